#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using SherdsTest = catalogue::SmallProject;

TEST_F(SherdsTest, AreReadBackWithEverything) {
  records::SherdRecord s;
  s.number = "ARM1-T3-0012-0100";
  s.context = context12;
  s.bag = bag4;
  s.part = {"rim", "neck"};
  s.ware = "grey";
  s.surface_out = "burnished";
  s.munsell_out = "10YR 3/1";
  s.date_edtf = "-1149/-0799~";
  s.note = "found \"under\" the wall; Գառնի";
  s.measures["weight"] = 23.4;
  s.extra_json = R"({"drawer":"7"})";
  const Result<store::SherdRow> row = Sherds(catalogue()).add(s, anna);
  ASSERT_TRUE(row) << row.error().sentence();
  const records::SherdRecord read = *Sherds(catalogue()).get(*row);
  EXPECT_EQ(read.state, records::SherdState::Numbered);
  EXPECT_EQ(read.site + read.trench + read.context_number + read.bag_number, "ARM1T300124");
  EXPECT_THAT(read.part, ElementsAre("rim", "neck"));
  EXPECT_EQ(read.note, s.note);
  EXPECT_EQ(read.measures.at("weight"), 23.4);
  EXPECT_EQ(sherds::textOf(read, "extra.drawer"), "7");
  EXPECT_EQ(sherds::textOf(read, "part"), "rim; neck");
  EXPECT_EQ(sherds::textOf(read, "state"), "numbered");
  EXPECT_EQ(sherds::textOf(read, "uuid"), read.id);
  EXPECT_EQ(*Sherds(catalogue()).byNumber("arm1-t3-0012-0100"), *row);
  EXPECT_EQ(*Sherds(catalogue()).byId(read.id), *row);
  EXPECT_FALSE(*Sherds(catalogue()).byNumber("X"));
}

TEST_F(SherdsTest, APageComesInTheOrderAskedFor) {
  const store::SherdRow a = numbered(context12), b = numbered(context12), c = numbered(context12);
  const std::vector<store::SherdRow> order = {c, a, b, a};
  const std::vector<records::SherdRecord> page = *Sherds(catalogue()).of(order);
  ASSERT_EQ(page.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(page[i].row, order[i]);
  const std::vector<store::SherdRow> none = {store::SherdRow{999}};
  EXPECT_FALSE(Sherds(catalogue()).of(none));
}

TEST_F(SherdsTest, AUuidIsThereOnce) {
  records::SherdRecord s;
  s.context = context12;
  s.id = "019f5ff6-39c0-7b3a-9c55-2f7e8d104ab6";
  ASSERT_TRUE(Sherds(catalogue()).add(s, anna));
  EXPECT_FALSE(Sherds(catalogue()).add(s, anna));
  s.id = "not a uuid";
  EXPECT_FALSE(Sherds(catalogue()).add(s, anna));
}

TEST_F(SherdsTest, AVoidOneKeepsItsNumberAndComesBack) {
  const store::SherdRow sherd = numbered(context12);
  EXPECT_FALSE(Sherds(catalogue()).voidSherd(sherd, " ", anna)) << "a reason is needed";
  ASSERT_TRUE(Sherds(catalogue()).voidSherd(sherd, "a stone", anna));
  EXPECT_EQ(Sherds(catalogue()).get(sherd)->state, records::SherdState::Void);
  EXPECT_EQ(Sherds(catalogue()).get(sherd)->number, "ARM1-T3-0012-0001");
  EXPECT_FALSE(set(sherd, "number", "")) << "a void sherd keeps its number";
  ASSERT_TRUE(set(sherd, "void_reason", ""));
  EXPECT_EQ(Sherds(catalogue()).get(sherd)->state, records::SherdState::Numbered);
}

TEST_F(SherdsTest, JoinsGoBothWays) {
  const store::SherdRow a = numbered(context12), b = numbered(context12), c = numbered(context12);
  ASSERT_TRUE(set(a, "joins", "ARM1-T3-0012-0003; arm1-t3-0012-0002"));
  EXPECT_THAT(Sherds(catalogue()).get(a)->joins, ElementsAre(b, c));
  EXPECT_THAT(Sherds(catalogue()).get(b)->joins, ElementsAre(a));
  EXPECT_EQ(valueOf(c, "joins"), "ARM1-T3-0012-0001");
  ASSERT_TRUE(set(c, "joins", ""));
  EXPECT_THAT(Sherds(catalogue()).get(a)->joins, ElementsAre(b));
  EXPECT_FALSE(set(a, "joins", "ARM1-T3-0012-0001")) << "not itself";
  EXPECT_FALSE(set(a, "joins", "ARM1-T3-0012-0009"));
}

TEST_F(SherdsTest, CustomFieldsAreThoseThatAnySherdHas) {
  const store::SherdRow a = numbered(context12), b = numbered(context12);
  EXPECT_THAT(*Sherds(catalogue()).customFields(), IsEmpty());
  ASSERT_TRUE(set(a, "extra.shelf", "4"));
  ASSERT_TRUE(set(b, "extra.shelf", "5"));
  ASSERT_TRUE(set(b, "extra.glaze", "lead"));
  EXPECT_THAT(*Sherds(catalogue()).customFields(), ElementsAre("extra.glaze", "extra.shelf"));
  ASSERT_TRUE(set(b, "extra.glaze", ""));
  EXPECT_THAT(*Sherds(catalogue()).customFields(), ElementsAre("extra.shelf"));
}

TEST_F(SherdsTest, HistoryTellsWhoChangedWhatAndWhy) {
  const store::SherdRow sherd = numbered(context12);
  const records::FieldChange change{sherd, "ware", "grey"};
  ASSERT_TRUE(SherdChanges(catalogue())
                  .apply(std::span(&change, 1), {anna.person, "window", "seen again"}));
  const records::HistoryEntry newest = catalogue::History(catalogue()).of(sherd)->front();
  EXPECT_EQ(newest.by, anna.person);
  EXPECT_EQ(newest.field, "ware");
  EXPECT_EQ(newest.old_value, "");
  EXPECT_EQ(newest.new_value, "grey");
  EXPECT_EQ(newest.why, "seen again");
  EXPECT_EQ(newest.source, "window");
  store::Statement row =
      catalogue().database().sql("SELECT updated_at FROM sherd WHERE row = ?", sherd);
  std::int64_t updated_ms = 0;
  ASSERT_TRUE(row.next());
  row >> updated_ms;
  EXPECT_EQ(newest.at_ms, updated_ms - 1) << "of the same provenance";
}

}  // namespace
}  // namespace ostraka::sherds
