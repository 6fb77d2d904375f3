#pragma once
#include <memory>

#include "base/result.h"
#include "cameras/uvc_camera.h"

/// The one function of video_camera.so. OpenCV's video input brings a hundred libraries, which
/// would take a quarter of a second of every start of the program: they are loaded with this
/// module, when the first video camera is opened.
extern "C" __attribute__((visibility("default"))) void ostrakaOpenVideoCamera(
    const ostraka::cameras::UvcOptions& options, std::shared_ptr<ostraka::devices::Clock> clock,
    ostraka::Result<std::unique_ptr<ostraka::devices::Camera>>& opened);
