#pragma once
#include <Eigen/Geometry>
#include <stop_token>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka::model {

struct ModelOptions {
  /// Distance between the points that the surface is made from, mm; denser clouds are thinned to
  /// it. 0 takes that of the scans; where it is below 0.28, twice that, 0.28 at most: points of
  /// stereo that are so near repeat each other's noise.
  double point_spacing_mm = 0;
  /// Edge of the grid's cells, mm; 0 takes three quarters of the spacing, 0.28 to 0.45, or the
  /// spacing itself where that is below: finer than the points brings no detail, coarser chamfers
  /// the broken edges. Larger where the grid would take more than 500 MB.
  double cell_mm = 0;
  /// A vertex is seen when a scan point lies within this many spacings (never below 0.5 mm).
  double seen_spacings = 2.0;
  int threads = 1;  ///< <= 0: all processors; the result does not depend on it
};

/// One whole sherd.
struct SherdModel {
  TriangleMesh mesh;      ///< closed, manifold, outward; frame of the front scan, mm; with normals
                          ///< and seen flags, with colours when a scan has them
  double area_mm2 = 0;    ///< of the whole mesh
  double filled_mm2 = 0;  ///< area of the faces with an unseen vertex
  double filled_share = 0;  ///< filled_mm2 / area_mm2
  double noise_mm = 0;      ///< median scatter of the scans' points about the surface
  double side_gap_mm =
      0;  ///< median distance between the sides where both saw the surface; 0 when nowhere
  int points_used = 0;     ///< scan points that the surface was made from (after thinning)
  int points_dropped = 0;  ///< flying points left aside
};

/// Both sides into one closed surface. front and back need normals (outward); back is taken to the
/// front's frame by front_from_back. Errors: Cancelled, UnusableInput (no normals, options),
/// NotEnough (too few points, no closed surface). About 1.5 s per 2000 mm^2 on one core for points
/// 0.15 mm apart, 5 s for points 0.08 mm apart.
/// Points are smoothed along robust local fits weighted by their own scatter; what is inside comes
/// from a Poisson equation on a grid (Kazhdan et al., SGP 2006); the surface itself is the zero set
/// of robust implicit moving least squares (Oeztireli et al., Eurographics 2009).
Result<SherdModel> closeModel(const PointCloud& front, const PointCloud& back,
                              const Eigen::Isometry3d& front_from_back, const ModelOptions& options,
                              Progress& progress, std::stop_token stop);

/// The figures of a closed mesh. Lengths in mm.
struct Measures {
  double length_mm = 0;  ///< longer side of the smallest rectangle around the sherd, seen along the
                         ///< least principal axis of its surface (its own plane)
  double width_mm = 0;   ///< shorter side of that rectangle
  /// Thickness: length of the wall along rays that enter one of its faces (turned by at most 60
  /// degrees from the sherd's plane: no break) against the normal and leave through the other
  /// (within 30 degrees of parallel: no oblique break either), one per about 1 mm^2. min and max
  /// are the 2nd and 98th percentile. 0 when no ray meets a wall.
  double thickness_min_mm = 0, thickness_mean_mm = 0, thickness_max_mm = 0;
  double area_mm2 = 0;
  double holes_mm2 = 0;  ///< of what one sees right through the sherd, along the axis of its plane:
                         ///< drilled holes, or places that no camera saw; single ones above 1 mm^2
  double volume_mm3 = 0;                               ///< positive for outward faces
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the volume
};
Measures measure(const TriangleMesh& mesh);

/// Fewer triangles by collapsing edges as long as the quadric error (distance from the planes of
/// the faces that were there) stays within max_deviation_mm; closed and manifold as before, colours
/// and seen flags kept. Errors: UnusableInput. Garland, Heckbert, SIGGRAPH 1997.
Result<TriangleMesh> decimated(const TriangleMesh& mesh, double max_deviation_mm);

/// Each edge is used once in each direction, each vertex has one fan of triangles, no triangle is
/// degenerate in its indices, none is repeated. `why` says in words what is wrong first.
bool isClosedManifold(const TriangleMesh& mesh, Message* why = nullptr);

/// What is larger than any vessel (limits::kModelExtent_mm) or smaller than any sherd (3 mm) is in
/// another unit than mm; a raster over the former would take all memory. where: names it in the
/// error. Error: UnusableInput.
Result<void> checkExtent(const TriangleMesh& mesh, const std::string& where);

/// The pixels over a rectangle: per_mm of them to a mm, or fewer where those would be more than
/// limits::kRasterPixels or a side longer than limits::kImageSide.
struct Raster {
  int columns = 0, rows = 0;
  double per_mm = 1;
};
Raster rasterOver(const Eigen::Vector2d& size_mm, double per_mm);

/// Outward unit normals per vertex, weighted by the triangles' angles.
std::vector<Eigen::Vector3f> vertexNormals(const TriangleMesh& mesh);

}  // namespace ostraka::model
