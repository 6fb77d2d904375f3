#include "calibration/lenses.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "batch/exif.h"

namespace ostraka::calibration {
namespace {

constexpr std::size_t kFewestOfALens = 3;  // views that a calibration needs
constexpr std::size_t kFewestCorners = 24;
constexpr double kZoomed = 1.1;  // breathing of autofocus is 1 to 2 %, one view's error 1 to 3 %

using Views = std::vector<TargetView>;

// Sum of squares that a calibration leaves; nothing where there is none.
std::optional<double> leftBy(const Views& views, int width, int height) {
  Result<IntrinsicsReport> report = calibrateIntrinsics(views, width, height);
  if (!report) report = intrinsicsFromPlate(views, width, height);
  if (!report) return std::nullopt;
  double corners = 0;
  for (const TargetView& view : views) corners += static_cast<double>(view.points.size());
  return report->rms_px * report->rms_px * corners;
}

struct OwnFocal {
  double focal = 0;
  std::size_t shot = 0;
};

// By focal length, each photograph's by itself.
std::vector<OwnFocal> ownFocals(const std::vector<int>& lenses, int lens,
                                std::span<const TargetView> views,
                                std::span<const batch::Shot> shots) {
  std::vector<OwnFocal> own;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (lenses[i] != lens || views[i].points.size() < kFewestCorners) continue;
    const Result<IntrinsicsReport> alone =
        intrinsicsFromPlate(views.subspan(i, 1), shots[i].width, shots[i].height);
    if (alone) own.push_back({alone->intrinsics.fx, i});
  }
  std::ranges::sort(own, {}, &OwnFocal::focal);
  return own;
}

// Where the widest step between focal lengths parts them; 0: nowhere.
std::size_t widestStep(const std::vector<OwnFocal>& own) {
  std::size_t at = 0;
  double widest = kZoomed;
  for (std::size_t k = kFewestOfALens; k + kFewestOfALens <= own.size(); ++k)
    if (const double step = own[k].focal / own[k - 1].focal; step > widest) widest = step, at = k;
  return at;
}

}  // namespace

std::vector<int> lensesOf(std::span<const batch::Shot> shots) {
  std::map<std::tuple<int, int, std::string, double>, int> numbers;
  std::vector<int> lenses;
  for (const batch::Shot& shot : shots) {
    const batch::Exif exif = batch::readExif(shot.file);
    lenses.push_back(numbers
                         .try_emplace({shot.width, shot.height, exif.make + exif.model,
                                       exif.focal_length_mm.value_or(0)},
                                      static_cast<int>(numbers.size()))
                         .first->second);
  }
  return lenses;
}

std::vector<int> toldApart(std::vector<int> lenses, std::span<const batch::Shot> shots,
                           std::span<const TargetView> views) {
  int count = lenses.empty() ? 0 : *std::max_element(lenses.begin(), lenses.end()) + 1;
  for (int lens = 0; lens < count; ++lens) {
    const std::vector<OwnFocal> own = ownFocals(lenses, lens, views, shots);
    const std::size_t at = widestStep(own);
    if (at == 0) continue;
    Views all, shorter, longer;
    for (std::size_t k = 0; k < own.size(); ++k) {
      all.push_back(views[own[k].shot]);
      (k < at ? shorter : longer).push_back(all.back());
    }
    const int width = shots[own[0].shot].width, height = shots[own[0].shot].height;
    const auto together = leftBy(all, width, height), first = leftBy(shorter, width, height),
               second = leftBy(longer, width, height);
    if (!first || !second || (together && *first + *second > 0.25 * *together)) continue;
    // Photographs with too few markers to tell stay with the larger group.
    const bool longer_stays = longer.size() > shorter.size();
    for (std::size_t k = 0; k < own.size(); ++k)
      if ((k < at) == longer_stays) lenses[own[k].shot] = count;
    ++count;
    --lens;  // what stays may be two again
  }
  return lenses;
}

}  // namespace ostraka::calibration
