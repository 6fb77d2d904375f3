// Results that were copied or moved to another batch than that of their photographs.
#include "intake/results_owner.h"

#include <gmock/gmock.h>

#include "catalogue/files.h"
#include "records/sherd.h"
#include "store/database.h"
#include "tests/core/intake/entering.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Three photographs a side; the results of B0001 lie in results/B0001.
class ResultsOfABatch : public Entering {
 protected:
  ResultsOfABatch() { writeInputs(project_->resultsFolder("B0001"), "B0001"); }
  static std::string photograph(const std::string& number, const std::string& name) {
    return "photograph " + name + " of " + number;
  }
  static std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const char* side : {"front/", "back/"})
      for (const char* stop : {"cam0_pos00.jpg", "cam0_pos01.jpg", "cam0_pos02.jpg"})
        all.push_back(std::string(side) + stop);
    return all;
  }
  // As `process` notes what it read.
  static void writeInputs(const fs::path& out, const std::string& of) {
    nlohmann::ordered_json inputs = {{"plate.json", sha256("the plate of all batches")}};
    for (const std::string& name : names()) inputs[name] = sha256(photograph(of, name));
    ASSERT_TRUE(writeJson(out / "work/batch.json", inputs));
  }
  void writePhotographs(const std::string& number) {
    for (const std::string& name : names())
      ASSERT_TRUE(
          writeFileAtomically(project_->batchFolder(number) / name, photograph(number, name)));
  }
  void photographAgain(const std::vector<std::string>& again) {
    for (const std::string& name : again)
      ASSERT_TRUE(writeFileAtomically(project_->batchFolder("B0001") / name, "again " + name));
  }
  void recordPhotographs(store::BatchRow of, const std::string& number) {
    for (const std::string& name : names()) {
      records::FileRecord file;
      file.path = "batches/" + number + "/" + name;
      file.sha256 = sha256(photograph(number, name));
      file.media_type = "image/jpeg";
      file.role = "photo";
      file.batch = of;
      ASSERT_TRUE(catalogue::Files(catalogue()).save(file, {}));
    }
  }
  Result<EnteredResults> tryTo(store::BatchRow as, const std::string& number) {
    return enterResults(catalogue(), project_->folder(), as, project_->resultsFolder(number), {},
                        quiet, {});
  }
  // B0002, with the results of B0001 as its own.
  store::BatchRow second() {
    const store::BatchRow row = newBatch({bag4});
    fs::copy(project_->resultsFolder("B0001"), project_->resultsFolder("B0002"),
             fs::copy_options::recursive);
    return row;
  }
};

TEST_F(ResultsOfABatch, AreEnteredByItsRecordedPhotographsOrThoseInItsFolder) {
  recordPhotographs(batch, "B0001");  // the folder was moved to another disk
  EXPECT_TRUE(tryTo(batch, "B0001"));
  const store::BatchRow row = newBatch({bag4});
  const catalogue::ResultFolder results(project_->resultsFolder("B0002"), 3);
  writeInputs(project_->resultsFolder("B0002"), "B0002");
  writePhotographs("B0002");
  EXPECT_TRUE(tryTo(row, "B0002"));
}

// The catalogue still has the earlier ones: what lies in the folder is what counts.
TEST_F(ResultsOfABatch, WhoseOneSideWasPhotographedAgainAreThoseOfEarlierPhotographs) {
  recordPhotographs(batch, "B0001");
  for (const char* side : {"front", "back"}) {
    writePhotographs("B0001");
    photographAgain({std::string(side) + "/cam0_pos00.jpg", std::string(side) + "/cam0_pos01.jpg"});
    const Result<EnteredResults> refused = tryTo(batch, "B0001");
    ASSERT_FALSE(refused) << side;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_THAT(refused.error().what,
                HasSubstr("earlier photographs of the " + std::string(side) + " of B0001"));
    EXPECT_TRUE(sherds().empty());
  }
}

TEST_F(ResultsOfABatch, AreEnteredForReviewWhereSinglePhotographsDifferOrAreMissing) {
  writePhotographs("B0001");
  const Result<EnteredResults> same = tryTo(batch, "B0001");
  ASSERT_TRUE(same) << same.error().sentence();
  EXPECT_FALSE(same->other_photographs);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);

  photographAgain({"front/cam0_pos00.jpg"});
  ASSERT_TRUE(fs::remove(project_->batchFolder("B0001") / "back/cam0_pos02.jpg"));
  const Result<EnteredResults> entered = tryTo(batch, "B0001");
  ASSERT_TRUE(entered) << entered.error().sentence();
  ASSERT_TRUE(entered->other_photographs);
  EXPECT_THAT(entered->other_photographs->english(), HasSubstr("2 of 6"));
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
}

TEST_F(ResultsOfABatch, OfImportedScansAreToldFromThoseOfOtherScans) {
  const fs::path results = project_->resultsFolder("B0001");
  const auto name = [](const char* side) { return std::string(side) + "/a.ply"; };
  nlohmann::ordered_json inputs;
  for (const char* side : {"front", "back"}) {
    inputs[name(side)] = sha256(side);
    ASSERT_TRUE(writeFileAtomically(project_->batchFolder("B0001") / name(side), side));
  }
  ASSERT_TRUE(writeJson(results / "work/batch.json", inputs));
  EXPECT_TRUE(tryTo(batch, "B0001"));
  ASSERT_TRUE(writeFileAtomically(project_->batchFolder("B0001") / name("front"), "others"));
  EXPECT_FALSE(tryTo(batch, "B0001"));
}

TEST_F(ResultsOfABatch, ThatDoNotSayWhatTheyWereMadeFromAreRefusedWhereThereArePhotographs) {
  const fs::path inputs = project_->resultsFolder("B0001") / "work/batch.json";
  writePhotographs("B0001");
  const auto refused = [&] {
    const Result<EnteredResults> entered = tryTo(batch, "B0001");
    return entered ? std::string("entered") : entered.error().what.english();
  };
  for (const char* text : {"{}", R"({"plate.json": "12ab"})"}) {
    ASSERT_TRUE(writeFileAtomically(inputs, text));
    EXPECT_THAT(refused(), HasSubstr("do not say which photographs")) << text;
  }
  fs::remove(inputs);
  EXPECT_THAT(refused(), HasSubstr("do not say which photographs"));
  fs::remove_all(project_->batchFolder("B0001"));
  recordPhotographs(batch, "B0001");
  EXPECT_THAT(refused(), HasSubstr("do not say which photographs")) << "on another disk";
  EXPECT_TRUE(sherds().empty());
}

TEST_F(ResultsOfABatch, AreNotThoseOfABatchWhoseSidesWereExchanged) {
  writePhotographs("B0001");
  const fs::path folder = project_->batchFolder("B0001");
  fs::rename(folder / "front", folder / "aside");
  fs::rename(folder / "back", folder / "front");
  fs::rename(folder / "aside", folder / "back");
  EXPECT_FALSE(tryTo(batch, "B0001"));
}

TEST_F(ResultsOfABatch, AreNotEnteredAsThoseOfAnotherWithOtherPhotographs) {
  writePhotographs("B0001");
  const store::BatchRow other = second();
  writePhotographs("B0002");
  const Result<EnteredResults> refused = tryTo(other, "B0002");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(refused.error().what, HasSubstr("from the photographs of B0001, not of B0002"));
  EXPECT_TRUE(sherds::Sherds(catalogue()).rows(other)->empty());
  EXPECT_FALSE(fs::exists(project_->folder() / "models/B0002"));
}

TEST_F(ResultsOfABatch, AreNotEnteredAsThoseOfAnEmptyOne) {
  recordPhotographs(batch, "B0001");
  const store::BatchRow other = second();
  const Result<EnteredResults> refused = tryTo(other, "B0002");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().what, HasSubstr("of B0001, not of B0002"));
}

TEST_F(ResultsOfABatch, FromNoBatchOfTheProjectAreRefusedWhereThereArePhotographs) {
  writeInputs(project_->resultsFolder("B0001"), "another project");
  EXPECT_TRUE(tryTo(batch, "B0001")) << "nothing says whose they are";
  writePhotographs("B0001");
  const Result<EnteredResults> refused = tryTo(batch, "B0001");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().what, HasSubstr("not made from the photographs of B0001"));
}

}  // namespace
}  // namespace ostraka::intake
