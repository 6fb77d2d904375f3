#include "drawing/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "images/jpeg_image.h"
#include "model/model.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;

constexpr int kOversampling = 2;  // per axis; the picture is averaged down
constexpr double kOutlineError_mm = 0.05;
constexpr float kFarthest = -1e17f;  // depth where nothing lies

// Depth, and shade or colour where something lies.
struct Canvas {
  cv::Mat1f depth;
  cv::Mat1f shade;
  cv::Mat3b colours;  // BGR, of an orthophoto instead of the shade
  Vector2d corner;    // of the first pixel's upper left, paper mm
  int dpi = 0;        // of the picture, averaged down
  double per_mm() const { return dpi * kOversampling / kMmPerInch; }
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

// p: column, row, depth towards the viewer; draw: a pixel, and the weights of the second and third
// corner.
template <class Draw>
void drawTriangle(cv::Mat1f& nearest, const std::array<Vector3f, 3>& p, Draw draw) {
  const float area =
      (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (p[1].y() - p[0].y());
  if (area == 0) return;
  const auto bounds = [&](int axis, int limit) {
    const auto [low, high] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
    return std::pair(std::max(0, static_cast<int>(std::ceil(low))),
                     std::min(limit - 1, static_cast<int>(std::floor(high))));
  };
  const auto [x0, x1] = bounds(0, nearest.cols);
  const auto [y0, y1] = bounds(1, nearest.rows);
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
      if (depth <= nearest(y, x)) continue;
      nearest(y, x) = depth;
      draw(cv::Point(x, y), b, c);
    }
}

std::vector<Vector3f> onCanvas(const Canvas& canvas, double scale, const TriangleMesh& mesh,
                               const Eigen::Isometry3d& view_from_model) {
  std::vector<Vector3f> places;
  places.reserve(mesh.vertices.size());
  for (const Vector3f& v : mesh.vertices) {
    const Eigen::Vector3d q = view_from_model * v.cast<double>();
    const Vector2d paper = scale * Vector2d(q.y(), -q.z());
    const Vector2d pixel = (paper - canvas.corner) * canvas.per_mm() - Vector2d(0.5, 0.5);
    places.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()),
                        static_cast<float>(q.x()));
  }
  return places;
}

// valueAt: of a triangle, by the weights of its second and third corner.
template <class Value, class ValueAt>
void drawMesh(cv::Mat1f& nearest, cv::Mat_<Value>& picture, const TriangleMesh& mesh,
              const std::vector<Vector3f>& places, ValueAt valueAt) {
  for (const auto& t : mesh.triangles)
    drawTriangle(nearest, {places[t[0]], places[t[1]], places[t[2]]},
                 [&](const cv::Point& at, float b, float c) { picture(at) = valueAt(t, b, c); });
}

// Between the three corners of a triangle.
template <class List>
auto between(const List& values, const std::array<int, 3>& t, float b, float c) {
  using Value = typename List::value_type;
  const Value &first = values[t[0]], &second = values[t[1]], &third = values[t[2]];
  return Value(first + b * (second - first) + c * (third - first));
}

float brightnessAt(const texture::TexturedMesh& photographs, const Eigen::Vector2f& place) {
  const cv::Vec3f bgr = texture::levelAt(photographs.texture.picture, place);
  return (0.3f * bgr[2] + 0.59f * bgr[1] + 0.11f * bgr[0]) / 255.f;
}

// Each pixel by the photographs' texel, so that the drawing is as fine as they are.
void paint(Canvas& canvas, const texture::TexturedMesh& photographs,
           const Eigen::Isometry3d& view_from_model, double scale) {
  cv::Mat1f depth(canvas.depth.size(), kFarthest), painted(canvas.depth.size(), -1.f);
  float mean = 0;
  for (const Eigen::Vector2f& place : photographs.uv)
    mean += brightnessAt(photographs, place) / static_cast<float>(photographs.uv.size());
  drawMesh(depth, painted, photographs.mesh,
           onCanvas(canvas, scale, photographs.mesh, view_from_model),
           [&](const std::array<int, 3>& t, float b, float c) {
             return brightnessAt(photographs, between(photographs.uv, t, b, c));
           });
  for (int y = 0; y < canvas.shade.rows; ++y)
    for (int x = 0; x < canvas.shade.cols; ++x)
      if (canvas.depth(y, x) > kFarthest && painted(y, x) >= 0)
        canvas.shade(y, x) = std::min(1.f, canvas.shade(y, x) * paintOf(painted(y, x), mean));
}

// With 1 mm of paper around; whole dots, as they are stated in a picture's file.
Canvas canvasFor(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                 const ViewOptions& options) {
  Eigen::AlignedBox2d box;
  for (const Vector3f& v : mesh.vertices) {
    const Eigen::Vector3d q = view_from_model * v.cast<double>();
    box.extend(options.scale * Vector2d(q.y(), -q.z()));
  }
  Canvas canvas;
  canvas.corner = box.min() - Vector2d(1, 1);
  const Vector2d size = box.sizes() + Vector2d(2, 2);
  const int dpi = static_cast<int>(options.dpi);
  const model::Raster raster = model::rasterOver(size, dpi * kOversampling / kMmPerInch);
  const int most = static_cast<int>(raster.per_mm / kOversampling * kMmPerInch + 1e-6);
  canvas.dpi = std::clamp(most, 1, dpi);
  const double fewer = canvas.per_mm() / raster.per_mm;
  const auto fine = [fewer](int pixels) {
    return kOversampling * static_cast<int>(std::ceil(fewer * pixels / kOversampling));
  };
  canvas.depth = cv::Mat1f(fine(raster.rows), fine(raster.columns), kFarthest);
  return canvas;
}

void shadeForm(Canvas& canvas, const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
               const ViewOptions& options) {
  canvas.shade = cv::Mat1f(canvas.depth.size(), 1.f);
  const std::vector<Vector3f> normals = model::vertexNormals(mesh);
  const texture::TexturedMesh* photographs =
      options.surface == Surface::Painted ? options.photographs : nullptr;
  const bool painted = options.surface == Surface::Painted && photographs == nullptr &&
                       mesh.colors.size() == mesh.vertices.size();
  float mean = painted ? 0 : 1;
  if (painted)
    for (const Color& c : mesh.colors)
      mean += brightness(c) / static_cast<float>(mesh.colors.size());
  std::vector<float> shades;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    float shade = shadeOf(view_from_model.linear().cast<float>() * normals[i]);
    if (painted) shade *= paintOf(brightness(mesh.colors[i]), mean);
    shades.push_back(std::min(shade, 1.f));
  }
  drawMesh(canvas.depth, canvas.shade, mesh, onCanvas(canvas, options.scale, mesh, view_from_model),
           [&](const auto& t, float b, float c) { return between(shades, t, b, c); });
  if (photographs != nullptr) paint(canvas, *photographs, view_from_model, options.scale);
}

void showColours(Canvas& canvas, const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                 const ViewOptions& options) {
  canvas.colours = cv::Mat3b(canvas.depth.size(), cv::Vec3b(255, 255, 255));
  if (const texture::TexturedMesh* photographs = options.photographs) {
    drawMesh(canvas.depth, canvas.colours, photographs->mesh,
             onCanvas(canvas, options.scale, photographs->mesh, view_from_model),
             [&](const auto& t, float b, float c) {
               return cv::Vec3b(texture::levelAt(photographs->texture.picture,
                                                 between(photographs->uv, t, b, c)));
             });
    return;
  }
  std::vector<cv::Vec3f> colours;
  for (const Color& c : mesh.colors) colours.emplace_back(c[2], c[1], c[0]);
  colours.resize(mesh.vertices.size(), cv::Vec3f::all(255));
  drawMesh(canvas.depth, canvas.colours, mesh,
           onCanvas(canvas, options.scale, mesh, view_from_model),
           [&](const auto& t, float b, float c) { return cv::Vec3b(between(colours, t, b, c)); });
}

// Breaks in depth: edges within the outline that a pen would draw.
void darkenSteps(Canvas& canvas, double scale) {
  const float step = static_cast<float>(0.8 / scale);  // mm of the sherd
  cv::Mat1f drawn = canvas.shade.clone();
  for (int y = 1; y + 1 < canvas.depth.rows; ++y)
    for (int x = 1; x + 1 < canvas.depth.cols; ++x) {
      const float here = canvas.depth(y, x);
      if (here <= kFarthest) continue;
      for (const auto& [dx, dy] :
           {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        const float there = canvas.depth(y + dy, x + dx);
        if (there > kFarthest && there > here + step) drawn(y, x) = 0.15f;
      }
    }
  canvas.shade = drawn;
}

Canvas render(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
              const ViewOptions& options) {
  Canvas canvas = canvasFor(mesh, view_from_model, options);
  if (options.surface == Surface::Orthophoto) {
    showColours(canvas, mesh, view_from_model, options);
  } else {
    shadeForm(canvas, mesh, view_from_model, options);
    darkenSteps(canvas, options.scale);
  }
  return canvas;
}

ViewPicture averaged(const Canvas& canvas) {
  ViewPicture picture{{}, canvas.corner, canvas.dpi};
  const cv::Mat fine = canvas.colours.empty() ? cv::Mat(canvas.shade) : cv::Mat(canvas.colours);
  cv::resize(fine, picture.pixels, {}, 1.0 / kOversampling, 1.0 / kOversampling, cv::INTER_AREA);
  if (canvas.colours.empty()) picture.pixels.convertTo(picture.pixels, CV_8U, 255);
  return picture;
}

Picture onPaper(const ViewPicture& view) {
  Picture picture;
  picture.corner = view.corner;
  picture.size = view.size_mm();
  picture.width_px = view.pixels.cols;
  picture.height_px = view.pixels.rows;
  picture.ink = view.pixels.channels() == 1 ? Ink::Black : Ink::Colours;
  picture.jpeg = images::encodedJpeg(view.pixels, {.quality = picture.ink == Ink::Black ? 92 : 95});
  return picture;
}

}  // namespace

Vector2d ViewPicture::size_mm() const {
  return Vector2d(pixels.cols, pixels.rows) * kMmPerInch / dpi;
}

ViewPicture pictureOf(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                      const ViewOptions& options) {
  return averaged(render(mesh, view_from_model, options));
}

SherdView drawView(const TriangleMesh& mesh, const Eigen::Isometry3d& view_from_model,
                   const ViewOptions& options) {
  const Canvas canvas = render(mesh, view_from_model, options);
  const cv::Mat1b mask = canvas.depth > kFarthest;
  SherdView view;
  view.sheet.items.emplace_back(onPaper(averaged(canvas)));
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  Shape outline;
  outline.closed = true;
  outline.stroke = 0.0;
  outline.stroke_mm = 0.3;
  for (const auto& contour : contours) {
    if (contour.size() < 8) continue;
    std::vector<cv::Point> simple;
    cv::approxPolyDP(contour, simple, kOutlineError_mm * canvas.per_mm(), true);
    auto& line = outline.lines.emplace_back();
    for (const cv::Point& p : simple) {
      line.push_back(canvas.corner + Vector2d(p.x + 0.5, p.y + 0.5) / canvas.per_mm());
      view.box.extend(line.back());
    }
  }
  if (options.surface != Surface::Orthophoto) view.sheet.items.push_back(std::move(outline));
  return view;
}

}  // namespace ostraka::drawing
