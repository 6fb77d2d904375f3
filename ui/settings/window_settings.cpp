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
    both.titles[project] = stored.titles.value(project);
  }
  while (both.recent.size() > kMostRecentProjects) both.titles.remove(both.recent.takeLast());
  return both;
}

}  // namespace

QLocale localeOf(const WindowSettings& settings) {
  return settings.language.isEmpty() ? QLocale::system() : QLocale(settings.language);
}

void WindowSettings::remember(const QString& project, const QString& title) {
  recent.removeAll(project);
  recent.prepend(project);
  titles[project] = title;
  while (recent.size() > kMostRecentProjects) titles.remove(recent.takeLast());
}

void WindowSettings::forget(const QString& project) {
  recent.removeAll(project);
  titles.remove(project);
}

void WindowSettings::moved(const QString& from, const QString& to) {
  const qsizetype at = recent.indexOf(from);
  if (at < 0 || from == to) return;
  recent.removeAll(to);
  recent.replace(recent.indexOf(from), to);
  titles[to] = titles.take(from);
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
  for (const QString& project : settings.recent)
    if (titles.contains(project)) settings.titles[project] = titles[project].toString();
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
  QVariantMap titles;
  for (auto title = settings.titles.begin(); title != settings.titles.end(); ++title)
    titles[title.key()] = title.value();
  kept.setValue(QStringLiteral("titles"), titles);
  kept.setValue(QStringLiteral("geometry"), settings.geometry);
}

void OpenSettings::keep() {
  known_ = merged(known_, *this, readSettings());
  writeSettings(known_);
  *this = known_;
}

}  // namespace ostraka::ui
