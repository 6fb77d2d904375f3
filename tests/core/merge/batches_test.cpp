// Batches that both houses computed.
#include <gmock/gmock.h>

#include "two_houses.h"

namespace ostraka::merge {
namespace {

using namespace catalogue;

class TwoComputations : public Conflicts {
 protected:
  /// B0005 in both projects, computed in each; b_moves: by how much B finds its pieces elsewhere.
  void compute(double b_moves_mm) {
    for (upkeep::Project* project : {&*project_, &b_}) {
      records::BatchRecord b;
      b.number = "B0005";
      b.id = kBatch;
      const store::BatchRow row = valueIn(Batches(project->catalogue()).add(b, anna));
      ResultFolder two(project->resultsFolder("B0005"), 2);
      if (project == &b_)
        for (Eigen::Vector2d& place : two.places_mm) place.x() += b_moves_mm;
      two.write();
      ASSERT_TRUE(intake::enterResults(project->catalogue(), project->folder(), row,
                                       project->resultsFolder("B0005"), {}, quiet, {}));
      ASSERT_EQ(sherds::Sherds(project->catalogue()).rows(row)->size(), 2u);
    }
  }
  std::size_t sherdsOfBatch() {
    const store::BatchRow row = Batches(catalogue()).byNumber("B0005")->row;
    return sherds::Sherds(catalogue()).rows(row)->size();
  }
  const std::string kBatch = "01980000-0000-7000-8000-000000000005";
};

TEST_F(TwoComputations, ThatFoundTheSameAreOneByThemselves) {
  compute(0);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(sherdsOfBatch(), 2u);
}

TEST_F(TwoComputations, ThatFoundOtherPiecesKeepTheResultsOfA) {
  compute(30);
  settle({{"batch/" + kBatch + "/results", take(Take::A)}});
  EXPECT_EQ(sherdsOfBatch(), 4u) << "nothing is lost";
}

}  // namespace
}  // namespace ostraka::merge
