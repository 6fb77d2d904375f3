#include "ui/frame/no_batch_yet.h"

#include <QPushButton>

#include "catalogue/batches.h"
#include "records/records.h"
#include "ui/frame/project_session.h"
#include "ui/frame/screen.h"
#include "upkeep/project.h"

namespace ostraka::ui {

NoBatchYet::NoBatchYet(const QString& icon_name, const QString& headline, const QString& words,
                       Screen* screen)
    : EmptyState(icon_name, headline, words, screen),
      first_words_(words),
      act_(addAct({}, screen->iconName() + QStringLiteral("ToCapture"))) {
  connect(act_, &QPushButton::clicked, screen,
          [this, screen] { emit screen->wantsScreen(leads_to_, {}); });
  follow(nullptr);
}

void NoBatchYet::follow(ProjectSession* session) {
  QString queued, failed;
  if (session != nullptr && session->hasProject())
    if (const auto batches = catalogue::Batches(session->project().catalogue()).all())
      for (const records::BatchRecord& batch : *batches) {  // of several the oldest
        const QString number = QString::fromStdString(batch.number);
        if (batch.state == records::BatchState::Queued) queued = number;
        if (batch.state == records::BatchState::Failed) failed = number;
      }
  const bool capture = queued.isEmpty() && failed.isEmpty();
  setWords(!queued.isEmpty()
               ? tr("%1 is in the queue; its results appear here when it is processed.").arg(queued)
           : !failed.isEmpty() ? tr("%1 could not be processed; the queue says why.").arg(failed)
                               : first_words_);
  leads_to_ = capture ? QStringLiteral("capture") : QStringLiteral("queue");
  act_->setText(capture ? tr("Capture a batch") : tr("Show the queue"));
}

}  // namespace ostraka::ui
