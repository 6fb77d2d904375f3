#include "api/version.h"

#include <gmock/gmock.h>

namespace ostraka::api {
namespace {

// The first two numbers are the library's soname.
TEST(Version, HasThreeNumbers) {
  EXPECT_THAT(version(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
}

}  // namespace
}  // namespace ostraka::api
