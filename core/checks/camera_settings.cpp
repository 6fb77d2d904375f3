#include "checks/camera_settings.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/parallel.h"
#include "base/text.h"

namespace ostraka::checks {
namespace {

using batch::Exif;

constexpr std::size_t kNamed = 4;  // values in a sentence

std::string shortNumber(double value) {
  const std::string text = fixed(value, 1);
  return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}

std::string focalLength(const Exif& e) {
  return e.focal_length_mm ? shortNumber(*e.focal_length_mm) + " mm" : std::string();
}
std::string aperture(const Exif& e) {
  return e.f_number ? "f/" + shortNumber(*e.f_number) : std::string();
}
std::string exposureTime(const Exif& e) {
  if (!e.exposure_s) return {};
  return (*e.exposure_s < 0.4 ? "1/" + std::to_string(std::lround(1 / *e.exposure_s))
                              : shortNumber(*e.exposure_s)) +
         " s";
}
std::string iso(const Exif& e) {
  return e.iso ? "ISO " + std::to_string(*e.iso) : std::string();
}
std::string whiteBalance(const Exif& e) {
  return e.auto_white_balance ? (*e.auto_white_balance ? "auto" : "manual") : std::string();
}
std::string body(const Exif& e) {
  return e.serial.empty() ? e.model : e.serial;
}

struct Setting {
  std::string (*value)(const Exif&);
  Template<2> differs;  // the camera, the values
};

constexpr Setting kSettings[] = {
    {body,
     translatable<2>("Camera %1: its photographs come from different cameras (%2); give each "
                     "camera its own name, because photographs with the same camera name share one "
                     "lens calibration.")},
    {focalLength,
     translatable<2>("Camera %1: its focal length varies between photographs (%2); all share one "
                     "lens calibration, so fix the zoom and reshoot.")},
    {aperture,
     translatable<2>("Camera %1: its aperture varies between photographs (%2); set the camera to "
                     "manual, because uneven photographs make masks and colours less reliable.")},
    {exposureTime,
     translatable<2>("Camera %1: its exposure time varies between photographs (%2); set the camera "
                     "to manual, because uneven photographs make masks and colours less "
                     "reliable.")},
    {iso,
     translatable<2>("Camera %1: its sensitivity varies between photographs (%2); set the camera "
                     "to manual, because uneven photographs make masks and colours less "
                     "reliable.")},
    {whiteBalance,
     translatable<2>("Camera %1: its white balance varies between photographs (%2); set the camera "
                     "to manual, because uneven photographs make masks and colours less "
                     "reliable.")}};

// The most frequent first.
std::string listed(const std::map<std::string, int>& counts) {
  std::vector<std::pair<int, std::string>> all;
  for (const auto& [value, count] : counts) all.emplace_back(-count, value);
  std::sort(all.begin(), all.end());
  std::string text;
  for (std::size_t i = 0; i < std::min(kNamed, all.size()); ++i)
    text += (i > 0 ? ", " : "") + all[i].second;
  return all.size() > kNamed ? text + ", ..." : text;
}

}  // namespace

std::vector<Message> settingsWarnings(std::span<const batch::Shot> shots,
                                      std::span<const Exif> exif) {
  std::vector<Message> warnings;
  std::map<int, std::vector<std::size_t>> of_camera;
  for (std::size_t i = 0; i < shots.size(); ++i) of_camera[shots[i].camera].push_back(i);
  for (const auto& [camera, photographs] : of_camera)
    for (const Setting& setting : kSettings) {
      std::map<std::string, int> counts;
      for (const std::size_t i : photographs)
        if (const std::string value = setting.value(exif[i]); !value.empty()) ++counts[value];
      if (counts.size() > 1)
        warnings.push_back(message(setting.differs, batch::cameraLetter(camera), listed(counts)));
    }
  return warnings;
}

std::vector<Message> settingsWarnings(const batch::Batch& batch, int threads) {
  if (batch.way == batch::Way::FreeCamera) return {};
  std::vector<Exif> exif(batch.shots.size());
  parallelFor(exif.size(), threads,
              [&](std::size_t i) { exif[i] = batch::readExif(batch.shots[i].file); });
  return settingsWarnings(batch.shots, exif);
}

}  // namespace ostraka::checks
