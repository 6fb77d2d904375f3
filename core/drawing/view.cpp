#include "drawing/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "model/model.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;

constexpr int kOversampling = 2;  // per axis; the picture is averaged down
constexpr double kOutlineError_mm = 0.05;

// Depth, and shade where something lies.
struct Canvas {
  cv::Mat1f depth;
  cv::Mat1f shade;
  Vector2d corner;  // of the first pixel's upper left, paper mm
  double per_mm = 1;
};

float brightness(const Color& c) {
  return (0.3f * c[0] + 0.59f * c[1] + 0.11f * c[2]) / 255.f;
}

// From the upper left before the sherd, as drawings have it; a softer one from the other side so
// that no part is black.
float shadeOf(const Vector3f& normal) {
  const Vector3f key = Vector3f(0.75f, -0.45f, 0.5f).normalized();
  const Vector3f fill = Vector3f(0.8f, 0.6f, 0.1f).normalized();
  return 0.12f + 0.8f * std::max(0.f, normal.dot(key)) + 0.14f * std::max(0.f, normal.dot(fill));
}

// How paint of this brightness changes the shade.
float paintOf(float brightness, float mean) {
  return std::clamp(0.25f + 0.75f * brightness / std::max(mean, 0.05f), 0.2f, 1.35f);
}

// p: column, row, depth towards the viewer; shadeAt: by the weights of the second and third corner.
template <class ShadeAt>
void drawTriangle(Canvas& canvas, const std::array<Vector3f, 3>& p, ShadeAt shadeAt) {
  const float area =
      (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (p[1].y() - p[0].y());
  if (area == 0) return;
  const auto bounds = [&](int axis, int limit) {
    const auto [low, high] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
    return std::pair(std::max(0, static_cast<int>(std::ceil(low))),
                     std::min(limit - 1, static_cast<int>(std::floor(high))));
  };
  const auto [x0, x1] = bounds(0, canvas.depth.cols);
  const auto [y0, y1] = bounds(1, canvas.depth.rows);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
      const float b =
          ((fx - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (fy - p[0].y())) /
          area;
      const float c =
          ((p[1].x() - p[0].x()) * (fy - p[0].y()) - (fx - p[0].x()) * (p[1].y() - p[0].y())) /
          area;
      if (b < 0 || c < 0 || b + c > 1) continue;
      const float depth = p[0].z() + b * (p[1].z() - p[0].z()) + c * (p[2].z() - p[0].z());
      if (depth <= canvas.depth(y, x)) continue;
      canvas.depth(y, x) = depth;
      canvas.shade(y, x) = shadeAt(b, c);
    }
}

Vector3f onCanvas(const Canvas& canvas, double scale, const Vector3f& in_view) {
  const Vector2d paper = scale * Vector2d(in_view.y(), -in_view.z());
  const Vector2d pixel = (paper - canvas.corner) * canvas.per_mm - Vector2d(0.5, 0.5);
  return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y()), in_view.x()};
}

// Each pixel by the photographs' texel, so that the drawing is as fine as they are.
void paint(Canvas& canvas, const texture::TexturedMesh& photographs,
           const Eigen::Isometry3d& view_from_model, double scale) {
  const auto brightnessAt = [&](const Eigen::Vector2f& place) {
    const cv::Vec3f bgr = texture::levelAt(photographs.texture.picture, place);
    return (0.3f * bgr[2] + 0.59f * bgr[1] + 0.11f * bgr[0]) / 255.f;
  };
  Canvas painted = canvas;
  painted.depth = cv::Mat1f(canvas.depth.size(), -1e18f);
  painted.shade = cv::Mat1f(canvas.depth.size(), -1.f);
  std::vector<Vector3f> places;
  float mean = 0;
  for (std::size_t v = 0; v < photographs.mesh.vertices.size(); ++v) {
    const Eigen::Vector3d p = view_from_model * photographs.mesh.vertices[v].cast<double>();
    places.push_back(onCanvas(canvas, scale, p.cast<float>()));
    mean += brightnessAt(photographs.uv[v]) / static_cast<float>(photographs.uv.size());
  }
  for (const auto& t : photographs.mesh.triangles) {
    const Eigen::Vector2f &first = photographs.uv[t[0]], &second = photographs.uv[t[1]],
                          &third = photographs.uv[t[2]];
    drawTriangle(painted, {places[t[0]], places[t[1]], places[t[2]]}, [&](float b, float c) {
      return brightnessAt(first + b * (second - first) + c * (third - first));
    });
  }
  for (int y = 0; y < canvas.shade.rows; ++y)
    for (int x = 0; x < canvas.shade.cols; ++x)
      if (canvas.depth(y, x) > -1e17f && painted.shade(y, x) >= 0)
        canvas.shade(y, x) = std::min(1.f, canvas.shade(y, x) * paintOf(painted.shade(y, x), mean));
}

Canvas render(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
              const ViewOptions& options) {
  std::vector<Vector3f> places;
  Eigen::AlignedBox2d box;
  for (const Vector3f& v : mesh.vertices) {
    const Eigen::Vector3d q = view_from_model * v.cast<double>();
    places.push_back(q.cast<float>());
    box.extend(options.scale * Vector2d(q.y(), -q.z()));
  }
  Canvas canvas;
  canvas.corner = box.min() - Vector2d(1, 1);
  const model::Raster raster =
      model::rasterOver(box.sizes() + Vector2d(2, 2), options.pixels_per_mm * kOversampling);
  canvas.per_mm = raster.per_mm;
  const auto whole = [](int fine) { return (fine + kOversampling - 1) / kOversampling; };
  const int columns = kOversampling * whole(raster.columns),
            rows = kOversampling * whole(raster.rows);
  canvas.depth = cv::Mat1f(rows, columns, -1e18f);
  canvas.shade = cv::Mat1f(rows, columns, 1.f);
  const std::vector<Vector3f> normals = model::vertexNormals(mesh);
  const texture::TexturedMesh* photographs =
      options.surface == Surface::Painted ? options.photographs : nullptr;
  const bool painted = options.surface == Surface::Painted && photographs == nullptr &&
                       mesh.colors.size() == places.size();
  float mean = 1;
  if (painted) {
    mean = 0;
    for (const Color& c : mesh.colors) mean += brightness(c) / static_cast<float>(places.size());
  }
  std::vector<float> shades;
  for (std::size_t i = 0; i < places.size(); ++i) {
    float shade = shadeOf(view_from_model.linear().cast<float>() * normals[i]);
    if (painted) shade *= paintOf(brightness(mesh.colors[i]), mean);
    shades.push_back(std::min(shade, 1.f));
    places[i] = onCanvas(canvas, options.scale, places[i]);
  }
  for (const auto& t : mesh.triangles) {
    const float first = shades[t[0]], second = shades[t[1]], third = shades[t[2]];
    drawTriangle(canvas, {places[t[0]], places[t[1]], places[t[2]]}, [&](float b, float c) {
      return first + b * (second - first) + c * (third - first);
    });
  }
  if (photographs != nullptr) paint(canvas, *photographs, view_from_model, options.scale);
  return canvas;
}

// Breaks in depth: edges within the outline that a pen would draw.
void darkenSteps(Canvas& canvas, double scale) {
  const float step = static_cast<float>(0.8 / scale);  // mm of the sherd
  cv::Mat1f drawn = canvas.shade.clone();
  for (int y = 1; y + 1 < canvas.depth.rows; ++y)
    for (int x = 1; x + 1 < canvas.depth.cols; ++x) {
      const float here = canvas.depth(y, x);
      if (here < -1e17f) continue;
      for (const auto& [dx, dy] :
           {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        const float there = canvas.depth(y + dy, x + dx);
        if (there > -1e17f && there > here + step) drawn(y, x) = 0.15f;
      }
    }
  canvas.shade = drawn;
}

std::string encoded(const cv::Mat1f& shade) {
  cv::Mat small, bytes;
  cv::resize(shade, small, {}, 1.0 / kOversampling, 1.0 / kOversampling, cv::INTER_AREA);
  small.convertTo(bytes, CV_8U, 255);
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", bytes, jpeg, {cv::IMWRITE_JPEG_QUALITY, 92});
  return {jpeg.begin(), jpeg.end()};
}

}  // namespace

SherdView drawView(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                   const ViewOptions& options) {
  Canvas canvas = render(mesh, view_from_model, options);
  const cv::Mat1b mask = canvas.depth > -1e17f;
  darkenSteps(canvas, options.scale);
  SherdView view;
  Picture picture;
  picture.corner = canvas.corner;
  picture.size = Vector2d(canvas.depth.cols, canvas.depth.rows) / canvas.per_mm;
  picture.width_px = canvas.depth.cols / kOversampling;
  picture.height_px = canvas.depth.rows / kOversampling;
  picture.jpeg = encoded(canvas.shade);
  view.sheet.items.push_back(std::move(picture));
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  Shape outline;
  outline.closed = true;
  outline.stroke = 0.0;
  outline.stroke_mm = 0.3;
  for (const auto& contour : contours) {
    if (contour.size() < 8) continue;
    std::vector<cv::Point> simple;
    cv::approxPolyDP(contour, simple, kOutlineError_mm * canvas.per_mm, true);
    auto& line = outline.lines.emplace_back();
    for (const cv::Point& p : simple) {
      line.push_back(canvas.corner + Vector2d(p.x + 0.5, p.y + 0.5) / canvas.per_mm);
      view.box.extend(line.back());
    }
  }
  view.sheet.items.push_back(std::move(outline));
  return view;
}

}  // namespace ostraka::drawing
