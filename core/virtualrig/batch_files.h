#pragma once
#include <filesystem>
#include <opencv2/core.hpp>

#include "virtualrig/layout.h"
#include "virtualrig/setup.h"

/// The files of a simulated batch: ../shared/batches/README.md.
namespace ostraka::virtualrig {

std::string photographName(batch::Side side, int camera, int stop);  ///< "front/cam0_pos00.jpg"

Result<void> writePlateAndBoard(const std::filesystem::path& folder);
/// cameras.json, sherds.json and the meshes.
Result<void> writeTruth(const std::filesystem::path& folder,
                        const std::vector<vessels::VirtualSherd>& sherds, const Layout& layout,
                        const std::vector<rig::PosedImage>& images);
std::vector<rig::PosedImage> posedImages(const VirtualRig& rig);

struct JpegOptions {
  int quality = 95;
  bool halved_colors = false;  ///< 4:2:0 instead of 4:4:4
  std::string exif = {};       ///< content of APP1; empty: none
  double kept_share = 1;       ///< less cuts the file off
};
/// Of an 8-bit picture: blue, green, red.
std::string encodedJpeg(const cv::Mat& image, const JpegOptions& options = {});
Result<void> writeJpeg(const std::filesystem::path& file, const cv::Mat& image,
                       const JpegOptions& options = {});
Result<void> writePng(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace ostraka::virtualrig
