#include "pairing/candidates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "synthetic_sherd.h"

namespace ostraka::pairing {
namespace {

using test::laid;
using test::LaidScan;
using test::SlabSherd;

struct Batch {
  std::vector<scan::Scan> fronts, backs;
  std::vector<Eigen::Isometry3d> front_from_back;
};

Batch batchOf(const std::vector<SlabSherd>& sherds) {
  Batch batch;
  for (std::size_t i = 0; i < sherds.size(); ++i) {
    const double k = static_cast<double>(i);
    const LaidScan front = laid(sherds[i], 1, 0.5 + k, 40 * k - 60, 20);
    const LaidScan back = laid(sherds[i], -1, 2.0 - 2 * k, 50 - 45 * k, -30);
    batch.fronts.push_back(front.scan);
    batch.backs.push_back(back.scan);
    batch.front_from_back.push_back(front.plate_from_sherd * back.plate_from_sherd.inverse());
  }
  return batch;
}

Result<std::vector<PairCandidate>> candidatesOf(const Batch& batch, CandidateOptions options = {}) {
  QuietProgress quiet;
  return findCandidates(batch.fronts, batch.backs, options, quiet, {});
}

const PairCandidate* candidate(const std::vector<PairCandidate>& all, int front, int back) {
  for (const PairCandidate& c : all) {
    if (c.front == front && c.back == back) return &c;
  }
  return nullptr;
}

TEST(FindCandidates, NamesEachTruePairWithItsPoseFirst) {
  const Batch batch = batchOf({SlabSherd(1), SlabSherd(2), SlabSherd(3)});
  const auto found = candidatesOf(batch);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  for (int i = 0; i < 3; ++i) {
    const PairCandidate* own = candidate(*found, i, i);
    ASSERT_NE(own, nullptr);
    EXPECT_GT(own->log_likelihood, 20);
    const Eigen::Isometry3d off = own->starts[0].front_from_back.inverse() *
                                  batch.front_from_back[static_cast<std::size_t>(i)];
    EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle(), 0.02);  // radians; 0.4 mm at the border
    const Eigen::Vector3d middle =
        batch.backs[static_cast<std::size_t>(i)].cloud.points[0].cast<double>();
    const Eigen::Vector3d shift = own->starts[0].front_from_back * middle -
                                  batch.front_from_back[static_cast<std::size_t>(i)] * middle;
    EXPECT_LT(shift.norm(), 1.0);  // a wall's height is known to a third
  }
}

TEST(FindCandidates, GivesTheInversePoseWhenFrontAndBackAreSwapped) {
  const Batch batch = batchOf({SlabSherd(4)});
  Batch swapped{batch.backs, batch.fronts, {}};
  const auto a = candidatesOf(batch), b = candidatesOf(swapped);
  ASSERT_TRUE(a.has_value() && b.has_value());
  const Eigen::Isometry3d both =
      (*a)[0].starts[0].front_from_back * (*b)[0].starts[0].front_from_back;
  EXPECT_LT(Eigen::AngleAxisd(both.linear()).angle(), 0.005);
  const Eigen::Vector3d p = batch.fronts[0].cloud.points[0].cast<double>();
  EXPECT_LT((both * p - p).norm(), 0.1);
}

TEST(FindCandidates, CountsTrueSize) {
  const Batch batch = batchOf({SlabSherd(5, 15), SlabSherd(5, 18)});  // alike but for 3 mm
  const auto found = candidatesOf(batch);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(candidate(*found, 0, 1), nullptr);
  EXPECT_NE(candidate(*found, 0, 0), nullptr);
}

TEST(FindCandidates, ComparesShapesAloneWhenScaleIsFree) {
  const SlabSherd sherd(6);
  Batch batch = batchOf({sherd});
  for (Eigen::Vector3f& p : batch.backs[0].cloud.points) p *= 0.8f;
  CandidateOptions options;
  options.scale = Scale::Free;
  const auto found = candidatesOf(batch, options);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->size(), 1u);
  EXPECT_NEAR((*found)[0].starts[0].scale, 1.25, 0.01);
  EXPECT_GT((*found)[0].log_likelihood, 10);
}

TEST(FindCandidates, InThePapersFormGiveEachFrontTheNearestBackWhateverItsSize) {
  Batch batch = batchOf({SlabSherd(1), SlabSherd(2), SlabSherd(3)});
  for (Eigen::Vector3f& p : batch.backs[1].cloud.points) p *= 0.8f;
  CandidateOptions options;
  options.method = Method::Paper;
  options.reach = -1;  // no likelihood keeps or drops a pair
  const auto found = candidatesOf(batch, options);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  ASSERT_EQ(found->size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const PairCandidate* own = candidate(*found, i, i);
    ASSERT_NE(own, nullptr);
    EXPECT_GT(own->distance_rad, 0);
    EXPECT_LT(own->distance_rad, 1);  // radians: 0.1 to 0.3 on scans, seldom 0.6
    EXPECT_EQ(own->log_likelihood, 0);
    ASSERT_EQ(own->starts.size(), 1u);
    EXPECT_EQ(own->starts[0].log_likelihood, 0);
  }
}

// A row's minimum, not an assignment: a front whose back is missing takes another front's.
TEST(FindCandidates, InThePapersFormLetTwoFrontsTakeOneBack) {
  Batch batch = batchOf({SlabSherd(1), SlabSherd(2)});
  batch.backs.pop_back();
  CandidateOptions options;
  options.method = Method::Paper;
  const auto found = candidatesOf(batch, options);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  ASSERT_EQ(found->size(), 2u);
  EXPECT_EQ((*found)[0].back, 0);
  EXPECT_EQ((*found)[1].back, 0);
  EXPECT_LT((*found)[0].distance_rad, (*found)[1].distance_rad);
}

TEST(FindCandidates, ListsSeveralPosesOfASymmetricOutline) {
  SlabSherd disc(7);
  for (double& w : disc.waves) w = 0;
  disc.waves[2] = 0.06;  // four equal bulges
  const auto found = candidatesOf(batchOf({disc}));
  ASSERT_TRUE(found.has_value());
  ASSERT_GE((*found)[0].starts.size(), 4u);
  EXPECT_LT((*found)[0].starts[3].contour_rms_mm, 0.15);
}

TEST(FindCandidates, DoesNotDependOnTheNumberOfThreads) {
  const Batch batch = batchOf({SlabSherd(1), SlabSherd(2), SlabSherd(8)});
  CandidateOptions options;
  options.reach = 1e6;
  std::vector<std::vector<PairCandidate>> all;
  for (const int threads : {1, 3, 16}) {
    options.threads = threads;
    all.push_back(*candidatesOf(batch, options));
  }
  for (std::size_t k = 1; k < 3; ++k) {
    ASSERT_EQ(all[k].size(), all[0].size());
    for (std::size_t i = 0; i < all[0].size(); ++i) {
      EXPECT_EQ(all[k][i].log_likelihood, all[0][i].log_likelihood);
      EXPECT_EQ(all[k][i].starts[0].front_from_back.matrix(),
                all[0][i].starts[0].front_from_back.matrix());
    }
  }
}

TEST(FindCandidates, LeavesOutAScanWithoutAnOutlineWithANote) {
  struct Listening final : Progress {
    std::string heard;
    void report(std::int64_t, std::int64_t) override {}
    void note(NoteLevel, const Message& text) override { heard += text.english(); }
  } progress;
  Batch batch = batchOf({SlabSherd(1)});
  scan::Scan broken;
  broken.id = "f009";
  broken.cloud.points.assign(5, Eigen::Vector3f::Zero());
  batch.fronts.push_back(broken);
  const auto found = findCandidates(batch.fronts, batch.backs, {}, progress, {});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->size(), 1u);
  EXPECT_NE(progress.heard.find("f009"), std::string::npos);
}

// A scan in the wrong unit is metres away from all others' outlines: a stranger, not no figure.
TEST(FindCandidates, GivesAFigureForAScanOfAnyLength) {
  Batch batch = batchOf({SlabSherd(1), SlabSherd(2)});
  for (Eigen::Vector3f& p : batch.fronts[1].cloud.points) p *= 200;
  CandidateOptions options;
  options.reach = 1e9;
  const auto found = candidatesOf(batch, options);
  ASSERT_TRUE(found.has_value()) << found.error().what;
  for (const PairCandidate& c : *found) EXPECT_TRUE(std::isfinite(c.log_likelihood));
  const PairCandidate* own = candidate(*found, 0, 0);
  ASSERT_NE(own, nullptr);
  EXPECT_GT(own->log_likelihood, 20);
}

TEST(FindCandidates, StopsOnRequest) {
  const Batch batch = batchOf({SlabSherd(1)});
  std::stop_source source;
  source.request_stop();
  QuietProgress quiet;
  EXPECT_EQ(findCandidates(batch.fronts, batch.backs, {}, quiet, source.get_token()).error().code,
            ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::pairing
