#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

namespace ostraka::mask {

/// How often colours occur: brightness in 22 steps of a fifth in the logarithm, two colour
/// differences in 21 steps of 0.06 (the noise of dark pixels).
class ColourHistogram {
 public:
  ColourHistogram();
  static int bin(const cv::Vec3f& log_colour);
  void add(int bin, float weight = 1) { counts_[bin] += weight; }
  /// Adds a share of what is there once more, at all lower brightnesses alike: shadows.
  void addShadows(double share);
  void finish();  ///< spreads counts to neighbouring bins; call before density
  static int bins();
  float total() const { return total_; }
  float density(int bin) const;  ///< share of the samples, with a little doubt in every bin

 private:
  std::vector<float> counts_;
  float total_ = 0;
};

/// One photograph's part in the learning.
struct ColourView {
  cv::Mat photograph;  ///< CV_8UC3
  cv::Mat1b group;     ///< reduced: which group of sherds shows here, 0 = none
  cv::Mat1b core;      ///< reduced: 255 where the hull is deep, so that hardly plate shows
  cv::Mat1b beyond;    ///< reduced: 255 where no plate is known; empty where one lies everywhere
  cv::Mat1b ink;       ///< 255 before the plate's ink; empty where it is plain
  cv::Mat1f* log_odds = nullptr;  ///< in and out
};

/// Sharpens the log odds with what all photographs of a side teach of each group of sherds: the
/// colours of what is likely sherd and of what is likely plate or shadow within and close around
/// the group's hull, as histograms of brightness and two colour differences. One photograph's doubt
/// is settled by the others: a dark patch of the clay shows in all of them, a shadow in few. Sherd
/// is learnt in the hull's core only, since along its foot the contact shadow lies within the hull.
/// Before what lies beyond the plate, of which nothing else is known, the colours of the same
/// photograph that lie there beside all hulls stand in for the plate's. In the cells along the
/// plate's edge either may lie behind a pixel, and colours say nothing. Ink has colours of its own,
/// learnt apart: before it, darkness is no sign of a dark sherd.
void sharpenByColours(std::span<const ColourView> views, int reduction, int threads);

}  // namespace ostraka::mask
