#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "capture/sequence.h"
#include "capture/silhouettes.h"
#include "files/files.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;

constexpr double kShift_mm = 15;
constexpr double kVotes = 0.6;  // of the looks at a place: a shadow lies there in fewer

// How steeply a camera looks down: 1 from straight above.
double steepness(const Eigen::Matrix3d& pixel_from_plate) {
  const Eigen::Vector3d middle = pixel_from_plate.col(2);
  Eigen::Matrix2d slopes;  // of the pixel at the plate's middle
  for (int c = 0; c < 2; ++c)
    slopes.col(c) = (pixel_from_plate.block<2, 1>(0, c) * middle.z() -
                     middle.head<2>() * pixel_from_plate(2, c)) /
                    (middle.z() * middle.z());
  const Eigen::Vector2d axes = slopes.jacobiSvd().singularValues();
  return axes[0] > 0 ? axes[1] / axes[0] : 0;
}

using Photographs = std::vector<std::vector<SidePhotograph>>;

// nullptr: unreadable, or the plate's place is not seen.
std::shared_ptr<const MappedInspection> lookOf(const SidePhotograph& photograph,
                                               const batch::Plate& plate,
                                               const InspectionOptions& options) {
  std::shared_ptr<const MappedInspection> inspection = photograph.inspection;
  if (!inspection) {
    const Result<std::string> bytes = readFile(photograph.file);
    if (!bytes) return nullptr;
    Result<MappedInspection> mapped = inspectAndMap(*bytes, plate, options);
    if (!mapped) return nullptr;
    inspection = std::make_shared<const MappedInspection>(std::move(*mapped));
  }
  return inspection->inspection.pixel_from_plate ? inspection : nullptr;
}

// The camera that looks down most steeply, by its first photograph with markers; -1: none.
int steepestCamera(const Photographs& photographs, const batch::Plate& plate,
                   const InspectionOptions& options, std::stop_token stop) {
  int best = -1;
  double most = 0;
  for (std::size_t c = 0; c < photographs.size(); ++c)
    for (const SidePhotograph& photograph : photographs[c]) {
      if (stop.stop_requested()) return -1;
      const auto mapped = lookOf(photograph, plate, options);
      if (!mapped) continue;
      const double steep = steepness(*mapped->inspection.pixel_from_plate);
      if (steep > most) {
        most = steep;
        best = static_cast<int>(c);
      }
      break;
    }
  return best;
}

Message places(const std::vector<Eigen::Vector2d>& list) {
  Message all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Message place =
        message("(%1, %2) mm", std::lround(list[i].x()), std::lround(list[i].y()));
    all = i == 0                 ? place
          : i + 1 == list.size() ? message("%1 and %2", all, place)
                                 : message("%1, %2", all, place);
  }
  return all;
}

// The votes of all looks round the notches off; each look shows them. A look from aside shifts a
// sherd by its height.
std::ptrdiff_t looksAt(const MapPiece& piece, const std::vector<MapPiece>& of_looks) {
  return std::count_if(of_looks.begin(), of_looks.end(), [&](const MapPiece& other) {
    return (other.centre_mm - piece.centre_mm).norm() < kShift_mm &&
           std::abs(other.area_mm2 - piece.area_mm2) < 0.2 * piece.area_mm2;
  });
}

// What the photographs of one camera show of the plate, laid over each other.
struct Looks {
  int count = 0;
  double radius_mm = 0;           // of the plate
  cv::Mat1i sherd, seen;          // in how many looks, by the plate's pixel
  std::vector<MapPiece> notched;  // of all looks
};

// Nothing: stopped.
std::optional<Looks> looksOf(const std::vector<SidePhotograph>& photographs,
                             const batch::Plate& plate, const InspectionOptions& options,
                             std::stop_token stop) {
  Looks looks;
  for (const SidePhotograph& photograph : photographs) {
    if (stop.stop_requested()) return std::nullopt;
    const auto mapped = lookOf(photograph, plate, options);
    if (!mapped) continue;
    if (looks.sherd.empty()) {
      looks.radius_mm = mapped->map.radius_mm;
      looks.sherd = cv::Mat1i(mapped->map.sherd.size(), 0);
      looks.seen = cv::Mat1i(mapped->map.sherd.size(), 0);
    }
    cv::add(looks.sherd, 1, looks.sherd, mapped->map.sherd);
    cv::add(looks.seen, 1, looks.seen, mapped->map.seen);
    ++looks.count;
    for (MapPiece& piece : piecesOf(mapped->map, options.smallest_sherd_mm))
      if (hasOppositeNotches(piece)) looks.notched.push_back(std::move(piece));
  }
  return looks;
}

// A sherd is where most looks at a place show one.
PlateMap together(const Looks& looks) {
  PlateMap map;
  map.radius_mm = looks.radius_mm;
  map.seen = looks.seen > 0;
  cv::Mat1f share(looks.seen.size(), 0.f);
  for (int y = 0; y < share.rows; ++y)
    for (int x = 0; x < share.cols; ++x)
      if (looks.seen(y, x) > 0)
        share(y, x) = static_cast<float>(looks.sherd(y, x)) / looks.seen(y, x);
  map.sherd = share >= kVotes;
  cv::morphologyEx(map.sherd, map.sherd, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
  return map;
}

SideCheck uncounted() {
  SideCheck side;
  side.sentences.push_back(
      message("The sherds could not be counted: too few of the plate's markers are visible."));
  return side;
}

// Turning sherds over by hand shifts them by millimetres: the same places twice are the same side.
bool sameSide(const SideCheck& front, const SideCheck& back) {
  std::size_t same = 0;
  for (const Eigen::Vector3d& f : front.places)
    same += std::any_of(back.places.begin(), back.places.end(), [&](const Eigen::Vector3d& b) {
      return (f - b).head<2>().norm() < 0.7 && std::abs(f.z() - b.z()) < 0.04 * f.z();
    });
  return !front.places.empty() && 5 * same >= 4 * front.places.size();
}

}  // namespace

SideCheck checkSide(const std::vector<std::vector<fs::path>>& files, const batch::Plate& plate,
                    const InspectionOptions& options, std::stop_token stop) {
  Photographs photographs(files.size());
  for (std::size_t c = 0; c < files.size(); ++c)
    for (const fs::path& file : files[c]) photographs[c].push_back({file, nullptr});
  return checkSide(photographs, plate, options, std::move(stop));
}

SideCheck checkSide(const Photographs& photographs, const batch::Plate& plate,
                    const InspectionOptions& options, std::stop_token stop) {
  SideCheck side;
  const int camera = steepestCamera(photographs, plate, options, stop);
  if (camera < 0) return uncounted();
  const std::optional<Looks> looks =
      looksOf(photographs[static_cast<std::size_t>(camera)], plate, options, stop);
  if (!looks) return side;
  if (looks->sherd.empty()) return uncounted();
  const std::vector<MapPiece> pieces = piecesOf(together(*looks), options.smallest_sherd_mm);
  std::vector<Eigen::Vector2d> touching_mm, doubtful_mm;  // where, on the plate
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const int within = sherdsInPiece(pieces[i]);
    side.sherds += within;
    side.places.emplace_back(pieces[i].centre_mm.x(), pieces[i].centre_mm.y(), pieces[i].area_mm2);
    side.touching += within - 1;
    if (within > 1)
      touching_mm.push_back(pieces[i].centre_mm);
    else if (mayBeSeveral(pieces[i]) || 2 * looksAt(pieces[i], looks->notched) >= looks->count)
      doubtful_mm.push_back(pieces[i].centre_mm);
    for (std::size_t k = 0; k < i; ++k)
      if (gapBetween_mm(pieces[k], pieces[i]) < options.touching_mm) {
        ++side.touching;
        touching_mm.push_back((pieces[i].centre_mm + pieces[k].centre_mm) / 2);
      }
  }
  side.counted = true;
  if (pieces.empty()) side.sentences.push_back(message("No sherd is visible on the plate."));
  if (!touching_mm.empty())
    side.sentences.push_back(
        message("Sherds touch or nearly touch at %1 from the plate's centre: move them apart and "
                "reshoot.",
                places(touching_mm)));
  side.doubtful = static_cast<int>(doubtful_mm.size());
  if (!doubtful_mm.empty())
    side.sentences.push_back(
        message("What lies at %1 from the plate's centre was counted as one but may be two "
                "touching sherds: check it; if so, move them apart and reshoot.",
                places(doubtful_mm)));
  return side;
}

std::vector<Message> compareSides(const SideCheck& front, const SideCheck& back) {
  std::vector<Message> sentences;
  if (sameSide(front, back))
    sentences.push_back(
        message("The back looks like the front: turn the sherds over and reshoot them."));
  if (!front.counted || !back.counted) {
    sentences.push_back(
        front.counted ? message("The sherds of the back could not be counted: compare the pictures "
                                "before you clear the plate.")
                      : message("The sherds of the front could not be counted: compare the "
                                "pictures before you clear the plate."));
  } else if (front.sherds > back.sherds) {
    sentences.push_back(
        message("Sherds counted on the front: %1, on the back: %2. Find the missing ones before "
                "you clear the plate.",
                front.sherds, back.sherds));
  } else if (front.sherds < back.sherds) {
    sentences.push_back(
        message("Sherds counted on the front: %1, on the back: %2. Check whether one was added or "
                "broke.",
                front.sherds, back.sherds));
  }
  return sentences;
}

}  // namespace ostraka::capture
