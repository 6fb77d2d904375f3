#include "upkeep/value_check.h"

#include "base/limits.h"
#include "sherds/measurements.h"
#include "store/database.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

class ValueCheck : public catalogue::SmallProject {
 protected:
  ValueCheck() {
    const store::SherdRow sherd = numbered(context12);
    EXPECT_TRUE(set(sherd, "weight_g", "23.4"));
    EXPECT_TRUE(set(sherd, "note", "Գառնի"));
  }
  Result<void> after(const std::string& change) {
    catalogue().database().script(change);
    return checkValues(catalogue());
  }
};

TEST_F(ValueCheck, LetsPassWhatThisProgramWrites) {
  EXPECT_TRUE(checkValues(catalogue()));
}

TEST_F(ValueCheck, NamesTheNumberThatIsNotFinite) {
  const Result<void> refused = after("UPDATE sherd_measure SET weight = 9e999");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(refused.error().where, "sherd_measure.weight, row 1");
  EXPECT_EQ(refused.error().what, "'inf' is not a number; write 12.5 or 12,5, without a unit.");
}

TEST_F(ValueCheck, NamesTheTextThatIsNotUtf8) {
  const Result<void> refused = after("UPDATE site SET name = CAST(x'ff00fe' AS TEXT)");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(refused.error().where, "site.name, row 1");
}

// A file that was imported may have any name on this system; the history remembers it.
TEST_F(ValueCheck, LeavesTheHistoryAsItWasWritten) {
  EXPECT_TRUE(
      after("INSERT INTO history (at, table_name, row, field, old, new, why, source) VALUES (1, "
            "'sherd', 1, 'note', '', '', '', CAST(x'ff' AS TEXT))"));
}

TEST_F(ValueCheck, NamesTheTextThatIsLongerThanAnyTyped) {
  const Result<void> refused = after("UPDATE site SET name = printf('%.*c', " +
                                     std::to_string(limits::kValueBytes.most + 1) + ", 'x')");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what, "The text is longer than 1 MB.");
  EXPECT_EQ(refused.error().where, "site.name, row 1");
}

}  // namespace
}  // namespace ostraka::upkeep
