#include "rig/plate_print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/aruco/charuco.hpp>
#include <sstream>

#include "base/message.h"
#include "base/text.h"
#include "rig/marker_dictionary.h"

namespace ostraka::rig {
namespace {

using Eigen::Vector2d;

// Markers' middle to the plate's edge, in markers' sides; paper around the black, in mm.
constexpr double kFromEdge = 20.0 / 24, kPaperMargin_mm = 3.5;
constexpr double kSpacing =
    1.45;  // of the inner edges, in markers' sides: room for paper and shade
constexpr int kFewestMarkers = 6;
constexpr double kLeastFree_mm = 12.5;  // radius of the free disc: a ruler of 20 mm fits
constexpr double kWordsFromEdge_mm = 4;
// Crosses that sheets are glued by: their places along a seam, in radii of the free disc; how far
// an arm reaches over the cut edge; half the line where that edge comes to lie.
constexpr std::array<double, 4> kCrosses{-0.85, -0.55, 0.55, 0.85};
constexpr double kArmBeyondCut_mm = 6, kEdgeMark_mm = 6;

// Lines of at most so many letters, broken between words.
std::vector<std::string> wrapped(const std::string& sentence, std::size_t letters) {
  std::vector<std::string> lines(1);
  std::istringstream stream(sentence);
  for (std::string word; stream >> word;) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > letters)
      lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

double ringRadius(double diameter_mm, double marker_mm) {
  return diameter_mm / 2 - kFromEdge * marker_mm;
}

int markersOnRing(double diameter_mm, double marker_mm) {
  const double inner = ringRadius(diameter_mm, marker_mm) - marker_mm / 2;
  return static_cast<int>(2 * std::numbers::pi * inner / (kSpacing * marker_mm));
}

Vector2d onPaper(const Eigen::Vector3d& p) {
  return {p.x(), -p.y()};
}

// Of the disc that is free of markers and their paper.
double freeRadiusOf(double diameter_mm, double marker_mm) {
  return ringRadius(diameter_mm, marker_mm) - marker_mm / 2 - kPaperMargin_mm;
}

// A ruler of full millimetres from `from`, along `along`, its ticks to the right of it; without
// numbers where another one crosses it, `crossed_mm` from its start.
void drawRuler(Sheet& sheet, const Vector2d& from, const Vector2d& along, double length_mm,
               double crossed_mm = -100) {
  const Vector2d across(-along.y(), along.x());
  sheet.line(from, from + length_mm * along, 0.15);
  for (int mm = 0; mm <= static_cast<int>(std::lround(length_mm)); ++mm) {
    const double tick = mm % 10 == 0 ? 5 : mm % 5 == 0 ? 3.5 : 2;
    const Vector2d p = from + mm * along;
    sheet.line(p, p + tick * across, mm % 10 == 0 ? 0.15 : 0.08);
    const bool upright = along.x() > 0.5;
    if (mm % 20 == 0 && (mm < crossed_mm - 3 || mm > crossed_mm + 11))
      sheet.text(p + (upright ? Vector2d(0, 8.2) : Vector2d(-6, 1)), 2.6, std::to_string(mm),
                 upright ? Anchor::Middle : Anchor::Right);
  }
}

class Drawing {
 public:
  Drawing(const PlatePrintOptions& options, const cv::Ptr<cv::aruco::Dictionary>& dictionary)
      : options_(options), dictionary_(dictionary) {}

  PlatePrint run() {
    out_.plate = ringPlate(options_.diameter_mm, options_.marker_mm, options_.dictionary);
    out_.board = standardBoard();
    planTiles();
    drawPlate();
    layTiles();
    drawBoard();
    scaleToRuler();
    return std::move(out_);
  }

 private:
  double radius() const { return options_.diameter_mm / 2; }
  double freeRadius() const { return freeRadiusOf(options_.diameter_mm, options_.marker_mm); }

  void drawPlate() {
    const bool black = options_.ground == Ground::Black;
    sheet_.circle({0, 0}, radius(), black ? Grey(0.0) : Grey(), 0.4, 0.2);
    for (const batch::Marker& marker : out_.plate.markers) drawMarkerOf(marker, black);
    if (black) sheet_.circle({0, 0}, freeRadius(), 1.0, {}, 0);
    sheet_.circle({0, 0}, freeRadius(), {}, 0.5, 0.15, 3);
    sheet_.line({-6, 0}, {6, 0}, 0.12);
    sheet_.line({0, -6}, {0, 6}, 0.12);
    out_.ruler_mm = 50 * std::floor(1.6 * freeRadius() / 50);
    if (out_.ruler_mm < 50) out_.ruler_mm = 10 * std::floor(1.6 * freeRadius() / 10);
    const double half = out_.ruler_mm / 2, aside = 0.22 * freeRadius();
    drawRuler(sheet_, {-half, aside}, {1, 0}, out_.ruler_mm);
    drawRuler(sheet_, {-aside, -half}, {0, 1}, out_.ruler_mm, half + aside);
    drawWords();
  }

  void drawWords() {
    const std::vector<std::string> sentences{
        formatted("Ostraka plate, diameter %.0f mm, markers of %.0f mm", options_.diameter_mm,
                  options_.marker_mm),
        options_.dictionary + ", " + std::to_string(out_.plate.markers.size()) + " markers",
        formatted("Both rulers must measure %.0f mm. If they do not, regenerate the files with "
                  "--ruler-measured and the measured length.",
                  out_.ruler_mm),
        "Turntable axis at the small cross; sherds within the dashed circle, on matt dark cloth "
        "cut to it."};
    const double size = freeRadius() > 100 ? 3.2 : 2.2, step = 1.5 * size;
    for (const bool inside : {true, false})
      for (const std::size_t letters : {62, 46, 34, 26}) {
        std::vector<std::string> lines;
        double width = 0;
        for (const std::string& sentence : sentences)
          for (std::string& line : wrapped(sentence, letters)) {
            width = std::max(width, textWidth({{0, 0}, size, line, Anchor::Left, Weight::Plain}));
            lines.push_back(std::move(line));
          }
        const double height = step * static_cast<double>(lines.size());
        const auto at = inside ? placeForWords({width, height}) : placeOutside({width, height});
        if (!at) continue;  // too wide for this plate's sheets
        for (std::size_t i = 0; i < lines.size(); ++i)
          sheet_.text(*at + Vector2d(0, size + step * static_cast<double>(i)), size, lines[i]);
        return;
      }
  }

  // Upper left of the words within the free disc: whole on one sheet, clear of rulers and crosses,
  // below the ruler and right of the middle where that can be.
  std::optional<Vector2d> placeForWords(const Vector2d& size) const {
    const Vector2d wanted(8, 0.22 * freeRadius() + 12), reach(freeRadius(), freeRadius());
    return nearestPlace(size, wanted, {-reach, reach}, [&](const Eigen::AlignedBox2d& box) {
      for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                                Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight})
        if (box.corner(corner).norm() > freeRadius() - kWordsFromEdge_mm) return false;
      return clear(box);
    });
  }

  // Small plates leave no room: beside the plate, below it on a page of the plate's own size.
  std::optional<Vector2d> placeOutside(const Vector2d& size) {
    const Vector2d wanted(-size.x() / 2, radius() + kWordsFromEdge_mm);
    if (!options_.paper) {
      if (size.x() > 2 * radius()) return std::nullopt;
      below_mm_ = kWordsFromEdge_mm + size.y();
      return wanted;
    }
    const double label = across_.count * down_.count > 1 ? 16 : 2;  // "Sheet 1 of 2" and its advice
    const auto end = [&](const Rows& rows) {
      return rows.begin + (rows.count - 1) * rows.step(options_.overlap_mm) + rows.usable;
    };
    const Vector2d low(across_.begin + 2, down_.begin + label),
        high(end(across_) - 2, end(down_) - label);
    return nearestPlace(size, wanted, {low, high - size}, [&](const Eigen::AlignedBox2d& box) {
      return box.exteriorDistance(Vector2d(0, 0)) > radius() + kWordsFromEdge_mm / 2 && clear(box);
    });
  }

  // In steps of 2 mm, upper left.
  template <class Fits>
  static std::optional<Vector2d> nearestPlace(const Vector2d& size, const Vector2d& wanted,
                                              const Eigen::AlignedBox2d& reach, Fits fits) {
    std::optional<Vector2d> best;
    double nearest = 1e9;
    for (double y = reach.min().y(); y < reach.max().y(); y += 2)
      for (double x = reach.min().x(); x < reach.max().x(); x += 2) {
        const Eigen::AlignedBox2d box(Vector2d(x, y), Vector2d(x, y) + size);
        const double off = (box.min() - wanted).norm();
        if (off >= nearest || !fits(box)) continue;
        nearest = off;
        best = box.min();
      }
    return best;
  }

  // Of rulers, the small cross, and what sheets are glued by.
  bool clear(const Eigen::AlignedBox2d& box) const {
    const double aside = 0.22 * freeRadius(), half = out_.ruler_mm / 2;
    const auto meets = [&](const Vector2d& low, const Vector2d& high) {
      return box.intersects(Eigen::AlignedBox2d(low, high));
    };
    if (meets({-8, -8}, {8, 8}) || meets({-half - 4, aside - 3}, {half + 4, aside + 11}) ||
        meets({-aside - 14, -half - 4}, {-aside + 3, half + 4}))
      return false;
    const auto onSeam = [&](const Rows& rows, int axis) {
      const double overlap = options_.overlap_mm;
      for (int k = 1; k < rows.count; ++k) {
        const double seam = rows.begin + k * rows.step(overlap), past = seam + overlap;
        if (box.max()[axis] > seam - 2 && box.min()[axis] < past + 2) return true;
        for (const double place : kCrosses) {
          const double at = place * freeRadius(), from = box.min()[1 - axis];
          if (box.min()[axis] < past + kArmBeyondCut_mm + 2 && box.max()[axis] > seam &&
              from < at + kEdgeMark_mm + 2 && box.max()[1 - axis] > at - kEdgeMark_mm - 2)
            return true;
        }
      }
      return false;
    };
    return !onSeam(across_, 0) && !onSeam(down_, 1);
  }

  void drawMarkerOf(const batch::Marker& marker, bool black) {
    std::array<Vector2d, 4> c;
    for (int k = 0; k < 4; ++k) c[k] = onPaper(marker.corners[k]);
    const Vector2d right = (c[1] - c[0]).normalized(), down = (c[3] - c[0]).normalized();
    if (black) {
      const double m = kPaperMargin_mm;
      sheet_.polygon({c[0] - m * right - m * down, c[1] + m * right - m * down,
                      c[2] + m * right + m * down, c[3] - m * right + m * down},
                     1.0);
    }
    sheet_.items.emplace_back(markerInk(dictionary_, marker.id, c));
  }

  // How far sheets reach along one axis, and where the first begins (plate frame, mm).
  struct Rows {
    int count = 1;
    double begin = 0, usable = 0;
    int cut = 0;
    double step(double overlap) const { return usable - overlap; }
  };

  // Seams run between markers where they can.
  Rows rowsFor(double usable, int axis) const {
    const double need = 2 * radius() + 2, overlap = options_.overlap_mm;
    Rows rows;
    rows.usable = usable;
    rows.count = need <= usable
                     ? 1
                     : static_cast<int>(std::ceil((need - overlap) / (usable - overlap) - 1e-9));
    const double slack = rows.count * (usable - overlap) + overlap - need;
    double best = 1e9;
    for (double shift = 0; shift <= slack / 2; shift += 0.5)
      for (const double sign : {1.0, -1.0}) {
        const double begin = -need / 2 - slack / 2 + sign * shift;
        const int cut = markersCut(begin, rows.count, usable, axis);
        const double cost = 1000 * cut + shift;
        if (cost >= best) continue;
        best = cost;
        rows.begin = begin;
        rows.cut = cut;
      }
    return rows;
  }

  int markersCut(double begin, int count, double usable, int axis) const {
    int cut = 0;
    for (const batch::Marker& marker : out_.plate.markers) {
      double low = 1e9, high = -1e9;
      for (const Eigen::Vector3d& corner : marker.corners) {
        low = std::min(low, onPaper(corner)[axis]);
        high = std::max(high, onPaper(corner)[axis]);
      }
      bool on_seam = false;
      for (int k = 1; k < count; ++k) {
        const double seam = begin + k * (usable - options_.overlap_mm);
        on_seam = on_seam || (high > seam && low < seam + options_.overlap_mm);
      }
      cut += on_seam ? 1 : 0;
    }
    return cut;
  }

  // Which sheets, upright or across, whichever are fewer.
  void planTiles() {
    if (!options_.paper) return;
    paper_ = paperSize(*options_.paper);
    const double margins = 2 * options_.printer_margin_mm;
    across_ = rowsFor(paper_.x() - margins, 0);
    down_ = rowsFor(paper_.y() - margins, 1);
    const Rows across2 = rowsFor(paper_.y() - margins, 0), down2 = rowsFor(paper_.x() - margins, 1);
    if (across2.count * down2.count < across_.count * down_.count) {
      across_ = across2;
      down_ = down2;
      paper_ = {paper_.y(), paper_.x()};
    }
  }

  void layTiles() {
    if (!options_.paper) {
      const double size = 2 * (radius() + options_.printer_margin_mm);
      out_.centres.emplace_back(size / 2, size / 2);
      out_.pages.push_back({size, size + below_mm_, {{sheet_, {size / 2, size / 2}, {}}}});
      return;
    }
    out_.markers_cut = across_.cut + down_.cut;
    markSeams(across_, 0);
    markSeams(down_, 1);
    for (int y = 0; y < down_.count; ++y)
      for (int x = 0; x < across_.count; ++x) addTile(paper_, across_, down_, x, y);
  }

  // On the lower sheet of a seam a line shows where the upper one's cut edge comes to lie, and the
  // arms of crosses go on beyond it: paper is not transparent, so marks within the overlap alone
  // would be hidden.
  void markSeams(const Rows& rows, int axis) {
    const Vector2d over = axis == 0 ? Vector2d(1, 0) : Vector2d(0, 1),
                   along = axis == 0 ? Vector2d(0, 1) : Vector2d(1, 0);
    for (int k = 1; k < rows.count; ++k) {
      const double cut = rows.begin + k * rows.step(options_.overlap_mm) + options_.overlap_mm;
      for (const double place : kCrosses) {
        const Vector2d p = cut * over + place * freeRadius() * along;
        sheet_.line(p - options_.overlap_mm * over, p + kArmBeyondCut_mm * over, 0.1);
        sheet_.line(p - kEdgeMark_mm * along, p + kEdgeMark_mm * along, 0.1);
      }
    }
  }

  void addTile(const Vector2d& paper, const Rows& across, const Rows& down, int x, int y) {
    const double margin = options_.printer_margin_mm, overlap = options_.overlap_mm;
    const Vector2d low(margin, margin), high = paper - low;
    const Vector2d centre(margin - across.begin - x * across.step(overlap),
                          margin - down.begin - y * down.step(overlap));
    Sheet marks;
    if (x + 1 < across.count) marks.line({high.x(), low.y()}, high, 0.15, 2);
    if (y + 1 < down.count) marks.line({low.x(), high.y()}, high, 0.15, 2);
    const int number = y * across.count + x + 1, count = across.count * down.count;
    if (count > 1) {
      // In the corner that is farthest from the plate's centre, where nothing else is.
      const bool right = centre.x() < paper.x() / 2, below = centre.y() < paper.y() / 2;
      const Vector2d at(right ? high.x() - 3 : low.x() + 3, below ? high.y() - 8 : low.y() + 6);
      const Anchor anchor = right ? Anchor::Right : Anchor::Left;
      marks.text(at, 3.2, "Sheet " + std::to_string(number) + " of " + std::to_string(count),
                 anchor, Weight::Bold);
      if (number < count)
        marks.text(at + Vector2d(0, 4.5), 2.6,
                   x + 1 < across.count && y + 1 < down.count
                       ? "cut at both dashed lines, lay the edges on the neighbours' crosses"
                       : "cut at the dashed line, lay the edge on the neighbour's crosses",
                   anchor);
    }
    out_.centres.push_back(centre);
    out_.pages.push_back({paper.x(),
                          paper.y(),
                          {{sheet_, centre, Eigen::AlignedBox2d(low, high)}, {marks, {0, 0}, {}}}});
  }

  void drawBoard() {
    const Vector2d paper(297, 210);  // A4 across: fits every printer
    const batch::Board& b = out_.board;
    const Vector2d size(b.squares_x * b.square_mm, b.squares_y * b.square_mm);
    out_.board_corner = {(paper.x() - size.x()) / 2, 18};
    Sheet sheet;
    for (Shape& shape : boardInk(b)) sheet.items.push_back(std::move(shape));
    // A frame that can be cut along, clear of the squares by the white they need.
    const Vector2d margin(8, 8);
    sheet.polygon({-margin, {size.x() + 8, -8}, size + margin, {-8, size.y() + 8}}, {}, 0.6, 0.1);
    const double ruler = 150;
    drawRuler(sheet, {(size.x() - ruler) / 2, size.y() + 17}, {1, 0}, ruler);
    sheet.text(
        {0, size.y() + 15}, 3.0,
        formatted("Board: squares of %.0f mm, markers of %.0f mm, ", b.square_mm, b.marker_mm) +
            b.dictionary +
            ". The ruler must measure 150 mm. Glue it on glass or a stiff "
            "board; it must not bend.");
    out_.pages.push_back({paper.x(), paper.y(), {{sheet, out_.board_corner, {}}}});
  }

  void scaleToRuler() {
    if (options_.ruler_measured_mm == 0) return;
    const double scale = options_.ruler_measured_mm / out_.ruler_mm;
    out_.plate.diameter_mm *= scale;
    for (batch::Marker& marker : out_.plate.markers)
      for (Eigen::Vector3d& corner : marker.corners) corner *= scale;
    out_.board.square_mm *= scale;
    out_.board.marker_mm *= scale;
  }

  const PlatePrintOptions& options_;
  cv::Ptr<cv::aruco::Dictionary> dictionary_;
  Sheet sheet_;  // origin at the plate's centre
  Vector2d paper_ = Vector2d::Zero();
  Rows across_, down_;
  double below_mm_ = 0;  // room for words below the plate, on a page of the plate's size
  PlatePrint out_;
};

// The side of the largest markers that fit, in whole mm; 0: none.
int largestMarkers(double diameter_mm) {
  for (int marker_mm = 200; marker_mm >= 5; --marker_mm)
    if (markersOnRing(diameter_mm, marker_mm) >= kFewestMarkers &&
        freeRadiusOf(diameter_mm, marker_mm) >= kLeastFree_mm)
      return marker_mm;
  return 0;
}

}  // namespace

Result<void> PlatePrintOptions::check() const {
  const auto bad = [](const Message& what) { return Error::unusable(what); };
  if (!(marker_mm >= 5 && marker_mm <= 200))
    return bad(message("The markers' side must be between 5 and 200 mm."));
  if (!(diameter_mm > 0 && diameter_mm <= 2000))
    return bad(message("The plate's diameter must be between 1 and 2000 mm."));
  const int fit_mm = largestMarkers(diameter_mm);
  const Decimal marker = decimal(marker_mm, 0), plate = decimal(diameter_mm, 0);
  if (markersOnRing(diameter_mm, marker_mm) < kFewestMarkers)
    return bad(fit_mm > 0 ? message("Fewer than six markers of %1 mm fit on a plate of %2 mm; "
                                    "markers of %3 mm fit on it.",
                                    marker, plate, fit_mm)
                          : message("Fewer than six markers of %1 mm fit on a plate of %2 mm; make "
                                    "the plate larger.",
                                    marker, plate));
  if (freeRadiusOf(diameter_mm, marker_mm) < kLeastFree_mm)
    return bad(fit_mm > 0 ? message("Markers of %1 mm leave no room for a sherd on a plate of %2 "
                                    "mm; markers of %3 mm fit on it.",
                                    marker, plate, fit_mm)
                          : message("Markers of %1 mm leave no room for a sherd on a plate of %2 "
                                    "mm; make the plate larger.",
                                    marker, plate));
  if (!(printer_margin_mm >= 0 && printer_margin_mm <= 40))
    return bad(message("The printer's margin must be between 0 and 40 mm."));
  if (!(overlap_mm >= 5 && overlap_mm <= 40))
    return bad(message("The sheets' overlap must be between 5 and 40 mm."));
  const Result<cv::Ptr<cv::aruco::Dictionary>> known = markerDictionary(dictionary);
  if (!known) return known.error();
  if (markersOnRing(diameter_mm, marker_mm) > (*known)->bytesList.rows)
    return bad(message("The dictionary %1 has too few markers for this plate.", dictionary));
  const double ruler = ruler_measured_mm;
  if (ruler != 0 && !(ruler > 0 && ruler < diameter_mm))
    return bad(message("The measured ruler length must be in mm and within the plate."));
  return {};
}

batch::Plate ringPlate(double diameter_mm, double marker_mm, const std::string& dictionary) {
  batch::Plate plate;
  plate.dictionary = dictionary;
  plate.diameter_mm = diameter_mm;
  const int count = markersOnRing(diameter_mm, marker_mm);
  const double ring = ringRadius(diameter_mm, marker_mm), half = marker_mm / 2;
  for (int id = 0; id < count; ++id) {
    const double turn = 2 * std::numbers::pi * id / count;
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0), left(-out.y(), out.x(), 0);
    plate.markers.push_back(
        {id,
         {(ring + half) * out + half * left, (ring + half) * out - half * left,
          (ring - half) * out - half * left, (ring - half) * out + half * left}});
  }
  return plate;
}

batch::Board standardBoard() {
  return {"DICT_5X5_100", 9, 7, 22, 16};
}

Result<PlatePrint> printPlate(const PlatePrintOptions& options) {
  if (const Result<void> good = options.check(); !good) return good.error();
  PlatePrint print = Drawing(options, *markerDictionary(options.dictionary)).run();
  if (options.ruler_measured_mm != 0) {
    const double off = options.ruler_measured_mm / print.ruler_mm - 1;
    if (std::abs(off) > 0.1)
      return Error::unusable(message(
          "The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. "
          "Print the file at 100 %, without 'fit to page', and measure again.",
          decimal(print.ruler_mm, 0), decimal(options.ruler_measured_mm, 1)));
  }
  return print;
}

}  // namespace ostraka::rig
