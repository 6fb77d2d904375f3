#include "cameras/gphoto_library.h"

#include <fcntl.h>
#include <gphoto2/gphoto2.h>
#include <unistd.h>

#include <memory>

#include "base/message.h"
#include "cameras/gphoto_camera.h"

namespace ostraka::cameras {

// libgphoto2 loads its drivers by libltdl, which is not safe in threads: one lock round loading,
// opening and closing. The only mutable static here, since the library's state is one as well.
std::mutex& gphotoLock() {
  static std::mutex lock;
  return lock;
}

KeepDescriptorZero::KeepDescriptorZero() : copy_(::fcntl(0, F_DUPFD_CLOEXEC, 3)) {}

KeepDescriptorZero::~KeepDescriptorZero() {
  if (copy_ < 0) return;
  if (::fcntl(0, F_GETFD) < 0) ::dup2(copy_, 0);
  ::close(copy_);
}

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

Error gphotoTrouble(int code, const std::string& where) {
  switch (code) {
    case GP_ERROR_IO_USB_CLAIM:
    case GP_ERROR_IO_LOCK:
      return {ErrorCode::Missing,
              message("Another program uses the camera, often the desktop's file manager; 'ostraka "
                      "devices' names it."),
              where};
    case GP_ERROR_IO_USB_FIND:
    case GP_ERROR_MODEL_NOT_FOUND:
    case GP_ERROR_UNKNOWN_PORT:
      return {ErrorCode::Missing, message("The camera is not plugged in or not switched on."),
              where};
    case GP_ERROR_TIMEOUT:
      return {
          ErrorCode::Missing,
          message(
              "The camera does not answer and may be asleep. Turn off its automatic power-off."),
          where};
    case GP_ERROR_CAMERA_BUSY:
      return {ErrorCode::Missing, message("The camera remains busy; switch it off and on."), where};
    case GP_ERROR_IO:
    case GP_ERROR:
    case GP_ERROR_IO_READ:
    case GP_ERROR_IO_WRITE:
      return {ErrorCode::Missing, message("The connection to the camera failed; check its cable."),
              where};
    case GP_ERROR_IO_INIT:
      return {
          ErrorCode::Missing,
          message(
              "The camera cannot be opened; check this user's permissions with 'ostraka devices'."),
          where};
    default:
      return {ErrorCode::Failed, message("The camera reports: %1.", gp_result_as_string(code)),
              where};
  }
}

Result<std::vector<FoundCamera>> listGphotoCameras() {
  std::vector<GphotoPort> seen;
  {
    const std::lock_guard lock(gphotoLock());
    const std::unique_ptr<GPContext, decltype(&gp_context_unref)> context(gp_context_new(),
                                                                          gp_context_unref);
    seen = detectGphoto(context.get());
  }
  std::vector<FoundCamera> found;
  for (const GphotoPort& camera : seen) {
    FoundCamera entry{{"gphoto2", camera.model, {}, camera.port}, {}};
    // Opened by itself to ask for its number; others may hold it.
    const std::lock_guard lock(gphotoLock());
    const std::unique_ptr<GPContext, decltype(&gp_context_unref)> context(gp_context_new(),
                                                                          gp_context_unref);
    ::Camera* device = nullptr;
    GPPortInfoList* ports = nullptr;
    gp_port_info_list_new(&ports);
    gp_port_info_list_load(ports);
    GPPortInfo info = nullptr;
    int code = gp_port_info_list_lookup_path(ports, camera.port.c_str());
    if (code >= GP_OK) code = gp_port_info_list_get_info(ports, code, &info);
    if (code >= GP_OK) code = gp_camera_new(&device);
    if (code >= GP_OK) code = gp_camera_set_port_info(device, info);
    if (code >= GP_OK) code = gp_camera_init(device, context.get());
    CameraWidget* widget = nullptr;
    if (code >= GP_OK &&
        gp_camera_get_single_config(device, "serialnumber", &widget, context.get()) >= GP_OK) {
      const char* value = nullptr;
      gp_widget_get_value(widget, &value);
      entry.id.serial = value == nullptr ? "" : value;
      gp_widget_free(widget);
    }
    if (code < GP_OK) entry.trouble = gphotoTrouble(code, {}).what;
    if (device != nullptr) {
      gp_camera_exit(device, context.get());
      gp_camera_unref(device);
    }
    gp_port_info_list_free(ports);
    found.push_back(std::move(entry));
  }
  return found;
}

}  // namespace ostraka::cameras
