<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hy" sourcelanguage="en">
<context>
    <name>ostraka::ui::ProjectSession</name>
    <message>
      <source>This project is read-only: you can look at everything, but change nothing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծը կարելի է միայն կարդալ. դիտեք ամեն ինչ, փոփոխությունները մերժվում են։</translation>
    </message>
    <message>
      <source>The project's folder is not there any more: it was moved, renamed, or its disk was taken out. Open the project again where it is now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծի պանակն այլևս չկա. այն տեղափոխվել է, անվանափոխվել, կամ նրա սկավառակը հանվել է։ Բացեք նախագիծը այնտեղ, որտեղ այն հիմա է։</translation>
    </message>
</context>
<context>
    <name>SideLabels</name>
    <message>
      <source>A label among the fronts names %1, one among the backs %2: check that both sides show the same sherds, and type the bag that they are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսների պիտակում նշված է %1, հետևի երեսների պիտակում՝ %2. ստուգեք՝ արդյոք երկու երեսները նույն բեկորներինն են, և մուտքագրեք դրանց տոպրակը։</translation>
    </message>
    <message>
      <source>Labels of several bags are in the photographs: %1. Type the one that these sherds are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարներում մի քանի տոպրակի պիտակ կա՝ %1։ Մուտքագրեք այն, որից այս բեկորներն են։</translation>
    </message>
    <message>
      <source>The label in the photographs names %1: check the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարների պիտակում նշված է %1. ստուգեք տոպրակը։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportAsk</name>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ նայեք սրան</translation>
    </message>
    <message>
      <source>The label in the photographs names %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարների պիտակում նշված է %1։</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել</translation>
    </message>
    <message>
      <source>Cancel import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ չներմուծել</translation>
    </message>
    <message>
      <source>From %1. The bag can also be given later, in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ից։ Տոպրակը կարելի է նշել նաև ավելի ուշ՝ կատալոգում։</translation>
    </message>
    <message>
        <source>Enter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Enter</translation>
    </message>
    <message>
      <source>To import, confirm or move the division between front and back, or choose one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծելու համար հաստատեք կամ տեղափոխեք առջևի և հետևի երեսի բաժանումը կամ ընտրեք միայն մեկ երես։</translation>
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
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հաստություն, mm</translation>
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
      <source>minimum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նվազագույն հաստություն, mm</translation>
    </message>
    <message>
      <source>maximum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առավելագույն հաստություն, mm</translation>
    </message>
    <message>
      <source>unseen surface, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>չերևացած, %</translation>
    </message>
    <message>
      <source>place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեղ</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մոդել</translation>
    </message>
    <message>
      <source>labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անվանումներ</translation>
    </message>
    <message>
      <source>person</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անձ</translation>
    </message>
    <message>
      <source>name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անուն</translation>
    </message>
    <message>
      <source>initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկզբնատառեր</translation>
    </message>
    <message>
      <source>code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ծածկագիր</translation>
    </message>
    <message>
      <source>location</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գտնվելու վայր</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեսակ</translation>
    </message>
    <message>
      <source>excavated on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պեղման օր</translation>
    </message>
    <message>
      <source>closed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փակված</translation>
    </message>
    <message>
      <source>collected on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հավաքման օր</translation>
    </message>
    <message>
      <source>storage</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պահպանման տեղ</translation>
    </message>
    <message>
      <source>operator</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կատարող</translation>
    </message>
    <message>
      <source>counted sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հաշված բեկորներ</translation>
    </message>
    <message>
      <source>results</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>արդյունքներ</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ծրագիր</translation>
    </message>
    <message>
      <source>project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նախագիծ</translation>
    </message>
    <message>
      <source>title</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վերնագիր</translation>
    </message>
    <message>
      <source>institution</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հաստատություն</translation>
    </message>
    <message>
      <source>licence</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>արտոնագիր</translation>
    </message>
    <message>
      <source>rights holder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>իրավատեր</translation>
    </message>
    <message>
      <source>numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համարակալում</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկոր</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>լուսանկար</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկան</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ֆայլ</translation>
    </message>
    <message>
      <source>term</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>եզրույթ</translation>
    </message>
    <message>
      <source>content</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բովանդակություն</translation>
    </message>
    <message>
      <source>mask strokes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վրձնահարվածներ դիմակների վրա</translation>
    </message>
    <message>
      <source>entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գրանցում</translation>
    </message>
    <message>
      <source>excavated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պեղում</translation>
    </message>
    <message>
      <source>measured by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ձեռքով չափված</translation>
    </message>
    <message>
      <source>centre of mass x, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զանգվածի կենտրոն x, mm</translation>
    </message>
    <message>
      <source>centre of mass y, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զանգվածի կենտրոն y, mm</translation>
    </message>
    <message>
      <source>centre of mass z, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զանգվածի կենտրոն z, mm</translation>
    </message>
    <message>
      <source>model file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մոդելի ֆայլ</translation>
    </message>
    <message>
      <source>picture file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատկերի ֆայլ</translation>
    </message>
    <message>
      <source>drawing file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գծագրի ֆայլ</translation>
    </message>
    <message>
      <source>sherds written on the bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկորներ ըստ տոպրակի</translation>
    </message>
    <message>
      <source>column of the CSV</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>CSV-ի սյունակ</translation>
    </message>
    <message>
      <source>column</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սյունակ</translation>
    </message>
    <message>
      <source>unit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>միավոր</translation>
    </message>
    <message>
      <source>meaning</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նշանակություն</translation>
    </message>
    <message>
      <source>reason for voiding</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անվավեր ճանաչելու պատճառ</translation>
    </message>
    <message>
      <source>identical with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նույնն է, ինչ</translation>
    </message>
</context>
<context>
    <name>Job</name>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա ծրագրի սխալ է. խնդրում ենք հայտնել մատյանի հետ (%1)։</translation>
    </message>
    <message>
      <source>Not enough memory. Close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հիշողությունը չի բավականացնում. փակեք այլ ծրագրեր և փորձեք կրկին։</translation>
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
      <translation>հուշարձան %1</translation>
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
    <message numerus="yes">
        <source>%n sherd(s) counted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>հաշվված է %n բեկոր</numerusform>
            <numerusform>հաշվված է %n բեկոր</numerusform>
        </translation>
    </message>
    <message>
      <source>invented by the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վիրտուալ սարքակազմի հորինածը</translation>
    </message>
    <message>
      <source>context %1, although %2 exists</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համատեքստ %1, թեև %2-ը կա</translation>
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
      <source>Finding the cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշվում են տեսախցիկների դիրքերը</translation>
    </message>
    <message>
      <source>Measuring the shape, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափվում է ձևը, առջև</translation>
    </message>
    <message>
      <source>Measuring the shape, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափվում է ձևը, հետև</translation>
    </message>
    <message>
      <source>Cutting the sherds out, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները կտրվում են մեկ առ մեկ, առջև</translation>
    </message>
    <message>
      <source>Cutting the sherds out, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները կտրվում են մեկ առ մեկ, հետև</translation>
    </message>
    <message>
      <source>Matching fronts and backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զուգադրվում են առջևի և հետևի կողմերը</translation>
    </message>
    <message>
      <source>Closing the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փակվում են մոդելները</translation>
    </message>
    <message>
      <source>Writing the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրվում է հաշվետվությունը</translation>
    </message>
    <message>
      <source>Entering the sherds into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները մուտքագրվում են կատալոգ</translation>
    </message>
    <message>
      <source>Starting</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկսվում է</translation>
    </message>
    <message>
      <source>Looking for other partners in doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոնվում են այլ զույգեր կասկածելի զույգերի համար</translation>
    </message>
    <message>
      <source>Finding the sherds, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները որոնվում են, առջև</translation>
    </message>
    <message>
      <source>Finding the sherds, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները որոնվում են, հետև</translation>
    </message>
</context>
<context>
    <name>Time</name>
    <message>
      <source>less than a minute left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մնացել է մեկ րոպեից քիչ</translation>
    </message>
    <message>
      <source>about %1 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մնացել է մոտ %1 րոպե</translation>
    </message>
    <message>
      <source>about %1 h left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մնացել է մոտ %1 ժամ</translation>
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
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը և %2-ը երկուսն էլ հարմար են %3-ին։</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նրա հետևի երեսը տրվել է ուրիշ առջևի երեսի. հիմա ճիշտը %1-ն է՞։</translation>
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
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տոպրակ %1</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս հետևի երեսը մի կողմ է դրված։ Այնուամենայնիվ օգտագործելու համար քաշեք այն առջևի երեսի վրա։</translation>
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
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջված է ձեռքով։</translation>
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
      <source>Sure by what was decided for others: %1; by itself %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վստահ է մյուսների համար որոշվածի շնորհիվ՝ %1. ինքնին՝ %2։</translation>
    </message>
    <message>
      <source>%1, aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, մի կողմ</translation>
    </message>
    <message>
      <source>%1, shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, կրկին նկարել</translation>
    </message>
    <message>
      <source>%1, void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, անվավեր</translation>
    </message>
    <message>
      <source>%1 in %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>now %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>այժմ %1</translation>
    </message>
    <message>
        <source>front %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>առջևի երես %1</translation>
    </message>
    <message>
        <source>back %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>հետևի երես %1</translation>
    </message>
    <message>
        <source>Merged with %1 by %2. It is one fragment once the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Միավորված է %1-ի հետ, %2։ Խմբաքանակի վերամշակումից հետո մեկ կտոր կլինի։</translation>
    </message>
    <message>
        <source>Split by %1. Its fragments appear when the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բաժանված է, %1։ Կտորները կհայտնվեն խմբաքանակի վերամշակումից հետո։</translation>
    </message>
    <message>
        <source>Merged</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Միավորված</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բաժանված</translation>
    </message>
    <message>
        <source>No front</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Առջևի երես չկա</translation>
    </message>
    <message>
        <source>This back is to be reshot.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այս հետևի երեսը պետք է վերալուսանկարել։</translation>
    </message>
    <message>
        <source>No front holds this back. Drag it onto its front, merge it with another, or set it aside.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ոչ մի առջևի երես այս հետևի երեսը չունի։ Քաշեք այն իր առջևի երեսի վրա, միավորեք մեկ ուրիշի հետ կամ մի կողմ դրեք։</translation>
    </message>
    <message>
        <source>%1 and %2 both fit %3: their fractures differ by only %4.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 և %2 երկուսն էլ համապատասխանում են %3-ին. կոտրվածքները տարբերվում են միայն %4-ով:</translation>
    </message>
    <message>
        <source>%1 would fit %2 almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 գրեթե նույնքան լավ կհամապատասխաներ %2-ին:</translation>
    </message>
    <message>
        <source>%1 fits barely better than an unrelated back.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 հազիվ ավելի լավ է համապատասխանում, քան օտար հետևի երեսը։</translation>
    </message>
    <message>
        <source>Ambiguous: a second position fits almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Երկիմաստ. երկրորդ դիրքը գրեթե նույնքան լավ է համապատասխանում:</translation>
    </message>
    <message>
        <source>%1 confident</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վստահություն՝ %1</translation>
    </message>
    <message>
        <source>Check</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ստուգել</translation>
    </message>
    <message>
        <source>No back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հետևի երես չկա</translation>
    </message>
    <message>
        <source>Sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վստահ</translation>
    </message>
    <message>
        <source>Decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Որոշված</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մի կողմ դրված</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերալուսանկարել</translation>
    </message>
    <message>
        <source>To be reshot, decided by %1 on %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերալուսանկարել, որոշել է %1, %2:</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Փոխարինել չափված արժեքով</translation>
    </message>
    <message>
        <source>Delete computed value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ջնջել հաշվարկված արժեքը</translation>
    </message>
    <message>
        <source>Save this value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Պահել այս արժեքը</translation>
    </message>
    <message>
        <source>%1 (computed %2)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 (հաշվարկված %2)</translation>
    </message>
    <message>
        <source>The two scans share only %1 of the fracture.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Երկու սկանների համար ընդհանուր է կոտրվածքի միայն %1-ը։</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դեռ համար չկա</translation>
    </message>
    <message>
      <source>Another partner fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ զույգ գրեթե նույնքան լավ է հարմարվում։</translation>
    </message>
    <message>
      <source>no probability</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հավանականություն չկա</translation>
    </message>
    <message>
      <source>The nearest outline; no probability is known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ամենամոտ ուրվագիծը. հավանականություն հայտնի չէ։</translation>
    </message>
    <message>
      <source>Another front takes the same back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ առջևի երես վերցնում է նույն հետևի երեսը։</translation>
    </message>
    <message>
      <source>The two scans share almost no fracture; only their outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու սկանները գրեթե չունեն ընդհանուր կոտրվածք. նրանց կապում են միայն ուրվագծերը։</translation>
    </message>
    <message>
      <source>The fractures do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքները չեն համընկնում. հեռավորությունը %1 է։</translation>
    </message>
    <message>
      <source>The fracture barely fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքը հազիվ է որոշում դիրքը. անորոշությունը %1 է։</translation>
    </message>
    <message>
      <source>A position %1 along the contour fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ուրվագծով %1 հեռու մի դիրք գրեթե նույնքան լավ է հարմարվում։</translation>
    </message>
    <message>
      <source>The fractures cannot be compared; only the outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքները համեմատել հնարավոր չէ. այս երեսները կապում են միայն ուրվագծերը։</translation>
    </message>
    <message>
      <source>refined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հարմարեցված</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջված է ձեռքով. հպվում է կոտրվածքների %1-ը։</translation>
    </message>
    <message>
      <source>Trying another start point: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է ուրիշ սկզբնակետ. հպվում է կոտրվածքների %1-ը։</translation>
    </message>
    <message>
      <source>Trying another start point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է ուրիշ սկզբնակետ։</translation>
    </message>
    <message>
      <source>Refined by the fractures: %1 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հարմարեցված է կոտրվածքներով. հպվում է %1-ը։</translation>
    </message>
    <message>
      <source>Refined by the fractures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հարմարեցված է կոտրվածքներով։</translation>
    </message>
    <message>
      <source>Trying %1: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է %1-ը՝ %2։</translation>
    </message>
    <message>
      <source>Trying %1: %2, fractures %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է %1-ը՝ %2, կոտրվածքների հեռավորությունը %3։</translation>
    </message>
    <message>
      <source>Trying %1: %2; its fractures do not touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փորձվում է %1-ը՝ %2. կոտրվածքները չեն հպվում։</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2, բեկոր %1</translation>
    </message>
    <message>
      <source>imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ներմուծված</translation>
    </message>
    <message>
      <source>estimated by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գնահատված ձեռքով</translation>
    </message>
    <message>
      <source>%1 confident; below %2, a person decides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վստահություն՝ %1. %2-ից ցածր որոշում է մարդը։</translation>
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
      <translation>Կոտրվածքների միայն %1-ն է հպվում։</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր</numerusform>
        <numerusform>%n բեկոր</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep a number of the old context: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկորը պահպանում է հին համատեքստի համարը՝ %1։</numerusform>
        <numerusform>%n բեկորները պահպանում են հին համատեքստի համարը՝ %1։</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag, because there is no bag %1 yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր թողնում է իր տոպրակը, քանի որ դեռ չկա տոպրակ %1։</numerusform>
        <numerusform>%n բեկոր թողնում են իրենց տոպրակները, քանի որ դեռ չկա տոպրակ %1։</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր թողնում է իր տոպրակը։</numerusform>
        <numerusform>%n բեկոր թողնում են իրենց տոպրակները։</numerusform>
      </translation>
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
    <message numerus="yes">
      <source>Sheet recognised: %n marker(s). Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Թերթը ճանաչվեց՝ %n նշիչ։ Չափերը հիմնված են մուտքագրված նշիչի կողմի վրա՝ %1 մմ. ստուգեք այն թղթի վրա քանոնով։</numerusform>
        <numerusform>Թերթը ճանաչվեց՝ %n նշիչ։ Չափերը հիմնված են մուտքագրված նշիչի կողմի վրա՝ %1 մմ. ստուգեք այն թղթի վրա քանոնով։</numerusform>
      </translation>
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
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զգուշացում՝ %1</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կրկին</translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1՝ դադար</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր</numerusform>
        <numerusform>%n բեկոր</numerusform>
      </translation>
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
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը սպասում է %2-ի սևագրին։</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի համար տեսախցիկները նորից գտնվել են. նորից տրամաչափեք սարքակազմը (C)։</translation>
    </message>
    <message>
      <source>You set it aside. Its photographs are kept; R takes it up again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք այն մի կողմ եք դրել։ Լուսանկարները պահված են. R-ը նորից է վերցնում։</translation>
    </message>
    <message>
      <source>%1; is %2 the sherd that it was? It measured %3 mm, now %4 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; %2-ը նույն բեկո՞րն է։ Չափում էր %3 մմ, այժմ՝ %4 մմ</translation>
    </message>
    <message>
      <source>%1; the number %2 was typed on its plate, and none of its sherds has it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1; %2 համարը գրվել է նրա սալի վրա, և նրա բեկորներից ոչ մեկը չունի այն</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n photographed again since</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%1. %n՝ արդեն նորից լուսանկարված</numerusform>
            <numerusform>%1. %n՝ արդեն նորից լուսանկարված</numerusform>
        </translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մի կողմ դրված</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նկարահանվում է</translation>
    </message>
    <message>
        <source>Queued</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հերթում</translation>
    </message>
    <message>
        <source>Processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մշակվում է</translation>
    </message>
    <message>
        <source>Paused</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դադարեցված</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կանգնած</translation>
    </message>
    <message>
        <source>Needs review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ստուգման ենթակա</translation>
    </message>
    <message>
        <source>Done</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Պատրաստ</translation>
    </message>
    <message>
        <source>Draft: review it, then reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Սևագիր. ստուգեք, ապա վերամշակեք</translation>
    </message>
    <message>
        <source>Masks edited: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դիմակները փոխված են. վերամշակեք</translation>
    </message>
    <message>
        <source>Scale in doubt: see the report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մասշտաբը կասկածելի է. տես հաշվետվությունը</translation>
    </message>
    <message>
        <source>Decided: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Որոշված է. վերամշակեք</translation>
    </message>
    <message>
        <source>%1 sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 վստահ</translation>
    </message>
    <message>
        <source>%1 decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 որոշված</translation>
    </message>
    <message>
        <source>%1 to review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 ստուգելու</translation>
    </message>
    <message>
        <source>draft, to be reprocessed; %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>սևագիր, վերամշակելու. %1</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n to reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%1; %n վերալուսանկարելու</numerusform>
            <numerusform>%1; %n վերալուսանկարելու</numerusform>
        </translation>
    </message>
    <message>
      <source>%1; joined to within %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. միացված են առավելագույնը %2 mm սխալով</translation>
    </message>
    <message numerus="yes">
      <source>%1 is ready: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1-ը պատրաստ է՝ %n բեկոր։</numerusform>
        <numerusform>%1-ը պատրաստ է՝ %n բեկոր։</numerusform>
      </translation>
    </message>
    <message>
      <source>You cancelled it. Finished stages are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք չեղարկեցիք։ Ավարտված փուլերը պահված են։</translation>
    </message>
    <message>
      <source>You removed it from the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք հանեցիք հերթից։</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) queued.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Դադար. սպասում է %n խմբաքանակ։</numerusform>
        <numerusform>Դադար. սպասում է %n խմբաքանակ։</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the markers by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկը տեղաշարժվել է. վրիպում է նշիչներից %2 px, տրամաչափման տեղից %3 մմ հեռու։</translation>
    </message>
    <message>
      <source>It was interrupted. Reprocess it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընդհատվել է. վերամշակեք։</translation>
    </message>
    <message>
      <source>No bag was given; its sherds get their context in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակ չի նշվել. դրա բեկորները համատեքստը ստանում են կատալոգում։</translation>
    </message>
    <message>
        <source>%1: stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1՝ կանգնեցվում է…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կանգնեցվում է…</translation>
    </message>
    <message>
      <source>%1, %2 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Draft: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Սևագիր՝ %1</translation>
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
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Համարներ տալ</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Փոխարինել չափված արժեքով</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n արժեք հաստատման կարիք ունի։</numerusform>
            <numerusform>%n արժեք հաստատման կարիք ունի։</numerusform>
        </translation>
    </message>
    <message>
      <source>rejected: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մերժված է՝ %1</translation>
    </message>
    <message>
      <source>Cancel and undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել և հետ վերցնել</translation>
    </message>
    <message>
      <source>To change: %1. Unchanged: %2. Rejected: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոխվող՝ %1։ Անփոփոխ՝ %2։ Մերժված՝ %3։</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համեմատել</translation>
    </message>
    <message>
      <source>Type a value to see what would change, or press Enter in the empty field to delete.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մուտքագրեք արժեք՝ տեսնելու, թե ինչ կփոխվի, կամ դատարկ դաշտում սեղմեք Enter՝ ջնջելու համար։</translation>
    </message>
    <message>
      <source>Make these bags</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստեղծել տոպրակները</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CandidateBar</name>
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
    <message>
        <source>gap %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>բացվածք %1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>հպում չկա</translation>
    </message>
    <message>
      <source>Another back…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ հետևի երես …</translation>
    </message>
    <message>
      <source>by outline alone</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>միայն ըստ ուրվագծի</translation>
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
</context>
<context>
    <name>ostraka::ui::CaptureScreen</name>
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
      <translation>Մուտքագրել բեկորների համարները</translation>
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
      <source>'%1' names no bag: write site-trench-context-bag, or empty the line to go on without one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1»-ը տոպրակ չի անվանում. գրեք հուշարձան-խրամատ-համատեքստ-տոպրակ կամ դատարկեք տողը՝ առանց դրա շարունակելու համար։</translation>
    </message>
    <message>
      <source>Set this batch aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի կողմ դնել այս խմբաքանակը</translation>
    </message>
    <message>
      <source>The bag is another now, the numbers are not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակն այժմ ուրիշ է, համարները՝ ոչ</translation>
    </message>
    <message>
      <source>Not as this bag&apos;s sherds are numbered: %1. Type them anew (N, or later in the catalogue), or say that they are right.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այնպես չեն, ինչպես համարակալվում են այս տոպրակի բեկորները. %1։ Մուտքագրեք դրանք նորից (N, կամ հետո՝ գրացուցակում) կամ ասեք, որ ճիշտ են։</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լավ</translation>
    </message>
    <message>
        <source>Next step</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հաջորդ քայլը</translation>
    </message>
    <message>
      <source>Stop turntable</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել սեղանը</translation>
    </message>
    <message>
      <source>Change rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ սարքակազմ…</translation>
    </message>
    <message>
      <source>Loading picture…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերը գալիս է։</translation>
    </message>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ նայեք սրան</translation>
    </message>
    <message>
      <source>Type how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ասել, թե քանի բեկոր կա</translation>
    </message>
    <message>
      <source>Import cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծումը չեղարկված է. ոչինչ չի մնացել։</translation>
    </message>
    <message>
      <source>Import anyway</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել այնուամենայնիվ</translation>
    </message>
    <message>
      <source>Photograph this side again?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարե՞լ այս երեսը ևս մեկ անգամ</translation>
    </message>
    <message>
      <source>Keep these numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրանք ճիշտ են</translation>
    </message>
    <message>
        <source>%1 The rig that worked before stays in use.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 Նախկին սարքակազմը մնում է գործածության մեջ:</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցնել</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել լուսանկարները</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, %2 %</translation>
    </message>
    <message>
      <source>%1 already has these files, so nothing was imported. If you import them anyway, its sherds appear twice in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն արդեն ունի այս ֆայլերը, ուստի ոչինչ չի ներմուծվել։ Եթե այնուամենայնիվ ներմուծեք դրանք, դրա բեկորները կատալոգում երկու անգամ կլինեն։</translation>
    </message>
    <message>
      <source>%1 already has %2 of these %3 files, so nothing was imported. If you import them anyway, the catalogue holds the sherds of both batches; if you do not want that, set %1 aside in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն արդեն ունի այս %3 ֆայլերից %2-ը, ուստի ոչինչ չի ներմուծվել։ Եթե այնուամենայնիվ ներմուծեք դրանք, կատալոգում երկուսի բեկորներն էլ կլինեն. եթե դա չեք ուզում, հերթում %1-ը մի կողմ դրեք։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>The label beside the backs names %1, but the fronts are of %2: check that these are the same sherds, or correct the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսների մոտ դրված պիտակում նշված է %1, իսկ առջևի երեսները %2-ից են. ստուգեք՝ արդյոք նույն բեկորներն են, կամ ուղղեք տոպրակը։</translation>
    </message>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը բացվում է</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղմեք %1 տեսախցիկի կոճակը։</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմ դեռ չկա</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրեք բեկորները սկավառակին</translation>
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
    <message>
      <source>This camera has no live view.</source>
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
      <source>You counted %1 sherds, the photographs show %2: look for one that is hidden, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք հաշվել եք %1 բեկոր, լուսանկարները ցույց են տալիս %2. փնտրեք մեկը, որ թաքնված է, դիպչում է մյուսին կամ չի դրվել։</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք հաշվել եք %1</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն ընդհատվել է այս երեսի կեսին։</translation>
    </message>
    <message>
      <source>%1 is photographed whole, but nobody said that it is right: look at its photographs, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն ամբողջությամբ լուսանկարված է, բայց ոչ ոք չի ասել, որ այն ճիշտ է. նայեք լուսանկարները, ապա շարունակեք։</translation>
    </message>
    <message>
      <source>To be photographed again: %1. Lay them down with others, and type their numbers (N) when the fronts are shot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նորից լուսանկարելու՝ %1։ Դրեք դրանք մյուսների հետ և մուտքագրեք նրանց համարները (N), երբ առջևի երեսները լուսանկարված են։</translation>
    </message>
    <message>
      <source>Labels of several bags are in sight: %1. Leave the one of these sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երևում են մի քանի տոպրակի պիտակներ՝ %1։ Թողեք միայն այս բեկորներինը։</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: check whether one is in fragments or an object is not a sherd, or correct the count.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք հաշվել եք %1 բեկոր, լուսանկարները ցույց են տալիս %2. նայեք՝ արդյոք մեկը մասերով է դրված, կամ կա մի բան, որ բեկոր չէ, կամ ուղղեք քանակը։</translation>
    </message>
    <message>
        <source>The rig does not open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Սարքակազմը չի բացվում</translation>
    </message>
    <message>
        <source>Taking calibration photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Արվում են տրամաչափման լուսանկարներ</translation>
    </message>
    <message>
        <source>The virtual rig turns the sherds over</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վիրտուալ սարքակազմը շրջում է բեկորները</translation>
    </message>
    <message>
        <source>Nothing to do by hand: shoot the backs.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ձեռքով անելիք չկա. լուսանկարեք հետևի երեսները։</translation>
    </message>
    <message>
        <source>Resume at position %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Շարունակել %1 դիրքից</translation>
    </message>
    <message>
        <source>Shoot the backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լուսանկարել հետևի երեսները</translation>
    </message>
    <message>
        <source>Calibration photograph %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Տրամաչափման լուսանկար %1 / %2</translation>
    </message>
    <message>
        <source>Position %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դիրք %1 / %2</translation>
    </message>
    <message>
        <source>Opening the rig…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Սարքակազմը բացվում է</translation>
    </message>
    <message>
        <source>Lighting OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լույսը կարգին է</translation>
    </message>
    <message>
      <source>%1 resumes where it stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը շարունակվում է կանգ առած տեղից։</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Այս երեսի %n լուսանկարն ապահով է։</numerusform>
        <numerusform>Այս երեսի %n լուսանկարներն ապահով են։</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at position %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1, դիրք %2՝ %3</translation>
    </message>
    <message>
      <source>Check the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ազատելուց առաջ նայեք սկավառակին</translation>
    </message>
    <message>
      <source>Fronts up, two centimetres apart, the markers at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսը վեր, երկու սանտիմետր հեռավորություն, եզրի նշիչներն ազատ։</translation>
    </message>
    <message>
      <source>Hands off the turntable. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեռք մի տվեք սեղանին։ Esc-ը անմիջապես կանգնեցնում է այն։</translation>
    </message>
    <message>
      <source>Space accepts anyway, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացատը շարունակում է ամեն դեպքում, R-ը կրկին լուսանկարում է հետևի երեսները։</translation>
    </message>
    <message>
      <source>Accept and queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընդունել և դնել հերթի</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) saved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n լուսանկարն ապահով է</numerusform>
        <numerusform>%n լուսանկարներն ապահով են</numerusform>
      </translation>
    </message>
    <message>
      <source>Markers %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչներ՝ %1 %2-ից</translation>
    </message>
    <message>
      <source>Release camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ազատել տեսախցիկը</translation>
    </message>
    <message>
      <source>Markers %1 of %2, %3 needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչներ՝ %1 %2-ից, պետք է %3</translation>
    </message>
    <message>
      <source>Its sherds are in the review (Ctrl+3): check them while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրա բեկորները ստուգման մեջ են (Ctrl+3). նայեք, քանի դեռ այստեղ են</translation>
    </message>
    <message>
        <source>The turntable stands still. Saved photographs are kept.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Պտտվող սեղանը կանգնած է։ Պահված լուսանկարները մնում են։</translation>
    </message>
    <message>
      <source>Nothing is wrong with the photographs of this side. Space or Esc keeps them; R once more puts all of them aside and takes new ones.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս երեսի լուսանկարներում սխալ չկա։ Բացատը կամ Esc-ը պահում է դրանք. ևս մեկ անգամ R-ը բոլորը մի կողմ է դնում և նորերն է անում։</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել լուսանկարները</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցվում է…</translation>
    </message>
    <message>
      <source>%1 is processed; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը մշակված է. հաջորդ խմբաքանակը մեկ սեղմում հեռու է։</translation>
    </message>
    <message>
      <source>No photograph of this side has been taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս երեսից ոչ մի լուսանկար չի արվել։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueScreen</name>
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
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրեք այն բեկորները, որոնք պետք է համար ստանան։</translation>
    </message>
    <message>
        <source>No sherds yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դեռ բեկորներ չկան</translation>
    </message>
    <message>
        <source>Sherds appear here when a batch is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բեկորները կհայտնվեն այստեղ, երբ խմբաքանակը մշակվի։</translation>
    </message>
    <message>
        <source>No sherds match this filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այս զտիչին համապատասխան բեկոր չկա</translation>
    </message>
    <message>
        <source>Remove a condition to see more.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հանեք մի պայման՝ ավելին տեսնելու համար:</translation>
    </message>
    <message>
        <source>Clear filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մաքրել զտիչը</translation>
    </message>
    <message>
        <source>Model</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մոդել</translation>
    </message>
    <message>
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Համարներ տալ</translation>
    </message>
    <message>
        <source>A void sherd gets no label, drawing or place on a plate, and its number is never given again. Is %1 void: “%2”?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Անվավեր բեկորը պիտակ, գծագիր կամ տեղ սկավառակի վրա չի ստանում, և դրա համարն այլևս չի տրվում։ %1-ն անվավե՞ր է. «%2»</translation>
    </message>
    <message>
      <source>Import…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել …</translation>
    </message>
    <message>
      <source>Dismiss</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անտեսել</translation>
    </message>
    <message>
        <source>Void sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Անվավեր դարձնել բեկորը</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համեմատել</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it; closing again discards it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ պահված չէ՝ %1։ Դաշտում Enter-ը պահում է, նորից փակելը՝ չեղարկում։</translation>
    </message>
    <message numerus="yes">
      <source>Export %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Արտահանել %n բեկոր</numerusform>
        <numerusform>Արտահանել %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>Print labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել պիտակները</translation>
    </message>
    <message>
      <source>sherd labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկորների պիտակներ</translation>
    </message>
    <message>
      <source>Only sherds with a number get a label: assign the numbers first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիտակ են ստանում միայն համար ունեցող բեկորները. նախ տվեք համարները։</translation>
    </message>
    <message>
      <source>Rename places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերանվանել տեղերը</translation>
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
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյոք շուրթ է</translation>
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
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ է ասում գծանկարը</translation>
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
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է՝ %1</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարն ուղարկվում է տպիչին. տպեք 100 % չափով։</translation>
    </message>
    <message>
      <source>Automatic</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինքնաշխատ</translation>
    </message>
    <message>
      <source>Rim sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շուրթի բեկոր</translation>
    </message>
    <message>
      <source>No rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շուրթ չկա</translation>
    </message>
    <message>
      <source>Save…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել …</translation>
    </message>
    <message>
      <source>Print…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել …</translation>
    </message>
    <message>
      <source>Previous sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ թերթը</translation>
    </message>
    <message>
      <source>Next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդ թերթը</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկված է. ոչինչ չի գծվել։</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Գծվում է %n բեկոր …</numerusform>
        <numerusform>Գծվում է %n բեկոր …</numerusform>
      </translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg);;PNG, the views of each sherd (*.png);;TIFF, the views of each sherd (*.tif)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, բոլոր թերթերը (*.pdf);;SVG, մեկ ֆայլ ամեն թերթի համար (*.svg);;PNG, ամեն բեկորի տեսքերը (*.png);;TIFF, ամեն բեկորի տեսքերը (*.tif)</translation>
    </message>
    <message>
      <source>Different</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տարբեր</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportModel</name>
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
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս անունով պանակ արդեն կա. ընտրեք այլ անուն։</translation>
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
        <numerusform>%n բեկոր, %1, ցուցակը ստուգված է</numerusform>
        <numerusform>%n բեկոր, %1, ցուցակը ստուգված է</numerusform>
      </translation>
    </message>
    <message>
      <source>Counting…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվում է …</translation>
    </message>
    <message>
      <source>No sherds match this selection.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի բեկոր չի համապատասխանում. ընտրեք ուրիշները։</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկված է. ոչինչ չի մնացել։</translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>որից %n-ն առանց մոդելի՝ %1</numerusform>
        <numerusform>որից %n-ն առանց մոդելի՝ %1</numerusform>
      </translation>
    </message>
    <message>
      <source>The whole project, %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ամբողջ նախագիծը, %1</translation>
    </message>
    <message numerus="yes">
      <source>%n file(s) of the project are missing, changed or links; damage.txt in the archive lists them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Նախագծի %n ֆայլ բացակայում է, փոխվել է կամ հղում է. արխիվի damage.txt-ը նշում է այն։</numerusform>
        <numerusform>Նախագծի %n ֆայլ բացակայում է, փոխվել է կամ հղում է. արխիվի damage.txt-ը նշում է դրանք։</numerusform>
      </translation>
    </message>
    <message>
        <source>Everything in the project, with checksums. &apos;Restore an archive&apos; on the start screen makes the project from it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նախագծի ամբողջ պարունակությունը՝ ստուգիչ գումարներով։ Մեկնարկի էկրանի «Վերականգնել արխիվը» կոճակը դրանից նորից նախագիծ է ստեղծում։</translation>
    </message>
    <message numerus="yes">
        <source>%n batch(es) in the queue: the archive holds their photographs and the stages that are finished when it is made; the restored project processes the rest.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Հերթում %n խմբաքանակ կա. արխիվը պարունակում է դրա լուսանկարները և մինչ այդ ավարտված փուլերը. մնացածը մշակում է վերականգնված նախագիծը։</numerusform>
            <numerusform>Հերթում %n խմբաքանակ կա. արխիվը պարունակում է դրանց լուսանկարները և մինչ այդ ավարտված փուլերը. մնացածը մշակում է վերականգնված նախագիծը։</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportScreen</name>
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
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանվողի զտիչ</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համատեքստ:0012</translation>
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
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման ընթացքը</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացել պանակը</translation>
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
      <source>How large a GLB may be. PLY and OBJ get the same surface. Larger models get fewer triangles and smaller photographs; how far they are off is measured and stated in each file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որքան մեծ կարող է լինել GLB նիշքը։ PLY-ն և OBJ-ն ունեն նույն մակերևույթը։ Ավելի մեծ մոդելները ստանում են ավելի քիչ եռանկյուններ և ավելի փոքր լուսանկարներ. շեղումը չափվում և գրվում է յուրաքանչյուր նիշքում։</translation>
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
    <message>
      <source>The export is not finished, and nothing of it would be kept. Close once more to stop it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանումն ավարտված չէ, և դրանից ոչինչ չէր մնա։ Դադարեցնելու համար փակեք ևս մեկ անգամ։</translation>
    </message>
    <message>
        <source>Matching the filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Զտիչին համապատասխան</translation>
    </message>
    <message>
        <source>Formats</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ձևաչափեր</translation>
    </message>
    <message>
        <source>Records (JSON), re-importable</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Գրառումներ (JSON), վերաներմուծելի</translation>
    </message>
    <message>
        <source>Full detail</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լրիվ մանրամասնություն</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Չեղարկել</translation>
    </message>
    <message>
        <source>Selected sherds</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ընտրված բեկորներ</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել …</translation>
    </message>
    <message>
      <source>Folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման պանակ</translation>
    </message>
    <message>
      <source>fit to A4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ըստ A4-ի</translation>
    </message>
    <message>
      <source>for the web, up to 5 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>համացանցի համար, մինչև 5 ՄԲ</translation>
    </message>
    <message>
      <source>for a phone, up to 1 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հեռախոսի համար, մինչև 1 ՄԲ</translation>
    </message>
    <message>
      <source>Tables (CSV): English headings, decimal points</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակներ (CSV)՝ անգլերեն վերնագրեր, տասնորդական կետ</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակներ (ODS)՝ LibreOffice, Excel</translation>
    </message>
    <message>
      <source>The whole project, as an archive</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ամբողջ նախագիծը՝ որպես արխիվ</translation>
    </message>
    <message>
      <source>Surfaces in the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մակերեսները գծանկարներում</translation>
    </message>
    <message numerus="yes">
      <source>%n selected sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ընտրված %n բեկոր</numerusform>
        <numerusform>Ընտրված %n բեկոր</numerusform>
      </translation>
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
      <translation>rim T3 հաստություն&gt;6</translation>
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
      <source>Remove the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հանել %1 պայմանը</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, entered&gt;=2026-07-01, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բառերը փնտրվում են ամենուր. գործում են նաև ware:grey, հաստություն&gt;6, գրանցում&gt;=2026-07-01, -burnt, նշում:*։</translation>
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
        <source>Idle</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Պարապ</translation>
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
      <translation>Բեկորների ամբողջական, չափված եռաչափ մոդելներ՝ երկու երեսների լուսանկարներից։</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Apache License 2.0։ Օգտագործում է, ի թիվս այլոց, Qt (LGPL 3), VTK և OpenCV. LICENSE ֆայլը և README-ն թվարկում են բոլորը։</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեռնարկը միայն անգլերեն է։</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: the program uses no network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ դուրս չի գալիս այս համակարգչից. այն ցանց չունի։</translation>
    </message>
    <message>
      <source>Search the manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փնտրել ձեռնարկում</translation>
    </message>
    <message>
      <source>The manual does not mention &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձեռնարկը չի հիշատակում «%1»։</translation>
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
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծել կատալոգ</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստեղծել դեռ չեղած հուշարձաններ, խրամատներ, համատեքստեր և տոպրակներ</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծման ընթացքը</translation>
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
      <source>Keep the other versions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել մյուս տարբերակները</translation>
    </message>
    <message>
        <source>to confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>հաստատել</translation>
    </message>
    <message>
        <source>Rows</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Տողեր</translation>
    </message>
    <message>
        <source>Columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Սյունակներ</translation>
    </message>
    <message numerus="yes">
        <source>Columns (%n to check)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Սյունակներ (%n ստուգելու)</numerusform>
            <numerusform>Սյունակներ (%n ստուգելու)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Confirm %n row(s)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Հաստատել %n տող</numerusform>
            <numerusform>Հաստատել %n տող</numerusform>
        </translation>
    </message>
    <message>
      <source>updated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխված է</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մերժված</translation>
    </message>
    <message>
      <source>unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչպես կա</translation>
    </message>
    <message>
      <source>Table (CSV)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակ (CSV) …</translation>
    </message>
    <message>
      <source>Export folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման պանակ …</translation>
    </message>
    <message>
      <source>Effect of each row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչ կաներ ամեն տողը</translation>
    </message>
    <message>
      <source>Save rejected rows…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել մերժվածը …</translation>
    </message>
    <message>
      <source>Save rejected rows</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել մերժվածը</translation>
    </message>
    <message>
      <source>rejected.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>refused.csv</translation>
    </message>
    <message>
      <source>Line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տող</translation>
    </message>
    <message>
      <source>Action</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչ է լինում</translation>
    </message>
    <message>
      <source>Reason</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչու ոչ</translation>
    </message>
    <message>
      <source>Reading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիտվում է …</translation>
    </message>
    <message>
      <source>Imported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծված է՝ %1</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ չվերցնել</translation>
    </message>
    <message numerus="yes">
      <source>Import %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ներմուծել %n տող</numerusform>
        <numerusform>Ներմուծել %n տող</numerusform>
      </translation>
    </message>
    <message>
      <source>Another project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այլ նախագիծ …</translation>
    </message>
    <message>
        <source>A table of sherds has a column with their numbers; one of contexts has a column with theirs. Their names may be in any of the program's languages.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բեկորների աղյուսակն ունի դրանց համարների սյունակ, համատեքստերինը՝ դրանց համարների սյունակ։ Անունները կարող են լինել ծրագրի ցանկացած լեզվով։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 «%2»՝ %3</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n տող հաստատման կարիք ունի։</numerusform>
            <numerusform>%n տող հաստատման կարիք ունի։</numerusform>
        </translation>
    </message>
    <message>
      <source>%1 new, %2 updated, %3 unchanged, %4 rejected.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 նոր, %2 փոխված, %3 ինչպես կան, %4 մերժված։</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկված է. ոչինչ չի ներմուծվել։</translation>
    </message>
    <message numerus="yes">
      <source>Cancelled: %n row(s) were not imported. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Կանգնեցված է. %n տող մուտքագրված չէ: Մնացածի համար կրկին ներմուծեք աղյուսակը:</numerusform>
        <numerusform>Կանգնեցված է. %n տող մուտքագրված չէ: Մնացածի համար կրկին ներմուծեք աղյուսակը:</numerusform>
      </translation>
    </message>
    <message>
      <source>Undo does not take back contexts and bags; the catalogue is backed up before the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետարկումը չի հանում համատեքստերն ու տոպրակները. ներմուծումից առաջ կատալոգի պահուստային պատճեն է արվում։</translation>
    </message>
    <message>
      <source>Undo does not take back new sherds; each can be voided in its details.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետարկումը նոր բեկորները չի հանում. յուրաքանչյուրը կարելի է չեղարկել իր մանրամասներում։</translation>
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
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ամենուր</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկը կանգնեցվում է. կշարունակվի, երբ նախագիծը նորից բացվի։ Պատուհանը շուտով կփակվի։</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետարկել՝ %1</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգը չհաջողվեց պատճենել. %1</translation>
    </message>
    <message>
        <source>%1 is ready.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1-ը պատրաստ է:</translation>
    </message>
    <message>
        <source>Redo</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կրկնել</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կրկնել. %1</translation>
    </message>
    <message>
      <source>Queue: editing masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հերթ. դիմակների խմբագրում</translation>
    </message>
    <message>
      <source>%1 (read-only)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (միայն ընթերցում)</translation>
    </message>
    <message>
      <source>%1 is being processed. Leaving the project stops it, and it continues when the project is opened again. Choose Projects once more to leave.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը մշակվում է։ Նախագծից դուրս գալը կանգնեցնում է մշակումը. այն շարունակվում է, երբ նախագիծը նորից բացվի։ Դուրս գալու համար ևս մեկ անգամ ընտրեք «Նախագծեր»։</translation>
    </message>
    <message>
      <source>Import cancelled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծումը չեղարկվեց</translation>
    </message>
    <message>
      <source>The project that was created for it is removed. Your photographs are as they were.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրա համար ստեղծված նախագիծը հեռացված է։ Ձեր լուսանկարներն այնպես են, ինչպես կային։</translation>
    </message>
    <message>
        <source>Restoring cancelled</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերականգնումը չեղարկվեց</translation>
    </message>
    <message>
        <source>Nothing was left behind.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ոչինչ չի մնացել։</translation>
    </message>
    <message>
        <source>The project is restored.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նախագիծը վերականգնված է։</translation>
    </message>
    <message>
        <source>It was archived with damage:</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այն արխիվացվել էր վնասներով՝</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapScreen</name>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպել քարտեզն ու պիտակները</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկոր %1</translation>
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
    <message>
        <source>No map yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դեռ քարտեզ չկա</translation>
    </message>
    <message>
      <source>The map is still loading.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Քարտեզը դեռ բեռնվում է։</translation>
    </message>
    <message>
        <source>The map of a batch appears here once it is processed, and shows which sherd lay where.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Խմբաքանակի քարտեզը երևում է այստեղ մշակումից հետո և ցույց է տալիս, թե որ բեկորը որտեղ էր։</translation>
    </message>
    <message>
      <source>%1 map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 քարտեզ և պիտակներ</translation>
    </message>
    <message>
      <source>bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պարկերի պիտակներ</translation>
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
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեռնվում է…</translation>
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
        <source>Dismiss</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Փակել</translation>
    </message>
    <message>
        <source>OK</source>
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
      <source>No model yet: it comes when the batch of the sherd is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդել դեռ չկա. այն ստեղծվում է, երբ բեկորի խմբաքանակը մշակվի։</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the model cannot be turned.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս էկրանը OpenGL 3.2 չունի, ուստի մոդելը պտտել հնարավոր չէ։</translation>
    </message>
    <message>
      <source>No model: the sherd belongs to no batch of photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդել չկա. բեկորը լուսանկարների ոչ մի խմբաքանակի չի պատկանում։</translation>
    </message>
    <message>
      <source>Large view</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեծ տեսք</translation>
    </message>
    <message>
      <source>The model alone, as large as the page; again or Esc: beside the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միայն մոդելը՝ ամբողջ էջով. կրկին կամ Esc՝ աղյուսակի կողքին</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site&apos;s code has two to eight letters from A to Z and digits, without accents, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձանի ծածկագիրը երկուսից ութ լատինական մեծատառ (A-ից Z) և թվանշան ունի, ինչպես ARM1։</translation>
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
    <message>
        <source>Photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լուսանկարներ</translation>
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
      <translation>Իրար վրա դրված ուրվագծեր և նրանց շրջադարձի անկյունները</translation>
    </message>
    <message>
      <source>Outlines overlaid</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ուրվագծերն իրար վրա</translation>
    </message>
    <message>
      <source>Turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>շրջադարձի անկյուններ</translation>
    </message>
    <message>
      <source>The lines of a pair lie on each other.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգի գծերը համընկնում են։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CardInHand</name>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երես ընտրված չէ։</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի ընտրություն</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկզբնակետ</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ձեռքով շրջում</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միայնակ հետևի երեսը փակ մոդել չունի։</translation>
    </message>
    <message>
      <source>Cancelled. The back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կանգնեցված է. հետևի երեսը մնում է իր տեղում։</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ միայն փորձարկվել էր, այլևս չկա. դրա զույգերը փակվել են։</translation>
    </message>
    <message>
      <source>The fractures do not touch here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքներն այստեղ չեն հպվում։</translation>
    </message>
    <message>
      <source>Fractures %1 apart, %2 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքների հեռավորությունը %1, հպվում է %2-ը։</translation>
    </message>
    <message>
      <source>Turned by hand; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շրջված է ձեռքով. B-ն ճշգրտում է հարմարեցումը։</translation>
    </message>
    <message>
      <source>Start point %1; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկզբնակետ %1. B-ն ճշգրտում է հարմարեցումը։</translation>
    </message>
    <message>
      <source>refining the fit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հարմարեցման ճշգրտում</translation>
    </message>
    <message>
      <source>This pair has no closed model yet. Reprocess the batch to make it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս զույգը դեռ փակ մոդել չունի։ Վերամշակեք խմբաքանակը՝ այն ստեղծելու համար։</translation>
    </message>
    <message>
      <source>This back has no partner.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս հետևի երեսը մենակ է։</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեռնվում է…</translation>
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
      <translation>Նախ ընտրեք հետևի երես։</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ գրեք ձեր սկզբնատառերը. ամեն որոշում պահում է իր անունը։</translation>
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
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգ ընտրված չէ. նախ այս հետևի երեսը տվեք առջևի երեսի։</translation>
    </message>
    <message>
        <source>reshooting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1-ի վերալուսանկարում</translation>
    </message>
    <message>
        <source>merging %1 and %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1-ի և %2-ի միավորում</translation>
    </message>
    <message>
        <source>splitting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1-ի բաժանում</translation>
    </message>
    <message>
      <source>One of the two has no back to merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկուսից մեկը միավորելու հետևի երես չունի։</translation>
    </message>
    <message>
      <source>A pair can be decided once it is shown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգի մասին կարելի է որոշել, երբ այն ցուցադրված է։</translation>
    </message>
    <message>
      <source>All pairs of this batch are decided.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի բոլոր զույգերը որոշված են։</translation>
    </message>
    <message>
      <source>Saved. Check %1 – %2: only %3 of their fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։ Ստուգեք %1 – %2. դրանց կոտրվածքների միայն %3-ն է հպվում։</translation>
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
      <translation>Սլաքները տեղաշարժում են գիծը, Shift-ի հետ՝ թեքում, Վերև կամ Ներքև՝ մյուս երեսը, Enter՝ կտրում է։ Կամ մկնիկով գիծ քաշեք։</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեռնվում է…</translation>
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
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձան, խրամատ, համատեքստ և տոպրակ</translation>
    </message>
    <message>
      <source>New: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր՝ %1</translation>
    </message>
    <message>
      <source>scan its label, or %1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկանավորեք պիտակը կամ %1-T3-0012-4</translation>
    </message>
    <message>
      <source>Write the bag as site-trench-context-bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրեք տոպրակը այսպես՝ հուշարձան-խրամատ-համատեքստ-տոպրակ։</translation>
    </message>
    <message>
      <source>No bag: the sherds can be numbered once the catalogue gives them a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակ չկա. բեկորները կարելի է համարակալել, երբ կատալոգը նրանց համատեքստ տա։</translation>
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
    <name>ostraka::ui::QueueScreen</name>
    <message>
      <source>This batch has no masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը դիմակներ չունի։</translation>
    </message>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դադար</translation>
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
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը դեռ հաշվետվություն չունի։</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախ սևագրեր</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ է տեղաշարժվել. այս խմբաքանակի լուսանկարները ցույց են տալիս, թե որտեղ են հիմա տեսախցիկները (C)</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերամշակել</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Չեղարկել</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ցույց տալ հաշվետվությունը</translation>
    </message>
    <message>
        <source>Review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ստուգել</translation>
    </message>
    <message>
        <source>Edit masks</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Խմբագրել դիմակները</translation>
    </message>
    <message>
        <source>Open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բացել</translation>
    </message>
    <message>
        <source>Processes each new batch quickly and coarsely, for a check while the sherds are still on the plate; reprocessing makes it final (D)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ամեն նոր խմբաքանակ մշակում է արագ և կոպիտ՝ ստուգելու, քանի դեռ բեկորները սկավառակին են. վերամշակումը դարձնում է վերջնական (D)</translation>
    </message>
    <message>
        <source>Recalibrate rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերատրամաչափել սարքակազմը</translation>
    </message>
    <message>
        <source>What you photograph or import is processed here, one batch after the other, while you go on working.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լուսանկարվածն ու ներմուծվածը մշակվում է այստեղ, խմբաքանակ առ խմբաքանակ, մինչ դուք շարունակում եք աշխատել:</translation>
    </message>
    <message>
        <source>Batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Խմբաքանակ</translation>
    </message>
    <message>
        <source>Resume</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Շարունակել</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մի կողմ դնել</translation>
    </message>
    <message>
        <source>Cancel %1?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Չեղարկե՞լ %1-ը</translation>
    </message>
    <message>
        <source>It has been processing for more than an hour. Finished stages are saved; the current one is lost.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մշակվում է ավելի քան մեկ ժամ: Ավարտված փուլերը պահված են, ընթացիկը կկորչի:</translation>
    </message>
    <message>
        <source>Cancel it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Չեղարկել</translation>
    </message>
    <message>
        <source>Keep processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Շարունակել մշակումը</translation>
    </message>
    <message>
      <source>Marker side…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչի կողմը…</translation>
    </message>
    <message>
      <source>Keep both</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահել երկուսը</translation>
    </message>
    <message>
      <source>Processes this batch although another one has the same photographs; the sherds of both are then in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մշակում է այս խմբաքանակը, թեև մեկ ուրիշն ունի նույն լուսանկարները. այդ դեպքում երկուսի բեկորներն էլ կատալոգում են</translation>
    </message>
    <message>
      <source>The report of %1 is not opened: this version of Ostraka did not write it, and it may run scripts. Reprocess the batch to write it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի հաշվետվությունը չի բացվում. այն չի գրել Ostraka-ի այս տարբերակը, և այն կարող է սկրիպտներ գործարկել։ Վերամշակեք խմբաքանակը, որպեսզի այն նորից գրվի։</translation>
    </message>
    <message>
        <source>The queue is paused: this project was restored from an archive.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հերթը դադարեցված է. այս նախագիծը վերականգնվել է արխիվից։</translation>
    </message>
    <message>
        <source>Its batches that are not processed yet wait until you resume it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դեռ չմշակված խմբաքանակները սպասում են, մինչև հերթը շարունակեք։</translation>
    </message>
    <message>
        <source>Photographs are being imported; their batch appears here when all of them are copied.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լուսանկարները ներմուծվում են. դրանց խմբաքանակն այստեղ կհայտնվի, երբ բոլորը պատճենվեն։</translation>
    </message>
    <message>
        <source>Show the import</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ցույց տալ ներմուծումը</translation>
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
      <translation>Կայաններ</translation>
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
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդել</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի կողմ</translation>
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
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղմեք բեկորի վրա երկարության մի ծայրին, ապա՝ մյուսին։ D-ն ավարտում է։</translation>
    </message>
    <message>
        <source>Accept</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ընդունել</translation>
    </message>
    <message>
        <source>Leave merging and splitting</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դուրս գալ միավորումից և բաժանումից</translation>
    </message>
    <message>
        <source>Refine fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ճշգրտել համադրումը</translation>
    </message>
    <message>
        <source>Refine the position by the fracture surfaces (B)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ճշգրտել դիրքը ըստ կոտրվածքների (B)</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերալուսանկարել</translation>
    </message>
    <message>
        <source>View</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Տեսք</translation>
    </message>
    <message>
        <source>Fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Համադրում</translation>
    </message>
    <message>
        <source>Decide</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Որոշել</translation>
    </message>
    <message>
        <source>Explode</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հեռացնել</translation>
    </message>
    <message>
        <source>Fracture gap</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կոտրվածքի բացվածք</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բաժանել</translation>
    </message>
    <message>
        <source>Split a scan of two sherds along a line over its photograph (K)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Երկու բեկորի սկանը բաժանել լուսանկարի վրայի գծով (K)</translation>
    </message>
    <message>
        <source>Merge</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Միավորել</translation>
    </message>
    <message>
        <source>Merge two fragments of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Միավորել մեկ բեկորի երկու կտոր. ապա ընտրել մյուս քարտը (J առջևի երեսներ, Shift+J հետևի երեսներ)</translation>
    </message>
    <message>
        <source>Merge backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Միավորել հետևի երեսները</translation>
    </message>
    <message>
      <source>Comparing the fractures… Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքները համեմատվում են … Esc-ը կանգնեցնում է։</translation>
    </message>
    <message>
      <source>Refining the fit, fracture gap %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հարմարեցումը ճշգրտվում է, կոտրվածքի բացվածքը %1։ Esc-ը կանգնեցնում է։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ReviewScreen</name>
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
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգում</translation>
    </message>
    <message>
        <source>Update changed models</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Թարմացնել փոխված մոդելները</translation>
    </message>
    <message>
        <source>Reprocesses the pairs that were decided differently</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերամշակում է այլ կերպ որոշված զույգերը</translation>
    </message>
    <message>
        <source>No pairs to review yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Դեռ ստուգելու զույգեր չկան</translation>
    </message>
    <message>
        <source>Photograph or import a batch. Its pairs appear here when it is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լուսանկարեք կամ ներմուծեք խմբաքանակ: Դրա զույգերը կհայտնվեն այստեղ մշակումից հետո:</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ցույց տալ հաշվետվությունը</translation>
    </message>
    <message>
        <source>%1 was reshot as %2 in %3 and now has two records. Void one of them in the catalogue, or set the fragment aside here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1-ը վերալուսանկարվել է որպես %2 %3-ում և հիմա երկու գրառում ունի։ Մեկն անվավեր դարձրեք կատալոգում կամ կտորն այստեղ մի կողմ դրեք։</translation>
    </message>
    <message>
      <source>%1 is queued; only what changed is reprocessed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը հերթում է. վերամշակվում է միայն փոխվածը։</translation>
    </message>
    <message>
      <source>Saved. Pairs of the new fragments appear after reprocessing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։ Նոր կտորների զույգերը կհայտնվեն վերամշակումից հետո։</translation>
    </message>
    <message>
      <source>Undone. The history keeps both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետ է վերցված։ Երկուսն էլ մնում են պատմության մեջ։</translation>
    </message>
    <message>
      <source>No pairs to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգելու զույգեր չկան</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Ստուգելու %n զույգ</numerusform>
        <numerusform>Ստուգելու %n զույգ</numerusform>
      </translation>
    </message>
    <message>
      <source>No measurement of %1 is certain. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի ոչ մի չափը վստահելի չէ։ %2</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd has no number, and %1 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։ Վերամշակումից հետո միավորված բեկորը համար չի ունենա, իսկ %1 համարը կմնա առանց կտորի։ Հետարկումը նորից կբաժանի դրանք։</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd keeps the number %1, and %2 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։ Վերամշակումից հետո միավորված բեկորը կպահի %1 համարը, իսկ %2 համարը կմնա առանց կտորի։ Հետարկումը նորից կբաժանի դրանք։</translation>
    </message>
    <message>
      <source>%1 has no scale: no length shown here is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ում ոչ մի երկարություն հայտնի չէ. այստեղ ցույց տրված ոչ մի թիվ և երկարություն միլիմետրով չէ։</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, number %1 goes to the half that it was typed on, or else to the larger one. Undo merges them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։ Վերամշակելիս %1 համարը կանցնի այն կեսին, որի վրա գրվել է, այլապես՝ մեծին։ Հետարկումը նորից կմիավորի դրանք։</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: the sherds in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանված է։ %1-ի բոլոր զույգերը որոշված են։ Հաջորդը՝ բեկորները կատալոգում։</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: update the changed models.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանված է։ %1-ի բոլոր զույգերը որոշված են։ Հաջորդը՝ թարմացնել փոփոխված մոդելները։</translation>
    </message>
    <message>
      <source>Saved, with your initials.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանված է ձեր սկզբնատառերով։</translation>
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
    <message>
        <source>Keep current rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Պահել ընթացիկ սարքակազմը</translation>
    </message>
    <message>
      <source>Import photographs taken by hand, or choose a rig file (RIG.json), which names your cameras and your turntable. The virtual rig is for practice: its sherds are invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներմուծեք ձեռքով արված լուսանկարներ կամ ընտրեք սարքակազմի ֆայլ (RIG.json), որը նշում է ձեր տեսախցիկներն ու պտտվող սեղանը։ Վիրտուալ սարքակազմը վարժվելու համար է. նրա բեկորները հորինված են։</translation>
    </message>
    <message>
      <source>No rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առանց սարքակազմի</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկել</translation>
    </message>
    <message>
      <source>Use the virtual rig in this project?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Օգտագործե՞լ վիրտուալ սարքակազմն այս նախագծում</translation>
    </message>
    <message>
      <source>It is for practice: its sherds are invented, and they enter this project's catalogue. The queue marks its batches as invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն վարժվելու համար է. նրա բեկորները հորինված են և մտնում են այս նախագծի կատալոգը։ Հերթում նրա խմբաքանակները նշվում են որպես հորինված։</translation>
    </message>
    <message>
        <source>Importing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ներմուծվում է</translation>
    </message>
    <message>
        <source>The batch goes into the queue when all of its files are copied. Meanwhile you can choose a rig.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Խմբաքանակը հերթ է մտնում, երբ նրա բոլոր ֆայլերը պատճենված են։ Մինչ այդ կարող եք սարքակազմ ընտրել։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectEdit</name>
    <message>
      <source>As photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ինչպես լուսանկարված է</translation>
    </message>
    <message>
      <source>Without the light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առանց լույսի</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց նախագիծ</translation>
    </message>
    <message>
      <source>Na&amp;me</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ա&amp;նուն</translation>
    </message>
    <message>
      <source>Site &amp;code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձանի &amp;ծածկագիր</translation>
    </message>
    <message>
      <source>Textures of new mo&amp;dels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր մոդելների հ&amp;յուսվածքները</translation>
    </message>
    <message>
      <source>rename the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վերանվանել նախագիծը</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։</translation>
    </message>
    <message>
      <source>change the textures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխել հյուսվածքները</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::RightsEdit</name>
    <message>
      <source>Rights to the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց նախագծի իրավունքները</translation>
    </message>
    <message>
      <source>for instance CC-BY-4.0; empty: none is named</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>օրինակ՝ CC-BY-4.0. դատարկ՝ ոչ մեկը չի նշվում</translation>
    </message>
    <message>
      <source>&amp;Licence of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանվածի &amp;լիցենզիան</translation>
    </message>
    <message>
      <source>Who &amp;holds the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ով ունի &amp;իրավունքները</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահված է։</translation>
    </message>
    <message>
      <source>change the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխել իրավունքները</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SettingsPage</name>
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
        <source>Follow system</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ըստ համակարգի</translation>
    </message>
    <message>
        <source>Recorded with each decision.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Գրանցվում են ամեն որոշման հետ:</translation>
    </message>
    <message>
        <source>Takes effect after restart.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ուժի մեջ է մտնում վերագործարկումից հետո:</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հետ (Esc)</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերագործարկել</translation>
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
      <source>7 is the running number in the sherd&apos;s context; =7 is the number 7 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7-ը հերթական համարն է բեկորի համատեքստում. =7-ը հենց 7 համարն է։</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հաստատել</translation>
    </message>
    <message>
        <source>computed; replaced by the measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>հաշվարկված. փոխարինված է չափված արժեքով</translation>
    </message>
    <message>
      <source>Assign number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տալ %1 համարը</translation>
    </message>
    <message>
      <source>Numbering…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալում…</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>լուսանկար</translation>
    </message>
    <message>
      <source>mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դիմակ</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկան</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մոդել</translation>
    </message>
    <message>
      <source>picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատկեր</translation>
    </message>
    <message>
      <source>drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գծանկար</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զեկույց</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մասշտաբ</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ պահված չէ՝ %1։ Դաշտում Enter-ը պահում է։</translation>
    </message>
    <message>
      <source>-0599/-0549: 600 to 550 BC</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>-0599/-0549՝ մ.թ.ա. 600–550</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdEdits</name>
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
    <message numerus="yes">
      <source>%n sherd(s) got no number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր համար չստացավ. %1</numerusform>
        <numerusform>%n բեկոր համար չստացավ. %1</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>numbering of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>համարակալել %n բեկոր</numerusform>
        <numerusform>համարակալել %n բեկոր</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկված է. ոչինչ չի փոխվել։</translation>
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
      <translation>գրանցված չէ</translation>
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
    <message>
        <source>%1: measured by hand; the computed value is kept beside it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1՝ ձեռքով չափված. հաշվարկված արժեքը պահվում է կողքին։</translation>
    </message>
    <message>
        <source>%1: %2, measured by hand</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1՝ %2, ձեռքով չափված</translation>
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
      <translation>Բեկորներ՝ երկու երեսով, ամբողջական և չափված։</translation>
    </message>
    <message>
      <source>&amp;Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Նախագծեր</translation>
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
      <source>%1
%2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2, %3</translation>
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
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որտե՞ղ է հիմա %1-ը</translation>
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
        <source>Create project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ստեղծել նախագիծ</translation>
    </message>
    <message>
        <source>Example</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Օրինակ</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լավ</translation>
    </message>
    <message>
        <source>Repair the catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերականգնել կատալոգը</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բացել նախագիծը</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2-ը տեղում չէ. գտեք այն …</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Enter</translation>
    </message>
    <message>
        <source>No project yet. Import photographs of both sides of your sherds, or drop their folders here: a project is created for them. To practise, try the virtual rig: it breaks a pot and photographs its sherds for you.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նախագիծ դեռ չկա։ Ներմուծեք ձեր բեկորների երկու կողմերի լուսանկարները կամ դրանց պանակները գցեք այստեղ․ դրանց համար նախագիծ կստեղծվի։ Վարժվելու համար փորձեք վիրտուալ սարքակազմը․ այն ջարդում է անոթ և լուսանկարում բեկորները։</translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ներմուծել լուսանկարներ…</translation>
    </message>
    <message>
        <source>Creates a project named after their folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ստեղծում է նախագիծ՝ դրանց պանակի անունով</translation>
    </message>
    <message>
        <source>Folder of the photographs: both sides, or a folder for each side within it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լուսանկարների պանակը՝ երկու կողմերով կամ յուրաքանչյուր կողմի համար առանձին պանակով</translation>
    </message>
    <message>
        <source>&amp;Restore an archive…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>&amp;Վերականգնել արխիվը…</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերականգնել…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Չեղարկել</translation>
    </message>
    <message>
        <source>Restoring the project to %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նախագիծը վերականգնվում է այստեղ՝ %1</translation>
    </message>
    <message>
        <source>Folder of the archive</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Արխիվի պանակը</translation>
    </message>
    <message>
        <source>Where to put the project: an empty folder, or one for a new folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Որտեղ դնել նախագիծը՝ դատարկ պանակում, կամ պանակում, ուր կստեղծվի նորը</translation>
    </message>
    <message>
      <source>&amp;Open from folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Բացել պանակից…</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացել նախագիծը</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n batch(es) unfinished</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1; %n խմբաքանակ անավարտ</numerusform>
        <numerusform>%1; %n խմբաքանակ անավարտ</numerusform>
      </translation>
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
      <source>%1 of %2 positions done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արված է %2 դիրքից %1-ը</translation>
    </message>
    <message>
      <source>%1 of %2 calibration photographs taken</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 տրամաչափման լուսանկարից արված է %1-ը</translation>
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
        <translation>Առջևի երես</translation>
    </message>
    <message>
        <source>Back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հետևի երես</translation>
    </message>
    <message>
        <source>No scale: lengths are not known</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Մասշտաբ չկա. երկարությունները հայտնի չեն</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>հպում չկա</translation>
    </message>
    <message>
        <source>filled in, not seen by a camera</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>լրացված է, ոչ մի տեսախցիկ չի տեսել</translation>
    </message>
    <message>
        <source>Distance between the sides along the fracture</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Երեսների միջև հեռավորությունը կոտրվածքի երկայնքով</translation>
    </message>
    <message>
        <source>front outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>առջևի երեսը դրսում է %1-ով</translation>
    </message>
    <message>
        <source>back outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>հետևի երեսը դրսում է %1-ով</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, the whole number, or scan its label</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, ամբողջ համարը կամ կարդալ պիտակը</translation>
    </message>
    <message>
      <source>&amp;Number of sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Բեկոր %1-ի համարը</translation>
    </message>
    <message>
      <source>If they have numbers already: each follows its sherd through the flip. Key N.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եթե արդեն համարներ ունեն՝ յուրաքանչյուրը հետևում է իր բեկորին շրջելիս։ N ստեղնը։</translation>
    </message>
    <message>
      <source>Sherd %1 got no number. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բեկորը համար չստացավ. %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskModel</name>
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
    <message>
      <source>%1, camera %2, position %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, տեսախցիկ %2, դիրք %3</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի դիմակները</translation>
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
        <source>Previous photograph</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նախորդ լուսանկարը</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վերամշակել</translation>
    </message>
    <message>
        <source>Brush</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վրձին</translation>
    </message>
    <message>
        <source>Loading photograph…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Լուսանկարը բեռնվում է…</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) edited. Reprocess to update what follows from them.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Փոխված է %n լուսանկար: Վերամշակեք՝ արդյունքները թարմացնելու համար:</numerusform>
            <numerusform>Փոխված է %n լուսանկար: Վերամշակեք՝ արդյունքները թարմացնելու համար:</numerusform>
        </translation>
    </message>
    <message>
        <source>Blue: classified as sherd. Paint missing parts as sherd and wrong ones as plate; the program&apos;s own masks stay.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կապույտ՝ դասված է որպես բեկոր։ Պակասը ներկեք որպես բեկոր, սխալը՝ որպես սկավառակ. ծրագրի դիմակները մնում են։</translation>
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
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մինչև</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, և {n}՝ մեկ անգամ. {n:04}-ն ունի առնվազն չորս նիշ</translation>
    </message>
    <message>
      <source>Example</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորը կլինի</translation>
    </message>
    <message>
      <source>Use this &amp;numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այսուհետև &amp;այսպես համարակալել</translation>
    </message>
    <message>
      <source>Skipped numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց թողնված համարներ</translation>
    </message>
    <message>
      <source>none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>չկան</translation>
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
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանված է։</translation>
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
      <source>&amp;Save vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահպանել բառ&amp;երը</translation>
    </message>
    <message>
      <source>&amp;One per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տ&amp;ողում մեկը</translation>
    </message>
    <message>
      <source>Project vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց նախագծի բառերը</translation>
    </message>
    <message>
      <source>Terms, one per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բառեր, տողում մեկը</translation>
    </message>
    <message>
      <source>change the vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փոխել բառերը</translation>
    </message>
    <message>
      <source>These terms are not saved yet.</source>
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
    <message>
      <source>Sherd %1: %2 is not as this bag's sherds are numbered (%3). If that is no slip, go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկոր %1. %2-ը այնպես չէ, ինչպես համարակալվում են այս տոպրակի բեկորները (%3)։ Եթե սխալ չէ, շարունակեք։</translation>
    </message>
</context>
<context>
    <name>ostraka::Error</name>
    <message>
      <source>The disk has only %1 MB left, and a batch needs more. Nothing is lost: free some space, then resume.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոշտ սկավառակի վրա մնացել է միայն %1 ՄԲ. խմբաքանակին ավելին է պետք։ Ոչինչ չի կորել. տեղ ազատեք և շարունակեք։</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but there is no sherd with a context in that place; assign it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. այս համարը մուտքագրվել էր սկավառակի վրա, բայց այնտեղ համատեքստով բեկոր չկա. տվեք այն կատալոգում։</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but it belongs to another sherd; check which of the two bears it, and give the other one a new number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. այս համարը գրվել է սալի վրա, բայց այլ բեկորինն է. նայեք՝ երկուսից որն է կրում այն, և մյուսին նոր համար տվեք։</translation>
    </message>
    <message>
      <source>Pairs were decided or masks edited while the batch was being processed; reprocess it to apply them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակի մշակման ընթացքում զույգեր են որոշվել կամ դիմակներ խմբագրվել. դրանց համար վերամշակեք։</translation>
    </message>
    <message>
      <source>Sherds counted on the plate: %1, but another number was found; check the map for a sherd that is missing or was split in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի վրա հաշվված բեկորներ՝ %1։ Գտնվել է այլ թիվ. քարտեզի վրա փնտրեք բացակայողը կամ երկու մասի բաժանվածը։</translation>
    </message>
    <message>
      <source>Cancelled.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկված է։</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը միացված չէ մալուխով կամ անջատված է։</translation>
    </message>
    <message>
      <source>The camera does not answer and may be asleep. Turn off its automatic power-off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը չի պատասխանում. քնա՞ծ է։ Անջատեք դրա ինքնաանջատումը։</translation>
    </message>
    <message>
      <source>The camera remains busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը շարունակում է զբաղված մնալ. անջատեք և միացրեք։</translation>
    </message>
    <message>
      <source>The connection to the camera failed; check its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կապը տեսախցիկի հետ ընդհատված է. ստուգեք դրա մալուխը։</translation>
    </message>
    <message>
      <source>Another program uses the camera, often the desktop&apos;s file manager; &apos;ostraka devices&apos; names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը զբաղեցրել է այլ ծրագիր, հաճախ՝ ֆայլերի կառավարիչը. 'ostraka devices'-ը նշում է այն։</translation>
    </message>
    <message>
      <source>The camera cannot be opened; check this user&apos;s permissions with &apos;ostraka devices&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը չի բացվում. այս օգտատերը կարո՞ղ է օգտվել դրանից։ Տե՛ս 'ostraka devices'։</translation>
    </message>
    <message>
      <source>The camera sent no photograph; check that it is focused and set to manual.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկից լուսանկար չեկավ. ֆոկուսն ու ձեռքի ռեժիմը կարգավորվա՞ծ են։</translation>
    </message>
    <message>
      <source>The camera does not stop sending photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը չի դադարում լուսանկարներ տալ։</translation>
    </message>
    <message>
      <source>This camera has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեսախցիկը կենդանի պատկեր չի ցուցադրում։</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; check that nothing blocks it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի հասնում իր անկյանը. արգելափակվա՞ծ է։</translation>
    </message>
    <message>
      <source>The turntable was paused with its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը դադարեցվել է իր սեփական կոճակով։</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի դիրքը հայտնի չէ. զրոյացրեք կամ հավասարեցրեք այն։</translation>
    </message>
    <message>
      <source>The turntable does not answer on the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը ցանցում չի պատասխանում։</translation>
    </message>
    <message>
      <source>The controller restarted; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարգավորիչը վերագործարկվել է. սեղանի դիրքը հայտնի չէ։</translation>
    </message>
    <message>
      <source>A reply from the turntable was lost, and it cannot report its position: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի պատասխանը կորավ, և այն չի կարող ասել՝ որտեղ է. զրոյացրեք կամ հավասարեցրեք այն։</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը չի պատասխանում որպես GRBL կարգավորիչ. միացվա՞ծ է և այս տեսակի՞ն է։</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը չի պատասխանում որպես ComXim. միացվա՞ծ է և այս տեսակի՞ն է։</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB-ն այս համակարգչում չի աշխատում։</translation>
    </message>
    <message>
      <source>The disk is full; free some space and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը լի է. տեղ ազատեք և նորից սկսեք նույնը։</translation>
    </message>
    <message>
      <source>The disk is full; free some space, then try again. No data was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը լի է. տեղ ազատեք և նորից փորձեք։ Ոչինչ չի կորել։</translation>
    </message>
    <message>
      <source>Another program is using the catalogue; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ ծրագիր զբաղեցրել է կատալոգը. փակեք այն և նորից փորձեք։</translation>
    </message>
    <message>
      <source>Another program is repairing or using the catalogue; this one waits up to 10 seconds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ ծրագիր վերանորոգում կամ օգտագործում է կատալոգը. սա սպասում է մինչև 10 վայրկյան։</translation>
    </message>
    <message>
      <source>The image file is truncated; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերը կտրված է մինչև վերջանալը. նորից պատճենեք տեսախցիկից։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a kind of context; use layer, cut, fill, structure, surface or unstratified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1»-ը համատեքստի տեսակ չէ. այն կարող է լինել layer, cut, fill, structure, surface կամ unstratified։</translation>
    </message>
    <message>
      <source>New sites and trenches: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձաններ և խրամատներ, որոնք չկային. %1. ստուգեք, որ դրանցից ոչ մեկը վրիպակ չլինի։</translation>
    </message>
    <message>
      <source>The results of this batch no longer exist; reprocess it, then decide.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի արդյունքներն այլևս չկան. վերամշակեք այն, ապա որոշեք։</translation>
    </message>
    <message>
      <source>Camera %1: its photographs come from different cameras (%2); give each camera its own name, because photographs with the same camera name share one lens calibration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. նրա լուսանկարները տարբեր տեսախցիկներից են (%2). յուրաքանչյուր տեսախցիկի տվեք իր անունը, քանի որ տեսախցիկի նույն անունն ունեցող լուսանկարներն ունեն օբյեկտիվի մեկ ընդհանուր տրամաչափում։</translation>
    </message>
    <message>
      <source>Camera %1: its focal length varies between photographs (%2); all share one lens calibration, so fix the zoom and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. կիզակետային հեռավորությունը բոլոր լուսանկարներում նույնը չէ (%2). բոլորն ունեն օբյեկտիվի մեկ ընդհանուր տրամաչափում, ուստի ամրացրեք խոշորացումը և վերալուսանկարեք։</translation>
    </message>
    <message>
      <source>Camera %1: its aperture varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. դիաֆրագման բոլոր լուսանկարներում նույնը չէ (%2). տեսախցիկը դրեք ձեռքի ռեժիմի. անհավասար լուսանկարները դիմակներն ու գույները դարձնում են պակաս հուսալի։</translation>
    </message>
    <message>
      <source>Camera %1: its exposure time varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. լուսակայման ժամանակը բոլոր լուսանկարներում նույնը չէ (%2). տեսախցիկը դրեք ձեռքի ռեժիմի. անհավասար լուսանկարները դիմակներն ու գույները դարձնում են պակաս հուսալի։</translation>
    </message>
    <message>
      <source>Camera %1: its sensitivity varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. զգայունությունը բոլոր լուսանկարներում նույնը չէ (%2). տեսախցիկը դրեք ձեռքի ռեժիմի. անհավասար լուսանկարները դիմակներն ու գույները դարձնում են պակաս հուսալի։</translation>
    </message>
    <message>
      <source>Camera %1: its white balance varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. սպիտակի հաշվեկշիռը բոլոր լուսանկարներում նույնը չէ (%2). տեսախցիկը դրեք ձեռքի ռեժիմի. անհավասար լուսանկարները դիմակներն ու գույները դարձնում են պակաս հուսալի։</translation>
    </message>
    <message>
      <source>No camera model fits the calibration pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի տեսախցիկ չի բացատրում տրամաչափման նկարները։</translation>
    </message>
    <message>
      <source>No photograph of this camera shows the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեսախցիկի ոչ մի լուսանկարում սկավառակի նշիչները չեն երևում։</translation>
    </message>
    <message>
      <source>No batch folder was given.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակի պանակ չի տրվել։</translation>
    </message>
    <message>
      <source>The angle is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անկյունը թիվ չէ։</translation>
    </message>
    <message>
      <source>This program is not installed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ծրագիրը տեղադրված չէ։</translation>
    </message>
    <message>
      <source>The photographs show no common object; check the cameras, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չգտնվեց մարմին, որի շուրջ լուսանկարները համընկնում են. ստուգեք տեսախցիկները կամ տվեք դիմակներ։</translation>
    </message>
    <message>
      <source>A visual hull needs at least 3 photographs; photograph the object from more directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թաղանթին պետք է առնվազն 3 լուսանկար. լուսանկարեք առարկան ավելի շատ կողմերից։</translation>
    </message>
    <message>
      <source>The cameras do not view a common area; check their poses.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկները չեն նայում ընդհանուր տեղի. ստուգեք նրանց դիրքերը։</translation>
    </message>
    <message>
      <source>The network needs an 8-bit colour photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցանցին պետք է 8 բիթանոց գունավոր լուսանկար։</translation>
    </message>
    <message>
      <source>The drawing needs a scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծագրի մասշտաբը տրված չէ։</translation>
    </message>
    <message>
      <source>The preview was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախադիտումը հետ է վերցվում։</translation>
    </message>
    <message>
      <source>Restoring a project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագիծը վերականգնվում է նոր կամ դատարկ պանակում. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>Not an archive of a whole project; import it as an export instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա ամբողջ նախագծի արխիվ չէ. ներմուծեք այն որպես արտահանում։</translation>
    </message>
    <message>
      <source>This is a project already, not an archive of one; open it as it is.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա արդեն նախագիծ է, ոչ թե արխիվ. բացեք այն այնպես, ինչպես կա։</translation>
    </message>
    <message>
      <source>This is an archive of a whole project, not an export; restore it (ostraka catalogue restore), then merge the restored project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա ամբողջ նախագծի արխիվ է, ոչ թե արտահանում. վերականգնեք այն (ostraka catalogue restore), ապա միավորեք վերականգնված նախագիծը։</translation>
    </message>
    <message>
      <source>The file or folder cannot be written (%1); choose another location, or check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այստեղ հնարավոր չէ գրել (%1). ընտրեք այլ տեղ կամ ստուգեք թույլտվությունները։</translation>
    </message>
    <message>
      <source>There is no such file; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այդպիսի ֆայլ չկա. ստուգեք անունը։</translation>
    </message>
    <message>
      <source>The file cannot be opened (%1); check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը չի բացվում (%1). ստուգեք դրա թույլտվությունները։</translation>
    </message>
    <message>
      <source>The file is larger than the limit of %1 bytes; check that it is the right one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը մեծ է այստեղ կարդացվող %1 բայտից. ճի՞շտ ֆայլն է։</translation>
    </message>
    <message>
      <source>The file cannot be read (%1); copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը չի կարդացվում (%1). նորից պատճենեք։</translation>
    </message>
    <message>
      <source>The JSON text is larger than 64 MiB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON տեքստը մեծ է 64 ՄիԲ-ից։</translation>
    </message>
    <message>
      <source>The JSON is nested more than 64 levels deep.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON-ն ունի 64-ից ավելի ներդրված մակարդակ։</translation>
    </message>
    <message>
      <source>Not valid JSON (line %1); correct that line, or copy the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա ճիշտ JSON չէ (տող %1). ուղղեք այնտեղ կամ նորից պատճենեք ֆայլը։</translation>
    </message>
    <message>
      <source>The JSON contains a number that is too large; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON-ում կա չափազանց մեծ թիվ. ուղղեք այն։</translation>
    </message>
    <message>
      <source>A transform must be a 4x4 matrix.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձևափոխությունը պետք է լինի 4x4 մատրից։</translation>
    </message>
    <message>
      <source>A transform contains a value that is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձևափոխությունը պարունակում է մի բան, որը թիվ չէ։</translation>
    </message>
    <message>
      <source>A transform is not rigid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձևափոխությունը կոշտ չէ։</translation>
    </message>
    <message>
      <source>A transform moves by more than %1 mm; check that its last column is in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձևափոխությունը տեղաշարժում է ավելի քան %1 մմ. ստուգեք, որ նրա վերջին սյունը մմ-ով է։</translation>
    </message>
    <message>
      <source>There is no such folder; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այդպիսի պանակ չկա. նշեք խմբաքանակի պանակը։</translation>
    </message>
    <message>
      <source>The front side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսը բացակայում է. դրա լուսանկարները դրեք '%1' պանակում։</translation>
    </message>
    <message>
      <source>The back side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսը բացակայում է. դրա լուսանկարները դրեք '%1' պանակում։</translation>
    </message>
    <message>
      <source>Not a batch folder: it has neither the folders &apos;front&apos; and &apos;back&apos; nor &apos;top_images&apos; and &apos;bottom_images&apos;; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա խմբաքանակ չէ. չունի ո՛չ 'front' և 'back', ո՛չ էլ 'top_images' և 'bottom_images' պանակները. նշեք խմբաքանակի պանակը։</translation>
    </message>
    <message>
      <source>The file name does not match the form %1; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անունը %1 ձևի չէ. այս լուսանկարը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>Another photograph has the same camera and position; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ լուսանկար ունի նույն տեսախցիկն ու դիրքը. այս մեկը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>This photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>Photographs are missing: %1 and %2 more. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այստեղ լուսանկարներ են պակասում՝ %1 և ևս %2. միայն դրանցով երևացողը կլրացվի, ուստի նորից նկարեք, եթե կարևոր են։</translation>
    </message>
    <message>
      <source>Photographs are missing: %1. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այստեղ լուսանկարներ են պակասում՝ %1. միայն դրանցով երևացողը կլրացվի, ուստի նորից նկարեք, եթե կարևոր են։</translation>
    </message>
    <message>
      <source>This file name follows the naming of rig photographs, but most others do not; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անունը սարքակազմի լուսանկարի է, իսկ մյուսների մեծ մասը՝ ոչ. այս լուսանկարը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>Another photograph has the same name; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ լուսանկար ունի նույն անունը. այս մեկը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2 and %3 more); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 մեգապիքսելից փոքր լուսանկարները բաց են թողնվում (%2 և ևս %3). մանրապատկերների փոխարեն պատճենեք բնօրինակները տեսախցիկից։</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 մեգապիքսելից փոքր լուսանկարները բաց են թողնվում (%2). մանրապատկերների փոխարեն պատճենեք բնօրինակները տեսախցիկից։</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs are used: the most detailed ones, spread over the series. More would take longer and add little.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Օգտագործվում է %1 լուսանկար %2-ից՝ ամենամանրամասները, շարքով մեկ բաշխված։ Ավելին երկար կտևի և քիչ բան կավելացնի։</translation>
    </message>
    <message>
      <source>This folder contains no photographs; put the photographs of one side into it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում լուսանկարներ չկան. այնտեղ դրեք մեկ երեսի լուսանկարները։</translation>
    </message>
    <message>
      <source>This folder contains neither photographs nor the folders &apos;front&apos; and &apos;back&apos; of a batch; choose a folder with photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում չկան ո՛չ լուսանկարներ, ո՛չ խմբաքանակի «front» և «back» պանակներ. նշեք լուսանկարներով պանակ։</translation>
    </message>
    <message>
      <source>There is no such folder; choose one with the photographs of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այդպիսի պանակ չկա. նշեք մեկ երեսի լուսանկարներով պանակ։</translation>
    </message>
    <message>
      <source>The same folder is given for the front and the back; choose the folder of each side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակը նշվել է և՛ առջևի, և՛ հետևի երեսի համար. նշեք յուրաքանչյուր երեսի պանակը։</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի պիտանի լուսանկարներ՝ %1. անհրաժեշտ է առնվազն %2։ Լուսանկարեք ևս՝ բոլոր կողմերից։</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի պիտանի լուսանկարներ՝ %1. անհրաժեշտ է առնվազն %2։ Լուսանկարեք ևս՝ բոլոր կողմերից։</translation>
    </message>
    <message>
      <source>The HEIC image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>HEIC պատկերը վնասված է. նորից պատճենեք։</translation>
    </message>
    <message>
      <source>The RAW image is damaged, or its camera is not supported; copy it again, or export it as TIFF.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>RAW պատկերը վնասված է կամ անհայտ տեսախցիկից է. նորից պատճենեք կամ արտահանեք որպես TIFF։</translation>
    </message>
    <message>
      <source>The side of a marker must be between 0.5 and 1000 mm; measure a black square on the paper.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչի կողմը պետք է լինի 0,5-ից 1000 մմ. չափեք թղթի վրայի սև քառակուսին։</translation>
    </message>
    <message>
      <source>No sheet with at least %1 markers of OpenCV&apos;s dictionaries was found in these %2 photographs; take photographs that show more of the sheet, or specify its plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս %2 լուսանկարներում չի կարդացվում OpenCV-ի բառարանների առնվազն %1 նշիչով թերթ. արեք լուսանկարներ, որոնք այն ավելի են ցույց տալիս, կամ նշեք դրա plate.json-ը։</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in the photographs (%4 px) and are used instead. Measure the distance between two markers that are far apart and compare it with plate.json in the output folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի plate.json չի նկարագրում թերթը. լուսանկարներում գտնվել է %2-ի %1 նշիչ՝ %3 մմ կողմերով (%4 px), և ընդունվել որպես թերթ։ Չափեք իրարից հեռու երկու նշիչների հեռավորությունը և համեմատեք արդյունքների պանակի plate.json-ի հետ։</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 were found in the photographs (%3 px), but their size is unknown, so the result has no scale. Measure the side of a marker&apos;s black square and give it with --marker-mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի plate.json չի նկարագրում թերթը. լուսանկարներում գտնվել է %2 բառարանի %1 նշիչ (%3 px), բայց դրանց չափը հայտնի չէ, ուստի արդյունքը մասշտաբ չունի։ Չափեք նշիչի սև քառակուսու կողմը և նշեք այն --marker-mm-ով։</translation>
    </message>
    <message>
      <source>This mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս դիմակը չի օգտագործվում։</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size; the mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիմակի չափը լուսանկարի չափը չէ. այն չի օգտագործվում։</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի պիտանի լուսանկարներ՝ %1. անհրաժեշտ է առնվազն %2։ Ավելացրեք %3 անունով լուսանկարներ։</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի պիտանի լուսանկարներ՝ %1. անհրաժեշտ է առնվազն %2։ Ավելացրեք %3 անունով լուսանկարներ։</translation>
    </message>
    <message>
      <source>The file name is neither cam&lt;C&gt;_cal&lt;NN&gt;.jpg nor empty_cam&lt;C&gt;.jpg; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անունը ո՛չ cam&lt;C&gt;_cal&lt;NN&gt;.jpg է, ո՛չ էլ empty_cam&lt;C&gt;.jpg. այս պատկերը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>This picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պատկերը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>The image has %1 x %2 pixels, but the photographs from its camera have %3 x %4; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերն ունի %1 x %2 պիքսել, տեսախցիկի լուսանկարները՝ %3 x %4. այս պատկերը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>The image header states a size of %1 x %2 pixels, which cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերը նշում է %1 x %2 պիքսել չափ, որը պիտանի չէ։</translation>
    </message>
    <message>
      <source>The network&apos;s file is damaged; copy it again, or export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցանցի ֆայլը վնասված է. նորից պատճենե՛ք կամ արտահանե՛ք այն։</translation>
    </message>
    <message>
      <source>A layer of the network has &apos;%1&apos; %2, but only %3 to %4 can be used; use another network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցանցի մի շերտում «%1»-ը %2 է, բայց կարելի է օգտագործել միայն %3-ից %4 արժեքները. օգտագործե՛ք այլ ցանց։</translation>
    </message>
    <message>
      <source>The network&apos;s weights are in another file; export it as one file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցանցի կշիռները այլ ֆայլում են. արտահանե՛ք այն որպես մեկ ֆայլ։</translation>
    </message>
    <message>
      <source>The network takes %1 GB of memory for one photograph, but at most %2 GB can be used; use a smaller network, or one with a smaller input.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցանցը մեկ լուսանկարի համար %1 ԳԲ հիշողություն է պահանջում, բայց կարելի է օգտագործել առավելագույնը %2 ԳԲ. օգտագործե՛ք ավելի փոքր ցանց կամ ավելի փոքր մուտքով ցանց։</translation>
    </message>
    <message>
      <source>The JPEG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JPEG պատկերը վնասված է. նորից պատճենեք։</translation>
    </message>
    <message>
      <source>The JPEG file contains no image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JPEG-ի մեջ պատկեր չկա։</translation>
    </message>
    <message>
      <source>The PNG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PNG պատկերը վնասված է. նորից պատճենեք։</translation>
    </message>
    <message>
      <source>The TIFF file does not state the image&apos;s size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>TIFF պատկերում չափ նշված չէ։</translation>
    </message>
    <message>
      <source>The file is empty; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը դատարկ է. նորից պատճենեք տեսախցիկից։</translation>
    </message>
    <message>
      <source>Not a JPEG, PNG, TIFF, HEIC or RAW image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա JPEG, PNG, TIFF, HEIC կամ RAW պատկեր չէ։</translation>
    </message>
    <message>
      <source>The known lengths cannot be used: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հայտնի երկարությունները պիտանի չեն. %1։</translation>
    </message>
    <message>
      <source>'side' must be 'front' or 'back'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'side'-ը պետք է լինի 'front' կամ 'back'</translation>
    </message>
    <message>
      <source>'ends' must be two lists of marks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'ends'-ը պետք է լինի նշումների երկու ցուցակ</translation>
    </message>
    <message>
      <source>each end must be marked on at least two photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ամեն ծայր պետք է նշված լինի առնվազն երկու լուսանկարի վրա</translation>
    </message>
    <message>
      <source>their unit must be mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դրանց միավորը պետք է լինի mm</translation>
    </message>
    <message>
      <source>each needs 'side', 'length' and 'ends' with 'file' and 'pixel'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>յուրաքանչյուրին պետք են 'side', 'length' և 'ends'՝ 'file'-ով ու 'pixel'-ով</translation>
    </message>
    <message>
      <source>The image cannot be decoded; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատկերը չի ապակոդավորվում. նորից պատճենեք։</translation>
    </message>
    <message>
      <source>The plate&apos;s unit must be mm; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի միավորը պետք է լինի mm. նորից ստեղծեք սկավառակի ֆայլը։</translation>
    </message>
    <message>
      <source>The plate file lists more than 1024 markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը նշում է 1024-ից ավելի նշիչ։</translation>
    </message>
    <message>
      <source>The plate file needs &apos;dictionary&apos; and &apos;markers&apos;, each with an id and four corners of three numbers; &apos;diameter&apos;, if given, is a number in mm, &apos;sheet&apos; the paper&apos;s width and height.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի ֆայլին պետք են 'dictionary' և 'markers'՝ id-ով և երեքական թվով չորս անկյուններով. 'diameter'-ը, եթե տրված է, թիվ է մմ-ով, 'sheet'-ը՝ թղթի լայնությունն ու բարձրությունը։</translation>
    </message>
    <message>
      <source>The plate file lists no markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը ոչ մի նշիչ չի նշում։</translation>
    </message>
    <message>
      <source>Marker %1 of the plate has no valid corners.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի %1 նշիչը վավեր անկյուններ չունի։</translation>
    </message>
    <message>
      <source>Marker %1 occurs twice on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 նշիչը սկավառակի վրա երկու անգամ կա։</translation>
    </message>
    <message>
      <source>The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and 'marker_mm'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տրամաչափման տախտակին պետք են 'dictionary', 'squares_x', 'squares_y', 'square_mm' և 'marker_mm'։</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another batch name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս անունով ֆայլ արդեն կա և չի վերագրվում. նշեք այլ խմբաքանակ։</translation>
    </message>
    <message>
      <source>This batch started on another plate; continue with that plate or start a new batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակը սկսվել է այլ սկավառակով. շարունակեք դրանով կամ սկսեք այլ խմբաքանակ։</translation>
    </message>
    <message>
      <source>This batch started with another setup (cameras: %1, positions: %2; now: %3 and %4); choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակն սկսվել է այլ կազմով (տեսախցիկներ՝ %1, դիրքեր՝ %2. այժմ՝ %3 և %4). ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>The photograph has changed since it was taken; restore the original or choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարը փոխվել է նկարելուց հետո. վերադարձրեք սկզբնականը կամ խմբաքանակի համար նշեք այլ պանակ։</translation>
    </message>
    <message>
      <source>This photograph does not belong to this batch; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարն այստեղ չի արվել. խմբաքանակի համար նշեք այլ պանակ։</translation>
    </message>
    <message>
      <source>Camera %1 delivers raw files only; set its image format to JPEG, or to both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկը տալիս է միայն raw ֆայլեր. պատկերի ձևաչափը դրեք JPEG կամ երկուսն էլ։</translation>
    </message>
    <message>
      <source>%1 is %2, but the rig specifies %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը %2 է, սարքակազմն ասում է՝ %3</translation>
    </message>
    <message>
      <source>%1 is %2, but the first photograph used %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը %2 է, առաջին լուսանկարում %3 էր</translation>
    </message>
    <message>
      <source>The turntable did not reach its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չհասավ իր զրոյին։</translation>
    </message>
    <message>
      <source>The turntable does not report its position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի հայտնում իր դիրքը։</translation>
    </message>
    <message>
      <source>The turntable rejected a command (error %1): wrong turntable type or bad cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը մերժեց հրամանը (սխալ %1). սեղանի տեսակը սխալ է կամ մալուխը վատն է։</translation>
    </message>
    <message>
      <source>The turntable&apos;s speed must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի արագությունը պետք է մեծ լինի 0-ից։</translation>
    </message>
    <message>
      <source>The connection to the turntable failed (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կապը պտտվող սեղանի հետ ընդհատված է (%1)։</translation>
    </message>
    <message>
      <source>it is not open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բացված չէ</translation>
    </message>
    <message>
      <source>it accepts no more data</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>այլևս բայտեր չի ընդունում</translation>
    </message>
    <message>
      <source>it was closed at the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>փակվել է մյուս ծայրում</translation>
    </message>
    <message>
      <source>You have no permission to use this serial port; install Ostraka&apos;s udev rules or join the group dialout, then log in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք չեք կարող օգտվել այս հաջորդական միացքից. տեղադրեք Ostraka-ի udev կանոնները կամ մտեք dialout խումբը և նորից մուտք գործեք։</translation>
    </message>
    <message>
      <source>The serial port does not exist; check that the turntable is plugged in and switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդական միացքը չկա. պտտվող սեղանը միացվա՞ծ է մալուխով և սնմանը։</translation>
    </message>
    <message>
      <source>Not a serial port.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա հաջորդական միացք չէ։</translation>
    </message>
    <message>
      <source>The serial port does not accept its settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդական միացքը չի ընդունում իր կարգավորումները։</translation>
    </message>
    <message>
      <source>The turntable&apos;s address is unknown on this network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի հասցեն այս ցանցում հայտնի չէ։</translation>
    </message>
    <message>
      <source>A serial port does not support %1 baud; common rates are 9600 and 115200.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաջորդական միացքը չի կարող աշխատել %1 բոդով. սովորական են 9600-ը և 115200-ը։</translation>
    </message>
    <message>
      <source>A network address looks like 192.168.0.7:23.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցանցային հասցեն ունի այս տեսքը՝ 192.168.0.7:23։</translation>
    </message>
    <message>
      <source>The desktop does not release the camera: it is still in use by %1; close its file window and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աշխատասեղանը բաց չի թողնում տեսախցիկը. այն դեռ զբաղեցնում է %1-ը. փակեք ֆայլերի պատուհանը և նորից փորձեք։</translation>
    </message>
    <message>
      <source>A watched folder has no setting %1; set it on the camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիտարկվող պանակը %1 կարգավորում չունի. դրեք այն տեսախցիկի վրա։</translation>
    </message>
    <message>
      <source>A watched folder has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիտարկվող պանակը կենդանի պատկեր չի ցուցադրում։</translation>
    </message>
    <message>
      <source>No new photograph arrived within %1 seconds; check that the camera&apos;s software writes into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 վայրկյանում նոր լուսանկար չեկավ. տեսախցիկի ծրագիրն այս պանակո՞ւմ է գրում։</translation>
    </message>
    <message>
      <source>The watched folder cannot be read (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիտարկվող պանակը չի կարդացվում (%1)։</translation>
    </message>
    <message>
      <source>Two photographs arrived for one shot, %1 and %2; use one folder per camera and one photograph per position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ նկարման համար եկավ երկու լուսանկար՝ %1 և %2. ամեն պանակին՝ մեկ տեսախցիկ, ամեն դիրքին՝ մեկ լուսանկար։</translation>
    </message>
    <message>
      <source>The camera with this serial number is not plugged in; found: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սերիական համարով տեսախցիկը միացված չէ. կա՝ %1։</translation>
    </message>
    <message>
      <source>The camera does not offer %1 for %2; it is set to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը %2-ի համար %1 չի առաջարկում. դրված է %3։</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3; check its mode dial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը %1-ը պահում է %2, ոչ թե %3. նայեք ռեժիմների անիվին։</translation>
    </message>
    <message>
      <source>The camera has no setting %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը %1 կարգավորում չունի։</translation>
    </message>
    <message>
      <source>The camera reports: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը հայտնում է՝ %1։</translation>
    </message>
    <message>
      <source>The turntable has no zero switch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը զրոյի անջատիչ չունի։</translation>
    </message>
    <message>
      <source>It did not answer while homing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զրոյացնելիս չպատասխանեց։</translation>
    </message>
    <message>
      <source>It did not unlock.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չապակողպվեց։</translation>
    </message>
    <message>
      <source>It did not answer the shutter command.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նկարելու պահին չպատասխանեց։</translation>
    </message>
    <message>
      <source>The turntable does not answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի պատասխանում։</translation>
    </message>
    <message>
      <source>The turntable does not stop moving.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը կանգ չի առնում։</translation>
    </message>
    <message>
      <source>The turntable does not accept its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի ընդունում իր զրոն։</translation>
    </message>
    <message>
      <source>The controller reset its count; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարգավորիչը սկսել է նորից հաշվել. սեղանի դիրքը հայտնի չէ։</translation>
    </message>
    <message>
      <source>The turntable does not move.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի շարժվում։</translation>
    </message>
    <message>
      <source>The turntable did not arrive in time; it was stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը ժամանակին տեղ չհասավ. այն կանգնեցվեց։</translation>
    </message>
    <message>
      <source>The shutter output must be M8, M7, M3 or M62 Pn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նկարման ելքը պետք է լինի M8, M7, M3 կամ M62 Pn։</translation>
    </message>
    <message>
      <source>The turntable was stopped while moving and lost its position: align the zero mark (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը կանգնեցվել է շարժման մեջ, և դիրքը կորել է. հավասարեցրեք զրոյի նշանը (ALARM:%1)։</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller reports a turn beyond its travel: switch $20 off (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի կարգավորիչն ասում է, որ պտույտն անցնում է ընթացքի սահմանը. անջատեք $20-ը (ALARM:%1)։</translation>
    </message>
    <message>
      <source>Homing failed: check the zero switch and its cable (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զրոյացումը չհաջողվեց. ստուգեք զրոյի անջատիչը և դրա մալուխը (ALARM:%1)։</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller raised an alarm (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի կարգավորիչը տագնապ տվեց (ALARM:%1)։</translation>
    </message>
    <message>
      <source>The controller does not understand the command: wrong controller type or bad cable (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարգավորիչը չի հասկանում հրամանը. կարգավորիչի տեսակը սխալ է կամ մալուխը վատն է (error:%1)։</translation>
    </message>
    <message>
      <source>The turntable has no zero switch (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը զրոյի անջատիչ չունի (error:%1)։</translation>
    </message>
    <message>
      <source>The turntable is still moving (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը դեռ շարժվում է (error:%1)։</translation>
    </message>
    <message>
      <source>The turntable is locked: home it or unlock it (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանը կողպված է. զրոյացրեք կամ ապակողպեք այն (error:%1)։</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller rejected a command (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի կարգավորիչը մերժեց հրամանը (error:%1)։</translation>
    </message>
    <message>
      <source>Turn the turntable counter-clockwise to %1 degrees, then take your hand away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտեք սեղանը ժամսլաքին հակառակ մինչև %1 աստիճան և հեռացրեք ձեռքը։</translation>
    </message>
    <message>
      <source>Not an Ostraka photograph list; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա Ostraka-ի լուսանկարների ցուցակ չէ. խմբաքանակի համար նշեք այլ պանակ։</translation>
    </message>
    <message>
      <source>The turntable driver %1 is unknown; available: grbl, comxim1, comxim2, text, hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի %1 վարորդը հայտնի չէ. կան՝ grbl, comxim1, comxim2, text, hand։</translation>
    </message>
    <message>
      <source>The camera driver %1 is unknown; available: folder, gphoto2, uvc.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկի %1 վարորդը հայտնի չէ. կան՝ folder, gphoto2, uvc։</translation>
    </message>
    <message>
      <source>The rig names no devices; &apos;ostraka devices&apos; lists what is plugged in and how to enter it in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը սարքեր չի նշում. 'ostraka devices'-ն ասում է, թե ինչ է միացված և ինչպես այն գրել։</translation>
    </message>
    <message>
      <source>The rig names no camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը ոչ մի տեսախցիկ չի նշում։</translation>
    </message>
    <message>
      <source>settle_s and speed_deg_s must be positive.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>settle_s-ը և speed_deg_s-ը պետք է դրական լինեն։</translation>
    </message>
    <message>
      <source>The section &apos;devices&apos; cannot be read; compare it with docs/devices.md.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'devices' մասը չի կարդացվում. համեմատեք docs/devices.md-ի հետ։</translation>
    </message>
    <message>
      <source>The number of positions must be between 3 and 99.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիրքերի թիվը պետք է լինի 3-ից 99։</translation>
    </message>
    <message>
      <source>The rig has no camera or no turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը չունի տեսախցիկ կամ պտտվող սեղան։</translation>
    </message>
    <message>
      <source>There is no shot %1 to retake: this side has positions 1 to %2 and cameras A to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կրկնելու %1 նկար չկա. այս երեսն ունի 1-ից %2 դիրքեր և A-ից %3 տեսախցիկներ։</translation>
    </message>
    <message>
      <source>Camera %1 of this batch was %2, but the connected one is %3; continue with the original cameras or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի %1 տեսախցիկը %2-ն էր, այստեղինը %3-ն է. շարունակեք սկսած տեսախցիկներով կամ նշեք այլ պանակ։</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: turn its zero mark to the front and set zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սեղանի դիրքը հայտնի չէ. զրոյի նշանը պտտեք դեպի առաջ և սահմանեք զրոն։</translation>
    </message>
    <message>
      <source>Camera %1, position %2 failed %3 times: %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1, դիրք %2. %3 անգամ չհաջողվեց՝ %4։</translation>
    </message>
    <message>
      <source>Camera %1 delivers only earlier or broken photographs; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկը տալիս է միայն նախորդ կամ վնասված լուսանկարներ. անջատեք և միացրեք։</translation>
    </message>
    <message>
      <source>The turntable does not answer as a %1; check its type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի պատասխանում որպես %1. գուցե ա՞յլ սեղան է։</translation>
    </message>
    <message>
      <source>Marlin controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Marlin կարգավորիչ</translation>
    </message>
    <message>
      <source>text controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեքստային կարգավորիչ</translation>
    </message>
    <message>
      <source>This turntable has no zero switch: align it by eye.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սեղանը զրոյի անջատիչ չունի. հավասարեցրեք աչքաչափով։</translation>
    </message>
    <message>
      <source>The turntable rejects the command: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը մերժում է՝ %1։</translation>
    </message>
    <message>
      <source>The turntable is at %1 degrees instead of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը կանգնած է %1 աստիճանի վրա, ոչ թե %2։</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;move&apos; must contain {target} or {by}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի բարբառը. 'move'-ը պետք է պարունակի {target} կամ {by}։</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;accepted&apos; must describe its answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի բարբառը. 'accepted'-ը պետք է ասի, թե ինչպես է պատասխանում։</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;query&apos; and &apos;position&apos; must be given together.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի բարբառը. 'query'-ն և 'position'-ը միասին են։</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;reply_s&apos; must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի բարբառը. 'reply_s'-ը պետք է մեծ լինի 0-ից։</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;%1&apos; is not a regular expression.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի բարբառը. '%1'-ը կանոնավոր արտահայտություն չէ։</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;position&apos; needs a group for the angle.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի բարբառը. 'position'-ին պետք է խումբ՝ անկյան համար։</translation>
    </message>
    <message>
      <source>The turntable&apos;s &apos;dialect&apos; must be &quot;marlin&quot; or an object with its commands.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի 'dialect'-ը պետք է լինի "marlin" կամ դրա բառերը։</translation>
    </message>
    <message>
      <source>The turntable is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը միացված չէ մալուխով։</translation>
    </message>
    <message>
      <source>The turntable&apos;s USB connection failed (%1); plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի USB կապը խափանվեց (%1). նորից միացրեք։</translation>
    </message>
    <message>
      <source>You have no permission to use this USB device; install packaging/udev/70-ostraka.rules and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք չեք կարող օգտվել այս USB սարքից. տեղադրեք packaging/udev/70-ostraka.rules-ը և նորից միացրեք։</translation>
    </message>
    <message>
      <source>Another program uses the turntable; close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանն օգտագործում է այլ ծրագիր. փակեք այն։</translation>
    </message>
    <message>
      <source>The turntable cannot be opened (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանը չի բացվում (%1)։</translation>
    </message>
    <message>
      <source>This USB device is not a serial controller (CDC-ACM).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս USB սարքը հաջորդական կարգավորիչ չէ (CDC-ACM)։</translation>
    </message>
    <message>
      <source>The turntable with this serial number is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սերիական համարով պտտվող սեղանը միացված չէ մալուխով։</translation>
    </message>
    <message>
      <source>A USB turntable is named by vendor and product, for example usb:1209:0001.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>USB պտտվող սեղանը նշվում է արտադրողով և արտադրանքով, ինչպես usb:1209:0001։</translation>
    </message>
    <message>
      <source>The video camera cannot be opened; check that it is plugged in and that no other program uses it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիդեոտեսախցիկը չի բացվում. միացվա՞ծ է, և ա՞յլ ծրագիր չի օգտագործում այն։</translation>
    </message>
    <message>
      <source>A video camera has exposure (0.1 ms), focus, white_balance (K) and gain, as numbers; not %1 %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիդեոտեսախցիկն ունի exposure (0,1 մվ), focus, white_balance (K) և gain՝ որպես թվեր, ոչ թե %1 %2։</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը %1-ը պահում է %2, ոչ թե %3։</translation>
    </message>
    <message>
      <source>The video camera no longer delivers pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիդեոտեսախցիկն այլևս պատկերներ չի տալիս։</translation>
    </message>
    <message>
      <source>The video camera took no picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիդեոտեսախցիկը պատկեր չի արել։</translation>
    </message>
    <message>
      <source>The video camera delivers pictures of %1x%2 pixels instead of the configured size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիդեոտեսախցիկը տալիս է %1x%2 պիքսել պատկերներ, ոչ թե սահմանված չափի։</translation>
    </message>
    <message>
      <source>Another program is writing decisions or masks of this batch, so nothing was saved; try again in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ ծրագիր գրում է այս խմբաքանակի որոշումները կամ դիմակները, ուստի ոչինչ չի պահպանվել. քիչ հետո նորից փորձեք։</translation>
    </message>
    <message>
      <source>The part of Ostraka that video cameras need cannot be loaded; install Ostraka again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka-ի այն մասը, որն անհրաժեշտ է տեսախցիկներին, չի բեռնվում. նորից տեղադրեք Ostraka-ն։</translation>
    </message>
    <message>
      <source>The video camera must be named.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիդեոտեսախցիկը պետք է նշված լինի։</translation>
    </message>
    <message>
      <source>the file is truncated or not a picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ֆայլը կտրված է կամ պատկեր չէ</translation>
    </message>
    <message>
      <source>the markers show an angle other than this position&apos;s</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նշիչները ցույց են տալիս այս դիրքի անկյունից տարբեր անկյուն</translation>
    </message>
    <message>
      <source>the picture&apos;s size differs from that of the camera&apos;s other pictures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատկերի չափը տարբերվում է այս տեսախցիկի մյուսներից</translation>
    </message>
    <message>
      <source>too few markers are visible to identify the position: check that nothing covers them and that the picture is sharp</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դիրքը որոշելու համար շատ քիչ նշիչ է երևում. արդյո՞ք դրանց առջև բան կա, կամ պատկերը մշո՞ւշոտ է</translation>
    </message>
    <message>
      <source>the camera delivered an earlier photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեսախցիկը կրկին տվեց նախորդ լուսանկարներից մեկը</translation>
    </message>
    <message>
      <source>too few markers of the plate are visible: check that nothing covers them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սկավառակի շատ քիչ նշիչ է երևում. արդյո՞ք դրանց առջև բան կա</translation>
    </message>
    <message>
      <source>the picture is blurred: check that the turntable is still and the focus is unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մշուշոտ է. սեղանը դեռ շարժվո՞ւմ էր, ֆոկուսը փոխվե՞լ է</translation>
    </message>
    <message>
      <source>the sherds are too dark: add light or increase the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկորները չափազանց մութ են. ավելացրեք լույսը կամ երկարացրեք լուսակայումը</translation>
    </message>
    <message>
      <source>the sherds are overexposed: reduce the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկորները գերլուսավորված են. կարճացրեք լուսակայումը</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատկերի եզրը կտրում է բեկորը. տեղաշարժեք այն կամ տեսախցիկը</translation>
    </message>
    <message>
      <source>the camera&apos;s settings have changed: restore them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տեսախցիկի կարգավորումները փոխվել են. վերականգնեք դրանք</translation>
    </message>
    <message>
      <source>%1: restore it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. վերականգնեք</translation>
    </message>
    <message>
      <source>A plate holds 1 to 60 sherds; 0 means not counted.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակը կրում է 1-ից 60 բեկոր. 0 նշանակում է՝ չհաշված։</translation>
    </message>
    <message>
      <source>The number of a batch is also the name of its folder; use letters and digits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակի համարը նաև դրա պանակի անունն է. օգտագործեք տառեր և թվանշաններ։</translation>
    </message>
    <message>
      <source>The uuid of a batch is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակի uuid-ը սխալ է գրված։</translation>
    </message>
    <message>
      <source>The batch %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 խմբաքանակն արդեն կա։</translation>
    </message>
    <message>
      <source>This batch is not in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը կատալոգում չկա։</translation>
    </message>
    <message>
      <source>The project&apos;s code must be 2 to 8 letters from A to Z or digits, for example ARM.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծի ծածկագիրը պետք է լինի 2-ից 8 լատինական մեծատառ (A-ից Z) կամ թվանշան, ինչպես ARM։</translation>
    </message>
    <message>
      <source>A vocabulary term must contain letters and no &apos;;&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բառարանի տերմինը պետք է ունենա տառեր և չունենա ';'։</translation>
    </message>
    <message>
      <source>The term &apos;%1&apos; appears twice in the vocabulary.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' տերմինը բառարանում երկու անգամ կա։</translation>
    </message>
    <message>
      <source>Sherds with the term '%1': %2; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» եզրով բեկորներ՝ %2. նախ փոխեք դրանք։</translation>
    </message>
    <message>
      <source>a row of %1 refers to a missing row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի տողը ոչնչի չի հղվում</translation>
    </message>
    <message>
      <source>the sherd tables are inconsistent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բեկորների աղյուսակներն իրար չեն համապատասխանում</translation>
    </message>
    <message>
      <source>the search index is incomplete</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>որոնումը բոլոր բեկորները չգիտի</translation>
    </message>
    <message>
      <source>The backup does not contain the saved data; try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պահուստային պատճենը չի պարունակում պահպանվածը. նորից փորձեք։</translation>
    </message>
    <message>
      <source>The catalogue cannot be opened; check that the folder exists and is writable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգը չի բացվում. ստուգեք, որ պանակը կա և դրանում կարելի է գրել։</translation>
    </message>
    <message>
      <source>The catalogue cannot be written to; check the permissions of the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգում հնարավոր չէ գրել. ստուգեք պանակի թույլտվությունները։</translation>
    </message>
    <message>
      <source>The disk reports errors; check it, then reopen the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոշտ սկավառակը պատշաճ չի պատասխանում. ստուգեք այն, ապա նորից բացեք նախագիծը։</translation>
    </message>
    <message>
      <source>The catalogue rejects this operation (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգը սա չի ընդունում (%1)։</translation>
    </message>
    <message>
      <source>The scan is not a front of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանն այս խմբաքանակի առջևի երես չէ։</translation>
    </message>
    <message>
      <source>The scan is not a back of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանն այս խմբաքանակի հետևի երես չէ։</translation>
    </message>
    <message>
      <source>A pair needs a front and a back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգն ունի առջևի և հետևի երես։</translation>
    </message>
    <message>
      <source>The decision to undo is not in this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետ վերցվող որոշումն այս խմբաքանակում չէ։</translation>
    </message>
    <message>
      <source>A decision needs a front, a back or both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշումը նշում է առջևի երես, հետևի երես կամ երկուսն էլ։</translation>
    </message>
    <message>
      <source>The uuid of a decision is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշման uuid-ը սխալ է գրված։</translation>
    </message>
    <message>
      <source>This file is outside the project&apos;s folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը նախագծի պանակում չէ։</translation>
    </message>
    <message>
      <source>This is a draft from reduced photographs; reprocess the batch for final measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա սևագիր է՝ փոքրացված լուսանկարներից. վերջնական չափերի համար խմբաքանակը վերամշակեք։</translation>
    </message>
    <message>
      <source>These results of &apos;ostraka process&apos; are incomplete; run it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սրանք 'ostraka process'-ի ամբողջական արդյունքներ չեն. նորից գործարկեք։</translation>
    </message>
    <message>
      <source>Another program is entering results of this batch; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ այլ ծրագիր մուտքագրում է այս խմբաքանակի արդյունքները. սա սպասում է դրա ավարտին։</translation>
    </message>
    <message>
      <source>The pair table names the scan %1, which is missing; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգերի աղյուսակը նշում է %1 սկանը, որը չկա. նորից գործարկեք 'ostraka process'-ը։</translation>
    </message>
    <message>
      <source>This batch is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This photograph is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This scan is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սկանն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This file is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This person is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս անձն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This site is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս հուշարձանն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This trench is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խրամատն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This context is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս համատեքստն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>This bag is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տոպրակն այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>The filter has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զտիչը բացում է չակերտ և չի փակում։</translation>
    </message>
    <message>
      <source>This is only part of a sherd&apos;s label; scan its code again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա բեկորի պիտակի միայն մի մասն է. նորից կարդացեք դրա կոդը։</translation>
    </message>
    <message>
      <source>The filter is not valid text.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զտիչն ընթեռնելի տեքստ չէ։</translation>
    </message>
    <message>
      <source>There is no field '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' դաշտ չկա։</translation>
    </message>
    <message>
      <source>Some of the changes remain because they could not be undone: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոփոխությունների մի մասը մնում է, քանի որ չհաջողվեց հետարկել. %1</translation>
    </message>
    <message>
      <source>There is no measurement of this kind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այսպիսի չափ չկա։</translation>
    </message>
    <message>
      <source>A measurement cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափը երբեք 0-ից փոքր չէ։</translation>
    </message>
    <message>
      <source>A newer Ostraka made this project (catalogue version %1, this program supports %2). Nothing was changed. Install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծն արել է ավելի նոր Ostraka-ն (կատալոգի տարբերակ %1, այս ծրագիրն աջակցում է %2)։ Ոչինչ չի փոխվել։ Տեղադրեք նոր տարբերակը։</translation>
    </message>
    <message>
      <source>The numbering cannot contain the character &apos;%1&apos;; letters, digits, &apos;.&apos;, &apos;_&apos;, &apos;/&apos; and &apos;-&apos; are allowed between the tokens.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալումը չի կարող պարունակել '%1' նիշը. տեղապահների միջև թույլատրվում են տառեր, թվանշաններ, '.', '_', '/' և '-'։</translation>
    </message>
    <message>
      <source>The numbering opens a token with { and does not close it with }.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալումը տեղապահը բացում է {-ով և չի փակում }-ով։</translation>
    </message>
    <message>
      <source>The numbering has no token {%1}; available: site, trench, context, bag, batch, yyyy, yy and n.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալումը {%1} տեղապահ չունի. կան site, trench, context, bag, batch, yyyy, yy և n։</translation>
    </message>
    <message>
      <source>The width of {%1} must be written as :04, with 12 digits at most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{%1}-ի լայնությունը պետք է գրվի որպես :04, առավելագույնը 12 նիշ։</translation>
    </message>
    <message>
      <source>Two tokens are adjacent; put &apos;-&apos; or another character between {%1} and {%2}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու տեղապահ կպած են. {%1}-ի և {%2}-ի միջև դրեք '-' կամ այլ նշան։</translation>
    </message>
    <message>
      <source>The numbering must count the sherds with {n} exactly once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալումը պետք է բեկորները հաշվի {n}-ով ճիշտ մեկ անգամ։</translation>
    </message>
    <message>
      <source>The number needs the site of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարին պետք է բեկորի հուշարձանը, որը գրանցված չէ։</translation>
    </message>
    <message>
      <source>The number needs the context of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարին պետք է բեկորի համատեքստը, որը գրանցված չէ։</translation>
    </message>
    <message>
      <source>The number needs the bag of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարին պետք է բեկորի տոպրակը, որը գրանցված չէ։</translation>
    </message>
    <message>
      <source>The number needs the batch of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարին պետք է բեկորի խմբաքանակը, որը գրանցված չէ։</translation>
    </message>
    <message>
      <source>The site %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 հուշարձանը պարունակում է '%2' նշանը, որը համարում դրա կողքին է։</translation>
    </message>
    <message>
      <source>The trench %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 խրամատը պարունակում է '%2' նշանը, որը համարում դրա կողքին է։</translation>
    </message>
    <message>
      <source>The context %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համատեքստը պարունակում է '%2' նշանը, որը համարում դրա կողքին է։</translation>
    </message>
    <message>
      <source>The bag %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տոպրակը պարունակում է '%2' նշանը, որը համարում դրա կողքին է։</translation>
    </message>
    <message>
      <source>The batch %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 խմբաքանակը պարունակում է '%2' նշանը, որը համարում դրա կողքին է։</translation>
    </message>
    <message>
      <source>The number %1 was assigned before; numbers are never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարն արդեն տրվել է. համարները կրկին չեն օգտագործվում։</translation>
    </message>
    <message>
      <source>The block of numbers up to %1 is used up; assign this computer a new block in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մինչև %1 համարների շարքը սպառված է. կարգավորումներում այս համակարգչին նոր շարք տվեք։</translation>
    </message>
    <message>
      <source>A decision needs the name of the person who makes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշմանը պետք է այն կայացնողի անունը։</translation>
    </message>
    <message>
      <source>A merge needs two or more fragments.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միավորման համար պետք է երկու կամ ավելի կտոր։</translation>
    </message>
    <message>
      <source>A split needs exactly one fragment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաժանման համար պետք է ուղիղ մեկ կտոր։</translation>
    </message>
    <message>
      <source>The name of a person must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անձի անունը չպետք է դատարկ լինի։</translation>
    </message>
    <message>
      <source>The person's initials must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անձի սկզբնատառերը չպետք է դատարկ լինեն։</translation>
    </message>
    <message>
      <source>The code of a site must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձանի ծածկագիրը չպետք է դատարկ լինի։</translation>
    </message>
    <message>
      <source>The code of a trench must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խրամատի ծածկագիրը չպետք է դատարկ լինի։</translation>
    </message>
    <message>
      <source>The number of a context must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համատեքստի համարը չպետք է դատարկ լինի։</translation>
    </message>
    <message>
      <source>The number of a bag must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակի համարը չպետք է դատարկ լինի։</translation>
    </message>
    <message>
      <source>The name of a person must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անձի անունը չափազանց երկար է. ամենաշատը 200 տառ։</translation>
    </message>
    <message>
      <source>The person&apos;s initials must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անձի սկզբնատառերը չափազանց երկար են. ամենաշատը 200 տառ։</translation>
    </message>
    <message>
      <source>The code of a site must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձանի ծածկագիրը չափազանց երկար է. ամենաշատը 200 տառ։</translation>
    </message>
    <message>
      <source>The code of a trench must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խրամատի ծածկագիրը չափազանց երկար է. ամենաշատը 200 տառ։</translation>
    </message>
    <message>
      <source>The number of a context must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համատեքստի համարը չափազանց երկար է. ամենաշատը 200 տառ։</translation>
    </message>
    <message>
      <source>The number of a bag must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակի համարը չափազանց երկար է. ամենաշատը 200 տառ։</translation>
    </message>
    <message>
      <source>The uuid is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>uuid-ը սխալ է գրված։</translation>
    </message>
    <message>
      <source>The initials %1 already belong to another person.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 սկզբնատառերն արդեն այլ անձինն են։</translation>
    </message>
    <message>
      <source>The latitude must be between -90 and 90 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լայնությունը -90-ից 90 աստիճան է։</translation>
    </message>
    <message>
      <source>The longitude must be between -180 and 180 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկայնությունը -180-ից 180 աստիճան է։</translation>
    </message>
    <message>
      <source>The site %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 հուշարձանն արդեն կա։</translation>
    </message>
    <message>
      <source>A trench needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խրամատը պատկանում է հուշարձանի։</translation>
    </message>
    <message>
      <source>A trench cannot contain itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խրամատը չի կարող լինել ինքն իր մեջ։</translation>
    </message>
    <message>
      <source>The trench %1 already exists in this site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս հուշարձանում %1 խրամատն արդեն կա։</translation>
    </message>
    <message>
      <source>A context needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համատեքստը պատկանում է հուշարձանի։</translation>
    </message>
    <message>
      <source>The trench and the context belong to different sites.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խրամատն այլ հուշարձանի է պատկանում, քան համատեքստը։</translation>
    </message>
    <message>
      <source>The context %1 already exists in this place.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեղում %1 համատեքստն արդեն կա։</translation>
    </message>
    <message>
      <source>A bag needs a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակը պատկանում է համատեքստի։</translation>
    </message>
    <message>
      <source>The weight of a bag must be greater than 0 g.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակի քաշը մեծ է 0 գ-ից։</translation>
    </message>
    <message>
      <source>A count cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Քանակը երբեք 0-ից փոքր չէ։</translation>
    </message>
    <message>
      <source>The bag %1 already exists in this context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս համատեքստում %1 տոպրակն արդեն կա։</translation>
    </message>
    <message>
      <source>The folder is on a network share (%1), which can damage catalogues; use a folder on this computer&apos;s own disk and copy backups to the share.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պանակը ցանցային ընդհանուր պահոցում է (%1), որտեղ կատալոգները վնասվում են. օգտագործեք այս համակարգչի սեփական կոշտ սկավառակի պանակ, իսկ պահուստային պատճենները պատճենեք պահոց։</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակն Ostraka-ի նախագիծ չէ. catalogue.sqlite չի պարունակում։</translation>
    </message>
    <message>
      <source>A new project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր նախագծին պետք է նոր կամ դատարկ պանակ. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>The folder cannot be created; choose a location that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պանակը չի ստեղծվում. ընտրեք տեղ, որտեղ կարող եք գրել։</translation>
    </message>
    <message>
      <source>A uuid of the export is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման մի uuid սխալ է գրված։</translation>
    </message>
    <message>
      <source>The decision is saved with the batch, but %1 is not in the catalogue yet; it is added with the next results.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշումը պահպանված է խմբաքանակի հետ, բայց %1-ը դեռ կատալոգում չկա. այն կգրանցվի հաջորդ արդյունքների հետ։</translation>
    </message>
    <message>
      <source>The field %1 is read-only: the program sets it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 դաշտը գալիս է ծրագրից։</translation>
    </message>
    <message>
      <source>A void sherd keeps its number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անվավեր բեկորը պահում է իր համարը։</translation>
    </message>
    <message>
      <source>A number cannot contain a line break, a tab or &apos;%&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարը չի պարունակում տողադարձ, տաբուլյացիա և '%'։</translation>
    </message>
    <message>
      <source>A number or code cannot contain invisible characters; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարը կամ ծածկագիրը չի կարող անտեսանելի նիշեր պարունակել. մուտքագրեք այն նորից։</translation>
    </message>
    <message>
      <source>A number has at most 120 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարն ունի առավելագույնը 120 նիշ։</translation>
    </message>
    <message>
      <source>The number %1 would be assigned twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարը երկու անգամ կտրվեր։</translation>
    </message>
    <message>
      <source>The files of %1 would have the same names as those of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի ֆայլերը կունենային նույն անունները, ինչ %2-ինը։</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարն արդեն տրվել է և կրկին չի օգտագործվում։</translation>
    </message>
    <message>
      <source>The number %1 belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարն այլ բեկորինն է։</translation>
    </message>
    <message>
      <source>Enter a value greater than 0 after ±, or 0 if the uncertainty is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>± նշանին հաջորդողը մեծ է 0-ից, կամ 0 է, եթե անորոշությունը հայտնի չէ։</translation>
    </message>
    <message>
      <source>Enter a value greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափը մեծ է 0-ից։</translation>
    </message>
    <message>
      <source>No sherd is larger than 1000 mm; check that the value is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի բեկոր 1000 մմ-ից մեծ չէ. սա միլիմետրո՞վ է։</translation>
    </message>
    <message>
      <source>No sherd is heavier than 20 kg; check that the value is in grams.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի բեկոր 20 կգ-ից ծանր չէ. սա գրամո՞վ է։</translation>
    </message>
    <message>
      <source>A share cannot exceed 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաժինը առավելագույնը 100 % է։</translation>
    </message>
    <message>
      <source>There is no sherd %1 to join.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չկա %1 բեկոր, որին այն կցվեր։</translation>
    </message>
    <message>
      <source>A sherd cannot join itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորն ինքն իրեն չի կցվում։</translation>
    </message>
    <message>
      <source>There is no context %1 in %2; add it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2-ում %1 համատեքստ չկա. նախ ավելացրեք այն։</translation>
    </message>
    <message>
      <source>A numbered sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարակալված բեկորին պետք է իր համատեքստը։</translation>
    </message>
    <message>
      <source>A sherd needs its context before it gets a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորը համար է ստանում, երբ համատեքստը հայտնի է։</translation>
    </message>
    <message>
      <source>The table cannot be sorted by &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակը չի դասավորվում ըստ '%1'-ի։</translation>
    </message>
    <message>
      <source>A sherd is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի բեկոր այլևս կատալոգում չկա։</translation>
    </message>
    <message>
      <source>The uuid of a sherd is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորի uuid-ը սխալ է գրված։</translation>
    </message>
    <message>
      <source>A sherd with this uuid already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս uuid-ով բեկոր արդեն կա։</translation>
    </message>
    <message>
      <source>A void sherd needs a reason; enter it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորն անվավեր է որևէ պատճառով. նշեք այն։</translation>
    </message>
    <message>
      <source>The number %1 appears on two sherds of this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարն այս սկավառակի երկու բեկորի վրա է։</translation>
    </message>
    <message>
      <source>The number %1 already belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարն արդեն այլ բեկորինն է։</translation>
    </message>
    <message>
      <source>The sherd of this label has no number yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պիտակի բեկորը դեռ համար չունի։</translation>
    </message>
    <message>
      <source>The text is longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեքստը 1 ՄԲ-ից երկար է։</translation>
    </message>
    <message>
      <source>The text is not valid UTF-8 or contains a zero byte.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեքստը ճիշտ UTF-8 չէ կամ պարունակում է զրոյական բայտ։</translation>
    </message>
    <message>
      <source>The text contains control characters, which documents cannot contain; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեքստը պարունակում է կառավարման նիշեր, որոնք փաստաթղթերը չեն կարող պարունակել. մուտքագրեք այն կրկին։</translation>
    </message>
    <message>
      <source>Write the day as 2026-07-14 (year-month-day).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Օրը գրվում է 2026-07-14 (տարի-ամիս-օր)։</translation>
    </message>
    <message>
      <source>Write the Munsell colour as 10YR 3/1 or N 4/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell գույնը գրվում է 10YR 3/1 կամ N 4/։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a number; write 12.5 or 12,5, without a unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1'-ը թիվ չէ. գրեք 12.5 կամ 12,5՝ առանց միավորի։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a path inside its folder; it must be relative, with &apos;/&apos; and without &apos;..&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1'-ը իր պանակի ներսի ուղի չէ. այն պետք է լինի հարաբերական՝ '/'-ով և առանց '..'-ի։</translation>
    </message>
    <message>
      <source>Not a PLY file; choose one, or export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա PLY ֆայլ չէ. նշեք PLY ֆայլ կամ նորից արտահանեք սկանը։</translation>
    </message>
    <message>
      <source>The PLY header states no format; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY վերնագիրը ձևաչափ չի նշում. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>The PLY header has an error in line %1: %2; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY վերնագրի %1 տողը սխալ է. %2. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>its format is unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ձևաչափն անհայտ է</translation>
    </message>
    <message>
      <source>a count is not a number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>քանակը թիվ չէ</translation>
    </message>
    <message>
      <source>a property cannot be read</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հատկությունը չի կարդացվում</translation>
    </message>
    <message>
      <source>a property has an unknown type</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հատկության տեսակն անհայտ է</translation>
    </message>
    <message>
      <source>the length of a list is not a whole number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ցուցակի երկարությունը ամբողջ թիվ չէ</translation>
    </message>
    <message>
      <source>a line cannot be parsed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տողն անհասկանալի է</translation>
    </message>
    <message>
      <source>The PLY header has no end; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY վերնագիրը վերջ չունի. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>The PLY header declares %1 of &apos;%2&apos;, more than the file contains; the file may be truncated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY վերնագիրը նշում է %1 '%2', ավելի, քան պարունակում է ֆայլը. այն գուցե կտրված է։</translation>
    </message>
    <message>
      <source>The PLY file has two lists of vertices; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլն ունի գագաթների երկու ցուցակ. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>The PLY vertices lack x, y or z; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY գագաթներին պակասում է x, y կամ z. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>The PLY file ends early or contains a value that is not a number; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլը շուտ է ավարտվում կամ պարունակում է մի բան, որը թիվ չէ. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>A face of the PLY file refers to a vertex that does not exist; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY-ի մի նիստը նշում է գոյություն չունեցող գագաթ. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>The PLY file ends within '%1'; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլն ավարտվում է '%1'-ի մեջտեղում. նորից պատճենեք։</translation>
    </message>
    <message>
      <source>The PLY file has no vertices; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլը գագաթներ չունի. նորից արտահանեք սկանը։</translation>
    </message>
    <message>
      <source>The PLY file states its unit as &apos;%1&apos;, but lengths must be in mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլը նշում է '%1' միավորը, բայց երկարությունները պետք է լինեն մմ-ով. արտահանեք այն մմ-ով։</translation>
    </message>
    <message>
      <source>The PLY file contains more data than its header declares; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլը պարունակում է ավելին, քան նշում է վերնագիրը. նորից արտահանեք։</translation>
    </message>
    <message>
      <source>The PLY file contains no usable points; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլում ոչ մի պիտանի կետ չկա. նորից արտահանեք սկանը։</translation>
    </message>
    <message>
      <source>No part of the edge can be a rim; draw this sherd without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եզրի ոչ մի հատված շուրթի մաս չի կարող լինել. այս բեկորը գծեք որպես առանց շուրթի բեկոր։</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %), so no diameter is given; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ ընդունվել է որպես շուրթ, հազիվ է նման դրան (%1 %), ուստի տրամագիծ չի նշվում. ստուգեք, թե ինչպես է բեկորը կանգնած։</translation>
    </message>
    <message>
      <source>The preserved rim is too short or too straight for a diameter; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շուրթի կտորը տրամագծի համար չափազանց կարճ է կամ չափազանց ուղիղ. ստուգեք, թե ինչպես է բեկորը կանգնած։</translation>
    </message>
    <message>
      <source>Drawn as a rim sherd, which is likely (%1 %); check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծված է որպես շուրթ, ինչը հավանական է (%1 %). ստուգեք։</translation>
    </message>
    <message>
      <source>This may be a rim sherd (%1 %); if it is, mark it as one and redraw it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարող է շուրթ լինել (%1 %). եթե այդպես է, նշեք դա և նորից գծեք։</translation>
    </message>
    <message>
      <source>The drawing&apos;s scale must be between 1:20 and 5:1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարի մասշտաբը պետք է լինի 1:20-ից 5:1։</translation>
    </message>
    <message>
      <source>A drawing needs a closed model (%1); create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարին պետք է փակ մոդել (%1). ստեղծեք այն 'ostraka process'-ով։</translation>
    </message>
    <message>
      <source>A drawing needs a closed model; create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծանկարին պետք է փակ մոդել. ստեղծեք այն 'ostraka process'-ով։</translation>
    </message>
    <message>
      <source>The manifest is missing; not an Ostraka export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլերի ցուցակը (manifest) բացակայում է. սա Ostraka-ի արտահանում չէ։</translation>
    </message>
    <message>
      <source>The manifest has a line that cannot be read (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մանիֆեստում կա անընթեռնելի տող (%1), ուստի ոչինչ չի կարդացվել. նորից պատճենեք պանակը։</translation>
    </message>
    <message>
      <source>The manifest names a file outside the folder (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մանիֆեստը նշում է պանակից դուրս գտնվող ֆայլ (%1), ուստի ոչինչ չի կարդացվել. նորից պատճենեք պանակը։</translation>
    </message>
    <message>
      <source>The manifest names the file %1 twice, so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մանիֆեստը %1 ֆայլը նշում է երկու անգամ, ուստի ոչինչ չի կարդացվել. նորից պատճենեք պանակը։</translation>
    </message>
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս անունով պանակ արդեն կա. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>Not every system supports names with a line break, a backslash or characters that are not UTF-8; rename this file or folder, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տողադարձ, հակառակ թեք գիծ կամ UTF-8 չհանդիսացող նիշեր պարունակող անունը ոչ բոլոր համակարգերն են պահպանում. վերանվանեք այս ֆայլը կամ պանակը և նորից փորձեք։</translation>
    </message>
    <message>
      <source>On some systems this is the same name as %1; rename one of the two, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշ համակարգերում սա նույն անունն է, ինչ %1. վերանվանեք երկուսից մեկը և նորից փորձեք։</translation>
    </message>
    <message>
      <source>Project A has another file with this name, which its catalogue does not list; nothing was merged. Move that file elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>A նախագիծն ունի այս անունով մեկ այլ ֆայլ, որը նրա կատալոգը չգիտի. տեղափոխեք այն, ոչինչ չի միավորվել։</translation>
    </message>
    <message>
      <source>Two files of the export would have the same name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանման երկու ֆայլ կունենային նույն անունը։</translation>
    </message>
    <message>
      <source>Another import into this project is running; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծ մեկ այլ ներմուծում է ընթանում. սա սպասում է դրա ավարտին։</translation>
    </message>
    <message>
      <source>Files that were missing from the project and are restored: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծից բացակայող և վերադարձված ֆայլեր՝ %1։</translation>
    </message>
    <message>
      <source>A folder with this name was created in the meantime; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մինչ այդ մեկը ստեղծել է այս անունով պանակ. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>Not an Ostraka export: this folder has no bagit.txt.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակն Ostraka-ի արտահանում չէ. bagit.txt-ը բացակայում է։</translation>
    </message>
    <message>
      <source>This file is not in the manifest; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը ցուցակում (manifest) չկա. ոչինչ չի կարդացվել։</translation>
    </message>
    <message>
      <source>This is a link, not a file; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա հղում է, ոչ թե ֆայլ. ոչինչ չի կարդացվել։</translation>
    </message>
    <message>
      <source>This folder cannot be read (%1); nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակը չի կարդացվում (%1). ոչինչ չի կարդացվել։</translation>
    </message>
    <message>
      <source>This file is missing; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը բացակայում է. ոչինչ չի կարդացվել։</translation>
    </message>
    <message>
      <source>This file has changed since the export; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը փոխվել է արտահանումից հետո. ոչինչ չի կարդացվել։</translation>
    </message>
    <message>
      <source>The column &apos;closed&apos; accepts only yes or no.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>closed սյունակում գրվում է yes կամ no։</translation>
    </message>
    <message>
      <source>The column &apos;count_written&apos; accepts only a whole number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>count_written սյունակում գրվում է ամբողջ թիվ։</translation>
    </message>
    <message>
      <source>Values in the row: %1, columns in the header: %2; correct the row.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տողի արժեքների թիվը՝ %1, վերնագրի սյունակների թիվը՝ %2. ուղղեք տողը։</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; is unknown; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' սյունակը հայտնի չէ. դրա արժեքները պահվում են որպես ձեր սեփական դաշտ։</translation>
    </message>
    <message>
      <source>Not a text file: it contains binary data, which a table never does.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը տեքստ չէ. այն պարունակում է երկուական տվյալներ, որոնք ոչ մի աղյուսակում չեն լինում։</translation>
    </message>
    <message>
      <source>This is a spreadsheet (ODS, XLSX), not a CSV table; save the sheet as 'CSV UTF-8' and import that file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա էլեկտրոնային աղյուսակ է (ODS, XLSX), ոչ թե CSV աղյուսակ. պահեք թերթը որպես 'CSV UTF-8' և ներմուծեք այդ ֆայլը։</translation>
    </message>
    <message>
      <source>Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տողը UTF-8 չէ. պահեք աղյուսակը որպես 'CSV UTF-8' և նորից փորձեք։</translation>
    </message>
    <message>
      <source>The table has more than 1,000,000 rows; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակն ունի 1 000 000-ից ավելի տող. բաժանեք այն։</translation>
    </message>
    <message>
      <source>The table has more than 1,000 columns; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակն ունի 1000-ից ավելի սյունակ. բաժանեք այն։</translation>
    </message>
    <message>
      <source>Line %1 has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տողը բացում է չակերտ, որը երբեք չի փակվում։</translation>
    </message>
    <message>
      <source>Line %1 has characters after a closing quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տողը փակող չակերտից հետո տառեր ունի։</translation>
    </message>
    <message>
      <source>Line %1 has a value longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տողն ունի 1 ՄԲ-ից երկար արժեք։</translation>
    </message>
    <message>
      <source>The table is empty; its first line must name the columns.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակը դատարկ է. առաջին տողը պետք է նշի սյունակները։</translation>
    </message>
    <message>
      <source>This sherd has no model yet, so it cannot be drawn; process its batch first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս բեկորը դեռ մոդել չունի և չի կարող գծվել. նախ մշակեք դրա խմբաքանակը։</translation>
    </message>
    <message>
      <source>The measurements of its batch are in doubt, and so is the size of this drawing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրա խմբաքանակի չափերը կասկածելի են. նույնը՝ այս գծանկարի չափը։</translation>
    </message>
    <message>
      <source>The sherd is recorded as a rim, but no part of its edge can be one; it is drawn without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ասված է, որ շուրթ է, բայց եզրի ոչ մի հատված շուրթ չի կարող լինել. գծված է առանց դրա։</translation>
    </message>
    <message>
      <source>%1 is missing and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը չկա և բաց է թողնվել։</translation>
    </message>
    <message>
      <source>%1 differs from the recorded photograph; check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը գրանցված լուսանկարը չէ. ստուգեք այն։</translation>
    </message>
    <message>
      <source>This model or picture of the sherd %1 differs from the recorded one; reprocess its batch %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բեկորի այս մոդելը կամ պատկերը տարբերվում է գրանցվածից. վերամշակեք նրա %2 խմբաքանակը։</translation>
    </message>
    <message>
      <source>%1 is exported in full detail: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն արտահանվում է ամբողջությամբ. %2</translation>
    </message>
    <message>
      <source>%1 is exported without photographs: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն արտահանվում է առանց լուսանկարների. %2</translation>
    </message>
    <message>
      <source>Photographs can be projected only onto a closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարները հնարավոր չէ դնել չփակված մոդելի վրա։</translation>
    </message>
    <message>
      <source>Not drawn: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծված չէ. %1</translation>
    </message>
    <message>
      <source>Drawn without its photographs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գծվել է առանց իր լուսանկարների. %1</translation>
    </message>
    <message>
      <source>No pictures with masks and poses of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի պատկերներ դիմակներով ու դիրքերով չկան. %2</translation>
    </message>
    <message>
      <source>No sherds to export; select some first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանելու բեկոր չկա. նախ ընտրեք։</translation>
    </message>
    <message>
      <source>The row has neither a number nor a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տողը ո՛չ համար ունի, ո՛չ uuid։</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա աղյուսակի մեկից ավելի տողում կա՝ %1 տողերում։</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1 and %2 more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա աղյուսակի մեկից ավելի տողում կա՝ %1 տողերում և ևս %2-ում։</translation>
    </message>
    <message>
      <source>Check the unit: %1 is unusual for a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգեք միավորը․ %1-ը բեկորի համար անսովոր է։</translation>
    </message>
    <message>
      <source>Check the unit: %1 is far from the other values of this column.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգեք միավորը․ %1-ը հեռու է այս սյունակի մյուս արժեքներից։</translation>
    </message>
    <message>
      <source>Not a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա uuid չէ։</translation>
    </message>
    <message>
      <source>The number and the uuid belong to different sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարն այլ բեկորինն է, քան uuid-ը։</translation>
    </message>
    <message>
      <source>A new sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր բեկորին պետք է իր համատեքստը։</translation>
    </message>
    <message>
      <source>A column of the table has no name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակի մի սյունակ անուն չունի։</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; appears twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1' սյունակը երկու անգամ կա։</translation>
    </message>
    <message>
      <source>These places and batches are not in Ostraka&apos;s format.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեղերն ու խմբաքանակները գրված չեն այնպես, ինչպես գրում է Ostraka-ն։</translation>
    </message>
    <message>
      <source>Not a PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա PLY ֆայլ չէ։</translation>
    </message>
    <message>
      <source>Not a GLB file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա GLB ֆայլ չէ։</translation>
    </message>
    <message>
      <source>This export contains no sherd records (JSON); export it again with them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արտահանումը բեկորների գրառումներ (JSON) չի պարունակում. նորից արտահանեք դրանցով։</translation>
    </message>
    <message>
      <source>The project already has this sherd with other values, which it keeps; the differing values are added in fields that end in _in_%1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծում այս բեկորն այլ արժեքներ ունի. դրանք մնում են, իսկ տարբերվողը պահվում է կողքին՝ _in_%1-ով վերջացող դաշտերում։</translation>
    </message>
    <message>
      <source>This file is not part of the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլն արտահանման ֆայլերի մեջ չէ։</translation>
    </message>
    <message>
      <source>The project has another file with this name; rename the export and import it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագիծն ունի այս անունով այլ ֆայլ. վերանվանեք արտահանումը և նորից ներմուծեք։</translation>
    </message>
    <message>
      <source>Not a sherd record (ostraka-sherd/1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա բեկորի գրառում չէ (ostraka-sherd/1)։</translation>
    </message>
    <message>
      <source>The measurement %1 has a unit other than %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 չափն այլ միավոր ունի, քան %2։</translation>
    </message>
    <message>
      <source>A value of the record has the wrong type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրառման մի արժեք պատշաճ տեսակի չէ։</translation>
    </message>
    <message>
      <source>This is too large for one ZIP file; select fewer sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա մեկ ZIP ֆայլի համար չափազանց մեծ է. ընտրեք ավելի քիչ բեկոր։</translation>
    </message>
    <message>
      <source>The mask is missing; expected a mask of %1 x %2 pixels under this name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիմակը բացակայում է. այս անունով սպասվում է %1 x %2 պիքսել դիմակ։</translation>
    </message>
    <message>
      <source>The mask cannot be read as a picture; expected a mask of %1 x %2 pixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիմակը որպես պատկեր չի կարդացվում. սպասվում է %1 x %2 պիքսել դիմակ։</translation>
    </message>
    <message>
      <source>The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size of its photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիմակն ունի %1 x %2 պիքսել. սպասվում է %3 x %4 պիքսել դիմակ՝ լուսանկարի չափով։</translation>
    </message>
    <message>
      <source>Masks from the plate need at least 3 photographs of a side; photograph more positions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակով դիմակների համար պետք է երեսի առնվազն 3 լուսանկար. նկարեք ավելի շատ դիրքեր։</translation>
    </message>
    <message>
      <source>The photograph differs in size from its camera&apos;s images; use the original file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարը տեսախցիկի չափը չունի. օգտագործեք սկզբնական ֆայլը։</translation>
    </message>
    <message>
      <source>No sherd was found on the plate; check that the photographs show sherds that stand out from the plate, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի վրա բեկոր չգտնվեց. ստուգեք, որ լուսանկարներում երևում են սկավառակից տարբերվող բեկորներ, կամ տվեք դիմակներ։</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 differs in size from the camera&apos;s other photographs; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դիմակներ. %1 տեսախցիկի դատարկ սկավառակի պատկերը տեսախցիկի լուսանկարների չափը չունի. դիմակներն արվել են առանց դրա</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows the plate at none of the positions; retake it at the first; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դիմակներ. %1 տեսախցիկի դատարկ սկավառակի պատկերը սկավառակը դիրքերից ոչ մեկում չի ցուցադրում. նորից նկարեք առաջին դիրքում. դիմակներն արվել են առանց դրա</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows covered markers in %2; uncover them; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դիմակներ. %1 տեսախցիկի դատարկ սկավառակը ցույց է տալիս նշիչներ, որոնք %2-ում ծածկված են. հանեք դրանց վրա դրվածը. դիմակներն արվել են առանց դրա</translation>
    </message>
    <message>
      <source>masks: a shadow that the other photographs do not show falls on the plate in %1; keep people and hands out of the light, and retake these if their masks look wrong</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դիմակներ. %1-ում սկավառակի վրա կա ստվեր, որը մյուս լուսանկարներում չկա. մարդիկ ու ձեռքերը լույսի առջև չլինեն. եթե դիմակները սխալ են թվում, այս լուսանկարները նորից արեք</translation>
    </message>
    <message>
      <source>%1 (%2 % of the bare plate)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (բաց սկավառակի %2 %)</translation>
    </message>
    <message>
      <source>masks: flat objects that look like labels or scale bars are left out (%1); if there are sherds among them, add them to the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դիմակներ՝ պիտակների կամ մասշտաբների նման տափակ իրերը բաց են թողնված (%1). եթե դրանց մեջ բեկորներ կան, ավելացրեք դրանք դիմակներին</translation>
    </message>
    <message>
      <source>The front scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի սկանում կետեր չկան։</translation>
    </message>
    <message>
      <source>The front scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի սկանը նորմալներ չունի. մոդելին պետք է իմանալ, թե որն է դրսի կողմը։</translation>
    </message>
    <message>
      <source>The back scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի սկանում կետեր չկան։</translation>
    </message>
    <message>
      <source>The back scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի սկանը նորմալներ չունի. մոդելին պետք է իմանալ, թե որն է դրսի կողմը։</translation>
    </message>
    <message>
      <source>The scans do not enclose a volume; their normals may point inward.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանները մարմին չեն պարփակում. գուցե դրանց նորմալներն ուղղված են ներս։</translation>
    </message>
    <message>
      <source>Only a closed mesh can be simplified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միայն փակ ցանցը կարելի է նոսրացնել։</translation>
    </message>
    <message>
      <source>The deviation of a simplified mesh must be greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոսրացված ցանցի շեղումը պետք է մեծ լինի 0 մմ-ից։</translation>
    </message>
    <message>
      <source>The scan is too large for a model at this spacing; use a larger spacing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանը չափազանց մեծ է կետերի այս հեռավորությամբ մոդելի համար. տվեք ավելի մեծը։</translation>
    </message>
    <message>
      <source>The scans contain too few points that agree with each other for a model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկաններում մոդելի համար շատ քիչ են իրար համապատասխանող կետերը։</translation>
    </message>
    <message>
      <source>This model is %1 mm in size, larger than any vessel, so its unit is probably not mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս մոդելի չափը %1 մմ է՝ ցանկացած անոթից մեծ. դրա միավորը կարծես ուրիշ է. արտահանեք այն մմ-ով։</translation>
    </message>
    <message>
      <source>This model is only %1 mm in size, smaller than any sherd, so its unit is probably not mm (%2); export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս մոդելն ընդամենը %1 մմ է, ցանկացած բեկորից փոքր, ուստի նրա միավորը հավանաբար այլ է (%2). արտահանեք այն մմ-ով։</translation>
    </message>
    <message>
      <source>Edge %1 is used more than once in the same direction.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 կողը նույն ուղղությամբ օգտագործված է մեկից ավելի անգամ։</translation>
    </message>
    <message>
      <source>Edge %1 has a face on one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 կողը միայն մի կողմից նիստ ունի։</translation>
    </message>
    <message>
      <source>Vertex %1 belongs to no face.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 գագաթը ոչ մի նիստի չի պատկանում։</translation>
    </message>
    <message>
      <source>Vertex %1 joins two separate fans of faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 գագաթն իրար է միացնում նիստերի երկու հովհար։</translation>
    </message>
    <message>
      <source>The mesh has no faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցանցը նիստեր չունի։</translation>
    </message>
    <message>
      <source>A face refers to a vertex that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի նիստ նշում է գագաթ, որը չկա։</translation>
    </message>
    <message>
      <source>A face has the same vertex twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի նիստ երկու անգամ նույն գագաթն ունի։</translation>
    </message>
    <message>
      <source>The scan&apos;s outline is not closed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանի ուրվագիծը չի փակվում։</translation>
    </message>
    <message>
      <source>A scan of fewer than 20 points has no outline.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>20-ից քիչ կետերով սկանն ուրվագիծ չունի։</translation>
    </message>
    <message>
      <source>A contour needs at least three points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ուրվագծին պետք է առնվազն երեք կետ։</translation>
    </message>
    <message>
      <source>The evidence for a pair has no valid scans or value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի զույգի տվյալներում չկան վավեր սկաններ կամ թիվ։</translation>
    </message>
    <message>
      <source>pairing: %1 stays unpaired: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>զուգավորում. %1-ը մնում է առանց զույգի. %2</translation>
    </message>
    <message>
      <source>No two outlines match, so the sizes of the two sides cannot be compared; provide a known length.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Իրար նման երկու ուրվագիծ չկա, ուստի երեսների չափերը համեմատել հնարավոր չէ. տվեք հայտնի երկարություն։</translation>
    </message>
    <message>
      <source>A candidate refers to a scan that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի թեկնածու նշում է սկան, որը չկա։</translation>
    </message>
    <message>
      <source>Not a candidate table; reprocess the batch, which redoes only its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա թեկնածուների աղյուսակ չէ. վերամշակեք խմբաքանակը, նորից կարվեն միայն դրա զույգերը։</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, whose side has been reshot since; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2-ի %1-ի որոշումը վերաբերում է %3-ին, որի երեսն այդ ժամանակից վերալուսանկարվել է. նորից որոշեք։</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, which is no longer on the plate; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2-ի %1-ի որոշումը վերաբերում է %3-ին, որն այլևս սկավառակի վրա չէ. նորից որոշեք։</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 has no effect: the later decision of %3 by %4 concerns the same scan; withdraw one of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2-ի %1-ի որոշումը չի գործում. %4-ի %3-ի որոշումը, որն ավելի ուշ է, նույն սկանի մասին է. դրանցից մեկը հետ վերցրեք։</translation>
    </message>
    <message>
      <source>A decision is of an unknown kind; a newer version of Ostraka wrote it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի որոշում այն տեսակի է, որն այս ծրագիրը չգիտի. այն գրել է ավելի նորը։</translation>
    </message>
    <message>
      <source>A pair needs one front and one back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգին պետք են մեկ առջևի և մեկ հետևի երես։</translation>
    </message>
    <message>
      <source>Nothing is selected to set aside or reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ չի նշվել՝ մի կողմ դնելու կամ վերալուսանկարելու համար։</translation>
    </message>
    <message>
      <source>Fragments to merge must be of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միավորվող կտորները պետք է նույն երեսից լինեն։</translation>
    </message>
    <message>
      <source>A split needs one fragment and a line of at least 1 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաժանման համար պետք են մեկ կտոր և առնվազն 1 մմ գիծ։</translation>
    </message>
    <message>
      <source>Nothing is selected to withdraw.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչինչ չի նշվել հետ վերցնելու համար։</translation>
    </message>
    <message>
      <source>A newer version of Ostraka wrote these decisions; use that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս որոշումները գրել է ավելի նոր ծրագիր. օգտագործեք այն։</translation>
    </message>
    <message>
      <source>Decision %1 cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 որոշումը հնարավոր չէ օգտագործել։</translation>
    </message>
    <message>
      <source>Its id is missing or used twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրա նույնացուցիչը բացակայում է կամ օգտագործված է երկու անգամ։</translation>
    </message>
    <message>
      <source>It replaces more than %1 decisions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն փոխարինում է %1-ից ավելի որոշում։</translation>
    </message>
    <message>
      <source>It replaces a decision twice, or one that does not come before it in the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն երկու անգամ փոխարինում է մի որոշում կամ այնպիսին, որը ֆայլում իրենից առաջ չէ։</translation>
    </message>
    <message>
      <source>A batch can have at most %1 decisions; move this file elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակը կարող է ունենալ առավելագույնը %1 որոշում. տեղափոխեք այս ֆայլը կամ ետ դրեք դրա պատճենը։</translation>
    </message>
    <message>
      <source>Correct it, or restore a copy of the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ուղղեք այն կամ ետ դրեք ֆայլի պատճենը։</translation>
    </message>
    <message>
      <source>Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սրանք այս ծրագրի որոշումներ չեն. հեռացրեք ֆայլը կամ ետ դրեք դրա պատճենը։</translation>
    </message>
    <message>
      <source>This decision is no longer in effect.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս որոշումն այլևս չի գործում։</translation>
    </message>
    <message>
      <source>There is no photograph of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս երեսի լուսանկար չկա։</translation>
    </message>
    <message>
      <source>The outlines of these two sides cannot be overlaid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս երկու երեսների ուրվագծերն իրար վրա դնել հնարավոր չէ։</translation>
    </message>
    <message>
      <source>%1 may be two sherds that touch, %2 and %3 of the other side: split it in the review, or move them apart and reshoot its side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը կարող է լինել իրար դիպչող երկու բեկոր՝ մյուս երեսի %2-ը և %3-ը. բաժանեք այն ստուգման մեջ կամ հեռացրեք դրանք իրարից և վերալուսանկարեք այդ երեսը։</translation>
    </message>
    <message>
      <source>Not a list of mask strokes; restore an earlier one, or delete it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա դիմակների վրայի վրձնահարվածների ցանկ չէ. ետ դրեք նախորդը կամ հեռացրեք այն։</translation>
    </message>
    <message>
      <source>A mask holds at most 1,000 strokes and 100,000 points; nothing is saved until you undo some.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիմակը պարունակում է առավելագույնը 1000 վրձնահարված և 100 000 կետ. ոչինչ չի պահպանվում, մինչև մի քանիսը չհետարկեք։</translation>
    </message>
    <message>
      <source>This batch has no masks yet; process it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը դեռ դիմակներ չունի. նախ մշակեք այն։</translation>
    </message>
    <message>
      <source>This file does not state how well the rig fits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը չի ասում, թե որքան էր համապատասխանում սարքակազմը։</translation>
    </message>
    <message>
      <source>This calibration is for other cameras than those of the batch; calibrate the rig from its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տրամաչափումն այլ տեսախցիկներինն է, ոչ թե նրանց, որոնցով լուսանկարվել է խմբաքանակը. տրամաչափեք սարքակազմն իր իսկ լուսանկարներով։</translation>
    </message>
    <message>
      <source>Masks cannot be made without plate.json; put masks next to the photographs, or choose a network (--masks MODEL.onnx).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առանց plate.json-ի դիմակները գտնել հնարավոր չէ. լուսանկարների կողքին դրեք դիմակներ կամ նշեք ցանց (--masks MODEL.onnx)։</translation>
    </message>
    <message>
      <source>The result has no scale: without plate.json no length is known, and lengths in mm are based on a guessed pixel size; photograph on a marker plate, lay the board of board.json beside the sherds on both sides, or mark a known length on both in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյունքը մասշտաբ չունի. առանց plate.json-ի ոչ մի երկարություն հայտնի չէ, և մմ-ով նշվածը հիմնված է պիքսելի ենթադրյալ չափի վրա. լուսանկարեք նշիչներով սկավառակի վրա, երկու երեսների դեպքում էլ բեկորների կողքին դրեք board.json-ի տախտակը կամ երկուսի վրա էլ scale.json-ում նշեք հայտնի երկարություն։</translation>
    </message>
    <message>
      <source>The output folder contains files that Ostraka did not write; choose another or an empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյունքների պանակում կա մի բան, որն այս ծրագրինը չէ. ընտրեք ուրիշը կամ դատարկը։</translation>
    </message>
    <message>
      <source>The file has changed since the batch&apos;s processing began; nothing made from it is kept. Process the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը փոխվել է խմբաքանակի մշակումն սկսվելուց հետո. դրանից ստացված ոչինչ չի պահվում։ Նորից մշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. Measure one; then correct the file, or leave the option out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլում նշիչների կողմերը %1 մմ են, իսկ --marker-mm-ով նշված է %2 մմ։ Չափեք մեկը, ապա ուղղեք ֆայլը կամ բաց թողեք ընտրանքը։</translation>
    </message>
    <message>
      <source>This photograph is identical to %1; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարը նույնն է, ինչ %1-ը. այն բաց է թողնվում։</translation>
    </message>
    <message>
      <source>These results were made from the photographs of %1, not of %2; process %3 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արդյունքներն ստացվել են %1-ի, ոչ թե %2-ի լուսանկարներից. մշակեք հենց %3-ը։</translation>
    </message>
    <message>
      <source>These results were not made from the photographs of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արդյունքները %1-ի լուսանկարներից չեն ստացվել. նորից մշակեք այն։</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2 and %3 more. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի գրանցված լուսանկարներ պակասում են նրա պանակում (%1)՝ %2 և ևս %3-ը։ Վերադարձրեք դրանք և վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի գրանցված լուսանկարներ պակասում են նրա պանակում (%1)՝ %2։ Վերադարձրեք դրանք և վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>The output folder contains another batch; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյունքների պանակում այլ խմբաքանակ է. ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>The output folder contains other files; choose a new or empty folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյունքների պանակում այլ բան կա. նշեք նոր կամ դատարկ պանակ։</translation>
    </message>
    <message>
      <source>A pair refers to a scan that does not exist; delete this file and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զույգը նշում է սկան, որը չկա. ջնջեք այս ֆայլը և վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>Not a pair table; delete it and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա զույգերի աղյուսակ չէ. ջնջեք այն և վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>%1 and %2 were paired by hand, but their relative pose is unknown; align the back by hand in the review: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը և %2-ը զույգվել են ձեռքով, բայց ոչինչ չի ասում, թե ինչպես են դրանք դրված իրար նկատմամբ. ստուգման մեջ ձեռքով շրջեք հետևի երեսը. %3</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; it is left out, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. լուսանկարը մշուշոտ է. դրա եզրերի լայնությունը %2 պիքսել է, տեսախցիկի ամենահստակինը՝ %3. այն բաց է թողնվում, նորից լուսանկարեք։</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. լուսանկարը մշուշոտ է. դրա եզրերի լայնությունը %2 պիքսել է, տեսախցիկի ամենահստակինը՝ %3. նորից լուսանկարեք։</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the front side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի %2 նշիչներից %1-ը առջևի երեսի ոչ մի լուսանկարում չկա (%3). տեսախցիկները հենվում են մյուսների վրա, ուստի հանեք այն, ինչ ծածկում է դրանք։</translation>
    </message>
    <message>
      <source>All photographs of the back side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի բոլոր լուսանկարները մշուշոտ են. նույնիսկ ամենահստակում նշիչների եզրերը %1 պիքսել լայն են, ուստի դրա սկանները կոպիտ են։ Ստուգեք ֆոկուսը և կափարիչի արագությունը և վերալուսանկարեք այս երեսը։</translation>
    </message>
    <message>
      <source>All photographs of the front side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի բոլոր լուսանկարները մշուշոտ են. նույնիսկ ամենահստակում նշիչների եզրերը %1 պիքսել լայն են, ուստի դրա սկանները կոպիտ են։ Ստուգեք ֆոկուսը և կափարիչի արագությունը և վերալուսանկարեք այս երեսը։</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the back side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի %2 նշիչներից %1-ը հետևի երեսի ոչ մի լուսանկարում չկա (%3). տեսախցիկները հենվում են մյուսների վրա, ուստի հանեք այն, ինչ ծածկում է դրանք։</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 merges fragments that no longer exist; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2-ի %1-ի որոշումը միավորում է կտորներ, որոնք այլևս չկան. նորից որոշեք։</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 splits a fragment that does not exist, or misses it; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2-ի %1-ի որոշումը բաժանում է կտոր, որը չկա, կամ վրիպում է դրանից. նորից որոշեք։</translation>
    </message>
    <message>
      <source>The program %1 is not installed, but the selected stereo needs it; install it, or use the built-in stereo.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ծրագիրը տեղադրված չէ, իսկ ընտրված ստերեոյին այն պետք է. տեղադրեք այն կամ օգտագործեք ներկառուցված ստերեոն։</translation>
    </message>
    <message>
      <source>The photographs show no marker plate, so finding the cameras needs the program %1, which is not installed; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարներում նշիչներով սկավառակ չկա, ուստի տեսախցիկները պետք է գտնի %1 ծրագիրը, իսկ այն տեղադրված չէ. տեղադրեք այն։</translation>
    </message>
    <message>
      <source>This needs about %1 GB of memory, but only %2 GB are free: the computer may stop the program or become very slow.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրա համար պետք է մոտ %1 ԳԲ հիշողություն, իսկ ազատ է միայն %2 ԳԲ. համակարգիչը կարող է կանգնեցնել այն կամ շատ դանդաղել։</translation>
    </message>
    <message>
      <source>Close other programs, or process a draft.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փակեք այլ ծրագրեր կամ մշակեք սևագիր։</translation>
    </message>
    <message>
      <source>%1: the camera was not in the place that it had while the plate turned; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. լուսանկարված չէ այնտեղից, որտեղ կանգնած էր տեսախցիկը սկուտեղի պտտվելիս. այն չի օգտագործվում։</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը առջևի երեսին հրվել է մոտ %2 մմ. %3 դիրքից սկսած (pos%4) այն այլ տեղում է. վերալուսանկարեք այս երեսը։</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը առջևի երեսին հրվել է մոտ %2 մմ. %3 լուսանկարից սկսած այն այլ տեղում է. վերալուսանկարեք այս երեսը։</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը հետևի երեսին հրվել է մոտ %2 մմ. %3 դիրքից սկսած (pos%4) այն այլ տեղում է. վերալուսանկարեք այս երեսը։</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը հետևի երեսին հրվել է մոտ %2 մմ. %3 լուսանկարից սկսած այն այլ տեղում է. վերալուսանկարեք այս երեսը։</translation>
    </message>
    <message>
      <source>The output folder is inside the batch folder, to which Ostraka never writes; choose one next to it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյունքների պանակը խմբաքանակի պանակում է, ուր երբեք ոչինչ չի գրվում. ընտրեք մեկը դրա կողքին։</translation>
    </message>
    <message>
      <source>Processing needs at least %1 GB of memory.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մշակման համար անհրաժեշտ է առնվազն %1 ԳԲ հիշողություն։</translation>
    </message>
    <message>
      <source>Photographs cannot be reduced to less than 0.3 megapixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարները հնարավոր չէ փոքրացնել 0,3 մեգապիքսելից պակաս։</translation>
    </message>
    <message>
      <source>There is no such segmentation network; masks are 'auto', 'given' or an ONNX file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այդպիսի հատվածավորման ցանց չկա. դիմակները լինում են 'auto', 'given' կամ ONNX ֆայլ։</translation>
    </message>
    <message>
      <source>The fronts are not in mm: lengths in the result, although labelled mm, are in the fronts&apos; own unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսները մմ-ով չեն. արդյունքի՝ մմ կոչվող երկարություններն առջևի երեսների սեփական միավորով են։</translation>
    </message>
    <message>
      <source>The pairs of this batch are not processed yet; process the batch: complete results are kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի զույգերը դեռ մշակված չեն. մշակեք խմբաքանակը. ամբողջականը պահպանվում է։</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too small; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբը ճիշտ չէ. %1, ուստի բոլոր չափերը կլինեին %2 %-ով չափազանց փոքր. չափեք սկավառակի քանոնը և 'ostraka plate --ruler-measured' հրամանով plate.json-ին տվեք իրական չափը կամ սկավառակը նորից տպեք 100 %-ով. եթե սկավառակը ճիշտ է, չափեք երկարությունը և նորից դրեք դրա նշանները։</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too large; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբը ճիշտ չէ. %1, ուստի բոլոր չափերը կլինեին %2 %-ով չափազանց մեծ. չափեք սկավառակի քանոնը և 'ostraka plate --ruler-measured' հրամանով plate.json-ին տվեք իրական չափը կամ սկավառակը նորից տպեք 100 %-ով. եթե սկավառակը ճիշտ է, չափեք երկարությունը և նորից դրեք դրա նշանները։</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the front side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առջևի երեսին նշված %1 մմ երկարությունը լուսանկարներում %2 ± %3 մմ է (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the front side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>scale.json-ի %1 մմ երկարությունը հնարավոր չեղավ համեմատել. դրա ծայրերից յուրաքանչյուրը նշեք առջևի երեսի՝ տարբեր ուղղություններից արված առնվազն երկու լուսանկարում։</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the back side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետևի երեսին նշված %1 մմ երկարությունը լուսանկարներում %2 ± %3 մմ է (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the back side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>scale.json-ի %1 մմ երկարությունը հնարավոր չեղավ համեմատել. դրա ծայրերից յուրաքանչյուրը նշեք հետևի երեսի՝ տարբեր ուղղություններից արված առնվազն երկու լուսանկարում։</translation>
    </message>
    <message>
      <source>The folder cannot be read; choose a folder of PLY files.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պանակը կարդալ հնարավոր չէ. նշեք PLY ֆայլերով պանակ։</translation>
    </message>
    <message>
      <source>This folder contains no PLY files; each sherd&apos;s scan must be one PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում PLY ֆայլ չկա. յուրաքանչյուր բեկորի սկանը պետք է լինի մեկ PLY ֆայլ։</translation>
    </message>
    <message>
      <source>%1: 1 point without finite coordinates was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. առանց վերջավոր կոորդինատների 1 կետ բաց է թողնվել. ստուգեք արտահանումը։</translation>
    </message>
    <message>
      <source>%1: %2 points without finite coordinates were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. առանց վերջավոր կոորդինատների %2 կետ բաց է թողնվել. ստուգեք արտահանումը։</translation>
    </message>
    <message>
      <source>%1: 1 point far from all others, or at 0, 0, 0, was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. բոլոր մյուսներից հեռու կամ 0, 0, 0-ում գտնվող 1 կետ բաց է թողնվել. ստուգեք արտահանումը։</translation>
    </message>
    <message>
      <source>%1: %2 points far from all others, or at 0, 0, 0, were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. բոլոր մյուսներից հեռու կամ 0, 0, 0-ում գտնվող %2 կետ բաց է թողնվել. ստուգեք արտահանումը։</translation>
    </message>
    <message>
      <source>The scan has fewer than 100 points; rescan this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանն ունի 100-ից քիչ կետ. նորից սկանավորեք այս երեսը։</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with nx, ny and nz.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանը նորմալներ չունի. արտահանեք այն nx, ny և nz-ով։</translation>
    </message>
    <message>
      <source>The scan is %1 times its length away from the origin, so its coordinates are rounded; move it to the origin and export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանը 0, 0, 0-ից հեռու է իր երկարության %1-ապատիկով, ուստի դրա կոորդինատները կլորացված են. տեղափոխեք այնտեղ և նորից արտահանեք։</translation>
    </message>
    <message>
      <source>None of the scans can be used: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկաններից ոչ մեկը պիտանի չէ. %1</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; their unit seems to be %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սկանների մեդիանային երկարությունը %1 մմ է. միավորը նման է՝ %2. %3։</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; no sherds are of that size: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սկանների մեդիանային երկարությունը %1 մմ է. այդ չափի բեկորներ չեն լինում. %2։</translation>
    </message>
    <message>
      <source>The median length of the fronts is %1 mm, of the backs %2 mm, so their units differ: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսների մեդիանային երկարությունը %1 մմ է, հետևի երեսներինը՝ %2 մմ, ուրեմն դրանց միավորները տարբեր են. %3։</translation>
    </message>
    <message>
      <source>centimetres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սանտիմետր</translation>
    </message>
    <message>
      <source>metres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մետր</translation>
    </message>
    <message>
      <source>micrometres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>միկրոմետր</translation>
    </message>
    <message>
      <source>export them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>արտահանեք դրանք մմ-ով</translation>
    </message>
    <message>
      <source>export them in mm, or use --scale free</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>արտահանեք դրանք մմ-ով կամ օգտագործեք --scale free</translation>
    </message>
    <message>
      <source>Sherd %1 has no model: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բեկորը մոդել չունի. %2</translation>
    </message>
    <message>
      <source>Sherd %1: %2 % of its surface is unseen by any camera and filled in, orange in its picture; reshoot it if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկոր %1. մակերեսի %2 %-ը ոչ մի տեսախցիկ չի տեսել և լրացված է, նկարում՝ նարնջագույն. եթե դա կարևոր է, վերալուսանկարեք։</translation>
    </message>
    <message>
      <source>Sherd %1: its model has a hole right through it (%2 mm²). If the sherd has none, the photographs do not show that area; reshoot the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկոր %1. դրա մոդելն ունի միջանցիկ անցք (%2 մմ²)։ Եթե բեկորն անցք չունի, լուսանկարները չեն ցույց տալիս այդ տեղը. վերալուսանկարեք այն։</translation>
    </message>
    <message>
      <source>The file lists %1, which is not in the batch; delete the file to find the cameras again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն նշում է %1-ը, որը խմբաքանակում չկա. ջնջեք այս ֆայլը, և տեսախցիկները նորից կգտնվեն։</translation>
    </message>
    <message>
      <source>This photograph has no mask; provide one for each photograph to be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարը դիմակ չունի. տվեք մեկը յուրաքանչյուրի համար, որը պետք է օգտագործվի։</translation>
    </message>
    <message>
      <source>This photograph is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարը չի օգտագործվում։</translation>
    </message>
    <message>
      <source>Photographs of the front side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի լուսանկարներ, որոնք բաց են թողնվում, քանի որ COLMAP-ը չի գտել դրանց դիրքը՝ %1։</translation>
    </message>
    <message>
      <source>Photographs of the back side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի լուսանկարներ, որոնք բաց են թողնվում, քանի որ COLMAP-ը չի գտել դրանց դիրքը՝ %1։</translation>
    </message>
    <message>
      <source>The rig was not used: without plate.json the poses come from COLMAP.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը չի օգտագործվել. առանց plate.json-ի դիրքերը տալիս է COLMAP-ը։</translation>
    </message>
    <message>
      <source>%1: The mask marks no sherd in this photograph; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. դիմակն այս լուսանկարի վրա ոչ մի բեկոր չի նշում. այն բաց է թողնվում։</translation>
    </message>
    <message>
      <source>If it shows sherds, retake it or edit its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եթե դրա վրա բեկորներ կան, նորից լուսանկարեք կամ խմբագրեք դիմակը։</translation>
    </message>
    <message>
      <source>Photographs of the front side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի լուսանկարներ, որոնց դիմակները ցույց են տալիս բեկորներ՝ %1. անհրաժեշտ է առնվազն 3։</translation>
    </message>
    <message>
      <source>Photographs of the back side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի լուսանկարներ, որոնց դիմակները ցույց են տալիս բեկորներ՝ %1. անհրաժեշտ է առնվազն 3։</translation>
    </message>
    <message>
      <source>Check the masks, and whether sherds were on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նայեք դիմակներին, և թե սկավառակի վրա բեկորներ կայի՞ն։</translation>
    </message>
    <message>
      <source>Fewer than 10 fracture points match; start from a better pose.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքների 10-ից քիչ կետ է հանդիպում. սկսեք ավելի լավ դիրքից։</translation>
    </message>
    <message>
      <source>No photograph shows the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի լուսանկար չի ցույց տալիս բեկորը։</translation>
    </message>
    <message>
      <source>Not every vertex has a place in the texture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ բոլոր գագաթներն ունեն տեղ հյուսվածքում։</translation>
    </message>
    <message>
      <source>The texture of this GLB model cannot be read, so the model is used without it; reprocess its batch to write the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս GLB մոդելի հյուսվածքը հնարավոր չէ կարդալ, ուստի մոդելն օգտագործվում է առանց դրա. վերամշակեք դրա խմբաքանակը՝ ֆայլը նորից գրելու համար։</translation>
    </message>
    <message>
      <source>The texture of this model has more than 67,108,864 pixels, so the model is used without it; export the model with a smaller one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս մոդելի հյուսվածքն ունի ավելի քան 67 108 864 պիքսել, ուստի մոդելն օգտագործվում է առանց դրա. արտահանեք մոդելն ավելի փոքր հյուսվածքով։</translation>
    </message>
    <message>
      <source>The texture of sherd %1 lacks a photograph: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բեկորի հյուսվածքից մի լուսանկար պակասում է՝ %2</translation>
    </message>
    <message>
      <source>Sherd %1 has no photographic texture: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բեկորը լուսանկարային հյուսվածք չունի՝ %2</translation>
    </message>
    <message>
      <source>The colour chart is overexposed or underexposed (clipped patches: %1), so it is not used and colours stay as photographed; reshoot it at another exposure.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գունային քարտը գերլուսավորված կամ թերլուսավորված է (կտրված դաշտեր՝ %1). այն չի օգտագործվում, և գույները մնում են այնպես, ինչպես լուսանկարված են. նորից լուսանկարեք այլ լուսակայումով։</translation>
    </message>
    <message>
      <source>The colour chart is shaded, bent or partly hidden, so it is not used and colours stay as photographed; reshoot it flat, whole and evenly lit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գունային քարտը ստվերում է, ծռված կամ մասամբ ծածկված. այն չի օգտագործվում, և գույները մնում են այնպես, ինչպես լուսանկարված են. նորից լուսանկարեք այն հարթ, ամբողջական և հավասար լուսավորված։</translation>
    </message>
    <message>
      <source>colours: corrected by the colour chart in %1 photographs; its patches differ from their reference by %2 (median) and %3 (95 %), CIEDE2000</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>գույներ՝ ուղղված են ըստ գունային քարտի %1 լուսանկարում. դրա դաշտերը հղման արժեքներից տարբերվում են %2-ով (միջնարժեք) և %3-ով (95 %), CIEDE2000</translation>
    </message>
    <message>
      <source>The chosen registration method did not converge; use the default method, or align the back by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրված միացման եղանակը չզուգամիտեց. օգտագործեք լռելյայն եղանակը կամ հետևի կողմը հավասարեցրեք ձեռքով։</translation>
    </message>
    <message>
      <source>Too few fracture points for the chosen registration method; use the default method.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքի կետերը չափազանց քիչ են ընտրված միացման եղանակի համար. օգտագործեք լռելյայն եղանակը։</translation>
    </message>
    <message>
      <source>No start pose was given for the registration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երեսների միացման համար սկզբնական դիրք չի տրվել։</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանը նորմալներ չունի. արտահանեք այն նորմալներով։</translation>
    </message>
    <message>
      <source>Fewer than 50 points are on the fracture; rescan the sherd including its fracture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կոտրվածքի վրա 50-ից քիչ կետ կա. նորից սկանավորեք բեկորն իր կոտրվածքով։</translation>
    </message>
    <message>
      <source>%1: The board was not detected; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. տրամաչափման տախտակը չի երևում. այս պատկերը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բառարանը տախտակի համար շատ քիչ նշիչ ունի։</translation>
    </message>
    <message>
      <source>A grid of markers needs 'dictionary', 'markers_x', 'markers_y', 'marker_length' and 'marker_separation'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչների ցանցին պետք են 'dictionary', 'markers_x', 'markers_y', 'marker_length' և 'marker_separation'։</translation>
    </message>
    <message>
      <source>Nothing to calibrate from: put photographs of the plate at each position into &apos;front&apos; (cam0_pos00.jpg and so on) and pictures of the board into &apos;calib&apos;, and copy plate.json and board.json next to them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տրամաչափելու համար ոչինչ չկա. յուրաքանչյուր դիրքում սկավառակը լուսանկարեք 'front'-ի մեջ (cam0_pos00.jpg և այսպես շարունակ), տախտակը՝ 'calib'-ի մեջ, և կողքին պատճենեք plate.json և board.json ֆայլերը։</translation>
    </message>
    <message>
      <source>No pictures of the board found; put them here or into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տախտակի պատկերներ չկան. դրեք դրանք այստեղ կամ 'calib'-ի մեջ։</translation>
    </message>
    <message>
      <source>It is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն մի կողմ է դրվում։</translation>
    </message>
    <message>
      <source>%1: its size differs from that of the first picture; it is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. չափը առաջինինը չէ. մի կողմ է դրվում։</translation>
    </message>
    <message>
      <source>The bundle adjustment of the rig did not converge; check that plate.json and board.json describe what was photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմի հաշվարկը լուծման չհասավ. ստուգեք, որ plate.json և board.json ֆայլերը նկարագրում են այն, ինչ լուսանկարվել է։</translation>
    </message>
    <message>
      <source>The file does not describe how the sheets bend; delete it to measure them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չի ասում, թե ինչպես են ծռված թերթերը. ջնջեք ֆայլը, և դրանք կչափվեն նորից։</translation>
    </message>
    <message>
      <source>The file does not describe what the sherds stand on; delete it to determine this again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չի ասում, թե ինչի վրա են կանգնած բեկորները. ջնջեք այն, և դա նորից կգտնվի։</translation>
    </message>
    <message>
      <source>The sheet's markers can be read in %1 of %2 photographs of the %3 side; at least 3 are needed. Check that plate.json describes this sheet, that the photographs are not mirrored, and that most of the markers are in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թերթի նշիչները կարդացվում են %3 երեսի %2 լուսանկարներից %1-ում. հարկավոր է առնվազն 3։ Ստուգեք, որ plate.json-ը նկարագրում է այս թերթը, որ լուսանկարները հայելային չեն, և որ նշիչների մեծ մասը նկարում է։</translation>
    </message>
    <message>
      <source>%1: %2 of the sheet&apos;s markers can be read, too few for a pose; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: կարդացվում է թերթի %2 նշիչ, շատ քիչ՝ դիրքի համար. լուսանկարը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>Photographs that show too few of the sheet&apos;s markers for a pose are left out (%1 and %2 more); check that they show this sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց են թողնվում լուսանկարներ, որոնք դիրքի համար թերթի շատ քիչ նշիչներ են ցույց տալիս (%1 և ևս %2). ստուգեք՝ արդյոք դրանք այս թերթն են ցույց տալիս։</translation>
    </message>
    <message>
      <source>%1: most of the sheet&apos;s markers are not where the other photographs place them; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. թերթի նշիչների մեծ մասն այնտեղ չէ, որտեղ դրանք տեսնում են մյուս լուսանկարները. լուսանկարը բաց է թողնվում։</translation>
    </message>
    <message>
      <source>Only one side was photographed: its %1 scans are open surfaces without a back; they are in 'unpaired'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարվել է միայն մեկ երեսը. դրա %1 սկանները բաց մակերեսներ են՝ առանց հետևի երեսի. դրանք 'unpaired'-ում են։</translation>
    </message>
    <message>
      <source>plate.json is missing, so the plate&apos;s markers cannot be used; copy the file that &apos;ostraka plate&apos; wrote with the plate into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>plate.json չկա, ուստի սկավառակի նշիչները չեն կարող օգտագործվել. այստեղ պատճենեք այն, որը 'ostraka plate'-ը գրել է սկավառակի հետ։</translation>
    </message>
    <message>
      <source>The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig is calibrated from this batch instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հայտնի սարքակազմը չունի %1 տեսախցիկ՝ %2 x %3 պիքսել պատկերներով. փոխարենը այն տրամաչափվում է այս խմբաքանակով։</translation>
    </message>
    <message>
      <source>Its lens is estimated from the plate's markers instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դրա օբյեկտիվը փոխարենը գնահատվում է սկավառակի նշիչներով։</translation>
    </message>
    <message>
      <source>The lens of camera %1 is unknown: no usable pictures of the board and no plate markers were found; add pictures of the board to &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկի օբյեկտիվը հայտնի չէ. չկան ո՛չ տախտակի պիտանի պատկերներ, ո՛չ սկավառակի նշիչներ. 'calib'-ին ավելացրեք տախտակի պատկերներ։</translation>
    </message>
    <message>
      <source>The lens of camera %1 was estimated from the plate&apos;s markers alone; add 12 pictures of the board to &apos;calib&apos; for accurate measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկի օբյեկտիվը գնահատվել է միայն սկավառակի նշիչներով. ճշգրիտ չափերի համար 'calib'-ին ավելացրեք տախտակի 12 պատկեր։</translation>
    </message>
    <message>
      <source>The plate's markers were found in %1 of %2 photographs, too few for a pose of each side; check that plate.json belongs to this plate and that the markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի նշիչները գտնվել են %2 լուսանկարից %1-ում, ինչը շատ քիչ է երկու երեսների դիրքի համար. ստուգեք, որ plate.json-ը այս սկավառակինն է, և որ նշիչները լուսավորված են ու պատկերի մեջ են։</translation>
    </message>
    <message>
      <source>No photograph of camera %1 shows two markers of the plate; all its photographs are left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկի ոչ մի լուսանկար ցույց չի տալիս սկավառակի երկու նշիչ. դրա բոլոր լուսանկարները բաց են թողնվում։</translation>
    </message>
    <message>
      <source>The known rig no longer fits: camera %1 misses the markers by %2 px. The camera poses are re-estimated for this batch; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հայտնի սարքակազմն այլևս չի համապատասխանում. %1 տեսախցիկը վրիպում է նշիչներից %2 px. տեսախցիկների տեղերն այս խմբաքանակի համար նորից են գնահատվում, նորից տրամաչափեք սարքակազմը։</translation>
    </message>
    <message>
      <source>%1: none of its %2 markers is where this camera sees them at this position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. դրա %2 նշիչներից ոչ մեկն այնտեղ չէ, որտեղ այս տեսախցիկը դրանք տեսնում է այս դիրքում։</translation>
    </message>
    <message>
      <source>It has another photograph&apos;s name or was taken while the plate was turning; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն կրում է այլ լուսանկարի անուն կամ արվել է սկավառակի պտտվելիս. բաց է թողնվում։</translation>
    </message>
    <message>
      <source>%1: no marker is visible; check that the photograph shows this position. If not, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. դրա վրա ոչ մի նշիչ չի երևում. այս դիրքը ցո՞ւյց է տալիս։ Եթե ոչ, նորից լուսանկարեք։</translation>
    </message>
    <message>
      <source>Photographs of the front side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի հայտնի դիրքով լուսանկարներ՝ %1. անհրաժեշտ է առնվազն 3։ Ստուգեք, որ սկավառակի նշիչները լուսավորված լինեն և երևան նկարում։</translation>
    </message>
    <message>
      <source>Photographs of the back side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի հայտնի դիրքով լուսանկարներ՝ %1. անհրաժեշտ է առնվազն 3։ Ստուգեք, որ սկավառակի նշիչները լուսավորված լինեն և երևան նկարում։</translation>
    </message>
    <message>
      <source>Camera %1 sees fewer than six of the plate&apos;s markers at position %2; check lighting and focus there and that nothing covers the markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկը %2 դիրքում տեսնում է սկավառակի վեցից քիչ նշիչ. ստուգեք այնտեղի լույսն ու ֆոկուսը, և որ նշիչների վրա ոչինչ դրված չէ։</translation>
    </message>
    <message>
      <source>Positions photographed: %1; photograph at least four around the full turn to determine the axis.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարված դիրքեր՝ %1. առանցքը որոշելու համար լուսանկարեք առնվազն չորսը՝ ամբողջ պտույտով։</translation>
    </message>
    <message>
      <source>Fewer than eight markers were detected, so no distance could be held out of the fit: the scale is not checked.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երևացել է ութից քիչ նշիչ, ուստի ստուգման համար ոչ մի հեռավորություն չի պահվել. մասշտաբը ստուգված չէ։</translation>
    </message>
    <message>
      <source>Markers %1 and %2: you measured %3 mm, plate.json says %4 mm (%5 %); measure the plate&apos;s ruler and regenerate plate.json with &apos;ostraka plate --ruler-measured&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 և %2 նշիչների միջև դուք չափել եք %3 մմ, ըստ plate.json-ի՝ %4 մմ (%5 %). չափեք սկավառակի քանոնը և նորից ստեղծեք plate.json-ը 'ostraka plate --ruler-measured' հրամանով։</translation>
    </message>
    <message>
      <source>Not usable: camera %1 misses the plate&apos;s markers by a median of %2 px; check that it did not move between the photographs and that plate.json belongs to this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիտանի չէ. %1 տեսախցիկը սկավառակի նշիչներից վրիպում է %2 px (մեդիան). լուսանկարների միջև դրան դիպե՞լ են, թե՞ plate.json-ն այլ սկավառակի է։</translation>
    </message>
    <message>
      <source>Not usable: the scale is wrong.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիտանի չէ. մասշտաբը ճիշտ չէ։</translation>
    </message>
    <message>
      <source>Good: lenses, camera poses and scale are determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լավ է. օբյեկտիվները, տեսախցիկների դիրքերն ու մասշտաբը որոշված են։</translation>
    </message>
    <message>
      <source>Usable for a trial only: the lens of camera %1 comes from the plate&apos;s markers alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիտանի է միայն փորձի համար. %1 տեսախցիկի օբյեկտիվը որոշված է միայն սկավառակի նշիչներով։</translation>
    </message>
    <message>
      <source>Usable, but a focal length is uncertain by more than a thousandth.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիտանի է, բայց մի ֆոկուսային հեռավորություն հայտնի է ոչ ավելի ճշգրիտ, քան հազարերորդ մասով։</translation>
    </message>
    <message>
      <source>Usable; the steps below improve it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիտանի է. ստորև նշվածը կլավացներ այն։</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. ֆոկուսային հեռավորություն՝ %2 px (%3 %)։</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. ֆոկուսային հեռավորություն՝ %2 px (%3 %), տախտակի %4 պատկեր՝ %5 px, վատագույնը՝ %6, %7 px, թեքությունը՝ մինչև %8 աստիճան։</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), median error at the plate&apos;s markers %4 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. ֆոկուսային հեռավորություն՝ %2 px (%3 %), սկավառակի նշիչները՝ %4 px (մեդիան)։</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees, median error at the plate&apos;s markers %9 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. ֆոկուսային հեռավորություն՝ %2 px (%3 %), տախտակի %4 պատկեր՝ %5 px, վատագույնը՝ %6, %7 px, թեքությունը՝ մինչև %8 աստիճան, սկավառակի նշիչները՝ %9 px (մեդիան)։</translation>
    </message>
    <message>
      <source>Camera %1: take 12 pictures of the board, near and far, in all corners of the picture, tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. արեք տախտակի 12 պատկեր՝ մոտիկից ու հեռվից, պատկերի բոլոր անկյուններում, տարբեր ուղղություններով 20-ից 45 աստիճան թեքված։</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. տախտակը ցույց է տալիս միայն 1 պատկեր. արեք առնվազն 8, ավելի լավ է՝ 12։</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. տախտակը ցույց են տալիս միայն %2 պատկեր. արեք առնվազն 8, ավելի լավ է՝ 12։</translation>
    </message>
    <message>
      <source>Camera %1: the board barely reaches the %2 of the picture; add pictures with the board there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. տախտակը գրեթե չի հասնում պատկերի այս մասերին՝ %2. ավելացրեք պատկերներ, որտեղ տախտակն այնտեղ է։</translation>
    </message>
    <message>
      <source>upper left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վերևից ձախ</translation>
    </message>
    <message>
      <source>upper middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վերևից մեջտեղ</translation>
    </message>
    <message>
      <source>upper right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վերևից աջ</translation>
    </message>
    <message>
      <source>left middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մեջտեղից ձախ</translation>
    </message>
    <message>
      <source>middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մեջտեղ</translation>
    </message>
    <message>
      <source>right middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մեջտեղից աջ</translation>
    </message>
    <message>
      <source>lower left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ներքևից ձախ</translation>
    </message>
    <message>
      <source>lower middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ներքևից մեջտեղ</translation>
    </message>
    <message>
      <source>lower right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ներքևից աջ</translation>
    </message>
    <message>
      <source>Camera %1: no picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. ոչ մի պատկերում տախտակը 20 աստիճանից ավելի թեքված չէ. արեք առնվազն չորսը՝ տարբեր կողմեր թեքված։</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. միայն 1 պատկերում է տախտակը 20 աստիճանից ավելի թեքված. արեք առնվազն չորսը՝ տարբեր կողմեր թեքված։</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. միայն %2 պատկերում է տախտակը 20 աստիճանից ավելի թեքված. արեք առնվազն չորսը՝ տարբեր կողմեր թեքված։</translation>
    </message>
    <message>
      <source>Reprojection error %1 px over the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերապրոյեկտման սխալը սկավառակի նշիչների վրա՝ %1 px։</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ. ստուգման համար պահված %1 և %2 նշիչների հեռավորությունը %3 մմ է՝ %4-ի փոխարեն (%5 մմ, %6 %)։</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, measured by hand as %3 mm between the midpoints of their outer edges, are %4 mm apart in the photographs (%5 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ. %1 և %2 նշիչների արտաքին կողմերի միջնակետերի միջև ձեռքով չափված է %3 մմ, լուսանկարներում՝ %4 մմ (%5 %)։</translation>
    </message>
    <message>
      <source>Set aside: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի կողմ է դրված՝ %1</translation>
    </message>
    <message>
      <source>The lens is known but the camera poses are not, so no rig can be saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Օբյեկտիվը հայտնի է, տեսախցիկների տեղերը՝ ոչ. սարքակազմ պահել հնարավոր չէ։</translation>
    </message>
    <message>
      <source>Not usable: the focal length is not determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիտանի չէ. ֆոկուսային հեռավորությունը որոշված չէ։</translation>
    </message>
    <message>
      <source>Photograph the plate with its markers too: put one picture per camera and position into &apos;front&apos; (cam0_pos00.jpg and so on) next to plate.json, and the board&apos;s pictures into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարեք նաև սկավառակը՝ իր նշիչներով. յուրաքանչյուր տեսախցիկի և դիրքի համար մեկ պատկեր դրեք 'front'-ի մեջ (cam0_pos00.jpg և այսպես շարունակ) plate.json-ի կողքին, տախտակի պատկերները՝ 'calib'-ի մեջ։</translation>
    </message>
    <message>
      <source>Marker %1 of the known length is visible in fewer than two photographs; choose two markers of the plate that the photographs show.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հայտնի երկարության %1 նշիչը երկու անգամ չի երևում. նշեք սկավառակի երկու նշիչ, որոնք լուսանկարներում կան։</translation>
    </message>
    <message>
      <source>A known length needs two different markers and a value greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հայտնի երկարությանը պետք են երկու տարբեր նշիչ և զրոյից մեծ միլիմետրեր։</translation>
    </message>
    <message>
      <source>Folder not found; choose one with photographs of the plate or of the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այդպիսի պանակ չկա. նշեք սկավառակի կամ տախտակի լուսանկարներով պանակ։</translation>
    </message>
    <message>
      <source>The lens %1 is not known; it is 'standard' or 'fisheye'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 օբյեկտիվը հայտնի չէ. այն 'standard' է կամ 'fisheye'։</translation>
    </message>
    <message>
      <source>Numbers in 'dist': %1; a lens has 0, 4, 5, 8 or 12 in OpenCV's order, a fisheye has 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թվեր 'dist'-ում՝ %1. օբյեկտիվն ունի 0, 4, 5, 8 կամ 12 թիվ OpenCV-ի հերթականությամբ, ձկնաչք օբյեկտիվը՝ 4։</translation>
    </message>
    <message>
      <source>No lens has the numbers in 'dist': its picture folds near the middle. Check their order.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի օբյեկտիվ չունի 'dist'-ի թվերը. նրա պատկերը ծալվում է կենտրոնի մոտ։ Ստուգեք դրանց հերթականությունը։</translation>
    </message>
    <message>
      <source>The camera of '%1' has no valid K, R, t or size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>'%1'-ի տեսախցիկը չունի վավեր K, R, t կամ չափ։</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի պատկերի պակասում է file, width, height, K, R կամ t։</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մի պատկերի պակասում է file, width, height, K, R կամ t (%1)։</translation>
    </message>
    <message>
      <source>The camera file has no list &apos;images&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկների ֆայլում 'images' ցուցակ չկա։</translation>
    </message>
    <message>
      <source>COLMAP&apos;s camera %1 has the model &apos;%2&apos; or values that Ostraka does not support; use the model OPENCV instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP-ի %1 տեսախցիկն ունի '%2' մոդելը կամ արժեքներ, որոնք այստեղ պիտանի չեն. փոխարենը օգտագործեք OPENCV։</translation>
    </message>
    <message>
      <source>COLMAP's model has no camera for the image '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP-ի մոդելը '%1' պատկերի համար տեսախցիկ չունի։</translation>
    </message>
    <message>
      <source>The file is damaged or not in COLMAP&apos;s format; run COLMAP again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը վնասված է կամ այնպիսին չէ, ինչպես COLMAP-ն է գրում. նորից գործարկեք COLMAP-ը։</translation>
    </message>
    <message>
      <source>The pose of this photograph is estimated without its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարի դիրքը որոշվում է առանց իր դիմակի։</translation>
    </message>
    <message>
      <source>Without plate.json, poses come from COLMAP, which is not installed; install the package &apos;colmap&apos; or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առանց plate.json-ի դիրքերը տալիս է COLMAP-ը, որը տեղադրված չէ. տեղադրեք 'colmap' փաթեթը կամ լուսանկարեք նշիչներով սկավառակի վրա։</translation>
    </message>
    <message>
      <source>COLMAP found poses for %1 of %2 photographs, too few; provide masks or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP-ը գտել է %2 լուսանկարից %1-ի դիրքը, ինչը շատ քիչ է. տվեք դիմակներ կամ լուսանկարեք նշիչներով սկավառակի վրա։</translation>
    </message>
    <message>
      <source>The scale is wrong: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %); check that plate.json belongs to this plate, that the plate is printed and glued without distortion, and that a known rig was calibrated with it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբը ճիշտ չէ. ստուգման համար պահված %1 և %2 նշիչների հեռավորությունը %3 մմ է՝ %4-ի փոխարեն (%5 մմ, %6 %). ստուգեք, որ plate.json-ն այս սկավառակինն է, որ այն ճիշտ է տպված ու սոսնձված, և որ հայտնի սարքակազմը տրամաչափվել է դրանով։</translation>
    </message>
    <message>
      <source>Relative to camera %1, camera %2 has moved by %3 mm and turned by %4 degrees since the rig was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկի համեմատ %2 տեսախցիկը սարքակազմի տրամաչափումից հետո տեղաշարժվել է %3 մմ և պտտվել %4 աստիճանով։</translation>
    </message>
    <message>
      <source>%1: the board was not detected; the picture is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. դրա վրա տախտակը չի երևում. մի կողմ է դրվում։</translation>
    </message>
    <message>
      <source>The marker dictionary &apos;%1&apos; is unknown; use one such as DICT_4X4_100.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչների '%1' բառարանը հայտնի չէ. օգտագործեք DICT_4X4_100-ի նմանը։</translation>
    </message>
    <message>
      <source>The markers&apos; side must be between 5 and 200 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչների կողմը պետք է լինի 5-ից 200 մմ։</translation>
    </message>
    <message>
      <source>The plate&apos;s diameter must be between 1 and 2000 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի տրամագիծը պետք է լինի 1-ից 2000 մմ։</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 մմ սկավառակի վրա տեղավորվում է %1 մմ վեցից քիչ նշիչ. դրա վրա տեղավորվում են %3 մմ նշիչներ։</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 մմ սկավառակի վրա տեղավորվում է %1 մմ վեցից քիչ նշիչ. մեծացրեք սկավառակը։</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 մմ նշիչները %2 մմ սկավառակի վրա բեկորի համար տեղ չեն թողնում. դրա վրա տեղավորվում են %3 մմ նշիչներ։</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 մմ նշիչները %2 մմ սկավառակի վրա բեկորի համար տեղ չեն թողնում. մեծացրեք սկավառակը։</translation>
    </message>
    <message>
      <source>The printer&apos;s margin must be between 0 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տպիչի լուսանցքը պետք է լինի 0-ից 40 մմ։</translation>
    </message>
    <message>
      <source>The sheets&apos; overlap must be between 5 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թերթերի վերածածկը պետք է լինի 5-ից 40 մմ։</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բառարանն այս սկավառակի համար շատ քիչ նշիչ ունի։</translation>
    </message>
    <message>
      <source>The measured ruler length must be in mm and within the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Քանոնի չափը պետք է լինի սկավառակի մեջ տեղավորվող երկարություն՝ մմ-ով։</translation>
    </message>
    <message>
      <source>The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. Print the file at 100 %, without &apos;fit to page&apos;, and measure again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սկավառակի քանոնը գծված է %1 մմ երկարությամբ, %2 մմ-ը տարբերվում է ավելի քան մեկ տասներորդով. տպեք ֆայլը 100 %-ով, առանց 'հարմարեցնել էջին', և նորից չափեք։</translation>
    </message>
    <message>
      <source>Camera %1 has a covariance of the wrong size; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկի կովարիացիայի չափն այլ է. նորից տրամաչափեք սարքակազմը։</translation>
    </message>
    <message>
      <source>Another version of Ostraka wrote this rig; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սարքակազմը գրել է այլ տարբերակ. նորից տրամաչափեք սարքակազմը։</translation>
    </message>
    <message>
      <source>Camera %1 appears twice in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկը սարքակազմում երկու անգամ է։</translation>
    </message>
    <message>
      <source>The rig has more than %1 positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմն ունի ավելի քան %1 դիրք. նորից տրամաչափեք այն։</translation>
    </message>
    <message>
      <source>Position %1 appears twice in the rig; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 դիրքը սարքակազմում երկու անգամ է. նորից տրամաչափեք այն։</translation>
    </message>
    <message>
      <source>The rig&apos;s lengths are not in mm; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմի երկարությունները մմ-ով չեն. նորից տրամաչափեք այն։</translation>
    </message>
    <message>
      <source>Camera %1 has pictures of %2 x %3 pixels, which no camera takes; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 տեսախցիկի պատկերները %2 x %3 փիքսել են, ինչպիսիք ոչ մի տեսախցիկ չի անում. նորից տրամաչափեք սարքակազմը։</translation>
    </message>
    <message>
      <source>Not a rig file (RIG.json); recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա սարքակազմի ֆայլ (RIG.json) չէ. նորից տրամաչափեք սարքակազմը։</translation>
    </message>
    <message>
      <source>The rig has no camera; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմը տեսախցիկ չունի. նորից տրամաչափեք այն։</translation>
    </message>
    <message>
      <source>This file already exists and is not a rig; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլն արդեն կա և սարքակազմ չէ. նշեք ուրիշը։</translation>
    </message>
    <message>
      <source>The log cannot be written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մատյանը գրել հնարավոր չէ։</translation>
    </message>
    <message>
      <source>A process cannot be started.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի գործընթաց հնարավոր չէ սկսել։</translation>
    </message>
    <message>
      <source>The program&apos;s exit status is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ծրագիրը կորավ։</translation>
    </message>
    <message>
      <source>The program cannot be started; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ծրագիրը չի գործարկվում. տեղադրեք այն։</translation>
    </message>
    <message>
      <source>%1 ended with an error; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն ավարտվեց սխալով. դրա հաղորդագրություններն այս ֆայլում են։</translation>
    </message>
    <message>
      <source>A small object of %1 mm at x %2, y %3 mm was left out; if it is a sherd, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 մմ փշուրը x %2, y %3 մմ տեղում բաց է թողնվել. եթե բեկոր է, լուսանկարեք այն առանձին։</translation>
    </message>
    <message>
      <source>A flat object at x %1, y %2 mm was left out; it may be a marker or dirt on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հարթ առարկան x %1, y %2 մմ տեղում բաց է թողնվել. կարող է լինել նշիչ կամ կեղտ սկավառակի վրա։</translation>
    </message>
    <message>
      <source>Two sherds touch at x %1, y %2 mm and were split there; leave a finger&apos;s width between sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու բեկոր դիպչում են իրար x %1, y %2 մմ տեղում և այնտեղ բաժանվել են. բեկորների միջև թողեք մեկ մատ հեռավորություն։</translation>
    </message>
    <message>
      <source>The plate&apos;s point cloud has no normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի կետերի ամպը նորմալներ չունի։</translation>
    </message>
    <message>
      <source>No sherd was found on the front side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսին ոչ մի բեկոր չգտնվեց. ստուգեք դրա դիմակներն ու լուսանկարները։</translation>
    </message>
    <message>
      <source>No sherd was found on the back side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսին ոչ մի բեկոր չգտնվեց. ստուգեք դրա դիմակներն ու լուսանկարները։</translation>
    </message>
    <message>
      <source>This COLMAP was built without CUDA, which its dense stereo needs; install one with CUDA, or use --dense builtin, which needs neither.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս colmap-ը կառուցված է առանց CUDA-ի, որը պետք է դրա խիտ ստերեոյին. տեղադրեք CUDA-ով տարբերակը կամ օգտագործեք --dense builtin, որին ոչինչ պետք չէ։</translation>
    </message>
    <message>
      <source>The masks of the views show no common object; check masks, cameras and bounds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսքերի դիմակներն ընդհանուր առարկա չունեն. ստուգեք դիմակները, տեսախցիկներն ու սահմանները։</translation>
    </message>
    <message>
      <source>InterfaceCOLMAP wrote no scene; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>InterfaceCOLMAP-ը տեսարան չթողեց. դրա հաղորդագրություններն այս ֆայլում են։</translation>
    </message>
    <message>
      <source>Stereo needs at least 3 photographs with known cameras.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խորության համար պետք է հայտնի տեսախցիկներով առնվազն 3 լուսանկար։</translation>
    </message>
    <message>
      <source>The photograph or its mask differs in size from its camera&apos;s images; use photographs of the size that the camera was calibrated with.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարի կամ դրա դիմակի չափը տեսախցիկի նշածը չէ. տվեք այն լուսանկարը, որով տրամաչափվել է տեսախցիկը։</translation>
    </message>
    <message>
      <source>The photograph differs in size from the images that its camera was calibrated with; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարի չափը տեսախցիկի նշածը չէ. տվեք այն լուսանկարը, որով տրամաչափվել է տեսախցիկը։</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դիմակի չափն իր լուսանկարինը չէ։</translation>
    </message>
    <message>
      <source>%1 found no points of the object; its output is in this file, and --dense builtin needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը առարկայի կետեր չգտավ. դրա հաղորդագրություններն այս ֆայլում են, իսկ --dense builtin-ին այլ ծրագիր պետք չէ։</translation>
    </message>
    <message>
      <source>%1 wrote points without normals; install a newer version, or use --dense builtin.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը գրել է կետեր առանց նորմալների. տեղադրեք ավելի նոր տարբերակ կամ օգտագործեք --dense builtin։</translation>
    </message>
    <message>
      <source>The program %1 is not on the PATH, but --dense %2 needs it; install it, or use --dense builtin, which needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ծրագիրը PATH-ում չկա, բայց --dense %2-ին այն պետք է. տեղադրեք այն կամ օգտագործեք --dense builtin, որին ոչինչ պետք չէ։</translation>
    </message>
    <message>
      <source>No two views agree on any surface point; check cameras and masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մակերևույթի ոչ մի կետ չգտնվեց, որի շուրջ երկու տեսք համընկնեն. ստուգեք տեսախցիկներն ու դիմակները։</translation>
    </message>
    <message>
      <source>The %1 sherds do not fit on the plate; use fewer, or another seed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 բեկորները սկավառակի վրա չեն տեղավորվում. պահանջեք ավելի քիչ կամ այլ սկզբնական թիվ։</translation>
    </message>
    <message>
      <source>sherds must be between 1 and 40.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորների թիվը պետք է լինի 1-ից 40։</translation>
    </message>
    <message>
      <source>width must be between 160 and 8192 pixels and divisible by 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լայնությունը պետք է լինի 160-ից 8192 պիքսել և բաժանվի 4-ի։</translation>
    </message>
    <message>
      <source>near_duplicates are groups of two: at most half the number of sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Իրար նման բեկորները զույգեր են՝ առավելագույնը բեկորների թվի կեսը։</translation>
    </message>
    <message>
      <source>The rig needs a camera and at least four positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սարքակազմին պետք են տեսախցիկ և առնվազն չորս դիրք. նորից տրամաչափեք այն։</translation>
    </message>
    <message>
      <source>The virtual camera has no setting %1 of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիրտուալ տեսախցիկը չունի %1 կարգավորում՝ %2 արժեքով։</translation>
    </message>
    <message>
      <source>The camera has taken no photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկը ոչ մի լուսանկար չի արել։</translation>
    </message>
    <message>
      <source>COLMAP cannot align these photographs; its output is in this file. Check that all show the same sherds with large overlap, or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>COLMAP-ը չի կարող այս լուսանկարները համապատասխանեցնել. նրա ելքն այս ֆայլում է։ Ստուգեք՝ արդյոք բոլորը նույն բեկորներն են ցույց տալիս մեծ համընկնումով, կամ լուսանկարեք նշիչներով սկավառակի վրա։</translation>
    </message>
    <message>
      <source>This model is missing; reprocess its batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս մոդելը չկա. վերամշակեք նրա խմբաքանակը։</translation>
    </message>
    <message>
      <source>This sherd is void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս բեկորն անվավեր է։</translation>
    </message>
    <message>
      <source>This sherd is void; reason: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս բեկորն անվավեր է, քանի որ՝ %1</translation>
    </message>
    <message>
      <source>%1 is void and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն անվավեր է և դուրս է թողնվել։</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %); check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ ընդունվել է որպես շուրթ, հազիվ է նման դրան (%1 %). ստուգեք, թե ինչպես է բեկորը կանգնած։</translation>
    </message>
    <message>
      <source>Ø %1 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm</translation>
    </message>
    <message>
      <source>Ø %1 cm (95 %: %2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm (95 %՝ %2-ից %3)</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պահպանված է շուրթի %1 %-ը</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պահպանված է շուրթի %1 %-ը (%2-ից %3)</translation>
    </message>
    <message>
      <source>wall %1 mm (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատը %1 mm (%2-ից %3)</translation>
    </message>
    <message>
      <source>wall %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>պատը %1 mm</translation>
    </message>
    <message>
      <source>A bag belongs to a context; enter the context first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տոպրակը համատեքստի մեջ է. նախ գրեք համատեքստը։</translation>
    </message>
    <message>
      <source>Context %1 has no bag %2; change or clear the bag at the same time.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համատեքստում %2 տոպրակ չկա. միաժամանակ փոխեք կամ դատարկեք տոպրակը։</translation>
    </message>
    <message>
      <source>There is no bag %1 in context %2 yet; enter it during capture or import a table of contexts that contains it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 համատեքստում %1 տոպրակ դեռ չկա. գրեք այն նկարահանման էջում կամ ներմուծեք համատեքստերի աղյուսակ, որտեղ այն կա։</translation>
    </message>
    <message>
      <source>The edge taken as the lip may be a fracture (%1 % that it is the lip), and the diameter may be wrong; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ ընդունվել է որպես շուրթ, կարող է կոտրվածք լինել (%1 %, որ շուրթն է), և տրամագիծը՝ սխալ. ստուգեք, թե ինչպես է բեկորը կանգնած։</translation>
    </message>
    <message>
      <source>This batch is still being photographed; it is processed afterwards.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը դեռ լուսանկարվում է. դրանից հետո կմշակվի։</translation>
    </message>
    <message>
      <source>Joins with sherds that are not in the export or were not imported are left out: %1; enter them by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կցումները այն բեկորների հետ, որոնք արտահանման մեջ չկան կամ չեն ներմուծվել, բաց են թողնված. %1. մուտքագրեք դրանք ձեռքով։</translation>
    </message>
    <message>
      <source>'%1' can be read as %2 or as %3; write one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1»-ը կարելի է կարդալ %2 կամ %3. գրեք երկուսից մեկը։</translation>
    </message>
    <message>
      <source>The batch is not fully processed; let the queue process it, then review its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակը լրիվ մշակված չէ. թողեք, որ հերթը մշակի այն, ապա ստուգեք դրա զույգերը։</translation>
    </message>
    <message>
      <source>%1 was retaken after its mask was edited; the strokes on the earlier photograph are left out. Check its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը նորից է լուսանկարվել իր դիմակը խմբագրելուց հետո. նախորդ լուսանկարի վրայի գծերը բաց են թողնված։ Ստուգեք դրա դիմակը։</translation>
    </message>
    <message>
      <source>Joins with rows that were not imported are left out: %1; correct these rows, then import the table again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չներմուծված տողերի հետ կցումները բաց են թողնվել. %1. ուղղեք այդ տողերը, ապա կրկին ներմուծեք աղյուսակը։</translation>
    </message>
    <message>
      <source>The sherd has a void_reason, so it is void; write void here, or %1 under void_reason.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորն ունի void_reason, ուրեմն անվավեր է. այստեղ գրեք void կամ void_reason սյունակում՝ %1։</translation>
    </message>
    <message>
      <source>A sherd is void only with a reason; write it under void_reason, or correct the state.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորն անվավեր է միայն պատճառով. գրեք այն void_reason սյունակում կամ ուղղեք վիճակը։</translation>
    </message>
    <message>
      <source>The state must be draft, numbered or void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վիճակը պետք է լինի draft, numbered կամ void։</translation>
    </message>
    <message>
      <source>Rows that are not imported leave their numbers free: %1; correct and import them before you assign new numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չներմուծված տողերն ազատ են թողնում իրենց համարները. %1. ուղղեք և ներմուծեք դրանք նախքան նոր համարներ տալը։</translation>
    </message>
    <message>
      <source>The number %1 was entered for a sherd of %2, which is not processed yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարը գրվել է %2-ի մի բեկորի վրա, որը դեռ մշակված չէ։</translation>
    </message>
    <message>
      <source>A sheet of an earlier drawing already exists and is not overwritten; choose another name, or delete that sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ գծանկարի թերթ արդեն կա և չի վերագրվում. ընտրեք այլ անուն կամ հեռացրեք այն։</translation>
    </message>
    <message>
      <source>Enter a number after =.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>= նշանից հետո համար է գրվում։</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա պանակ է, ոչ թե ֆայլ. նշեք ֆայլ։</translation>
    </message>
    <message>
      <source>This is a pipe, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա խողովակ է (pipe), ոչ թե ֆայլ. նշեք ֆայլ։</translation>
    </message>
    <message>
      <source>This is a socket, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա վարդակ է (socket), ոչ թե ֆայլ. նշեք ֆայլ։</translation>
    </message>
    <message>
      <source>This is a device, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա սարք է, ոչ թե ֆայլ. նշեք ֆայլ։</translation>
    </message>
    <message>
      <source>A link has taken the place of this folder&apos;s lock file; delete the link.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակի կողպեքի տեղում հղում է. ջնջեք այն։</translation>
    </message>
    <message>
        <source>A link has taken the place of a folder of a project or of a result; what it leads to was not touched. Delete the link, or move the folder itself here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Հղումը գրավել է նախագծի կամ արդյունքի պանակի տեղը. այն, ուր այն տանում է, անձեռնմխելի է մնացել։ Ջնջեք հղումը կամ տեղափոխեք պանակն այստեղ։</translation>
    </message>
    <message>
      <source>No temporary folder can be created here (%1); free some space, or set TMPDIR to another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այստեղ ժամանակավոր պանակ չի ստեղծվում (%1). տեղ ազատեք կամ TMPDIR-ում այլ պանակ նշեք։</translation>
    </message>
    <message>
      <source>The JSON contains &apos;%1&apos; twice in one object; delete one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>JSON-ը մեկ օբյեկտում երկու անգամ նշում է «%1». ջնջեք երկուսից մեկը։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a whole number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1»-ը պետք է լինի ամբողջ թիվ՝ %2-ից %3. ուղղեք։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1»-ը պետք է լինի թիվ՝ %2-ից %3. ուղղեք։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1»-ը պետք է թիվ լինի. ուղղեք։</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is mirrored: its corners run counter-clockwise as seen from above; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի %1 նշիչը հայելային է. վերևից նայելիս անկյունները գնում են ժամսլաքին հակառակ. սկավառակի ֆայլը նորից ստեղծեք։</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is not convex; list its corners in order along its edge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի %1 նշիչը ուռուցիկ չէ. անկյունները նշեք հերթով՝ եզրի երկայնքով։</translation>
    </message>
    <message>
      <source>The markers %1 and %2 of the plate overlap; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի %1 և %2 նշիչները վերադրվում են. սկավառակի ֆայլը նորից տպեք։</translation>
    </message>
    <message>
      <source>The board&apos;s markers must be smaller than its squares; correct &apos;marker_mm&apos; or &apos;square_mm&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տրամաչափման տախտակի նշիչները պետք է փոքր լինեն քառակուսիներից. ուղղեք «marker_mm»-ը կամ «square_mm»-ը։</translation>
    </message>
    <message>
      <source>A face of the PLY file has more than %1 corners; export the file again as triangles.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY-ի մի նիստ ունի %1-ից ավելի անկյուն. նորից արտահանեք եռանկյուններով։</translation>
    </message>
    <message>
      <source>The PLY file has more than %1 of '%2'; export it with fewer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PLY ֆայլում «%2»-ից %1-ից ավելին կա. արտահանեք ավելի քչով։</translation>
    </message>
    <message>
      <source>A link or a file has taken the place of a folder, or a link that of a file; replace it with the folder or the file itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պանակի տեղում հղում կամ ֆայլ է, կամ ֆայլի տեղում՝ հղում. այնտեղ դրեք հենց ֆայլերը։</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս անունով ֆայլ արդեն կա և չի վերագրվում. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>The export names a location in the project where no such file belongs; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արտահանումը նշում է նախագծի մի տեղ, որտեղ այդպիսի ֆայլ չի կարող լինել. ոչինչ չի ներմուծվել։</translation>
    </message>
    <message>
      <source>The archive contains a journal of its catalogue, which an Ostraka archive never contains; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արխիվը պարունակում է իր կատալոգի մատյանը, ինչը Ostraka-ի ոչ մի արխիվ չունի. ոչինչ չգրվեց։</translation>
    </message>
    <message>
      <source>The catalogue&apos;s tables, indexes or triggers differ from those that Ostraka creates; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգի աղյուսակները, ինդեքսներն ու տրիգերները այնպիսին չեն, ինչպիսին Ostraka-ն ստեղծում է. ոչինչ չգրվեց։</translation>
    </message>
    <message>
      <source>The output folder is gone: it was moved or deleted while Ostraka was writing to it. The photographs are untouched; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյունքի պանակն այլևս չկա. այն տեղափոխվել կամ ջնջվել է, երբ ծրագիրը գրում էր այնտեղ։ Լուսանկարներն անվնաս են. նորից սկսեք նույն հրամանը։</translation>
    </message>
    <message>
      <source>The folder already contains files; choose a new or empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պանակում արդեն ֆայլեր կան. նշեք նոր կամ դատարկ պանակ։</translation>
    </message>
    <message>
      <source>This location belongs to the archive or export &apos;%1&apos;, which new files would make invalid; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեղը պատկանում է «%1» արխիվին կամ արտահանմանը, որը նոր ֆայլերից անվավեր կդառնա. ընտրեք դրանից դուրս մի տեղ։</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեղը պատկանում է «%1» նախագծին. ընտրեք դրանից դուրս մի տեղ։</translation>
    </message>
    <message>
      <source>The name of this output must end in %1; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ելքային ֆայլի անունը պետք է ավարտվի %1-ով. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա պանակ է, ոչ թե ֆայլ. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>This output is one of the input files, which it would overwrite; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ելքը մուտքային ֆայլերից մեկն է և կվերագրեր այն. ընտրեք այլ անուն։</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a folder directly in &apos;%2&apos;, or one outside the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեղը պատկանում է «%1» նախագծին. ընտրեք պանակ անմիջապես «%2» պանակում կամ նախագծից դուրս։</translation>
    </message>
    <message>
      <source>This file describes another plate, or this plate with another ruler length; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը նկարագրում է մեկ այլ սկավառակ կամ այս սկավառակը քանոնի այլ երկարությամբ. ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>This file describes another calibration board; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը նկարագրում է մեկ այլ տրամաչափման տախտակ. ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>This folder contains photographs, and a new plate.json would describe the sheet under their sherds; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում լուսանկարներ կան, և նոր plate.json-ը կնկարագրեր դրանց խեցիների տակի թերթը. ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>This folder is a mount point or the current folder; choose a new folder inside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակն առանձին սկավառակ է կամ այն պանակը, որում գտնվում եք. նշեք նոր պանակ դրա մեջ։</translation>
    </message>
    <message>
      <source>This folder is needed for unfinished files but contains others; move it elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակն անհրաժեշտ է անավարտ ֆայլերի համար, բայց պարունակում է ուրիշները. տեղափոխեք այն։</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the front side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսում բաց է թողնվել մի առարկա՝ սովորական բեկորի երկարության %1 %-ը. առանց մասշտաբի այն կարող է բեկոր լինել։</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the back side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսում բաց է թողնվել մի առարկա՝ սովորական բեկորի երկարության %1 %-ը. առանց մասշտաբի այն կարող է բեկոր լինել։</translation>
    </message>
    <message>
      <source>The photographs of the front side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի լուսանկարները համընկնում են դրա դիմակների ցույց տվածի միայն %1 %-ում, ուստի դրա սկանները կարող են սխալ լինել։ Ստուգեք դիմակները, և որ լուսանկարելիս ոչինչ չի շարժվել։</translation>
    </message>
    <message>
      <source>The photographs of the back side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի լուսանկարները համընկնում են դրա դիմակների ցույց տվածի միայն %1 %-ում, ուստի դրա սկանները կարող են սխալ լինել։ Ստուգեք դիմակները, և որ լուսանկարելիս ոչինչ չի շարժվել։</translation>
    </message>
    <message>
      <source>All photographs look at the sheet from straight above, so heights and wall thicknesses are uncertain and broken edges are hardly seen. Add photographs from the side, tilted by 30 to 60 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բոլոր լուսանկարները թերթին նայում են ուղիղ վերևից, ուստի բարձրություններն ու պատերի հաստությունները անորոշ են, իսկ կոտրվածքի եզրերը գրեթե չեն երևում։ Ավելացրեք կողքից արված լուսանկարներ՝ 30-ից 60 աստիճան թեքությամբ։</translation>
    </message>
    <message>
      <source>If it is one, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Եթե բեկոր է, լուսանկարեք այն առանձին։</translation>
    </message>
    <message>
        <source>The catalogue is damaged (%1); nothing was changed, and no backup was deleted. Restore it with 'ostraka catalogue repair PROJECT'.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կատալոգը վնասված է (%1). ոչինչ չի փոխվել, և ոչ մի պահուստային պատճեն չի ջնջվել։ Վերականգնեք այն «ostraka catalogue repair PROJECT» հրամանով։</translation>
    </message>
    <message>
        <source>a page was changed</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>մի էջ փոխվել է</translation>
    </message>
    <message>
        <source>it is a backup, but the -wal file beside it belongs to the catalogue that it replaced</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>սա պահուստային պատճեն է, բայց կողքի -wal ֆայլը պատկանում է այն կատալոգին, որին այն փոխարինել է</translation>
    </message>
    <message>
        <source>its repair was interrupted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>նրա վերականգնումն ընդհատվել է</translation>
    </message>
    <message>
        <source>its pages are inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>նրա էջերն իրար չեն համապատասխանում</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ֆայլը դատարկ է</translation>
    </message>
    <message>
        <source>the file is not a database</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ֆայլը տվյալների շտեմարան չէ</translation>
    </message>
    <message>
        <source>the file belongs to another program</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ֆայլը պատկանում է այլ ծրագրի</translation>
    </message>
    <message>
        <source>the file contains no catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ֆայլում կատալոգ չկա</translation>
    </message>
    <message>
        <source>the header is inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>գլխագիրը հակասում է ինքն իրեն</translation>
    </message>
    <message>
        <source>it contains no project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>դրանում նախագիծ չկա</translation>
    </message>
    <message>
        <source>The catalogue cannot be read; check that it exists and check its permissions.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կատալոգը չի կարդացվում. ստուգեք՝ արդյոք այն տեղում է, և դրա թույլտվությունները։</translation>
    </message>
    <message>
        <source>This project is read-only, and there is no space for the copy that Ostraka reads; free some space in the folder for temporary files.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այս նախագիծը միայն կարդացվում է, և կարդալու պատճենի համար տեղ չկա. տեղ ազատեք ժամանակավոր ֆայլերի պանակում։</translation>
    </message>
    <message>
        <source>An older Ostraka made this project, and it is read-only here; copy it to a folder that you can write to, and open it there.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այս նախագիծը ստեղծվել է ավելի հին Ostraka-ով և այստեղ միայն կարդացվում է. պատճենեք այն մի պանակ, որտեղ կարող եք գրել, և բացեք այնտեղ։</translation>
    </message>
    <message>
        <source>The catalogue is damaged, and none of its backups is intact; copy one from an archive or another disk into the folder backups, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կատալոգը վնասված է, և դրա ոչ մի պահուստային պատճեն ամբողջական չէ. պատճենեք մեկը backups պանակ՝ արխիվից կամ այլ սկավառակից, և նորից վերականգնեք։</translation>
    </message>
    <message>
        <source>Another program has this project open; close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այս նախագիծը բացված է մեկ այլ ծրագրում. փակեք այն այնտեղ, ապա վերականգնեք։</translation>
    </message>
    <message>
        <source>%1 rows in total, %2 read; run the same import again for the others.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 տողից կարդացված է %2-ը. նույն ներմուծումը կմուտքագրի մնացածը։</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; means the same as &apos;%2&apos;; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos; սյունակը նույնն է ասում, ինչ &apos;%2&apos;-ը. դրա արժեքները պահվում են որպես ձեր սեփական դաշտ:</translation>
    </message>
    <message>
      <source>Check the drawing of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգեք %1-ի գծագիրը՝ %2</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2, բեկոր %1</translation>
    </message>
    <message>
      <source>camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. %2</translation>
    </message>
    <message>
      <source>%1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 և %2</translation>
    </message>
    <message>
      <source>Camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1. %2</translation>
    </message>
    <message>
      <source>The focal length is not determined: %1 px with a standard deviation of %2 px; take more pictures, closer and with the board tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ֆոկուսային հեռավորությունը որոշված չէ՝ %1 px, ստանդարտ շեղումը՝ %2 px. արեք ավելի շատ պատկերներ՝ ավելի մոտիկից և տախտակը տարբեր ուղղություններով 20-ից 45 աստիճան թեքված։</translation>
    </message>
    <message>
      <source>No picture shows the board tilted by more than 15 degrees; tilt it more to separate focal length from distance.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ոչ մի պատկերում տախտակը 15 աստիճանից ավելի թեքված չէ. ավելի շատ թեքեք, որ ֆոկուսային հեռավորությունն ու հեռավորությունը տարբերվեն։</translation>
    </message>
    <message>
      <source>The corners scatter by %1 px, more than the 0.3 px of sharp pictures of a flat board; check focus, lighting and the board's flatness.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>անկյունները ցրվում են %1 px, ավելի քան հարթ տախտակի հստակ պատկերների 0,3 px-ը. ստուգեք ֆոկուսը, լույսը և տախտակի հարթությունը։</translation>
    </message>
    <message>
      <source>The worst picture is %1 with %2 px; retake it or leave it out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վատագույն պատկերը %1-ն է՝ %2 px. նորից արեք կամ հանեք այն։</translation>
    </message>
    <message>
      <source>Calibration pictures that show the board: %1; at least 3 are needed. Take more pictures of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տրամաչափման նկարներ, որտեղ երևում է տախտակը՝ %1. անհրաժեշտ է առնվազն 3։ Լուսանկարեք այն ևս։</translation>
    </message>
    <message>
      <source>Camera %1, position %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1, դիրք %2. %3։</translation>
    </message>
    <message>
      <source>%1 poses are given for %2 photographs; give one pose for each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%2 լուսանկարի համար տրված է %1 դիրք. տվեք մեկական դիրք յուրաքանչյուրի համար։</translation>
    </message>
    <message>
      <source>its front no longer has a back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դրա առջևի երեսն այլևս հետևի երես չունի</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about ten times the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգեք միավորը․ %1-ը հաշվարկված արժեքից մոտ տասն անգամ մեծ է։</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about a tenth of the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգեք միավորը․ %1-ը հաշվարկված արժեքի մոտ մեկ տասներորդն է։</translation>
    </message>
    <message>
      <source>Check the value: %1 differs from the computed value by a factor of three or more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգեք արժեքը․ %1-ը հաշվարկված արժեքից առնվազն երեք անգամ տարբերվում է։</translation>
    </message>
    <message>
      <source>Check the values: %1 (%2) is below %3 (%4).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստուգեք արժեքները․ %1 (%2) փոքր է, քան %3 (%4)։</translation>
    </message>
    <message>
      <source>The computed value is %1. Delete it?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկված արժեքը %1 է։ Ջնջե՞լ այն։</translation>
    </message>
    <message>
      <source>The computed value is %1. Replace it with the measured value?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշվարկված արժեքը %1 է։ Փոխարինե՞լ չափված արժեքով։</translation>
    </message>
    <message>
      <source>the length</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>երկարությունը</translation>
    </message>
    <message>
      <source>the width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>լայնությունը</translation>
    </message>
    <message>
      <source>the minimum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նվազագույն հաստությունը</translation>
    </message>
    <message>
      <source>the maximum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առավելագույն հաստությունը</translation>
    </message>
    <message>
      <source>the thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հաստությունը</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) մմ</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate&apos;s markers are visible.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները հնարավոր չեղավ հաշվել. սկավառակի շատ քիչ նշիչ է երևում։</translation>
    </message>
    <message>
      <source>No sherd is visible on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկավառակի վրա ոչ մի բեկոր չի երևում։</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate&apos;s centre: move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորները դիպչում են կամ գրեթե դիպչում են %1 սկավառակի կենտրոնից. հեռացրեք դրանք իրարից և վերալուսանկարեք։</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate&apos;s centre was counted as one but may be two touching sherds: check it; if so, move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ ընկած է %1 սկավառակի կենտրոնից, հաշվվել է որպես մեկ, բայց կարող է լինել իրար դիպչող երկու բեկոր. նայեք այնտեղ. եթե այդպես է, հեռացրեք դրանք իրարից և վերալուսանկարեք։</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and reshoot them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսը նման է առջևի երեսին. շրջեք բեկորները և վերալուսանկարեք։</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի բեկորները հնարավոր չեղավ հաշվել. սկավառակը դատարկելուց առաջ համեմատեք պատկերները։</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի բեկորները հնարավոր չեղավ հաշվել. սկավառակը դատարկելուց առաջ համեմատեք պատկերները։</translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Find the missing ones before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշված բեկորներ՝ առջևի երեսին՝ %1, հետևի երեսին՝ %2։ Գտեք պակասողները՝ նախքան սկավառակն ազատելը։</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Check whether one was added or broke.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հաշված բեկորներ՝ առջևի երեսին՝ %1, հետևի երեսին՝ %2։ Ստուգեք՝ արդյոք մեկն ավելացվե՞լ է կամ կոտրվե՞լ։</translation>
    </message>
    <message>
      <source>The turntable&apos;s own count was %1 degrees off; it was corrected from the plate&apos;s markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտվող սեղանի սեփական հաշվարկը շեղված էր %1 աստիճանով․ այն ուղղվել է սկավառակի նշիչներով։</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka-ի նախագիծ չէ․ այս պանակում catalogue.sqlite չկա. ոչինչ չի միավորվել։</translation>
    </message>
    <message>
      <source>Another version of Ostraka made this project; nothing was merged. Open it once with this version, which updates it, or install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծն ստեղծել է Ostraka-ի մեկ այլ տարբերակ. ոչինչ չի միավորվել։ Մեկ անգամ բացեք այն այս տարբերակով, որը կթարմացնի այն, կամ տեղադրեք ավելի նոր տարբերակը։</translation>
    </message>
    <message>
      <source>A project cannot be merged with itself; name another project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագիծը չի կարող միավորվել ինքն իր հետ. նշեք մեկ այլ նախագիծ։</translation>
    </message>
    <message>
      <source>This project is read-only here, so nothing was merged; copy it to a folder that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծն այստեղ միայն ընթերցման համար է, ուստի ոչինչ չի միավորվել. պատճենեք այն այնպիսի պանակ, որտեղ կարող եք գրել։</translation>
    </message>
    <message>
      <source>The project changed while files were copied, so nothing was merged; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլերը պատճենելիս նախագիծը փոխվել է, ուստի ոչինչ չի միավորվել. նորից գործարկեք նույն հրամանը։</translation>
    </message>
    <message>
      <source>The conflict %1 (%2) cannot be settled with &apos;%3&apos;; nothing was merged. Choose one of the ways that the list of conflicts offers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 հակասությունը (%2) չի կարող լուծվել «%3» տարբերակով. ոչինչ չի միավորվել։ Ընտրեք հակասությունների ցանկում առաջարկված տարբերակներից մեկը։</translation>
    </message>
    <message>
      <source>This file must be a JSON list of {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} or {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;}; nothing was merged. Correct the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը պետք է լինի JSON ցանկ՝ {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} կամ {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;} տարրերով. ոչինչ չի միավորվել։ Ուղղեք ֆայլը։</translation>
    </message>
    <message>
      <source>The conflict %1 is settled twice in this file; nothing was merged. Keep one of the two entries.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 հակասությունն այս ֆայլում լուծված է երկու անգամ. ոչինչ չի միավորվել։ Պահեք երկու գրառումներից մեկը։</translation>
    </message>
    <message>
      <source>This file of project B differs from what its catalogue records; nothing was merged. Restore it from a copy (&apos;ostraka catalogue check&apos; lists all such files).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>B նախագծի այս ֆայլը տարբերվում է նրա կատալոգում գրանցվածից. ոչինչ չի միավորվել։ Վերականգնեք այն պատճենից («ostraka catalogue check» հրամանը թվարկում է բոլոր այդպիսի ֆայլերը)։</translation>
    </message>
    <message>
      <source>The disk does not return what was written to it; nothing was merged. Check the disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կրիչը չի վերադարձնում այն, ինչ գրվել է դրա վրա. ոչինչ չի միավորվել։ Ստուգեք կրիչը։</translation>
    </message>
    <message>
      <source>A link or a device cannot be merged; nothing was merged. Move what it leads to into project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հղումը կամ սարքը չի կարող միավորվել. ոչինչ չի միավորվել։ Դրա մատնանշած բովանդակությունը տեղափոխեք B նախագիծ։</translation>
    </message>
    <message>
      <source>Results from a cluster must be regular files with plain names; nothing of this batch was entered. Submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կլաստերի արդյունքները պետք է լինեն պարզ անուններով սովորական ֆայլեր. այս խմբաքանակից ոչինչ չի մուտքագրվել։ Խմբաքանակը նորից ուղարկեք։</translation>
    </message>
    <message>
      <source>This batch was processed here or reshot in the meantime; the cluster&apos;s results are not entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակն այդ ընթացքում մշակվել է այստեղ կամ վերալուսանկարվել. կլաստերի արդյունքները չեն մուտքագրվում։</translation>
    </message>
    <message>
      <source>The name of a partition or an account consists of letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;; look it up with &apos;sinfo&apos; or ask the cluster&apos;s administrators.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաժնի կամ հաշվի անունը կազմված է տառերից, թվանշաններից, «-», «_» և «.» նշաններից. տեսեք այն «sinfo» հրամանով կամ հարցրեք կլաստերի ադմինիստրատորներին։</translation>
    </message>
    <message>
      <source>The command that starts Ostraka on the cluster must be one line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կլաստերում Ostraka-ն գործարկող հրամանը պետք է լինի մեկ տող։</translation>
    </message>
    <message>
      <source>A job needs at least one core, and its memory and time must not be negative.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առաջադրանքին անհրաժեշտ է առնվազն մեկ միջուկ, իսկ հիշողությունն ու ժամանակը չեն կարող բացասական լինել։</translation>
    </message>
    <message>
      <source>This folder cannot be opened (%1); check its name and permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակը հնարավոր չէ բացել (%1). ստուգեք դրա անունն ու թույլտվությունները։</translation>
    </message>
    <message>
      <source>The path of this project contains a character that has a special meaning for Slurm (%, a backslash or a control character); rename the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագծի ուղին պարունակում է Slurm-ի համար հատուկ նշանակություն ունեցող նիշ (%, հակառակ շեղագիծ կամ կառավարման նիշ). վերանվանեք պանակը։</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH; run this command on a login node of the cluster, or name one with --host USER@LOGIN:/FOLDER.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ծրագիրն այս համակարգչի PATH-ում չկա. հրամանը գործարկեք կլաստերի մուտքի հանգույցում կամ նշեք այն --host USER@LOGIN:/FOLDER-ով։</translation>
    </message>
    <message>
      <source>Not a folder on a cluster; write USER@LOGIN:/FOLDER, with the folder&apos;s full path and without spaces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա կլաստերի պանակ չէ. գրեք USER@LOGIN:/FOLDER՝ պանակի լրիվ ուղիով և առանց բացատների։</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH, but --host needs it; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ծրագիրն այս համակարգչի PATH-ում չկա, բայց անհրաժեշտ է --host-ի համար. տեղադրեք այն։</translation>
    </message>
    <message>
      <source>The program %1 cannot be started there; ask the cluster&apos;s administrators how Slurm is reached.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ծրագիրն այնտեղ հնարավոր չէ գործարկել. կլաստերի ադմինիստրատորներին հարցրեք, թե ինչպես է հասանելի Slurm-ը։</translation>
    </message>
    <message>
      <source>%1 failed (%2). Nothing is lost; once the cause is removed, run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 հրամանը ձախողվեց (%2)։ Ոչինչ չի կորել. պատճառը վերացնելուց հետո նորից գործարկեք նույն հրամանը։</translation>
    </message>
    <message>
      <source>This batch contains imported scans and is not submitted; the window&apos;s queue processes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը պարունակում է ներմուծված սկաններ և չի ուղարկվում. այն մշակում է պատուհանի հերթը։</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk has %1 GB left, but the batches to submit (%2) need about %3 GB. Nothing was submitted; free some space, or submit fewer with --most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կլաստերի կրիչում մնացել է %1 ԳԲ, բայց ուղարկվող խմբաքանակներին (%2) անհրաժեշտ է մոտ %3 ԳԲ։ Ոչինչ չի ուղարկվել. ազատեք տեղ կամ --most-ով ավելի քիչ ուղարկեք։</translation>
    </message>
    <message>
      <source>Batches of this project are on another cluster or in another folder; collect them before you submit to this one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագծի խմբաքանակներ կան մեկ այլ կլաստերում կամ պանակում. հավաքեք դրանք՝ նախքան այստեղ ուղարկելը։</translation>
    </message>
    <message>
      <source>Not a list of the batches on a cluster; restore an earlier one, or delete it: batches that are on the cluster are then processed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա կլաստերի խմբաքանակների ցանկ չէ. վերականգնեք նախորդը կամ ջնջեք այն՝ կլաստերում գտնվող խմբաքանակներն այդ դեպքում նորից կմշակվեն։</translation>
    </message>
    <message>
      <source>Out of memory (%1 MB requested); the next submission requests twice as much.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հիշողությունը սպառվեց (պահանջվել էր %1 ՄԲ). հաջորդ ուղարկումը կպահանջի կրկնակին։</translation>
    </message>
    <message>
      <source>Out of time (minutes requested: %1); the next submission requests twice as many and resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ժամանակը սպառվեց (պահանջված րոպեներ՝ %1). հաջորդ ուղարկումը կպահանջի կրկնակին և կշարունակի վերջին ավարտված փուլից հետո։</translation>
    </message>
    <message>
      <source>The node failed, or the job was killed; the next submission resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հանգույցը խափանվել է, կամ առաջադրանքն ընդհատվել է. հաջորդ ուղարկումը կշարունակի վերջին ավարտված փուլից հետո։</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk is full, or your quota is used up; free some space, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կլաստերի կրիչը լցված է, կամ ձեր քվոտան սպառված է. ազատեք տեղ, ապա նորից ուղարկեք։</translation>
    </message>
    <message>
      <source>The cluster does not know this job, and the job wrote nothing into the project&apos;s folder; check that the cluster&apos;s nodes see that folder, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կլաստերը չի ճանաչում այս առաջադրանքը, և այն նախագծի պանակում ոչինչ չի գրել. ստուգեք, որ կլաստերի հանգույցները տեսնեն այդ պանակը, ապա նորից ուղարկեք։</translation>
    </message>
    <message>
      <source>The program ended with status %1; its output is in %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ծրագիրն ավարտվեց %1 կոդով. դրա արդյունքի տեքստը %2 ֆայլում է։</translation>
    </message>
    <message>
      <source>The partition ends jobs earlier than the %1 minutes requested; cancel the job, then submit again with another --partition or fewer --minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաժինն առաջադրանքներն ավարտում է պահանջված %1 րոպեից շուտ. չեղարկեք առաջադրանքը, ապա նորից ուղարկեք այլ --partition-ով կամ ավելի քիչ --minutes-ով։</translation>
    </message>
    <message>
      <source>Slurm&apos;s reason: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Slurm-ի նշած պատճառը՝ %1։</translation>
    </message>
    <message>
      <source>This network cannot be used: %1. Choose an ONNX network that takes 1 x 3 x H x W and gives 1 x 1 x h x w or 1 x 2 x h x w.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ցանցը հնարավոր չէ օգտագործել՝ %1։ Ընտրեք ONNX ցանց, որն ընդունում է 1 x 3 x H x W և տալիս 1 x 1 x h x w կամ 1 x 2 x h x w։</translation>
    </message>
    <message>
      <source>it cannot be run (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>այն հնարավոր չէ գործարկել (%1)</translation>
    </message>
    <message>
      <source>its output has another shape</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դրա ելքն այլ ձև ունի</translation>
    </message>
    <message>
      <source>its output contains numbers that are not finite</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դրա ելքը պարունակում է ոչ վերջավոր թվեր</translation>
    </message>
    <message>
      <source>its input is not an image</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դրա մուտքը պատկեր չէ</translation>
    </message>
    <message>
      <source>its input has %1 channels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դրա մուտքն ունի %1 ալիք</translation>
    </message>
    <message>
      <source>its input is larger than %1 pixels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դրա մուտքը մեծ է %1 պիքսելից</translation>
    </message>
    <message>
      <source>You have no permission to use it: copy packaging/udev/70-ostraka.rules to /etc/udev/rules.d/ and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դուք այն օգտագործելու թույլտվություն չունեք. պատճենեք packaging/udev/70-ostraka.rules ֆայլը /etc/udev/rules.d/ պանակ և նորից միացրեք սարքը։</translation>
    </message>
    <message>
      <source>It is in use by %1: &apos;ostraka devices --release&apos; releases it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն օգտագործում է %1 ծրագիրը. «ostraka devices --release» հրամանն ազատում է այն։</translation>
    </message>
    <message>
      <source>It is in use by %1: close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն օգտագործում է %1 ծրագիրը. փակեք այդ ծրագիրը։</translation>
    </message>
    <message>
      <source>The kernel has no driver for it; install one for this adapter.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միջուկը դրա համար դրայվեր չունի. տեղադրեք այս ադապտերի դրայվերը։</translation>
    </message>
    <message>
      <source>A folder of the project cannot be read (%1); check its permissions, then archive the project again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծի պանակներից մեկը չի կարդացվում (%1). ստուգեք դրա թույլտվությունները, ապա նորից արխիվացրեք նախագիծը։</translation>
    </message>
    <message>
      <source>No output folder was given; name one with --output OUT.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ելքային պանակ նշված չէ. նշեք այն --output OUT-ով։</translation>
    </message>
    <message>
      <source>No folder of front scans was given; name one with --front DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսների սկանների պանակ նշված չէ. նշեք այն --front DIR-ով։</translation>
    </message>
    <message>
      <source>No folder of back scans was given; name one with --back DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսների սկանների պանակ նշված չէ. նշեք այն --back DIR-ով։</translation>
    </message>
    <message>
      <source>The field %1 has no unit &apos;%2&apos;; choose another unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 դաշտը «%2» միավոր չունի. ընտրեք այլ միավոր։</translation>
    </message>
    <message>
      <source>The table has no column &apos;%1&apos;; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակում «%1» սյունակ չկա. ստուգեք դրա անունը։</translation>
    </message>
    <message>
      <source>The columns &apos;%1&apos; and &apos;%2&apos; are both mapped to the field %3; leave one of them out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1» և «%2» սյունակները երկուսն էլ համապատասխանեցված են %3 դաշտին. դրանցից մեկը բաց թողեք։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; maps no column; write COLUMN=FIELD or COLUMN=FIELD:unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>«%1»-ը ոչ մի սյունակ չի համապատասխանեցնում. գրեք COLUMN=FIELD կամ COLUMN=FIELD:unit։</translation>
    </message>
    <message>
      <source>The scan&apos;s colours or qualities differ in number from its points; give one for each point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանի գույների կամ որակի արժեքների թիվը տարբերվում է կետերի թվից. տվեք մեկական արժեք յուրաքանչյուր կետի համար։</translation>
    </message>
    <message>
      <source>The pixels or the mask differ in size from the stated width and height; give one value for each pixel.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պիքսելները կամ դիմակը չեն համապատասխանում նշված լայնությանն ու բարձրությանը. տվեք մեկական արժեք յուրաքանչյուր պիքսելի համար։</translation>
    </message>
    <message>
      <source>No scan of this side was given; give at least one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս երեսի սկան չի տրվել. տվեք առնվազն մեկը։</translation>
    </message>
    <message>
      <source>give them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տվեք դրանք մմ-ով</translation>
    </message>
    <message>
      <source>A remark in this file cannot be read; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլի նշումներից մեկը չի կարդացվում. վերականգնեք ֆայլի ավելի վաղ պատճենը կամ վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>Camera %1, position %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեսախցիկ %1, դիրք %2</translation>
    </message>
    <message>
        <source>%1: from %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1. %2-ից</translation>
    </message>
    <message>
        <source>%1: from the history</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1. պատմությունից</translation>
    </message>
    <message>
        <source>%1: not restored</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1. չվերականգնվեց</translation>
    </message>
    <message>
      <source>draft %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>սևագիր %1</translation>
    </message>
    <message>
      <source>The remarks in this file are longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլի նշումները երկար են %1 բայթից. վերականգնեք ֆայլի ավելի վաղ պատճենը կամ վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>A remark in this file is nested more than %1 levels deep; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլի նշումներից մեկն ունի %1-ից ավելի ներդրված մակարդակ. վերականգնեք ֆայլի ավելի վաղ պատճենը կամ վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>The template of a remark in this file is longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլի նշումներից մեկի ձևանմուշը երկար է %1 բայթից. վերականգնեք ֆայլի ավելի վաղ պատճենը կամ վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>A remark in this file uses a value more than %1 times; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլի նշումներից մեկը որևէ արժեք օգտագործում է %1-ից ավելի անգամ. վերականգնեք ֆայլի ավելի վաղ պատճենը կամ վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>The version of the damaged catalogue cannot be read, so this repair relies on the backup %1. If a newer Ostraka has changed this project since, put the damaged file back and repair it with that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վնասված կատալոգի տարբերակը չի կարդացվում, ուստի այս վերականգնումը հիմնվում է %1 պահուստային պատճենի վրա։ Եթե դրանից հետո ավելի նոր Ostraka է փոխել նախագիծը, հետ դրեք վնասված ֆայլը և վերականգնեք այն այդ տարբերակով։</translation>
    </message>
    <message>
      <source>The setting %1 of project B says that two different things are the same; nothing was merged. Ask for another copy of project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>B նախագծի %1 կարգավորումն ասում է, որ երկու տարբեր բաներ նույնն են. ոչինչ չի միավորվել։ Խնդրեք B նախագծի մեկ այլ պատճեն։</translation>
    </message>
    <message>
      <source>The number or code %1 is already in use; nothing was merged. Settle the conflict %2 with another one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարը կամ ծածկագիրն արդեն օգտագործվում է. ոչինչ չի միավորվել։ %2 հակասությունը լուծեք մեկ ուրիշով։</translation>
    </message>
    <message>
      <source>A new number cannot be empty; nothing was merged. Enter a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր համարը չի կարող դատարկ լինել. ոչինչ չի միավորվել։ Մուտքագրեք համար։</translation>
    </message>
    <message>
      <source>The merged catalogue would be inconsistent, so nothing was merged; report this with a copy of both projects.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միավորված կատալոգն անհետևողական կլիներ, ուստի ոչինչ չի միավորվել. հայտնեք այս մասին երկու նախագծերի պատճեններով։</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the front of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արդյունքները ստացվել են %1-ի առջևի երեսի ավելի վաղ լուսանկարներից. կրկին մշակեք այն։</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the back of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արդյունքները ստացվել են %1-ի հետևի երեսի ավելի վաղ լուսանկարներից. կրկին մշակեք այն։</translation>
    </message>
    <message>
      <source>Photographs of %1 that are missing or are others than these results were made from: %2 of %3. The results are entered; reprocess the batch if it was photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի լուսանկարներ, որոնք բացակայում են կամ այլ են, քան նրանք, որոնցից ստացվել են այս արդյունքները՝ %2՝ %3-ից։ Արդյունքները մուտքագրված են. կրկին մշակեք խմբաքանակը, եթե այն նորից է լուսանկարվել։</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; the cluster&apos;s results are not entered. Submit it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը ուղարկելուց հետո նորից է լուսանկարվել. կլաստերի արդյունքները չեն մուտքագրվում։ Նորից ուղարկեք այն։</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; its job %1 is of no use any more. Cancel it with &apos;scancel&apos;, or wait until it has ended, then submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակը ուղարկելուց հետո նորից է լուսանկարվել. նրա %1 առաջադրանքն այլևս պետք չէ։ Չեղարկեք այն &apos;scancel&apos;-ով կամ սպասեք մինչև ավարտվի, ապա նորից ուղարկեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>Batches of this project were submitted to this host, which was not named on this computer; nothing was sent to it. If you trust it, name it once with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագծի խմբաքանակներն ուղարկվել են այս հանգույցին, որը այս համակարգչում չի նշվել. նրան ոչինչ չի ուղարկվել։ Եթե վստահում եք նրան, մեկ անգամ նշեք այն --host-ով։</translation>
    </message>
    <message>
      <source>Not a file in which Ostraka remembers the host of a cluster; delete it, then name the host with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա այն ֆայլը չէ, որում Ostraka-ն հիշում է կլաստերի հանգույցը. ջնջեք այն, ապա նշեք հանգույցը --host-ով։</translation>
    </message>
    <message>
      <source>A job can request at most %1 MB of memory and %2 minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առաջադրանքը կարող է պահանջել առավելագույնը %1 ՄԲ հիշողություն և %2 րոպե։</translation>
    </message>
    <message>
      <source>This photograph is identical to %1 of the front side; it is left out of both sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս լուսանկարը նույնն է, ինչ առջևի երեսի %1-ը. այն բաց է թողնվում երկու երեսներում էլ։</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the front side are identical to photographs of the back side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի %2 լուսանկարներից %1-ը նույնն են, ինչ հետևի երեսի լուսանկարները (օրինակ՝ %3), ուստի խմբաքանակը չի կարող օգտագործվել. յուրաքանչյուր երեսին տվեք իր լուսանկարները։</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the back side are identical to photographs of the front side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի %2 լուսանկարներից %1-ը նույնն են, ինչ առջևի երեսի լուսանկարները (օրինակ՝ %3), ուստի խմբաքանակը չի կարող օգտագործվել. յուրաքանչյուր երեսին տվեք իր լուսանկարները։</translation>
    </message>
    <message>
      <source>The field %1 was changed meanwhile; nothing was undone or redone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 դաշտն այդ ընթացքում փոխվել է. ոչինչ չի հետարկվել կամ կրկնվել։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term; choose one of %2, or add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos;-ը տերմին չէ. ընտրեք սրանցից մեկը՝ %2, կամ ավելացրեք կարգավորումներում։</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term: the vocabulary is empty; add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&apos;%1&apos;-ը տերմին չէ. բառարանը դատարկ է, ավելացրեք այն կարգավորումներում։</translation>
    </message>
    <message>
      <source>why this row was not imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ինչու այս տողը չներմուծվեց</translation>
    </message>
    <message>
      <source>Read as a table of contexts and bags: no column has the sherds&apos; numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարդացվել է որպես համատեքստերի և տոպրակների աղյուսակ. ոչ մի սյունակ չունի բեկորների համարները։</translation>
    </message>
    <message>
      <source>Read as a table of sherds: the column &apos;%1&apos; identifies them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կարդացվել է որպես բեկորների աղյուսակ. դրանք որոշում է &apos;%1&apos; սյունակը։</translation>
    </message>
    <message>
      <source>No column has the sherds&apos; numbers, but &apos;%1&apos; is a column of sherds; select the column of numbers, or leave &apos;%1&apos; out if this is a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ոչ մի սյունակ չունի բեկորների համարները, բայց &apos;%1&apos;-ը բեկորների սյունակ է. ընտրեք համարների սյունակը կամ բաց թողեք &apos;%1&apos;-ը, եթե սա համատեքստերի աղյուսակ է։</translation>
    </message>
    <message>
        <source>%1: not restored; it belongs to %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1. չվերականգնվեց, պատկանում է՝ %2</translation>
    </message>
    <message>
      <source>Only measurements and days accept &lt; and &gt;; write %1:value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միայն չափերն ու օրերն են համեմատվում &lt; և &gt; նշաններով. գրեք %1:value։</translation>
    </message>
    <message>
      <source>The filter has no field &apos;%1&apos;; write extra.%1 for a custom field, or enclose the word in quotation marks to search for it literally.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Զտիչը &apos;%1&apos; դաշտ չգիտի. սեփական դաշտի համար գրեք extra.%1 կամ բառը դրեք չակերտների մեջ, որ փնտրվի՝ ինչպես կա։</translation>
    </message>
    <message>
      <source>Write the date in EDTF, for example -0599/-0549~ (600 to about 550 BC), -1149? or 0350/..; years have four digits, and words such as MB II belong in the field for the period.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թվագրումը գրվում է EDTF-ով, ինչպես -0599/-0549~ (մ. թ. ա. 600-ից մոտ 550), -1149? կամ 0350/..՝ քառանիշ տարիներով, իսկ MB II-ի նման բառերը գրվում են շրջանի դաշտում։</translation>
    </message>
    <message>
      <source>Enter the context with its site and trench, such as KT26-A-012.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրեք համատեքստը իր հուշարձանի և խրամատի հետ, օրինակ՝ KT26-A-012։</translation>
    </message>
    <message>
      <source>Scale: none; lengths in mm are based on a guess.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ՝ չկա. մմ-ով երկարությունները ենթադրության վրա են հիմնված։</translation>
    </message>
    <message>
      <source>Scale: the board of board.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ՝ board.json-ի տախտակը։</translation>
    </message>
    <message>
      <source>Scale: the lengths marked in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ՝ scale.json-ում նշված երկարությունները։</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as typed at the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ՝ %1 մմ նշիչներ, ինչպես մուտքագրվել է ներմուծելիս։</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as in plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ՝ %1 մմ նշիչներ, ինչպես plate.json-ում։</translation>
    </message>
    <message>
      <source>Scale: the markers that plate.json describes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ՝ plate.json-ի նկարագրած նշիչները։</translation>
    </message>
    <message>
      <source>Scale: that of the imported scans.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մասշտաբ՝ ներմուծված սկաների մասշտաբը։</translation>
    </message>
    <message>
      <source>The scale of this batch is its rig&apos;s; calibrate the rig to correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս խմբաքանակի մասշտաբը սարքակազմինն է. այն ուղղելու համար տրամաչափեք սարքակազմը։</translation>
    </message>
    <message>
      <source>The markers of this sheet are of several sizes; correct its plate.json by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս թերթի նշիչները տարբեր չափերի են. ուղղեք դրա plate.json-ը ձեռքով։</translation>
    </message>
    <message>
      <source>These results contain a measurement larger than any sherd; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արդյունքները պարունակում են ցանկացած խեցաբեկորից մեծ չափ. նորից գործարկեք &apos;ostraka process&apos;-ը։</translation>
    </message>
    <message>
      <source>This project lies in the archive &apos;%1&apos;, which any change would make invalid; restore the archive to a new folder, and open that.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծը գտնվում է «%1» արխիվում, որը ցանկացած փոփոխությունից անվավեր կդառնա. վերականգնեք արխիվը նոր պանակում և բացեք այն։</translation>
    </message>
    <message>
      <source>Not a location of photographs, results, models or imported files, the only files that a merge writes; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա լուսանկարների, արդյունքների, մոդելների կամ ներմուծված ֆայլերի տեղ չէ, իսկ միավորումը միայն այդ ֆայլերն է գրում. ոչինչ չի միավորվել։</translation>
    </message>
    <message>
      <source>A point, a normal or a quality of the scan is not finite; leave such points out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սկանի կետերից, նորմալներից կամ որակի արժեքներից մեկը վերջավոր չէ. այդպիսի կետերը բաց թողեք։</translation>
    </message>
    <message>
      <source>The lists of this cloud or mesh differ in length, or a triangle names a vertex that does not exist; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս կետային ամպի կամ ցանցի ցուցակները տարբեր երկարություն ունեն, կամ եռանկյունը նշում է գոյություն չունեցող գագաթ. ոչինչ չգրվեց։</translation>
    </message>
    <message>
      <source>The transform puts the back %1 mm away from the front; give one that takes points of the back to the front&apos;s frame.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ձևափոխությունը հետևի երեսը դնում է առջևի երեսից %1 մմ հեռու. տվեք այնպիսին, որը հետևի երեսի կետերը բերում է առջևի երեսի կոորդինատային համակարգ։</translation>
    </message>
    <message>
      <source>The model has no photographs, so the orthophoto shows the colours of its vertices.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդելը լուսանկարներ չունի, ուստի օրթոլուսանկարը ցույց է տալիս դրա գագաթների գույները։</translation>
    </message>
    <message>
      <source>The model has neither photographs nor colours, so there is no orthophoto of it; draw its shaded form.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոդելը ո՛չ լուսանկարներ ունի, ո՛չ գույներ, ուստի դրա օրթոլուսանկար չկա. գծեք ստվերավորված ձևը։</translation>
    </message>
    <message>
      <source>%1: 1 point whose normal has no direction was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. 1 կետ, որի նորմալն ուղղություն չունի, բաց է թողնվել. ստուգեք արտահանումը։</translation>
    </message>
    <message>
      <source>%1: %2 points whose normals have no direction were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1. %2 կետ, որոնց նորմալներն ուղղություն չունեն, բաց է թողնվել. ստուգեք արտահանումը։</translation>
    </message>
    <message>
      <source>The photograph is less than %1 pixels wide or high; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարի լայնությունը կամ բարձրությունը %1 պիքսելից պակաս է. օգտագործեք սկզբնական լուսանկարը։</translation>
    </message>
    <message>
        <source>The project has no site yet; add a column &apos;Site&apos;, or write the context with its site, such as %1.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նախագիծը դեռ հուշարձան չունի. ավելացրեք «Հուշարձան» սյունակ կամ համատեքստը գրեք իր հուշարձանով, օրինակ՝ %1։</translation>
    </message>
    <message>
        <source>This project has %1 sites; add a column &apos;Site&apos;, or write the context with its site, such as %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այս նախագիծն ունի %1 հուշարձան. ավելացրեք «Հուշարձան» սյունակ կամ համատեքստը գրեք իր հուշարձանով, օրինակ՝ %2։</translation>
    </message>
    <message>
        <source>The site %1 has %2 trenches; add a column &apos;Trench&apos;, or write the context with its trench, such as %3.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 հուշարձանն ունի %2 խրամատ. ավելացրեք «Խրամատ» սյունակ կամ համատեքստը գրեք իր խրամատով, օրինակ՝ %3։</translation>
    </message>
    <message>
        <source>There is no such trench in the site %1; write trench and context in columns of their own.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 հուշարձանում այդպիսի խրամատ չկա. խրամատն ու համատեքստը գրեք առանձին սյունակներում։</translation>
    </message>
    <message>
        <source>The backups %1 and %2 are of different projects, and nothing tells which of them this folder is; nothing was changed. Move those of the other project away, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 և %2 պահուստային պատճենները տարբեր նախագծերից են, և ոչինչ չի ցույց տալիս, թե դրանցից որն է այս պանակը. ոչինչ չի փոխվել։ Մյուս նախագծինը տեղափոխեք այլ տեղ, ապա նորից վերանորոգեք։</translation>
    </message>
    <message>
        <source>This can be %1 or %2; enter site, trench and context each by itself.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Սա կարող է լինել %1 կամ %2. հուշարձանը, խրամատն ու համատեքստը մուտքագրեք առանձին։</translation>
    </message>
    <message>
        <source>The table needs a column for the sherds&apos; numbers, or one for the contexts (a table of contexts); select it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Աղյուսակին պետք է սյունակ բեկորների համարների համար կամ համատեքստերի համար (համատեքստերի աղյուսակ). ընտրեք այն։</translation>
    </message>
    <message>
      <source>The number needs the trench of the sherd, which is not recorded; choose a context in a trench, or change the numbering in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարին պետք է բեկորի խրամատը, որը գրանցված չէ. ընտրեք խրամատի մեջ գտնվող համատեքստ կամ փոխեք համարակալումը կարգավորումներում։</translation>
    </message>
    <message>
      <source>This folder on the cluster belongs to another project, to another copy of this one, or to this one before it was moved; nothing was sent. Name another folder with --host. If nothing else uses this one, delete &apos;cluster/owner&apos; in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կլաստերի այս պանակը պատկանում է մեկ այլ նախագծի, այս նախագծի մեկ այլ պատճենի կամ այս նախագծին՝ մինչև տեղափոխվելը. ոչինչ չուղարկվեց։ --host-ով նշեք մեկ այլ պանակ։ Եթե այս պանակն ուրիշ ոչինչ չի օգտագործում, ջնջեք դրա միջի &apos;cluster/owner&apos;-ը։</translation>
    </message>
    <message>
      <source>This changed while a merge was being completed, so it was kept, but the catalogue has what was merged. Reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա փոխվել է միավորումն ավարտելու ընթացքում, ուստի պահպանվել է, բայց կատալոգում միավորվածն է։ Վերամշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տող</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դաշտ</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>արժեք</translation>
    </message>
    <message>
      <source>A sparse object of %1 points at x %2, y %3 mm was left out; if it is a sherd, photograph it closer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընդամենը %1 կետից կազմված առարկան x %2, y %3 մմ տեղում բաց է թողնվել. եթե բեկոր է, լուսանկարեք այն ավելի մոտիկից։</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs or scans of %3 belong to %4, too: its sherds would be in the catalogue twice. Nothing was entered. Set %3 aside and use %4, or keep both: 'Keep both' in the queue, 'ostraka catalogue enter --keep-both' on the command line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%3-ի %2 լուսանկարից կամ սկանից %1-ը պատկանում է նաև %4-ին. դրա բեկորները կատալոգում երկու անգամ կլինեին։ Ոչինչ չի մուտքագրվել։ %3-ը մի կողմ դրեք և օգտագործեք %4-ը, կամ պահեք երկուսը. «Պահել երկուսը» հերթում, 'ostraka catalogue enter --keep-both' հրամանի տողում։</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of %3, which this export holds, belong to %4, too: its sherds would be in the catalogue twice. Use %4 and leave the export out, or keep both on purpose (on the command line: --keep-both).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արտահանման մեջ եղած %3-ի %2 լուսանկարից %1-ը պատկանում է նաև %4-ին. դրա բեկորները կատալոգում երկու անգամ կլինեին։ Օգտագործեք %4-ը առանց այս արտահանման, կամ դիտմամբ պահեք երկուսը (հրամանի տողում՝ --keep-both)։</translation>
    </message>
    <message>
      <source>Another run is writing to this folder. What it has saved is kept, and this run has changed nothing; wait until the other one ends, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում գրում է մեկ այլ գործարկում։ Նրա պահպանածը մնում է, և այս գործարկումը ոչինչ չի փոխել. սպասեք մյուսի ավարտին կամ ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>The photographs do not tell the light from the sherds' own colours, so textures stay as photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարները թույլ չեն տալիս լույսը տարբերել բեկորների սեփական գույներից. հյուսվածքները մնում են այնպես, ինչպես լուսանկարված են։</translation>
    </message>
    <message>
      <source>Ostraka needs this folder for its own files, but it contains others. They are unchanged; move them elsewhere, then start again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka-ին այս պանակն անհրաժեշտ է իր սեփական ֆայլերի համար, բայց այն պարունակում է ուրիշ ֆայլեր։ Դրանք անփոփոխ են. տեղափոխեք դրանք այլ տեղ և նորից սկսեք։</translation>
    </message>
    <message>
      <source>This is not the location of a photograph, result, model or imported file, the only files that a catalogue lists. Nothing was changed; use a backup or another copy of the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սա լուսանկարի, արդյունքի, մոդելի կամ ներմուծված ֆայլի տեղ չէ, իսկ կատալոգը թվարկում է միայն դրանք։ Ոչինչ չի փոխվել. օգտագործեք պահուստային պատճենը կամ նախագծի մեկ այլ պատճեն։</translation>
    </message>
    <message>
      <source>The catalogue has earlier results of %1, and the batch is queued again. Enter the new ones with &apos;ostraka catalogue enter&apos;, or reprocess it in the window.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կատալոգում կան %1-ի ավելի վաղ արդյունքներ, և խմբաքանակը նորից հերթում է։ Նորերը գրանցեք &apos;ostraka catalogue enter&apos; հրամանով կամ խմբաքանակը նորից մշակեք պատուհանում։</translation>
    </message>
    <message>
      <source>The folder on the cluster has files that Ostraka did not write (%1): %2. They were left there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կլաստերի պանակում կան ֆայլեր, որոնք Ostraka-ն չի գրել (%1)՝ %2։ Դրանք մնացել են այնտեղ։</translation>
    </message>
    <message>
      <source>The output folder contains the results of other scans, or of these before a file was changed, renamed, added or removed; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Արդյունքների պանակում այլ սկանների կամ սրանց արդյունքներն են՝ նախքան որևէ ֆայլ կփոխվեր, կվերանվանվեր, կավելացվեր կամ կհեռացվեր. ընտրեք այլ պանակ։</translation>
    </message>
    <message>
      <source>The interval ends before it begins: %1 is earlier than %2; write the earlier date first, and years BC with a minus sign.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միջակայքն ավարտվում է սկսվելուց առաջ. %1-ը %2-ից վաղ է. նախ գրեք ավելի վաղ թվագրումը, իսկ մ. թ. ա. տարիները՝ մինուս նշանով։</translation>
    </message>
    <message>
      <source>The number %1 differs from the existing number %2 only in zeros, letter case or punctuation; check which one is meant.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարն առկա %2 համարից տարբերվում է միայն զրոներով, տառերի մեծությամբ կամ կետադրությամբ. ստուգեք, թե որն է նկատի առնված։</translation>
    </message>
    <message>
      <source>New numbers differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր համարներն առկա համարներից տարբերվում են միայն զրոներով, տառերի մեծությամբ կամ կետադրությամբ՝ %1. ստուգեք վրիպակները։</translation>
    </message>
    <message>
      <source>New contexts differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր համատեքստերն առկաներից տարբերվում են միայն զրոներով, տառերի մեծությամբ կամ կետադրությամբ՝ %1. ստուգեք վրիպակները։</translation>
    </message>
    <message>
      <source>A spreadsheet may have shortened these numbers or turned them into dates: %1; compare them with the labels and correct them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Աղյուսակային ծրագիրը հնարավոր է կրճատել է այս համարները կամ դարձրել ամսաթվեր՝ %1. համեմատեք դրանք պիտակների հետ և ուղղեք։</translation>
    </message>
    <message>
      <source>This file differs from what &apos;ostraka process&apos; wrote; run it again, which writes the file anew.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլը տարբերվում է նրանից, ինչ գրել է 'ostraka process'-ը. նորից գործարկեք, և ֆայլը կգրվի նորից։</translation>
    </message>
    <message>
      <source>The name of the file %1 is not UTF-8, and results could not tell it from others; rename it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ֆայլի անունը UTF-8 չէ, և արդյունքները չէին կարող այն տարբերել մյուսներից. վերանվանեք ֆայլը և նորից փորձեք։</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երեսի պիտանի լուսանկարներ՝ %1. անհրաժեշտ է առնվազն %2։ Բաց թողնված լուսանկարներ՝ %3. առաջինը՝ %4</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երեսի պիտանի լուսանկարներ՝ %1. անհրաժեշտ է առնվազն %2։ Բաց թողնված լուսանկարներ՝ %3. առաջինը՝ %4</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused; nothing was merged. Settle the conflict %2 with another number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 համարն արդեն տրվել է և երբեք չի վերօգտագործվում. ոչինչ չի միավորվել։ %2 հակասությունը լուծեք մեկ այլ համարով։</translation>
    </message>
    <message>
      <source>An entry of this file does not have the form {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} (or &quot;b&quot; or &quot;one&quot;, or &quot;number&quot; with a new number): %1; nothing was merged. Correct the entry.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս ֆայլի գրառումներից մեկը {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} ձևը չունի (կամ &quot;b&quot; կամ &quot;one&quot;, կամ &quot;number&quot;՝ նոր համարով)՝ %1. ոչինչ չի միավորվել։ Ուղղեք գրառումը։</translation>
    </message>
    <message>
      <source>The name of a place must not be empty; nothing was renamed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեղի անունը չի կարող դատարկ լինել. ոչինչ չի վերանվանվել։</translation>
    </message>
    <message>
      <source>Another place has the name %1 by now; nothing was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այժմ մեկ այլ տեղ ունի %1 անունը. ոչինչ չի հետարկվել։</translation>
    </message>
    <message>
      <source>This disk does not accept this name; rename the file, or use a folder on another disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս սկավառակը չի ընդունում այս անունը. վերանվանեք ֆայլը կամ օգտագործեք այլ սկավառակի պանակ։</translation>
    </message>
    <message>
      <source>A file of an earlier merge cannot be moved to its place, %1. Make it possible (move away what lies there, or copy the project to another disk), or delete the file; then merge again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ միավորման ֆայլը չի կարող տեղափոխվել իր տեղը՝ %1։ Հնարավոր դարձրեք դա (հեռացրեք այնտեղ եղածը կամ պատճենեք նախագիծը այլ սկավառակի վրա) կամ ջնջեք ֆայլը, ապա կրկին միավորեք։</translation>
    </message>
    <message>
      <source>It belongs to a merge and waits in %1; moving it to its place is tried again whenever the project is opened.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ֆայլը պատկանում է միավորմանը և սպասում է %1-ում. նախագիծը բացելիս ամեն անգամ կրկին փորձվում է այն տեղափոխել իր տեղը։</translation>
    </message>
    <message>
      <source>The block of numbers of this computer begins or ends with &apos;%1&apos;, but must be of whole numbers from 1 to %2; set it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս համակարգչի համարների շարքը սկսվում կամ ավարտվում է «%1»-ով, բայց պետք է լինի 1-ից %2 ամբողջ թվերից. սահմանեք այն կարգավորումներում։</translation>
    </message>
    <message>
      <source>Photographs of %1 that these results were not made from: %2, the first is %3. Reprocess the batch to use them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի լուսանկարներ, որոնցից այս արդյունքները չեն ստացվել՝ %2, առաջինը՝ %3։ Դրանք օգտագործելու համար կրկին մշակեք խմբաքանակը։</translation>
    </message>
    <message>
      <source>These results do not say which photographs they were made from, so they are not entered; process %1 again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս արդյունքները չեն ասում, թե որ լուսանկարներից են ստացվել, ուստի չեն գրանցվում. կրկին մշակեք %1-ը։</translation>
    </message>
    <message>
      <source>The GLB beside this model has another shape, so it is that of another sherd or of an earlier run; put its own beside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս մոդելի կողքի GLB-ն այլ ձև ունի, ուրեմն այլ բեկորի կամ նախորդ մշակման է. կողքին դրեք նրա սեփականը։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ToolRow</name>
    <message>
        <source>More</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ավելին</translation>
    </message>
    <message>
        <source>More tools</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այլ գործիքներ</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, ստեղն %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ColumnTable</name>
    <message>
        <source>says nothing about the sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>բեկորի մասին ոչինչ չի ասում</translation>
    </message>
    <message>
        <source>only shown, never read</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>միայն ցուցադրվում է, երբեք չի կարդացվում</translation>
    </message>
    <message>
        <source>share of 1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>մաս 1-ից</translation>
    </message>
    <message>
        <source>unit guessed from the values; check it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>միավորը ենթադրվել է արժեքներից. ստուգեք այն</translation>
    </message>
    <message>
        <source>as in the last table with these columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ինչպես այս սյունակներով վերջին աղյուսակում</translation>
    </message>
    <message>
        <source>chosen by you</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>ընտրված է ձեր կողմից</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Աղյուսակի սյունակները</translation>
    </message>
    <message>
        <source>column</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>սյունակ</translation>
    </message>
    <message>
        <source>field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>դաշտ</translation>
    </message>
    <message>
        <source>unit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>միավոր</translation>
    </message>
    <message>
        <source>first values</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>առաջին արժեքները</translation>
    </message>
    <message>
        <source>why</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>պատճառը</translation>
    </message>
    <message>
        <source>Field of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 սյունակի դաշտը</translation>
    </message>
    <message>
        <source>Unit of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 սյունակի միավորը</translation>
    </message>
    <message>
        <source>skip</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>բաց թողնել</translation>
    </message>
    <message>
        <source>custom field: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>սեփական դաշտ՝ %1</translation>
    </message>
    <message>
        <source>no field of this name; kept as a custom field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>այս անունով դաշտ չկա. պահվում է որպես սեփական դաշտ</translation>
    </message>
    <message>
      <source>proposed by its heading</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>առաջարկված է ըստ վերնագրի</translation>
    </message>
</context>
<context>
    <name>ImportSides</name>
    <message>
      <source>Drop either folders or photographs, not both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գցեք կա՛մ պանակներ, կա՛մ լուսանկարներ, ոչ երկուսը միասին։</translation>
    </message>
    <message>
      <source>These are more than two folders; drop that of the fronts and that of the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Սրանք երկուսից ավելի պանակներ են. գցեք առջևի երեսներինը և հետևի երեսներինը։</translation>
    </message>
    <message>
      <source>There are no photographs in this folder; choose one that holds them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում լուսանկարներ չկան. ընտրեք մեկը, որտեղ դրանք կան։</translation>
    </message>
    <message>
      <source>This folder contains several folders with photographs (%1); drop the two of one batch, front and back, onto this page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակում լուսանկարներով մի քանի պանակ կա (%1). գցեք մեկ խմբաքանակի երկուսը՝ առջևի և հետևի երեսները, այս էջի վրա։</translation>
    </message>
    <message>
      <source>The photographs of this folder are those of the front already; choose another folder for the back, or divide the series with the slider.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս պանակի լուսանկարներն արդեն առջևի երեսինն են. հետևի երեսի համար ընտրեք այլ պանակ կամ սահիչով բաժանեք շարքը։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportChooser</name>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>front/ և back/ սկաններով պանակ</translation>
    </message>
    <message>
      <source>Folder of a batch, or with photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակի կամ լուսանկարներով պանակ</translation>
    </message>
    <message>
      <source>Folder of the back photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դարձերեսի լուսանկարների պանակ</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SidesView</name>
    <message>
      <source>One side only</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միայն մեկ երես</translation>
    </message>
    <message>
      <source>Swap sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փոխել երեսները</translation>
    </message>
    <message>
      <source>First photograph of the second side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկրորդ երեսի առաջին լուսանկարը</translation>
    </message>
    <message>
      <source>Choose sheet…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել թերթ…</translation>
    </message>
    <message>
      <source>Clear sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հեռացնել թերթը</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s &amp;black square</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչի &amp;սև քառակուսու կողմը</translation>
    </message>
    <message>
      <source>Unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անհայտ</translation>
    </message>
    <message>
      <source> mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation> mm</translation>
    </message>
    <message>
      <source>The sheet will be found in the photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թերթը կգտնվի լուսանկարներում։</translation>
    </message>
    <message>
      <source>No sheet file (plate.json) and no marker size: the result has no scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ո՛չ թերթի ֆայլ (plate.json), ո՛չ նշիչի չափ. արդյունքը մասշտաբ չունի։</translation>
    </message>
    <message>
      <source>Sheet under the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թերթը բեկորների տակ</translation>
    </message>
    <message>
      <source>Sheet (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թերթ (*.json)</translation>
    </message>
    <message>
      <source>Front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առջևի երես</translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետևի երես</translation>
    </message>
    <message>
      <source>The series is divided where the sherds were turned over.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Շարքը բաժանված է այնտեղ, որտեղ բեկորները շրջվել են։</translation>
    </message>
    <message>
      <source>Sheet: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Թերթ՝ %1</translation>
    </message>
    <message>
      <source>%1: none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1՝ չկա</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n photograph(s), %2 to %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1՝ %n լուսանկար, %2-ից %3</numerusform>
        <numerusform>%1՝ %n լուսանկար, %2-ից %3</numerusform>
      </translation>
    </message>
    <message>
      <source>The marker size is proposed from the last import: check it with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչների չափն առաջարկված է վերջին ներմուծումից. ստուգեք քանոնով։</translation>
    </message>
    <message>
      <source>Choose back folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել դարձերեսների պանակը…</translation>
    </message>
    <message>
      <source>A folder that holds both sides is split where the sherds were turned over; the folder of the back photographs replaces the split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու երեսները պարունակող պանակը բաժանվում է այնտեղ, որտեղ բեկորները շրջվել են. դարձերեսների պանակը փոխարինում է այդ բաժանումը</translation>
    </message>
    <message>
      <source>No pause stands out between the photographs. Where the two pictures beside the division show the sherds before and after they were turned over, divide here; else move the slider, or choose the folder of the back photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Լուսանկարների միջև ընդմիջում չի երևում։ Եթե բաժանման կողքի երկու նկարները ցույց են տալիս բեկորները շրջելուց առաջ և հետո, բաժանեք այստեղ. այլապես տեղափոխեք սահիչը կամ ընտրեք հետևի երեսի լուսանկարների պանակը։</translation>
    </message>
    <message>
      <source>Divide here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաժանել այստեղ</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueRepair</name>
    <message>
        <source>It is whole; nothing was changed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այն ամբողջական է. ոչինչ չի փոխվել։</translation>
    </message>
    <message>
        <source>Nothing in the damaged file could be read: it is that of %1 again. Look what is missing since.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վնասված ֆայլում ոչինչ հնարավոր չեղավ կարդալ. կրկին գործում է %1-ը։ Նայեք, թե ինչ է պակասում այդ ժամանակից։</translation>
    </message>
    <message>
        <source>An earlier repair was interrupted and is now finished. Check the catalogue for missing changes.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նախորդ վերականգնումն ընդհատվել էր և այժմ ավարտված է։ Ստուգեք՝ արդյոք կատալոգում փոփոխություններ չեն պակասում։</translation>
    </message>
    <message>
        <source>Everything in it is as it was.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նրանում ամեն ինչ այնպես է, ինչպես եղել է։</translation>
    </message>
    <message>
        <source>All %1 rows stand in %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բոլոր %1 տողերը %2-ում են։</translation>
    </message>
    <message>
        <source>The damaged file is kept: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Վնասված ֆայլը պահված է՝ %1</translation>
    </message>
    <message>
        <source>Another window has this project open: close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Այս նախագիծը բաց է մեկ այլ պատուհանում. փակեք այն այնտեղ, ապա վերականգնեք։</translation>
    </message>
    <message>
        <source>The catalogue is being repaired …</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կատալոգը վերականգնվում է …</translation>
    </message>
    <message>
        <source>The catalogue could not be repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կատալոգը հնարավոր չեղավ վերականգնել։</translation>
    </message>
    <message>
        <source>The catalogue is repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Կատալոգը վերականգնված է։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeDialog</name>
    <message>
      <source>Merge another project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միավորել այլ նախագիծ</translation>
    </message>
    <message>
      <source>Conflicts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հակասություններ</translation>
    </message>
    <message>
      <source>Record</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գրառում</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դաշտ</translation>
    </message>
    <message>
      <source>This project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծը</translation>
    </message>
    <message>
      <source>Other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մյուս նախագիծը</translation>
    </message>
    <message>
      <source>Decision</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Որոշում</translation>
    </message>
    <message>
      <source>New number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր համար</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հետարկել</translation>
    </message>
    <message>
      <source>All open ones: this project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բոլոր բացերը՝ այս նախագիծը</translation>
    </message>
    <message>
      <source>Choose project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրել նախագիծ …</translation>
    </message>
    <message>
      <source>Progress of the merge</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միավորման ընթացքը</translation>
    </message>
    <message>
      <source>Folder of the other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մյուս նախագծի պանակը</translation>
    </message>
    <message>
      <source>New number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր համար %1</translation>
    </message>
    <message>
      <source>Open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց</translation>
    </message>
    <message>
      <source>What the other project holds comes into this one; the other one is only read. Nothing changes before you merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այն, ինչ պարունակում է մյուս նախագիծը, գալիս է այս նախագիծ. մյուսը միայն կարդացվում է։ Մինչև միավորելը ոչինչ չի փոխվում։</translation>
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
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկել</translation>
    </message>
    <message numerus="yes">
      <source>%n conflict(s) to settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n հակասություն լուծելու</numerusform>
        <numerusform>%n հակասություն լուծելու</numerusform>
      </translation>
    </message>
    <message>
      <source>Merge project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միավորել նախագիծը</translation>
    </message>
    <message>
      <source>New number:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր համար՝</translation>
    </message>
    <message>
      <source>New number of the record that does not keep it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համարը չպահող գրառման նոր համարը</translation>
    </message>
    <message>
      <source>Sherds with a new number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նոր համարով բեկորներ</translation>
    </message>
    <message>
      <source>Copy list</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պատճենել ցանկը</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու բեկոր․ այս նախագծինը պահում է համարը, մյուսը ստանում է %1</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու բեկոր․ այս նախագծինը պահում է համարը, մյուսը ստանում է նորը</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու բեկոր․ մյուսը պահում է համարը, այս նախագծինը ստանում է %1</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու բեկոր․ մյուսը պահում է համարը, այս նախագծինը ստանում է նորը</translation>
    </message>
    <message>
      <source>One sherd: both records become one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ բեկոր․ երկու գրառումը դառնում են մեկը</translation>
    </message>
    <message>
      <source>Open; new number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բաց․ նոր համար՝ %1</translation>
    </message>
    <message>
      <source>One sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մեկ բեկոր</translation>
    </message>
    <message>
      <source>This project; the other sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծը. մյուս բեկորը՝ %1</translation>
    </message>
    <message>
      <source>Other project; this sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մյուս նախագիծը. այս բեկորը՝ %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeModel</name>
    <message>
      <source>Sherds: %1. Batches: %2. Changed records: %3. Files: %4 (%5).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորներ՝ %1։ Խմբաքանակներ՝ %2։ Փոխված գրառումներ՝ %3։ Ֆայլեր՝ %4 (%5)։</translation>
    </message>
    <message>
      <source>Comparing…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համեմատում …</translation>
    </message>
    <message>
      <source>Merged %1. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միավորվեց %1։ %2</translation>
    </message>
    <message>
      <source>This project already has everything that the other one holds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս նախագիծն արդեն ունի այն ամենը, ինչ պարունակում է մյուսը։</translation>
    </message>
    <message>
      <source>Batches that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակներ, որոնք այստեղ այլ համար են ստանում՝ %1</translation>
    </message>
    <message>
      <source>Sherds that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորներ, որոնք այստեղ այլ համար են ստանում՝ %1</translation>
    </message>
    <message numerus="yes">
      <source>Missing in the other project: %n file(s), %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Մյուս նախագծում պակասում է %n ֆայլ՝ %1</numerusform>
        <numerusform>Մյուս նախագծում պակասում է %n ֆայլ՝ %1</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չեղարկված է. ոչինչ չի միավորվել։</translation>
    </message>
    <message>
      <source>Nothing was merged yet: what you chose leads to further conflicts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Դեռ ոչինչ չի միավորվել. ձեր ընտրածը հանգեցնում է նոր հակասությունների։</translation>
    </message>
    <message>
      <source>An earlier merge was interrupted and could not be completed here: %1. What lies there is kept; the other project&apos;s version was left out, or waits in the folder merge.partial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախորդ միավորումն ընդհատվել է և այստեղ չի կարողացել ավարտվել՝ %1։ Այնտեղ եղածը պահպանվում է. մյուս նախագծի տարբերակը բաց է թողնվել կամ սպասում է merge.partial պանակում։</translation>
    </message>
</context>
<context>
    <name>Verdicts</name>
    <message>
      <source>accepted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ընդունված</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մերժված</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մի կողմ դրված</translation>
    </message>
    <message>
      <source>to be photographed again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>վերալուսանկարելու</translation>
    </message>
    <message>
      <source>merged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>միավորված</translation>
    </message>
    <message>
      <source>split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>բաժանված</translation>
    </message>
    <message>
      <source>withdrawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>հետ վերցված</translation>
    </message>
    <message>
      <source>pair of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի զույգը</translation>
    </message>
    <message>
      <source>fragments: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>կտորներ՝ %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateScreen</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Խմբաքանակ</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NoBatchYet</name>
    <message>
        <source>Capture a batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Նկարել խմբաքանակ</translation>
    </message>
    <message>
      <source>Show the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ցույց տալ հերթը</translation>
    </message>
    <message>
      <source>%1 is in the queue; its results appear here when it is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը հերթում է. արդյունքները կհայտնվեն այստեղ, երբ այն մշակվի։</translation>
    </message>
    <message>
      <source>%1 could not be processed; the queue says why.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը հնարավոր չեղավ մշակել. հերթն ասում է՝ ինչու։</translation>
    </message>
</context>
<context>
    <name>Outside</name>
    <message>
      <source>No program was found that opens %1. It is there: open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ը բացող ծրագիր չգտնվեց։ Այն տեղում է. բացեք ձեռքով։</translation>
    </message>
    <message>
      <source>Opening %1. If it does not appear, open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բացվում է %1։ Եթե չերևա, բացեք ձեռքով։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MarkerSide</name>
    <message>
      <source>Marker side of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի նշիչի կողմը</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s black square, mm. The batch is reprocessed with this size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նշիչի սև քառակուսու կողմը, մմ։ Խմբաքանակը նորից մշակվում է այս չափով։</translation>
    </message>
    <message>
      <source>marker side typed anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>նշիչի կողմը նորից մուտքագրվեց</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PrintSheetButton</name>
    <message>
        <source>Print a sheet…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Տպել թերթ…</translation>
    </message>
    <message>
        <source>Markers around the sherds give photographs taken by hand their scale</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Բեկորների շուրջի նշիչները ձեռքից արված լուսանկարներին մասշտաբ են տալիս</translation>
    </message>
    <message>
        <source>Print it at 100 %, not fitted to the page, and measure the bar of the second page: it must be %1 mm long. The next import proposes this sheet. If the bar is not %1 mm long, choose Clear sheet there and type the measured side of a black square.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Տպեք այն 100 % չափով՝ առանց էջին հարմարեցնելու, և չափեք երկրորդ էջի գիծը․ այն պետք է լինի %1 մմ։ Հաջորդ ներմուծումն առաջարկում է այս թերթը։ Եթե գիծը %1 մմ չէ, այնտեղ ընտրեք «Հեռացնել թերթը» և մուտքագրեք սև քառակուսու չափված կողմը։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SurfaceChoice</name>
    <message>
      <source>Shaded form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ստվերագծված ձև</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ներկով և անգոբով</translation>
    </message>
    <message>
      <source>Orthophoto, %1 dpi</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Օրթոլուսանկար, %1 dpi</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectCare</name>
    <message numerus="yes">
      <source>%n file(s) of this project are missing or were changed, first %1. Put them back from a copy; &apos;ostraka catalogue check&apos; lists all of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Այս նախագծի %n ֆայլ բացակայում է կամ փոխվել է՝ %1։ Վերականգնեք այն պատճենից. «ostraka catalogue check»-ը նշում է այն։</numerusform>
        <numerusform>Այս նախագծի %n ֆայլ բացակայում է կամ փոխվել է, առաջինը՝ %1։ Վերականգնեք դրանք պատճենից. «ostraka catalogue check»-ը նշում է բոլորը։</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MunsellLine</name>
    <message>
      <source>Rough: no usable colour chart in these photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոտավոր՝ այս լուսանկարներում պիտանի գունային քարտ չկա։</translation>
    </message>
    <message>
      <source>Measured by the colour chart (Delta E 2000: median %1, 95 % %2).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափված է գունային քարտով (Delta E 2000՝ միջնարժեք %1, 95 % %2)։</translation>
    </message>
    <message>
      <source>Take over</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընդունել</translation>
    </message>
    <message>
      <source>Proposed: %1 (Delta E 2000: %2), then %3 (%4). %5</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առաջարկ՝ %1 (Delta E 2000՝ %2), ապա %3 (%4)։ %5</translation>
    </message>
    <message>
      <source>Take over %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընդունել %1</translation>
    </message>
    <message>
      <source>Of the side that was photographed first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Առաջինը լուսանկարված կողմի։</translation>
    </message>
    <message>
      <source>Of the side that was photographed second.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկրորդը լուսանկարված կողմի։</translation>
    </message>
    <message>
      <source>Measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Չափված։</translation>
    </message>
    <message>
      <source>No colours proposed: the model has no texture from photographs, or an earlier version of the program made it. Reprocess its batch to get proposals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Գույներ չեն առաջարկվում. մոդելը լուսանկարներից հյուսվածք չունի, կամ այն ստեղծել է ծրագրի ավելի վաղ տարբերակը։ Առաջարկներ ստանալու համար վերամշակեք դրա խմբաքանակը։</translation>
    </message>
    <message>
      <source>Rough estimate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Մոտավոր գնահատական։</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CompareWindow</name>
    <message>
      <source>only one entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>մուտքագրված է միայն մեկի համար</translation>
    </message>
    <message>
      <source>differs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տարբերվում է</translation>
    </message>
    <message>
      <source>differs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տարբերվում է՝ %1</translation>
    </message>
    <message>
      <source>%1, within the uncertainty</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, անորոշության սահմաններում</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message>
      <source>Compare sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Համեմատել բեկորները</translation>
    </message>
    <message>
      <source>Turn &amp;together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Պտտել &amp;միասին</translation>
    </message>
    <message>
      <source>Off: each sherd is turned alone, until both lie alike. The scale stays the same.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Անջատված. յուրաքանչյուր բեկոր պտտվում է առանձին, մինչև երկուսն էլ նույն դիրքն ունենան։ Մասշտաբը մնում է նույնը։</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Կտրվածք</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերևից</translation>
    </message>
    <message>
      <source>Fields and measurements of both sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկու բեկորների դաշտերն ու չափերը</translation>
    </message>
    <message>
      <source>Model of %1; the arrow keys turn it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի մոդելը. սլաքների ստեղները պտտում են այն</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>դաշտ</translation>
    </message>
    <message>
      <source>difference</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>տարբերություն</translation>
    </message>
    <message numerus="yes">
      <source>%n field(s) differ.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%n դաշտ տարբերվում է։</numerusform>
            <numerusform>%n դաշտ տարբերվում է։</numerusform>
        </translation>
    </message>
    <message>
      <source>The two are recorded as joining.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Երկուսը գրանցված են որպես իրար կցվող։</translation>
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
      <translation>Վերանվանել տեղերը</translation>
    </message>
    <message>
      <source>Choose the place that was typed wrongly and enter its right name. If that place exists already, both become one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ընտրեք սխալ գրված տեղը և մուտքագրեք դրա ճիշտ անունը։ Եթե այդ տեղն արդեն կա, երկուսը դառնում են մեկը։</translation>
    </message>
    <message>
      <source>Places of the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Նախագծի տեղերը</translation>
    </message>
    <message>
      <source>Place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեղ</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Բեկորներ</translation>
    </message>
    <message>
      <source>Right name of the place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Տեղի ճիշտ անունը</translation>
    </message>
    <message>
      <source>Rename</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերանվանել</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Փակել</translation>
    </message>
    <message>
      <source>Right &amp;name:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ճիշտ &amp;անուն՝</translation>
    </message>
    <message numerus="yes">
      <source>%n context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n համատեքստ</numerusform>
        <numerusform>%n համատեքստ</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n bag(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n տոպրակ</numerusform>
        <numerusform>%n տոպրակ</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n խմբաքանակ</numerusform>
        <numerusform>%n խմբաքանակ</numerusform>
      </translation>
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
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ոչինչ</translation>
    </message>
    <message>
      <source>%1 exists already. Join with it? What is in %2 comes to %1: %3. %1 keeps its own description, and %2 is not listed any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ն արդեն կա։ Միացնե՞լ դրա հետ։ Ինչ կա %2-ում, անցնում է %1-ին՝ %3։ %1-ը պահում է իր նկարագրությունը, իսկ %2-ն այլևս ցանկում չէ։</translation>
    </message>
    <message>
      <source>In this place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Այս տեղում՝ %1։</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep the number that is written on them; new numbers go on behind these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n բեկոր պահում է իր վրա գրված համարը. նոր համարները շարունակվում են դրանից հետո։</numerusform>
        <numerusform>%n բեկոր պահում են իրենց վրա գրված համարները. նոր համարները շարունակվում են դրանցից հետո։</numerusform>
      </translation>
    </message>
    <message>
      <source>Join places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միացնել տեղերը</translation>
    </message>
    <message>
      <source>join %1 with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի միացում %2-ի հետ</translation>
    </message>
    <message>
      <source>rename %1 to %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1-ի վերանվանում՝ %2</translation>
    </message>
    <message>
      <source>Joined: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Միացված է. %1-ն այժմ %2 է։</translation>
    </message>
    <message>
      <source>Renamed: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Վերանվանված է. %1-ն այժմ %2 է։</translation>
    </message>
    <message>
      <source>A site gets another code in the settings, under Open project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Հուշարձանը այլ ծածկագիր է ստանում կարգավորումներում՝ «Բաց նախագիծ» բաժնում։</translation>
    </message>
</context>
</TS>
