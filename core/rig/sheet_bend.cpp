#include "rig/sheet_bend.h"

#include <nlohmann/json.hpp>

#include "base/limits.h"

namespace ostraka::rig {

nlohmann::ordered_json toJson(const SheetBend& bend) {
  return {{"reach", bend.reach_mm}, {"coefficients", bend.coefficients_mm}};
}

std::optional<SheetBend> sheetBendFrom(const nlohmann::json& value) {
  constexpr double kMost_mm = 2 * limits::kPlateReach_mm.most;  // a marker's corner, too
  try {
    SheetBend bend;
    bend.reach_mm = value.at("reach").get<double>();
    const nlohmann::json& coefficients = value.at("coefficients");
    bool usable =
        bend.reach_mm > 0 && bend.reach_mm <= kMost_mm && coefficients.size() == SheetBend::kTerms;
    for (std::size_t k = 0; usable && k < coefficients.size(); ++k) {
      bend.coefficients_mm[k] = coefficients[k].get<double>();
      usable = std::abs(bend.coefficients_mm[k]) <= kMost_mm;
    }
    if (usable) return bend;
  } catch (const nlohmann::json::exception&) {  // a value of another kind describes no bend
  }
  return std::nullopt;
}

}  // namespace ostraka::rig
