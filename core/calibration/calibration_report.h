#pragma once
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "calibration/calibrate.h"

namespace ostraka::calibration {

/// What a person measured on the plate with a calliper, to check the scale.
struct MarkerLength {
  int first = 0, second = 0;  ///< markers' ids
  double mm = 0;              ///< between the middles of their outer edges
};

struct CalibrationOptions {
  int threads = 0;  ///< <= 0: all processors of this process
  std::vector<MarkerLength> lengths;
  Result<void> check() const;
};

enum class Verdict { Good, Usable, NotUsable };

/// One camera as calibrated.
struct CameraCalibration {
  int camera = 0, width = 0, height = 0;
  double focal_px = 0, focal_sd_px = 0, lens_rms_px = 0;
  std::size_t pictures = 0;   ///< of the board, used
  std::string worst_picture;  ///< empty without pictures of the board
  double worst_picture_rms_px = 0;
  /// Corners of the board in each ninth of the picture, rows from the top left.
  std::array<int, 9> corners_per_region{};
  double largest_tilt_rad = 0;   ///< of the board against the picture
  int tilted_pictures = 0;       ///< by more than 20 degrees
  double plate_residual_px = 0;  ///< median over the plate's markers; 0 without photographs of it
};

struct MeasuredLength {
  MarkerLength length;
  double found_mm = 0;
};

/// What a calibration found, in figures and in words.
struct CalibrationReport {
  std::optional<rig::Rig>
      rig;  ///< nothing where only the board was photographed, or the lens is unknown
  std::vector<CameraCalibration> cameras;
  double reprojection_rms_px = 0;  ///< of the plate's markers
  std::vector<HeldOutDistance> held_out;
  std::vector<MeasuredLength> lengths;
  Verdict verdict = Verdict::NotUsable;
  Message verdict_in_words;
  std::vector<Message> missing;    ///< what to shoot or do, whole sentences
  std::vector<Message> set_aside;  ///< pictures that could not be used, each with its reason
};

/// Calibrates from photographs. folder: a batch, the front of one (front/, calib/, plate.json,
/// board.json), or pictures of a board alone with its board.json (ChArUco or plain grid; named
/// cam<C>_cal<NN> where there are several cameras): then the lenses only. Nothing is written.
/// Errors: UnusableInput, NotEnough, Failed, Cancelled.
Result<CalibrationReport> calibrateFolder(const std::filesystem::path& folder,
                                          const CalibrationOptions& options, Progress& progress,
                                          std::stop_token stop);

/// False: a held-out distance or a known length is off by more than kMostScaleError. A person must
/// find out why before anything rests on this rig.
bool scaleIsRight(const CalibrationReport& report);

/// The report for a person, line by line; for the terminal and the window.
std::vector<Message> inWords(const CalibrationReport& report);

}  // namespace ostraka::calibration
