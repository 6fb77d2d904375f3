#include "checks/scale_check.h"

#include <cmath>

#include "base/text.h"
#include "calibration/held_out.h"

namespace ostraka::checks {
namespace {

Message doubtOf(const checks::CheckedLength& length) {
  const Decimal off = decimal(100 * std::abs(length.error()), 2);
  return length.error() < 0
             ? message(
                   "The scale is wrong: %1, so all measurements would be %2 % too small; measure "
                   "the ruler on the plate and set its true size in plate.json with 'ostraka plate "
                   "--ruler-measured', or reprint the plate at 100 %; if the plate is correct, "
                   "measure the length and set its marks again.",
                   sentence(length), off)
             : message(
                   "The scale is wrong: %1, so all measurements would be %2 % too large; measure "
                   "the ruler on the plate and set its true size in plate.json with 'ostraka plate "
                   "--ruler-measured', or reprint the plate at 100 %; if the plate is correct, "
                   "measure the length and set its marks again.",
                   sentence(length), off);
}

Message unusable(const batch::KnownLength& known) {
  const Decimal length = decimal(known.length_mm, 2);
  return known.side == batch::Side::Front
             ? message(
                   "The length of %1 mm in scale.json could not be checked: mark each of its ends "
                   "on at least two photographs of the front side, taken from different "
                   "directions.",
                   length)
             : message(
                   "The length of %1 mm in scale.json could not be checked: mark each of its ends "
                   "on at least two photographs of the back side, taken from different directions.",
                   length);
}

}  // namespace

Message sentence(const checks::CheckedLength& length) {
  const Decimal truth = decimal(length.true_mm, 2), found = decimal(length.found_mm, 2),
                sd = decimal(length.sd_mm, 2);
  const std::string off = (length.error() < 0 ? "" : "+") + fixed(100 * length.error(), 2);
  return length.side == batch::Side::Front
             ? message(
                   "the length of %1 mm marked on the front side measures %2 +- %3 mm in the "
                   "photographs (%4 %)",
                   truth, found, sd, off)
             : message(
                   "the length of %1 mm marked on the back side measures %2 +- %3 mm in the "
                   "photographs (%4 %)",
                   truth, found, sd, off);
}

ScaleCheck checkScale(const calibration::BatchPoses& poses,
                      const std::vector<batch::KnownLength>& lengths) {
  ScaleCheck check;
  check.lengths = nlohmann::ordered_json::array();
  for (const calibration::HeldOutDistance& distance : poses.held_out)
    if (const std::optional<Message> doubt = calibration::scaleDoubt(distance))
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
      check.agreeing.push_back(about("scale", sentence(*found[i])));
      continue;
    }
    check.doubts.push_back(doubtOf(*found[i]));
    check.warnings.push_back(check.doubts.back());
  }
  return check;
}

}  // namespace ostraka::checks
