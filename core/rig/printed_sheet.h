#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "paper/sheet.h"

/// The sheet under sherds that are photographed by hand: markers round its border, printed in true
/// scale, and the file that describes them.
namespace ostraka::rig {

enum class SheetSize { A4, A3, Letter };

/// Width and height of the paper, mm; it lies across.
Eigen::Vector2d sheetSize(SheetSize size);

inline constexpr double kSheetMarker_mm = 20;  ///< side of its markers

/// Markers of DICT_5X5_100, tops along +y, ids from 0 clockwise from the upper left. Origin
/// in the middle of the paper.
batch::Plate sheetPlate(SheetSize size);
/// plate.json, to a ten-thousandth of a millimetre.
Result<void> writeSheet(const std::filesystem::path& file, batch::Plate plate);

struct SheetPrintOptions {
  SheetSize size = SheetSize::A4;
  /// What the bar of the second page measures once printed; 0: as drawn. plate.json follows it.
  double bar_measured_mm = 0;
};

struct SheetPrint {
  /// The sheet, blank within its markers, then a page with the bar and how to photograph.
  std::vector<Page> pages;
  double bar_mm = 0;   ///< as drawn
  batch::Plate plate;  ///< scaled to the measured bar
};

/// Error: UnusableInput (a bar that was measured wrongly).
Result<SheetPrint> printSheet(const SheetPrintOptions& options);

/// Prints into the PDF, and plate.json beside it; both or none. Errors: as printSheet;
/// UnusableInput (a project or an archive; another plate.json; photographs, which a new one would
/// describe), CannotWrite.
Result<SheetPrint> writeSheetPrint(const std::filesystem::path& pdf,
                                   const SheetPrintOptions& options);

}  // namespace ostraka::rig
