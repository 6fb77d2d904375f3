#include "cameras/uvc_camera.h"

#include <dlfcn.h>

#include "base/message.h"
#include "base/program_parts.h"
#include "cameras/video_camera.h"

namespace ostraka::cameras {
namespace {

constexpr const char* kModule = "video_camera.so";

// Stays loaded until the program ends.
decltype(&ostrakaOpenVideoCamera) loaded() {
  static void* const module = [] {
    void* beside = ::dlopen(programPart(kModule).c_str(), RTLD_NOW | RTLD_LOCAL);
    return beside ? beside : ::dlopen(kModule, RTLD_NOW | RTLD_LOCAL);  // in a build folder
  }();
  return module ? reinterpret_cast<decltype(&ostrakaOpenVideoCamera)>(
                      ::dlsym(module, "ostrakaOpenVideoCamera"))
                : nullptr;
}

}  // namespace

Result<std::unique_ptr<devices::Camera>> openUvcCamera(const UvcOptions& options,
                                                       std::shared_ptr<devices::Clock> clock) {
  if (options.source.empty()) return Error::unusable(message("The video camera must be named."));
  const auto open = loaded();
  if (!open)
    return Error::missing(message("The part of Ostraka that video cameras need cannot be loaded; "
                                  "install Ostraka again."),
                          kModule);
  Result<std::unique_ptr<devices::Camera>> camera = std::unique_ptr<devices::Camera>();
  open(options, std::move(clock), camera);
  return camera;
}

}  // namespace ostraka::cameras
