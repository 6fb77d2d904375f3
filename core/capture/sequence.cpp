#include "capture/sequence.h"

#include "base/message.h"
#include "capture/manifest.h"
#include "capture/series.h"

namespace ostraka::capture {

Result<void> SideOptions::check() const {
  const auto bad = [](const Message& what) { return Error::unusable(what); };
  if (batch.empty()) return bad(message("No batch folder was given."));
  if (stops < 3 || stops > 99)
    return bad(message("The number of positions must be between 3 and 99."));
  return {};
}

Result<SideSummary> shootSide(RigDevices& devices, const SideOptions& options,
                              const OnCaptureEvent& on_event, Progress& progress,
                              std::stop_token stop) {
  return Series(devices, options, on_event, progress, std::move(stop)).run();
}

Result<std::vector<ShotName>> missingShots(const SideOptions& options, int cameras) {
  const Result<Manifest> manifest = readManifest(options.batch);
  if (!manifest) return manifest.error();
  std::vector<ShotName> missing;
  for (int s = 0; s < options.stops; ++s)
    for (int c = 0; c < cameras; ++c) {
      const ManifestEntry* entry = manifest->find(options.side, s, c);
      std::error_code absent;
      if (entry == nullptr || !std::filesystem::exists(options.batch / entry->file, absent))
        missing.push_back({s, c});
    }
  return missing;
}

}  // namespace ostraka::capture
