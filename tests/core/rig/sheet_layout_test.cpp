// Sheets of others' making, proposed from photographs and compared with what was printed.
#include "rig/sheet_layout.h"

#include <gmock/gmock.h>

#include <cmath>

#include "batch/photographs.h"

namespace ostraka::rig {
namespace {

namespace fs = std::filesystem;

struct Compared {
  std::size_t markers = 0;
  double shape = 0;  ///< RMS of the corners after the best turn, shift and scale, of the diagonal
  double scale = 0;  ///< proposed over printed
};

Compared compare(const batch::Plate& found, const batch::Plate& printed) {
  std::vector<Eigen::Vector3d> a, b;
  Compared result;
  for (const batch::Marker& of : printed.markers)
    for (const batch::Marker& marker : found.markers)
      if (marker.id == of.id) {
        ++result.markers;
        for (std::size_t c = 0; c < 4; ++c) {
          a.push_back(of.corners[c]);
          b.push_back(marker.corners[c]);
        }
      }
  Eigen::Matrix3Xd from(3, a.size()), to(3, b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    from.col(static_cast<Eigen::Index>(i)) = a[i];
    to.col(static_cast<Eigen::Index>(i)) = b[i];
  }
  const Eigen::Matrix4d fit = Eigen::umeyama(from, to, true);
  result.scale = fit.block<3, 1>(0, 0).norm();
  const Eigen::Matrix3Xd left =
      ((fit.topLeftCorner<3, 3>() * from).colwise() + fit.topRightCorner<3, 1>()) - to;
  const Eigen::Vector3d size = from.rowwise().maxCoeff() - from.rowwise().minCoeff();
  result.shape =
      std::sqrt(left.squaredNorm() / static_cast<double>(a.size())) / (size.norm() * result.scale);
  return result;
}

Result<SheetLayout> propose(const fs::path& folder, double marker_mm) {
  SheetLayoutOptions options;
  options.marker_mm = marker_mm;
  QuietProgress quiet;
  return proposeSheet(batch::photographsIn(folder), options, quiet, {});
}

TEST(SheetLayout, OfATelephonesPhotographsIsTheSheetThatWasPrinted) {
  const auto sheet = propose(OSTRAKA_SHARED_DIR "/batches/hand/front", 20);
  ASSERT_TRUE(sheet.has_value()) << sheet.error().sentence();
  EXPECT_EQ(sheet->plate.dictionary, "DICT_5X5_50");  // of 32 markers; its codes are DICT_5X5_100's
  const auto printed = batch::readPlate(OSTRAKA_SHARED_DIR "/batches/hand/plate.json");
  const Compared compared = compare(sheet->plate, *printed);
  RecordProperty("shape", std::to_string(compared.shape));
  RecordProperty("scale", std::to_string(compared.scale));
  std::printf("hand: rms %.3f px, shape %.5f, scale %.5f\n", sheet->rms_px, compared.shape,
              compared.scale);
  EXPECT_EQ(compared.markers, 32U);
  EXPECT_LT(compared.shape, 0.003);
  EXPECT_NEAR(compared.scale, 1, 0.005);
}

// The sheet was not flat, and the telephone moved its lens.
TEST(SheetLayout, OfASheetThatWasNotFlatIsRightInShape) {
  const auto sheet = propose(OSTRAKA_SHARED_DIR "/real/apple/photographs", 33);
  ASSERT_TRUE(sheet.has_value()) << sheet.error().sentence();
  EXPECT_EQ(sheet->plate.dictionary, "DICT_7X7_50");
  const auto printed = batch::readPlate(OSTRAKA_SHARED_DIR "/real/apple/markers.json");
  const Compared compared = compare(sheet->plate, *printed);
  std::printf("apple: rms %.3f px, shape %.5f, scale %.5f\n", sheet->rms_px, compared.shape,
              compared.scale);
  EXPECT_GE(compared.markers, 34U);  // of 35: things lie on the sheet
  EXPECT_LT(compared.shape, 0.003);
}

TEST(SheetLayout, IsNotProposedWhereThereAreNoMarkers) {
  const auto sheet = propose(OSTRAKA_SHARED_DIR "/real/statue", 20);
  ASSERT_FALSE(sheet.has_value());
  EXPECT_EQ(sheet.error().code, ErrorCode::NotEnough);
  EXPECT_FALSE(propose(OSTRAKA_SHARED_DIR "/real/statue", -1).has_value());
}

}  // namespace
}  // namespace ostraka::rig
