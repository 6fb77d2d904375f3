#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka {

/// A relative path as a file from elsewhere may name it: parts between single '/', none of them '.'
/// or '..', no backslash, drive or control character, at most 4096 bytes. It does not exclude links
/// on the disk; OpenFolder opens it without following any.
class ContainedPath {
 public:
  /// Error: UnusableInput for everything else.
  static Result<ContainedPath> parse(std::string_view text);
  const std::string& text() const { return text_; }
  const std::vector<std::string>& parts() const { return parts_; }
  /// The path without its first part, which must not be its only one.
  ContainedPath below() const;

 private:
  std::string text_;
  std::vector<std::string> parts_;
};

}  // namespace ostraka
