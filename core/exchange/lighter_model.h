#pragma once
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "texture/texture.h"

namespace ostraka::exchange {

/// A model with fewer triangles, for programs and networks that cannot take it whole. How far off
/// it is was measured from the vertices of each to the surface of the other.
struct LighterModel {
  TriangleMesh mesh;
  double deviation_mm = 0;  ///< all but one vertex in a thousand lie within this
  double farthest_mm = 0;   ///< the farthest of those: as a rule a fold of noise that is gone
};

/// Thinned out as far as deviation_mm allows; where four attempts do not reach that, the model
/// itself. Errors: UnusableInput (not closed, no deviation above 0).
Result<LighterModel> lighterModel(const TriangleMesh& model, double deviation_mm);

/// The photographs of a model on a lighter one of the same sherd: charts of its own, on which each
/// texel is what the model shows at the place nearest to it. mesh: closed, outward, mm. Error:
/// UnusableInput (not closed).
Result<texture::TexturedMesh> retextured(TriangleMesh mesh, const texture::TexturedMesh& model);

}  // namespace ostraka::exchange
