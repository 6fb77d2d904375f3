#pragma once
#include <QPushButton>

namespace ostraka::ui {

/// The next thing to do: large, in the accent colour, with its key at the right.
class BigButton final : public QPushButton {
  Q_OBJECT

 public:
  explicit BigButton(QWidget* parent = nullptr);
  /// "Space": shown beside the text; the shortcut itself belongs to the screen's action.
  void setKeyHint(const QString& key);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString key_;
};

}  // namespace ostraka::ui
