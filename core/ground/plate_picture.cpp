#include "ground/plate_picture.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "ground/bare_rows.h"

namespace ostraka::ground {
namespace {

constexpr int kAlternations = 6;   // the alternation changes < 0.5 % after the fourth
constexpr int kFitStride = 3;      // light needs no more than every third cell
constexpr float kEmptyWeight = 4;  // a certain look is worth several doubtful ones
constexpr float kNoSample = -1e3F;

/// Samples of one look on the grid; log colours, kNoSample where unseen.
using Samples = std::vector<cv::Mat3f>;

cv::Vec3f latticeAt(const cv::Mat3f& lattice, float x, float y) {
  const float u = std::clamp(x / kLightStep, 0.F, static_cast<float>(lattice.cols - 1) - 1e-3F);
  const float v = std::clamp(y / kLightStep, 0.F, static_cast<float>(lattice.rows - 1) - 1e-3F);
  const int c = static_cast<int>(u), r = static_cast<int>(v);
  const float a = u - static_cast<float>(c), b = v - static_cast<float>(r);
  return (lattice(r, c) * (1 - a) + lattice(r, c + 1) * a) * (1 - b) +
         (lattice(r + 1, c) * (1 - a) + lattice(r + 1, c + 1) * a) * b;
}

// 255 on the plate's bare border: between and outside the markers.
cv::Mat1b bareBorder(const PlateGrid& grid, const cv::Mat1b& paper) {
  cv::Mat1b border(grid.size, grid.size, uchar{0});
  const double inner = grid.ring_inner_mm, outer = grid.radius_mm - 2;
  for (int row = 0; row < grid.size; ++row)
    for (int column = 0; column < grid.size; ++column) {
      const double x = grid.pitch_mm * (column - grid.middle()),
                   y = grid.pitch_mm * (row - grid.middle()), square = x * x + y * y;
      if (square > inner * inner && square < outer * outer && paper(row, column) == 0)
        border(row, column) = 255;
    }
  return border;
}

// Median log colour of the plate's bare border: a ring all around, so every stop sees the same
// light on it, and what differs between stops is exposure.
cv::Vec3f borderColour(const cv::Mat3f& samples, const cv::Mat1b& border) {
  cv::Vec3f colour(0, 0, 0);
  std::vector<float> values[3];
  for (int row = 0; row < border.rows; ++row)
    for (int column = 0; column < border.cols; ++column)
      if (border(row, column) != 0 && samples(row, column)[0] != kNoSample)
        for (int channel = 0; channel < 3; ++channel)
          values[channel].push_back(samples(row, column)[channel]);
  for (int channel = 0; channel < 3; ++channel) colour[channel] = medianOf(values[channel]);
  return colour;
}

// A quadratic over the image through the plate's bare border (between and outside the markers),
// where no sherd stands: the start that needs no idea of the sherds' colours.
void fitLightFromBorder(std::span<const PlateLook> looks, const Samples& samples,
                        const cv::Mat1b& border, PlatePicture& picture) {
  const cv::Size size = looks[0].log_colours.size();
  const auto basis = [&](double x, double y) {
    const double u = 2 * x / size.width - 1, v = 2 * y / size.height - 1;
    Eigen::Matrix<double, 6, 1> b;
    b << 1, u, v, u * u, u * v, v * v;
    return b;
  };
  for (int channel = 0; channel < 3; ++channel) {
    Eigen::Matrix<double, 6, 1> fit = Eigen::Matrix<double, 6, 1>::Zero();
    for (int round = 0; round < 8; ++round) {
      Eigen::Matrix<double, 6, 6> normal = 1e-3 * Eigen::Matrix<double, 6, 6>::Identity();
      Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
      const double scale = round == 0 ? 1e3 : 1.0 / (1 << std::min(round, 3));
      for (std::size_t s = 0; s < looks.size(); ++s)
        for (int row = 0; row < border.rows; row += kFitStride)
          for (int column = 0; column < border.cols; column += kFitStride) {
            if (border(row, column) == 0 || samples[s](row, column)[0] == kNoSample) continue;
            const float value = samples[s](row, column)[channel] - picture.exposure[s][channel];
            const cv::Vec2f p = looks[s].pixel_of_cell(row, column);
            const auto b = basis(p[0], p[1]);
            const double residual = value - b.dot(fit);
            const double weight = 1 / (1 + std::pow(residual / scale, 2));
            normal += weight * b * b.transpose();
            right += weight * value * b;
          }
      fit = normal.ldlt().solve(right);
    }
    for (int r = 0; r < picture.light.rows; ++r)
      for (int c = 0; c < picture.light.cols; ++c)
        picture.light(r, c)[channel] =
            static_cast<float>(basis(c * kLightStep, r * kLightStep).dot(fit));
  }
}

// The albedo to start from: the empty plate where it was photographed, the median over the looks
// on the markers' paper (bare in most of them), the border's colour elsewhere.
void startAlbedo(std::span<const PlateLook> looks, const Samples& samples, const cv::Mat3f& empty,
                 int empty_look, const cv::Mat1b& paper, PlatePicture& picture) {
  std::vector<float> values;
  for (int row = 0; row < paper.rows; ++row)
    for (int column = 0; column < paper.cols; ++column) {
      cv::Vec3f& albedo = picture.albedo(row, column);
      if (!empty.empty() && empty(row, column)[0] != kNoSample) {
        const cv::Vec2f p = looks[empty_look].pixel_of_cell(row, column);
        albedo = empty(row, column) - latticeAt(picture.light, p[0], p[1]);
      } else if (paper(row, column) != 0) {
        for (int channel = 0; channel < 3; ++channel) {
          values.clear();
          for (std::size_t s = 0; s < looks.size(); ++s) {
            if (samples[s](row, column)[0] == kNoSample) continue;
            const cv::Vec2f p = looks[s].pixel_of_cell(row, column);
            values.push_back(samples[s](row, column)[channel] - picture.exposure[s][channel] -
                             latticeAt(picture.light, p[0], p[1])[channel]);
          }
          if (!values.empty()) albedo[channel] = medianOf(values);
        }
      }
    }
}

// Normalised blur: cells with weight keep their value, the others take their neighbours'.
cv::Mat3f spreadColours(const cv::Mat3f& weighted_sum, const cv::Mat1f& weight, double sigma) {
  // Blur at 1/8 size: the filling is smooth anyway.
  cv::Mat sum, total;
  const cv::Size small((weight.cols + 7) / 8, (weight.rows + 7) / 8);
  cv::resize(weighted_sum, sum, small, 0, 0, cv::INTER_AREA);
  cv::resize(weight, total, small, 0, 0, cv::INTER_AREA);
  const double widths[] = {sigma / 8, sigma / 2, sigma * 2};
  cv::Mat3f filled(small, cv::Vec3f::all(0));
  cv::Mat1f have(small, 0.F);
  for (const double width : widths) {
    cv::Mat blurred_sum, blurred_total;
    cv::GaussianBlur(sum, blurred_sum, {}, width, width, cv::BORDER_REPLICATE);
    cv::GaussianBlur(total, blurred_total, {}, width, width, cv::BORDER_REPLICATE);
    for (int r = 0; r < small.height; ++r)
      for (int c = 0; c < small.width; ++c) {
        const float w = blurred_total.at<float>(r, c);
        const float share = (1 - have(r, c)) * w / (w + 0.1F);
        if (w > 1e-5F) filled(r, c) += share * blurred_sum.at<cv::Vec3f>(r, c) / w;
        if (w > 1e-5F) have(r, c) += share;
      }
  }
  cv::Mat3f full;
  cv::resize(filled, full, weight.size(), 0, 0, cv::INTER_LINEAR);
  return full;
}

/// The plate's colour that nothing accepted as bare may be far from: without it the estimate could
/// walk, round by round, from the plate's colour to that of a grey sherd.
struct Anchor {
  cv::Mat3f albedo;
  Tolerance tolerance;
};

// How far the plate's own mottle strays from one colour, measured on the bare border; a stain may
// be three times as strong. With an empty photograph the anchor is each cell's own colour.
Tolerance anchorTolerance(std::span<const PlateLook> looks, const Samples& samples,
                          const cv::Mat1b& border, const PlatePicture& picture) {
  Tolerance tolerance{0.1F, 0.04F};
  if (picture.has_empty) return tolerance;
  std::vector<float> brightness, colour;
  for (std::size_t s = 0; s < looks.size(); ++s)
    for (int row = 0; row < border.rows; row += kFitStride)
      for (int column = 0; column < border.cols; column += kFitStride) {
        const cv::Vec3f value = samples[s](row, column);
        if (border(row, column) == 0 || value[0] == kNoSample) continue;
        const cv::Vec2f p = looks[s].pixel_of_cell(row, column);
        const cv::Vec3f own = value - latticeAt(picture.light, p[0], p[1]) - picture.exposure[s];
        const float g = (own[0] + own[1] + own[2]) / 3;
        brightness.push_back(std::abs(g));
        colour.push_back(static_cast<float>(cv::norm(own - cv::Vec3f(g, g, g))));
      }
  if (brightness.size() < 100) return tolerance;
  tolerance.brightness = std::clamp(3 * 1.48F * medianOf(brightness), 0.1F, 0.3F);
  // 0.85: two dimensions.
  tolerance.colour = std::clamp(3 * 0.85F * medianOf(colour), 0.04F, 0.12F);
  return tolerance;
}

/// Light and exposure of one look at the grid's cells, row by row. Exact at every eighth cell of
/// every eighth row: light bends over kLightStep pixels.
class LightOnCells {
 public:
  LightOnCells(const cv::Mat3f& light, const cv::Vec3f& exposure, const cv::Mat2f& pixel_of_cell)
      : nodes_(pixel_of_cell.rows / kStep + 2, pixel_of_cell.cols / kStep + 2) {
    for (int r = 0; r < nodes_.rows; ++r)
      for (int c = 0; c < nodes_.cols; ++c) {
        const cv::Vec2f p = pixel_of_cell(std::min(r * kStep, pixel_of_cell.rows - 1),
                                          std::min(c * kStep, pixel_of_cell.cols - 1));
        nodes_(r, c) = latticeAt(light, p[0], p[1]) + exposure;
      }
  }
  void row(int row, ColourRow& light) const {
    const float v = static_cast<float>(row % kStep) / kStep;
    const cv::Vec3f *top = nodes_[row / kStep], *bottom = nodes_[row / kStep + 1];
    const int size = static_cast<int>(light.channel[0].size());
    for (int c = 0; c * kStep < size; ++c) {
      const cv::Vec3f left = top[c] * (1 - v) + bottom[c] * v;
      const cv::Vec3f slope =
          (top[c + 1] * (1 - v) + bottom[c + 1] * v - left) * (1.F / static_cast<float>(kStep));
      const int end = std::min(kStep, size - c * kStep);
      for (int channel = 0; channel < 3; ++channel)
        for (int k = 0; k < end; ++k)
          light.channel[channel][c * kStep + k] =
              left[channel] + static_cast<float>(k) * slope[channel];
    }
  }

 private:
  static constexpr int kStep = 8;
  cv::Mat3f nodes_;
};

// Step A: albedo from all looks' samples without light and exposure, weighted by how bare they look
// against the albedo so far.
void updateAlbedo(std::span<const PlateLook> looks, const Samples& samples, const cv::Mat3f& empty,
                  int empty_look, const Tolerance& tolerance, const Anchor& anchor,
                  const PlateGrid& grid, PlatePicture& picture) {
  cv::Mat3f sum(grid.size, grid.size);
  cv::Mat1f weight(grid.size, grid.size), trusted(grid.size, grid.size);
  std::vector<LightOnCells> lights;
  for (std::size_t s = 0; s < looks.size(); ++s)
    lights.emplace_back(picture.light, picture.exposure[s], looks[s].pixel_of_cell);
  const LightOnCells empty_light(picture.light, cv::Vec3f::all(0), looks[empty_look].pixel_of_cell);
  ColourRow value(grid.size), light(grid.size);
  BareRow row_sums(grid.size);
  for (int row = 0; row < grid.size; ++row) {
    row_sums.start(picture.albedo[row], anchor.albedo[row]);
    for (std::size_t s = 0; s < looks.size(); ++s) {
      value.read(samples[s][row]);
      lights[s].row(row, light);
      row_sums.add(value, light, kNoSample, tolerance, anchor.tolerance);
    }
    if (!empty.empty()) {
      value.read(empty[row]);
      empty_light.row(row, light);
      row_sums.addCertain(value, light, kNoSample, kEmptyWeight);
    }
    row_sums.write(sum[row], weight[row], trusted[row]);
  }
  // 4 mm: wider than the cloth's texture, narrower than its stains.
  cv::Mat3f certain_sum = sum.clone();
  for (int row = 0; row < grid.size; ++row)
    for (int column = 0; column < grid.size; ++column)
      certain_sum(row, column) *= trusted(row, column) / std::max(1e-6F, weight(row, column));
  const cv::Mat3f filled = spreadColours(certain_sum, trusted, 4 / grid.pitch_mm);
  for (int row = 0; row < grid.size; ++row)
    for (int column = 0; column < grid.size; ++column) {
      const float w = weight(row, column);
      // Less than about one certain look is no evidence against the neighbours.
      const float certain = trusted(row, column);
      const float share = certain * certain / (certain * certain + 0.5F);
      picture.albedo(row, column) =
          w > 0 ? share * sum(row, column) / w + (1 - share) * filled(row, column)
                : filled(row, column);
    }
  picture.support = trusted;
}

// Step B: exposure of each look, then the light's lattice, from the residuals of bare samples.
void updateLight(std::span<const PlateLook> looks, const Samples& samples,
                 const Tolerance& tolerance, const PlateGrid& grid, PlatePicture& picture) {
  cv::Mat3f sum(picture.light.size(), cv::Vec3f::all(0));
  cv::Mat1f weight(picture.light.size(), 0.F);
  std::vector<std::pair<cv::Vec3f, cv::Point>> left;  // residuals, and their node of the lattice
  for (std::size_t s = 0; s < looks.size(); ++s) {
    left.clear();
    cv::Vec3d shift(0, 0, 0);
    double total = 0;
    for (int row = 0; row < grid.size; row += kFitStride)
      for (int column = 0; column < grid.size; column += kFitStride) {
        const cv::Vec3f value = samples[s](row, column);
        if (value[0] == kNoSample || picture.support(row, column) < 1) continue;
        const cv::Vec2f p = looks[s].pixel_of_cell(row, column);
        const cv::Vec3f residual = value - latticeAt(picture.light, p[0], p[1]) -
                                   picture.exposure[s] - picture.albedo(row, column);
        left.emplace_back(residual,
                          cv::Point(std::clamp(cvRound(p[0] / kLightStep), 0, sum.cols - 1),
                                    std::clamp(cvRound(p[1] / kLightStep), 0, sum.rows - 1)));
        const float w = bareWeight(residual, tolerance);
        shift += cv::Vec3d(w * residual);
        total += w;
      }
    const cv::Vec3f mean = total > 100 ? cv::Vec3f(shift * (1 / total)) : cv::Vec3f(0, 0, 0);
    picture.exposure[s] += mean;
    for (const auto& [residual, node] : left) {
      const cv::Vec3f own = residual - mean;
      const float w = bareWeight(own, tolerance);
      sum(node) += w * own;
      weight(node) += w;
    }
  }
  cv::Mat blurred_sum, blurred_weight;
  cv::GaussianBlur(sum, blurred_sum, {}, 1, 1, cv::BORDER_REPLICATE);
  cv::GaussianBlur(weight, blurred_weight, {}, 1, 1, cv::BORDER_REPLICATE);
  for (int r = 0; r < sum.rows; ++r)
    for (int c = 0; c < sum.cols; ++c)
      picture.light(r, c) +=
          blurred_sum.at<cv::Vec3f>(r, c) / (blurred_weight.at<float>(r, c) + 20.F);
}

// What does not turn looks the same at all stops: the median over the looks, channel by channel.
cv::Mat3f stillRoom(std::span<const PlateLook> looks, const PlatePicture& picture,
                    const PlateGrid& grid) {
  const cv::Size size = looks[0].log_colours.size();
  cv::Mat3f room(size, cv::Vec3f::all(0));
  const double limit = (grid.radius_mm - 3) / grid.pitch_mm;
  const cv::Vec2f middle(static_cast<float>(grid.middle()), static_cast<float>(grid.middle()));
  std::vector<float> values(looks.size());
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (cv::norm(looks[0].grid_of_pixel(y, x) - middle) < limit) continue;
      for (int channel = 0; channel < 3; ++channel) {
        for (std::size_t s = 0; s < looks.size(); ++s)
          values[s] = looks[s].log_colours(y, x)[channel] - picture.exposure[s][channel];
        room(y, x)[channel] = medianOf(values);
      }
    }
  return room;
}

cv::Mat3f sampled(const cv::Mat3f& colours, const cv::Mat2f& pixel_of_cell) {
  cv::Mat3f samples;
  cv::remap(colours, samples, pixel_of_cell, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar::all(kNoSample));
  // A sample half outside the picture mixes in the border's value.
  for (cv::Vec3f& value : samples)
    if (value[0] < 0) value = cv::Vec3f::all(kNoSample);
  return samples;
}

}  // namespace

cv::Mat3f logColours(const cv::Mat& photograph) {
  std::array<float, 256> table{};
  for (int i = 0; i < 256; ++i) table[i] = std::log(static_cast<float>(i) + kDarkLevel);
  cv::Mat3f logs(photograph.size());
  for (int y = 0; y < photograph.rows; ++y) {
    const cv::Vec3b* from = photograph.ptr<cv::Vec3b>(y);
    cv::Vec3f* to = logs[y];
    for (int x = 0; x < photograph.cols; ++x)
      to[x] = {table[from[x][0]], table[from[x][1]], table[from[x][2]]};
  }
  return logs;
}

PlatePicture buildPlatePicture(std::span<const PlateLook> looks, const cv::Mat3f& empty,
                               int empty_look, const PlateGrid& grid, const cv::Mat1b& paper) {
  const cv::Size size = looks[0].log_colours.size();
  PlatePicture picture;
  picture.albedo = cv::Mat3f(grid.size, grid.size, cv::Vec3f::all(0));
  picture.support = cv::Mat1f(grid.size, grid.size, 1.F);
  picture.light = cv::Mat3f(size.height / kLightStep + 2, size.width / kLightStep + 2);
  picture.exposure.assign(looks.size(), cv::Vec3f::all(0));
  Samples samples;
  for (const PlateLook& look : looks)
    samples.push_back(sampled(look.log_colours, look.pixel_of_cell));
  cv::Mat3f empty_samples;
  if (!empty.empty()) empty_samples = sampled(empty, looks[empty_look].pixel_of_cell);
  picture.has_empty = !empty.empty();
  cv::Vec3f mean(0, 0, 0);
  const cv::Mat1b border = bareBorder(grid, paper);
  for (std::size_t s = 0; s < looks.size(); ++s) {
    picture.exposure[s] = borderColour(samples[s], border);
    mean += picture.exposure[s] * (1.F / static_cast<float>(looks.size()));
  }
  for (cv::Vec3f& exposure : picture.exposure) exposure -= mean;
  if (!empty_samples.empty()) {
    const cv::Vec3f shift = mean - borderColour(empty_samples, border);
    for (cv::Vec3f& value : empty_samples)
      if (value[0] != kNoSample) value += shift;
  }
  fitLightFromBorder(looks, samples, border, picture);
  startAlbedo(looks, samples, empty_samples, empty_look, paper, picture);
  const Anchor anchor{picture.albedo.clone(), anchorTolerance(looks, samples, border, picture)};
  for (int round = 0; round < kAlternations; ++round) {
    // From a wide look at everything plate-like down to the noise of a pixel.
    const float narrowing = std::pow(0.75F, static_cast<float>(round));
    const Tolerance tolerance{0.3F * narrowing, 0.12F * narrowing};
    updateAlbedo(looks, samples, empty_samples, empty_look, tolerance, anchor, grid, picture);
    updateLight(looks, samples, tolerance, grid, picture);
  }
  picture.room = stillRoom(looks, picture, grid);
  return picture;
}

cv::Mat3f predictBare(const PlatePicture& picture, const PlateLook& look, std::size_t index,
                      const PlateGrid& grid) {
  const cv::Size size = look.log_colours.size();
  cv::Mat3f bare;
  cv::remap(picture.albedo, bare, look.grid_of_pixel, cv::noArray(), cv::INTER_LINEAR,
            cv::BORDER_REPLICATE);
  const double limit = (grid.radius_mm - 1.5) / grid.pitch_mm;  // the plate's edge is rounded
  const cv::Vec2f middle(static_cast<float>(grid.middle()), static_cast<float>(grid.middle()));
  const cv::Vec3f exposure = picture.exposure[index];
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (cv::norm(look.grid_of_pixel(y, x) - middle) < limit)
        bare(y, x) +=
            exposure + latticeAt(picture.light, static_cast<float>(x), static_cast<float>(y));
      else
        bare(y, x) = picture.room(y, x) + exposure;
    }
  return bare;
}

}  // namespace ostraka::ground
