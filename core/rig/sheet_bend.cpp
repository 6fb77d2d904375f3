#include "rig/sheet_bend.h"

#include <nlohmann/json.hpp>

namespace ostraka::rig {

nlohmann::ordered_json toJson(const SheetBend& bend) {
  return {{"reach", bend.reach_mm}, {"coefficients", bend.coefficients_mm}};
}

Result<SheetBend> sheetBendFrom(const nlohmann::json& value) {
  constexpr double kMostMm = 1000;  // no sheet is as large, nor leaves its plane as far
  try {
    SheetBend bend;
    bend.reach_mm = value.at("reach").get<double>();
    bend.coefficients_mm = value.at("coefficients").get<std::array<double, SheetBend::kTerms>>();
    bool usable = bend.reach_mm > 0 && bend.reach_mm < kMostMm;
    for (const double c : bend.coefficients_mm) usable = usable && std::abs(c) < kMostMm;
    if (usable && value.at("coefficients").size() == SheetBend::kTerms) return bend;
  } catch (const nlohmann::json::exception&) {
  }
  return Error{ErrorCode::UnusableInput, "The bend of a sheet is not described.", {}};
}

}  // namespace ostraka::rig
