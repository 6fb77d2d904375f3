#include "api/catalogue.h"

#include <utility>

#include "api/checked.h"
#include "catalogue/settings.h"
#include "sherds/filter.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "upkeep/project.h"

namespace ostraka::api {
namespace {

namespace fs = std::filesystem;

CatalogueSherd asSherd(const records::SherdRecord& record, const fs::path& project) {
  CatalogueSherd sherd;
  sherd.id = record.id;
  sherd.number = record.number;
  for (const records::SherdField& field : sherds::sherdFields())
    if (std::string text = sherds::textOf(record, field.name); !text.empty())
      sherd.fields.emplace(field.name, std::move(text));
  sherd.measurements = record.measures;
  if (!record.model_path.empty()) sherd.model = project / record.model_path;
  if (!record.preview_path.empty()) sherd.preview = project / record.preview_path;
  return sherd;
}

Result<CatalogueContents> contentsOf(const fs::path& project, std::string_view filter) {
  const Result<sherds::Filter> parsed = sherds::parseFilter(filter);
  if (!parsed) return parsed.error();
  const Result<upkeep::Project> opened = upkeep::Project::open(project);
  if (!opened) return opened.error();
  CatalogueContents contents;
  const Result<void> read = opened->catalogue().inSnapshot([&]() -> Result<void> {
    const Result<records::ProjectRecord> record =
        catalogue::Settings(opened->catalogue()).project();
    if (!record) return record.error();
    contents.id = record->id;
    contents.code = record->code;
    contents.title = record->title;
    const sherds::Sherds all(opened->catalogue());
    const auto rows = all.rows(*parsed, {});
    if (!rows) return rows.error();
    const auto records = all.of(*rows);
    if (!records) return records.error();
    for (const records::SherdRecord& sherd : *records)
      contents.sherds.push_back(asSherd(sherd, opened->folder()));
    return {};
  });
  if (!read) return read.error();
  return contents;
}

}  // namespace

Result<CatalogueContents> readCatalogue(const fs::path& project, std::string_view filter) {
  return withoutExceptions([&] { return contentsOf(project, filter); });
}

}  // namespace ostraka::api
