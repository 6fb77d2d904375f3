#pragma once
#include <QMainWindow>
#include <QString>
#include <memory>
#include <optional>
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
class HelpPage;
class JobRunner;
class OpenProject;
class ProjectCare;
class ProjectSession;
class QueueScreen;
class PageArea;
class SettingsPage;
class StartScreen;
class Screen;
class Thumbnails;
class WorkPage;

/// The start screen, the page of an open project, the settings and the manual. It puts the screens
/// together and passes on what they tell each other; what happens stands in them and in their
/// view-models.
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
  /// The project to open in the next window, empty without one, where this one was closed for a
  /// restart; else nothing.
  const std::optional<QString>& restarted() const { return restarted_; }
  ProjectSession* session() const;
  BatchQueue* queue() const { return queue_; }
  CaptureWizard* wizard() const { return wizard_; }
  const std::vector<Screen*>& screens() const;

 public slots:
  void showScreen(int index);
  void showScreenNamed(const QString& icon_name, const QString& what);
  void showSettings();
  void showManual();
  void showShortcuts();
  void leaveSidePage();
  void restart();  ///< closes the window as a person does

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildLayout();
  void connectParts();
  void takeProject(std::shared_ptr<upkeep::Project> project);
  void showProject();
  void showTitle();
  void tryVirtualRig();
  void applySettings(const WindowSettings& settings);
  void findProject(const QString& lost, const QString& found);

  JobRunner& runner_;
  OpenSettings settings_;
  QUndoGroup* undo_;
  BatchQueue* queue_;
  CaptureWizard* wizard_;
  OpenProject* project_;
  QueueScreen* queue_screen_ = nullptr;
  CaptureScreen* capture_screen_ = nullptr;
  Thumbnails* thumbnails_;
  QStackedWidget* all_ = nullptr;
  WorkPage* work_ = nullptr;
  PageArea *start_area_ = nullptr, *settings_area_ = nullptr;
  StartScreen* start_ = nullptr;
  SettingsPage* settings_page_ = nullptr;
  HelpPage* help_ = nullptr;
  ProjectCare* care_;
  std::optional<QString> restarted_ = {};
};

}  // namespace ostraka::ui
