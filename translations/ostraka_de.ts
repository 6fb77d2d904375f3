<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ostraka::ui::ProjectSession</name>
    <message>
      <source>This project is read-only: you can look at everything, but change nothing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt ist nur lesbar: Sie können alles ansehen, aber nichts ändern.</translation>
    </message>
    <message>
      <source>The project's folder is not there any more: it was moved, renamed, or its disk was taken out. Open the project again where it is now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ordner des Projekts ist nicht mehr da: verschoben, umbenannt, oder sein Datenträger wurde entfernt. Das Projekt dort öffnen, wo es jetzt liegt.</translation>
    </message>
</context>
<context>
    <name>SideLabels</name>
    <message>
      <source>A label among the fronts names %1, one among the backs %2: check that both sides show the same sherds, and type the bag that they are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Etikett bei den Vorderseiten nennt %1, eines bei den Rückseiten %2: Prüfen Sie, ob beide Seiten dieselben Scherben zeigen, und geben Sie deren Beutel ein.</translation>
    </message>
    <message>
      <source>Labels of several bags are in the photographs: %1. Type the one that these sherds are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In den Fotos liegen Etiketten mehrerer Beutel: %1. Geben Sie den ein, aus dem diese Scherben sind.</translation>
    </message>
    <message>
      <source>The label in the photographs names %1: check the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Etikett in den Fotos nennt %1: Prüfen Sie den Beutel.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportAsk</name>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erst dies prüfen</translation>
    </message>
    <message>
      <source>The label in the photographs names %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Etikett in den Fotos nennt %1.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importieren</translation>
    </message>
    <message>
      <source>Cancel import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Import abbrechen</translation>
    </message>
    <message>
      <source>From %1. The bag can also be given later, in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aus %1. Der Beutel kann auch später im Katalog angegeben werden.</translation>
    </message>
    <message>
        <source>Enter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Eingabe</translation>
    </message>
    <message>
      <source>To import, confirm or move the division between front and back, or choose one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zum Importieren die Teilung zwischen Vorder- und Rückseite bestätigen oder verschieben, oder „Nur eine Seite“ wählen.</translation>
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
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wandstärke, mm</translation>
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
      <translation>Durchgang</translation>
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
      <source>minimum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kleinste Wandstärke, mm</translation>
    </message>
    <message>
      <source>maximum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>größte Wandstärke, mm</translation>
    </message>
    <message>
      <source>unseen surface, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nicht gesehene Fläche, %</translation>
    </message>
    <message>
      <source>place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ort</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modell</translation>
    </message>
    <message>
      <source>labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bezeichnungen</translation>
    </message>
    <message>
      <source>person</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Person</translation>
    </message>
    <message>
      <source>name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Name</translation>
    </message>
    <message>
      <source>initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kürzel</translation>
    </message>
    <message>
      <source>code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Code</translation>
    </message>
    <message>
      <source>location</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lage</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Art</translation>
    </message>
    <message>
      <source>excavated on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ausgegraben am</translation>
    </message>
    <message>
      <source>closed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgeschlossen</translation>
    </message>
    <message>
      <source>collected on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geborgen am</translation>
    </message>
    <message>
      <source>storage</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lager</translation>
    </message>
    <message>
      <source>operator</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bearbeiter</translation>
    </message>
    <message>
      <source>counted sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>gezählte Scherben</translation>
    </message>
    <message>
      <source>results</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ergebnisse</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Programm</translation>
    </message>
    <message>
      <source>project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt</translation>
    </message>
    <message>
      <source>title</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Titel</translation>
    </message>
    <message>
      <source>institution</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einrichtung</translation>
    </message>
    <message>
      <source>licence</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Lizenz</translation>
    </message>
    <message>
      <source>rights holder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rechteinhaber</translation>
    </message>
    <message>
      <source>numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummerierung</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Foto</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scan</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Datei</translation>
    </message>
    <message>
      <source>term</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Begriff</translation>
    </message>
    <message>
      <source>content</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Inhalt</translation>
    </message>
    <message>
      <source>mask strokes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maskenstriche</translation>
    </message>
    <message>
      <source>entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>erfasst</translation>
    </message>
    <message>
      <source>excavated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ausgegraben</translation>
    </message>
    <message>
      <source>measured by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>von Hand gemessen</translation>
    </message>
    <message>
      <source>centre of mass x, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schwerpunkt x, mm</translation>
    </message>
    <message>
      <source>centre of mass y, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schwerpunkt y, mm</translation>
    </message>
    <message>
      <source>centre of mass z, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schwerpunkt z, mm</translation>
    </message>
    <message>
      <source>model file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelldatei</translation>
    </message>
    <message>
      <source>picture file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilddatei</translation>
    </message>
    <message>
      <source>drawing file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeichnungsdatei</translation>
    </message>
    <message>
      <source>sherds written on the bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben laut Beutel</translation>
    </message>
    <message>
      <source>column of the CSV</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Spalte der CSV</translation>
    </message>
    <message>
      <source>column</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Spalte</translation>
    </message>
    <message>
      <source>unit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einheit</translation>
    </message>
    <message>
      <source>meaning</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bedeutung</translation>
    </message>
    <message>
      <source>reason for voiding</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Grund der Ungültigkeit</translation>
    </message>
    <message>
      <source>identical with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>identisch mit</translation>
    </message>
</context>
<context>
    <name>Job</name>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist ein Fehler des Programms; bitte mit dem Protokoll melden (%1).</translation>
    </message>
    <message>
      <source>Not enough memory. Close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zu wenig Speicher. Andere Programme schließen und noch einmal versuchen.</translation>
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
    <message numerus="yes">
        <source>%n sherd(s) counted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n Scherbe gezählt</numerusform>
            <numerusform>%n Scherben gezählt</numerusform>
        </translation>
    </message>
    <message>
      <source>invented by the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>vom virtuellen Messplatz erfunden</translation>
    </message>
    <message>
      <source>context %1, although %2 exists</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Befund %1, obwohl es %2 gibt</translation>
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
      <source>Finding the cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kameras werden gefunden</translation>
    </message>
    <message>
      <source>Measuring the shape, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Form wird gemessen, vorn</translation>
    </message>
    <message>
      <source>Measuring the shape, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Form wird gemessen, hinten</translation>
    </message>
    <message>
      <source>Cutting the sherds out, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben werden einzeln ausgeschnitten, vorn</translation>
    </message>
    <message>
      <source>Cutting the sherds out, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben werden einzeln ausgeschnitten, hinten</translation>
    </message>
    <message>
      <source>Matching fronts and backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorder- und Rückseiten werden einander zugeordnet</translation>
    </message>
    <message>
      <source>Closing the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelle werden geschlossen</translation>
    </message>
    <message>
      <source>Writing the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
      <source>Entering the sherds into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben werden in den Katalog eingetragen</translation>
    </message>
    <message>
      <source>Starting</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beginnt</translation>
    </message>
    <message>
      <source>Looking for other partners in doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Weitere Partner für zweifelhafte Paare werden gesucht</translation>
    </message>
    <message>
      <source>Finding the sherds, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben werden gesucht, vorn</translation>
    </message>
    <message>
      <source>Finding the sherds, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben werden gesucht, hinten</translation>
    </message>
</context>
<context>
    <name>Time</name>
    <message>
      <source>less than a minute left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch weniger als eine Minute</translation>
    </message>
    <message>
      <source>about %1 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch etwa %1 min</translation>
    </message>
    <message>
      <source>about %1 h left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch etwa %1 h</translation>
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
      <source>%1 or %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 oder %2</translation>
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Foto ist nicht mehr da.</translation>
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
      <translation>Der Druck oder die Datei wurde nicht fertig; ist der Datenträger voll?</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 und %2 passen beide zu %3.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre Rückseite wurde einer anderen Vorderseite gegeben: Ist %1 jetzt die richtige?</translation>
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
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beutel %1</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Rückseite ist beiseitegelegt. Ziehen Sie sie auf eine Vorderseite, um sie doch zu verwenden.</translation>
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
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Hand gedreht.</translation>
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
      <source>Sure by what was decided for others: %1; by itself %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sicher durch das, was für andere entschieden wurde: %1; für sich allein %2.</translation>
    </message>
    <message>
      <source>%1, aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, beiseite</translation>
    </message>
    <message>
      <source>%1, shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, neu aufnehmen</translation>
    </message>
    <message>
      <source>%1, void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ungültig</translation>
    </message>
    <message>
      <source>%1 in %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 in %2</translation>
    </message>
    <message>
      <source>now %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>jetzt %1</translation>
    </message>
    <message>
        <source>front %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Vorderseite %1</translation>
    </message>
    <message>
        <source>back %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Rückseite %1</translation>
    </message>
    <message>
        <source>Merged with %1 by %2. It is one fragment once the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mit %1 zusammengeführt von %2. Nach der Neuverarbeitung des Durchgangs ist es ein Fragment.</translation>
    </message>
    <message>
        <source>Split by %1. Its fragments appear when the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geteilt von %1. Die Fragmente erscheinen, wenn der Durchgang neu verarbeitet ist.</translation>
    </message>
    <message>
        <source>Merged</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zusammengeführt</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geteilt</translation>
    </message>
    <message>
        <source>No front</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Keine Vorderseite</translation>
    </message>
    <message>
        <source>This back is to be reshot.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Diese Rückseite ist neu aufzunehmen.</translation>
    </message>
    <message>
        <source>No front holds this back. Drag it onto its front, merge it with another, or set it aside.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Keine Vorderseite hat diese Rückseite. Auf ihre Vorderseite ziehen, mit einer anderen zusammenführen oder beiseitelegen.</translation>
    </message>
    <message>
        <source>%1 and %2 both fit %3: their fractures differ by only %4.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 und %2 passen beide zu %3: ihre Brüche unterscheiden sich nur um %4.</translation>
    </message>
    <message>
        <source>%1 would fit %2 almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 würde fast ebenso gut zu %2 passen.</translation>
    </message>
    <message>
        <source>%1 fits barely better than an unrelated back.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 passt kaum besser als eine fremde Rückseite.</translation>
    </message>
    <message>
        <source>Ambiguous: a second position fits almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mehrdeutig: eine zweite Lage passt fast ebenso gut.</translation>
    </message>
    <message>
        <source>%1 confident</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 sicher</translation>
    </message>
    <message>
        <source>Check</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>No back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Keine Rückseite</translation>
    </message>
    <message>
        <source>Sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sicher</translation>
    </message>
    <message>
        <source>Decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Entschieden</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Beiseitegelegt</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Neu aufnehmen</translation>
    </message>
    <message>
        <source>To be reshot, decided by %1 on %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Neu aufzunehmen, entschieden von %1 am %2.</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Durch gemessenen Wert ersetzen</translation>
    </message>
    <message>
        <source>Delete computed value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Berechneten Wert löschen</translation>
    </message>
    <message>
        <source>Save this value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Diesen Wert speichern</translation>
    </message>
    <message>
        <source>%1 (computed %2)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 (berechnet %2)</translation>
    </message>
    <message>
        <source>The two scans share only %1 of the fracture.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Die beiden Scans haben nur %1 des Bruchs gemeinsam.</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch keine Nummer</translation>
    </message>
    <message>
      <source>Another partner fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Partner passt fast ebenso gut.</translation>
    </message>
    <message>
      <source>no probability</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>keine Wahrscheinlichkeit</translation>
    </message>
    <message>
      <source>The nearest outline; no probability is known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der nächstliegende Umriss; eine Wahrscheinlichkeit ist nicht bekannt.</translation>
    </message>
    <message>
      <source>Another front takes the same back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine andere Vorderseite nimmt dieselbe Rückseite.</translation>
    </message>
    <message>
      <source>The two scans share almost no fracture; only their outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die beiden Scans haben fast keinen gemeinsamen Bruch; nur die Umrisse passen.</translation>
    </message>
    <message>
      <source>The fractures do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Brüche passen nicht: %1 Abstand.</translation>
    </message>
    <message>
      <source>The fracture barely fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Bruch legt die Lage kaum fest: auf %1 ungewiss.</translation>
    </message>
    <message>
      <source>A position %1 along the contour fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Lage %1 weiter am Umriss passt fast ebenso gut.</translation>
    </message>
    <message>
      <source>The fractures cannot be compared; only the outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Brüche lassen sich nicht vergleichen; nur die Umrisse passen.</translation>
    </message>
    <message>
      <source>refined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>verfeinert</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Hand gedreht: %1 der Brüche berühren sich.</translation>
    </message>
    <message>
      <source>Trying another start point: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Anfangspunkt wird probiert: %1 der Brüche berühren sich.</translation>
    </message>
    <message>
      <source>Trying another start point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Anfangspunkt wird probiert.</translation>
    </message>
    <message>
      <source>Refined by the fractures: %1 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nach den Brüchen verfeinert: %1 davon berühren sich.</translation>
    </message>
    <message>
      <source>Refined by the fractures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nach den Brüchen verfeinert.</translation>
    </message>
    <message>
      <source>Trying %1: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird probiert: %2.</translation>
    </message>
    <message>
      <source>Trying %1: %2, fractures %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird probiert: %2, Brüche %3 auseinander.</translation>
    </message>
    <message>
      <source>Trying %1: %2; its fractures do not touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird probiert: %2; die Brüche berühren sich nicht.</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1 von %2</translation>
    </message>
    <message>
      <source>imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>importiert</translation>
    </message>
    <message>
      <source>estimated by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>von Hand geschätzt</translation>
    </message>
    <message>
      <source>%1 confident; below %2, a person decides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sicher; unter %2 entscheidet ein Mensch.</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eingabe</translation>
    </message>
    <message>
      <source>%1 ± %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ± %2</translation>
    </message>
    <message>
      <source>Only %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nur %1 der Brüche berühren sich.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe</numerusform>
        <numerusform>%n Scherben</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep a number of the old context: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe behält eine Nummer des alten Befunds: %1.</numerusform>
        <numerusform>%n Scherben behalten eine Nummer des alten Befunds: %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag, because there is no bag %1 yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe verlässt ihren Beutel, denn es gibt noch keinen Beutel %1.</numerusform>
        <numerusform>%n Scherben verlassen ihre Beutel, denn es gibt noch keinen Beutel %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe verlässt ihren Beutel.</numerusform>
        <numerusform>%n Scherben verlassen ihre Beutel.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BatchImporter</name>
    <message>
      <source>Import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Import von %1</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kopie lässt sich nicht an ihren Platz legen: %1.</translation>
    </message>
    <message numerus="yes">
      <source>Sheet recognised: %n marker(s). Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Blatt erkannt: %n Marke. Alle Maße beruhen auf der eingegebenen Markenseite von %1 mm; bitte auf dem Papier mit einem Lineal nachmessen.</numerusform>
        <numerusform>Blatt erkannt: %n Marken. Alle Maße beruhen auf der eingegebenen Markenseite von %1 mm; bitte auf dem Papier mit einem Lineal nachmessen.</numerusform>
      </translation>
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
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Warnung: %1</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch einmal</translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: angehalten</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe</numerusform>
        <numerusform>%n Scherben</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; aber %n auf der Platte gezählt</numerusform>
        <numerusform>%1; aber %n auf der Platte gezählt</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wartet auf den Entwurf von %2.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für diesen Durchgang wurden die Kameras neu gefunden; kalibrieren Sie den Messplatz neu (C).</translation>
    </message>
    <message>
      <source>You set it aside. Its photographs are kept; R takes it up again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Ihnen beiseitegelegt. Die Fotos bleiben; R nimmt den Durchgang wieder auf.</translation>
    </message>
    <message>
      <source>%1; is %2 the sherd that it was? It measured %3 mm, now %4 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; ist %2 noch dieselbe Scherbe? Sie maß %3 mm, jetzt %4 mm</translation>
    </message>
    <message>
      <source>%1; the number %2 was typed on its plate, and none of its sherds has it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; die Nummer %2 wurde auf seiner Platte getippt, und keine seiner Scherben hat sie</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n photographed again since</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%1; %n seither neu aufgenommen</numerusform>
            <numerusform>%1; %n seither neu aufgenommen</numerusform>
        </translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Beiseitegelegt</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aufnahme läuft</translation>
    </message>
    <message>
        <source>Queued</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>In der Warteschlange</translation>
    </message>
    <message>
        <source>Processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>In Verarbeitung</translation>
    </message>
    <message>
        <source>Paused</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Needs review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zu prüfen</translation>
    </message>
    <message>
        <source>Done</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Draft: review it, then reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Entwurf: prüfen, dann neu verarbeiten</translation>
    </message>
    <message>
        <source>Masks edited: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Masken bearbeitet: neu verarbeiten</translation>
    </message>
    <message>
        <source>Scale in doubt: see the report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Maßstab zweifelhaft: siehe Bericht</translation>
    </message>
    <message>
        <source>Decided: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Entschieden: neu verarbeiten</translation>
    </message>
    <message>
        <source>%1 sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 sicher</translation>
    </message>
    <message>
        <source>%1 decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 entschieden</translation>
    </message>
    <message>
        <source>%1 to review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 zu prüfen</translation>
    </message>
    <message>
        <source>draft, to be reprocessed; %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Entwurf, neu zu verarbeiten; %1</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n to reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%1; %n neu aufzunehmen</numerusform>
            <numerusform>%1; %n neu aufzunehmen</numerusform>
        </translation>
    </message>
    <message>
      <source>%1; joined to within %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; gefügt auf höchstens %2 mm</translation>
    </message>
    <message numerus="yes">
      <source>%1 is ready: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 ist fertig: eine Scherbe.</numerusform>
        <numerusform>%1 ist fertig: %n Scherben.</numerusform>
      </translation>
    </message>
    <message>
      <source>You cancelled it. Finished stages are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Ihnen abgebrochen. Fertige Schritte sind gespeichert.</translation>
    </message>
    <message>
      <source>You removed it from the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Ihnen aus der Warteschlange genommen.</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) queued.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Angehalten; ein Durchgang wartet.</numerusform>
        <numerusform>Angehalten; %n Durchgänge warten.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the markers by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 wurde angestoßen: Sie verfehlt die Marken um %2 px, %3 mm neben dem Ort ihrer Kalibrierung.</translation>
    </message>
    <message>
      <source>It was interrupted. Reprocess it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Berechnung wurde unterbrochen. Neu verarbeiten.</translation>
    </message>
    <message>
      <source>No bag was given; its sherds get their context in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Beutel angegeben; die Scherben bekommen ihren Befund im Katalog.</translation>
    </message>
    <message>
        <source>%1: stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: wird abgebrochen …</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird abgebrochen …</translation>
    </message>
    <message>
      <source>%1, %2 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Draft: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Entwurf: %1</translation>
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
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Nummern vergeben</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Durch gemessenen Wert ersetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Ein Wert muss bestätigt werden.</numerusform>
            <numerusform>%n Werte müssen bestätigt werden.</numerusform>
        </translation>
    </message>
    <message>
      <source>rejected: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgelehnt: %1</translation>
    </message>
    <message>
      <source>Cancel and undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abbrechen und rückgängig machen</translation>
    </message>
    <message>
      <source>To change: %1. Unchanged: %2. Rejected: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zu ändern: %1. Unverändert: %2. Abgelehnt: %3.</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vergleichen</translation>
    </message>
    <message>
      <source>Type a value to see what would change, or press Enter in the empty field to delete.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Wert eingeben, um zu sehen, was sich ändern würde, oder im leeren Feld Enter drücken, um zu löschen.</translation>
    </message>
    <message>
      <source>Make these bags</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Beutel anlegen</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CandidateBar</name>
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
    <message>
        <source>gap %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abstand %1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>kein Kontakt</translation>
    </message>
    <message>
      <source>Another back…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Andere Rückseite …</translation>
    </message>
    <message>
      <source>by outline alone</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nur nach dem Umriss</translation>
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
</context>
<context>
    <name>ostraka::ui::CaptureScreen</name>
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
        <numerusform>%1: eine Datei importiert; der Durchgang ist in der Warteschlange.</numerusform>
        <numerusform>%1: %n Dateien importiert; der Durchgang ist in der Warteschlange.</numerusform>
      </translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch einmal aufnehmen</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos importieren …</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scans importieren …</translation>
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
      <translation>%1 Der Desktop hält eine Kamera fest, mit seinem Programm %2.</translation>
    </message>
    <message>
      <source>Type the sherds' numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern der Scherben eingeben</translation>
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
      <source>'%1' names no bag: write site-trench-context-bag, or empty the line to go on without one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>„%1“ nennt keinen Beutel: Fundort-Schnitt-Befund-Beutel schreiben, oder die Zeile leeren, um ohne einen weiterzumachen.</translation>
    </message>
    <message>
      <source>Set this batch aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diesen Durchgang beiseitelegen</translation>
    </message>
    <message>
      <source>The bag is another now, the numbers are not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Beutel ist jetzt ein anderer, die Nummern sind es nicht</translation>
    </message>
    <message>
      <source>Not as this bag&apos;s sherds are numbered: %1. Type them anew (N, or later in the catalogue), or say that they are right.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nicht so, wie die Scherben dieses Beutels nummeriert werden: %1. Tippen Sie sie neu ein (N, oder später im Katalog), oder sagen Sie, dass sie stimmen.</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>OK</translation>
    </message>
    <message>
        <source>Next step</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
      <source>Stop turntable</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Drehtisch anhalten</translation>
    </message>
    <message>
      <source>Change rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatz wechseln …</translation>
    </message>
    <message>
      <source>Loading picture…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild wird geladen …</translation>
    </message>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erst dies prüfen</translation>
    </message>
    <message>
      <source>Type how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zahl der Scherben eingeben</translation>
    </message>
    <message>
      <source>Import cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Import abgebrochen. Nichts blieb zurück.</translation>
    </message>
    <message>
      <source>Import anyway</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Trotzdem importieren</translation>
    </message>
    <message>
      <source>Photograph this side again?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Seite noch einmal aufnehmen?</translation>
    </message>
    <message>
      <source>Keep these numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern behalten</translation>
    </message>
    <message>
        <source>%1 The rig that worked before stays in use.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 Der bisherige Messplatz bleibt in Gebrauch.</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos behalten</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, %2 %</translation>
    </message>
    <message>
      <source>%1 already has these files, so nothing was imported. If you import them anyway, its sherds appear twice in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hat diese Dateien schon, daher wurde nichts importiert. Werden sie trotzdem importiert, stehen die Scherben zweimal im Katalog.</translation>
    </message>
    <message>
      <source>%1 already has %2 of these %3 files, so nothing was imported. If you import them anyway, the catalogue holds the sherds of both batches; if you do not want that, set %1 aside in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hat %2 dieser %3 Dateien schon, daher wurde nichts importiert. Werden sie trotzdem importiert, stehen die Scherben beider Durchgänge im Katalog; ist das nicht gewollt, legen Sie %1 in der Warteschlange beiseite.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>The label beside the backs names %1, but the fronts are of %2: check that these are the same sherds, or correct the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Etikett neben den Rückseiten nennt %1, die Vorderseiten sind aber aus %2: Prüfen Sie, ob es dieselben Scherben sind, oder berichtigen Sie den Beutel.</translation>
    </message>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz wird geöffnet</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bitte den Auslöser von Kamera %1 drücken.</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch kein Messplatz</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben auf die Platte legen</translation>
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
      <translation>Die Platte darf abgeräumt werden.</translation>
    </message>
    <message>
      <source>Shifting is fine, swapping is fine, losing one is not.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verschieben ist erlaubt, Vertauschen auch, Verlieren nicht.</translation>
    </message>
    <message>
      <source>%1 is in the queue; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist in der Warteschlange; der nächste Durchgang ist eine Taste entfernt.</translation>
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
      <translation>Gewendet: Rückseiten aufnehmen</translation>
    </message>
    <message>
      <source>Next batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nächster Durchgang</translation>
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
    <message>
      <source>This camera has no live view.</source>
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
      <source>You counted %1 sherds, the photographs show %2: look for one that is hidden, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie haben %1 Scherben gezählt, die Fotos zeigen %2: Suchen Sie eine, die verdeckt ist, eine andere berührt oder gar nicht hingelegt wurde.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie haben %1 gezählt</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wurde mitten in dieser Seite unterbrochen.</translation>
    </message>
    <message>
      <source>%1 is photographed whole, but nobody said that it is right: look at its photographs, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist ganz fotografiert, aber niemand hat gesagt, dass sie richtig ist: die Fotos ansehen, dann weitermachen.</translation>
    </message>
    <message>
      <source>To be photographed again: %1. Lay them down with others, and type their numbers (N) when the fronts are shot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch einmal aufzunehmen: %1. Mit anderen auflegen und ihre Nummern eingeben (N), wenn die Vorderseiten aufgenommen sind.</translation>
    </message>
    <message>
      <source>Labels of several bags are in sight: %1. Leave the one of these sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mehrere Beuteletiketten sind zu sehen: %1. Nur das dieser Scherben liegen lassen.</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: check whether one is in fragments or an object is not a sherd, or correct the count.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie haben %1 Scherben gezählt, die Fotos zeigen %2: Sehen Sie nach, ob eine in Teilen daliegt oder etwas, das keine Scherbe ist, oder berichtigen Sie die Zahl.</translation>
    </message>
    <message>
        <source>The rig does not open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Messplatz lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Taking calibration photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kalibrierfotos werden aufgenommen</translation>
    </message>
    <message>
        <source>The virtual rig turns the sherds over</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der virtuelle Messplatz wendet die Scherben</translation>
    </message>
    <message>
        <source>Nothing to do by hand: shoot the backs.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Von Hand ist nichts zu tun: Rückseiten aufnehmen.</translation>
    </message>
    <message>
        <source>Resume at position %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bei Position %1 fortsetzen</translation>
    </message>
    <message>
        <source>Shoot the backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Rückseiten aufnehmen</translation>
    </message>
    <message>
        <source>Calibration photograph %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kalibrierfoto %1 von %2</translation>
    </message>
    <message>
        <source>Position %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Position %1 von %2</translation>
    </message>
    <message>
        <source>Opening the rig…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Messplatz wird geöffnet …</translation>
    </message>
    <message>
        <source>Lighting OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Beleuchtung OK</translation>
    </message>
    <message>
      <source>%1 resumes where it stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 geht weiter, wo es aufhörte.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Das bisherige Foto dieser Seite ist gespeichert.</numerusform>
        <numerusform>Die %n bisherigen Fotos dieser Seite sind gespeichert.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at position %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, Position %2: %3</translation>
    </message>
    <message>
      <source>Check the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vor dem Abräumen die Platte ansehen</translation>
    </message>
    <message>
      <source>Fronts up, two centimetres apart, the markers at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseite oben, zwei Zentimeter Abstand, die Marken am Rand frei.</translation>
    </message>
    <message>
      <source>Hands off the turntable. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hände weg vom Drehtisch. Esc hält ihn sofort an.</translation>
    </message>
    <message>
      <source>Space accepts anyway, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leertaste: trotzdem weiter. R: Rückseiten noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>Accept and queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Annehmen und einreihen</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) saved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ein Foto gespeichert</numerusform>
        <numerusform>%n Fotos gespeichert</numerusform>
      </translation>
    </message>
    <message>
      <source>Markers %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marken %1 von %2</translation>
    </message>
    <message>
      <source>Release camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera freigeben</translation>
    </message>
    <message>
      <source>Markers %1 of %2, %3 needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marken %1 von %2, nötig sind %3</translation>
    </message>
    <message>
      <source>Its sherds are in the review (Ctrl+3): check them while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre Scherben sind in der Prüfung (Strg+3): Sehen Sie sie an, solange sie noch hier liegen</translation>
    </message>
    <message>
        <source>The turntable stands still. Saved photographs are kept.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Drehtisch steht. Gespeicherte Fotos bleiben erhalten.</translation>
    </message>
    <message>
      <source>Nothing is wrong with the photographs of this side. Space or Esc keeps them; R once more puts all of them aside and takes new ones.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>An den Fotos dieser Seite ist nichts auszusetzen. Leertaste oder Esc behält sie; noch einmal R legt alle beiseite und macht neue.</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos behalten</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird angehalten …</translation>
    </message>
    <message>
      <source>%1 is processed; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist verarbeitet; der nächste Durchgang ist eine Taste entfernt.</translation>
    </message>
    <message>
      <source>No photograph of this side has been taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von dieser Seite ist noch kein Foto aufgenommen.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueScreen</name>
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
      <translation>Diese exportieren</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihr Kürzel</translation>
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wer arbeitet? Ihr Kürzel kommt in den Verlauf:</translation>
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
      <translation>Änderungen durch den Import von %1</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 importiert: %2</translation>
    </message>
    <message>
      <source>Numbers, contexts and descriptions from a table, or an export (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummern, Befunde und Beschreibungen aus einer Tabelle, oder einem Export (%1)</translation>
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
      <translation>Import</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Import von %1 brach nach %2 von %3 Zeilen ab; diese sind vollständig. Für den Rest noch einmal importieren.</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen Sie die Scherben, die Nummern bekommen sollen.</translation>
    </message>
    <message>
        <source>No sherds yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Noch keine Scherben</translation>
    </message>
    <message>
        <source>Sherds appear here when a batch is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Scherben erscheinen hier, wenn ein Durchgang verarbeitet ist.</translation>
    </message>
    <message>
        <source>No sherds match this filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Keine Scherbe passt zu diesem Filter</translation>
    </message>
    <message>
        <source>Remove a condition to see more.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Eine Bedingung entfernen, um mehr zu sehen.</translation>
    </message>
    <message>
        <source>Clear filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Filter leeren</translation>
    </message>
    <message>
        <source>Model</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Nummern vergeben</translation>
    </message>
    <message>
        <source>A void sherd gets no label, drawing or place on a plate, and its number is never given again. Is %1 void: “%2”?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Eine ungültige Scherbe erhält kein Etikett, keine Zeichnung und keinen Platz auf einer Platte, und ihre Nummer wird nie wieder vergeben. Ist %1 ungültig: „%2“?</translation>
    </message>
    <message>
      <source>Import…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importieren …</translation>
    </message>
    <message>
      <source>Dismiss</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Void sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Für ungültig erklären</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vergleichen</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it; closing again discards it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch nicht gespeichert: %1. Die Enter-Taste im Feld speichert; erneutes Schließen verwirft.</translation>
    </message>
    <message numerus="yes">
      <source>Export %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe exportieren</numerusform>
        <numerusform>%n Scherben exportieren</numerusform>
      </translation>
    </message>
    <message>
      <source>Print labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Etiketten drucken</translation>
    </message>
    <message>
      <source>sherd labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbenetiketten</translation>
    </message>
    <message>
      <source>Only sherds with a number get a label: assign the numbers first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nur Scherben mit Nummer bekommen ein Etikett: zuerst die Nummern vergeben.</translation>
    </message>
    <message>
      <source>Rename places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Orte umbenennen</translation>
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
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ob es ein Randstück ist</translation>
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
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was die Zeichnung sagt</translation>
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
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert: %1</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeichnung geht an den Drucker; drucken Sie mit 100 %.</translation>
    </message>
    <message>
      <source>Automatic</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Automatisch</translation>
    </message>
    <message>
      <source>Rim sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Randstück</translation>
    </message>
    <message>
      <source>No rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Rand</translation>
    </message>
    <message>
      <source>Save…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Speichern …</translation>
    </message>
    <message>
      <source>Print…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Drucken …</translation>
    </message>
    <message>
      <source>Previous sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Voriges Blatt</translation>
    </message>
    <message>
      <source>Next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nächstes Blatt</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgebrochen. Nichts wurde gezeichnet.</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe wird gezeichnet …</numerusform>
        <numerusform>%n Scherben werden gezeichnet …</numerusform>
      </translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg);;PNG, the views of each sherd (*.png);;TIFF, the views of each sherd (*.tif)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, alle Blätter (*.pdf);;SVG, eine Datei je Blatt (*.svg);;PNG, die Ansichten jeder Scherbe (*.png);;TIFF, die Ansichten jeder Scherbe (*.tif)</translation>
    </message>
    <message>
      <source>Different</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unterschiedlich</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportModel</name>
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
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Ordner dieses Namens gibt es schon; wählen Sie einen anderen Namen.</translation>
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
        <numerusform>Eine Scherbe, %1, Verzeichnis geprüft</numerusform>
        <numerusform>%n Scherben, %1, Verzeichnis geprüft</numerusform>
      </translation>
    </message>
    <message>
      <source>Counting…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird gezählt …</translation>
    </message>
    <message>
      <source>No sherds match this selection.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Scherben passen zu dieser Auswahl.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgebrochen. Nichts blieb zurück.</translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>eine davon ohne Modell: %1</numerusform>
        <numerusform>%n davon ohne Modell: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>The whole project, %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ganze Projekt, %1</translation>
    </message>
    <message numerus="yes">
      <source>%n file(s) of the project are missing, changed or links; damage.txt in the archive lists them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Datei des Projekts fehlt, ist geändert oder eine Verknüpfung; damage.txt im Archiv nennt sie.</numerusform>
        <numerusform>%n Dateien des Projekts fehlen, sind geändert oder Verknüpfungen; damage.txt im Archiv nennt sie.</numerusform>
      </translation>
    </message>
    <message>
        <source>Everything in the project, with checksums. &apos;Restore an archive&apos; on the start screen makes the project from it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Alles im Projekt, mit Prüfsummen. „Archiv wiederherstellen“ auf der Startseite macht daraus wieder das Projekt.</translation>
    </message>
    <message numerus="yes">
        <source>%n batch(es) in the queue: the archive holds their photographs and the stages that are finished when it is made; the restored project processes the rest.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Ein Durchgang ist in der Warteschlange: Das Archiv enthält seine Fotos und die Schritte, die bis dahin fertig sind; das wiederhergestellte Projekt verarbeitet den Rest.</numerusform>
            <numerusform>%n Durchgänge sind in der Warteschlange: Das Archiv enthält ihre Fotos und die Schritte, die bis dahin fertig sind; das wiederhergestellte Projekt verarbeitet den Rest.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportScreen</name>
    <message>
      <source>Exported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Exportiert: %1</translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Export</translation>
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
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Filter für den Export</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Befund:0012</translation>
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
      <translation>Die Fotos, unverändert</translation>
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wo</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neuer Ordner für den Export</translation>
    </message>
    <message>
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt des Exports</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner öffnen</translation>
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
      <source>How large a GLB may be. PLY and OBJ get the same surface. Larger models get fewer triangles and smaller photographs; how far they are off is measured and stated in each file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wie groß eine GLB-Datei werden darf. PLY und OBJ erhalten dieselbe Oberfläche. Größere Modelle bekommen weniger Dreiecke und kleinere Fotos; wie weit sie abweichen, wird gemessen und steht in jeder Datei.</translation>
    </message>
    <message>
      <source>Stop the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Export abbrechen</translation>
    </message>
    <message>
      <source>Export: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Export: %1</translation>
    </message>
    <message>
      <source>The export is not finished, and nothing of it would be kept. Close once more to stop it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Export ist nicht fertig, und nichts davon bliebe. Noch einmal schließen, um ihn abzubrechen.</translation>
    </message>
    <message>
        <source>Matching the filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Passend zum Filter</translation>
    </message>
    <message>
        <source>Formats</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Formate</translation>
    </message>
    <message>
        <source>Records (JSON), re-importable</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Datensätze (JSON), wieder importierbar</translation>
    </message>
    <message>
        <source>Full detail</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Volle Auflösung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Selected sherds</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ausgewählte Scherben</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen …</translation>
    </message>
    <message>
      <source>Folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner für den Export</translation>
    </message>
    <message>
      <source>fit to A4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>auf A4 eingepasst</translation>
    </message>
    <message>
      <source>for the web, up to 5 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>für das Web, bis 5 MB</translation>
    </message>
    <message>
      <source>for a phone, up to 1 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>für ein Telefon, bis 1 MB</translation>
    </message>
    <message>
      <source>Tables (CSV): English headings, decimal points</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabellen (CSV): englische Überschriften, Dezimalpunkt</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabellen (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>The whole project, as an archive</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ganze Projekt, als Archiv</translation>
    </message>
    <message>
      <source>Surfaces in the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oberflächen in den Zeichnungen</translation>
    </message>
    <message numerus="yes">
      <source>%n selected sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n ausgewählte Scherbe</numerusform>
        <numerusform>%n ausgewählte Scherben</numerusform>
      </translation>
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
      <translation>T3 Wandstärke&gt;6</translation>
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
      <source>Remove the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bedingung %1 entfernen</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, entered&gt;=2026-07-01, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wörter werden überall gesucht; auch ware:grey, Wandstärke&gt;6, erfasst&gt;=2026-07-01, -burnt, Bemerkung:* gehen.</translation>
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
        <source>Idle</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bereit</translation>
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
      <translation>Platz auf dem Datenträger</translation>
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
        <numerusform>Datenträger: Platz für einen Durchgang</numerusform>
        <numerusform>Datenträger: Platz für %n Durchgänge</numerusform>
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
      <translation>Vollständige, vermessene 3D-Modelle von Scherben aus Fotos beider Seiten.</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apache-Lizenz 2.0. Es benutzt unter anderem Qt (LGPL 3), VTK und OpenCV; die Datei LICENSE und das README nennen alle.</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Handbuch gibt es nur auf Englisch.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: the program uses no network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nichts verlässt diesen Rechner: Das Programm benutzt kein Netz.</translation>
    </message>
    <message>
      <source>Search the manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
      <source>The manual does not mention &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Handbuch erwähnt „%1“ nicht.</translation>
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
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In den Katalog importieren</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fundorte, Schnitte, Befunde und Beutel anlegen, die es noch nicht gibt</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt des Imports</translation>
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
      <translation>Welcher Export?</translation>
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
      <source>Keep the other versions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die anderen Fassungen behalten</translation>
    </message>
    <message>
        <source>to confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>zu bestätigen</translation>
    </message>
    <message>
        <source>Rows</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Spalten</translation>
    </message>
    <message numerus="yes">
        <source>Columns (%n to check)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Spalten (eine zu prüfen)</numerusform>
            <numerusform>Spalten (%n zu prüfen)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Confirm %n row(s)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Eine Zeile bestätigen</numerusform>
            <numerusform>%n Zeilen bestätigen</numerusform>
        </translation>
    </message>
    <message>
      <source>updated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aktualisiert</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgelehnt</translation>
    </message>
    <message>
      <source>unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unverändert</translation>
    </message>
    <message>
      <source>Table (CSV)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabelle (CSV) …</translation>
    </message>
    <message>
      <source>Export folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Exportordner …</translation>
    </message>
    <message>
      <source>Effect of each row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wirkung jeder Zeile</translation>
    </message>
    <message>
      <source>Save rejected rows…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgelehnte Zeilen speichern …</translation>
    </message>
    <message>
      <source>Save rejected rows</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgelehnte Zeilen speichern</translation>
    </message>
    <message>
      <source>rejected.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgelehnt.csv</translation>
    </message>
    <message>
      <source>Line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeile</translation>
    </message>
    <message>
      <source>Action</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aktion</translation>
    </message>
    <message>
      <source>Reason</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Grund</translation>
    </message>
    <message>
      <source>Reading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird gelesen …</translation>
    </message>
    <message>
      <source>Imported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importiert: %1</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
      <source>Import %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Zeile importieren</numerusform>
        <numerusform>%n Zeilen importieren</numerusform>
      </translation>
    </message>
    <message>
      <source>Another project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Projekt …</translation>
    </message>
    <message>
        <source>A table of sherds has a column with their numbers; one of contexts has a column with theirs. Their names may be in any of the program's languages.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Eine Tabelle von Scherben hat eine Spalte mit ihren Nummern; eine von Befunden hat eine Spalte mit deren Nummern. Die Namen dürfen in jeder Sprache des Programms stehen.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 „%2“: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Eine Zeile muss bestätigt werden.</numerusform>
            <numerusform>%n Zeilen müssen bestätigt werden.</numerusform>
        </translation>
    </message>
    <message>
      <source>%1 new, %2 updated, %3 unchanged, %4 rejected.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 neu, %2 aktualisiert, %3 unverändert, %4 abgelehnt.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgebrochen. Nichts wurde importiert.</translation>
    </message>
    <message numerus="yes">
      <source>Cancelled: %n row(s) were not imported. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Abgebrochen: %n Zeile wurde nicht importiert. Für den Rest die Tabelle noch einmal importieren.</numerusform>
        <numerusform>Abgebrochen: %n Zeilen wurden nicht importiert. Für den Rest die Tabelle noch einmal importieren.</numerusform>
      </translation>
    </message>
    <message>
      <source>Undo does not take back contexts and bags; the catalogue is backed up before the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückgängig nimmt Befunde und Beutel nicht zurück; der Katalog wird vor dem Import gesichert.</translation>
    </message>
    <message>
      <source>Undo does not take back new sherds; each can be voided in its details.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückgängig nimmt neue Scherben nicht zurück; jede kann in ihren Details ungültig gemacht werden.</translation>
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
      <translation>Welche Vorderseite gehört zu der von %1? Wählen Sie ihre Karte (Pfeile und Eingabe); ein Klick auf das Bild einer Rückseite führt die Rückseiten zusammen.</translation>
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
      <translation>%1 ist abgebrochen: %2</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückgängig</translation>
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
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Überall</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Berechnung wird angehalten; sie geht weiter, sobald das Projekt wieder geöffnet wird. Das Fenster schließt gleich.</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückgängig: %1</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Katalog konnte nicht kopiert werden: %1</translation>
    </message>
    <message>
        <source>%1 is ready.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 ist fertig.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
      <source>Queue: editing masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Warteschlange: Masken bearbeiten</translation>
    </message>
    <message>
      <source>%1 (read-only)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (nur lesbar)</translation>
    </message>
    <message>
      <source>%1 is being processed. Leaving the project stops it, and it continues when the project is opened again. Choose Projects once more to leave.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird verarbeitet. Beim Verlassen des Projekts hält das an und geht weiter, wenn das Projekt wieder geöffnet wird. Zum Verlassen noch einmal Projekte wählen.</translation>
    </message>
    <message>
      <source>Import cancelled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Import abgebrochen</translation>
    </message>
    <message>
      <source>The project that was created for it is removed. Your photographs are as they were.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Projekt, das dafür angelegt wurde, ist entfernt. Ihre Fotos sind, wie sie waren.</translation>
    </message>
    <message>
        <source>Restoring cancelled</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Wiederherstellung abgebrochen</translation>
    </message>
    <message>
        <source>Nothing was left behind.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Nichts ist zurückgeblieben.</translation>
    </message>
    <message>
        <source>The project is restored.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Das Projekt ist wiederhergestellt.</translation>
    </message>
    <message>
        <source>It was archived with damage:</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Es wurde mit Schäden archiviert:</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapScreen</name>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan und Etiketten drucken</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchgang %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchgang %1, %2</translation>
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
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Etikett für jeden Beutel drucken; sein Code gibt einem Durchgang seinen Befund (Strg+Umschalt+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es gibt noch keinen Beutel: beim Aufnehmen einen eintippen oder eine Befundtabelle importieren.</translation>
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
      <translation>Dieser Durchgang wurde gescannt, nicht fotografiert: Von seiner Platte gibt es kein Bild.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe dieses Durchgangs hat noch keine Nummer: Ihr Etikett nennt den Durchgang.</numerusform>
        <numerusform>%n Scherben dieses Durchgangs haben noch keine Nummer: Ihre Etiketten nennen den Durchgang.</numerusform>
      </translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>No map yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Noch kein Plan</translation>
    </message>
    <message>
      <source>The map is still loading.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Plan wird noch geladen.</translation>
    </message>
    <message>
        <source>The map of a batch appears here once it is processed, and shows which sherd lay where.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Plan eines Durchgangs erscheint hier, sobald er verarbeitet ist, und zeigt, welche Scherbe wo lag.</translation>
    </message>
    <message>
      <source>%1 map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Plan und Etiketten</translation>
    </message>
    <message>
      <source>bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beuteletiketten</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Platte, vorn und hinten</translation>
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
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird geladen …</translation>
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
        <source>Dismiss</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>OK</translation>
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
      <source>No model yet: it comes when the batch of the sherd is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch kein Modell: es entsteht, wenn der Durchgang der Scherbe verarbeitet wird.</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the model cannot be turned.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Bildschirm hat kein OpenGL 3.2; das Modell lässt sich nicht drehen.</translation>
    </message>
    <message>
      <source>No model: the sherd belongs to no batch of photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Modell: Die Scherbe gehört zu keinem Durchgang mit Fotos.</translation>
    </message>
    <message>
      <source>Large view</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Große Ansicht</translation>
    </message>
    <message>
      <source>The model alone, as large as the page; again or Esc: beside the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Modell allein, so groß wie die Seite; noch einmal oder Esc: neben der Tabelle</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site&apos;s code has two to eight letters from A to Z and digits, without accents, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel des Fundorts hat zwei bis acht Großbuchstaben von A bis Z und Ziffern, ohne Umlaute, wie ARM1.</translation>
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
    <message>
        <source>Photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotos</translation>
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
      <translation>Umrisse übereinandergelegt, und ihre Drehwinkel</translation>
    </message>
    <message>
      <source>Outlines overlaid</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Umrisse übereinander</translation>
    </message>
    <message>
      <source>Turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Drehwinkel</translation>
    </message>
    <message>
      <source>The lines of a pair lie on each other.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bei einem Paar liegen die Linien aufeinander.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CardInHand</name>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Rückseite ist gewählt.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wahl von %1</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anfangspunkt</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Drehen von Hand</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Rückseite allein hat kein geschlossenes Modell.</translation>
    </message>
    <message>
      <source>Cancelled. The back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Angehalten; die Rückseite bleibt, wo sie war.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was nur ausprobiert wurde, gibt es nicht mehr: Seine Paare wurden seither geschlossen.</translation>
    </message>
    <message>
      <source>The fractures do not touch here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Brüche berühren sich hier nicht.</translation>
    </message>
    <message>
      <source>Fractures %1 apart, %2 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brüche %1 auseinander, %2 davon berühren sich.</translation>
    </message>
    <message>
      <source>Turned by hand; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von Hand gedreht; B verfeinert die Lage.</translation>
    </message>
    <message>
      <source>Start point %1; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anfangspunkt %1; B verfeinert die Lage.</translation>
    </message>
    <message>
      <source>refining the fit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verfeinern der Lage</translation>
    </message>
    <message>
      <source>This pair has no closed model yet. Reprocess the batch to make it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Paar hat noch kein geschlossenes Modell. Es entsteht beim Neuverarbeiten.</translation>
    </message>
    <message>
      <source>This back has no partner.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Rückseite hat keinen Partner.</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird geladen …</translation>
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
      <translation>Wählen Sie zuerst eine Rückseite.</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geben Sie zuerst Ihr Kürzel ein: Jede Entscheidung behält ihren Namen.</translation>
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
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Paar ist gewählt: Geben Sie diese Rückseite erst einer Vorderseite.</translation>
    </message>
    <message>
        <source>reshooting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Neuaufnahme von %1</translation>
    </message>
    <message>
        <source>merging %1 and %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zusammenführen von %1 und %2</translation>
    </message>
    <message>
        <source>splitting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Teilen von %1</translation>
    </message>
    <message>
      <source>One of the two has no back to merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine der beiden hat keine Rückseite, die sich zusammenführen ließe.</translation>
    </message>
    <message>
      <source>A pair can be decided once it is shown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Paar kann entschieden werden, sobald es zu sehen ist.</translation>
    </message>
    <message>
      <source>All pairs of this batch are decided.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle Paare dieses Durchgangs sind entschieden.</translation>
    </message>
    <message>
      <source>Saved. Check %1 – %2: only %3 of their fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Bitte %1 – %2 prüfen: Nur %3 ihrer Brüche berühren sich.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos beider Seiten</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorn %1, hinten %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Foto ist nicht da.</translation>
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
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wird geladen …</translation>
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
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fundort, Schnitt, Befund und Beutel</translation>
    </message>
    <message>
      <source>New: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neu: %1</translation>
    </message>
    <message>
      <source>scan its label, or %1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Etikett scannen, oder %1-T3-0012-4</translation>
    </message>
    <message>
      <source>Write the bag as site-trench-context-bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Beutel als Fundort-Schnitt-Befund-Beutel schreiben.</translation>
    </message>
    <message>
      <source>No bag: the sherds can be numbered once the catalogue gives them a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Beutel: Die Scherben können nummeriert werden, sobald der Katalog ihnen einen Befund gibt.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateView</name>
    <message>
      <source>Picture of the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild der Platte</translation>
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
    <name>ostraka::ui::QueueScreen</name>
    <message>
      <source>This batch has no masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang hat keine Masken.</translation>
    </message>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pause</translation>
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Protokoll</translation>
    </message>
    <message>
      <source>Batches</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchgänge</translation>
    </message>
    <message>
      <source>Log of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Protokoll der Berechnung</translation>
    </message>
    <message>
      <source>No batch yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch kein Durchgang</translation>
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
        <numerusform>Ein Durchgang ist abgebrochen und braucht Sie</numerusform>
        <numerusform>%n Durchgänge sind abgebrochen und brauchen Sie</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hat noch keinen Bericht.</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erst Entwürfe</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Kamera wurde angestoßen: Die Fotos dieses Durchgangs sagen, wo die Kameras jetzt stehen (C)</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Neu verarbeiten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bericht zeigen</translation>
    </message>
    <message>
        <source>Review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Edit masks</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Masken bearbeiten</translation>
    </message>
    <message>
        <source>Open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Processes each new batch quickly and coarsely, for a check while the sherds are still on the plate; reprocessing makes it final (D)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Verarbeitet jeden neuen Durchgang schnell und grob zur Prüfung, solange die Scherben noch liegen; neu verarbeitet wird er endgültig (D)</translation>
    </message>
    <message>
        <source>Recalibrate rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Messplatz neu kalibrieren</translation>
    </message>
    <message>
        <source>What you photograph or import is processed here, one batch after the other, while you go on working.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Was aufgenommen oder importiert wird, wird hier verarbeitet, ein Durchgang nach dem anderen, während Sie weiterarbeiten.</translation>
    </message>
    <message>
        <source>Batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Resume</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Beiseitelegen</translation>
    </message>
    <message>
        <source>Cancel %1?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 abbrechen?</translation>
    </message>
    <message>
        <source>It has been processing for more than an hour. Finished stages are saved; the current one is lost.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Die Verarbeitung läuft seit mehr als einer Stunde. Fertige Schritte sind gespeichert; der laufende geht verloren.</translation>
    </message>
    <message>
        <source>Cancel it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Keep processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Weiter verarbeiten</translation>
    </message>
    <message>
      <source>Marker side…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Markenseite …</translation>
    </message>
    <message>
      <source>Keep both</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beide behalten</translation>
    </message>
    <message>
      <source>Processes this batch although another one has the same photographs; the sherds of both are then in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Verarbeitet diesen Durchgang, obwohl ein anderer dieselben Fotos hat; dann stehen die Scherben beider im Katalog</translation>
    </message>
    <message>
      <source>The report of %1 is not opened: this version of Ostraka did not write it, and it may run scripts. Reprocess the batch to write it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Bericht von %1 wird nicht geöffnet: Diese Version von Ostraka hat ihn nicht geschrieben, und er könnte Skripte ausführen. Den Durchgang neu verarbeiten, damit er neu geschrieben wird.</translation>
    </message>
    <message>
        <source>The queue is paused: this project was restored from an archive.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Die Warteschlange ist angehalten: Dieses Projekt wurde aus einem Archiv wiederhergestellt.</translation>
    </message>
    <message>
        <source>Its batches that are not processed yet wait until you resume it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Durchgänge, die noch nicht verarbeitet sind, warten, bis Sie sie fortsetzen.</translation>
    </message>
    <message>
        <source>Photographs are being imported; their batch appears here when all of them are copied.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotos werden importiert; ihr Durchgang erscheint hier, wenn alle kopiert sind.</translation>
    </message>
    <message>
        <source>Show the import</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Import zeigen</translation>
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
      <translation>Seiten</translation>
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
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modell</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beiseite</translation>
    </message>
    <message>
      <source>… and the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation> … und das andere Ende</translation>
    </message>
    <message>
      <source>Pairs of the batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Paare des Durchgangs</translation>
    </message>
    <message>
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klicken Sie auf der Scherbe auf ein Ende der Strecke, dann auf das andere. D beendet.</translation>
    </message>
    <message>
        <source>Accept</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Leave merging and splitting</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zusammenführen und Teilen verlassen</translation>
    </message>
    <message>
        <source>Refine fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Passung verfeinern</translation>
    </message>
    <message>
        <source>Refine the position by the fracture surfaces (B)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Lage nach den Bruchflächen verfeinern (B)</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Neu aufnehmen</translation>
    </message>
    <message>
        <source>View</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Passung</translation>
    </message>
    <message>
        <source>Decide</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Entscheiden</translation>
    </message>
    <message>
        <source>Explode</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Auseinanderziehen</translation>
    </message>
    <message>
        <source>Fracture gap</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bruchabstand</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Split a scan of two sherds along a line over its photograph (K)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Den Scan zweier Scherben entlang einer Linie über dem Foto teilen (K)</translation>
    </message>
    <message>
        <source>Merge</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zusammenführen</translation>
    </message>
    <message>
        <source>Merge two fragments of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zwei Fragmente einer Scherbe zusammenführen: dann die andere Karte wählen (J Vorderseiten, Umschalt+J Rückseiten)</translation>
    </message>
    <message>
        <source>Merge backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Rückseiten zusammenführen</translation>
    </message>
    <message>
      <source>Comparing the fractures… Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Brüche werden verglichen … Esc hält an.</translation>
    </message>
    <message>
      <source>Refining the fit, fracture gap %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Lage wird verfeinert, Abstand der Brüche %1. Esc hält an.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ReviewScreen</name>
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
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Prüfung</translation>
    </message>
    <message>
        <source>Update changed models</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geänderte Modelle erneuern</translation>
    </message>
    <message>
        <source>Reprocesses the pairs that were decided differently</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Verarbeitet die anders entschiedenen Paare neu</translation>
    </message>
    <message>
        <source>No pairs to review yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Noch keine Paare zu prüfen</translation>
    </message>
    <message>
        <source>Photograph or import a batch. Its pairs appear here when it is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Einen Durchgang aufnehmen oder importieren. Seine Paare erscheinen hier, wenn er verarbeitet ist.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bericht zeigen</translation>
    </message>
    <message>
        <source>%1 was reshot as %2 in %3 and now has two records. Void one of them in the catalogue, or set the fragment aside here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 wurde als %2 in %3 neu aufgenommen und hat nun zwei Datensätze. Einen davon im Katalog für ungültig erklären oder das Fragment hier beiseitelegen.</translation>
    </message>
    <message>
      <source>%1 is queued; only what changed is reprocessed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist in der Warteschlange; nur was sich geändert hat, wird neu verarbeitet.</translation>
    </message>
    <message>
      <source>Saved. Pairs of the new fragments appear after reprocessing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Die Paare der neuen Fragmente erscheinen nach dem Neuverarbeiten.</translation>
    </message>
    <message>
      <source>Undone. The history keeps both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zurückgenommen. Beides bleibt im Verlauf.</translation>
    </message>
    <message>
      <source>No pairs to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Paare zu prüfen</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ein Paar zu prüfen</numerusform>
        <numerusform>%n Paare zu prüfen</numerusform>
      </translation>
    </message>
    <message>
      <source>No measurement of %1 is certain. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keines der Maße von %1 ist sicher. %2</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd has no number, and %1 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Nach dem Neuverarbeiten hat die zusammengeführte Scherbe keine Nummer, und %1 kein Fragment. Rückgängig trennt sie wieder.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd keeps the number %1, and %2 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Nach dem Neuverarbeiten behält die zusammengeführte Scherbe die Nummer %1, und %2 hat kein Fragment. Rückgängig trennt sie wieder.</translation>
    </message>
    <message>
      <source>%1 has no scale: no length shown here is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hat keinen Maßstab: Keine Länge hier ist in Millimetern.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, number %1 goes to the half that it was typed on, or else to the larger one. Undo merges them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Nach dem Neuverarbeiten geht die Nummer %1 an die Hälfte, auf der sie getippt wurde, sonst an die größere. Rückgängig führt sie wieder zusammen.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: the sherds in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Alle Paare von %1 sind entschieden. Als Nächstes: die Scherben im Katalog.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: update the changed models.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert. Alle Paare von %1 sind entschieden. Als Nächstes: die geänderten Modelle aktualisieren.</translation>
    </message>
    <message>
      <source>Saved, with your initials.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert, mit Ihrem Kürzel.</translation>
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
      <source>Use the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den virtuellen Messplatz nehmen</translation>
    </message>
    <message>
      <source>Choose a rig file…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Messplatzdatei wählen …</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos importieren …</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scans importieren …</translation>
    </message>
    <message>
      <source>The virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der virtuelle Messplatz</translation>
    </message>
    <message>
      <source>small: a batch in a minute or two</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>klein: ein Durchgang in ein, zwei Minuten</translation>
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
      <translation>&amp;Scherben auf der Platte</translation>
    </message>
    <message>
      <source>&amp;Photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Fotos</translation>
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
    <message>
        <source>Keep current rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bisherigen Messplatz behalten</translation>
    </message>
    <message>
      <source>Import photographs taken by hand, or choose a rig file (RIG.json), which names your cameras and your turntable. The virtual rig is for practice: its sherds are invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Importieren Sie von Hand aufgenommene Fotos, oder wählen Sie eine Messplatzdatei (RIG.json), die Ihre Kameras und Ihren Drehtisch nennt. Der virtuelle Messplatz dient der Übung: Seine Scherben sind erfunden.</translation>
    </message>
    <message>
      <source>No rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Messplatz</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Use the virtual rig in this project?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den virtuellen Messplatz in diesem Projekt verwenden?</translation>
    </message>
    <message>
      <source>It is for practice: its sherds are invented, and they enter this project's catalogue. The queue marks its batches as invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Er dient der Übung: Seine Scherben sind erfunden und kommen in den Katalog dieses Projekts. Die Warteschlange kennzeichnet seine Durchgänge als erfunden.</translation>
    </message>
    <message>
        <source>Importing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Import läuft</translation>
    </message>
    <message>
        <source>The batch goes into the queue when all of its files are copied. Meanwhile you can choose a rig.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Durchgang kommt in die Warteschlange, wenn alle seine Dateien kopiert sind. Inzwischen können Sie einen Messplatz wählen.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectEdit</name>
    <message>
      <source>As photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wie fotografiert</translation>
    </message>
    <message>
      <source>Without the light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ohne das Licht</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Offenes Projekt</translation>
    </message>
    <message>
      <source>Na&amp;me</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Na&amp;me</translation>
    </message>
    <message>
      <source>Site &amp;code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Fundortkürzel</translation>
    </message>
    <message>
      <source>Textures of new mo&amp;dels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Texturen neuer M&amp;odelle</translation>
    </message>
    <message>
      <source>rename the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt umbenennen</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert.</translation>
    </message>
    <message>
      <source>change the textures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Texturen ändern</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::RightsEdit</name>
    <message>
      <source>Rights to the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rechte am offenen Projekt</translation>
    </message>
    <message>
      <source>for instance CC-BY-4.0; empty: none is named</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>zum Beispiel CC-BY-4.0; leer: keine wird genannt</translation>
    </message>
    <message>
      <source>&amp;Licence of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Lizenz des Exportierten</translation>
    </message>
    <message>
      <source>Who &amp;holds the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wer die &amp;Rechte hat</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert.</translation>
    </message>
    <message>
      <source>change the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rechte ändern</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SettingsPage</name>
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
        <source>Follow system</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Recorded with each decision.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Wird bei jeder Entscheidung vermerkt.</translation>
    </message>
    <message>
        <source>Takes effect after restart.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Wirkt nach einem Neustart.</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Zurück (Esc)</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Jetzt neu starten</translation>
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
      <translation>Verlauf</translation>
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
      <source>7 is the running number in the sherd&apos;s context; =7 is the number 7 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7 ist die laufende Nummer im Befund der Scherbe; =7 ist die Nummer 7 selbst.</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>computed; replaced by the measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>berechnet; durch den gemessenen Wert ersetzt</translation>
    </message>
    <message>
      <source>Assign number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummer %1 vergeben</translation>
    </message>
    <message>
      <source>Numbering…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nummerierung …</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Foto</translation>
    </message>
    <message>
      <source>mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maske</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scan</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modell</translation>
    </message>
    <message>
      <source>picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bild</translation>
    </message>
    <message>
      <source>drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeichnung</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch nicht gespeichert: %1. Die Enter-Taste im Feld speichert es.</translation>
    </message>
    <message>
      <source>-0599/-0549: 600 to 550 BC</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>-0599/-0549: 600 bis 550 v. Chr.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdEdits</name>
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
    <message numerus="yes">
      <source>%n sherd(s) got no number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Scherbe bekam keine Nummer: %1</numerusform>
        <numerusform>%n Scherben bekamen keine Nummer: %1</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>numbering of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe nummerieren</numerusform>
        <numerusform>%n Scherben nummerieren</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgebrochen. Nichts wurde geändert.</translation>
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
      <translation>nicht erfasst</translation>
    </message>
    <message>
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, zweifelhaft</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Der Maßstab von Durchgang %2 ist zweifelhaft; sein Bericht sagt, warum und was zu tun ist.</translation>
    </message>
    <message>
        <source>%1: measured by hand; the computed value is kept beside it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: von Hand gemessen; der berechnete Wert bleibt daneben erhalten.</translation>
    </message>
    <message>
        <source>%1: %2, measured by hand</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: %2, von Hand gemessen</translation>
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
      <translation>Dieser Bildschirm hat kein OpenGL 3.2; die Scherbe lässt sich nicht räumlich zeigen. Alles andere geht; Fotos und Umrisse stehen daneben.</translation>
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
      <translation>Wählen …</translation>
    </message>
    <message>
      <source>Choose the folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner wählen</translation>
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
      <source>%1
%2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2, %3</translation>
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
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wo ist %1 jetzt?</translation>
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
        <source>Create project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Projekt anlegen</translation>
    </message>
    <message>
        <source>Example</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>OK</translation>
    </message>
    <message>
        <source>Repair the catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Katalog reparieren</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2 ist nicht da: suchen …</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eingabe</translation>
    </message>
    <message>
        <source>No project yet. Import photographs of both sides of your sherds, or drop their folders here: a project is created for them. To practise, try the virtual rig: it breaks a pot and photographs its sherds for you.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Noch kein Projekt. Importieren Sie Fotos beider Seiten Ihrer Scherben, oder legen Sie deren Ordner hier ab: Dafür wird ein Projekt angelegt. Zum Üben dient der virtuelle Messplatz: Er zerbricht ein Gefäß und fotografiert die Scherben.</translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotos importieren …</translation>
    </message>
    <message>
        <source>Creates a project named after their folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Legt ein Projekt mit dem Namen ihres Ordners an</translation>
    </message>
    <message>
        <source>Folder of the photographs: both sides, or a folder for each side within it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ordner der Fotos: beide Seiten, oder darin ein Ordner je Seite</translation>
    </message>
    <message>
        <source>&amp;Restore an archive…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Archiv &amp;wiederherstellen …</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wiederherstellen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Restoring the project to %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Das Projekt wird in %1 wiederhergestellt</translation>
    </message>
    <message>
        <source>Folder of the archive</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ordner des Archivs</translation>
    </message>
    <message>
        <source>Where to put the project: an empty folder, or one for a new folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Wohin mit dem Projekt: ein leerer Ordner oder einer für einen neuen Ordner</translation>
    </message>
    <message>
      <source>&amp;Open from folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Aus Ordner öffnen …</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt öffnen</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n batch(es) unfinished</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; %n Durchgang unfertig</numerusform>
        <numerusform>%1; %n Durchgänge unfertig</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::StopBoard</name>
    <message>
      <source>Photographs of this side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos dieser Seite</translation>
    </message>
    <message>
      <source>%1 of %2 positions done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 von %2 Positionen fertig</translation>
    </message>
    <message>
      <source>%1 of %2 calibration photographs taken</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 von %2 Kalibrierfotos aufgenommen</translation>
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
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>Back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>No scale: lengths are not known</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kein Maßstab: Längen sind nicht bekannt</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>kein Kontakt</translation>
    </message>
    <message>
        <source>filled in, not seen by a camera</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ergänzt, von keiner Kamera gesehen</translation>
    </message>
    <message>
        <source>Distance between the sides along the fracture</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Abstand der Seiten entlang des Bruchs</translation>
    </message>
    <message>
        <source>front outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Vorderseite außen um %1</translation>
    </message>
    <message>
        <source>back outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Rückseite außen um %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, the whole number, or scan its label</source>
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
    <message>
      <source>Sherd %1 got no number. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1 bekam keine Nummer. %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskModel</name>
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
    <message>
      <source>%1, camera %2, position %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, Kamera %2, Position %3</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken von %1</translation>
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
      <translation>Nächstes Foto</translation>
    </message>
    <message>
      <source>Photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Foto</translation>
    </message>
    <message>
      <source>Plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Platte</translation>
    </message>
    <message>
      <source>Sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe</translation>
    </message>
    <message>
        <source>Previous photograph</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Voriges Foto</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Neu verarbeiten</translation>
    </message>
    <message>
        <source>Brush</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Loading photograph…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Foto wird geladen …</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) edited. Reprocess to update what follows from them.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n Foto bearbeitet. Neu verarbeiten, damit gilt, was daraus folgt.</numerusform>
            <numerusform>%n Fotos bearbeitet. Neu verarbeiten, damit gilt, was daraus folgt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Blue: classified as sherd. Paint missing parts as sherd and wrong ones as plate; the program&apos;s own masks stay.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Blau: als Scherbe erkannt. Fehlendes als Scherbe malen, Falsches als Platte; die Masken des Programms bleiben.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskView</name>
    <message>
      <source>Photograph with its mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Foto mit seiner Maske</translation>
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
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bis</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, und {n} einmal; {n:04} hat mindestens vier Ziffern</translation>
    </message>
    <message>
      <source>Example</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beispiel</translation>
    </message>
    <message>
      <source>Use this &amp;numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese &amp;Nummerierung verwenden</translation>
    </message>
    <message>
      <source>Skipped numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ausgelassene Nummern</translation>
    </message>
    <message>
      <source>none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>keine</translation>
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
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gespeichert.</translation>
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
      <source>&amp;Save vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vokabular speich&amp;ern</translation>
    </message>
    <message>
      <source>&amp;One per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eines &amp;je Zeile</translation>
    </message>
    <message>
      <source>Project vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vokabular des Projekts</translation>
    </message>
    <message>
      <source>Terms, one per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Begriffe, einer je Zeile</translation>
    </message>
    <message>
      <source>change the vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ändern des Vokabulars</translation>
    </message>
    <message>
      <source>These terms are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Begriffe sind noch nicht gespeichert.</translation>
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
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wie weit der Import ist</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Import anhalten</translation>
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
      <translation>Scherbe %1 auf dieser Platte hat die Nummer %2: Nehmen Sie sie ihr zuerst, oder geben Sie eine andere ein.</translation>
    </message>
    <message>
      <source>A sherd of %1 has the number %2 already; type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe von %1 hat die Nummer %2 schon; geben Sie eine andere ein.</translation>
    </message>
    <message>
      <source>Sherd %1: %2 is not as this bag's sherds are numbered (%3). If that is no slip, go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1: %2 ist nicht so, wie die Scherben dieses Beutels nummeriert werden (%3). Wenn das kein Versehen ist, weiter.</translation>
    </message>
</context>
<context>
    <name>ostraka::Error</name>
    <message>
      <source>The disk has only %1 MB left, and a batch needs more. Nothing is lost: free some space, then resume.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf dem Datenträger sind nur noch %1 MB frei; ein Durchgang braucht mehr. Nichts ist verloren: Platz schaffen, dann fortsetzen.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but there is no sherd with a context in that place; assign it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Diese Nummer wurde auf der Platte eingetippt, aber dort liegt keine Scherbe mit einem Befund; vergeben Sie sie im Katalog.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but it belongs to another sherd; check which of the two bears it, and give the other one a new number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: diese Nummer wurde auf der Platte getippt, gehört aber einer anderen Scherbe; nachsehen, welche der beiden sie trägt, und der anderen eine neue geben.</translation>
    </message>
    <message>
      <source>Pairs were decided or masks edited while the batch was being processed; reprocess it to apply them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Während der Durchgang verarbeitet wurde, wurden Paare entschieden oder Masken bearbeitet. Dafür neu verarbeiten.</translation>
    </message>
    <message>
      <source>Sherds counted on the plate: %1, but another number was found; check the map for a sherd that is missing or was split in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf der Platte gezählte Scherben: %1. Gefunden wurde eine andere Zahl; suchen Sie auf dem Plan nach einer, die fehlt oder zerteilt ist.</translation>
    </message>
    <message>
      <source>Cancelled.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgebrochen.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera ist nicht angeschlossen oder nicht eingeschaltet.</translation>
    </message>
    <message>
      <source>The camera does not answer and may be asleep. Turn off its automatic power-off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera antwortet nicht und schläft vielleicht. Ihre automatische Abschaltung ausschalten.</translation>
    </message>
    <message>
      <source>The camera remains busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera bleibt beschäftigt; aus- und wieder einschalten.</translation>
    </message>
    <message>
      <source>The connection to the camera failed; check its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Verbindung zur Kamera ist ausgefallen; ihr Kabel prüfen.</translation>
    </message>
    <message>
      <source>Another program uses the camera, often the desktop&apos;s file manager; &apos;ostraka devices&apos; names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Programm benutzt die Kamera, oft die Dateiverwaltung; 'ostraka devices' nennt es.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; check this user&apos;s permissions with &apos;ostraka devices&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera lässt sich nicht öffnen; die Rechte dieses Benutzers mit 'ostraka devices' prüfen.</translation>
    </message>
    <message>
      <source>The camera sent no photograph; check that it is focused and set to manual.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von der Kamera kam kein Foto; prüfen, ob sie scharf gestellt und auf manuell ist.</translation>
    </message>
    <message>
      <source>The camera does not stop sending photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera hört nicht auf, Fotos zu liefern.</translation>
    </message>
    <message>
      <source>This camera has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Kamera zeigt kein Livebild.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; check that nothing blocks it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch erreicht seinen Winkel nicht; prüfen, ob ihn etwas blockiert.</translation>
    </message>
    <message>
      <source>The turntable was paused with its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch wurde an seinem eigenen Knopf angehalten.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Position des Drehtisches ist unbekannt: nullen oder ausrichten.</translation>
    </message>
    <message>
      <source>The turntable does not answer on the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht im Netz.</translation>
    </message>
    <message>
      <source>The controller restarted; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Steuerung ist neu gestartet; die Position des Drehtisches ist unbekannt.</translation>
    </message>
    <message>
      <source>A reply from the turntable was lost, and it cannot report its position: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Antwort des Drehtisches ging verloren, und er kann seine Position nicht melden: nullen oder ausrichten.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht wie eine GRBL-Steuerung; prüfen, ob er eingeschaltet und von dieser Art ist.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht wie ein ComXim; prüfen, ob er eingeschaltet und von dieser Art ist.</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB funktioniert auf diesem Computer nicht.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger ist voll; Platz schaffen und noch einmal versuchen.</translation>
    </message>
    <message>
      <source>The disk is full; free some space, then try again. No data was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger ist voll; Platz schaffen und noch einmal versuchen. Nichts ging verloren.</translation>
    </message>
    <message>
      <source>Another program is using the catalogue; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Programm benutzt den Katalog; es schließen und noch einmal versuchen.</translation>
    </message>
    <message>
      <source>Another program is repairing or using the catalogue; this one waits up to 10 seconds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Programm repariert oder benutzt den Katalog; dieses wartet bis zu 10 Sekunden.</translation>
    </message>
    <message>
      <source>The image file is truncated; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Bild ist vor seinem Ende abgeschnitten; noch einmal von der Kamera kopieren.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a kind of context; use layer, cut, fill, structure, surface or unstratified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>„%1“ ist keine Art von Befund; möglich sind layer, cut, fill, structure, surface und unstratified.</translation>
    </message>
    <message>
      <source>New sites and trenches: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neue Fundorte und Schnitte: %1; auf Schreibfehler prüfen.</translation>
    </message>
    <message>
      <source>The results of this batch no longer exist; reprocess it, then decide.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ergebnisse dieses Durchgangs sind nicht mehr da; ihn neu verarbeiten, dann entscheiden.</translation>
    </message>
    <message>
      <source>Camera %1: its photographs come from different cameras (%2); give each camera its own name, because photographs with the same camera name share one lens calibration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: ihre Fotos stammen von verschiedenen Kameras (%2); jeder Kamera einen eigenen Namen geben, denn Fotos mit demselben Kameranamen teilen sich eine Objektivkalibrierung.</translation>
    </message>
    <message>
      <source>Camera %1: its focal length varies between photographs (%2); all share one lens calibration, so fix the zoom and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: ihre Brennweite ist nicht in allen Fotos gleich (%2); alle teilen sich eine Objektivkalibrierung, also den Zoom festsetzen und neu aufnehmen.</translation>
    </message>
    <message>
      <source>Camera %1: its aperture varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: ihre Blende ist nicht in allen Fotos gleich (%2); die Kamera auf manuell stellen: ungleiche Fotos machen Masken und Farben unsicherer.</translation>
    </message>
    <message>
      <source>Camera %1: its exposure time varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: ihre Belichtungszeit ist nicht in allen Fotos gleich (%2); die Kamera auf manuell stellen: ungleiche Fotos machen Masken und Farben unsicherer.</translation>
    </message>
    <message>
      <source>Camera %1: its sensitivity varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: ihre Empfindlichkeit ist nicht in allen Fotos gleich (%2); die Kamera auf manuell stellen: ungleiche Fotos machen Masken und Farben unsicherer.</translation>
    </message>
    <message>
      <source>Camera %1: its white balance varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: ihr Weißabgleich ist nicht in allen Fotos gleich (%2); die Kamera auf manuell stellen: ungleiche Fotos machen Masken und Farben unsicherer.</translation>
    </message>
    <message>
      <source>No camera model fits the calibration pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Kameramodell passt zu den Kalibrierbildern.</translation>
    </message>
    <message>
      <source>No photograph of this camera shows the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Foto dieser Kamera zeigt die Marken der Platte.</translation>
    </message>
    <message>
      <source>No batch folder was given.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Ordner eines Durchgangs wurde angegeben.</translation>
    </message>
    <message>
      <source>The angle is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Winkel ist keine Zahl.</translation>
    </message>
    <message>
      <source>This program is not installed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Programm ist nicht installiert.</translation>
    </message>
    <message>
      <source>The photographs show no common object; check the cameras, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Fotos zeigen keinen gemeinsamen Gegenstand; die Kameras prüfen oder Masken angeben.</translation>
    </message>
    <message>
      <source>A visual hull needs at least 3 photographs; photograph the object from more directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Hülle braucht mindestens 3 Fotos; den Gegenstand aus mehr Richtungen aufnehmen.</translation>
    </message>
    <message>
      <source>The cameras do not view a common area; check their poses.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kameras blicken nicht auf einen gemeinsamen Bereich; ihre Lagen prüfen.</translation>
    </message>
    <message>
      <source>The network needs an 8-bit colour photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Netz braucht ein Farbfoto mit 8 Bit.</translation>
    </message>
    <message>
      <source>The drawing needs a scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeichnung braucht einen Maßstab.</translation>
    </message>
    <message>
      <source>The preview was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Vorschau wurde rückgängig gemacht.</translation>
    </message>
    <message>
      <source>Restoring a project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zum Wiederherstellen eines Projekts ist ein neuer oder leerer Ordner nötig; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>Not an archive of a whole project; import it as an export instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist kein Archiv eines ganzen Projekts; statt dessen als Export importieren.</translation>
    </message>
    <message>
      <source>This is a project already, not an archive of one; open it as it is.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist schon ein Projekt und kein Archiv; es öffnen, wie es ist.</translation>
    </message>
    <message>
      <source>This is an archive of a whole project, not an export; restore it (ostraka catalogue restore), then merge the restored project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist das Archiv eines ganzen Projekts und kein Export; es wiederherstellen (ostraka catalogue restore), dann das wiederhergestellte Projekt zusammenführen.</translation>
    </message>
    <message>
      <source>The file or folder cannot be written (%1); choose another location, or check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei oder der Ordner lässt sich nicht schreiben (%1); einen anderen Ort wählen oder die Zugriffsrechte prüfen.</translation>
    </message>
    <message>
      <source>There is no such file; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei gibt es nicht; den Namen prüfen.</translation>
    </message>
    <message>
      <source>The file cannot be opened (%1); check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei lässt sich nicht öffnen (%1); ihre Zugriffsrechte prüfen.</translation>
    </message>
    <message>
      <source>The file is larger than the limit of %1 bytes; check that it is the right one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei ist größer als die Grenze von %1 Bytes; prüfen, ob es die richtige ist.</translation>
    </message>
    <message>
      <source>The file cannot be read (%1); copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei lässt sich nicht lesen (%1); noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The JSON text is larger than 64 MiB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der JSON-Text ist größer als 64 MiB.</translation>
    </message>
    <message>
      <source>The JSON is nested more than 64 levels deep.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das JSON ist tiefer als 64 Ebenen verschachtelt.</translation>
    </message>
    <message>
      <source>Not valid JSON (line %1); correct that line, or copy the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist kein gültiges JSON (Zeile %1); diese Zeile berichtigen oder die Datei noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The JSON contains a number that is too large; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das JSON enthält eine zu große Zahl; sie berichtigen.</translation>
    </message>
    <message>
      <source>A transform must be a 4x4 matrix.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Transformation muss eine 4x4-Matrix sein.</translation>
    </message>
    <message>
      <source>A transform contains a value that is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Transformation enthält etwas, das keine Zahl ist.</translation>
    </message>
    <message>
      <source>A transform is not rigid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Transformation ist nicht starr.</translation>
    </message>
    <message>
      <source>A transform moves by more than %1 mm; check that its last column is in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Transformation verschiebt um mehr als %1 mm; prüfen, ob ihre letzte Spalte in mm ist.</translation>
    </message>
    <message>
      <source>There is no such folder; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diesen Ordner gibt es nicht; den Ordner eines Durchgangs wählen.</translation>
    </message>
    <message>
      <source>The front side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Vorderseite fehlt; ihre Fotos in den Ordner '%1' legen.</translation>
    </message>
    <message>
      <source>The back side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Rückseite fehlt; ihre Fotos in den Ordner '%1' legen.</translation>
    </message>
    <message>
      <source>Not a batch folder: it has neither the folders &apos;front&apos; and &apos;back&apos; nor &apos;top_images&apos; and &apos;bottom_images&apos;; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist kein Ordner eines Durchgangs: Es fehlen die Ordner 'front' und 'back' (oder 'top_images' und 'bottom_images'); den Ordner eines Durchgangs wählen.</translation>
    </message>
    <message>
      <source>The file name does not match the form %1; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Dateiname hat nicht die Form %1; dieses Foto wird ausgelassen.</translation>
    </message>
    <message>
      <source>Another photograph has the same camera and position; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Foto hat dieselbe Kamera und dieselbe Position; dieses wird ausgelassen.</translation>
    </message>
    <message>
      <source>This photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Foto wird ausgelassen.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1 and %2 more. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es fehlen Fotos: %1 und %2 weitere. Flächen, die nur sie zeigen, werden ergänzt; wenn es darauf ankommt, noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es fehlen Fotos: %1. Flächen, die nur sie zeigen, werden ergänzt; wenn es darauf ankommt, noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>This file name follows the naming of rig photographs, but most others do not; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Dateiname ist wie der eines Fotos vom Messplatz gebildet, die meisten anderen sind es nicht; dieses Foto wird ausgelassen.</translation>
    </message>
    <message>
      <source>Another photograph has the same name; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Foto hat denselben Namen; dieses wird ausgelassen.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2 and %3 more); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos mit weniger als %1 Megapixeln werden ausgelassen (%2 und %3 weitere); statt der Vorschaubilder die Originale von der Kamera kopieren.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos mit weniger als %1 Megapixeln werden ausgelassen (%2); statt der Vorschaubilder die Originale von der Kamera kopieren.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs are used: the most detailed ones, spread over the series. More would take longer and add little.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 der %2 Fotos werden verwendet: die schärfsten, über die Reihe verteilt. Mehr dauern länger und bringen wenig.</translation>
    </message>
    <message>
      <source>This folder contains no photographs; put the photographs of one side into it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ordner sind keine Fotos; die Fotos einer Seite dorthin legen.</translation>
    </message>
    <message>
      <source>This folder contains neither photographs nor the folders &apos;front&apos; and &apos;back&apos; of a batch; choose a folder with photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ordner sind weder Fotos noch die Ordner „front“ und „back“ eines Durchgangs; einen Ordner mit Fotos wählen.</translation>
    </message>
    <message>
      <source>There is no such folder; choose one with the photographs of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diesen Ordner gibt es nicht; einen mit den Fotos einer Seite wählen.</translation>
    </message>
    <message>
      <source>The same folder is given for the front and the back; choose the folder of each side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Derselbe Ordner wurde für Vorder- und Rückseite genannt; den Ordner jeder Seite wählen.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbare Fotos der Vorderseite: %1; mindestens %2 sind nötig. Weitere aus allen Richtungen aufnehmen.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbare Fotos der Rückseite: %1; mindestens %2 sind nötig. Weitere aus allen Richtungen aufnehmen.</translation>
    </message>
    <message>
      <source>The HEIC image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das HEIC-Bild ist beschädigt; noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The RAW image is damaged, or its camera is not supported; copy it again, or export it as TIFF.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das RAW-Bild ist beschädigt, oder seine Kamera wird nicht unterstützt; noch einmal kopieren oder als TIFF exportieren.</translation>
    </message>
    <message>
      <source>The side of a marker must be between 0.5 and 1000 mm; measure a black square on the paper.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Seite einer Marke muss zwischen 0,5 und 1000 mm liegen; ein schwarzes Quadrat auf dem Papier messen.</translation>
    </message>
    <message>
      <source>No sheet with at least %1 markers of OpenCV&apos;s dictionaries was found in these %2 photographs; take photographs that show more of the sheet, or specify its plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesen %2 Fotos wurde kein Bogen mit mindestens %1 Marken aus OpenCVs Wörterbüchern gefunden; Fotos aufnehmen, die mehr vom Bogen zeigen, oder seine plate.json nennen.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in the photographs (%4 px) and are used instead. Measure the distance between two markers that are far apart and compare it with plate.json in the output folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine plate.json beschreibt den Bogen: %1 Marken aus %2 mit Seiten von %3 mm wurden in den Fotos gefunden (%4 px) und dafür genommen. Den Abstand zweier weit auseinanderliegender Marken messen und mit plate.json im Ausgabeordner vergleichen.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 were found in the photographs (%3 px), but their size is unknown, so the result has no scale. Measure the side of a marker&apos;s black square and give it with --marker-mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine plate.json beschreibt den Bogen: %1 Marken aus %2 wurden in den Fotos gefunden (%3 px), ihre Größe ist nicht bekannt, daher hat das Ergebnis keinen Maßstab. Die Seite des schwarzen Quadrats einer Marke messen und mit --marker-mm angeben.</translation>
    </message>
    <message>
      <source>This mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Maske wird nicht verwendet.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size; the mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Maske hat eine andere Größe als ihr Foto; sie wird nicht verwendet.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbare Fotos der Vorderseite: %1; mindestens %2 sind nötig. Fotos hinzufügen, die %3 heißen.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbare Fotos der Rückseite: %1; mindestens %2 sind nötig. Fotos hinzufügen, die %3 heißen.</translation>
    </message>
    <message>
      <source>The file name is neither cam&lt;C&gt;_cal&lt;NN&gt;.jpg nor empty_cam&lt;C&gt;.jpg; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Name ist weder cam&lt;C&gt;_cal&lt;NN&gt;.jpg noch empty_cam&lt;C&gt;.jpg; dieses Bild wird ausgelassen.</translation>
    </message>
    <message>
      <source>This picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Bild wird ausgelassen.</translation>
    </message>
    <message>
      <source>The image has %1 x %2 pixels, but the photographs from its camera have %3 x %4; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Bild hat %1 x %2 Pixel, die Fotos seiner Kamera haben %3 x %4; dieses Bild wird ausgelassen.</translation>
    </message>
    <message>
      <source>The image header states a size of %1 x %2 pixels, which cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Bild nennt eine Größe von %1 x %2 Pixeln, die sich nicht verwenden lässt.</translation>
    </message>
    <message>
      <source>The network&apos;s file is damaged; copy it again, or export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei des Netzes ist beschädigt; noch einmal kopieren oder exportieren.</translation>
    </message>
    <message>
      <source>A layer of the network has &apos;%1&apos; %2, but only %3 to %4 can be used; use another network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Schicht des Netzes hat „%1“ %2, aber nur %3 bis %4 sind verwendbar; ein anderes Netz verwenden.</translation>
    </message>
    <message>
      <source>The network&apos;s weights are in another file; export it as one file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Gewichte des Netzes stehen in einer anderen Datei; als eine Datei exportieren.</translation>
    </message>
    <message>
      <source>The network takes %1 GB of memory for one photograph, but at most %2 GB can be used; use a smaller network, or one with a smaller input.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Netz braucht %1 GB Speicher für ein Foto, aber höchstens %2 GB sind verwendbar; ein kleineres Netz oder eines mit kleinerer Eingabe verwenden.</translation>
    </message>
    <message>
      <source>The JPEG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das JPEG-Bild ist beschädigt; noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The JPEG file contains no image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die JPEG-Datei enthält kein Bild.</translation>
    </message>
    <message>
      <source>The PNG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das PNG-Bild ist beschädigt; noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The TIFF file does not state the image&apos;s size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die TIFF-Datei nennt keine Bildgröße.</translation>
    </message>
    <message>
      <source>The file is empty; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei ist leer; noch einmal von der Kamera kopieren.</translation>
    </message>
    <message>
      <source>Not a JPEG, PNG, TIFF, HEIC or RAW image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist kein Bild in JPEG, PNG, TIFF, HEIC oder RAW.</translation>
    </message>
    <message>
      <source>The known lengths cannot be used: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die bekannten Längen lassen sich nicht verwenden: %1.</translation>
    </message>
    <message>
      <source>'side' must be 'front' or 'back'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'side' muss 'front' oder 'back' sein</translation>
    </message>
    <message>
      <source>'ends' must be two lists of marks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'ends' müssen zwei Listen von Markierungen sein</translation>
    </message>
    <message>
      <source>each end must be marked on at least two photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>jedes Ende muss auf mindestens zwei Fotos markiert sein</translation>
    </message>
    <message>
      <source>their unit must be mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ihre Einheit muss mm sein</translation>
    </message>
    <message>
      <source>each needs 'side', 'length' and 'ends' with 'file' and 'pixel'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>jede braucht 'side', 'length' und 'ends' mit 'file' und 'pixel'</translation>
    </message>
    <message>
      <source>The image cannot be decoded; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Bild lässt sich nicht entschlüsseln; noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The plate&apos;s unit must be mm; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Einheit der Platte muss mm sein; die Plattendatei neu erzeugen.</translation>
    </message>
    <message>
      <source>The plate file lists more than 1024 markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Plattendatei nennt mehr als 1024 Marken.</translation>
    </message>
    <message>
      <source>The plate file needs &apos;dictionary&apos; and &apos;markers&apos;, each with an id and four corners of three numbers; &apos;diameter&apos;, if given, is a number in mm, &apos;sheet&apos; the paper&apos;s width and height.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Plattendatei braucht 'dictionary' und 'markers' mit einer id und vier Ecken zu je drei Zahlen; 'diameter' ist, wenn angegeben, eine Zahl in mm, 'sheet' Breite und Höhe des Papiers.</translation>
    </message>
    <message>
      <source>The plate file lists no markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Plattendatei nennt keine Marke.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate has no valid corners.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marke %1 der Platte hat keine gültigen Ecken.</translation>
    </message>
    <message>
      <source>Marker %1 occurs twice on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marke %1 steht zweimal auf der Platte.</translation>
    </message>
    <message>
      <source>The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and 'marker_mm'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tafel braucht 'dictionary', 'squares_x', 'squares_y', 'square_mm' und 'marker_mm'.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another batch name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Datei dieses Namens gibt es schon, sie wird nicht überschrieben; einen anderen Durchgangsnamen wählen.</translation>
    </message>
    <message>
      <source>This batch started on another plate; continue with that plate or start a new batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang wurde auf einer anderen Platte begonnen; mit jener Platte weitermachen oder einen neuen Durchgang beginnen.</translation>
    </message>
    <message>
      <source>This batch started with another setup (cameras: %1, positions: %2; now: %3 and %4); choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang begann mit einem anderen Aufbau (Kameras: %1, Positionen: %2; jetzt: %3 und %4); einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>The photograph has changed since it was taken; restore the original or choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Foto wurde seit der Aufnahme verändert; das Original zurücklegen oder einen anderen Ordner für den Durchgang wählen.</translation>
    </message>
    <message>
      <source>This photograph does not belong to this batch; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Foto gehört nicht zu diesem Durchgang; einen anderen Ordner für den Durchgang wählen.</translation>
    </message>
    <message>
      <source>Camera %1 delivers raw files only; set its image format to JPEG, or to both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 liefert nur Rohdateien; ihr Bildformat auf JPEG oder auf beides stellen.</translation>
    </message>
    <message>
      <source>%1 is %2, but the rig specifies %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist %2, der Messplatz gibt %3 vor</translation>
    </message>
    <message>
      <source>%1 is %2, but the first photograph used %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist %2, beim ersten Foto war es %3</translation>
    </message>
    <message>
      <source>The turntable did not reach its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch hat seine Nullstellung nicht erreicht.</translation>
    </message>
    <message>
      <source>The turntable does not report its position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch meldet seine Position nicht.</translation>
    </message>
    <message>
      <source>The turntable rejected a command (error %1): wrong turntable type or bad cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch hat einen Befehl abgelehnt (Fehler %1): falsche Art von Drehtisch oder schlechtes Kabel.</translation>
    </message>
    <message>
      <source>The turntable&apos;s speed must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Geschwindigkeit des Drehtisches muss größer als 0 sein.</translation>
    </message>
    <message>
      <source>The connection to the turntable failed (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Verbindung zum Drehtisch ist ausgefallen (%1).</translation>
    </message>
    <message>
      <source>it is not open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ist nicht offen</translation>
    </message>
    <message>
      <source>it accepts no more data</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nimmt keine Daten mehr an</translation>
    </message>
    <message>
      <source>it was closed at the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>wurde am anderen Ende geschlossen</translation>
    </message>
    <message>
      <source>You have no permission to use this serial port; install Ostraka&apos;s udev rules or join the group dialout, then log in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser serielle Anschluss darf nicht benutzt werden; die udev-Regeln von Ostraka installieren oder der Gruppe dialout beitreten und neu anmelden.</translation>
    </message>
    <message>
      <source>The serial port does not exist; check that the turntable is plugged in and switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den seriellen Anschluss gibt es nicht; prüfen, ob der Drehtisch angeschlossen und eingeschaltet ist.</translation>
    </message>
    <message>
      <source>Not a serial port.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist kein serieller Anschluss.</translation>
    </message>
    <message>
      <source>The serial port does not accept its settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der serielle Anschluss nimmt seine Einstellungen nicht an.</translation>
    </message>
    <message>
      <source>The turntable&apos;s address is unknown on this network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Adresse des Drehtisches ist in diesem Netz unbekannt.</translation>
    </message>
    <message>
      <source>A serial port does not support %1 baud; common rates are 9600 and 115200.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein serieller Anschluss unterstützt %1 Baud nicht; üblich sind 9600 und 115200.</translation>
    </message>
    <message>
      <source>A network address looks like 192.168.0.7:23.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Netzadresse sieht aus wie 192.168.0.7:23.</translation>
    </message>
    <message>
      <source>The desktop does not release the camera: it is still in use by %1; close its file window and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Arbeitsfläche gibt die Kamera nicht frei: %1 hält sie noch fest; ihr Dateifenster schließen und noch einmal versuchen.</translation>
    </message>
    <message>
      <source>A watched folder has no setting %1; set it on the camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein überwachter Ordner hat keine Einstellung %1; an der Kamera einstellen.</translation>
    </message>
    <message>
      <source>A watched folder has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein überwachter Ordner zeigt kein Livebild.</translation>
    </message>
    <message>
      <source>No new photograph arrived within %1 seconds; check that the camera&apos;s software writes into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In %1 Sekunden kam kein neues Foto; prüfen, ob das Programm der Kamera in diesen Ordner schreibt.</translation>
    </message>
    <message>
      <source>The watched folder cannot be read (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der überwachte Ordner lässt sich nicht lesen (%1).</translation>
    </message>
    <message>
      <source>Two photographs arrived for one shot, %1 and %2; use one folder per camera and one photograph per position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für eine Aufnahme kamen zwei Fotos, %1 und %2; einen Ordner je Kamera und ein Foto je Position verwenden.</translation>
    </message>
    <message>
      <source>The camera with this serial number is not plugged in; found: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera mit dieser Seriennummer ist nicht angeschlossen; da ist: %1.</translation>
    </message>
    <message>
      <source>The camera does not offer %1 for %2; it is set to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera bietet %1 für %2 nicht an; sie steht auf %3.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3; check its mode dial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera lässt %1 auf %2 statt auf %3; ihr Moduswahlrad prüfen.</translation>
    </message>
    <message>
      <source>The camera has no setting %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera hat keine Einstellung %1.</translation>
    </message>
    <message>
      <source>The camera reports: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera meldet: %1.</translation>
    </message>
    <message>
      <source>The turntable has no zero switch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch hat keinen Nullschalter.</translation>
    </message>
    <message>
      <source>It did not answer while homing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Er hat beim Nullen nicht geantwortet.</translation>
    </message>
    <message>
      <source>It did not unlock.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Er hat sich nicht entsperrt.</translation>
    </message>
    <message>
      <source>It did not answer the shutter command.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Er hat auf den Auslösebefehl nicht geantwortet.</translation>
    </message>
    <message>
      <source>The turntable does not answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht.</translation>
    </message>
    <message>
      <source>The turntable does not stop moving.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch kommt nicht zur Ruhe.</translation>
    </message>
    <message>
      <source>The turntable does not accept its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch nimmt seinen Nullpunkt nicht an.</translation>
    </message>
    <message>
      <source>The controller reset its count; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Steuerung hat ihre Zählung zurückgesetzt; die Position des Drehtisches ist unbekannt.</translation>
    </message>
    <message>
      <source>The turntable does not move.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch bewegt sich nicht.</translation>
    </message>
    <message>
      <source>The turntable did not arrive in time; it was stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch kam nicht rechtzeitig an; er wurde angehalten.</translation>
    </message>
    <message>
      <source>The shutter output must be M8, M7, M3 or M62 Pn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Auslöserausgang muss M8, M7, M3 oder M62 Pn sein.</translation>
    </message>
    <message>
      <source>The turntable was stopped while moving and lost its position: align the zero mark (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch wurde in der Bewegung angehalten, seine Position ist verloren: die Nullmarke ausrichten (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller reports a turn beyond its travel: switch $20 off (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Steuerung des Drehtisches meldet eine Drehung über seinen Weg hinaus: $20 ausschalten (ALARM:%1).</translation>
    </message>
    <message>
      <source>Homing failed: check the zero switch and its cable (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Nullen ist misslungen: den Nullschalter und sein Kabel prüfen (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller raised an alarm (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Steuerung des Drehtisches meldet einen Alarm (ALARM:%1).</translation>
    </message>
    <message>
      <source>The controller does not understand the command: wrong controller type or bad cable (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Steuerung versteht den Befehl nicht: falsche Art von Steuerung oder schlechtes Kabel (error:%1).</translation>
    </message>
    <message>
      <source>The turntable has no zero switch (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch hat keinen Nullschalter (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is still moving (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch bewegt sich noch (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is locked: home it or unlock it (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch ist gesperrt: nullen oder entsperren (error:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller rejected a command (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Steuerung des Drehtisches hat einen Befehl abgelehnt (error:%1).</translation>
    </message>
    <message>
      <source>Turn the turntable counter-clockwise to %1 degrees, then take your hand away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Drehtisch gegen den Uhrzeigersinn auf %1 Grad drehen und die Hand wegnehmen.</translation>
    </message>
    <message>
      <source>Not an Ostraka photograph list; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine Fotoliste von Ostraka; einen anderen Ordner für den Durchgang wählen.</translation>
    </message>
    <message>
      <source>The turntable driver %1 is unknown; available: grbl, comxim1, comxim2, text, hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Treiber %1 des Drehtisches ist unbekannt; es gibt: grbl, comxim1, comxim2, text, hand.</translation>
    </message>
    <message>
      <source>The camera driver %1 is unknown; available: folder, gphoto2, uvc.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Kameratreiber %1 ist unbekannt; es gibt: folder, gphoto2, uvc.</translation>
    </message>
    <message>
      <source>The rig names no devices; &apos;ostraka devices&apos; lists what is plugged in and how to enter it in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz nennt keine Geräte; 'ostraka devices' sagt, was angeschlossen ist und wie es im Messplatz einzutragen ist.</translation>
    </message>
    <message>
      <source>The rig names no camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz nennt keine Kamera.</translation>
    </message>
    <message>
      <source>settle_s and speed_deg_s must be positive.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>settle_s und speed_deg_s müssen positiv sein.</translation>
    </message>
    <message>
      <source>The section &apos;devices&apos; cannot be read; compare it with docs/devices.md.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Teil 'devices' lässt sich nicht lesen; mit docs/devices.md vergleichen.</translation>
    </message>
    <message>
      <source>The number of positions must be between 3 and 99.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zahl der Positionen muss zwischen 3 und 99 liegen.</translation>
    </message>
    <message>
      <source>The rig has no camera or no turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz hat keine Kamera oder keinen Drehtisch.</translation>
    </message>
    <message>
      <source>There is no shot %1 to retake: this side has positions 1 to %2 and cameras A to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Aufnahme %1 zum Wiederholen gibt es nicht: Diese Seite hat die Positionen 1 bis %2 und die Kameras A bis %3.</translation>
    </message>
    <message>
      <source>Camera %1 of this batch was %2, but the connected one is %3; continue with the original cameras or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 dieses Durchgangs war %2, angeschlossen ist %3; mit den ursprünglichen Kameras weitermachen oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: turn its zero mark to the front and set zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Position des Drehtisches ist unbekannt: seine Nullmarke nach vorn drehen und den Nullpunkt setzen.</translation>
    </message>
    <message>
      <source>Camera %1, position %2 failed %3 times: %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, Position %2 misslang %3-mal: %4.</translation>
    </message>
    <message>
      <source>Camera %1 delivers only earlier or broken photographs; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 liefert nur frühere oder beschädigte Fotos; aus- und wieder einschalten.</translation>
    </message>
    <message>
      <source>The turntable does not answer as a %1; check its type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch antwortet nicht als %1; seine Art prüfen.</translation>
    </message>
    <message>
      <source>Marlin controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marlin-Steuerung</translation>
    </message>
    <message>
      <source>text controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Text-Steuerung</translation>
    </message>
    <message>
      <source>This turntable has no zero switch: align it by eye.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Drehtisch hat keinen Nullschalter: nach Augenmaß ausrichten.</translation>
    </message>
    <message>
      <source>The turntable rejects the command: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch lehnt den Befehl ab: %1.</translation>
    </message>
    <message>
      <source>The turntable is at %1 degrees instead of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch steht auf %1 Grad statt auf %2.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;move&apos; must contain {target} or {by}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Dialekt des Drehtisches: 'move' muss {target} oder {by} enthalten.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;accepted&apos; must describe its answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Dialekt des Drehtisches: 'accepted' muss seine Antwort beschreiben.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;query&apos; and &apos;position&apos; must be given together.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Dialekt des Drehtisches: 'query' und 'position' müssen zusammen angegeben werden.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;reply_s&apos; must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Dialekt des Drehtisches: 'reply_s' muss größer als 0 sein.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;%1&apos; is not a regular expression.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Dialekt des Drehtisches: '%1' ist kein regulärer Ausdruck.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;position&apos; needs a group for the angle.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Dialekt des Drehtisches: 'position' braucht eine Gruppe für den Winkel.</translation>
    </message>
    <message>
      <source>The turntable&apos;s &apos;dialect&apos; must be &quot;marlin&quot; or an object with its commands.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'dialect' des Drehtisches muss &quot;marlin&quot; sein oder ein Objekt mit seinen Befehlen.</translation>
    </message>
    <message>
      <source>The turntable is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch ist nicht angeschlossen.</translation>
    </message>
    <message>
      <source>The turntable&apos;s USB connection failed (%1); plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die USB-Verbindung des Drehtisches ist ausgefallen (%1); noch einmal einstecken.</translation>
    </message>
    <message>
      <source>You have no permission to use this USB device; install packaging/udev/70-ostraka.rules and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses USB-Gerät darf nicht benutzt werden; packaging/udev/70-ostraka.rules installieren und noch einmal einstecken.</translation>
    </message>
    <message>
      <source>Another program uses the turntable; close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch wird von einem anderen Programm benutzt; es schließen.</translation>
    </message>
    <message>
      <source>The turntable cannot be opened (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch lässt sich nicht öffnen (%1).</translation>
    </message>
    <message>
      <source>This USB device is not a serial controller (CDC-ACM).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses USB-Gerät ist keine serielle Steuerung (CDC-ACM).</translation>
    </message>
    <message>
      <source>The turntable with this serial number is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Drehtisch mit dieser Seriennummer ist nicht angeschlossen.</translation>
    </message>
    <message>
      <source>A USB turntable is named by vendor and product, for example usb:1209:0001.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein USB-Drehtisch wird mit Hersteller und Produkt benannt, wie usb:1209:0001.</translation>
    </message>
    <message>
      <source>The video camera cannot be opened; check that it is plugged in and that no other program uses it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Videokamera lässt sich nicht öffnen; prüfen, ob sie angeschlossen ist und kein anderes Programm sie benutzt.</translation>
    </message>
    <message>
      <source>A video camera has exposure (0.1 ms), focus, white_balance (K) and gain, as numbers; not %1 %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Videokamera hat exposure (0,1 ms), focus, white_balance (K) und gain, als Zahlen; nicht %1 %2.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera lässt %1 auf %2 statt auf %3.</translation>
    </message>
    <message>
      <source>The video camera no longer delivers pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Videokamera liefert keine Bilder mehr.</translation>
    </message>
    <message>
      <source>The video camera took no picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Videokamera hat kein Bild aufgenommen.</translation>
    </message>
    <message>
      <source>The video camera delivers pictures of %1x%2 pixels instead of the configured size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Videokamera liefert Bilder von %1x%2 Pixeln, nicht von der eingestellten Größe.</translation>
    </message>
    <message>
      <source>Another program is writing decisions or masks of this batch, so nothing was saved; try again in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Programm schreibt gerade Entscheidungen oder Masken dieses Durchgangs, daher wurde nichts gespeichert; gleich noch einmal versuchen.</translation>
    </message>
    <message>
      <source>The part of Ostraka that video cameras need cannot be loaded; install Ostraka again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Teil von Ostraka, den Videokameras brauchen, lässt sich nicht laden; Ostraka neu installieren.</translation>
    </message>
    <message>
      <source>The video camera must be named.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Videokamera muss benannt sein.</translation>
    </message>
    <message>
      <source>the file is truncated or not a picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Datei ist abgeschnitten oder kein Bild</translation>
    </message>
    <message>
      <source>the markers show an angle other than this position&apos;s</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Marken zeigen einen anderen Winkel als den dieser Position</translation>
    </message>
    <message>
      <source>the picture&apos;s size differs from that of the camera&apos;s other pictures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>das Bild hat eine andere Größe als die übrigen dieser Kamera</translation>
    </message>
    <message>
      <source>too few markers are visible to identify the position: check that nothing covers them and that the picture is sharp</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>zu wenige Marken sind zu sehen, um die Position zu erkennen: prüfen, ob etwas davor liegt und ob das Bild scharf ist</translation>
    </message>
    <message>
      <source>the camera delivered an earlier photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Kamera hat ein früheres Foto noch einmal geliefert</translation>
    </message>
    <message>
      <source>too few markers of the plate are visible: check that nothing covers them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>zu wenige Marken der Platte sind zu sehen: prüfen, ob etwas davor liegt</translation>
    </message>
    <message>
      <source>the picture is blurred: check that the turntable is still and the focus is unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>das Bild ist unscharf: prüfen, ob der Drehtisch stillsteht und der Fokus unverändert ist</translation>
    </message>
    <message>
      <source>the sherds are too dark: add light or increase the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Scherben sind zu dunkel: mehr Licht geben oder länger belichten</translation>
    </message>
    <message>
      <source>the sherds are overexposed: reduce the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Scherben sind überbelichtet: kürzer belichten</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>der Bildrand schneidet eine Scherbe ab: sie oder die Kamera verschieben</translation>
    </message>
    <message>
      <source>the camera&apos;s settings have changed: restore them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Einstellungen der Kamera haben sich geändert: zurückstellen</translation>
    </message>
    <message>
      <source>%1: restore it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: zurückstellen</translation>
    </message>
    <message>
      <source>A plate holds 1 to 60 sherds; 0 means not counted.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf eine Platte passen 1 bis 60 Scherben; 0 heißt nicht gezählt.</translation>
    </message>
    <message>
      <source>The number of a batch is also the name of its folder; use letters and digits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer eines Durchgangs ist auch der Name seines Ordners; Buchstaben und Ziffern verwenden.</translation>
    </message>
    <message>
      <source>The uuid of a batch is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die uuid eines Durchgangs ist falsch geschrieben.</translation>
    </message>
    <message>
      <source>The batch %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Durchgang %1 gibt es schon.</translation>
    </message>
    <message>
      <source>This batch is not in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang ist nicht im Katalog.</translation>
    </message>
    <message>
      <source>The project&apos;s code must be 2 to 8 letters from A to Z or digits, for example ARM.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel des Projekts muss aus 2 bis 8 Großbuchstaben von A bis Z oder Ziffern bestehen, wie ARM.</translation>
    </message>
    <message>
      <source>A vocabulary term must contain letters and no &apos;;&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Begriff einer Wortliste muss Buchstaben haben und kein ';'.</translation>
    </message>
    <message>
      <source>The term &apos;%1&apos; appears twice in the vocabulary.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Begriff '%1' steht zweimal in der Wortliste.</translation>
    </message>
    <message>
      <source>Sherds with the term '%1': %2; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben mit dem Begriff „%1“: %2; zuerst diese ändern.</translation>
    </message>
    <message>
      <source>a row of %1 refers to a missing row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eine Zeile von %1 verweist auf eine fehlende Zeile</translation>
    </message>
    <message>
      <source>the sherd tables are inconsistent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Tabellen der Scherben widersprechen sich</translation>
    </message>
    <message>
      <source>the search index is incomplete</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>das Suchverzeichnis ist unvollständig</translation>
    </message>
    <message>
      <source>The backup does not contain the saved data; try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Sicherung enthält nicht, was gespeichert wurde; noch einmal versuchen.</translation>
    </message>
    <message>
      <source>The catalogue cannot be opened; check that the folder exists and is writable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Katalog lässt sich nicht öffnen; prüfen, ob der Ordner da ist und beschrieben werden darf.</translation>
    </message>
    <message>
      <source>The catalogue cannot be written to; check the permissions of the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In den Katalog lässt sich nicht schreiben; die Zugriffsrechte des Ordners prüfen.</translation>
    </message>
    <message>
      <source>The disk reports errors; check it, then reopen the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger meldet Fehler; ihn prüfen, dann das Projekt neu öffnen.</translation>
    </message>
    <message>
      <source>The catalogue rejects this operation (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Katalog lehnt diesen Vorgang ab (%1).</translation>
    </message>
    <message>
      <source>The scan is not a front of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan ist keine Vorderseite dieses Durchgangs.</translation>
    </message>
    <message>
      <source>The scan is not a back of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan ist keine Rückseite dieses Durchgangs.</translation>
    </message>
    <message>
      <source>A pair needs a front and a back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Paar hat eine Vorderseite und eine Rückseite.</translation>
    </message>
    <message>
      <source>The decision to undo is not in this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die zurückzunehmende Entscheidung gehört nicht zu diesem Durchgang.</translation>
    </message>
    <message>
      <source>A decision needs a front, a back or both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Entscheidung nennt eine Vorderseite, eine Rückseite oder beide.</translation>
    </message>
    <message>
      <source>The uuid of a decision is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die uuid einer Entscheidung ist falsch geschrieben.</translation>
    </message>
    <message>
      <source>This file is outside the project&apos;s folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei liegt nicht im Ordner des Projekts.</translation>
    </message>
    <message>
      <source>This is a draft from reduced photographs; reprocess the batch for final measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist ein Entwurf aus verkleinerten Fotos; den Durchgang für endgültige Maße neu verarbeiten.</translation>
    </message>
    <message>
      <source>These results of &apos;ostraka process&apos; are incomplete; run it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ergebnisse von 'ostraka process' sind unvollständig; es noch einmal laufen lassen.</translation>
    </message>
    <message>
      <source>Another program is entering results of this batch; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderes Programm trägt gerade Ergebnisse dieses Durchgangs ein; dieses wartet, bis es fertig ist.</translation>
    </message>
    <message>
      <source>The pair table names the scan %1, which is missing; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tabelle der Paare nennt den Scan %1, den es nicht gibt; 'ostraka process' noch einmal laufen lassen.</translation>
    </message>
    <message>
      <source>This batch is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This photograph is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Foto ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This scan is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Scan ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This file is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This person is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Person ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This site is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Fundort ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This trench is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Schnitt ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This context is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Befund ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>This bag is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Beutel ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>The filter has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Filter öffnet ein Anführungszeichen und schließt es nicht.</translation>
    </message>
    <message>
      <source>This is only part of a sherd&apos;s label; scan its code again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist nur ein Teil eines Scherbenetiketts; seinen Code noch einmal lesen.</translation>
    </message>
    <message>
      <source>The filter is not valid text.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Filter ist kein gültiger Text.</translation>
    </message>
    <message>
      <source>There is no field '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Feld '%1' gibt es nicht.</translation>
    </message>
    <message>
      <source>Some of the changes remain because they could not be undone: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einige der Änderungen bleiben, denn sie ließen sich nicht zurücknehmen: %1</translation>
    </message>
    <message>
      <source>There is no measurement of this kind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Maß dieser Art gibt es nicht.</translation>
    </message>
    <message>
      <source>A measurement cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Maß kann nicht kleiner als 0 sein.</translation>
    </message>
    <message>
      <source>A newer Ostraka made this project (catalogue version %1, this program supports %2). Nothing was changed. Install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein neueres Ostraka hat dieses Projekt angelegt (Katalogversion %1, dieses Programm unterstützt %2). Nichts wurde geändert. Die neuere Version installieren.</translation>
    </message>
    <message>
      <source>The numbering cannot contain the character &apos;%1&apos;; letters, digits, &apos;.&apos;, &apos;_&apos;, &apos;/&apos; and &apos;-&apos; are allowed between the tokens.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummerierung kann das Zeichen '%1' nicht enthalten; zwischen den Platzhaltern sind Buchstaben, Ziffern, '.', '_', '/' und '-' erlaubt.</translation>
    </message>
    <message>
      <source>The numbering opens a token with { and does not close it with }.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummerierung öffnet einen Platzhalter mit { und schließt ihn nicht mit }.</translation>
    </message>
    <message>
      <source>The numbering has no token {%1}; available: site, trench, context, bag, batch, yyyy, yy and n.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummerierung kennt keinen Platzhalter {%1}; es gibt site, trench, context, bag, batch, yyyy, yy und n.</translation>
    </message>
    <message>
      <source>The width of {%1} must be written as :04, with 12 digits at most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Breite von {%1} muss wie :04 geschrieben sein, mit höchstens 12 Stellen.</translation>
    </message>
    <message>
      <source>Two tokens are adjacent; put &apos;-&apos; or another character between {%1} and {%2}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Platzhalter stoßen aneinander; ein '-' oder ein anderes Zeichen zwischen {%1} und {%2} setzen.</translation>
    </message>
    <message>
      <source>The numbering must count the sherds with {n} exactly once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummerierung muss die Scherben mit {n} genau einmal zählen.</translation>
    </message>
    <message>
      <source>The number needs the site of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer braucht den Fundort der Scherbe, der nicht eingetragen ist.</translation>
    </message>
    <message>
      <source>The number needs the context of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer braucht den Befund der Scherbe, der nicht eingetragen ist.</translation>
    </message>
    <message>
      <source>The number needs the bag of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer braucht den Beutel der Scherbe, der nicht eingetragen ist.</translation>
    </message>
    <message>
      <source>The number needs the batch of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer braucht den Durchgang der Scherbe, der nicht eingetragen ist.</translation>
    </message>
    <message>
      <source>The site %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Fundort %1 enthält das Zeichen '%2', das in der Nummer neben ihm steht.</translation>
    </message>
    <message>
      <source>The trench %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Schnitt %1 enthält das Zeichen '%2', das in der Nummer neben ihm steht.</translation>
    </message>
    <message>
      <source>The context %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Befund %1 enthält das Zeichen '%2', das in der Nummer neben ihm steht.</translation>
    </message>
    <message>
      <source>The bag %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Beutel %1 enthält das Zeichen '%2', das in der Nummer neben ihm steht.</translation>
    </message>
    <message>
      <source>The batch %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Durchgang %1 enthält das Zeichen '%2', das in der Nummer neben ihm steht.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before; numbers are never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 wurde schon einmal vergeben; Nummern werden nie wieder verwendet.</translation>
    </message>
    <message>
      <source>The block of numbers up to %1 is used up; assign this computer a new block in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Nummernblock bis %1 ist verbraucht; diesem Rechner in den Einstellungen einen neuen geben.</translation>
    </message>
    <message>
      <source>A decision needs the name of the person who makes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Entscheidung braucht den Namen der Person, die sie trifft.</translation>
    </message>
    <message>
      <source>A merge needs two or more fragments.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zum Zusammenführen sind zwei oder mehr Fragmente nötig.</translation>
    </message>
    <message>
      <source>A split needs exactly one fragment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geteilt wird genau ein Fragment.</translation>
    </message>
    <message>
      <source>The name of a person must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Name einer Person darf nicht leer sein.</translation>
    </message>
    <message>
      <source>The person's initials must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel der Person darf nicht leer sein.</translation>
    </message>
    <message>
      <source>The code of a site must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel eines Fundorts darf nicht leer sein.</translation>
    </message>
    <message>
      <source>The code of a trench must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel eines Schnitts darf nicht leer sein.</translation>
    </message>
    <message>
      <source>The number of a context must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer eines Befunds darf nicht leer sein.</translation>
    </message>
    <message>
      <source>The number of a bag must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer eines Beutels darf nicht leer sein.</translation>
    </message>
    <message>
      <source>The name of a person must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Name einer Person ist zu lang; höchstens 200 Zeichen.</translation>
    </message>
    <message>
      <source>The person&apos;s initials must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel der Person ist zu lang; höchstens 200 Zeichen.</translation>
    </message>
    <message>
      <source>The code of a site must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel eines Fundorts ist zu lang; höchstens 200 Zeichen.</translation>
    </message>
    <message>
      <source>The code of a trench must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel eines Schnitts ist zu lang; höchstens 200 Zeichen.</translation>
    </message>
    <message>
      <source>The number of a context must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer eines Befunds ist zu lang; höchstens 200 Zeichen.</translation>
    </message>
    <message>
      <source>The number of a bag must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer eines Beutels ist zu lang; höchstens 200 Zeichen.</translation>
    </message>
    <message>
      <source>The uuid is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die uuid ist falsch geschrieben.</translation>
    </message>
    <message>
      <source>The initials %1 already belong to another person.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Kürzel %1 gehört schon einer anderen Person.</translation>
    </message>
    <message>
      <source>The latitude must be between -90 and 90 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die geografische Breite muss zwischen -90 und 90 Grad liegen.</translation>
    </message>
    <message>
      <source>The longitude must be between -180 and 180 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die geografische Länge muss zwischen -180 und 180 Grad liegen.</translation>
    </message>
    <message>
      <source>The site %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Fundort %1 gibt es schon.</translation>
    </message>
    <message>
      <source>A trench needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Schnitt braucht einen Fundort.</translation>
    </message>
    <message>
      <source>A trench cannot contain itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Schnitt kann nicht in sich selbst liegen.</translation>
    </message>
    <message>
      <source>The trench %1 already exists in this site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Schnitt %1 gibt es in diesem Fundort schon.</translation>
    </message>
    <message>
      <source>A context needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Befund braucht einen Fundort.</translation>
    </message>
    <message>
      <source>The trench and the context belong to different sites.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Schnitt und der Befund gehören zu verschiedenen Fundorten.</translation>
    </message>
    <message>
      <source>The context %1 already exists in this place.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Befund %1 gibt es an diesem Ort schon.</translation>
    </message>
    <message>
      <source>A bag needs a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Beutel braucht einen Befund.</translation>
    </message>
    <message>
      <source>The weight of a bag must be greater than 0 g.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Gewicht eines Beutels muss größer als 0 g sein.</translation>
    </message>
    <message>
      <source>A count cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Anzahl kann nicht kleiner als 0 sein.</translation>
    </message>
    <message>
      <source>The bag %1 already exists in this context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Beutel %1 gibt es in diesem Befund schon.</translation>
    </message>
    <message>
      <source>The folder is on a network share (%1), which can damage catalogues; use a folder on this computer&apos;s own disk and copy backups to the share.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ordner liegt auf einer Netzfreigabe (%1), was Kataloge beschädigen kann; einen Ordner auf dem eigenen Datenträger dieses Rechners nehmen und Sicherungen auf die Freigabe kopieren.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner ist kein Ostraka-Projekt: Er enthält kein catalogue.sqlite.</translation>
    </message>
    <message>
      <source>A new project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein neues Projekt braucht einen neuen oder leeren Ordner; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>The folder cannot be created; choose a location that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ordner lässt sich nicht anlegen; einen Ort wählen, an den geschrieben werden darf.</translation>
    </message>
    <message>
      <source>A uuid of the export is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine uuid des Exports ist falsch geschrieben.</translation>
    </message>
    <message>
      <source>The decision is saved with the batch, but %1 is not in the catalogue yet; it is added with the next results.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Entscheidung ist bei dem Durchgang gespeichert, aber %1 ist noch nicht im Katalog; sie wird mit den nächsten Ergebnissen eingetragen.</translation>
    </message>
    <message>
      <source>The field %1 is read-only: the program sets it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Feld %1 ist schreibgeschützt: Das Programm setzt es.</translation>
    </message>
    <message>
      <source>A void sherd keeps its number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine ungültige Scherbe behält ihre Nummer.</translation>
    </message>
    <message>
      <source>A number cannot contain a line break, a tab or &apos;%&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Nummer darf keinen Zeilenumbruch, keinen Tabulator und kein '%' enthalten.</translation>
    </message>
    <message>
      <source>A number or code cannot contain invisible characters; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Nummer oder ein Kürzel darf keine unsichtbaren Zeichen enthalten; noch einmal eingeben.</translation>
    </message>
    <message>
      <source>A number has at most 120 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Nummer hat höchstens 120 Zeichen.</translation>
    </message>
    <message>
      <source>The number %1 would be assigned twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 würde zweimal vergeben.</translation>
    </message>
    <message>
      <source>The files of %1 would have the same names as those of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Dateien von %1 hätten dieselben Namen wie die von %2.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 wurde schon einmal vergeben und wird nie wieder verwendet.</translation>
    </message>
    <message>
      <source>The number %1 belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 gehört einer anderen Scherbe.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0 after ±, or 0 if the uncertainty is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nach ± einen Wert größer als 0 eingeben, oder 0, wenn die Unsicherheit unbekannt ist.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Wert größer als 0 eingeben.</translation>
    </message>
    <message>
      <source>No sherd is larger than 1000 mm; check that the value is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Scherbe ist größer als 1000 mm; prüfen, ob der Wert in Millimetern ist.</translation>
    </message>
    <message>
      <source>No sherd is heavier than 20 kg; check that the value is in grams.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Scherbe ist schwerer als 20 kg; prüfen, ob der Wert in Gramm ist.</translation>
    </message>
    <message>
      <source>A share cannot exceed 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Anteil kann 100 % nicht überschreiten.</translation>
    </message>
    <message>
      <source>There is no sherd %1 to join.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe %1, an die sie passen könnte, gibt es nicht.</translation>
    </message>
    <message>
      <source>A sherd cannot join itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe passt nicht an sich selbst.</translation>
    </message>
    <message>
      <source>There is no context %1 in %2; add it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Befund %1 gibt es in %2 nicht; ihn zuerst anlegen.</translation>
    </message>
    <message>
      <source>A numbered sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine nummerierte Scherbe braucht ihren Befund.</translation>
    </message>
    <message>
      <source>A sherd needs its context before it gets a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe braucht ihren Befund, bevor sie eine Nummer bekommt.</translation>
    </message>
    <message>
      <source>The table cannot be sorted by &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tabelle lässt sich nicht nach '%1' ordnen.</translation>
    </message>
    <message>
      <source>A sherd is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe ist nicht mehr im Katalog.</translation>
    </message>
    <message>
      <source>The uuid of a sherd is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die uuid einer Scherbe ist falsch geschrieben.</translation>
    </message>
    <message>
      <source>A sherd with this uuid already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe mit dieser uuid gibt es schon.</translation>
    </message>
    <message>
      <source>A void sherd needs a reason; enter it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine ungültige Scherbe braucht einen Grund; ihn eingeben.</translation>
    </message>
    <message>
      <source>The number %1 appears on two sherds of this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 steht auf zwei Scherben dieser Platte.</translation>
    </message>
    <message>
      <source>The number %1 already belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 gehört schon einer anderen Scherbe.</translation>
    </message>
    <message>
      <source>The sherd of this label has no number yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherbe dieses Etiketts hat noch keine Nummer.</translation>
    </message>
    <message>
      <source>The text is longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Text ist länger als 1 MB.</translation>
    </message>
    <message>
      <source>The text is not valid UTF-8 or contains a zero byte.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Text ist kein gültiges UTF-8 oder enthält ein Nullbyte.</translation>
    </message>
    <message>
      <source>The text contains control characters, which documents cannot contain; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Text enthält Steuerzeichen, die Dokumente nicht enthalten können; ihn neu eingeben.</translation>
    </message>
    <message>
      <source>Write the day as 2026-07-14 (year-month-day).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Tag wie 2026-07-14 schreiben (Jahr-Monat-Tag).</translation>
    </message>
    <message>
      <source>Write the Munsell colour as 10YR 3/1 or N 4/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Munsell-Farbe wie 10YR 3/1 oder N 4/ schreiben.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a number; write 12.5 or 12,5, without a unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' ist keine Zahl; 12.5 oder 12,5 schreiben, ohne Einheit.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a path inside its folder; it must be relative, with &apos;/&apos; and without &apos;..&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' ist kein Pfad innerhalb seines Ordners; er muss relativ sein, mit '/' und ohne '..'.</translation>
    </message>
    <message>
      <source>Not a PLY file; choose one, or export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine PLY-Datei; eine wählen oder den Scan neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY header states no format; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der PLY-Kopf nennt kein Format; neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY header has an error in line %1: %2; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der PLY-Kopf hat einen Fehler in Zeile %1: %2; die Datei neu exportieren.</translation>
    </message>
    <message>
      <source>its format is unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sein Format ist unbekannt</translation>
    </message>
    <message>
      <source>a count is not a number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eine Anzahl ist keine Zahl</translation>
    </message>
    <message>
      <source>a property cannot be read</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eine Eigenschaft lässt sich nicht lesen</translation>
    </message>
    <message>
      <source>a property has an unknown type</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eine Eigenschaft hat einen unbekannten Typ</translation>
    </message>
    <message>
      <source>the length of a list is not a whole number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Länge einer Liste ist keine ganze Zahl</translation>
    </message>
    <message>
      <source>a line cannot be parsed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eine Zeile lässt sich nicht auswerten</translation>
    </message>
    <message>
      <source>The PLY header has no end; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der PLY-Kopf hat kein Ende; neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY header declares %1 of &apos;%2&apos;, more than the file contains; the file may be truncated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der PLY-Kopf nennt %1 '%2', mehr als die Datei enthält; sie ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
      <source>The PLY file has two lists of vertices; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei hat zwei Punktlisten; neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY vertices lack x, y or z; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den PLY-Punkten fehlt x, y oder z; neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY file ends early or contains a value that is not a number; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei endet zu früh oder enthält etwas, das keine Zahl ist; neu exportieren.</translation>
    </message>
    <message>
      <source>A face of the PLY file refers to a vertex that does not exist; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Fläche der PLY-Datei nennt einen Punkt, den es nicht gibt; neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY file ends within '%1'; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei endet mitten in '%1'; noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The PLY file has no vertices; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei hat keine Punkte; den Scan neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY file states its unit as &apos;%1&apos;, but lengths must be in mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei gibt als Einheit '%1' an, Längen müssen aber in mm sein; sie in mm exportieren.</translation>
    </message>
    <message>
      <source>The PLY file contains more data than its header declares; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei enthält mehr, als ihr Kopf nennt; neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY file contains no usable points; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei enthält keinen brauchbaren Punkt; den Scan neu exportieren.</translation>
    </message>
    <message>
      <source>No part of the edge can be a rim; draw this sherd without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Abschnitt der Kante kann Rand sein; diese Scherbe ohne Rand zeichnen.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %), so no diameter is given; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die als Lippe angenommene Kante sieht kaum danach aus (%1 %), daher wird kein Durchmesser angegeben; die Ausrichtung der Scherbe prüfen.</translation>
    </message>
    <message>
      <source>The preserved rim is too short or too straight for a diameter; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der erhaltene Rand ist für einen Durchmesser zu kurz oder zu gerade; die Ausrichtung der Scherbe prüfen.</translation>
    </message>
    <message>
      <source>Drawn as a rim sherd, which is likely (%1 %); check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Als Randstück gezeichnet, was wahrscheinlich ist (%1 %); nachprüfen.</translation>
    </message>
    <message>
      <source>This may be a rim sherd (%1 %); if it is, mark it as one and redraw it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das kann ein Randstück sein (%1 %); wenn ja, es so kennzeichnen und neu zeichnen.</translation>
    </message>
    <message>
      <source>The drawing&apos;s scale must be between 1:20 and 5:1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Maßstab der Zeichnung muss zwischen 1:20 und 5:1 liegen.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model (%1); create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Zeichnung braucht ein geschlossenes Modell (%1); es mit 'ostraka process' erzeugen.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model; create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Zeichnung braucht ein geschlossenes Modell; es mit 'ostraka process' erzeugen.</translation>
    </message>
    <message>
      <source>The manifest is missing; not an Ostraka export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Verzeichnis der Dateien fehlt; das ist kein Export von Ostraka.</translation>
    </message>
    <message>
      <source>The manifest has a line that cannot be read (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Manifest hat eine unlesbare Zeile (%1), deshalb wurde nichts gelesen; den Ordner noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The manifest names a file outside the folder (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Manifest nennt eine Datei außerhalb des Ordners (%1), deshalb wurde nichts gelesen; den Ordner noch einmal kopieren.</translation>
    </message>
    <message>
      <source>The manifest names the file %1 twice, so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Manifest nennt die Datei %1 zweimal, deshalb wurde nichts gelesen; den Ordner noch einmal kopieren.</translation>
    </message>
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Ordner dieses Namens gibt es schon; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>Not every system supports names with a line break, a backslash or characters that are not UTF-8; rename this file or folder, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nicht jedes System bewahrt einen Namen mit einem Zeilenumbruch, einem umgekehrten Schrägstrich oder Zeichen, die kein UTF-8 sind; benennen Sie diese Datei oder diesen Ordner um und versuchen Sie es erneut.</translation>
    </message>
    <message>
      <source>On some systems this is the same name as %1; rename one of the two, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf manchen Systemen ist dies derselbe Name wie %1; benennen Sie eine der beiden Dateien um und versuchen Sie es erneut.</translation>
    </message>
    <message>
      <source>Project A has another file with this name, which its catalogue does not list; nothing was merged. Move that file elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt A hat eine andere Datei dieses Namens, die sein Katalog nicht kennt; verschieben Sie sie, es wurde nichts zusammengeführt.</translation>
    </message>
    <message>
      <source>Two files of the export would have the same name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Dateien des Exports hätten denselben Namen.</translation>
    </message>
    <message>
      <source>Another import into this project is running; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Import in dieses Projekt läuft gerade; dieser wartet, bis er beendet ist.</translation>
    </message>
    <message>
      <source>Files that were missing from the project and are restored: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dateien, die im Projekt fehlten und wiederhergestellt wurden: %1.</translation>
    </message>
    <message>
      <source>A folder with this name was created in the meantime; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Inzwischen wurde ein Ordner dieses Namens angelegt; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>Not an Ostraka export: this folder has no bagit.txt.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner ist kein Export von Ostraka: bagit.txt fehlt.</translation>
    </message>
    <message>
      <source>This file is not in the manifest; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei steht nicht im Verzeichnis der Dateien; nichts wurde eingelesen.</translation>
    </message>
    <message>
      <source>This is a link, not a file; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist eine Verknüpfung, keine Datei; nichts wurde eingelesen.</translation>
    </message>
    <message>
      <source>This folder cannot be read (%1); nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner lässt sich nicht lesen (%1); nichts wurde eingelesen.</translation>
    </message>
    <message>
      <source>This file is missing; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei fehlt; nichts wurde eingelesen.</translation>
    </message>
    <message>
      <source>This file has changed since the export; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei wurde nach dem Export verändert; nichts wurde eingelesen.</translation>
    </message>
    <message>
      <source>The column &apos;closed&apos; accepts only yes or no.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In der Spalte closed steht yes oder no.</translation>
    </message>
    <message>
      <source>The column &apos;count_written&apos; accepts only a whole number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In der Spalte count_written steht eine ganze Zahl.</translation>
    </message>
    <message>
      <source>Values in the row: %1, columns in the header: %2; correct the row.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Werte in der Zeile: %1, Spalten in der Kopfzeile: %2; die Zeile berichtigen.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; is unknown; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Spalte '%1' ist unbekannt; ihre Werte werden als eigenes Feld behalten.</translation>
    </message>
    <message>
      <source>Not a text file: it contains binary data, which a table never does.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine Textdatei: Sie enthält binäre Daten, die keine Tabelle hat.</translation>
    </message>
    <message>
      <source>This is a spreadsheet (ODS, XLSX), not a CSV table; save the sheet as 'CSV UTF-8' and import that file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist eine Arbeitsmappe (ODS, XLSX) und keine CSV-Tabelle; das Blatt als 'CSV UTF-8' speichern und diese Datei importieren.</translation>
    </message>
    <message>
      <source>Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeile %1 ist nicht in UTF-8; die Tabelle als 'CSV UTF-8' speichern und noch einmal versuchen.</translation>
    </message>
    <message>
      <source>The table has more than 1,000,000 rows; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tabelle hat mehr als 1 000 000 Zeilen; sie aufteilen.</translation>
    </message>
    <message>
      <source>The table has more than 1,000 columns; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tabelle hat mehr als 1000 Spalten; sie aufteilen.</translation>
    </message>
    <message>
      <source>Line %1 has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeile %1 hat ein nicht geschlossenes Anführungszeichen.</translation>
    </message>
    <message>
      <source>Line %1 has characters after a closing quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeile %1 hat Zeichen hinter einem schließenden Anführungszeichen.</translation>
    </message>
    <message>
      <source>Line %1 has a value longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeile %1 hat einen Wert, der länger als 1 MB ist.</translation>
    </message>
    <message>
      <source>The table is empty; its first line must name the columns.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tabelle ist leer; ihre erste Zeile muss die Spalten nennen.</translation>
    </message>
    <message>
      <source>This sherd has no model yet, so it cannot be drawn; process its batch first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Scherbe hat noch kein Modell und lässt sich nicht zeichnen; zuerst ihren Durchgang verarbeiten.</translation>
    </message>
    <message>
      <source>The measurements of its batch are in doubt, and so is the size of this drawing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Maße ihres Durchgangs sind zweifelhaft: damit auch die Größe dieser Zeichnung.</translation>
    </message>
    <message>
      <source>The sherd is recorded as a rim, but no part of its edge can be one; it is drawn without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherbe ist als Randstück eingetragen, aber kein Abschnitt ihrer Kante kann Rand sein; sie wird ohne Rand gezeichnet.</translation>
    </message>
    <message>
      <source>%1 is missing and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 fehlt und wurde ausgelassen.</translation>
    </message>
    <message>
      <source>%1 differs from the recorded photograph; check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 weicht vom eingetragenen Foto ab; nachprüfen.</translation>
    </message>
    <message>
      <source>This model or picture of the sherd %1 differs from the recorded one; reprocess its batch %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Modell oder Bild der Scherbe %1 weicht vom eingetragenen ab; ihren Durchgang %2 neu verarbeiten.</translation>
    </message>
    <message>
      <source>%1 is exported in full detail: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird in voller Auflösung exportiert: %2</translation>
    </message>
    <message>
      <source>%1 is exported without photographs: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird ohne Fotos exportiert: %2</translation>
    </message>
    <message>
      <source>Photographs can be projected only onto a closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Fotos lassen sich nicht auf ein Modell legen, das nicht geschlossen ist.</translation>
    </message>
    <message>
      <source>Not drawn: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nicht gezeichnet: %1</translation>
    </message>
    <message>
      <source>Drawn without its photographs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ohne die Fotos gezeichnet: %1</translation>
    </message>
    <message>
      <source>No pictures with masks and poses of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Bilder mit Masken und Posen von %1: %2</translation>
    </message>
    <message>
      <source>No sherds to export; select some first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Scherben zu exportieren; zuerst welche auswählen.</translation>
    </message>
    <message>
      <source>The row has neither a number nor a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeile hat weder eine Nummer noch eine uuid.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das steht in mehr als einer Zeile der Tabelle, in den Zeilen %1.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1 and %2 more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das steht in mehr als einer Zeile der Tabelle, in den Zeilen %1 und %2 weiteren.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is unusual for a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Einheit prüfen: %1 ist für eine Scherbe ungewöhnlich.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is far from the other values of this column.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Einheit prüfen: %1 ist weit von den anderen Werten dieser Spalte entfernt.</translation>
    </message>
    <message>
      <source>Not a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine uuid.</translation>
    </message>
    <message>
      <source>The number and the uuid belong to different sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer und die uuid gehören zu verschiedenen Scherben.</translation>
    </message>
    <message>
      <source>A new sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine neue Scherbe braucht ihren Befund.</translation>
    </message>
    <message>
      <source>A column of the table has no name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Spalte der Tabelle hat keinen Namen.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; appears twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Spalte '%1' gibt es zweimal.</translation>
    </message>
    <message>
      <source>These places and batches are not in Ostraka&apos;s format.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Orte und Durchgänge sind nicht in Ostrakas Format.</translation>
    </message>
    <message>
      <source>Not a PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine PLY-Datei.</translation>
    </message>
    <message>
      <source>Not a GLB file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine GLB-Datei.</translation>
    </message>
    <message>
      <source>This export contains no sherd records (JSON); export it again with them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Export enthält keine Datensätze (JSON) von Scherben; mit ihnen neu exportieren.</translation>
    </message>
    <message>
      <source>The project already has this sherd with other values, which it keeps; the differing values are added in fields that end in _in_%1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Projekt hat diese Scherbe mit anderen Werten und behält sie; was abweicht, wird in Feldern hinzugefügt, die auf _in_%1 enden.</translation>
    </message>
    <message>
      <source>This file is not part of the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei gehört nicht zum Export.</translation>
    </message>
    <message>
      <source>The project has another file with this name; rename the export and import it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Projekt hat eine andere Datei dieses Namens; den Export umbenennen und noch einmal importieren.</translation>
    </message>
    <message>
      <source>Not a sherd record (ostraka-sherd/1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist kein Datensatz einer Scherbe (ostraka-sherd/1).</translation>
    </message>
    <message>
      <source>The measurement %1 has a unit other than %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Maß %1 hat eine andere Einheit als %2.</translation>
    </message>
    <message>
      <source>A value of the record has the wrong type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Wert des Datensatzes hat den falschen Typ.</translation>
    </message>
    <message>
      <source>This is too large for one ZIP file; select fewer sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist zu groß für eine ZIP-Datei; weniger Scherben auswählen.</translation>
    </message>
    <message>
      <source>The mask is missing; expected a mask of %1 x %2 pixels under this name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Maske fehlt; erwartet wird unter diesem Namen eine Maske von %1 x %2 Pixeln.</translation>
    </message>
    <message>
      <source>The mask cannot be read as a picture; expected a mask of %1 x %2 pixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Maske lässt sich nicht als Bild lesen; erwartet wird eine Maske von %1 x %2 Pixeln.</translation>
    </message>
    <message>
      <source>The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size of its photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Maske hat %1 x %2 Pixel; erwartet wird eine Maske von %3 x %4 Pixeln, so groß wie ihr Foto.</translation>
    </message>
    <message>
      <source>Masks from the plate need at least 3 photographs of a side; photograph more positions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken von der Platte brauchen mindestens 3 Fotos einer Seite; mehr Positionen aufnehmen.</translation>
    </message>
    <message>
      <source>The photograph differs in size from its camera&apos;s images; use the original file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Foto hat eine andere Größe als die Bilder seiner Kamera; die Originaldatei verwenden.</translation>
    </message>
    <message>
      <source>No sherd was found on the plate; check that the photographs show sherds that stand out from the plate, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf der Platte wurde keine Scherbe gefunden; prüfen, ob die Fotos Scherben zeigen, die sich von der Platte abheben, oder Masken angeben.</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 differs in size from the camera&apos;s other photographs; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken: Das Foto der leeren Platte von Kamera %1 hat eine andere Größe als die übrigen Fotos der Kamera; die Masken entstehen ohne es</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows the plate at none of the positions; retake it at the first; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken: Das Foto der leeren Platte von Kamera %1 zeigt die Platte an keiner der Positionen; bei der ersten noch einmal aufnehmen; die Masken entstehen ohne es</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows covered markers in %2; uncover them; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken: Das Foto der leeren Platte von Kamera %1 zeigt in %2 verdeckte Marken; sie freilegen; die Masken entstehen ohne es</translation>
    </message>
    <message>
      <source>masks: a shadow that the other photographs do not show falls on the plate in %1; keep people and hands out of the light, and retake these if their masks look wrong</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken: Ein Schatten, den die anderen Fotos nicht haben, liegt auf der Platte in %1; Menschen und Hände aus dem Licht halten und diese Fotos noch einmal aufnehmen, wenn ihre Masken falsch aussehen</translation>
    </message>
    <message>
      <source>%1 (%2 % of the bare plate)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (%2 % der freien Platte)</translation>
    </message>
    <message>
      <source>masks: flat objects that look like labels or scale bars are left out (%1); if there are sherds among them, add them to the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masken: Flache Dinge, die wie Etiketten oder Maßstäbe aussehen, sind weggelassen (%1); wenn Scherben darunter sind, diese in den Masken ergänzen</translation>
    </message>
    <message>
      <source>The front scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan der Vorderseite enthält keine Punkte.</translation>
    </message>
    <message>
      <source>The front scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan der Vorderseite hat keine Normalen; ein Modell braucht sie, um außen und innen zu unterscheiden.</translation>
    </message>
    <message>
      <source>The back scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan der Rückseite enthält keine Punkte.</translation>
    </message>
    <message>
      <source>The back scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan der Rückseite hat keine Normalen; ein Modell braucht sie, um außen und innen zu unterscheiden.</translation>
    </message>
    <message>
      <source>The scans do not enclose a volume; their normals may point inward.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scans umschließen keinen Körper; vielleicht zeigen ihre Normalen nach innen.</translation>
    </message>
    <message>
      <source>Only a closed mesh can be simplified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nur ein geschlossenes Netz lässt sich vereinfachen.</translation>
    </message>
    <message>
      <source>The deviation of a simplified mesh must be greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Abweichung eines vereinfachten Netzes muss über 0 mm liegen.</translation>
    </message>
    <message>
      <source>The scan is too large for a model at this spacing; use a larger spacing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan ist für ein Modell mit diesem Punktabstand zu groß; einen größeren angeben.</translation>
    </message>
    <message>
      <source>The scans contain too few points that agree with each other for a model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scans haben zu wenige Punkte, die miteinander übereinstimmen, für ein Modell.</translation>
    </message>
    <message>
      <source>This model is %1 mm in size, larger than any vessel, so its unit is probably not mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Modell ist %1 mm groß, mehr als jedes Gefäß, also hat es wohl eine andere Einheit; es in mm exportieren.</translation>
    </message>
    <message>
      <source>This model is only %1 mm in size, smaller than any sherd, so its unit is probably not mm (%2); export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Modell ist nur %1 mm groß, weniger als jede Scherbe, also hat es wohl eine andere Einheit (%2); es in mm exportieren.</translation>
    </message>
    <message>
      <source>Edge %1 is used more than once in the same direction.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kante %1 kommt in derselben Richtung mehr als einmal vor.</translation>
    </message>
    <message>
      <source>Edge %1 has a face on one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kante %1 hat nur auf einer Seite eine Fläche.</translation>
    </message>
    <message>
      <source>Vertex %1 belongs to no face.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ecke %1 gehört zu keiner Fläche.</translation>
    </message>
    <message>
      <source>Vertex %1 joins two separate fans of faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ecke %1 verbindet zwei getrennte Fächer von Flächen.</translation>
    </message>
    <message>
      <source>The mesh has no faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Netz hat keine Flächen.</translation>
    </message>
    <message>
      <source>A face refers to a vertex that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Fläche nennt eine Ecke, die es nicht gibt.</translation>
    </message>
    <message>
      <source>A face has the same vertex twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Fläche hat dieselbe Ecke zweimal.</translation>
    </message>
    <message>
      <source>The scan&apos;s outline is not closed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Umriss des Scans schließt sich nicht.</translation>
    </message>
    <message>
      <source>A scan of fewer than 20 points has no outline.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Scan von weniger als 20 Punkten hat keinen Umriss.</translation>
    </message>
    <message>
      <source>A contour needs at least three points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Umriss braucht mindestens drei Punkte.</translation>
    </message>
    <message>
      <source>The evidence for a pair has no valid scans or value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Belege für ein Paar nennen keine gültigen Scans oder keinen gültigen Wert.</translation>
    </message>
    <message>
      <source>pairing: %1 stays unpaired: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zuordnung: %1 bleibt ohne Partner: %2</translation>
    </message>
    <message>
      <source>No two outlines match, so the sizes of the two sides cannot be compared; provide a known length.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine zwei Umrisse gleichen sich, also lassen sich die Größen der Seiten nicht vergleichen; eine bekannte Länge angeben.</translation>
    </message>
    <message>
      <source>A candidate refers to a scan that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Kandidat nennt einen Scan, den es nicht gibt.</translation>
    </message>
    <message>
      <source>Not a candidate table; reprocess the batch, which redoes only its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine Kandidatentabelle; den Durchgang neu verarbeiten, nur seine Paare werden neu gemacht.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, whose side has been reshot since; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Entscheidung vom %1 von %2 betrifft %3, dessen Seite seither neu aufgenommen wurde; noch einmal entscheiden.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, which is no longer on the plate; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Entscheidung vom %1 von %2 betrifft %3, das nicht mehr auf der Platte liegt; noch einmal entscheiden.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 has no effect: the later decision of %3 by %4 concerns the same scan; withdraw one of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Entscheidung vom %1 von %2 ist wirkungslos: Die Entscheidung vom %3 von %4 ist später und betrifft denselben Scan; eine von beiden zurücknehmen.</translation>
    </message>
    <message>
      <source>A decision is of an unknown kind; a newer version of Ostraka wrote it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Entscheidung ist von unbekannter Art; eine neuere Version von Ostraka hat sie geschrieben.</translation>
    </message>
    <message>
      <source>A pair needs one front and one back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Paar braucht eine Vorderseite und eine Rückseite.</translation>
    </message>
    <message>
      <source>Nothing is selected to set aside or reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es ist nichts ausgewählt, das beiseitegelegt oder neu aufgenommen werden soll.</translation>
    </message>
    <message>
      <source>Fragments to merge must be of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmente, die zusammengeführt werden, müssen von derselben Seite sein.</translation>
    </message>
    <message>
      <source>A split needs one fragment and a line of at least 1 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zum Teilen sind ein Fragment und eine Linie von mindestens 1 mm nötig.</translation>
    </message>
    <message>
      <source>Nothing is selected to withdraw.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es ist nichts ausgewählt, das zurückgenommen werden soll.</translation>
    </message>
    <message>
      <source>A newer version of Ostraka wrote these decisions; use that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine neuere Version von Ostraka hat diese Entscheidungen geschrieben; jene Version benutzen.</translation>
    </message>
    <message>
      <source>Decision %1 cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entscheidung %1 ist nicht verwendbar.</translation>
    </message>
    <message>
      <source>Its id is missing or used twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihre ID fehlt oder kommt zweimal vor.</translation>
    </message>
    <message>
      <source>It replaces more than %1 decisions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie ersetzt mehr als %1 Entscheidungen.</translation>
    </message>
    <message>
      <source>It replaces a decision twice, or one that does not come before it in the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie ersetzt eine Entscheidung zweimal oder eine, die in der Datei nicht vor ihr steht.</translation>
    </message>
    <message>
      <source>A batch can have at most %1 decisions; move this file elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Durchgang kann höchstens %1 Entscheidungen haben; diese Datei woandershin verschieben oder eine Kopie von ihr zurücklegen.</translation>
    </message>
    <message>
      <source>Correct it, or restore a copy of the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie berichtigen oder eine Kopie der Datei zurücklegen.</translation>
    </message>
    <message>
      <source>Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine Entscheidungsdatei von Ostraka; sie woandershin verschieben oder eine Kopie von ihr zurücklegen.</translation>
    </message>
    <message>
      <source>This decision is no longer in effect.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Entscheidung gilt nicht mehr.</translation>
    </message>
    <message>
      <source>There is no photograph of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von dieser Seite gibt es kein Foto.</translation>
    </message>
    <message>
      <source>The outlines of these two sides cannot be overlaid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Umrisse dieser beiden Seiten lassen sich nicht übereinanderlegen.</translation>
    </message>
    <message>
      <source>%1 may be two sherds that touch, %2 and %3 of the other side: split it in the review, or move them apart and reshoot its side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 können zwei Scherben sein, die sich berühren, %2 und %3 der anderen Seite: in der Prüfung teilen, oder auseinanderlegen und diese Seite neu aufnehmen.</translation>
    </message>
    <message>
      <source>Not a list of mask strokes; restore an earlier one, or delete it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine Liste von Maskenstrichen; eine frühere zurücklegen oder sie löschen.</translation>
    </message>
    <message>
      <source>A mask holds at most 1,000 strokes and 100,000 points; nothing is saved until you undo some.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Maske fasst höchstens 1000 Striche und 100 000 Punkte; nichts wird gespeichert, bis Sie einige rückgängig machen.</translation>
    </message>
    <message>
      <source>This batch has no masks yet; process it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang hat noch keine Masken; ihn zuerst verarbeiten.</translation>
    </message>
    <message>
      <source>This file does not state how well the rig fits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei sagt nicht, wie gut der Messplatz passt.</translation>
    </message>
    <message>
      <source>This calibration is for other cameras than those of the batch; calibrate the rig from its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Kalibrierung ist für andere Kameras als die des Durchgangs; den Messplatz nach seinen eigenen Fotos kalibrieren.</translation>
    </message>
    <message>
      <source>Masks cannot be made without plate.json; put masks next to the photographs, or choose a network (--masks MODEL.onnx).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ohne plate.json lassen sich keine Masken erzeugen; Masken neben die Fotos legen oder ein Netz wählen (--masks MODEL.onnx).</translation>
    </message>
    <message>
      <source>The result has no scale: without plate.json no length is known, and lengths in mm are based on a guessed pixel size; photograph on a marker plate, lay the board of board.json beside the sherds on both sides, or mark a known length on both in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Ergebnis hat keinen Maßstab: Ohne plate.json ist keine Länge bekannt, und Längen in mm beruhen auf einer geschätzten Pixelgröße; auf einer Markenplatte aufnehmen, die Tafel aus board.json auf beiden Seiten neben die Scherben legen, oder auf beiden eine bekannte Länge in scale.json markieren.</translation>
    </message>
    <message>
      <source>The output folder contains files that Ostraka did not write; choose another or an empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ausgabeordner enthält Dateien, die Ostraka nicht geschrieben hat; einen anderen oder einen leeren wählen.</translation>
    </message>
    <message>
      <source>The file has changed since the batch&apos;s processing began; nothing made from it is kept. Process the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei hat sich geändert, seit die Verarbeitung des Durchgangs begann; nichts, was daraus entstand, wird behalten. Den Durchgang noch einmal verarbeiten.</translation>
    </message>
    <message>
      <source>The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. Measure one; then correct the file, or leave the option out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Marken haben in dieser Datei Seiten von %1 mm, mit --marker-mm sind aber %2 mm angegeben. Eine nachmessen; dann die Datei berichtigen oder die Option weglassen.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Foto ist mit %1 identisch; es wird ausgelassen.</translation>
    </message>
    <message>
      <source>These results were made from the photographs of %1, not of %2; process %3 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ergebnisse entstanden aus den Fotos von %1, nicht aus denen von %2; %3 selbst verarbeiten.</translation>
    </message>
    <message>
      <source>These results were not made from the photographs of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ergebnisse entstanden nicht aus den Fotos von %1; den Durchgang noch einmal verarbeiten.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2 and %3 more. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für diesen Durchgang verzeichnete Fotos fehlen in seinem Ordner (%1): %2 und %3 weitere. Sie zurücklegen und den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für diesen Durchgang verzeichnete Fotos fehlen in seinem Ordner (%1): %2. Sie zurücklegen und den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>The output folder contains another batch; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ausgabeordner enthält einen anderen Durchgang; einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>The output folder contains other files; choose a new or empty folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ausgabeordner enthält andere Dateien; einen neuen oder leeren Ordner wählen.</translation>
    </message>
    <message>
      <source>A pair refers to a scan that does not exist; delete this file and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Paar nennt einen Scan, den es nicht gibt; diese Datei löschen und den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>Not a pair table; delete it and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine Paartabelle; sie löschen und den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>%1 and %2 were paired by hand, but their relative pose is unknown; align the back by hand in the review: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 und %2 wurden von Hand gepaart, aber ihre Lage zueinander ist unbekannt; die Rückseite in der Prüfung von Hand ausrichten: %3</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; it is left out, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Das Foto ist unscharf: Seine Kanten sind %2 Pixel breit, die des schärfsten dieser Kamera %3; es wird ausgelassen, noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Das Foto ist unscharf: Seine Kanten sind %2 Pixel breit, die des schärfsten dieser Kamera %3; noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the front side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 der %2 Marken der Platte sind auf keinem Foto der Vorderseite zu sehen (%3); die Lage der Kameras beruht auf den anderen, also wegnehmen, was sie verdeckt.</translation>
    </message>
    <message>
      <source>All photographs of the back side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle Fotos der Rückseite sind unscharf: Selbst im schärfsten sind die Kanten der Marken %1 Pixel breit, daher sind ihre Scans grob. Schärfe und Verschlusszeit prüfen und diese Seite neu aufnehmen.</translation>
    </message>
    <message>
      <source>All photographs of the front side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle Fotos der Vorderseite sind unscharf: Selbst im schärfsten sind die Kanten der Marken %1 Pixel breit, daher sind ihre Scans grob. Schärfe und Verschlusszeit prüfen und diese Seite neu aufnehmen.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the back side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 der %2 Marken der Platte sind auf keinem Foto der Rückseite zu sehen (%3); die Lage der Kameras beruht auf den anderen, also wegnehmen, was sie verdeckt.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 merges fragments that no longer exist; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Entscheidung vom %1 von %2 führt Fragmente zusammen, die es nicht mehr gibt; noch einmal entscheiden.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 splits a fragment that does not exist, or misses it; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Entscheidung vom %1 von %2 teilt ein Fragment, das es nicht gibt, oder verfehlt es; noch einmal entscheiden.</translation>
    </message>
    <message>
      <source>The program %1 is not installed, but the selected stereo needs it; install it, or use the built-in stereo.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm %1 ist nicht installiert, und die gewählte Stereoberechnung braucht es; es installieren oder die eingebaute nehmen.</translation>
    </message>
    <message>
      <source>The photographs show no marker plate, so finding the cameras needs the program %1, which is not installed; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Fotos zeigen keine Markenplatte, also muss das Programm %1 die Kameras finden, und es ist nicht installiert; es installieren.</translation>
    </message>
    <message>
      <source>This needs about %1 GB of memory, but only %2 GB are free: the computer may stop the program or become very slow.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das braucht etwa %1 GB Speicher, und nur %2 GB sind frei: Der Rechner kann es abbrechen oder sehr langsam werden.</translation>
    </message>
    <message>
      <source>Close other programs, or process a draft.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Andere Programme schließen oder einen Entwurf verarbeiten.</translation>
    </message>
    <message>
      <source>%1: the camera was not in the place that it had while the plate turned; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Die Kamera war nicht dort, wo sie stand, während sich die Platte drehte; das Foto wird ausgelassen.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wurde auf der Vorderseite um etwa %2 mm verschoben: Ab Position %3 (pos%4) liegt die Scherbe woanders; diese Seite neu aufnehmen.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wurde auf der Vorderseite um etwa %2 mm verschoben: Ab %3 liegt die Scherbe woanders; diese Seite neu aufnehmen.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wurde auf der Rückseite um etwa %2 mm verschoben: Ab Position %3 (pos%4) liegt die Scherbe woanders; diese Seite neu aufnehmen.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wurde auf der Rückseite um etwa %2 mm verschoben: Ab %3 liegt die Scherbe woanders; diese Seite neu aufnehmen.</translation>
    </message>
    <message>
      <source>The output folder is inside the batch folder, to which Ostraka never writes; choose one next to it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ausgabeordner liegt im Ordner des Durchgangs, in den Ostraka nie schreibt; einen daneben wählen.</translation>
    </message>
    <message>
      <source>Processing needs at least %1 GB of memory.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Verarbeitung braucht mindestens %1 GB Arbeitsspeicher.</translation>
    </message>
    <message>
      <source>Photographs cannot be reduced to less than 0.3 megapixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos lassen sich nicht auf weniger als 0,3 Megapixel verkleinern.</translation>
    </message>
    <message>
      <source>There is no such segmentation network; masks are 'auto', 'given' or an ONNX file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein solches Netz zum Freistellen gibt es nicht; Masken sind 'auto', 'given' oder eine ONNX-Datei.</translation>
    </message>
    <message>
      <source>The fronts are not in mm: lengths in the result, although labelled mm, are in the fronts&apos; own unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Vorderseiten sind nicht in mm: Längen des Ergebnisses, obwohl als mm bezeichnet, sind in der Einheit der Vorderseiten.</translation>
    </message>
    <message>
      <source>The pairs of this batch are not processed yet; process the batch: complete results are kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Paare dieses Durchgangs sind noch nicht verarbeitet; den Durchgang verarbeiten: was vollständig ist, bleibt.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too small; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Maßstab stimmt nicht: %1, also wären alle Maße %2 % zu klein; das Lineal auf der Platte messen und plate.json mit 'ostraka plate --ruler-measured' die wahre Größe geben, oder die Platte noch einmal mit 100 % drucken; wenn die Platte stimmt, die Länge messen und ihre Marken neu setzen.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too large; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Maßstab stimmt nicht: %1, also wären alle Maße %2 % zu groß; das Lineal auf der Platte messen und plate.json mit 'ostraka plate --ruler-measured' die wahre Größe geben, oder die Platte noch einmal mit 100 % drucken; wenn die Platte stimmt, die Länge messen und ihre Marken neu setzen.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the front side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die auf der Vorderseite markierte Länge von %1 mm misst in den Fotos %2 ± %3 mm (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the front side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Länge von %1 mm in scale.json ließ sich nicht prüfen: jedes ihrer Enden auf mindestens zwei Fotos der Vorderseite markieren, die aus verschiedenen Richtungen aufgenommen sind.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the back side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die auf der Rückseite markierte Länge von %1 mm misst in den Fotos %2 ± %3 mm (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the back side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Länge von %1 mm in scale.json ließ sich nicht prüfen: jedes ihrer Enden auf mindestens zwei Fotos der Rückseite markieren, die aus verschiedenen Richtungen aufgenommen sind.</translation>
    </message>
    <message>
      <source>The folder cannot be read; choose a folder of PLY files.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ordner lässt sich nicht lesen; einen Ordner mit PLY-Dateien wählen.</translation>
    </message>
    <message>
      <source>This folder contains no PLY files; each sherd&apos;s scan must be one PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ordner ist keine PLY-Datei; der Scan jeder Scherbe muss eine PLY-Datei sein.</translation>
    </message>
    <message>
      <source>%1: 1 point without finite coordinates was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: 1 Punkt ohne endliche Koordinaten wurde ausgelassen; den Export prüfen.</translation>
    </message>
    <message>
      <source>%1: %2 points without finite coordinates were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 Punkte ohne endliche Koordinaten wurden ausgelassen; den Export prüfen.</translation>
    </message>
    <message>
      <source>%1: 1 point far from all others, or at 0, 0, 0, was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: 1 Punkt weit weg von allen anderen oder bei 0, 0, 0 wurde ausgelassen; den Export prüfen.</translation>
    </message>
    <message>
      <source>%1: %2 points far from all others, or at 0, 0, 0, were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 Punkte weit weg von allen anderen oder bei 0, 0, 0 wurden ausgelassen; den Export prüfen.</translation>
    </message>
    <message>
      <source>The scan has fewer than 100 points; rescan this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan hat weniger als 100 Punkte; diese Seite noch einmal scannen.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with nx, ny and nz.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan hat keine Normalen; ihn mit nx, ny und nz exportieren.</translation>
    </message>
    <message>
      <source>The scan is %1 times its length away from the origin, so its coordinates are rounded; move it to the origin and export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan liegt das %1-Fache seiner Länge vom Ursprung entfernt, also sind seine Koordinaten gerundet; ihn zum Ursprung verschieben und noch einmal exportieren.</translation>
    </message>
    <message>
      <source>None of the scans can be used: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keiner der Scans ist verwendbar: %1</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; their unit seems to be %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Scans sind im Median %1 mm lang; das sieht nach %2 aus: %3.</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; no sherds are of that size: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Scans sind im Median %1 mm lang; so große Scherben gibt es nicht: %2.</translation>
    </message>
    <message>
      <source>The median length of the fronts is %1 mm, of the backs %2 mm, so their units differ: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Vorderseiten sind im Median %1 mm lang, die Rückseiten %2 mm, also sind ihre Einheiten verschieden: %3.</translation>
    </message>
    <message>
      <source>centimetres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zentimetern</translation>
    </message>
    <message>
      <source>metres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Metern</translation>
    </message>
    <message>
      <source>micrometres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mikrometern</translation>
    </message>
    <message>
      <source>export them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sie in mm exportieren</translation>
    </message>
    <message>
      <source>export them in mm, or use --scale free</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sie in mm exportieren oder --scale free nehmen</translation>
    </message>
    <message>
      <source>Sherd %1 has no model: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1 hat kein Modell: %2</translation>
    </message>
    <message>
      <source>Sherd %1: %2 % of its surface is unseen by any camera and filled in, orange in its picture; reshoot it if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1: %2 % der Oberfläche hat keine Kamera gesehen; sie sind ergänzt, im Bild orange. Wenn es darauf ankommt, die Scherbe neu aufnehmen.</translation>
    </message>
    <message>
      <source>Sherd %1: its model has a hole right through it (%2 mm²). If the sherd has none, the photographs do not show that area; reshoot the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1: Durch ihr Modell geht ein Loch (%2 mm²). Wenn die Scherbe keines hat, zeigen die Fotos diese Stelle nicht; sie neu aufnehmen.</translation>
    </message>
    <message>
      <source>The file lists %1, which is not in the batch; delete the file to find the cameras again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei nennt %1, das nicht in dem Durchgang ist; sie löschen, dann werden die Kameras neu gefunden.</translation>
    </message>
    <message>
      <source>This photograph has no mask; provide one for each photograph to be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Foto hat keine Maske; für jedes, das verwendet werden soll, eine angeben.</translation>
    </message>
    <message>
      <source>This photograph is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Foto wird nicht verwendet.</translation>
    </message>
    <message>
      <source>Photographs of the front side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos der Vorderseite, die ausgelassen werden, weil COLMAP keine Lage für sie fand: %1.</translation>
    </message>
    <message>
      <source>Photographs of the back side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos der Rückseite, die ausgelassen werden, weil COLMAP keine Lage für sie fand: %1.</translation>
    </message>
    <message>
      <source>The rig was not used: without plate.json the poses come from COLMAP.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz wurde nicht verwendet: Ohne plate.json bestimmt COLMAP die Lage der Kameras.</translation>
    </message>
    <message>
      <source>%1: The mask marks no sherd in this photograph; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Die Maske markiert auf diesem Foto keine Scherbe; es wird ausgelassen.</translation>
    </message>
    <message>
      <source>If it shows sherds, retake it or edit its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wenn Scherben darauf sind, es noch einmal aufnehmen oder seine Maske bearbeiten.</translation>
    </message>
    <message>
      <source>Photographs of the front side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos der Vorderseite, deren Masken Scherben zeigen: %1; mindestens 3 sind nötig.</translation>
    </message>
    <message>
      <source>Photographs of the back side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos der Rückseite, deren Masken Scherben zeigen: %1; mindestens 3 sind nötig.</translation>
    </message>
    <message>
      <source>Check the masks, and whether sherds were on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Masken prüfen, und ob Scherben auf der Platte lagen.</translation>
    </message>
    <message>
      <source>Fewer than 10 fracture points match; start from a better pose.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Weniger als 10 Punkte des Bruchs passen zueinander; von einer besseren Lage aus beginnen.</translation>
    </message>
    <message>
      <source>No photograph shows the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Foto zeigt die Scherbe.</translation>
    </message>
    <message>
      <source>Not every vertex has a place in the texture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nicht jeder Punkt des Netzes hat einen Platz in der Textur.</translation>
    </message>
    <message>
      <source>The texture of this GLB model cannot be read, so the model is used without it; reprocess its batch to write the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Textur dieses GLB-Modells ist nicht lesbar, deshalb wird das Modell ohne sie verwendet; seinen Durchgang neu verarbeiten, damit die Datei neu geschrieben wird.</translation>
    </message>
    <message>
      <source>The texture of this model has more than 67,108,864 pixels, so the model is used without it; export the model with a smaller one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Textur dieses Modells hat mehr als 67.108.864 Pixel, deshalb wird das Modell ohne sie verwendet; das Modell mit einer kleineren exportieren.</translation>
    </message>
    <message>
      <source>The texture of sherd %1 lacks a photograph: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Textur der Scherbe %1 fehlt ein Foto: %2</translation>
    </message>
    <message>
      <source>Sherd %1 has no photographic texture: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1 hat keine Textur aus Fotos: %2</translation>
    </message>
    <message>
      <source>The colour chart is overexposed or underexposed (clipped patches: %1), so it is not used and colours stay as photographed; reshoot it at another exposure.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Farbtafel ist über- oder unterbelichtet (abgeschnittene Felder: %1); sie wird nicht verwendet, und die Farben bleiben wie fotografiert. Die Tafel mit anderer Belichtung neu fotografieren.</translation>
    </message>
    <message>
      <source>The colour chart is shaded, bent or partly hidden, so it is not used and colours stay as photographed; reshoot it flat, whole and evenly lit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Farbtafel ist beschattet, gebogen oder teilweise verdeckt; sie wird nicht verwendet, und die Farben bleiben wie fotografiert. Die Tafel flach, ganz und gleichmäßig beleuchtet neu fotografieren.</translation>
    </message>
    <message>
      <source>colours: corrected by the colour chart in %1 photographs; its patches differ from their reference by %2 (median) and %3 (95 %), CIEDE2000</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Farben: nach der Farbtafel in %1 Fotos korrigiert; ihre Felder weichen um %2 (Median) und %3 (95 %) von ihren Sollwerten ab, CIEDE2000</translation>
    </message>
    <message>
      <source>The chosen registration method did not converge; use the default method, or align the back by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das gewählte Verfahren zum Fügen der Seiten hat keine Lage gefunden; das Standardverfahren verwenden oder die Rückseite von Hand ausrichten.</translation>
    </message>
    <message>
      <source>Too few fracture points for the chosen registration method; use the default method.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zu wenige Punkte des Bruchs für das gewählte Verfahren zum Fügen der Seiten; das Standardverfahren verwenden.</translation>
    </message>
    <message>
      <source>No start pose was given for the registration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für das Fügen der Seiten wurde keine Anfangslage angegeben.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan hat keine Normalen; ihn mit Normalen exportieren.</translation>
    </message>
    <message>
      <source>Fewer than 50 points are on the fracture; rescan the sherd including its fracture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Weniger als 50 Punkte liegen auf dem Bruch; die Scherbe mit ihrem Bruch noch einmal scannen.</translation>
    </message>
    <message>
      <source>%1: The board was not detected; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Die Tafel wurde nicht erkannt; dieses Bild wird ausgelassen.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Wörterbuch %1 hat zu wenige Marken für die Tafel.</translation>
    </message>
    <message>
      <source>A grid of markers needs 'dictionary', 'markers_x', 'markers_y', 'marker_length' and 'marker_separation'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Gitter aus Marken braucht 'dictionary', 'markers_x', 'markers_y', 'marker_length' und 'marker_separation'.</translation>
    </message>
    <message>
      <source>Nothing to calibrate from: put photographs of the plate at each position into &apos;front&apos; (cam0_pos00.jpg and so on) and pictures of the board into &apos;calib&apos;, and copy plate.json and board.json next to them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es gibt nichts, wonach sich kalibrieren ließe: die Platte an jeder Position nach 'front' aufnehmen (cam0_pos00.jpg und so weiter), die Tafel nach 'calib', und plate.json und board.json daneben kopieren.</translation>
    </message>
    <message>
      <source>No pictures of the board found; put them here or into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es gibt keine Bilder der Tafel; sie hierher legen oder nach 'calib'.</translation>
    </message>
    <message>
      <source>It is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es wird beiseitegelegt.</translation>
    </message>
    <message>
      <source>%1: its size differs from that of the first picture; it is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Es hat eine andere Größe als das erste; es wird beiseitegelegt.</translation>
    </message>
    <message>
      <source>The bundle adjustment of the rig did not converge; check that plate.json and board.json describe what was photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Bündelausgleichung des Messplatzes konvergierte nicht; prüfen, ob plate.json und board.json beschreiben, was aufgenommen wurde.</translation>
    </message>
    <message>
      <source>The file does not describe how the sheets bend; delete it to measure them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei beschreibt nicht, wie die Bögen gebogen sind; sie löschen, dann wird es neu gemessen.</translation>
    </message>
    <message>
      <source>The file does not describe what the sherds stand on; delete it to determine this again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei beschreibt nicht, worauf die Scherben stehen; sie löschen, dann wird es neu bestimmt.</translation>
    </message>
    <message>
      <source>The sheet's markers can be read in %1 of %2 photographs of the %3 side; at least 3 are needed. Check that plate.json describes this sheet, that the photographs are not mirrored, and that most of the markers are in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Marken des Bogens sind in %1 von %2 Fotos der Seite %3 lesbar; mindestens 3 sind nötig. Prüfen, ob plate.json diesen Bogen beschreibt, ob die Fotos nicht gespiegelt sind und ob die meisten Marken im Bild sind.</translation>
    </message>
    <message>
      <source>%1: %2 of the sheet&apos;s markers can be read, too few for a pose; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 Marken des Bogens sind lesbar, zu wenige für eine Lage; das Foto wird ausgelassen.</translation>
    </message>
    <message>
      <source>Photographs that show too few of the sheet&apos;s markers for a pose are left out (%1 and %2 more); check that they show this sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos, die für eine Lage zu wenige Marken des Bogens zeigen, werden ausgelassen (%1 und %2 weitere); prüfen, ob sie diesen Bogen zeigen.</translation>
    </message>
    <message>
      <source>%1: most of the sheet&apos;s markers are not where the other photographs place them; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Die meisten Marken des Bogens liegen nicht dort, wo die übrigen Fotos sie sehen; das Foto wird ausgelassen.</translation>
    </message>
    <message>
      <source>Only one side was photographed: its %1 scans are open surfaces without a back; they are in 'unpaired'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nur eine Seite wurde fotografiert: Ihre %1 Scans sind offene Flächen ohne Rückseite; sie liegen in 'unpaired'.</translation>
    </message>
    <message>
      <source>plate.json is missing, so the plate&apos;s markers cannot be used; copy the file that &apos;ostraka plate&apos; wrote with the plate into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>plate.json fehlt, also sind die Marken der Platte nicht verwendbar; die Datei, die 'ostraka plate' mit der Platte geschrieben hat, in diesen Ordner kopieren.</translation>
    </message>
    <message>
      <source>The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig is calibrated from this batch instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der bekannte Messplatz hat keine Kamera %1 mit Bildern von %2 x %3 Pixeln; er wird stattdessen nach diesem Durchgang kalibriert.</translation>
    </message>
    <message>
      <source>Its lens is estimated from the plate's markers instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ihr Objektiv wird stattdessen aus den Marken der Platte geschätzt.</translation>
    </message>
    <message>
      <source>The lens of camera %1 is unknown: no usable pictures of the board and no plate markers were found; add pictures of the board to &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Objektiv von Kamera %1 ist unbekannt: Es wurden weder brauchbare Bilder der Tafel noch Marken der Platte gefunden; Bilder der Tafel zu 'calib' hinzufügen.</translation>
    </message>
    <message>
      <source>The lens of camera %1 was estimated from the plate&apos;s markers alone; add 12 pictures of the board to &apos;calib&apos; for accurate measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Objektiv von Kamera %1 wurde allein aus den Marken der Platte geschätzt; für genaue Maße 12 Bilder der Tafel zu 'calib' hinzufügen.</translation>
    </message>
    <message>
      <source>The plate's markers were found in %1 of %2 photographs, too few for a pose of each side; check that plate.json belongs to this plate and that the markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Marken der Platte wurden in %1 von %2 Fotos gefunden, zu wenige für die Lage beider Seiten; prüfen, ob plate.json zu dieser Platte gehört und ob die Marken beleuchtet und im Bild sind.</translation>
    </message>
    <message>
      <source>No photograph of camera %1 shows two markers of the plate; all its photographs are left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Foto von Kamera %1 zeigt zwei Marken der Platte; alle ihre Fotos werden ausgelassen.</translation>
    </message>
    <message>
      <source>The known rig no longer fits: camera %1 misses the markers by %2 px. The camera poses are re-estimated for this batch; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der bekannte Messplatz passt nicht mehr: Kamera %1 verfehlt die Marken um %2 px. Die Lagen der Kameras werden für diesen Durchgang neu geschätzt; den Messplatz neu kalibrieren.</translation>
    </message>
    <message>
      <source>%1: none of its %2 markers is where this camera sees them at this position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Keine seiner %2 Marken liegt dort, wo diese Kamera sie an dieser Position sieht.</translation>
    </message>
    <message>
      <source>It has another photograph&apos;s name or was taken while the plate was turning; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es trägt den Namen eines anderen Fotos oder entstand, während die Platte sich drehte; es wird ausgelassen.</translation>
    </message>
    <message>
      <source>%1: no marker is visible; check that the photograph shows this position. If not, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Keine Marke ist zu sehen; prüfen, ob das Foto diese Position zeigt. Wenn nicht, noch einmal aufnehmen.</translation>
    </message>
    <message>
      <source>Photographs of the front side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos der Vorderseite mit bekannter Lage: %1; mindestens 3 sind nötig. Prüfen, ob die Marken der Platte beleuchtet und im Bild sind.</translation>
    </message>
    <message>
      <source>Photographs of the back side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos der Rückseite mit bekannter Lage: %1; mindestens 3 sind nötig. Prüfen, ob die Marken der Platte beleuchtet und im Bild sind.</translation>
    </message>
    <message>
      <source>Camera %1 sees fewer than six of the plate&apos;s markers at position %2; check lighting and focus there and that nothing covers the markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 sieht weniger als sechs Marken der Platte an Position %2; dort Licht und Fokus prüfen, und dass nichts auf den Marken liegt.</translation>
    </message>
    <message>
      <source>Positions photographed: %1; photograph at least four around the full turn to determine the axis.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aufgenommene Positionen: %1; mindestens vier über die ganze Umdrehung aufnehmen, damit sich die Achse bestimmen lässt.</translation>
    </message>
    <message>
      <source>Fewer than eight markers were detected, so no distance could be held out of the fit: the scale is not checked.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Weniger als acht Marken wurden erkannt, also ließ sich kein Abstand zur Kontrolle zurückhalten: Der Maßstab ist nicht geprüft.</translation>
    </message>
    <message>
      <source>Markers %1 and %2: you measured %3 mm, plate.json says %4 mm (%5 %); measure the plate&apos;s ruler and regenerate plate.json with &apos;ostraka plate --ruler-measured&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwischen den Marken %1 und %2 haben Sie %3 mm gemessen, nach plate.json sind es %4 mm (%5 %); das Lineal der Platte messen und plate.json mit 'ostraka plate --ruler-measured' neu erstellen.</translation>
    </message>
    <message>
      <source>Not usable: camera %1 misses the plate&apos;s markers by a median of %2 px; check that it did not move between the photographs and that plate.json belongs to this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nicht brauchbar: Kamera %1 verfehlt die Marken der Platte im Median um %2 px; prüfen, ob sie sich zwischen den Fotos nicht bewegt hat und ob plate.json zu dieser Platte gehört.</translation>
    </message>
    <message>
      <source>Not usable: the scale is wrong.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nicht brauchbar: Der Maßstab stimmt nicht.</translation>
    </message>
    <message>
      <source>Good: lenses, camera poses and scale are determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gut: Objektive, Lagen der Kameras und Maßstab sind bestimmt.</translation>
    </message>
    <message>
      <source>Usable for a trial only: the lens of camera %1 comes from the plate&apos;s markers alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nur für einen Versuch brauchbar: Das Objektiv von Kamera %1 folgt allein aus den Marken der Platte.</translation>
    </message>
    <message>
      <source>Usable, but a focal length is uncertain by more than a thousandth.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbar, aber eine Brennweite ist um mehr als ein Tausendstel unsicher.</translation>
    </message>
    <message>
      <source>Usable; the steps below improve it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbar; die Schritte unten verbessern es.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Brennweite %2 px (%3 %).</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Brennweite %2 px (%3 %), %4 Bilder der Tafel mit %5 px, das schlechteste %6 mit %7 px, bis %8 Grad geneigt.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), median error at the plate&apos;s markers %4 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Brennweite %2 px (%3 %), Fehler an den Marken der Platte %4 px im Median.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees, median error at the plate&apos;s markers %9 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Brennweite %2 px (%3 %), %4 Bilder der Tafel mit %5 px, das schlechteste %6 mit %7 px, bis %8 Grad geneigt, Fehler an den Marken der Platte %9 px im Median.</translation>
    </message>
    <message>
      <source>Camera %1: take 12 pictures of the board, near and far, in all corners of the picture, tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: 12 Bilder der Tafel aufnehmen, nah und fern, bis in alle Ecken des Bildes, um 20 bis 45 Grad in verschiedene Richtungen geneigt.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Nur 1 Bild zeigt die Tafel; mindestens 8 aufnehmen, besser 12.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Nur %2 Bilder zeigen die Tafel; mindestens 8 aufnehmen, besser 12.</translation>
    </message>
    <message>
      <source>Camera %1: the board barely reaches the %2 of the picture; add pictures with the board there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Die Tafel reicht kaum in diese Bereiche des Bildes: %2; Bilder mit der Tafel dort hinzufügen.</translation>
    </message>
    <message>
      <source>upper left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>oben links</translation>
    </message>
    <message>
      <source>upper middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>oben in der Mitte</translation>
    </message>
    <message>
      <source>upper right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>oben rechts</translation>
    </message>
    <message>
      <source>left middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mitte links</translation>
    </message>
    <message>
      <source>middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mitte</translation>
    </message>
    <message>
      <source>right middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mitte rechts</translation>
    </message>
    <message>
      <source>lower left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unten links</translation>
    </message>
    <message>
      <source>lower middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unten in der Mitte</translation>
    </message>
    <message>
      <source>lower right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>unten rechts</translation>
    </message>
    <message>
      <source>Camera %1: no picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Kein Bild zeigt die Tafel um mehr als 20 Grad geneigt; mindestens vier aufnehmen, zu verschiedenen Seiten geneigt.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Nur 1 Bild zeigt die Tafel um mehr als 20 Grad geneigt; mindestens vier aufnehmen, zu verschiedenen Seiten geneigt.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: Nur %2 Bilder zeigen die Tafel um mehr als 20 Grad geneigt; mindestens vier aufnehmen, zu verschiedenen Seiten geneigt.</translation>
    </message>
    <message>
      <source>Reprojection error %1 px over the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückprojektionsfehler %1 px über die Marken der Platte.</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: Die Marken %1 und %2, zur Kontrolle zurückgehalten, liegen %3 mm auseinander statt %4 (%5 mm, %6 %).</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, measured by hand as %3 mm between the midpoints of their outer edges, are %4 mm apart in the photographs (%5 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: Die Marken %1 und %2, von Hand %3 mm zwischen den Mitten ihrer Außenkanten, liegen in den Fotos %4 mm auseinander (%5 %).</translation>
    </message>
    <message>
      <source>Set aside: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Beiseitegelegt: %1</translation>
    </message>
    <message>
      <source>The lens is known but the camera poses are not, so no rig can be saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Objektiv ist bekannt, die Lagen der Kameras sind es nicht: Es lässt sich kein Messplatz speichern.</translation>
    </message>
    <message>
      <source>Not usable: the focal length is not determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nicht brauchbar: Die Brennweite ist nicht bestimmt.</translation>
    </message>
    <message>
      <source>Photograph the plate with its markers too: put one picture per camera and position into &apos;front&apos; (cam0_pos00.jpg and so on) next to plate.json, and the board&apos;s pictures into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auch die Platte mit ihren Marken aufnehmen: je Kamera und Position ein Bild nach 'front' legen (cam0_pos00.jpg und so weiter), neben plate.json, die Bilder der Tafel nach 'calib'.</translation>
    </message>
    <message>
      <source>Marker %1 of the known length is visible in fewer than two photographs; choose two markers of the plate that the photographs show.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marke %1 der bekannten Länge ist auf weniger als zwei Fotos zu sehen; zwei Marken der Platte wählen, die auf den Fotos sind.</translation>
    </message>
    <message>
      <source>A known length needs two different markers and a value greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine bekannte Länge braucht zwei verschiedene Marken und einen Wert größer als 0 mm.</translation>
    </message>
    <message>
      <source>Folder not found; choose one with photographs of the plate or of the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner nicht gefunden; einen mit Fotos der Platte oder der Tafel wählen.</translation>
    </message>
    <message>
      <source>The lens %1 is not known; it is 'standard' or 'fisheye'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Objektiv %1 ist nicht bekannt; es ist 'standard' oder 'fisheye'.</translation>
    </message>
    <message>
      <source>Numbers in 'dist': %1; a lens has 0, 4, 5, 8 or 12 in OpenCV's order, a fisheye has 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zahlen in 'dist': %1; ein Objektiv hat 0, 4, 5, 8 oder 12 in der Reihenfolge von OpenCV, ein Fischauge hat 4.</translation>
    </message>
    <message>
      <source>No lens has the numbers in 'dist': its picture folds near the middle. Check their order.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Objektiv hat die Zahlen in 'dist': sein Bild faltet sich nahe der Mitte. Ihre Reihenfolge prüfen.</translation>
    </message>
    <message>
      <source>The camera of '%1' has no valid K, R, t or size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera von '%1' hat kein gültiges K, R, t oder keine gültige Größe.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einem Bild fehlt file, width, height, K, R oder t.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einem Bild fehlt file, width, height, K, R oder t (%1).</translation>
    </message>
    <message>
      <source>The camera file has no list &apos;images&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kameradatei enthält keine Liste 'images'.</translation>
    </message>
    <message>
      <source>COLMAP&apos;s camera %1 has the model &apos;%2&apos; or values that Ostraka does not support; use the model OPENCV instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAPs Kamera %1 hat das Modell '%2' oder Werte, die Ostraka nicht unterstützt; stattdessen OPENCV nehmen.</translation>
    </message>
    <message>
      <source>COLMAP's model has no camera for the image '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAPs Modell hat keine Kamera für das Bild '%1'.</translation>
    </message>
    <message>
      <source>The file is damaged or not in COLMAP&apos;s format; run COLMAP again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei ist beschädigt oder nicht in COLMAPs Format; COLMAP noch einmal laufen lassen.</translation>
    </message>
    <message>
      <source>The pose of this photograph is estimated without its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Lage dieses Fotos wird ohne seine Maske geschätzt.</translation>
    </message>
    <message>
      <source>Without plate.json, poses come from COLMAP, which is not installed; install the package &apos;colmap&apos; or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ohne plate.json kommen die Lagen von COLMAP, das nicht installiert ist; das Paket 'colmap' installieren oder auf einer Markenplatte aufnehmen.</translation>
    </message>
    <message>
      <source>COLMAP found poses for %1 of %2 photographs, too few; provide masks or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP fand die Lage von %1 der %2 Fotos, zu wenige; Masken angeben oder auf einer Markenplatte aufnehmen.</translation>
    </message>
    <message>
      <source>The scale is wrong: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %); check that plate.json belongs to this plate, that the plate is printed and glued without distortion, and that a known rig was calibrated with it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Maßstab stimmt nicht: Die Marken %1 und %2, zur Kontrolle zurückgehalten, liegen %3 mm auseinander statt %4 (%5 mm, %6 %); prüfen, ob plate.json zu dieser Platte gehört, ob sie ohne Verzerrung gedruckt und aufgeklebt ist, und ob ein bekannter Messplatz mit ihr kalibriert wurde.</translation>
    </message>
    <message>
      <source>Relative to camera %1, camera %2 has moved by %3 mm and turned by %4 degrees since the rig was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gegenüber Kamera %1 hat sich Kamera %2 seit der Kalibrierung des Messplatzes um %3 mm verschoben und um %4 Grad gedreht.</translation>
    </message>
    <message>
      <source>%1: the board was not detected; the picture is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Die Tafel wurde nicht erkannt; das Bild wird beiseitegelegt.</translation>
    </message>
    <message>
      <source>The marker dictionary &apos;%1&apos; is unknown; use one such as DICT_4X4_100.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Markenwörterbuch '%1' ist unbekannt; eines wie DICT_4X4_100 nehmen.</translation>
    </message>
    <message>
      <source>The markers&apos; side must be between 5 and 200 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Seite der Marken muss zwischen 5 und 200 mm liegen.</translation>
    </message>
    <message>
      <source>The plate&apos;s diameter must be between 1 and 2000 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Durchmesser der Platte muss zwischen 1 und 2000 mm liegen.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf eine Platte von %2 mm passen weniger als sechs Marken von %1 mm; Marken von %3 mm passen darauf.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf eine Platte von %2 mm passen weniger als sechs Marken von %1 mm; die Platte größer machen.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marken von %1 mm lassen auf einer Platte von %2 mm keinen Platz für eine Scherbe; Marken von %3 mm passen darauf.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marken von %1 mm lassen auf einer Platte von %2 mm keinen Platz für eine Scherbe; die Platte größer machen.</translation>
    </message>
    <message>
      <source>The printer&apos;s margin must be between 0 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Rand des Druckers muss zwischen 0 und 40 mm liegen.</translation>
    </message>
    <message>
      <source>The sheets&apos; overlap must be between 5 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Überlappung der Bögen muss zwischen 5 und 40 mm liegen.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Wörterbuch %1 hat zu wenige Marken für diese Platte.</translation>
    </message>
    <message>
      <source>The measured ruler length must be in mm and within the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die gemessene Länge des Lineals muss in mm sein und auf die Platte passen.</translation>
    </message>
    <message>
      <source>The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. Print the file at 100 %, without &apos;fit to page&apos;, and measure again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Lineal dieser Platte ist %1 mm lang gezeichnet, %2 mm weicht um mehr als ein Zehntel ab; die Datei mit 100 % drucken, ohne 'An Seite anpassen', und noch einmal messen.</translation>
    </message>
    <message>
      <source>Camera %1 has a covariance of the wrong size; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 hat eine Kovarianz falscher Größe; den Messplatz neu kalibrieren.</translation>
    </message>
    <message>
      <source>Another version of Ostraka wrote this rig; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine andere Version von Ostraka hat diesen Messplatz geschrieben; ihn neu kalibrieren.</translation>
    </message>
    <message>
      <source>Camera %1 appears twice in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 steht zweimal im Messplatz.</translation>
    </message>
    <message>
      <source>The rig has more than %1 positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz hat mehr als %1 Positionen; ihn neu kalibrieren.</translation>
    </message>
    <message>
      <source>Position %1 appears twice in the rig; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Position %1 steht zweimal im Messplatz; ihn neu kalibrieren.</translation>
    </message>
    <message>
      <source>The rig&apos;s lengths are not in mm; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Längen des Messplatzes sind nicht in mm; ihn neu kalibrieren.</translation>
    </message>
    <message>
      <source>Camera %1 has pictures of %2 x %3 pixels, which no camera takes; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 hat Bilder von %2 x %3 Pixeln, wie sie keine Kamera aufnimmt; den Messplatz neu kalibrieren.</translation>
    </message>
    <message>
      <source>Not a rig file (RIG.json); recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist keine Messplatzdatei (RIG.json); den Messplatz neu kalibrieren.</translation>
    </message>
    <message>
      <source>The rig has no camera; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz hat keine Kamera; ihn neu kalibrieren.</translation>
    </message>
    <message>
      <source>This file already exists and is not a rig; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei gibt es schon, und sie ist kein Messplatz; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>The log cannot be written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Protokoll lässt sich nicht schreiben.</translation>
    </message>
    <message>
      <source>A process cannot be started.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es lässt sich kein Prozess starten.</translation>
    </message>
    <message>
      <source>The program&apos;s exit status is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Endstatus des Programms ist unbekannt.</translation>
    </message>
    <message>
      <source>The program cannot be started; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm lässt sich nicht starten; es installieren.</translation>
    </message>
    <message>
      <source>%1 ended with an error; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 endete mit einem Fehler; seine Ausgabe steht in dieser Datei.</translation>
    </message>
    <message>
      <source>A small object of %1 mm at x %2, y %3 mm was left out; if it is a sherd, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Krümel von %1 mm bei x %2, y %3 mm wurde ausgelassen; wenn es eine Scherbe ist, sie allein aufnehmen.</translation>
    </message>
    <message>
      <source>A flat object at x %1, y %2 mm was left out; it may be a marker or dirt on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein flacher Gegenstand bei x %1, y %2 mm wurde ausgelassen; er kann eine Marke oder Schmutz auf der Platte sein.</translation>
    </message>
    <message>
      <source>Two sherds touch at x %1, y %2 mm and were split there; leave a finger&apos;s width between sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Scherben berühren sich bei x %1, y %2 mm und wurden dort getrennt; zwischen Scherben einen Finger breit Abstand lassen.</translation>
    </message>
    <message>
      <source>The plate&apos;s point cloud has no normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Punktwolke der Platte hat keine Normalen.</translation>
    </message>
    <message>
      <source>No sherd was found on the front side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf der Vorderseite wurde keine Scherbe gefunden; ihre Masken und Fotos prüfen.</translation>
    </message>
    <message>
      <source>No sherd was found on the back side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf der Rückseite wurde keine Scherbe gefunden; ihre Masken und Fotos prüfen.</translation>
    </message>
    <message>
      <source>This COLMAP was built without CUDA, which its dense stereo needs; install one with CUDA, or use --dense builtin, which needs neither.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses COLMAP wurde ohne CUDA gebaut, das seine Stereoberechnung braucht; eines mit CUDA installieren oder --dense builtin nehmen, das keines von beiden braucht.</translation>
    </message>
    <message>
      <source>The masks of the views show no common object; check masks, cameras and bounds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Masken der Ansichten zeigen keinen gemeinsamen Gegenstand; Masken, Kameras und Grenzen prüfen.</translation>
    </message>
    <message>
      <source>InterfaceCOLMAP wrote no scene; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>InterfaceCOLMAP schrieb keine Szene; seine Ausgabe steht in dieser Datei.</translation>
    </message>
    <message>
      <source>Stereo needs at least 3 photographs with known cameras.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für die Stereoberechnung sind mindestens 3 Fotos mit bekannten Kameras nötig.</translation>
    </message>
    <message>
      <source>The photograph or its mask differs in size from its camera&apos;s images; use photographs of the size that the camera was calibrated with.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Foto oder seine Maske hat eine andere Größe als die Bilder seiner Kamera; Fotos der Größe nehmen, mit der die Kamera kalibriert wurde.</translation>
    </message>
    <message>
      <source>The photograph differs in size from the images that its camera was calibrated with; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Foto hat eine andere Größe als die Bilder, mit denen seine Kamera kalibriert wurde; das Originalfoto nehmen.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Maske hat eine andere Größe als ihr Foto.</translation>
    </message>
    <message>
      <source>%1 found no points of the object; its output is in this file, and --dense builtin needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 fand keine Punkte des Gegenstands; seine Ausgabe steht in dieser Datei, und --dense builtin braucht kein anderes Programm.</translation>
    </message>
    <message>
      <source>%1 wrote points without normals; install a newer version, or use --dense builtin.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 schrieb Punkte ohne Normalen; eine neuere Version installieren oder --dense builtin nehmen.</translation>
    </message>
    <message>
      <source>The program %1 is not on the PATH, but --dense %2 needs it; install it, or use --dense builtin, which needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm %1 ist nicht im PATH, aber --dense %2 braucht es; es installieren oder --dense builtin nehmen, das kein anderes Programm braucht.</translation>
    </message>
    <message>
      <source>No two views agree on any surface point; check cameras and masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine zwei Ansichten stimmen in einem Punkt der Oberfläche überein; Kameras und Masken prüfen.</translation>
    </message>
    <message>
      <source>The %1 sherds do not fit on the plate; use fewer, or another seed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die %1 Scherben passen nicht auf die Platte; weniger verlangen oder einen anderen Startwert nehmen.</translation>
    </message>
    <message>
      <source>sherds must be between 1 and 40.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zahl der Scherben muss zwischen 1 und 40 liegen.</translation>
    </message>
    <message>
      <source>width must be between 160 and 8192 pixels and divisible by 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Breite muss zwischen 160 und 8192 Pixeln liegen und durch 4 teilbar sein.</translation>
    </message>
    <message>
      <source>near_duplicates are groups of two: at most half the number of sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>near_duplicates sind Zweiergruppen: höchstens halb so viele wie Scherben.</translation>
    </message>
    <message>
      <source>The rig needs a camera and at least four positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Messplatz braucht eine Kamera und mindestens vier Positionen; ihn neu kalibrieren.</translation>
    </message>
    <message>
      <source>The virtual camera has no setting %1 of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die virtuelle Kamera hat keine Einstellung %1 mit dem Wert %2.</translation>
    </message>
    <message>
      <source>The camera has taken no photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Kamera hat kein Foto aufgenommen.</translation>
    </message>
    <message>
      <source>COLMAP cannot align these photographs; its output is in this file. Check that all show the same sherds with large overlap, or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP kann diese Fotos nicht ausrichten; seine Ausgabe steht in dieser Datei. Prüfen, ob alle dieselben Scherben mit viel Überlappung zeigen, oder auf einer Markenplatte aufnehmen.</translation>
    </message>
    <message>
      <source>This model is missing; reprocess its batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Modell fehlt; seinen Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>This sherd is void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Scherbe ist ungültig.</translation>
    </message>
    <message>
      <source>This sherd is void; reason: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Scherbe ist ungültig; Grund: %1</translation>
    </message>
    <message>
      <source>%1 is void and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist ungültig und wurde ausgelassen.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %); check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die als Lippe angenommene Kante sieht kaum danach aus (%1 %); die Ausrichtung der Scherbe prüfen.</translation>
    </message>
    <message>
      <source>Ø %1 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm</translation>
    </message>
    <message>
      <source>Ø %1 cm (95 %: %2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm (95 %: %2 bis %3)</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 % des Randes erhalten</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 % des Randes erhalten (%2 bis %3)</translation>
    </message>
    <message>
      <source>wall %1 mm (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wandung %1 mm (%2 bis %3)</translation>
    </message>
    <message>
      <source>wall %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wandung %1 mm</translation>
    </message>
    <message>
      <source>A bag belongs to a context; enter the context first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Beutel gehört zu einem Befund; zuerst den Befund eingeben.</translation>
    </message>
    <message>
      <source>Context %1 has no bag %2; change or clear the bag at the same time.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Befund %1 hat keinen Beutel %2; den Beutel zugleich ändern oder leeren.</translation>
    </message>
    <message>
      <source>There is no bag %1 in context %2 yet; enter it during capture or import a table of contexts that contains it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einen Beutel %1 gibt es im Befund %2 noch nicht; ihn bei der Aufnahme eingeben oder eine Tabelle der Befunde mit ihm importieren.</translation>
    </message>
    <message>
      <source>The edge taken as the lip may be a fracture (%1 % that it is the lip), and the diameter may be wrong; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die als Lippe angenommene Kante kann ein Bruch sein (%1 %, dass es die Lippe ist) und der Durchmesser falsch; die Ausrichtung der Scherbe prüfen.</translation>
    </message>
    <message>
      <source>This batch is still being photographed; it is processed afterwards.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang wird gerade aufgenommen; er wird danach verarbeitet.</translation>
    </message>
    <message>
      <source>Joins with sherds that are not in the export or were not imported are left out: %1; enter them by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anpassungen an Scherben, die nicht im Export sind oder nicht importiert wurden, sind ausgelassen: %1; von Hand eintragen.</translation>
    </message>
    <message>
      <source>'%1' can be read as %2 or as %3; write one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>„%1“ lässt sich als %2 oder als %3 lesen; eines von beiden schreiben.</translation>
    </message>
    <message>
      <source>The batch is not fully processed; let the queue process it, then review its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Durchgang ist nicht fertig verarbeitet; ihn von der Warteschlange verarbeiten lassen, dann seine Paare prüfen.</translation>
    </message>
    <message>
      <source>%1 was retaken after its mask was edited; the strokes on the earlier photograph are left out. Check its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wurde noch einmal aufgenommen, nachdem die Maske bearbeitet war; die Striche auf dem früheren Foto sind ausgelassen. Die Maske prüfen.</translation>
    </message>
    <message>
      <source>Joins with rows that were not imported are left out: %1; correct these rows, then import the table again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anpassungen an Zeilen, die nicht importiert wurden, sind ausgelassen: %1; diese Zeilen berichtigen, dann die Tabelle noch einmal importieren.</translation>
    </message>
    <message>
      <source>The sherd has a void_reason, so it is void; write void here, or %1 under void_reason.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherbe hat einen void_reason und ist also ungültig; hier void eintragen oder %1 unter void_reason.</translation>
    </message>
    <message>
      <source>A sherd is void only with a reason; write it under void_reason, or correct the state.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe ist nur mit einem Grund ungültig; ihn unter void_reason eintragen oder den Zustand berichtigen.</translation>
    </message>
    <message>
      <source>The state must be draft, numbered or void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Zustand muss draft, numbered oder void sein.</translation>
    </message>
    <message>
      <source>Rows that are not imported leave their numbers free: %1; correct and import them before you assign new numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeilen, die nicht importiert werden, lassen ihre Nummern frei: %1; sie berichtigen und importieren, bevor neue Nummern vergeben werden.</translation>
    </message>
    <message>
      <source>The number %1 was entered for a sherd of %2, which is not processed yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 wurde für eine Scherbe des Durchgangs %2 eingegeben, der noch nicht verarbeitet ist.</translation>
    </message>
    <message>
      <source>A sheet of an earlier drawing already exists and is not overwritten; choose another name, or delete that sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Blatt einer früheren Zeichnung ist da und wird nicht überschrieben; einen anderen Namen wählen oder jenes Blatt löschen.</translation>
    </message>
    <message>
      <source>Enter a number after =.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nach = eine Nummer eingeben.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist ein Ordner, keine Datei; eine Datei wählen.</translation>
    </message>
    <message>
      <source>This is a pipe, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist eine Pipe, keine Datei; eine Datei wählen.</translation>
    </message>
    <message>
      <source>This is a socket, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist ein Socket, keine Datei; eine Datei wählen.</translation>
    </message>
    <message>
      <source>This is a device, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist ein Gerät, keine Datei; eine Datei wählen.</translation>
    </message>
    <message>
      <source>A link has taken the place of this folder&apos;s lock file; delete the link.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Link hat den Platz der Sperrdatei dieses Ordners eingenommen; den Link löschen.</translation>
    </message>
    <message>
        <source>A link has taken the place of a folder of a project or of a result; what it leads to was not touched. Delete the link, or move the folder itself here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ein Link steht an der Stelle eines Ordners, der zu einem Projekt oder einem Ergebnis gehört; worauf er zeigt, blieb unberührt. Löschen Sie den Link, oder verschieben Sie den Ordner selbst hierher.</translation>
    </message>
    <message>
      <source>No temporary folder can be created here (%1); free some space, or set TMPDIR to another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hier lässt sich kein temporärer Ordner anlegen (%1); Platz schaffen oder TMPDIR auf einen anderen Ordner setzen.</translation>
    </message>
    <message>
      <source>The JSON contains &apos;%1&apos; twice in one object; delete one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das JSON enthält „%1“ zweimal in einem Objekt; eines von beiden löschen.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a whole number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>„%1“ muss eine ganze Zahl von %2 bis %3 sein; sie berichtigen.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>„%1“ muss eine Zahl von %2 bis %3 sein; sie berichtigen.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>„%1“ muss eine Zahl sein; sie berichtigen.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is mirrored: its corners run counter-clockwise as seen from above; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marke %1 der Platte ist gespiegelt: ihre Ecken laufen von oben gesehen gegen den Uhrzeigersinn; die Plattendatei neu erzeugen.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is not convex; list its corners in order along its edge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marke %1 der Platte ist nicht konvex; ihre Ecken der Reihe nach am Rand entlang nennen.</translation>
    </message>
    <message>
      <source>The markers %1 and %2 of the plate overlap; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Marken %1 und %2 der Platte überlappen sich; die Plattendatei neu erzeugen.</translation>
    </message>
    <message>
      <source>The board&apos;s markers must be smaller than its squares; correct &apos;marker_mm&apos; or &apos;square_mm&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Marken der Tafel müssen kleiner als ihre Felder sein; „marker_mm“ oder „square_mm“ berichtigen.</translation>
    </message>
    <message>
      <source>A face of the PLY file has more than %1 corners; export the file again as triangles.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Fläche der PLY-Datei hat mehr als %1 Ecken; sie als Dreiecke neu exportieren.</translation>
    </message>
    <message>
      <source>The PLY file has more than %1 of '%2'; export it with fewer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die PLY-Datei hat mehr als %1 von „%2“; sie mit weniger exportieren.</translation>
    </message>
    <message>
      <source>A link or a file has taken the place of a folder, or a link that of a file; replace it with the folder or the file itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Link oder eine Datei hat den Platz eines Ordners eingenommen, oder ein Link den einer Datei; durch den Ordner oder die Datei selbst ersetzen.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Datei dieses Namens gibt es schon; sie wird nicht überschrieben. Einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>The export names a location in the project where no such file belongs; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Export nennt einen Ort im Projekt, an den keine solche Datei gehört; nichts wurde importiert.</translation>
    </message>
    <message>
      <source>The archive contains a journal of its catalogue, which an Ostraka archive never contains; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Archiv enthält ein Journal seines Katalogs, was kein Archiv von Ostraka tut; nichts wurde geschrieben.</translation>
    </message>
    <message>
      <source>The catalogue&apos;s tables, indexes or triggers differ from those that Ostraka creates; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tabellen, Indizes und Trigger des Katalogs sind nicht so, wie Ostraka sie anlegt; nichts wurde geschrieben.</translation>
    </message>
    <message>
      <source>The output folder is gone: it was moved or deleted while Ostraka was writing to it. The photographs are untouched; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ausgabeordner ist weg: Er wurde verschoben oder gelöscht, während Ostraka hineinschrieb. Die Fotos sind unberührt; denselben Befehl noch einmal starten.</translation>
    </message>
    <message>
      <source>The folder already contains files; choose a new or empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ordner enthält schon Dateien; einen neuen oder leeren wählen.</translation>
    </message>
    <message>
      <source>This location belongs to the archive or export &apos;%1&apos;, which new files would make invalid; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ort gehört zum Archiv oder Export „%1“, den neue Dateien ungültig machen würden; einen Ort außerhalb wählen.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ort gehört zum Projekt „%1“; einen Ort außerhalb wählen.</translation>
    </message>
    <message>
      <source>The name of this output must end in %1; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Name dieser Ausgabedatei muss auf %1 enden; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das ist ein Ordner, keine Datei; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>This output is one of the input files, which it would overwrite; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ausgabe ist eine der Eingabedateien und würde sie überschreiben; einen anderen Namen wählen.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a folder directly in &apos;%2&apos;, or one outside the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ort gehört zum Projekt „%1“; einen Ordner direkt in „%2“ wählen oder einen außerhalb des Projekts.</translation>
    </message>
    <message>
      <source>This file describes another plate, or this plate with another ruler length; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei beschreibt eine andere Platte, oder diese Platte mit anderer Länge des Lineals; einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>This file describes another calibration board; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei beschreibt eine andere Kalibriertafel; einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>This folder contains photographs, and a new plate.json would describe the sheet under their sherds; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ordner sind Fotos, und eine neue plate.json würde das Blatt unter ihren Scherben beschreiben; einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>This folder is a mount point or the current folder; choose a new folder inside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner ist ein Einhängepunkt oder der aktuelle Ordner; einen neuen Ordner darin wählen.</translation>
    </message>
    <message>
      <source>This folder is needed for unfinished files but contains others; move it elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner wird für unfertige Dateien gebraucht, enthält aber andere; ihn woandershin verschieben.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the front side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Gegenstand von %1 % der Länge der üblichen Scherbe wurde auf der Vorderseite ausgelassen; ohne Maßstab kann es eine Scherbe sein.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the back side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Gegenstand von %1 % der Länge der üblichen Scherbe wurde auf der Rückseite ausgelassen; ohne Maßstab kann es eine Scherbe sein.</translation>
    </message>
    <message>
      <source>The photographs of the front side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Fotos der Vorderseite stimmen nur auf %1 % dessen überein, was ihre Masken zeigen; ihre Scans können daher falsch sein. Die Masken prüfen, und ob sich während der Aufnahmen nichts bewegt hat.</translation>
    </message>
    <message>
      <source>The photographs of the back side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Fotos der Rückseite stimmen nur auf %1 % dessen überein, was ihre Masken zeigen; ihre Scans können daher falsch sein. Die Masken prüfen, und ob sich während der Aufnahmen nichts bewegt hat.</translation>
    </message>
    <message>
      <source>All photographs look at the sheet from straight above, so heights and wall thicknesses are uncertain and broken edges are hardly seen. Add photographs from the side, tilted by 30 to 60 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle Fotos blicken senkrecht von oben auf das Blatt; daher sind Höhen und Wandstärken ungewiss, und Bruchkanten sind kaum zu sehen. Fotos von der Seite hinzufügen, um 30 bis 60 Grad geneigt.</translation>
    </message>
    <message>
      <source>If it is one, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ist es eine, sie allein aufnehmen.</translation>
    </message>
    <message>
        <source>The catalogue is damaged (%1); nothing was changed, and no backup was deleted. Restore it with 'ostraka catalogue repair PROJECT'.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Katalog ist beschädigt (%1); nichts wurde geändert und keine Sicherung gelöscht. Stellen Sie ihn mit „ostraka catalogue repair PROJECT“ wieder her.</translation>
    </message>
    <message>
        <source>a page was changed</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>eine Seite wurde verändert</translation>
    </message>
    <message>
        <source>it is a backup, but the -wal file beside it belongs to the catalogue that it replaced</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>er ist eine Sicherung, aber die -wal-Datei daneben gehört zu dem Katalog, den sie ersetzt hat</translation>
    </message>
    <message>
        <source>its repair was interrupted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>seine Reparatur wurde unterbrochen</translation>
    </message>
    <message>
        <source>its pages are inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>seine Seiten widersprechen sich</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file is not a database</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>die Datei ist keine Datenbank</translation>
    </message>
    <message>
        <source>the file belongs to another program</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>die Datei gehört zu einem anderen Programm</translation>
    </message>
    <message>
        <source>the file contains no catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>die Datei enthält keinen Katalog</translation>
    </message>
    <message>
        <source>the header is inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>der Kopf der Datei widerspricht sich</translation>
    </message>
    <message>
        <source>it contains no project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>er enthält kein Projekt</translation>
    </message>
    <message>
        <source>The catalogue cannot be read; check that it exists and check its permissions.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Katalog lässt sich nicht lesen; prüfen, ob er vorhanden ist, und seine Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>This project is read-only, and there is no space for the copy that Ostraka reads; free some space in the folder for temporary files.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dieses Projekt kann nur gelesen werden, und für die Kopie, die Ostraka liest, fehlt der Platz; im Ordner für temporäre Dateien Platz schaffen.</translation>
    </message>
    <message>
        <source>An older Ostraka made this project, and it is read-only here; copy it to a folder that you can write to, and open it there.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dieses Projekt stammt von einem älteren Ostraka und kann hier nur gelesen werden; kopieren Sie es in einen Ordner, in den Sie schreiben dürfen, und öffnen Sie es dort.</translation>
    </message>
    <message>
        <source>The catalogue is damaged, and none of its backups is intact; copy one from an archive or another disk into the folder backups, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Katalog ist beschädigt, und keine seiner Sicherungen ist unversehrt; eine aus einem Archiv oder von einem anderen Datenträger in den Ordner backups kopieren und ihn dann noch einmal reparieren.</translation>
    </message>
    <message>
        <source>Another program has this project open; close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ein anderes Programm hat dieses Projekt geöffnet; schließen Sie es dort und reparieren Sie es dann.</translation>
    </message>
    <message>
        <source>%1 rows in total, %2 read; run the same import again for the others.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 Zeilen insgesamt, %2 gelesen; für die übrigen denselben Import noch einmal ausführen.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; means the same as &apos;%2&apos;; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Spalte &apos;%1&apos; bedeutet dasselbe wie &apos;%2&apos;; ihre Werte werden als eigenes Feld behalten.</translation>
    </message>
    <message>
      <source>Check the drawing of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Zeichnung von %1 prüfen: %2</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherbe %1 von %2</translation>
    </message>
    <message>
      <source>camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: %2</translation>
    </message>
    <message>
      <source>%1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 und %2</translation>
    </message>
    <message>
      <source>Camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: %2</translation>
    </message>
    <message>
      <source>The focal length is not determined: %1 px with a standard deviation of %2 px; take more pictures, closer and with the board tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Brennweite ist nicht bestimmt: %1 px mit einer Standardabweichung von %2 px; mehr Bilder aufnehmen, näher und mit der Tafel um 20 bis 45 Grad in verschiedene Richtungen geneigt.</translation>
    </message>
    <message>
      <source>No picture shows the board tilted by more than 15 degrees; tilt it more to separate focal length from distance.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Bild zeigt die Tafel um mehr als 15 Grad geneigt; sie stärker neigen, damit sich Brennweite und Entfernung unterscheiden lassen.</translation>
    </message>
    <message>
      <source>The corners scatter by %1 px, more than the 0.3 px of sharp pictures of a flat board; check focus, lighting and the board's flatness.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Ecken streuen um %1 px, mehr als die 0,3 px scharfer Bilder einer ebenen Tafel; Fokus, Licht und Ebenheit der Tafel prüfen.</translation>
    </message>
    <message>
      <source>The worst picture is %1 with %2 px; retake it or leave it out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das schlechteste Bild ist %1 mit %2 px; noch einmal aufnehmen oder weglassen.</translation>
    </message>
    <message>
      <source>Calibration pictures that show the board: %1; at least 3 are needed. Take more pictures of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kalibrierbilder, auf denen die Tafel zu sehen ist: %1; mindestens 3 sind nötig. Weitere Bilder von ihr aufnehmen.</translation>
    </message>
    <message>
      <source>Camera %1, position %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, Position %2: %3.</translation>
    </message>
    <message>
      <source>%1 poses are given for %2 photographs; give one pose for each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Für %2 Fotos sind %1 Lagen angegeben; für jedes genau eine angeben.</translation>
    </message>
    <message>
      <source>its front no longer has a back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seine Vorderseite hat keine Rückseite mehr</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about ten times the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einheit prüfen: %1 ist etwa das Zehnfache des berechneten Werts.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about a tenth of the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Einheit prüfen: %1 ist etwa ein Zehntel des berechneten Werts.</translation>
    </message>
    <message>
      <source>Check the value: %1 differs from the computed value by a factor of three or more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wert prüfen: %1 weicht mindestens um das Dreifache vom berechneten Wert ab.</translation>
    </message>
    <message>
      <source>Check the values: %1 (%2) is below %3 (%4).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Werte prüfen: %1 (%2) liegt unter: %3 (%4).</translation>
    </message>
    <message>
      <source>The computed value is %1. Delete it?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der berechnete Wert ist %1. Löschen?</translation>
    </message>
    <message>
      <source>The computed value is %1. Replace it with the measured value?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der berechnete Wert ist %1. Durch den gemessenen ersetzen?</translation>
    </message>
    <message>
      <source>the length</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Länge</translation>
    </message>
    <message>
      <source>the width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Breite</translation>
    </message>
    <message>
      <source>the minimum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die kleinste Dicke</translation>
    </message>
    <message>
      <source>the maximum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die größte Dicke</translation>
    </message>
    <message>
      <source>the thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>die Dicke</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate&apos;s markers are visible.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherben konnten nicht gezählt werden: zu wenige Marken der Platte sind zu sehen.</translation>
    </message>
    <message>
      <source>No sherd is visible on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf der Platte ist keine Scherbe zu sehen.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate&apos;s centre: move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben berühren sich fast oder ganz bei %1 von der Mitte der Platte: auseinanderrücken und neu aufnehmen.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate&apos;s centre was counted as one but may be two touching sherds: check it; if so, move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was bei %1 von der Mitte der Platte liegt, wurde als eine gezählt, kann aber zwei Scherben sein, die sich berühren: dort nachsehen; wenn ja, auseinanderrücken und neu aufnehmen.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and reshoot them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Rückseite sieht aus wie die Vorderseite: die Scherben umdrehen und neu aufnehmen.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherben der Rückseite konnten nicht gezählt werden: die Bilder vergleichen, bevor die Platte abgeräumt wird.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Scherben der Vorderseite konnten nicht gezählt werden: die Bilder vergleichen, bevor die Platte abgeräumt wird.</translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Find the missing ones before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gezählte Scherben auf der Vorderseite: %1, auf der Rückseite: %2. Die fehlenden suchen, bevor die Platte abgeräumt wird.</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Check whether one was added or broke.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gezählte Scherben auf der Vorderseite: %1, auf der Rückseite: %2. Prüfen, ob eine hinzukam oder zerbrach.</translation>
    </message>
    <message>
      <source>The turntable&apos;s own count was %1 degrees off; it was corrected from the plate&apos;s markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die eigene Zählung des Drehtischs lag um %1 Grad daneben; sie wurde anhand der Marken der Platte berichtigt.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Ostraka-Projekt: in diesem Ordner liegt keine catalogue.sqlite; nichts wurde zusammengeführt.</translation>
    </message>
    <message>
      <source>Another version of Ostraka made this project; nothing was merged. Open it once with this version, which updates it, or install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine andere Version von Ostraka hat dieses Projekt angelegt; nichts wurde zusammengeführt. Das Projekt einmal mit dieser Version öffnen, die es aktualisiert, oder die neuere Version installieren.</translation>
    </message>
    <message>
      <source>A project cannot be merged with itself; name another project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Projekt kann nicht mit sich selbst zusammengeführt werden; ein anderes Projekt nennen.</translation>
    </message>
    <message>
      <source>This project is read-only here, so nothing was merged; copy it to a folder that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt ist hier nur lesbar, deshalb wurde nichts zusammengeführt; es in einen Ordner kopieren, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
      <source>The project changed while files were copied, so nothing was merged; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Projekt hat sich geändert, während Dateien kopiert wurden, deshalb wurde nichts zusammengeführt; denselben Befehl noch einmal ausführen.</translation>
    </message>
    <message>
      <source>The conflict %1 (%2) cannot be settled with &apos;%3&apos;; nothing was merged. Choose one of the ways that the list of conflicts offers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Konflikt %1 (%2) lässt sich nicht mit „%3“ lösen; nichts wurde zusammengeführt. Eine der Möglichkeiten wählen, die die Liste der Konflikte nennt.</translation>
    </message>
    <message>
      <source>This file must be a JSON list of {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} or {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;}; nothing was merged. Correct the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei muss eine JSON-Liste aus {&quot;id&quot;: &quot; …&quot;, &quot;take&quot;: &quot;a&quot;} oder {&quot;id&quot;: &quot; …&quot;, &quot;number&quot;: &quot; …&quot;} sein; nichts wurde zusammengeführt. Die Datei berichtigen.</translation>
    </message>
    <message>
      <source>The conflict %1 is settled twice in this file; nothing was merged. Keep one of the two entries.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Konflikt %1 wird in dieser Datei zweimal gelöst; nichts wurde zusammengeführt. Einen der beiden Einträge behalten.</translation>
    </message>
    <message>
      <source>This file of project B differs from what its catalogue records; nothing was merged. Restore it from a copy (&apos;ostraka catalogue check&apos; lists all such files).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei von Projekt B weicht von dem ab, was dessen Katalog verzeichnet; nichts wurde zusammengeführt. Sie aus einer Kopie wiederherstellen („ostraka catalogue check“ nennt alle solchen Dateien).</translation>
    </message>
    <message>
      <source>The disk does not return what was written to it; nothing was merged. Check the disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger gibt nicht zurück, was auf ihn geschrieben wurde; nichts wurde zusammengeführt. Den Datenträger prüfen.</translation>
    </message>
    <message>
      <source>A link or a device cannot be merged; nothing was merged. Move what it leads to into project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Verknüpfung oder ein Gerät kann nicht zusammengeführt werden; nichts wurde zusammengeführt. Das, worauf sie verweist, in Projekt B verschieben.</translation>
    </message>
    <message>
      <source>Results from a cluster must be regular files with plain names; nothing of this batch was entered. Submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ergebnisse eines Clusters müssen gewöhnliche Dateien mit einfachen Namen sein; von diesem Durchgang wurde nichts eingetragen. Den Durchgang noch einmal einreichen.</translation>
    </message>
    <message>
      <source>This batch was processed here or reshot in the meantime; the cluster&apos;s results are not entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang wurde inzwischen hier verarbeitet oder neu aufgenommen; die Ergebnisse des Clusters werden nicht eingetragen.</translation>
    </message>
    <message>
      <source>The name of a partition or an account consists of letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;; look it up with &apos;sinfo&apos; or ask the cluster&apos;s administrators.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Name einer Partition oder eines Kontos besteht aus Buchstaben, Ziffern, „-“, „_“ und „.“; ihn mit „sinfo“ nachsehen oder bei der Verwaltung des Clusters erfragen.</translation>
    </message>
    <message>
      <source>The command that starts Ostraka on the cluster must be one line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Befehl, der Ostraka auf dem Cluster startet, muss eine einzige Zeile sein.</translation>
    </message>
    <message>
      <source>A job needs at least one core, and its memory and time must not be negative.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Auftrag braucht mindestens einen Kern, und sein Speicher und seine Zeit dürfen nicht negativ sein.</translation>
    </message>
    <message>
      <source>This folder cannot be opened (%1); check its name and permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner lässt sich nicht öffnen (%1); seinen Namen und seine Rechte prüfen.</translation>
    </message>
    <message>
      <source>The path of this project contains a character that has a special meaning for Slurm (%, a backslash or a control character); rename the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Pfad dieses Projekts enthält ein Zeichen, das für Slurm eine besondere Bedeutung hat (%, ein umgekehrter Schrägstrich oder ein Steuerzeichen); den Ordner umbenennen.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH; run this command on a login node of the cluster, or name one with --host USER@LOGIN:/FOLDER.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm %1 ist nicht im PATH dieses Rechners; diesen Befehl auf einem Anmeldeknoten des Clusters ausführen oder einen mit --host USER@LOGIN:/FOLDER nennen.</translation>
    </message>
    <message>
      <source>Not a folder on a cluster; write USER@LOGIN:/FOLDER, with the folder&apos;s full path and without spaces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Ordner auf einem Cluster; USER@LOGIN:/FOLDER schreiben, mit dem vollständigen Pfad des Ordners und ohne Leerzeichen.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH, but --host needs it; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm %1 ist nicht im PATH dieses Rechners, --host braucht es aber; es installieren.</translation>
    </message>
    <message>
      <source>The program %1 cannot be started there; ask the cluster&apos;s administrators how Slurm is reached.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm %1 lässt sich dort nicht starten; bei der Verwaltung des Clusters erfragen, wie Slurm erreichbar ist.</translation>
    </message>
    <message>
      <source>%1 failed (%2). Nothing is lost; once the cause is removed, run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist gescheitert (%2). Nichts ist verloren; sobald die Ursache behoben ist, denselben Befehl noch einmal ausführen.</translation>
    </message>
    <message>
      <source>This batch contains imported scans and is not submitted; the window&apos;s queue processes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang enthält importierte Scans und wird nicht eingereicht; die Warteschlange des Fensters verarbeitet ihn.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk has %1 GB left, but the batches to submit (%2) need about %3 GB. Nothing was submitted; free some space, or submit fewer with --most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Auf dem Datenträger des Clusters sind noch %1 GB frei, die einzureichenden Durchgänge (%2) brauchen aber etwa %3 GB. Nichts wurde eingereicht; Platz schaffen oder mit --most weniger einreichen.</translation>
    </message>
    <message>
      <source>Batches of this project are on another cluster or in another folder; collect them before you submit to this one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchgänge dieses Projekts sind auf einem anderen Cluster oder in einem anderen Ordner; sie einsammeln, bevor Sie hier einreichen.</translation>
    </message>
    <message>
      <source>Not a list of the batches on a cluster; restore an earlier one, or delete it: batches that are on the cluster are then processed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Liste der Durchgänge auf einem Cluster; eine frühere wiederherstellen oder die Datei löschen: Durchgänge auf dem Cluster werden dann noch einmal verarbeitet.</translation>
    </message>
    <message>
      <source>Out of memory (%1 MB requested); the next submission requests twice as much.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Speicher aufgebraucht (%1 MB angefordert); beim nächsten Einreichen wird doppelt so viel angefordert.</translation>
    </message>
    <message>
      <source>Out of time (minutes requested: %1); the next submission requests twice as many and resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeit abgelaufen (angeforderte Minuten: %1); beim nächsten Einreichen werden doppelt so viele angefordert, und es geht nach dem letzten vollständigen Schritt weiter.</translation>
    </message>
    <message>
      <source>The node failed, or the job was killed; the next submission resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Knoten ist ausgefallen, oder der Auftrag wurde abgebrochen; beim nächsten Einreichen geht es nach dem letzten vollständigen Schritt weiter.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk is full, or your quota is used up; free some space, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Datenträger des Clusters ist voll, oder Ihr Kontingent ist aufgebraucht; Platz schaffen, dann noch einmal einreichen.</translation>
    </message>
    <message>
      <source>The cluster does not know this job, and the job wrote nothing into the project&apos;s folder; check that the cluster&apos;s nodes see that folder, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Cluster kennt diesen Auftrag nicht, und der Auftrag hat nichts in den Ordner des Projekts geschrieben; prüfen, ob die Knoten des Clusters diesen Ordner sehen, dann noch einmal einreichen.</translation>
    </message>
    <message>
      <source>The program ended with status %1; its output is in %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Programm endete mit dem Status %1; seine Ausgabe steht in %2.</translation>
    </message>
    <message>
      <source>The partition ends jobs earlier than the %1 minutes requested; cancel the job, then submit again with another --partition or fewer --minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Partition beendet Aufträge vor Ablauf der angeforderten %1 Minuten; den Auftrag abbrechen, dann mit einer anderen --partition oder weniger --minutes noch einmal einreichen.</translation>
    </message>
    <message>
      <source>Slurm&apos;s reason: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Grund laut Slurm: %1.</translation>
    </message>
    <message>
      <source>This network cannot be used: %1. Choose an ONNX network that takes 1 x 3 x H x W and gives 1 x 1 x h x w or 1 x 2 x h x w.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Netz ist nicht verwendbar: %1. Ein ONNX-Netz wählen, das 1 x 3 x H x W nimmt und 1 x 1 x h x w oder 1 x 2 x h x w liefert.</translation>
    </message>
    <message>
      <source>it cannot be run (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>es lässt sich nicht ausführen (%1)</translation>
    </message>
    <message>
      <source>its output has another shape</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seine Ausgabe hat eine andere Form</translation>
    </message>
    <message>
      <source>its output contains numbers that are not finite</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seine Ausgabe enthält Zahlen, die nicht endlich sind</translation>
    </message>
    <message>
      <source>its input is not an image</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seine Eingabe ist kein Bild</translation>
    </message>
    <message>
      <source>its input has %1 channels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seine Eingabe hat %1 Kanäle</translation>
    </message>
    <message>
      <source>its input is larger than %1 pixels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>seine Eingabe ist größer als %1 Pixel</translation>
    </message>
    <message>
      <source>You have no permission to use it: copy packaging/udev/70-ostraka.rules to /etc/udev/rules.d/ and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sie haben keine Berechtigung, es zu verwenden: packaging/udev/70-ostraka.rules nach /etc/udev/rules.d/ kopieren und das Gerät neu einstecken.</translation>
    </message>
    <message>
      <source>It is in use by %1: &apos;ostraka devices --release&apos; releases it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es wird von %1 benutzt: „ostraka devices --release“ gibt es frei.</translation>
    </message>
    <message>
      <source>It is in use by %1: close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es wird von %1 benutzt: dieses Programm schließen.</translation>
    </message>
    <message>
      <source>The kernel has no driver for it; install one for this adapter.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Kernel hat keinen Treiber dafür; einen für diesen Adapter installieren.</translation>
    </message>
    <message>
      <source>A folder of the project cannot be read (%1); check its permissions, then archive the project again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Ordner des Projekts ist nicht lesbar (%1); seine Rechte prüfen, dann das Projekt noch einmal archivieren.</translation>
    </message>
    <message>
      <source>No output folder was given; name one with --output OUT.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Ausgabeordner angegeben; einen mit --output OUT nennen.</translation>
    </message>
    <message>
      <source>No folder of front scans was given; name one with --front DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Ordner mit Scans der Vorderseiten angegeben; einen mit --front DIR nennen.</translation>
    </message>
    <message>
      <source>No folder of back scans was given; name one with --back DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Ordner mit Scans der Rückseiten angegeben; einen mit --back DIR nennen.</translation>
    </message>
    <message>
      <source>The field %1 has no unit &apos;%2&apos;; choose another unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Feld %1 kennt keine Einheit „%2“; eine andere Einheit wählen.</translation>
    </message>
    <message>
      <source>The table has no column &apos;%1&apos;; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Tabelle hat keine Spalte „%1“; den Namen prüfen.</translation>
    </message>
    <message>
      <source>The columns &apos;%1&apos; and &apos;%2&apos; are both mapped to the field %3; leave one of them out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Spalten „%1“ und „%2“ sind beide dem Feld %3 zugeordnet; eine davon auslassen.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; maps no column; write COLUMN=FIELD or COLUMN=FIELD:unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>„%1“ ordnet keine Spalte zu; COLUMN=FIELD oder COLUMN=FIELD:unit schreiben.</translation>
    </message>
    <message>
      <source>The scan&apos;s colours or qualities differ in number from its points; give one for each point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Scan hat nicht so viele Farben oder Gütewerte wie Punkte; für jeden Punkt einen Wert angeben.</translation>
    </message>
    <message>
      <source>The pixels or the mask differ in size from the stated width and height; give one value for each pixel.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Pixel oder die Maske passen nicht zur angegebenen Breite und Höhe; für jedes Pixel einen Wert angeben.</translation>
    </message>
    <message>
      <source>No scan of this side was given; give at least one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Scan dieser Seite wurde übergeben; mindestens einen übergeben.</translation>
    </message>
    <message>
      <source>give them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sie in mm übergeben</translation>
    </message>
    <message>
      <source>A remark in this file cannot be read; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Anmerkung in dieser Datei ist nicht lesbar; eine frühere Kopie der Datei wiederherstellen oder den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>Camera %1, position %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, Position %2</translation>
    </message>
    <message>
        <source>%1: from %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: aus %2</translation>
    </message>
    <message>
        <source>%1: from the history</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: aus dem Verlauf</translation>
    </message>
    <message>
        <source>%1: not restored</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: nicht wiederhergestellt</translation>
    </message>
    <message>
      <source>draft %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entwurf %1</translation>
    </message>
    <message>
      <source>The remarks in this file are longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Anmerkungen in dieser Datei sind länger als %1 Bytes; eine frühere Kopie der Datei wiederherstellen oder den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>A remark in this file is nested more than %1 levels deep; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Anmerkung in dieser Datei ist mehr als %1 Ebenen tief verschachtelt; eine frühere Kopie der Datei wiederherstellen oder den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>The template of a remark in this file is longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Vorlage einer Anmerkung in dieser Datei ist länger als %1 Bytes; eine frühere Kopie der Datei wiederherstellen oder den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>A remark in this file uses a value more than %1 times; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Anmerkung in dieser Datei verwendet einen Wert mehr als %1-mal; eine frühere Kopie der Datei wiederherstellen oder den Durchgang neu verarbeiten.</translation>
    </message>
    <message>
      <source>The version of the damaged catalogue cannot be read, so this repair relies on the backup %1. If a newer Ostraka has changed this project since, put the damaged file back and repair it with that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Version des beschädigten Katalogs ist nicht lesbar, daher stützt sich diese Reparatur auf die Sicherung %1. Falls ein neueres Ostraka das Projekt seitdem geändert hat, die beschädigte Datei zurücklegen und mit jener Version reparieren.</translation>
    </message>
    <message>
      <source>The setting %1 of project B says that two different things are the same; nothing was merged. Ask for another copy of project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Einstellung %1 von Projekt B setzt zwei verschiedene Dinge gleich; nichts wurde zusammengeführt. Um eine andere Kopie von Projekt B bitten.</translation>
    </message>
    <message>
      <source>The number or code %1 is already in use; nothing was merged. Settle the conflict %2 with another one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer oder das Kürzel %1 wird schon verwendet; nichts wurde zusammengeführt. Den Konflikt %2 mit einer anderen Angabe lösen.</translation>
    </message>
    <message>
      <source>A new number cannot be empty; nothing was merged. Enter a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine neue Nummer darf nicht leer sein; nichts wurde zusammengeführt. Eine Nummer eingeben.</translation>
    </message>
    <message>
      <source>The merged catalogue would be inconsistent, so nothing was merged; report this with a copy of both projects.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der zusammengeführte Katalog wäre in sich widersprüchlich, deshalb wurde nichts zusammengeführt; dies mit einer Kopie beider Projekte melden.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the front of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ergebnisse entstanden aus früheren Fotos der Vorderseite von %1; den Durchgang noch einmal verarbeiten.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the back of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ergebnisse entstanden aus früheren Fotos der Rückseite von %1; den Durchgang noch einmal verarbeiten.</translation>
    </message>
    <message>
      <source>Photographs of %1 that are missing or are others than these results were made from: %2 of %3. The results are entered; reprocess the batch if it was photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos von %1, die fehlen oder andere sind als die, aus denen diese Ergebnisse entstanden: %2 von %3. Die Ergebnisse sind eingetragen; den Durchgang neu verarbeiten, falls er neu aufgenommen wurde.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; the cluster&apos;s results are not entered. Submit it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang wurde nach dem Einreichen neu aufgenommen; die Ergebnisse des Clusters werden nicht eingetragen. Reichen Sie ihn noch einmal ein.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; its job %1 is of no use any more. Cancel it with &apos;scancel&apos;, or wait until it has ended, then submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Durchgang wurde nach dem Einreichen neu aufgenommen; sein Auftrag %1 nützt nichts mehr. Brechen Sie ihn mit &apos;scancel&apos; ab, oder warten Sie sein Ende ab, und reichen Sie den Durchgang dann noch einmal ein.</translation>
    </message>
    <message>
      <source>Batches of this project were submitted to this host, which was not named on this computer; nothing was sent to it. If you trust it, name it once with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchgänge dieses Projekts wurden bei diesem Rechner eingereicht, der auf diesem Computer nicht genannt wurde; ihm wurde nichts gesendet. Wenn Sie ihm vertrauen, nennen Sie ihn einmal mit --host.</translation>
    </message>
    <message>
      <source>Not a file in which Ostraka remembers the host of a cluster; delete it, then name the host with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Datei, in der sich Ostraka den Rechner eines Clusters merkt; löschen Sie sie, und nennen Sie den Rechner mit --host.</translation>
    </message>
    <message>
      <source>A job can request at most %1 MB of memory and %2 minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Auftrag kann höchstens %1 MB Speicher und %2 Minuten anfordern.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1 of the front side; it is left out of both sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Foto ist mit %1 der Vorderseite identisch; es wird auf beiden Seiten ausgelassen.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the front side are identical to photographs of the back side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 der %2 Fotos der Vorderseite sind mit Fotos der Rückseite identisch (etwa %3), daher ist der Durchgang nicht verwendbar; jeder Seite ihre eigenen Fotos geben.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the back side are identical to photographs of the front side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 der %2 Fotos der Rückseite sind mit Fotos der Vorderseite identisch (etwa %3), daher ist der Durchgang nicht verwendbar; jeder Seite ihre eigenen Fotos geben.</translation>
    </message>
    <message>
      <source>The field %1 was changed meanwhile; nothing was undone or redone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Feld %1 wurde inzwischen geändert; nichts wurde rückgängig gemacht oder wiederholt.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term; choose one of %2, or add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; ist kein Begriff der Wortliste; einen von diesen wählen: %2, oder ihn in den Einstellungen hinzufügen.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term: the vocabulary is empty; add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; ist kein Begriff: die Wortliste ist leer; ihn in den Einstellungen hinzufügen.</translation>
    </message>
    <message>
      <source>why this row was not imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>warum diese Zeile nicht importiert wurde</translation>
    </message>
    <message>
      <source>Read as a table of contexts and bags: no column has the sherds&apos; numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Als Tabelle von Befunden und Beuteln gelesen: keine Spalte enthält die Nummern der Scherben.</translation>
    </message>
    <message>
      <source>Read as a table of sherds: the column &apos;%1&apos; identifies them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Als Tabelle von Scherben gelesen: die Spalte &apos;%1&apos; bezeichnet sie.</translation>
    </message>
    <message>
      <source>No column has the sherds&apos; numbers, but &apos;%1&apos; is a column of sherds; select the column of numbers, or leave &apos;%1&apos; out if this is a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Spalte enthält die Nummern der Scherben, aber &apos;%1&apos; ist eine Spalte von Scherben; die Spalte der Nummern auswählen, oder &apos;%1&apos; weglassen, wenn dies eine Tabelle von Befunden ist.</translation>
    </message>
    <message>
        <source>%1: not restored; it belongs to %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: nicht wiederhergestellt; gehört zu %2</translation>
    </message>
    <message>
      <source>Only measurements and days accept &lt; and &gt;; write %1:value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nur Maße und Tage nehmen &lt; und &gt; an; %1:value schreiben.</translation>
    </message>
    <message>
      <source>The filter has no field &apos;%1&apos;; write extra.%1 for a custom field, or enclose the word in quotation marks to search for it literally.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Filter kennt kein Feld &apos;%1&apos;; für ein eigenes Feld extra.%1 schreiben oder das Wort in Anführungszeichen setzen, um es so zu suchen, wie es dasteht.</translation>
    </message>
    <message>
      <source>Write the date in EDTF, for example -0599/-0549~ (600 to about 550 BC), -1149? or 0350/..; years have four digits, and words such as MB II belong in the field for the period.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datierung in EDTF schreiben, zum Beispiel -0599/-0549~ (600 bis etwa 550 v. Chr.), -1149? oder 0350/..; Jahre haben vier Stellen, und Worte wie MB II gehören in das Feld für die Zeitstellung.</translation>
    </message>
    <message>
      <source>Enter the context with its site and trench, such as KT26-A-012.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Den Befund mit Fundort und Schnitt eingeben, zum Beispiel KT26-A-012.</translation>
    </message>
    <message>
      <source>Scale: none; lengths in mm are based on a guess.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: keiner; Längen in mm beruhen auf einer Schätzung.</translation>
    </message>
    <message>
      <source>Scale: the board of board.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: das Brett aus board.json.</translation>
    </message>
    <message>
      <source>Scale: the lengths marked in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: die in scale.json markierten Längen.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as typed at the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: Marken von %1 mm, wie beim Import eingegeben.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as in plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: Marken von %1 mm, wie in plate.json.</translation>
    </message>
    <message>
      <source>Scale: the markers that plate.json describes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: die Marken, die plate.json beschreibt.</translation>
    </message>
    <message>
      <source>Scale: that of the imported scans.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maßstab: der der importierten Scans.</translation>
    </message>
    <message>
      <source>The scale of this batch is its rig&apos;s; calibrate the rig to correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Maßstab dieses Durchgangs ist der seines Messplatzes; den Messplatz kalibrieren, um ihn zu berichtigen.</translation>
    </message>
    <message>
      <source>The markers of this sheet are of several sizes; correct its plate.json by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Marken dieses Blatts sind verschieden groß; seine plate.json von Hand berichtigen.</translation>
    </message>
    <message>
      <source>These results contain a measurement larger than any sherd; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ergebnisse enthalten ein Maß, das größer ist als jede Scherbe; &apos;ostraka process&apos; noch einmal ausführen.</translation>
    </message>
    <message>
      <source>This project lies in the archive &apos;%1&apos;, which any change would make invalid; restore the archive to a new folder, and open that.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt liegt im Archiv „%1“, das jede Änderung ungültig machen würde; das Archiv in einem neuen Ordner wiederherstellen und diesen öffnen.</translation>
    </message>
    <message>
      <source>Not a location of photographs, results, models or imported files, the only files that a merge writes; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kein Ort von Fotos, Ergebnissen, Modellen oder importierten Dateien, den einzigen Dateien, die ein Zusammenführen schreibt; es wurde nichts zusammengeführt.</translation>
    </message>
    <message>
      <source>A point, a normal or a quality of the scan is not finite; leave such points out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Punkt, eine Normale oder eine Güte des Scans ist nicht endlich; solche Punkte auslassen.</translation>
    </message>
    <message>
      <source>The lists of this cloud or mesh differ in length, or a triangle names a vertex that does not exist; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Listen dieser Punktwolke oder dieses Netzes sind verschieden lang, oder ein Dreieck nennt einen Eckpunkt, den es nicht gibt; nichts wurde geschrieben.</translation>
    </message>
    <message>
      <source>The transform puts the back %1 mm away from the front; give one that takes points of the back to the front&apos;s frame.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Transformation legt die Rückseite %1 mm von der Vorderseite weg; eine angeben, die Punkte der Rückseite in das Koordinatensystem der Vorderseite bringt.</translation>
    </message>
    <message>
      <source>The model has no photographs, so the orthophoto shows the colours of its vertices.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Modell hat keine Fotos, daher zeigt das Orthofoto die Farben seiner Eckpunkte.</translation>
    </message>
    <message>
      <source>The model has neither photographs nor colours, so there is no orthophoto of it; draw its shaded form.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Modell hat weder Fotos noch Farben, daher gibt es kein Orthofoto davon; die schattierte Form zeichnen.</translation>
    </message>
    <message>
      <source>%1: 1 point whose normal has no direction was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: 1 Punkt, dessen Normale keine Richtung hat, wurde ausgelassen; den Export prüfen.</translation>
    </message>
    <message>
      <source>%1: %2 points whose normals have no direction were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 Punkte, deren Normalen keine Richtung haben, wurden ausgelassen; den Export prüfen.</translation>
    </message>
    <message>
      <source>The photograph is less than %1 pixels wide or high; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das Foto ist weniger als %1 Pixel breit oder hoch; das Originalfoto verwenden.</translation>
    </message>
    <message>
        <source>The project has no site yet; add a column &apos;Site&apos;, or write the context with its site, such as %1.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Das Projekt hat noch keinen Fundort; eine Spalte „Fundort“ hinzufügen oder den Befund mit seinem Fundort schreiben, etwa %1.</translation>
    </message>
    <message>
        <source>This project has %1 sites; add a column &apos;Site&apos;, or write the context with its site, such as %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Dieses Projekt hat %1 Fundorte; eine Spalte „Fundort“ hinzufügen oder den Befund mit seinem Fundort schreiben, etwa %2.</translation>
    </message>
    <message>
        <source>The site %1 has %2 trenches; add a column &apos;Trench&apos;, or write the context with its trench, such as %3.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Fundort %1 hat %2 Schnitte; eine Spalte „Schnitt“ hinzufügen oder den Befund mit seinem Schnitt schreiben, etwa %3.</translation>
    </message>
    <message>
        <source>There is no such trench in the site %1; write trench and context in columns of their own.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Einen solchen Schnitt gibt es im Fundort %1 nicht; Schnitt und Befund in eigene Spalten schreiben.</translation>
    </message>
    <message>
        <source>The backups %1 and %2 are of different projects, and nothing tells which of them this folder is; nothing was changed. Move those of the other project away, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Die Sicherungen %1 und %2 sind von verschiedenen Projekten, und nichts sagt, welches davon dieser Ordner ist; nichts wurde geändert. Die des anderen Projekts an einen anderen Ort verschieben, dann noch einmal reparieren.</translation>
    </message>
    <message>
        <source>This can be %1 or %2; enter site, trench and context each by itself.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Das kann %1 oder %2 sein; Fundort, Schnitt und Befund einzeln eingeben.</translation>
    </message>
    <message>
        <source>The table needs a column for the sherds&apos; numbers, or one for the contexts (a table of contexts); select it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Die Tabelle braucht eine Spalte mit den Nummern der Scherben oder eine mit den Befunden (eine Tabelle von Befunden); diese auswählen.</translation>
    </message>
    <message>
      <source>The number needs the trench of the sherd, which is not recorded; choose a context in a trench, or change the numbering in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer braucht den Schnitt der Scherbe, der nicht eingetragen ist; wählen Sie einen Befund in einem Schnitt oder ändern Sie die Nummerierung in den Einstellungen.</translation>
    </message>
    <message>
      <source>This folder on the cluster belongs to another project, to another copy of this one, or to this one before it was moved; nothing was sent. Name another folder with --host. If nothing else uses this one, delete &apos;cluster/owner&apos; in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner auf dem Cluster gehört einem anderen Projekt, einer anderen Kopie von diesem oder diesem, bevor es verschoben wurde; nichts wurde gesendet. Mit --host einen anderen Ordner nennen. Wenn sonst nichts diesen Ordner benutzt, darin &apos;cluster/owner&apos; löschen.</translation>
    </message>
    <message>
      <source>This changed while a merge was being completed, so it was kept, but the catalogue has what was merged. Reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dies änderte sich, während eine Zusammenführung abgeschlossen wurde; es blieb erhalten, aber der Katalog hat, was zusammengeführt wurde. Den Durchgang noch einmal verarbeiten.</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zeile</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Feld</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wert</translation>
    </message>
    <message>
      <source>A sparse object of %1 points at x %2, y %3 mm was left out; if it is a sherd, photograph it closer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Gegenstand aus nur %1 Punkten bei x %2, y %3 mm wurde ausgelassen; wenn es eine Scherbe ist, sie aus geringerem Abstand aufnehmen.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs or scans of %3 belong to %4, too: its sherds would be in the catalogue twice. Nothing was entered. Set %3 aside and use %4, or keep both: 'Keep both' in the queue, 'ostraka catalogue enter --keep-both' on the command line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 der %2 Fotos oder Scans von %3 gehören auch zu %4: Seine Scherben stünden zweimal im Katalog. Nichts wurde eingetragen. %3 beiseitelegen und %4 verwenden, oder beide behalten: „Beide behalten“ in der Warteschlange, 'ostraka catalogue enter --keep-both' auf der Befehlszeile.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of %3, which this export holds, belong to %4, too: its sherds would be in the catalogue twice. Use %4 and leave the export out, or keep both on purpose (on the command line: --keep-both).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 der %2 Fotos von %3, das dieser Export enthält, gehören auch zu %4: Seine Scherben stünden zweimal im Katalog. %4 verwenden und den Export weglassen, oder beide absichtlich behalten (auf der Befehlszeile: --keep-both).</translation>
    </message>
    <message>
      <source>Another run is writing to this folder. What it has saved is kept, and this run has changed nothing; wait until the other one ends, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Lauf schreibt in diesen Ordner. Was er gespeichert hat, bleibt erhalten, und dieser Lauf hat nichts geändert; das Ende des anderen abwarten oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>The photographs do not tell the light from the sherds' own colours, so textures stay as photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Fotos lassen das Licht nicht von den Eigenfarben der Scherben unterscheiden; die Texturen bleiben wie fotografiert.</translation>
    </message>
    <message>
      <source>Ostraka needs this folder for its own files, but it contains others. They are unchanged; move them elsewhere, then start again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka braucht diesen Ordner für eigene Dateien, er enthält aber andere. Sie sind unverändert; sie an einen anderen Ort verschieben, dann noch einmal starten.</translation>
    </message>
    <message>
      <source>This is not the location of a photograph, result, model or imported file, the only files that a catalogue lists. Nothing was changed; use a backup or another copy of the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hier liegt kein Foto, kein Ergebnis, kein Modell und keine importierte Datei, und nur solche führt ein Katalog auf. Nichts wurde geändert; eine Sicherung oder eine andere Kopie des Projekts verwenden.</translation>
    </message>
    <message>
      <source>The catalogue has earlier results of %1, and the batch is queued again. Enter the new ones with &apos;ostraka catalogue enter&apos;, or reprocess it in the window.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Katalog hat frühere Ergebnisse von %1, und der Durchgang steht wieder in der Warteschlange. Die neuen mit &apos;ostraka catalogue enter&apos; eintragen oder ihn im Fenster neu verarbeiten.</translation>
    </message>
    <message>
      <source>The folder on the cluster has files that Ostraka did not write (%1): %2. They were left there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ordner auf dem Cluster enthält Dateien, die Ostraka nicht geschrieben hat (%1): %2. Sie bleiben dort.</translation>
    </message>
    <message>
      <source>The output folder contains the results of other scans, or of these before a file was changed, renamed, added or removed; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Ausgabeordner enthält die Ergebnisse anderer Scans oder dieser Scans, bevor eine Datei geändert, umbenannt, hinzugefügt oder entfernt wurde; einen anderen Ordner wählen.</translation>
    </message>
    <message>
      <source>The interval ends before it begins: %1 is earlier than %2; write the earlier date first, and years BC with a minus sign.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Zeitraum endet, bevor er beginnt: %1 liegt vor %2; die frühere Datierung zuerst schreiben und Jahre v. Chr. mit einem Minuszeichen.</translation>
    </message>
    <message>
      <source>The number %1 differs from the existing number %2 only in zeros, letter case or punctuation; check which one is meant.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 unterscheidet sich von der vorhandenen Nummer %2 nur in Nullen, Groß- und Kleinschreibung oder Satzzeichen; prüfen, welche gemeint ist.</translation>
    </message>
    <message>
      <source>New numbers differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neue Nummern unterscheiden sich von vorhandenen nur in Nullen, Groß- und Kleinschreibung oder Satzzeichen: %1; auf Tippfehler prüfen.</translation>
    </message>
    <message>
      <source>New contexts differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neue Befunde unterscheiden sich von vorhandenen nur in Nullen, Groß- und Kleinschreibung oder Satzzeichen: %1; auf Tippfehler prüfen.</translation>
    </message>
    <message>
      <source>A spreadsheet may have shortened these numbers or turned them into dates: %1; compare them with the labels and correct them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Tabellenkalkulation hat diese Nummern möglicherweise verkürzt oder in Daten umgewandelt: %1; mit den Etiketten vergleichen und berichtigen.</translation>
    </message>
    <message>
      <source>This file differs from what &apos;ostraka process&apos; wrote; run it again, which writes the file anew.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Datei ist nicht mehr so, wie 'ostraka process' sie geschrieben hat; es noch einmal laufen lassen, dann wird sie neu geschrieben.</translation>
    </message>
    <message>
      <source>The name of the file %1 is not UTF-8, and results could not tell it from others; rename it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Name der Datei %1 ist kein UTF-8, und Ergebnisse könnten sie nicht von anderen unterscheiden; die Datei umbenennen, dann noch einmal versuchen.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbare Fotos der Vorderseite: %1; mindestens %2 sind nötig. Ausgelassene Fotos: %3; das erste: %4</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Brauchbare Fotos der Rückseite: %1; mindestens %2 sind nötig. Ausgelassene Fotos: %3; das erste: %4</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused; nothing was merged. Settle the conflict %2 with another number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Nummer %1 wurde schon vergeben und wird nie wieder verwendet; nichts wurde zusammengeführt. Den Konflikt %2 mit einer anderen Nummer lösen.</translation>
    </message>
    <message>
      <source>An entry of this file does not have the form {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} (or &quot;b&quot; or &quot;one&quot;, or &quot;number&quot; with a new number): %1; nothing was merged. Correct the entry.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Eintrag dieser Datei hat nicht die Form {&quot;id&quot;: &quot; …&quot;, &quot;take&quot;: &quot;a&quot;} (oder &quot;b&quot; oder &quot;one&quot;, oder &quot;number&quot; mit einer neuen Nummer): %1; nichts wurde zusammengeführt. Den Eintrag berichtigen.</translation>
    </message>
    <message>
      <source>The name of a place must not be empty; nothing was renamed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Name eines Ortes darf nicht leer sein; nichts wurde umbenannt.</translation>
    </message>
    <message>
      <source>Another place has the name %1 by now; nothing was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein anderer Ort heißt inzwischen %1; nichts wurde rückgängig gemacht.</translation>
    </message>
    <message>
      <source>This disk does not accept this name; rename the file, or use a folder on another disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Datenträger lässt diesen Namen nicht zu; die Datei umbenennen oder einen Ordner auf einem anderen Datenträger benutzen.</translation>
    </message>
    <message>
      <source>A file of an earlier merge cannot be moved to its place, %1. Make it possible (move away what lies there, or copy the project to another disk), or delete the file; then merge again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Datei einer früheren Zusammenführung kann nicht an ihren Ort %1 verschoben werden. Dies ermöglichen (verschieben, was dort liegt, oder das Projekt auf einen anderen Datenträger kopieren) oder die Datei löschen; dann noch einmal zusammenführen.</translation>
    </message>
    <message>
      <source>It belongs to a merge and waits in %1; moving it to its place is tried again whenever the project is opened.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Datei gehört zu einer Zusammenführung und wartet in %1; bei jedem Öffnen des Projekts wird erneut versucht, sie an ihren Ort zu verschieben.</translation>
    </message>
    <message>
      <source>The block of numbers of this computer begins or ends with &apos;%1&apos;, but must be of whole numbers from 1 to %2; set it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Nummernblock dieses Rechners beginnt oder endet mit &apos;%1&apos;, muss aber aus ganzen Zahlen von 1 bis %2 bestehen; in den Einstellungen festlegen.</translation>
    </message>
    <message>
      <source>Photographs of %1 that these results were not made from: %2, the first is %3. Reprocess the batch to use them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotos von %1, aus denen diese Ergebnisse nicht entstanden: %2, das erste ist %3. Den Durchgang noch einmal verarbeiten, um sie zu benutzen.</translation>
    </message>
    <message>
      <source>These results do not say which photographs they were made from, so they are not entered; process %1 again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diese Ergebnisse sagen nicht, aus welchen Fotos sie entstanden; sie werden daher nicht eingetragen. %1 noch einmal verarbeiten.</translation>
    </message>
    <message>
      <source>The GLB beside this model has another shape, so it is that of another sherd or of an earlier run; put its own beside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die GLB neben diesem Modell hat eine andere Form, ist also die einer anderen Scherbe oder einer früheren Verarbeitung; seine eigene daneben legen.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ToolRow</name>
    <message>
        <source>More</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More tools</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, Taste %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ColumnTable</name>
    <message>
        <source>says nothing about the sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>sagt nichts über die Scherbe</translation>
    </message>
    <message>
        <source>only shown, never read</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>nur gezeigt, nie gelesen</translation>
    </message>
    <message>
        <source>share of 1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Anteil an 1</translation>
    </message>
    <message>
        <source>unit guessed from the values; check it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Einheit aus den Werten erschlossen; bitte prüfen</translation>
    </message>
    <message>
        <source>as in the last table with these columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>wie in der letzten Tabelle mit diesen Spalten</translation>
    </message>
    <message>
        <source>chosen by you</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>von Ihnen gewählt</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Spalten der Tabelle</translation>
    </message>
    <message>
        <source>column</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Feld</translation>
    </message>
    <message>
        <source>unit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>first values</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>erste Werte</translation>
    </message>
    <message>
        <source>why</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Field of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Feld der Spalte %1</translation>
    </message>
    <message>
        <source>Unit of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Einheit der Spalte %1</translation>
    </message>
    <message>
        <source>skip</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>weglassen</translation>
    </message>
    <message>
        <source>custom field: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>eigenes Feld: %1</translation>
    </message>
    <message>
        <source>no field of this name; kept as a custom field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>kein Feld dieses Namens; als eigenes Feld behalten</translation>
    </message>
    <message>
      <source>proposed by its heading</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nach der Überschrift vorgeschlagen</translation>
    </message>
</context>
<context>
    <name>ImportSides</name>
    <message>
      <source>Drop either folders or photographs, not both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entweder Ordner oder Fotos ablegen, nicht beides.</translation>
    </message>
    <message>
      <source>These are more than two folders; drop that of the fronts and that of the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Das sind mehr als zwei Ordner; den der Vorderseiten und den der Rückseiten ablegen.</translation>
    </message>
    <message>
      <source>There are no photographs in this folder; choose one that holds them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ordner sind keine Fotos; einen wählen, der sie enthält.</translation>
    </message>
    <message>
      <source>This folder contains several folders with photographs (%1); drop the two of one batch, front and back, onto this page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieser Ordner enthält mehrere Ordner mit Fotos (%1); die zwei eines Durchgangs, Vorder- und Rückseite, hier ablegen.</translation>
    </message>
    <message>
      <source>The photographs of this folder are those of the front already; choose another folder for the back, or divide the series with the slider.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Fotos dieses Ordners sind schon die der Vorderseite; einen anderen Ordner für die Rückseite wählen oder die Reihe mit dem Schieber teilen.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportChooser</name>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner mit Scans in front/ und back/</translation>
    </message>
    <message>
      <source>Folder of a batch, or with photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner eines Durchgangs oder mit Fotos</translation>
    </message>
    <message>
      <source>Folder of the back photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner mit den Fotos der Rückseiten</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SidesView</name>
    <message>
      <source>One side only</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nur eine Seite</translation>
    </message>
    <message>
      <source>Swap sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seiten tauschen</translation>
    </message>
    <message>
      <source>First photograph of the second side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Erstes Foto der zweiten Seite</translation>
    </message>
    <message>
      <source>Choose sheet…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bogen wählen …</translation>
    </message>
    <message>
      <source>Clear sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bogen entfernen</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s &amp;black square</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seite des &amp;schwarzen Markerquadrats</translation>
    </message>
    <message>
      <source>Unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unbekannt</translation>
    </message>
    <message>
      <source> mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation> mm</translation>
    </message>
    <message>
      <source>The sheet will be found in the photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Der Bogen wird in den Fotos gefunden.</translation>
    </message>
    <message>
      <source>No sheet file (plate.json) and no marker size: the result has no scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Bogendatei (plate.json) und keine Markergröße: Das Ergebnis hat keinen Maßstab.</translation>
    </message>
    <message>
      <source>Sheet under the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bogen unter den Scherben</translation>
    </message>
    <message>
      <source>Sheet (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bogen (*.json)</translation>
    </message>
    <message>
      <source>Front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorderseite</translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückseite</translation>
    </message>
    <message>
      <source>The series is divided where the sherds were turned over.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Reihe ist dort geteilt, wo die Scherben umgedreht wurden.</translation>
    </message>
    <message>
      <source>Sheet: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bogen: %1</translation>
    </message>
    <message>
      <source>%1: none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: keine</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n photograph(s), %2 to %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: %n Foto, %2 bis %3</numerusform>
        <numerusform>%1: %n Fotos, %2 bis %3</numerusform>
      </translation>
    </message>
    <message>
      <source>The marker size is proposed from the last import: check it with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die Markengröße ist vom letzten Import vorgeschlagen: mit einem Lineal prüfen.</translation>
    </message>
    <message>
      <source>Choose back folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner der Rückseiten wählen …</translation>
    </message>
    <message>
      <source>A folder that holds both sides is split where the sherds were turned over; the folder of the back photographs replaces the split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Ordner mit beiden Seiten wird dort geteilt, wo die Scherben gewendet wurden; der Ordner der Rückseiten ersetzt die Teilung</translation>
    </message>
    <message>
      <source>No pause stands out between the photographs. Where the two pictures beside the division show the sherds before and after they were turned over, divide here; else move the slider, or choose the folder of the back photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwischen den Fotos fällt keine Pause auf. Zeigen die beiden Bilder neben der Teilung die Scherben vor und nach dem Wenden, hier teilen; sonst den Schieber bewegen oder den Ordner mit den Fotos der Rückseiten wählen.</translation>
    </message>
    <message>
      <source>Divide here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hier teilen</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueRepair</name>
    <message>
        <source>It is whole; nothing was changed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Er ist vollständig; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Nothing in the damaged file could be read: it is that of %1 again. Look what is missing since.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>In der beschädigten Datei war nichts lesbar: Es gilt wieder der Stand von %1. Sehen Sie nach, was seither fehlt.</translation>
    </message>
    <message>
        <source>An earlier repair was interrupted and is now finished. Check the catalogue for missing changes.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Eine frühere Reparatur wurde unterbrochen und ist jetzt abgeschlossen. Prüfen Sie, ob im Katalog Änderungen fehlen.</translation>
    </message>
    <message>
        <source>Everything in it is as it was.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Alles darin ist, wie es war.</translation>
    </message>
    <message>
        <source>All %1 rows stand in %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Alle %1 Zeilen stehen in %2.</translation>
    </message>
    <message>
        <source>The damaged file is kept: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Die beschädigte Datei bleibt aufbewahrt: %1</translation>
    </message>
    <message>
        <source>Another window has this project open: close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ein anderes Fenster hat dieses Projekt offen: dort schließen, dann reparieren.</translation>
    </message>
    <message>
        <source>The catalogue is being repaired …</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Katalog wird repariert …</translation>
    </message>
    <message>
        <source>The catalogue could not be repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Katalog konnte nicht repariert werden.</translation>
    </message>
    <message>
        <source>The catalogue is repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Der Katalog ist repariert.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeDialog</name>
    <message>
      <source>Merge another project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anderes Projekt zusammenführen</translation>
    </message>
    <message>
      <source>Conflicts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Konflikte</translation>
    </message>
    <message>
      <source>Record</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Datensatz</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Feld</translation>
    </message>
    <message>
      <source>This project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt</translation>
    </message>
    <message>
      <source>Other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anderes Projekt</translation>
    </message>
    <message>
      <source>Decision</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Entscheidung</translation>
    </message>
    <message>
      <source>New number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neue Nummer</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rückgängig</translation>
    </message>
    <message>
      <source>All open ones: this project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alle offenen: dieses Projekt</translation>
    </message>
    <message>
      <source>Choose project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt wählen …</translation>
    </message>
    <message>
      <source>Progress of the merge</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fortschritt der Zusammenführung</translation>
    </message>
    <message>
      <source>Folder of the other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ordner des anderen Projekts</translation>
    </message>
    <message>
      <source>New number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neue Nummer %1</translation>
    </message>
    <message>
      <source>Open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Offen</translation>
    </message>
    <message>
      <source>What the other project holds comes into this one; the other one is only read. Nothing changes before you merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Was das andere Projekt enthält, kommt in dieses; das andere wird nur gelesen. Nichts ändert sich, bevor Sie zusammenführen.</translation>
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
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
      <source>%n conflict(s) to settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Konflikt zu klären</numerusform>
        <numerusform>%n Konflikte zu klären</numerusform>
      </translation>
    </message>
    <message>
      <source>Merge project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projekt zusammenführen</translation>
    </message>
    <message>
      <source>New number:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neue Nummer:</translation>
    </message>
    <message>
      <source>New number of the record that does not keep it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neue Nummer des Datensatzes, der sie nicht behält</translation>
    </message>
    <message>
      <source>Sherds with a new number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben mit neuer Nummer</translation>
    </message>
    <message>
      <source>Copy list</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Liste kopieren</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Scherben: die dieses Projekts behält die Nummer, die andere bekommt %1</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Scherben: die dieses Projekts behält die Nummer, die andere bekommt eine neue</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Scherben: die andere behält die Nummer, die dieses Projekts bekommt %1</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zwei Scherben: die andere behält die Nummer, die dieses Projekts bekommt eine neue</translation>
    </message>
    <message>
      <source>One sherd: both records become one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe: beide Datensätze werden einer</translation>
    </message>
    <message>
      <source>Open; new number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Offen; neue Nummer: %1</translation>
    </message>
    <message>
      <source>One sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine Scherbe</translation>
    </message>
    <message>
      <source>This project; the other sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt; die andere Scherbe: %1</translation>
    </message>
    <message>
      <source>Other project; this sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Anderes Projekt; diese Scherbe: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeModel</name>
    <message>
      <source>Sherds: %1. Batches: %2. Changed records: %3. Files: %4 (%5).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben: %1. Durchgänge: %2. Geänderte Datensätze: %3. Dateien: %4 (%5).</translation>
    </message>
    <message>
      <source>Comparing…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vergleich läuft …</translation>
    </message>
    <message>
      <source>Merged %1. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 zusammengeführt. %2</translation>
    </message>
    <message>
      <source>This project already has everything that the other one holds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dieses Projekt hat schon alles, was das andere enthält.</translation>
    </message>
    <message>
      <source>Batches that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchgänge, die hier eine andere Nummer bekommen: %1</translation>
    </message>
    <message>
      <source>Sherds that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben, die hier eine andere Nummer bekommen: %1</translation>
    </message>
    <message numerus="yes">
      <source>Missing in the other project: %n file(s), %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Im anderen Projekt fehlt %n Datei: %1</numerusform>
        <numerusform>Im anderen Projekt fehlen %n Dateien: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Abgebrochen. Nichts wurde zusammengeführt.</translation>
    </message>
    <message>
      <source>Nothing was merged yet: what you chose leads to further conflicts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Noch wurde nichts zusammengeführt: Ihre Wahl führt zu weiteren Konflikten.</translation>
    </message>
    <message>
      <source>An earlier merge was interrupted and could not be completed here: %1. What lies there is kept; the other project&apos;s version was left out, or waits in the folder merge.partial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eine frühere Zusammenführung wurde unterbrochen und konnte hier nicht abgeschlossen werden: %1. Was dort liegt, bleibt erhalten; die Fassung des anderen Projekts wurde weggelassen oder wartet im Ordner merge.partial.</translation>
    </message>
</context>
<context>
    <name>Verdicts</name>
    <message>
      <source>accepted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>angenommen</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>abgelehnt</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>beiseitegelegt</translation>
    </message>
    <message>
      <source>to be photographed again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>neu aufzunehmen</translation>
    </message>
    <message>
      <source>merged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>zusammengeführt</translation>
    </message>
    <message>
      <source>split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geteilt</translation>
    </message>
    <message>
      <source>withdrawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>zurückgenommen</translation>
    </message>
    <message>
      <source>pair of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Paar von %1</translation>
    </message>
    <message>
      <source>fragments: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fragmente: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateScreen</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durchgang</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NoBatchYet</name>
    <message>
        <source>Capture a batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Durchgang aufnehmen</translation>
    </message>
    <message>
      <source>Show the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Warteschlange zeigen</translation>
    </message>
    <message>
      <source>%1 is in the queue; its results appear here when it is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ist in der Warteschlange; die Ergebnisse erscheinen hier, sobald der Durchgang verarbeitet ist.</translation>
    </message>
    <message>
      <source>%1 could not be processed; the queue says why.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 konnte nicht verarbeitet werden; die Warteschlange sagt, warum.</translation>
    </message>
</context>
<context>
    <name>Outside</name>
    <message>
      <source>No program was found that opens %1. It is there: open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Es wurde kein Programm gefunden, das %1 öffnet. Die Datei ist da: Öffnen Sie sie von Hand.</translation>
    </message>
    <message>
      <source>Opening %1. If it does not appear, open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 wird geöffnet. Erscheint es nicht, von Hand öffnen.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MarkerSide</name>
    <message>
      <source>Marker side of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Markenseite von %1</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s black square, mm. The batch is reprocessed with this size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seite des schwarzen Quadrats einer Marke, mm. Der Durchgang wird mit dieser Größe neu verarbeitet.</translation>
    </message>
    <message>
      <source>marker side typed anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Markenseite neu eingegeben</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PrintSheetButton</name>
    <message>
        <source>Print a sheet…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bogen drucken …</translation>
    </message>
    <message>
        <source>Markers around the sherds give photographs taken by hand their scale</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Marken um die Scherben geben Fotos aus freier Hand ihren Maßstab</translation>
    </message>
    <message>
        <source>Print it at 100 %, not fitted to the page, and measure the bar of the second page: it must be %1 mm long. The next import proposes this sheet. If the bar is not %1 mm long, choose Clear sheet there and type the measured side of a black square.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Drucken Sie ihn mit 100 %, nicht an die Seite angepasst, und messen Sie den Balken der zweiten Seite: Er muss %1 mm lang sein. Der nächste Import schlägt diesen Bogen vor. Ist der Balken nicht %1 mm lang, wählen Sie dort „Bogen entfernen“ und geben Sie die gemessene Seite eines schwarzen Quadrats ein.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SurfaceChoice</name>
    <message>
      <source>Shaded form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schattierte Form</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mit Bemalung und Engobe</translation>
    </message>
    <message>
      <source>Orthophoto, %1 dpi</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Orthofoto, %1 dpi</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectCare</name>
    <message numerus="yes">
      <source>%n file(s) of this project are missing or were changed, first %1. Put them back from a copy; &apos;ostraka catalogue check&apos; lists all of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n Datei dieses Projekts fehlt oder wurde verändert: %1. Aus einer Kopie zurücklegen; »ostraka catalogue check« nennt sie.</numerusform>
        <numerusform>%n Dateien dieses Projekts fehlen oder wurden verändert, zuerst %1. Aus einer Kopie zurücklegen; »ostraka catalogue check« nennt alle.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MunsellLine</name>
    <message>
      <source>Rough: no usable colour chart in these photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Grob: Diese Fotos zeigen keine brauchbare Farbtafel.</translation>
    </message>
    <message>
      <source>Measured by the colour chart (Delta E 2000: median %1, 95 % %2).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mit der Farbtafel gemessen (Delta E 2000: Median %1, 95 % %2).</translation>
    </message>
    <message>
      <source>Take over</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Übernehmen</translation>
    </message>
    <message>
      <source>Proposed: %1 (Delta E 2000: %2), then %3 (%4). %5</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorschlag: %1 (Delta E 2000: %2), dann %3 (%4). %5</translation>
    </message>
    <message>
      <source>Take over %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 übernehmen</translation>
    </message>
    <message>
      <source>Of the side that was photographed first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von der zuerst fotografierten Seite.</translation>
    </message>
    <message>
      <source>Of the side that was photographed second.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von der danach fotografierten Seite.</translation>
    </message>
    <message>
      <source>Measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gemessen.</translation>
    </message>
    <message>
      <source>No colours proposed: the model has no texture from photographs, or an earlier version of the program made it. Reprocess its batch to get proposals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Keine Farben vorgeschlagen: Das Modell hat keine Textur aus Fotos oder stammt von einer früheren Version des Programms. Verarbeiten Sie seinen Durchgang neu, um Vorschläge zu erhalten.</translation>
    </message>
    <message>
      <source>Rough estimate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Grobe Schätzung.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CompareWindow</name>
    <message>
      <source>only one entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nur bei einer eingetragen</translation>
    </message>
    <message>
      <source>differs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>verschieden</translation>
    </message>
    <message>
      <source>differs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>verschieden: %1</translation>
    </message>
    <message>
      <source>%1, within the uncertainty</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, innerhalb der Unsicherheit</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message>
      <source>Compare sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben vergleichen</translation>
    </message>
    <message>
      <source>Turn &amp;together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Gemeinsam drehen</translation>
    </message>
    <message>
      <source>Off: each sherd is turned alone, until both lie alike. The scale stays the same.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aus: jede Scherbe wird für sich gedreht, bis beide gleich liegen. Der Maßstab bleibt derselbe.</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Von oben</translation>
    </message>
    <message>
      <source>Fields and measurements of both sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Felder und Maße beider Scherben</translation>
    </message>
    <message>
      <source>Model of %1; the arrow keys turn it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modell von %1; die Pfeiltasten drehen es</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Feld</translation>
    </message>
    <message>
      <source>difference</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Unterschied</translation>
    </message>
    <message numerus="yes">
      <source>%n field(s) differ.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%n Feld ist verschieden.</numerusform>
            <numerusform>%n Felder sind verschieden.</numerusform>
        </translation>
    </message>
    <message>
      <source>The two are recorded as joining.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Die beiden sind als aneinanderpassend eingetragen.</translation>
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
      <translation>Orte umbenennen</translation>
    </message>
    <message>
      <source>Choose the place that was typed wrongly and enter its right name. If that place exists already, both become one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wählen Sie den Ort, der falsch eingegeben wurde, und geben Sie seinen richtigen Namen ein. Gibt es diesen Ort schon, werden beide einer.</translation>
    </message>
    <message>
      <source>Places of the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Orte des Projekts</translation>
    </message>
    <message>
      <source>Place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ort</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Scherben</translation>
    </message>
    <message>
      <source>Right name of the place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Richtiger Name des Ortes</translation>
    </message>
    <message>
      <source>Rename</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Umbenennen</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Schließen</translation>
    </message>
    <message>
      <source>Right &amp;name:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Richtiger &amp;Name:</translation>
    </message>
    <message numerus="yes">
      <source>%n context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>ein Befund</numerusform>
        <numerusform>%n Befunde</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n bag(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>ein Beutel</numerusform>
        <numerusform>%n Beutel</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>ein Durchgang</numerusform>
        <numerusform>%n Durchgänge</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>eine Scherbe</numerusform>
        <numerusform>%n Scherben</numerusform>
      </translation>
    </message>
    <message>
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>nichts</translation>
    </message>
    <message>
      <source>%1 exists already. Join with it? What is in %2 comes to %1: %3. %1 keeps its own description, and %2 is not listed any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 gibt es schon. Damit vereinen? Was in %2 ist, kommt zu %1: %3. %1 behält seine eigene Beschreibung, und %2 wird nicht mehr aufgeführt.</translation>
    </message>
    <message>
      <source>In this place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>In diesem Ort: %1.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep the number that is written on them; new numbers go on behind these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Eine Scherbe behält die Nummer, die auf ihr steht; neue Nummern folgen dahinter.</numerusform>
        <numerusform>%n Scherben behalten die Nummern, die auf ihnen stehen; neue Nummern folgen dahinter.</numerusform>
      </translation>
    </message>
    <message>
      <source>Join places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Orte vereinen</translation>
    </message>
    <message>
      <source>join %1 with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mit %2 vereinen</translation>
    </message>
    <message>
      <source>rename %1 to %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
      <source>Joined: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vereint: %1 ist jetzt %2.</translation>
    </message>
    <message>
      <source>Renamed: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Umbenannt: %1 ist jetzt %2.</translation>
    </message>
    <message>
      <source>A site gets another code in the settings, under Open project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ein Fundort bekommt ein anderes Kürzel in den Einstellungen unter „Offenes Projekt“.</translation>
    </message>
</context>
</TS>
