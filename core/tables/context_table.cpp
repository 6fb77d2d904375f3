// Sites, trenches, contexts and bags from a table.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "files/json_text.h"
#include "store/database.h"
#include "store/names.h"
#include "store/values.h"
#include "tables/csv.h"
#include "tables/import_table.h"
#include "tables/portions.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;
using store::valueOrThrow;

Error unknownContext(const std::string& number) {
  return Error::unusable(
      message("There is no context %1; create it or let the import create it.", number));
}
Error unknownBag(const std::string& number) {
  return Error::unusable(
      message("There is no bag %1; create it or let the import create it.", number));
}

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

std::vector<SavedField> fieldsOf(const records::ContextRecord& c) {
  return {{"kind", c.kind},           {"excavated_on", c.excavated_on}, {"period", c.period},
          {"date_edtf", c.date_edtf}, {"closed", c.closedWord()},       {"note", c.note},
          {"extra", c.extra_json}};
}

std::vector<SavedField> fieldsOf(const records::BagRecord& b) {
  return {{"collected_on", b.collected_on},
          {"storage", b.storage},
          {"weight_g", optionalText(b.weight_g)},
          {"count_written", optionalText(b.count_written)}};
}

template <class Record>
void addDifferences(std::vector<ChangedValue>& changed, const std::string& name,
                    const Record& before, const Record& after) {
  const std::vector<SavedField> then = fieldsOf(before), now = fieldsOf(after);
  for (std::size_t i = 0; i < now.size(); ++i)
    if (then[i].value != now[i].value)
      changed.push_back({name, now[i].name, then[i].value, now[i].value});
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

// What was there before, and is another now. Throws Refused where the row cannot be looked at to
// its end.
std::vector<ChangedValue> enterRow(Catalogue& catalogue, Places& places, const Values& values,
                                   const records::Provenance& provenance, Faults& faults) {
  catalogue::Places known(catalogue);
  const auto row =
      valueOrThrow(places.context(values.raw("site"), values.raw("trench"), values.raw("context")));
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
  std::vector<ChangedValue> changed;
  addDifferences(changed, placeOf(context), found, context);
  const std::string number = values.raw("bag");
  if (number.empty()) return changed;
  const Result<store::BagRow> bag_row = places.bag(row, number);
  if (!checked(bag_row, "bag", faults)) return changed;
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
  addDifferences(changed, placeOf(context) + ", bag " + bag.number, before, bag);
  return changed;
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
        report_(report),
        places_(catalogue, UnknownPlaces::Make, provenance) {
  }  // a table of contexts is there to make them

  Result<void> row(const CsvRow& row) {
    Faults faults;
    for (std::size_t i = 0; i < row.values.size(); ++i)
      if (const auto good = store::checkedText(row.values[i]); !good)
        faults.emplace_back(table_.columns[i], good.error().what);
    const Values values(table_, row, unclear_);
    const auto known =
        catalogue::Places(catalogue_)
            .contextByPlace(values.raw("site"), values.raw("trench"), values.raw("context"));
    const bool fresh = !known || !*known;
    const std::int64_t before = History(catalogue_).length();
    std::vector<ChangedValue> changed_values;
    const Result<void> entered = catalogue_.together([&]() -> Result<void> {
      if (faults.empty())
        changed_values = enterRow(catalogue_, places_, values, provenance_, faults);
      return faults.empty() ? Result<void>() : Error::unusable(faults.front().second);
    });
    if (!entered && entered.error().code != ErrorCode::UnusableInput) return entered;
    if (!entered) {
      places_.forget();
      places_.forgetMade();
      if (faults.empty()) faults.emplace_back("context", entered.error().sentence());
      ++report_.refused;
      report_.rows.emplace_back(row.line, RowFate::Refused);
      for (auto& [column, reason] : faults)
        report_.refusals.push_back({row.line, column, values.raw(column), std::move(reason)});
      return {};
    }
    const bool changed = History(catalogue_).length() > before;
    ++(fresh ? report_.fresh : changed ? report_.changed : report_.same);
    if (!fresh && changed)
      report_.changed_values.insert(report_.changed_values.end(), changed_values.begin(),
                                    changed_values.end());
    report_.rows.emplace_back(row.line, fresh     ? RowFate::Fresh
                                        : changed ? RowFate::Changed
                                                  : RowFate::Same);
    for (const std::string& place : places_.made()) made_.insert(place);
    places_.forgetMade();
    return {};
  }
  std::vector<std::string> madePlaces() const { return {made_.begin(), made_.end()}; }

 private:
  Catalogue& catalogue_;
  const CsvTable& table_;
  const NumberRemarks& unclear_;
  const records::Provenance& provenance_;
  ImportReport& report_;
  Places places_;
  std::set<std::string> made_;
};

}  // namespace

Result<store::ContextRow> Places::context(const std::string& site_code,
                                          const std::string& trench_code,
                                          const std::string& number) {
  const std::string key = store::uniqueKey(site_code) + "\n" + store::uniqueKey(trench_code) +
                          "\n" + store::uniqueKey(number);
  if (const auto known = known_.find(key); known != known_.end())
    return store::ContextRow{known->second};
  const Result<store::ContextRow> there =
      catalogue::Places(catalogue_).contextByPlace(site_code, trench_code, number);
  if (!there) return there;
  if (*there) {
    known_[key] = there->value;
    return there;
  }
  if (unknown_ == UnknownPlaces::Refuse)
    return unknownContext(site_code + " " + trench_code + " " + number);
  const Result<store::ContextRow> made =
      catalogue::Places(catalogue_).contextAt(site_code, trench_code, number, provenance_, made_);
  if (made) known_[key] = made->value;
  return made;
}

Result<store::BagRow> Places::bag(store::ContextRow context, const std::string& number) {
  const std::string key = std::to_string(context.value) + "\n" + store::uniqueKey(number);
  if (const auto known = known_.find(key); known != known_.end())
    return store::BagRow{known->second};
  const Result<store::BagRow> there = catalogue::Places(catalogue_).bagByNumber(context, number);
  if (!there) return there;
  if (*there) {
    known_[key] = there->value;
    return there;
  }
  if (unknown_ == UnknownPlaces::Refuse) return unknownBag(number);
  records::BagRecord record;
  record.context = context;
  record.number = number;
  const Result<store::BagRow> made = catalogue::Places(catalogue_).save(record, provenance_);
  if (made) known_[key] = made->value;
  return made;
}

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
  return report;
}

}  // namespace ostraka::tables
