#include "pipeline/chain.h"

namespace ostraka::pipeline {

// That a file changed explains why it could not be used, too.
Result<stages::StageRecord> runStage(const Run& run, const std::string& name,
                                     const nlohmann::ordered_json& key,
                                     const stages::StageWork& work) {
  const auto ofTheSameFiles =
      [&](const std::filesystem::path& folder) -> Result<stages::StageNotes> {
    Result<stages::StageNotes> notes = work(folder);
    if (!notes && notes.error().code != ErrorCode::UnusableInput &&
        notes.error().code != ErrorCode::NotEnough)
      return notes;
    if (const Result<void> same = run.inputs.checkUnchanged(); !same) return same.error();
    return notes;
  };
  return stages::runStage(run.held, name, key, ofTheSameFiles, run.progress);
}

}  // namespace ostraka::pipeline
