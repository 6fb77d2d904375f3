#include "archive/bag_reader.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "archive/distinct_paths.h"
#include "base/limits.h"
#include "base/message.h"
#include "files/checksum.h"
#include "files/files.h"
#include "store/values.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;
using Hashes = std::map<std::string, std::string>;  // by name

constexpr const char* kPayload = "manifest-sha256.txt";
constexpr const char* kTags = "tagmanifest-sha256.txt";
constexpr const char* kDamage = "damage.txt";
constexpr std::size_t kMostTagBytes = limits::kManifestBytes.most;
const std::set<std::string> kTagFiles = {"bagit.txt", "bag-info.txt", "README.txt", kPayload,
                                         kDamage};

Result<ContainedPath> parsed(const std::string& name) {
  const Result<std::string> text = store::checkedPath(name);
  return text ? ContainedPath::parse(name) : text.error();
}

bool isSha256(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

// A manifest's lines: a hash, blanks, a name.
Result<Hashes> parseManifest(const std::string& text, const std::string& where) {
  Hashes hashes;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    const std::string hash = line.substr(0, line.find_first_of(" \t"));
    const std::size_t name = line.find_first_not_of(" \t*", hash.size());
    if (!isSha256(hash) || name == std::string::npos)
      return Error::unusable(message("The manifest has a line that cannot be read (%1), so nothing "
                                     "was read; copy the folder again.",
                                     line.substr(0, 80)),
                             where);
    const std::string path = fromManifest(line.substr(name));
    if (!hashes.emplace(path, hash).second)
      return Error::unusable(
          message(
              "The manifest names the file %1 twice, so nothing was read; copy the folder again.",
              path),
          where);
  }
  return hashes;
}

Result<std::string> bytesOf(OpenFile& file, std::size_t max_bytes, const std::stop_token& stop,
                            std::string& sha256) {
  std::string bytes;
  const Result<Checksum> sum = checksumOf(file, stop, [&](std::string_view piece) -> Result<void> {
    if (bytes.size() + piece.size() > max_bytes)
      return Error::unusable(
          message("The file is larger than the limit of %1 bytes; check that it is the right one.",
                  max_bytes),
          file.name());
    bytes += piece;
    return {};
  });
  if (!sum) return sum.error();
  sha256 = sum->sha256;
  return bytes;
}

Error changedSince(const std::string& where) {
  return Error::unusable(message("This file has changed since the export; nothing was read."),
                         where);
}

}  // namespace

// By name, their texts, which agree with the tag manifest.
Result<Hashes> BagReader::tagFiles() const {
  const auto read = [&](const std::string& name, std::string& hash) -> Result<std::string> {
    Result<OpenFile> file = folder_.read(*ContainedPath::parse(name));
    return file ? bytesOf(*file, kMostTagBytes, {}, hash) : file.error();
  };
  std::string hash;
  const Result<std::string> declaration = read("bagit.txt", hash);
  if (!declaration || !declaration->starts_with("BagIt-Version: "))
    return Error::unusable(message("Not an Ostraka export: this folder has no bagit.txt."),
                           folder_.path().string());
  const Result<std::string> tags = read(kTags, hash);
  if (!tags)
    return Error::unusable(message("The manifest is missing; not an Ostraka export."),
                           where(kTags));
  const Result<Hashes> hashes = parseManifest(*tags, where(kTags));
  if (!hashes) return hashes.error();
  if (!hashes->contains(kPayload))
    return Error::unusable(message("The manifest is missing; not an Ostraka export."),
                           where(kPayload));
  Hashes texts;
  for (const auto& [name, wanted] : *hashes) {
    if (!kTagFiles.contains(name))
      return Error::unusable(message("The manifest names a file outside the folder (%1), so "
                                     "nothing was read; copy the folder again.",
                                     name),
                             where(kTags));
    Result<std::string> text = read(name, hash);
    if (!text)
      return Error::unusable(message("This file is missing; nothing was read."), where(name));
    if (hash != wanted) return changedSince(where(name));
    texts[name] = std::move(*text);
  }
  return texts;
}

// Of the payload, all of it in data/.
Result<Hashes> BagReader::listed(const std::string& manifest) const {
  Result<Hashes> hashes = parseManifest(manifest, where(kPayload));
  if (!hashes) return hashes;
  DistinctPaths distinct;
  for (const auto& [name, hash] : *hashes) {
    const Result<ContainedPath> path = parsed(name);
    if (!path || path->parts().size() < 2 || path->parts().front() != "data")
      return Error::unusable(message("The manifest names a file outside the folder (%1), so "
                                     "nothing was read; copy the folder again.",
                                     name.substr(0, 255)),
                             where(kPayload));
    if (Result<void> apart = distinct.add(name); !apart) return apart.error();
  }
  return hashes;
}

// What lies in data/ is what the manifest lists, and each a file of its own.
Result<void> BagReader::checkNames(const Hashes& hashes) const {
  const auto found = folder_.filesBelow(*ContainedPath::parse("data"));
  if (!found) return found.error();
  std::set<std::string> there;
  for (const OpenFolder::Entry& entry : *found) {
    if (!hashes.contains(entry.path))
      return Error::unusable(message("This file is not in the manifest; nothing was read."),
                             where(entry.path));
    if (!entry.is_regular)
      return Error::unusable(message("This is a link, not a file; nothing was read."),
                             where(entry.path));
    there.insert(entry.path);
  }
  for (const auto& [name, hash] : hashes)
    if (!there.contains(name))
      return Error::unusable(message("This file is missing; nothing was read."), where(name));
  return {};
}

Result<BagReader> BagReader::open(const fs::path& folder, Progress& progress,
                                  std::stop_token stop) {
  Result<OpenFolder> opened = OpenFolder::open(folder);
  if (!opened) return opened.error();
  BagReader bag(std::move(*opened));
  Result<Hashes> tags = bag.tagFiles();
  if (!tags) return tags.error();
  const Result<Hashes> hashes = bag.listed((*tags)[kPayload]);
  if (!hashes) return hashes.error();
  if (Result<void> good = bag.checkNames(*hashes); !good) return good.error();
  std::istringstream damage((*tags)[kDamage]);
  for (std::string line; std::getline(damage, line);) bag.damage_.push_back(line);
  for (const auto& [name, hash] : *hashes) {
    progress.report(static_cast<std::int64_t>(bag.files_.size()),
                    static_cast<std::int64_t>(hashes->size()));
    Result<OpenFile> file = bag.folder_.read(*ContainedPath::parse(name));
    if (!file) return file.error();
    const Result<Checksum> sum = checksumOf(*file, stop);
    if (!sum) return sum.error();
    if (sum->sha256 != hash) return changedSince(bag.where(name));
    bag.files_.push_back({name, hash, sum->bytes});
  }
  return bag;
}

const BagFile* BagReader::find(const std::string& path) const {
  const auto found =
      std::lower_bound(files_.begin(), files_.end(), path,
                       [](const BagFile& file, const std::string& p) { return file.path < p; });
  return found != files_.end() && found->path == path ? &*found : nullptr;
}

Result<std::string> BagReader::read(const BagFile& file, std::size_t max_bytes) const {
  Result<OpenFile> open = folder_.read(*ContainedPath::parse(file.path));
  if (!open) return open.error();
  std::string hash;
  Result<std::string> bytes = bytesOf(*open, max_bytes, {}, hash);
  if (bytes && hash != file.sha256) return changedSince(where(file.path));
  return bytes;
}

Result<void> BagReader::copy(const BagFile& file, const OpenFolder& to, const ContainedPath& as,
                             const std::stop_token& stop) const {
  Result<OpenFile> open = folder_.read(*ContainedPath::parse(file.path));
  if (!open) return open.error();
  Result<NewFile> made = to.create(as);
  if (!made) return made.error();
  const Result<Checksum> sum =
      checksumOf(*open, stop, [&](std::string_view piece) { return made->write(piece); });
  if (!sum) return sum.error();
  if (sum->sha256 != file.sha256) return changedSince(where(file.path));
  return made->finish();
}

Result<std::vector<BagFile>> checkBag(const fs::path& folder, Progress& progress,
                                      std::stop_token stop) {
  const Result<BagReader> bag = BagReader::open(folder, progress, std::move(stop));
  if (!bag) return bag.error();
  return bag->files();
}

}  // namespace ostraka::archive
