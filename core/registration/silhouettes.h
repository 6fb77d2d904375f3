#pragma once
#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "registration/evidence.h"
#include "registration/outline.h"
#include "registration/register_sides.h"
#include "registration/strip.h"

namespace ostraka::registration {

struct SilhouetteOptions {
  double blur_px = 1.5;        ///< picture and points alike, so that corners shrink alike
  double reach_px = 6;         ///< start poses from the strips hold to a millimetre
  double margin_px = 0.5;      ///< the side that moves counts where the other ends this far inside:
                               ///< a mask holds to half a pixel
  double min_sigma_px = 0.25;  ///< masks' edges hold to a quarter of a pixel
  double correlation_px = 12;  ///< a bump of the scan's end shows in several pixels ...
  double views_alike = 3;      ///< ... and in as many of 24 views, by chi-square at true poses
  double fatness_px = 0.5;     ///< SD of the moving side's excess over the mask about the still's
  double lower_px = 0.5;       ///< SD of what outlines that face down err beside it: scans hang
                               ///< skirts there, masks take in the shadow under a sherd
};

/// Registered sides must fill the outlines of the photographs of both shots to sub-pixel. In the
/// front's photographs the back moves, in the back's the front; what is alike around an outline
/// (fat strips, soft masks) is taken out.
class SilhouetteConstraint {
 public:
  /// Cuts the views' outlines once around the sherd. front_from_back: good to a millimetre.
  SilhouetteConstraint(const Strip& front, const Strip& back,
                       std::span<const SilhouetteView> front_views,
                       std::span<const SilhouetteView> back_views,
                       const Eigen::Isometry3d& front_from_back, const SilhouetteOptions& options,
                       int threads);
  ~SilhouetteConstraint();

  /// reach_px shrinks from round to round. sigma is in pixels.
  OutlineFit evidence(const Eigen::Isometry3d& front_from_back, const Eigen::Vector3d& pivot,
                      double reach_px) const;

 private:
  struct View;
  SilhouetteOptions options_;
  int threads_;
  std::vector<View> views_;
  std::array<double, 2> excess_px_{};  ///< of the still side over its masks: front's, back's shot
};

}  // namespace ostraka::registration
