#include "upkeep/project.h"

#include <fcntl.h>

#include <chrono>
#include <fstream>
#include <stop_token>
#include <thread>

#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "files/open_folder.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

using ProjectFolder = catalogue::SmallProject;

TEST_F(ProjectFolder, HoldsTheFoldersThatTheProgramWorksIn) {
  for (const char* name : {"catalogue.sqlite", "batches", "results", "backups"})
    EXPECT_TRUE(fs::exists(project_->folder() / name)) << name;
  EXPECT_TRUE(Project::isProject(project_->folder()));
  EXPECT_FALSE(Project::isProject(folder_.path()));
  EXPECT_EQ(project_->batchFolder("B0001"), project_->folder() / "batches" / "B0001");
}

TEST_F(ProjectFolder, IsRemovedAsUnusedOnlyWhereNobodyWorkedInIt) {
  const fs::path folder = folder_.path() / "fresh";
  std::int64_t history = 0;
  {
    records::ProjectRecord record;
    record.code = "ARM";
    const Result<Project> fresh = Project::create(folder, record);
    ASSERT_TRUE(fresh) << fresh.error().sentence();
    history = catalogue::History(fresh->catalogue()).length();
    ASSERT_TRUE(fresh->backUp());
  }
  std::ofstream(folder / "batches" / "notes.txt") << "a person's";
  EXPECT_FALSE(*Project::removeUnused(folder, history));
  fs::remove(folder / "batches" / "notes.txt");
  {
    const Result<Project> worked = Project::open(folder);
    ASSERT_TRUE(worked);
    ASSERT_TRUE(catalogue::Settings(worked->catalogue()).setValue("key", "value", {}));
  }
  EXPECT_FALSE(*Project::removeUnused(folder, history));
  EXPECT_TRUE(Project::isProject(folder));
  std::ofstream(folder / "catalogue.sqlite.old") << "a person's copy";
  EXPECT_FALSE(*Project::removeUnused(folder, history + 1));
  EXPECT_TRUE(fs::remove(folder / "catalogue.sqlite.old"));
  EXPECT_TRUE(*Project::removeUnused(folder, history + 1));
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(ProjectFolder, StaysWholeWhereOneOfItsFoldersCannotBeRead) {
  const fs::path folder = project_->folder();
  const std::int64_t history = catalogue::History(catalogue()).length();
  project_.reset();
  for (const char* name : {"batches", "results"}) {
    ASSERT_TRUE(fs::remove(folder / name));
    std::ofstream(folder / name) << "no folder";
    EXPECT_FALSE(Project::removeUnused(folder, history)) << name;
    EXPECT_TRUE(fs::exists(folder / name));
    EXPECT_TRUE(Project::isProject(folder));
    ASSERT_TRUE(fs::remove(folder / name));
    fs::create_directory(folder / name);
  }
}

TEST_F(ProjectFolder, TheCataloguesHeaderTellsItFromOtherDatabases) {
  project_.reset();
  std::ifstream file(folder_.path() / "project" / "catalogue.sqlite", std::ios::binary);
  std::string head(72, '\0');
  ASSERT_TRUE(file.read(head.data(), 72));
  EXPECT_EQ(head.substr(0, 15), "SQLite format 3");
  EXPECT_EQ(head.substr(68, 4), "OSTR") << "where packaging/ostraka-mime.xml looks for it";
}

TEST_F(ProjectFolder, OpensAgainWithWhatWasSaved) {
  const store::SherdRow sherd = numbered(context12);
  project_.reset();
  Result<Project> again = Project::open(folder_.path() / "project");
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(catalogue::Settings(again->catalogue()).project()->title, "Trial");
  EXPECT_EQ(sherds::Sherds(again->catalogue()).get(sherd)->number, "ARM1-T3-0012-0001");
  EXPECT_FALSE(catalogue::Settings(again->catalogue()).project()->id.empty());
}

struct Notes final : Progress {
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override { all.emplace_back(text.english()); }
  std::vector<std::string> all;
};

TEST_F(ProjectFolder, WaitsForARepairUntilAStopIsRequestedAndSaysForWhat) {
  project_.reset();
  const fs::path folder = folder_.path() / "project";
  const FileDescriptor file(::open((folder / "catalogue.sqlite").c_str(), O_RDWR | O_CLOEXEC));
  struct flock repair {};
  repair.l_type = F_WRLCK;
  repair.l_whence = SEEK_SET;
  repair.l_start = 0x40000000;
  repair.l_len = 512;
  ASSERT_EQ(::fcntl(file.get(), F_OFD_SETLK, &repair), 0);
  Notes notes;
  std::stop_source stop;
  std::thread person([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    stop.request_stop();
  });
  const auto begin = std::chrono::steady_clock::now();
  const Result<Project> stopped = Project::open(folder, {}, {stop.get_token(), &notes});
  person.join();
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled) << stopped.error().sentence();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  ASSERT_EQ(notes.all.size(), 1u);
  EXPECT_NE(notes.all[0].find("repairing"), std::string::npos);
  repair.l_type = F_UNLCK;
  ASSERT_EQ(::fcntl(file.get(), F_OFD_SETLK, &repair), 0);
  EXPECT_TRUE(Project::open(folder, {}, {{}, &notes}));
  EXPECT_EQ(notes.all.size(), 1u);
}

TEST_F(ProjectFolder, ThatIsRefusedIsNotWrittenTo) {
  catalogue().database().script("PRAGMA journal_mode = DELETE; CREATE TABLE mine (secret TEXT)");
  project_.reset();
  const fs::path folder = folder_.path() / "project";
  const std::string before = *readFile(folder / "catalogue.sqlite");
  const Result<Project> refused = Project::open(folder);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(*readFile(folder / "catalogue.sqlite"), before);
}

TEST_F(ProjectFolder, IsNotOpenedWhereABatchLeadsOutOfIt) {
  newBatch({bag4});
  for (const char* number : {"../../x", "/tmp/x", ".."}) {
    catalogue().database().script(std::string("UPDATE batch SET number = '") + number + "'");
    const Result<Project> again = Project::open(folder_.path() / "project");
    ASSERT_FALSE(again) << number;
    EXPECT_EQ(again.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(again.error().where, number);
  }
  catalogue().database().script("UPDATE batch SET number = 'CON'");
  EXPECT_TRUE(Project::open(folder_.path() / "project")) << "what was taken once stays open";
}

// Of a project that a stranger hands over: its export would take along what lies there.
TEST_F(ProjectFolder, IsNotOpenedWhereAPathOfTheCatalogueLeadsOutOfIt) {
  const store::SherdRow sherd = numbered(context12);
  const fs::path folder = project_->folder();
  for (const char* path : {"../secret.txt", "/etc/hostname", "models/../../secret.txt"}) {
    SCOPED_TRACE(path);
    catalogue().database().run("UPDATE sherd SET preview_path = ? WHERE row = ?", std::string(path),
                               sherd);
    const Result<Project> opened = Project::open(folder);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(opened.error().what.english().find(path), std::string::npos)
        << opened.error().sentence();
  }
  catalogue().database().run("UPDATE sherd SET preview_path = ''");
  EXPECT_TRUE(Project::open(folder));
}

TEST_F(ProjectFolder, AFolderThatHoldsSomethingIsNotTaken) {
  std::ofstream(folder_.path() / "file") << "x";
  records::ProjectRecord record;
  record.code = "ARM";
  const Result<Project> made = Project::create(folder_.path(), record);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::UnusableInput);
}

TEST_F(ProjectFolder, ACodeOrANumberingThatCannotBeUsedLeavesNoFolderBehind) {
  records::ProjectRecord record;
  record.code = "too long a code";
  EXPECT_FALSE(Project::create(folder_.path() / "new", record));
  EXPECT_FALSE(fs::exists(folder_.path() / "new"));
  record.code = "ARM";
  record.numbering = "{site}";
  EXPECT_FALSE(Project::create(folder_.path() / "new", record));
  EXPECT_FALSE(fs::exists(folder_.path() / "new"));
}

TEST_F(ProjectFolder, AnyFolderNameWillDo) {
  records::ProjectRecord record;
  record.code = "ARM";
  for (const char* name : {"mit Leerzeichen", "Գառնի %20 #1", "مشروع"}) {
    const Result<Project> made = Project::create(folder_.path() / name, record);
    ASSERT_TRUE(made) << name << made.error().sentence();
    EXPECT_TRUE(Project::open(folder_.path() / name)) << name;
  }
}

TEST_F(ProjectFolder, ACatalogueOfANewerProgramIsRefused) {
  {
    auto database = *store::Database::open(project_->folder() / "catalogue.sqlite",
                                           store::Database::Mode::ReadWrite);
    database->script("PRAGMA user_version = 99");
  }
  const Result<Project> newer = Project::open(project_->folder());
  ASSERT_FALSE(newer);
  EXPECT_NE(newer.error().what.english().find("newer Ostraka"), std::string::npos);
}

TEST_F(ProjectFolder, AFolderWithoutACatalogueAndAFileThatIsNoneAreRefused) {
  EXPECT_FALSE(Project::open(folder_.path()));
  fs::create_directories(folder_.path() / "other");
  std::ofstream(folder_.path() / "other" / "catalogue.sqlite") << std::string(5000, 'x');
  const Result<Project> opened = Project::open(folder_.path() / "other");
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().what.english().find("damaged"), std::string::npos)
      << opened.error().what;
}

TEST_F(ProjectFolder, AnotherThreadsConnectionSeesWhatWasSaved) {
  const Result<catalogue::Catalogue> other = Project::connect(project_->folder());
  ASSERT_TRUE(other) << other.error().sentence();
  const store::SherdRow sherd = numbered(context12);
  EXPECT_EQ(sherds::Sherds(*other).get(sherd)->number, "ARM1-T3-0012-0001");
}

TEST_F(ProjectFolder, ANewProjectsWordsHaveLabelsThatAreToldApart) {
  for (const char* name : {"part", "surface", "decoration", "manufacture", "firing", "condition"}) {
    const auto terms = catalogue::Settings(catalogue()).vocabulary(name);
    ASSERT_TRUE(terms.has_value());
    ASSERT_GE(terms->size(), 3u) << name;
    for (const char* language : {"de", "el", "es", "fr", "hy", "tr"}) {
      std::set<std::string> labels;
      for (const records::Term& term : *terms) {
        ASSERT_TRUE(term.labels.contains(language)) << name << " " << term.term;
        EXPECT_TRUE(labels.insert(store::uniqueKey(term.labels.at(language))).second)
            << name << " " << term.labels.at(language);
        for (const records::Term& other : *terms)  // nor is it another one's own word
          EXPECT_TRUE(&other == &term ||
                      store::uniqueKey(other.term) != store::uniqueKey(term.labels.at(language)))
              << name << " " << term.labels.at(language);
      }
    }
  }
  const store::SherdRow sherd = draft(context12);
  ASSERT_TRUE(set(sherd, "part", "Bord; col"));
  EXPECT_EQ(valueOf(sherd, "part"), "rim; neck");
}

TEST_F(ProjectFolder, AVocabularyKeepsTheTermsThatAreInUse) {
  const store::SherdRow sherd = draft(context12);
  ASSERT_TRUE(set(sherd, "firing", "reduced"));
  std::vector<records::Term> terms = *catalogue::Settings(catalogue()).vocabulary("firing");
  ASSERT_EQ(terms.size(), 3u);
  const Result<void> without =
      catalogue::Settings(catalogue()).setVocabulary("firing", {terms[0]}, anna);
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().what.english().find("'reduced': 1;"), std::string::npos);
  terms.push_back({"sandwich", {{"de", "Sandwichbrand"}}, "http://example.org/1"});
  ASSERT_TRUE(catalogue::Settings(catalogue()).setVocabulary("firing", terms, anna));
  EXPECT_EQ(catalogue::Settings(catalogue()).vocabulary("firing")->back().labels.at("de"),
            "Sandwichbrand");
  ASSERT_TRUE(set(sherd, "firing", "sandwichbrand")) << "a label means its term";
  EXPECT_EQ(valueOf(sherd, "firing"), "sandwich");
}

TEST_F(ProjectFolder, IsNotOpenedWithATriggerOfOthers) {
  const fs::path folder = project_->folder();
  catalogue().database().script(
      "CREATE TRIGGER evil AFTER INSERT ON history BEGIN UPDATE sherd SET ware = 'x'; END");
  project_.reset();
  const Result<Project> opened = Project::open(folder);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(opened.error().where, "trigger evil");
}

TEST_F(ProjectFolder, IsNotOpenedWithALinkInPlaceOfAFolder) {
  const fs::path folder = project_->folder();
  project_.reset();
  for (const char* name : {"batches", "results", "backups", "models", "imported", "cluster"}) {
    fs::remove_all(folder / name);
    fs::create_directory_symlink(folder_.path(), folder / name);
    const Result<Project> opened = Project::open(folder);
    ASSERT_FALSE(opened) << name;
    EXPECT_EQ(opened.error().where, (folder / name).string());
    fs::remove(folder / name);
    fs::create_directory(folder / name);
  }
  EXPECT_TRUE(Project::open(folder));
}

}  // namespace
}  // namespace ostraka::upkeep
