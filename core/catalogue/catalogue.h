#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::store {
class Database;
}  // namespace ostraka::store

namespace ostraka::catalogue {

struct Filter;

/// One connection to a project's catalogue.sqlite. Use it in one thread; another thread opens its
/// own (Project::connect). Everything that changes something is one transaction, is saved when the
/// call returns, and leaves rows in the history. Errors are sentences for a person.
class Catalogue {
 public:
  using Clock = std::function<std::int64_t()>;  ///< milliseconds UTC

  Catalogue(Catalogue&&) noexcept;
  Catalogue& operator=(Catalogue&&) noexcept;
  ~Catalogue();

  // the project
  Result<records::ProjectRecord> project() const;
  Result<void> setProject(const records::ProjectRecord&, const records::Provenance&);
  Result<std::string> setting(const std::string& key) const;  ///< empty when never set
  Result<void> setSetting(const std::string& key, const std::string& value);
  Result<std::vector<records::Term>> vocabulary(const std::string& name) const;
  Result<void> setVocabulary(const std::string& name, const std::vector<records::Term>&,
                             const records::Provenance&);

  // people and places; save: row none adds, else changes; the row is returned
  Result<std::vector<records::PersonRecord>> persons() const;
  Result<store::PersonRow> save(const records::PersonRecord&, const records::Provenance&);
  /// Made when nobody has them. Capitals make no difference.
  Result<store::PersonRow> personByInitials(const std::string& initials,
                                            const records::Provenance&);
  Result<std::vector<records::SiteRecord>> sites() const;
  Result<store::SiteRow> save(const records::SiteRecord&, const records::Provenance&);
  Result<std::vector<records::TrenchRecord>> trenches() const;
  Result<store::TrenchRow> save(const records::TrenchRecord&, const records::Provenance&);
  Result<std::vector<records::ContextRecord>> contexts() const;
  Result<store::ContextRow> save(const records::ContextRecord&, const records::Provenance&);
  Result<records::ContextRecord> context(store::ContextRow) const;
  /// None when there is no such place. Capitals make no difference; an empty trench is none.
  Result<store::ContextRow> contextByPlace(const std::string& site, const std::string& trench,
                                           const std::string& number) const;
  Result<std::vector<records::BagRecord>> bags(store::ContextRow) const;
  Result<std::vector<records::BagRecord>> bags() const;
  Result<store::BagRow> save(const records::BagRecord&, const records::Provenance&);

  // batches; a new one gets the next number (B0031) in the saving transaction
  Result<std::string> nextBatchNumber() const;
  Result<store::BatchRow> addBatch(const records::BatchRecord&, const records::Provenance&);
  Result<void> saveBatch(const records::BatchRecord&, const records::Provenance&);
  Result<void> setBatchState(store::BatchRow, records::BatchState, const records::Provenance&);
  Result<std::vector<records::BatchRecord>> batches() const;  ///< newest first
  Result<records::BatchRecord> batch(store::BatchRow) const;
  Result<records::BatchRecord> batchByNumber(const std::string&) const;
  /// None when it is not there.
  Result<std::optional<records::BatchRecord>> batchById(const std::string& id) const;
  Result<store::PhotographRow> save(const records::PhotographRecord&,
                                    const records::Provenance&);  ///< row none: by its key
  Result<std::vector<records::PhotographRecord>> photographs(store::BatchRow) const;
  Result<store::ScanRow> save(const records::ScanRecord&,
                              const records::Provenance&);  ///< row none: by batch, side, index
  Result<std::vector<records::ScanRecord>> scans(store::BatchRow) const;

  // pair decisions: only added. decide() also lets the sherds of the batch follow.
  Result<store::DecisionRow> decide(const records::PairDecision&, const records::Provenance&);
  Result<std::vector<records::PairDecision>> decisions(
      store::BatchRow) const;  ///< all, oldest first
  /// What counts now, one per pair or lone scan: persons before the program, later before earlier.
  Result<std::vector<records::PairDecision>> currentDecisions(store::BatchRow) const;

  // sherds
  Result<std::vector<store::SherdRow>> sherdRows(const Filter&, const records::SherdOrder&) const;
  Result<std::vector<store::SherdRow>> sherdRows(store::BatchRow) const;
  Result<std::vector<records::SherdRecord>> sherds(
      std::span<const store::SherdRow>) const;  ///< in this order
  Result<records::SherdRecord> sherd(store::SherdRow) const;
  Result<store::SherdRow> sherdByNumber(
      const std::string&) const;  ///< none when there is no such sherd
  Result<store::SherdRow> sherdById(const std::string& uuid) const;  ///< likewise
  Result<store::SherdRow> addSherd(const records::SherdRecord&,
                                   const records::Provenance&);  ///< draft, or with its number
  Result<std::vector<records::ChangePreview>> preview(std::span<const records::FieldChange>) const;
  /// All or nothing. Returns the changes that undo it, in the order to apply them. Errors: what the
  /// preview refuses, what it asks and nobody confirmed.
  Result<std::vector<records::FieldChange>> change(std::span<const records::FieldChange>,
                                                   const records::Provenance&);
  /// The next free numbers of a context (and bag, batch) by the project's scheme; not reserved.
  Result<std::vector<std::string>> proposeNumbers(std::span<const store::SherdRow>) const;
  /// Gives drafts their numbers. Returns them in the order of the rows.
  Result<std::vector<std::string>> assignNumbers(std::span<const store::SherdRow>,
                                                 const records::Provenance&);
  /// Which model and picture show it; relative paths.
  Result<void> setModel(store::SherdRow, const std::string& model_path,
                        const std::string& preview_path);
  Result<void> voidSherd(store::SherdRow, const std::string& reason,
                         const records::Provenance&);  ///< number stays taken
  Result<std::vector<int>> numberGaps(
      store::ContextRow) const;  ///< numbers never given below the highest

  // measurements: a new value is a new row that replaces the older one
  Result<void> measure(const records::Measurement&, const records::Provenance&);
  Result<std::vector<records::Measurement>> measurements(
      store::SherdRow) const;  ///< those that count now
  /// Those of them that persons took, by sherd.
  Result<std::vector<records::Measurement>> measuredByHand(std::span<const store::SherdRow>) const;
  /// All values of a kind that the program has taken from the sherd's models, old ones too.
  Result<std::vector<double>> everComputed(store::SherdRow, const std::string& kind) const;

  // files and history
  Result<store::FileRow> save(const records::FileRecord&,
                              const records::Provenance&);  ///< row none: by its path
  Result<std::vector<records::FileRecord>> files(store::SherdRow) const;
  Result<std::vector<records::FileRecord>> files(store::BatchRow) const;
  Result<std::vector<records::FileRecord>> files() const;
  /// Newest first; its scans and batches by name, B0001 b004.
  Result<std::vector<records::HistoryEntry>> history(store::SherdRow) const;
  Result<std::vector<records::HistoryEntry>> history(const std::string& table,
                                                     std::int64_t row) const;

  std::int64_t historyLength() const;  ///< rows of the history: grows with every change

  /// Whole and consistent: all pages, SQLite's own check, foreign keys, search. Error: Damaged.
  Result<void> checkIntegrity() const;
  /// A copy in a new file, read back and checked before it gets its name.
  Result<void> backup(const std::filesystem::path& file) const;
  int schemaVersion() const;
  bool readOnly() const;  ///< it lies where nothing can be written: every change is refused

  /// Several of the calls above as one transaction: work returns an error to undo them all.
  Result<void> together(const std::function<Result<void>()>& work);
  /// What `work` reads is of one moment, whatever is written meanwhile; it must not write itself.
  Result<void> inSnapshot(const std::function<Result<void>()>& work) const;

  /// For the other files of this folder.
  store::Database& database() const { return *database_; }
  std::int64_t now() const { return clock_(); }
  explicit Catalogue(std::unique_ptr<store::Database>, Clock);

 private:
  std::unique_ptr<store::Database> database_;
  Clock clock_;
};

}  // namespace ostraka::catalogue
