#include "checks/agreement.h"

#include <gmock/gmock.h>

namespace ostraka::checks {
namespace {

using testing::HasSubstr;

TEST(Disagreement, IsToldOfASideWhosePhotographsConfirmLittleOfTheirMasks) {
  stereo::Agreement agreement{.shown = 1000, .matched = 900, .confirmed = 120};
  const std::optional<Message> front = disagreement(batch::Side::Front, agreement);
  ASSERT_TRUE(front.has_value());
  EXPECT_THAT(front->english(), HasSubstr("front side agree on only 12 %"));
  EXPECT_THAT(disagreement(batch::Side::Back, agreement)->english(), HasSubstr("back side"));
  agreement.confirmed = 800;
  EXPECT_FALSE(disagreement(batch::Side::Front, agreement).has_value());
}

}  // namespace
}  // namespace ostraka::checks
