#include "catalogue/label_codes.h"

#include "catalogue/places.h"
#include "small_project.h"
#include "store/names.h"

namespace ostraka::catalogue {
namespace {

using LabelCodes = SmallProject;

TEST(LabelCode, IsReadFromBehind) {
  const auto label = readLabelCode(" OST1:S:12:7:9F3A77C1 ");
  ASSERT_TRUE(label);
  EXPECT_EQ(label->number, "12:7");
  EXPECT_EQ(label->id_end, "9f3a77c1");
  EXPECT_EQ(readLabelCode("ost1:b:arm1-4:9f3a77c1")->of, LabelCode::Of::Bag);
  EXPECT_TRUE(readLabelCode("OST1:S:B0031-01")->isPlaceOnPlate());
  EXPECT_TRUE(readLabelCode("OST1:S:B0031-01:9F3A77C1")->isPlaceOnPlate());
  EXPECT_FALSE(readLabelCode("OST1:S:B-1:9F3A77C1")->isPlaceOnPlate());
  for (const char* half : {"", "ARM1", "OST1:S:", "OST1:S:ARM1", "OST1:S:ARM1:9F3A",
                           "OST1:B:ARM1-4", "OST1:X:ARM1:9F3A77C1", "OST1:S::9F3A77C1"})
    EXPECT_FALSE(readLabelCode(half)) << half;
}

TEST_F(LabelCodes, LeadABagBackToItsPlaceWhateverItsCodesAreByNow) {
  const records::BagRecord bag = Places(catalogue()).bags(context12)->front();
  const std::string end = bag.id.substr(bag.id.size() - 8);
  const BagPlace place{"ARM1", "T3", "0012", "4"};
  EXPECT_EQ(*placeOfLabel(catalogue(), *readLabelCode("OST1:B:OLD-T3-0012-4:" + end)), place);
  EXPECT_FALSE(*placeOfLabel(catalogue(), *readLabelCode("OST1:B:ARM1-T3-0012-4:00000000")))
      << "of another project";
}

TEST_F(LabelCodes, ABatchIsWhereAllOfItsSherdsAreByNow) {
  records::BatchRecord record;
  record.bags = {bag4};
  const store::BatchRow row = *Batches(catalogue()).add(record, anna);
  std::vector<store::SherdRow> sherds;
  for (int i = 0; i < 2; ++i) {
    records::SherdRecord sherd;
    sherd.batch = row;
    sherd.context = context12;
    sherd.bag = bag4;
    sherds.push_back(*sherds::Sherds(catalogue()).add(sherd, anna));
  }
  const auto place = [&] {
    return *valueIn(placeOf(catalogue(), Batches(catalogue()).all()->front()));
  };
  const auto move = [&](store::SherdRow sherd, const std::string& context, const std::string& bag) {
    const std::vector<records::FieldChange> changes = {{sherd, "context", context},
                                                       {sherd, "bag", bag}};
    const auto moved = sherds::SherdChanges(catalogue()).apply(changes, anna);
    EXPECT_TRUE(moved) << (moved ? "" : moved.error().sentence().english());
  };
  EXPECT_EQ(place(), (BagPlace{"ARM1", "T3", "0012", "4"}));
  move(sherds[0], "0013", "");
  EXPECT_EQ(place(), (BagPlace{"ARM1", "T3", "0012", "4"})) << "one is still there";
  move(sherds[1], "0013", "");
  EXPECT_EQ(place(), (BagPlace{"ARM1", "T3", "0013", ""}));
  for (const store::SherdRow sherd : sherds) move(sherd, "0013", "1");
  EXPECT_EQ(place(), (BagPlace{"ARM1", "T3", "0013", "1"}));
}

TEST_F(LabelCodes, ABagIsMadeOnceInAnyCapitals) {
  EXPECT_EQ(*bagAt(catalogue(), {"ARM1", "T3", "0012", "4"}, anna), bag4);
  EXPECT_EQ(*bagAt(catalogue(), {" arm1", "t3 ", "0012", "4"}, anna), bag4);
  const store::BagRow fresh = *bagAt(catalogue(), {"arm1", "t3", "0012", "4b"}, anna);
  EXPECT_EQ(*bagAt(catalogue(), {"ARM1", "T3", "0012", "4B"}, anna), fresh);
  const store::BagRow elsewhere = *bagAt(catalogue(), {"Hayk1", "", "7", "1"}, anna);
  EXPECT_EQ(*bagAt(catalogue(), {"HAYK1", "", "7", "1"}, anna), elsewhere);
  EXPECT_EQ(Places(catalogue()).sites()->size(), 2u);
  EXPECT_FALSE(bagAt(catalogue(), {"NEW", "", "7", ""}, anna));
  EXPECT_EQ(Places(catalogue()).sites()->size(), 2u) << "nothing of what is refused stays";
}

}  // namespace
}  // namespace ostraka::catalogue
