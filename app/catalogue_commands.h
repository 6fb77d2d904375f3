#pragma once
#include "command.h"
#include "records/records.h"

namespace ostraka::app {

inline const records::Provenance kCommandLine = {{}, "command line", {}};

/// Sub-commands of `ostraka catalogue`.
void addCatalogueImport(CLI::App& catalogue, Command& chosen);
void addCatalogueMerge(CLI::App& catalogue, Command& chosen);

}  // namespace ostraka::app
