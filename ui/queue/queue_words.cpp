// What a person reads of the queue.
#include <QCoreApplication>
#include <QLocale>

#include "batch/batch.h"
#include "registration/within.h"
#include "ui/frame/lines.h"
#include "ui/queue/batch_queue.h"

namespace ostraka::ui {

QString queueStateWords(QueueState state) {
  switch (state) {
    case QueueState::Shooting:
      return BatchQueue::tr("Capturing");
    case QueueState::Waiting:
      return BatchQueue::tr("Queued");
    case QueueState::Busy:
      return BatchQueue::tr("Processing");
    case QueueState::Paused:
      return BatchQueue::tr("Paused");
    case QueueState::Failed:
      return BatchQueue::tr("Stopped");
    case QueueState::Review:
      return BatchQueue::tr("Needs review");
    case QueueState::Done:
      return BatchQueue::tr("Done");
  }
  return {};
}

QString progressWords(const QueueRow& row) {
  QString words = BatchQueue::tr("%1, %2 %")
                      .arg(stageWords(row.progress.stage))
                      .arg(static_cast<int>(100 * row.progress.fraction));
  if (row.draft) words = BatchQueue::tr("Draft: %1").arg(words);
  QString time = timeLeftWords(row.progress.seconds_left);
  if (time.isEmpty() && row.estimate_s > 0)
    time = timeLeftWords(row.estimate_s * (1 - row.progress.fraction));
  return time.isEmpty() ? words : words + QStringLiteral(", ") + time;
}

QString stateWords(const QueueRow& row) {
  if (row.stopping) return BatchQueue::tr("Stopping…");
  if (row.state == QueueState::Review && row.figures && row.figures->draft)
    return BatchQueue::tr("Draft: review it, then reprocess it");
  if (row.masks_edited) return BatchQueue::tr("Masks edited: reprocess it");
  if (row.state == QueueState::Review && !row.scale_doubts.isEmpty())
    return BatchQueue::tr("Scale in doubt: see the report");
  if (row.state == QueueState::Review && row.figures && row.figures->ask == 0)
    return BatchQueue::tr("Decided: reprocess it");
  if (row.aside) return BatchQueue::tr("Set aside");
  return queueStateWords(row.state);
}

QString figuresWords(const intake::BatchFigures& figures) {
  const QString sherds = BatchQueue::tr("%n sherd(s)", nullptr, figures.sherds);
  QStringList parts;
  if (figures.sure > 0) parts << BatchQueue::tr("%1 sure").arg(figures.sure);
  if (figures.decided > 0) parts << BatchQueue::tr("%1 decided").arg(figures.decided);
  if (figures.ask > 0) parts << BatchQueue::tr("%1 to review").arg(figures.ask);
  const QString pairs =
      figures.sure == figures.sherds
          ? BatchQueue::tr("%n sherd(s), all sure", nullptr, figures.sherds)
          : BatchQueue::tr("%1: %2").arg(sherds, parts.join(QStringLiteral(", ")));
  const QString shown =
      figures.draft ? BatchQueue::tr("draft, to be reprocessed; %1").arg(pairs) : pairs;
  const QString counted =
      figures.counted == 0
          ? shown
          : BatchQueue::tr("%1; but %n counted on the plate", nullptr, figures.counted).arg(shown);
  const QString again =
      figures.reshoot == 0
          ? counted
          : BatchQueue::tr("%1; %n to reshoot", nullptr, figures.reshoot).arg(counted);
  QString told =
      figures.again == 0
          ? again
          : BatchQueue::tr("%1; %n photographed again since", nullptr, figures.again).arg(again);
  for (const sherds::UnlikeBefore& sherd : figures.unlike)
    told = BatchQueue::tr("%1; is %2 the sherd that it was? It measured %3 mm, now %4 mm")
               .arg(told, QString::fromStdString(sherd.number),
                    QLocale().toString(sherd.before_mm, 'f', 1),
                    QLocale().toString(sherd.now_mm, 'f', 1));
  for (const std::string& number : figures.numbers_left)
    told = BatchQueue::tr("%1; the number %2 was typed on its plate, and none of its sherds has it")
               .arg(told, QString::fromStdString(number));
  if (figures.uncertainty_mm <= 0) return told;
  return BatchQueue::tr("%1; joined to within %2 mm")
      .arg(told, QLocale().toString(registration::within95_mm(figures.uncertainty_mm), 'f', 2));
}

QString movedWords(const intake::BatchFigures& figures) {
  QStringList sentences;
  for (const checks::MovedCamera& camera : figures.moved)
    sentences << BatchQueue::tr(
                     "Camera %1 was bumped: it misses the markers by %2 px, %3 mm from where it "
                     "was calibrated.")
                     .arg(QString::fromStdString(batch::cameraLetter(camera.camera)),
                          QLocale().toString(camera.residual_px, 'f', 1),
                          QLocale().toString(camera.moved_mm, 'f', 1));
  if (sentences.isEmpty()) return {};
  sentences << BatchQueue::tr("This batch's cameras were found anew; calibrate the rig again (C).");
  return sentences.join(QLatin1Char(' '));
}

QString withoutBagWords() {
  return BatchQueue::tr("No bag was given; its sherds get their context in the catalogue.");
}

QString stageWords(const QString& stage) {
  struct Words {
    const char* stage;
    const char* words;
  };
  static constexpr Words kStages[] = {
      {"cameras", QT_TRANSLATE_NOOP("Stage", "Finding the cameras")},
      {"masks of the front side", QT_TRANSLATE_NOOP("Stage", "Finding the sherds, front")},
      {"masks of the back side", QT_TRANSLATE_NOOP("Stage", "Finding the sherds, back")},
      {"stereo of the front side", QT_TRANSLATE_NOOP("Stage", "Measuring the shape, front")},
      {"stereo of the back side", QT_TRANSLATE_NOOP("Stage", "Measuring the shape, back")},
      {"scans of the front side", QT_TRANSLATE_NOOP("Stage", "Cutting the sherds out, front")},
      {"scans of the back side", QT_TRANSLATE_NOOP("Stage", "Cutting the sherds out, back")},
      {"pairs", QT_TRANSLATE_NOOP("Stage", "Matching fronts and backs")},
      {"models", QT_TRANSLATE_NOOP("Stage", "Closing the models")},
      {"report", QT_TRANSLATE_NOOP("Stage", "Writing the report")},
      {"candidates", QT_TRANSLATE_NOOP("Stage", "Looking for other partners in doubtful pairs")},
      {"catalogue", QT_TRANSLATE_NOOP("Stage", "Entering the sherds into the catalogue")}};
  if (stage.isEmpty()) return QCoreApplication::translate("Stage", "Starting");
  for (const Words& known : kStages)
    if (stage == QLatin1String(known.stage))
      return QCoreApplication::translate("Stage", known.words);
  return stage;
}

}  // namespace ostraka::ui
