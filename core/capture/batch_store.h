#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "capture/manifest.h"
#include "devices/camera.h"
#include "files/folder_lock.h"

namespace ostraka::capture {

/// A photograph on its way into the batch: its bytes are on disk under a hidden name.
struct Arriving {
  ManifestEntry entry;
  std::vector<std::string> files;  ///< final names, relative to the batch; the photograph first
};

/// The batch's folder while it is being photographed. Nothing in it is ever overwritten; a crash at
/// any moment leaves whole photographs that the manifest names, or none. It is held for one program
/// at a time.
class BatchStore {
 public:
  /// Makes the folder and plate.json, reads the manifest, and tidies up after a crash. Errors:
  /// UnusableInput (photographs that are not in the manifest, another plate, another number of
  /// stops or cameras, a link in the place of one of the batch's folders), CannotWrite (another
  /// program photographs this batch).
  static Result<BatchStore> open(const std::filesystem::path& batch, batch::Side side, int stops,
                                 int cameras, const batch::Plate& plate);

  /// Writes and syncs the files of one shot; may be called by several threads for several cameras.
  /// Errors: CannotWrite; UnusableInput when no file is a JPEG, PNG or TIFF.
  Result<Arriving> stage(const std::vector<devices::CameraFile>& files, int camera, int stop,
                         double angle_deg, const devices::CameraId& id) const;
  /// The manifest first, then the names: all arriving photographs are in the batch.
  Result<void> commit(std::vector<Arriving> arriving);
  /// Shots that are not kept go to the folder set_aside: the manifest first, then the names, so
  /// that all of them are out of the batch or none. Shots that are not there are passed over.
  Result<void> setAside(const std::vector<ShotName>& shots, const std::string& reason);
  Result<void> save() const { return writeManifest(batch_, manifest_); }

  /// Are these very bytes those of another stop, camera or side?
  bool holdsElsewhere(const ManifestEntry& entry) const;
  /// "exposure is 1/60, the rig says 1/8": settings that are not the rig's; what the rig does not
  /// name is compared with the camera's first photograph that is in use. Empty: all are the same.
  std::vector<Message> otherSettings(const ManifestEntry& entry,
                                     const std::map<std::string, std::string>& of_rig) const;
  Manifest& manifest() { return manifest_; }
  const Manifest& manifest() const { return manifest_; }
  std::filesystem::path fileOf(const ManifestEntry& entry) const { return batch_ / entry.file; }

  BatchStore(BatchStore&&) = default;
  BatchStore& operator=(BatchStore&&) = default;
  ~BatchStore() { held_.endWithoutTrace(); }

 private:
  explicit BatchStore(FolderLock held) : held_(std::move(held)) {}
  Result<void> tidyUp(batch::Side side);
  Result<void> finishAside(const ManifestEntry& entry) const;
  Result<void> finishRaw(const ManifestEntry& entry) const;

  FolderLock held_;
  std::filesystem::path batch_;
  batch::Side side_ = batch::Side::Front;
  Manifest manifest_;
};

/// Before anything of another rig is written into a batch that has photographs. Errors:
/// UnusableInput: they were taken on another plate than this one.
Result<void> checkPlate(const std::filesystem::path& batch, const batch::Plate& plate);

}  // namespace ostraka::capture
