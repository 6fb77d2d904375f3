#pragma once
#include <QList>
#include <QWidget>

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace ostraka::ui {

/// Flat tools in one row, in groups with a caption and a thin line between them. What finds no room
/// stands in a menu at its end, so that a small window hides no tool and a long word widens none.
class ToolRow final : public QWidget {
  Q_OBJECT

 public:
  explicit ToolRow(QWidget* parent = nullptr);
  /// The buttons are named after their actions: "pauseButton". An empty caption takes no room.
  void addGroup(const QString& caption, const QList<QAction*>& actions);
  void addWidget(QWidget* widget);  ///< stays in sight, before the groups
  void setCompact(bool compact);    ///< without captions
  void setTouched();                ///< by gloves: as high as the primary button
  QToolButton* buttonOf(const QAction* action) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Group {
    QLabel* caption;
    QList<QToolButton*> buttons;
  };
  void arrange();
  void refit();
  bool hasCaptions() const;
  int captionHeight() const;
  int rowHeight() const;
  int widthOfGroup(const Group& group) const;
  int widthOfAll() const;
  int fixedWidth() const;

  QList<QWidget*> fixed_;
  QList<Group> groups_;
  QList<int> lines_;  ///< where one group ends
  QToolButton* more_;
  QMenu* menu_;
  bool compact_ = false, touched_ = false;
};

}  // namespace ostraka::ui
