#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka::archive {

struct ZipEntry {
  std::string name;  ///< with '/', ASCII
  std::string_view bytes;
};

/// A ZIP archive (APPNOTE 6.3) of entries as they are, not deflated, dated 1980-01-01 so that the
/// same contents give the same bytes. Errors: UnusableInput at 4 GiB, which would need ZIP64.
Result<std::string> zipped(const std::vector<ZipEntry>& entries);

}  // namespace ostraka::archive
