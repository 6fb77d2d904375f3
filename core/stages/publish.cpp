#include "stages/publish.h"

#include "files/files.h"
#include "stages/output_folder.h"

namespace ostraka::stages {

namespace fs = std::filesystem;

Result<void> publish(const FolderLock& held, const std::string& number, bool has_model) {
  const fs::path output = held.folder().parent_path(), to = output / "sherds" / number;
  struct Left {
    const char *stage, *name;
    bool is_there;
  };
  if (!held.stands()) return outputGone(output);
  for (const Left& left :
       {Left{"model_", "front.ply", true}, Left{"model_", "back.ply", true},
        Left{"model_", "model.ply", has_model}, Left{"texture_", "model.glb", has_model},
        Left{"texture_", "preview.png", has_model}}) {
    std::error_code failed;
    if (!left.is_there) {
      fs::remove(to / left.name, failed);
      continue;
    }
    const Result<std::string> bytes = readFile(held.folder() / (left.stage + number) / left.name);
    if (!bytes) return bytes.error();
    if (const Result<void> written = writeFileAtomically(to / left.name, *bytes); !written)
      return written;
  }
  if (held.stands()) return {};
  std::error_code ignored;
  fs::remove_all(to, ignored);
  return outputGone(output);
}

void removeStaleSherds(const fs::path& output, const std::set<std::string>& numbers) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(output / "sherds", ignored))
    if (!numbers.contains(entry.path().filename().string())) fs::remove_all(entry.path(), ignored);
}

}  // namespace ostraka::stages
