#pragma once
#include <string_view>

namespace ostraka {

/// How each report in HTML begins: in what follows no script runs, and nothing is fetched from
/// elsewhere (W3C, Content Security Policy Level 3, section 3.3).
inline constexpr std::string_view kReportHead =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
    "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">";

/// Whether a page begins so and leads to no other by itself. A person's browser may then show it,
/// even if it came with somebody else's project.
bool isSafeReport(std::string_view page);

}  // namespace ostraka
