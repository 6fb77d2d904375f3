#include "model/preview.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <opencv2/imgproc.hpp>

namespace ostraka::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kSamples = 2;  // per pixel and axis

struct Frame {
  double px_per_mm = 1;
  Vector3d centre = Vector3d::Zero();  // in the view
};

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh, const Matrix3d& view) {
  Eigen::AlignedBox3d box;
  for (const Vector3f& v : mesh.vertices) box.extend(Vector3d(view * v.cast<double>()));
  return box;
}

double fittingScale(const Eigen::AlignedBox3d& box, const PreviewOptions& o) {
  const Vector3d extent = box.sizes().cwiseMax(1e-3);
  const double free = 1 - 2 * o.margin;
  return std::min(free * o.width_px / extent[0], free * o.height_px / extent[1]);
}

// Two lamps and some light from everywhere; the main lamp stands at the upper left, low enough to
// show relief, as archaeological drawings have it.
double shade(const Vector3d& normal) {
  const Vector3d main = Vector3d(-0.55, 0.55, 0.63).normalized(),
                 fill = Vector3d(0.6, -0.2, 0.77).normalized();
  return 0.25 + 0.65 * std::max(0.0, normal.dot(main)) + 0.2 * std::max(0.0, normal.dot(fill));
}

class Raster {
 public:
  Raster(const TriangleMesh& mesh, const Matrix3d& view, const Frame& frame,
         const PreviewOptions& o)
      : mesh_(mesh), o_(o), width_(o.width_px * kSamples), height_(o.height_px * kSamples) {
    const double s = frame.px_per_mm * kSamples;
    for (const Vector3f& v : mesh.vertices) {
      const Vector3d p = view * v.cast<double>() - frame.centre;
      points_.emplace_back(0.5 * width_ + s * p[0] - 0.5, 0.5 * height_ - s * p[1] - 0.5, p[2]);
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
      normals_.push_back(view * mesh.normals[i].cast<double>());
    view_ = view;
    image_ = cv::Mat(height_, width_, CV_8UC3,
                     cv::Scalar(o.background[2], o.background[1], o.background[0]));
    depth_.assign(static_cast<std::size_t>(width_) * height_, -INFINITY);
  }

  cv::Mat run() {
    for (const auto& t : mesh_.triangles) draw(t);
    return image_;
  }

 private:
  void draw(const std::array<int, 3>& t) {
    const Vector3d &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    // Rows run downward: a triangle that faces the viewer turns the other way round.
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if (!(area < 0)) return;
    const auto range = [](double low, double high, int size) {
      return std::pair(std::max(0, static_cast<int>(std::ceil(low))),
                       std::min(size - 1, static_cast<int>(std::floor(high))));
    };
    const auto [x0, x1] = range(std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}), width_);
    const auto [y0, y1] =
        range(std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}), height_);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double wb = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
        const double wc = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
        const double wa = 1 - wb - wc;
        if (wa < 0 || wb < 0 || wc < 0) continue;
        const double z = wa * a[2] + wb * b[2] + wc * c[2];
        double& nearest = depth_[static_cast<std::size_t>(y) * width_ + x];
        if (z <= nearest) continue;
        nearest = z;
        paint(x, y, t, {wa, wb, wc});
      }
  }

  void paint(int x, int y, const std::array<int, 3>& t, const std::array<double, 3>& w) {
    Vector3d normal = Vector3d::Zero(), color = Vector3d::Zero();
    bool seen = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = static_cast<std::size_t>(t[k]);
      if (!normals_.empty()) normal += w[k] * normals_[v];
      const Color& c = mesh_.colors.empty() ? o_.clay : mesh_.colors[v];
      color += w[k] * Vector3d(c[0], c[1], c[2]);
      seen = seen && (mesh_.seen.empty() || mesh_.seen[v]);
    }
    if (normals_.empty())
      normal = view_ * (mesh_.vertices[t[1]] - mesh_.vertices[t[0]])
                           .cross(mesh_.vertices[t[2]] - mesh_.vertices[t[0]])
                           .cast<double>();
    if (o_.color_at) color = o_.color_at(t, w);
    if (!seen) color = Vector3d(o_.filled[0], o_.filled[1], o_.filled[2]);
    const double light = shade(normal.normalized());
    cv::Vec3b& pixel = image_.at<cv::Vec3b>(y, x);
    for (int k = 0; k < 3; ++k)
      pixel[2 - k] = static_cast<std::uint8_t>(std::clamp(light * color[k] + 0.5, 0.0, 255.0));
  }

  const TriangleMesh& mesh_;
  const PreviewOptions& o_;
  int width_, height_;
  Matrix3d view_;
  std::vector<Vector3d> points_, normals_;
  std::vector<double> depth_;
  cv::Mat image_;
};

cv::Mat drawn(const TriangleMesh& mesh, const Matrix3d& view, double px_per_mm,
              const PreviewOptions& o) {
  const Eigen::AlignedBox3d box = boxOf(mesh, view);
  const Frame frame{px_per_mm, 0.5 * (box.min() + box.max())};
  cv::Mat out;
  cv::resize(Raster(mesh, view, frame, o).run(), out, {o.width_px, o.height_px}, 0, 0,
             cv::INTER_AREA);
  return out;
}

// The sherd without a ground: what differs between a white and a black one shines through.
cv::Mat cutOut(const TriangleMesh& mesh, const Matrix3d& view, double px_per_mm, PreviewOptions o) {
  o.background = {255, 255, 255};
  const cv::Mat on_white = drawn(mesh, view, px_per_mm, o);
  o.background = {0, 0, 0};
  const cv::Mat on_black = drawn(mesh, view, px_per_mm, o);
  cv::Mat out(on_white.rows, on_white.cols, CV_8UC4);
  for (int y = 0; y < out.rows; ++y)
    for (int x = 0; x < out.cols; ++x) {
      const cv::Vec3b &white = on_white.at<cv::Vec3b>(y, x), &black = on_black.at<cv::Vec3b>(y, x);
      const int opaque = std::clamp(255 - (white[1] - black[1]), 0, 255);
      cv::Vec4b& pixel = out.at<cv::Vec4b>(y, x);
      for (int k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>(
            opaque == 0 ? 0 : std::min(255, (black[k] * 255 + opaque / 2) / opaque));
      pixel[3] = static_cast<std::uint8_t>(opaque);
    }
  return out;
}

// Rows: right, up, towards the viewer of the front; the longest axis to the right, z of the mesh
// decides which side is the front.
Matrix3d frontView(const TriangleMesh& mesh) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3f& v : mesh.vertices) mean += v.cast<double>();
  mean /= static_cast<double>(mesh.vertices.size());
  Matrix3d covariance = Matrix3d::Zero();
  for (const Vector3f& v : mesh.vertices)
    covariance += (v.cast<double>() - mean) * (v.cast<double>() - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(covariance);
  Vector3d towards = axes.eigenvectors().col(0), right = axes.eigenvectors().col(2);
  if (towards[2] < 0) towards = -towards;
  if (right[0] < 0) right = -right;
  Matrix3d view;
  view.row(0) = right;
  view.row(1) = towards.cross(right);
  view.row(2) = towards;
  return view;
}

}  // namespace

cv::Mat renderView(const TriangleMesh& mesh, const Matrix3d& view_from_model,
                   const PreviewOptions& options) {
  if (mesh.vertices.empty())
    return cv::Mat(options.height_px, options.width_px, CV_8UC3,
                   cv::Scalar(options.background[2], options.background[1], options.background[0]));
  return drawn(mesh, view_from_model, fittingScale(boxOf(mesh, view_from_model), options), options);
}

cv::Mat renderPreview(const TriangleMesh& mesh, const PreviewOptions& options) {
  if (mesh.vertices.empty()) return renderView(mesh, Matrix3d::Identity(), options);
  const Matrix3d front = frontView(mesh);
  const Matrix3d back = Vector3d(-1, 1, -1).asDiagonal() * front;
  // The edge: from below, the front face up.
  Matrix3d edge;
  edge.row(0) = front.row(0);
  edge.row(1) = front.row(2);
  edge.row(2) = -front.row(1);
  double scale = INFINITY;
  for (const Matrix3d& view : {front, back, edge})
    scale = std::min(scale, fittingScale(boxOf(mesh, view), options));
  cv::Mat picture(options.height_px, 3 * options.width_px, CV_8UC4);
  int at = 0;
  for (const Matrix3d& view : {front, back, edge}) {
    cutOut(mesh, view, scale, options)
        .copyTo(picture(cv::Rect(at, 0, options.width_px, options.height_px)));
    at += options.width_px;
  }
  return picture;
}

}  // namespace ostraka::model
