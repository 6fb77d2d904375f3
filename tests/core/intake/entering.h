#pragma once

#include "catalogue/batches.h"
#include "intake/enter_results.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/result_folder.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {

class Entering : public catalogue::SmallProject {
 protected:
  Entering() : batch(newBatch({bag4})), out(project_->resultsFolder("B0001"), 3) {}
  EnteredResults enter() {
    const Result<EnteredResults> entered = enterResults(
        catalogue(), project_->folder(), batch, project_->resultsFolder("B0001"), {}, quiet, {});
    EXPECT_TRUE(entered) << (entered ? "" : entered.error().sentence());
    return entered ? *entered : EnteredResults{};
  }
  std::vector<records::SherdRecord> sherds() {
    return *sherds::Sherds(catalogue()).of(*sherds::Sherds(catalogue()).rows(batch));
  }
  int count(const std::string& table) {
    int rows = 0;
    store::Statement all = catalogue().database().sql("SELECT count(*) FROM " + table);
    all.read(rows);
    return rows;
  }
  store::ScanRow scanNamed(const std::string& name) {
    for (const records::ScanRecord& scan :
         catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
      if (scan.name == name) return scan.row;
    return {};
  }
  store::BatchRow batch;
  catalogue::ResultFolder out;
  QuietProgress quiet;
};

}  // namespace ostraka::intake
