#pragma once
#include <map>
#include <string>

#include "base/result.h"

namespace ostraka::archive {

/// Files and folders of one bag whose names stay apart on every system: letters that differ in
/// case, or in how an accent is written, are the same on some.
class DistinctPaths {
 public:
  /// path: with '/'. Error: UnusableInput when it, or a folder on the way, is spelled otherwise
  /// than before, or it was added before.
  Result<void> add(const std::string& path);

 private:
  std::map<std::string, std::string> spellings_;  ///< what is unique -> as it was written
};

}  // namespace ostraka::archive
