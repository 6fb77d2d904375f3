#include "ui/capture/capture_foot.h"

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/capture/count_edit.h"
#include "ui/import/place_edit.h"
#include "ui/look/look.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/tool_row.h"
#include "ui/wizard/batch_description.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/side_progress.h"

namespace ostraka::ui {

CaptureFoot::CaptureFoot(CaptureWizard* wizard, const Acts& acts, QWidget* parent)
    : SideBySide(parent), wizard_(wizard), text_(*wizard) {
  button_ = new BigButton(QStringLiteral("captureButton"), {}, this);
  button_->setKeyHint(tr("Space"));
  connect(button_, &QPushButton::clicked, acts.next, &QAction::trigger);
  connect(wizard_->side(), &SideProgress::changed, this, [this] { showButton(); });
  fields_ = buildFields();
  add(fields_, 1);
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
  connect(count_, &CountEdit::counted, wizard_->description(), &BatchDescription::setCounted);
  filled(bareLayout<QHBoxLayout>(fields), {{place_, 1}, count_});
  return fields;
}

QWidget* CaptureFoot::buildTools(const Acts& acts) {
  tools_ = new ToolRow(this);
  tools_->setTouched();
  tools_->addGroup({}, QList<QAction*>(acts.cameras.begin(), acts.cameras.end()));
  tools_->addGroup({}, {acts.stop});
  tools_->addGroup({}, acts.more);
  for (QAction* camera : acts.cameras) {
    tools_->buttonOf(camera)->setToolButtonStyle(Qt::ToolButtonTextOnly);
    tools_->buttonOf(camera)->setMinimumWidth(targetSize(*this));
  }
  return tools_;
}

QAbstractButton* CaptureFoot::button() const {
  return button_;
}

void CaptureFoot::setCompact(bool compact) {
  tools_->setCompact(compact);
  place_->setCompact(compact);
}

void CaptureFoot::showButton() {
  button_->setText(text_.button());
  shareWidth();
}

void CaptureFoot::resizeEvent(QResizeEvent* event) {
  SideBySide::resizeEvent(event);
  shareWidth();
}

// The tools go into their menu before the button's text loses its room.
void CaptureFoot::shareWidth() {
  const int left =
      width() - fields_->sizeHint().width() - button_->sizeHint().width() - 2 * layout()->spacing();
  tools_->setMaximumWidth(isRow() ? qMax(left, tools_->minimumSizeHint().width())
                                  : QWIDGETSIZE_MAX);
}

void CaptureFoot::follow() {
  place_->setEnabled(wizard_->canDescribe());
  count_->setEnabled(wizard_->canDescribe());
  count_->setCount(wizard_->batch().counted());
  showButton();
  button_->setEnabled(wizard_->canGoOn());
  button_->setVisible(!wizard_->fault());
}

}  // namespace ostraka::ui
