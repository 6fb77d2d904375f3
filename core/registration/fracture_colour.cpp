#include "registration/fracture_colour.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/median.h"

namespace ostraka::registration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kOneFracture = 0.5f;      // normals of the strip's points are 15 degrees noisy
constexpr double kLongestDetail = 6;      // radii; beyond, light and soil differ, not grains
constexpr std::size_t kFewestPoints = 6;  // of a plane of three unknowns
constexpr double kOutlier = 4;            // SDs: highlights and shadows of neighbours
constexpr double kLeastSteps = 0.5;       // two SD of a rounded value
constexpr int kFewestPairs = 200;
constexpr int kFewestPatches = 12;  // to estimate a scatter in six dimensions

// Lightness and two colour differences, as logarithms: exposure and white balance become constants.
Vector3f channelsOf(const Color& colour) {
  Vector3f l;
  for (int c = 0; c < 3; ++c)
    l[c] = std::log(std::max(4.0f, static_cast<float>(colour[static_cast<std::size_t>(c)])));
  return {l.sum() / 3, l[0] - 0.5f * (l[1] + l[2]), l[1] - l[2]};
}

// The detail around a point as a plane, by Gaussian weights.
ColourDetail planeAround(std::span<const Vector3f> points, std::span<const Vector3f> detail,
                         const Vector3f& p, const Vector3f& n, std::span<const std::size_t> near,
                         double radius_mm) {
  const Vector3f u = n.unitOrthogonal(), v = n.cross(u);
  Eigen::Matrix3f square = 1e-6f * Eigen::Matrix3f::Identity(), right = Eigen::Matrix3f::Zero();
  const float scale = static_cast<float>(-0.5 / (radius_mm * radius_mm));
  for (const std::size_t k : near) {
    const Vector3f d = points[k] - p;
    const Vector3f row(1, d.dot(u), d.dot(v));
    const float w = std::exp(scale * d.squaredNorm());
    square += w * row * row.transpose();
    right += w * row * detail[k].transpose();
  }
  const Eigen::Matrix3f plane = square.ldlt().solve(right);  // a column per channel
  ColourDetail result;
  result.value = plane.row(0).transpose();
  result.slope =
      plane.row(1).transpose() * u.transpose() + plane.row(2).transpose() * v.transpose();
  return result;
}

// step: of a value of 8 bits, as a logarithm. Detail that is finer says where values were rounded.
void normaliseChannels(std::vector<ColourDetail>& detail, double step) {
  for (int c = 0; c < 3; ++c) {
    std::vector<double> sizes;
    for (const ColourDetail& d : detail) sizes.push_back(std::abs(static_cast<double>(d.value[c])));
    const double sd = 1.4826 * medianOf(sizes);
    const float scale = sd > kLeastSteps * step ? static_cast<float>(1 / sd) : 0.0f;
    for (ColourDetail& d : detail) {
      d.value[c] *= scale;
      d.slope.row(c) *= scale;
    }
  }
}

struct ColourPair {
  std::size_t front, back;
  Vector3d q;                          // the back's point in the front's frame
  Eigen::Matrix<double, 3, 3> g;       // row c: gradient of channel c along the surface
  Vector3d misfit, at_front, at_back;  // per channel
  std::array<int, 3> patch;            // cube of the back's frame
};

std::vector<ColourPair> pairsOf(const StripLevel& front, const StripLevel& back,
                                const Eigen::Isometry3d& front_from_back,
                                const ColourOptions& options) {
  std::vector<ColourPair> pairs;
  const Matrix3d turn = front_from_back.linear();
  for (std::size_t i = 0; i < back.points.size(); ++i) {
    const Vector3d q = front_from_back * back.points[i].cast<double>();
    const Neighbour near =
        front.tree.nearest(q.cast<float>(), static_cast<float>(options.reach_mm));
    if (near.index < 0) continue;
    const auto k = static_cast<std::size_t>(near.index);
    const Vector3d n_front = front.normals[k].cast<double>();
    const Vector3d n_back = turn * back.normals[i].cast<double>();
    if (n_front.dot(n_back) < options.min_cos) continue;
    const Vector3d n = (n_front + n_back).normalized();
    const Matrix3d along = Matrix3d::Identity() - n * n.transpose();
    const Matrix3d g_front = front.colours[k].slope.cast<double>();
    const Matrix3d g_back = back.colours[i].slope.cast<double>() * turn.transpose();
    ColourPair pair;
    pair.front = k;
    pair.back = i;
    pair.q = q;
    pair.g = 0.5 * (g_front + g_back) * along;
    const Vector3d offset = q - front.points[k].cast<double>();
    pair.at_front = front.colours[k].value.cast<double>() + pair.g * offset;
    pair.at_back = back.colours[i].value.cast<double>();
    pair.misfit = pair.at_front - pair.at_back;
    for (int c = 0; c < 3; ++c)
      pair.patch[static_cast<std::size_t>(c)] =
          static_cast<int>(std::floor(static_cast<double>(back.points[i][c]) / options.patch_mm));
    pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end(), [](const ColourPair& a, const ColourPair& b) {
    return std::tie(a.patch, a.back) < std::tie(b.patch, b.back);
  });
  return pairs;
}

double correlationOf(std::span<const ColourPair> pairs, int channel) {
  double ff = 1e-12, bb = 1e-12, fb = 0;
  for (const ColourPair& pair : pairs) {
    const double f = std::clamp(pair.at_front[channel], -kOutlier, kOutlier);
    const double b = std::clamp(pair.at_back[channel], -kOutlier, kOutlier);
    ff += f * f;
    bb += b * b;
    fb += f * b;
  }
  return fb / std::sqrt(ff * bb);
}

// Of one channel. The scatter of the gradient is measured patch by patch: pairs within a patch err
// together, by light that differs and by how far the smoothing reaches.
Evidence channelEvidence(std::span<const ColourPair> pairs, int channel, double correlation,
                         const Vector3d& pivot) {
  std::vector<double> sizes;
  for (const ColourPair& pair : pairs) sizes.push_back(std::abs(pair.misfit[channel]));
  const double sigma = std::max(0.05, 1.4826 * medianOf(sizes));
  // Of two noisy slopes only this share is the clay's own.
  const double shared = 2 * correlation / (1 + correlation);
  Evidence all;
  Matrix6 scatter = Matrix6::Zero();
  Vector6 patch = Vector6::Zero();
  int patches = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double r = pairs[i].misfit[channel] / sigma;
    const double free = 1 - r * r / (kOutlier * kOutlier);
    if (free > 0) {
      const Vector3d g = pairs[i].g.row(channel).transpose() * (shared / sigma);
      const Vector6 row = rowOf(pairs[i].q, g, pivot);
      all.add(r, row, free * free);
      patch += free * free * r * row;
    }
    if (i + 1 < pairs.size() && pairs[i].patch == pairs[i + 1].patch) continue;
    scatter += patch * patch.transpose();
    patch.setZero();
    ++patches;
  }
  if (patches < kFewestPatches) return {};
  const Matrix6 claimed = all.information + 1e-6 * Matrix6::Identity();
  const double alike = std::max(1.0, (claimed.inverse() * scatter).trace() / 6);
  all.information /= alike;
  all.gradient /= alike;
  all.cost /= alike;
  return all;
}

// Colour differences are noisier than lightness. Where they correlate better all the same, the
// lightness is mostly the relief's shading, which light from above inverts when a sherd is turned.
int firstChannel(const ColourFit& fit) {
  return fit.correlation[0] < fit.correlation[1] ? 1 : 0;
}

ColourFit correlated(std::span<const ColourPair> pairs) {
  ColourFit fit;
  fit.pairs = static_cast<int>(pairs.size());
  if (fit.pairs < kFewestPairs) return fit;
  for (int c = 0; c < 3; ++c)
    fit.correlation[static_cast<std::size_t>(c)] = correlationOf(pairs, c);
  int patches = 1;
  for (std::size_t i = 1; i < pairs.size(); ++i)
    patches += pairs[i].patch == pairs[i - 1].patch ? 0 : 1;
  for (int c = firstChannel(fit); c < 3; ++c) {
    const double r = std::clamp(fit.correlation[static_cast<std::size_t>(c)], 0.0, 0.99);
    fit.log_likelihood -= 0.5 * patches * std::log(1 - r * r);
  }
  return fit;
}

// A common displacement d moves the detail as the pose does: it is marginalised.
void takeOutDisplacement(double sd_mm, Evidence& evidence) {
  const Matrix3d own =
      evidence.information.bottomRightCorner<3, 3>() + Matrix3d::Identity() / (sd_mm * sd_mm);
  const Eigen::Matrix<double, 6, 3> gain = evidence.information.rightCols<3>() * own.inverse();
  const Vector3d slope = evidence.gradient.tail<3>();
  const Eigen::Matrix<double, 3, 6> with = evidence.information.bottomRows<3>();
  evidence.cost -= 0.5 * slope.dot(own.inverse() * slope);
  evidence.information -= gain * with;
  evidence.gradient -= gain * slope;
}

}  // namespace

std::vector<ColourDetail> colourDetail(std::span<const Vector3f> points,
                                       std::span<const Vector3f> normals,
                                       std::span<const Color> colours, const KdTree& tree,
                                       double radius_mm) {
  if (colours.size() != points.size()) return {};
  std::vector<Vector3f> detail(points.size());
  std::vector<double> lightness;
  for (const Color& colour : colours)
    lightness.push_back(static_cast<double>(channelsOf(colour)[0]));
  std::vector<std::vector<std::size_t>> near(points.size());
  std::vector<Neighbour> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    tree.within(points[i], static_cast<float>(kLongestDetail * radius_mm), found);
    Vector3f sum = Vector3f::Zero();
    float count = 0;
    for (const Neighbour& neighbour : found) {
      const auto k = static_cast<std::size_t>(neighbour.index);
      if (normals[k].dot(normals[i]) < kOneFracture) continue;
      sum += channelsOf(colours[k]);
      ++count;
      if (static_cast<double>(neighbour.squared_distance) < 4 * radius_mm * radius_mm)
        near[i].push_back(k);
    }
    detail[i] = channelsOf(colours[i]) - sum / std::max(1.0f, count);
  }
  std::vector<ColourDetail> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (near[i].size() >= kFewestPoints)
      result[i] = planeAround(points, detail, points[i], normals[i], near[i], radius_mm);
  normaliseChannels(result, std::exp(-medianOf(lightness)));
  return result;
}

ColourFit correlateColours(const StripLevel& front, const StripLevel& back,
                           const Eigen::Isometry3d& front_from_back, const ColourOptions& options) {
  if (front.colours.empty() || back.colours.empty()) return {};
  return correlated(pairsOf(front, back, front_from_back, options));
}

ColourFit fitColours(const StripLevel& front, const StripLevel& back,
                     const Eigen::Isometry3d& front_from_back, const Vector3d& pivot,
                     const ColourOptions& options) {
  if (front.colours.empty() || back.colours.empty()) return {};
  const std::vector<ColourPair> pairs = pairsOf(front, back, front_from_back, options);
  ColourFit fit = correlated(pairs);
  if (fit.pairs < kFewestPairs) return fit;
  for (int c = firstChannel(fit); c < 3; ++c) {
    const double correlation = fit.correlation[static_cast<std::size_t>(c)];
    if (correlation > 0.05) fit.evidence += channelEvidence(pairs, c, correlation, pivot);
  }
  takeOutDisplacement(options.displacement_mm, fit.evidence);
  return fit;
}

}  // namespace ostraka::registration
