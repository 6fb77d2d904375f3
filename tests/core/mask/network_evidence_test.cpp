#include "mask/network_evidence.h"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <stop_token>
#include <vector>

namespace ostraka::mask {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Thing {
  uchar probability;   // of sherd by the network, 0..255
  float heights;       // odds; below 0: in the plate
  int sherd_rows = 0;  // of 10 rows that the network takes for sherd all the same
};
constexpr Thing kSherd{240, 3}, kLabel{0, -2}, kFlatSherd{220, -1}, kStrangeSherd{0, 3};

// A view of things side by side, groups 1, 2, ...
ViewState viewOf(const std::vector<Thing>& things) {
  const int columns = 10 * static_cast<int>(things.size());
  ViewState view;
  view.group = cv::Mat1b(10, columns, uchar{0});
  view.probability = cv::Mat1b(10, columns, uchar{0});
  view.height_odds = cv::Mat1f(20, 2 * columns, 0.F);
  for (int i = 0; i < static_cast<int>(things.size()); ++i) {
    const cv::Range place(10 * i + 1, 10 * i + 9);
    view.group.colRange(place) = static_cast<uchar>(i + 1);
    view.probability.colRange(place) = things[i].probability;
    view.probability(cv::Range(0, things[i].sherd_rows), place) = 240;
    view.height_odds.colRange(2 * place.start, 2 * place.end) = things[i].heights;
  }
  return view;
}

TEST(FlatGroups, AreFlatAndNothingToTheNetwork) {
  const std::vector views{viewOf({kSherd, kLabel, kFlatSherd, kSherd, kStrangeSherd})};
  EXPECT_THAT(findFlatGroups(views), ElementsAre(2));
}

TEST(FlatGroups, AreNoneThatOneOfTwentyPhotographsShowsAsSherds) {
  std::vector views(19, viewOf({kSherd, kLabel}));
  views.push_back(viewOf({kSherd, kFlatSherd}));
  EXPECT_THAT(findFlatGroups(views), IsEmpty());
}

TEST(FlatGroups, AreNoneThatASherdTouches) {
  const Thing bar_with_sherd{0, -2, 2};
  EXPECT_THAT(findFlatGroups(std::vector{viewOf({kSherd, bar_with_sherd})}), IsEmpty());
}

TEST(FlatGroups, AreNoneToANetworkWithoutANotionOfTheOthers) {
  EXPECT_THAT(findFlatGroups(std::vector{viewOf({kStrangeSherd, kLabel, kStrangeSherd})}),
              IsEmpty());
}

TEST(FlatGroups, AreNotAllThatThereIs) {
  EXPECT_THAT(findFlatGroups(std::vector{viewOf({kLabel})}), IsEmpty());
}

// A view of things side by side, 40 x 40 cells each, as dark as `shade` (log), of 4 x 4 pixels.
struct Dark {
  uchar probability;
  float heights;  // odds
  float shade = -1;
};
ViewState shadedView(const std::vector<Dark>& things) {
  const int columns = 40 * static_cast<int>(things.size());
  ViewState view;
  view.group = cv::Mat1b(40, columns, uchar{1});
  view.probability = cv::Mat1b(40, columns);
  view.height_odds = cv::Mat1f(80, 2 * columns);
  view.residual = cv::Mat3f(160, 4 * columns);
  view.log_odds = cv::Mat1f(160, 4 * columns, 8.F);
  for (int i = 0; i < static_cast<int>(things.size()); ++i) {
    view.probability.colRange(40 * i, 40 * (i + 1)) = things[i].probability;
    view.height_odds.colRange(80 * i, 80 * (i + 1)) = things[i].heights;
    view.residual.colRange(160 * i, 160 * (i + 1)) = cv::Scalar::all(things[i].shade);
  }
  return view;
}
float oddsInTheMiddle(const ViewState& view, int thing) {
  return view.log_odds(80, 160 * thing + 80);
}

constexpr Dark kDarkClay{250, 4}, kShade{5, 0.5F};

TEST(ShadeLimits, AreWhatTheNetworkSaysWhereItKnowsDarkClay) {
  ViewState view = shadedView({kDarkClay, kShade, {5, 0.5F, 0}});
  limitInShade(learnShadeLimits(std::vector{view}, 4, true), 0, view);
  EXPECT_FLOAT_EQ(oddsInTheMiddle(view, 0), 8);
  EXPECT_NEAR(oddsInTheMiddle(view, 1), std::log(5.0 / 250) + 0.5, 1e-4);
  EXPECT_FLOAT_EQ(oddsInTheMiddle(view, 2), 8);  // in the light
}

TEST(ShadeLimits, LeaveWhatSurelyStandsHigh) {
  ViewState view = shadedView({kDarkClay, kDarkClay, {5, 0.9F}, {0, 0}});
  view.height_odds.colRange(2 * 80, 3 * 80) = 0.9F;  // not high enough to be learnt from
  const ShadeLimits limits = learnShadeLimits(std::vector{view}, 4, true);
  view.height_odds.colRange(2 * 80, 3 * 80) = 6;
  limitInShade(limits, 0, view);
  EXPECT_GT(oddsInTheMiddle(view, 2), 2);
  EXPECT_LT(oddsInTheMiddle(view, 3), -5);
}

TEST(ShadeLimits, AreNoneToANetworkThatOftenMissesDarkClay) {
  // A hundredth of what is dark and stands high it takes for none.
  ViewState view = shadedView({kDarkClay, kShade});
  view.probability(cv::Rect(0, 0, 4, 4)) = 0;
  const std::vector<ViewState> before{view};
  limitInShade(learnShadeLimits(before, 4, true), 0, view);
  EXPECT_FLOAT_EQ(oddsInTheMiddle(view, 1), 8);
}

TEST(ShadeLimits, AreNoneWhereNothingDarkStandsHigh) {
  ViewState view = shadedView({{250, 0}, kShade});
  limitInShade(learnShadeLimits(std::vector{view}, 4, true), 0, view);
  EXPECT_FLOAT_EQ(oddsInTheMiddle(view, 1), 8);
}

// Things that the network knows, each with its shade in one group, and one that it misses.
ViewState viewOfTwoThings(uchar first, uchar second) {
  ViewState view = shadedView({{first, 4, 0}, kShade, {second, 4}, kShade});
  view.group.colRange(80, 160) = uchar{2};
  return view;
}

TEST(ShadeLimits, AreThoseOfTheBatchAloneWhereShadowsTurn) {
  ViewState view = viewOfTwoThings(250, 0);
  limitInShade(learnShadeLimits(std::vector{view}, 4, false), 0, view);
  for (int thing : {1, 2, 3}) EXPECT_FLOAT_EQ(oddsInTheMiddle(view, thing), 8);
}

TEST(ShadeLimits, AreThoseOfEachThing) {
  ViewState view = viewOfTwoThings(250, 0);
  limitInShade(learnShadeLimits(std::vector{view}, 4, true), 0, view);
  EXPECT_LT(oddsInTheMiddle(view, 1), -3);
  EXPECT_FLOAT_EQ(oddsInTheMiddle(view, 2), 8);  // black clay that the network misses
  EXPECT_FLOAT_EQ(oddsInTheMiddle(view, 3), 8);
}

TEST(ShadeLimits, AreThoseOfMostPhotographsWhereOneShowsTooLittle) {
  std::vector<ViewState> views(4, viewOfTwoThings(250, 0));
  views.push_back(viewOfTwoThings(0, 0));  // here the network misses the first, too
  views.push_back(viewOfTwoThings(250, 0));
  views.back().height_odds.colRange(0, 80) = 2.9F;
  const ShadeLimits limits = learnShadeLimits(views, 4, true);
  for (std::size_t i = 0; i < views.size(); ++i) limitInShade(limits, i, views[i]);
  EXPECT_LT(oddsInTheMiddle(views[0], 1), -3);
  EXPECT_FLOAT_EQ(oddsInTheMiddle(views[4], 1), 8);
  EXPECT_LT(oddsInTheMiddle(views[5], 1), -3);
  EXPECT_FLOAT_EQ(oddsInTheMiddle(views[5], 3), 8);
}

// A view of 64 x 64 pixels: bare paper but for a corner.
ViewState viewOfPaper() {
  ViewState view;
  view.log_odds = cv::Mat1f(64, 64, -3.F);
  view.log_odds(cv::Rect(0, 0, 32, 32)) = 3;
  view.height_odds = cv::Mat1f(32, 32, 0.F);
  view.hull.inside = insideOf(view.log_odds, 4);
  view.hull.clear = 1 - view.hull.inside;
  return view;
}

TEST(AddNetwork, ChangesNothingWhereTheNetworkHasNoNotionOfThings) {
  // All is paper to the network; what other evidence is sure of stays.
  const std::vector<cv::Mat> photographs(4, cv::Mat(64, 64, CV_8UC3, cv::Scalar(225, 230, 235)));
  std::vector<ViewState> views;
  for (int i = 0; i < 4; ++i) views.push_back(viewOfPaper());
  int looked = 0;
  ASSERT_TRUE(addNetwork(photographs, views, 4, 2, [&] { ++looked; }, {}).has_value());
  EXPECT_EQ(looked, 4);
  const ViewState before = viewOfPaper();
  for (const ViewState& view : views) {
    EXPECT_EQ(view.probability.size(), view.hull.clear.size());
    EXPECT_LT(cv::norm(view.log_odds, before.log_odds, cv::NORM_INF), 0.05);
    EXPECT_LT(cv::norm(view.hull.inside, before.hull.inside, cv::NORM_INF), 0.05);
  }
}

TEST(AddNetwork, CanBeCancelled) {
  const std::vector<cv::Mat> photographs(1, cv::Mat(64, 64, CV_8UC3, cv::Scalar(225, 230, 235)));
  std::vector<ViewState> views{viewOfPaper()};
  std::stop_source source;
  source.request_stop();
  const Result<void> added = addNetwork(
      photographs, views, 4, 1, [] {}, source.get_token());
  ASSERT_FALSE(added.has_value());
  EXPECT_EQ(added.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::mask
