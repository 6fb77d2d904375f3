#include "checks/scale_check.h"

#include <cmath>

#include "base/text.h"
#include "calibration/held_out.h"

namespace ostraka::checks {
namespace {

std::string doubtOf(const checks::CheckedLength& length) {
  const bool too_small = length.error() < 0;
  return "The scale is wrong: " + sentence(length) + ", so all measurements would be " +
         fixed(100 * std::abs(length.error()), 2) + " % too " + (too_small ? "small" : "large") +
         "; measure the ruler on the plate and set its true size in plate.json with 'ostraka plate "
         "--ruler-measured', or reprint the plate at 100 %; if the plate is correct, measure the "
         "length and set its marks again.";
}

std::string unusable(const batch::KnownLength& known) {
  return "The length of " + fixed(known.length_mm, 2) + " mm in scale.json could not be checked: " +
         "mark each of its ends on at least two photographs of the " + batch::name(known.side) +
         " side, taken from different directions.";
}

}  // namespace

std::string sentence(const checks::CheckedLength& length) {
  const std::string sign = length.error() < 0 ? "" : "+";
  return "the length of " + fixed(length.true_mm, 2) + " mm marked on the " +
         batch::name(length.side) + " side measures " + fixed(length.found_mm, 2) + " +- " +
         fixed(length.sd_mm, 2) + " mm in the photographs (" + sign +
         fixed(100 * length.error(), 2) + " %)";
}

ScaleCheck checkScale(const calibration::BatchPoses& poses,
                      const std::vector<batch::KnownLength>& lengths) {
  ScaleCheck check;
  check.lengths = nlohmann::ordered_json::array();
  for (const calibration::HeldOutDistance& distance : poses.held_out)
    if (const std::optional<std::string> doubt = calibration::scaleDoubt(distance))
      check.doubts.push_back(*doubt);
  const std::vector<std::optional<checks::CheckedLength>> found =
      checks::checkLengths(poses.images, lengths);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) {
      check.warnings.push_back(unusable(lengths[i]));
      continue;
    }
    check.lengths.push_back({{"side", batch::name(found[i]->side)},
                             {"true_mm", found[i]->true_mm},
                             {"found_mm", found[i]->found_mm},
                             {"sd_mm", found[i]->sd_mm},
                             {"error_pct", 100 * found[i]->error()},
                             {"contradicts", found[i]->contradicts()}});
    if (!found[i]->contradicts()) {
      check.agreeing.push_back("scale: " + sentence(*found[i]));
      continue;
    }
    check.doubts.push_back(doubtOf(*found[i]));
    check.warnings.push_back(check.doubts.back());
  }
  return check;
}

}  // namespace ostraka::checks
