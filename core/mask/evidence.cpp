#include "mask/evidence.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/median.h"
#include "base/processors.h"
#include "ground/exponential.h"
#include "ground/plate_picture.h"

namespace ostraka::mask {
namespace {

constexpr float kUneven = 0.02F;  // log: lit plate is as bright as predicted but for so much

float brightnessOf(const cv::Vec3f& v) {
  return (v[0] + v[1] + v[2]) / 3;
}

// Two orthonormal directions across (1,1,1)/sqrt(3), scaled so that white noise of SD s per channel
// has SD s in both.
cv::Vec2f colourOf(const cv::Vec3f& v) {
  return {(v[2] - v[0]) * 0.70710678F, (v[0] + v[2] - 2 * v[1]) * 0.40824829F};
}

float robustDeviation(std::vector<float>& values) {
  const float median = medianOf(values);
  for (float& v : values) v = std::abs(v - median);
  return 1.4826F * medianOf(values);
}

// Gradient length of the bare plate's brightness, per pixel: markers and texture.
cv::Mat1f slopeOf(const cv::Mat3f& bare) {
  cv::Mat1f brightness;
  cv::transform(bare, brightness, cv::Matx13f(1 / 3.F, 1 / 3.F, 1 / 3.F));
  cv::Mat1f across, along, slope;
  cv::Sobel(brightness, across, CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(brightness, along, CV_32F, 0, 1, 3, 0.125);
  cv::magnitude(across, along, slope);
  cv::dilate(slope, slope, cv::Mat());
  return slope;
}

// Smaller eigenvalue of [a c; c b].
float smallerEigenvalue(float a, float b, float c) {
  const float half = 0.5F * (a - b);
  return std::max(0.F, 0.5F * (a + b) - std::sqrt(half * half + c * c));
}

// Energy of the fine structure in the direction in which a window shows least of it: the smaller
// eigenvalue of the structure tensor (Shi and Tomasi, CVPR 1994), the smallest of the windows that
// hold the pixel. Grain runs in all directions. Outlines, the narrow dark line where a sherd meets
// the plate, and the borders of shadows run in one and leave none.
cv::Mat1f calmestTexture(const cv::Mat3f& residual) {
  constexpr int kWindow = 7;
  cv::Mat1f brightness, fine, across, along, both;
  cv::transform(residual, brightness, cv::Matx13f(1 / 3.F, 1 / 3.F, 1 / 3.F));
  cv::GaussianBlur(brightness, fine, {}, 1.2, 1.2, cv::BORDER_REPLICATE);
  fine = brightness - fine;
  cv::Sobel(fine, across, CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(fine, along, CV_32F, 0, 1, 3, 0.125);
  cv::boxFilter(across.mul(along), both, CV_32F, {kWindow, kWindow});
  cv::sqrBoxFilter(across, across, CV_32F, {kWindow, kWindow});
  cv::sqrBoxFilter(along, along, CV_32F, {kWindow, kWindow});
  cv::Mat1f energy(fine.size());
  for (int y = 0; y < energy.rows; ++y)
    for (int x = 0; x < energy.cols; ++x)
      energy(y, x) = smallerEigenvalue(across(y, x), along(y, x), both(y, x));
  cv::erode(energy, energy, cv::getStructuringElement(cv::MORPH_RECT, {kWindow, kWindow}));
  return energy;
}

/// What weighRow needs of a row of pixels.
struct PixelRow {
  std::vector<float> brightness, colour2;  ///< of the residual; the colour's length, squared
  std::vector<float> bare;                 ///< log brightness of the bare plate
  std::vector<float> edge;                 ///< how far a misplaced bare plate may be off
  std::vector<float> in_shade;             ///< ResidualNoise::shadeTexture
  explicit PixelRow(int n) : brightness(n), colour2(n), bare(n), edge(n), in_shade(n) {}
};

OSTRAKA_CLONED void weighRow(const PixelRow& row, const float* texture, const ResidualNoise& noise,
                             int count, float* log_odds, float* clear) {
  constexpr float kTwoPi = 6.2831853F, kSurest = 8;
  // Any clay: colour differences within +-0.6, brightness within a factor of e^2 either way.
  constexpr float kSherdDensity = 1 / (3.14159F * 0.36F * 4);
  const float *brightness = row.brightness.data(), *colour2 = row.colour2.data(),
              *bare = row.bare.data(), *edges = row.edge.data(), *in_shade = row.in_shade.data();
  const float var_noise = noise.brightness * noise.brightness;
  const float var_colour = noise.colour * noise.colour;
  const float level = noise.level + ground::kDarkLevel, log_six = ground::logOf(6.F);
  const float per_texture = 1 / noise.texture, per_noise = 1 / var_noise;
  for (int x = 0; x < count; ++x) {
    const float g = brightness[x], c2 = colour2[x], edge = edges[x];
    const float down = std::min(g, 0.F);
    // Encoded values stabilise shot noise: it is about the same number of levels everywhere, so
    // in the logarithm it grows in shadows as the inverse of the brightness.
    const float darker = level * ground::expOf(-bare[x] - down);
    const float gain = std::max(0.25F, darker * darker);
    const float var_c = var_colour * gain + 0.1F * edge * edge +
                        0.0016F * g * g;  // lamps' colours differ by some 4 %
    const float var_g = var_noise * gain + kUneven * kUneven + edge * edge;
    const float chi_c = c2 / var_c;
    const float colour_density =
        (0.95F * ground::expOf(-0.5F * chi_c) + 0.05F / 9 * ground::expOf(-0.5F * chi_c / 9)) /
        (kTwoPi * var_c);
    const float lit = ground::expOf(-0.5F * g * g / var_g) / std::sqrt(kTwoPi * var_g);
    const float bounce = ground::expOf(-0.5F * g * g / 0.01F) / 0.25F;  // light off a bright sherd
    const float shadow = ((g < 0) & (g > -3)) ? 1 / 3.F : 0.F;
    // In a shadow the sherds' own light counts: beside them some tenth of the lamps' light comes
    // off their clay, with its colour. On what is left of exp(g) that tints by up to
    // 0.12 (exp(-g) - 1).
    const float tint = 0.12F * (ground::expOf(-down) - 1);
    const float var_t = var_c + tint * tint;
    const float tinted = ground::expOf(-0.5F * c2 / var_t) / (kTwoPi * var_t);
    const float plate_density =
        colour_density * (0.4F * lit + 0.05F * bounce + 0.2F * shadow) + 0.35F * shadow * tinted;
    // White clay has a white sheet's colour, however little noise there is.
    float odds =
        std::max(ground::logOf(kSherdDensity / (plate_density + 1e-4F * kSherdDensity)), -kSurest);
    // Texture: clay's grain leaves some six times the energy of the plate's noise (likelihood
    // ratio of two variances over the window's sixteen independent samples). Smooth clay leaves
    // none, so a lack of texture says nothing.
    const float ratio = texture[x] * per_texture / (in_shade[x] * gain + edge * edge * per_noise);
    // What else lies on a plate has a grain, too, the seldomer the stronger it is: one time in a
    // thousand as much as clay's, and less with its square.
    const float most = 7 + 2 * ground::logOf(std::max(ratio, 6.F) / 6);
    const float grain =
        std::min(std::max(0.5F * 16 * (ratio * (1 - 1 / 6.F) - log_six), 0.F), most);
    // Where a shadow leaves less than a third of the light, JPEG's rounding makes a grain of its
    // own.
    odds += grain * std::min(std::max(2 - darker / 3, 0.F), 1.F);
    odds = std::min(std::max(odds, -kSurest), kSurest);
    log_odds[x] = odds;
    const float chi = chi_c / 9 + g * g / (9 * (var_g + 0.0025F));
    const float open = ground::expOf(-0.5F * chi * chi);
    clear[x] = odds < -2 ? open : 0.F;
  }
}

// What nine of ten windows stay below, where a shadow's depth is often seen; between as it goes on:
// noise in shadows is uneven, and what exceeds it counts as clay.
std::array<float, ResidualNoise::kDepths> excessByDepth(
    std::array<std::vector<float>, ResidualNoise::kDepths>& excess) {
  constexpr std::size_t kFewest = 100;
  std::array<float, ResidualNoise::kDepths> by_depth;
  by_depth.fill(1);
  int last = 0;
  for (int depth = 1; depth < ResidualNoise::kDepths; ++depth) {
    std::vector<float>& here = excess[static_cast<std::size_t>(depth)];
    if (here.size() < kFewest) continue;
    const auto most_of_them = here.begin() + static_cast<std::ptrdiff_t>(here.size() * 9 / 10);
    std::nth_element(here.begin(), most_of_them, here.end());
    const float value = std::max(1.F, *most_of_them);
    const float start = by_depth[static_cast<std::size_t>(last)];
    for (int k = last + 1; k <= depth; ++k)
      by_depth[static_cast<std::size_t>(k)] =
          start * std::pow(value / start, static_cast<float>(k - last) / (depth - last));
    last = depth;
  }
  const float most = by_depth[static_cast<std::size_t>(last)];
  for (int k = 1; k < ResidualNoise::kDepths; ++k) {
    float& value = by_depth[static_cast<std::size_t>(k)];
    if (k > last) value = most;
    // Below half the light shot noise explains more and more of it, below a third all.
    value = (value - 1) * std::clamp(3 - std::exp(k * ResidualNoise::kDepthStep), 0.F, 1.F);
  }
  by_depth[0] = 0;
  return by_depth;
}

}  // namespace

float ResidualNoise::shadeTexture(float depth) const {
  const float at = std::clamp(depth / kDepthStep, 0.F, kDepths - 1.001F);
  const auto k = static_cast<std::size_t>(at);
  const float t = at - static_cast<float>(k);
  return 1 + (1 - t) * shade_texture[k] + t * shade_texture[k + 1];
}

cv::Mat3f smoothed(const cv::Mat3f& log_colours) {
  cv::Mat3f smooth;
  cv::GaussianBlur(log_colours, smooth, {}, 0.8, 0.8, cv::BORDER_REPLICATE);
  return smooth;
}

ResidualNoise measureNoise(const cv::Mat3f& residual, const cv::Mat3f& bare, float bare_slope_px,
                           const cv::Mat1b& on_plate, const cv::Mat1b& shade) {
  // The plate's own texture, not only what the prediction misses of it: close to a sherd the plate
  // is seldom seen bare and its texture not predicted.
  const cv::Mat3f plate = bare + residual;
  const cv::Mat1f energy = calmestTexture(plate);
  std::vector<float> texture;
  std::vector<float> brightness, colour, level;
  for (int y = 0; y < residual.rows; y += 5)
    for (int x = 0; x < residual.cols; x += 5) {
      if (on_plate(y, x) == 0) continue;
      const float g = brightnessOf(residual(y, x));
      const cv::Vec2f c = colourOf(residual(y, x));
      if (std::abs(g) > 0.3F || c.dot(c) > 0.02F) continue;
      brightness.push_back(g);
      texture.push_back(energy(y, x));
      colour.push_back(c[0]);
      colour.push_back(c[1]);
      level.push_back(brightnessOf(bare(y, x)));
    }
  ResidualNoise noise;
  if (brightness.size() < 500) return noise;
  noise.texture = std::max(medianOf(texture), 1e-8F);
  noise.level = std::max(2.F, std::exp(medianOf(level)) - ground::kDarkLevel);
  // Not below what 8 bits leave: a third of a level after smoothing.
  const float rounding = 0.3F / (noise.level + ground::kDarkLevel);
  noise.brightness = std::max(robustDeviation(brightness), rounding);
  noise.colour = std::max(robustDeviation(colour), rounding);
  if (shade.empty()) return noise;
  const cv::Mat1f slope = slopeOf(bare);
  std::array<std::vector<float>, ResidualNoise::kDepths> excess;
  for (int y = 0; y < residual.rows; ++y)
    for (int x = 0; x < residual.cols; ++x) {
      if (shade(y, x) == 0) continue;
      const float darker =
          (noise.level + ground::kDarkLevel) * std::exp(-brightnessOf(plate(y, x)));
      const auto depth = static_cast<int>(std::log(darker) / ResidualNoise::kDepthStep + 0.5F);
      if (depth <= 0 || depth >= ResidualNoise::kDepths) continue;
      if (bare_slope_px * slope(y, x) > kUneven) continue;  // a shadow's border
      excess[static_cast<std::size_t>(depth)].push_back(
          energy(y, x) / (noise.texture * std::max(0.25F, darker * darker)));
    }
  noise.shade_texture = excessByDepth(excess);
  return noise;
}

Evidence weighEvidence(const cv::Mat3f& residual, const cv::Mat3f& bare, const ResidualNoise& noise,
                       float bare_slope_px) {
  Evidence evidence;
  evidence.residual = residual;
  evidence.log_odds.create(residual.size());
  evidence.clear.create(residual.size());
  const cv::Mat1f slope = slopeOf(bare);
  const cv::Mat1f texture = calmestTexture(residual);
  PixelRow row(residual.cols);
  const float level = std::log(noise.level + ground::kDarkLevel);
  for (int y = 0; y < residual.rows; ++y) {
    for (int x = 0; x < residual.cols; ++x) {
      const cv::Vec3f& v = residual(y, x);
      const cv::Vec2f c = colourOf(v);
      row.brightness[x] = brightnessOf(v);
      row.colour2[x] = c.dot(c);
      row.bare[x] = brightnessOf(bare(y, x));
      row.edge[x] = bare_slope_px * slope(y, x);
      row.in_shade[x] = noise.shadeTexture(level - row.bare[x] - std::min(row.brightness[x], 0.F));
    }
    weighRow(row, texture[y], noise, residual.cols, evidence.log_odds[y], evidence.clear[y]);
  }
  return evidence;
}

}  // namespace ostraka::mask
