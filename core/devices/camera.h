#pragma once
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.h"

namespace ostraka::devices {

struct CameraId {
  std::string driver;  ///< "gphoto2", "uvc", "folder" or "virtual"
  std::string model;   ///< as the camera calls itself
  std::string serial;  ///< what binds a camera to its place; ports change at each plug-in
  std::string port;    ///< where it is plugged in now: for people only
};

/// One thing that can be set. The same names for every kind of camera: "iso", "aperture",
/// "exposure", "white_balance", "focus", "format"; others as the camera calls them.
struct CameraSetting {
  std::string name;
  std::string value;                 ///< as read from the camera just now
  std::vector<std::string> choices;  ///< empty: the camera names none
  bool read_only = false;
};

/// A file that the camera made for one shot, whole, in memory.
struct CameraFile {
  std::string name;   ///< on the camera: may repeat and roll over, never used as ours
  std::string bytes;  ///< JPEG, PNG, TIFF or a raw format
};

/// A camera of the rig. Calls come from one thread at a time, any thread; several cameras are
/// driven at once. Errors name the camera; Missing means that it is gone or does not answer:
/// reopen() may bring it back. What was changed is restored by close() and by the destructor.
class Camera {
 public:
  virtual ~Camera() = default;

  virtual CameraId id() const = 0;

  virtual Result<std::vector<CameraSetting>> settings() = 0;
  /// Sets and reads back; the value read is returned. UnusableInput: no such setting or choice, or
  /// the camera kept another value.
  virtual Result<CameraSetting> set(const std::string& name, const std::string& value) = 0;

  /// A small live picture as JPEG. Missing, and no defect, when this kind has none.
  virtual Result<std::string> preview(std::stop_token stop) = 0;

  /// Before a shot: everything that an earlier one left behind is fetched and dropped, so that
  /// what comes next belongs to this shot.
  virtual Result<void> getReady(std::stop_token stop) = 0;
  /// False: a person or the turntable's output presses the button, trigger() does nothing.
  virtual bool triggersItself() const { return true; }
  virtual Result<void> trigger() = 0;
  /// True: fetch() can only hand over what this trigger() made. False: a file may be late, or be
  /// one of an earlier trigger, and has to be checked.
  virtual bool fileIsOfItsTrigger() const { return false; }
  /// Waits for the files of this shot (two for RAW and JPEG). Missing after timeout_s.
  virtual Result<std::vector<CameraFile>> fetch(double timeout_s, std::stop_token stop) = 0;
  /// After Missing: looks for the same serial number again, wherever it is plugged in now.
  virtual Result<void> reopen(std::stop_token stop) = 0;
  /// Restores what was changed and lets the camera go. Again: nothing happens.
  virtual Result<void> close() = 0;
};

}  // namespace ostraka::devices
