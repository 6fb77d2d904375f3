#pragma once
#include <sys/types.h>

#include <string>

namespace ostraka {

/// A file in an open folder that gets its final name once it is complete.
struct UnfinishedFile {
  int fd = -1;  ///< to be closed by the caller; -1: errno says why there is none
  std::string name;
};

/// Begins one for the file with this name, and removes those that killed programs left.
UnfinishedFile beginFile(int folder, const std::string& of, mode_t mode);

}  // namespace ostraka
