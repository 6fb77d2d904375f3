#pragma once
#include <Eigen/Core>

#include "vessels/gloss.h"
#include "vessels/noise.h"

namespace ostraka::vessels {

/// Where on its vessel a point of a sherd lies.
struct ClayPlace {
  float around_mm = 0;  ///< along the parallel, scaled to a radius of 60 mm
  float up_mm = 0;      ///< arc length of the profile from the base's centre
  float depth = 0;      ///< 0 outer, 1 inner surface
  float broken = 0;     ///< 1 on the break
};

enum class Paint { None, Bands, Waves, Zigzag };

/// The look of a vessel's clay. Colours are linear albedos, red, green, blue.
struct Clay {
  Eigen::Vector3f body, core, slip, paint_color;
  float core_strength = 0;  ///< 0..1, how grey the middle of the wall fired
  bool slip_outside = false, slip_inside = false;
  float slip_worn = 0.3f;  ///< share of the slip that has flaked off
  Paint paint = Paint::None;
  float paint_period_mm = 12, paint_width_mm = 2, paint_phase_mm = 0;
  float grain = 0.1f;        ///< relative brightness of the finest grain
  float mottle = 0.12f;      ///< relative brightness of clouds of some mm
  float temper = 0.08f;      ///< share of cells with an inclusion
  float temper_mm = 1.6f;    ///< cell of the coarse temper
  float roughness = 0.45f;   ///< slope of the relief finer than the mesh, on the break
  float pits_per_mm = 1.3f;  ///< darkening of that relief's pits, per mm of its height at slope 1
  Gloss shine;               ///< of the slip, or of the whole face where it was burnished
  bool burnished = false;    ///< no slip: the face itself was rubbed until it shone
  std::uint32_t seed = 0;
};

/// plain: neither slip nor paint, one colour with fine temper only.
Clay makeClay(bool plain, Random& random);
/// Black, grey and white clays and slips among the usual ones; a share of all shines.
void widen(Clay& clay, double shiny_share, Random& random);

struct ClaySample {
  Eigen::Vector3f albedo;
  Eigen::Vector3f slope;  ///< to be taken from the unit normal before normalising: fine relief
  float glitter = 0;      ///< relative SD of one sample's light from view to view
  Gloss shine;
};
/// p_model: mm in the sherd's model frame.
ClaySample sampleClay(const Clay& clay, const Eigen::Vector3f& p_model, const ClayPlace& place);

}  // namespace ostraka::vessels
