#include "batch/flip.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "base/median.h"
#include "batch/exif.h"
#include "batch/photographs.h"

namespace ostraka::batch {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLeastSide = 3;  // photographs; fewer are no side

// The last number in the name, as cameras count; none that is longer than nine digits.
std::optional<std::int64_t> numberOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t last = stem.find_last_of("0123456789");
  if (last == std::string::npos) return {};
  const std::size_t before = stem.find_last_not_of("0123456789", last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  if (last - first >= 9) return {};
  std::int64_t number = 0;
  std::from_chars(stem.data() + first, stem.data() + last + 1, number);
  return number;
}

// Behind the largest jump that is one; else the middle.
std::size_t proposal(const std::vector<fs::path>& files) {
  std::size_t at = files.size() / 2;
  std::int64_t largest = 1;
  for (std::size_t i = kLeastSide; i + kLeastSide <= files.size(); ++i) {
    const auto before = numberOf(files[i - 1]), after = numberOf(files[i]);
    if (!before || !after || *after - *before <= largest) continue;
    largest = *after - *before;
    at = i;
  }
  return at;
}

}  // namespace

std::optional<std::size_t> flipIn(const std::vector<std::int64_t>& taken_ms, std::size_t least_side,
                                  double pauses) {
  if (taken_ms.size() < 2 * least_side || taken_ms.size() < 2) return {};
  std::vector<std::int64_t> all;
  for (std::size_t i = 1; i < taken_ms.size(); ++i) all.push_back(taken_ms[i] - taken_ms[i - 1]);
  std::size_t longest = least_side;
  for (std::size_t i = least_side; i + least_side <= taken_ms.size(); ++i)
    if (all[i - 1] > all[longest - 1]) longest = i;
  const auto pause = static_cast<double>(all[longest - 1]);
  std::int64_t next = 0;
  for (std::size_t i = least_side; i + least_side <= taken_ms.size(); ++i)
    if (i != longest) next = std::max(next, all[i - 1]);
  const auto usual = static_cast<double>(medianOf(all));
  if (pause <= 0 || pause < pauses * usual || pause < 2 * static_cast<double>(next)) return {};
  return longest;
}

Series seriesOf(std::vector<fs::path> files) {
  Series series;
  std::vector<std::pair<std::int64_t, fs::path>> timed;
  for (const fs::path& file : files)
    if (const auto ms = readExif(file).takenMs()) timed.emplace_back(*ms, file);
  if (timed.size() == files.size() && !files.empty()) {
    std::ranges::stable_sort(timed, {}, [](const auto& one) { return one.first; });
    std::vector<std::int64_t> times;
    for (const auto& [ms, file] : timed) {
      times.push_back(ms);
      series.files.push_back(file);
    }
    const auto flip = flipIn(times, kLeastSide);
    series.flip_found = flip.has_value();
    series.first_back = flip.value_or(proposal(series.files));
    return series;
  }
  std::ranges::sort(files, inOrderOfNames);
  series.first_back = proposal(files);
  series.files = std::move(files);
  return series;
}

}  // namespace ostraka::batch
