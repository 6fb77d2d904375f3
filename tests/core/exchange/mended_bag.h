#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "files/files.h"

namespace ostraka::exchange {

/// A bag that somebody changes by hand and mends, so that all of its checksums agree.
class MendedBag {
 public:
  explicit MendedBag(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::istringstream lines(*readFile(folder_ / "manifest-sha256.txt"));
    for (std::string line; std::getline(lines, line);)
      payload.emplace_back(line.substr(66), line.substr(0, 64));
    for (const char* name : {"bagit.txt", "bag-info.txt", "manifest-sha256.txt"}) tag(name);
  }
  const std::filesystem::path& folder() const { return folder_; }

  /// A line of the manifest for bytes that lie wherever they lie.
  void list(const std::string& path, const std::string& bytes) {
    payload.emplace_back(path, sha256(bytes));
  }
  /// A file of the bag, new or changed, with its line.
  void put(const std::string& path, const std::string& bytes) {
    std::filesystem::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path, std::ios::binary) << bytes;
    for (auto& [name, hash] : payload)
      if (name == path) {
        hash = sha256(bytes);
        return;
      }
    list(path, bytes);
  }
  void drop(const std::string& path) {
    std::erase_if(payload, [&](const auto& line) { return line.first == path; });
    std::filesystem::remove(folder_ / path);
  }
  nlohmann::json json(const std::string& path) const {
    return nlohmann::json::parse(*readFile(folder_ / path));
  }
  void tag(const std::string& name) { tags.push_back(name); }
  void mend() const {
    std::ofstream manifest(folder_ / "manifest-sha256.txt", std::ios::binary);
    for (const auto& [name, hash] : payload) manifest << hash << "  " << name << "\n";
    manifest.close();
    std::ofstream all(folder_ / "tagmanifest-sha256.txt", std::ios::binary);
    for (const std::string& name : tags) {
      const Result<std::string> bytes = readFile(folder_ / name);
      all << sha256(bytes ? *bytes : "") << "  " << name << "\n";
    }
  }
  std::vector<std::pair<std::string, std::string>> payload;  ///< path, hash
  std::vector<std::string> tags;

 private:
  std::filesystem::path folder_;
};

/// Everything that lies in a folder: kind and contents by path. What SQLite keeps while a catalogue
/// is open is left out.
inline std::map<std::string, std::string> everythingIn(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> all;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (name.ends_with("-shm") || name.ends_with("-wal")) continue;
    std::string what = "other";
    if (entry.is_symlink())
      what = "link to " + fs::read_symlink(entry.path()).string();
    else if (entry.is_directory())
      what = "folder";
    else if (entry.is_regular_file())
      what = "file " + *readFile(entry.path());
    all[name] = what;
  }
  return all;
}

}  // namespace ostraka::exchange
