#pragma once
#include "base/result.h"
#include "cloud/ply.h"
#include "texture/texture.h"

namespace ostraka::exchange {

/// A model with fewer triangles, for programs and networks that cannot take it whole. How far off
/// it is was measured from the vertices of each to the surface of the other.
struct LighterModel {
  TriangleMesh mesh;
  double deviation_mm = -1;  ///< all but one vertex in a thousand lie within this; < 0: it is whole
  double farthest_mm = -1;   ///< the farthest of those: as a rule a fold of noise that is gone
};

/// Thinned out until its GLB takes at most so many bytes, without photographs; what does already is
/// left as it is. Error: UnusableInput (not closed).
Result<LighterModel> lighterModel(const TriangleMesh& model, std::size_t most_bytes);

/// The photographs of a model on a lighter one of the same sherd: charts of its own, on which each
/// texel is what the model shows at the place nearest to it. mesh: closed, outward, mm. Error:
/// UnusableInput (not closed).
Result<texture::TexturedMesh> retextured(TriangleMesh mesh, const texture::TexturedMesh& model);

/// Where the corners of each triangle of a mesh of the same sherd lie in the model's picture: of a
/// triangle across the border of two charts, all in the one that its middle lies in.
CornerPlaces placesOn(const TriangleMesh& mesh, const texture::TexturedMesh& model);

/// Its photographs and its relief in so few texels that its GLB takes at most so many bytes.
void shrinkPhotographs(texture::TexturedMesh& model, std::size_t most_bytes);

}  // namespace ostraka::exchange
