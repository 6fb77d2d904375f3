#include "mask/plate_mask.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

#include "base/median.h"
#include "base/message.h"
#include "base/parallel.h"
#include "base/shared_progress.h"
#include "ground/plate_picture.h"
#include "ground/ring_agreement.h"
#include "ground/sheet_picture.h"
#include "hull/hull.h"
#include "hull/hull_odds.h"
#include "mask/coarse_heights.h"
#include "mask/colour_model.h"
#include "mask/evidence.h"
#include "mask/network_evidence.h"
#include "mask/outline.h"
#include "mask/plate_agreement.h"
#include "mask/raised.h"
#include "mask/shadow_depths.h"
#include "mask/strange_shadow.h"
#include "mask/view_state.h"

namespace ostraka::mask {
namespace {

constexpr float kMisplaced_px = 0.5F;  // poses: a few tenths; the mosaic's cells are 1.4 px wide
constexpr double kBareOdds = 6;  // log odds against a sherd where others see the same bare sheet
constexpr double kStandingOdds = 3;        // for a thing (docs/experiments.md)
constexpr double kInsideOverTable = 0.35;  // of the photographs that see a voxel
constexpr double kCarvingShare = 0.15;     // of the photographs; some see a shadow as sherd
constexpr double kStripVoxels = 3;         // +-50 %: IoU +-0.0007 (docs/experiments.md)
constexpr double kStrange = 0.03;  // share of the bare plate: more than what poses and grain do

class PlateMasker {
 public:
  PlateMasker(std::span<const rig::PosedImage> images, std::span<const cv::Mat> photographs,
              const batch::Plate& plate, std::span<const cv::Mat> empties,
              const PlateMaskOptions& options)
      : images_(images),
        photographs_(photographs),
        plate_(plate),
        empties_(empties),
        options_(options),
        views_(images.size()) {}

  Result<MaskResult> run(Progress& progress, const std::stop_token& stop) {
    std::map<int, std::vector<std::size_t>> by_camera;
    for (std::size_t i = 0; i < images_.size(); ++i) by_camera[images_[i].camera].push_back(i);
    const auto all = static_cast<std::int64_t>(images_.size());
    steps_.emplace(progress, all * (kOnce + (plate_.sheet ? kAgain : 0)));
    if (plate_.sheet) {
      if (const Result<void> weighed = weighSheet(stop); !weighed) return weighed.error();
    } else {
      for (const auto& [camera, members] : by_camera) {
        if (stop.stop_requested()) return Error::cancelled();
        weighCamera(camera, members, progress);
      }
    }
    weighStops(stop);
    if (const auto added = addNetwork(
            photographs_, views_, hull_.reduction, options_.threads,
            [this] { steps_->count(kLook); }, stop);
        !added)
      return added.error();
    if (!carve(stop)) return stop.stop_requested() ? Error::cancelled() : noSherdFound();
    result_.masks.resize(images_.size());
    const auto overViews = [&](void (PlateMasker::*work)(std::size_t), std::int64_t steps) {
      parallelFor(images_.size(), options_.threads, [&](std::size_t i) {
        if (!stop.stop_requested()) (this->*work)(i);
        steps_->count(steps);
      });
    };
    overViews(&PlateMasker::showHull, kShow);
    if (!stop.stop_requested() && dropFlatThings(progress)) overViews(&PlateMasker::showHull, 0);
    const bool lasting = plate_.sheet && still_light_;  // shadows are in the first hull, too
    shade_limits_ = learnShadeLimits(views_, hull_.reduction, lasting);
    for (std::size_t i = 0; i < views_.size(); ++i) limitInShade(shade_limits_, i, views_[i]);
    if (!lasting) knowShadows(), trustHull();
    if (!stop.stop_requested() && !plate_.sheet) nameShadows(by_camera, progress);
    overViews(&PlateMasker::askOthers, kAsk);
    if (!stop.stop_requested()) learnColours();
    steps_->count(all * (kLearn + (plate_.sheet && !lasting ? kAgain : 0)));
    overViews(&PlateMasker::cutView, kCut);
    if (lasting && !stop.stop_requested()) {
      carveByMasks(stop);
      steps_->count(all * kCarve);
      overViews(&PlateMasker::showHull, kShow);
      shade_limits_ = learnShadeLimits(views_, hull_.reduction, true);  // its groups are others
      trustHull();
      overViews(&PlateMasker::cutView, kCut);
    }
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(1, 1);
    return std::move(result_);
  }

 private:
  // A ground of which nothing but a reconstruction tells.
  bool unprinted() const { return plate_.sheet && plate_.markers.empty(); }

  void weighCamera(int camera, const std::vector<std::size_t>& members, Progress& progress) {
    const auto grid = ground::gridOver(plate_, ground::millimetresPerPixel(images_[members[0]]));
    const cv::Mat1b paper = ground::markerPaper(plate_, grid);
    std::vector<ground::PlateLook> looks(members.size());
    parallelFor(members.size(), options_.threads, [&](std::size_t k) {
      const rig::PosedImage& image = images_[members[k]];
      looks[k] = {ground::logColours(photographs_[members[k]]), ground::gridOfPixels(image, grid),
                  ground::pixelsOfGrid(image, grid)};
    });
    const auto [empty, empty_look] = emptyPlate(camera, members, looks, paper, progress);
    const auto picture = ground::buildPlatePicture(looks, empty, empty_look, grid, paper);
    parallelFor(members.size(), options_.threads, [&](std::size_t k) {
      const cv::Mat3f bare = smoothed(ground::predictBare(picture, looks[k], k, grid));
      const cv::Mat3f residual = smoothed(looks[k].log_colours) - bare;
      const cv::Mat1b inside = ground::insideMarkers(looks[k].grid_of_pixel, grid);
      const ResidualNoise noise = measureNoise(residual, bare, kMisplaced_px, inside);
      const Evidence evidence = weighEvidence(residual, bare, noise, kMisplaced_px);
      ViewState& view = views_[members[k]];
      keep(members[k], evidence);
      cv::resize(inside, view.plate, view.hull.clear.size(), 0, 0, cv::INTER_NEAREST);
      looks[k] = {};
      steps_->count(kWeigh);
    });
  }

  // Against the printed sheet. Beyond its edge nothing is known.
  Result<void> weighSheet(const std::stop_token& stop) {
    double finest = ground::millimetresPerPixel(images_[0]);
    for (const rig::PosedImage& image : images_)
      finest = std::min(finest, ground::millimetresPerPixel(image));
    const ground::PlateGrid grid = ground::gridOver(plate_, finest);
    Result<cv::Mat1f> printed = ground::printedSheet(plate_, grid);
    if (!printed) return printed.error();
    std::vector<cv::Mat3b> samples(images_.size());
    std::vector<cv::Mat1b> covered(options_.shown.size());
    parallelFor(images_.size(), options_.threads, [&](std::size_t i) {
      if (stop.stop_requested()) return;
      const cv::Mat2f pixels = ground::pixelsOfGrid(images_[i], grid, options_.bend);
      cv::remap(photographs_[i], samples[i], pixels, cv::noArray(), cv::INTER_LINEAR,
                cv::BORDER_CONSTANT, cv::Scalar::all(0));
      if (options_.shown.empty()) return;
      // Even clay, too, looks alike from everywhere: what stands there shows nothing of the sheet.
      covered[i] = coveredCells(options_.shown[i], photographs_[i].size(), pixels);
      samples[i].setTo(cv::Scalar::all(0), covered[i]);
    });
    if (stop.stop_requested()) return Error::cancelled();
    const auto picture = ground::buildSheetPicture(samples, *printed, covered);
    still_light_ = picture.still_light;
    const ShadowDepths depths = depthsOfLastingShade(picture);
    samples.clear();
    parallelFor(images_.size(), options_.threads, [&](std::size_t i) {
      if (stop.stop_requested()) return;
      cv::Mat1b known;
      const cv::Mat2f grid_of_pixel = ground::gridOfPixels(images_[i], grid, options_.bend);
      const cv::Mat3f bare = smoothed(predictBareSheet(picture, i, *printed, grid_of_pixel, known));
      cv::Mat3f residual = smoothed(ground::logColours(photographs_[i])) - bare;
      residual.setTo(cv::Scalar::all(0), ~known);
      cv::Mat1b shade;
      if (!picture.shade.empty())
        cv::remap(picture.shade, shade, grid_of_pixel, cv::noArray(), cv::INTER_NEAREST,
                  cv::BORDER_CONSTANT, cv::Scalar::all(0));
      const cv::Mat1f seen_bare = ground::seenBare(picture, residual, grid_of_pixel);
      if (!shade.empty()) shade.setTo(0, seen_bare < 0.5F);  // a sherd before it
      const auto noise = measureNoise(residual, bare, kMisplaced_px, known, shade);
      Evidence evidence = weighEvidence(residual, bare, noise, kMisplaced_px);
      depths.addTo(evidence.log_odds, residual, photographs_[i]);
      evidence.clear = cv::max(evidence.clear, seen_bare);
      evidence.log_odds -= seen_bare.mul(evidence.log_odds + kBareOdds);
      cv::add(evidence.log_odds, kStandingOdds, evidence.log_odds,
              ground::somethingStands(picture, grid_of_pixel));
      // Where the pixel beside is unknown the smoothing mixed both.
      cv::Mat1b certain;
      cv::erode(known, certain, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
      evidence.log_odds.setTo(0, ~certain);
      evidence.clear.setTo(0, ~certain);
      ViewState& view = views_[i];
      view.ink = ground::inkBehind(*printed, grid_of_pixel);
      keep(i, evidence);
      cv::resize(certain, view.plate, view.hull.clear.size(), 0, 0, cv::INTER_NEAREST);
      steps_->count(kWeigh);
    });
    return stop.stop_requested() ? Result<void>(Error::cancelled()) : Result<void>();
  }

  // What stands above the plate though it has the plate's colour, stop by stop.
  void weighStops(const std::stop_token& stop) {
    std::map<int, std::vector<std::size_t>> by_stop;
    for (std::size_t i = 0; i < images_.size(); ++i) by_stop[images_[i].stop].push_back(i);
    std::vector<std::vector<std::size_t>> stops;
    for (auto& [number, members] : by_stop) stops.push_back(std::move(members));
    parallelFor(stops.size(), options_.threads, [&](std::size_t s) {
      if (stop.stop_requested()) return;
      std::vector<const rig::PosedImage*> images;
      std::vector<const cv::Mat*> photographs;
      for (const std::size_t i : stops[s]) {
        images.push_back(&images_[i]);
        photographs.push_back(&photographs_[i]);
      }
      std::vector<cv::Mat1f> heights;
      if (!unprinted())
        heights =
            weighHeights(images, photographs, plate_, options_.height_mm, options_.bend.most());
      else
        for (const cv::Mat* photograph : photographs)
          heights.emplace_back(photograph->rows / 2, photograph->cols / 2, 0.F);
      for (std::size_t k = 0; k < images.size() && !options_.shown.empty(); ++k) {
        const cv::Mat1f shown = heightsShown(options_.shown[stops[s][k]], photographs[k]->size());
        shown.copyTo(heights[k], shown != 0);
      }
      for (std::size_t k = 0; k < images.size(); ++k) {
        ViewState& view = views_[stops[s][k]];
        if (plate_.sheet) {  // a table's grain agrees at any height along its lines
          cv::Mat1b known;
          cv::resize(view.plate, known, heights[k].size(), 0, 0, cv::INTER_NEAREST);
          heights[k].setTo(0, ~known);
        }
        addHeights(view, heights[k]);
        steps_->count(kSweep);
      }
    });
  }

  void warn(const Message& text, Progress& progress) {
    progress.note(NoteLevel::Warning, text);
    result_.warnings.push_back(text);
  }

  std::pair<cv::Mat3f, int> emptyPlate(int camera, const std::vector<std::size_t>& members,
                                       const std::vector<ground::PlateLook>& looks,
                                       const cv::Mat1b& paper, Progress& progress) {
    if (camera < 0 || camera >= static_cast<int>(empties_.size()) || empties_[camera].empty())
      return {cv::Mat3f(), 0};
    const std::string letter = batch::cameraLetter(camera);
    const auto refuse = [&](const Message& why) {
      warn(why, progress);
      return std::pair<cv::Mat3f, int>{cv::Mat3f(), 0};
    };
    const cv::Mat& photograph = empties_[camera];
    if (photograph.type() != CV_8UC3 || photograph.size() != looks[0].log_colours.size())
      return refuse(
          message("masks: the empty-plate photograph of camera %1 differs in size from the "
                  "camera's other photographs; masks are made without it",
                  letter));
    // Markers turned by one stop correlate below 0.5; a good fit is above 0.95.
    constexpr double kFits = 0.85;
    const cv::Mat3f empty = ground::logColours(photograph);
    ground::RingAgreement best;
    std::size_t at = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const ground::RingAgreement agreement = ground::ringAgreement(empty, looks[k], paper);
      if (k == 0 || agreement.typical > best.typical) best = agreement, at = k;
    }
    if (best.typical < kFits)
      return refuse(
          message("masks: the empty-plate photograph of camera %1 shows the plate at none of the "
                  "positions; retake it at the first; masks are made without it",
                  letter));
    // Used all the same, it would make a sherd of what lies on the markers in every photograph.
    if (best.whole < kFits)
      return refuse(
          message("masks: the empty-plate photograph of camera %1 shows covered markers in %2; "
                  "uncover them; masks are made without it",
                  letter, images_[members[at]].file));
    return {empty, static_cast<int>(at)};
  }

  void keep(std::size_t index, const Evidence& evidence) {
    ViewState& view = views_[index];
    view.residual = evidence.residual;
    view.log_odds = evidence.log_odds;
    view.hull.image = &images_[index];
    view.hull.inside = insideOf(evidence.log_odds, hull_.reduction);
    cv::resize(evidence.clear, view.hull.clear, view.hull.inside.size(), 0, 0, cv::INTER_AREA);
  }

  bool carve(const std::stop_token& stop) {
    space_.pitch = 1.5;  // about 6 pixels; the outline itself is found in the photographs
    Eigen::Vector2d reach = Eigen::Vector2d::Constant(0.5 * plate_.diameter_mm);
    if (plate_.sheet) {
      reach = 0.5 * plate_.sheet->sizes();
      // Many photographs see a high voxel before the table, of which nothing is known.
      hull_.inside_share = kInsideOverTable;
    } else {
      space_.radius = reach.x();
    }
    const int half_x = static_cast<int>(std::ceil(reach.x() / space_.pitch));
    const int half_y = static_cast<int>(std::ceil(reach.y() / space_.pitch));
    space_.low =
        Eigen::Vector3d(-half_x * space_.pitch, -half_y * space_.pitch, 0.5 * space_.pitch);
    hull_.threads = options_.threads;
    std::vector<hull::HullView> views;
    for (const ViewState& view : views_) views.push_back(view.hull);
    int groups = 0;
    for (double height = options_.height_mm; height <= kTallest_mm; height *= 2) {
      space_.count = {2 * half_x + 1, 2 * half_y + 1,
                      static_cast<int>(std::ceil(height / space_.pitch))};
      voxels_ = hull::carveHull(space_, views, hull_, stop);
      groups = hull::dropSmallGroups(space_, voxels_, options_.min_sherd_area_mm2);
      if (unprinted()) hull::dropGroupsAtSides(space_, voxels_);
      if (!reachesTop()) break;
    }
    steps_->count(static_cast<std::int64_t>(views.size()) * kCarve);
    return groups > 0;
  }

  bool dropFlatThings(Progress& progress) {
    const std::vector<unsigned char> flat = findFlatGroups(views_);
    if (flat.empty()) return false;
    for (unsigned char& voxel : voxels_)
      if (std::find(flat.begin(), flat.end(), voxel) != flat.end()) voxel = 0;
    warn(message("masks: flat objects that look like labels or scale bars are left out (%1); if "
                 "there are sherds among them, add them to the masks",
                 flat.size()),
         progress);
    return true;
  }

  // The first hull holds lasting shadows; what most photographs took for shadow leaves this one.
  void carveByMasks(const std::stop_token& stop) {
    std::vector<hull::HullView> views;
    for (std::size_t i = 0; i < views_.size(); ++i)
      views.push_back(hullViewOf(views_[i], result_.masks[i]));
    hull_.carving_views = std::max(2.0, kCarvingShare * static_cast<double>(views.size()));
    voxels_ = hull::carveHull(space_, views, hull_, stop);
    hull::dropSmallGroups(space_, voxels_, options_.min_sherd_area_mm2);
    if (unprinted()) hull::dropGroupsAtSides(space_, voxels_);
    masks_known_ = true;
  }

  bool reachesTop() const {
    const auto layer = static_cast<std::size_t>(space_.count.x()) * space_.count.y();
    return std::ranges::any_of(std::span(voxels_).last(layer), [](auto v) { return v != 0; });
  }

  // Where the hull shows, and a little beyond: it is as coarse as its voxels.
  void showHull(std::size_t index) {
    ViewState& view = views_[index];
    const hull::Silhouette shown = hull::silhouetteOfHull(space_, voxels_, view.hull, hull_);
    view.group = shown.group, view.depth = shown.depth;
    view.hull.inside.release();
    if (plate_.sheet) hull::keepTouching(view.plate, view.group);
    cv::Mat1b silhouette;
    cv::resize(cv::Mat1b(view.group != 0), silhouette, photographs_[index].size(), 0, 0,
               cv::INTER_NEAREST);
    cv::dilate(silhouette, view.allowed, cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9}));
    view.below = shown.height / space_.pitch;
  }

  void knowShadows() {
    std::vector<ShadowSight> sights;
    for (std::size_t i = 0; i < views_.size(); ++i)
      sights.push_back({views_[i].residual, views_[i].group, views_[i].plate, photographs_[i],
                        views_[i].log_odds});
    const ShadowDepths depths = learnShadowDepths(sights, hull_.reduction);
    parallelFor(views_.size(), options_.threads, [&](std::size_t i) {
      depths.addTo(views_[i].log_odds, views_[i].residual, photographs_[i]);
    });
  }

  // Black clay looks like nothing else but a shadow; what lies deep in the hull is none.
  void trustHull() {
    std::vector<hull::HullSight> sights;
    for (const ViewState& view : views_)
      sights.push_back(
          {view.depth / space_.pitch, view.below, view.group, view.hull.clear, view.log_odds});
    hull_odds_ = hull::learnHullOdds(sights, hull_.reduction);
    parallelFor(views_.size(), options_.threads,
                [&](std::size_t i) { views_[i].log_odds += hullOddsOf(views_[i]); });
  }
  cv::Mat1f hullOddsOf(const ViewState& view) const {
    const double share = masks_known_ ? 0.5 : 1;  // the masks' own hull repeats what they say
    return share * hull_odds_.of(view.depth / space_.pitch, view.below, view.log_odds.size());
  }

  // Lamps and sherds cast the same shadows at each stop, or nearly; a hand or a person does not.
  void nameShadows(const std::map<int, std::vector<std::size_t>>& by_camera, Progress& progress) {
    std::vector<StrangeShadow> strange;
    for (const auto& [camera, members] : by_camera) {
      if (members.size() < 3) continue;
      std::vector<double> shares;
      for (const std::size_t i : members) {
        const ViewState& view = views_[i];
        shares.push_back(darkenedShare(view.residual, view.group, view.plate, hull_.reduction,
                                       ground::millimetresPerPixel(images_[i])));
      }
      const double usual = medianOf(std::vector<double>(shares));
      for (std::size_t k = 0; k < members.size(); ++k)
        if (shares[k] > usual + kStrange)
          strange.push_back({images_[members[k]].file, cvRound(100 * shares[k])});
    }
    if (!strange.empty()) warn(warningOf(strange), progress);
  }

  void askOthers(std::size_t index) {
    const auto bare = [this](double x, double y) { return hull::bareAt(space_, voxels_, {x, y}); };
    ViewState& view = views_[index];
    weighAgreement(plateViewOf(index), beside(index), bare, view.allowed, view.log_odds);
  }

  void learnColours() {
    std::vector<ColourView> views;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      cv::Mat1b grown;
      cv::dilate(views_[i].group, grown, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
      views_[i].group.copyTo(grown, views_[i].group != 0);
      const cv::Mat1b unknown = plate_.sheet ? cv::Mat1b(views_[i].plate == 0) : cv::Mat1b();
      views.push_back({photographs_[i], grown, views_[i].depth >= 3 * space_.pitch, unknown,
                       views_[i].ink, &views_[i].log_odds});
    }
    sharpenByColours(views, hull_.reduction, options_.threads);
  }

  void cutView(std::size_t index) {
    ViewState& view = views_[index];
    CutOptions cut_options;
    const double mm = ground::millimetresPerPixel(images_[index]);
    const double sine = std::abs(images_[index].centre().normalized().z());
    cut_options.min_area_px = options_.min_sherd_area_mm2 * sine / (mm * mm);
    // Colours spoke twice, by themselves and as learnt; a grey sherd's are a shadow's both times.
    // Only what surely stands high: near the foot the windows reach over the outline.
    if (!masks_known_) {
      cv::Mat1f surely;
      cv::threshold(view.height_odds, surely, 3, 0, cv::THRESH_TOZERO);
      view.log_odds += heightsInTheLight(surely, view.residual);
    }
    limitInShade(shade_limits_, index, view);
    const cv::Mat1b cut = cutWithHull(view, cut_options, mm);
    // The plate's z axis in the camera's frame, as it shows in the picture.
    const Eigen::Vector3d z = images_[index].camera_from_plate.linear().col(2);
    const cv::Vec2f up(static_cast<float>(z.x()), static_cast<float>(z.y()));
    result_.masks[index] =
        refineOutline(softenOutline(cut, photographs_[index]), photographs_[index], up);
  }

  cv::Mat1b cutWithHull(const ViewState& view, const CutOptions& options, double mm) const {
    cv::Mat1b with = cutOutline(view.log_odds, view.allowed, view.residual, options);
    if (hull_odds_.by == hull::HullOdds().by) return with;
    const cv::Mat1f odds = view.log_odds - hullOddsOf(view);
    const cv::Mat1b own = cutOutline(odds, view.allowed, view.residual, options);
    return settleStrips(own, with, kStripVoxels * space_.pitch / mm, view.residual, options);
  }

  // The other cameras' views of the same stop, as long as the light is the same.
  std::vector<PlateView> beside(std::size_t index) const {
    std::vector<PlateView> others;
    if (!still_light_) return others;
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (i != index && images_[i].stop == images_[index].stop &&
          (plate_.sheet || images_[i].camera != images_[index].camera))
        others.push_back(plateViewOf(i));
    return others;
  }

  PlateView plateViewOf(std::size_t i) const {
    const ViewState& view = views_[i];
    return {&images_[i],     &view.residual, &view.group,
            hull_.reduction, options_.bend,  plate_.sheet ? &view.plate : nullptr};
  }

  std::span<const rig::PosedImage> images_;
  std::span<const cv::Mat> photographs_;
  const batch::Plate& plate_;
  std::span<const cv::Mat> empties_;
  const PlateMaskOptions& options_;
  std::vector<ViewState> views_;
  hull::HullOptions hull_;
  hull::HullSpace space_;
  std::vector<unsigned char> voxels_;
  hull::HullOdds hull_odds_;
  ShadeLimits shade_limits_;
  bool still_light_ = true;              ///< on a sheet; at a stop of a rig it is
  bool masks_known_ = false;             ///< the hull is that of the masks so far
  std::optional<SharedProgress> steps_;  ///< of run
  MaskResult result_;
};

}  // namespace

Result<MaskResult> maskByPlate(std::span<const rig::PosedImage> images,
                               std::span<const cv::Mat> photographs, const batch::Plate& plate,
                               std::span<const cv::Mat> empty_photographs,
                               const PlateMaskOptions& options, Progress& progress,
                               std::stop_token stop) {
  if (const Result<void> ok = checkViews(images, photographs,
                                         message("Masks from the plate need at least 3 photographs "
                                                 "of a side; photograph more positions."));
      !ok)
    return ok.error();
  return PlateMasker(images, photographs, plate, empty_photographs, options).run(progress, stop);
}

}  // namespace ostraka::mask
