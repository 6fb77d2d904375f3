#include "batch/copied_photographs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "base/message.h"
#include "base/text.h"
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
    return failed ? 0 : bytes;
  });
  const Alike by_beginning =
      parted(by_size, [&](std::size_t i) { return beginningOf(shots[i].file); });
  return parted(by_beginning, [&](std::size_t i) {
    const Result<std::string> bytes = readFile(shots[i].file);
    return bytes ? sha256(*bytes) : shots[i].file.string();
  });
}

using Shared = std::vector<std::array<std::size_t, 2>>;  // one photograph: of the front, the back

std::size_t sideOf(const Shot& shot) {
  return shot.side == Side::Front ? 0 : 1;
}

// All but one are left out; returns that one.
std::size_t keepOne(const std::vector<Shot>& shots, const std::vector<std::size_t>& copies,
                    std::set<std::size_t>& left_out, Progress& progress) {
  const std::size_t kept = *std::ranges::min_element(copies, [&](std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t i) {
      return std::tuple(shots[i].mask_file.empty(), shots[i].file.filename().string().size(), i);
    };
    return rank(a) < rank(b);
  });
  for (const std::size_t copy : copies)
    if (copy != kept) {
      left_out.insert(copy);
      progress.note(
          NoteLevel::Warning,
          about(shots[copy].file, message("This photograph is identical to %1; it is left out.",
                                          shots[kept].file.filename())));
    }
  return kept;
}

// On one of its sides such a photograph is wrong, and nothing says on which.
Result<void> leaveOutShared(const std::vector<Shot>& shots, const Shared& shared,
                            std::set<std::size_t>& left_out, Progress& progress) {
  std::size_t photographs[2] = {0, 0};
  for (std::size_t i = 0; i < shots.size(); ++i)
    if (!left_out.contains(i)) ++photographs[sideOf(shots[i])];
  const std::size_t side = photographs[0] < photographs[1] ? 0 : 1;
  if (2 * shared.size() > photographs[side]) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(shared.size(), 3); ++i)
      names.push_back(shots[shared[i][side]].file.filename().string());
    return Error::unusable(
        message(side == 0 ? translatable<3>("%1 of the %2 photographs of the front side are "
                                            "identical to photographs of the back side (such as "
                                            "%3), so the batch cannot be used; give each side its "
                                            "own photographs.")
                          : translatable<3>("%1 of the %2 photographs of the back side are "
                                            "identical to photographs of the front side (such as "
                                            "%3), so the batch cannot be used; give each side its "
                                            "own photographs."),
                shared.size(), photographs[side], joined(names, ", ")),
        shots[shared.front()[side]].file.parent_path());
  }
  for (const auto& [front, back] : shared) {
    progress.note(NoteLevel::Warning,
                  about(shots[back].file,
                        message("This photograph is identical to %1 of the front side; it is left "
                                "out of both sides.",
                                shots[front].file)));
    left_out.insert(front);
    left_out.insert(back);
  }
  return {};
}

Result<void> areEnough(const std::vector<Shot>& shots, const std::set<std::size_t>& left_out,
                       const ReadBatchOptions& options) {
  for (const std::size_t out : left_out) {
    std::ptrdiff_t left = 0;
    for (std::size_t i = 0; i < shots.size(); ++i)
      left += shots[i].side == shots[out].side && !left_out.contains(i) ? 1 : 0;
    if (left < options.min_views_per_side)
      return tooFewOf(shots[out].side, left, options.min_views_per_side,
                      shots[out].file.parent_path());
  }
  return {};
}

void countAnew(std::vector<Shot>& shots) {
  int next[2] = {0, 0};
  for (Shot& shot : shots) shot.camera = next[sideOf(shot)]++;
}

}  // namespace

Result<void> leaveOutCopies(Batch& batch, const ReadBatchOptions& options, Progress& progress) {
  std::set<std::size_t> left_out;
  Shared shared;
  for (const std::vector<std::size_t>& copies : copiesIn(batch.shots)) {
    std::vector<std::size_t> of[2];
    for (const std::size_t shot : copies) of[sideOf(batch.shots[shot])].push_back(shot);
    std::array<std::size_t, 2> kept{};
    for (const std::size_t side : {0u, 1u})
      if (!of[side].empty()) kept[side] = keepOne(batch.shots, of[side], left_out, progress);
    if (!of[0].empty() && !of[1].empty()) shared.push_back(kept);
  }
  // In the order of the photographs, not of their sizes.
  std::sort(shared.begin(), shared.end());
  if (!shared.empty())
    if (Result<void> few = leaveOutShared(batch.shots, shared, left_out, progress); !few)
      return few;
  if (Result<void> enough = areEnough(batch.shots, left_out, options); !enough) return enough;
  std::vector<Shot> kept;
  for (std::size_t i = 0; i < batch.shots.size(); ++i)
    if (!left_out.contains(i)) kept.push_back(std::move(batch.shots[i]));
  batch.shots = std::move(kept);
  if (batch.way == Way::FreeCamera) countAnew(batch.shots);
  return {};
}

}  // namespace ostraka::batch
