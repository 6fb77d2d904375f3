#pragma once
#include <QObject>

namespace ostraka::ui {

/// While a list or a menu is open, Esc closes it and no shortcut below it hears the key. For a
/// whole application.
class PopupGuard final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ostraka::ui
