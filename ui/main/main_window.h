#pragma once
#include <QMainWindow>
#include <QString>
#include <memory>
#include <vector>

#include "ui/settings/window_settings.h"

class QStackedWidget;
class QUndoGroup;

namespace ostraka::upkeep {
class Project;
}

namespace ostraka::ui {

class BatchQueue;
class CaptureScreen;
class CaptureWizard;
class FileWatch;
class FooterLine;
class HeaderLine;
class HelpPage;
class JobRunner;
class ProjectCare;
class ProjectLock;
class ProjectSession;
class QueueScreen;
class PageArea;
class Sidebar;
class SettingsPage;
class StartScreen;
class Screen;
class Thumbnails;

/// Sidebar, line at the head, screens, line at the foot. It puts the screens together and passes on
/// what they tell each other; what happens stands in them and in their view-models.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(JobRunner& runner, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Shows the project of this folder or catalogue file, or says on the start screen why it cannot.
  void openProject(const QString& path);
  void closeProject();
  /// Closes it, but says first what would be lost: who closes once more means it.
  void leaveProject();
  ProjectSession* session() const { return session_.get(); }
  BatchQueue* queue() const { return queue_; }
  CaptureWizard* wizard() const { return wizard_; }
  const std::vector<Screen*>& screens() const { return screens_; }

 public slots:
  void showScreen(int index);
  void showScreenNamed(const QString& icon_name, const QString& what);
  void showSettings();
  void showManual();
  void showShortcuts();
  void leaveSidePage();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool saysWhatIsLost();
  void fitToSize();
  void buildScreens();
  void buildLayout();
  bool lockProject(const QString& folder);
  void takeProject(std::shared_ptr<upkeep::Project> project);
  void showProject(std::shared_ptr<upkeep::Project> project);
  int screenNamed(const QString& icon_name) const;
  void tryVirtualRig();
  void applySettings(const WindowSettings& settings);
  void followLines();
  void findProject(const QString& lost, const QString& found);

  JobRunner& runner_;
  WindowSettings settings_;
  std::unique_ptr<ProjectSession> session_;
  std::unique_ptr<ProjectLock> lock_;
  std::unique_ptr<ProjectLock> leaving_lock_;  ///< of a project whose computation is ending
  QUndoGroup* undo_;
  BatchQueue* queue_;
  CaptureWizard* wizard_;
  QueueScreen* queue_screen_ = nullptr;
  CaptureScreen* capture_screen_ = nullptr;
  std::vector<Screen*> screens_;
  Thumbnails* thumbnails_;
  QStackedWidget *all_ = nullptr, *pages_ = nullptr;
  PageArea *start_area_ = nullptr, *settings_area_ = nullptr;
  StartScreen* start_ = nullptr;
  QString other_work_;  ///< than the queue's
  double other_fraction_ = -1;
  QString title_;        ///< of the project
  bool warned_ = false;  ///< of what closing would lose
  SettingsPage* settings_page_ = nullptr;
  HelpPage* help_ = nullptr;
  Sidebar* sidebar_ = nullptr;
  HeaderLine* header_ = nullptr;
  FooterLine* footer_ = nullptr;
  ProjectCare* care_;
  FileWatch* file_watch_;
};

/// All screens of the sidebar in their order, made with their view-models.
std::vector<Screen*> makeScreens(CaptureScreen* capture, QueueScreen* queue, QWidget* parent);

}  // namespace ostraka::ui
