#include "ui/main/file_watch.h"

#include "ui/jobs/when_done.h"
#include "upkeep/file_check.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr std::int64_t kShare_bytes = std::int64_t{1} << 30;  // some seconds of a slow disk

}  // namespace

FileWatch::FileWatch(JobRunner& runner, QObject* parent) : QObject(parent), runner_(runner) {}

void FileWatch::look(const std::filesystem::path& project) {
  stop();
  job_ = runner_.start(
      makeJob(
          [project](Progress& progress, std::stop_token stop) -> Result<upkeep::CheckedFiles> {
            const auto rows = upkeep::Project::connect(project);
            if (!rows) return rows.error();
            return upkeep::checkShare(*rows, project, kShare_bytes, progress, stop);
          },
          JobPriority::Background),
      this);
  whenDone<upkeep::CheckedFiles>(job_, this, [this](const auto& checked) {
    if (!checked && checked.error().code == ErrorCode::Damaged)
      return emit catalogueDamaged(checked.error());
    if (!checked || checked->damaged.empty()) return;
    emit found(tr("%n file(s) of this project are missing or were changed, first %1. Put them "
                  "back from a copy; 'ostraka catalogue check' lists all of them.",
                  nullptr, static_cast<int>(checked->damaged.size()))
                   .arg(QString::fromStdString(checked->damaged.front().file.path)));
  });
}

void FileWatch::stop() {
  dropJob(job_);
}

}  // namespace ostraka::ui
