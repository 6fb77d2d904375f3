#include "virtualrig/batch_files.h"

#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cloud/ply.h"
#include "files/files.h"
#include "files/json.h"
#include "images/jpeg_image.h"
#include "images/png_image.h"
#include "rendering/plate_surface.h"
#include "rig/plate_print.h"

namespace ostraka::virtualrig {
namespace {

// To 1 / steps: written short, as 61.6.
double rounded(double value, int steps) {
  return std::round(value * steps) / steps;
}

}  // namespace

std::string photographName(batch::Side side, int camera, int stop) {
  return std::string(batch::name(side)) + "/" + formatted("cam%d_pos%02d.jpg", camera, stop);
}

Result<void> writeJpeg(const std::filesystem::path& file, const cv::Mat& image,
                       const images::JpegOptions& options, double kept_share) {
  const std::string bytes = images::encodedJpeg(image, options);
  const auto kept = static_cast<std::size_t>(static_cast<double>(bytes.size()) * kept_share);
  return writeFileAtomically(file, std::string_view(bytes).substr(0, kept));
}

Result<void> writePng(const std::filesystem::path& file, const cv::Mat& image) {
  return writeFileAtomically(file, images::encodedPng(image, 6));
}

Result<void> writePlateAndBoard(const std::filesystem::path& folder) {
  if (Result<void> r = rig::writePlate(folder / "plate.json", rendering::standardPlate()); !r)
    return r;
  return rig::writeBoard(folder / "board.json", rig::standardBoard());
}

std::vector<rig::PosedImage> posedImages(const VirtualRig& rig) {
  std::vector<rig::PosedImage> images;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    for (int stop = 0; stop < static_cast<int>(rig.angles_rad.size()); ++stop)
      for (int camera = 0; camera < rig.cameras(); ++camera)
        images.push_back({photographName(side, camera, stop), side, camera, stop,
                          rig.intrinsics[camera], rig.cameraFromPlate(camera, stop)});
  return images;
}

Result<void> writeTruth(const std::filesystem::path& folder,
                        const std::vector<vessels::VirtualSherd>& sherds, const Layout& layout,
                        const std::vector<rig::PosedImage>& images) {
  if (Result<void> r = rig::writeCameras(folder / "cameras.json", images); !r) return r;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < sherds.size(); ++i) {
    const vessels::VirtualSherd& s = sherds[i];
    const std::string mesh = formatted("sherd%02d.ply", static_cast<int>(i));
    if (Result<void> r = writePly(folder / mesh, s.mesh, "model"); !r) return r;
    nlohmann::ordered_json group;
    if (s.lookalike_group >= 0) group = s.lookalike_group;
    const bool outer_up = (layout.front[i].linear() * Eigen::Vector3d::UnitZ()).z() > 0;
    list.push_back(
        {{"id", i},
         {"mesh", mesh},
         {"plate_from_model_front", toJson(layout.front[i])},
         {"plate_from_model_back", toJson(layout.back[i])},
         {"T_front_from_back", toJson(layout.front[i] * layout.back[i].inverse())},
         {"lookalike_group", group},
         {"kind", s.kind},
         {"width_mm", rounded(s.width_mm, 10)},
         {"wall_mm",
          {rounded(s.wall_min_mm, 100), rounded(s.wall_mean_mm, 100), rounded(s.wall_max_mm, 100)}},
         {"volume_mm3", rounded(s.volume_mm3, 1)},
         {"outer_up_in_front", outer_up}});
  }
  return writeJson(folder / "sherds.json", {{"unit", "mm"}, {"sherds", list}});
}

}  // namespace ostraka::virtualrig
