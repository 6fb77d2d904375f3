#include "refusals_file.h"

#include <string>
#include <system_error>

#include "files/files.h"
#include "files/input_file.h"
#include "files/output_place.h"
#include "tables/import_table.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;

Result<void> checkReplaced(const fs::path& file) {
  const std::string head = tables::refusalsCsv({});
  Result<InputFile> there = InputFile::open(file);
  if (!there) return there.error();
  const Result<std::string> begin = there->read(head.size());
  if (!begin) return begin.error();
  if (*begin == head) return {};
  return Error::unusable(
      "This file already exists and is not a table of refusals; choose another name.",
      file.string());
}

}  // namespace

Result<void> checkRefusalsFile(const fs::path& file) {
  if (file.empty()) return {};
  if (Result<void> good = checkOutputPlace(file); !good) return good;
  std::error_code failed;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failed))
    return Error::unusable("There is no such folder; create it, or choose another location.",
                           folder.string());
  if (!file.has_filename())
    return Error::unusable("This is a folder, not a file; add the name of the table.",
                           file.string());
  if (Message other = otherThanAFile(file); !other.empty())
    return Error::unusable(std::move(other), file.string());
  if (fs::exists(fs::symlink_status(file, failed)))
    if (Result<void> good = checkReplaced(file); !good) return good;
  if (!mayBeWritten(folder))
    return Error::unusable(
        "The folder cannot be written to; check its permissions, or choose another location.",
        folder.string());
  return {};
}

}  // namespace ostraka::app
