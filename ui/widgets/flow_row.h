#pragma once
#include <QLayout>

namespace ostraka::ui {

/// Widgets in a row that goes on in the next line where the width ends, as words do: long words of
/// another language make it higher, not wider than the screen.
class FlowRow final : public QLayout {
 public:
  explicit FlowRow(QWidget* parent = nullptr);
  ~FlowRow() override;

  void setCentred(bool centred) { centred_ = centred; }
  void insertWidget(int index, QWidget* widget);

  void addItem(QLayoutItem* item) override;
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override { return items_.value(index); }
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return arrange({0, 0, width, 0}, false); }
  QSize minimumSize() const override;
  QSize sizeHint() const override;
  void setGeometry(const QRect& where) override;

 private:
  int arrange(const QRect& where, bool place) const;  ///< returns the height

  QSize sizeOf(qsizetype item, const QRect& where) const;

  QList<QLayoutItem*> items_;
  bool centred_ = false;
};

}  // namespace ostraka::ui
