#pragma once
#include <QScreen>
#include <QStyle>
#include <QWidget>

namespace ostraka::ui {

/// What a window of its own may have of the wanted size: no more than its screen has room for below
/// its title bar.
inline QSize fittedToScreen(const QWidget& window, const QSize& wanted) {
  const int title = 2 * window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
  return wanted.boundedTo(window.screen()->availableSize() - QSize(0, title));
}

}  // namespace ostraka::ui
