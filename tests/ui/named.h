#pragma once
#include <QWidget>
#include <QtTest>

/// What the tests of pages and windows share.
namespace ostraka::ui {

template <class T>
T* named(const QWidget& window, const char* name) {
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
