#include "decisions/piece_edits.h"

#include <gmock/gmock.h>

#include "decisions/candidate_table.h"
#include "tests/core/model/shapes.h"

namespace ostraka::decisions {
namespace {

using batch::Side;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A sherd of 24 x 18 mm with its middle there.
scan::Scan pieceAt(const std::string& id, float x_mm, float y_mm) {
  PointCloud cloud = model::scanOfBox({}, false, 1);
  for (Eigen::Vector3f& p : cloud.points) p += Eigen::Vector3f(x_mm, y_mm, 0);
  return {id, std::move(cloud), {}, Eigen::Vector3d::UnitZ()};
}

PairDecision edit(DecisionKind kind, const std::vector<scan::Scan>& scans) {
  PairDecision d;
  d.kind = kind;
  d.by = "AP";
  d.at = "2026-07-14T09:30:12Z";
  for (const scan::Scan& scan : scans) d.scans.push_back(refOf(scan, Side::Front));
  return d;
}

PairDecision cutAlong(const scan::Scan& scan, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to) {
  PairDecision d = edit(DecisionKind::Split, {scan});
  d.cut_mm = {from, to};
  return d;
}

std::vector<std::string> idsOf(const EditedPieces& edited) {
  std::vector<std::string> ids;
  for (const scan::Scan& scan : edited.scans) ids.push_back(scan.id);
  return ids;
}

TEST(PieceEdits, CutAPieceAndJoinItAgain) {
  const scan::Scan whole = pieceAt("f003", 50, 20);
  const PairDecision cut = cutAlong(whole, {50, -30}, {50, 70});
  const EditedPieces two = editedPieces({whole}, Side::Front, {cut});
  ASSERT_THAT(idsOf(two), ElementsAre("f003", "f004")) << "the next free number";
  EXPECT_EQ(two.scans[0].cloud.size() + two.scans[1].cloud.size(), whole.cloud.size());
  for (const Eigen::Vector3f& p : two.scans[0].cloud.points)
    ASSERT_LE(p.x(), 50) << "left of the line as one walks along it";
  EXPECT_EQ(two.scans[0].cloud.normals.size(), two.scans[0].cloud.size());
  for (const scan::Scan& part : two.scans) EXPECT_FALSE(part.fracture.empty());

  const PairDecision join = edit(DecisionKind::Join, two.scans);
  const EditedPieces one = editedPieces({whole}, Side::Front, {cut, join});
  ASSERT_THAT(idsOf(one), ElementsAre("f003"));
  EXPECT_EQ(one.scans[0].cloud.size(), whole.cloud.size());
  EXPECT_THAT(one.warnings, IsEmpty());
}

TEST(PieceEdits, JoinAnyNumberAndKeepTheFirstOnesId) {
  const std::vector<scan::Scan> scans = {pieceAt("f001", 0, 0), pieceAt("f002", 40, 0),
                                         pieceAt("f003", 80, 0), pieceAt("f004", 120, 0)};
  const EditedPieces edited =
      editedPieces(scans, Side::Front, {edit(DecisionKind::Join, {scans[2], scans[0], scans[3]})});
  ASSERT_THAT(idsOf(edited), ElementsAre("f002", "f003"));
  EXPECT_EQ(edited.scans[1].cloud.size(), 3 * scans[0].cloud.size());
}

// Scans that only the camera of one of them gave colours would be of no colour in part.
TEST(PieceEdits, DropWhatOnlyOneOfTheJoinedHas) {
  std::vector<scan::Scan> scans = {pieceAt("f001", 0, 0), pieceAt("f002", 40, 0)};
  scans[0].cloud.colors.resize(scans[0].cloud.size());
  const EditedPieces edited = editedPieces(scans, Side::Front, {edit(DecisionKind::Join, scans)});
  ASSERT_EQ(edited.scans.size(), 1u);
  EXPECT_THAT(edited.scans[0].cloud.colors, IsEmpty());
  EXPECT_EQ(edited.scans[0].cloud.normals.size(), edited.scans[0].cloud.size());
}

// f002 and what was beside it are one scan by now: with f002 twice, f003 would be lost.
TEST(PieceEdits, JoinNoPieceTwice) {
  const std::vector<scan::Scan> scans = {pieceAt("f001", 0, 0), pieceAt("f002", 40, 0),
                                         pieceAt("f003", 80, 0)};
  const scan::Scan beside = pieceAt("f009", 45, 0);
  for (const std::vector<scan::Scan>& meant :
       {std::vector{scans[0], scans[1], beside}, {scans[1], scans[0], beside}}) {
    const EditedPieces edited = editedPieces(scans, Side::Front, {edit(DecisionKind::Join, meant)});
    EXPECT_THAT(idsOf(edited), ElementsAre("f001", "f002", "f003"));
    EXPECT_EQ(edited.scans[1].cloud.size(), scans[1].cloud.size());
    ASSERT_EQ(edited.warnings.size(), 1u);
    EXPECT_THAT(edited.warnings[0].english(),
                HasSubstr("2026-07-14 09:30 UTC by AP merges fragments that no longer exist"));
  }
}

TEST(PieceEdits, OfOtherPhotographsOrBesideThePieceAreNamedAndNotDone) {
  const std::vector<scan::Scan> scans = {pieceAt("f001", 0, 0), pieceAt("f002", 40, 0)};
  PairDecision earlier = edit(DecisionKind::Join, scans);
  for (ScanRef& scan : earlier.scans) scan.photographs = "first";
  const EditedPieces again = editedPieces(scans, Side::Front, {earlier}, "second");
  EXPECT_EQ(again.scans.size(), 2u) << "the side was photographed again";
  ASSERT_EQ(again.warnings.size(), 1u);
  EXPECT_THAT(again.warnings[0].english(), HasSubstr("decide again"));

  // 18 mm beside it, and along its edge, where no outline would be left.
  for (const float x : {30.0f, 12.05f}) {
    const EditedPieces beside =
        editedPieces({scans[0]}, Side::Front, {cutAlong(scans[0], {x, -50}, {x, 50})});
    EXPECT_EQ(beside.scans.size(), 1u) << x;
    ASSERT_EQ(beside.warnings.size(), 1u) << x;
    EXPECT_THAT(beside.warnings[0].english(), HasSubstr("splits a fragment"));
  }
}

TEST(PieceEdits, AreThoseOfTheirSideAlone) {
  const std::vector<scan::Scan> scans = {pieceAt("b001", 0, 0), pieceAt("b002", 40, 0)};
  const Decisions joined = {edit(DecisionKind::Join, scans)};
  EXPECT_TRUE(hasEdits(joined, Side::Front));
  EXPECT_FALSE(hasEdits(joined, Side::Back));
  EXPECT_FALSE(hasEdits({edit(DecisionKind::Aside, scans)}, Side::Front));
  const EditedPieces backs = editedPieces(scans, Side::Back, joined);
  EXPECT_EQ(backs.scans.size(), 2u);
  EXPECT_THAT(backs.warnings, IsEmpty());
}

}  // namespace
}  // namespace ostraka::decisions
