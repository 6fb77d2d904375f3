#include "archive/archive.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <map>

#include "archive/bag_reader.h"
#include "base/text.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "catalogue/queue_pause.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "tests/core/exchange/exported_project.h"
#include "tests/core/exchange/mended_bag.h"
#include "upkeep/archived_project.h"
#include "upkeep/repair.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;

class Archive : public exchange::ExportedProject {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  Result<Archived> archive(DamagedFiles damaged = DamagedFiles::Refuse) {
    return archiveProject(*project_, {at("archive"), "ostraka 1.0.0", damaged}, quiet, {});
  }
  Result<Restored> restore() { return restoreProject(at("archive"), at("laptop"), quiet, {}); }
};

// Nothing larger can be written while it is there: a write fails in the middle, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t most_bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    struct rlimit small = before_;
    small.rlim_cur = most_bytes;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  struct rlimit before_ {};
  void (*handler_)(int) = nullptr;
};

TEST_F(Archive, OnAnEmptyLaptopIsTheSameProject) {
  const Result<Archived> archived =
      archiveProject(*project_, {at("archive") / "", "ostraka 1.0.0"}, quiet, {});
  ASSERT_TRUE(archived) << archived.error().sentence();
  EXPECT_TRUE(archived->sealed);
  EXPECT_TRUE(archived->damage.empty());
  const Result<Restored> restored = restoreProject(at("archive"), at("laptop") / "", quiet, {});
  ASSERT_TRUE(restored) << restored.error().sentence();
  EXPECT_TRUE(restored->damage.empty());
  Result<upkeep::Project> laptop = upkeep::Project::open(at("laptop"));
  ASSERT_TRUE(laptop) << laptop.error().sentence();
  EXPECT_EQ(History(laptop->catalogue()).length(), History(catalogue()).length());
  EXPECT_EQ(sherds::Sherds(laptop->catalogue()).get(rows[0])->note,
            sherds::Sherds(catalogue()).get(rows[0])->note);
  for (const records::FileRecord& file : valueIn(Files(catalogue()).all()))
    EXPECT_EQ(sha256(*readFile(laptop->folder() / file.path)), file.sha256) << file.path;
  EXPECT_FALSE(restore()) << "never over a project";
  const Result<Restored> project = restoreProject(at("laptop"), at("again"), quiet, {});
  ASSERT_FALSE(project);
  EXPECT_NE(project.error().what.english().find("a project already"), std::string::npos);
  EXPECT_FALSE(archiveProject(*project_, {project_->folder() / "inside"}, quiet, {}));
}

TEST_F(Archive, SaysWhatItIsAndHowItIsRestored) {
  ASSERT_TRUE(archive());
  const std::string day = utcDay(catalogue().now());
  EXPECT_THAT(*readFile(at("archive/bag-info.txt")),
              testing::HasSubstr("Bagging-Date: " + day + "\n"));
  const std::string read_me = *readFile(at("archive/README.txt"));
  EXPECT_THAT(read_me, testing::HasSubstr(", made " + day + " by ostraka 1.0.0\n"));
  EXPECT_THAT(read_me, testing::HasSubstr("ostraka catalogue restore"));
  ASSERT_TRUE(restore());
  EXPECT_FALSE(fs::exists(at("laptop/README.txt"))) << "it is about the archive";
}

TEST_F(Archive, ComesBackWithItsQueuePausedWhereABatchWaits) {
  const auto restoredAs = [&](const std::string& name, records::BatchState state) {
    EXPECT_TRUE(Batches(catalogue()).setState(batch, state, anna));
    EXPECT_TRUE(archiveProject(*project_, {at(name + "-archive"), "ostraka 1.0.0"}, quiet, {}));
    EXPECT_TRUE(restoreProject(at(name + "-archive"), at(name), quiet, {}));
    return upkeep::Project::open(at(name));
  };
  const auto done = restoredAs("done", records::BatchState::Done);
  EXPECT_EQ(valueIn(queuePause(done->catalogue())), QueuePause::None);
  EXPECT_EQ(valueIn(batchesInQueue(done->catalogue())), 0);
  auto waits = restoredAs("waits", records::BatchState::Queued);
  EXPECT_EQ(valueIn(batchesInQueue(waits->catalogue())), 1);
  EXPECT_EQ(valueIn(queuePause(waits->catalogue())), QueuePause::Restored);
  EXPECT_EQ(valueIn(queuePause(catalogue())), QueuePause::None) << "it goes on where it was";
  ASSERT_TRUE(setQueuePause(waits->catalogue(), QueuePause::None, anna));
  EXPECT_EQ(valueIn(queuePause(waits->catalogue())), QueuePause::None);
}

// As a capture or a computation that was killed leaves it.
TEST_F(Archive, TakesNoLockAlong) {
  for (const char* folder : {"", "batches/B0001", "results/B0001/work", "models/B0001"})
    put(project_->folder() / folder / "lock", "");
  put(project_->folder() / "imported/lock/model.ply", "ply");
  ASSERT_TRUE(archive());
  for (const auto& entry : fs::recursive_directory_iterator(at("archive")))
    EXPECT_FALSE(entry.is_regular_file() && entry.path().filename() == "lock") << entry.path();
  EXPECT_TRUE(fs::exists(at("archive/data/imported/lock/model.ply")))
      << "of an export that was called so";
}

// Not even by one who only looks at the catalogue in it.
TEST_F(Archive, IsNotOpenedAsAProjectAndCanStillBeRestored) {
  ASSERT_TRUE(archive());
  fs::create_directory_symlink(at("archive/data"), at("link"));
  fs::create_directories(at("beside"));
  fs::create_symlink(at("archive/data/catalogue.sqlite"), at("beside/catalogue.sqlite"));
  for (const char* name : {"archive/data", "archive/data/", "link", "beside", "archive"}) {
    const Result<upkeep::Project> opened = upkeep::Project::open(at(name));
    ASSERT_FALSE(opened) << name;
    EXPECT_EQ(opened.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(opened.error().what.english().find("restore the archive"), std::string::npos)
        << opened.error().sentence();
    EXPECT_EQ(upkeep::archiveAt(at(name)), fs::canonical(at("archive"))) << name;
    EXPECT_FALSE(upkeep::Project::connect(at(name))) << name;
    const auto repaired = upkeep::repairCatalogue(at(name), quiet, {});
    ASSERT_FALSE(repaired) << name;
    EXPECT_EQ(repaired.error().what, opened.error().what);
  }
  const Result<Restored> restored = restore();
  EXPECT_TRUE(restored) << restored.error().sentence();
  for (const fs::path& project : {at("laptop"), project_->folder(), at("")})
    EXPECT_EQ(upkeep::archiveAt(project), fs::path()) << project;
}

TEST_F(Archive, LeavesOutWhatBelongsToAWindowThatHasTheProjectOpen) {
  put(project_->folder() / ".ostraka.lock", "4711");
  put(project_->folder() / "lock", "");
  put(project_->folder() / "notes.txt", "mine");
  fs::create_directories(project_->folder() / "cluster/log");
  put(project_->folder() / "cluster/tasks.json", "{}");
  put(project_->folder() / "cluster/log/job.1.txt", "");
  ASSERT_TRUE(
      upkeep::checkFiles(catalogue(), project_->folder(), upkeep::CheckDepth::Hashes, quiet, {}));
  ASSERT_TRUE(archive());
  ASSERT_TRUE(restore());
  EXPECT_TRUE(fs::exists(at("laptop/notes.txt")));
  EXPECT_FALSE(fs::exists(at("laptop/.ostraka.lock")));
  EXPECT_FALSE(fs::exists(at("laptop/lock")));
  EXPECT_FALSE(fs::exists(at("laptop/file-checks.txt")));
  EXPECT_FALSE(fs::exists(at("laptop/cluster")));
}

TEST_F(Archive, IsNotSealedWhereWhatPeopleSaidOfABatchCannotBeRead) {
  const fs::path results = project_->folder() / "results/B0001";
  fs::create_directories(results);
  put(results / "report.json", "{}");
  put(results / "mask_strokes.json", "[{");
  records::FileRecord report;
  report.path = "results/B0001/report.json";
  report.role = "report";
  report.media_type = "application/json";
  report.sha256 = sha256("{}");
  report.bytes = 2;
  report.batch = catalogue::Batches(catalogue()).byNumber("B0001")->row;
  ASSERT_TRUE(catalogue::Files(catalogue()).save(report, anna));
  const Result<Archived> archived = archive();
  ASSERT_TRUE(archived) << archived.error().sentence();
  EXPECT_FALSE(archived->sealed);
  ASSERT_EQ(archived->damage.size(), 1u);
  EXPECT_EQ(archived->damage[0].file.path, "results/B0001/mask_strokes.json");
}

TEST_F(Archive, WithDamageIsNotSealedAndLeavesNothing) {
  put(modelOf(0), "one bit another");
  fs::remove(pictureOf(1));
  fs::remove(project_->folder() / "batches/B0001/front/cam0_pos00.jpg");
  fs::create_symlink("/etc/hostname", project_->folder() / "batches/B0001/front/cam0_pos00.jpg");
  const Result<Archived> refused = archive();
  ASSERT_TRUE(refused) << refused.error().sentence();
  EXPECT_FALSE(refused->sealed);
  ASSERT_EQ(refused->damage.size(), 3u);
  EXPECT_EQ(refused->damage[0].damage, upkeep::Damage::Missing) << "a link is no photograph";
  EXPECT_EQ(refused->damage[0].file.batch, "B0001");
  // In the order of their folders, which are named by what the models hold.
  std::map<std::string, upkeep::Damage> sherds;
  for (const upkeep::DamagedFile& damaged : {refused->damage[1], refused->damage[2]})
    sherds[damaged.file.sherd] = damaged.damage;
  EXPECT_EQ(sherds, (std::map<std::string, upkeep::Damage>{
                        {"ARM1-T3-0012-0001", upkeep::Damage::Changed},
                        {"ARM1-T3-0012-0002", upkeep::Damage::Missing}}));
  EXPECT_FALSE(fs::exists(at("archive")));
  EXPECT_FALSE(fs::exists(at("archive.partial")));
}

// The project goes on changing while its files are copied.
class AtTheFirstFile final : public Progress {
 public:
  explicit AtTheFirstFile(std::function<void()> act) : act_(std::move(act)) {}
  void report(std::int64_t, std::int64_t) override {
    if (act_) std::exchange(act_, {})();
  }
  void note(NoteLevel, const Message&) override {}

 private:
  std::function<void()> act_;
};

TEST_F(Archive, HoldsItsFilesAgainstTheCatalogueThatItHolds) {
  records::FileRecord late;
  late.path = "batches/B0001/front/late.jpg";
  late.role = "photo";
  late.batch = batch;
  AtTheFirstFile entering([&] {
    put(project_->folder() / late.path, "late");
    late.sha256 = sha256("late");
    late.bytes = 4;
    ASSERT_TRUE(Files(catalogue()).save(late, anna));
  });
  const Result<Archived> archived =
      archiveProject(*project_, {at("archive"), "ostraka 1.0.0"}, entering, {});
  ASSERT_TRUE(archived) << archived.error().sentence();
  EXPECT_TRUE(archived->sealed) << "what entered meanwhile is not missing: it is not in it";
  EXPECT_TRUE(archived->damage.empty());
  ASSERT_TRUE(restore());
  const Result<upkeep::Project> laptop = upkeep::Project::open(at("laptop"));
  ASSERT_TRUE(laptop);
  EXPECT_EQ(valueIn(Files(laptop->catalogue()).all()).size() + 1,
            valueIn(Files(catalogue()).all()).size());
}

TEST_F(Archive, SealedWithDamageListsItInsideAndWhenItComesBack) {
  put(modelOf(0), "one bit another");
  const Result<Archived> sealed = archive(DamagedFiles::Seal);
  ASSERT_TRUE(sealed) << sealed.error().sentence();
  EXPECT_TRUE(sealed->sealed);
  ASSERT_EQ(sealed->damage.size(), 1u);
  const std::string sentence = upkeep::sentenceOf(sealed->damage[0]);
  EXPECT_EQ(*readFile(at("archive/damage.txt")), sentence + "\n");
  const std::string command =
      "cd '" + at("archive").string() +
      "' && sha256sum --quiet --strict -c manifest-sha256.txt tagmanifest-sha256.txt";
  EXPECT_EQ(std::system(command.c_str()), 0);
  const Result<Restored> restored = restore();
  ASSERT_TRUE(restored) << restored.error().sentence();
  EXPECT_THAT(restored->damage, testing::ElementsAre(sentence));
  // A list that was taken away is noticed.
  fs::remove_all(at("laptop"));
  fs::remove(at("archive/damage.txt"));
  EXPECT_FALSE(restore());
}

TEST_F(Archive, LeavesFilesOfOthersAloneThatBearItsUnfinishedNames) {
  for (const char* mine :
       {"archive.partial/letter.txt", "archive.sqlite.partial", "laptop.partial/letter.txt"})
    put(at(mine), "mine");
  EXPECT_FALSE(archive());
  EXPECT_EQ(*readFile(at("archive.partial/letter.txt")), "mine");
  fs::remove_all(at("archive.partial"));
  ASSERT_TRUE(archive());
  EXPECT_EQ(*readFile(at("archive.sqlite.partial")), "mine");
  EXPECT_FALSE(restore());
  EXPECT_EQ(*readFile(at("laptop.partial/letter.txt")), "mine");
  fs::remove_all(at("laptop.partial"));
  EXPECT_TRUE(restore());
}

TEST_F(Archive, OnAFullDiskNamesTheArchiveAndLeavesNothing) {
  const std::string photograph(std::size_t{3} << 20, 'p');
  put(project_->folder() / "batches/B0001/front/cam0_pos01.jpg", photograph);
  for (const rlim_t most_bytes : {rlim_t{2} << 20, rlim_t{64} << 10}) {
    const Result<Archived> full = [&] {
      const FullDisk disk(most_bytes);
      return archive();
    }();
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().code, ErrorCode::CannotWrite);
    EXPECT_THAT(full.error().where, testing::StartsWith(at("archive").string())) << most_bytes;
    EXPECT_FALSE(fs::exists(at("archive")));
    EXPECT_FALSE(fs::exists(at("archive.partial")));
    EXPECT_FALSE(fs::exists(at("archive.sqlite.partial")));
  }
  ASSERT_TRUE(archive());
  const Result<Restored> full = [&] {
    const FullDisk disk(rlim_t{2} << 20);
    return restore();
  }();
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().code, ErrorCode::CannotWrite);
  EXPECT_THAT(full.error().where, testing::StartsWith(at("laptop").string()));
  EXPECT_FALSE(fs::exists(at("laptop.partial")));
}

TEST_F(Archive, AnExportOnAFullDiskNamesTheExport) {
  put(project_->folder() / "batches/B0001/front/cam0_pos00.jpg",
      std::string(std::size_t{3} << 20, 'p'));
  const FullDisk disk(rlim_t{2} << 20);
  const Result<exchange::Exported> full =
      exportTo("out", {exchange::Form::Json, exchange::Form::Photographs});
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().code, ErrorCode::CannotWrite);
  EXPECT_THAT(full.error().where, testing::StartsWith(at("out").string()));
}

// Calls back with how often it was asked, to provenance between the check of a bag and its use.
class Between final : public Progress {
 public:
  explicit Between(std::function<void(int)> provenance) : provenance_(std::move(provenance)) {}
  void report(std::int64_t, std::int64_t) override { provenance_(++times_); }
  void note(NoteLevel, const Message&) override {}

 private:
  std::function<void(int)> provenance_;
  int times_ = 0;
};

TEST_F(Archive, TakesNoFileThatTookThePlaceOfACheckedOne) {
  ASSERT_TRUE(archive());
  put(at("secret"), "PRIVATE KEY");
  const fs::path photograph = at("archive/data/batches/B0001/front/cam0_pos00.jpg");
  const auto files = static_cast<int>(exchange::MendedBag(at("archive")).payload.size());
  const std::vector<std::function<void()>> swaps = {
      [&] { fs::create_symlink(at("secret"), photograph); },
      [&] { put(photograph, "another JPEG"); },
      [&] {
        fs::rename(photograph.parent_path(), at("front"));
        fs::create_directory_symlink(folder_.path(), photograph.parent_path());
      }};
  for (const auto& swap : swaps) {
    Between between([&](int times) {
      if (times != files + 1) return;  // all hashes agreed
      fs::remove(photograph);
      swap();
    });
    const Result<Restored> restored = restoreProject(at("archive"), at("laptop"), between, {});
    ASSERT_FALSE(restored);
    EXPECT_EQ(restored.error().code, ErrorCode::UnusableInput);
    EXPECT_FALSE(fs::exists(at("laptop")));
    EXPECT_FALSE(fs::exists(at("laptop.partial")));
    fs::remove(photograph);
    if (fs::is_symlink(photograph.parent_path())) break;
    put(photograph, "JPEG");
  }
}

// Nobody who loses the laptop shall find out then that a folder was on another disk.
TEST_F(Archive, NamesLinksWhoseFilesItDoesNotHold) {
  fs::create_directories(at("large disk"));
  put(at("large disk") / "calib.jpg", "a board");
  fs::create_directory_symlink(at("large disk"), project_->folder() / "batches/B0001/calib");
  const Result<Archived> refused = archive();
  ASSERT_TRUE(refused) << refused.error().sentence();
  EXPECT_FALSE(refused->sealed);
  EXPECT_TRUE(refused->damage.empty());
  EXPECT_EQ(refused->links, std::vector<std::string>{"batches/B0001/calib"});
  EXPECT_FALSE(fs::exists(at("archive")));
  ASSERT_TRUE(archive(DamagedFiles::Seal)->sealed);
  EXPECT_NE(readFile(at("archive/damage.txt"))->find("batches/B0001/calib is a link"),
            std::string::npos);
}

TEST_F(Archive, BringsNoFindingsOfElsewhereAlong) {
  ASSERT_TRUE(archive());
  exchange::MendedBag bag(at("archive"));
  bag.put("data/file-checks.txt", "4102444800000 begin\n");
  bag.mend();
  ASSERT_TRUE(restore());
  EXPECT_FALSE(fs::exists(at("laptop/file-checks.txt")));
}

}  // namespace
}  // namespace ostraka::archive
