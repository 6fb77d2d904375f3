// A project on a disk, or of a person, where nothing may be written.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "catalogue/database.h"
#include "small_project.h"

namespace ostraka::catalogue {
namespace {

namespace fs = std::filesystem;

class ReadOnlyProject : public SmallProject {
 protected:
  fs::path folder() const { return folder_.path() / "project"; }

  // Nobody may write there: permissions for others, and a process of another person where this one
  // is root. What it says is its exit status.
  template <class Look>
  int asSomebodyElse(Look look) {
    ::chmod(folder_.path().c_str(), 0755);
    for (const auto& entry : fs::recursive_directory_iterator(folder()))
      ::chmod(entry.path().c_str(), entry.is_directory() ? 0555 : 0444);
    ::chmod(folder().c_str(), 0555);
    const fs::path room = folder_.path() / "tmp";
    fs::create_directory(room);
    ::chmod(room.c_str(), 0777);
    const pid_t child = ::fork();
    if (child == 0) {
      constexpr uid_t kNobody = 65534;
      if (::geteuid() == 0 && (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)) ::_exit(100);
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
    const Result<Project> open = Project::open(folder);
    if (!open) return std::fprintf(stderr, "%s\n", open.error().sentence().c_str()), 1;
    if (!open->catalogue().readOnly()) return 2;
    const Result<std::vector<SherdRow>> rows = open->catalogue().sherdRows({}, {});
    if (!rows || rows->size() != sherds) return 3;
    if (!open->catalogue().checkIntegrity()) return 4;
    const Result<Catalogue> other = open->connect();
    return other && other->sherds(*rows) ? 0 : 5;
  }
};

TEST_F(ReadOnlyProject, IsLookedAtAndChecked) {
  for (int i = 0; i < 5; ++i) numbered(context12);
  project_.reset();
  EXPECT_EQ(asSomebodyElse([&] { return look(folder(), 5); }), 0);
}

TEST_F(ReadOnlyProject, SaysWhatAKilledProcessSavedLast) {
  const fs::path place = folder();
  project_.reset();
  const pid_t child = ::fork();
  if (child == 0) {
    project_ = std::make_unique<Project>(*Project::open(place));
    for (int i = 0; i < 5; ++i) numbered(context12);
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_GT(fs::file_size(place / "catalogue.sqlite-wal"), 0u);
  fs::remove(place / "catalogue.sqlite-shm");
  EXPECT_EQ(asSomebodyElse([&] { return look(place, 5); }), 0);
}

TEST_F(ReadOnlyProject, IsReadBesideAProgramThatWritesToIt) {
  for (int i = 0; i < 5; ++i) numbered(context12);
  EXPECT_EQ(asSomebodyElse([&] { return look(folder(), 5); }), 0);
}

TEST_F(ReadOnlyProject, RefusesChangesInASentence) {
  const SherdRow sherd = numbered(context12);
  project_.reset();
  EXPECT_EQ(asSomebodyElse([&] {
              Project open = valueIn(Project::open(folder()));
              const FieldChange change{sherd, "ware", "grey"};
              const auto changed = open.catalogue().change(std::span(&change, 1), {});
              if (changed || changed.error().code != ErrorCode::CannotWrite) return 1;
              return open.backUp() ? 2 : 0;
            }),
            0);
}

TEST_F(ReadOnlyProject, OfAnOlderVersionAsksForACopy) {
  project_->catalogue().database().script("PRAGMA user_version = 7");
  project_.reset();
  EXPECT_EQ(asSomebodyElse([&] {
              const Result<Project> open = Project::open(folder());
              return !open && open.error().what.find("older Ostraka") != std::string::npos ? 0 : 1;
            }),
            0);
}

}  // namespace
}  // namespace ostraka::catalogue
