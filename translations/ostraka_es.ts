<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>ostraka::ui::ProjectSession</name>
    <message>
      <source>This project is read-only: you can look at everything, but change nothing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto es de solo lectura: puede mirarlo todo, pero no cambiar nada.</translation>
    </message>
    <message>
      <source>The project's folder is not there any more: it was moved, renamed, or its disk was taken out. Open the project again where it is now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta del proyecto ya no está: se movió, se renombró o se retiró su disco. Abra el proyecto donde está ahora.</translation>
    </message>
</context>
<context>
    <name>SideLabels</name>
    <message>
      <source>A label among the fronts names %1, one among the backs %2: check that both sides show the same sherds, and type the bag that they are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una etiqueta entre los anversos indica %1 y otra entre los reversos %2: compruebe que ambas caras muestran los mismos fragmentos y escriba su bolsa.</translation>
    </message>
    <message>
      <source>Labels of several bags are in the photographs: %1. Type the one that these sherds are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En las fotografías hay etiquetas de varias bolsas: %1. Escriba la de estos fragmentos.</translation>
    </message>
    <message>
      <source>The label in the photographs names %1: check the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La etiqueta de las fotografías indica %1: compruebe la bolsa.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportAsk</name>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Compruebe esto primero</translation>
    </message>
    <message>
      <source>The label in the photographs names %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La etiqueta de las fotografías indica %1.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar</translation>
    </message>
    <message>
      <source>Cancel import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelar importación</translation>
    </message>
    <message>
      <source>From %1. The bag can also be given later, in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>De %1. La bolsa también puede indicarse más tarde, en el catálogo.</translation>
    </message>
    <message>
        <source>Enter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Intro</translation>
    </message>
    <message>
      <source>To import, confirm or move the division between front and back, or choose one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Para importar, confirme o mueva la división entre anverso y reverso, o elija un solo lado.</translation>
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
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>grosor, mm</translation>
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
      <source>minimum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>grosor mínimo, mm</translation>
    </message>
    <message>
      <source>maximum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>grosor máximo, mm</translation>
    </message>
    <message>
      <source>unseen surface, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>superficie no vista, %</translation>
    </message>
    <message>
      <source>place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>lugar</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>modelo</translation>
    </message>
    <message>
      <source>labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>etiquetas</translation>
    </message>
    <message>
      <source>person</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>persona</translation>
    </message>
    <message>
      <source>name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nombre</translation>
    </message>
    <message>
      <source>initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>iniciales</translation>
    </message>
    <message>
      <source>code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>código</translation>
    </message>
    <message>
      <source>location</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ubicación</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tipo</translation>
    </message>
    <message>
      <source>excavated on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>excavado el</translation>
    </message>
    <message>
      <source>closed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cerrado</translation>
    </message>
    <message>
      <source>collected on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>recogido el</translation>
    </message>
    <message>
      <source>storage</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>almacén</translation>
    </message>
    <message>
      <source>operator</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>operador</translation>
    </message>
    <message>
      <source>counted sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmentos contados</translation>
    </message>
    <message>
      <source>results</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resultados</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>programa</translation>
    </message>
    <message>
      <source>project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>proyecto</translation>
    </message>
    <message>
      <source>title</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>título</translation>
    </message>
    <message>
      <source>institution</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>institución</translation>
    </message>
    <message>
      <source>licence</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>licencia</translation>
    </message>
    <message>
      <source>rights holder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>titular de los derechos</translation>
    </message>
    <message>
      <source>numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>numeración</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmento</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fotografía</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>escaneo</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>archivo</translation>
    </message>
    <message>
      <source>term</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>término</translation>
    </message>
    <message>
      <source>content</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contenido</translation>
    </message>
    <message>
      <source>mask strokes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>trazos en máscaras</translation>
    </message>
    <message>
      <source>entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>registrado</translation>
    </message>
    <message>
      <source>excavated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>excavado</translation>
    </message>
    <message>
      <source>measured by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>medido a mano</translation>
    </message>
    <message>
      <source>centre of mass x, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>centro de masa x, mm</translation>
    </message>
    <message>
      <source>centre of mass y, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>centro de masa y, mm</translation>
    </message>
    <message>
      <source>centre of mass z, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>centro de masa z, mm</translation>
    </message>
    <message>
      <source>model file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>archivo del modelo</translation>
    </message>
    <message>
      <source>picture file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>archivo de la imagen</translation>
    </message>
    <message>
      <source>drawing file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>archivo del dibujo</translation>
    </message>
    <message>
      <source>sherds written on the bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmentos según la bolsa</translation>
    </message>
    <message>
      <source>column of the CSV</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>columna del CSV</translation>
    </message>
    <message>
      <source>column</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>columna</translation>
    </message>
    <message>
      <source>unit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unidad</translation>
    </message>
    <message>
      <source>meaning</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>significado</translation>
    </message>
    <message>
      <source>reason for voiding</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>motivo de la anulación</translation>
    </message>
    <message>
      <source>identical with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>idéntico a</translation>
    </message>
</context>
<context>
    <name>Job</name>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un defecto del programa; comuníquelo con el registro (%1).</translation>
    </message>
    <message>
      <source>Not enough memory. Close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Memoria insuficiente. Cierre otros programas e inténtelo otra vez.</translation>
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
    <message numerus="yes">
        <source>%n sherd(s) counted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n fragmento contado</numerusform>
            <numerusform>%n fragmentos contados</numerusform>
        </translation>
    </message>
    <message>
      <source>invented by the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>inventado por el equipo virtual</translation>
    </message>
    <message>
      <source>context %1, although %2 exists</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contexto %1, aunque ya existe %2</translation>
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
      <source>Finding the cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Localizando las cámaras</translation>
    </message>
    <message>
      <source>Measuring the shape, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Midiendo la forma, anverso</translation>
    </message>
    <message>
      <source>Measuring the shape, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Midiendo la forma, reverso</translation>
    </message>
    <message>
      <source>Cutting the sherds out, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Recortando cada fragmento, anverso</translation>
    </message>
    <message>
      <source>Cutting the sherds out, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Recortando cada fragmento, reverso</translation>
    </message>
    <message>
      <source>Matching fronts and backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Emparejando anversos y reversos</translation>
    </message>
    <message>
      <source>Closing the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cerrando los modelos</translation>
    </message>
    <message>
      <source>Writing the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escribiendo el informe</translation>
    </message>
    <message>
      <source>Entering the sherds into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anotando los fragmentos en el catálogo</translation>
    </message>
    <message>
      <source>Starting</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comenzando</translation>
    </message>
    <message>
      <source>Looking for other partners in doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buscando otras parejas para los pares dudosos</translation>
    </message>
    <message>
      <source>Finding the sherds, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buscando los fragmentos, anverso</translation>
    </message>
    <message>
      <source>Finding the sherds, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buscando los fragmentos, reverso</translation>
    </message>
</context>
<context>
    <name>Time</name>
    <message>
      <source>less than a minute left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>queda menos de un minuto</translation>
    </message>
    <message>
      <source>about %1 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>quedan unos %1 min</translation>
    </message>
    <message>
      <source>about %1 h left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>quedan unas %1 h</translation>
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
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 y %2 encajan ambos con %3.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Su reverso se dio a otro anverso: ¿es %1 el correcto ahora?</translation>
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
      <source>shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>volver a fotografiar</translation>
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
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bolsa %1</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este reverso está apartado. Arrástrelo sobre un anverso para usarlo después de todo.</translation>
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
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girado a mano.</translation>
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
      <source>Sure by what was decided for others: %1; by itself %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seguro por lo decidido para otros: %1; por sí solo %2.</translation>
    </message>
    <message>
      <source>%1, aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, aparte</translation>
    </message>
    <message>
      <source>%1, shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, volver a fotografiar</translation>
    </message>
    <message>
      <source>%1, void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, anulado</translation>
    </message>
    <message>
      <source>%1 in %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 en %2</translation>
    </message>
    <message>
      <source>now %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ahora %1</translation>
    </message>
    <message>
        <source>front %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>anverso %1</translation>
    </message>
    <message>
        <source>back %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>reverso %1</translation>
    </message>
    <message>
        <source>Merged with %1 by %2. It is one fragment once the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Unido con %1 por %2. Será un solo trozo cuando se reprocese la tanda.</translation>
    </message>
    <message>
        <source>Split by %1. Its fragments appear when the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dividido por %1. Sus trozos aparecen al reprocesar la tanda.</translation>
    </message>
    <message>
        <source>Merged</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Unido</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dividido</translation>
    </message>
    <message>
        <source>No front</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sin anverso</translation>
    </message>
    <message>
        <source>This back is to be reshot.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Este reverso debe volver a fotografiarse.</translation>
    </message>
    <message>
        <source>No front holds this back. Drag it onto its front, merge it with another, or set it aside.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ningún anverso tiene este reverso. Arrástrelo a su anverso, únalo con otro o apártelo.</translation>
    </message>
    <message>
        <source>%1 and %2 both fit %3: their fractures differ by only %4.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 y %2 encajan con %3: sus fracturas difieren solo en %4.</translation>
    </message>
    <message>
        <source>%1 would fit %2 almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 encajaría casi igual de bien con %2.</translation>
    </message>
    <message>
        <source>%1 fits barely better than an unrelated back.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 encaja apenas mejor que un reverso ajeno.</translation>
    </message>
    <message>
        <source>Ambiguous: a second position fits almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ambiguo: una segunda posición encaja casi igual de bien.</translation>
    </message>
    <message>
        <source>%1 confident</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Confianza: %1</translation>
    </message>
    <message>
        <source>Check</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Revisar</translation>
    </message>
    <message>
        <source>No back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sin reverso</translation>
    </message>
    <message>
        <source>Sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Seguro</translation>
    </message>
    <message>
        <source>Decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Decidido</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Apartado</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Volver a fotografiar</translation>
    </message>
    <message>
        <source>To be reshot, decided by %1 on %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Para volver a fotografiar, decidido por %1 el %2.</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sustituir por el valor medido</translation>
    </message>
    <message>
        <source>Delete computed value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Borrar el valor calculado</translation>
    </message>
    <message>
        <source>Save this value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Guardar este valor</translation>
    </message>
    <message>
        <source>%1 (computed %2)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 (calculado %2)</translation>
    </message>
    <message>
        <source>The two scans share only %1 of the fracture.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Los dos escaneos solo comparten %1 de la fractura.</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aún sin número</translation>
    </message>
    <message>
      <source>Another partner fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otra pareja encaja casi igual de bien.</translation>
    </message>
    <message>
      <source>no probability</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sin probabilidad</translation>
    </message>
    <message>
      <source>The nearest outline; no probability is known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El contorno más parecido; no se conoce ninguna probabilidad.</translation>
    </message>
    <message>
      <source>Another front takes the same back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro anverso toma el mismo reverso.</translation>
    </message>
    <message>
      <source>The two scans share almost no fracture; only their outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los dos escaneos casi no comparten fractura; solo los contornos los unen.</translation>
    </message>
    <message>
      <source>The fractures do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fracturas no encajan: %1 de separación.</translation>
    </message>
    <message>
      <source>The fracture barely fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La fractura apenas fija la posición: incertidumbre de %1.</translation>
    </message>
    <message>
      <source>A position %1 along the contour fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una posición a %1 por el contorno encaja casi igual de bien.</translation>
    </message>
    <message>
      <source>The fractures cannot be compared; only the outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fracturas no se pueden comparar; solo los contornos unen estos lados.</translation>
    </message>
    <message>
      <source>refined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ajustado</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girado a mano: se toca el %1 de las fracturas.</translation>
    </message>
    <message>
      <source>Trying another start point: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba otro punto inicial: se toca el %1 de las fracturas.</translation>
    </message>
    <message>
      <source>Trying another start point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba otro punto inicial.</translation>
    </message>
    <message>
      <source>Refined by the fractures: %1 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajustado por las fracturas: se toca el %1.</translation>
    </message>
    <message>
      <source>Refined by the fractures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajustado por las fracturas.</translation>
    </message>
    <message>
      <source>Trying %1: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba %1: %2.</translation>
    </message>
    <message>
      <source>Trying %1: %2, fractures %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba %1: %2, fracturas separadas %3.</translation>
    </message>
    <message>
      <source>Trying %1: %2; its fractures do not touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se prueba %1: %2; las fracturas no se tocan.</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmento %1 de %2</translation>
    </message>
    <message>
      <source>imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>importado</translation>
    </message>
    <message>
      <source>estimated by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>estimado a mano</translation>
    </message>
    <message>
      <source>%1 confident; below %2, a person decides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Certeza del %1; por debajo del %2 decide una persona.</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Intro</translation>
    </message>
    <message>
      <source>%1 ± %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ± %2</translation>
    </message>
    <message>
      <source>Only %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Solo el %1 de las fracturas se toca.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento</numerusform>
        <numerusform>%n fragmentos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep a number of the old context: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento conserva un número del contexto antiguo: %1.</numerusform>
        <numerusform>%n fragmentos conservan un número del contexto antiguo: %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag, because there is no bag %1 yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento deja su bolsa, porque aún no hay bolsa %1.</numerusform>
        <numerusform>%n fragmentos dejan sus bolsas, porque aún no hay bolsa %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento deja su bolsa.</numerusform>
        <numerusform>%n fragmentos dejan sus bolsas.</numerusform>
      </translation>
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
    <message numerus="yes">
      <source>Sheet recognised: %n marker(s). Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Hoja reconocida: %n marcador. Los tamaños parten del lado de marcador que se escribió, %1 mm; compruébelo en el papel con una regla.</numerusform>
        <numerusform>Hoja reconocida: %n marcadores. Los tamaños parten del lado de marcador que se escribió, %1 mm; compruébelo en el papel con una regla.</numerusform>
      </translation>
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
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aviso: %1</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>otra vez</translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: en pausa</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento</numerusform>
        <numerusform>%n fragmentos</numerusform>
      </translation>
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
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 espera el borrador de %2.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En esta tanda se hallaron de nuevo las cámaras; calibre otra vez el equipo (C).</translation>
    </message>
    <message>
      <source>You set it aside. Its photographs are kept; R takes it up again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo ha apartado. Sus fotografías se conservan; R lo retoma.</translation>
    </message>
    <message>
      <source>%1; is %2 the sherd that it was? It measured %3 mm, now %4 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; ¿es %2 el mismo fragmento? Medía %3 mm, ahora %4 mm</translation>
    </message>
    <message>
      <source>%1; the number %2 was typed on its plate, and none of its sherds has it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; el número %2 se escribió en su plato y ninguno de sus fragmentos lo tiene</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n photographed again since</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%1; %n fotografiado de nuevo desde entonces</numerusform>
            <numerusform>%1; %n fotografiados de nuevo desde entonces</numerusform>
        </translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Apartado</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Capturando</translation>
    </message>
    <message>
        <source>Queued</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>En cola</translation>
    </message>
    <message>
        <source>Processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Procesando</translation>
    </message>
    <message>
        <source>Paused</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Detenido</translation>
    </message>
    <message>
        <source>Needs review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Por revisar</translation>
    </message>
    <message>
        <source>Done</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Draft: review it, then reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Borrador: revíselo y luego reprocese la tanda</translation>
    </message>
    <message>
        <source>Masks edited: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Máscaras editadas: reprocesar</translation>
    </message>
    <message>
        <source>Scale in doubt: see the report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Escala dudosa: vea el informe</translation>
    </message>
    <message>
        <source>Decided: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Decidido: reprocesar</translation>
    </message>
    <message>
        <source>%1 sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 seguros</translation>
    </message>
    <message>
        <source>%1 decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 decididos</translation>
    </message>
    <message>
        <source>%1 to review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 por revisar</translation>
    </message>
    <message>
        <source>draft, to be reprocessed; %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>borrador, por reprocesar; %1</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n to reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%1; %n por volver a fotografiar</numerusform>
            <numerusform>%1; %n por volver a fotografiar</numerusform>
        </translation>
    </message>
    <message>
      <source>%1; joined to within %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; unidos con un error de %2 mm como máximo</translation>
    </message>
    <message numerus="yes">
      <source>%1 is ready: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 está lista: %n fragmento.</numerusform>
        <numerusform>%1 está lista: %n fragmentos.</numerusform>
      </translation>
    </message>
    <message>
      <source>You cancelled it. Finished stages are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Usted la canceló. Las etapas terminadas están guardadas.</translation>
    </message>
    <message>
      <source>You removed it from the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Usted la sacó de la cola.</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) queued.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>En pausa; espera %n tanda.</numerusform>
        <numerusform>En pausa; esperan %n tandas.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the markers by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 recibió un golpe: yerra las marcas por %2 px, a %3 mm de donde se calibró.</translation>
    </message>
    <message>
      <source>It was interrupted. Reprocess it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se interrumpió. Reprocésela.</translation>
    </message>
    <message>
      <source>No bag was given; its sherds get their context in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se indicó ninguna bolsa; sus fragmentos reciben su contexto en el catálogo.</translation>
    </message>
    <message>
        <source>%1: stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: deteniéndose…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Deteniéndose…</translation>
    </message>
    <message>
      <source>%1, %2 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Draft: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Borrador: %1</translation>
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
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Asignar números</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sustituir por el valor medido</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n valor debe confirmarse.</numerusform>
            <numerusform>%n valores deben confirmarse.</numerusform>
        </translation>
    </message>
    <message>
      <source>rejected: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rechazado: %1</translation>
    </message>
    <message>
      <source>Cancel and undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelar y deshacer</translation>
    </message>
    <message>
      <source>To change: %1. Unchanged: %2. Rejected: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Por cambiar: %1. Sin cambios: %2. Rechazados: %3.</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comparar</translation>
    </message>
    <message>
      <source>Type a value to see what would change, or press Enter in the empty field to delete.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba un valor para ver qué cambiaría, o pulse Intro en el campo vacío para borrar.</translation>
    </message>
    <message>
      <source>Make these bags</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Crear estas bolsas</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CandidateBar</name>
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
    <message>
        <source>gap %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>separación %1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>sin contacto</translation>
    </message>
    <message>
      <source>Another back…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro reverso …</translation>
    </message>
    <message>
      <source>by outline alone</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>solo por el contorno</translation>
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
</context>
<context>
    <name>ostraka::ui::CaptureScreen</name>
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
      <source>'%1' names no bag: write site-trench-context-bag, or empty the line to go on without one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» no nombra ninguna bolsa: escriba yacimiento-corte-contexto-bolsa, o vacíe la línea para seguir sin ella.</translation>
    </message>
    <message>
      <source>Set this batch aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apartar esta tanda</translation>
    </message>
    <message>
      <source>The bag is another now, the numbers are not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La bolsa es ahora otra, los números no</translation>
    </message>
    <message>
      <source>Not as this bag&apos;s sherds are numbered: %1. Type them anew (N, or later in the catalogue), or say that they are right.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No son como se numeran los fragmentos de esta bolsa: %1. Escríbalos de nuevo (N, o más tarde en el catálogo), o diga que son correctos.</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Next step</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Siguiente paso</translation>
    </message>
    <message>
      <source>Stop turntable</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detener la mesa giratoria</translation>
    </message>
    <message>
      <source>Change rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cambiar de equipo…</translation>
    </message>
    <message>
      <source>Loading picture…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cargando la imagen…</translation>
    </message>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Compruebe esto primero</translation>
    </message>
    <message>
      <source>Type how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escribir cuántos fragmentos hay</translation>
    </message>
    <message>
      <source>Import cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importación cancelada; no ha quedado nada.</translation>
    </message>
    <message>
      <source>Import anyway</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importarlos de todos modos</translation>
    </message>
    <message>
      <source>Photograph this side again?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Fotografiar este lado otra vez?</translation>
    </message>
    <message>
      <source>Keep these numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Conservar estos números</translation>
    </message>
    <message>
        <source>%1 The rig that worked before stays in use.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 El equipo anterior sigue en uso.</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parar</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Conservar las fotos</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, %2 %</translation>
    </message>
    <message>
      <source>%1 already has these files, so nothing was imported. If you import them anyway, its sherds appear twice in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ya tiene estos archivos, así que no se importó nada. Si los importa de todos modos, sus fragmentos aparecen dos veces en el catálogo.</translation>
    </message>
    <message>
      <source>%1 already has %2 of these %3 files, so nothing was imported. If you import them anyway, the catalogue holds the sherds of both batches; if you do not want that, set %1 aside in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ya tiene %2 de estos %3 archivos, así que no se importó nada. Si los importa de todos modos, el catálogo contiene los fragmentos de ambas tandas; si no lo desea, aparte %1 en la cola.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>The label beside the backs names %1, but the fronts are of %2: check that these are the same sherds, or correct the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La etiqueta junto a los reversos indica %1, pero los anversos son de %2: compruebe que son los mismos fragmentos o corrija la bolsa.</translation>
    </message>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abriendo el equipo</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pulse el disparador de la cámara %1.</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay equipo</translation>
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
    <message>
      <source>This camera has no live view.</source>
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
      <source>You counted %1 sherds, the photographs show %2: look for one that is hidden, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ha contado %1 fragmentos, las fotos muestran %2: busque uno que esté oculto, toque a otro o no se haya colocado.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ha contado %1</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se interrumpió en mitad de este lado.</translation>
    </message>
    <message>
      <source>%1 is photographed whole, but nobody said that it is right: look at its photographs, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está fotografiada entera, pero nadie ha dicho que sea correcta: mire sus fotos y siga.</translation>
    </message>
    <message>
      <source>To be photographed again: %1. Lay them down with others, and type their numbers (N) when the fronts are shot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Por fotografiar de nuevo: %1. Colóquelos con otros y escriba sus números (N) cuando estén tomados los anversos.</translation>
    </message>
    <message>
      <source>Labels of several bags are in sight: %1. Leave the one of these sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se ven etiquetas de varias bolsas: %1. Deje solo la de estos fragmentos.</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: check whether one is in fragments or an object is not a sherd, or correct the count.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ha contado %1 fragmentos, las fotos muestran %2: mire si alguno está en trozos o si hay algo que no es un fragmento, o corrija el número.</translation>
    </message>
    <message>
        <source>The rig does not open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El equipo no se abre</translation>
    </message>
    <message>
        <source>Taking calibration photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tomando fotos de calibración</translation>
    </message>
    <message>
        <source>The virtual rig turns the sherds over</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El equipo virtual da la vuelta a los fragmentos</translation>
    </message>
    <message>
        <source>Nothing to do by hand: shoot the backs.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Nada que hacer a mano: fotografíe los reversos.</translation>
    </message>
    <message>
        <source>Resume at position %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reanudar en la posición %1</translation>
    </message>
    <message>
        <source>Shoot the backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotografiar los reversos</translation>
    </message>
    <message>
        <source>Calibration photograph %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Foto de calibración %1 de %2</translation>
    </message>
    <message>
        <source>Position %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Posición %1 de %2</translation>
    </message>
    <message>
        <source>Opening the rig…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abriendo el equipo</translation>
    </message>
    <message>
        <source>Lighting OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Iluminación correcta</translation>
    </message>
    <message>
      <source>%1 resumes where it stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sigue donde estaba.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>La fotografía ya tomada de este lado está guardada.</numerusform>
        <numerusform>Las %n fotografías ya tomadas de este lado están guardadas.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at position %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1 en la posición %2: %3</translation>
    </message>
    <message>
      <source>Check the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mire el plato antes de despejarlo</translation>
    </message>
    <message>
      <source>Fronts up, two centimetres apart, the markers at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anverso arriba, dos centímetros de separación, las marcas del borde libres.</translation>
    </message>
    <message>
      <source>Hands off the turntable. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Manos fuera de la mesa giratoria. Esc la detiene al instante.</translation>
    </message>
    <message>
      <source>Space accepts anyway, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Espacio continúa igualmente, R fotografía otra vez los reversos.</translation>
    </message>
    <message>
      <source>Accept and queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aceptar y poner en cola</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) saved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fotografía guardada</numerusform>
        <numerusform>%n fotografías guardadas</numerusform>
      </translation>
    </message>
    <message>
      <source>Markers %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marcas %1 de %2</translation>
    </message>
    <message>
      <source>Release camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Liberar cámara</translation>
    </message>
    <message>
      <source>Markers %1 of %2, %3 needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marcas %1 de %2, hacen falta %3</translation>
    </message>
    <message>
      <source>Its sherds are in the review (Ctrl+3): check them while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sus fragmentos están en la revisión (Ctrl+3): mire mientras aún están aquí</translation>
    </message>
    <message>
        <source>The turntable stands still. Saved photographs are kept.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>La mesa giratoria está parada. Las fotos guardadas se conservan.</translation>
    </message>
    <message>
      <source>Nothing is wrong with the photographs of this side. Space or Esc keeps them; R once more puts all of them aside and takes new ones.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos de esta cara no tienen ningún problema. Espacio o Esc las conserva; otra vez R las aparta todas y hace otras.</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Conservar las fotos</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deteniéndose…</translation>
    </message>
    <message>
      <source>%1 is processed; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está procesada; la siguiente tanda está a una tecla.</translation>
    </message>
    <message>
      <source>No photograph of this side has been taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se ha tomado ninguna fotografía de este lado.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueScreen</name>
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
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elija los fragmentos que deben recibir número.</translation>
    </message>
    <message>
        <source>No sherds yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aún no hay fragmentos</translation>
    </message>
    <message>
        <source>Sherds appear here when a batch is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Los fragmentos aparecen aquí cuando se procesa una tanda.</translation>
    </message>
    <message>
        <source>No sherds match this filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ningún fragmento cumple este filtro</translation>
    </message>
    <message>
        <source>Remove a condition to see more.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Quite una condición para ver más.</translation>
    </message>
    <message>
        <source>Clear filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Borrar filtro</translation>
    </message>
    <message>
        <source>Model</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Asignar números</translation>
    </message>
    <message>
        <source>A void sherd gets no label, drawing or place on a plate, and its number is never given again. Is %1 void: “%2”?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Un fragmento anulado no recibe etiqueta, dibujo ni lugar en un plato, y su número no se vuelve a dar. ¿Está anulado %1: «%2»?</translation>
    </message>
    <message>
      <source>Import…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar …</translation>
    </message>
    <message>
      <source>Dismiss</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Descartar</translation>
    </message>
    <message>
        <source>Void sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Anular fragmento</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comparar</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it; closing again discards it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aún sin guardar: %1. Intro en el campo guarda; cerrar otra vez descarta.</translation>
    </message>
    <message numerus="yes">
      <source>Export %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Exportar %n fragmento</numerusform>
        <numerusform>Exportar %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Print labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir etiquetas</translation>
    </message>
    <message>
      <source>sherd labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>etiquetas de fragmentos</translation>
    </message>
    <message>
      <source>Only sherds with a number get a label: assign the numbers first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Solo los fragmentos con número reciben etiqueta: asigne antes los números.</translation>
    </message>
    <message>
      <source>Rename places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renombrar lugares</translation>
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
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Si es un borde</translation>
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
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que dice el dibujo</translation>
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
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado: %1</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dibujo va a la impresora; imprímalo al 100 %.</translation>
    </message>
    <message>
      <source>Automatic</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Automático</translation>
    </message>
    <message>
      <source>Rim sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento de borde</translation>
    </message>
    <message>
      <source>No rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sin borde</translation>
    </message>
    <message>
      <source>Save…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar …</translation>
    </message>
    <message>
      <source>Print…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir …</translation>
    </message>
    <message>
      <source>Previous sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La hoja anterior</translation>
    </message>
    <message>
      <source>Next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La hoja siguiente</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelado. No se dibujó nada.</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Dibujando %n fragmento …</numerusform>
        <numerusform>Dibujando %n fragmentos …</numerusform>
      </translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg);;PNG, the views of each sherd (*.png);;TIFF, the views of each sherd (*.tif)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, todas las hojas (*.pdf);;SVG, un archivo por hoja (*.svg);;PNG, las vistas de cada fragmento (*.png);;TIFF, las vistas de cada fragmento (*.tif)</translation>
    </message>
    <message>
      <source>Different</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Distintos</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportModel</name>
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
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay una carpeta con este nombre; elija otro nombre.</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
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
      <source>Counting…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Contando …</translation>
    </message>
    <message>
      <source>No sherds match this selection.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún fragmento cumple esta selección.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelada. No quedó nada a medias.</translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n de ellos sin modelo: %1</numerusform>
        <numerusform>%n de ellos sin modelo: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>The whole project, %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El proyecto completo, %1</translation>
    </message>
    <message numerus="yes">
      <source>%n file(s) of the project are missing, changed or links; damage.txt in the archive lists them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fichero del proyecto falta, ha cambiado o es un enlace; damage.txt lo indica.</numerusform>
        <numerusform>%n ficheros del proyecto faltan, han cambiado o son enlaces; damage.txt los indica.</numerusform>
      </translation>
    </message>
    <message>
        <source>Everything in the project, with checksums. &apos;Restore an archive&apos; on the start screen makes the project from it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Todo lo que hay en el proyecto, con sumas de comprobación. «Restaurar una copia de archivo», en la pantalla de inicio, vuelve a hacer de ella el proyecto.</translation>
    </message>
    <message numerus="yes">
        <source>%n batch(es) in the queue: the archive holds their photographs and the stages that are finished when it is made; the restored project processes the rest.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n tanda en la cola: la copia de archivo contiene sus fotografías y las etapas terminadas hasta entonces; el proyecto restaurado procesa el resto.</numerusform>
            <numerusform>%n tandas en la cola: la copia de archivo contiene sus fotografías y las etapas terminadas hasta entonces; el proyecto restaurado procesa el resto.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportScreen</name>
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
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Filtro de lo que se exporta</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contexto:0012</translation>
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
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance de la exportación</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abrir la carpeta</translation>
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
      <source>How large a GLB may be. PLY and OBJ get the same surface. Larger models get fewer triangles and smaller photographs; how far they are off is measured and stated in each file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tamaño máximo de un GLB. PLY y OBJ reciben la misma superficie. Los modelos mayores tienen menos triángulos y fotografías más pequeñas; su desviación se mide y consta en cada archivo.</translation>
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
    <message>
      <source>The export is not finished, and nothing of it would be kept. Close once more to stop it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La exportación no ha terminado y no quedaría nada de ella. Cierre otra vez para detenerla.</translation>
    </message>
    <message>
        <source>Matching the filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Según el filtro</translation>
    </message>
    <message>
        <source>Formats</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Formatos</translation>
    </message>
    <message>
        <source>Records (JSON), re-importable</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Registros (JSON), reimportables</translation>
    </message>
    <message>
        <source>Full detail</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Detalle completo</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Selected sherds</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fragmentos seleccionados</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir …</translation>
    </message>
    <message>
      <source>Folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta de la exportación</translation>
    </message>
    <message>
      <source>fit to A4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>según A4</translation>
    </message>
    <message>
      <source>for the web, up to 5 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>para la web, hasta 5 MB</translation>
    </message>
    <message>
      <source>for a phone, up to 1 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>para un teléfono, hasta 1 MB</translation>
    </message>
    <message>
      <source>Tables (CSV): English headings, decimal points</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablas (CSV): encabezados en inglés, punto decimal</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablas (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>The whole project, as an archive</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El proyecto completo, como archivo de conservación</translation>
    </message>
    <message>
      <source>Surfaces in the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Superficies en los dibujos</translation>
    </message>
    <message numerus="yes">
      <source>%n selected sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento seleccionado</numerusform>
        <numerusform>%n fragmentos seleccionados</numerusform>
      </translation>
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
      <translation>rim T3 grosor&gt;6</translation>
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
      <source>Remove the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Quitar la condición %1</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, entered&gt;=2026-07-01, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las palabras se buscan en todas partes; también sirven ware:grey, grosor&gt;6, registrado&gt;=2026-07-01, -burnt, nota:*.</translation>
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
        <source>Idle</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Inactivo</translation>
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
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El manual solo está en inglés.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: the program uses no network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nada sale de este ordenador: no hay red en él.</translation>
    </message>
    <message>
      <source>Search the manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buscar en el manual</translation>
    </message>
    <message>
      <source>The manual does not mention &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El manual no menciona «%1».</translation>
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
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importar al catálogo</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Crear los yacimientos, cortes, contextos y bolsas que aún no existen</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance de la importación</translation>
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
      <source>Keep the other versions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar las otras versiones</translation>
    </message>
    <message>
        <source>to confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>por confirmar</translation>
    </message>
    <message>
        <source>Rows</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Filas</translation>
    </message>
    <message>
        <source>Columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Columnas</translation>
    </message>
    <message numerus="yes">
        <source>Columns (%n to check)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Columnas (%n por comprobar)</numerusform>
            <numerusform>Columnas (%n por comprobar)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Confirm %n row(s)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Confirmar %n fila</numerusform>
            <numerusform>Confirmar %n filas</numerusform>
        </translation>
    </message>
    <message>
      <source>updated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>actualizado</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rechazado</translation>
    </message>
    <message>
      <source>unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sin cambios</translation>
    </message>
    <message>
      <source>Table (CSV)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una tabla (CSV) …</translation>
    </message>
    <message>
      <source>Export folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una carpeta de exportación …</translation>
    </message>
    <message>
      <source>Effect of each row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que haría cada fila</translation>
    </message>
    <message>
      <source>Save rejected rows…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar filas rechazadas …</translation>
    </message>
    <message>
      <source>Save rejected rows</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardar filas rechazadas</translation>
    </message>
    <message>
      <source>rejected.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rechazados.csv</translation>
    </message>
    <message>
      <source>Line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>línea</translation>
    </message>
    <message>
      <source>Action</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Acción</translation>
    </message>
    <message>
      <source>Reason</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Motivo</translation>
    </message>
    <message>
      <source>Reading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leyendo …</translation>
    </message>
    <message>
      <source>Imported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importado: %1</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelar</translation>
    </message>
    <message numerus="yes">
      <source>Import %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Importar %n fila</numerusform>
        <numerusform>Importar %n filas</numerusform>
      </translation>
    </message>
    <message>
      <source>Another project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro proyecto …</translation>
    </message>
    <message>
        <source>A table of sherds has a column with their numbers; one of contexts has a column with theirs. Their names may be in any of the program's languages.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Una tabla de fragmentos tiene una columna con sus números; una de contextos tiene una columna con los suyos. Los nombres pueden estar en cualquiera de los idiomas del programa.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 «%2»: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n fila debe confirmarse.</numerusform>
            <numerusform>%n filas deben confirmarse.</numerusform>
        </translation>
    </message>
    <message>
      <source>%1 new, %2 updated, %3 unchanged, %4 rejected.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 nuevos, %2 actualizados, %3 sin cambios, %4 rechazados.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelado. No se importó nada.</translation>
    </message>
    <message numerus="yes">
      <source>Cancelled: %n row(s) were not imported. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Cancelado: %n fila no se ha importado. Importe la tabla otra vez para el resto.</numerusform>
        <numerusform>Cancelado: %n filas no se han importado. Importe la tabla otra vez para el resto.</numerusform>
      </translation>
    </message>
    <message>
      <source>Undo does not take back contexts and bags; the catalogue is backed up before the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deshacer no retira contextos ni bolsas; antes de la importación se hace una copia de seguridad del catálogo.</translation>
    </message>
    <message>
      <source>Undo does not take back new sherds; each can be voided in its details.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deshacer no retira los fragmentos nuevos; cada uno puede anularse en sus detalles.</translation>
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
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En todas partes</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se está deteniendo el cálculo; continúa cuando el proyecto se abra otra vez. La ventana se cierra en un momento.</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deshacer: %1</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudo copiar el catálogo: %1</translation>
    </message>
    <message>
        <source>%1 is ready.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 está listo.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Rehacer: %1</translation>
    </message>
    <message>
      <source>Queue: editing masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cola: editar máscaras</translation>
    </message>
    <message>
      <source>%1 (read-only)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (solo lectura)</translation>
    </message>
    <message>
      <source>%1 is being processed. Leaving the project stops it, and it continues when the project is opened again. Choose Projects once more to leave.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se está procesando. Al salir del proyecto se detiene y continúa cuando el proyecto se abre de nuevo. Elija Proyectos otra vez para salir.</translation>
    </message>
    <message>
      <source>Import cancelled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importación cancelada</translation>
    </message>
    <message>
      <source>The project that was created for it is removed. Your photographs are as they were.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El proyecto creado para ella se ha eliminado. Sus fotografías están como estaban.</translation>
    </message>
    <message>
        <source>Restoring cancelled</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Restauración cancelada</translation>
    </message>
    <message>
        <source>Nothing was left behind.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>No ha quedado nada.</translation>
    </message>
    <message>
        <source>The project is restored.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El proyecto está restaurado.</translation>
    </message>
    <message>
        <source>It was archived with damage:</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Se archivó con daños:</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapScreen</name>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imprimir plano y etiquetas</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento %1</translation>
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
    <message>
        <source>No map yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aún no hay plano</translation>
    </message>
    <message>
      <source>The map is still loading.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El plano aún se está cargando.</translation>
    </message>
    <message>
        <source>The map of a batch appears here once it is processed, and shows which sherd lay where.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El plano de una tanda aparece aquí cuando se ha procesado y muestra dónde estaba cada fragmento.</translation>
    </message>
    <message>
      <source>%1 map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 plano y etiquetas</translation>
    </message>
    <message>
      <source>bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>etiquetas de bolsa</translation>
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
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cargando…</translation>
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
        <source>Dismiss</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aceptar</translation>
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
      <source>No model yet: it comes when the batch of the sherd is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aún no hay modelo: llega cuando se procesa la tanda del fragmento.</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the model cannot be turned.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta pantalla no tiene OpenGL 3.2; el modelo no se puede girar.</translation>
    </message>
    <message>
      <source>No model: the sherd belongs to no batch of photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay modelo: el fragmento no pertenece a ninguna tanda de fotografías.</translation>
    </message>
    <message>
      <source>Large view</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vista grande</translation>
    </message>
    <message>
      <source>The model alone, as large as the page; again or Esc: beside the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Solo el modelo, tan grande como la página; otra vez o Esc: junto a la tabla</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site&apos;s code has two to eight letters from A to Z and digits, without accents, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El código del yacimiento tiene de dos a ocho mayúsculas de la A a la Z y cifras, sin acentos, como ARM1.</translation>
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
    <message>
        <source>Photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotografías</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::OutlinePlot</name>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Outlines overlaid, and their turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Contornos superpuestos, y sus ángulos de giro</translation>
    </message>
    <message>
      <source>Outlines overlaid</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>contornos superpuestos</translation>
    </message>
    <message>
      <source>Turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ángulos de giro</translation>
    </message>
    <message>
      <source>The lines of a pair lie on each other.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En un par, las líneas coinciden.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CardInHand</name>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay reverso elegido.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>elección de %1</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>punto inicial</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>giro a mano</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un reverso solo no tiene modelo cerrado.</translation>
    </message>
    <message>
      <source>Cancelled. The back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido; el reverso queda donde estaba.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que solo se probó ya no existe: sus parejas se cerraron desde entonces.</translation>
    </message>
    <message>
      <source>The fractures do not touch here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fracturas no se tocan aquí.</translation>
    </message>
    <message>
      <source>Fractures %1 apart, %2 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fracturas separadas %1, se toca el %2.</translation>
    </message>
    <message>
      <source>Turned by hand; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girado a mano; B afina el ajuste.</translation>
    </message>
    <message>
      <source>Start point %1; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Punto inicial %1; B afina el ajuste.</translation>
    </message>
    <message>
      <source>refining the fit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ajuste por las fracturas</translation>
    </message>
    <message>
      <source>This pair has no closed model yet. Reprocess the batch to make it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta pareja aún no tiene modelo cerrado. Reprocese la tanda para crearlo.</translation>
    </message>
    <message>
      <source>This back has no partner.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este reverso no tiene pareja.</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cargando…</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CardListModel</name>
    <message>
      <source>%1, %2. %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2. %3</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PairReview</name>
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
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay pareja elegida: dé primero este reverso a un anverso.</translation>
    </message>
    <message>
        <source>reshooting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>nueva fotografía de %1</translation>
    </message>
    <message>
        <source>merging %1 and %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>unión de %1 y %2</translation>
    </message>
    <message>
        <source>splitting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>división de %1</translation>
    </message>
    <message>
      <source>One of the two has no back to merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Uno de los dos no tiene reverso que unir.</translation>
    </message>
    <message>
      <source>A pair can be decided once it is shown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se puede decidir sobre una pareja en cuanto se muestra.</translation>
    </message>
    <message>
      <source>All pairs of this batch are decided.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todos los pares de este lote están decididos.</translation>
    </message>
    <message>
      <source>Saved. Check %1 – %2: only %3 of their fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Compruebe %1 – %2: solo el %3 de sus fracturas se toca.</translation>
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
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cargando…</translation>
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
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yacimiento, corte, contexto y bolsa</translation>
    </message>
    <message>
      <source>New: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nuevo: %1</translation>
    </message>
    <message>
      <source>scan its label, or %1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>escanee su etiqueta, o %1-T3-0012-4</translation>
    </message>
    <message>
      <source>Write the bag as site-trench-context-bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba la bolsa como yacimiento-corte-contexto-bolsa.</translation>
    </message>
    <message>
      <source>No bag: the sherds can be numbered once the catalogue gives them a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sin bolsa: los fragmentos se podrán numerar cuando el catálogo les dé un contexto.</translation>
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
    <name>ostraka::ui::QueueScreen</name>
    <message>
      <source>This batch has no masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda no tiene máscaras.</translation>
    </message>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pausa</translation>
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
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 aún no tiene informe.</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Primero borradores</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cámara recibió un golpe: las fotos de esta tanda dicen dónde están ahora las cámaras (C)</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reprocesar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mostrar informe</translation>
    </message>
    <message>
        <source>Review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Revisar</translation>
    </message>
    <message>
        <source>Edit masks</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Editar máscaras</translation>
    </message>
    <message>
        <source>Open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Processes each new batch quickly and coarsely, for a check while the sherds are still on the plate; reprocessing makes it final (D)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Procesa cada tanda nueva de forma rápida y tosca, para comprobarla mientras los fragmentos siguen en el plato; reprocesarla la hace definitiva (D)</translation>
    </message>
    <message>
        <source>Recalibrate rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Recalibrar equipo</translation>
    </message>
    <message>
        <source>What you photograph or import is processed here, one batch after the other, while you go on working.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Lo que fotografíe o importe se procesa aquí, una tanda tras otra, mientras sigue trabajando.</translation>
    </message>
    <message>
        <source>Batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tanda</translation>
    </message>
    <message>
        <source>Resume</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reanudar</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Apartar</translation>
    </message>
    <message>
        <source>Cancel %1?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>¿Cancelar %1?</translation>
    </message>
    <message>
        <source>It has been processing for more than an hour. Finished stages are saved; the current one is lost.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Lleva más de una hora procesándose. Las etapas terminadas están guardadas; la actual se pierde.</translation>
    </message>
    <message>
        <source>Cancel it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Cancelarla</translation>
    </message>
    <message>
        <source>Keep processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Seguir procesando</translation>
    </message>
    <message>
      <source>Marker side…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lado del marcador…</translation>
    </message>
    <message>
      <source>Keep both</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Conservar ambas</translation>
    </message>
    <message>
      <source>Processes this batch although another one has the same photographs; the sherds of both are then in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Procesa esta tanda aunque otra tenga las mismas fotografías; los fragmentos de ambas están entonces en el catálogo</translation>
    </message>
    <message>
      <source>The report of %1 is not opened: this version of Ostraka did not write it, and it may run scripts. Reprocess the batch to write it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El informe de %1 no se abre: esta versión de Ostraka no lo escribió y podría ejecutar scripts. Vuelva a procesar la tanda para escribirlo de nuevo.</translation>
    </message>
    <message>
        <source>The queue is paused: this project was restored from an archive.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>La cola está en pausa: este proyecto se restauró de una copia de archivo.</translation>
    </message>
    <message>
        <source>Its batches that are not processed yet wait until you resume it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Las tandas aún sin procesar esperan hasta que la reanude.</translation>
    </message>
    <message>
        <source>Photographs are being imported; their batch appears here when all of them are copied.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Se están importando fotografías; su tanda aparece aquí cuando todas están copiadas.</translation>
    </message>
    <message>
        <source>Show the import</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mostrar la importación</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::Sidebar</name>
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
    <message>
      <source>Screens</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pantallas</translation>
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
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelo</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apartar</translation>
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
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Haga clic en un extremo de la longitud sobre el fragmento y luego en el otro. D termina.</translation>
    </message>
    <message>
        <source>Accept</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Leave merging and splitting</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Salir de unir y dividir</translation>
    </message>
    <message>
        <source>Refine fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Afinar ajuste</translation>
    </message>
    <message>
        <source>Refine the position by the fracture surfaces (B)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Afinar la posición por las fracturas (B)</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Volver a fotografiar</translation>
    </message>
    <message>
        <source>View</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Decide</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Decidir</translation>
    </message>
    <message>
        <source>Explode</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Separar</translation>
    </message>
    <message>
        <source>Fracture gap</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Separación de fractura</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dividir</translation>
    </message>
    <message>
        <source>Split a scan of two sherds along a line over its photograph (K)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dividir un escaneo de dos fragmentos por una línea sobre su foto (K)</translation>
    </message>
    <message>
        <source>Merge</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Unir</translation>
    </message>
    <message>
        <source>Merge two fragments of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Unir dos trozos de un fragmento: elija luego la otra tarjeta (J anversos, Mayús+J reversos)</translation>
    </message>
    <message>
        <source>Merge backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Unir reversos</translation>
    </message>
    <message>
      <source>Comparing the fractures… Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comparando las fracturas … Esc detiene.</translation>
    </message>
    <message>
      <source>Refining the fit, fracture gap %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ajuste en curso, separación de las fracturas %1. Esc detiene.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ReviewScreen</name>
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
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Revisión</translation>
    </message>
    <message>
        <source>Update changed models</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Actualizar modelos cambiados</translation>
    </message>
    <message>
        <source>Reprocesses the pairs that were decided differently</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reprocesa las parejas decididas de otro modo</translation>
    </message>
    <message>
        <source>No pairs to review yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aún no hay parejas que revisar</translation>
    </message>
    <message>
        <source>Photograph or import a batch. Its pairs appear here when it is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotografíe o importe una tanda. Sus parejas aparecen aquí cuando se procese.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mostrar informe</translation>
    </message>
    <message>
        <source>%1 was reshot as %2 in %3 and now has two records. Void one of them in the catalogue, or set the fragment aside here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 se volvió a fotografiar como %2 en %3 y ahora tiene dos registros. Anule uno en el catálogo o aparte aquí el trozo.</translation>
    </message>
    <message>
      <source>%1 is queued; only what changed is reprocessed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está en cola; solo se reprocesa lo que cambió.</translation>
    </message>
    <message>
      <source>Saved. Pairs of the new fragments appear after reprocessing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Las parejas de los trozos nuevos aparecen al reprocesar.</translation>
    </message>
    <message>
      <source>Undone. The history keeps both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deshecho. Ambos quedan en el historial.</translation>
    </message>
    <message>
      <source>No pairs to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay parejas que revisar</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n pareja por revisar</numerusform>
        <numerusform>%n parejas por revisar</numerusform>
      </translation>
    </message>
    <message>
      <source>No measurement of %1 is certain. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguna de las medidas de %1 es segura. %2</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd has no number, and %1 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Tras el reprocesado, el fragmento unido no tendrá número y %1 no tendrá trozo. Deshacer los separa de nuevo.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd keeps the number %1, and %2 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Tras el reprocesado, el fragmento unido conserva el número %1 y %2 no tiene trozo. Deshacer los separa de nuevo.</translation>
    </message>
    <message>
      <source>%1 has no scale: no length shown here is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 no tiene escala: ninguna longitud mostrada aquí está en milímetros.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, number %1 goes to the half that it was typed on, or else to the larger one. Undo merges them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Tras el reprocesado, el número %1 pasa a la mitad en la que se escribió o, si no, a la mayor. Deshacer las vuelve a unir.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: the sherds in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Todos los pares de %1 están decididos. Lo siguiente: los fragmentos en el catálogo.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: update the changed models.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado. Todos los pares de %1 están decididos. Lo siguiente: actualizar los modelos cambiados.</translation>
    </message>
    <message>
      <source>Saved, with your initials.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado, con sus iniciales.</translation>
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
    <message>
        <source>Keep current rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mantener el equipo actual</translation>
    </message>
    <message>
      <source>Import photographs taken by hand, or choose a rig file (RIG.json), which names your cameras and your turntable. The virtual rig is for practice: its sherds are invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importe fotografías hechas a mano o elija un archivo de equipo (RIG.json), que nombra sus cámaras y su plataforma giratoria. El equipo virtual es para practicar: sus fragmentos son inventados.</translation>
    </message>
    <message>
      <source>No rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún equipo</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelar</translation>
    </message>
    <message>
      <source>Use the virtual rig in this project?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Usar el equipo virtual en este proyecto?</translation>
    </message>
    <message>
      <source>It is for practice: its sherds are invented, and they enter this project's catalogue. The queue marks its batches as invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es para practicar: sus fragmentos son inventados y entran en el catálogo de este proyecto. La cola marca sus lotes como inventados.</translation>
    </message>
    <message>
        <source>Importing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Importación en curso</translation>
    </message>
    <message>
        <source>The batch goes into the queue when all of its files are copied. Meanwhile you can choose a rig.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>La tanda pasa a la cola cuando todos sus archivos están copiados. Mientras tanto puede elegir un equipo.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectEdit</name>
    <message>
      <source>As photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Como en las fotografías</translation>
    </message>
    <message>
      <source>Without the light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sin la luz</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Proyecto abierto</translation>
    </message>
    <message>
      <source>Na&amp;me</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No&amp;mbre</translation>
    </message>
    <message>
      <source>Site &amp;code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Código del yacimiento</translation>
    </message>
    <message>
      <source>Textures of new mo&amp;dels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>T&amp;exturas de los modelos nuevos</translation>
    </message>
    <message>
      <source>rename the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiar el nombre del proyecto</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado.</translation>
    </message>
    <message>
      <source>change the textures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiar las texturas</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::RightsEdit</name>
    <message>
      <source>Rights to the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Derechos sobre el proyecto abierto</translation>
    </message>
    <message>
      <source>for instance CC-BY-4.0; empty: none is named</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>por ejemplo CC-BY-4.0; vacío: no se nombra ninguna</translation>
    </message>
    <message>
      <source>&amp;Licence of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Licencia de lo exportado</translation>
    </message>
    <message>
      <source>Who &amp;holds the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Quién tiene los &amp;derechos</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado.</translation>
    </message>
    <message>
      <source>change the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiar los derechos</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SettingsPage</name>
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
        <source>Follow system</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Según el sistema</translation>
    </message>
    <message>
        <source>Recorded with each decision.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Se anotan con cada decisión.</translation>
    </message>
    <message>
        <source>Takes effect after restart.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Se aplica al reiniciar.</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Volver (Esc)</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reiniciar ahora</translation>
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
      <source>7 is the running number in the sherd&apos;s context; =7 is the number 7 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7 es el número correlativo en el contexto del fragmento; =7 es el propio número 7.</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Confirmar</translation>
    </message>
    <message>
        <source>computed; replaced by the measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>calculado; sustituido por el valor medido</translation>
    </message>
    <message>
      <source>Assign number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dar el número %1</translation>
    </message>
    <message>
      <source>Numbering…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numeración…</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fotografía</translation>
    </message>
    <message>
      <source>mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>máscara</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>escaneo</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>modelo</translation>
    </message>
    <message>
      <source>picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>imagen</translation>
    </message>
    <message>
      <source>drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dibujo</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>informe</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>escala</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aún no guardado: %1. Intro en el campo lo guarda.</translation>
    </message>
    <message>
      <source>-0599/-0549: 600 to 550 BC</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>-0599/-0549: 600 a 550 a. C.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdEdits</name>
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
    <message numerus="yes">
      <source>%n sherd(s) got no number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento no recibió número: %1</numerusform>
        <numerusform>%n fragmentos no recibieron número: %1</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>numbering of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>numerar %n fragmento</numerusform>
        <numerusform>numerar %n fragmentos</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Detenido; no cambió nada.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdTableModel</name>
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
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, dudoso</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: la escala de la tanda %2 es dudosa; su informe dice por qué y qué hacer.</translation>
    </message>
    <message>
        <source>%1: measured by hand; the computed value is kept beside it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: medido a mano; el valor calculado se conserva al lado.</translation>
    </message>
    <message>
        <source>%1: %2, measured by hand</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: %2, medido a mano</translation>
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
      <source>%1
%2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2, %3</translation>
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
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>¿Dónde está %1 ahora?</translation>
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
        <source>Create project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Crear proyecto</translation>
    </message>
    <message>
        <source>Example</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ejemplo</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Repair the catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reparar el catálogo</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abrir el proyecto</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2 no está: búsquelo …</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Intro</translation>
    </message>
    <message>
        <source>No project yet. Import photographs of both sides of your sherds, or drop their folders here: a project is created for them. To practise, try the virtual rig: it breaks a pot and photographs its sherds for you.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Todavía no hay ningún proyecto. Importe fotografías de las dos caras de sus fragmentos o suelte aquí sus carpetas: se crea un proyecto para ellas. Para practicar, pruebe el equipo virtual: rompe una vasija y fotografía sus fragmentos.</translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Importar fotografías…</translation>
    </message>
    <message>
        <source>Creates a project named after their folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Crea un proyecto con el nombre de su carpeta</translation>
    </message>
    <message>
        <source>Folder of the photographs: both sides, or a folder for each side within it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Carpeta de las fotografías: las dos caras, o una carpeta para cada cara</translation>
    </message>
    <message>
        <source>&amp;Restore an archive…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>&amp;Restaurar una copia de archivo…</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Restaurar…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Restoring the project to %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Se restaura el proyecto en %1</translation>
    </message>
    <message>
        <source>Folder of the archive</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Carpeta de la copia de archivo</translation>
    </message>
    <message>
        <source>Where to put the project: an empty folder, or one for a new folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dónde poner el proyecto: una carpeta vacía, o una para una carpeta nueva</translation>
    </message>
    <message>
      <source>&amp;Open from folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Abrir desde una carpeta…</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abrir proyecto</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n batch(es) unfinished</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; %n tanda sin terminar</numerusform>
        <numerusform>%1; %n tandas sin terminar</numerusform>
      </translation>
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
      <source>%1 of %2 positions done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de %2 posiciones hechas</translation>
    </message>
    <message>
      <source>%1 of %2 calibration photographs taken</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de %2 fotos de calibración hechas</translation>
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
        <source>Front</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Anverso</translation>
    </message>
    <message>
        <source>Back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reverso</translation>
    </message>
    <message>
        <source>No scale: lengths are not known</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sin escala: no se conocen las longitudes</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>sin contacto</translation>
    </message>
    <message>
        <source>filled in, not seen by a camera</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>rellenado, no visto por ninguna cámara</translation>
    </message>
    <message>
        <source>Distance between the sides along the fracture</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Distancia entre los lados a lo largo de la fractura</translation>
    </message>
    <message>
        <source>front outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>anverso por fuera %1</translation>
    </message>
    <message>
        <source>back outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>reverso por fuera %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, the whole number, or scan its label</source>
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
    <message>
      <source>Sherd %1 got no number. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El fragmento %1 no recibió número. %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskModel</name>
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
    <message>
      <source>%1, camera %2, position %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, cámara %2, posición %3</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Máscaras de %1</translation>
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
        <source>Previous photograph</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Foto anterior</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Reprocesar</translation>
    </message>
    <message>
        <source>Brush</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Loading photograph…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Cargando la foto…</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) edited. Reprocess to update what follows from them.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n foto editada. Reprocese para actualizar lo que sigue.</numerusform>
            <numerusform>%n fotos editadas. Reprocese para actualizar lo que sigue.</numerusform>
        </translation>
    </message>
    <message>
        <source>Blue: classified as sherd. Paint missing parts as sherd and wrong ones as plate; the program&apos;s own masks stay.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Azul: clasificado como fragmento. Pinte lo que falta como fragmento y lo erróneo como plato; las máscaras del programa quedan.</translation>
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
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>a</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, y {n} una vez; {n:04} tiene al menos cuatro cifras</translation>
    </message>
    <message>
      <source>Example</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ejemplo</translation>
    </message>
    <message>
      <source>Use this &amp;numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Usar esta &amp;numeración</translation>
    </message>
    <message>
      <source>Skipped numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Números omitidos</translation>
    </message>
    <message>
      <source>none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ninguno</translation>
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
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Guardado.</translation>
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
      <source>&amp;Save vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Guardar vocabulario</translation>
    </message>
    <message>
      <source>&amp;One per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un&amp;o por línea</translation>
    </message>
    <message>
      <source>Project vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vocabulario del proyecto</translation>
    </message>
    <message>
      <source>Terms, one per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Términos, uno por línea</translation>
    </message>
    <message>
      <source>change the vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cambiar el vocabulario</translation>
    </message>
    <message>
      <source>These terms are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos términos aún no están guardados.</translation>
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
    <message>
      <source>Sherd %1: %2 is not as this bag's sherds are numbered (%3). If that is no slip, go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento %1: %2 no es como se numeran los fragmentos de esta bolsa (%3). Si no es un descuido, siga.</translation>
    </message>
</context>
<context>
    <name>ostraka::Error</name>
    <message>
      <source>The disk has only %1 MB left, and a batch needs more. Nothing is lost: free some space, then resume.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En el disco solo quedan %1 MB; una tanda necesita más. No se ha perdido nada: haga sitio y continúe.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but there is no sherd with a context in that place; assign it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: este número se escribió sobre el plato, pero allí no hay ningún fragmento con contexto; asígnelo en el catálogo.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but it belongs to another sherd; check which of the two bears it, and give the other one a new number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: este número se escribió en el plato, pero es de otro fragmento; mire cuál de los dos lo lleva y dé al otro uno nuevo.</translation>
    </message>
    <message>
      <source>Pairs were decided or masks edited while the batch was being processed; reprocess it to apply them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mientras se procesaba la tanda se decidieron parejas o se editaron máscaras; reprocésela para tenerlas en cuenta.</translation>
    </message>
    <message>
      <source>Sherds counted on the plate: %1, but another number was found; check the map for a sherd that is missing or was split in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos contados sobre el plato: %1. Se encontró otro número; busque en el plano el que falta o está partido en dos.</translation>
    </message>
    <message>
      <source>Cancelled.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelado.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no está conectada o no está encendida.</translation>
    </message>
    <message>
      <source>The camera does not answer and may be asleep. Turn off its automatic power-off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no responde y puede estar en reposo. Desactive su apagado automático.</translation>
    </message>
    <message>
      <source>The camera remains busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara sigue ocupada; apáguela y enciéndala.</translation>
    </message>
    <message>
      <source>The connection to the camera failed; check its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falló la conexión con la cámara; revise su cable.</translation>
    </message>
    <message>
      <source>Another program uses the camera, often the desktop&apos;s file manager; &apos;ostraka devices&apos; names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa usa la cámara, a menudo el gestor de archivos; 'ostraka devices' lo nombra.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; check this user&apos;s permissions with &apos;ostraka devices&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no se puede abrir; revise los permisos de este usuario con 'ostraka devices'.</translation>
    </message>
    <message>
      <source>The camera sent no photograph; check that it is focused and set to manual.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No llegó ninguna foto de la cámara; compruebe que está enfocada y en modo manual.</translation>
    </message>
    <message>
      <source>The camera does not stop sending photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no deja de entregar fotos.</translation>
    </message>
    <message>
      <source>This camera has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta cámara no muestra imagen en directo.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; check that nothing blocks it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no alcanza su ángulo; compruebe que nada la bloquea.</translation>
    </message>
    <message>
      <source>The turntable was paused with its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria se pausó con su propio botón.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se conoce la posición de la mesa giratoria: llévela a cero o alinéela.</translation>
    </message>
    <message>
      <source>The turntable does not answer on the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no responde en la red.</translation>
    </message>
    <message>
      <source>The controller restarted; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El controlador se reinició; no se conoce la posición de la mesa giratoria.</translation>
    </message>
    <message>
      <source>A reply from the turntable was lost, and it cannot report its position: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se perdió una respuesta de la mesa giratoria, y no puede comunicar su posición: llévela a cero o alinéela.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no responde como un controlador GRBL; compruebe que está encendida y es de este tipo.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no responde como una ComXim; compruebe que está encendida y es de este tipo.</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB no funciona en este ordenador.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco está lleno; libere espacio e inténtelo otra vez.</translation>
    </message>
    <message>
      <source>The disk is full; free some space, then try again. No data was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco está lleno; haga sitio e inténtelo otra vez. No se perdió nada.</translation>
    </message>
    <message>
      <source>Another program is using the catalogue; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa está usando el catálogo; ciérrelo e inténtelo otra vez.</translation>
    </message>
    <message>
      <source>Another program is repairing or using the catalogue; this one waits up to 10 seconds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa está reparando o usando el catálogo; este espera hasta 10 segundos.</translation>
    </message>
    <message>
      <source>The image file is truncated; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen está cortada antes de su final; cópiela otra vez de la cámara.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a kind of context; use layer, cut, fill, structure, surface or unstratified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» no es un tipo de contexto; puede ser layer, cut, fill, structure, surface o unstratified.</translation>
    </message>
    <message>
      <source>New sites and trenches: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yacimientos y cortes nuevos: %1; compruebe que no haya erratas.</translation>
    </message>
    <message>
      <source>The results of this batch no longer exist; reprocess it, then decide.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los resultados de esta tanda ya no están; reprocésela y decida después.</translation>
    </message>
    <message>
      <source>Camera %1: its photographs come from different cameras (%2); give each camera its own name, because photographs with the same camera name share one lens calibration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: sus fotos proceden de cámaras distintas (%2); dé a cada cámara su propio nombre, pues las fotos con el mismo nombre de cámara comparten una calibración del objetivo.</translation>
    </message>
    <message>
      <source>Camera %1: its focal length varies between photographs (%2); all share one lens calibration, so fix the zoom and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: su distancia focal no es la misma en todas las fotos (%2); todas comparten una calibración del objetivo, así que fije el zoom y vuelva a fotografiar.</translation>
    </message>
    <message>
      <source>Camera %1: its aperture varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: su apertura no es la misma en todas las fotos (%2); ponga la cámara en manual: las fotos desiguales hacen menos seguras las máscaras y los colores.</translation>
    </message>
    <message>
      <source>Camera %1: its exposure time varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: su tiempo de exposición no es el mismo en todas las fotos (%2); ponga la cámara en manual: las fotos desiguales hacen menos seguras las máscaras y los colores.</translation>
    </message>
    <message>
      <source>Camera %1: its sensitivity varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: su sensibilidad no es la misma en todas las fotos (%2); ponga la cámara en manual: las fotos desiguales hacen menos seguras las máscaras y los colores.</translation>
    </message>
    <message>
      <source>Camera %1: its white balance varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: su balance de blancos no es el mismo en todas las fotos (%2); ponga la cámara en manual: las fotos desiguales hacen menos seguras las máscaras y los colores.</translation>
    </message>
    <message>
      <source>No camera model fits the calibration pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún modelo de cámara se ajusta a las imágenes de calibración.</translation>
    </message>
    <message>
      <source>No photograph of this camera shows the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguna foto de esta cámara muestra las marcas del plato.</translation>
    </message>
    <message>
      <source>No batch folder was given.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se indicó ninguna carpeta de tanda.</translation>
    </message>
    <message>
      <source>The angle is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El ángulo no es un número.</translation>
    </message>
    <message>
      <source>This program is not installed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este programa no está instalado.</translation>
    </message>
    <message>
      <source>The photographs show no common object; check the cameras, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos no muestran ningún objeto común; revise las cámaras o dé máscaras.</translation>
    </message>
    <message>
      <source>A visual hull needs at least 3 photographs; photograph the object from more directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una envolvente necesita al menos 3 fotos; fotografíe el objeto desde más direcciones.</translation>
    </message>
    <message>
      <source>The cameras do not view a common area; check their poses.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las cámaras no miran a una zona común; revise sus poses.</translation>
    </message>
    <message>
      <source>The network needs an 8-bit colour photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La red necesita una foto en color de 8 bits.</translation>
    </message>
    <message>
      <source>The drawing needs a scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dibujo necesita una escala.</translation>
    </message>
    <message>
      <source>The preview was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La vista previa se deshizo.</translation>
    </message>
    <message>
      <source>Restoring a project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Restaurar un proyecto necesita una carpeta nueva o vacía; elija otro nombre.</translation>
    </message>
    <message>
      <source>Not an archive of a whole project; import it as an export instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es la copia de archivo de un proyecto entero; impórtela como una exportación.</translation>
    </message>
    <message>
      <source>This is a project already, not an archive of one; open it as it is.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto ya es un proyecto, no una copia de archivo; ábralo tal como está.</translation>
    </message>
    <message>
      <source>This is an archive of a whole project, not an export; restore it (ostraka catalogue restore), then merge the restored project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es la copia de archivo de un proyecto entero, no una exportación; restáurela (ostraka catalogue restore) y una después el proyecto restaurado.</translation>
    </message>
    <message>
      <source>The file or folder cannot be written (%1); choose another location, or check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo o la carpeta no se puede escribir (%1); elija otro lugar o revise sus permisos.</translation>
    </message>
    <message>
      <source>There is no such file; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No existe ese archivo; revise su nombre.</translation>
    </message>
    <message>
      <source>The file cannot be opened (%1); check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo no se puede abrir (%1); revise sus permisos.</translation>
    </message>
    <message>
      <source>The file is larger than the limit of %1 bytes; check that it is the right one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo supera el límite de %1 bytes; compruebe que es el correcto.</translation>
    </message>
    <message>
      <source>The file cannot be read (%1); copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo no se puede leer (%1); cópielo otra vez.</translation>
    </message>
    <message>
      <source>The JSON text is larger than 64 MiB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El texto JSON supera los 64 MiB.</translation>
    </message>
    <message>
      <source>The JSON is nested more than 64 levels deep.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El JSON está anidado en más de 64 niveles.</translation>
    </message>
    <message>
      <source>Not valid JSON (line %1); correct that line, or copy the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es JSON válido (línea %1); corrija esa línea o copie otra vez el archivo.</translation>
    </message>
    <message>
      <source>The JSON contains a number that is too large; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El JSON contiene un número demasiado grande; corríjalo.</translation>
    </message>
    <message>
      <source>A transform must be a 4x4 matrix.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una transformación debe ser una matriz 4x4.</translation>
    </message>
    <message>
      <source>A transform contains a value that is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una transformación contiene algo que no es un número.</translation>
    </message>
    <message>
      <source>A transform is not rigid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una transformación no es rígida.</translation>
    </message>
    <message>
      <source>A transform moves by more than %1 mm; check that its last column is in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una transformación desplaza más de %1 mm; compruebe que su última columna esté en mm.</translation>
    </message>
    <message>
      <source>There is no such folder; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No existe esa carpeta; elija la carpeta de una tanda.</translation>
    </message>
    <message>
      <source>The front side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falta el anverso; ponga sus fotos en la carpeta '%1'.</translation>
    </message>
    <message>
      <source>The back side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falta el reverso; ponga sus fotos en la carpeta '%1'.</translation>
    </message>
    <message>
      <source>Not a batch folder: it has neither the folders &apos;front&apos; and &apos;back&apos; nor &apos;top_images&apos; and &apos;bottom_images&apos;; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es la carpeta de una tanda: no tiene las carpetas 'front' y 'back' ni 'top_images' y 'bottom_images'; elija la carpeta de una tanda.</translation>
    </message>
    <message>
      <source>The file name does not match the form %1; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre del archivo no tiene la forma %1; esta foto se omite.</translation>
    </message>
    <message>
      <source>Another photograph has the same camera and position; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otra foto tiene la misma cámara y la misma posición; esta se omite.</translation>
    </message>
    <message>
      <source>This photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta foto se omite.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1 and %2 more. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Faltan fotos: %1 y %2 más. Las superficies que solo ellas muestran se rellenan; repítalas si importa.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Faltan fotos: %1. Las superficies que solo ellas muestran se rellenan; repítalas si importa.</translation>
    </message>
    <message>
      <source>This file name follows the naming of rig photographs, but most others do not; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este nombre de archivo es el de una foto de equipo, pero la mayoría de los demás no; esta foto se omite.</translation>
    </message>
    <message>
      <source>Another photograph has the same name; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otra foto tiene el mismo nombre; esta se omite.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2 and %3 more); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos de menos de %1 megapíxeles se omiten (%2 y %3 más); copie los originales de la cámara en lugar de las miniaturas.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos de menos de %1 megapíxeles se omiten (%2); copie los originales de la cámara en lugar de las miniaturas.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs are used: the most detailed ones, spread over the series. More would take longer and add little.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se usan %1 de las %2 fotos: las más detalladas, repartidas por la serie. Más tardan más y aportan poco.</translation>
    </message>
    <message>
      <source>This folder contains no photographs; put the photographs of one side into it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En esta carpeta no hay fotos; ponga ahí las fotos de un lado.</translation>
    </message>
    <message>
      <source>This folder contains neither photographs nor the folders &apos;front&apos; and &apos;back&apos; of a batch; choose a folder with photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En esta carpeta no hay ni fotos ni las carpetas «front» y «back» de una tanda; elija una carpeta con fotos.</translation>
    </message>
    <message>
      <source>There is no such folder; choose one with the photographs of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No existe esa carpeta; elija una con las fotos de un lado.</translation>
    </message>
    <message>
      <source>The same folder is given for the front and the back; choose the folder of each side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se indicó la misma carpeta para el anverso y el reverso; elija la carpeta de cada lado.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías utilizables del anverso: %1; hacen falta al menos %2. Haga más desde todas las direcciones.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías utilizables del reverso: %1; hacen falta al menos %2. Haga más desde todas las direcciones.</translation>
    </message>
    <message>
      <source>The HEIC image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen HEIC está dañada; cópiela otra vez.</translation>
    </message>
    <message>
      <source>The RAW image is damaged, or its camera is not supported; copy it again, or export it as TIFF.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen RAW está dañada, o su cámara no es compatible; cópiela otra vez, o expórtela como TIFF.</translation>
    </message>
    <message>
      <source>The side of a marker must be between 0.5 and 1000 mm; measure a black square on the paper.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El lado de una marca debe estar entre 0,5 y 1000 mm; mida un cuadrado negro en el papel.</translation>
    </message>
    <message>
      <source>No sheet with at least %1 markers of OpenCV&apos;s dictionaries was found in these %2 photographs; take photographs that show more of the sheet, or specify its plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En estas %2 fotos no se encontró ninguna hoja con al menos %1 marcas de los diccionarios de OpenCV; tome fotos que muestren más de la hoja, o indique su plate.json.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in the photographs (%4 px) and are used instead. Measure the distance between two markers that are far apart and compare it with plate.json in the output folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún plate.json describe la hoja: se encontraron %1 marcas de %2 con lados de %3 mm en las fotos (%4 px) y se toman por ella. Mida la distancia entre dos marcas alejadas y compárela con plate.json en la carpeta de salida.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 were found in the photographs (%3 px), but their size is unknown, so the result has no scale. Measure the side of a marker&apos;s black square and give it with --marker-mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún plate.json describe la hoja: en las fotografías se encontraron %1 marcas de %2 (%3 px) y no se conoce su tamaño, por lo que el resultado no tiene escala. Mida el lado del cuadrado negro de una marca e indíquelo con --marker-mm.</translation>
    </message>
    <message>
      <source>This mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta máscara no se usa.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size; the mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La máscara no tiene el tamaño de su foto; no se usa.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías utilizables del anverso: %1; hacen falta al menos %2. Añada fotografías con nombres como %3.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías utilizables del reverso: %1; hacen falta al menos %2. Añada fotografías con nombres como %3.</translation>
    </message>
    <message>
      <source>The file name is neither cam&lt;C&gt;_cal&lt;NN&gt;.jpg nor empty_cam&lt;C&gt;.jpg; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre no es cam&lt;C&gt;_cal&lt;NN&gt;.jpg ni empty_cam&lt;C&gt;.jpg; esta imagen se omite.</translation>
    </message>
    <message>
      <source>This picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta imagen se omite.</translation>
    </message>
    <message>
      <source>The image has %1 x %2 pixels, but the photographs from its camera have %3 x %4; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen tiene %1 x %2 píxeles, las fotos de su cámara %3 x %4; esta imagen se omite.</translation>
    </message>
    <message>
      <source>The image header states a size of %1 x %2 pixels, which cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen declara un tamaño de %1 x %2 píxeles, que no se puede usar.</translation>
    </message>
    <message>
      <source>The network&apos;s file is damaged; copy it again, or export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo de la red está dañado; cópielo o expórtelo de nuevo.</translation>
    </message>
    <message>
      <source>A layer of the network has &apos;%1&apos; %2, but only %3 to %4 can be used; use another network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una capa de la red tiene «%1» %2, pero solo se pueden usar valores de %3 a %4; use otra red.</translation>
    </message>
    <message>
      <source>The network&apos;s weights are in another file; export it as one file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los pesos de la red están en otro archivo; expórtela como un solo archivo.</translation>
    </message>
    <message>
      <source>The network takes %1 GB of memory for one photograph, but at most %2 GB can be used; use a smaller network, or one with a smaller input.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La red ocupa %1 GB de memoria para una fotografía, pero se pueden usar como máximo %2 GB; use una red más pequeña o con una entrada más pequeña.</translation>
    </message>
    <message>
      <source>The JPEG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen JPEG está dañada; cópiela otra vez.</translation>
    </message>
    <message>
      <source>The JPEG file contains no image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo JPEG no contiene ninguna imagen.</translation>
    </message>
    <message>
      <source>The PNG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen PNG está dañada; cópiela otra vez.</translation>
    </message>
    <message>
      <source>The TIFF file does not state the image&apos;s size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo TIFF no indica el tamaño de la imagen.</translation>
    </message>
    <message>
      <source>The file is empty; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo está vacío; cópielo otra vez de la cámara.</translation>
    </message>
    <message>
      <source>Not a JPEG, PNG, TIFF, HEIC or RAW image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es una imagen JPEG, PNG, TIFF, HEIC ni RAW.</translation>
    </message>
    <message>
      <source>The known lengths cannot be used: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las longitudes conocidas no se pueden usar: %1.</translation>
    </message>
    <message>
      <source>'side' must be 'front' or 'back'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'side' debe ser 'front' o 'back'</translation>
    </message>
    <message>
      <source>'ends' must be two lists of marks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'ends' debe ser dos listas de marcas</translation>
    </message>
    <message>
      <source>each end must be marked on at least two photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cada extremo debe estar marcado en dos fotos como mínimo</translation>
    </message>
    <message>
      <source>their unit must be mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su unidad debe ser mm</translation>
    </message>
    <message>
      <source>each needs 'side', 'length' and 'ends' with 'file' and 'pixel'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cada una necesita 'side', 'length' y 'ends' con 'file' y 'pixel'</translation>
    </message>
    <message>
      <source>The image cannot be decoded; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La imagen no se puede descodificar; cópiela otra vez.</translation>
    </message>
    <message>
      <source>The plate&apos;s unit must be mm; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La unidad del plato debe ser mm; cree otra vez el archivo del plato.</translation>
    </message>
    <message>
      <source>The plate file lists more than 1024 markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo del plato nombra más de 1024 marcas.</translation>
    </message>
    <message>
      <source>The plate file needs &apos;dictionary&apos; and &apos;markers&apos;, each with an id and four corners of three numbers; &apos;diameter&apos;, if given, is a number in mm, &apos;sheet&apos; the paper&apos;s width and height.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo del plato necesita 'dictionary' y 'markers' con un id y cuatro esquinas de tres números cada una; 'diameter', si se da, es un número en mm, 'sheet' la anchura y la altura del papel.</translation>
    </message>
    <message>
      <source>The plate file lists no markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo del plato no nombra ninguna marca.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate has no valid corners.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La marca %1 del plato no tiene esquinas válidas.</translation>
    </message>
    <message>
      <source>Marker %1 occurs twice on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La marca %1 está dos veces en el plato.</translation>
    </message>
    <message>
      <source>The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and 'marker_mm'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El tablero necesita 'dictionary', 'squares_x', 'squares_y', 'square_mm' y 'marker_mm'.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another batch name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay un archivo con este nombre y no se sobrescribe; elija otro nombre de tanda.</translation>
    </message>
    <message>
      <source>This batch started on another plate; continue with that plate or start a new batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda se empezó en otro plato; siga con aquel o empiece una tanda nueva.</translation>
    </message>
    <message>
      <source>This batch started with another setup (cameras: %1, positions: %2; now: %3 and %4); choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda empezó con otra configuración (cámaras: %1, posiciones: %2; ahora: %3 y %4); elija otra carpeta.</translation>
    </message>
    <message>
      <source>The photograph has changed since it was taken; restore the original or choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La foto se modificó después de tomarla; vuelva a poner el original o elija otra carpeta para la tanda.</translation>
    </message>
    <message>
      <source>This photograph does not belong to this batch; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta foto no pertenece a esta tanda; elija otra carpeta para la tanda.</translation>
    </message>
    <message>
      <source>Camera %1 delivers raw files only; set its image format to JPEG, or to both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 solo entrega archivos raw; ponga su formato de imagen en JPEG o en ambos.</translation>
    </message>
    <message>
      <source>%1 is %2, but the rig specifies %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 es %2, el equipo dice %3</translation>
    </message>
    <message>
      <source>%1 is %2, but the first photograph used %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 es %2, en la primera foto era %3</translation>
    </message>
    <message>
      <source>The turntable did not reach its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no llegó a su cero.</translation>
    </message>
    <message>
      <source>The turntable does not report its position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no comunica su posición.</translation>
    </message>
    <message>
      <source>The turntable rejected a command (error %1): wrong turntable type or bad cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria rechazó una orden (error %1): tipo de mesa giratoria equivocado o cable defectuoso.</translation>
    </message>
    <message>
      <source>The turntable&apos;s speed must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La velocidad de la mesa giratoria debe ser mayor que 0.</translation>
    </message>
    <message>
      <source>The connection to the turntable failed (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falló la conexión con la mesa giratoria (%1).</translation>
    </message>
    <message>
      <source>it is not open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>no está abierta</translation>
    </message>
    <message>
      <source>it accepts no more data</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>no acepta más datos</translation>
    </message>
    <message>
      <source>it was closed at the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>se cerró en el otro extremo</translation>
    </message>
    <message>
      <source>You have no permission to use this serial port; install Ostraka&apos;s udev rules or join the group dialout, then log in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No tiene permiso para usar este puerto serie; instale las reglas udev de Ostraka o únase al grupo dialout y vuelva a iniciar sesión.</translation>
    </message>
    <message>
      <source>The serial port does not exist; check that the turntable is plugged in and switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El puerto serie no existe; compruebe que la mesa giratoria está conectada y encendida.</translation>
    </message>
    <message>
      <source>Not a serial port.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un puerto serie.</translation>
    </message>
    <message>
      <source>The serial port does not accept its settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El puerto serie no acepta sus ajustes.</translation>
    </message>
    <message>
      <source>The turntable&apos;s address is unknown on this network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La dirección de la mesa giratoria no se conoce en esta red.</translation>
    </message>
    <message>
      <source>A serial port does not support %1 baud; common rates are 9600 and 115200.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un puerto serie no admite %1 baudios; lo habitual es 9600 y 115200.</translation>
    </message>
    <message>
      <source>A network address looks like 192.168.0.7:23.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una dirección de red tiene la forma 192.168.0.7:23.</translation>
    </message>
    <message>
      <source>The desktop does not release the camera: it is still in use by %1; close its file window and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escritorio no suelta la cámara: todavía la usa %1; cierre su ventana de archivos e inténtelo otra vez.</translation>
    </message>
    <message>
      <source>A watched folder has no setting %1; set it on the camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una carpeta vigilada no tiene el ajuste %1; ajústelo en la cámara.</translation>
    </message>
    <message>
      <source>A watched folder has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una carpeta vigilada no muestra imagen en directo.</translation>
    </message>
    <message>
      <source>No new photograph arrived within %1 seconds; check that the camera&apos;s software writes into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No llegó ninguna foto nueva en %1 segundos; compruebe que el programa de la cámara escribe en esta carpeta.</translation>
    </message>
    <message>
      <source>The watched folder cannot be read (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta vigilada no se puede leer (%1).</translation>
    </message>
    <message>
      <source>Two photographs arrived for one shot, %1 and %2; use one folder per camera and one photograph per position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Llegaron dos fotos para una toma, %1 y %2; una carpeta por cámara, una foto por posición.</translation>
    </message>
    <message>
      <source>The camera with this serial number is not plugged in; found: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara con este número de serie no está conectada; hay: %1.</translation>
    </message>
    <message>
      <source>The camera does not offer %1 for %2; it is set to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no ofrece %1 para %2; está en %3.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3; check its mode dial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara mantiene %1 en %2 en vez de %3; revise su dial de modos.</translation>
    </message>
    <message>
      <source>The camera has no setting %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no tiene el ajuste %1.</translation>
    </message>
    <message>
      <source>The camera reports: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara comunica: %1.</translation>
    </message>
    <message>
      <source>The turntable has no zero switch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no tiene interruptor de cero.</translation>
    </message>
    <message>
      <source>It did not answer while homing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No respondió mientras iba a cero.</translation>
    </message>
    <message>
      <source>It did not unlock.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se desbloqueó.</translation>
    </message>
    <message>
      <source>It did not answer the shutter command.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No respondió a la orden de disparo.</translation>
    </message>
    <message>
      <source>The turntable does not answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no responde.</translation>
    </message>
    <message>
      <source>The turntable does not stop moving.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no se detiene.</translation>
    </message>
    <message>
      <source>The turntable does not accept its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no acepta su cero.</translation>
    </message>
    <message>
      <source>The controller reset its count; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El controlador puso su cuenta a cero; no se conoce la posición de la mesa giratoria.</translation>
    </message>
    <message>
      <source>The turntable does not move.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no se mueve.</translation>
    </message>
    <message>
      <source>The turntable did not arrive in time; it was stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no llegó a tiempo; se detuvo.</translation>
    </message>
    <message>
      <source>The shutter output must be M8, M7, M3 or M62 Pn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La salida del disparador debe ser M8, M7, M3 o M62 Pn.</translation>
    </message>
    <message>
      <source>The turntable was stopped while moving and lost its position: align the zero mark (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria se detuvo en movimiento y su posición se perdió: alinee la marca de cero (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller reports a turn beyond its travel: switch $20 off (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El controlador de la mesa giratoria comunica un giro que excede su recorrido: desactive $20 (ALARM:%1).</translation>
    </message>
    <message>
      <source>Homing failed: check the zero switch and its cable (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudo llevar a cero: revise el interruptor de cero y su cable (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller raised an alarm (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El controlador de la mesa giratoria dio una alarma (ALARM:%1).</translation>
    </message>
    <message>
      <source>The controller does not understand the command: wrong controller type or bad cable (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El controlador no entiende la orden: tipo de controlador equivocado o cable defectuoso (error:%1).</translation>
    </message>
    <message>
      <source>The turntable has no zero switch (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no tiene interruptor de cero (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is still moving (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria todavía se mueve (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is locked: home it or unlock it (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria está bloqueada: llévela a cero o desbloquéela (error:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller rejected a command (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El controlador de la mesa giratoria rechazó una orden (error:%1).</translation>
    </message>
    <message>
      <source>Turn the turntable counter-clockwise to %1 degrees, then take your hand away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gire la mesa giratoria en sentido antihorario hasta %1 grados y retire la mano.</translation>
    </message>
    <message>
      <source>Not an Ostraka photograph list; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es una lista de fotos de Ostraka; elija otra carpeta para la tanda.</translation>
    </message>
    <message>
      <source>The turntable driver %1 is unknown; available: grbl, comxim1, comxim2, text, hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se conoce el controlador %1 de la mesa giratoria; hay: grbl, comxim1, comxim2, text, hand.</translation>
    </message>
    <message>
      <source>The camera driver %1 is unknown; available: folder, gphoto2, uvc.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se conoce el controlador de cámara %1; hay: folder, gphoto2, uvc.</translation>
    </message>
    <message>
      <source>The rig names no devices; &apos;ostraka devices&apos; lists what is plugged in and how to enter it in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo no nombra ningún dispositivo; 'ostraka devices' dice qué está conectado y cómo escribirlo en el equipo.</translation>
    </message>
    <message>
      <source>The rig names no camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo no nombra ninguna cámara.</translation>
    </message>
    <message>
      <source>settle_s and speed_deg_s must be positive.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>settle_s y speed_deg_s deben ser positivos.</translation>
    </message>
    <message>
      <source>The section &apos;devices&apos; cannot be read; compare it with docs/devices.md.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La parte 'devices' no se puede leer; compárela con docs/devices.md.</translation>
    </message>
    <message>
      <source>The number of positions must be between 3 and 99.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de posiciones debe estar entre 3 y 99.</translation>
    </message>
    <message>
      <source>The rig has no camera or no turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo no tiene cámara o no tiene mesa giratoria.</translation>
    </message>
    <message>
      <source>There is no shot %1 to retake: this side has positions 1 to %2 and cameras A to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay una toma %1 que repetir: este lado tiene las posiciones 1 a %2 y las cámaras A a %3.</translation>
    </message>
    <message>
      <source>Camera %1 of this batch was %2, but the connected one is %3; continue with the original cameras or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 de esta tanda era %2, la conectada es %3; siga con las cámaras originales o elija otra carpeta.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: turn its zero mark to the front and set zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se conoce la posición de la mesa giratoria: gire su marca de cero hacia delante y fije el cero.</translation>
    </message>
    <message>
      <source>Camera %1, position %2 failed %3 times: %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1, posición %2: falló %3 veces: %4.</translation>
    </message>
    <message>
      <source>Camera %1 delivers only earlier or broken photographs; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 solo entrega fotos anteriores o dañadas; apáguela y enciéndala.</translation>
    </message>
    <message>
      <source>The turntable does not answer as a %1; check its type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no responde como un %1; compruebe su tipo.</translation>
    </message>
    <message>
      <source>Marlin controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>controlador Marlin</translation>
    </message>
    <message>
      <source>text controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>controlador de texto</translation>
    </message>
    <message>
      <source>This turntable has no zero switch: align it by eye.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta mesa giratoria no tiene interruptor de cero: alinéela a ojo.</translation>
    </message>
    <message>
      <source>The turntable rejects the command: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria rechaza la orden: %1.</translation>
    </message>
    <message>
      <source>The turntable is at %1 degrees instead of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria está en %1 grados en vez de %2.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;move&apos; must contain {target} or {by}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dialecto de la mesa giratoria: 'move' debe contener {target} o {by}.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;accepted&apos; must describe its answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dialecto de la mesa giratoria: 'accepted' debe describir su respuesta.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;query&apos; and &apos;position&apos; must be given together.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dialecto de la mesa giratoria: 'query' y 'position' deben darse juntas.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;reply_s&apos; must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dialecto de la mesa giratoria: 'reply_s' debe ser mayor que 0.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;%1&apos; is not a regular expression.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dialecto de la mesa giratoria: '%1' no es una expresión regular.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;position&apos; needs a group for the angle.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El dialecto de la mesa giratoria: 'position' necesita un grupo para el ángulo.</translation>
    </message>
    <message>
      <source>The turntable&apos;s &apos;dialect&apos; must be &quot;marlin&quot; or an object with its commands.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'dialect' de la mesa giratoria debe ser &quot;marlin&quot; o un objeto con sus órdenes.</translation>
    </message>
    <message>
      <source>The turntable is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no está conectada.</translation>
    </message>
    <message>
      <source>The turntable&apos;s USB connection failed (%1); plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falló la conexión USB de la mesa giratoria (%1); vuelva a conectarla.</translation>
    </message>
    <message>
      <source>You have no permission to use this USB device; install packaging/udev/70-ostraka.rules and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No tiene permiso para usar este dispositivo USB; instale packaging/udev/70-ostraka.rules y vuelva a conectarlo.</translation>
    </message>
    <message>
      <source>Another program uses the turntable; close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa está usando la mesa giratoria; ciérrelo.</translation>
    </message>
    <message>
      <source>The turntable cannot be opened (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria no se puede abrir (%1).</translation>
    </message>
    <message>
      <source>This USB device is not a serial controller (CDC-ACM).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este dispositivo USB no es un controlador serie (CDC-ACM).</translation>
    </message>
    <message>
      <source>The turntable with this serial number is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La mesa giratoria con este número de serie no está conectada.</translation>
    </message>
    <message>
      <source>A USB turntable is named by vendor and product, for example usb:1209:0001.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una mesa giratoria USB se nombra por fabricante y producto, como usb:1209:0001.</translation>
    </message>
    <message>
      <source>The video camera cannot be opened; check that it is plugged in and that no other program uses it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara de vídeo no se puede abrir; compruebe que está conectada y que no la usa otro programa.</translation>
    </message>
    <message>
      <source>A video camera has exposure (0.1 ms), focus, white_balance (K) and gain, as numbers; not %1 %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cámara de vídeo tiene exposure (0,1 ms), focus, white_balance (K) y gain, como números; no %1 %2.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara mantiene %1 en %2 en vez de %3.</translation>
    </message>
    <message>
      <source>The video camera no longer delivers pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara de vídeo ya no da imágenes.</translation>
    </message>
    <message>
      <source>The video camera took no picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara de vídeo no tomó ninguna imagen.</translation>
    </message>
    <message>
      <source>The video camera delivers pictures of %1x%2 pixels instead of the configured size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara de vídeo da imágenes de %1x%2 píxeles, no del tamaño ajustado.</translation>
    </message>
    <message>
      <source>Another program is writing decisions or masks of this batch, so nothing was saved; try again in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa está escribiendo decisiones o máscaras de esta tanda, así que no se guardó nada; inténtelo de nuevo enseguida.</translation>
    </message>
    <message>
      <source>The part of Ostraka that video cameras need cannot be loaded; install Ostraka again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede cargar la parte de Ostraka que necesitan las cámaras de vídeo; vuelva a instalar Ostraka.</translation>
    </message>
    <message>
      <source>The video camera must be named.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay que nombrar la cámara de vídeo.</translation>
    </message>
    <message>
      <source>the file is truncated or not a picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el archivo está cortado o no es una imagen</translation>
    </message>
    <message>
      <source>the markers show an angle other than this position&apos;s</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>las marcas muestran otro ángulo que el de esta posición</translation>
    </message>
    <message>
      <source>the picture&apos;s size differs from that of the camera&apos;s other pictures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la imagen tiene otro tamaño que las demás de la cámara</translation>
    </message>
    <message>
      <source>too few markers are visible to identify the position: check that nothing covers them and that the picture is sharp</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>se ven muy pocas marcas para saber la posición: compruebe que nada las tapa y que la imagen es nítida</translation>
    </message>
    <message>
      <source>the camera delivered an earlier photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la cámara entregó otra vez una foto anterior</translation>
    </message>
    <message>
      <source>too few markers of the plate are visible: check that nothing covers them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>se ven muy pocas marcas del plato: compruebe que nada las tapa</translation>
    </message>
    <message>
      <source>the picture is blurred: check that the turntable is still and the focus is unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la imagen está borrosa: compruebe que la mesa giratoria está quieta y que el enfoque no ha cambiado</translation>
    </message>
    <message>
      <source>the sherds are too dark: add light or increase the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>los fragmentos están muy oscuros: dé más luz o exponga más tiempo</translation>
    </message>
    <message>
      <source>the sherds are overexposed: reduce the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>los fragmentos están sobreexpuestos: exponga menos tiempo</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el borde de la imagen corta un fragmento: muévalo, o mueva la cámara</translation>
    </message>
    <message>
      <source>the camera&apos;s settings have changed: restore them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>los ajustes de la cámara han cambiado: restablézcalos</translation>
    </message>
    <message>
      <source>%1: restore it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: restablézcalo</translation>
    </message>
    <message>
      <source>A plate holds 1 to 60 sherds; 0 means not counted.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un plato lleva de 1 a 60 fragmentos; 0 significa sin contar.</translation>
    </message>
    <message>
      <source>The number of a batch is also the name of its folder; use letters and digits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de una tanda es también el nombre de su carpeta; use letras y cifras.</translation>
    </message>
    <message>
      <source>The uuid of a batch is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El uuid de una tanda está mal formado.</translation>
    </message>
    <message>
      <source>The batch %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay una tanda %1.</translation>
    </message>
    <message>
      <source>This batch is not in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda no está en el catálogo.</translation>
    </message>
    <message>
      <source>The project&apos;s code must be 2 to 8 letters from A to Z or digits, for example ARM.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El código del proyecto debe tener de 2 a 8 mayúsculas de la A a la Z o cifras, como ARM.</translation>
    </message>
    <message>
      <source>A vocabulary term must contain letters and no &apos;;&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un término de un vocabulario debe tener letras y ningún ';'.</translation>
    </message>
    <message>
      <source>The term &apos;%1&apos; appears twice in the vocabulary.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El término '%1' está dos veces en el vocabulario.</translation>
    </message>
    <message>
      <source>Sherds with the term '%1': %2; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos con el término «%1»: %2; cámbielos primero.</translation>
    </message>
    <message>
      <source>a row of %1 refers to a missing row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>una fila de %1 apunta a una fila que falta</translation>
    </message>
    <message>
      <source>the sherd tables are inconsistent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>las tablas de los fragmentos no concuerdan</translation>
    </message>
    <message>
      <source>the search index is incomplete</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el índice de búsqueda está incompleto</translation>
    </message>
    <message>
      <source>The backup does not contain the saved data; try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La copia de seguridad no contiene lo que se guardó; inténtelo otra vez.</translation>
    </message>
    <message>
      <source>The catalogue cannot be opened; check that the folder exists and is writable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El catálogo no se puede abrir; compruebe que la carpeta existe y que se puede escribir en ella.</translation>
    </message>
    <message>
      <source>The catalogue cannot be written to; check the permissions of the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede escribir en el catálogo; revise los permisos de la carpeta.</translation>
    </message>
    <message>
      <source>The disk reports errors; check it, then reopen the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco comunica errores; revíselo y vuelva a abrir el proyecto.</translation>
    </message>
    <message>
      <source>The catalogue rejects this operation (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El catálogo rechaza esta operación (%1).</translation>
    </message>
    <message>
      <source>The scan is not a front of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo no es un anverso de esta tanda.</translation>
    </message>
    <message>
      <source>The scan is not a back of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo no es un reverso de esta tanda.</translation>
    </message>
    <message>
      <source>A pair needs a front and a back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una pareja tiene un anverso y un reverso.</translation>
    </message>
    <message>
      <source>The decision to undo is not in this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión que se quiere deshacer no está en esta tanda.</translation>
    </message>
    <message>
      <source>A decision needs a front, a back or both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una decisión nombra un anverso, un reverso o ambos.</translation>
    </message>
    <message>
      <source>The uuid of a decision is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El uuid de una decisión está mal formado.</translation>
    </message>
    <message>
      <source>This file is outside the project&apos;s folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo no está en la carpeta del proyecto.</translation>
    </message>
    <message>
      <source>This is a draft from reduced photographs; reprocess the batch for final measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un borrador a partir de fotos reducidas; reprocese la tanda para tener medidas definitivas.</translation>
    </message>
    <message>
      <source>These results of &apos;ostraka process&apos; are incomplete; run it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos resultados de 'ostraka process' están incompletos; ejecútelo otra vez.</translation>
    </message>
    <message>
      <source>Another program is entering results of this batch; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro programa está introduciendo resultados de esta tanda; este espera a que termine.</translation>
    </message>
    <message>
      <source>The pair table names the scan %1, which is missing; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tabla de parejas nombra el escaneo %1, que no existe; ejecute otra vez 'ostraka process'.</translation>
    </message>
    <message>
      <source>This batch is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This photograph is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta foto ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This scan is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este escaneo ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This file is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This person is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta persona ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This site is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este yacimiento ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This trench is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este corte ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This context is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este contexto ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>This bag is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta bolsa ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>The filter has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El filtro abre unas comillas y no las cierra.</translation>
    </message>
    <message>
      <source>This is only part of a sherd&apos;s label; scan its code again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es solo una parte de la etiqueta de un fragmento; lea otra vez su código.</translation>
    </message>
    <message>
      <source>The filter is not valid text.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El filtro no es un texto válido.</translation>
    </message>
    <message>
      <source>There is no field '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay ningún campo '%1'.</translation>
    </message>
    <message>
      <source>Some of the changes remain because they could not be undone: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Algunos de los cambios quedan, porque no se pudieron deshacer: %1</translation>
    </message>
    <message>
      <source>There is no measurement of this kind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay ninguna medida de este tipo.</translation>
    </message>
    <message>
      <source>A measurement cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una medida no puede ser menor que 0.</translation>
    </message>
    <message>
      <source>A newer Ostraka made this project (catalogue version %1, this program supports %2). Nothing was changed. Install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un Ostraka más nuevo hizo este proyecto (catálogo versión %1, este programa admite %2). No se cambió nada. Instale la versión más nueva.</translation>
    </message>
    <message>
      <source>The numbering cannot contain the character &apos;%1&apos;; letters, digits, &apos;.&apos;, &apos;_&apos;, &apos;/&apos; and &apos;-&apos; are allowed between the tokens.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La numeración no puede contener el carácter '%1'; entre las marcas se permiten letras, cifras, '.', '_', '/' y '-'.</translation>
    </message>
    <message>
      <source>The numbering opens a token with { and does not close it with }.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La numeración abre una marca con { y no la cierra con }.</translation>
    </message>
    <message>
      <source>The numbering has no token {%1}; available: site, trench, context, bag, batch, yyyy, yy and n.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La numeración no tiene la marca {%1}; hay site, trench, context, bag, batch, yyyy, yy y n.</translation>
    </message>
    <message>
      <source>The width of {%1} must be written as :04, with 12 digits at most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La anchura de {%1} debe escribirse como :04, con 12 cifras como máximo.</translation>
    </message>
    <message>
      <source>Two tokens are adjacent; put &apos;-&apos; or another character between {%1} and {%2}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos marcas se tocan; ponga un '-' u otro signo entre {%1} y {%2}.</translation>
    </message>
    <message>
      <source>The numbering must count the sherds with {n} exactly once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La numeración debe contar los fragmentos con {n} exactamente una vez.</translation>
    </message>
    <message>
      <source>The number needs the site of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número necesita el yacimiento del fragmento, que no está registrado.</translation>
    </message>
    <message>
      <source>The number needs the context of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número necesita el contexto del fragmento, que no está registrado.</translation>
    </message>
    <message>
      <source>The number needs the bag of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número necesita la bolsa del fragmento, que no está registrada.</translation>
    </message>
    <message>
      <source>The number needs the batch of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número necesita la tanda del fragmento, que no está registrada.</translation>
    </message>
    <message>
      <source>The site %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El yacimiento %1 contiene el signo '%2' que está a su lado en el número.</translation>
    </message>
    <message>
      <source>The trench %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El corte %1 contiene el signo '%2' que está a su lado en el número.</translation>
    </message>
    <message>
      <source>The context %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El contexto %1 contiene el signo '%2' que está a su lado en el número.</translation>
    </message>
    <message>
      <source>The bag %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La bolsa %1 contiene el signo '%2' que está a su lado en el número.</translation>
    </message>
    <message>
      <source>The batch %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tanda %1 contiene el signo '%2' que está a su lado en el número.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before; numbers are never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 ya se dio antes; los números nunca se reutilizan.</translation>
    </message>
    <message>
      <source>The block of numbers up to %1 is used up; assign this computer a new block in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El bloque de números hasta %1 está agotado; dé a este ordenador un bloque nuevo en los ajustes.</translation>
    </message>
    <message>
      <source>A decision needs the name of the person who makes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una decisión necesita el nombre de la persona que la toma.</translation>
    </message>
    <message>
      <source>A merge needs two or more fragments.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una unión necesita dos trozos o más.</translation>
    </message>
    <message>
      <source>A split needs exactly one fragment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una división necesita exactamente un trozo.</translation>
    </message>
    <message>
      <source>The name of a person must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre de una persona no puede estar vacío.</translation>
    </message>
    <message>
      <source>The person's initials must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las iniciales de la persona no pueden estar vacías.</translation>
    </message>
    <message>
      <source>The code of a site must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El código de un yacimiento no puede estar vacío.</translation>
    </message>
    <message>
      <source>The code of a trench must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El código de un corte no puede estar vacío.</translation>
    </message>
    <message>
      <source>The number of a context must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de un contexto no puede estar vacío.</translation>
    </message>
    <message>
      <source>The number of a bag must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de una bolsa no puede estar vacío.</translation>
    </message>
    <message>
      <source>The name of a person must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre de una persona es demasiado largo; 200 letras como máximo.</translation>
    </message>
    <message>
      <source>The person&apos;s initials must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las iniciales de la persona son demasiado largas; 200 letras como máximo.</translation>
    </message>
    <message>
      <source>The code of a site must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El código de un yacimiento es demasiado largo; 200 letras como máximo.</translation>
    </message>
    <message>
      <source>The code of a trench must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El código de un corte es demasiado largo; 200 letras como máximo.</translation>
    </message>
    <message>
      <source>The number of a context must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de un contexto es demasiado largo; 200 letras como máximo.</translation>
    </message>
    <message>
      <source>The number of a bag must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de una bolsa es demasiado largo; 200 letras como máximo.</translation>
    </message>
    <message>
      <source>The uuid is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El uuid está mal formado.</translation>
    </message>
    <message>
      <source>The initials %1 already belong to another person.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las iniciales %1 ya pertenecen a otra persona.</translation>
    </message>
    <message>
      <source>The latitude must be between -90 and 90 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La latitud debe estar entre -90 y 90 grados.</translation>
    </message>
    <message>
      <source>The longitude must be between -180 and 180 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La longitud debe estar entre -180 y 180 grados.</translation>
    </message>
    <message>
      <source>The site %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay un yacimiento %1.</translation>
    </message>
    <message>
      <source>A trench needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un corte necesita un yacimiento.</translation>
    </message>
    <message>
      <source>A trench cannot contain itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un corte no puede estar dentro de sí mismo.</translation>
    </message>
    <message>
      <source>The trench %1 already exists in this site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay un corte %1 en este yacimiento.</translation>
    </message>
    <message>
      <source>A context needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un contexto necesita un yacimiento.</translation>
    </message>
    <message>
      <source>The trench and the context belong to different sites.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El corte y el contexto pertenecen a yacimientos distintos.</translation>
    </message>
    <message>
      <source>The context %1 already exists in this place.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay un contexto %1 en este lugar.</translation>
    </message>
    <message>
      <source>A bag needs a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una bolsa necesita un contexto.</translation>
    </message>
    <message>
      <source>The weight of a bag must be greater than 0 g.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El peso de una bolsa debe ser mayor que 0 g.</translation>
    </message>
    <message>
      <source>A count cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cantidad no puede ser menor que 0.</translation>
    </message>
    <message>
      <source>The bag %1 already exists in this context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay una bolsa %1 en este contexto.</translation>
    </message>
    <message>
      <source>The folder is on a network share (%1), which can damage catalogues; use a folder on this computer&apos;s own disk and copy backups to the share.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta está en un recurso de red (%1), lo que puede dañar los catálogos; use una carpeta del disco de este ordenador y copie las copias de seguridad al recurso.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta no es un proyecto de Ostraka: no contiene catalogue.sqlite.</translation>
    </message>
    <message>
      <source>A new project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un proyecto nuevo necesita una carpeta nueva o vacía; elija otro nombre.</translation>
    </message>
    <message>
      <source>The folder cannot be created; choose a location that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta no se puede crear; elija un lugar en el que pueda escribir.</translation>
    </message>
    <message>
      <source>A uuid of the export is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un uuid de la exportación está mal formado.</translation>
    </message>
    <message>
      <source>The decision is saved with the batch, but %1 is not in the catalogue yet; it is added with the next results.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión está guardada con la tanda, pero %1 aún no está en el catálogo; se añadirá con los próximos resultados.</translation>
    </message>
    <message>
      <source>The field %1 is read-only: the program sets it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El campo %1 es de solo lectura: lo pone el programa.</translation>
    </message>
    <message>
      <source>A void sherd keeps its number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento anulado conserva su número.</translation>
    </message>
    <message>
      <source>A number cannot contain a line break, a tab or &apos;%&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un número no puede contener saltos de línea, tabuladores ni '%'.</translation>
    </message>
    <message>
      <source>A number or code cannot contain invisible characters; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un número o código no puede contener caracteres invisibles; escríbalo de nuevo.</translation>
    </message>
    <message>
      <source>A number has at most 120 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un número tiene 120 caracteres como máximo.</translation>
    </message>
    <message>
      <source>The number %1 would be assigned twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 se daría dos veces.</translation>
    </message>
    <message>
      <source>The files of %1 would have the same names as those of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los archivos de %1 tendrían los mismos nombres que los de %2.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 ya se dio antes y no se vuelve a usar.</translation>
    </message>
    <message>
      <source>The number %1 belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 pertenece a otro fragmento.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0 after ±, or 0 if the uncertainty is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba tras ± un valor mayor que 0, o 0 si no se conoce la incertidumbre.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba un valor mayor que 0.</translation>
    </message>
    <message>
      <source>No sherd is larger than 1000 mm; check that the value is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún fragmento mide más de 1000 mm; compruebe que el valor está en milímetros.</translation>
    </message>
    <message>
      <source>No sherd is heavier than 20 kg; check that the value is in grams.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún fragmento pesa más de 20 kg; compruebe que el valor está en gramos.</translation>
    </message>
    <message>
      <source>A share cannot exceed 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una proporción no puede superar el 100 %.</translation>
    </message>
    <message>
      <source>There is no sherd %1 to join.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay ningún fragmento %1 con el que pueda unirse.</translation>
    </message>
    <message>
      <source>A sherd cannot join itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento no se une consigo mismo.</translation>
    </message>
    <message>
      <source>There is no context %1 in %2; add it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay ningún contexto %1 en %2; añádalo primero.</translation>
    </message>
    <message>
      <source>A numbered sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento numerado necesita su contexto.</translation>
    </message>
    <message>
      <source>A sherd needs its context before it gets a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento necesita su contexto antes de recibir número.</translation>
    </message>
    <message>
      <source>The table cannot be sorted by &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tabla no se puede ordenar por '%1'.</translation>
    </message>
    <message>
      <source>A sherd is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento ya no está en el catálogo.</translation>
    </message>
    <message>
      <source>The uuid of a sherd is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El uuid de un fragmento está mal formado.</translation>
    </message>
    <message>
      <source>A sherd with this uuid already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay un fragmento con este uuid.</translation>
    </message>
    <message>
      <source>A void sherd needs a reason; enter it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento anulado necesita un motivo; escríbalo.</translation>
    </message>
    <message>
      <source>The number %1 appears on two sherds of this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 está en dos fragmentos de este plato.</translation>
    </message>
    <message>
      <source>The number %1 already belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 ya pertenece a otro fragmento.</translation>
    </message>
    <message>
      <source>The sherd of this label has no number yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El fragmento de esta etiqueta aún no tiene número.</translation>
    </message>
    <message>
      <source>The text is longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El texto supera 1 MB.</translation>
    </message>
    <message>
      <source>The text is not valid UTF-8 or contains a zero byte.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El texto no es UTF-8 válido o contiene un byte nulo.</translation>
    </message>
    <message>
      <source>The text contains control characters, which documents cannot contain; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El texto contiene caracteres de control, que los documentos no pueden contener; escríbalo de nuevo.</translation>
    </message>
    <message>
      <source>Write the day as 2026-07-14 (year-month-day).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba el día como 2026-07-14 (año-mes-día).</translation>
    </message>
    <message>
      <source>Write the Munsell colour as 10YR 3/1 or N 4/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba el color Munsell como 10YR 3/1 o N 4/.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a number; write 12.5 or 12,5, without a unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' no es un número; escriba 12.5 o 12,5, sin unidad.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a path inside its folder; it must be relative, with &apos;/&apos; and without &apos;..&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' no es una ruta dentro de su carpeta; debe ser relativa, con '/' y sin '..'.</translation>
    </message>
    <message>
      <source>Not a PLY file; choose one, or export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un archivo PLY; elija uno o exporte otra vez el escaneo.</translation>
    </message>
    <message>
      <source>The PLY header states no format; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cabecera PLY no nombra ningún formato; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>The PLY header has an error in line %1: %2; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cabecera PLY está mal en la línea %1: %2; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>its format is unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su formato no se conoce</translation>
    </message>
    <message>
      <source>a count is not a number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>una cantidad no es un número</translation>
    </message>
    <message>
      <source>a property cannot be read</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>una propiedad no se puede leer</translation>
    </message>
    <message>
      <source>a property has an unknown type</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>una propiedad tiene un tipo desconocido</translation>
    </message>
    <message>
      <source>the length of a list is not a whole number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la longitud de una lista no es un número entero</translation>
    </message>
    <message>
      <source>a line cannot be parsed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>una línea no se entiende</translation>
    </message>
    <message>
      <source>The PLY header has no end; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cabecera PLY no tiene final; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>The PLY header declares %1 of &apos;%2&apos;, more than the file contains; the file may be truncated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cabecera PLY declara %1 de '%2', más de lo que contiene el archivo; puede estar cortado.</translation>
    </message>
    <message>
      <source>The PLY file has two lists of vertices; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY tiene dos listas de vértices; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>The PLY vertices lack x, y or z; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A los vértices del PLY les falta x, y o z; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>The PLY file ends early or contains a value that is not a number; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY acaba antes de tiempo o contiene algo que no es un número; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>A face of the PLY file refers to a vertex that does not exist; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cara del PLY nombra un vértice que no existe; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>The PLY file ends within '%1'; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY acaba en medio de '%1'; cópielo otra vez.</translation>
    </message>
    <message>
      <source>The PLY file has no vertices; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY no tiene vértices; exporte otra vez el escaneo.</translation>
    </message>
    <message>
      <source>The PLY file states its unit as &apos;%1&apos;, but lengths must be in mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY indica la unidad '%1', pero las longitudes deben estar en mm; expórtelo en mm.</translation>
    </message>
    <message>
      <source>The PLY file contains more data than its header declares; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY contiene más de lo que declara su cabecera; expórtelo otra vez.</translation>
    </message>
    <message>
      <source>The PLY file contains no usable points; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY no contiene ningún punto utilizable; exporte otra vez el escaneo.</translation>
    </message>
    <message>
      <source>No part of the edge can be a rim; draw this sherd without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún tramo del contorno puede ser un borde; dibuje este fragmento sin borde.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %), so no diameter is given; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que se tomó por el labio apenas lo parece (%1 %), así que no se indica diámetro; revise cómo está orientado el fragmento.</translation>
    </message>
    <message>
      <source>The preserved rim is too short or too straight for a diameter; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El tramo de borde es demasiado corto o demasiado recto para dar un diámetro; revise cómo está orientado el fragmento.</translation>
    </message>
    <message>
      <source>Drawn as a rim sherd, which is likely (%1 %); check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dibujado como fragmento de borde, lo que es probable (%1 %); compruébelo.</translation>
    </message>
    <message>
      <source>This may be a rim sherd (%1 %); if it is, mark it as one and redraw it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Puede ser un fragmento de borde (%1 %); si lo es, indíquelo y dibújelo otra vez.</translation>
    </message>
    <message>
      <source>The drawing&apos;s scale must be between 1:20 and 5:1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La escala del dibujo debe estar entre 1:20 y 5:1.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model (%1); create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un dibujo necesita un modelo cerrado (%1); hágalo con 'ostraka process'.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model; create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un dibujo necesita un modelo cerrado; hágalo con 'ostraka process'.</translation>
    </message>
    <message>
      <source>The manifest is missing; not an Ostraka export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falta el manifiesto; no es una exportación de Ostraka.</translation>
    </message>
    <message>
      <source>The manifest has a line that cannot be read (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El manifiesto tiene una línea ilegible (%1), por lo que no se leyó nada; copie la carpeta de nuevo.</translation>
    </message>
    <message>
      <source>The manifest names a file outside the folder (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El manifiesto nombra un archivo fuera de la carpeta (%1), por lo que no se leyó nada; copie la carpeta de nuevo.</translation>
    </message>
    <message>
      <source>The manifest names the file %1 twice, so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El manifiesto nombra dos veces el archivo %1, por lo que no se leyó nada; copie la carpeta de nuevo.</translation>
    </message>
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay una carpeta con este nombre; elija otro nombre.</translation>
    </message>
    <message>
      <source>Not every system supports names with a line break, a backslash or characters that are not UTF-8; rename this file or folder, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No todos los sistemas conservan un nombre con un salto de línea, una barra invertida o caracteres que no son UTF-8; cambie el nombre de este archivo o de esta carpeta y vuelva a intentarlo.</translation>
    </message>
    <message>
      <source>On some systems this is the same name as %1; rename one of the two, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En algunos sistemas este nombre es el mismo que %1; cambie uno de los dos y vuelva a intentarlo.</translation>
    </message>
    <message>
      <source>Project A has another file with this name, which its catalogue does not list; nothing was merged. Move that file elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El proyecto A tiene otro archivo con este nombre que su catálogo no conoce; muévalo, no se ha fusionado nada.</translation>
    </message>
    <message>
      <source>Two files of the export would have the same name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos archivos de la exportación tendrían el mismo nombre.</translation>
    </message>
    <message>
      <source>Another import into this project is running; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay otra importación en curso en este proyecto; esta espera a que termine.</translation>
    </message>
    <message>
      <source>Files that were missing from the project and are restored: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Archivos que faltaban en el proyecto y se han recuperado: %1.</translation>
    </message>
    <message>
      <source>A folder with this name was created in the meantime; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entretanto se creó una carpeta con este nombre; elija otro nombre.</translation>
    </message>
    <message>
      <source>Not an Ostraka export: this folder has no bagit.txt.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta no es una exportación de Ostraka: falta bagit.txt.</translation>
    </message>
    <message>
      <source>This file is not in the manifest; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo no está en el manifiesto; no se leyó nada.</translation>
    </message>
    <message>
      <source>This is a link, not a file; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un enlace, no un archivo; no se leyó nada.</translation>
    </message>
    <message>
      <source>This folder cannot be read (%1); nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta no se puede leer (%1); no se leyó nada.</translation>
    </message>
    <message>
      <source>This file is missing; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo falta; no se leyó nada.</translation>
    </message>
    <message>
      <source>This file has changed since the export; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo se modificó después de la exportación; no se leyó nada.</translation>
    </message>
    <message>
      <source>The column &apos;closed&apos; accepts only yes or no.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La columna closed admite yes o no.</translation>
    </message>
    <message>
      <source>The column &apos;count_written&apos; accepts only a whole number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La columna count_written admite un número entero.</translation>
    </message>
    <message>
      <source>Values in the row: %1, columns in the header: %2; correct the row.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Valores en la fila: %1, columnas en el encabezado: %2; corrija la fila.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; is unknown; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La columna '%1' no se conoce; sus valores se guardan como un campo propio.</translation>
    </message>
    <message>
      <source>Not a text file: it contains binary data, which a table never does.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un archivo de texto: contiene datos binarios, que ninguna tabla tiene.</translation>
    </message>
    <message>
      <source>This is a spreadsheet (ODS, XLSX), not a CSV table; save the sheet as 'CSV UTF-8' and import that file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un libro de cálculo (ODS, XLSX), no una tabla CSV; guarde la hoja como 'CSV UTF-8' e importe ese archivo.</translation>
    </message>
    <message>
      <source>Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La línea %1 no está en UTF-8; guarde la tabla como 'CSV UTF-8' e inténtelo otra vez.</translation>
    </message>
    <message>
      <source>The table has more than 1,000,000 rows; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tabla tiene más de 1 000 000 de filas; divídala.</translation>
    </message>
    <message>
      <source>The table has more than 1,000 columns; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tabla tiene más de 1000 columnas; divídala.</translation>
    </message>
    <message>
      <source>Line %1 has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La línea %1 tiene unas comillas sin cerrar.</translation>
    </message>
    <message>
      <source>Line %1 has characters after a closing quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La línea %1 tiene caracteres detrás de unas comillas de cierre.</translation>
    </message>
    <message>
      <source>Line %1 has a value longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La línea %1 tiene un valor de más de 1 MB.</translation>
    </message>
    <message>
      <source>The table is empty; its first line must name the columns.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tabla está vacía; su primera línea debe nombrar las columnas.</translation>
    </message>
    <message>
      <source>This sherd has no model yet, so it cannot be drawn; process its batch first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este fragmento aún no tiene modelo y no se puede dibujar; procese antes su tanda.</translation>
    </message>
    <message>
      <source>The measurements of its batch are in doubt, and so is the size of this drawing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las medidas de su tanda son dudosas: también el tamaño de este dibujo.</translation>
    </message>
    <message>
      <source>The sherd is recorded as a rim, but no part of its edge can be one; it is drawn without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El fragmento está registrado como borde, pero ningún tramo de su contorno puede serlo; se dibuja sin él.</translation>
    </message>
    <message>
      <source>%1 is missing and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 falta y se omitió.</translation>
    </message>
    <message>
      <source>%1 differs from the recorded photograph; check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 difiere de la foto registrada; compruébela.</translation>
    </message>
    <message>
      <source>This model or picture of the sherd %1 differs from the recorded one; reprocess its batch %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este modelo o esta imagen del fragmento %1 difiere de lo registrado; reprocese su tanda %2.</translation>
    </message>
    <message>
      <source>%1 is exported in full detail: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se exporta con detalle completo: %2</translation>
    </message>
    <message>
      <source>%1 is exported without photographs: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se exporta sin fotografías: %2</translation>
    </message>
    <message>
      <source>Photographs can be projected only onto a closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotografías no se pueden aplicar a un modelo que no está cerrado.</translation>
    </message>
    <message>
      <source>Not drawn: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No dibujado: %1</translation>
    </message>
    <message>
      <source>Drawn without its photographs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dibujado sin sus fotografías: %1</translation>
    </message>
    <message>
      <source>No pictures with masks and poses of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sin imágenes con máscaras y poses de %1: %2</translation>
    </message>
    <message>
      <source>No sherds to export; select some first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay fragmentos que exportar; seleccione antes algunos.</translation>
    </message>
    <message>
      <source>The row has neither a number nor a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La fila no tiene ni número ni uuid.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto está en más de una fila de la tabla, en las líneas %1.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1 and %2 more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto está en más de una fila de la tabla, en las líneas %1 y %2 más.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is unusual for a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comprobar la unidad: %1 es inusual para un fragmento.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is far from the other values of this column.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comprobar la unidad: %1 está lejos de los demás valores de esta columna.</translation>
    </message>
    <message>
      <source>Not a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un uuid.</translation>
    </message>
    <message>
      <source>The number and the uuid belong to different sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número y el uuid pertenecen a fragmentos distintos.</translation>
    </message>
    <message>
      <source>A new sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento nuevo necesita su contexto.</translation>
    </message>
    <message>
      <source>A column of the table has no name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una columna de la tabla no tiene nombre.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; appears twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La columna '%1' está dos veces.</translation>
    </message>
    <message>
      <source>These places and batches are not in Ostraka&apos;s format.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos lugares y tandas no están en el formato de Ostraka.</translation>
    </message>
    <message>
      <source>Not a PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un archivo PLY.</translation>
    </message>
    <message>
      <source>Not a GLB file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un archivo GLB.</translation>
    </message>
    <message>
      <source>This export contains no sherd records (JSON); export it again with them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta exportación no contiene registros (JSON) de fragmentos; expórtela otra vez con ellos.</translation>
    </message>
    <message>
      <source>The project already has this sherd with other values, which it keeps; the differing values are added in fields that end in _in_%1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El proyecto tiene este fragmento con otros valores y los conserva; los que difieren se añaden en campos que acaban en _in_%1.</translation>
    </message>
    <message>
      <source>This file is not part of the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo no forma parte de la exportación.</translation>
    </message>
    <message>
      <source>The project has another file with this name; rename the export and import it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El proyecto tiene otro archivo con este nombre; cambie el nombre de la exportación e impórtela otra vez.</translation>
    </message>
    <message>
      <source>Not a sherd record (ostraka-sherd/1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es el registro de un fragmento (ostraka-sherd/1).</translation>
    </message>
    <message>
      <source>The measurement %1 has a unit other than %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La medida %1 tiene otra unidad que %2.</translation>
    </message>
    <message>
      <source>A value of the record has the wrong type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un valor del registro es de otro tipo del debido.</translation>
    </message>
    <message>
      <source>This is too large for one ZIP file; select fewer sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es demasiado grande para un solo archivo ZIP; seleccione menos fragmentos.</translation>
    </message>
    <message>
      <source>The mask is missing; expected a mask of %1 x %2 pixels under this name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falta la máscara; se esperaba con este nombre una máscara de %1 x %2 píxeles.</translation>
    </message>
    <message>
      <source>The mask cannot be read as a picture; expected a mask of %1 x %2 pixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La máscara no se puede leer como imagen; se esperaba una máscara de %1 x %2 píxeles.</translation>
    </message>
    <message>
      <source>The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size of its photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La máscara tiene %1 x %2 píxeles; se esperaba una máscara de %3 x %4 píxeles, el tamaño de su foto.</translation>
    </message>
    <message>
      <source>Masks from the plate need at least 3 photographs of a side; photograph more positions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las máscaras a partir del plato necesitan al menos 3 fotos de un lado; fotografíe más posiciones.</translation>
    </message>
    <message>
      <source>The photograph differs in size from its camera&apos;s images; use the original file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La foto no tiene el tamaño de las imágenes de su cámara; use el archivo original.</translation>
    </message>
    <message>
      <source>No sherd was found on the plate; check that the photographs show sherds that stand out from the plate, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se encontró ningún fragmento en el plato; compruebe que las fotos muestran fragmentos distintos del plato, o dé máscaras.</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 differs in size from the camera&apos;s other photographs; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>máscaras: la foto del plato vacío de la cámara %1 tiene otro tamaño que las demás fotos de la cámara; las máscaras se hacen sin ella</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows the plate at none of the positions; retake it at the first; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>máscaras: la foto del plato vacío de la cámara %1 no muestra el plato en ninguna de las posiciones; repítala en la primera; las máscaras se hacen sin ella</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows covered markers in %2; uncover them; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>máscaras: la foto del plato vacío de la cámara %1 muestra marcas tapadas en %2; destápelas; las máscaras se hacen sin ella</translation>
    </message>
    <message>
      <source>masks: a shadow that the other photographs do not show falls on the plate in %1; keep people and hands out of the light, and retake these if their masks look wrong</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>máscaras: una sombra que las demás fotos no tienen cae sobre el plato en %1; mantenga personas y manos fuera de la luz, y repita estas fotos si sus máscaras parecen mal</translation>
    </message>
    <message>
      <source>%1 (%2 % of the bare plate)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (%2 % del plato libre)</translation>
    </message>
    <message>
      <source>masks: flat objects that look like labels or scale bars are left out (%1); if there are sherds among them, add them to the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>máscaras: se omiten cosas planas que parecen etiquetas o escalas (%1); si entre ellas hay fragmentos, añádalos a las máscaras</translation>
    </message>
    <message>
      <source>The front scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo del anverso no contiene puntos.</translation>
    </message>
    <message>
      <source>The front scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo del anverso no tiene normales; un modelo las necesita para distinguir el exterior del interior.</translation>
    </message>
    <message>
      <source>The back scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo del reverso no contiene puntos.</translation>
    </message>
    <message>
      <source>The back scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo del reverso no tiene normales; un modelo las necesita para distinguir el exterior del interior.</translation>
    </message>
    <message>
      <source>The scans do not enclose a volume; their normals may point inward.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los escaneos no encierran ningún cuerpo; quizá sus normales apuntan hacia dentro.</translation>
    </message>
    <message>
      <source>Only a closed mesh can be simplified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Solo se puede simplificar una malla cerrada.</translation>
    </message>
    <message>
      <source>The deviation of a simplified mesh must be greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La desviación de una malla simplificada debe ser mayor que 0 mm.</translation>
    </message>
    <message>
      <source>The scan is too large for a model at this spacing; use a larger spacing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo es demasiado grande para un modelo con este espaciado; dé uno mayor.</translation>
    </message>
    <message>
      <source>The scans contain too few points that agree with each other for a model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los escaneos tienen muy pocos puntos que concuerden entre sí para un modelo.</translation>
    </message>
    <message>
      <source>This model is %1 mm in size, larger than any vessel, so its unit is probably not mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este modelo mide %1 mm, más que cualquier vasija, así que su unidad parece ser otra; expórtelo en mm.</translation>
    </message>
    <message>
      <source>This model is only %1 mm in size, smaller than any sherd, so its unit is probably not mm (%2); export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este modelo mide solo %1 mm, menos que cualquier fragmento, así que su unidad es probablemente otra (%2); expórtelo en mm.</translation>
    </message>
    <message>
      <source>Edge %1 is used more than once in the same direction.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La arista %1 se usa más de una vez en el mismo sentido.</translation>
    </message>
    <message>
      <source>Edge %1 has a face on one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La arista %1 tiene una cara solo a un lado.</translation>
    </message>
    <message>
      <source>Vertex %1 belongs to no face.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El vértice %1 no pertenece a ninguna cara.</translation>
    </message>
    <message>
      <source>Vertex %1 joins two separate fans of faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El vértice %1 une dos abanicos de caras separados.</translation>
    </message>
    <message>
      <source>The mesh has no faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La malla no tiene caras.</translation>
    </message>
    <message>
      <source>A face refers to a vertex that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cara nombra un vértice que no existe.</translation>
    </message>
    <message>
      <source>A face has the same vertex twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cara tiene dos veces el mismo vértice.</translation>
    </message>
    <message>
      <source>The scan&apos;s outline is not closed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El contorno del escaneo no se cierra.</translation>
    </message>
    <message>
      <source>A scan of fewer than 20 points has no outline.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un escaneo de menos de 20 puntos no tiene contorno.</translation>
    </message>
    <message>
      <source>A contour needs at least three points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un contorno necesita al menos tres puntos.</translation>
    </message>
    <message>
      <source>The evidence for a pair has no valid scans or value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los indicios de una pareja no tienen escaneos o valor válidos.</translation>
    </message>
    <message>
      <source>pairing: %1 stays unpaired: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>emparejamiento: %1 queda sin pareja: %2</translation>
    </message>
    <message>
      <source>No two outlines match, so the sizes of the two sides cannot be compared; provide a known length.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay dos contornos parecidos, así que no se pueden comparar los tamaños de los lados; dé una longitud conocida.</translation>
    </message>
    <message>
      <source>A candidate refers to a scan that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un candidato nombra un escaneo que no existe.</translation>
    </message>
    <message>
      <source>Not a candidate table; reprocess the batch, which redoes only its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto no es una tabla de candidatos; reprocese la tanda, solo se rehacen sus parejas.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, whose side has been reshot since; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión del %1 de %2 trata de %3, cuyo lado se volvió a fotografiar desde entonces; decida otra vez.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, which is no longer on the plate; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión del %1 de %2 trata de %3, que ya no está en el plato; decida otra vez.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 has no effect: the later decision of %3 by %4 concerns the same scan; withdraw one of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión del %1 de %2 no tiene efecto: la decisión del %3 de %4, que es posterior, trata del mismo escaneo; retire una de las dos.</translation>
    </message>
    <message>
      <source>A decision is of an unknown kind; a newer version of Ostraka wrote it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una decisión es de un tipo desconocido; la escribió una versión más nueva de Ostraka.</translation>
    </message>
    <message>
      <source>A pair needs one front and one back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una pareja necesita un anverso y un reverso.</translation>
    </message>
    <message>
      <source>Nothing is selected to set aside or reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay nada seleccionado que apartar o volver a fotografiar.</translation>
    </message>
    <message>
      <source>Fragments to merge must be of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los trozos que se unen deben ser del mismo lado.</translation>
    </message>
    <message>
      <source>A split needs one fragment and a line of at least 1 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una división necesita un trozo y una línea de al menos 1 mm.</translation>
    </message>
    <message>
      <source>Nothing is selected to withdraw.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay nada seleccionado que retirar.</translation>
    </message>
    <message>
      <source>A newer version of Ostraka wrote these decisions; use that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una versión más nueva de Ostraka escribió estas decisiones; use esa versión.</translation>
    </message>
    <message>
      <source>Decision %1 cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión %1 no se puede usar.</translation>
    </message>
    <message>
      <source>Its id is missing or used twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Su identificador falta o se usa dos veces.</translation>
    </message>
    <message>
      <source>It replaces more than %1 decisions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sustituye más de %1 decisiones.</translation>
    </message>
    <message>
      <source>It replaces a decision twice, or one that does not come before it in the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sustituye dos veces una decisión, o una que no está antes que ella en el archivo.</translation>
    </message>
    <message>
      <source>A batch can have at most %1 decisions; move this file elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una tanda puede tener como máximo %1 decisiones; mueva este archivo a otro lugar, o restablezca una copia.</translation>
    </message>
    <message>
      <source>Correct it, or restore a copy of the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Corríjala, o restablezca una copia del archivo.</translation>
    </message>
    <message>
      <source>Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un archivo de decisiones de Ostraka; muévalo a otro lugar, o restablezca una copia.</translation>
    </message>
    <message>
      <source>This decision is no longer in effect.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta decisión ya no vale.</translation>
    </message>
    <message>
      <source>There is no photograph of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay ninguna foto de este lado.</translation>
    </message>
    <message>
      <source>The outlines of these two sides cannot be overlaid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los contornos de estos dos lados no se pueden superponer.</translation>
    </message>
    <message>
      <source>%1 may be two sherds that touch, %2 and %3 of the other side: split it in the review, or move them apart and reshoot its side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 pueden ser dos fragmentos que se tocan, %2 y %3 del otro lado: divídalo en la revisión, o sepárelos y vuelva a fotografiar su lado.</translation>
    </message>
    <message>
      <source>Not a list of mask strokes; restore an earlier one, or delete it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto no es una lista de trazos en máscaras; restablezca una anterior o bórrela.</translation>
    </message>
    <message>
      <source>A mask holds at most 1,000 strokes and 100,000 points; nothing is saved until you undo some.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una máscara admite como máximo 1000 trazos y 100 000 puntos; no se guarda nada hasta que deshaga algunos.</translation>
    </message>
    <message>
      <source>This batch has no masks yet; process it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda aún no tiene máscaras; procésela antes.</translation>
    </message>
    <message>
      <source>This file does not state how well the rig fits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo no dice lo bien que se ajusta el equipo.</translation>
    </message>
    <message>
      <source>This calibration is for other cameras than those of the batch; calibrate the rig from its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta calibración es de otras cámaras que las de la tanda; calibre el equipo con sus propias fotos.</translation>
    </message>
    <message>
      <source>Masks cannot be made without plate.json; put masks next to the photographs, or choose a network (--masks MODEL.onnx).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sin plate.json no se pueden hacer las máscaras; ponga máscaras junto a las fotos, o elija una red (--masks MODEL.onnx).</translation>
    </message>
    <message>
      <source>The result has no scale: without plate.json no length is known, and lengths in mm are based on a guessed pixel size; photograph on a marker plate, lay the board of board.json beside the sherds on both sides, or mark a known length on both in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El resultado no tiene escala: sin plate.json no se conoce ninguna longitud, y las longitudes en mm parten de un tamaño de píxel supuesto; fotografíe sobre un plato de marcas, ponga el tablero de board.json junto a los fragmentos en ambos lados, o marque en ambos una longitud conocida en scale.json.</translation>
    </message>
    <message>
      <source>The output folder contains files that Ostraka did not write; choose another or an empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta de salida contiene archivos que Ostraka no escribió; elija otra o una vacía.</translation>
    </message>
    <message>
      <source>The file has changed since the batch&apos;s processing began; nothing made from it is kept. Process the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo ha cambiado desde que empezó el procesamiento de la tanda; no se conserva nada de lo hecho con él. Procese la tanda otra vez.</translation>
    </message>
    <message>
      <source>The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. Measure one; then correct the file, or leave the option out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las marcas tienen lados de %1 mm en este archivo, pero --marker-mm indica %2 mm. Mida una; después corrija el archivo u omita la opción.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta foto es idéntica a %1; se omite.</translation>
    </message>
    <message>
      <source>These results were made from the photographs of %1, not of %2; process %3 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos resultados proceden de las fotos de %1, no de las de %2; procese %3.</translation>
    </message>
    <message>
      <source>These results were not made from the photographs of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos resultados no proceden de las fotos de %1; procésela otra vez.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2 and %3 more. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Faltan en la carpeta de esta tanda fotos registradas (%1): %2 y %3 más. Devuélvalas a su sitio y reprocese la tanda.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Faltan en la carpeta de esta tanda fotos registradas (%1): %2. Devuélvalas a su sitio y reprocese la tanda.</translation>
    </message>
    <message>
      <source>The output folder contains another batch; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta de salida contiene otra tanda; elija otra carpeta.</translation>
    </message>
    <message>
      <source>The output folder contains other files; choose a new or empty folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta de salida contiene otros archivos; elija una carpeta nueva o vacía.</translation>
    </message>
    <message>
      <source>A pair refers to a scan that does not exist; delete this file and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una pareja nombra un escaneo que no existe; borre este archivo y reprocese la tanda.</translation>
    </message>
    <message>
      <source>Not a pair table; delete it and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto no es una tabla de parejas; bórrela y reprocese la tanda.</translation>
    </message>
    <message>
      <source>%1 and %2 were paired by hand, but their relative pose is unknown; align the back by hand in the review: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 y %2 se emparejaron a mano, pero no se conoce su pose relativa; alinee el reverso a mano en la revisión: %3</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; it is left out, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: la foto está borrosa: sus bordes tienen %2 píxeles de ancho, los de la más nítida de la cámara %3; se omite, repítala.</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: la foto está borrosa: sus bordes tienen %2 píxeles de ancho, los de la más nítida de la cámara %3; repítala.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the front side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de las %2 marcas del plato no están en ninguna foto del anverso (%3); las poses de las cámaras se apoyan en las otras, así que quite lo que las tapa.</translation>
    </message>
    <message>
      <source>All photographs of the back side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todas las fotografías del reverso están borrosas: incluso en la más nítida los bordes de las marcas miden %1 píxeles, por lo que sus escaneos son toscos. Revise el enfoque y la velocidad de obturación y vuelva a fotografiar este lado.</translation>
    </message>
    <message>
      <source>All photographs of the front side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todas las fotografías del anverso están borrosas: incluso en la más nítida los bordes de las marcas miden %1 píxeles, por lo que sus escaneos son toscos. Revise el enfoque y la velocidad de obturación y vuelva a fotografiar este lado.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the back side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de las %2 marcas del plato no están en ninguna foto del reverso (%3); las poses de las cámaras se apoyan en las otras, así que quite lo que las tapa.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 merges fragments that no longer exist; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión del %1 de %2 une trozos que ya no existen; decida otra vez.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 splits a fragment that does not exist, or misses it; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La decisión del %1 de %2 divide un trozo que no existe, o no lo alcanza; decida otra vez.</translation>
    </message>
    <message>
      <source>The program %1 is not installed, but the selected stereo needs it; install it, or use the built-in stereo.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa %1 no está instalado, y el estéreo elegido lo necesita; instálelo, o use el estéreo integrado.</translation>
    </message>
    <message>
      <source>The photographs show no marker plate, so finding the cameras needs the program %1, which is not installed; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos no muestran un plato de marcas, así que el programa %1 tiene que hallar las cámaras, y no está instalado; instálelo.</translation>
    </message>
    <message>
      <source>This needs about %1 GB of memory, but only %2 GB are free: the computer may stop the program or become very slow.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto necesitará unos %1 GB de memoria, y solo hay %2 GB libres: el ordenador puede detenerlo o volverse muy lento.</translation>
    </message>
    <message>
      <source>Close other programs, or process a draft.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cierre otros programas, o procese un borrador.</translation>
    </message>
    <message>
      <source>%1: the camera was not in the place that it had while the plate turned; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: la cámara no estaba donde se hallaba mientras giraba el plato; la foto se omite.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se desplazó unos %2 mm en el anverso: desde la posición %3 (pos%4) está en otro lugar; vuelva a fotografiar este lado.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se desplazó unos %2 mm en el anverso: desde %3 está en otro lugar; vuelva a fotografiar este lado.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se desplazó unos %2 mm en el reverso: desde la posición %3 (pos%4) está en otro lugar; vuelva a fotografiar este lado.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se desplazó unos %2 mm en el reverso: desde %3 está en otro lugar; vuelva a fotografiar este lado.</translation>
    </message>
    <message>
      <source>The output folder is inside the batch folder, to which Ostraka never writes; choose one next to it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta de salida está dentro de la carpeta de la tanda, donde Ostraka nunca escribe; elija una al lado.</translation>
    </message>
    <message>
      <source>Processing needs at least %1 GB of memory.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El procesamiento necesita al menos %1 GB de memoria.</translation>
    </message>
    <message>
      <source>Photographs cannot be reduced to less than 0.3 megapixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos no se pueden reducir a menos de 0,3 megapíxeles.</translation>
    </message>
    <message>
      <source>There is no such segmentation network; masks are 'auto', 'given' or an ONNX file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esa red de segmentación no existe; las máscaras son 'auto', 'given' o un archivo ONNX.</translation>
    </message>
    <message>
      <source>The fronts are not in mm: lengths in the result, although labelled mm, are in the fronts&apos; own unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los anversos no están en mm: las longitudes del resultado, aunque se llamen mm, están en la unidad propia de los anversos.</translation>
    </message>
    <message>
      <source>The pairs of this batch are not processed yet; process the batch: complete results are kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las parejas de esta tanda aún no están procesadas; procese la tanda: lo que está completo se conserva.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too small; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La escala no es correcta: %1, así que todas las medidas serían un %2 % demasiado pequeñas; mida la regla del plato y dé a plate.json su tamaño verdadero con 'ostraka plate --ruler-measured', o imprima otra vez el plato al 100 %; si el plato está bien, mida la longitud y ponga de nuevo sus marcas.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too large; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La escala no es correcta: %1, así que todas las medidas serían un %2 % demasiado grandes; mida la regla del plato y dé a plate.json su tamaño verdadero con 'ostraka plate --ruler-measured', o imprima otra vez el plato al 100 %; si el plato está bien, mida la longitud y ponga de nuevo sus marcas.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the front side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la longitud de %1 mm marcada en el anverso mide %2 ± %3 mm en las fotos (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the front side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La longitud de %1 mm en scale.json no se pudo comprobar: marque cada uno de sus extremos en dos o más fotos del anverso, tomadas desde distintas direcciones.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the back side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la longitud de %1 mm marcada en el reverso mide %2 ± %3 mm en las fotos (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the back side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La longitud de %1 mm en scale.json no se pudo comprobar: marque cada uno de sus extremos en dos o más fotos del reverso, tomadas desde distintas direcciones.</translation>
    </message>
    <message>
      <source>The folder cannot be read; choose a folder of PLY files.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede leer la carpeta; elija una carpeta con archivos PLY.</translation>
    </message>
    <message>
      <source>This folder contains no PLY files; each sherd&apos;s scan must be one PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay ningún archivo PLY en esta carpeta; el escaneo de cada fragmento debe ser un archivo PLY.</translation>
    </message>
    <message>
      <source>%1: 1 point without finite coordinates was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: se omitió 1 punto sin coordenadas finitas; revise la exportación.</translation>
    </message>
    <message>
      <source>%1: %2 points without finite coordinates were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: se omitieron %2 puntos sin coordenadas finitas; revise la exportación.</translation>
    </message>
    <message>
      <source>%1: 1 point far from all others, or at 0, 0, 0, was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: se omitió 1 punto lejos de todos los demás, o en 0, 0, 0; revise la exportación.</translation>
    </message>
    <message>
      <source>%1: %2 points far from all others, or at 0, 0, 0, were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: se omitieron %2 puntos lejos de todos los demás, o en 0, 0, 0; revise la exportación.</translation>
    </message>
    <message>
      <source>The scan has fewer than 100 points; rescan this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo tiene menos de 100 puntos; escanee otra vez este lado.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with nx, ny and nz.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo no tiene normales; expórtelo con nx, ny y nz.</translation>
    </message>
    <message>
      <source>The scan is %1 times its length away from the origin, so its coordinates are rounded; move it to the origin and export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo está a %1 veces su longitud del origen, así que sus coordenadas están redondeadas; llévelo al origen y expórtelo otra vez.</translation>
    </message>
    <message>
      <source>None of the scans can be used: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguno de los escaneos se puede usar: %1</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; their unit seems to be %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos escaneos miden %1 mm de mediana; parecen %2: %3.</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; no sherds are of that size: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos escaneos miden %1 mm de mediana; no hay fragmentos de ese tamaño: %2.</translation>
    </message>
    <message>
      <source>The median length of the fronts is %1 mm, of the backs %2 mm, so their units differ: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los anversos miden %1 mm de mediana, los reversos %2 mm, así que sus unidades difieren: %3.</translation>
    </message>
    <message>
      <source>centimetres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>centímetros</translation>
    </message>
    <message>
      <source>metres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>metros</translation>
    </message>
    <message>
      <source>micrometres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>micrómetros</translation>
    </message>
    <message>
      <source>export them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>expórtelos en mm</translation>
    </message>
    <message>
      <source>export them in mm, or use --scale free</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>expórtelos en mm, o use --scale free</translation>
    </message>
    <message>
      <source>Sherd %1 has no model: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El fragmento %1 no tiene modelo: %2</translation>
    </message>
    <message>
      <source>Sherd %1: %2 % of its surface is unseen by any camera and filled in, orange in its picture; reshoot it if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento %1: ninguna cámara vio el %2 % de su superficie; está rellenado, en naranja en la imagen. Vuelva a fotografiarlo si importa.</translation>
    </message>
    <message>
      <source>Sherd %1: its model has a hole right through it (%2 mm²). If the sherd has none, the photographs do not show that area; reshoot the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmento %1: su modelo tiene un agujero que lo atraviesa (%2 mm²). Si el fragmento no tiene ninguno, las fotografías no muestran ese lugar; vuelva a fotografiarlo.</translation>
    </message>
    <message>
      <source>The file lists %1, which is not in the batch; delete the file to find the cameras again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo nombra %1, que no está en la tanda; bórrelo y las cámaras se hallarán de nuevo.</translation>
    </message>
    <message>
      <source>This photograph has no mask; provide one for each photograph to be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta foto no tiene máscara; dé una para cada foto que se vaya a usar.</translation>
    </message>
    <message>
      <source>This photograph is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta foto no se usa.</translation>
    </message>
    <message>
      <source>Photographs of the front side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías del anverso omitidas porque COLMAP no encontró su pose: %1.</translation>
    </message>
    <message>
      <source>Photographs of the back side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías del reverso omitidas porque COLMAP no encontró su pose: %1.</translation>
    </message>
    <message>
      <source>The rig was not used: without plate.json the poses come from COLMAP.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo no se usó: sin plate.json las poses vienen de COLMAP.</translation>
    </message>
    <message>
      <source>%1: The mask marks no sherd in this photograph; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: la máscara no marca ningún fragmento en esta foto; se omite.</translation>
    </message>
    <message>
      <source>If it shows sherds, retake it or edit its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Si hay fragmentos en ella, repítala o edite su máscara.</translation>
    </message>
    <message>
      <source>Photographs of the front side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías del anverso cuyas máscaras marcan fragmentos: %1; hacen falta al menos 3.</translation>
    </message>
    <message>
      <source>Photographs of the back side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías del reverso cuyas máscaras marcan fragmentos: %1; hacen falta al menos 3.</translation>
    </message>
    <message>
      <source>Check the masks, and whether sherds were on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Revise las máscaras, y si había fragmentos en el plato.</translation>
    </message>
    <message>
      <source>Fewer than 10 fracture points match; start from a better pose.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Coinciden menos de 10 puntos de las fracturas; parta de una pose mejor.</translation>
    </message>
    <message>
      <source>No photograph shows the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguna fotografía muestra el fragmento.</translation>
    </message>
    <message>
      <source>Not every vertex has a place in the texture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No todos los vértices tienen un lugar en la textura.</translation>
    </message>
    <message>
      <source>The texture of this GLB model cannot be read, so the model is used without it; reprocess its batch to write the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede leer la textura de este modelo GLB, por lo que el modelo se usa sin ella; vuelva a procesar su lote para escribir el archivo de nuevo.</translation>
    </message>
    <message>
      <source>The texture of this model has more than 67,108,864 pixels, so the model is used without it; export the model with a smaller one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La textura de este modelo tiene más de 67 108 864 píxeles, por lo que el modelo se usa sin ella; exporte el modelo con una más pequeña.</translation>
    </message>
    <message>
      <source>The texture of sherd %1 lacks a photograph: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A la textura del fragmento %1 le falta una fotografía: %2</translation>
    </message>
    <message>
      <source>Sherd %1 has no photographic texture: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El fragmento %1 no tiene textura fotográfica: %2</translation>
    </message>
    <message>
      <source>The colour chart is overexposed or underexposed (clipped patches: %1), so it is not used and colours stay as photographed; reshoot it at another exposure.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carta de color está sobreexpuesta o subexpuesta (parches recortados: %1), así que no se usa y los colores quedan como se fotografiaron; vuelva a fotografiarla con otra exposición.</translation>
    </message>
    <message>
      <source>The colour chart is shaded, bent or partly hidden, so it is not used and colours stay as photographed; reshoot it flat, whole and evenly lit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carta de color está en sombra, doblada o parcialmente tapada, así que no se usa y los colores quedan como se fotografiaron; vuelva a fotografiarla plana, entera y con luz uniforme.</translation>
    </message>
    <message>
      <source>colours: corrected by the colour chart in %1 photographs; its patches differ from their reference by %2 (median) and %3 (95 %), CIEDE2000</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>colores: corregidos según la carta de color en %1 fotografías; sus parches difieren de su referencia en %2 (mediana) y %3 (95 %), CIEDE2000</translation>
    </message>
    <message>
      <source>The chosen registration method did not converge; use the default method, or align the back by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El método de registro elegido no convergió; use el método predeterminado o alinee el reverso a mano.</translation>
    </message>
    <message>
      <source>Too few fracture points for the chosen registration method; use the default method.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay muy pocos puntos de fractura para el método de registro elegido; use el método predeterminado.</translation>
    </message>
    <message>
      <source>No start pose was given for the registration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se dio ninguna pose inicial para el registro de los lados.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El escaneo no tiene normales; expórtelo con normales.</translation>
    </message>
    <message>
      <source>Fewer than 50 points are on the fracture; rescan the sherd including its fracture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay menos de 50 puntos en la fractura; escanee otra vez el fragmento con su fractura.</translation>
    </message>
    <message>
      <source>%1: The board was not detected; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: no se detectó el tablero; esta imagen se omite.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El diccionario %1 tiene muy pocas marcas para el tablero.</translation>
    </message>
    <message>
      <source>A grid of markers needs 'dictionary', 'markers_x', 'markers_y', 'marker_length' and 'marker_separation'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cuadrícula de marcas necesita 'dictionary', 'markers_x', 'markers_y', 'marker_length' y 'marker_separation'.</translation>
    </message>
    <message>
      <source>Nothing to calibrate from: put photographs of the plate at each position into &apos;front&apos; (cam0_pos00.jpg and so on) and pictures of the board into &apos;calib&apos;, and copy plate.json and board.json next to them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay nada con que calibrar: fotografíe el plato en cada posición en 'front' (cam0_pos00.jpg, etc.) y el tablero en 'calib', y copie plate.json y board.json al lado.</translation>
    </message>
    <message>
      <source>No pictures of the board found; put them here or into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay imágenes del tablero; póngalas aquí o en 'calib'.</translation>
    </message>
    <message>
      <source>It is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se aparta.</translation>
    </message>
    <message>
      <source>%1: its size differs from that of the first picture; it is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: su tamaño no es el de la primera; se aparta.</translation>
    </message>
    <message>
      <source>The bundle adjustment of the rig did not converge; check that plate.json and board.json describe what was photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El ajuste de haces del equipo no convergió; compruebe que plate.json y board.json describen lo que se fotografió.</translation>
    </message>
    <message>
      <source>The file does not describe how the sheets bend; delete it to measure them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo no describe cómo están curvadas las hojas; bórrelo y se medirán de nuevo.</translation>
    </message>
    <message>
      <source>The file does not describe what the sherds stand on; delete it to determine this again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo no describe sobre qué están los fragmentos; bórrelo y se determinará de nuevo.</translation>
    </message>
    <message>
      <source>The sheet's markers can be read in %1 of %2 photographs of the %3 side; at least 3 are needed. Check that plate.json describes this sheet, that the photographs are not mirrored, and that most of the markers are in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las marcas de la hoja se leen en %1 de %2 fotografías del lado %3; se necesitan al menos 3. Compruebe que plate.json describe esta hoja, que las fotografías no están invertidas y que la mayoría de las marcas están en la imagen.</translation>
    </message>
    <message>
      <source>%1: %2 of the sheet&apos;s markers can be read, too few for a pose; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: se leen %2 marcas de la hoja, muy pocas para una pose; la foto se omite.</translation>
    </message>
    <message>
      <source>Photographs that show too few of the sheet&apos;s markers for a pose are left out (%1 and %2 more); check that they show this sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se omiten fotografías que muestran muy pocas marcas de la hoja para una pose (%1 y %2 más); compruebe si muestran esta hoja.</translation>
    </message>
    <message>
      <source>%1: most of the sheet&apos;s markers are not where the other photographs place them; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: la mayoría de las marcas de la hoja no están donde las sitúan las demás fotografías; la foto se omite.</translation>
    </message>
    <message>
      <source>Only one side was photographed: its %1 scans are open surfaces without a back; they are in 'unpaired'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Solo se fotografió un lado: sus %1 escaneos son superficies abiertas sin reverso; están en 'unpaired'.</translation>
    </message>
    <message>
      <source>plate.json is missing, so the plate&apos;s markers cannot be used; copy the file that &apos;ostraka plate&apos; wrote with the plate into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falta plate.json, así que no se pueden usar las marcas del plato; copie en esta carpeta el archivo que 'ostraka plate' escribió con el plato.</translation>
    </message>
    <message>
      <source>The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig is calibrated from this batch instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo conocido no tiene una cámara %1 con imágenes de %2 x %3 píxeles; en su lugar se calibra con esta tanda.</translation>
    </message>
    <message>
      <source>Its lens is estimated from the plate's markers instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En su lugar, su objetivo se estima con las marcas del plato.</translation>
    </message>
    <message>
      <source>The lens of camera %1 is unknown: no usable pictures of the board and no plate markers were found; add pictures of the board to &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se conoce el objetivo de la cámara %1: no hay imágenes útiles del tablero ni marcas del plato; añada imágenes del tablero a 'calib'.</translation>
    </message>
    <message>
      <source>The lens of camera %1 was estimated from the plate&apos;s markers alone; add 12 pictures of the board to &apos;calib&apos; for accurate measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El objetivo de la cámara %1 se estimó solo con las marcas del plato; para medidas exactas, añada 12 imágenes del tablero a 'calib'.</translation>
    </message>
    <message>
      <source>The plate's markers were found in %1 of %2 photographs, too few for a pose of each side; check that plate.json belongs to this plate and that the markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las marcas del plato se encontraron en %1 de %2 fotos, muy pocas para la pose de cada lado; compruebe que plate.json es de este plato y que las marcas están iluminadas y dentro de la imagen.</translation>
    </message>
    <message>
      <source>No photograph of camera %1 shows two markers of the plate; all its photographs are left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguna foto de la cámara %1 muestra dos marcas del plato; se omiten todas sus fotos.</translation>
    </message>
    <message>
      <source>The known rig no longer fits: camera %1 misses the markers by %2 px. The camera poses are re-estimated for this batch; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo conocido ya no se ajusta: la cámara %1 yerra las marcas por %2 px. Las poses de las cámaras se estiman de nuevo para esta tanda; calibre otra vez el equipo.</translation>
    </message>
    <message>
      <source>%1: none of its %2 markers is where this camera sees them at this position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: ninguna de sus %2 marcas está donde esta cámara las ve en esta posición.</translation>
    </message>
    <message>
      <source>It has another photograph&apos;s name or was taken while the plate was turning; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lleva el nombre de otra foto, o se tomó mientras el plato giraba; se omite.</translation>
    </message>
    <message>
      <source>%1: no marker is visible; check that the photograph shows this position. If not, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: no se ve ninguna marca; compruebe que la foto muestra esta posición. Si no, repítala.</translation>
    </message>
    <message>
      <source>Photographs of the front side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías del anverso con pose conocida: %1; hacen falta al menos 3. Compruebe que las marcas del plato están iluminadas y dentro de la imagen.</translation>
    </message>
    <message>
      <source>Photographs of the back side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías del reverso con pose conocida: %1; hacen falta al menos 3. Compruebe que las marcas del plato están iluminadas y dentro de la imagen.</translation>
    </message>
    <message>
      <source>Camera %1 sees fewer than six of the plate&apos;s markers at position %2; check lighting and focus there and that nothing covers the markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 ve menos de seis marcas del plato en la posición %2; revise allí la luz y el enfoque, y que no haya nada sobre las marcas.</translation>
    </message>
    <message>
      <source>Positions photographed: %1; photograph at least four around the full turn to determine the axis.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Posiciones fotografiadas: %1; fotografíe al menos cuatro en la vuelta completa para determinar el eje.</translation>
    </message>
    <message>
      <source>Fewer than eight markers were detected, so no distance could be held out of the fit: the scale is not checked.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se vieron menos de ocho marcas, así que no se pudo reservar ninguna distancia para el control: la escala no está comprobada.</translation>
    </message>
    <message>
      <source>Markers %1 and %2: you measured %3 mm, plate.json says %4 mm (%5 %); measure the plate&apos;s ruler and regenerate plate.json with &apos;ostraka plate --ruler-measured&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entre las marcas %1 y %2 usted midió %3 mm, según plate.json son %4 mm (%5 %); mida la regla del plato y haga de nuevo plate.json con 'ostraka plate --ruler-measured'.</translation>
    </message>
    <message>
      <source>Not usable: camera %1 misses the plate&apos;s markers by a median of %2 px; check that it did not move between the photographs and that plate.json belongs to this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No utilizable: la cámara %1 yerra las marcas del plato por %2 px de mediana; compruebe que no se movió entre las fotos y que plate.json es de este plato.</translation>
    </message>
    <message>
      <source>Not usable: the scale is wrong.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No utilizable: la escala no es correcta.</translation>
    </message>
    <message>
      <source>Good: lenses, camera poses and scale are determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bien: objetivos, poses de las cámaras y escala están determinados.</translation>
    </message>
    <message>
      <source>Usable for a trial only: the lens of camera %1 comes from the plate&apos;s markers alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Utilizable solo para una prueba: el objetivo de la cámara %1 procede solo de las marcas del plato.</translation>
    </message>
    <message>
      <source>Usable, but a focal length is uncertain by more than a thousandth.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Utilizable, pero una distancia focal es incierta en más de una milésima.</translation>
    </message>
    <message>
      <source>Usable; the steps below improve it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Utilizable; los pasos de abajo lo mejoran.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: distancia focal %2 px (%3 %).</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: distancia focal %2 px (%3 %), %4 imágenes del tablero con %5 px, la peor %6 con %7 px, inclinadas hasta %8 grados.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), median error at the plate&apos;s markers %4 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: distancia focal %2 px (%3 %), error mediano en las marcas del plato %4 px.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees, median error at the plate&apos;s markers %9 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: distancia focal %2 px (%3 %), %4 imágenes del tablero con %5 px, la peor %6 con %7 px, inclinadas hasta %8 grados, error mediano en las marcas del plato %9 px.</translation>
    </message>
    <message>
      <source>Camera %1: take 12 pictures of the board, near and far, in all corners of the picture, tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: tome 12 imágenes del tablero, de cerca y de lejos, en todas las esquinas de la imagen, inclinado de 20 a 45 grados en distintas direcciones.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: solo 1 imagen muestra el tablero; tome al menos 8, mejor 12.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: solo %2 imágenes muestran el tablero; tome al menos 8, mejor 12.</translation>
    </message>
    <message>
      <source>Camera %1: the board barely reaches the %2 of the picture; add pictures with the board there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: el tablero apenas llega a estas partes de la imagen: %2; añada imágenes con el tablero allí.</translation>
    </message>
    <message>
      <source>upper left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arriba a la izquierda</translation>
    </message>
    <message>
      <source>upper middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arriba en el centro</translation>
    </message>
    <message>
      <source>upper right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arriba a la derecha</translation>
    </message>
    <message>
      <source>left middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en el centro a la izquierda</translation>
    </message>
    <message>
      <source>middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en el centro</translation>
    </message>
    <message>
      <source>right middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en el centro a la derecha</translation>
    </message>
    <message>
      <source>lower left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abajo a la izquierda</translation>
    </message>
    <message>
      <source>lower middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abajo en el centro</translation>
    </message>
    <message>
      <source>lower right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abajo a la derecha</translation>
    </message>
    <message>
      <source>Camera %1: no picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: ninguna imagen muestra el tablero inclinado más de 20 grados; tome al menos cuatro, inclinadas hacia distintos lados.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: solo 1 imagen muestra el tablero inclinado más de 20 grados; tome al menos cuatro, inclinadas hacia distintos lados.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: solo %2 imágenes muestran el tablero inclinado más de 20 grados; tome al menos cuatro, inclinadas hacia distintos lados.</translation>
    </message>
    <message>
      <source>Reprojection error %1 px over the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Error de reproyección %1 px en las marcas del plato.</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: las marcas %1 y %2, reservadas para el control, están a %3 mm en vez de %4 (%5 mm, %6 %).</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, measured by hand as %3 mm between the midpoints of their outer edges, are %4 mm apart in the photographs (%5 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: las marcas %1 y %2, a mano %3 mm entre los centros de sus bordes exteriores, están a %4 mm en las fotos (%5 %).</translation>
    </message>
    <message>
      <source>Set aside: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apartado: %1</translation>
    </message>
    <message>
      <source>The lens is known but the camera poses are not, so no rig can be saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se conoce el objetivo, pero no las poses de las cámaras: no se puede guardar ningún equipo.</translation>
    </message>
    <message>
      <source>Not usable: the focal length is not determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No utilizable: la distancia focal no está determinada.</translation>
    </message>
    <message>
      <source>Photograph the plate with its markers too: put one picture per camera and position into &apos;front&apos; (cam0_pos00.jpg and so on) next to plate.json, and the board&apos;s pictures into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografíe también el plato con sus marcas: ponga una imagen por cámara y posición en 'front' (cam0_pos00.jpg, etc.) junto a plate.json, y las imágenes del tablero en 'calib'.</translation>
    </message>
    <message>
      <source>Marker %1 of the known length is visible in fewer than two photographs; choose two markers of the plate that the photographs show.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La marca %1 de la longitud conocida se ve en menos de dos fotos; elija dos marcas del plato que muestren las fotos.</translation>
    </message>
    <message>
      <source>A known length needs two different markers and a value greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una longitud conocida necesita dos marcas distintas y un valor mayor que 0 mm.</translation>
    </message>
    <message>
      <source>Folder not found; choose one with photographs of the plate or of the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se encontró la carpeta; elija una con fotos del plato o del tablero.</translation>
    </message>
    <message>
      <source>The lens %1 is not known; it is 'standard' or 'fisheye'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El objetivo %1 no se conoce; es 'standard' o 'fisheye'.</translation>
    </message>
    <message>
      <source>Numbers in 'dist': %1; a lens has 0, 4, 5, 8 or 12 in OpenCV's order, a fisheye has 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Números en 'dist': %1; un objetivo tiene 0, 4, 5, 8 o 12 en el orden de OpenCV, un ojo de pez tiene 4.</translation>
    </message>
    <message>
      <source>No lens has the numbers in 'dist': its picture folds near the middle. Check their order.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ningún objetivo tiene los números de 'dist': su imagen se pliega cerca del centro. Compruebe su orden.</translation>
    </message>
    <message>
      <source>The camera of '%1' has no valid K, R, t or size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara de '%1' no tiene K, R, t o tamaño válido.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A una imagen le falta file, width, height, K, R o t.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A una imagen le falta file, width, height, K, R o t (%1).</translation>
    </message>
    <message>
      <source>The camera file has no list &apos;images&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo de cámaras no contiene una lista 'images'.</translation>
    </message>
    <message>
      <source>COLMAP&apos;s camera %1 has the model &apos;%2&apos; or values that Ostraka does not support; use the model OPENCV instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 de COLMAP tiene el modelo '%2' o valores que Ostraka no admite; use OPENCV.</translation>
    </message>
    <message>
      <source>COLMAP's model has no camera for the image '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El modelo de COLMAP no tiene cámara para la imagen '%1'.</translation>
    </message>
    <message>
      <source>The file is damaged or not in COLMAP&apos;s format; run COLMAP again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo está dañado o no está en el formato de COLMAP; ejecute COLMAP otra vez.</translation>
    </message>
    <message>
      <source>The pose of this photograph is estimated without its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La pose de esta foto se estima sin su máscara.</translation>
    </message>
    <message>
      <source>Without plate.json, poses come from COLMAP, which is not installed; install the package &apos;colmap&apos; or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sin plate.json las poses vienen de COLMAP, que no está instalado; instale el paquete 'colmap' o fotografíe sobre un plato de marcas.</translation>
    </message>
    <message>
      <source>COLMAP found poses for %1 of %2 photographs, too few; provide masks or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP encontró la pose de %1 de %2 fotos, muy pocas; dé máscaras o fotografíe sobre un plato de marcas.</translation>
    </message>
    <message>
      <source>The scale is wrong: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %); check that plate.json belongs to this plate, that the plate is printed and glued without distortion, and that a known rig was calibrated with it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La escala no es correcta: las marcas %1 y %2, reservadas para el control, están a %3 mm en vez de %4 (%5 mm, %6 %); compruebe que plate.json es de este plato, que está impreso y pegado sin deformación, y que un equipo conocido se calibró con él.</translation>
    </message>
    <message>
      <source>Relative to camera %1, camera %2 has moved by %3 mm and turned by %4 degrees since the rig was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Respecto a la cámara %1, la cámara %2 se ha movido %3 mm y ha girado %4 grados desde que se calibró el equipo.</translation>
    </message>
    <message>
      <source>%1: the board was not detected; the picture is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: no se detectó el tablero; la imagen se aparta.</translation>
    </message>
    <message>
      <source>The marker dictionary &apos;%1&apos; is unknown; use one such as DICT_4X4_100.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El diccionario de marcas '%1' no se conoce; use uno como DICT_4X4_100.</translation>
    </message>
    <message>
      <source>The markers&apos; side must be between 5 and 200 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El lado de las marcas debe estar entre 5 y 200 mm.</translation>
    </message>
    <message>
      <source>The plate&apos;s diameter must be between 1 and 2000 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El diámetro del plato debe estar entre 1 y 2000 mm.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En un plato de %2 mm caben menos de seis marcas de %1 mm; caben marcas de %3 mm.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En un plato de %2 mm caben menos de seis marcas de %1 mm; haga el plato más grande.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marcas de %1 mm no dejan sitio para un fragmento en un plato de %2 mm; caben marcas de %3 mm.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marcas de %1 mm no dejan sitio para un fragmento en un plato de %2 mm; haga el plato más grande.</translation>
    </message>
    <message>
      <source>The printer&apos;s margin must be between 0 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El margen de la impresora debe estar entre 0 y 40 mm.</translation>
    </message>
    <message>
      <source>The sheets&apos; overlap must be between 5 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El solape de las hojas debe estar entre 5 y 40 mm.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El diccionario %1 tiene muy pocas marcas para este plato.</translation>
    </message>
    <message>
      <source>The measured ruler length must be in mm and within the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La longitud medida de la regla debe estar en mm y caber en el plato.</translation>
    </message>
    <message>
      <source>The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. Print the file at 100 %, without &apos;fit to page&apos;, and measure again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La regla de este plato está dibujada con %1 mm, %2 mm se aparta más de una décima parte; imprima el archivo al 100 %, sin 'ajustar a la página', y mida otra vez.</translation>
    </message>
    <message>
      <source>Camera %1 has a covariance of the wrong size; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 tiene una covarianza de tamaño erróneo; calibre otra vez el equipo.</translation>
    </message>
    <message>
      <source>Another version of Ostraka wrote this rig; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otra versión de Ostraka escribió este equipo; calíbrelo otra vez.</translation>
    </message>
    <message>
      <source>Camera %1 appears twice in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 aparece dos veces en el equipo.</translation>
    </message>
    <message>
      <source>The rig has more than %1 positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo tiene más de %1 posiciones; calíbrelo otra vez.</translation>
    </message>
    <message>
      <source>Position %1 appears twice in the rig; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La posición %1 aparece dos veces en el equipo; calíbrelo otra vez.</translation>
    </message>
    <message>
      <source>The rig&apos;s lengths are not in mm; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las longitudes del equipo no están en mm; calíbrelo otra vez.</translation>
    </message>
    <message>
      <source>Camera %1 has pictures of %2 x %3 pixels, which no camera takes; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara %1 tiene imágenes de %2 x %3 píxeles, que ninguna cámara toma; calibre el equipo otra vez.</translation>
    </message>
    <message>
      <source>Not a rig file (RIG.json); recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto no es un archivo de equipo (RIG.json); calibre otra vez el equipo.</translation>
    </message>
    <message>
      <source>The rig has no camera; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo no tiene cámara; calíbrelo otra vez.</translation>
    </message>
    <message>
      <source>This file already exists and is not a rig; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo ya existe y no es un equipo; elija otro nombre.</translation>
    </message>
    <message>
      <source>The log cannot be written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede escribir el registro.</translation>
    </message>
    <message>
      <source>A process cannot be started.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede iniciar ningún proceso.</translation>
    </message>
    <message>
      <source>The program&apos;s exit status is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se conoce el estado de salida del programa.</translation>
    </message>
    <message>
      <source>The program cannot be started; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se puede iniciar el programa; instálelo.</translation>
    </message>
    <message>
      <source>%1 ended with an error; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 terminó con un error; su salida está en este archivo.</translation>
    </message>
    <message>
      <source>A small object of %1 mm at x %2, y %3 mm was left out; if it is a sherd, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una migaja de %1 mm en x %2, y %3 mm se omitió; si es un fragmento, fotografíelo solo.</translation>
    </message>
    <message>
      <source>A flat object at x %1, y %2 mm was left out; it may be a marker or dirt on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un objeto plano en x %1, y %2 mm se omitió; puede ser una marca o suciedad en el plato.</translation>
    </message>
    <message>
      <source>Two sherds touch at x %1, y %2 mm and were split there; leave a finger&apos;s width between sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos fragmentos se tocan en x %1, y %2 mm y se separaron ahí; deje un dedo de separación entre fragmentos.</translation>
    </message>
    <message>
      <source>The plate&apos;s point cloud has no normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La nube de puntos del plato no tiene normales.</translation>
    </message>
    <message>
      <source>No sherd was found on the front side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se encontró ningún fragmento en el anverso; revise sus máscaras y fotos.</translation>
    </message>
    <message>
      <source>No sherd was found on the back side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se encontró ningún fragmento en el reverso; revise sus máscaras y fotos.</translation>
    </message>
    <message>
      <source>This COLMAP was built without CUDA, which its dense stereo needs; install one with CUDA, or use --dense builtin, which needs neither.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este COLMAP se compiló sin CUDA, que su estéreo denso necesita; instale uno con CUDA, o use --dense builtin, que no necesita ni lo uno ni lo otro.</translation>
    </message>
    <message>
      <source>The masks of the views show no common object; check masks, cameras and bounds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las máscaras de las vistas no muestran un objeto común; revise máscaras, cámaras y límites.</translation>
    </message>
    <message>
      <source>InterfaceCOLMAP wrote no scene; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>InterfaceCOLMAP no escribió ninguna escena; su salida está en este archivo.</translation>
    </message>
    <message>
      <source>Stereo needs at least 3 photographs with known cameras.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El estéreo necesita al menos 3 fotos con cámaras conocidas.</translation>
    </message>
    <message>
      <source>The photograph or its mask differs in size from its camera&apos;s images; use photographs of the size that the camera was calibrated with.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La foto o su máscara tiene otro tamaño que las imágenes de su cámara; use fotos del tamaño con el que se calibró la cámara.</translation>
    </message>
    <message>
      <source>The photograph differs in size from the images that its camera was calibrated with; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La foto tiene otro tamaño que las imágenes con las que se calibró su cámara; use la foto original.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La máscara tiene otro tamaño que su foto.</translation>
    </message>
    <message>
      <source>%1 found no points of the object; its output is in this file, and --dense builtin needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 no encontró puntos del objeto; su salida está en este archivo, y --dense builtin no necesita otro programa.</translation>
    </message>
    <message>
      <source>%1 wrote points without normals; install a newer version, or use --dense builtin.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 escribió puntos sin normales; instale una versión más nueva, o use --dense builtin.</translation>
    </message>
    <message>
      <source>The program %1 is not on the PATH, but --dense %2 needs it; install it, or use --dense builtin, which needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa %1 no está en el PATH, pero --dense %2 lo necesita; instálelo, o use --dense builtin, que no necesita otro programa.</translation>
    </message>
    <message>
      <source>No two views agree on any surface point; check cameras and masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No hay dos vistas que coincidan en ningún punto de la superficie; revise cámaras y máscaras.</translation>
    </message>
    <message>
      <source>The %1 sherds do not fit on the plate; use fewer, or another seed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los %1 fragmentos no caben en el plato; pida menos, u otra semilla.</translation>
    </message>
    <message>
      <source>sherds must be between 1 and 40.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de fragmentos debe estar entre 1 y 40.</translation>
    </message>
    <message>
      <source>width must be between 160 and 8192 pixels and divisible by 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El ancho debe estar entre 160 y 8192 píxeles y ser divisible entre 4.</translation>
    </message>
    <message>
      <source>near_duplicates are groups of two: at most half the number of sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>near_duplicates son grupos de dos: como mucho la mitad del número de fragmentos.</translation>
    </message>
    <message>
      <source>The rig needs a camera and at least four positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El equipo necesita una cámara y al menos cuatro posiciones; calíbrelo otra vez.</translation>
    </message>
    <message>
      <source>The virtual camera has no setting %1 of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara virtual no tiene un ajuste %1 de %2.</translation>
    </message>
    <message>
      <source>The camera has taken no photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cámara no ha tomado ninguna foto.</translation>
    </message>
    <message>
      <source>COLMAP cannot align these photographs; its output is in this file. Check that all show the same sherds with large overlap, or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP no puede alinear estas fotografías; su salida está en este archivo. Compruebe que todas muestran los mismos fragmentos con mucho solape, o fotografíe sobre un plato de marcas.</translation>
    </message>
    <message>
      <source>This model is missing; reprocess its batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falta este modelo; reprocese su tanda.</translation>
    </message>
    <message>
      <source>This sherd is void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este fragmento está anulado.</translation>
    </message>
    <message>
      <source>This sherd is void; reason: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este fragmento está anulado; motivo: %1</translation>
    </message>
    <message>
      <source>%1 is void and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está anulado y se ha omitido.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %); check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que se tomó por el labio apenas lo parece (%1 %); revise cómo está orientado el fragmento.</translation>
    </message>
    <message>
      <source>Ø %1 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm</translation>
    </message>
    <message>
      <source>Ø %1 cm (95 %: %2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm (95 %: de %2 a %3)</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 % del borde conservado</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 % del borde conservado (de %2 a %3)</translation>
    </message>
    <message>
      <source>wall %1 mm (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pared %1 mm (de %2 a %3)</translation>
    </message>
    <message>
      <source>wall %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pared %1 mm</translation>
    </message>
    <message>
      <source>A bag belongs to a context; enter the context first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una bolsa pertenece a un contexto; escriba primero el contexto.</translation>
    </message>
    <message>
      <source>Context %1 has no bag %2; change or clear the bag at the same time.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El contexto %1 no tiene ninguna bolsa %2; cambie o vacíe la bolsa al mismo tiempo.</translation>
    </message>
    <message>
      <source>There is no bag %1 in context %2 yet; enter it during capture or import a table of contexts that contains it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todavía no hay ninguna bolsa %1 en el contexto %2; escríbala en la captura o importe una tabla de contextos que la contenga.</translation>
    </message>
    <message>
      <source>The edge taken as the lip may be a fracture (%1 % that it is the lip), and the diameter may be wrong; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que se tomó por labio puede ser una fractura (%1 % de que sea el labio) y el diámetro erróneo; compruebe cómo está orientado el fragmento.</translation>
    </message>
    <message>
      <source>This batch is still being photographed; it is processed afterwards.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda se está fotografiando; se procesa después.</translation>
    </message>
    <message>
      <source>Joins with sherds that are not in the export or were not imported are left out: %1; enter them by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se omiten las uniones con fragmentos que no están en la exportación o no se importaron: %1; escríbalas a mano.</translation>
    </message>
    <message>
      <source>'%1' can be read as %2 or as %3; write one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» se puede leer como %2 o como %3; escriba uno de los dos.</translation>
    </message>
    <message>
      <source>The batch is not fully processed; let the queue process it, then review its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tanda no está procesada del todo; deje que la cola la procese y después revise sus parejas.</translation>
    </message>
    <message>
      <source>%1 was retaken after its mask was edited; the strokes on the earlier photograph are left out. Check its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 se repitió después de editar su máscara; los trazos sobre la fotografía anterior se omiten. Revise su máscara.</translation>
    </message>
    <message>
      <source>Joins with rows that were not imported are left out: %1; correct these rows, then import the table again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se omiten las uniones con filas que no se importaron: %1; corrija esas filas e importe la tabla otra vez.</translation>
    </message>
    <message>
      <source>The sherd has a void_reason, so it is void; write void here, or %1 under void_reason.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El fragmento tiene un void_reason, así que está anulado; escriba void aquí, o %1 en void_reason.</translation>
    </message>
    <message>
      <source>A sherd is void only with a reason; write it under void_reason, or correct the state.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un fragmento solo está anulado con un motivo; escríbalo en void_reason o corrija el estado.</translation>
    </message>
    <message>
      <source>The state must be draft, numbered or void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El estado debe ser draft, numbered o void.</translation>
    </message>
    <message>
      <source>Rows that are not imported leave their numbers free: %1; correct and import them before you assign new numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las filas que no se importan dejan libres sus números: %1; corríjalas e impórtelas antes de asignar números nuevos.</translation>
    </message>
    <message>
      <source>The number %1 was entered for a sherd of %2, which is not processed yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 se escribió para un fragmento de %2, que aún no está procesada.</translation>
    </message>
    <message>
      <source>A sheet of an earlier drawing already exists and is not overwritten; choose another name, or delete that sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya hay una hoja de un dibujo anterior y no se sobrescribe; elija otro nombre o borre esa hoja.</translation>
    </message>
    <message>
      <source>Enter a number after =.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba un número tras =.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es una carpeta, no un archivo; elija un archivo.</translation>
    </message>
    <message>
      <source>This is a pipe, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es una tubería, no un archivo; elija un archivo.</translation>
    </message>
    <message>
      <source>This is a socket, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un socket, no un archivo; elija un archivo.</translation>
    </message>
    <message>
      <source>This is a device, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es un dispositivo, no un archivo; elija un archivo.</translation>
    </message>
    <message>
      <source>A link has taken the place of this folder&apos;s lock file; delete the link.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un enlace ha ocupado el lugar del archivo de bloqueo de esta carpeta; borre el enlace.</translation>
    </message>
    <message>
        <source>A link has taken the place of a folder of a project or of a result; what it leads to was not touched. Delete the link, or move the folder itself here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Un enlace ha ocupado el lugar de una carpeta de un proyecto o de un resultado; aquello a lo que conduce no se ha tocado. Elimine el enlace, o mueva aquí la propia carpeta.</translation>
    </message>
    <message>
      <source>No temporary folder can be created here (%1); free some space, or set TMPDIR to another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aquí no se puede crear una carpeta temporal (%1); libere espacio o asigne otra carpeta a TMPDIR.</translation>
    </message>
    <message>
      <source>The JSON contains &apos;%1&apos; twice in one object; delete one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El JSON contiene «%1» dos veces en un objeto; borre uno de los dos.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a whole number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» debe ser un número entero de %2 a %3; corríjalo.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» debe ser un número de %2 a %3; corríjalo.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» debe ser un número; corríjalo.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is mirrored: its corners run counter-clockwise as seen from above; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La marca %1 del plato está reflejada: vistas desde arriba, sus esquinas van en sentido antihorario; cree de nuevo el archivo del plato.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is not convex; list its corners in order along its edge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La marca %1 del plato no es convexa; indique sus esquinas una tras otra a lo largo del borde.</translation>
    </message>
    <message>
      <source>The markers %1 and %2 of the plate overlap; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las marcas %1 y %2 del plato se superponen; cree de nuevo el archivo del plato.</translation>
    </message>
    <message>
      <source>The board&apos;s markers must be smaller than its squares; correct &apos;marker_mm&apos; or &apos;square_mm&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las marcas del tablero deben ser menores que sus cuadrados; corrija «marker_mm» o «square_mm».</translation>
    </message>
    <message>
      <source>A face of the PLY file has more than %1 corners; export the file again as triangles.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una cara del PLY tiene más de %1 esquinas; expórtelo de nuevo como triángulos.</translation>
    </message>
    <message>
      <source>The PLY file has more than %1 of '%2'; export it with fewer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo PLY tiene más de %1 de «%2»; expórtelo con menos.</translation>
    </message>
    <message>
      <source>A link or a file has taken the place of a folder, or a link that of a file; replace it with the folder or the file itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un enlace o un archivo ha ocupado el lugar de una carpeta, o un enlace el de un archivo; sustitúyalo por la carpeta o el archivo mismo.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya existe un archivo con este nombre y no se sobrescribe; elija otro nombre.</translation>
    </message>
    <message>
      <source>The export names a location in the project where no such file belongs; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La exportación indica un lugar del proyecto donde no corresponde un archivo así; no se ha importado nada.</translation>
    </message>
    <message>
      <source>The archive contains a journal of its catalogue, which an Ostraka archive never contains; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La copia de archivo contiene un diario de su catálogo, cosa que ninguna de Ostraka contiene; no se ha escrito nada.</translation>
    </message>
    <message>
      <source>The catalogue&apos;s tables, indexes or triggers differ from those that Ostraka creates; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las tablas, los índices y los disparadores del catálogo no son como los crea Ostraka; no se ha escrito nada.</translation>
    </message>
    <message>
      <source>The output folder is gone: it was moved or deleted while Ostraka was writing to it. The photographs are untouched; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta de salida ya no está: se movió o se borró mientras Ostraka escribía en ella. Las fotografías están intactas; ejecute de nuevo la misma orden.</translation>
    </message>
    <message>
      <source>The folder already contains files; choose a new or empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta ya contiene archivos; elija una nueva o vacía.</translation>
    </message>
    <message>
      <source>This location belongs to the archive or export &apos;%1&apos;, which new files would make invalid; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este lugar pertenece a la copia de archivo o exportación «%1», que dejaría de ser válida con archivos nuevos; elija un lugar fuera de ella.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este lugar pertenece al proyecto «%1»; elija un lugar fuera de él.</translation>
    </message>
    <message>
      <source>The name of this output must end in %1; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre de este archivo de salida debe terminar en %1; elija otro nombre.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es una carpeta, no un archivo; elija otro nombre.</translation>
    </message>
    <message>
      <source>This output is one of the input files, which it would overwrite; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta salida es uno de los archivos de entrada y lo sobrescribiría; elija otro nombre.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a folder directly in &apos;%2&apos;, or one outside the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este lugar pertenece al proyecto «%1»; elija una carpeta directamente en «%2», o una fuera del proyecto.</translation>
    </message>
    <message>
      <source>This file describes another plate, or this plate with another ruler length; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo describe otro plato, o este plato con otra longitud de la regla; elija otra carpeta.</translation>
    </message>
    <message>
      <source>This file describes another calibration board; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo describe otro tablero; elija otra carpeta.</translation>
    </message>
    <message>
      <source>This folder contains photographs, and a new plate.json would describe the sheet under their sherds; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En esta carpeta hay fotos, y un plate.json nuevo describiría la hoja bajo sus fragmentos; elija otra carpeta.</translation>
    </message>
    <message>
      <source>This folder is a mount point or the current folder; choose a new folder inside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta es un punto de montaje o la carpeta actual; elija una carpeta nueva dentro de ella.</translation>
    </message>
    <message>
      <source>This folder is needed for unfinished files but contains others; move it elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta se necesita para archivos sin terminar, pero contiene otros; muévala a otro lugar.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the front side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se omitió en el anverso un objeto del %1 % de la longitud del fragmento habitual; sin escala puede ser un fragmento.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the back side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se omitió en el reverso un objeto del %1 % de la longitud del fragmento habitual; sin escala puede ser un fragmento.</translation>
    </message>
    <message>
      <source>The photographs of the front side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos del anverso solo concuerdan en el %1 % de lo que muestran sus máscaras, por lo que sus escaneos pueden ser erróneos. Revise las máscaras, y que nada se moviera mientras se fotografiaba.</translation>
    </message>
    <message>
      <source>The photographs of the back side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotos del reverso solo concuerdan en el %1 % de lo que muestran sus máscaras, por lo que sus escaneos pueden ser erróneos. Revise las máscaras, y que nada se moviera mientras se fotografiaba.</translation>
    </message>
    <message>
      <source>All photographs look at the sheet from straight above, so heights and wall thicknesses are uncertain and broken edges are hardly seen. Add photographs from the side, tilted by 30 to 60 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todas las fotos miran la hoja verticalmente desde arriba, por lo que las alturas y los grosores de pared son inciertos y los bordes de fractura apenas se ven. Añada fotos desde el lado, inclinadas de 30 a 60 grados.</translation>
    </message>
    <message>
      <source>If it is one, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Si lo es, fotografíelo solo.</translation>
    </message>
    <message>
        <source>The catalogue is damaged (%1); nothing was changed, and no backup was deleted. Restore it with 'ostraka catalogue repair PROJECT'.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El catálogo está dañado (%1); no se cambió nada ni se borró ninguna copia de seguridad. Restáurelo con «ostraka catalogue repair PROJECT».</translation>
    </message>
    <message>
        <source>a page was changed</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>se modificó una página</translation>
    </message>
    <message>
        <source>it is a backup, but the -wal file beside it belongs to the catalogue that it replaced</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>es una copia de seguridad, pero el archivo -wal junto a ella pertenece al catálogo que ha reemplazado</translation>
    </message>
    <message>
        <source>its repair was interrupted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>su reparación se interrumpió</translation>
    </message>
    <message>
        <source>its pages are inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>sus páginas no concuerdan</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the file is not a database</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>el archivo no es una base de datos</translation>
    </message>
    <message>
        <source>the file belongs to another program</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>el archivo pertenece a otro programa</translation>
    </message>
    <message>
        <source>the file contains no catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>el archivo no contiene ningún catálogo</translation>
    </message>
    <message>
        <source>the header is inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>la cabecera se contradice</translation>
    </message>
    <message>
        <source>it contains no project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>no contiene ningún proyecto</translation>
    </message>
    <message>
        <source>The catalogue cannot be read; check that it exists and check its permissions.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>No se puede leer el catálogo; compruebe que existe y revise sus permisos.</translation>
    </message>
    <message>
        <source>This project is read-only, and there is no space for the copy that Ostraka reads; free some space in the folder for temporary files.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Este proyecto es de solo lectura y no hay espacio para la copia que lee Ostraka; libere espacio en la carpeta de archivos temporales.</translation>
    </message>
    <message>
        <source>An older Ostraka made this project, and it is read-only here; copy it to a folder that you can write to, and open it there.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Un Ostraka anterior hizo este proyecto, y aquí es de solo lectura; cópielo en una carpeta en la que pueda escribir y ábralo allí.</translation>
    </message>
    <message>
        <source>The catalogue is damaged, and none of its backups is intact; copy one from an archive or another disk into the folder backups, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El catálogo está dañado y ninguna de sus copias de seguridad está íntegra; copie una en la carpeta backups, desde una copia de archivo o desde otro disco, y repárelo de nuevo.</translation>
    </message>
    <message>
        <source>Another program has this project open; close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Otro programa tiene abierto este proyecto; ciérrelo allí y repárelo después.</translation>
    </message>
    <message>
        <source>%1 rows in total, %2 read; run the same import again for the others.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 filas en total, %2 leídas; ejecute la misma importación otra vez para las demás.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; means the same as &apos;%2&apos;; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La columna &apos;%1&apos; significa lo mismo que &apos;%2&apos;; sus valores se guardan en un campo propio.</translation>
    </message>
    <message>
      <source>Check the drawing of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Revise el dibujo de %1: %2</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fragmento %1 de %2</translation>
    </message>
    <message>
      <source>camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: %2</translation>
    </message>
    <message>
      <source>%1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 y %2</translation>
    </message>
    <message>
      <source>Camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1: %2</translation>
    </message>
    <message>
      <source>The focal length is not determined: %1 px with a standard deviation of %2 px; take more pictures, closer and with the board tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la distancia focal no está determinada: %1 px con una desviación típica de %2 px; tome más imágenes, más de cerca y con el tablero inclinado de 20 a 45 grados en distintas direcciones.</translation>
    </message>
    <message>
      <source>No picture shows the board tilted by more than 15 degrees; tilt it more to separate focal length from distance.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ninguna imagen muestra el tablero inclinado más de 15 grados; inclínelo más, para distinguir la distancia focal de la distancia.</translation>
    </message>
    <message>
      <source>The corners scatter by %1 px, more than the 0.3 px of sharp pictures of a flat board; check focus, lighting and the board's flatness.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>las esquinas se dispersan %1 px, más que los 0,3 px de imágenes nítidas de un tablero plano; revise el enfoque, la luz y que el tablero sea plano.</translation>
    </message>
    <message>
      <source>The worst picture is %1 with %2 px; retake it or leave it out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la peor imagen es %1 con %2 px; repítala u omítala.</translation>
    </message>
    <message>
      <source>Calibration pictures that show the board: %1; at least 3 are needed. Take more pictures of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Imágenes de calibración que muestran el tablero: %1; hacen falta al menos 3. Haga más.</translation>
    </message>
    <message>
      <source>Camera %1, position %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1, posición %2: %3.</translation>
    </message>
    <message>
      <source>%1 poses are given for %2 photographs; give one pose for each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Se dan %1 poses para %2 fotos; dé una para cada una.</translation>
    </message>
    <message>
      <source>its front no longer has a back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su anverso ya no tiene reverso</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about ten times the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Compruebe la unidad: %1 es unas diez veces el valor calculado.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about a tenth of the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Compruebe la unidad: %1 es aproximadamente una décima parte del valor calculado.</translation>
    </message>
    <message>
      <source>Check the value: %1 differs from the computed value by a factor of three or more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Compruebe el valor: %1 se aparta al menos tres veces del valor calculado.</translation>
    </message>
    <message>
      <source>Check the values: %1 (%2) is below %3 (%4).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Compruebe los valores: %1 (%2) es menor que %3 (%4).</translation>
    </message>
    <message>
      <source>The computed value is %1. Delete it?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El valor calculado es %1. ¿Eliminarlo?</translation>
    </message>
    <message>
      <source>The computed value is %1. Replace it with the measured value?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El valor calculado es %1. ¿Sustituirlo por el valor medido?</translation>
    </message>
    <message>
      <source>the length</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la longitud</translation>
    </message>
    <message>
      <source>the width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>la anchura</translation>
    </message>
    <message>
      <source>the minimum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el grosor mínimo</translation>
    </message>
    <message>
      <source>the maximum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el grosor máximo</translation>
    </message>
    <message>
      <source>the thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>el grosor</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate&apos;s markers are visible.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudieron contar los fragmentos: se ven muy pocas marcas del plato.</translation>
    </message>
    <message>
      <source>No sherd is visible on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se ve ningún fragmento en el plato.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate&apos;s centre: move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay fragmentos que se tocan o casi se tocan en %1 desde el centro del plato: sepárelos y vuelva a fotografiar.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate&apos;s centre was counted as one but may be two touching sherds: check it; if so, move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que está en %1 desde el centro del plato se contó como uno, pero pueden ser dos fragmentos que se tocan: compruébelo; si es así, sepárelos y vuelva a fotografiar.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and reshoot them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El reverso parece el anverso: dé la vuelta a los fragmentos y vuelva a fotografiarlos.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudieron contar los fragmentos del reverso: compare las imágenes antes de vaciar el plato.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudieron contar los fragmentos del anverso: compare las imágenes antes de vaciar el plato.</translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Find the missing ones before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos contados en el anverso: %1, en el reverso: %2. Busque los que faltan antes de vaciar el plato.</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Check whether one was added or broke.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos contados en el anverso: %1, en el reverso: %2. Compruebe si se añadió o se rompió alguno.</translation>
    </message>
    <message>
      <source>The turntable&apos;s own count was %1 degrees off; it was corrected from the plate&apos;s markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La cuenta de la mesa giratoria se desviaba %1 grados; se corrigió según las marcas del plato.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un proyecto de Ostraka: esta carpeta no tiene catalogue.sqlite; no se unió nada.</translation>
    </message>
    <message>
      <source>Another version of Ostraka made this project; nothing was merged. Open it once with this version, which updates it, or install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otra versión de Ostraka creó este proyecto; no se unió nada. Ábralo una vez con esta versión, que lo actualiza, o instale la versión más reciente.</translation>
    </message>
    <message>
      <source>A project cannot be merged with itself; name another project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un proyecto no puede unirse consigo mismo; indique otro proyecto.</translation>
    </message>
    <message>
      <source>This project is read-only here, so nothing was merged; copy it to a folder that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto es aquí de solo lectura, por lo que no se unió nada; cópielo en una carpeta en la que pueda escribir.</translation>
    </message>
    <message>
      <source>The project changed while files were copied, so nothing was merged; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El proyecto cambió mientras se copiaban archivos, por lo que no se unió nada; vuelva a ejecutar la misma orden.</translation>
    </message>
    <message>
      <source>The conflict %1 (%2) cannot be settled with &apos;%3&apos;; nothing was merged. Choose one of the ways that the list of conflicts offers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El conflicto %1 (%2) no puede resolverse con «%3»; no se unió nada. Elija una de las opciones que ofrece la lista de conflictos.</translation>
    </message>
    <message>
      <source>This file must be a JSON list of {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} or {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;}; nothing was merged. Correct the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo debe ser una lista JSON de {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} o {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;}; no se unió nada. Corrija el archivo.</translation>
    </message>
    <message>
      <source>The conflict %1 is settled twice in this file; nothing was merged. Keep one of the two entries.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El conflicto %1 se resuelve dos veces en este archivo; no se unió nada. Conserve una de las dos entradas.</translation>
    </message>
    <message>
      <source>This file of project B differs from what its catalogue records; nothing was merged. Restore it from a copy (&apos;ostraka catalogue check&apos; lists all such files).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo del proyecto B difiere de lo que registra su catálogo; no se unió nada. Restáurelo desde una copia («ostraka catalogue check» enumera todos esos archivos).</translation>
    </message>
    <message>
      <source>The disk does not return what was written to it; nothing was merged. Check the disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco no devuelve lo que se escribió en él; no se unió nada. Compruebe el disco.</translation>
    </message>
    <message>
      <source>A link or a device cannot be merged; nothing was merged. Move what it leads to into project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un enlace o un dispositivo no puede unirse; no se unió nada. Mueva al proyecto B aquello a lo que lleva.</translation>
    </message>
    <message>
      <source>Results from a cluster must be regular files with plain names; nothing of this batch was entered. Submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los resultados de un clúster deben ser archivos corrientes con nombres sencillos; no se registró nada de esta tanda. Envíe la tanda de nuevo.</translation>
    </message>
    <message>
      <source>This batch was processed here or reshot in the meantime; the cluster&apos;s results are not entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entretanto esta tanda se procesó aquí o se volvió a fotografiar; los resultados del clúster no se registran.</translation>
    </message>
    <message>
      <source>The name of a partition or an account consists of letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;; look it up with &apos;sinfo&apos; or ask the cluster&apos;s administrators.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre de una partición o de una cuenta consta de letras, cifras, «-», «_» y «.»; consúltelo con «sinfo» o pregunte a los administradores del clúster.</translation>
    </message>
    <message>
      <source>The command that starts Ostraka on the cluster must be one line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La orden que inicia Ostraka en el clúster debe ocupar una sola línea.</translation>
    </message>
    <message>
      <source>A job needs at least one core, and its memory and time must not be negative.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un trabajo necesita al menos un núcleo, y su memoria y su tiempo no pueden ser negativos.</translation>
    </message>
    <message>
      <source>This folder cannot be opened (%1); check its name and permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta no puede abrirse (%1); compruebe su nombre y sus permisos.</translation>
    </message>
    <message>
      <source>The path of this project contains a character that has a special meaning for Slurm (%, a backslash or a control character); rename the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La ruta de este proyecto contiene un carácter con un significado especial para Slurm (%, una barra invertida o un carácter de control); cambie el nombre de la carpeta.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH; run this command on a login node of the cluster, or name one with --host USER@LOGIN:/FOLDER.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa %1 no está en el PATH de este equipo; ejecute esta orden en un nodo de acceso del clúster o indique uno con --host USER@LOGIN:/FOLDER.</translation>
    </message>
    <message>
      <source>Not a folder on a cluster; write USER@LOGIN:/FOLDER, with the folder&apos;s full path and without spaces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es una carpeta de un clúster; escriba USER@LOGIN:/FOLDER, con la ruta completa de la carpeta y sin espacios.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH, but --host needs it; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa %1 no está en el PATH de este equipo, pero --host lo necesita; instálelo.</translation>
    </message>
    <message>
      <source>The program %1 cannot be started there; ask the cluster&apos;s administrators how Slurm is reached.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa %1 no puede iniciarse allí; pregunte a los administradores del clúster cómo se accede a Slurm.</translation>
    </message>
    <message>
      <source>%1 failed (%2). Nothing is lost; once the cause is removed, run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 falló (%2). No se ha perdido nada; una vez eliminada la causa, vuelva a ejecutar la misma orden.</translation>
    </message>
    <message>
      <source>This batch contains imported scans and is not submitted; the window&apos;s queue processes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda contiene escaneos importados y no se envía; la procesa la cola de la ventana.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk has %1 GB left, but the batches to submit (%2) need about %3 GB. Nothing was submitted; free some space, or submit fewer with --most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Al disco del clúster le quedan %1 GB, pero las tandas por enviar (%2) necesitan unos %3 GB. No se envió nada; libere espacio o envíe menos con --most.</translation>
    </message>
    <message>
      <source>Batches of this project are on another cluster or in another folder; collect them before you submit to this one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay tandas de este proyecto en otro clúster o en otra carpeta; recójalas antes de enviar a este.</translation>
    </message>
    <message>
      <source>Not a list of the batches on a cluster; restore an earlier one, or delete it: batches that are on the cluster are then processed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es una lista de las tandas de un clúster; restaure una anterior o elimínela: las tandas que están en el clúster se procesarán entonces de nuevo.</translation>
    </message>
    <message>
      <source>Out of memory (%1 MB requested); the next submission requests twice as much.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Memoria agotada (se pidieron %1 MB); el próximo envío pedirá el doble.</translation>
    </message>
    <message>
      <source>Out of time (minutes requested: %1); the next submission requests twice as many and resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tiempo agotado (minutos pedidos: %1); el próximo envío pedirá el doble y reanudará tras la última etapa completa.</translation>
    </message>
    <message>
      <source>The node failed, or the job was killed; the next submission resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nodo falló o el trabajo se interrumpió; el próximo envío reanudará tras la última etapa completa.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk is full, or your quota is used up; free some space, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El disco del clúster está lleno o su cuota está agotada; libere espacio y envíe de nuevo.</translation>
    </message>
    <message>
      <source>The cluster does not know this job, and the job wrote nothing into the project&apos;s folder; check that the cluster&apos;s nodes see that folder, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El clúster no conoce este trabajo, y el trabajo no escribió nada en la carpeta del proyecto; compruebe que los nodos del clúster ven esa carpeta y envíe de nuevo.</translation>
    </message>
    <message>
      <source>The program ended with status %1; its output is in %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El programa terminó con el código %1; su salida está en %2.</translation>
    </message>
    <message>
      <source>The partition ends jobs earlier than the %1 minutes requested; cancel the job, then submit again with another --partition or fewer --minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La partición termina los trabajos antes de los %1 minutos pedidos; cancele el trabajo y envíe de nuevo con otra --partition o menos --minutes.</translation>
    </message>
    <message>
      <source>Slurm&apos;s reason: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Motivo según Slurm: %1.</translation>
    </message>
    <message>
      <source>This network cannot be used: %1. Choose an ONNX network that takes 1 x 3 x H x W and gives 1 x 1 x h x w or 1 x 2 x h x w.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta red no puede usarse: %1. Elija una red ONNX que tome 1 x 3 x H x W y dé 1 x 1 x h x w o 1 x 2 x h x w.</translation>
    </message>
    <message>
      <source>it cannot be run (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>no puede ejecutarse (%1)</translation>
    </message>
    <message>
      <source>its output has another shape</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su salida tiene otra forma</translation>
    </message>
    <message>
      <source>its output contains numbers that are not finite</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su salida contiene números no finitos</translation>
    </message>
    <message>
      <source>its input is not an image</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su entrada no es una imagen</translation>
    </message>
    <message>
      <source>its input has %1 channels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su entrada tiene %1 canales</translation>
    </message>
    <message>
      <source>its input is larger than %1 pixels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>su entrada supera los %1 píxeles</translation>
    </message>
    <message>
      <source>You have no permission to use it: copy packaging/udev/70-ostraka.rules to /etc/udev/rules.d/ and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No tiene permiso para usarlo: copie packaging/udev/70-ostraka.rules en /etc/udev/rules.d/ y vuelva a conectarlo.</translation>
    </message>
    <message>
      <source>It is in use by %1: &apos;ostraka devices --release&apos; releases it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo está usando %1: «ostraka devices --release» lo libera.</translation>
    </message>
    <message>
      <source>It is in use by %1: close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo está usando %1: cierre ese programa.</translation>
    </message>
    <message>
      <source>The kernel has no driver for it; install one for this adapter.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El núcleo no tiene controlador para él; instale uno para este adaptador.</translation>
    </message>
    <message>
      <source>A folder of the project cannot be read (%1); check its permissions, then archive the project again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No puede leerse una carpeta del proyecto (%1); compruebe sus permisos y archive el proyecto de nuevo.</translation>
    </message>
    <message>
      <source>No output folder was given; name one with --output OUT.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se indicó carpeta de salida; indique una con --output OUT.</translation>
    </message>
    <message>
      <source>No folder of front scans was given; name one with --front DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se indicó carpeta con los escaneos de los anversos; indique una con --front DIR.</translation>
    </message>
    <message>
      <source>No folder of back scans was given; name one with --back DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se indicó carpeta con los escaneos de los reversos; indique una con --back DIR.</translation>
    </message>
    <message>
      <source>The field %1 has no unit &apos;%2&apos;; choose another unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El campo %1 no tiene la unidad «%2»; elija otra unidad.</translation>
    </message>
    <message>
      <source>The table has no column &apos;%1&apos;; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La tabla no tiene columna «%1»; compruebe su nombre.</translation>
    </message>
    <message>
      <source>The columns &apos;%1&apos; and &apos;%2&apos; are both mapped to the field %3; leave one of them out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las columnas «%1» y «%2» están asignadas al mismo campo %3; omita una de ellas.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; maps no column; write COLUMN=FIELD or COLUMN=FIELD:unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» no asigna ninguna columna; escriba COLUMN=FIELD o COLUMN=FIELD:unit.</translation>
    </message>
    <message>
      <source>The scan&apos;s colours or qualities differ in number from its points; give one for each point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número de colores o calidades del escaneo difiere del de sus puntos; dé uno por punto.</translation>
    </message>
    <message>
      <source>The pixels or the mask differ in size from the stated width and height; give one value for each pixel.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los píxeles o la máscara no corresponden a la anchura y la altura indicadas; dé un valor por píxel.</translation>
    </message>
    <message>
      <source>No scan of this side was given; give at least one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se dio ningún escaneo de este lado; dé al menos uno.</translation>
    </message>
    <message>
      <source>give them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>delos en mm</translation>
    </message>
    <message>
      <source>A remark in this file cannot be read; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una observación de este archivo no puede leerse; restaure una copia anterior del archivo o vuelva a procesar la tanda.</translation>
    </message>
    <message>
      <source>Camera %1, position %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cámara %1, posición %2</translation>
    </message>
    <message>
        <source>%1: from %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: de %2</translation>
    </message>
    <message>
        <source>%1: from the history</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: del historial</translation>
    </message>
    <message>
        <source>%1: not restored</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: no restaurado</translation>
    </message>
    <message>
      <source>draft %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>borrador %1</translation>
    </message>
    <message>
      <source>The remarks in this file are longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las observaciones de este archivo superan los %1 bytes; restaure una copia anterior del archivo o vuelva a procesar la tanda.</translation>
    </message>
    <message>
      <source>A remark in this file is nested more than %1 levels deep; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una observación de este archivo tiene más de %1 niveles de anidamiento; restaure una copia anterior del archivo o vuelva a procesar la tanda.</translation>
    </message>
    <message>
      <source>The template of a remark in this file is longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La plantilla de una observación de este archivo supera los %1 bytes; restaure una copia anterior del archivo o vuelva a procesar la tanda.</translation>
    </message>
    <message>
      <source>A remark in this file uses a value more than %1 times; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una observación de este archivo usa un valor más de %1 veces; restaure una copia anterior del archivo o vuelva a procesar la tanda.</translation>
    </message>
    <message>
      <source>The version of the damaged catalogue cannot be read, so this repair relies on the backup %1. If a newer Ostraka has changed this project since, put the damaged file back and repair it with that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La versión del catálogo dañado no puede leerse, por lo que esta reparación se basa en la copia de seguridad %1. Si un Ostraka más reciente ha modificado el proyecto desde entonces, vuelva a colocar el archivo dañado y repárelo con esa versión.</translation>
    </message>
    <message>
      <source>The setting %1 of project B says that two different things are the same; nothing was merged. Ask for another copy of project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El ajuste %1 del proyecto B dice que dos cosas distintas son la misma; no se unió nada. Pida otra copia del proyecto B.</translation>
    </message>
    <message>
      <source>The number or code %1 is already in use; nothing was merged. Settle the conflict %2 with another one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número o código %1 ya está en uso; no se unió nada. Resuelva el conflicto %2 con otro.</translation>
    </message>
    <message>
      <source>A new number cannot be empty; nothing was merged. Enter a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un número nuevo no puede estar vacío; no se unió nada. Escriba un número.</translation>
    </message>
    <message>
      <source>The merged catalogue would be inconsistent, so nothing was merged; report this with a copy of both projects.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El catálogo unido sería incoherente, por lo que no se unió nada; comuníquelo con una copia de ambos proyectos.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the front of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos resultados proceden de fotos anteriores del anverso de %1; procésela otra vez.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the back of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos resultados proceden de fotos anteriores del reverso de %1; procésela otra vez.</translation>
    </message>
    <message>
      <source>Photographs of %1 that are missing or are others than these results were made from: %2 of %3. The results are entered; reprocess the batch if it was photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos de %1 que faltan o son distintas de las que dieron estos resultados: %2 de %3. Los resultados están registrados; reprocese la tanda si se volvió a fotografiar.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; the cluster&apos;s results are not entered. Submit it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda se volvió a fotografiar después de enviarla; los resultados del clúster no se registran. Envíela otra vez.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; its job %1 is of no use any more. Cancel it with &apos;scancel&apos;, or wait until it has ended, then submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta tanda se volvió a fotografiar después de enviarla; su trabajo %1 ya no sirve. Cancélelo con &apos;scancel&apos; o espere a que termine, y envíe la tanda otra vez.</translation>
    </message>
    <message>
      <source>Batches of this project were submitted to this host, which was not named on this computer; nothing was sent to it. If you trust it, name it once with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay tandas de este proyecto enviadas a este equipo, que no se ha indicado en este ordenador; no se le ha enviado nada. Si confía en él, indíquelo una vez con --host.</translation>
    </message>
    <message>
      <source>Not a file in which Ostraka remembers the host of a cluster; delete it, then name the host with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un archivo en el que Ostraka recuerda el equipo de un clúster; bórrelo e indique el equipo con --host.</translation>
    </message>
    <message>
      <source>A job can request at most %1 MB of memory and %2 minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un trabajo puede pedir como máximo %1 MB de memoria y %2 minutos.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1 of the front side; it is left out of both sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta foto es idéntica a %1 del anverso; se omite en ambos lados.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the front side are identical to photographs of the back side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de las %2 fotos del anverso son idénticas a fotos del reverso (por ejemplo, %3), por lo que la tanda no se puede usar; dé a cada lado sus propias fotos.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the back side are identical to photographs of the front side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de las %2 fotos del reverso son idénticas a fotos del anverso (por ejemplo, %3), por lo que la tanda no se puede usar; dé a cada lado sus propias fotos.</translation>
    </message>
    <message>
      <source>The field %1 was changed meanwhile; nothing was undone or redone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El campo %1 se modificó entretanto; no se deshizo ni se rehízo nada.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term; choose one of %2, or add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; no es un término; elija uno de %2, o añádalo en los ajustes.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term: the vocabulary is empty; add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; no es un término: el vocabulario está vacío; añádalo en los ajustes.</translation>
    </message>
    <message>
      <source>why this row was not imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>por qué no se importó esta fila</translation>
    </message>
    <message>
      <source>Read as a table of contexts and bags: no column has the sherds&apos; numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leída como tabla de contextos y bolsas: ninguna columna contiene los números de los fragmentos.</translation>
    </message>
    <message>
      <source>Read as a table of sherds: the column &apos;%1&apos; identifies them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leída como tabla de fragmentos: la columna &apos;%1&apos; los identifica.</translation>
    </message>
    <message>
      <source>No column has the sherds&apos; numbers, but &apos;%1&apos; is a column of sherds; select the column of numbers, or leave &apos;%1&apos; out if this is a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ninguna columna contiene los números de los fragmentos, pero &apos;%1&apos; es una columna de fragmentos; elija la columna de los números, u omita &apos;%1&apos; si esta es una tabla de contextos.</translation>
    </message>
    <message>
        <source>%1: not restored; it belongs to %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: no restaurado; pertenece a %2</translation>
    </message>
    <message>
      <source>Only measurements and days accept &lt; and &gt;; write %1:value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Solo las medidas y los días admiten &lt; y &gt;; escriba %1:value.</translation>
    </message>
    <message>
      <source>The filter has no field &apos;%1&apos;; write extra.%1 for a custom field, or enclose the word in quotation marks to search for it literally.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El filtro no conoce ningún campo &apos;%1&apos;; escriba extra.%1 para un campo propio o ponga la palabra entre comillas para buscarla tal cual.</translation>
    </message>
    <message>
      <source>Write the date in EDTF, for example -0599/-0549~ (600 to about 550 BC), -1149? or 0350/..; years have four digits, and words such as MB II belong in the field for the period.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escriba la fecha en EDTF, por ejemplo -0599/-0549~ (600 a hacia 550 a. C.), -1149? o 0350/..; los años tienen cuatro cifras, y las palabras como MB II van en el campo del período.</translation>
    </message>
    <message>
      <source>Enter the context with its site and trench, such as KT26-A-012.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Indique el contexto con su yacimiento y su corte, por ejemplo KT26-A-012.</translation>
    </message>
    <message>
      <source>Scale: none; lengths in mm are based on a guess.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: ninguna; las longitudes en mm se basan en una suposición.</translation>
    </message>
    <message>
      <source>Scale: the board of board.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: el tablero de board.json.</translation>
    </message>
    <message>
      <source>Scale: the lengths marked in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: las longitudes marcadas en scale.json.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as typed at the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: marcadores de %1 mm, como se escribió al importar.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as in plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: marcadores de %1 mm, como en plate.json.</translation>
    </message>
    <message>
      <source>Scale: the markers that plate.json describes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: los marcadores que describe plate.json.</translation>
    </message>
    <message>
      <source>Scale: that of the imported scans.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Escala: la de los escaneos importados.</translation>
    </message>
    <message>
      <source>The scale of this batch is its rig&apos;s; calibrate the rig to correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La escala de este lote es la de su equipo; calibre el equipo para corregirla.</translation>
    </message>
    <message>
      <source>The markers of this sheet are of several sizes; correct its plate.json by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los marcadores de esta hoja son de varios tamaños; corrija su plate.json a mano.</translation>
    </message>
    <message>
      <source>These results contain a measurement larger than any sherd; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos resultados contienen una medida mayor que cualquier fragmento; ejecute de nuevo &apos;ostraka process&apos;.</translation>
    </message>
    <message>
      <source>This project lies in the archive &apos;%1&apos;, which any change would make invalid; restore the archive to a new folder, and open that.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto está en la copia de archivo «%1», que dejaría de ser válida con cualquier cambio; restaure la copia de archivo en una carpeta nueva y ábrala.</translation>
    </message>
    <message>
      <source>Not a location of photographs, results, models or imported files, the only files that a merge writes; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es un lugar de fotografías, resultados, modelos o archivos importados, los únicos archivos que escribe una fusión; no se ha fusionado nada.</translation>
    </message>
    <message>
      <source>A point, a normal or a quality of the scan is not finite; leave such points out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un punto, una normal o una calidad del escaneo no es finito; omita esos puntos.</translation>
    </message>
    <message>
      <source>The lists of this cloud or mesh differ in length, or a triangle names a vertex that does not exist; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las listas de esta nube de puntos o malla tienen longitudes distintas, o un triángulo nombra un vértice que no existe; no se ha escrito nada.</translation>
    </message>
    <message>
      <source>The transform puts the back %1 mm away from the front; give one that takes points of the back to the front&apos;s frame.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La transformación coloca el reverso a %1 mm del anverso; indique una que lleve los puntos del reverso al sistema de coordenadas del anverso.</translation>
    </message>
    <message>
      <source>The model has no photographs, so the orthophoto shows the colours of its vertices.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El modelo no tiene fotografías, por lo que la ortofoto muestra los colores de sus vértices.</translation>
    </message>
    <message>
      <source>The model has neither photographs nor colours, so there is no orthophoto of it; draw its shaded form.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El modelo no tiene ni fotografías ni colores, por lo que no hay ortofoto de él; dibuje su forma sombreada.</translation>
    </message>
    <message>
      <source>%1: 1 point whose normal has no direction was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: se omitió 1 punto cuya normal no tiene dirección; revise la exportación.</translation>
    </message>
    <message>
      <source>%1: %2 points whose normals have no direction were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: se omitieron %2 puntos cuyas normales no tienen dirección; revise la exportación.</translation>
    </message>
    <message>
      <source>The photograph is less than %1 pixels wide or high; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La fotografía tiene menos de %1 píxeles de ancho o de alto; use la fotografía original.</translation>
    </message>
    <message>
        <source>The project has no site yet; add a column &apos;Site&apos;, or write the context with its site, such as %1.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El proyecto aún no tiene yacimiento; añada una columna «Yacimiento» o escriba el contexto con su yacimiento, por ejemplo %1.</translation>
    </message>
    <message>
        <source>This project has %1 sites; add a column &apos;Site&apos;, or write the context with its site, such as %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Este proyecto tiene %1 yacimientos; añada una columna «Yacimiento» o escriba el contexto con su yacimiento, por ejemplo %2.</translation>
    </message>
    <message>
        <source>The site %1 has %2 trenches; add a column &apos;Trench&apos;, or write the context with its trench, such as %3.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El yacimiento %1 tiene %2 cortes; añada una columna «Corte» o escriba el contexto con su corte, por ejemplo %3.</translation>
    </message>
    <message>
        <source>There is no such trench in the site %1; write trench and context in columns of their own.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>No existe tal corte en el yacimiento %1; escriba el corte y el contexto en columnas propias.</translation>
    </message>
    <message>
        <source>The backups %1 and %2 are of different projects, and nothing tells which of them this folder is; nothing was changed. Move those of the other project away, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Las copias de seguridad %1 y %2 son de proyectos distintos, y nada indica cuál de ellos es esta carpeta; no se ha cambiado nada. Mueva las del otro proyecto a otro lugar y repare de nuevo.</translation>
    </message>
    <message>
        <source>This can be %1 or %2; enter site, trench and context each by itself.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Puede ser %1 o %2; introduzca por separado el yacimiento, el corte y el contexto.</translation>
    </message>
    <message>
        <source>The table needs a column for the sherds&apos; numbers, or one for the contexts (a table of contexts); select it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>La tabla necesita una columna para los números de los fragmentos, o una para los contextos (una tabla de contextos); selecciónela.</translation>
    </message>
    <message>
      <source>The number needs the trench of the sherd, which is not recorded; choose a context in a trench, or change the numbering in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número necesita el corte del fragmento, que no está registrado; elija un contexto dentro de un corte o cambie la numeración en los ajustes.</translation>
    </message>
    <message>
      <source>This folder on the cluster belongs to another project, to another copy of this one, or to this one before it was moved; nothing was sent. Name another folder with --host. If nothing else uses this one, delete &apos;cluster/owner&apos; in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta del clúster pertenece a otro proyecto, a otra copia de este, o a este antes de que se moviera; no se envió nada. Indique otra carpeta con --host. Si nada más usa esta carpeta, borre en ella &apos;cluster/owner&apos;.</translation>
    </message>
    <message>
      <source>This changed while a merge was being completed, so it was kept, but the catalogue has what was merged. Reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esto cambió mientras se completaba una fusión, por lo que se conservó, pero el catálogo tiene lo fusionado. Reprocese la tanda.</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>línea</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>campo</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>valor</translation>
    </message>
    <message>
      <source>A sparse object of %1 points at x %2, y %3 mm was left out; if it is a sherd, photograph it closer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un objeto de solo %1 puntos en x %2, y %3 mm se omitió; si es un fragmento, fotografíelo más de cerca.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs or scans of %3 belong to %4, too: its sherds would be in the catalogue twice. Nothing was entered. Set %3 aside and use %4, or keep both: 'Keep both' in the queue, 'ostraka catalogue enter --keep-both' on the command line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de las %2 fotografías o escaneos de %3 pertenecen también a %4: sus fragmentos estarían dos veces en el catálogo. No se registró nada. Aparte %3 y use %4, o conserve ambas: «Conservar ambas» en la cola, 'ostraka catalogue enter --keep-both' en la línea de órdenes.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of %3, which this export holds, belong to %4, too: its sherds would be in the catalogue twice. Use %4 and leave the export out, or keep both on purpose (on the command line: --keep-both).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 de las %2 fotografías de %3, que contiene esta exportación, pertenecen también a %4: sus fragmentos estarían dos veces en el catálogo. Use %4 sin esta exportación, o conserve ambas a propósito (en la línea de órdenes: --keep-both).</translation>
    </message>
    <message>
      <source>Another run is writing to this folder. What it has saved is kept, and this run has changed nothing; wait until the other one ends, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro proceso está escribiendo en esta carpeta. Lo que ha guardado se conserva, y este no ha cambiado nada; espere a que el otro termine o elija otra carpeta.</translation>
    </message>
    <message>
      <source>The photographs do not tell the light from the sherds' own colours, so textures stay as photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotografías no permiten distinguir la luz de los colores propios de los fragmentos, así que las texturas quedan como se fotografiaron.</translation>
    </message>
    <message>
      <source>Ostraka needs this folder for its own files, but it contains others. They are unchanged; move them elsewhere, then start again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka necesita esta carpeta para sus propios archivos, pero contiene otros. No se han modificado; muévalos a otro lugar y empiece de nuevo.</translation>
    </message>
    <message>
      <source>This is not the location of a photograph, result, model or imported file, the only files that a catalogue lists. Nothing was changed; use a backup or another copy of the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No es el lugar de una fotografía, un resultado, un modelo o un archivo importado, los únicos archivos que un catálogo enumera. No se ha cambiado nada; use una copia de seguridad u otra copia del proyecto.</translation>
    </message>
    <message>
      <source>The catalogue has earlier results of %1, and the batch is queued again. Enter the new ones with &apos;ostraka catalogue enter&apos;, or reprocess it in the window.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El catálogo tiene resultados anteriores de %1, y la tanda está de nuevo en la cola. Registre los nuevos con &apos;ostraka catalogue enter&apos; o vuelva a procesarla en la ventana.</translation>
    </message>
    <message>
      <source>The folder on the cluster has files that Ostraka did not write (%1): %2. They were left there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta del clúster tiene archivos que Ostraka no escribió (%1): %2. Se han quedado allí.</translation>
    </message>
    <message>
      <source>The output folder contains the results of other scans, or of these before a file was changed, renamed, added or removed; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La carpeta de salida contiene los resultados de otros escaneos, o de estos antes de que un archivo se cambiara, renombrara, añadiera o quitara; elija otra carpeta.</translation>
    </message>
    <message>
      <source>The interval ends before it begins: %1 is earlier than %2; write the earlier date first, and years BC with a minus sign.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El intervalo termina antes de empezar: %1 es anterior a %2; escriba primero la fecha más antigua, y los años a. C. con un signo menos.</translation>
    </message>
    <message>
      <source>The number %1 differs from the existing number %2 only in zeros, letter case or punctuation; check which one is meant.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 se distingue del número existente %2 solo en los ceros, las mayúsculas o la puntuación; compruebe cuál es el correcto.</translation>
    </message>
    <message>
      <source>New numbers differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay números nuevos que se distinguen de los existentes solo en los ceros, las mayúsculas o la puntuación: %1; compruebe si hay erratas.</translation>
    </message>
    <message>
      <source>New contexts differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hay contextos nuevos que se distinguen de los existentes solo en los ceros, las mayúsculas o la puntuación: %1; compruebe si hay erratas.</translation>
    </message>
    <message>
      <source>A spreadsheet may have shortened these numbers or turned them into dates: %1; compare them with the labels and correct them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es posible que una hoja de cálculo haya abreviado estos números o los haya convertido en fechas: %1; compárelos con las etiquetas y corríjalos.</translation>
    </message>
    <message>
      <source>This file differs from what &apos;ostraka process&apos; wrote; run it again, which writes the file anew.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este archivo difiere de lo que escribió 'ostraka process'; ejecútelo otra vez y se escribirá de nuevo.</translation>
    </message>
    <message>
      <source>The name of the file %1 is not UTF-8, and results could not tell it from others; rename it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre del archivo %1 no está en UTF-8 y los resultados no podrían distinguirlo de otros; cámbiele el nombre y vuelva a intentarlo.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías utilizables del anverso: %1; hacen falta al menos %2. Fotografías omitidas: %3; la primera: %4</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotografías utilizables del reverso: %1; hacen falta al menos %2. Fotografías omitidas: %3; la primera: %4</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused; nothing was merged. Settle the conflict %2 with another number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El número %1 ya se asignó y nunca se reutiliza; no se unió nada. Resuelva el conflicto %2 con otro número.</translation>
    </message>
    <message>
      <source>An entry of this file does not have the form {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} (or &quot;b&quot; or &quot;one&quot;, or &quot;number&quot; with a new number): %1; nothing was merged. Correct the entry.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una entrada de este archivo no tiene la forma {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} (o &quot;b&quot; o &quot;one&quot;, o &quot;number&quot; con un número nuevo): %1; no se unió nada. Corrija la entrada.</translation>
    </message>
    <message>
      <source>The name of a place must not be empty; nothing was renamed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El nombre de un lugar no puede estar vacío; no se ha renombrado nada.</translation>
    </message>
    <message>
      <source>Another place has the name %1 by now; nothing was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro lugar se llama ya %1; no se ha deshecho nada.</translation>
    </message>
    <message>
      <source>This disk does not accept this name; rename the file, or use a folder on another disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este disco no admite este nombre; cambie el nombre del archivo o use una carpeta de otro disco.</translation>
    </message>
    <message>
      <source>A file of an earlier merge cannot be moved to its place, %1. Make it possible (move away what lies there, or copy the project to another disk), or delete the file; then merge again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un archivo de una unión anterior no puede moverse a su lugar, %1. Haga que sea posible (aparte lo que hay allí o copie el proyecto a otro disco) o elimine el archivo; después, una de nuevo.</translation>
    </message>
    <message>
      <source>It belongs to a merge and waits in %1; moving it to its place is tried again whenever the project is opened.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El archivo pertenece a una unión y espera en %1; cada vez que se abre el proyecto se intenta de nuevo moverlo a su lugar.</translation>
    </message>
    <message>
      <source>The block of numbers of this computer begins or ends with &apos;%1&apos;, but must be of whole numbers from 1 to %2; set it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El bloque de números de este ordenador empieza o termina con «%1», pero debe ser de números enteros de 1 a %2; establézcalo en los ajustes.</translation>
    </message>
    <message>
      <source>Photographs of %1 that these results were not made from: %2, the first is %3. Reprocess the batch to use them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos de %1 de las que no proceden estos resultados: %2, la primera es %3. Vuelva a procesar la tanda para usarlas.</translation>
    </message>
    <message>
      <source>These results do not say which photographs they were made from, so they are not entered; process %1 again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estos resultados no dicen de qué fotos proceden, por lo que no se registran; procese %1 de nuevo.</translation>
    </message>
    <message>
      <source>The GLB beside this model has another shape, so it is that of another sherd or of an earlier run; put its own beside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El GLB que acompaña a este modelo tiene otra forma, así que es de otro fragmento o de un procesamiento anterior; ponga el suyo al lado.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ToolRow</name>
    <message>
        <source>More</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Más</translation>
    </message>
    <message>
        <source>More tools</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Más herramientas</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, tecla %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ColumnTable</name>
    <message>
        <source>says nothing about the sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>no dice nada del fragmento</translation>
    </message>
    <message>
        <source>only shown, never read</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>solo se muestra, nunca se lee</translation>
    </message>
    <message>
        <source>share of 1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>parte de 1</translation>
    </message>
    <message>
        <source>unit guessed from the values; check it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>unidad deducida de los valores; compruébela</translation>
    </message>
    <message>
        <source>as in the last table with these columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>como en la última tabla con estas columnas</translation>
    </message>
    <message>
        <source>chosen by you</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>elegido por usted</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Columnas de la tabla</translation>
    </message>
    <message>
        <source>column</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>columna</translation>
    </message>
    <message>
        <source>field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>campo</translation>
    </message>
    <message>
        <source>unit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>unidad</translation>
    </message>
    <message>
        <source>first values</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>primeros valores</translation>
    </message>
    <message>
        <source>why</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>motivo</translation>
    </message>
    <message>
        <source>Field of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Campo de la columna %1</translation>
    </message>
    <message>
        <source>Unit of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Unidad de la columna %1</translation>
    </message>
    <message>
        <source>skip</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>omitir</translation>
    </message>
    <message>
        <source>custom field: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>campo propio: %1</translation>
    </message>
    <message>
        <source>no field of this name; kept as a custom field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ningún campo con este nombre; se conserva como campo propio</translation>
    </message>
    <message>
      <source>proposed by its heading</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>propuesto por su encabezado</translation>
    </message>
</context>
<context>
    <name>ImportSides</name>
    <message>
      <source>Drop either folders or photographs, not both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Suelte carpetas o fotos, no ambas.</translation>
    </message>
    <message>
      <source>These are more than two folders; drop that of the fronts and that of the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Son más de dos carpetas; suelte la de los anversos y la de los reversos.</translation>
    </message>
    <message>
      <source>There are no photographs in this folder; choose one that holds them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En esta carpeta no hay fotos; elija una que las contenga.</translation>
    </message>
    <message>
      <source>This folder contains several folders with photographs (%1); drop the two of one batch, front and back, onto this page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Esta carpeta contiene varias carpetas con fotos (%1); suelte en esta página las dos de una tanda, anverso y reverso.</translation>
    </message>
    <message>
      <source>The photographs of this folder are those of the front already; choose another folder for the back, or divide the series with the slider.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Las fotografías de esta carpeta ya son las del anverso; elija otra carpeta para el reverso, o divida la serie con el control.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportChooser</name>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta con los escaneos front/ y back/</translation>
    </message>
    <message>
      <source>Folder of a batch, or with photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta de una tanda, o con fotos</translation>
    </message>
    <message>
      <source>Folder of the back photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta de las fotografías de reversos</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SidesView</name>
    <message>
      <source>One side only</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un solo lado</translation>
    </message>
    <message>
      <source>Swap sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Intercambiar lados</translation>
    </message>
    <message>
      <source>First photograph of the second side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Primera foto del segundo lado</translation>
    </message>
    <message>
      <source>Choose sheet…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir hoja…</translation>
    </message>
    <message>
      <source>Clear sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Quitar la hoja</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s &amp;black square</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lado del cuadrado &amp;negro de una marca</translation>
    </message>
    <message>
      <source>Unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Desconocido</translation>
    </message>
    <message>
      <source> mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation> mm</translation>
    </message>
    <message>
      <source>The sheet will be found in the photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La hoja se encontrará en las fotografías.</translation>
    </message>
    <message>
      <source>No sheet file (plate.json) and no marker size: the result has no scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sin archivo de hoja (plate.json) ni tamaño de marca: el resultado no tiene escala.</translation>
    </message>
    <message>
      <source>Sheet under the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hoja bajo los fragmentos</translation>
    </message>
    <message>
      <source>Sheet (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hoja (*.json)</translation>
    </message>
    <message>
      <source>Front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anverso</translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Reverso</translation>
    </message>
    <message>
      <source>The series is divided where the sherds were turned over.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>La serie se divide donde se dio la vuelta a los fragmentos.</translation>
    </message>
    <message>
      <source>Sheet: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hoja: %1</translation>
    </message>
    <message>
      <source>%1: none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: ninguna</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n photograph(s), %2 to %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: %n foto, de %2 a %3</numerusform>
        <numerusform>%1: %n fotos, de %2 a %3</numerusform>
      </translation>
    </message>
    <message>
      <source>The marker size is proposed from the last import: check it with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El tamaño de los marcadores se propone de la última importación: compruébelo con una regla.</translation>
    </message>
    <message>
      <source>Choose back folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir carpeta de reversos…</translation>
    </message>
    <message>
      <source>A folder that holds both sides is split where the sherds were turned over; the folder of the back photographs replaces the split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una carpeta con ambos lados se divide donde se dio la vuelta a los fragmentos; la carpeta de los reversos sustituye esa división</translation>
    </message>
    <message>
      <source>No pause stands out between the photographs. Where the two pictures beside the division show the sherds before and after they were turned over, divide here; else move the slider, or choose the folder of the back photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se nota ninguna pausa entre las fotografías. Si las dos imágenes junto a la división muestran los fragmentos antes y después de darles la vuelta, divida aquí; si no, mueva el control o elija la carpeta de las fotografías del reverso.</translation>
    </message>
    <message>
      <source>Divide here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dividir aquí</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueRepair</name>
    <message>
        <source>It is whole; nothing was changed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Está íntegro; no se cambió nada.</translation>
    </message>
    <message>
        <source>Nothing in the damaged file could be read: it is that of %1 again. Look what is missing since.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>No se pudo leer nada del archivo dañado: vuelve a ser el de %1. Mire qué falta desde entonces.</translation>
    </message>
    <message>
        <source>An earlier repair was interrupted and is now finished. Check the catalogue for missing changes.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Una reparación anterior se interrumpió y ahora ha terminado. Compruebe si faltan cambios en el catálogo.</translation>
    </message>
    <message>
        <source>Everything in it is as it was.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Todo en él está como estaba.</translation>
    </message>
    <message>
        <source>All %1 rows stand in %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Las %1 filas están todas en %2.</translation>
    </message>
    <message>
        <source>The damaged file is kept: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El archivo dañado se conserva: %1</translation>
    </message>
    <message>
        <source>Another window has this project open: close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Otra ventana tiene abierto este proyecto: ciérrelo allí y repárelo después.</translation>
    </message>
    <message>
        <source>The catalogue is being repaired …</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Se está reparando el catálogo …</translation>
    </message>
    <message>
        <source>The catalogue could not be repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>No se pudo reparar el catálogo.</translation>
    </message>
    <message>
        <source>The catalogue is repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>El catálogo está reparado.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeDialog</name>
    <message>
      <source>Merge another project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unir otro proyecto</translation>
    </message>
    <message>
      <source>Conflicts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Conflictos</translation>
    </message>
    <message>
      <source>Record</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Registro</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Campo</translation>
    </message>
    <message>
      <source>This project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto</translation>
    </message>
    <message>
      <source>Other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro proyecto</translation>
    </message>
    <message>
      <source>Decision</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Decisión</translation>
    </message>
    <message>
      <source>New number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Número nuevo</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deshacer</translation>
    </message>
    <message>
      <source>All open ones: this project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Todos los abiertos: este proyecto</translation>
    </message>
    <message>
      <source>Choose project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elegir proyecto …</translation>
    </message>
    <message>
      <source>Progress of the merge</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Avance de la unión</translation>
    </message>
    <message>
      <source>Folder of the other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Carpeta del otro proyecto</translation>
    </message>
    <message>
      <source>New number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Número nuevo %1</translation>
    </message>
    <message>
      <source>Open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abierto</translation>
    </message>
    <message>
      <source>What the other project holds comes into this one; the other one is only read. Nothing changes before you merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lo que contiene el otro proyecto pasa a este; el otro solo se lee. Nada cambia antes de unirlos.</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cerrar</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parar</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelar</translation>
    </message>
    <message numerus="yes">
      <source>%n conflict(s) to settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n conflicto por resolver</numerusform>
        <numerusform>%n conflictos por resolver</numerusform>
      </translation>
    </message>
    <message>
      <source>Merge project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unir proyecto</translation>
    </message>
    <message>
      <source>New number:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Número nuevo:</translation>
    </message>
    <message>
      <source>New number of the record that does not keep it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Número nuevo del registro que no lo conserva</translation>
    </message>
    <message>
      <source>Sherds with a new number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos con número nuevo</translation>
    </message>
    <message>
      <source>Copy list</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Copiar la lista</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos fragmentos: el de este proyecto conserva el número, el otro recibe %1</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos fragmentos: el de este proyecto conserva el número, el otro recibe uno nuevo</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos fragmentos: el otro conserva el número, el de este proyecto recibe %1</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dos fragmentos: el otro conserva el número, el de este proyecto recibe uno nuevo</translation>
    </message>
    <message>
      <source>One sherd: both records become one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un solo fragmento: los dos registros pasan a ser uno</translation>
    </message>
    <message>
      <source>Open; new number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abierto; número nuevo: %1</translation>
    </message>
    <message>
      <source>One sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un solo fragmento</translation>
    </message>
    <message>
      <source>This project; the other sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto; el otro fragmento: %1</translation>
    </message>
    <message>
      <source>Other project; this sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otro proyecto; este fragmento: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeModel</name>
    <message>
      <source>Sherds: %1. Batches: %2. Changed records: %3. Files: %4 (%5).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos: %1. Tandas: %2. Registros cambiados: %3. Archivos: %4 (%5).</translation>
    </message>
    <message>
      <source>Comparing…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comparando …</translation>
    </message>
    <message>
      <source>Merged %1. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 unido. %2</translation>
    </message>
    <message>
      <source>This project already has everything that the other one holds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Este proyecto ya tiene todo lo que contiene el otro.</translation>
    </message>
    <message>
      <source>Batches that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tandas que reciben aquí otro número: %1</translation>
    </message>
    <message>
      <source>Sherds that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos que reciben aquí otro número: %1</translation>
    </message>
    <message numerus="yes">
      <source>Missing in the other project: %n file(s), %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Falta %n archivo en el otro proyecto: %1</numerusform>
        <numerusform>Faltan %n archivos en el otro proyecto: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cancelado. No se unió nada.</translation>
    </message>
    <message>
      <source>Nothing was merged yet: what you chose leads to further conflicts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aún no se unió nada: lo que eligió lleva a otros conflictos.</translation>
    </message>
    <message>
      <source>An earlier merge was interrupted and could not be completed here: %1. What lies there is kept; the other project&apos;s version was left out, or waits in the folder merge.partial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Una unión anterior se interrumpió y no pudo completarse aquí: %1. Lo que hay allí se conserva; la versión del otro proyecto se omitió o espera en la carpeta merge.partial.</translation>
    </message>
</context>
<context>
    <name>Verdicts</name>
    <message>
      <source>accepted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aceptada</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rechazada</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>apartada</translation>
    </message>
    <message>
      <source>to be photographed again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>por fotografiar de nuevo</translation>
    </message>
    <message>
      <source>merged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unidos</translation>
    </message>
    <message>
      <source>split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dividido</translation>
    </message>
    <message>
      <source>withdrawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>retirada</translation>
    </message>
    <message>
      <source>pair of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pareja de %1</translation>
    </message>
    <message>
      <source>fragments: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>trozos: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateScreen</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tanda</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NoBatchYet</name>
    <message>
        <source>Capture a batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Capturar una tanda</translation>
    </message>
    <message>
      <source>Show the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mostrar la cola</translation>
    </message>
    <message>
      <source>%1 is in the queue; its results appear here when it is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 está en la cola; sus resultados aparecen aquí cuando se haya procesado.</translation>
    </message>
    <message>
      <source>%1 could not be processed; the queue says why.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se pudo procesar %1; la cola dice por qué.</translation>
    </message>
</context>
<context>
    <name>Outside</name>
    <message>
      <source>No program was found that opens %1. It is there: open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se encontró ningún programa que abra %1. Está ahí: ábralo a mano.</translation>
    </message>
    <message>
      <source>Opening %1. If it does not appear, open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abriendo %1. Si no aparece, ábralo a mano.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MarkerSide</name>
    <message>
      <source>Marker side of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lado del marcador de %1</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s black square, mm. The batch is reprocessed with this size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lado del cuadrado negro de un marcador, mm. El lote se vuelve a procesar con este tamaño.</translation>
    </message>
    <message>
      <source>marker side typed anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>lado del marcador escrito de nuevo</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PrintSheetButton</name>
    <message>
        <source>Print a sheet…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Imprimir una hoja…</translation>
    </message>
    <message>
        <source>Markers around the sherds give photographs taken by hand their scale</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Las marcas alrededor de los fragmentos dan su escala a las fotografías hechas a mano</translation>
    </message>
    <message>
        <source>Print it at 100 %, not fitted to the page, and measure the bar of the second page: it must be %1 mm long. The next import proposes this sheet. If the bar is not %1 mm long, choose Clear sheet there and type the measured side of a black square.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Imprímala al 100 %, sin ajustar a la página, y mida la barra de la segunda página: debe medir %1 mm. La próxima importación propone esta hoja. Si la barra no mide %1 mm, elija allí «Quitar la hoja» e introduzca el lado medido de un cuadrado negro.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SurfaceChoice</name>
    <message>
      <source>Shaded form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Forma sombreada</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Con pintura y engobe</translation>
    </message>
    <message>
      <source>Orthophoto, %1 dpi</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ortofoto, %1 ppp</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectCare</name>
    <message numerus="yes">
      <source>%n file(s) of this project are missing or were changed, first %1. Put them back from a copy; &apos;ostraka catalogue check&apos; lists all of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Falta %n archivo de este proyecto o ha sido modificado: %1. Repóngalo desde una copia; «ostraka catalogue check» lo enumera.</numerusform>
        <numerusform>Faltan %n archivos de este proyecto o han sido modificados, el primero %1. Repóngalos desde una copia; «ostraka catalogue check» los enumera todos.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MunsellLine</name>
    <message>
      <source>Rough: no usable colour chart in these photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aproximado: no hay una carta de color utilizable en estas fotografías.</translation>
    </message>
    <message>
      <source>Measured by the colour chart (Delta E 2000: median %1, 95 % %2).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Medido con la carta de color (Delta E 2000: mediana %1, 95 % %2).</translation>
    </message>
    <message>
      <source>Take over</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Adoptar</translation>
    </message>
    <message>
      <source>Proposed: %1 (Delta E 2000: %2), then %3 (%4). %5</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Propuesta: %1 (Delta E 2000: %2), después %3 (%4). %5</translation>
    </message>
    <message>
      <source>Take over %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Adoptar %1</translation>
    </message>
    <message>
      <source>Of the side that was photographed first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Del lado fotografiado primero.</translation>
    </message>
    <message>
      <source>Of the side that was photographed second.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Del lado fotografiado después.</translation>
    </message>
    <message>
      <source>Measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Medido.</translation>
    </message>
    <message>
      <source>No colours proposed: the model has no texture from photographs, or an earlier version of the program made it. Reprocess its batch to get proposals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>No se proponen colores: el modelo no tiene textura de fotografías o lo hizo una versión anterior del programa. Reprocese su tanda para obtener propuestas.</translation>
    </message>
    <message>
      <source>Rough estimate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Estimación aproximada.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CompareWindow</name>
    <message>
      <source>only one entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>solo en uno</translation>
    </message>
    <message>
      <source>differs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>distinto</translation>
    </message>
    <message>
      <source>differs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>distinto: %1</translation>
    </message>
    <message>
      <source>%1, within the uncertainty</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, dentro de la incertidumbre</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message>
      <source>Compare sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Comparar fragmentos</translation>
    </message>
    <message>
      <source>Turn &amp;together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Girar juntos</translation>
    </message>
    <message>
      <source>Off: each sherd is turned alone, until both lie alike. The scale stays the same.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Desactivado: cada fragmento se gira por separado, hasta que ambos queden orientados igual. La escala sigue siendo la misma.</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sección</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Desde arriba</translation>
    </message>
    <message>
      <source>Fields and measurements of both sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Campos y medidas de ambos fragmentos</translation>
    </message>
    <message>
      <source>Model of %1; the arrow keys turn it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelo de %1; las teclas de flecha lo giran</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>campo</translation>
    </message>
    <message>
      <source>difference</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>diferencia</translation>
    </message>
    <message numerus="yes">
      <source>%n field(s) differ.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%n campo es distinto.</numerusform>
            <numerusform>%n campos son distintos.</numerusform>
        </translation>
    </message>
    <message>
      <source>The two are recorded as joining.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Los dos constan como que unen entre sí.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectRestoring</name>
    <message>
        <source>%1 %</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlacesDialog</name>
    <message>
      <source>Rename places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renombrar lugares</translation>
    </message>
    <message>
      <source>Choose the place that was typed wrongly and enter its right name. If that place exists already, both become one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elija el lugar que se escribió mal e introduzca su nombre correcto. Si ese lugar ya existe, los dos pasan a ser uno.</translation>
    </message>
    <message>
      <source>Places of the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lugares del proyecto</translation>
    </message>
    <message>
      <source>Place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lugar</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmentos</translation>
    </message>
    <message>
      <source>Right name of the place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nombre correcto del lugar</translation>
    </message>
    <message>
      <source>Rename</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renombrar</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cerrar</translation>
    </message>
    <message>
      <source>Right &amp;name:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Nombre correcto:</translation>
    </message>
    <message numerus="yes">
      <source>%n context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n contexto</numerusform>
        <numerusform>%n contextos</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n bag(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n bolsa</numerusform>
        <numerusform>%n bolsas</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n tanda</numerusform>
        <numerusform>%n tandas</numerusform>
      </translation>
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
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nada</translation>
    </message>
    <message>
      <source>%1 exists already. Join with it? What is in %2 comes to %1: %3. %1 keeps its own description, and %2 is not listed any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ya existe. ¿Unir con él? Lo que hay en %2 pasa a %1: %3. %1 conserva su propia descripción y %2 deja de aparecer en la lista.</translation>
    </message>
    <message>
      <source>In this place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En este lugar: %1.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep the number that is written on them; new numbers go on behind these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fragmento conserva el número que lleva escrito; los números nuevos siguen a continuación.</numerusform>
        <numerusform>%n fragmentos conservan los números que llevan escritos; los números nuevos siguen a continuación.</numerusform>
      </translation>
    </message>
    <message>
      <source>Join places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unir lugares</translation>
    </message>
    <message>
      <source>join %1 with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unir %1 con %2</translation>
    </message>
    <message>
      <source>rename %1 to %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>renombrar %1 como %2</translation>
    </message>
    <message>
      <source>Joined: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unidos: %1 es ahora %2.</translation>
    </message>
    <message>
      <source>Renamed: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renombrado: %1 es ahora %2.</translation>
    </message>
    <message>
      <source>A site gets another code in the settings, under Open project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Un yacimiento recibe otro código en los ajustes, en Proyecto abierto.</translation>
    </message>
</context>
</TS>
