#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "base/result.h"

namespace ostraka::store {
class Database;
}  // namespace ostraka::store

namespace ostraka::catalogue {

/// One connection to a project's catalogue.sqlite. Use it in one thread; another thread opens its
/// own (Project::connect). What it holds is read and written through the subjects of this folder:
/// Settings, People, Places, Batches, PairDecisions, Sherds, SherdChanges, Numbers, Measurements,
/// Files and History.
class Catalogue {
 public:
  using Clock = std::function<std::int64_t()>;  ///< milliseconds UTC

  Catalogue(Catalogue&&) noexcept;
  Catalogue& operator=(Catalogue&&) noexcept;
  ~Catalogue();

  /// Whole and consistent: all pages, SQLite's own check, foreign keys, search. Error: Damaged.
  Result<void> checkIntegrity() const;
  /// A copy in a new file, read back and checked before it gets its name.
  Result<void> backup(const std::filesystem::path& file) const;
  int schemaVersion() const;
  /// Another number after other connections, of this program or another, have written. Cheap.
  Result<std::int64_t> writesOfOthers() const;
  bool readOnly() const;  ///< it lies where nothing can be written: every change is refused

  /// Several changes as one transaction: work returns an error to undo them all.
  Result<void> together(const std::function<Result<void>()>& work);
  /// What `work` reads is of one moment, whatever is written meanwhile; it must not write itself.
  Result<void> inSnapshot(const std::function<Result<void>()>& work) const;

  /// For the subjects and for upkeep.
  store::Database& database() const { return *database_; }
  std::int64_t now() const { return clock_(); }
  explicit Catalogue(std::unique_ptr<store::Database>, Clock);

 private:
  std::unique_ptr<store::Database> database_;
  Clock clock_;
};

}  // namespace ostraka::catalogue
