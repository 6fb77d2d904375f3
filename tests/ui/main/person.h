#pragma once
#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

/// What the tests of the window share: a person's home of its own, and looking for things by name.
namespace ostraka::ui {

/// Settings and projects of a test go into a folder of their own. Make it before the window.
class Home {
 public:
  Home() {
    qputenv("XDG_CONFIG_HOME", folder_.filePath("config").toUtf8());
    qputenv("HOME", folder_.path().toUtf8());
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.filePath("config"));
  }
  QString path(const QString& name) const { return folder_.filePath(name); }

 private:
  QTemporaryDir folder_;
};

template <class T>
T* named(QWidget& window, const char* name) {
  T* found = window.findChild<T*>(QString::fromLatin1(name));
  if (found == nullptr) qFatal("there is no %s", name);
  return found;
}

inline void activate(QWidget& window) {
  window.show();
  window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&window));
}

}  // namespace ostraka::ui
