#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "base/message.h"
#include "batch/photographs.h"
#include "files/files.h"
#include "files/json.h"
#include "files/output_place.h"
#include "rig/plate_print.h"
#include "rig/printed_sheet.h"

namespace ostraka::rig {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json describedPlate(const batch::Plate& plate) {
  ordered_json markers = ordered_json::array();
  for (const batch::Marker& m : plate.markers) {
    ordered_json corners = ordered_json::array();
    for (const Eigen::Vector3d& c : m.corners) corners.push_back({c.x(), c.y(), c.z()});
    markers.push_back({{"id", m.id}, {"corners", corners}});
  }
  ordered_json all{{"unit", "mm"}, {"dictionary", plate.dictionary}};
  if (plate.sheet)  // about the origin, as it is read
    all["sheet"] = {plate.sheet->sizes().x(), plate.sheet->sizes().y()};
  else
    all["diameter"] = plate.diameter_mm;
  if (plate.typed_marker_mm) all["typed_marker_mm"] = *plate.typed_marker_mm;
  all["markers"] = markers;
  return all;
}

ordered_json describedBoard(const batch::Board& board) {
  return {{"dictionary", board.dictionary},
          {"squares_x", board.squares_x},
          {"squares_y", board.squares_y},
          {"square_mm", board.square_mm},
          {"marker_mm", board.marker_mm}};
}

// How a file beside the PDF stands to what is to be written there.
enum class Beside { Absent, Same, AsDrawn, Another };

Result<Beside> compared(const fs::path& file, const ordered_json& fresh,
                        const ordered_json& as_drawn) {
  std::error_code failed;
  if (!fs::exists(fs::symlink_status(file, failed))) return Beside::Absent;
  const Result<nlohmann::json> there = readJson(file);
  if (!there) return there.error();
  const auto equals = [&there](const ordered_json& other) {
    return *there == nlohmann::json(other);
  };
  return equals(fresh) ? Beside::Same : equals(as_drawn) ? Beside::AsDrawn : Beside::Another;
}

// Files that are written together: when one cannot be, all are as they were.
class Together {
 public:
  Result<void> write(const fs::path& file, const std::string& bytes) {
    std::error_code failed;
    std::optional<std::string> before;
    if (fs::exists(fs::symlink_status(file, failed))) {
      Result<std::string> old = readFile(file);
      if (!old) return undone(old.error());
      if (*old == bytes) return {};
      before = std::move(*old);
    }
    if (const Result<void> written = writeFileAtomically(file, bytes); !written)
      return undone(written.error());
    written_.emplace_back(file, std::move(before));
    return {};
  }

 private:
  Error undone(const Error& error) const {
    for (const auto& [file, before] : written_) {
      std::error_code ignored;
      if (!before)
        fs::remove(file, ignored);
      else if (const Result<void> back = writeFileAtomically(file, *before); !back)
        continue;  // the same command goes on from there
    }
    return error;
  }

  std::vector<std::pair<fs::path, std::optional<std::string>>> written_;
};

// plate.json of the folder may become `fresh`: it is not there yet, as drawn, or the same.
Result<Beside> plateBeside(const fs::path& folder, const ordered_json& fresh,
                           const ordered_json& as_drawn) {
  const fs::path file = folder / "plate.json";
  const Result<Beside> there = compared(file, fresh, as_drawn);
  if (!there || *there == Beside::Same) return there;
  if (*there == Beside::Another)
    return Error::unusable(
        message(
            "This file describes another plate, or this plate with another ruler length; choose "
            "another folder."),
        file.string());
  if (!batch::photographsIn(folder.empty() ? fs::path(".") : folder).empty())
    return Error::unusable(
        message(
            "This folder contains photographs, and a new plate.json would describe the sheet under "
            "their sherds; choose another folder."),
        folder.string());
  return there;
}

batch::Plate roundedPlate(batch::Plate plate) {
  for (batch::Marker& marker : plate.markers)
    for (Eigen::Vector3d& corner : marker.corners)
      for (double& value : corner) value = std::round(value * 1e4) / 1e4;
  return plate;
}

}  // namespace

Result<void> writePlate(const fs::path& file, const batch::Plate& plate) {
  return writeJson(file, describedPlate(plate));
}

Result<void> writeBoard(const fs::path& file, const batch::Board& board) {
  return writeJson(file, describedBoard(board));
}

Result<PlatePrint> writePlatePrint(const fs::path& pdf, const PlatePrintOptions& options) {
  if (const Result<void> good = checkOutputPlace(pdf); !good) return good.error();
  Result<PlatePrint> print = printPlate(options);
  if (!print) return print;
  PlatePrintOptions unmeasured = options;
  unmeasured.ruler_measured_mm = 0;
  const Result<PlatePrint> as_drawn = printPlate(unmeasured);
  if (!as_drawn) return as_drawn;
  const fs::path folder = pdf.parent_path();
  const fs::path plate_file = folder / "plate.json", board_file = folder / "board.json";
  const ordered_json plate = describedPlate(print->plate), board = describedBoard(print->board);
  const auto plate_there = plateBeside(folder, plate, describedPlate(as_drawn->plate));
  if (!plate_there) return plate_there.error();
  const auto board_there = compared(board_file, board, describedBoard(as_drawn->board));
  if (!board_there) return board_there.error();
  if (*board_there == Beside::Another)
    return Error::unusable(
        message("This file describes another calibration board; choose another folder."),
        board_file.string());
  // The PDF last: nobody prints a plate that nothing describes.
  Together files;
  if (*plate_there != Beside::Same)
    if (const Result<void> r = files.write(plate_file, plate.dump(1) + "\n"); !r) return r.error();
  if (*board_there != Beside::Same)
    if (const Result<void> r = files.write(board_file, board.dump(1) + "\n"); !r) return r.error();
  if (const Result<void> r = files.write(pdf, formatPdf(print->pages, "Ostraka plate")); !r)
    return r.error();
  return print;
}

Result<void> writeSheet(const fs::path& file, batch::Plate plate) {
  return writePlate(file, roundedPlate(std::move(plate)));
}

Result<SheetPrint> writeSheetPrint(const fs::path& pdf, const SheetPrintOptions& options) {
  if (const Result<void> good = checkOutputPlace(pdf); !good) return good.error();
  Result<SheetPrint> print = printSheet(options);
  if (!print) return print;
  const fs::path folder = pdf.parent_path();
  const ordered_json plate = describedPlate(roundedPlate(print->plate));
  const auto there =
      plateBeside(folder, plate, describedPlate(roundedPlate(sheetPlate(options.size))));
  if (!there) return there.error();
  Together files;
  if (*there != Beside::Same)
    if (const Result<void> r = files.write(folder / "plate.json", plate.dump(1) + "\n"); !r)
      return r.error();
  if (const Result<void> r = files.write(pdf, formatPdf(print->pages, "Ostraka sheet")); !r)
    return r.error();
  return print;
}

}  // namespace ostraka::rig
