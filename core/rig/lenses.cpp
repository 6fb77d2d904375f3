#include "rig/lenses.h"

#include <map>
#include <string>
#include <tuple>

#include "batch/exif.h"

namespace ostraka::rig {

std::vector<int> lensesOf(std::span<const batch::Shot> shots) {
  std::map<std::tuple<int, int, std::string, double>, int> numbers;
  std::vector<int> lenses;
  for (const batch::Shot& shot : shots) {
    const batch::Exif exif = batch::readExif(shot.file);
    lenses.push_back(numbers
                         .try_emplace({shot.width, shot.height, exif.make + exif.model,
                                       exif.focal_length_mm.value_or(0)},
                                      static_cast<int>(numbers.size()))
                         .first->second);
  }
  return lenses;
}

}  // namespace ostraka::rig
