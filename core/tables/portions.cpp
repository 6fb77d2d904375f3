// Long imports leave room for others, and are remembered until they came to their end.
#include "tables/portions.h"

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "catalogue/settings.h"
#include "files/json_numbers.h"
#include "files/json_text.h"

namespace ostraka::tables {
namespace {

using catalogue::Catalogue;
using nlohmann::json;

constexpr const char* kUnfinished = "import.unfinished";
constexpr std::size_t kMostKept = 20;
constexpr auto kTogether = std::chrono::milliseconds(20);  // rows of one transaction
constexpr auto kForOthers = std::chrono::milliseconds(5);  // who waits looks every 2 ms

// Each table that broke off has an entry of its own, the latest last.
Result<void> remember(Catalogue& catalogue, const std::string& source, std::size_t entered,
                      std::size_t of) {
  json all = json::array();
  for (const UnfinishedImport& other : unfinishedImports(catalogue))
    if (other.source != source)
      all.push_back({{"source", other.source}, {"entered", other.entered}, {"of", other.of}});
  if (entered < of) all.push_back({{"source", source}, {"entered", entered}, {"of", of}});
  if (all.size() > kMostKept) all.erase(all.begin());
  return catalogue::Settings(catalogue).setValue(kUnfinished,
                                                 all.empty() ? std::string() : all.dump());
}

}  // namespace

Result<std::size_t> enterInPortions(Catalogue& catalogue, std::size_t count,
                                    const ImportOptions& options, Progress& progress,
                                    const std::stop_token& stop,
                                    const std::function<Result<void>(std::size_t)>& enter) {
  const bool preview = options.mode == ImportMode::Preview;
  std::size_t next = 0;
  // Rows until others have waited long enough; of a preview all.
  const auto portion = [&]() -> Result<void> {
    const auto begin = std::chrono::steady_clock::now();
    while (next < count) {
      if (stop.stop_requested()) {
        if (preview) return Error::cancelled();
        break;  // what was entered stays, and is remembered as a part
      }
      if (next % 64 == 0)
        progress.report(static_cast<std::int64_t>(next), static_cast<std::int64_t>(count));
      if (Result<void> entered = enter(next); !entered) return entered;
      ++next;
      if (!preview && std::chrono::steady_clock::now() - begin > kTogether) break;
    }
    return preview || next == 0 ? Result<void>() : remember(catalogue, options.source, next, count);
  };
  if (preview) {
    if (const Result<void> done = previewOrEnter(catalogue, options.mode, portion); !done)
      return done.error();
    return next;
  }
  while (next < count && !stop.stop_requested()) {
    const std::size_t entered = next;
    if (const Result<void> done = catalogue.together(portion); !done) {
      Error error = done.error();
      if (error.code != ErrorCode::Cancelled)
        error.what =
            inOne(error.what,
                  message("%1 rows in total, %2 read; run the same import again for the others.",
                          count, entered));
      return error;
    }
    if (next < count) std::this_thread::sleep_for(kForOthers);
  }
  if (next == 0 && count > 0) return Error::cancelled();
  return next;
}

std::vector<UnfinishedImport> unfinishedImports(const Catalogue& catalogue) {
  std::vector<UnfinishedImport> list;
  const Result<std::string> kept = catalogue::Settings(catalogue).value(kUnfinished);
  if (!kept) return list;
  const json all = jsonOrDiscarded(*kept);
  if (!all.is_array()) return list;
  for (const json& one : all)
    if (one.is_object())
      list.push_back({one.value("source", ""), wholeOr(one, "entered", 0), wholeOr(one, "of", 0)});
  return list;
}

Result<void> forgetUnfinishedImports(Catalogue& catalogue) {
  return catalogue::Settings(catalogue).setValue(kUnfinished, {});
}

}  // namespace ostraka::tables
