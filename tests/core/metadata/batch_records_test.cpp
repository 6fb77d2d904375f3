#include "metadata/batch_records.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "archive/bag_reader.h"
#include "archive/bagit.h"
#include "catalogue/files.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::metadata {
namespace {

class BatchRecords : public catalogue::SmallProject {
 protected:
  // An export of one photograph.
  archive::BagReader bag() {
    auto writer = catalogue::valueIn(archive::BagWriter::begin(folder_.path() / "bag"));
    photograph = catalogue::valueIn(writer.add("photographs/B0001/front/a.jpg", "JPEG"));
    EXPECT_TRUE(writer.finish({}));
    return catalogue::valueIn(archive::BagReader::open(folder_.path() / "bag", quiet, {}));
  }
  QuietProgress quiet;
  archive::BagFile photograph;
};

TEST_F(BatchRecords, AFileIsTheOneThatItsRecordAndTheManifestName) {
  const archive::BagReader read = bag();
  const std::string at = "photographs/B0001/front/a.jpg";
  const Result<archive::BagFile> same = verifiedFile(read, at, photograph.sha256, 4);
  ASSERT_TRUE(same) << same.error().sentence();
  EXPECT_EQ(same->path, "data/" + at);
  EXPECT_FALSE(verifiedFile(read, at, photograph.sha256, 5));
  EXPECT_FALSE(verifiedFile(read, at, std::string(64, '0'), 4));
  const Result<archive::BagFile> none =
      verifiedFile(read, "photographs/B0001/front/b.jpg", photograph.sha256, 4);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(none.error().where, "photographs/B0001/front/b.jpg");
}

// What is in the catalogue and did not go along is of no use to who reads the export.
TEST_F(BatchRecords, NamePhotographsThatGoAlongByWhereTheyLieInTheExport) {
  const store::BatchRow batch = newBatch({bag4});
  for (const char* name : {"a", "b"}) {
    records::FileRecord file;
    file.path = "batches/B0001/front/" + std::string(name) + ".jpg";
    file.sha256 = std::string(64, 'f');
    file.bytes = 9;
    file.role = "photo";
    file.media_type = "image/jpeg";
    file.batch = batch;
    ASSERT_TRUE(catalogue::Files(catalogue()).save(file, anna));
  }
  const std::string sum(64, '1');
  const auto written =
      batchesJson(catalogue(), {batch}, {{"data/photographs/B0001/front/a.jpg", sum, 4}});
  ASSERT_TRUE(written) << written.error().sentence();
  const auto& one = written->at("batches").at(0);
  EXPECT_EQ(one.at("number"), "B0001");
  EXPECT_EQ(one.at("counted"), 3);
  ASSERT_EQ(one.at("files").size(), 1u);
  EXPECT_EQ(one.at("files").at(0).at("at"), "photographs/B0001/front/a.jpg");
  EXPECT_EQ(one.at("files").at(0).at("path"), "batches/B0001/front/a.jpg");
  EXPECT_EQ(one.at("files").at(0).at("sha256"), sum) << "of the copy, not of what was entered";
  EXPECT_EQ(one.at("files").at(0).at("bytes"), 4);
}

// Two laptops begin with B0001 each; the folders of a batch bear its number.
TEST_F(BatchRecords, ABatchWhoseNumberIsTakenTakesItsFilesToTheNextOne) {
  newBatch({bag4});
  const archive::BagReader read = bag();
  const nlohmann::json batches = nlohmann::json::parse(
      R"({"batches":[{"id":"019f5ff6-39c0-7b3a-9c55-2f7e8d104ab6","number":"B0001",)"
      R"("state":"queued","counted":2,"files":[)"
      R"({"id":"019f5ff6-39c0-7b3a-9c55-2f7e8d104ab7","role":"photo","bytes":4,"sha256":")" +
      photograph.sha256 +
      R"(","path":"batches/B0001/front/a.jpg","media_type":"image/jpeg",)"
      R"("at":"photographs/B0001/front/a.jpg"}]}]})");
  const Result<ReadBatches> entered = readBatches(catalogue(), read, batches, {}, anna);
  ASSERT_TRUE(entered) << entered.error().sentence();
  EXPECT_THAT(entered->numbers, testing::ElementsAre(testing::Pair("B0001", "B0002")));
  ASSERT_EQ(entered->copies.size(), 1u);
  EXPECT_EQ(entered->copies[0].from, "photographs/B0001/front/a.jpg");
  EXPECT_EQ(entered->copies[0].to, "batches/B0002/front/a.jpg");
  ASSERT_EQ(entered->fresh.size(), 1u);
  const records::BatchRecord batch = *catalogue::Batches(catalogue()).get(*entered->fresh.begin());
  EXPECT_EQ(batch.number, "B0002");
  EXPECT_EQ(batch.state, records::BatchState::Failed) << "nobody here computes it by itself";
  EXPECT_EQ(batch.note, "Was B0001 where it was made.");
  const Result<ReadBatches> again = readBatches(catalogue(), read, batches, {}, anna);
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_TRUE(again->fresh.empty()) << "known by its id";
  EXPECT_TRUE(again->copies.empty());
}

}  // namespace
}  // namespace ostraka::metadata
