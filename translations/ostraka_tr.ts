<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>ostraka::ui::ProjectSession</name>
    <message>
      <source>This project is read-only: you can look at everything, but change nothing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje yalnızca okunabilir: her şeye bakın; değişiklikler kabul edilmez.</translation>
    </message>
    <message>
      <source>The project's folder is not there any more: it was moved, renamed, or its disk was taken out. Open the project again where it is now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projenin klasörü artık yerinde değil: taşındı, adı değişti ya da diski çıkarıldı. Projeyi şimdi bulunduğu yerde açın.</translation>
    </message>
</context>
<context>
    <name>SideLabels</name>
    <message>
      <source>A label among the fronts names %1, one among the backs %2: check that both sides show the same sherds, and type the bag that they are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzlerdeki bir etiket %1, arka yüzlerdeki bir etiket %2 diyor: iki yüzün aynı parçaları gösterip göstermediğini denetleyin ve torbalarını yazın.</translation>
    </message>
    <message>
      <source>Labels of several bags are in the photographs: %1. Type the one that these sherds are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflarda birden çok torbanın etiketi var: %1. Bu parçaların torbasını yazın.</translation>
    </message>
    <message>
      <source>The label in the photographs names %1: check the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflardaki etiket %1 diyor: torbayı denetleyin.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportAsk</name>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce buna bakın</translation>
    </message>
    <message>
      <source>The label in the photographs names %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflardaki etiket %1 diyor.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktar</translation>
    </message>
    <message>
      <source>Cancel import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarma</translation>
    </message>
    <message>
      <source>From %1. The bag can also be given later, in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaynak: %1. Torba daha sonra katalogda da verilebilir.</translation>
    </message>
    <message>
        <source>Enter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Enter</translation>
    </message>
    <message>
      <source>To import, confirm or move the division between front and back, or choose one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarmak için ön ve arka yüz arasındaki bölmeyi onaylayın ya da kaydırın, ya da yalnızca bir yüzü seçin.</translation>
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
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kalınlık, mm</translation>
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
      <source>minimum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en az kalınlık, mm</translation>
    </message>
    <message>
      <source>maximum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en çok kalınlık, mm</translation>
    </message>
    <message>
      <source>unseen surface, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>görülmeyen, %</translation>
    </message>
    <message>
      <source>place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yer</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>model</translation>
    </message>
    <message>
      <source>labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>adlar</translation>
    </message>
    <message>
      <source>person</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kişi</translation>
    </message>
    <message>
      <source>name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ad</translation>
    </message>
    <message>
      <source>initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>baş harfler</translation>
    </message>
    <message>
      <source>code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kod</translation>
    </message>
    <message>
      <source>location</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>konum</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tür</translation>
    </message>
    <message>
      <source>excavated on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kazı tarihi</translation>
    </message>
    <message>
      <source>closed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kapalı</translation>
    </message>
    <message>
      <source>collected on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>toplama tarihi</translation>
    </message>
    <message>
      <source>storage</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>depo</translation>
    </message>
    <message>
      <source>operator</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>çalışan</translation>
    </message>
    <message>
      <source>counted sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sayılan parçalar</translation>
    </message>
    <message>
      <source>results</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sonuçlar</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>program</translation>
    </message>
    <message>
      <source>project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>proje</translation>
    </message>
    <message>
      <source>title</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>başlık</translation>
    </message>
    <message>
      <source>institution</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kurum</translation>
    </message>
    <message>
      <source>licence</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>lisans</translation>
    </message>
    <message>
      <source>rights holder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hak sahibi</translation>
    </message>
    <message>
      <source>numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>numaralandırma</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parça</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fotoğraf</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tarama</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dosya</translation>
    </message>
    <message>
      <source>term</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>terim</translation>
    </message>
    <message>
      <source>content</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>içerik</translation>
    </message>
    <message>
      <source>mask strokes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maskelerdeki fırça izleri</translation>
    </message>
    <message>
      <source>entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kayıt</translation>
    </message>
    <message>
      <source>excavated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kazı</translation>
    </message>
    <message>
      <source>measured by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>elle ölçülen</translation>
    </message>
    <message>
      <source>centre of mass x, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kütle merkezi x, mm</translation>
    </message>
    <message>
      <source>centre of mass y, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kütle merkezi y, mm</translation>
    </message>
    <message>
      <source>centre of mass z, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kütle merkezi z, mm</translation>
    </message>
    <message>
      <source>model file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>model dosyası</translation>
    </message>
    <message>
      <source>picture file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resim dosyası</translation>
    </message>
    <message>
      <source>drawing file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>çizim dosyası</translation>
    </message>
    <message>
      <source>sherds written on the bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>torbada yazan parça sayısı</translation>
    </message>
    <message>
      <source>column of the CSV</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>CSV sütunu</translation>
    </message>
    <message>
      <source>column</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sütun</translation>
    </message>
    <message>
      <source>unit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>birim</translation>
    </message>
    <message>
      <source>meaning</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>anlam</translation>
    </message>
    <message>
      <source>reason for voiding</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geçersiz sayma nedeni</translation>
    </message>
    <message>
      <source>identical with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>aynısı</translation>
    </message>
</context>
<context>
    <name>Job</name>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu programın bir hatasıdır; lütfen günlükle (%1) birlikte bildirin.</translation>
    </message>
    <message>
      <source>Not enough memory. Close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bellek yetmiyor; başka programları kapatıp yeniden deneyin.</translation>
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
    <message numerus="yes">
        <source>%n sherd(s) counted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n parça sayıldı</numerusform>
        </translation>
    </message>
    <message>
      <source>invented by the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sanal düzeneğin uydurduğu</translation>
    </message>
    <message>
      <source>context %1, although %2 exists</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kontekst %1, oysa %2 var</translation>
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
      <translation>hazır (bugün kalibre edildi)</translation>
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
      <source>Finding the cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kameralar bulunuyor</translation>
    </message>
    <message>
      <source>Measuring the shape, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Biçim ölçülüyor, ön</translation>
    </message>
    <message>
      <source>Measuring the shape, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Biçim ölçülüyor, arka</translation>
    </message>
    <message>
      <source>Cutting the sherds out, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar tek tek ayrılıyor, ön</translation>
    </message>
    <message>
      <source>Cutting the sherds out, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar tek tek ayrılıyor, arka</translation>
    </message>
    <message>
      <source>Matching fronts and backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön ve arka yüzler eşleştiriliyor</translation>
    </message>
    <message>
      <source>Closing the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modeller kapatılıyor</translation>
    </message>
    <message>
      <source>Writing the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Rapor yazılıyor</translation>
    </message>
    <message>
      <source>Entering the sherds into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar kataloğa giriliyor</translation>
    </message>
    <message>
      <source>Starting</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başlıyor</translation>
    </message>
    <message>
      <source>Looking for other partners in doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kuşkulu çiftler için başka eşler aranıyor</translation>
    </message>
    <message>
      <source>Finding the sherds, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar bulunuyor, ön</translation>
    </message>
    <message>
      <source>Finding the sherds, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar bulunuyor, arka</translation>
    </message>
</context>
<context>
    <name>Time</name>
    <message>
      <source>less than a minute left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir dakikadan az kaldı</translation>
    </message>
    <message>
      <source>about %1 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yaklaşık %1 dk kaldı</translation>
    </message>
    <message>
      <source>about %1 h left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yaklaşık %1 sa kaldı</translation>
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
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2 ikisi de %3 ile uyuyor.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzü başka bir ön yüze verildi: şimdi doğrusu %1 mi?</translation>
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
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>torba %1</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arka yüz kenara ayrıldı. Yine de kullanmak için bir ön yüzün üzerine sürükleyin.</translation>
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
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elle döndürüldü.</translation>
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
      <source>Sure by what was decided for others: %1; by itself %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diğerleri için verilen kararlardan emin: %1; tek başına %2.</translation>
    </message>
    <message>
      <source>%1, aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, kenarda</translation>
    </message>
    <message>
      <source>%1, shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, yeniden çekin</translation>
    </message>
    <message>
      <source>%1, void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, geçersiz</translation>
    </message>
    <message>
      <source>%1 in %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 içinde %1</translation>
    </message>
    <message>
      <source>now %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>şimdi %1</translation>
    </message>
    <message>
        <source>front %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ön yüz %1</translation>
    </message>
    <message>
        <source>back %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>arka yüz %1</translation>
    </message>
    <message>
        <source>Merged with %1 by %2. It is one fragment once the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%2 tarafından %1 ile birleştirildi. Parti yeniden işlenince tek kırık parça olur.</translation>
    </message>
    <message>
        <source>Split by %1. Its fragments appear when the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 tarafından bölündü. Kırık parçaları parti yeniden işlenince görünür.</translation>
    </message>
    <message>
        <source>Merged</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Birleştirildi</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bölündü</translation>
    </message>
    <message>
        <source>No front</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ön yüz yok</translation>
    </message>
    <message>
        <source>This back is to be reshot.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu arka yüz yeniden çekilecek.</translation>
    </message>
    <message>
        <source>No front holds this back. Drag it onto its front, merge it with another, or set it aside.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu arka yüz hiçbir ön yüze ait değil. Ön yüzüne sürükleyin, başka biriyle birleştirin ya da bir kenara koyun.</translation>
    </message>
    <message>
        <source>%1 and %2 both fit %3: their fractures differ by only %4.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 ve %2, %3 ile uyuyor: kırıkları yalnızca %4 farklı.</translation>
    </message>
    <message>
        <source>%1 would fit %2 almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, %2 ile neredeyse aynı ölçüde uyardı.</translation>
    </message>
    <message>
        <source>%1 fits barely better than an unrelated back.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 ilgisiz bir arka yüzden ancak biraz daha iyi uyuyor.</translation>
    </message>
    <message>
        <source>Ambiguous: a second position fits almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Belirsiz: ikinci bir konum neredeyse aynı ölçüde uyuyor.</translation>
    </message>
    <message>
        <source>%1 confident</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Güven: %1</translation>
    </message>
    <message>
        <source>Check</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Denetle</translation>
    </message>
    <message>
        <source>No back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Arka yüz yok</translation>
    </message>
    <message>
        <source>Sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kesin</translation>
    </message>
    <message>
        <source>Decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Karar verildi</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kenara ayrıldı</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yeniden çek</translation>
    </message>
    <message>
        <source>To be reshot, decided by %1 on %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yeniden çekilecek, karar: %1, %2.</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ölçülen değerle değiştir</translation>
    </message>
    <message>
        <source>Delete computed value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Hesaplanan değeri sil</translation>
    </message>
    <message>
        <source>Save this value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu değeri kaydet</translation>
    </message>
    <message>
        <source>%1 (computed %2)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 (hesaplanan %2)</translation>
    </message>
    <message>
        <source>The two scans share only %1 of the fracture.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İki taramanın ortak olan yanı kırığın yalnız %1 kadarı.</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>henüz numara yok</translation>
    </message>
    <message>
      <source>Another partner fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir eş neredeyse aynı ölçüde uyuyor.</translation>
    </message>
    <message>
      <source>no probability</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>olasılık yok</translation>
    </message>
    <message>
      <source>The nearest outline; no probability is known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>En yakın dış çizgi; bir olasılık bilinmiyor.</translation>
    </message>
    <message>
      <source>Another front takes the same back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir ön yüz aynı arka yüzü alıyor.</translation>
    </message>
    <message>
      <source>The two scans share almost no fracture; only their outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki taramanın neredeyse hiç ortak kırığı yok; onları yalnız dış çizgiler bağlıyor.</translation>
    </message>
    <message>
      <source>The fractures do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıklar uymuyor: arada %1.</translation>
    </message>
    <message>
      <source>The fracture barely fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırık konumu pek belirlemiyor: belirsizlik %1.</translation>
    </message>
    <message>
      <source>A position %1 along the contour fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dış çizgi boyunca %1 ötedeki bir konum neredeyse aynı ölçüde uyuyor.</translation>
    </message>
    <message>
      <source>The fractures cannot be compared; only the outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıklar karşılaştırılamıyor; bu yüzleri yalnız dış çizgiler bağlıyor.</translation>
    </message>
    <message>
      <source>refined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>oturtuldu</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elle döndürüldü: kırıkların değen payı %1.</translation>
    </message>
    <message>
      <source>Trying another start point: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir başlangıç noktası deneniyor: kırıkların değen payı %1.</translation>
    </message>
    <message>
      <source>Trying another start point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir başlangıç noktası deneniyor.</translation>
    </message>
    <message>
      <source>Refined by the fractures: %1 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıklarla oturtuldu: değen pay %1.</translation>
    </message>
    <message>
      <source>Refined by the fractures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıklarla oturtuldu.</translation>
    </message>
    <message>
      <source>Trying %1: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 deneniyor: %2.</translation>
    </message>
    <message>
      <source>Trying %1: %2, fractures %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 deneniyor: %2, kırık aralığı %3.</translation>
    </message>
    <message>
      <source>Trying %1: %2; its fractures do not touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 deneniyor: %2; kırıklar değmiyor.</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2, parça %1</translation>
    </message>
    <message>
      <source>imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>içe aktarılmış</translation>
    </message>
    <message>
      <source>estimated by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>elle tahmin edildi</translation>
    </message>
    <message>
      <source>%1 confident; below %2, a person decides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 emin; %2 altında bir kişi karar verir.</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Enter</translation>
    </message>
    <message>
      <source>%1 ± %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ± %2</translation>
    </message>
    <message>
      <source>Only %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıkların yalnızca %1 kadarı birbirine değiyor.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep a number of the old context: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça eski kontekstin numarasını koruyor: %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag, because there is no bag %1 yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça torbasından ayrılıyor, çünkü henüz şu torba yok: %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça torbasından ayrılıyor.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BatchImporter</name>
    <message>
      <source>Import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 içe aktarılıyor</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kopya yerine konamıyor: %1.</translation>
    </message>
    <message numerus="yes">
      <source>Sheet recognised: %n marker(s). Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Sayfa tanındı: %n işaret. Boyutlar, yazılan %1 mm işaret kenarına dayanır; kâğıt üzerinde cetvelle denetleyin.</numerusform>
      </translation>
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
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Uyarı: %1</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yeniden</translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: duraklatıldı</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; ama tablada %n sayıldı</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 taslağını bekliyor.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti için kameralar yeniden bulundu; düzeneği yeniden kalibre edin (C).</translation>
    </message>
    <message>
      <source>You set it aside. Its photographs are kept; R takes it up again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenara koydunuz. Fotoğrafları duruyor; R onu yeniden ele alır.</translation>
    </message>
    <message>
      <source>%1; is %2 the sherd that it was? It measured %3 mm, now %4 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; %2 aynı parça mı? %3 mm idi, şimdi %4 mm</translation>
    </message>
    <message>
      <source>%1; the number %2 was typed on its plate, and none of its sherds has it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; %2 numarası plakasında yazıldı, ama parçalarının hiçbirinde yok</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n photographed again since</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%1; %n o zamandan beri yeniden fotoğraflandı</numerusform>
        </translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kenara ayrıldı</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Çekiliyor</translation>
    </message>
    <message>
        <source>Queued</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sırada</translation>
    </message>
    <message>
        <source>Processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İşleniyor</translation>
    </message>
    <message>
        <source>Paused</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Duraklatıldı</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Durdu</translation>
    </message>
    <message>
        <source>Needs review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Gözden geçirilecek</translation>
    </message>
    <message>
        <source>Done</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tamam</translation>
    </message>
    <message>
        <source>Draft: review it, then reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Taslak: gözden geçirin, sonra yeniden işleyin</translation>
    </message>
    <message>
        <source>Masks edited: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Maskeler düzenlendi: yeniden işleyin</translation>
    </message>
    <message>
        <source>Scale in doubt: see the report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ölçek kuşkulu: rapora bakın</translation>
    </message>
    <message>
        <source>Decided: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Karar verildi: yeniden işleyin</translation>
    </message>
    <message>
        <source>%1 sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 kesin</translation>
    </message>
    <message>
        <source>%1 decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 karar verildi</translation>
    </message>
    <message>
        <source>%1 to review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 gözden geçirilecek</translation>
    </message>
    <message>
        <source>draft, to be reprocessed; %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>taslak, yeniden işlenecek; %1</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n to reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%1; %n yeniden çekilecek</numerusform>
        </translation>
    </message>
    <message>
      <source>%1; joined to within %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; en çok %2 mm hatayla birleşti</translation>
    </message>
    <message numerus="yes">
      <source>%1 is ready: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 hazır: %n parça.</numerusform>
      </translation>
    </message>
    <message>
      <source>You cancelled it. Finished stages are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Siz iptal ettiniz. Biten aşamalar kaydedildi.</translation>
    </message>
    <message>
      <source>You removed it from the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sıradan siz çıkardınız.</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) queued.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Duraklatıldı; %n parti bekliyor.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the markers by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 çarpılmış: işaretleri %2 px kaçırıyor, kalibre edildiği yerden %3 mm uzakta.</translation>
    </message>
    <message>
      <source>It was interrupted. Reprocess it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yarıda kesildi; yeniden işleyin.</translation>
    </message>
    <message>
      <source>No bag was given; its sherds get their context in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Torba verilmedi; parçaların bağlamı katalogda girilir.</translation>
    </message>
    <message>
        <source>%1: stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: durduruluyor…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Durduruluyor…</translation>
    </message>
    <message>
      <source>%1, %2 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Draft: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Taslak: %1</translation>
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
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Numara ver</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ölçülen değerle değiştir</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n değer onay istiyor.</numerusform>
        </translation>
    </message>
    <message>
      <source>rejected: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri çevrildi: %1</translation>
    </message>
    <message>
      <source>Cancel and undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal et ve geri al</translation>
    </message>
    <message>
      <source>To change: %1. Unchanged: %2. Rejected: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değişecek: %1. Değişmeyen: %2. Reddedilen: %3.</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Karşılaştır</translation>
    </message>
    <message>
      <source>Type a value to see what would change, or press Enter in the empty field to delete.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Neyin değişeceğini görmek için bir değer yazın ya da silmek için boş alanda Enter tuşuna basın.</translation>
    </message>
    <message>
      <source>Make these bags</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu torbaları oluştur</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CandidateBar</name>
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
    <message>
        <source>gap %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>aralık %1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>temas yok</translation>
    </message>
    <message>
      <source>Another back…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka arka yüz …</translation>
    </message>
    <message>
      <source>by outline alone</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yalnızca dış hatta göre</translation>
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
</context>
<context>
    <name>ostraka::ui::CaptureScreen</name>
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
        <numerusform>%1: %n dosya içe aktarıldı; sırada.</numerusform>
      </translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden çek</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafları içe aktar…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramaları içe aktar…</translation>
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
      <source>This project photographs with no calibrated rig of its own.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje kendine ait kalibre edilmiş bir düzenekle çekim yapmıyor.</translation>
    </message>
    <message>
      <source>The rig is calibrated by %1; the calibration before is kept as %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek %1 ile kalibre edildi; önceki kalibrasyon %2 olarak saklandı.</translation>
    </message>
    <message>
      <source>'%1' names no bag: write site-trench-context-bag, or empty the line to go on without one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>“%1” bir torbanın adı değil: alan-açma-kontekst-torba yazın ya da onsuz sürdürmek için satırı boşaltın.</translation>
    </message>
    <message>
      <source>Set this batch aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partiyi kenara ayır</translation>
    </message>
    <message>
      <source>The bag is another now, the numbers are not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Torba artık başka, numaralar değil</translation>
    </message>
    <message>
      <source>Not as this bag&apos;s sherds are numbered: %1. Type them anew (N, or later in the catalogue), or say that they are right.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu torbanın parçalarının numaralandığı gibi değil: %1. Yeniden yazın (N ya da daha sonra katalogda) veya doğru olduklarını söyleyin.</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tamam</translation>
    </message>
    <message>
        <source>Next step</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sonraki adım</translation>
    </message>
    <message>
      <source>Stop turntable</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masayı durdur</translation>
    </message>
    <message>
      <source>Change rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka düzenek…</translation>
    </message>
    <message>
      <source>Loading picture…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Görüntü geliyor.</translation>
    </message>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce buna bakın</translation>
    </message>
    <message>
      <source>Type how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaç parça olduğunu söyle</translation>
    </message>
    <message>
      <source>Import cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarma iptal edildi; geride bir şey kalmadı.</translation>
    </message>
    <message>
      <source>Import anyway</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yine de içe aktar</translation>
    </message>
    <message>
      <source>Photograph this side again?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yüz bir kez daha çekilsin mi?</translation>
    </message>
    <message>
      <source>Keep these numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Doğrular</translation>
    </message>
    <message>
        <source>%1 The rig that worked before stays in use.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 Önceki düzenek kullanımda kalıyor.</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durdur</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafları tut</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, %2 %</translation>
    </message>
    <message>
      <source>%1 already has these files, so nothing was imported. If you import them anyway, its sherds appear twice in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bu dosyalara zaten sahip, bu yüzden hiçbir şey içe aktarılmadı. Yine de içe aktarırsanız parçaları katalogda iki kez yer alır.</translation>
    </message>
    <message>
      <source>%1 already has %2 of these %3 files, so nothing was imported. If you import them anyway, the catalogue holds the sherds of both batches; if you do not want that, set %1 aside in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bu %3 dosyadan %2 tanesine zaten sahip, bu yüzden hiçbir şey içe aktarılmadı. Yine de içe aktarırsanız katalogda ikisinin parçaları da yer alır; bunu istemiyorsanız %1 partisini sırada kenara ayırın.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>The label beside the backs names %1, but the fronts are of %2: check that these are the same sherds, or correct the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzlerin yanındaki etiket %1 diyor, ön yüzler ise %2 torbasından: aynı parçalar olup olmadığını denetleyin ya da torbayı düzeltin.</translation>
    </message>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek açılıyor</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kamerasının deklanşörüne basın.</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz düzenek yok</translation>
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
    <message>
      <source>This camera has no live view.</source>
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
      <source>You counted %1 sherds, the photographs show %2: look for one that is hidden, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 parça saydınız, fotoğraflarda %2 görünüyor: gizlenen, başkasına değen ya da hiç konmamış birini arayın.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 saydınız</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bu yüzün ortasında kesildi.</translation>
    </message>
    <message>
      <source>%1 is photographed whole, but nobody said that it is right: look at its photographs, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bütünüyle fotoğraflandı, ama kimse doğru olduğunu söylemedi: fotoğraflarına bakın, sonra sürdürün.</translation>
    </message>
    <message>
      <source>To be photographed again: %1. Lay them down with others, and type their numbers (N) when the fronts are shot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden fotoğraflanacak: %1. Onları diğerleriyle birlikte koyun ve ön yüzler çekilince numaralarını yazın (N).</translation>
    </message>
    <message>
      <source>Labels of several bags are in sight: %1. Leave the one of these sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birkaç torbanın etiketi görünüyor: %1. Yalnız bu parçalarınkini bırakın.</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: check whether one is in fragments or an object is not a sherd, or correct the count.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 parça saydınız, fotoğraflarda %2 görünüyor: parçalar hâlinde duran biri ya da parça olmayan bir şey var mı bakın veya sayıyı düzeltin.</translation>
    </message>
    <message>
        <source>The rig does not open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Düzenek açılmıyor</translation>
    </message>
    <message>
        <source>Taking calibration photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kalibrasyon fotoğrafları çekiliyor</translation>
    </message>
    <message>
        <source>The virtual rig turns the sherds over</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sanal düzenek parçaları çeviriyor</translation>
    </message>
    <message>
        <source>Nothing to do by hand: shoot the backs.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Elle yapılacak bir şey yok: arka yüzleri çekin.</translation>
    </message>
    <message>
        <source>Resume at position %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1. konumdan sürdür</translation>
    </message>
    <message>
        <source>Shoot the backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Arka yüzleri çek</translation>
    </message>
    <message>
        <source>Calibration photograph %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kalibrasyon fotoğrafı %1 / %2</translation>
    </message>
    <message>
        <source>Position %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Konum %1 / %2</translation>
    </message>
    <message>
        <source>Opening the rig…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Düzenek açılıyor</translation>
    </message>
    <message>
        <source>Lighting OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Işık uygun</translation>
    </message>
    <message>
      <source>%1 resumes where it stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kaldığı yerden sürüyor.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Bu yüzün şimdiye kadarki %n fotoğrafı güvende.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at position %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, konum %2: %3</translation>
    </message>
    <message>
      <source>Check the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşaltmadan önce tablaya bakın</translation>
    </message>
    <message>
      <source>Fronts up, two centimetres apart, the markers at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz yukarıda, iki santimetre aralık, kenardaki işaretler açıkta.</translation>
    </message>
    <message>
      <source>Hands off the turntable. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masaya dokunmayın. Esc hemen durdurur.</translation>
    </message>
    <message>
      <source>Space accepts anyway, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boşluk yine de sürdürür, R arka yüzleri yeniden çeker.</translation>
    </message>
    <message>
      <source>Accept and queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kabul et ve sıraya koy</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) saved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n fotoğraf güvende</numerusform>
      </translation>
    </message>
    <message>
      <source>Markers %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşaretler %1 / %2</translation>
    </message>
    <message>
      <source>Release camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamerayı serbest bırak</translation>
    </message>
    <message>
      <source>Markers %1 of %2, %3 needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşaretler %1 / %2, %3 gerekli</translation>
    </message>
    <message>
      <source>Its sherds are in the review (Ctrl+3): check them while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaları gözden geçirmede (Ctrl+3): hâlâ buradayken bakın</translation>
    </message>
    <message>
        <source>The turntable stands still. Saved photographs are kept.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Döner masa duruyor. Kaydedilen fotoğraflar korunur.</translation>
    </message>
    <message>
      <source>Nothing is wrong with the photographs of this side. Space or Esc keeps them; R once more puts all of them aside and takes new ones.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yüzün fotoğraflarında bir sorun yok. Boşluk ya da Esc onları tutar; bir kez daha R hepsini bir kenara koyup yenilerini çeker.</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafları tut</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durduruluyor…</translation>
    </message>
    <message>
      <source>%1 is processed; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 işlendi; sonraki parti bir tuş ötede.</translation>
    </message>
    <message>
      <source>No photograph of this side has been taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yüzün hiç fotoğrafı çekilmedi.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueScreen</name>
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
      <translation>%1 içe aktarımıyla gelen değişiklikler</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 içe aktarıldı: %2</translation>
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
      <translation>İçe aktar</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 içe aktarımı %3 satırdan %2 satır sonra kesildi; bunlar tamdır. Kalanı için yeniden içe aktarın.</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara alacak parçaları seçin.</translation>
    </message>
    <message>
        <source>No sherds yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Henüz parça yok</translation>
    </message>
    <message>
        <source>Sherds appear here when a batch is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bir parti işlenince parçalar burada görünür.</translation>
    </message>
    <message>
        <source>No sherds match this filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu süzgece uyan parça yok</translation>
    </message>
    <message>
        <source>Remove a condition to see more.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Daha fazlası için bir koşulu kaldırın.</translation>
    </message>
    <message>
        <source>Clear filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Süzgeci temizle</translation>
    </message>
    <message>
        <source>Model</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Model</translation>
    </message>
    <message>
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Numara ver</translation>
    </message>
    <message>
        <source>A void sherd gets no label, drawing or place on a plate, and its number is never given again. Is %1 void: “%2”?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geçersiz bir parçaya etiket, çizim ya da tablada yer verilmez ve numarası bir daha kullanılmaz. %1 geçersiz mi: “%2”?</translation>
    </message>
    <message>
      <source>Import…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktar …</translation>
    </message>
    <message>
      <source>Dismiss</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kapat</translation>
    </message>
    <message>
        <source>Void sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Parçayı geçersiz kıl</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Karşılaştır</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it; closing again discards it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz kaydedilmedi: %1. Alanda Enter kaydeder; yeniden kapatmak vazgeçer.</translation>
    </message>
    <message numerus="yes">
      <source>Export %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parçayı dışa aktar</numerusform>
      </translation>
    </message>
    <message>
      <source>Print labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Etiketleri yazdır</translation>
    </message>
    <message>
      <source>sherd labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parça etiketleri</translation>
    </message>
    <message>
      <source>Only sherds with a number get a label: assign the numbers first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnızca numarası olan parçalar etiket alır: önce numaraları verin.</translation>
    </message>
    <message>
      <source>Rename places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yerleri yeniden adlandır</translation>
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
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız parçası mı</translation>
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
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim ne diyor</translation>
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
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi: %1</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim yazıcıya gönderiliyor; % 100 boyutta yazdırın.</translation>
    </message>
    <message>
      <source>Automatic</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Otomatik</translation>
    </message>
    <message>
      <source>Rim sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız parçası</translation>
    </message>
    <message>
      <source>No rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız yok</translation>
    </message>
    <message>
      <source>Save…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydet …</translation>
    </message>
    <message>
      <source>Print…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazdır …</translation>
    </message>
    <message>
      <source>Previous sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önceki yaprak</translation>
    </message>
    <message>
      <source>Next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonraki yaprak</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal edildi. Hiçbir şey çizilmedi.</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça çiziliyor …</numerusform>
      </translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg);;PNG, the views of each sherd (*.png);;TIFF, the views of each sherd (*.tif)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, bütün yapraklar (*.pdf);;SVG, yaprak başına bir dosya (*.svg);;PNG, her parçanın görünüşleri (*.png);;TIFF, her parçanın görünüşleri (*.tif)</translation>
    </message>
    <message>
      <source>Different</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Farklı</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportModel</name>
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
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu adda bir klasör zaten var; başka bir ad seçin.</translation>
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
        <numerusform>%n parça, %1, döküm denetlendi</numerusform>
      </translation>
    </message>
    <message>
      <source>Counting…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayılıyor …</translation>
    </message>
    <message>
      <source>No sherds match this selection.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir parça uymuyor; başkalarını seçin.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal edildi. Geride bir şey kalmadı.</translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n tanesinin modeli yok: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>The whole project, %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projenin tamamı, %1</translation>
    </message>
    <message numerus="yes">
      <source>%n file(s) of the project are missing, changed or links; damage.txt in the archive lists them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Projenin %n dosyası eksik, değişmiş ya da bağlantı; arşivdeki damage.txt bunları listeler.</numerusform>
      </translation>
    </message>
    <message>
        <source>Everything in the project, with checksums. &apos;Restore an archive&apos; on the start screen makes the project from it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Projedeki her şey, sağlama toplamlarıyla. Başlangıç ekranındaki “Arşivi geri yükle” projeyi ondan yeniden kurar.</translation>
    </message>
    <message numerus="yes">
        <source>%n batch(es) in the queue: the archive holds their photographs and the stages that are finished when it is made; the restored project processes the rest.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Sırada %n parti var: arşiv, fotoğraflarını ve o ana kadar biten aşamaları içerir; gerisini geri yüklenen proje işler.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportScreen</name>
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
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarılanların süzgeci</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kontekst:0012</translation>
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
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarmanın ilerlemesi</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasörü aç</translation>
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
      <source>How large a GLB may be. PLY and OBJ get the same surface. Larger models get fewer triangles and smaller photographs; how far they are off is measured and stated in each file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir GLB dosyasının en fazla ne kadar büyük olabileceği. PLY ve OBJ aynı yüzeyi alır. Daha büyük modeller daha az üçgen ve daha küçük fotoğraflar alır; sapmaları ölçülür ve her dosyaya yazılır.</translation>
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
    <message>
      <source>The export is not finished, and nothing of it would be kept. Close once more to stop it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarma bitmedi ve ondan hiçbir şey kalmazdı. Durdurmak için bir kez daha kapatın.</translation>
    </message>
    <message>
        <source>Matching the filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Süzgece uyanlar</translation>
    </message>
    <message>
        <source>Formats</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Biçimler</translation>
    </message>
    <message>
        <source>Records (JSON), re-importable</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kayıtlar (JSON), yeniden içe aktarılabilir</translation>
    </message>
    <message>
        <source>Full detail</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tam ayrıntı</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İptal</translation>
    </message>
    <message>
        <source>Selected sherds</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Seçilen parçalar</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seç …</translation>
    </message>
    <message>
      <source>Folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarma klasörü</translation>
    </message>
    <message>
      <source>fit to A4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A4'e sığdığı gibi</translation>
    </message>
    <message>
      <source>for the web, up to 5 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>web için, en çok 5 MB</translation>
    </message>
    <message>
      <source>for a phone, up to 1 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>telefon için, en çok 1 MB</translation>
    </message>
    <message>
      <source>Tables (CSV): English headings, decimal points</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablolar (CSV): İngilizce başlıklar, ondalık nokta</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablolar (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>The whole project, as an archive</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projenin tamamı, arşiv olarak</translation>
    </message>
    <message>
      <source>Surfaces in the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimlerdeki yüzeyler</translation>
    </message>
    <message numerus="yes">
      <source>%n selected sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Seçilen %n parça</numerusform>
      </translation>
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
      <translation>rim T3 kalınlık&gt;6</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça</numerusform>
      </translation>
    </message>
    <message>
      <source>Remove the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 koşulunu kaldır</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, entered&gt;=2026-07-01, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sözcükler her yerde aranır; ware:grey, kalınlık&gt;6, kayıt&gt;=2026-07-01, -burnt, not:* da olur.</translation>
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
        <source>Idle</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Boşta</translation>
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
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kılavuz yalnızca İngilizcedir.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: the program uses no network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bilgisayardan hiçbir şey çıkmaz: içinde ağ yoktur.</translation>
    </message>
    <message>
      <source>Search the manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kılavuzda ara</translation>
    </message>
    <message>
      <source>The manual does not mention &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kılavuzda &apos;%1&apos; geçmiyor.</translation>
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
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kataloğa aktar</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz olmayan alan, açma, kontekst ve torbaları oluştur</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarmanın ilerlemesi</translation>
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
      <source>Keep the other versions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öteki sürümleri sakla</translation>
    </message>
    <message>
        <source>to confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>onaylanacak</translation>
    </message>
    <message>
        <source>Rows</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Satırlar</translation>
    </message>
    <message>
        <source>Columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sütunlar</translation>
    </message>
    <message numerus="yes">
        <source>Columns (%n to check)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Sütunlar (%n denetlenecek)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Confirm %n row(s)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n satırı onayla</numerusform>
        </translation>
    </message>
    <message>
      <source>updated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>değişmiş</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri çevrildi</translation>
    </message>
    <message>
      <source>unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>olduğu gibi</translation>
    </message>
    <message>
      <source>Table (CSV)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir tablo (CSV) …</translation>
    </message>
    <message>
      <source>Export folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dışa aktarma klasörü …</translation>
    </message>
    <message>
      <source>Effect of each row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her satır ne yapardı</translation>
    </message>
    <message>
      <source>Save rejected rows…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri çevrilenleri kaydet …</translation>
    </message>
    <message>
      <source>Save rejected rows</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri çevrilenleri kaydet</translation>
    </message>
    <message>
      <source>rejected.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri-cevrilen.csv</translation>
    </message>
    <message>
      <source>Line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>satır</translation>
    </message>
    <message>
      <source>Action</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ne olur</translation>
    </message>
    <message>
      <source>Reason</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>neden olmaz</translation>
    </message>
    <message>
      <source>Reading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bakılıyor …</translation>
    </message>
    <message>
      <source>Imported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarıldı: %1</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbirini alma</translation>
    </message>
    <message numerus="yes">
      <source>Import %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n satırı içe aktar</numerusform>
      </translation>
    </message>
    <message>
      <source>Another project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir proje …</translation>
    </message>
    <message>
        <source>A table of sherds has a column with their numbers; one of contexts has a column with theirs. Their names may be in any of the program's languages.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Parça tablosunda parça numaralarını içeren bir sütun, kontekst tablosunda kontekst numaralarını içeren bir sütun vardır. Adlar programın dillerinden herhangi birinde olabilir.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ‘%2’: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n satır onay istiyor.</numerusform>
        </translation>
    </message>
    <message>
      <source>%1 new, %2 updated, %3 unchanged, %4 rejected.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 yeni, %2 değişmiş, %3 olduğu gibi, %4 geri çevrildi.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal edildi. Hiçbir şey içe aktarılmadı.</translation>
    </message>
    <message numerus="yes">
      <source>Cancelled: %n row(s) were not imported. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>İptal edildi: %n satır içe aktarılmadı. Kalanı için tabloyu yeniden içe aktarın.</numerusform>
      </translation>
    </message>
    <message>
      <source>Undo does not take back contexts and bags; the catalogue is backed up before the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri alma kontekstleri ve torbaları kapsamaz; içe aktarmadan önce katalog yedeklenir.</translation>
    </message>
    <message>
      <source>Undo does not take back new sherds; each can be voided in its details.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri alma yeni parçaları kaldırmaz; her biri ayrıntılarında geçersiz kılınabilir.</translation>
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
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her yerde</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hesap durduruluyor; proje yeniden açılınca sürer. Pencere birazdan kapanır.</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri al: %1</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalog kopyalanamadı: %1</translation>
    </message>
    <message>
        <source>%1 is ready.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 hazır.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yinele</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yinele: %1</translation>
    </message>
    <message>
      <source>Queue: editing masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sıra: maskeleri düzenleme</translation>
    </message>
    <message>
      <source>%1 (read-only)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (salt okunur)</translation>
    </message>
    <message>
      <source>%1 is being processed. Leaving the project stops it, and it continues when the project is opened again. Choose Projects once more to leave.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 işleniyor. Projeden çıkmak bunu durdurur; proje yeniden açılınca sürer. Çıkmak için Projeler seçeneğini bir kez daha seçin.</translation>
    </message>
    <message>
      <source>Import cancelled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarma iptal edildi</translation>
    </message>
    <message>
      <source>The project that was created for it is removed. Your photographs are as they were.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bunun için oluşturulan proje kaldırıldı. Fotoğraflarınız olduğu gibi duruyor.</translation>
    </message>
    <message>
        <source>Restoring cancelled</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geri yükleme iptal edildi</translation>
    </message>
    <message>
        <source>Nothing was left behind.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geride hiçbir şey kalmadı.</translation>
    </message>
    <message>
        <source>The project is restored.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Proje geri yüklendi.</translation>
    </message>
    <message>
        <source>It was archived with damage:</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Hasarlı olarak arşivlenmişti:</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapScreen</name>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Plan ve etiket yazdır</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça %1</translation>
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
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her torba için etiket yazdır; kodu partiye kontekstini verir (Ctrl+Shift+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz torba yok: çekimde birini yazın ya da bir kontekst tablosu içe aktarın.</translation>
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
    <message>
        <source>No map yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Henüz harita yok</translation>
    </message>
    <message>
      <source>The map is still loading.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Harita hâlâ yükleniyor.</translation>
    </message>
    <message>
        <source>The map of a batch appears here once it is processed, and shows which sherd lay where.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bir partinin haritası işlendikten sonra burada görünür ve hangi parçanın nerede durduğunu gösterir.</translation>
    </message>
    <message>
      <source>%1 map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 plan ve etiketler</translation>
    </message>
    <message>
      <source>bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>torba etiketleri</translation>
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
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yükleniyor…</translation>
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
        <source>Dismiss</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kapat</translation>
    </message>
    <message>
        <source>OK</source>
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
      <source>No model yet: it comes when the batch of the sherd is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz model yok: parçanın partisi işlenince oluşur.</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the model cannot be turned.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu ekranda OpenGL 3.2 yok, bu yüzden model döndürülemiyor.</translation>
    </message>
    <message>
      <source>No model: the sherd belongs to no batch of photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Model yok: parça hiçbir fotoğraf partisine ait değil.</translation>
    </message>
    <message>
      <source>Large view</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Büyük görünüm</translation>
    </message>
    <message>
      <source>The model alone, as large as the page; again or Esc: beside the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnız model, sayfa kadar büyük; yeniden ya da Esc: tablonun yanında</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site&apos;s code has two to eight letters from A to Z and digits, without accents, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan kodu ARM1 gibi A'dan Z'ye iki ile sekiz büyük harf ve rakamdan oluşur; Ç, Ş gibi harfler olmaz.</translation>
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
    <message>
        <source>Photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotoğraflar</translation>
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
      <translation>Üst üste konmuş dış çizgiler ve dönüş açıları</translation>
    </message>
    <message>
      <source>Outlines overlaid</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>üst üste dış çizgiler</translation>
    </message>
    <message>
      <source>Turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dönüş açıları</translation>
    </message>
    <message>
      <source>The lines of a pair lie on each other.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir çiftte çizgiler üst üste gelir.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CardInHand</name>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz seçilmedi.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 seçimi</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>başlangıç noktası</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>elle döndürme</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tek başına bir arka yüzün kapalı modeli olmaz.</translation>
    </message>
    <message>
      <source>Cancelled. The back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durduruldu; arka yüz olduğu yerde kaldı.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnızca denenen artık yok: eşleri o zamandan beri kapatıldı.</translation>
    </message>
    <message>
      <source>The fractures do not touch here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıklar burada değmiyor.</translation>
    </message>
    <message>
      <source>Fractures %1 apart, %2 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırık aralığı %1, değen pay %2.</translation>
    </message>
    <message>
      <source>Turned by hand; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elle döndürüldü; B oturtmayı iyileştirir.</translation>
    </message>
    <message>
      <source>Start point %1; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başlangıç noktası %1; B oturtmayı iyileştirir.</translation>
    </message>
    <message>
      <source>refining the fit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>oturtmayı iyileştirme</translation>
    </message>
    <message>
      <source>This pair has no closed model yet. Reprocess the batch to make it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu eşin henüz kapalı modeli yok. Oluşturmak için partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>This back has no partner.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arka yüz tek başına.</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yükleniyor…</translation>
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
      <translation>Önce bir arka yüz seçin.</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce baş harflerinizi girin: her karar adını taşır.</translation>
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
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eş seçilmedi: önce bu arka yüzü bir ön yüze verin.</translation>
    </message>
    <message>
        <source>reshooting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 yeniden çekimi</translation>
    </message>
    <message>
        <source>merging %1 and %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 ve %2 birleştirme</translation>
    </message>
    <message>
        <source>splitting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 bölme</translation>
    </message>
    <message>
      <source>One of the two has no back to merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İkisinden birinin birleştirilecek arka yüzü yok.</translation>
    </message>
    <message>
      <source>A pair can be decided once it is shown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir eş hakkında, gösterildiğinde karar verilebilir.</translation>
    </message>
    <message>
      <source>All pairs of this batch are decided.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin bütün çiftlerine karar verildi.</translation>
    </message>
    <message>
      <source>Saved. Check %1 – %2: only %3 of their fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. %1 – %2 çiftini denetleyin: kırıklarının yalnızca %3 kadarı birbirine değiyor.</translation>
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
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yükleniyor…</translation>
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
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan, açma, kontekst ve torba</translation>
    </message>
    <message>
      <source>New: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni: %1</translation>
    </message>
    <message>
      <source>scan its label, or %1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>etiketini tarayın ya da %1-T3-0012-4</translation>
    </message>
    <message>
      <source>Write the bag as site-trench-context-bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Torbayı alan-açma-kontekst-torba olarak yazın.</translation>
    </message>
    <message>
      <source>No bag: the sherds can be numbered once the catalogue gives them a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Torba yok: katalog onlara bir kontekst verince parçalar numaralanabilir.</translation>
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
    <name>ostraka::ui::QueueScreen</name>
    <message>
      <source>This batch has no masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin maskesi yok.</translation>
    </message>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Duraklat</translation>
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
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 için henüz rapor yok.</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önce taslaklar</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kameraya çarpılmış: bu partinin fotoğrafları kameraların şimdi nerede olduğunu söylüyor (C)</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yeniden işle</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İptal</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Raporu göster</translation>
    </message>
    <message>
        <source>Review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Gözden geçir</translation>
    </message>
    <message>
        <source>Edit masks</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Maskeleri düzenle</translation>
    </message>
    <message>
        <source>Open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Aç</translation>
    </message>
    <message>
        <source>Processes each new batch quickly and coarsely, for a check while the sherds are still on the plate; reprocessing makes it final (D)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Her yeni partiyi parçalar hâlâ tabladayken denetlemek için hızlı ve kaba işler; yeniden işlenince kesinleşir (D)</translation>
    </message>
    <message>
        <source>Recalibrate rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Düzeneği yeniden kalibre et</translation>
    </message>
    <message>
        <source>What you photograph or import is processed here, one batch after the other, while you go on working.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Çektikleriniz ve içe aktardıklarınız, siz çalışırken burada parti parti işlenir.</translation>
    </message>
    <message>
        <source>Batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Parti</translation>
    </message>
    <message>
        <source>Resume</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sürdür</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kenara ayır</translation>
    </message>
    <message>
        <source>Cancel %1?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 iptal edilsin mi?</translation>
    </message>
    <message>
        <source>It has been processing for more than an hour. Finished stages are saved; the current one is lost.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bir saatten uzun süredir işleniyor. Biten aşamalar kayıtlı; süren aşama yitirilir.</translation>
    </message>
    <message>
        <source>Cancel it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İptal et</translation>
    </message>
    <message>
        <source>Keep processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İşlemeyi sürdür</translation>
    </message>
    <message>
      <source>Marker side…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşaret kenarı…</translation>
    </message>
    <message>
      <source>Keep both</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İkisini de tut</translation>
    </message>
    <message>
      <source>Processes this batch although another one has the same photographs; the sherds of both are then in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir partide aynı fotoğraflar olsa da bu partiyi işler; o zaman ikisinin parçaları da katalogda yer alır</translation>
    </message>
    <message>
      <source>The report of %1 is not opened: this version of Ostraka did not write it, and it may run scripts. Reprocess the batch to write it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 raporu açılmıyor: onu Ostraka’nın bu sürümü yazmadı ve komut dosyaları çalıştırabilir. Yeniden yazılması için partiyi yeniden işleyin.</translation>
    </message>
    <message>
        <source>The queue is paused: this project was restored from an archive.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sıra duraklatıldı: bu proje bir arşivden geri yüklendi.</translation>
    </message>
    <message>
        <source>Its batches that are not processed yet wait until you resume it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Henüz işlenmemiş partiler, siz sırayı sürdürene kadar bekler.</translation>
    </message>
    <message>
        <source>Photographs are being imported; their batch appears here when all of them are copied.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotoğraflar içe aktarılıyor; hepsi kopyalanınca partileri burada görünür.</translation>
    </message>
    <message>
        <source>Show the import</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İçe aktarmayı göster</translation>
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
      <translation>Ekranlar</translation>
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
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Model</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenara ayır</translation>
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
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçanın üzerinde uzunluğun bir ucuna, sonra öbür ucuna tıklayın. D bitirir.</translation>
    </message>
    <message>
        <source>Accept</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kabul et</translation>
    </message>
    <message>
        <source>Leave merging and splitting</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Birleştirme ve bölmeden çık</translation>
    </message>
    <message>
        <source>Refine fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Uyumu iyileştir</translation>
    </message>
    <message>
        <source>Refine the position by the fracture surfaces (B)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Konumu kırık yüzeylerine göre iyileştir (B)</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yeniden çek</translation>
    </message>
    <message>
        <source>View</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Görünüm</translation>
    </message>
    <message>
        <source>Fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Uyum</translation>
    </message>
    <message>
        <source>Decide</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Karar</translation>
    </message>
    <message>
        <source>Explode</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ayır</translation>
    </message>
    <message>
        <source>Fracture gap</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kırık aralığı</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Böl</translation>
    </message>
    <message>
        <source>Split a scan of two sherds along a line over its photograph (K)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İki parçanın taramasını fotoğrafındaki bir çizgi boyunca böl (K)</translation>
    </message>
    <message>
        <source>Merge</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Birleştir</translation>
    </message>
    <message>
        <source>Merge two fragments of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bir parçanın iki kırık parçasını birleştir: sonra öbür kartı seçin (J ön yüzler, Shift+J arka yüzler)</translation>
    </message>
    <message>
        <source>Merge backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Arka yüzleri birleştir</translation>
    </message>
    <message>
      <source>Comparing the fractures… Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıklar karşılaştırılıyor … Esc durdurur.</translation>
    </message>
    <message>
      <source>Refining the fit, fracture gap %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Oturtma iyileştiriliyor, kırık aralığı %1. Esc durdurur.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ReviewScreen</name>
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
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gözden geçirme</translation>
    </message>
    <message>
        <source>Update changed models</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Değişen modelleri güncelle</translation>
    </message>
    <message>
        <source>Reprocesses the pairs that were decided differently</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Farklı karar verilen eşleri yeniden işler</translation>
    </message>
    <message>
        <source>No pairs to review yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Henüz gözden geçirilecek eş yok</translation>
    </message>
    <message>
        <source>Photograph or import a batch. Its pairs appear here when it is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bir parti çekin ya da içe aktarın. Eşleri işlenince burada görünür.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Raporu göster</translation>
    </message>
    <message>
        <source>%1 was reshot as %2 in %3 and now has two records. Void one of them in the catalogue, or set the fragment aside here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, %3 içinde %2 olarak yeniden çekildi ve şimdi iki kaydı var. Katalogda birini geçersiz kılın ya da kırık parçayı burada kenara ayırın.</translation>
    </message>
    <message>
      <source>%1 is queued; only what changed is reprocessed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sırada; yalnız değişenler yeniden işlenir.</translation>
    </message>
    <message>
      <source>Saved. Pairs of the new fragments appear after reprocessing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. Yeni kırık parçaların eşleri yeniden işlendikten sonra görünür.</translation>
    </message>
    <message>
      <source>Undone. The history keeps both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri alındı. İkisi de geçmişte durur.</translation>
    </message>
    <message>
      <source>No pairs to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gözden geçirilecek eş yok</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Gözden geçirilecek %n eş</numerusform>
      </translation>
    </message>
    <message>
      <source>No measurement of %1 is certain. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 partisinin hiçbir ölçüsü kesin değil. %2</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd has no number, and %1 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. Yeniden işlenince birleşen parçanın numarası olmaz, %1 numarasının da kırık parçası olmaz. Geri alma onları yeniden ayırır.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd keeps the number %1, and %2 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. Yeniden işlenince birleşen parça %1 numarasını korur, %2 numarasının kırık parçası olmaz. Geri alma onları yeniden ayırır.</translation>
    </message>
    <message>
      <source>%1 has no scale: no length shown here is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 üzerinde bilinen bir uzunluk yok: burada gösterilen hiçbir sayı ve uzunluk milimetre değildir.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, number %1 goes to the half that it was typed on, or else to the larger one. Undo merges them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. Yeniden işlenince %1 numarası yazıldığı yarıya, yoksa büyüğüne gider. Geri alma onları yeniden birleştirir.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: the sherds in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. %1 partisinin bütün çiftlerine karar verildi. Sırada: katalogdaki parçalar.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: update the changed models.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi. %1 partisinin bütün çiftlerine karar verildi. Sırada: değişen modelleri güncellemek.</translation>
    </message>
    <message>
      <source>Saved, with your initials.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Baş harflerinizle kaydedildi.</translation>
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
      <translation>Fotoğrafları içe aktar…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramaları içe aktar…</translation>
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
    <message>
        <source>Keep current rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geçerli düzeneği koru</translation>
    </message>
    <message>
      <source>Import photographs taken by hand, or choose a rig file (RIG.json), which names your cameras and your turntable. The virtual rig is for practice: its sherds are invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Elle çekilmiş fotoğrafları içe aktarın ya da kameralarınızı ve döner tablanızı adlandıran bir düzenek dosyası (RIG.json) seçin. Sanal düzenek alıştırma içindir: parçaları uydurmadır.</translation>
    </message>
    <message>
      <source>No rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek yok</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal</translation>
    </message>
    <message>
      <source>Use the virtual rig in this project?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal düzenek bu projede kullanılsın mı?</translation>
    </message>
    <message>
      <source>It is for practice: its sherds are invented, and they enter this project's catalogue. The queue marks its batches as invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alıştırma içindir: parçaları uydurmadır ve bu projenin kataloğuna girer. Kuyruk, partilerini uydurma olarak işaretler.</translation>
    </message>
    <message>
        <source>Importing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İçe aktarılıyor</translation>
    </message>
    <message>
        <source>The batch goes into the queue when all of its files are copied. Meanwhile you can choose a rig.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Parti, bütün dosyaları kopyalanınca sıraya girer. Bu arada bir düzenek seçebilirsiniz.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectEdit</name>
    <message>
      <source>As photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflandığı gibi</translation>
    </message>
    <message>
      <source>Without the light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Işık olmadan</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık proje</translation>
    </message>
    <message>
      <source>Na&amp;me</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Proje adı</translation>
    </message>
    <message>
      <source>Site &amp;code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan k&amp;odu</translation>
    </message>
    <message>
      <source>Textures of new mo&amp;dels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni &amp;modellerin dokuları</translation>
    </message>
    <message>
      <source>rename the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>projeyi yeniden adlandır</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi.</translation>
    </message>
    <message>
      <source>change the textures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dokuları değiştir</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::RightsEdit</name>
    <message>
      <source>Rights to the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık projenin hakları</translation>
    </message>
    <message>
      <source>for instance CC-BY-4.0; empty: none is named</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>örneğin CC-BY-4.0; boş: hiçbiri belirtilmez</translation>
    </message>
    <message>
      <source>&amp;Licence of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarılanın &amp;lisansı</translation>
    </message>
    <message>
      <source>Who &amp;holds the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Hakların sahibi</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi.</translation>
    </message>
    <message>
      <source>change the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hakları değiştir</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SettingsPage</name>
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
        <source>Follow system</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sistemi izle</translation>
    </message>
    <message>
        <source>Recorded with each decision.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Her kararla birlikte kaydedilir.</translation>
    </message>
    <message>
        <source>Takes effect after restart.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yeniden başlatınca geçerli olur.</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geri (Esc)</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Şimdi yeniden başlat</translation>
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
      <source>7 is the running number in the sherd&apos;s context; =7 is the number 7 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, parçanın kontekstindeki sıra numarasıdır; =7 ise 7 numarasının kendisidir.</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Onayla</translation>
    </message>
    <message>
        <source>computed; replaced by the measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>hesaplanan; yerini ölçülen değer aldı</translation>
    </message>
    <message>
      <source>Assign number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarasını ver</translation>
    </message>
    <message>
      <source>Numbering…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numaralama…</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fotoğraf</translation>
    </message>
    <message>
      <source>mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maske</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tarama</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>model</translation>
    </message>
    <message>
      <source>picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resim</translation>
    </message>
    <message>
      <source>drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>çizim</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rapor</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ölçek</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz kaydedilmedi: %1. Alanda Enter kaydeder.</translation>
    </message>
    <message>
      <source>-0599/-0549: 600 to 550 BC</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>-0599/-0549: MÖ 600 – 550</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdEdits</name>
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
    <message numerus="yes">
      <source>%n sherd(s) got no number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça numara almadı: %1</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>numbering of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parçaya numara ver</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal edildi. Hiçbir şey değiştirilmedi.</translation>
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
      <translation>kaydedilmedi</translation>
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
    <message>
        <source>%1: measured by hand; the computed value is kept beside it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: elle ölçüldü; hesaplanan değer yanında tutuluyor.</translation>
    </message>
    <message>
        <source>%1: %2, measured by hand</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: %2, elle ölçüldü</translation>
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
      <source>%1
%2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2, %3</translation>
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
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 şimdi nerede?</translation>
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
        <source>Create project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Proje oluştur</translation>
    </message>
    <message>
        <source>Example</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Örnek</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tamam</translation>
    </message>
    <message>
        <source>Repair the catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kataloğu onar</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Projeyi aç</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2 yerinde yok: bulun …</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Enter</translation>
    </message>
    <message>
        <source>No project yet. Import photographs of both sides of your sherds, or drop their folders here: a project is created for them. To practise, try the virtual rig: it breaks a pot and photographs its sherds for you.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Henüz proje yok. Parçalarınızın iki yüzünün fotoğraflarını içe aktarın ya da klasörlerini buraya bırakın: onlar için bir proje oluşturulur. Alıştırma için sanal düzeneği deneyin: bir kabı kırar ve parçalarını fotoğraflar.</translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotoğrafları içe aktar…</translation>
    </message>
    <message>
        <source>Creates a project named after their folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Klasörlerinin adını taşıyan bir proje oluşturur</translation>
    </message>
    <message>
        <source>Folder of the photographs: both sides, or a folder for each side within it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotoğrafların klasörü: iki yüz birlikte ya da içinde her yüz için bir klasör</translation>
    </message>
    <message>
        <source>&amp;Restore an archive…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>A&amp;rşivi geri yükle…</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Geri yükle…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İptal</translation>
    </message>
    <message>
        <source>Restoring the project to %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Proje şuraya geri yükleniyor: %1</translation>
    </message>
    <message>
        <source>Folder of the archive</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Arşivin klasörü</translation>
    </message>
    <message>
        <source>Where to put the project: an empty folder, or one for a new folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Projenin yeri: boş bir klasör ya da içinde yeni klasör açılacak bir klasör</translation>
    </message>
    <message>
      <source>&amp;Open from folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasörden &amp;aç…</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projeyi aç</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n batch(es) unfinished</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; %n parti bitmedi</numerusform>
      </translation>
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
      <source>%1 of %2 positions done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 konumdan %1 tamam</translation>
    </message>
    <message>
      <source>%1 of %2 calibration photographs taken</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 kalibrasyon fotoğrafından %1 tanesi çekildi</translation>
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
        <translation>Ön yüz</translation>
    </message>
    <message>
        <source>Back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Arka yüz</translation>
    </message>
    <message>
        <source>No scale: lengths are not known</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ölçek yok: uzunluklar bilinmiyor</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>temas yok</translation>
    </message>
    <message>
        <source>filled in, not seen by a camera</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>dolduruldu, hiçbir kamera görmedi</translation>
    </message>
    <message>
        <source>Distance between the sides along the fracture</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Kırık boyunca yüzler arası uzaklık</translation>
    </message>
    <message>
        <source>front outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ön yüz %1 dışarıda</translation>
    </message>
    <message>
        <source>back outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>arka yüz %1 dışarıda</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, the whole number, or scan its label</source>
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
    <message>
      <source>Sherd %1 got no number. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numaralı parça numara almadı. %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskModel</name>
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
    <message>
      <source>%1, camera %2, position %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, kamera %2, konum %3</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 maskeleri</translation>
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
        <source>Previous photograph</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Önceki fotoğraf</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Yeniden işle</translation>
    </message>
    <message>
        <source>Brush</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fırça</translation>
    </message>
    <message>
        <source>Loading photograph…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Fotoğraf yükleniyor…</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) edited. Reprocess to update what follows from them.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n fotoğraf düzenlendi. Sonuçları güncellemek için yeniden işleyin.</numerusform>
        </translation>
    </message>
    <message>
        <source>Blue: classified as sherd. Paint missing parts as sherd and wrong ones as plate; the program&apos;s own masks stay.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Mavi: parça olarak sınıflandı. Eksikleri parça, yanlışları tabla olarak boyayın; programın maskeleri kalır.</translation>
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
        <numerusform>ve %n kontekstte daha</numerusform>
      </translation>
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
    <message>
      <source>Example</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça şöyle olur:</translation>
    </message>
    <message>
      <source>Use this &amp;numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Artık böyle numarala</translation>
    </message>
    <message>
      <source>Skipped numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Atlanan numaralar</translation>
    </message>
    <message>
      <source>none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yok</translation>
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
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydedildi.</translation>
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
      <source>&amp;Save vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sözcükleri &amp;kaydet</translation>
    </message>
    <message>
      <source>&amp;One per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Her satıra bir</translation>
    </message>
    <message>
      <source>Project vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık projenin sözcükleri</translation>
    </message>
    <message>
      <source>Terms, one per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sözcükler, her satıra bir</translation>
    </message>
    <message>
      <source>change the vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sözcükleri değiştirme</translation>
    </message>
    <message>
      <source>These terms are not saved yet.</source>
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
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarmanın ilerlemesi</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarmayı durdur</translation>
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
    <message>
      <source>Sherd %1: %2 is not as this bag's sherds are numbered (%3). If that is no slip, go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça %1: %2 bu torbanın parçalarının numaralanışı gibi değil (%3). Yanlış değilse devam edin.</translation>
    </message>
</context>
<context>
    <name>ostraka::Error</name>
    <message>
      <source>The disk has only %1 MB left, and a batch needs more. Nothing is lost: free some space, then resume.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Diskte yalnızca %1 MB kaldı; bir parti daha fazlasını ister. Hiçbir şey kaybolmadı: yer açın, sonra sürdürün.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but there is no sherd with a context in that place; assign it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: bu numara tabla üzerinde yazıldı, ama orada konteksti olan bir parça yok; numarayı katalogda verin.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but it belongs to another sherd; check which of the two bears it, and give the other one a new number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: bu numara plakada yazıldı, ama başka bir parçanın; ikisinden hangisinin taşıdığına bakın ve ötekine yeni bir numara verin.</translation>
    </message>
    <message>
      <source>Pairs were decided or masks edited while the batch was being processed; reprocess it to apply them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti işlenirken eşlere karar verildi ya da maskeler düzenlendi; bunlar için yeniden işleyin.</translation>
    </message>
    <message>
      <source>Sherds counted on the plate: %1, but another number was found; check the map for a sherd that is missing or was split in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabla üzerinde sayılan parça: %1. Başka bir sayı bulundu; eksik olanı ya da ikiye bölüneni planda arayın.</translation>
    </message>
    <message>
      <source>Cancelled.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal edildi.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera takılı değil ya da açık değil.</translation>
    </message>
    <message>
      <source>The camera does not answer and may be asleep. Turn off its automatic power-off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera yanıt vermiyor; uykuda mı? Otomatik kapanmasını kapatın.</translation>
    </message>
    <message>
      <source>The camera remains busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera meşgul kalıyor; kapatıp açın.</translation>
    </message>
    <message>
      <source>The connection to the camera failed; check its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamerayla bağlantı koptu; kablosuna bakın.</translation>
    </message>
    <message>
      <source>Another program uses the camera, often the desktop&apos;s file manager; &apos;ostraka devices&apos; names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamerayı başka bir program tutuyor, çoğu zaman dosya yöneticisi; 'ostraka devices' adını söyler.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; check this user&apos;s permissions with &apos;ostraka devices&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera açılamıyor; bu kullanıcı onu kullanabilir mi? 'ostraka devices' komutuna bakın.</translation>
    </message>
    <message>
      <source>The camera sent no photograph; check that it is focused and set to manual.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kameradan fotoğraf gelmedi; odaklı ve elle kipinde mi?</translation>
    </message>
    <message>
      <source>The camera does not stop sending photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera fotoğraf göndermeyi bırakmıyor.</translation>
    </message>
    <message>
      <source>This camera has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kamera canlı görüntü göstermiyor.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; check that nothing blocks it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa açısına ulaşmıyor; takılı mı?</translation>
    </message>
    <message>
      <source>The turntable was paused with its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa kendi düğmesinden duraklatıldı.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın konumu bilinmiyor: sıfırlayın ya da hizalayın.</translation>
    </message>
    <message>
      <source>The turntable does not answer on the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa ağda yanıt vermiyor.</translation>
    </message>
    <message>
      <source>The controller restarted; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Denetleyici yeniden başladı; masanın konumu bilinmiyor.</translation>
    </message>
    <message>
      <source>A reply from the turntable was lost, and it cannot report its position: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın bir yanıtı kayboldu ve nerede durduğunu söyleyemiyor: sıfırlayın ya da hizalayın.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masa bir GRBL denetleyicisi gibi yanıt vermiyor: açık mı, bu türden mi?</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masa bir ComXim gibi yanıt vermiyor: açık mı, bu türden mi?</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB bu bilgisayarda çalışmıyor.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Disk dolu; yer açın ve aynı işi yeniden başlatın.</translation>
    </message>
    <message>
      <source>The disk is full; free some space, then try again. No data was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Disk dolu; yer açın, sonra yeniden deneyin. Hiçbir şey kaybolmadı.</translation>
    </message>
    <message>
      <source>Another program is using the catalogue; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir program kataloğu meşgul ediyor; onu kapatın, sonra yeniden deneyin.</translation>
    </message>
    <message>
      <source>Another program is repairing or using the catalogue; this one waits up to 10 seconds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir program kataloğu onarıyor ya da kullanıyor; bu, en çok 10 saniye bekliyor.</translation>
    </message>
    <message>
      <source>The image file is truncated; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Resim sonundan önce kesilmiş; kameradan yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a kind of context; use layer, cut, fill, structure, surface or unstratified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>“%1” bir kontekst türü değil; layer, cut, fill, structure, surface ya da unstratified olabilir.</translation>
    </message>
    <message>
      <source>New sites and trenches: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz olmayan alanlar ve açmalar: %1; hiçbirinin yazım hatası olmadığına bakın.</translation>
    </message>
    <message>
      <source>The results of this batch no longer exist; reprocess it, then decide.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin sonuçları artık yok; yeniden işleyin, sonra karar verin.</translation>
    </message>
    <message>
      <source>Camera %1: its photographs come from different cameras (%2); give each camera its own name, because photographs with the same camera name share one lens calibration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: fotoğrafları farklı kameralardan geliyor (%2); her kameraya kendi adını verin, çünkü aynı kamera adını taşıyan fotoğraflar tek bir objektif kalibrasyonunu paylaşır.</translation>
    </message>
    <message>
      <source>Camera %1: its focal length varies between photographs (%2); all share one lens calibration, so fix the zoom and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: odak uzaklığı bütün fotoğraflarda aynı değil (%2); hepsi tek bir objektif kalibrasyonunu paylaşır, bu yüzden zumu sabitleyip yeniden çekin.</translation>
    </message>
    <message>
      <source>Camera %1: its aperture varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: diyafram açıklığı bütün fotoğraflarda aynı değil (%2); kamerayı elle ayara alın: eşit olmayan fotoğraflar maskeleri ve renkleri daha az güvenilir kılar.</translation>
    </message>
    <message>
      <source>Camera %1: its exposure time varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: poz süresi bütün fotoğraflarda aynı değil (%2); kamerayı elle ayara alın: eşit olmayan fotoğraflar maskeleri ve renkleri daha az güvenilir kılar.</translation>
    </message>
    <message>
      <source>Camera %1: its sensitivity varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: duyarlılığı bütün fotoğraflarda aynı değil (%2); kamerayı elle ayara alın: eşit olmayan fotoğraflar maskeleri ve renkleri daha az güvenilir kılar.</translation>
    </message>
    <message>
      <source>Camera %1: its white balance varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: beyaz dengesi bütün fotoğraflarda aynı değil (%2); kamerayı elle ayara alın: eşit olmayan fotoğraflar maskeleri ve renkleri daha az güvenilir kılar.</translation>
    </message>
    <message>
      <source>No camera model fits the calibration pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir kamera modeli kalibrasyon resimlerine uymuyor.</translation>
    </message>
    <message>
      <source>No photograph of this camera shows the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kameranın hiçbir fotoğrafı tablanın işaretlerini göstermiyor.</translation>
    </message>
    <message>
      <source>No batch folder was given.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti klasörü belirtilmedi.</translation>
    </message>
    <message>
      <source>The angle is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açı bir sayı değil.</translation>
    </message>
    <message>
      <source>This program is not installed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu program kurulu değil.</translation>
    </message>
    <message>
      <source>The photographs show no common object; check the cameras, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafların uyuştuğu bir cisim bulunamadı; kameraları denetleyin ya da maske verin.</translation>
    </message>
    <message>
      <source>A visual hull needs at least 3 photographs; photograph the object from more directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dış zarf için en az 3 fotoğraf gerekir; parçayı daha çok yönden çekin.</translation>
    </message>
    <message>
      <source>The cameras do not view a common area; check their poses.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kameralar ortak bir yere bakmıyor; duruşlarını denetleyin.</translation>
    </message>
    <message>
      <source>The network needs an 8-bit colour photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağ için 8 bitlik renkli bir fotoğraf gerekir.</translation>
    </message>
    <message>
      <source>The drawing needs a scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim için bir ölçek verilmedi.</translation>
    </message>
    <message>
      <source>The preview was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir önizleme geri alınır.</translation>
    </message>
    <message>
      <source>Restoring a project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir proje yeni ya da boş bir klasöre geri yüklenir; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>Not an archive of a whole project; import it as an export instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, bütün bir projenin arşivi değil; bunun yerine dışa aktarım olarak okuyun.</translation>
    </message>
    <message>
      <source>This is a project already, not an archive of one; open it as it is.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu zaten bir proje, arşiv değil; olduğu gibi açın.</translation>
    </message>
    <message>
      <source>This is an archive of a whole project, not an export; restore it (ostraka catalogue restore), then merge the restored project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, bütün bir projenin arşivi, dışa aktarım değil; geri yükleyin (ostraka catalogue restore), sonra geri yüklenen projeyi birleştirin.</translation>
    </message>
    <message>
      <source>The file or folder cannot be written (%1); choose another location, or check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buraya yazılamıyor (%1); başka bir yer seçin ya da izinlerini denetleyin.</translation>
    </message>
    <message>
      <source>There is no such file; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Böyle bir dosya yok; adını denetleyin.</translation>
    </message>
    <message>
      <source>The file cannot be opened (%1); check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya açılamıyor (%1); izinlerini denetleyin.</translation>
    </message>
    <message>
      <source>The file is larger than the limit of %1 bytes; check that it is the right one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya burada okunan %1 bayttan büyük; doğru dosya mı?</translation>
    </message>
    <message>
      <source>The file cannot be read (%1); copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya okunamıyor (%1); yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The JSON text is larger than 64 MiB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON metni 64 MiB’den büyük.</translation>
    </message>
    <message>
      <source>The JSON is nested more than 64 levels deep.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON 64 düzeyden daha derin iç içe.</translation>
    </message>
    <message>
      <source>Not valid JSON (line %1); correct that line, or copy the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu geçerli JSON değil (satır %1); orada düzeltin ya da dosyayı yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The JSON contains a number that is too large; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON içinde fazla büyük bir sayı var; düzeltin.</translation>
    </message>
    <message>
      <source>A transform must be a 4x4 matrix.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dönüşüm 4x4 matris olmalı.</translation>
    </message>
    <message>
      <source>A transform contains a value that is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dönüşümde sayı olmayan bir şey var.</translation>
    </message>
    <message>
      <source>A transform is not rigid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dönüşüm katı değil.</translation>
    </message>
    <message>
      <source>A transform moves by more than %1 mm; check that its last column is in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dönüşüm %1 mm'den fazla öteliyor; son sütununun mm olduğunu denetleyin.</translation>
    </message>
    <message>
      <source>There is no such folder; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Böyle bir klasör yok; bir partinin klasörünü belirtin.</translation>
    </message>
    <message>
      <source>The front side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz eksik; fotoğraflarını '%1' klasörüne koyun.</translation>
    </message>
    <message>
      <source>The back side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz eksik; fotoğraflarını '%1' klasörüne koyun.</translation>
    </message>
    <message>
      <source>Not a batch folder: it has neither the folders &apos;front&apos; and &apos;back&apos; nor &apos;top_images&apos; and &apos;bottom_images&apos;; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir parti değil: ne 'front' ve 'back' ne de 'top_images' ve 'bottom_images' klasörleri var; bir partinin klasörünü belirtin.</translation>
    </message>
    <message>
      <source>The file name does not match the form %1; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ad %1 biçiminde değil; bu fotoğraf atlanıyor.</translation>
    </message>
    <message>
      <source>Another photograph has the same camera and position; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir fotoğraf aynı kameradan ve konumdan; bu atlanıyor.</translation>
    </message>
    <message>
      <source>This photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğraf atlanıyor.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1 and %2 more. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Burada fotoğraf eksik: %1 ve %2 tane daha; yalnız onların gördüğü yerler doldurulacak, önemliyse yeniden çekin.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Burada fotoğraf eksik: %1; yalnız onların gördüğü yerler doldurulacak, önemliyse yeniden çekin.</translation>
    </message>
    <message>
      <source>This file name follows the naming of rig photographs, but most others do not; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu ad bir düzeneğin fotoğraf adı, diğerlerinin çoğu öyle değil; bu fotoğraf atlanıyor.</translation>
    </message>
    <message>
      <source>Another photograph has the same name; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir fotoğrafın adı aynı; bu atlanıyor.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2 and %3 more); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 megapikselden küçük fotoğraflar atlanıyor (%2 ve %3 tane daha); küçük resimler yerine kameradaki asıllarını kopyalayın.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 megapikselden küçük fotoğraflar atlanıyor (%2); küçük resimler yerine kameradaki asıllarını kopyalayın.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs are used: the most detailed ones, spread over the series. More would take longer and add little.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 / %2 fotoğraf kullanılıyor: diziye yayılmış en ayrıntılı olanlar. Daha fazlası uzun sürer, az şey katar.</translation>
    </message>
    <message>
      <source>This folder contains no photographs; put the photographs of one side into it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde fotoğraf yok; bir yüzün fotoğraflarını oraya koyun.</translation>
    </message>
    <message>
      <source>This folder contains neither photographs nor the folders &apos;front&apos; and &apos;back&apos; of a batch; choose a folder with photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde ne fotoğraf ne de bir partinin &apos;front&apos; ve &apos;back&apos; klasörleri var; fotoğraf içeren bir klasör belirtin.</translation>
    </message>
    <message>
      <source>There is no such folder; choose one with the photographs of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Böyle bir klasör yok; bir yüzün fotoğraflarını içeren bir klasör belirtin.</translation>
    </message>
    <message>
      <source>The same folder is given for the front and the back; choose the folder of each side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör hem ön hem arka yüz için belirtildi; her yüzün klasörünü belirtin.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün kullanılabilir fotoğrafları: %1; en az %2 gerekli. Her yönden daha fazlasını çekin.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün kullanılabilir fotoğrafları: %1; en az %2 gerekli. Her yönden daha fazlasını çekin.</translation>
    </message>
    <message>
      <source>The HEIC image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>HEIC resmi bozuk; yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The RAW image is damaged, or its camera is not supported; copy it again, or export it as TIFF.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>RAW resmi bozuk ya da bilinmeyen bir kameradan; yeniden kopyalayın ya da TIFF olarak dışa aktarın.</translation>
    </message>
    <message>
      <source>The side of a marker must be between 0.5 and 1000 mm; measure a black square on the paper.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir işaretin kenarı 0,5 ile 1000 mm arasında olmalı; kâğıttaki siyah bir kareyi ölçün.</translation>
    </message>
    <message>
      <source>No sheet with at least %1 markers of OpenCV&apos;s dictionaries was found in these %2 photographs; take photographs that show more of the sheet, or specify its plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu %2 fotoğrafta OpenCV sözlüklerinden en az %1 işaretli bir sayfa okunmuyor; onu daha çok gösteren fotoğraflar çekin ya da plate.json dosyasını belirtin.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in the photographs (%4 px) and are used instead. Measure the distance between two markers that are far apart and compare it with plate.json in the output folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfayı anlatan plate.json yok: fotoğraflarda kenarları %3 mm olan %1 %2 işareti bulundu (%4 px) ve sayfa sayıldı. Birbirinden uzak iki işaretin aralığını ölçüp çıktı klasöründeki plate.json ile karşılaştırın.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 were found in the photographs (%3 px), but their size is unknown, so the result has no scale. Measure the side of a marker&apos;s black square and give it with --marker-mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir plate.json sayfayı tanımlamıyor: fotoğraflarda %2 sözlüğünden %1 işaret bulundu (%3 px) ama boyutları bilinmiyor; bu yüzden sonucun ölçeği yok. Bir işaretin siyah karesinin kenarını ölçün ve --marker-mm ile belirtin.</translation>
    </message>
    <message>
      <source>This mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu maske kullanılmıyor.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size; the mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maskenin boyutu fotoğrafınınki değil; kullanılmıyor.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün kullanılabilir fotoğrafları: %1; en az %2 gerekli. %3 adlı fotoğraflar ekleyin.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün kullanılabilir fotoğrafları: %1; en az %2 gerekli. %3 adlı fotoğraflar ekleyin.</translation>
    </message>
    <message>
      <source>The file name is neither cam&lt;C&gt;_cal&lt;NN&gt;.jpg nor empty_cam&lt;C&gt;.jpg; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ad ne cam&lt;C&gt;_cal&lt;NN&gt;.jpg ne de empty_cam&lt;C&gt;.jpg; bu resim atlanıyor.</translation>
    </message>
    <message>
      <source>This picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu resim atlanıyor.</translation>
    </message>
    <message>
      <source>The image has %1 x %2 pixels, but the photographs from its camera have %3 x %4; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Resim %1 x %2 piksel, kamerasının fotoğrafları %3 x %4; bu resim atlanıyor.</translation>
    </message>
    <message>
      <source>The image header states a size of %1 x %2 pixels, which cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Resim %1 x %2 piksel boyut bildiriyor; bu kullanılamaz.</translation>
    </message>
    <message>
      <source>The network&apos;s file is damaged; copy it again, or export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağın dosyası bozuk; yeniden kopyalayın ya da dışa aktarın.</translation>
    </message>
    <message>
      <source>A layer of the network has &apos;%1&apos; %2, but only %3 to %4 can be used; use another network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağın bir katmanında “%1” %2, ancak yalnızca %3 ile %4 arası kullanılabilir; başka bir ağ kullanın.</translation>
    </message>
    <message>
      <source>The network&apos;s weights are in another file; export it as one file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağın ağırlıkları başka bir dosyada; tek dosya olarak dışa aktarın.</translation>
    </message>
    <message>
      <source>The network takes %1 GB of memory for one photograph, but at most %2 GB can be used; use a smaller network, or one with a smaller input.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağ bir fotoğraf için %1 GB bellek kullanıyor, ancak en çok %2 GB kullanılabilir; daha küçük bir ağ ya da girdisi daha küçük bir ağ kullanın.</translation>
    </message>
    <message>
      <source>The JPEG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JPEG resmi bozuk; yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The JPEG file contains no image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JPEG dosyasının içinde resim yok.</translation>
    </message>
    <message>
      <source>The PNG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PNG resmi bozuk; yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The TIFF file does not state the image&apos;s size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>TIFF resminde boyut yazmıyor.</translation>
    </message>
    <message>
      <source>The file is empty; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya boş; kameradan yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>Not a JPEG, PNG, TIFF, HEIC or RAW image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir JPEG, PNG, TIFF, HEIC ya da RAW resmi değil.</translation>
    </message>
    <message>
      <source>The known lengths cannot be used: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilinen uzunluklar kullanılamıyor: %1.</translation>
    </message>
    <message>
      <source>'side' must be 'front' or 'back'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'side' değeri 'front' ya da 'back' olmalı</translation>
    </message>
    <message>
      <source>'ends' must be two lists of marks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'ends' iki işaret listesi olmalı</translation>
    </message>
    <message>
      <source>each end must be marked on at least two photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>her uç en az iki fotoğrafta işaretlenmiş olmalı</translation>
    </message>
    <message>
      <source>their unit must be mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>birimleri mm olmalı</translation>
    </message>
    <message>
      <source>each needs 'side', 'length' and 'ends' with 'file' and 'pixel'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>her biri için 'side', 'length' ve içinde 'file' ile 'pixel' olan 'ends' gerekir</translation>
    </message>
    <message>
      <source>The image cannot be decoded; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Resim çözülemiyor; yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The plate&apos;s unit must be mm; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın birimi mm olmalı; tablanın dosyasını yeniden oluşturun.</translation>
    </message>
    <message>
      <source>The plate file lists more than 1024 markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabla 1024’ten fazla işaret bildiriyor.</translation>
    </message>
    <message>
      <source>The plate file needs &apos;dictionary&apos; and &apos;markers&apos;, each with an id and four corners of three numbers; &apos;diameter&apos;, if given, is a number in mm, &apos;sheet&apos; the paper&apos;s width and height.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabla dosyası için 'dictionary' ve her biri bir id ile üçer sayılık dört köşe içeren 'markers' gerekir; 'diameter' verilmişse mm cinsinden bir sayıdır, 'sheet' kâğıdın eni ve boyudur.</translation>
    </message>
    <message>
      <source>The plate file lists no markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabla hiç işaret bildirmiyor.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate has no valid corners.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın %1 numaralı işaretinin geçerli köşeleri yok.</translation>
    </message>
    <message>
      <source>Marker %1 occurs twice on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numaralı işaret tablada iki kez var.</translation>
    </message>
    <message>
      <source>The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and 'marker_mm'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kalibrasyon levhası için 'dictionary', 'squares_x', 'squares_y', 'square_mm' ve 'marker_mm' gerekir.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another batch name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu adda bir dosya zaten var ve üzerine yazılmıyor; başka bir parti belirtin.</translation>
    </message>
    <message>
      <source>This batch started on another plate; continue with that plate or start a new batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti başka bir tablada başlatılmıştı: onunla sürdürün ya da başka bir partiye başlayın.</translation>
    </message>
    <message>
      <source>This batch started with another setup (cameras: %1, positions: %2; now: %3 and %4); choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti başka bir kurulumla başladı (kamera: %1, konum: %2; şimdi: %3 ve %4); başka bir klasör seçin.</translation>
    </message>
    <message>
      <source>The photograph has changed since it was taken; restore the original or choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf çekildikten sonra değiştirilmiş; özgününü geri koyun ya da parti için başka bir klasör belirtin.</translation>
    </message>
    <message>
      <source>This photograph does not belong to this batch; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğraf burada çekilmedi; parti için başka bir klasör belirtin.</translation>
    </message>
    <message>
      <source>Camera %1 delivers raw files only; set its image format to JPEG, or to both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kamerası yalnız ham dosya veriyor; resim biçimini JPEG’e ya da ikisine birden ayarlayın.</translation>
    </message>
    <message>
      <source>%1 is %2, but the rig specifies %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ayarı %2, düzenek %3 diyor</translation>
    </message>
    <message>
      <source>%1 is %2, but the first photograph used %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ayarı %2, ilk fotoğrafta %3 idi</translation>
    </message>
    <message>
      <source>The turntable did not reach its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa sıfırına ulaşmadı.</translation>
    </message>
    <message>
      <source>The turntable does not report its position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa nerede durduğunu söylemiyor.</translation>
    </message>
    <message>
      <source>The turntable rejected a command (error %1): wrong turntable type or bad cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa bir komutu geri çevirdi (hata %1): yanlış masa türü ya da bozuk kablo.</translation>
    </message>
    <message>
      <source>The turntable&apos;s speed must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın hızı 0’dan büyük olmalı.</translation>
    </message>
    <message>
      <source>The connection to the turntable failed (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masayla bağlantı koptu (%1).</translation>
    </message>
    <message>
      <source>it is not open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>açık değil</translation>
    </message>
    <message>
      <source>it accepts no more data</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>artık bayt almıyor</translation>
    </message>
    <message>
      <source>it was closed at the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>öbür uçtan kapatıldı</translation>
    </message>
    <message>
      <source>You have no permission to use this serial port; install Ostraka&apos;s udev rules or join the group dialout, then log in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu seri portu kullanma izniniz yok; Ostraka’nın udev kurallarını kurun ya da dialout grubuna katılın ve yeniden oturum açın.</translation>
    </message>
    <message>
      <source>The serial port does not exist; check that the turntable is plugged in and switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seri port yok; döner masa takılı ve açık mı?</translation>
    </message>
    <message>
      <source>Not a serial port.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir seri port değil.</translation>
    </message>
    <message>
      <source>The serial port does not accept its settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seri port ayarlarını kabul etmiyor.</translation>
    </message>
    <message>
      <source>The turntable&apos;s address is unknown on this network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın adresi bu ağda bilinmiyor.</translation>
    </message>
    <message>
      <source>A serial port does not support %1 baud; common rates are 9600 and 115200.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir seri port %1 baud ile çalışamaz; olağan olanlar 9600 ve 115200.</translation>
    </message>
    <message>
      <source>A network address looks like 192.168.0.7:23.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir ağ adresi 192.168.0.7:23 gibidir.</translation>
    </message>
    <message>
      <source>The desktop does not release the camera: it is still in use by %1; close its file window and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masaüstü kamerayı bırakmıyor: %1 onu hâlâ tutuyor; dosya penceresini kapatıp yeniden deneyin.</translation>
    </message>
    <message>
      <source>A watched folder has no setting %1; set it on the camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İzlenen klasörün %1 ayarı yok; kamerada ayarlayın.</translation>
    </message>
    <message>
      <source>A watched folder has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İzlenen klasör canlı görüntü göstermiyor.</translation>
    </message>
    <message>
      <source>No new photograph arrived within %1 seconds; check that the camera&apos;s software writes into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 saniyede yeni fotoğraf gelmedi; kameranın yazılımı bu klasöre yazıyor mu?</translation>
    </message>
    <message>
      <source>The watched folder cannot be read (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İzlenen klasör okunamıyor (%1).</translation>
    </message>
    <message>
      <source>Two photographs arrived for one shot, %1 and %2; use one folder per camera and one photograph per position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir çekim için iki fotoğraf geldi, %1 ve %2; her kamera için bir klasör, her konum için bir fotoğraf.</translation>
    </message>
    <message>
      <source>The camera with this serial number is not plugged in; found: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu seri numaralı kamera takılı değil; takılı olan: %1.</translation>
    </message>
    <message>
      <source>The camera does not offer %1 for %2; it is set to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %2 için %1 değerini sunmuyor; şu an %3 değerinde.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3; check its mode dial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 ayarını %3 yerine %2 değerinde tutuyor; kip düğmesine bakın.</translation>
    </message>
    <message>
      <source>The camera has no setting %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kameranın %1 ayarı yok.</translation>
    </message>
    <message>
      <source>The camera reports: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera bildiriyor: %1.</translation>
    </message>
    <message>
      <source>The turntable has no zero switch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın sıfır anahtarı yok.</translation>
    </message>
    <message>
      <source>It did not answer while homing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sıfırlanırken yanıt vermedi.</translation>
    </message>
    <message>
      <source>It did not unlock.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kilidi açılmadı.</translation>
    </message>
    <message>
      <source>It did not answer the shutter command.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deklanşörlere basılacağı anda yanıt vermedi.</translation>
    </message>
    <message>
      <source>The turntable does not answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa yanıt vermiyor.</translation>
    </message>
    <message>
      <source>The turntable does not stop moving.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa durmuyor.</translation>
    </message>
    <message>
      <source>The turntable does not accept its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa sıfırını kabul etmiyor.</translation>
    </message>
    <message>
      <source>The controller reset its count; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Denetleyici baştan sayıyor; masanın konumu bilinmiyor.</translation>
    </message>
    <message>
      <source>The turntable does not move.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa hareket etmiyor.</translation>
    </message>
    <message>
      <source>The turntable did not arrive in time; it was stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa zamanında varmadı; durduruldu.</translation>
    </message>
    <message>
      <source>The shutter output must be M8, M7, M3 or M62 Pn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Deklanşör çıkışı M8, M7, M3 ya da M62 Pn olmalı.</translation>
    </message>
    <message>
      <source>The turntable was stopped while moving and lost its position: align the zero mark (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masa hareket ederken durduruldu ve konumu yitirildi: sıfır işaretini hizalayın (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller reports a turn beyond its travel: switch $20 off (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın denetleyicisi dönüşün sınırını aştığını söylüyor: $20 ayarını kapatın (ALARM:%1).</translation>
    </message>
    <message>
      <source>Homing failed: check the zero switch and its cable (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sıfırlama başarısız oldu: sıfır anahtarına ve kablosuna bakın (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller raised an alarm (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın denetleyicisi alarm verdi (ALARM:%1).</translation>
    </message>
    <message>
      <source>The controller does not understand the command: wrong controller type or bad cable (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Denetleyici komutu anlamıyor: yanlış denetleyici türü ya da bozuk kablo (error:%1).</translation>
    </message>
    <message>
      <source>The turntable has no zero switch (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın sıfır anahtarı yok (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is still moving (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masa hâlâ hareket ediyor (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is locked: home it or unlock it (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masa kilitli: sıfırlayın ya da kilidini açın (error:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller rejected a command (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın denetleyicisi bir komutu geri çevirdi (error:%1).</translation>
    </message>
    <message>
      <source>Turn the turntable counter-clockwise to %1 degrees, then take your hand away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masayı saat yönünün tersine %1 dereceye çevirin ve elinizi çekin.</translation>
    </message>
    <message>
      <source>Not an Ostraka photograph list; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir Ostraka fotoğraf listesi değil; parti için başka bir klasör belirtin.</translation>
    </message>
    <message>
      <source>The turntable driver %1 is unknown; available: grbl, comxim1, comxim2, text, hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın %1 sürücüsü bilinmiyor; olanlar: grbl, comxim1, comxim2, text, hand.</translation>
    </message>
    <message>
      <source>The camera driver %1 is unknown; available: folder, gphoto2, uvc.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kamera sürücüsü bilinmiyor; olanlar: folder, gphoto2, uvc.</translation>
    </message>
    <message>
      <source>The rig names no devices; &apos;ostraka devices&apos; lists what is plugged in and how to enter it in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek hiç aygıt bildirmiyor; 'ostraka devices' nelerin takılı olduğunu ve oraya nasıl yazılacağını söyler.</translation>
    </message>
    <message>
      <source>The rig names no camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek hiç kamera bildirmiyor.</translation>
    </message>
    <message>
      <source>settle_s and speed_deg_s must be positive.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>settle_s ve speed_deg_s pozitif olmalı.</translation>
    </message>
    <message>
      <source>The section &apos;devices&apos; cannot be read; compare it with docs/devices.md.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'devices' bölümü okunamıyor; docs/devices.md ile karşılaştırın.</translation>
    </message>
    <message>
      <source>The number of positions must be between 3 and 99.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Konum sayısı 3 ile 99 arasında olmalı.</translation>
    </message>
    <message>
      <source>The rig has no camera or no turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzeneğin kamerası ya da döner masası yok.</translation>
    </message>
    <message>
      <source>There is no shot %1 to retake: this side has positions 1 to %2 and cameras A to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden çekilecek %1 çekimi yok: bu yüzün 1–%2 konumları ve A–%3 kameraları var.</translation>
    </message>
    <message>
      <source>Camera %1 of this batch was %2, but the connected one is %3; continue with the original cameras or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin %1 kamerası %2 idi, buradaki %3; partiyi başlatan kameralarla sürdürün ya da başka bir klasör belirtin.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: turn its zero mark to the front and set zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Masanın konumu bilinmiyor: sıfır işaretini öne çevirin ve sıfırı belirleyin.</translation>
    </message>
    <message>
      <source>Camera %1, position %2 failed %3 times: %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, konum %2: %3 kez başarısız oldu: %4.</translation>
    </message>
    <message>
      <source>Camera %1 delivers only earlier or broken photographs; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kamerası yalnız önceki ya da bozuk fotoğraflar veriyor; kapatıp açın.</translation>
    </message>
    <message>
      <source>The turntable does not answer as a %1; check its type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa %1 gibi yanıt vermiyor; başka bir masa mı?</translation>
    </message>
    <message>
      <source>Marlin controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marlin denetleyicisi</translation>
    </message>
    <message>
      <source>text controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>metin denetleyicisi</translation>
    </message>
    <message>
      <source>This turntable has no zero switch: align it by eye.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu masanın sıfır anahtarı yok: gözle hizalayın.</translation>
    </message>
    <message>
      <source>The turntable rejects the command: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa geri çeviriyor: %1.</translation>
    </message>
    <message>
      <source>The turntable is at %1 degrees instead of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa %2 yerine %1 derecede duruyor.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;move&apos; must contain {target} or {by}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın lehçesi: 'move' içinde {target} ya da {by} olmalı.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;accepted&apos; must describe its answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın lehçesi: 'accepted' nasıl yanıt verdiğini söylemeli.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;query&apos; and &apos;position&apos; must be given together.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın lehçesi: 'query' ile 'position' birlikte verilir.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;reply_s&apos; must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın lehçesi: 'reply_s' 0’dan büyük olmalı.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;%1&apos; is not a regular expression.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın lehçesi: '%1' bir düzenli ifade değil.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;position&apos; needs a group for the angle.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın lehçesi: 'position' için açıyı veren bir öbek gerekir.</translation>
    </message>
    <message>
      <source>The turntable&apos;s &apos;dialect&apos; must be &quot;marlin&quot; or an object with its commands.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın 'dialect' değeri "marlin" ya da kendi sözcükleri olmalı.</translation>
    </message>
    <message>
      <source>The turntable is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa takılı değil.</translation>
    </message>
    <message>
      <source>The turntable&apos;s USB connection failed (%1); plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın USB bağlantısı kesildi (%1); yeniden takın.</translation>
    </message>
    <message>
      <source>You have no permission to use this USB device; install packaging/udev/70-ostraka.rules and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu USB aygıtını kullanma izniniz yok; packaging/udev/70-ostraka.rules dosyasını kurun ve yeniden takın.</translation>
    </message>
    <message>
      <source>Another program uses the turntable; close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masayı başka bir program kullanıyor; onu kapatın.</translation>
    </message>
    <message>
      <source>The turntable cannot be opened (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masa açılamıyor (%1).</translation>
    </message>
    <message>
      <source>This USB device is not a serial controller (CDC-ACM).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu USB aygıtı bir seri denetleyici değil (CDC-ACM).</translation>
    </message>
    <message>
      <source>The turntable with this serial number is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu seri numaralı döner masa takılı değil.</translation>
    </message>
    <message>
      <source>A USB turntable is named by vendor and product, for example usb:1209:0001.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB döner masa, usb:1209:0001 gibi üretici ve ürünle belirtilir.</translation>
    </message>
    <message>
      <source>The video camera cannot be opened; check that it is plugged in and that no other program uses it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Video kamera açılamıyor: takılı mı, onu başka bir program kullanıyor mu?</translation>
    </message>
    <message>
      <source>A video camera has exposure (0.1 ms), focus, white_balance (K) and gain, as numbers; not %1 %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Video kameranın exposure (0,1 ms), focus, white_balance (K) ve gain ayarları sayı olarak vardır; %1 %2 değil.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 ayarını %3 yerine %2 değerinde tutuyor.</translation>
    </message>
    <message>
      <source>The video camera no longer delivers pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Video kamera artık görüntü vermiyor.</translation>
    </message>
    <message>
      <source>The video camera took no picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Video kamera resim çekmedi.</translation>
    </message>
    <message>
      <source>The video camera delivers pictures of %1x%2 pixels instead of the configured size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Video kamera ayarlanan boyutta değil, %1x%2 piksellik resimler veriyor.</translation>
    </message>
    <message>
      <source>Another program is writing decisions or masks of this batch, so nothing was saved; try again in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir program bu partinin kararlarını ya da maskelerini yazıyor, bu yüzden hiçbir şey kaydedilmedi; birazdan yeniden deneyin.</translation>
    </message>
    <message>
      <source>The part of Ostraka that video cameras need cannot be loaded; install Ostraka again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka’nın video kameraların gerek duyduğu parçası yüklenemiyor; Ostraka’yı yeniden kurun.</translation>
    </message>
    <message>
      <source>The video camera must be named.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Video kamera belirtilmeli.</translation>
    </message>
    <message>
      <source>the file is truncated or not a picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>dosya yarım kalmış ya da resim değil</translation>
    </message>
    <message>
      <source>the markers show an angle other than this position&apos;s</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>işaretler bu konumun açısından başka bir açı gösteriyor</translation>
    </message>
    <message>
      <source>the picture&apos;s size differs from that of the camera&apos;s other pictures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resmin boyutu bu kameranın ötekilerinden farklı</translation>
    </message>
    <message>
      <source>too few markers are visible to identify the position: check that nothing covers them and that the picture is sharp</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>konumu belirlemek için çok az işaret görünüyor: önlerinde bir şey olmadığına ve resmin net olduğuna bakın</translation>
    </message>
    <message>
      <source>the camera delivered an earlier photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kamera önceki bir fotoğrafı yeniden verdi</translation>
    </message>
    <message>
      <source>too few markers of the plate are visible: check that nothing covers them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>tablanın çok az işareti görünüyor: önlerinde bir şey mi var?</translation>
    </message>
    <message>
      <source>the picture is blurred: check that the turntable is still and the focus is unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resim bulanık: döner masanın hareketsiz ve odağın değişmemiş olduğuna bakın</translation>
    </message>
    <message>
      <source>the sherds are too dark: add light or increase the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parçalar çok karanlık: daha çok ışık verin ya da daha uzun pozlayın</translation>
    </message>
    <message>
      <source>the sherds are overexposed: reduce the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parçalar patlamış: daha kısa pozlayın</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>resmin kenarı bir parçayı kesiyor: onu ya da kamerayı oynatın</translation>
    </message>
    <message>
      <source>the camera&apos;s settings have changed: restore them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kameranın ayarları öncekilerden farklı: geri alın</translation>
    </message>
    <message>
      <source>%1: restore it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: geri alın</translation>
    </message>
    <message>
      <source>A plate holds 1 to 60 sherds; 0 means not counted.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir tablaya 1–60 parça sığar; 0 sayılmadı demektir.</translation>
    </message>
    <message>
      <source>The number of a batch is also the name of its folder; use letters and digits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir partinin numarası klasörünün de adıdır; harf ve rakam kullanın.</translation>
    </message>
    <message>
      <source>The uuid of a batch is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir partinin uuid değeri düzgün yazılmamış.</translation>
    </message>
    <message>
      <source>The batch %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 partisi zaten var.</translation>
    </message>
    <message>
      <source>This batch is not in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti katalogda yok.</translation>
    </message>
    <message>
      <source>The project&apos;s code must be 2 to 8 letters from A to Z or digits, for example ARM.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projenin kodu ARM gibi A'dan Z'ye 2–8 büyük harf ya da rakam olmalı.</translation>
    </message>
    <message>
      <source>A vocabulary term must contain letters and no &apos;;&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir sözlük teriminde harf olmalı, ';' olmamalı.</translation>
    </message>
    <message>
      <source>The term &apos;%1&apos; appears twice in the vocabulary.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' terimi sözlükte iki kez var.</translation>
    </message>
    <message>
      <source>Sherds with the term '%1': %2; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>“%1” terimini taşıyan parçalar: %2; önce onları değiştirin.</translation>
    </message>
    <message>
      <source>a row of %1 refers to a missing row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir %1 satırı hiçbir şeyi göstermiyor</translation>
    </message>
    <message>
      <source>the sherd tables are inconsistent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>parçaların tabloları birbirini tutmuyor</translation>
    </message>
    <message>
      <source>the search index is incomplete</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arama tüm parçaları bilmiyor</translation>
    </message>
    <message>
      <source>The backup does not contain the saved data; try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yedek, kaydedileni içermiyor; yeniden deneyin.</translation>
    </message>
    <message>
      <source>The catalogue cannot be opened; check that the folder exists and is writable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalog açılamıyor; klasörün var ve yazılabilir olduğunu denetleyin.</translation>
    </message>
    <message>
      <source>The catalogue cannot be written to; check the permissions of the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kataloğa yazılamıyor; klasörün izinlerini denetleyin.</translation>
    </message>
    <message>
      <source>The disk reports errors; check it, then reopen the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Disk düzgün yanıt vermiyor; denetleyin, sonra projeyi yeniden açın.</translation>
    </message>
    <message>
      <source>The catalogue rejects this operation (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalog bunu kabul etmiyor (%1).</translation>
    </message>
    <message>
      <source>The scan is not a front of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tarama bu partinin bir ön yüzü değil.</translation>
    </message>
    <message>
      <source>The scan is not a back of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tarama bu partinin bir arka yüzü değil.</translation>
    </message>
    <message>
      <source>A pair needs a front and a back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir eş için bir ön yüz ve bir arka yüz gerekir.</translation>
    </message>
    <message>
      <source>The decision to undo is not in this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri alınacak karar bu partide değil.</translation>
    </message>
    <message>
      <source>A decision needs a front, a back or both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir karar ön yüzü, arka yüzü ya da ikisini belirtir.</translation>
    </message>
    <message>
      <source>The uuid of a decision is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kararın uuid değeri düzgün yazılmamış.</translation>
    </message>
    <message>
      <source>This file is outside the project&apos;s folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya projenin klasöründe değil.</translation>
    </message>
    <message>
      <source>This is a draft from reduced photographs; reprocess the batch for final measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, küçültülmüş fotoğraflardan bir taslak; kesin ölçüler için partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>These results of &apos;ostraka process&apos; are incomplete; run it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bunlar 'ostraka process' komutunun tam sonuçları değil; yeniden çalıştırın.</translation>
    </message>
    <message>
      <source>Another program is entering results of this batch; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir program bu partinin sonuçlarını giriyor; bu, onun bitmesini bekliyor.</translation>
    </message>
    <message>
      <source>The pair table names the scan %1, which is missing; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Eş tablosu olmayan %1 taramasını belirtiyor; 'ostraka process' komutunu yeniden çalıştırın.</translation>
    </message>
    <message>
      <source>This batch is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti artık katalogda yok.</translation>
    </message>
    <message>
      <source>This photograph is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğraf artık katalogda yok.</translation>
    </message>
    <message>
      <source>This scan is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu tarama artık katalogda yok.</translation>
    </message>
    <message>
      <source>This file is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya artık katalogda yok.</translation>
    </message>
    <message>
      <source>This person is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kişi artık katalogda yok.</translation>
    </message>
    <message>
      <source>This site is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu alan artık katalogda yok.</translation>
    </message>
    <message>
      <source>This trench is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu açma artık katalogda yok.</translation>
    </message>
    <message>
      <source>This context is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kontekst artık katalogda yok.</translation>
    </message>
    <message>
      <source>This bag is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu torba artık katalogda yok.</translation>
    </message>
    <message>
      <source>The filter has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Süzgeç bir tırnak açıyor ve kapatmıyor.</translation>
    </message>
    <message>
      <source>This is only part of a sherd&apos;s label; scan its code again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, bir parça etiketinin yalnız bir bölümü; kodunu yeniden okutun.</translation>
    </message>
    <message>
      <source>The filter is not valid text.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Süzgeç okunabilir bir metin değil.</translation>
    </message>
    <message>
      <source>There is no field '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' alanı yok.</translation>
    </message>
    <message>
      <source>Some of the changes remain because they could not be undone: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değişikliklerin bir kısmı kalıyor, çünkü geri alınamadı: %1</translation>
    </message>
    <message>
      <source>There is no measurement of this kind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu türden bir ölçü yok.</translation>
    </message>
    <message>
      <source>A measurement cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir ölçü hiçbir zaman 0’ın altında olmaz.</translation>
    </message>
    <message>
      <source>A newer Ostraka made this project (catalogue version %1, this program supports %2). Nothing was changed. Install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu projeyi daha yeni bir Ostraka yapmış (katalog sürümü %1, bu program %2 sürümünü destekliyor). Hiçbir şey değiştirilmedi. Yeni sürümü kurun.</translation>
    </message>
    <message>
      <source>The numbering cannot contain the character &apos;%1&apos;; letters, digits, &apos;.&apos;, &apos;_&apos;, &apos;/&apos; and &apos;-&apos; are allowed between the tokens.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numaralama '%1' karakterini içeremez; yer tutucular arasında harf, rakam, '.', '_', '/' ve '-' kullanılabilir.</translation>
    </message>
    <message>
      <source>The numbering opens a token with { and does not close it with }.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numaralama bir yer tutucuyu { ile açıyor ve } ile kapatmıyor.</translation>
    </message>
    <message>
      <source>The numbering has no token {%1}; available: site, trench, context, bag, batch, yyyy, yy and n.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numaralamada {%1} yer tutucusu yok; olanlar: site, trench, context, bag, batch, yyyy, yy ve n.</translation>
    </message>
    <message>
      <source>The width of {%1} must be written as :04, with 12 digits at most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{%1} genişliği :04 gibi yazılmalı, en çok 12 hane olabilir.</translation>
    </message>
    <message>
      <source>Two tokens are adjacent; put &apos;-&apos; or another character between {%1} and {%2}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki yer tutucu birbirine bitişik; {%1} ile {%2} arasına '-' ya da başka bir işaret koyun.</translation>
    </message>
    <message>
      <source>The numbering must count the sherds with {n} exactly once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numaralama parçaları {n} ile tam bir kez saymalı.</translation>
    </message>
    <message>
      <source>The number needs the site of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara için parçanın alanı gerekir, o da kayıtlı değil.</translation>
    </message>
    <message>
      <source>The number needs the context of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara için parçanın konteksti gerekir, o da kayıtlı değil.</translation>
    </message>
    <message>
      <source>The number needs the bag of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara için parçanın torbası gerekir, o da kayıtlı değil.</translation>
    </message>
    <message>
      <source>The number needs the batch of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara için parçanın partisi gerekir, o da kayıtlı değil.</translation>
    </message>
    <message>
      <source>The site %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alanı, numarada yanında duran '%2' işaretini içeriyor.</translation>
    </message>
    <message>
      <source>The trench %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 açması, numarada yanında duran '%2' işaretini içeriyor.</translation>
    </message>
    <message>
      <source>The context %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 konteksti, numarada yanında duran '%2' işaretini içeriyor.</translation>
    </message>
    <message>
      <source>The bag %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 torbası, numarada yanında duran '%2' işaretini içeriyor.</translation>
    </message>
    <message>
      <source>The batch %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 partisi, numarada yanında duran '%2' işaretini içeriyor.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before; numbers are never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası daha önce verilmiş; numaralar bir daha kullanılmaz.</translation>
    </message>
    <message>
      <source>The block of numbers up to %1 is used up; assign this computer a new block in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarasına kadar olan blok bitti; ayarlarda bu bilgisayara yeni bir blok verin.</translation>
    </message>
    <message>
      <source>A decision needs the name of the person who makes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir karar için onu veren kişinin adı gerekir.</translation>
    </message>
    <message>
      <source>A merge needs two or more fragments.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birleştirme için iki ya da daha çok kırık parça gerekir.</translation>
    </message>
    <message>
      <source>A split needs exactly one fragment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bölme için tam bir kırık parça gerekir.</translation>
    </message>
    <message>
      <source>The name of a person must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kişinin adı boş olamaz.</translation>
    </message>
    <message>
      <source>The person's initials must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kişinin baş harfleri boş olamaz.</translation>
    </message>
    <message>
      <source>The code of a site must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir alanın kodu boş olamaz.</translation>
    </message>
    <message>
      <source>The code of a trench must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir açmanın kodu boş olamaz.</translation>
    </message>
    <message>
      <source>The number of a context must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kontekstin numarası boş olamaz.</translation>
    </message>
    <message>
      <source>The number of a bag must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir torbanın numarası boş olamaz.</translation>
    </message>
    <message>
      <source>The name of a person must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kişinin adı çok uzun; en çok 200 harf.</translation>
    </message>
    <message>
      <source>The person&apos;s initials must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kişinin baş harfleri çok uzun; en çok 200 harf.</translation>
    </message>
    <message>
      <source>The code of a site must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir alanın kodu çok uzun; en çok 200 harf.</translation>
    </message>
    <message>
      <source>The code of a trench must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir açmanın kodu çok uzun; en çok 200 harf.</translation>
    </message>
    <message>
      <source>The number of a context must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kontekstin numarası çok uzun; en çok 200 harf.</translation>
    </message>
    <message>
      <source>The number of a bag must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir torbanın numarası çok uzun; en çok 200 harf.</translation>
    </message>
    <message>
      <source>The uuid is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>uuid değeri düzgün yazılmamış.</translation>
    </message>
    <message>
      <source>The initials %1 already belong to another person.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 baş harfleri zaten başka bir kişinin.</translation>
    </message>
    <message>
      <source>The latitude must be between -90 and 90 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Enlem -90 ile 90 derece arasındadır.</translation>
    </message>
    <message>
      <source>The longitude must be between -180 and 180 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boylam -180 ile 180 derece arasındadır.</translation>
    </message>
    <message>
      <source>The site %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alanı zaten var.</translation>
    </message>
    <message>
      <source>A trench needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir açma bir alana aittir.</translation>
    </message>
    <message>
      <source>A trench cannot contain itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir açma kendi içinde olamaz.</translation>
    </message>
    <message>
      <source>The trench %1 already exists in this site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu alanda %1 açması zaten var.</translation>
    </message>
    <message>
      <source>A context needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kontekst bir alana aittir.</translation>
    </message>
    <message>
      <source>The trench and the context belong to different sites.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açma, kontekstten başka bir alana ait.</translation>
    </message>
    <message>
      <source>The context %1 already exists in this place.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yerde %1 konteksti zaten var.</translation>
    </message>
    <message>
      <source>A bag needs a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir torba bir kontekste aittir.</translation>
    </message>
    <message>
      <source>The weight of a bag must be greater than 0 g.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir torbanın ağırlığı 0 g üzerindedir.</translation>
    </message>
    <message>
      <source>A count cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir sayım hiçbir zaman 0’ın altında olmaz.</translation>
    </message>
    <message>
      <source>The bag %1 already exists in this context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kontekstte %1 torbası zaten var.</translation>
    </message>
    <message>
      <source>The folder is on a network share (%1), which can damage catalogues; use a folder on this computer&apos;s own disk and copy backups to the share.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasör bir ağ paylaşımında (%1); kataloglar orada bozulur. Bu bilgisayarın kendi diskinde bir klasör kullanın ve yedekleri paylaşıma kopyalayın.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör bir Ostraka projesi değil: içinde catalogue.sqlite yok.</translation>
    </message>
    <message>
      <source>A new project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni proje için yeni ya da boş bir klasör gerekir; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>The folder cannot be created; choose a location that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasör oluşturulamıyor; yazabileceğiniz bir yer seçin.</translation>
    </message>
    <message>
      <source>A uuid of the export is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarmadaki bir uuid düzgün yazılmamış.</translation>
    </message>
    <message>
      <source>The decision is saved with the batch, but %1 is not in the catalogue yet; it is added with the next results.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Karar partiyle birlikte kaydedildi, ama %1 henüz katalogda yok; sonraki sonuçlarla girilecek.</translation>
    </message>
    <message>
      <source>The field %1 is read-only: the program sets it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alanı programdan gelir.</translation>
    </message>
    <message>
      <source>A void sherd keeps its number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geçersiz bir parça numarasını korur.</translation>
    </message>
    <message>
      <source>A number cannot contain a line break, a tab or &apos;%&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numarada satır sonu, sekme ve '%' olmaz.</translation>
    </message>
    <message>
      <source>A number or code cannot contain invisible characters; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir numara veya kod görünmez karakter içeremez; yeniden yazın.</translation>
    </message>
    <message>
      <source>A number has at most 120 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara en çok 120 karakter olabilir.</translation>
    </message>
    <message>
      <source>The number %1 would be assigned twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası iki kez verilmiş olurdu.</translation>
    </message>
    <message>
      <source>The files of %1 would have the same names as those of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 dosyaları %2 dosyalarıyla aynı adları taşırdı.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası daha önce verilmiş ve bir daha kullanılmaz.</translation>
    </message>
    <message>
      <source>The number %1 belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası başka bir parçanın.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0 after ±, or 0 if the uncertainty is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>± işaretinden sonra gelen 0’dan büyüktür; belirsizlik bilinmiyorsa 0’dır.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir ölçü 0’dan büyüktür.</translation>
    </message>
    <message>
      <source>No sherd is larger than 1000 mm; check that the value is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir parça 1000 mm’den büyük değildir; bu milimetre mi?</translation>
    </message>
    <message>
      <source>No sherd is heavier than 20 kg; check that the value is in grams.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir parça 20 kg’dan ağır değildir; bu gram mı?</translation>
    </message>
    <message>
      <source>A share cannot exceed 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir pay en çok 100 % olur.</translation>
    </message>
    <message>
      <source>There is no sherd %1 to join.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birleşebileceği bir %1 parçası yok.</translation>
    </message>
    <message>
      <source>A sherd cannot join itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça kendisiyle birleşmez.</translation>
    </message>
    <message>
      <source>There is no context %1 in %2; add it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 içinde %1 konteksti yok; önce onu ekleyin.</translation>
    </message>
    <message>
      <source>A numbered sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numaralı bir parçanın konteksti olmalı.</translation>
    </message>
    <message>
      <source>A sherd needs its context before it gets a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça, konteksti bilinince numara alır.</translation>
    </message>
    <message>
      <source>The table cannot be sorted by &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablo '%1' ile sıralanamıyor.</translation>
    </message>
    <message>
      <source>A sherd is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça artık katalogda yok.</translation>
    </message>
    <message>
      <source>The uuid of a sherd is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parçanın uuid değeri düzgün yazılmamış.</translation>
    </message>
    <message>
      <source>A sherd with this uuid already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu uuid ile bir parça zaten var.</translation>
    </message>
    <message>
      <source>A void sherd needs a reason; enter it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça bir nedenle geçersizdir; nedenini yazın.</translation>
    </message>
    <message>
      <source>The number %1 appears on two sherds of this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası bu tablanın iki parçasında var.</translation>
    </message>
    <message>
      <source>The number %1 already belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası zaten başka bir parçanın.</translation>
    </message>
    <message>
      <source>The sherd of this label has no number yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu etiketin parçasının henüz numarası yok.</translation>
    </message>
    <message>
      <source>The text is longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Metin 1 MB’den uzun.</translation>
    </message>
    <message>
      <source>The text is not valid UTF-8 or contains a zero byte.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Metin geçerli UTF-8 değil ya da sıfır bayt içeriyor.</translation>
    </message>
    <message>
      <source>The text contains control characters, which documents cannot contain; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Metin, belgelerin içeremeyeceği denetim karakterleri içeriyor; yeniden yazın.</translation>
    </message>
    <message>
      <source>Write the day as 2026-07-14 (year-month-day).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gün 2026-07-14 gibi yazılır (yıl-ay-gün).</translation>
    </message>
    <message>
      <source>Write the Munsell colour as 10YR 3/1 or N 4/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell rengi 10YR 3/1 ya da N 4/ gibi yazılır.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a number; write 12.5 or 12,5, without a unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' bir sayı değil; birim olmadan 12.5 ya da 12,5 yazın.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a path inside its folder; it must be relative, with &apos;/&apos; and without &apos;..&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' klasörünün içinde bir yol değil; göreli olmalı, '/' içermeli, '..' içermemeli.</translation>
    </message>
    <message>
      <source>Not a PLY file; choose one, or export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir PLY dosyası değil; bir PLY belirtin ya da taramayı yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY header states no format; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY başlığı biçim bildirmiyor; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY header has an error in line %1: %2; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY başlığının %1. satırı yanlış: %2; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>its format is unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>biçimi bilinmiyor</translation>
    </message>
    <message>
      <source>a count is not a number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir adet sayı değil</translation>
    </message>
    <message>
      <source>a property cannot be read</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir özellik okunamıyor</translation>
    </message>
    <message>
      <source>a property has an unknown type</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir özelliğin türü bilinmiyor</translation>
    </message>
    <message>
      <source>the length of a list is not a whole number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir listenin uzunluğu tam sayı değil</translation>
    </message>
    <message>
      <source>a line cannot be parsed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bir satır anlaşılmıyor</translation>
    </message>
    <message>
      <source>The PLY header has no end; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY başlığının sonu yok; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY header declares %1 of &apos;%2&apos;, more than the file contains; the file may be truncated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY başlığı %1 '%2' bildiriyor, dosyada bu kadar yok; yarım kalmış olabilir.</translation>
    </message>
    <message>
      <source>The PLY file has two lists of vertices; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyasında iki köşe listesi var; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY vertices lack x, y or z; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY köşelerinde x, y ya da z eksik; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY file ends early or contains a value that is not a number; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyası erken bitiyor ya da sayı olmayan bir şey içeriyor; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>A face of the PLY file refers to a vertex that does not exist; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyasının bir yüzeyi olmayan bir köşeyi gösteriyor; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY file ends within '%1'; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyası '%1' ortasında bitiyor; yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The PLY file has no vertices; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyasında köşe yok; taramayı yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY file states its unit as &apos;%1&apos;, but lengths must be in mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyası birimini '%1' olarak belirtiyor, ama uzunluklar mm olmalı; mm olarak dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY file contains more data than its header declares; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyası başlığının bildirdiğinden fazlasını içeriyor; yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY file contains no usable points; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyasında kullanılabilir nokta yok; taramayı yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>No part of the edge can be a rim; draw this sherd without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenarın hiçbir bölümü ağız kenarı olamaz; bu parçayı ağızsız bir parça olarak çizin.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %), so no diameter is given; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dudak sanılan yer pek dudağa benzemiyor (%1 %), bu yüzden çap verilmiyor; parçanın nasıl durduğunu denetleyin.</translation>
    </message>
    <message>
      <source>The preserved rim is too short or too straight for a diameter; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız parçası çap vermek için fazla kısa ya da fazla düz; parçanın nasıl durduğunu denetleyin.</translation>
    </message>
    <message>
      <source>Drawn as a rim sherd, which is likely (%1 %); check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız olarak çizildi, bu olası (%1 %); denetleyin.</translation>
    </message>
    <message>
      <source>This may be a rim sherd (%1 %); if it is, mark it as one and redraw it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız olabilir (%1 %); öyleyse belirtin ve yeniden çizin.</translation>
    </message>
    <message>
      <source>The drawing&apos;s scale must be between 1:20 and 5:1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizimin ölçeği 1:20 ile 5:1 arasında olmalı.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model (%1); create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim için kapalı bir model gerekir (%1); 'ostraka process' ile yapın.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model; create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizim için kapalı bir model gerekir; 'ostraka process' ile yapın.</translation>
    </message>
    <message>
      <source>The manifest is missing; not an Ostraka export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya listesi (manifest) eksik; bu bir Ostraka dışa aktarması değil.</translation>
    </message>
    <message>
      <source>The manifest has a line that cannot be read (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bildirimde okunamayan bir satır var (%1), bu yüzden hiçbir şey okunmadı; klasörü yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The manifest names a file outside the folder (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bildirim klasörün dışında bir dosya anıyor (%1), bu yüzden hiçbir şey okunmadı; klasörü yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>The manifest names the file %1 twice, so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bildirim %1 dosyasını iki kez anıyor, bu yüzden hiçbir şey okunmadı; klasörü yeniden kopyalayın.</translation>
    </message>
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu adda bir klasör zaten var; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>Not every system supports names with a line break, a backslash or characters that are not UTF-8; rename this file or folder, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Satır sonu, ters eğik çizgi ya da UTF-8 olmayan karakter içeren bir adı her sistem korumaz; bu dosyayı ya da klasörü yeniden adlandırıp yeniden deneyin.</translation>
    </message>
    <message>
      <source>On some systems this is the same name as %1; rename one of the two, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bazı sistemlerde bu ad %1 ile aynıdır; ikisinden birini yeniden adlandırıp yeniden deneyin.</translation>
    </message>
    <message>
      <source>Project A has another file with this name, which its catalogue does not list; nothing was merged. Move that file elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A projesinde bu adda, kataloğunun tanımadığı başka bir dosya var; onu başka yere taşıyın, hiçbir şey birleştirilmedi.</translation>
    </message>
    <message>
      <source>Two files of the export would have the same name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarmanın iki dosyası aynı adı taşırdı.</translation>
    </message>
    <message>
      <source>Another import into this project is running; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu projeye başka bir içe aktarma sürüyor; bu, onun bitmesini bekliyor.</translation>
    </message>
    <message>
      <source>Files that were missing from the project and are restored: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projede eksik olup geri gelen dosyalar: %1.</translation>
    </message>
    <message>
      <source>A folder with this name was created in the meantime; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arada biri bu adda bir klasör oluşturmuş; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>Not an Ostraka export: this folder has no bagit.txt.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör bir Ostraka dışa aktarması değil: bagit.txt eksik.</translation>
    </message>
    <message>
      <source>This file is not in the manifest; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya listede (manifest) yok; hiçbir şey okunmadı.</translation>
    </message>
    <message>
      <source>This is a link, not a file; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir bağlantı, dosya değil; hiçbir şey okunmadı.</translation>
    </message>
    <message>
      <source>This folder cannot be read (%1); nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör okunamıyor (%1); hiçbir şey okunmadı.</translation>
    </message>
    <message>
      <source>This file is missing; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya eksik; hiçbir şey okunmadı.</translation>
    </message>
    <message>
      <source>This file has changed since the export; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya dışa aktarmadan sonra değiştirilmiş; hiçbir şey okunmadı.</translation>
    </message>
    <message>
      <source>The column &apos;closed&apos; accepts only yes or no.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>closed sütununa yes ya da no yazılır.</translation>
    </message>
    <message>
      <source>The column &apos;count_written&apos; accepts only a whole number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>count_written sütununa tam sayı yazılır.</translation>
    </message>
    <message>
      <source>Values in the row: %1, columns in the header: %2; correct the row.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Satırdaki değer sayısı: %1, başlıktaki sütun sayısı: %2; satırı düzeltin.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; is unknown; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' sütunu bilinmiyor; değerleri kendi alanınız olarak saklanıyor.</translation>
    </message>
    <message>
      <source>Not a text file: it contains binary data, which a table never does.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya metin değil: hiçbir tabloda olmayan ikili veriler içeriyor.</translation>
    </message>
    <message>
      <source>This is a spreadsheet (ODS, XLSX), not a CSV table; save the sheet as 'CSV UTF-8' and import that file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir hesap tablosu dosyası (ODS, XLSX), CSV tablosu değil; sayfayı 'CSV UTF-8' olarak kaydedip o dosyayı içe aktarın.</translation>
    </message>
    <message>
      <source>Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. satır UTF-8 değil; tabloyu 'CSV UTF-8' olarak kaydedip yeniden deneyin.</translation>
    </message>
    <message>
      <source>The table has more than 1,000,000 rows; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabloda 1.000.000’dan çok satır var; bölün.</translation>
    </message>
    <message>
      <source>The table has more than 1,000 columns; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabloda 1.000’den çok sütun var; bölün.</translation>
    </message>
    <message>
      <source>Line %1 has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. satır hiç kapatılmayan bir tırnak açıyor.</translation>
    </message>
    <message>
      <source>Line %1 has characters after a closing quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. satırda kapanan tırnaktan sonra harfler var.</translation>
    </message>
    <message>
      <source>Line %1 has a value longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. satırda 1 MB’den uzun bir değer var.</translation>
    </message>
    <message>
      <source>The table is empty; its first line must name the columns.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablo boş; ilk satırı sütunları adlandırmalı.</translation>
    </message>
    <message>
      <source>This sherd has no model yet, so it cannot be drawn; process its batch first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parçanın henüz modeli yok, bu yüzden çizilemiyor; önce partisini işleyin.</translation>
    </message>
    <message>
      <source>The measurements of its batch are in doubt, and so is the size of this drawing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Partisinin ölçüleri şüpheli: bu çizimin boyutu da öyle.</translation>
    </message>
    <message>
      <source>The sherd is recorded as a rim, but no part of its edge can be one; it is drawn without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağız olduğu söylenmiş, ama kenarının hiçbir bölümü ağız olamaz; ağızsız çizildi.</translation>
    </message>
    <message>
      <source>%1 is missing and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 yok ve atlandı.</translation>
    </message>
    <message>
      <source>%1 differs from the recorded photograph; check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kayda girilen fotoğraf değil; denetleyin.</translation>
    </message>
    <message>
      <source>This model or picture of the sherd %1 differs from the recorded one; reprocess its batch %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 parçasının bu modeli ya da resmi kaydedilenden farklı; %2 partisini yeniden işleyin.</translation>
    </message>
    <message>
      <source>%1 is exported in full detail: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 olduğu gibi aktarıldı: %2</translation>
    </message>
    <message>
      <source>%1 is exported without photographs: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 fotoğrafsız dışa aktarılıyor: %2</translation>
    </message>
    <message>
      <source>Photographs can be projected only onto a closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflar kapalı olmayan bir modele yerleştirilemez.</translation>
    </message>
    <message>
      <source>Not drawn: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çizilmedi: %1</translation>
    </message>
    <message>
      <source>Drawn without its photographs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafları olmadan çizildi: %1</translation>
    </message>
    <message>
      <source>No pictures with masks and poses of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 için maske ve duruşlu resim yok: %2</translation>
    </message>
    <message>
      <source>No sherds to export; select some first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarılacak parça yok; önce birkaçını seçin.</translation>
    </message>
    <message>
      <source>The row has neither a number nor a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Satırda ne numara ne de uuid var.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, tablonun birden fazla satırında var; satırlar: %1.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1 and %2 more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, tablonun birden fazla satırında var; satırlar: %1 ve %2 tane daha.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is unusual for a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birimi denetleyin: %1 bir parça için olağan dışı.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is far from the other values of this column.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birimi denetleyin: %1 bu sütunun öteki değerlerinden çok uzak.</translation>
    </message>
    <message>
      <source>Not a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir uuid değil.</translation>
    </message>
    <message>
      <source>The number and the uuid belong to different sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara, uuid’nin gösterdiğinden başka bir parçanın.</translation>
    </message>
    <message>
      <source>A new sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni bir parçanın konteksti olmalı.</translation>
    </message>
    <message>
      <source>A column of the table has no name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablonun bir sütununun adı yok.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; appears twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' sütunu iki kez var.</translation>
    </message>
    <message>
      <source>These places and batches are not in Ostraka&apos;s format.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yerler ve partiler Ostraka’nın yazdığı gibi yazılmamış.</translation>
    </message>
    <message>
      <source>Not a PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir PLY dosyası değil.</translation>
    </message>
    <message>
      <source>Not a GLB file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir GLB dosyası değil.</translation>
    </message>
    <message>
      <source>This export contains no sherd records (JSON); export it again with them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dışa aktarmada parça kayıtları (JSON) yok; kayıtlarla birlikte yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The project already has this sherd with other values, which it keeps; the differing values are added in fields that end in _in_%1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projede bu parça başka değerlerle var; onlar kalıyor, farklı olanlar yanlarında _in_%1 ile biten alanlarda saklanıyor.</translation>
    </message>
    <message>
      <source>This file is not part of the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya dışa aktarmanın dosyaları arasında değil.</translation>
    </message>
    <message>
      <source>The project has another file with this name; rename the export and import it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projede bu adda başka bir dosya var; dışa aktarmanın adını değiştirin ve yeniden içe aktarın.</translation>
    </message>
    <message>
      <source>Not a sherd record (ostraka-sherd/1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir parça kaydı değil (ostraka-sherd/1).</translation>
    </message>
    <message>
      <source>The measurement %1 has a unit other than %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ölçüsünün birimi %2 değil.</translation>
    </message>
    <message>
      <source>A value of the record has the wrong type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaydın bir değeri olması gereken türde değil.</translation>
    </message>
    <message>
      <source>This is too large for one ZIP file; select fewer sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, tek bir ZIP dosyası için çok büyük; daha az parça seçin.</translation>
    </message>
    <message>
      <source>The mask is missing; expected a mask of %1 x %2 pixels under this name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maske eksik; bu adla %1 x %2 piksellik bir maske bekleniyor.</translation>
    </message>
    <message>
      <source>The mask cannot be read as a picture; expected a mask of %1 x %2 pixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maske resim olarak okunamıyor; %1 x %2 piksellik bir maske bekleniyor.</translation>
    </message>
    <message>
      <source>The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size of its photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maske %1 x %2 piksel; fotoğrafı boyutunda, %3 x %4 piksellik bir maske bekleniyor.</translation>
    </message>
    <message>
      <source>Masks from the plate need at least 3 photographs of a side; photograph more positions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabladan maske için bir yüzün en az 3 fotoğrafı gerekir; daha çok konum çekin.</translation>
    </message>
    <message>
      <source>The photograph differs in size from its camera&apos;s images; use the original file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraf kamerasının boyutunda değil; özgün dosyayı kullanın.</translation>
    </message>
    <message>
      <source>No sherd was found on the plate; check that the photographs show sherds that stand out from the plate, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablada parça bulunamadı; fotoğraflarda tabladan ayrılan parçalar olduğunu denetleyin ya da maske verin.</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 differs in size from the camera&apos;s other photographs; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maskeler: %1 kamerasının boş tablası, kameranın fotoğraflarından farklı boyutta; onsuz maskelendi</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows the plate at none of the positions; retake it at the first; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maskeler: %1 kamerasının boş tabla fotoğrafı tablayı hiçbir konumda göstermiyor; ilk konumda yeniden çekin; maskeler onsuz yapıldı</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows covered markers in %2; uncover them; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maskeler: %1 kamerasının boş tablasında görünen işaretleri %2 resminde bir şey örtüyor; üzerlerindekini kaldırın; onsuz maskelendi</translation>
    </message>
    <message>
      <source>masks: a shadow that the other photographs do not show falls on the plate in %1; keep people and hands out of the light, and retake these if their masks look wrong</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maskeler: %1 içinde tablanın üzerine öteki fotoğraflarda olmayan bir gölge düşüyor; insanları ve elleri ışıktan uzak tutun, maskeleri yanlış görünüyorsa bunları yeniden çekin</translation>
    </message>
    <message>
      <source>%1 (%2 % of the bare plate)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (çıplak tablanın %2 %)</translation>
    </message>
    <message>
      <source>masks: flat objects that look like labels or scale bars are left out (%1); if there are sherds among them, add them to the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>maskeler: etikete veya ölçek çubuğuna benzeyen düz şeyler dışarıda bırakıldı (%1); aralarında çanak çömlek parçası varsa maskelere ekleyin</translation>
    </message>
    <message>
      <source>The front scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz taramasında hiç nokta yok.</translation>
    </message>
    <message>
      <source>The front scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz taramasının normalleri yok; bir model dışının neresi olduğunu bilmek ister.</translation>
    </message>
    <message>
      <source>The back scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz taramasında hiç nokta yok.</translation>
    </message>
    <message>
      <source>The back scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz taramasının normalleri yok; bir model dışının neresi olduğunu bilmek ister.</translation>
    </message>
    <message>
      <source>The scans do not enclose a volume; their normals may point inward.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramalar bir gövde çevrelemiyor; normalleri içe bakıyor olabilir.</translation>
    </message>
    <message>
      <source>Only a closed mesh can be simplified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnız kapalı bir ağ seyreltilebilir.</translation>
    </message>
    <message>
      <source>The deviation of a simplified mesh must be greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seyreltilmiş bir ağın sapması 0 mm’den büyük olmalı.</translation>
    </message>
    <message>
      <source>The scan is too large for a model at this spacing; use a larger spacing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tarama bu nokta aralığında bir model için çok büyük; daha büyük bir aralık verin.</translation>
    </message>
    <message>
      <source>The scans contain too few points that agree with each other for a model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramalarda bir model için birbiriyle uyuşan çok az nokta var.</translation>
    </message>
    <message>
      <source>This model is %1 mm in size, larger than any vessel, so its unit is probably not mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu model %1 mm büyüklüğünde, her kaptan daha büyük; birimi başka görünüyor: mm olarak dışa aktarın.</translation>
    </message>
    <message>
      <source>This model is only %1 mm in size, smaller than any sherd, so its unit is probably not mm (%2); export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu model yalnızca %1 mm büyüklüğünde, her parçadan küçük; birimi büyük olasılıkla başka (%2): mm olarak dışa aktarın.</translation>
    </message>
    <message>
      <source>Edge %1 is used more than once in the same direction.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ayrıtı aynı yönde birden çok kez kullanılmış.</translation>
    </message>
    <message>
      <source>Edge %1 has a face on one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ayrıtının yalnız bir yanında yüzey var.</translation>
    </message>
    <message>
      <source>Vertex %1 belongs to no face.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 köşesi hiçbir yüzeye ait değil.</translation>
    </message>
    <message>
      <source>Vertex %1 joins two separate fans of faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 köşesi iki yüzey yelpazesini bir arada tutuyor.</translation>
    </message>
    <message>
      <source>The mesh has no faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ağın yüzeyi yok.</translation>
    </message>
    <message>
      <source>A face refers to a vertex that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir yüzey, var olmayan bir köşeyi anıyor.</translation>
    </message>
    <message>
      <source>A face has the same vertex twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir yüzeyde aynı köşe iki kez var.</translation>
    </message>
    <message>
      <source>The scan&apos;s outline is not closed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramanın dış çizgisi kapanmıyor.</translation>
    </message>
    <message>
      <source>A scan of fewer than 20 points has no outline.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>20 noktadan az bir taramanın dış çizgisi olmaz.</translation>
    </message>
    <message>
      <source>A contour needs at least three points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir dış çizgi en az üç nokta ister.</translation>
    </message>
    <message>
      <source>The evidence for a pair has no valid scans or value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir eşin verilerinde geçerli tarama ya da sayı yok.</translation>
    </message>
    <message>
      <source>pairing: %1 stays unpaired: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>eşleştirme: %1 eşsiz kalıyor: %2</translation>
    </message>
    <message>
      <source>No two outlines match, so the sizes of the two sides cannot be compared; provide a known length.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birbirine benzeyen iki dış çizgi yok, bu yüzden yüzlerin boyutları karşılaştırılamıyor; bilinen bir uzunluk verin.</translation>
    </message>
    <message>
      <source>A candidate refers to a scan that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir aday, var olmayan bir taramayı anıyor.</translation>
    </message>
    <message>
      <source>Not a candidate table; reprocess the batch, which redoes only its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir aday tablosu değil; partiyi yeniden işleyin, yalnız eşleri yeniden yapılır.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, whose side has been reshot since; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 tarafından %1 tarihinde verilen karar, yüzü o zamandan beri yeniden çekilen %3 içindir; yeniden karar verin.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, which is no longer on the plate; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 tarafından %1 tarihinde verilen karar, artık tablada olmayan %3 içindir; yeniden karar verin.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 has no effect: the later decision of %3 by %4 concerns the same scan; withdraw one of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 tarafından %1 tarihinde verilen karar geçerli değil: daha sonraki %3 tarihli karar (%4) aynı tarama içindir; ikisinden birini geri alın.</translation>
    </message>
    <message>
      <source>A decision is of an unknown kind; a newer version of Ostraka wrote it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir karar bu programın bilmediği türden; onu daha yeni bir program yazmış.</translation>
    </message>
    <message>
      <source>A pair needs one front and one back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir eş için bir ön yüz ve bir arka yüz gerekir.</translation>
    </message>
    <message>
      <source>Nothing is selected to set aside or reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenara ayrılacak ya da yeniden çekilecek bir şey verilmedi.</translation>
    </message>
    <message>
      <source>Fragments to merge must be of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birleştirilecek kırık parçalar aynı yüzden olmalı.</translation>
    </message>
    <message>
      <source>A split needs one fragment and a line of at least 1 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bölme için bir kırık parça ve en az 1 mm&apos;lik bir çizgi gerekir.</translation>
    </message>
    <message>
      <source>Nothing is selected to withdraw.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri alınacak bir şey verilmedi.</translation>
    </message>
    <message>
      <source>A newer version of Ostraka wrote these decisions; use that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kararları daha yeni bir program yazmış; onu kullanın.</translation>
    </message>
    <message>
      <source>Decision %1 cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. karar kullanılamıyor.</translation>
    </message>
    <message>
      <source>Its id is missing or used twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kimliği eksik ya da iki kez kullanılmış.</translation>
    </message>
    <message>
      <source>It replaces more than %1 decisions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 karardan fazlasının yerine geçiyor.</translation>
    </message>
    <message>
      <source>It replaces a decision twice, or one that does not come before it in the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kararın iki kez ya da dosyada kendisinden önce gelmeyen bir kararın yerine geçiyor.</translation>
    </message>
    <message>
      <source>A batch can have at most %1 decisions; move this file elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir partinin en çok %1 kararı olabilir; bu dosyayı başka yere taşıyın ya da bir kopyasını geri koyun.</translation>
    </message>
    <message>
      <source>Correct it, or restore a copy of the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzeltin ya da dosyanın bir kopyasını geri koyun.</translation>
    </message>
    <message>
      <source>Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bunlar bu programın kararları değil; dosyayı kaldırın ya da bir kopyasını geri koyun.</translation>
    </message>
    <message>
      <source>This decision is no longer in effect.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu karar artık geçerli değil.</translation>
    </message>
    <message>
      <source>There is no photograph of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yüzün fotoğrafı yok.</translation>
    </message>
    <message>
      <source>The outlines of these two sides cannot be overlaid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu iki yüzün dış çizgileri üst üste konamıyor.</translation>
    </message>
    <message>
      <source>%1 may be two sherds that touch, %2 and %3 of the other side: split it in the review, or move them apart and reshoot its side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, birbirine değen iki parça olabilir: öteki yüzün %2 ve %3 parçaları; onu gözden geçirmede bölün ya da ayırıp yüzünü yeniden çekin.</translation>
    </message>
    <message>
      <source>Not a list of mask strokes; restore an earlier one, or delete it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, maskelerdeki fırça izlerinin listesi değil; eskisini geri koyun ya da kaldırın.</translation>
    </message>
    <message>
      <source>A mask holds at most 1,000 strokes and 100,000 points; nothing is saved until you undo some.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir maske en çok 1.000 vuruş ve 100.000 nokta alır; bazılarını geri alana kadar hiçbir şey kaydedilmez.</translation>
    </message>
    <message>
      <source>This batch has no masks yet; process it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin henüz maskesi yok; önce işleyin.</translation>
    </message>
    <message>
      <source>This file does not state how well the rig fits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya düzeneğin ne kadar uyduğunu söylemiyor.</translation>
    </message>
    <message>
      <source>This calibration is for other cameras than those of the batch; calibrate the rig from its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu kalibrasyon, partinin kameralarından başka kameralar için; düzeneği kendi fotoğraflarıyla kalibre edin.</translation>
    </message>
    <message>
      <source>Masks cannot be made without plate.json; put masks next to the photographs, or choose a network (--masks MODEL.onnx).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>plate.json olmadan maskeler bulunamıyor; fotoğrafların yanına maske koyun ya da bir ağ verin (--masks MODEL.onnx).</translation>
    </message>
    <message>
      <source>The result has no scale: without plate.json no length is known, and lengths in mm are based on a guessed pixel size; photograph on a marker plate, lay the board of board.json beside the sherds on both sides, or mark a known length on both in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sonucun ölçeği yok: plate.json olmadan hiçbir uzunluk bilinmez, mm olarak verilenler de bir pikselin tahmin edilen boyutuna dayanır; işaretli bir tabla üzerinde fotoğraflayın, board.json dosyasındaki kalibrasyon levhasını iki yüzde de parçaların yanına koyun ya da ikisinde de scale.json içinde bilinen bir uzunluk işaretleyin.</translation>
    </message>
    <message>
      <source>The output folder contains files that Ostraka did not write; choose another or an empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çıktı klasöründe bu programdan olmayan bir şey var; başka ya da boş birini seçin.</translation>
    </message>
    <message>
      <source>The file has changed since the batch&apos;s processing began; nothing made from it is kept. Process the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Partinin işlenmesi başladığından beri dosya değişti; ondan yapılan hiçbir şey saklanmıyor. Partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. Measure one; then correct the file, or leave the option out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosyada işaretlerin kenarları %1 mm, ama --marker-mm %2 mm diyor. Birini ölçün; sonra dosyayı düzeltin ya da seçeneği kullanmayın.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğraf %1 ile aynı; atlanıyor.</translation>
    </message>
    <message>
      <source>These results were made from the photographs of %1, not of %2; process %3 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sonuçlar %1 partisinin fotoğraflarından yapılmış, %2 partisininkilerden değil; %3 partisinin kendisini işleyin.</translation>
    </message>
    <message>
      <source>These results were not made from the photographs of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sonuçlar %1 partisinin fotoğraflarından yapılmamış; onu yeniden işleyin.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2 and %3 more. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin kayıtlı fotoğrafları klasöründe eksik (%1): %2 ve %3 fotoğraf daha. Onları yerine koyun ve partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin kayıtlı fotoğrafları klasöründe eksik (%1): %2. Onları yerine koyun ve partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>The output folder contains another batch; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çıktı klasöründe başka bir parti var; başka klasör seçin.</translation>
    </message>
    <message>
      <source>The output folder contains other files; choose a new or empty folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çıktı klasöründe başka bir şey var; yeni ya da boş bir klasör verin.</translation>
    </message>
    <message>
      <source>A pair refers to a scan that does not exist; delete this file and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir eş, var olmayan bir taramayı anıyor; bu dosyayı silin ve partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>Not a pair table; delete it and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir eş tablosu değil; silin ve partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>%1 and %2 were paired by hand, but their relative pose is unknown; align the back by hand in the review: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2 elle eşlendi, ama birbirlerine göre duruşları bilinmiyor; arka yüzü gözden geçirmede elle hizalayın: %3</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; it is left out, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: fotoğraf bulanık: kenarları %2 piksel geniş, kameranın en keskin fotoğrafında %3; atlanıyor, yeniden çekin.</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: fotoğraf bulanık: kenarları %2 piksel geniş, kameranın en keskin fotoğrafında %3; yeniden çekin.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the front side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın %2 işaretinden %1 tanesi ön yüzün hiçbir fotoğrafında yok (%3); kameralar ötekilere dayanıyor, onları örteni kaldırın.</translation>
    </message>
    <message>
      <source>All photographs of the back side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün bütün fotoğrafları bulanık: en netinde bile işaretlerin kenarları %1 piksel genişliğinde, bu yüzden taramaları kaba. Odağa ve enstantaneye bakın ve bu yüzü yeniden çekin.</translation>
    </message>
    <message>
      <source>All photographs of the front side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün bütün fotoğrafları bulanık: en netinde bile işaretlerin kenarları %1 piksel genişliğinde, bu yüzden taramaları kaba. Odağa ve enstantaneye bakın ve bu yüzü yeniden çekin.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the back side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın %2 işaretinden %1 tanesi arka yüzün hiçbir fotoğrafında yok (%3); kameralar ötekilere dayanıyor, onları örteni kaldırın.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 merges fragments that no longer exist; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 tarafından %1 tarihinde verilen karar, artık olmayan kırık parçaları birleştiriyor; yeniden karar verin.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 splits a fragment that does not exist, or misses it; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 tarafından %1 tarihinde verilen karar, olmayan bir kırık parçayı bölüyor ya da ıskalıyor; yeniden karar verin.</translation>
    </message>
    <message>
      <source>The program %1 is not installed, but the selected stereo needs it; install it, or use the built-in stereo.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 programı kurulu değil, seçilen stereo ise onu istiyor; kurun ya da yerleşik stereoyu kullanın.</translation>
    </message>
    <message>
      <source>The photographs show no marker plate, so finding the cameras needs the program %1, which is not installed; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflarda işaretli bir tabla yok, bu yüzden kameraları %1 programı bulmalı, o da kurulu değil; kurun.</translation>
    </message>
    <message>
      <source>This needs about %1 GB of memory, but only %2 GB are free: the computer may stop the program or become very slow.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yaklaşık %1 GB bellek ister, yalnız %2 GB boş: bilgisayar onu durdurabilir ya da çok yavaşlayabilir.</translation>
    </message>
    <message>
      <source>Close other programs, or process a draft.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka programları kapatın ya da bir taslak işleyin.</translation>
    </message>
    <message>
      <source>%1: the camera was not in the place that it had while the plate turned; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: tabla dönerken kameranın durduğu yerden çekilmemiş; kullanılmadı.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ön yüzde yaklaşık %2 mm itilmiş: %3. konumdan (pos%4) sonra başka yerde duruyor; bu yüzü yeniden çekin.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ön yüzde yaklaşık %2 mm itilmiş: %3 fotoğrafından sonra başka yerde duruyor; bu yüzü yeniden çekin.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, arka yüzde yaklaşık %2 mm itilmiş: %3. konumdan (pos%4) sonra başka yerde duruyor; bu yüzü yeniden çekin.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, arka yüzde yaklaşık %2 mm itilmiş: %3 fotoğrafından sonra başka yerde duruyor; bu yüzü yeniden çekin.</translation>
    </message>
    <message>
      <source>The output folder is inside the batch folder, to which Ostraka never writes; choose one next to it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çıktı klasörü, içine hiçbir şey yazılmayan parti klasörünün içinde; onun yanında birini seçin.</translation>
    </message>
    <message>
      <source>Processing needs at least %1 GB of memory.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşleme için en az %1 GB bellek gerekir.</translation>
    </message>
    <message>
      <source>Photographs cannot be reduced to less than 0.3 megapixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflar 0,3 megapikselden aza küçültülemez.</translation>
    </message>
    <message>
      <source>There is no such segmentation network; masks are 'auto', 'given' or an ONNX file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Böyle bir bölütleme ağı yok; maskeler 'auto', 'given' ya da bir ONNX dosyasıdır.</translation>
    </message>
    <message>
      <source>The fronts are not in mm: lengths in the result, although labelled mm, are in the fronts&apos; own unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzler mm cinsinden değil: sonucun mm diye anılan uzunlukları ön yüzlerin kendi birimindedir.</translation>
    </message>
    <message>
      <source>The pairs of this batch are not processed yet; process the batch: complete results are kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin eşleri henüz işlenmedi; partiyi işleyin: tamamlanmış olan korunur.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too small; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek doğru değil: %1, bu yüzden bütün ölçüler %2 % fazla küçük olurdu; tabladaki cetveli ölçün ve plate.json dosyasına gerçek boyutunu 'ostraka plate --ruler-measured' ile verin ya da tablayı 100 % olarak yeniden basın; tabla doğruysa uzunluğu ölçün ve işaretlerini yeniden koyun.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too large; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek doğru değil: %1, bu yüzden bütün ölçüler %2 % fazla büyük olurdu; tabladaki cetveli ölçün ve plate.json dosyasına gerçek boyutunu 'ostraka plate --ruler-measured' ile verin ya da tablayı 100 % olarak yeniden basın; tabla doğruysa uzunluğu ölçün ve işaretlerini yeniden koyun.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the front side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ön yüzde işaretlenen %1 mm uzunluk fotoğraflarda %2 ± %3 mm geliyor (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the front side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>scale.json içindeki %1 mm uzunluk karşılaştırılamadı: her ucunu ön yüzün değişik yönlerden çekilmiş en az iki fotoğrafında işaretleyin.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the back side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>arka yüzde işaretlenen %1 mm uzunluk fotoğraflarda %2 ± %3 mm geliyor (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the back side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>scale.json içindeki %1 mm uzunluk karşılaştırılamadı: her ucunu arka yüzün değişik yönlerden çekilmiş en az iki fotoğrafında işaretleyin.</translation>
    </message>
    <message>
      <source>The folder cannot be read; choose a folder of PLY files.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasör okunamıyor; PLY dosyaları olan bir klasör verin.</translation>
    </message>
    <message>
      <source>This folder contains no PLY files; each sherd&apos;s scan must be one PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde PLY dosyası yok; her parçanın taraması bir PLY dosyası olmalı.</translation>
    </message>
    <message>
      <source>%1: 1 point without finite coordinates was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: sonlu koordinatı olmayan 1 nokta atlandı; dışa aktarmayı denetleyin.</translation>
    </message>
    <message>
      <source>%1: %2 points without finite coordinates were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: sonlu koordinatı olmayan %2 nokta atlandı; dışa aktarmayı denetleyin.</translation>
    </message>
    <message>
      <source>%1: 1 point far from all others, or at 0, 0, 0, was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: ötekilerin hepsinden uzakta ya da 0, 0, 0 yerinde olan 1 nokta atlandı; dışa aktarmayı denetleyin.</translation>
    </message>
    <message>
      <source>%1: %2 points far from all others, or at 0, 0, 0, were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: ötekilerin hepsinden uzakta ya da 0, 0, 0 yerinde olan %2 nokta atlandı; dışa aktarmayı denetleyin.</translation>
    </message>
    <message>
      <source>The scan has fewer than 100 points; rescan this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramada 100’den az nokta var; bu yüzü yeniden tarayın.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with nx, ny and nz.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramanın normalleri yok; nx, ny ve nz ile dışa aktarın.</translation>
    </message>
    <message>
      <source>The scan is %1 times its length away from the origin, so its coordinates are rounded; move it to the origin and export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tarama 0, 0, 0 noktasından boyunun %1 katı uzakta, bu yüzden koordinatları yuvarlanıyor; oraya taşıyın ve yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>None of the scans can be used: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramaların hiçbiri kullanılamıyor: %1</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; their unit seems to be %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu taramaların ortanca boyu %1 mm; birim %2 gibi görünüyor: %3.</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; no sherds are of that size: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu taramaların ortanca boyu %1 mm; bu boyda parça olmaz: %2.</translation>
    </message>
    <message>
      <source>The median length of the fronts is %1 mm, of the backs %2 mm, so their units differ: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzlerin ortanca boyu %1 mm, arka yüzlerinki %2 mm, demek ki birimleri farklı: %3.</translation>
    </message>
    <message>
      <source>centimetres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>santimetre</translation>
    </message>
    <message>
      <source>metres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>metre</translation>
    </message>
    <message>
      <source>micrometres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>mikrometre</translation>
    </message>
    <message>
      <source>export them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>onları mm olarak dışa aktarın</translation>
    </message>
    <message>
      <source>export them in mm, or use --scale free</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>onları mm olarak dışa aktarın ya da --scale free kullanın</translation>
    </message>
    <message>
      <source>Sherd %1 has no model: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numaralı parçanın modeli yok: %2</translation>
    </message>
    <message>
      <source>Sherd %1: %2 % of its surface is unseen by any camera and filled in, orange in its picture; reshoot it if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça %1: yüzeyinin %2 % kadarını hiçbir kamera görmedi; bu kısım dolduruldu, resimde turuncu. Önemliyse yeniden çekin.</translation>
    </message>
    <message>
      <source>Sherd %1: its model has a hole right through it (%2 mm²). If the sherd has none, the photographs do not show that area; reshoot the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça %1: modelinde bir yandan öbür yana geçen bir delik var (%2 mm²). Parçada delik yoksa fotoğraflar o yeri göstermiyor; yeniden çekin.</translation>
    </message>
    <message>
      <source>The file lists %1, which is not in the batch; delete the file to find the cameras again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Partide olmayan %1 dosyasını anıyor; bu dosyayı silin, kameralar yeniden bulunur.</translation>
    </message>
    <message>
      <source>This photograph has no mask; provide one for each photograph to be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğrafın maskesi yok; kullanılacak her biri için bir maske verin.</translation>
    </message>
    <message>
      <source>This photograph is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğraf kullanılmaz.</translation>
    </message>
    <message>
      <source>Photographs of the front side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP’ın konumunu bulamadığı için dışarıda bırakılan ön yüz fotoğrafları: %1.</translation>
    </message>
    <message>
      <source>Photographs of the back side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP’ın konumunu bulamadığı için dışarıda bırakılan arka yüz fotoğrafları: %1.</translation>
    </message>
    <message>
      <source>The rig was not used: without plate.json the poses come from COLMAP.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek kullanılmadı: plate.json olmadan duruşlar COLMAP’ten gelir.</translation>
    </message>
    <message>
      <source>%1: The mask marks no sherd in this photograph; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: maske bu fotoğrafta hiç parça işaretlemiyor; atlanıyor.</translation>
    </message>
    <message>
      <source>If it shows sherds, retake it or edit its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Üzerinde parça varsa yeniden çekin ya da maskesini düzenleyin.</translation>
    </message>
    <message>
      <source>Photographs of the front side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün, maskelerinde parça bulunan fotoğrafları: %1; en az 3 gerekli.</translation>
    </message>
    <message>
      <source>Photographs of the back side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün, maskelerinde parça bulunan fotoğrafları: %1; en az 3 gerekli.</translation>
    </message>
    <message>
      <source>Check the masks, and whether sherds were on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maskelere ve tablada parça olup olmadığına bakın.</translation>
    </message>
    <message>
      <source>Fewer than 10 fracture points match; start from a better pose.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıkların 10’dan az noktası eşleşiyor; daha iyi bir duruştan başlayın.</translation>
    </message>
    <message>
      <source>No photograph shows the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir fotoğraf parçayı göstermiyor.</translation>
    </message>
    <message>
      <source>Not every vertex has a place in the texture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Her köşenin dokuda bir yeri yok.</translation>
    </message>
    <message>
      <source>The texture of this GLB model cannot be read, so the model is used without it; reprocess its batch to write the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu GLB modelinin dokusu okunamıyor, bu nedenle model dokusuz kullanılıyor; dosyanın yeniden yazılması için partisini yeniden işleyin.</translation>
    </message>
    <message>
      <source>The texture of this model has more than 67,108,864 pixels, so the model is used without it; export the model with a smaller one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu modelin dokusu 67.108.864 pikselden fazla, bu nedenle model dokusuz kullanılıyor; modeli daha küçük bir dokuyla dışa aktarın.</translation>
    </message>
    <message>
      <source>The texture of sherd %1 lacks a photograph: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numaralı parçanın dokusunda bir fotoğraf eksik: %2</translation>
    </message>
    <message>
      <source>Sherd %1 has no photographic texture: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numaralı parçanın fotoğraf dokusu yok: %2</translation>
    </message>
    <message>
      <source>The colour chart is overexposed or underexposed (clipped patches: %1), so it is not used and colours stay as photographed; reshoot it at another exposure.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renk kartı fazla veya az pozlanmış (kırpılmış kareler: %1); kullanılmıyor ve renkler fotoğraftaki gibi kalıyor; başka bir pozlamayla yeniden çekin.</translation>
    </message>
    <message>
      <source>The colour chart is shaded, bent or partly hidden, so it is not used and colours stay as photographed; reshoot it flat, whole and evenly lit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renk kartı gölgede, bükülmüş veya kısmen örtülü; kullanılmıyor ve renkler fotoğraftaki gibi kalıyor; düz, bütün ve eşit aydınlatılmış olarak yeniden çekin.</translation>
    </message>
    <message>
      <source>colours: corrected by the colour chart in %1 photographs; its patches differ from their reference by %2 (median) and %3 (95 %), CIEDE2000</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>renkler: %1 fotoğraftaki renk kartına göre düzeltildi; kartın kareleri referanslarından %2 (medyan) ve %3 (% 95) farklı, CIEDE2000</translation>
    </message>
    <message>
      <source>The chosen registration method did not converge; use the default method, or align the back by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seçilen birleştirme yöntemi yakınsamadı; varsayılan yöntemi kullanın veya arka yüzü elle hizalayın.</translation>
    </message>
    <message>
      <source>Too few fracture points for the chosen registration method; use the default method.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Seçilen birleştirme yöntemi için çok az kırık noktası var; varsayılan yöntemi kullanın.</translation>
    </message>
    <message>
      <source>No start pose was given for the registration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yüzleri birleştirmek için başlangıç konumu verilmedi.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramanın normalleri yok; normalleriyle dışa aktarın.</translation>
    </message>
    <message>
      <source>Fewer than 50 points are on the fracture; rescan the sherd including its fracture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kırıkta 50’den az nokta var; parçayı kırığıyla birlikte yeniden tarayın.</translation>
    </message>
    <message>
      <source>%1: The board was not detected; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: kalibrasyon levhası görünmüyor; bu resim atlanıyor.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sözlüğünde kalibrasyon levhası için çok az işaret var.</translation>
    </message>
    <message>
      <source>A grid of markers needs 'dictionary', 'markers_x', 'markers_y', 'marker_length' and 'marker_separation'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir işaret ızgarası 'dictionary', 'markers_x', 'markers_y', 'marker_length' ve 'marker_separation' ister.</translation>
    </message>
    <message>
      <source>Nothing to calibrate from: put photographs of the plate at each position into &apos;front&apos; (cam0_pos00.jpg and so on) and pictures of the board into &apos;calib&apos;, and copy plate.json and board.json next to them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kalibre etmek için bir şey yok: tablayı her konumda 'front' içine (cam0_pos00.jpg ve böyle sürer), kalibrasyon levhasını 'calib' içine fotoğraflayın ve yanlarına plate.json ile board.json dosyalarını kopyalayın.</translation>
    </message>
    <message>
      <source>No pictures of the board found; put them here or into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kalibrasyon levhasının resmi yok; buraya ya da 'calib' içine koyun.</translation>
    </message>
    <message>
      <source>It is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenara ayrılır.</translation>
    </message>
    <message>
      <source>%1: its size differs from that of the first picture; it is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: boyutu ilkininki gibi değil; kenara ayrılır.</translation>
    </message>
    <message>
      <source>The bundle adjustment of the rig did not converge; check that plate.json and board.json describe what was photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzeneğin hesabı bir çözüme varmadı; plate.json ve board.json dosyalarının fotoğraflananı anlattığını denetleyin.</translation>
    </message>
    <message>
      <source>The file does not describe how the sheets bend; delete it to measure them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfaların nasıl eğildiğini söylemiyor; dosyayı silin, yeniden ölçülür.</translation>
    </message>
    <message>
      <source>The file does not describe what the sherds stand on; delete it to determine this again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların neyin üzerinde durduğunu söylemiyor; silin, yeniden bulunur.</translation>
    </message>
    <message>
      <source>The sheet's markers can be read in %1 of %2 photographs of the %3 side; at least 3 are needed. Check that plate.json describes this sheet, that the photographs are not mirrored, and that most of the markers are in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfanın işaretleri %3 tarafının %2 fotoğrafından %1 tanesinde okunabiliyor; en az 3 gerekir. plate.json dosyasının bu sayfayı tanımladığını, fotoğrafların ters çevrilmediğini ve işaretlerin çoğunun resimde olduğunu denetleyin.</translation>
    </message>
    <message>
      <source>%1: %2 of the sheet&apos;s markers can be read, too few for a pose; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: sayfanın %2 işareti okunabiliyor, konum için çok az; dışarıda bırakıldı.</translation>
    </message>
    <message>
      <source>Photographs that show too few of the sheet&apos;s markers for a pose are left out (%1 and %2 more); check that they show this sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Konum için sayfanın çok az işaretini gösteren fotoğraflar dışarıda bırakılıyor (%1 ve %2 tane daha); bu sayfayı gösterip göstermediklerine bakın.</translation>
    </message>
    <message>
      <source>%1: most of the sheet&apos;s markers are not where the other photographs place them; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: sayfanın işaretlerinin çoğu bu fotoğrafta ötekilerin gösterdiğinden başka yerde; fotoğraf dışarıda bırakılıyor.</translation>
    </message>
    <message>
      <source>Only one side was photographed: its %1 scans are open surfaces without a back; they are in 'unpaired'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnızca bir taraf fotoğraflandı: %1 taraması arkası olmayan açık yüzeylerdir; 'unpaired' içindedir.</translation>
    </message>
    <message>
      <source>plate.json is missing, so the plate&apos;s markers cannot be used; copy the file that &apos;ostraka plate&apos; wrote with the plate into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>plate.json yok, bu yüzden tablanın işaretleri kullanılamıyor; 'ostraka plate' komutunun tablayla birlikte yazdığını buraya kopyalayın.</translation>
    </message>
    <message>
      <source>The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig is calibrated from this batch instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilinen düzenekte %2 x %3 piksellik resimler veren kamera %1 yok; düzenek onun yerine bu partiden kalibre edilir.</translation>
    </message>
    <message>
      <source>Its lens is estimated from the plate's markers instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Objektifi bunun yerine tablanın işaretlerinden kestirilir.</translation>
    </message>
    <message>
      <source>The lens of camera %1 is unknown: no usable pictures of the board and no plate markers were found; add pictures of the board to &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 objektifi bilinmiyor: ne kullanılabilir kalibrasyon levhası resmi ne de tablanın işaretleri var; 'calib' içine kalibrasyon levhasının resimlerini ekleyin.</translation>
    </message>
    <message>
      <source>The lens of camera %1 was estimated from the plate&apos;s markers alone; add 12 pictures of the board to &apos;calib&apos; for accurate measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 objektifi yalnız tablanın işaretlerinden kestirildi; kesin ölçüler için 'calib' içine kalibrasyon levhasının 12 resmini ekleyin.</translation>
    </message>
    <message>
      <source>The plate's markers were found in %1 of %2 photographs, too few for a pose of each side; check that plate.json belongs to this plate and that the markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın işaretleri %2 fotoğraftan %1 tanesinde bulundu, her iki yüzün duruşu için çok az; plate.json dosyasının bu tablanın olduğunu, işaretlerin aydınlık ve resmin içinde olduğunu denetleyin.</translation>
    </message>
    <message>
      <source>No photograph of camera %1 shows two markers of the plate; all its photographs are left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 fotoğraflarının hiçbirinde tablanın iki işareti görünmüyor; bütün fotoğrafları atlanıyor.</translation>
    </message>
    <message>
      <source>The known rig no longer fits: camera %1 misses the markers by %2 px. The camera poses are re-estimated for this batch; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilinen düzenek artık uymuyor: kamera %1 işaretleri %2 px kaçırıyor. Kameraların duruşları bu parti için yeniden kestirilir; düzeneği yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>%1: none of its %2 markers is where this camera sees them at this position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 işaretinden hiçbiri bu kameranın bu konumda gördüğü yerde değil.</translation>
    </message>
    <message>
      <source>It has another photograph&apos;s name or was taken while the plate was turning; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir fotoğrafın adını taşıyor ya da tabla dönerken çekilmiş; atlanıyor.</translation>
    </message>
    <message>
      <source>%1: no marker is visible; check that the photograph shows this position. If not, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: hiç işaret görünmüyor; fotoğrafın bu konumu gösterdiğine bakın. Göstermiyorsa yeniden çekin.</translation>
    </message>
    <message>
      <source>Photographs of the front side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün konumu bilinen fotoğrafları: %1; en az 3 gerekli. Tablanın işaretlerinin aydınlık ve görüntü içinde olduğunu denetleyin.</translation>
    </message>
    <message>
      <source>Photographs of the back side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün konumu bilinen fotoğrafları: %1; en az 3 gerekli. Tablanın işaretlerinin aydınlık ve görüntü içinde olduğunu denetleyin.</translation>
    </message>
    <message>
      <source>Camera %1 sees fewer than six of the plate&apos;s markers at position %2; check lighting and focus there and that nothing covers the markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, %2 konumunda tablanın altıdan az işaretini görüyor; oradaki ışığa ve odağa, işaretlerin üstünde bir şey olmadığına bakın.</translation>
    </message>
    <message>
      <source>Positions photographed: %1; photograph at least four around the full turn to determine the axis.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflanan konumlar: %1; ekseni belirlemek için tam tur boyunca en az dördünü çekin.</translation>
    </message>
    <message>
      <source>Fewer than eight markers were detected, so no distance could be held out of the fit: the scale is not checked.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sekizden az işaret görüldü, bu yüzden denetim için hiçbir uzaklık ayrılamadı: ölçek denetlenmedi.</translation>
    </message>
    <message>
      <source>Markers %1 and %2: you measured %3 mm, plate.json says %4 mm (%5 %); measure the plate&apos;s ruler and regenerate plate.json with &apos;ostraka plate --ruler-measured&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2 işaretleri arasında %3 mm ölçtünüz, plate.json dosyasına göre %4 mm (%5 %); tablanın cetvelini ölçün ve plate.json dosyasını 'ostraka plate --ruler-measured' ile yeniden yapın.</translation>
    </message>
    <message>
      <source>Not usable: camera %1 misses the plate&apos;s markers by a median of %2 px; check that it did not move between the photographs and that plate.json belongs to this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kullanılamaz: kamera %1 tablanın işaretlerini ortanca %2 px kaçırıyor; fotoğraflar arasında ona dokunuldu mu, yoksa plate.json başka bir tablanın mı?</translation>
    </message>
    <message>
      <source>Not usable: the scale is wrong.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kullanılamaz: ölçek doğru değil.</translation>
    </message>
    <message>
      <source>Good: lenses, camera poses and scale are determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İyi: objektifler, kamera duruşları ve ölçek belirlendi.</translation>
    </message>
    <message>
      <source>Usable for a trial only: the lens of camera %1 comes from the plate&apos;s markers alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnız deneme için kullanılabilir: kamera %1 objektifi yalnız tablanın işaretlerinden geliyor.</translation>
    </message>
    <message>
      <source>Usable, but a focal length is uncertain by more than a thousandth.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kullanılabilir, ama bir odak uzaklığı binde birden daha iyi bilinmiyor.</translation>
    </message>
    <message>
      <source>Usable; the steps below improve it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kullanılabilir; aşağıda anılanlar onu iyileştirir.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: odak uzaklığı %2 px (%3 %).</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: odak uzaklığı %2 px (%3 %), kalibrasyon levhasının %4 resmi %5 px ile, en kötüsü %6 %7 px ile, en çok %8 derece eğik.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), median error at the plate&apos;s markers %4 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: odak uzaklığı %2 px (%3 %), tablanın işaretleri ortanca %4 px.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees, median error at the plate&apos;s markers %9 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: odak uzaklığı %2 px (%3 %), kalibrasyon levhasının %4 resmi %5 px ile, en kötüsü %6 %7 px ile, en çok %8 derece eğik, tablanın işaretleri ortanca %9 px.</translation>
    </message>
    <message>
      <source>Camera %1: take 12 pictures of the board, near and far, in all corners of the picture, tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: kalibrasyon levhasının 12 resmini çekin; yakından ve uzaktan, resmin bütün köşelerinde, değişik yönlere 20 ile 45 derece eğik.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: kalibrasyon levhası yalnız 1 resimde görünüyor; en az 8, daha iyisi 12 resim çekin.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: kalibrasyon levhası yalnız %2 resimde görünüyor; en az 8, daha iyisi 12 resim çekin.</translation>
    </message>
    <message>
      <source>Camera %1: the board barely reaches the %2 of the picture; add pictures with the board there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: kalibrasyon levhası resmin şu bölgelerine pek ulaşmıyor: %2; kalibrasyon levhasının orada olduğu resimler ekleyin.</translation>
    </message>
    <message>
      <source>upper left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sol üst</translation>
    </message>
    <message>
      <source>upper middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>orta üst</translation>
    </message>
    <message>
      <source>upper right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sağ üst</translation>
    </message>
    <message>
      <source>left middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sol orta</translation>
    </message>
    <message>
      <source>middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>orta</translation>
    </message>
    <message>
      <source>right middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sağ orta</translation>
    </message>
    <message>
      <source>lower left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sol alt</translation>
    </message>
    <message>
      <source>lower middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>orta alt</translation>
    </message>
    <message>
      <source>lower right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>sağ alt</translation>
    </message>
    <message>
      <source>Camera %1: no picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: hiçbir resimde kalibrasyon levhası 20 dereceden fazla eğik değil; değişik yanlara eğik en az dört resim çekin.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: kalibrasyon levhası yalnız 1 resimde 20 dereceden fazla eğik; değişik yanlara eğik en az dört resim çekin.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: kalibrasyon levhası yalnız %2 resimde 20 dereceden fazla eğik; değişik yanlara eğik en az dört resim çekin.</translation>
    </message>
    <message>
      <source>Reprojection error %1 px over the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın işaretlerinde geri izdüşüm hatası %1 px.</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: denetim için ayrılan %1 ve %2 işaretlerinin arası %3 mm, olması gereken %4 (%5 mm, %6 %).</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, measured by hand as %3 mm between the midpoints of their outer edges, are %4 mm apart in the photographs (%5 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: %1 ve %2 işaretlerinin dış kenarlarının ortaları arası elle %3 mm, fotoğraflarda %4 mm (%5 %).</translation>
    </message>
    <message>
      <source>Set aside: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kenara ayrıldı: %1</translation>
    </message>
    <message>
      <source>The lens is known but the camera poses are not, so no rig can be saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Objektif biliniyor, kameraların yerleri bilinmiyor: düzenek kaydedilemez.</translation>
    </message>
    <message>
      <source>Not usable: the focal length is not determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kullanılamaz: odak uzaklığı belirlenmedi.</translation>
    </message>
    <message>
      <source>Photograph the plate with its markers too: put one picture per camera and position into &apos;front&apos; (cam0_pos00.jpg and so on) next to plate.json, and the board&apos;s pictures into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablayı işaretleriyle de fotoğraflayın: her kamera ve konum için bir resmi plate.json yanındaki 'front' içine (cam0_pos00.jpg ve böyle sürer), kalibrasyon levhasının resimlerini 'calib' içine koyun.</translation>
    </message>
    <message>
      <source>Marker %1 of the known length is visible in fewer than two photographs; choose two markers of the plate that the photographs show.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilinen uzunluğun %1 işareti iki kez görünmüyor; tablanın fotoğraflarda görünen iki işaretini verin.</translation>
    </message>
    <message>
      <source>A known length needs two different markers and a value greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilinen bir uzunluk iki ayrı işaret ve sıfırdan büyük milimetre ister.</translation>
    </message>
    <message>
      <source>Folder not found; choose one with photographs of the plate or of the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Böyle bir klasör yok; tablanın ya da kalibrasyon levhasının fotoğrafları olan birini verin.</translation>
    </message>
    <message>
      <source>The lens %1 is not known; it is 'standard' or 'fisheye'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 objektifi bilinmiyor; 'standard' ya da 'fisheye' olur.</translation>
    </message>
    <message>
      <source>Numbers in 'dist': %1; a lens has 0, 4, 5, 8 or 12 in OpenCV's order, a fisheye has 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'dist' içindeki sayılar: %1; bir objektifte OpenCV sırasıyla 0, 4, 5, 8 ya da 12, balıkgözünde 4 sayı olur.</translation>
    </message>
    <message>
      <source>No lens has the numbers in 'dist': its picture folds near the middle. Check their order.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir objektifte 'dist' içindeki sayılar olmaz: görüntüsü ortaya yakın katlanıyor. Sıralarını kontrol edin.</translation>
    </message>
    <message>
      <source>The camera of '%1' has no valid K, R, t or size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' kamerasının K, R, t değeri ya da boyutu geçersiz.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir resimde file, width, height, K, R ya da t eksik.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir resimde file, width, height, K, R ya da t eksik (%1).</translation>
    </message>
    <message>
      <source>The camera file has no list &apos;images&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera dosyasında 'images' listesi yok.</translation>
    </message>
    <message>
      <source>COLMAP&apos;s camera %1 has the model &apos;%2&apos; or values that Ostraka does not support; use the model OPENCV instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP kamerası %1, '%2' modelini ya da burada kullanılamayan değerler taşıyor; yerine OPENCV kullanın.</translation>
    </message>
    <message>
      <source>COLMAP's model has no camera for the image '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP modelinde '%1' resmi için kamera yok.</translation>
    </message>
    <message>
      <source>The file is damaged or not in COLMAP&apos;s format; run COLMAP again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya bozuk ya da COLMAP’in yazdığı gibi değil; COLMAP’i yeniden çalıştırın.</translation>
    </message>
    <message>
      <source>The pose of this photograph is estimated without its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğrafın duruşu maskesi olmadan bulunur.</translation>
    </message>
    <message>
      <source>Without plate.json, poses come from COLMAP, which is not installed; install the package &apos;colmap&apos; or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>plate.json olmadan duruşlar COLMAP’ten gelir, o da kurulu değil; 'colmap' paketini kurun ya da işaretli bir tabla üzerinde fotoğraflayın.</translation>
    </message>
    <message>
      <source>COLMAP found poses for %1 of %2 photographs, too few; provide masks or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP, %2 fotoğraftan %1 tanesinin duruşunu buldu, çok az; maske verin ya da işaretli bir tabla üzerinde fotoğraflayın.</translation>
    </message>
    <message>
      <source>The scale is wrong: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %); check that plate.json belongs to this plate, that the plate is printed and glued without distortion, and that a known rig was calibrated with it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek doğru değil: denetim için ayrılan %1 ve %2 işaretlerinin arası %3 mm, olması gereken %4 (%5 mm, %6 %); plate.json dosyasının bu tablanın olduğunu, tablanın doğru basılıp yapıştırıldığını ve bilinen düzeneğin onunla kalibre edildiğinı denetleyin.</translation>
    </message>
    <message>
      <source>Relative to camera %1, camera %2 has moved by %3 mm and turned by %4 degrees since the rig was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 ile karşılaştırıldığında kamera %2, düzenek kalibre edildiğindan beri %3 mm kaymış ve %4 derece dönmüş.</translation>
    </message>
    <message>
      <source>%1: the board was not detected; the picture is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: içinde kalibrasyon levhası görünmüyor; kenara ayrılır.</translation>
    </message>
    <message>
      <source>The marker dictionary &apos;%1&apos; is unknown; use one such as DICT_4X4_100.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' işaret sözlüğü bilinmiyor; DICT_4X4_100 gibi birini kullanın.</translation>
    </message>
    <message>
      <source>The markers&apos; side must be between 5 and 200 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşaretlerin kenarı 5 ile 200 mm arasında olmalı.</translation>
    </message>
    <message>
      <source>The plate&apos;s diameter must be between 1 and 2000 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın çapı 1 ile 2000 mm arasında olmalı.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 mm’lik tablaya %1 mm’lik altıdan az işaret sığar; üzerine %3 mm’lik işaretler sığar.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 mm’lik tablaya %1 mm’lik altıdan az işaret sığar; tablayı büyütün.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm’lik işaretler %2 mm’lik tablada parçaya yer bırakmaz; üzerine %3 mm’lik işaretler sığar.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm’lik işaretler %2 mm’lik tablada parçaya yer bırakmaz; tablayı büyütün.</translation>
    </message>
    <message>
      <source>The printer&apos;s margin must be between 0 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yazıcının kenar payı 0 ile 40 mm arasında olmalı.</translation>
    </message>
    <message>
      <source>The sheets&apos; overlap must be between 5 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yaprakların üst üste binmesi 5 ile 40 mm arasında olmalı.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sözlüğünde bu tabla için çok az işaret var.</translation>
    </message>
    <message>
      <source>The measured ruler length must be in mm and within the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Cetvelin ölçüsü, tablaya sığan mm cinsinden bir uzunluk olmalı.</translation>
    </message>
    <message>
      <source>The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. Print the file at 100 %, without &apos;fit to page&apos;, and measure again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu tablanın cetveli %1 mm çizildi, %2 mm onda birden çok sapıyor; dosyayı 'sayfaya sığdır' olmadan 100 % basın ve yeniden ölçün.</translation>
    </message>
    <message>
      <source>Camera %1 has a covariance of the wrong size; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 kovaryansının boyutu yanlış; düzeneği yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>Another version of Ostraka wrote this rig; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu düzeneği Ostraka&apos;nın başka bir sürümü yazmış; yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>Camera %1 appears twice in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1 düzenekte iki kez geçiyor.</translation>
    </message>
    <message>
      <source>The rig has more than %1 positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzeneğin %1 konumdan fazlası var; yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>Position %1 appears twice in the rig; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 konumu düzenekte iki kez geçiyor; yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>The rig&apos;s lengths are not in mm; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzeneğin uzunlukları mm değil; yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>Camera %1 has pictures of %2 x %3 pixels, which no camera takes; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, hiçbir kameranın çekmediği %2 x %3 piksellik görüntülere sahip; düzeneği yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>Not a rig file (RIG.json); recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir düzenek dosyası (RIG.json) değil; düzeneği yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>The rig has no camera; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzeneğin kamerası yok; yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>This file already exists and is not a rig; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya zaten var ve düzenek değil; başka birini verin.</translation>
    </message>
    <message>
      <source>The log cannot be written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Günlük yazılamıyor.</translation>
    </message>
    <message>
      <source>A process cannot be started.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir işlem başlatılamıyor.</translation>
    </message>
    <message>
      <source>The program&apos;s exit status is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Program yitirildi.</translation>
    </message>
    <message>
      <source>The program cannot be started; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Program başlatılamıyor; kurun.</translation>
    </message>
    <message>
      <source>%1 ended with an error; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 bir hatayla bitti; bildirileri bu dosyada.</translation>
    </message>
    <message>
      <source>A small object of %1 mm at x %2, y %3 mm was left out; if it is a sherd, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm’lik bir kırıntı (x %2, y %3 mm) dışarıda bırakıldı; parçaysa onu tek başına çekin.</translation>
    </message>
    <message>
      <source>A flat object at x %1, y %2 mm was left out; it may be a marker or dirt on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düz bir nesne (x %1, y %2 mm) dışarıda bırakıldı; bir işaret ya da tabladaki kir olabilir.</translation>
    </message>
    <message>
      <source>Two sherds touch at x %1, y %2 mm and were split there; leave a finger&apos;s width between sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki parça birbirine değiyor (x %1, y %2 mm) ve orada ayrıldı; parçalar arasında bir parmak aralık bırakın.</translation>
    </message>
    <message>
      <source>The plate&apos;s point cloud has no normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın nokta bulutunun normalleri yok.</translation>
    </message>
    <message>
      <source>No sherd was found on the front side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzde hiç parça bulunamadı; maskelerini ve fotoğraflarını denetleyin.</translation>
    </message>
    <message>
      <source>No sherd was found on the back side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzde hiç parça bulunamadı; maskelerini ve fotoğraflarını denetleyin.</translation>
    </message>
    <message>
      <source>This COLMAP was built without CUDA, which its dense stereo needs; install one with CUDA, or use --dense builtin, which needs neither.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu colmap, yoğun stereosunun gerektirdiği CUDA olmadan derlenmiş; CUDA’lı birini kurun ya da başka bir şey istemeyen --dense builtin kullanın.</translation>
    </message>
    <message>
      <source>The masks of the views show no common object; check masks, cameras and bounds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Görünümlerin maskelerinde ortak bir nesne yok; maskeleri, kameraları ve sınırları denetleyin.</translation>
    </message>
    <message>
      <source>InterfaceCOLMAP wrote no scene; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>InterfaceCOLMAP sahne bırakmadı; bildirileri bu dosyada.</translation>
    </message>
    <message>
      <source>Stereo needs at least 3 photographs with known cameras.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Derinlik için kameraları bilinen en az 3 fotoğraf gerekir.</translation>
    </message>
    <message>
      <source>The photograph or its mask differs in size from its camera&apos;s images; use photographs of the size that the camera was calibrated with.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafın ya da maskesinin boyutu kamerasının resimlerinden farklı; kameranın kalibre edildiği boyutta fotoğraflar kullanın.</translation>
    </message>
    <message>
      <source>The photograph differs in size from the images that its camera was calibrated with; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafın boyutu, kamerasının kalibre edildiği resimlerden farklı; özgün fotoğrafı kullanın.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Maskenin boyutu fotoğrafınınkinden farklı.</translation>
    </message>
    <message>
      <source>%1 found no points of the object; its output is in this file, and --dense builtin needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 nesnenin hiç noktasını bulamadı; bildirileri bu dosyada, --dense builtin ise başka program istemez.</translation>
    </message>
    <message>
      <source>%1 wrote points without normals; install a newer version, or use --dense builtin.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 normalleri olmayan noktalar yazdı; daha yeni bir sürüm kurun ya da --dense builtin kullanın.</translation>
    </message>
    <message>
      <source>The program %1 is not on the PATH, but --dense %2 needs it; install it, or use --dense builtin, which needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 programı PATH üzerinde yok, ama --dense %2 onu istiyor; kurun ya da başka bir şey istemeyen --dense builtin kullanın.</translation>
    </message>
    <message>
      <source>No two views agree on any surface point; check cameras and masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki görünümün uyuştuğu hiçbir yüzey noktası bulunamadı; kameraları ve maskeleri denetleyin.</translation>
    </message>
    <message>
      <source>The %1 sherds do not fit on the plate; use fewer, or another seed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 parça tablaya sığmıyor; daha az parça ya da başka bir başlangıç sayısı isteyin.</translation>
    </message>
    <message>
      <source>sherds must be between 1 and 40.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça sayısı 1 ile 40 arasında olmalı.</translation>
    </message>
    <message>
      <source>width must be between 160 and 8192 pixels and divisible by 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Genişlik 160 ile 8192 piksel arasında olmalı ve 4’e bölünmeli.</translation>
    </message>
    <message>
      <source>near_duplicates are groups of two: at most half the number of sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birbirine benzeyenler ikişerli gruplardır: en çok parça sayısının yarısı kadar.</translation>
    </message>
    <message>
      <source>The rig needs a camera and at least four positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düzenek için bir kamera ve en az dört konum gerekir; yeniden kalibre edin.</translation>
    </message>
    <message>
      <source>The virtual camera has no setting %1 of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sanal kamerada %2 değerli bir %1 ayarı yok.</translation>
    </message>
    <message>
      <source>The camera has taken no photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera hiç fotoğraf çekmedi.</translation>
    </message>
    <message>
      <source>COLMAP cannot align these photographs; its output is in this file. Check that all show the same sherds with large overlap, or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP bu fotoğrafların nasıl bir araya geldiğini bulamıyor; iletileri bu dosyada. Hepsinin aynı parçaları bolca örtüşerek gösterip göstermediğine bakın ya da işaretli tablada fotoğraf çekin.</translation>
    </message>
    <message>
      <source>This model is missing; reprocess its batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu model eksik; partisini yeniden işleyin.</translation>
    </message>
    <message>
      <source>This sherd is void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parça geçersiz.</translation>
    </message>
    <message>
      <source>This sherd is void; reason: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parça geçersiz, çünkü: %1</translation>
    </message>
    <message>
      <source>%1 is void and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 geçersiz olduğu için dışarıda bırakıldı.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %); check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dudak sanılan yer pek dudağa benzemiyor (%1 %); parçanın nasıl durduğunu denetleyin.</translation>
    </message>
    <message>
      <source>Ø %1 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm</translation>
    </message>
    <message>
      <source>Ø %1 cm (95 %: %2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm (% 95: %2 ile %3 arası)</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>korunan ağız kenarı % %1</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>korunan ağız kenarı % %1 (%2 ile %3 arası)</translation>
    </message>
    <message>
      <source>wall %1 mm (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cidar %1 mm (%2 ile %3 arası)</translation>
    </message>
    <message>
      <source>wall %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>cidar %1 mm</translation>
    </message>
    <message>
      <source>A bag belongs to a context; enter the context first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir torba bir kontekstte bulunur; önce konteksti girin.</translation>
    </message>
    <message>
      <source>Context %1 has no bag %2; change or clear the bag at the same time.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 konteksti %2 torbasını içermiyor; torbayı da aynı anda değiştirin ya da boşaltın.</translation>
    </message>
    <message>
      <source>There is no bag %1 in context %2 yet; enter it during capture or import a table of contexts that contains it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 kontekstinde henüz %1 torbası yok; onu çekimde yazın ya da onu içeren bir kontekst tablosu içe aktarın.</translation>
    </message>
    <message>
      <source>The edge taken as the lip may be a fracture (%1 % that it is the lip), and the diameter may be wrong; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dudak sanılan yer bir kırık olabilir (dudak olma olasılığı %1 %) ve çap yanlış olabilir; parçanın nasıl durduğunu denetleyin.</translation>
    </message>
    <message>
      <source>This batch is still being photographed; it is processed afterwards.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti şu anda fotoğraflanıyor; sonra işlenir.</translation>
    </message>
    <message>
      <source>Joins with sherds that are not in the export or were not imported are left out: %1; enter them by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarmada bulunmayan ya da girilmeyen parçalarla birleşmeler dışarıda bırakıldı: %1; bunları elle girin.</translation>
    </message>
    <message>
      <source>'%1' can be read as %2 or as %3; write one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1', %2 ya da %3 diye okunabilir; ikisinden birini yazın.</translation>
    </message>
    <message>
      <source>The batch is not fully processed; let the queue process it, then review its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti tam işlenmedi; sıranın onu işlemesini bekleyin, sonra eşlerini gözden geçirin.</translation>
    </message>
    <message>
      <source>%1 was retaken after its mask was edited; the strokes on the earlier photograph are left out. Check its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, maskesi düzenlendikten sonra yeniden çekildi; önceki fotoğraftaki çizgiler dışarıda bırakıldı. Maskesine bakın.</translation>
    </message>
    <message>
      <source>Joins with rows that were not imported are left out: %1; correct these rows, then import the table again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Girilmeyen satırlarla birleşmeler dışarıda bırakıldı: %1; bu satırlar düzeltilince tabloyu yeniden içe aktarın.</translation>
    </message>
    <message>
      <source>The sherd has a void_reason, so it is void; write void here, or %1 under void_reason.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçanın void_reason değeri var, yani geçersiz; buraya void ya da void_reason altına %1 yazın.</translation>
    </message>
    <message>
      <source>A sherd is void only with a reason; write it under void_reason, or correct the state.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir parça ancak bir nedenle geçersizdir; nedeni void_reason altına yazın ya da durumu düzeltin.</translation>
    </message>
    <message>
      <source>The state must be draft, numbered or void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Durum draft, numbered ya da void olmalıdır.</translation>
    </message>
    <message>
      <source>Rows that are not imported leave their numbers free: %1; correct and import them before you assign new numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İçe aktarılmayan satırlar numaralarını boş bırakır: %1; yeni numara vermeden önce bunları düzeltip içe aktarın.</translation>
    </message>
    <message>
      <source>The number %1 was entered for a sherd of %2, which is not processed yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası, henüz işlenmemiş %2 içindeki bir parçaya yazıldı.</translation>
    </message>
    <message>
      <source>A sheet of an earlier drawing already exists and is not overwritten; choose another name, or delete that sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Daha önceki bir çizimin bir sayfası var ve üzerine yazılmaz; başka bir ad seçin ya da onu kaldırın.</translation>
    </message>
    <message>
      <source>Enter a number after =.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>= işaretinden sonra bir numara gelir.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir klasör, dosya değil; bir dosya belirtin.</translation>
    </message>
    <message>
      <source>This is a pipe, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir boru, dosya değil; bir dosya belirtin.</translation>
    </message>
    <message>
      <source>This is a socket, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir soket, dosya değil; bir dosya belirtin.</translation>
    </message>
    <message>
      <source>This is a device, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir aygıt, dosya değil; bir dosya belirtin.</translation>
    </message>
    <message>
      <source>A link has taken the place of this folder&apos;s lock file; delete the link.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörün kilidinin yerinde bir bağlantı duruyor; onu silin.</translation>
    </message>
    <message>
        <source>A link has taken the place of a folder of a project or of a result; what it leads to was not touched. Delete the link, or move the folder itself here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bir bağlantı, bir projenin ya da bir sonucun klasörünün yerini almış; gösterdiği yere dokunulmadı. Bağlantıyı silin ya da klasörün kendisini buraya taşıyın.</translation>
    </message>
    <message>
      <source>No temporary folder can be created here (%1); free some space, or set TMPDIR to another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Burada geçici klasör oluşturulamıyor (%1); yer açın veya TMPDIR'i başka bir klasöre ayarlayın.</translation>
    </message>
    <message>
      <source>The JSON contains &apos;%1&apos; twice in one object; delete one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON bir nesnede '%1' adını iki kez veriyor; ikisinden birini silin.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a whole number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1', %2 ile %3 arasında bir tam sayı olmalı; düzeltin.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1', %2 ile %3 arasında bir sayı olmalı; düzeltin.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' bir sayı olmalı; düzeltin.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is mirrored: its corners run counter-clockwise as seen from above; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın %1 numaralı işareti aynalanmış: köşeleri yukarıdan bakınca saat yönünün tersine dönüyor; tabla dosyasını yeniden yazdırın.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is not convex; list its corners in order along its edge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın %1 numaralı işareti dışbükey değil; köşelerini kenar boyunca sırayla belirtin.</translation>
    </message>
    <message>
      <source>The markers %1 and %2 of the plate overlap; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın %1 ve %2 numaralı işaretleri üst üste geliyor; tabla dosyasını yeniden yazdırın.</translation>
    </message>
    <message>
      <source>The board&apos;s markers must be smaller than its squares; correct &apos;marker_mm&apos; or &apos;square_mm&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kalibrasyon levhasının işaretleri karelerinden küçük olmalı; 'marker_mm' veya 'square_mm' değerini düzeltin.</translation>
    </message>
    <message>
      <source>A face of the PLY file has more than %1 corners; export the file again as triangles.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY'nin bir yüzünün %1'den fazla köşesi var; üçgenler olarak yeniden dışa aktarın.</translation>
    </message>
    <message>
      <source>The PLY file has more than %1 of '%2'; export it with fewer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY dosyasında %1'den fazla '%2' var; daha azıyla dışa aktarın.</translation>
    </message>
    <message>
      <source>A link or a file has taken the place of a folder, or a link that of a file; replace it with the folder or the file itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasör olması gereken yerde bir bağlantı ya da dosya, ya da dosya olması gereken yerde bir bağlantı var; oraya dosyaların kendisini koyun.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu adda bir dosya zaten var ve üzerine yazılmaz; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>The export names a location in the project where no such file belongs; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dışa aktarım, projede böyle bir dosyanın yeri olmayan bir konum belirtiyor; hiçbir şey girilmedi.</translation>
    </message>
    <message>
      <source>The archive contains a journal of its catalogue, which an Ostraka archive never contains; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arşiv, kataloğunun bir günlüğünü içeriyor; Ostraka&apos;nın hiçbir arşivi bunu içermez; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
      <source>The catalogue&apos;s tables, indexes or triggers differ from those that Ostraka creates; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kataloğun tabloları, dizinleri ve tetikleyicileri Ostraka&apos;nın oluşturduğu gibi değil; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
      <source>The output folder is gone: it was moved or deleted while Ostraka was writing to it. The photographs are untouched; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çıktı klasörü artık yok: program içine yazarken taşındı veya silindi. Fotoğraflara dokunulmadı; aynı komutu yeniden başlatın.</translation>
    </message>
    <message>
      <source>The folder already contains files; choose a new or empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Klasörde zaten dosyalar var; yeni veya boş bir klasör belirtin.</translation>
    </message>
    <message>
      <source>This location belongs to the archive or export &apos;%1&apos;, which new files would make invalid; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu konum, yeni dosyaların geçersiz kılacağı &apos;%1&apos; arşivine veya dışa aktarımına ait; onun dışında bir konum seçin.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu konum &apos;%1&apos; projesine ait; onun dışında bir konum seçin.</translation>
    </message>
    <message>
      <source>The name of this output must end in %1; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu çıktı dosyasının adı %1 ile bitmeli; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir klasör, dosya değil; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>This output is one of the input files, which it would overwrite; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu çıktı, girdi dosyalarından biri ve onun üzerine yazardı; başka bir ad seçin.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a folder directly in &apos;%2&apos;, or one outside the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu konum &apos;%1&apos; projesine ait; doğrudan &apos;%2&apos; içinde bir klasör ya da projenin dışında bir klasör seçin.</translation>
    </message>
    <message>
      <source>This file describes another plate, or this plate with another ruler length; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya başka bir tablayı ya da bu tablayı başka bir cetvel uzunluğuyla anlatıyor; başka bir klasör seçin.</translation>
    </message>
    <message>
      <source>This file describes another calibration board; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya başka bir kalibrasyon levhasını anlatıyor; başka bir klasör seçin.</translation>
    </message>
    <message>
      <source>This folder contains photographs, and a new plate.json would describe the sheet under their sherds; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde fotoğraflar var; yeni bir plate.json onlardaki parçaların altındaki kâğıdı anlatırdı; başka bir klasör seçin.</translation>
    </message>
    <message>
      <source>This folder is a mount point or the current folder; choose a new folder inside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör ayrı bir disk ya da içinde bulunduğunuz klasör; içinde yeni bir klasör belirtin.</translation>
    </message>
    <message>
      <source>This folder is needed for unfinished files but contains others; move it elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör tamamlanmamış dosyalar için gerekli, ama başka dosyalar içeriyor; onu başka yere taşıyın.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the front side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzde, olağan parçanın uzunluğunun % %1 kadarı olan bir parça dışarıda bırakıldı; ölçek olmadan bir çömlek parçası olabilir.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the back side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzde, olağan parçanın uzunluğunun % %1 kadarı olan bir parça dışarıda bırakıldı; ölçek olmadan bir çömlek parçası olabilir.</translation>
    </message>
    <message>
      <source>The photographs of the front side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün fotoğrafları, maskelerinin gösterdiğinin yalnızca % %1 kadarında uyuşuyor, bu yüzden taramaları yanlış olabilir. Maskelere ve çekim sırasında hiçbir şeyin kıpırdamadığına bakın.</translation>
    </message>
    <message>
      <source>The photographs of the back side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün fotoğrafları, maskelerinin gösterdiğinin yalnızca % %1 kadarında uyuşuyor, bu yüzden taramaları yanlış olabilir. Maskelere ve çekim sırasında hiçbir şeyin kıpırdamadığına bakın.</translation>
    </message>
    <message>
      <source>All photographs look at the sheet from straight above, so heights and wall thicknesses are uncertain and broken edges are hardly seen. Add photographs from the side, tilted by 30 to 60 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bütün fotoğraflar kâğıda dik olarak yukarıdan bakıyor, bu yüzden yükseklikler ve cidar kalınlıkları belirsiz, kırık kenarlar da neredeyse görünmüyor. Yandan, 30 ile 60 derece eğik fotoğraflar ekleyin.</translation>
    </message>
    <message>
      <source>If it is one, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öyleyse, onu tek başına fotoğraflayın.</translation>
    </message>
    <message>
        <source>The catalogue is damaged (%1); nothing was changed, and no backup was deleted. Restore it with 'ostraka catalogue repair PROJECT'.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Katalog bozuk (%1); hiçbir şey değiştirilmedi ve hiçbir yedek silinmedi. “ostraka catalogue repair PROJECT” ile onarın.</translation>
    </message>
    <message>
        <source>a page was changed</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>bir sayfa değişmiş</translation>
    </message>
    <message>
        <source>it is a backup, but the -wal file beside it belongs to the catalogue that it replaced</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>bu bir yedek, ama yanındaki -wal dosyası yerini aldığı kataloğa ait</translation>
    </message>
    <message>
        <source>its repair was interrupted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>onarımı yarıda kalmış</translation>
    </message>
    <message>
        <source>its pages are inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>sayfaları birbirini tutmuyor</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>dosya boş</translation>
    </message>
    <message>
        <source>the file is not a database</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>dosya bir veritabanı değil</translation>
    </message>
    <message>
        <source>the file belongs to another program</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>dosya başka bir programa ait</translation>
    </message>
    <message>
        <source>the file contains no catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>dosyada katalog yok</translation>
    </message>
    <message>
        <source>the header is inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>başlık kendisiyle çelişiyor</translation>
    </message>
    <message>
        <source>it contains no project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>içinde proje yok</translation>
    </message>
    <message>
        <source>The catalogue cannot be read; check that it exists and check its permissions.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Katalog okunamıyor; yerinde olup olmadığını ve izinlerini denetleyin.</translation>
    </message>
    <message>
        <source>This project is read-only, and there is no space for the copy that Ostraka reads; free some space in the folder for temporary files.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu proje yalnızca okunabilir ve okumak için bir kopyaya yer yok; geçici dosyalar klasöründe yer açın.</translation>
    </message>
    <message>
        <source>An older Ostraka made this project, and it is read-only here; copy it to a folder that you can write to, and open it there.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu proje daha eski bir Ostraka ile yapılmış ve burada yalnızca okunabilir; yazabildiğiniz bir klasöre kopyalayıp orada açın.</translation>
    </message>
    <message>
        <source>The catalogue is damaged, and none of its backups is intact; copy one from an archive or another disk into the folder backups, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Katalog bozuk ve hiçbir yedeği sağlam değil; bir arşivden ya da başka bir diskten backups klasörüne bir yedek kopyalayıp yeniden onarın.</translation>
    </message>
    <message>
        <source>Another program has this project open; close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu proje başka bir programda açık; orada kapatıp sonra onarın.</translation>
    </message>
    <message>
        <source>%1 rows in total, %2 read; run the same import again for the others.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 satırdan %2 tanesi okundu; aynı içe aktarma ötekileri girer.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; means the same as &apos;%2&apos;; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; sütunu &apos;%2&apos; ile aynı şeyi söylüyor; değerleri kendi alanınız olarak saklanır.</translation>
    </message>
    <message>
      <source>Check the drawing of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 çizimini kontrol edin: %2</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2, parça %1</translation>
    </message>
    <message>
      <source>camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: %2</translation>
    </message>
    <message>
      <source>%1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ve %2</translation>
    </message>
    <message>
      <source>Camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1: %2</translation>
    </message>
    <message>
      <source>The focal length is not determined: %1 px with a standard deviation of %2 px; take more pictures, closer and with the board tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>odak uzaklığı belirlenmedi: %1 px, standart sapma %2 px; daha çok resim çekin, daha yakından ve kalibrasyon levhası değişik yönlere 20 ile 45 derece eğikken.</translation>
    </message>
    <message>
      <source>No picture shows the board tilted by more than 15 degrees; tilt it more to separate focal length from distance.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hiçbir resimde kalibrasyon levhası 15 dereceden fazla eğik değil; odak uzaklığı ile uzaklık ayırt edilsin diye onu daha çok eğin.</translation>
    </message>
    <message>
      <source>The corners scatter by %1 px, more than the 0.3 px of sharp pictures of a flat board; check focus, lighting and the board's flatness.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>köşeler %1 px dağılıyor, düz bir kalibrasyon levhasının keskin resimlerindeki 0,3 px’ten çok; odağı, ışığı ve kalibrasyon levhasının düzlüğünü denetleyin.</translation>
    </message>
    <message>
      <source>The worst picture is %1 with %2 px; retake it or leave it out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en kötü resim %1, %2 px ile; yeniden çekin ya da çıkarın.</translation>
    </message>
    <message>
      <source>Calibration pictures that show the board: %1; at least 3 are needed. Take more pictures of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Levhanın göründüğü kalibrasyon görüntüleri: %1; en az 3 gerekli. Levhanın daha çok görüntüsünü çekin.</translation>
    </message>
    <message>
      <source>Camera %1, position %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, konum %2: %3.</translation>
    </message>
    <message>
      <source>%1 poses are given for %2 photographs; give one pose for each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 fotoğraf için %1 duruş verilmiş; her biri için bir duruş verin.</translation>
    </message>
    <message>
      <source>its front no longer has a back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ön yüzünün artık arka yüzü yok</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about ten times the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birimi denetleyin: %1, hesaplanan değerin yaklaşık on katı.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about a tenth of the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birimi denetleyin: %1, hesaplanan değerin yaklaşık onda biri.</translation>
    </message>
    <message>
      <source>Check the value: %1 differs from the computed value by a factor of three or more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değeri denetleyin: %1, hesaplanan değerden en az üç kat farklı.</translation>
    </message>
    <message>
      <source>Check the values: %1 (%2) is below %3 (%4).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Değerleri denetleyin: %1 (%2), şundan küçük: %3 (%4).</translation>
    </message>
    <message>
      <source>The computed value is %1. Delete it?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hesaplanan değer %1. Silinsin mi?</translation>
    </message>
    <message>
      <source>The computed value is %1. Replace it with the measured value?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hesaplanan değer %1. Ölçülen değerle değiştirilsin mi?</translation>
    </message>
    <message>
      <source>the length</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>uzunluk</translation>
    </message>
    <message>
      <source>the width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>genişlik</translation>
    </message>
    <message>
      <source>the minimum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en küçük kalınlık</translation>
    </message>
    <message>
      <source>the maximum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>en büyük kalınlık</translation>
    </message>
    <message>
      <source>the thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kalınlık</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate&apos;s markers are visible.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar sayılamadı: tablanın çok az işareti görünüyor.</translation>
    </message>
    <message>
      <source>No sherd is visible on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablada hiç parça görünmüyor.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate&apos;s centre: move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar tablanın ortasından %1 uzakta birbirine değiyor ya da neredeyse değiyor: ayırın ve yeniden çekin.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate&apos;s centre was counted as one but may be two touching sherds: check it; if so, move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tablanın ortasından %1 uzakta duran bir parça sayıldı, ama birbirine değen iki parça olabilir: oraya bakın; öyleyse ayırın ve yeniden çekin.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and reshoot them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz ön yüze benziyor: parçaları çevirin ve yeniden çekin.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün parçaları sayılamadı: tablayı boşaltmadan önce resimleri kendiniz karşılaştırın.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün parçaları sayılamadı: tablayı boşaltmadan önce resimleri kendiniz karşılaştırın.</translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Find the missing ones before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzde sayılan parça: %1, arka yüzde: %2. Tablayı boşaltmadan önce eksik olanları bulun.</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Check whether one was added or broke.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzde sayılan parça: %1, arka yüzde: %2. Birinin eklenip eklenmediğini ya da kırılıp kırılmadığını denetleyin.</translation>
    </message>
    <message>
      <source>The turntable&apos;s own count was %1 degrees off; it was corrected from the plate&apos;s markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Döner masanın kendi sayımı %1 derece kaymıştı; tablanın işaretlerine göre düzeltildi.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bir Ostraka projesi değil: klasörde catalogue.sqlite yok; hiçbir şey birleştirilmedi.</translation>
    </message>
    <message>
      <source>Another version of Ostraka made this project; nothing was merged. Open it once with this version, which updates it, or install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu projeyi Ostraka’nın başka bir sürümü oluşturdu; hiçbir şey birleştirilmedi. Projeyi güncellemesi için bir kez bu sürümle açın ya da yeni sürümü kurun.</translation>
    </message>
    <message>
      <source>A project cannot be merged with itself; name another project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir proje kendisiyle birleştirilemez; başka bir proje belirtin.</translation>
    </message>
    <message>
      <source>This project is read-only here, so nothing was merged; copy it to a folder that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje burada salt okunur, bu yüzden hiçbir şey birleştirilmedi; yazabileceğiniz bir klasöre kopyalayın.</translation>
    </message>
    <message>
      <source>The project changed while files were copied, so nothing was merged; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosyalar kopyalanırken proje değişti, bu yüzden hiçbir şey birleştirilmedi; aynı komutu yeniden çalıştırın.</translation>
    </message>
    <message>
      <source>The conflict %1 (%2) cannot be settled with &apos;%3&apos;; nothing was merged. Choose one of the ways that the list of conflicts offers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 çakışması (%2) “%3” ile çözülemez; hiçbir şey birleştirilmedi. Çakışma listesinin sunduğu yollardan birini seçin.</translation>
    </message>
    <message>
      <source>This file must be a JSON list of {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} or {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;}; nothing was merged. Correct the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya, {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} ya da {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;} öğelerinden oluşan bir JSON listesi olmalıdır; hiçbir şey birleştirilmedi. Dosyayı düzeltin.</translation>
    </message>
    <message>
      <source>The conflict %1 is settled twice in this file; nothing was merged. Keep one of the two entries.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 çakışması bu dosyada iki kez çözülüyor; hiçbir şey birleştirilmedi. İki girdiden birini bırakın.</translation>
    </message>
    <message>
      <source>This file of project B differs from what its catalogue records; nothing was merged. Restore it from a copy (&apos;ostraka catalogue check&apos; lists all such files).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>B projesinin bu dosyası kataloğunda kayıtlı olandan farklı; hiçbir şey birleştirilmedi. Bir kopyadan geri yükleyin (“ostraka catalogue check” bu tür dosyaların hepsini listeler).</translation>
    </message>
    <message>
      <source>The disk does not return what was written to it; nothing was merged. Check the disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Disk, üzerine yazılanı geri vermiyor; hiçbir şey birleştirilmedi. Diski denetleyin.</translation>
    </message>
    <message>
      <source>A link or a device cannot be merged; nothing was merged. Move what it leads to into project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir bağlantı ya da aygıt birleştirilemez; hiçbir şey birleştirilmedi. Gösterdiği içeriği B projesine taşıyın.</translation>
    </message>
    <message>
      <source>Results from a cluster must be regular files with plain names; nothing of this batch was entered. Submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir kümeden gelen sonuçlar, yalın adlı olağan dosyalar olmalıdır; bu partiden hiçbir şey girilmedi. Partiyi yeniden gönderin.</translation>
    </message>
    <message>
      <source>This batch was processed here or reshot in the meantime; the cluster&apos;s results are not entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti bu arada burada işlendi ya da yeniden çekildi; kümenin sonuçları girilmiyor.</translation>
    </message>
    <message>
      <source>The name of a partition or an account consists of letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;; look it up with &apos;sinfo&apos; or ask the cluster&apos;s administrators.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir bölümün ya da hesabın adı harf, rakam, “-”, “_” ve “.” karakterlerinden oluşur; “sinfo” ile bakın ya da kümenin yöneticilerine sorun.</translation>
    </message>
    <message>
      <source>The command that starts Ostraka on the cluster must be one line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kümede Ostraka’yı başlatan komut tek satır olmalıdır.</translation>
    </message>
    <message>
      <source>A job needs at least one core, and its memory and time must not be negative.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir iş için en az bir çekirdek gerekir; belleği ve süresi negatif olamaz.</translation>
    </message>
    <message>
      <source>This folder cannot be opened (%1); check its name and permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasör açılamıyor (%1); adını ve izinlerini denetleyin.</translation>
    </message>
    <message>
      <source>The path of this project contains a character that has a special meaning for Slurm (%, a backslash or a control character); rename the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu projenin yolu, Slurm için özel anlamı olan bir karakter içeriyor (%, ters eğik çizgi ya da denetim karakteri); klasörün adını değiştirin.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH; run this command on a login node of the cluster, or name one with --host USER@LOGIN:/FOLDER.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 programı bu bilgisayarın PATH değişkeninde yok; bu komutu kümenin bir oturum açma düğümünde çalıştırın ya da --host USER@LOGIN:/FOLDER ile bir düğüm belirtin.</translation>
    </message>
    <message>
      <source>Not a folder on a cluster; write USER@LOGIN:/FOLDER, with the folder&apos;s full path and without spaces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, kümedeki bir klasör değil; klasörün tam yoluyla ve boşluksuz olarak USER@LOGIN:/FOLDER yazın.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH, but --host needs it; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 programı bu bilgisayarın PATH değişkeninde yok, ama --host için gerekli; kurun.</translation>
    </message>
    <message>
      <source>The program %1 cannot be started there; ask the cluster&apos;s administrators how Slurm is reached.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 programı orada başlatılamıyor; Slurm’a nasıl erişildiğini kümenin yöneticilerine sorun.</translation>
    </message>
    <message>
      <source>%1 failed (%2). Nothing is lost; once the cause is removed, run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 başarısız oldu (%2). Hiçbir şey kaybolmadı; neden giderilince aynı komutu yeniden çalıştırın.</translation>
    </message>
    <message>
      <source>This batch contains imported scans and is not submitted; the window&apos;s queue processes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti içe aktarılmış taramalar içeriyor ve gönderilmiyor; onu pencerenin sırası işler.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk has %1 GB left, but the batches to submit (%2) need about %3 GB. Nothing was submitted; free some space, or submit fewer with --most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kümenin diskinde %1 GB kaldı, ama gönderilecek partiler (%2) yaklaşık %3 GB istiyor. Hiçbir şey gönderilmedi; yer açın ya da --most ile daha azını gönderin.</translation>
    </message>
    <message>
      <source>Batches of this project are on another cluster or in another folder; collect them before you submit to this one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu projenin partileri başka bir kümede ya da başka bir klasörde; buraya göndermeden önce onları toplayın.</translation>
    </message>
    <message>
      <source>Not a list of the batches on a cluster; restore an earlier one, or delete it: batches that are on the cluster are then processed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, kümedeki partilerin listesi değil; daha eskisini geri yükleyin ya da silin: kümedeki partiler o zaman yeniden işlenir.</translation>
    </message>
    <message>
      <source>Out of memory (%1 MB requested); the next submission requests twice as much.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bellek tükendi (istenen: %1 MB); sonraki gönderim iki katını ister.</translation>
    </message>
    <message>
      <source>Out of time (minutes requested: %1); the next submission requests twice as many and resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Süre doldu (istenen dakika: %1); sonraki gönderim iki katını ister ve son tamamlanan aşamadan sürdürür.</translation>
    </message>
    <message>
      <source>The node failed, or the job was killed; the next submission resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Düğüm arızalandı ya da iş sonlandırıldı; sonraki gönderim son tamamlanan aşamadan sürdürür.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk is full, or your quota is used up; free some space, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kümenin diski dolu ya da kotanız tükendi; yer açın, sonra yeniden gönderin.</translation>
    </message>
    <message>
      <source>The cluster does not know this job, and the job wrote nothing into the project&apos;s folder; check that the cluster&apos;s nodes see that folder, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Küme bu işi tanımıyor ve iş, projenin klasörüne hiçbir şey yazmadı; kümenin düğümlerinin bu klasörü gördüğünü denetleyin, sonra yeniden gönderin.</translation>
    </message>
    <message>
      <source>The program ended with status %1; its output is in %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Program %1 durumuyla sona erdi; çıktısı şurada: %2.</translation>
    </message>
    <message>
      <source>The partition ends jobs earlier than the %1 minutes requested; cancel the job, then submit again with another --partition or fewer --minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bölüm, işleri istenen %1 dakikadan önce bitiriyor; işi iptal edin, sonra başka bir --partition ya da daha az --minutes ile yeniden gönderin.</translation>
    </message>
    <message>
      <source>Slurm&apos;s reason: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Slurm’un bildirdiği neden: %1.</translation>
    </message>
    <message>
      <source>This network cannot be used: %1. Choose an ONNX network that takes 1 x 3 x H x W and gives 1 x 1 x h x w or 1 x 2 x h x w.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu ağ kullanılamıyor: %1. 1 x 3 x H x W alan ve 1 x 1 x h x w ya da 1 x 2 x h x w veren bir ONNX ağı seçin.</translation>
    </message>
    <message>
      <source>it cannot be run (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>çalıştırılamıyor (%1)</translation>
    </message>
    <message>
      <source>its output has another shape</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>çıktısının biçimi farklı</translation>
    </message>
    <message>
      <source>its output contains numbers that are not finite</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>çıktısı sonlu olmayan sayılar içeriyor</translation>
    </message>
    <message>
      <source>its input is not an image</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>girdisi bir görüntü değil</translation>
    </message>
    <message>
      <source>its input has %1 channels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>girdisinde %1 kanal var</translation>
    </message>
    <message>
      <source>its input is larger than %1 pixels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>girdisi %1 pikselden büyük</translation>
    </message>
    <message>
      <source>You have no permission to use it: copy packaging/udev/70-ostraka.rules to /etc/udev/rules.d/ and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Onu kullanma izniniz yok: packaging/udev/70-ostraka.rules dosyasını /etc/udev/rules.d/ içine kopyalayın ve yeniden takın.</translation>
    </message>
    <message>
      <source>It is in use by %1: &apos;ostraka devices --release&apos; releases it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 tarafından kullanılıyor: “ostraka devices --release” onu serbest bırakır.</translation>
    </message>
    <message>
      <source>It is in use by %1: close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 tarafından kullanılıyor: o programı kapatın.</translation>
    </message>
    <message>
      <source>The kernel has no driver for it; install one for this adapter.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çekirdekte bunun sürücüsü yok; bu bağdaştırıcı için bir sürücü kurun.</translation>
    </message>
    <message>
      <source>A folder of the project cannot be read (%1); check its permissions, then archive the project again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projenin bir klasörü okunamıyor (%1); izinlerini denetleyin, sonra projeyi yeniden arşivleyin.</translation>
    </message>
    <message>
      <source>No output folder was given; name one with --output OUT.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çıktı klasörü verilmedi; --output OUT ile bir klasör belirtin.</translation>
    </message>
    <message>
      <source>No folder of front scans was given; name one with --front DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz taramalarının klasörü verilmedi; --front DIR ile bir klasör belirtin.</translation>
    </message>
    <message>
      <source>No folder of back scans was given; name one with --back DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz taramalarının klasörü verilmedi; --back DIR ile bir klasör belirtin.</translation>
    </message>
    <message>
      <source>The field %1 has no unit &apos;%2&apos;; choose another unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alanının “%2” birimi yok; başka bir birim seçin.</translation>
    </message>
    <message>
      <source>The table has no column &apos;%1&apos;; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tabloda “%1” sütunu yok; adını denetleyin.</translation>
    </message>
    <message>
      <source>The columns &apos;%1&apos; and &apos;%2&apos; are both mapped to the field %3; leave one of them out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>“%1” ve “%2” sütunlarının ikisi de %3 alanına eşlenmiş; birini dışarıda bırakın.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; maps no column; write COLUMN=FIELD or COLUMN=FIELD:unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>“%1” hiçbir sütunu eşlemiyor; COLUMN=FIELD ya da COLUMN=FIELD:unit yazın.</translation>
    </message>
    <message>
      <source>The scan&apos;s colours or qualities differ in number from its points; give one for each point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramanın renk ya da kalite değerlerinin sayısı noktalarınınkinden farklı; her nokta için bir değer verin.</translation>
    </message>
    <message>
      <source>The pixels or the mask differ in size from the stated width and height; give one value for each pixel.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Pikseller ya da maske, belirtilen genişlik ve yüksekliğe uymuyor; her piksel için bir değer verin.</translation>
    </message>
    <message>
      <source>No scan of this side was given; give at least one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yüzün taraması verilmedi; en az bir tane verin.</translation>
    </message>
    <message>
      <source>give them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>onları mm olarak verin</translation>
    </message>
    <message>
      <source>A remark in this file cannot be read; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosyadaki bir not okunamıyor; dosyanın daha eski bir kopyasını geri yükleyin ya da partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>Camera %1, position %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kamera %1, konum %2</translation>
    </message>
    <message>
        <source>%1: from %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: %2 içinden</translation>
    </message>
    <message>
        <source>%1: from the history</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: geçmişten</translation>
    </message>
    <message>
        <source>%1: not restored</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: geri getirilemedi</translation>
    </message>
    <message>
      <source>draft %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>taslak %1</translation>
    </message>
    <message>
      <source>The remarks in this file are longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosyadaki notlar %1 bayttan uzun; dosyanın daha eski bir kopyasını geri yükleyin ya da partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>A remark in this file is nested more than %1 levels deep; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosyadaki bir not %1 düzeyden daha derin iç içe geçmiş; dosyanın daha eski bir kopyasını geri yükleyin ya da partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>The template of a remark in this file is longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosyadaki bir notun şablonu %1 bayttan uzun; dosyanın daha eski bir kopyasını geri yükleyin ya da partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>A remark in this file uses a value more than %1 times; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosyadaki bir not bir değeri %1 kereden fazla kullanıyor; dosyanın daha eski bir kopyasını geri yükleyin ya da partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>The version of the damaged catalogue cannot be read, so this repair relies on the backup %1. If a newer Ostraka has changed this project since, put the damaged file back and repair it with that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hasarlı kataloğun sürümü okunamıyor, bu yüzden bu onarım %1 yedeğine dayanıyor. O zamandan beri daha yeni bir Ostraka bu projeyi değiştirdiyse hasarlı dosyayı geri koyup o sürümle onarın.</translation>
    </message>
    <message>
      <source>The setting %1 of project B says that two different things are the same; nothing was merged. Ask for another copy of project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>B projesinin %1 ayarı iki farklı şeyin aynı olduğunu söylüyor; hiçbir şey birleştirilmedi. B projesinin başka bir kopyasını isteyin.</translation>
    </message>
    <message>
      <source>The number or code %1 is already in use; nothing was merged. Settle the conflict %2 with another one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası veya kodu zaten kullanılıyor; hiçbir şey birleştirilmedi. %2 çakışmasını başka biriyle çözün.</translation>
    </message>
    <message>
      <source>A new number cannot be empty; nothing was merged. Enter a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni bir numara boş olamaz; hiçbir şey birleştirilmedi. Bir numara girin.</translation>
    </message>
    <message>
      <source>The merged catalogue would be inconsistent, so nothing was merged; report this with a copy of both projects.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birleştirilen katalog tutarsız olurdu, bu yüzden hiçbir şey birleştirilmedi; bunu iki projenin kopyasıyla bildirin.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the front of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sonuçlar %1 için ön yüzün önceki fotoğraflarından elde edildi; yeniden işleyin.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the back of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sonuçlar %1 için arka yüzün önceki fotoğraflarından elde edildi; yeniden işleyin.</translation>
    </message>
    <message>
      <source>Photographs of %1 that are missing or are others than these results were made from: %2 of %3. The results are entered; reprocess the batch if it was photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 için eksik olan veya bu sonuçların elde edildiği fotoğraflardan farklı olan fotoğraflar: %2 / %3. Sonuçlar girildi; parti yeniden fotoğraflandıysa yeniden işleyin.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; the cluster&apos;s results are not entered. Submit it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti gönderildikten sonra yeniden fotoğraflandı; kümenin sonuçları girilmedi. Yeniden gönderin.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; its job %1 is of no use any more. Cancel it with &apos;scancel&apos;, or wait until it has ended, then submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu parti gönderildikten sonra yeniden fotoğraflandı; %1 işi artık işe yaramaz. &apos;scancel&apos; ile iptal edin veya bitmesini bekleyin, sonra partiyi yeniden gönderin.</translation>
    </message>
    <message>
      <source>Batches of this project were submitted to this host, which was not named on this computer; nothing was sent to it. If you trust it, name it once with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu projenin partileri, bu bilgisayarda belirtilmemiş olan bu sunucuya gönderilmiş; sunucuya hiçbir şey gönderilmedi. Ona güveniyorsanız --host ile bir kez belirtin.</translation>
    </message>
    <message>
      <source>Not a file in which Ostraka remembers the host of a cluster; delete it, then name the host with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka&apos;nın bir kümenin sunucusunu hatırladığı bir dosya değil; silin, sonra sunucuyu --host ile belirtin.</translation>
    </message>
    <message>
      <source>A job can request at most %1 MB of memory and %2 minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir iş en çok %1 MB bellek ve %2 dakika isteyebilir.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1 of the front side; it is left out of both sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu fotoğraf ön yüzün %1 fotoğrafıyla aynı; her iki yüzde de atlanıyor.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the front side are identical to photographs of the back side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün %2 fotoğrafından %1 tanesi arka yüzün fotoğraflarıyla aynı (örneğin %3), bu yüzden parti kullanılamaz; her yüze kendi fotoğraflarını verin.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the back side are identical to photographs of the front side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün %2 fotoğrafından %1 tanesi ön yüzün fotoğraflarıyla aynı (örneğin %3), bu yüzden parti kullanılamaz; her yüze kendi fotoğraflarını verin.</translation>
    </message>
    <message>
      <source>The field %1 was changed meanwhile; nothing was undone or redone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 alanı bu arada değiştirildi; hiçbir şey geri alınmadı veya yinelenmedi.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term; choose one of %2, or add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; bir terim değil; şunlardan birini seçin: %2, ya da ayarlarda ekleyin.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term: the vocabulary is empty; add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; bir terim değil: sözlük boş; ayarlarda ekleyin.</translation>
    </message>
    <message>
      <source>why this row was not imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bu satır neden içe aktarılmadı</translation>
    </message>
    <message>
      <source>Read as a table of contexts and bags: no column has the sherds&apos; numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kontekst ve torba tablosu olarak okundu: hiçbir sütunda parçaların numaraları yok.</translation>
    </message>
    <message>
      <source>Read as a table of sherds: the column &apos;%1&apos; identifies them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça tablosu olarak okundu: parçaları &apos;%1&apos; sütunu belirliyor.</translation>
    </message>
    <message>
      <source>No column has the sherds&apos; numbers, but &apos;%1&apos; is a column of sherds; select the column of numbers, or leave &apos;%1&apos; out if this is a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Hiçbir sütunda parçaların numaraları yok, ama &apos;%1&apos; parçalara ait bir sütun; numara sütununu seçin ya da bu bir kontekst tablosuysa &apos;%1&apos; sütununu dışarıda bırakın.</translation>
    </message>
    <message>
        <source>%1: not restored; it belongs to %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: geri getirilemedi; ait olduğu kayıt: %2</translation>
    </message>
    <message>
      <source>Only measurements and days accept &lt; and &gt;; write %1:value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnız ölçüler ve günler &lt; ve &gt; ile karşılaştırılır; %1:value yazın.</translation>
    </message>
    <message>
      <source>The filter has no field &apos;%1&apos;; write extra.%1 for a custom field, or enclose the word in quotation marks to search for it literally.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Süzgeç &apos;%1&apos; alanını bilmiyor; kendi alanınız için extra.%1 yazın ya da sözcüğü olduğu gibi aramak için tırnak içine alın.</translation>
    </message>
    <message>
      <source>Write the date in EDTF, for example -0599/-0549~ (600 to about 550 BC), -1149? or 0350/..; years have four digits, and words such as MB II belong in the field for the period.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tarih EDTF ile yazılır: -0599/-0549~ (MÖ 600 – yaklaşık 550), -1149? ya da 0350/.. gibi; yıllar dört hanelidir, MB II gibi sözcükler dönem alanına yazılır.</translation>
    </message>
    <message>
      <source>Enter the context with its site and trench, such as KT26-A-012.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Konteksti alanı ve açmasıyla birlikte yazın, örneğin KT26-A-012.</translation>
    </message>
    <message>
      <source>Scale: none; lengths in mm are based on a guess.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: yok; mm cinsinden uzunluklar bir tahmine dayanır.</translation>
    </message>
    <message>
      <source>Scale: the board of board.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: board.json dosyasındaki tahta.</translation>
    </message>
    <message>
      <source>Scale: the lengths marked in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: scale.json içinde işaretlenen uzunluklar.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as typed at the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: içe aktarmada yazıldığı gibi %1 mm işaretler.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as in plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: plate.json dosyasındaki gibi %1 mm işaretler.</translation>
    </message>
    <message>
      <source>Scale: the markers that plate.json describes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: plate.json dosyasının tanımladığı işaretler.</translation>
    </message>
    <message>
      <source>Scale: that of the imported scans.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçek: içe aktarılan taramalarınki.</translation>
    </message>
    <message>
      <source>The scale of this batch is its rig&apos;s; calibrate the rig to correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu partinin ölçeği düzeneğinden gelir; düzeltmek için düzeneği kalibre edin.</translation>
    </message>
    <message>
      <source>The markers of this sheet are of several sizes; correct its plate.json by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sayfanın işaretleri farklı boyutlarda; plate.json dosyasını elle düzeltin.</translation>
    </message>
    <message>
      <source>These results contain a measurement larger than any sherd; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sonuçlar, her parçadan büyük bir ölçü içeriyor; &apos;ostraka process&apos; komutunu yeniden çalıştırın.</translation>
    </message>
    <message>
      <source>This project lies in the archive &apos;%1&apos;, which any change would make invalid; restore the archive to a new folder, and open that.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje, her değişikliğin geçersiz kılacağı &apos;%1&apos; arşivinde; arşivi yeni bir klasöre geri yükleyin ve o klasörü açın.</translation>
    </message>
    <message>
      <source>Not a location of photographs, results, models or imported files, the only files that a merge writes; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Burası fotoğrafların, sonuçların, modellerin ya da içe aktarılan dosyaların yeri değil; birleştirme yalnız bu dosyaları yazar. Hiçbir şey birleştirilmedi.</translation>
    </message>
    <message>
      <source>A point, a normal or a quality of the scan is not finite; leave such points out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Taramanın bir noktası, normali ya da niteliği sonlu değil; böyle noktaları dışarıda bırakın.</translation>
    </message>
    <message>
      <source>The lists of this cloud or mesh differ in length, or a triangle names a vertex that does not exist; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu nokta bulutunun ya da ağın listeleri farklı uzunlukta ya da bir üçgen var olmayan bir köşeyi gösteriyor; hiçbir şey yazılmadı.</translation>
    </message>
    <message>
      <source>The transform puts the back %1 mm away from the front; give one that takes points of the back to the front&apos;s frame.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dönüşüm, arka yüzü ön yüzden %1 mm uzağa koyuyor; arka yüzün noktalarını ön yüzün koordinat sistemine taşıyan bir dönüşüm verin.</translation>
    </message>
    <message>
      <source>The model has no photographs, so the orthophoto shows the colours of its vertices.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelin fotoğrafı yok, bu yüzden ortofoto köşe noktalarının renklerini gösterir.</translation>
    </message>
    <message>
      <source>The model has neither photographs nor colours, so there is no orthophoto of it; draw its shaded form.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Modelin ne fotoğrafı ne rengi var, bu yüzden ortofotosu yok; gölgeli biçimini çizin.</translation>
    </message>
    <message>
      <source>%1: 1 point whose normal has no direction was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: normalinin yönü olmayan 1 nokta atlandı; dışa aktarmayı denetleyin.</translation>
    </message>
    <message>
      <source>%1: %2 points whose normals have no direction were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: normallerinin yönü olmayan %2 nokta atlandı; dışa aktarmayı denetleyin.</translation>
    </message>
    <message>
      <source>The photograph is less than %1 pixels wide or high; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğrafın genişliği veya yüksekliği %1 pikselden az; özgün fotoğrafı kullanın.</translation>
    </message>
    <message>
        <source>The project has no site yet; add a column &apos;Site&apos;, or write the context with its site, such as %1.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Projede henüz alan yok; bir “Alan” sütunu ekleyin veya konteksti alanıyla yazın, örneğin %1.</translation>
    </message>
    <message>
        <source>This project has %1 sites; add a column &apos;Site&apos;, or write the context with its site, such as %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu projede %1 alan var; bir “Alan” sütunu ekleyin veya konteksti alanıyla yazın, örneğin %2.</translation>
    </message>
    <message>
        <source>The site %1 has %2 trenches; add a column &apos;Trench&apos;, or write the context with its trench, such as %3.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 alanında %2 açma var; bir “Açma” sütunu ekleyin veya konteksti açmasıyla yazın, örneğin %3.</translation>
    </message>
    <message>
        <source>There is no such trench in the site %1; write trench and context in columns of their own.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 alanında böyle bir açma yok; açmayı ve konteksti ayrı sütunlara yazın.</translation>
    </message>
    <message>
        <source>The backups %1 and %2 are of different projects, and nothing tells which of them this folder is; nothing was changed. Move those of the other project away, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 ve %2 yedekleri farklı projelere ait ve bu klasörün hangisi olduğu belli değil; hiçbir şey değiştirilmedi. Öteki projeninkileri başka yere taşıyın, sonra yeniden onarın.</translation>
    </message>
    <message>
        <source>This can be %1 or %2; enter site, trench and context each by itself.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu %1 veya %2 olabilir; alanı, açmayı ve konteksti ayrı ayrı girin.</translation>
    </message>
    <message>
        <source>The table needs a column for the sherds&apos; numbers, or one for the contexts (a table of contexts); select it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tabloda parça numaraları için bir sütun veya kontekstler için bir sütun (kontekst tablosu) olmalı; sütunu seçin.</translation>
    </message>
    <message>
      <source>The number needs the trench of the sherd, which is not recorded; choose a context in a trench, or change the numbering in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numara için parçanın açması gerekir, o da kayıtlı değil; açması olan bir konteks seçin veya ayarlarda numaralandırmayı değiştirin.</translation>
    </message>
    <message>
      <source>This folder on the cluster belongs to another project, to another copy of this one, or to this one before it was moved; nothing was sent. Name another folder with --host. If nothing else uses this one, delete &apos;cluster/owner&apos; in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kümedeki bu klasör başka bir projeye, bu projenin başka bir kopyasına ya da taşınmadan önceki bu projeye ait; hiçbir şey gönderilmedi. --host ile başka bir klasör belirtin. Bu klasörü başka hiçbir şey kullanmıyorsa içindeki &apos;cluster/owner&apos; bağlantısını silin.</translation>
    </message>
    <message>
      <source>This changed while a merge was being completed, so it was kept, but the catalogue has what was merged. Reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu, bir birleştirme tamamlanırken değişti; bu yüzden korundu, ama katalogda birleştirilen var. Partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>satır</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>alan</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>değer</translation>
    </message>
    <message>
      <source>A sparse object of %1 points at x %2, y %3 mm was left out; if it is a sherd, photograph it closer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnızca %1 noktadan oluşan bir nesne (x %2, y %3 mm) dışarıda bırakıldı; parçaysa onu daha yakından çekin.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs or scans of %3 belong to %4, too: its sherds would be in the catalogue twice. Nothing was entered. Set %3 aside and use %4, or keep both: 'Keep both' in the queue, 'ostraka catalogue enter --keep-both' on the command line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%3 partisinin %2 fotoğraf veya taramasından %1 tanesi %4 partisine de ait: parçaları katalogda iki kez yer alırdı. Hiçbir şey girilmedi. %3 partisini kenara ayırıp %4 partisini kullanın ya da ikisini de tutun: sırada “İkisini de tut”, komut satırında 'ostraka catalogue enter --keep-both'.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of %3, which this export holds, belong to %4, too: its sherds would be in the catalogue twice. Use %4 and leave the export out, or keep both on purpose (on the command line: --keep-both).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dışa aktarımdaki %3 partisinin %2 fotoğrafından %1 tanesi %4 partisine de ait: parçaları katalogda iki kez yer alırdı. %4 partisini kullanıp dışa aktarımı bırakın ya da bilerek ikisini de tutun (komut satırında: --keep-both).</translation>
    </message>
    <message>
      <source>Another run is writing to this folder. What it has saved is kept, and this run has changed nothing; wait until the other one ends, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasöre başka bir işlem yazıyor. Kaydettikleri korunuyor ve bu işlem hiçbir şeyi değiştirmedi; ötekinin bitmesini bekleyin ya da başka bir klasör seçin.</translation>
    </message>
    <message>
      <source>The photographs do not tell the light from the sherds' own colours, so textures stay as photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflar ışığı parçaların kendi renklerinden ayırmaya yetmiyor; dokular fotoğraftaki gibi kalıyor.</translation>
    </message>
    <message>
      <source>Ostraka needs this folder for its own files, but it contains others. They are unchanged; move them elsewhere, then start again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka’nın kendi dosyaları için bu klasöre ihtiyacı var, ama içinde başka dosyalar var. Onlar değişmedi; başka bir yere taşıyın, sonra yeniden başlatın.</translation>
    </message>
    <message>
      <source>This is not the location of a photograph, result, model or imported file, the only files that a catalogue lists. Nothing was changed; use a backup or another copy of the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Burası bir fotoğrafın, sonucun, modelin ya da içe aktarılmış dosyanın yeri değil; bir katalog yalnız bunları listeler. Hiçbir şey değiştirilmedi; bir yedek ya da projenin başka bir kopyasını kullanın.</translation>
    </message>
    <message>
      <source>The catalogue has earlier results of %1, and the batch is queued again. Enter the new ones with &apos;ostraka catalogue enter&apos;, or reprocess it in the window.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Katalogda %1 için önceki sonuçlar var ve parti yeniden sıraya alındı. Yenilerini &apos;ostraka catalogue enter&apos; ile kaydedin ya da partiyi pencerede yeniden işleyin.</translation>
    </message>
    <message>
      <source>The folder on the cluster has files that Ostraka did not write (%1): %2. They were left there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kümedeki klasörde Ostraka’nın yazmadığı dosyalar var (%1): %2. Orada bırakıldılar.</translation>
    </message>
    <message>
      <source>The output folder contains the results of other scans, or of these before a file was changed, renamed, added or removed; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çıktı klasöründe başka taramaların ya da bir dosya değişmeden, yeniden adlandırılmadan, eklenmeden veya çıkarılmadan önce bu taramaların sonuçları var; başka klasör seçin.</translation>
    </message>
    <message>
      <source>The interval ends before it begins: %1 is earlier than %2; write the earlier date first, and years BC with a minus sign.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aralık başlamadan bitiyor: %1, %2 tarihinden öncedir; önce eski tarihi, MÖ yılları da eksi işaretiyle yazın.</translation>
    </message>
    <message>
      <source>The number %1 differs from the existing number %2 only in zeros, letter case or punctuation; check which one is meant.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası var olan %2 numarasından yalnızca sıfırlarda, büyük-küçük harfte ya da noktalamada ayrılıyor; hangisinin kastedildiğini denetleyin.</translation>
    </message>
    <message>
      <source>New numbers differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni numaralar var olanlardan yalnızca sıfırlarda, büyük-küçük harfte ya da noktalamada ayrılıyor: %1; yazım hatası olup olmadığını denetleyin.</translation>
    </message>
    <message>
      <source>New contexts differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni kontekstler var olanlardan yalnızca sıfırlarda, büyük-küçük harfte ya da noktalamada ayrılıyor: %1; yazım hatası olup olmadığını denetleyin.</translation>
    </message>
    <message>
      <source>A spreadsheet may have shortened these numbers or turned them into dates: %1; compare them with the labels and correct them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir hesap tablosu bu numaraları kısaltmış ya da tarihe çevirmiş olabilir: %1; etiketlerle karşılaştırın ve düzeltin.</translation>
    </message>
    <message>
      <source>This file differs from what &apos;ostraka process&apos; wrote; run it again, which writes the file anew.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosya, 'ostraka process' komutunun yazdığından farklı; komutu yeniden çalıştırın, dosya yeniden yazılır.</translation>
    </message>
    <message>
      <source>The name of the file %1 is not UTF-8, and results could not tell it from others; rename it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 dosyasının adı UTF-8 değil ve sonuçlar onu başkalarından ayıramaz; dosyayı yeniden adlandırıp bir daha deneyin.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüzün kullanılabilir fotoğrafları: %1; en az %2 gerekli. Atlanan fotoğraflar: %3; ilki: %4</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüzün kullanılabilir fotoğrafları: %1; en az %2 gerekli. Atlanan fotoğraflar: %3; ilki: %4</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused; nothing was merged. Settle the conflict %2 with another number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 numarası daha önce verildi ve asla yeniden kullanılmaz; hiçbir şey birleştirilmedi. %2 çakışmasını başka bir numarayla çözün.</translation>
    </message>
    <message>
      <source>An entry of this file does not have the form {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} (or &quot;b&quot; or &quot;one&quot;, or &quot;number&quot; with a new number): %1; nothing was merged. Correct the entry.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu dosyanın bir girdisi {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} biçiminde değil (ya da &quot;b&quot; veya &quot;one&quot;, ya da yeni bir numarayla &quot;number&quot;): %1; hiçbir şey birleştirilmedi. Girdiyi düzeltin.</translation>
    </message>
    <message>
      <source>The name of a place must not be empty; nothing was renamed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir yerin adı boş olamaz; hiçbir şey yeniden adlandırılmadı.</translation>
    </message>
    <message>
      <source>Another place has the name %1 by now; nothing was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu arada başka bir yerin adı %1 oldu; hiçbir şey geri alınmadı.</translation>
    </message>
    <message>
      <source>This disk does not accept this name; rename the file, or use a folder on another disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu disk bu adı kabul etmiyor; dosyayı yeniden adlandırın ya da başka bir diskteki bir klasörü kullanın.</translation>
    </message>
    <message>
      <source>A file of an earlier merge cannot be moved to its place, %1. Make it possible (move away what lies there, or copy the project to another disk), or delete the file; then merge again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önceki bir birleştirmenin dosyası yerine, %1, taşınamıyor. Bunu olanaklı kılın (orada bulunanı başka yere taşıyın ya da projeyi başka bir diske kopyalayın) ya da dosyayı silin; sonra yeniden birleştirin.</translation>
    </message>
    <message>
      <source>It belongs to a merge and waits in %1; moving it to its place is tried again whenever the project is opened.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dosya bir birleştirmeye aittir ve %1 içinde bekliyor; proje her açıldığında yerine taşınması yeniden denenir.</translation>
    </message>
    <message>
      <source>The block of numbers of this computer begins or ends with &apos;%1&apos;, but must be of whole numbers from 1 to %2; set it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu bilgisayarın numara bloğu &apos;%1&apos; ile başlıyor ya da bitiyor, oysa 1 ile %2 arasındaki tam sayılardan oluşmalı; ayarlarda belirleyin.</translation>
    </message>
    <message>
      <source>Photographs of %1 that these results were not made from: %2, the first is %3. Reprocess the batch to use them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 partisinin, bu sonuçların yapılmadığı fotoğrafları: %2, ilki %3. Bunları kullanmak için partiyi yeniden işleyin.</translation>
    </message>
    <message>
      <source>These results do not say which photographs they were made from, so they are not entered; process %1 again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu sonuçlar hangi fotoğraflardan yapıldıklarını söylemiyor, bu yüzden kaydedilmiyor; %1 partisini yeniden işleyin.</translation>
    </message>
    <message>
      <source>The GLB beside this model has another shape, so it is that of another sherd or of an earlier run; put its own beside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu modelin yanındaki GLB&apos;nin biçimi başka; yani başka bir parçanın ya da önceki bir işlemenin dosyasıdır; yanına kendisininkini koyun.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ToolRow</name>
    <message>
        <source>More</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Diğer</translation>
    </message>
    <message>
        <source>More tools</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Diğer araçlar</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, tuş %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ColumnTable</name>
    <message>
        <source>says nothing about the sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>parça hakkında bir şey söylemiyor</translation>
    </message>
    <message>
        <source>only shown, never read</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>yalnızca gösterilir, hiç okunmaz</translation>
    </message>
    <message>
        <source>share of 1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>1 üzerinden pay</translation>
    </message>
    <message>
        <source>unit guessed from the values; check it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>birim değerlerden tahmin edildi; denetleyin</translation>
    </message>
    <message>
        <source>as in the last table with these columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>bu sütunları olan son tablodaki gibi</translation>
    </message>
    <message>
        <source>chosen by you</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>sizin seçiminiz</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Tablonun sütunları</translation>
    </message>
    <message>
        <source>column</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>sütun</translation>
    </message>
    <message>
        <source>field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>alan</translation>
    </message>
    <message>
        <source>unit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>birim</translation>
    </message>
    <message>
        <source>first values</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ilk değerler</translation>
    </message>
    <message>
        <source>why</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>neden</translation>
    </message>
    <message>
        <source>Field of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 sütununun alanı</translation>
    </message>
    <message>
        <source>Unit of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 sütununun birimi</translation>
    </message>
    <message>
        <source>skip</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>atla</translation>
    </message>
    <message>
        <source>custom field: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>kendi alanınız: %1</translation>
    </message>
    <message>
        <source>no field of this name; kept as a custom field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>bu adda alan yok; kendi alanınız olarak tutulur</translation>
    </message>
    <message>
      <source>proposed by its heading</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>başlığına göre önerildi</translation>
    </message>
</context>
<context>
    <name>ImportSides</name>
    <message>
      <source>Drop either folders or photographs, not both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ya klasör ya da fotoğraf bırakın, ikisini birden değil.</translation>
    </message>
    <message>
      <source>These are more than two folders; drop that of the fronts and that of the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İkiden çok klasör; ön yüzlerinkini ve arka yüzlerinkini bırakın.</translation>
    </message>
    <message>
      <source>There are no photographs in this folder; choose one that holds them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde fotoğraf yok; içinde fotoğraf olan birini seçin.</translation>
    </message>
    <message>
      <source>This folder contains several folders with photographs (%1); drop the two of one batch, front and back, onto this page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörde fotoğraf içeren birkaç klasör var (%1); bir partinin iki klasörünü, ön ve arka yüz, bu sayfaya bırakın.</translation>
    </message>
    <message>
      <source>The photographs of this folder are those of the front already; choose another folder for the back, or divide the series with the slider.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu klasörün fotoğrafları zaten ön yüzün fotoğrafları; arka yüz için başka bir klasör seçin ya da diziyi sürgüyle bölün.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportChooser</name>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>front/ ve back/ taramaları olan klasör</translation>
    </message>
    <message>
      <source>Folder of a batch, or with photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir partinin ya da fotoğrafların klasörü</translation>
    </message>
    <message>
      <source>Folder of the back photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz fotoğraflarının klasörü</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SidesView</name>
    <message>
      <source>One side only</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yalnız bir yüz</translation>
    </message>
    <message>
      <source>Swap sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yüzleri değiştir</translation>
    </message>
    <message>
      <source>First photograph of the second side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İkinci yüzün ilk fotoğrafı</translation>
    </message>
    <message>
      <source>Choose sheet…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfa seç…</translation>
    </message>
    <message>
      <source>Clear sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfayı kaldır</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s &amp;black square</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir işaretin &amp;siyah karesinin kenarı</translation>
    </message>
    <message>
      <source>Unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bilinmiyor</translation>
    </message>
    <message>
      <source> mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation> mm</translation>
    </message>
    <message>
      <source>The sheet will be found in the photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfa fotoğraflarda bulunacak.</translation>
    </message>
    <message>
      <source>No sheet file (plate.json) and no marker size: the result has no scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfa dosyası (plate.json) ve işaret boyutu yok: sonucun ölçeği olmaz.</translation>
    </message>
    <message>
      <source>Sheet under the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaların altındaki sayfa</translation>
    </message>
    <message>
      <source>Sheet (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfa (*.json)</translation>
    </message>
    <message>
      <source>Front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ön yüz</translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz</translation>
    </message>
    <message>
      <source>The series is divided where the sherds were turned over.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Dizi, parçaların çevrildiği yerde bölündü.</translation>
    </message>
    <message>
      <source>Sheet: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sayfa: %1</translation>
    </message>
    <message>
      <source>%1: none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: yok</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n photograph(s), %2 to %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: %n fotoğraf, %2 – %3</numerusform>
      </translation>
    </message>
    <message>
      <source>The marker size is proposed from the last import: check it with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İşaret boyutu son içe aktarmadan önerildi: cetvelle denetleyin.</translation>
    </message>
    <message>
      <source>Choose back folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Arka yüz klasörünü seç…</translation>
    </message>
    <message>
      <source>A folder that holds both sides is split where the sherds were turned over; the folder of the back photographs replaces the split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki yüzü de içeren klasör, parçaların çevrildiği yerde bölünür; arka yüz klasörü bu bölmenin yerini alır</translation>
    </message>
    <message>
      <source>No pause stands out between the photographs. Where the two pictures beside the division show the sherds before and after they were turned over, divide here; else move the slider, or choose the folder of the back photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Fotoğraflar arasında belirgin bir ara yok. Bölmenin yanındaki iki resim parçaları çevrilmeden önce ve sonra gösteriyorsa buradan bölün; değilse sürgüyü kaydırın ya da arka yüz fotoğraflarının klasörünü seçin.</translation>
    </message>
    <message>
      <source>Divide here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Buradan böl</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueRepair</name>
    <message>
        <source>It is whole; nothing was changed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sağlam; hiçbir şey değiştirilmedi.</translation>
    </message>
    <message>
        <source>Nothing in the damaged file could be read: it is that of %1 again. Look what is missing since.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bozuk dosyada hiçbir şey okunamadı: yine %1 içindeki geçerli. O zamandan beri neyin eksik olduğuna bakın.</translation>
    </message>
    <message>
        <source>An earlier repair was interrupted and is now finished. Check the catalogue for missing changes.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Önceki bir onarım yarıda kalmıştı ve şimdi tamamlandı. Katalogda eksik değişiklik olup olmadığını denetleyin.</translation>
    </message>
    <message>
        <source>Everything in it is as it was.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>İçindeki her şey eskisi gibi.</translation>
    </message>
    <message>
        <source>All %1 rows stand in %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 satırın tümü %2 içinde.</translation>
    </message>
    <message>
        <source>The damaged file is kept: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bozuk dosya saklandı: %1</translation>
    </message>
    <message>
        <source>Another window has this project open: close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Bu proje başka bir pencerede açık: orada kapatıp sonra onarın.</translation>
    </message>
    <message>
        <source>The catalogue is being repaired …</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Katalog onarılıyor …</translation>
    </message>
    <message>
        <source>The catalogue could not be repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Katalog onarılamadı.</translation>
    </message>
    <message>
        <source>The catalogue is repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Katalog onarıldı.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeDialog</name>
    <message>
      <source>Merge another project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Başka bir projeyi birleştir</translation>
    </message>
    <message>
      <source>Conflicts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Çelişkiler</translation>
    </message>
    <message>
      <source>Record</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kayıt</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Alan</translation>
    </message>
    <message>
      <source>This project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje</translation>
    </message>
    <message>
      <source>Other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öteki proje</translation>
    </message>
    <message>
      <source>Decision</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Karar</translation>
    </message>
    <message>
      <source>New number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni numara</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Geri al</translation>
    </message>
    <message>
      <source>All open ones: this project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık olanların hepsi: bu proje</translation>
    </message>
    <message>
      <source>Choose project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Proje seç …</translation>
    </message>
    <message>
      <source>Progress of the merge</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birleştirmenin ilerlemesi</translation>
    </message>
    <message>
      <source>Folder of the other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öteki projenin klasörü</translation>
    </message>
    <message>
      <source>New number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni numara %1</translation>
    </message>
    <message>
      <source>Open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık</translation>
    </message>
    <message>
      <source>What the other project holds comes into this one; the other one is only read. Nothing changes before you merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öteki projede ne varsa bu projeye gelir; öteki proje yalnızca okunur. Birleştirmeden önce hiçbir şey değişmez.</translation>
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
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal</translation>
    </message>
    <message numerus="yes">
      <source>%n conflict(s) to settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n çelişki çözülecek</numerusform>
      </translation>
    </message>
    <message>
      <source>Merge project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projeyi birleştir</translation>
    </message>
    <message>
      <source>New number:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni numara:</translation>
    </message>
    <message>
      <source>New number of the record that does not keep it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Numarayı korumayan kaydın yeni numarası</translation>
    </message>
    <message>
      <source>Sherds with a new number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeni numaralı parçalar</translation>
    </message>
    <message>
      <source>Copy list</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Listeyi kopyala</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki parça: bu projeninki numarayı korur, öteki %1 alır</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki parça: bu projeninki numarayı korur, öteki yeni numara alır</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki parça: öteki numarayı korur, bu projeninki %1 alır</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki parça: öteki numarayı korur, bu projeninki yeni numara alır</translation>
    </message>
    <message>
      <source>One sherd: both records become one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tek parça: iki kayıt bir olur</translation>
    </message>
    <message>
      <source>Open; new number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Açık; yeni numara: %1</translation>
    </message>
    <message>
      <source>One sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Tek parça</translation>
    </message>
    <message>
      <source>This project; the other sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu proje; öteki parça: %1</translation>
    </message>
    <message>
      <source>Other project; this sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öteki proje; bu parça: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeModel</name>
    <message>
      <source>Sherds: %1. Batches: %2. Changed records: %3. Files: %4 (%5).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parça: %1. Parti: %2. Değişen kayıt: %3. Dosya: %4 (%5).</translation>
    </message>
    <message>
      <source>Comparing…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Karşılaştırılıyor …</translation>
    </message>
    <message>
      <source>Merged %1. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 birleştirildi. %2</translation>
    </message>
    <message>
      <source>This project already has everything that the other one holds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öteki projede ne varsa bu projede zaten var.</translation>
    </message>
    <message>
      <source>Batches that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Burada başka numara alan partiler: %1</translation>
    </message>
    <message>
      <source>Sherds that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Burada başka numara alan parçalar: %1</translation>
    </message>
    <message numerus="yes">
      <source>Missing in the other project: %n file(s), %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Öteki projede %n dosya eksik: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İptal edildi. Hiçbir şey birleştirilmedi.</translation>
    </message>
    <message>
      <source>Nothing was merged yet: what you chose leads to further conflicts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Henüz hiçbir şey birleştirilmedi: seçtikleriniz yeni çelişkilere yol açıyor.</translation>
    </message>
    <message>
      <source>An earlier merge was interrupted and could not be completed here: %1. What lies there is kept; the other project&apos;s version was left out, or waits in the folder merge.partial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Önceki bir birleştirme yarıda kesildi ve burada tamamlanamadı: %1. Orada bulunan korunur; öteki projenin sürümü dışarıda bırakıldı ya da merge.partial klasöründe bekliyor.</translation>
    </message>
</context>
<context>
    <name>Verdicts</name>
    <message>
      <source>accepted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kabul edildi</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri çevrildi</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kenara ayrıldı</translation>
    </message>
    <message>
      <source>to be photographed again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yeniden çekilecek</translation>
    </message>
    <message>
      <source>merged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>birleştirildi</translation>
    </message>
    <message>
      <source>split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>bölündü</translation>
    </message>
    <message>
      <source>withdrawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>geri alındı</translation>
    </message>
    <message>
      <source>pair of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 için eş</translation>
    </message>
    <message>
      <source>fragments: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>kırık parçalar: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateScreen</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parti</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NoBatchYet</name>
    <message>
        <source>Capture a batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Parti çek</translation>
    </message>
    <message>
      <source>Show the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Sırayı göster</translation>
    </message>
    <message>
      <source>%1 is in the queue; its results appear here when it is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 sırada; sonuçları işlendiğinde burada görünür.</translation>
    </message>
    <message>
      <source>%1 could not be processed; the queue says why.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 işlenemedi; nedeni sırada yazar.</translation>
    </message>
</context>
<context>
    <name>Outside</name>
    <message>
      <source>No program was found that opens %1. It is there: open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 öğesini açacak bir program bulunamadı. Dosya yerinde: elle açın.</translation>
    </message>
    <message>
      <source>Opening %1. If it does not appear, open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 açılıyor. Görünmezse elle açın.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MarkerSide</name>
    <message>
      <source>Marker side of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 için işaret kenarı</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s black square, mm. The batch is reprocessed with this size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir işaretin siyah karesinin kenarı, mm. Parti bu boyutla yeniden işlenir.</translation>
    </message>
    <message>
      <source>marker side typed anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>işaret kenarı yeniden yazıldı</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PrintSheetButton</name>
    <message>
        <source>Print a sheet…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Sayfa yazdır…</translation>
    </message>
    <message>
        <source>Markers around the sherds give photographs taken by hand their scale</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Parçaların çevresindeki işaretler, elde çekilen fotoğraflara ölçeğini verir</translation>
    </message>
    <message>
        <source>Print it at 100 %, not fitted to the page, and measure the bar of the second page: it must be %1 mm long. The next import proposes this sheet. If the bar is not %1 mm long, choose Clear sheet there and type the measured side of a black square.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Onu sayfaya sığdırmadan, % 100 boyutta yazdırın ve ikinci sayfadaki çubuğu ölçün: uzunluğu %1 mm olmalıdır. Bir sonraki içe aktarma bu sayfayı önerir. Çubuğun uzunluğu %1 mm değilse orada “Sayfayı kaldır” seçeneğini seçin ve bir siyah karenin ölçülen kenarını yazın.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SurfaceChoice</name>
    <message>
      <source>Shaded form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Gölgeli biçim</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Boya ve astarla</translation>
    </message>
    <message>
      <source>Orthophoto, %1 dpi</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ortofoto, %1 dpi</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectCare</name>
    <message numerus="yes">
      <source>%n file(s) of this project are missing or were changed, first %1. Put them back from a copy; &apos;ostraka catalogue check&apos; lists all of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Bu projenin %n dosyası eksik ya da değiştirilmiş, ilki %1. Bir kopyadan geri koyun; &apos;ostraka catalogue check&apos; hepsini listeler.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MunsellLine</name>
    <message>
      <source>Rough: no usable colour chart in these photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kabaca: bu fotoğraflarda kullanılabilir bir renk kartı yok.</translation>
    </message>
    <message>
      <source>Measured by the colour chart (Delta E 2000: median %1, 95 % %2).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renk kartıyla ölçüldü (Delta E 2000: ortanca %1, 95 % %2).</translation>
    </message>
    <message>
      <source>Take over</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kullan</translation>
    </message>
    <message>
      <source>Proposed: %1 (Delta E 2000: %2), then %3 (%4). %5</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Öneri: %1 (Delta E 2000: %2), sonra %3 (%4). %5</translation>
    </message>
    <message>
      <source>Take over %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 kullan</translation>
    </message>
    <message>
      <source>Of the side that was photographed first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İlk fotoğraflanan yüzün.</translation>
    </message>
    <message>
      <source>Of the side that was photographed second.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İkinci fotoğraflanan yüzün.</translation>
    </message>
    <message>
      <source>Measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ölçüldü.</translation>
    </message>
    <message>
      <source>No colours proposed: the model has no texture from photographs, or an earlier version of the program made it. Reprocess its batch to get proposals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Renk önerilmiyor: modelin fotoğraflardan dokusu yok ya da onu programın daha eski bir sürümü yaptı. Öneri almak için partisini yeniden işleyin.</translation>
    </message>
    <message>
      <source>Rough estimate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kaba tahmin.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CompareWindow</name>
    <message>
      <source>only one entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>yalnız birinde girilmiş</translation>
    </message>
    <message>
      <source>differs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>farklı</translation>
    </message>
    <message>
      <source>differs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>farklı: %1</translation>
    </message>
    <message>
      <source>%1, within the uncertainty</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, belirsizlik içinde</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message>
      <source>Compare sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçaları karşılaştır</translation>
    </message>
    <message>
      <source>Turn &amp;together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Birlikte döndür</translation>
    </message>
    <message>
      <source>Off: each sherd is turned alone, until both lie alike. The scale stays the same.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kapalı: her parça, ikisi aynı yönde durana dek tek başına döndürülür. Ölçek aynı kalır.</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kesit</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Üstten</translation>
    </message>
    <message>
      <source>Fields and measurements of both sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İki parçanın alanları ve ölçüleri</translation>
    </message>
    <message>
      <source>Model of %1; the arrow keys turn it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 modeli; ok tuşları onu döndürür</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>alan</translation>
    </message>
    <message>
      <source>difference</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>fark</translation>
    </message>
    <message numerus="yes">
      <source>%n field(s) differ.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%n alan farklı.</numerusform>
        </translation>
    </message>
    <message>
      <source>The two are recorded as joining.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>İkisi birleşiyor olarak kayıtlı.</translation>
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
      <translation>Yerleri yeniden adlandır</translation>
    </message>
    <message>
      <source>Choose the place that was typed wrongly and enter its right name. If that place exists already, both become one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yanlış yazılan yeri seçin ve doğru adını girin. Bu yer zaten varsa ikisi tek yer olur.</translation>
    </message>
    <message>
      <source>Places of the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Projenin yerleri</translation>
    </message>
    <message>
      <source>Place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yer</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Parçalar</translation>
    </message>
    <message>
      <source>Right name of the place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yerin doğru adı</translation>
    </message>
    <message>
      <source>Rename</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden adlandır</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Kapat</translation>
    </message>
    <message>
      <source>Right &amp;name:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Doğru &amp;ad:</translation>
    </message>
    <message numerus="yes">
      <source>%n context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n kontekst</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n bag(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n torba</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parti</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça</numerusform>
      </translation>
    </message>
    <message>
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>hiçbir şey</translation>
    </message>
    <message>
      <source>%1 exists already. Join with it? What is in %2 comes to %1: %3. %1 keeps its own description, and %2 is not listed any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 zaten var. Onunla birleştirilsin mi? %2 içindekiler %1 içine geçer: %3. %1 kendi tanımını korur, %2 artık listelenmez.</translation>
    </message>
    <message>
      <source>In this place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bu yerde: %1.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep the number that is written on them; new numbers go on behind these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n parça üzerinde yazan numarayı korur; yeni numaralar bunların ardından gelir.</numerusform>
      </translation>
    </message>
    <message>
      <source>Join places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yerleri birleştir</translation>
    </message>
    <message>
      <source>join %1 with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ile %2 birleştirme</translation>
    </message>
    <message>
      <source>rename %1 to %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 adını %2 yapma</translation>
    </message>
    <message>
      <source>Joined: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Birleştirildi: %1 artık %2.</translation>
    </message>
    <message>
      <source>Renamed: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Yeniden adlandırıldı: %1 artık %2.</translation>
    </message>
    <message>
      <source>A site gets another code in the settings, under Open project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Bir alan, ayarlarda “Açık proje” altında başka bir kod alır.</translation>
    </message>
</context>
</TS>
