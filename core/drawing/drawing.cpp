#include "drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drawing/section.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kGap_mm = 9;                  // between section and views, on paper
constexpr double kLikely = 0.9;                // from which a proposed rim is drawn as one
constexpr double kPossible = 0.1;              // below which nothing is said of a rim
constexpr double kMostReconstructed_mm = 400;  // on paper: beyond, the axis is left out

std::string words(const char* format, double a, double b = 0, double c = 0) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

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

class Composer {
 public:
  Composer(const TriangleMesh& mesh, const std::string& id, const DrawingOptions& options)
      : mesh_(mesh), options_(options) {
    out_.id = id;
  }

  Result<SherdDrawing> run() {
    out_.remarks = options_.remarks;
    const Walls walls = findWalls(mesh_);
    out_.measures = model::measure(mesh_);
    if (options_.rim != RimChoice::No) out_.rim = findRim(walls);
    decide();
    if (options_.rim == RimChoice::Yes && !out_.drawn_as_rim)
      return Error{
          ErrorCode::UnusableInput,
          "No stretch of the edge can be a piece of a rim; draw this sherd as one without a rim.",
          out_.id};
    outer_ = out_.drawn_as_rim ? out_.rim->vessel_from_model : frameByAxes(walls);
    // An axis that is not known may lie kilometres away: only how the sherd stands is kept of it.
    if (out_.drawn_as_rim && !saysDiameter())
      outer_.pretranslate(Vector3d(-(outer_ * walls.centre).x(), 0, 0));
    draw();
    return std::move(out_);
  }

 private:
  void decide() {
    if (!out_.rim) return;
    const double p = out_.rim->probability;
    out_.drawn_as_rim = options_.rim == RimChoice::Yes || p >= kLikely;
    if (options_.rim == RimChoice::Yes) {
      if (p < 0.5)
        out_.remarks.push_back(words(
            "What was taken for the lip hardly looks like one (%.0f %%), so no diameter is stated; "
            "check how the sherd stands.",
            100 * p));
      else
        sayWhyNoDiameter();
      return;
    }
    if (out_.drawn_as_rim && p < 0.99)
      out_.remarks.push_back(
          words("Drawn as a rim, which is likely (%.0f %%); check it.", 100 * p));
    else if (!out_.drawn_as_rim && p >= kPossible)
      out_.hints.push_back(
          words("May be a rim (%.0f %%); if it is one, say so and draw it again.", 100 * p));
    if (out_.drawn_as_rim) sayWhyNoDiameter();
  }

  bool saysDiameter() const { return out_.drawn_as_rim && out_.rim->saysDiameter(); }
  void sayWhyNoDiameter() {
    if (saysDiameter()) return;
    out_.remarks.emplace_back(
        "The piece of the rim is too short or too straight for a diameter; check how the sherd "
        "stands.");
  }

  ViewOptions viewOptions() const {
    ViewOptions view;
    view.scale = options_.scale;
    view.surface = options_.surface;
    return view;
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
    const SherdView outer = drawView(mesh_, outer_, viewOptions());
    const SherdView inner = drawView(mesh_, fromBehind(outer_), viewOptions());
    const double rim_radius = saysDiameter() ? options_.scale * out_.rim->diameter_mm / 2 : 0;
    const bool reconstructed = saysDiameter() && 2 * rim_radius <= kMostReconstructed_mm;
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
    caption();
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

  void caption() {
    double y = out_.box.max().y() + 6;
    const double x = out_.box.min().x();
    const auto line = [&](const std::string& text, double size, Weight weight) {
      const Text drawn{{x, y}, size, text, Anchor::Left, weight};
      out_.sheet.items.push_back(drawn);
      out_.box.extend(Vector2d(x + textWidth(drawn), y + 1));
      y += 1.45 * size;
    };
    line(out_.id, 4, Weight::Bold);
    if (saysDiameter()) {
      const RimEstimate& rim = *out_.rim;
      std::string text = words("\xC3\x98 %.1f cm (95 %%: %.1f to %.1f), ", rim.diameter_mm / 10,
                               rim.low_mm / 10, rim.high_mm / 10);
      text += words("%.0f %% of the rim kept (%.0f to %.0f)", 100 * rim.kept, 100 * rim.kept_low,
                    100 * rim.kept_high);
      line(text, 3, Weight::Plain);
    }
    const model::Measures& m = out_.measures;
    line(words("%.1f x %.1f mm", m.length_mm, m.width_mm) +
             (m.thickness_mean_mm > 0 ? words(", wall %.1f mm (%.1f to %.1f)", m.thickness_mean_mm,
                                              m.thickness_min_mm, m.thickness_max_mm)
                                      : ""),
         3, Weight::Plain);
    for (const std::string& remark : out_.remarks) line(remark, 2.6, Weight::Plain);
  }

  const TriangleMesh& mesh_;
  const DrawingOptions& options_;
  Eigen::Isometry3d outer_ = Eigen::Isometry3d::Identity();
  SherdDrawing out_;
};

}  // namespace

Result<void> DrawingOptions::check() const {
  if (!(scale >= 0.05 && scale <= 5))
    return Error{
        ErrorCode::UnusableInput, "The drawing's scale must lie between 1:20 and 5:1.", {}};
  return {};
}

Result<SherdDrawing> drawSherd(const TriangleMesh& mesh, const std::string& id,
                               const DrawingOptions& options) {
  if (const Result<void> good = options.check(); !good) return good.error();
  std::string why;
  if (mesh.triangles.empty() || !model::isClosedManifold(mesh, &why))
    return Error{ErrorCode::UnusableInput,
                 "A drawing needs a closed model" + (why.empty() ? "" : " (" + why + ")") +
                     "; make it with 'ostraka process'.",
                 id};
  return Composer(mesh, id, options).run();
}

}  // namespace ostraka::drawing
