#include "capture/batch_store.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "batch/photographs.h"
#include "files/files.h"
#include "files/output_place.h"
#include "files/unfinished_file.h"
#include "rig/plate_print.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;

constexpr const char* kArriving = ".arriving";
constexpr std::string_view kBatchFolders[] = {"front", "back", "set_aside", "raw", "calib"};

Error cannotMake(const fs::path& path, int reason) {
  if (reason != EEXIST) return cannotWrite(path, reason);
  return {ErrorCode::CannotWrite,
          message("A file with this name already exists and is not overwritten; choose another "
                  "batch name."),
          path.string()};
}

std::string lowerExtension(const std::string& name) {
  return lowerCase(fs::path(name).extension().string());
}

// The extension under which the chain reads it; empty for raw formats. The camera's own name
// decides, since many raw formats are TIFF inside.
std::string photographExtension(const devices::CameraFile& file) {
  const std::string extension = lowerExtension(file.name);
  if (extension == ".jpg" || extension == ".jpeg") return ".jpg";
  if (extension == ".png") return ".png";
  if (extension == ".tif" || extension == ".tiff") return ".tif";
  if (extension.empty() && file.bytes.starts_with("\xFF\xD8")) return ".jpg";
  return {};
}

std::string shotName(int camera, int stop) {
  return formatted("cam%d_pos%02d", camera, stop);
}

fs::path hidden(const fs::path& file) {
  return file.parent_path() / ("." + file.filename().string() + kArriving);
}

// "set_aside/front_cam0_pos00_take1.jpg" for "front/cam0_pos00.jpg".
std::string asideName(const std::string& file, int take) {
  std::string name = file;
  std::replace(name.begin(), name.end(), '/', '_');
  const fs::path path(name);
  return "set_aside/" + path.stem().string() + "_take" + std::to_string(take) +
         path.extension().string();
}

// In the folder of its side, whether it is there or set aside.
std::string nameInSide(const ManifestEntry& entry) {
  return shotName(entry.camera, entry.stop) + fs::path(entry.file).extension().string();
}

Result<void> holdsOnly(const fs::path& folder, const std::set<std::string>& names) {
  for (const fs::path& photograph : batch::photographsIn(folder))
    if (!names.contains(photograph.filename().string()))
      return Error::unusable(message("This photograph does not belong to this batch; choose "
                                     "another folder for the batch."),
                             photograph.string());
  return {};
}

// Of plate.json, where it is there.
Result<void> isThisPlate(const fs::path& file, const batch::Plate& plate) {
  std::error_code absent;
  if (!fs::exists(file, absent)) return {};
  const Result<batch::Plate> there = batch::readPlate(file);
  if (!there) return there.error();
  bool same =
      there->dictionary == plate.dictionary && there->markers.size() == plate.markers.size();
  for (std::size_t i = 0; same && i < plate.markers.size(); ++i)
    same = there->markers[i].id == plate.markers[i].id &&
           (there->markers[i].corners[0] - plate.markers[i].corners[0]).norm() < 1e-3;
  if (same) return {};
  return Error::unusable(
      message(
          "This batch started on another plate; continue with that plate or start a new batch."),
      file.string());
}

Result<void> keepPlate(const fs::path& folder, const batch::Plate& plate) {
  const fs::path file = folder / "plate.json";
  std::error_code absent;
  if (fs::exists(file, absent)) return isThisPlate(file, plate);
  return rig::writePlate(file, plate);
}

// Writes a file that must not be there yet, and syncs it.
Result<void> writeNewFile(const fs::path& path, std::string_view bytes) {
  const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (!file.isOpen()) return cannotMake(path, errno);
  if (writeAll(file.get(), bytes) && ::fsync(file.get()) == 0) return {};
  const int reason = errno;
  ::unlink(path.c_str());
  return cannotWrite(path, reason);
}

// Gives a file another name that must not be taken, in the same file system.
Result<void> renameToNew(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
  if (errno != EINVAL && errno != ENOSYS) return cannotMake(to, errno);
  // The file system knows no such renaming: a second name, then without the first.
  if (::link(from.c_str(), to.c_str()) == 0) {
    ::unlink(from.c_str());
    return {};
  }
  if (errno != EPERM && errno != EOPNOTSUPP) return cannotMake(to, errno);
  // Nor second names (FAT): an empty file takes the place, which nobody else can then.
  if (!FileDescriptor(::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)).isOpen())
    return cannotMake(to, errno);
  if (::rename(from.c_str(), to.c_str()) != 0) return cannotWrite(to, errno);
  return {};
}

}  // namespace

Result<void> checkPlate(const fs::path& batch, const batch::Plate& plate) {
  const Result<Manifest> manifest = readManifest(batch);
  if (!manifest) return manifest.error();
  const bool taken =
      std::ranges::any_of(manifest->entries, [](const ManifestEntry& entry) { return entry.used; });
  return taken ? isThisPlate(batch / "plate.json", plate) : Result<void>();
}

Result<BatchStore> BatchStore::open(const fs::path& batch, batch::Side side, int stops, int cameras,
                                    const batch::Plate& plate) {
  if (const Result<void> own =
          checkNoLinkedFolder(batch, kBatchFolders, LinkedFolders::OfTheseNames);
      !own)
    return own.error();
  Result<FolderLock> held = FolderLock::take(batch);
  if (!held) return held.error();
  BatchStore store(std::move(*held));
  store.batch_ = batch;
  store.side_ = side;
  Result<Manifest> manifest = readManifest(batch);
  if (!manifest) return manifest.error();
  store.manifest_ = std::move(*manifest);
  // Before anything is made in a folder that may be another's.
  std::set<std::string> listed;
  for (const ManifestEntry& entry : store.manifest_.entries)
    if (entry.side == side) listed.insert(nameInSide(entry));
  if (const Result<void> own = holdsOnly(batch / batch::name(side), listed); !own)
    return own.error();
  for (const fs::path& folder : {batch / batch::name(side), batch / "set_aside"})
    if (const Result<void> made = makeFolder(folder); !made) return made.error();
  Manifest& m = store.manifest_;
  if (m.entries.empty()) {
    m.stops = stops;
    m.cameras = cameras;
  }
  if (m.stops != stops || m.cameras != cameras)
    return Error::unusable(message("This batch started with another setup (cameras: %1, positions: "
                                   "%2; now: %3 and %4); choose another folder.",
                                   m.cameras, m.stops, cameras, stops),
                           batch.string());
  if (const Result<void> kept = keepPlate(batch, plate); !kept) return kept.error();
  if (const Result<void> tidied = store.tidyUp(side); !tidied) return tidied.error();
  return store;
}

// Set aside in the manifest, but not in the folder yet, when the program ended.
Result<void> BatchStore::finishAside(const ManifestEntry& entry) const {
  const fs::path file = batch_ / batch::name(entry.side) / nameInSide(entry);
  std::error_code absent;
  if (fs::exists(fileOf(entry), absent) || !fs::exists(file, absent)) return {};
  const Result<std::string> bytes = readFile(file);
  if (!bytes || sha256(*bytes) != entry.sha256) return {};
  return renameToNew(file, fileOf(entry));
}

// The photograph had its name already when the program ended.
Result<void> BatchStore::finishRaw(const ManifestEntry& entry) const {
  for (const std::string& raw : entry.raw) {
    std::error_code absent;
    if (fs::exists(batch_ / raw, absent) || !fs::exists(hidden(batch_ / raw), absent)) continue;
    if (const Result<void> named = renameToNew(hidden(batch_ / raw), batch_ / raw); !named)
      return named;
  }
  return {};
}

Result<void> BatchStore::tidyUp(batch::Side side) {
  for (ManifestEntry& entry : manifest_.entries) {
    if (entry.side != side) continue;
    if (const Result<void> finished = finishRaw(entry); !finished) return finished;
    if (!entry.used) {
      if (const Result<void> finished = finishAside(entry); !finished) return finished;
      continue;
    }
    std::error_code absent;
    if (fs::exists(fileOf(entry), absent)) {
      const Result<std::string> bytes = readFile(fileOf(entry));
      if (bytes && bytes->size() == entry.bytes && sha256(*bytes) == entry.sha256) continue;
      return Error::unusable(
          message("The photograph has changed since it was taken; restore the original or choose "
                  "another folder for the batch."),
          fileOf(entry).string());
    }
    // Between the manifest and the name when the program ended.
    entry.used = false;
    entry.reason = "the file is missing";
  }
  std::set<std::string> ours;
  for (const ManifestEntry& entry : manifest_.entries)
    if (entry.used) ours.insert(fs::path(entry.file).filename().string());
  if (const Result<void> own = holdsOnly(batch_ / batch::name(side), ours); !own) return own;
  std::error_code unread;
  std::vector<fs::path> left_over;
  for (const fs::directory_entry& e : fs::directory_iterator(batch_ / batch::name(side), unread))
    if (e.path().filename().string().ends_with(kArriving)) left_over.push_back(e.path());
  const std::string raw_of_side = std::string(".") + batch::name(side) + "_";
  for (const fs::directory_entry& e : fs::directory_iterator(batch_ / "raw", unread))
    if (const std::string name = e.path().filename().string();
        name.starts_with(raw_of_side) && name.ends_with(kArriving))
      left_over.push_back(e.path());
  for (const fs::path& file : left_over) fs::remove(file, unread);
  return {};
}

Result<Arriving> BatchStore::stage(const std::vector<devices::CameraFile>& files, int camera,
                                   int stop, double angle_deg, const devices::CameraId& id) const {
  const auto photograph = std::ranges::find_if(
      files, [](const devices::CameraFile& f) { return !photographExtension(f).empty(); });
  if (photograph == files.end())
    return Error::unusable(
        message("Camera %1 delivers raw files only; set its image format to JPEG, or to both.",
                batch::cameraLetter(camera)));
  Arriving arriving;
  ManifestEntry& entry = arriving.entry;
  entry.side = side_;
  entry.camera = camera;
  entry.stop = stop;
  entry.take = manifest_.takes(side_, stop, camera) + 1;
  const std::string name = std::string(batch::name(side_)) + "/" + shotName(camera, stop);
  entry.file = name + photographExtension(*photograph);
  entry.sha256 = sha256(photograph->bytes);
  entry.bytes = photograph->bytes.size();
  entry.camera_model = id.model;
  entry.camera_serial = id.serial;
  entry.taken_at = utcNow();
  entry.angle_deg = angle_deg;
  arriving.files.push_back(entry.file);
  const fs::path first = hidden(batch_ / entry.file);
  std::error_code absent;
  fs::remove(first, absent);  // of a try that broke off; never a name of the batch
  if (Result<void> r = writeNewFile(first, photograph->bytes); !r) return r.error();
  for (const devices::CameraFile& file : files) {
    if (&file == &*photograph || !photographExtension(file).empty()) continue;
    const std::string raw = "raw/" + std::string(batch::name(side_)) + "_" +
                            shotName(camera, stop) + "_take" + std::to_string(entry.take) +
                            lowerExtension(file.name);
    if (Result<void> r = makeFolder(batch_ / "raw"); !r) return r.error();
    fs::remove(hidden(batch_ / raw), absent);
    if (Result<void> r = writeNewFile(hidden(batch_ / raw), file.bytes); !r) return r.error();
    entry.raw.push_back(raw);
    arriving.files.push_back(raw);
  }
  return arriving;
}

Result<void> BatchStore::commit(std::vector<Arriving> arriving) {
  if (arriving.empty()) return {};
  const std::size_t before = manifest_.entries.size();
  for (const Arriving& a : arriving) manifest_.entries.push_back(a.entry);
  if (Result<void> r = save(); !r) {
    manifest_.entries.resize(before);  // they have no names, and are not safe
    return r;
  }
  std::set<fs::path> folders;
  for (std::size_t i = 0; i < arriving.size(); ++i)
    for (const std::string& file : arriving[i].files) {
      if (Result<void> r = renameToNew(hidden(batch_ / file), batch_ / file); !r) {
        // What has no name is not in the batch; a raw file gets its name when the batch is opened.
        const bool photograph_named = file != arriving[i].files.front();
        manifest_.entries.resize(before + i + (photograph_named ? 1 : 0));
        (void)save();
        return r;
      }
      folders.insert((batch_ / file).parent_path());
    }
  for (const fs::path& folder : folders) syncFolder(folder);
  return {};
}

Result<void> BatchStore::setAside(const std::vector<ShotName>& shots, const std::string& reason) {
  const std::vector<ManifestEntry> before = manifest_.entries;
  std::vector<std::pair<std::string, std::string>> names;
  for (const auto& [stop, camera] : shots) {
    ManifestEntry* entry = manifest_.find(side_, stop, camera);
    if (entry == nullptr) continue;
    names.emplace_back(entry->file, asideName(entry->file, entry->take));
    entry->file = names.back().second;
    entry->used = false;
    entry->reason = reason;
  }
  if (names.empty()) return {};
  if (Result<void> r = save(); !r) {
    manifest_.entries = before;
    return r;
  }
  for (const auto& [file, aside] : names)
    if (Result<void> r = renameToNew(batch_ / file, batch_ / aside); !r) return r;
  syncFolder(batch_ / "set_aside");
  return {};
}

bool BatchStore::holdsElsewhere(const ManifestEntry& entry) const {
  return std::ranges::any_of(manifest_.entries, [&](const ManifestEntry& e) {
    const bool same_shot = e.side == entry.side && e.stop == entry.stop && e.camera == entry.camera;
    return !same_shot && e.sha256 == entry.sha256;
  });
}

std::vector<Message> BatchStore::otherSettings(
    const ManifestEntry& entry, const std::map<std::string, std::string>& of_rig) const {
  const auto first = std::ranges::find_if(manifest_.entries, [&](const ManifestEntry& e) {
    return e.used && e.camera == entry.camera && !e.settings.empty();
  });
  std::vector<Message> others;
  for (const auto& [name, now] : entry.settings) {
    if (const auto rig = of_rig.find(name); rig != of_rig.end()) {
      if (rig->second != now)
        others.push_back(message("%1 is %2, but the rig specifies %3", name, now, rig->second));
    } else if (first != manifest_.entries.end()) {
      const auto then = first->settings.find(name);
      if (then != first->settings.end() && then->second != now)
        others.push_back(
            message("%1 is %2, but the first photograph used %3", name, now, then->second));
    }
  }
  return others;
}

}  // namespace ostraka::capture
