// The tables of an export.
#include <nlohmann/json.hpp>
#include <set>

#include "catalogue/values.h"
#include "exchange/csv.h"
#include "exchange/export_folder.h"

namespace ostraka::exchange {
namespace {

using namespace catalogue;

constexpr const char* kMark = "\xEF\xBB\xBF";
constexpr const char* kFileColumns[] = {"model_file", "image_file", "drawing_file"};
constexpr std::size_t kPage = 1000;

bool isNumber(const SherdField& field) {
  return field.kind == FieldKind::Number;
}

// Sherds are read a page at a time, so that 100,000 need no more memory than the text itself.
template <class Use>
Result<void> eachSherd(const Catalogue& catalogue, std::span<const SherdRow> rows, Use use) {
  for (std::size_t i = 0; i < rows.size(); i += kPage) {
    const Result<std::vector<SherdRecord>> page =
        catalogue.sherds(rows.subspan(i, std::min(kPage, rows.size() - i)));
    if (!page) return page.error();
    for (const SherdRecord& sherd : *page) use(sherd);
  }
  return {};
}

}  // namespace

Result<std::string> sherdsCsv(const Catalogue& catalogue, std::span<const SherdRow> rows,
                              ByteOrderMark mark,
                              const std::map<SherdRow, std::map<std::string, std::string>>& files) {
  const Result<ProjectRecord> project = catalogue.project();
  if (!project) return project.error();
  std::set<std::string> own;  // fields of the user's own, of any of the sherds
  Result<void> read = eachSherd(catalogue, rows, [&](const SherdRecord& sherd) {
    if (sherd.extra_json == "{}") return;
    const nlohmann::json extra = nlohmann::json::parse(sherd.extra_json, nullptr, false);
    if (extra.is_object())
      for (const auto& [key, value] : extra.items()) own.insert(key);
  });
  if (!read) return read.error();
  std::vector<std::string> columns;
  for (const SherdField& field : sherdFields()) columns.emplace_back(field.name);
  for (const char* column : kFileColumns) columns.emplace_back(column);
  columns.emplace_back("licence");
  for (const std::string& key : own) columns.push_back(guarded("extra." + key));
  std::string text = (mark == ByteOrderMark::With ? kMark : "") + csvLine(columns);
  read = eachSherd(catalogue, rows, [&](const SherdRecord& sherd) {
    std::vector<std::string> values;
    for (const SherdField& field : sherdFields()) {
      const std::string value = textOf(sherd, field.name);
      values.push_back(isNumber(field) ? value : guarded(value));
    }
    const auto named = files.find(sherd.row);
    for (const char* column : kFileColumns) {
      const auto file = named == files.end() ? std::map<std::string, std::string>::const_iterator()
                                             : named->second.find(column);
      const bool there = named != files.end() && file != named->second.end();
      values.push_back(there ? guarded(file->second) : std::string());
    }
    values.push_back(guarded(project->licence));
    for (const std::string& key : own) values.push_back(guarded(textOf(sherd, "extra." + key)));
    text += csvLine(values);
  });
  if (!read) return read.error();
  return text;
}

Result<std::string> contextsCsv(const Catalogue& catalogue, std::span<const ContextRow> rows,
                                ByteOrderMark mark) {
  std::string text =
      (mark == ByteOrderMark::With ? kMark : "") +
      csvLine({"site", "trench", "context", "kind", "excavated_on", "period", "date_edtf", "closed",
               "note", "bag", "collected_on", "count_written", "weight_g", "storage"});
  for (const ContextRow& row : rows) {
    const Result<ContextRecord> c = catalogue.context(row);
    if (!c) return c.error();
    Result<std::vector<BagRecord>> bags = catalogue.bags(row);
    if (!bags) return bags.error();
    if (bags->empty()) bags->emplace_back();
    for (const BagRecord& bag : *bags)
      text +=
          csvLine({guarded(c->site_code), guarded(c->trench_code), guarded(c->number), c->kind,
                   c->excavated_on, guarded(c->period), guarded(c->date_edtf),
                   c->closed ? "yes" : "no", guarded(c->note), guarded(bag.number),
                   bag.collected_on, bag.count_written ? std::to_string(*bag.count_written) : "",
                   bag.weight_g ? numberText(*bag.weight_g) : "", guarded(bag.storage)});
  }
  return text;
}

}  // namespace ostraka::exchange
