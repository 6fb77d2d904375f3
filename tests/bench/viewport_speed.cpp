// viewport_speed: how fast the view in three dimensions turns half
// a million points and half a million triangles: frames a second while the mouse turns them, and
// what a frame takes at rest, by the clock and in processor time of the whole process (a driver
// that draws in software has threads of its own). Without a screen:
//   xvfb-run -s '-screen 0 1400x900x24' viewport_speed
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "ui/viewport/gl_canvas.h"
#include "ui/viewport/sherd_view.h"

namespace {

using namespace ostraka;
using namespace ostraka::ui;

constexpr int kFrames = 40;

double process_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// A sherd-like shell: part of a vessel's wall, rough to a hundredth of a millimetre.
Eigen::Vector3f wall(float u, float v, float radius) {
  const float a = 0.6f * u, rough = 0.02f * std::sin(97 * u) * std::cos(89 * v);
  return {(radius + rough) * std::sin(a), 30 * v, (radius + rough) * std::cos(a) - radius};
}

PointCloud cloudOf(int points, float radius) {
  PointCloud cloud;
  const int side = static_cast<int>(std::sqrt(points));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float u = 2.0f * static_cast<float>(x) / static_cast<float>(side) - 1;
      const float v = 2.0f * static_cast<float>(y) / static_cast<float>(side) - 1;
      cloud.points.push_back(wall(u, v, radius));
      cloud.normals.emplace_back(std::sin(0.6f * u), 0.0f, std::cos(0.6f * u));
      const auto shade = static_cast<std::uint8_t>(130 + 40 * std::sin(13 * u + 7 * v));
      cloud.colors.push_back({shade, static_cast<std::uint8_t>(shade * 3 / 4), 90});
    }
  return cloud;
}

TriangleMesh meshOf(int triangles) {
  const PointCloud cloud = cloudOf(triangles / 2, 50);
  TriangleMesh mesh;
  mesh.vertices = cloud.points;
  mesh.normals = cloud.normals;
  mesh.colors = cloud.colors;
  const int side = static_cast<int>(std::sqrt(cloud.size()));
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const int i = y * side + x;
      mesh.triangles.push_back({i, i + 1, i + side + 1});
      mesh.triangles.push_back({i, i + side + 1, i + side});
    }
  return mesh;
}

struct Bench {
  SherdView view;
  GlCanvas* canvas = nullptr;
  int drawn = 0;

  bool start() {
    view.resize(1280, 760);
    view.show();
    canvas = view.findChild<GlCanvas*>();
    if (canvas == nullptr || !QTest::qWaitForWindowExposed(&view)) return false;
    QObject::connect(canvas, &GlCanvas::rendered, &view, [this] { ++drawn; });
    QTest::qWait(1200);
    return true;
  }
  // Until it was drawn and nothing else is to be drawn.
  void settle() {
    for (int before = -1; before != drawn;) {
      before = drawn;
      QTest::qWait(400);
    }
  }
  void mouse(QEvent::Type type, const QPointF& at) {
    const bool move = type == QEvent::MouseMove;
    QMouseEvent event(type, at, canvas->mapToGlobal(at), move ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QCoreApplication::sendEvent(canvas, &event);
  }
  void drawOnce() {
    const int before = drawn;
    QElapsedTimer limit;
    limit.start();
    while (drawn == before && limit.elapsed() < 5000) QCoreApplication::processEvents();
  }
  void measure(const char* what) {
    settle();
    const QPointF middle = canvas->rect().center();
    mouse(QEvent::MouseButtonPress, middle);
    mouse(QEvent::MouseMove, middle + QPointF(2, 0));
    drawOnce();  // what is made for the first picture of the turn does not count
    const int before = drawn;
    const double cpu = process_ms();
    QElapsedTimer clock;
    clock.start();
    for (int i = 1; i <= kFrames; ++i) {
      mouse(QEvent::MouseMove, middle + QPointF(2 + 3 * i, 0.6 * i));
      drawOnce();
    }
    const double turning_s = 1e-9 * static_cast<double>(clock.nsecsElapsed());
    const double cpu_ms = (process_ms() - cpu) / kFrames;
    const int frames = drawn - before;
    mouse(QEvent::MouseButtonRelease, middle + QPointF(2 + 3 * kFrames, 0.6 * kFrames));
    settle();
    const double cpu_rest = process_ms();
    clock.restart();
    canvas->update();
    drawOnce();
    const double rest_ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    const double cpu_rest_ms = process_ms() - cpu_rest;
    settle();
    const int still = drawn;
    const double cpu_idle = process_ms();
    QTest::qWait(1000);
    std::printf(
        "%-34s %5.1f frames/s turning (%.0f ms of processor, %d pictures for %d turns), "
        "%.0f ms at rest (%.0f of processor), idle: %d frames, %.0f ms in 1 s\n",
        what, kFrames / turning_s, cpu_ms, frames, kFrames, rest_ms, cpu_rest_ms, drawn - still,
        process_ms() - cpu_idle);
    std::fflush(stdout);
  }
};

ShownScan scanOf(PointCloud cloud) {
  ShownScan scan;
  scan.cloud = std::move(cloud);
  for (const Eigen::Vector3f& p : scan.cloud.points)
    scan.fracture.push_back(std::abs(p.y()) > 28 ? 1 : 0);
  return scan;
}

}  // namespace

int main(int argc, char** argv) {
  prepareOpenGl();
  QApplication application(argc, argv);
  Bench bench;
  if (!bench.start()) return std::fputs("no OpenGL 3.2 on this screen\n", stderr), 1;
  bench.canvas->makeCurrent();
  std::printf("driver: %s\n", reinterpret_cast<const char*>(
                                  bench.canvas->context()->functions()->glGetString(GL_RENDERER)));
  bench.canvas->doneCurrent();
  const auto show = [&](const char* what, auto&& load) {
    QElapsedTimer clock;
    clock.start();
    load();
    const double load_ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    bench.drawOnce();
    std::printf("%-34s %.0f ms to load, %.0f ms to the first picture\n", what, load_ms,
                1e-6 * static_cast<double>(clock.nsecsElapsed()));
    bench.measure(what);
  };
  show("500,000 points in two scans", [&] {
    bench.view.showScans(scanOf(cloudOf(250000, 50)), scanOf(cloudOf(250000, 44)),
                         Eigen::Isometry3d::Identity());
  });
  show("500,000 triangles", [&] { bench.view.showModel(meshOf(500000)); });
  return 0;
}
