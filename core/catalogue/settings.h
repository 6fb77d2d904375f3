#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::catalogue {

/// Before the number of a batch: its photographs are another's, too, and a person keeps both.
inline constexpr const char* kKeptTwice = "photographs.kept_twice.";

/// How the history tells what a term is called, under the field "part/rim".
std::string toldTerm(const std::string& labels_json, const std::string& uri);
struct ToldTerm {
  std::string labels_json, uri;
};
/// None where the text is no such one.
ToldTerm toldTermFrom(const std::string& told);

/// What holds for the whole project: its record, its settings and its vocabularies.
class Settings : public Subject {
 public:
  using Subject::Subject;

  Result<records::ProjectRecord> project() const;
  Result<void> setProject(const records::ProjectRecord&, const records::Provenance&);
  /// Another title and code; an empty title is the code. The site that has the project's code gets
  /// the new one too, and the title where its name was the old one. Numbers that sherds have stay;
  /// {site} in those still to be given follows. Errors: a code that is none, or is another site's.
  Result<void> rename(const std::string& title, const std::string& code,
                      const records::Provenance&);
  /// Textures of batches that are computed from now on show the sherds without the light of the
  /// photographs.
  Result<bool> texturesWithoutLight() const;
  Result<void> setTexturesWithoutLight(bool without, const records::Provenance&);
  Result<std::string> value(const std::string& key) const;  ///< empty when never set
  /// What a person set: it goes into the history.
  Result<void> setValue(const std::string& key, const std::string& value,
                        const records::Provenance&);
  /// What the program notes of its own work, and finds or makes anew where it is lost.
  Result<void> setValue(const std::string& key, const std::string& value);
  Result<std::vector<records::Term>> vocabulary(const std::string& name) const;
  Result<void> setVocabulary(const std::string& name, const std::vector<records::Term>&,
                             const records::Provenance&);
  /// How many have this term of the vocabulary.
  Result<int> sherdsWith(const std::string& vocabulary, const std::string& term) const;
};

}  // namespace ostraka::catalogue
