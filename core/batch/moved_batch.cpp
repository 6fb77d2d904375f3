#include "batch/moved_batch.h"

namespace ostraka::batch {

namespace fs = std::filesystem;

fs::path photographNow(const std::string& then, const fs::path& output) {
  const fs::path old(then);
  std::error_code ignored;
  const fs::path results = fs::absolute(output, ignored).lexically_normal();
  const fs::path folder = results.has_filename() ? results : results.parent_path();
  const fs::path now = folder.parent_path().parent_path() / "batches" / folder.filename() /
                       old.parent_path().filename() / old.filename();
  return fs::exists(now, ignored) ? now : old;
}

}  // namespace ostraka::batch
