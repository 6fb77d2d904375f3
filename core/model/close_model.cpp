#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "base/parallel.h"
#include "model/blocks.h"
#include "model/contouring.h"
#include "model/indicator.h"
#include "model/model.h"
#include "model/surface_field.h"
#include "model/surfels.h"

namespace ostraka::model {
namespace {

using Eigen::Array3i;
using Eigen::Vector3f;

// The field at every node of a finer grid: measured near surfels, from the indicator elsewhere.
class FineGrid {
 public:
  FineGrid(const SurfaceField& field, const Grid& coarse, float cell_mm) : field_(field) {
    grid_.cell_mm = cell_mm;
    grid_.origin = coarse.origin;
    grid_.size =
        ((coarse.size - 1).cast<float>() * (coarse.cell_mm / cell_mm)).floor().cast<int>() + 1;
    grid_.values.resize(static_cast<std::size_t>(grid_.size[0]) * grid_.size[1] * grid_.size[2]);
    measured_.assign(grid_.values.size(), 0);
  }

  bool fill(const Surfels& surfels, int threads, std::stop_token stop) {
    const std::size_t layer = static_cast<std::size_t>(grid_.size[0]) * grid_.size[1];
    parallelFor(static_cast<std::size_t>(grid_.size[2]), threads, [&](std::size_t z) {
      for (std::size_t k = 0; k < layer && !stop.stop_requested(); ++k)
        grid_.values[z * layer + k] = field_.farDistance(position(z * layer + k));
    });
    std::vector<std::size_t> wanted = nodesAround(surfels);
    // The measured sheet may leave the band where the indicator is far off: follow it.
    for (int round = 0; round < 40 && !wanted.empty(); ++round) {
      if (!inBlocks<Nothing>(wanted.size(), threads, stop, [&](std::size_t i, Nothing) {
            grid_.values[wanted[i]] = field_.sample(position(wanted[i])).distance;
          }))
        return false;
      wanted = openNeighbours(wanted);
    }
    closeBorder();
    return !stop.stop_requested();
  }

  const Grid& grid() const { return grid_; }

 private:
  Vector3f position(std::size_t node) const {
    const std::size_t row = static_cast<std::size_t>(grid_.size[0]);
    const std::size_t y = node / row;
    return grid_.node(static_cast<int>(node % row), static_cast<int>(y % grid_.size[1]),
                      static_cast<int>(y / grid_.size[1]));
  }

  std::vector<std::size_t> nodesAround(const Surfels& surfels) {
    std::vector<std::size_t> nodes;
    for (const Vector3f& p : surfels.points) {
      const Array3i base = ((p - grid_.origin) / grid_.cell_mm).array().floor().cast<int>() - 1;
      for (int k = 0; k < 64; ++k) {
        const Array3i at = base + Array3i(k & 3, (k >> 2) & 3, k >> 4);
        if ((at < 1).any() || (at + 1 >= grid_.size).any()) continue;
        const std::size_t node = grid_.at(at[0], at[1], at[2]);
        if (!measured_[node]) nodes.push_back(node);
        measured_[node] = 1;
      }
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  // Nodes not yet measured beyond an edge on which the sign changes.
  std::vector<std::size_t> openNeighbours(const std::vector<std::size_t>& nodes) {
    const std::ptrdiff_t row = grid_.size[0], layer = row * grid_.size[1];
    std::vector<std::size_t> open;
    for (const std::size_t node : nodes)
      for (const std::ptrdiff_t step :
           {-layer, -row, std::ptrdiff_t{-1}, std::ptrdiff_t{1}, row, layer}) {
        const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(node) + step;
        if (next < 0 || next >= static_cast<std::ptrdiff_t>(measured_.size()) || measured_[next])
          continue;
        if ((grid_.values[node] < 0) == (grid_.values[next] < 0)) continue;
        measured_[next] = 1;
        open.push_back(static_cast<std::size_t>(next));
      }
    std::sort(open.begin(), open.end());
    return open;
  }

  void closeBorder() {
    const Array3i& n = grid_.size;
    for (std::size_t k = 0; k < grid_.values.size(); ++k) {
      const int x = static_cast<int>(k % n[0]), y = static_cast<int>(k / n[0] % n[1]);
      const int z = static_cast<int>(k / n[0] / n[1]);
      if (x == 0 || y == 0 || z == 0 || x == n[0] - 1 || y == n[1] - 1 || z == n[2] - 1)
        grid_.values[k] = std::max(grid_.values[k], 0.1f * grid_.cell_mm);
    }
  }

  const SurfaceField& field_;
  Grid grid_;
  std::vector<std::uint8_t> measured_;
};

// Takes the vertices onto the zero set itself: the grid's straight cuts chamfer edges.
bool ontoSurface(TriangleMesh& mesh, const SurfaceField& field, float cell_mm, int threads,
                 std::stop_token stop) {
  return inBlocks<Nothing>(mesh.vertices.size(), threads, stop, [&](std::size_t v, Nothing) {
    const Vector3f start = mesh.vertices[v];
    for (int round = 0; round < 2; ++round) {
      const FieldSample s = field.sample(mesh.vertices[v]);
      if (s.support < 0.1f) return;
      const Vector3f moved = mesh.vertices[v] - s.distance * s.gradient;
      if ((moved - start).norm() > 0.5f * cell_mm) return;
      mesh.vertices[v] = moved;
    }
  });
}

bool markSeen(TriangleMesh& mesh, const Surfels& surfels, float reach_mm, int threads,
              std::stop_token stop) {
  const PointBins bins(surfels.points, reach_mm);
  mesh.seen.assign(mesh.vertices.size(), 0);
  return inBlocks<Nothing>(mesh.vertices.size(), threads, stop, [&](std::size_t v, Nothing) {
    bins.within(mesh.vertices[v], reach_mm, [&](int j, float) {
      // The other face of a thin wall is no witness.
      if (surfels.normals[static_cast<std::size_t>(j)].dot(mesh.normals[v]) > 0) mesh.seen[v] = 1;
    });
  });
}

// Colours of the scans' own points, blended by nearness and by how squarely they face the vertex.
bool paint(TriangleMesh& mesh, const PointCloud& front, const PointCloud& back, float reach_mm,
           int threads, std::stop_token stop) {
  PointCloud all;
  for (const PointCloud* side : {&front, &back}) {
    if (side->colors.size() != side->size()) continue;
    all.points.insert(all.points.end(), side->points.begin(), side->points.end());
    all.normals.insert(all.normals.end(), side->normals.begin(), side->normals.end());
    all.colors.insert(all.colors.end(), side->colors.begin(), side->colors.end());
  }
  if (all.empty()) return true;
  const PointBins bins(all.points, reach_mm);
  mesh.colors.assign(mesh.vertices.size(), Color{});
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Color& c : all.colors) mean += Eigen::Vector3d(c[0], c[1], c[2]);
  mean /= static_cast<double>(all.size());
  return inBlocks<Nothing>(mesh.vertices.size(), threads, stop, [&](std::size_t v, Nothing) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float weight = 0;
    // Filled places take the colour around them, farther and farther away.
    for (float reach = reach_mm; weight <= 0 && reach < 20; reach *= 2)
      bins.within(mesh.vertices[v], reach, [&](int j, float d2) {
        const float facing = all.normals[static_cast<std::size_t>(j)].dot(mesh.normals[v]);
        if (facing <= 0.1f) return;
        const float u = 1 - d2 / (reach * reach);
        const float w = u * u * u * u * facing + 1e-9f;
        const Color& c = all.colors[static_cast<std::size_t>(j)];
        sum += w * Eigen::Vector3f(c[0], c[1], c[2]);
        weight += w;
      });
    const Eigen::Vector3f level =
        weight > 0 ? Eigen::Vector3f(sum / weight) : Eigen::Vector3f(mean.cast<float>());
    for (int k = 0; k < 3; ++k) mesh.colors[v][k] = static_cast<std::uint8_t>(level[k] + 0.5f);
  });
}

void countFilled(SherdModel& model) {
  const TriangleMesh& mesh = model.mesh;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[0]].cast<double>();
    const double area = 0.5 * (mesh.vertices[t[1]].cast<double>() - a)
                                  .cross(mesh.vertices[t[2]].cast<double>() - a)
                                  .norm();
    model.area_mm2 += area;
    if (!mesh.seen[t[0]] || !mesh.seen[t[1]] || !mesh.seen[t[2]]) model.filled_mm2 += area;
  }
  model.filled_share = model.area_mm2 > 0 ? model.filled_mm2 / model.area_mm2 : 0;
}

// See ModelOptions::cell_mm. A node of the grid takes five bytes.
double usualCell(const Surfels& surfels) {
  constexpr double kMostNodes = 1e8;
  Eigen::AlignedBox3f box;
  for (const Vector3f& p : surfels.points) box.extend(p);
  const Vector3f grid = box.sizes().array() + 2 * kMargin_mm;
  const double cell =
      std::clamp(0.75 * surfels.spacing_mm, std::min(0.28, surfels.spacing_mm), 0.45);
  return std::max(cell, std::cbrt(static_cast<double>(grid.prod()) / kMostNodes));
}

Error noModel(Message what) {
  return Error::notEnough(std::move(what));
}

Result<void> checkInput(const PointCloud& front, const PointCloud& back) {
  for (const PointCloud* side : {&front, &back}) {
    const bool is_front = side == &front;
    if (side->empty())
      return noModel(is_front ? message("The front scan contains no points.")
                              : message("The back scan contains no points."));
    if (!side->hasNormals())
      return Error::unusable(
          is_front ? message("The front scan has no normals; a model needs them to tell outside "
                             "from inside.")
                   : message("The back scan has no normals; a model needs them to tell outside "
                             "from inside."));
  }
  return {};
}

}  // namespace

Result<SherdModel> closeModel(const PointCloud& front, const PointCloud& back,
                              const Eigen::Isometry3d& front_from_back, const ModelOptions& options,
                              Progress& progress, std::stop_token stop) {
  if (Result<void> fine = checkInput(front, back); !fine) return fine.error();
  const int threads = options.threads;
  constexpr int kSteps = 5;
  progress.report(0, kSteps);
  Result<Surfels> surfels =
      mergedSurfels(front, back, front_from_back, options.point_spacing_mm, threads, stop);
  if (!surfels) return surfels.error();
  progress.report(1, kSteps);
  const float cell =
      static_cast<float>(options.cell_mm > 0 ? options.cell_mm : usualCell(*surfels));
  const Result<Grid> inside = trustedIndicator(*surfels, 2 * cell, threads, stop);
  if (!inside) return inside.error();
  progress.report(2, kSteps);
  const SurfaceField field(*surfels, *inside);
  FineGrid fine(field, *inside, cell);
  if (!fine.fill(*surfels, threads, stop)) return Error::cancelled();
  progress.report(3, kSteps);

  SherdModel model;
  model.mesh = largestPart(contour(fine.grid()));
  if (model.mesh.triangles.empty())
    return noModel(message("The scans do not enclose a volume; their normals may point inward."));
  if (!ontoSurface(model.mesh, field, cell, threads, stop)) return Error::cancelled();
  progress.report(4, kSteps);
  model.mesh.normals = vertexNormals(model.mesh);
  const float reach =
      static_cast<float>(std::max(0.5, options.seen_spacings * surfels->spacing_mm));
  if (!markSeen(model.mesh, *surfels, reach, threads, stop)) return Error::cancelled();
  if (!paint(model.mesh, front, transformed(back, front_from_back),
             1.5f * static_cast<float>(surfels->spacing_mm), threads, stop))
    return Error::cancelled();
  countFilled(model);
  model.noise_mm = surfels->noise_mm;
  model.side_gap_mm = surfels->side_gap_mm;
  model.points_used = static_cast<int>(surfels->size());
  model.points_dropped = surfels->dropped;
  progress.report(kSteps, kSteps);
  return model;
}

}  // namespace ostraka::model
