#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "catalogue/catalogue.h"
#include "merge/content.h"
#include "merge/joined_places.h"
#include "merge/outcome.h"
#include "merge/units.h"
#include "records/records.h"

namespace ostraka::merge {

/// Brings the content of B into A's catalogue: once, within the caller's transaction, which is
/// rolled back if a conflict is unsettled (until then it counts as settled for A). Throws as
/// Statement does. docs/merge.md has the rules.
class Merging {
 public:
  struct Projects {
    const catalogue::Catalogue& a;
    std::filesystem::path a_folder;
    const catalogue::Catalogue& b;
    std::filesystem::path b_folder;
    const Content& b_content;
  };
  Merging(Projects projects, const Settled& settled, const records::Provenance& provenance);
  Outcome run();

 private:
  using Values = std::vector<Value>;
  /// Which fields of a row only one of the projects changed, and by which event last.
  using Touched = std::unordered_map<std::string, std::unordered_map<std::string, const Event*>>;

  // merging.cpp: rows of any table
  void readAliases();
  void mergeTable(const Table& a, const Table& b);
  void aliasRows(const Table& a, const Table& b);
  bool sameUnderAnotherId(const Table& a, const Row& mine, const Table& b, const Row& theirs,
                          const Values& values);
  void mergeRow(const Table& table, const Row& mine, const Row& theirs);
  void mergeCustomFields(const Table& table, const Row& mine, const Values& theirs);
  void insertRow(const Table& table, const Row& theirs, const Values& values);
  bool claimName(const Table& table, const Values& values);
  void write(const Table& table, std::int64_t row,
             std::vector<std::pair<std::size_t, Value>> changes);
  void setDeferred();
  Values canonical(const Table& table, const Row& row) const;
  std::string sameId(const std::string& id) const;       ///< the same row in A
  std::string canonicalId(const std::string& id) const;  ///< or the place that it is one with
  Value stored(const Table& table, std::size_t column, const Value& value) const;
  /// Whose value holds, by who changed it since both were the same.
  Take decide(const Table* table, Said said);
  Take settle(Conflict conflict);
  const Choice* choiceOf(const std::string& conflict_id) const;
  Said saidOf(const Table& table, const Unit& unit, const Row& mine, const Values& theirs) const;
  std::string told(const Table& table, std::size_t column, const Value& value) const;
  // versions.cpp: what a person sees of a conflict
  std::string labelOf(const std::string& id) const;
  void label(const Table& table, const std::string& id, const Values& values);
  std::string wholeName(const Table& table, const std::string& id) const;
  std::string shown(const Table& table, std::size_t column, const Value& value) const;
  Version versionOf(const Table& table, const Unit& unit, const Values& values) const;
  Version sherdSeen(const Table& table, const Values& values) const;
  static Version computed(const Table& batches, const Values& values);
  std::string initialsOf(const std::string& person) const;
  void stamp(Version& version, const Touched& touched, const Said& said) const;
  void stampRow(Version& version, const Table& table, const Values& values, const char* person,
                const char* at) const;
  // events.cpp: the history
  void compareHistories(const std::string& table);
  void copyEvents(const std::string& row);
  void remember(const std::string& table, std::int64_t row, const std::string& field,
                const std::string& old_value, const std::string& new_value);
  static bool touches(const Touched& touched, const std::string& row,
                      const std::vector<std::string>& fields);
  // numbers.cpp: sherds and their numbers
  void readSameSherds();
  void noteNumbers();
  Conflict twoSherds(const std::string& mine, const std::string& theirs, const Values&) const;
  std::string freeNumber(const Conflict& conflict, const std::string& loser) const;
  std::string numberNow(const std::string& sherd) const;
  std::string numberInB(const std::string& sherd) const;  ///< empty: none, or no such sherd
  bool takesNumber(const std::string& sherd, const Table& table, Values& values);
  bool winsNumber(const std::string& sherd, const Table& table, Values& values);
  void takeNumberAway(const std::string& sherd, const std::string& wanted);
  void renumberLosers();
  void claimNumber(const std::string& sherd, const std::string& number);
  void addGivenNumbers();
  void assignNumbers();
  void proposeNumbers();
  void mergeMeasurements();
  void mergeJoins();
  // batches.cpp, peoples_files.cpp: batches, their scans, decisions and files
  void numberBatch(const Table& table, const Row& theirs, Values& values);
  std::string placed(const std::string& path) const;
  void noteOwnComputations();
  void placeScan(const Table& table, const Row& theirs, Values& values);
  std::vector<std::string> bagsNow(const std::vector<std::string>& bags) const;
  void mergeBags();
  void comparePairs();
  void comparePieces();
  Version decided(std::vector<std::pair<std::string, std::string>> verdicts, const Table& table,
                  const std::vector<const Row*>& rows) const;
  void withdrawLosers();
  void mergePeoplesFiles();
  Take settleMasks(Conflict, const std::string& batch, const std::string& a, const std::string& b);
  void finishBatches();
  static bool isOfResults(const Table&, const Values&, const std::set<std::string>& batches);
  void restoreFile(const Table& table, const Row& mine, const Row& theirs);
  FileCopy& addFile(const Table& table, const Values& values, const std::string& from);
  void mergeTerms();
  void mergeProject();
  void mergeSettings();
  void searchAnew();
  Projects projects_;
  const Settled& settled_;
  const records::Provenance& provenance_;
  store::Database& database_;
  Content a_;
  const Content& b_;
  Outcome outcome_;
  std::map<std::string, std::vector<Unit>> units_;               ///< by table
  std::unordered_map<std::string, std::string> alias_, labels_;  ///< of B -> of A; by uuid
  std::unordered_map<std::string, std::int64_t> rows_;           ///< of A, by uuid
  JoinedPlaces places_;
  std::unordered_map<std::string, Take> takes_, of_row_;  ///< of a conflict; of a row's fields
  std::unordered_map<std::string, std::vector<Event>> new_events_;  ///< of B alone, by row
  Touched touched_a_, touched_b_;
  std::map<std::string, std::vector<const Event*>> since_a_, since_b_;  ///< by table, in order
  std::vector<Deferred> deferred_;
  std::unordered_map<std::string, std::string> number_owner_, contested_;  ///< of slug, conflict
  std::set<std::pair<std::string, std::string>> numbers_in_b_;  ///< slug, sherd: at any time
  std::set<std::string> new_places_;                         ///< table and natural key: as settled
  std::unordered_map<std::string, const Row*> sherds_of_b_;  ///< by uuid in A
  std::vector<TakenNumber> taken_away_;                      ///< of sherds of A
  std::set<std::string> lost_numbers_;  ///< sherds of B whose number stays with another
  std::map<std::string, std::pair<std::string, std::string>> new_numbers_;  ///< sherd: old, new
  std::map<std::string, std::string> claimed_, folder_of_, demoted_;  ///< sherd; batch, scan of B
  std::set<std::string> fresh_batches_, computed_in_a_, computed_in_b_, decided_in_b_;  ///< uuids
  std::vector<std::pair<std::int64_t, Value>> scan_positions_;  ///< once all others moved away
  std::vector<std::pair<std::string, std::string>> losers_;     ///< table, uuid of a decision
  std::set<std::int64_t> changed_sherds_;
  bool places_changed_ = false;
};

}  // namespace ostraka::merge
