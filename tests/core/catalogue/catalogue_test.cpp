#include "catalogue/catalogue.h"

#include <gmock/gmock.h>

#include "catalogue/settings.h"
#include "files/files.h"
#include "small_project.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

namespace fs = std::filesystem;

class ACatalogue : public SmallProject {
 protected:
  static Catalogue connected(const fs::path& file) {
    return Catalogue(valueIn(store::Database::open(file, store::Database::Mode::ReadWrite)),
                     [] { return 1; });
  }
};

TEST_F(ACatalogue, ThatIsDamagedIsNoticed) {
  for (int i = 0; i < 50; ++i) draft(context12);
  ASSERT_TRUE(catalogue().checkIntegrity());
  catalogue().database().script("DELETE FROM sherd_text WHERE rowid = 3");
  const Result<void> checked = catalogue().checkIntegrity();
  ASSERT_FALSE(checked);
  EXPECT_NE(checked.error().what.english().find("catalogue repair"), std::string::npos);
}

TEST_F(ACatalogue, WhoseTablesDisagreeIsDamaged) {
  numbered(context12);
  for (const auto& [change, word] :
       {std::pair("DELETE FROM sherd_measure", "the sherd tables are inconsistent"),
        {"DROP TRIGGER given_number_is_kept; DELETE FROM given_number",
         "the sherd tables are inconsistent"},
        {"UPDATE sherd SET context = 99", "a row of sherd refers to a missing row"},
        {"DELETE FROM project", "it contains no project"}}) {
    const fs::path file = folder_.path() / "copy.sqlite";
    ASSERT_TRUE(catalogue().backup(file));
    Catalogue copy = connected(file);
    ASSERT_TRUE(copy.checkIntegrity());
    copy.database().script(std::string("PRAGMA foreign_keys = OFF;") + change);
    const Result<void> checked = copy.checkIntegrity();
    ASSERT_FALSE(checked) << change;
    EXPECT_EQ(checked.error().code, ErrorCode::Damaged);
    EXPECT_THAT(checked.error().sentence().english(), testing::HasSubstr(word));
  }
}

TEST_F(ACatalogue, IsBackedUpWholeOrNotAtAll) {
  const fs::path file = folder_.path() / "copy.sqlite";
  numbered(context12);
  ASSERT_TRUE(catalogue().backup(file));
  EXPECT_EQ(sherds::Sherds(connected(file)).byNumber("ARM1-T3-0012-0001")->value, 1);
  // What is damaged takes the place of no good copy.
  const std::string good = *readFile(file);
  catalogue().database().script("DELETE FROM sherd_measure");
  const Result<void> refused = catalogue().backup(file);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Damaged);
  EXPECT_EQ(*readFile(file), good);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().string().find(".partial"), std::string::npos) << entry.path();
}

TEST_F(ACatalogue, TellsThatOthersWrote) {
  const Catalogue other = connected(catalogue().database().file());
  const std::int64_t before = *other.writesOfOthers(), own = *catalogue().writesOfOthers();
  EXPECT_EQ(*other.writesOfOthers(), before);
  draft(context12);
  EXPECT_NE(*other.writesOfOthers(), before);
  EXPECT_EQ(*catalogue().writesOfOthers(), own) << "what it wrote itself";
}

TEST_F(ACatalogue, IsReadAsOfOneMoment) {
  const Catalogue other = connected(catalogue().database().file());
  const auto sherdsOf = [](const Catalogue& read) {
    return sherds::Sherds(read).rows(*sherds::parseFilter(""), {})->size();
  };
  const Result<void> done = other.inSnapshot([&]() -> Result<void> {
    EXPECT_EQ(sherdsOf(other), 0u);
    draft(context12);
    EXPECT_EQ(sherdsOf(other), 0u);
    EXPECT_EQ(sherdsOf(catalogue()), 1u);
    return {};
  });
  EXPECT_TRUE(done);
  EXPECT_EQ(sherdsOf(other), 1u);
}

TEST_F(ACatalogue, TakesSeveralActsAsOneTransaction) {
  const Result<void> done = catalogue().together([&]() -> Result<void> {
    draft(context12);
    if (auto set = Settings(catalogue()).setValue("a", "1"); !set) return set;
    return Error{ErrorCode::Cancelled, "stop", {}};
  });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(*Settings(catalogue()).value("a"), "");
  EXPECT_TRUE(found("").empty());
}

}  // namespace
}  // namespace ostraka::catalogue
