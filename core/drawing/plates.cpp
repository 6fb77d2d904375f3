#include <algorithm>

#include "drawing/drawing.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector2d;

constexpr double kMargin_mm = 12, kBetween_mm = 8, kFoot_mm = 22;  // one sheet: 8 above the drawing

// Full centimetres in black and white, as long as fits a sherd.
Sheet scaleBar(double scale, const Wording& wording) {
  Sheet sheet;
  const double step = 10 * scale;
  for (int k = 0; k < 5; ++k)
    sheet.polygon({{k * step, 0}, {(k + 1) * step, 0}, {(k + 1) * step, 2}, {k * step, 2}},
                  k % 2 == 0 ? 0.0 : 1.0, 0.0, 0.2);
  sheet.text({0, -1}, 2.6, "0", Anchor::Middle);
  sheet.text({5 * step, -1}, 2.6, "5 cm", Anchor::Middle);
  const std::string ratio =
      scale <= 1 ? "1 : " + wording.shortNumber(1 / scale) : wording.shortNumber(scale) + " : 1";
  sheet.text({5 * step + 12, 2}, 3, ratio);
  return sheet;
}

Vector2d usable(const Vector2d& paper) {
  return paper - Vector2d(2 * kMargin_mm, 2 * kMargin_mm + kFoot_mm);
}

// The smallest of: the paper upright, the paper across, A3 both ways, a size of its own.
Vector2d paperFor(const Vector2d& need, Paper paper) {
  const auto fits = [&](const Vector2d& p) { return (usable(p).array() >= need.array()).all(); };
  for (const Paper choice : {paper, Paper::A3}) {
    const Vector2d size = paperSize(choice), across(size.y(), size.x());
    if (fits(size)) return size;
    if (fits(across)) return across;
  }
  return need + Vector2d(2 * kMargin_mm, 2 * kMargin_mm + kFoot_mm);
}

void addFoot(Page& page, double scale, const SheetOptions& options) {
  Sheet foot = scaleBar(scale, options.wording);
  page.layers.push_back({foot, {kMargin_mm + 3, page.height_mm - kMargin_mm - 2}, {}});
  if (options.title.empty()) return;
  Sheet words;
  words.text({0, 0}, 3, options.title, Anchor::Right);
  page.layers.push_back({words, {page.width_mm - kMargin_mm, page.height_mm - kMargin_mm}, {}});
}

Layer placed(const SherdDrawing& drawing, const Vector2d& corner) {
  return {drawing.sheet, corner - drawing.box.min(), {}};
}

// Rows of drawings in their order, as many as fit the paper's width and height.
std::vector<Page> plates(const std::vector<SherdDrawing>& drawings, double scale,
                         const SheetOptions& options) {
  std::vector<Page> pages;
  const auto newPage = [&](const Vector2d& size) {
    pages.push_back({size.x(), size.y(), {}});
    addFoot(pages.back(), scale, options);
  };
  const Vector2d paper = paperSize(options.paper), room = usable(paper);
  Vector2d at(0, 0);
  double row_height = 0;
  bool open = false;
  for (const SherdDrawing& drawing : drawings) {
    const Vector2d size = drawing.box.sizes();
    if (size.x() > room.x() || size.y() > room.y()) {  // a page of its own
      newPage(paperFor(size, options.paper));
      pages.back().layers.push_back(placed(drawing, {kMargin_mm, kMargin_mm}));
      open = false;
      continue;
    }
    if (open && at.x() + size.x() > room.x()) {
      at = {0, at.y() + row_height + kBetween_mm};
      row_height = 0;
    }
    if (!open || at.y() + size.y() > room.y()) {
      newPage(paper);
      at = {0, 0};
      row_height = 0;
      open = true;
    }
    pages.back().layers.push_back(placed(drawing, at + Vector2d(kMargin_mm, kMargin_mm)));
    at.x() += size.x() + kBetween_mm;
    row_height = std::max(row_height, size.y());
  }
  return pages;
}

}  // namespace

std::vector<Page> layOut(const std::vector<SherdDrawing>& drawings, double scale,
                         const SheetOptions& options) {
  if (options.layout == SheetOptions::Layout::Plates) return plates(drawings, scale, options);
  std::vector<Page> pages;
  for (const SherdDrawing& drawing : drawings) {
    const Vector2d size = paperFor(drawing.box.sizes(), options.paper);
    Page page{size.x(), size.y(), {}};
    const double left = (size.x() - drawing.box.sizes().x()) / 2;
    page.layers.push_back(placed(drawing, {left, kMargin_mm + 8}));
    addFoot(page, scale, options);
    pages.push_back(std::move(page));
  }
  return pages;
}

}  // namespace ostraka::drawing
