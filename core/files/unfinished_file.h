#pragma once
#include <sys/types.h>

#include <string>

namespace ostraka {

/// A file in an open folder that gets its own name when it is whole.
struct UnfinishedFile {
  int fd = -1;  ///< to be closed by the caller; -1: errno says why there is none
  std::string name;
};

/// Begins one for the file of this name, and removes what killed programs left of such.
UnfinishedFile beginFile(int folder, const std::string& of, mode_t mode);

}  // namespace ostraka
