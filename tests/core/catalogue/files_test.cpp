#include "catalogue/files.h"

#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RecordedFiles : public SmallProject {
 protected:
  records::FileRecord photo(const std::string& name) const {
    records::FileRecord file;
    file.path = "batches/B0001/front/" + name;
    file.sha256 = std::string(64, 'a');
    file.media_type = "image/jpeg";
    file.role = "photo";
    file.bytes = 5'000'000'000;  // more than 32 bits hold
    file.batch = batch;
    return file;
  }
  static std::vector<std::string> pathsOf(const Result<std::vector<records::FileRecord>>& files) {
    std::vector<std::string> paths;
    for (const records::FileRecord& file : files.value()) paths.push_back(file.path);
    return paths;
  }
  store::BatchRow batch = newBatch({bag4});
  store::SherdRow sherd = numbered(context12);
  Files files{catalogue()};
};

TEST_F(RecordedFiles, KeepAllThatIsSaidOfThem) {
  records::FileRecord file = photo("a.jpg");
  file.state = records::FileState::Changed;
  file.sherd = sherd;
  const store::FileRow row = valueIn(files.save(file, anna));
  const std::vector<records::FileRecord> all = valueIn(files.all());
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].row, row);
  EXPECT_FALSE(all[0].id.empty());
  EXPECT_EQ(all[0].path, "batches/B0001/front/a.jpg");
  EXPECT_EQ(all[0].sha256, std::string(64, 'a'));
  EXPECT_EQ(all[0].media_type, "image/jpeg");
  EXPECT_EQ(all[0].role, "photo");
  EXPECT_EQ(all[0].bytes, 5'000'000'000);
  EXPECT_EQ(all[0].state, records::FileState::Changed);
  EXPECT_EQ(all[0].sherd, sherd);
  EXPECT_EQ(all[0].batch, batch);
}

TEST_F(RecordedFiles, AreOneForEachPathWhoeverEntersItAgain) {
  const store::FileRow first = valueIn(files.save(photo("a.jpg"), anna));
  const std::string id = valueIn(files.all()).front().id;
  records::FileRecord again = photo("a.jpg");
  again.sha256 = std::string(64, 'b');
  EXPECT_EQ(valueIn(files.save(again, anna)), first);
  for (const char* same_place : {"batches//B0001/front/a.jpg", "batches/./B0001/front/a.jpg"}) {
    again.path = same_place;
    EXPECT_FALSE(files.save(again, anna)) << "in other letters";
  }
  const std::vector<records::FileRecord> all = valueIn(files.all());
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].id, id);
  EXPECT_EQ(all[0].sha256, std::string(64, 'b'));
}

TEST_F(RecordedFiles, ThatMoveKeepTheirRow) {
  const store::FileRow row = valueIn(files.save(photo("a.jpg"), anna));
  records::FileRecord moved = valueIn(files.all()).front();
  moved.path = "batches/B0001/front/b.jpg";
  EXPECT_EQ(valueIn(files.save(moved, anna)), row);
  EXPECT_THAT(pathsOf(files.all()), ElementsAre("batches/B0001/front/b.jpg"));
}

TEST_F(RecordedFiles, AreFoundByTheirBatchAndTheirSherdInTheOrderOfTheirPaths) {
  const store::BatchRow other = newBatch({bag5});
  for (const char* name : {"c.jpg", "a.jpg", "b.jpg"}) {
    records::FileRecord file = photo(name);
    if (file.path.ends_with("b.jpg")) file.sherd = sherd;
    ASSERT_TRUE(files.save(file, anna));
  }
  EXPECT_THAT(pathsOf(files.of(batch)),
              ElementsAre("batches/B0001/front/a.jpg", "batches/B0001/front/b.jpg",
                          "batches/B0001/front/c.jpg"));
  EXPECT_THAT(pathsOf(files.of(sherd)), ElementsAre("batches/B0001/front/b.jpg"));
  EXPECT_THAT(pathsOf(files.of(other)), IsEmpty());
}

TEST_F(RecordedFiles, NeverLieOutsideTheProject) {
  for (const char* path : {"../secret.jpg", "/etc/passwd", "batches/../../x.jpg", "", "a\nb.jpg"}) {
    records::FileRecord file = photo("a.jpg");
    file.path = path;
    const Result<store::FileRow> saved = files.save(file, anna);
    ASSERT_FALSE(saved) << path;
    EXPECT_EQ(saved.error().code, ErrorCode::UnusableInput) << path;
  }
  EXPECT_THAT(pathsOf(files.all()), IsEmpty());
}

TEST_F(RecordedFiles, OfASherdThatIsNotThereAreRefusedAndNothingIsLeft) {
  const std::int64_t before = History(catalogue()).length();
  records::FileRecord file = photo("a.jpg");
  file.sherd = store::SherdRow{4711};
  EXPECT_FALSE(files.save(file, anna));
  EXPECT_THAT(pathsOf(files.all()), IsEmpty());
  EXPECT_EQ(History(catalogue()).length(), before);
}

}  // namespace
}  // namespace ostraka::catalogue
