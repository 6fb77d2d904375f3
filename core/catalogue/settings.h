#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::catalogue {

/// What holds for the whole project: its record, its settings and its vocabularies.
class Settings : public Subject {
 public:
  using Subject::Subject;

  Result<records::ProjectRecord> project() const;
  Result<void> setProject(const records::ProjectRecord&, const records::Provenance&);
  Result<std::string> value(const std::string& key) const;  ///< empty when never set
  Result<void> setValue(const std::string& key, const std::string& value);
  Result<std::vector<records::Term>> vocabulary(const std::string& name) const;
  Result<void> setVocabulary(const std::string& name, const std::vector<records::Term>&,
                             const records::Provenance&);
  /// How many have this term of the vocabulary.
  Result<int> sherdsWith(const std::string& vocabulary, const std::string& term) const;
};

}  // namespace ostraka::catalogue
