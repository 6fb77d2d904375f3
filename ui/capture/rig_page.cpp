#include "ui/capture/rig_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/look/look.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {

RigPage::RigPage(QWidget* parent)
    : QWidget(parent),
      ask_(new MessagePanel(QStringLiteral("virtualAsk"), this)),
      sherds_(named<QSpinBox>("virtualSherds", this)),
      width_(named<QComboBox>("virtualWidth", this)),
      near_duplicates_(named<QCheckBox>("virtualLookalikes", tr("Two of them look alike"), this)) {
  asks_ = tr("What do you photograph with?");
  explains_ =
      tr("Import photographs taken by hand, or choose a rig file (RIG.json), which names your "
         "cameras and your turntable. The virtual rig is for practice: its sherds are invented.");
  auto* empty = empty_ = new EmptyState(QStringLiteral("turntable"), asks_, explains_, this);
  import_ = empty->addAct(tr("Import photographs…"), QStringLiteral("importPhotographsButton"));
  if (auto* big = qobject_cast<BigButton*>(import_)) big->setKeyHint(tr("Space"));
  connect(import_, &QAbstractButton::clicked, this, &RigPage::importPhotographs);
  connect(empty->addAct(tr("Choose a rig file…"), QStringLiteral("chooseRigFile")),
          &QPushButton::clicked, this, &RigPage::chooseFile);
  scans_ = empty->addAct(tr("Import scans…"), QStringLiteral("importScansButton"));
  connect(scans_, &QAbstractButton::clicked, this, &RigPage::importScans);
  connect(empty->addAct(tr("Use the virtual rig"), QStringLiteral("useVirtualRig")),
          &QPushButton::clicked, this, &RigPage::askForVirtual);
  keep_ = empty->addAct(tr("Keep current rig"), QStringLiteral("keepRig"));
  leave_ = empty->addAct(tr("No rig"), QStringLiteral("noRig"));
  for (QAbstractButton* hidden : {keep_, leave_}) hidden->hide();
  connect(keep_, &QAbstractButton::clicked, this, &RigPage::kept);
  connect(leave_, &QAbstractButton::clicked, this, &RigPage::left);
  ask_->setBesidePrimary();
  ask_->setSecondAct(tr("Cancel"));
  connect(ask_, &MessagePanel::acted, this, &RigPage::chooseVirtual);
  connect(ask_, &MessagePanel::actedSecond, ask_, &QWidget::hide);

  auto* box = new QGroupBox(tr("The virtual rig"), this);
  sherds_->setRange(1, 20);
  width_->addItem(tr("small: a batch in a minute or two"), 800);
  width_->addItem(tr("normal"), 1600);
  width_->addItem(tr("fine: as a real camera"), 2400);
  near_duplicates_->setMinimumHeight(controlHeight(*this));
  auto* form = new QFormLayout(box);
  form->addRow(tr("&Sherds on the plate"), sherds_);
  form->addRow(tr("&Photographs"), width_);
  form->addRow(near_duplicates_);
  alignForm(*form);
  filled(new QVBoxLayout(this), {{empty, 3}, ask_, {box, 0, Qt::AlignHCenter}, Part::room(1)});
  // As the eye goes: the acts first, then what the virtual rig is to break.
  setTabOrder(leave_, sherds_);
  setTabOrder(sherds_, width_);
  setTabOrder(width_, near_duplicates_);
  setChoice({});
}

void RigPage::goOn() {
  auto* button = qobject_cast<QAbstractButton*>(focusWidget());
  (button != nullptr && button->hasFocus() ? button : import_)->click();
}

void RigPage::setImporting(bool importing) {
  empty_->setHeadline(importing ? tr("Importing") : asks_);
  empty_->setWords(importing ? tr("The batch goes into the queue when all of its files are copied. "
                                  "Meanwhile you can choose a rig.")
                             : explains_);
  for (QAbstractButton* button : {import_, scans_}) button->setEnabled(!importing);
}

void RigPage::setCanKeep(bool can) {
  keep_->setVisible(can);
}

void RigPage::setCanLeave(bool can) {
  leave_->setVisible(can);
}

void RigPage::hideEvent(QHideEvent* event) {
  ask_->hide();
  QWidget::hideEvent(event);
}

// Once for a project: what it invents stands among real finds.
void RigPage::askForVirtual() {
  if (choice_.kind == RigChoice::Kind::Virtual) return chooseVirtual();
  ask_->showWords(State::Ask, tr("Use the virtual rig in this project?"),
                  tr("It is for practice: its sherds are invented, and they enter this project's "
                     "catalogue. The queue marks its batches as invented."),
                  tr("Use the virtual rig"));
  if (auto* act = ask_->act()) act->setFocus();
}

void RigPage::setChoice(const RigChoice& choice) {
  ask_->hide();
  choice_ = choice;
  sherds_->setValue(choice.sherds);
  int at = width_->findData(choice.width_px);
  if (at < 0) {
    width_->addItem(tr("%1 pixels wide").arg(choice.width_px), choice.width_px);
    at = width_->count() - 1;
  }
  width_->setCurrentIndex(at);
  near_duplicates_->setChecked(choice.near_duplicates);
}

void RigPage::chooseVirtual() {
  choice_.kind = RigChoice::Kind::Virtual;
  choice_.sherds = sherds_->value();
  choice_.width_px = width_->currentData().toInt();
  choice_.near_duplicates = near_duplicates_->isChecked();
  emit chosen(choice_);
}

void RigPage::chooseFile() {
  QFileDialog* dialog = askForFile(this, tr("Rig file"), {}, tr("Rig (*.json)"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    choice_.kind = RigChoice::Kind::File;
    choice_.file = file.toStdString();
    emit chosen(choice_);
  });
}

}  // namespace ostraka::ui
