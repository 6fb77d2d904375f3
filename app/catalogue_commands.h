#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "command.h"
#include "records/records.h"

namespace ostraka::app {

inline const records::Provenance kCommandLine = {{}, "command line", {}};

/// A sub-command of `ostraka catalogue`.
void addCatalogueImport(CLI::App& catalogue, Command& chosen);

/// The result as words, or with --json as an object; returns its exit_status, 0 without one.
int said(Session& session, nlohmann::ordered_json json, const std::string& words);

}  // namespace ostraka::app
