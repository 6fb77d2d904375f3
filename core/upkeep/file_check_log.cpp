#include "upkeep/file_check_log.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <iterator>
#include <sstream>
#include <utility>

#include "files/files.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLog = "file-checks.txt";
constexpr std::size_t kMostLogBytes = std::size_t{256} << 20;
constexpr std::size_t kSpareLines = 1000;
constexpr const char* kNoStamp = "-";
constexpr const char* kFindings[] = {"missing", "changed", "unreadable", "whole"};

const char* finding(std::optional<Damage> damage) {
  return damage ? kFindings[static_cast<int>(*damage)] : "whole";
}

std::string lineOf(const std::string& path, const FileCheckLog::Seen& seen) {
  return std::to_string(seen.at_ms) + " " + finding(seen.damage) + " " + seen.sha256 + " " +
         (seen.stamp.empty() ? kNoStamp : seen.stamp) + " " + path + "\n";
}

std::string roundLine(const char* what, std::int64_t at_ms) {
  return std::to_string(at_ms) + " " + what + "\n";
}

}  // namespace

FileCheckLog::FileCheckLog(const fs::path& project) : path_(project / kLog) {
  const Result<std::string> text = readFile(path_, kMostLogBytes);
  if (!text) return;
  std::size_t lines = 0;
  std::istringstream in(*text);
  for (std::string line; std::getline(in, line); ++lines) {
    is_cut_off_ = in.eof();
    if (!is_cut_off_) read(line);
  }
  if (lines <= 2 * seen_.size() + kSpareLines) return;
  rewrite();
  is_cut_off_ = false;
}

void FileCheckLog::read(const std::string& line) {
  std::istringstream words(line);
  std::int64_t at_ms = 0;
  std::string what, hash, stamp, path;
  if (!(words >> at_ms >> what)) return;
  if (what == "begin") begun_ms_ = at_ms;
  if (what == "end") begun_ms_ = 0;
  if (!(words >> hash >> stamp) || !std::getline(words >> std::ws, path)) return;
  for (std::size_t i = 0; i < std::size(kFindings); ++i)
    if (what == kFindings[i])
      seen_[path] = {at_ms, hash, i < 3 ? std::optional(static_cast<Damage>(i)) : std::nullopt,
                     stamp == kNoStamp ? std::string() : stamp};
}

void FileCheckLog::write(const std::string& line) {
  if (!file_.isOpen())
    file_ = FileDescriptor(::open(
        path_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
  // One write a line: those of two programs do not mix. Behind one that was cut off begins another.
  const std::string whole = std::exchange(is_cut_off_, false) ? "\n" + line : line;
  if (file_.isOpen() && ::write(file_.get(), whole.data(), whole.size()) < 0) return;
}

void FileCheckLog::rewrite() const {
  std::string text;
  for (const auto& [path, seen] : seen_) text += lineOf(path, seen);
  if (begun_ms_ > 0) text += roundLine("begin", begun_ms_);
  if (const Result<void> written = writeFileAtomically(path_, text); !written) return;
}

const FileCheckLog::Seen* FileCheckLog::seen(const KnownFile& file) const {
  const auto found = seen_.find(file.path);
  return found != seen_.end() && found->second.sha256 == file.sha256 ? &found->second : nullptr;
}

std::string FileCheckLog::stampOf(const fs::path& file) {
  struct stat now {};
  if (::lstat(file.c_str(), &now) != 0 || !S_ISREG(now.st_mode)) return {};
  const auto time = [](const timespec& t) {
    return std::to_string(t.tv_sec) + "." + std::to_string(t.tv_nsec);
  };
  return std::to_string(now.st_size) + "," + std::to_string(now.st_ino) + "," + time(now.st_mtim) +
         "," + time(now.st_ctim);
}

void FileCheckLog::note(const KnownFile& file, std::int64_t at_ms, std::optional<Damage> damage,
                        const std::string& stamp) {
  if (file.sha256.empty()) return;
  Seen& seen = seen_[file.path] = {at_ms, file.sha256, damage, stamp};
  write(lineOf(file.path, seen));
}

void FileCheckLog::begin(std::int64_t at_ms) {
  begun_ms_ = at_ms;
  write(roundLine("begin", at_ms));
}

void FileCheckLog::end(std::int64_t at_ms) {
  begun_ms_ = 0;
  write(roundLine("end", at_ms));
}

}  // namespace ostraka::upkeep
