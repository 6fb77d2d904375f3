#include "archive/bagit.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <utility>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/catalogue.h"
#include "catalogue/settings.h"
#include "files/checksum.h"
#include "files/files.h"
#include "store/values.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDeclaration = "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n";
struct Closing {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closing>;

bool sync(std::FILE* file) {
  return std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0;
}

std::string manifestOf(const std::vector<BagFile>& files) {
  std::string text;
  for (const BagFile& file : files) text += file.sha256 + "  " + inManifest(file.path) + "\n";
  return text;
}

}  // namespace

// RFC 8493, section 2.1.3; store::checkedPath() leaves no line breaks, the other two.
std::string inManifest(std::string path) {
  for (std::size_t at = path.find('%'); at != std::string::npos; at = path.find('%', at + 3))
    path.replace(at, 1, "%25");
  return path;
}

std::string fromManifest(std::string name) {
  for (std::size_t at = name.find('%'); at != std::string::npos; at = name.find('%', at + 1)) {
    const std::string code = name.substr(at + 1, 2);
    if (code == "25") name.erase(at + 1, 2);
    if (code == "0A" || code == "0a") name.replace(at, 3, "\n");
    if (code == "0D" || code == "0d") name.replace(at, 3, "\r");
  }
  return name;
}

Result<std::map<std::string, std::string>> bagInfo(const catalogue::Catalogue& catalogue,
                                                   const std::string& program) {
  const auto project = catalogue::Settings(catalogue).project();
  if (!project) return project.error();
  return std::map<std::string, std::string>{{"Source-Organization", project->institution},
                                            {"External-Description", project->title},
                                            {"External-Identifier", project->code},
                                            {"Bagging-Date", utcDay(catalogue.now())},
                                            {"Bag-Software-Agent", program}};
}

fs::path folderNamed(const fs::path& folder) {
  return fs::absolute(folder / "").lexically_normal().parent_path();
}

Result<BagWriter> BagWriter::begin(const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code))
    return Error::unusable(message("A folder with this name already exists; choose another name."),
                           target);
  Result<NewFolder> folder = NewFolder::begin(target);
  if (!folder) return folder.error();
  if (const Result<void> made = makeFolder(folder->path() / "data"); !made) return made.error();
  return BagWriter(folderNamed(target), std::move(*folder));
}

Result<void> BagWriter::take(const std::string& path) {
  const Result<std::string> good = store::checkedPath(path);
  if (!good)
    return Error::unusable(
        message("Not every system supports names with a line break, a backslash or characters that "
                "are not UTF-8; rename this file or folder, then try again."),
        path);
  return distinct_.add(path);
}

Result<BagFile> BagWriter::add(const std::string& path, std::string_view bytes) {
  if (Result<void> free = take(path); !free) return free.error();
  const Result<void> written = writeFileAtomically(folder_.path() / "data" / path, bytes);
  if (!written) return written.error();
  BagFile file{"data/" + path, sha256(bytes), static_cast<std::int64_t>(bytes.size())};
  files_.push_back(file);
  bytes_ += file.bytes;
  return file;
}

Result<BagFile> BagWriter::addFile(const std::string& path, const fs::path& source,
                                   std::stop_token stop) {
  Result<OpenFile> in = OpenFile::open(source);
  return in ? addFile(path, std::move(*in), std::move(stop)) : Result<BagFile>(in.error());
}

Result<BagFile> BagWriter::addFile(const std::string& path, OpenFile source, std::stop_token stop) {
  if (Result<void> free = take(path); !free) return free.error();
  const fs::path to = folder_.path() / "data" / path;
  if (const Result<void> made = makeFolder(to.parent_path()); !made) return made.error();
  const File out(std::fopen(to.c_str(), "wbx"));
  if (!out) return cannotWrite(to, errno);
  const Result<Checksum> sum =
      checksumOf(source, stop, [&](std::string_view piece) -> Result<void> {
        if (std::fwrite(piece.data(), 1, piece.size(), out.get()) == piece.size()) return {};
        return cannotWrite(to, errno);
      });
  if (!sum) return sum.error();
  if (!sync(out.get())) return cannotWrite(to, errno);
  files_.push_back({"data/" + path, sum->sha256, sum->bytes});
  bytes_ += sum->bytes;
  return files_.back();
}

void BagWriter::tag(const std::string& name, const std::string& text) {
  tags_.emplace_back(name, text);
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
  tag("bagit.txt", kDeclaration);
  tag("bag-info.txt", info_text);
  tag("manifest-sha256.txt", manifestOf(files_));
  std::vector<BagFile> tag_files;
  for (const auto& [name, text] : tags_) {
    if (Result<void> written = writeFileAtomically(folder_.path() / name, text); !written)
      return written;
    tag_files.push_back({name, sha256(text), static_cast<std::int64_t>(text.size())});
  }
  const Result<void> last =
      writeFileAtomically(folder_.path() / "tagmanifest-sha256.txt", manifestOf(tag_files));
  if (!last) return last;
  if (check)
    if (Result<void> good = check(folder_.path()); !good) return good;
  std::error_code code;
  if (fs::exists(target_, code))
    return Error::unusable(
        message("A folder with this name was created in the meantime; choose another name."),
        target_);
  return folder_.finish();
}

}  // namespace ostraka::archive
