// dense_accuracy BATCH front|back OUT.ply [--sherd K] [--threads N] [--masks DIR]
// One side's dense cloud from the true cameras and masks, to be judged by `evaluate.py cloud`.
// --sherd K takes that sherd alone (1 = the first);
// --masks DIR takes masks from there (front_cam0_pos00.png) instead of the true ones. Prints the
// seconds.
#include <chrono>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "cloud/ply.h"
#include "stereo/stereo.h"

using namespace ostraka;

namespace {

class Notes final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override {
    std::printf("%s\n", text.english().c_str());
  }
};

struct Arguments {
  std::string batch, side, out, masks;
  int sherd = 0, threads = 1;
};

Result<std::vector<stereo::View>> readViews(const Arguments& a) {
  auto images = rig::readCameras(a.batch + "/truth/cameras.json");
  if (!images) return images.error();
  std::vector<stereo::View> views;
  for (const rig::PosedImage& image : *images) {
    if (image.file.rfind(a.side + "/", 0) != 0) continue;
    stereo::View view;
    view.camera = image;
    view.photograph =
        cv::imread(a.batch + "/" + image.file, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    std::string mask = image.file.substr(0, image.file.size() - 4) + ".png";
    mask[mask.find('/')] = '_';
    const cv::Mat labels = cv::imread(
        (a.masks.empty() ? a.batch + "/truth/masks" : a.masks) + "/" + mask, cv::IMREAD_UNCHANGED);
    view.mask = a.sherd > 0       ? cv::Mat1b(labels == a.sherd)
                : a.masks.empty() ? cv::Mat1b(labels > 0)
                                  : cv::Mat1b(labels);
    views.push_back(std::move(view));
  }
  return views;
}

int run(const Arguments& a) {
  auto views = readViews(a);
  if (!views) return std::fprintf(stderr, "%s\n", views.error().sentence().english().c_str()), 2;
  stereo::DenseOptions options;
  options.threads = a.threads;
  options.floor_z_mm = 0.0;
  Notes notes;
  const auto start = std::chrono::steady_clock::now();
  const auto cloud = stereo::reconstruct(*views, options, notes, {});
  if (!cloud) return std::fprintf(stderr, "%s\n", cloud.error().sentence().english().c_str()), 1;
  const std::chrono::duration<double> s = std::chrono::steady_clock::now() - start;
  std::printf("%zu views, %zu points, %.1f s with %d threads\n", views->size(), cloud->cloud.size(),
              s.count(), a.threads);
  auto written = writePly(a.out, cloud->cloud, "plate_" + a.side);
  return written ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "dense_accuracy BATCH front|back OUT.ply\n"), 2;
  Arguments a{argv[1], argv[2], argv[3], {}};
  for (int i = 4; i + 1 < argc; i += 2) {
    if (std::string(argv[i]) == "--sherd") a.sherd = std::stoi(argv[i + 1]);
    if (std::string(argv[i]) == "--masks") a.masks = argv[i + 1];
    if (std::string(argv[i]) == "--threads") a.threads = std::stoi(argv[i + 1]);
  }
  return run(a);
}
