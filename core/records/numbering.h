#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka::records {

/// `{site}-{trench}-{context}-{n:04}`: how sherds are numbered. n counts for each combination of
/// the other tokens.
class Numbering {
 public:
  /// Tokens: site trench context bag batch yyyy yy, and n exactly once; `:0w` pads digits to a
  /// least width. Literals: letters, digits, '.', '_', '/', '-'. Tokens must not touch each other.
  /// Errors: UnusableInput with a sentence.
  static Result<Numbering> parse(std::string_view scheme);

  /// The number for these values of the tokens. Errors: a token that is not among them. One with an
  /// empty value is a part that the place does not have: left out with its separator.
  Result<std::string> number(const std::map<std::string, std::string>& values, int n) const;
  /// All but n filled in: sherds with the same counter share one count.
  Result<std::string> counter(const std::map<std::string, std::string>& values) const;
  /// What could be misread: a value that contains the literal beside it, as 12-3. Empty when clear.
  Message warning(const std::map<std::string, std::string>& values) const;

 private:
  struct Part {
    bool token = false;
    std::string text;  ///< the literal, or the token's name
    int width = 0;
  };
  std::string fill(const std::map<std::string, std::string>& values, std::string_view n,
                   std::string* lacking) const;
  std::vector<Part> parts_;
};

}  // namespace ostraka::records
