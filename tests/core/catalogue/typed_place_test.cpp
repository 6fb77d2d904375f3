#include "catalogue/typed_place.h"

#include "catalogue/places.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

class TypedPlaces : public SmallProject {
 protected:
  std::optional<BagPlace> read(const std::string& text, Named what) {
    return valueIn(typedPlace(catalogue(), text, what));
  }
};

TEST_F(TypedPlaces, AreReadAsLabelsPrintThem) {
  for (const char* text : {"ARM1-T3-0012", "ARM1 T3 0012", " ARM1/T3/0012 ", "arm1 / t3 - 0012"})
    EXPECT_EQ(read(text, Named::Context), (BagPlace{"ARM1", "T3", "0012", ""})) << text;
  for (const char* text : {"ARM1-T3-0012-4", "ARM1 T3 0012 4", "arm1 / T3 / 0012 bag 4"})
    EXPECT_EQ(read(text, Named::Bag), (BagPlace{"ARM1", "T3", "0012", "4"})) << text;
  EXPECT_EQ(read("arm1-t3-0012-4B", Named::Bag), (BagPlace{"ARM1", "T3", "0012", "4B"}))
      << "a new bag is spelled as it was typed";
}

TEST_F(TypedPlaces, LeadOnlyToKnownContexts) {
  for (const char* text : {"", "ARM1-T3", "ARM1-T3-0099", "ARM2-T3-0012", "ARM1-T3-0012-4"})
    EXPECT_FALSE(read(text, Named::Context)) << text;
  for (const char* text : {"4", "ARM1-T3-0012", "ARM1-T3-0099-4", "ARM1-T3-0012-4-7"})
    EXPECT_FALSE(read(text, Named::Bag)) << text;
}

TEST_F(TypedPlaces, ThatDifferFromAKnownOneInZerosOnlyAreNamed) {
  const auto alike = [&](const BagPlace& place) {
    return valueIn(contextReadAlike(catalogue(), place));
  };
  EXPECT_EQ(alike({"ARM1", "T3", "12", ""}), "0012");
  EXPECT_EQ(alike({"arm1", "t3", "012", ""}), "0012");
  EXPECT_EQ(alike({"ARM1", "T3", "0012", ""}), "") << "it is that one";
  EXPECT_EQ(alike({"ARM1", "T3", "112", ""}), "");
  EXPECT_EQ(alike({"ARM1", "", "12", ""}), "") << "in the site itself";
}

TEST_F(TypedPlaces, MayHaveBlanksWithinTheirNames) {
  bag(context("K 12"), "1");
  context("K15");
  for (const char* text : {"ARM1-T3-K 12", "ARM1 T3 K12", "arm1 / t3 / k 12", "K12", "K 12"})
    EXPECT_EQ(read(text, Named::Context), (BagPlace{"ARM1", "T3", "K 12", ""})) << text;
  for (const char* text : {"ARM1-T3-K 12-1", "ARM1-K12-1", "K 12 bag 1", "k12-1"})
    EXPECT_EQ(read(text, Named::Bag), (BagPlace{"ARM1", "T3", "K 12", "1"})) << text;
  EXPECT_EQ(read("ARM1-K 15", Named::Context), (BagPlace{"ARM1", "T3", "K15", ""}));
  records::ContextRecord c;
  c.site = site;
  c.trench = trench;
  c.number = "k12";
  EXPECT_FALSE(Places(catalogue()).save(c, anna)) << "never two contexts";
}

TEST_F(TypedPlaces, MayHaveMarksInTheirCodes) {
  records::SiteRecord record;
  record.code = record.name = "AR-TS";
  const store::SiteRow other = *Places(catalogue()).save(record, anna);
  records::ContextRecord c;
  c.site = other;
  c.number = "7";
  const store::ContextRow context7 = *Places(catalogue()).save(c, anna);
  bag(context7, "a-4");
  EXPECT_EQ(read("ar-ts-7", Named::Context), (BagPlace{"AR-TS", "", "7", ""}));
  EXPECT_EQ(read("AR-TS-7-a-4", Named::Bag), (BagPlace{"AR-TS", "", "7", "a-4"}));
}

TEST_F(TypedPlaces, ANumberAloneLeadsToTheOnlyContextThatHasIt) {
  EXPECT_EQ(read("0013", Named::Context), (BagPlace{"ARM1", "T3", "0013", ""}));
  EXPECT_FALSE(read("0099", Named::Context));
  records::TrenchRecord t;
  t.site = site;
  t.code = "T4";
  records::ContextRecord c;
  c.site = site;
  c.trench = *Places(catalogue()).save(t, anna);
  c.number = "0013";
  ASSERT_TRUE(Places(catalogue()).save(c, anna));
  const auto two = typedPlace(catalogue(), "0013", Named::Context);
  ASSERT_FALSE(two);
  EXPECT_EQ(two.error().what.english(),
            "This can be ARM1 T3 0013 or ARM1 T4 0013; enter site, trench and context each by "
            "itself.");
  EXPECT_EQ(valueIn(typedPlace(catalogue(), "0013", Named::Context, {"", "t4", "", ""})),
            (BagPlace{"ARM1", "T4", "0013", ""}));
}

TEST_F(TypedPlaces, ThatReadAlikeAreAsked) {
  records::ContextRecord c;
  c.site = site;
  c.number = "T3-0012";
  ASSERT_TRUE(Places(catalogue()).save(c, anna));
  EXPECT_FALSE(typedPlace(catalogue(), "ARM1-T3-0012", Named::Context));
}

class WrittenPlaces : public SmallProject {
 protected:
  BagPlace read(const BagPlace& written) { return valueIn(readPlace(catalogue(), written)); }
  std::string why(const std::string& context) {
    const auto place = readPlace(catalogue(), {"", "", context, ""});
    return place ? "read" : place.error().what.english();
  }
};

TEST_F(WrittenPlaces, TakeTheOnlySiteAndTrench) {
  EXPECT_EQ(read({"", "", "0012", "4"}), (BagPlace{"ARM1", "T3", "0012", "4"}));
  EXPECT_EQ(read({"arm1", "", " 00 12 ", ""}), (BagPlace{"ARM1", "T3", "0012", ""}));
  EXPECT_EQ(read({"", "", "ARM1-T3-0012-4", ""}), (BagPlace{"ARM1", "T3", "0012", "4"}));
  EXPECT_EQ(read({"", "", "", "ARM1-0012-4"}), (BagPlace{"ARM1", "T3", "0012", "4"}));
  for (const char* text : {"K 12", "ARM1-K 12", "arm1-t3-K 12"})
    EXPECT_EQ(read({"", "", text, ""}), (BagPlace{"ARM1", "T3", "K 12", ""})) << text;
  EXPECT_EQ(read({"", "", "0012-3", ""}), (BagPlace{"ARM1", "T3", "0012-3", ""})) << "no new bag";
  EXPECT_EQ(read({"ARM1", "T3", "0099", ""}), (BagPlace{"ARM1", "T3", "0099", ""}));
}

TEST_F(WrittenPlaces, SayWhatIsMissing) {
  EXPECT_EQ(why("ARM1-T9-K12"),
            "There is no such trench in the site ARM1; write trench and context in columns of "
            "their own.");
  records::TrenchRecord t;
  t.site = site;
  t.code = "T4";
  ASSERT_TRUE(Places(catalogue()).save(t, anna));
  EXPECT_EQ(why("K 12"),
            "The site ARM1 has 2 trenches; add a column 'Trench', or write the context with its "
            "trench, such as ARM1-T3-K 12.");
  records::SiteRecord s;
  s.code = "KT26";
  ASSERT_TRUE(Places(catalogue()).save(s, anna));
  EXPECT_EQ(why("K 12"),
            "This project has 2 sites; add a column 'Site', or write the context with its site, "
            "such as ARM1-K 12.");
  EXPECT_EQ(read({"", "", "KT26-K 12", ""}), (BagPlace{"KT26", "", "K 12", ""}));
}

}  // namespace
}  // namespace ostraka::catalogue
