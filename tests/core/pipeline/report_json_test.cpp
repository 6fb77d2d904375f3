#include "pipeline/report.h"

#include <gtest/gtest.h>

namespace ostraka::pipeline {
namespace {

class Report : public testing::Test {
 protected:
  Report() {
    front.id = "f001";
    back.id = "b002";
    pair.score = 0.9375;
    pair.margin = 2.5;
    pair.fracture_rms_mm = 0.0625;
    pair.fracture_overlap = 0.75;
    pair.uncertainty_mm = 0.125;
    input.batch_name = "B0001";
    input.sherds.push_back({"01", &pair, &front, &back, {{"volume_mm3", 1234.5}}, {}});
  }
  nlohmann::ordered_json sherd() const { return reportJson(input).at("sherds").at(0); }
  scan::Scan front, back;
  DecidedPair pair;
  ReportInput input;
};

TEST_F(Report, HasTheFiguresOfASherdAsTheyAre) {
  EXPECT_EQ(sherd().at("number"), "01");
  EXPECT_EQ(sherd().at("front"), "f001");
  EXPECT_EQ(sherd().at("back"), "b002");
  EXPECT_EQ(sherd().at("score"), 0.9375);
  EXPECT_EQ(sherd().at("margin"), 2.5);
  EXPECT_EQ(sherd().at("fracture_rms_mm"), 0.0625);
  EXPECT_EQ(sherd().at("fracture_overlap"), 0.75);
  EXPECT_EQ(sherd().at("uncertainty_mm"), 0.125);
  EXPECT_EQ(sherd().at("figures").at("volume_mm3"), 1234.5);
  EXPECT_EQ(reportJson(input).at("unit"), "mm");
}

// 0 mm would read as a perfect fit.
TEST_F(Report, HasNoFigureForWhatWasNotCompared) {
  pair.fracture_rms_mm = pair.fracture_overlap = 0;
  pair.score.reset();
  pair.margin.reset();
  for (const char* figure : {"fracture_rms_mm", "fracture_overlap", "score", "margin"})
    EXPECT_TRUE(sherd().at(figure).is_null()) << figure;
  EXPECT_EQ(sherd().at("uncertainty_mm"), 0.125);
}

TEST_F(Report, SaysWhoDecidedAPairThatAPersonDecided) {
  pair.ambiguous = true;
  pair.reason = "Ambiguous: a second position fits almost as well.";
  pair.decided_by = "AP";
  pair.decided_at = "2026-07-14T09:30:12Z";
  EXPECT_EQ(sherd().at("ambiguous"), true);
  EXPECT_EQ(sherd().at("reason"), pair.reason);
  EXPECT_EQ(sherd().at("decided_by"), "AP");
  EXPECT_EQ(sherd().at("decided_at"), "2026-07-14T09:30:12Z");
}

TEST_F(Report, SaysWhetherLengthsAreInMillimetres) {
  EXPECT_EQ(reportJson(input).at("has_scale"), true) << "scans of other programs";
  Poses poses;
  input.poses = &poses;
  EXPECT_EQ(reportJson(input).at("has_scale"), true);
  poses.has_scale = false;
  EXPECT_EQ(reportJson(input).at("has_scale"), false);
}

TEST_F(Report, NamesWhatTookNoPart) {
  input.unpaired_front = {"f002", "f003"};
  input.unpaired_back = {"b001"};
  input.set_aside = {"f004"};
  input.reshoot = {"f005"};
  input.decisions = {"0190a0b0-0000-7000-8000-000000000001"};
  input.draft = true;
  const nlohmann::ordered_json report = reportJson(input);
  EXPECT_EQ(report.at("unpaired_front"), (std::vector<std::string>{"f002", "f003"}));
  EXPECT_EQ(report.at("unpaired_back"), (std::vector<std::string>{"b001"}));
  EXPECT_EQ(report.at("set_aside"), (std::vector<std::string>{"f004"}));
  EXPECT_EQ(report.at("reshoot"), (std::vector<std::string>{"f005"}));
  EXPECT_EQ(report.at("decisions"), input.decisions);
  EXPECT_EQ(report.at("draft"), true);
}

TEST_F(Report, OfNothingHasListsThatAreEmptyAndNotNull) {
  input.sherds.clear();
  const nlohmann::ordered_json report = reportJson(input);
  for (const char* list : {"stages", "sherds", "unpaired_front", "unpaired_back", "set_aside",
                           "reshoot", "warnings", "decisions", "scale_doubts"}) {
    EXPECT_TRUE(report.at(list).is_array()) << list << ": " << report.at(list);
    EXPECT_TRUE(report.at(list).empty()) << list;
  }
}

TEST_F(Report, HasTheStagesInTheirOrderWithTheirFigures) {
  ReportStage rig{"rig", {}}, masks{"masks_front", {}};
  rig.record.seconds = 1.5;
  rig.record.peak_memory_mb = 300;
  rig.record.notes.figures = {{"rms_px", 0.25}};
  input.stages = {rig, masks};
  const nlohmann::ordered_json stages = reportJson(input).at("stages");
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[0].at("stage"), "rig");
  EXPECT_EQ(stages[0].at("seconds"), 1.5);
  EXPECT_EQ(stages[0].at("figures").at("rms_px"), 0.25);
  EXPECT_EQ(stages[1].at("stage"), "masks_front");
}

}  // namespace
}  // namespace ostraka::pipeline
