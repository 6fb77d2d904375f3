#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QThreadPool>
#include <cstdint>
#include <map>
#include <mutex>

#include "ui/jobs/job.h"

namespace ostraka::ui {
namespace {

// Linux knows a niceness per thread, and threads inherit it: all that a computing job starts gives
// way to the window. 15 leaves it a thirtieth of a processor that others want.
void giveWay() {
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), 15);
}

}  // namespace

struct ThreadedJobRunner::Pools {
  std::mutex lock;
  std::map<std::uint64_t, std::stop_source> unfinished;
  std::uint64_t next = 0;
  QThreadPool quick, background;  // last: their ends wait for the threads, which use the others
};

ThreadedJobRunner::ThreadedJobRunner() : pools_(std::make_unique<Pools>()) {
  pools_->quick.setMaxThreadCount(2);
  pools_->background.setMaxThreadCount(2);
}

ThreadedJobRunner::~ThreadedJobRunner() {
  const std::lock_guard guard(pools_->lock);
  for (auto& [number, stop] : pools_->unfinished) stop.request_stop();
}

void ThreadedJobRunner::run(JobPriority priority, std::function<void()> body, std::stop_source stop,
                            JobHandle*) {
  Pools* pools = pools_.get();
  std::uint64_t number = 0;
  {
    const std::lock_guard guard(pools->lock);
    number = pools->next++;
    pools->unfinished.emplace(number, std::move(stop));
  }
  const bool background = priority == JobPriority::Background;
  (background ? pools->background : pools->quick)
      .start([pools, number, background, body = std::move(body)] {
        if (background) giveWay();
        body();
        const std::lock_guard guard(pools->lock);
        pools->unfinished.erase(number);
      });
}

}  // namespace ostraka::ui
