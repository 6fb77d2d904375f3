#include "base/limits.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace ostraka {
namespace {

std::string textOf(const std::string& file) {
  std::ifstream in(std::string(OSTRAKA_SOURCE_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t countOf(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
    ++count;
  return count;
}

// 65536 as 65,536.
std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; text.insert(at -= 3, ",")) {
  }
  return text;
}

TEST(Limits, AreAllListed) {
  EXPECT_EQ(countOf(textOf("core/base/limits.h"), "inline constexpr Limit k"),
            std::size(limits::kAll) + 1);  // and the list itself
}

TEST(Limits, StandInTheDocumentAsInTheHeader) {
  std::string table = "| what | most | why |\n|---|---|---|\n";
  for (const Limit& limit : limits::kAll) {
    const std::string unit = limit.unit;
    table += std::string("| ") + limit.what + " | " + grouped(limit.most) +
             (unit.empty() ? "" : " " + unit) + " | " + limit.reason + " |\n";
  }
  EXPECT_NE(textOf("docs/limits.md").find(table), std::string::npos)
      << "the table of docs/limits.md must be:\n"
      << table;
  EXPECT_NE(textOf("docs/limits.md")
                .find("at least " + std::to_string(limits::kLeastPhotographSide) + " pixels wide"),
            std::string::npos);
}

}  // namespace
}  // namespace ostraka
