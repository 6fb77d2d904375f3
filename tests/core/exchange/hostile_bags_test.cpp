// Archives and exports of strangers: every checksum agrees, and still nothing lands where it does
// not belong.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "archive/archive.h"
#include "base/limits.h"
#include "catalogue/batches.h"
#include "catalogue/history.h"
#include "exchange/read_back.h"
#include "exported_project.h"
#include "mended_bag.h"
#include "store/database.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;
using namespace std::string_literals;

struct Attack {
  std::string name;
  std::function<void(MendedBag&)> change;  ///< before its checksums are mended
  std::function<void(MendedBag&)> after = {};
};

const std::string kPhotograph = "data/batches/B0001/front/cam0_pos00.jpg";

// One more line of the manifest, for a file that was put where the line says, if it can be.
Attack listed(const std::string& path, const std::string& file = {}) {
  return {"lists " + path.substr(0, 60), [=](MendedBag& bag) {
            if (!file.empty()) {
              fs::create_directories((bag.folder() / file).parent_path());
              std::ofstream(bag.folder() / file) << "planted";
            }
            bag.list(path, "planted");
          }};
}

std::vector<Attack> attacksByPath() {
  std::vector<Attack> all = {
      listed(".config/autostart/x.desktop", ".config/autostart/x.desktop"),
      listed("bagit2.txt", "bagit2.txt"),
      listed("/etc/hostname"),
      listed("../planted.txt", "../planted.txt"),
      listed("data/../planted.txt", "planted.txt"),
      listed("data/a/../../planted.txt", "planted.txt"),
      listed("data/a/../planted.txt", "data/planted.txt"),
      listed("data//planted.txt", "data/planted.txt"),
      listed("data/./planted.txt", "data/planted.txt"),
      listed("./data/planted.txt", "data/planted.txt"),
      listed("//data/planted.txt", "data/planted.txt"),
      listed("data"),
      listed("data/"),
      listed("data/planted/", "data/planted"),
      listed("data\\..\\planted.txt"),
      listed("data/a\\b", "data/a\\b"),
      listed("C:/planted.txt"),
      listed("data/a\x01"
             "b",
             "data/a\x01"
             "b"),
      listed("data/a\x1B[2Jb", "data/a\x1B[2Jb"),
      listed("data/a\x7F", "data/a\x7F"),
      listed("data/\xFF\xFE", "data/\xFF\xFE"),
      listed("data/" + std::string(300, 'a')),
      listed("data/batches"),
      listed("data/missing.txt"),
      listed("data/Batches/B0001/front/x.jpg", "data/Batches/B0001/front/x.jpg"),
      listed("data/batches/B0001/front/CAM0_pos00.jpg", "data/batches/B0001/front/CAM0_pos00.jpg"),
      listed("data/catalogue.sqlite-journal", "data/catalogue.sqlite-journal"),
      listed("data/catalogue.sqlite-wal", "data/catalogue.sqlite-wal")};
  std::string deep = "data";
  while (deep.size() < 5000) deep += "/a";
  all.push_back(listed(deep));
  all.push_back({"two spellings of one letter", [](MendedBag& bag) {
                   bag.put("data/\xC3\xA9.txt", "one");
                   bag.put("data/e\xCC\x81.txt", "other");
                 }});
  return all;
}

std::vector<Attack> attacksByLink() {
  return {
      {"a folder beside data is a link",
       [](MendedBag& bag) {
         fs::create_directory_symlink("/etc", bag.folder() / "etc");
         bag.list("etc/hostname", *readFile("/etc/hostname"));
       }},
      {"a folder in data is a link",
       [](MendedBag& bag) {
         fs::create_directory_symlink("/etc", bag.folder() / "data/etc");
         bag.list("data/etc/hostname", *readFile("/etc/hostname"));
       }},
      {"a file in data is a link",
       [](MendedBag& bag) {
         fs::create_symlink("/etc/hostname", bag.folder() / "data/host.txt");
         bag.list("data/host.txt", *readFile("/etc/hostname"));
       }},
      {"a link to a file of the bag",
       [](MendedBag& bag) {
         fs::create_symlink("catalogue.sqlite", bag.folder() / "data/copy");
         bag.list("data/copy", *readFile(bag.folder() / "data/catalogue.sqlite"));
       }},
      {"a link to itself",
       [](MendedBag& bag) {
         fs::create_symlink("loop", bag.folder() / "data/loop");
         bag.list("data/loop", "");
       }},
      {"data is a link",
       [](MendedBag& bag) {
         fs::rename(bag.folder() / "data", bag.folder() / "other");
         fs::create_directory_symlink("other", bag.folder() / "data");
       }},
      {"the manifest is a link",
       {},
       [](MendedBag& bag) {
         fs::rename(bag.folder() / "manifest-sha256.txt", bag.folder() / "m");
         fs::create_symlink("m", bag.folder() / "manifest-sha256.txt");
       }},
      {"bagit.txt is a link",
       {},
       [](MendedBag& bag) {
         fs::rename(bag.folder() / "bagit.txt", bag.folder() / "b");
         fs::create_symlink("b", bag.folder() / "bagit.txt");
       }},
      {"a pipe that is listed",
       [](MendedBag& bag) {
         ASSERT_EQ(::mkfifo((bag.folder() / "data/pipe").c_str(), 0600), 0);
         bag.list("data/pipe", "");
       }},
      {"a pipe that is not listed",
       [](MendedBag& bag) { ASSERT_EQ(::mkfifo((bag.folder() / "data/pipe").c_str(), 0600), 0); }},
  };
}

std::vector<Attack> attacksByManifest() {
  return {
      {"a file that is not listed",
       {},
       [](MendedBag& bag) { std::ofstream(bag.folder() / "data/more.txt") << "more"; }},
      {"a file that was changed",
       {},
       [](MendedBag& bag) { std::ofstream(bag.folder() / kPhotograph) << "JPEH"; }},
      {"a file that was cut off",
       {},
       [](MendedBag& bag) { fs::resize_file(bag.folder() / kPhotograph, 3); }},
      {"two hashes for one file", [](MendedBag& bag) { bag.list(kPhotograph, "another"); }},
      {"a hash that is none",
       [](MendedBag& bag) { bag.payload.emplace_back("data/x", std::string(64, 'g')); }},
      {"a hash that is too short",
       [](MendedBag& bag) { bag.payload.emplace_back("data/x", "abc"); }},
      {"a line without a name", [](MendedBag& bag) { bag.list("", "planted"); }},
      {"a tag file of its own",
       [](MendedBag& bag) {
         std::ofstream(bag.folder() / "autorun.inf") << "planted";
         bag.tag("autorun.inf");
       }},
      {"a tag file outside",
       [](MendedBag& bag) {
         std::ofstream(bag.folder().parent_path() / "secret") << "planted";
         bag.tag("../secret");
       }},
      {"a payload file as a tag file", [](MendedBag& bag) { bag.tag(kPhotograph); }},
      {"a manifest that no tag manifest vouches for",
       [](MendedBag& bag) { std::erase(bag.tags, "manifest-sha256.txt"); }},
      {"a manifest changed afterwards",
       {},
       [](MendedBag& bag) {
         std::ofstream(bag.folder() / "manifest-sha256.txt", std::ios::app) << "\n";
       }},
      {"no tag manifest",
       {},
       [](MendedBag& bag) { fs::remove(bag.folder() / "tagmanifest-sha256.txt"); }},
      {"no declaration", {}, [](MendedBag& bag) { fs::remove(bag.folder() / "bagit.txt"); }},
      {"no catalogue", [](MendedBag& bag) { bag.drop("data/catalogue.sqlite"); }},
      {"a catalogue that is none",
       [](MendedBag& bag) { bag.put("data/catalogue.sqlite", "SQLite format 3 at heart"); }},
      {"a catalogue whose files lie outside",
       [](MendedBag& bag) {
         const fs::path opened = bag.folder() / "data";
         const fs::path declared = bag.folder() / "bagit.txt", aside = bag.folder() / "aside";
         fs::rename(declared, aside);  // no project of an archive is opened
         {
           upkeep::Project project = valueIn(upkeep::Project::open(opened));
           project.catalogue().database().script(
               "UPDATE file SET path = '../../.ssh/id_rsa' WHERE role = 'photo'");
         }
         fs::rename(aside, declared);
         for (const char* more : {"catalogue.sqlite-wal", "catalogue.sqlite-shm"})
           fs::remove(opened / more);
         bag.put("data/catalogue.sqlite", *readFile(opened / "catalogue.sqlite"));
       }},
  };
}

class HostileBags : public ExportedProject {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  // The bag as the attack leaves it.
  void prepare(const std::string& from, const Attack& attack) {
    fs::remove_all(at("bag"));
    for (const char* planted : {"planted.txt", "secret"}) fs::remove(at(planted));
    fs::copy(at(from), at("bag"), fs::copy_options::recursive);
    MendedBag bag(at("bag"));
    if (attack.change) attack.change(bag);
    bag.mend();
    if (attack.after) attack.after(bag);
  }
};

TEST_F(HostileBags, AreNotRestoredAndWriteNothingAnywhere) {
  ASSERT_TRUE(archive::archiveProject(*project_, {at("archive")}, quiet, {}));
  int attacks = 0;
  for (const auto& some : {attacksByPath(), attacksByLink(), attacksByManifest()})
    for (const Attack& attack : some) {
      SCOPED_TRACE(attack.name);
      prepare("archive", attack);
      const auto before = everythingIn(folder_.path());
      const Result<archive::Restored> restored =
          archive::restoreProject(at("bag"), at("home/project"), quiet, {});
      ASSERT_FALSE(restored);
      EXPECT_THAT(restored.error().code,
                  testing::AnyOf(ErrorCode::UnusableInput, ErrorCode::Damaged))
          << restored.error().sentence();
      EXPECT_FALSE(restored.error().what.empty());
      EXPECT_EQ(everythingIn(folder_.path()), before);
      ++attacks;
    }
  EXPECT_GE(attacks, 55);
  prepare("archive", {"none", {}});
  EXPECT_TRUE(archive::restoreProject(at("bag"), at("home/project"), quiet, {}))
      << "mending alone harms none";
}

// Photographs of the batch that land where this says.
Attack landsAt(const std::string& path) {
  return {"a photograph for " + path, [=](MendedBag& bag) {
            nlohmann::json batches = bag.json("data/metadata/batches.json");
            batches["batches"][0]["files"][0]["path"] = path;
            bag.put("data/metadata/batches.json", batches.dump());
          }};
}

// A file of the first sherd that is said to lie there in the export.
Attack comesFrom(const std::string& path, bool is_there = true) {
  return {"a file from " + path, [=](MendedBag& bag) {
            const std::string record = "data/sherds/ARM1-T3-0012-0001.json";
            nlohmann::json sherd = bag.json(record);
            sherd["files"] = {
                {{"role", "drawing"}, {"path", path}, {"sha256", sha256("planted")}, {"bytes", 7}}};
            bag.put(record, sherd.dump());
            if (is_there) bag.put("data/" + path, "planted");
          }};
}

Attack numbered(const std::string& number) {
  return {"a batch " + number, [=](MendedBag& bag) {
            nlohmann::json batches = bag.json("data/metadata/batches.json");
            nlohmann::json& batch = batches["batches"][0];
            batch["number"] = number;
            batch["files"][0]["path"] = "batches/" + number + "/front/cam0_pos00.jpg";
            bag.put("data/metadata/batches.json", batches.dump());
          }};
}

std::vector<Attack> attacksByRecords() {
  std::vector<Attack> all;
  for (const char* path : {"backups/catalogue-99990101-000000-000.sqlite",
                           "catalogue.sqlite",
                           "catalogue.sqlite-journal",
                           "catalogue.sqlite-wal",
                           ".ostraka.lock",
                           "file-checks.txt",
                           "results/B0001/decisions.json",
                           "results/B0001/mask_strokes.json",
                           "results/B0001/work/cameras/stage.json",
                           "results/B0001/lock",
                           "results/B0001/report.html",
                           "batches/B0001/manifest.json",
                           "batches/B0002/front/x.jpg",
                           "batches/B0001/front/.x.jpg",
                           "batches/B0001/front/x.desktop",
                           "batches/B0001/front/x.jpg.partial",
                           "batches/B0001/../../../planted.jpg",
                           "batches/B0001//front/x.jpg",
                           "/tmp/planted.jpg",
                           "../planted.jpg",
                           "models/B0001/x/catalogue.sqlite",
                           "imported/other/x.ply",
                           "x.jpg",
                           ""})
    all.push_back(landsAt(path));
  all.push_back(comesFrom("../../planted", false));
  all.push_back(comesFrom("models/../../planted.ply", false));
  all.push_back(comesFrom("/etc/hostname", false));
  all.push_back(comesFrom("models/none.ply", false));
  all.push_back(comesFrom("models/x.desktop"));
  all.push_back(comesFrom(".config/x.svg"));
  all.push_back(comesFrom("work/x.svg"));
  for (const char* number : {"../evil", "B0001/../../evil", "", ".", "..", ".git"})
    all.push_back(numbered(number));
  all.push_back({"a photograph that the export does not hold", [](MendedBag& bag) {
                   nlohmann::json batches = bag.json("data/metadata/batches.json");
                   batches["batches"][0]["files"][0]["at"] = "../../../etc/hostname";
                   bag.put("data/metadata/batches.json", batches.dump());
                 }});
  for (const std::string& note :
       {std::string(limits::kValueBytes.most + 1, 'x'), std::string("a\0b", 3)})
    all.push_back({"a note of " + std::to_string(note.size()) + " bytes", [=](MendedBag& bag) {
                     nlohmann::json batches = bag.json("data/metadata/batches.json");
                     batches["batches"][0]["note"] = note;
                     bag.put("data/metadata/batches.json", batches.dump());
                   }});
  all.push_back({"two files for one place", [](MendedBag& bag) {
                   nlohmann::json batches = bag.json("data/metadata/batches.json");
                   nlohmann::json& files = batches["batches"][0]["files"];
                   files.push_back(files[0]);
                   const std::string read_me = *readFile(bag.folder() / "data/README.txt");
                   files[1]["at"] = "README.txt";
                   files[1]["sha256"] = sha256(read_me);
                   files[1]["bytes"] = read_me.size();
                   bag.put("data/metadata/batches.json", batches.dump());
                 }});
  for (const auto& [key, value] :
       {std::pair<std::string, nlohmann::json>("sha256", std::string(64, '0')), {"bytes", 7}}) {
    all.push_back({"a photograph with another " + key, [=](MendedBag& bag) {
                     nlohmann::json batches = bag.json("data/metadata/batches.json");
                     batches["batches"][0]["files"][0][key] = value;
                     bag.put("data/metadata/batches.json", batches.dump());
                   }});
    all.push_back({"a model with another " + key, [=](MendedBag& bag) {
                     const std::string record = "data/sherds/ARM1-T3-0012-0001.json";
                     nlohmann::json sherd = bag.json(record);
                     sherd["files"][0][key] = value;
                     bag.put(record, sherd.dump());
                   }});
  }
  all.push_back(numbered("B9223372036854775807"));
  all.push_back({"records behind a link", [](MendedBag& bag) {
                   fs::rename(bag.folder() / "data/sherds", bag.folder() / "sherds");
                   fs::create_directory_symlink("../sherds", bag.folder() / "data/sherds");
                 }});
  all.push_back({"no places", [](MendedBag& bag) { bag.drop("data/metadata/places.json"); }});
  return all;
}

TEST_F(HostileBags, AreNotImportedAndLeaveTheProjectAsItWas) {
  ASSERT_TRUE(exportTo("out", all));
  records::ProjectRecord record;
  record.code = "ARM";
  upkeep::Project other = valueIn(upkeep::Project::create(at("other"), record));
  int attacks = 0;
  for (const Attack& attack : attacksByRecords()) {
    SCOPED_TRACE(attack.name);
    prepare("out", attack);
    const auto before = everythingIn(folder_.path());
    const std::int64_t history = History(other.catalogue()).length();
    const auto read = readBack(other, at("bag"), tables::ImportMode::Enter, {}, quiet, {});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::UnusableInput) << read.error().sentence();
    EXPECT_EQ(History(other.catalogue()).length(), history);
    EXPECT_EQ(everythingIn(folder_.path()), before);
    ++attacks;
  }
  EXPECT_GE(attacks, 40);
  prepare("out", {"none", {}});
  const auto read = readBack(other, at("bag"), tables::ImportMode::Enter, {}, quiet, {});
  EXPECT_TRUE(read) << read.error().sentence();
}

// What lies in the project already is reached by a link that somebody put there.
TEST_F(HostileBags, AreNotImportedThroughLinksOfTheProject) {
  ASSERT_TRUE(exportTo("out", all));
  records::ProjectRecord record;
  record.code = "ARM";
  upkeep::Project other = valueIn(upkeep::Project::create(at("other"), record));
  fs::create_directories(at("outside"));
  fs::create_directory_symlink(at("outside"), at("other/batches/B0001"));
  const auto read = readBack(other, at("out"), tables::ImportMode::Enter, {}, quiet, {});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
  EXPECT_TRUE(fs::is_empty(at("outside")));
  EXPECT_TRUE(Batches(other.catalogue()).all()->empty());
}

}  // namespace
}  // namespace ostraka::exchange
