#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"

/// Drawings in true scale on paper, as PDF and SVG.
namespace ostraka {

/// Black is 0, white is 1; nothing where there is none.
using Grey = std::optional<double>;

/// Lines or areas. Areas are filled by the even-odd rule over all lines of the shape.
struct Shape {
  std::vector<std::vector<Eigen::Vector2d>> lines;  ///< mm
  bool closed = false;
  Grey fill, stroke;
  double stroke_mm = 0.25;
  double dash_mm = 0;  ///< length of dashes and gaps; 0: drawn through
};

enum class Anchor { Left, Middle, Right };
enum class Weight { Plain, Bold };

/// One line of text; `at` is on its baseline.
struct Text {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double size_mm = 3;  ///< of the font
  std::string text;    ///< UTF-8; letters that no font of the computer has become '?'
  Anchor anchor = Anchor::Left;
  Weight weight = Weight::Plain;
};

enum class Ink { Black, Colours };

/// A photograph or rendering, stretched over its box.
struct Picture {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< upper left
  Eigen::Vector2d size = Eigen::Vector2d::Zero();    ///< mm
  std::string jpeg;                                  ///< the file's bytes
  int width_px = 0, height_px = 0;
  Ink ink = Ink::Black;
};

/// Things drawn one over the other. Millimetres, x to the right, y down.
struct Sheet {
  std::vector<std::variant<Shape, Text, Picture>> items;

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double stroke_mm,
            double dash_mm = 0);
  void polygon(std::vector<Eigen::Vector2d> corners, Grey fill, Grey stroke = {},
               double stroke_mm = 0.25);
  void circle(const Eigen::Vector2d& centre, double radius_mm, Grey fill, Grey stroke,
              double stroke_mm = 0.25, double dash_mm = 0);
  void text(const Eigen::Vector2d& at, double size_mm, std::string text,
            Anchor anchor = Anchor::Left, Weight weight = Weight::Plain);
  /// All of another sheet, its origin at `at`.
  void add(const Sheet& other, const Eigen::Vector2d& at);
};

/// A sheet on a page: its origin lies at `at`; only what lies within `window` (page, mm) is shown.
struct Layer {
  Sheet sheet;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  std::optional<Eigen::AlignedBox2d> window;
};

struct Page {
  double width_mm = 210, height_mm = 297;
  std::vector<Layer> layers;
};

enum class Paper { A4, A3 };
/// Upright: width, height in mm.
Eigen::Vector2d paperSize(Paper paper);

/// Width of a text in mm, as the PDF's font has it.
double textWidth(const Text& text);

/// PDF 1.4 with vector paths; asks printers not to scale. The letters are embedded, and can be
/// searched and copied. The same input and fonts give the same bytes.
std::string formatPdf(const std::vector<Page>& pages, const std::string& title);
/// One page, with its size in mm.
std::string formatSvg(const Page& page, const std::string& title);

}  // namespace ostraka
