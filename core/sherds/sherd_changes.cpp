#include "sherds/sherd_changes.h"

#include <algorithm>
#include <map>
#include <unordered_set>

#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/search.h"
#include "catalogue/settings.h"
#include "catalogue/typed_place.h"
#include "records/words.h"
#include "sherds/measurements.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/names.h"
#include "store/values.h"

namespace ostraka::sherds {
namespace {
using store::refuse;
constexpr double kMostMillimetres = 1000, kMostGrams = 20'000;
constexpr const char* kPlusMinus = " ± ";  // as values and the history show it

// A change that was looked at: what the preview shows, and what is needed to do it.
struct Examined {
  records::ChangePreview shown;
  const SherdColumn* column = nullptr;  ///< null for custom fields
  double number = 0;
  store::ContextRow context;  ///< of a place, once for all its parts
  store::BagRow bag;
  std::vector<store::SherdRow> joins;
  std::optional<double> uncertainty = std::nullopt;  ///< of a measure typed as 12.5 ± 0.4; 0: none
  bool changes() const { return shown.old_value != shown.new_value; }
};

class Examination {
 public:
  explicit Examination(const catalogue::Catalogue& catalogue) : catalogue_(catalogue) {}

  /// All changes of one sherd, which are looked at together: the parts of a place belong together.
  void sherd(const records::SherdRecord& sherd, std::vector<Examined*> changes) {
    bool place = false;
    for (Examined* change : changes) {
      try {
        one(sherd, *change);
      } catch (const store::Refused& refused) {
        change->shown.refusal = refused.error.what;
      }
      place |= change->column && change->column->field.kind == records::FieldKind::Place;
    }
    askAboutMeasures(sherd, changes);
    if (!place) return;
    try {
      placeOf(sherd, changes);
    } catch (const store::Refused& refused) {
      for (Examined* change : changes)
        if (change->column && change->column->field.kind == records::FieldKind::Place)
          change->shown.refusal = refused.error.what;
    }
  }

 private:
  void one(const records::SherdRecord& sherd, Examined& change) {
    const std::string& field = change.shown.change.field;
    change.shown.old_value = textOf(sherd, field);
    if (!holdsExpected(sherd, change.shown.change))
      throw store::Refused(Error::changedMeanwhile(field));
    std::string& value = change.shown.new_value;
    value = store::valueOrThrow(store::checkedText(change.shown.change.value));
    if (field.starts_with("extra.") && field.size() > 6) return;
    change.column = sherdColumn(field);
    if (!change.column) refuse(message("There is no field '%1'.", field));
    const records::SherdField& known = change.column->field;
    if (!known.editable) refuse(message("The field %1 is read-only: the program sets it.", field));
    switch (known.kind) {
      case records::FieldKind::Text:
        if (field == "number") number(sherd, change);
        break;
      case records::FieldKind::Term:
        if (!value.empty()) value = term(known.vocabulary, value);
        break;
      case records::FieldKind::Terms:
        terms(known.vocabulary, value);
        break;
      case records::FieldKind::Munsell:
        value = store::valueOrThrow(store::checkedMunsell(value));
        break;
      case records::FieldKind::Edtf:
        value = store::valueOrThrow(store::checkedEdtf(value));
        break;
      case records::FieldKind::Day:
        value = store::valueOrThrow(store::checkedDay(value));
        break;
      case records::FieldKind::Number:
        if (!value.empty()) measure(sherd.row, change);
        break;
      case records::FieldKind::Place:
        break;  // together with the sherd's other changes
      case records::FieldKind::Joins:
        joins(sherd, change);
        break;
    }
  }

  bool holdsExpected(const records::SherdRecord& sherd, const records::FieldChange& change) const {
    if (!change.expected) return true;
    const SherdColumn* column = sherdColumn(change.field);
    // A joined sherd may have got another number: it is the same sherd.
    if (column && column->field.kind == records::FieldKind::Joins)
      return joined(*change.expected, sherd) == joined(textOf(sherd, change.field), sherd);
    std::string now = textOf(sherd, change.field);
    if (column && column->measure && change.expected->find(kPlusMinus) != std::string::npos)
      now += kPlusMinus + store::numberText(uncertaintyOf(sherd.row, column->measure));
    return now == *change.expected;
  }

  void number(const records::SherdRecord& sherd, Examined& change) {
    const std::string& value = change.shown.new_value;
    if (sherd.state == records::SherdState::Void && value != sherd.number)
      refuse(message("A void sherd keeps its number."));
    if (value.empty() || value == sherd.number) return;
    store::valueOrThrow(store::checkedNumber(value));
    const Taken taken = takenBy(catalogue_.database(), value);
    const std::string key = store::uniqueKey(value);
    const auto [earlier, first] = numbers_.emplace(key, sherd.row);
    if (!first && earlier->second != sherd.row)
      refuse(message("The number %1 would be assigned twice.", value));
    if (!taken.sherd) return notOnAPlate(sherd, value);
    if (taken.sherd == sherd.row && !taken.slug_only) return;
    change.shown.in_the_way = taken.sherd;
    const Result<records::SherdRecord> other = Sherds(catalogue_).get(taken.sherd);
    if (taken.slug_only)
      refuse(message("The files of %1 would have the same names as those of %2.", value,
                     taken.number));
    if (other && other->number != taken.number)
      refuse(message("The number %1 was assigned before and is never reused.", value));
    refuse(message("The number %1 belongs to another sherd.", value));
  }

  // Else it would be written on two sherds.
  void notOnAPlate(const records::SherdRecord& sherd, const std::string& number) {
    if (!waiting_) waiting_ = typedAndWaiting(catalogue_);
    const auto plate = waiting_->find(store::uniqueKey(number));
    if (plate != waiting_->end() && plate->second != sherd.batch_number)
      refuse(message("The number %1 was entered for a sherd of %2, which is not processed yet.",
                     number, plate->second));
  }

  // The term itself, also when a label of another language or capitals were typed.
  std::string term(const std::string& vocabulary, const std::string& typed) {
    auto& known = vocabularies_[vocabulary];
    if (known.empty())
      for (const records::Term& entry :
           store::valueOrThrow(catalogue::Settings(catalogue_).vocabulary(vocabulary))) {
        known.emplace(store::uniqueKey(entry.term), entry.term);
        for (const auto& [language, label] : entry.labels)
          known.emplace(store::uniqueKey(label), entry.term);
      }
    const auto found = known.find(store::uniqueKey(typed));
    if (found != known.end()) return found->second;
    refuse(records::notATerm(
        typed, store::valueOrThrow(catalogue::Settings(catalogue_).vocabulary(vocabulary))));
  }

  void terms(const std::string& vocabulary, std::string& value) {
    std::vector<std::string> canonical;
    std::unordered_set<std::string> said;
    for (const std::string& typed : store::splitTerms(value)) {
      std::string known = term(vocabulary, typed);
      if (said.insert(known).second) canonical.push_back(std::move(known));
    }
    value = store::joinTerms(canonical);
  }

  void measure(store::SherdRow sherd, Examined& change) {
    const std::string unit = records::unitOf(change.column->measure);
    const auto [value, half] = store::splitPlusMinus(change.shown.new_value);
    change.number = store::valueOrThrow(store::parsedNumber(value));
    if (half) change.uncertainty = store::valueOrThrow(store::parsedNumber(*half));
    if (change.uncertainty.value_or(0) < 0)
      refuse(message("Enter a value greater than 0 after ±, or 0 if the uncertainty is unknown."));
    if (!(change.number > 0)) refuse(message("Enter a value greater than 0."));
    if (unit == "mm" && change.number > kMostMillimetres)
      refuse(message("No sherd is larger than 1000 mm; check that the value is in millimetres."));
    if (unit == "g" && change.number > kMostGrams)
      refuse(message("No sherd is heavier than 20 kg; check that the value is in grams."));
    if (unit == "pct" && change.number > 100) refuse(message("A share cannot exceed 100 %."));
    change.shown.new_value = store::numberText(change.number);
    if (change.uncertainty) showUncertainty(sherd, change);
  }

  // Where it becomes another; so it is a change of a value that stays, too.
  void showUncertainty(store::SherdRow sherd, Examined& change) {
    const double old = uncertaintyOf(sherd, change.column->measure);
    if (old == *change.uncertainty) return;
    const bool stays = change.shown.old_value == change.shown.new_value;
    if (old > 0 || stays) change.shown.old_value += kPlusMinus + store::numberText(old);
    if (*change.uncertainty > 0 || stays)
      change.shown.new_value += kPlusMinus + store::numberText(*change.uncertainty);
  }

  double uncertaintyOf(store::SherdRow sherd, const std::string& kind) const {
    for (const records::Measurement& m : store::valueOrThrow(Measurements(catalogue_).of(sherd)))
      if (m.kind == kind) return m.uncertainty.value_or(0);
    return 0;
  }

  // Together: a length and a width that change at once are compared with each other.
  void askAboutMeasures(const records::SherdRecord& sherd, const std::vector<Examined*>& changes) {
    records::MeasureValues measured = sherd.measures;
    std::vector<std::string> kinds;
    for (const Examined* change : changes) {
      if (!change->column || !change->column->measure || !change->shown.refusal.empty()) continue;
      const std::string kind = change->column->measure;
      if (change->shown.new_value.empty())
        measured.erase(kind);
      else
        measured[kind] = change->number;
      if (change->changes()) kinds.push_back(kind);
    }
    if (kinds.empty()) return;
    const ComputedMeasures computed = computedMeasures(catalogue_, sherd.row);
    for (Examined* change : changes) {
      if (!change->column || !change->column->measure || !change->changes() ||
          !change->shown.refusal.empty())
        continue;
      const std::string kind = change->column->measure;
      std::vector<records::MeasureFinding>& findings = change->shown.findings;
      const bool deletes = change->shown.new_value.empty();
      // To take the computed value again needs no reason.
      if (!deletes && computed.values.contains(kind) && !computed.current.contains(kind) &&
          computed.values.at(kind) == change->number)
        continue;
      findings = records::implausible({kind}, measured, computed.values);
      const auto doubt = deletes ? records::MeasureDoubt::DeletesComputed
                                 : records::MeasureDoubt::ReplacesComputed;
      if (computed.current.contains(kind))
        findings.push_back({doubt, kind, change->number, {}, computed.values.at(kind)});
      for (const records::MeasureFinding& finding : findings)
        change->shown.question = change->shown.question.empty()
                                     ? records::sentenceOf(finding)
                                     : inOne(change->shown.question, records::sentenceOf(finding));
    }
  }

  std::vector<store::SherdRow> joined(const std::string& typed,
                                      const records::SherdRecord& sherd) const {
    std::vector<store::SherdRow> joins;
    for (const std::string& name : store::splitTerms(typed)) {
      store::SherdRow other = store::valueOrThrow(Sherds(catalogue_).byNumber(name));
      if (!other) other = store::valueOrThrow(Sherds(catalogue_).byId(name));
      if (!other) refuse(message("There is no sherd %1 to join.", name));
      if (other == sherd.row) refuse(message("A sherd cannot join itself."));
      joins.push_back(other);
    }
    std::sort(joins.begin(), joins.end());
    joins.erase(std::unique(joins.begin(), joins.end()), joins.end());
    return joins;
  }

  void joins(const records::SherdRecord& sherd, Examined& change) {
    std::vector<std::string> numbers;
    change.joins = joined(change.shown.new_value, sherd);
    std::vector<std::pair<std::string, std::string>> sorted;
    for (const records::SherdRecord& other :
         store::valueOrThrow(Sherds(catalogue_).of(change.joins))) {
      const std::string& name = other.number.empty() ? other.id : other.number;
      sorted.emplace_back(store::sortKey(name), name);
    }
    std::sort(sorted.begin(), sorted.end());
    for (auto& [key, name] : sorted) numbers.push_back(name);
    change.shown.new_value = store::joinTerms(numbers);
  }

  // Site, trench, context and bag as they would be, found in the catalogue.
  void placeOf(const records::SherdRecord& sherd, const std::vector<Examined*>& changes) {
    catalogue::BagPlace wanted{sherd.site, sherd.trench, sherd.context_number, sherd.bag_number};
    const std::map<std::string, std::string*> parts = {{"site", &wanted.site},
                                                       {"trench", &wanted.trench},
                                                       {"context", &wanted.context},
                                                       {"bag", &wanted.bag}};
    for (const Examined* change : changes)
      if (const auto part = parts.find(change->shown.change.field); part != parts.end())
        *part->second = change->shown.new_value;
    store::ContextRow context;
    store::BagRow bag;
    // A sherd has its site and trench by its context.
    const std::string codes = wanted.site + wanted.trench;
    if (wanted.context.empty() && !codes.empty() && codes != sherd.site + sherd.trench)
      refuse(message("Enter the context with its site and trench, such as KT26-A-012."));
    if (!wanted.context.empty()) {
      if (wanted.site.empty()) wanted = store::valueOrThrow(readPlace(catalogue_, wanted));
      context = store::valueOrThrow(
          catalogue::Places(catalogue_).contextByPlace(wanted.site, wanted.trench, wanted.context));
      if (!context)
        refuse(message("There is no context %1 in %2; add it first.", wanted.context,
                       wanted.site + (wanted.trench.empty() ? "" : " " + wanted.trench)));
    } else if (sherd.state == records::SherdState::Numbered && !losesNumber(changes)) {
      refuse(message("A numbered sherd needs its context."));
    }
    if (!wanted.bag.empty()) {
      bag = store::valueOrThrow(catalogue::Places(catalogue_).bagByNumber(context, wanted.bag));
      if (!bag)
        refuse(
            !context ? message("A bag belongs to a context; enter the context first.")
            : wanted.bag == sherd.bag_number
                ? message("Context %1 has no bag %2; change or clear the bag at the same time.",
                          wanted.context, wanted.bag)
                : message("There is no bag %1 in context %2 yet; enter it during capture or import "
                          "a table of contexts that contains it.",
                          wanted.bag, wanted.context));
    }
    for (Examined* change : changes)
      if (change->column && change->column->field.kind == records::FieldKind::Place) {
        change->context = context;
        change->bag = bag;
        if (context && !change->shown.new_value.empty()) canonical(*change);
      }
  }

  // The codes as the catalogue writes them, so that arm1 for ARM1 is no change.
  void canonical(Examined& change) {
    const auto place = store::valueOrThrow(catalogue::Places(catalogue_).context(change.context));
    std::string& value = change.shown.new_value;
    const std::string& field = change.shown.change.field;
    if (field == "site") value = place.site_code;
    if (field == "trench") value = place.trench_code;
    if (field == "context") value = place.number;
    if (field != "bag") return;
    catalogue_.database().sql("SELECT number FROM bag WHERE row = ?", change.bag).read(value);
  }

  static bool losesNumber(const std::vector<Examined*>& changes) {
    return std::any_of(changes.begin(), changes.end(), [](const Examined* change) {
      return change->shown.change.field == "number" && change->shown.new_value.empty();
    });
  }

  const catalogue::Catalogue& catalogue_;
  std::map<std::string, std::map<std::string, std::string>> vocabularies_;
  std::map<std::string, store::SherdRow> numbers_;
  std::optional<std::map<std::string, std::string>> waiting_;  ///< on plates, once asked for
};

struct Batch {
  std::vector<Examined> changes;
  std::map<std::int64_t, records::SherdRecord> sherds;
};

Batch examine(const catalogue::Catalogue& catalogue, std::span<const records::FieldChange> wanted) {
  Batch all;
  std::vector<store::SherdRow> rows;
  std::map<std::int64_t, std::vector<std::size_t>> by_sherd;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    all.changes.push_back({{wanted[i], {}, {}, {}, {}}, nullptr, 0, {}, {}, {}});
    auto& of_sherd = by_sherd[wanted[i].sherd.value];
    if (of_sherd.empty()) rows.push_back(wanted[i].sherd);
    of_sherd.push_back(i);
  }
  Examination examination(catalogue);
  for (records::SherdRecord& sherd : store::valueOrThrow(Sherds(catalogue).of(rows))) {
    std::vector<Examined*> of_sherd;
    for (const std::size_t i : by_sherd[sherd.row.value]) of_sherd.push_back(&all.changes[i]);
    examination.sherd(sherd, of_sherd);
    all.sherds.emplace(sherd.row.value, std::move(sherd));
  }
  return all;
}

std::string methodOf(const std::string& kind, const records::FieldChange& change) {
  if (!change.method.empty()) return change.method;
  if (kind == "weight") return "scale";
  return kind.starts_with("rim_") ? "estimate" : "calliper";
}

// Numbers are taken away before places change and given afterwards: a numbered sherd always has its
// context.
int turnOf(const Examined& change) {
  if (!change.column) return 2;
  if (change.column->field.kind == records::FieldKind::Place) return 1;
  return std::string_view(change.column->field.name) == "number" && change.shown.new_value.empty()
             ? 0
             : 2;
}

// Columns that are set together, in one statement for each sherd.
using Plain = std::vector<std::pair<std::string, std::string>>;

void write(const catalogue::Catalogue& catalogue, const Examined& change,
           records::SherdRecord& sherd, Plain& plain, const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  const store::SherdRow row = sherd.row;
  const std::string& field = change.shown.change.field;
  const std::string& value = change.shown.new_value;
  if (!change.column) {
    setExtra(catalogue, row, field.substr(6), value);
  } else if (change.column->measure) {
    const std::string kind = change.column->measure;
    if (value.empty())
      clearMeasure(catalogue, row, kind, provenance);
    else
      typeMeasure(catalogue,
                  {row,
                   kind,
                   {},
                   change.number,
                   change.uncertainty,
                   methodOf(kind, change.shown.change),
                   provenance.person,
                   {}},
                  provenance);
    return;  // its history is written with the measurement
  } else if (change.column->field.kind == records::FieldKind::Joins) {
    setJoins(catalogue, row, change.joins);
  } else if (change.column->field.kind == records::FieldKind::Place) {
    if (sherd.context != change.context || sherd.bag != change.bag)
      database.run("UPDATE sherd SET context = ?, bag = ? WHERE row = ?", change.context,
                   change.bag, row);
    sherd.context = change.context;
    sherd.bag = change.bag;
  } else if (field == "number") {
    if (!value.empty() && !sherd.context)
      refuse(message("A sherd needs its context before it gets a number."), value);
    setNumber(catalogue, store::valueOrThrow(Sherds(catalogue).get(row)), value);
    sherd.number = value;
  } else if (field == "void_reason") {
    const char* state = !value.empty() ? "void" : sherd.number.empty() ? "draft" : "numbered";
    database.run("UPDATE sherd SET void_reason = ?, state = ? WHERE row = ?", value, state, row);
  } else {
    plain.emplace_back(field,
                       change.column->terms ? store::termsJson(store::splitTerms(value)) : value);
  }
  catalogue::remember(catalogue, provenance, "sherd", row.value, field, change.shown.old_value,
                      value);
}

void finish(const catalogue::Catalogue& catalogue, store::SherdRow sherd, const Plain& plain,
            const records::Provenance& provenance) {
  std::string pairs;
  for (const auto& [column, value] : plain) pairs += column + " = ?, ";
  store::Statement update = catalogue.database().sql(
      "UPDATE sherd SET " + pairs +
      "updated_at = ?, updated_by = ?, revision = revision + 1 WHERE row = ?");
  for (const auto& [column, value] : plain) update.with(value);
  update.with(catalogue.now(), provenance.person, sherd).run();
  catalogue::searchAnew(catalogue.database(), sherd);
}

}  // namespace

Result<std::vector<records::ChangePreview>> SherdChanges::preview(
    std::span<const records::FieldChange> wanted) const {
  return database_->asResult([&] {
    std::vector<records::ChangePreview> shown;
    for (Examined& change : examine(catalogue_, wanted).changes)
      shown.push_back(std::move(change.shown));
    return shown;
  });
}

Result<std::vector<records::FieldChange>> SherdChanges::apply(
    std::span<const records::FieldChange> wanted, const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    Batch all = examine(catalogue_, wanted);
    const auto numberOf = [&](const Examined& change) {
      const records::SherdRecord& sherd = all.sherds.at(change.shown.change.sherd.value);
      return sherd.number.empty() ? sherd.id : sherd.number;
    };
    for (const Examined& change : all.changes)
      if (!change.shown.refusal.empty()) refuse(change.shown.refusal, numberOf(change));
    for (const Examined& change : all.changes)
      if (change.shown.asks()) refuse(change.shown.question, numberOf(change));
    std::vector<records::FieldChange> undo;
    std::map<std::int64_t, Plain> touched;
    for (const int turn : {0, 1, 2})
      for (const Examined& change : all.changes) {
        if (!change.changes() || turnOf(change) != turn) continue;
        const records::FieldChange& asked = change.shown.change;
        write(catalogue_, change, all.sherds.at(asked.sherd.value), touched[asked.sherd.value],
              provenance);
        undo.push_back({asked.sherd, asked.field, change.shown.old_value,
                        records::Confirmation::Given, change.shown.new_value});
      }
    for (const auto& [row, plain] : touched)
      finish(catalogue_, store::SherdRow{row}, plain, provenance);
    std::reverse(undo.begin(), undo.end());
    return undo;
  });
}

}  // namespace ostraka::sherds
