#pragma once
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "capture/batch_store.h"
#include "capture/sequence.h"

namespace ostraka::capture {

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
  /// On disk, and looked at while the table turns on.
  struct Unchecked {
    int stop = 0, camera = 0;
    ShotCheck check;
    int epoch = 0;  ///< of the table's count when it was taken
    bool repeated = false;
    bool refused = false;
  };
  struct Delivery {
    Result<void> outcome;
    std::optional<Arriving> arriving;
    double fetched_s = 0;
  };

  Result<void> prepare();
  Result<void> readReferences();
  Result<void> findPosition();
  Result<void> shootStop(const Task& task);
  Result<void> turnTo(const Task& task);
  Result<void> turnOnce(const Task& task, bool with_checks);
  Result<void> recoverTable(const Error& trouble);
  void lookAt(Unchecked& shot);
  Result<void> takeVerdicts();
  Result<void> refuse(const Unchecked& shot);
  Result<void> correctZero(const std::vector<Unchecked>& shots);
  Result<void> shootCameras(std::vector<int> cameras, int stop);
  Delivery shootOne(int camera, int stop, bool triggered);
  Result<void> recoverCamera(int camera, int stop, const Error& trouble);
  Result<SideSummary> summary();
  double angleOf(int stop) const { return 360.0 * stop / options_.stops; }
  double targetOf(int stop) const;
  Error withSafety(Error error) const;
  void tell(CaptureEvent event);
  int kept() const;

  RigDevices& devices_;
  const SideOptions& options_;
  const OnCaptureEvent& on_event_;
  Progress& progress_;
  std::stop_token stop_;
  std::mutex telling_;
  std::optional<BatchStore> store_;
  std::vector<CameraReference> references_;
  std::deque<Task> tasks_;
  std::vector<Unchecked> unchecked_;
  std::map<std::pair<int, int>, int> tries_;  ///< by stop and camera
  double zero_deg_ = 0;                       ///< of the plate against the table, by the markers
  std::optional<double> doubted_zero_deg_;    ///< seen once; believed when it is seen again
  bool zero_unknown_ = false;                 ///< the table restarted: the markers will tell
  int epoch_ = 0;                             ///< how often the table's count began anew
  double busy_s_ = 0;                         ///< turning, settling, exposing, transferring
  double last_fetch_s_ = 0;
};

}  // namespace ostraka::capture
