#include "base/program_parts.h"

namespace ostraka {

std::filesystem::path programPart(const std::string& name) {
  std::error_code failed;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
  const std::filesystem::path installed = folder.parent_path() / "libexec/ostraka" / name;
  return std::filesystem::exists(folder / name, failed) ||
                 !std::filesystem::exists(installed, failed)
             ? folder / name
             : installed;
}

}  // namespace ostraka
