#include "mask/network_evidence.h"

#include <gmock/gmock.h>

namespace ostraka::mask {
namespace {

struct Thing {
  uchar says;     // of the network
  float heights;  // odds; below 0: in the plate
};

// A view of things side by side, groups 1, 2, ...
ViewState viewOf(const std::vector<Thing>& things) {
  const int columns = 10 * static_cast<int>(things.size());
  ViewState view;
  view.group = cv::Mat1b(10, columns, uchar{0});
  view.says = cv::Mat1b(10, columns, uchar{0});
  view.height_odds = cv::Mat1f(20, 2 * columns, 0.F);
  for (int i = 0; i < static_cast<int>(things.size()); ++i) {
    const cv::Range place(10 * i + 1, 10 * i + 9);
    view.group.colRange(place) = static_cast<uchar>(i + 1);
    view.says.colRange(place) = things[i].says;
    view.height_odds.colRange(2 * place.start, 2 * place.end) = things[i].heights;
  }
  return view;
}

TEST(FlatThings, AreFlatAndNothingToTheNetwork) {
  const std::vector views{viewOf({{240, 3}, {0, -2}, {220, -1}, {0, 3}})};
  // The second is a label; the third a flat sherd, the fourth one of a kind that the network has
  // never seen.
  EXPECT_THAT(flatThings(views), testing::ElementsAre(2));
}

TEST(FlatThings, AreNoneWhereOnePhotographShowsASherd) {
  const std::vector views{viewOf({{240, 3}, {0, -2}}), viewOf({{240, 3}, {200, -2}})};
  EXPECT_THAT(flatThings(views), testing::IsEmpty());
}

TEST(FlatThings, AreNoneToANetworkThatSeesNothing) {
  const std::vector views{viewOf({{3, 3}, {0, -2}, {8, 3}})};
  EXPECT_THAT(flatThings(views), testing::IsEmpty());
}

TEST(FlatThings, AreNotAllThatThereIs) {
  const std::vector views{viewOf({{0, -2}})};
  EXPECT_THAT(flatThings(views), testing::IsEmpty());
}

}  // namespace
}  // namespace ostraka::mask
