#include "records/sherd.h"

#include <algorithm>

#include "base/text.h"

namespace ostraka::records {

std::string unitOf(const std::string& kind) {
  if (kind == "area") return "mm2";
  if (kind == "volume") return "mm3";
  if (kind == "weight") return "g";
  if (kind == "filled_pct" || kind == "rim_pct") return "pct";
  for (const char* length :
       {"length", "width", "thickness_min", "thickness_mean", "thickness_max", "rim_diameter"})
    if (kind == length) return "mm";
  return {};
}

namespace {

// "rim, neck, base", in each language that has labels.
MessageValue namesOf(const std::vector<Term>& terms) {
  constexpr std::size_t kMost = 8;
  std::set<std::string> languages;
  for (const Term& term : terms)
    for (const auto& [language, label] : term.labels) languages.insert(language);
  const auto in = [&](const std::string& language) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(terms.size(), kMost); ++i) {
      const auto label = terms[i].labels.find(language);
      names.push_back(label == terms[i].labels.end() ? terms[i].term : label->second);
    }
    if (terms.size() > kMost) names.emplace_back("\u2026");
    return joined(names, ", ");
  };
  MessageValue value(in({}));
  for (const std::string& language : languages) value.translations[language] = in(language);
  return value;
}

}  // namespace

Message notATerm(const std::string& typed, const std::vector<Term>& vocabulary) {
  return vocabulary.empty()
             ? message("'%1' is not a term: the vocabulary is empty; add it in the settings.",
                       typed)
             : message("'%1' is not a term; choose one of %2, or add it in the settings.", typed,
                       namesOf(vocabulary));
}

}  // namespace ostraka::records
