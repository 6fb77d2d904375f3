#include "ui/widgets/input_guard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QSlider>

namespace ostraka::ui {

bool InputGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    if (QApplication::activePopupWidget() == nullptr ||
        static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
      return false;
    event->accept();  // a key of the popup, and so no shortcut
    return true;
  }
  if (event->type() != QEvent::Wheel) return false;
  auto* field = qobject_cast<QWidget*>(watched);
  if (field == nullptr || field->parentWidget() == nullptr) return false;
  if (qobject_cast<QComboBox*>(field) == nullptr && qobject_cast<QSlider*>(field) == nullptr &&
      qobject_cast<QAbstractSpinBox*>(field) == nullptr)
    return false;
  event->ignore();  // goes on to what scrolls
  return true;
}

}  // namespace ostraka::ui
