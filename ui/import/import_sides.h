#pragma once
#include <QString>
#include <QStringList>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/result.h"

namespace ostraka::ui {

/// The photographs of a batch by hand, side by side, as they are imported.
struct ImportSides {
  std::vector<std::filesystem::path> front, back;  ///< no back: the fronts alone
  std::optional<std::filesystem::path> sheet;      ///< plate.json of the sheet under the sherds
  std::optional<double> marker_mm;  ///< without one: side of a marker's black square on it
};

/// What was dropped or chosen, told apart by side, until a person confirms it. No widget.
struct SidesPlan {
  QString from;                              ///< the folders, in words
  std::vector<std::filesystem::path> files;  ///< of one side, then of the other
  std::size_t first_second = 0;              ///< index of the first photograph of the second side
  bool divisible = false;  ///< one series: a person may say where the second side begins
  bool flip_found = true;  ///< else a person must
  bool backs_first = false;
  bool one_side = false;
  std::optional<std::filesystem::path> sheet;
  std::optional<double> marker_mm;
  bool marker_proposed = false;  ///< it is the last import's, and nobody has confirmed it

  ImportSides sides() const;
  /// No person needs to say anything more.
  bool isDecided() const { return flip_found || one_side; }
};

/// Least photographs of a side.
inline constexpr std::size_t kLeastOfASide = 3;

/// Of one or two folders with photographs, of the folder that holds two such, or of photographs
/// themselves; nothing when the one folder is a batch of a rig, or one by hand with more than its
/// photographs and the sheet: that is imported whole. The sheet is plate.json beside the
/// photographs or in the folder above, else the one that was used last. Reads what the cameras
/// wrote about each photograph: for a job. Errors: UnusableInput; of a batch: as readBatch.
Result<std::optional<SidesPlan>> planSides(const QStringList& dropped,
                                           const std::filesystem::path& last_sheet);

/// The same with the photographs of this folder for its back: a series that was divided, or one
/// side only, is the front as a whole. Errors: UnusableInput (no photographs, or the front's own).
Result<SidesPlan> withBack(SidesPlan plan, const QString& folder);

}  // namespace ostraka::ui
