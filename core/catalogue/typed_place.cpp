#include "catalogue/typed_place.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "base/message.h"
#include "base/text.h"
#include "catalogue/places.h"
#include "store/database.h"
#include "store/names.h"

namespace ostraka::catalogue {
namespace {

using Codes = std::vector<const std::string*>;

enum class Mark { None, Blank, Dash };  // Dash: - or /

// What is typed, or a code: its letters as a unique key, and what stands before each of them and
// behind the last. The word bag between blanks is a blank.
struct Letters {
  std::string key;
  std::vector<Mark> before;
  std::vector<std::size_t> from;  ///< of each in the text that was typed, and its end
};

Letters lettersOf(const std::string& text) {
  Letters all;
  const std::string folded = store::uniqueKey(text);
  Mark mark = Mark::None;
  const auto isBlank = [&](std::size_t at) {
    return at >= folded.size() || std::isspace(static_cast<unsigned char>(folded[at])) != 0;
  };
  for (std::size_t i = 0; i < folded.size(); ++i) {
    const bool is_bag = mark == Mark::Blank && !all.key.empty() &&
                        folded.compare(i, 3, "bag") == 0 && i + 3 < folded.size() && isBlank(i + 3);
    if (is_bag) i += 3;
    if (is_bag || isBlank(i)) {
      mark = std::max(mark, Mark::Blank);
    } else if (folded[i] == '-' || folded[i] == '/') {
      mark = Mark::Dash;
    } else {
      all.key += folded[i];
      all.before.push_back(std::exchange(mark, Mark::None));
      all.from.push_back(i);
    }
  }
  all.before.push_back(Mark::Dash);  // an end is one
  all.from.push_back(folded.size());
  return all;
}

// Where the code ends that begins at this letter of what was typed; none: another is there.
std::optional<std::size_t> endOf(const Letters& code, const Letters& typed, std::size_t begin) {
  const std::size_t count = code.key.size();
  if (typed.key.compare(begin, count, code.key) != 0) return {};
  for (std::size_t i = 1; i < count; ++i) {
    const Mark there = typed.before[begin + i];
    if (code.before[i] == Mark::Dash ? there == Mark::None : there == Mark::Dash) return {};
  }
  if (typed.before[begin + count] == Mark::None) return {};
  return begin + count;
}

std::optional<std::size_t> endOf(const Codes& codes, const Letters& typed) {
  std::optional<std::size_t> end = 0;
  for (const std::string* code : codes)
    if (end && !code->empty()) end = endOf(lettersOf(*code), typed, *end);
  return end;
}

bool hasDash(const Letters& typed, std::size_t begin) {
  for (std::size_t i = begin + 1; i < typed.key.size(); ++i)
    if (typed.before[i] == Mark::Dash) return true;
  return false;
}

// As it was typed, where folding keeps the text's length.
std::string restOf(const std::string& text, const Letters& typed, std::size_t begin) {
  const std::size_t length = typed.from.back() - typed.from[begin];
  return store::trimmed(
      std::string_view(text).substr(text.size() > length ? text.size() - length : 0));
}

// The bag as the rest of what was typed names it; only one that is known may have dashes.
std::string bagOf(const Catalogue& catalogue, store::ContextRow context, const Letters& typed,
                  std::size_t begin, const std::string& text, bool may_be_new) {
  for (const records::BagRecord& bag : store::valueOrThrow(Places(catalogue).bags(context)))
    if (endOf(lettersOf(bag.number), typed, begin) == typed.key.size()) return bag.number;
  return !may_be_new || hasDash(typed, begin) ? std::string() : restOf(text, typed, begin);
}

std::string nameOf(const BagPlace& place) {
  std::string name = place.site;
  for (const std::string* code : {&place.trench, &place.context})
    if (!code->empty()) name += (name.empty() ? "" : " ") + *code;
  return name;
}

// The context's name with all codes, then without its trench, its site, both.
std::vector<Codes> namesOf(const records::ContextRecord& context) {
  const std::string *site = &context.site_code, *trench = &context.trench_code,
                    *number = &context.number;
  if (trench->empty()) return {{site, number}, {number}};
  return {{site, trench, number}, {site, number}, {trench, number}, {number}};
}

bool isBelow(const records::ContextRecord& context, const BagPlace& below) {
  const auto fits = [](const std::string& code, const std::string& wanted) {
    return wanted.empty() || store::codeKey(code) == store::codeKey(wanted);
  };
  return fits(context.site_code, below.site) && fits(context.trench_code, below.trench);
}

struct Fit {
  std::size_t left_out = 0, letters = 0;  ///< of the codes; of 0012 and 0012-a, the second
  BagPlace place;
  bool operator<(const Fit& other) const {
    return std::pair(other.left_out, letters) < std::pair(left_out, other.letters);
  }
};

std::optional<Fit> fitOf(const Catalogue& catalogue, const records::ContextRecord& context,
                         const Letters& typed, const std::string& text, Named what) {
  const std::vector<Codes> names = namesOf(context);
  for (const Codes& name : names) {
    const auto end = endOf(name, typed);
    if (!end || (*end == typed.key.size()) != (what == Named::Context)) continue;
    Fit fit{names.front().size() - name.size(),
            *end,
            {context.site_code, context.trench_code, context.number, {}}};
    if (what == Named::Context) return fit;
    const bool may_be_new = name.front() == &context.site_code || typed.before[*end] == Mark::Dash;
    fit.place.bag = bagOf(catalogue, context.row, typed, *end, text, may_be_new);
    if (!fit.place.bag.empty()) return fit;
  }
  return {};
}

// A new context in the site and trench that are written before its number, or the only ones.
class NewPlace {
 public:
  NewPlace(const Catalogue& catalogue, const BagPlace& written)
      : catalogue_(catalogue), place_(written) {}

  BagPlace read() {
    if (!place_.site.empty()) return place_;
    const auto sites = store::valueOrThrow(Places(catalogue_).sites());
    const auto* site = taken(sites);
    const bool is_named = site != nullptr;
    if (sites.empty())
      store::refuse(
          message("The project has no site yet; add a column 'Site', or write the "
                  "context with its site, such as %1.",
                  "A-" + place_.context));
    if (!is_named && sites.size() > 1)
      store::refuse(
          message("This project has %1 sites; add a column 'Site', or write the context "
                  "with its site, such as %2.",
                  sites.size(), sites.front().code + "-" + place_.context));
    if (!is_named) site = &sites.front();
    place_.site = site->code;
    if (place_.trench.empty()) readTrench(*site, is_named);
    return place_;
  }

 private:
  // The longest of the codes that the context begins with, which is taken from it.
  template <class Record>
  const Record* taken(const std::vector<Record>& records) {
    const Letters typed = lettersOf(place_.context);
    const Record* found = nullptr;
    std::size_t longest = 0;
    for (const Record& record : records)
      if (const auto end = endOf(lettersOf(record.code), typed, 0);
          end && *end > longest && *end < typed.key.size()) {
        longest = *end;
        found = &record;
      }
    if (found) place_.context = restOf(place_.context, typed, longest);
    return found;
  }
  void readTrench(const records::SiteRecord& site, bool site_is_named) {
    auto trenches = store::valueOrThrow(Places(catalogue_).trenches());
    std::erase_if(trenches, [&](const auto& trench) { return trench.site != site.row; });
    const auto* trench = taken(trenches);
    if (!trench && site_is_named && hasDash(lettersOf(place_.context), 0))
      store::refuse(message("There is no such trench in the site %1; write trench and context in "
                            "columns of their own.",
                            site.code),
                    place_.context);
    if (!trench && trenches.size() > 1)
      store::refuse(
          message("The site %1 has %2 trenches; add a column 'Trench', or write the "
                  "context with its trench, such as %3.",
                  site.code, trenches.size(),
                  site.code + "-" + trenches.front().code + "-" + place_.context));
    if (!trench && !trenches.empty()) trench = &trenches.front();
    if (trench) place_.trench = trench->code;
  }

  const Catalogue& catalogue_;
  BagPlace place_;
};

// Not a new context 12-3 beside 12: the bag is known, or its site is named.
bool isWhole(const Catalogue& catalogue, const BagPlace& bag, const std::string& text) {
  if (endOf(lettersOf(bag.site), lettersOf(text), 0)) return true;
  const Places places(catalogue);
  const auto context =
      store::valueOrThrow(places.contextByPlace(bag.site, bag.trench, bag.context));
  return static_cast<bool>(store::valueOrThrow(places.bagByNumber(context, bag.bag)));
}

}  // namespace

Result<std::optional<BagPlace>> typedPlace(const Catalogue& catalogue, const std::string& text,
                                           Named what, const BagPlace& below) {
  return catalogue.database().asResult([&] {
    const Letters typed = lettersOf(text);
    std::vector<Fit> best;
    for (const records::ContextRecord& context :
         store::valueOrThrow(Places(catalogue).contexts())) {
      if (typed.key.empty() || !isBelow(context, below)) continue;
      const auto fit = fitOf(catalogue, context, typed, text, what);
      if (!fit || (!best.empty() && *fit < best.front())) continue;
      if (!best.empty() && best.front() < *fit) best.clear();
      best.push_back(*fit);
    }
    if (best.size() > 1)
      store::refuse(message("This can be %1 or %2; enter site, trench and context each by itself.",
                            nameOf(best[0].place), nameOf(best[1].place)),
                    text);
    return best.empty() ? std::optional<BagPlace>() : best.front().place;
  });
}

Result<std::string> contextReadAlike(const Catalogue& catalogue, const BagPlace& place) {
  return catalogue.database().asResult([&] {
    for (const records::ContextRecord& known : store::valueOrThrow(Places(catalogue).contexts()))
      if (store::codeKey(known.site_code) == store::codeKey(place.site) &&
          store::codeKey(known.trench_code) == store::codeKey(place.trench) &&
          store::codeKey(known.number) != store::codeKey(place.context) &&
          store::sortKey(known.number) == store::sortKey(place.context))
        return known.number;
    return std::string();
  });
}

std::string placeOfRenamedSite(const Catalogue& catalogue, const std::string& text,
                               const std::string& from, const std::string& to) {
  const std::string key = store::codeKey(from);
  const auto place = typedPlace(catalogue, text, Named::Bag);
  if (place && *place && store::codeKey((*place)->site) != key) return text;
  constexpr std::string_view kMarks = " -/";
  for (std::size_t at = text.find_first_of(kMarks); at != std::string::npos;
       at = text.find_first_of(kMarks, at + 1))
    if (store::codeKey(text.substr(0, at)) == key) return to + text.substr(at);
  return store::codeKey(text) == key ? to : text;
}

Result<BagPlace> readPlace(const Catalogue& catalogue, const BagPlace& written) {
  return catalogue.database().asResult([&] {
    BagPlace place{store::trimmed(written.site), store::trimmed(written.trench),
                   store::trimmed(written.context), store::trimmed(written.bag)};
    const auto typed = [&](const std::string& text, Named what) {
      return store::valueOrThrow(typedPlace(catalogue, text, what, place));
    };
    if (place.context.empty()) {
      const auto whole = place.bag.empty() ? std::nullopt : typed(place.bag, Named::Bag);
      return whole ? *whole : place;
    }
    const store::ContextRow known = store::valueOrThrow(
        Places(catalogue).contextByPlace(place.site, place.trench, place.context));
    if (known) {
      const auto context = store::valueOrThrow(Places(catalogue).context(known));
      return BagPlace{context.site_code, context.trench_code, context.number, place.bag};
    }
    if (auto context = typed(place.context, Named::Context)) {
      context->bag = place.bag;
      return *context;
    }
    const auto bag = place.bag.empty() ? typed(place.context, Named::Bag) : std::nullopt;
    if (bag && isWhole(catalogue, *bag, place.context)) return *bag;
    return NewPlace(catalogue, place).read();
  });
}

}  // namespace ostraka::catalogue
