#pragma once
#include <algorithm>
#include <cstddef>
#include <stop_token>

#include "base/parallel.h"

namespace ostraka::model {

/// The scratch of a body that needs none.
struct Nothing {};

/// body(i, scratch) for each i in [0, count), in blocks of which each has its own scratch; false
/// when stopped. See parallelFor for `threads`.
template <class Scratch, class Body>
bool inBlocks(std::size_t count, int threads, const std::stop_token& stop, const Body& body) {
  constexpr std::size_t kBlock = 512;
  parallelFor((count + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    if (stop.stop_requested()) return;
    Scratch scratch{};
    for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i)
      body(i, scratch);
  });
  return !stop.stop_requested();
}

}  // namespace ostraka::model
