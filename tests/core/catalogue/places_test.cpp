#include "small_project.h"

namespace ostraka::catalogue {
namespace {

using Places = SmallProject;

TEST_F(Places, AreReadBackAsTheyWereSaved) {
  const std::vector<records::ContextRecord> contexts = *catalogue().contexts();
  ASSERT_EQ(contexts.size(), 2u);
  EXPECT_EQ(contexts[0].number, "0012");
  EXPECT_EQ(contexts[0].site_code, "ARM1");
  EXPECT_EQ(contexts[0].trench_code, "T3");
  EXPECT_EQ(catalogue().bags(context12)->size(), 2u);
  EXPECT_EQ(catalogue().bags()->size(), 3u);
  EXPECT_EQ(catalogue().persons()->front().initials, "AP");
}

TEST_F(Places, NoPlaceIsThereTwice) {
  records::SiteRecord s;
  s.code = "arm1";
  EXPECT_FALSE(catalogue().save(s, anna)) << "capitals make no difference";
  records::TrenchRecord t;
  t.site = site;
  t.code = "T3";
  EXPECT_FALSE(catalogue().save(t, anna));
  records::ContextRecord c;
  c.site = site;
  c.trench = trench;
  c.number = "0012";
  EXPECT_FALSE(catalogue().save(c, anna));
  c.number = "12";
  EXPECT_TRUE(catalogue().save(c, anna)) << "numbers of contexts are texts: 12 is not 0012";
  c.number = "0012";
  c.trench = {};
  EXPECT_TRUE(catalogue().save(c, anna)) << "directly in the site";
  EXPECT_FALSE(catalogue().save(c, anna));
  records::BagRecord b;
  b.context = context12;
  b.number = "4";
  EXPECT_FALSE(catalogue().save(b, anna));
  EXPECT_FALSE(catalogue().save(records::PersonRecord{{}, {}, "Another", "ap", {}}, anna));
}

TEST_F(Places, APersonIsKnownByInitialsInAnyCapitals) {
  EXPECT_EQ(*catalogue().personByInitials("ap", {}), anna.person);
  EXPECT_EQ(*catalogue().personByInitials(" AP ", {}), anna.person);
  const Result<store::PersonRow> fresh = catalogue().personByInitials("b\u00e9", {});
  ASSERT_TRUE(fresh);
  EXPECT_EQ(*catalogue().personByInitials("BE\u0301", {}), *fresh) << "composed or not";
  EXPECT_EQ(catalogue().persons()->size(), 2u);
  EXPECT_FALSE(catalogue().personByInitials("", {}));
}

TEST_F(Places, WhatCannotBeIsRefused) {
  records::SiteRecord s;
  EXPECT_FALSE(catalogue().save(s, anna)) << "no code";
  s.code = "X";
  s.latitude_deg = 91;
  EXPECT_FALSE(catalogue().save(s, anna));
  records::ContextRecord c;
  c.site = site;
  c.number = "7";
  c.excavated_on = "yesterday";
  EXPECT_FALSE(catalogue().save(c, anna));
  c.excavated_on = "";
  c.date_edtf = "600 BC";
  EXPECT_FALSE(catalogue().save(c, anna));
  c.date_edtf = "";
  c.kind = "hole";
  EXPECT_FALSE(catalogue().save(c, anna));
  c.kind = "layer";
  EXPECT_TRUE(catalogue().save(c, anna));
  records::BagRecord b;
  b.context = context12;
  b.number = "9";
  b.weight_g = 0;
  EXPECT_FALSE(catalogue().save(b, anna));
}

TEST_F(Places, AChangeIsInTheHistoryOnce) {
  records::SiteRecord s = catalogue().sites()->front();
  s.name = "Long hill";
  s.latitude_deg = 40.1;
  ASSERT_TRUE(catalogue().save(s, anna));
  ASSERT_TRUE(catalogue().save(s, anna)) << "saving the same again is no change";
  const std::vector<records::HistoryEntry> history = *catalogue().history("site", s.row.value);
  ASSERT_EQ(history.size(), 3u);  // newest first: latitude, name, and that it was added
  EXPECT_EQ(history[0].field, "latitude_deg");
  EXPECT_EQ(history[0].new_value, "40.1");
  EXPECT_EQ(history[1].old_value, "Hill");
  EXPECT_EQ(history[1].new_value, "Long hill");
  EXPECT_EQ(history[1].by, anna.person);
}

TEST_F(Places, SherdsAreFoundByTheNewNameOfTheirContext) {
  numbered(context12);
  records::ContextRecord c = catalogue().contexts()->front();
  c.number = "pit 77";
  ASSERT_TRUE(catalogue().save(c, anna));
  EXPECT_EQ(found("\"pit 77\"").size(), 1u);
}

}  // namespace
}  // namespace ostraka::catalogue
