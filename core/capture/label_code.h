#pragma once
#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka::capture {

/// The texts of the QR codes in an encoded picture (JPEG, PNG), each once, in any direction; a
/// module must be 2 pixels wide or more. About 0.1 s for 2 megapixels. Errors: not decodable.
Result<std::vector<std::string>> codesIn(std::string_view picture);

/// A photograph and the texts of the codes in it.
struct PhotographCodes {
  std::filesystem::path file;
  std::vector<std::string> texts;
};

/// Those of `looked` photographs (2 or more) that are spread over the series, the first and the
/// last among them. A photograph that cannot be read has none. Errors: Cancelled.
Result<std::vector<PhotographCodes>> codesInSome(const std::vector<std::filesystem::path>& series,
                                                 std::size_t looked, const std::stop_token& stop);

}  // namespace ostraka::capture
