#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "base/message.h"
#include "batch/batch.h"
#include "calibration/calibrate.h"
#include "checks/known_scale.h"

namespace ostraka::checks {

/// What is known besides plate.json about the size of what a batch's photographs show.
struct ScaleCheck {
  nlohmann::ordered_json lengths;  ///< of scale.json, true and found, for the report
  std::vector<Message> doubts;     ///< whole sentences; one holds the result for a person
  std::vector<Message> warnings;   ///< of the lengths; poses.warnings has the others already
  std::vector<Message> agreeing;   ///< lengths that are as they should be, with their figures
};

/// Compares the marked lengths of scale.json, and the distances between markers that took no part
/// in the fit, with what the posed photographs make of them.
ScaleCheck checkScale(const calibration::BatchPoses& poses,
                      const std::vector<batch::KnownLength>& lengths);

/// "the length of 50.00 mm marked on the front side measures 49.51 +- 0.06 mm (-0.98 %)".
Message sentence(const checks::CheckedLength& length);

}  // namespace ostraka::checks
