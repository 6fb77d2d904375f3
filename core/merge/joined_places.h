#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "catalogue/catalogue.h"
#include "merge/content.h"
#include "merge/outcome.h"

namespace ostraka::merge {

/// Trenches, contexts and bags of A that are one with another by now, in whichever project a person
/// said so, and those whose names change hands in a merge. Throws as Statement does.
class JoinedPlaces {
 public:
  /// content: of A; rows: of A by uuid, which both grow.
  JoinedPlaces(const catalogue::Catalogue& a, Content& content,
               const std::unordered_map<std::string, std::int64_t>& rows)
      : a_(a), database_(a.database()), content_(content), rows_(rows) {}

  /// The place that this one of A is one with; else its own uuid.
  std::string now(const std::string& id) const;
  /// What stands for the key of a name until all others let theirs go (settleNames). came_by_join:
  /// it lies in a place that is one with another.
  std::string heldKey(const std::string& table, const Value& key, bool came_by_join,
                      const std::string& id);
  /// The same within changes of a row of A, by which it may get the name of another.
  void hold(const Table& table, std::int64_t row,
            std::vector<std::pair<std::size_t, Value>>& changes);
  /// Each gets its name. Two of one name beside each other become one: the one that came from
  /// another place goes, else the younger one, so that each project and order gives the same.
  void settleNames();
  /// Those that are another by now behind that one.
  static void sort(const Table& table, std::vector<const Row*>& rows);
  /// After a table was merged: what still lies in a place that is another by now comes to that one,
  /// in the catalogue and in what is known of A.
  void settle(const Table& table, std::vector<Deferred>& deferred);
  bool changed() const { return changed_; }  ///< something came to another place

 private:
  struct Name {
    std::string table, id, key;
    bool came_by_join = false;
  };
  void breakCircles(const std::string& table);
  void bringTogether(const Table& table, const std::string& id, std::int64_t row);

  const catalogue::Catalogue& a_;
  store::Database& database_;
  Content& content_;
  const std::unordered_map<std::string, std::int64_t>& rows_;
  std::unordered_map<std::string, std::string> now_;
  std::set<std::string> came_by_join_;
  std::vector<Name> names_;
  bool changed_ = false;
};

}  // namespace ostraka::merge
