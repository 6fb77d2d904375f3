#include "archive/distinct_paths.h"

#include <gtest/gtest.h>

namespace ostraka::archive {
namespace {

TEST(DistinctPaths, RefusesNamesThatAreOneOnOtherSystems) {
  DistinctPaths paths;
  EXPECT_TRUE(paths.add("data/Batches/a.jpg"));
  EXPECT_TRUE(paths.add("data/Batches/b.jpg"));
  EXPECT_TRUE(paths.add("data/straße"));
  EXPECT_TRUE(paths.add("data/\xC3\xA9"));
  for (const char* twin : {"data/Batches/a.jpg", "data/Batches/A.jpg", "data/batches/c.jpg",
                           "data/STRASSE", "data/e\xCC\x81", "DATA/x"})
    EXPECT_FALSE(paths.add(twin)) << twin;
}

}  // namespace
}  // namespace ostraka::archive
