#include "drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/message.h"
#include "drawing/caption.h"
#include "drawing/section.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kGap_mm = 9;                  // between section and views, on paper
constexpr double kLikely = 0.9;                // from which a proposed rim is drawn as one
constexpr double kPossible = 0.1;              // below which nothing is said of a rim
constexpr double kEntered = 0.051;             // of what is entered to a tenth
constexpr double kMostReconstructed_mm = 400;  // on paper: beyond, the axis is left out

// Which of the two faces bulges: along its own normals the middle lies above the ends.
bool outwardAlongZ(const Walls& walls) {
  double product = 0;
  for (const WallPoint& point : walls.points) {
    const Vector3d d = walls.axes.transpose() * (point.p - walls.centre);
    const Vector3d n = walls.axes.transpose() * point.normal;
    // On a bulging face normals lean away from the middle.
    const double away = d.head<2>().dot(n.head<2>());
    product += n.z() > 0 ? away : -away;
  }
  return product > 0;
}

// A view's frame looks along -x at y to the right, z up. By principal axes: outer side to the
// viewer, longest axis upright.
Eigen::Isometry3d frameByAxes(const Walls& walls) {
  Vector3d towards = walls.axes.col(2);
  if (!outwardAlongZ(walls)) towards = -towards;
  const Vector3d up = walls.axes.col(0);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() << towards.transpose(), up.cross(towards).transpose(), up.transpose();
  frame.translation() = -frame.linear() * walls.centre;
  return frame;
}

Eigen::Isometry3d fromBehind(const Eigen::Isometry3d& frame) {
  return Eigen::AngleAxisd(M_PI, Vector3d::UnitZ()) * frame;
}

ViewOptions viewOptions(const DrawingOptions& options) {
  ViewOptions view;
  view.scale = options.scale;
  view.dpi = options.dpi;
  view.surface = options.surface;
  view.photographs = options.photographs;
  return view;
}

class Composer {
 public:
  Composer(const TriangleMesh& mesh, const Message& id, const DrawingOptions& options)
      : mesh_(mesh), options_(options) {
    out_.id = id;
  }

  Result<SherdDrawing> run() {
    out_.remarks = options_.remarks;
    if (options_.surface == Surface::Orthophoto && options_.photographs == nullptr)
      out_.remarks.push_back(message(
          "The model has no photographs, so the orthophoto shows the colours of its vertices."));
    const Walls walls = findWalls(mesh_);
    out_.measures = printedMeasures();
    if (options_.rim != RimChoice::No) out_.rim = findRim(walls);
    decide();
    if (options_.rim == RimChoice::Yes && !out_.drawn_as_rim)
      return Error::unusable(
          message("No part of the edge can be a rim; draw this sherd without a rim."),
          out_.id.english());
    outer_ = out_.drawn_as_rim ? out_.rim->vessel_from_model : frameByAxes(walls);
    placeAxis(walls);
    out_.outer_from_model = outer_;
    draw();
    return std::move(out_);
  }

 private:
  void decide() {
    if (!out_.rim) return;
    const double p = out_.rim->probability;
    const Decimal percent = decimal(100 * p, 0);
    out_.drawn_as_rim = options_.rim == RimChoice::Yes || p >= kLikely;
    if (options_.rim == RimChoice::Yes) {
      if (p < kLikelyLip && byHand("rim_diameter"))
        out_.remarks.push_back(
            message("The edge taken as the lip barely resembles one (%1 %); check the sherd's "
                    "orientation.",
                    percent));
      else if (p < kLikelyLip)
        out_.remarks.push_back(
            message("The edge taken as the lip barely resembles one (%1 %), so no diameter is "
                    "given; check the sherd's orientation.",
                    percent));
      else {
        sayWhyNoDiameter();
        if (p < kLikely && out_.rim->saysDiameter() && !byHand("rim_diameter"))
          out_.remarks.push_back(
              message("The edge taken as the lip may be a fracture (%1 % that it is the lip), and "
                      "the diameter may be wrong; check the sherd's orientation.",
                      percent));
      }
      return;
    }
    if (out_.drawn_as_rim && p < 0.99)
      out_.remarks.push_back(
          message("Drawn as a rim sherd, which is likely (%1 %); check it.", percent));
    else if (!out_.drawn_as_rim && p >= kPossible)
      out_.hints.push_back(message(
          "This may be a rim sherd (%1 %); if it is, mark it as one and redraw it.", percent));
    if (out_.drawn_as_rim) sayWhyNoDiameter();
  }

  void sayWhyNoDiameter() {
    if (out_.rim->saysDiameter() || byHand("rim_diameter")) return;
    out_.remarks.emplace_back(
        message("The preserved rim is too short or too straight for a diameter; check the sherd's "
                "orientation."));
  }

  const Estimate* byHand(const char* kind) const {
    const auto found = options_.by_hand.find(kind);
    const bool there = found != options_.by_hand.end() && found->second.value > 0;
    return there ? &found->second : nullptr;
  }

  model::Measures printedMeasures() const {
    model::Measures m = model::measure(mesh_);
    for (const auto& [kind, measure] : {std::pair("length", &m.length_mm),
                                        {"width", &m.width_mm},
                                        {"thickness_min", &m.thickness_min_mm},
                                        {"thickness_mean", &m.thickness_mean_mm},
                                        {"thickness_max", &m.thickness_max_mm}})
      if (const Estimate* measured = byHand(kind)) *measure = measured->value;
    // The model's range is none about a wall that a person measured.
    if (byHand("thickness_mean") && !byHand("thickness_min")) m.thickness_min_mm = 0;
    if (byHand("thickness_mean") && !byHand("thickness_max")) m.thickness_max_mm = 0;
    return m;
  }

  // A hand's value that is the estimate, rounded as it is entered from a drawing, keeps the
  // estimate's interval, which is not symmetric.
  static Estimate printed(const Estimate& measured, const Estimate& found) {
    return std::abs(measured.value - found.value) <= kEntered ? found : measured;
  }

  void decideMouth() {
    Mouth& mouth = out_.mouth.emplace();
    const RimEstimate* rim = out_.drawn_as_rim ? &*out_.rim : nullptr;
    if (rim && rim->saysDiameter()) {
      mouth.diameter_mm = {rim->diameter_mm, std::pair(rim->low_mm, rim->high_mm)};
      mouth.kept_pct = {100 * rim->kept, std::pair(100 * rim->kept_low, 100 * rim->kept_high)};
    }
    if (const Estimate* measured = byHand("rim_diameter")) {
      mouth.by_hand = true;
      const Estimate diameter = printed(*measured, mouth.diameter_mm);
      if (diameter.value != mouth.diameter_mm.value) mouth.kept_pct.reset();
      mouth.diameter_mm = diameter;
      if (!mouth.kept_pct && rim && rim->probability >= kLikelyLip)
        mouth.kept_pct =
            Estimate{std::min(100.0, 100 * rim->arc_mm / (std::numbers::pi * diameter.value)), {}};
    }
    if (const Estimate* measured = byHand("rim_pct"))
      mouth.kept_pct = mouth.kept_pct ? printed(*measured, *mouth.kept_pct) : *measured;
    if (mouth.diameter_mm.value == 0) out_.mouth.reset();
  }

  // How far the axis lies from the lip is what the mouth's diameter says; an axis that is not known
  // may lie kilometres away, and only how the sherd stands is kept of it.
  void placeAxis(const Walls& walls) {
    decideMouth();
    if (!out_.drawn_as_rim) return;
    const double off = out_.mouth ? (out_.rim->diameter_mm - out_.mouth->diameter_mm.value) / 2
                                  : (outer_ * walls.centre).x();
    outer_.pretranslate(Vector3d(-off, 0, 0));
  }

  // The section's loops on paper, its outer side to the left.
  std::vector<Loop> section() const {
    // The plane y = 0 of the outer view: seen from the sherd's right, the outer side is at the
    // left.
    const Eigen::Isometry3d cut_from_outer(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()));
    std::vector<Loop> loops = cut(mesh_, cut_from_outer * outer_);
    for (Loop& loop : loops)
      for (Vector2d& p : loop) p = options_.scale * Vector2d(-p.x(), -p.y());
    return loops;
  }

  void draw() {
    const std::vector<Loop> loops = section();
    Eigen::AlignedBox2d section_box;
    for (const Loop& loop : loops)
      for (const Vector2d& p : loop) section_box.extend(p);
    const SherdView outer = drawView(mesh_, outer_, viewOptions(options_));
    const SherdView inner = drawView(mesh_, fromBehind(outer_), viewOptions(options_));
    const bool mouth = out_.drawn_as_rim && out_.mouth;
    const double rim_radius = mouth ? options_.scale * out_.mouth->diameter_mm.value / 2 : 0;
    const bool reconstructed = mouth && 2 * rim_radius <= kMostReconstructed_mm;
    // A rim's section stands at its own radius left of the axis; otherwise everything stands in a
    // row, the section's left end at 0.
    double x = reconstructed ? 0 : -section_box.min().x();
    drawSection(loops, {x, 0});
    x += reconstructed ? 0 : section_box.max().x();
    // The outer view, right of the axis.
    double left =
        reconstructed ? std::max(kGap_mm, rim_radius - outer.box.sizes().x()) : x + kGap_mm;
    place(outer, left);
    drawSectionMarks(outer, left);
    double right = left + outer.box.sizes().x();
    if (reconstructed) {
      drawMouth(rim_radius, section_box);
      right = std::max(right, rim_radius);
    }
    place(inner, right + kGap_mm);
    addCaption(out_, options_.wording);
  }

  void place(const SherdView& view, double left) {
    const Vector2d shift(left - view.box.min().x(), 0);
    out_.sheet.add(view.sheet, shift);
    out_.box.extend(view.box.min() + shift);
    out_.box.extend(view.box.max() + shift);
  }

  void drawSection(const std::vector<Loop>& loops, const Vector2d& shift) {
    Shape outline;
    outline.closed = true;
    outline.stroke = 0.0;
    outline.stroke_mm = 0.35;
    for (const Loop& loop : loops) {
      auto& line = outline.lines.emplace_back(loop);
      for (Vector2d& p : line) {
        p += shift;
        out_.box.extend(p);
      }
    }
    out_.sheet.items.push_back(hatched(outline.lines, -M_PI / 4, 1.0, 0.12));
    out_.sheet.items.push_back(std::move(outline));
  }

  // Short strokes above and below the outer view where the section is taken.
  void drawSectionMarks(const SherdView& view, double left) {
    const double x = left - view.box.min().x();
    for (const double y : {view.box.min().y() - 4.5, view.box.max().y() + 1.5}) {
      out_.sheet.line({x, y}, {x, y + 3}, 0.25);
      out_.box.extend(Vector2d(x, y));
      out_.box.extend(Vector2d(x, y + 3));
    }
  }

  // Rim line and axis of the vessel.
  void drawMouth(double radius, const Eigen::AlignedBox2d& section) {
    const double bottom = section.max().y() + 4;
    out_.sheet.line({-radius, 0}, {radius, 0}, 0.2);
    out_.sheet.line({0, 0}, {0, bottom}, 0.2, 3);
    out_.box.extend(Vector2d(-radius, 0));
    out_.box.extend(Vector2d(radius, bottom));
  }

  const TriangleMesh& mesh_;
  const DrawingOptions& options_;
  Eigen::Isometry3d outer_ = Eigen::Isometry3d::Identity();
  SherdDrawing out_;
};

}  // namespace

Result<void> DrawingOptions::check() const {
  if (!(scale >= 0.05 && scale <= 5))
    return Error::unusable(message("The drawing's scale must be between 1:20 and 5:1."));
  return {};
}

Result<SherdDrawing> drawSherd(const TriangleMesh& mesh, const Message& id,
                               const DrawingOptions& options) {
  if (const Result<void> good = options.check(); !good) return good.error();
  if (const Result<void> good = model::checkExtent(mesh, id.english()); !good) return good.error();
  Message why;
  if (mesh.triangles.empty() || !model::isClosedManifold(mesh, &why))
    return Error::unusable(
        why.empty()
            ? message("A drawing needs a closed model; create one with 'ostraka process'.")
            : message("A drawing needs a closed model (%1); create one with 'ostraka process'.",
                      why),
        id.english());
  if (options.surface == Surface::Orthophoto && options.photographs == nullptr &&
      mesh.colors.size() != mesh.vertices.size())
    return Error::unusable(
        message("The model has neither photographs nor colours, so there is no orthophoto of it; "
                "draw its shaded form."),
        id.english());
  return Composer(mesh, id, options).run();
}

ViewPicture pictureOf(const TriangleMesh& mesh, const SherdDrawing& drawing,
                      const DrawingOptions& options) {
  const ViewOptions view = viewOptions(options);
  ViewPicture both = pictureOf(mesh, drawing.outer_from_model, view);
  const cv::Mat outer = both.pixels,
                inner = pictureOf(mesh, fromBehind(drawing.outer_from_model), view).pixels;
  const int gap = static_cast<int>(kGap_mm * both.dpi / kMmPerInch);
  both.pixels = cv::Mat(std::max(outer.rows, inner.rows), outer.cols + gap + inner.cols,
                        outer.type(), cv::Scalar::all(255));
  outer.copyTo(both.pixels(cv::Rect(0, 0, outer.cols, outer.rows)));
  inner.copyTo(both.pixels(cv::Rect(outer.cols + gap, 0, inner.cols, inner.rows)));
  return both;
}

}  // namespace ostraka::drawing
