#include "baselines/fast_global_registration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace ostraka::baselines {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

struct Match {
  int front = -1, back = -1;
};

// The most alike of the others for each; empty: stopped.
std::vector<int> nearestFeatures(const std::vector<Feature>& asked,
                                 const std::vector<Feature>& others, const std::stop_token& stop) {
  std::vector<int> nearest;
  for (const Feature& feature : asked) {
    if (stop.stop_requested()) return {};
    const Eigen::Map<const Eigen::Array<float, 33, 1>> a(feature.data());
    float least = std::numeric_limits<float>::infinity();
    nearest.push_back(-1);
    for (std::size_t j = 0; j < others.size(); ++j) {
      const Eigen::Map<const Eigen::Array<float, 33, 1>> b(others[j].data());
      const float square = (a - b).square().sum();
      if (square >= least) continue;
      least = square;
      nearest.back() = static_cast<int>(j);
    }
  }
  return nearest;
}

Vector3d at(const PointCloud& cloud, int index) {
  return cloud.points[static_cast<std::size_t>(index)].cast<double>();
}

// The paper's tuple test: of three pairs drawn at random all are kept when their triangles on both
// sides have edges alike.
std::vector<Match> likeTriangles(const std::vector<Match>& matches, const PointCloud& front,
                                 const PointCloud& back, const FastGlobalOptions& options) {
  std::vector<Match> kept;
  std::mt19937 random(1);
  const auto draws =
      static_cast<std::int64_t>(options.draws_per_pair) * static_cast<std::int64_t>(matches.size());
  int tuples = 0;
  for (std::int64_t draw = 0; draw < draws && tuples < options.max_tuples; ++draw) {
    Match three[3];
    for (Match& match : three) match = matches[random() % matches.size()];
    const auto alike = [&](const Match& a, const Match& b) {
      const double f = (at(front, a.front) - at(front, b.front)).norm();
      const double g = (at(back, a.back) - at(back, b.back)).norm();
      return f > options.edge_similarity * g && g > options.edge_similarity * f;
    };
    if (!alike(three[0], three[1]) || !alike(three[1], three[2]) || !alike(three[2], three[0]))
      continue;
    kept.insert(kept.end(), std::begin(three), std::end(three));
    ++tuples;
  }
  return kept;
}

double squaredDiameter(const PointCloud& cloud) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : cloud.points) box.extend(p);
  return box.sizes().cast<double>().squaredNorm();
}

// One Gauss-Newton step of equation 8 for the weights that equation 6 gives at this pose. Turns are
// about the pairs' middle on the front.
Isometry3d improved(const Isometry3d& pose, const std::vector<Match>& matches,
                    const PointCloud& front, const PointCloud& back, const Vector3d& middle,
                    double mu) {
  Matrix6d information = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  for (const Match& match : matches) {
    const Vector3d q = pose * at(back, match.back);
    const Vector3d off = q - at(front, match.front);
    const double l = mu / (mu + off.squaredNorm());
    Eigen::Matrix<double, 3, 6> rows;
    const Vector3d arm = q - middle;
    rows << 0, arm.z(), -arm.y(), 1, 0, 0, -arm.z(), 0, arm.x(), 0, 1, 0, arm.y(), -arm.x(), 0, 0,
        0, 1;
    information += l * l * rows.transpose() * rows;
    gradient += l * l * rows.transpose() * off;
  }
  information.diagonal().array() += 1e-9;
  const Vector6d x = -information.ldlt().solve(gradient);
  const Vector3d turn = x.head<3>();
  const double angle = turn.norm();
  Isometry3d change = Isometry3d::Identity();
  change.translate(middle + Vector3d(x.tail<3>()));
  if (angle > 1e-15) change.rotate(Eigen::AngleAxisd(angle, turn / angle));
  change.translate(-middle);
  Isometry3d better = change * pose;
  better.linear() = Eigen::Quaterniond(better.linear()).normalized().toRotationMatrix();
  return better;
}

}  // namespace

Result<Isometry3d> fastGlobalRegistration(const PointCloud& front_cloud,
                                          const PointCloud& back_cloud,
                                          const FastGlobalOptions& options, std::stop_token stop) {
  const PointCloud front = thinned(front_cloud, options.spacing_mm);
  const PointCloud back = thinned(back_cloud, options.spacing_mm);
  if (const auto ok = enoughPoints(front, back); !ok) return ok.error();
  const std::vector<Feature> front_features = pointFeatures(front, options.feature_radius_mm);
  const std::vector<Feature> back_features = pointFeatures(back, options.feature_radius_mm);
  const std::vector<int> of_front = nearestFeatures(front_features, back_features, stop);
  const std::vector<int> of_back = nearestFeatures(back_features, front_features, stop);
  if (stop.stop_requested()) return Error::cancelled();
  std::vector<Match> matches;
  for (int f = 0; f < static_cast<int>(of_front.size()); ++f) {
    const int b = of_front[static_cast<std::size_t>(f)];
    if (b >= 0 && of_back[static_cast<std::size_t>(b)] == f) matches.push_back({f, b});
  }
  if (static_cast<int>(matches.size()) < 3) return notConverged();
  matches = likeTriangles(matches, front, back, options);
  if (static_cast<int>(matches.size()) < options.fewest_pairs) return notConverged();

  Vector3d front_middle = Vector3d::Zero(), back_middle = Vector3d::Zero();
  for (const Match& match : matches) {
    front_middle += at(front, match.front) / static_cast<double>(matches.size());
    back_middle += at(back, match.back) / static_cast<double>(matches.size());
  }
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = front_middle - back_middle;
  const double last = options.inlier_mm * options.inlier_mm;
  for (double mu = std::max(squaredDiameter(front), squaredDiameter(back)); mu > last;
       mu /= options.division) {
    if (stop.stop_requested()) return Error::cancelled();
    for (int round = 0; round < 4; ++round)
      pose = improved(pose, matches, front, back, front_middle, mu);
  }
  const auto meet = std::count_if(matches.begin(), matches.end(), [&](const Match& match) {
    return (pose * at(back, match.back) - at(front, match.front)).squaredNorm() < last;
  });
  if (meet < options.fewest_pairs) return notConverged();
  return pose;
}

}  // namespace ostraka::baselines
