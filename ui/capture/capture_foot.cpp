#include "ui/capture/capture_foot.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include "ui/capture/capture_wizard.h"
#include "ui/capture/count_edit.h"
#include "ui/capture/place_edit.h"
#include "ui/frame/big_button.h"
#include "ui/frame/look.h"

namespace ostraka::ui {

CaptureFoot::CaptureFoot(CaptureWizard* wizard, const Acts& acts, QWidget* parent)
    : SideBySide(parent), wizard_(wizard) {
  button_ = new BigButton(this);
  button_->setObjectName(QStringLiteral("captureButton"));
  button_->setKeyHint(tr("Space"));
  connect(button_, &QPushButton::clicked, acts.next, &QAction::trigger);
  connect(wizard_, &CaptureWizard::shotsChanged, this,
          [this] { button_->setText(wizard_->buttonText()); });
  add(buildFields(), 1);
  add(buildTools(acts), 0);
  add(button_, 2);
}

QWidget* CaptureFoot::buildFields() {
  auto* fields = new QWidget(this);
  place_ = new PlaceEdit(fields);
  place_->setToolTip(
      tr("Typed, from a code reader, or from the bag's label laid under the camera"));
  count_ = new CountEdit(fields);
  connect(place_, &PlaceEdit::entered, this, &CaptureFoot::entered);
  connect(count_, &CountEdit::entered, this, &CaptureFoot::entered);
  connect(count_, &CountEdit::counted, wizard_, &CaptureWizard::setCounted);
  auto* row = new QHBoxLayout(fields);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(place_, 1);
  row->addWidget(count_);
  return fields;
}

QWidget* CaptureFoot::buildTools(const Acts& acts) {
  auto* tools = new QWidget(this);
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  for (QAction* camera : acts.cameras) {
    auto* button = new QToolButton(tools);
    button->setDefaultAction(camera);
    button->setObjectName(camera->objectName() + QStringLiteral("Button"));
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setAccessibleName(camera->text());
    button->setMinimumSize(targetSize(*this), targetSize(*this));
    row->addWidget(button);
  }
  auto* stop = new QToolButton(tools);
  stop->setDefaultAction(acts.stop);
  stop->setObjectName(QStringLiteral("captureStopButton"));
  stop->setAccessibleName(acts.stop->text());
  stop->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto* more = new QToolButton(tools);
  more->setObjectName(QStringLiteral("captureMore"));
  more->setText(tr("More"));
  more->setAccessibleName(tr("Import, another rig, set aside"));
  more->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(more);
  menu->addActions(acts.more);
  more->setMenu(menu);
  for (QToolButton* button : {stop, more}) {
    button->setMinimumHeight(targetSize(*this));
    row->addWidget(button);
  }
  row->addStretch();
  return tools;
}

void CaptureFoot::follow() {
  place_->setEnabled(wizard_->canDescribe());
  count_->setEnabled(wizard_->canDescribe());
  count_->setCount(wizard_->counted());
  button_->setText(wizard_->buttonText());
  button_->setEnabled(wizard_->canGoOn());
  button_->setVisible(!wizard_->fault());
}

}  // namespace ostraka::ui
