#include "tables/import_places.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "store/values.h"

namespace ostraka::tables {
namespace {

struct ImportPlace {
  const char* folder;
  std::set<std::string> endings;
  std::set<std::string> names;  // of files with other endings
};

const std::vector<ImportPlace>& importPlaces() {
  static const std::vector<ImportPlace> kAll = {
      {"batches",
       {".jpg", ".jpeg", ".png", ".tif", ".tiff", ".heic", ".heif", ".dng", ".cr2", ".cr3", ".nef",
        ".nrw", ".arw", ".orf", ".rw2", ".raf", ".pef", ".srw"},
       {"plate.json", "board.json", "scale.json", "rig.json"}},
      {"results", {".ply", ".png"}, {"pairs.json", "report.json"}},
      {"models", {".ply", ".glb", ".obj", ".png"}, {}},
      {"imported", {".ply", ".glb", ".obj", ".mtl", ".png", ".jpg", ".svg", ".pdf"}, {}}};
  return kAll;
}

bool isOfTheProgram(const std::string& part) {
  return part.starts_with('.') || part == "work" || part.ends_with(".partial");
}

// The scans of a computation and its report in HTML, which no export has.
bool isComputed(const std::vector<std::string>& parts, const std::string& number) {
  if (parts[0] != "results" || parts[1] != number) return false;
  if (parts.size() == 3) return parts[2] == "report.html";
  return parts.size() > 4 && parts[2] == "work" && parts.back().ends_with(".ply") &&
         std::none_of(parts.begin() + 3, parts.end(), isOfTheProgram);
}

}  // namespace

Result<ContainedPath> importPlace(const std::string& path, const std::string& batch) {
  const auto refused = [&] {
    return Error::unusable(
        message(
            "The export names a location in the project where no such file belongs; nothing was "
            "imported."),
        path.substr(0, 255));
  };
  const Result<std::string> text = store::checkedPath(path);
  if (!text) return text.error();
  Result<ContainedPath> parsed = ContainedPath::parse(*text);
  if (!parsed) return parsed;
  const std::vector<std::string>& parts = parsed->parts();
  if (parts.size() < 3 || std::any_of(parts.begin(), parts.end(), isOfTheProgram)) return refused();
  const std::string name = lowerCase(parts.back());
  const std::string ending = std::filesystem::path(name).extension().string();
  for (const ImportPlace& place : importPlaces()) {
    if (parts[0] != place.folder) continue;
    const bool own = batch.empty() ? parts[0] == "imported" : parts[1] == batch;
    if (own && (place.endings.contains(ending) || place.names.contains(name))) return parsed;
  }
  return refused();
}

bool isMergePlace(const std::string& path, const std::string& batch) {
  const Result<ContainedPath> parsed = ContainedPath::parse(path);
  if (!parsed || parsed->parts().size() < 3) return false;
  if (parsed->parts()[0] == "imported") return importPlace(path, {}).has_value();
  return !batch.empty() && (isComputed(parsed->parts(), batch) || importPlace(path, batch));
}

}  // namespace ostraka::tables
