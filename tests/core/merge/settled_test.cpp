#include "merge/settled.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::merge {
namespace {

class SettledFile : public testing::Test {
 protected:
  Result<Settled> read(const std::string& text) {
    const auto file = folder_.path() / "settled.json";
    EXPECT_TRUE(writeFileAtomically(file, text));
    return readSettled(file);
  }
  TemporaryFolder folder_;
};

TEST_F(SettledFile, SaysWhatToTakeOfEachConflict) {
  const Result<Settled> settled =
      read(R"([{"id": "sherd/1/ware", "take": "b"}, {"id": "context/2", "number": "X-7"},
             {"id": "number/3", "take": "a", "number": "X-8"},
             {"id": "number/4", "take": "one"}])");
  ASSERT_TRUE(settled) << settled.error().sentence();
  EXPECT_EQ(settled->at("sherd/1/ware").take, Take::B);
  EXPECT_EQ(settled->at("context/2").take, Take::Number);
  EXPECT_EQ(settled->at("context/2").number, "X-7");
  EXPECT_EQ(settled->at("number/3").take, Take::A);
  EXPECT_EQ(settled->at("number/3").number, "X-8");
  EXPECT_EQ(settled->at("number/4").take, Take::One);
}

TEST_F(SettledFile, IsRefusedWhereItSaysTwoThingsOrNothing) {
  for (const char* text :
       {"{}", "[1]", R"([{"take": "a"}])", R"([{"id": "x"}])", R"([{"id": "x", "take": "c"}])",
        R"([{"id": "x", "take": "one", "number": "1"}])", R"([{"id": "x", "take": "number"}])",
        R"([{"id": "x", "take": "a"}, {"id": "x", "take": "b"}])", "nothing"}) {
    const Result<Settled> settled = read(text);
    ASSERT_FALSE(settled) << text;
    EXPECT_EQ(settled.error().code, ErrorCode::UnusableInput) << text;
  }
}

}  // namespace
}  // namespace ostraka::merge
