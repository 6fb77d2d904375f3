// What a sherd leaves behind that is moved to another context.
#include "intake/sherd_moves.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "catalogue/places.h"
#include "catalogue/typed_place.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "sherds/typed_numbers.h"
#include "store/names.h"

namespace ostraka::intake {
namespace {

constexpr std::pair<const char*, std::string records::SherdRecord::*> kParts[] = {
    {"site", &records::SherdRecord::site},
    {"trench", &records::SherdRecord::trench},
    {"context", &records::SherdRecord::context_number},
    {"bag", &records::SherdRecord::bag_number}};

class Mover {
 public:
  explicit Mover(const catalogue::Catalogue& catalogue) : catalogue_(catalogue) {}

  void move(const records::SherdRecord& sherd, std::span<const records::FieldChange> wanted) {
    const auto first = static_cast<std::ptrdiff_t>(move_.changes.size());
    move_.changes.insert(move_.changes.end(), wanted.begin(), wanted.end());
    records::SherdRecord moved = sherd;
    std::set<std::string> named;
    for (const records::FieldChange& change : wanted)
      for (const auto& [field, part] : kParts)
        if (change.field == field) {
          moved.*part = store::trimmed(change.value);
          named.insert(field);
        }
    byItsWholeName(sherd, moved, named);
    moved.context = contextOf(moved);
    const bool leaves = !moved.context && moved.context_number.empty() && sherd.context &&
                        sherd.state != records::SherdState::Numbered && !named.contains("site") &&
                        !named.contains("trench");
    if (!moved.context && !leaves) return;
    if (leaves) moved.site = moved.trench = {};
    const bool moves = moved.context != sherd.context;
    if (moves && !named.contains("bag") && !sherd.bag_number.empty() && !hasBag(moved)) {
      if (moved.context)
        move_.lacking.insert({moved.site, moved.trench, moved.context_number, sherd.bag_number});
      moved.bag_number.clear();
      ++move_.without_bag;
    }
    for (const auto& [field, part] : kParts) {
      const auto change = std::find_if(
          move_.changes.begin() + first, move_.changes.end(),
          [&, name = field](const records::FieldChange& one) { return one.field == name; });
      if (change != move_.changes.end())
        change->value = moved.*part;
      else if (moved.*part != sherd.*part)
        move_.changes.push_back({sherd.row, field, moved.*part});
    }
    if (moves && moved.context && namesOnly(sherd, moved)) move_.numbers.push_back(sherd.number);
  }
  Move take() { return std::move(move_); }

 private:
  // KT26-A-012 typed as the context, KT26-A-012-4 typed as the bag, 012 where only one context has
  // that number: all codes come from it.
  void byItsWholeName(const records::SherdRecord& sherd, records::SherdRecord& moved,
                      std::set<std::string>& named) {
    records::SherdRecord below = moved;
    const store::ContextRow context = contextOf(below);
    const bool by_context = named.contains("context") && !moved.context_number.empty();
    const bool by_bag = !by_context && named.contains("bag") && !moved.bag_number.empty();
    const bool is_known =
        by_context ? static_cast<bool>(context)
        : by_bag
            ? context && store::valueOrThrow(
                             catalogue::Places(catalogue_).bagByNumber(context, moved.bag_number))
            : true;
    if (is_known) return;
    catalogue::BagPlace written;
    if (named.contains("site")) written.site = moved.site;
    if (named.contains("trench")) written.trench = moved.trench;
    if (by_context) written.context = moved.context_number;
    if (named.contains("bag")) written.bag = moved.bag_number;
    std::optional<records::SherdRecord> place;
    if (written.site.empty() && sherd.context && by_context) {
      catalogue::BagPlace nearby = written;
      nearby.site = sherd.site;
      place = knownPlace(moved, nearby);
    }
    if (!place) {
      place = knownPlace(moved, written);
      // Into another site only what names it.
      const std::string text = by_context ? written.context : written.bag;
      if (place && sherd.context && written.site.empty() && place->site != sherd.site &&
          !store::codeKey(text).starts_with(store::codeKey(place->site)))
        return;
    }
    if (!place) return;
    if (place->bag_number.empty())
      place->bag_number = moved.bag_number;
    else
      named.insert("bag");
    moved = *place;
  }

  std::optional<records::SherdRecord> knownPlace(records::SherdRecord moved,
                                                 const catalogue::BagPlace& written) {
    const auto [known, fresh] =
        read_.try_emplace(std::array{written.site, written.trench, written.context, written.bag});
    if (fresh) {
      const auto read = catalogue::readPlace(catalogue_, written);
      if (!read && read.error().code != ErrorCode::UnusableInput)
        throw store::Refused(read.error());
      if (read) known->second = *read;
    }
    if (!known->second) return {};
    moved.site = known->second->site;
    moved.trench = known->second->trench;
    moved.context_number = known->second->context;
    moved.bag_number = known->second->bag;
    return contextOf(moved) ? std::optional(moved) : std::nullopt;
  }

  bool hasBag(const records::SherdRecord& moved) {
    if (!moved.context) return false;
    return static_cast<bool>(store::valueOrThrow(
        catalogue::Places(catalogue_).bagByNumber(moved.context, moved.bag_number)));
  }

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
    if (!known->second.row) return {};
    place.site = known->second.site_code;
    place.trench = known->second.trench_code;
    place.context_number = known->second.number;
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
  std::map<std::array<std::string, 4>, std::optional<catalogue::BagPlace>> read_;
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
