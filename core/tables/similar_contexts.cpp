#include "tables/similar_contexts.h"

#include <algorithm>

#include "base/text.h"

namespace ostraka::tables {

Result<void> SimilarContexts::note(const catalogue::Catalogue& catalogue,
                                   const catalogue::BagPlace& made) {
  constexpr std::size_t kMostNamed = 10;
  const Result<std::string> other = catalogue::contextReadAlike(catalogue, made);
  if (!other) return other.error();
  if (other->empty()) return {};
  std::string words = made.context + " (" + *other + ")";
  if (noted_.size() >= kMostNamed) words = "\u2026";
  if (std::ranges::find(noted_, words) == noted_.end()) noted_.push_back(std::move(words));
  return {};
}

std::optional<Message> SimilarContexts::warning() const {
  if (noted_.empty()) return {};
  return message(
      "New contexts differ from existing ones only in zeros, letter case or punctuation: %1; check "
      "for typos.",
      joined(noted_, ", "));
}

}  // namespace ostraka::tables
