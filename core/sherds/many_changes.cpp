#include "sherds/many_changes.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <thread>
#include <utility>

#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"

namespace ostraka::sherds {
namespace {

constexpr std::size_t kTogether = 100;                     // some 50 ms
constexpr auto kForOthers = std::chrono::milliseconds(3);  // SQLite wakes nobody: they look again

// Where the next transaction ends: all changes of a sherd belong together.
std::size_t endOf(std::span<const records::FieldChange> changes, std::size_t begin) {
  std::size_t end = std::min(begin + kTogether, changes.size());
  while (end < changes.size() && changes[end].sherd == changes[end - 1].sherd) ++end;
  return end;
}

}  // namespace

Result<std::vector<records::FieldChange>> changeMany(const catalogue::Catalogue& catalogue,
                                                     std::span<const records::FieldChange> changes,
                                                     const records::Provenance& provenance,
                                                     Progress& progress, std::stop_token stop) {
  std::vector<std::vector<records::FieldChange>> undo;  // of each transaction
  const auto takeBack = [&](const Error& why) -> Error {
    while (!undo.empty()) {
      if (const auto done = SherdChanges(catalogue).apply(undo.back(), provenance); !done)
        return {done.error().code,
                inOne(why.what,
                      message("Some of the changes remain because they could not be undone: %1",
                              done.error().what)),
                done.error().where};
      undo.pop_back();
    }
    return why;
  };
  for (std::size_t begin = 0; begin < changes.size();) {
    if (stop.stop_requested()) return takeBack(Error::cancelled());
    progress.report(static_cast<std::int64_t>(begin), static_cast<std::int64_t>(changes.size()));
    const std::size_t end = endOf(changes, begin);
    Result<std::vector<records::FieldChange>> done =
        SherdChanges(catalogue).apply(changes.subspan(begin, end - begin), provenance);
    if (!done) return takeBack(done.error());
    undo.push_back(std::move(*done));
    begin = end;
    if (begin < changes.size()) std::this_thread::sleep_for(kForOthers);
  }
  std::vector<records::FieldChange> all;
  for (auto part = undo.rbegin(); part != undo.rend(); ++part)
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

std::vector<records::FieldChange> changesAgain(std::span<const records::FieldChange> changes,
                                               std::span<const records::FieldChange> undo) {
  std::map<std::pair<std::int64_t, std::string>, std::string> before;
  for (const records::FieldChange& back : undo)
    before.emplace(std::pair(back.sherd.value, back.field), back.value);
  std::vector<records::FieldChange> again;
  for (const records::FieldChange& change : changes) {
    const auto found = before.find({change.sherd.value, change.field});
    if (found == before.end()) continue;
    again.push_back(change);
    again.back().expected = found->second;
  }
  return again;
}

}  // namespace ostraka::sherds
