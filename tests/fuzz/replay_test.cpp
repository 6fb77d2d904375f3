// Every input that the fuzzers were started from or once stumbled over, in the normal run of tests.
#include <gtest/gtest.h>

#include <filesystem>

#include "files/files.h"
#include "targets.h"

namespace {

void replay(const ostraka::fuzz::Target& target) {
  int count = 0;
  const std::filesystem::path folder = std::filesystem::path(OSTRAKA_CORPUS) / target.name;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path());
    const auto bytes = ostraka::readFile(entry.path());
    ASSERT_TRUE(bytes.has_value());
    target.run(*bytes);
    // Cut off anywhere, and with a byte changed, the same promises hold.
    for (std::size_t k = 1; k < 64; ++k) {
      const std::size_t at = bytes->size() * k / 64;
      target.run(bytes->substr(0, at));
      std::string changed = *bytes;
      if (at < changed.size()) changed[at] = static_cast<char>(changed[at] ^ 0xFF);
      target.run(changed);
    }
    ++count;
  }
  EXPECT_GE(count, 5) << "the corpus of " << target.name << " is missing";
}

class Corpus : public testing::TestWithParam<ostraka::fuzz::Target> {};

TEST_P(Corpus, KeepsThePromises) {
  replay(GetParam());
}

INSTANTIATE_TEST_SUITE_P(OfEachTarget, Corpus, testing::ValuesIn(ostraka::fuzz::targets()),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
