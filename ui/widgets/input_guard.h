#pragma once
#include <QObject>

namespace ostraka::ui {

/// For a whole application. Turning the wheel over a form scrolls it: no field under the pointer
/// takes another value by it, which nobody meant and perhaps nobody sees. And while a list or a
/// menu is open, Esc closes it and no shortcut below it hears the key.
class InputGuard final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ostraka::ui
