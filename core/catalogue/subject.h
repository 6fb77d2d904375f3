#pragma once
#include <string_view>
#include <vector>

#include "catalogue/catalogue.h"
#include "store/database.h"

namespace ostraka::catalogue {

/// What the objects that read and write one subject of a catalogue have in common. Make one where
/// it is needed, as in `Places(catalogue).sites()`: it is a reference to the catalogue and no more.
/// What changes something is one transaction, is saved when the call returns, and leaves rows in
/// the history that say who did it.
class Subject {
 public:
  explicit Subject(const Catalogue& catalogue)
      : catalogue_(catalogue), database_(&catalogue.database()) {}

 protected:
  std::int64_t now() const { return catalogue_.now(); }
  /// What a query finds: one column of its first row, Value() without one; and of all rows.
  template <class Value, class... Values>
  Result<Value> firstOf(std::string_view query, const Values&... values) const {
    return database_->asResult(
        [&] { return database_->sql(query, values...).template one<Value>(); });
  }
  template <class Value, class... Values>
  Result<std::vector<Value>> allOf(std::string_view query, const Values&... values) const {
    return database_->asResult(
        [&] { return database_->sql(query, values...).template all<Value>(); });
  }

  const Catalogue& catalogue_;
  store::Database* database_;
};

}  // namespace ostraka::catalogue
