#include "intake/settle_batch.h"

#include <gtest/gtest.h>

#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "intake/batch_figures.h"
#include "synthetic_out.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

class SettleBatch : public catalogue::SmallProject {
 protected:
  SettleBatch() : batch(newBatch({bag4})) {}
  store::BatchRow batch;
};

TEST_F(SettleBatch, ABatchIsSettledUnlessItsScaleIsInDoubt) {
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Review, {}));
  ASSERT_TRUE(settleBatch(catalogue(), "B0001", "AP", true));
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  ASSERT_TRUE(settleBatch(catalogue(), "B0001", "", false)) << "nobody said a name";
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
  records::BatchRecord doubtful = *catalogue::Batches(catalogue()).get(batch);
  doubtful.scale_doubts = {"The scale is wrong: 50 mm measure 49.5 mm."};
  ASSERT_TRUE(catalogue::Batches(catalogue()).save(doubtful, {}));
  ASSERT_TRUE(settleBatch(catalogue(), "B0001", "AP", true));
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
}

TEST_F(SettleBatch, TheResultsSayWhatWaitsForAPerson) {
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Done, {}));
  EXPECT_FALSE(settleByResults(project_->folder(), "B0001", "AP")) << "there are no results";
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  pipeline::writeSyntheticOut(project_->resultsFolder("B0001"), {});
  const Result<bool> wants_computing = settleByResults(project_->folder(), "B0001", "AP");
  ASSERT_TRUE(wants_computing) << wants_computing.error().sentence();
  EXPECT_FALSE(*wants_computing);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
  const auto kept = keptFigures(catalogue(), "B0001");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->ask, 2) << "the near-duplicates";
  EXPECT_EQ(kept->sure, 2);
}

// Wherever it is interrupted, the catalogue tells of no stroke that the file lacks.
TEST_F(SettleBatch, TheCatalogueKnowsTheStrokesOfAFileAndNoOthers) {
  const auto stroke = [](int position) {
    decisions::MaskStroke s;
    s.stop = position;
    s.radius_px = 5;
    s.path_px = {{10, 10}};
    return s;
  };
  const auto isKnown = [&](const std::vector<decisions::MaskStroke>& strokes) {
    return catalogue::valueIn(catalogue::Settings(catalogue()).value("mask_strokes.B0001")) ==
           decisions::knownText(strokes);
  };
  const std::vector<decisions::MaskStroke> none, one = {stroke(0)}, two = {stroke(0), stroke(1)};
  const std::filesystem::path out = project_->resultsFolder("B0001");
  const auto save = [&](const auto& before, const auto& after, const auto& known_meanwhile) {
    const auto saved = saveStrokes(catalogue(), "B0001", before, after, anna, [&] {
      EXPECT_TRUE(before.empty() || isKnown(known_meanwhile));
      return decisions::writeMaskStrokes(out, after);
    });
    ASSERT_TRUE(saved) << saved.error().sentence();
    EXPECT_TRUE(isKnown(after));
  };
  save(none, one, none);
  save(one, two, one);
  save(two, one, one);
  EXPECT_FALSE(saveStrokes(catalogue(), "B0001", one, two, anna,
                           [] { return Result<void>(Error::cancelled()); }));
  EXPECT_TRUE(isKnown(one));
  ASSERT_TRUE(decisions::writeMaskStrokes(out, two));
  ASSERT_TRUE(followStrokes(catalogue(), "B0001", out));
  EXPECT_TRUE(isKnown(two));
  ASSERT_TRUE(decisions::writeMaskStrokes(out, one));
  ASSERT_TRUE(followStrokes(catalogue(), "B0001", out));
  EXPECT_TRUE(isKnown(two)) << "what was lost is not taken for what a person took away";
}

}  // namespace
}  // namespace ostraka::intake
