#include "batch/batch.h"

namespace ostraka::batch {

const char* name(Side side) { return side == Side::Front ? "front" : "back"; }

}  // namespace ostraka::batch
