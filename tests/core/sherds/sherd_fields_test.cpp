#include "sherds/sherd_fields.h"

#include <gmock/gmock.h>

#include <set>
#include <string>

#include "records/sherd.h"

namespace ostraka::sherds {
namespace {

TEST(SherdFields, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const records::SherdField& field : filterFields())
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
  EXPECT_TRUE(names.contains("thickness_mean_mm"));
  EXPECT_EQ(filterFields().size(), sherdFields().size() + 2) << "and two days";
  for (const records::SherdField& field : sherdFields())
    EXPECT_STREQ(sherdField(field.name)->name, field.name);
  EXPECT_EQ(sherdField("drawer"), nullptr);
  EXPECT_EQ(sherdField("extra.drawer"), nullptr);
}

TEST(SherdFields, AreTextsAsTablesHaveThem) {
  records::SherdRecord sherd;
  sherd.ware = "grey";
  sherd.part = {"rim", "neck"};
  sherd.measures = {{"length", 52.125}, {"thickness_mean", 6}};
  sherd.join_numbers = {"A-2", "A-3"};
  sherd.scale_doubtful = true;
  sherd.state = records::SherdState::Void;
  EXPECT_EQ(textOf(sherd, "ware"), "grey");
  EXPECT_EQ(textOf(sherd, "part"), "rim; neck");
  EXPECT_EQ(textOf(sherd, "length_mm"), "52.125");
  EXPECT_EQ(textOf(sherd, "thickness"), "6") << "as a person writes it in a filter";
  EXPECT_EQ(textOf(sherd, "weight_g"), "");
  EXPECT_EQ(textOf(sherd, "joins"), "A-2; A-3");
  EXPECT_EQ(textOf(sherd, "scale"), "doubtful");
  EXPECT_EQ(textOf(sherd, "state"), "void");
  EXPECT_EQ(textOf(sherd, "no such field"), "");
  EXPECT_EQ(textOf(records::SherdRecord(), "scale"), "");
}

// Whoever imported the table may have written anything there.
TEST(SherdFields, OfOnesOwnAreTextsWhateverTheJsonHolds) {
  const std::string extra = R"({"drawer":"7 \"b\"","shelf":3,"list":[1,"x"]})";
  EXPECT_EQ(customText(extra, "drawer"), "7 \"b\"");
  EXPECT_EQ(customText(extra, "shelf"), "3");
  EXPECT_EQ(customText(extra, "list"), R"([1,"x"])");
  for (const char* none : {"", "{}", "[1]", "null", "{not json", "\"drawer\""})
    EXPECT_EQ(customText(none, "drawer"), "") << none;
  records::SherdRecord sherd;
  sherd.extra_json = extra;
  EXPECT_EQ(textOf(sherd, "extra.drawer"), "7 \"b\"");
  EXPECT_EQ(textOf(sherd, "drawer"), "") << "a column of this name may come one day";
}

}  // namespace
}  // namespace ostraka::sherds
