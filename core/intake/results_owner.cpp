#include "intake/results_owner.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>

#include "base/message.h"
#include "batch/photographs.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "files/json.h"
#include "stages/output_folder.h"
#include "store/database.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using batch::Side;
using store::valueOrThrow;

using SideHashes = std::array<std::set<std::string>, 2>;  // SHA-256 of photographs, by side

std::size_t indexOf(Side side) {
  return side == Side::Front ? 0 : 1;
}

SideHashes bySide(const batch::PhotographHashes& photographs) {
  SideHashes hashes;
  for (const auto& [name, hash] : photographs)
    if (const std::optional<Side> side = batch::sideOf(name)) hashes[indexOf(*side)].insert(hash);
  return hashes;
}

struct Comparison {
  std::array<std::size_t, 2> made_from{}, same{};
  std::array<bool, 2> known{};  // whether the batch has photographs of that side

  bool isForeign(Side side) const {
    const std::size_t i = indexOf(side);
    return known[i] && 2 * same[i] < made_from[i];
  }
  bool isOfTheBatch() const {
    return same[0] + same[1] > 0 && !isForeign(Side::Front) && !isForeign(Side::Back);
  }
  std::size_t all() const { return made_from[0] + made_from[1]; }
  std::size_t others() const { return all() - same[0] - same[1]; }
};

class Owners {
 public:
  Owners(const catalogue::Catalogue& catalogue, const fs::path& project,
         const SideHashes& made_from, const std::stop_token& stop)
      : catalogue_(catalogue), project_(project), made_from_(made_from), stop_(stop) {}

  Comparison with(const records::BatchRecord& batch) const {
    const SideHashes there =
        bySide(valueOrThrow(batch::photographsNow(project_ / "batches" / batch.number, stop_)));
    const SideHashes recorded = recordedOf(batch);
    Comparison compared;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::set<std::string>& now = there[side].empty() ? recorded[side] : there[side];
      compared.known[side] = !now.empty();
      compared.made_from[side] = made_from_[side].size();
      compared.same[side] = static_cast<std::size_t>(std::ranges::count_if(
          made_from_[side], [&](const std::string& hash) { return now.contains(hash); }));
    }
    return compared;
  }

 private:
  SideHashes recordedOf(const records::BatchRecord& batch) const {
    batch::PhotographHashes photographs;
    for (const records::FileRecord& file : valueOrThrow(catalogue::Files(catalogue_).of(batch.row)))
      if (file.role == "photo")
        photographs[fs::path(file.path)
                        .lexically_relative(fs::path("batches") / batch.number)
                        .generic_string()] = file.sha256;
    return bySide(photographs);
  }

  const catalogue::Catalogue& catalogue_;
  const fs::path& project_;
  const SideHashes& made_from_;
  const std::stop_token& stop_;
};

[[noreturn]] void refuseForeign(const Comparison& own, const std::string& number,
                                const fs::path& out) {
  if (own.same[1] > 0 && !own.isForeign(Side::Back))
    store::refuse(message("These results were made from earlier photographs of the front of %1; "
                          "process it again.",
                          number),
                  out);
  if (own.same[0] > 0 && !own.isForeign(Side::Front))
    store::refuse(message("These results were made from earlier photographs of the back of %1; "
                          "process it again.",
                          number),
                  out);
  store::refuse(
      message("These results were not made from the photographs of %1; process it again.", number),
      out);
}

}  // namespace

batch::PhotographHashes photographsOf(const fs::path& out) {
  const fs::path file = out / stages::kInputsRecord;
  std::error_code failed;
  if (!fs::exists(file, failed)) return {};  // it does not say
  const nlohmann::json all = valueOrThrow(readJson(file));
  batch::PhotographHashes photographs;
  if (all.is_object())
    for (const auto& [name, hash] : all.items())
      if (hash.is_string() && batch::sideOf(name)) photographs[name] = hash.get<std::string>();
  return photographs;
}

Result<std::optional<Message>> checkResultsAreOf(const catalogue::Catalogue& catalogue,
                                                 const fs::path& project,
                                                 const records::BatchRecord& batch,
                                                 const fs::path& out, const std::stop_token& stop) {
  return catalogue.database().asResult([&]() -> std::optional<Message> {
    const SideHashes made_from = bySide(photographsOf(out));
    const Owners owners(catalogue, project, made_from, stop);
    const Comparison own = owners.with(batch);
    if (own.all() == 0) {
      if (!own.known[0] && !own.known[1]) return std::nullopt;
      store::refuse(message("These results do not say which photographs they were made from, so "
                            "they are not entered; process %1 again.",
                            batch.number),
                    out);
    }
    if (own.isOfTheBatch()) {
      if (own.others() == 0) return std::nullopt;
      return message(
          "Photographs of %1 that are missing or are others than these results were made from: "
          "%2 of %3. The results are entered; reprocess the batch if it was photographed again.",
          batch.number, own.others(), own.all());
    }
    for (const records::BatchRecord& other : valueOrThrow(catalogue::Batches(catalogue).all()))
      if (other.row != batch.row && owners.with(other).isOfTheBatch())
        store::refuse(
            message("These results were made from the photographs of %1, not of %2; process %3 "
                    "itself.",
                    other.number, batch.number, batch.number),
            out);
    if (own.known[0] || own.known[1]) refuseForeign(own, batch.number, out);
    return std::nullopt;
  });
}

}  // namespace ostraka::intake
