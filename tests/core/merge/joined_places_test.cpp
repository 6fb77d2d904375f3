#include "merge/joined_places.h"

#include <gmock/gmock.h>

#include <functional>
#include <random>
#include <set>

#include "catalogue/label_codes.h"
#include "catalogue/renamed_places.h"
#include "two_houses.h"

namespace ostraka::merge {
namespace {

using namespace catalogue;
using testing::ElementsAre;
using testing::IsEmpty;

class JoinedInOneHouse : public TwoCopies {
 protected:
  Renamed called(upkeep::Project& project, PlaceKind kind, std::int64_t row,
                 const std::string& name) {
    return valueIn(rename(project.catalogue(), {kind, row}, name, IfNameIsTaken::Join, anna));
  }
  Renamed called(upkeep::Project& project, store::ContextRow row, const std::string& name) {
    return called(project, PlaceKind::Context, row.value, name);
  }
  store::BagRow newBag(upkeep::Project& project, store::ContextRow in, const std::string& number) {
    return valueIn(Places(project.catalogue()).bagAt(in, number, anna));
  }
  store::SherdRow newSherdIn(upkeep::Project& project, store::ContextRow in, store::BagRow bag) {
    records::SherdRecord sherd;
    sherd.context = in;
    sherd.bag = bag;
    return valueIn(sherds::Sherds(project.catalogue()).add(sherd, anna));
  }
  // Where each sherd is, by its uuid, and what contexts and bags there are.
  static std::set<std::string> seen(const upkeep::Project& project) {
    std::set<std::string> lines;
    const Catalogue& catalogue = project.catalogue();
    const sherds::Sherds all(catalogue);
    for (const records::SherdRecord& s : valueIn(all.of(valueIn(all.rows(sherds::Filter{}, {})))))
      lines.insert(s.id + ": " + s.trench + " " + s.context_number + " " + s.bag_number);
    for (const records::ContextRecord& c : valueIn(Places(catalogue).contexts())) {
      lines.insert("context " + c.trench_code + " " + c.number + " " + c.period);
      for (const records::BagRecord& b : valueIn(Places(catalogue).bags(c.row)))
        lines.insert("bag " + c.number + " " + b.number + " " + std::to_string(b.sherds));
    }
    for (const records::BatchRecord& record : valueIn(Batches(catalogue).all()))
      for (const store::BagRow bag : record.bags) {
        const auto place = valueIn(placeOf(catalogue, bag));
        lines.insert("batch " + record.id + " " + place->context + " " + place->bag);
      }
    return lines;
  }
  void mergedWithoutQuestion(upkeep::Project& into, const upkeep::Project& from) {
    const MergeReport report = merged(into, from);
    EXPECT_THAT(openIn(report), IsEmpty());
    EXPECT_TRUE(report.entered);
    EXPECT_TRUE(into.catalogue().checkIntegrity());
  }
  // Either order, and each once more: the same project.
  void expectSame() {
    upkeep::Project& a = *project_;
    mergedWithoutQuestion(a, b_);
    const std::set<std::string> there = seen(a);
    mergedWithoutQuestion(b_, a);
    EXPECT_EQ(seen(b_), there);
    const std::string content = contentIn(a), content_b = contentIn(b_);
    mergedWithoutQuestion(a, b_);
    mergedWithoutQuestion(b_, a);
    EXPECT_EQ(contentIn(a), content) << "merging once more changes nothing";
    EXPECT_EQ(contentIn(b_), content_b);
  }
};

TEST_F(JoinedInOneHouse, StayOnePlaceWhateverTheOtherHouseAdds) {
  const store::BagRow new4 = newBag(b_, context13, "4");  // 0012 has a bag 4
  const std::string in_new4 =
      valueIn(sherds::Sherds(b_.catalogue()).get(newSherdIn(b_, context13, new4))).id;
  const std::string in_new9 =
      valueIn(
          sherds::Sherds(b_.catalogue()).get(newSherdIn(b_, context13, newBag(b_, context13, "9"))))
          .id;
  records::BatchRecord record;
  record.bags = {new4};
  ASSERT_TRUE(Batches(b_.catalogue()).add(record, anna));
  called(*project_, context13, "0012");
  expectSame();
  EXPECT_EQ(saidOf(*project_, in_new4, "context") + saidOf(*project_, in_new4, "bag"), "00124");
  EXPECT_EQ(saidOf(b_, in_new9, "context") + saidOf(b_, in_new9, "bag"), "00129");
  EXPECT_EQ(seen(b_).count("context T3 0013 "), 0u);
}

TEST_F(JoinedInOneHouse, TakeNoSherdBackThatTheOtherHouseMovedElsewhere) {
  const store::SherdRow sherd = newSherd(*project_, context13, false);
  const std::string id = idOf(sherd);
  merged(b_, *project_);
  const store::ContextRow fresh =
      valueIn(Places(b_.catalogue()).contextByPlace("ARM1", "T3", "0012"));
  ASSERT_TRUE(fresh);
  records::ContextRecord c = valueIn(Places(b_.catalogue()).context(fresh));
  c.row = {};
  c.id.clear();
  c.number = "0077";
  ASSERT_TRUE(Places(b_.catalogue()).save(c, anna));
  say(b_, valueIn(sherds::Sherds(b_.catalogue()).byId(id)), "context", "0077");
  called(*project_, context13, "0012");
  expectSame();
  EXPECT_EQ(saidOf(*project_, id, "context"), "0077");
}

TEST_F(JoinedInOneHouse, WithAPlaceThatTheOtherDoesNotHave) {
  records::ContextRecord c = valueIn(Places(catalogue()).context(context13));
  c.row = {};
  c.id.clear();
  c.number = "0113";
  const store::ContextRow right = valueIn(Places(catalogue()).save(c, anna));
  called(*project_, context13, "0113");
  called(*project_, right, "113");
  expectSame();
  EXPECT_EQ(seen(b_).count("context T3 113 "), 1u);
  EXPECT_EQ(seen(b_).count("context T3 0013 "), 0u);
}

TEST_F(JoinedInOneHouse, AndUndoneIsAsIfItHadNotBeen) {
  const std::string sherd = idOf(newSherdIn(*project_, context13, bag1));
  const std::set<std::string> before = seen(*project_);
  const Renamed done = called(*project_, context13, "0012");
  ASSERT_TRUE(renameBack(catalogue(), done, anna));
  EXPECT_EQ(seen(*project_), before);
  expectSame();
  EXPECT_EQ(seen(b_), before);
}

TEST_F(JoinedInOneHouse, EachWayRoundEndsAsOnePlace) {
  called(*project_, context13, "0012");
  called(b_, context12, "0013");
  mergedWithoutQuestion(*project_, b_);
  mergedWithoutQuestion(b_, *project_);
  EXPECT_EQ(seen(*project_), seen(b_));
  EXPECT_EQ(Places(catalogue()).contexts()->size(), 1u);
}

TEST_F(JoinedInOneHouse, RenamedPlacesThatSwapNamesKeepTheirSherds) {
  const std::string in12 = idOf(newSherd(*project_, context12, false)),
                    in13 = idOf(newSherd(*project_, context13, false));
  merged(b_, *project_);
  called(*project_, context12, "0050");
  called(*project_, context13, "0012");
  called(*project_, context12, "0013");
  expectSame();
  EXPECT_EQ(saidOf(b_, in12, "context"), "0013");
  EXPECT_EQ(saidOf(b_, in13, "context"), "0012");
}

TEST_F(JoinedInOneHouse, TwoThatGetOneNameAreOne) {
  called(*project_, context12, "0014");
  called(b_, context13, "0014");
  expectSame();
  EXPECT_EQ(Places(catalogue()).contexts()->size(), 1u);
  EXPECT_EQ(Places(b_.catalogue()).contexts()->size(), 1u);
}

class JoinedInAnyOrder : public JoinedInOneHouse, public testing::WithParamInterface<unsigned> {};

// Three houses: one joins, the others go on working in the place that is no more.
TEST_P(JoinedInAnyOrder, EndAsTheSameProject) {
  std::mt19937_64 random(GetParam());
  upkeep::Project c = copied("c");
  std::vector<upkeep::Project*> projects = {&*project_, &b_, &c};
  for (std::size_t i = 0; i < 3; ++i) {
    upkeep::Project& project = *projects[i];
    for (std::uint64_t n = 1 + random() % 4; n > 0; --n) {
      const store::ContextRow in = random() % 2 == 0 ? context12 : context13;
      newSherdIn(project, in, newBag(project, in, std::to_string(1 + random() % 6)));
    }
  }
  switch (random() % 3) {
    case 0:
      called(*project_, context13, "0012");
      break;
    case 1:
      called(b_, context12, "0013");
      break;
    default:
      called(*project_, context13, "0012");
      called(c, PlaceKind::Bag, bag4.value, "5");
  }
  const auto once = [&](std::size_t into, std::size_t from) {
    mergedWithoutQuestion(*projects[into], *projects[from]);
  };
  for (int i = 0; i < 4; ++i) {
    const std::size_t into = random() % 3;
    once(into, (into + 1 + random() % 2) % 3);
  }
  const std::vector<std::pair<std::size_t, std::size_t>> all_pairs = {{0, 1}, {0, 2}, {1, 0},
                                                                      {2, 0}, {1, 2}, {2, 1}};
  for (const auto& [into, from] : all_pairs) once(into, from);
  EXPECT_EQ(seen(b_), seen(*project_));
  EXPECT_EQ(seen(c), seen(*project_));
  EXPECT_EQ(Places(catalogue()).contexts()->size(), 1u);
  for (const auto& [into, from] : all_pairs) {
    const std::string before = contentIn(*projects[into]);
    once(into, from);
    EXPECT_EQ(contentIn(*projects[into]), before) << "merging once more changes nothing";
  }
}

INSTANTIATE_TEST_SUITE_P(AnyOrder, JoinedInAnyOrder, testing::Range(1u, 5u));

}  // namespace
}  // namespace ostraka::merge
