#include "batch/batch.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <tuple>

#include "base/message.h"
#include "base/parallel.h"
#include "base/text.h"
#include "batch/photographs.h"
#include "images/image_header.h"

namespace ostraka::batch {
namespace fs = std::filesystem;
namespace {

using Key = std::tuple<Side, int, int>;  // side, camera, stop

// Takes a literal or a number of at most six digits from the front of a name.
bool take(std::string_view& name, std::string_view literal) {
  if (!name.starts_with(literal)) return false;
  name.remove_prefix(literal.size());
  return true;
}

bool take(std::string_view& name, int& number) {
  std::size_t digits = 0;
  number = 0;
  while (digits < name.size() && digits < 6 && name[digits] >= '0' && name[digits] <= '9')
    number = number * 10 + (name[digits++] - '0');
  name.remove_prefix(digits);
  return digits > 0;
}

// A number, or the letter that the camera has in the window: A is the first.
bool takeCamera(std::string_view& name, int first, int& camera) {
  if (take(name, camera)) return true;
  if (name.empty() || name[0] < 'a' || name[0] > 'z') return false;
  camera = name[0] - 'a' + first;
  name.remove_prefix(1);
  return true;
}

// "cam3_pos07" gives {3, 7} for between = "_pos", and "camD_pos07" where cameras count from 0.
bool camNumbers(const fs::path& file, std::string_view between, int first, int& camera,
                int& number) {
  const std::string stem = lowerCase(file.stem().string());
  std::string_view name = stem;
  return take(name, "cam") && takeCamera(name, first, camera) && take(name, between) &&
         take(name, number) && name.empty();
}

bool emptyPlateCamera(const fs::path& file, int first, int& camera) {
  const std::string stem = lowerCase(file.stem().string());
  std::string_view name = stem;
  return take(name, "empty_cam") && takeCamera(name, first, camera) && name.empty();
}

std::vector<fs::path> imagesIn(const fs::path& folder) {
  std::vector<fs::path> files = photographsIn(folder);
  std::sort(files.begin(), files.end());
  return files;
}

struct Layout {
  const char* folder[2];  // by side
  const char* masks[2];
  const char* between;  // of the numbers in a photograph's name
  const char* pattern;
  int first_camera;  // number of the first camera in the names
};

constexpr Layout kOurs{
    {"front", "back"}, {"front_masks", "back_masks"}, "_pos", "cam<C>_pos<PP>.jpg", 0};
constexpr Layout kPaper{{"top_images", "bottom_images"},
                        {"top_masks", "bottom_masks"},
                        "_image",
                        "cam<C>_image<NNN>.tif",
                        1};

class Reader {
 public:
  Reader(const fs::path& folder, const ReadBatchOptions& options, Progress& progress)
      : options_(options), progress_(progress) {
    batch_.folder = fs::absolute(folder).lexically_normal();
  }

  Result<Batch> read() {
    std::error_code ignored;
    if (!fs::is_directory(batch_.folder, ignored))
      return Error::unusable(message("There is no such folder; choose a batch folder."),
                             batch_.folder);
    const Result<Layout> layout = findLayout();
    if (!layout) return layout.error();
    batch_.way = wayOf(*layout);
    if (const Result<void> read =
            batch_.way == Way::FreeCamera ? readFreeCameras(*layout) : readRig(*layout);
        !read)
      return read.error();
    if (const Result<void> read =
            readDescriptions({batch_.folder / "plate.json"}, options_, batch_);
        !read)
      return read.error();
    return std::move(batch_);
  }

 private:
  void warn(const fs::path& file, const Message& what) {
    progress_.note(NoteLevel::Warning, about(file, what));
  }

  void leaveOut(LeftOut& left_out, const fs::path& file, const Message& why) {
    left_out.add(about(file, why));
    warn(file, why);
  }

  static bool isRigName(const Layout& layout, const fs::path& file) {
    int camera = 0, stop = 0;
    return camNumbers(file, layout.between, layout.first_camera, camera, stop) &&
           camera >= layout.first_camera;
  }

  // By most names of both sides; a folder without photographs is a rig's that is not filled yet.
  Way wayOf(const Layout& layout) const {
    std::ptrdiff_t rig = 0, other = 0;
    for (const char* side : layout.folder)
      for (const fs::path& file : photographsIn(batch_.folder / side))
        ++(isRigName(layout, file) ? rig : other);
    return other > rig ? Way::FreeCamera : Way::Rig;
  }

  Result<void> readFreeCameras(const Layout& layout) {
    std::error_code ignored;
    for (const Side side : {Side::Front, Side::Back}) {
      const int s = side == Side::Front ? 0 : 1;
      const fs::path folder = batch_.folder / layout.folder[s];
      if (side == Side::Back && !fs::is_directory(folder, ignored)) continue;
      FreeSide free{side, photographsIn(folder), folder, batch_.folder / layout.masks[s]};
      std::erase_if(free.files, [&](const fs::path& file) {
        if (!isRigName(layout, file)) return false;
        leaveOut(free.left_out, file,
                 message("This file name follows the naming of rig photographs, but most others "
                         "do not; this "
                         "photograph is left out."));
        return true;
      });
      Result<std::vector<Shot>> shots = freeCameraShots(free, options_, progress_);
      if (!shots) return shots.error();
      std::move(shots->begin(), shots->end(), std::back_inserter(batch_.shots));
    }
    return {};
  }

  Result<void> readRig(const Layout& layout) {
    for (const Side side : {Side::Front, Side::Back}) collectShots(layout, side);
    for (const Side side : {Side::Front, Side::Back}) nameAbsent(layout, side);
    keepOneSizePerCamera();
    for (const Side side : {Side::Front, Side::Back})
      if (const Result<void> enough = checkViews(layout, side); !enough) return enough.error();
    collectCalibration();
    return {};
  }

  Result<Layout> findLayout() const {
    std::error_code ignored;
    for (const Layout& layout : {kOurs, kPaper}) {
      bool there[2];
      for (int s = 0; s < 2; ++s)
        there[s] = fs::is_directory(batch_.folder / layout.folder[s], ignored);
      if (there[0] && there[1]) return layout;
      if (there[0] && (options_.min_views_per_side == 0 || wayOf(layout) == Way::FreeCamera))
        return layout;
      if (there[0] || there[1]) {
        const int s = there[0] ? 1 : 0;
        return Error::unusable(message(s ? translatable<1>("The back side is missing; put its "
                                                           "photographs into the folder '%1'.")
                                         : translatable<1>("The front side is missing; put its "
                                                           "photographs into the folder '%1'."),
                                       layout.folder[s]),
                               batch_.folder / layout.folder[s]);
      }
    }
    return Error::unusable(message("Not a batch folder: it has neither the folders 'front' and "
                                   "'back' nor 'top_images' and "
                                   "'bottom_images'; choose a batch folder."),
                           batch_.folder);
  }

  void collectShots(const Layout& layout, Side side) {
    const int s = side == Side::Front ? 0 : 1;
    const GivenMasks masks(batch_.folder / layout.masks[s]);
    LeftOut& left_out = left_out_[side];
    for (const fs::path& file : imagesIn(batch_.folder / layout.folder[s])) {
      Shot shot;
      shot.side = side;
      shot.file = file;
      if (!camNumbers(file, layout.between, layout.first_camera, shot.camera, shot.stop) ||
          shot.camera < layout.first_camera) {
        leaveOut(left_out, file,
                 message("The file name does not match the form %1; this photograph is left out.",
                         layout.pattern));
        continue;
      }
      shot.camera -= layout.first_camera;
      if (!named_.insert({side, shot.camera, shot.stop}).second) {
        leaveOut(
            left_out, file,
            message("Another photograph has the same camera and position; this one is left out."));
        continue;
      }
      const Result<images::ImageSize> size = images::readImageSize(file);
      if (!size) {
        left_out.add(size.error().sentence());
        progress_.note(NoteLevel::Warning,
                       inOne(size.error().sentence(), message("This photograph is left out.")));
        continue;
      }
      shot.width = size->width;
      shot.height = size->height;
      masks.attachTo(shot, progress_);
      batch_.shots.push_back(std::move(shot));
    }
    std::ranges::sort(batch_.shots, [](const Shot& a, const Shot& b) {
      return Key(a.side, a.camera, a.stop) < Key(b.side, b.camera, b.stop);
    });
  }

  // The stops of a side. Our own names count them without gaps; the paper's need not.
  std::set<int> stopsOf(const Layout& layout, Side side) const {
    std::set<int> stops;
    for (const auto& [of, camera, stop] : named_)
      if (of == side) stops.insert(stop);
    if (layout.first_camera == 0 && !stops.empty())
      for (int stop = *stops.begin(); stop < *stops.rbegin(); ++stop) stops.insert(stop);
    return stops;
  }

  // A camera goes round with the others when it has half of a side's stops at least; one that takes
  // a single picture from above is meant so.
  bool goesRound(const Layout& layout, Side side, int camera) const {
    const std::set<int> stops = stopsOf(layout, side);
    const auto has = std::ranges::count_if(stops, [&](int stop) {
      return named_.contains({side, camera, stop});
    });
    return 2 * static_cast<std::size_t>(has) >= stops.size() && has > 0;
  }

  // Names what a camera that goes round has no photograph of on this side.
  void nameAbsent(const Layout& layout, Side side) {
    const Side other = side == Side::Front ? Side::Back : Side::Front;
    std::set<int> cameras;
    for (const auto& [of, camera, stop] : named_)
      if (goesRound(layout, side, camera) || goesRound(layout, other, camera))
        cameras.insert(camera);
    std::vector<std::string> absent;
    for (const int stop : stopsOf(layout, side))
      for (const int camera : cameras) {
        if (named_.contains({side, camera, stop})) continue;
        const std::string number = std::to_string(stop);
        const std::size_t digits = layout.first_camera == 0 ? 2 : 3;
        absent.push_back("cam" + std::to_string(camera + layout.first_camera) + layout.between +
                         std::string(digits - std::min(digits, number.size()), '0') + number);
      }
    if (absent.empty()) return;
    constexpr std::size_t kNamed = 6;
    const std::string names =
        joined(std::span(absent).first(std::min(absent.size(), kNamed)), ", ");
    warn(batch_.folder / layout.folder[side == Side::Front ? 0 : 1],
         absent.size() > kNamed
             ? message("Photographs are missing: %1 and %2 more. Surfaces that only they show are "
                       "filled in; retake them if that matters.",
                       names, absent.size() - kNamed)
             : message("Photographs are missing: %1. Surfaces that only they show are filled in; "
                       "retake them if that matters.",
                       names));
  }

  // The size that most photographs of a camera have; the smaller one where two are as frequent, so
  // that the outcome does not depend on an order.
  std::map<int, images::ImageSize> usualSizes() const {
    std::map<int, std::map<std::pair<int, int>, int>> counts;
    for (const Shot& shot : batch_.shots) ++counts[shot.camera][{shot.width, shot.height}];
    std::map<int, images::ImageSize> usual;
    for (const auto& [camera, sizes] : counts) {
      const auto most =
          std::ranges::max_element(sizes, {}, [](const auto& one) { return one.second; });
      usual[camera] = {most->first.first, most->first.second};
    }
    return usual;
  }

  void keepOneSizePerCamera() {
    const std::map<int, images::ImageSize> usual = usualSizes();
    std::erase_if(batch_.shots, [&](const Shot& shot) {
      const images::ImageSize size{shot.width, shot.height}, expected = usual.at(shot.camera);
      if (size == expected) return false;
      leaveOut(left_out_[shot.side], shot.file,
               message("The image has %1 x %2 pixels, but the photographs from its camera have "
                       "%3 x %4; this picture is left out.",
                       size.width, size.height, expected.width, expected.height));
      return true;
    });
  }

  Result<void> checkViews(const Layout& layout, Side side) {
    const auto views =
        std::ranges::count_if(batch_.shots, [&](const Shot& shot) { return shot.side == side; });
    if (views >= options_.min_views_per_side) return {};
    const fs::path folder = batch_.folder / layout.folder[side == Side::Front ? 0 : 1];
    const LeftOut& left_out = left_out_[side];
    if (views + left_out.photographs > 0)  // names are right, or the reason says that they are not
      return tooFewOf(side, views, options_.min_views_per_side, folder, left_out);
    return Error{ErrorCode::NotEnough,
                 message(side == Side::Front
                             ? translatable<3>("Usable photographs of the front side: %1; at least "
                                               "%2 are needed. Add photographs named %3.")
                             : translatable<3>("Usable photographs of the back side: %1; at least "
                                               "%2 are needed. Add photographs named %3."),
                         views, options_.min_views_per_side, layout.pattern),
                 folder.string()};
  }

  void collectCalibration() {
    const std::map<int, images::ImageSize> usual = usualSizes();
    for (const fs::path& file : imagesIn(batch_.folder / "calib")) {
      CalibrationShot shot;
      shot.file = file;
      int number = 0;
      const bool empty = emptyPlateCamera(file, 0, shot.camera);
      if (!empty && !camNumbers(file, "_cal", 0, shot.camera, number)) {
        warn(
            file,
            message(
                "The file name is neither cam<C>_cal<NN>.jpg nor empty_cam<C>.jpg; this picture is "
                "left out."));
        continue;
      }
      const auto expected = usual.find(shot.camera);
      if (expected == usual.end()) continue;  // of a camera that took no photograph
      const Result<images::ImageSize> size = images::readImageSize(file);
      if (!size)
        progress_.note(NoteLevel::Warning,
                       inOne(size.error().sentence(), message("This picture is left out.")));
      else if (*size != expected->second)
        warn(file,
             message("The image has %1 x %2 pixels, but the photographs from its camera have "
                     "%3 x %4; this picture is left out.",
                     size->width, size->height, expected->second.width, expected->second.height));
      else
        (empty ? batch_.empty_plates : batch_.calibration).push_back(std::move(shot));
    }
  }

  ReadBatchOptions options_;
  Progress& progress_;
  std::set<Key> named_;  // photographs by their names, usable or not; cameras from 0
  std::map<Side, LeftOut> left_out_;
  Batch batch_;
};

}  // namespace

const char* name(Side side) {
  return side == Side::Front ? "front" : "back";
}

std::string cameraLetter(int camera) {
  return camera >= 0 && camera < 26 ? std::string(1, static_cast<char>('A' + camera))
                                    : std::to_string(camera);
}

double largestPixels(const Batch& batch) {
  double pixels = 0;
  for (const Shot& shot : batch.shots)
    pixels = std::max(pixels, static_cast<double>(shot.width) * shot.height);
  return pixels;
}

// Measured with 200 megapixels: 1.5 GB for each thread beyond the first on plain paper, 2.2 on a
// fine pattern.
double originalMb(const Batch& batch) {
  constexpr double kBytesOfAPixel = 10;
  return kBytesOfAPixel * largestPixels(batch) / 1e6;
}

int threadsForOriginals(const Batch& batch, int threads, double free_mb) {
  const int most = threads > 0 ? threads : availableThreads();
  const double one_mb = originalMb(batch);
  if (free_mb <= 0 || one_mb <= 0) return most;
  return static_cast<int>(std::clamp(free_mb / 2 / one_mb, 1.0, static_cast<double>(most)));
}

Result<Batch> readBatch(const fs::path& folder, const ReadBatchOptions& options,
                        Progress& progress) {
  return Reader(folder, options, progress).read();
}

}  // namespace ostraka::batch
