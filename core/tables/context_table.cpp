// Sites, trenches, contexts and bags from a table.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/stamped_rows.h"
#include "catalogue/typed_place.h"
#include "files/json_text.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"
#include "tables/csv.h"
#include "tables/import_table.h"
#include "tables/portions.h"
#include "tables/similar_contexts.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;
using store::valueOrThrow;

// Sets a text from a column: blank keeps, <clear> empties.
class Values {
 public:
  Values(const CsvTable& table, const CsvRow& row, const NumberRemarks& unclear)
      : table_(table), row_(row), unclear_(unclear) {}
  std::string raw(const std::string& column) const {
    const auto found = std::find(table_.columns.begin(), table_.columns.end(), column);
    if (found == table_.columns.end()) return {};
    const auto index = static_cast<std::size_t>(found - table_.columns.begin());
    return index < row_.values.size() ? row_.values[index] : std::string();
  }
  // A column of trenches says also that there is none.
  Result<BagPlace> place(const Catalogue& catalogue) const {
    BagPlace written{raw("site"), raw("trench"), raw("context"), raw("bag")};
    const bool says_all = !written.site.empty() &&
                          std::ranges::find(table_.columns, "trench") != table_.columns.end();
    if (says_all || written.context.empty()) return written;
    return readPlace(catalogue, written);
  }
  void text(const std::string& column, std::string& value) const { take(raw(column), value); }
  // Custom fields with what their columns say.
  std::string extra(const std::string& before) const {
    nlohmann::ordered_json fields = orderedJsonOrDiscarded(before);
    if (!fields.is_object()) fields = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      if (!table_.columns[i].starts_with("extra.")) continue;
      const std::string name = table_.columns[i].substr(6);
      std::string value = fields.contains(name) && fields[name].is_string()
                              ? fields[name].get<std::string>()
                              : std::string();
      take(row_.values[i], value);
      value.empty() ? (void)fields.erase(name) : (void)(fields[name] = value);
    }
    return fields.dump();
  }
  Result<void> number(const std::string& column, std::optional<double>& value) const {
    const std::string read = raw(column);
    if (read.empty()) return {};
    const std::optional<double> before = std::exchange(value, std::nullopt);
    if (read == "<clear>") return {};
    const Result<double> parsed = store::parsedNumber(read);
    if (!parsed) return parsed.error();
    if (const auto remarks = unclear_.find(row_.line);
        remarks != unclear_.end() && before != *parsed)
      if (const auto why = remarks->second.find(column); why != remarks->second.end())
        return Error::unusable(why->second);
    value = *parsed;
    return {};
  }

 private:
  static void take(const std::string& read, std::string& value) {
    if (!read.empty()) value = read == "<clear>" ? std::string() : read;
  }

  const CsvTable& table_;
  const CsvRow& row_;
  const NumberRemarks& unclear_;
};

std::string placeOf(const records::ContextRecord& context) {
  return context.site_code + " " + (context.trench_code.empty() ? "" : context.trench_code + " ") +
         context.number;
}

std::vector<Column> fieldsOf(const records::ContextRecord& c) {
  return {{"kind", c.kind},           {"excavated_on", c.excavated_on}, {"period", c.period},
          {"date_edtf", c.date_edtf}, {"closed", c.closedWord()},       {"note", c.note}};
}

std::vector<Column> fieldsOf(const records::BagRecord& b) {
  return {{"collected_on", b.collected_on},
          {"storage", b.storage},
          {"weight_g", b.weight_g},
          {"count_written", b.count_written}};
}

template <class Record>
void addDifferences(std::vector<ChangedValue>& changed, const std::string& name,
                    const Record& before, const Record& after) {
  const std::vector<Column> then = fieldsOf(before), now = fieldsOf(after);
  for (std::size_t i = 0; i < now.size(); ++i)
    if (const std::string old = then[i].value.told(), is = now[i].value.told(); old != is)
      changed.push_back({name, now[i].name, old, is});
}

// Of a row: columns, and what is wrong with their values.
using Faults = std::vector<std::pair<std::string, Message>>;

// Whether it is good.
template <class Value>
bool checked(const Result<Value>& value, const char* column, Faults& faults) {
  if (value) return true;
  if (value.error().code != ErrorCode::UnusableInput) throw store::Refused(value.error());
  faults.emplace_back(column, value.error().sentence());
  return false;
}

// Custom fields, as the columns of tables call them.
void addOwnDifferences(std::vector<ChangedValue>& changed, const std::string& name,
                       const std::string& before, const std::string& after) {
  const nlohmann::json then = jsonOrDiscarded(before), now = jsonOrDiscarded(after);
  const auto valueIn = [](const nlohmann::json& fields, const std::string& key) {
    if (!fields.is_object() || !fields.contains(key)) return std::string();
    return fields[key].is_string() ? fields[key].get<std::string>() : fields[key].dump();
  };
  std::set<std::string> keys;
  for (const nlohmann::json* fields : {&then, &now})
    for (const auto& field : fields->items()) keys.insert(field.key());
  for (const std::string& key : keys)
    if (const std::string old = valueIn(then, key), is = valueIn(now, key); old != is)
      changed.push_back({name, "extra." + key, old, is});
}

struct EnteredRow {
  bool fresh = false;  ///< its context or its bag was not there
  bool fresh_context = false;
  std::vector<ChangedValue> changed;  ///< what was there before, and is another now
};

// Throws Refused where the row cannot be looked at to its end.
EnteredRow enterRow(Catalogue& catalogue, const BagPlace& place, const Values& values,
                    const records::Provenance& provenance, Faults& faults,
                    std::vector<std::string>& made) {
  Places known(catalogue);
  EnteredRow entered;
  entered.fresh_context =
      !valueOrThrow(known.contextByPlace(place.site, place.trench, place.context));
  const auto row =
      valueOrThrow(known.contextAt(place.site, place.trench, place.context, provenance, made));
  const records::ContextRecord found = valueOrThrow(known.context(row));
  records::ContextRecord context = found;
  values.text("kind", context.kind);
  values.text("excavated_on", context.excavated_on);
  values.text("period", context.period);
  values.text("date_edtf", context.date_edtf);
  values.text("note", context.note);
  const std::string closed = store::uniqueKey(values.raw("closed"));
  if (!closed.empty() && closed != "yes" && closed != "no" && closed != "<clear>")
    faults.emplace_back("closed", message("The column 'closed' accepts only yes or no."));
  if (closed == "<clear>")
    context.closed.reset();
  else if (!closed.empty())
    context.closed = closed == "yes";
  context.extra_json = values.extra(context.extra_json);
  if (!checked(store::checkedDay(context.excavated_on), "excavated_on", faults))
    context.excavated_on = found.excavated_on;
  if (!checked(store::checkedEdtf(context.date_edtf), "date_edtf", faults))
    context.date_edtf = found.date_edtf;
  checked(known.save(context, provenance), "context", faults);
  entered.fresh = entered.fresh_context;
  if (!entered.fresh) {
    addDifferences(entered.changed, placeOf(context), found, context);
    addOwnDifferences(entered.changed, placeOf(context), found.extra_json, context.extra_json);
  }
  if (place.bag.empty()) return entered;
  const bool fresh_bag = !valueOrThrow(known.bagByNumber(row, place.bag));
  const Result<store::BagRow> bag_row = known.bagAt(row, place.bag, provenance);
  if (!checked(bag_row, "bag", faults)) return entered;
  const std::vector<records::BagRecord> bags = valueOrThrow(known.bags(row));
  const records::BagRecord before = *std::ranges::find(bags, *bag_row, &records::BagRecord::row);
  records::BagRecord bag = before;
  values.text("collected_on", bag.collected_on);
  values.text("storage", bag.storage);
  if (!checked(store::checkedDay(bag.collected_on), "collected_on", faults))
    bag.collected_on = before.collected_on;
  checked(values.number("weight_g", bag.weight_g), "weight_g", faults);
  std::optional<double> count;
  if (bag.count_written) count = *bag.count_written;
  checked(values.number("count_written", count), "count_written", faults);
  if (count && (*count < 0 || *count > 1'000'000 || *count != static_cast<int>(*count))) {
    faults.emplace_back("count_written",
                        message("The column 'count_written' accepts only a whole number."));
    count.reset();
  }
  bag.count_written = count ? std::optional(static_cast<int>(*count)) : std::nullopt;
  checked(known.save(bag, provenance), "bag", faults);
  if (!fresh_bag)
    addDifferences(entered.changed, placeOf(context) + ", bag " + bag.number, before, bag);
  entered.fresh = entered.fresh || fresh_bag;
  return entered;
}

// Each row whole or not at all, and what became of it.
class ContextRows {
 public:
  ContextRows(Catalogue& catalogue, const CsvTable& table, const NumberRemarks& unclear,
              const records::Provenance& provenance, ImportReport& report)
      : catalogue_(catalogue),
        table_(table),
        unclear_(unclear),
        provenance_(provenance),
        report_(report) {}

  Result<void> row(const CsvRow& row) {
    Faults faults;
    for (std::size_t i = 0; i < row.values.size(); ++i)
      if (const auto good = store::checkedText(row.values[i]); !good)
        faults.emplace_back(table_.columns[i], good.error().what);
    const Values values(table_, row, unclear_);
    const Result<BagPlace> place = values.place(catalogue_);
    if (!place && place.error().code != ErrorCode::UnusableInput) return place.error();
    if (!place) faults.emplace_back("context", place.error().sentence());
    const std::int64_t before = History(catalogue_).length();
    EnteredRow of_row;
    std::vector<std::string> made;
    const Result<void> entered = catalogue_.together([&]() -> Result<void> {
      if (faults.empty()) of_row = enterRow(catalogue_, *place, values, provenance_, faults, made);
      return faults.empty() ? Result<void>() : Error::unusable(faults.front().second);
    });
    if (!entered && entered.error().code != ErrorCode::UnusableInput) return entered;
    if (!entered) {
      if (faults.empty()) faults.emplace_back("context", entered.error().sentence());
      report_.add(row.line, RowFate::Refused);
      for (auto& [column, reason] : faults)
        report_.refusals.push_back({row.line, column, values.raw(column), std::move(reason)});
      return {};
    }
    const bool changed = History(catalogue_).length() > before;
    report_.add(row.line, of_row.fresh ? RowFate::Fresh
                          : changed    ? RowFate::Changed
                                       : RowFate::Same);
    for (ChangedValue& value : of_row.changed) {
      value.line = row.line;
      report_.changed_values.push_back(std::move(value));
    }
    made_.insert(made.begin(), made.end());
    return of_row.fresh_context ? similar_.note(catalogue_, *place) : Result<void>();
  }
  std::vector<std::string> madePlaces() const { return {made_.begin(), made_.end()}; }
  std::optional<Message> similarContexts() const { return similar_.warning(); }

 private:
  Catalogue& catalogue_;
  const CsvTable& table_;
  const NumberRemarks& unclear_;
  const records::Provenance& provenance_;
  ImportReport& report_;
  SimilarContexts similar_;
  std::set<std::string> made_;  ///< codes of sites ("ARM1") and trenches ("ARM1 T3")
};

}  // namespace

Result<ImportReport> importContexts(Catalogue& catalogue, const CsvTable& table,
                                    const NumberRemarks& unclear, const ImportOptions& options,
                                    const records::Provenance& provenance, Progress& progress,
                                    std::stop_token stop) {
  ImportReport report;
  ContextRows entering(catalogue, table, unclear, provenance, report);
  const Result<std::size_t> entered =
      enterInPortions(catalogue, table.rows.size(), options, progress, stop,
                      [&](std::size_t i) { return entering.row(table.rows[i]); });
  if (!entered) return entered.error();
  report.not_reached = static_cast<int>(table.rows.size() - *entered);
  if (const std::vector<std::string> made = entering.madePlaces(); !made.empty())
    report.warnings.push_back(
        message("New sites and trenches: %1; check for typos.", joined(made, ", ")));
  if (auto warning = entering.similarContexts()) report.warnings.push_back(std::move(*warning));
  return report;
}

}  // namespace ostraka::tables
