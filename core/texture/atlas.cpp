#include "texture/atlas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "texture/flat.h"

namespace ostraka::texture {
namespace {

// Texels around a chart: three halvings of the page keep charts apart.
constexpr int kMargin = 8;

// With the margin on both sides.
Eigen::Vector2i texelsAcross(const Chart& chart, double texel_mm) {
  return {static_cast<int>(std::ceil(chart.size.x() / texel_mm)) + 1 + 2 * kMargin,
          static_cast<int>(std::ceil(chart.size.y() / texel_mm)) + 1 + 2 * kMargin};
}

// In rows within `width` texels, the tallest first.
Atlas shelved(const std::vector<Chart>& charts, double texel_mm, int width) {
  Atlas atlas;
  atlas.texel_mm = texel_mm;
  atlas.places.resize(charts.size(), Eigen::Vector2i::Zero());
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return charts[a].size.y() > charts[b].size.y(); });
  int x = 0, y = 0, shelf = 0;
  for (const std::size_t i : order) {
    const Eigen::Vector2i size = texelsAcross(charts[i], texel_mm);
    if (x + size.x() > width) {
      y += shelf;
      x = shelf = 0;
    }
    atlas.places[i] = {x + kMargin, y + kMargin};
    x += size.x();
    atlas.width = std::max(atlas.width, x);
    shelf = std::max(shelf, size.y());
  }
  atlas.height = y + shelf;
  return atlas;
}

// The width that wastes least.
Atlas smallest(const std::vector<Chart>& charts, double texel_mm) {
  double area = 0;
  int widest = 0;
  for (const Chart& chart : charts) {
    const Eigen::Vector2i size = texelsAcross(chart, texel_mm);
    area += static_cast<double>(size.x()) * size.y();
    widest = std::max(widest, size.x());
  }
  std::optional<Atlas> best;
  for (double factor = 1; factor < 2.05; factor += 0.05) {
    const int width = std::max(widest, static_cast<int>(std::ceil(factor * std::sqrt(area))));
    Atlas atlas = shelved(charts, texel_mm, width);
    const auto texels = [](const Atlas& a) { return static_cast<double>(a.width) * a.height; };
    if (!best || texels(atlas) < texels(*best)) best = std::move(atlas);
  }
  return *best;
}

// Texels as one triangle after the other takes them.
struct Laying {
  explicit Laying(cv::Size page)
      : texels{cv::Mat1i(page, -1), cv::Mat_<cv::Vec2f>(page, cv::Vec2f(0, 0))},
        outside(page, INFINITY) {}

  // t: on the page.
  void add(const std::array<Eigen::Vector2d, 3>& t, int face) {
    const double longest =
        std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    // A weight of -s lies s heights outside, the least of which stands on the longest edge.
    const double height = std::abs(crossOf(t)) / std::max(longest, 1e-9);
    if (height < 1e-6) return;
    forEachInside(t, outside.cols, outside.rows, std::min(0.7 / height, 20.0),
                  [&](int x, int y, const Eigen::Vector3d& w) {
                    const auto off = static_cast<float>(std::max(0.0, -w.minCoeff()) * height);
                    if (off >= outside(y, x)) return;
                    outside(y, x) = off;
                    texels.face(y, x) = face;
                    texels.weights(y, x) = {static_cast<float>(w[0]), static_cast<float>(w[1])};
                  });
  }

  Texels texels;
  cv::Mat1f outside;  // how far, in texels
};

}  // namespace

Eigen::Vector2d Atlas::onPage(const Chart& chart, std::size_t index,
                              const Eigen::Vector2f& corner) const {
  return {places[index].x() + corner.x() / texel_mm,
          places[index].y() + (chart.size.y() - corner.y()) / texel_mm};
}

Atlas packed(const std::vector<Chart>& charts, double texel_mm, int most_texels) {
  Atlas atlas = smallest(charts, texel_mm);
  while (std::max(atlas.width, atlas.height) > most_texels) {
    texel_mm *=
        std::max(1.02, static_cast<double>(std::max(atlas.width, atlas.height)) / most_texels);
    atlas = smallest(charts, texel_mm);
  }
  return atlas;
}

Texels texelsOf(const std::vector<Chart>& charts, const Atlas& atlas) {
  Laying laying({atlas.width, atlas.height});
  for (std::size_t c = 0; c < charts.size(); ++c)
    for (std::size_t i = 0; i < charts[c].faces.size(); ++i) {
      std::array<Eigen::Vector2d, 3> t;
      for (std::size_t k = 0; k < 3; ++k)
        t[k] = atlas.onPage(charts[c], c, charts[c].corners[i][k]);
      laying.add(t, charts[c].faces[i]);
    }
  return std::move(laying.texels);
}

Texels texelsOf(const TriangleMesh& mesh, const std::vector<Eigen::Vector2f>& uv, cv::Size page) {
  Laying laying(page);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    std::array<Eigen::Vector2d, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(mesh.triangles[f][k]);
      t[k] = {static_cast<double>(uv[v].x()) * page.width - 0.5,
              static_cast<double>(uv[v].y()) * page.height - 0.5};
    }
    laying.add(t, static_cast<int>(f));
  }
  return std::move(laying.texels);
}

UnwrappedMesh unwrapped(const TriangleMesh& mesh, const std::vector<Chart>& charts,
                        const Atlas& atlas) {
  UnwrappedMesh out;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    // Within a chart a vertex may have two places: where the fracture's way around begins and ends.
    std::map<std::pair<int, std::pair<float, float>>, int> there;
    for (std::size_t i = 0; i < charts[c].faces.size(); ++i) {
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = mesh.triangles[static_cast<std::size_t>(charts[c].faces[i])][k];
        const Eigen::Vector2f& corner = charts[c].corners[i][k];
        const auto [found, is_new] = there.try_emplace({v, {corner.x(), corner.y()}},
                                                       static_cast<int>(out.mesh.vertices.size()));
        triangle[k] = found->second;
        if (!is_new) continue;
        const auto at = static_cast<std::size_t>(v);
        out.mesh.vertices.push_back(mesh.vertices[at]);
        if (!mesh.normals.empty()) out.mesh.normals.push_back(mesh.normals[at]);
        if (!mesh.colors.empty()) out.mesh.colors.push_back(mesh.colors[at]);
        if (!mesh.seen.empty()) out.mesh.seen.push_back(mesh.seen[at]);
        const Eigen::Vector2d page = atlas.onPage(charts[c], c, corner);
        // A page's edge lies half a texel beyond the centre of its first.
        out.uv.emplace_back(static_cast<float>((page.x() + 0.5) / atlas.width),
                            static_cast<float>((page.y() + 0.5) / atlas.height));
      }
      out.mesh.triangles.push_back(triangle);
    }
  }
  return out;
}

}  // namespace ostraka::texture
