#include "cameras/gphoto_camera.h"

#include <fcntl.h>
#include <gphoto2/gphoto2.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>

#include "base/message.h"
#include "base/text.h"

namespace ostraka::cameras {
namespace {

constexpr double kBusy_s = 4;       // "I/O in progress" passes; a person who stops waits as long
constexpr double kMoreFiles_s = 2;  // RAW and JPEG come one after the other
constexpr double kPause_s = 0.02;   // a time-out event may come at once
constexpr double kStart_s = 5;      // cameras take seconds to start
constexpr double kDrain_s = 0.2;    // silence for so long: nothing is left
constexpr int kPreviewTries = 3;

// libgphoto2 loads its drivers by libltdl, which is not safe in threads: one lock round loading,
// opening and closing. The only mutable static here, since the library's state is one as well.
std::mutex& gphotoLock() {
  static std::mutex lock;
  return lock;
}

// libgphoto2 2.5.30 closes descriptor 0 when it lets a PTP/IP camera go; while this lives, it is
// put back. Without it the next file that is opened would be 0, and be closed with the next camera.
class KeepDescriptorZero {
 public:
  KeepDescriptorZero() : copy_(::fcntl(0, F_DUPFD_CLOEXEC, 3)) {}
  ~KeepDescriptorZero() {
    if (copy_ < 0) return;
    if (::fcntl(0, F_GETFD) < 0) ::dup2(copy_, 0);
    ::close(copy_);
  }
  KeepDescriptorZero(const KeepDescriptorZero&) = delete;
  KeepDescriptorZero& operator=(const KeepDescriptorZero&) = delete;

 private:
  int copy_;
};

struct GphotoPort {
  std::string model, port;
};

// The cameras at all ports. Under the lock.
std::vector<GphotoPort> detectGphoto(GPContext* context) {
  std::vector<GphotoPort> seen;
  CameraList* list = nullptr;
  if (gp_list_new(&list) < GP_OK) return seen;
  if (gp_camera_autodetect(list, context) >= GP_OK)
    for (int i = 0; i < gp_list_count(list); ++i) {
      const char *model = nullptr, *port = nullptr;
      gp_list_get_name(list, i, &model);
      gp_list_get_value(list, i, &port);
      if (model != nullptr && port != nullptr) seen.push_back({model, port});
    }
  gp_list_free(list);
  return seen;
}

// An error code of the library in words.
Error gphotoTrouble(int code, const std::string& where) {
  switch (code) {
    case GP_ERROR_IO_USB_CLAIM:
    case GP_ERROR_IO_LOCK:
      return Error::missing(
          message("Another program uses the camera, often the desktop's file manager; 'ostraka "
                  "devices' names it."),
          where);
    case GP_ERROR_IO_USB_FIND:
    case GP_ERROR_MODEL_NOT_FOUND:
    case GP_ERROR_UNKNOWN_PORT:
      return Error::missing(message("The camera is not plugged in or not switched on."), where);
    case GP_ERROR_TIMEOUT:
      return Error::missing(
          message(
              "The camera does not answer and may be asleep. Turn off its automatic power-off."),
          where);
    case GP_ERROR_CAMERA_BUSY:
      return Error::missing(message("The camera remains busy; switch it off and on."), where);
    case GP_ERROR_IO:
    case GP_ERROR:
    case GP_ERROR_IO_READ:
    case GP_ERROR_IO_WRITE:
      return Error::missing(message("The connection to the camera failed; check its cable."),
                            where);
    case GP_ERROR_IO_INIT:
      return Error::missing(
          message(
              "The camera cannot be opened; check this user's permissions with 'ostraka devices'."),
          where);
    default:
      return Error::failed(message("The camera reports: %1.", gp_result_as_string(code)), where);
  }
}

struct ContextDeleter {
  void operator()(GPContext* c) const { gp_context_unref(c); }
};
using Context = std::unique_ptr<GPContext, ContextDeleter>;

struct FileDeleter {
  void operator()(::CameraFile* f) const { gp_file_unref(f); }
};
using File = std::unique_ptr<::CameraFile, FileDeleter>;
File newFile() {
  ::CameraFile* made = nullptr;
  gp_file_new(&made);
  return File(made);
}
struct WidgetDeleter {
  void operator()(CameraWidget* w) const { gp_widget_free(w); }
};
using Widget = std::unique_ptr<CameraWidget, WidgetDeleter>;

// Names that cameras give to one setting; the first that exists counts.
const std::map<std::string, std::vector<std::string>>& keysOf() {
  static const std::map<std::string, std::vector<std::string>> keys{
      {"iso", {"iso"}},
      {"aperture", {"aperture", "f-number"}},
      {"exposure", {"shutterspeed2", "shutterspeed"}},
      {"format", {"imageformat", "imagequality"}},
      {"focus", {"focusmode", "focusmode2"}},
      {"white_balance", {"whitebalance"}}};
  return keys;
}

class GphotoCamera final : public devices::Camera {
 public:
  GphotoCamera(std::string serial, std::shared_ptr<devices::Clock> clock)
      : serial_(std::move(serial)), clock_(std::move(clock)), context_(gp_context_new()) {}
  ~GphotoCamera() override { (void)close(); }
  GphotoCamera(const GphotoCamera&) = delete;
  GphotoCamera& operator=(const GphotoCamera&) = delete;

  // By the serial number, wherever it is plugged in.
  Result<void> open() {
    const std::lock_guard lock(gphotoLock());
    if (serial_.starts_with("ptpip:")) return openAt({"PTP/IP Camera", serial_});
    std::optional<Error> trouble;
    std::string others;
    for (const GphotoPort& seen : detectGphoto(context_.get())) {
      const Result<void> opened = openAt(seen);
      if (!opened) {
        trouble = opened.error();
        continue;
      }
      if (const std::string found = text("serialnumber"); found == serial_ || serial_.empty()) {
        serial_ = found;
        return {};
      } else {
        others += (others.empty() ? "" : ", ") + found;
      }
      letGo();
    }
    if (trouble) return *trouble;
    return Error::missing(
        others.empty()
            ? message("The camera is not plugged in or not switched on.")
            : message("The camera with this serial number is not plugged in; found: %1.", others),
        serial_);
  }

  // Opens each by itself to ask for its number; others may hold it.
  std::vector<FoundCamera> all() {
    const std::lock_guard lock(gphotoLock());
    std::vector<FoundCamera> found;
    for (const GphotoPort& seen : detectGphoto(context_.get())) {
      const Result<void> opened = openAt(seen);
      FoundCamera& entry = found.emplace_back();
      entry.id = {"gphoto2", seen.model, text("serialnumber"), seen.port};
      if (!opened) entry.trouble = opened.error().what;
      letGo();
    }
    return found;
  }

  devices::CameraId id() const override { return {"gphoto2", model_, serial_, port_}; }

  Result<std::vector<devices::CameraSetting>> settings() override {
    std::vector<devices::CameraSetting> all;
    for (const auto& [name, keys] : keysOf()) {
      const Result<devices::CameraSetting> setting = read(name);
      if (setting)
        all.push_back(*setting);
      else if (setting.error().code == ErrorCode::Missing)
        return setting.error();
    }
    return all;
  }

  Result<devices::CameraSetting> set(const std::string& name, const std::string& value) override {
    const Result<devices::CameraSetting> before = read(name);
    if (!before) return before;
    if (before->value == value) return before;
    const auto& choices = before->choices;
    if (before->read_only ||
        (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end()))
      return Error::unusable(message("The camera does not offer %1 for %2; it is set to %3.", value,
                                     name, before->value),
                             serial_);
    const std::string key = keyOf(name);
    if (Result<void> r = write(key, value); !r) return r.error();
    changed_.insert({key, before->value});  // the first value is what is restored
    const Result<devices::CameraSetting> after = read(name);
    if (after && after->value != value)
      return Error::unusable(
          message("The camera keeps %1 at %2 instead of %3; check its mode dial.", name,
                  after->value, value),
          serial_);
    return after;
  }

  Result<std::string> preview(std::stop_token stop) override {
    if (camera_ == nullptr) return notOpen();
    int code = GP_OK;
    for (int k = 0; k < kPreviewTries && !stop.stop_requested(); ++k) {
      const File file = newFile();
      code = gp_camera_capture_preview(camera_, file.get(), context_.get());
      if (code >= GP_OK) return bytesOf(file.get());
      if (code != GP_ERROR_CAMERA_BUSY) break;
      if (!clock_->sleep(0.1, stop)) break;
    }
    if (stop.stop_requested()) return Error::cancelled();
    if (code == GP_ERROR_NOT_SUPPORTED)
      return Error::missing(message("This camera has no live view."), serial_);
    return gphotoTrouble(code, serial_);
  }

  Result<void> getReady(std::stop_token stop) override {
    if (camera_ == nullptr) return notOpen();
    const double deadline_s = clock_->now_s() + kBusy_s;
    for (double quiet_s = clock_->now_s(); clock_->now_s() - quiet_s < kDrain_s;) {
      if (stop.stop_requested()) return Error::cancelled();
      const Result<Event> event = next();
      if (!event) return event.error();
      if (event->file) {
        (void)download(*event->file);  // some cameras block until it is fetched
        quiet_s = clock_->now_s();
      }
      if (clock_->now_s() > deadline_s)
        return Error::missing(message("The camera does not stop sending photographs."), serial_);
    }
    return {};
  }

  Result<void> trigger() override {
    if (camera_ == nullptr) return notOpen();
    return onceFree([this] {
      const int code = gp_camera_trigger_capture(camera_, context_.get());
      if (code == GP_ERROR_CAMERA_BUSY) (void)next();
      return code;
    });
  }

  Result<std::vector<devices::CameraFile>> fetch(double timeout_s, std::stop_token stop) override {
    if (camera_ == nullptr) return notOpen();
    std::vector<devices::CameraFile> files;
    double deadline_s = clock_->now_s() + timeout_s;
    while (clock_->now_s() < deadline_s) {
      if (stop.stop_requested()) return Error::cancelled();
      const Result<Event> event = next();
      if (!event) return event.error();
      if (!event->file) continue;
      Result<devices::CameraFile> file = download(*event->file);
      if (!file) return file.error();
      files.push_back(std::move(*file));
      if (!two_files_ || files.size() == 2) return files;
      deadline_s = clock_->now_s() + kMoreFiles_s;
    }
    if (files.empty())
      return Error::missing(
          message("The camera sent no photograph; check that it is focused and set to manual."),
          serial_);
    return files;
  }

  Result<void> reopen(std::stop_token stop) override {
    {
      const std::lock_guard lock(gphotoLock());
      letGo();
    }
    return devices::openWithin(kStart_s, 0.5, *clock_, stop, [this] { return open(); });
  }

  Result<void> close() override {
    if (camera_ == nullptr) return {};
    Result<void> restored;
    for (const auto& [key, value] : changed_)
      if (Result<void> r = write(key, value); !r) restored = r;
    changed_.clear();
    const std::lock_guard lock(gphotoLock());
    letGo();
    return restored;
  }

 private:
  struct OnCamera {
    std::string folder, name;
  };
  struct Event {
    std::optional<OnCamera> file;
  };

  Error notOpen() const {
    return Error::missing(message("The camera is not plugged in or not switched on."), serial_);
  }

  // Calls again while the camera is busy.
  template <typename Call>
  Result<void> onceFree(Call&& call) {
    const double deadline_s = clock_->now_s() + kBusy_s;
    while (true) {
      const int code = call();
      if (code >= GP_OK) return {};
      if (code != GP_ERROR_CAMERA_BUSY || clock_->now_s() > deadline_s)
        return gphotoTrouble(code, serial_);
      clock_->sleep(0.1, {});
    }
  }

  // Under the library's lock.
  void letGo() {
    if (camera_ == nullptr) return;
    const KeepDescriptorZero keep;
    gp_camera_exit(camera_, context_.get());
    gp_camera_unref(camera_);
    camera_ = nullptr;
  }

  // Under the library's lock.
  Result<void> openAt(const GphotoPort& seen) {
    std::signal(SIGPIPE, SIG_IGN);  // a camera that leaves the network would end the program
    CameraAbilitiesList* abilities = nullptr;
    GPPortInfoList* ports = nullptr;
    gp_abilities_list_new(&abilities);
    gp_port_info_list_new(&ports);
    gp_abilities_list_load(abilities, context_.get());
    gp_port_info_list_load(ports);
    int code = gp_camera_new(&camera_);
    const int model = gp_abilities_list_lookup_model(abilities, seen.model.c_str());
    CameraAbilities about{};
    if (code >= GP_OK) code = model;
    if (code >= GP_OK) code = gp_abilities_list_get_abilities(abilities, model, &about);
    if (code >= GP_OK) code = gp_camera_set_abilities(camera_, about);
    if (code >= GP_OK) {
      const int port = gp_port_info_list_lookup_path(ports, seen.port.c_str());
      GPPortInfo info = nullptr;
      code = port;
      if (code >= GP_OK) code = gp_port_info_list_get_info(ports, port, &info);
      if (code >= GP_OK) code = gp_camera_set_port_info(camera_, info);
      if (code >= GP_OK) code = gp_camera_init(camera_, context_.get());
    }
    gp_abilities_list_free(abilities);
    gp_port_info_list_free(ports);
    if (code < GP_OK) {
      const KeepDescriptorZero keep;
      if (camera_ != nullptr) gp_camera_unref(camera_);
      camera_ = nullptr;
      return gphotoTrouble(code, seen.model + " at " + seen.port);
    }
    model_ = seen.model;
    port_ = seen.port;
    const std::string format = lowerCase(text("imageformat") + text("imagequality"));
    two_files_ = format.find("raw") != std::string::npos &&
                 (format.find('+') != std::string::npos || format.find("jp") != std::string::npos);
    return {};
  }

  Widget widget(const std::string& key) const {
    CameraWidget* found = nullptr;
    if (camera_ == nullptr ||
        gp_camera_get_single_config(camera_, key.c_str(), &found, context_.get()) < GP_OK)
      return nullptr;
    return Widget(found);
  }

  static std::string valueOf(CameraWidget* widget) {
    CameraWidgetType type{};
    gp_widget_get_type(widget, &type);
    if (type != GP_WIDGET_RADIO && type != GP_WIDGET_MENU && type != GP_WIDGET_TEXT) return {};
    const char* value = nullptr;
    gp_widget_get_value(widget, &value);
    return value == nullptr ? "" : value;
  }
  std::string text(const std::string& key) const {
    const Widget found = widget(key);
    return found ? valueOf(found.get()) : std::string();
  }

  std::string keyOf(const std::string& name) const {
    const auto known = keysOf().find(name);
    if (known == keysOf().end()) return name;
    for (const std::string& key : known->second)
      if (widget(key)) return key;
    return {};
  }

  Result<devices::CameraSetting> read(const std::string& name) const {
    if (camera_ == nullptr) return notOpen();
    const std::string key = keyOf(name);
    const Widget found = key.empty() ? nullptr : widget(key);
    if (!found) return Error::unusable(message("The camera has no setting %1.", name), serial_);
    devices::CameraSetting setting{name, valueOf(found.get()), {}, false};
    int read_only = 0;
    gp_widget_get_readonly(found.get(), &read_only);
    setting.read_only = read_only != 0;
    CameraWidgetType type{};
    gp_widget_get_type(found.get(), &type);
    if (type == GP_WIDGET_RADIO || type == GP_WIDGET_MENU)
      for (int i = 0; i < gp_widget_count_choices(found.get()); ++i) {
        const char* choice = nullptr;
        if (gp_widget_get_choice(found.get(), i, &choice) >= GP_OK && choice != nullptr)
          setting.choices.emplace_back(choice);
      }
    return setting;
  }

  Result<void> write(const std::string& key, const std::string& value) {
    const Widget found = widget(key);
    if (!found) return Error::unusable(message("The camera has no setting %1.", key), serial_);
    gp_widget_set_value(found.get(), value.c_str());
    return onceFree([&] {
      return gp_camera_set_single_config(camera_, key.c_str(), found.get(), context_.get());
    });
  }

  // Waits shortly; many events say nothing about files.
  Result<Event> next() {
    CameraEventType type = GP_EVENT_UNKNOWN;
    void* details = nullptr;
    const int code = gp_camera_wait_for_event(camera_, 50, &type, &details, context_.get());
    Event event;
    if (code >= GP_OK && type == GP_EVENT_FILE_ADDED && details != nullptr) {
      const auto* path = static_cast<const CameraFilePath*>(details);
      event.file = OnCamera{path->folder, path->name};
    }
    std::free(details);
    if (code == GP_ERROR_CAMERA_BUSY || code == GP_ERROR_TIMEOUT || type == GP_EVENT_TIMEOUT)
      clock_->sleep(kPause_s, {});
    if (code < GP_OK && code != GP_ERROR_CAMERA_BUSY && code != GP_ERROR_TIMEOUT)
      return gphotoTrouble(code, serial_);
    return event;
  }

  static std::string bytesOf(::CameraFile* file) {
    const char* data = nullptr;
    unsigned long size = 0;
    if (gp_file_get_data_and_size(file, &data, &size) < GP_OK || data == nullptr) return {};
    return {data, size};
  }

  Result<devices::CameraFile> download(const OnCamera& place) {
    File file;
    const Result<void> got = onceFree([&] {
      file = newFile();
      return gp_camera_file_get(camera_, place.folder.c_str(), place.name.c_str(),
                                GP_FILE_TYPE_NORMAL, file.get(), context_.get());
    });
    if (!got) return got.error();
    return devices::CameraFile{place.name, bytesOf(file.get())};
  }

  std::string serial_;
  std::shared_ptr<devices::Clock> clock_;
  Context context_;
  ::Camera* camera_ = nullptr;
  std::string model_, port_;
  bool two_files_ = false;
  std::map<std::string, std::string> changed_;  // widget and its value before
};

}  // namespace

std::vector<FoundCamera> listGphotoCameras() {
  return GphotoCamera({}, devices::steadyClock()).all();
}

Result<std::unique_ptr<devices::Camera>> openGphotoCamera(const std::string& serial,
                                                          std::shared_ptr<devices::Clock> clock) {
  auto camera = std::make_unique<GphotoCamera>(serial, std::move(clock));
  if (const Result<void> opened = camera->open(); !opened) return opened.error();
  return std::unique_ptr<devices::Camera>(std::move(camera));
}

}  // namespace ostraka::cameras
