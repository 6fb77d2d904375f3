#pragma once
#include <Eigen/Geometry>
#include <array>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

/// Registration methods of other papers, as the Point Cloud Library (PCL) has them. All take the
/// oriented points of the two sides' fracture strips, mm, each in the frame of its scan, and return
/// front_from_back. They draw from seeds of their own: the same input gives the same pose,
/// however many threads call them at once. Errors of all: Cancelled, NotEnough (fewer than 20
/// points are left of a side once it is thinned, or it has no normals), Failed (the method's own
/// criterion says that it did not converge).
namespace ostraka::baselines {

struct IcpOptions {
  double spacing_mm = 0.6;  ///< points are thinned to this: more only cost time
  double reach_mm = 3.0;    ///< pairs farther apart are left out: start poses hold to this
  double overlap =
      0.7;  ///< share of the pairs that is kept (trimmed ICP): strips share 0.6 and more
  int max_rounds = 400;  ///< point to point creeps in height along steep walls
};

/// Chetverikov, Svirko, Stepanov, Krsek: The trimmed iterative closest point algorithm, ICPR 2002:
/// each round keeps the nearest `overlap` of the pairs, back to front, point to point; the overlap
/// is given, not searched. Not converged: still moving by 0.001 mm after max_rounds.
Result<Eigen::Isometry3d> trimmedIcp(const PointCloud& front, const PointCloud& back,
                                     const Eigen::Isometry3d& start, const IcpOptions& options,
                                     std::stop_token stop);

/// Segal, Haehnel, Thrun: Generalized-ICP, RSS 2009: plane to plane, covariances of 20 neighbours.
Result<Eigen::Isometry3d> generalizedIcp(const PointCloud& front, const PointCloud& back,
                                         const Eigen::Isometry3d& start, const IcpOptions& options,
                                         std::stop_token stop);

using Feature = std::array<float, 33>;

/// Fast point feature histograms (Rusu, Blodow, Beetz, ICRA 2009), one for each point, over all
/// neighbours within the radius; zero where a point has none.
std::vector<Feature> pointFeatures(const PointCloud& cloud, double radius_mm);

struct FeatureRansacOptions {
  double spacing_mm = 0.8;         ///< points are thinned to this: each pose is tried on all
  double feature_radius_mm = 6.0;  ///< more than a strip is high: its bends along the edge count
  int max_rounds = 5000;           ///< 20000: median 0.38 instead of 0.54 mm in four times the time
  int nearest_features = 5;        ///< a point's partner is drawn from so many most alike
  double edge_similarity = 0.9;    ///< of the triangles' edges: others are not tried (Buch)
  double inlier_mm = 1.2;          ///< one and a half spacings
  double inlier_share = 0.4;       ///< a pose with fewer of the back's points as inliers is none
};

/// FPFH with RANSAC that rejects poses before it tries them: Buch, Kraft, Kaemaeraeinen, Petersen,
/// Krueger, ICRA 2013. Needs no start; its pose is not refined.
Result<Eigen::Isometry3d> featureRansac(const PointCloud& front, const PointCloud& back,
                                        const FeatureRansacOptions& options, std::stop_token stop);

struct FourPointOptions {
  double spacing_mm = 1.2;           ///< some 300 to 1100 points: quadruples are many
  double accuracy_mm = 0.5;          ///< delta: how far congruent points may lie off
  double overlap = 0.5;              ///< share of the back's points that must meet the front
  double max_normal_angle_deg = 30;  ///< by which normals may turn otherwise along a segment
  int samples = 300;                 ///< of the back, to look for quadruples and to test poses on
  int bases = 30;         ///< quadruples that are tried: a number, as time would not repeat itself
  int max_matches = 500;  ///< congruent quadruples that are tested for a base
};

/// Aiger, Mitra, Cohen-Or: 4-points congruent sets, SIGGRAPH 2008. No start; not refined.
Result<Eigen::Isometry3d> fourPointSets(const PointCloud& front, const PointCloud& back,
                                        const FourPointOptions& options, std::stop_token stop);

/// More quadruples of denser points, of which only corners are asked.
inline FourPointOptions keypointDefaults() {
  return {.spacing_mm = 0.3, .bases = 200};
}

/// Theiler, Wegner, Schindler: Keypoint-based 4-points congruent sets, ISPRS J. 2014, on Harris
/// corners of the normals (radius: four spacings). No start; not refined.
Result<Eigen::Isometry3d> keypointFourPointSets(const PointCloud& front, const PointCloud& back,
                                                const FourPointOptions& options,
                                                std::stop_token stop);

/// What every method checks of its two clouds, thinned.
Result<void> enoughPoints(const PointCloud& thinned_front, const PointCloud& thinned_back);
/// Failed, with what a person can do.
Error notConverged();

}  // namespace ostraka::baselines
