<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
  <context>
    <name>ComputeBatch</name>
    <message>
      <source>The disk has only %1 MB left; a batch needs more. Nothing is lost: make room, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diskte yalnızca %1 MB kaldı; bir parti daha fazlasını ister. Hiçbir şey kaybolmadı: yer açın, sonra sürdürün.</translation>
    </message>
    <message>
      <source>%1: this number was typed on the plate, but no sherd with a context lies there; give it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: bu numara tabla üzerinde yazıldı, ama orada konteksti olan bir parça yok; numarayı katalogda verin.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) were counted on the plate, and another number was found; look at the map for one that is missing or cut in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Tabla üzerinde %n parça sayıldı, başka bir sayı bulundu; eksik olanı ya da ikiye bölüneni planda arayın.</numerusform>
      </translation>
    </message>
    <message>
      <source>Pairs were decided while the batch was computed; compute it again for them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti hesaplanırken çiftlere karar verildi; onlar için yeniden hesaplayın.</translation>
    </message>
  </context>
  <context>
    <name>Fields</name>
    <message>
      <source>number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>numara</translation>
    </message>
    <message>
      <source>identifier</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kimlik</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>durum</translation>
    </message>
    <message>
      <source>void because</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geçersiz, çünkü</translation>
    </message>
    <message>
      <source>site</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>alan</translation>
    </message>
    <message>
      <source>trench</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>açma</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kontekst</translation>
    </message>
    <message>
      <source>bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>torba</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bölüm</translation>
    </message>
    <message>
      <source>ware</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>mal grubu</translation>
    </message>
    <message>
      <source>fabric</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hamur</translation>
    </message>
    <message>
      <source>inclusions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>katkı</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yapım</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pişirim</translation>
    </message>
    <message>
      <source>surface outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dış yüzey</translation>
    </message>
    <message>
      <source>surface inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>iç yüzey</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bezeme</translation>
    </message>
    <message>
      <source>Munsell outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell dış</translation>
    </message>
    <message>
      <source>Munsell inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell iç</translation>
    </message>
    <message>
      <source>Munsell core</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell öz</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>korunma durumu</translation>
    </message>
    <message>
      <source>joins with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>birleştiği</translation>
    </message>
    <message>
      <source>vessel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kap</translation>
    </message>
    <message>
      <source>period</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dönem</translation>
    </message>
    <message>
      <source>date</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tarih</translation>
    </message>
    <message>
      <source>length, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>uzunluk, mm</translation>
    </message>
    <message>
      <source>width, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>genişlik, mm</translation>
    </message>
    <message>
      <source>thickness least, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en az kalınlık, mm</translation>
    </message>
    <message>
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kalınlık, mm</translation>
    </message>
    <message>
      <source>thickness most, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en çok kalınlık, mm</translation>
    </message>
    <message>
      <source>area, mm²</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>alan, mm²</translation>
    </message>
    <message>
      <source>volume, mm³</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hacim, mm³</translation>
    </message>
    <message>
      <source>not seen, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>görülmeyen, %</translation>
    </message>
    <message>
      <source>rim diameter, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ağız çapı, mm</translation>
    </message>
    <message>
      <source>rim kept, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>korunan ağız, %</translation>
    </message>
    <message>
      <source>weight, g</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ağırlık, g</translation>
    </message>
    <message>
      <source>batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parti</translation>
    </message>
    <message>
      <source>note</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>not</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ölçek</translation>
    </message>
  </context>
  <context>
    <name>Job</name>
    <message>
      <source>The memory does not suffice; close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bellek yetmiyor; başka programları kapatıp yeniden deneyin.</translation>
    </message>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu programın bir hatasıdır; lütfen günlükle (%1) birlikte bildirin.</translation>
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
    <message>
      <source>site %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>alan %1</translation>
    </message>
    <message>
      <source>trench %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>açma %1</translation>
    </message>
    <message>
      <source>context %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kontekst %1</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>torba %1</translation>
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
    <message>
      <source>more candidates for doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kuşkulu çiftler için başka adaylar</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>numaralı</translation>
    </message>
    <message>
      <source>void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geçersiz</translation>
    </message>
    <message>
      <source>draft</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>taslak</translation>
    </message>
    <message>
      <source>on a scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tartıyla</translation>
    </message>
    <message>
      <source>with a calliper</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kumpasla</translation>
    </message>
    <message>
      <source>estimated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tahminî</translation>
    </message>
    <message>
      <source>by the program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>programca</translation>
    </message>
    <message>
      <source>aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kenara</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yeniden</translation>
    </message>
    <message>
      <source>%1 or %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ya da %2</translation>
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf artık yok.</translation>
    </message>
    <message>
      <source>The printer or file cannot be written; choose another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazıcıya ya da dosyaya yazılamıyor; başka birini seçin.</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ön yüz</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka yüz</translation>
    </message>
    <message>
      <source>The printer took no further page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazıcı başka sayfa almadı.</translation>
    </message>
    <message>
      <source>The printer or file could not be finished; is the disk full?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazdırma ya da dosya tamamlanamadı; disk dolu mu?</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3: their rims differ by %4 only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2 ikisi de %3 ile uyuyor: kenarları yalnız %4 farklı.</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2 ikisi de %3 ile uyuyor.</translation>
    </message>
    <message>
      <source>%1 would fit %2 nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 ile neredeyse aynı ölçüde uyardı.</translation>
    </message>
    <message>
      <source>Another partner fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir eş neredeyse aynı ölçüde uyuyor.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzü başka bir ön yüze verildi: şimdi doğrusu %1 mi?</translation>
    </message>
    <message>
      <source>%1 fits hardly better than a stranger's back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, yabancı bir parçanın arka yüzünden pek de iyi uymuyor.</translation>
    </message>
    <message>
      <source>The two sides fit nearly as well in another position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki yüz başka bir konumda neredeyse aynı ölçüde uyuyor.</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>under 1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 % altında</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>The back lies upside down: both sides face the same way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz ters duruyor: iki yüz de aynı yöne bakıyor.</translation>
    </message>
    <message>
      <source>The faces cross: %1 of the front lies behind the back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yüzler kesişiyor: ön yüzün %1 kadarı arka yüzün gerisinde.</translation>
    </message>
    <message>
      <source>The two scans share almost no broken edge; outlines alone tie them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki taramanın neredeyse hiç ortak kırığı yok; onları yalnız dış çizgiler bağlıyor.</translation>
    </message>
    <message>
      <source>The broken edges do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıklar uymuyor: arada %1.</translation>
    </message>
    <message>
      <source>The rim hardly fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenar konumu pek belirlemiyor: belirsizlik %1.</translation>
    </message>
    <message>
      <source>A place %1 along the rim fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenar boyunca %1 ötedeki bir yer neredeyse aynı ölçüde uyuyor.</translation>
    </message>
    <message>
      <source>The rims cannot be compared; outlines alone tie these sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarlar karşılaştırılamıyor; bu yüzleri yalnız dış çizgiler bağlıyor.</translation>
    </message>
    <message>
      <source>look</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bakın</translation>
    </message>
    <message>
      <source>no back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka yüz yok</translation>
    </message>
    <message>
      <source>sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kesin</translation>
    </message>
    <message>
      <source>decided</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>karar verildi</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kenara ayrıldı</translation>
    </message>
    <message>
      <source>shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yeniden çekin</translation>
    </message>
    <message>
      <source>%1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 – %2</translation>
    </message>
    <message>
      <source>No back was found for it. Choose one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz bulunamadı. Birini seçin ya da parçayı kenara ayırın.</translation>
    </message>
    <message>
      <source>The program is sure: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Program emin: %1.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kararı veren %1, %2.</translation>
    </message>
    <message>
      <source>Set aside by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenara ayıran %1, %2.</translation>
    </message>
    <message>
      <source>To be shot again, says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden çekilsin diyen %1, %2.</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>torba %1</translation>
    </message>
    <message>
      <source>no front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ön yüz yok</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arka yüz kenara ayrıldı. Yine de kullanmak için bir ön yüzün üzerine sürükleyin.</translation>
    </message>
    <message>
      <source>This back is to be shot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arka yüz yeniden çekilecek.</translation>
    </message>
    <message>
      <source>No front holds this back. Drag it onto its front, join it to another, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arka yüz hiçbir ön yüzde değil. Ön yüzünün üzerine sürükleyin, başka birine ekleyin ya da kenara ayırın.</translation>
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
        <numerusform>%n parçadan %1</numerusform>
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
      <translation>şüpheli</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça</numerusform>
      </translation>
    </message>
    <message>
      <source>Its back %1 was given to %2: is %3 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzü %1, %2 ön yüzüne verildi: şimdi doğrusu %3 mi?</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2. Choose another one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzü %1, %2 ön yüzüne verildi. Başkasını seçin ya da parçayı kenara ayırın.</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2; next best %3, %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzü %1, %2 ön yüzüne verildi; sıradaki en iyisi %3, %4.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2, turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kararı veren %1, %2, elle döndürüldü.</translation>
    </message>
    <message>
      <source>The rims hardly meet: %1 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarlar pek buluşmuyor: buluşan pay %1.</translation>
    </message>
    <message>
      <source>by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>elle</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>başlangıç noktası</translation>
    </message>
    <message>
      <source>settled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>oturtuldu</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elle döndürüldü: kenarların buluşan payı %1.</translation>
    </message>
    <message>
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elle döndürüldü.</translation>
    </message>
    <message>
      <source>Another start point is tried: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir başlangıç noktası deneniyor: kenarların buluşan payı %1.</translation>
    </message>
    <message>
      <source>Another start point is tried.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir başlangıç noktası deneniyor.</translation>
    </message>
    <message>
      <source>Settled by the rims: %1 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarlarla oturtuldu: buluşan pay %1.</translation>
    </message>
    <message>
      <source>Settled by the rims.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarlarla oturtuldu.</translation>
    </message>
    <message>
      <source>%1 is tried: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 deneniyor: %2.</translation>
    </message>
    <message>
      <source>%1 is tried: %2, rims %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 deneniyor: %2, kenar aralığı %3.</translation>
    </message>
    <message>
      <source>%1 is tried: %2; its rims do not meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 deneniyor: %2; kenarlar buluşmuyor.</translation>
    </message>
    <message>
      <source>%1 decided for %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 için karar verdi.</translation>
    </message>
    <message>
      <source>The program says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Program %1 diyor, %2.</translation>
    </message>
    <message>
      <source>Joined with %1 by %2; it is one piece once the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2, %1 ile birleştirdi; parti hesaplanınca tek parça olur.</translation>
    </message>
    <message>
      <source>Cut in two by %1; its pieces come when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ikiye kesti; parçaları parti hesaplanınca gelir.</translation>
    </message>
    <message>
      <source>joined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>birleştirildi</translation>
    </message>
    <message>
      <source>cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kesildi</translation>
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
      <translation>%1 alınıyor</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kopya yerine konamıyor: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça, hepsi kesin</numerusform>
      </translation>
    </message>
    <message>
      <source>a draft: look, then compute it again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>taslak: bakın, sonra yeniden hesaplayın</translation>
    </message>
    <message>
      <source>the scale is not right: see the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ölçek doğru değil: rapora bakın</translation>
    </message>
    <message>
      <source>%1; joined to %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; %2 mm ile birleşti</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti %1</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Uyarı: %1</translation>
    </message>
    <message numerus="yes">
      <source>%1 is computed: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 hesaplandı: %n parça.</numerusform>
      </translation>
    </message>
    <message>
      <source>You stopped it. What was computed so far is kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Siz durdurdunuz. Şimdiye kadar hesaplanan duruyor.</translation>
    </message>
    <message>
      <source>You took it out of the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sıradan siz çıkardınız.</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yeniden</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) wait.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Duraklatıldı; %n parti bekliyor.</numerusform>
      </translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: duraklatıldı</translation>
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
    <message>
      <source>decided; to be computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>karar verildi; hesaplanacak</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça</numerusform>
      </translation>
    </message>
    <message>
      <source>sure %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kesin %1</translation>
    </message>
    <message>
      <source>decided %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kararlı %1</translation>
    </message>
    <message>
      <source>ask %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kuşkulu %1</translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; ama tablada %n sayıldı</numerusform>
      </translation>
    </message>
    <message>
      <source>draft, to be computed again; %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>taslak, yeniden hesaplanacak; %1</translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 taslağını bekliyor.</translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the marks by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 çarpılmış: işaretleri %2 px kaçırıyor, ayarlandığı yerden %3 mm uzakta.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti için kameralar yeniden bulundu; düzeneği yeniden ayarlayın (C).</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BigButton</name>
    <message>
      <source>Key: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tuş: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BulkEdit</name>
    <message>
      <source>Field to change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değişecek alan</translation>
    </message>
    <message>
      <source>New value for all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hepsi için yeni değer</translation>
    </message>
    <message>
      <source>new value; empty deletes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yeni değer; boş siler</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parça</translation>
    </message>
    <message>
      <source>now</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>şimdi</translation>
    </message>
    <message>
      <source>then</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sonra</translation>
    </message>
    <message>
      <source>What would change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neler değişirdi</translation>
    </message>
    <message>
      <source>Change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değiştir</translation>
    </message>
    <message>
      <source>Give numbers to the drafts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taslaklara numara ver</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan</translation>
    </message>
    <message>
      <source>Value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değer</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça seçildi</numerusform>
      </translation>
    </message>
    <message>
      <source>Type a value to see what would change.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neyin değişeceğini görmek için bir değer yazın.</translation>
    </message>
    <message>
      <source>Preview of a change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değişikliğin önizlemesi</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>henüz numara yok</translation>
    </message>
    <message>
      <source>refused: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri çevrildi: %1</translation>
    </message>
    <message>
      <source>%1 change, %2 stay as they are, %3 are refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 değişiyor, %2 olduğu gibi kalıyor, %3 geri çevriliyor.</translation>
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parçayı değiştir</numerusform>
      </translation>
    </message>
    <message>
      <source>Progress of the changes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değişikliklerin ilerlemesi</translation>
    </message>
    <message>
      <source>Stop and take back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durdur ve geri al</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CandidateBar</name>
    <message>
      <source>Another back …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka arka yüz …</translation>
    </message>
    <message>
      <source>rim %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kenar %1</translation>
    </message>
    <message>
      <source>no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kenar yok</translation>
    </message>
    <message>
      <source>%1, with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, şimdi %2 ile</translation>
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
      <translation>Aday %1: %2, %3, %4</translation>
    </message>
    <message>
      <source>%1, nobody's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, boşta</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureFoot</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşluk</translation>
    </message>
    <message>
      <source>Typed, from a code reader, or from the bag's label laid under the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazarak, kod okuyucuyla ya da kameranın altına konan torba etiketinden</translation>
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
  </context>
  <context>
    <name>ostraka::ui::CaptureStation</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşluk</translation>
    </message>
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
    <message>
      <source>%1 The desktop holds a camera, by its program %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Masaüstü bir kamerayı %2 programıyla tutuyor.</translation>
    </message>
    <message>
      <source>Type the sherds' numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların numaralarını yaz</translation>
    </message>
    <message>
      <source>Say how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaç parça olduğunu söyle</translation>
    </message>
    <message>
      <source>This project photographs with no calibrated rig of its own.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje kendine ait ayarlanmış bir düzenekle çekim yapmıyor.</translation>
    </message>
    <message>
      <source>The rig is calibrated by %1; the calibration before is kept as %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek %1 ile ayarlandı; önceki ayar %2 olarak saklandı.</translation>
    </message>
    <message>
      <source>The import is stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alma durduruldu; geride bir şey kalmadı.</translation>
    </message>
    <message>
      <source>Import them all the same</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yine de içe aktar</translation>
    </message>
    <message>
      <source>%1 has these files already; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bu dosyaları zaten içeriyor; hiçbir şey içe aktarılmadı.</translation>
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
      <source>%1 may be two sherds, too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 belki birbirine çok yakın iki parça</translation>
    </message>
    <message>
      <source>%1 and %2 lie too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2 birbirine çok yakın</translation>
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
    <message>
      <source>Read from the label: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Etiketten okundu: %1</translation>
    </message>
    <message>
      <source>No room for more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka yer yok</translation>
    </message>
    <message numerus="yes">
      <source>Room for about %n more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Yaklaşık %n tane daha sığar</numerusform>
      </translation>
    </message>
    <message>
      <source>Looking for what holds the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamerayı neyin tuttuğu aranıyor</translation>
    </message>
    <message>
      <source>Making the desktop let go of the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masaüstüne kamera bıraktırılıyor</translation>
    </message>
    <message>
      <source>Make the desktop let go</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masaüstüne bıraktır</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: look for one that hides, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 parça saydınız, fotoğraflarda %2 görünüyor: gizlenen, başkasına değen ya da hiç konmamış birini arayın.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 saydınız</translation>
    </message>
    <message>
      <source>Marks %1 of %2, %3 are needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşaretler %1 / %2, %3 gerekli</translation>
    </message>
    <message>
      <source>Its sherds stand in the review (Ctrl+3): look while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaları incelemede (Ctrl+3): hâlâ buradayken bakın</translation>
    </message>
    <message>
      <source>The table stands still. What is safe is not photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabla duruyor. Güvende olanlar yeniden fotoğraflanmaz.</translation>
    </message>
    <message>
      <source>Go on at stop %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. duraktan devam et</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bu yüzün ortasında kesildi.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CatalogueStation</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parçada %1 değiştir</numerusform>
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
      <translation>Bunları dışa aktar</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Adınızın baş harfleri</translation>
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kim çalışıyor? Baş harfleriniz geçmişe yazılır:</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar</translation>
    </message>
    <message>
      <source>Search</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ara</translation>
    </message>
    <message>
      <source>Edit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenle</translation>
    </message>
    <message>
      <source>Give numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara ver</translation>
    </message>
    <message>
      <source>No sherds yet. They come by themselves when a batch is computed; start with Capture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz parça yok. Bir parti hesaplanınca kendiliğinden gelirler; Çekim ile başlayın.</translation>
    </message>
    <message>
      <source>No sherd fits. Take a condition away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir parça uymuyor. Bir koşulu kaldırın.</translation>
    </message>
    <message>
      <source>change %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 değiştir</translation>
    </message>
    <message>
      <source>move to another context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>başka kontekste taşı</translation>
    </message>
    <message>
      <source>changes by the import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alımıyla gelen değişiklikler</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alındı: %2</translation>
    </message>
    <message>
      <source>Import …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Al …</translation>
    </message>
    <message>
      <source>Numbers, contexts and descriptions from a table, or an export (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir tablodan numaralar, kontekstler ve tanımlar ya da bir dışa aktarma (%1)</translation>
    </message>
    <message>
      <source>About what is chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seçilenler hakkında</translation>
    </message>
    <message>
      <source>Details</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ayrıntılar</translation>
    </message>
    <message>
      <source>Drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim</translation>
    </message>
    <message>
      <source>Details or drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ayrıntılar ya da çizim</translation>
    </message>
    <message>
      <source>enter the rim's diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ağız çapını gir</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Al</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alımı %3 satırdan %2 satır sonra kesildi; bunlar tamdır. Kalanı için yeniden alın.</translation>
    </message>
    <message>
      <source>Do not tell this again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bunu bir daha bildirme</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara alacak parçaları seçin.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::DrawingPage</name>
    <message>
      <source>Scale of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimin ölçeği</translation>
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
      <translation>Yüzeyler nasıl çizilir</translation>
    </message>
    <message>
      <source>Light and shade of the form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Biçimin ışık ve gölgesi</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boya ve astarla</translation>
    </message>
    <message>
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız parçası mı</translation>
    </message>
    <message>
      <source>As the parts say, or as is likely</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bölümlerin dediği gibi ya da olası olduğu gibi</translation>
    </message>
    <message>
      <source>It is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız parçasıdır</translation>
    </message>
    <message>
      <source>It is no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız parçası değildir</translation>
    </message>
    <message>
      <source>Scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek</translation>
    </message>
    <message>
      <source>Surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yüzey</translation>
    </message>
    <message>
      <source>Rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız</translation>
    </message>
    <message>
      <source>Enter the diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çapı gir</translation>
    </message>
    <message>
      <source>Save …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydet …</translation>
    </message>
    <message>
      <source>Print …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazdır …</translation>
    </message>
    <message>
      <source>Print the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimi yazdır</translation>
    </message>
    <message>
      <source>Progress of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimin ilerlemesi</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durdur</translation>
    </message>
    <message>
      <source>The sheet before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önceki yaprak</translation>
    </message>
    <message>
      <source>The next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki yaprak</translation>
    </message>
    <message>
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim ne diyor</translation>
    </message>
    <message>
      <source>Drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimler</translation>
    </message>
    <message>
      <source>Stopped; nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durduruldu; hiçbir şey çizilmedi.</translation>
    </message>
    <message>
      <source>A sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir yaprak</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça çiziliyor …</numerusform>
      </translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça seçin.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: %2 to %3), %4 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız çapı %1 cm (% 95: %2 ile %3 arası), ağzın %4 kadarı (yüzde) korunmuş.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: above %2), %3 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız çapı %1 cm (% 95: %2 üstü), ağzın %3 kadarı (yüzde) korunmuş.</translation>
    </message>
    <message>
      <source>%1 drawn, %2 left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 çizildi, %2 dışarıda kaldı.</translation>
    </message>
    <message numerus="yes">
      <source>Draw plates of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parçanın levhalarını çiz</numerusform>
      </translation>
    </message>
    <message>
      <source>Sheet %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yaprak %1 / %2</translation>
    </message>
    <message>
      <source>plates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>levhalar</translation>
    </message>
    <message>
      <source>Save the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimi kaydet</translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, bütün yapraklar (*.pdf);;SVG, yaprak başına bir dosya (*.svg)</translation>
    </message>
    <message>
      <source>Saving a drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim kaydediliyor</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi: %1</translation>
    </message>
    <message>
      <source>Printing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazdırılıyor</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim yazıcıya gönderiliyor; % 100 boyutta yazdırın.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportModel</name>
    <message>
      <source>Size of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarmanın boyutu</translation>
    </message>
    <message>
      <source>Counting …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayılıyor …</translation>
    </message>
    <message>
      <source>No sherd fits; choose others.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir parça uymuyor; başkalarını seçin.</translation>
    </message>
    <message>
      <source>less than a minute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir dakikadan az</translation>
    </message>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>yaklaşık %n dakika</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça, %1 dosya, %2, %3</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n tanesinin modeli yok</numerusform>
      </translation>
    </message>
    <message>
      <source>There is a folder of this name already; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu adda bir klasör zaten var; başka bir ad seçin.</translation>
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
        <numerusform>%1, %n saniye kaldı</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça, %1, döküm denetlendi</numerusform>
      </translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarma</translation>
    </message>
    <message>
      <source>Stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durduruldu; geride bir şey kalmadı.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportStation</name>
    <message>
      <source>Exported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarıldı: %1</translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarma</translation>
    </message>
    <message>
      <source>What</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ne</translation>
    </message>
    <message>
      <source>All sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bütün parçalar</translation>
    </message>
    <message>
      <source>Those that fit this filter:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu süzgece uyanlar:</translation>
    </message>
    <message>
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarılanların süzgeci</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>context:0012</translation>
    </message>
    <message>
      <source>Forms</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Biçimler</translation>
    </message>
    <message>
      <source>Tables (CSV), for spreadsheets</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablolar (CSV), hesap çizelgeleri için</translation>
    </message>
    <message>
      <source>Records (JSON), to be read back whole</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kayıtlar (JSON), bütünüyle geri okunabilir</translation>
    </message>
    <message>
      <source>A picture of each model (PNG)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her modelin bir resmi (PNG)</translation>
    </message>
    <message>
      <source>Models as PLY, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY olarak modeller, mm</translation>
    </message>
    <message>
      <source>Models as GLB, for the web and for slides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>GLB olarak modeller, ağ ve sunumlar için</translation>
    </message>
    <message>
      <source>Models as OBJ, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>OBJ olarak modeller, mm</translation>
    </message>
    <message>
      <source>The photographs, unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflar, değişmeden</translation>
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nerede</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarma için yeni klasör</translation>
    </message>
    <message>
      <source>Choose …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seç …</translation>
    </message>
    <message>
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarmanın ilerlemesi</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durdur</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasörü aç</translation>
    </message>
    <message>
      <source>Where shall the folder be?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasör nerede olsun?</translation>
    </message>
    <message>
      <source>Those chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalogda seçilenler</translation>
    </message>
    <message numerus="yes">
      <source>The %n chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Katalogda seçilen %n parça</numerusform>
      </translation>
    </message>
    <message>
      <source>Drawings for print (SVG and PDF)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Baskı için çizimler (SVG ve PDF)</translation>
    </message>
    <message>
      <source>Scale of the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimlerin ölçeği</translation>
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
      <translation>A4'e sığdığı gibi</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablolar (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>Pictures, masks, poses for COLMAP and OpenMVS</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP ve OpenMVS için resimler, maskeler, duruşlar</translation>
    </message>
    <message>
      <source>Detail of the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modellerin ayrıntısı</translation>
    </message>
    <message>
      <source>Of PLY, GLB and OBJ: with fewer triangles the files are a fraction as large. How far they are off is measured and stated in each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY, GLB ve OBJ için: daha az üçgenle dosyalar çok daha küçüktür. Sapmaları ölçülür ve her birine yazılır.</translation>
    </message>
    <message>
      <source>as computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hesaplandığı gibi</translation>
    </message>
    <message>
      <source>lighter, to %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>daha hafif, %1 mm’ye kadar</translation>
    </message>
    <message>
      <source>Stop the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarmayı durdur</translation>
    </message>
    <message>
      <source>Export: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarma: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FilterLine</name>
    <message>
      <source>Filter of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalog süzgeci</translation>
    </message>
    <message>
      <source>rim T3 thickness&gt;6</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rim T3 thickness&gt;6</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sözcükler her yerde aranır; ware:grey, thickness&gt;6, -burnt, note:* da olur.</translation>
    </message>
    <message>
      <source>Take away the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 koşulunu kaldır</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FooterLine</name>
    <message>
      <source>What the computer does</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilgisayarın yaptığı iş</translation>
    </message>
    <message>
      <source>What was done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ne yapıldı</translation>
    </message>
    <message>
      <source>Progress of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hesabın ilerlemesi</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Nerede</translation>
    </message>
    <message>
      <source>Rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diskteki yer</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El kitabı</translation>
    </message>
    <message>
      <source>&amp;Contents</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İ&amp;çindekiler</translation>
    </message>
    <message>
      <source>All &amp;keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bütün &amp;tuşlar</translation>
    </message>
    <message>
      <source>&amp;About</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Hakkında</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşe dön (Esc)</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bütün tuşlar</translation>
    </message>
    <message>
      <source>Complete, measured 3D models of potsherds from photographs of both their sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çanak parçalarının iki yüzünün fotoğraflarından eksiksiz, ölçülmüş 3B modeller.</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apache Lisansı 2.0. Başkalarının yanında Qt (LGPL 3), VTK ve OpenCV kullanır; LICENSE dosyası ve README hepsini adlandırır.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: there is no network in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bilgisayardan hiçbir şey çıkmaz: içinde ağ yoktur.</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kılavuz yalnızca İngilizcedir.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportDialog</name>
    <message>
      <source>new</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yeni</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>değişmiş</translation>
    </message>
    <message>
      <source>refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri çevrildi</translation>
    </message>
    <message>
      <source>as it is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>olduğu gibi</translation>
    </message>
    <message>
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kataloğa al</translation>
    </message>
    <message>
      <source>A table (CSV) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir tablo (CSV) …</translation>
    </message>
    <message>
      <source>An export folder …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dışa aktarma klasörü …</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz olmayan alan, açma, kontekst ve torbaları oluştur</translation>
    </message>
    <message>
      <source>What each row would do</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her satır ne yapardı</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alımın ilerlemesi</translation>
    </message>
    <message>
      <source>Save what is refused …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri çevrilenleri kaydet …</translation>
    </message>
    <message>
      <source>Which table?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hangi tablo?</translation>
    </message>
    <message>
      <source>Tables (*.csv *.tsv *.txt);;All (*)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablolar (*.csv *.tsv *.txt);;Hepsi (*)</translation>
    </message>
    <message>
      <source>Which export?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hangi dışa aktarma?</translation>
    </message>
    <message>
      <source>Save what is refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri çevrilenleri kaydet</translation>
    </message>
    <message>
      <source>refused.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri-cevrilen.csv</translation>
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablolar (*.csv)</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi: %1</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>satır</translation>
    </message>
    <message>
      <source>what happens</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ne olur</translation>
    </message>
    <message>
      <source>why not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>neden olmaz</translation>
    </message>
    <message>
      <source>A table of sherds has a column number or uuid; one of contexts has site, context and, if you like, trench and bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça tablosunda number ya da uuid sütunu vardır; kontekst tablosunda site, context ve isterseniz trench ile bag.</translation>
    </message>
    <message>
      <source>Looking at it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bakılıyor …</translation>
    </message>
    <message>
      <source>Entered: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girildi: %1</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kapat</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durdur</translation>
    </message>
    <message>
      <source>Take nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbirini alma</translation>
    </message>
    <message numerus="yes">
      <source>Enter %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n satırı gir</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ‘%2’: %3</translation>
    </message>
    <message>
      <source>Preview of an import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alımın önizlemesi</translation>
    </message>
    <message>
      <source>%1 new, %2 changed, %3 as they are, %4 refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 yeni, %2 değişmiş, %3 olduğu gibi, %4 geri çevrildi.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Al</translation>
    </message>
    <message>
      <source>Stopped; nothing was entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durduruldu; hiçbir şey girilmedi.</translation>
    </message>
    <message numerus="yes">
      <source>Stopped: %n row(s) are not entered. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Durduruldu: %n satır girilmedi. Kalanı için tabloyu yeniden alın.</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::JoinMode</name>
    <message>
      <source>Which back belongs to the one of %1? Choose its card (arrows and Enter).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 arka yüzüne hangi arka yüz ait? Kartını seçin (oklar ve Enter).</translation>
    </message>
    <message>
      <source>Which front belongs to the one of %1? Choose its card (arrows and Enter); a click on a back's picture joins the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ön yüzüne hangi ön yüz ait? Kartını seçin (oklar ve Enter); bir arka yüz resmine tıklamak arka yüzleri birleştirir.</translation>
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
      <translation>%1 hesaplandı.</translation>
    </message>
    <message>
      <source>%1 stopped: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 durdu: %2</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>El kitabı</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bütün tuşlar</translation>
    </message>
    <message>
      <source>Other projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka projeler</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşe dön</translation>
    </message>
    <message>
      <source>This project is open in another window already: go on there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje başka bir pencerede zaten açık: orada sürdürün.</translation>
    </message>
    <message>
      <source>%1 - Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 - Ostraka</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzenek</translation>
    </message>
    <message>
      <source>Virtual rig %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzenek %1</translation>
    </message>
    <message>
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her yerde</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diskteki yer</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hesap durduruluyor; proje yeniden açılınca sürer. Pencere birazdan kapanır.</translation>
    </message>
    <message>
      <source>Queue: mending masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kuyruk: maskeleri düzeltme</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri al: %1</translation>
    </message>
    <message>
      <source>Do again: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yinele: %1</translation>
    </message>
    <message>
      <source>Copy of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kataloğun kopyası</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalog kopyalanamadı: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti</translation>
    </message>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan ve etiket yazdır</translation>
    </message>
    <message>
      <source>Print map and labels   Ctrl+P</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan ve etiket yazdır   Ctrl+P</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça %1</translation>
    </message>
    <message>
      <source>No batch is computed yet; its map appears here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz hesaplanmış parti yok; planı burada görünür.</translation>
    </message>
    <message>
      <source>Map of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 planı</translation>
    </message>
    <message>
      <source>%1-%2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-%2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti %1, %2</translation>
    </message>
    <message>
      <source>Map and labels are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan ve etiketler yazıcıya gönderiliyor.</translation>
    </message>
    <message>
      <source>Map</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan</translation>
    </message>
    <message>
      <source>Print bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Torba etiketlerini yazdır</translation>
    </message>
    <message>
      <source>Bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Torba etiketleri</translation>
    </message>
    <message>
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her torba için etiket yazdır; kodu partiye kontekstini verir (Ctrl+Shift+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz torba yok: çekimde birini yazın ya da bir kontekst tablosu alın.</translation>
    </message>
    <message numerus="yes">
      <source>%n label(s) are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n etiket yazıcıya gönderildi.</numerusform>
      </translation>
    </message>
    <message>
      <source>This batch was scanned, not photographed: there is no picture of its plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti fotoğraflanmadı, tarandı: tablasının resmi yok.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Bu partinin %n parçasının henüz numarası yok: etiketleri partiyi belirtir.</numerusform>
      </translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi: %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabla, ön ve arka</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça %1</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ön yüz</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka yüz</translation>
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
    <name>ostraka::ui::ModelPane</name>
    <message>
      <source>Picture of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçanın resmi</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kesit</translation>
    </message>
    <message>
      <source>Cut the model open; Shift and the wheel move the plane</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modeli kes; Shift ve tekerlek düzlemi kaydırır</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Üstten</translation>
    </message>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parçanın resmi</translation>
    </message>
    <message>
      <source>Model of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parçanın modeli</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site's code has two to eight capital letters and digits, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan kodu ARM1 gibi iki ile sekiz büyük harf ve rakamdan oluşur.</translation>
    </message>
    <message>
      <source>Choose a folder for the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Proje için bir klasör seçin.</translation>
    </message>
    <message>
      <source>There is a project in this folder already: open it, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde zaten bir proje var: onu açın ya da başka klasör seçin.</translation>
    </message>
    <message>
      <source>This folder holds other files: choose a new one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde başka dosyalar var: yeni bir klasör seçin.</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzenek</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::OutlinePlot</name>
    <message>
      <source>Outlines laid over each other, and their turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Üst üste konmuş dış çizgiler ve dönüş açıları</translation>
    </message>
    <message>
      <source>The turning angles differ by %1 rad.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dönüş açıları %1 rad farklı.</translation>
    </message>
    <message>
      <source>outlines on each other</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>üst üste dış çizgiler</translation>
    </message>
    <message>
      <source>turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dönüş açıları</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>differ by %1 rad</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fark %1 rad</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PairReviewModel</name>
    <message>
      <source>Small pictures of the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların küçük resimleri</translation>
    </message>
    <message>
      <source>%1, %2. %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2. %3</translation>
    </message>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz seçilmedi.</translation>
    </message>
    <message>
      <source>The rims do not meet here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarlar burada buluşmuyor.</translation>
    </message>
    <message>
      <source>Rims %1 apart, %2 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenar aralığı %1, buluşan pay %2.</translation>
    </message>
    <message>
      <source>Turned by hand; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elle döndürüldü; B kenarların oturtmasını sağlar.</translation>
    </message>
    <message>
      <source>Start point %1; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başlangıç noktası %1; B kenarların oturtmasını sağlar.</translation>
    </message>
    <message>
      <source>Choose a back first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce bir arka yüz seçin.</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce baş harflerinizi girin: her karar adını taşır.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 seçimi</translation>
    </message>
    <message>
      <source>Comparing two sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki yüz karşılaştırılıyor</translation>
    </message>
    <message>
      <source>pair %1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eş %1 – %2</translation>
    </message>
    <message>
      <source>setting aside %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kenara ayırma</translation>
    </message>
    <message>
      <source>shooting %1 again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 yeniden çekimi</translation>
    </message>
    <message>
      <source>One of the two has no back to be joined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İkisinden birinin birleştirilecek arka yüzü yok.</translation>
    </message>
    <message>
      <source>joining %1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2 birleştirme</translation>
    </message>
    <message>
      <source>cutting %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kesme</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>başlangıç noktası</translation>
    </message>
    <message>
      <source>settling by the rims</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kenarlarla oturtma</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>elle döndürme</translation>
    </message>
    <message>
      <source>Closed model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kapalı model</translation>
    </message>
    <message>
      <source>This pair has no closed model yet; it is made when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu eşin henüz kapalı modeli yok; parti hesaplanınca yapılır.</translation>
    </message>
    <message>
      <source>Picture of a pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir eşin resmi</translation>
    </message>
    <message>
      <source>More candidates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka adaylar</translation>
    </message>
    <message>
      <source>This back lies alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arka yüz tek başına.</translation>
    </message>
    <message>
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eş seçilmedi: önce bu arka yüzü bir ön yüze verin.</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tek başına bir arka yüzün kapalı modeli olmaz.</translation>
    </message>
    <message>
      <source>Stopped; the back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durduruldu; arka yüz olduğu yerde kaldı.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnızca denenen artık yok: çiftleri o zamandan beri kapatıldı.</translation>
    </message>
    <message>
      <source>Saved, with your name; but the rims of %1 and %2 hardly meet: %3 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Adınızla kaydedildi; ama %1 ile %2 kenarları pek buluşmuyor: buluşan pay %3.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki yüzün fotoğrafları</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön %1, arka %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf yok.</translation>
    </message>
    <message>
      <source>front %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ön %1</translation>
    </message>
    <message>
      <source>back %1, mirrored</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka %1, aynalı</translation>
    </message>
    <message>
      <source>back %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka %1</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Line over the %1, %2 steps from its middle, turned by %3 degrees</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 üzerinde çizgi, ortasından %2 adım uzakta, %3 derece döndürülmüş</translation>
    </message>
    <message>
      <source>Arrows move the line, with Shift they turn it, Up or Down takes the other side, Enter cuts. Or draw a line with the mouse.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oklar çizgiyi kaydırır, Shift ile döndürür, Yukarı veya Aşağı öbür yüzü alır, Enter keser. Ya da fareyle bir çizgi çizin.</translation>
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
    <message>
      <source>New: %1 (Esc takes it back)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni: %1 (Esc geri alır)</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden hesapla</translation>
    </message>
    <message>
      <source>Stop this batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partiyi durdur</translation>
    </message>
    <message>
      <source>Report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rapor</translation>
    </message>
    <message>
      <source>Review it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İncele</translation>
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Günlük</translation>
    </message>
    <message>
      <source>Batches</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Partiler</translation>
    </message>
    <message>
      <source>Log of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hesap günlüğü</translation>
    </message>
    <message>
      <source>No batch yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz parti yok</translation>
    </message>
    <message>
      <source>What you photograph or import is computed here, one batch after the other, while you go on working.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çektiğiniz ya da aldığınız her şey, siz çalışırken parti parti burada hesaplanır.</translation>
    </message>
    <message>
      <source>Photograph the first batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İlk partiyi çek</translation>
    </message>
    <message>
      <source>Queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sıra</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parti durdu ve size gerek var</numerusform>
      </translation>
    </message>
    <message>
      <source>Go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sürdür</translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 için henüz rapor yok.</translation>
    </message>
    <message>
      <source>Stop %1?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 durdurulsun mu?</translation>
    </message>
    <message>
      <source>It has been computed for more than an hour. Whole stages are kept, the present one is lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir saatten uzun süredir hesaplanıyor. Biten aşamalar kalır, şimdiki yitirilir.</translation>
    </message>
    <message>
      <source>Stop it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durdur</translation>
    </message>
    <message>
      <source>Let it go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sürsün</translation>
    </message>
    <message>
      <source>Mend the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maskeleri düzelt</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce taslaklar</translation>
    </message>
    <message>
      <source>Computes each new batch quickly and coarsely, to be looked at while the sherds still lie there; computed again it becomes final (D)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her yeni partiyi hızlı ve kaba hesaplar; parçalar hâlâ oradayken bakılabilsin diye. Yeniden hesaplanınca kesinleşir (D)</translation>
    </message>
    <message>
      <source>Calibrate the rig again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzeneği yeniden ayarla</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kameraya çarpılmış: bu partinin fotoğrafları kameraların şimdi nerede olduğunu söylüyor (C)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Rail</name>
    <message>
      <source>Stations</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İstasyonlar</translation>
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
      <translation>Eşler, en kuşkulular önce</translation>
    </message>
    <message>
      <source>This one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu</translation>
    </message>
    <message>
      <source>Next pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki eş</translation>
    </message>
    <message>
      <source>Previous pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önceki eş</translation>
    </message>
    <message>
      <source>Candidate %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aday %1</translation>
    </message>
    <message>
      <source>Start point before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önceki başlangıç noktası</translation>
    </message>
    <message>
      <source>Next start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki başlangıç noktası</translation>
    </message>
    <message>
      <source>One sample back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir örnek geri</translation>
    </message>
    <message>
      <source>One sample on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir örnek ileri</translation>
    </message>
    <message>
      <source>Mirror back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aynala</translation>
    </message>
    <message>
      <source>Apart</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ayır</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kesit</translation>
    </message>
    <message>
      <source>Measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölç</translation>
    </message>
    <message>
      <source>Rim gap</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenar aralığı</translation>
    </message>
    <message>
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Model</translation>
    </message>
    <message>
      <source>Settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oturt</translation>
    </message>
    <message>
      <source>Let the rims settle the position (B)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Konumu kenarlar bulsun (B)</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenara ayır</translation>
    </message>
    <message>
      <source>Shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden çek</translation>
    </message>
    <message>
      <source>Cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kes</translation>
    </message>
    <message>
      <source>Join</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birleştir</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>%1, key %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, tuş %2</translation>
    </message>
    <message>
      <source>This one   Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu   Enter</translation>
    </message>
    <message>
      <source>The rims are compared … Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarlar karşılaştırılıyor … Esc durdurur.</translation>
    </message>
    <message>
      <source>… and the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>… ve öteki uç</translation>
    </message>
    <message>
      <source>Pairs of the batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Partinin eşleri</translation>
    </message>
    <message>
      <source>Join two pieces of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parçanın iki kırığını birleştirin: sonra öteki kartı seçin (J ön yüzler, Shift+J arka yüzler)</translation>
    </message>
    <message>
      <source>Join backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzleri birleştir</translation>
    </message>
    <message>
      <source>Settle, join and cut nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir şeyi oturtma, birleştirme veya kesme</translation>
    </message>
    <message>
      <source>Cut a piece that is two sherds in truth, along a line over its picture (K)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aslında iki parça olan bir parçayı resminin üzerindeki çizgi boyunca kes (K)</translation>
    </message>
    <message>
      <source>The rims settle: %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarlar oturuyor: %1. Esc durdurur.</translation>
    </message>
    <message>
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçanın üzerinde uzunluğun bir ucuna, sonra öbür ucuna tıklayın. D bitirir.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti</translation>
    </message>
    <message>
      <source>Your &amp;initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Baş harfleriniz</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Adınızın baş harfleri</translation>
    </message>
    <message>
      <source>Compute what changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değişenleri hesapla</translation>
    </message>
    <message>
      <source>Makes the models of the pairs that were decided anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden karar verilen eşlerin modellerini yapar</translation>
    </message>
    <message>
      <source>No batch is computed yet. Shoot or import one; its pairs appear here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz hesaplanmış parti yok. Bir tane çekin ya da alın; eşleri burada görünür.</translation>
    </message>
    <message>
      <source>Opening %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 açılıyor</translation>
    </message>
    <message>
      <source>%1 waits to be computed; only what changed is done again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 hesaplanmayı bekliyor; yalnız değişenler yeniden yapılır.</translation>
    </message>
    <message>
      <source>Saved. The pairs of the new pieces come when it is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. Yeni kırıkların eşleri hesaplanınca gelir.</translation>
    </message>
    <message>
      <source>Taken back. Both are kept in the history.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri alındı. İkisi de geçmişte durur.</translation>
    </message>
    <message>
      <source>Saved, with your name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Adınızla kaydedildi.</translation>
    </message>
    <message>
      <source>No pair needs your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir eşe bakmanız gerekmiyor</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) need your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n eşe bakmanız gerekiyor</numerusform>
      </translation>
    </message>
    <message>
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İnceleme</translation>
    </message>
    <message>
      <source>Where its report is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Raporuna git</translation>
    </message>
    <message>
      <source>None of the measures of %1 is sure. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 partisinin hiçbir ölçüsü kesin değil. %2</translation>
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
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşluk</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SettingsPage</name>
    <message>
      <source>As the desktop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masaüstü gibi</translation>
    </message>
    <message>
      <source>Light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık</translation>
    </message>
    <message>
      <source>Dark, for the tent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Koyu, çadır için</translation>
    </message>
    <message>
      <source>Sunlight: black on white, thick lines</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Güneş ışığı: beyaz üstüne siyah, kalın çizgiler</translation>
    </message>
    <message>
      <source>all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hepsi</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ayarlar</translation>
    </message>
    <message>
      <source>&amp;Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Baş harfleriniz</translation>
    </message>
    <message>
      <source>They stand in the history of each decision.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her kararın geçmişinde yer alırlar.</translation>
    </message>
    <message>
      <source>&amp;Theme</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Tema</translation>
    </message>
    <message>
      <source>Te&amp;xt size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Yazı boyutu</translation>
    </message>
    <message>
      <source>Text size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazı boyutu</translation>
    </message>
    <message>
      <source>&amp;Language</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Dil</translation>
    </message>
    <message>
      <source>Holds from the next start.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki açılışta geçerli olur.</translation>
    </message>
    <message>
      <source>&amp;Processors for computing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hesap için &amp;işlemciler</translation>
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
    <name>ostraka::ui::SheetView</name>
    <message>
      <source>The drawing on its sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yaprağındaki çizim</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdDetails</name>
    <message>
      <source>missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eksik</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>değişmiş</translation>
    </message>
    <message>
      <source>present</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>var</translation>
    </message>
    <message>
      <source>Details of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçanın ayrıntıları</translation>
    </message>
    <message>
      <source>Number of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçanın numarası</translation>
    </message>
    <message>
      <source>Picture of the sherd in the way</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Engel olan parçanın resmi</translation>
    </message>
    <message>
      <source>measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ölçü</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>değer</translation>
    </message>
    <message>
      <source>from</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kaynak</translation>
    </message>
    <message>
      <source>Measurements</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçüler</translation>
    </message>
    <message>
      <source>when</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ne zaman</translation>
    </message>
    <message>
      <source>who</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kim</translation>
    </message>
    <message>
      <source>what</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ne</translation>
    </message>
    <message>
      <source>History</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geçmiş</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dosya</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tür</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>durum</translation>
    </message>
    <message>
      <source>Files</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosyalar</translation>
    </message>
    <message>
      <source>Measured</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçülen</translation>
    </message>
    <message>
      <source>Context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kontekst</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kontekst</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>henüz numara yok</translation>
    </message>
    <message>
      <source>Give the number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarasını ver</translation>
    </message>
    <message>
      <source>added</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eklendi</translation>
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
      <translation>hiçbir şey</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>program</translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça seçin.</translation>
    </message>
    <message>
      <source>%1 It is %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 O, %2.</translation>
    </message>
    <message>
      <source>%1; in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; şüpheli</translation>
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
        <numerusform>%n parçaya numara ver</numerusform>
      </translation>
    </message>
    <message>
      <source>Other changes are still being saved; wait for them, or stop them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka değişiklikler hâlâ kaydediliyor; bekleyin ya da durdurun.</translation>
    </message>
    <message>
      <source>The sherds that are chosen have their numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seçilen parçaların numaraları var.</translation>
    </message>
    <message>
      <source>Numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numaralar</translation>
    </message>
    <message>
      <source>Stopped; nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durduruldu; hiçbir şey değişmedi.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdTableModel</name>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parçanın resmi</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>not recorded</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kaydedilmedi</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>henüz numara yok</translation>
    </message>
    <message>
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, şüpheli</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 partisinin ölçeği şüpheli; raporu nedenini ve ne yapılacağını söyler.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdView</name>
    <message>
      <source>Sherd in three dimensions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Üç boyutlu parça</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the sherd cannot be shown in three dimensions. Everything else works; photographs and outlines are beside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu ekranda OpenGL 3.2 yok, bu yüzden parça üç boyutlu gösterilemiyor. Geri kalan her şey çalışır; fotoğraflar ve dış çizgiler yanda.</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz proje yok. Bir tane yapın ya da her şeyi sanal düzenekle deneyin: sizin için bir kap kırar ve parçalarını fotoğraflar.</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seç…</translation>
    </message>
    <message>
      <source>Choose the folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasörü seç</translation>
    </message>
    <message>
      <source>Make the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projeyi oluştur</translation>
    </message>
    <message>
      <source>&amp;Name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A&amp;d</translation>
    </message>
    <message>
      <source>&amp;Site code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan &amp;kodu</translation>
    </message>
    <message>
      <source>&amp;Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>K&amp;lasör</translation>
    </message>
    <message>
      <source>Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasör</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>N&amp;umaralama</translation>
    </message>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça şöyle olur:</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni projenin klasörü</translation>
    </message>
    <message>
      <source>Folder of a project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir projenin klasörü</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projeler</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2 yerinde yok: bulun …</translation>
    </message>
    <message>
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 şimdi nerede?</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Resim</translation>
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
      <translation>ön: mavi kenar</translation>
    </message>
    <message>
      <source>back: red rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka: kırmızı kenar</translation>
    </message>
    <message>
      <source>%1 mm and more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm ve üstü</translation>
    </message>
    <message>
      <source>0 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>0 mm</translation>
    </message>
    <message>
      <source>gap between the sides along the rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yüzler arasında kenar boyunca aralık</translation>
    </message>
    <message>
      <source>grey: not met by the other side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>gri: öteki yüz buraya değmiyor</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, a whole number, or scan its label</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, tam numara veya etiketini okut</translation>
    </message>
    <message>
      <source>&amp;Number of sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Parça %1 numarası</translation>
    </message>
    <message>
      <source>If they have numbers already: each follows its sherd through the flip. Key N.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Zaten numaraları varsa: her biri çevirmede parçasını izler. N tuşu.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskModel</name>
    <message>
      <source>%1, camera %2, stop %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, kamera %2, durak %3</translation>
    </message>
    <message>
      <source>Mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maske</translation>
    </message>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 maskeleri</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka yüz</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ön yüz</translation>
    </message>
    <message>
      <source>paint on a mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maske üzerine boyama</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 maskeleri</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) mended; what follows from them is computed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fotoğraf düzeltildi; ondan çıkanlar yeniden hesaplanır.</numerusform>
      </translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri</translation>
    </message>
    <message>
      <source>Brush's &amp;width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fırça &amp;genişliği</translation>
    </message>
    <message>
      <source>Compute with these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bunlarla hesapla</translation>
    </message>
    <message>
      <source>Larger</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Daha büyük</translation>
    </message>
    <message>
      <source>Smaller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Daha küçük</translation>
    </message>
    <message>
      <source>Next photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki fotoğraf</translation>
    </message>
    <message>
      <source>Photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf</translation>
    </message>
    <message>
      <source>Photograph before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önceki fotoğraf</translation>
    </message>
    <message>
      <source>Plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabla</translation>
    </message>
    <message>
      <source>Sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça</translation>
    </message>
    <message>
      <source>The photograph is being read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf okunuyor.</translation>
    </message>
    <message>
      <source>What is veiled in blue is taken for sherd. Paint what is missing, or as plate what is too much; the program's own masks stay.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Mavi örtülü olan yer parça sayılır. Eksik olanı boyayın ya da fazla olanı tabla olarak boyayın; programın kendi maskeleri kalır.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskView</name>
    <message>
      <source>Photograph with its mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maskesiyle fotoğraf</translation>
    </message>
    <message>
      <source>The arrows move the brush, Space paints, plus and minus enlarge and reduce.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oklar fırçayı taşır, boşluk boyar, artı ve eksi büyütür ve küçültür.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberingEdit</name>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça şöyle olur:</translation>
    </message>
    <message>
      <source>First number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bilgisayarın ilk numarası</translation>
    </message>
    <message>
      <source>Last number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bilgisayarın son numarası</translation>
    </message>
    <message>
      <source>Left out so far</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Şimdiye dek atlananlar</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>N&amp;umaralama</translation>
    </message>
    <message>
      <source>Num&amp;bers of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bilgisayarın &amp;numaraları</translation>
    </message>
    <message>
      <source>Number so from &amp;now on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Artık böyle numarala</translation>
    </message>
    <message>
      <source>Numbers of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık projenin numaraları</translation>
    </message>
    <message>
      <source>What has a number keeps it; the next sherds follow. No number is ever given twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numarası olan onu korur; sonraki parçalar buna uyar. Hiçbir numara iki kez verilmez.</translation>
    </message>
    <message numerus="yes">
      <source>and in %n more context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>ve %n bağlamda daha</numerusform>
      </translation>
    </message>
    <message>
      <source>no number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hiçbir numara</translation>
    </message>
    <message>
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ila</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, ve bir kez {n}; {n:04} en az dört hanelidir</translation>
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
      <translation>Atlanan numaralar</translation>
    </message>
    <message>
      <source>Sherds of %1 get no number so: it lacks a part that the numbering names.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 parçaları böyle numara almaz: numaralamanın andığı bir bölüm onda yok.</translation>
    </message>
    <message>
      <source>The first number of a block is not above its last.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir bloğun ilk numarası sonuncusundan büyük olamaz.</translation>
    </message>
    <message>
      <source>change the numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>numaralamayı değiştirme</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::VocabularyEdit</name>
    <message>
      <source>&amp;Save the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sözcükleri &amp;kaydet</translation>
    </message>
    <message>
      <source>&amp;Words for</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Sözcükler:</translation>
    </message>
    <message>
      <source>A word that sherds use already stays; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların kullandığı sözcük kalır; önce onları değiştirin.</translation>
    </message>
    <message>
      <source>&amp;One a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Her satıra bir</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi.</translation>
    </message>
    <message>
      <source>Words of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık projenin sözcükleri</translation>
    </message>
    <message>
      <source>Words, one a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sözcükler, her satıra bir</translation>
    </message>
    <message>
      <source>change the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sözcükleri değiştirme</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>korunma durumu</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bezeme</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>pişirim</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yapım</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bölüm</translation>
    </message>
    <message>
      <source>surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yüzey</translation>
    </message>
    <message>
      <source>These words are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sözcükler henüz kaydedilmedi.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CountEdit</name>
    <message>
      <source>&amp;Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Parça</translation>
    </message>
    <message>
      <source>not counted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sayılmadı</translation>
    </message>
    <message>
      <source>How many sherds you counted onto the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablaya kaç parça saydığınız</translation>
    </message>
    <message>
      <source>Count them if you like: you are asked when the photographs show another number (S)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İsterseniz sayın: fotoğraflar başka bir sayı gösterirse size sorulur (S)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigRenewal</name>
    <message>
      <source>Calibration by %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ile ayarlama</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Almanın ilerlemesi</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Almayı durdur</translation>
    </message>
  </context>
  <context>
    <name>ImportBatch</name>
    <message>
      <source>There are no scans (*.ply) in its folder %1/. Choose a folder that holds front/ and back/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1/ klasöründe tarama (*.ply) yok. front/ ve back/ içeren bir klasör seçin.</translation>
    </message>
    <message>
      <source>This folder cannot be read to its end: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör sonuna kadar okunamıyor: %1.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdNumbers</name>
    <message>
      <source>%1 is no sherd's number: it has a digit, no space and at most %2 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bir parça numarası değil: numarada bir rakam bulunur, boşluk bulunmaz ve en çok %2 karakterdir.</translation>
    </message>
    <message>
      <source>Sherd %1 of this plate has the number %2: take it from that one first, or type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu tabladaki %1 numaralı sıradaki parçanın numarası %2: önce ondan alın ya da başka bir numara yazın.</translation>
    </message>
    <message>
      <source>A sherd of %1 has the number %2 already; type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 partisinden bir parçanın numarası zaten %2; başka bir numara yazın.</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Doubts</name>
    <message>
      <source>the file is cut off or no picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dosya yarım kalmış ya da resim değil</translation>
    </message>
    <message>
      <source>the markers show another angle than this stop's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>işaretler bu durağın açısından başka bir açı gösteriyor</translation>
    </message>
    <message>
      <source>the picture has another size than the camera's others</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resmin boyutu bu kameranın ötekilerinden farklı</translation>
    </message>
    <message>
      <source>too few markers are seen to tell the stop: is something before them, is it blurred?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>durağı bulmak için çok az işaret görünüyor: önlerinde bir şey mi var, bulanık mı?</translation>
    </message>
    <message>
      <source>the camera handed over an earlier photograph once more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kamera önceki bir fotoğrafı yeniden verdi</translation>
    </message>
    <message>
      <source>too few markers of the plate are seen: is something before them?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tablanın çok az işareti görünüyor: önlerinde bir şey mi var?</translation>
    </message>
    <message>
      <source>it is blurred: did the table still move, did the focus change?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bulanık: tabla hâlâ hareket mi ediyordu, odak mı değişti?</translation>
    </message>
    <message>
      <source>the sherds are too dark: give more light or expose longer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parçalar çok karanlık: daha çok ışık verin ya da daha uzun pozlayın</translation>
    </message>
    <message>
      <source>the sherds are burnt out: expose shorter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parçalar patlamış: daha kısa pozlayın</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resmin kenarı bir parçayı kesiyor: onu ya da kamerayı oynatın</translation>
    </message>
    <message>
      <source>the camera's settings are others than they were: set them back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kameranın ayarları öncekilerden farklı: geri alın</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>%1: set it back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: geri alın</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate's markers are seen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar sayılamadı: tablanın çok az işareti görünüyor.</translation>
    </message>
    <message>
      <source>No sherd is seen on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablada hiç parça görünmüyor.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate's middle: move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar tablanın ortasından %1 uzakta birbirine değiyor ya da neredeyse değiyor: ayırın ve yeniden çekin.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate's middle was counted as one but may be two sherds that touch: look there; if so, move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın ortasından %1 uzakta duran bir parça sayıldı, ama birbirine değen iki parça olabilir: oraya bakın; öyleyse ayırın ve yeniden çekin.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and photograph them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz ön yüze benziyor: parçaları çevirin ve yeniden fotoğraflayın.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün parçaları sayılamadı: tablayı boşaltmadan önce resimleri kendiniz karşılaştırın.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün parçaları sayılamadı: tablayı boşaltmadan önce resimleri kendiniz karşılaştırın.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: look for the missing one before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önde %1 parça göründü, arkada %2: tablayı boşaltmadan önce eksik olanı arayın.</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: was one added, or did one break?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önde %1 parça göründü, arkada %2: biri mi eklendi, yoksa biri mi kırıldı?</translation>
    </message>
  </context>
  <context>
    <name>ostraka::Error</name>
    <message>
      <source>Stopped on request.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İstek üzerine durduruldu.</translation>
    </message>
    <message>
      <source>The camera is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera takılı değil.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera takılı değil ya da açık değil.</translation>
    </message>
    <message>
      <source>The camera does not answer; is it asleep? Switch its automatic power-off off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera yanıt vermiyor; uykuda mı? Otomatik kapanmasını kapatın.</translation>
    </message>
    <message>
      <source>The camera stays busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera meşgul kalıyor; kapatıp açın.</translation>
    </message>
    <message>
      <source>The line to the camera is broken; look at its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamerayla bağlantı koptu; kablosuna bakın.</translation>
    </message>
    <message>
      <source>The camera is held by another program, often the desktop's file manager; 'ostraka devices' names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamerayı başka bir program tutuyor, çoğu zaman dosya yöneticisi; 'ostraka devices' adını söyler.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; may this user use it? Look at 'ostraka devices'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera açılamıyor; bu kullanıcı onu kullanabilir mi? 'ostraka devices' komutuna bakın.</translation>
    </message>
    <message>
      <source>No photograph came from the camera; is it focused and set to manual?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kameradan fotoğraf gelmedi; odaklı ve elle kipinde mi?</translation>
    </message>
    <message>
      <source>The camera does not stop to deliver photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera fotoğraf göndermeyi bırakmıyor.</translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kamera canlı görüntü göstermiyor.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; is it blocked?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa açısına ulaşmıyor; takılı mı?</translation>
    </message>
    <message>
      <source>The turntable was paused at its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa kendi düğmesinden duraklatıldı.</translation>
    </message>
    <message>
      <source>The table's position is not known: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın konumu bilinmiyor: sıfırlayın ya da hizalayın.</translation>
    </message>
    <message>
      <source>The turntable does not answer in the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa ağda yanıt vermiyor.</translation>
    </message>
    <message>
      <source>The controller restarted; the table's position is not known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Denetleyici yeniden başladı; masanın konumu bilinmiyor.</translation>
    </message>
    <message>
      <source>A reply of the turntable was lost and it cannot tell where it stands: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın bir yanıtı kayboldu ve nerede durduğunu söyleyemiyor: sıfırlayın ya da hizalayın.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masa bir GRBL denetleyicisi gibi yanıt vermiyor: açık mı, bu türden mi?</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masa bir ComXim gibi yanıt vermiyor: açık mı, bu türden mi?</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB bu bilgisayarda çalışmıyor.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and shoot on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Disk dolu; yer açın ve çekime devam edin.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and start the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Disk dolu; yer açın ve aynı işi yeniden başlatın.</translation>
    </message>
    <message>
      <source>The disk is full; make room, then try again. Nothing was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Disk dolu; yer açın, sonra yeniden deneyin. Hiçbir şey kaybolmadı.</translation>
    </message>
    <message>
      <source>Another program keeps the catalogue busy; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir program kataloğu meşgul ediyor; onu kapatın, sonra yeniden deneyin.</translation>
    </message>
    <message>
      <source>The image is cut off before its end; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Resim sonundan önce kesilmiş; kameradan yeniden kopyalayın.</translation>
    </message>
  </context>
</TS>
