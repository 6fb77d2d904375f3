#include "synthetic_out.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "../registration/simulated_sherd.h"
#include "cloud/ply.h"
#include "files/json.h"
#include "rig/camera.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using batch::Side;
using Eigen::Isometry3d;
using Eigen::Vector3d;

struct Placed {
  scan::Scan front, back;
  Isometry3d front_from_back = Isometry3d::Identity();
};

// Stretched in its own frame, where the front lies flat, then laid on the plates.
Placed placed(int i, const SyntheticOptions& options) {
  const bool alike = options.swapped_look_alikes && i < 2;
  registration::SimulatedSherdOptions shape;
  shape.seed = static_cast<unsigned>(i + 1);
  shape.shape = i;
  shape.noise_mm = options.noise_mm;
  const registration::SimulatedSherd sherd = registration::simulatedSherd(shape);
  const double wide = alike ? 0.6 : 0.5 + 0.03 * (i % 7),
               high = alike ? 0.6 : 0.72 - 0.04 * (i % 5);
  const Eigen::DiagonalMatrix<double, 3> stretch(wide, high, 1), unstretch(1 / wide, 1 / high, 1);
  const double x = -80.0 + 40.0 * (i % 5), y = 60.0 - 40.0 * (i / 5);
  Isometry3d front_place = Isometry3d::Identity(), back_place = Isometry3d::Identity();
  front_place.translate(Vector3d(x, y, 0));
  back_place.translate(Vector3d(x + 2, y - 3, 5));
  back_place.rotate(Eigen::AngleAxisd(0.3 + 0.2 * i, Vector3d::UnitZ()));
  back_place.rotate(Eigen::AngleAxisd(std::acos(-1.0), Vector3d::UnitX()));

  Placed out;
  out.front_from_back = front_place * back_place.inverse();
  char id[16];
  const auto fill = [&](scan::Scan& to, const scan::Scan& from, const Isometry3d& own_from_scan,
                        const Isometry3d& place, char letter) {
    std::snprintf(id, sizeof id, "%c%03d", letter, i + 1);
    to.id = id;
    for (std::size_t k = 0; k < from.cloud.size(); ++k) {
      const Vector3d p = stretch * (own_from_scan * from.cloud.points[k].cast<double>());
      const Vector3d n = own_from_scan.linear() * from.cloud.normals[k].cast<double>();
      to.cloud.points.push_back((place * p).cast<float>());
      to.cloud.normals.push_back(
          (place.linear() * Vector3d(unstretch * n).normalized()).cast<float>());
      // Fired clay with a darker spot that says which is which.
      const double spot = std::exp(-0.02 * (p.head<2>() - Eigen::Vector2d(i % 5, 3)).squaredNorm());
      const int shade = static_cast<int>(60 * spot) + 6 * (i % 4);
      to.cloud.colors.push_back({static_cast<std::uint8_t>(190 - shade),
                                 static_cast<std::uint8_t>(140 - shade),
                                 static_cast<std::uint8_t>(105 - shade)});
    }
  };
  fill(out.front, sherd.front, Isometry3d::Identity(), front_place, 'f');
  fill(out.back, sherd.back, sherd.truth, back_place, 'b');
  return out;
}

rig::PosedImage fromAbove(Side side, const fs::path& file) {
  rig::PosedImage image;
  image.file = file.string();
  image.side = side;
  image.intrinsics = {1200, 1000, 3000, 3000, 600, 500, {}};
  image.camera_from_plate.linear() =
      Eigen::AngleAxisd(std::acos(-1.0), Vector3d::UnitX()).toRotationMatrix();
  image.camera_from_plate.translation() = Vector3d(0, 0, 600);
  return image;
}

void photograph(const rig::PosedImage& image, const std::vector<const scan::Scan*>& scans,
                const fs::path& mask_file) {
  cv::Mat picture(image.intrinsics.height, image.intrinsics.width, CV_8UC3, {58, 60, 62});
  cv::Mat1b mask = cv::Mat1b::zeros(picture.size());
  for (const scan::Scan* scan : scans)
    for (std::size_t k = 0; k < scan->cloud.size(); ++k) {
      const Vector3d p = scan->cloud.points[k].cast<double>();
      const Eigen::Vector2d pixel = image.project(p);
      const cv::Point at(static_cast<int>(std::lround(pixel.x())),
                         static_cast<int>(std::lround(pixel.y())));
      const Color& c = scan->cloud.colors[k];
      cv::circle(picture, at, 1, {double(c[2]), double(c[1]), double(c[0])}, cv::FILLED);
      cv::circle(mask, at, 1, 255, cv::FILLED);
    }
  fs::create_directories(fs::path(image.file).parent_path());
  fs::create_directories(mask_file.parent_path());
  cv::imwrite(image.file, picture);
  cv::imwrite(mask_file.string(), mask);
}

decisions::RegisteredCandidate candidate(int front, int back, double log_likelihood,
                                         double fracture_rms_mm, const Isometry3d& pose) {
  decisions::RegisteredCandidate c;
  c.evidence.front = front;
  c.evidence.back = back;
  c.evidence.log_likelihood = log_likelihood;
  c.evidence.fracture_rms_mm = c.registration.fracture_rms_mm = fracture_rms_mm;
  c.evidence.overlap = c.registration.fracture_overlap = 0.8;
  c.registration.uncertainty_mm = 0.05;
  c.registration.runner_up_gap = 1e9;
  c.registration.start = 0;
  c.registration.front_from_back = pose;
  c.starts = {{pose, 0.2, log_likelihood, 40, 1}, {pose, 0.4, log_likelihood - 6, 120, 1}};
  return c;
}

// Its sherds are the pairs as the program has them.
void writeReport(const decisions::CandidateTable& table, const SyntheticOptions& options,
                 const fs::path& file) {
  nlohmann::ordered_json sherds = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < table.fronts.size(); ++i) {
    const std::size_t back = options.swapped_look_alikes && i < 2 ? 1 - i : i;
    sherds.push_back({{"number", decisions::sherdNumber(table.fronts[i].id)},
                      {"front", table.fronts[i].id},
                      {"back", table.backs[back].id}});
  }
  (void)writeJson(file, {{"format", "ostraka-report/1"},
                         {"decisions", nlohmann::ordered_json::array()},
                         {"sherds", sherds}});
}

}  // namespace

SyntheticOut writeSyntheticOut(const fs::path& output, const SyntheticOptions& options) {
  SyntheticOut out;
  out.output = output;
  const fs::path work = output / "work";
  std::vector<Placed> sherds;
  for (int i = 0; i < options.sherds; ++i) sherds.push_back(placed(i, options));
  std::vector<const scan::Scan*> fronts, backs;
  for (const Placed& sherd : sherds) {
    fronts.push_back(&sherd.front);
    backs.push_back(&sherd.back);
    out.table.fronts.push_back(decisions::refOf(sherd.front, Side::Front));
    out.table.backs.push_back(decisions::refOf(sherd.back, Side::Back));
    out.table.front_files.push_back("scans_front/" + sherd.front.id + ".ply");
    out.table.back_files.push_back("scans_back/" + sherd.back.id + ".ply");
    (void)writePly(work / out.table.front_files.back(), sherd.front.cloud, "plate_front");
    (void)writePly(work / out.table.back_files.back(), sherd.back.cloud, "plate_back");
    out.front_from_back.push_back(sherd.front_from_back);
  }
  const rig::PosedImage front = fromAbove(Side::Front, output / "photographs" / "front.png");
  const rig::PosedImage back = fromAbove(Side::Back, output / "photographs" / "back.png");
  photograph(front, fronts, work / "masks_front" / "front.png");
  photograph(back, backs, work / "masks_back" / "back.png");
  (void)rig::writeCameras(work / "rig" / "cameras.json", {front, back});

  // The outlines of near-duplicates lie on each other: the pose of one is the other's, moved.
  const auto across = [&](int f, int b) {
    const Isometry3d& own = out.front_from_back[static_cast<std::size_t>(b)];
    const decisions::ScanRef &from = out.table.fronts[static_cast<std::size_t>(b)],
                             &to = out.table.fronts[static_cast<std::size_t>(f)];
    Isometry3d pose = own;
    pose.pretranslate(
        Vector3d(to.place_mm.x() - from.place_mm.x(), to.place_mm.y() - from.place_mm.y(), 0));
    return pose;
  };
  for (int i = 0; i < options.sherds; ++i) {
    const Isometry3d& truth = out.front_from_back[static_cast<std::size_t>(i)];
    if (options.swapped_look_alikes && i < 2) {
      const int other = 1 - i;
      const decisions::RegisteredCandidate own = candidate(i, i, 9.0, 0.11, truth);
      const decisions::RegisteredCandidate wrong = candidate(i, other, 9.6, 0.10, across(i, other));
      out.table.candidates.push_back(i == 0 ? own : wrong);
      out.table.candidates.push_back(i == 0 ? wrong : own);
    } else {
      out.table.candidates.push_back(candidate(i, i, 14, 0.08, truth));
    }
  }
  (void)writeJson(work / "pairs" / "candidates.json", toJson(out.table));
  writeReport(out.table, options, output / "report.json");
  return out;
}

}  // namespace ostraka::pipeline
