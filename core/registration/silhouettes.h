#pragma once
#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "registration/evidence.h"
#include "registration/outline.h"
#include "registration/register_sides.h"
#include "registration/strip.h"

namespace ostraka::registration {

/// Registered sides must fill the outlines of the photographs of both shots to sub-pixel. In the
/// front's photographs the back moves, in the back's the front; what is alike around an outline
/// (fat strips, soft masks) is taken out.
class SilhouetteConstraint {
 public:
  /// Cuts the views' outlines once around the sherd. front_from_back: good to a millimetre.
  SilhouetteConstraint(const Strip& front, const Strip& back,
                       std::span<const SilhouetteView> front_views,
                       std::span<const SilhouetteView> back_views,
                       const Eigen::Isometry3d& front_from_back, int threads);
  ~SilhouetteConstraint();

  /// reach_px shrinks from round to round. sigma is in pixels.
  OutlineFit evidence(const Eigen::Isometry3d& front_from_back, const Eigen::Vector3d& pivot,
                      double reach_px) const;

 private:
  struct View;
  int threads_;
  std::vector<View> views_;
  std::array<double, 2> excess_px_{};  ///< of the still side over its masks: front's, back's shot
};

}  // namespace ostraka::registration
