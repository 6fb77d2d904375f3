#include "tables/column_names.h"

#include <algorithm>
#include <map>

#include "records/sherd.h"
#include "sherds/sherd_fields.h"
#include "store/names.h"

namespace ostraka::tables {
namespace {

struct Names {
  const char* field;
  const char* names;  ///< English, German, French, Spanish, Greek, Turkish, Armenian; by '|'
};

constexpr Names kOfSherds[] = {
    {"number",
     "number|no|nr|sherd|sherd number|sherd no|find number|find no|inventory number|inv no|"
     "catalogue number|cat "
     "no|Nummer|Fundnummer|Fund-Nr|Inventarnummer|Inv-Nr|Scherbe|Scherbennummer|"
     "Scherben-Nr|Kat-Nr|Katalognummer|numéro|nº|№|numéro d'inventaire|n° inv|numéro de tesson|"
     "tesson|n° tesson|número|núm|número de inventario|n.º inv|fragmento|αριθμός|αρ|αρ.|"
     "αριθμός ευρήματος|αριθμός οστράκου|αρ. ευρ|αρ. ευρετηρίου|όστρακο|numara|no.|envanter no|"
     "envanter numarası|buluntu no|parça no|համար|հ/հ|գույքահամար|բեկոր"},
    {"uuid",
     "uuid|identifier|id ostraka|Kennung|identifiant|identificador|ταυτότητα|kimlik|"
     "նույնացուցիչ"},
    {"void_reason",
     "void because|reason for voiding|reason voided|Grund der Ungültigkeit|ungültig, weil|raison "
     "de l’annulation|annulé parce que|motivo de la anulación|anulado porque|λόγος ακύρωσης|"
     "άκυρο επειδή|geçersiz sayma nedeni|geçersiz, çünkü|անվավեր ճանաչելու պատճառ|"
     "անվավեր է, քանի որ"},
    {"site",
     "site|site code|Fundort|Fundstelle|Grabung|chantier|yacimiento|sitio|θέση|ανασκαφή|"
     "alan|yerleşim|kazı yeri|հուշարձան|հնավայր"},
    {"trench",
     "trench|sector|Schnitt|Areal|Sektor|Quadrant|tranchée|secteur|carré|"
     "sondage|corte|cuadro|τομή|τετράγωνο|açma|plankare|խրամատ|քառակուսի"},
    {"context",
     "context|locus|stratigraphic unit|su|unit|layer|feature|Befund|Kontext|Schicht|"
     "Stelle|contexte|us|unité stratigraphique|couche|contexto|ue|unidad estratigráfica|"
     "estrato|πλαίσιο|στρώμα|στρωματογραφική μονάδα|kontekst|tabaka|birim|համատեքստ|շերտ"},
    {"bag",
     "bag|bag no|lot|box|Beutel|Tüte|Fundtüte|Fundzettel|sac|sachet|bolsa|σακούλα|σακουλάκι|"
     "torba|poşet|տոպրակ|տուփ"},
    {"part",
     "part|vessel part|sherd type|form part|Teil|Gefäßteil|Scherbenart|partie|"
     "partie du vase|parte|parte del vaso|μέρος|τμήμα|μέρος αγγείου|bölüm|kap bölümü|մաս|"
     "անոթի մաս"},
    {"ware",
     "ware|ware type|class|Ware|Warenart|Gattung|Keramikart|céramique|céramique (type)|"
     "catégorie|cerámica (tipo)|clase cerámica|κεραμική κατηγορία|κατηγορία|mal grubu|mal|"
     "խեցեղենի տեսակ"},
    {"fabric",
     "fabric|paste|clay|Scherbentyp|Ton|Fabric|Tonart|Scherben|pâte|argile|pasta|arcilla|"
     "πηλός|hamur|kil|կավազանգված|կավ"},
    {"inclusions",
     "inclusions|temper|Magerung|Einschlüsse|dégraissant|desgrasante|inclusiones|"
     "προσμίξεις|εγκλείσματα|katkı|katkılar|խառնուրդներ|խառնուրդ"},
    {"manufacture",
     "manufacture|forming|technique|Herstellung|Technik|Machart|façonnage|"
     "fabrication|manufactura|técnica|κατασκευή|τεχνική|yapım|yapım tekniği|"
     "պատրաստում"},
    {"firing", "firing|Brand|Brennart|cuisson|cocción|όπτηση|ψήσιμο|pişirim|pişirme|թրծում"},
    {"surface_out",
     "surface outside|outer surface|exterior surface|surface exterior|Oberfläche außen|"
     "Außenoberfläche|Außenseite|surface externe|surface extérieure|superficie exterior|"
     "εξωτερική επιφάνεια|dış yüzey|արտաքին մակերես"},
    {"surface_in",
     "surface inside|inner surface|interior surface|surface interior|Oberfläche innen|"
     "Innenoberfläche|Innenseite|surface interne|surface intérieure|superficie interior|"
     "εσωτερική επιφάνεια|iç yüzey|ներքին մակերես"},
    {"decoration",
     "decoration|decor|ornament|Verzierung|Dekor|décor|décoration|decoración|"
     "διακόσμηση|bezeme|süsleme|զարդ|զարդանախշ"},
    {"munsell_out",
     "munsell|munsell outside|munsell exterior|munsell out|colour outside|color outside|"
     "Munsell außen|Farbe außen|Munsell externe|couleur externe|color exterior|"
     "Munsell έξω|Munsell dış|dış renk|Munsell՝ դրսից"},
    {"munsell_in",
     "munsell inside|munsell interior|munsell in|colour inside|color inside|"
     "Munsell innen|Farbe innen|Munsell interne|couleur interne|color interior|"
     "Munsell μέσα|Munsell iç|iç renk|Munsell՝ ներսից"},
    {"munsell_core",
     "munsell core|core colour|core color|Munsell Kern|Farbe Kern|"
     "Farbe Bruch|Munsell cœur|couleur cœur|Munsell núcleo|color núcleo|"
     "Munsell πυρήνας|Munsell öz|Munsell՝ միջուկ"},
    {"condition",
     "condition|preservation|Erhaltung|Erhaltungszustand|Zustand|conservation|"
     "état de conservation|conservación|estado de conservación|διατήρηση|"
     "κατάσταση διατήρησης|korunma durumu|korunma|պահպանվածություն"},
    {"joins",
     "joins|joins with|passt an|Anpassung|Anpassungen|remonte avec|remontage|une con|"
     "συνανήκει με|birleştiği|կցվում է"},
    {"vessel", "vessel|vessel number|pot|Gefäß|Gefäßnummer|vase|vasija|recipiente|αγγείο|kap|անոթ"},
    {"period",
     "period|phase|Zeitstellung|Periode|Phase|Epoche|période|epoque|période|época|período|"
     "περίοδος|φάση|dönem|evre|շրջան|դարաշրջան"},
    {"date_edtf",
     "date|dating|Datierung|datation|datación|χρονολόγηση|χρονολογία|tarih|tarihleme|"
     "թվագրում"},
    {"length_mm",
     "length|max length|maximum length|max dimension|Länge|max Länge|"
     "größte Länge|longueur|long|longueur max|longitud|largo|longitud máxima|μήκος|"
     "μέγιστο μήκος|uzunluk|boy|en çok uzunluk|երկարություն"},
    {"width_mm",
     "width|breadth|max width|maximum width|Breite|max Breite|größte Breite|largeur|"
     "larg|largeur max|anchura|ancho|πλάτος|μέγιστο πλάτος|genişlik|en|լայնություն"},
    {"thickness_min_mm",
     "thickness least|minimum thickness|min thickness|thickness min|Wandstärke kleinste|"
     "Wandstärke min|Dicke min|kleinste Wandstärke|kleinste Dicke|min Dicke|minimale Wandstärke|"
     "épaisseur minimale|épaisseur min|grosor mínimo|grosor mín|espesor mínimo|πάχος ελάχιστο|"
     "ελάχιστο πάχος|en az kalınlık|en düşük kalınlık|նվազագույն հաստություն"},
    {"thickness_mean_mm",
     "thickness|wall thickness|mean thickness|wall|thickness mean|Dicke|Wandstärke|Wanddicke|"
     "Wandungsstärke|Scherbendicke|mittlere Wandstärke|Stärke|épaisseur|épaisseur moyenne|ép|"
     "épaisseur paroi|épaisseur de la paroi|grosor|espesor|grosor medio|grosor de la pared|πάχος|"
     "πάχος τοιχώματος|μέσο πάχος|kalınlık|cidar kalınlığı|et kalınlığı|ortalama kalınlık|"
     "հաստություն|պատի հաստություն"},
    {"thickness_max_mm",
     "thickness most|maximum thickness|max thickness|thickness max|Wandstärke größte|"
     "Wandstärke max|Dicke max|größte Wandstärke|größte Dicke|max Dicke|maximale Wandstärke|"
     "épaisseur maximale|épaisseur max|grosor máximo|grosor máx|espesor máximo|πάχος μέγιστο|"
     "μέγιστο πάχος|en çok kalınlık|en yüksek kalınlık|առավելագույն հաստություն"},
    {"rim_diameter_mm",
     "rim diameter|diameter|diam|orifice diameter|mouth diameter|Randdurchmesser|Durchmesser|"
     "Mündungsdurchmesser|Dm|Rand Dm|diamètre du bord|diamètre|diamètre ouverture|"
     "diamètre à l'ouverture|diámetro del borde|diámetro|diámetro de boca|διάμετρος χείλους|"
     "διάμετρος|ağız çapı|çap|շուրթի տրամագիծ|տրամագիծ"},
    {"rim_pct",
     "rim kept|rim percent|rim eve|eve|rim preserved|Rand erhalten|Randerhaltung|bord conservé|"
     "borde conservado|σωζόμενο χείλος|korunan ağız|շուրթի պահպանված մաս"},
    {"weight_g",
     "weight|mass|wt|Gewicht|Masse|Gew|poids|masse|peso|masa|βάρος|ağırlık|քաշ|զանգված|"
     "կշիռ"},
    {"note",
     "note|notes|remark|remarks|comment|comments|Bemerkung|Bemerkungen|"
     "Anmerkung|Notiz|Kommentar|remarque|remarques|commentaire|observations|"
     "nota|notas|observaciones|comentario|σημείωση|σημειώσεις|παρατηρήσεις|not|notlar|"
     "açıklama|նշում|նշումներ|ծանոթագրություն"}};

// What an export says besides; nothing of it is typed.
constexpr Names kOfExports[] = {
    {"batch", "batch|Durchgang|tanda|παρτίδα|parti|խմբաքանակ"},
    {"area_mm2",
     "area, mm²|Fläche, mm²|surface, mm²|área, mm²|εμβαδόν, mm²|alan, mm²|մակերես, mm²"},
    {"volume_mm3", "volume, mm³|Volumen, mm³|volumen, mm³|όγκος, mm³|hacim, mm³|ծավալ, mm³"},
    {"filled_pct",
     "unseen surface|nicht gesehene Fläche|surface non vue|superficie no vista|αθέατο|görülmeyen|"
     "չերևացած"},
    {"measured_by_hand",
     "measured by hand|von Hand gemessen|mesuré à la main|medido a mano|μετρημένα με το χέρι|"
     "elle ölçülen|ձեռքով չափված"},
    {"mass_centre_x_mm",
     "centre of mass x|Schwerpunkt x|centre de masse x|centro de masa x|κέντρο μάζας x|"
     "kütle merkezi x|զանգվածի կենտրոն x"},
    {"mass_centre_y_mm",
     "centre of mass y|Schwerpunkt y|centre de masse y|centro de masa y|κέντρο μάζας y|"
     "kütle merkezi y|զանգվածի կենտրոն y"},
    {"mass_centre_z_mm",
     "centre of mass z|Schwerpunkt z|centre de masse z|centro de masa z|κέντρο μάζας z|"
     "kütle merkezi z|զանգվածի կենտրոն z"},
    {"model_file",
     "model file|Modelldatei|fichier du modèle|archivo del modelo|αρχείο μοντέλου|model dosyası|"
     "մոդելի ֆայլ"},
    {"image_file",
     "picture file|Bilddatei|fichier de l'image|archivo de la imagen|αρχείο εικόνας|"
     "resim dosyası|պատկերի ֆայլ"},
    {"drawing_file",
     "drawing file|Zeichnungsdatei|fichier du dessin|archivo del dibujo|αρχείο σχεδίου|"
     "çizim dosyası|գծագրի ֆայլ"},
    {"licence", "licence|license|Lizenz|licencia|άδεια|lisans|արտոնագիր"}};

constexpr Names kOfContexts[] = {
    {"kind", "kind|kind of context|type|Art|Befundart|Typ|tipo|genre|είδος|τύπος|tür|տեսակ"},
    {"excavated_on",
     "excavated on|excavated|date excavated|excavation date|ausgegraben am|Grabungsdatum|"
     "date de fouille|fouillé le|fecha de excavación|excavado el|"
     "ημερομηνία ανασκαφής|kazı tarihi|պեղման օր"},
    {"closed",
     "closed|finished|abgeschlossen|fertig|fermé|terminé|cerrado|terminado|κλειστό|kapalı|"
     "փակ"},
    {"collected_on",
     "collected on|collected|gefüllt am|gesammelt am|collecté le|ramassé le|"
     "recogido el|συλλέχθηκε|toplama tarihi|հավաքման օր"},
    {"count_written",
     "count written|count|number of sherds|sherds written on the bag|Scherben laut Beutel|"
     "tessons indiqués sur le sac|fragmentos según la bolsa|όστρακα κατά τη σακούλα|"
     "torbada yazan parça sayısı|բեկորներ ըստ տոպրակի|Anzahl|Stückzahl|nombre|"
     "nombre de tessons|cantidad|número de fragmentos|πλήθος|αριθμός οστράκων|adet|"
     "sayı|քանակ"},
    {"storage",
     "storage|location|Lagerort|Lager|Magazin|Standort|dépôt|rangement|almacén|depósito|"
     "αποθήκη|depo|պահեստ"}};

// Fields of sherds that contexts have, too.
constexpr const char* kOfBoth[] = {"site",   "trench",    "context",  "bag",
                                   "period", "date_edtf", "weight_g", "note"};

using Dictionary = std::map<std::string, std::string>;

// Laenge for Länge, as many keyboards and old databases have it.
std::string withoutUmlauts(std::string name) {
  for (const auto& [letter, pair] :
       {std::pair("ä", "ae"), std::pair("ö", "oe"), std::pair("ü", "ue"), std::pair("ß", "ss")})
    for (std::size_t at = name.find(letter); at != std::string::npos; at = name.find(letter))
      name.replace(at, std::string_view(letter).size(), pair);
  return name;
}

void add(Dictionary& dictionary, const Names& one) {
  std::string_view rest = one.names;
  dictionary.emplace(store::plainKey(one.field), one.field);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    const std::string name(rest.substr(0, end));
    for (const std::string& key : {store::plainKey(name), store::plainKey(withoutUmlauts(name))})
      if (!key.empty()) dictionary.emplace(key, one.field);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

const Dictionary& dictionaryOf(bool contexts) {
  static const Dictionary of_sherds = [] {
    Dictionary all;
    for (const records::SherdField& field : sherds::sherdFields())
      all.emplace(store::plainKey(field.name), field.name);
    for (const Names& one : kOfSherds) add(all, one);
    for (const Names& one : kOfExports) add(all, one);
    return all;
  }();
  static const Dictionary of_contexts = [] {
    Dictionary all;
    for (const Names& one : kOfContexts) add(all, one);
    for (const Names& one : kOfSherds)
      if (std::find(std::begin(kOfBoth), std::end(kOfBoth), std::string(one.field)) !=
          std::end(kOfBoth))
        add(all, one);
    return all;
  }();
  return contexts ? of_contexts : of_sherds;
}

// Its end is where the unit stands.
constexpr std::string_view kSeparators = " _-([{,;/.:\t";

std::string withoutMarks(std::string text) {
  const auto mark = [](char c) { return kSeparators.find(c) != std::string_view::npos; };
  while (!text.empty() && mark(text.back())) text.pop_back();
  return text;
}

}  // namespace

std::string fieldOfColumn(std::string_view column, bool of_contexts) {
  const Dictionary& dictionary = dictionaryOf(of_contexts);
  const auto found = dictionary.find(store::plainKey(column));
  return found == dictionary.end() ? std::string() : found->second;
}

std::string unitNamed(std::string_view text) {
  const std::string typed = store::trimmed(text);
  if (typed == "%") return typed;
  const char* const kShare = "share";  // eve: estimated vessel equivalents; a whole rim is 1
  static const std::map<std::string, std::string> kUnits = {
      {"mm", "mm"},      {"millimetre", "mm"}, {"millimeter", "mm"}, {"millimetres", "mm"},
      {"cm", "cm"},      {"centimetre", "cm"}, {"zentimeter", "cm"}, {"centimeter", "cm"},
      {"m", "m"},        {"g", "g"},           {"gr", "g"},          {"gram", "g"},
      {"grams", "g"},    {"gramm", "g"},       {"kg", "kg"},         {"kilo", "kg"},
      {"mg", "mg"},      {"pct", "%"},         {"percent", "%"},     {"prozent", "%"},
      {"χλστ", "mm"},    {"χιλ", "mm"},        {"εκ", "cm"},         {"γρ", "g"},
      {"χγρ", "kg"},     {"κιλα", "kg"},       {"մմ", "mm"},         {"սմ", "cm"},
      {"գ", "g"},        {"գր", "g"},          {"կգ", "kg"},         {"мм", "mm"},
      {"см", "cm"},      {"г", "g"},           {"кг", "kg"},         {"eve", kShare},
      {"share", kShare}, {"anteil", kShare}};
  const auto found = kUnits.find(store::plainKey(typed));
  return found == kUnits.end() ? std::string() : found->second;
}

NameAndUnit nameAndUnit(const std::string& column) {
  std::string text = store::trimmed(column);
  while (!text.empty() && std::string_view(")]}.").find(text.back()) != std::string_view::npos)
    text.pop_back();
  const std::size_t before = text.find_last_of(kSeparators);
  if (before == std::string::npos) return {column, unitNamed(text)};
  const std::string unit = unitNamed(text.substr(before + 1));
  std::string name = withoutMarks(text.substr(0, before));
  if (unit.empty() || name.empty()) return {column, {}};
  for (const char* joint : {" in", " en", " σε"})
    if (name.ends_with(joint)) name.resize(name.size() - std::string_view(joint).size());
  return {withoutMarks(name), unit};
}

NameAndUnit fieldAndUnit(const std::string& heading, bool of_contexts) {
  const NameAndUnit parts = nameAndUnit(heading);
  const std::string field = fieldOfColumn(heading, of_contexts);
  if (parts.unit.empty() || field == heading) return {field, {}};
  const std::string without = fieldOfColumn(parts.name, of_contexts);
  const std::vector<std::string> units = unitsOf(without);
  if (std::find(units.begin(), units.end(), parts.unit) == units.end()) return {field, {}};
  return {without, parts.unit};
}

std::string headingOf(const std::string& field, const std::string& words, bool of_contexts) {
  const NameAndUnit read = fieldAndUnit(words, of_contexts);
  const std::vector<std::string> units = unitsOf(field);
  const bool own = units.empty() || read.unit == units.front();
  return read.name == field && own ? words : field;
}

NameAndUnit valueAndUnit(const std::string& value) {
  NameAndUnit number{store::trimmed(value), {}};
  const std::size_t last = number.name.find_last_of("0123456789");
  if (last == std::string::npos) return number;
  number.unit = unitNamed(std::string_view(number.name).substr(last + 1));
  if (!number.unit.empty()) number.name.resize(last + 1);
  return number;
}

std::vector<std::string> unitsOf(const std::string& field) {
  if (field.ends_with("_mm")) return {"mm", "cm", "m"};
  if (field.ends_with("_g")) return {"g", "kg", "mg"};
  if (field.ends_with("_pct")) return {"%", "share"};
  return {};
}

int tensBetween(const std::string& unit, const std::string& field) {
  static const std::map<std::string, int> kTens = {{"mm", 0}, {"cm", 1},  {"m", 3}, {"g", 0},
                                                   {"kg", 3}, {"mg", -3}, {"%", 0}, {"share", 2}};
  const auto found = kTens.find(unit);
  return found == kTens.end() || unitsOf(field).empty() ? 0 : found->second;
}

}  // namespace ostraka::tables
