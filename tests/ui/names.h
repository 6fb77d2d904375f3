#pragma once
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextEdit>

/// What a screen reader says of a window: the tests walk all its controls, shown or not.
namespace ostraka::ui {

inline bool isControl(const QWidget* widget) {
  return qobject_cast<const QAbstractButton*>(widget) != nullptr ||
         qobject_cast<const QLineEdit*>(widget) != nullptr ||
         qobject_cast<const QComboBox*>(widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         qobject_cast<const QAbstractSlider*>(widget) != nullptr ||
         qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
         qobject_cast<const QTextEdit*>(widget) != nullptr ||
         qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
         qobject_cast<const QProgressBar*>(widget) != nullptr ||
         widget->focusPolicy() != Qt::NoFocus;
}

/// Parts that Qt makes inside a control speak with the control's name.
inline bool isPartOfAnother(const QWidget* widget) {
  if (qobject_cast<const QScrollBar*>(widget) != nullptr) return true;
  if (widget->objectName().startsWith(QLatin1String("qt_"))) return true;
  for (const QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget())
    if (qobject_cast<const QAbstractSpinBox*>(up) != nullptr ||
        qobject_cast<const QComboBox*>(up) != nullptr ||
        qobject_cast<const QLineEdit*>(up) != nullptr ||
        qobject_cast<const QAbstractItemView*>(up) != nullptr ||
        (qobject_cast<const QAbstractScrollArea*>(up) != nullptr &&
         qobject_cast<const QScrollArea*>(up) == nullptr))  // that holds whole pages
      return true;
  return false;
}

inline QStringList namelessIn(const QWidget& window) {
  QStringList nameless;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!isControl(widget) || isPartOfAnother(widget)) continue;
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
    if (spoken == nullptr || spoken->text(QAccessible::Name).trimmed().isEmpty())
      nameless << QStringLiteral("%1 '%2' in '%3'")
                      .arg(widget->metaObject()->className(), widget->objectName(),
                           widget->parentWidget()->objectName());
  }
  return nameless;
}

}  // namespace ostraka::ui
