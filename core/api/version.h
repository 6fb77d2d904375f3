#pragma once

/// What stands outside of the library; everything else in it is hidden.
#define OSTRAKA_API __attribute__((visibility("default")))

namespace ostraka::api {

/// Of the library that runs, as "0.1.0" (semver.org). Before 1.0.0 each minor version may change
/// the interface, so the library's soname carries both numbers.
OSTRAKA_API const char* version();

}  // namespace ostraka::api
