#include "review/saved_views.h"

#include <opencv2/core.hpp>

#include "batch/photograph.h"
#include "decisions/mask_strokes.h"
#include "rig/camera.h"

namespace ostraka::review {

Result<std::vector<stereo::View>> savedViews(const std::filesystem::path& out,
                                             const std::filesystem::path& batch, batch::Side side,
                                             const std::stop_token& stop) {
  const Result<std::vector<rig::PosedImage>> images =
      rig::readCameras(out / "work" / "rig" / "cameras.json");
  if (!images) return images.error();
  const std::string masks = decisions::maskFolder(out, side);
  std::vector<stereo::View> views;
  for (const rig::PosedImage& image : *images) {
    if (image.side != side) continue;
    if (stop.stop_requested()) return Error::cancelled();
    Result<cv::Mat> mask = batch::readMask(out / "work" / masks / maskName(image));
    if (!mask) return mask.error();
    if (cv::countNonZero(*mask) == 0) continue;
    // The project may have moved since: only the last two names count.
    const std::filesystem::path then = image.file;
    const std::filesystem::path now = batch / then.parent_path().filename() / then.filename();
    Result<cv::Mat> photograph = batch::readPhotograph(now);
    if (!photograph) return photograph.error();
    stereo::View view{image, std::move(*photograph), cv::Mat1b(std::move(*mask))};
    view.camera.file = now.string();
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace ostraka::review
