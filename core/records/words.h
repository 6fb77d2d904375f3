#pragma once
#include <array>
#include <string>
#include <string_view>

#include "records/records.h"
#include "records/sherd.h"
#include "store/statement.h"

namespace ostraka::records {

/// An enumeration's words as the tables hold them, in the order of the enumeration.
template <class Enum>
struct Words;
template <>
struct Words<BatchState> {
  static constexpr std::array<const char*, 9> all = {
      "placed", "front", "flipped", "back", "queued", "computed", "review", "done", "failed"};
};
template <>
struct Words<ScanState> {
  static constexpr std::array<const char*, 3> all = {"open", "paired", "aside"};
};
template <>
struct Words<Verdict> {
  static constexpr std::array<const char*, 5> all = {"accept", "reject", "aside", "reshoot",
                                                     "withdraw"};
};
template <>
struct Words<SherdState> {
  static constexpr std::array<const char*, 3> all = {"draft", "numbered", "void"};
};
template <>
struct Words<FileState> {
  static constexpr std::array<const char*, 3> all = {"present", "missing", "changed"};
};
template <>
struct Words<batch::Side> {
  static constexpr std::array<const char*, 2> all = {"front", "back"};
};

template <class Enum>
const char* wordOf(Enum value) {
  return Words<Enum>::all[static_cast<std::size_t>(value)];
}
/// The first value when the word is not known; the tables hold known words only.
template <class Enum>
Enum fromWord(std::string_view word) {
  for (std::size_t i = 0; i < Words<Enum>::all.size(); ++i)
    if (word == Words<Enum>::all[i]) return static_cast<Enum>(i);
  return Enum{};
}

}  // namespace ostraka::records

namespace ostraka::store {

/// A column that holds the word of an enumeration's value.
template <class Enum>
requires requires {
  records::Words<Enum>::all;
}
Statement& operator>>(Statement& row, Enum& value) {
  std::string word;
  row >> word;
  value = records::fromWord<Enum>(word);
  return row;
}

}  // namespace ostraka::store
