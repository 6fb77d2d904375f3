#include "texture/relief.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "cloud/surface.h"
#include "model/model.h"
#include "texture/atlas.h"

namespace ostraka::texture {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kLeastTilt_rad = M_PI / 180;  // RMS; see relief.h
constexpr double kLeastRise = 0.1;             // of a normal in its frame: less faces away
constexpr int kApproaches = 4;                 // to where a normal meets the surface
constexpr double kNear = 0.1;                  // texels: close enough to the normal

double areaOf(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  const auto corner = [&](std::size_t k) -> const Vector3f& {
    return mesh.vertices[static_cast<std::size_t>(t[k])];
  };
  return 0.5 * static_cast<double>((corner(1) - corner(0)).cross(corner(2) - corner(0)).norm());
}

// An edge of an even mesh with as many triangles on as much surface, mm.
double edgeOf_mm(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) area += areaOf(mesh, t);
  return std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(mesh.triangles.size()));
}

// Of a triangle's corners at a point of it.
Vector3d mixedAt(const Vector3d& point, const std::array<Vector3d, 3>& corners,
                 const std::array<Vector3d, 3>& values) {
  const Vector3d a = corners[1] - corners[0], b = corners[2] - corners[0];
  const Vector3d across = a.cross(b), off = point - corners[0];
  const double area2 = across.squaredNorm();
  if (!(area2 > 0)) return values[0];
  const double second = off.cross(b).dot(across) / area2, third = a.cross(off).dot(across) / area2;
  return (1 - second - third) * values[0] + second * values[1] + third * values[2];
}

class ReliefOver {
 public:
  ReliefOver(const TexturedMesh& model, const TriangleMesh& full, cv::Size page)
      : model_(model),
        full_(full),
        normals_(full.normals.size() == full.vertices.size() ? full.normals
                                                             : model::vertexNormals(full)),
        surface_(full),
        tangents_(tangentsOf(model.mesh, model.uv)),
        texels_(texelsOf(model.mesh, model.uv, page)),
        texel_mm_(model.texel_mm * model.texture.picture.cols / page.width) {}

  cv::Mat3b drawn(int threads) const {
    cv::Mat3b map(texels_.face.size(), cv::Vec3b(255, 128, 128));
    struct Tilt {
      double squares = 0;
      std::int64_t count = 0;
    };
    std::vector<Tilt> tilts(static_cast<std::size_t>(map.rows));
    parallelFor(tilts.size(), threads, [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < map.cols; ++x) {
        if (texels_.face(y, x) < 0) continue;
        const std::optional<Vector3d> normal = normalAt(x, y);
        if (!normal) continue;
        for (int k = 0; k < 3; ++k)
          map(y, x)[2 - k] = cv::saturate_cast<uchar>(std::lround(127.5 + 127.5 * (*normal)[k]));
        tilts[row].squares += std::pow(std::acos(std::min(1.0, normal->z())), 2);
        ++tilts[row].count;
      }
    });
    Tilt all;
    for (const Tilt& tilt : tilts) {
      all.squares += tilt.squares;
      all.count += tilt.count;
    }
    const double least = kLeastTilt_rad * kLeastTilt_rad * static_cast<double>(all.count);
    return all.count > 0 && all.squares >= least ? map : cv::Mat3b();
  }

 private:
  // Of the full mesh, in the texel's frame, unit length; nothing where it was not seen or faces
  // away.
  std::optional<Vector3d> normalAt(int x, int y) const {
    const auto& t = model_.mesh.triangles[static_cast<std::size_t>(texels_.face(y, x))];
    const cv::Vec2f& w = texels_.weights(y, x);
    const auto mixed = [&](const std::vector<Vector3f>& of) -> Vector3d {
      return (w[0] * of[static_cast<std::size_t>(t[0])] +
              w[1] * of[static_cast<std::size_t>(t[1])] +
              (1 - w[0] - w[1]) * of[static_cast<std::size_t>(t[2])])
          .cast<double>();
    };
    const Vector3d point = mixed(model_.mesh.vertices);
    Eigen::Matrix3d frame;
    frame.col(2) = mixed(model_.mesh.normals).normalized();
    frame.col(0) = mixed(tangents_).normalized();
    frame.col(1) = frame.col(2).cross(frame.col(0));
    const std::optional<Vector3d> normal = normalWhere(point, frame.col(2));
    if (!normal || !(std::abs(frame.determinant()) > 0.1)) return std::nullopt;
    const Vector3d in_frame = (frame.inverse() * *normal).normalized();
    return in_frame.z() > kLeastRise ? std::optional(in_frame) : std::nullopt;
  }

  // Where the line through `point` along `along` meets the full mesh: each closest point, taken
  // back to the line, is nearer to it.
  std::optional<Vector3d> normalWhere(const Vector3d& point, const Vector3d& along) const {
    SurfacePoint at = surface_.closest(point);
    for (int i = 0; i < kApproaches; ++i) {
      const Vector3d on_line = point + (at.point - point).dot(along) * along;
      if ((at.point - on_line).norm() < kNear * texel_mm_) break;
      at = surface_.closest(on_line);
    }
    const auto& t = full_.triangles[static_cast<std::size_t>(at.triangle)];
    std::array<Vector3d, 3> corners, normals;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(t[k]);
      if (!full_.seen.empty() && full_.seen[v] == 0) return std::nullopt;
      corners[k] = full_.vertices[v].cast<double>();
      normals[k] = normals_[v].cast<double>();
    }
    const Vector3d normal = mixedAt(at.point, corners, normals);
    return normal.norm() > 1e-6 ? std::optional<Vector3d>(normal.normalized()) : std::nullopt;
  }

  const TexturedMesh& model_;
  const TriangleMesh& full_;
  std::vector<Vector3f> normals_;
  Surface surface_;
  std::vector<Vector3f> tangents_;
  Texels texels_;
  double texel_mm_;
};

}  // namespace

std::vector<Vector3f> tangentsOf(const TriangleMesh& mesh, const std::vector<Eigen::Vector2f>& uv) {
  std::vector<Vector3f> tangents(mesh.vertices.size(), Vector3f::Zero());
  for (const auto& t : mesh.triangles) {
    const std::array<std::size_t, 3> v = {static_cast<std::size_t>(t[0]),
                                          static_cast<std::size_t>(t[1]),
                                          static_cast<std::size_t>(t[2])};
    const Vector3f a = mesh.vertices[v[1]] - mesh.vertices[v[0]],
                   b = mesh.vertices[v[2]] - mesh.vertices[v[0]];
    const Eigen::Vector2f p = uv[v[1]] - uv[v[0]], q = uv[v[2]] - uv[v[0]];
    const float sign = p.x() * q.y() < p.y() * q.x() ? -1.f : 1.f;
    // By the area on the page.
    const Vector3f along = sign * (q.y() * a - p.y() * b);
    for (const std::size_t corner : v) tangents[corner] += along;
  }
  for (std::size_t v = 0; v < tangents.size(); ++v) {
    const Vector3f normal = mesh.normals[v].normalized();
    const Vector3f square = tangents[v] - tangents[v].dot(normal) * normal;
    tangents[v] =
        square.norm() > 1e-3f * tangents[v].norm() ? square.normalized() : normal.unitOrthogonal();
  }
  return tangents;
}

cv::Mat3b reliefOf(const TexturedMesh& model, const TriangleMesh& full, int threads) {
  const cv::Size page = model.texture.picture.size();
  if (full.triangles.empty() || !(model.texel_mm > 0) ||
      model.mesh.triangles.size() >= full.triangles.size())
    return {};
  const double share = std::min(1.0, 2 * model.texel_mm / edgeOf_mm(full));
  const cv::Size size(std::max(1, cvCeil(share * page.width)),
                      std::max(1, cvCeil(share * page.height)));
  return ReliefOver(model, full, size).drawn(threads);
}

}  // namespace ostraka::texture
