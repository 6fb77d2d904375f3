#include "paper/report_page.h"

#include <string>

#include "base/text.h"

namespace ostraka {

bool isSafeReport(std::string_view page) {
  if (!page.starts_with(kReportHead)) return false;
  const std::string rest = lowerCase(std::string(page.substr(kReportHead.size())));
  return rest.find("<meta") == std::string::npos;  // none that leads to another page
}

}  // namespace ostraka
