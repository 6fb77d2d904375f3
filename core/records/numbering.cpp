#include "records/numbering.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "base/message.h"
#include "store/names.h"

namespace ostraka::records {
namespace {

constexpr std::array kTokens = {"site", "trench", "context", "bag", "batch", "yyyy", "yy", "n"};

bool isDigits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool isLiteral(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '/' || c == '-';
}

std::string padded(std::string_view value, int width) {
  if (!isDigits(value) || static_cast<int>(value.size()) >= width) return std::string(value);
  return std::string(static_cast<std::size_t>(width) - value.size(), '0') + std::string(value);
}

Message lacks(std::string_view token) {
  if (token == "site")
    return message("The number needs the site of the sherd, which is not recorded.");
  if (token == "trench")
    return message(
        "The number needs the trench of the sherd, which is not recorded; choose a context in a "
        "trench, or change the numbering in the settings.");
  if (token == "context")
    return message("The number needs the context of the sherd, which is not recorded.");
  if (token == "bag")
    return message("The number needs the bag of the sherd, which is not recorded.");
  return message("The number needs the batch of the sherd, which is not recorded.");
}

// Where one part ends and the next begins could not be told.
Message unclear(std::string_view token, const std::string& value, const std::string& letters) {
  if (token == "site")
    return message("The site %1 contains the character '%2' that is next to it in the number.",
                   value, letters);
  if (token == "trench")
    return message("The trench %1 contains the character '%2' that is next to it in the number.",
                   value, letters);
  if (token == "context")
    return message("The context %1 contains the character '%2' that is next to it in the number.",
                   value, letters);
  if (token == "bag")
    return message("The bag %1 contains the character '%2' that is next to it in the number.",
                   value, letters);
  return message("The batch %1 contains the character '%2' that is next to it in the number.",
                 value, letters);
}

}  // namespace

Result<Numbering> Numbering::parse(std::string_view scheme) {
  Numbering numbering;
  int counters = 0;
  for (std::size_t i = 0; i < scheme.size();) {
    if (scheme[i] != '{') {
      if (!isLiteral(scheme[i]))
        return Error::unusable(
            message("The numbering cannot contain the character '%1'; letters, digits, '.', '_', "
                    "'/' and '-' are allowed between the tokens.",
                    scheme[i]));
      if (numbering.parts_.empty() || numbering.parts_.back().token)
        numbering.parts_.push_back({false, {}, 0});
      numbering.parts_.back().text += scheme[i++];
      continue;
    }
    const std::size_t end = scheme.find('}', i);
    if (end == std::string_view::npos)
      return Error::unusable(
          message("The numbering opens a token with { and does not close it with }."));
    const std::string_view inside = scheme.substr(i + 1, end - i - 1);
    const std::size_t colon = inside.find(':');
    Part part{true, std::string(inside.substr(0, colon)), 0};
    if (std::find(kTokens.begin(), kTokens.end(), part.text) == kTokens.end())
      return Error::unusable(
          message("The numbering has no token {%1}; available: site, trench, context, bag, batch, "
                  "yyyy, yy and n.",
                  part.text));
    if (colon != std::string_view::npos) {
      const std::string_view width = inside.substr(colon + 1);
      if (!isDigits(width) || width[0] != '0' || width.size() > 3 ||
          std::stoi(std::string(width)) > 12)
        return Error::unusable(message(
            "The width of {%1} must be written as :04, with 12 digits at most.", part.text));
      part.width = std::stoi(std::string(width));
    }
    if (!numbering.parts_.empty() && numbering.parts_.back().token)
      return Error::unusable(
          message("Two tokens are adjacent; put '-' or another character between {%1} and {%2}.",
                  numbering.parts_.back().text, part.text));
    counters += part.text == "n";
    numbering.parts_.push_back(std::move(part));
    i = end + 1;
  }
  if (counters != 1)
    return Error::unusable(message("The numbering must count the sherds with {n} exactly once."));
  return numbering;
}

Result<NumberBlock> NumberBlock::parse(std::string_view first, std::string_view last) {
  NumberBlock block;
  for (const auto& [text, number] :
       {std::pair(first, &block.first), std::pair(last, &block.last)}) {
    if (text.empty()) continue;
    const auto [end, bad] = std::from_chars(text.data(), text.data() + text.size(), *number);
    if (bad != std::errc() || end != text.data() + text.size() || *number < 1 || *number > kLast)
      return Error::unusable(
          message("The block of numbers of this computer begins or ends with '%1', but must be of "
                  "whole numbers from 1 to %2; set it in the settings.",
                  std::string(text), kLast));
  }
  return block;
}

std::string Numbering::fill(const std::map<std::string, std::string>& values, std::string_view n,
                            std::string* lacking) const {
  std::string out;
  std::size_t before = 0;  // where the last literal of `out` begins
  bool left_out = false;   // the part before this one
  for (const Part& part : parts_) {
    if (!part.token) {
      before = out.size();
      if (!left_out) out += part.text;
      left_out = false;
      continue;
    }
    const auto value = values.find(part.text);
    if (part.text == "n")
      out += n.starts_with('{') ? std::string(n) : padded(n, part.width);
    else if (value == values.end())
      *lacking = part.text;
    else
      out += padded(value->second, part.width);
    left_out = part.text != "n" && value != values.end() && value->second.empty();
  }
  if (left_out) out.resize(before);
  return out;
}

Result<std::string> Numbering::number(const std::map<std::string, std::string>& values,
                                      int n) const {
  std::string lacking;
  std::string out = fill(values, std::to_string(n), &lacking);
  if (!lacking.empty()) return Error::unusable(lacks(lacking));
  return out;
}

Result<std::string> Numbering::counter(const std::map<std::string, std::string>& values) const {
  std::string lacking;
  std::string out = fill(values, "{n}", &lacking);
  if (!lacking.empty()) return Error::unusable(lacks(lacking));
  return out;
}

Message Numbering::warning(const std::map<std::string, std::string>& values) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!parts_[i].token) continue;
    const auto value = values.find(parts_[i].text);
    if (value == values.end()) continue;
    for (const std::size_t k : {i - 1, i + 1})
      if (k < parts_.size() && value->second.find(parts_[k].text) != std::string::npos)
        return unclear(parts_[i].text, value->second, parts_[k].text);
  }
  return {};
}

NumberCount::NumberCount(const std::string& counter) {
  const std::size_t n = counter.find("{n}");
  before_ = store::codeKey(counter.substr(0, n));
  after_ = store::codeKey(counter.substr(n + 3));
}

std::optional<std::int64_t> NumberCount::of(const std::string& number) const {
  constexpr std::size_t kMostDigits = 12;
  const std::string key = store::codeKey(number);
  if (key.size() <= before_.size() + after_.size() || !key.starts_with(before_) ||
      !key.ends_with(after_))
    return {};
  const std::string digits =
      key.substr(before_.size(), key.size() - before_.size() - after_.size());
  if (digits.size() > kMostDigits || !isDigits(digits)) return {};
  return std::stoll(digits);
}

}  // namespace ostraka::records
