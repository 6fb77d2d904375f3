#pragma once
#include <string>
#include <vector>

#include "calibration/calibration_report.h"

namespace ostraka::calibration {

/// What the pictures of the board leave open: regions of the picture, tilts, their number.
void adviseOnBoard(const CameraCalibration& camera, std::vector<std::string>& missing);

/// What the plate's photographs leave open (stops, markers, scale), and the verdict on all.
void adviseOnPlate(const BatchPoses& poses, CalibrationReport& report);

}  // namespace ostraka::calibration
