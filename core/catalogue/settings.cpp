#include "catalogue/settings.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/stamped_rows.h"
#include "catalogue/typed_place.h"
#include "files/json_text.h"
#include "records/numbering.h"
#include "records/sherd.h"
#include "records/starting_words.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

constexpr const char *kTextureKey = "process.texture", *kWithoutLight = "albedo";

bool isProjectCode(const std::string& code) {
  if (code.size() < 2 || code.size() > 8) return false;
  for (const char c : code)
    if (!((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))) return false;
  return true;
}

}  // namespace

std::string toldTerm(const std::string& labels_json, const std::string& uri) {
  return labels_json + " " + uri;
}

ToldTerm toldTermFrom(const std::string& told) {
  const std::size_t end = std::min(told.rfind("} "), told.size() - 1);
  ToldTerm term{told.substr(0, end + 1), end + 2 < told.size() ? told.substr(end + 2) : ""};
  if (!jsonOrDiscarded(term.labels_json).is_object()) return {"{}", {}};
  return term;
}

Result<records::ProjectRecord> Settings::project() const {
  return database_->asResult([&] {
    records::ProjectRecord p;
    store::Statement row = database_->sql(
        "SELECT id, code, title, institution, licence, rights_holder, numbering, word_for_context "
        "FROM project");
    row.read(p.id, p.code, p.title, p.institution, p.licence, p.rights_holder, p.numbering,
             p.word_for_context);
    return p;
  });
}

Result<void> Settings::setProject(const records::ProjectRecord& p,
                                  const records::Provenance& provenance) {
  if (!isProjectCode(p.code))
    return Error::unusable(
        message(
            "The project's code must be 2 to 8 letters from A to Z or digits, for example ARM."),
        p.code);
  if (const Result<records::Numbering> scheme = records::Numbering::parse(p.numbering); !scheme)
    return scheme.error();
  return database_->inTransaction([&] {
    const bool first = !database_->sql("SELECT 1 FROM project").next();
    if (first) {
      database_->run(
          "INSERT INTO project (row, id, created_at, created_by, updated_at, updated_by, "
          "code, title, institution, licence, rights_holder, numbering, word_for_context) "
          "VALUES (1, ?, ?, ?, ?, ?, ?, '', '', '', '', ?, '')",
          newId(now()), now(), provenance.person, now(), provenance.person, p.code, p.numbering);
      for (const records::StartingVocabulary& vocabulary : records::startingVocabularies())
        for (std::size_t i = 0; i < vocabulary.terms.size(); ++i)
          database_->run("INSERT INTO vocabulary VALUES (?, ?, ?, ?, ?)", vocabulary.name,
                         vocabulary.terms[i].term, static_cast<std::int64_t>(i),
                         nlohmann::json(vocabulary.terms[i].labels).dump(),
                         vocabulary.terms[i].uri);
    }
    const std::vector<Column> columns = {{"code", p.code},
                                         {"title", p.title},
                                         {"institution", p.institution},
                                         {"licence", p.licence},
                                         {"rights_holder", p.rights_holder},
                                         {"numbering", p.numbering},
                                         {"word_for_context", p.word_for_context}};
    rememberDifferences(catalogue_, provenance, "project", 1, columns);
    changeRow(catalogue_, provenance, "project", 1, columns);
  });
}

Result<void> Settings::rename(const std::string& title, const std::string& code,
                              const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    records::ProjectRecord renamed = store::valueOrThrow(project());
    const std::string old_title = std::exchange(renamed.title, title.empty() ? code : title);
    const std::string old_code = std::exchange(renamed.code, code);
    const std::string place = store::valueOrThrow(value(kCapturePlace));
    const std::string same_place = placeOfRenamedSite(catalogue_, place, old_code, code);
    store::valueOrThrow(setProject(renamed, provenance));
    if (same_place != place) store::valueOrThrow(setValue(kCapturePlace, same_place));
    Places places(catalogue_);
    const bool same_code = store::codeKey(code) == store::codeKey(old_code);
    std::vector<records::SiteRecord> sites = store::valueOrThrow(places.sites());
    for (records::SiteRecord& site : sites) {
      const std::string key = store::codeKey(site.code);
      if (!same_code && key == store::codeKey(code))
        store::refuse(message("The site %1 already exists.", site.code), code);
      if (key != store::codeKey(old_code)) continue;
      site.code = code;
      if (site.name == old_title) site.name = renamed.title;
      store::valueOrThrow(places.save(site, provenance));
    }
  });
}

Result<bool> Settings::texturesWithoutLight() const {
  const Result<std::string> kept = value(kTextureKey);
  if (!kept) return kept.error();
  return *kept == kWithoutLight;
}

Result<void> Settings::setTexturesWithoutLight(bool without,
                                               const records::Provenance& provenance) {
  return setValue(kTextureKey, without ? kWithoutLight : "", provenance);
}

Result<std::string> Settings::value(const std::string& key) const {
  return firstOf<std::string>("SELECT value FROM setting WHERE key = ?", key);
}

Result<void> Settings::setValue(const std::string& key, const std::string& value,
                                const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    remember(catalogue_, provenance, "setting", 0, key, store::valueOrThrow(Settings::value(key)),
             value);
    store::valueOrThrow(setValue(key, value));
  });
}

Result<void> Settings::setValue(const std::string& key, const std::string& value) {
  return database_->inTransaction(
      [&] { database_->run("INSERT OR REPLACE INTO setting VALUES (?, ?)", key, value); });
}

Result<std::vector<records::Term>> Settings::vocabulary(const std::string& name) const {
  return database_->asResult([&] {
    std::vector<records::Term> terms;
    store::Statement rows = database_->sql(
        "SELECT term, labels, uri FROM vocabulary WHERE name = ? ORDER BY position", name);
    std::string labels;
    for (records::Term term; rows.read(term.term, labels, term.uri);) {
      term.labels.clear();
      const nlohmann::json json = jsonOrDiscarded(labels);
      for (const auto& [language, label] : json.items())
        if (label.is_string()) term.labels[language] = label.get<std::string>();
      terms.push_back(term);
    }
    return terms;
  });
}

Result<void> Settings::setVocabulary(const std::string& name,
                                     const std::vector<records::Term>& terms,
                                     const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    std::vector<std::string> older, newer;
    std::map<std::string, std::string> described;  // as before
    {
      store::Statement rows = database_->sql(
          "SELECT term, labels, uri FROM vocabulary WHERE name = ? ORDER BY position", name);
      for (std::string term, labels, uri; rows.read(term, labels, uri);) {
        older.push_back(term);
        described[term] = toldTerm(labels, uri);
      }
    }
    std::set<std::string> seen;
    for (const records::Term& term : terms) {
      if (store::trimmed(term.term).empty() || term.term.find(';') != std::string::npos)
        store::refuse(message("A vocabulary term must contain letters and no ';'."), name);
      if (!seen.insert(term.term).second)
        store::refuse(message("The term '%1' appears twice in the vocabulary.", term.term), name);
      newer.push_back(term.term);
    }
    for (const std::string& term : older) {
      if (seen.contains(term)) continue;
      const int count = store::valueOrThrow(sherdsWith(name, term));
      if (count > 0)
        store::refuse(message("Sherds with the term '%1': %2; change those first.", term, count),
                      name);
    }
    database_->run("DELETE FROM vocabulary WHERE name = ?", name);
    remember(catalogue_, provenance, "vocabulary", 0, name, store::joinTerms(older),
             store::joinTerms(newer));
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const std::string labels = nlohmann::json(terms[i].labels).dump();
      database_->run("INSERT INTO vocabulary VALUES (?, ?, ?, ?, ?)", name, terms[i].term,
                     static_cast<std::int64_t>(i), labels, terms[i].uri);
      const auto before = described.try_emplace(terms[i].term, toldTerm("{}", {})).first;
      remember(catalogue_, provenance, "vocabulary", 0, name + "/" + terms[i].term, before->second,
               toldTerm(labels, terms[i].uri));
    }
  });
}

Result<int> Settings::sherdsWith(const std::string& vocabulary, const std::string& term) const {
  return firstOf<int>(
      "SELECT count(*) FROM sherd_term WHERE term = ?1 AND (field = ?2 OR (?2 = 'surface' AND "
      "field "
      "IN ('surface_out', 'surface_in')))",
      term, vocabulary);
}

}  // namespace ostraka::catalogue
