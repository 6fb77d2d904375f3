#include "exchange/lighter_model.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/message.h"
#include "cloud/glb.h"
#include "cloud/surface.h"
#include "model/model.h"
#include "texture/atlas.h"
#include "texture/charts.h"
#include "texture/fill.h"
#include "texture/seams.h"

namespace ostraka::exchange {
namespace {

constexpr double kFirst_mm = 0.005;  // off the model: less takes away next to nothing
constexpr int kAttempts = 10;        // each begins with what the one before it left
constexpr std::size_t kOneIn = 1000;

// Measures of LighterModel, from one surface to the other.
void measure(const TriangleMesh& from, const Surface& to, LighterModel& lighter) {
  std::vector<double> off_mm;
  off_mm.reserve(from.vertices.size());
  for (const Eigen::Vector3f& vertex : from.vertices)
    off_mm.push_back(to.closest(vertex.cast<double>()).distance_mm);
  const auto most = off_mm.end() - 1 - static_cast<std::ptrdiff_t>(off_mm.size() / kOneIn);
  std::nth_element(off_mm.begin(), most, off_mm.end());
  lighter.deviation_mm = std::max(lighter.deviation_mm, *most);
  lighter.farthest_mm = std::max(lighter.farthest_mm, *std::max_element(most, off_mm.end()));
}

// Of the model's texels on its surface, in the mean; 0 where it has none.
double texelEdge_mm(const texture::TexturedMesh& model) {
  double surface_mm2 = 0, texels = 0;
  const Eigen::Vector2d page(model.texture.picture.cols, model.texture.picture.rows);
  for (const auto& t : model.mesh.triangles) {
    const auto corner = [&](std::size_t k) {
      return model.mesh.vertices[static_cast<std::size_t>(t[k])].cast<double>().eval();
    };
    const auto place = [&](std::size_t k) {
      return model.uv[static_cast<std::size_t>(t[k])].cast<double>().cwiseProduct(page).eval();
    };
    surface_mm2 += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    const Eigen::Vector2d a = place(1) - place(0), b = place(2) - place(0);
    texels += std::abs(a.x() * b.y() - a.y() * b.x());
  }
  return texels > 0 ? std::sqrt(surface_mm2 / texels) : 0;
}

// Where a point in the plane of one of the model's triangles lies in its picture.
Eigen::Vector2f placeOf(const texture::TexturedMesh& model, const SurfacePoint& at) {
  const auto& t = model.mesh.triangles[static_cast<std::size_t>(at.triangle)];
  const auto corner = [&](std::size_t k) {
    return model.mesh.vertices[static_cast<std::size_t>(t[k])].cast<double>().eval();
  };
  const Eigen::Vector3d a = corner(1) - corner(0), b = corner(2) - corner(0);
  const Eigen::Vector3d normal = a.cross(b), off = at.point - corner(0);
  const double area2 = normal.squaredNorm();
  const Eigen::Vector2f& first = model.uv[static_cast<std::size_t>(t[0])];
  if (!(area2 > 0)) return first;
  const auto second = static_cast<float>(off.cross(b).dot(normal) / area2),
             third = static_cast<float>(a.cross(off).dot(normal) / area2);
  return first + second * (model.uv[static_cast<std::size_t>(t[1])] - first) +
         third * (model.uv[static_cast<std::size_t>(t[2])] - first);
}

bool isSeenAt(const cv::Mat1b& seen, const Eigen::Vector2f& place) {
  const auto texel = [](float share, int count) {
    return std::clamp(static_cast<int>(share * static_cast<float>(count)), 0, count - 1);
  };
  return seen(texel(place.y(), seen.rows), texel(place.x(), seen.cols)) != 0;
}

}  // namespace

Result<LighterModel> lighterModel(const TriangleMesh& model, std::size_t most_bytes) {
  LighterModel lighter{model};
  double bound_mm = kFirst_mm;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Result<std::string> glb = formatGlb(lighter.mesh, {});
    if (!glb) return glb.error();
    const double share = static_cast<double>(glb->size()) / static_cast<double>(most_bytes);
    if (share <= 1) break;
    if (attempt > 0) bound_mm *= std::clamp(share, 1.2, 4.0);
    Result<TriangleMesh> mesh = model::decimated(lighter.mesh, bound_mm);
    if (!mesh) return mesh.error();
    lighter.mesh = std::move(*mesh);
  }
  if (lighter.mesh.triangles.size() == model.triangles.size()) return lighter;
  measure(model, Surface(lighter.mesh), lighter);
  measure(lighter.mesh, Surface(model), lighter);
  return lighter;
}

void shrinkPhotographs(texture::TexturedMesh& model, std::size_t most_bytes) {
  const texture::Texture whole = model.texture;
  const double whole_texel_mm = model.texel_mm;
  const cv::Mat3b whole_relief = model.relief;
  double scale = 1;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const GlbTexture page = texture::filesOf(model);
    const Result<std::string> glb = formatGlb(model.mesh, page, {});
    if (!glb || glb->size() <= most_bytes) return;
    const auto pictures =
        static_cast<double>(page.jpeg.size() + page.seen_png.size() + page.normals_png.size());
    const double room =
        static_cast<double>(most_bytes) - static_cast<double>(glb->size()) + pictures;
    // A picture half as wide takes more than a fourth: what is left is denser.
    scale *= std::clamp(std::sqrt(std::max(0.0, 0.9 * room / pictures)), 0.25, 0.95);
    const auto sizeOf = [scale](const cv::Mat& of) {
      return cv::Size(std::max(1, cvRound(scale * of.cols)), std::max(1, cvRound(scale * of.rows)));
    };
    const cv::Size size = sizeOf(whole.picture);
    cv::resize(whole.picture, model.texture.picture, size, 0, 0, cv::INTER_AREA);
    cv::resize(whole.seen, model.texture.seen, size, 0, 0, cv::INTER_NEAREST);
    // A mean of normals is shorter than one: readers bring it to unit length, as they have to.
    if (!whole_relief.empty())
      cv::resize(whole_relief, model.relief, sizeOf(whole_relief), 0, 0, cv::INTER_AREA);
    model.texel_mm = whole_texel_mm / scale;
  }
}

CornerPlaces placesOn(const TriangleMesh& mesh, const texture::TexturedMesh& model) {
  std::vector<Eigen::Vector3d> corners, middles;
  for (const Eigen::Vector3f& v : mesh.vertices) corners.push_back(v.cast<double>());
  const auto cornerOf = [&](std::size_t face, std::size_t k) {
    return static_cast<std::size_t>(mesh.triangles[face][k]);
  };
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    middles.push_back(
        (corners[cornerOf(f, 0)] + corners[cornerOf(f, 1)] + corners[cornerOf(f, 2)]) / 3);
  const Surface surface(model.mesh);
  const auto at_corners = surface.closest(corners, 0), at_middles = surface.closest(middles, 0);
  const Eigen::Array2f page(static_cast<float>(model.texture.picture.cols),
                            static_cast<float>(model.texture.picture.rows));
  const auto texels = [&page](const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
    return ((to - from).array() * page).matrix().norm();
  };
  CornerPlaces places(mesh.triangles.size());
  for (std::size_t f = 0; f < places.size(); ++f) {
    const Eigen::Vector2f middle = placeOf(model, at_middles[f]);
    for (std::size_t k = 0; k < 3; ++k) {
      SurfacePoint beside = at_middles[f];
      beside.point = corners[cornerOf(f, k)];
      const Eigen::Vector2f continued = placeOf(model, beside),
                            own = placeOf(model, at_corners[cornerOf(f, k)]);
      // Its own place may lie in another chart, or at the other end of a strip.
      const bool together = texels(own, continued) <= 1 + texels(middle, continued) / 2;
      places[f][k] = (together ? own : continued).cwiseMax(0.f).cwiseMin(1.f);
    }
  }
  return places;
}

Result<texture::TexturedMesh> retextured(TriangleMesh mesh, const texture::TexturedMesh& model) {
  const double texel_mm = texelEdge_mm(model);
  if (!model::isClosedManifold(mesh) || !(texel_mm > 0))
    return Error::unusable(message("Photographs can be projected only onto a closed model."));
  if (mesh.normals.size() != mesh.vertices.size()) mesh.normals = model::vertexNormals(mesh);
  const std::vector<texture::Chart> charts = texture::chartsOf(mesh, texel_mm);
  const texture::Atlas atlas = texture::packed(charts, texel_mm);
  const texture::Texels texels = texture::texelsOf(charts, atlas);
  std::vector<cv::Point> on_page;
  std::vector<Eigen::Vector3d> on_mesh;
  for (int y = 0; y < texels.face.rows; ++y)
    for (int x = 0; x < texels.face.cols; ++x) {
      if (texels.face(y, x) < 0) continue;
      const auto& t = mesh.triangles[static_cast<std::size_t>(texels.face(y, x))];
      const cv::Vec2f& w = texels.weights(y, x);
      const Eigen::Vector3f point =
          w[0] * mesh.vertices[static_cast<std::size_t>(t[0])] +
          w[1] * mesh.vertices[static_cast<std::size_t>(t[1])] +
          (1 - w[0] - w[1]) * mesh.vertices[static_cast<std::size_t>(t[2])];
      on_page.emplace_back(x, y);
      on_mesh.push_back(point.cast<double>());
    }
  const auto nearest = Surface(model.mesh).closest(on_mesh, 0);
  cv::Mat3f page(texels.face.size(), cv::Vec3f(0, 0, 0));
  cv::Mat1b on_chart(texels.face.size(), uchar{0});
  texture::TexturedMesh made;
  made.texture.lit = model.texture.lit;
  made.texture.seen = cv::Mat1b(texels.face.size(), uchar{0});
  std::size_t seen = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i].triangle < 0) continue;
    const Eigen::Vector2f place = placeOf(model, nearest[i]);
    page(on_page[i]) = texture::levelAt(model.texture.picture, place);
    on_chart(on_page[i]) = 255;
    if (!isSeenAt(model.texture.seen, place)) continue;
    made.texture.seen(on_page[i]) = 255;
    ++seen;
  }
  made.texture.seen_share =
      nearest.empty() ? 0 : static_cast<double>(seen) / static_cast<double>(nearest.size());
  page = texture::filled(page, on_chart);
  texture::levelSeams(page, texels.face, made.texture.seen, texture::seamsOf(mesh, charts, atlas),
                      0);
  page.convertTo(made.texture.picture, CV_8U);
  texture::UnwrappedMesh unwrapped = texture::unwrapped(mesh, charts, atlas);
  made.mesh = std::move(unwrapped.mesh);
  made.uv = std::move(unwrapped.uv);
  made.texel_mm = atlas.texel_mm;
  return made;
}

}  // namespace ostraka::exchange
