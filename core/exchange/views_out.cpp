#include "exchange/views_out.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <vector>

#include "batch/photograph.h"
#include "decisions/mask_strokes.h"
#include "files/folder_lock.h"
#include "files/open_folder.h"
#include "images/png_image.h"
#include "rig/camera.h"
#include "stereo/outside_adapter.h"
#include "tables/csv.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMask = ".mask.png";

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, code))
    if (entry.is_regular_file(code)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The photographs of one side with the cameras and the masks that a run left in `out`, without
// those on which no sherd is marked. batch: the batch's folder, wherever it lies now.
Result<std::vector<stereo::View>> savedViews(const fs::path& out, const fs::path& batch,
                                             batch::Side side, const std::stop_token& stop) {
  const Result<std::vector<rig::PosedImage>> images =
      rig::readCameras(out / "work" / "rig" / "cameras.json");
  if (!images) return images.error();
  const std::string masks = decisions::maskFolder(out, side);
  std::vector<stereo::View> views;
  for (const rig::PosedImage& image : *images) {
    if (image.side != side) continue;
    if (stop.stop_requested()) return Error::cancelled();
    Result<cv::Mat> mask = batch::readMask(out / "work" / masks / maskName(image));
    if (!mask) return mask.error();
    if (cv::countNonZero(*mask) == 0) continue;
    // The project may have moved since: only the last two names count.
    const fs::path then = image.file;
    const fs::path now = batch / then.parent_path().filename() / then.filename();
    Result<cv::Mat> photograph = batch::readPhotograph(now);
    if (!photograph) return photograph.error();
    stereo::View view{image, std::move(*photograph), cv::Mat1b(std::move(*mask))};
    view.camera.file = now.string();
    views.push_back(std::move(view));
  }
  return views;
}

Result<void> addSide(archive::BagWriter& bag, const fs::path& folder, const std::string& to,
                     const std::stop_token& stop) {
  for (const fs::path& file : filesIn(folder)) {
    if (file.filename() == kLockFile) continue;
    const std::string name = file.lexically_relative(folder).generic_string();
    if (const auto added = bag.addFile(to + name, file, stop); !added) return added.error();
    if (!name.ends_with(kMask)) continue;
    // COLMAP looks for the image's whole name with .png behind it.
    const std::string image = name.substr(0, name.size() - kMask.size());
    if (const auto added = bag.addFile(to + image + ".png.png", file, stop); !added)
      return added.error();
  }
  return {};
}

Result<void> addBothSides(archive::BagWriter& bag, const fs::path& project,
                          const std::string& number, const fs::path& scratch,
                          const std::stop_token& stop) {
  const fs::path batch = project / "batches" / number;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const auto views = savedViews(project / "results" / number, batch, side, stop);
    if (!views) return views.error();
    // A link may lead to a picture that nobody wants to hand on.
    for (const auto& view : *views) {
      const fs::path photograph = fs::path(view.camera.file).lexically_relative(project);
      const Result<OpenFile> own = OpenFile::within(project, photograph.generic_string());
      if (!own) return own.error();
    }
    stereo::DenseOptions options;
    std::error_code code;
    if (fs::exists(batch / "plate.json", code)) options.floor_z_mm = 0.0;
    const Result<FolderLock> held =
        stereo::writeOutsideFolder(*views, options, scratch, stereo::MaskStyle::OpenMvs, stop);
    if (!held) return held.error();
    const std::string to = "views/" + number + "/" + batch::name(side) + "/";
    if (Result<void> added = addSide(bag, scratch, to, stop); !added) return added;
    std::string names = tables::csvLine({"image", "photograph"});
    for (std::size_t i = 0; i < views->size(); ++i)
      names +=
          tables::csvLine({stereo::viewName(i) + ".png",
                           fs::path((*views)[i].camera.file).lexically_relative(batch).string()});
    if (const auto added = bag.add(to + "photographs.csv", names); !added) return added.error();
  }
  return {};
}

std::int64_t fileBytes(const fs::path& file) {
  std::error_code code;
  const std::uintmax_t bytes = fs::file_size(file, code);
  return code ? 0 : static_cast<std::int64_t>(bytes);
}

// As the adapters write it. That the lens bends it yet changes little.
double pngBytes(const cv::Mat& picture) {
  return static_cast<double>(images::encodedPng(picture, 1).size());
}

struct Pictured {
  fs::path photograph, mask;
  std::int64_t bytes;  ///< of the photograph
};

// PNG take as many times the bytes of a photograph as the middle one's, a mask as many as its mask.
Result<std::int64_t> bytesAsPng(std::vector<Pictured> pictures) {
  const auto middle = pictures.begin() + static_cast<std::ptrdiff_t>(pictures.size() / 2);
  std::nth_element(pictures.begin(), middle, pictures.end(),
                   [](const Pictured& a, const Pictured& b) { return a.bytes < b.bytes; });
  const Result<cv::Mat> photograph = batch::readPhotograph(middle->photograph);
  if (!photograph) return photograph.error();
  const Result<cv::Mat> mask = batch::readMask(middle->mask);
  if (!mask) return mask.error();
  const double photographs = pngBytes(*photograph) / static_cast<double>(middle->bytes),
               masks = pngBytes(*mask >= 128) / static_cast<double>(fileBytes(middle->mask));
  double sum = 0;
  for (const Pictured& one : pictures)
    sum += photographs * static_cast<double>(one.bytes) +
           2 * masks * static_cast<double>(fileBytes(one.mask));
  return static_cast<std::int64_t>(sum);
}

}  // namespace

Result<ViewsSize> sizeOfViews(const fs::path& project, const std::string& number) {
  constexpr int kTextFiles = 4;  // cameras, images, points3D, photographs
  // Of COLMAP's model: half of the views see each of 3000 to 6000 points.
  constexpr double kPoints = 4500, kPointBytes = 60, kBytesSeen = 0.5 * 48;
  const fs::path batch = project / "batches" / number, out = project / "results" / number;
  const auto images = rig::readCameras(out / "work" / "rig" / "cameras.json");
  if (!images) return images.error();
  ViewsSize size;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    std::vector<Pictured> pictures;
    for (const rig::PosedImage& image : *images) {
      if (image.side != side) continue;
      const fs::path photograph = batch / batch::name(side) / fs::path(image.file).filename();
      pictures.push_back({photograph,
                          out / "work" / decisions::maskFolder(out, side) / rig::maskName(image),
                          fileBytes(photograph)});
    }
    if (pictures.empty()) continue;
    const auto views = static_cast<double>(pictures.size());
    size.files += 3 * static_cast<int>(pictures.size()) + kTextFiles;
    const Result<std::int64_t> bytes = bytesAsPng(std::move(pictures));
    if (!bytes) return bytes.error();
    size.bytes += *bytes + static_cast<std::int64_t>(kPoints * (kPointBytes + kBytesSeen * views));
  }
  return size;
}

Result<void> addViews(archive::BagWriter& bag, const fs::path& project, const std::string& number,
                      const fs::path& scratch, const std::stop_token& stop) {
  const Result<void> done = addBothSides(bag, project, number, scratch, stop);
  std::error_code ignored;
  fs::remove_all(scratch, ignored);
  return done;
}

}  // namespace ostraka::exchange
