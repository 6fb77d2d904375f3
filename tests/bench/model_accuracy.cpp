// Closes models from scans and writes them, with figures, for the judge:
//   model_accuracy FRONT.ply BACK.ply T.json OUT_PREFIX [--disturb MM] [--spacing MM] [--cell MM]
//   [--threads N]
// T.json holds T_front_from_back, or is a truth.json with "pairs" (then the files' names choose).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cloud/glb.h"
#include "cloud/ply.h"
#include "files/files.h"
#include "files/json.h"
#include "model/model.h"
#include "model/preview.h"

namespace {

using namespace ostraka;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int refuse(const Error& error) {
  std::fprintf(stderr, "%s\n", error.sentence().english().c_str());
  return 2;
}

Result<Eigen::Isometry3d> transformFor(const std::string& front, const std::string& path) {
  const Result<nlohmann::json> json = readJson(path);
  if (!json) return json.error();
  if (!json->contains("pairs")) return isometryFromJson(json->at("T_front_from_back"), path);
  for (const nlohmann::json& pair : json->at("pairs"))
    if (std::filesystem::path(pair.at("front").get<std::string>()).filename() ==
        std::filesystem::path(front).filename())
      return isometryFromJson(pair.at("T_front_from_back"), path);
  return Error{ErrorCode::UnusableInput, "No pair has this front.", front};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fprintf(stderr,
                 "model_accuracy FRONT.ply BACK.ply T.json OUT_PREFIX [--disturb MM] [--spacing "
                 "MM] [--cell MM] [--threads N]\n");
    return 2;
  }
  std::map<std::string, double> given;
  for (int i = 5; i + 1 < argc; i += 2) given[argv[i]] = std::stod(argv[i + 1]);
  const Result<PointCloud> front = readPlyCloud(argv[1]), back = readPlyCloud(argv[2]);
  if (!front) return refuse(front.error());
  if (!back) return refuse(back.error());
  Result<Eigen::Isometry3d> front_from_back = transformFor(argv[1], argv[3]);
  if (!front_from_back) return refuse(front_from_back.error());
  front_from_back->pretranslate(given["--disturb"] * Eigen::Vector3d(0.6, 0, 0.8));

  model::ModelOptions options;
  options.point_spacing_mm = given["--spacing"];
  options.cell_mm = given["--cell"];
  options.threads = given.contains("--threads") ? static_cast<int>(given["--threads"]) : 1;
  QuietProgress quiet;
  const double begun = seconds();
  const auto made = model::closeModel(*front, *back, *front_from_back, options, quiet, {});
  const double closed = seconds();
  if (!made) return refuse(made.error());
  Message why = "closed, manifold";
  model::isClosedManifold(made->mesh, &why);
  const model::Measures m = model::measure(made->mesh);
  const double measured = seconds();
  const auto fewer = model::decimated(made->mesh, 0.03);
  const double thinner = seconds();
  std::printf(
      "%s: %.2f s model, %.2f s measures, %.2f s decimation to %zu faces; %zu faces, %s; points "
      "%d, dropped %d; "
      "noise %.3f, gap %.3f mm; filled %.2f %%; length %.2f, width %.2f, thickness %.2f %.2f %.2f "
      "mm, area %.1f mm2, volume %.1f mm3\n",
      argv[4], closed - begun, measured - closed, thinner - measured,
      fewer ? fewer->triangles.size() : 0, made->mesh.triangles.size(), why.english().c_str(),
      made->points_used, made->points_dropped, made->noise_mm, made->side_gap_mm,
      100 * made->filled_share, m.length_mm, m.width_mm, m.thickness_min_mm, m.thickness_mean_mm,
      m.thickness_max_mm, m.area_mm2, m.volume_mm3);
  const std::string prefix = argv[4];
  const Result<void> ply = writePly(prefix + ".ply", made->mesh, "plate_front");
  if (!ply) return refuse(ply.error());
  if (fewer)
    if (const Result<void> glb = writeGlb(prefix + ".glb", formatGlb(*fewer, {})); !glb)
      return refuse(glb.error());
  cv::imwrite(prefix + ".png", model::renderPreview(made->mesh, {}));
  return 0;
}
