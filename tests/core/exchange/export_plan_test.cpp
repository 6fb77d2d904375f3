#include "exchange/export_plan.h"

#include <gmock/gmock.h>

#include "exported_project.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ExportName, OfASherdIsItsNumberOrItsPlaceOnItsBatch) {
  std::vector<records::SherdRecord> sherds(1);
  records::SherdRecord& sherd = sherds.front();
  const auto name = [&] { return namesOf(sherds).at(sherd.row); };
  sherd.id = "0190a0b0-0000-7000-8000-000000000001";
  EXPECT_EQ(name(), "sherd-" + sherd.id);
  sherd.piece = 3;
  EXPECT_EQ(name(), "sherd-" + sherd.id) << "a place on no batch is none";
  sherd.batch_number = "B0004";
  EXPECT_EQ(name(), "B0004-03");
  sherd.piece = 12;
  EXPECT_EQ(name(), "B0004-12");
  sherd.number = "ARM1/T3 7";
  EXPECT_EQ(name(), "ARM1_T3_7") << "a slash would be a folder";
}

TEST(ExportName, OfADraftTellsItFromANumberOfTheSameName) {
  std::vector<records::SherdRecord> sherds(2);
  sherds[0].row = store::SherdRow{1};
  sherds[0].id = "0190a0b0-0000-7000-8000-000000000001";
  sherds[0].batch_number = "B0004";
  sherds[0].piece = 3;
  sherds[1].row = store::SherdRow{2};
  sherds[1].number = "b0004-03";
  const auto names = namesOf(sherds);
  EXPECT_EQ(names.at(store::SherdRow{1}), "B0004-03-0190a0b0");
  EXPECT_EQ(names.at(store::SherdRow{2}), "b0004-03");
}

TEST(ExportedModels, AreMadeAnewOnlyWhereTheyMayTakeLess) {
  ExportOptions options;
  PlannedFile file;
  for (const char* name : {"model.ply", "model.glb"})
    for (const Form form : {Form::Ply, Form::Glb, Form::Obj, Form::Pictures})
      for (const std::size_t most : {0u, 1000u}) {
        file.from = name;
        file.form = form;
        options.most_model_bytes = most;
        EXPECT_EQ(isMadeAnew(file, options),
                  most > 0 && form != Form::Pictures && file.from == "model.ply");
      }
  // A GLB of 1000 bytes: 50 for its label, 550 for its photographs.
  EXPECT_EQ(unlabelledBytes(options), 950u);
  EXPECT_EQ(surfaceBytes(options), 400u);
}

class Plan : public ExportedProject {
 protected:
  // What is copied from where, but the sherds' folders, which are named by checksums.
  std::vector<std::string> planned(const ExportOptions& options, std::size_t sherds = 1) {
    const fs::path folder = project_->folder();
    ExportPlan plan(catalogue(), folder, options);
    records_ = readAll(catalogue(), std::span(rows).first(sherds), plan, {});
    std::vector<std::string> files;
    for (const PlannedFile& file : plan.files())
      files.push_back(file.to + " < " + file.from.filename().string());
    drawn_ = plan.drawn().size();
    not_drawn_ = plan.notDrawn();
    return files;
  }
  std::vector<records::SherdRecord> records_;
  std::size_t drawn_ = 0;
  std::vector<Message> not_drawn_;
};

TEST_F(Plan, TakesOfEachSherdWhatIsWantedAndOfABatchItsPhotographsOnce) {
  ExportOptions options;
  options.forms = {Form::Ply, Form::Glb, Form::Obj, Form::Pictures, Form::Photographs};
  const std::string first = "ARM1-T3-0012-0001", second = "ARM1-T3-0012-0002";
  EXPECT_THAT(
      planned(options, 2),
      ElementsAre("models/" + first + ".ply < model.ply", "models/" + first + ".glb < model.glb",
                  "models/" + first + ".obj < model.ply", "images/" + first + ".png < preview.png",
                  "photographs/B0001/front/cam0_pos00.jpg < cam0_pos00.jpg",
                  "models/" + second + ".ply < model.ply", "models/" + second + ".glb < model.glb",
                  "models/" + second + ".obj < model.ply",
                  "images/" + second + ".png < preview.png"));
  options.forms = {Form::Csv};
  EXPECT_THAT(planned(options), IsEmpty());
}

TEST_F(Plan, DrawsWhatNobodyDrewAndNoVoidSherd) {
  ExportOptions options;
  options.forms = {Form::Drawings};
  options.drawings[rows[0]] = {folder_.path() / "mine.SVG", folder_.path() / "mine.pdf"};
  EXPECT_THAT(planned(options, 3), ElementsAre("drawings/ARM1-T3-0012-0001.SVG < mine.SVG",
                                               "drawings/ARM1-T3-0012-0001.pdf < mine.pdf"));
  EXPECT_EQ(drawn_, 2u);
  EXPECT_THAT(not_drawn_, IsEmpty());
  ASSERT_TRUE(set(rows[1], "void_reason", "a stone"));
  planned(options, 3);
  EXPECT_EQ(drawn_, 1u);
  ASSERT_EQ(not_drawn_.size(), 1u);
  EXPECT_THAT(not_drawn_[0].english(), HasSubstr("ARM1-T3-0012-0002"));
}

}  // namespace
}  // namespace ostraka::exchange
