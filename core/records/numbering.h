#pragma once
#include <cstdint>
#include <map>
#include <optional>
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

/// Which running numbers a computer gives.
struct NumberBlock {
  static constexpr int kLast = 999'999'999;
  int first = 1, last = kLast;
  /// Both as settings hold them; empty: the default. Error: UnusableInput for all but 1..kLast.
  static Result<NumberBlock> parse(std::string_view first, std::string_view last);
};

/// The numbers that differ in {n} alone. Places are told apart by store::codeKey, so their numbers
/// are too: T3 written on a sherd is the trench that was typed as t3.
class NumberCount {
 public:
  explicit NumberCount(const std::string& counter);  ///< as Numbering::counter has it
  /// Which n of this count a number is; none: it is of another count or form.
  std::optional<std::int64_t> of(const std::string& number) const;
  /// How the store::codeKey of each of its numbers begins.
  const std::string& before() const { return before_; }

 private:
  std::string before_, after_;
};

}  // namespace ostraka::records
