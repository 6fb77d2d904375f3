#include "review/plate_map.h"

#include <algorithm>
#include <tuple>

namespace ostraka::review {
namespace {

using batch::Side;

// The number that the front would share with the rival, and the back have with its.
std::string otherNumber(const ReviewCard& card, const Review& review, Side side) {
  if (card.state != CardState::Ask) return {};
  const ReviewCard* rival = nullptr;
  if (side == Side::Back) {
    // This back may belong to another front.
    if (card.rival_front >= 0) rival = review.ofFront(card.rival_front);
    for (const ReviewCard& other : review.cards)
      if (rival == nullptr && other.state == CardState::Ask && other.rival_back == card.back &&
          other.front != card.front)
        rival = &other;
  }
  return rival == nullptr ? std::string() : rival->number;
}

MapMark markOf(const ReviewCard& card, const Review& review, Side side) {
  MapMark mark;
  mark.scan = side == Side::Front ? card.front : card.back;
  mark.number = card.number;
  mark.other_number = otherNumber(card, review, side);
  mark.state = card.state;
  return mark;
}

// A back that was set aside with its front is still of that front's sherd.
std::string numberOfBackAside(int back, const LivePairs& live, const Review& review,
                              const decisions::Decisions& standing) {
  std::string number;
  for (const decisions::PairDecision& d : standing) {
    if (d.kind != decisions::DecisionKind::Aside && d.kind != decisions::DecisionKind::Reshoot)
      continue;
    const ReviewCard* card = nullptr;
    bool meant = false;
    for (const decisions::ScanRef& ref : d.scans)
      if (ref.side == Side::Front)
        card = review.ofFront(decisions::resolved(ref, live.table().fronts));
      else
        meant = meant || decisions::resolved(ref, live.table().backs) == back;
    if (meant) number = card == nullptr ? std::string() : card->number;
  }
  return number;
}

Result<MapSide> sideOf(const LivePairs& live, Side side, std::vector<MapMark> marks) {
  const Result<rig::PosedImage> image = live.photographed(side);
  if (!image) return image.error();
  MapSide map{image->file, image->intrinsics.width, image->intrinsics.height, {}};
  for (MapMark& mark : marks) {
    auto outlines = live.outlinesIn(*image, mark.scan);
    if (!outlines) return outlines.error();
    const auto& scans = side == Side::Front ? live.table().fronts : live.table().backs;
    mark.place_mm = scans.at(static_cast<std::size_t>(mark.scan)).place_mm;
    for (std::vector<Eigen::Vector2d>& outline : *outlines) {
      MapMark& part = map.marks.emplace_back(mark);
      ++mark.part;
      part.outline = std::move(outline);
      for (const Eigen::Vector2d& p : part.outline)
        part.at += p / static_cast<double>(part.outline.size());
    }
  }
  std::sort(map.marks.begin(), map.marks.end(), [](const MapMark& a, const MapMark& b) {
    return std::tie(a.scan, a.part) < std::tie(b.scan, b.part);
  });
  return map;
}

}  // namespace

Result<PlateMap> plateMap(const LivePairs& live, const decisions::Decisions& standing) {
  const Result<Review> review = reviewOf(live.table(), standing);
  if (!review) return review.error();
  std::vector<MapMark> fronts, backs;
  for (const ReviewCard& card : review->cards) {
    fronts.push_back(markOf(card, *review, Side::Front));
    if (card.back >= 0) backs.push_back(markOf(card, *review, Side::Back));
  }
  const auto nobodys = [&](const std::vector<int>& list, CardState state) {
    for (const int back : list) {
      MapMark mark;
      mark.scan = back;
      if (state != CardState::Alone) mark.number = numberOfBackAside(back, live, *review, standing);
      mark.state = state;
      backs.push_back(mark);
    }
  };
  nobodys(review->lone_backs, CardState::Alone);
  nobodys(review->aside_backs, CardState::Aside);
  nobodys(review->reshoot_backs, CardState::Reshoot);
  Result<MapSide> front = sideOf(live, Side::Front, std::move(fronts));
  if (!front) return front.error();
  Result<MapSide> back = sideOf(live, Side::Back, std::move(backs));
  if (!back) return back.error();
  return PlateMap{std::move(*front), std::move(*back)};
}

}  // namespace ostraka::review
