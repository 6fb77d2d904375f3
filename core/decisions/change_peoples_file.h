#pragma once
#include <filesystem>
#include <functional>

#include "base/result.h"

namespace ostraka::decisions {

/// Runs `change`, which reads one of the files of batch/peoples_files.h in OUT, changes it and
/// writes it back, while no other program or thread does: of two that decide or paint at one
/// moment neither loses what the other wrote. Not within itself. Where there is no OUT nothing is
/// held, nor on a file system without locks. Errors: those of `change`; CannotWrite when another
/// has held OUT for 10 s, and `change` was not run.
Result<void> changePeoplesFile(const std::filesystem::path& output,
                               const std::function<Result<void>()>& change);

}  // namespace ostraka::decisions
