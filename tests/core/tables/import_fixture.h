#pragma once

#include "sherds/sherds.h"
#include "tables/import_table.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::tables {

/// A table of two sherds.
inline constexpr const char* kTwo =
    "number,site,trench,context,bag,part,weight_g,note\r\n"
    "ARM1-T3-0012-0001,ARM1,T3,0012,4,rim; neck,\"23,4\",\"'=1+1\"\r\n"
    "ARM1-T3-0013-0001,arm1,t3,0013,,body,,\r\n";

class Import : public catalogue::SmallProject {
 protected:
  ImportReport import(const std::string& text, ImportMode mode = ImportMode::Enter,
                      UnknownPlaces places = UnknownPlaces::Refuse,
                      const std::string& file = "t.csv") {
    const Result<ImportReport> report =
        importTable(catalogue(), text, file, {mode, places}, anna, quiet, {});
    EXPECT_TRUE(report) << (report ? "" : report.error().sentence());
    return report ? *report : ImportReport{};
  }
  std::string why(const std::string& text) {
    const ImportReport report = import(text);
    return report.refusals.empty()
               ? "accepted"
               : std::to_string(report.refusals[0].line) + " " + report.refusals[0].column + " " +
                     report.refusals[0].value + ": " + report.refusals[0].reason.english();
  }
  QuietProgress quiet;
};

}  // namespace ostraka::tables
