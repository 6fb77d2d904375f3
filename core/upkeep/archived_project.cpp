#include "upkeep/archived_project.h"

#include <system_error>

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

bool isBag(const fs::path& folder) {
  std::error_code code;
  return fs::exists(folder / "bagit.txt", code);
}

}  // namespace

fs::path archiveAt(const fs::path& folder) {
  std::error_code code;
  const fs::path data = fs::weakly_canonical(folder / "catalogue.sqlite", code).parent_path();
  if (data.filename() == "data" && isBag(data.parent_path())) return data.parent_path();
  const bool of_project = fs::is_regular_file(folder / "data" / "catalogue.sqlite", code);
  return of_project && isBag(folder) ? fs::canonical(folder, code) : fs::path();
}

}  // namespace ostraka::upkeep
