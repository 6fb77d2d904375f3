#pragma once
#include <QPushButton>

namespace ostraka::ui {

/// A button whose text gives way in its middle where there is no room, rather than widening the
/// page; the whole of it is its tool tip then.
class ElidedButton final : public QPushButton {
  Q_OBJECT

 public:
  ElidedButton(const QIcon& icon, const QString& text, QWidget* parent);
  QSize minimumSizeHint() const override;
  QString shownText() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace ostraka::ui
