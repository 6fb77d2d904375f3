#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "capture/manifest.h"
#include "capture/sequence.h"
#include "files/files.h"
#include "tests/core/capture/flat_rig.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::capture {

inline constexpr int kStops = 3;
inline constexpr int kProofs = 2;  // a throw-away exposure of each camera before a side

/// One side before two cameras of the flat rig, in simulated time.
class PhotographedSide : public ::testing::Test {
 protected:
  PhotographedSide() {
    options_.batch = folder_;
    options_.stops = kStops;
  }

  Result<SideSummary> shoot() {
    return shootSide(
        rig_.devices, options_,
        [this](const CaptureEvent& event) {
          events_.push_back(event);
          if (on_event_) on_event_(event);
        },
        progress_, stop_.get_token());
  }
  std::string note(int stop, int camera) const {
    const auto bytes =
        readFile(folder_ / batch::name(options_.side) /
                 ("cam" + std::to_string(camera) + "_pos0" + std::to_string(stop) + ".jpg"));
    return bytes ? testing::noteOf(*bytes) : "no file";
  }
  // Every file is of its own camera and stop, and the manifest knows its bytes.
  void expectWholeSide() const {
    const auto manifest = readManifest(folder_);
    ASSERT_TRUE(manifest.has_value());
    for (int s = 0; s < kStops; ++s)
      for (int c = 0; c < static_cast<int>(rig_.cameras.size()); ++c) {
        EXPECT_THAT(note(s, c), ::testing::HasSubstr(testing::exposureNote(
                                    batch::name(options_.side), c, s * 360.0 / kStops)));
        const ManifestEntry* entry = manifest->find(options_.side, s, c);
        ASSERT_NE(entry, nullptr);
        const auto bytes = readFile(folder_ / entry->file);
        ASSERT_TRUE(bytes.has_value());
        EXPECT_EQ(entry->sha256, sha256(*bytes));
        EXPECT_TRUE(entry->checked);
      }
  }
  // The moves of the table: twice for the throw-away exposure, then one for each stop.
  static std::deque<testing::FlatTurntable::Fault> afterStop(
      int stop, std::vector<testing::FlatTurntable::Fault> faults) {
    std::deque<testing::FlatTurntable::Fault> all(static_cast<std::size_t>(2 + stop),
                                                  testing::FlatTurntable::Fault::None);
    all.insert(all.end(), faults.begin(), faults.end());
    return all;
  }
  int count(CaptureEventKind kind) const {
    return static_cast<int>(std::count_if(events_.begin(), events_.end(),
                                          [&](const auto& e) { return e.kind == kind; }));
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path() / "batch";
  SideOptions options_;
  testing::FlatRig rig_ = testing::makeFlatRig(2);
  std::vector<CaptureEvent> events_;
  std::function<void(const CaptureEvent&)> on_event_;
  QuietProgress progress_;
  std::stop_source stop_;
};

}  // namespace ostraka::capture
