#include "rendering/sheet.h"

#include <algorithm>
#include <cmath>
#include <opencv2/aruco/charuco.hpp>

namespace ostraka::rendering {
namespace {

constexpr double kFree = 4;  // mm that nothing is printed on beside markers
constexpr float kCell = 2;   // mm

// Half of what lies within the markers, clear of them.
Eigen::Vector2f blankWithin(const batch::Plate& plate) {
  const Eigen::Vector2d inner = plate.markers.front().corners[2].head<2>();
  return (inner.cwiseAbs() - Eigen::Vector2d::Constant(kFree)).cast<float>();
}

}  // namespace

SheetSurface::SheetSurface(rig::SheetSize size, double bend_mm, vessels::Random& random)
    : plate_(rig::sheetPlate(size)),
      half_(plate_.sheet->max().cast<float>()),
      blank_(blankWithin(plate_)),
      paper_(static_cast<float>(random.uniform(0.74, 0.82))),
      ink_(static_cast<float>(random.uniform(0.025, 0.06))),
      spread_mm_(static_cast<float>(random.uniform(0, 0.06))) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100);
  columns_ = static_cast<int>(std::ceil(2 * half_.x() / kCell)) + 1;
  cells_.assign(static_cast<std::size_t>(columns_) *
                    static_cast<std::size_t>(std::ceil(2 * half_.y() / kCell) + 1),
                0);
  for (const batch::Marker& marker : plate_.markers) {
    cv::Mat picture;
    cv::aruco::drawMarker(dictionary, marker.id, 7, picture, 1);
    std::array<std::uint8_t, 49> bits;
    for (int i = 0; i < 49; ++i) bits[i] = picture.at<std::uint8_t>(i / 7, i % 7) > 127;
    bits_.push_back(bits);
    const Eigen::Vector2f low = marker.corners[3].head<2>().cast<float>() + half_,
                          high = marker.corners[1].head<2>().cast<float>() + half_;
    for (int y = static_cast<int>(low.y() / kCell); y <= static_cast<int>(high.y() / kCell); ++y)
      for (int x = static_cast<int>(low.x() / kCell); x <= static_cast<int>(high.x() / kCell); ++x)
        cells_[static_cast<std::size_t>(y) * columns_ + x] = marker.id + 1;
  }
  if (bend_mm <= 0) return;
  for (float& b : bend_) b = static_cast<float>(random.normal());
  bend_[0] *= 0.3f;
  bend_[1] *= 0.3f;
  float low = 1e9f, high = -1e9f;
  const auto over = [&](const auto& body) {
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j <= 40; ++j)
        body(height(Eigen::Vector2f((static_cast<float>(i) / 20 - 1) * half_.x(),
                                    (static_cast<float>(j) / 20 - 1) * half_.y())));
  };
  over([&](float z) {
    low = std::min(low, z);
    high = std::max(high, z);
  });
  for (float& b : bend_) b *= static_cast<float>(bend_mm) / (high - low);
  lift_ = -low * static_cast<float>(bend_mm) / (high - low);
}

float SheetSurface::distance(const Eigen::Vector2f& p) const {
  const Eigen::Vector2f out = p.cwiseAbs() - half_;
  return out.maxCoeff() < 0 ? out.maxCoeff() : out.cwiseMax(0.f).norm();
}

// Toner ends a little inside of where it was meant to: paper shines in.
bool SheetSurface::ink(const Eigen::Vector2f& p) const {
  const Eigen::Vector2f cell = (p + half_) / kCell;
  const int found = cells_[static_cast<std::size_t>(static_cast<int>(cell.y())) * columns_ +
                           static_cast<std::size_t>(static_cast<int>(cell.x()))];
  if (found == 0) return false;
  const auto& corner = plate_.markers[static_cast<std::size_t>(found - 1)].corners[0];
  const auto& bits = bits_[static_cast<std::size_t>(found - 1)];
  constexpr auto module = static_cast<float>(rig::kSheetMarker_mm / 7);
  for (const float dx : {-spread_mm_, spread_mm_})
    for (const float dy : {-spread_mm_, spread_mm_}) {
      const float u = (p.x() + dx - static_cast<float>(corner.x())) / module,
                  v = (static_cast<float>(corner.y()) - p.y() - dy) / module;
      if (u < 0 || v < 0 || u >= 7 || v >= 7) return false;
      if (bits[static_cast<std::size_t>(static_cast<int>(v) * 7 + static_cast<int>(u))])
        return false;
    }
  return true;
}

Eigen::Vector3f SheetSurface::albedo(const Eigen::Vector2f& p) const {
  if (!blank(p) && ink(p)) return Eigen::Vector3f(1.f, 0.98f, 0.97f) * ink_;
  return Eigen::Vector3f(0.985f, 0.995f, 1.f) * paper_;
}

Eigen::Vector3f SheetSurface::meanAlbedo(const Eigen::Vector2f& p) const {
  // Two thirds of the border are markers, half of those are black.
  return Eigen::Vector3f::Constant(blank(p) ? paper_ : 0.67f * paper_);
}

float SheetSurface::height(const Eigen::Vector2f& p) const {
  const Eigen::Vector2f q = p.cwiseQuotient(half_);
  return lift_ + bend_[0] * q.x() + bend_[1] * q.y() + bend_[2] * q.x() * q.x() +
         bend_[3] * q.x() * q.y() + bend_[4] * q.y() * q.y();
}

Eigen::Vector2f SheetSurface::slope(const Eigen::Vector2f& p) const {
  const Eigen::Vector2f q = p.cwiseQuotient(half_);
  return Eigen::Vector2f(bend_[0] + 2 * bend_[2] * q.x() + bend_[3] * q.y(),
                         bend_[1] + bend_[3] * q.x() + 2 * bend_[4] * q.y())
      .cwiseQuotient(half_);
}

Eigen::Isometry3d SheetSurface::tableFromPlate() const {
  const Eigen::Vector2d slope = this->slope(Eigen::Vector2f::Zero()).cast<double>();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                      Eigen::Vector3d(-slope.x(), -slope.y(), 1))
                       .toRotationMatrix();
  frame.translation().z() = height(Eigen::Vector2f::Zero());
  return frame;
}

Eigen::Isometry3d restingOn(const SheetSurface& sheet, const Eigen::Isometry3d& pose,
                            const std::vector<Eigen::Vector3f>& vertices_model) {
  const Eigen::Vector2f middle = pose.translation().head<2>().cast<float>();
  const Eigen::Vector2f slope = sheet.slope(middle);
  Eigen::Isometry3d out = pose;
  out.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                    Eigen::Vector3d(-slope.x(), -slope.y(), 1))
                     .toRotationMatrix() *
                 pose.linear();
  float gap = 1e9f;
  for (const Eigen::Vector3f& v : vertices_model) {
    const Eigen::Vector3f p = (out * v.cast<double>()).cast<float>();
    gap = std::min(gap, p.z() - sheet.height(p.head<2>()));
  }
  out.translation().z() -= gap;
  return out;
}

}  // namespace ostraka::rendering
