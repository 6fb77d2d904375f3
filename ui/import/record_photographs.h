#pragma once
#include <QString>

namespace ostraka::ui {

class ProjectSession;

/// Enters a batch's photographs with their hashes into the catalogue, in the background: what
/// vanishes or changes from now on is noticed. If it fails, processing the batch enters them.
/// source: "import", "capture", for the history.
void recordPhotographs(ProjectSession& session, const QString& batch, const char* source);

}  // namespace ostraka::ui
