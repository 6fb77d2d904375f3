#include "review/more_candidates.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "files/files.h"
#include "files/json.h"
#include "review/review.h"

namespace ostraka::review {
namespace {

namespace fs = std::filesystem;

// Found so far. orders: per front all backs, the likeliest first, but those whose fractures cannot
// be compared.
struct Found {
  decisions::CandidateTable table;
  std::map<int, std::vector<int>> orders;
};

fs::path fileOf(const LivePairs& live) {
  return live.output() / "work" / "more_candidates.json";
}

// Tells this table of pairs from every other; the dates of files would not, since a laptop's clock
// may go back.
std::string pairsOf(const LivePairs& live) {
  return sha256(toJson(live.table()).dump());
}

// Empty where nothing is kept, or only of pairs that were computed anew since.
Found kept(const LivePairs& live) {
  Found none;
  none.table = live.table();
  none.table.candidates.clear();
  Result<decisions::CandidateTable> table = decisions::readCandidates(fileOf(live));
  const auto text = readJson(fileOf(live));
  if (!table || !text || text->value("pairs", nlohmann::json()) != pairsOf(live)) return none;
  Found found{std::move(*table), {}};
  const int backs = static_cast<int>(found.table.backs.size());
  try {
    for (const auto& order : text->at("orders"))
      found.orders[order.at("front").get<int>()] = order.at("backs").get<std::vector<int>>();
  } catch (const nlohmann::json::exception&) {
    return none;
  }
  for (const auto& [front, order] : found.orders)
    for (const int back : order)
      if (back < 0 || back >= backs) return none;
  return found;
}

Result<void> keep(const LivePairs& live, Found& found) {
  std::sort(found.table.candidates.begin(), found.table.candidates.end(),
            [](const decisions::RegisteredCandidate& a, const decisions::RegisteredCandidate& b) {
              return std::pair(a.evidence.front, a.evidence.back) <
                     std::pair(b.evidence.front, b.evidence.back);
            });
  nlohmann::ordered_json text = toJson(found.table);
  text["pairs"] = pairsOf(live);
  text["orders"] = nlohmann::ordered_json::array();
  for (const auto& [front, backs] : found.orders)
    text["orders"].push_back({{"front", front}, {"backs", backs}});
  return writeFileAtomically(fileOf(live), text.dump(1) + "\n");
}

}  // namespace

Result<std::optional<decisions::RegisteredCandidate>> nextCandidate(const LivePairs& live,
                                                                    int front,
                                                                    std::span<const int> known,
                                                                    Progress& progress,
                                                                    std::stop_token stop) {
  Found found = kept(live);
  if (!found.orders.contains(front)) {
    Result<std::vector<int>> order = live.likeliestBacks(front, progress, stop);
    if (!order) return order.error();
    found.orders[front] = std::move(*order);
    if (const Result<void> done = keep(live, found); !done) return done.error();
  }
  std::vector<int>& order = found.orders[front];
  while (true) {
    const auto next = std::find_if(order.begin(), order.end(), [&](int back) {
      return std::find(known.begin(), known.end(), back) == known.end();
    });
    if (next == order.end()) return std::optional<decisions::RegisteredCandidate>();
    if (const decisions::RegisteredCandidate* there = found.table.find(front, *next))
      return std::optional(*there);
    Result<decisions::RegisteredCandidate> compared = live.compared(front, *next, stop);
    if (!compared && compared.error().code == ErrorCode::Cancelled) return compared.error();
    if (!compared) {
      order.erase(next);
    } else {
      found.table.candidates.push_back(*compared);
    }
    if (const Result<void> done = keep(live, found); !done) return done.error();
    if (compared) return std::optional(std::move(*compared));
  }
}

Result<void> prepareCandidates(const fs::path& output, int wanted, Progress& progress,
                               std::stop_token stop) {
  const auto live = LivePairs::open(output);
  if (!live) return live.error();
  const Result<Review> review = loadReview(output);
  if (!review) return review.error();
  std::int64_t done = 0;
  for (const ReviewCard& card : review->cards) {
    progress.report(done++, static_cast<std::int64_t>(review->cards.size()));
    if (card.state != CardState::Ask && card.state != CardState::Alone) continue;
    std::vector<int> known;
    for (const ReviewCandidate& candidate : card.candidates) known.push_back(candidate.back);
    while (static_cast<int>(known.size()) < wanted) {
      QuietProgress quiet;
      const auto next = nextCandidate(**live, card.front, known, quiet, stop);
      if (!next) return next.error();
      if (!*next) break;
      known.push_back((*next)->evidence.back);
    }
  }
  return {};
}

}  // namespace ostraka::review
