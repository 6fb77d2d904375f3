#pragma once
#include <vector>

#include "base/message.h"
#include "calibration/calibration_report.h"

namespace ostraka::calibration {

/// What the pictures of the board leave open: regions of the picture, tilts, their number.
void adviseOnBoard(const CameraCalibration& camera, std::vector<Message>& missing);

/// What the plate's photographs leave open (stops, markers, scale), and the verdict on all.
void adviseOnPlate(const BatchPoses& poses, CalibrationReport& report);

}  // namespace ostraka::calibration
