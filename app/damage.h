#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "upkeep/file_check.h"

namespace ostraka::app {

/// Files of the project that are missing or changed: a line each on standard error, and as JSON.
void printDamage(std::span<const upkeep::DamagedFile> damaged);
nlohmann::ordered_json damageJson(std::span<const upkeep::DamagedFile> damaged);

}  // namespace ostraka::app
