#include "ui/widgets/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace ostraka::ui {

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
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
