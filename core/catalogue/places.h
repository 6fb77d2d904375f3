#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"

namespace ostraka::catalogue {

/// Who works in the project. save: a record without a row is added, else changed; returns the row.
class People : public Subject {
 public:
  using Subject::Subject;

  Result<std::vector<records::PersonRecord>> all() const;
  Result<store::PersonRow> save(const records::PersonRecord&, const records::Provenance&);
  /// Added when nobody has these initials. Capitals make no difference.
  Result<store::PersonRow> byInitials(const std::string& initials, const records::Provenance&);
};

/// Sites, trenches, contexts and bags. save: as People's.
class Places : public Subject {
 public:
  using Subject::Subject;

  Result<std::vector<records::SiteRecord>> sites() const;
  Result<std::vector<records::TrenchRecord>> trenches() const;
  /// Of the site with this code.
  Result<bool> hasTrenches(const std::string& site) const;
  Result<std::vector<records::ContextRecord>> contexts() const;
  Result<records::ContextRecord> context(store::ContextRow) const;
  /// None when there is no such place. Capitals make no difference; an empty trench is none.
  Result<store::ContextRow> contextByPlace(const std::string& site, const std::string& trench,
                                           const std::string& number) const;
  /// The same, made with its trench and site where they are new; adds their codes ("ARM1",
  /// "ARM1 T3") to `made`.
  Result<store::ContextRow> contextAt(const std::string& site, const std::string& trench,
                                      const std::string& number, const records::Provenance&,
                                      std::vector<std::string>& made);
  /// None when there is no such bag. Capitals make no difference.
  Result<store::BagRow> bagByNumber(store::ContextRow, const std::string& number) const;
  /// The same, made where it is new.
  Result<store::BagRow> bagAt(store::ContextRow, const std::string& number,
                              const records::Provenance&);
  Result<std::vector<records::BagRecord>> bags() const;
  Result<std::vector<records::BagRecord>> bags(store::ContextRow) const;

  Result<store::SiteRow> save(const records::SiteRecord&, const records::Provenance&);
  Result<store::TrenchRow> save(const records::TrenchRecord&, const records::Provenance&);
  Result<store::ContextRow> save(const records::ContextRecord&, const records::Provenance&);
  Result<store::BagRow> save(const records::BagRecord&, const records::Provenance&);
};

}  // namespace ostraka::catalogue
