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
#include "store/names.h"
#include "store/values.h"
#include "tables/csv.h"
#include "tables/import_table.h"
#include "tables/portions.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;

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
  // The user's own fields with what their columns say.
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

template <class Record, class Row>
Record* byRow(std::vector<Record>& records, Row row) {
  const auto found =
      std::find_if(records.begin(), records.end(), [&](const Record& r) { return r.row == row; });
  return found == records.end() ? nullptr : &*found;
}

void compare(std::vector<ChangedValue>& changed, const std::string& name, const char* field,
             const std::string& before, const std::string& after) {
  if (before != after) changed.push_back({name, field, before, after});
}

std::string placeOf(const records::ContextRecord& context) {
  return context.site_code + " " + (context.trench_code.empty() ? "" : context.trench_code + " ") +
         context.number;
}

std::vector<ChangedValue> differences(const records::ContextRecord& before,
                                      const records::ContextRecord& after) {
  std::vector<ChangedValue> changed;
  const std::string name = placeOf(after);
  compare(changed, name, "kind", before.kind, after.kind);
  compare(changed, name, "excavated_on", before.excavated_on, after.excavated_on);
  compare(changed, name, "period", before.period, after.period);
  compare(changed, name, "date_edtf", before.date_edtf, after.date_edtf);
  compare(changed, name, "closed", before.closed ? "yes" : "no", after.closed ? "yes" : "no");
  compare(changed, name, "note", before.note, after.note);
  compare(changed, name, "extra", before.extra_json, after.extra_json);
  return changed;
}

std::string countText(const std::optional<int>& count) {
  return count ? std::to_string(*count) : std::string();
}

std::string weightText(const std::optional<double>& weight) {
  return weight ? store::numberText(*weight) : std::string();
}

void addDifferences(std::vector<ChangedValue>& changed, const std::string& place,
                    const records::BagRecord& before, const records::BagRecord& after) {
  const std::string name = place + ", bag " + after.number;
  compare(changed, name, "collected_on", before.collected_on, after.collected_on);
  compare(changed, name, "storage", before.storage, after.storage);
  compare(changed, name, "weight_g", weightText(before.weight_g), weightText(after.weight_g));
  compare(changed, name, "count_written", countText(before.count_written),
          countText(after.count_written));
}

// What was there before, and is another now.
Result<std::vector<ChangedValue>> enterRow(Catalogue& catalogue, Places& places,
                                           const Values& values,
                                           const records::Provenance& provenance) {
  const auto row = places.context(values.raw("site"), values.raw("trench"), values.raw("context"));
  if (!row) return row.error();
  Result<records::ContextRecord> found = catalogue::Places(catalogue).context(*row);
  if (!found) return found.error();
  records::ContextRecord context = *found;
  values.text("kind", context.kind);
  values.text("excavated_on", context.excavated_on);
  values.text("period", context.period);
  values.text("date_edtf", context.date_edtf);
  values.text("note", context.note);
  const std::string closed = store::uniqueKey(values.raw("closed"));
  if (!closed.empty() && closed != "yes" && closed != "no" && closed != "<clear>")
    return Error::unusable(message("The column 'closed' accepts only yes or no."));
  if (!closed.empty()) context.closed = closed == "yes";
  context.extra_json = values.extra(context.extra_json);
  if (const auto saved = catalogue::Places(catalogue).save(context, provenance); !saved)
    return saved.error();
  std::vector<ChangedValue> changed = differences(*found, context);
  const std::string number = values.raw("bag");
  if (number.empty()) return changed;
  const auto bag_row = places.bag(*row, number);
  if (!bag_row) return bag_row.error();
  Result<std::vector<records::BagRecord>> bags = catalogue::Places(catalogue).bags(*row);
  if (!bags) return bags.error();
  const records::BagRecord before = *byRow(*bags, *bag_row);
  records::BagRecord bag = before;
  values.text("collected_on", bag.collected_on);
  values.text("storage", bag.storage);
  if (Result<void> weight = values.number("weight_g", bag.weight_g); !weight) return weight.error();
  std::optional<double> count;
  if (bag.count_written) count = *bag.count_written;
  if (Result<void> counted = values.number("count_written", count); !counted)
    return counted.error();
  if (count && (*count < 0 || *count > 1'000'000 || *count != static_cast<int>(*count)))
    return Error::unusable(message("The column 'count_written' accepts only a whole number."));
  bag.count_written = count ? std::optional(static_cast<int>(*count)) : std::nullopt;
  if (const auto saved = catalogue::Places(catalogue).save(bag, provenance); !saved)
    return saved.error();
  addDifferences(changed, placeOf(context), before, bag);
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
    for (std::size_t i = 0; i < row.values.size(); ++i)
      if (const auto good = store::checkedText(row.values[i]); !good) {
        refuse({row.line, table_.columns[i], row.values[i], good.error().what});
        return {};
      }
    const Values values(table_, row, unclear_);
    const auto known =
        catalogue::Places(catalogue_)
            .contextByPlace(values.raw("site"), values.raw("trench"), values.raw("context"));
    const bool fresh = !known || !*known;
    const std::int64_t before = History(catalogue_).length();
    std::vector<ChangedValue> changed_values;
    const Result<void> entered = catalogue_.together([&]() -> Result<void> {
      auto done = enterRow(catalogue_, places_, values, provenance_);
      if (!done) return done.error();
      changed_values = std::move(*done);
      return {};
    });
    if (!entered && entered.error().code != ErrorCode::UnusableInput) return entered;
    if (!entered) {
      places_.forget();
      places_.forgetMade();
      refuse({row.line, "context", values.raw("context"), entered.error().sentence()});
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
  void refuse(Refusal refusal) {
    ++report_.refused;
    report_.rows.emplace_back(refusal.line, RowFate::Refused);
    report_.refusals.push_back(std::move(refusal));
  }

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
  store::SiteRow site;
  const Result<std::vector<records::SiteRecord>> sites = catalogue::Places(catalogue_).sites();
  if (!sites) return sites.error();
  for (const records::SiteRecord& s : *sites)
    if (store::uniqueKey(s.code) == store::uniqueKey(site_code)) site = s.row;
  if (!site) {
    records::SiteRecord record;
    record.code = record.name = site_code;
    const Result<store::SiteRow> made = catalogue::Places(catalogue_).save(record, provenance_);
    if (!made) return made.error();
    site = *made;
    made_.push_back(site_code);
  }
  store::TrenchRow trench;
  if (!trench_code.empty()) {
    const Result<std::vector<records::TrenchRecord>> trenches =
        catalogue::Places(catalogue_).trenches();
    if (!trenches) return trenches.error();
    for (const records::TrenchRecord& t : *trenches)
      if (t.site == site && store::uniqueKey(t.code) == store::uniqueKey(trench_code))
        trench = t.row;
    if (!trench) {
      records::TrenchRecord record;
      record.site = site;
      record.code = trench_code;
      const Result<store::TrenchRow> made = catalogue::Places(catalogue_).save(record, provenance_);
      if (!made) return made.error();
      trench = *made;
      made_.push_back(site_code + " " + trench_code);
    }
  }
  records::ContextRecord record;
  record.site = site;
  record.trench = trench;
  record.number = number;
  const Result<store::ContextRow> made = catalogue::Places(catalogue_).save(record, provenance_);
  if (made) known_[key] = made->value;
  return made;
}

Result<store::BagRow> Places::bag(store::ContextRow context, const std::string& number) {
  const std::string key = std::to_string(context.value) + "\n" + store::uniqueKey(number);
  if (const auto known = known_.find(key); known != known_.end())
    return store::BagRow{known->second};
  const Result<std::vector<records::BagRecord>> bags = catalogue::Places(catalogue_).bags(context);
  if (!bags) return bags.error();
  for (const records::BagRecord& bag : *bags)
    if (store::uniqueKey(bag.number) == store::uniqueKey(number)) {
      known_[key] = bag.row.value;
      return bag.row;
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
