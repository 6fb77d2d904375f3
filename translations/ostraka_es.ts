<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
  <context>
    <name>ComputeBatch</name>
    <message>
      <source>The disk has only %1 MB left; a batch needs more. Nothing is lost: make room, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En el disco solo quedan %1 MB; una tanda necesita más. No se ha perdido nada: haga sitio y continúe.</translation>
    </message>
    <message>
      <source>%1: this number was typed on the plate, but no sherd with a context lies there; give it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: este número se escribió sobre el plato, pero allí no hay ningún fragmento con contexto; asígnelo en el catálogo.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) were counted on the plate, and another number was found; look at the map for one that is missing or cut in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Se contó %n fragmento sobre el plato y se encontró otro número; busque en el plano el que falta o está partido en dos.</numerusform>
        <numerusform>Se contaron %n fragmentos sobre el plato y se encontró otro número; busque en el plano el que falta o está partido en dos.</numerusform>
      </translation>
    </message>
    <message>
      <source>Pairs were decided while the batch was computed; compute it again for them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se decidieron pares mientras se calculaba la tanda; calcúlela de nuevo para ellos.</translation>
    </message>
  </context>
  <context>
    <name>Fields</name>
    <message>
      <source>number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>número</translation>
    </message>
    <message>
      <source>identifier</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>identificador</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>estado</translation>
    </message>
    <message>
      <source>void because</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anulado porque</translation>
    </message>
    <message>
      <source>site</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yacimiento</translation>
    </message>
    <message>
      <source>trench</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>corte</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contexto</translation>
    </message>
    <message>
      <source>bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bolsa</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parte</translation>
    </message>
    <message>
      <source>ware</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cerámica (tipo)</translation>
    </message>
    <message>
      <source>fabric</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pasta</translation>
    </message>
    <message>
      <source>inclusions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>desgrasante</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>manufactura</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cocción</translation>
    </message>
    <message>
      <source>surface outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>superficie exterior</translation>
    </message>
    <message>
      <source>surface inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>superficie interior</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>decoración</translation>
    </message>
    <message>
      <source>Munsell outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell exterior</translation>
    </message>
    <message>
      <source>Munsell inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell interior</translation>
    </message>
    <message>
      <source>Munsell core</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell núcleo</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>conservación</translation>
    </message>
    <message>
      <source>joins with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>une con</translation>
    </message>
    <message>
      <source>vessel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>vasija</translation>
    </message>
    <message>
      <source>period</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>período</translation>
    </message>
    <message>
      <source>date</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>datación</translation>
    </message>
    <message>
      <source>length, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>longitud, mm</translation>
    </message>
    <message>
      <source>width, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anchura, mm</translation>
    </message>
    <message>
      <source>thickness least, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>grosor mínimo, mm</translation>
    </message>
    <message>
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>grosor, mm</translation>
    </message>
    <message>
      <source>thickness most, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>grosor máximo, mm</translation>
    </message>
    <message>
      <source>area, mm²</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>área, mm²</translation>
    </message>
    <message>
      <source>volume, mm³</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>volumen, mm³</translation>
    </message>
    <message>
      <source>not seen, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>no visto, %</translation>
    </message>
    <message>
      <source>rim diameter, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>diámetro del borde, mm</translation>
    </message>
    <message>
      <source>rim kept, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>borde conservado, %</translation>
    </message>
    <message>
      <source>weight, g</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>peso, g</translation>
    </message>
    <message>
      <source>batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tanda</translation>
    </message>
    <message>
      <source>note</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nota</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>escala</translation>
    </message>
  </context>
  <context>
    <name>Job</name>
    <message>
      <source>The memory does not suffice; close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La memoria no basta; cierre otros programas e inténtelo otra vez.</translation>
    </message>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un defecto del programa; comuníquelo con el registro (%1).</translation>
    </message>
  </context>
  <context>
    <name>PlaceText</name>
    <message>
      <source>%1 bag %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bolsa %2</translation>
    </message>
    <message>
      <source>A site, a context and a bag are needed so that the sherds can be numbered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hacen falta yacimiento, contexto y bolsa para numerar los fragmentos.</translation>
    </message>
    <message>
      <source>site %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yacimiento %1</translation>
    </message>
    <message>
      <source>trench %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>corte %1</translation>
    </message>
    <message>
      <source>context %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contexto %1</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bolsa %1</translation>
    </message>
  </context>
  <context>
    <name>Rig</name>
    <message>
      <source>its file is missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>falta su archivo</translation>
    </message>
    <message>
      <source>ready (calibrated today)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>listo (calibrado hoy)</translation>
    </message>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>listo (%n día)</numerusform>
        <numerusform>listo (%n días)</numerusform>
      </translation>
    </message>
    <message>
      <source>virtual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>virtual</translation>
    </message>
  </context>
  <context>
    <name>Stage</name>
    <message>
      <source>cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cámaras</translation>
    </message>
    <message>
      <source>sherd or plate, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmento o plato, anverso</translation>
    </message>
    <message>
      <source>sherd or plate, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmento o plato, reverso</translation>
    </message>
    <message>
      <source>surface, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>superficie, anverso</translation>
    </message>
    <message>
      <source>surface, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>superficie, reverso</translation>
    </message>
    <message>
      <source>one scan a sherd, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>un escaneo por fragmento, anverso</translation>
    </message>
    <message>
      <source>one scan a sherd, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>un escaneo por fragmento, reverso</translation>
    </message>
    <message>
      <source>which back belongs to which front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>qué reverso corresponde a qué anverso</translation>
    </message>
    <message>
      <source>models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>modelos</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>informe</translation>
    </message>
    <message>
      <source>catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>catálogo</translation>
    </message>
    <message>
      <source>begins</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>empieza</translation>
    </message>
    <message>
      <source>more candidates for doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>más candidatos para las parejas dudosas</translation>
    </message>
  </context>
  <context>
    <name>Time</name>
    <message numerus="yes">
      <source>%n s left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>queda %n s</numerusform>
        <numerusform>quedan %n s</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>queda %n min</numerusform>
        <numerusform>quedan %n min</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 h %2 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>quedan %1 h %2 min</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui</name>
    <message>
      <source>numbered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>numerado</translation>
    </message>
    <message>
      <source>void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anulado</translation>
    </message>
    <message>
      <source>draft</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>borrador</translation>
    </message>
    <message>
      <source>on a scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en la balanza</translation>
    </message>
    <message>
      <source>with a calliper</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>con calibre</translation>
    </message>
    <message>
      <source>estimated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>estimado</translation>
    </message>
    <message>
      <source>by the program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>por el programa</translation>
    </message>
    <message>
      <source>aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aparte</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>otra vez</translation>
    </message>
    <message>
      <source>%1 or %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 o %2</translation>
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La fotografía ya no está.</translation>
    </message>
    <message>
      <source>The printer or file cannot be written; choose another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede escribir en la impresora o el archivo; elija otro.</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anverso</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>reverso</translation>
    </message>
    <message>
      <source>The printer took no further page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La impresora no aceptó más páginas.</translation>
    </message>
    <message>
      <source>The printer or file could not be finished; is the disk full?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudo terminar la impresión o el archivo; ¿está lleno el disco?</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3: their rims differ by %4 only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 y %2 encajan ambos con %3: sus bordes solo difieren en %4.</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 y %2 encajan ambos con %3.</translation>
    </message>
    <message>
      <source>%1 would fit %2 nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 encajaría casi igual de bien con %2.</translation>
    </message>
    <message>
      <source>Another partner fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otra pareja encaja casi igual de bien.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Su reverso se dio a otro anverso: ¿es %1 el correcto ahora?</translation>
    </message>
    <message>
      <source>%1 fits hardly better than a stranger's back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 encaja apenas mejor que el reverso de un fragmento ajeno.</translation>
    </message>
    <message>
      <source>The two sides fit nearly as well in another position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los dos lados encajan casi igual de bien en otra posición.</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>under 1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>menos del 1 %</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>The back lies upside down: both sides face the same way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El reverso está boca abajo: ambos lados miran hacia la misma parte.</translation>
    </message>
    <message>
      <source>The faces cross: %1 of the front lies behind the back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las caras se cruzan: %1 del anverso queda detrás del reverso.</translation>
    </message>
    <message>
      <source>The two scans share almost no broken edge; outlines alone tie them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los dos escaneos casi no comparten fractura; solo los contornos los unen.</translation>
    </message>
    <message>
      <source>The broken edges do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fracturas no encajan: %1 de separación.</translation>
    </message>
    <message>
      <source>The rim hardly fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El borde apenas fija la posición: incertidumbre de %1.</translation>
    </message>
    <message>
      <source>A place %1 along the rim fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un lugar a %1 por el borde encaja casi igual de bien.</translation>
    </message>
    <message>
      <source>The rims cannot be compared; outlines alone tie these sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los bordes no se pueden comparar; solo los contornos unen estos lados.</translation>
    </message>
    <message>
      <source>look</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>mirar</translation>
    </message>
    <message>
      <source>no back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sin reverso</translation>
    </message>
    <message>
      <source>sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seguro</translation>
    </message>
    <message>
      <source>decided</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>decidido</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>apartado</translation>
    </message>
    <message>
      <source>shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fotografiar otra vez</translation>
    </message>
    <message>
      <source>%1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 – %2</translation>
    </message>
    <message>
      <source>No back was found for it. Choose one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se encontró reverso. Elija uno, o aparte el fragmento.</translation>
    </message>
    <message>
      <source>The program is sure: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa está seguro: %1.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Decidido por %1 el %2.</translation>
    </message>
    <message>
      <source>Set aside by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apartado por %1 el %2.</translation>
    </message>
    <message>
      <source>To be shot again, says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografiar otra vez, dice %1, %2.</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bolsa %1</translation>
    </message>
    <message>
      <source>no front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sin anverso</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este reverso está apartado. Arrástrelo sobre un anverso para usarlo después de todo.</translation>
    </message>
    <message>
      <source>This back is to be shot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este reverso se fotografiará otra vez.</translation>
    </message>
    <message>
      <source>No front holds this back. Drag it onto its front, join it to another, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún anverso tiene este reverso. Arrástrelo a su anverso, únalo a otro, o apártelo.</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message numerus="yes">
      <source>%1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 de %n fragmento</numerusform>
        <numerusform>%1 de %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dudosa</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento</numerusform>
        <numerusform>%n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Its back %1 was given to %2: is %3 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Su reverso %1 se dio a %2: ¿es %3 el correcto ahora?</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2. Choose another one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Su reverso %1 se dio a %2. Elija otro, o aparte el fragmento.</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2; next best %3, %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Su reverso %1 se dio a %2; el siguiente mejor es %3, %4.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2, turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Decidido por %1 el %2, girado a mano.</translation>
    </message>
    <message>
      <source>The rims hardly meet: %1 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los bordes apenas se encuentran: el %1.</translation>
    </message>
    <message>
      <source>by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>a mano</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>punto inicial</translation>
    </message>
    <message>
      <source>settled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ajustado</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girado a mano: se encuentra el %1 de los bordes.</translation>
    </message>
    <message>
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girado a mano.</translation>
    </message>
    <message>
      <source>Another start point is tried: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba otro punto inicial: se encuentra el %1 de los bordes.</translation>
    </message>
    <message>
      <source>Another start point is tried.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba otro punto inicial.</translation>
    </message>
    <message>
      <source>Settled by the rims: %1 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajustado por los bordes: se encuentra el %1.</translation>
    </message>
    <message>
      <source>Settled by the rims.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajustado por los bordes.</translation>
    </message>
    <message>
      <source>%1 is tried: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba %1: %2.</translation>
    </message>
    <message>
      <source>%1 is tried: %2, rims %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba %1: %2, bordes separados %3.</translation>
    </message>
    <message>
      <source>%1 is tried: %2; its rims do not meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba %1: %2; los bordes no se encuentran.</translation>
    </message>
    <message>
      <source>%1 decided for %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se decidió por %2.</translation>
    </message>
    <message>
      <source>The program says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa dice %1, %2.</translation>
    </message>
    <message>
      <source>Joined with %1 by %2; it is one piece once the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unido con %1 por %2; será una sola pieza cuando se calcule la tanda.</translation>
    </message>
    <message>
      <source>Cut in two by %1; its pieces come when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cortado en dos por %1; sus piezas llegan cuando se calcule la tanda.</translation>
    </message>
    <message>
      <source>joined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unido</translation>
    </message>
    <message>
      <source>cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cortado</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchDelegate</name>
    <message>
      <source>%1, %2 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 %</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchImporter</name>
    <message>
      <source>Import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importación de %1</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La copia no se puede poner en su sitio: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento, seguro</numerusform>
        <numerusform>%n fragmentos, todos seguros</numerusform>
      </translation>
    </message>
    <message>
      <source>a draft: look, then compute it again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>un borrador: mírelo y vuelva a calcularlo</translation>
    </message>
    <message>
      <source>the scale is not right: see the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la escala no es correcta: vea el informe</translation>
    </message>
    <message>
      <source>%1; joined to %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; unidos a %2 mm</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tanda %1</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aviso: %1</translation>
    </message>
    <message numerus="yes">
      <source>%1 is computed: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 está calculada: %n fragmento.</numerusform>
        <numerusform>%1 está calculada: %n fragmentos.</numerusform>
      </translation>
    </message>
    <message>
      <source>You stopped it. What was computed so far is kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Usted la detuvo. Lo calculado hasta ahora se conserva.</translation>
    </message>
    <message>
      <source>You took it out of the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Usted la sacó de la cola.</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>otra vez</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) wait.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>En pausa; espera %n tanda.</numerusform>
        <numerusform>En pausa; esperan %n tandas.</numerusform>
      </translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: en pausa</translation>
    </message>
    <message>
      <source>%1: %2, %3 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, %3 %</translation>
    </message>
    <message>
      <source>being photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>se está fotografiando</translation>
    </message>
    <message>
      <source>waits for its turn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>espera su turno</translation>
    </message>
    <message>
      <source>is being computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>se está calculando</translation>
    </message>
    <message>
      <source>paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en pausa</translation>
    </message>
    <message>
      <source>stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>detenida</translation>
    </message>
    <message>
      <source>wants your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>requiere su atención</translation>
    </message>
    <message>
      <source>done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>terminada</translation>
    </message>
    <message>
      <source>decided; to be computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>decidida; falta calcular</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento</numerusform>
        <numerusform>%n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>sure %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seguros %1</translation>
    </message>
    <message>
      <source>decided %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>decididos %1</translation>
    </message>
    <message>
      <source>ask %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dudosos %1</translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; pero %n contado en el plato</numerusform>
        <numerusform>%1; pero %n contados en el plato</numerusform>
      </translation>
    </message>
    <message>
      <source>draft, to be computed again; %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>borrador, por calcular de nuevo; %1</translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 espera el borrador de %2.</translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the marks by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 recibió un golpe: yerra las marcas por %2 px, a %3 mm de donde se calibró.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En esta tanda se hallaron de nuevo las cámaras; calibre otra vez el equipo (C).</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BigButton</name>
    <message>
      <source>Key: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tecla: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BulkEdit</name>
    <message>
      <source>Field to change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Campo que cambia</translation>
    </message>
    <message>
      <source>New value for all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nuevo valor para todos</translation>
    </message>
    <message>
      <source>new value; empty deletes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nuevo valor; vacío borra</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmento</translation>
    </message>
    <message>
      <source>now</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ahora</translation>
    </message>
    <message>
      <source>then</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>después</translation>
    </message>
    <message>
      <source>What would change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que cambiaría</translation>
    </message>
    <message>
      <source>Change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cambiar</translation>
    </message>
    <message>
      <source>Give numbers to the drafts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numerar los borradores</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Campo</translation>
    </message>
    <message>
      <source>Value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Valor</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento elegido</numerusform>
        <numerusform>%n fragmentos elegidos</numerusform>
      </translation>
    </message>
    <message>
      <source>Type a value to see what would change.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba un valor para ver lo que cambiaría.</translation>
    </message>
    <message>
      <source>Preview of a change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vista previa de un cambio</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aún sin número</translation>
    </message>
    <message>
      <source>refused: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rechazado: %1</translation>
    </message>
    <message>
      <source>%1 change, %2 stay as they are, %3 are refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 cambian, %2 quedan como están, %3 se rechazan.</translation>
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Cambiar %n fragmento</numerusform>
        <numerusform>Cambiar %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Progress of the changes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance de los cambios</translation>
    </message>
    <message>
      <source>Stop and take back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener y deshacer</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CandidateBar</name>
    <message>
      <source>Another back …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro reverso …</translation>
    </message>
    <message>
      <source>rim %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>borde %1</translation>
    </message>
    <message>
      <source>no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sin borde</translation>
    </message>
    <message>
      <source>%1, with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ahora con %2</translation>
    </message>
    <message>
      <source>%1   %2   %3
%4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1   %2   %3
%4</translation>
    </message>
    <message>
      <source>Candidate %1: %2, %3, %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Candidato %1: %2, %3, %4</translation>
    </message>
    <message>
      <source>%1, nobody's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, libre</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureFoot</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Espacio</translation>
    </message>
    <message>
      <source>Typed, from a code reader, or from the bag's label laid under the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escrito, con un lector de códigos, o con la etiqueta de la bolsa bajo la cámara</translation>
    </message>
    <message>
      <source>More</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Más</translation>
    </message>
    <message>
      <source>Import, another rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar, otro equipo</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureStation</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Espacio</translation>
    </message>
    <message>
      <source>%1 is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está en la cola.</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: %n archivo importado; está en la cola.</numerusform>
        <numerusform>%1: %n archivos importados; está en la cola.</numerusform>
      </translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>De acuerdo</translation>
    </message>
    <message>
      <source>The next thing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo siguiente</translation>
    </message>
    <message>
      <source>Stop the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener la mesa</translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografiar otra vez</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar fotografías…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar escaneos…</translation>
    </message>
    <message>
      <source>Another rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro equipo…</translation>
    </message>
    <message>
      <source>Camera %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1</translation>
    </message>
    <message>
      <source>Capture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Captura</translation>
    </message>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta con los escaneos front/ y back/</translation>
    </message>
    <message>
      <source>Folder of a batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta de una tanda</translation>
    </message>
    <message>
      <source>The picture is on its way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen está en camino.</translation>
    </message>
    <message>
      <source>Look at this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mire esto primero</translation>
    </message>
    <message>
      <source>R</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>R</translation>
    </message>
    <message>
      <source>does not answer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>no responde</translation>
    </message>
    <message>
      <source>%1 The desktop holds a camera, by its program %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 El escritorio retiene una cámara, con su programa %2.</translation>
    </message>
    <message>
      <source>Type the sherds' numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escribir los números de los fragmentos</translation>
    </message>
    <message>
      <source>Say how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Decir cuántos fragmentos hay</translation>
    </message>
    <message>
      <source>This project photographs with no calibrated rig of its own.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto no fotografía con un equipo calibrado propio.</translation>
    </message>
    <message>
      <source>The rig is calibrated by %1; the calibration before is kept as %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo está calibrado según %1; la calibración anterior se guarda como %2.</translation>
    </message>
    <message>
      <source>The import is stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La importación se ha detenido; no ha quedado nada.</translation>
    </message>
    <message>
      <source>Import them all the same</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importarlos de todos modos</translation>
    </message>
    <message>
      <source>%1 has these files already; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ya tiene estos archivos; no se ha importado nada.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abriendo el equipo</translation>
    </message>
    <message>
      <source>%1 goes on where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sigue donde estaba.</translation>
    </message>
    <message>
      <source>Photographs of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías de %1</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pulse el disparador de la cámara %1.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are safe.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>La fotografía ya tomada de este lado está a salvo.</numerusform>
        <numerusform>Las %n fotografías ya tomadas de este lado están a salvo.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at stop %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1, parada %2: %3</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>Live picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen en vivo</translation>
    </message>
    <message>
      <source>Front picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen de los anversos</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay equipo</translation>
    </message>
    <message>
      <source>The rig is being opened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se está abriendo el equipo</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Coloque los fragmentos en el plato</translation>
    </message>
    <message>
      <source>Stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido</translation>
    </message>
    <message>
      <source>Photographing the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografiando los anversos</translation>
    </message>
    <message>
      <source>Turn each sherd over where it lies</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dé la vuelta a cada fragmento en su sitio</translation>
    </message>
    <message>
      <source>Photographing the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografiando los reversos</translation>
    </message>
    <message>
      <source>You may clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Puede despejar el plato.</translation>
    </message>
    <message>
      <source>Look at the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mire el plato antes de despejarlo</translation>
    </message>
    <message>
      <source>Fronts up, a finger's width apart, the marks at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anverso arriba, un dedo de separación, las marcas del borde libres.</translation>
    </message>
    <message>
      <source>Hands off the table. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Manos fuera de la mesa. Esc la detiene al instante.</translation>
    </message>
    <message>
      <source>Shifting is fine, swapping is fine, losing one is not.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se pueden mover o cambiar de sitio, pero no perder ninguno.</translation>
    </message>
    <message>
      <source>%1 is in the queue; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está en la cola; la siguiente tanda está a una tecla.</translation>
    </message>
    <message>
      <source>Space goes on all the same, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Espacio continúa igualmente, R fotografía otra vez los reversos.</translation>
    </message>
    <message>
      <source>Done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hecho</translation>
    </message>
    <message>
      <source>Try again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Intentar otra vez</translation>
    </message>
    <message>
      <source>Shoot the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografiar los anversos</translation>
    </message>
    <message>
      <source>All turned: shoot the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todos girados: fotografiar los reversos</translation>
    </message>
    <message>
      <source>Next batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Siguiente tanda</translation>
    </message>
    <message>
      <source>It is right: into the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Está bien: a la cola</translation>
    </message>
    <message>
      <source>Stop %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parada %1 de %2</translation>
    </message>
    <message>
      <source>One moment</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un momento</translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Anverso: %n fragmento</numerusform>
        <numerusform>Anverso: %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Front: %1 sherds, now %2 are seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anverso: %1 fragmentos, ahora se ven %2</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anverso %1, reverso %2</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) are safe</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fotografía a salvo</numerusform>
        <numerusform>%n fotografías a salvo</numerusform>
      </translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta cámara no muestra imagen en vivo.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Se ve %n fragmento</numerusform>
        <numerusform>Se ven %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 may be two sherds, too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 pueden ser dos fragmentos demasiado juntos</translation>
    </message>
    <message>
      <source>%1 and %2 lie too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 y %2 están demasiado juntos</translation>
    </message>
    <message>
      <source>%1 reaches out of the picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se sale de la imagen</translation>
    </message>
    <message>
      <source>Marks %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marcas %1 de %2</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too dark</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El %1 % de los fragmentos está demasiado oscuro</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too bright</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El %1 % de los fragmentos está demasiado claro</translation>
    </message>
    <message>
      <source>Light is right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La luz está bien</translation>
    </message>
    <message>
      <source>Read from the label: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leído de la etiqueta: %1</translation>
    </message>
    <message>
      <source>No room for more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No cabe ninguno más</translation>
    </message>
    <message numerus="yes">
      <source>Room for about %n more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Cabe alrededor de %n más</numerusform>
        <numerusform>Caben alrededor de %n más</numerusform>
      </translation>
    </message>
    <message>
      <source>Looking for what holds the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buscando qué retiene la cámara</translation>
    </message>
    <message>
      <source>Making the desktop let go of the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Haciendo que el escritorio suelte la cámara</translation>
    </message>
    <message>
      <source>Make the desktop let go</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hacer que el escritorio la suelte</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: look for one that hides, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ha contado %1 fragmentos, las fotos muestran %2: busque uno que esté oculto, toque a otro o no se haya colocado.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ha contado %1</translation>
    </message>
    <message>
      <source>Marks %1 of %2, %3 are needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marcas %1 de %2, hacen falta %3</translation>
    </message>
    <message>
      <source>Its sherds stand in the review (Ctrl+3): look while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sus fragmentos están en la revisión (Ctrl+3): mire mientras aún están aquí</translation>
    </message>
    <message>
      <source>The table stands still. What is safe is not photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa está parada. Lo que está a salvo no se fotografía otra vez.</translation>
    </message>
    <message>
      <source>Go on at stop %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seguir en la parada %1</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se interrumpió en mitad de esta cara.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CatalogueStation</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>cambiar %1 de %n fragmento</numerusform>
        <numerusform>cambiar %1 de %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Catálogo</translation>
    </message>
    <message>
      <source>Export these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Exportar estos</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sus iniciales</translation>
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Quién trabaja? Sus iniciales van al historial:</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos</translation>
    </message>
    <message>
      <source>Search</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buscar</translation>
    </message>
    <message>
      <source>Edit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Editar</translation>
    </message>
    <message>
      <source>Give numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numerar</translation>
    </message>
    <message>
      <source>No sherds yet. They come by themselves when a batch is computed; start with Capture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay fragmentos. Llegan solos cuando se calcula una tanda; empiece por la captura.</translation>
    </message>
    <message>
      <source>No sherd fits. Take a condition away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún fragmento cumple. Quite una condición.</translation>
    </message>
    <message>
      <source>change %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiar %1</translation>
    </message>
    <message>
      <source>move to another context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>mover a otro contexto</translation>
    </message>
    <message>
      <source>changes by the import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambios por la importación de %1</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 importado: %2</translation>
    </message>
    <message>
      <source>Import …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar …</translation>
    </message>
    <message>
      <source>Numbers, contexts and descriptions from a table, or an export (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Números, contextos y descripciones de una tabla, o una exportación (%1)</translation>
    </message>
    <message>
      <source>About what is chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sobre lo elegido</translation>
    </message>
    <message>
      <source>Details</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detalles</translation>
    </message>
    <message>
      <source>Drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dibujo</translation>
    </message>
    <message>
      <source>Details or drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detalles o dibujo</translation>
    </message>
    <message>
      <source>enter the rim's diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anotar el diámetro del borde</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La importación de %1 se interrumpió tras %2 de %3 filas; estas están completas. Impórtela otra vez para el resto.</translation>
    </message>
    <message>
      <source>Do not tell this again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No volver a avisar de esto</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elija los fragmentos que deben recibir número.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::DrawingPage</name>
    <message>
      <source>Scale of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala del dibujo</translation>
    </message>
    <message>
      <source>1 : 1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 1</translation>
    </message>
    <message>
      <source>1 : 2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 2</translation>
    </message>
    <message>
      <source>How surfaces are drawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cómo se dibujan las superficies</translation>
    </message>
    <message>
      <source>Light and shade of the form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Luz y sombra de la forma</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Con pintura y engobe</translation>
    </message>
    <message>
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Si es un borde</translation>
    </message>
    <message>
      <source>As the parts say, or as is likely</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Según las partes, o según lo probable</translation>
    </message>
    <message>
      <source>It is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un borde</translation>
    </message>
    <message>
      <source>It is no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un borde</translation>
    </message>
    <message>
      <source>Scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala</translation>
    </message>
    <message>
      <source>Surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Superficie</translation>
    </message>
    <message>
      <source>Rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Borde</translation>
    </message>
    <message>
      <source>Enter the diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anotar el diámetro</translation>
    </message>
    <message>
      <source>Save …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar …</translation>
    </message>
    <message>
      <source>Print …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir …</translation>
    </message>
    <message>
      <source>Print the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir el dibujo</translation>
    </message>
    <message>
      <source>Progress of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance del dibujo</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener</translation>
    </message>
    <message>
      <source>The sheet before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La hoja anterior</translation>
    </message>
    <message>
      <source>The next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La hoja siguiente</translation>
    </message>
    <message>
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que dice el dibujo</translation>
    </message>
    <message>
      <source>Drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dibujos</translation>
    </message>
    <message>
      <source>Stopped; nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido; no se dibujó nada.</translation>
    </message>
    <message>
      <source>A sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una hoja</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Dibujando %n fragmento …</numerusform>
        <numerusform>Dibujando %n fragmentos …</numerusform>
      </translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elija un fragmento.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: %2 to %3), %4 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boca de %1 cm (95 %: %2 a %3), se conserva el %4 % del borde.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: above %2), %3 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boca de %1 cm (95 %: más de %2), se conserva el %3 % del borde.</translation>
    </message>
    <message>
      <source>%1 drawn, %2 left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 dibujados, %2 omitidos.</translation>
    </message>
    <message numerus="yes">
      <source>Draw plates of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Dibujar lámina de %n fragmento</numerusform>
        <numerusform>Dibujar láminas de %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Sheet %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hoja %1 de %2</translation>
    </message>
    <message>
      <source>plates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>láminas</translation>
    </message>
    <message>
      <source>Save the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar el dibujo</translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, todas las hojas (*.pdf);;SVG, un archivo por hoja (*.svg)</translation>
    </message>
    <message>
      <source>Saving a drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardando un dibujo</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado: %1</translation>
    </message>
    <message>
      <source>Printing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimiendo</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dibujo va a la impresora; imprímalo al 100 %.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportModel</name>
    <message>
      <source>Size of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tamaño de la exportación</translation>
    </message>
    <message>
      <source>Counting …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Contando …</translation>
    </message>
    <message>
      <source>No sherd fits; choose others.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún fragmento cumple; elija otros.</translation>
    </message>
    <message>
      <source>less than a minute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>menos de un minuto</translation>
    </message>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>alrededor de %n minuto</numerusform>
        <numerusform>alrededor de %n minutos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento, %1 archivos, %2, %3</numerusform>
        <numerusform>%n fragmentos, %1 archivos, %2, %3</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n de ellos sin modelo</numerusform>
        <numerusform>%n de ellos sin modelo</numerusform>
      </translation>
    </message>
    <message>
      <source>There is a folder of this name already; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay una carpeta con este nombre; elija otro nombre.</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message numerus="yes">
      <source>%1, %n second(s) left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1, queda %n segundo</numerusform>
        <numerusform>%1, quedan %n segundos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento, %1, manifiesto comprobado</numerusform>
        <numerusform>%n fragmentos, %1, manifiesto comprobado</numerusform>
      </translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Exportación</translation>
    </message>
    <message>
      <source>Stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenida; no quedó nada a medias.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportStation</name>
    <message>
      <source>Exported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Exportado: %1</translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Exportación</translation>
    </message>
    <message>
      <source>What</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Qué</translation>
    </message>
    <message>
      <source>All sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todos los fragmentos</translation>
    </message>
    <message>
      <source>Those that fit this filter:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los que cumplen este filtro:</translation>
    </message>
    <message>
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Filtro de lo que se exporta</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>context:0012</translation>
    </message>
    <message>
      <source>Forms</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Formas</translation>
    </message>
    <message>
      <source>Tables (CSV), for spreadsheets</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablas (CSV), para hojas de cálculo</translation>
    </message>
    <message>
      <source>Records (JSON), to be read back whole</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fichas (JSON), que se pueden volver a leer enteras</translation>
    </message>
    <message>
      <source>A picture of each model (PNG)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una imagen de cada modelo (PNG)</translation>
    </message>
    <message>
      <source>Models as PLY, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelos en PLY, en mm</translation>
    </message>
    <message>
      <source>Models as GLB, for the web and for slides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelos en GLB, para la web y presentaciones</translation>
    </message>
    <message>
      <source>Models as OBJ, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelos en OBJ, en mm</translation>
    </message>
    <message>
      <source>The photographs, unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotografías, sin cambios</translation>
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dónde</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nueva carpeta para la exportación</translation>
    </message>
    <message>
      <source>Choose …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir …</translation>
    </message>
    <message>
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance de la exportación</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abrir la carpeta</translation>
    </message>
    <message>
      <source>Where shall the folder be?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Dónde estará la carpeta?</translation>
    </message>
    <message>
      <source>Those chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los elegidos en el catálogo</translation>
    </message>
    <message numerus="yes">
      <source>The %n chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>El elegido en el catálogo</numerusform>
        <numerusform>Los %n elegidos en el catálogo</numerusform>
      </translation>
    </message>
    <message>
      <source>Drawings for print (SVG and PDF)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dibujos para imprimir (SVG y PDF)</translation>
    </message>
    <message>
      <source>Scale of the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala de los dibujos</translation>
    </message>
    <message>
      <source>1 : 1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 1</translation>
    </message>
    <message>
      <source>1 : 2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 2</translation>
    </message>
    <message>
      <source>as fits A4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>según A4</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablas (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>Pictures, masks, poses for COLMAP and OpenMVS</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imágenes, máscaras y poses para COLMAP y OpenMVS</translation>
    </message>
    <message>
      <source>Detail of the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detalle de los modelos</translation>
    </message>
    <message>
      <source>Of PLY, GLB and OBJ: with fewer triangles the files are a fraction as large. How far they are off is measured and stated in each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>De PLY, GLB y OBJ: con menos triángulos los archivos son mucho menores. Su desviación se mide y consta en cada uno.</translation>
    </message>
    <message>
      <source>as computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>como se calcularon</translation>
    </message>
    <message>
      <source>lighter, to %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>más ligeros, hasta %1 mm</translation>
    </message>
    <message>
      <source>Stop the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener la exportación</translation>
    </message>
    <message>
      <source>Export: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Exportación: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FilterLine</name>
    <message>
      <source>Filter of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Filtro del catálogo</translation>
    </message>
    <message>
      <source>rim T3 thickness&gt;6</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rim T3 thickness&gt;6</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las palabras se buscan en todas partes; también sirven ware:grey, thickness&gt;6, -burnt, note:*.</translation>
    </message>
    <message>
      <source>Take away the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Quitar la condición %1</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento</numerusform>
        <numerusform>%n fragmentos</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FooterLine</name>
    <message>
      <source>What the computer does</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que hace el ordenador</translation>
    </message>
    <message>
      <source>What was done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que se hizo</translation>
    </message>
    <message>
      <source>Progress of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance del cálculo</translation>
    </message>
    <message>
      <source>Nothing to compute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nada que calcular</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HeaderLine</name>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dónde</translation>
    </message>
    <message>
      <source>Rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Equipo</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sitio en el disco</translation>
    </message>
    <message>
      <source>Rig: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Equipo: %1</translation>
    </message>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Disco: sitio para %n tanda</numerusform>
        <numerusform>Disco: sitio para %n tandas</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HelpPage</name>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Manual</translation>
    </message>
    <message>
      <source>&amp;Contents</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Contenido</translation>
    </message>
    <message>
      <source>All &amp;keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todas las &amp;teclas</translation>
    </message>
    <message>
      <source>&amp;About</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Acerca de</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Volver al trabajo (Esc)</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todas las teclas</translation>
    </message>
    <message>
      <source>Complete, measured 3D models of potsherds from photographs of both their sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelos 3D completos y medidos de fragmentos cerámicos, a partir de fotografías de sus dos lados.</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Licencia Apache 2.0. Usa, entre otros, Qt (LGPL 3), VTK y OpenCV; el archivo LICENSE y el README los nombran todos.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: there is no network in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nada sale de este ordenador: no hay red en él.</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El manual solo está en inglés.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportDialog</name>
    <message>
      <source>new</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nuevo</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiado</translation>
    </message>
    <message>
      <source>refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rechazado</translation>
    </message>
    <message>
      <source>as it is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>como está</translation>
    </message>
    <message>
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar al catálogo</translation>
    </message>
    <message>
      <source>A table (CSV) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una tabla (CSV) …</translation>
    </message>
    <message>
      <source>An export folder …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una carpeta de exportación …</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Crear los yacimientos, cortes, contextos y bolsas que aún no existen</translation>
    </message>
    <message>
      <source>What each row would do</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que haría cada fila</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance de la importación</translation>
    </message>
    <message>
      <source>Save what is refused …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar lo rechazado …</translation>
    </message>
    <message>
      <source>Which table?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Qué tabla?</translation>
    </message>
    <message>
      <source>Tables (*.csv *.tsv *.txt);;All (*)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablas (*.csv *.tsv *.txt);;Todos (*)</translation>
    </message>
    <message>
      <source>Which export?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Qué exportación?</translation>
    </message>
    <message>
      <source>Save what is refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar lo rechazado</translation>
    </message>
    <message>
      <source>refused.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rechazados.csv</translation>
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablas (*.csv)</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado: %1</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>línea</translation>
    </message>
    <message>
      <source>what happens</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>qué ocurre</translation>
    </message>
    <message>
      <source>why not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>por qué no</translation>
    </message>
    <message>
      <source>A table of sherds has a column number or uuid; one of contexts has site, context and, if you like, trench and bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una tabla de fragmentos tiene una columna number o uuid; una de contextos tiene site, context y, si quiere, trench y bag.</translation>
    </message>
    <message>
      <source>Looking at it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mirándola …</translation>
    </message>
    <message>
      <source>Entered: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anotado: %1</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cerrar</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener</translation>
    </message>
    <message>
      <source>Take nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No tomar nada</translation>
    </message>
    <message numerus="yes">
      <source>Enter %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Anotar %n fila</numerusform>
        <numerusform>Anotar %n filas</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 «%2»: %3</translation>
    </message>
    <message>
      <source>Preview of an import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vista previa de una importación</translation>
    </message>
    <message>
      <source>%1 new, %2 changed, %3 as they are, %4 refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 nuevos, %2 cambiados, %3 como están, %4 rechazados.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar</translation>
    </message>
    <message>
      <source>Stopped; nothing was entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido; no se anotó nada.</translation>
    </message>
    <message numerus="yes">
      <source>Stopped: %n row(s) are not entered. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Detenido: %n fila no se ha introducido. Importe la tabla otra vez para el resto.</numerusform>
        <numerusform>Detenido: %n filas no se han introducido. Importe la tabla otra vez para el resto.</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::JoinMode</name>
    <message>
      <source>Which back belongs to the one of %1? Choose its card (arrows and Enter).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Qué reverso va con el de %1? Elija su ficha (flechas e Intro).</translation>
    </message>
    <message>
      <source>Which front belongs to the one of %1? Choose its card (arrows and Enter); a click on a back's picture joins the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Qué anverso va con el de %1? Elija su ficha (flechas e Intro); un clic en la imagen de un reverso une los reversos.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MainWindow</name>
    <message>
      <source>Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka</translation>
    </message>
    <message>
      <source>%1 is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está calculada.</translation>
    </message>
    <message>
      <source>%1 stopped: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se detuvo: %2</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deshacer</translation>
    </message>
    <message>
      <source>Do again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rehacer</translation>
    </message>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Manual</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todas las teclas</translation>
    </message>
    <message>
      <source>Other projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otros proyectos</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Proyectos</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajustes</translation>
    </message>
    <message>
      <source>Help</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ayuda</translation>
    </message>
    <message>
      <source>Back to work</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Volver al trabajo</translation>
    </message>
    <message>
      <source>This project is open in another window already: go on there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto ya está abierto en otra ventana: siga allí.</translation>
    </message>
    <message>
      <source>%1 - Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 - Ostraka</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Equipo virtual</translation>
    </message>
    <message>
      <source>Virtual rig %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Equipo virtual %1</translation>
    </message>
    <message>
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En todas partes</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sitio en el disco</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se está deteniendo el cálculo; continúa cuando el proyecto se abra otra vez. La ventana se cierra en un momento.</translation>
    </message>
    <message>
      <source>Queue: mending masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cola: corregir las máscaras</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deshacer: %1</translation>
    </message>
    <message>
      <source>Do again: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rehacer: %1</translation>
    </message>
    <message>
      <source>Copy of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Copia del catálogo</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudo copiar el catálogo: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tanda</translation>
    </message>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir plano y etiquetas</translation>
    </message>
    <message>
      <source>Print map and labels   Ctrl+P</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir plano y etiquetas   Ctrl+P</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento %1</translation>
    </message>
    <message>
      <source>No batch is computed yet; its map appears here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay tanda calculada; su plano aparece aquí.</translation>
    </message>
    <message>
      <source>Map of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plano de %1</translation>
    </message>
    <message>
      <source>%1-%2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-%2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tanda %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tanda %1, %2</translation>
    </message>
    <message>
      <source>Map and labels are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El plano y las etiquetas van a la impresora.</translation>
    </message>
    <message>
      <source>Map</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plano</translation>
    </message>
    <message>
      <source>Print bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir etiquetas de bolsas</translation>
    </message>
    <message>
      <source>Bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Etiquetas de bolsas</translation>
    </message>
    <message>
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir una etiqueta por bolsa; su código da a una tanda su contexto (Ctrl+Mayús+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aún no hay ninguna bolsa: escriba una en la captura o importe una tabla de contextos.</translation>
    </message>
    <message numerus="yes">
      <source>%n label(s) are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n etiqueta se ha enviado a la impresora.</numerusform>
        <numerusform>%n etiquetas se han enviado a la impresora.</numerusform>
      </translation>
    </message>
    <message>
      <source>This batch was scanned, not photographed: there is no picture of its plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda se escaneó, no se fotografió: no hay imagen de su plato.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento de esta tanda aún no tiene número: su etiqueta nombra la tanda.</numerusform>
        <numerusform>%n fragmentos de esta tanda aún no tienen número: sus etiquetas nombran la tanda.</numerusform>
      </translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plato, anverso y reverso</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento %1</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anverso</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>reverso</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MessagePanel</name>
    <message>
      <source>What happened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Qué ha pasado</translation>
    </message>
    <message>
      <source>Leave it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dejarlo</translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>De acuerdo</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ModelPane</name>
    <message>
      <source>Picture of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen del fragmento</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sección</translation>
    </message>
    <message>
      <source>Cut the model open; Shift and the wheel move the plane</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cortar el modelo; Mayús y la rueda mueven el plano</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Desde arriba</translation>
    </message>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen de un fragmento</translation>
    </message>
    <message>
      <source>Model of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelo de un fragmento</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site's code has two to eight capital letters and digits, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El código del yacimiento tiene de dos a ocho mayúsculas y cifras, como ARM1.</translation>
    </message>
    <message>
      <source>Choose a folder for the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elija una carpeta para el proyecto.</translation>
    </message>
    <message>
      <source>There is a project in this folder already: open it, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay un proyecto en esta carpeta: ábralo, o elija otra carpeta.</translation>
    </message>
    <message>
      <source>This folder holds other files: choose a new one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta tiene otros archivos: elija una nueva.</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Equipo virtual</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::OutlinePlot</name>
    <message>
      <source>Outlines laid over each other, and their turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Contornos superpuestos, y sus ángulos de giro</translation>
    </message>
    <message>
      <source>The turning angles differ by %1 rad.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los ángulos de giro difieren en %1 rad.</translation>
    </message>
    <message>
      <source>outlines on each other</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contornos superpuestos</translation>
    </message>
    <message>
      <source>turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ángulos de giro</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>differ by %1 rad</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>difieren en %1 rad</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PairReviewModel</name>
    <message>
      <source>Small pictures of the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imágenes pequeñas de los fragmentos</translation>
    </message>
    <message>
      <source>%1, %2. %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2. %3</translation>
    </message>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay reverso elegido.</translation>
    </message>
    <message>
      <source>The rims do not meet here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los bordes no se encuentran aquí.</translation>
    </message>
    <message>
      <source>Rims %1 apart, %2 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bordes separados %1, se encuentra el %2.</translation>
    </message>
    <message>
      <source>Turned by hand; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girado a mano; B deja que los bordes ajusten.</translation>
    </message>
    <message>
      <source>Start point %1; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Punto inicial %1; B deja que los bordes ajusten.</translation>
    </message>
    <message>
      <source>Choose a back first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elija primero un reverso.</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba primero sus iniciales: cada decisión guarda su nombre.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>elección de %1</translation>
    </message>
    <message>
      <source>Comparing two sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comparando dos lados</translation>
    </message>
    <message>
      <source>pair %1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pareja %1 – %2</translation>
    </message>
    <message>
      <source>setting aside %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>apartar %1</translation>
    </message>
    <message>
      <source>shooting %1 again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fotografiar otra vez %1</translation>
    </message>
    <message>
      <source>One of the two has no back to be joined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Uno de los dos no tiene reverso que unir.</translation>
    </message>
    <message>
      <source>joining %1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unir %1 y %2</translation>
    </message>
    <message>
      <source>cutting %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cortar %1</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>punto inicial</translation>
    </message>
    <message>
      <source>settling by the rims</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ajuste por los bordes</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>giro a mano</translation>
    </message>
    <message>
      <source>Closed model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelo cerrado</translation>
    </message>
    <message>
      <source>This pair has no closed model yet; it is made when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta pareja aún no tiene modelo cerrado; se hace al calcular la tanda.</translation>
    </message>
    <message>
      <source>Picture of a pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen de una pareja</translation>
    </message>
    <message>
      <source>More candidates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Más candidatos</translation>
    </message>
    <message>
      <source>This back lies alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este reverso está solo.</translation>
    </message>
    <message>
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay pareja elegida: dé primero este reverso a un anverso.</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un reverso solo no tiene modelo cerrado.</translation>
    </message>
    <message>
      <source>Stopped; the back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido; el reverso queda donde estaba.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que solo se probó ya no existe: sus parejas se cerraron desde entonces.</translation>
    </message>
    <message>
      <source>Saved, with your name; but the rims of %1 and %2 hardly meet: %3 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado, con su nombre; pero los bordes de %1 y %2 apenas se encuentran: el %3.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías de ambos lados</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anverso %1, reverso %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La fotografía no está.</translation>
    </message>
    <message>
      <source>front %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anverso %1</translation>
    </message>
    <message>
      <source>back %1, mirrored</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>reverso %1, en espejo</translation>
    </message>
    <message>
      <source>back %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>reverso %1</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Line over the %1, %2 steps from its middle, turned by %3 degrees</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Línea sobre %1, a %2 pasos del centro, girada %3 grados</translation>
    </message>
    <message>
      <source>Arrows move the line, with Shift they turn it, Up or Down takes the other side, Enter cuts. Or draw a line with the mouse.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las flechas mueven la línea, con Mayús la giran, Arriba o Abajo toma el otro lado, Intro corta. O trace una línea con el ratón.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlaceEdit</name>
    <message>
      <source>&amp;Bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Bolsa</translation>
    </message>
    <message>
      <source>scan its label, or ARM1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>escanee su etiqueta, o ARM1-T3-0012-4</translation>
    </message>
    <message>
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yacimiento, corte, contexto y bolsa</translation>
    </message>
    <message>
      <source>no bag: no numbers yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sin bolsa: aún sin números</translation>
    </message>
    <message>
      <source>site-trench-context-bag, please</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yacimiento-corte-contexto-bolsa, por favor</translation>
    </message>
    <message>
      <source>New: %1 (Esc takes it back)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nuevo: %1 (Esc lo deshace)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlateView</name>
    <message>
      <source>Picture of the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen del plato</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Se ve %n fragmento</numerusform>
        <numerusform>Se ven %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>5 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>5 cm</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::QueueStation</name>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pausa</translation>
    </message>
    <message>
      <source>Compute again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Calcular otra vez</translation>
    </message>
    <message>
      <source>Stop this batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener esta tanda</translation>
    </message>
    <message>
      <source>Report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Informe</translation>
    </message>
    <message>
      <source>Review it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Revisarla</translation>
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Registro</translation>
    </message>
    <message>
      <source>Batches</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tandas</translation>
    </message>
    <message>
      <source>Log of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Registro del cálculo</translation>
    </message>
    <message>
      <source>No batch yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay tandas</translation>
    </message>
    <message>
      <source>What you photograph or import is computed here, one batch after the other, while you go on working.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que fotografíe o importe se calcula aquí, una tanda tras otra, mientras usted sigue trabajando.</translation>
    </message>
    <message>
      <source>Photograph the first batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografiar la primera tanda</translation>
    </message>
    <message>
      <source>Queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cola</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n tanda se detuvo y le necesita</numerusform>
        <numerusform>%n tandas se detuvieron y le necesitan</numerusform>
      </translation>
    </message>
    <message>
      <source>Go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seguir</translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 aún no tiene informe.</translation>
    </message>
    <message>
      <source>Stop %1?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Detener %1?</translation>
    </message>
    <message>
      <source>It has been computed for more than an hour. Whole stages are kept, the present one is lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se calcula desde hace más de una hora. Las etapas enteras se conservan, la actual se pierde.</translation>
    </message>
    <message>
      <source>Stop it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenerla</translation>
    </message>
    <message>
      <source>Let it go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dejar que siga</translation>
    </message>
    <message>
      <source>Mend the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Corregir las máscaras</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Primero borradores</translation>
    </message>
    <message>
      <source>Computes each new batch quickly and coarsely, to be looked at while the sherds still lie there; computed again it becomes final (D)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Calcula cada tanda nueva deprisa y sin detalle, para verlo mientras los fragmentos siguen ahí; calculada de nuevo es definitiva (D)</translation>
    </message>
    <message>
      <source>Calibrate the rig again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Calibrar otra vez el equipo</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cámara recibió un golpe: las fotos de esta tanda dicen dónde están ahora las cámaras (C)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Rail</name>
    <message>
      <source>Stations</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Puestos</translation>
    </message>
    <message>
      <source>%1  %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1  %2</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewPane</name>
    <message>
      <source>Pairs, most doubtful first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parejas, las más dudosas primero</translation>
    </message>
    <message>
      <source>This one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta</translation>
    </message>
    <message>
      <source>Next pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pareja siguiente</translation>
    </message>
    <message>
      <source>Previous pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pareja anterior</translation>
    </message>
    <message>
      <source>Candidate %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Candidato %1</translation>
    </message>
    <message>
      <source>Start point before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Punto inicial anterior</translation>
    </message>
    <message>
      <source>Next start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Punto inicial siguiente</translation>
    </message>
    <message>
      <source>One sample back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una muestra atrás</translation>
    </message>
    <message>
      <source>One sample on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una muestra adelante</translation>
    </message>
    <message>
      <source>Mirror back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Espejo</translation>
    </message>
    <message>
      <source>Apart</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Separar</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sección</translation>
    </message>
    <message>
      <source>Measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Medir</translation>
    </message>
    <message>
      <source>Rim gap</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hueco del borde</translation>
    </message>
    <message>
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelo</translation>
    </message>
    <message>
      <source>Settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajustar</translation>
    </message>
    <message>
      <source>Let the rims settle the position (B)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dejar que los bordes ajusten la posición (B)</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apartar</translation>
    </message>
    <message>
      <source>Shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Repetir foto</translation>
    </message>
    <message>
      <source>Cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cortar</translation>
    </message>
    <message>
      <source>Join</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unir</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>%1, key %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, tecla %2</translation>
    </message>
    <message>
      <source>This one   Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta   Intro</translation>
    </message>
    <message>
      <source>The rims are compared … Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comparando los bordes … Esc detiene.</translation>
    </message>
    <message>
      <source>… and the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>… y el otro extremo</translation>
    </message>
    <message>
      <source>Pairs of the batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parejas de la tanda</translation>
    </message>
    <message>
      <source>Join two pieces of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unir dos piezas de un fragmento: elija después la otra ficha (J anversos, Mayús+J reversos)</translation>
    </message>
    <message>
      <source>Join backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unir reversos</translation>
    </message>
    <message>
      <source>Settle, join and cut nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No asentar, unir ni cortar nada</translation>
    </message>
    <message>
      <source>Cut a piece that is two sherds in truth, along a line over its picture (K)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cortar una pieza que en realidad son dos fragmentos, por una línea sobre su imagen (K)</translation>
    </message>
    <message>
      <source>The rims settle: %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los bordes se asientan: %1. Esc detiene.</translation>
    </message>
    <message>
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Haga clic en un extremo de la longitud sobre el fragmento y luego en el otro. D termina.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tanda</translation>
    </message>
    <message>
      <source>Your &amp;initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sus &amp;iniciales</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sus iniciales</translation>
    </message>
    <message>
      <source>Compute what changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Calcular lo que cambió</translation>
    </message>
    <message>
      <source>Makes the models of the pairs that were decided anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hace los modelos de las parejas decididas de nuevo</translation>
    </message>
    <message>
      <source>No batch is computed yet. Shoot or import one; its pairs appear here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay tanda calculada. Fotografíe o importe una; sus parejas aparecen aquí.</translation>
    </message>
    <message>
      <source>Opening %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abriendo %1</translation>
    </message>
    <message>
      <source>%1 waits to be computed; only what changed is done again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 espera a ser calculada; solo se repite lo que cambió.</translation>
    </message>
    <message>
      <source>Saved. The pairs of the new pieces come when it is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Las parejas de las piezas nuevas vienen con el cálculo.</translation>
    </message>
    <message>
      <source>Taken back. Both are kept in the history.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Retirado. Ambos quedan en el historial.</translation>
    </message>
    <message>
      <source>Saved, with your name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado, con su nombre.</translation>
    </message>
    <message>
      <source>No pair needs your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguna pareja necesita su ojo</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) need your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n pareja necesita su ojo</numerusform>
        <numerusform>%n parejas necesitan su ojo</numerusform>
      </translation>
    </message>
    <message>
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Revisión</translation>
    </message>
    <message>
      <source>Where its report is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A su informe</translation>
    </message>
    <message>
      <source>None of the measures of %1 is sure. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguna de las medidas de %1 es segura. %2</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigPage</name>
    <message>
      <source>Two of them look alike</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos de ellos se parecen</translation>
    </message>
    <message>
      <source>What do you photograph with?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Con qué fotografía?</translation>
    </message>
    <message>
      <source>The virtual rig breaks a pot and photographs its sherds: try everything with it. A rig file (RIG.json) names your cameras and your turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo virtual rompe una vasija y fotografía sus fragmentos: pruébelo todo con él. Un archivo de equipo (RIG.json) nombra sus cámaras y su mesa giratoria.</translation>
    </message>
    <message>
      <source>Use the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Usar el equipo virtual</translation>
    </message>
    <message>
      <source>Choose a rig file…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir un archivo de equipo…</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar fotografías…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar escaneos…</translation>
    </message>
    <message>
      <source>The virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo virtual</translation>
    </message>
    <message>
      <source>small: a batch in a minute or two</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pequeñas: una tanda en uno o dos minutos</translation>
    </message>
    <message>
      <source>normal</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>normales</translation>
    </message>
    <message>
      <source>fine: as a real camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>finas: como una cámara real</translation>
    </message>
    <message>
      <source>&amp;Sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Fragmentos en el plato</translation>
    </message>
    <message>
      <source>&amp;Photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fo&amp;tografías</translation>
    </message>
    <message>
      <source>%1 pixels wide</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 píxeles de ancho</translation>
    </message>
    <message>
      <source>Rig file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Archivo de equipo</translation>
    </message>
    <message>
      <source>Rig (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Equipo (*.json)</translation>
    </message>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Espacio</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SettingsPage</name>
    <message>
      <source>As the desktop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Como el escritorio</translation>
    </message>
    <message>
      <source>Light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Claro</translation>
    </message>
    <message>
      <source>Dark, for the tent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oscuro, para la tienda</translation>
    </message>
    <message>
      <source>Sunlight: black on white, thick lines</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Luz de sol: negro sobre blanco, líneas gruesas</translation>
    </message>
    <message>
      <source>all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>todos</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajustes</translation>
    </message>
    <message>
      <source>&amp;Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sus &amp;iniciales</translation>
    </message>
    <message>
      <source>They stand in the history of each decision.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Constan en el historial de cada decisión.</translation>
    </message>
    <message>
      <source>&amp;Theme</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Tema</translation>
    </message>
    <message>
      <source>Te&amp;xt size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tamaño del te&amp;xto</translation>
    </message>
    <message>
      <source>Text size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tamaño del texto</translation>
    </message>
    <message>
      <source>&amp;Language</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>I&amp;dioma</translation>
    </message>
    <message>
      <source>Holds from the next start.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vale desde el próximo inicio.</translation>
    </message>
    <message>
      <source>&amp;Processors for computing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Procesadores para el cálculo</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Volver al trabajo (Esc)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SheetView</name>
    <message>
      <source>The drawing on its sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dibujo en su hoja</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdDetails</name>
    <message>
      <source>missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>falta</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiado</translation>
    </message>
    <message>
      <source>present</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>presente</translation>
    </message>
    <message>
      <source>Details of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detalles del fragmento</translation>
    </message>
    <message>
      <source>Number of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Número del fragmento</translation>
    </message>
    <message>
      <source>Picture of the sherd in the way</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen del fragmento que lo impide</translation>
    </message>
    <message>
      <source>measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>medida</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>valor</translation>
    </message>
    <message>
      <source>from</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>origen</translation>
    </message>
    <message>
      <source>Measurements</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Medidas</translation>
    </message>
    <message>
      <source>when</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cuándo</translation>
    </message>
    <message>
      <source>who</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>quién</translation>
    </message>
    <message>
      <source>what</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>qué</translation>
    </message>
    <message>
      <source>History</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Historial</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>archivo</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>clase</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>estado</translation>
    </message>
    <message>
      <source>Files</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Archivos</translation>
    </message>
    <message>
      <source>Measured</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Medido</translation>
    </message>
    <message>
      <source>Context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Contexto</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contexto</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aún sin número</translation>
    </message>
    <message>
      <source>Give the number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dar el número %1</translation>
    </message>
    <message>
      <source>added</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>añadido</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>%1: %2 → %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 → %3</translation>
    </message>
    <message>
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nada</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>programa</translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elija un fragmento.</translation>
    </message>
    <message>
      <source>%1 It is %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Es %2.</translation>
    </message>
    <message>
      <source>%1; in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; dudoso</translation>
    </message>
    <message>
      <source>%1 ± %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ± %2</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdEdits</name>
    <message numerus="yes">
      <source>number %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>numerar %n fragmento</numerusform>
        <numerusform>numerar %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Other changes are still being saved; wait for them, or stop them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía se guardan otros cambios; espere, o deténgalos.</translation>
    </message>
    <message>
      <source>The sherds that are chosen have their numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los fragmentos elegidos tienen sus números.</translation>
    </message>
    <message>
      <source>Numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Números</translation>
    </message>
    <message>
      <source>Stopped; nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido; no cambió nada.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdTableModel</name>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen de un fragmento</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>not recorded</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>no registrado</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aún sin número</translation>
    </message>
    <message>
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, dudoso</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: la escala del lote %2 es dudosa; su informe dice por qué y qué hacer.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdView</name>
    <message>
      <source>Sherd in three dimensions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento en tres dimensiones</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the sherd cannot be shown in three dimensions. Everything else works; photographs and outlines are beside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta pantalla no tiene OpenGL 3.2; el fragmento no se puede mostrar en tres dimensiones. Todo lo demás funciona; fotografías y contornos están al lado.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::StartScreen</name>
    <message>
      <source>Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka</translation>
    </message>
    <message>
      <source>Potsherds, both sides, complete and measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos cerámicos, ambos lados, completos y medidos.</translation>
    </message>
    <message>
      <source>&amp;Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Proyectos</translation>
    </message>
    <message>
      <source>No project yet. Make one, or try everything with the virtual rig: it breaks a pot and photographs its sherds for you.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay proyecto. Haga uno, o pruébelo todo con el equipo virtual: rompe una vasija y fotografía sus fragmentos.</translation>
    </message>
    <message>
      <source>&amp;Open a project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Abrir un proyecto…</translation>
    </message>
    <message>
      <source>Try with the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Probar con el equipo virtual</translation>
    </message>
    <message>
      <source>New project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nuevo proyecto</translation>
    </message>
    <message>
      <source>Aragats 2026</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aragats 2026</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir…</translation>
    </message>
    <message>
      <source>Choose the folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir la carpeta</translation>
    </message>
    <message>
      <source>Make the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Crear el proyecto</translation>
    </message>
    <message>
      <source>&amp;Name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Nombre</translation>
    </message>
    <message>
      <source>&amp;Site code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Código del &amp;yacimiento</translation>
    </message>
    <message>
      <source>&amp;Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Carpeta</translation>
    </message>
    <message>
      <source>Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>N&amp;umeración</translation>
    </message>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento será</translation>
    </message>
    <message>
      <source>%1
%2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2, %3</translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>De acuerdo</translation>
    </message>
    <message>
      <source>Folder of the new project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta del proyecto nuevo</translation>
    </message>
    <message>
      <source>Folder of a project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta de un proyecto</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Proyectos</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2 no está: búsquelo …</translation>
    </message>
    <message>
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Dónde está %1 ahora?</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::StopBoard</name>
    <message>
      <source>Photographs of this side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías de este lado</translation>
    </message>
    <message>
      <source>%1 of %2 stops are done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de %2 paradas hechas</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Thumbnails</name>
    <message>
      <source>Picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imagen</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ViewOverlay</name>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>front: blue rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anverso: borde azul</translation>
    </message>
    <message>
      <source>back: red rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>reverso: borde rojo</translation>
    </message>
    <message>
      <source>%1 mm and more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm y más</translation>
    </message>
    <message>
      <source>0 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>0 mm</translation>
    </message>
    <message>
      <source>gap between the sides along the rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hueco entre los lados a lo largo del borde</translation>
    </message>
    <message>
      <source>grey: not met by the other side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>gris: la otra cara no llega aquí</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, a whole number, or scan its label</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, un número entero o leer su etiqueta</translation>
    </message>
    <message>
      <source>&amp;Number of sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Número del fragmento %1</translation>
    </message>
    <message>
      <source>If they have numbers already: each follows its sherd through the flip. Key N.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Si ya tienen números: cada uno sigue a su fragmento al darle la vuelta. Tecla N.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskModel</name>
    <message>
      <source>%1, camera %2, stop %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, cámara %2, parada %3</translation>
    </message>
    <message>
      <source>Mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Máscara</translation>
    </message>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Máscaras de %1</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>reverso</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anverso</translation>
    </message>
    <message>
      <source>paint on a mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pintar en una máscara</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Máscaras de %1</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) mended; what follows from them is computed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fotografía corregida; lo que sigue de ella se calcula de nuevo.</numerusform>
        <numerusform>%n fotografías corregidas; lo que sigue de ellas se calcula de nuevo.</numerusform>
      </translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Volver</translation>
    </message>
    <message>
      <source>Brush's &amp;width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Ancho del pincel</translation>
    </message>
    <message>
      <source>Compute with these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Calcular con estas</translation>
    </message>
    <message>
      <source>Larger</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Más grande</translation>
    </message>
    <message>
      <source>Smaller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Más pequeño</translation>
    </message>
    <message>
      <source>Next photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografía siguiente</translation>
    </message>
    <message>
      <source>Photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografía</translation>
    </message>
    <message>
      <source>Photograph before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografía anterior</translation>
    </message>
    <message>
      <source>Plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plato</translation>
    </message>
    <message>
      <source>Sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento</translation>
    </message>
    <message>
      <source>The photograph is being read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se está leyendo la fotografía.</translation>
    </message>
    <message>
      <source>What is veiled in blue is taken for sherd. Paint what is missing, or as plate what is too much; the program's own masks stay.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo velado en azul se toma por fragmento. Pinte lo que falta o, como plato, lo que sobra; las máscaras del programa se conservan.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskView</name>
    <message>
      <source>Photograph with its mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografía con su máscara</translation>
    </message>
    <message>
      <source>The arrows move the brush, Space paints, plus and minus enlarge and reduce.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las flechas mueven el pincel, Espacio pinta, más y menos amplían y reducen.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberingEdit</name>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento será</translation>
    </message>
    <message>
      <source>First number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Primer número de este ordenador</translation>
    </message>
    <message>
      <source>Last number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Último número de este ordenador</translation>
    </message>
    <message>
      <source>Left out so far</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Omitidos hasta ahora</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>N&amp;umeración</translation>
    </message>
    <message>
      <source>Num&amp;bers of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Números de este &amp;ordenador</translation>
    </message>
    <message>
      <source>Number so from &amp;now on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Numerar así desde ahora</translation>
    </message>
    <message>
      <source>Numbers of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Números del proyecto abierto</translation>
    </message>
    <message>
      <source>What has a number keeps it; the next sherds follow. No number is ever given twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que tiene número lo conserva; los siguientes fragmentos lo siguen. Ningún número se da dos veces.</translation>
    </message>
    <message numerus="yes">
      <source>and in %n more context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>y en %n contexto más</numerusform>
        <numerusform>y en %n contextos más</numerusform>
      </translation>
    </message>
    <message>
      <source>no number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ningún número</translation>
    </message>
    <message>
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>a</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, y {n} una vez; {n:04} tiene al menos cuatro cifras</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberingModel</name>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Numbers left out</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Números omitidos</translation>
    </message>
    <message>
      <source>Sherds of %1 get no number so: it lacks a part that the numbering names.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los fragmentos de %1 no reciben así número: le falta una parte que nombra la numeración.</translation>
    </message>
    <message>
      <source>The first number of a block is not above its last.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El primer número de un bloque no es mayor que el último.</translation>
    </message>
    <message>
      <source>change the numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiar la numeración</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::VocabularyEdit</name>
    <message>
      <source>&amp;Save the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Guardar las palabras</translation>
    </message>
    <message>
      <source>&amp;Words for</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pala&amp;bras para</translation>
    </message>
    <message>
      <source>A word that sherds use already stays; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una palabra que ya usan fragmentos se queda; cambie antes esos.</translation>
    </message>
    <message>
      <source>&amp;One a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un&amp;a por línea</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado.</translation>
    </message>
    <message>
      <source>Words of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Palabras del proyecto abierto</translation>
    </message>
    <message>
      <source>Words, one a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Palabras, una por línea</translation>
    </message>
    <message>
      <source>change the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiar las palabras</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>conservación</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>decoración</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cocción</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>manufactura</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parte</translation>
    </message>
    <message>
      <source>surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>superficie</translation>
    </message>
    <message>
      <source>These words are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estas palabras aún no están guardadas.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CountEdit</name>
    <message>
      <source>&amp;Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Fragmentos</translation>
    </message>
    <message>
      <source>not counted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sin contar</translation>
    </message>
    <message>
      <source>How many sherds you counted onto the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cuántos fragmentos ha contado sobre el plato</translation>
    </message>
    <message>
      <source>Count them if you like: you are asked when the photographs show another number (S)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cuéntelos si quiere: se le pregunta cuando las fotos muestran otro número (S)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigRenewal</name>
    <message>
      <source>Calibration by %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Calibración según %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hasta dónde ha llegado la importación</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener la importación</translation>
    </message>
  </context>
  <context>
    <name>ImportBatch</name>
    <message>
      <source>There are no scans (*.ply) in its folder %1/. Choose a folder that holds front/ and back/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay escaneos (*.ply) en su carpeta %1/. Elija una carpeta que contenga front/ y back/.</translation>
    </message>
    <message>
      <source>This folder cannot be read to its end: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta no se puede leer hasta el final: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdNumbers</name>
    <message>
      <source>%1 is no sherd's number: it has a digit, no space and at most %2 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 no es un número de fragmento: tiene una cifra, ningún espacio y como máximo %2 caracteres.</translation>
    </message>
    <message>
      <source>Sherd %1 of this plate has the number %2: take it from that one first, or type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El fragmento %1 de este plato tiene el número %2: quíteselo primero a ese o escriba otro.</translation>
    </message>
    <message>
      <source>A sherd of %1 has the number %2 already; type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento de %1 ya tiene el número %2; escriba otro.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Doubts</name>
    <message>
      <source>the file is cut off or no picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el archivo está cortado o no es una imagen</translation>
    </message>
    <message>
      <source>the markers show another angle than this stop's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>las marcas muestran otro ángulo que el de esta parada</translation>
    </message>
    <message>
      <source>the picture has another size than the camera's others</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la imagen tiene otro tamaño que las demás de la cámara</translation>
    </message>
    <message>
      <source>too few markers are seen to tell the stop: is something before them, is it blurred?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>se ven muy pocas marcas para saber la parada: ¿hay algo delante, está borrosa?</translation>
    </message>
    <message>
      <source>the camera handed over an earlier photograph once more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la cámara entregó otra vez una foto anterior</translation>
    </message>
    <message>
      <source>too few markers of the plate are seen: is something before them?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>se ven muy pocas marcas del plato: ¿hay algo delante?</translation>
    </message>
    <message>
      <source>it is blurred: did the table still move, did the focus change?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>está borrosa: ¿se movía aún la mesa, cambió el enfoque?</translation>
    </message>
    <message>
      <source>the sherds are too dark: give more light or expose longer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>los fragmentos están muy oscuros: dé más luz o exponga más tiempo</translation>
    </message>
    <message>
      <source>the sherds are burnt out: expose shorter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>los fragmentos están sobreexpuestos: exponga menos tiempo</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el borde de la imagen corta un fragmento: muévalo, o mueva la cámara</translation>
    </message>
    <message>
      <source>the camera's settings are others than they were: set them back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>los ajustes de la cámara no son los de antes: restablézcalos</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>%1: set it back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: restablézcalo</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate's markers are seen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudieron contar los fragmentos: se ven muy pocas marcas del plato.</translation>
    </message>
    <message>
      <source>No sherd is seen on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se ve ningún fragmento en el plato.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate's middle: move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay fragmentos que se tocan o casi se tocan en %1 desde el centro del plato: sepárelos y fotografíe otra vez.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate's middle was counted as one but may be two sherds that touch: look there; if so, move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que está en %1 desde el centro del plato se contó como uno, pero pueden ser dos fragmentos que se tocan: mire ahí; si es así, sepárelos y fotografíe otra vez.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and photograph them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dorso parece el anverso: dé la vuelta a los fragmentos y fotografíelos otra vez.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudieron contar los fragmentos del dorso: compare usted mismo las imágenes antes de vaciar el plato.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudieron contar los fragmentos del anverso: compare usted mismo las imágenes antes de vaciar el plato.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: look for the missing one before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El anverso mostró %1 fragmentos, el dorso %2: busque el que falta antes de vaciar el plato.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: was one added, or did one break?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El anverso mostró %1 fragmentos, el dorso %2: ¿se añadió uno, o se rompió uno?</translation>
    </message>
  </context>
  <context>
    <name>ostraka::Error</name>
    <message>
      <source>Stopped on request.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido a petición.</translation>
    </message>
    <message>
      <source>The camera is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no está conectada.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no está conectada o no está encendida.</translation>
    </message>
    <message>
      <source>The camera does not answer; is it asleep? Switch its automatic power-off off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no responde; ¿está en reposo? Desactive su apagado automático.</translation>
    </message>
    <message>
      <source>The camera stays busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara sigue ocupada; apáguela y enciéndala.</translation>
    </message>
    <message>
      <source>The line to the camera is broken; look at its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se cortó la conexión con la cámara; revise su cable.</translation>
    </message>
    <message>
      <source>The camera is held by another program, often the desktop's file manager; 'ostraka devices' names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa retiene la cámara, a menudo el gestor de archivos; 'ostraka devices' lo nombra.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; may this user use it? Look at 'ostraka devices'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no se puede abrir; ¿puede usarla este usuario? Vea 'ostraka devices'.</translation>
    </message>
    <message>
      <source>No photograph came from the camera; is it focused and set to manual?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No llegó ninguna foto de la cámara; ¿está enfocada y en modo manual?</translation>
    </message>
    <message>
      <source>The camera does not stop to deliver photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no deja de entregar fotos.</translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta cámara no muestra imagen en directo.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; is it blocked?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no alcanza su ángulo; ¿está bloqueada?</translation>
    </message>
    <message>
      <source>The turntable was paused at its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria se pausó con su propio botón.</translation>
    </message>
    <message>
      <source>The table's position is not known: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se conoce la posición de la mesa: llévela a cero o alinéela.</translation>
    </message>
    <message>
      <source>The turntable does not answer in the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no responde en la red.</translation>
    </message>
    <message>
      <source>The controller restarted; the table's position is not known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El controlador se reinició; no se conoce la posición de la mesa.</translation>
    </message>
    <message>
      <source>A reply of the turntable was lost and it cannot tell where it stands: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se perdió una respuesta de la mesa y no puede decir dónde está: llévela a cero o alinéela.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa no responde como un controlador GRBL: ¿está encendida y es de este tipo?</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa no responde como una ComXim: ¿está encendida y es de este tipo?</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB no funciona en este ordenador.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and shoot on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco está lleno; libere espacio y siga fotografiando.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and start the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco está lleno; libere espacio y empiece lo mismo otra vez.</translation>
    </message>
    <message>
      <source>The disk is full; make room, then try again. Nothing was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco está lleno; haga sitio e inténtelo otra vez. No se perdió nada.</translation>
    </message>
    <message>
      <source>Another program keeps the catalogue busy; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa mantiene ocupado el catálogo; ciérrelo e inténtelo otra vez.</translation>
    </message>
    <message>
      <source>The image is cut off before its end; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen está cortada antes de su final; cópiela otra vez de la cámara.</translation>
    </message>
  </context>
</TS>
