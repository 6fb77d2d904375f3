#include "scansets/register_report.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/json.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::scansets {
namespace {

using testing::HasSubstr;
using testing::Not;

// Of one pair, named as a scanner's program may name files.
class RegisterReport : public testing::Test {
 protected:
  RegisterReport() : fronts(1), backs(2) {
    for (float x = 0; x < 4; ++x)
      for (float y = 0; y < 4; ++y) fronts[0].cloud.points.emplace_back(x, y, 3);
    backs[0].cloud = backs[1].cloud = fronts[0].cloud;
    fronts[0].id = "a<b>&1";
    backs[0].id = "x";
    backs[1].id = "y";
    RegisterSummary::Pair pair;
    pair.number = "01";
    pair.front = fronts[0].id;
    pair.back = "x";
    pair.score = 0.984375;
    pair.margin = 2.5;
    pair.fracture_rms_mm = 0.0625;
    pair.fracture_overlap = 0.75;
    pair.uncertainty_mm = 0.125;
    summary.pairs = {pair};
    summary.unpaired_back = {"y"};
    table.pairs.resize(1);
    table.pairs[0].contour_rms_mm = 0.5;
    table.candidates = 2;
  }
  void write() {
    const Result<void> written =
        writeRegisterReport(folder_.path(), summary, table, fronts, backs, "abc");
    ASSERT_TRUE(written.has_value()) << written.error().sentence();
  }
  nlohmann::json json() { return *readJson(folder_.path() / "report.json"); }
  std::string page() { return *readFile(folder_.path() / "report.html"); }
  TemporaryFolder folder_;
  RegisterSummary summary;
  decisions::PairTable table;
  std::vector<scan::Scan> fronts, backs;
};

TEST_F(RegisterReport, HasTheFiguresOfEachPair) {
  summary.unusable = 1;
  summary.warnings = {message("y.ply cannot be read.")};
  write();
  const nlohmann::json report = json();
  EXPECT_EQ(report.at("command"), "register");
  EXPECT_EQ(report.at("inputs_hash"), "abc");
  EXPECT_EQ(report.at("candidates"), 2);
  EXPECT_EQ(report.at("unusable_scans"), 1);
  EXPECT_EQ(report.at("unpaired_back"), (std::vector<std::string>{"y"}));
  EXPECT_EQ(report.at("warnings").size(), 1U);
  const nlohmann::json& pair = report.at("pairs").at(0);
  EXPECT_EQ(pair.at("front"), "a<b>&1");
  EXPECT_EQ(pair.at("score"), 0.984375);
  EXPECT_EQ(pair.at("fracture_rms_mm"), 0.0625);
  EXPECT_EQ(pair.at("uncertainty_mm"), 0.125);
  EXPECT_EQ(pair.at("contour_rms_mm"), 0.5);
}

// What a person is told of the uncertainty is twice its sigma.
TEST_F(RegisterReport, ShowsThemWithTheirUnitsAndTheNamesLetterByLetter) {
  write();
  for (const char* text : {"<td>a&lt;b&gt;&amp;1</td>", "98.44 %", "0.062 mm", "75 %", "0.25 mm",
                           "Certain.", "Backs without a front: y."})
    EXPECT_THAT(page(), HasSubstr(text));
  EXPECT_THAT(page(), Not(HasSubstr("a<b>")));
  EXPECT_THAT(page(), Not(HasSubstr("height=\"-"))) << "of a slice without points";
}

// 0 mm would read as a perfect fit.
TEST_F(RegisterReport, HasNoFigureForWhatWasNotCompared) {
  summary.pairs[0].fracture_rms_mm = summary.pairs[0].fracture_overlap = 0;
  summary.pairs[0].score.reset();
  summary.pairs[0].margin.reset();
  write();
  const nlohmann::json pair = json().at("pairs").at(0);
  for (const char* figure : {"score", "margin", "fracture_rms_mm", "fracture_overlap"})
    EXPECT_TRUE(pair.at(figure).is_null()) << figure;
  EXPECT_THAT(page(), Not(HasSubstr("0.000 mm")));
  EXPECT_THAT(page(), HasSubstr("Nearest outline."));
}

TEST_F(RegisterReport, SaysWhyAPersonMustLookAndWhichOtherIsLikely) {
  summary.pairs[0].ambiguous = true;
  summary.pairs[0].reason = "Ambiguous: a second position fits almost as well.";
  table.pairs[0].decision.alternatives = {{0, 1, 0.015}};
  write();
  EXPECT_THAT(page(), HasSubstr("Needs review: " + summary.pairs[0].reason));
  EXPECT_THAT(page(), HasSubstr(" with y (1.5 %)."));
  EXPECT_THAT(page(), HasSubstr("1 pairs, 1 to review."));
}

}  // namespace
}  // namespace ostraka::scansets
