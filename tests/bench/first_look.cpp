// first_look [MS]: what the first look at the view in three dimensions takes the window's thread,
// when somebody wants it MS milliseconds after the window was shown (0: before the view could make
// itself ready), and what the same look takes the second time: processor time, so that other
// programs on the machine say nothing, and the clock.
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QStackedWidget>
#include <QTimer>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "ui/viewport/sherd_view.h"

namespace {

using ostraka::ui::ShownScan;

double ownTime_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// A face of a sherd as the review shows it: 20,000 points.
ShownScan disc(float z, float up) {
  ShownScan scan;
  for (float x = -20; x <= 20; x += 0.25f)
    for (float y = -20; y <= 20; y += 0.25f) {
      const float r = std::hypot(x, y);
      if (r > 20) continue;
      scan.cloud.points.emplace_back(x, y, z);
      scan.cloud.normals.emplace_back(0.0f, 0.0f, up);
      scan.cloud.colors.push_back({150, 150, 150});
      scan.fracture.push_back(r > 15 ? 1 : 0);
    }
  return scan;
}

void look(QStackedWidget& window, const char* what) {
  window.setCurrentIndex(0);
  window.repaint();
  QElapsedTimer clock;
  clock.start();
  const double before = ownTime_ms();
  window.setCurrentIndex(1);
  window.repaint();
  std::printf("%s: %.1f ms of the window's thread, %.1f ms on the clock\n", what,
              ownTime_ms() - before, static_cast<double>(clock.nsecsElapsed()) / 1e6);
}

}  // namespace

int main(int argc, char** argv) {
  ostraka::ui::prepareOpenGl();
  QApplication application(argc, argv);
  const int after_ms = argc > 1 ? std::atoi(argv[1]) : 0;
  QStackedWidget window;
  window.resize(1280, 760);
  ostraka::ui::reserveOpenGl(window);
  window.addWidget(new QLabel("another screen", &window));
  auto* view = new ostraka::ui::SherdView(&window);
  window.addWidget(view);
  view->showScans(disc(5, 1), disc(0, -1), Eigen::Isometry3d::Identity());
  window.show();
  constexpr int kShown_ms = 400;
  QTimer::singleShot(kShown_ms + after_ms, &window, [&] { look(window, "the first look"); });
  QTimer::singleShot(kShown_ms + after_ms + 600, &window, [&] { look(window, "the second"); });
  QTimer::singleShot(kShown_ms + after_ms + 1500, &application, &QApplication::quit);
  return QApplication::exec();
}
