#include "rendering/prop.h"

#include <array>
#include <cmath>
#include <numbers>

namespace ostraka::rendering {
namespace {

using Eigen::Vector3f;

constexpr double kGrid = 1.5;          // mm, of a mesh's edges: light is known at their ends
constexpr float kPencilRadius = 3.6f;  // mm

const Vector3f kCardWhite(0.78f, 0.78f, 0.76f), kCardBlack(0.03f, 0.03f, 0.032f);
// A card's patches, row by row: skin, sky, leaf, orange, blue, red, green, yellow, and six greys.
const std::array<Vector3f, 14> kPatches{
    Vector3f(0.50f, 0.27f, 0.18f), Vector3f(0.12f, 0.20f, 0.33f),   Vector3f(0.10f, 0.15f, 0.05f),
    Vector3f(0.62f, 0.19f, 0.03f), Vector3f(0.03f, 0.05f, 0.28f),   Vector3f(0.40f, 0.03f, 0.03f),
    Vector3f(0.06f, 0.28f, 0.06f), Vector3f(0.70f, 0.53f, 0.03f),   Vector3f(0.85f, 0.85f, 0.84f),
    Vector3f(0.58f, 0.58f, 0.58f), Vector3f(0.36f, 0.36f, 0.36f),   Vector3f(0.19f, 0.19f, 0.19f),
    Vector3f(0.09f, 0.09f, 0.09f), Vector3f(0.032f, 0.032f, 0.032f)};

// A rectangle of the mesh: corner and two sides, seen from where u x v points.
void addFace(TriangleMesh& mesh, const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
             const Eigen::Vector3d& v) {
  const int across = std::max(1, static_cast<int>(u.norm() / kGrid)),
            down = std::max(1, static_cast<int>(v.norm() / kGrid));
  const auto first = static_cast<int>(mesh.vertices.size());
  for (int j = 0; j <= down; ++j)
    for (int i = 0; i <= across; ++i)
      mesh.vertices.push_back((corner + u * i / across + v * j / down).cast<float>());
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      const int a = first + j * (across + 1) + i, b = a + across + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({a + 1, b + 1, b});
    }
}

TriangleMesh box(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  const Eigen::Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  const Eigen::Vector3d low(-size.x() / 2, -size.y() / 2, 0);
  addFace(mesh, low + z, x, y);
  addFace(mesh, low, x, z);
  addFace(mesh, low + y + x, -x, z);
  addFace(mesh, low + y, -y, z);
  addFace(mesh, low + x, y, z);
  return mesh;
}

// Lies along x; pointed at its far end.
TriangleMesh pencil(double length) {
  TriangleMesh mesh;
  constexpr int kAround = 24;
  const std::array<std::array<double, 2>, 4> profile{
      {{-length / 2, 1}, {length / 2 - 16, 1}, {length / 2 - 4, 0.28}, {length / 2, 0.05}}};
  for (std::size_t part = 0; part + 1 < profile.size(); ++part) {
    const auto [x0, r0] = profile[part];
    const auto [x1, r1] = profile[part + 1];
    const int steps = std::max(1, static_cast<int>((x1 - x0) / kGrid));
    const auto first = static_cast<int>(mesh.vertices.size());
    for (int s = 0; s <= steps; ++s)
      for (int k = 0; k < kAround; ++k) {
        const double t = static_cast<double>(s) / steps, r = kPencilRadius * (r0 + t * (r1 - r0)),
                     a = 2 * std::numbers::pi * k / kAround;
        mesh.vertices.emplace_back(static_cast<float>(x0 + t * (x1 - x0)),
                                   static_cast<float>(r * std::cos(a)),
                                   static_cast<float>(kPencilRadius + r * std::sin(a)));
      }
    for (int s = 0; s < steps; ++s)
      for (int k = 0; k < kAround; ++k) {
        const int a = first + s * kAround + k, b = first + s * kAround + (k + 1) % kAround;
        mesh.triangles.push_back({a, b, a + kAround});
        mesh.triangles.push_back({b, b + kAround, a + kAround});
      }
  }
  return mesh;
}

Vector3f scaleBar(const Vector3f& p) {
  const Vector3f size = propSize(PropKind::ScaleBar).cast<float>();
  const float x = p.x() + size.x() / 2, y = p.y() + size.y() / 2;
  if (x < 5 || x > size.x() - 5 || y < 3 || y > size.y() - 3) return kCardWhite;
  const bool odd = static_cast<int>((x - 5) / 10) % 2 != 0, upper = y > size.y() / 2;
  return odd == upper ? kCardBlack : kCardWhite;
}

Vector3f colorCard(const Vector3f& p) {
  const Vector3f size = propSize(PropKind::ColorCard).cast<float>();
  const float x = (p.x() + size.x() / 2 - 3) / 12, y = (p.y() + size.y() / 2 - 3) / 12;
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const bool inside = x - std::floor(x) > 0.08f && y - std::floor(y) > 0.08f && column >= 0 &&
                      row >= 0 && column < 7 && row < 2;
  return inside ? kPatches[static_cast<std::size_t>(7 * row + column)]
                : Vector3f(0.05f, 0.05f, 0.05f);
}

// Three lines of writing.
Vector3f label(const Vector3f& p, std::uint32_t seed) {
  const Vector3f size = propSize(PropKind::Label).cast<float>();
  const float line = (p.y() + size.y() / 2 - 3) / 7;
  const float height = (line - std::floor(line) - 0.5f) * 7;
  const bool row = line > 0 && line < 3 && std::abs(p.x()) < size.x() / 2 - 4;
  const auto number = static_cast<float>(std::floor(line));
  const float pen = 1.6f * vessels::noise({p.x() / 1.1f, number * 7, 0}, seed) +
                    0.8f * vessels::noise({p.x() / 0.5f, number * 7, 5}, seed);
  const bool word = vessels::noise({p.x() / 6, number * 3, 9}, seed) > -0.25f;
  return row && word && std::abs(height - 1.3f * pen) < 0.35f ? Vector3f(0.03f, 0.03f, 0.07f)
                                                              : Vector3f(0.66f, 0.60f, 0.46f);
}

Vector3f pencilColor(const Vector3f& p, const Vector3f& body) {
  const auto length = static_cast<float>(propSize(PropKind::Pencil).x());
  if (p.x() > length / 2 - 4) return {0.05f, 0.05f, 0.055f};  // graphite
  if (p.x() > length / 2 - 16) return {0.45f, 0.29f, 0.15f};  // wood
  if (p.x() < -length / 2 + 9) return {0.50f, 0.18f, 0.16f};  // rubber
  return body;
}

}  // namespace

Eigen::Vector3d propSize(PropKind kind) {
  switch (kind) {
    case PropKind::ScaleBar:
      return {110, 16, 1.2};
    case PropKind::Label:
      return {50, 26, 0.3};
    case PropKind::ColorCard:
      return {90, 30, 0.8};
    case PropKind::Pencil:
      return {140, 2 * kPencilRadius, 2 * kPencilRadius};
  }
  return {10, 10, 1};
}

Prop makeProp(PropKind kind, const Eigen::Isometry3d& plate_from_prop, vessels::Random& random) {
  Prop prop;
  prop.kind = kind;
  prop.plate_from_prop = plate_from_prop;
  prop.seed = static_cast<std::uint32_t>(random.next());
  const Eigen::Vector3d size = propSize(kind);
  prop.mesh = kind == PropKind::Pencil ? pencil(size.x()) : box(size);
  prop.mesh = transformed(prop.mesh, plate_from_prop);
  switch (kind) {
    case PropKind::ScaleBar:
      prop.body = Vector3f::Constant(0.45f);
      break;
    case PropKind::Label:
      prop.body = {0.62f, 0.56f, 0.43f};
      break;
    case PropKind::ColorCard:
      prop.body = Vector3f::Constant(0.2f);
      break;
    case PropKind::Pencil:
      prop.body =
          random.chance(0.5) ? Vector3f(0.62f, 0.40f, 0.02f) : Vector3f(0.03f, 0.16f, 0.06f);
      break;
  }
  return prop;
}

Eigen::Vector3f Prop::albedo(const Eigen::Vector3f& p_plate) const {
  const Vector3f p = (plate_from_prop.inverse() * p_plate.cast<double>()).cast<float>();
  switch (kind) {
    case PropKind::ScaleBar:
      return scaleBar(p);
    case PropKind::Label:
      return label(p, seed);
    case PropKind::ColorCard:
      return colorCard(p);
    case PropKind::Pencil:
      return pencilColor(p, body);
  }
  return body;
}

}  // namespace ostraka::rendering
