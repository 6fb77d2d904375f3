#include "review/live_pairs.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "base/message.h"
#include "batch/moved_batch.h"
#include "batch/photograph.h"
#include "checks/no_scale.h"
#include "cloud/ply.h"
#include "decisions/mask_strokes.h"
#include "pairing/common_scale.h"
#include "pairing/contour.h"
#include "pairing/turning_angles.h"
#include "pipeline/chain.h"
#include "registration/pair_fit.h"
#include "review/picture_pixel.h"
#include "review/review.h"
#include "rig/camera.h"
#include "scan/fracture.h"

namespace ostraka::review {
namespace {

namespace fs = std::filesystem;
using batch::Side;
using Eigen::Isometry3d;
using registration::Strip;
using Line = std::vector<Eigen::Vector2d>;

constexpr int kTurnSamples = 200;
constexpr double kBeside_mm = 1;            // farther than the outline's own roundings
constexpr std::size_t kTold = 4000;         // points that tell whether anything lies there
constexpr std::size_t kLeastOfAPart = 200;  // points; fewer make no outline

/// A scan with all that is made from it; each part is made when it is first asked for.
struct Opened {
  std::recursive_mutex mutex;
  std::optional<Result<scan::Scan>> scan;
  std::optional<Result<Strip>> strip;
  std::optional<std::vector<Eigen::Vector3d>> outline;  ///< on the outermost surface, plate frame
};

struct Photograph {
  cv::Mat picture;
  cv::Mat1b mask;
  rig::PosedImage image;
};

// Empty where it has none.
std::vector<Eigen::Vector3d> outlined(const PointCloud& cloud, const Eigen::Vector3d& up) {
  const Result<pairing::Contour> contour = pairing::traceContour(cloud, up);
  if (!contour) return {};
  const Isometry3d scan_from_plane = contour->plane_from_scan.inverse();
  std::vector<Eigen::Vector3d> outline;
  for (std::size_t i = 0; i < contour->points.size(); ++i)
    outline.push_back(scan_from_plane * Eigen::Vector3d(contour->points[i].x(),
                                                        contour->points[i].y(),
                                                        contour->heights[i]));
  return outline;
}

// What lies beside an outline on the plate, of every step-th point.
PointCloud outsideOf(const std::vector<Eigen::Vector3d>& outline, const PointCloud& cloud,
                     std::size_t step = 1) {
  if (outline.empty()) return {};
  std::vector<cv::Point2f> polygon;
  for (const Eigen::Vector3d& p : outline)
    polygon.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  std::vector<int> outside;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (cv::pointPolygonTest(polygon, {cloud.points[i].x(), cloud.points[i].y()}, true) <
        -kBeside_mm)
      outside.push_back(static_cast<int>(i));
  return subset(cloud, outside);
}

Line flat(const std::vector<Eigen::Vector3d>& line, const Isometry3d& frame_from_line) {
  Line out;
  for (const Eigen::Vector3d& p : line) out.push_back((frame_from_line * p).head<2>());
  return out;
}

// Turns of both outlines as they lie, the back's from the point nearest to the front's first.
void addTurns(PairView& view) {
  if (view.front_outline.size() < 8 || view.back_outline.size() < 8) return;
  Line front = view.front_outline, back = view.back_outline;
  for (Line* line : {&front, &back})
    if (pairing::signedArea(*line) < 0) std::reverse(line->begin(), line->end());
  const auto nearest = std::ranges::min_element(back, [&](const auto& a, const auto& b) {
    return (a - front[0]).squaredNorm() < (b - front[0]).squaredNorm();
  });
  std::rotate(back.begin(), nearest, back.end());
  const auto a = pairing::turningAngles(front, kTurnSamples);
  const auto b = pairing::turningAngles(back, kTurnSamples);
  if (!a || !b) return;
  view.front_turns = pairing::accumulated(*a, 0);
  view.back_turns = pairing::accumulated(*b, 0);
}

// As one figure after the other is shown, all must be measured alike.
LiveFit shownAt(const Strip& front, const Strip& back, const Isometry3d& pose) {
  const registration::PoseFigures figures = registration::figuresAt(front, back, pose);
  LiveFit fit;
  fit.front_from_back = pose;
  fit.fracture_rms_mm = figures.fracture_rms_mm;
  fit.fracture_overlap = figures.fracture_overlap;
  return fit;
}

}  // namespace

struct LivePairs::State {
  fs::path output;
  decisions::CandidateTable table;
  std::vector<rig::PosedImage> images;                    ///< backs brought to the fronts' size
  mutable std::map<std::pair<Side, int>, Opened> opened;  ///< all keys there from the start
  mutable std::mutex photographs_mutex;
  mutable std::map<Side, Result<Photograph>> photographs;

  Result<scan::Scan> read(Side side, int scan) const {
    const std::size_t i = static_cast<std::size_t>(scan);
    const bool front = side == Side::Front;
    Result<PointCloud> cloud =
        readPlyCloud(output / "work" / (front ? table.front_files[i] : table.back_files[i]));
    if (!cloud) return cloud.error();
    scan::Scan read{(front ? table.fronts[i] : table.backs[i]).id,
                    std::move(*cloud),
                    {},
                    Eigen::Vector3d::UnitZ()};
    read.fracture = scan::findFracture(read.cloud, read.up);
    if (!front && table.back_scale != 1) read = pairing::scaled(read, table.back_scale);
    return read;
  }

  /// The scan stays where it is until this object dies: what is made is never made again.
  Result<const scan::Scan*> scanOf(Side side, int scan) const {
    Opened& slot = opened.at({side, scan});
    const std::lock_guard lock(slot.mutex);
    if (!slot.scan) slot.scan = read(side, scan);
    if (!*slot.scan) return slot.scan->error();
    return &**slot.scan;
  }
  Result<const Strip*> stripOf(Side side, int scan) const {
    Opened& slot = opened.at({side, scan});
    const std::lock_guard lock(slot.mutex);
    if (!slot.strip) {
      const Result<const scan::Scan*> points = scanOf(side, scan);
      slot.strip = points ? registration::prepareStrip(**points, {}) : points.error();
    }
    if (!*slot.strip) return slot.strip->error();
    return &**slot.strip;
  }
  const std::vector<Eigen::Vector3d>& outlineOf(Side side, int scan) const {
    Opened& slot = opened.at({side, scan});
    const std::lock_guard lock(slot.mutex);
    if (!slot.outline) {
      slot.outline.emplace();
      if (const Result<const scan::Scan*> points = scanOf(side, scan))
        slot.outline = outlined((*points)->cloud, (*points)->up);
    }
    return *slot.outline;
  }

  /// The view from highest above: there the sherds hide each other least.
  Result<rig::PosedImage> highest(Side side) const {
    const rig::PosedImage* best = nullptr;
    for (const rig::PosedImage& image : images) {
      if (image.side != side) continue;
      const double up = image.centre().normalized().z();
      if (best == nullptr || up > best->centre().normalized().z() + 1e-3) best = &image;
    }
    if (best == nullptr)
      return Error::missing(message("There is no photograph of this side."), output.string());
    return *best;
  }
  Result<const Photograph*> photographOf(Side side) const {
    const std::lock_guard lock(photographs_mutex);
    auto found = photographs.find(side);
    if (found == photographs.end()) found = photographs.emplace(side, readPhotographOf(side)).first;
    if (!found->second) return found->second.error();
    return &*found->second;
  }
  Result<Photograph> readPhotographOf(Side side) const {
    const Result<rig::PosedImage> image = highest(side);
    if (!image) return image.error();
    Result<cv::Mat> picture = batch::readPhotograph(image->file);
    if (!picture) return picture.error();
    Photograph photograph{std::move(*picture), {}, *image};
    const fs::path masks = output / "work" / decisions::maskFolder(output, side);
    if (Result<cv::Mat> mask = batch::readMask(masks / maskName(*image)))
      photograph.mask = std::move(*mask);
    return photograph;
  }
};

LivePairs::LivePairs(std::unique_ptr<State> state) : state_(std::move(state)) {}
LivePairs::~LivePairs() = default;

const decisions::CandidateTable& LivePairs::table() const {
  return state_->table;
}
const fs::path& LivePairs::output() const {
  return state_->output;
}

Result<std::shared_ptr<const LivePairs>> LivePairs::open(const fs::path& output) {
  auto state = std::make_unique<State>();
  state->output = output;
  Result<decisions::CandidateTable> table = decisions::readCandidatesOf(output);
  if (!table) return table.error();
  state->table = std::move(*table);
  const fs::path cameras = output / "work" / "rig" / "cameras.json";
  std::error_code ignored;
  if (fs::exists(cameras, ignored)) {  // imported scans have no photographs
    Result<std::vector<rig::PosedImage>> images = rig::readCameras(cameras);
    if (!images) return images.error();
    state->images = std::move(*images);
  }
  for (rig::PosedImage& image : state->images)
    image.file = batch::photographNow(image.file, output).string();
  checks::resizeSide(state->images, Side::Back, state->table.back_scale);
  for (std::size_t i = 0; i < state->table.fronts.size(); ++i)
    state->opened[{Side::Front, static_cast<int>(i)}];
  for (std::size_t i = 0; i < state->table.backs.size(); ++i)
    state->opened[{Side::Back, static_cast<int>(i)}];
  return std::shared_ptr<const LivePairs>(new LivePairs(std::move(state)));
}

Result<LiveFit> LivePairs::settled(int front, int back, const Isometry3d& start,
                                   std::stop_token stop,
                                   const std::function<void(const LiveFit&)>& on_way) const {
  const Result<const Strip*> f = state_->stripOf(Side::Front, front);
  if (!f) return f.error();
  const Result<const Strip*> b = state_->stripOf(Side::Back, back);
  if (!b) return b.error();
  const auto& supports = state_->table.supports;
  const registration::Constraints constraints{{}, {}, supports[0], supports[1]};
  // The registration's own first rounds once more, for the eye.
  const registration::RegistrationOptions options;
  const registration::PairFit pair(**f, **b, constraints, options);
  registration::FittedPose pose;
  pose.front_from_back = pose.begun = start;
  for (const auto rounds : {&registration::PairFit::coarse, &registration::PairFit::fine}) {
    if (!on_way) break;
    if (stop.stop_requested()) return Error::cancelled();
    (pair.*rounds)(pose);
    on_way(shownAt(**f, **b, pose.front_from_back));
  }
  QuietProgress quiet;
  const Result<registration::Registration> found =
      registration::registerSides(**f, **b, {&start, 1}, constraints, options, quiet, stop);
  if (!found) return found.error();
  if (on_way) on_way(shownAt(**f, **b, found->front_from_back));
  LiveFit fit;
  static_cast<registration::Registration&>(fit) = *found;
  return fit;
}

Result<LiveFit> LivePairs::measured(int front, int back, const Isometry3d& pose) const {
  const Result<const Strip*> f = state_->stripOf(Side::Front, front);
  if (!f) return f.error();
  const Result<const Strip*> b = state_->stripOf(Side::Back, back);
  if (!b) return b.error();
  return shownAt(**f, **b, pose);
}

Result<LiveFit> LivePairs::atStartPoint(int front, int back, int shift) const {
  const Result<const scan::Scan*> f = state_->scanOf(Side::Front, front);
  if (!f) return f.error();
  const Result<const scan::Scan*> b = state_->scanOf(Side::Back, back);
  if (!b) return b.error();
  const Result<pairing::StartPose> start = pairing::startPoseAt(**f, **b, shift);
  if (!start) return start.error();
  Result<LiveFit> fit = measured(front, back, start->front_from_back);
  if (!fit) return fit;
  fit->shift = start->shift;
  fit->contour_rms_mm = start->contour_rms_mm;
  return fit;
}

Result<decisions::RegisteredCandidate> LivePairs::compared(int front, int back,
                                                           std::stop_token stop) const {
  if (const decisions::RegisteredCandidate* known = state_->table.find(front, back)) return *known;
  const Result<const scan::Scan*> f = state_->scanOf(Side::Front, front);
  if (!f) return f.error();
  const Result<const scan::Scan*> b = state_->scanOf(Side::Back, back);
  if (!b) return b.error();
  decisions::PairOptions options;
  options.threads = options.candidates.threads = 1;
  options.candidates.reach = 1e9;  // a person asks for this pair
  const auto& supports = state_->table.supports;
  QuietProgress quiet;
  Result<decisions::CandidateTable> table = decisions::compareSides(
      {*f, 1}, {*b, 1}, {{}, {}, supports[0], supports[1]}, options, quiet, stop);
  if (!table) return table.error();
  if (table->candidates.empty())
    return Error::notEnough(message("The outlines of these two sides cannot be overlaid."));
  decisions::RegisteredCandidate found = std::move(table->candidates.front());
  found.evidence.front = front;
  found.evidence.back = back;
  return found;
}

Result<std::vector<int>> LivePairs::likeliestBacks(int front, Progress& progress,
                                                   std::stop_token stop) const {
  const Result<const scan::Scan*> f = state_->scanOf(Side::Front, front);
  if (!f) return f.error();
  std::vector<std::pair<double, int>> found;
  const int n = static_cast<int>(state_->table.backs.size());
  for (int b = 0; b < n; ++b) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(b, n);
    const Result<const scan::Scan*> back = state_->scanOf(Side::Back, b);
    if (!back) continue;
    pairing::CandidateOptions options;
    options.reach = 1e9;
    options.threads = 1;
    QuietProgress quiet;
    const auto candidates = pairing::findCandidates({*f, 1}, {*back, 1}, options, quiet, stop);
    if (!candidates) return candidates.error();
    if (!candidates->empty()) found.emplace_back(-candidates->front().log_likelihood, b);
  }
  std::sort(found.begin(), found.end());
  std::vector<int> backs;
  for (const auto& [cost, b] : found) backs.push_back(b);
  return backs;
}

Result<PairView> LivePairs::view(int front, int back, const Isometry3d& pose) const {
  constexpr double kMargin_mm = 2;
  const Result<const scan::Scan*> f = state_->scanOf(Side::Front, front);
  if (!f) return f.error();
  const Result<const scan::Scan*> b = state_->scanOf(Side::Back, back);
  if (!b) return b.error();
  PairView view;
  const PointCloud moved = transformed((*b)->cloud, pose);
  std::vector<Eigen::Vector3f> both = (*f)->cloud.points;
  both.insert(both.end(), moved.points.begin(), moved.points.end());
  const double pixel_mm = std::min(pixelOf_mm(Side::Front, front), pixelOf_mm(Side::Back, back));
  view.frame = frameAround(both, pixel_mm, kMargin_mm);
  if (state_->images.empty()) {
    view.front = pointPicture((*f)->cloud, Isometry3d::Identity(), Facing::Up, view.frame);
    view.back = pointPicture((*b)->cloud, pose, Facing::Down, view.frame);
  }
  if (const auto photograph = state_->photographOf(Side::Front))
    view.front = orthophoto((*photograph)->picture, (*photograph)->mask, (*photograph)->image,
                            (*f)->cloud.points, Isometry3d::Identity(), Facing::Up, view.frame);
  if (const auto photograph = state_->photographOf(Side::Back))
    view.back = orthophoto((*photograph)->picture, (*photograph)->mask, (*photograph)->image,
                           moved.points, pose.inverse(), Facing::Down, view.frame);
  view.front_outline = flat(state_->outlineOf(Side::Front, front), Isometry3d::Identity());
  view.back_outline = flat(state_->outlineOf(Side::Back, back), pose);
  addTurns(view);
  const Result<const Strip*> front_strip = state_->stripOf(Side::Front, front);
  const Result<const Strip*> back_strip = state_->stripOf(Side::Back, back);
  if (front_strip && back_strip)
    view.fracture = registration::fractureGaps(**front_strip, **back_strip, pose);
  return view;
}

double LivePairs::pixelOf_mm(Side side, int scan) const {
  const Result<const scan::Scan*> points = state_->scanOf(side, scan);
  const Result<rig::PosedImage> photograph = state_->highest(side);
  return points && photograph && !(*points)->cloud.empty()
             ? picturePixel_mm(*photograph, (*points)->cloud.points)
             : kWidestPicturePixel_mm;
}

PictureFrame LivePairs::frameOf(Side side, int scan, double px_mm) const {
  const Result<const scan::Scan*> points = state_->scanOf(side, scan);
  return points ? frameAround((*points)->cloud.points, px_mm, 1.5) : PictureFrame{};
}

Result<Picture> LivePairs::picture(Side side, int scan, double px_mm) const {
  const Result<const scan::Scan*> points = state_->scanOf(side, scan);
  if (!points) return points.error();
  const PictureFrame frame = frameOf(side, scan, px_mm);
  if (state_->images.empty())
    return pointPicture((*points)->cloud, Isometry3d::Identity(), Facing::Up, frame);
  const Result<const Photograph*> photograph = state_->photographOf(side);
  if (!photograph) return photograph.error();
  return orthophoto((*photograph)->picture, (*photograph)->mask, (*photograph)->image,
                    (*points)->cloud.points, Isometry3d::Identity(), Facing::Up, frame);
}

Result<rig::PosedImage> LivePairs::photographed(Side side) const {
  return state_->highest(side);
}

Result<std::vector<std::vector<Eigen::Vector2d>>> LivePairs::outlinesIn(
    const rig::PosedImage& photograph, int scan) const {
  const Result<const scan::Scan*> found = state_->scanOf(photograph.side, scan);
  if (!found) return found.error();
  std::vector<std::vector<Eigen::Vector2d>> outlines(1);
  for (const Eigen::Vector3d& p : state_->outlineOf(photograph.side, scan))
    outlines[0].push_back(photograph.project(p));
  // A piece that was joined may lie in several parts. Most are whole, which some points tell.
  const std::vector<Eigen::Vector3d>& largest = state_->outlineOf(photograph.side, scan);
  const PointCloud& cloud = (*found)->cloud;
  const std::size_t step = 1 + cloud.size() / kTold;
  if (step * outsideOf(largest, cloud, step).size() < kLeastOfAPart) return outlines;
  PointCloud rest = outsideOf(largest, cloud);
  while (rest.size() >= kLeastOfAPart) {
    const auto part = outlined(rest, (*found)->up);
    if (part.empty()) break;
    outlines.emplace_back();
    for (const Eigen::Vector3d& p : part) outlines.back().push_back(photograph.project(p));
    PointCloud left = outsideOf(part, rest);
    if (left.size() == rest.size()) break;
    rest = std::move(left);
  }
  return outlines;
}

Result<ScanCloud> LivePairs::cloud(Side side, int scan, std::size_t most_points) const {
  const Result<const scan::Scan*> found = state_->scanOf(side, scan);
  if (!found) return found.error();
  const std::size_t n = (*found)->cloud.size();
  const std::size_t step = std::max<std::size_t>(1, (n + most_points - 1) / most_points);
  std::vector<int> kept;
  ScanCloud out;
  for (std::size_t i = 0; i < n; ++i) {
    // Of the fracture all points stay: it is what a person looks at.
    const bool fracture = i < (*found)->fracture.size() && (*found)->fracture[i] != 0;
    if (!fracture && i % step != 0) continue;
    kept.push_back(static_cast<int>(i));
    out.fracture.push_back(fracture ? 1 : 0);
  }
  out.cloud = subset((*found)->cloud, kept);
  out.strip_point.assign(kept.size(), -1);
  const Result<const Strip*> strip = state_->stripOf(side, scan);
  if (!strip) return out;
  // Thinned strips have a point for all of a cell; beyond the next cell it is another place.
  const float cell = static_cast<float>(1.5 * (*strip)->spacing_mm);
  for (std::size_t i = 0; i < kept.size(); ++i)
    out.strip_point[i] = (*strip)->fine.tree.nearest(out.cloud.points[i], cell).index;
  return out;
}

Isometry3d movedByHand(const Isometry3d& front_from_back, const decisions::ScanRef& back,
                       const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& move_mm) {
  const Eigen::Vector3d pivot =
      front_from_back * Eigen::Vector3d(back.place_mm.x(), back.place_mm.y(), 0);
  const double angle = turn_rad.norm();
  Isometry3d change = Isometry3d::Identity();
  change.translate(pivot + move_mm);
  if (angle > 0) change.rotate(Eigen::AngleAxisd(angle, turn_rad / angle));
  change.translate(-pivot);
  return change * front_from_back;
}

Eigen::Vector2d onBackPlate(const Isometry3d& front_from_back, const decisions::ScanRef& back,
                            const Eigen::Vector2d& shown_mm) {
  const double height =
      (front_from_back * Eigen::Vector3d(back.place_mm.x(), back.place_mm.y(), 0)).z();
  return (front_from_back.inverse() * Eigen::Vector3d(shown_mm.x(), shown_mm.y(), height))
      .head<2>();
}

double length_mm(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return (to - from).norm();
}

}  // namespace ostraka::review
