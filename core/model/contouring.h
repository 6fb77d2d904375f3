#pragma once
#include "cloud/point_cloud.h"
#include "model/indicator.h"

namespace ostraka::model {

/// The zero set of a grid (negative inside, positive on the whole border) as a closed, manifold,
/// outward mesh without normals: marching cubes whose polygons are traced along the cells' faces.
/// A face with four crossings always parts the outside corners, in both cells alike, so each edge
/// has two polygons and each vertex one fan. Polygons of more than four corners get a middle
/// vertex. Lorensen, Cline, SIGGRAPH 1987; the rule for faces after Nielson, Hamann, Visualization
/// 1991.
TriangleMesh contour(const Grid& distance);

/// Only the connected part that encloses the most.
TriangleMesh largestPart(const TriangleMesh& mesh);

}  // namespace ostraka::model
