// Loaded by uvc_camera.cpp when a video camera is opened.
#include "cameras/video_camera.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <optional>

#include "base/message.h"
#include "base/text.h"
#include "images/jpeg_image.h"

namespace ostraka::cameras {
namespace {

constexpr double kFresh_s = 0.008;  // a frame that had to be waited for was not lying about
constexpr int kPreviewWidth = 960;

// A setting, and the automatic that must be off for it to stay.
struct Property {
  int value = 0;
  int automatic = -1;  // -1: has none
  double off = 0;
};
const std::map<std::string, Property>& properties() {
  static const std::map<std::string, Property> all{
      {"exposure", {cv::CAP_PROP_EXPOSURE, cv::CAP_PROP_AUTO_EXPOSURE, 1}},
      {"focus", {cv::CAP_PROP_FOCUS, cv::CAP_PROP_AUTOFOCUS, 0}},
      {"white_balance", {cv::CAP_PROP_WB_TEMPERATURE, cv::CAP_PROP_AUTO_WB, 0}},
      {"gain", {cv::CAP_PROP_GAIN, -1, 0}}};
  return all;
}

std::string written(double value) {
  return formatted("%g", value);
}

class UvcCamera final : public devices::Camera {
 public:
  UvcCamera(UvcOptions options, std::shared_ptr<devices::Clock> clock)
      : options_(std::move(options)), clock_(std::move(clock)) {}

  Result<void> open() {
    const bool device = options_.source.starts_with("/dev/");
    try {
      if (!(device ? video_.open(options_.source, cv::CAP_V4L2) : video_.open(options_.source)))
        return notOpen();
      if (device) {
        video_.set(cv::CAP_PROP_BUFFERSIZE, 1);
        if (options_.width > 0) {
          // The compressed form first: uncompressed pictures of full size do not fit the cable.
          video_.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
          video_.set(cv::CAP_PROP_FRAME_WIDTH, options_.width);
          video_.set(cv::CAP_PROP_FRAME_HEIGHT, options_.height);
        }
      }
    } catch (const cv::Exception&) {
      return notOpen();
    }
    return {};
  }

  devices::CameraId id() const override {
    return {"uvc", "Video camera", options_.source, options_.source};
  }

  Result<std::vector<devices::CameraSetting>> settings() override {
    std::vector<devices::CameraSetting> all;
    for (const auto& [name, property] : properties())
      all.push_back({name, written(video_.get(property.value)), {}, false});
    return all;
  }

  Result<devices::CameraSetting> set(const std::string& name, const std::string& value) override {
    const auto found = properties().find(name);
    char* end = nullptr;
    const double wanted = std::strtod(value.c_str(), &end);
    if (found == properties().end() || value.empty() || *end != '\0')
      return Error::unusable(message("A video camera has exposure (0.1 ms), focus, white_balance "
                                     "(K) and gain, as numbers; not %1 %2.",
                                     name, value),
                             options_.source);
    const Property& property = found->second;
    remember(property.value);
    if (property.automatic >= 0) {
      remember(property.automatic);
      video_.set(property.automatic, property.off);
    }
    video_.set(property.value, wanted);
    const double kept = video_.get(property.value);
    if (std::abs(kept - wanted) > 0.01 * std::abs(wanted) + 0.5)
      return Error::unusable(
          message("The camera keeps %1 at %2 instead of %3.", name, written(kept), value),
          options_.source);
    return devices::CameraSetting{name, written(kept), {}, false};
  }

  Result<std::string> preview(std::stop_token) override {
    const Result<cv::Mat> frame = read();
    if (!frame) return frame.error();
    cv::Mat small = *frame;
    if (small.cols > kPreviewWidth)
      cv::resize(*frame, small, {kPreviewWidth, small.rows * kPreviewWidth / small.cols}, 0, 0,
                 cv::INTER_AREA);
    return images::encodedJpeg(small, {.quality = 85});
  }

  Result<void> getReady(std::stop_token) override {
    frame_.reset();
    return video_.isOpened() ? Result<void>() : Result<void>(notOpen());
  }

  Result<void> trigger() override {
    frame_.reset();
    for (int k = 0; k < options_.most_stale; ++k) {
      const double before_s = clock_->now_s();
      if (!video_.grab()) return gone(message("The video camera no longer delivers pictures."));
      if (clock_->now_s() - before_s > kFresh_s) break;
    }
    const Result<cv::Mat> frame = read();
    if (!frame) return frame.error();
    frame_ = *frame;
    return {};
  }

  Result<std::vector<devices::CameraFile>> fetch(double, std::stop_token) override {
    if (!frame_) return gone(message("The video camera took no picture."));
    const cv::Mat frame = *frame_;
    frame_.reset();
    if (options_.width > 0 && frame.cols != options_.width)
      return Error::unusable(
          message(
              "The video camera delivers pictures of %1x%2 pixels instead of the configured size.",
              frame.cols, frame.rows),
          options_.source);
    return std::vector<devices::CameraFile>{{"frame.jpg", images::encodedJpeg(frame)}};
  }

  Result<void> reopen(std::stop_token stop) override {
    video_.release();
    return devices::openWithin(2, 0.2, *clock_, stop, [this] { return open(); });
  }

  Result<void> close() override {
    for (const auto& [property, value] : before_)
      if (video_.isOpened()) video_.set(property, value);
    before_.clear();
    video_.release();
    return {};
  }
  ~UvcCamera() override { (void)close(); }
  UvcCamera(const UvcCamera&) = delete;
  UvcCamera& operator=(const UvcCamera&) = delete;

 private:
  Error gone(const Message& what) const { return Error::missing(what, options_.source); }
  Error notOpen() const {
    return gone(
        message("The video camera cannot be opened; check that it is plugged in and that no other "
                "program uses it."));
  }
  void remember(int property) { before_.insert({property, video_.get(property)}); }

  Result<cv::Mat> read() {
    cv::Mat frame;
    try {
      if (!video_.read(frame) || frame.empty())
        return gone(message("The video camera no longer delivers pictures."));
    } catch (const cv::Exception&) {
      return gone(message("The video camera no longer delivers pictures."));
    }
    return frame.clone();
  }

  UvcOptions options_;
  std::shared_ptr<devices::Clock> clock_;
  cv::VideoCapture video_;
  std::optional<cv::Mat> frame_;
  std::map<int, double> before_;  // what is restored
};

}  // namespace
}  // namespace ostraka::cameras

void ostrakaOpenVideoCamera(const ostraka::cameras::UvcOptions& options,
                            std::shared_ptr<ostraka::devices::Clock> clock,
                            ostraka::Result<std::unique_ptr<ostraka::devices::Camera>>& opened) {
  auto camera = std::make_unique<ostraka::cameras::UvcCamera>(options, std::move(clock));
  if (const ostraka::Result<void> open = camera->open(); !open)
    opened = open.error();
  else
    opened = std::unique_ptr<ostraka::devices::Camera>(std::move(camera));
}
