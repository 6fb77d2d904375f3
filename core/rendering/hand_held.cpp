#include "rendering/hand_held.h"

namespace ostraka::rendering {

Result<void> HandHeldOptions::check() const {
  const auto bad = [](Message what) { return Error::unusable(std::move(what)); };
  if (photographs < 3 || photographs > 400)
    return bad("hand_held must be between 3 and 400 photographs a side.");
  if (!(bend_mm >= 0 && bend_mm <= 20)) return bad("bend must be between 0 and 20 mm.");
  if (clutter < 0 || clutter > 4) return bad("clutter must be between 0 and 4 objects.");
  return {};
}

}  // namespace ostraka::rendering
