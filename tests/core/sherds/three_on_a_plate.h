#pragma once
#include <string>
#include <vector>

#include "catalogue/batches.h"
#include "cloud/ply.h"
#include "intake/enter_results.h"
#include "sherds/sherds.h"
#include "sherds/typed_numbers.h"
#include "tests/core/catalogue/result_folder.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {

/// Three sherds 50 mm apart on a plate; the results come when entered.
class ThreeOnAPlate : public catalogue::SmallProject {
 protected:
  ThreeOnAPlate() : batch(newBatch({bag4})) {}
  void results(bool doubtful = false) {
    catalogue::ResultFolder out(project_->resultsFolder("B0001"), 3);
    out.pairs()[0].ambiguous = out.pairs()[1].ambiguous = doubtful;
    out.write();
    for (const int i : {1, 2, 3}) {
      PointCloud cloud;
      const auto x = static_cast<float>(50 * i);
      cloud.points = {{x - 2, 10, 0}, {x + 2, 10, 0}};
      EXPECT_TRUE(writePly(project_->resultsFolder("B0001") / "work/scans_front" /
                               ("f00" + std::to_string(i) + ".ply"),
                           cloud, "plate_front"));
    }
  }
  intake::EnteredResults enter() {
    QuietProgress quiet;
    const auto entered = intake::enterResults(catalogue(), project_->folder(), batch,
                                              project_->resultsFolder("B0001"), {}, quiet, {});
    EXPECT_TRUE(entered) << (entered ? "" : entered.error().sentence());
    return entered ? *entered : intake::EnteredResults{};
  }
  std::string numberOf(const std::string& front) {
    for (const records::ScanRecord& scan :
         catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
      if (scan.name == front)
        for (const records::SherdRecord& sherd : catalogue::valueIn(
                 Sherds(catalogue()).of(catalogue::valueIn(Sherds(catalogue()).rows(batch)))))
          if (sherd.front == scan.row) return sherd.number;
    return "no sherd";
  }
  Result<void> type(const std::vector<TypedNumber>& numbers) {
    return setTypedNumbers(catalogue(), batch, numbers);
  }
  store::BatchRow batch;
};

}  // namespace ostraka::sherds
