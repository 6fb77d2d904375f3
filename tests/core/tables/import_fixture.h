#pragma once

#include "sherds/sherds.h"
#include "tables/import_table.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::tables {

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
