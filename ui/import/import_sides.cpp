#include "ui/import/import_sides.h"

#include <QCoreApplication>
#include <algorithm>
#include <system_error>
#include <utility>

#include "batch/batch.h"
#include "batch/flip.h"
#include "batch/photograph.h"
#include "batch/photographs.h"
#include "images/raw_image.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoPhotographs = QT_TRANSLATE_NOOP(
    "ImportSides", "There are no photographs in this folder; choose one that holds them.");

Error refused(const char* sentence, const fs::path& where) {
  return Error::unusable(QCoreApplication::translate("ImportSides", sentence).toStdString(),
                         where.string());
}

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

std::vector<fs::path> withPhotographsIn(const fs::path& folder) {
  std::vector<fs::path> within;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (isFolder(at->path()) && !batch::photographsIn(at->path()).empty())
      within.push_back(at->path());
  std::sort(within.begin(), within.end());
  return within;
}

Error severalFolders(const fs::path& folder, const std::vector<fs::path>& within) {
  constexpr std::size_t kNamed = 3;
  QStringList names;
  for (const fs::path& one : within)
    if (static_cast<std::size_t>(names.size()) < kNamed)
      names << QString::fromStdString(one.filename().string());
  if (within.size() > kNamed) names << QStringLiteral("…");
  return Error::unusable(
      QCoreApplication::translate("ImportSides",
                                  "This folder contains several folders with photographs (%1); "
                                  "drop the two of one batch, front and back, onto this page.")
          .arg(names.join(QStringLiteral(", ")))
          .toStdString(),
      folder.string());
}

// The folders of both sides of a batch by hand that is no more than its photographs and the sheet;
// else none: masks and lengths come only with the whole folder. Errors: as readBatch.
Result<std::vector<fs::path>> sidesOfBatch(const fs::path& folder) {
  const std::vector<fs::path> none;
  QuietProgress quiet;
  const Result<batch::Batch> read = batch::readBatch(folder, {}, quiet);
  if (!read) return read.error();
  if (read->way != batch::Way::FreeCamera || read->board || !read->known_lengths.empty())
    return none;
  const std::vector<batch::Shot>& shots = read->shots;
  if (shots.front().side == shots.back().side ||
      std::ranges::any_of(shots, [](const batch::Shot& shot) { return !shot.mask_file.empty(); }))
    return none;
  return std::vector<fs::path>{shots.front().file.parent_path(), shots.back().file.parent_path()};
}

std::optional<fs::path> sheetBeside(const std::vector<fs::path>& folders) {
  std::vector<fs::path> places = folders;
  for (const fs::path& folder : folders)
    if (folder.parent_path() == folders.front().parent_path())
      places.push_back(folder.parent_path());
  std::error_code ignored;
  for (const fs::path& place : places)
    if (fs::is_regular_file(place / "plate.json", ignored)) return place / "plate.json";
  return {};
}

void divide(SidesPlan& plan, std::vector<fs::path> files) {
  batch::Series series = batch::seriesOf(std::move(files));
  plan.files = std::move(series.files);
  plan.first_second = series.first_back;
  plan.divisible = plan.files.size() >= 2 * kLeastOfASide;
  plan.one_side = !plan.divisible;
  plan.flip_found = series.flip_found;
}

// Of the front's photographs.
bool holds(const std::vector<fs::path>& photographs, const fs::path& other) {
  return std::ranges::any_of(photographs, [&](const fs::path& one) {
    std::error_code ignored;
    return fs::equivalent(one, other, ignored);
  });
}

Result<void> areOther(const std::vector<fs::path>& fronts, const std::vector<fs::path>& backs) {
  for (const fs::path& back : backs)
    if (holds(fronts, back))
      return refused(
          QT_TRANSLATE_NOOP("ImportSides",
                            "The photographs of this folder are those of the front already; "
                            "choose another folder for the back, or divide the series with the "
                            "slider."),
          back.parent_path());
  return {};
}

// Whose clock began later holds the backs; without clocks, the one that is called so.
void join(SidesPlan& plan, const fs::path& first, const fs::path& second) {
  const std::vector<fs::path> one = batch::photographsIn(first),
                              other = batch::photographsIn(second);
  plan.files = one;
  plan.files.insert(plan.files.end(), other.begin(), other.end());
  plan.first_second = one.size();
  const batch::Series series = batch::seriesOf({one.front(), other.front()});
  const auto backs = [](const fs::path& folder) {
    return QString::fromStdString(folder.filename().string())
        .contains(QLatin1String("back"), Qt::CaseInsensitive);
  };
  plan.backs_first =
      backs(first) != backs(second) ? backs(first) : series.files.front() == other.front();
}

}  // namespace

ImportSides SidesPlan::sides() const {
  const auto middle = files.begin() + static_cast<std::ptrdiff_t>(first_second);
  ImportSides all;
  all.sheet = sheet;
  if (!sheet) all.marker_mm = marker_mm;
  if (one_side)
    all.front = files;
  else {
    all.front = {files.begin(), middle};
    all.back = {middle, files.end()};
    if (backs_first) std::swap(all.front, all.back);
  }
  return all;
}

Result<std::optional<SidesPlan>> planSides(const QStringList& dropped, const fs::path& last_sheet) {
  std::vector<fs::path> paths;
  for (const QString& path : dropped)
    paths.push_back(fs::absolute(path.toStdString()).lexically_normal());
  for (fs::path& path : paths)
    if (!path.has_filename()) path = path.parent_path();
  if (paths.empty()) return std::optional<SidesPlan>();
  const bool is_batch = paths.size() == 1 && batch::isBatchFolder(paths.front());
  SidesPlan plan;
  plan.from = dropped.join(QStringLiteral(", "));
  if (is_batch) {
    Result<std::vector<fs::path>> sides = sidesOfBatch(paths.front());
    if (!sides) return sides.error();
    if (sides->empty()) return std::optional<SidesPlan>();
    paths = std::move(*sides);
  } else if (paths.size() == 1 && batch::photographsIn(paths.front()).empty()) {
    const std::vector<fs::path> within = withPhotographsIn(paths.front());
    if (within.size() > 2) return severalFolders(paths.front(), within);
    if (within.size() == 2) paths = within;
  }
  if (!std::all_of(paths.begin(), paths.end(), isFolder)) {
    if (std::any_of(paths.begin(), paths.end(), isFolder))
      return refused(
          QT_TRANSLATE_NOOP("ImportSides", "Drop either folders or photographs, not both."),
          paths.front());
    const fs::path folder = paths.front().parent_path();
    std::erase_if(paths, [](const fs::path& path) {
      std::error_code ignored;
      return !fs::is_regular_file(path, ignored) ||
             !(batch::hasPhotographEnding(path) || images::hasRawEnding(path));
    });
    if (paths.empty()) return refused(kNoPhotographs, folder);
    plan.from = QString::fromStdString(folder.string());
    plan.sheet = sheetBeside({folder});
    divide(plan, paths);
  } else {
    if (paths.size() > 2)
      return refused(
          QT_TRANSLATE_NOOP("ImportSides",
                            "These are more than two folders; drop that of the fronts and "
                            "that of the backs."),
          paths.front());
    for (const fs::path& folder : paths)
      if (batch::photographsIn(folder).empty()) return refused(kNoPhotographs, folder);
    plan.sheet = sheetBeside(paths);
    if (paths.size() == 1)
      divide(plan, batch::photographsIn(paths.front()));
    else
      join(plan, paths[0], paths[1]);
    if (is_batch) plan.backs_first = false;  // its folders say which side is which
  }
  std::error_code ignored;
  if (!plan.sheet && fs::is_regular_file(last_sheet, ignored)) plan.sheet = last_sheet;
  return std::optional<SidesPlan>(std::move(plan));
}

Result<SidesPlan> withBack(SidesPlan plan, const QString& folder) {
  const std::vector<fs::path> backs = batch::photographsIn(folder.toStdString());
  if (backs.empty()) return refused(kNoPhotographs, folder.toStdString());
  if (!plan.divisible && !plan.one_side) plan.files = plan.sides().front;
  if (Result<void> other = areOther(plan.files, backs); !other) return other.error();
  plan.first_second = plan.files.size();
  plan.files.insert(plan.files.end(), backs.begin(), backs.end());
  plan.divisible = plan.one_side = plan.backs_first = false;
  plan.flip_found = true;
  return plan;
}

}  // namespace ostraka::ui
