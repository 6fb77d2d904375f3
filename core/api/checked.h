#pragma once
#include <exception>
#include <string>

#include "base/result.h"
#include "cloud/points_and_meshes.h"

namespace ostraka::api {

/// Points of another program may be anything, where a file's reader has sorted out what cannot be
/// used: its points as a file's reader gives them (oriented). Errors, which name the cloud:
/// UnusableInput (no normals, a value that is not finite, colours or qualities in another number
/// than points).
Result<PointCloud> checkedCloud(const PointCloud& cloud, const std::string& name);

/// What a function of the interface computes; an exception becomes an Error: it may have been
/// compiled by another compiler than its caller.
template <class Function>
auto withoutExceptions(Function&& function) -> decltype(function()) {
  try {
    return function();
  } catch (const std::exception& thrown) {
    return Error{ErrorCode::Failed, thrown.what(), {}};
  }
}

}  // namespace ostraka::api
