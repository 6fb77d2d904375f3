#pragma once
#include <QListView>
#include <QPoint>

class QLabel;

namespace ostraka::ui {

class CardListModel;

/// The cards. The picture of a back can be dragged onto another card: that front gets it.
class CardList final : public QListView {
  Q_OBJECT

 public:
  explicit CardList(CardListModel& cards, QWidget* parent = nullptr);
  bool pressedOnBack() const { return on_back_; }  ///< by the mouse, last

 signals:
  void backDropped(int front, int back);  ///< onto this front

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyboardSearch(const QString&) override {}  ///< letters are acts here

 private:
  void endDrag();

  CardListModel& cards_;
  QPoint pressed_;
  int dragged_back_ = -1;
  bool on_back_ = false;
  QLabel* ghost_ = nullptr;  ///< the picture that goes along with the mouse
};

}  // namespace ostraka::ui
