#include <gtest/gtest.h>

#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

TEST_F(Import, RefusesTextsThatNoDocumentCanHoldByRowAndColumn) {
  const std::string reason =
      ": The text contains control characters, which documents cannot contain; type it again.";
  EXPECT_EQ(why("number,site,trench,context,note\nX-1,ARM1,T3,0012,a\x01\n"),
            "2 note a\x01" + reason);
  EXPECT_EQ(why("number,site,trench,context,note\nX-1,ARM1,T3,0012,x\uFFFEy\n"),
            "2 note x\uFFFEy" + reason);
  EXPECT_EQ(why("site,trench,context,note,bedding\nARM1,T3,0012,a,b\x1F\n"),
            "2 bedding b\x1F" + reason);
}

}  // namespace
}  // namespace ostraka::tables
