// window_heartbeat BATCH PROJECT [SECONDS]: makes a new project with this batch of photographs in
// its queue, opens the window with it and measures, while both processors compute, how late the
// window's events come: a timer of 5 ms, and a key press every 200 ms until it was handled. Prints
// the time to a usable window, the delays' median, 99 % and maximum in ms, and how many were above
// 50 ms.
#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "catalogue/project.h"
#include "ui/frame/look.h"
#include "ui/jobs/job.h"
#include "ui/main/main_window.h"
#include "ui/queue/batch_queue.h"
#include "ui/viewport/sherd_view.h"

namespace {

constexpr int kBeat_ms = 5, kKeyEvery_ms = 200;

void print(const char* what, std::vector<double> delays) {
  if (delays.empty()) return;
  std::sort(delays.begin(), delays.end());
  const auto at = [&](double share) {
    return delays[static_cast<std::size_t>(share * static_cast<double>(delays.size() - 1))];
  };
  const auto late = std::count_if(delays.begin(), delays.end(), [](double d) { return d > 50; });
  std::printf("%s: %zu, median %.1f ms, 99 %% %.1f ms, max %.1f ms, above 50 ms: %ld\n", what,
              delays.size(), at(0.5), at(0.99), delays.back(), static_cast<long>(late));
}

// A project with one batch in its queue.
bool makeProject(const std::filesystem::path& batch, const std::filesystem::path& folder) {
  using namespace ostraka;
  catalogue::ProjectRecord record;
  record.code = "BENCH";
  record.title = "Bench";
  auto project = catalogue::Project::create(folder, record);
  if (!project) {
    std::fprintf(stderr, "%s\n", project.error().sentence().c_str());
    return false;
  }
  catalogue::BatchRecord queued;
  queued.state = catalogue::BatchState::Queued;
  const auto row = project->catalogue().addBatch(queued, {});
  if (!row) return false;
  const std::string number = project->catalogue().batch(*row)->number;
  std::filesystem::copy(batch, project->batchFolder(number),
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove_all(project->batchFolder(number) / "truth");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  QElapsedTimer since_start;
  since_start.start();
  ostraka::ui::prepareOpenGl();
  QApplication application(argc, argv);
  if (argc < 3) {
    std::fputs("window_heartbeat BATCH PROJECT [SECONDS]\n", stderr);
    return 2;
  }
  if (!makeProject(argv[1], argv[2])) return 2;
  since_start.restart();
  ostraka::ui::applyLook(application, ostraka::ui::Theme::Light, 100);
  ostraka::ui::ThreadedJobRunner jobs;
  ostraka::ui::MainWindow window(jobs);
  window.show();
  window.openProject(QString::fromLocal8Bit(argv[2]));
  QTimer::singleShot(0, &window, [&] {
    std::printf("usable after %.0f ms\n", static_cast<double>(since_start.nsecsElapsed()) / 1e6);
  });

  std::vector<double> beats, keys;
  QElapsedTimer last;
  last.start();
  QTimer beat;
  beat.setTimerType(Qt::PreciseTimer);
  QObject::connect(&beat, &QTimer::timeout, &window, [&] {
    beats.push_back(std::max(0.0, static_cast<double>(last.nsecsElapsed()) / 1e6 - kBeat_ms));
    last.restart();
  });
  beat.start(kBeat_ms);
  QTimer key;
  int pressed = 0;
  QObject::connect(&key, &QTimer::timeout, &window, [&] {
    QElapsedTimer handled;
    handled.start();
    const int station = pressed++ % static_cast<int>(window.stations().size());
    window.showStation(station);
    window.repaint();
    keys.push_back(static_cast<double>(handled.nsecsElapsed()) / 1e6);
  });
  key.start(kKeyEvery_ms);
  const int seconds = argc > 3 ? std::atoi(argv[3]) : 120;
  QTimer::singleShot(seconds * 1000, &application, &QApplication::quit);
  QTimer idle;
  QObject::connect(&idle, &QTimer::timeout, &window, [&] {
    if (window.queue()->waitingToCompute() == 0) QApplication::quit();
  });
  idle.start(1000);
  const int status = QApplication::exec();
  print("beats", beats);
  print("switching stations and painting", keys);
  return status;
}
