// What an export leaves out or refuses.
#include <gmock/gmock.h>

#include "archive/archive.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "exchange/drawn_sherds.h"
#include "exchange/export_folder.h"
#include "exchange/read_back.h"
#include "exported_project.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "store/database.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;

using RefusedExport = ExportedProject;

TEST_F(RefusedExport, TakesNothingAlongFromOutsideTheProject) {
  const fs::path secret = folder_.path() / "secret";
  put(secret, "SECRET");
  fs::remove(pictureOf(0));
  fs::create_symlink(secret, pictureOf(0));
  catalogue().database().run("UPDATE sherd SET preview_path = '../secret' WHERE row = ?", rows[1]);
  catalogue().database().run("UPDATE file SET path = ? WHERE role = 'photo'", secret.string());
  const auto exported = exportTo("out", {Form::Pictures, Form::Photographs});
  ASSERT_TRUE(exported) << exported.error().sentence();
  EXPECT_EQ(exported->warnings.size(), 3u);
  int pictures = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "out")) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(readFile(entry.path())->find("SECRET"), std::string::npos) << entry.path();
    pictures += entry.path().extension() == ".png" ? 1 : 0;
  }
  EXPECT_EQ(pictures, 1) << "the third sherd's";
  fs::remove(modelOf(2));
  fs::create_symlink(secret, modelOf(2));
  EXPECT_FALSE(exchange::modelOf(*sherds::Sherds(catalogue()).get(rows[2]), project_->folder()));
}

TEST_F(RefusedExport, NamesTheSherdsOfWhichItHasNoModel) {
  catalogue().database().run("UPDATE sherd SET model_path = '' WHERE row = ?", rows[0]);
  fs::remove(modelOf(1));
  const std::vector<std::string> without = {"ARM1-T3-0012-0001", "ARM1-T3-0012-0002"};
  const auto sizeOf = [&](std::set<Form> forms) {
    ExportOptions options;
    options.forms = std::move(forms);
    return *sizeOfExport(catalogue(), project_->folder(), rows, options, {});
  };
  EXPECT_EQ(sizeOf({Form::Csv, Form::Ply}).without_model, without);
  const Result<Exported> exported = exportTo("out", {Form::Csv, Form::Ply});
  ASSERT_TRUE(exported) << exported.error().sentence();
  EXPECT_EQ(exported->without_model, without);
  EXPECT_THAT(*readFile(folder_.path() / "out/data/README.txt"),
              testing::HasSubstr("\nSherds without a model\n----------------------\n"
                                 "ARM1-T3-0012-0001\nARM1-T3-0012-0002\n"));
  // Nobody asked for one.
  EXPECT_TRUE(sizeOf({Form::Csv}).without_model.empty());
  const Result<Exported> table = exportTo("table", {Form::Csv});
  ASSERT_TRUE(table) << table.error().sentence();
  EXPECT_TRUE(table->without_model.empty());
  EXPECT_THAT(*readFile(folder_.path() / "table/data/README.txt"),
              testing::Not(testing::HasSubstr("without a model")));
}

// Else one number would keep all sherds from being exported.
TEST_F(RefusedExport, IsNotRefusedForANumberThatIsADraftsName) {
  EXPECT_TRUE(set(rows[1], "number", ""));
  EXPECT_TRUE(set(rows[0], "number", "b0001-02"));
  const Result<Exported> exported = exportTo("out", {Form::Json, Form::Ply});
  ASSERT_TRUE(exported) << exported.error().sentence();
  const std::string draft = "B0001-02-" + sherds::Sherds(catalogue()).get(rows[1])->id.substr(0, 8);
  for (const char* file : {"sherds/b0001-02.json", "models/b0001-02.ply"})
    EXPECT_TRUE(fs::exists(folder_.path() / "out/data" / file)) << file;
  for (const std::string& file : {"sherds/" + draft + ".json", "models/" + draft + ".ply"})
    EXPECT_TRUE(fs::exists(folder_.path() / "out/data" / file)) << file;
}

TEST_F(RefusedExport, NamesTheValueThatNoFileCanHold) {
  catalogue().database().script("UPDATE sherd_measure SET weight = 9e999 WHERE sherd = 1");
  for (const Form form : {Form::Csv, Form::Ods}) {
    const Result<Exported> endless = exportTo("out", {form});
    ASSERT_FALSE(endless);
    EXPECT_EQ(endless.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(endless.error().where, "ARM1-T3-0012-0001, weight_g");
  }
  catalogue().database().script(
      "UPDATE sherd_measure SET weight = 23.4 WHERE sherd = 1; UPDATE sherd SET ware = "
      "CAST(x'ff' AS TEXT) WHERE row = 2");
  EXPECT_EQ(exportTo("out", {Form::Csv}).error().where, "ARM1-T3-0012-0002, ware");
  EXPECT_EQ(exportTo("out", {Form::Ods}).error().where, "ARM1-T3-0012-0002, ware");
  EXPECT_EQ(exportTo("out", {Form::Json}).error().where, "ARM1-T3-0012-0002/description/ware");
  catalogue().database().script(
      "UPDATE sherd SET ware = '' WHERE row = 2; UPDATE site SET name = CAST(x'ff' AS TEXT)");
  const Result<Exported> json = exportTo("out", {Form::Json});
  ASSERT_FALSE(json);
  EXPECT_EQ(json.error().what, "The text is not valid UTF-8 or contains a zero byte.");
  EXPECT_THAT(json.error().where, testing::StartsWith("metadata/places.json/"));
  EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(RefusedExport, IsAnArchiveWhichIsToBeRestored) {
  const fs::path archive = folder_.path() / "archive";
  ASSERT_TRUE(archive::archiveProject(*project_, {archive}, quiet, {}));
  const auto read = readBack(*project_, archive, tables::ImportMode::Preview, {}, quiet, {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().what.english(), testing::HasSubstr("catalogue restore"));
}

}  // namespace
}  // namespace ostraka::exchange
