// What people said of a batch that both houses have: decisions.json and mask_strokes.json.
#include "batch/peoples_files.h"

#include <gmock/gmock.h>

#include "decisions/decisions.h"
#include "decisions/mask_strokes.h"
#include "intake/review_decisions.h"
#include "intake/settle_batch.h"
#include "two_houses.h"

namespace ostraka::merge {
namespace {

using namespace catalogue;
using decisions::DecisionKind, decisions::MaskStroke;
using testing::ElementsAre;
using testing::IsEmpty;
using Strokes = std::vector<MaskStroke>;

class PeoplesFiles : public TwoHouses {
 protected:
  PeoplesFiles() : b_(copied("b")) {}
  static std::filesystem::path resultsOf(const upkeep::Project& project) {
    return project.resultsFolder("B0001");
  }
  static decisions::ScanRef scan(batch::Side side, int piece) {
    return {side,
            (side == batch::Side::Front ? "f00" : "b00") + std::to_string(piece),
            {40.0 * piece, 0},
            {}};
  }
  /// As the window does it: into the file, then into the catalogue.
  static std::string decide(upkeep::Project& project, DecisionKind kind,
                            std::vector<decisions::ScanRef> scans) {
    decisions::PairDecision decision;
    decision.kind = kind;
    decision.by = "AP";
    decision.scans = std::move(scans);
    decision = valueIn(decisions::appendDecision(resultsOf(project), decision));
    const Result<void> entered =
        intake::enterDecision(project.catalogue(), "B0001", decision, resultsOf(project));
    EXPECT_TRUE(entered) << entered.error().sentence();
    return decision.id;
  }
  static std::string pair(upkeep::Project& project, int piece) {
    return decide(project, DecisionKind::Pair,
                  {scan(batch::Side::Front, piece), scan(batch::Side::Back, piece)});
  }
  static std::vector<std::string> idsOf(const decisions::Decisions& all) {
    std::vector<std::string> ids;
    for (const decisions::PairDecision& decision : all) ids.push_back(decision.id);
    return ids;
  }
  void resultsAreEntered(upkeep::Project& project) {
    const auto entered = intake::enterResults(project.catalogue(), project.folder(), batch,
                                              resultsOf(project), {}, quiet, {});
    EXPECT_TRUE(entered) << entered.error().sentence();
  }
  static MaskStroke stroke(int position, double x) {
    MaskStroke s;
    s.camera = 1;
    s.stop = position;
    s.radius_px = 5;
    s.path_px = {{x, 10}};
    s.by = "AP";
    s.at = "2026-07-14T09:30:12Z";
    s.photograph = sha256(std::to_string(position));
    return s;
  }
  static void paint(const upkeep::Project& project, const Strokes& strokes) {
    const Result<void> written = decisions::writeMaskStrokes(resultsOf(project), strokes);
    EXPECT_TRUE(written) << written.error().sentence();
  }
  static Strokes paintedIn(const upkeep::Project& project) {
    return valueIn(decisions::readMaskStrokes(resultsOf(project)));
  }
  upkeep::Project b_;
};

TEST_F(PeoplesFiles, ADecisionOfBIsReadAndEnteredAfterwards) {
  const std::string id = pair(b_, 2);
  EXPECT_TRUE(merged(*project_, b_).entered);
  const auto read = decisions::readDecisions(resultsOf(*project_));
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_THAT(idsOf(*read), ElementsAre(id));
  resultsAreEntered(*project_);
  EXPECT_EQ(merged(*project_, b_).files, 0) << "once";
  EXPECT_TRUE(merged(b_, *project_).entered);
  EXPECT_EQ(bytesOf(resultsOf(b_) / batch::kDecisionsFile),
            bytesOf(resultsOf(*project_) / batch::kDecisionsFile));
}

TEST_F(PeoplesFiles, OfDecisionsOfBothTheSettledOneStands) {
  const std::string own = decide(*project_, DecisionKind::Aside, {scan(batch::Side::Front, 2)});
  const std::string theirs = pair(b_, 2);
  const MergeReport open = merged(*project_, b_);
  Settled settled;
  for (const std::string& id : openIn(open)) settled[id] = take(Take::B);
  ASSERT_FALSE(settled.empty());
  EXPECT_TRUE(merged(*project_, b_, settled).entered);
  const auto read = decisions::readDecisions(resultsOf(*project_));
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_THAT(idsOf(decisions::standing(*read)), ElementsAre(theirs));
  EXPECT_THAT(idsOf(*read), testing::Contains(own)) << "nothing is removed";
  resultsAreEntered(*project_);
}

TEST_F(PeoplesFiles, StrokesOfBComeThoughNothingElseDiffers) {
  paint(b_, {stroke(0, 1), stroke(3, 2)});
  const MergeReport preview =
      valueIn(mergeInto(*project_, b_.folder(), MergeMode::Preview, {}, anna, quiet, {}));
  EXPECT_EQ(preview.files, 1);
  EXPECT_THAT(paintedIn(*project_), IsEmpty());
  EXPECT_EQ(merged(*project_, b_).files, 1);
  EXPECT_EQ(paintedIn(*project_), paintedIn(b_));
  EXPECT_EQ(valueIn(Settings(catalogue()).value("mask_strokes.B0001")),
            decisions::knownText(paintedIn(b_)))
      << "so that they are missed when they are gone";
  EXPECT_EQ(merged(*project_, b_).files, 0) << "once";
}

TEST_F(PeoplesFiles, StrokesAreJoinedByPhotograph) {
  const MaskStroke both = stroke(0, 1), only_a = stroke(1, 2), only_b = stroke(2, 3),
                   later = stroke(0, 4);
  paint(*project_, {both, only_a});
  paint(b_, {both, later, only_b});
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_THAT(paintedIn(*project_), testing::UnorderedElementsAre(both, later, only_a, only_b));
  EXPECT_TRUE(merged(b_, *project_).entered);
  EXPECT_THAT(paintedIn(b_), testing::UnorderedElementsAre(both, later, only_a, only_b));
}

TEST_F(PeoplesFiles, StrokesThatOneProjectTookAwayStayAway) {
  const MaskStroke first = stroke(0, 1), second = stroke(0, 2), third = stroke(1, 3),
                   later = stroke(0, 4);
  for (const upkeep::Project* project : {project_.get(), &b_})
    paint(*project, {first, second, third});
  const auto takeAway = [&](upkeep::Project& project, const Strokes& rest) {
    const Strokes before = paintedIn(project);
    paint(project, rest);
    EXPECT_TRUE(
        intake::rememberTakenStrokes(project.catalogue(), "B0001", before, rest, anna).has_value());
  };
  takeAway(b_, {first, second});  // all of one photograph
  takeAway(b_, {first});
  EXPECT_EQ(merged(*project_, b_).conflicts.size(), 0u);
  EXPECT_EQ(paintedIn(*project_), Strokes{first});
  // A goes on, and takes away what B has still.
  paint(*project_, {first, later});
  EXPECT_TRUE(merged(*project_, b_).conflicts.empty());
  EXPECT_EQ(paintedIn(*project_), (Strokes{first, later}));
  takeAway(*project_, {later});
  EXPECT_TRUE(merged(b_, *project_).conflicts.empty());
  EXPECT_EQ(paintedIn(b_), Strokes{later});
}

TEST_F(PeoplesFiles, APhotographThatBothPaintedOnIsSettledOnceForBothDirections) {
  const Strokes own = {stroke(0, 1)}, theirs = {stroke(0, 2)};
  const std::string id =
      "masks/" + valueIn(Batches(catalogue()).get(batch)).id + "/front/cam1_pos00";
  paint(*project_, own);
  paint(b_, theirs);
  const MergeReport open = merged(*project_, b_);
  EXPECT_FALSE(open.entered);
  EXPECT_THAT(openIn(open), ElementsAre(id));
  EXPECT_EQ(open.conflicts.front().name, "B0001 front/cam1_pos00");
  EXPECT_EQ(open.conflicts.front().b.by, "AP");
  EXPECT_EQ(paintedIn(*project_), own);
  EXPECT_TRUE(merged(*project_, b_, {{id, take(Take::A)}}).entered);
  EXPECT_EQ(paintedIn(*project_), own);
  EXPECT_THAT(merged(*project_, b_).conflicts, IsEmpty());
  EXPECT_EQ(paintedIn(*project_), own);
  EXPECT_THAT(merged(b_, *project_).conflicts, IsEmpty());
  EXPECT_EQ(paintedIn(b_), own);
  // What is painted anew is asked anew, and can be taken from B.
  paint(b_, {stroke(0, 3)});
  EXPECT_THAT(openIn(merged(*project_, b_)), ElementsAre(id));
  EXPECT_TRUE(merged(*project_, b_, {{id, take(Take::B)}}).entered);
  EXPECT_EQ(paintedIn(*project_), Strokes{stroke(0, 3)});
}

TEST_F(PeoplesFiles, ResultsOfBDoNotReplaceWhatAPainted) {
  records::BatchRecord record;
  record.number = "B0007";
  const store::BatchRow row = valueIn(Batches(catalogue()).add(record, anna));
  upkeep::Project cluster = copied("cluster");
  const ResultFolder two(cluster.resultsFolder("B0007"), 2);
  ASSERT_TRUE(intake::enterResults(cluster.catalogue(), cluster.folder(), row,
                                   cluster.resultsFolder("B0007"), {}, quiet, {}));
  const MaskStroke own = stroke(0, 1), theirs = stroke(1, 2);
  ASSERT_TRUE(decisions::writeMaskStrokes(project_->resultsFolder("B0007"), {own}));
  ASSERT_TRUE(decisions::writeMaskStrokes(cluster.resultsFolder("B0007"), {theirs}));
  EXPECT_TRUE(merged(*project_, cluster).entered);
  EXPECT_TRUE(std::filesystem::exists(project_->resultsFolder("B0007") / "pairs.json"));
  EXPECT_EQ(valueIn(decisions::readMaskStrokes(project_->resultsFolder("B0007"))),
            (Strokes{own, theirs}));
}

TEST_F(PeoplesFiles, StrokesThatCannotBeReadStopAll) {
  put(resultsOf(b_) / batch::kMaskStrokesFile, "{\"format\": 7}");
  const std::string before = contentIn(*project_);
  const Result<MergeReport> refused = tried(*project_, b_, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().where, testing::HasSubstr("mask_strokes.json"));
  EXPECT_EQ(contentIn(*project_), before);
}

}  // namespace
}  // namespace ostraka::merge
