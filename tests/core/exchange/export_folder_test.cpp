#include "exchange/export_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "archive/bagit.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "closed_shell.h"
#include "exchange/drawn_sherds.h"
#include "exported_project.h"
#include "images/jpeg_image.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "tables/csv.h"
#include "texture/texture.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;

using Export = ExportedProject;

TEST_F(Export, HoldsEverythingThatWasChosenWithItsChecksum) {
  const Result<Exported> done = exportTo("out", all);
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_EQ(done->sherds, 3);
  // No warning stands on a sheet: who exports is told.
  EXPECT_THAT(done->warnings, testing::ElementsAre(
                                  testing::StartsWith("Check the drawing of ARM1-T3-0012-0001: ")));
  const fs::path data = folder_.path() / "out" / "data";
  for (const char* name :
       {"sherds.csv", "contexts.csv", "sherds/ARM1-T3-0012-0001.json",
        "models/ARM1-T3-0012-0002.ply", "models/ARM1-T3-0012-0002.glb",
        "models/ARM1-T3-0012-0002.obj", "images/ARM1-T3-0012-0003.png",
        "photographs/B0001/front/cam0_pos00.jpg", "metadata/project.json", "metadata/places.json",
        "metadata/batches.json", "context.jsonld", "README.txt"})
    EXPECT_TRUE(fs::exists(data / name)) << name;
  EXPECT_TRUE(archive::checkBag(folder_.path() / "out", quiet, {}));
  EXPECT_EQ(*readFile(data / "photographs/B0001/front/cam0_pos00.jpg"), "JPEG");
}

// At the first report after the manifests are written.
class AtTheCheck final : public Progress {
 public:
  AtTheCheck(fs::path target, std::function<void(const fs::path&)> provenance)
      : target_(std::move(target)), provenance_(std::move(provenance)) {}
  void report(std::int64_t, std::int64_t) override {
    for (const fs::path& there : {target_, fs::path(target_.string() + ".partial/content")})
      if (provenance_ && fs::exists(there / "tagmanifest-sha256.txt"))
        std::exchange(provenance_, {})(there);
  }
  void note(NoteLevel, const Message&) override {}

 private:
  fs::path target_;
  std::function<void(const fs::path&)> provenance_;
};

// Edits once, when the first file is copied.
class Editing final : public Progress {
 public:
  explicit Editing(std::function<void()> edit) : edit_(std::move(edit)) {}
  void report(std::int64_t, std::int64_t) override {
    if (edit_) std::exchange(edit_, {})();
  }
  void note(NoteLevel, const Message&) override {}

 private:
  std::function<void()> edit_;
};

TEST_F(Export, IsOfOneMomentWhateverIsEditedMeanwhile) {
  const auto own = upkeep::Project::connect(project_->folder());
  ASSERT_TRUE(own);
  Editing editing([&] {
    EXPECT_TRUE(set(rows[0], "weight_g", "99"));
    EXPECT_TRUE(set(rows[0], "note", "edited"));
  });
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = all;
  const Result<Exported> done = exportFolder(*own, project_->folder(), rows, options, editing, {});
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_EQ(sherds::Sherds(catalogue()).get(rows[0])->note, "edited");
  const auto table = readFile(options.target / "data/sherds.csv");
  const auto record = readFile(options.target / "data/sherds/ARM1-T3-0012-0001.json");
  ASSERT_TRUE(table && record);
  EXPECT_THAT(*table, testing::HasSubstr(",23.4,"));
  EXPECT_THAT(*record, testing::HasSubstr("23.4"));
  EXPECT_THAT(*table + *record, testing::Not(testing::HasSubstr("edited")));
}

// What was reported, in parts of the whole.
class Parts final : public Progress {
 public:
  void report(std::int64_t done, std::int64_t total) override {
    parts.push_back(static_cast<double>(done) / static_cast<double>(total));
  }
  void note(NoteLevel, const Message&) override {}
  std::vector<double> parts = {0};
};

TEST_F(Export, CountsRecordsAndTablesAsWork) {
  std::vector<store::SherdRow> some(rows.begin(), rows.end());
  while (some.size() < 20) {
    records::SherdRecord sherd;
    sherd.context = context13;
    some.push_back(*sherds::Sherds(catalogue()).add(sherd, anna));
  }
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Csv, Form::Ods, Form::Json};
  Parts progress;
  ASSERT_TRUE(exportFolder(catalogue(), project_->folder(), some, options, progress, {}));
  std::vector<double>& parts = progress.parts;
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  parts.push_back(1);
  for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_LE(parts[i] - parts[i - 1], 0.25) << i;
}

TEST_F(Export, MakesAGlbWhereThereIsAPlyAlone) {
  records::FileRecord glb;
  const auto files = Files(catalogue()).of(rows[1]);
  ASSERT_TRUE(files);
  for (const records::FileRecord& file : *files)
    if (file.path.ends_with(".glb")) glb = file;
  ASSERT_FALSE(glb.path.empty());
  glb.role = "report";
  ASSERT_TRUE(Files(catalogue()).save(glb, anna));
  ASSERT_TRUE(exportTo("out", {Form::Glb}));
  for (const char* number : {"0001", "0002"}) {
    const auto model = readFile(folder_.path() / "out/data/models" /
                                ("ARM1-T3-0012-" + std::string(number) + ".glb"));
    ASSERT_TRUE(model) << number;
    EXPECT_EQ(model->substr(0, 4), "glTF") << number;
  }
}

TEST_F(Export, HasItsNameOnlyWhenItWasReadAgain) {
  ExportOptions options;
  options.target = folder_.path() / "out";
  std::stop_source stop;
  AtTheCheck stopping(options.target, [&](const fs::path&) { stop.request_stop(); });
  const Result<Exported> stopped =
      exportFolder(catalogue(), project_->folder(), rows, options, stopping, stop.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(fs::exists(options.target));
  EXPECT_FALSE(fs::exists(options.target.string() + ".partial"));

  AtTheCheck spoiling(options.target,
                      [](const fs::path& there) { put(there / "data/sherds.csv", "spoilt"); });
  const Result<Exported> spoilt =
      exportFolder(catalogue(), project_->folder(), rows, options, spoiling, {});
  ASSERT_FALSE(spoilt);
  EXPECT_THAT(spoilt.error().sentence(), testing::HasSubstr("sherds.csv"));
  EXPECT_FALSE(fs::exists(options.target));
  EXPECT_FALSE(fs::exists(options.target.string() + ".partial"));
}

// The catalogued file of a sherd, with other bytes.
void enter(Catalogue& catalogue, const fs::path& project, store::SherdRow sherd, const char* ending,
           const std::string& bytes, const records::Provenance& provenance) {
  const auto files = *Files(catalogue).of(sherd);
  for (records::FileRecord file : files) {
    if (!file.path.ends_with(ending)) continue;
    EXPECT_TRUE(writeFileAtomically(project / file.path, bytes));
    file.sha256 = sha256(bytes);
    file.bytes = static_cast<std::int64_t>(bytes.size());
    EXPECT_TRUE(Files(catalogue).save(file, provenance));
  }
}

constexpr std::size_t kSmall = 60'000;  // half of what a shell takes

TEST_F(Export, SmallerModelsSayHowFarOffTheyAreAndAreOfWhatWasEntered) {
  for (const store::SherdRow row : rows) {
    enter(catalogue(), project_->folder(), row, "model.ply", formatPly(closedShell(), "a"), anna);
    enter(catalogue(), project_->folder(), row, "model.glb", *formatGlb(closedShell(), {}), anna);
  }
  ExportOptions options;
  options.target = folder_.path() / "light";
  options.forms = {Form::Ply, Form::Glb, Form::Obj};
  options.most_model_bytes = kSmall;
  const Result<ExportSize> size = sizeOfExport(catalogue(), project_->folder(), rows, options, {});
  ASSERT_TRUE(size);
  EXPECT_EQ(size->lightened, 3);
  const Result<Exported> done =
      exportFolder(catalogue(), project_->folder(), rows, options, quiet, {});
  ASSERT_TRUE(done) << done.error().sentence();
  const fs::path models = options.target / "data/models";
  for (const char* sherd : {"ARM1-T3-0012-0001", "ARM1-T3-0012-0003"}) {
    for (const char* ending : {".ply", ".obj"})
      EXPECT_THAT(*readFile(models / (std::string(sherd) + ending)),
                  testing::HasSubstr(" simplified from the full-detail model: 99.9 % within 0"));
    const std::string glb = *readFile(models / (std::string(sherd) + ".glb"));
    EXPECT_THAT(glb, testing::HasSubstr("\"deviation_mm\":0"));
    EXPECT_LE(glb.size(), kSmall);
  }
  put(modelOf(1), "another one");
  options.target = folder_.path() / "changed";
  const Result<Exported> refused =
      exportFolder(catalogue(), project_->folder(), rows, options, quiet, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_FALSE(fs::exists(options.target));
}

TEST_F(Export, ModelsThatAreSmallEnoughStayWhole) {
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Ply, Form::Glb};
  options.most_model_bytes = kSmall;
  ASSERT_TRUE(exportFolder(catalogue(), project_->folder(), rows, options, quiet, {}));
  for (const char* ending : {".ply", ".glb"}) {
    const auto model =
        readFile(options.target / ("data/models/ARM1-T3-0012-0001" + std::string(ending)));
    ASSERT_TRUE(model);
    EXPECT_THAT(*model, testing::Not(testing::HasSubstr("simplified")));
    EXPECT_THAT(*model, testing::Not(testing::HasSubstr("deviation_mm")));
  }
}

std::string texturedGlb(const cv::Mat3b& picture) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return *formatGlb(
      mesh, {{{0, 0}, {1, 0}, {0, 1}, {0.25f, 0.75f}}, images::encodedJpeg(picture), {}}, {});
}

TEST_F(Export, AnObjHasThePhotographsOfItsModelBesideIt) {
  const cv::Mat3b picture(8, 16, cv::Vec3b(30, 60, 200));
  enter(catalogue(), project_->folder(), rows[1], ".glb", texturedGlb(picture), anna);
  const Result<Exported> done = exportTo("out", {Form::Obj, Form::Json});
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_THAT(done->warnings, testing::IsEmpty());
  const fs::path data = folder_.path() / "out/data";
  const std::string base = "models/ARM1-T3-0012-0002";
  const std::string obj = *readFile(data / (base + ".obj"));
  EXPECT_THAT(obj, testing::HasSubstr("\nmtllib ARM1-T3-0012-0002.mtl\n"));
  EXPECT_THAT(obj, testing::HasSubstr("\nvt 0.25 0.25\n"));
  EXPECT_THAT(*readFile(data / (base + ".mtl")),
              testing::HasSubstr("\nmap_Kd ARM1-T3-0012-0002.png\n"));
  const cv::Mat3b read = cv::imread((data / (base + ".png")).string());
  ASSERT_EQ(read.size(), picture.size());
  EXPECT_LT(cv::norm(read, picture, cv::NORM_INF), 4) << "of the JPEG";
  const std::string record = *readFile(data / "sherds/ARM1-T3-0012-0002.json");
  for (const char* ending : {".obj", ".mtl", ".png"})
    EXPECT_THAT(record, testing::HasSubstr(base + ending)) << "it comes back with the sherd";
  EXPECT_FALSE(fs::exists(data / "models/ARM1-T3-0012-0001.mtl")) << "without a texture";
}

TEST_F(Export, APlyHasThePhotographsOfItsModelBesideItOnTheSameSurface) {
  const cv::Mat3b picture(8, 16, cv::Vec3b(30, 60, 200));
  enter(catalogue(), project_->folder(), rows[1], ".glb", texturedGlb(picture), anna);
  const Result<Exported> done = exportTo("out", {Form::Ply, Form::Obj, Form::Json});
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_THAT(done->warnings, testing::IsEmpty());
  const fs::path data = folder_.path() / "out/data";
  const std::string base = "models/ARM1-T3-0012-0002";
  const std::string ply = *readFile(data / (base + ".ply"));
  EXPECT_THAT(ply, testing::HasSubstr("\ncomment TextureFile ARM1-T3-0012-0002.png\n"));
  EXPECT_THAT(ply, testing::HasSubstr("\nproperty list uchar float texcoord\n"));
  EXPECT_EQ(cv::imread((data / (base + ".png")).string()).size(), picture.size());
  const Result<PlyContents> was = readPly(modelOf(1)), read = parsePly(ply, "exported");
  ASSERT_TRUE(was);
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_EQ(formatPly(read->mesh, "a"), formatPly(was->mesh, "a"));
  const std::string record = *readFile(data / "sherds/ARM1-T3-0012-0002.json");
  EXPECT_EQ(record.find(base + ".png"), record.rfind(base + ".png")) << "once for PLY and OBJ";
  const std::string plain = *readFile(data / "models/ARM1-T3-0012-0001.ply");
  EXPECT_THAT(plain, testing::Not(testing::HasSubstr("TextureFile"))) << "without a texture";
  // What was read back names a picture that lies elsewhere; without photographs it names none.
  enter(catalogue(), project_->folder(), rows[0], "model.ply", ply, anna);
  ASSERT_TRUE(exportTo("again", {Form::Ply}));
  EXPECT_THAT(*readFile(folder_.path() / "again/data/models/ARM1-T3-0012-0001.ply"),
              testing::Not(testing::HasSubstr("TextureFile")));
}

TEST_F(Export, PhotographsStayOnSmallerModelsAndTheirSizeIsKnownBefore) {
  const TriangleMesh shell = closedShell();
  GlbTexture photographs;  // seen from above, through to the other side
  for (const Eigen::Vector3f& v : shell.vertices)
    photographs.uv.emplace_back(0.5f + v.x() / 80, 0.5f - v.y() / 80);
  photographs.jpeg = images::encodedJpeg(cv::Mat3b(400, 400, cv::Vec3b(30, 60, 200)));
  for (const store::SherdRow row : rows) {
    enter(catalogue(), project_->folder(), row, "model.ply", formatPly(shell, "a"), anna);
    enter(catalogue(), project_->folder(), row, ".glb", *formatGlb(shell, photographs, {}), anna);
  }
  for (const std::size_t most : {std::size_t{0}, kSmall}) {
    ExportOptions options;
    options.target = folder_.path() / (most > 0 ? "light" : "whole");
    options.forms = {Form::Ply, Form::Obj, Form::Glb};
    options.most_model_bytes = most;
    const auto size = sizeOfExport(catalogue(), project_->folder(), rows, options, {});
    ASSERT_TRUE(size) << size.error().sentence();
    const auto done = exportFolder(catalogue(), project_->folder(), rows, options, quiet, {});
    ASSERT_TRUE(done) << done.error().sentence();
    EXPECT_THAT(done->warnings, testing::IsEmpty());
    EXPECT_EQ(size->files, done->files);
    EXPECT_NEAR(static_cast<double>(size->bytes) / static_cast<double>(done->bytes), 1, 0.1);
    const fs::path models = options.target / "data/models";
    EXPECT_TRUE(fs::exists(models / "ARM1-T3-0012-0001.png"));
    const std::string bytes = *readFile(models / "ARM1-T3-0012-0001.glb");
    EXPECT_EQ(bytes.size() <= kSmall, most > 0);
    const auto glb = texture::openedGlb(bytes, "a");
    ASSERT_TRUE(glb) << glb.error().sentence();
    ASSERT_TRUE(glb->has_value());
    const cv::Mat3b& page = (*glb)->texture.picture;
    EXPECT_LT(cv::norm(page, cv::Mat3b(page.size(), cv::Vec3b(30, 60, 200)), cv::NORM_INF), 6);
  }
}

TEST_F(Export, ATextureThatCannotBeReadLeavesTheObjItsColours) {
  enter(catalogue(), project_->folder(), rows[1], ".glb", "no GLB", anna);
  const Result<Exported> done = exportTo("out", {Form::Obj});
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_THAT(done->warnings,
              testing::ElementsAre(testing::StartsWith(
                  "models/ARM1-T3-0012-0002.obj is exported without photographs: ")));
  EXPECT_TRUE(fs::exists(folder_.path() / "out/data/models/ARM1-T3-0012-0002.obj"));
}

TEST_F(Export, TheTableNamesTheFilesOfEachSherd) {
  ASSERT_TRUE(exportTo("out", all));
  const std::string text = *readFile(folder_.path() / "out/data/sherds.csv");
  EXPECT_TRUE(text.starts_with("\xEF\xBB\xBFnumber,uuid,"));
  const Result<tables::CsvTable> table = tables::parseCsv(text, "sherds.csv");
  ASSERT_TRUE(table) << table.error().sentence();
  ASSERT_EQ(table->rows.size(), 3u);
  const auto value = [&](std::size_t row, const std::string& column) {
    const auto at = std::find(table->columns.begin(), table->columns.end(), column);
    return table->rows[row].values[static_cast<std::size_t>(at - table->columns.begin())];
  };
  EXPECT_EQ(value(0, "model_file"), "models/ARM1-T3-0012-0001.ply");
  EXPECT_EQ(value(0, "image_file"), "images/ARM1-T3-0012-0001.png");
  EXPECT_EQ(value(0, "note"), "'=SUM(A1), \"quoted\"; Գառնի\nsecond line");
  EXPECT_EQ(value(0, "length_mm"), "51");
  EXPECT_EQ(value(0, "extra.drawer"), "7");
  EXPECT_EQ(value(2, "length_mm"), "52");
}

TEST_F(Export, TheTablesHaveTheSameHeadingsForAllAndTheSpreadsheetSaysThePersonsWords) {
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Csv, Form::Ods};
  options.words = [](const std::string& column) { return "<" + column + ">"; };
  ASSERT_TRUE(exportFolder(catalogue(), project_->folder(), rows, options, quiet, {}));
  const std::string ods = *readFile(options.target / "data/sherds.ods");
  EXPECT_THAT(ods, testing::HasSubstr("<text:p>length_mm</text:p>"));
  EXPECT_THAT(ods, testing::HasSubstr("<text:p>extra.drawer</text:p>"));
  EXPECT_THAT(ods, testing::HasSubstr("<text:p>&lt;length_mm&gt;</text:p>"))
      << "in the sheet that explains the columns";
  EXPECT_TRUE(
      readFile(options.target / "data/sherds.csv")->starts_with("\xEF\xBB\xBFnumber,uuid,"));
  EXPECT_THAT(*readFile(options.target / "data/README.txt"),
              testing::HasSubstr("same English headings in every language"));
}

TEST_F(Export, AWholeBatchWithoutItsResultsIsNamedWhenViewsAreWanted) {
  const Result<Exported> done = exportTo("out", {Form::Csv, Form::Views});
  ASSERT_TRUE(done) << done.error().sentence();
  ASSERT_EQ(done->warnings.size(), 1u);
  EXPECT_NE(done->warnings[0].english().find("No pictures with masks and poses of B0001"),
            std::string::npos);
  EXPECT_FALSE(fs::exists((folder_.path() / "out").string() + ".views"));
}

TEST_F(Export, ARecordSaysWhereItsValuesComeFrom) {
  ASSERT_TRUE(exportTo("out", all));
  const std::string text = *readFile(folder_.path() / "out/data/sherds/ARM1-T3-0012-0003.json");
  const auto json = nlohmann::ordered_json::parse(text);
  EXPECT_EQ(json["format"], "ostraka-sherd/1");
  EXPECT_EQ(json.begin().key(), "@context");
  EXPECT_EQ(json["provenience"]["context"], "0012");
  EXPECT_EQ(json["digitisation"]["batch"], "B0001");
  EXPECT_EQ(json["pairing"]["front"], "f003");
  EXPECT_EQ(json["pairing"]["by"], "program");
  EXPECT_EQ(json["processing"]["program"], "ostraka 1.0.0");
  bool by_hand = false;
  for (const auto& m : json["measurements"])
    by_hand |= m["kind"] == "length" && m["method"] == "calliper" && m["by"] == "AP";
  EXPECT_TRUE(by_hand);
  const std::string model = *readFile(folder_.path() / "out/data/models/ARM1-T3-0012-0003.ply");
  EXPECT_EQ(json["files"][0]["sha256"], sha256(model)) << "of the file as it was exported";
  EXPECT_TRUE(text.ends_with("}\n"));
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST_F(Export, ADoubtfulScaleIsSaidInModelsRecordsAndTheReadMe) {
  ASSERT_TRUE(exportTo("sure", all));
  records::BatchRecord held = *Batches(catalogue()).get(batch);
  held.scale_doubts = {"The scale is wrong: 50 mm measure 49.5 mm."};
  ASSERT_TRUE(Batches(catalogue()).save(held, anna));
  ASSERT_TRUE(exportTo("doubtful", all));
  for (const char* name :
       {"README.txt", "models/ARM1-T3-0012-0002.ply", "models/ARM1-T3-0012-0002.glb",
        "models/ARM1-T3-0012-0002.obj", "sherds/ARM1-T3-0012-0002.json"}) {
    const auto said = [&](const char* folder) {
      return readFile(folder_.path() / folder / "data" / name)->find("50 mm measure 49.5 mm") !=
             std::string::npos;
    };
    EXPECT_TRUE(said("doubtful")) << name;
    EXPECT_FALSE(said("sure")) << name;
  }
}

TEST_F(Export, DrawingsAreTakenFromTheirPaths) {
  put(folder_.path() / "drawn.svg", "<svg/>");
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Drawings, Form::Csv};
  options.drawings[rows[0]] = {folder_.path() / "drawn.svg"};
  ASSERT_TRUE(exportFolder(catalogue(), project_->folder(), rows, options, quiet, {}));
  EXPECT_EQ(*readFile(folder_.path() / "out/data/drawings/ARM1-T3-0012-0001.svg"), "<svg/>");
}

TEST_F(Export, WhatIsMissingIsNamedAndTheRestIsWhole) {
  fs::remove(pictureOf(1));
  const Result<Exported> done = exportTo("out", all);
  ASSERT_TRUE(done);
  ASSERT_EQ(done->warnings.size(), 2u);  // the other is about a drawing
  EXPECT_NE(done->warnings[0].english().find("/preview.png"), std::string::npos);
  EXPECT_TRUE(archive::checkBag(folder_.path() / "out", quiet, {}));
}

// The project may be a stranger's: what its catalogue or its links lead to is not handed on.
TEST_F(Export, AModelThatIsNotTheOneEnteredStopsIt) {
  for (const std::string& file : {modelOf(1), pictureOf(1)}) {
    const std::string was = *readFile(file);
    put(file, "ply\nsomething else");
    const Result<Exported> done = exportTo("out", all);
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().sentence(),
                testing::HasSubstr("of the sherd ARM1-T3-0012-0002 differs from"));
    put(file, was);
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "out"));
  EXPECT_FALSE(fs::exists(folder_.path() / "out.partial"));
}

TEST_F(Export, CanBeStoppedAndLeavesNothing) {
  std::stop_source stop;
  stop.request_stop();
  ExportOptions options;
  options.target = folder_.path() / "out";
  const Result<Exported> done =
      exportFolder(catalogue(), project_->folder(), rows, options, quiet, stop.get_token());
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(fs::exists(folder_.path() / "out.partial"));
}

TEST_F(Export, OfTheSameSherdsIsTheSameBytes) {
  ASSERT_TRUE(exportTo("one", all));
  ASSERT_TRUE(exportTo("two", all));
  EXPECT_EQ(*readFile(folder_.path() / "one/manifest-sha256.txt"),
            *readFile(folder_.path() / "two/manifest-sha256.txt"));
}

}  // namespace
}  // namespace ostraka::exchange
