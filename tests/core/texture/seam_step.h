#pragma once
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "texture/seams.h"
#include "texture/texture.h"

namespace ostraka::texture {

/// RMS of the CIE 1976 difference between both sides of seams, where both were seen.
inline double stepAcross(const cv::Mat3b& page, const cv::Mat1b& seen,
                         const std::vector<Seam>& seams) {
  const auto labAt = [&](const Eigen::Vector2d& texel) {
    const Eigen::Vector2f place(static_cast<float>((texel.x() + 0.5) / page.cols),
                                static_cast<float>((texel.y() + 0.5) / page.rows));
    const cv::Mat3f one(1, 1, cv::Vec3f(levelAt(page, place) / 255));
    cv::Mat3f lab;
    cv::cvtColor(one, lab, cv::COLOR_BGR2Lab);
    return lab(0, 0);
  };
  const auto isSeen = [&](const Eigen::Vector2d& texel) {
    return seen(cvRound(texel.y()), cvRound(texel.x())) != 0;
  };
  double sum = 0;
  int count = 0;
  for (const Seam& seam : seams)
    for (const auto& [one, other] : placesAlong(seam)) {
      if (!isSeen(one) || !isSeen(other)) continue;
      const cv::Vec3f off = labAt(one) - labAt(other);
      sum += off.dot(off);
      ++count;
    }
  return count > 0 ? std::sqrt(sum / count) : INFINITY;
}

}  // namespace ostraka::texture
