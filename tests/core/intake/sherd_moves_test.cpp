#include "intake/sherd_moves.h"

#include <gmock/gmock.h>

#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Moves : public catalogue::SmallProject {
 protected:
  Moves() {
    first = draft(context12, bag4);
    second = draft(context12, bag5);
    EXPECT_TRUE(sherds::Numbers(catalogue()).assign(std::vector{first, second}, anna));
  }
  Move move(const std::vector<records::FieldChange>& wanted) {
    return catalogue::valueIn(moveOf(catalogue(), wanted));
  }

  store::SherdRow first, second;
};

TEST_F(Moves, LeaveTheBagsOfTheOldContextAndUndoBringsThemBack) {
  const Move both = move({{first, "context", "0013"}, {second, "context", "0013"}});
  EXPECT_EQ(both.without_bag, 2);
  EXPECT_THAT(both.lacking, ElementsAre(catalogue::BagPlace{"ARM1", "T3", "0013", "4"},
                                        catalogue::BagPlace{"ARM1", "T3", "0013", "5"}));
  EXPECT_THAT(both.numbers, ElementsAre("ARM1-T3-0012-0001", "ARM1-T3-0012-0002"));
  const Result<std::vector<records::FieldChange>> undo =
      sherds::SherdChanges(catalogue()).apply(both.changes, anna);
  ASSERT_TRUE(undo) << undo.error().sentence();
  EXPECT_EQ(valueOf(first, "context"), "0013");
  EXPECT_EQ(valueOf(first, "bag"), "");
  EXPECT_EQ(valueOf(second, "bag"), "");
  ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(*undo, anna));
  EXPECT_EQ(valueOf(first, "context"), "0012");
  EXPECT_EQ(valueOf(first, "bag"), "4");
  EXPECT_EQ(valueOf(second, "bag"), "5");
}

TEST_F(Moves, IntoABagOfTheNewContextEmptyNone) {
  const Move named = move({{first, "context", "0013"}, {first, "bag", "1"}});
  EXPECT_EQ(named.changes.size(), 2u);
  EXPECT_EQ(named.without_bag, 0);
  EXPECT_THAT(named.numbers, ElementsAre("ARM1-T3-0012-0001"));
}

TEST_F(Moves, KeepTheBagWhereTheNewContextHasOneOfItsNumber) {
  bag(context13, "4");
  const Move both = move({{first, "context", "0013"}, {second, "context", "0013"}});
  EXPECT_EQ(both.without_bag, 1);
  EXPECT_THAT(both.lacking, ElementsAre(catalogue::BagPlace{"ARM1", "T3", "0013", "5"}));
  const auto undo = sherds::SherdChanges(catalogue()).apply(both.changes, anna);
  ASSERT_TRUE(undo) << undo.error().sentence();
  EXPECT_EQ(valueOf(first, "context") + " " + valueOf(first, "bag"), "0013 4");
  EXPECT_EQ(valueOf(second, "context") + " " + valueOf(second, "bag"), "0013 ");
  const auto bag4_now = sherds::Sherds(catalogue()).get(first)->bag;
  EXPECT_NE(bag4_now, bag4) << "of the new context";
  ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(*undo, anna));
  EXPECT_EQ(sherds::Sherds(catalogue()).get(first)->bag, bag4);
  EXPECT_EQ(valueOf(second, "context") + " " + valueOf(second, "bag"), "0012 5");
}

TEST_F(Moves, ThatAreNoneOrAreRefusedLeaveNothing) {
  for (const char* context : {"0012", "0099", ""}) {
    const Move none = move({{first, "context", context}});
    EXPECT_EQ(none.changes.size(), 1u) << context;
    EXPECT_EQ(none.without_bag, 0) << context;
    EXPECT_THAT(none.numbers, IsEmpty()) << context;
  }
  EXPECT_EQ(move({{draft(context12, bag4), "context", ""}}).without_bag, 1) << "a draft may";
}

TEST_F(Moves, ByWholeNamesBringAllCodes) {
  records::SiteRecord record;
  record.code = record.name = "KT26";
  records::ContextRecord c;
  c.site = *catalogue::Places(catalogue()).save(record, anna);
  c.number = "7";
  const store::ContextRow seven = *catalogue::Places(catalogue()).save(c, anna);
  bag(seven, "2");
  const auto placeOf = [&](store::SherdRow sherd) {
    return valueOf(sherd, "site") + "|" + valueOf(sherd, "trench") + "|" +
           valueOf(sherd, "context") + "|" + valueOf(sherd, "bag");
  };
  const std::vector<std::pair<records::FieldChange, std::string>> typed = {
      {{first, "context", "KT26-7"}, "KT26||7|"},
      {{first, "context", "KT26 7 2"}, "KT26||7|2"},
      {{first, "bag", "kt26/7/2"}, "KT26||7|2"},
      {{first, "context", "ARM1-T3-0013"}, "ARM1|T3|0013|"},
      {{draft({}), "context", "KT26-7"}, "KT26||7|"},
      {{draft({}), "context", "0013"}, "ARM1|T3|0013|"}};
  for (const auto& [change, place] : typed) {
    const std::string before = placeOf(change.sherd);
    const Move whole = move({change});
    EXPECT_EQ(whole.changes.front().field, change.field);
    const auto undo = sherds::SherdChanges(catalogue()).apply(whole.changes, anna);
    ASSERT_TRUE(undo) << change.value << ": " << undo.error().sentence();
    EXPECT_EQ(placeOf(change.sherd), place) << change.value;
    ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(*undo, anna)) << change.value;
    EXPECT_EQ(placeOf(change.sherd), before) << change.value;
  }
}

TEST_F(Moves, OutOfEveryPlaceCanBeUndone) {
  const store::SherdRow third = draft(context12, bag4);
  const auto undo =
      sherds::SherdChanges(catalogue()).apply(move({{third, "context", ""}}).changes, anna);
  ASSERT_TRUE(undo) << undo.error().sentence();
  EXPECT_EQ(valueOf(third, "site"), "");
  ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(*undo, anna));
  EXPECT_EQ(valueOf(third, "context") + " " + valueOf(third, "bag"), "0012 4");
}

TEST_F(Moves, TellNoNumbersWhereTheSchemeNamesNoContext) {
  records::ProjectRecord project = *catalogue::Settings(catalogue()).project();
  project.numbering = "{site}-{n}";
  ASSERT_TRUE(catalogue::Settings(catalogue()).setProject(project, anna));
  const store::SherdRow third = numbered(context12);
  EXPECT_THAT(move({{third, "context", "0013"}}).numbers, IsEmpty());
}

}  // namespace
}  // namespace ostraka::intake
