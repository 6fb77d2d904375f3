#include <set>

#include "archive/archive.h"
#include "capture/manifest.h"
#include "decisions/candidate_table.h"
#include "decisions/mask_strokes.h"
#include "exchange/read_back.h"
#include "files/files.h"
#include "foreign_folder.h"
#include "must.h"
#include "targets.h"
#include "upkeep/project.h"

namespace ostraka::fuzz {
namespace {

namespace fs = std::filesystem;

std::set<std::string> filesBelow(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory())
      files.insert(entry.path().lexically_relative(folder).generic_string());
  return files;
}

// What an import may add to a project: files of batches, results and models, and what it imported.
bool belongsToAProject(const std::string& file) {
  for (const char* folder : {"batches/", "results/", "models/", "imported/"})
    if (file.starts_with(folder)) {
      const fs::path name = fs::path(file).filename();
      return name != "decisions.json" && name != "stage.json" && name != "lock" &&
             !name.string().starts_with("catalogue.sqlite");
    }
  return file == "catalogue.sqlite" || file == "catalogue.sqlite-wal" ||
         file == "catalogue.sqlite-shm" || file == "lock";
}

}  // namespace

void archive(std::string_view bytes) {
  const Sandbox sandbox(foreignFiles(bytes));
  QuietProgress quiet;
  const auto restored = archive::restoreProject(sandbox.foreign(), sandbox.target(), quiet, {});
  mustNameItself(restored);
  sandbox.mustBeContained();
  if (!restored) {
    must(!fs::exists(sandbox.target()), "what was refused leaves nothing behind");
    return;
  }
  const auto project = upkeep::Project::open(sandbox.target());
  must(project.has_value(), "what was restored can be opened");
}

void exportFolder(std::string_view bytes) {
  std::vector<ForeignFile> files = foreignFiles(bytes);
  const Sandbox sandbox(files);
  fs::create_directory(sandbox.target());
  must(writeFileAtomically(sandbox.target() / "catalogue.sqlite", emptyCatalogue()).has_value(),
       "a catalogue is written");
  auto project = upkeep::Project::open(sandbox.target());
  must(project.has_value(), "a project is opened");
  const std::set<std::string> before = filesBelow(sandbox.target());
  QuietProgress quiet;
  const auto entered =
      exchange::readBack(*project, sandbox.foreign(), tables::ImportMode::Enter, {}, quiet, {});
  mustNameItself(entered);
  sandbox.mustBeContained();
  for (const std::string& file : filesBelow(sandbox.target()))
    must(before.contains(file) || belongsToAProject(file), "an import plants no control file");
  must(project->catalogue().checkIntegrity().has_value(), "the catalogue stays whole");
}

void batchManifest(std::string_view bytes) {
  const Sandbox sandbox({{"manifest.json", {}, std::string(bytes)}});
  const auto read = capture::readManifest(sandbox.foreign());
  mustNameItself(read);
  if (!read) return;
  for (const capture::ManifestEntry& entry : read->entries)
    must(entry.camera >= 0 && entry.stop >= 0 && entry.take >= 1, "a photograph has a place");
  must(capture::writeManifest(sandbox.target(), *read).has_value(), "it can be written");
  const auto again = capture::readManifest(sandbox.target());
  must(again.has_value() && again->entries.size() == read->entries.size(),
       "what was read is written and read");
}

void outputFolder(std::string_view bytes) {
  const Sandbox sandbox(foreignFiles(bytes));
  mustNameItself(decisions::readCandidates(sandbox.foreign() / "candidates.json"));
  mustNameItself(decisions::readMaskStrokes(sandbox.foreign()));
  mustNameItself(decisions::maskedPhotographs(sandbox.foreign()));
  mustNameItself(decisions::readDecisions(sandbox.foreign()));
  sandbox.mustBeContained();
}

}  // namespace ostraka::fuzz
