#include "paper/report_page.h"

#include <gtest/gtest.h>

#include <string>

namespace ostraka {
namespace {

TEST(ReportPage, IsSafeOnlyIfItsPolicyStandsBeforeAllElseAndItLeadsNowhere) {
  const std::string head(kReportHead);
  EXPECT_TRUE(isSafeReport(head + "<title>B0001</title><h1>Batch</h1></html>\n"));
  EXPECT_TRUE(isSafeReport(head + "<script>alert(1)</script>")) << "the policy stops it";
  for (const std::string& page :
       {std::string(), std::string("<!doctype html><html><script>alert(1)</script>"),
        "<script>alert(1)</script>" + head, head.substr(0, head.size() - 2) + " script-src *\">",
        head + "<META http-equiv=\"refresh\" content=\"0;url=evil.html\">"})
    EXPECT_FALSE(isSafeReport(page)) << page;
}

}  // namespace
}  // namespace ostraka
