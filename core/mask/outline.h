#pragma once
#include <opencv2/core/mat.hpp>

namespace ostraka::mask {

struct CutOptions {
  double smoothness = 2.5;  ///< log odds that one pixel of outline costs where there is no contrast
  double min_area_px = 100;  ///< smaller pieces are crumbs, smaller holes are filled
};

/// Graph cut at pixel level. log_odds: > 0 is sherd; where `allowed` is 0 there is none. residual:
/// 3 channels; its steps attract the outline. Returns 255 inside.
/// Boykov and Jolly, ICCV 2001, with the contrast term of Rother et al., SIGGRAPH 2004,
/// equation 11.
cv::Mat1b cutOutline(const cv::Mat1f& log_odds, const cv::Mat1b& allowed, const cv::Mat3f& residual,
                     const CutOptions& options);

/// The outline between what is surely sherd and what may be, for a hull is a voxel or two wider
/// than its sherd: where the second is wider than `strip_px` it is taken; in strips, each of which
/// is a dark break or the plate in its shadow, the outline runs where the residual is sharper, for
/// shadows fade. All of one size, 255 inside.
cv::Mat1b settleStrips(const cv::Mat1b& surely, const cv::Mat1b& perhaps, double strip_px,
                       const cv::Mat3f& residual, const CutOptions& options);

/// Soft coverage within about two pixels of the cut: each pixel's share between the local colours
/// of sherd and background, in linear light (coverage mixes light, not encoded values). Where the
/// two are too alike the cut, slightly smoothed, stays.
cv::Mat1b softenOutline(const cv::Mat1b& cut, const cv::Mat& photograph);

/// The same once more from the outline that softenOutline found, with colours taken closer by, and
/// a sherd's last pixel darker along its foot. up: where the plate's upward direction points in the
/// picture, as long as the cosine of the camera's height above the plate: an outline that faces
/// there is an upper edge before a plate far behind it, any other one meets the plate.
cv::Mat1b refineOutline(const cv::Mat1b& soft, const cv::Mat& photograph, const cv::Vec2f& up);

}  // namespace ostraka::mask
