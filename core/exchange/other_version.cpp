#include "exchange/other_version.h"

#include "sherds/measurements.h"
#include "sherds/sherd_fields.h"
#include "store/values.h"

namespace ostraka::exchange {
namespace {

constexpr const char* kNone = "-";  // what is kept of an empty value

// What the project says of it now: of a field, a measurement, or a custom field.
std::string valueNow(const records::SherdRecord& sherd, const std::string& name) {
  if (const auto value = sherd.measures.find(name); value != sherd.measures.end())
    return store::numberText(value->second);
  return sherds::textOf(sherd, sherds::sherdField(name) != nullptr ? name : "extra." + name);
}

// ware_in_out is what another project kept of ours: it says nothing new while our ware is that.
// Else two laptops that read each other by turns would add to these fields for ever.
bool isOurs(const records::SherdRecord& sherd, const std::string& name, const std::string& value) {
  for (std::size_t at = name.find("_in_"); at != std::string::npos; at = name.find("_in_", at + 1))
    if (const std::string now = valueNow(sherd, name.substr(0, at));
        value == (now.empty() ? kNone : now))
      return true;
  return false;
}

// Custom fields that the record has, and the project otherwise or not at all. Those that
// only the project has are no difference: they stay, and nothing of the record is left out.
std::vector<std::pair<std::string, std::string>> ownThatDiffer(const records::SherdRecord& sherd,
                                                               const tables::ImportRow& row,
                                                               const std::string& from) {
  std::vector<std::pair<std::string, std::string>> differ;
  for (const auto& [field, value] : row.values) {
    if (!field.starts_with("extra.") || field.ends_with("_in_" + from)) continue;
    const std::string name = field.substr(6);
    if (value != sherds::textOf(sherd, field) && !isOurs(sherd, name, value))
      differ.emplace_back(name, value);
  }
  return differ;
}

}  // namespace

std::vector<records::FieldChange> otherVersion(const records::SherdRecord& sherd,
                                               const tables::ImportRow& row,
                                               const std::string& from) {
  std::vector<records::FieldChange> kept;
  const auto keep = [&](const std::string& name, const std::string& value) {
    kept.push_back({sherd.row, "extra." + name + "_in_" + from, value.empty() ? kNone : value});
  };
  for (const records::SherdField& field : sherds::sherdFields()) {
    const std::string name = field.name;
    if (!field.editable || field.kind == records::FieldKind::Number) continue;
    const auto found = row.values.find(name);
    const std::string value = found == row.values.end() ? std::string() : found->second;
    if (value != sherds::textOf(sherd, name)) keep(name, value);
  }
  for (const auto& [m, initials] : row.measured) {
    const auto value = sherd.measures.find(m.kind);
    if (value == sherd.measures.end() || value->second != m.value)
      keep(m.kind, store::numberText(m.value));
  }
  for (const auto& [name, value] : ownThatDiffer(sherd, row, from)) keep(name, value);
  return kept;
}

bool sameAs(const records::SherdRecord& sherd, const tables::ImportRow& row,
            const std::string& from, const catalogue::Catalogue& catalogue) {
  for (const records::SherdField& field : sherds::sherdFields()) {
    const std::string name = field.name;
    if (name == "state" || name == "batch" || name == "scale" ||
        field.kind == records::FieldKind::Number)
      continue;
    const auto value = row.values.find(name);
    if ((value == row.values.end() ? std::string() : value->second) != sherds::textOf(sherd, name))
      return false;
  }
  if (!ownThatDiffer(sherd, row, from).empty()) return false;
  const auto measured = sherds::Measurements(catalogue).of(sherd.row);
  if (!measured || measured->size() != row.measured.size()) return false;
  for (const auto& [m, initials] : row.measured) {
    const auto value = sherd.measures.find(m.kind);
    if (value == sherd.measures.end() || value->second != m.value) return false;
  }
  return true;
}

Message keepsItsOwn(const std::string& from) {
  return message(
      "The project already has this sherd with other values, which it keeps; the differing values "
      "are added in fields that end in _in_%1.",
      from);
}

}  // namespace ostraka::exchange
