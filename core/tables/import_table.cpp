#include "tables/import_table.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "base/uuid.h"
#include "catalogue/places.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/names.h"
#include "store/values.h"
#include "tables/column_meanings.h"
#include "tables/column_names.h"
#include "tables/csv.h"
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

const SherdField* fieldNamed(const std::string& name) {
  for (const SherdField& field : sherds::sherdFields())
    if (name == field.name) return &field;
  return nullptr;
}

std::string valueOf(const ImportRow& row, const std::string& name) {
  const auto found = row.values.find(name);
  return found == row.values.end() || found->second == kClear ? std::string() : found->second;
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
      const Result<SherdRow> sherd = find(row, refusal);
      if (!sherd) return sherd.error();
      const bool fresh = !*sherd;
      Result<SherdRow> target = fresh ? add(row, refusal) : *sherd;
      if (!target) return target.error();
      entered = *target;
      const Result<bool> changed = change(at, entered, fresh, refusal);
      if (!changed) return changed.error();
      fate = fresh ? RowFate::Fresh : *changed ? RowFate::Changed : RowFate::Same;
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
    report_.changes.insert(report_.changes.end(), done_.begin(), done_.end());
    report_.undo.insert(report_.undo.end(), undo_.rbegin(), undo_.rend());  // turned at the end
    return {};
  }

  Result<void> tellLostJoins() {
    const Result<std::vector<std::string>> lost = joins_.lost(catalogue_);
    if (!lost) return lost.error();
    if (!lost->empty())
      report_.warnings.push_back(
          "Joins with rows that were not imported are left out: " + joined(*lost, ", ") +
          "; correct these rows, then import the table again.");
    return {};
  }

 private:
  static Error refuse(Refusal& refusal, std::string column, std::string value, std::string reason) {
    refusal.column = std::move(column);
    refusal.value = std::move(value);
    refusal.reason = reason;
    return {ErrorCode::UnusableInput, std::move(reason), {}};
  }

  Result<SherdRow> find(const ImportRow& row, Refusal& refusal) {
    const std::string number = valueOf(row, "number"), uuid = valueOf(row, "uuid");
    if (number.empty() && uuid.empty())
      return refuse(refusal, "number", "", "The row has neither a number nor a uuid.");
    for (const auto& [column, value] : {std::pair("number", number), std::pair("uuid", uuid)})
      if (!value.empty() && !seen_[column].insert(store::uniqueKey(value)).second)
        return refuse(refusal, column, value, "This appears in two rows of the table.");
    SherdRow by_uuid, by_number;
    if (!uuid.empty()) {
      if (!isUuid(uuid)) return refuse(refusal, "uuid", uuid, "Not a uuid.");
      const Result<SherdRow> found = sherds::Sherds(catalogue_).byId(uuid);
      if (!found) return found.error();
      by_uuid = *found;
    }
    if (!number.empty()) {
      const Result<SherdRow> found = sherds::Sherds(catalogue_).byNumber(number);
      if (!found) return found.error();
      by_number = *found;
    }
    if (by_number && !uuid.empty() && by_uuid != by_number)
      return refuse(refusal, "number", number,
                    "The number and the uuid belong to different sherds.");
    return by_uuid ? by_uuid : by_number;
  }

  Result<SherdRow> add(const ImportRow& row, Refusal& refusal) {
    if (valueOf(row, "context").empty() && !valueOf(row, "number").empty())
      return refuse(refusal, "context", "", "A new sherd needs its context.");
    SherdRecord record;
    record.id = store::uniqueKey(valueOf(row, "uuid"));
    record.batch = row.batch;
    return sherds::Sherds(catalogue_).add(record, provenance_);
  }

  Result<bool> change(std::size_t at, SherdRow sherd, bool fresh, Refusal& refusal) {
    const ImportRow& row = rows_[at];
    if (makes_places_) {
      const std::string site = valueOf(row, "site"), context = valueOf(row, "context");
      if (!site.empty() && !context.empty()) {
        const auto place = places_.context(site, valueOf(row, "trench"), context);
        if (!place) return refuse(refusal, "context", context, place.error().sentence());
        const std::string bag = valueOf(row, "bag");
        if (!bag.empty())
          if (const auto made = places_.bag(*place, bag); !made)
            return refuse(refusal, "bag", bag, made.error().sentence());
      }
    }
    const Result<SherdRecord> now = sherds::Sherds(catalogue_).get(sherd);
    if (!now) return now.error();
    std::vector<FieldChange> changes;
    const bool confirmed =
        options_.asked_rows == AskedRows::Enter || options_.confirmed_lines.contains(row.line);
    const Confirmation confirmation = confirmed ? Confirmation::Given : Confirmation::None;
    for (const auto& [name, typed] : row.values) {
      if (typed.empty() || name == "joins") continue;
      const SherdField* field = fieldNamed(name);
      if (field && !field->editable) continue;
      if (name == "number" && store::uniqueKey(typed) == store::uniqueKey(now->number))
        continue;  // capitals make no difference
      const std::string value = typed == kClear ? std::string() : typed;
      // Else a measure of the program, rounded in a table, would come back as a person's.
      const std::string before = sherds::textOf(*now, name);
      if (field && field->kind == FieldKind::Number && !before.empty() &&
          showsInTable(value, *store::parsedNumber(before)))
        continue;
      if (field && field->kind == FieldKind::Number && row.comma_separates)
        if (const Result<void> clear = readsOneWay(value); !clear)
          return refuse(refusal, name, value, clear.error().sentence());
      const bool by_program =
          field && field->kind == FieldKind::Number && row.by_hand && !row.by_hand->contains(name);
      if (by_program && fresh && store::parsedNumber(value)) {
        if (const Result<void> done = measureByProgram({sherd, name, value}, refusal); !done)
          return done.error();
        continue;
      }
      if (by_program && !fresh) {  // a table of before the latest computation
        const Result<std::vector<double>> computed =
            sherds::Measurements(catalogue_).everComputed(sherd, kindOf(name));
        if (!computed) return computed.error();
        if (std::any_of(computed->begin(), computed->end(),
                        [&](double one) { return showsInTable(value, one); }))
          continue;
      }
      const std::string own = field ? name : name.starts_with("extra.") ? name : "extra." + name;
      if (value != sherds::textOf(*now, own)) changes.push_back({sherd, own, value, confirmation});
    }
    const auto joins = joins_.of(at, *now, catalogue_);
    if (!joins) return refuse(refusal, "joins", valueOf(row, "joins"), joins.error().sentence());
    if (*joins && std::set((*joins)->begin(), (*joins)->end()) !=
                      std::set(now->joins.begin(), now->joins.end())) {
      std::vector<std::string> ids;
      for (const SherdRow partner : **joins) {
        const Result<SherdRecord> other = sherds::Sherds(catalogue_).get(partner);
        if (!other) return other.error();
        ids.push_back(other->id);
      }
      changes.push_back({sherd, "joins", store::joinTerms(ids)});
    }
    bool changed = false;
    if (!changes.empty()) {
      const Result<std::vector<FieldChange>> undo =
          sherds::SherdChanges(catalogue_).apply(changes, provenance_);
      if (!undo) return named(changes, undo.error(), refusal);
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
      const auto before = now->measures.find(m.kind);
      changed |= before == now->measures.end() || before->second != m.value;
      if (const Result<void> done = sherds::Measurements(catalogue_).add(m, by); !done)
        return refuse(refusal, m.kind, {}, done.error().sentence());
    }
    return changed;
  }

  static std::string kindOf(const std::string& field) {  // rim_pct, beside length_mm
    return records::unitOf(field).empty() ? field.substr(0, field.rfind('_')) : field;
  }

  // Computed where the table comes from: it gives way to what is computed or measured here.
  Result<void> measureByProgram(const FieldChange& number, Refusal& refusal) {
    const auto shown = sherds::SherdChanges(catalogue_)
                           .preview(std::span(&number, 1));  // as strict as with typed ones
    if (!shown) return shown.error();
    if (!shown->front().refusal.empty())
      return refuse(refusal, number.field, number.value, shown->front().refusal);
    records::Measurement m;
    m.sherd = number.sherd;
    m.kind = kindOf(number.field);
    m.value = *store::parsedNumber(number.value);
    Provenance by = provenance_;
    by.person = {};
    return sherds::Measurements(catalogue_).add(m, by);
  }

  // Which column it was.
  Error named(const std::vector<FieldChange>& changes, const Error& error, Refusal& refusal) {
    const auto shown = sherds::SherdChanges(catalogue_).preview(changes);
    if (!shown) return error;
    for (const records::ChangePreview& change : *shown)
      if (!change.refusal.empty())
        return refuse(refusal, change.change.field, change.change.value, change.refusal);
    for (const records::ChangePreview& change : *shown)
      if (change.asks()) {
        asks_ = true;
        return refuse(refusal, change.change.field, change.change.value, change.question);
      }
    return error;
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
  std::map<std::string, std::set<std::string>> seen_;
  std::map<std::string, store::PersonRow> persons_;
};

Result<void> checkColumns(const CsvTable& table, const std::string& where) {
  std::set<std::string> seen;
  for (const std::string& column : table.columns) {
    if (column.empty())
      return Error{ErrorCode::UnusableInput, "A column of the table has no name.", where};
    if (!seen.insert(column).second)
      return Error{ErrorCode::UnusableInput, "The column '" + column + "' appears twice.", where};
  }
  return {};
}

std::vector<ImportRow> sherdRowsOf(const CsvTable& table) {
  std::vector<ImportRow> rows;
  for (const CsvRow& read : table.rows) {
    ImportRow row{read.line, {}, {}};
    row.comma_separates = table.separator == ',';
    for (std::size_t i = 0; i < read.values.size(); ++i) {
      if (table.columns[i] != "measured_by_hand") {
        row.values[table.columns[i]] = read.values[i];
        continue;
      }
      const std::vector<std::string> columns = store::splitTerms(read.values[i]);
      row.by_hand.emplace(columns.begin(), columns.end());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// Takes out the rows that do not fit the header.
std::vector<Refusal> takeBroken(CsvTable& table) {
  std::vector<Refusal> broken;
  std::erase_if(table.rows, [&](const CsvRow& row) {
    if (row.values.size() == table.columns.size()) return false;
    broken.push_back({row.line,
                      {},
                      {},
                      "The row has " + std::to_string(row.values.size()) +
                          " values, but the header has " + std::to_string(table.columns.size()) +
                          "."});
    return true;
  });
  return broken;
}

void addBroken(ImportReport& report, const std::vector<Refusal>& broken) {
  report.refused += static_cast<int>(broken.size());
  for (const Refusal& refusal : broken) report.rows.emplace_back(refusal.line, RowFate::Refused);
  std::sort(report.rows.begin(), report.rows.end());
  report.refusals.insert(report.refusals.end(), broken.begin(), broken.end());
  std::stable_sort(report.refusals.begin(), report.refusals.end(),
                   [](const Refusal& a, const Refusal& b) { return a.line < b.line; });
}

// A refusal names the column as the table does.
void nameColumns(std::vector<Refusal>& refusals, const TableMapping& mapping) {
  for (Refusal& refusal : refusals)
    for (const ColumnChoice& choice : mapping.columns)
      if (!choice.field.empty() && choice.field == refusal.column) {
        refusal.column = choice.column;
        break;
      }
}

// A column that has no field: its name says nothing, or another one has its field.
std::string ownField(const ColumnChoice& choice, const TableMapping& mapping) {
  std::string field = fieldOfColumn(choice.column, mapping.of_contexts);
  if (field.empty()) field = fieldOfColumn(nameAndUnit(choice.column).name, mapping.of_contexts);
  for (const ColumnChoice& other : mapping.columns)
    if (!field.empty() && other.field == field && other.column != choice.column)
      return "The column '" + choice.column + "' means the same as '" + other.column +
             "'; its values are kept as a custom field.";
  return "The column '" + choice.column + "' is unknown; its values are kept as a custom field.";
}

}  // namespace

Result<void> previewOrEnter(Catalogue& catalogue, ImportMode mode,
                            const std::function<Result<void>()>& work) {
  bool whole = false;
  const Result<void> done = catalogue.together([&]() -> Result<void> {
    if (Result<void> worked = work(); !worked) return worked;
    whole = true;
    if (mode == ImportMode::Enter) return {};
    return Error{ErrorCode::Cancelled, "The preview was undone.", {}};
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

Result<ImportReport> importTable(Catalogue& catalogue, std::string_view bytes,
                                 const std::string& where, const ImportOptions& options,
                                 const Provenance& provenance, Progress& progress,
                                 std::stop_token stop) {
  Result<CsvTable> table = parseCsv(bytes, where);
  if (!table) return table.error();
  if (Result<void> good = checkColumns(*table, where); !good) return good.error();
  const Result<TableMapping> mapping = mapColumns(catalogue, *table, options.columns, where);
  if (!mapping) return mapping.error();
  ImportOptions named = options;
  if (named.source.empty()) named.source = where;
  const std::vector<Refusal> broken = takeBroken(*table);
  const CsvTable own = mapped(*table, *mapping);
  Result<ImportReport> report =
      mapping->of_contexts
          ? importContexts(catalogue, own, named, provenance, progress, stop)
          : importSherds(catalogue, sherdRowsOf(own), named, provenance, progress, stop);
  if (!report) return report;
  addBroken(*report, broken);
  nameColumns(report->refusals, *mapping);
  nameColumns(report->questions, *mapping);
  for (const ColumnChoice& choice : mapping->columns)
    if (choice.by == ChosenBy::Nobody) report->warnings.push_back(ownField(choice, *mapping));
  if (options.mode == ImportMode::Enter)
    if (Result<void> saved = rememberColumns(catalogue, *mapping); !saved) return saved.error();
  report->mapping = *mapping;
  return report;
}

std::string refusalsCsv(const ImportReport& report) {
  std::string text = csvLine({"line", "column", "value", "reason"});
  for (const auto* list : {&report.refusals, &report.questions})
    for (const Refusal& refusal : *list)
      text += csvLine({std::to_string(refusal.line), guarded(refusal.column),
                       guarded(refusal.value), refusal.reason});
  return text;
}

}  // namespace ostraka::tables
