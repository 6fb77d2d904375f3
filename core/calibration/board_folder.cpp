#include "calibration/board_folder.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/limits.h"
#include "base/message.h"
#include "base/parallel.h"
#include "batch/photograph.h"
#include "batch/photographs.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::calibration {
namespace {

namespace fs = std::filesystem;

struct Target {
  std::optional<MarkerGrid> grid;
  std::optional<batch::Board> board;
  Result<TargetView> find(const cv::Mat& picture) const {
    return grid ? findGrid(picture, *grid) : findBoard(picture, *board);
  }
};

Result<Target> readTarget(const fs::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  if (!json->is_object() || json->value("type", "") != "aruco_grid") {
    const Result<batch::Board> board = batch::readBoard(file);
    if (!board) return board.error();
    return Target{{}, *board};
  }
  constexpr int kMostSquares = limits::kBoardSquares.most;
  constexpr double kMost_mm = limits::kPlateReach_mm.most;
  MarkerGrid grid;
  try {
    grid.dictionary = json->at("dictionary").get<std::string>();
    grid.markers_x = wholeAt(*json, "markers_x", 1, kMostSquares);
    grid.markers_y = wholeAt(*json, "markers_y", 1, kMostSquares);
    grid.marker_mm = numberAt(*json, "marker_length", 0.01, kMost_mm);
    grid.gap_mm = numberAt(*json, "marker_separation", 0.01, kMost_mm);
    grid.first_id = wholeOr(*json, "first_id", 0, 0, 1'000'000);
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(refused,
                        message("A grid of markers needs 'dictionary', 'markers_x', 'markers_y', "
                                "'marker_length' and 'marker_separation'."),
                        file.string());
  }
  return Target{grid, {}};
}

int cameraOf(const fs::path& file) {
  int camera = 0, number = 0;
  return std::sscanf(file.stem().c_str(), "cam%d_cal%d", &camera, &number) == 2 ? camera : 0;
}

struct Found {
  cv::Size size;
  TargetView view;
  Message unreadable;
};

}  // namespace

Result<std::map<int, BoardPictures>> readBoardFolder(const fs::path& folder, int threads,
                                                     Progress& progress, std::stop_token stop) {
  std::error_code absent;
  if (!fs::exists(folder / "board.json", absent))
    return Error::unusable(
        message("Nothing to calibrate from: put photographs of the plate at each position into "
                "'front' (cam0_pos00.jpg and so on) and pictures of the board into 'calib', and "
                "copy plate.json and board.json next to them."),
        folder.string());
  const Result<Target> target = readTarget(folder / "board.json");
  if (!target) return target.error();
  std::error_code ignored;
  std::vector<fs::path> files =
      batch::photographsIn(fs::is_directory(folder / "calib", ignored) ? folder / "calib" : folder);
  std::erase_if(files, [](const fs::path& file) {
    return file.filename().string().starts_with("empty_cam");
  });
  if (files.empty())
    return Error::unusable(
        message("No pictures of the board found; put them here or into 'calib'."), folder.string());
  std::vector<Found> found(files.size());
  constexpr std::size_t kBlock = 8;  // between two looks at the stop
  for (std::size_t first = 0; first < files.size(); first += kBlock) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(static_cast<std::int64_t>(first), static_cast<std::int64_t>(files.size()));
    parallelFor(std::min(kBlock, files.size() - first), threads, [&](std::size_t k) {
      Found& one = found[first + k];
      const Result<cv::Mat> picture = batch::readPhotograph(files[first + k]);
      if (!picture) {
        one.unreadable = picture.error().sentence();
        return;
      }
      one.size = picture->size();
      Result<TargetView> view = target->find(*picture);
      if (view)
        one.view = std::move(*view);
      else
        one.unreadable = view.error().sentence();
      one.view.file = files[first + k].filename().string();
    });
  }
  std::map<int, BoardPictures> cameras;
  for (std::size_t i = 0; i < files.size(); ++i) {
    BoardPictures& camera = cameras[cameraOf(files[i])];
    const std::string name = files[i].filename().string();
    if (!found[i].unreadable.empty()) {
      camera.set_aside.push_back(inOne(found[i].unreadable, message("It is set aside.")));
      continue;
    }
    if (camera.width == 0) {
      camera.width = found[i].size.width;
      camera.height = found[i].size.height;
    }
    if (found[i].size != cv::Size(camera.width, camera.height))
      camera.set_aside.push_back(
          message("%1: its size differs from that of the first picture; it is set aside.", name));
    else
      camera.views.push_back(std::move(found[i].view));
  }
  return cameras;
}

}  // namespace ostraka::calibration
