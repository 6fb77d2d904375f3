#include "api/catalogue.h"

#include <gmock/gmock.h>

#include "tests/core/catalogue/small_project.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::api {
namespace {

using ReadCatalogue = catalogue::SmallProject;

TEST_F(ReadCatalogue, GivesSherdsThatMatchWithTheirFields) {
  numbered(context12);
  numbered(context13);
  draft(context12);
  const std::filesystem::path folder = folder_.path() / "project";
  const Result<CatalogueContents> all = readCatalogue(folder, "");
  ASSERT_TRUE(all.has_value()) << all.error().sentence();
  EXPECT_EQ(all->title, "Trial");
  ASSERT_EQ(all->sherds.size(), 3u);
  EXPECT_EQ(all->sherds.front().number, "ARM1-T3-0012-0001");
  EXPECT_TRUE(all->sherds.back().number.empty()) << "drafts are last";
  const Result<CatalogueContents> some = readCatalogue(folder, "context:0013");
  ASSERT_TRUE(some.has_value()) << some.error().sentence();
  ASSERT_EQ(some->sherds.size(), 1u);
  EXPECT_THAT(some->sherds.front().fields, testing::Contains(testing::Pair("context", "0013")));
}

TEST(ReadNoCatalogue, SaysThatAFolderIsNoProject) {
  const TemporaryFolder folder;
  const Result<CatalogueContents> none = readCatalogue(folder.path(), "");
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::api
