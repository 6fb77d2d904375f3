// Sherds of a table or of records, each row whole or not at all.
#include <algorithm>
#include <set>
#include <span>

#include "base/message.h"
#include "base/text.h"
#include "base/uuid.h"
#include "catalogue/places.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"
#include "tables/column_meanings.h"
#include "tables/import_table.h"
#include "tables/portions.h"
#include "tables/table_joins.h"

namespace ostraka::tables {
namespace {

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
        places_(catalogue, options.unknown_places, provenance),
        makes_places_(options.unknown_places == UnknownPlaces::Make),
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
    const ImportRow& row = rows_[at];
    SherdRow entered;
    RowFate fate = RowFate::Same;
    Refusal refusal{row.line, {}, {}, {}};
    done_.clear();
    undo_.clear();
    asks_ = false;
    const Result<void> done = catalogue_.together([&]() -> Result<void> {
      entered = find(row, refusal);
      const bool fresh = !entered;
      if (fresh) entered = add(row, refusal);
      const bool changed = change(at, entered, fresh, refusal);
      fate = fresh ? RowFate::Fresh : changed ? RowFate::Changed : RowFate::Same;
      return {};
    });
    if (!done && done.error().code != ErrorCode::UnusableInput) return done;
    if (!done) {
      places_.forget();
      if (refusal.reason.empty()) refusal.reason = done.error().sentence();
      (asks_ ? report_.questions : report_.refusals).push_back(std::move(refusal));
      ++(asks_ ? report_.asked : report_.refused);
      report_.rows.emplace_back(row.line, asks_ ? RowFate::Asked : RowFate::Refused);
      return {};
    }
    joins_.enteredAs(at, entered);
    report_.rows.emplace_back(row.line, fate);
    ++(fate == RowFate::Fresh     ? report_.fresh
       : fate == RowFate::Changed ? report_.changed
                                  : report_.same);
    if (fate != RowFate::Changed) return {};
    if (const Result<void> told = tellChanges(entered); !told) return told;
    report_.changes.insert(report_.changes.end(), done_.begin(), done_.end());
    report_.undo.insert(report_.undo.end(), undo_.rbegin(), undo_.rend());  // turned at the end
    return {};
  }

  Result<void> tellLostJoins() {
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
  // What follows is within the row's transaction: throws Refused.
  [[noreturn]] static void refuse(Refusal& refusal, std::string column, std::string value,
                                  Message reason) {
    refusal.column = std::move(column);
    refusal.value = std::move(value);
    refusal.reason = reason;
    store::refuse(std::move(reason));
  }

  SherdRow find(const ImportRow& row, Refusal& refusal) {
    const std::string number = valueOf(row, "number"), uuid = valueOf(row, "uuid");
    if (number.empty() && uuid.empty())
      refuse(refusal, "number", "", message("The row has neither a number nor a uuid."));
    for (const auto& [column, value] : {std::pair("number", number), std::pair("uuid", uuid)})
      if (const auto same = lines_.find({column, store::uniqueKey(value)});
          same != lines_.end() && same->second.size() > 1)
        refuse(refusal, column, value, inTheLines(same->second));
    SherdRow by_uuid, by_number;
    if (!uuid.empty()) {
      if (!isUuid(uuid)) refuse(refusal, "uuid", uuid, message("Not a uuid."));
      by_uuid = valueOrThrow(sherds::Sherds(catalogue_).byId(uuid));
    }
    if (!number.empty()) by_number = valueOrThrow(sherds::Sherds(catalogue_).byNumber(number));
    if (by_number && !uuid.empty() && by_uuid != by_number)
      refuse(refusal, "number", number,
             message("The number and the uuid belong to different sherds."));
    return by_uuid ? by_uuid : by_number;
  }

  SherdRow add(const ImportRow& row, Refusal& refusal) {
    if (valueOf(row, "context").empty() && !valueOf(row, "number").empty())
      refuse(refusal, "context", "", message("A new sherd needs its context."));
    SherdRecord record;
    record.id = store::uniqueKey(valueOf(row, "uuid"));
    record.batch = row.batch;
    return valueOrThrow(sherds::Sherds(catalogue_).add(record, provenance_));
  }

  bool change(std::size_t at, SherdRow sherd, bool fresh, Refusal& refusal) {
    const ImportRow& row = rows_[at];
    if (makes_places_) {
      const std::string site = valueOf(row, "site"), context = valueOf(row, "context");
      if (!site.empty() && !context.empty()) {
        const auto place = places_.context(site, valueOf(row, "trench"), context);
        if (!place) refuse(refusal, "context", context, place.error().sentence());
        const std::string bag = valueOf(row, "bag");
        if (!bag.empty())
          if (const auto made = places_.bag(*place, bag); !made)
            refuse(refusal, "bag", bag, made.error().sentence());
      }
    }
    const SherdRecord now = valueOrThrow(sherds::Sherds(catalogue_).get(sherd));
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
      if (const auto unclear = row.unclear.find(name); unclear != row.unclear.end())
        refuse(refusal, name, value, unclear->second);
      const bool by_program =
          field && field->kind == FieldKind::Number && row.by_hand && !row.by_hand->contains(name);
      if (by_program && fresh && store::parsedNumber(value)) {
        measureByProgram({sherd, name, value}, refusal);
        continue;
      }
      if (by_program && !fresh) {  // a table of before the latest computation
        const std::vector<double> computed =
            valueOrThrow(sherds::Measurements(catalogue_).everComputed(sherd, kindOf(name)));
        if (std::any_of(computed.begin(), computed.end(),
                        [&](double one) { return showsInTable(value, one); }))
          continue;
      }
      const std::string own = field ? name : name.starts_with("extra.") ? name : "extra." + name;
      if (value != sherds::textOf(now, own)) changes.push_back({sherd, own, value, confirmation});
    }
    const auto joins = joins_.of(at, now, catalogue_);
    if (!joins) refuse(refusal, "joins", valueOf(row, "joins"), joins.error().sentence());
    if (*joins && std::set((*joins)->begin(), (*joins)->end()) !=
                      std::set(now.joins.begin(), now.joins.end())) {
      std::vector<std::string> ids;
      for (const SherdRecord& other : valueOrThrow(sherds::Sherds(catalogue_).of(**joins)))
        ids.push_back(other.id);
      changes.push_back({sherd, "joins", store::joinTerms(ids)});
    }
    bool changed = false;
    if (!changes.empty()) {
      const Result<std::vector<FieldChange>> undo =
          sherds::SherdChanges(catalogue_).apply(changes, provenance_);
      if (!undo) refuseNamed(changes, row, undo.error(), refusal);
      if (!confirmed)
        if (const FieldChange* doubted = doubtedOf(*undo, row); doubted != nullptr) {
          asks_ = true;
          refuse(refusal, doubted->field, row.values.at(doubted->field), questionOf(*undo, row));
        }
      changed = !undo->empty();
      done_ = std::move(changes);
      undo_ = *undo;
    }
    for (const auto& [measurement, initials] : row.measured) {
      records::Measurement m = measurement;
      m.sherd = sherd;
      Provenance by = provenance_;
      const auto person = persons_.find(initials);
      by.person = person == persons_.end() ? store::PersonRow{} : person->second;
      const auto before = now.measures.find(m.kind);
      changed |= before == now.measures.end() || before->second != m.value;
      if (const Result<void> done = sherds::Measurements(catalogue_).add(m, by); !done)
        refuse(refusal, m.kind, {}, done.error().sentence());
    }
    return changed;
  }

  // Of what would change; what stays as it was is not asked about.
  static const FieldChange* doubtedOf(const std::vector<FieldChange>& changes,
                                      const ImportRow& row) {
    const auto found = std::find_if(changes.begin(), changes.end(), [&](const FieldChange& change) {
      return row.doubtful.contains(change.field);
    });
    return found == changes.end() ? nullptr : &*found;
  }
  static Message questionOf(const std::vector<FieldChange>& changes, const ImportRow& row) {
    Message question;
    for (const FieldChange& change : changes)
      if (const auto doubt = row.doubtful.find(change.field); doubt != row.doubtful.end())
        question = question.empty() ? doubt->second : inOne(question, doubt->second);
    return question;
  }

  static std::string kindOf(const std::string& field) {  // rim_pct, beside length_mm
    return records::unitOf(field).empty() ? field.substr(0, field.rfind('_')) : field;
  }

  // Computed where the table comes from: it gives way to what is computed or measured here.
  void measureByProgram(const FieldChange& number, Refusal& refusal) {
    const auto shown =
        valueOrThrow(sherds::SherdChanges(catalogue_)
                         .preview(std::span(&number, 1)));  // as strict as with typed ones
    if (!shown.front().refusal.empty())
      refuse(refusal, number.field, number.value, shown.front().refusal);
    records::Measurement m;
    m.sherd = number.sherd;
    m.kind = kindOf(number.field);
    m.value = *store::parsedNumber(number.value);
    Provenance by = provenance_;
    by.person = {};
    valueOrThrow(sherds::Measurements(catalogue_).add(m, by));
  }

  Result<void> tellChanges(SherdRow sherd) {
    const Result<SherdRecord> after = sherds::Sherds(catalogue_).get(sherd);
    if (!after) return after.error();
    for (auto before = undo_.rbegin(); before != undo_.rend(); ++before)
      report_.changed_values.push_back({after->number.empty() ? after->id : after->number,
                                        before->field, before->value,
                                        sherds::textOf(*after, before->field)});
    return {};
  }

  // Which column it was.
  [[noreturn]] void refuseNamed(const std::vector<FieldChange>& changes, const ImportRow& row,
                                const Error& error, Refusal& refusal) {
    const auto shown = sherds::SherdChanges(catalogue_).preview(changes);
    if (!shown) throw store::Refused(error);
    for (const records::ChangePreview& change : *shown)
      if (!change.refusal.empty())
        refuse(refusal, change.change.field, change.change.value, change.refusal);
    for (const records::ChangePreview& change : *shown)
      if (change.asks()) {
        asks_ = true;
        const Message more = questionOf(changes, row);
        refuse(refusal, change.change.field, change.change.value,
               more.empty() ? change.question : inOne(change.question, more));
      }
    throw store::Refused(error);
  }

  Catalogue& catalogue_;
  const std::vector<ImportRow>& rows_;
  TableJoins joins_;
  Places places_;
  bool makes_places_;
  const ImportOptions& options_;
  const Provenance& provenance_;
  bool asks_ = false;  ///< the present row is not refused: a person may confirm it
  ImportReport& report_;
  std::vector<FieldChange> done_, undo_;  ///< of the present row
  /// Of the rows that have this number or uuid.
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> lines_;
  std::map<std::string, store::PersonRow> persons_;
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
        return done && i + 1 == rows.size() ? importing.tellLostJoins() : done;
      });
  if (!entered) return entered.error();
  std::reverse(report.undo.begin(), report.undo.end());
  report.not_reached = static_cast<int>(rows.size() - *entered);
  return report;
}

}  // namespace ostraka::tables
