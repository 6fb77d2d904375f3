#pragma once
#include <QByteArray>
#include <QLocale>
#include <QMap>
#include <QString>
#include <QStringList>

#include "ui/look/look.h"

namespace ostraka::ui {

/// What is told of a project that is not open.
struct RecentProject {
  QString title;
  int unfinished = 0;  ///< batches that were not done when it was last open

  bool operator==(const RecentProject&) const = default;
};

/// What the program remembers about a person and a computer, not about a project.
struct WindowSettings {
  Theme theme = Theme::System;
  int text_percent = 100;  ///< 90..200
  QString language;        ///< "de"; empty: as the desktop
  QString initials;        ///< who decides and edits: goes into the history of each change
  int threads = 0;         ///< that a computation may use; 0: all
  QStringList recent;      ///< folders of projects, the last one first
  QMap<QString, RecentProject> projects;  ///< of those, by folder
  QByteArray geometry;                    ///< of the window

  void remember(const QString& folder, const RecentProject& project);
  void forget(const QString& project);
  void moved(const QString& from, const QString& to);  ///< a project's folder
};

inline constexpr int kMostRecentProjects = 8;

/// What numbers and texts of the window follow.
QLocale localeOf(const WindowSettings& settings);

/// The one place that reads and writes them; values out of range become the default.
WindowSettings readSettings();
void writeSettings(const WindowSettings& settings);

/// Those of a window beside which others may be open.
class OpenSettings final : public WindowSettings {
 public:
  OpenSettings() : WindowSettings(readSettings()), known_(*this) {}
  using WindowSettings::operator=;

  /// Writes them, and takes what another window changed meanwhile. What both changed is as here;
  /// both windows' projects are recent.
  void keep();

 private:
  WindowSettings known_;  ///< as last read or written
};

}  // namespace ostraka::ui
