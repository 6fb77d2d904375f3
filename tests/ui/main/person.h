#pragma once
#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "../named.h"

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

}  // namespace ostraka::ui
