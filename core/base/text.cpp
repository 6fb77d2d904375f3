#include "base/text.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <ctime>

namespace ostraka {
namespace {

std::string utcText(std::time_t seconds, const char* form) {
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, form, &parts)};
}

}  // namespace

std::string fixed(double value, int digits) {
  char text[400];  // the largest double has 309 digits before the point
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr;
  return {text, end};
}

std::string lowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string joined(std::span<const std::string> words, const char* between) {
  std::string text;
  for (const std::string& word : words) {
    if (&word != words.data()) text += between;
    text += word;
  }
  return text;
}

std::string utcNow() {
  return utcText(std::time(nullptr), "%Y-%m-%dT%H:%M:%SZ");
}

std::string utcDay(std::int64_t ms) {
  return utcText(static_cast<std::time_t>(ms / 1000), "%Y-%m-%d");
}

}  // namespace ostraka
