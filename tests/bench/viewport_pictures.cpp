// viewport_pictures OUTPUT FOLDER: pictures of the view in three dimensions, for looking at: a pair
// of a processed batch (OUTPUT) from above and below, sparse, near, cut, with the distances along
// its fracture, and its closed model whole and cut, in a light and in a dark theme. Under a
// display.
#include <QApplication>
#include <QDir>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cstdio>

#include "cloud/ply.h"
#include "review/live_pairs.h"
#include "ui/look/look.h"
#include "ui/viewport/gl_canvas.h"
#include "ui/viewport/sherd_view.h"

namespace {

using namespace ostraka;
using namespace ostraka::ui;

struct Studio {
  SherdView view;
  QString folder;

  void take(const QString& name) {
    QTest::qWait(400);
    view.grab().save(folder + "/" + name + ".png");
    std::printf("%s\n", qPrintable(name));
  }
  void drag(const QPoint& by) {
    QWidget* canvas = view.findChild<GlCanvas*>();
    const QPoint middle = canvas->rect().center();
    QTest::mousePress(canvas, Qt::LeftButton, {}, middle);
    const QPoint to = middle + by;
    QMouseEvent move(QEvent::MouseMove, to, canvas->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     {});
    QCoreApplication::sendEvent(canvas, &move);
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, to);
  }
  void zoom(int notches) {
    QWidget* canvas = view.findChild<GlCanvas*>();
    const QPointF middle = canvas->rect().center();
    QWheelEvent wheel(middle, canvas->mapToGlobal(middle), {}, {0, 120 * notches}, {}, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(canvas, &wheel);
  }
};

ShownScan shown(const review::ScanCloud& scan) {
  return {scan.cloud, scan.fracture, scan.strip_point};
}

}  // namespace

int main(int argc, char** argv) {
  prepareOpenGl();
  QApplication application(argc, argv);
  if (argc < 3) return std::fputs("viewport_pictures OUTPUT FOLDER\n", stderr), 2;
  const auto live = review::LivePairs::open(argv[1]);
  if (!live) return std::fprintf(stderr, "%s\n", live.error().what.english().c_str()), 1;
  const auto& candidates = (*live)->table().candidates;
  if (candidates.empty()) return std::fputs("no pair\n", stderr), 1;
  const auto best =
      std::max_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return a.registration.fracture_overlap < b.registration.fracture_overlap;
      });
  const int front_scan = best->evidence.front, back_scan = best->evidence.back;
  const Eigen::Isometry3d pose = best->registration.front_from_back;
  const auto scan = [&](batch::Side side, int index, std::size_t most) {
    return shown((*live)->cloud(side, index, most).value());
  };
  const ShownScan front = scan(batch::Side::Front, front_scan, 60000);
  const ShownScan back = scan(batch::Side::Back, back_scan, 60000);
  const ShownScan sparse_front = scan(batch::Side::Front, front_scan, 1500);
  const ShownScan sparse_back = scan(batch::Side::Back, back_scan, 1500);
  const Result<review::PairView> pair = (*live)->view(front_scan, back_scan, pose);
  if (!pair) return std::fprintf(stderr, "%s\n", pair.error().what.english().c_str()), 1;
  const ShownDistances distances{pair->fracture.front_mm, pair->fracture.back_mm};
  Studio studio;
  studio.folder = QString::fromLocal8Bit(argv[2]);
  QDir().mkpath(studio.folder);
  SherdView& view = studio.view;
  view.resize(900, 640);
  view.show();
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    applyLook(application, theme, 100);
    const QString in = "_" + themeName(theme);
    view.showScans(front, back, pose);
    studio.take("scans" + in);
    view.setDistances(distances);
    studio.take("distances" + in);
    if (theme == Theme::Dark) break;
    view.setDistances({});
    studio.drag({0, -300});
    studio.take("scans_below");
    view.resetView();
    studio.zoom(8);
    studio.take("scans_near");
    view.resetView();
    view.setSection(true);
    studio.take("scans_section");
    studio.drag({60, 60});
    studio.take("scans_section_oblique");
    view.showScans(sparse_front, sparse_back, pose);
    studio.take("sparse");
    view.setSection(true);
    studio.take("sparse_section");
  }
  for (int number = 1; number < 100; ++number) {
    char name[16];
    std::snprintf(name, sizeof name, "%02d", number);
    const auto model = readPly(std::filesystem::path(argv[1]) / "sherds" / name / "model.ply");
    if (!model) continue;
    view.showModel(model->mesh);
    studio.take("model_dark");
    applyLook(application, Theme::Light, 100);
    studio.take("model_light");
    studio.drag({0, -300});
    studio.take("model_below");
    view.resetView();
    view.setSection(true);
    studio.take("model_section");
    studio.drag({60, 60});
    studio.take("model_section_oblique");
    break;
  }
  return 0;
}
