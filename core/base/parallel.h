#pragma once
#include <cstddef>
#include <functional>

namespace ostraka {

/// Number of processors that this process may use, at least 1.
int availableThreads();

/// Calls body(i) once for each i in [0, count) on up to `threads` threads (the caller's included);
/// threads <= 0 means availableThreads(), and fewer where the system gives no more. A body writes
/// to its own index only, so the result does not depend on the number of threads. The first
/// exception is rethrown once all threads have ended.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The same in tasks of this many consecutive indices: body(begin, end).
void parallelForRanges(std::size_t count, std::size_t at_once, int threads,
                       const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace ostraka
