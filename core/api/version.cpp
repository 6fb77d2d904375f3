#include "api/version.h"

namespace ostraka::api {

const char* version() {
  return OSTRAKA_VERSION;
}

}  // namespace ostraka::api
