#pragma once
#include <filesystem>
#include <string>

namespace ostraka {

/// Where a part of the program lies that is not in every process: beside the running program's
/// file, or in ../libexec/ostraka of its folder, as installed. One that is in neither gets the
/// first place.
std::filesystem::path programPart(const std::string& name);

}  // namespace ostraka
