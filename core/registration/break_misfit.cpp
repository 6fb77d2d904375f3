#include "registration/break_misfit.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

namespace ostraka::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;

constexpr float kReach_mm = 1.0f;  // fractures of near-duplicates differ by half of it
constexpr float kMinCos = 0.7071f;
constexpr float kPatch_mm = 1.5f;  // the noise of scans is alike over 1 mm, that of stereo over 2
constexpr float kAlike_mm = 3.0f;  // stereo errs alike over 2 to 4 mm; beyond, breaks are too short
constexpr float kSameBreak = 0.5f;
constexpr std::size_t kFewest = 5;  // pairs that make a mean

// The distances of the back's points from the front's nearest, along the mean of their normals.
struct Gaps {
  std::vector<Vector3f> points, normals;  // frame of the back
  std::vector<double> distances, rises;   // rise: the normal's part towards the viewer
};

Gaps gapsOf(const Strip& front, const Strip& back, const Eigen::Isometry3d& front_from_back) {
  const Eigen::Matrix3f turn = front_from_back.linear().cast<float>();
  const Vector3f shift = front_from_back.translation().cast<float>();
  const Vector3f up = front.up.cast<float>();
  Gaps gaps;
  for (std::size_t i = 0; i < back.fine.points.size(); ++i) {
    const Vector3f q = turn * back.fine.points[i] + shift;
    const Neighbour near = front.fine.tree.nearest(q, kReach_mm);
    if (near.index < 0) continue;
    const auto k = static_cast<std::size_t>(near.index);
    const Vector3f m = turn * back.fine.normals[i];
    if (m.dot(front.fine.normals[k]) < kMinCos) continue;
    const Vector3f n = (m + front.fine.normals[k]).normalized();
    gaps.points.push_back(back.fine.points[i]);
    gaps.normals.push_back(back.fine.normals[i]);
    gaps.distances.push_back(static_cast<double>(n.dot(q - front.fine.points[k])));
    gaps.rises.push_back(static_cast<double>(n.dot(up)));
  }
  return gaps;
}

void takeOutFatness(Gaps& gaps) {
  Eigen::Matrix2d square = 1e-9 * Eigen::Matrix2d::Identity();
  Vector2d right = Vector2d::Zero();
  for (std::size_t i = 0; i < gaps.distances.size(); ++i) {
    const Vector2d row(1, gaps.rises[i]);
    square += row * row.transpose();
    right += gaps.distances[i] * row;
  }
  const Vector2d fat = square.ldlt().solve(right);
  for (std::size_t i = 0; i < gaps.distances.size(); ++i)
    gaps.distances[i] -= fat.x() + fat.y() * gaps.rises[i];
}

// Mean distances over patches around the thinned points.
struct Patches {
  double rms = 0, pairs = 0;  // of the means; pairs to a patch
  double count = 0;
};

Patches patchesOf(const StripLevel& centres, const Gaps& gaps, const KdTree& tree, float radius) {
  Patches patches;
  std::vector<Neighbour> found;
  for (std::size_t c = 0; c < centres.points.size(); ++c) {
    tree.within(centres.points[c], radius, found);
    double sum = 0;
    std::size_t count = 0;
    for (const Neighbour& n : found) {
      const auto i = static_cast<std::size_t>(n.index);
      if (gaps.normals[i].dot(centres.normals[c]) < kSameBreak) continue;
      sum += gaps.distances[i];
      ++count;
    }
    if (count < kFewest) continue;
    const double mean = sum / static_cast<double>(count);
    patches.rms += mean * mean;
    patches.pairs += static_cast<double>(count);
    ++patches.count;
  }
  patches.rms = std::sqrt(patches.rms / std::max(1.0, patches.count));
  patches.pairs /= std::max(1.0, patches.count);
  return patches;
}

}  // namespace

BreakMisfit breakMisfit(const Strip& front, const Strip& back,
                        const Eigen::Isometry3d& front_from_back) {
  Gaps gaps = gapsOf(front, back, front_from_back);
  takeOutFatness(gaps);
  const KdTree tree(gaps.points);
  const Patches patches = patchesOf(back.coarse, gaps, tree, kPatch_mm);
  if (patches.count == 0) return {};
  BreakMisfit misfit;
  misfit.rms_mm = patches.rms;
  // Centres lie 1.2 mm apart, about one to a square of that edge, and share their patches.
  const double per_patch = M_PI * kPatch_mm * kPatch_mm / (1.2 * 1.2);
  misfit.places = std::max(1.0, patches.count / per_patch);
  // The mean of n white distances has an n-th of their variance.
  const Patches wide = patchesOf(back.coarse, gaps, tree, kAlike_mm);
  double squares = 1e-12;
  for (const double d : gaps.distances) squares += d * d;
  const double point = squares / static_cast<double>(gaps.distances.size());
  misfit.alike = std::max(1.0, wide.pairs * wide.rms * wide.rms / point);
  return misfit;
}

}  // namespace ostraka::registration
