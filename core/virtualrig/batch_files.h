#pragma once
#include <filesystem>
#include <opencv2/core.hpp>

#include "images/jpeg_image.h"
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

/// Colours in full resolution (4:4:4), unless told otherwise; a kept share below 1 cuts the file
/// off.
Result<void> writeJpeg(const std::filesystem::path& file, const cv::Mat& image,
                       const images::JpegOptions& options = {.halved_colors = false},
                       double kept_share = 1);
Result<void> writePng(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace ostraka::virtualrig
