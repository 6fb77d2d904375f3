// The disk of a project, an export or an archive fills at a write of a command: it says so, leaves
// a whole catalogue, and goes on when there is room again. OSTRAKA_EVERY_WRITE=1 tries each write.
#include <cstdio>
#include <ctime>

#include "project_commands.h"
#include "sherds/sherds.h"
#include "small_disk.h"

namespace ostraka::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class FullDiskOfACatalogue : public ProjectCommands {
 protected:
  // prepare: before each trial. full: after the disk was full. done: after the same command with
  // room, and where the command ended well without.
  template <class Prepare, class Full, class Done>
  void fills(const Words& command, const fs::path& disk, long some, Prepare prepare, Full full,
             Done done) {
    prepare();
    const long writes = writesOf(disk, command, errors());
    int said = 0;
    for (const long room : roomsBelow(writes, some)) {
      SCOPED_TRACE("room for " + std::to_string(room) + " of " + std::to_string(writes));
      prepare();
      const Ended ended = runWithRoomFor(room, disk, command, errors());
      if (ended.status != 0) {
        ++said;
        expectDiskFull(ended, disk);
        full(ended);
        expectDone(run(command));
      }
      done();
      if (HasFailure()) return;
    }
    EXPECT_GT(said, 0);
    std::printf("%s %s: full at %d of %ld writes\n", command[0].c_str(), command[1].c_str(), said,
                writes);
  }
};

TEST_F(FullDiskOfACatalogue, ANewProjectIsMadeWhenThereIsRoom) {
  fills(
      {"catalogue", "new", "--output", at("new"), "--code", "ARM"}, at("new"), 5,
      [&] { fs::remove_all(at("new")); },
      [&](const Ended&) { EXPECT_FALSE(fs::exists(at("new"))); }, [&] { expectWhole("new", 0); });
}

TEST_F(FullDiskOfACatalogue, AnImportSaysHowManyRowsAreIn) {
  project_.reset();
  tableOf(300);
  fills(
      {"catalogue", "import", at("work"), at("table.csv"), "--enter"}, at("work"), 5,
      [&] { copy("project", "work"); },
      [&](const Ended& ended) {
        expectReadable("work");
        const Result<upkeep::Project> open = upkeep::Project::open(at("work"));
        const std::size_t entered = sherds::Sherds(open->catalogue()).rows({}, {})->size() - 3;
        if (ended.errors.find("300 rows in total") != std::string::npos)
          EXPECT_NE(ended.errors.find("300 rows in total, " + std::to_string(entered) + " read"),
                    std::string::npos)
              << entered << " rows: " << ended.errors;
        else
          EXPECT_EQ(entered, 0u) << ended.errors;
      },
      [&] { expectWhole("work", 303); });
}

TEST_F(FullDiskOfACatalogue, AnExportIsReadBackWhenThereIsRoom) {
  ASSERT_TRUE(exportTo("export", {exchange::Form::Json, exchange::Form::Ply}));
  expectDone(run({"catalogue", "new", "--output", at("empty"), "--code", "ARM"}));
  fills(
      {"catalogue", "import", at("work"), at("export"), "--enter"}, at("work"), 5,
      [&] { copy("empty", "work"); }, [&](const Ended&) { expectReadable("work"); },
      [&] { expectWhole("work", 3); });
}

TEST_F(FullDiskOfACatalogue, AnExportLeavesNothing) {
  fills(
      {"catalogue", "export", at("project"), "--output", at("out"), "--forms",
       "csv,glb,json,obj,ods,photographs,pictures,ply"},
      at("out"), 5, [&] { fs::remove_all(at("out")); },
      [&](const Ended&) { EXPECT_FALSE(fs::exists(at("out"))); },
      [&] { EXPECT_TRUE(fs::exists(at("out/tagmanifest-sha256.txt"))); });
}

TEST_F(FullDiskOfACatalogue, AnArchiveLeavesNothing) {
  fills(
      {"catalogue", "archive", at("project"), "--output", at("out")}, at("out"), 5,
      [&] { fs::remove_all(at("out")); },
      [&](const Ended&) { EXPECT_FALSE(fs::exists(at("out"))); },
      [&] { EXPECT_TRUE(fs::exists(at("out/tagmanifest-sha256.txt"))); });
}

TEST_F(FullDiskOfACatalogue, AnArchiveIsRestoredWhenThereIsRoom) {
  expectDone(run({"catalogue", "archive", at("project"), "--output", at("archive")}));
  fills(
      {"catalogue", "restore", at("archive"), "--output", at("out")}, at("out"), 5,
      [&] { fs::remove_all(at("out")); },
      [&](const Ended&) { EXPECT_FALSE(fs::exists(at("out"))); }, [&] { expectWhole("out", 3); });
}

TEST_F(FullDiskOfACatalogue, ResultsEnterWhenThereIsRoom) {
  computeAgain();
  project_.reset();
  fills(
      {"catalogue", "enter", at("work"), "B0001"}, at("work"), 5, [&] { copy("project", "work"); },
      [&](const Ended&) { expectReadable("work"); }, [&] { expectWhole("work", 3); });
}

TEST_F(FullDiskOfACatalogue, ACheckSaysThatItsBackupHasNoRoom) {
  project_.reset();
  fills(
      {"catalogue", "check", at("work")}, at("work"), 5, [&] { copy("project", "work"); },
      [&](const Ended&) {
        expectReadable("work");
        EXPECT_TRUE(upkeep::backupsOf(at("work"), 1000LL * std::time(nullptr)).empty());
      },
      [&] { expectWhole("work", 3); });
}

TEST_F(FullDiskOfACatalogue, ARepairLeavesTheDamagedFileAndTheBackups) {
  const std::string content = damagedCopy(4, 1);
  const std::string bytes = catalogue::bytesOf(at("damaged/catalogue.sqlite"));
  fills(
      {"catalogue", "repair", at("work")}, at("work"), 5, [&] { copy("damaged", "work"); },
      [&](const Ended&) {
        EXPECT_EQ(catalogue::bytesOf(at("work/catalogue.sqlite")), bytes);
        EXPECT_FALSE(fs::is_empty(at("work/backups")));
      },
      [&] {
        const Result<std::string> now = catalogue::contentOf(at("work"));
        EXPECT_TRUE(now && *now == content);
      });
}

}  // namespace
}  // namespace ostraka::test
