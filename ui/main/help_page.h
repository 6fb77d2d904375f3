#pragma once
#include <QString>
#include <QWidget>
#include <utility>
#include <vector>

class QLabel;
class QLineEdit;
class QTextBrowser;

namespace ostraka::ui {

/// A paragraph, list item, cell or heading of the manual.
struct ManualLine {
  QString page, title;  ///< its file's name, and how the page is called
  QString heading;      ///< the last one above it, or itself; empty: none but the title
  QString text;
  int block;      ///< its number in the page
  double weight;  ///< how much a word that is searched for counts here
};

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

  std::vector<ManualLine> lines_;  ///< of the whole manual, once it was searched
  QTextBrowser* text_;
  QLineEdit* search_;
  QLabel* note_;  ///< above the manual: in which language it is
};

}  // namespace ostraka::ui
