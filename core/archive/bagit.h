#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "archive/distinct_paths.h"
#include "base/progress.h"
#include "base/result.h"
#include "files/new_folder.h"
#include "files/open_folder.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::archive {

/// A folder's absolute path without a slash at its end, so that names can be made from its own.
std::filesystem::path folderNamed(const std::filesystem::path& folder);

struct BagFile {
  std::string path;  ///< within the bag, with '/': data/sherds.csv
  std::string sha256;
  std::int64_t bytes = 0;
};

/// A path as a manifest has it, '%' as %25, and back. What encodes nothing stays as it is.
std::string inManifest(std::string path);
std::string fromManifest(std::string name);

/// What bag-info.txt says of every bag made from this project: whose it is, the day, the program.
Result<std::map<std::string, std::string>> bagInfo(const catalogue::Catalogue& catalogue,
                                                   const std::string& program);

/// Writes a folder after BagIt 1.0 (RFC 8493). Everything goes to a NewFolder; finish() syncs it
/// and gives it its name. Without finish() nothing stays behind.
class BagWriter {
 public:
  /// Errors: the folder is there already, or cannot be made; NAME.partial holds files of others.
  static Result<BagWriter> begin(const std::filesystem::path& target);

  /// path is relative to data/. Errors: the same name twice, one that other systems
  /// do not keep, a full disk.
  Result<BagFile> add(const std::string& path, std::string_view bytes);
  /// Copies in pieces, hashing while it reads; stops within a piece. Errors name the source where
  /// it cannot be read, else what cannot be written.
  Result<BagFile> addFile(const std::string& path, OpenFile source, std::stop_token stop);
  Result<BagFile> addFile(const std::string& path, const std::filesystem::path& source,
                          std::stop_token stop);
  /// A file beside data/, for finish().
  void tag(const std::string& name, const std::string& text);
  /// Writes bagit.txt, bag-info.txt and the manifests, lets `check` look at the folder, then
  /// renames.
  Result<void> finish(const std::map<std::string, std::string>& info,
                      const std::function<Result<void>(const std::filesystem::path&)>& check = {});
  /// The folder meanwhile: what is written there beside add() must be gone before finish().
  std::filesystem::path folder() const { return folder_.path(); }
  const std::vector<BagFile>& files() const { return files_; }
  std::int64_t bytes() const { return bytes_; }

 private:
  BagWriter(std::filesystem::path target, NewFolder folder)
      : target_(std::move(target)), folder_(std::move(folder)) {}
  Result<void> take(const std::string& path);
  std::filesystem::path target_;
  NewFolder folder_;
  std::vector<BagFile> files_;
  DistinctPaths distinct_;
  std::vector<std::pair<std::string, std::string>> tags_;  ///< name, text
  std::int64_t bytes_ = 0;
};

/// Every file of the bag, after all hashes agreed (BagReader::open).
Result<std::vector<BagFile>> checkBag(const std::filesystem::path& folder, Progress& progress,
                                      std::stop_token stop);

}  // namespace ostraka::archive
