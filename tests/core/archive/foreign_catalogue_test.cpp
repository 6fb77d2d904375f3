// Archives whose catalogue a stranger wrote: every checksum agrees, and none becomes a project.
#include <gmock/gmock.h>

#include "archive/archive.h"
#include "store/database.h"
#include "tests/core/exchange/exported_project.h"
#include "tests/core/exchange/mended_bag.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;

class ForeignCatalogue : public exchange::ExportedProject {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  Result<Archived> archive(Progress& progress) {
    return archiveProject(*project_, {at("archive"), "ostraka 1.0.0"}, progress, {});
  }
  // Of an archive whose catalogue was changed so.
  Result<Restored> restored(const std::string& change) {
    fs::remove_all(at("archive"));
    fs::remove_all(at("laptop"));
    EXPECT_TRUE(archive(quiet));
    const std::string catalogue = "data/catalogue.sqlite";
    const fs::path file = at("archive") / catalogue;
    (*store::Database::open(file, store::Database::Mode::ReadWrite))->script(change);
    exchange::MendedBag bag(at("archive"));
    bag.put(catalogue, *readFile(file));
    bag.mend();
    return restoreProject(at("archive"), at("laptop"), quiet, {});
  }
};

TEST_F(ForeignCatalogue, IsRestoredWhereNothingWasChanged) {
  const Result<Restored> back = restored("");
  EXPECT_TRUE(back) << back.error().sentence();
}

TEST_F(ForeignCatalogue, IsRefusedWithBatchesThatLeadOutOfTheProject) {
  const fs::path photographs = at("photographs");
  put(photographs / "2024" / "a.jpg", "mine");
  for (const std::string& number :
       {photographs.string(), std::string("../../photographs"), std::string("B0001/.."),
        std::string(".."), std::string(".git"), std::string()}) {
    const Result<Restored> back = restored("UPDATE batch SET number = '" + number + "'");
    ASSERT_FALSE(back) << number;
    EXPECT_EQ(back.error().code, ErrorCode::UnusableInput) << number;
    EXPECT_FALSE(fs::exists(at("laptop"))) << number;
  }
  EXPECT_EQ(*readFile(photographs / "2024" / "a.jpg"), "mine");
}

TEST_F(ForeignCatalogue, IsRefusedWithTablesViewsAndTriggersThatAreNotOurs) {
  for (const char* change :
       {"CREATE TRIGGER evil AFTER INSERT ON history BEGIN UPDATE sherd SET ware = 'x'; END",
        "CREATE TABLE more AS SELECT * FROM project; PRAGMA foreign_keys = OFF; DROP TABLE "
        "project; CREATE VIEW project AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 "
        "FROM c) SELECT more.* FROM more WHERE (SELECT max(x) FROM c) > 0",
        "CREATE INDEX evil ON sherd (length(ware))"}) {
    const Result<Restored> back = restored(change);
    ASSERT_FALSE(back) << change;
    EXPECT_THAT(back.error().what, testing::HasSubstr("those that Ostraka creates")) << change;
    EXPECT_FALSE(fs::exists(at("laptop"))) << change;
  }
}

TEST_F(ForeignCatalogue, IsRefusedWithValuesThatNoExportCanHold) {
  for (const char* change : {"UPDATE sherd_measure SET weight = 9e999 WHERE sherd = 1",
                             "UPDATE site SET name = CAST(x'ff00fe' AS TEXT)"}) {
    const Result<Restored> back = restored(change);
    ASSERT_FALSE(back) << change;
    EXPECT_EQ(back.error().code, ErrorCode::UnusableInput) << change;
    EXPECT_FALSE(fs::exists(at("laptop"))) << change;
  }
}

// As an older Ostraka may have stored it.
TEST_F(ForeignCatalogue, IsNoneThatWeSealWithValuesThatWeWouldNotRestore) {
  catalogue().database().script("UPDATE site SET name = CAST(x'ff00fe' AS TEXT)");
  const Result<Archived> refused = archive(quiet);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "site.name, row 1");
  EXPECT_FALSE(fs::exists(at("archive")));
  EXPECT_FALSE(fs::exists(at("archive.partial")));
}

// A photograph is taken anew and entered while the archive is made.
class TakingAnew final : public Progress {
 public:
  explicit TakingAnew(std::function<void()> act) : act_(std::move(act)) {}
  void report(std::int64_t, std::int64_t) override {
    if (act_) std::exchange(act_, {})();
  }
  void note(NoteLevel, const Message&) override {}

 private:
  std::function<void()> act_;
};

TEST_F(ForeignCatalogue, IsNoneThatWeSealWithFilesItDoesNotKnow) {
  const std::string photograph = "batches/B0001/front/cam0_pos00.jpg";
  TakingAnew anew([&] {
    put(project_->folder() / photograph, "another JPEG");
    catalogue().database().run("UPDATE file SET sha256 = ?, bytes = 12 WHERE path = ?",
                               sha256("another JPEG"), photograph);
  });
  const Result<Archived> archived = archive(anew);
  ASSERT_TRUE(archived) << archived.error().sentence();
  EXPECT_FALSE(archived->sealed) << "its catalogue is the one of before";
  ASSERT_EQ(archived->damage.size(), 1u);
  EXPECT_EQ(archived->damage[0].file.path, photograph);
  EXPECT_EQ(archived->damage[0].damage, upkeep::Damage::Changed);
}

}  // namespace
}  // namespace ostraka::archive
