#include "virtualrig/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ostraka::virtualrig {
namespace {

constexpr int kSteps = 4096;  // of brightness: finer than 1/8 of an 8-bit step at the dark end

std::array<float, kSteps + 1> sRgbTable() {
  std::array<float, kSteps + 1> table;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = static_cast<double>(i) / kSteps;
    table[i] = static_cast<float>(
        255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055));
  }
  return table;
}

std::uint8_t encoded(float linear, const std::array<float, kSteps + 1>& table) {
  const float x = std::clamp(linear, 0.f, 0.99999f) * kSteps;
  const int i = static_cast<int>(x);
  const float v = table[i] + (x - static_cast<float>(i)) * (table[i + 1] - table[i]);
  return static_cast<std::uint8_t>(v + 0.5f);
}

std::vector<float> gaussian(double sigma) {
  const int radius = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
  std::vector<float> kernel;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) sum += std::exp(-0.5 * i * i / (sigma * sigma));
  for (int i = -radius; i <= radius; ++i)
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / sum));
  return kernel;
}

// Separable; borders repeat the outermost pixel.
void blur(std::vector<float>& pixels, int width, int height, double sigma) {
  const std::vector<float> kernel = gaussian(sigma);
  const int radius = static_cast<int>(kernel.size()) / 2, row = width * 3;
  std::vector<float> across(pixels.size());
  std::vector<float> padded(static_cast<std::size_t>(row) + 6 * radius);
  for (int y = 0; y < height; ++y) {
    const float* in = &pixels[static_cast<std::size_t>(y) * row];
    for (int i = 0; i < 3 * radius; ++i) {
      padded[i] = in[i % 3];
      padded[3 * radius + row + i] = in[row - 3 + i % 3];
    }
    std::copy(in, in + row, padded.begin() + 3 * radius);
    float* out = &across[static_cast<std::size_t>(y) * row];
    for (int k = 0; k <= 2 * radius; ++k)
      for (int x = 0; x < row; ++x) out[x] += kernel[k] * padded[x + 3 * k];
  }
  std::fill(pixels.begin(), pixels.end(), 0.f);
  for (int y = 0; y < height; ++y) {
    float* out = &pixels[static_cast<std::size_t>(y) * row];
    for (int k = 0; k <= 2 * radius; ++k) {
      const float* in =
          &across[static_cast<std::size_t>(std::clamp(y + k - radius, 0, height - 1)) * row];
      for (int x = 0; x < row; ++x) out[x] += kernel[k] * in[x];
    }
  }
}

}  // namespace

cv::Mat develop(std::vector<float>& linear, int width, int height, const Sensor& sensor,
                std::uint64_t seed) {
  const float cx = static_cast<float>(width - 1) / 2, cy = static_cast<float>(height - 1) / 2;
  const float corner = cx * cx + cy * cy;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const float dx = static_cast<float>(x) - cx, dy = static_cast<float>(y) - cy;
      const float gain = 1 - static_cast<float>(sensor.vignette) * (dx * dx + dy * dy) / corner;
      for (int c = 0; c < 3; ++c) linear[3 * i + c] *= gain;
    }
  blur(linear, width, height, sensor.blur_px);
  static const std::array<float, kSteps + 1> table = sRgbTable();
  cv::Mat image(height, width, CV_8UC3);
  const auto shot = static_cast<float>(sensor.shot_noise),
             read = static_cast<float>(sensor.read_noise * sensor.read_noise);
  for (int y = 0; y < height; ++y) {
    auto* out = image.ptr<std::uint8_t>(y);
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const std::uint64_t h = mixed(seed + 1, i);
      for (int c = 0; c < 3; ++c) {
        const float v = linear[3 * i + c];
        const float noisy =
            v + std::sqrt(shot * v + read) * quickNormal(mixed(h + static_cast<std::uint64_t>(c)));
        out[3 * x + 2 - c] = encoded(noisy, table);
      }
    }
  }
  return image;
}

}  // namespace ostraka::virtualrig
