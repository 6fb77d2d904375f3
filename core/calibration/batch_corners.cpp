#include "calibration/batch_corners.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "base/memory.h"
#include "base/message.h"
#include "base/parallel.h"
#include "batch/photograph.h"

namespace ostraka::calibration {
namespace {

// In blocks, so that progress is told from the stage's own thread.
bool inBlocks(std::size_t count, int threads, Progress& progress, const std::stop_token& stop,
              const std::function<void(std::size_t)>& body) {
  const std::size_t block =
      static_cast<std::size_t>(threads > 0 ? threads : availableThreads()) * 4;
  for (std::size_t first = 0; first < count; first += block) {
    if (stop.stop_requested()) return false;
    progress.report(static_cast<std::int64_t>(first), static_cast<std::int64_t>(count));
    parallelFor(std::min(block, count - first), threads, [&](std::size_t i) {
      if (!stop.stop_requested()) body(first + i);
    });
  }
  progress.report(static_cast<std::int64_t>(count), static_cast<std::int64_t>(count));
  return !stop.stop_requested();
}

}  // namespace

Result<std::vector<ShotMarkers>> findBatchMarkers(const batch::Batch& batch, int threads,
                                                  Progress& progress, std::stop_token stop) {
  std::vector<ShotMarkers> shots(batch.shots.size());
  std::vector<std::optional<Error>> failed(shots.size());
  const int at_once = batch::threadsForOriginals(batch, threads, freeMemoryMb());
  const bool done = inBlocks(shots.size(), at_once, progress, stop, [&](std::size_t i) {
    const Result<cv::Mat> photograph = batch::readPhotograph(batch.shots[i].file);
    if (!photograph) {
      shots[i].unreadable = photograph.error().sentence();
      return;
    }
    if (stop.stop_requested()) return;  // the search takes as long again
    Result<std::vector<rig::SeenMarker>> seen = rig::findPlateMarkers(*photograph, *batch.plate);
    if (seen)
      shots[i].markers = std::move(*seen);
    else
      failed[i] = seen.error();
  });
  if (!done) return Error::cancelled();
  for (const std::optional<Error>& error : failed)
    if (error) return Error{error->code, error->what, (batch.folder / "plate.json").string()};
  return shots;
}

Result<std::vector<TargetView>> findBatchBoards(const batch::Batch& batch, int threads,
                                                Progress& progress, std::stop_token stop) {
  std::vector<TargetView> views(batch.calibration.size());
  std::vector<Message> unreadable(views.size());
  std::vector<std::optional<Error>> failed(views.size());
  // By the cameras that the shots are from.
  const int at_once = batch::threadsForOriginals(batch, threads, freeMemoryMb());
  const bool done = inBlocks(views.size(), at_once, progress, stop, [&](std::size_t i) {
    const Result<cv::Mat> photograph = batch::readPhotograph(batch.calibration[i].file);
    if (!photograph) {
      unreadable[i] = photograph.error().sentence();
    } else {
      Result<TargetView> view = findBoard(*photograph, *batch.board);
      if (view)
        views[i] = std::move(*view);
      else
        failed[i] = view.error();
    }
    views[i].file = batch.calibration[i].file.string();
  });
  if (!done) return Error::cancelled();
  for (const std::optional<Error>& error : failed)
    if (error) return Error{error->code, error->what, (batch.folder / "board.json").string()};
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!unreadable[i].empty())
      progress.note(NoteLevel::Warning, inOne(unreadable[i], message("This picture is left out.")));
    else if (views[i].points.empty())
      progress.note(
          NoteLevel::Warning,
          message("%1: The board was not detected; this picture is left out.", views[i].file));
  }
  return views;
}

}  // namespace ostraka::calibration
