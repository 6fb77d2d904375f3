#include "archive/distinct_paths.h"

#include "base/message.h"
#include "store/names.h"

namespace ostraka::archive {

Result<void> DistinctPaths::add(const std::string& path) {
  for (std::size_t to = path.find('/');; to = path.find('/', to + 1)) {
    const std::string name = path.substr(0, to);
    const auto [known, is_new] = spellings_.try_emplace(store::uniqueKey(name), name);
    const bool is_whole = to == std::string::npos;
    if (known->second != name || (is_whole && !is_new))
      return Error::unusable(
          message("On some systems this is the same name as %1; rename one of the two, then try "
                  "again.",
                  known->second),
          path);
    if (is_whole) return {};
  }
}

}  // namespace ostraka::archive
