#include "mask/plane_sweep.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "base/processors.h"
#include "ground/exponential.h"
#include "ground/plate_geometry.h"

namespace ostraka::mask {
namespace {

constexpr int kWindow = 9;  // cells, of two pixels: holds some grains of temper
constexpr int kHalf = kWindow / 2;
constexpr float kUnit = 2400;    // of brightness, per 1 in the logarithm
constexpr float kMiddle = 3.47;  // log brightness lies within 2.09 of it: 81 squares fit 31 bits
constexpr float kNoise = 1;      // levels of 255 that noise leaves after halving
constexpr double kFiner = 1.5;   // picture cells per cell, so that scaling blurs little
constexpr int kShares = 256;     // of a cell, for interpolating
constexpr float kUnseen = -1e3F;
constexpr std::size_t kNearest = 4;  // photographs farther off see another shading and outline

OSTRAKA_CLONED void blendRows(const short* top, const short* bottom, int share, int count,
                              short* blend) {
  for (int x = 0; x < count; ++x)
    blend[x] = static_cast<short>((top[x] * (kShares - share) + bottom[x] * share + kShares / 2) /
                                  kShares);
}

OSTRAKA_CLONED void addValues(const short* in, int count, int* sum, int* squares) {
  for (int x = 0; x < count; ++x) {
    const int value = in[x];
    sum[x] += value;
    squares[x] += value * value;
  }
}

OSTRAKA_CLONED void takeValues(const short* out, int count, int* sum, int* squares) {
  for (int x = 0; x < count; ++x) {
    const int value = out[x];
    sum[x] -= value;
    squares[x] -= value * value;
  }
}

OSTRAKA_CLONED void addProducts(const short* a, const short* b, int count, int* sum) {
  for (int x = 0; x < count; ++x) sum[x] += static_cast<int>(a[x]) * b[x];
}

OSTRAKA_CLONED void takeProducts(const short* a, const short* b, int count, int* sum) {
  for (int x = 0; x < count; ++x) sum[x] -= static_cast<int>(a[x]) * b[x];
}

// window[x] = columns[x - 4] + ... + columns[x + 4]; pairs and fours are scratch of that size.
OSTRAKA_CLONED void sumAcross(const int* columns, int count, int* pairs, int* fours, int* window) {
  for (int x = 0; x + 1 < count; ++x) pairs[x] = columns[x] + columns[x + 1];
  for (int x = 0; x + 3 < count; ++x) fours[x] = pairs[x] + pairs[x + 2];
  for (int x = kHalf; x + kHalf < count; ++x) window[x] = fours[x - 4] + fours[x] + columns[x + 4];
}

// 1 / SD of a window, damped by the noise's, so that even surfaces do not agree.
OSTRAKA_CLONED void strengths(const int* sum, const int* squares, int count, float* strength) {
  constexpr int kCells = kWindow * kWindow;
  for (int x = kHalf; x < count - kHalf; ++x) {
    const double spread = static_cast<double>(squares[x]) * kCells -
                          static_cast<double>(sum[x]) * static_cast<double>(sum[x]);
    const float variance = static_cast<float>(spread) * (1.F / (kCells * kCells));
    const float mean = static_cast<float>(sum[x]) * (1.F / (kCells * kUnit)) + kMiddle;
    const float noise = kUnit * kNoise * ground::expOf(-mean);
    strength[x] = 1 / std::sqrt(variance + noise * noise);
  }
}

struct Moments {
  std::vector<int> columns, square_columns, sum, squares;
  std::vector<float> strength;
  explicit Moments(int n)
      : columns(n, 0), square_columns(n, 0), sum(n), squares(n), strength(n, 0.F) {}
};

OSTRAKA_CLONED void agreements(const int* products, const int* sum_a, const float* strength_a,
                               const int* sum_b, const float* strength_b, int count, float* ncc) {
  constexpr int kCells = kWindow * kWindow;
  for (int x = kHalf; x < count - kHalf; ++x) {
    const double shared = static_cast<double>(products[x]) * kCells -
                          static_cast<double>(sum_a[x]) * static_cast<double>(sum_b[x]);
    ncc[x] = static_cast<float>(shared) * (1.F / (kCells * kCells)) * strength_a[x] * strength_b[x];
  }
}

OSTRAKA_CLONED void keepLarger(const float* ncc, int count, float* a, float* b) {
  for (int x = kHalf; x < count - kHalf; ++x) {
    a[x] = std::max(a[x], ncc[x]);
    b[x] = std::max(b[x], ncc[x]);
  }
}

// Places `count` samples at first + k * step in a row: cell and share of the next one; returns
// which of them, from..to, have both cells within 0 .. cells - 1.
struct Places {
  std::vector<int> cell, share;
  int from = 0, to = 0;
  Places(double first, double step, int count, int cells) : cell(count), share(count), to(count) {
    for (int k = 0; k < count; ++k) {
      const double at = first + k * step;
      cell[k] = static_cast<int>(std::floor(at));
      share[k] = static_cast<int>((at - cell[k]) * kShares);
      if (cell[k] < 0) from = k + 1;
      if (cell[k] + 1 >= cells) to = std::min(to, k);
    }
    to = std::max(from, to);
  }
};

}  // namespace

PlaneSweep::PlaneSweep(double pitch_mm, double radius_mm)
    : pitch_mm_(pitch_mm),
      fine_mm_(pitch_mm / kFiner),
      size_(2 * (static_cast<int>(std::ceil(radius_mm / pitch_mm)) + kHalf) + 1) {}

void PlaneSweep::add(const rig::PosedImage& image, const cv::Mat1f& brightness, double highest_mm) {
  Shot shot;
  const Eigen::Vector3d centre = image.centre();
  shot.x_mm = centre.x(), shot.y_mm = centre.y(), shot.z_mm = centre.z();
  // Where the rays through the square of the highest plane and of the plate meet the plate.
  const double half = 0.5 * (size_ - 1) * pitch_mm_;
  const double share = std::min(0.9, highest_mm / shot.z_mm);
  const auto along = [&](double edge, double eye) { return (edge - share * eye) / (1 - share); };
  const double left = std::min(-half, along(-half, shot.x_mm)) - pitch_mm_,
               right = std::max(half, along(half, shot.x_mm)) + pitch_mm_,
               top = std::min(-half, along(-half, shot.y_mm)) - pitch_mm_,
               bottom = std::max(half, along(half, shot.y_mm)) + pitch_mm_;
  shot.left_mm = left, shot.top_mm = top;
  shot.ground = {static_cast<int>(std::ceil((right - left) / pitch_mm_)) + 1,
                 static_cast<int>(std::ceil((bottom - top) / pitch_mm_)) + 1};
  const cv::Size fine(static_cast<int>(std::ceil(shot.ground.width * kFiner)) + 2,
                      static_cast<int>(std::ceil(shot.ground.height * kFiner)) + 2);
  const cv::Mat2f pixels = ground::pixelsOfCells(image, {left, top}, fine_mm_, fine);
  cv::Mat1f laid;
  cv::remap(brightness, laid, pixels, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar::all(kUnseen));
  shot.seen = laid >= 0;
  if (cv::countNonZero(shot.seen) == static_cast<int>(shot.seen.total())) shot.seen.release();
  laid = (laid - kMiddle) * kUnit;
  laid = cv::max(cv::min(laid, 2.09F * kUnit), -2.09F * kUnit);
  laid.convertTo(shot.picture, CV_16S);
  shots_.push_back(std::move(shot));
  laid_.emplace_back();
}

void PlaneSweep::lay(const Shot& shot, double height_mm, Laid& laid) const {
  const double share = height_mm / shot.z_mm, half = 0.5 * (size_ - 1) * pitch_mm_;
  const double step = pitch_mm_ / (1 - share) / fine_mm_;
  const double first_x = ((-half - share * shot.x_mm) / (1 - share) - shot.left_mm) / fine_mm_,
               first_y = ((-half - share * shot.y_mm) / (1 - share) - shot.top_mm) / fine_mm_;
  const Places columns(first_x, step, size_, shot.picture.cols),
      rows(first_y, step, size_, shot.picture.rows);
  laid.value.create(size_, size_);
  if (!shot.seen.empty()) laid.seen.create(size_, size_);
  std::vector<short> blend(static_cast<std::size_t>(shot.picture.cols));
  const int first = columns.cell[0], count = columns.cell[size_ - 1] + 2 - first;
  for (int y = 0; y < size_; ++y) {
    const short* top = shot.picture[rows.cell[y]] + first;
    blendRows(top, shot.picture[rows.cell[y] + 1] + first, rows.share[y], count, blend.data());
    short* to = laid.value[y];
    for (int x = 0; x < size_; ++x) {
      const short* at = blend.data() + columns.cell[x] - first;
      to[x] = static_cast<short>(
          (at[0] * (kShares - columns.share[x]) + at[1] * columns.share[x] + kShares / 2) /
          kShares);
    }
    if (shot.seen.empty()) continue;
    for (int x = 0; x < size_; ++x)
      laid.seen(y, x) = shot.seen(rows.cell[y], columns.cell[x]) &
                        shot.seen(rows.cell[y] + 1, columns.cell[x] + 1);
  }
  if (!shot.seen.empty())
    cv::erode(laid.seen, laid.seen, cv::getStructuringElement(cv::MORPH_RECT, {kWindow, kWindow}));
  laid.best.create(size_, size_);
  laid.best.setTo(0);
}

// Each photograph with its nearest, by the angle at which they look at the plate's middle.
void PlaneSweep::findPairs() {
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  const auto direction = [&](std::size_t i) {
    return Eigen::Vector3d(shots_[i].x_mm, shots_[i].y_mm, shots_[i].z_mm).normalized();
  };
  for (std::size_t i = 0; i < shots_.size(); ++i) {
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t j = 0; j < shots_.size(); ++j)
      if (j != i) others.emplace_back(-direction(i).dot(direction(j)), j);
    std::sort(others.begin(), others.end());
    for (std::size_t k = 0; k < std::min(kNearest, others.size()); ++k)
      pairs.emplace(std::min(i, others[k].second), std::max(i, others[k].second));
  }
  pairs_.assign(pairs.begin(), pairs.end());
}

void PlaneSweep::correlate() {
  const std::size_t count = laid_.size();
  std::vector<Moments> moments(count, Moments(size_));
  std::vector<std::vector<int>> products(pairs_.size(), std::vector<int>(size_, 0));
  std::vector<int> pairs(size_), fours(size_), window(size_);
  std::vector<float> ncc(size_);
  for (int row = 0; row < size_; ++row) {
    const int gone = row - kWindow, y = row - kHalf;
    for (std::size_t i = 0; i < count; ++i) {
      Moments& m = moments[i];
      addValues(laid_[i].value[row], size_, m.columns.data(), m.square_columns.data());
      if (gone >= 0)
        takeValues(laid_[i].value[gone], size_, m.columns.data(), m.square_columns.data());
      if (row + 1 < kWindow) continue;
      sumAcross(m.columns.data(), size_, pairs.data(), fours.data(), m.sum.data());
      sumAcross(m.square_columns.data(), size_, pairs.data(), fours.data(), m.squares.data());
      strengths(m.sum.data(), m.squares.data(), size_, m.strength.data());
      if (!laid_[i].seen.empty())
        for (int x = 0; x < size_; ++x)
          if (laid_[i].seen(y, x) == 0) m.strength[x] = 0;
    }
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const auto [i, j] = pairs_[p];
      int* product = products[p].data();
      addProducts(laid_[i].value[row], laid_[j].value[row], size_, product);
      if (gone >= 0) takeProducts(laid_[i].value[gone], laid_[j].value[gone], size_, product);
      if (row + 1 < kWindow) continue;
      sumAcross(product, size_, pairs.data(), fours.data(), window.data());
      agreements(window.data(), moments[i].sum.data(), moments[i].strength.data(),
                 moments[j].sum.data(), moments[j].strength.data(), size_, ncc.data());
      keepLarger(ncc.data(), size_, laid_[i].best[y], laid_[j].best[y]);
    }
  }
}

void PlaneSweep::keep(const Shot& shot, double height_mm, const cv::Mat1f& best,
                      cv::Mat1f& kept) const {
  const double share = height_mm / shot.z_mm, half = 0.5 * (size_ - 1) * pitch_mm_;
  const auto first = [&](double edge, double eye) {
    return ((1 - share) * edge + share * eye + half) / pitch_mm_;
  };
  const Places columns(first(shot.left_mm, shot.x_mm), 1 - share, kept.cols, size_),
      rows(first(shot.top_mm, shot.y_mm), 1 - share, kept.rows, size_);
  std::vector<float> blend(static_cast<std::size_t>(size_));
  for (int y = rows.from; y < rows.to; ++y) {
    const float *top = best[rows.cell[y]], *bottom = best[rows.cell[y] + 1];
    const float down = static_cast<float>(rows.share[y]) / kShares;
    for (int x = 0; x < size_; ++x) blend[x] = top[x] + down * (bottom[x] - top[x]);
    float* to = kept[y];
    for (int x = columns.from; x < columns.to; ++x) {
      const float* at = blend.data() + columns.cell[x];
      const float across = static_cast<float>(columns.share[x]) / kShares;
      to[x] = std::max(to[x], at[0] + across * (at[1] - at[0]));
    }
  }
}

void PlaneSweep::agreeOn(double height_mm, std::vector<cv::Mat1f>& best) {
  if (pairs_.empty()) findPairs();
  for (std::size_t i = 0; i < shots_.size(); ++i) lay(shots_[i], height_mm, laid_[i]);
  correlate();
  for (std::size_t i = 0; i < shots_.size(); ++i)
    keep(shots_[i], height_mm, laid_[i].best, best[i]);
}

cv::Mat1f PlaneSweep::seenFrom(std::size_t i, const cv::Mat1f& cells,
                               const cv::Mat2f& plate_mm) const {
  const Shot& shot = shots_[i];
  const cv::Mat2f places = (plate_mm - cv::Scalar(shot.left_mm, shot.top_mm)) * (1 / pitch_mm_);
  cv::Mat1f seen;
  cv::remap(cells, seen, places, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar::all(0));
  return seen;
}

}  // namespace ostraka::mask
