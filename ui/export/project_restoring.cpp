#include "ui/export/project_restoring.h"

#include <QDir>
#include <QFileInfo>
#include <filesystem>

#include "archive/archive.h"
#include "ui/frame/lines.h"
#include "ui/jobs/when_done.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

ProjectRestoring::ProjectRestoring(JobRunner& runner, QObject* parent)
    : QObject(parent), runner_(runner) {}

QString ProjectRestoring::placeIn(const QString& chosen, const QString& archive) {
  const QDir folder(chosen);
  if (!folder.exists() || folder.isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot))
    return chosen;
  QString name = QFileInfo(QDir(archive).absolutePath()).fileName();
  name.remove(QStringLiteral("-archive"));
  QString place = folder.filePath(name);
  for (int n = 2; QFileInfo::exists(place); ++n)
    place = folder.filePath(QStringLiteral("%1-%2").arg(name).arg(n));
  return place;
}

void ProjectRestoring::restore(const QString& archive, const QString& folder) {
  if (job_ != nullptr) return;
  const std::filesystem::path from = archive.toStdString(), to = folder.toStdString();
  job_ = runner_.start(makeJob(
                           [from, to](Progress& progress, std::stop_token stop) {
                             return archive::restoreProject(from, to, progress, stop);
                           },
                           JobPriority::Background),
                       this);
  const auto tell = [this, folder](const JobProgress& progress) {
    QString words = tr("%1 %").arg(static_cast<int>(100 * progress.fraction));
    if (const QString left = timeLeftWords(progress.seconds_left); !left.isEmpty())
      words += QStringLiteral(", ") + left;
    emit progressed(folder, words);
  };
  connect(job_, &JobHandle::progressed, this, tell);
  whenDone<archive::Restored>(job_, this, [this, folder](const auto& done) {
    if (!done) return emit failed(done.error());
    QStringList damage;
    for (const Message& line : done->damage) damage << wordsOf(line);
    emit restored(folder, damage);
  });
  tell({});
}

void ProjectRestoring::cancel() {
  if (job_ != nullptr) job_->cancel();
}

}  // namespace ostraka::ui
