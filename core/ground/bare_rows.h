#pragma once
#include <opencv2/core/matx.hpp>
#include <vector>

namespace ostraka::ground {

/// How much a residual looks like bare plate: brightness along (1,1,1), colour across it.
struct Tolerance {
  float brightness = 0.2F, colour = 0.08F;
};

/// 1 for none, falling to 0 where it is three times the tolerance.
float bareWeight(const cv::Vec3f& residual, const Tolerance& tolerance);

/// A row of colours, channel by channel.
struct ColourRow {
  std::vector<float> channel[3];
  explicit ColourRow(int size);
  void read(const cv::Vec3f* colours);
};

/// Sums over the looks at a row of the plate's cells.
class BareRow {
 public:
  explicit BareRow(int size);
  /// before: the albedo so far; anchor: what it may not stray from.
  void start(const cv::Vec3f* before, const cv::Vec3f* anchor);
  /// A look's values without its light, weighted by how bare they look. unseen: the value of the
  /// first channel where there is none.
  void add(const ColourRow& value, const ColourRow& light, float unseen, const Tolerance& tolerance,
           const Tolerance& from_anchor);
  /// The same with one weight for all.
  void addCertain(const ColourRow& value, const ColourRow& light, float unseen, float weight);
  /// trusted: the sum of squared weights, since many half-hearted looks are not one certain look.
  void write(cv::Vec3f* sum, float* weight, float* trusted) const;

 private:
  int size_;
  ColourRow before_, anchor_, sum_;
  std::vector<float> weight_, squares_;
};

}  // namespace ostraka::ground
