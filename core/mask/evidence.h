#pragma once
#include <array>
#include <opencv2/core/mat.hpp>

namespace ostraka::mask {

/// What one pixel says by itself, against the bare plate as it should look there.
struct Evidence {
  cv::Mat3f residual;  ///< log photograph - log bare plate, both smoothed
  cv::Mat1f log_odds;  ///< log P(residual | sherd) / P(residual | plate, lit or in shadow)
  cv::Mat1f clear;     ///< 0..1: certainly bare, lit plate seen, so nothing stands in the ray's way
};

/// Noise of the residual as a function of the photograph's brightness, measured on what looks bare.
struct ResidualNoise {
  float brightness = 0.05F;  ///< SD of the mean of the channels, log, at the plate's own brightness
  float colour = 0.02F;      ///< SD of each of the two colour differences
  float texture = 1e-4F;     ///< median energy of fine structure, any direction, on the bare plate
  float level = 40;          ///< the brightness (0..255) at which they were measured
  static constexpr int kDepths = 16;
  static constexpr float kDepthStep = 0.1F;  ///< of log darkness, 0: lit
  /// How much more fine structure there is in shadows than such noise explains, by their depth, in
  /// units of what it explains; 0: no more.
  std::array<float, kDepths> shade_texture{};
  /// All that there is in them: 1 + the same at any depth (log bare lit plate - log what is seen).
  float shadeTexture(float depth) const;
};

/// Sigma 0.8 pixels, about the lens's own blur, so outlines stay in place.
cv::Mat3f smoothed(const cv::Mat3f& log_colours);

/// bare_slope_px: by how many pixels the bare plate's edges may be misplaced (pose, sampling).
/// on_plate: where to measure: the plate inside the markers. shade: where the plate is known to lie
/// bare in a shadow that `bare` has too; empty where none is known.
ResidualNoise measureNoise(const cv::Mat3f& residual, const cv::Mat3f& bare, float bare_slope_px,
                           const cv::Mat1b& on_plate, const cv::Mat1b& shade = {});

/// A shadow scales all channels alike and keeps the plate's texture; clay changes colour, or
/// brightens, or shows a texture of its own. bare_slope_px: as for measureNoise.
Evidence weighEvidence(const cv::Mat3f& residual, const cv::Mat3f& bare, const ResidualNoise& noise,
                       float bare_slope_px);

}  // namespace ostraka::mask
