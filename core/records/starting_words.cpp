#include "records/starting_words.h"

namespace ostraka::records {
namespace {

struct Words {
  const char *term, *de, *el, *es, *fr, *hy, *tr;
};

Term termOf(const Words& w) {
  return {w.term,
          {{"de", w.de}, {"el", w.el}, {"es", w.es}, {"fr", w.fr}, {"hy", w.hy}, {"tr", w.tr}},
          {}};
}

StartingVocabulary vocabulary(const char* name, const std::vector<Words>& words) {
  StartingVocabulary made{name, {}};
  for (const Words& one : words) made.terms.push_back(termOf(one));
  return made;
}

}  // namespace

// No speaker has reviewed the words in other languages yet.
const std::vector<StartingVocabulary>& startingVocabularies() {
  static const std::vector<StartingVocabulary> all = {
      vocabulary(
          "part",
          {
              {"rim", "Rand", "χείλος", "borde", "bord", "շուրթ", "ağız kenarı"},
              {"neck", "Hals", "λαιμός", "cuello", "col", "վիզ", "boyun"},
              {"shoulder", "Schulter", "ώμος", "hombro", "épaule", "ուս", "omuz"},
              {"body", "Wandung", "σώμα", "pared", "panse", "իրան", "gövde"},
              {"base", "Boden", "βάση", "base", "fond", "հատակ", "dip"},
              {"handle", "Henkel", "λαβή", "asa", "anse", "կանթ", "kulp"},
              {"spout", "Ausguss", "προχοή", "vertedor", "bec verseur", "ծորակ", "emzik"},
              {"lid", "Deckel", "πώμα", "tapadera", "couvercle", "կափարիչ", "kapak"},
              {"profile", "ganzes Profil", "πλήρες προφίλ", "perfil completo", "profil complet",
               "ամբողջական կտրվածք", "tam profil"},
              {"whole", "ganz", "ακέραιο", "entero", "entier", "ամբողջական", "bütün"},
              {"unknown", "unbekannt", "άγνωστο", "desconocido", "inconnu", "անհայտ", "bilinmiyor"},
          }),
      vocabulary(
          "surface",
          {
              {"plain", "unbehandelt", "απλή", "sin tratar", "brute", "պարզ", "işlemsiz"},
              {"smoothed", "geglättet", "λειασμένη", "alisada", "lissée", "հարթեցված",
               "düzeltilmiş"},
              {"burnished", "poliert", "στιλβωμένη", "bruñida", "polie", "փայլեցված", "perdahlı"},
              {"slipped", "engobiert", "με επίχρισμα", "engobada", "engobée", "անգոբապատ",
               "astarlı"},
              {"washed", "dünn engobiert", "με αραιό επίχρισμα", "con aguada", "badigeonnée",
               "բարակ անգոբով", "ince astarlı"},
              {"glazed", "glasiert", "εφυαλωμένη", "vidriada", "glaçurée", "ջնարակված", "sırlı"},
              {"painted", "bemalt", "γραπτή", "pintada", "peinte", "ներկված", "boyalı"},
          }),
      vocabulary(
          "decoration",
          {
              {"none", "keine", "καμία", "ninguna", "aucun", "չկա", "yok"},
              {"incised", "geritzt", "εγχάρακτη", "incisa", "incisé", "փորագիր", "kazıma"},
              {"impressed", "eingedrückt", "εμπίεστη", "impresa", "imprimé", "սեղմված", "baskı"},
              {"stamped", "gestempelt", "σφραγιστή", "estampillada", "estampé", "դրոշմված",
               "damgalı"},
              {"applied", "aufgelegt", "επίθετη", "aplicada", "appliqué", "վրադիր", "aplike"},
              {"painted", "bemalt", "γραπτή", "pintada", "peint", "ներկված", "boyalı"},
              {"combed", "Kammstrich", "χτενιστή", "peinada", "peigné", "սանրազարդ", "taraklı"},
          }),
      vocabulary(
          "manufacture",
          {
              {"hand", "handgeformt", "χειροποίητο", "a mano", "à la main", "ձեռածեփ", "el yapımı"},
              {"coil", "Wulsttechnik", "με κουλούρες", "de rollos", "au colombin", "գալարային",
               "fitil"},
              {"mould", "in der Form", "με μήτρα", "a molde", "au moule", "կաղապարով", "kalıp"},
              {"wheel", "Drehscheibe", "τροχήλατο", "a torno", "au tour", "դուրգով", "çark"},
              {"unknown", "unbekannt", "άγνωστο", "desconocido", "inconnu", "անհայտ", "bilinmiyor"},
          }),
      vocabulary("firing",
                 {
                     {"oxidised", "oxidierend", "οξειδωτική", "oxidante", "oxydante", "օքսիդացնող",
                      "oksitleyici"},
                     {"reduced", "reduzierend", "αναγωγική", "reductora", "réductrice",
                      "վերականգնող", "indirgeyici"},
                     {"mixed", "wechselnd", "μικτή", "mixta", "mixte", "խառը", "karışık"},
                 }),
      vocabulary("condition",
                 {
                     {"fresh", "frisch", "φρέσκια", "fresca", "frais", "թարմ", "taze"},
                     {"worn", "verrieben", "φθαρμένη", "rodada", "usé", "մաշված", "aşınmış"},
                     {"encrusted", "versintert", "με επικαθίσεις", "con concreciones",
                      "concrétionné", "նստվածքով", "kabuklanmış"},
                     {"burnt", "verbrannt", "καμένη", "quemada", "brûlé", "այրված", "yanmış"},
                     {"flaked", "abgeplatzt", "απολεπισμένη", "desconchada", "écaillé", "շերտատված",
                      "pul pul"},
                     {"repaired", "geflickt", "επισκευασμένη", "reparada", "réparé", "նորոգված",
                      "onarılmış"},
                 }),
  };
  return all;
}

}  // namespace ostraka::records
