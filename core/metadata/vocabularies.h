#pragma once
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::metadata {

/// metadata/vocabularies.json: the terms that these sherds use, with their labels and URIs.
Result<nlohmann::ordered_json> vocabulariesJson(const catalogue::Catalogue& catalogue,
                                                const std::vector<records::SherdRecord>& sherds);

/// Adds the terms that the project knows neither as a term nor as a label of one, behind its own;
/// those that it has stay as they are. Throws json::exception where something is not as written.
Result<void> readVocabularies(catalogue::Catalogue& catalogue, const nlohmann::json& vocabularies,
                              const records::Provenance& provenance);

}  // namespace ostraka::metadata
