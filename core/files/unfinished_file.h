#pragma once
#include <sys/types.h>

#include <string>
#include <string_view>

#include "files/file_descriptor.h"

namespace ostraka {

/// A file in an open folder that gets its final name once it is complete.
struct UnfinishedFile {
  FileDescriptor file;  ///< not open: errno says why there is none
  std::string name;
};

/// Begins one for the file with this name, and removes those that killed programs left.
UnfinishedFile beginFile(int folder, const std::string& of, mode_t mode);

/// False: errno says why.
bool writeAll(int fd, std::string_view bytes);

}  // namespace ostraka
