#include "catalogue/file_places.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "files/folder_lock.h"
#include "store/values.h"

namespace ostraka::catalogue {
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

bool isUnfinished(const std::string& part) {
  return part.starts_with('.') || part.ends_with(".partial");
}

bool isOfTheProgram(const std::string& part) {
  return isUnfinished(part) || part == "work";
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

bool isRecordedPlace(const std::string& path, const std::string& batch) {
  const Result<ContainedPath> parsed = ContainedPath::parse(path);
  if (!parsed || parsed->parts().size() < 3) return false;
  if (parsed->parts()[0] == "imported") return importPlace(path, {}).has_value();
  return !batch.empty() && (isComputed(parsed->parts(), batch) || importPlace(path, batch));
}

Result<std::string> recordedPath(std::string_view path) {
  Result<std::string> text = store::checkedPath(path);
  if (!text) return text;
  const std::size_t first = text->find('/'), second = text->find('/', first + 1);
  const bool is_deep = second != std::string::npos;
  if (is_deep && isRecordedPlace(*text, text->substr(first + 1, second - first - 1))) return text;
  return Error::unusable(
      message("This is not the location of a photograph, result, model or imported file, the only "
              "files that a catalogue lists. Nothing was changed; use a backup or another copy of "
              "the project."),
      text->substr(0, 255));
}

bool isPlaceOfFiles(const std::string& path) {
  const Result<ContainedPath> parsed = ContainedPath::parse(path);
  if (!parsed || parsed->parts().size() < 3) return false;
  const std::vector<std::string>& parts = parsed->parts();
  if (parts[0] == "imported") return importPlace(path, {}).has_value();
  return std::find(std::begin(kFoldersOfBatches), std::end(kFoldersOfBatches), parts[0] + "/") !=
             std::end(kFoldersOfBatches) &&
         parts.back() != kLockFile && std::none_of(parts.begin(), parts.end(), isUnfinished);
}

}  // namespace ostraka::catalogue
