#pragma once
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "capture/batch_store.h"
#include "capture/sequence.h"
#include "capture/silhouettes.h"

namespace ostraka::capture {

/// Whether sherds lie too close is asked before the first shot, and by checkSide after the last.
inline const InspectionOptions kSequenceInspection{.too_close_mm = 0};

/// One side being photographed: what shootSide does, step by step.
class Series {
 public:
  Series(RigDevices& devices, const SideOptions& options, const OnCaptureEvent& on_event,
         Progress& progress, std::stop_token stop)
      : devices_(devices),
        options_(options),
        on_event_(on_event),
        progress_(progress),
        stop_(std::move(stop)) {}

  Result<SideSummary> run();

 private:
  struct Task {
    int stop = 0;
    std::vector<int> cameras;
  };
  /// Delivered by a camera; put on disk and looked at while the table turns on.
  struct Shot {
    int stop = 0, camera = 0;
    std::vector<devices::CameraFile> files{};  ///< empty: on disk already
    devices::CameraId id{};
    std::map<std::string, std::string> settings{};
    ShotCheck check{};
    int epoch = 0;  ///< of the table's count when it was taken; -1: says nothing about the table
    bool checked = false, refused = false;
  };
  struct Delivery {
    Result<void> outcome;
    std::vector<devices::CameraFile> files;
    double fetched_s = 0;
  };
  /// May the next file of a camera be one of an earlier trigger? A throw-away exposure is taken at
  /// an angle at which no stop is; the first photograph must be turned against it as the table was.
  enum class Trust { Doubted, Awaiting, Proven };
  struct Watch {
    CameraReference reference;
    Trust trust = Trust::Proven;
    std::string proof;  ///< the throw-away exposure's bytes, not yet looked at
    std::optional<PlateInspection> probe_inspection;
    double proof_deg = 0;                         ///< where the table stood then, as a stop's angle
    int blind_proofs = 0;                         ///< without enough markers
    std::map<std::string, std::string> settings;  ///< read before the coming shot
  };

  Result<void> prepare();
  Result<void> sameCamera(int camera) const;
  Result<void> readReferences();
  Result<void> findPosition();
  Result<void> shootStop(const Task& task);
  Result<void> turnTo(const Task& task, double beyond_deg);
  Result<void> turnOnce(const Task& task, double beyond_deg, std::span<const int> to_empty);
  Result<void> recoverTable(const Error& trouble);
  void emptyCamera(int camera);
  Result<void> setAsRigSays(int camera);
  bool byHand(int camera) const;
  std::vector<int> doubted(const Task& task) const;
  Result<void> takeProofs(std::vector<int> cameras, const Task& task);
  void lookAtProof(int camera);
  bool provenBy(Watch& watch, const PlateInspection& inspection, double angle_deg) const;
  Result<void> keepAndCheck();
  void checkShot(Shot& shot, std::shared_ptr<const MappedInspection> inspection, bool old);
  Result<void> takeVerdicts();
  Result<void> refuse(const Shot& shot);
  Result<void> correctZero(const std::vector<Shot>& shots);
  Result<void> shootCameras(const Task& task);
  Result<void> expose(std::vector<int> cameras, int stop, std::vector<Shot>& shots);
  Delivery shootOne(int camera, bool triggered);
  Result<void> recoverCamera(int camera, int stop, const Error& trouble);
  Result<SideSummary> summary();
  double angleOf(int stop) const { return 360.0 * stop / options_.stops; }
  double targetOf(int stop) const;
  void tell(CaptureEvent event);
  int kept() const;

  RigDevices& devices_;
  const SideOptions& options_;
  const OnCaptureEvent& on_event_;
  Progress& progress_;
  std::stop_token stop_;
  std::mutex telling_;
  std::optional<BatchStore> store_;
  std::vector<Watch> watches_;  ///< by camera
  std::deque<Task> tasks_;
  std::vector<Shot> shots_;                   ///< of the last stop, until their verdicts are taken
  std::map<std::pair<int, int>, int> tries_;  ///< by stop and camera
  std::map<std::pair<int, int>, std::shared_ptr<const MappedInspection>>
      inspections_;                         ///< of kept shots
  double zero_deg_ = 0;                     ///< of the plate against the table, by the markers
  std::optional<double> doubted_zero_deg_;  ///< seen once; believed when it is seen again
  bool zero_unknown_ = false;               ///< the table restarted: the markers will tell
  int epoch_ = 0;                           ///< how often the table's count began anew
  double busy_s_ = 0;                       ///< turning, settling, exposing, transferring
};

/// "Camera B, position 3".
Message shotWords(int stop, int camera);
/// Sentences about the problems, one after the other.
Message listed(const ShotCheck& check);

}  // namespace ostraka::capture
