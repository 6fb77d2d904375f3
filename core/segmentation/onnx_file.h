#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka::segmentation {

/// Shape of the model's image input; -1 where it is free.
using InputShape = std::vector<std::int64_t>;

/// Of the first input of a network (the bytes of an ONNX file) that is no weights; nothing where
/// there is none.
std::optional<InputShape> inputShapeOf(std::string_view model);

/// Looks at what OpenCV's reader takes on trust: that each tensor has as many bytes as its shape
/// says, and that convolutions have weights, groups and steps. `where` names the file.
/// Errors: UnusableInput. O(bytes), without memory of its own for the weights.
Result<void> checkOnnx(std::string_view model, const std::string& where);

}  // namespace ostraka::segmentation
