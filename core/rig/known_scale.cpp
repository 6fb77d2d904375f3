#include "rig/known_scale.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace ostraka::rig {
namespace {

constexpr double kMinAngle_rad = 0.052;  // 3 degrees: below it a pixel moves the depth by 20
constexpr std::size_t kMinScaleCorners = 6;

std::optional<KnownScale> middleOf(std::vector<double> ratios) {
  if (ratios.empty()) return std::nullopt;
  std::sort(ratios.begin(), ratios.end());
  const auto quantile = [&](double q) {
    return ratios[static_cast<std::size_t>(q * static_cast<double>(ratios.size() - 1) + 0.5)];
  };
  const double middle = quantile(0.5);
  return KnownScale{middle, (quantile(0.84) - quantile(0.16)) / 2 / middle,
                    static_cast<int>(ratios.size())};
}

const PosedImage* imageNamed(const std::vector<PosedImage>& images, batch::Side side,
                             const std::string& name) {
  for (const PosedImage& image : images)
    if (image.side == side && std::filesystem::path(image.file).filename() == name) return &image;
  return nullptr;
}

}  // namespace

std::optional<Eigen::Vector3d> triangulate(const std::vector<SeenIn>& rays) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> directions;
  double widest = 0;
  for (const SeenIn& ray : rays) {
    const Eigen::Vector2d at = ray.image->intrinsics.unproject(ray.pixel);
    const Eigen::Vector3d direction =
        (ray.image->camera_from_plate.linear().transpose() * at.homogeneous()).normalized();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
    a += across;
    b += across * ray.image->centre();
    for (const Eigen::Vector3d& other : directions)
      widest = std::max(widest, direction.cross(other).norm());
    directions.push_back(direction);
  }
  if (widest < std::sin(kMinAngle_rad)) return std::nullopt;
  return Eigen::Vector3d(a.ldlt().solve(b));
}

std::optional<KnownScale> scaleFromLengths(const std::vector<PosedImage>& images,
                                           const std::vector<batch::KnownLength>& lengths) {
  std::vector<double> ratios;
  for (const batch::KnownLength& known : lengths) {
    std::array<std::optional<Eigen::Vector3d>, 2> ends;
    for (int e = 0; e < 2; ++e) {
      std::vector<SeenIn> rays;
      for (const batch::KnownLength::Mark& mark : known.ends[e])
        if (const PosedImage* image = imageNamed(images, known.side, mark.file))
          rays.push_back({image, mark.pixel});
      ends[e] = triangulate(rays);
    }
    if (!ends[0] || !ends[1]) continue;
    const double found = (*ends[0] - *ends[1]).norm();
    if (found > 0) ratios.push_back(known.length_mm / found);
  }
  return middleOf(std::move(ratios));
}

std::optional<KnownScale> scaleFromBoard(const std::vector<PosedImage>& images,
                                         const std::vector<TargetView>& views) {
  // A corner is known by its place on the board, in hundredths of a millimetre.
  std::map<std::array<long, 2>, std::vector<SeenIn>> seen;
  for (std::size_t i = 0; i < images.size() && i < views.size(); ++i)
    for (std::size_t k = 0; k < views[i].points.size(); ++k) {
      const Eigen::Vector3d& at = views[i].points[k];
      seen[{std::lround(100 * at.x()), std::lround(100 * at.y())}].push_back(
          {&images[i], views[i].pixels[k]});
    }
  std::vector<Eigen::Vector2d> true_mm;
  std::vector<Eigen::Vector3d> found;
  for (const auto& [corner, rays] : seen)
    if (const std::optional<Eigen::Vector3d> point = triangulate(rays)) {
      true_mm.emplace_back(static_cast<double>(corner[0]) / 100,
                           static_cast<double>(corner[1]) / 100);
      found.push_back(*point);
    }
  if (found.size() < kMinScaleCorners) return std::nullopt;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double length = (found[i] - found[j]).norm(); length > 0)
        ratios.push_back((true_mm[i] - true_mm[j]).norm() / length);
  return middleOf(std::move(ratios));
}

}  // namespace ostraka::rig
