#include "cameras/folder_camera.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "batch/photograph.h"
#include "files/files.h"
#include "images/image_header.h"

namespace ostraka::cameras {
namespace {

namespace fs = std::filesystem;

// What other programs write while they copy.
bool isPartial(const fs::path& file) {
  const std::string name = lowerCase(file.filename().string()),
                    extension = lowerCase(file.extension().string());
  return name.starts_with(".") || name.ends_with("~") || extension == ".part" ||
         extension == ".partial" || extension == ".tmp" || extension == ".crdownload" ||
         extension == ".xmp";
}

struct FileState {
  std::uintmax_t size = 0;
  fs::file_time_type changed{};
  bool operator==(const FileState&) const = default;
};

class FolderCamera final : public devices::Camera {
 public:
  FolderCamera(FolderCameraOptions options, std::shared_ptr<devices::Clock> clock)
      : options_(std::move(options)), clock_(std::move(clock)) {}

  devices::CameraId id() const override {
    return {"folder", "Watched folder", options_.folder.string(), options_.folder.string()};
  }
  Result<std::vector<devices::CameraSetting>> settings() override {
    return std::vector<devices::CameraSetting>{};
  }
  Result<devices::CameraSetting> set(const std::string& name, const std::string&) override {
    return Error::unusable(
        message("A watched folder has no setting %1; set it on the camera.", name), where());
  }
  Result<std::string> preview(std::stop_token) override {
    return Error::missing(message("A watched folder has no live view."), where());
  }
  bool triggersItself() const override { return false; }
  Result<void> trigger() override { return {}; }

  Result<void> getReady(std::stop_token) override {
    const Result<std::map<fs::path, FileState>> now = list();
    if (!now) return now.error();
    known_.clear();
    for (const auto& [file, state] : *now) known_.insert(file);
    return {};
  }

  Result<std::vector<devices::CameraFile>> fetch(double timeout_s, std::stop_token stop) override {
    const double deadline_s = clock_->now_s() + timeout_s;
    std::map<fs::path, FileState> before;
    double changed_s = clock_->now_s();
    while (true) {
      const Result<std::map<fs::path, FileState>> now = list();
      if (!now) return now.error();
      std::map<fs::path, FileState> fresh;
      for (const auto& [file, state] : *now)
        if (!known_.contains(file)) fresh.insert({file, state});
      if (fresh != before) {
        before = fresh;
        changed_s = clock_->now_s();
      }
      if (clock_->now_s() - changed_s >= options_.steady_s && hasPhotograph(fresh)) {
        Result<std::vector<devices::CameraFile>> files = take(fresh);
        if (files || files.error().code == ErrorCode::UnusableInput) return files;
      }
      if (clock_->now_s() >= deadline_s)
        return Error::missing(
            message("No new photograph arrived within %1 seconds; check that the camera's "
                    "software writes into this folder.",
                    static_cast<int>(timeout_s)),
            where());
      if (!clock_->sleep(options_.poll_s, stop)) return Error::cancelled();
    }
  }

  Result<void> reopen(std::stop_token) override {
    const Result<std::map<fs::path, FileState>> now = list();
    return now ? Result<void>() : Result<void>(now.error());
  }
  Result<void> close() override { return {}; }

 private:
  std::string where() const { return options_.folder.string(); }

  Result<std::map<fs::path, FileState>> list() const {
    std::map<fs::path, FileState> files;
    std::error_code failed;
    fs::directory_iterator it(options_.folder, failed);
    for (; !failed && it != fs::directory_iterator(); it.increment(failed)) {
      std::error_code gone;  // a file may vanish while we look
      if (!it->is_regular_file(gone) || isPartial(it->path())) continue;
      const FileState state{it->file_size(gone), it->last_write_time(gone)};
      if (!gone) files[it->path()] = state;
    }
    if (failed)
      return Error::missing(message("The watched folder cannot be read (%1).", failed.message()),
                            where());
    return files;
  }

  static bool hasPhotograph(const std::map<fs::path, FileState>& files) {
    return std::any_of(files.begin(), files.end(),
                       [](const auto& file) { return batch::hasPhotographEnding(file.first); });
  }

  // Missing: not whole yet, wait on.
  Result<std::vector<devices::CameraFile>> take(const std::map<fs::path, FileState>& fresh) {
    std::vector<devices::CameraFile> files;
    std::string photograph;
    for (const auto& [file, state] : fresh) {
      if (!batch::hasPhotographEnding(file)) continue;
      if (!photograph.empty())
        return Error::unusable(message("Two photographs arrived for one shot, %1 and %2; use one "
                                       "folder per camera and one photograph per position.",
                                       photograph, file.filename().string()),
                               where());
      photograph = file.filename().string();
    }
    for (const auto& [file, state] : fresh) {
      Result<std::string> bytes = readFile(file);
      if (!bytes) return Error::missing(bytes.error().what, bytes.error().where);
      if (batch::hasPhotographEnding(file))
        if (const auto size = images::imageSize(*bytes, file.string()); !size)
          return Error::missing(size.error().what, file.string());
      const bool belongs =
          batch::hasPhotographEnding(file) || file.stem() == fs::path(photograph).stem();
      if (belongs) files.push_back({file.filename().string(), std::move(*bytes)});
      known_.insert(file);
    }
    std::stable_partition(files.begin(), files.end(), [](const devices::CameraFile& f) {
      return batch::hasPhotographEnding(f.name);
    });
    return files;
  }

  FolderCameraOptions options_;
  std::shared_ptr<devices::Clock> clock_;
  std::set<fs::path> known_;
};

}  // namespace

Result<std::unique_ptr<devices::Camera>> openFolderCamera(const FolderCameraOptions& options,
                                                          std::shared_ptr<devices::Clock> clock) {
  std::unique_ptr<devices::Camera> camera =
      std::make_unique<FolderCamera>(options, std::move(clock));
  if (const Result<void> ready = camera->getReady({}); !ready) return ready.error();
  return camera;
}

}  // namespace ostraka::cameras
