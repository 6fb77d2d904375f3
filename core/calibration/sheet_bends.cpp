#include "calibration/sheet_bends.h"

#include <nlohmann/json.hpp>

#include "base/message.h"
#include "batch/batch.h"
#include "files/json.h"

namespace ostraka::calibration {

Result<void> writeBends(const std::filesystem::path& file,
                        const std::array<rig::SheetBend, 2>& bends) {
  nlohmann::ordered_json sheets{{"unit", "mm"}};
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    sheets[batch::name(side)] = rig::toJson(bends[static_cast<std::size_t>(side)]);
  return writeJson(file, sheets);
}

Result<std::array<rig::SheetBend, 2>> readBends(const std::filesystem::path& file) {
  const Result<nlohmann::json> sheets = readJson(file);
  if (!sheets) return sheets.error();
  std::array<rig::SheetBend, 2> bends;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const bool told = sheets->contains(batch::name(side));
    const std::optional<rig::SheetBend> bend =
        rig::sheetBendFrom(told ? sheets->at(batch::name(side)) : nlohmann::json());
    if (!bend)
      return Error::unusable(
          message(
              "The file does not describe how the sheets bend; delete it to measure them again."),
          file);
    bends[static_cast<std::size_t>(side)] = *bend;
  }
  return bends;
}

}  // namespace ostraka::calibration
