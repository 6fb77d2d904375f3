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

namespace ostraka::catalogue {

class Database;
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
  Result<ProjectRecord> project() const;
  Result<void> setProject(const ProjectRecord&, const Provenance&);
  Result<std::string> setting(const std::string& key) const;  ///< empty when never set
  Result<void> setSetting(const std::string& key, const std::string& value);
  Result<std::vector<Term>> vocabulary(const std::string& name) const;
  Result<void> setVocabulary(const std::string& name, const std::vector<Term>&, const Provenance&);

  // people and places; save: row none adds, else changes; the row is returned
  Result<std::vector<PersonRecord>> persons() const;
  Result<PersonRow> save(const PersonRecord&, const Provenance&);
  /// Made when nobody has them. Capitals make no difference.
  Result<PersonRow> personByInitials(const std::string& initials, const Provenance&);
  Result<std::vector<SiteRecord>> sites() const;
  Result<SiteRow> save(const SiteRecord&, const Provenance&);
  Result<std::vector<TrenchRecord>> trenches() const;
  Result<TrenchRow> save(const TrenchRecord&, const Provenance&);
  Result<std::vector<ContextRecord>> contexts() const;
  Result<ContextRow> save(const ContextRecord&, const Provenance&);
  Result<ContextRecord> context(ContextRow) const;
  /// None when there is no such place. Capitals make no difference; an empty trench is none.
  Result<ContextRow> contextByPlace(const std::string& site, const std::string& trench,
                                    const std::string& number) const;
  Result<std::vector<BagRecord>> bags(ContextRow) const;
  Result<std::vector<BagRecord>> bags() const;
  Result<BagRow> save(const BagRecord&, const Provenance&);

  // batches; a new one gets the next number (B0031) in the saving transaction
  Result<std::string> nextBatchNumber() const;
  Result<BatchRow> addBatch(const BatchRecord&, const Provenance&);
  Result<void> saveBatch(const BatchRecord&, const Provenance&);
  Result<void> setBatchState(BatchRow, BatchState, const Provenance&);
  Result<std::vector<BatchRecord>> batches() const;  ///< newest first
  Result<BatchRecord> batch(BatchRow) const;
  Result<BatchRecord> batchByNumber(const std::string&) const;
  /// None when it is not there.
  Result<std::optional<BatchRecord>> batchById(const std::string& id) const;
  Result<PhotographRow> save(const PhotographRecord&, const Provenance&);  ///< row none: by its key
  Result<std::vector<PhotographRecord>> photographs(BatchRow) const;
  Result<ScanRow> save(const ScanRecord&, const Provenance&);  ///< row none: by batch, side, index
  Result<std::vector<ScanRecord>> scans(BatchRow) const;

  // pair decisions: only added. decide() also lets the sherds of the batch follow.
  Result<DecisionRow> decide(const PairDecision&, const Provenance&);
  Result<std::vector<PairDecision>> decisions(BatchRow) const;  ///< all, oldest first
  /// What counts now, one per pair or lone scan: persons before the program, later before earlier.
  Result<std::vector<PairDecision>> currentDecisions(BatchRow) const;

  // sherds
  Result<std::vector<SherdRow>> sherdRows(const Filter&, const SherdOrder&) const;
  Result<std::vector<SherdRow>> sherdRows(BatchRow) const;
  Result<std::vector<SherdRecord>> sherds(std::span<const SherdRow>) const;  ///< in this order
  Result<SherdRecord> sherd(SherdRow) const;
  Result<SherdRow> sherdByNumber(const std::string&) const;   ///< none when there is no such sherd
  Result<SherdRow> sherdById(const std::string& uuid) const;  ///< likewise
  Result<SherdRow> addSherd(const SherdRecord&, const Provenance&);  ///< draft, or with its number
  Result<std::vector<ChangePreview>> preview(std::span<const FieldChange>) const;
  /// All or nothing. Returns the changes that undo it, in the order to apply them. Errors: what the
  /// preview refuses, what it asks and nobody confirmed.
  Result<std::vector<FieldChange>> change(std::span<const FieldChange>, const Provenance&);
  /// The next free numbers of a context (and bag, batch) by the project's scheme; not reserved.
  Result<std::vector<std::string>> proposeNumbers(std::span<const SherdRow>) const;
  /// Gives drafts their numbers. Returns them in the order of the rows.
  Result<std::vector<std::string>> assignNumbers(std::span<const SherdRow>, const Provenance&);
  /// Which model and picture show it; relative paths.
  Result<void> setModel(SherdRow, const std::string& model_path, const std::string& preview_path);
  Result<void> voidSherd(SherdRow, const std::string& reason,
                         const Provenance&);              ///< number stays taken
  Result<std::vector<int>> numberGaps(ContextRow) const;  ///< numbers never given below the highest

  // measurements: a new value is a new row that replaces the older one
  Result<void> measure(const Measurement&, const Provenance&);
  Result<std::vector<Measurement>> measurements(SherdRow) const;  ///< those that count now
  /// Those of them that persons took, by sherd.
  Result<std::vector<Measurement>> measuredByHand(std::span<const SherdRow>) const;
  /// All values of a kind that the program has taken from the sherd's models, old ones too.
  Result<std::vector<double>> everComputed(SherdRow, const std::string& kind) const;

  // files and history
  Result<FileRow> save(const FileRecord&, const Provenance&);  ///< row none: by its path
  Result<std::vector<FileRecord>> files(SherdRow) const;
  Result<std::vector<FileRecord>> files(BatchRow) const;
  Result<std::vector<FileRecord>> files() const;
  /// Newest first; its scans and batches by name, B0001 b004.
  Result<std::vector<HistoryEntry>> history(SherdRow) const;
  Result<std::vector<HistoryEntry>> history(const std::string& table, std::int64_t row) const;

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
  Database& database() const { return *database_; }
  std::int64_t now() const { return clock_(); }
  explicit Catalogue(std::unique_ptr<Database>, Clock);

 private:
  std::unique_ptr<Database> database_;
  Clock clock_;
};

}  // namespace ostraka::catalogue
