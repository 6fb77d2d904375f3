// Commands of a project, killed at any moment: what stood there still stands, and the same command,
// given again, ends as if nobody had killed it. kills.h says how to kill them more often.
#include <ctime>

#include "project_commands.h"
#include "small_disk.h"
#include "undisturbed.h"

namespace ostraka::test {
namespace {

namespace fs = std::filesystem;
using KilledCommands = ProjectCommands;

// Killed at a write: the same on every machine. OSTRAKA_EVERY_WRITE=1 tries each of them.
class CommandsKilledAtAWrite : public ProjectCommands {
 protected:
  template <class Prepare, class Done>
  void leaveNothingUnfinished(const std::vector<std::string>& command, const fs::path& target,
                              Prepare prepare, Done done) {
    prepare();
    const long writes = writesOf(target, command, errors());
    int killed = 0;
    for (const long before : roomsBelow(writes, 6)) {
      SCOPED_TRACE("killed after " + std::to_string(before) + " of " + std::to_string(writes));
      prepare();
      ASSERT_EQ(runKilledAfter(before, target, command, errors()).status, -1);
      const Ended again = run(command);
      if (again.status != 2) expectDone(again);  // 2: it was whole when it was killed
      done();
      for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
        EXPECT_NE(entry.path().extension(), ".partial") << entry.path();
      if (HasFailure()) return;
      ++killed;
    }
    std::printf("%s %s: killed at %d of %ld writes\n", command[0].c_str(), command[1].c_str(),
                killed, writes);
  }
};

TEST_F(CommandsKilledAtAWrite, AnImportLeavesNothingUnfinishedWhenItIsGivenAgain) {
  ASSERT_TRUE(exportTo("export", all));
  expectDone(run({"catalogue", "new", "--output", at("empty"), "--code", "ARM"}));
  leaveNothingUnfinished(
      {"catalogue", "import", at("work"), at("export"), "--enter"}, at("work/batches"),
      [&] { copy("empty", "work"); }, [&] { expectWhole("work", 3); });
}

TEST_F(CommandsKilledAtAWrite, ARestoreLeavesNothingUnfinishedWhenItIsGivenAgain) {
  expectDone(run({"catalogue", "archive", at("project"), "--output", at("archive")}));
  leaveNothingUnfinished(
      {"catalogue", "restore", at("archive"), "--output", at("out")}, at("out"),
      [&] { fs::remove_all(at("out")); }, [&] { expectWhole("out", 3); });
}

TEST_F(CommandsKilledAtAWrite, AnExportLeavesNothingUnfinishedWhenItIsGivenAgain) {
  leaveNothingUnfinished(
      {"catalogue", "export", at("project"), "--output", at("out"), "--forms",
       "csv,json,photographs,ply"},
      at("out"), [&] { fs::remove_all(at("out")); },
      [&] { EXPECT_TRUE(fs::exists(at("out/bagit.txt"))); });
}

TEST_F(KilledCommands, ANewProjectIsMadeBySayingItAgain) {
  killRepeatedly(
      {"catalogue", "new", "--output", at("new"), "--code", "ARM"}, errors(),
      [&] { fs::remove_all(at("new")); },
      [&] {
        if (upkeep::Project::isProject(at("new"))) expectReadable("new");
      },
      [&](const Ended& again) {
        // One that was whole when it was killed is there.
        if (again.status == 2)
          EXPECT_NE(again.errors.find("needs a new or empty folder"), std::string::npos);
        else
          expectDone(again);
        expectWhole("new", 0);
      });
}

TEST_F(KilledCommands, ATableEntersWholeRowsAndTheRestBySayingItAgain) {
  project_.reset();
  tableOf(600);
  killRepeatedly(
      {"catalogue", "import", at("work"), at("table.csv"), "--enter"}, errors(),
      [&] { copy("project", "work"); }, [&] { expectReadable("work"); },
      [&](const Ended& again) {
        expectDone(again);
        expectWhole("work", 603);
      });
}

TEST_F(KilledCommands, AnExportEntersOnceBySayingItAgain) {
  ASSERT_TRUE(exportTo("export", all));
  expectDone(run({"catalogue", "new", "--output", at("empty"), "--code", "ARM"}));
  killRepeatedly(
      {"catalogue", "import", at("work"), at("export"), "--enter"}, errors(),
      [&] { copy("empty", "work"); }, [&] { expectReadable("work"); },
      [&](const Ended& again) {
        expectDone(again);
        expectWhole("work", 3);
        expectDone(run({"catalogue", "check", at("work")}));
      });
}

TEST_F(KilledCommands, AnExportIsWholeBySayingItAgain) {
  const std::vector<std::string> command{"catalogue",
                                         "export",
                                         at("project"),
                                         "--output",
                                         at("out"),
                                         "--forms",
                                         "csv,drawings,glb,json,obj,ods,photographs,pictures,ply"};
  killedWithTheSameBytes({command, at("out"), errors()}, "bagit.txt");
}

TEST_F(KilledCommands, AnArchiveIsWholeBySayingItAgain) {
  const std::vector<std::string> command{"catalogue", "archive", at("project"), "--output",
                                         at("out")};
  killedWithTheSameBytes({command, at("out"), errors()}, "bagit.txt");
}

TEST_F(KilledCommands, AnArchiveIsRestoredBySayingItAgain) {
  expectDone(run({"catalogue", "archive", at("project"), "--output", at("archive")}));
  killRepeatedly(
      {"catalogue", "restore", at("archive"), "--output", at("out")}, errors(),
      [&] { fs::remove_all(at("out")); },
      [&] {
        if (fs::exists(at("out"))) expectDone(run({"catalogue", "check", at("out")}));
      },
      [&](const Ended& again) {
        if (again.status != 2) expectDone(again);  // 2: it was whole when it was killed
        expectWhole("out", 3);
        expectDone(run({"catalogue", "check", at("out")}));
      });
}

TEST_F(KilledCommands, ResultsEnterOnceBySayingItAgain) {
  computeAgain();
  project_.reset();
  killRepeatedly(
      {"catalogue", "enter", at("work"), "B0001"}, errors(), [&] { copy("project", "work"); },
      [&] { expectReadable("work"); },
      [&](const Ended& again) {
        expectDone(again);
        expectWhole("work", 3);
        expectDone(run({"catalogue", "check", at("work")}));
      });
}

TEST_F(KilledCommands, ACheckLeavesWholeBackupsOnly) {
  project_.reset();
  const std::string content = *catalogue::contentOf(at("project"));
  const auto backups_are_whole = [&] {
    for (const fs::path& backup : upkeep::backupsOf(at("work"), 1000LL * std::time(nullptr))) {
      fs::remove_all(at("back"));
      fs::create_directories(at("back"));
      fs::copy(backup, at("back/catalogue.sqlite"));
      const Result<std::string> kept = catalogue::contentOf(at("back"));
      EXPECT_TRUE(kept && *kept == content) << backup;
    }
  };
  killRepeatedly(
      {"catalogue", "check", at("work")}, errors(), [&] { copy("project", "work"); },
      backups_are_whole,
      [&](const Ended& again) {
        expectDone(again);
        expectWhole("work", 3);
        EXPECT_FALSE(upkeep::backupsOf(at("work"), 1000LL * std::time(nullptr)).empty());
        backups_are_whole();
      });
}

TEST_F(KilledCommands, ADamagedCatalogueIsRepairedBySayingItAgain) {
  const std::string content = damagedCopy(3, 3);  // more than a bit in each page: from the backup
  killRepeatedly(
      {"catalogue", "repair", at("work")}, errors(), [&] { copy("damaged", "work"); },
      [&] {
        const Result<std::string> now = catalogue::contentOf(at("work"));
        EXPECT_TRUE(!now || *now == content) << "neither damaged nor as it was";
      },
      [&](const Ended& again) {
        EXPECT_NE(again.status, 2) << again.errors;
        expectWhole("work", 3);
        const Result<std::string> now = catalogue::contentOf(at("work"));
        EXPECT_TRUE(now && *now == content);
      });
}

}  // namespace
}  // namespace ostraka::test
