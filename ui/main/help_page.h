#pragma once
#include <QWidget>
#include <utility>
#include <vector>

class QLabel;
class QLineEdit;
class QTextBrowser;

namespace ostraka::ui {

/// The manual with a search, the sheet of shortcuts and 'about', as pages of the window; all
/// offline.
class HelpPage final : public QWidget {
  Q_OBJECT

 public:
  explicit HelpPage(QWidget* parent = nullptr);
  void showManual(const QString& page);
  /// Every action with a shortcut below each of these widgets, by its title.
  void showShortcuts(const std::vector<std::pair<QString, const QWidget*>>& screens);
  void showAbout();

 signals:
  void closed();
  void shortcutsWanted();

 private:
  void showFound();
  void showHit(const QUrl& page);

  QTextBrowser* text_;
  QLineEdit* search_;
  QLabel* note_;  ///< above the manual: in which language it is
};

}  // namespace ostraka::ui
