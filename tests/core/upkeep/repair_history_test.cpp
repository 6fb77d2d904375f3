// What a repair takes from the history where a page held more than the backup has.
#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "sherds/measurements.h"
#include "store/database.h"
#include "store/page_checksums.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"
#include "upkeep/repair.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

class RepairHistory : public catalogue::SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
  // All of a small table lies on its first page. The words of the rows; the project is open again.
  std::vector<std::string> repairedWithout(const std::string& table) {
    const auto page = catalogue()
                          .database()
                          .sql("SELECT rootpage FROM sqlite_schema WHERE name = ?", table)
                          .one<std::int64_t>();
    project_.reset();
    std::string bytes = catalogue::bytesOf(file());
    const std::size_t at = static_cast<std::size_t>(page - 1) * store::kPageBytes;
    for (std::size_t i = 0; i < store::kPageBytes; ++i) bytes[at + i] = static_cast<char>(i * 7);
    catalogue::writeBytes(file(), bytes);
    QuietProgress quiet;
    const RepairReport report =
        catalogue::valueIn(repairCatalogue(folder(), quiet, {}, [this] { return now_ms += 1; }));
    EXPECT_EQ(report.pages_lost, 1);
    EXPECT_FALSE(report.all_from_backup);
    project_ = std::make_unique<Project>(*Project::open(folder()));
    EXPECT_TRUE(catalogue().checkIntegrity());
    std::vector<std::string> words;
    for (const RepairedRow& row : report.rows) words.push_back(row.words("backup").english());
    return words;
  }
  // As a table enters it, whose history names its place.
  store::SherdRow placed(const std::string& in_site, const std::string& in_trench,
                         const std::string& in_context, const std::string& number) {
    const store::SherdRow sherd = *sherds::Sherds(catalogue()).add({}, anna);
    const auto given = records::Confirmation::Given;
    const std::vector<records::FieldChange> changes = {{sherd, "site", in_site, given},
                                                       {sherd, "trench", in_trench, given},
                                                       {sherd, "context", in_context, given},
                                                       {sherd, "number", number, given}};
    EXPECT_TRUE(sherds::SherdChanges(catalogue()).apply(changes, anna));
    return sherd;
  }
  std::string numberOf(store::SherdRow row) { return valueOf(row, "number"); }
};

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

// Site ARM2 with trench T9 and context 0099, and a sherd there with a weight: all newer than the
// backup.
class RepairNewPlaces : public RepairHistory {
 protected:
  void SetUp() override {
    old_ = numbered(context12);
    ASSERT_TRUE(project_->backUp());
    std::vector<std::string> made;
    catalogue::Places places(catalogue());
    ASSERT_TRUE(places.contextAt("ARM2", "T9", "0099", anna, made));
    sherd_ = placed("ARM2", "T9", "0099", "X-1");
    ASSERT_TRUE(set(sherd_, "weight_g", "12.5 ± 0.4"));
    ASSERT_TRUE(set(sherd_, "joins", numberOf(old_)));
  }
  void expectTheSherdAsItWas() {
    EXPECT_EQ(sherds::Sherds(catalogue()).rows({}, {})->size(), 2u);
    EXPECT_EQ(sherds::Sherds(catalogue()).byNumber("X-1")->value, sherd_.value);
    EXPECT_EQ(valueOf(sherd_, "site"), "ARM2");
    EXPECT_EQ(valueOf(sherd_, "trench"), "T9");
    EXPECT_EQ(valueOf(sherd_, "context"), "0099");
    EXPECT_EQ(valueOf(sherd_, "weight_g"), "12.5");
    EXPECT_EQ(valueOf(sherd_, "joins"), numberOf(old_));
    EXPECT_EQ(found("ARM2").size(), 1u);
  }
  store::SherdRow old_, sherd_;
};

TEST_F(RepairNewPlaces, AreMadeAnewWhereTheContextIsLost) {
  const std::vector<std::string> words = repairedWithout("context");
  expectTheSherdAsItWas();
  EXPECT_THAT(words, Contains("context 3 (0099): from the history"));
  EXPECT_THAT(words, Contains("context 3 (0099), kind, excavated_on, period, date_edtf, note: not "
                              "restored"));
}

TEST_F(RepairNewPlaces, AreMadeAnewWhereTheTrenchIsLost) {
  repairedWithout("trench");
  expectTheSherdAsItWas();
}

TEST_F(RepairNewPlaces, AreMadeAnewWhereTheSiteIsLost) {
  EXPECT_THAT(repairedWithout("site"), Contains("site 2 (ARM2): from the history"));
  expectTheSherdAsItWas();
}

TEST_F(RepairNewPlaces, AreThoseOfASherdWhoseOwnRowIsLost) {
  const std::vector<std::string> words = repairedWithout("sherd");
  expectTheSherdAsItWas();
  EXPECT_THAT(words, Contains("sherd 2 (X-1): from the history"));
  EXPECT_THAT(words, Not(Contains("sherd_join: not restored")));
  EXPECT_THAT(words, Not(Contains("measurement: not restored")));
}

TEST_F(RepairNewPlaces, MeasurementsThatAreLostComeFromTheHistory) {
  const std::vector<std::string> words = repairedWithout("measurement");
  expectTheSherdAsItWas();
  EXPECT_THAT(words, Contains("sherd 2 (X-1), weight: from the history"));
  const auto measures = *sherds::Measurements(catalogue()).of(sherd_);
  ASSERT_EQ(measures.size(), 1u);
  EXPECT_EQ(measures[0].uncertainty, 0.4);
}

TEST_F(RepairNewPlaces, NumbersThatWereGivenStayTaken) {
  ASSERT_TRUE(set(sherd_, "number", "X-2"));
  repairedWithout("given_number");
  EXPECT_EQ(sherds::Sherds(catalogue()).byNumber("X-2")->value, sherd_.value);
  EXPECT_FALSE(set(old_, "number", "X-1"));
}

// The photographed sherd's history does not name its place.
TEST_F(RepairHistory, ASherdStaysWhereNothingTellsTheSiteOfItsContext) {
  ASSERT_TRUE(project_->backUp());
  const store::SherdRow sherd = numbered(context("0050"));
  const std::string number = numberOf(sherd);
  const std::vector<std::string> words = repairedWithout("context");
  EXPECT_EQ(numberOf(sherd), number);
  EXPECT_EQ(valueOf(sherd, "context"), "0050");
  EXPECT_EQ(valueOf(sherd, "site"), "ARM1") << "the only one";
  EXPECT_THAT(words, Contains("context 3 (0050), site, trench, kind, excavated_on, period, "
                              "date_edtf, note: not restored"));
}

TEST_F(RepairHistory, TheRowNumberOfALostSherdIsNotGivenAgain) {
  const store::SherdRow first = draft(context12);
  catalogue::remember(catalogue(), anna, "sherd", first.value + 6, "note", "", "lost");
  EXPECT_EQ(draft(context12).value, first.value + 7);
}

}  // namespace
}  // namespace ostraka::upkeep
