#include "base/parallel.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace ostraka {

int availableThreads() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
  return std::max(1u, std::thread::hardware_concurrency());
}

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  if (threads <= 0) threads = availableThreads();
  std::atomic<std::size_t> next{0};
  std::exception_ptr first;
  std::mutex first_guard;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(first_guard);
        if (!first) first = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::jthread> helpers;
  const std::size_t wanted = std::min<std::size_t>(count, static_cast<std::size_t>(threads));
  try {
    for (std::size_t t = 1; t < wanted; ++t) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do all, with the same result.
  }
  work();
  helpers.clear();
  if (first) std::rethrow_exception(first);
}

void parallelForRanges(std::size_t count, std::size_t at_once, int threads,
                       const std::function<void(std::size_t, std::size_t)>& body) {
  parallelFor((count + at_once - 1) / at_once, threads, [&](std::size_t task) {
    body(task * at_once, std::min(count, (task + 1) * at_once));
  });
}

}  // namespace ostraka
