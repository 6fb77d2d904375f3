#include "ui/main/project_care.h"

#include "intake/compute_batch.h"
#include "ui/jobs/when_done.h"
#include "ui/main/main_window.h"
#include "ui/words/sentence.h"
#include "upkeep/file_check.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kRoomEvery_ms = 60000;
constexpr int kBackUpEvery_ms = 30 * 60000;
constexpr std::int64_t kShare_bytes = std::int64_t{1} << 30;  // some seconds of a slow disk

}  // namespace

ProjectCare::ProjectCare(JobRunner& runner, QObject* parent) : QObject(parent), runner_(runner) {
  connect(&room_timer_, &QTimer::timeout, this, &ProjectCare::measureRoom);
  connect(&back_up_timer_, &QTimer::timeout, this, &ProjectCare::backUp);
  room_timer_.start(kRoomEvery_ms);
  back_up_timer_.start(kBackUpEvery_ms);
}

void ProjectCare::begin(const std::filesystem::path& folder, bool read_only) {
  folder_ = folder;
  measureRoom();
  if (!read_only) backUp();
  checkFiles();
}

void ProjectCare::end() {
  folder_.clear();
  dropJob(check_);
}

void ProjectCare::measureRoom() {
  if (folder_.empty()) return;
  JobHandle* job =
      runner_.start(makeJob([folder = folder_](Progress&, std::stop_token) -> Result<int> {
                      return intake::roomForBatches(folder);
                    }),
                    this);
  whenDone<int>(job, this, [this](const auto& room) {
    if (room) emit roomMeasured(*room);
  });
}

// What is described by hand has copies, too, not only what is computed.
void ProjectCare::backUp() {
  if (folder_.empty()) return;
  JobHandle* job = runner_.start(makeJob([folder = folder_](Progress&, std::stop_token) {
                                   const auto project = upkeep::Project::open(folder);
                                   return project ? project->backUpIfChanged() : project.error();
                                 }),
                                 this);
  whenDone<bool>(job, this, [this](const auto& done) {
    if (!done && done.error().code != ErrorCode::Cancelled)
      emit said(
          MainWindow::tr("The catalogue could not be copied: %1").arg(sentenceOf(done.error())));
  });
}

void ProjectCare::checkFiles() {
  dropJob(check_);
  check_ =
      runner_.start(makeJob(
                        [folder = folder_](Progress& progress,
                                           std::stop_token stop) -> Result<upkeep::CheckedFiles> {
                          const auto rows = upkeep::Project::connect(folder);
                          if (!rows) return rows.error();
                          return upkeep::checkShare(*rows, folder, kShare_bytes, progress, stop);
                        },
                        JobPriority::Background),
                    this);
  whenDone<upkeep::CheckedFiles>(check_, this, [this](const auto& checked) {
    if (!checked && checked.error().code == ErrorCode::Damaged)
      return emit catalogueDamaged(checked.error());
    if (!checked || checked->damaged.empty()) return;
    emit said(tr("%n file(s) of this project are missing or were changed, first %1. Put them "
                 "back from a copy; 'ostraka catalogue check' lists all of them.",
                 nullptr, static_cast<int>(checked->damaged.size()))
                  .arg(QString::fromStdString(checked->damaged.front().file.path)));
  });
}

}  // namespace ostraka::ui
