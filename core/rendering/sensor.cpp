#include "rendering/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ostraka::rendering {
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

float encoded(float linear, const std::array<float, kSteps + 1>& table) {
  const float x = std::clamp(linear, 0.f, 0.99999f) * kSteps;
  const int i = static_cast<int>(x);
  return table[i] + (x - static_cast<float>(i)) * (table[i + 1] - table[i]);
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

// Separable; borders repeat the outermost pixel. n: values of a pixel.
void blur(std::vector<float>& pixels, int n, int width, int height, double sigma) {
  const std::vector<float> kernel = gaussian(sigma);
  const int radius = static_cast<int>(kernel.size()) / 2, row = width * n;
  std::vector<float> across(pixels.size());
  std::vector<float> padded(static_cast<std::size_t>(row) + 2 * n * radius);
  for (int y = 0; y < height; ++y) {
    const float* in = &pixels[static_cast<std::size_t>(y) * row];
    for (int i = 0; i < n * radius; ++i) {
      padded[i] = in[i % n];
      padded[n * radius + row + i] = in[row - n + i % n];
    }
    std::copy(in, in + row, padded.begin() + n * radius);
    float* out = &across[static_cast<std::size_t>(y) * row];
    for (int k = 0; k <= 2 * radius; ++k)
      for (int x = 0; x < row; ++x) out[x] += kernel[k] * padded[x + n * k];
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

// The mean along a straight line about each pixel, so that nothing shifts.
void smear(std::vector<float>& pixels, int width, int height, const Eigen::Vector2d& motion_px) {
  const int taps = 2 * static_cast<int>(std::ceil(motion_px.norm())) + 1;
  std::vector<float> out(pixels.size(), 0.f);
  for (int k = 0; k < taps; ++k) {
    const Eigen::Vector2d d = ((k + 0.5) / taps - 0.5) * motion_px;
    const int dx = static_cast<int>(std::floor(d.x())), dy = static_cast<int>(std::floor(d.y()));
    const auto u = static_cast<float>(d.x() - dx), v = static_cast<float>(d.y() - dy);
    const std::array<float, 4> weights{
        (1 - u) * (1 - v) / static_cast<float>(taps), u * (1 - v) / static_cast<float>(taps),
        (1 - u) * v / static_cast<float>(taps), u * v / static_cast<float>(taps)};
    for (int y = 0; y < height; ++y)
      for (int c = 0; c < 4; ++c) {
        const int from_y = std::clamp(y + dy + c / 2, 0, height - 1);
        const float* in = &pixels[static_cast<std::size_t>(from_y) * width * 3];
        float* row = &out[static_cast<std::size_t>(y) * width * 3];
        for (int x = 0; x < width; ++x) {
          const int from = 3 * std::clamp(x + dx + c % 2, 0, width - 1);
          for (int i = 0; i < 3; ++i) row[3 * x + i] += weights[c] * in[from + i];
        }
      }
  }
  pixels = std::move(out);
}

// Adds what the brightness has more than its surroundings of a pixel and a half.
void sharpen(std::vector<float>& pixels, int width, int height, double share) {
  std::vector<float> brightness(static_cast<std::size_t>(width) * height);
  for (std::size_t i = 0; i < brightness.size(); ++i)
    brightness[i] =
        0.299f * pixels[3 * i] + 0.587f * pixels[3 * i + 1] + 0.114f * pixels[3 * i + 2];
  std::vector<float> blurred = brightness;
  blur(blurred, 1, width, height, 1.3);
  for (std::size_t i = 0; i < brightness.size(); ++i)
    for (int c = 0; c < 3; ++c)
      pixels[3 * i + c] += static_cast<float>(share) * (brightness[i] - blurred[i]);
}

}  // namespace

double expose(std::vector<float>& linear, int width, int height, const Sensor& sensor) {
  if (sensor.exposure_aim <= 0) return 1;
  std::vector<float> brightness;
  for (int y = 4; y < height; y += 8)
    for (int x = 4; x < width; x += 8) {
      const float* p = &linear[(static_cast<std::size_t>(y) * width + x) * 3];
      brightness.push_back(0.25f * p[0] + 0.6f * p[1] + 0.15f * p[2]);
    }
  const auto high = brightness.begin() + static_cast<std::ptrdiff_t>(brightness.size() * 19 / 20);
  std::nth_element(brightness.begin(), high, brightness.end());
  const double gain = sensor.exposure_aim / std::max(1e-4f, *high) * sensor.exposure;
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] *= static_cast<float>(gain) * sensor.balance[static_cast<long>(i % 3)];
  return gain;
}

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
  if (sensor.motion_px.norm() > 0.1) smear(linear, width, height, sensor.motion_px);
  blur(linear, 3, width, height, sensor.blur_px);
  static const std::array<float, kSteps + 1> table = sRgbTable();
  const auto shot = static_cast<float>(sensor.shot_noise),
             read = static_cast<float>(sensor.read_noise * sensor.read_noise);
  for (std::size_t i = 0; i < linear.size() / 3; ++i) {
    const std::uint64_t h = vessels::mixed(seed + 1, i);
    for (int c = 0; c < 3; ++c) {
      float& v = linear[3 * i + c];
      const float noise = vessels::quickNormal(vessels::mixed(h + static_cast<std::uint64_t>(c)));
      v = encoded(v + std::sqrt(shot * v + read) * noise, table);
    }
  }
  if (sensor.sharpening > 0) sharpen(linear, width, height, sensor.sharpening);
  cv::Mat image(height, width, CV_8UC3);
  for (int y = 0; y < height; ++y) {
    auto* out = image.ptr<std::uint8_t>(y);
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        out[3 * x + 2 - c] = static_cast<std::uint8_t>(
            std::clamp(linear[(static_cast<std::size_t>(y) * width + x) * 3 + c], 0.f, 255.f) +
            0.5f);
  }
  return image;
}

}  // namespace ostraka::rendering
