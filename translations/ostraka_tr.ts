<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
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
      <translation>%1 torba %2</translation>
    </message>
    <message>
      <source>A site, a context and a bag are needed so that the sherds can be numbered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların numaralanması için alan, kontekst ve torba gerekir.</translation>
    </message>
  </context>
  <context>
    <name>Rig</name>
    <message>
      <source>its file is missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dosyası yok</translation>
    </message>
    <message>
      <source>ready (calibrated today)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hazır (bugün ayarlandı)</translation>
    </message>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>hazır (%n günlük)</numerusform>
      </translation>
    </message>
    <message>
      <source>virtual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sanal</translation>
    </message>
  </context>
  <context>
    <name>Stage</name>
    <message>
      <source>cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kameralar</translation>
    </message>
    <message>
      <source>sherd or plate, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parça mı tabla mı, ön</translation>
    </message>
    <message>
      <source>sherd or plate, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parça mı tabla mı, arka</translation>
    </message>
    <message>
      <source>surface, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yüzey, ön</translation>
    </message>
    <message>
      <source>surface, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yüzey, arka</translation>
    </message>
    <message>
      <source>one scan a sherd, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parça başına bir tarama, ön</translation>
    </message>
    <message>
      <source>one scan a sherd, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parça başına bir tarama, arka</translation>
    </message>
    <message>
      <source>which back belongs to which front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hangi arka yüz hangi ön yüzün</translation>
    </message>
    <message>
      <source>models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>modeller</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rapor</translation>
    </message>
    <message>
      <source>catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>katalog</translation>
    </message>
    <message>
      <source>begins</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>başlıyor</translation>
    </message>
  </context>
  <context>
    <name>Time</name>
    <message numerus="yes">
      <source>%n s left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n sn kaldı</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n dk kaldı</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 h %2 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sa %2 dk kaldı</translation>
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
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translation type="unfinished">
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
      <translation>fotoğraflanıyor</translation>
    </message>
    <message>
      <source>waits for its turn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sırasını bekliyor</translation>
    </message>
    <message>
      <source>is being computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hesaplanıyor</translation>
    </message>
    <message>
      <source>paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>duraklatıldı</translation>
    </message>
    <message>
      <source>stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>durdu</translation>
    </message>
    <message>
      <source>wants your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>gözünüzü bekliyor</translation>
    </message>
    <message>
      <source>done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bitti</translation>
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
      <translation>%1 sırada.</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: %n dosya alındı; sırada.</numerusform>
      </translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tamam</translation>
    </message>
    <message>
      <source>The next thing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki iş</translation>
    </message>
    <message>
      <source>Stop the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masayı durdur</translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden çek</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf al…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tarama al…</translation>
    </message>
    <message>
      <source>Another rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka düzenek…</translation>
    </message>
    <message>
      <source>Camera %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1</translation>
    </message>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşluk</translation>
    </message>
    <message>
      <source>More</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Daha</translation>
    </message>
    <message>
      <source>Import, another rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Al, başka düzenek</translation>
    </message>
    <message>
      <source>Capture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çekim</translation>
    </message>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>front/ ve back/ taramaları olan klasör</translation>
    </message>
    <message>
      <source>Folder of a batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir partinin klasörü</translation>
    </message>
    <message>
      <source>The picture is on its way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Görüntü geliyor.</translation>
    </message>
    <message>
      <source>Look at this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce buna bakın</translation>
    </message>
    <message>
      <source>R</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>R</translation>
    </message>
    <message>
      <source>does not answer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yanıt vermiyor</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek açılıyor</translation>
    </message>
    <message>
      <source>%1 goes on where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kaldığı yerden sürüyor.</translation>
    </message>
    <message>
      <source>Photographs of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 fotoğrafları</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kamerasının deklanşörüne basın.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are safe.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Bu yüzün şimdiye kadarki %n fotoğrafı güvende.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at stop %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, durak %2: %3</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>Live picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Canlı görüntü</translation>
    </message>
    <message>
      <source>Front picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz görüntüsü</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz düzenek yok</translation>
    </message>
    <message>
      <source>The rig is being opened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek açılıyor</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaları tablaya yerleştirin</translation>
    </message>
    <message>
      <source>Stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durdu</translation>
    </message>
    <message>
      <source>Photographing the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzler fotoğraflanıyor</translation>
    </message>
    <message>
      <source>Turn each sherd over where it lies</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her parçayı yerinde ters çevirin</translation>
    </message>
    <message>
      <source>Photographing the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzler fotoğraflanıyor</translation>
    </message>
    <message>
      <source>You may clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablayı boşaltabilirsiniz.</translation>
    </message>
    <message>
      <source>Look at the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşaltmadan önce tablaya bakın</translation>
    </message>
    <message>
      <source>Fronts up, a finger's width apart, the marks at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz yukarıda, bir parmak aralık, kenardaki işaretler açıkta.</translation>
    </message>
    <message>
      <source>Hands off the table. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masaya dokunmayın. Esc hemen durdurur.</translation>
    </message>
    <message>
      <source>Shifting is fine, swapping is fine, losing one is not.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydırmak olur, yer değiştirmek olur, kaybetmek olmaz.</translation>
    </message>
    <message>
      <source>%1 is in the queue; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sırada; sonraki parti bir tuş ötede.</translation>
    </message>
    <message>
      <source>Space goes on all the same, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşluk yine de sürdürür, R arka yüzleri yeniden çeker.</translation>
    </message>
    <message>
      <source>Done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tamam</translation>
    </message>
    <message>
      <source>Try again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden dene</translation>
    </message>
    <message>
      <source>Shoot the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzleri çek</translation>
    </message>
    <message>
      <source>All turned: shoot the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hepsi çevrildi: arka yüzleri çek</translation>
    </message>
    <message>
      <source>Next batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki parti</translation>
    </message>
    <message>
      <source>It is right: into the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Doğru: sıraya al</translation>
    </message>
    <message>
      <source>Stop %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durak %1 / %2</translation>
    </message>
    <message>
      <source>One moment</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir saniye</translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ön: %n parça</numerusform>
      </translation>
    </message>
    <message>
      <source>Front: %1 sherds, now %2 are seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön: %1 parça, şimdi %2 görünüyor</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön %1, arka %2</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) are safe</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fotoğraf güvende</numerusform>
      </translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kamera canlı görüntü vermiyor.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça görünüyor</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 and %2 nearly touch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ile %2 neredeyse değiyor</translation>
    </message>
    <message>
      <source>%1 reaches out of the picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 görüntünün dışına taşıyor</translation>
    </message>
    <message>
      <source>Marks %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşaretler %1 / %2</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too dark</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların %1 kadarı (yüzde) çok karanlık</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too bright</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların %1 kadarı (yüzde) çok parlak</translation>
    </message>
    <message>
      <source>Light is right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Işık uygun</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CatalogueStation</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translation type="unfinished">
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
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translation type="unfinished">
        <numerusform />
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model</source>
      <translation type="unfinished">
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
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translation type="unfinished">
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
      <translation>Hesaplanacak bir şey yok</translation>
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
      <translation>Düzenek: %1</translation>
    </message>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Disk: %n partilik yer</numerusform>
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
      <translation>İşe dön (Esc)</translation>
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
      <translation>Geri al</translation>
    </message>
    <message>
      <source>Do again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yinele</translation>
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
      <translation>Projeler</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ayarlar</translation>
    </message>
    <message>
      <source>Help</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yardım</translation>
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
      <translation>Ne oldu</translation>
    </message>
    <message>
      <source>Leave it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bırak</translation>
    </message>
    <message>
      <source>All right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tamam</translation>
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
      <translation>Ön %1, arka %2</translation>
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
      <translation>&amp;Torba</translation>
    </message>
    <message>
      <source>scan its label, or ARM1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>etiketini okutun ya da ARM1-T3-0012-4</translation>
    </message>
    <message>
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan, açma, kontekst ve torba</translation>
    </message>
    <message>
      <source>no bag: no numbers yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>torba yok: henüz numara yok</translation>
    </message>
    <message>
      <source>site-trench-context-bag, please</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>lütfen alan-açma-kontekst-torba</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlateView</name>
    <message>
      <source>Picture of the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın görüntüsü</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça görünüyor</numerusform>
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
      <translation>Duraklat</translation>
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
      <translation>Günlük</translation>
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
      <translation>Sıra</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translation type="unfinished">
        <numerusform />
      </translation>
    </message>
    <message>
      <source>Go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sürdür</translation>
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
      <translation>İkisi birbirine benzer</translation>
    </message>
    <message>
      <source>What do you photograph with?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neyle fotoğraf çekiyorsunuz?</translation>
    </message>
    <message>
      <source>The virtual rig breaks a pot and photographs its sherds: try everything with it. A rig file (RIG.json) names your cameras and your turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzenek bir kap kırar ve parçalarını fotoğraflar: her şeyi onunla deneyin. Düzenek dosyası (RIG.json) kameralarınızı ve döner masanızı adlandırır.</translation>
    </message>
    <message>
      <source>Use the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzeneği kullan</translation>
    </message>
    <message>
      <source>Choose a rig file…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek dosyası seç…</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf al…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tarama al…</translation>
    </message>
    <message>
      <source>The virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzenek</translation>
    </message>
    <message>
      <source>small: a batch in a minute or two</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>küçük: bir parti bir iki dakikada</translation>
    </message>
    <message>
      <source>normal</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>normal</translation>
    </message>
    <message>
      <source>fine: as a real camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ince: gerçek kamera gibi</translation>
    </message>
    <message>
      <source>&amp;Sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabladaki &amp;parçalar</translation>
    </message>
    <message>
      <source>&amp;Photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Fotoğraflar</translation>
    </message>
    <message>
      <source>%1 pixels wide</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 piksel genişlik</translation>
    </message>
    <message>
      <source>Rig file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek dosyası</translation>
    </message>
    <message>
      <source>Rig (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek (*.json)</translation>
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
      <translation>Ayarlar</translation>
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
      <translation>İşe dön (Esc)</translation>
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
      <translation>Çanak parçaları, iki yüzü, eksiksiz ve ölçülmüş.</translation>
    </message>
    <message>
      <source>&amp;Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Projeler</translation>
    </message>
    <message>
      <source>No project yet. Make one, or try everything with the virtual rig: it breaks a pot and photographs its sherds for you.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&amp;Open a project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Proje &amp;aç…</translation>
    </message>
    <message>
      <source>Try with the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzenekle dene</translation>
    </message>
    <message>
      <source>New project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni proje</translation>
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
      <translation>Projeyi oluştur</translation>
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
      <translation>Tamam</translation>
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
      <translation>Projeler</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::StopBoard</name>
    <message>
      <source>Photographs of this side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yüzün fotoğrafları</translation>
    </message>
    <message>
      <source>%1 of %2 stops are done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 duraktan %1 tamam</translation>
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
