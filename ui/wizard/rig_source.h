#pragma once
#include <QString>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "capture/rig_devices.h"
#include "capture/sequence.h"

namespace ostraka::ui {

/// Which rig a project photographs with; kept in the catalogue as JSON under "rig".
struct RigChoice {
  enum class Kind { None, Virtual, File };
  Kind kind = Kind::None;
  std::filesystem::path file;  ///< RIG.json
  int sherds = 6;              ///< of the virtual rig
  int width_px = 1600;         ///< of its photographs
  std::uint64_t seed = 1;
  bool near_duplicates = false;  ///< two of the virtual sherds look alike

  QString toJson() const;
  static RigChoice fromJson(const QString& text);
};

/// How the wizard comes to its devices: a real rig stays open, the virtual one breaks another pot
/// for each batch.
struct RigSource {
  std::function<Result<std::shared_ptr<capture::RigDevices>>(
      int batch, const devices::AskPerson& ask, std::stop_token)>
      open;
  /// Puts into a new batch folder what belongs to the rig: plate, board, calibration.
  std::function<Result<void>(const std::filesystem::path& folder, int batch, Progress&,
                             std::stop_token)>
      prepare;
  /// Takes one side; another one in tests.
  std::function<Result<capture::SideSummary>(capture::RigDevices&, const capture::SideOptions&,
                                             const capture::OnCaptureEvent&, Progress&,
                                             std::stop_token)>
      shoot = capture::shootSide;
  /// Counts the sherds of a side that was photographed in an earlier run.
  std::function<capture::SideCheck(const std::vector<std::vector<std::filesystem::path>>&,
                                   const batch::Plate&, const capture::InspectionOptions&,
                                   std::stop_token)>
      check = capture::checkSide;
  /// Programs of the desktop that hold a camera, and how they are made to let go (wish W4); absent
  /// where there is no such camera.
  std::function<std::vector<std::string>()> holders{};
  std::function<Result<void>(std::stop_token)> release{};
  bool anew_for_each_batch = false;
  bool turns_sherds = false;  ///< over, by itself
  int stops = 8;
  QString words;  ///< for the line at the head: "ready (2 days old)"
};

/// What prepare() tells of its photographs while it takes them; of none: total is 0.
struct PreparedPhotographs {
  int done = 0, total = 0;
};

RigSource virtualRigSource(const RigChoice& choice);
RigSource fileRigSource(const std::filesystem::path& rig_file);

}  // namespace ostraka::ui
