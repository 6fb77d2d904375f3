#include "exchange/bagit.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include "base/files.h"
#include "catalogue/names.h"
#include "catalogue/values.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDeclaration = "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n";
constexpr std::size_t kPiece = 1 << 20;

class Hash {
 public:
  Hash() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
  }
  void add(std::string_view bytes) { EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()); }
  std::string text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    EVP_DigestFinal_ex(context_.get(), digest.data(), &size);
    std::string out;
    for (unsigned i = 0; i < size; ++i) {
      out += "0123456789abcdef"[digest[i] >> 4];
      out += "0123456789abcdef"[digest[i] & 15];
    }
    return out;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

struct Closing {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closing>;

// Reads in pieces, gives each to `use` and hashes it.
template <class Use>
Result<BagFile> readPieces(const fs::path& path, std::stop_token stop, Use use) {
  const File in(std::fopen(path.c_str(), "rb"));
  if (!in) return Error::unusable("This file is missing or cannot be read.", path);
  BagFile file;
  Hash hash;
  std::string piece(kPiece, '\0');
  while (true) {
    if (stop.stop_requested()) return Error::cancelled();
    const std::size_t size = std::fread(piece.data(), 1, piece.size(), in.get());
    const std::string_view bytes = std::string_view(piece).substr(0, size);
    hash.add(bytes);
    file.bytes += static_cast<std::int64_t>(size);
    if (!use(bytes)) return cannotWrite(path);
    if (size < piece.size()) break;
  }
  if (std::ferror(in.get()) != 0) return Error::unusable("The disk cannot read this file.", path);
  file.sha256 = hash.text();
  return file;
}

bool sync(std::FILE* file) {
  return std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0;
}

std::string manifestOf(const std::vector<BagFile>& files) {
  std::string text;
  for (const BagFile& file : files) text += file.sha256 + "  " + file.path + "\n";
  return text;
}

Result<std::map<std::string, std::string>> readManifest(const fs::path& path) {
  const Result<std::string> text = readFile(path);
  if (!text) return Error::unusable("The manifest is missing; this is no export of Ostraka.", path);
  std::map<std::string, std::string> hashes;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    const std::size_t blank = line.find_first_of(" \t");
    const std::size_t name = line.find_first_not_of(" \t*", blank);
    if (blank != 64 || name == std::string::npos)
      return Error::unusable("The manifest has a line that cannot be read: " + line.substr(0, 80),
                             path);
    std::string file = line.substr(name);
    if (!catalogue::checkedPath(file))
      return Error::unusable("The manifest names a file outside the folder: " + file, path);
    if (!hashes.emplace(std::move(file), line.substr(0, 64)).second)
      return Error::unusable("The manifest names a file twice: " + line.substr(name), path);
  }
  return hashes;
}

}  // namespace

Error cannotWrite(const fs::path& where) {
  return {ErrorCode::CannotWrite,
          "This cannot be written; check the space left and the permissions.", where.string()};
}

fs::path folderNamed(const fs::path& folder) {
  return fs::absolute(folder / "").lexically_normal().parent_path();
}

BagWriter::BagWriter(fs::path target)
    : target_(std::move(target)), partial_(target_.string() + ".partial") {}

BagWriter::BagWriter(BagWriter&& other) noexcept
    : target_(std::move(other.target_)),
      partial_(std::move(other.partial_)),
      files_(std::move(other.files_)),
      keys_(std::move(other.keys_)),
      bytes_(other.bytes_),
      open_(std::exchange(other.open_, false)) {}

BagWriter::~BagWriter() {
  std::error_code ignored;
  if (open_) fs::remove_all(partial_, ignored);
}

Result<BagWriter> BagWriter::begin(const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code))
    return Error::unusable("There is a folder of this name already; choose another name.", target);
  BagWriter writer(folderNamed(target));
  fs::remove_all(writer.partial_, code);  // of an export that was cut off
  fs::create_directories(writer.partial_ / "data", code);
  if (code) return cannotWrite(target);
  return writer;
}

Result<void> BagWriter::taken(const std::string& path) const {
  const Result<std::string> good = catalogue::checkedPath(path);
  if (!good) return good.error();
  if (path.find('%') != std::string::npos)
    return Error::unusable("A name in an export must not hold '%'.", path);
  if (keys_.contains(catalogue::uniqueKey(path)))
    return Error::unusable("Two files of the export would have the same name.", path);
  return {};
}

Result<BagFile> BagWriter::add(const std::string& path, std::string_view bytes) {
  if (Result<void> free = taken(path); !free) return free.error();
  const Result<void> written = writeFileAtomically(partial_ / "data" / path, bytes);
  if (!written) return written.error();
  BagFile file{"data/" + path, sha256(bytes), static_cast<std::int64_t>(bytes.size())};
  files_.push_back(file);
  keys_[catalogue::uniqueKey(path)] = path;
  bytes_ += file.bytes;
  return file;
}

Result<BagFile> BagWriter::addFile(const std::string& path, const fs::path& source,
                                   std::stop_token stop) {
  if (Result<void> free = taken(path); !free) return free.error();
  const fs::path to = partial_ / "data" / path;
  std::error_code code;
  fs::create_directories(to.parent_path(), code);
  const File out(std::fopen(to.c_str(), "wbx"));
  if (!out) return cannotWrite(to);
  Result<BagFile> file = readPieces(source, stop, [&](std::string_view piece) {
    return std::fwrite(piece.data(), 1, piece.size(), out.get()) == piece.size();
  });
  if (!file) return file;
  if (!sync(out.get())) return cannotWrite(to);
  file->path = "data/" + path;
  files_.push_back(*file);
  keys_[catalogue::uniqueKey(path)] = path;
  bytes_ += file->bytes;
  return file;
}

Result<void> BagWriter::finish(const std::map<std::string, std::string>& info,
                               const std::function<Result<void>(const fs::path&)>& check) {
  std::string info_text;
  for (const auto& [key, value] : info) {
    std::string line = value;
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::replace(line.begin(), line.end(), '\r', ' ');
    if (!line.empty()) info_text += key + ": " + line + "\n";
  }
  info_text +=
      "Payload-Oxum: " + std::to_string(bytes_) + "." + std::to_string(files_.size()) + "\n";
  const std::pair<const char*, std::string> tags[] = {{"bagit.txt", kDeclaration},
                                                      {"bag-info.txt", info_text},
                                                      {"manifest-sha256.txt", manifestOf(files_)}};
  std::vector<BagFile> tag_files;
  for (const auto& [name, text] : tags) {
    if (Result<void> written = writeFileAtomically(partial_ / name, text); !written) return written;
    tag_files.push_back({name, sha256(text), static_cast<std::int64_t>(text.size())});
  }
  const Result<void> last =
      writeFileAtomically(partial_ / "tagmanifest-sha256.txt", manifestOf(tag_files));
  if (!last) return last;
  if (check)
    if (Result<void> good = check(partial_); !good) return good;
  std::error_code code;
  if (fs::exists(target_, code))
    return Error::unusable("Somebody made a folder of this name meanwhile; choose another name.",
                           target_);
  fs::rename(partial_, target_, code);
  if (code) return cannotWrite(target_);
  open_ = false;
  const int folder = ::open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY);
  if (folder >= 0) {
    ::fsync(folder);
    ::close(folder);
  }
  return {};
}

Result<std::vector<BagFile>> checkBag(const fs::path& folder, Progress& progress,
                                      std::stop_token stop) {
  const Result<std::string> declaration = readFile(folder / "bagit.txt", 1 << 16);
  if (!declaration || !declaration->starts_with("BagIt-Version: "))
    return Error::unusable("This folder is no export of Ostraka: bagit.txt is missing.", folder);
  const Result<std::map<std::string, std::string>> listed =
      readManifest(folder / "manifest-sha256.txt");
  if (!listed) return listed.error();
  const Result<std::map<std::string, std::string>> tags =
      readManifest(folder / "tagmanifest-sha256.txt");
  if (!tags) return tags.error();
  std::error_code code;
  for (auto it = fs::recursive_directory_iterator(folder / "data", code);
       it != fs::recursive_directory_iterator(); it.increment(code)) {
    if (it->is_directory() && !it->is_symlink()) continue;
    const std::string name = it->path().lexically_relative(folder).generic_string();
    if (!listed->contains(name))
      return Error::unusable("This file is not in the manifest; nothing was read.", it->path());
    if (!it->is_regular_file() || it->is_symlink())
      return Error::unusable("This is a link, not a file; nothing was read.", it->path());
  }
  if (code &&
      code != std::errc::no_such_file_or_directory)  // a missing data/ lacks each file below
    return Error::unusable("This folder cannot be read (" + code.message() + "); nothing was read.",
                           folder / "data");
  std::vector<BagFile> files;
  const auto total = static_cast<std::int64_t>(listed->size() + tags->size());
  std::int64_t done = 0;
  for (const auto* list : {&*tags, &*listed})
    for (const auto& [name, hash] : *list) {
      progress.report(done++, total);
      Result<BagFile> file = readPieces(folder / name, stop, [](std::string_view) { return true; });
      if (!file && file.error().code == ErrorCode::Cancelled) return file.error();
      if (!file) return Error::unusable("This file is missing; nothing was read.", folder / name);
      if (file->sha256 != hash)
        return Error::unusable("This file was changed after the export; nothing was read.",
                               folder / name);
      file->path = name;
      if (list == &*listed) files.push_back(std::move(*file));
    }
  return files;
}

}  // namespace ostraka::exchange
