#pragma once
#include <QObject>

namespace ostraka::ui {

/// Turning the wheel over a form scrolls it: no field under the pointer takes another value by it,
/// which nobody meant and perhaps nobody sees. For a whole application.
class WheelGuard final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ostraka::ui
