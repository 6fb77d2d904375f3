<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>Fields</name>
    <message>
      <source>number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>identifier</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>state</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>void because</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>site</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>trench</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>context</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>bag</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>ware</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>fabric</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>inclusions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>manufacture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>firing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>surface outside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>surface inside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>decoration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Munsell outside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Munsell inside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Munsell core</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>condition</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>joins with</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>vessel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>period</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>date</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>length, mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>width, mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>thickness least, mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>thickness, mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>thickness most, mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>area, mm²</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>volume, mm³</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not seen, %</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>rim diameter, mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>rim kept, %</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>weight, g</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>batch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>note</source>
      <translation type="unfinished" />
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>void</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>draft</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>on a scale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>with a calliper</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>estimated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>by the program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>aside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>noch einmal</translation>
    </message>
    <message>
      <source>%1 or %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The printer or file cannot be written; choose another.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>front</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The printer took no further page.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The printer or file could not be finished; is the disk full?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 and %2 both fit %3: their rims differ by %4 only.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 would fit %2 nearly as well.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Another partner fits nearly as well.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 fits hardly better than a stranger's back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The two sides fit nearly as well in another position.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>under 1 %</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>The back lies upside down: both sides face the same way.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The faces cross: %1 of the front lies behind the back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The two scans share almost no broken edge; outlines alone tie them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The broken edges do not fit: %1 apart.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rim hardly fixes the position: uncertain by %1.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A place %1 along the rim fits nearly as well.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rims cannot be compared; outlines alone tie these sides.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>look</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>sure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>decided</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>set aside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>shoot again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 – %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No back was found for it. Choose one, or set it aside.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The program is sure: %1.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Decided by %1 on %2.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set aside by %1 on %2.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>To be shot again, says %1, %2.</source>
      <translation type="unfinished" />
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
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s): sure %1, ask %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>eine Scherbe: sicher %1, fraglich %2</numerusform>
        <numerusform>%n Scherben: sicher %1, fraglich %2</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>eine Scherbe, sicher</numerusform>
        <numerusform>%n Scherben, alle sicher</numerusform>
      </translation>
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>New value for all</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>new value; empty deletes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>sherd</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>then</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What would change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give numbers to the drafts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Field</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Value</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>Type a value to see what would change.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preview of a change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no number yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>refused: %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 change, %2 stay as they are, %3 are refused.</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CandidateBar</name>
    <message>
      <source>Another back …</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>under 1 %</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>rim %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no rim</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1, now with %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1   %2   %3
%4</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Candidate %1: %2, %3, %4</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1, nobody's</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureStation</name>
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
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Leertaste</translation>
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
      <source>%1 and %2 nearly touch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 und %2 berühren sich fast</translation>
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
  </context>
  <context>
    <name>ostraka::ui::CatalogueStation</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>Catalogue</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filter of the catalogue</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>rim T3 thickness&gt;6</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, -burnt, note:* also work.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export these</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Your initials</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sherds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Search</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give numbers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take away the condition %1</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>No sherds yet. They come by themselves when a batch is computed; start with Capture.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No sherd fits. Take a condition away.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>change %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>move to another context</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The sherds that are chosen have their numbers.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportModel</name>
    <message>
      <source>Size of the export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Counting …</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No sherd fits; choose others.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>less than a minute</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>There is a folder of this name already; choose another name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message numerus="yes">
      <source>%1, %n second(s) left</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>Export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stopped; nothing was left behind.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportStation</name>
    <message>
      <source>Exported: %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All sherds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Those that fit this filter:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filter of what is exported</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>context:0012</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Forms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tables (CSV), for spreadsheets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Records (JSON), to be read back whole</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A picture of each model (PNG)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Models as PLY, in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Models as GLB, for the web and for slides</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Models as OBJ, in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The photographs, unchanged</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wo</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose …</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Progress of the export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where shall the folder be?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Those chosen in the catalogue</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>The %n chosen in the catalogue</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
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
      <translation>Rückgängig:</translation>
    </message>
    <message>
      <source>Do again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Wiederholen:</translation>
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
  </context>
  <context>
    <name>ostraka::ui::MapStation</name>
    <message>
      <source>Batch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Print map and labels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Print map and labels   Ctrl+P</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sherd %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No batch is computed yet; its map appears here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Map of %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1-%2</source>
      <translation type="unfinished">%1-%2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ladung %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Map and labels are sent to the printer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Map</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sherd %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>front</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>back</source>
      <translation type="unfinished" />
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>The turning angles differ by %1 rad.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>outlines on each other</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>turning angles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>differ by %1 rad</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::PairReviewModel</name>
    <message>
      <source>Small pictures of the sherds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1, %2. %3</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No back is chosen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rims do not meet here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rims %1 apart, %2 of them meet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turned by hand; B lets the rims settle it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start point %1; B lets the rims settle it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No pair is chosen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a back first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>choice of %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Comparing two sides</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>pair %1 – %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>setting aside %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>shooting %1 again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One of the two has no back to be joined.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>joining %1 and %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cutting %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>start point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>settling by the rims</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>turning by hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Closed model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This pair has no closed model yet; it is made when the batch is computed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of a pair</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>More candidates</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Vorn %1, hinten %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>front %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>back %1, mirrored</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>back %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Draw a line over the piece where it is to be cut.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 mm</source>
      <translation type="unfinished" />
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>This one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Next pair</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Previous pair</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Candidate %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start point before</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Next start point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One sample back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One sample on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mirror back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Apart</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rim gap</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Settle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Let the rims settle the position (B)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set aside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shoot again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cut</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cut a piece that is two sherds in truth: draw a line over its picture (K)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Join</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Join two pieces of one sherd: then choose the other card (J)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>%1, key %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This one   Enter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Which piece belongs to %1? Choose its card.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rims are compared …</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>… and the other end</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewStation</name>
    <message>
      <source>Batch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Your &amp;initials</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Your initials</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compute what changed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Makes the models of the pairs that were decided anew</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No batch is computed yet. Shoot or import one; its pairs appear here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opening %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 waits to be computed; only what changed is done again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saved. The pairs of the new pieces come when it is computed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Taken back. Both are kept in the history.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saved, with your name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No pair needs your eye</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>%n pair(s) need your eye</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>Review</source>
      <translation type="unfinished" />
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
    <name>ostraka::ui::SherdDetails</name>
    <message>
      <source>missing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>changed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>present</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Details of the sherd</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of the sherd</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of the sherd</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture of the sherd in the way</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measurements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>when</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>who</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>what</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>History</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>kind</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>state</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Files</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Context</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>context</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no number yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the number %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>added</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>%1: %2 → %3</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>nothing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 It is %2.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdEdits</name>
    <message numerus="yes">
      <source>number %n sherd(s)</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdTableModel</name>
    <message>
      <source>Picture of a sherd</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>not recorded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no number yet</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdView</name>
    <message>
      <source>Sherd in three dimensions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the sherd cannot be shown in three dimensions. Everything else works; photographs and outlines are beside.</source>
      <translation type="unfinished" />
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>front: blue rim</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>back: red rim</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 mm and more</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>0 mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>gap between the sides along the rim</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>
