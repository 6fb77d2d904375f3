#pragma once
#include <opencv2/core/mat.hpp>
#include <vector>

#include "ground/bare_rows.h"

namespace ostraka::ground {

/// What is left of one photograph's log colours over the sheet's printed picture in every second
/// cell of every second row of its grid (shadows are smooth), thousandths; kNoRest: nothing is
/// seen.
using SheetRest = cv::Mat_<cv::Vec3s>;

inline const cv::Vec3s kNoRest{32767, 32767, 32767};
/// A stain or a crease is within these of the printed picture; clay and shadow mostly are not.
inline constexpr Tolerance kStain{0.12F, 0.04F};

inline bool isKnown(const cv::Vec3s& rest) {
  return rest[0] != kNoRest[0];
}
inline cv::Vec3f logsOf(const cv::Vec3s& rest) {
  return cv::Vec3f(rest) * 0.001F;
}
inline float brightnessOfRest(const cv::Vec3f& logs) {
  return (logs[0] + logs[1] + logs[2]) / 3;
}

/// Whether it is no brighter than paper, not too dark, and of no other colour than light of the sky
/// or off a sherd gives.
bool mayBeShadow(const cv::Vec3f& logs);

/// Whether shadows stay where they are from photograph to photograph: of what looks like one, dark,
/// of paper's colour and even (clay has grain), most is what most photographs see at its place; or
/// hardly anything looks like one.
/// rests: by photograph, at least 3. paper: over the grid, where bare paper is all around.
bool lightStandsStill(const std::vector<SheetRest>& rests, const cv::Mat1b& paper);

}  // namespace ostraka::ground
