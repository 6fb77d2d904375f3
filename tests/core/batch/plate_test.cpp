#include <gmock/gmock.h>

#include "batch/batch.h"
#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::HasSubstr;

constexpr const char* kMarker = R"({"id":3,"corners":[[0,1,0],[1,1,0],[1,0,0],[0,0,0]]})";

Result<Plate> plateOf(const std::string& text) {
  const TemporaryFolder folder("plates");
  folder.write("plate.json", text);
  return readPlate(folder.path() / "plate.json");
}

std::string plateText(const std::string& markers) {
  return R"({"unit":"mm","dictionary":"DICT_4X4_100","diameter":330,"markers":[)" + markers + "]}";
}

TEST(ReadPlate, ReadsMarkersWithTheirCorners) {
  const auto plate = plateOf(plateText(kMarker));
  ASSERT_TRUE(plate.has_value()) << plate.error().sentence();
  EXPECT_EQ(plate->dictionary, "DICT_4X4_100");
  EXPECT_EQ(plate->diameter_mm, 330);
  EXPECT_EQ(plate->markers[0].id, 3);
  EXPECT_EQ(plate->markers[0].corners[1], Eigen::Vector3d(1, 1, 0));
}

TEST(ReadPlate, WithoutADiameterReachesToTheFarthestMarker) {
  const auto plate = plateOf(R"({"unit":"mm","dictionary":"DICT_4X4_100","markers":[
      {"id":3,"corners":[[0,1,0],[1,1,0],[1,0,0],[0,0,0]]},
      {"id":4,"corners":[[29,40,0],[30,40,0],[30,39,0],[29,39,0]]}]})");
  ASSERT_TRUE(plate.has_value()) << plate.error().sentence();
  EXPECT_DOUBLE_EQ(plate->diameter_mm, 100);  // 30, 40, 50
}

TEST(ReadPlate, RefusesADiameterThatIsNone) {
  for (const char* diameter : {"0", "-5", "1e9", "\"wide\""})
    EXPECT_THAT(plateOf(R"({"dictionary":"D","diameter":)" + std::string(diameter) +
                        R"(,"markers":[)" + kMarker + "]}")
                    .error()
                    .what,
                HasSubstr("diameter"))
        << diameter;
}

TEST(ReadPlate, RefusesWhatIsNoPlate) {
  EXPECT_FALSE(plateOf("[]").has_value());
  EXPECT_FALSE(plateOf("{}").has_value());
  EXPECT_FALSE(plateOf(R"({"dictionary":3,"markers":[]})").has_value());
  EXPECT_THAT(plateOf(plateText("")).error().what, HasSubstr("no marker"));
  EXPECT_THAT(plateOf(plateText(std::string(kMarker) + "," + kMarker)).error().what,
              HasSubstr("twice"));
  EXPECT_THAT(
      plateOf(plateText(R"({"id":3,"corners":[[0,0,0],[1,0,0],[2,0,0],[3,0,0]]})")).error().what,
      HasSubstr("no valid corners"));
  EXPECT_THAT(plateOf(R"({"unit":"inch","dictionary":"x","markers":[]})").error().what,
              HasSubstr("mm"));
}

TEST(ReadBoard, ReadsOurNamesAndThoseOfOthers) {
  const TemporaryFolder folder("boards");
  folder.write("a.json",
               R"({"dictionary":"D","squares_x":9,"squares_y":7,"square_mm":22,"marker_mm":16})");
  folder.write(
      "b.json",
      R"({"dictionary":"D","squares_x":9,"squares_y":7,"square_length":20,"marker_length":10})");
  folder.write("c.json",
               R"({"dictionary":"D","squares_x":9,"squares_y":7,"square_mm":22,"marker_mm":23})");
  EXPECT_EQ(readBoard(folder.path() / "a.json")->square_mm, 22);
  EXPECT_EQ(readBoard(folder.path() / "b.json")->marker_mm, 10);
  EXPECT_FALSE(readBoard(folder.path() / "c.json").has_value());
}

}  // namespace
}  // namespace ostraka::batch
