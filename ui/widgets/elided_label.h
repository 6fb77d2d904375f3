#pragma once
#include <QLabel>

namespace ostraka::ui {

/// A line of plain text that ends with … where there is no room, rather than widening the window;
/// the whole of it is its tool tip.
class ElidedLabel final : public QLabel {
  Q_OBJECT

 public:
  using QLabel::QLabel;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace ostraka::ui
