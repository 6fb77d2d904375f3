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
  for (const char* text : {"", "0012", "ARM1-T3", "ARM1-T3-0099", "ARM2-T3-0012", "ARM1-T3-0012-4"})
    EXPECT_FALSE(read(text, Named::Context)) << text;
  for (const char* text : {"4", "ARM1-T3-0012", "ARM1-T3-0099-4", "ARM1-T3-0012-4-7"})
    EXPECT_FALSE(read(text, Named::Bag)) << text;
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
  EXPECT_EQ(*onlyContext(catalogue(), "0013"), context13);
  EXPECT_FALSE(*onlyContext(catalogue(), "0099"));
  records::ContextRecord c;
  c.site = site;
  c.number = "0013";
  ASSERT_TRUE(Places(catalogue()).save(c, anna));
  EXPECT_FALSE(*onlyContext(catalogue(), "0013")) << "another outside the trench";
}

}  // namespace
}  // namespace ostraka::catalogue
