#pragma once
#include <string_view>

namespace ostraka::segmentation {

/// Ostraka's own network (resources/network), ONNX, as Network takes it.
std::string_view shippedNetwork();

}  // namespace ostraka::segmentation
