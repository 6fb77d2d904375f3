#pragma once
#include <optional>

#include "cloud/points_and_meshes.h"
#include "colour/correction.h"
#include "colour/munsell_proposals.h"
#include "texture/texture.h"

namespace ostraka::texture {

/// The colour of each part of a sherd, sRGB: per channel the median, in linear light, of the texels
/// that photographs show; none where they show too little of it.
struct SherdColours {
  std::optional<Color> outer, inner, fracture;
  bool front_is_outer = true;
};

/// Parts as the texture's charts divide a sherd (partsOf). The outer face is the one that bulges;
/// on a flat sherd either may be.
SherdColours coloursOf(const TexturedMesh& model);
/// What these colours propose: measured where a chart corrected the photographs, else rough.
colour::MunsellProposals munsellOf(const TexturedMesh& model,
                                   const std::optional<colour::Correction>& correction);

}  // namespace ostraka::texture
