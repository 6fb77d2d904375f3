#include "ui/capture/count_edit.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "ui/look/look.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

constexpr int kMostSherds = 60;  // on a plate

// Digits are its own; Space stays the screen's.
class Number final : public QSpinBox {
 public:
  using QSpinBox::QSpinBox;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
      event->ignore();
      return true;
    }
    return QSpinBox::event(event);
  }
};

}  // namespace

CountEdit::CountEdit(QWidget* parent)
    : QWidget(parent), number_(named<Number>("captureCounted", this)) {
  number_->setRange(0, kMostSherds);
  number_->setSpecialValueText(tr("not counted"));
  number_->setAccessibleDescription(tr("How many sherds you counted onto the plate"));
  number_->setToolTip(
      tr("Count them if you like: you are asked when the photographs show another number (S)"));
  number_->setMinimumHeight(targetSize(*this));
  filled(bareLayout<QHBoxLayout>(this), {labelFor(number_, tr("&Sherds")), number_});
  connect(number_, &QSpinBox::valueChanged, this, &CountEdit::counted);
  connect(number_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &CountEdit::entered);
}

void CountEdit::setCount(int sherds) {
  number_->setValue(sherds);
}

void CountEdit::takeKeys() {
  number_->setFocus();
  number_->selectAll();
}

}  // namespace ostraka::ui
