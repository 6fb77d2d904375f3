#include "registration/silhouettes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "base/parallel.h"
#include "cloud/bounds.h"
#include "cloud/nearest.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kBlur_px = 1.5;     // picture and points alike, so that corners shrink alike
constexpr double kMostReach_px = 6;  // start poses from the strips hold to a millimetre
// The side that moves counts where the other ends this far inside: a mask holds to half a pixel.
constexpr double kMargin_px = 0.5;
constexpr double kMinSigma_px = 0.25;  // masks' edges hold to a quarter of a pixel
constexpr double kBump_px = 12;        // a bump of the scan's end shows in several pixels ...
constexpr double kViewsAlike = 3;  // ... and in as many of 24 views, by chi-square at true poses
// SD of the moving side's excess over the mask about the still's.
constexpr double kFatness_px = 0.5;
// SD of what outlines that face down err beside it: scans hang skirts there, masks take in the
// shadow under a sherd.
constexpr double kLower_px = 0.5;

using Derivative = Eigen::Matrix<double, 2, 3>;

// d(pixel)/d(point in the plate frame), the distortion of a standard lens left aside (its slope is
// below 1 %).
Derivative derivative(const rig::PosedImage& camera, const Vector3d& p_plate) {
  const Vector3d p = camera.camera_from_plate * p_plate;
  const double fx = camera.intrinsics.fx, fy = camera.intrinsics.fy;
  Derivative d;
  d << fx / p.z(), 0, -fx * p.x() / (p.z() * p.z()), 0, fy / p.z(), -fy * p.y() / (p.z() * p.z());
  const rig::Distortion& lens = camera.intrinsics.distortion;
  if (lens.lens != rig::Lens::Standard)
    d = Eigen::DiagonalMatrix<double, 2>(fx, fy) * lens.slope(p.head<2>() / p.z()) *
        Eigen::DiagonalMatrix<double, 2>(1 / fx, 1 / fy) * d;
  return d * camera.camera_from_plate.linear();
}

std::vector<Vector2f> project(const rig::PosedImage& camera, std::span<const Vector3f> points,
                              const Eigen::Isometry3d& plate_from_points) {
  std::vector<Vector2f> pixels;
  pixels.reserve(points.size());
  for (const Vector3f& p : points)
    pixels.push_back(camera.project(plate_from_points * p.cast<double>()).cast<float>());
  return pixels;
}

Vector3f flatPoint(const Vector2d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f};
}

std::vector<Vector3f> flatPoints(const std::vector<Vector2d>& points) {
  std::vector<Vector3f> flat(points.size());
  std::transform(points.begin(), points.end(), flat.begin(), flatPoint);
  return flat;
}

// The mask around the sherd, blurred as the points' coverage is. Empty outside the photograph.
Coverage cutOut(const cv::Mat1b& mask, const Coverage& around, double blur) {
  Coverage coverage;
  const int x0 = std::max(0, static_cast<int>(around.origin.x()) - 10);
  const int y0 = std::max(0, static_cast<int>(around.origin.y()) - 10);
  const int x1 = std::min(
      mask.cols, static_cast<int>(around.origin.x() + around.cell * around.picture.cols) + 10);
  const int y1 = std::min(
      mask.rows, static_cast<int>(around.origin.y() + around.cell * around.picture.rows) + 10);
  if (x1 - x0 < 8 || y1 - y0 < 8) return coverage;
  coverage.origin = Vector2d(x0, y0);
  mask(cv::Rect(x0, y0, x1 - x0, y1 - y0)).convertTo(coverage.picture, CV_32F, 1.0 / 255);
  cv::GaussianBlur(coverage.picture, coverage.picture, cv::Size(0, 0), blur);
  return coverage;
}

// Where the side that made this shot's scan ends at the mask's outline too, it hides the other
// side's end, which may then lie anywhere inside. That is asked once, of the mask and a scan that
// both lie still: asked of the moving outline, it would keep the points that lie wrong.
Outline madeByTheMoving(const Outline& mask, const Coverage& still, double margin_px) {
  Outline free;
  for (std::size_t i = 0; i < mask.points.size(); ++i) {
    if (still.at(mask.points[i] - margin_px * mask.normals[i]) > 0.5) continue;
    free.points.push_back(mask.points[i]);
    free.normals.push_back(mask.normals[i]);
  }
  return free;
}

// How far the still side's own end lies outside the mask where it made the outline: pictures of
// points are wider than photographs by half a cell or so, scans and masks end where they end. The
// pose has no part in it, and the moving side's end errs alike.
void addExcess(const Outline& mask, const Outline& still, double margin_px,
               std::vector<double>& excess_px) {
  const std::vector<Vector3f> ends = flatPoints(still.points);
  const KdTree tree(ends);
  for (std::size_t i = 0; i < mask.points.size(); ++i) {
    const Neighbour near = tree.nearest(flatPoint(mask.points[i]), 3.0f);
    if (near.index < 0) continue;
    const auto k = static_cast<std::size_t>(near.index);
    if (still.normals[k].dot(mask.normals[i]) < 0.7071) continue;
    const double out = mask.normals[i].dot(still.points[k] - mask.points[i]);
    if (out > -margin_px) excess_px.push_back(out);
  }
}

// Pixels within `near` of the outline. The ends that leaving out the others makes lie farther away
// than any match reaches.
std::vector<std::size_t> nearOutline(const Outline& outline, std::span<const Vector2f> pixels,
                                     double near) {
  std::vector<std::size_t> kept;
  if (outline.points.empty()) return kept;
  auto [low, high] = boundsOf(outline.points);
  const int radius = static_cast<int>(std::ceil(near)) + 1;
  low.array() -= radius + 1;
  const Eigen::Vector2i size = ((high - low).array() + radius + 3).cast<int>();
  cv::Mat1b band(size.y(), size.x(), uchar{0});
  const auto place = [&low](const Vector2d& p) {
    return cv::Point(cvRound(p.x() - low.x()), cvRound(p.y() - low.y()));
  };
  for (const Vector2d& p : outline.points)
    cv::circle(band, place(p), radius, cv::Scalar(1), cv::FILLED);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const cv::Point c = place(pixels[i].cast<double>());
    if (c.inside(cv::Rect(0, 0, band.cols, band.rows)) && band(c) != 0) kept.push_back(i);
  }
  return kept;
}

// A misfit, and how far down the outline faces there: 1 at an edge that the sherd has above the
// plate, 0 at an upright one.
struct Match {
  OutlineMatch outline;
  double down;
};

// One fatness for all views of a side (a fat strip, a soft mask), unknown and marginalised, and one
// more for what faces down: it shifts all sherds of a batch alike in height (0.08 to 0.10 mm at the
// true poses of one batch), and nothing beside the lower edges shows it. They must not be one per
// view: what moves in a low view is mostly the lower edge, and taking out each view's own mean
// would take out the height.
OutlineFit sideEvidence(std::span<const Match> matches, double independent) {
  OutlineFit fit;
  fit.pairs = static_cast<int>(matches.size());
  if (fit.pairs < 50) return fit;
  std::vector<double> sizes;
  for (const Match& m : matches) sizes.push_back(m.outline.residual);
  const double median = medianOf(sizes);
  for (double& s : sizes) s = std::abs(s - median);
  fit.sigma_mm = std::max(kMinSigma_px, 1.4826 * medianOf(sizes));
  Eigen::Matrix<double, 6, 2> shared = Eigen::Matrix<double, 6, 2>::Zero();
  Eigen::Matrix2d weight = Eigen::Matrix2d::Zero();
  weight(0, 0) = 1 / (kFatness_px * kFatness_px);
  weight(1, 1) = 1 / (kLower_px * kLower_px);
  Vector2d slope = Vector2d::Zero();
  for (const Match& m : matches) {
    const OutlineMatch& o = m.outline;
    const double u = (o.residual - median) / (3 * fit.sigma_mm), free = 1 - u * u;
    if (free <= 0) continue;
    const double w = free * free * independent;
    fit.evidence.add(o.residual / fit.sigma_mm, o.row / fit.sigma_mm, w);
    const double w_px = w / (fit.sigma_mm * fit.sigma_mm);
    const Vector2d both(1, m.down);
    shared += w_px * o.row * both.transpose();
    weight += w_px * both * both.transpose();
    slope += w_px * o.residual * both;
  }
  const Eigen::Matrix<double, 6, 2> gain = shared * weight.inverse();
  fit.evidence.information -= gain * shared.transpose();
  fit.evidence.gradient -= gain * slope;
  return fit;
}

}  // namespace

struct SilhouetteConstraint::View {
  const rig::PosedImage* camera = nullptr;
  bool back_moves = false;  // a photograph of the front's shot
  double cell = 1, blur = 1.5;
  Coverage still;  // the side that made this shot's scan
  Outline mask;
  KdTree mask_tree{{}};
  std::vector<double> excess_px;  // of the still side over the mask
  std::vector<Vector3f> moving;   // the points of the other side that may come near the mask's end
};

SilhouetteConstraint::~SilhouetteConstraint() = default;

SilhouetteConstraint::SilhouetteConstraint(const Strip& front, const Strip& back,
                                           std::span<const SilhouetteView> front_views,
                                           std::span<const SilhouetteView> back_views,
                                           const Eigen::Isometry3d& front_from_back, int threads)
    : threads_(threads) {
  views_.resize(front_views.size() + back_views.size());
  const Eigen::Isometry3d same = Eigen::Isometry3d::Identity();
  parallelFor(views_.size(), threads, [&](std::size_t i) {
    const bool of_front = i < front_views.size();
    const SilhouetteView& given = of_front ? front_views[i] : back_views[i - front_views.size()];
    const Strip& still = of_front ? front : back;
    const Strip& moving = of_front ? back : front;
    View& view = views_[i];
    view.camera = &given.camera;
    view.back_moves = of_front;
    const double depth = (given.camera.camera_from_plate * still.centre).z();
    if (!(depth > 0) || given.mask.empty()) return;
    const double px_per_mm = given.camera.intrinsics.fx / depth;
    const double spacing = std::max(front.spacing_mm, back.spacing_mm);
    view.cell = std::max(1.0, 1.3 * spacing * px_per_mm);
    view.blur = std::max(kBlur_px, view.cell);
    view.still = coverageOf(project(given.camera, still.all, same), view.cell, view.blur);
    const Eigen::Isometry3d plate_from_moving =
        of_front ? front_from_back : front_from_back.inverse();
    const std::vector<Vector2f> pixels = project(given.camera, moving.all, plate_from_moving);
    const Coverage around = coverageOf(pixels, view.cell, view.blur);
    if (view.still.picture.empty() || around.picture.empty()) return;
    const Outline whole = outlineOf(cutOut(given.mask, around, view.blur));
    addExcess(whole, outlineOf(view.still), kMargin_px, view.excess_px);
    view.mask = madeByTheMoving(whole, view.still, kMargin_px);
    view.mask_tree = KdTree(flatPoints(view.mask.points));
    // A millimetre that the pose may still move, the reach, and what the blur looks at.
    const double near = px_per_mm + kMostReach_px + 4 * view.blur;
    for (const std::size_t k : nearOutline(view.mask, pixels, near))
      view.moving.push_back(moving.all[k]);
  });
  for (const bool back_moves : {true, false}) {
    std::vector<double> all;
    for (const View& view : views_)
      if (view.back_moves == back_moves)
        all.insert(all.end(), view.excess_px.begin(), view.excess_px.end());
    excess_px_[back_moves ? 0 : 1] = all.size() < 50 ? 0 : medianOf(all);
  }
}

OutlineFit SilhouetteConstraint::evidence(const Eigen::Isometry3d& front_from_back,
                                          const Vector3d& pivot, double reach_px) const {
  std::vector<std::vector<Match>> found(views_.size());
  parallelFor(views_.size(), threads_, [&](std::size_t i) {
    const View& view = views_[i];
    if (view.mask.points.empty()) return;
    const Eigen::Isometry3d plate_from_moving =
        view.back_moves ? front_from_back : front_from_back.inverse();
    const std::vector<Vector2f> pixels = project(*view.camera, view.moving, plate_from_moving);
    const Outline outline = outlineOf(coverageOf(pixels, view.cell, view.blur));
    std::vector<Vector3f> flat;
    for (const Vector2f& p : pixels) flat.emplace_back(p.x(), p.y(), 0.0f);
    const KdTree points(flat);
    std::vector<Match> matches;
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
      const Vector2d& u = outline.points[k];
      const Neighbour near = view.mask_tree.nearest(flatPoint(u), static_cast<float>(reach_px));
      if (near.index < 0) continue;
      const auto m = static_cast<std::size_t>(near.index);
      if (view.mask.normals[m].dot(outline.normals[k]) < 0.7071) continue;
      const int q = points.nearest(flatPoint(u)).index;
      const Vector3d p_moving = view.moving[static_cast<std::size_t>(q)].cast<double>();
      const Vector3d p_plate = plate_from_moving * p_moving;
      const Vector2d n2 = view.mask.normals[m];
      const Vector3d slope = derivative(*view.camera, p_plate).transpose() * n2;  // px per mm
      const Vector3d p_front = view.back_moves ? p_plate : p_moving;
      // Moving the back moves the front against it in the back's photographs.
      const Vector3d n = view.back_moves ? slope : Vector3d(-front_from_back.linear() * slope);
      const double excess = excess_px_[view.back_moves ? 0 : 1];
      const double out = n2.dot(u - view.mask.points[m]) - excess;
      matches.push_back({{out, rowOf(p_front, n, pivot)}, -slope.z() / slope.norm()});
    }
    found[i] = std::move(matches);
  });
  OutlineFit sum;
  for (const bool back_moves : {true, false}) {
    std::vector<Match> matches;
    double cell = 1;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      if (views_[i].back_moves != back_moves) continue;
      matches.insert(matches.end(), found[i].begin(), found[i].end());
      cell = views_[i].cell;
    }
    const double independent = std::min(1.0, cell / kBump_px) / kViewsAlike;
    const OutlineFit fit = sideEvidence(matches, independent);
    sum.evidence += fit.evidence;
    sum.sigma_mm = std::max(sum.sigma_mm, fit.sigma_mm);
    sum.pairs += fit.pairs;
  }
  return sum;
}

}  // namespace ostraka::registration
