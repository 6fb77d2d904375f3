#pragma once
#include <QScrollArea>

namespace ostraka::ui {

/// Holds a page of the window: as large as there is room, and scrolled where large text or a small
/// screen leaves less than the page needs, so that nothing lies beyond the screen's edge.
class PageArea final : public QScrollArea {
  Q_OBJECT

 public:
  explicit PageArea(QWidget* page, QWidget* parent = nullptr);
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
};

}  // namespace ostraka::ui
