#include "catalogue/renamed_places.h"

#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "catalogue/label_codes.h"
#include "catalogue/settings.h"
#include "catalogue/typed_place.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RenamedPlaces : public SmallProject {
 protected:
  static PlaceId id(store::TrenchRow row) { return {PlaceKind::Trench, row.value}; }
  static PlaceId id(store::ContextRow row) { return {PlaceKind::Context, row.value}; }
  static PlaceId id(store::BagRow row) { return {PlaceKind::Bag, row.value}; }
  Renamed renamed(PlaceId place, const std::string& name) {
    return valueIn(rename(catalogue(), place, name, IfNameIsTaken::Join, anna));
  }
  void back(const Renamed& done) {
    const Result<void> undone = renameBack(catalogue(), done, anna);
    ASSERT_TRUE(undone) << undone.error().sentence();
  }
  std::vector<std::string> contextsNow() {
    std::vector<std::string> all;
    for (const records::ContextRecord& c : valueIn(Places(catalogue()).contexts()))
      all.push_back(c.trench_code + " " + c.number);
    return all;
  }
  std::vector<std::string> bagsIn(store::ContextRow row) {
    std::vector<std::string> all;
    for (const records::BagRecord& b : valueIn(Places(catalogue()).bags(row)))
      all.push_back(b.number + ": " + std::to_string(b.sherds));
    return all;
  }
  std::string placeOfSherd(store::SherdRow sherd) {
    return valueOf(sherd, "trench") + " " + valueOf(sherd, "context") + " " + valueOf(sherd, "bag");
  }
};

TEST_F(RenamedPlaces, KeepTheNumbersOfTheirSherdsAndGoOnBehindThem) {
  const store::SherdRow first = numbered(context12), second = numbered(context12);
  ASSERT_EQ(valueOf(second, "number"), "ARM1-T3-0012-0002");
  const Renaming would = valueIn(renamingOf(catalogue(), id(context12), " 0112 "));
  EXPECT_EQ(would.before, "0012");
  EXPECT_EQ(would.after, "0112");
  EXPECT_EQ(would.into, 0);
  EXPECT_EQ(would.bags, 2);
  EXPECT_EQ(would.sherds, 2);
  EXPECT_EQ(would.numbered, 2);
  const Renamed done = renamed(id(context12), "0112");
  EXPECT_EQ(valueOf(first, "number"), "ARM1-T3-0012-0001") << "it is inked";
  EXPECT_EQ(valueOf(first, "context"), "0112");
  EXPECT_EQ(valueOf(numbered(context12), "number"), "ARM1-T3-0112-0003");
  EXPECT_THAT(*sherds::Numbers(catalogue()).gaps(context12), IsEmpty()) << "1 and 2 are given";
  EXPECT_EQ(valueOf(numbered(context("0012")), "number"), "ARM1-T3-0012-0003") << "a new 0012";
  EXPECT_THAT(found("context:0112"),
              ElementsAre("ARM1-T3-0012-0001", "ARM1-T3-0012-0002", "ARM1-T3-0112-0003"));
  renamed(id(trench), "T4");
  EXPECT_EQ(valueOf(numbered(context12), "number"), "ARM1-T4-0112-0004");
  EXPECT_FALSE(renameBack(catalogue(), done, anna)) << "0012 is another by now";
}

TEST_F(RenamedPlaces, AreCalledAsBeforeAgain) {
  back(renamed(id(bag4), "14"));
  back(renamed(id(trench), "T8"));
  EXPECT_THAT(contextsNow(), ElementsAre("T3 0012", "T3 0013"));
  EXPECT_THAT(bagsIn(context12), ElementsAre("4: 0", "5: 0"));
  for (const std::string& name : {std::string("  "), std::string(201, '4')})
    EXPECT_FALSE(rename(catalogue(), id(bag4), name, IfNameIsTaken::Join, anna)) << name;
  EXPECT_FALSE(rename(catalogue(), id(bag4), "5", IfNameIsTaken::Refuse, anna));
  const Renamed done = renamed(id(bag4), "14");
  renamed(id(bag4), "15");
  EXPECT_FALSE(renameBack(catalogue(), done, anna)) << "it was renamed meanwhile";
}

TEST_F(RenamedPlaces, BecomeOneWithAllThatLiesInThem) {
  const store::BagRow other4 = bag(context13, "4");
  const store::BatchRow batch = newBatch({bag4, bag5, other4});
  const store::SherdRow in4 = draft(context12, bag4), in_other4 = draft(context13, other4),
                        in1 = draft(context13, bag1), loose = draft(context13);
  EXPECT_FALSE(rename(catalogue(), id(context13), "0012", IfNameIsTaken::Refuse, anna));
  const Renaming would = valueIn(renamingOf(catalogue(), id(context13), "0012"));
  EXPECT_EQ(would.into, context12.value);
  EXPECT_EQ(would.sherds, 3);
  EXPECT_EQ(would.bags, 2);
  EXPECT_EQ(would.batches, 1);
  const Renamed done = renamed(id(context13), "0012");
  EXPECT_THAT(contextsNow(), ElementsAre("T3 0012"));
  EXPECT_THAT(bagsIn(context12), ElementsAre("1: 1", "4: 2", "5: 0"));
  for (const store::SherdRow sherd : {in4, in_other4}) EXPECT_EQ(placeOfSherd(sherd), "T3 0012 4");
  EXPECT_EQ(placeOfSherd(in1), "T3 0012 1");
  EXPECT_EQ(placeOfSherd(loose), "T3 0012 ");
  EXPECT_THAT(Batches(catalogue()).get(batch)->bags, ElementsAre(bag4, bag5));
  EXPECT_EQ(Places(catalogue()).contextByPlace("ARM1", "T3", "0013")->value, 0);
  EXPECT_TRUE(catalogue().checkIntegrity());
  back(done);
  EXPECT_EQ(placeOfSherd(in_other4), "T3 0013 4");
  EXPECT_EQ(placeOfSherd(in4), "T3 0012 4");
  EXPECT_EQ(placeOfSherd(in1), "T3 0013 1");
  EXPECT_THAT(Batches(catalogue()).get(batch)->bags, ElementsAre(bag4, bag5, other4));
  EXPECT_THAT(contextsNow(), ElementsAre("T3 0012", "T3 0013"));
  EXPECT_TRUE(catalogue().checkIntegrity());
  EXPECT_EQ(History(catalogue()).of("context", context13.value)->size(), 3u)
      << "made, joined, parted";
}

TEST_F(RenamedPlaces, OfATrenchBringTheirContextsAndBags) {
  records::TrenchRecord t;
  t.site = site;
  t.code = "T03";
  const store::TrenchRow wrong = *Places(catalogue()).save(t, anna);
  records::ContextRecord c;
  c.site = site;
  c.trench = wrong;
  c.number = "0012";
  c.period = "LB I";
  const store::ContextRow same = *Places(catalogue()).save(c, anna);
  c.number = "0099";
  c.id.clear();
  const store::ContextRow own = *Places(catalogue()).save(c, anna);
  const store::BagRow same4 = bag(same, "4");
  const store::SherdRow first = draft(same, same4), second = draft(own);
  ASSERT_TRUE(sherds::Numbers(catalogue()).assign(std::vector{first}, anna));
  std::string id_of_bag;
  for (const records::BagRecord& one : valueIn(Places(catalogue()).bags(same)))
    for (const char letter : one.id)
      if (letter != '-') id_of_bag += letter;
  const LabelCode label =
      *readLabelCode("OST1:B:ARM1-T03-0012-4:" + id_of_bag.substr(id_of_bag.size() - 8));
  const Renamed done = renamed(id(wrong), "t3");
  EXPECT_THAT(contextsNow(), ElementsAre("T3 0012", "T3 0013", "T3 0099"));
  EXPECT_EQ(placeOfSherd(first), "T3 0012 4");
  EXPECT_EQ(placeOfSherd(second), "T3 0099 ");
  EXPECT_EQ(valueIn(Places(catalogue()).context(context12)).period, "LB I")
      << "it said nothing of its own";
  EXPECT_EQ(valueOf(numbered(context12), "number"), "ARM1-T3-0012-0002")
      << "behind ARM1-T03-0012-0001";
  EXPECT_EQ(**placeOfLabel(catalogue(), label), (BagPlace{"ARM1", "T3", "0012", "4"}));
  EXPECT_TRUE(catalogue().checkIntegrity());
  back(done);
  EXPECT_EQ(placeOfSherd(first), "T03 0012 4");
  EXPECT_EQ(placeOfSherd(second), "T03 0099 ");
  EXPECT_EQ(valueIn(Places(catalogue()).context(context12)).period, "");
}

TEST_F(RenamedPlaces, StayTogetherWhereTheirSherdsWereChangedMeanwhile) {
  const store::SherdRow sherd = draft(context13, bag1);
  const Renamed done = renamed(id(context13), "0012");
  ASSERT_TRUE(set(sherd, "bag", "5"));
  EXPECT_FALSE(renameBack(catalogue(), done, anna));
  EXPECT_EQ(placeOfSherd(sherd), "T3 0012 5");
  ASSERT_TRUE(set(sherd, "bag", "1"));
  back(done);
  EXPECT_EQ(placeOfSherd(sherd), "T3 0013 1");
}

TEST_F(RenamedPlaces, TakeWhatIsTypedInTheCaptureAlong) {
  Settings settings(catalogue());
  ASSERT_TRUE(settings.setValue(kCapturePlace, "ARM1-T3-0012-7"));
  const Renamed done = renamed(id(trench), "T4");
  EXPECT_EQ(*settings.value(kCapturePlace), "ARM1 T4 0012 7") << "a new bag";
  back(done);
  EXPECT_EQ(*settings.value(kCapturePlace), "ARM1 T3 0012 7");
  renamed(id(context12), "0013");
  EXPECT_EQ(*settings.value(kCapturePlace), "ARM1 T3 0013 7");
  renamed(id(bag4), "40");
  EXPECT_EQ(*settings.value(kCapturePlace), "ARM1 T3 0013 7");
}

}  // namespace
}  // namespace ostraka::catalogue
