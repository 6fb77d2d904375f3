// Every input that the fuzzers were started from or once stumbled over, in the normal run of tests.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "targets.h"

namespace {

void replay(const char* target, void (*run)(std::string_view)) {
  int count = 0;
  const std::filesystem::path folder = std::filesystem::path(OSTRAKA_CORPUS) / target;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path());
    const auto bytes = ostraka::readFile(entry.path());
    ASSERT_TRUE(bytes.has_value());
    run(*bytes);
    // Cut off anywhere, and with a byte changed, the same promises hold.
    for (std::size_t k = 1; k < 64; ++k) {
      const std::size_t at = bytes->size() * k / 64;
      run(bytes->substr(0, at));
      std::string changed = *bytes;
      if (at < changed.size()) changed[at] = static_cast<char>(changed[at] ^ 0xFF);
      run(changed);
    }
    ++count;
  }
  EXPECT_GE(count, 5) << "the corpus of " << target << " is missing";
}

TEST(Corpus, OfPlyFilesKeepsThePromises) {
  replay("ply", ostraka::fuzz::ply);
}
TEST(Corpus, OfJsonFilesKeepsThePromises) {
  replay("json", ostraka::fuzz::json);
}
TEST(Corpus, OfTablesKeepsThePromises) {
  replay("table", ostraka::fuzz::table);
}
TEST(Corpus, OfSherdRecordsKeepsThePromises) {
  replay("sherd_json", ostraka::fuzz::sherdJson);
}
TEST(Corpus, OfDecisionsKeepsThePromises) {
  replay("decisions", ostraka::fuzz::decisions);
}
TEST(Corpus, OfImageHeadersKeepsThePromises) {
  replay("image_header", ostraka::fuzz::imageHeader);
}
TEST(Corpus, OfDeviceRepliesKeepsThePromises) {
  replay("device_replies", ostraka::fuzz::deviceReplies);
}

}  // namespace
