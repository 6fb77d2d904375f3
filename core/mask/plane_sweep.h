#pragma once
#include <opencv2/core/mat.hpp>
#include <vector>

#include "rig/camera.h"

namespace ostraka::mask {

/// Photographs of one stop laid over each other on planes parallel to the plate: where they see a
/// surface their texture agrees on its plane. A photograph is laid on the plate once; seen from its
/// camera a plane higher up is that same picture, scaled about the point below the camera, so each
/// further plane costs a scaling. Whole numbers throughout: sums over windows run along and stay
/// exact.
class PlaneSweep {
 public:
  /// Agreement is sought within radius_mm of the plate's centre, on cells of pitch_mm.
  PlaneSweep(double pitch_mm, double radius_mm);

  /// image and its brightness, log, as large as its intrinsics say. highest_mm: of all planes.
  void add(const rig::PosedImage& image, const cv::Mat1f& brightness, double highest_mm);

  /// Lays all photographs on a plane; best[i], as large as `ground(i)`, becomes the larger of
  /// itself and the normalised cross correlation of photograph i with that one of its nearest which
  /// agrees most, over windows of 9 cells; nothing where a window is not seen whole.
  void agreeOn(double height_mm, std::vector<cv::Mat1f>& best);

  /// The cells of the plate's plane that photograph i's rays through all planes can meet.
  cv::Size ground(std::size_t i) const { return shots_[i].ground; }

  /// What stands in `cells` of ground(i), seen from pixels whose rays meet the plate at plate_mm.
  cv::Mat1f seenFrom(std::size_t i, const cv::Mat1f& cells, const cv::Mat2f& plate_mm) const;

 private:
  struct Shot {
    cv::Mat_<short> picture;  ///< on the plate's plane, finer than the cells
    cv::Mat1b seen;           ///< 255 where the picture is; empty when it is everywhere
    double left_mm = 0, top_mm = 0;
    cv::Size ground;
    double x_mm = 0, y_mm = 0, z_mm = 0;  ///< the camera's centre
  };
  /// A photograph on the present plane.
  struct Laid {
    cv::Mat_<short> value;
    cv::Mat1b seen;  ///< windows seen whole; empty when all are
    cv::Mat1f best;
  };
  void lay(const Shot& shot, double height_mm, Laid& laid) const;
  void findPairs();
  void correlate();
  void keep(const Shot& shot, double height_mm, const cv::Mat1f& best, cv::Mat1f& kept) const;

  double pitch_mm_, fine_mm_;
  int size_;
  std::vector<Shot> shots_;
  std::vector<Laid> laid_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< that are laid over each other
};

}  // namespace ostraka::mask
