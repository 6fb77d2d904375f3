#include "texture/bake.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "base/parallel.h"
#include "texture/fill.h"
#include "texture/gains.h"
#include "texture/seams.h"

namespace ostraka::texture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kCell = 4;             // texels: the coarse band and all choices are made on cells
constexpr double kCoarse = 1.5;      // standard deviation of the coarse band, cells
constexpr double kLeastSight = 0.2;  // more slant shows next to nothing
constexpr float kSharp = 6;          // power of the weights in the fine band
constexpr float kOdd = 0.08f;        // share of the level that light may differ without a highlight
constexpr std::size_t kPlaces = 6000;  // for the gains

// A photograph ready for use.
struct Prepared {
  const View* view = nullptr;
  DepthMap depth;
  cv::Mat1b surely;  // inside the sherd, off its edge
  cv::Mat3b coarse;  // the picture's coarse band
  cv::Mat1b detail;  // how much fine band there is around

  bool isSurelySherd(const Vector2d& pixel) const {
    if (!(pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= surely.cols - 1.0 &&
          pixel.y() <= surely.rows - 1.0))
      return false;
    return surely(cvRound(pixel.y()), cvRound(pixel.x())) != 0;
  }
};

Prepared prepared(const TriangleMesh& mesh, const View& view, double texel_mm) {
  Prepared p{&view, DepthMap(mesh, view), {}, {}, {}};
  // Two pixels off the outline, or one and a half of the mask's own.
  const int off = std::max(2, static_cast<int>(std::ceil(1.5 * view.mask_step)));
  cv::erode(view.mask >= 128, p.surely,
            cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * off + 1, 2 * off + 1}), {-1, -1}, 1,
            cv::BORDER_CONSTANT, cv::Scalar(0));
  const double pixel_mm = finestPixel_mm(mesh, {view});
  const double sigma =
      pixel_mm > 0 ? std::clamp(kCoarse * kCell * texel_mm / pixel_mm, 1.0, 50.0) : 1;
  // Of the sherd only: what lies around it is no part of its colour.
  cv::Mat1f inside, inside_blurred;
  cv::Mat1b(view.mask >= 128).convertTo(inside, CV_32F, 1 / 255.0);
  cv::GaussianBlur(inside, inside_blurred, {}, sigma);
  cv::Mat3f picture;
  view.picture.convertTo(picture, CV_32F);
  cv::Mat3f coarse(picture.size());
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) coarse(y, x) = picture(y, x) * inside(y, x);
  cv::GaussianBlur(coarse, coarse, {}, sigma);
  cv::Mat1f detail(picture.size());
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      coarse(y, x) *= 1 / std::max(inside_blurred(y, x), 1e-3f);
      const cv::Vec3f fine = picture(y, x) - coarse(y, x);
      detail(y, x) = inside(y, x) * (std::abs(fine[0]) + std::abs(fine[1]) + std::abs(fine[2]));
    }
  cv::GaussianBlur(detail, detail, {}, sigma);
  coarse.convertTo(p.coarse, CV_8U);
  detail.convertTo(p.detail, CV_8U);
  return p;
}

// By the four pixels around.
template <class Sum, class Value>
Sum linearAt(const cv::Mat_<Value>& m, const Vector2d& pixel) {
  const auto x = static_cast<int>(std::clamp(std::floor(pixel.x()), 0.0, m.cols - 1.0));
  const auto y = static_cast<int>(std::clamp(std::floor(pixel.y()), 0.0, m.rows - 1.0));
  const int x1 = std::min(x + 1, m.cols - 1), y1 = std::min(y + 1, m.rows - 1);
  const auto fx = static_cast<float>(std::clamp(pixel.x() - x, 0.0, 1.0));
  const auto fy = static_cast<float>(std::clamp(pixel.y() - y, 0.0, 1.0));
  return (1 - fy) * ((1 - fx) * Sum(m(y, x)) + fx * Sum(m(y, x1))) +
         fy * ((1 - fx) * Sum(m(y1, x)) + fx * Sum(m(y1, x1)));
}

// Catmull and Rom's cubic: keeps what a linear one would blur.
cv::Vec3f cubicAt(const cv::Mat3b& m, const Vector2d& pixel) {
  const int x0 = static_cast<int>(std::floor(pixel.x())),
            y0 = static_cast<int>(std::floor(pixel.y()));
  const auto weights = [](double t) {
    return std::array<float, 4>{static_cast<float>(((-0.5 * t + 1) * t - 0.5) * t),
                                static_cast<float>((1.5 * t - 2.5) * t * t + 1),
                                static_cast<float>(((-1.5 * t + 2) * t + 0.5) * t),
                                static_cast<float>((0.5 * t - 0.5) * t * t)};
  };
  const auto wx = weights(pixel.x() - x0), wy = weights(pixel.y() - y0);
  cv::Vec3f sum(0, 0, 0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const cv::Vec3b& level =
          m(std::clamp(y0 + j - 1, 0, m.rows - 1), std::clamp(x0 + i - 1, 0, m.cols - 1));
      const float w = wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)];
      for (int k = 0; k < 3; ++k) sum[k] += w * static_cast<float>(level[k]);
    }
  return sum;
}

struct Place {
  Vector3d point, normal;
};

class Baking {
 public:
  Baking(const TriangleMesh& mesh, const Atlas& atlas, Texels texels,
         const std::vector<View>& views, const std::optional<Light>& light, int threads)
      : mesh_(mesh),
        texels_(std::move(texels)),
        light_(light),
        threads_(threads),
        cells_((atlas.height - 1) / kCell + 1, (atlas.width - 1) / kCell + 1, -1) {
    views_.reserve(views.size());
    std::vector<std::optional<Prepared>> ready(views.size());
    parallelFor(views.size(), threads,
                [&](std::size_t v) { ready[v] = prepared(mesh, views[v], atlas.texel_mm); });
    for (std::optional<Prepared>& view : ready) views_.push_back(std::move(*view));
    for (int cy = 0; cy < cells_.rows; ++cy)
      for (int cx = 0; cx < cells_.cols; ++cx)
        if (const std::optional<Place> place = placeOfCell(cx, cy)) {
          cells_(cy, cx) = static_cast<int>(places_.size());
          places_.push_back(*place);
        }
  }

  void look() {
    samples_.assign(places_.size(), std::vector<Sample>(views_.size()));
    parallelForRanges(places_.size(), 256, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t v = 0; v < views_.size(); ++v)
          samples_[i][v] = sampleOf(places_[i], views_[v]);
    });
    std::vector<std::vector<Sample>> some;
    const std::size_t step = places_.size() / kPlaces + 1;
    for (std::size_t i = 0; i < samples_.size(); i += step) some.push_back(samples_[i]);
    gains_ = gainsOf(some).cast<float>();
  }

  // The coarse band of each cell, and the weights of the fine one; weights then sum to 1.
  void choose() {
    coarse_.assign(places_.size(), Vector3f::Zero());
    parallelForRanges(places_.size(), 256, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) chooseFor(samples_[i], coarse_[i]);
    });
  }

  Texture drawn(const std::vector<Seam>& seams) const {
    const int width = texels_.face.cols, height = texels_.face.rows;
    const cv::Mat3f coarse = coarsePage();
    cv::Mat3f page(height, width, cv::Vec3f(0, 0, 0));
    Texture texture;
    texture.seen = cv::Mat1b::zeros(height, width);
    parallelForRanges(
        static_cast<std::size_t>(height), 16, threads_, [&](std::size_t begin, std::size_t end) {
          for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
            for (int x = 0; x < width; ++x) {
              const int cell = texels_.face(y, x) < 0 ? -1 : cells_(y / kCell, x / kCell);
              if (cell < 0) continue;
              if (drawTexel(x, y, samples_[static_cast<std::size_t>(cell)], coarse(y, x),
                            page(y, x)))
                texture.seen(y, x) = 255;
            }
        });
    std::int64_t all = 0, seen = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        all += texels_.face(y, x) >= 0 ? 1 : 0;
        seen += texture.seen(y, x) != 0 ? 1 : 0;
      }
    texture.seen_share = all > 0 ? static_cast<double>(seen) / static_cast<double>(all) : 0;
    page = filled(page, texture.seen);
    levelSeams(page, texels_.face, texture.seen, seams, threads_);
    page.convertTo(texture.picture, CV_8U);
    return texture;
  }

 private:
  Place placeAt(int x, int y) const {
    const auto& t = mesh_.triangles[static_cast<std::size_t>(texels_.face(y, x))];
    const cv::Vec2f& w = texels_.weights(y, x);
    const float c = 1 - w[0] - w[1];
    const auto mixed = [&](const std::vector<Vector3f>& of) {
      return Vector3f(w[0] * of[t[0]] + w[1] * of[t[1]] + c * of[t[2]]).cast<double>().eval();
    };
    return {mixed(mesh_.vertices), mixed(mesh_.normals).normalized()};
  }

  // Of the texel of a chart that lies nearest the cell's middle.
  std::optional<Place> placeOfCell(int cx, int cy) const {
    int best = 1000;
    cv::Point at;
    for (int y = cy * kCell; y < std::min((cy + 1) * kCell, texels_.face.rows); ++y)
      for (int x = cx * kCell; x < std::min((cx + 1) * kCell, texels_.face.cols); ++x) {
        const int dx = 2 * (x - cx * kCell) - kCell + 1, dy = 2 * (y - cy * kCell) - kCell + 1;
        if (texels_.face(y, x) >= 0 && dx * dx + dy * dy < best)
          best = dx * dx + dy * dy, at = {x, y};
      }
    return best == 1000 ? std::nullopt : std::optional(placeAt(at.x, at.y));
  }

  // A level, BGR, as photographed at a place, without the light that fell there.
  Vector3f inEvenLight(const cv::Vec3f& level, const View& view, const Vector3d& normal) const {
    const Vector3f bgr(level[0], level[1], level[2]);
    return light_ ? light_->without(bgr, view.light_from_mesh * normal) : bgr;
  }

  Sample sampleOf(const Place& place, const Prepared& p) const {
    const Vector3d in_camera = p.view->camera_from_mesh * place.point;
    if (!p.view->isInSight(in_camera)) return {};
    const Vector3d normal = p.view->camera_from_mesh.linear() * place.normal;
    const double cosine = -normal.dot(in_camera.normalized());
    if (cosine < kLeastSight) return {};
    const Vector2d pixel = p.view->intrinsics.project(in_camera) - p.view->corner.cast<double>();
    if (!p.isSurelySherd(pixel)) return {};
    if (!p.depth.sees(pixel, in_camera.z(), cosine)) return {};
    const cv::Vec3f level = linearAt<cv::Vec3f>(p.coarse, pixel);
    // Pixels to a mm^2 of surface, with a factor for what the lens has blurred there.
    const double density = p.view->intrinsics.fx / in_camera.z();
    const double detail = 1 + linearAt<float>(p.detail, pixel);
    return {inEvenLight(level, *p.view, place.normal),
            static_cast<float>(cosine * density * density * detail)};
  }

  void chooseFor(std::vector<Sample>& samples, Vector3f& coarse) const {
    std::vector<float> levels;
    const auto levelOf = [&](std::size_t v) {
      return samples[v]
          .level.cwiseProduct(gains_.row(static_cast<Eigen::Index>(v)).transpose())
          .sum();
    };
    for (std::size_t v = 0; v < samples.size(); ++v)
      if (samples[v].weight > 0) levels.push_back(levelOf(v));
    if (levels.empty()) return;
    if (levels.size() >= 3) {
      const float middle = medianOf(levels);
      for (float& level : levels) level = std::abs(level - middle);
      const float most = std::max(3 * 1.4826f * medianOf(levels), kOdd * middle);
      for (std::size_t v = 0; v < samples.size(); ++v)
        if (samples[v].weight > 0 && std::abs(levelOf(v) - middle) > most) samples[v].weight = 0;
    }
    float sum = 0, largest = 0;
    for (std::size_t v = 0; v < samples.size(); ++v) {
      coarse += samples[v].weight *
                samples[v].level.cwiseProduct(gains_.row(static_cast<Eigen::Index>(v)).transpose());
      sum += samples[v].weight;
      largest = std::max(largest, samples[v].weight);
    }
    coarse /= sum;
    sum = 0;
    for (Sample& s : samples) {
      s.weight = std::pow(s.weight / largest, kSharp);
      if (s.weight < 0.02f) s.weight = 0;
      sum += s.weight;
    }
    for (Sample& s : samples) s.weight /= sum;
  }

  // Cells brought to texels; those that nothing shows are left out.
  cv::Mat3f coarsePage() const {
    cv::Mat3f levels = cv::Mat3f::zeros(cells_.size());
    cv::Mat1f there = cv::Mat1f::zeros(cells_.size());
    for (int y = 0; y < cells_.rows; ++y)
      for (int x = 0; x < cells_.cols; ++x)
        if (const int cell = cells_(y, x);
            cell >= 0 && !coarse_[static_cast<std::size_t>(cell)].isZero()) {
          const Vector3f& c = coarse_[static_cast<std::size_t>(cell)];
          levels(y, x) = {c[0], c[1], c[2]};
          there(y, x) = 1;
        }
    cv::resize(levels, levels, {}, kCell, kCell, cv::INTER_LINEAR);
    cv::resize(there, there, {}, kCell, kCell, cv::INTER_LINEAR);
    for (int y = 0; y < levels.rows; ++y)
      for (int x = 0; x < levels.cols; ++x) levels(y, x) *= 1 / std::max(there(y, x), 1e-3f);
    return levels;
  }

  bool drawTexel(int x, int y, const std::vector<Sample>& samples, const cv::Vec3f& coarse,
                 cv::Vec3f& out) const {
    const Place place = placeAt(x, y);
    cv::Vec3f fine(0, 0, 0);
    float sum = 0;
    for (std::size_t v = 0; v < samples.size(); ++v) {
      if (!(samples[v].weight > 0)) continue;
      const Vector2d pixel = views_[v].view->project(place.point);
      // The cell is seen; beside it the outline may run.
      if (!views_[v].isSurelySherd(pixel)) continue;
      const cv::Vec3f level = linearAt<cv::Vec3f>(views_[v].coarse, pixel),
                      difference = cubicAt(views_[v].view->picture, pixel) - level;
      const Vector3f even = inEvenLight(level, *views_[v].view, place.normal);
      for (int k = 0; k < 3; ++k)
        fine[k] += samples[v].weight * gains_(static_cast<Eigen::Index>(v), k) * difference[k] *
                   (light_ ? even[k] / std::max(level[k], 1.f) : 1.f);
      sum += samples[v].weight;
    }
    if (sum > 0) out = coarse + fine / sum;
    return sum > 0;
  }

  const TriangleMesh& mesh_;
  Texels texels_;
  const std::optional<Light>& light_;
  int threads_;
  cv::Mat1i cells_;  // index of the place, -1: no chart
  std::vector<Prepared> views_;
  std::vector<Place> places_;                 // of the cells
  std::vector<std::vector<Sample>> samples_;  // by place and photograph
  Eigen::MatrixX3f gains_;
  std::vector<Vector3f> coarse_;
};

}  // namespace

Result<Texture> bake(const TriangleMesh& mesh, const std::vector<Chart>& charts, const Atlas& atlas,
                     const std::vector<View>& views, const std::optional<Light>& light, int threads,
                     Progress& progress, const std::stop_token& stop) {
  Baking baking(mesh, atlas, texelsOf(charts, atlas), views, light, threads);
  progress.report(1, 3);
  if (stop.stop_requested()) return Error::cancelled();
  baking.look();
  progress.report(2, 3);
  if (stop.stop_requested()) return Error::cancelled();
  baking.choose();
  Texture texture = baking.drawn(seamsOf(mesh, charts, atlas));
  texture.lit = !light;
  progress.report(3, 3);
  return texture;
}

}  // namespace ostraka::texture
