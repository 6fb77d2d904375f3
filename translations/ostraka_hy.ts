<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hy" sourcelanguage="en">
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>PlaceText</name>
    <message>
      <source>%1 bag %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տոպրակ %2</translation>
    </message>
    <message>
      <source>A site, a context and a bag are needed so that the sherds can be numbered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները համարակալելու համար պետք են հուշարձան, համատեքստ և տոպրակ։</translation>
    </message>
  </context>
  <context>
    <name>Rig</name>
    <message>
      <source>its file is missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ֆայլը բացակայում է</translation>
    </message>
    <message>
      <source>ready (calibrated today)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատրաստ է (տրամաչափված է այսօր)</translation>
    </message>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>պատրաստ է (%n օրվա)</numerusform>
        <numerusform>պատրաստ է (%n օրվա)</numerusform>
      </translation>
    </message>
    <message>
      <source>virtual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վիրտուալ</translation>
    </message>
  </context>
  <context>
    <name>Stage</name>
    <message>
      <source>cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեսախցիկներ</translation>
    </message>
    <message>
      <source>sherd or plate, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկոր թե սկավառակ, առջև</translation>
    </message>
    <message>
      <source>sherd or plate, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկոր թե սկավառակ, հետև</translation>
    </message>
    <message>
      <source>surface, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մակերևույթ, առջև</translation>
    </message>
    <message>
      <source>surface, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մակերևույթ, հետև</translation>
    </message>
    <message>
      <source>one scan a sherd, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մեկ սկան ամեն բեկորին, առջև</translation>
    </message>
    <message>
      <source>one scan a sherd, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մեկ սկան ամեն բեկորին, հետև</translation>
    </message>
    <message>
      <source>which back belongs to which front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>որ հետևի երեսը որ առջևինն է</translation>
    </message>
    <message>
      <source>models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մոդելներ</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հաշվետվություն</translation>
    </message>
    <message>
      <source>catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կատալոգ</translation>
    </message>
    <message>
      <source>begins</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկսվում է</translation>
    </message>
  </context>
  <context>
    <name>Time</name>
    <message numerus="yes">
      <source>%n s left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>մնաց %n վ</numerusform>
        <numerusform>մնաց %n վ</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>մնաց %n րոպե</numerusform>
        <numerusform>մնաց %n րոպե</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 h %2 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մնաց %1 ժ %2 րոպե</translation>
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
      <translation type="unfinished" />
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
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s): sure %1, ask %2</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>%1; joined to %2 mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Warning: %1</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>%1 is computed: %n sherd(s).</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>You stopped it. What was computed so far is kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>You took it out of the queue.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>again</source>
      <translation type="unfinished" />
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) wait.</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1: %2, %3 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, %3 %</translation>
    </message>
    <message>
      <source>being photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>լուսանկարվում է</translation>
    </message>
    <message>
      <source>waits for its turn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սպասում է հերթին</translation>
    </message>
    <message>
      <source>is being computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հաշվարկվում է</translation>
    </message>
    <message>
      <source>paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դադարի մեջ է</translation>
    </message>
    <message>
      <source>stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կանգնեցված է</translation>
    </message>
    <message>
      <source>wants your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պահանջում է ձեր աչքը</translation>
    </message>
    <message>
      <source>done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ավարտված է</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BigButton</name>
    <message>
      <source>Key: %1</source>
      <translation type="unfinished" />
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
      <translation>%1-ը հերթում է։</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1՝ ներմուծվեց %n ֆայլ. հերթում է։</numerusform>
        <numerusform>%1՝ ներմուծվեց %n ֆայլ. հերթում է։</numerusform>
      </translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լավ</translation>
    </message>
    <message>
      <source>The next thing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդ քայլը</translation>
    </message>
    <message>
      <source>Stop the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել սեղանը</translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարել կրկին</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել լուսանկարներ…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել սկաններ…</translation>
    </message>
    <message>
      <source>Another rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ սարքակազմ…</translation>
    </message>
    <message>
      <source>Camera %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1</translation>
    </message>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացատ</translation>
    </message>
    <message>
      <source>More</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ավելին</translation>
    </message>
    <message>
      <source>Import, another rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել, այլ սարքակազմ</translation>
    </message>
    <message>
      <source>Capture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նկարահանում</translation>
    </message>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>front/ և back/ սկաններով պանակ</translation>
    </message>
    <message>
      <source>Folder of a batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակի պանակ</translation>
    </message>
    <message>
      <source>The picture is on its way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերը գալիս է։</translation>
    </message>
    <message>
      <source>Look at this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ նայեք սրան</translation>
    </message>
    <message>
      <source>R</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>R</translation>
    </message>
    <message>
      <source>does not answer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>չի պատասխանում</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը բացվում է</translation>
    </message>
    <message>
      <source>%1 goes on where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը շարունակվում է կանգ առած տեղից։</translation>
    </message>
    <message>
      <source>Photographs of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի լուսանկարները</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղմեք %1 տեսախցիկի կոճակը։</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are safe.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Այս երեսի %n լուսանկարն ապահով է։</numerusform>
        <numerusform>Այս երեսի %n լուսանկարներն ապահով են։</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at stop %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1, կանգառ %2՝ %3</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>Live picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կենդանի պատկեր</translation>
    </message>
    <message>
      <source>Front picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի պատկեր</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմ դեռ չկա</translation>
    </message>
    <message>
      <source>The rig is being opened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը բացվում է</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրեք խեցաբեկորները սկավառակին</translation>
    </message>
    <message>
      <source>Stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցված է</translation>
    </message>
    <message>
      <source>Photographing the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարվում են առջևի երեսները</translation>
    </message>
    <message>
      <source>Turn each sherd over where it lies</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջեք ամեն բեկոր իր տեղում</translation>
    </message>
    <message>
      <source>Photographing the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարվում են հետևի երեսները</translation>
    </message>
    <message>
      <source>You may clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարող եք ազատել սկավառակը։</translation>
    </message>
    <message>
      <source>Look at the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ազատելուց առաջ նայեք սկավառակին</translation>
    </message>
    <message>
      <source>Fronts up, a finger's width apart, the marks at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսը վեր, մեկ մատ հեռավորություն, եզրի նշաններն ազատ։</translation>
    </message>
    <message>
      <source>Hands off the table. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեռք մի տվեք սեղանին։ Esc-ը անմիջապես կանգնեցնում է այն։</translation>
    </message>
    <message>
      <source>Shifting is fine, swapping is fine, losing one is not.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեղաշարժել կարելի է, փոխատեղել՝ նույնպես, կորցնել՝ ոչ։</translation>
    </message>
    <message>
      <source>%1 is in the queue; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը հերթում է. հաջորդ խմբաքանակը մեկ սեղմում հեռու է։</translation>
    </message>
    <message>
      <source>Space goes on all the same, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացատը շարունակում է ամեն դեպքում, R-ը կրկին լուսանկարում է հետևի երեսները։</translation>
    </message>
    <message>
      <source>Done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատրաստ է</translation>
    </message>
    <message>
      <source>Try again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձել կրկին</translation>
    </message>
    <message>
      <source>Shoot the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարել առջևի երեսները</translation>
    </message>
    <message>
      <source>All turned: shoot the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բոլորը շրջված են. լուսանկարել հետևի երեսները</translation>
    </message>
    <message>
      <source>Next batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդ խմբաքանակը</translation>
    </message>
    <message>
      <source>It is right: into the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ճիշտ է. դնել հերթի</translation>
    </message>
    <message>
      <source>Stop %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգառ %1՝ %2-ից</translation>
    </message>
    <message>
      <source>One moment</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ վայրկյան</translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Առջև՝ %n բեկոր</numerusform>
        <numerusform>Առջև՝ %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>Front: %1 sherds, now %2 are seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջև՝ %1 բեկոր, հիմա երևում է %2</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջև %1, հետև %2</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) are safe</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n լուսանկարն ապահով է</numerusform>
        <numerusform>%n լուսանկարներն ապահով են</numerusform>
      </translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեսախցիկը կենդանի պատկեր չի ցույց տալիս։</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Երևում է %n բեկոր</numerusform>
        <numerusform>Երևում է %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 and %2 nearly touch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը և %2-ը գրեթե դիպչում են</translation>
    </message>
    <message>
      <source>%1 reaches out of the picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը դուրս է գալիս պատկերից</translation>
    </message>
    <message>
      <source>Marks %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշաններ՝ %1 %2-ից</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too dark</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորների %1 %-ը չափազանց մութ է</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too bright</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորների %1 %-ը չափազանց լուսավոր է</translation>
    </message>
    <message>
      <source>Light is right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լույսը ճիշտ է</translation>
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
      <translation type="unfinished" />
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>What was done</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Progress of the computation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing to compute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվելու բան չկա</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HeaderLine</name>
    <message>
      <source>Where</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Room on the disk</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմ՝ %1</translation>
    </message>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Սկավառակ՝ տեղ %n խմբաքանակի համար</numerusform>
        <numerusform>Սկավառակ՝ տեղ %n խմբաքանակի համար</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HelpPage</name>
    <message>
      <source>Manual</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Contents</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All &amp;keys</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;About</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերադառնալ աշխատանքին (Esc)</translation>
    </message>
    <message>
      <source>All keys</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Complete, measured 3D models of potsherds from photographs of both their sides.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing leaves this computer: there is no network in it.</source>
      <translation type="unfinished" />
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
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 stopped: %2</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետարկել</translation>
    </message>
    <message>
      <source>Do again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կրկնել</translation>
    </message>
    <message>
      <source>Manual</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All keys</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Other projects</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծեր</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարգավորումներ</translation>
    </message>
    <message>
      <source>Help</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Օգնություն</translation>
    </message>
    <message>
      <source>Back to work</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This project is open in another window already: go on there.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 - Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 - Ostraka</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Virtual rig %1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Everywhere</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Room on the disk</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translation type="unfinished" />
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
      <translation type="unfinished" />
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
      <translation>Ինչ պատահեց</translation>
    </message>
    <message>
      <source>Leave it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թողնել</translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լավ</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site's code has two to eight capital letters and digits, like ARM1.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a folder for the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is a project in this folder already: open it, or choose another folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This folder holds other files: choose a new one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Virtual rig</source>
      <translation type="unfinished" />
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
      <translation>Առջև %1, հետև %2</translation>
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
      <translation>&amp;Տոպրակ</translation>
    </message>
    <message>
      <source>scan its label, or ARM1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կարդացրեք պիտակը կամ ARM1-T3-0012-4</translation>
    </message>
    <message>
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձան, խրամատ, համատեքստ և տոպրակ</translation>
    </message>
    <message>
      <source>no bag: no numbers yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տոպրակ չկա՝ համարներ դեռ չկան</translation>
    </message>
    <message>
      <source>site-trench-context-bag, please</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>խնդրում ենք՝ հուշարձան-խրամատ-համատեքստ-տոպրակ</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlateView</name>
    <message>
      <source>Picture of the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի պատկերը</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Երևում է %n բեկոր</numerusform>
        <numerusform>Երևում է %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>5 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>5 սմ</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::QueueStation</name>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դադար</translation>
    </message>
    <message>
      <source>Compute again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop this batch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Review it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մատյան</translation>
    </message>
    <message>
      <source>Batches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Log of the computation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No batch yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What you photograph or import is computed here, one batch after the other, while you go on working.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Photograph the first batch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հերթ</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translation type="unfinished">
        <numerusform />
        <numerusform />
      </translation>
    </message>
    <message>
      <source>Go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շարունակել</translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop %1?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It has been computed for more than an hour. Whole stages are kept, the present one is lost.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Let it go on</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>ostraka::ui::Rail</name>
    <message>
      <source>Stations</source>
      <translation type="unfinished" />
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
      <translation>Դրանցից երկուսը նման են</translation>
    </message>
    <message>
      <source>What do you photograph with?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչո՞վ եք լուսանկարում</translation>
    </message>
    <message>
      <source>The virtual rig breaks a pot and photographs its sherds: try everything with it. A rig file (RIG.json) names your cameras and your turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիրտուալ սարքակազմը կոտրում է անոթ և լուսանկարում բեկորները. փորձեք ամեն ինչ դրանով։ Սարքակազմի ֆայլը (RIG.json) նշում է ձեր տեսախցիկներն ու պտտվող սեղանը։</translation>
    </message>
    <message>
      <source>Use the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Օգտագործել վիրտուալ սարքակազմը</translation>
    </message>
    <message>
      <source>Choose a rig file…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել սարքակազմի ֆայլ…</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել լուսանկարներ…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել սկաններ…</translation>
    </message>
    <message>
      <source>The virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիրտուալ սարքակազմ</translation>
    </message>
    <message>
      <source>small: a batch in a minute or two</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոքր՝ խմբաքանակը մեկ-երկու րոպեում</translation>
    </message>
    <message>
      <source>normal</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սովորական</translation>
    </message>
    <message>
      <source>fine: as a real camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մանրամասն՝ ինչպես իրական տեսախցիկը</translation>
    </message>
    <message>
      <source>&amp;Sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Բեկորներ սկավառակին</translation>
    </message>
    <message>
      <source>&amp;Photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Լուսանկարներ</translation>
    </message>
    <message>
      <source>%1 pixels wide</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 պիքսել լայնություն</translation>
    </message>
    <message>
      <source>Rig file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմի ֆայլ</translation>
    </message>
    <message>
      <source>Rig (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմ (*.json)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SettingsPage</name>
    <message>
      <source>As the desktop</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Light</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dark, for the tent</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sunlight: black on white, thick lines</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>all</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարգավորումներ</translation>
    </message>
    <message>
      <source>&amp;Your initials</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>They stand in the history of each decision.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Theme</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Te&amp;xt size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Text size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Language</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Holds from the next start.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Processors for computing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերադառնալ աշխատանքին (Esc)</translation>
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
      <translation>Խեցաբեկորներ՝ երկու երեսով, ամբողջական և չափված։</translation>
    </message>
    <message>
      <source>&amp;Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Նախագծեր</translation>
    </message>
    <message>
      <source>No project yet. Make one, or try everything with the virtual rig: it breaks a pot and photographs its sherds for you.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Open a project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Բացել նախագիծ…</translation>
    </message>
    <message>
      <source>Try with the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձել վիրտուալ սարքակազմով</translation>
    </message>
    <message>
      <source>New project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր նախագիծ</translation>
    </message>
    <message>
      <source>Aragats 2026</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aragats 2026</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Make the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստեղծել նախագիծը</translation>
    </message>
    <message>
      <source>&amp;Name</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Site code</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A sherd will be</source>
      <translation type="unfinished" />
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
      <translation>Լավ</translation>
    </message>
    <message>
      <source>Folder of the new project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder of a project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծեր</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::StopBoard</name>
    <message>
      <source>Photographs of this side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս երեսի լուսանկարները</translation>
    </message>
    <message>
      <source>%1 of %2 stops are done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արված է %2 կանգառից %1-ը</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Thumbnails</name>
    <message>
      <source>Picture</source>
      <translation type="unfinished" />
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
