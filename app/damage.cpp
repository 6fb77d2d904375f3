#include "damage.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "shown.h"

namespace ostraka::app {

void printDamage(std::span<const upkeep::DamagedFile> damaged) {
  for (const upkeep::DamagedFile& file : damaged) show(stderr, "%s\n", sentenceOf(file).c_str());
}

nlohmann::ordered_json damageJson(std::span<const upkeep::DamagedFile> damaged) {
  constexpr const char* kWords[] = {"missing", "changed", "unreadable"};
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [file, damage] : damaged)
    list.push_back({{"path", file.path},
                    {"damage", kWords[static_cast<int>(damage)]},
                    {"role", file.role},
                    {"sherd", file.sherd},
                    {"batch", file.batch}});
  return list;
}

}  // namespace ostraka::app
