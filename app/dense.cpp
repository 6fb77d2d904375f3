#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/limits.h"
#include "base/text.h"
#include "batch/photograph.h"
#include "cloud/ply.h"
#include "command.h"
#include "files/json.h"
#include "files/open_folder.h"
#include "files/output_place.h"
#include "mask/given_mask.h"
#include "mask/hull_mask.h"
#include "rig/camera.h"
#include "shown.h"
#include "stereo/background.h"
#include "stereo/stereo.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct DenseArguments {
  fs::path images, cameras, output;
  std::optional<fs::path> masks;
  double megapixels = 5;
  int threads = 0;
};

// Photograph, mask and camera averaged down together.
stereo::View reducedTo(stereo::View view, double megapixels) {
  view.camera.intrinsics = rig::reducedTo(view.camera.intrinsics, megapixels);
  const int width = view.camera.intrinsics.width, height = view.camera.intrinsics.height;
  view.photograph = batch::reducedTo(view.photograph, width, height);
  view.mask = batch::reducedTo(view.mask, width, height);
  return view;
}

// The photograph's mask beside its own name or stem, whatever folder the camera file gives.
std::optional<fs::path> maskFileOf(const fs::path& folder, const fs::path& file) {
  const std::string stem = file.stem().string(), name = file.filename().string();
  fs::path with_folders = folder / file;
  with_folders.replace_extension(".png");
  for (const fs::path& candidate :
       {with_folders, folder / (stem + ".png"), folder / (name + ".png"),
        folder / (stem + "_mask.png"), folder / (stem + ".tif")}) {
    std::error_code failed;
    if (fs::is_regular_file(candidate, failed)) return candidate;
  }
  return {};
}

// The results of `process` name their photographs absolutely; a name that lies in the folder counts
// from there, any other is one that ContainedPath refuses.
std::string nameWithin(const fs::path& folder, const fs::path& file) {
  if (!file.is_absolute()) return file.lexically_normal().string();
  const fs::path name =
      file.lexically_normal().lexically_relative(fs::absolute(folder).lexically_normal());
  return name.empty() || *name.begin() == ".." ? file.string() : name.string();
}

Result<cv::Mat> readPhotograph(const fs::path& folder, const std::string& name) {
  Result<OpenFile> open = OpenFile::within(folder, name);
  if (!open) return open.error();
  const Result<std::string> bytes = open->readAll(limits::kImageBytes.most);
  return bytes ? batch::decodePhotograph(*bytes, open->name()) : Result<cv::Mat>(bytes.error());
}

Result<stereo::View> readView(const DenseArguments& arguments, const rig::PosedImage& camera) {
  const std::string name = nameWithin(arguments.images, camera.file);
  const fs::path file = arguments.images / name;
  stereo::View view;
  view.camera = camera;
  Result<cv::Mat> photograph = readPhotograph(arguments.images, name);
  if (!photograph) return photograph.error();
  view.photograph = std::move(*photograph);
  const int width = camera.intrinsics.width, height = camera.intrinsics.height;
  if (view.photograph.cols != width || view.photograph.rows != height)
    return Error::unusable("The photograph is " + std::to_string(view.photograph.cols) + "x" +
                               std::to_string(view.photograph.rows) +
                               " pixels, but its camera says " + std::to_string(width) + "x" +
                               std::to_string(height) + ".",
                           file.string());
  if (!arguments.masks) {
    view.mask = stereo::possibleObject(view.photograph);
    return view;
  }
  const std::optional<fs::path> mask_file = maskFileOf(*arguments.masks, name);
  if (!mask_file)
    return Error::unusable("This photograph has no mask; expected " +
                               fs::path(camera.file).stem().string() + ".png in " +
                               arguments.masks->string() + ".",
                           file.string());
  Result<cv::Mat1b> mask = mask::readGivenMask(*mask_file, width, height);
  if (!mask) return mask.error();
  view.mask = std::move(*mask);
  return view;
}

// One bad photograph costs that view, with a warning.
Result<std::vector<stereo::View>> readViews(const DenseArguments& arguments, Session& session) {
  const Result<std::vector<rig::PosedImage>> cameras = rig::readCameras(arguments.cameras);
  if (!cameras) return cameras.error();
  session.progress.begin("photographs", 0.02);
  std::vector<stereo::View> views;
  std::string first_wrong;
  for (const rig::PosedImage& camera : *cameras) {
    if (session.stop.stop_requested()) return Error::cancelled();
    Result<stereo::View> view = readView(arguments, camera);
    if (view) {
      views.push_back(reducedTo(std::move(*view), arguments.megapixels));
    } else {
      if (first_wrong.empty()) first_wrong = view.error().sentence().english();
      session.progress.note(NoteLevel::Warning, inOne(view.error().sentence(), "It is left out."));
    }
  }
  if (views.size() < 3)
    return Error{ErrorCode::NotEnough,
                 "Only " + std::to_string(views.size()) + " of " + std::to_string(cameras->size()) +
                     " photographs can be used; 3 are needed." +
                     (first_wrong.empty() ? "" : " The first trouble: " + first_wrong),
                 arguments.cameras.string()};
  return views;
}

// Where the background is not dark, the photographs themselves say nothing about the object: the
// body that they agree on is taken.
Result<void> maskCluttered(std::vector<stereo::View>& views, int threads, Session& session) {
  const auto unmasked = std::ranges::count_if(
      views, [](const stereo::View& view) { return stereo::isEverything(view.mask); });
  if (2 * static_cast<std::size_t>(unmasked) < views.size()) return {};
  session.progress.begin("masks", 0.05);
  session.progress.note(NoteLevel::Info,
                        "dense: the background is not dark; masks are found from the body that "
                        "all photographs show");
  std::vector<rig::PosedImage> cameras;
  std::vector<cv::Mat> photographs;
  for (const stereo::View& view : views) {
    cameras.push_back(view.camera);
    photographs.push_back(view.photograph);
  }
  mask::HullMaskOptions options;
  options.threads = threads;
  Result<mask::MaskResult> masks =
      mask::maskByHull(cameras, photographs, options, session.progress, session.stop);
  if (!masks && masks.error().code == ErrorCode::NotEnough) {
    session.progress.note(NoteLevel::Warning,
                          inOne(masks.error().sentence(), "All pixels are used."));
    return {};
  }
  if (!masks) return masks.error();
  for (std::size_t i = 0; i < views.size(); ++i) views[i].mask = stereo::wholeBody(masks->masks[i]);
  return {};
}

// "bounding_box_mm": {"min": [x, y, z], "max": [x, y, z]} beside the images, where the file has it.
Result<std::optional<Eigen::AlignedBox3d>> readBounds(const fs::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  if (!json->is_object() || !json->contains("bounding_box_mm"))
    return std::optional<Eigen::AlignedBox3d>();
  const nlohmann::json& box = (*json)["bounding_box_mm"];
  Eigen::AlignedBox3d bounds;
  bool fine = box.is_object() && box.contains("min") && box.contains("max");
  for (const char* corner : {"min", "max"}) {
    fine = fine && box[corner].is_array() && box[corner].size() == 3;
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t axis = 0; fine && axis < 3; ++axis) {
      fine = box[corner][axis].is_number();
      if (fine) p[static_cast<Eigen::Index>(axis)] = box[corner][axis].get<double>();
    }
    if (fine) (corner[1] == 'i' ? bounds.min() : bounds.max()) = p;
  }
  if (!fine || bounds.isEmpty())
    return Error::unusable("bounding_box_mm must be {\"min\": [x, y, z], \"max\": [x, y, z]}.",
                           file.string());
  return std::optional<Eigen::AlignedBox3d>(bounds);
}

ordered_json figuresOf(const stereo::Agreement& agreement) {
  return {{"confirmed_share", agreement.confirmedShare()},
          {"covered_share", agreement.coveredShare()}};
}

std::string inWords(const stereo::Agreement& agreement) {
  return "Other photographs confirm " + fixed(100 * agreement.confirmedShare(), 0) +
         " % of the depths, which cover " + fixed(100 * agreement.coveredShare(), 0) +
         " % of what the masks show.";
}

// With wrong cameras there is no surface; a cloud of chance points would pass for one.
int disagree(Session& session, const stereo::Agreement& agreement, ordered_json figures) {
  const std::string sentence =
      "The photographs do not agree on a surface, so no cloud was written. " + inWords(agreement) +
      " Check that the cameras are those of these photographs and of their orientation.";
  session.finishProgress();
  show(stderr, "ostraka: %s\n", sentence.c_str());
  figures.update({{"error", sentence}, {"stopped", false}});
  return finish(session, NotWhole, std::move(figures), [] {});
}

int runDense(const DenseArguments& arguments, Session& session) {
  const auto begin = std::chrono::steady_clock::now();
  if (const Result<void> good = checkOutputFile(arguments.output, {".ply"}, {arguments.cameras});
      !good)
    return fail(session, good.error());
  Result<std::vector<stereo::View>> views = readViews(arguments, session);
  if (!views) return fail(session, views.error());
  if (!arguments.masks)
    if (const Result<void> masked = maskCluttered(*views, arguments.threads, session); !masked)
      return fail(session, masked.error());
  Result<std::optional<Eigen::AlignedBox3d>> bounds = readBounds(arguments.cameras);
  if (!bounds) return fail(session, bounds.error());
  session.progress.begin("stereo", 0.93);
  stereo::DenseOptions options;
  options.bounds = *bounds;
  options.threads = arguments.threads;
  const Result<stereo::Reconstruction> found =
      stereo::reconstruct(*views, options, session.progress, session.stop);
  if (!found) return fail(session, found.error());
  ordered_json figures = figuresOf(found->agreement);
  if (!found->agreement.plausible()) return disagree(session, found->agreement, std::move(figures));
  const Result<void> written = writePly(arguments.output, found->cloud, "world");
  if (!written) return fail(session, written.error());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  figures.update({{"output", arguments.output.string()},
                  {"points", found->cloud.size()},
                  {"views", views->size()},
                  {"seconds", seconds}});
  return finish(session, Whole, std::move(figures), [&] {
    show(stdout, "%zu points from %zu photographs in %.0f s: %s\n%s\n", found->cloud.size(),
         views->size(), seconds, arguments.output.c_str(), inWords(found->agreement).c_str());
  });
}

}  // namespace

void addDense(CLI::App& root, Command& chosen) {
  CLI::App* command =
      root.add_subcommand("dense", "Dense reconstruction alone, of photographs with known cameras");
  command->footer(
      "CAMERAS.json: "
      "{\"unit\":\"mm\",\"images\":[{\"file\",\"width\",\"height\",\"K\",\"dist\",\"R\",\"t\"}]},\n"
      "x_cam = R X + t, OpenCV's axes, a pixel's centre has integer coordinates. Its\n"
      "\"bounding_box_mm\" {\"min\",\"max\"} bounds what is reconstructed. Without --masks "
      "everything\n"
      "that is lit before a dark background counts as the object; where the background is not "
      "dark,\n"
      "the body in the middle of all views that the photographs agree on.");
  auto arguments = std::make_shared<DenseArguments>();
  command->add_option("IMAGES", arguments->images, "Folder of the photographs")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--cameras", arguments->cameras, "CAMERAS.json")->required();
  command
      ->add_option("--masks", arguments->masks,
                   "Folder of masks: NAME.png for NAME.jpg, 0 = background")
      ->check(CLI::ExistingDirectory);
  command->add_option("--output,-o", arguments->output, "The cloud, a PLY file")->required();
  addThreads(*command, arguments->threads);
  command
      ->add_option("--megapixels", arguments->megapixels,
                   "Photographs of more millions of pixels are averaged down to this: more takes "
                   "more memory and time")
      ->check(CLI::Range(0.3, 1000.0))
      ->capture_default_str();
  workOf(*command, chosen, runDense, arguments);
}

}  // namespace ostraka::app
