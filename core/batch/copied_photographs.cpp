#include "batch/copied_photographs.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "batch/photographs.h"
#include "files/files.h"

namespace ostraka::batch {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBeginning_bytes = 1 << 16;  // where photographs of one size differ

std::string beginningOf(const fs::path& file) {
  std::string bytes(kBeginning_bytes, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return sha256(bytes);
}

using Alike = std::vector<std::vector<std::size_t>>;  // shots by index

// Parts each group by what `key` says of a shot; those that are alone in it are no copies.
template <class Key>
Alike parted(const Alike& groups, const Key& key) {
  Alike parts;
  for (const std::vector<std::size_t>& group : groups) {
    std::map<decltype(key(0)), std::vector<std::size_t>> by_key;
    for (const std::size_t shot : group) by_key[key(shot)].push_back(shot);
    for (auto& [of, part] : by_key)
      if (part.size() > 1) parts.push_back(std::move(part));
  }
  return parts;
}

// Only what is alike so far is read further.
Alike copiesIn(const std::vector<Shot>& shots) {
  Alike all(1);
  for (std::size_t i = 0; i < shots.size(); ++i) all[0].push_back(i);
  const Alike by_size = parted(all, [&](std::size_t i) {
    std::error_code failed;
    const std::uintmax_t bytes = fs::file_size(shots[i].file, failed);
    return std::pair(shots[i].side, failed ? 0 : bytes);
  });
  const Alike by_beginning =
      parted(by_size, [&](std::size_t i) { return beginningOf(shots[i].file); });
  return parted(by_beginning, [&](std::size_t i) {
    const Result<std::string> bytes = readFile(shots[i].file);
    return bytes ? sha256(*bytes) : shots[i].file.string();
  });
}

Result<void> enoughOf(const Batch& batch, Side side, const ReadBatchOptions& options) {
  const auto left = std::count_if(batch.shots.begin(), batch.shots.end(),
                                  [side](const Shot& shot) { return shot.side == side; });
  if (left >= options.min_views_per_side) return {};
  return tooFewOf(side, left, options.min_views_per_side, batch.folder);
}

void countAnew(std::vector<Shot>& shots) {
  int next[2] = {0, 0};
  for (Shot& shot : shots) shot.camera = next[shot.side == Side::Front ? 0 : 1]++;
}

}  // namespace

Result<void> leaveOutCopies(Batch& batch, const ReadBatchOptions& options, Progress& progress) {
  std::set<std::size_t> left_out;
  std::set<Side> sides;
  for (const std::vector<std::size_t>& copies : copiesIn(batch.shots)) {
    const std::size_t kept =
        *std::min_element(copies.begin(), copies.end(), [&](std::size_t a, std::size_t b) {
          const auto rank = [&](std::size_t i) {
            return std::tuple(batch.shots[i].mask_file.empty(),
                              batch.shots[i].file.filename().string().size(), i);
          };
          return rank(a) < rank(b);
        });
    for (const std::size_t copy : copies) {
      if (copy == kept) continue;
      progress.note(
          NoteLevel::Warning,
          about(batch.shots[copy].file, message("This photograph is identical to %1; it is left "
                                                "out.",
                                                batch.shots[kept].file.filename())));
      left_out.insert(copy);
      sides.insert(batch.shots[copy].side);
    }
  }
  if (left_out.empty()) return {};
  std::vector<Shot> kept;
  for (std::size_t i = 0; i < batch.shots.size(); ++i)
    if (!left_out.contains(i)) kept.push_back(std::move(batch.shots[i]));
  batch.shots = std::move(kept);
  if (batch.way == Way::FreeCamera) countAnew(batch.shots);
  for (const Side side : sides)
    if (Result<void> enough = enoughOf(batch, side, options); !enough) return enough;
  return {};
}

}  // namespace ostraka::batch
