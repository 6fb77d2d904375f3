#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka::capture {

/// The texts of the QR codes in an encoded picture (JPEG, PNG), each once, in any direction; a
/// module must be 2 pixels wide or more. About 0.1 s for 2 megapixels. Errors: not decodable.
Result<std::vector<std::string>> codesIn(std::string_view picture);

}  // namespace ostraka::capture
