#pragma once
#include <QWidget>

class QBoxLayout;

namespace ostraka::ui {

/// Parts side by side; below each other where large letters or a small screen leave no room.
class SideBySide : public QWidget {
  Q_OBJECT

 public:
  explicit SideBySide(QWidget* parent = nullptr);
  void add(QWidget* part, int stretch);
  QSize minimumSizeHint() const override;

 protected:
  bool isRow() const;  ///< side by side just now
  void resizeEvent(QResizeEvent* event) override;

 private:
  QBoxLayout* box_;
};

}  // namespace ostraka::ui
