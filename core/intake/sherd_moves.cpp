// What a sherd leaves behind that is moved to another context.
#include "intake/sherd_moves.h"

#include <array>
#include <map>

#include "catalogue/places.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "sherds/typed_numbers.h"
#include "store/names.h"

namespace ostraka::intake {
namespace {

class Mover {
 public:
  explicit Mover(const catalogue::Catalogue& catalogue) : catalogue_(catalogue) {}

  void move(const records::SherdRecord& sherd, std::span<const records::FieldChange> wanted) {
    move_.changes.insert(move_.changes.end(), wanted.begin(), wanted.end());
    records::SherdRecord moved = sherd;
    bool bag_named = false;
    for (const records::FieldChange& change : wanted) {
      if (change.field == "site") moved.site = change.value;
      if (change.field == "trench") moved.trench = change.value;
      if (change.field == "context") moved.context_number = change.value;
      if (change.field == "bag") moved.bag_number = change.value;
      bag_named |= change.field == "bag";
    }
    moved.context = contextOf(moved);
    const bool refused = !moved.context && (!store::trimmed(moved.context_number).empty() ||
                                            sherd.state == records::SherdState::Numbered);
    if (refused || moved.context == sherd.context) return;
    if (!bag_named && !sherd.bag_number.empty()) {
      moved.bag_number.clear();
      move_.changes.push_back({sherd.row, "bag", {}});
      ++move_.without_bag;
      move_.bags.insert(sherd.bag_number);
    }
    if (moved.context && namesOnly(sherd, moved)) move_.numbers.push_back(sherd.number);
  }
  Move take() { return std::move(move_); }

 private:
  // With its codes as the catalogue writes them; none: there is no such context.
  store::ContextRow contextOf(records::SherdRecord& place) {
    const std::string context = store::trimmed(place.context_number);
    if (context.empty()) return {};
    const auto key = std::array{place.site, place.trench, context};
    auto known = contexts_.find(key);
    if (known == contexts_.end()) {
      const store::ContextRow row = store::valueOrThrow(
          catalogue::Places(catalogue_)
              .contextByPlace(store::trimmed(key[0]), store::trimmed(key[1]), context));
      known =
          contexts_
              .emplace(key, row ? store::valueOrThrow(catalogue::Places(catalogue_).context(row))
                                : records::ContextRecord())
              .first;
    }
    place.site = known->second.site_code;
    place.trench = known->second.trench_code;
    place.context_number = known->second.row ? known->second.number : context;
    return known->second.row;
  }

  // The number names the place where the sherd was, not the one where it comes.
  bool namesOnly(const records::SherdRecord& sherd, const records::SherdRecord& moved) const {
    if (sherd.number.empty()) return false;
    const Result<bool> before = sherds::fitsThePlace(catalogue_, sherd, sherd.number);
    const Result<bool> then = sherds::fitsThePlace(catalogue_, moved, sherd.number);
    return before && *before && !(then && *then);
  }

  const catalogue::Catalogue& catalogue_;
  std::map<std::array<std::string, 3>, records::ContextRecord> contexts_;
  Move move_;
};

}  // namespace

Result<Move> moveOf(const catalogue::Catalogue& catalogue,
                    std::span<const records::FieldChange> wanted) {
  return catalogue.database().asResult([&] {
    std::vector<store::SherdRow> rows;
    for (const records::FieldChange& change : wanted)
      if (rows.empty() || rows.back() != change.sherd) rows.push_back(change.sherd);
    Mover mover(catalogue);
    std::size_t begin = 0;
    for (const records::SherdRecord& sherd :
         store::valueOrThrow(sherds::Sherds(catalogue).of(rows))) {
      std::size_t end = begin;
      while (end < wanted.size() && wanted[end].sherd == sherd.row) ++end;
      mover.move(sherd, wanted.subspan(begin, end - begin));
      begin = end;
    }
    return mover.take();
  });
}

}  // namespace ostraka::intake
