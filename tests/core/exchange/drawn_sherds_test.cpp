#include "exchange/drawn_sherds.h"

#include <gmock/gmock.h>

#include "archive/bagit.h"
#include "closed_shell.h"
#include "drawing/drawing_files.h"
#include "exported_project.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherds.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using drawing::RimChoice;
using records::SherdRecord;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;

TEST(RimChoice, FollowsWhatThePartsSay) {
  SherdRecord sherd;
  EXPECT_EQ(rimChoiceOf(sherd), RimChoice::Propose);
  sherd.part = {"body"};
  EXPECT_EQ(rimChoiceOf(sherd), RimChoice::No);
  sherd.part = {"neck", "rim"};
  EXPECT_EQ(rimChoiceOf(sherd), RimChoice::Yes);
  sherd.part = {"profile"};
  EXPECT_EQ(rimChoiceOf(sherd), RimChoice::Yes);
  sherd.part = {"lid"};
  EXPECT_EQ(rimChoiceOf(sherd), RimChoice::Propose);
}

class DrawnSherds : public ExportedProject {
 protected:
  DrawnSherds() {
    // The second is a body sherd with a model worth drawing; the third's has a hole.
    TriangleMesh mesh = closedShell();
    EXPECT_TRUE(set(rows[1], "part", "body"));
    model(1, mesh);
    mesh.triangles.pop_back();
    model(2, mesh);
  }
  void model(std::size_t i, const TriangleMesh& mesh) {
    const std::string path = "models/drawn/" + std::to_string(i) + ".ply";
    put(project_->folder() / path, formatPly(mesh, "plate_front"));
    EXPECT_TRUE(sherds::Sherds(catalogue()).setModel(rows[i], path, {}));
  }
};

TEST_F(DrawnSherds, WithoutANumberAreNamedInWordsThatCanBeTranslated) {
  records::SherdRecord sherd = *sherds::Sherds(catalogue()).get(rows[1]);
  sherd.number.clear();
  sherd.piece = 2;
  const auto drawn = drawSherd(catalogue(), sherd, project_->folder(), {});
  ASSERT_TRUE(drawn) << drawn.error().sentence();
  EXPECT_EQ(drawn->id.english(), "sherd 2 of B0001");
  EXPECT_EQ(drawn->id.values().size(), 2u);
}

TEST_F(DrawnSherds, AreNamedByTheirNumbersAndWhatCannotBeDrawnIsNamed) {
  const std::vector<store::SherdRow> two = {rows[1], rows[2]};
  const auto drawn = drawSherds(catalogue(), project_->folder(), two, {}, quiet, {});
  ASSERT_TRUE(drawn) << drawn.error().sentence();
  ASSERT_EQ(drawn->drawings.size(), 1u);
  EXPECT_EQ(drawn->rows.front(), rows[1]);
  EXPECT_EQ(drawn->drawings.front().id, "ARM1-T3-0012-0002");
  EXPECT_FALSE(drawn->drawings.front().drawn_as_rim);
  ASSERT_EQ(drawn->left_out.size(), 1u);
  EXPECT_EQ(drawn->left_out.front().id, "ARM1-T3-0012-0003");
  EXPECT_THAT(drawn->left_out.front().why, HasSubstr("closed model"));
}

TEST_F(DrawnSherds, AreRimsWhereAPersonSaysSoOfTheirDrawingAlone) {
  ASSERT_TRUE(set(rows[1], "part", "rim"));
  const std::vector<store::SherdRow> one = {rows[1]};
  DrawSherdsOptions options;
  options.rims[rows[2]] = RimChoice::No;  // of another
  const auto isTakenForARim = [&] {
    const auto drawn = drawSherds(catalogue(), project_->folder(), one, options, quiet, {});
    EXPECT_TRUE(drawn) << drawn.error().sentence();
    const drawing::SherdDrawing& sherd = drawn->drawings.front();
    return sherd.drawn_as_rim ||
           testing::Value(sherd.remarks, Contains(HasSubstr("recorded as a rim")));
  };
  EXPECT_TRUE(isTakenForARim());
  options.rims[rows[1]] = RimChoice::No;
  EXPECT_FALSE(isTakenForARim());
}

TEST_F(DrawnSherds, SayWhereTheirPhotographsCannotBeShown) {
  records::FileRecord glb;
  glb.path = "models/drawn/1.glb";
  glb.sha256 = sha256("no GLB");
  glb.bytes = 6;
  glb.media_type = "model/gltf-binary";
  glb.role = "model";
  glb.sherd = rows[1];
  put(project_->folder() / glb.path, "no GLB");
  ASSERT_TRUE(catalogue::Files(catalogue()).save(glb, anna));
  const std::vector<store::SherdRow> one = {rows[1]};
  DrawSherdsOptions options;
  const auto relief = drawSherds(catalogue(), project_->folder(), one, options, quiet, {});
  ASSERT_TRUE(relief) << relief.error().sentence();
  EXPECT_THAT(relief->drawings.front().remarks,
              testing::Not(Contains(HasSubstr("without its photographs"))));
  for (const auto surface : {drawing::Surface::Painted, drawing::Surface::Orthophoto}) {
    options.drawing.surface = surface;
    const auto drawn = drawSherds(catalogue(), project_->folder(), one, options, quiet, {});
    ASSERT_TRUE(drawn) << drawn.error().sentence();
    EXPECT_THAT(
        drawn->drawings.front().remarks,
        Contains(testing::StartsWith("Drawn without its photographs: The texture of this")));
  }
}

TEST_F(DrawnSherds, HavePicturesOfTheirOwnInTheirOrder) {
  DrawSherdsOptions options;
  options.drawing.surface = drawing::Surface::Orthophoto;
  const std::vector<store::SherdRow> two = {rows[2], rows[1]};  // the first cannot be drawn
  const auto drawn = drawSherds(catalogue(), project_->folder(), two, options, quiet, {});
  ASSERT_TRUE(drawn) << drawn.error().sentence();
  const auto pictures =
      picturesOf(catalogue(), project_->folder(), *drawn, options, "views.png", quiet, {});
  ASSERT_TRUE(pictures) << pictures.error().sentence();
  const drawing::ViewPicture shown =
      drawing::pictureOf(closedShell(), drawn->drawings.front(), options.drawing);
  EXPECT_THAT(*pictures, testing::ElementsAre(drawing::formatPicture(shown, "views.png")));
}

TEST_F(DrawnSherds, AreExportedAsOrthophotosWhereThatIsChosen) {
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Drawings};
  options.drawing_surface = drawing::Surface::Orthophoto;
  const std::vector<store::SherdRow> one = {rows[1]};
  const auto done = exportFolder(catalogue(), project_->folder(), one, options, quiet, {});
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_THAT(done->warnings, Contains(HasSubstr("colours of its vertices")));
  EXPECT_THAT(*readFile(options.target / "data/drawings/ARM1-T3-0012-0002.pdf"),
              HasSubstr("/DeviceRGB"));
}

TEST_F(DrawnSherds, LeaveVoidOnesOutAndSayWhichUnlessOneAloneIsWanted) {
  model(0, closedShell());
  ASSERT_TRUE(set(rows[0], "part", "body"));
  ASSERT_TRUE(set(rows[0], "void_reason", "a brick"));
  const std::vector<store::SherdRow> two = {rows[0], rows[1]}, one = {rows[0]};
  const auto plates = drawSherds(catalogue(), project_->folder(), two, {}, quiet, {});
  ASSERT_TRUE(plates) << plates.error().sentence();
  EXPECT_THAT(plates->rows, testing::ElementsAre(rows[1]));
  ASSERT_EQ(plates->left_out.size(), 1u);
  EXPECT_EQ(plates->left_out.front().why, "ARM1-T3-0012-0001 is void and was left out.");
  const auto alone = drawSherds(catalogue(), project_->folder(), one, {}, quiet, {});
  ASSERT_TRUE(alone) << alone.error().sentence();
  ASSERT_EQ(alone->drawings.size(), 1u);
  EXPECT_THAT(alone->drawings.front().remarks,
              testing::ElementsAre("This sherd is void; reason: a brick"));
}

TEST_F(DrawnSherds, ThatAreVoidAreInTheExportsTableAndInNoDrawing) {
  ASSERT_TRUE(set(rows[1], "void_reason", "a brick"));
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Drawings, Form::Csv};
  const std::vector<store::SherdRow> one = {rows[1]};
  const auto size = sizeOfExport(catalogue(), project_->folder(), one, options, {});
  ASSERT_TRUE(size);
  EXPECT_EQ(size->drawings, 0);
  const auto done = exportFolder(catalogue(), project_->folder(), one, options, quiet, {});
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_THAT(done->warnings,
              testing::ElementsAre("Not drawn: ARM1-T3-0012-0002 is void and was left out."));
  EXPECT_FALSE(fs::exists(options.target / "data/drawings"));
  EXPECT_THAT(*readFile(options.target / "data/sherds.csv"), HasSubstr("void,a brick"));
}

TEST_F(DrawnSherds, PrintWhatAPersonMeasuredInsteadOfWhatTheModelSays) {
  const auto measuresOf = [&] {
    const auto drawn =
        drawSherd(catalogue(), *sherds::Sherds(catalogue()).get(rows[1]), project_->folder(), {});
    EXPECT_TRUE(drawn) << drawn.error().sentence();
    return formatSvg(drawing::layOut({*drawn}, 1, {})[0], "x");
  };
  records::Measurement by_program;
  by_program.sherd = rows[1];
  by_program.kind = "width";
  by_program.value = 77;
  ASSERT_TRUE(sherds::Measurements(catalogue()).add(by_program, {}));
  EXPECT_THAT(measuresOf(), HasSubstr(" \u00D7 47.1"));  // the shell's
  ASSERT_TRUE(set(rows[1], "length_mm", "58.5"));
  ASSERT_TRUE(set(rows[1], "thickness_mean_mm", "6.8"));
  ASSERT_TRUE(set(rows[1], "rim_diameter_mm", "123 ± 4"));
  const std::string svg = measuresOf();
  EXPECT_THAT(svg, HasSubstr(">58.5 \u00D7 47.1"));
  EXPECT_THAT(svg, HasSubstr(", wall 6.8 mm<"));
  EXPECT_THAT(svg, HasSubstr("\u00D8 12.3 cm (95 %: 11.9 to 12.7)"));
}

TEST_F(DrawnSherds, StopBetweenTwoSherds) {
  std::stop_source stop;
  stop.request_stop();
  const auto drawn = drawSherds(catalogue(), project_->folder(), rows, {}, quiet, stop.get_token());
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.error().code, ErrorCode::Cancelled);
}

TEST_F(DrawnSherds, TravelInTheExportWithTheirChecksums) {
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Drawings, Form::Csv, Form::Json};
  const std::vector<store::SherdRow> two = {rows[1], rows[2]};
  const auto size = sizeOfExport(catalogue(), project_->folder(), two, options, {});
  ASSERT_TRUE(size);
  EXPECT_EQ(size->drawings, 2);
  EXPECT_EQ(size->files, 2 + 2 + 3 + 6 + 4);  // drawings of one, records, tables, metadata, the bag
  const auto done = exportFolder(catalogue(), project_->folder(), two, options, quiet, {});
  ASSERT_TRUE(done) << done.error().sentence();
  EXPECT_THAT(done->warnings, testing::ElementsAre(HasSubstr("Not drawn: ARM1-T3-0012-0003")));
  const auto files = archive::checkBag(options.target, quiet, {});
  ASSERT_TRUE(files) << files.error().sentence();
  for (const char* ending : {"svg", "pdf"})
    EXPECT_THAT(*files,
                Contains(Field(&archive::BagFile::path,
                               std::string("data/drawings/") + "ARM1-T3-0012-0002." + ending)));
  const std::string svg = *readFile(options.target / "data/drawings/ARM1-T3-0012-0002.svg");
  EXPECT_THAT(svg, HasSubstr(">ARM1-T3-0012-0002</text>"));
  EXPECT_THAT(svg, HasSubstr(">1 : 1</text>"));
  EXPECT_THAT(*readFile(options.target / "data/sherds.csv"),
              HasSubstr(",drawings/ARM1-T3-0012-0002.pdf,"));
  EXPECT_THAT(*readFile(options.target / "data/sherds/ARM1-T3-0012-0002.json"),
              HasSubstr("\"role\": \"drawing\""));
}

TEST_F(DrawnSherds, AreExportedAtTheScaleWantedOrAtTheOneThatFits) {
  TriangleMesh large = closedShell();
  for (Eigen::Vector3f& p : large.vertices) p *= 4;  // 224 by 176 mm: no A4 holds both views at 1:1
  model(1, large);
  const auto pageOf = [&](std::optional<double> scale, const std::string& name) {
    ExportOptions options;
    options.target = folder_.path() / name;
    options.forms = {Form::Drawings};
    options.drawing_scale = scale;
    const std::vector<store::SherdRow> one = {rows[1]};
    EXPECT_TRUE(exportFolder(catalogue(), project_->folder(), one, options, quiet, {}));
    return *readFile(options.target / "data/drawings/ARM1-T3-0012-0002.svg");
  };
  EXPECT_THAT(pageOf(0.5, "half"), HasSubstr("1 : 2"));
  const std::string fits = pageOf(std::nullopt, "fits");
  EXPECT_THAT(fits, testing::AnyOf(HasSubstr("1 : 2"), HasSubstr("1 : 3"), HasSubstr("1 : 4")));
  EXPECT_THAT(fits, testing::AnyOf(HasSubstr("width=\"297mm\""), HasSubstr("width=\"210mm\"")));
  // A handle: its page at 1:1 has less area than an A4 and is longer than one.
  TriangleMesh slender = closedShell();
  for (Eigen::Vector3f& p : slender.vertices) p = {0.4F * p.x(), 10 * p.y(), p.z()};
  model(1, slender);
  const std::string handle = pageOf(std::nullopt, "handle");
  EXPECT_THAT(handle, testing::AnyOf(HasSubstr("width=\"297mm\""), HasSubstr("width=\"210mm\"")))
      << handle.substr(0, 400);
}

}  // namespace
}  // namespace ostraka::exchange
