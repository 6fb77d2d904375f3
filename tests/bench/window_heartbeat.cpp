// window_heartbeat BATCH PROJECT [SECONDS]: makes a new project with this batch of photographs in
// its queue, opens the window with it and measures, while both processors compute, how late the
// window's events come: a timer of 5 ms, and a key press every 200 ms until it was handled. Prints
// the time to a usable window, the delays' median, 99 % and maximum in ms, and how many were above
// 50 ms. Beside it how late a bare thread wakes that sleeps for 5 ms, which is what the machine
// takes; what the window's own thread computed during its latest beats; and the single events that
// kept it for longer than 10 ms of processor time, which are the window's own stalls.
#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "catalogue/project.h"
#include "ui/frame/look.h"
#include "ui/jobs/job.h"
#include "ui/main/main_window.h"
#include "ui/queue/batch_queue.h"
#include "ui/viewport/sherd_view.h"

namespace {

constexpr int kBeat_ms = 5, kKeyEvery_ms = 200;
constexpr double kStall_ms = 10;

double ownTime_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// What each event of the window's thread computed, outermost events only.
class Timed final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    if (depth_ > 0 || !counting) return QApplication::notify(receiver, event);
    const QString what =
        QStringLiteral("%1 '%2', event %3")
            .arg(QString::fromLatin1(receiver->metaObject()->className()), receiver->objectName())
            .arg(event->type());
    ++depth_;
    const double before = ownTime_ms();
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    const double took = ownTime_ms() - before;
    if (took > kStall_ms) stalls.emplace_back(took, what.toStdString());
    return taken;
  }
  bool counting = false;
  std::vector<std::pair<double, std::string>> stalls;

 private:
  int depth_ = 0;
};

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
  Timed application(argc, argv);
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

  std::vector<double> beats, keys, own, bare;
  std::atomic<bool> over = false;
  std::thread sleeper([&] {
    while (!over) {
      const auto before = std::chrono::steady_clock::now();
      std::this_thread::sleep_for(std::chrono::milliseconds(kBeat_ms));
      const std::chrono::duration<double, std::milli> slept =
          std::chrono::steady_clock::now() - before;
      bare.push_back(slept.count() - kBeat_ms);
    }
  });
  double computed = ownTime_ms();
  application.counting = true;
  QElapsedTimer last;
  last.start();
  QTimer beat;
  beat.setTimerType(Qt::PreciseTimer);
  QObject::connect(&beat, &QTimer::timeout, &window, [&] {
    beats.push_back(std::max(0.0, static_cast<double>(last.nsecsElapsed()) / 1e6 - kBeat_ms));
    last.restart();
    const double now = ownTime_ms();
    own.push_back(now - computed);
    computed = now;
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
  over = true;
  sleeper.join();
  print("beats", beats);
  print("a bare thread beside it", bare);
  print("computed by the window's thread between two beats", own);
  print("switching stations and painting", keys);
  std::sort(application.stalls.rbegin(), application.stalls.rend());
  std::printf("events of more than %.0f ms of the window's own: %zu\n", kStall_ms,
              application.stalls.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(20, application.stalls.size()); ++i)
    std::printf("  %6.1f ms  %s\n", application.stalls[i].first,
                application.stalls[i].second.c_str());
  return status;
}
