#include "metadata/vocabularies.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "catalogue/settings.h"
#include "metadata/json_fields.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherd_fields.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::metadata {

using namespace catalogue;
using nlohmann::json;
using nlohmann::ordered_json;

Result<ordered_json> vocabulariesJson(const Catalogue& catalogue,
                                      const std::vector<records::SherdRecord>& sherds) {
  std::map<std::string, std::set<std::string>> used;
  for (const records::SherdField& field : sherds::sherdFields())
    if (*field.vocabulary)
      for (const records::SherdRecord& sherd : sherds)
        for (const std::string& term : store::splitTerms(sherds::textOf(sherd, field.name)))
          used[field.vocabulary].insert(term);
  ordered_json all = ordered_json::object();
  for (const auto& [name, terms] : used) {
    const Result<std::vector<records::Term>> known = Settings(catalogue).vocabulary(name);
    if (!known) return known.error();
    ordered_json list = ordered_json::array();
    for (const records::Term& term : *known) {
      if (!terms.contains(term.term)) continue;
      ordered_json one = {{"term", term.term}};
      if (!term.labels.empty()) one["labels"] = term.labels;
      put(one, "uri", term.uri);
      list.push_back(std::move(one));
    }
    all[name] = std::move(list);
  }
  return ordered_json{{"vocabularies", all}};
}

Result<void> readVocabularies(Catalogue& catalogue, const json& vocabularies,
                              const records::Provenance& provenance) {
  for (const auto& [name, list] : vocabularies.at("vocabularies").items()) {
    Result<std::vector<records::Term>> terms = Settings(catalogue).vocabulary(name);
    if (!terms) return terms.error();
    std::set<std::string> known;
    for (const records::Term& term : *terms) {
      known.insert(store::uniqueKey(term.term));
      for (const auto& [language, label] : term.labels) known.insert(store::uniqueKey(label));
    }
    const std::size_t before = terms->size();
    for (const json& one : list) {
      records::Term term;
      term.term = one.at("term").get<std::string>();
      if (!known.insert(store::uniqueKey(term.term)).second) continue;
      if (one.contains("labels")) one.at("labels").get_to(term.labels);
      // A label that is another term's here would be taken for that one.
      std::erase_if(term.labels, [&](const auto& label) {
        return store::uniqueKey(label.second) != store::uniqueKey(term.term) &&
               known.contains(store::uniqueKey(label.second));
      });
      term.uri = one.value("uri", "");
      terms->push_back(std::move(term));
    }
    if (terms->size() == before) continue;
    if (Result<void> set = Settings(catalogue).setVocabulary(name, *terms, provenance); !set)
      return set;
  }
  return {};
}

}  // namespace ostraka::metadata
