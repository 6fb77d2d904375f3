#include <gmock/gmock.h>

#include <filesystem>
#include <limits>

#include "pipeline/process_batch.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;

class CheckedOptions : public testing::Test {
 protected:
  CheckedOptions() {
    fs::create_directories(folder_.path() / "batch" / "front");
    options_.batch = folder_.path() / "batch";
    options_.output = folder_.path() / "out";
  }
  std::string wrong() const {
    const Result<void> checked = options_.check();
    if (checked) return "";
    EXPECT_EQ(checked.error().code, ErrorCode::UnusableInput);
    return checked.error().what.english();
  }
  TemporaryFolder folder_;
  ProcessOptions options_;
};

TEST_F(CheckedOptions, NeedABatchAndAnOutput) {
  EXPECT_EQ(wrong(), "");
  options_.output.clear();
  EXPECT_THAT(wrong(), testing::HasSubstr("--output"));
  options_.batch.clear();
  EXPECT_THAT(wrong(), testing::HasSubstr("No batch folder"));
}

// Nothing in a batch is ever written, however its folder is named.
TEST_F(CheckedOptions, RefuseAnOutputInsideTheBatch) {
  for (const char* inside :
       {"batch", "batch/out", "batch/front/../out", "batch/./", "other/../batch/x"}) {
    options_.output = folder_.path() / inside;
    EXPECT_THAT(wrong(), testing::HasSubstr("inside the batch folder")) << inside;
  }
  options_.output = folder_.path() / "batch-out";
  EXPECT_EQ(wrong(), "") << "its name begins alike";
  fs::create_directories(folder_.path() / "backs");
  options_.back = folder_.path() / "backs";
  options_.output = folder_.path() / "backs" / "out";
  EXPECT_THAT(wrong(), testing::HasSubstr("inside the batch folder"));
}

TEST_F(CheckedOptions, RefuseSizesAndMasksThatCannotBe) {
  for (const double megapixels : {0.0, 0.29, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options_.megapixels = megapixels;
    EXPECT_THAT(wrong(), testing::HasSubstr("0.3 megapixels")) << megapixels;
  }
  options_.megapixels = 0.3;
  EXPECT_EQ(wrong(), "");
  options_.masks = "given";
  EXPECT_EQ(wrong(), "");
  options_.masks = (folder_.path() / "none.onnx").string();
  EXPECT_THAT(wrong(), testing::HasSubstr("no such segmentation network"));
}

TEST(ProcessSummary, IsWholeWhereEachSherdHasItsModelAndNothingIsLeft) {
  ProcessSummary summary;
  EXPECT_FALSE(summary.whole()) << "no sherd is no success";
  summary.sherds.resize(2);
  summary.sherds[0].has_model = true;
  summary.sherds[1].ambiguous = true;
  EXPECT_FALSE(summary.whole());
  EXPECT_EQ(summary.ambiguous(), 1);
  summary.sherds[1].has_model = true;
  EXPECT_TRUE(summary.whole());
  summary.set_aside = {"f003"};
  EXPECT_TRUE(summary.whole()) << "a person took it out";
  for (const auto list : {&ProcessSummary::unpaired_front, &ProcessSummary::unpaired_back,
                          &ProcessSummary::reshoot, &ProcessSummary::moved}) {
    ProcessSummary left = summary;
    (left.*list).push_back("f001");
    EXPECT_FALSE(left.whole());
  }
}

}  // namespace
}  // namespace ostraka::pipeline
