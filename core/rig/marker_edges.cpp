#include "rig/marker_edges.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "batch/photograph.h"

namespace ostraka::rig {
namespace {

constexpr double kSharpReach_px = 4;  // of the band beside an edge: what a lens in focus blurs
constexpr double kMostBlurShare =
    0.35;                              // of the band: beyond, its ends are not yet black and white
constexpr double kMostSamples = 8000;  // of an edge

struct Line {
  Eigen::Vector2d point, normal;  // the normal points out of the marker
};

struct Sample {
  double along, across, value;  // along in 0..1 of the edge, across in pixels, outwards
};

// Pixels beside the edge from a to b, away from both corners by `margin` and within `reach`; of
// large pictures every second or third one in both directions, which is more than enough.
std::vector<Sample> samplesBeside(const cv::Mat& grey, const Eigen::Vector2d& a,
                                  const Eigen::Vector2d& b, const Eigen::Vector2d& normal,
                                  double margin, double reach) {
  const std::array<double, 256>& table = batch::linearLight();
  const double length = (b - a).norm();
  const Eigen::Vector2d direction = (b - a) / length;
  const Eigen::Vector2d low = a.cwiseMin(b).array() - reach, high = a.cwiseMax(b).array() + reach;
  std::vector<Sample> samples;
  if (low.minCoeff() < 0 || high.x() > grey.cols - 1 || high.y() > grey.rows - 1) return samples;
  const int stride = 1 + static_cast<int>(std::sqrt(2 * reach * length / kMostSamples));
  for (int y = static_cast<int>(low.y()); y <= static_cast<int>(high.y()); y += stride)
    for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); x += stride) {
      const Eigen::Vector2d d = Eigen::Vector2d(x, y) - a;
      const double along = d.dot(direction), across = d.dot(normal);
      if (along < margin || along > length - margin || std::abs(across) > reach) continue;
      samples.push_back({along / length, across, table[grey.at<unsigned char>(y, x)]});
    }
  return samples;
}

// Step blurred by a Gaussian: parameters are the edge's offset at both ends, the blur's sigma and
// the black and white levels at both ends (light falls off along a marker).
using Step = Eigen::Matrix<double, 7, 1>;

struct StepFit {
  Step step;
  bool good = false;
};

void addSample(const Sample& s, const Step& step, Eigen::Matrix<double, 7, 7>& hessian,
               Step& gradient) {
  const double offset = step[0] + (step[1] - step[0]) * s.along;
  const double z = (s.across - offset) / step[2];
  const double white_share = 0.5 * std::erfc(-z * M_SQRT1_2);
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2 * M_PI);
  const double black = step[3] + (step[4] - step[3]) * s.along;
  const double white = step[5] + (step[6] - step[5]) * s.along;
  const double slope = (white - black) * density / step[2];
  Step j;
  j << -slope * (1 - s.along), -slope * s.along, -slope * z, (1 - white_share) * (1 - s.along),
      (1 - white_share) * s.along, white_share * (1 - s.along), white_share * s.along;
  const double residual = s.value - (black + (white - black) * white_share);
  hessian.noalias() += j * j.transpose();
  gradient += j * residual;
}

StepFit fitStep(const std::vector<Sample>& samples, double reach) {
  StepFit fit;
  double inner = 0, outer = 0, inner_count = 0, outer_count = 0;
  for (const Sample& s : samples) {
    if (s.across < -reach / 2) inner += s.value, ++inner_count;
    if (s.across > reach / 2) outer += s.value, ++outer_count;
  }
  if (inner_count < 10 || outer_count < 10) return fit;
  inner /= inner_count;
  outer /= outer_count;
  if (outer - inner < 0.02) return fit;  // 5 of 255 steps in the dark: no edge
  fit.step << 0, 0, 0.8, inner, inner, outer, outer;
  for (int round = 0; round < 12; ++round) {
    Eigen::Matrix<double, 7, 7> hessian = Eigen::Matrix<double, 7, 7>::Zero();
    Step gradient = Step::Zero();
    for (const Sample& s : samples) addSample(s, fit.step, hessian, gradient);
    hessian.diagonal() *= 1 + 1e-6;
    Step change = hessian.ldlt().solve(gradient);
    if (!change.allFinite()) return fit;
    // A step longer than a pixel leaves the region where the linear model holds.
    change *= std::min(1.0, 1.0 / std::max(1e-12, change.head<3>().cwiseAbs().maxCoeff()));
    fit.step += change;
    fit.step[2] = std::clamp(fit.step[2], 0.25, reach);
    if (change.head<2>().cwiseAbs().maxCoeff() < 1e-4) break;
  }
  fit.good =
      std::abs(fit.step[0]) < reach && std::abs(fit.step[1]) < reach && fit.step[2] < 0.9 * reach;
  return fit;
}

// The edge from a to b within `widest` of where it is expected. The band is as narrow as a sharp
// edge allows, and wider where the picture is soft or enlarged.
StepFit fitEdge(const cv::Mat& grey, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                const Eigen::Vector2d& normal, double margin, double widest) {
  for (double reach = std::min(kSharpReach_px, widest);; reach = std::min(2 * reach, widest)) {
    const StepFit fit = fitStep(samplesBeside(grey, a, b, normal, margin, reach), reach);
    if (reach >= widest || (fit.good && fit.step[2] < kMostBlurShare * reach)) return fit;
  }
}

Eigen::Vector2d intersection(const Line& a, const Line& b) {
  Eigen::Matrix2d normals;
  normals << a.normal.transpose(), b.normal.transpose();
  return normals.inverse() * Eigen::Vector2d(a.normal.dot(a.point), b.normal.dot(b.point));
}

Eigen::Vector2d outwardNormal(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                              const Eigen::Vector2d& centre) {
  const Eigen::Vector2d d = (b - a).normalized(), normal(d.y(), -d.x());
  return normal.dot(a - centre) > 0 ? normal : Eigen::Vector2d(-normal);
}

Eigen::Vector2d middle(const Quad& q) {
  return (q[0] + q[1] + q[2] + q[3]) / 4;
}

}  // namespace

Quad toQuad(const std::vector<cv::Point2f>& corners) {
  Quad quad;
  for (std::size_t c = 0; c < 4; ++c) quad[c] = Eigen::Vector2d(corners[c].x, corners[c].y);
  return quad;
}

std::optional<Quad> refineByEdges(const cv::Mat& grey, const Quad& start, int bits) {
  std::array<Line, 4> edges;
  const Eigen::Vector2d centre = middle(start);
  Quad corners = start;
  // Twice: the second time the band lies where the first found the edge.
  for (int round = 0; round < 2; ++round) {
    for (int e = 0; e < 4; ++e) {
      const Eigen::Vector2d a = corners[e], b = corners[(e + 1) % 4];
      const double length = (b - a).norm();
      if (!(length > 12)) return std::nullopt;
      const Eigen::Vector2d normal = outwardNormal(a, b, centre);
      const Eigen::Vector2d far = (corners[(e + 2) % 4] + corners[(e + 3) % 4]) / 2;
      const double cell = normal.dot((a + b) / 2 - far) / (bits + 2);
      const double widest = 0.75 * cell;  // inside the black border and inside the paper's margin
      if (!(widest > 1.5)) return std::nullopt;
      const double margin = std::max(3.0, 0.1 * length);
      const StepFit fit = fitEdge(grey, a, b, normal, margin, widest);
      if (!fit.good) return std::nullopt;
      const Eigen::Vector2d p = a + fit.step[0] * normal, q = b + fit.step[1] * normal;
      edges[e] = {p, outwardNormal(p, q, centre)};
    }
    for (int c = 0; c < 4; ++c) corners[c] = intersection(edges[(c + 3) % 4], edges[c]);
  }
  // Contours follow whole pixels, of large soft markers less closely.
  const double most_moved = std::max(3.0, 0.03 * (start[1] - start[0]).norm());
  for (int c = 0; c < 4; ++c)
    if (!((corners[c] - start[c]).norm() < most_moved)) return std::nullopt;
  return corners;
}

Quad outwardPerPixel(const Quad& corners) {
  const Eigen::Vector2d centre = middle(corners);
  std::array<Line, 4> edges;
  for (int e = 0; e < 4; ++e) {
    const Eigen::Vector2d normal = outwardNormal(corners[e], corners[(e + 1) % 4], centre);
    edges[e] = {corners[e] + normal, normal};
  }
  Quad moved;
  for (int c = 0; c < 4; ++c) moved[c] = intersection(edges[(c + 3) % 4], edges[c]) - corners[c];
  return moved;
}

}  // namespace ostraka::rig
