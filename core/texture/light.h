#pragma once
#include <Eigen/Core>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"
#include "texture/view.h"

namespace ostraka::texture {

/// The irradiance of a diffuse surface by its normal, in the frame in which the lights stand still,
/// z up: spherical harmonics of second order, which hold 99 % of it whatever the lights
/// (Ramamoorthi, Hanrahan, An efficient representation for irradiance environment maps, SIGGRAPH
/// 2001).
struct Light {
  using Terms = Eigen::Matrix<double, 9, 1>;
  /// Of 1, x, y, z, xy, yz, 3z^2 - 1, xz, x^2 - y^2; a column each for blue, green and red.
  Eigen::Matrix<double, 9, 3> coefficients = Eigen::Matrix<double, 9, 3>::Zero();

  static Terms terms(const Eigen::Vector3d& normal);
  /// BGR, 1 for what faces up. Never below a fifth of that: what stands so dark has its light from
  /// what lies around it, which normals say nothing of.
  Eigen::Vector3d on(const Eigen::Vector3d& normal) const;
  /// What a level, BGR 0..255 of the sRGB curve, would be in the light of what faces up.
  Eigen::Vector3f without(const Eigen::Vector3f& level, const Eigen::Vector3d& normal) const;
};

/// A point of a sherd as the photographs show it.
struct LitPoint {
  struct Sample {
    int photograph = 0;      ///< counted over the batch
    Eigen::Vector3d normal;  ///< in the lights' frame
    Eigen::Vector3d light;   ///< linear BGR, 0..1, above 0
    double weight = 1;
  };
  int sherd = 0;
  std::vector<Sample> samples;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< on the sherd, mm
};

/// Some points of a sherd, at most `most`, spread over its surface. mesh: closed, with normals, mm;
/// views: of this sherd. What is clipped, next to black or at an outline is left out.
std::vector<LitPoint> litPoints(const TriangleMesh& mesh, const std::vector<View>& views, int sherd,
                                std::size_t most, int threads);

/// The light of a batch, and how well it is known.
struct LightFit {
  Light light;
  /// Relative, one standard deviation, RMS over what the samples show, of the worst channel: twice
  /// this is to cover 95 % of the errors (89 % over random lights, light_test.cpp).
  double uncertainty = 0;
  double residual = 0;  ///< relative, robust standard deviation of a sample
};

/// The light that explains why points look brighter in one photograph than in another: on a plate
/// that turns they face the lights in turn, and what both sides show faces up and down. Logarithms
/// of the irradiance, of one albedo a point and one exposure a photograph and channel, by robust
/// least squares (Gauss and Newton; Cauchy weights for highlights and cast shadows), albedos
/// eliminated. Samples of a point share the error of its normal, and those of a place its shadow,
/// so their number says little: the uncertainty is that of the jackknife by groups (Quenouille;
/// Efron, The jackknife, the bootstrap and other resampling plans, SIAM 1982), ten of places
/// 10 mm apart or of whole sherds where there are six, or, where it is larger, that of independent
/// samples; with what the pull towards even light takes away. Light that no normal tells of, and
/// what is the same for all sherds (gloss), is not in it. Errors: NotEnough where it is above 3 %:
/// a light that no point tells of would be invented.
Result<LightFit> lightOf(const std::vector<LitPoint>& points);

}  // namespace ostraka::texture
