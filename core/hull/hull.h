#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "rig/camera.h"

namespace ostraka::hull {

/// Which space the hull is carved from: a box of cubic voxels.
struct HullSpace {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  ///< centre of the first voxel
  double pitch = 1;                               ///< edge of a voxel, in the cameras' unit
  Eigen::Vector3i count = Eigen::Vector3i::Zero();
  double radius = 0;  ///< > 0: only the cylinder of this radius around the z axis
};

/// A view's evidence, reduced by `reduction` pixels per sample.
struct HullView {
  const rig::PosedImage* image = nullptr;
  cv::Mat1f inside;  ///< 0..1: certainly foreground
  cv::Mat1f clear;   ///< 0..1: certainly background
};

struct HullOptions {
  int threads = 1;
  int reduction = 4;           ///< pixels per sample of the views' evidence
  double carving_views = 2;    ///< so many views that see through a voxel empty it
  double inside_share = 0.15;  ///< share of the views that must see it as foreground
};

/// 1 for each voxel that stays; index (z * count.y + y) * count.x + x.
std::vector<unsigned char> carveHull(const HullSpace& space, std::span<const HullView> views,
                                     const HullOptions& options, std::stop_token stop);

/// How the hull shows in a view, reduced; grown by half a voxel.
struct Silhouette {
  cv::Mat1b group;   ///< the value of the nearest voxel, 0 where there is none
  cv::Mat1f depth;   ///< from the nearest voxel to the farthest, in the cameras' unit
  cv::Mat1f height;  ///< of the nearest voxel above the space's floor; 0 where there is none
};
Silhouette silhouetteOfHull(const HullSpace& space, const std::vector<unsigned char>& voxels,
                            const HullView& view, const HullOptions& options);

/// Takes away connected parts of a silhouette that nowhere show before the floor: a sherd's foot
/// does, however far its top leans over what lies beyond. floor: as large, 255 where it shows.
void keepTouching(const cv::Mat1b& floor, cv::Mat1b& group);

inline constexpr int kMostGroups = 255;   ///< more share numbers
inline constexpr int kMostGapLayers = 3;  ///< a stripe of the ground's colour around a thing

/// Takes away voxels from which no way leads down to the floor (rays that cross by chance where
/// nothing is known of what lies behind), kMostGapLayers empty layers between at most, then groups
/// (connected seen from above) with a footprint below min_area. Returns how many groups are left
/// and gives their voxels the group's number, 1, 2, ... kMostGroups.
int dropSmallGroups(const HullSpace& space, std::vector<unsigned char>& voxels, double min_area);

/// Whether the hull leaves the floor bare at (x, y): its lowest layer is empty there. False beyond
/// the space, of which nothing is known.
bool bareAt(const HullSpace& space, const std::vector<unsigned char>& voxels,
            const Eigen::Vector2d& p);

/// Takes away numbered groups that reach a side of the space, unless all of them do: where nothing
/// says what the ground is beyond, such a group is mostly that.
void dropGroupsAtSides(const HullSpace& space, std::vector<unsigned char>& voxels);

}  // namespace ostraka::hull
