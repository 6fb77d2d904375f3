#include "ui/main/window_place.h"

#include <QByteArray>
#include <QGuiApplication>
#include <QScreen>
#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace ostraka::ui {
namespace {

constexpr int kFrame = 4;  // pixels that a desktop draws around a window, about
constexpr QSize kUsual(1280, 760);

}  // namespace

void placeWindow(QWidget& window, const QByteArray& geometry) {
  const bool restored = window.restoreGeometry(geometry);
  const Qt::WindowStates state = window.windowState();
  const QRect was = window.normalGeometry();
  window.setWindowState(Qt::WindowNoState);  // else it would be lost when it is maximised no longer
  const QScreen* screen = QGuiApplication::screenAt(was.center());
  if (screen == nullptr) screen = window.screen();
  const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
  const QRect room = screen->availableGeometry().adjusted(kFrame, kFrame + title, -kFrame, -kFrame);
  const QSize size = (restored ? was.size() : kUsual).boundedTo(room.size());
  const QPoint corner(std::clamp(was.left(), room.left(), room.right() + 1 - size.width()),
                      std::clamp(was.top(), room.top(), room.bottom() + 1 - size.height()));
  if (restored)
    window.setGeometry({corner, size});
  else
    window.resize(size);  // the desktop says where
  window.setWindowState(state);
}

}  // namespace ostraka::ui
