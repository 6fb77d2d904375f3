#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "files/open_folder.h"
#include "upkeep/file_check.h"

namespace ostraka::upkeep {

/// When each file was last checked, and the result: PROJECT/file-checks.txt, one line at a time, so
/// that a check that is killed loses nothing. It contains nothing that cannot be found again; a
/// file that cannot be read or written is ignored.
class FileCheckLog {
 public:
  struct Seen {
    std::int64_t at_ms = 0;
    std::string sha256;  ///< as the catalogue had it then
    std::optional<Damage> damage;
    std::string stamp;  ///< what stampOf() gave before it was read; empty: not known
  };
  /// What changes when somebody writes to the file, puts another in its place or brings the project
  /// to another disk: size, inode, times. No file can be given the stamp of another on purpose, as
  /// nobody sets the time of its last change. Empty where there is no regular file.
  static std::string stampOf(const std::filesystem::path& file);
  explicit FileCheckLog(const std::filesystem::path& project);
  /// Null: never, or the catalogue holds another hash by now.
  const Seen* seen(const KnownFile& file) const;
  void note(const KnownFile& file, std::int64_t at_ms, std::optional<Damage> damage,
            const std::string& stamp);
  /// When the check of all files began that did not end; 0: none is under way.
  std::int64_t begun_ms() const { return begun_ms_; }
  void begin(std::int64_t at_ms);
  void end(std::int64_t at_ms);

 private:
  void read(const std::string& line);
  void write(const std::string& line);
  void rewrite() const;
  std::filesystem::path path_;
  std::map<std::string, Seen> seen_;  ///< by path
  std::int64_t begun_ms_ = 0;
  FileDescriptor file_;  ///< opened when the first line is written
  bool is_cut_off_ = false;
};

}  // namespace ostraka::upkeep
