#pragma once
#include <array>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "rig/rig.h"
#include "virtualrig/coverage.h"

/// What a calibrated rig will do, before a sherd lies on it.
namespace ostraka::virtualrig {

struct PredictOptions {
  /// Of the simulated pictures, pixels; 0, and at most: what processBatch works on of this rig's.
  /// Narrower ones take less time, by their square, but what stereo and the breaks lose grows
  /// faster than the pixel: at 5/8 of the width the error is 2.8 times as large.
  int width = 0;
  int sherds_per_size = 2;
  /// Of the camera moves that rays recommend at most so many are simulated, until one makes better
  /// models; each takes as long as the prediction without them. 0: none is recommended.
  int moves = 1;
  std::uint64_t seed = 1;
  std::filesystem::path work;  ///< new or empty folder for batch and models; left as it is
  int threads = 0;
  Result<void> check() const;
};

struct SizePrediction {
  std::string name;     ///< "small", "medium", "large"
  double width_mm = 0;  ///< mean of the sherds
  int sherds = 0, without_model = 0;
  /// From the simulated pictures: 90 % of the surface lies within accuracy of the truth; share of
  /// the truth within 0.25 mm. Means over the sherds with a model.
  double accuracy_mm = 0, completeness_percent = 0;
  double seen = 0, break_seen = 0;  ///< by rays at the rig's own resolution, shares
  /// That one such sherd adds to the processing of a batch, on this machine: depth by its surface,
  /// and its model.
  double seconds = 0;
};

/// A camera move that was simulated, and the same sherds photographed from there.
struct MoveTried {
  CameraMove move;
  std::array<SizePrediction, 3> sizes;  ///< without seconds and shares seen
  bool better = false;
};

/// Whether models are better by more than chance explains: accuracy by a tenth or completeness by
/// one per cent in the mean of the sizes, or more models; neither worse in the mean, of no size
/// worse by a third or three per cent, and of none fewer.
bool isBetter(const std::array<SizePrediction, 3>& after,
              const std::array<SizePrediction, 3>& before);

struct Prediction {
  std::array<SizePrediction, 3> sizes;
  double width_share = 1;    ///< simulated width over what processBatch works on
  double seconds = 0;        ///< of processing the simulated batch, on this machine
  double fixed_seconds = 0;  ///< of these, for any number of sherds: cameras, masks, pairs
  double processors = 0;     ///< that worked at it in the mean; few where others kept them busy
  int threads = 1;           ///< that it asked for
  int photographs = 0;
  double outside = 0;            ///< share of looks at the sherds that fall outside of the pictures
  std::vector<MoveTried> moves;  ///< in the order of their promise; the last one may be better
  std::vector<int> cameras;      ///< their numbers
  std::vector<double> elevations_rad, pixels_mm;  ///< by camera
  std::vector<Message> remarks;                   ///< on the rig, whole sentences

  /// Carried to the full resolution where narrower pictures were simulated: noise goes with the
  /// pixel's size at least, so this is on the safe side; time goes with its square.
  double expectedAccuracy(const SizePrediction& size) const {
    return size.accuracy_mm * width_share;
  }
  double expectedSeconds(double simulated_seconds) const {
    return simulated_seconds / (width_share * width_share);
  }
};

/// Simulates the rig: virtual sherds of 26, 48 and 82 mm are photographed by its cameras at its
/// stops and go through the whole chain with this rig, the models are compared with the truth; rays
/// tell what is seen and which camera to move, and the same sherds photographed from there tell
/// whether that helps. Six sherds take three to four minutes on two cores at 1600 pixels, up to ten
/// at 2582, which is what is left of larger photographs, and each move as much again. Errors: as
/// simulateBatch and processBatch.
Result<Prediction> predict(const rig::Rig& rig, const PredictOptions& options, Progress& progress,
                           std::stop_token stop);

}  // namespace ostraka::virtualrig
