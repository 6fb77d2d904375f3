#pragma once
#include "base/progress.h"

namespace ostraka::api {

inline QuietProgress quiet;

}  // namespace ostraka::api
