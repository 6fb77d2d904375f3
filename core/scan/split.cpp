#include "scan/split.h"
namespace ostraka::scan {
Result<SplitResult> splitScans(const PointCloud&, batch::Side, const SplitOptions&, Progress&) {
  return Error{ErrorCode::Failed, "not yet", {}};
}
}  // namespace ostraka::scan
