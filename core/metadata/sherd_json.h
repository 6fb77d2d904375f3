#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "cloud/glb.h"
#include "records/sherd.h"
#include "tables/import_table.h"

namespace ostraka::metadata {

/// A file of an export that belongs to a sherd.
struct SherdFile {
  std::string role, path, sha256;  ///< path relative to data/
  std::int64_t bytes = 0;
};

/// The record of one sherd (format ostraka-sherd/1), keys in a fixed order, LF at the end. model:
/// what `process` left in its GLB. Its texture's kind stands in `processing`, Munsell colours in
/// `proposals`, apart from those that a person entered; parseSherdJson reads neither.
Result<std::string> sherdJson(const catalogue::Catalogue& catalogue,
                              const records::SherdRecord& sherd,
                              const std::vector<SherdFile>& files, const GlbExtras& model,
                              const std::string& program);

struct ReadSherdJson {
  tables::ImportRow row;
  std::vector<SherdFile> files;
  std::string front, back;  ///< names of the scans that it was made from
};
/// Unknown keys survive as custom fields. Errors: another format, a value of a wrong type.
Result<ReadSherdJson> parseSherdJson(std::string_view text, const std::string& where);

}  // namespace ostraka::metadata
