#include "checks/known_scale.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "calibration/held_out.h"

namespace ostraka::checks {
namespace {

constexpr double kMinAngle_rad = 0.052;  // 3 degrees: below it a pixel moves the depth by 20
constexpr std::size_t kMinScaleCorners = 6;
constexpr double kRounding_px = 0.28867513459481287;  // 1 / sqrt(12): to whole pixels

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

const rig::PosedImage* imageNamed(const std::vector<rig::PosedImage>& images, batch::Side side,
                                  const std::string& name) {
  for (const rig::PosedImage& image : images)
    if (image.side == side && std::filesystem::path(image.file).filename() == name) return &image;
  return nullptr;
}

std::vector<SeenIn> raysTo(const std::vector<rig::PosedImage>& images, batch::Side side,
                           const std::vector<batch::KnownLength::Mark>& marks) {
  std::vector<SeenIn> rays;
  for (const batch::KnownLength::Mark& mark : marks)
    if (const rig::PosedImage* image = imageNamed(images, side, mark.file))
      rays.push_back({image, mark.pixel});
  return rays;
}

// A marked end in space, and how it was seen.
struct MarkedEnd {
  Eigen::Vector3d point;
  Eigen::Matrix3d information;  // for marks with a standard deviation of 1 px, 1 / mm^2
  double squares_px2 = 0;       // of what is left between the marks and the point
  int freedom = 0;              // marks' coordinates less the point's three
};

// Two steps of Gauss-Newton from the rays' nearest point: the rays differ in length.
std::optional<MarkedEnd> locate(const std::vector<SeenIn>& rays) {
  constexpr double kStep_mm = 1e-3;
  const std::optional<Eigen::Vector3d> start = triangulate(rays);
  if (!start) return std::nullopt;
  MarkedEnd end{*start, {}, 0, 2 * static_cast<int>(rays.size()) - 3};
  for (int round = 0; round < 3; ++round) {
    end.information.setZero();
    end.squares_px2 = 0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const SeenIn& ray : rays) {
      const Eigen::Vector2d left = ray.pixel - ray.image->project(end.point);
      Eigen::Matrix<double, 2, 3> slope;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d step = kStep_mm * Eigen::Vector3d::Unit(k);
        slope.col(k) =
            (ray.image->project(end.point + step) - ray.image->project(end.point - step)) /
            (2 * kStep_mm);
      }
      end.information += slope.transpose() * slope;
      gradient += slope.transpose() * left;
      end.squares_px2 += left.squaredNorm();
    }
    if (round < 2) end.point += end.information.ldlt().solve(gradient);
  }
  return end;
}

}  // namespace

bool CheckedLength::contradicts() const {
  return std::abs(found_mm - true_mm) > 3 * sd_mm &&
         std::abs(error()) > calibration::kMostScaleError;
}

std::vector<std::optional<CheckedLength>> checkLengths(
    const std::vector<rig::PosedImage>& images, const std::vector<batch::KnownLength>& lengths) {
  std::vector<std::array<std::optional<MarkedEnd>, 2>> found;
  double squares = 0;
  int freedom = 0;
  for (const batch::KnownLength& known : lengths) {
    found.push_back({locate(raysTo(images, known.side, known.ends[0])),
                     locate(raysTo(images, known.side, known.ends[1]))});
    for (const std::optional<MarkedEnd>& end : found.back())
      if (end) squares += end->squares_px2, freedom += end->freedom;
  }
  const double mark_sd_px = std::max(kRounding_px, freedom > 0 ? std::sqrt(squares / freedom) : 0);
  std::vector<std::optional<CheckedLength>> checked(lengths.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const auto& [a, b] = found[i];
    if (!a || !b) continue;
    const Eigen::Vector3d along = (a->point - b->point).normalized();
    const double variance = along.dot(a->information.ldlt().solve(along)) +
                            along.dot(b->information.ldlt().solve(along));
    checked[i] = CheckedLength{lengths[i].side, lengths[i].length_mm, (a->point - b->point).norm(),
                               mark_sd_px * std::sqrt(variance)};
  }
  return checked;
}

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

std::optional<KnownScale> scaleFromLengths(const std::vector<rig::PosedImage>& images,
                                           const std::vector<batch::KnownLength>& lengths) {
  std::vector<double> ratios;
  for (const batch::KnownLength& known : lengths) {
    std::array<std::optional<Eigen::Vector3d>, 2> ends;
    for (int e = 0; e < 2; ++e) ends[e] = triangulate(raysTo(images, known.side, known.ends[e]));
    if (!ends[0] || !ends[1]) continue;
    const double found = (*ends[0] - *ends[1]).norm();
    if (found > 0) ratios.push_back(known.length_mm / found);
  }
  return middleOf(std::move(ratios));
}

std::optional<KnownScale> scaleFromBoard(const std::vector<rig::PosedImage>& images,
                                         const std::vector<calibration::TargetView>& views) {
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

}  // namespace ostraka::checks
