// A project on a disk, or of a person, where nothing may be written.
#include <linux/capability.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "small_project.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

namespace fs = std::filesystem;

class ReadOnlyProject : public SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }

  // Nobody may write there: no permission for anybody, and a process without the privileges that
  // would let root write all the same. It stays the same person and may still look everywhere,
  // since the folders above may be closed to others. What it says is its exit status.
  template <class Look>
  int withoutPrivileges(Look look) {
    ::chmod(folder_.path().c_str(), 0755);
    for (const auto& entry : fs::recursive_directory_iterator(folder()))
      ::chmod(entry.path().c_str(), entry.is_directory() ? 0555 : 0444);
    ::chmod(folder().c_str(), 0555);
    const fs::path room = folder_.path() / "tmp";
    fs::create_directory(room);
    ::chmod(room.c_str(), 0777);
    const pid_t child = ::fork();
    if (child == 0) {
      __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
      __user_cap_data_struct kept[_LINUX_CAPABILITY_U32S_3]{};
      if (::syscall(SYS_capget, &header, kept) != 0) ::_exit(100);
      const __u32 reading = kept[0].permitted & CAP_TO_MASK(CAP_DAC_READ_SEARCH);
      kept[0] = {reading, reading, 0};
      kept[1] = {0, 0, 0};
      if (::syscall(SYS_capset, &header, kept) != 0) ::_exit(100);
      ::setenv("TMPDIR", room.c_str(), 1);
      ::_exit(look());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    for (const auto& entry : fs::recursive_directory_iterator(folder()))
      if (entry.is_directory()) ::chmod(entry.path().c_str(), 0755);
    ::chmod(folder().c_str(), 0755);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  static int look(const fs::path& folder, std::size_t sherds) {
    const Result<upkeep::Project> open = upkeep::Project::open(folder);
    if (!open) return std::fprintf(stderr, "%s\n", open.error().sentence().english().c_str()), 1;
    if (!open->catalogue().readOnly()) return 2;
    const Result<std::vector<store::SherdRow>> rows =
        sherds::Sherds(open->catalogue()).rows({}, {});
    if (!rows || rows->size() != sherds) return 3;
    if (!open->catalogue().checkIntegrity()) return 4;
    const Result<Catalogue> other = upkeep::Project::connect(open->folder());
    return other && sherds::Sherds(*other).of(*rows) ? 0 : 5;
  }
};

TEST_F(ReadOnlyProject, IsLookedAtAndChecked) {
  for (int i = 0; i < 5; ++i) numbered(context12);
  project_.reset();
  EXPECT_EQ(withoutPrivileges([&] { return look(folder(), 5); }), 0);
}

TEST_F(ReadOnlyProject, SaysWhatAKilledProcessSavedLast) {
  const fs::path place = folder();
  project_.reset();
  const pid_t child = ::fork();
  if (child == 0) {
    project_ = std::make_unique<upkeep::Project>(*upkeep::Project::open(place));
    for (int i = 0; i < 5; ++i) numbered(context12);
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_GT(fs::file_size(place / "catalogue.sqlite-wal"), 0u);
  fs::remove(place / "catalogue.sqlite-shm");
  EXPECT_EQ(withoutPrivileges([&] { return look(place, 5); }), 0);
}

TEST_F(ReadOnlyProject, IsReadBesideAProgramThatWritesToIt) {
  for (int i = 0; i < 5; ++i) numbered(context12);
  EXPECT_EQ(withoutPrivileges([&] { return look(folder(), 5); }), 0);
}

TEST_F(ReadOnlyProject, RefusesChangesInASentence) {
  const store::SherdRow sherd = numbered(context12);
  project_.reset();
  EXPECT_EQ(withoutPrivileges([&] {
              upkeep::Project open = valueIn(upkeep::Project::open(folder()));
              const records::FieldChange change{sherd, "ware", "grey"};
              const auto changed =
                  sherds::SherdChanges(open.catalogue()).apply(std::span(&change, 1), {});
              if (changed || changed.error().code != ErrorCode::CannotWrite) return 1;
              return open.backUp() ? 2 : 0;
            }),
            0);
}

}  // namespace
}  // namespace ostraka::catalogue
