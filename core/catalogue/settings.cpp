#include "catalogue/settings.h"

#include <nlohmann/json.hpp>
#include <set>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/history.h"
#include "files/json_text.h"
#include "records/numbering.h"
#include "records/sherd.h"
#include "records/starting_words.h"
#include "store/database.h"
#include "store/file_header.h"
#include "store/migrations.h"
#include "store/names.h"
#include "store/partial_file.h"
#include "store/values.h"

namespace ostraka::catalogue {
namespace {

bool isProjectCode(const std::string& code) {
  if (code.size() < 2 || code.size() > 8) return false;
  for (const char c : code)
    if (!((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))) return false;
  return true;
}

}  // namespace

Result<records::ProjectRecord> Settings::project() const {
  return database_->asResult([&] {
    records::ProjectRecord p;
    store::Statement row = database_->sql(
        "SELECT id, code, title, institution, licence, rights_holder, numbering, word_for_context "
        "FROM project");
    if (row.next())
      row >> p.id >> p.code >> p.title >> p.institution >> p.licence >> p.rights_holder >>
          p.numbering >> p.word_for_context;
    return p;
  });
}

Result<void> Settings::setProject(const records::ProjectRecord& p,
                                  const records::Provenance& provenance) {
  if (!isProjectCode(p.code))
    return Error::unusable(
        message("The project's code must be 2 to 8 capital letters or digits, for example ARM."),
        p.code);
  if (const Result<records::Numbering> scheme = records::Numbering::parse(p.numbering); !scheme)
    return scheme.error();
  return database_->inTransaction([&] {
    const bool first = !database_->sql("SELECT 1 FROM project").next();
    if (first) {
      database_
          ->sql(
              "INSERT INTO project (row, id, created_at, created_by, updated_at, updated_by, "
              "code, title, institution, licence, rights_holder, numbering, word_for_context) "
              "VALUES (1, ?, ?, ?, ?, ?, ?, '', '', '', '', ?, '')")
          .with(newId(now()), now(), provenance.person, now(), provenance.person, p.code,
                p.numbering)
          .run();
      for (const records::StartingVocabulary& vocabulary : records::startingVocabularies())
        for (std::size_t i = 0; i < vocabulary.terms.size(); ++i)
          database_->sql("INSERT INTO vocabulary VALUES (?, ?, ?, ?, ?)")
              .with(vocabulary.name, vocabulary.terms[i].term, static_cast<std::int64_t>(i),
                    nlohmann::json(vocabulary.terms[i].labels).dump(), vocabulary.terms[i].uri)
              .run();
    }
    rememberDifferences(catalogue_, provenance, "project", 1,
                        {{"code", p.code},
                         {"title", p.title},
                         {"institution", p.institution},
                         {"licence", p.licence},
                         {"rights_holder", p.rights_holder},
                         {"numbering", p.numbering},
                         {"word_for_context", p.word_for_context}});
    database_
        ->sql(
            "UPDATE project SET code = ?, title = ?, institution = ?, licence = ?, "
            "rights_holder = ?, numbering = ?, word_for_context = ?, updated_at = ?, "
            "updated_by = ?, revision = revision + 1")
        .with(p.code, p.title, p.institution, p.licence, p.rights_holder, p.numbering,
              p.word_for_context, now(), provenance.person)
        .run();
  });
}

Result<std::string> Settings::value(const std::string& key) const {
  return database_->asResult([&] {
    std::string value;
    store::Statement row = database_->sql("SELECT value FROM setting WHERE key = ?");
    row.with(key);
    if (row.next()) row >> value;
    return value;
  });
}

Result<void> Settings::setValue(const std::string& key, const std::string& value) {
  return database_->inTransaction([&] {
    database_->sql("INSERT OR REPLACE INTO setting VALUES (?, ?)").with(key, value).run();
  });
}

Result<std::vector<records::Term>> Settings::vocabulary(const std::string& name) const {
  return database_->asResult([&] {
    std::vector<records::Term> terms;
    store::Statement rows =
        database_->sql("SELECT term, labels, uri FROM vocabulary WHERE name = ? ORDER BY position");
    rows.with(name);
    while (rows.next()) {
      records::Term term;
      std::string labels;
      rows >> term.term >> labels >> term.uri;
      const nlohmann::json json = jsonOrDiscarded(labels);
      for (const auto& [language, label] : json.items())
        if (label.is_string()) term.labels[language] = label.get<std::string>();
      terms.push_back(std::move(term));
    }
    return terms;
  });
}

Result<void> Settings::setVocabulary(const std::string& name,
                                     const std::vector<records::Term>& terms,
                                     const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    std::vector<std::string> older, newer;
    {
      store::Statement rows =
          database_->sql("SELECT term FROM vocabulary WHERE name = ? ORDER BY position");
      rows.with(name);
      for (std::string term; rows.next();) {
        rows >> term;
        older.push_back(term);
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
      store::Statement used = database_->sql(
          "SELECT count(*) FROM sherd_term WHERE term = ?1 AND (field = ?2 OR (?2 = 'surface' AND "
          "field IN ('surface_out', 'surface_in')))");
      used.with(term, name);
      std::int64_t count = 0;
      if (used.next()) used >> count;
      if (count > 0)
        store::refuse(message("Sherds with the term '%1': %2; change those first.", term, count),
                      name);
    }
    database_->sql("DELETE FROM vocabulary WHERE name = ?").with(name).run();
    for (std::size_t i = 0; i < terms.size(); ++i)
      database_->sql("INSERT INTO vocabulary VALUES (?, ?, ?, ?, ?)")
          .with(name, terms[i].term, static_cast<std::int64_t>(i),
                nlohmann::json(terms[i].labels).dump(), terms[i].uri)
          .run();
    remember(catalogue_, provenance, "vocabulary", 0, name, store::joinTerms(older),
             store::joinTerms(newer));
  });
}

}  // namespace ostraka::catalogue
