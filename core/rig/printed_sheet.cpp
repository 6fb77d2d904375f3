#include "rig/printed_sheet.h"

#include <array>
#include <cmath>
#include <string>

#include "base/message.h"
#include "base/text.h"
#include "rig/marker_dictionary.h"

namespace ostraka::rig {
namespace {

using Eigen::Vector2d;

constexpr const char* kSheetDictionary = "DICT_5X5_100";
constexpr double kMarginX = 6.5, kMarginY = 6;      // mm of paper outside of the markers
constexpr double kMostStepX = 27, kMostStepY = 30;  // mm from marker to marker
constexpr double kBar_mm = 200, kMostOff = 0.1;

batch::Marker markerAt(int id, const Vector2d& middle) {
  const double h = kSheetMarker_mm / 2;
  return {id,
          {Eigen::Vector3d(middle.x() - h, middle.y() + h, 0),
           Eigen::Vector3d(middle.x() + h, middle.y() + h, 0),
           Eigen::Vector3d(middle.x() + h, middle.y() - h, 0),
           Eigen::Vector3d(middle.x() - h, middle.y() - h, 0)}};
}

// Origin in the middle of the paper, y down.
Sheet drawnMarkers(const batch::Plate& plate) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100);
  Sheet sheet;
  for (const batch::Marker& marker : plate.markers) {
    std::array<Vector2d, 4> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
      corners[k] = {marker.corners[k].x(), -marker.corners[k].y()};
    sheet.items.emplace_back(markerInk(dictionary, marker.id, corners));
  }
  return sheet;
}

Sheet drawnBar(const Vector2d& paper) {
  constexpr double kLeft = 30, kTop = 40, kTick = 6, kLetters = 4, kStep = 8;
  Sheet sheet;
  sheet.line({kLeft, kTop}, {kLeft + kBar_mm, kTop}, 0.3);
  for (int mm = 0; mm <= static_cast<int>(kBar_mm); mm += 10) {
    const double tick = mm % 100 == 0 ? kTick : kTick / 2;
    sheet.line({kLeft + mm, kTop}, {kLeft + mm, kTop + tick}, 0.2);
  }
  const std::array<std::string, 7> lines{
      formatted("Print at 100 %% (not 'fit to page'). This bar must measure %.0f mm.", kBar_mm),
      "If it does not, print again, or write the file anew with --ruler-measured and the length;",
      "or, when you import, choose Clear sheet and type the measured side of a black square.",
      "Lay the other page flat on a table and the sherds within its markers, apart from each "
      "other.",
      "Photograph it from all around, 20 to 40 times, from high and from low, markers in sight.",
      "Turn each sherd over where it lies, and photograph the other side in the same way.",
      "Import both series; plate.json beside this file describes the sheet."};
  double y = kTop + kTick + 2 * kStep;
  for (const std::string& line : lines) {
    Text text{{kLeft, y}, kLetters, line, Anchor::Left, Weight::Plain};
    const double room = paper.x() - 2 * kLeft, width = textWidth(text);
    if (width > room) text.size_mm *= room / width;
    sheet.items.push_back(text);
    y += kStep;
  }
  return sheet;
}

}  // namespace

Vector2d sheetSize(SheetSize size) {
  switch (size) {
    case SheetSize::A4:
      return {297, 210};
    case SheetSize::A3:
      return {420, 297};
    case SheetSize::Letter:
      return {279.4, 215.9};
  }
  return {297, 210};
}

batch::Plate sheetPlate(SheetSize size) {
  const Vector2d half = sheetSize(size) / 2;
  batch::Plate plate;
  plate.dictionary = kSheetDictionary;
  plate.sheet = Eigen::AlignedBox2d(-half, half);
  const Vector2d reach =
      half - Vector2d(kMarginX, kMarginY) - Vector2d::Constant(kSheetMarker_mm / 2);
  const int across = static_cast<int>(std::ceil(2 * reach.x() / kMostStepX)),
            down = static_cast<int>(std::ceil(2 * reach.y() / kMostStepY));
  const Vector2d step(2 * reach.x() / across, 2 * reach.y() / down);
  int id = 0;
  for (int i = 0; i < across; ++i)
    plate.markers.push_back(markerAt(id++, {-reach.x() + i * step.x(), reach.y()}));
  for (int i = 0; i < down; ++i)
    plate.markers.push_back(markerAt(id++, {reach.x(), reach.y() - i * step.y()}));
  for (int i = 0; i < across; ++i)
    plate.markers.push_back(markerAt(id++, {reach.x() - i * step.x(), -reach.y()}));
  for (int i = 0; i < down; ++i)
    plate.markers.push_back(markerAt(id++, {-reach.x(), -reach.y() + i * step.y()}));
  return plate;
}

Result<SheetPrint> printSheet(const SheetPrintOptions& options) {
  const double measured = options.bar_measured_mm;
  if (measured != 0 && !(std::abs(measured / kBar_mm - 1) <= kMostOff))
    return Error::unusable(
        message("The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. "
                "Print the file at 100 %, without 'fit to page', and measure again.",
                decimal(kBar_mm, 0), decimal(measured, 1)));
  SheetPrint print;
  print.bar_mm = kBar_mm;
  print.plate = sheetPlate(options.size);
  const Vector2d paper = sheetSize(options.size);
  print.pages.push_back({paper.x(), paper.y(), {{drawnMarkers(print.plate), paper / 2, {}}}});
  print.pages.push_back({paper.x(), paper.y(), {{drawnBar(paper), {0, 0}, {}}}});
  if (measured == 0) return print;
  const double scale = measured / kBar_mm;
  print.plate.sheet =
      Eigen::AlignedBox2d(scale * print.plate.sheet->min(), scale * print.plate.sheet->max());
  for (batch::Marker& marker : print.plate.markers)
    for (Eigen::Vector3d& corner : marker.corners) corner *= scale;
  return print;
}

}  // namespace ostraka::rig
