#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "capture/manifest.h"
#include "capture/shot_checks.h"
#include "devices/camera.h"
#include "devices/clock.h"
#include "devices/turntable.h"

namespace ostraka::capture {

/// The opened devices of a rig, real or virtual.
struct RigDevices {
  std::unique_ptr<devices::Turntable> turntable;
  std::vector<std::unique_ptr<devices::Camera>>
      cameras;            ///< by place; a shot's camera number is its index
  batch::Plate plate;     ///< what lies on the table
  double settle_s = 1.5;  ///< from standstill to a still picture
  /// By camera, as RIG.json has them: set before each side, compared at each shot. A camera without
  /// any is compared with its own first shot.
  std::vector<std::map<std::string, std::string>> wanted_settings{};
  std::shared_ptr<devices::Clock> clock = devices::steadyClock();
  /// SHA-256 of every photograph that the cameras handed over since they were opened: none of them
  /// is accepted a second time, whatever side and batch is shot next.
  std::set<std::string> delivered{};
  /// Tells the rig that a person turned the sherds over: the virtual one does it then.
  std::function<void(batch::Side)> side_placed;
};

enum class CaptureEventKind {
  Turning,       ///< to `stop`
  Settling,      ///< at `stop`
  PressShutter,  ///< a person has to press the button of `camera`
  Shooting,      ///< all cameras, at `stop`
  ShotKept,      ///< `file` is safely on disk; `check` may still hold problems
  ShotRefused,   ///< `camera` at `stop` is taken again; `check` or `trouble` says why
  Trouble,       ///< a device failed and is tried again; `trouble` says why
  StopDone       ///< all photographs of `stop` are on disk
};

struct CaptureEvent {
  CaptureEventKind kind{};
  batch::Side side{};
  int stop = -1;                 ///< 0 .. stops - 1; -1: none in particular
  int camera = -1;               ///< -1: none in particular
  std::filesystem::path file{};  ///< of ShotKept and ShotRefused
  ShotCheck check{};             ///< of ShotKept and ShotRefused
  Message trouble{};             ///< one sentence
  int take = 0;                  ///< from 1
};

/// Called one at a time, from threads of the sequence.
using OnCaptureEvent = std::function<void(const CaptureEvent&)>;

struct SideOptions {
  std::filesystem::path batch;  ///< folder; files become <side>/cam0_pos00.jpg
  batch::Side side = batch::Side::Front;
  int stops = 8;
  int tries_per_shot = 3;        ///< of a shot that blurred or came from another stop
  int tries_per_device = 3;      ///< reopened after it was gone or silent
  double fetch_timeout_s = 30;   ///< from the trigger to the whole file
  double press_timeout_s = 600;  ///< the same where a person presses the button
  std::vector<ShotName> retake;  ///< kept shots that a person wants again
  Result<void> check() const;
};

struct SideSummary {
  int kept = 0;                   ///< photographs of the side on disk, all takes before included
  std::vector<ShotName> flagged;  ///< kept, but with problems
  /// A sherd is cut off in one of these: sherds or a camera must be moved, and then the whole side
  /// is photographed again.
  bool cut_off = false;
  SideCheck check;
  double overhead_s = 0;  ///< beyond turning, settling, exposure and transfer, all stops
};

/// Turn, settle, shoot all cameras at once, fetch, check; stop after stop. Photographs that the
/// batch's manifest names and that are whole are not taken again: calling it again after an error,
/// a crash or Cancelled goes on where it ended. Every file is on disk, decoded and in the manifest
/// with its SHA-256 before the next stop is shot; nothing is ever overwritten.
/// Before the first shot the table stands for a throw-away exposure a third of a step before the
/// stop, where no photograph is ever kept: a camera that hands over a photograph of an earlier
/// trigger is found out by the angle between the two.
/// Errors: Missing (a device is gone; the sentence says which and what is safe), CannotWrite,
/// NotEnough (the table's position is not known), UnusableInput, Cancelled (within 5 s).
Result<SideSummary> shootSide(RigDevices& devices, const SideOptions& options,
                              const OnCaptureEvent& on_event, Progress& progress,
                              std::stop_token stop);

/// The shots of a side that are still to be taken, in their order: 'go on at stop 5, camera B'.
Result<std::vector<ShotName>> missingShots(const SideOptions& options, int cameras);

/// Before clearing the plate: is every sherd of the front there on the back? One sentence a
/// complaint; none: the plate may be cleared.
std::vector<Message> compareSides(const SideCheck& front, const SideCheck& back);

}  // namespace ostraka::capture
