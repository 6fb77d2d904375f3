#include "tables/ods.h"

#include <gtest/gtest.h>

namespace ostraka::tables {
namespace {

TEST(Ods, BeginsWithItsTypeSoThatAnyProgramKnowsIt) {
  const Result<std::string> ods = formatOds({OdsSheet("one", {{"a"}})});
  ASSERT_TRUE(ods);
  EXPECT_EQ(ods->substr(30, 54), "mimetypeapplication/vnd.oasis.opendocument.spreadsheet");
}

TEST(Ods, KeepsBlanksLinesAndSigns) {
  OdsSheet sheet("a & b", {{"text"}, {"number", true}});
  sheet.row({"x   <y>\tz\r\n007", "-1.5"});
  sheet.row({"", ""});
  const Result<std::string> ods = formatOds({sheet});
  ASSERT_TRUE(ods);
  const auto holds = [&](const std::string& part) { return ods->find(part) != std::string::npos; };
  EXPECT_TRUE(holds("table:name=\"a &amp; b\""));
  EXPECT_TRUE(
      holds("<text:p>x <text:s text:c=\"2\"/>&lt;y&gt;<text:tab/>z</text:p>"
            "<text:p>007</text:p>"));
  EXPECT_TRUE(holds("office:value=\"-1.5\""));
  EXPECT_TRUE(holds("<table:table-row><table:table-cell/><table:table-cell/></table:table-row>"))
      << "an empty number is no zero";
}

TEST(Ods, HoldsNothingThatXmlForbids) {
  OdsSheet sheet("a\uFFFF", {{"b\x01"}});
  sheet.row({"c\uFFFE d\v"});
  const Result<std::string> ods = formatOds({sheet});
  ASSERT_TRUE(ods);
  for (const char* part : {"table:name=\"a \"", "<text:p>b </text:p>", "<text:p>c  d </text:p>"})
    EXPECT_NE(ods->find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace ostraka::tables
