// A repair reads the file under what its WAL holds, the first page, too.
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "catalogue/settings.h"
#include "store/page_checksums.h"
#include "store/wal_content.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"
#include "upkeep/repair.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class RepairWal : public catalogue::SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
  fs::path wal() const { return file().string() + "-wal"; }
  // Its transactions stay in the WAL.
  template <class Work>
  void inAKilledProcess(Work work) {
    project_.reset();
    const pid_t child = ::fork();
    if (child == 0) {
      project_ = std::make_unique<Project>(*Project::open(folder()));
      work();
      ::_exit(0);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  std::set<std::uint32_t> pagesOfWal() const {
    const std::string bytes = catalogue::bytesOf(wal());
    const auto read = [&](unsigned char* to, std::size_t count, std::int64_t from) {
      return bytes.copy(reinterpret_cast<char*>(to), count, static_cast<std::size_t>(from)) ==
             count;
    };
    std::set<std::uint32_t> pages;
    for (const store::WalFrame& frame :
         store::readWal(read, static_cast<std::int64_t>(bytes.size())).frames)
      pages.insert(frame.page);
    return pages;
  }
  void destroyTheFirstPage() const {
    std::string bytes = catalogue::bytesOf(file());
    std::fill_n(bytes.begin(), store::kPageBytes, '\x5A');
    catalogue::writeBytes(file(), bytes);
  }
  RepairReport repaired() {
    return catalogue::valueIn(
        repairCatalogue(folder(), quiet_, {}, [this] { return now_ms += 1; }));
  }
  QuietProgress quiet_;
};

TEST_F(RepairWal, GivesADestroyedFirstPageBackAndNeedsNoBackup) {
  inAKilledProcess([&] {
    for (int i = 0; i < 40; ++i)
      EXPECT_TRUE(set(numbered(context12), "note", std::string(60, 'n')));
  });
  ASSERT_TRUE(pagesOfWal().contains(1));
  const std::string main = catalogue::bytesOf(file()), saved = catalogue::bytesOf(wal());
  const std::string content = *catalogue::contentOf(folder());
  fs::remove_all(folder() / "backups");
  catalogue::writeBytes(file(), main);
  catalogue::writeBytes(wal(), saved);
  destroyTheFirstPage();
  ASSERT_FALSE(Project::open(folder()));
  const RepairReport report = repaired();
  EXPECT_FALSE(report.damaged.empty());
  EXPECT_EQ(report.pages_lost, 0);
  EXPECT_TRUE(report.backup.empty());
  EXPECT_TRUE(report.rows.empty());
  EXPECT_EQ(*catalogue::contentOf(folder()), content);
  EXPECT_EQ(catalogue::bytesOf(report.damaged.string() + "-wal"), saved) << "it is kept";
}

TEST_F(RepairWal, IsReadWhereTheFirstPageComesFromABackup) {
  numbered(context12);
  const fs::path backup = *project_->backUp();
  inAKilledProcess([&] { catalogue().database().script("UPDATE project SET title = 'Grand'"); });
  ASSERT_FALSE(pagesOfWal().empty());
  ASSERT_FALSE(pagesOfWal().contains(1));
  destroyTheFirstPage();
  const RepairReport report = repaired();
  EXPECT_EQ(report.pages_lost, 1);
  EXPECT_EQ(report.backup, backup);
  EXPECT_FALSE(report.all_from_backup);
  EXPECT_TRUE(report.rows.empty());
  EXPECT_TRUE(catalogue::contentOf(folder()));
  const Project open = catalogue::valueIn(Project::open(folder()));
  EXPECT_EQ(catalogue::Settings(open.catalogue()).project()->title, "Grand");
}

}  // namespace
}  // namespace ostraka::upkeep
