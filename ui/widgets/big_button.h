#pragma once
#include <QPushButton>

namespace ostraka::ui {

/// The next step of a page: large, filled with the accent colour, with its key at the right.
class BigButton final : public QPushButton {
  Q_OBJECT

 public:
  BigButton(const QString& name, const QString& text, QWidget* parent);
  /// "Space": shown beside the text; the shortcut itself belongs to the screen's action.
  void setKeyHint(const QString& key);
  /// Outlined only, where another button of the page is the one to press now.
  void setPrimary(bool primary);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool isOnOneLine() const { return letters().one_line; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Letters {
    double factor;  ///< of the body's
    bool one_line;
  };
  Letters letters() const;
  QRectF keyCap() const;  ///< empty: none
  QRectF wordsRect() const;

  QString key_;
  bool primary_ = true;
};

}  // namespace ostraka::ui
