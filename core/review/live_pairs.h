#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "decisions/candidate_table.h"
#include "registration/pose_figures.h"
#include "review/orthophoto.h"

namespace ostraka::review {

/// Two sides at a pose, with its figures; of one that was only measured, those of its fracture.
/// uncertainty_mm 0: nothing was estimated, the pose is as it was given.
struct LiveFit : registration::Registration {
  double contour_rms_mm = 0;  ///< 0: not asked
  int shift = -1;             ///< start point on the back's contour, of 200; -1: not known

  /// So little of the fractures lies together that nothing is shown by it: sides that were seen
  /// well meet along 0.15 and more.
  bool hardlyMeets() const { return !(fracture_overlap >= 0.05); }
};

/// What the screen shows of a pair at a pose. All lengths in the front's plate frame, mm; the back
/// is seen through the front (mirrored), so that everything lies on each other.
struct PairView {
  PictureFrame frame;
  Picture front, back;                                       ///< empty where the photograph is gone
  std::vector<Eigen::Vector2d> front_outline, back_outline;  ///< closed
  std::vector<double> front_turns, back_turns;  ///< accumulated turning angles, rad, 200 or none
  registration::FractureGaps fracture;          ///< empty where a scan has no usable fracture
};

/// A scan for the 3D view: thinned, with colours, its fracture marked.
struct ScanCloud {
  PointCloud cloud;  ///< its own plate frame; backs brought to the fronts' size
  std::vector<std::uint8_t> fracture;
  /// Its point of registration::Strip::fine, whose gap PairView tells; -1: it is nothing of what
  /// the other side can have seen.
  std::vector<int> strip_point;
};

/// One batch opened for work on its pairs by hand. Scans are read when they are first asked for and
/// kept; all calls may come from several threads.
class LivePairs {
 public:
  /// Errors: those of readCandidatesOf, UnusableInput (cameras).
  static Result<std::shared_ptr<const LivePairs>> open(const std::filesystem::path& output);
  ~LivePairs();

  const decisions::CandidateTable& table() const;
  const std::filesystem::path& output() const;

  /// The registration goes on from a pose (strip, outlines, rest on the plate). About 0.2 s.
  /// on_way, where somebody looks on: the pose and its fracture after the coarse and after the fine
  /// rounds, and at last that of the result. It does not change the result.
  Result<LiveFit> settled(int front, int back, const Eigen::Isometry3d& start, std::stop_token stop,
                          const std::function<void(const LiveFit&)>& on_way = {}) const;
  /// How well a pose fits as it is. About 20 ms.
  Result<LiveFit> measured(int front, int back, const Eigen::Isometry3d& pose) const;
  /// The pose of one start point of the back's contour, measured, moved no further.
  Result<LiveFit> atStartPoint(int front, int back, int shift) const;
  /// Outlines, then fractures: for a pair that the program did not compare. shifts: its start
  /// points.
  Result<decisions::RegisteredCandidate> compared(int front, int back, std::stop_token stop) const;
  /// The backs by how well their outlines fit this front's, best first.
  Result<std::vector<int>> likeliestBacks(int front, Progress& progress,
                                          std::stop_token stop) const;

  Result<PairView> view(int front, int back, const Eigen::Isometry3d& pose) const;
  /// A side alone, seen from its own outside, in its own plate frame.
  /// picturePixel_mm of the photograph that shows the scan; without one the widest.
  double pixelOf_mm(batch::Side side, int scan) const;
  PictureFrame frameOf(batch::Side side, int scan, double px_mm) const;  ///< of picture()
  Result<Picture> picture(batch::Side side, int scan, double px_mm) const;
  /// The photograph that a side is shown by, the one from highest above; its file may be gone.
  Result<rig::PosedImage> photographed(batch::Side side) const;
  /// The outlines of a scan's parts in that photograph, pixels, the largest first; that one is
  /// empty when it has none.
  Result<std::vector<std::vector<Eigen::Vector2d>>> outlinesIn(const rig::PosedImage& photograph,
                                                               int scan) const;
  Result<ScanCloud> cloud(batch::Side side, int scan, std::size_t most_points) const;

 private:
  struct State;
  explicit LivePairs(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A pose turned and moved by hand: about the back's middle, in the front's frame.
Eigen::Isometry3d movedByHand(const Eigen::Isometry3d& front_from_back,
                              const decisions::ScanRef& back, const Eigen::Vector3d& turn_rad,
                              const Eigen::Vector3d& move_mm);

/// A point of the back as the screen shows it (front's frame, seen through the front), on the
/// back's own plate: for a cut that is drawn on its photograph.
Eigen::Vector2d onBackPlate(const Eigen::Isometry3d& front_from_back,
                            const decisions::ScanRef& back, const Eigen::Vector2d& shown_mm);

/// The length of a line that a person drew in the 3D view.
double length_mm(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace ostraka::review
