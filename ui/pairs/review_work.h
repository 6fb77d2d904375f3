#pragma once
#include <Eigen/Geometry>
#include <QImage>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "intake/apply_decision.h"
#include "review/live_pairs.h"
#include "review/review.h"
#include "ui/pairs/review_rows.h"

/// What the review computes away from the window's thread: values in, values out.
namespace ostraka::ui {

using LivePairsPtr = std::shared_ptr<const review::LivePairs>;

/// A batch as it is opened for review.
struct OpenedBatch {
  LivePairsPtr live;
  decisions::Decisions decisions;  ///< all ever taken
  decisions::Decisions followed;   ///< by the results as they are
  Result<int> caught_up = 0;       ///< rows of decisions that the catalogue lacked
};
/// rows: the folder of the project whose catalogue follows the decisions first; none: it is not
/// asked. Missing while the batch is computed, and where that was stopped.
Result<OpenedBatch> openBatch(const std::filesystem::path& output,
                              const std::filesystem::path& rows = {});

/// What takes a decision about the results in `output`.
using ApplyDecision = std::function<Result<intake::AppliedDecision>(
    const std::filesystem::path& output, decisions::PairDecision decision)>;

/// A pair at a pose with all that is shown of it.
struct PairScene {
  int front = -1, back = -1;
  review::LiveFit fit;
  review::PairView view;
  QImage front_picture, back_picture;                        ///< of view
  std::optional<review::ScanCloud> front_cloud, back_cloud;  ///< only when asked for
};
enum class Clouds { Leave, Fetch };
Result<std::shared_ptr<const PairScene>> pairScene(const LivePairsPtr& live, int front, int back,
                                                   const Eigen::Isometry3d& pose, Clouds clouds);

/// A scan that has no partner to be shown with, in its own plate frame.
Result<std::shared_ptr<const PairScene>> loneScene(const LivePairsPtr& live, batch::Side side,
                                                   int scan);

/// OUT/sherds/<number>/model.ply of the sherd that was computed from these two sides; Missing where
/// the front was computed with another back, or the batch not to its end.
using MeshPtr = std::shared_ptr<const TriangleMesh>;
Result<MeshPtr> closedModel(const LivePairsPtr& live, int front, int back);

/// Small pictures of all scans, by side and index.
using ScanPictures = std::map<std::pair<batch::Side, int>, QImage>;
Result<ScanPictures> scanPictures(const LivePairsPtr& live, std::stop_token stop);

/// The likeliest back that is not known yet, fractures compared; nothing when there is none.
Result<std::optional<review::ReviewCandidate>> anotherCandidate(const LivePairsPtr& live, int front,
                                                                const std::vector<int>& known,
                                                                Progress& progress,
                                                                std::stop_token stop);

/// One back compared on demand.
Result<review::ReviewCandidate> oneCandidate(const LivePairsPtr& live, int front, int back,
                                             std::stop_token stop);

QImage imageOf(const review::Picture& picture);

}  // namespace ostraka::ui
