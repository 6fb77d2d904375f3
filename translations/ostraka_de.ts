<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>ComputeBatch</name>
    <message>
      <source>The disk has only %1 MB left; a batch needs more. Nothing is lost: make room, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf dem Datenträger sind nur noch %1 MB frei; eine Ladung braucht mehr. Nichts ist verloren: Platz schaffen, dann weitermachen.</translation>
    </message>
    <message>
      <source>%1: this number was typed on the plate, but no sherd with a context lies there; give it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Diese Nummer wurde auf dem Teller eingetippt, aber dort liegt keine Scherbe mit einem Befund; vergeben Sie sie im Katalog.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) were counted on the plate, and another number was found; look at the map for one that is missing or cut in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe wurde auf dem Teller gezählt, gefunden wurde eine andere Zahl; suchen Sie auf dem Plan nach einer, die fehlt oder zerteilt ist.</numerusform>
        <numerusform>%n Scherben wurden auf dem Teller gezählt, gefunden wurde eine andere Zahl; suchen Sie auf dem Plan nach einer, die fehlt oder zerteilt ist.</numerusform>
      </translation>
    </message>
    <message>
      <source>Pairs were decided while the batch was computed; compute it again for them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Während die Ladung berechnet wurde, sind Paare entschieden worden; berechnen Sie sie dafür noch einmal.</translation>
    </message>
  </context>
  <context>
    <name>Fields</name>
    <message>
      <source>number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummer</translation>
    </message>
    <message>
      <source>identifier</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kennung</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zustand</translation>
    </message>
    <message>
      <source>void because</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ungültig, weil</translation>
    </message>
    <message>
      <source>site</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fundort</translation>
    </message>
    <message>
      <source>trench</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Befund</translation>
    </message>
    <message>
      <source>bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beutel</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Teil</translation>
    </message>
    <message>
      <source>ware</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ware</translation>
    </message>
    <message>
      <source>fabric</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbentyp</translation>
    </message>
    <message>
      <source>inclusions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Magerung</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Herstellung</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brand</translation>
    </message>
    <message>
      <source>surface outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oberfläche außen</translation>
    </message>
    <message>
      <source>surface inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oberfläche innen</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verzierung</translation>
    </message>
    <message>
      <source>Munsell outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell außen</translation>
    </message>
    <message>
      <source>Munsell inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell innen</translation>
    </message>
    <message>
      <source>Munsell core</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell Kern</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erhaltung</translation>
    </message>
    <message>
      <source>joins with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>passt an</translation>
    </message>
    <message>
      <source>vessel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gefäß</translation>
    </message>
    <message>
      <source>period</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeitstellung</translation>
    </message>
    <message>
      <source>date</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Datierung</translation>
    </message>
    <message>
      <source>length, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Länge, mm</translation>
    </message>
    <message>
      <source>width, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Breite, mm</translation>
    </message>
    <message>
      <source>thickness least, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wandstärke kleinste, mm</translation>
    </message>
    <message>
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wandstärke, mm</translation>
    </message>
    <message>
      <source>thickness most, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wandstärke größte, mm</translation>
    </message>
    <message>
      <source>area, mm²</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fläche, mm²</translation>
    </message>
    <message>
      <source>volume, mm³</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Volumen, mm³</translation>
    </message>
    <message>
      <source>not seen, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nicht gesehen, %</translation>
    </message>
    <message>
      <source>rim diameter, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Randdurchmesser, mm</translation>
    </message>
    <message>
      <source>rim kept, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rand erhalten, %</translation>
    </message>
    <message>
      <source>weight, g</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gewicht, g</translation>
    </message>
    <message>
      <source>batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladung</translation>
    </message>
    <message>
      <source>note</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bemerkung</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab</translation>
    </message>
  </context>
  <context>
    <name>Job</name>
    <message>
      <source>The memory does not suffice; close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Speicher reicht nicht; andere Programme schließen und noch einmal versuchen.</translation>
    </message>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist ein Fehler des Programms; bitte mit dem Protokoll melden (%1).</translation>
    </message>
  </context>
  <context>
    <name>PlaceText</name>
    <message>
      <source>%1 bag %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Beutel %2</translation>
    </message>
    <message>
      <source>A site, a context and a bag are needed so that the sherds can be numbered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fundort, Befund und Beutel werden gebraucht, damit die Scherben Nummern bekommen.</translation>
    </message>
    <message>
      <source>site %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fundort %1</translation>
    </message>
    <message>
      <source>trench %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schnitt %1</translation>
    </message>
    <message>
      <source>context %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Befund %1</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beutel %1</translation>
    </message>
  </context>
  <context>
    <name>Rig</name>
    <message>
      <source>its file is missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seine Datei fehlt</translation>
    </message>
    <message>
      <source>ready (calibrated today)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bereit (heute kalibriert)</translation>
    </message>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>bereit (einen Tag alt)</numerusform>
        <numerusform>bereit (%n Tage alt)</numerusform>
      </translation>
    </message>
    <message>
      <source>virtual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>virtuell</translation>
    </message>
  </context>
  <context>
    <name>Stage</name>
    <message>
      <source>cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kameras</translation>
    </message>
    <message>
      <source>sherd or plate, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe oder Teller, vorn</translation>
    </message>
    <message>
      <source>sherd or plate, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe oder Teller, hinten</translation>
    </message>
    <message>
      <source>surface, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oberfläche, vorn</translation>
    </message>
    <message>
      <source>surface, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oberfläche, hinten</translation>
    </message>
    <message>
      <source>one scan a sherd, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ein Scan je Scherbe, vorn</translation>
    </message>
    <message>
      <source>one scan a sherd, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ein Scan je Scherbe, hinten</translation>
    </message>
    <message>
      <source>which back belongs to which front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>welche Rückseite zu welcher Vorderseite gehört</translation>
    </message>
    <message>
      <source>models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelle</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalog</translation>
    </message>
    <message>
      <source>begins</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>beginnt</translation>
    </message>
    <message>
      <source>more candidates for doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>weitere Kandidaten für zweifelhafte Paare</translation>
    </message>
  </context>
  <context>
    <name>Time</name>
    <message numerus="yes">
      <source>%n s left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>noch %n s</numerusform>
        <numerusform>noch %n s</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>noch %n min</numerusform>
        <numerusform>noch %n min</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 h %2 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch %1 h %2 min</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui</name>
    <message>
      <source>numbered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nummeriert</translation>
    </message>
    <message>
      <source>void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ungültig</translation>
    </message>
    <message>
      <source>draft</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entwurf</translation>
    </message>
    <message>
      <source>on a scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>auf der Waage</translation>
    </message>
    <message>
      <source>with a calliper</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>mit der Schieblehre</translation>
    </message>
    <message>
      <source>estimated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geschätzt</translation>
    </message>
    <message>
      <source>by the program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>vom Programm</translation>
    </message>
    <message>
      <source>aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>beiseite</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch einmal</translation>
    </message>
    <message>
      <source>%1 or %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 oder %2</translation>
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Aufnahme ist nicht mehr da.</translation>
    </message>
    <message>
      <source>The printer or file cannot be written; choose another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drucker oder die Datei lässt sich nicht beschreiben; bitte wählen Sie etwas anderes.</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseite</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseite</translation>
    </message>
    <message>
      <source>The printer took no further page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drucker nahm keine weitere Seite an.</translation>
    </message>
    <message>
      <source>The printer or file could not be finished; is the disk full?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Druck oder die Datei wurde nicht fertig; ist die Platte voll?</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3: their rims differ by %4 only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 und %2 passen beide zu %3: ihre Ränder unterscheiden sich nur um %4.</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 und %2 passen beide zu %3.</translation>
    </message>
    <message>
      <source>%1 would fit %2 nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 würde fast ebenso gut zu %2 passen.</translation>
    </message>
    <message>
      <source>Another partner fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Partner passt fast ebenso gut.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre Rückseite wurde einer anderen Vorderseite gegeben: Ist %1 jetzt die richtige?</translation>
    </message>
    <message>
      <source>%1 fits hardly better than a stranger's back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 passt kaum besser als die Rückseite einer fremden Scherbe.</translation>
    </message>
    <message>
      <source>The two sides fit nearly as well in another position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die beiden Seiten passen in einer anderen Lage fast ebenso gut.</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>under 1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unter 1 %</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>The back lies upside down: both sides face the same way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Rückseite liegt verkehrt herum: Beide Seiten schauen in dieselbe Richtung.</translation>
    </message>
    <message>
      <source>The faces cross: %1 of the front lies behind the back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Flächen durchdringen sich: %1 der Vorderseite liegen hinter der Rückseite.</translation>
    </message>
    <message>
      <source>The two scans share almost no broken edge; outlines alone tie them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die beiden Scans haben fast keine gemeinsame Bruchkante; nur die Umrisse verbinden sie.</translation>
    </message>
    <message>
      <source>The broken edges do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Bruchkanten passen nicht: %1 Abstand.</translation>
    </message>
    <message>
      <source>The rim hardly fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Rand legt die Lage kaum fest: auf %1 ungewiss.</translation>
    </message>
    <message>
      <source>A place %1 along the rim fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Stelle %1 weiter am Rand passt fast ebenso gut.</translation>
    </message>
    <message>
      <source>The rims cannot be compared; outlines alone tie these sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ränder lassen sich nicht vergleichen; nur die Umrisse verbinden diese Seiten.</translation>
    </message>
    <message>
      <source>look</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ansehen</translation>
    </message>
    <message>
      <source>no back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>keine Rückseite</translation>
    </message>
    <message>
      <source>sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sicher</translation>
    </message>
    <message>
      <source>decided</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>entschieden</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>beiseitegelegt</translation>
    </message>
    <message>
      <source>shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>neu aufnehmen</translation>
    </message>
    <message>
      <source>%1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 – %2</translation>
    </message>
    <message>
      <source>No back was found for it. Choose one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Rückseite wurde gefunden. Wählen Sie eine, oder legen Sie die Scherbe beiseite.</translation>
    </message>
    <message>
      <source>The program is sure: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm ist sicher: %1.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entschieden von %1 am %2.</translation>
    </message>
    <message>
      <source>Set aside by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beiseitegelegt von %1 am %2.</translation>
    </message>
    <message>
      <source>To be shot again, says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neu aufzunehmen, sagt %1, %2.</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beutel %1</translation>
    </message>
    <message>
      <source>no front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>keine Vorderseite</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Rückseite ist beiseitegelegt. Ziehen Sie sie auf eine Vorderseite, um sie doch zu verwenden.</translation>
    </message>
    <message>
      <source>This back is to be shot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Rückseite soll neu aufgenommen werden.</translation>
    </message>
    <message>
      <source>No front holds this back. Drag it onto its front, join it to another, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Vorderseite hat diese Rückseite. Ziehen Sie sie auf ihre Vorderseite, fügen Sie sie an eine andere, oder legen Sie sie beiseite.</translation>
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
        <numerusform>%1 von %n Scherbe</numerusform>
        <numerusform>%1 von %n Scherben</numerusform>
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
      <translation>zweifelhaft</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe</numerusform>
        <numerusform>%n Scherben</numerusform>
      </translation>
    </message>
    <message>
      <source>Its back %1 was given to %2: is %3 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre Rückseite %1 wurde %2 gegeben: Ist %3 jetzt die richtige?</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2. Choose another one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre Rückseite %1 wurde %2 gegeben. Wählen Sie eine andere, oder legen Sie die Scherbe beiseite.</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2; next best %3, %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre Rückseite %1 wurde %2 gegeben; die nächstbeste ist %3, %4.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2, turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entschieden von %1 am %2, von Hand gedreht.</translation>
    </message>
    <message>
      <source>The rims hardly meet: %1 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ränder treffen sich kaum: %1 davon.</translation>
    </message>
    <message>
      <source>by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>von Hand</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anfangspunkt</translation>
    </message>
    <message>
      <source>settled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eingerastet</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Hand gedreht: %1 der Ränder treffen sich.</translation>
    </message>
    <message>
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Hand gedreht.</translation>
    </message>
    <message>
      <source>Another start point is tried: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Anfangspunkt wird probiert: %1 der Ränder treffen sich.</translation>
    </message>
    <message>
      <source>Another start point is tried.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Anfangspunkt wird probiert.</translation>
    </message>
    <message>
      <source>Settled by the rims: %1 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durch die Ränder eingerastet: %1 davon treffen sich.</translation>
    </message>
    <message>
      <source>Settled by the rims.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durch die Ränder eingerastet.</translation>
    </message>
    <message>
      <source>%1 is tried: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird probiert: %2.</translation>
    </message>
    <message>
      <source>%1 is tried: %2, rims %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird probiert: %2, Ränder %3 auseinander.</translation>
    </message>
    <message>
      <source>%1 is tried: %2; its rims do not meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird probiert: %2; die Ränder treffen sich nicht.</translation>
    </message>
    <message>
      <source>%1 decided for %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hat sich für %2 entschieden.</translation>
    </message>
    <message>
      <source>The program says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm meint %1, %2.</translation>
    </message>
    <message>
      <source>Joined with %1 by %2; it is one piece once the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mit %1 verbunden von %2; sobald die Ladung berechnet ist, ist es ein Stück.</translation>
    </message>
    <message>
      <source>Cut in two by %1; its pieces come when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In zwei geteilt von %1; die Stücke kommen, wenn die Ladung berechnet wird.</translation>
    </message>
    <message>
      <source>joined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>verbunden</translation>
    </message>
    <message>
      <source>cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geteilt</translation>
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
      <translation>Einlesen von %1</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kopie lässt sich nicht an ihren Platz legen: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>eine Scherbe, sicher</numerusform>
        <numerusform>%n Scherben, alle sicher</numerusform>
      </translation>
    </message>
    <message>
      <source>a draft: look, then compute it again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ein Entwurf: ansehen, dann neu berechnen</translation>
    </message>
    <message>
      <source>the scale is not right: see the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>der Maßstab stimmt nicht: siehe Bericht</translation>
    </message>
    <message>
      <source>%1; joined to %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; gefügt auf %2 mm</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladung %1</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Warnung: %1</translation>
    </message>
    <message numerus="yes">
      <source>%1 is computed: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 ist berechnet: eine Scherbe.</numerusform>
        <numerusform>%1 ist berechnet: %n Scherben.</numerusform>
      </translation>
    </message>
    <message>
      <source>You stopped it. What was computed so far is kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Ihnen angehalten. Was schon berechnet ist, bleibt.</translation>
    </message>
    <message>
      <source>You took it out of the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Ihnen aus der Warteschlange genommen.</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch einmal</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) wait.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Angehalten; eine Ladung wartet.</numerusform>
        <numerusform>Angehalten; %n Ladungen warten.</numerusform>
      </translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: angehalten</translation>
    </message>
    <message>
      <source>%1: %2, %3 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, %3 %</translation>
    </message>
    <message>
      <source>being photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wird aufgenommen</translation>
    </message>
    <message>
      <source>waits for its turn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wartet</translation>
    </message>
    <message>
      <source>is being computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wird berechnet</translation>
    </message>
    <message>
      <source>paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>angehalten</translation>
    </message>
    <message>
      <source>stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgebrochen</translation>
    </message>
    <message>
      <source>wants your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>braucht Ihren Blick</translation>
    </message>
    <message>
      <source>done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fertig</translation>
    </message>
    <message>
      <source>decided; to be computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>entschieden; noch zu berechnen</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe</numerusform>
        <numerusform>%n Scherben</numerusform>
      </translation>
    </message>
    <message>
      <source>sure %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sicher %1</translation>
    </message>
    <message>
      <source>decided %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>entschieden %1</translation>
    </message>
    <message>
      <source>ask %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fraglich %1</translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; aber %n auf dem Teller gezählt</numerusform>
        <numerusform>%1; aber %n auf dem Teller gezählt</numerusform>
      </translation>
    </message>
    <message>
      <source>draft, to be computed again; %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entwurf, noch endgültig zu berechnen; %1</translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wartet auf den Entwurf von %2.</translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the marks by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 wurde angestoßen: Sie verfehlt die Marken um %2 px, %3 mm neben dem Ort ihrer Kalibrierung.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für diese Ladung wurden die Kameras neu gefunden; kalibrieren Sie den Messplatz neu (C).</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BigButton</name>
    <message>
      <source>Key: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taste: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BulkEdit</name>
    <message>
      <source>Field to change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Feld, das geändert wird</translation>
    </message>
    <message>
      <source>New value for all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neuer Wert für alle</translation>
    </message>
    <message>
      <source>new value; empty deletes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>neuer Wert; leer löscht</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe</translation>
    </message>
    <message>
      <source>now</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>jetzt</translation>
    </message>
    <message>
      <source>then</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dann</translation>
    </message>
    <message>
      <source>What would change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was sich ändern würde</translation>
    </message>
    <message>
      <source>Change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ändern</translation>
    </message>
    <message>
      <source>Give numbers to the drafts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Entwürfen Nummern geben</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Feld</translation>
    </message>
    <message>
      <source>Value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wert</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe gewählt</numerusform>
        <numerusform>%n Scherben gewählt</numerusform>
      </translation>
    </message>
    <message>
      <source>Type a value to see what would change.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geben Sie einen Wert ein, um zu sehen, was sich ändern würde.</translation>
    </message>
    <message>
      <source>Preview of a change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorschau einer Änderung</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch keine Nummer</translation>
    </message>
    <message>
      <source>refused: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgelehnt: %1</translation>
    </message>
    <message>
      <source>%1 change, %2 stay as they are, %3 are refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ändern sich, %2 bleiben, wie sie sind, %3 werden abgelehnt.</translation>
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe ändern</numerusform>
        <numerusform>%n Scherben ändern</numerusform>
      </translation>
    </message>
    <message>
      <source>Progress of the changes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt der Änderungen</translation>
    </message>
    <message>
      <source>Stop and take back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anhalten und zurücknehmen</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CandidateBar</name>
    <message>
      <source>Another back …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Andere Rückseite …</translation>
    </message>
    <message>
      <source>rim %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rand %1</translation>
    </message>
    <message>
      <source>no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kein Rand</translation>
    </message>
    <message>
      <source>%1, with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, jetzt bei %2</translation>
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
      <translation>Kandidat %1: %2, %3, %4</translation>
    </message>
    <message>
      <source>%1, nobody's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, noch frei</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureFoot</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leertaste</translation>
    </message>
    <message>
      <source>Typed, from a code reader, or from the bag's label laid under the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Getippt, vom Codeleser, oder vom Beuteletikett unter der Kamera</translation>
    </message>
    <message>
      <source>More</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mehr</translation>
    </message>
    <message>
      <source>Import, another rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einlesen, anderer Messplatz</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureStation</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leertaste</translation>
    </message>
    <message>
      <source>%1 is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist in der Warteschlange.</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: eine Datei eingelesen; es ist in der Warteschlange.</numerusform>
        <numerusform>%1: %n Dateien eingelesen; es ist in der Warteschlange.</numerusform>
      </translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gut</translation>
    </message>
    <message>
      <source>The next thing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Nächste</translation>
    </message>
    <message>
      <source>Stop the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tisch anhalten</translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch einmal aufnehmen</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos einlesen…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scans einlesen…</translation>
    </message>
    <message>
      <source>Another rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anderer Messplatz…</translation>
    </message>
    <message>
      <source>Camera %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1</translation>
    </message>
    <message>
      <source>Capture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aufnahme</translation>
    </message>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner mit Scans in front/ und back/</translation>
    </message>
    <message>
      <source>Folder of a batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner einer Ladung</translation>
    </message>
    <message>
      <source>The picture is on its way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Bild ist unterwegs.</translation>
    </message>
    <message>
      <source>Look at this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erst hierauf sehen</translation>
    </message>
    <message>
      <source>R</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>R</translation>
    </message>
    <message>
      <source>does not answer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>antwortet nicht</translation>
    </message>
    <message>
      <source>%1 The desktop holds a camera, by its program %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Der Schreibtisch hält eine Kamera fest, mit seinem Programm %2.</translation>
    </message>
    <message>
      <source>Type the sherds' numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern der Scherben eingeben</translation>
    </message>
    <message>
      <source>Say how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sagen, wie viele Scherben da liegen</translation>
    </message>
    <message>
      <source>This project photographs with no calibrated rig of its own.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt fotografiert mit keinem eigenen, kalibrierten Messplatz.</translation>
    </message>
    <message>
      <source>The rig is calibrated by %1; the calibration before is kept as %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz ist nach %1 kalibriert; die Kalibrierung davor liegt als %2.</translation>
    </message>
    <message>
      <source>The import is stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Einlesen ist angehalten; nichts ist liegen geblieben.</translation>
    </message>
    <message>
      <source>Import them all the same</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Trotzdem importieren</translation>
    </message>
    <message>
      <source>%1 has these files already; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hat diese Dateien schon; nichts wurde importiert.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz wird geöffnet</translation>
    </message>
    <message>
      <source>%1 goes on where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 geht weiter, wo es war.</translation>
    </message>
    <message>
      <source>Photographs of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aufnahmen von %1</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bitte den Auslöser von Kamera %1 drücken.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are safe.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Die bisherige Aufnahme dieser Seite ist gesichert.</numerusform>
        <numerusform>Die %n bisherigen Aufnahmen dieser Seite sind gesichert.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at stop %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, Halt %2: %3</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>Live picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Livebild</translation>
    </message>
    <message>
      <source>Front picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild der Vorderseiten</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch kein Messplatz</translation>
    </message>
    <message>
      <source>The rig is being opened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz wird geöffnet</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben auf den Teller legen</translation>
    </message>
    <message>
      <source>Stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Angehalten</translation>
    </message>
    <message>
      <source>Photographing the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Vorderseiten werden aufgenommen</translation>
    </message>
    <message>
      <source>Turn each sherd over where it lies</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Jede Scherbe an ihrem Platz wenden</translation>
    </message>
    <message>
      <source>Photographing the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Rückseiten werden aufgenommen</translation>
    </message>
    <message>
      <source>You may clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Teller darf abgeräumt werden.</translation>
    </message>
    <message>
      <source>Look at the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vor dem Abräumen den Teller ansehen</translation>
    </message>
    <message>
      <source>Fronts up, a finger's width apart, the marks at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseite oben, einen Finger breit Abstand, die Marken am Rand frei.</translation>
    </message>
    <message>
      <source>Hands off the table. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hände weg vom Tisch. Esc hält ihn sofort an.</translation>
    </message>
    <message>
      <source>Shifting is fine, swapping is fine, losing one is not.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verschieben ist erlaubt, Vertauschen auch, Verlieren nicht.</translation>
    </message>
    <message>
      <source>%1 is in the queue; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist in der Warteschlange; die nächste Ladung ist eine Taste entfernt.</translation>
    </message>
    <message>
      <source>Space goes on all the same, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leertaste: trotzdem weiter. R: Rückseiten noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>Done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erledigt</translation>
    </message>
    <message>
      <source>Try again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch einmal versuchen</translation>
    </message>
    <message>
      <source>Shoot the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseiten aufnehmen</translation>
    </message>
    <message>
      <source>All turned: shoot the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle gewendet: Rückseiten aufnehmen</translation>
    </message>
    <message>
      <source>Next batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nächste Ladung</translation>
    </message>
    <message>
      <source>It is right: into the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es stimmt: in die Warteschlange</translation>
    </message>
    <message>
      <source>Stop %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Halt %1 von %2</translation>
    </message>
    <message>
      <source>One moment</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Moment</translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Vorn: eine Scherbe</numerusform>
        <numerusform>Vorn: %n Scherben</numerusform>
      </translation>
    </message>
    <message>
      <source>Front: %1 sherds, now %2 are seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorn: %1 Scherben, jetzt sind %2 zu sehen</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorn %1, hinten %2</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) are safe</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Aufnahme ist gesichert</numerusform>
        <numerusform>%n Aufnahmen sind gesichert</numerusform>
      </translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Kamera zeigt kein Livebild.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe zu sehen</numerusform>
        <numerusform>%n Scherben zu sehen</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 may be two sherds, too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sind vielleicht zwei Scherben, zu nah beieinander</translation>
    </message>
    <message>
      <source>%1 and %2 lie too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 und %2 liegen zu nah beieinander</translation>
    </message>
    <message>
      <source>%1 reaches out of the picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ragt aus dem Bild</translation>
    </message>
    <message>
      <source>Marks %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marken %1 von %2</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too dark</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 % der Scherben sind zu dunkel</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too bright</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 % der Scherben sind zu hell</translation>
    </message>
    <message>
      <source>Light is right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Licht stimmt</translation>
    </message>
    <message>
      <source>Read from the label: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vom Etikett gelesen: %1</translation>
    </message>
    <message>
      <source>No room for more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Platz für weitere</translation>
    </message>
    <message numerus="yes">
      <source>Room for about %n more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Platz für etwa eine weitere</numerusform>
        <numerusform>Platz für etwa %n weitere</numerusform>
      </translation>
    </message>
    <message>
      <source>Looking for what holds the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es wird gesucht, was die Kamera festhält</translation>
    </message>
    <message>
      <source>Making the desktop let go of the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Schreibtisch soll die Kamera loslassen</translation>
    </message>
    <message>
      <source>Make the desktop let go</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera vom Schreibtisch lösen</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: look for one that hides, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie haben %1 Scherben gezählt, die Fotos zeigen %2: Suchen Sie eine, die verdeckt ist, eine andere berührt oder gar nicht hingelegt wurde.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie haben %1 gezählt</translation>
    </message>
    <message>
      <source>Marks %1 of %2, %3 are needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marken %1 von %2, nötig sind %3</translation>
    </message>
    <message>
      <source>Its sherds stand in the review (Ctrl+3): look while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre Scherben stehen in der Durchsicht (Strg+3): Sehen Sie nach, solange sie noch hier liegen</translation>
    </message>
    <message>
      <source>The table stands still. What is safe is not photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Tisch steht still. Was sicher ist, wird nicht noch einmal fotografiert.</translation>
    </message>
    <message>
      <source>Go on at stop %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bei Halt %1 weitermachen</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wurde mitten in dieser Seite unterbrochen.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CatalogueStation</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 einer Scherbe ändern</numerusform>
        <numerusform>%1 von %n Scherben ändern</numerusform>
      </translation>
    </message>
    <message>
      <source>Catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalog</translation>
    </message>
    <message>
      <source>Export these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese ausgeben</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihr Kürzel</translation>
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wer arbeitet? Ihr Kürzel kommt in die Geschichte:</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben</translation>
    </message>
    <message>
      <source>Search</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Suchen</translation>
    </message>
    <message>
      <source>Edit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bearbeiten</translation>
    </message>
    <message>
      <source>Give numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern geben</translation>
    </message>
    <message>
      <source>No sherds yet. They come by themselves when a batch is computed; start with Capture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch keine Scherben. Sie kommen von selbst, wenn eine Ladung berechnet ist; beginnen Sie mit der Aufnahme.</translation>
    </message>
    <message>
      <source>No sherd fits. Take a condition away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Scherbe passt. Nehmen Sie eine Bedingung weg.</translation>
    </message>
    <message>
      <source>change %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ändern</translation>
    </message>
    <message>
      <source>move to another context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>in einen anderen Befund verlegen</translation>
    </message>
    <message>
      <source>changes by the import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Änderungen durch das Einlesen von %1</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 eingelesen: %2</translation>
    </message>
    <message>
      <source>Import …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einlesen …</translation>
    </message>
    <message>
      <source>Numbers, contexts and descriptions from a table, or an export (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern, Befunde und Beschreibungen aus einer Tabelle, oder eine Ausgabe (%1)</translation>
    </message>
    <message>
      <source>About what is chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zum Gewählten</translation>
    </message>
    <message>
      <source>Details</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einzelheiten</translation>
    </message>
    <message>
      <source>Drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeichnung</translation>
    </message>
    <message>
      <source>Details or drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einzelheiten oder Zeichnung</translation>
    </message>
    <message>
      <source>enter the rim's diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>den Randdurchmesser eintragen</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einlesen</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Einlesen von %1 brach nach %2 von %3 Zeilen ab; diese sind vollständig. Für den Rest noch einmal einlesen.</translation>
    </message>
    <message>
      <source>Do not tell this again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das nicht wieder melden</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen Sie die Scherben, die Nummern bekommen sollen.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::DrawingPage</name>
    <message>
      <source>Scale of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab der Zeichnung</translation>
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
      <translation>Wie Oberflächen gezeichnet werden</translation>
    </message>
    <message>
      <source>Light and shade of the form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Licht und Schatten der Form</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mit Bemalung und Engobe</translation>
    </message>
    <message>
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ob es ein Randstück ist</translation>
    </message>
    <message>
      <source>As the parts say, or as is likely</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wie es die Teile sagen, oder wie es wahrscheinlich ist</translation>
    </message>
    <message>
      <source>It is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es ist ein Randstück</translation>
    </message>
    <message>
      <source>It is no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es ist kein Randstück</translation>
    </message>
    <message>
      <source>Scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab</translation>
    </message>
    <message>
      <source>Surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oberfläche</translation>
    </message>
    <message>
      <source>Rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rand</translation>
    </message>
    <message>
      <source>Enter the diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchmesser eintragen</translation>
    </message>
    <message>
      <source>Save …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Speichern …</translation>
    </message>
    <message>
      <source>Print …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Drucken …</translation>
    </message>
    <message>
      <source>Print the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeichnung drucken</translation>
    </message>
    <message>
      <source>Progress of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt der Zeichnung</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>The sheet before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Blatt davor</translation>
    </message>
    <message>
      <source>The next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das nächste Blatt</translation>
    </message>
    <message>
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was die Zeichnung sagt</translation>
    </message>
    <message>
      <source>Drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeichnungen</translation>
    </message>
    <message>
      <source>Stopped; nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Angehalten; nichts wurde gezeichnet.</translation>
    </message>
    <message>
      <source>A sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Blatt</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe wird gezeichnet …</numerusform>
        <numerusform>%n Scherben werden gezeichnet …</numerusform>
      </translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen Sie eine Scherbe.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: %2 to %3), %4 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mündung %1 cm weit (95 %: %2 bis %3), %4 % des Randes erhalten.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: above %2), %3 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mündung %1 cm weit (95 %: über %2), %3 % des Randes erhalten.</translation>
    </message>
    <message>
      <source>%1 drawn, %2 left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 gezeichnet, %2 ausgelassen.</translation>
    </message>
    <message numerus="yes">
      <source>Draw plates of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Tafel einer Scherbe zeichnen</numerusform>
        <numerusform>Tafeln von %n Scherben zeichnen</numerusform>
      </translation>
    </message>
    <message>
      <source>Sheet %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Blatt %1 von %2</translation>
    </message>
    <message>
      <source>plates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tafeln</translation>
    </message>
    <message>
      <source>Save the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeichnung speichern</translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, alle Blätter (*.pdf);;SVG, eine Datei je Blatt (*.svg)</translation>
    </message>
    <message>
      <source>Saving a drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Zeichnung wird gespeichert</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert: %1</translation>
    </message>
    <message>
      <source>Printing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird gedruckt</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeichnung geht an den Drucker; drucken Sie mit 100 %.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportModel</name>
    <message>
      <source>Size of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Umfang der Ausgabe</translation>
    </message>
    <message>
      <source>Counting …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird gezählt …</translation>
    </message>
    <message>
      <source>No sherd fits; choose others.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Scherbe passt; wählen Sie andere.</translation>
    </message>
    <message>
      <source>less than a minute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>weniger als eine Minute</translation>
    </message>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>etwa eine Minute</numerusform>
        <numerusform>etwa %n Minuten</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe, %1 Dateien, %2, %3</numerusform>
        <numerusform>%n Scherben, %1 Dateien, %2, %3</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>eine davon ohne Modell</numerusform>
        <numerusform>%n davon ohne Modell</numerusform>
      </translation>
    </message>
    <message>
      <source>There is a folder of this name already; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Ordner dieses Namens gibt es schon; wählen Sie einen anderen Namen.</translation>
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
        <numerusform>%1, noch eine Sekunde</numerusform>
        <numerusform>%1, noch %n Sekunden</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe, %1, Verzeichnis geprüft</numerusform>
        <numerusform>%n Scherben, %1, Verzeichnis geprüft</numerusform>
      </translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ausgabe</translation>
    </message>
    <message>
      <source>Stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Angehalten; nichts blieb zurück.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportStation</name>
    <message>
      <source>Exported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ausgegeben: %1</translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ausgabe</translation>
    </message>
    <message>
      <source>What</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was</translation>
    </message>
    <message>
      <source>All sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle Scherben</translation>
    </message>
    <message>
      <source>Those that fit this filter:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die, auf die dieser Filter passt:</translation>
    </message>
    <message>
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Filter für die Ausgabe</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>context:0012</translation>
    </message>
    <message>
      <source>Forms</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Formen</translation>
    </message>
    <message>
      <source>Tables (CSV), for spreadsheets</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabellen (CSV), für Tabellenprogramme</translation>
    </message>
    <message>
      <source>Records (JSON), to be read back whole</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Datensätze (JSON), die sich ganz zurücklesen lassen</translation>
    </message>
    <message>
      <source>A picture of each model (PNG)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Bild jedes Modells (PNG)</translation>
    </message>
    <message>
      <source>Models as PLY, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelle als PLY, in mm</translation>
    </message>
    <message>
      <source>Models as GLB, for the web and for slides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelle als GLB, für das Netz und für Vorträge</translation>
    </message>
    <message>
      <source>Models as OBJ, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelle als OBJ, in mm</translation>
    </message>
    <message>
      <source>The photographs, unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Aufnahmen, unverändert</translation>
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wo</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neuer Ordner für die Ausgabe</translation>
    </message>
    <message>
      <source>Choose …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen …</translation>
    </message>
    <message>
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt der Ausgabe</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner öffnen</translation>
    </message>
    <message>
      <source>Where shall the folder be?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wo soll der Ordner sein?</translation>
    </message>
    <message>
      <source>Those chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die im Katalog gewählten</translation>
    </message>
    <message numerus="yes">
      <source>The %n chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Die eine im Katalog gewählte</numerusform>
        <numerusform>Die %n im Katalog gewählten</numerusform>
      </translation>
    </message>
    <message>
      <source>Drawings for print (SVG and PDF)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeichnungen für den Druck (SVG und PDF)</translation>
    </message>
    <message>
      <source>Scale of the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab der Zeichnungen</translation>
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
      <translation>wie es auf A4 passt</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabellen (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>Pictures, masks, poses for COLMAP and OpenMVS</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilder, Masken, Posen für COLMAP und OpenMVS</translation>
    </message>
    <message>
      <source>Detail of the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Feinheit der Modelle</translation>
    </message>
    <message>
      <source>Of PLY, GLB and OBJ: with fewer triangles the files are a fraction as large. How far they are off is measured and stated in each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von PLY, GLB und OBJ: Mit weniger Dreiecken sind die Dateien um ein Vielfaches kleiner. Wie weit sie abweichen, wird gemessen und steht in jeder.</translation>
    </message>
    <message>
      <source>as computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wie berechnet</translation>
    </message>
    <message>
      <source>lighter, to %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>leichter, auf %1 mm</translation>
    </message>
    <message>
      <source>Stop the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ausgabe anhalten</translation>
    </message>
    <message>
      <source>Export: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ausgabe: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FilterLine</name>
    <message>
      <source>Filter of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Filter des Katalogs</translation>
    </message>
    <message>
      <source>rim T3 thickness&gt;6</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rim T3 thickness&gt;6</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wörter werden überall gesucht; auch ware:grey, thickness&gt;6, -burnt, note:* gehen.</translation>
    </message>
    <message>
      <source>Take away the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Bedingung %1 wegnehmen</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe</numerusform>
        <numerusform>%n Scherben</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FooterLine</name>
    <message>
      <source>What the computer does</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was der Rechner tut</translation>
    </message>
    <message>
      <source>What was done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was getan wurde</translation>
    </message>
    <message>
      <source>Progress of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt der Berechnung</translation>
    </message>
    <message>
      <source>Nothing to compute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nichts zu berechnen</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HeaderLine</name>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wo</translation>
    </message>
    <message>
      <source>Rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatz</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Platz auf der Platte</translation>
    </message>
    <message>
      <source>Rig: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatz: %1</translation>
    </message>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Platte: Platz für eine Ladung</numerusform>
        <numerusform>Platte: Platz für %n Ladungen</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HelpPage</name>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Handbuch</translation>
    </message>
    <message>
      <source>&amp;Contents</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Inhalt</translation>
    </message>
    <message>
      <source>All &amp;keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle &amp;Tasten</translation>
    </message>
    <message>
      <source>&amp;About</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ü&amp;ber</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zurück zur Arbeit (Esc)</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle Tasten</translation>
    </message>
    <message>
      <source>Complete, measured 3D models of potsherds from photographs of both their sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vollständige, vermessene 3D-Modelle von Scherben aus Aufnahmen beider Seiten.</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apache-Lizenz 2.0. Es benutzt unter anderem Qt (LGPL 3), VTK und OpenCV; die Datei LICENSE und das README nennen alle.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: there is no network in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nichts verlässt diesen Rechner: es benutzt kein Netz.</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Handbuch gibt es nur auf Englisch.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportDialog</name>
    <message>
      <source>new</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>neu</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>verändert</translation>
    </message>
    <message>
      <source>refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgelehnt</translation>
    </message>
    <message>
      <source>as it is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wie es ist</translation>
    </message>
    <message>
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In den Katalog einlesen</translation>
    </message>
    <message>
      <source>A table (CSV) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Tabelle (CSV) …</translation>
    </message>
    <message>
      <source>An export folder …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Ausgabeordner …</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fundorte, Schnitte, Befunde und Beutel anlegen, die es noch nicht gibt</translation>
    </message>
    <message>
      <source>What each row would do</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was jede Zeile bewirken würde</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt des Einlesens</translation>
    </message>
    <message>
      <source>Save what is refused …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgelehntes speichern …</translation>
    </message>
    <message>
      <source>Which table?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Welche Tabelle?</translation>
    </message>
    <message>
      <source>Tables (*.csv *.tsv *.txt);;All (*)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabellen (*.csv *.tsv *.txt);;Alle (*)</translation>
    </message>
    <message>
      <source>Which export?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Welche Ausgabe?</translation>
    </message>
    <message>
      <source>Save what is refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgelehntes speichern</translation>
    </message>
    <message>
      <source>refused.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgelehnt.csv</translation>
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert: %1</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeile</translation>
    </message>
    <message>
      <source>what happens</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>was geschieht</translation>
    </message>
    <message>
      <source>why not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>warum nicht</translation>
    </message>
    <message>
      <source>A table of sherds has a column number or uuid; one of contexts has site, context and, if you like, trench and bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbentabelle hat eine Spalte number oder uuid; eine Befundtabelle hat site, context und, wenn Sie wollen, trench und bag.</translation>
    </message>
    <message>
      <source>Looking at it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird angesehen …</translation>
    </message>
    <message>
      <source>Entered: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eingetragen: %1</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schließen</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Take nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nichts übernehmen</translation>
    </message>
    <message numerus="yes">
      <source>Enter %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Zeile eintragen</numerusform>
        <numerusform>%n Zeilen eintragen</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 „%2“: %3</translation>
    </message>
    <message>
      <source>Preview of an import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorschau eines Einlesens</translation>
    </message>
    <message>
      <source>%1 new, %2 changed, %3 as they are, %4 refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 neu, %2 verändert, %3 wie sie sind, %4 abgelehnt.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einlesen</translation>
    </message>
    <message>
      <source>Stopped; nothing was entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Angehalten; nichts wurde eingetragen.</translation>
    </message>
    <message numerus="yes">
      <source>Stopped: %n row(s) are not entered. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Angehalten: %n Zeile ist nicht eingetragen. Für den Rest die Tabelle noch einmal einlesen.</numerusform>
        <numerusform>Angehalten: %n Zeilen sind nicht eingetragen. Für den Rest die Tabelle noch einmal einlesen.</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::JoinMode</name>
    <message>
      <source>Which back belongs to the one of %1? Choose its card (arrows and Enter).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Welche Rückseite gehört zu der von %1? Wählen Sie ihre Karte (Pfeile und Eingabe).</translation>
    </message>
    <message>
      <source>Which front belongs to the one of %1? Choose its card (arrows and Enter); a click on a back's picture joins the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Welche Vorderseite gehört zu der von %1? Wählen Sie ihre Karte (Pfeile und Eingabe); ein Klick auf das Bild einer Rückseite verbindet die Rückseiten.</translation>
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
      <translation>%1 ist berechnet.</translation>
    </message>
    <message>
      <source>%1 stopped: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist abgebrochen: %2</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückgängig</translation>
    </message>
    <message>
      <source>Do again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wiederholen</translation>
    </message>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Handbuch</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle Tasten</translation>
    </message>
    <message>
      <source>Other projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Andere Projekte</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekte</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einstellungen</translation>
    </message>
    <message>
      <source>Help</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hilfe</translation>
    </message>
    <message>
      <source>Back to work</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zurück zur Arbeit</translation>
    </message>
    <message>
      <source>This project is open in another window already: go on there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt ist schon in einem anderen Fenster offen: dort weitermachen.</translation>
    </message>
    <message>
      <source>%1 - Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 - Ostraka</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Virtueller Messplatz</translation>
    </message>
    <message>
      <source>Virtual rig %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Virtueller Messplatz %1</translation>
    </message>
    <message>
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Überall</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Platz auf der Platte</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Berechnung wird angehalten; sie geht weiter, sobald das Projekt wieder geöffnet wird. Das Fenster schließt gleich.</translation>
    </message>
    <message>
      <source>Queue: mending masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Warteschlange: Masken ausbessern</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückgängig: %1</translation>
    </message>
    <message>
      <source>Do again: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wiederholen: %1</translation>
    </message>
    <message>
      <source>Copy of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kopie des Katalogs</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Katalog konnte nicht kopiert werden: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladung</translation>
    </message>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan und Etiketten drucken</translation>
    </message>
    <message>
      <source>Print map and labels   Ctrl+P</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan und Etiketten drucken   Strg+P</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1</translation>
    </message>
    <message>
      <source>No batch is computed yet; its map appears here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch keine Ladung ist berechnet; ihr Plan erscheint hier.</translation>
    </message>
    <message>
      <source>Map of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan von %1</translation>
    </message>
    <message>
      <source>%1-%2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-%2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladung %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladung %1, %2</translation>
    </message>
    <message>
      <source>Map and labels are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan und Etiketten gehen an den Drucker.</translation>
    </message>
    <message>
      <source>Map</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan</translation>
    </message>
    <message>
      <source>Print bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beuteletiketten drucken</translation>
    </message>
    <message>
      <source>Bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beuteletiketten</translation>
    </message>
    <message>
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Etikett für jeden Beutel drucken; sein Code gibt einer Ladung ihren Befund (Strg+Umschalt+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es gibt noch keinen Beutel: beim Aufnehmen einen eintippen oder eine Befundtabelle einlesen.</translation>
    </message>
    <message numerus="yes">
      <source>%n label(s) are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Etikett ist zum Drucker geschickt.</numerusform>
        <numerusform>%n Etiketten sind zum Drucker geschickt.</numerusform>
      </translation>
    </message>
    <message>
      <source>This batch was scanned, not photographed: there is no picture of its plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ladung wurde gescannt, nicht fotografiert: Von ihrem Teller gibt es kein Bild.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe dieser Ladung hat noch keine Nummer: Ihr Etikett nennt die Ladung.</numerusform>
        <numerusform>%n Scherben dieser Ladung haben noch keine Nummer: Ihre Etiketten nennen die Ladung.</numerusform>
      </translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Teller, vorn und hinten</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseite</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseite</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MessagePanel</name>
    <message>
      <source>What happened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was geschehen ist</translation>
    </message>
    <message>
      <source>Leave it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>So lassen</translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gut</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ModelPane</name>
    <message>
      <source>Picture of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild der Scherbe</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Cut the model open; Shift and the wheel move the plane</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Modell aufschneiden; Umschalt und das Mausrad bewegen die Ebene</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von oben</translation>
    </message>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild einer Scherbe</translation>
    </message>
    <message>
      <source>Model of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modell einer Scherbe</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site's code has two to eight capital letters and digits, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel des Fundorts hat zwei bis acht Großbuchstaben und Ziffern, wie ARM1.</translation>
    </message>
    <message>
      <source>Choose a folder for the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bitte einen Ordner für das Projekt wählen.</translation>
    </message>
    <message>
      <source>There is a project in this folder already: open it, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ordner ist schon ein Projekt: öffnen Sie es, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
      <source>This folder holds other files: choose a new one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ordner liegen andere Dateien: bitte einen neuen wählen.</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Virtueller Messplatz</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::OutlinePlot</name>
    <message>
      <source>Outlines laid over each other, and their turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Umrisse übereinandergelegt, und ihre Drehwinkel</translation>
    </message>
    <message>
      <source>The turning angles differ by %1 rad.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Drehwinkel unterscheiden sich um %1 rad.</translation>
    </message>
    <message>
      <source>outlines on each other</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Umrisse übereinander</translation>
    </message>
    <message>
      <source>turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Drehwinkel</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>differ by %1 rad</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unterschied %1 rad</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PairReviewModel</name>
    <message>
      <source>Small pictures of the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kleine Bilder der Scherben</translation>
    </message>
    <message>
      <source>%1, %2. %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2. %3</translation>
    </message>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Rückseite ist gewählt.</translation>
    </message>
    <message>
      <source>The rims do not meet here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ränder treffen sich hier nicht.</translation>
    </message>
    <message>
      <source>Rims %1 apart, %2 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ränder %1 auseinander, %2 davon treffen sich.</translation>
    </message>
    <message>
      <source>Turned by hand; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Hand gedreht; B lässt die Ränder einrasten.</translation>
    </message>
    <message>
      <source>Start point %1; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anfangspunkt %1; B lässt die Ränder einrasten.</translation>
    </message>
    <message>
      <source>Choose a back first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen Sie zuerst eine Rückseite.</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geben Sie zuerst Ihr Kürzel ein: Jede Entscheidung behält ihren Namen.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wahl von %1</translation>
    </message>
    <message>
      <source>Comparing two sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Seiten werden verglichen</translation>
    </message>
    <message>
      <source>pair %1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Paar %1 – %2</translation>
    </message>
    <message>
      <source>setting aside %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beiseitelegen von %1</translation>
    </message>
    <message>
      <source>shooting %1 again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neuaufnahme von %1</translation>
    </message>
    <message>
      <source>One of the two has no back to be joined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine der beiden hat keine Rückseite, die sich anfügen ließe.</translation>
    </message>
    <message>
      <source>joining %1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verbinden von %1 und %2</translation>
    </message>
    <message>
      <source>cutting %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zerschneiden von %1</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anfangspunkt</translation>
    </message>
    <message>
      <source>settling by the rims</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einrasten der Ränder</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Drehen von Hand</translation>
    </message>
    <message>
      <source>Closed model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geschlossenes Modell</translation>
    </message>
    <message>
      <source>This pair has no closed model yet; it is made when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Paar hat noch kein geschlossenes Modell; es entsteht, wenn die Ladung berechnet wird.</translation>
    </message>
    <message>
      <source>Picture of a pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild eines Paars</translation>
    </message>
    <message>
      <source>More candidates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Weitere Kandidaten</translation>
    </message>
    <message>
      <source>This back lies alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Rückseite liegt allein.</translation>
    </message>
    <message>
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Paar ist gewählt: Geben Sie diese Rückseite erst einer Vorderseite.</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Rückseite allein hat kein geschlossenes Modell.</translation>
    </message>
    <message>
      <source>Stopped; the back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Angehalten; die Rückseite bleibt, wo sie war.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was nur ausprobiert wurde, gibt es nicht mehr: Seine Paare wurden seither geschlossen.</translation>
    </message>
    <message>
      <source>Saved, with your name; but the rims of %1 and %2 hardly meet: %3 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert, mit Ihrem Namen; aber die Ränder von %1 und %2 treffen sich kaum: %3 davon.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aufnahmen beider Seiten</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorn %1, hinten %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Aufnahme ist nicht da.</translation>
    </message>
    <message>
      <source>front %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseite %1</translation>
    </message>
    <message>
      <source>back %1, mirrored</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseite %1, gespiegelt</translation>
    </message>
    <message>
      <source>back %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseite %1</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Line over the %1, %2 steps from its middle, turned by %3 degrees</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Linie über %1, %2 Schritte neben der Mitte, um %3 Grad gedreht</translation>
    </message>
    <message>
      <source>Arrows move the line, with Shift they turn it, Up or Down takes the other side, Enter cuts. Or draw a line with the mouse.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pfeile verschieben die Linie, mit Umschalt drehen sie sie, Auf oder Ab nimmt die andere Seite, Enter schneidet. Oder mit der Maus eine Linie ziehen.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlaceEdit</name>
    <message>
      <source>&amp;Bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Beutel</translation>
    </message>
    <message>
      <source>scan its label, or ARM1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Etikett scannen, oder ARM1-T3-0012-4</translation>
    </message>
    <message>
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fundort, Schnitt, Befund und Beutel</translation>
    </message>
    <message>
      <source>no bag: no numbers yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kein Beutel: noch keine Nummern</translation>
    </message>
    <message>
      <source>site-trench-context-bag, please</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bitte Fundort-Schnitt-Befund-Beutel</translation>
    </message>
    <message>
      <source>New: %1 (Esc takes it back)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neu: %1 (Esc nimmt es zurück)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlateView</name>
    <message>
      <source>Picture of the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild des Tellers</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe zu sehen</numerusform>
        <numerusform>%n Scherben zu sehen</numerusform>
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
      <translation>Pause</translation>
    </message>
    <message>
      <source>Compute again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch einmal berechnen</translation>
    </message>
    <message>
      <source>Stop this batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ladung anhalten</translation>
    </message>
    <message>
      <source>Report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Review it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchsehen</translation>
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Protokoll</translation>
    </message>
    <message>
      <source>Batches</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladungen</translation>
    </message>
    <message>
      <source>Log of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Protokoll der Berechnung</translation>
    </message>
    <message>
      <source>No batch yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch keine Ladung</translation>
    </message>
    <message>
      <source>What you photograph or import is computed here, one batch after the other, while you go on working.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was Sie aufnehmen oder einlesen, wird hier berechnet, eine Ladung nach der anderen, während Sie weiterarbeiten.</translation>
    </message>
    <message>
      <source>Photograph the first batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die erste Ladung aufnehmen</translation>
    </message>
    <message>
      <source>Queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Warteschlange</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Ladung ist abgebrochen und braucht Sie</numerusform>
        <numerusform>%n Ladungen sind abgebrochen und brauchen Sie</numerusform>
      </translation>
    </message>
    <message>
      <source>Go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Weiter</translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hat noch keinen Bericht.</translation>
    </message>
    <message>
      <source>Stop %1?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 anhalten?</translation>
    </message>
    <message>
      <source>It has been computed for more than an hour. Whole stages are kept, the present one is lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es wird seit mehr als einer Stunde berechnet. Ganze Stufen bleiben, die jetzige geht verloren.</translation>
    </message>
    <message>
      <source>Stop it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Let it go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
      <source>Mend the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken ausbessern</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erst Entwürfe</translation>
    </message>
    <message>
      <source>Computes each new batch quickly and coarsely, to be looked at while the sherds still lie there; computed again it becomes final (D)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Berechnet jede neue Ladung schnell und grob, um sie anzusehen, solange die Scherben noch daliegen; noch einmal berechnet wird sie endgültig (D)</translation>
    </message>
    <message>
      <source>Calibrate the rig again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatz neu kalibrieren</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Kamera wurde angestoßen: Die Fotos dieser Ladung sagen, wo die Kameras jetzt stehen (C)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Rail</name>
    <message>
      <source>Stations</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Stationen</translation>
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
      <translation>Paare, die fraglichsten zuerst</translation>
    </message>
    <message>
      <source>This one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses</translation>
    </message>
    <message>
      <source>Next pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nächstes Paar</translation>
    </message>
    <message>
      <source>Previous pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Voriges Paar</translation>
    </message>
    <message>
      <source>Candidate %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kandidat %1</translation>
    </message>
    <message>
      <source>Start point before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anfangspunkt davor</translation>
    </message>
    <message>
      <source>Next start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nächster Anfangspunkt</translation>
    </message>
    <message>
      <source>One sample back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Stelle zurück</translation>
    </message>
    <message>
      <source>One sample on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Stelle weiter</translation>
    </message>
    <message>
      <source>Mirror back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Spiegeln</translation>
    </message>
    <message>
      <source>Apart</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Trennen</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messen</translation>
    </message>
    <message>
      <source>Rim gap</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Randabstand</translation>
    </message>
    <message>
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modell</translation>
    </message>
    <message>
      <source>Settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einrasten</translation>
    </message>
    <message>
      <source>Let the rims settle the position (B)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ränder die Lage finden lassen (B)</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beiseite</translation>
    </message>
    <message>
      <source>Shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neu aufnehmen</translation>
    </message>
    <message>
      <source>Cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zerteilen</translation>
    </message>
    <message>
      <source>Join</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verbinden</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>%1, key %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, Taste %2</translation>
    </message>
    <message>
      <source>This one   Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses   Eingabe</translation>
    </message>
    <message>
      <source>The rims are compared … Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ränder werden verglichen … Esc hält an.</translation>
    </message>
    <message>
      <source>… and the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>… und das andere Ende</translation>
    </message>
    <message>
      <source>Pairs of the batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Paare der Ladung</translation>
    </message>
    <message>
      <source>Join two pieces of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Stücke einer Scherbe verbinden: danach die andere Karte wählen (J Vorderseiten, Umschalt+J Rückseiten)</translation>
    </message>
    <message>
      <source>Join backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseiten verbinden</translation>
    </message>
    <message>
      <source>Settle, join and cut nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nichts einpassen, verbinden oder schneiden</translation>
    </message>
    <message>
      <source>Cut a piece that is two sherds in truth, along a line over its picture (K)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Stück zerschneiden, das in Wahrheit zwei Scherben ist, entlang einer Linie über seinem Bild (K)</translation>
    </message>
    <message>
      <source>The rims settle: %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ränder finden sich: %1. Esc hält an.</translation>
    </message>
    <message>
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klicken Sie auf der Scherbe auf ein Ende der Strecke, dann auf das andere. D beendet.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladung</translation>
    </message>
    <message>
      <source>Your &amp;initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihr &amp;Kürzel</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihr Kürzel</translation>
    </message>
    <message>
      <source>Compute what changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geändertes berechnen</translation>
    </message>
    <message>
      <source>Makes the models of the pairs that were decided anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Macht die Modelle der neu entschiedenen Paare</translation>
    </message>
    <message>
      <source>No batch is computed yet. Shoot or import one; its pairs appear here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch keine Ladung ist berechnet. Nehmen Sie eine auf oder lesen Sie eine ein; ihre Paare erscheinen hier.</translation>
    </message>
    <message>
      <source>Opening %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird geöffnet</translation>
    </message>
    <message>
      <source>%1 waits to be computed; only what changed is done again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wartet auf die Berechnung; nur was sich geändert hat, wird neu gemacht.</translation>
    </message>
    <message>
      <source>Saved. The pairs of the new pieces come when it is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Die Paare der neuen Stücke kommen, wenn berechnet ist.</translation>
    </message>
    <message>
      <source>Taken back. Both are kept in the history.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zurückgenommen. Beides bleibt in der Geschichte.</translation>
    </message>
    <message>
      <source>Saved, with your name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert, mit Ihrem Namen.</translation>
    </message>
    <message>
      <source>No pair needs your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Paar braucht Ihr Auge</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) need your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ein Paar braucht Ihr Auge</numerusform>
        <numerusform>%n Paare brauchen Ihr Auge</numerusform>
      </translation>
    </message>
    <message>
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchsicht</translation>
    </message>
    <message>
      <source>Where its report is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zu ihrem Bericht</translation>
    </message>
    <message>
      <source>None of the measures of %1 is sure. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keines der Maße von %1 ist sicher. %2</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigPage</name>
    <message>
      <source>Two of them look alike</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei davon sehen gleich aus</translation>
    </message>
    <message>
      <source>What do you photograph with?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Womit wird aufgenommen?</translation>
    </message>
    <message>
      <source>The virtual rig breaks a pot and photographs its sherds: try everything with it. A rig file (RIG.json) names your cameras and your turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der virtuelle Messplatz zerbricht ein Gefäß und nimmt seine Scherben auf: damit lässt sich alles ausprobieren. Eine Messplatzdatei (RIG.json) nennt Ihre Kameras und Ihren Drehtisch.</translation>
    </message>
    <message>
      <source>Use the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den virtuellen Messplatz nehmen</translation>
    </message>
    <message>
      <source>Choose a rig file…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatzdatei wählen…</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos einlesen…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scans einlesen…</translation>
    </message>
    <message>
      <source>The virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der virtuelle Messplatz</translation>
    </message>
    <message>
      <source>small: a batch in a minute or two</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>klein: eine Ladung in ein, zwei Minuten</translation>
    </message>
    <message>
      <source>normal</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>normal</translation>
    </message>
    <message>
      <source>fine: as a real camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fein: wie eine echte Kamera</translation>
    </message>
    <message>
      <source>&amp;Sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Scherben auf dem Teller</translation>
    </message>
    <message>
      <source>&amp;Photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Aufnahmen</translation>
    </message>
    <message>
      <source>%1 pixels wide</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Pixel breit</translation>
    </message>
    <message>
      <source>Rig file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatzdatei</translation>
    </message>
    <message>
      <source>Rig (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatz (*.json)</translation>
    </message>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leertaste</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SettingsPage</name>
    <message>
      <source>As the desktop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wie der Schreibtisch</translation>
    </message>
    <message>
      <source>Light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hell</translation>
    </message>
    <message>
      <source>Dark, for the tent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dunkel, für das Zelt</translation>
    </message>
    <message>
      <source>Sunlight: black on white, thick lines</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonne: schwarz auf weiß, dicke Linien</translation>
    </message>
    <message>
      <source>all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>alle</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einstellungen</translation>
    </message>
    <message>
      <source>&amp;Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Ihr Kürzel</translation>
    </message>
    <message>
      <source>They stand in the history of each decision.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es steht im Verlauf jeder Entscheidung.</translation>
    </message>
    <message>
      <source>&amp;Theme</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Darstellung</translation>
    </message>
    <message>
      <source>Te&amp;xt size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Te&amp;xtgröße</translation>
    </message>
    <message>
      <source>Text size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Textgröße</translation>
    </message>
    <message>
      <source>&amp;Language</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Sprache</translation>
    </message>
    <message>
      <source>Holds from the next start.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gilt ab dem nächsten Start.</translation>
    </message>
    <message>
      <source>&amp;Processors for computing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Prozessoren zum Rechnen</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zurück zur Arbeit (Esc)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SheetView</name>
    <message>
      <source>The drawing on its sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeichnung auf ihrem Blatt</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdDetails</name>
    <message>
      <source>missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fehlt</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>verändert</translation>
    </message>
    <message>
      <source>present</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>vorhanden</translation>
    </message>
    <message>
      <source>Details of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einzelheiten der Scherbe</translation>
    </message>
    <message>
      <source>Number of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummer der Scherbe</translation>
    </message>
    <message>
      <source>Picture of the sherd in the way</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild der Scherbe, die im Weg ist</translation>
    </message>
    <message>
      <source>measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maß</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wert</translation>
    </message>
    <message>
      <source>from</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Herkunft</translation>
    </message>
    <message>
      <source>Measurements</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maße</translation>
    </message>
    <message>
      <source>when</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wann</translation>
    </message>
    <message>
      <source>who</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wer</translation>
    </message>
    <message>
      <source>what</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>was</translation>
    </message>
    <message>
      <source>History</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geschichte</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Datei</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Art</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zustand</translation>
    </message>
    <message>
      <source>Files</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dateien</translation>
    </message>
    <message>
      <source>Measured</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gemessen</translation>
    </message>
    <message>
      <source>Context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Befund</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Befund</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch keine Nummer</translation>
    </message>
    <message>
      <source>Give the number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummer %1 geben</translation>
    </message>
    <message>
      <source>added</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hinzugefügt</translation>
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
      <translation>nichts</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Programm</translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen Sie eine Scherbe.</translation>
    </message>
    <message>
      <source>%1 It is %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Es ist %2.</translation>
    </message>
    <message>
      <source>%1; in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; zweifelhaft</translation>
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
        <numerusform>Eine Scherbe nummerieren</numerusform>
        <numerusform>%n Scherben nummerieren</numerusform>
      </translation>
    </message>
    <message>
      <source>Other changes are still being saved; wait for them, or stop them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Andere Änderungen werden noch gespeichert; warten Sie, oder halten Sie sie an.</translation>
    </message>
    <message>
      <source>The sherds that are chosen have their numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die gewählten Scherben haben ihre Nummern.</translation>
    </message>
    <message>
      <source>Numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern</translation>
    </message>
    <message>
      <source>Stopped; nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Angehalten; nichts wurde geändert.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdTableModel</name>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild einer Scherbe</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>not recorded</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nicht erfasst</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch keine Nummer</translation>
    </message>
    <message>
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, zweifelhaft</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Der Maßstab von Ladung %2 ist zweifelhaft; ihr Bericht sagt, warum und was zu tun ist.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdView</name>
    <message>
      <source>Sherd in three dimensions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe, räumlich</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the sherd cannot be shown in three dimensions. Everything else works; photographs and outlines are beside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Bildschirm hat kein OpenGL 3.2; die Scherbe lässt sich nicht räumlich zeigen. Alles andere geht; Aufnahmen und Umrisse stehen daneben.</translation>
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
      <translation>Scherben, beide Seiten, vollständig und vermessen.</translation>
    </message>
    <message>
      <source>&amp;Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Projekte</translation>
    </message>
    <message>
      <source>No project yet. Make one, or try everything with the virtual rig: it breaks a pot and photographs its sherds for you.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch kein Projekt. Legen Sie eines an, oder probieren Sie alles mit dem virtuellen Messplatz aus: er zerbricht ein Gefäß und nimmt seine Scherben für Sie auf.</translation>
    </message>
    <message>
      <source>&amp;Open a project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt &amp;öffnen…</translation>
    </message>
    <message>
      <source>Try with the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mit dem virtuellen Messplatz ausprobieren</translation>
    </message>
    <message>
      <source>New project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neues Projekt</translation>
    </message>
    <message>
      <source>Aragats 2026</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aragats 2026</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen…</translation>
    </message>
    <message>
      <source>Choose the folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner wählen</translation>
    </message>
    <message>
      <source>Make the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt anlegen</translation>
    </message>
    <message>
      <source>&amp;Name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Name</translation>
    </message>
    <message>
      <source>&amp;Site code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Fundortkürzel</translation>
    </message>
    <message>
      <source>&amp;Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Ordner</translation>
    </message>
    <message>
      <source>Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>N&amp;ummerierung</translation>
    </message>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe wird</translation>
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
      <translation>Gut</translation>
    </message>
    <message>
      <source>Folder of the new project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner des neuen Projekts</translation>
    </message>
    <message>
      <source>Folder of a project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner eines Projekts</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekte</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2 ist nicht da: suchen …</translation>
    </message>
    <message>
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wo ist %1 jetzt?</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::StopBoard</name>
    <message>
      <source>Photographs of this side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aufnahmen dieser Seite</translation>
    </message>
    <message>
      <source>%1 of %2 stops are done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 von %2 Halten sind fertig</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Thumbnails</name>
    <message>
      <source>Picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild</translation>
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
      <translation>Vorderseite: blauer Rand</translation>
    </message>
    <message>
      <source>back: red rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseite: roter Rand</translation>
    </message>
    <message>
      <source>%1 mm and more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm und mehr</translation>
    </message>
    <message>
      <source>0 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>0 mm</translation>
    </message>
    <message>
      <source>gap between the sides along the rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abstand der Seiten am Rand entlang</translation>
    </message>
    <message>
      <source>grey: not met by the other side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>grau: die andere Seite reicht nicht heran</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, a whole number, or scan its label</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, eine ganze Nummer, oder das Etikett lesen</translation>
    </message>
    <message>
      <source>&amp;Number of sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Nummer der Scherbe %1</translation>
    </message>
    <message>
      <source>If they have numbers already: each follows its sherd through the flip. Key N.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Falls sie schon Nummern haben: jede folgt ihrer Scherbe durch das Wenden. Taste N.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskModel</name>
    <message>
      <source>%1, camera %2, stop %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, Kamera %2, Halt %3</translation>
    </message>
    <message>
      <source>Mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maske</translation>
    </message>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken von %1</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseite</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseite</translation>
    </message>
    <message>
      <source>paint on a mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Malen auf einer Maske</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken von %1</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) mended; what follows from them is computed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Aufnahme ausgebessert; was aus ihr folgt, wird neu berechnet.</numerusform>
        <numerusform>%n Aufnahmen ausgebessert; was aus ihnen folgt, wird neu berechnet.</numerusform>
      </translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zurück</translation>
    </message>
    <message>
      <source>Brush's &amp;width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pinsel&amp;breite</translation>
    </message>
    <message>
      <source>Compute with these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Damit berechnen</translation>
    </message>
    <message>
      <source>Larger</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Größer</translation>
    </message>
    <message>
      <source>Smaller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kleiner</translation>
    </message>
    <message>
      <source>Next photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nächste Aufnahme</translation>
    </message>
    <message>
      <source>Photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aufnahme</translation>
    </message>
    <message>
      <source>Photograph before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorige Aufnahme</translation>
    </message>
    <message>
      <source>Plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Teller</translation>
    </message>
    <message>
      <source>Sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe</translation>
    </message>
    <message>
      <source>The photograph is being read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Aufnahme wird gelesen.</translation>
    </message>
    <message>
      <source>What is veiled in blue is taken for sherd. Paint what is missing, or as plate what is too much; the program's own masks stay.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was blau verschleiert ist, gilt als Scherbe. Malen Sie, was fehlt, oder als Teller, was zu viel ist; die Masken des Programms bleiben erhalten.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskView</name>
    <message>
      <source>Photograph with its mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aufnahme mit ihrer Maske</translation>
    </message>
    <message>
      <source>The arrows move the brush, Space paints, plus and minus enlarge and reduce.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Pfeile bewegen den Pinsel, die Leertaste malt, Plus und Minus vergrößern und verkleinern.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberingEdit</name>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe wird</translation>
    </message>
    <message>
      <source>First number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erste Nummer dieses Rechners</translation>
    </message>
    <message>
      <source>Last number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Letzte Nummer dieses Rechners</translation>
    </message>
    <message>
      <source>Left out so far</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bisher ausgelassen</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>N&amp;ummerierung</translation>
    </message>
    <message>
      <source>Num&amp;bers of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern dieses &amp;Rechners</translation>
    </message>
    <message>
      <source>Number so from &amp;now on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von &amp;nun an so nummerieren</translation>
    </message>
    <message>
      <source>Numbers of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern des offenen Projekts</translation>
    </message>
    <message>
      <source>What has a number keeps it; the next sherds follow. No number is ever given twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was eine Nummer hat, behält sie; die nächsten Scherben folgen. Keine Nummer wird je zweimal vergeben.</translation>
    </message>
    <message numerus="yes">
      <source>and in %n more context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>und in %n weiteren Befund</numerusform>
        <numerusform>und in %n weiteren Befunden</numerusform>
      </translation>
    </message>
    <message>
      <source>no number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>keine Nummer</translation>
    </message>
    <message>
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bis</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, und {n} einmal; {n:04} hat mindestens vier Ziffern</translation>
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
      <translation>Ausgelassene Nummern</translation>
    </message>
    <message>
      <source>Sherds of %1 get no number so: it lacks a part that the numbering names.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben aus %1 bekommen so keine Nummer: Ihm fehlt ein Teil, den die Nummerierung nennt.</translation>
    </message>
    <message>
      <source>The first number of a block is not above its last.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die erste Nummer eines Blocks liegt nicht über seiner letzten.</translation>
    </message>
    <message>
      <source>change the numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ändern der Nummerierung</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::VocabularyEdit</name>
    <message>
      <source>&amp;Save the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wörter speich&amp;ern</translation>
    </message>
    <message>
      <source>&amp;Words for</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Wörter für</translation>
    </message>
    <message>
      <source>A word that sherds use already stays; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Wort, das Scherben schon tragen, bleibt; ändern Sie diese zuerst.</translation>
    </message>
    <message>
      <source>&amp;One a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eines &amp;je Zeile</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert.</translation>
    </message>
    <message>
      <source>Words of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wörter des offenen Projekts</translation>
    </message>
    <message>
      <source>Words, one a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wörter, eines je Zeile</translation>
    </message>
    <message>
      <source>change the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ändern der Wörter</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erhaltung</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verzierung</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brand</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Herstellung</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Teil</translation>
    </message>
    <message>
      <source>surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oberfläche</translation>
    </message>
    <message>
      <source>These words are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Wörter sind noch nicht gespeichert.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CountEdit</name>
    <message>
      <source>&amp;Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Scherben</translation>
    </message>
    <message>
      <source>not counted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nicht gezählt</translation>
    </message>
    <message>
      <source>How many sherds you counted onto the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wie viele Scherben Sie auf die Platte gezählt haben</translation>
    </message>
    <message>
      <source>Count them if you like: you are asked when the photographs show another number (S)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zählen Sie sie, wenn Sie mögen: Sie werden gefragt, wenn die Fotos eine andere Zahl zeigen (S)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigRenewal</name>
    <message>
      <source>Calibration by %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kalibrierung nach %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wie weit das Einlesen ist</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Einlesen anhalten</translation>
    </message>
  </context>
  <context>
    <name>ImportBatch</name>
    <message>
      <source>There are no scans (*.ply) in its folder %1/. Choose a folder that holds front/ and back/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In seinem Ordner %1/ sind keine Scans (*.ply). Wählen Sie einen Ordner mit front/ und back/.</translation>
    </message>
    <message>
      <source>This folder cannot be read to its end: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner lässt sich nicht zu Ende lesen: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdNumbers</name>
    <message>
      <source>%1 is no sherd's number: it has a digit, no space and at most %2 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist keine Nummer einer Scherbe: Sie hat eine Ziffer, kein Leerzeichen und höchstens %2 Zeichen.</translation>
    </message>
    <message>
      <source>Sherd %1 of this plate has the number %2: take it from that one first, or type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1 auf diesem Teller hat die Nummer %2: Nehmen Sie sie ihr zuerst, oder geben Sie eine andere ein.</translation>
    </message>
    <message>
      <source>A sherd of %1 has the number %2 already; type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe von %1 hat die Nummer %2 schon; geben Sie eine andere ein.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Doubts</name>
    <message>
      <source>the file is cut off or no picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Datei ist abgeschnitten oder kein Bild</translation>
    </message>
    <message>
      <source>the markers show another angle than this stop's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Marken zeigen einen anderen Winkel als den dieses Halts</translation>
    </message>
    <message>
      <source>the picture has another size than the camera's others</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>das Bild hat eine andere Größe als die übrigen dieser Kamera</translation>
    </message>
    <message>
      <source>too few markers are seen to tell the stop: is something before them, is it blurred?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>zu wenige Marken sind zu sehen, um den Halt zu erkennen: liegt etwas davor, ist es unscharf?</translation>
    </message>
    <message>
      <source>the camera handed over an earlier photograph once more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Kamera hat ein früheres Foto noch einmal geliefert</translation>
    </message>
    <message>
      <source>too few markers of the plate are seen: is something before them?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>zu wenige Marken des Tellers sind zu sehen: liegt etwas davor?</translation>
    </message>
    <message>
      <source>it is blurred: did the table still move, did the focus change?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>es ist unscharf: bewegte sich der Tisch noch, hat sich der Fokus geändert?</translation>
    </message>
    <message>
      <source>the sherds are too dark: give more light or expose longer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Scherben sind zu dunkel: mehr Licht geben oder länger belichten</translation>
    </message>
    <message>
      <source>the sherds are burnt out: expose shorter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Scherben sind überbelichtet: kürzer belichten</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>der Bildrand schneidet eine Scherbe ab: sie oder die Kamera verschieben</translation>
    </message>
    <message>
      <source>the camera's settings are others than they were: set them back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Einstellungen der Kamera sind andere als zuvor: zurückstellen</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>%1: set it back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: zurückstellen</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate's markers are seen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherben konnten nicht gezählt werden: zu wenige Marken des Tellers sind zu sehen.</translation>
    </message>
    <message>
      <source>No sherd is seen on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf dem Teller ist keine Scherbe zu sehen.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate's middle: move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben berühren sich fast oder ganz bei %1 von der Mitte des Tellers: auseinanderrücken und noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate's middle was counted as one but may be two sherds that touch: look there; if so, move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was bei %1 von der Mitte des Tellers liegt, wurde als eine gezählt, kann aber zwei Scherben sein, die sich berühren: dort nachsehen; wenn ja, auseinanderrücken und noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and photograph them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Rückseite sieht aus wie die Vorderseite: die Scherben umdrehen und noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherben der Rückseite konnten nicht gezählt werden: die Bilder selbst vergleichen, bevor der Teller abgeräumt wird.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherben der Vorderseite konnten nicht gezählt werden: die Bilder selbst vergleichen, bevor der Teller abgeräumt wird.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: look for the missing one before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorn waren %1 Scherben zu sehen, hinten %2: die fehlende suchen, bevor der Teller abgeräumt wird.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: was one added, or did one break?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorn waren %1 Scherben zu sehen, hinten %2: kam eine hinzu, oder zerbrach eine?</translation>
    </message>
  </context>
  <context>
    <name>ostraka::Error</name>
    <message>
      <source>Stopped on request.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf Wunsch angehalten.</translation>
    </message>
    <message>
      <source>The camera is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera ist nicht angeschlossen.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera ist nicht angeschlossen oder nicht eingeschaltet.</translation>
    </message>
    <message>
      <source>The camera does not answer; is it asleep? Switch its automatic power-off off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera antwortet nicht; schläft sie? Ihre automatische Abschaltung ausschalten.</translation>
    </message>
    <message>
      <source>The camera stays busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera bleibt beschäftigt; aus- und wieder einschalten.</translation>
    </message>
    <message>
      <source>The line to the camera is broken; look at its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Verbindung zur Kamera ist unterbrochen; ihr Kabel prüfen.</translation>
    </message>
    <message>
      <source>The camera is held by another program, often the desktop's file manager; 'ostraka devices' names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Programm hält die Kamera fest, oft die Dateiverwaltung; 'ostraka devices' nennt es.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; may this user use it? Look at 'ostraka devices'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera lässt sich nicht öffnen; darf dieser Benutzer sie verwenden? Siehe 'ostraka devices'.</translation>
    </message>
    <message>
      <source>No photograph came from the camera; is it focused and set to manual?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von der Kamera kam kein Foto; ist sie scharf gestellt und auf manuell?</translation>
    </message>
    <message>
      <source>The camera does not stop to deliver photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera hört nicht auf, Fotos zu liefern.</translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Kamera zeigt kein Livebild.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; is it blocked?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch erreicht seinen Winkel nicht; ist er blockiert?</translation>
    </message>
    <message>
      <source>The turntable was paused at its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch wurde an seinem eigenen Knopf angehalten.</translation>
    </message>
    <message>
      <source>The table's position is not known: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Stellung des Tisches ist unbekannt: nullen oder ausrichten.</translation>
    </message>
    <message>
      <source>The turntable does not answer in the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht im Netz.</translation>
    </message>
    <message>
      <source>The controller restarted; the table's position is not known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Steuerung ist neu gestartet; die Stellung des Tisches ist unbekannt.</translation>
    </message>
    <message>
      <source>A reply of the turntable was lost and it cannot tell where it stands: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Antwort des Drehtisches ging verloren, und er kann nicht sagen, wo er steht: nullen oder ausrichten.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht wie eine GRBL-Steuerung: ist er eingeschaltet und von dieser Art?</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht wie ein ComXim: ist er eingeschaltet und von dieser Art?</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB funktioniert auf diesem Computer nicht.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and shoot on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger ist voll; Platz schaffen und weiter aufnehmen.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and start the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger ist voll; Platz schaffen und dasselbe noch einmal beginnen.</translation>
    </message>
    <message>
      <source>The disk is full; make room, then try again. Nothing was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger ist voll; Platz schaffen und noch einmal versuchen. Nichts ging verloren.</translation>
    </message>
    <message>
      <source>Another program keeps the catalogue busy; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Programm hält den Katalog besetzt; es schließen und noch einmal versuchen.</translation>
    </message>
    <message>
      <source>The image is cut off before its end; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Bild ist vor seinem Ende abgeschnitten; noch einmal von der Kamera kopieren.</translation>
    </message>
  </context>
</TS>
