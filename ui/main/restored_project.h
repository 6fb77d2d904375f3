#pragma once
#include <QObject>
#include <QString>
#include <QStringList>

#include "base/result.h"

namespace ostraka::ui {

class JobRunner;
class MainWindow;
class StartScreen;

/// A project that is restored from an archive chosen on the start screen, which shows how far that
/// is. It is opened when it is whole and nobody opened another meanwhile; with what it was archived
/// damaged, and why it could not be restored, stand on the start screen.
class RestoredProject final : public QObject {
  Q_OBJECT

 public:
  /// A child of the window; the screen is the window's.
  RestoredProject(MainWindow& window, StartScreen& start, JobRunner& runner);

 signals:
  void said(const QString& words);  ///< to whoever works in another project by now

 private:
  void take(const QString& folder, const QStringList& damage);
  void tellFailure(const Error& error);

  MainWindow& window_;
  StartScreen& start_;
};

}  // namespace ostraka::ui
