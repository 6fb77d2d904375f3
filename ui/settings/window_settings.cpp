#include "ui/settings/window_settings.h"

#include <QSettings>
#include <QThread>

namespace ostraka::ui {
namespace {

// A QSettings cannot be copied: each use makes its own.
struct Store : QSettings {
  Store() : QSettings(IniFormat, UserScope, QStringLiteral("ostraka"), QStringLiteral("window")) {}
};

int inRange(int value, int least, int most, int otherwise) {
  return value < least || value > most ? otherwise : value;
}

// mine, with what another window changed: known is what both began from, stored what that wrote.
WindowSettings merged(const WindowSettings& known, const WindowSettings& mine,
                      const WindowSettings& stored) {
  WindowSettings both = mine;
  const auto take = [&](auto member) {
    if (mine.*member == known.*member) both.*member = stored.*member;
  };
  take(&WindowSettings::theme);
  take(&WindowSettings::text_percent);
  take(&WindowSettings::language);
  take(&WindowSettings::initials);
  take(&WindowSettings::threads);
  take(&WindowSettings::geometry);
  for (const QString& project : stored.recent) {
    if (mine.recent.contains(project) || known.recent.contains(project)) continue;
    both.recent.append(project);
    both.projects[project] = stored.projects.value(project);
  }
  while (both.recent.size() > kMostRecentProjects) both.projects.remove(both.recent.takeLast());
  return both;
}

}  // namespace

QLocale localeOf(const WindowSettings& settings) {
  return settings.language.isEmpty() ? QLocale::system() : QLocale(settings.language);
}

void WindowSettings::remember(const QString& folder, const RecentProject& project) {
  recent.removeAll(folder);
  recent.prepend(folder);
  projects[folder] = project;
  while (recent.size() > kMostRecentProjects) projects.remove(recent.takeLast());
}

void WindowSettings::forget(const QString& project) {
  recent.removeAll(project);
  projects.remove(project);
}

void WindowSettings::moved(const QString& from, const QString& to) {
  const qsizetype at = recent.indexOf(from);
  if (at < 0 || from == to) return;
  recent.removeAll(to);
  recent.replace(recent.indexOf(from), to);
  projects[to] = projects.take(from);
}

WindowSettings readSettings() {
  const Store kept;
  WindowSettings settings;
  settings.theme = themeFromName(kept.value(QStringLiteral("theme")).toString());
  settings.text_percent =
      inRange(kept.value(QStringLiteral("text_percent")).toInt(), 90, 200, settings.text_percent);
  settings.language = kept.value(QStringLiteral("language")).toString();
  settings.initials = kept.value(QStringLiteral("initials")).toString();
  settings.threads = inRange(kept.value(QStringLiteral("threads")).toInt(), 0,
                             QThread::idealThreadCount(), settings.threads);
  settings.recent = kept.value(QStringLiteral("recent")).toStringList();
  const QVariantMap titles = kept.value(QStringLiteral("titles")).toMap();
  const QVariantMap unfinished = kept.value(QStringLiteral("unfinished")).toMap();
  for (const QString& folder : settings.recent)
    if (titles.contains(folder))
      settings.projects[folder] = {titles[folder].toString(), unfinished[folder].toInt()};
  settings.geometry = kept.value(QStringLiteral("geometry")).toByteArray();
  return settings;
}

void writeSettings(const WindowSettings& settings) {
  Store kept;
  kept.setValue(QStringLiteral("theme"), themeName(settings.theme));
  kept.setValue(QStringLiteral("text_percent"), settings.text_percent);
  kept.setValue(QStringLiteral("language"), settings.language);
  kept.setValue(QStringLiteral("initials"), settings.initials);
  kept.setValue(QStringLiteral("threads"), settings.threads);
  kept.setValue(QStringLiteral("recent"), settings.recent);
  QVariantMap titles, unfinished;
  for (auto project = settings.projects.begin(); project != settings.projects.end(); ++project) {
    titles[project.key()] = project->title;
    unfinished[project.key()] = project->unfinished;
  }
  kept.setValue(QStringLiteral("titles"), titles);
  kept.setValue(QStringLiteral("unfinished"), unfinished);
  kept.setValue(QStringLiteral("geometry"), settings.geometry);
}

void OpenSettings::keep() {
  known_ = merged(known_, *this, readSettings());
  writeSettings(known_);
  *this = known_;
}

}  // namespace ostraka::ui
