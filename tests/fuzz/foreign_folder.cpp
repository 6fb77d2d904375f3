#include "foreign_folder.h"

#include <stdlib.h>

#include <map>
#include <set>

#include "files/files.h"
#include "must.h"
#include "records/records.h"
#include "upkeep/project.h"

namespace ostraka::fuzz {
namespace {

namespace fs = std::filesystem;
constexpr const char* kSecret = "what lies outside stays outside";

// The harness itself writes below its folder only.
bool staysInside(const std::string& path) {
  const fs::path p(path);
  if (path.empty() || p.is_absolute() || path.size() > 200 || path.find('\0') != std::string::npos)
    return false;
  for (const fs::path& part : p)
    if (part == ".." || part.empty()) return false;
  return true;
}

void write(const fs::path& file, const std::string& content) {
  std::error_code failed;
  if (fs::is_symlink(file, failed)) return;
  for (fs::path up = file.parent_path(); up.has_relative_path(); up = up.parent_path())
    if (fs::is_symlink(up, failed)) return;
  if (!fs::exists(file, failed)) (void)writeFileAtomically(file, content);
}

std::string manifestOf(const std::map<std::string, std::string>& contents, bool of_payload) {
  std::string text;
  for (const auto& [path, content] : contents)
    if (path.starts_with("data/") == of_payload) text += sha256(content) + "  " + path + "\n";
  return text;
}

// '@  PATH' -> the hash of what PATH holds.
std::string withHashes(const std::string& manifest,
                       const std::map<std::string, std::string>& contents) {
  std::string text;
  for (std::size_t at = 0; at < manifest.size();) {
    const std::size_t end = std::min(manifest.find('\n', at), manifest.size());
    const std::string line = manifest.substr(at, end - at);
    const auto named = line.starts_with("@  ") ? contents.find(line.substr(3)) : contents.end();
    text += (named == contents.end() ? line : sha256(named->second) + line.substr(1)) + "\n";
    at = end + 1;
  }
  return text;
}

}  // namespace

std::string emptyCatalogue() {
  static const std::string bytes = [] {
    std::string name = (fs::temp_directory_path() / "ostraka-fuzz-XXXXXX").string();
    must(::mkdtemp(name.data()) != nullptr, "a scratch folder");
    records::ProjectRecord record;
    record.code = "ARM";
    std::string made;
    {
      const auto project = upkeep::Project::create(fs::path(name) / "project", record);
      must(project.has_value(), "a project");
      const fs::path copy = fs::path(name) / "copy.sqlite";
      must(project->catalogue().backup(copy).has_value(), "a copy of the catalogue");
      made = *readFile(copy);
    }
    fs::remove_all(name);
    return made;
  }();
  return bytes;
}

std::vector<ForeignFile> foreignFiles(std::string_view text) {
  std::vector<ForeignFile> files;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = std::min(text.find("\n=== ", at), text.size());
    std::string_view section = text.substr(at, next - at);
    at = next + 1;
    if (!section.starts_with("=== ")) continue;
    section.remove_prefix(4);
    const std::size_t line = std::min(section.find('\n'), section.size());
    ForeignFile file;
    file.path = section.substr(0, line);
    if (line < section.size()) file.content = section.substr(line + 1);
    if (const std::size_t arrow = file.path.find(" -> "); arrow != std::string::npos) {
      file.link = file.path.substr(arrow + 4);
      file.path.resize(arrow);
    }
    if (file.content == "@project") file.content = emptyCatalogue();
    if (files.size() < 200 && staysInside(file.path)) files.push_back(std::move(file));
  }
  return files;
}

Sandbox::Sandbox(const std::vector<ForeignFile>& files) {
  const fs::path memory = "/dev/shm";
  std::error_code failed;
  std::string name =
      ((fs::is_directory(memory, failed) ? memory : fs::temp_directory_path()) / "ostraka-XXXXXX")
          .string();
  must(::mkdtemp(name.data()) != nullptr, "a scratch folder");
  folder_ = name;
  write(folder_ / "outside" / "secret", kSecret);
  std::map<std::string, std::string> contents;
  for (const ForeignFile& file : files)
    if (file.link.empty()) contents.try_emplace(file.path, file.content);
  for (const bool of_payload : {true, false}) {
    const char* name_of = of_payload ? "manifest-sha256.txt" : "tagmanifest-sha256.txt";
    const auto given = contents.find(name_of);
    const std::string text = given == contents.end() ? manifestOf(contents, of_payload)
                                                     : withHashes(given->second, contents);
    contents[name_of] = text;
  }
  fs::create_directory(foreign());
  for (const ForeignFile& file : files) {
    if (file.link.empty() || file.link.find('\0') != std::string::npos) continue;
    fs::create_directories((foreign() / file.path).parent_path(), failed);
    fs::create_symlink(file.link, foreign() / file.path, failed);
  }
  for (const auto& [path, content] : contents) write(foreign() / path, content);
}

Sandbox::~Sandbox() {
  std::error_code failed;
  fs::remove_all(folder_, failed);
}

void Sandbox::mustBeContained() const {
  const std::set<std::string> known = {"foreign", "outside", "target"};
  for (const auto& entry : fs::directory_iterator(folder_))
    must(known.contains(entry.path().filename().string()), "nothing is written beside the target");
  int outside = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "outside"))
    outside += entry.path().filename() == "secret" ? 1 : 100;
  must(outside == 1 && readFile(folder_ / "outside" / "secret").value() == kSecret,
       "what lies outside is as it was");
  if (!fs::exists(target())) return;
  for (const auto& entry : fs::recursive_directory_iterator(target())) {
    must(!entry.is_symlink(), "no link is taken over");
    if (!entry.is_regular_file()) continue;
    const auto bytes = readFile(entry.path());
    must(bytes && bytes->find(kSecret) == std::string::npos, "nothing outside is copied");
  }
}

}  // namespace ostraka::fuzz
