#include "texture/sherd_colours.h"

#include <array>
#include <cstdint>

#include "texture/charts.h"
#include "texture/flat.h"

namespace ostraka::texture {
namespace {

// 1 mm^2 of 0.1 mm texels: a chip of a page of a Munsell book shows no less to an eye.
constexpr std::int64_t kLeastTexels = 100;

// How many texels of a part have a level, by channel, BGR. The transfer from levels to light is
// monotone, so the median level is that of the median light.
class Levels {
 public:
  void add(const cv::Vec3b& bgr) {
    ++texels_;
    for (std::size_t channel = 0; channel < 3; ++channel)
      ++counts_[channel][bgr[static_cast<int>(channel)]];
  }
  std::optional<Color> median() const {
    if (texels_ < kLeastTexels) return std::nullopt;
    return Color{medianOf(2), medianOf(1), medianOf(0)};
  }

 private:
  std::uint8_t medianOf(std::size_t channel) const {
    std::int64_t below = 0;
    std::size_t level = 0;
    while ((below += counts_[channel][level]) * 2 < texels_) ++level;
    return static_cast<std::uint8_t>(level);
  }
  std::array<std::array<std::int64_t, 256>, 3> counts_{};
  std::int64_t texels_ = 0;
};

std::array<Eigen::Vector3f, 3> cornersOf(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return {mesh.vertices[static_cast<std::size_t>(t[0])],
          mesh.vertices[static_cast<std::size_t>(t[1])],
          mesh.vertices[static_cast<std::size_t>(t[2])]};
}

// On a bulging face normals lean away from the middle, on a hollow one towards it.
bool frontBulges(const TriangleMesh& mesh, const std::vector<Part>& parts,
                 const Eigen::Vector3f& axis) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : mesh.vertices)
    middle += p.cast<double>() / static_cast<double>(mesh.vertices.size());
  double sum = 0;
  for (std::size_t f = 0; f < parts.size(); ++f) {
    if (parts[f] == Part::Fracture) continue;
    const auto corners = cornersOf(mesh, mesh.triangles[f]);
    const Eigen::Vector3f across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const Eigen::Vector3f from_middle =
        (corners[0] + corners[1] + corners[2]) / 3 - middle.cast<float>();
    const float away = from_middle.dot(across) - from_middle.dot(axis) * across.dot(axis);
    sum += parts[f] == Part::Front ? away : -away;
  }
  return sum >= 0;
}

}  // namespace

SherdColours coloursOf(const TexturedMesh& model) {
  const cv::Mat3b& picture = model.texture.picture;
  const SherdParts parts = partsOf(model.mesh);
  std::array<Levels, 3> levels;
  for (std::size_t f = 0; f < parts.of_face.size(); ++f) {
    std::array<Eigen::Vector2d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2f& uv = model.uv[static_cast<std::size_t>(model.mesh.triangles[f][k])];
      corners[k] = {uv.x() * static_cast<float>(picture.cols) - 0.5f,
                    uv.y() * static_cast<float>(picture.rows) - 0.5f};
    }
    Levels& own = levels[static_cast<std::size_t>(parts.of_face[f])];
    forEachInside(corners, picture.cols, picture.rows, 0,
                  [&](int x, int y, const Eigen::Vector3d&) {
                    if (model.texture.seen(y, x) != 0) own.add(picture(y, x));
                  });
  }
  SherdColours colours;
  colours.front_is_outer = frontBulges(model.mesh, parts.of_face, parts.axis);
  colours.outer = levels[colours.front_is_outer ? 0 : 1].median();
  colours.inner = levels[colours.front_is_outer ? 1 : 0].median();
  colours.fracture = levels[2].median();
  return colours;
}

colour::MunsellProposals munsellOf(const TexturedMesh& model,
                                   const std::optional<colour::Correction>& correction) {
  const SherdColours colours = coloursOf(model);
  colour::MunsellProposals proposals;
  if (colours.outer) proposals.out = colour::proposedFor(*colours.outer);
  if (colours.inner) proposals.in = colour::proposedFor(*colours.inner);
  if (colours.fracture) proposals.core = colour::proposedFor(*colours.fracture);
  proposals.front_is_out = colours.front_is_outer;
  if (correction) proposals.chart = {correction->median, correction->within_95};
  return proposals;
}

}  // namespace ostraka::texture
