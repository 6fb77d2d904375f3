// mask_accuracy BATCH [--no-empty] [--threads N] [--side S] [--dump FOLDER] [--cameras
// CAMERAS.json]: masks of a batch with its true cameras, or those of a file, against the true
// masks: IoU and distance of the outline, per photograph, per camera and in the mean. Over a
// printed sheet, taken to be flat, with a coarse reconstruction as `process` has it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "batch/batch.h"
#include "mask/plate_mask.h"
#include "pipeline/view_masks.h"
#include "rig/camera.h"

using namespace ostraka;

namespace {

struct Accuracy {
  double iou = 0, bias_px = 0, mean_px = 0, worst_px = 0;
};

// Points of the soft mask's outline at level 127.5, to a fraction of a pixel, and their signed
// distance to the true outline (positive: the mask is too wide).
Accuracy compare(const cv::Mat1b& mask, const cv::Mat1b& truth) {
  Accuracy accuracy;
  const double both = cv::countNonZero((mask >= 128) & truth);
  accuracy.iou = both / std::max(1, cv::countNonZero((mask >= 128) | truth));
  cv::Mat1f inside, outside;
  cv::distanceTransform(truth, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::distanceTransform(~truth, outside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const cv::Mat1f signed_distance = outside - inside;  // crosses 0 between -1 and 1
  double n = 0;
  const auto at = [&](int y, int x) {
    const float d = signed_distance(y, x);
    return d > 0 ? d - 0.5 : d + 0.5;
  };
  for (int y = 0; y + 1 < mask.rows; ++y)
    for (int x = 0; x + 1 < mask.cols; ++x)
      for (int k = 0; k < 2; ++k) {
        const int xn = x + (k == 0), yn = y + (k == 1);
        const double a = mask(y, x), b = mask(yn, xn);
        if ((a >= 127.5) == (b >= 127.5)) continue;
        const double t = (127.5 - a) / (b - a);
        const double d = (1 - t) * at(y, x) + t * at(yn, xn);
        accuracy.bias_px += d;
        accuracy.mean_px += std::abs(d);
        accuracy.worst_px = std::max(accuracy.worst_px, std::abs(d));
        n += 1;
      }
  accuracy.bias_px /= std::max(1.0, n);
  accuracy.mean_px /= std::max(1.0, n);
  return accuracy;
}

// Sums of the photographs' figures, and their means in words.
struct Sum {
  double iou = 0, bias_px = 0, mean_px = 0;
  int count = 0;
  void add(const Accuracy& a) { iou += a.iou, bias_px += a.bias_px, mean_px += a.mean_px, ++count; }
  void print(const std::string& of) const {
    std::printf("%s of %d: IoU %.4f  edge bias %+.3f  mean %.3f px\n", of.c_str(), count,
                iou / count, bias_px / count, mean_px / count);
  }
};

// Of batches of a rig, or of photographs by hand.
std::string truthMaskName(const rig::PosedImage& image) {
  const std::filesystem::path file = image.file;
  if (!file.filename().string().starts_with("cam"))
    return std::string(batch::name(image.side)) + "_" + file.stem().string() + ".png";
  char text[64];
  std::snprintf(text, sizeof text, "%s_cam%d_pos%02d.png", batch::name(image.side), image.camera,
                image.stop);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2)
    return std::fprintf(
               stderr,
               "mask_accuracy BATCH [--no-empty] [--threads N] [--side S] [--dump FOLDER]\n"),
           2;
  const std::filesystem::path folder = argv[1];
  mask::PlateMaskOptions options;
  std::string dump, only;
  std::filesystem::path cameras = folder / "truth" / "cameras.json";
  bool with_empty = true;
  for (int i = 2; i < argc; ++i) {
    if (std::strcmp(argv[i], "--no-empty") == 0) with_empty = false;
    if (std::strcmp(argv[i], "--threads") == 0) options.threads = std::atoi(argv[i + 1]);
    if (std::strcmp(argv[i], "--side") == 0) only = argv[i + 1];
    if (std::strcmp(argv[i], "--dump") == 0) dump = argv[i + 1];
    if (std::strcmp(argv[i], "--cameras") == 0) cameras = argv[i + 1];
  }
  const auto all = rig::readCameras(cameras);
  const auto plate = batch::readPlate(folder / "plate.json");
  if (!all || !plate) return std::fprintf(stderr, "cannot read the batch\n"), 2;
  std::vector<cv::Mat> empties;
  for (int c = 0; with_empty && c < 3; ++c)
    empties.push_back(
        cv::imread((folder / "calib" / ("empty_cam" + std::to_string(c) + ".jpg")).string()));
  double seconds = 0;
  Sum all_photographs;
  std::map<int, Sum> by_camera;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    if (!only.empty() && only != batch::name(side)) continue;
    std::vector<rig::PosedImage> images;
    std::vector<cv::Mat> photographs;
    for (const rig::PosedImage& image : *all)
      if (image.side == side) {
        images.push_back(image);
        photographs.push_back(cv::imread((folder / image.file).string(),
                                         cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION));
      }
    QuietProgress quiet;
    const auto start = std::chrono::steady_clock::now();
    options.shown.clear();
    if (plate->sheet && !plate->round) {
      auto shown = pipeline::shownOn({*plate->sheet, options.bend, true}, images, photographs,
                                     {options.threads}, quiet, {});
      if (shown) options.shown = std::move(*shown);
    }
    const auto result = mask::maskByPlate(images, photographs, *plate, empties, options, quiet, {});
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!result)
      return std::fprintf(stderr, "%s\n", result.error().sentence().english().c_str()), 1;
    for (const Message& warning : result->warnings)
      std::printf("warning: %s\n", warning.english().c_str());
    for (std::size_t i = 0; i < images.size(); ++i) {
      const std::string name = truthMaskName(images[i]);
      const cv::Mat1b labels =
          cv::imread((folder / "truth" / "masks" / name).string(), cv::IMREAD_GRAYSCALE);
      const Accuracy a = compare(result->masks[i], labels != 0);
      std::printf("%-24s IoU %.4f  edge bias %+.3f  mean %.3f  worst %.1f px\n", name.c_str(),
                  a.iou, a.bias_px, a.mean_px, a.worst_px);
      all_photographs.add(a);
      by_camera[images[i].camera].add(a);
      if (!dump.empty()) cv::imwrite(dump + "/" + name, result->masks[i]);
    }
  }
  for (const auto& [camera, sum] : by_camera) sum.print("camera " + std::to_string(camera));
  all_photographs.print("mean");
  std::printf("%.1f s\n", seconds);
  return 0;
}
