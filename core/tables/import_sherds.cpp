// Sherds of a table or of records, each row whole or not at all.
#include <algorithm>
#include <set>
#include <span>

#include "base/message.h"
#include "base/text.h"
#include "base/uuid.h"
#include "catalogue/places.h"
#include "catalogue/typed_place.h"
#include "records/records.h"
#include "records/sherd.h"
#include "records/words.h"
#include "sherds/measurements.h"
#include "sherds/numbers.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"
#include "tables/column_meanings.h"
#include "tables/damaged_number.h"
#include "tables/import_table.h"
#include "tables/portions.h"
#include "tables/similar_contexts.h"
#include "tables/table_joins.h"

namespace ostraka::tables {
namespace {

// How a value was measured that somebody else's table has, nobody here knows.
constexpr const char* kImported = "imported";

using catalogue::BagPlace;
using catalogue::Catalogue;
using records::Confirmation;
using records::FieldChange;
using records::FieldKind;
using records::Provenance;
using records::SherdField;
using records::SherdRecord;
using store::SherdRow;
using store::valueOrThrow;

std::string valueOf(const ImportRow& row, const std::string& name) {
  const auto found = row.values.find(name);
  return found == row.values.end() || found->second == kClear ? std::string() : found->second;
}

// A sentence a row: one that named all rows would make them grow with the square.
Message inTheLines(const std::vector<std::string>& lines) {
  constexpr std::size_t kMostNamed = 10;
  const std::size_t named = std::min(lines.size(), kMostNamed);
  const std::string first = joined(std::span(lines).first(named), ", ");
  return named == lines.size()
             ? message("This appears in more than one row of the table, in the lines %1.", first)
             : message(
                   "This appears in more than one row of the table, in the lines %1 and %2 "
                   "more.",
                   first, lines.size() - named);
}

class Importing {
 public:
  Importing(Catalogue& catalogue, const std::vector<ImportRow>& rows, const ImportOptions& options,
            const Provenance& provenance, ImportReport& report)
      : catalogue_(catalogue),
        rows_(rows),
        joins_(rows),
        options_(options),
        provenance_(provenance),
        report_(report) {
    if (const auto persons = catalogue::People(catalogue).all())
      for (const auto& person : *persons) persons_[person.initials] = person.row;
    for (const ImportRow& row : rows)
      for (const char* column : {"number", "uuid"})
        if (const std::string value = valueOf(row, column); !value.empty())
          lines_[{column, store::uniqueKey(value)}].push_back(std::to_string(row.line));
  }

  Result<void> row(std::size_t at) {
    SherdRow entered;
    RowFate fate = RowFate::Same;
    done_.clear();
    undo_.clear();
    faults_.clear();
    asks_ = false;
    ImportRow row = rows_[at];
    const Result<void> done = catalogue_.together([&]() -> Result<void> {
      entered = find(row);
      const bool fresh = !entered;
      readPlace(row, entered);
      if (fresh) entered = add(row);
      const bool changed = change(at, row, entered, fresh);
      if (!faults_.empty()) return Error::unusable(faults_.front().reason);
      fate = fresh ? RowFate::Fresh : changed ? RowFate::Changed : RowFate::Same;
      return {};
    });
    if (!done && done.error().code != ErrorCode::UnusableInput) return done;
    if (!done) {
      if (faults_.empty()) fault({}, {}, done.error().sentence());
      if (const std::string number = valueOf(row, "number"); !number.empty())
        left_out_.push_back(number);
      for (Refusal& one : faults_) {
        one.line = row.line;
        (asks_ ? report_.questions : report_.refusals).push_back(std::move(one));
      }
      report_.add(row.line, asks_ ? RowFate::Asked : RowFate::Refused);
      return {};
    }
    joins_.enteredAs(at, entered);
    if (const Result<void> noted = noteSimilarNumbers(); !noted) return noted;
    if (fate != RowFate::Same) noteDamagedNumbers(rows_[at]);
    report_.add(row.line, fate);
    if (fate != RowFate::Changed) return {};
    if (const Result<void> told = tellChanges(entered, row.line); !told) return told;
    report_.changes.insert(report_.changes.end(), done_.begin(), done_.end());
    report_.undo.insert(report_.undo.end(), undo_.rbegin(), undo_.rend());  // turned at the end
    return {};
  }

  // Once all rows are entered.
  Result<void> tellWhatToCheck() {
    if (!similar_.empty())
      report_.warnings.push_back(
          message("New numbers differ from existing ones only in zeros, letter case or "
                  "punctuation: %1; check for typos.",
                  joined(similar_, ", ")));
    if (auto warning = similar_contexts_.warning()) report_.warnings.push_back(*warning);
    if (!damaged_.empty())
      report_.warnings.push_back(
          message("A spreadsheet may have shortened these numbers or turned them into dates: %1; "
                  "compare them with the labels and correct them.",
                  joined(damaged_, ", ")));
    if (const Result<void> told = tellFreeNumbers(); !told) return told;
    const Result<std::vector<std::string>> lost = joins_.lost(catalogue_);
    if (!lost) return lost.error();
    if (!lost->empty())
      report_.warnings.push_back(
          message("Joins with rows that were not imported are left out: %1; correct these rows, "
                  "then import the table again.",
                  joined(*lost, ", ")));
    return {};
  }

 private:
  // "007 (0007)"; also of two rows of this table.
  Result<void> noteSimilarNumbers() {
    constexpr std::size_t kMostNamed = 10;
    for (const FieldChange& change : undo_) {
      const std::string number = change.expected.value_or("");
      if (change.field != "number" || number.empty() || similar_.size() > kMostNamed) continue;
      const auto others = sherds::Numbers(catalogue_).similar(change.sherd, number);
      if (!others) return others.error();
      if (others->empty()) continue;
      similar_.push_back(similar_.size() == kMostNamed ? "\u2026"
                                                       : number + " (" + others->front() + ")");
    }
    return {};
  }

  // Of rows that did not enter: they may be written on sherds, and nothing else tells of them.
  Result<void> tellFreeNumbers() {
    constexpr std::size_t kMostNamed = 10;
    std::vector<std::string> free;
    std::set<std::string> seen;
    for (const std::string& number : left_out_) {
      if (free.size() > kMostNamed || !seen.insert(store::uniqueKey(number)).second) continue;
      const Result<bool> is_free = sherds::Numbers(catalogue_).isFree(number);
      if (!is_free) return is_free.error();
      if (*is_free) free.push_back(free.size() == kMostNamed ? "\u2026" : number);
    }
    if (!free.empty())
      report_.warnings.push_back(
          message("Rows that are not imported leave their numbers free: %1; correct and import "
                  "them before you assign new numbers.",
                  joined(free, ", ")));
    return {};
  }

  // Of the sherd and of its place, each once.
  void noteDamagedNumbers(const ImportRow& row) {
    constexpr std::size_t kMostNamed = 10;
    for (const auto& [name, value] : row.values) {
      const SherdField* field = sherds::sherdField(name);
      if (name != "number" && !(field && field->kind == FieldKind::Place)) continue;
      if (!isDamagedNumber(value) || damaged_.size() > kMostNamed ||
          std::find(damaged_.begin(), damaged_.end(), value) != damaged_.end())
        continue;
      damaged_.push_back(damaged_.size() == kMostNamed ? "\u2026" : value);
    }
  }

  // The row goes on to be looked at, so that a person sees at once all that is wrong with it; one
  // fault a value. The parts of a place are one value: they are wrong together.
  void fault(const std::string& column, const std::string& value, Message reason) {
    const auto isPlace = [](const std::string& name) {
      const SherdField* field = sherds::sherdField(name);
      return field && field->kind == FieldKind::Place;
    };
    const bool known = std::ranges::any_of(faults_, [&](const Refusal& one) {
      return one.column == column || (isPlace(one.column) && isPlace(column));
    });
    if (!known) faults_.push_back({0, column, value, std::move(reason)});
  }

  SherdRow find(const ImportRow& row) {
    const std::string number = valueOf(row, "number"), uuid = valueOf(row, "uuid");
    if (number.empty() && uuid.empty())
      fault("number", "", message("The row has neither a number nor a uuid."));
    for (const auto& [column, value] : {std::pair("number", number), std::pair("uuid", uuid)})
      if (const auto same = lines_.find({column, store::uniqueKey(value)});
          same != lines_.end() && same->second.size() > 1)
        fault(column, value, inTheLines(same->second));
    SherdRow by_uuid, by_number;
    if (!uuid.empty() && !isUuid(uuid)) fault("uuid", uuid, message("Not a uuid."));
    if (isUuid(uuid)) by_uuid = valueOrThrow(sherds::Sherds(catalogue_).byId(uuid));
    if (!number.empty()) by_number = valueOrThrow(sherds::Sherds(catalogue_).byNumber(number));
    if (by_number && isUuid(uuid) && by_uuid != by_number)
      fault("number", number, message("The number and the uuid belong to different sherds."));
    return by_uuid ? by_uuid : by_number;
  }

  SherdRow add(const ImportRow& row) {
    if (valueOf(row, "context").empty() && !valueOf(row, "number").empty())
      fault("context", "", message("A new sherd needs its context."));
    SherdRecord record;
    if (const std::string uuid = valueOf(row, "uuid"); isUuid(uuid))
      record.id = store::uniqueKey(uuid);
    record.batch = row.batch;
    return valueOrThrow(sherds::Sherds(catalogue_).add(record, provenance_));
  }

  // The codes that the row writes become those of the place that they name.
  void readPlace(ImportRow& row, SherdRow sherd) {
    const BagPlace written{valueOf(row, "site"), valueOf(row, "trench"), valueOf(row, "context"),
                           valueOf(row, "bag")};
    if (written.context.empty() && (sherd || written.bag.empty())) return;
    if (sherd && written.site.empty()) {  // where it is comes before all other places
      const SherdRecord now = valueOrThrow(sherds::Sherds(catalogue_).get(sherd));
      const std::string trench = written.trench.empty() ? now.trench : written.trench;
      if (valueOrThrow(
              catalogue::Places(catalogue_).contextByPlace(now.site, trench, written.context)))
        return;
    }
    auto known = read_.find(written);
    if (known == read_.end()) {
      const Result<BagPlace> read = catalogue::readPlace(catalogue_, written);
      if (!read) return fault("context", written.context, read.error().sentence());
      known = read_.emplace(written, *read).first;
    }
    const BagPlace& place = known->second;
    for (const auto& [column, code] : {std::pair("site", &place.site),
                                       {"trench", &place.trench},
                                       {"context", &place.context},
                                       {"bag", &place.bag}})
      if (!code->empty()) row.values[column] = *code;
  }

  bool change(std::size_t at, const ImportRow& row, SherdRow sherd, bool fresh) {
    if (options_.unknown_places == UnknownPlaces::Make) {
      const std::string site = valueOf(row, "site"), context = valueOf(row, "context");
      if (!site.empty() && !context.empty()) {
        const std::string trench = valueOf(row, "trench");
        catalogue::Places places(catalogue_);
        const bool is_new = !valueOrThrow(places.contextByPlace(site, trench, context));
        std::vector<std::string> made;
        const auto place = places.contextAt(site, trench, context, provenance_, made);
        if (!place) fault("context", context, place.error().sentence());
        if (place && is_new)
          valueOrThrow(similar_contexts_.note(catalogue_, {site, trench, context, {}}));
        const std::string bag = valueOf(row, "bag");
        if (place && !bag.empty())
          if (const auto bagged = places.bagAt(*place, bag, provenance_); !bagged)
            fault("bag", bag, bagged.error().sentence());
      }
    }
    const SherdRecord now = valueOrThrow(sherds::Sherds(catalogue_).get(sherd));
    checkState(row, now);
    std::vector<FieldChange> changes;
    const bool confirmed =
        options_.asked_rows == AskedRows::Enter || options_.confirmed_lines.contains(row.line);
    const Confirmation confirmation = confirmed ? Confirmation::Given : Confirmation::None;
    for (const auto& [name, typed] : row.values) {
      if (typed.empty() || name == "joins") continue;
      const SherdField* field = sherds::sherdField(name);
      if (field && !field->editable) continue;
      if (name == "number" && store::uniqueKey(typed) == store::uniqueKey(now.number))
        continue;  // capitals make no difference
      const std::string value = typed == kClear ? std::string() : typed;
      // Else a measure of the program, rounded in a table, would come back as a person's.
      const std::string before = sherds::textOf(now, name);
      if (field && field->kind == FieldKind::Number && !before.empty() &&
          showsInTable(value, *store::parsedNumber(before)))
        continue;
      if (const auto unclear = row.unclear.find(name); unclear != row.unclear.end()) {
        fault(name, value, unclear->second);
        continue;
      }
      const bool by_program =
          field && field->kind == FieldKind::Number && row.by_hand && !row.by_hand->contains(name);
      if (by_program && fresh && store::parsedNumber(value)) {
        measureByProgram({sherd, name, value});
        continue;
      }
      if (by_program && !fresh) {  // a table of before the latest computation
        const std::vector<double> computed =
            valueOrThrow(sherds::Measurements(catalogue_).everComputed(sherd, kindOf(name)));
        if (std::ranges::any_of(computed, [&](double one) { return showsInTable(value, one); }))
          continue;
      }
      const std::string own = field ? name : name.starts_with("extra.") ? name : "extra." + name;
      if (value != sherds::textOf(now, own))
        changes.push_back({sherd, own, value, confirmation, std::nullopt, kImported});
    }
    const auto joins = joins_.of(at, now, catalogue_);
    if (!joins) fault("joins", valueOf(row, "joins"), joins.error().sentence());
    if (joins && *joins &&
        std::set((*joins)->begin(), (*joins)->end()) !=
            std::set(now.joins.begin(), now.joins.end())) {
      std::vector<std::string> ids;
      for (const SherdRecord& other : valueOrThrow(sherds::Sherds(catalogue_).of(**joins)))
        ids.push_back(other.id);
      changes.push_back({sherd, "joins", store::joinTerms(ids)});
    }
    bool changed = !changes.empty() && enter(std::move(changes), row, confirmed);
    for (const auto& [measurement, initials] : row.measured) {
      records::Measurement m = measurement;
      m.sherd = sherd;
      Provenance by = provenance_;
      const auto person = persons_.find(initials);
      by.person = person == persons_.end() ? store::PersonRow{} : person->second;
      const auto before = now.measures.find(m.kind);
      changed |= before == now.measures.end() || before->second != m.value;
      if (const Result<void> done = sherds::Measurements(catalogue_).add(m, by); !done)
        fault(m.kind, {}, done.error().sentence());
    }
    return changed;
  }

  // The state follows from the number and from void_reason: one that says another thing would be
  // lost without a word.
  void checkState(const ImportRow& row, const SherdRecord& now) {
    const std::string typed = valueOf(row, "state"), state = store::uniqueKey(typed);
    if (state.empty()) return;
    constexpr auto& words = records::Words<records::SherdState>::all;
    if (std::ranges::find(words, state) == words.end())
      return fault("state", typed, message("The state must be draft, numbered or void."));
    const auto reason = row.values.find("void_reason");
    const bool is_void = reason == row.values.end() || reason->second.empty()
                             ? now.state == records::SherdState::Void
                             : reason->second != kClear;
    const bool says_void = state == records::wordOf(records::SherdState::Void);
    if (says_void && !is_void)
      fault("state", typed,
            message("A sherd is void only with a reason; write it under void_reason, or correct "
                    "the state."));
    if (!says_void && is_void)
      fault("state", typed,
            message("The sherd has a void_reason, so it is void; write void here, or %1 under "
                    "void_reason.",
                    kClear));
  }

  // Whether anything is another now; else what is wrong with each of them.
  bool enter(std::vector<FieldChange> changes, const ImportRow& row, bool confirmed) {
    std::optional<Error> failed;
    if (faults_.empty()) {
      const auto undo = sherds::SherdChanges(catalogue_).apply(changes, provenance_);
      if (undo) {
        // Of what would change; what stays as it was is not asked about.
        for (auto change = undo->rbegin(); change != undo->rend() && !confirmed; ++change)
          if (const auto doubt = row.doubtful.find(change->field); doubt != row.doubtful.end())
            fault(change->field, row.values.at(change->field), doubt->second);
        asks_ = !faults_.empty();
        done_ = std::move(changes);
        undo_ = *undo;
        return !undo->empty();
      }
      failed = undo.error();
    }
    const auto shown = valueOrThrow(sherds::SherdChanges(catalogue_).preview(changes));
    for (const records::ChangePreview& change : shown)
      if (!change.refusal.empty()) fault(change.change.field, change.change.value, change.refusal);
    if (!faults_.empty()) return false;
    for (const records::ChangePreview& change : shown) {
      const auto doubt = row.doubtful.find(change.change.field);
      const bool doubted = doubt != row.doubtful.end() && change.old_value != change.new_value;
      if (change.asks())
        fault(change.change.field, change.change.value,
              doubted ? inOne(change.question, doubt->second) : change.question);
      else if (doubted)
        fault(change.change.field, change.change.value, doubt->second);
    }
    asks_ = !faults_.empty();
    if (!asks_) throw store::Refused(*failed);
    return false;
  }

  static std::string kindOf(const std::string& field) {  // rim_pct, beside length_mm
    return records::unitOf(field).empty() ? field.substr(0, field.rfind('_')) : field;
  }

  // Computed where the table comes from: it gives way to what is computed or measured here.
  void measureByProgram(const FieldChange& number) {
    const auto shown =
        valueOrThrow(sherds::SherdChanges(catalogue_)
                         .preview(std::span(&number, 1)));  // as strict as with typed ones
    if (!shown.front().refusal.empty())
      return fault(number.field, number.value, shown.front().refusal);
    records::Measurement m;
    m.sherd = number.sherd;
    m.kind = kindOf(number.field);
    m.value = *store::parsedNumber(number.value);
    Provenance by = provenance_;
    by.person = {};
    valueOrThrow(sherds::Measurements(catalogue_).add(m, by));
  }

  Result<void> tellChanges(SherdRow sherd, int line) {
    const Result<SherdRecord> after = sherds::Sherds(catalogue_).get(sherd);
    if (!after) return after.error();
    for (auto before = undo_.rbegin(); before != undo_.rend(); ++before)
      report_.changed_values.push_back({after->number.empty() ? after->id : after->number,
                                        before->field, before->value,
                                        sherds::textOf(*after, before->field), line});
    return {};
  }

  Catalogue& catalogue_;
  const std::vector<ImportRow>& rows_;
  TableJoins joins_;
  const ImportOptions& options_;
  const Provenance& provenance_;
  std::vector<Refusal> faults_;  ///< of the present row
  bool asks_ = false;            ///< it is not refused: a person may confirm it
  ImportReport& report_;
  std::vector<FieldChange> done_, undo_;  ///< of the present row
  std::vector<std::string> similar_;      ///< numbers, each with the one that it resembles
  SimilarContexts similar_contexts_;
  std::vector<std::string> damaged_, left_out_;
  /// Of the rows that have this number or uuid.
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> lines_;
  std::map<std::string, store::PersonRow> persons_;
  std::map<BagPlace, BagPlace> read_;  ///< as it was written, and what it is
};

}  // namespace

Result<void> previewOrEnter(Catalogue& catalogue, ImportMode mode,
                            const std::function<Result<void>()>& work) {
  bool whole = false;
  const Result<void> done = catalogue.together([&]() -> Result<void> {
    if (Result<void> worked = work(); !worked) return worked;
    whole = true;
    if (mode == ImportMode::Enter) return {};
    return Error{ErrorCode::Cancelled, message("The preview was undone."), {}};
  });
  return whole && mode == ImportMode::Preview ? Result<void>() : done;
}

Result<ImportReport> importSherds(Catalogue& catalogue, const std::vector<ImportRow>& rows,
                                  const ImportOptions& options, const Provenance& provenance,
                                  Progress& progress, std::stop_token stop) {
  ImportReport report;
  Importing importing(catalogue, rows, options, provenance, report);
  const Result<std::size_t> entered = enterInPortions(
      catalogue, rows.size(), options, progress, stop, [&](std::size_t i) -> Result<void> {
        Result<void> done = importing.row(i);
        return done && i + 1 == rows.size() ? importing.tellWhatToCheck() : done;
      });
  if (!entered) return entered.error();
  std::reverse(report.undo.begin(), report.undo.end());
  report.not_reached = static_cast<int>(rows.size() - *entered);
  return report;
}

}  // namespace ostraka::tables
