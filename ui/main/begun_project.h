#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <cstdint>

namespace ostraka::ui {

class CaptureScreen;
class JobRunner;
class MainWindow;
class ProjectSession;
class StartScreen;

/// A project that the window makes for photographs which somebody dropped on the start screen. When
/// their import is cancelled and nobody worked in it, it is removed again.
class BegunProject final : public QObject {
  Q_OBJECT

 public:
  /// A child of the window; the screens are the window's.
  BegunProject(MainWindow& window, StartScreen& start, CaptureScreen& capture, JobRunner& runner);

  /// Makes a project and proposes these photographs to be imported; what holds none makes none. A
  /// project's folder is opened.
  void beginWith(const QStringList& photographs);

 signals:
  void removed(const QString& folder);

 private:
  void make(const QStringList& photographs);
  void leave();

  MainWindow& window_;
  StartScreen& start_;
  CaptureScreen& capture_;
  JobRunner& runner_;
  QPointer<ProjectSession> session_;  ///< null: it is closed, or none was made
  std::int64_t history_ = 0;          ///< its length when the project was made
};

}  // namespace ostraka::ui
