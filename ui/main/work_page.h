#pragma once
#include <QString>
#include <QWidget>
#include <utility>
#include <vector>

class QStackedWidget;

namespace ostraka::ui {

class BatchQueue;
class CaptureScreen;
class FooterLine;
class HeaderLine;
class ProjectSession;
class QueueScreen;
class Screen;
class Sidebar;

/// What one sees while a project is open: sidebar, line at the head, the screens, line at the foot.
/// The lines follow what the screens and the queue tell.
class WorkPage final : public QWidget {
  Q_OBJECT

 public:
  /// The keys of the sidebar become those of the window that parent stands in.
  WorkPage(BatchQueue& queue, CaptureScreen& capture, QueueScreen& queue_screen, QWidget* parent);

  Sidebar* sidebar() const { return sidebar_; }
  HeaderLine* header() const { return header_; }
  FooterLine* footer() const { return footer_; }
  const std::vector<Screen*>& screens() const { return screens_; }
  int shown() const;                                ///< the screen in front
  QString shownName() const;                        ///< the icon name of that one
  int screenNamed(const QString& icon_name) const;  ///< -1: none
  int shownLast() const;  ///< the screen in front when the project was closed; else the first
  /// The screens and the pages in them that have keys of their own, by their titles.
  std::vector<std::pair<QString, const QWidget*>> partsWithKeys() const;

  void openProject(ProjectSession& session);
  void setTitle(const QString& title);  ///< of the project
  void closeProject();
  /// What is chosen in the screen in front goes along to this one.
  void bringChosen(int index);
  void showScreen(int index);
  /// Whoever waits before the queue for this batch is shown what came of it, unless masks are
  /// edited there. Empty: nobody waits.
  void await(const QString& batch) { awaited_ = batch; }
  void rest();  ///< it is hidden: no live picture
  void fit(const QSize& window);
  /// Shows what would be lost by closing, and says so, but only once: who closes again means it.
  bool saysWhatIsLost();
  /// So, too, of what is computed, before another project is chosen.
  bool saysWhatStops();

 public slots:
  void followLines();

 signals:
  void screenWanted(int index);
  void resultsWanted(const QString& icon_name, const QString& batch);

 private:
  struct Warning {
    int screen = 0;
    QString words;  ///< empty: none
  };

  void buildLayout();
  Warning loss() const;
  bool warn(const Warning& of);

  BatchQueue& queue_;
  CaptureScreen& capture_;
  QueueScreen& queue_screen_;
  std::vector<Screen*> screens_;
  ProjectSession* session_ = nullptr;
  QString title_;  ///< of the project
  Sidebar* sidebar_ = nullptr;
  HeaderLine* header_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  FooterLine* footer_ = nullptr;
  QString other_work_;  ///< than the queue's
  double other_fraction_ = -1;
  QString awaited_;      ///< a batch
  bool warned_ = false;  ///< of what closing would lose
};

/// All screens of the sidebar in their order, made with their view-models.
std::vector<Screen*> makeScreens(CaptureScreen* capture, QueueScreen* queue, QWidget* parent);

}  // namespace ostraka::ui
