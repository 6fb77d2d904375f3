#include "base/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ostraka {
namespace {

TEST(Memory, PeakGrowsWithWhatWasTouched) {
  const double before = peakMemoryMb();
  EXPECT_GT(before, 1);
  const std::vector<char> many(std::size_t{256} << 20, 'x');  // each page written
  EXPECT_GE(peakMemoryMb(), std::max(before, 256.0)) << many[many.size() / 2];
  EXPECT_GT(freeMemoryMb(), 1);
}

}  // namespace
}  // namespace ostraka
