#include "metadata/sherd_json.h"

#include <gtest/gtest.h>

namespace ostraka::metadata {
namespace {

TEST(SherdJson, RecordsOfStrangersAreReadWithCare) {
  const auto why = [](const std::string& text) {
    const Result<ReadSherdJson> read = parseSherdJson(text, "x.json");
    return read ? std::string("accepted") : read.error().sentence().english();
  };
  EXPECT_NE(why("{}").find("Not a sherd record"), std::string::npos);
  EXPECT_NE(why("[1]").find("Not a sherd record"), std::string::npos);
  EXPECT_NE(why(R"({"format":"ostraka-sherd/1","number":7})").find("wrong type"),
            std::string::npos);
  EXPECT_NE(why(R"({"format":"ostraka-sherd/1","measurements":)"
                R"([{"kind":"length","value":1,"unit":"cm"}]})")
                .find("a unit other than mm"),
            std::string::npos);
  const Result<ReadSherdJson> own =
      parseSherdJson(R"({"format":"ostraka-sherd/1","id":"x","mine":{"a":1}})", "x");
  ASSERT_TRUE(own);
  EXPECT_EQ(own->row.values.at("extra.mine"), R"({"a":1})") << "unknown keys survive";
}

TEST(SherdJson, AProposalIsNoEntry) {
  const Result<ReadSherdJson> read = parseSherdJson(
      R"({"format":"ostraka-sherd/1","id":"x","proposals":{"munsell":{"out":"5YR 5/4"}},)"
      R"("processing":{"program":"ostraka 1","texture":"albedo"}})",
      "x");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->row.values.size(), 1u) << "the id alone";
}

}  // namespace
}  // namespace ostraka::metadata
