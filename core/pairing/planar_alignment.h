#pragma once
#include <Eigen/Geometry>
#include <vector>

namespace ostraka::pairing {

/// A closed line with a raster of nearest points around it, for fast distances.
class OutlineField {
 public:
  /// closed: counter-clockwise, equal steps, mm; at least 8 points.
  explicit OutlineField(std::vector<Eigen::Vector2d> closed);

  struct Foot {
    Eigen::Vector2d point;   ///< nearest point of the line
    Eigen::Vector2d normal;  ///< unit, outward, over about a millimetre of the line
    double distance = 0;     ///< mm, to the line
    int index = 0;           ///< of the line's point at or before the foot
  };
  Foot nearest(const Eigen::Vector2d& q) const;
  /// Distance to the nearest point of the line, to about half a cell: for coarse search only.
  double roughDistance(const Eigen::Vector2d& q) const;

  const std::vector<Eigen::Vector2d>& line() const { return line_; }
  const Eigen::Vector2d& centroid() const { return centroid_; }  ///< of the area
  double perimeter() const { return perimeter_; }

 private:
  std::size_t cellOf(const Eigen::Vector2d& q) const;
  void fillRaster();

  std::vector<Eigen::Vector2d> line_, normals_;
  Eigen::Vector2d centroid_, low_;
  double perimeter_ = 0, cell_mm_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<int> nearest_;
};

/// front = scale * R(angle) * back + shift, in the two contours' planes, the back mirrored already.
struct PlanarPose {
  double angle_rad = 0, scale = 1;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  Eigen::Vector2d apply(const Eigen::Vector2d& back) const {
    return scale * (Eigen::Rotation2Dd(angle_rad) * back) + shift;
  }
  Eigen::Vector2d unapply(const Eigen::Vector2d& front) const {
    return Eigen::Rotation2Dd(-angle_rad) * (front - shift) / scale;
  }
};

struct PlanarFit {
  PlanarPose pose;
  double rms_mm = 0;                 ///< over the nearest 80 % of both directions' distances
  std::vector<double> distances_mm;  ///< both directions, equal steps
};

enum class FreeScale { No, Yes };

struct PlanarAlignOptions {
  double first_reach_mm =
      2.5;  ///< scale of the robust weight in the first round: the start is off by
  double last_reach_mm = 0.4;  ///< so much; and in the last: two sigma of two outlines' difference
  int rounds = 12;
  int samples = 160;  ///< of each line
  FreeScale scale = FreeScale::No;
};

/// Robust point-to-line alignment in both directions (each line's samples against the other line),
/// Geman-McClure weights over a shrinking scale: parts missing from one outline pull little.
PlanarFit alignOutlines(const OutlineField& front, const OutlineField& back,
                        const PlanarPose& start, const PlanarAlignOptions& options);

/// The turns, in equal steps, at which the outlines laid centroid on centroid agree better than at
/// the neighbouring turns; best first, at most max_count.
std::vector<PlanarPose> bestTurns(const OutlineField& front, const OutlineField& back, double scale,
                                  int max_count);

}  // namespace ostraka::pairing
