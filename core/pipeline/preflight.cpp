#include "pipeline/preflight.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/message.h"
#include "base/text.h"
#include "batch/mask_source.h"
#include "colmap/colmap_program.h"
#include "stereo/stereo.h"

namespace ostraka::pipeline {
namespace {

// Peaks of whole runs with 8 or 9 sherds: 0.68 GB with photographs of 0.75 megapixels, 1.59 with
// 1.9, 2.65 with 3.2, 4.03 with 5, these averaged down from 27 (docs/experiments.md). All had 24
// photographs a side, and what is held is pictures, masks and depths of all photographs of a side.
constexpr double kBase_mb = 80, kEachMegapixel_mb = 790.0 / 24;
// 943 s for 40 photographs of 5 megapixels, on one thread.
constexpr double kEachMegapixel_s = 943.0 / (40 * 5);
constexpr double kPixelsPerMegapixel = 1e6, kMegabytesAGigabyte = 1024;
// Less makes parts that are hardly larger than what lies around them.
constexpr double kLeastOfStereo_mb = 500;

int countOf(const batch::Batch& batch, batch::Side side) {
  return static_cast<int>(std::ranges::count_if(
      batch.shots, [&](const batch::Shot& shot) { return shot.side == side; }));
}

int photographsOfASide(const batch::Batch& batch) {
  return std::max(countOf(batch, batch::Side::Front), countOf(batch, batch::Side::Back));
}

double largestMegapixels(const batch::Batch& batch) {
  return batch::largestPixels(batch) / kPixelsPerMegapixel;
}

double workedOn(const ProcessOptions& options, const batch::Batch& batch) {
  return std::min(largestMegapixels(batch), options.megapixels);
}

// A byte for each pixel of both sides' photographs.
double heldMasks_mb(const ProcessOptions& options, const batch::Batch& batch) {
  return workedOn(options, batch) * static_cast<double>(batch.shots.size());
}

// The program that a later stage would miss; empty: none.
std::string missingProgram(const batch::Batch& batch, const ProcessOptions& options) {
  std::vector<std::string> wanted;
  if (!batch.plate || options.dense == DenseMethod::Colmap) wanted.emplace_back("colmap");
  if (options.dense == DenseMethod::OpenMvs)
    wanted.insert(wanted.end(), {"InterfaceCOLMAP", "DensifyPointCloud"});
  for (const std::string& name : wanted)
    if (!colmap::findProgram(name)) return name;
  return {};
}

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

// "from 3 cameras at 8 positions"; a camera that is held by hand has no place of its own.
std::string waysOfTaking(const batch::Batch& batch) {
  if (batch.way == batch::Way::FreeCamera) return "taken by hand";
  std::set<int> cameras, stops;
  for (const batch::Shot& shot : batch.shots) {
    cameras.insert(shot.camera);
    stops.insert(shot.stop);
  }
  return "from " + counted(cameras.size(), "camera") + " at " + counted(stops.size(), "position");
}

}  // namespace

double maskMegapixels(const ProcessOptions& options, const batch::Batch& batch) {
  constexpr double kMost = 5, kLeast = 1;
  const double held = (kMegabytesAGigabyte * options.memory_gb - kBase_mb) /
                      (kEachMegapixel_mb * std::max(1, photographsOfASide(batch)));
  return std::min(options.megapixels, std::clamp(held, kLeast, kMost));
}

double stereoMemory_mb(const ProcessOptions& options, const batch::Batch& batch, int originals) {
  const double left = kMegabytesAGigabyte * options.memory_gb - kBase_mb -
                      heldMasks_mb(options, batch) - originals * batch::originalMb(batch);
  return std::max(left, kLeastOfStereo_mb);
}

Needs needsOf(const batch::Batch& batch, const ProcessOptions& options, double free_memory_mb) {
  Needs needs;
  needs.megapixels = workedOn(options, batch);
  const int originals = batch::threadsForOriginals(batch, options.threads, free_memory_mb);
  const double originals_mb = originals * batch::originalMb(batch);
  const int of_a_side = photographsOfASide(batch);
  const double masks_mb =
      kEachMegapixel_mb * std::min(needs.megapixels, maskMegapixels(options, batch)) * of_a_side;
  const double stereo_mb =
      heldMasks_mb(options, batch) + std::min(stereo::kBytesAPixel * needs.megapixels * of_a_side,
                                              stereoMemory_mb(options, batch, originals));
  needs.memory_mb = kBase_mb + std::max({originals_mb, masks_mb, stereo_mb});
  needs.core_s = kEachMegapixel_s * needs.megapixels * static_cast<double>(batch.shots.size());
  return needs;
}

Result<Preflight> preflight(const batch::Batch& batch, const ProcessOptions& options,
                            double free_memory_mb) {
  if (const auto masks = batch::maskSource(options.masks, batch); !masks) return masks.error();
  if (const std::string missing = missingProgram(batch, options); !missing.empty())
    return Error{ErrorCode::Missing,
                 batch.plate
                     ? message("The program %1 is not installed, but the selected stereo needs it; "
                               "install it, or use the built-in stereo.",
                               missing)
                     : message("The photographs show no marker plate, so finding the cameras needs "
                               "the program %1, which is not installed; install it.",
                               missing),
                 batch.folder.string()};
  Preflight ahead{needsOf(batch, options, free_memory_mb), {}, {}};
  const int fronts = countOf(batch, batch::Side::Front), backs = countOf(batch, batch::Side::Back);
  ahead.lines.push_back(
      "before: photographs: " + std::to_string(fronts) + " of the front, " + std::to_string(backs) +
      " of the back, " + waysOfTaking(batch) + "; " +
      formatted("%.1f megapixels, used with %.1f", largestMegapixels(batch), ahead.megapixels));
  ahead.lines.push_back(std::string("before: cameras: ") +
                        (!batch.plate  ? "found by COLMAP"
                         : options.rig ? "from the plate's markers, lenses from the calibrated rig"
                         : batch.calibration.empty()
                             ? "lenses and poses from the plate's markers alone"
                             : "from the plate's markers, lenses from " +
                                   std::to_string(batch.calibration.size()) +
                                   " photographs of the board"));
  // It may lie in the folder above the photographs, and be another sheet's.
  if (!batch.plate_file.empty())
    ahead.lines.push_back("before: sheet: as in " + batch.plate_file.string());
  ahead.lines.push_back(
      formatted("before: memory: about %.1f GB at the peak", ahead.memory_mb / 1000) +
      (free_memory_mb > 0 ? formatted(", %.1f GB are free", free_memory_mb / 1000) : "") +
      formatted("; time: about %.0f minutes of one core", std::ceil(ahead.core_s / 60)));
  if (free_memory_mb > 0 && ahead.memory_mb > free_memory_mb)
    ahead.warnings.push_back(
        inOne(message("This needs about %1 GB of memory, but only %2 GB are free: the computer may "
                      "stop the program or become very slow.",
                      decimal(ahead.memory_mb / 1000, 1), decimal(free_memory_mb / 1000, 1)),
              message("Close other programs, or process a draft.")));
  if (options.estimated) options.estimated(ahead.core_s);
  return ahead;
}

}  // namespace ostraka::pipeline
