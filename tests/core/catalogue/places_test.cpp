#include "catalogue/places.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "records/records.h"
#include "records/sherd.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

using PlacesTest = SmallProject;

TEST_F(PlacesTest, AreReadBackAsTheyWereSaved) {
  const std::vector<records::ContextRecord> contexts = *Places(catalogue()).contexts();
  ASSERT_EQ(contexts.size(), 2u);
  EXPECT_EQ(contexts[0].number, "0012");
  EXPECT_EQ(contexts[0].site_code, "ARM1");
  EXPECT_EQ(contexts[0].trench_code, "T3");
  EXPECT_EQ(Places(catalogue()).bags(context12)->size(), 2u);
  EXPECT_EQ(Places(catalogue()).bags()->size(), 3u);
  EXPECT_EQ(People(catalogue()).all()->front().initials, "AP");
}

TEST_F(PlacesTest, NoPlaceIsThereTwice) {
  records::SiteRecord s;
  s.code = "arm1";
  EXPECT_FALSE(Places(catalogue()).save(s, anna)) << "capitals make no difference";
  records::TrenchRecord t;
  t.site = site;
  t.code = "T3";
  EXPECT_FALSE(Places(catalogue()).save(t, anna));
  records::ContextRecord c;
  c.site = site;
  c.trench = trench;
  c.number = "0012";
  EXPECT_FALSE(Places(catalogue()).save(c, anna));
  c.number = "12";
  EXPECT_TRUE(Places(catalogue()).save(c, anna)) << "numbers of contexts are texts: 12 is not 0012";
  c.number = "0012";
  c.trench = {};
  EXPECT_TRUE(Places(catalogue()).save(c, anna)) << "directly in the site";
  EXPECT_FALSE(Places(catalogue()).save(c, anna));
  records::BagRecord b;
  b.context = context12;
  b.number = "4";
  EXPECT_FALSE(Places(catalogue()).save(b, anna));
  EXPECT_FALSE(People(catalogue()).save(records::PersonRecord{{}, {}, "Another", "ap", {}}, anna));
}

TEST_F(PlacesTest, APersonIsKnownByInitialsInAnyCapitals) {
  EXPECT_EQ(*People(catalogue()).byInitials("ap", {}), anna.person);
  EXPECT_EQ(*People(catalogue()).byInitials(" AP ", {}), anna.person);
  const Result<store::PersonRow> fresh = People(catalogue()).byInitials("b\u00e9", {});
  ASSERT_TRUE(fresh);
  EXPECT_EQ(*People(catalogue()).byInitials("BE\u0301", {}), *fresh) << "composed or not";
  EXPECT_EQ(People(catalogue()).all()->size(), 2u);
  EXPECT_FALSE(People(catalogue()).byInitials("", {}));
}

TEST_F(PlacesTest, WhatCannotBeIsRefused) {
  records::SiteRecord s;
  EXPECT_FALSE(Places(catalogue()).save(s, anna)) << "no code";
  s.code = "X";
  s.latitude_deg = 91;
  EXPECT_FALSE(Places(catalogue()).save(s, anna));
  records::ContextRecord c;
  c.site = site;
  c.number = "7";
  c.excavated_on = "yesterday";
  EXPECT_FALSE(Places(catalogue()).save(c, anna));
  c.excavated_on = "";
  c.date_edtf = "600 BC";
  EXPECT_FALSE(Places(catalogue()).save(c, anna));
  c.date_edtf = "";
  c.kind = "hole";
  EXPECT_FALSE(Places(catalogue()).save(c, anna));
  c.kind = "layer";
  EXPECT_TRUE(Places(catalogue()).save(c, anna));
  records::BagRecord b;
  b.context = context12;
  b.number = "9";
  b.weight_g = 0;
  EXPECT_FALSE(Places(catalogue()).save(b, anna));
}

TEST_F(PlacesTest, ATextThatNoDocumentCanHoldIsRefusedByItsField) {
  records::ContextRecord context;
  context.site = site;
  context.number = "15";
  context.note = "dark\x01 fill";
  const auto refused = Places(catalogue()).save(context, anna);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence(),
            "note: The text contains control characters, which documents cannot contain; type it "
            "again.");
}

TEST_F(PlacesTest, ACodeHasNoLettersThatNobodySees) {
  records::SiteRecord turned;
  turned.code = "ARM\u202E2";
  turned.name = "Hill";
  EXPECT_FALSE(Places(catalogue()).save(turned, anna));
  turned.code = "ARM2";
  turned.name = "\u200FHill";
  EXPECT_TRUE(Places(catalogue()).save(turned, anna)) << "a name may need them";
  records::ContextRecord context;
  context.site = site;
  for (const char* number : {"0014\u200B", "12\n13", "12\t13"}) {
    context.number = number;
    EXPECT_FALSE(Places(catalogue()).save(context, anna)) << number;
  }
}

TEST_F(PlacesTest, AChangeIsInTheHistoryOnce) {
  records::SiteRecord s = Places(catalogue()).sites()->front();
  s.name = "Long hill";
  s.latitude_deg = 40.1;
  ASSERT_TRUE(Places(catalogue()).save(s, anna));
  ASSERT_TRUE(Places(catalogue()).save(s, anna)) << "saving the same again is no change";
  const std::vector<records::HistoryEntry> history = *History(catalogue()).of("site", s.row.value);
  ASSERT_EQ(history.size(), 3u);  // newest first: latitude, name, and that it was added
  EXPECT_EQ(history[0].field, "latitude_deg");
  EXPECT_EQ(history[0].new_value, "40.1");
  EXPECT_EQ(history[1].old_value, "Hill");
  EXPECT_EQ(history[1].new_value, "Long hill");
  EXPECT_EQ(history[1].by, anna.person);
}

TEST_F(PlacesTest, SherdsAreFoundByTheNewNameOfTheirContext) {
  numbered(context12);
  records::ContextRecord c = Places(catalogue()).contexts()->front();
  c.number = "pit 77";
  ASSERT_TRUE(Places(catalogue()).save(c, anna));
  EXPECT_EQ(found("\"pit 77\"").size(), 1u);
}

}  // namespace
}  // namespace ostraka::catalogue
