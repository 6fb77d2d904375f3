// Which rig the screen photographs with, and what is said about photographs that are there already.
#include <QAction>
#include <utility>

#include "ui/capture/capture_screen.h"
#include "ui/capture/rig_page.h"
#include "ui/frame/project_session.h"
#include "ui/import/batch_importer.h"
#include "ui/import/import_chooser.h"
#include "ui/widgets/message_panel.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/rig_renewal.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

constexpr const char* kRigKey = "rig";

}  // namespace

// The same photographs once more are a slip more often than a wish.
void CaptureScreen::buildTwice() {
  twice_ = new MessagePanel(QStringLiteral("importTwice"), this);
  twice_->setSecondAct(tr("Import anyway"));
  connect(importer_, &BatchImporter::alreadyThere, this,
          [this](const QString& number, const QString& folder, int there, int files) {
            twice_->showWords(
                State::Ask, folder,
                there == files
                    ? tr("%1 already has these files, so nothing was imported. If you import "
                         "them anyway, its sherds appear twice in the catalogue.")
                          .arg(number)
                    : tr("%1 already has %2 of these %3 files, so nothing was imported. If you "
                         "import them anyway, the catalogue holds the sherds of both batches; if "
                         "you do not want that, set %1 aside in the queue.")
                          .arg(number)
                          .arg(there)
                          .arg(files),
                tr("OK"));
          });
  for (QAction* import : {import_photographs_, import_scans_}) {  // one at a time
    connect(importer_, &BatchImporter::started, import, [import] { import->setEnabled(false); });
    connect(importer_, &BatchImporter::ended, import, [import] { import->setEnabled(true); });
  }
  connect(twice_, &MessagePanel::actedSecond, importer_, &BatchImporter::startAllTheSame);
  connect(twice_, &MessagePanel::acted, this, [this] {
    twice_->hide();
    setFocus();
  });
}

void CaptureScreen::importPhotographs(const QStringList& paths) {
  chooser_->take(paths);
}

QString CaptureScreen::rigWords() const {
  if (wizard_->phase() == CapturePhase::NoRig) return {};
  return isRigReady() ? wizard_->rig()->source().words : tr("does not answer");
}
bool CaptureScreen::isRigReady() const {
  return wizard_->phase() != CapturePhase::NoRig &&
         !(wizard_->phase() == CapturePhase::Opening && wizard_->fault());
}
void CaptureScreen::chooseRig(const RigChoice& choice) {
  if (session_ == nullptr) return;
  tried_rig_ = choice;
  if (!wizard_->rig()->canRestore()) keepChoice(choice);
  wizard_->rig()->choose(choice.kind == RigChoice::Kind::Virtual ? virtualRigSource(choice)
                                                                 : fileRigSource(choice.file));
  setFocus();
}

void CaptureScreen::keepChoice(const RigChoice& choice) {
  session_->keepSetting(kRigKey, choice.toJson());
}

// What it worked with, practised and photographed stays.
void CaptureScreen::leaveRig() {
  RigChoice none = rigChoice();
  none.kind = RigChoice::Kind::None;
  keepChoice(none);
  rig_page_->setChoice(none);
  wizard_->rig()->forgetPrevious();
}

// A rig that does not open leaves the place to the one that worked.
void CaptureScreen::followRig(const std::optional<Error>& why_not) {
  if (session_ == nullptr) return;
  const RigChoice tried = std::exchange(tried_rig_, {});
  if (!why_not) {
    if (tried.kind != RigChoice::Kind::None) keepChoice(tried);
    return;
  }
  rig_page_->setChoice(rigChoice());
  Error shown = *why_not;
  shown.what =
      tr("%1 The rig that worked before stays in use.").arg(wordsOf(shown.what)).toStdString();
  failure_->showError(shown, tr("OK"));
}

RigChoice CaptureScreen::rigChoice() const {
  return session_ == nullptr ? RigChoice() : RigChoice::fromJson(session_->setting(kRigKey));
}

void CaptureScreen::showItem(const QString& what) {
  const QString batch = what.section(QStringLiteral("calibrate:"), 1);
  if (session_ == nullptr || batch.isEmpty()) return;
  const RigChoice choice = rigChoice();
  if (choice.kind != RigChoice::Kind::File)
    return emit said(tr("This project photographs with no calibrated rig of its own."));
  renewal_->start(*session_, choice.file, batch);
}

}  // namespace ostraka::ui
