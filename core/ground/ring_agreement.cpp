#include "ground/ring_agreement.h"

#include <array>
#include <cmath>
#include <vector>

#include "base/median.h"

namespace ostraka::ground {
namespace {

// Sums of a correlation.
struct Correlation {
  double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
  void add(double a, double b) {
    n += 1, sx += a, sy += b, sxx += a * a, syy += b * b, sxy += a * b;
  }
  double value() const {
    const double vx = n * sxx - sx * sx, vy = n * syy - sy * sy;
    return vx > 0 && vy > 0 ? (n * sxy - sx * sy) / std::sqrt(vx * vy) : 0;
  }
};

}  // namespace

RingAgreement ringAgreement(const cv::Mat3f& empty, const PlateLook& look, const cv::Mat1b& paper) {
  constexpr int kPieces = 16;
  Correlation whole;
  std::array<Correlation, kPieces> pieces;
  const double middle_row = 0.5 * (paper.rows - 1), middle_column = 0.5 * (paper.cols - 1);
  for (int row = 0; row < paper.rows; row += 2)
    for (int column = 0; column < paper.cols; column += 2) {
      if (paper(row, column) == 0) continue;
      const cv::Vec2f p = look.pixel_of_cell(row, column);
      const cv::Point pixel(cvRound(p[0]), cvRound(p[1]));
      if (!cv::Rect({0, 0}, empty.size()).contains(pixel)) continue;
      const double turn = std::atan2(row - middle_row, column - middle_column) / (2 * M_PI) + 0.5;
      const double a = empty(pixel)[1], b = look.log_colours(pixel)[1];
      whole.add(a, b);
      pieces[static_cast<std::size_t>(kPieces * turn) % kPieces].add(a, b);
    }
  std::vector<double> values;
  for (const Correlation& piece : pieces)
    if (piece.n > 0) values.push_back(piece.value());
  return {whole.value(), values.empty() ? 0 : medianOf(std::move(values))};
}

}  // namespace ostraka::ground
