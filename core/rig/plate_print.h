#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "paper/sheet.h"

/// Marker plate and calibration board to be printed in true scale, and the files that describe
/// them.
namespace ostraka::rig {

enum class Ground { White, Black };

struct PlatePrintOptions {
  double diameter_mm = 330;  ///< of the turntable's plate; markers keep clear of its edge
  double marker_mm = 24;     ///< at 0.24 mm a pixel 100 pixels: read well from 20 degrees above
  std::string dictionary = "DICT_4X4_100";
  std::optional<Paper> paper = Paper::A3;  ///< nothing: one page of the plate's size, for a plotter
  Ground ground = Ground::White;           ///< black saves the felt between the markers
  double printer_margin_mm = 8;            ///< what printers leave white at the paper's edge
  double overlap_mm = 10;                  ///< of neighbouring sheets, for gluing
  /// What the plate's ruler measures once printed and glued; 0: as drawn. plate.json and board.json
  /// follow it, so a printer that scales does no harm.
  double ruler_measured_mm = 0;

  Result<void> check() const;
};

/// Markers of DICT on a ring, tops outward, ids from 0 counter-clockwise from +x; as many as fit.
batch::Plate ringPlate(double diameter_mm, double marker_mm, const std::string& dictionary);
/// 9 x 7 squares of 22 mm: fits A4, and a camera sees all of it at the plate's distance.
batch::Board standardBoard();

struct PlatePrint {
  std::vector<Page> pages;  ///< the plate's sheets row by row, the board last
  /// Where the plate's centre lies on each of the plate's pages, mm from the upper left.
  std::vector<Eigen::Vector2d> centres;
  Eigen::Vector2d board_corner = Eigen::Vector2d::Zero();  ///< upper left of the board's squares
  double ruler_mm = 0;                                     ///< length of the ruler as drawn
  int markers_cut = 0;                                     ///< markers that lie on a seam
  batch::Plate plate;                                      ///< scaled to the measured ruler
  batch::Board board;
};

/// Errors: UnusableInput (an option; fewer than six markers fit; more than the dictionary has).
Result<PlatePrint> printPlate(const PlatePrintOptions& options);

/// plate.json and board.json of a batch.
Result<void> writePlate(const std::filesystem::path& file, const batch::Plate& plate);
Result<void> writeBoard(const std::filesystem::path& file, const batch::Board& board);

/// Prints into the PDF, and plate.json and board.json beside it; all of them or none. Nothing is
/// lost: those of this plate as drawn follow a measured ruler, the same are left as they are.
/// Errors: as printPlate; UnusableInput (a project or an archive; those of another plate, board or
/// ruler; photographs, which a new plate.json would describe), CannotWrite.
Result<PlatePrint> writePlatePrint(const std::filesystem::path& pdf,
                                   const PlatePrintOptions& options);

}  // namespace ostraka::rig
