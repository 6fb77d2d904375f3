// Two batches of a project with the same photographs.
#include "intake/side_photographs.h"

#include <gmock/gmock.h>

#include "catalogue/files.h"
#include "files/files.h"
#include "intake/compute_batch.h"
#include "records/sherd.h"
#include "tests/core/intake/entering.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using catalogue::valueIn;
using testing::HasSubstr;

// B0001 has three photographs a side, and results of three sherds that are not entered yet.
class TheSamePhotographs : public Entering {
 protected:
  TheSamePhotographs() {
    photograph("B0001", "of B0001 ");
    catalogue::ResultFolder::noteInputs(project_->resultsFolder("B0001"),
                                        project_->batchFolder("B0001"));
  }
  void put(const std::string& number, const std::string& name, const std::string& bytes) {
    ASSERT_TRUE(writeFileAtomically(project_->batchFolder(number) / name, bytes));
  }
  void photograph(const std::string& number, const std::string& bytes) {
    for (const char* name :
         {"front/a.jpg", "front/b.jpg", "front/c.jpg", "back/a.jpg", "back/b.jpg", "back/c.jpg"})
      put(number, name, bytes + name);
  }
  // B0002, whose photographs are its own.
  store::BatchRow second() {
    const store::BatchRow row = newBatch({bag4});
    photograph("B0002", "of B0002 ");
    const catalogue::ResultFolder results(project_->resultsFolder("B0002"), 2);
    return row;
  }
  Result<EnteredResults> enterSecond(store::BatchRow row) {
    catalogue::ResultFolder::noteInputs(project_->resultsFolder("B0002"),
                                        project_->batchFolder("B0002"));
    return enterResults(catalogue(), project_->folder(), row, project_->resultsFolder("B0002"), {},
                        quiet, {});
  }
  Result<void> check(store::BatchRow row) {
    return checkNotShared(catalogue(), project_->folder(),
                          valueIn(catalogue::Batches(catalogue()).get(row)), {});
  }
  std::size_t sherdsOf(store::BatchRow row) {
    return valueIn(sherds::Sherds(catalogue()).rows(row)).size();
  }
};

TEST_F(TheSamePhotographs, OfAnotherBatchAreNeitherProcessedNorEntered) {
  enter();
  const store::BatchRow row = second();
  EXPECT_TRUE(check(row));
  put("B0002", "back/under_another_name.jpg", "of B0001 back/b.jpg");
  const Result<EnteredResults> refused = enterSecond(row);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_TRUE(isAboutShared(refused.error().what));
  EXPECT_THAT(refused.error().what.english(),
              HasSubstr("1 of the 7 photographs or scans of B0002 belong to B0001, too"));
  EXPECT_EQ(sherdsOf(row), 0u);
  const auto computed = computeBatch({project_->folder(), "B0002"}, quiet, {});
  ASSERT_FALSE(computed);
  EXPECT_TRUE(isAboutShared(computed.error().what)) << computed.error().sentence();
}

TEST_F(TheSamePhotographs, AreNotTwoFilesOfWhichACopyFailed) {
  enter();
  const store::BatchRow row = second();
  put("B0001", "front/a.jpg", "");
  put("B0002", "back/c.jpg", "");
  EXPECT_TRUE(check(row));
}

TEST_F(TheSamePhotographs, AreEnteredTwiceByAPersonWhoKeepsBoth) {
  enter();
  const store::BatchRow row = second();
  photograph("B0002", "of B0001 ");
  EXPECT_FALSE(check(row));
  ASSERT_TRUE(keepBoth(catalogue(), "B0002", anna));
  EXPECT_TRUE(enterSecond(row));
  EXPECT_EQ(sherdsOf(row), 2u);
}

TEST_F(TheSamePhotographs, AreNoMatterWhereABatchIsProcessedAgain) {
  const store::BatchRow row = second();
  ASSERT_TRUE(enterSecond(row));
  enter();
  photograph("B0002", "of B0001 ");  // both are in the catalogue by now
  EXPECT_TRUE(check(batch));
  EXPECT_TRUE(check(row));
  EXPECT_TRUE(enterSecond(row));
  enter();
}

TEST_F(TheSamePhotographs, HoldBackTheLaterBatchOnly) {
  const store::BatchRow row = second();
  photograph("B0002", "of B0001 ");
  EXPECT_TRUE(check(batch)) << "neither is entered yet";
  EXPECT_FALSE(check(row));
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Failed, anna));
  EXPECT_TRUE(check(row)) << "the other one was set aside";
  ASSERT_TRUE(enterSecond(row));
  EXPECT_FALSE(check(batch)) << "whose turn it would be again";
}

// Of a size, as uncompressed ones are; what is recorded is not read again.
TEST_F(TheSamePhotographs, AreKnownByContentAlsoWhereTheirFolderIsGone) {
  records::FileRecord file;
  file.path = "batches/B0001/front/a.jpg";
  file.sha256 = sha256("of B0001 front/a.jpg");
  file.bytes = 20;
  file.media_type = "image/jpeg";
  file.role = "photo";
  file.batch = batch;
  ASSERT_TRUE(catalogue::Files(catalogue()).save(file, anna));
  fs::remove_all(project_->batchFolder("B0001"));
  const fs::path taken = folder_.path() / "card";
  for (const char* name : {"x.jpg", "y.jpg"})
    ASSERT_TRUE(writeFileAtomically(
        taken / name, name[0] == 'x' ? "of B0001 front/a.jpg" : "of B0001 front/z.jpg"));
  const auto all = [](const records::BatchRecord&) { return true; };
  const auto shared =
      valueIn(sharedPhotographs(catalogue(), project_->folder(),
                                batch::sideFiles({taken / "x.jpg", taken / "y.jpg"}), all, {}));
  ASSERT_TRUE(shared);
  EXPECT_EQ(shared->batch, "B0001");
  EXPECT_EQ(shared->shared, 1);
  EXPECT_EQ(shared->of, 2);
  EXPECT_FALSE(valueIn(sharedPhotographs(catalogue(), project_->folder(),
                                         batch::sideFiles({taken / "y.jpg"}), all, {})));
}

}  // namespace
}  // namespace ostraka::intake
