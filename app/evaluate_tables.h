#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "evaluate/cloud.h"
#include "evaluate/masks.h"
#include "evaluate/model.h"
#include "evaluate/pairs.h"

namespace ostraka::app {

/// The tables that `ostraka evaluate` prints, each ending in a line's end, and the same for
/// machines.
std::string table(const evaluate::BatchEvaluation& batch);
std::string table(const evaluate::ModelFigures& figures);
std::string table(const evaluate::CloudFigures& figures, const std::string& side);
std::string table(const evaluate::PairsEvaluation& set);
std::string table(const evaluate::PairsSummary& summary);
std::string table(const evaluate::MaskFigures& figures, int count, double worst,
                  const std::string& worst_name);

nlohmann::ordered_json toJson(const evaluate::BatchEvaluation& batch);
nlohmann::ordered_json toJson(const evaluate::ModelFigures& figures);
nlohmann::ordered_json toJson(const evaluate::CloudFigures& figures);
nlohmann::ordered_json toJson(const evaluate::PairsEvaluation& set,
                              const evaluate::PairsSummary& summary);
nlohmann::ordered_json toJson(const evaluate::MaskFigures& figures, int count, double worst,
                              const std::string& worst_name);

}  // namespace ostraka::app
