#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "base/result.h"
#include "decisions/pair_sides.h"
#include "scan/scan.h"
#include "scansets/register_scans.h"

namespace ostraka::scansets {

/// OUT/report.json (figures per pair; seconds are the only values that differ between two runs) and
/// OUT/report.html: one file without a network, the pair table with reasons and both sides' points
/// laid over each other, seen from above and from the side.
Result<void> writeRegisterReport(const std::filesystem::path& output,
                                 const RegisterSummary& summary, const decisions::PairTable& table,
                                 std::span<const scan::Scan> fronts,
                                 std::span<const scan::Scan> backs, const std::string& inputs_hash);

/// One row of the pair table, as in report.json; null where no fractures were compared.
nlohmann::ordered_json toJson(const RegisterSummary::Pair& pair);

}  // namespace ostraka::scansets
