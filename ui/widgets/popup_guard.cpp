#include "ui/widgets/popup_guard.h"

#include <QApplication>
#include <QKeyEvent>

namespace ostraka::ui {

bool PopupGuard::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride || QApplication::activePopupWidget() == nullptr ||
      static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return false;
  event->accept();  // a key of the popup, and so no shortcut
  return true;
}

}  // namespace ostraka::ui
