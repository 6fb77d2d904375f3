<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hy" sourcelanguage="en">
  <context>
    <name>ComputeBatch</name>
    <message>
      <source>The disk has only %1 MB left; a batch needs more. Nothing is lost: make room, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոշտ սկավառակի վրա մնացել է միայն %1 ՄԲ. խմբաքանակին ավելին է պետք։ Ոչինչ չի կորել. տեղ ազատեք և շարունակեք։</translation>
    </message>
    <message>
      <source>%1: this number was typed on the plate, but no sherd with a context lies there; give it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. այս համարը մուտքագրվել էր սկավառակի վրա, բայց այնտեղ համատեքստով խեցաբեկոր չկա. տվեք այն կատալոգում։</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) were counted on the plate, and another number was found; look at the map for one that is missing or cut in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Սկավառակի վրա հաշվվել է %n խեցաբեկոր, իսկ գտնվել է այլ թիվ. քարտեզի վրա փնտրեք բացակայողը կամ երկու մասի բաժանվածը։</numerusform>
        <numerusform>Սկավառակի վրա հաշվվել է %n խեցաբեկոր, իսկ գտնվել է այլ թիվ. քարտեզի վրա փնտրեք բացակայողը կամ երկու մասի բաժանվածը։</numerusform>
      </translation>
    </message>
    <message>
      <source>Pairs were decided while the batch was computed; compute it again for them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգեր որոշվեցին, մինչ խմբաքանակը հաշվարկվում էր. նորից հաշվարկեք այն դրանց համար։</translation>
    </message>
  </context>
  <context>
    <name>Fields</name>
    <message>
      <source>number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համար</translation>
    </message>
    <message>
      <source>identifier</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նույնացուցիչ</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վիճակ</translation>
    </message>
    <message>
      <source>void because</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անվավեր է, քանի որ</translation>
    </message>
    <message>
      <source>site</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հուշարձան</translation>
    </message>
    <message>
      <source>trench</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>խրամատ</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համատեքստ</translation>
    </message>
    <message>
      <source>bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տոպրակ</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մաս</translation>
    </message>
    <message>
      <source>ware</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>խեցեղենի տեսակ</translation>
    </message>
    <message>
      <source>fabric</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կավազանգված</translation>
    </message>
    <message>
      <source>inclusions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>խառնուրդներ</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատրաստում</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>թրծում</translation>
    </message>
    <message>
      <source>surface outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>արտաքին մակերես</translation>
    </message>
    <message>
      <source>surface inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ներքին մակերես</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զարդ</translation>
    </message>
    <message>
      <source>Munsell outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell՝ դրսից</translation>
    </message>
    <message>
      <source>Munsell inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell՝ ներսից</translation>
    </message>
    <message>
      <source>Munsell core</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell՝ միջուկ</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պահպանվածություն</translation>
    </message>
    <message>
      <source>joins with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կցվում է</translation>
    </message>
    <message>
      <source>vessel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անոթ</translation>
    </message>
    <message>
      <source>period</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>շրջան</translation>
    </message>
    <message>
      <source>date</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>թվագրում</translation>
    </message>
    <message>
      <source>length, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>երկարություն, mm</translation>
    </message>
    <message>
      <source>width, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>լայնություն, mm</translation>
    </message>
    <message>
      <source>thickness least, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նվազագույն հաստություն, mm</translation>
    </message>
    <message>
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հաստություն, mm</translation>
    </message>
    <message>
      <source>thickness most, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առավելագույն հաստություն, mm</translation>
    </message>
    <message>
      <source>area, mm²</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մակերես, mm²</translation>
    </message>
    <message>
      <source>volume, mm³</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ծավալ, mm³</translation>
    </message>
    <message>
      <source>not seen, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>չերևացած, %</translation>
    </message>
    <message>
      <source>rim diameter, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>շուրթի տրամագիծ, mm</translation>
    </message>
    <message>
      <source>rim kept, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>շուրթի պահպանված մաս, %</translation>
    </message>
    <message>
      <source>weight, g</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>քաշ, g</translation>
    </message>
    <message>
      <source>batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>խմբաքանակ</translation>
    </message>
    <message>
      <source>note</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նշում</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մասշտաբ</translation>
    </message>
  </context>
  <context>
    <name>Job</name>
    <message>
      <source>The memory does not suffice; close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հիշողությունը չի բավականացնում. փակեք այլ ծրագրեր և փորձեք կրկին։</translation>
    </message>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա ծրագրի սխալ է. խնդրում ենք հայտնել մատյանի հետ (%1)։</translation>
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
    <message>
      <source>site %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հնավայր %1</translation>
    </message>
    <message>
      <source>trench %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>խրամատ %1</translation>
    </message>
    <message>
      <source>context %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համատեքստ %1</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տոպրակ %1</translation>
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
    <message>
      <source>more candidates for doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>այլ թեկնածուներ կասկածելի զույգերի համար</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համարակալված</translation>
    </message>
    <message>
      <source>void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անվավեր</translation>
    </message>
    <message>
      <source>draft</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սևագիր</translation>
    </message>
    <message>
      <source>on a scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կշեռքով</translation>
    </message>
    <message>
      <source>with a calliper</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ձողկարկինով</translation>
    </message>
    <message>
      <source>estimated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գնահատված</translation>
    </message>
    <message>
      <source>by the program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ծրագրի կողմից</translation>
    </message>
    <message>
      <source>aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մի կողմ</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կրկին</translation>
    </message>
    <message>
      <source>%1 or %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 կամ %2</translation>
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարն այլևս չկա։</translation>
    </message>
    <message>
      <source>The printer or file cannot be written; choose another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հնարավոր չէ գրել տպիչին կամ ֆայլի մեջ. ընտրեք ուրիշը։</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առջևի երես</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետևի երես</translation>
    </message>
    <message>
      <source>The printer took no further page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպիչն այլ էջ չընդունեց։</translation>
    </message>
    <message>
      <source>The printer or file could not be finished; is the disk full?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպումը կամ ֆայլը չավարտվեց. գուցե սկավառակը լի՞ է։</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3: their rims differ by %4 only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը և %2-ը երկուսն էլ հարմար են %3-ին. նրանց եզրերը տարբերվում են միայն %4-ով։</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը և %2-ը երկուսն էլ հարմար են %3-ին։</translation>
    </message>
    <message>
      <source>%1 would fit %2 nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը գրեթե նույնքան լավ կհարմարեր %2-ին։</translation>
    </message>
    <message>
      <source>Another partner fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ զույգ գրեթե նույնքան լավ է հարմարվում։</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նրա հետևի երեսը տրվել է ուրիշ առջևի երեսի. հիմա ճիշտը %1-ն է՞։</translation>
    </message>
    <message>
      <source>%1 fits hardly better than a stranger's back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը հազիվ է ավելի լավ հարմարվում, քան օտար բեկորի հետևի երեսը։</translation>
    </message>
    <message>
      <source>The two sides fit nearly as well in another position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու երեսները գրեթե նույնքան լավ են հարմարվում այլ դիրքում։</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>under 1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 %-ից պակաս</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>The back lies upside down: both sides face the same way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսը շրջված է. երկու երեսներն էլ նույն կողմն են նայում։</translation>
    </message>
    <message>
      <source>The faces cross: %1 of the front lies behind the back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երեսները հատվում են. առջևի երեսի %1-ը հետևի երեսից այն կողմ է։</translation>
    </message>
    <message>
      <source>The two scans share almost no broken edge; outlines alone tie them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու սկանները գրեթե չունեն ընդհանուր կոտրվածք. նրանց կապում են միայն ուրվագծերը։</translation>
    </message>
    <message>
      <source>The broken edges do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքները չեն համընկնում. հեռավորությունը %1 է։</translation>
    </message>
    <message>
      <source>The rim hardly fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրը հազիվ է որոշում դիրքը. անորոշությունը %1 է։</translation>
    </message>
    <message>
      <source>A place %1 along the rim fits nearly as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրով %1 հեռու մի տեղ գրեթե նույնքան լավ է հարմարվում։</translation>
    </message>
    <message>
      <source>The rims cannot be compared; outlines alone tie these sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրերը համեմատել հնարավոր չէ. այս երեսները կապում են միայն ուրվագծերը։</translation>
    </message>
    <message>
      <source>look</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նայել</translation>
    </message>
    <message>
      <source>no back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետևի երես չկա</translation>
    </message>
    <message>
      <source>sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վստահ</translation>
    </message>
    <message>
      <source>decided</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>որոշված</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մի կողմ դրված</translation>
    </message>
    <message>
      <source>shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կրկին նկարել</translation>
    </message>
    <message>
      <source>%1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 – %2</translation>
    </message>
    <message>
      <source>No back was found for it. Choose one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երես չգտնվեց։ Ընտրեք մեկը կամ բեկորը մի կողմ դրեք։</translation>
    </message>
    <message>
      <source>The program is sure: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ծրագիրը վստահ է՝ %1։</translation>
    </message>
    <message>
      <source>Decided by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշել է %1-ը, %2։</translation>
    </message>
    <message>
      <source>Set aside by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի կողմ է դրել %1-ը, %2։</translation>
    </message>
    <message>
      <source>To be shot again, says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պետք է կրկին նկարել, ասում է %1-ը, %2։</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տոպրակ %1</translation>
    </message>
    <message>
      <source>no front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առջևի երես չկա</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս հետևի երեսը մի կողմ է դրված։ Այնուամենայնիվ օգտագործելու համար քաշեք այն առջևի երեսի վրա։</translation>
    </message>
    <message>
      <source>This back is to be shot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս հետևի երեսը պետք է կրկին նկարել։</translation>
    </message>
    <message>
      <source>No front holds this back. Drag it onto its front, join it to another, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի առջևի երես այս հետևի երեսը չունի։ Քաշեք այն իր առջևի երեսի վրա, միացրեք մյուսին կամ մի կողմ դրեք։</translation>
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
        <numerusform>%1՝ %n բեկորից</numerusform>
        <numerusform>%1՝ %n բեկորից</numerusform>
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
      <translation>կասկածելի</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր</numerusform>
        <numerusform>%n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>Its back %1 was given to %2: is %3 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նրա հետևի երեսը՝ %1, տրվել է %2-ին. հիմա ճիշտը %3-ն է՞։</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2. Choose another one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նրա հետևի երեսը՝ %1, տրվել է %2-ին։ Ընտրեք ուրիշը կամ բեկորը մի կողմ դրեք։</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2; next best %3, %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նրա հետևի երեսը՝ %1, տրվել է %2-ին. հաջորդ լավագույնը %3-ն է, %4։</translation>
    </message>
    <message>
      <source>Decided by %1 on %2, turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշել է %1-ը, %2, ձեռքով շրջված։</translation>
    </message>
    <message>
      <source>The rims hardly meet: %1 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրերը հազիվ են հանդիպում՝ %1-ը։</translation>
    </message>
    <message>
      <source>by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ձեռքով</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկզբնակետ</translation>
    </message>
    <message>
      <source>settled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հարմարեցված</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջված է ձեռքով. հանդիպում է եզրերի %1-ը։</translation>
    </message>
    <message>
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջված է ձեռքով։</translation>
    </message>
    <message>
      <source>Another start point is tried: %1 of the rims meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է ուրիշ սկզբնակետ. հանդիպում է եզրերի %1-ը։</translation>
    </message>
    <message>
      <source>Another start point is tried.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է ուրիշ սկզբնակետ։</translation>
    </message>
    <message>
      <source>Settled by the rims: %1 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հարմարեցված է եզրերով. հանդիպում է %1-ը։</translation>
    </message>
    <message>
      <source>Settled by the rims.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հարմարեցված է եզրերով։</translation>
    </message>
    <message>
      <source>%1 is tried: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է %1-ը՝ %2։</translation>
    </message>
    <message>
      <source>%1 is tried: %2, rims %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է %1-ը՝ %2, եզրերի հեռավորությունը %3։</translation>
    </message>
    <message>
      <source>%1 is tried: %2; its rims do not meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է %1-ը՝ %2. եզրերը չեն հանդիպում։</translation>
    </message>
    <message>
      <source>%1 decided for %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը որոշել է %2-ը։</translation>
    </message>
    <message>
      <source>The program says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ծրագիրն ասում է %1, %2։</translation>
    </message>
    <message>
      <source>Joined with %1 by %2; it is one piece once the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2-ը միացրել է %1-ի հետ. մեկ կտոր կդառնա, երբ խմբաքանակը հաշվարկվի։</translation>
    </message>
    <message>
      <source>Cut in two by %1; its pieces come when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը կտրել է երկու մասի. կտորները կգան, երբ խմբաքանակը հաշվարկվի։</translation>
    </message>
    <message>
      <source>joined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>միացված</translation>
    </message>
    <message>
      <source>cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կտրված</translation>
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
      <translation>%1-ի ներմուծում</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատճենը հնարավոր չէ դնել իր տեղը՝ %1։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր, վստահ</numerusform>
        <numerusform>%n բեկոր, բոլորը վստահ</numerusform>
      </translation>
    </message>
    <message>
      <source>a draft: look, then compute it again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սևագիր. նայեք, ապա նորից հաշվեք</translation>
    </message>
    <message>
      <source>the scale is not right: see the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մասշտաբը ճիշտ չէ. տե՛ս զեկույցը</translation>
    </message>
    <message>
      <source>%1; joined to %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. միացված են %2 mm ճշտությամբ</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակ %1</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զգուշացում՝ %1</translation>
    </message>
    <message numerus="yes">
      <source>%1 is computed: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1-ը հաշվարկված է՝ %n բեկոր։</numerusform>
        <numerusform>%1-ը հաշվարկված է՝ %n բեկոր։</numerusform>
      </translation>
    </message>
    <message>
      <source>You stopped it. What was computed so far is kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք կանգնեցրիք։ Մինչև հիմա հաշվարկվածը պահվում է։</translation>
    </message>
    <message>
      <source>You took it out of the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք հանեցիք հերթից։</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կրկին</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) wait.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Դադար. սպասում է %n խմբաքանակ։</numerusform>
        <numerusform>Դադար. սպասում է %n խմբաքանակ։</numerusform>
      </translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1՝ դադար</translation>
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
    <message>
      <source>decided; to be computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>որոշված է. մնում է հաշվարկել</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր</numerusform>
        <numerusform>%n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>sure %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վստահ %1</translation>
    </message>
    <message>
      <source>decided %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>որոշված %1</translation>
    </message>
    <message>
      <source>ask %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կասկածելի %1</translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1. սակայն սկավառակի վրա հաշվվել է %n</numerusform>
        <numerusform>%1. սակայն սկավառակի վրա հաշվվել է %n</numerusform>
      </translation>
    </message>
    <message>
      <source>draft, to be computed again; %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սևագիր, պետք է նորից հաշվել. %1</translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը սպասում է %2-ի սևագրին։</translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the marks by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկը տեղաշարժվել է. վրիպում է նշաններից %2 px, տրամաչափման տեղից %3 մմ հեռու։</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի համար տեսախցիկները նորից գտնվել են. նորից տրամաչափեք սարքակազմը (C)։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BigButton</name>
    <message>
      <source>Key: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստեղն՝ %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BulkEdit</name>
    <message>
      <source>Field to change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոփոխվող դաշտ</translation>
    </message>
    <message>
      <source>New value for all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր արժեք բոլորի համար</translation>
    </message>
    <message>
      <source>new value; empty deletes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նոր արժեք. դատարկը ջնջում է</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկոր</translation>
    </message>
    <message>
      <source>now</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հիմա</translation>
    </message>
    <message>
      <source>then</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետո</translation>
    </message>
    <message>
      <source>What would change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ կփոխվեր</translation>
    </message>
    <message>
      <source>Change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոխել</translation>
    </message>
    <message>
      <source>Give numbers to the drafts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալել սևագրերը</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դաշտ</translation>
    </message>
    <message>
      <source>Value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արժեք</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ընտրված է %n բեկոր</numerusform>
        <numerusform>Ընտրված է %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>Type a value to see what would change.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրեք արժեք՝ տեսնելու, թե ինչ կփոխվի։</translation>
    </message>
    <message>
      <source>Preview of a change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոփոխության նախադիտում</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դեռ համար չկա</translation>
    </message>
    <message>
      <source>refused: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մերժված է՝ %1</translation>
    </message>
    <message>
      <source>%1 change, %2 stay as they are, %3 are refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը փոխվում է, %2-ը մնում է, %3-ը մերժվում է։</translation>
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Փոխել %n բեկոր</numerusform>
        <numerusform>Փոխել %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>Progress of the changes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոփոխությունների ընթացքը</translation>
    </message>
    <message>
      <source>Stop and take back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել և հետ վերցնել</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CandidateBar</name>
    <message>
      <source>Another back …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ հետևի երես …</translation>
    </message>
    <message>
      <source>rim %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>եզր %1</translation>
    </message>
    <message>
      <source>no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>եզր չկա</translation>
    </message>
    <message>
      <source>%1, with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, հիմա %2-ի հետ</translation>
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
      <translation>Թեկնածու %1՝ %2, %3, %4</translation>
    </message>
    <message>
      <source>%1, nobody's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ազատ</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureFoot</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացատ</translation>
    </message>
    <message>
      <source>Typed, from a code reader, or from the bag's label laid under the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպելով, կոդ կարդացողով կամ տեսախցիկի տակ դրված տոպրակի պիտակից</translation>
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
  </context>
  <context>
    <name>ostraka::ui::CaptureStation</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացատ</translation>
    </message>
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
      <translation>Կանգնեցնել</translation>
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
    <message>
      <source>%1 The desktop holds a camera, by its program %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Աշխատասեղանը պահում է տեսախցիկը իր %2 ծրագրով։</translation>
    </message>
    <message>
      <source>Type the sherds' numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մուտքագրել խեցաբեկորների համարները</translation>
    </message>
    <message>
      <source>Say how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ասել, թե քանի բեկոր կա</translation>
    </message>
    <message>
      <source>This project photographs with no calibrated rig of its own.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծը չունի սեփական տրամաչափված սարքակազմ։</translation>
    </message>
    <message>
      <source>The rig is calibrated by %1; the calibration before is kept as %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը տրամաչափված է ըստ %1-ի. նախորդը պահված է որպես %2։</translation>
    </message>
    <message>
      <source>The import is stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծումը կանգնեցված է. ոչինչ չի մնացել։</translation>
    </message>
    <message>
      <source>Import them all the same</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել այնուամենայնիվ</translation>
    </message>
    <message>
      <source>%1 has these files already; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն արդեն ունի այս ֆայլերը. ոչինչ չի ներմուծվել։</translation>
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
      <source>%1 may be two sherds, too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը գուցե իրար շատ մոտ երկու բեկոր է</translation>
    </message>
    <message>
      <source>%1 and %2 lie too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը և %2-ը շատ մոտ են իրար</translation>
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
    <message>
      <source>Read from the label: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարդացված է պիտակից՝ %1</translation>
    </message>
    <message>
      <source>No room for more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլևս տեղ չկա</translation>
    </message>
    <message numerus="yes">
      <source>Room for about %n more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Տեղ կա մոտ %n-ի համար</numerusform>
        <numerusform>Տեղ կա մոտ %n-ի համար</numerusform>
      </translation>
    </message>
    <message>
      <source>Looking for what holds the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոնվում է, թե ինչն է պահում տեսախցիկը</translation>
    </message>
    <message>
      <source>Making the desktop let go of the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աշխատասեղանը ազատում է տեսախցիկը</translation>
    </message>
    <message>
      <source>Make the desktop let go</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ազատել տեսախցիկը</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: look for one that hides, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք հաշվել եք %1 բեկոր, լուսանկարները ցույց են տալիս %2. փնտրեք մեկը, որ թաքնված է, դիպչում է մյուսին կամ չի դրվել։</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք հաշվել եք %1</translation>
    </message>
    <message>
      <source>Marks %1 of %2, %3 are needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշաններ՝ %1 %2-ից, պետք է %3</translation>
    </message>
    <message>
      <source>Its sherds stand in the review (Ctrl+3): look while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրա բեկորները ստուգման մեջ են (Ctrl+3). նայեք, քանի դեռ այստեղ են</translation>
    </message>
    <message>
      <source>The table stands still. What is safe is not photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը կանգնած է։ Ինչ պահպանված է, նորից չի լուսանկարվում։</translation>
    </message>
    <message>
      <source>Go on at stop %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շարունակել %1 կանգառից</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն ընդհատվել է այս կողմի կեսին։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CatalogueStation</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկորում փոխել՝ %1</numerusform>
        <numerusform>%n բեկորում փոխել՝ %1</numerusform>
      </translation>
    </message>
    <message>
      <source>Catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգ</translation>
    </message>
    <message>
      <source>Export these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանել սրանք</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեր սկզբնատառերը</translation>
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ո՞վ է աշխատում։ Ձեր սկզբնատառերը մտնում են պատմության մեջ.</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորներ</translation>
    </message>
    <message>
      <source>Search</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փնտրել</translation>
    </message>
    <message>
      <source>Edit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբագրել</translation>
    </message>
    <message>
      <source>Give numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալել</translation>
    </message>
    <message>
      <source>No sherds yet. They come by themselves when a batch is computed; start with Capture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ բեկորներ չկան։ Նրանք ինքնըստինքյան գալիս են, երբ խմբաքանակը հաշվարկվում է. սկսեք նկարահանումից։</translation>
    </message>
    <message>
      <source>No sherd fits. Take a condition away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի բեկոր չի համապատասխանում։ Հանեք մի պայման։</translation>
    </message>
    <message>
      <source>change %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխել՝ %1</translation>
    </message>
    <message>
      <source>move to another context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեղափոխել այլ համատեքստ</translation>
    </message>
    <message>
      <source>changes by the import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի ներմուծման փոփոխությունները</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը ներմուծված է՝ %2</translation>
    </message>
    <message>
      <source>Import …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել …</translation>
    </message>
    <message>
      <source>Numbers, contexts and descriptions from a table, or an export (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարներ, համատեքստեր և նկարագրություններ աղյուսակից կամ արտահանում (%1)</translation>
    </message>
    <message>
      <source>About what is chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրվածի մասին</translation>
    </message>
    <message>
      <source>Details</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մանրամասներ</translation>
    </message>
    <message>
      <source>Drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկար</translation>
    </message>
    <message>
      <source>Details or drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մանրամասներ կամ գծանկար</translation>
    </message>
    <message>
      <source>enter the rim's diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գրանցել շուրթի տրամագիծը</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծում</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի ներմուծումն ընդհատվել է %3 տողից %2-ից հետո. դրանք ամբողջական են: Մնացածի համար կրկին ներմուծեք:</translation>
    </message>
    <message>
      <source>Do not tell this again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլևս չհիշեցնել</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրեք այն բեկորները, որոնք պետք է համար ստանան։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::DrawingPage</name>
    <message>
      <source>Scale of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարի մասշտաբը</translation>
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
      <translation>Ինչպես են գծվում մակերեսները</translation>
    </message>
    <message>
      <source>Light and shade of the form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձևի լույս և ստվեր</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներկով և անգոբով</translation>
    </message>
    <message>
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյոք շուրթ է</translation>
    </message>
    <message>
      <source>As the parts say, or as is likely</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ըստ մասերի կամ ըստ հավանականության</translation>
    </message>
    <message>
      <source>It is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շուրթ է</translation>
    </message>
    <message>
      <source>It is no rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շուրթ չէ</translation>
    </message>
    <message>
      <source>Scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ</translation>
    </message>
    <message>
      <source>Surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մակերես</translation>
    </message>
    <message>
      <source>Rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շուրթ</translation>
    </message>
    <message>
      <source>Enter the diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրանցել տրամագիծը</translation>
    </message>
    <message>
      <source>Save …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել …</translation>
    </message>
    <message>
      <source>Print …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել …</translation>
    </message>
    <message>
      <source>Print the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել գծանկարը</translation>
    </message>
    <message>
      <source>Progress of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարի ընթացքը</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել</translation>
    </message>
    <message>
      <source>The sheet before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ թերթը</translation>
    </message>
    <message>
      <source>The next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդ թերթը</translation>
    </message>
    <message>
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ է ասում գծանկարը</translation>
    </message>
    <message>
      <source>Drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարներ</translation>
    </message>
    <message>
      <source>Stopped; nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցված է. ոչինչ չի գծվել։</translation>
    </message>
    <message>
      <source>A sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ թերթ</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Գծվում է %n բեկոր …</numerusform>
        <numerusform>Գծվում է %n բեկոր …</numerusform>
      </translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրեք բեկոր։</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: %2 to %3), %4 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բերանը %1 cm (95 %՝ %2-ից %3), պահպանված է շուրթի %4 %-ը։</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: above %2), %3 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բերանը %1 cm (95 %՝ %2-ից ավելի), պահպանված է շուրթի %3 %-ը։</translation>
    </message>
    <message>
      <source>%1 drawn, %2 left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը գծված է, %2-ը դուրս է թողնված։</translation>
    </message>
    <message numerus="yes">
      <source>Draw plates of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Գծել %n բեկորի աղյուսակներ</numerusform>
        <numerusform>Գծել %n բեկորի աղյուսակներ</numerusform>
      </translation>
    </message>
    <message>
      <source>Sheet %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թերթ %1՝ %2-ից</translation>
    </message>
    <message>
      <source>plates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>աղյուսակներ</translation>
    </message>
    <message>
      <source>Save the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել գծանկարը</translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, բոլոր թերթերը (*.pdf);;SVG, մեկ ֆայլ ամեն թերթի համար (*.svg)</translation>
    </message>
    <message>
      <source>Saving a drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարը պահվում է</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է՝ %1</translation>
    </message>
    <message>
      <source>Printing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպվում է</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարն ուղարկվում է տպիչին. տպեք 100 % չափով։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportModel</name>
    <message>
      <source>Size of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման չափը</translation>
    </message>
    <message>
      <source>Counting …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվում է …</translation>
    </message>
    <message>
      <source>No sherd fits; choose others.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի բեկոր չի համապատասխանում. ընտրեք ուրիշները։</translation>
    </message>
    <message>
      <source>less than a minute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մեկ րոպեից պակաս</translation>
    </message>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>մոտ %n րոպե</numerusform>
        <numerusform>մոտ %n րոպե</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր, %1 ֆայլ, %2, %3</numerusform>
        <numerusform>%n բեկոր, %1 ֆայլ, %2, %3</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>որից %n-ն առանց մոդելի</numerusform>
        <numerusform>որից %n-ն առանց մոդելի</numerusform>
      </translation>
    </message>
    <message>
      <source>There is a folder of this name already; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս անունով պանակ արդեն կա. ընտրեք այլ անուն։</translation>
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
        <numerusform>%1, մնաց %n վայրկյան</numerusform>
        <numerusform>%1, մնաց %n վայրկյան</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր, %1, ցուցակը ստուգված է</numerusform>
        <numerusform>%n բեկոր, %1, ցուցակը ստուգված է</numerusform>
      </translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանում</translation>
    </message>
    <message>
      <source>Stopped; nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցված է. ոչինչ չի մնացել։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ExportStation</name>
    <message>
      <source>Exported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանված է՝ %1</translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանում</translation>
    </message>
    <message>
      <source>What</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ</translation>
    </message>
    <message>
      <source>All sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բոլոր բեկորները</translation>
    </message>
    <message>
      <source>Those that fit this filter:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս զտիչին համապատասխանողները.</translation>
    </message>
    <message>
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանվողի զտիչ</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>context:0012</translation>
    </message>
    <message>
      <source>Forms</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձևեր</translation>
    </message>
    <message>
      <source>Tables (CSV), for spreadsheets</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակներ (CSV)՝ էլեկտրոնային աղյուսակների համար</translation>
    </message>
    <message>
      <source>Records (JSON), to be read back whole</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրառումներ (JSON)՝ ամբողջությամբ հետ կարդացվող</translation>
    </message>
    <message>
      <source>A picture of each model (PNG)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ամեն մոդելի մի պատկեր (PNG)</translation>
    </message>
    <message>
      <source>Models as PLY, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդելներ PLY ձևով, mm</translation>
    </message>
    <message>
      <source>Models as GLB, for the web and for slides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդելներ GLB ձևով՝ համացանցի և ցուցադրությունների համար</translation>
    </message>
    <message>
      <source>Models as OBJ, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդելներ OBJ ձևով, mm</translation>
    </message>
    <message>
      <source>The photographs, unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարները՝ անփոփոխ</translation>
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որտեղ</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր պանակ արտահանման համար</translation>
    </message>
    <message>
      <source>Choose …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել …</translation>
    </message>
    <message>
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման ընթացքը</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացել պանակը</translation>
    </message>
    <message>
      <source>Where shall the folder be?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որտե՞ղ լինի պանակը։</translation>
    </message>
    <message>
      <source>Those chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգում ընտրվածները</translation>
    </message>
    <message numerus="yes">
      <source>The %n chosen in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Կատալոգում ընտրված %n-ը</numerusform>
        <numerusform>Կատալոգում ընտրված %n-ը</numerusform>
      </translation>
    </message>
    <message>
      <source>Drawings for print (SVG and PDF)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծագրեր տպագրության համար (SVG և PDF)</translation>
    </message>
    <message>
      <source>Scale of the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծագրերի մասշտաբը</translation>
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
      <translation>ըստ A4-ի</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակներ (ODS)՝ LibreOffice, Excel</translation>
    </message>
    <message>
      <source>Pictures, masks, poses for COLMAP and OpenMVS</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերներ, դիմակներ, դիրքեր COLMAP-ի և OpenMVS-ի համար</translation>
    </message>
    <message>
      <source>Detail of the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդելների մանրամասնությունը</translation>
    </message>
    <message>
      <source>Of PLY, GLB and OBJ: with fewer triangles the files are a fraction as large. How far they are off is measured and stated in each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY, GLB և OBJ. քիչ եռանկյուններով նիշքերը շատ ավելի փոքր են։ Շեղումը չափվում և գրվում է յուրաքանչյուրում։</translation>
    </message>
    <message>
      <source>as computed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչպես հաշվարկվել է</translation>
    </message>
    <message>
      <source>lighter, to %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>թեթև, մինչև %1 մմ</translation>
    </message>
    <message>
      <source>Stop the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել արտահանումը</translation>
    </message>
    <message>
      <source>Export: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանում՝ %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FilterLine</name>
    <message>
      <source>Filter of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգի զտիչ</translation>
    </message>
    <message>
      <source>rim T3 thickness&gt;6</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rim T3 thickness&gt;6</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բառերը փնտրվում են ամենուր. գործում են նաև ware:grey, thickness&gt;6, -burnt, note:*։</translation>
    </message>
    <message>
      <source>Take away the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հանել %1 պայմանը</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր</numerusform>
        <numerusform>%n բեկոր</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::FooterLine</name>
    <message>
      <source>What the computer does</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ է անում համակարգիչը</translation>
    </message>
    <message>
      <source>What was done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ արվեց</translation>
    </message>
    <message>
      <source>Progress of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկի ընթացքը</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որտեղ</translation>
    </message>
    <message>
      <source>Rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմ</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեղ սկավառակի վրա</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեռնարկ</translation>
    </message>
    <message>
      <source>&amp;Contents</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Բովանդակություն</translation>
    </message>
    <message>
      <source>All &amp;keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բոլոր &amp;ստեղները</translation>
    </message>
    <message>
      <source>&amp;About</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Ծրագրի մասին</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերադառնալ աշխատանքին (Esc)</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բոլոր ստեղները</translation>
    </message>
    <message>
      <source>Complete, measured 3D models of potsherds from photographs of both their sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խեցաբեկորների ամբողջական, չափված եռաչափ մոդելներ՝ երկու երեսների լուսանկարներից։</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apache License 2.0։ Օգտագործում է, ի թիվս այլոց, Qt (LGPL 3), VTK և OpenCV. LICENSE ֆայլը և README-ն թվարկում են բոլորը։</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: there is no network in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ դուրս չի գալիս այս համակարգչից. այն ցանց չունի։</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեռնարկը միայն անգլերեն է։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportDialog</name>
    <message>
      <source>new</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նոր</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխված է</translation>
    </message>
    <message>
      <source>refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մերժված</translation>
    </message>
    <message>
      <source>as it is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչպես կա</translation>
    </message>
    <message>
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել կատալոգ</translation>
    </message>
    <message>
      <source>A table (CSV) …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակ (CSV) …</translation>
    </message>
    <message>
      <source>An export folder …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման պանակ …</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստեղծել դեռ չեղած հուշարձաններ, խրամատներ, համատեքստեր և տոպրակներ</translation>
    </message>
    <message>
      <source>What each row would do</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ կաներ ամեն տողը</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծման ընթացքը</translation>
    </message>
    <message>
      <source>Save what is refused …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել մերժվածը …</translation>
    </message>
    <message>
      <source>Which table?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ո՞ր աղյուսակը։</translation>
    </message>
    <message>
      <source>Tables (*.csv *.tsv *.txt);;All (*)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակներ (*.csv *.tsv *.txt);;Բոլորը (*)</translation>
    </message>
    <message>
      <source>Which export?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ո՞ր արտահանումը։</translation>
    </message>
    <message>
      <source>Save what is refused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել մերժվածը</translation>
    </message>
    <message>
      <source>refused.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>refused.csv</translation>
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակներ (*.csv)</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է՝ %1</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տող</translation>
    </message>
    <message>
      <source>what happens</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչ է լինում</translation>
    </message>
    <message>
      <source>why not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչու ոչ</translation>
    </message>
    <message>
      <source>A table of sherds has a column number or uuid; one of contexts has site, context and, if you like, trench and bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորների աղյուսակն ունի number կամ uuid սյունակ. համատեքստերինը՝ site, context և, եթե ցանկանում եք, trench և bag։</translation>
    </message>
    <message>
      <source>Looking at it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիտվում է …</translation>
    </message>
    <message>
      <source>Entered: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրանցված է՝ %1</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փակել</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել</translation>
    </message>
    <message>
      <source>Take nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ չվերցնել</translation>
    </message>
    <message numerus="yes">
      <source>Enter %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Գրանցել %n տող</numerusform>
        <numerusform>Գրանցել %n տող</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 «%2»՝ %3</translation>
    </message>
    <message>
      <source>Preview of an import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծման նախադիտում</translation>
    </message>
    <message>
      <source>%1 new, %2 changed, %3 as they are, %4 refused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 նոր, %2 փոխված, %3 ինչպես կան, %4 մերժված։</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծում</translation>
    </message>
    <message>
      <source>Stopped; nothing was entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցված է. ոչինչ չի գրանցվել։</translation>
    </message>
    <message numerus="yes">
      <source>Stopped: %n row(s) are not entered. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Կանգնեցված է. %n տող մուտքագրված չէ: Մնացածի համար կրկին ներմուծեք աղյուսակը:</numerusform>
        <numerusform>Կանգնեցված է. %n տող մուտքագրված չէ: Մնացածի համար կրկին ներմուծեք աղյուսակը:</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::JoinMode</name>
    <message>
      <source>Which back belongs to the one of %1? Choose its card (arrows and Enter).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ո՞ր հետևի երեսն է %1-ի հետևի երեսինը։ Ընտրեք նրա քարտը (սլաքներ և Enter)։</translation>
    </message>
    <message>
      <source>Which front belongs to the one of %1? Choose its card (arrows and Enter); a click on a back's picture joins the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ո՞ր առջևի երեսն է %1-ի առջևի երեսինը։ Ընտրեք նրա քարտը (սլաքներ և Enter). սեղմումը հետևի երեսի պատկերին միացնում է հետևի երեսները։</translation>
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
      <translation>%1-ը հաշվարկված է։</translation>
    </message>
    <message>
      <source>%1 stopped: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը կանգնեց՝ %2</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեռնարկ</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բոլոր ստեղները</translation>
    </message>
    <message>
      <source>Other projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ նախագծեր</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերադառնալ գործին</translation>
    </message>
    <message>
      <source>This project is open in another window already: go on there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծն արդեն բաց է մեկ այլ պատուհանում. շարունակեք այնտեղ։</translation>
    </message>
    <message>
      <source>%1 - Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 - Ostraka</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիրտուալ սարքակազմ</translation>
    </message>
    <message>
      <source>Virtual rig %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիրտուալ սարքակազմ %1</translation>
    </message>
    <message>
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ամենուր</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեղ սկավառակի վրա</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկը կանգնեցվում է. կշարունակվի, երբ նախագիծը նորից բացվի։ Պատուհանը շուտով կփակվի։</translation>
    </message>
    <message>
      <source>Queue: mending masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հերթ. դիմակների ուղղում</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետարկել՝ %1</translation>
    </message>
    <message>
      <source>Do again: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կրկնել՝ %1</translation>
    </message>
    <message>
      <source>Copy of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգի պատճեն</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգը չհաջողվեց պատճենել. %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակ</translation>
    </message>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել քարտեզն ու պիտակները</translation>
    </message>
    <message>
      <source>Print map and labels   Ctrl+P</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել քարտեզն ու պիտակները   Ctrl+P</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկոր %1</translation>
    </message>
    <message>
      <source>No batch is computed yet; its map appears here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ ոչ մի խմբաքանակ հաշվարկված չէ. նրա քարտեզը կերևա այստեղ։</translation>
    </message>
    <message>
      <source>Map of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի քարտեզ</translation>
    </message>
    <message>
      <source>%1-%2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-%2</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակ %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակ %1, %2</translation>
    </message>
    <message>
      <source>Map and labels are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Քարտեզն ու պիտակներն ուղարկվում են տպիչին։</translation>
    </message>
    <message>
      <source>Map</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Քարտեզ</translation>
    </message>
    <message>
      <source>Print bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել տոպրակների պիտակները</translation>
    </message>
    <message>
      <source>Bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակների պիտակներ</translation>
    </message>
    <message>
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել պիտակ յուրաքանչյուր տոպրակի համար. դրա կոդը խմբաքանակին տալիս է համատեքստը (Ctrl+Shift+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ տոպրակ չկա. մուտքագրեք նկարահանման ժամանակ կամ ներմուծեք համատեքստերի աղյուսակ:</translation>
    </message>
    <message numerus="yes">
      <source>%n label(s) are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n պիտակ ուղարկվել է տպիչին:</numerusform>
        <numerusform>%n պիտակ ուղարկվել է տպիչին:</numerusform>
      </translation>
    </message>
    <message>
      <source>This batch was scanned, not photographed: there is no picture of its plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը սքանավորվել է, ոչ թե լուսանկարվել. նրա սկավառակի պատկեր չկա։</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Այս խմբաքանակի %n բեկորը դեռ համար չունի. նրա պիտակը նշում է խմբաքանակը։</numerusform>
        <numerusform>Այս խմբաքանակի %n բեկորը դեռ համար չունի. նրանց պիտակները նշում են խմբաքանակը։</numerusform>
      </translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանված է՝ %1</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը՝ առջևից և հետևից</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկոր %1</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առջևի երես</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետևի երես</translation>
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
    <name>ostraka::ui::ModelPane</name>
    <message>
      <source>Picture of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորի պատկերը</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կտրվածք</translation>
    </message>
    <message>
      <source>Cut the model open; Shift and the wheel move the plane</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կտրել մոդելը. Shift-ը և անիվը շարժում են հարթությունը</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերևից</translation>
    </message>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորի պատկեր</translation>
    </message>
    <message>
      <source>Model of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորի մոդել</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site's code has two to eight capital letters and digits, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձանի ծածկագիրը երկուսից ութ մեծատառ և թվանշան ունի, ինչպես ARM1։</translation>
    </message>
    <message>
      <source>Choose a folder for the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրեք պանակ նախագծի համար։</translation>
    </message>
    <message>
      <source>There is a project in this folder already: open it, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում արդեն նախագիծ կա. բացեք այն կամ ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>This folder holds other files: choose a new one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում այլ ֆայլեր կան. ընտրեք նորը։</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիրտուալ սարքակազմ</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::OutlinePlot</name>
    <message>
      <source>Outlines laid over each other, and their turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Իրար վրա դրված ուրվագծեր և նրանց շրջադարձի անկյունները</translation>
    </message>
    <message>
      <source>The turning angles differ by %1 rad.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջադարձի անկյունները տարբերվում են %1 rad։</translation>
    </message>
    <message>
      <source>outlines on each other</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ուրվագծերն իրար վրա</translation>
    </message>
    <message>
      <source>turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>շրջադարձի անկյուններ</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>differ by %1 rad</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տարբերություն՝ %1 rad</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PairReviewModel</name>
    <message>
      <source>Small pictures of the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորների փոքր պատկերներ</translation>
    </message>
    <message>
      <source>%1, %2. %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2. %3</translation>
    </message>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երես ընտրված չէ։</translation>
    </message>
    <message>
      <source>The rims do not meet here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրերն այստեղ չեն հանդիպում։</translation>
    </message>
    <message>
      <source>Rims %1 apart, %2 of them meet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրերի հեռավորությունը %1, հանդիպում է %2-ը։</translation>
    </message>
    <message>
      <source>Turned by hand; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջված է ձեռքով. B-ն թողնում է, որ եզրերը հարմարեցնեն։</translation>
    </message>
    <message>
      <source>Start point %1; B lets the rims settle it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկզբնակետ %1. B-ն թողնում է, որ եզրերը հարմարեցնեն։</translation>
    </message>
    <message>
      <source>Choose a back first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ ընտրեք հետևի երես։</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ գրեք ձեր սկզբնատառերը. ամեն որոշում պահում է իր անունը։</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի ընտրություն</translation>
    </message>
    <message>
      <source>Comparing two sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու երես համեմատվում են</translation>
    </message>
    <message>
      <source>pair %1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զույգ %1 – %2</translation>
    </message>
    <message>
      <source>setting aside %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը մի կողմ դնել</translation>
    </message>
    <message>
      <source>shooting %1 again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի կրկին նկարում</translation>
    </message>
    <message>
      <source>One of the two has no back to be joined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկուսից մեկը միացնելու հետևի երես չունի։</translation>
    </message>
    <message>
      <source>joining %1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի և %2-ի միացում</translation>
    </message>
    <message>
      <source>cutting %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի կտրում</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկզբնակետ</translation>
    </message>
    <message>
      <source>settling by the rims</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հարմարեցում եզրերով</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ձեռքով շրջում</translation>
    </message>
    <message>
      <source>Closed model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փակ մոդել</translation>
    </message>
    <message>
      <source>This pair has no closed model yet; it is made when the batch is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս զույգը դեռ փակ մոդել չունի. այն ստեղծվում է խմբաքանակը հաշվարկելիս։</translation>
    </message>
    <message>
      <source>Picture of a pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգի պատկեր</translation>
    </message>
    <message>
      <source>More candidates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ թեկնածուներ</translation>
    </message>
    <message>
      <source>This back lies alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս հետևի երեսը մենակ է։</translation>
    </message>
    <message>
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգ ընտրված չէ. նախ այս հետևի երեսը տվեք առջևի երեսի։</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միայնակ հետևի երեսը փակ մոդել չունի։</translation>
    </message>
    <message>
      <source>Stopped; the back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցված է. հետևի կողմը մնում է իր տեղում։</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ միայն փորձարկվել էր, այլևս չկա. դրա զույգերը փակվել են։</translation>
    </message>
    <message>
      <source>Saved, with your name; but the rims of %1 and %2 hardly meet: %3 of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է ձեր անունով, բայց %1-ի և %2-ի եզրերը հազիվ են հանդիպում՝ %3-ը։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու երեսների լուսանկարները</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջև %1, հետև %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարը չկա։</translation>
    </message>
    <message>
      <source>front %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առջև %1</translation>
    </message>
    <message>
      <source>back %1, mirrored</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետև %1, հայելային</translation>
    </message>
    <message>
      <source>back %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետև %1</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Line over the %1, %2 steps from its middle, turned by %3 degrees</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գիծ %1 վրա, մեջտեղից %2 քայլ, թեքված %3 աստիճանով</translation>
    </message>
    <message>
      <source>Arrows move the line, with Shift they turn it, Up or Down takes the other side, Enter cuts. Or draw a line with the mouse.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սլաքները տեղաշարժում են գիծը, Shift-ի հետ՝ թեքում, Վերև կամ Ներքև՝ մյուս կողմը, Enter՝ կտրում է: Կամ մկնիկով գիծ քաշեք:</translation>
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
    <message>
      <source>New: %1 (Esc takes it back)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր՝ %1 (Esc-ը հետ է վերցնում)</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկել կրկին</translation>
    </message>
    <message>
      <source>Stop this batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել այս խմբաքանակը</translation>
    </message>
    <message>
      <source>Report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվետվություն</translation>
    </message>
    <message>
      <source>Review it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգել այն</translation>
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մատյան</translation>
    </message>
    <message>
      <source>Batches</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակներ</translation>
    </message>
    <message>
      <source>Log of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկի մատյան</translation>
    </message>
    <message>
      <source>No batch yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ խմբաքանակ չկա</translation>
    </message>
    <message>
      <source>What you photograph or import is computed here, one batch after the other, while you go on working.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ լուսանկարում կամ ներմուծում եք, հաշվարկվում է այստեղ՝ խմբաքանակ առ խմբաքանակ, մինչ դուք շարունակում եք։</translation>
    </message>
    <message>
      <source>Photograph the first batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարել առաջին խմբաքանակը</translation>
    </message>
    <message>
      <source>Queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հերթ</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n խմբաքանակ կանգնել է և սպասում է ձեզ</numerusform>
        <numerusform>%n խմբաքանակ կանգնել է և սպասում է ձեզ</numerusform>
      </translation>
    </message>
    <message>
      <source>Go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շարունակել</translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը դեռ հաշվետվություն չունի։</translation>
    </message>
    <message>
      <source>Stop %1?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնե՞լ %1-ը։</translation>
    </message>
    <message>
      <source>It has been computed for more than an hour. Whole stages are kept, the present one is lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկվում է ավելի քան մեկ ժամ։ Ավարտված փուլերը պահվում են, ընթացիկը կորչում է։</translation>
    </message>
    <message>
      <source>Stop it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել</translation>
    </message>
    <message>
      <source>Let it go on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թող շարունակի</translation>
    </message>
    <message>
      <source>Mend the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ուղղել դիմակները</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ սևագրեր</translation>
    </message>
    <message>
      <source>Computes each new batch quickly and coarsely, to be looked at while the sherds still lie there; computed again it becomes final (D)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Յուրաքանչյուր նոր խմբաքանակ հաշվում է արագ և կոպիտ, որ նայեք, քանի դեռ բեկորները տեղում են. նորից հաշվելիս դառնում է վերջնական (D)</translation>
    </message>
    <message>
      <source>Calibrate the rig again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նորից տրամաչափել սարքակազմը</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ է տեղաշարժվել. այս խմբաքանակի լուսանկարները ցույց են տալիս, թե որտեղ են հիմա տեսախցիկները (C)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Rail</name>
    <message>
      <source>Stations</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կայաններ</translation>
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
      <translation>Զույգեր, նախ ամենակասկածելիները</translation>
    </message>
    <message>
      <source>This one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս մեկը</translation>
    </message>
    <message>
      <source>Next pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդ զույգը</translation>
    </message>
    <message>
      <source>Previous pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ զույգը</translation>
    </message>
    <message>
      <source>Candidate %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թեկնածու %1</translation>
    </message>
    <message>
      <source>Start point before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ սկզբնակետը</translation>
    </message>
    <message>
      <source>Next start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդ սկզբնակետը</translation>
    </message>
    <message>
      <source>One sample back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ նմուշ հետ</translation>
    </message>
    <message>
      <source>One sample on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ նմուշ առաջ</translation>
    </message>
    <message>
      <source>Mirror back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հայելի</translation>
    </message>
    <message>
      <source>Apart</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հեռու</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կտրվածք</translation>
    </message>
    <message>
      <source>Measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափել</translation>
    </message>
    <message>
      <source>Rim gap</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրի բացվածք</translation>
    </message>
    <message>
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդել</translation>
    </message>
    <message>
      <source>Settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հարմարեցնել</translation>
    </message>
    <message>
      <source>Let the rims settle the position (B)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թող եզրերը գտնեն դիրքը (B)</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի կողմ</translation>
    </message>
    <message>
      <source>Shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կրկին նկարել</translation>
    </message>
    <message>
      <source>Cut</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կտրել</translation>
    </message>
    <message>
      <source>Join</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միացնել</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>%1, key %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ստեղն %2</translation>
    </message>
    <message>
      <source>This one   Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս մեկը   Enter</translation>
    </message>
    <message>
      <source>The rims are compared … Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրերը համեմատվում են … Esc-ը կանգնեցնում է։</translation>
    </message>
    <message>
      <source>… and the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>… և մյուս ծայրը</translation>
    </message>
    <message>
      <source>Pairs of the batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակի զույգերը</translation>
    </message>
    <message>
      <source>Join two pieces of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միացնել մեկ բեկորի երկու կտոր. հետո ընտրեք մյուս քարտը (J՝ առջև, Shift+J՝ հետև)</translation>
    </message>
    <message>
      <source>Join backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միացնել հետևի երեսները</translation>
    </message>
    <message>
      <source>Settle, join and cut nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ չհարմարեցնել, չմիացնել և չկտրել</translation>
    </message>
    <message>
      <source>Cut a piece that is two sherds in truth, along a line over its picture (K)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կտրել կտորը, որն իրականում երկու բեկոր է, նրա նկարի վրայի գծով (K)</translation>
    </message>
    <message>
      <source>The rims settle: %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրերը համընկնում են՝ %1։ Esc-ը կանգնեցնում է։</translation>
    </message>
    <message>
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղմեք բեկորի վրա երկարության մի ծայրին, ապա՝ մյուսին։ D-ն ավարտում է։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ReviewStation</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակ</translation>
    </message>
    <message>
      <source>Your &amp;initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեր &amp;սկզբնատառերը</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեր սկզբնատառերը</translation>
    </message>
    <message>
      <source>Compute what changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկել փոխվածը</translation>
    </message>
    <message>
      <source>Makes the models of the pairs that were decided anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստեղծում է նորից որոշված զույգերի մոդելները</translation>
    </message>
    <message>
      <source>No batch is computed yet. Shoot or import one; its pairs appear here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ ոչ մի խմբաքանակ հաշվարկված չէ։ Լուսանկարեք կամ ներմուծեք մեկը. նրա զույգերը կերևան այստեղ։</translation>
    </message>
    <message>
      <source>Opening %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացվում է %1-ը</translation>
    </message>
    <message>
      <source>%1 waits to be computed; only what changed is done again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը սպասում է հաշվարկի. կրկնվում է միայն փոխվածը։</translation>
    </message>
    <message>
      <source>Saved. The pairs of the new pieces come when it is computed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։ Նոր կտորների զույգերը կգան հաշվարկից հետո։</translation>
    </message>
    <message>
      <source>Taken back. Both are kept in the history.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետ է վերցված։ Երկուսն էլ մնում են պատմության մեջ։</translation>
    </message>
    <message>
      <source>Saved, with your name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է ձեր անունով։</translation>
    </message>
    <message>
      <source>No pair needs your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի զույգի նայել պետք չէ</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) need your eye</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n զույգի պետք է նայել</numerusform>
        <numerusform>%n զույգի պետք է նայել</numerusform>
      </translation>
    </message>
    <message>
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգում</translation>
    </message>
    <message>
      <source>Where its report is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեպի նրա հաշվետվությունը</translation>
    </message>
    <message>
      <source>None of the measures of %1 is sure. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի ոչ մի չափը վստահելի չէ։ %2</translation>
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
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացատ</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SettingsPage</name>
    <message>
      <source>As the desktop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչպես աշխատասեղանը</translation>
    </message>
    <message>
      <source>Light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց</translation>
    </message>
    <message>
      <source>Dark, for the tent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մուգ՝ վրանի համար</translation>
    </message>
    <message>
      <source>Sunlight: black on white, thick lines</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արևի լույս՝ սև սպիտակի վրա, հաստ գծեր</translation>
    </message>
    <message>
      <source>all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բոլորը</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարգավորումներ</translation>
    </message>
    <message>
      <source>&amp;Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեր &amp;սկզբնատառերը</translation>
    </message>
    <message>
      <source>They stand in the history of each decision.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նրանք նշվում են ամեն որոշման պատմության մեջ։</translation>
    </message>
    <message>
      <source>&amp;Theme</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Տեսք</translation>
    </message>
    <message>
      <source>Te&amp;xt size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տե&amp;քստի չափը</translation>
    </message>
    <message>
      <source>Text size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեքստի չափը</translation>
    </message>
    <message>
      <source>&amp;Language</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Լեզու</translation>
    </message>
    <message>
      <source>Holds from the next start.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գործում է հաջորդ մեկնարկից։</translation>
    </message>
    <message>
      <source>&amp;Processors for computing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Պրոցեսորներ հաշվարկի համար</translation>
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
    <name>ostraka::ui::SheetView</name>
    <message>
      <source>The drawing on its sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարն իր թերթին</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdDetails</name>
    <message>
      <source>missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բացակայում է</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխված է</translation>
    </message>
    <message>
      <source>present</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կա</translation>
    </message>
    <message>
      <source>Details of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորի մանրամասները</translation>
    </message>
    <message>
      <source>Number of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորի համարը</translation>
    </message>
    <message>
      <source>Picture of the sherd in the way</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խանգարող բեկորի պատկերը</translation>
    </message>
    <message>
      <source>measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>չափ</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>արժեք</translation>
    </message>
    <message>
      <source>from</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>աղբյուր</translation>
    </message>
    <message>
      <source>Measurements</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափումներ</translation>
    </message>
    <message>
      <source>when</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>երբ</translation>
    </message>
    <message>
      <source>who</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ով</translation>
    </message>
    <message>
      <source>what</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչ</translation>
    </message>
    <message>
      <source>History</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատմություն</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ֆայլ</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեսակ</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վիճակ</translation>
    </message>
    <message>
      <source>Files</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլեր</translation>
    </message>
    <message>
      <source>Measured</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափված</translation>
    </message>
    <message>
      <source>Context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համատեքստ</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համատեքստ</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դեռ համար չկա</translation>
    </message>
    <message>
      <source>Give the number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տալ %1 համարը</translation>
    </message>
    <message>
      <source>added</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ավելացված է</translation>
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
      <translation>ոչինչ</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ծրագիր</translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրեք բեկոր։</translation>
    </message>
    <message>
      <source>%1 It is %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Դա %2-ն է։</translation>
    </message>
    <message>
      <source>%1; in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. կասկածելի է</translation>
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
        <numerusform>համարակալել %n բեկոր</numerusform>
        <numerusform>համարակալել %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>Other changes are still being saved; wait for them, or stop them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ փոփոխություններ դեռ պահվում են. սպասեք կամ կանգնեցրեք։</translation>
    </message>
    <message>
      <source>The sherds that are chosen have their numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրված բեկորներն ունեն իրենց համարները։</translation>
    </message>
    <message>
      <source>Numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարներ</translation>
    </message>
    <message>
      <source>Stopped; nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցված է. ոչինչ չի փոխվել։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdTableModel</name>
    <message>
      <source>Picture of a sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորի պատկեր</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>not recorded</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գրանցված չէ</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դեռ համար չկա</translation>
    </message>
    <message>
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1՝ %2, կասկածելի</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. %2 խմբաքանակի մասշտաբը կասկածելի է. դրա հաշվետվությունն ասում է ինչու և ինչ անել։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdView</name>
    <message>
      <source>Sherd in three dimensions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորը եռաչափ</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the sherd cannot be shown in three dimensions. Everything else works; photographs and outlines are beside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս էկրանը OpenGL 3.2 չունի, ուստի բեկորը եռաչափ ցույց տալ հնարավոր չէ։ Մնացած ամեն ինչ աշխատում է. լուսանկարներն ու ուրվագծերը կողքին են։</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ նախագիծ չկա։ Ստեղծեք մեկը կամ փորձեք ամեն ինչ վիրտուալ սարքակազմով. այն ձեզ համար կոտրում է անոթ և լուսանկարում բեկորները։</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել…</translation>
    </message>
    <message>
      <source>Choose the folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել պանակը</translation>
    </message>
    <message>
      <source>Make the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստեղծել նախագիծը</translation>
    </message>
    <message>
      <source>&amp;Name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Անուն</translation>
    </message>
    <message>
      <source>&amp;Site code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձանի &amp;ծածկագիր</translation>
    </message>
    <message>
      <source>&amp;Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Պանակ</translation>
    </message>
    <message>
      <source>Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պանակ</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Համարակալում</translation>
    </message>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորը կլինի</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր նախագծի պանակը</translation>
    </message>
    <message>
      <source>Folder of a project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծի պանակը</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծեր</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it …</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2-ը տեղում չէ. գտեք այն …</translation>
    </message>
    <message>
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որտե՞ղ է հիմա %1-ը</translation>
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
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկեր</translation>
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
      <translation>առջև՝ կապույտ եզր</translation>
    </message>
    <message>
      <source>back: red rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետև՝ կարմիր եզր</translation>
    </message>
    <message>
      <source>%1 mm and more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm և ավելի</translation>
    </message>
    <message>
      <source>0 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>0 mm</translation>
    </message>
    <message>
      <source>gap between the sides along the rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>երեսների միջև բացվածքը եզրի երկայնքով</translation>
    </message>
    <message>
      <source>grey: not met by the other side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մոխրագույն. մյուս կողմը չի հասնում</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, a whole number, or scan its label</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, ամբողջ համարը կամ կարդալ պիտակը</translation>
    </message>
    <message>
      <source>&amp;Number of sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Խեցաբեկոր %1-ի համարը</translation>
    </message>
    <message>
      <source>If they have numbers already: each follows its sherd through the flip. Key N.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եթե արդեն համարներ ունեն՝ յուրաքանչյուրը հետևում է իր խեցաբեկորին շրջելիս։ N ստեղնը։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskModel</name>
    <message>
      <source>%1, camera %2, stop %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, տեսախցիկ %2, կանգառ %3</translation>
    </message>
    <message>
      <source>Mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիմակ</translation>
    </message>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի դիմակները</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետևի երես</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առջևի երես</translation>
    </message>
    <message>
      <source>paint on a mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նկարել դիմակի վրա</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի դիմակները</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) mended; what follows from them is computed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n լուսանկար ուղղված է. դրանից բխողը կրկին կհաշվարկվի։</numerusform>
        <numerusform>%n լուսանկար ուղղված է. դրանցից բխողը կրկին կհաշվարկվի։</numerusform>
      </translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետ</translation>
    </message>
    <message>
      <source>Brush's &amp;width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վրձնի &amp;լայնությունը</translation>
    </message>
    <message>
      <source>Compute with these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկել սրանցով</translation>
    </message>
    <message>
      <source>Larger</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեծացնել</translation>
    </message>
    <message>
      <source>Smaller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոքրացնել</translation>
    </message>
    <message>
      <source>Next photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդ լուսանկարը</translation>
    </message>
    <message>
      <source>Photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկար</translation>
    </message>
    <message>
      <source>Photograph before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ լուսանկարը</translation>
    </message>
    <message>
      <source>Plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակ</translation>
    </message>
    <message>
      <source>Sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկոր</translation>
    </message>
    <message>
      <source>The photograph is being read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարը կարդացվում է։</translation>
    </message>
    <message>
      <source>What is veiled in blue is taken for sherd. Paint what is missing, or as plate what is too much; the program's own masks stay.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կապույտով ծածկվածը համարվում է բեկոր։ Նկարեք այն, ինչ պակասում է, կամ որպես սկավառակ՝ այն, ինչ ավելորդ է. ծրագրի դիմակները մնում են։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::MaskView</name>
    <message>
      <source>Photograph with its mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարն իր դիմակով</translation>
    </message>
    <message>
      <source>The arrows move the brush, Space paints, plus and minus enlarge and reduce.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սլաքները շարժում են վրձինը, բացատը նկարում է, գումարման և հանման նշանները մեծացնում ու փոքրացնում են։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::NumberingEdit</name>
    <message>
      <source>A sherd will be</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորը կլինի</translation>
    </message>
    <message>
      <source>First number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս համակարգչի առաջին համարը</translation>
    </message>
    <message>
      <source>Last number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս համակարգչի վերջին համարը</translation>
    </message>
    <message>
      <source>Left out so far</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առայժմ բաց թողնված</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Համարակալում</translation>
    </message>
    <message>
      <source>Num&amp;bers of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս համակարգչի հա&amp;մարները</translation>
    </message>
    <message>
      <source>Number so from &amp;now on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այսուհետև &amp;այսպես համարակալել</translation>
    </message>
    <message>
      <source>Numbers of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց նախագծի համարները</translation>
    </message>
    <message>
      <source>What has a number keeps it; the next sherds follow. No number is ever given twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համար ունեցողը պահում է այն. հաջորդ բեկորները հետևում են։ Ոչ մի համար երկու անգամ չի տրվում։</translation>
    </message>
    <message numerus="yes">
      <source>and in %n more context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>և ևս %n համատեքստում</numerusform>
        <numerusform>և ևս %n համատեքստում</numerusform>
      </translation>
    </message>
    <message>
      <source>no number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ոչ մի համար</translation>
    </message>
    <message>
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մինչև</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, և {n}՝ մեկ անգամ. {n:04}-ն ունի առնվազն չորս նիշ</translation>
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
      <translation>Բաց թողնված համարներ</translation>
    </message>
    <message>
      <source>Sherds of %1 get no number so: it lacks a part that the numbering names.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի բեկորներն այսպես համար չեն ստանում. դրան պակասում է մի մաս, որը նշում է համարակալումը։</translation>
    </message>
    <message>
      <source>The first number of a block is not above its last.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբի առաջին համարը մեծ չէ վերջինից։</translation>
    </message>
    <message>
      <source>change the numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխել համարակալումը</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::VocabularyEdit</name>
    <message>
      <source>&amp;Save the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանել բառ&amp;երը</translation>
    </message>
    <message>
      <source>&amp;Words for</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Բառեր</translation>
    </message>
    <message>
      <source>A word that sherds use already stays; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորների օգտագործած բառը մնում է. նախ փոխեք դրանք։</translation>
    </message>
    <message>
      <source>&amp;One a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տ&amp;ողում մեկը</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանված է։</translation>
    </message>
    <message>
      <source>Words of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց նախագծի բառերը</translation>
    </message>
    <message>
      <source>Words, one a line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բառեր, տողում մեկը</translation>
    </message>
    <message>
      <source>change the words</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխել բառերը</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պահպանվածություն</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զարդ</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>թրծում</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատրաստում</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մաս</translation>
    </message>
    <message>
      <source>surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մակերես</translation>
    </message>
    <message>
      <source>These words are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս բառերը դեռ պահված չեն։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CountEdit</name>
    <message>
      <source>&amp;Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Բեկորներ</translation>
    </message>
    <message>
      <source>not counted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>չի հաշվված</translation>
    </message>
    <message>
      <source>How many sherds you counted onto the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Քանի բեկոր եք հաշվել սկուտեղի վրա</translation>
    </message>
    <message>
      <source>Count them if you like: you are asked when the photographs show another number (S)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվեք, եթե ուզում եք. ձեզ կհարցնեն, երբ լուսանկարները այլ թիվ ցույց տան (S)</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::RigRenewal</name>
    <message>
      <source>Calibration by %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տրամաչափում ըստ %1-ի</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծման ընթացքը</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել ներմուծումը</translation>
    </message>
  </context>
  <context>
    <name>ImportBatch</name>
    <message>
      <source>There are no scans (*.ply) in its folder %1/. Choose a folder that holds front/ and back/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նրա %1/ պանակում սկաններ (*.ply) չկան։ Ընտրեք պանակ, որում կան front/ և back/։</translation>
    </message>
    <message>
      <source>This folder cannot be read to its end: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակը հնարավոր չէ կարդալ մինչև վերջ՝ %1։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::SherdNumbers</name>
    <message>
      <source>%1 is no sherd's number: it has a digit, no space and at most %2 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը բեկորի համար չէ. այն ունի թվանշան, չունի բացատ և առավելագույնը %2 նիշ է։</translation>
    </message>
    <message>
      <source>Sherd %1 of this plate has the number %2: take it from that one first, or type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սկավառակի %1 բեկորն ունի %2 համարը. նախ հանեք այն նրանից կամ գրեք ուրիշը։</translation>
    </message>
    <message>
      <source>A sherd of %1 has the number %2 already; type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի մի բեկոր արդեն ունի %2 համարը. գրեք ուրիշը։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::Doubts</name>
    <message>
      <source>the file is cut off or no picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ֆայլը կտրված է կամ պատկեր չէ</translation>
    </message>
    <message>
      <source>the markers show another angle than this stop's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նշիչները ցույց են տալիս այս կանգառի անկյունից տարբեր անկյուն</translation>
    </message>
    <message>
      <source>the picture has another size than the camera's others</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատկերի չափը տարբերվում է այս տեսախցիկի մյուսներից</translation>
    </message>
    <message>
      <source>too few markers are seen to tell the stop: is something before them, is it blurred?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կանգառը որոշելու համար շատ քիչ նշիչ է երևում. արդյո՞ք դրանց առջև բան կա, կամ պատկերը մշո՞ւշոտ է</translation>
    </message>
    <message>
      <source>the camera handed over an earlier photograph once more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեսախցիկը կրկին տվեց նախորդ լուսանկարներից մեկը</translation>
    </message>
    <message>
      <source>too few markers of the plate are seen: is something before them?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկավառակի շատ քիչ նշիչ է երևում. արդյո՞ք դրանց առջև բան կա</translation>
    </message>
    <message>
      <source>it is blurred: did the table still move, did the focus change?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մշուշոտ է. սեղանը դեռ շարժվո՞ւմ էր, ֆոկուսը փոխվե՞լ է</translation>
    </message>
    <message>
      <source>the sherds are too dark: give more light or expose longer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկորները չափազանց մութ են. ավելացրեք լույսը կամ երկարացրեք լուսակայումը</translation>
    </message>
    <message>
      <source>the sherds are burnt out: expose shorter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկորները գերլուսավորված են. կարճացրեք լուսակայումը</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատկերի եզրը կտրում է բեկորը. տեղաշարժեք այն կամ տեսախցիկը</translation>
    </message>
    <message>
      <source>the camera's settings are others than they were: set them back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեսախցիկի կարգավորումները փոխվել են. վերականգնեք դրանք</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) մմ</translation>
    </message>
    <message>
      <source>%1: set it back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. վերականգնեք</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate's markers are seen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները հնարավոր չեղավ հաշվել. սկավառակի շատ քիչ նշիչ է երևում։</translation>
    </message>
    <message>
      <source>No sherd is seen on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի վրա ոչ մի բեկոր չի երևում։</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate's middle: move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները դիպչում են կամ գրեթե դիպչում են %1 սկավառակի կենտրոնից. հեռացրեք դրանք իրարից և նորից լուսանկարեք։</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate's middle was counted as one but may be two sherds that touch: look there; if so, move them apart and shoot again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ ընկած է %1 սկավառակի կենտրոնից, հաշվվել է որպես մեկ, բայց կարող է լինել իրար դիպչող երկու բեկոր. նայեք այնտեղ. եթե այդպես է, հեռացրեք դրանք իրարից և նորից լուսանկարեք։</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and photograph them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հակառակ կողմը նման է առջևի կողմին. շրջեք բեկորները և նորից լուսանկարեք։</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հակառակ կողմի բեկորները հնարավոր չեղավ հաշվել. սկավառակը դատարկելուց առաջ ինքներդ համեմատեք պատկերները։</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures yourself before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի կողմի բեկորները հնարավոր չեղավ հաշվել. սկավառակը դատարկելուց առաջ ինքներդ համեմատեք պատկերները։</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: look for the missing one before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևում երևացել է %1 բեկոր, հակառակ կողմում՝ %2. սկավառակը դատարկելուց առաջ փնտրեք պակասողը։</translation>
    </message>
    <message>
      <source>The front showed %1 sherds, the back %2: was one added, or did one break?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևում երևացել է %1 բեկոր, հակառակ կողմում՝ %2. մեկը ավելացվե՞լ է, թե՞ կոտրվել։</translation>
    </message>
  </context>
  <context>
    <name>ostraka::Error</name>
    <message>
      <source>Stopped on request.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցվել է ըստ ցանկության։</translation>
    </message>
    <message>
      <source>The camera is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը միացված չէ մալուխով։</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը միացված չէ մալուխով կամ անջատված է։</translation>
    </message>
    <message>
      <source>The camera does not answer; is it asleep? Switch its automatic power-off off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը չի պատասխանում. քնա՞ծ է։ Անջատեք դրա ինքնաանջատումը։</translation>
    </message>
    <message>
      <source>The camera stays busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը շարունակում է զբաղված մնալ. անջատեք և միացրեք։</translation>
    </message>
    <message>
      <source>The line to the camera is broken; look at its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կապը տեսախցիկի հետ ընդհատված է. ստուգեք դրա մալուխը։</translation>
    </message>
    <message>
      <source>The camera is held by another program, often the desktop's file manager; 'ostraka devices' names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը զբաղեցրել է այլ ծրագիր, հաճախ՝ ֆայլերի կառավարիչը. 'ostraka devices'-ը նշում է այն։</translation>
    </message>
    <message>
      <source>The camera cannot be opened; may this user use it? Look at 'ostraka devices'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը չի բացվում. այս օգտատերը կարո՞ղ է օգտվել դրանից։ Տե՛ս 'ostraka devices'։</translation>
    </message>
    <message>
      <source>No photograph came from the camera; is it focused and set to manual?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկից լուսանկար չեկավ. ֆոկուսն ու ձեռքի ռեժիմը կարգավորվա՞ծ են։</translation>
    </message>
    <message>
      <source>The camera does not stop to deliver photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը չի դադարում լուսանկարներ տալ։</translation>
    </message>
    <message>
      <source>This camera shows no live picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեսախցիկը կենդանի պատկեր չի ցուցադրում։</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; is it blocked?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի հասնում իր անկյանը. արգելափակվա՞ծ է։</translation>
    </message>
    <message>
      <source>The turntable was paused at its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը դադարեցվել է իր սեփական կոճակով։</translation>
    </message>
    <message>
      <source>The table's position is not known: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի դիրքը հայտնի չէ. զրոյացրեք կամ հավասարեցրեք այն։</translation>
    </message>
    <message>
      <source>The turntable does not answer in the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը ցանցում չի պատասխանում։</translation>
    </message>
    <message>
      <source>The controller restarted; the table's position is not known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարգավորիչը վերագործարկվել է. սեղանի դիրքը հայտնի չէ։</translation>
    </message>
    <message>
      <source>A reply of the turntable was lost and it cannot tell where it stands: home it, or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի պատասխանը կորավ, և այն չի կարող ասել՝ որտեղ է. զրոյացրեք կամ հավասարեցրեք այն։</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը չի պատասխանում որպես GRBL կարգավորիչ. միացվա՞ծ է և այս տեսակի՞ն է։</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim: is it switched on, and is it of this type?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը չի պատասխանում որպես ComXim. միացվա՞ծ է և այս տեսակի՞ն է։</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB-ն այս համակարգչում չի աշխատում։</translation>
    </message>
    <message>
      <source>The disk is full; free some space and shoot on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը լի է. տեղ ազատեք և շարունակեք նկարահանումը։</translation>
    </message>
    <message>
      <source>The disk is full; free some space and start the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը լի է. տեղ ազատեք և նորից սկսեք նույնը։</translation>
    </message>
    <message>
      <source>The disk is full; make room, then try again. Nothing was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը լի է. տեղ ազատեք և նորից փորձեք։ Ոչինչ չի կորել։</translation>
    </message>
    <message>
      <source>Another program keeps the catalogue busy; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ ծրագիր զբաղեցրել է կատալոգը. փակեք այն և նորից փորձեք։</translation>
    </message>
    <message>
      <source>The image is cut off before its end; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերը կտրված է մինչև վերջանալը. նորից պատճենեք տեսախցիկից։</translation>
    </message>
  </context>
</TS>
