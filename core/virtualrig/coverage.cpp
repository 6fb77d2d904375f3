#include "virtualrig/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "virtualrig/rest.h"
#include "virtualrig/scene.h"

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

std::vector<Sample> samplesOf(const VirtualSherd& sherd, int count) {
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
  double area = 0, seen = 0, broken = 0, broken_seen = 0;
  std::int64_t views = 0, outside = 0;
};

class Look {
 public:
  Look(const VirtualRig& rig, const CoverageOptions& options) : rig_(rig), options_(options) {
    for (int stop = 0; stop < static_cast<int>(rig.angles_rad.size()); ++stop)
      for (int camera = 0; camera < rig.cameras(); ++camera) {
        poses_.push_back(rig.cameraFromPlate(camera, stop));
        eyes_.push_back(poses_.back().inverse().translation().cast<float>());
      }
  }

  // Counts this side for the samples that enough of its views see.
  void side(const Scene& scene, const std::vector<Sample>& samples, std::vector<char>& sides,
            Tally& tally) const {
    const std::vector<Eigen::Vector3f>&points = scene.vertices(0), &normals = scene.normals(0);
    const double least = std::cos(options_.most_slant_rad);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Eigen::Vector3f& p = points[samples[i].vertex];
      const Eigen::Vector3f& n = normals[samples[i].vertex];
      int views = 0;
      for (std::size_t v = 0; v < eyes_.size(); ++v) {
        const Eigen::Vector3f to_eye = eyes_[v] - p;
        if (n.dot(to_eye) < least * to_eye.norm()) continue;
        ++tally.views;
        if (!inPicture(v, p)) {
          ++tally.outside;
          continue;
        }
        if (views < options_.least_views && !scene.blocked(p + kFacetLift * n, to_eye, 1)) ++views;
      }
      if (views >= options_.least_views) ++sides[i];
    }
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
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<Eigen::Vector3f> eyes_;
};

SherdCoverage ofSherd(const VirtualSherd& sherd, const Look& look, const CoverageOptions& options) {
  const std::vector<Sample> samples = samplesOf(sherd, options.points_per_sherd);
  Tally tally;
  const std::vector<VirtualSherd> alone{sherd};
  for (const double away : {0.0, kHalfWay_mm}) {
    std::vector<char> sides(samples.size(), 0);
    for (const double up : {1.0, -1.0}) {
      Eigen::Isometry3d pose = restPose(sherd.mesh, {0, 0, up});
      pose.pretranslate(Eigen::Vector3d(away, 0, 0));
      const Scene scene(alone, {pose});
      look.side(scene, samples, sides, tally);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      tally.area += samples[i].area;
      tally.seen += sides[i] > 0 ? samples[i].area : 0;
      if (!samples[i].broken) continue;
      tally.broken += samples[i].area;
      tally.broken_seen += sides[i] == 2 ? samples[i].area : 0;
    }
  }
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
  return {share(tally.seen, tally.area), share(tally.broken_seen, tally.broken),
          share(static_cast<double>(tally.outside), static_cast<double>(tally.views))};
}

double breaksSeen(const std::vector<VirtualSherd>& sherds, const VirtualRig& rig,
                  const CoverageOptions& options) {
  double sum = 0;
  for (const SherdCoverage& one : coverage(sherds, rig, options)) sum += one.break_seen;
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

// The camera carried about the plate's middle, still looking at the same places.
VirtualRig raised(VirtualRig rig, int camera, double raise_rad) {
  Eigen::Isometry3d& pose = rig.camera_from_room[static_cast<std::size_t>(camera)];
  const Eigen::Vector3d eye = pose.inverse().translation();
  const Eigen::Vector3d axis = eye.cross(Eigen::Vector3d::UnitZ()).normalized();
  pose = pose * Eigen::AngleAxisd(-raise_rad, axis);
  return rig;
}

}  // namespace

std::vector<SherdCoverage> coverage(const std::vector<VirtualSherd>& sherds, const VirtualRig& rig,
                                    const CoverageOptions& options) {
  const Look look(rig, options);
  std::vector<SherdCoverage> found(sherds.size());
  parallelFor(sherds.size(), options.threads,
              [&](std::size_t i) { found[i] = ofSherd(sherds[i], look, options); });
  return found;
}

Result<CameraAdvice> bestMove(const std::vector<VirtualSherd>& sherds, const VirtualRig& rig,
                              const CoverageOptions& options, std::stop_token stop) {
  constexpr double kLeastGain = 0.01;
  // Pictures from farther apart do not match: the demo's middle camera carried down from 44 to 24
  // degrees, 40 below the highest, saw a fifth more of the breaks, and models became worse.
  constexpr double kWidestStep = 26 * std::numbers::pi / 180;
  CameraAdvice best;
  if (sherds.empty()) return best;
  const double now = breaksSeen(sherds, rig, options);
  const double widest = std::max(kWidestStep, widestStep(rig));
  for (int camera = 0; camera < rig.cameras(); ++camera)
    for (const double degrees : {-20.0, -10.0, 10.0, 20.0}) {
      if (stop.stop_requested()) return Error::cancelled();
      const double then = elevation(rig, camera) * 180 / std::numbers::pi + degrees;
      if (then < 10 || then > 85) continue;
      const double raise = degrees * std::numbers::pi / 180;
      const VirtualRig moved = raised(rig, camera, raise);
      if (widestStep(moved) > widest + 1e-9) continue;
      const double gain = breaksSeen(sherds, moved, options) - now;
      if (gain > std::max(kLeastGain, best.gain + 1e-9)) best = {camera, raise, gain};
    }
  return best;
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
