#include "virtualrig/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/parallel.h"
#include "rendering/scene.h"
#include "vessels/rest.h"

namespace ostraka::virtualrig {
namespace {

constexpr double kHalfWay_mm = 60;  // from the axis
constexpr float kFacetLift =
    0.05f;  // mm off the surface, so that a ray does not meet its own start

// A point of a sherd with the area it stands for.
struct Sample {
  int vertex = 0;
  double area = 0;
  bool broken = false;
};

std::vector<Sample> samplesOf(const vessels::VirtualSherd& sherd, int count) {
  std::vector<double> area(sherd.mesh.vertices.size(), 0.0);
  for (const auto& t : sherd.mesh.triangles) {
    const Eigen::Vector3f &a = sherd.mesh.vertices[t[0]], &b = sherd.mesh.vertices[t[1]],
                          &c = sherd.mesh.vertices[t[2]];
    const double third = (b - a).cross(c - a).norm() / 6;
    for (const int v : t) area[v] += third;
  }
  const std::size_t step = std::max<std::size_t>(1, area.size() / static_cast<std::size_t>(count));
  std::vector<Sample> samples;
  for (std::size_t v = step / 2; v < area.size(); v += step)
    samples.push_back({static_cast<int>(v), area[v], sherd.places[v].broken > 0.5f});
  return samples;
}

struct Tally {
  double area = 0, seen = 0, broken = 0, broken_seen = 0, square = 0, broken_square = 0;
  std::int64_t views = 0, outside = 0;
};

class Look {
 public:
  Look(const VirtualRig& rig, const CoverageOptions& options, const std::stop_token& asked)
      : rig_(rig), options_(options), asked_(asked) {
    for (int stop = 0; stop < static_cast<int>(rig.angles_rad.size()); ++stop)
      for (int camera = 0; camera < rig.cameras(); ++camera) {
        poses_.push_back(rig.cameraFromPlate(camera, stop));
        eyes_.push_back(poses_.back().inverse().translation().cast<float>());
      }
  }

  // Of each sample the cosine between ray and normal in the least square of enough views of this
  // side; 0: too few views, or it was stopped.
  std::vector<float> side(const rendering::Scene& scene, const std::vector<Sample>& samples,
                          Tally& tally) const {
    std::vector<float> square(samples.size(), 0);
    std::vector<std::pair<float, std::size_t>> views;  // cosine, view
    const std::vector<Eigen::Vector3f>&points = scene.vertices(0), &normals = scene.normals(0);
    const double least = std::cos(options_.most_slant_rad);
    for (std::size_t i = 0; i < samples.size() && !asked_.stop_requested(); ++i) {
      const Eigen::Vector3f& p = points[samples[i].vertex];
      const Eigen::Vector3f& n = normals[samples[i].vertex];
      views.clear();
      for (std::size_t v = 0; v < eyes_.size(); ++v) {
        const Eigen::Vector3f to_eye = eyes_[v] - p;
        const float cosine = n.dot(to_eye) / to_eye.norm();
        if (cosine < least) continue;
        ++tally.views;
        if (inPicture(v, p))
          views.emplace_back(cosine, v);
        else
          ++tally.outside;
      }
      std::sort(views.begin(), views.end(), std::greater<>());
      int seen = 0;
      for (const auto& [cosine, v] : views)
        if (!scene.blocked(p + kFacetLift * n, eyes_[v] - p, 1) && ++seen == options_.least_views) {
          square[i] = cosine;
          break;
        }
    }
    return square;
  }

 private:
  bool inPicture(std::size_t view, const Eigen::Vector3f& p) const {
    const rig::Intrinsics& k = rig_.intrinsics[view % static_cast<std::size_t>(rig_.cameras())];
    const Eigen::Vector3d x = poses_[view] * p.cast<double>();
    if (x.z() <= 0) return false;
    const Eigen::Vector2d q = k.project(x);
    return q.x() >= 0 && q.y() >= 0 && q.x() <= k.width - 1 && q.y() <= k.height - 1;
  }

  const VirtualRig& rig_;
  const CoverageOptions& options_;
  const std::stop_token& asked_;
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<Eigen::Vector3f> eyes_;
};

SherdCoverage ofSherd(const vessels::VirtualSherd& sherd, const Look& look,
                      const CoverageOptions& options) {
  const std::vector<Sample> samples = samplesOf(sherd, options.points_per_sherd);
  Tally tally;
  const std::vector<vessels::VirtualSherd> alone{sherd};
  for (const double away : {0.0, kHalfWay_mm}) {
    std::array<std::vector<float>, 2> sides;
    for (const int down : {0, 1}) {
      Eigen::Isometry3d pose = vessels::restPose(sherd.mesh, {0, 0, down == 0 ? 1.0 : -1.0});
      pose.pretranslate(Eigen::Vector3d(away, 0, 0));
      const rendering::Scene scene(alone, {pose});
      sides[down] = look.side(scene, samples, tally);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto [worse, better] = std::minmax(sides[0][i], sides[1][i]);
      tally.area += samples[i].area;
      tally.seen += better > 0 ? samples[i].area : 0;
      tally.square += samples[i].area * better;
      if (!samples[i].broken) continue;
      tally.broken += samples[i].area;
      tally.broken_seen += worse > 0 ? samples[i].area : 0;
      tally.broken_square += samples[i].area * worse;
    }
  }
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
  return {share(tally.seen, tally.area), share(tally.broken_seen, tally.broken),
          0.5 * (share(tally.square, tally.area) + share(tally.broken_square, tally.broken)),
          share(static_cast<double>(tally.outside), static_cast<double>(tally.views))};
}

// How much of the sherds models can rest on: seen squarely, and with a break that both sides see,
// which ties them together.
Result<double> promise(const std::vector<vessels::VirtualSherd>& sherds, const VirtualRig& rig,
                       const CoverageOptions& options, const std::stop_token& stop) {
  const Result<std::vector<SherdCoverage>> found = coverage(sherds, rig, options, stop);
  if (!found) return found.error();
  double sum = 0;
  for (const SherdCoverage& one : *found) sum += one.square + 0.3 * one.break_seen;
  return sum / static_cast<double>(sherds.size());
}

// The widest step from one camera's elevation to the next one's, radians.
double widestStep(const VirtualRig& rig) {
  std::vector<double> elevations;
  for (int c = 0; c < rig.cameras(); ++c) elevations.push_back(elevation(rig, c));
  std::sort(elevations.begin(), elevations.end());
  double widest = 0;
  for (std::size_t c = 1; c < elevations.size(); ++c)
    widest = std::max(widest, elevations[c] - elevations[c - 1]);
  return widest;
}

}  // namespace

Result<std::vector<SherdCoverage>> coverage(const std::vector<vessels::VirtualSherd>& sherds,
                                            const VirtualRig& rig, const CoverageOptions& options,
                                            const std::stop_token& stop) {
  const Look look(rig, options, stop);
  std::vector<SherdCoverage> found(sherds.size());
  parallelFor(sherds.size(), options.threads,
              [&](std::size_t i) { found[i] = ofSherd(sherds[i], look, options); });
  if (stop.stop_requested()) return Error::cancelled();
  return found;
}

Eigen::Isometry3d raised(const Eigen::Isometry3d& camera_from_room, double raise_rad) {
  const Eigen::Vector3d eye = camera_from_room.inverse().translation();
  const Eigen::Vector3d axis = eye.cross(Eigen::Vector3d::UnitZ()).normalized();
  return camera_from_room * Eigen::AngleAxisd(-raise_rad, axis);
}

Result<std::vector<CameraMove>> promisingMoves(const std::vector<vessels::VirtualSherd>& sherds,
                                               const VirtualRig& rig,
                                               const CoverageOptions& options,
                                               std::stop_token stop) {
  constexpr double kLeastGain = 0.01;
  // Pictures from farther apart do not match: the demo's middle camera carried down from 44 to 24
  // degrees, 40 below the highest, saw a fifth more of the breaks, and models became worse.
  constexpr double kWidestStep = 26 * std::numbers::pi / 180;
  std::vector<CameraMove> moves;
  if (sherds.empty()) return moves;
  const Result<double> now = promise(sherds, rig, options, stop);
  if (!now) return now.error();
  const double widest = std::max(kWidestStep, widestStep(rig));
  CameraMove closing{0, 0, -1};
  for (int camera = 0; camera < rig.cameras(); ++camera) {
    CameraMove best{camera, 0, kLeastGain};
    for (const double degrees : {-20.0, -10.0, 10.0, 20.0}) {
      const double then = elevation(rig, camera) * 180 / std::numbers::pi + degrees;
      if (then < 10 || then > 85) continue;
      const double raise = degrees * std::numbers::pi / 180;
      VirtualRig moved = rig;
      Eigen::Isometry3d& pose = moved.camera_from_room[static_cast<std::size_t>(camera)];
      pose = raised(pose, raise);
      if (widestStep(moved) > widest + 1e-9) continue;
      const Result<double> promised = promise(sherds, moved, options, stop);
      if (!promised) return promised.error();
      const double gain = *promised - *now;
      if (gain > best.gain) best = {camera, raise, gain};
      if (widest > kWidestStep && widestStep(moved) <= kWidestStep && gain > closing.gain)
        closing = {camera, raise, gain};
    }
    if (best.raise_rad != 0) moves.push_back(best);
  }
  std::ranges::stable_sort(moves, std::greater(), &CameraMove::gain);
  if (closing.raise_rad != 0) {
    std::erase_if(moves, [&](const CameraMove& m) { return m.camera == closing.camera; });
    moves.insert(moves.begin(), closing);
  }
  return moves;
}

double elevation(const VirtualRig& rig, int camera) {
  const Eigen::Vector3d eye =
      rig.camera_from_room[static_cast<std::size_t>(camera)].inverse().translation();
  return std::atan2(eye.z(), eye.head<2>().norm());
}

double pixelSize(const VirtualRig& rig, int camera) {
  const auto c = static_cast<std::size_t>(camera);
  return rig.camera_from_room[c].translation().norm() / rig.intrinsics[c].fx;
}

}  // namespace ostraka::virtualrig
