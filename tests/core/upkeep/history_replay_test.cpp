// What a repair takes from the history where a page held more than the backup has.
#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "tests/core/upkeep/repaired_project.h"

namespace ostraka::upkeep {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

using RepairHistory = RepairedProject;

TEST_F(RepairHistory, TellsJoinsThatAreNewerThanTheBackup) {
  const store::SherdRow a = numbered(context12), b = numbered(context12), c = numbered(context12),
                        d = numbered(context12);
  ASSERT_TRUE(set(a, "joins", numberOf(d)));
  ASSERT_TRUE(set(b, "joins", numberOf(d)));
  ASSERT_TRUE(project_->backUp());
  ASSERT_TRUE(set(a, "joins", numberOf(b)));
  ASSERT_TRUE(set(c, "joins", numberOf(b)));
  const std::string joins = valueOf(b, "joins");
  const std::vector<std::string> words = repairedWithout("sherd_join");
  EXPECT_THAT(words, Contains("sherd_join: not restored")) << "it may have held others";
  EXPECT_THAT(words, Contains("sherd 1 (ARM1-T3-0012-0001), joins: from the history"));
  EXPECT_EQ(valueOf(a, "joins"), numberOf(b));
  EXPECT_EQ(valueOf(b, "joins"), joins) << "to a, c and, as the backup has it, d";
  EXPECT_EQ(valueOf(c, "joins"), numberOf(b));
  EXPECT_EQ(valueOf(d, "joins"), numberOf(b)) << "a was parted from it since";
}

TEST_F(RepairHistory, TellsBagsOfABatchThatAreNewerThanTheBackup) {
  const store::BatchRow row = newBatch({bag4});
  ASSERT_TRUE(project_->backUp());
  records::BatchRecord batch = *catalogue::Batches(catalogue()).get(row);
  batch.bags = {bag1, bag5};
  ASSERT_TRUE(catalogue::Batches(catalogue()).save(batch, anna));
  const std::vector<std::string> words = repairedWithout("batch_bag");
  EXPECT_THAT(words, Contains("batch_bag: not restored")) << "of a batch that is newer, too";
  EXPECT_THAT(words, Contains("batch 1 (B0001), bags: from the history"));
  EXPECT_THAT(catalogue::Batches(catalogue()).get(row)->bags, ElementsAre(bag1, bag5));
}

TEST_F(RepairHistory, TellsTermsThatAreNewerThanTheBackup) {
  const auto terms = [this] {
    std::vector<std::string> all;
    for (const records::Term& term :
         catalogue::valueIn(catalogue::Settings(catalogue()).vocabulary("part")))
      all.push_back(term.term);
    return all;
  };
  ASSERT_TRUE(project_->backUp());
  std::vector<records::Term> changed = *catalogue::Settings(catalogue()).vocabulary("part");
  changed.erase(changed.begin());
  changed.insert(changed.begin() + 1, {"spout tip", {{"de", "Tülle"}}, "https://example.org/1"});
  changed.back().labels["tr"] = "kulp}";
  ASSERT_TRUE(catalogue::Settings(catalogue()).setVocabulary("part", changed, anna));
  const std::vector<std::string> before = terms();
  const std::vector<std::string> words = repairedWithout("vocabulary");
  EXPECT_THAT(words, Contains("vocabulary: not restored")) << "it may have held others";
  EXPECT_THAT(words, Contains("vocabulary (part): from the history"));
  EXPECT_EQ(terms(), before);
  EXPECT_EQ(catalogue::valueIn(catalogue::Settings(catalogue()).vocabulary("part")), changed);
}

TEST_F(RepairHistory, NamesTheTableOfSettingsThatAreLost) {
  ASSERT_TRUE(project_->backUp());
  ASSERT_TRUE(catalogue::Settings(catalogue()).setValue("unit.weight", "g"));
  EXPECT_THAT(repairedWithout("setting"), Contains("setting: not restored"));
}

TEST_F(RepairHistory, TellsWhatAPersonSetSinceTheBackup) {
  catalogue::Settings settings(catalogue());
  ASSERT_TRUE(settings.setValue("numbering.first", "1", anna));
  ASSERT_TRUE(project_->backUp());
  ASSERT_TRUE(settings.setValue("numbering.first", "5001", anna));
  ASSERT_TRUE(settings.setValue("numbering.last", "5002", anna));
  const std::vector<std::string> words = repairedWithout("setting");
  EXPECT_THAT(words, Contains("setting (numbering.last): from the history"));
  const catalogue::Settings repaired(catalogue());
  EXPECT_EQ(catalogue::valueIn(repaired.value("numbering.first")), "5001");
  EXPECT_EQ(catalogue::valueIn(repaired.value("numbering.last")), "5002");
}

TEST_F(RepairHistory, TellsTheBagsThatABatchWasBegunWith) {
  ASSERT_TRUE(project_->backUp());
  const store::BatchRow row = newBatch({bag5, bag1});
  EXPECT_THAT(repairedWithout("batch_bag"), Contains("batch 1 (B0001), bags: from the history"));
  EXPECT_THAT(catalogue::Batches(catalogue()).get(row)->bags, ElementsAre(bag5, bag1));
}

}  // namespace
}  // namespace ostraka::upkeep
