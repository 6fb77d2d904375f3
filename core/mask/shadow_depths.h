#pragma once
#include <array>
#include <opencv2/core/mat.hpp>
#include <span>

#include "ground/sheet_picture.h"

namespace ostraka::mask {

/// What one view tells of shadows; group and plate are reduced.
struct ShadowSight {
  const cv::Mat3f& residual;  ///< Evidence::residual
  const cv::Mat1b& group;     ///< 0 where the hull does not show
  const cv::Mat1b& plate;     ///< 0 beyond the plate
  const cv::Mat& photograph;  ///< CV_8UC3
  const cv::Mat1f& log_odds;  ///< Evidence::log_odds
};

/// How much more a dark pixel looks like a sherd than Evidence::log_odds says, by
/// its darkness (log, steps of kShadowStep): there a shadow may be as deep as it likes, but in one
/// room shadows end somewhere, and what is darker is black clay; not darker, though, than clay is.
struct ShadowDepths {
  std::array<float, 32> odds{};
  float darkest_clay = 0;  ///< log (brightness + kDarkLevel)
  /// Adds them to log odds of the photograph's size.
  void addTo(cv::Mat1f& log_odds, const cv::Mat3f& residual, const cv::Mat& photograph) const;
};

inline constexpr float kShadowStep = 0.1F;

/// Shadows are learnt from what lies in them beside the hull, where no sherd stands; clay from what
/// surely is some.
ShadowDepths learnShadowDepths(std::span<const ShadowSight> sights, int reduction);
/// Where light stands still over a sheet, shadows are known by themselves (SheetPicture::shade) and
/// seen to the sherds' feet. No odds where there is no shade.
ShadowDepths depthsOfLastingShade(const ground::SheetPicture& picture);

}  // namespace ostraka::mask
