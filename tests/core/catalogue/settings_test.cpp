#include "catalogue/settings.h"

#include "catalogue/history.h"
#include "catalogue/typed_place.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

// A project whose site has the project's code, as one that was made for photographs.
class SettingsTest : public SmallProject {
 protected:
  SettingsTest() {
    records::ProjectRecord record = *settings.project();
    record.code = "ARM1";
    record.title = "Hill";
    if (!settings.setProject(record, anna)) throw std::runtime_error("not set");
  }
  records::SiteRecord onlySite() { return Places(catalogue()).sites()->front(); }
  Settings settings{catalogue()};
};

TEST_F(SettingsTest, ARenamedProjectTakesItsSiteAlongAndLeavesTheNumbersThatWereGiven) {
  const store::SherdRow first = numbered(context12);
  ASSERT_TRUE(settings.rename("Grabung Nord", "GRB", anna));
  EXPECT_EQ(settings.project()->title, "Grabung Nord");
  EXPECT_EQ(settings.project()->code, "GRB");
  EXPECT_EQ(onlySite().code, "GRB");
  EXPECT_EQ(onlySite().name, "Grabung Nord");
  EXPECT_EQ(valueOf(first, "number"), "ARM1-T3-0012-0001");
  EXPECT_EQ(valueOf(numbered(context12), "number").substr(0, 12), "GRB-T3-0012-");
  const auto history = *History(catalogue()).of("site", site.value);
  ASSERT_FALSE(history.empty());
  EXPECT_EQ(history.front().by, anna.person);
}

TEST_F(SettingsTest, ThePlaceTypedLastForABatchFollowsTheSitesNewCode) {
  records::SiteRecord other;
  other.code = "ARM1-N";
  ASSERT_TRUE(Places(catalogue()).save(other, anna));
  const BagPlace there{"ARM1-N", "T3", "0012", "1"};
  ASSERT_TRUE(bagAt(catalogue(), there, anna));
  const auto after = [&](const std::string& typed) {
    return placeOfRenamedSite(catalogue(), typed, "ARM1", "GRB");
  };
  EXPECT_EQ(after("ARM1"), "GRB");
  EXPECT_EQ(after("arm 1 / T9 / new"), "GRB / T9 / new") << "not in the catalogue yet";
  for (const char* stays : {"", "T3-0012-4", "ARM12-T3-0012-4", "ARM1-N-T3-0012-1"})
    EXPECT_EQ(after(stays), stays);
  ASSERT_TRUE(settings.setValue(kCapturePlace, "ARM1-T3-0012-4"));
  ASSERT_TRUE(settings.rename("Grabung Nord", "GRB", anna));
  EXPECT_EQ(*settings.value(kCapturePlace), "GRB-T3-0012-4");
}

TEST_F(SettingsTest, ASiteNameThatAPersonTypedStays) {
  records::SiteRecord named = onlySite();
  named.name = "Tell";
  ASSERT_TRUE(Places(catalogue()).save(named, anna));
  ASSERT_TRUE(settings.rename("", "GRB", anna));
  EXPECT_EQ(settings.project()->title, "GRB") << "no title is the code";
  EXPECT_EQ(onlySite().name, "Tell");
}

TEST_F(SettingsTest, TheCodeOfAnotherSiteIsRefusedAndNothingIsChanged) {
  records::SiteRecord other;
  other.code = "GRB";
  ASSERT_TRUE(Places(catalogue()).save(other, anna));
  EXPECT_FALSE(settings.rename("Grabung Nord", "GRB", anna));
  EXPECT_FALSE(settings.rename("Grabung Nord", "a code", anna));
  EXPECT_EQ(settings.project()->title, "Hill");
  EXPECT_EQ(settings.project()->code, "ARM1");
}

TEST_F(SettingsTest, TexturesAreAsPhotographedUntilAPersonWantsThemWithoutTheLight) {
  EXPECT_FALSE(*settings.texturesWithoutLight());
  ASSERT_TRUE(settings.setTexturesWithoutLight(true, anna));
  EXPECT_TRUE(*settings.texturesWithoutLight());
  ASSERT_TRUE(settings.setTexturesWithoutLight(false, anna));
  EXPECT_FALSE(*settings.texturesWithoutLight());
}

}  // namespace
}  // namespace ostraka::catalogue
