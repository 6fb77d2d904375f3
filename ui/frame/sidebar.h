#pragma once
#include <QFrame>
#include <QSize>
#include <vector>

class QAction;
class QActionGroup;
class QToolButton;
class QVBoxLayout;

namespace ostraka::ui {

class Screen;

/// The column of screens at the left. Each is an action with Ctrl+1..9; a count that wants a
/// person stands beside its word, and in words for screen readers.
class Sidebar final : public QFrame {
  Q_OBJECT

 public:
  explicit Sidebar(QWidget* parent = nullptr);

  QAction* addScreen(Screen* screen);
  /// At the foot of the sidebar: settings, help.
  QAction* addFoot(const QString& icon_name, const QString& text, const QKeySequence& key);
  void select(int index);
  int selected() const;
  /// Words below their icons where the window is small.
  void fit(const QSize& window);

 signals:
  void selectedChanged(int index);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* addButton(QAction* action, int at);
  void showCount(Screen* screen, QAction* action, QToolButton* button);
  void lay();

  QActionGroup* group_;
  QVBoxLayout* column_;
  std::vector<QToolButton*> buttons_;
  int screens_ = 0;
  QSize window_;
};

}  // namespace ostraka::ui
