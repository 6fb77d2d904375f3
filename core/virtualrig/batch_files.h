#pragma once
#include <filesystem>
#include <opencv2/core.hpp>

#include "virtualrig/layout.h"
#include "virtualrig/setup.h"

/// The files of a simulated batch: ../shared/batches/README.md.
namespace ostraka::virtualrig {

std::string photographName(batch::Side side, int camera, int stop);  ///< "front/cam0_pos00.jpg"

Result<void> writePlateAndBoard(const std::filesystem::path& folder);
Result<void> writeTruth(const std::filesystem::path& folder,
                        const std::vector<VirtualSherd>& sherds, const Layout& layout,
                        const VirtualRig& rig);
/// JPEG 4:4:4, quality 95, of an 8-bit picture: blue, green, red.
std::string encodedJpeg(const cv::Mat& image);
/// The same to a file; kept_share < 1 cuts the file off.
Result<void> writeJpeg(const std::filesystem::path& file, const cv::Mat& image,
                       double kept_share = 1);
Result<void> writePng(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace ostraka::virtualrig
