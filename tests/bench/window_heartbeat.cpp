// window_heartbeat BATCH PROJECT [SECONDS]: makes a new project with this batch of photographs in
// its queue (or adds the batch to a project that is there, so that review, masks, map and catalogue
// have contents), opens the window with it and measures, while both processors compute, how late
// the window's events come: a timer of 5 ms, and an act every 200 ms until it was handled: the next
// screen, the next pair, the next sherd, the settings, the masks and a stroke of their brush.
// Prints the time to a usable window, which is painted, the delays' median, 99 % and maximum in ms,
// and how many were above 50 ms. Beside it how late a bare thread wakes that sleeps for 5 ms, which
// is what the machine takes; what the window's own thread computed during its latest beats; and the
// single events that kept it for longer than 10 ms of processor time, which are the window's own
// stalls.
#include <sys/resource.h>

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "catalogue/batches.h"
#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"
#include "ui/queue/batch_queue.h"
#include "ui/viewport/sherd_view.h"
#include "upkeep/project.h"

namespace {

constexpr int kBeat_ms = 5, kKeyEvery_ms = 200;
constexpr double kStall_ms = 10, kPart_ms = 3;

double ownTime_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Part {
  double passed_ms, own_ms;
  long waited, preempted;  // how often for something, and by another thread
  std::string what;
};

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
    rusage from{}, to{};
    getrusage(RUSAGE_THREAD, &from);
    QElapsedTimer wall;
    wall.start();
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    const double took = ownTime_ms() - before;
    if (took > kStall_ms) stalls.emplace_back(took, what.toStdString());
    const double passed = 1e-6 * static_cast<double>(wall.nsecsElapsed());
    getrusage(RUSAGE_THREAD, &to);
    if (passed > kPart_ms)
      parts.push_back({passed, took, to.ru_nvcsw - from.ru_nvcsw, to.ru_nivcsw - from.ru_nivcsw,
                       what.toStdString() + " " + act});
    act.clear();
    painted = painted || event->type() == QEvent::Expose;
    return taken;
  }
  bool counting = false, painted = false;
  std::string act;  // of a person, in the present event
  std::vector<std::pair<double, std::string>> stalls;
  std::vector<Part> parts;  // since the last beat

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

ostraka::Result<ostraka::upkeep::Project> projectIn(const std::filesystem::path& folder) {
  using namespace ostraka;
  if (upkeep::Project::isProject(folder)) return upkeep::Project::open(folder);
  records::ProjectRecord record;
  record.code = "BENCH";
  record.title = "Bench";
  return upkeep::Project::create(folder, record);
}

// A project with one batch more in its queue.
bool makeProject(const std::filesystem::path& batch, const std::filesystem::path& folder) {
  using namespace ostraka;
  auto project = projectIn(folder);
  if (!project) {
    std::fprintf(stderr, "%s\n", project.error().sentence().english().c_str());
    return false;
  }
  records::BatchRecord queued;
  queued.state = records::BatchState::Queued;
  const auto row = catalogue::Batches(project->catalogue()).add(queued, {});
  if (!row) return false;
  const std::string number = catalogue::Batches(project->catalogue()).get(*row)->number;
  std::filesystem::copy(batch, project->batchFolder(number),
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove_all(project->batchFolder(number) / "truth");
  return true;
}

void press(QWidget* receiver, int key) {
  if (receiver == nullptr) return;
  for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
    QKeyEvent event(type, key, Qt::NoModifier);
    QApplication::sendEvent(receiver, &event);
  }
}

// What a person does with the mouse: across the middle of the photograph.
void stroke(QWidget* view) {
  if (view == nullptr || !view->isVisible()) return;
  const QPointF from = view->rect().center();
  const auto send = [&](QEvent::Type type, double share, Qt::MouseButtons held) {
    const QPointF at = from + QPointF(40 * share, 15 * share);
    const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, view->mapToGlobal(at), button, held, Qt::NoModifier);
    QApplication::sendEvent(view, &event);
  };
  send(QEvent::MouseButtonPress, 0, Qt::LeftButton);
  for (int i = 1; i <= 10; ++i) send(QEvent::MouseMove, 0.1 * i, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, 1, Qt::NoButton);
}

void trigger(QWidget& window, const char* name) {
  if (auto* action = window.findChild<QAction*>(name); action != nullptr && action->isEnabled())
    action->trigger();
}

// Each is one act of a person; the screens one after the other, again and again.
std::vector<std::pair<const char*, std::function<void()>>> actsOn(ostraka::ui::MainWindow& window) {
  const auto child = [&window](const char* name) { return window.findChild<QWidget*>(name); };
  std::vector<std::pair<const char*, std::function<void()>>> acts;
  static constexpr const char* kScreens[] = {"capture", "queue",     "review",
                                             "map",     "catalogue", "export"};
  for (int i = 0; i < 6; ++i) {
    acts.emplace_back(kScreens[i], [&window, i] { window.showScreen(i); });
    if (i == 1) {
      acts.emplace_back("the batch below", [child] { press(child("queueList"), Qt::Key_Down); });
      acts.emplace_back("masks", [&window] { trigger(window, "queueMasks"); });
      acts.emplace_back("(masks come)", [] {});
      for (int k = 0; k < 3; ++k)
        acts.emplace_back("a stroke", [child] { stroke(child("maskView")); });
      acts.emplace_back("undo", [&window] { trigger(window, "undo"); });
      acts.emplace_back("next photograph", [&window] { trigger(window, "masksNext"); });
    }
    if (i == 2)
      for (int k = 0; k < 3; ++k)
        acts.emplace_back("next pair", [&window] { trigger(window, "next"); });
    if (i == 4)
      for (int k = 0; k < 3; ++k)
        acts.emplace_back("next sherd", [child] { press(child("sherds"), Qt::Key_Down); });
  }
  acts.emplace_back("settings", [&window] { window.showSettings(); });
  return acts;
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
  struct Late {
    double at_ms, by_ms;
    std::vector<Part> parts;  // the events in it
  };
  std::vector<Late> late;
  QTimer beat;
  beat.setTimerType(Qt::PreciseTimer);
  QObject::connect(&beat, &QTimer::timeout, &window, [&] {
    beats.push_back(std::max(0.0, static_cast<double>(last.nsecsElapsed()) / 1e6 - kBeat_ms));
    if (beats.back() > 50)
      late.push_back(
          {static_cast<double>(since_start.nsecsElapsed()) / 1e6, beats.back(), application.parts});
    application.parts.clear();
    last.restart();
    const double now = ownTime_ms();
    own.push_back(now - computed);
    computed = now;
  });
  // Before the window is painted and hears what is done there is nothing to freeze.
  QTimer first;
  QObject::connect(&first, &QTimer::timeout, &window, [&] {
    if (!application.painted) return;
    first.stop();
    std::printf("usable after %.0f ms\n", static_cast<double>(since_start.nsecsElapsed()) / 1e6);
    application.parts.clear();
    computed = ownTime_ms();
    last.start();
    beat.start(kBeat_ms);
  });
  first.start(0);
  QTimer key;
  std::size_t pressed = 0;
  const auto acts = actsOn(window);
  std::map<std::string, std::vector<double>> by_act;
  QObject::connect(&key, &QTimer::timeout, &window, [&] {
    const auto& [name, act] = acts[pressed++ % acts.size()];
    QElapsedTimer handled;
    handled.start();
    application.act = name;
    const double before = ownTime_ms();
    act();
    window.repaint();
    keys.push_back(static_cast<double>(handled.nsecsElapsed()) / 1e6);
    by_act[name].push_back(ownTime_ms() - before);
  });
  key.start(kKeyEvery_ms);
  const int seconds = argc > 3 ? std::atoi(argv[3]) : 120;
  // Not quit(), which closes the project first: that is none of the acts.
  QTimer::singleShot(seconds * 1000, &application, [] { QApplication::exit(); });
  QTimer idle;
  QObject::connect(&idle, &QTimer::timeout, &window, [&] {
    if (window.queue()->waitingToCompute() == 0) QApplication::exit();
  });
  idle.start(1000);
  const int status = QApplication::exec();
  over = true;
  sleeper.join();
  print("beats", beats);
  for (const Late& beat_late : late) {
    std::printf("  %.1f ms late, %.1f s after the start\n", beat_late.by_ms,
                beat_late.at_ms / 1000);
    for (const Part& part : beat_late.parts)
      std::printf("    %6.1f ms, own %6.1f, waited %ld times, preempted %ld  %s\n", part.passed_ms,
                  part.own_ms, part.waited, part.preempted, part.what.c_str());
  }
  print("a bare thread beside it", bare);
  print("computed by the window's thread between two beats", own);
  print("acts, each handled and painted", keys);
  for (const auto& [name, own_ms] : by_act)
    print(("  " + name + ", computed by the window's thread").c_str(), own_ms);
  std::sort(application.stalls.rbegin(), application.stalls.rend());
  std::printf("events of more than %.0f ms of the window's own: %zu\n", kStall_ms,
              application.stalls.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(20, application.stalls.size()); ++i)
    std::printf("  %6.1f ms  %s\n", application.stalls[i].first,
                application.stalls[i].second.c_str());
  return status;
}
