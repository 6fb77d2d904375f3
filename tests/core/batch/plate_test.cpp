#include <gmock/gmock.h>

#include "batch/batch.h"
#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::HasSubstr;

constexpr const char* kMarker = R"({"id":3,"corners":[[0,1,0],[1,1,0],[1,0,0],[0,0,0]]})";

Result<Plate> plateOf(const std::string& text) {
  const BatchFolder folder;
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

TEST(MarkerSide, ThatAPersonTypesMakesTheSheetAsLarge) {
  auto plate = plateOf(
      R"({"dictionary":"D","sheet":[40,60],"typed_marker_mm":2,"markers":[
      {"id":3,"corners":[[0,2,0],[2,2,0],[2,0,0],[0,0,0]]},
      {"id":4,"corners":[[9,2.1,0],[11.1,2.1,0],[11.1,0,0],[9,0,0]]}]})");
  ASSERT_TRUE(plate.has_value()) << plate.error().sentence();
  EXPECT_EQ(plate->typed_marker_mm, 2);
  EXPECT_NEAR(*markerSide(*plate), 2.05, 1e-9) << "found in photographs they differ a little";
  const Plate larger = withMarkerSide(*plate, 3);
  EXPECT_EQ(larger.typed_marker_mm, 3);
  EXPECT_EQ(larger.markers[0].corners[1], Eigen::Vector3d(3, 3, 0));
  EXPECT_EQ(larger.sheet->sizes(), Eigen::Vector2d(60, 90));
  plate->markers[1].corners[0].y() = 9;
  EXPECT_FALSE(markerSide(*plate).has_value()) << "several sizes";
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

TEST(ReadPlate, RefusesMarkersThatNoPrinterMakes) {
  const std::pair<const char*, const char*> wrong[] = {
      {R"({"id":3,"corners":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]})", "is mirrored"},
      {R"({"id":3,"corners":[[0,-1,0],[1,-1,0],[1,0,0],[0,0,0]]})", "is mirrored"},
      {R"({"id":3,"corners":[[0,10,0],[10,10,0],[2,8,0],[0,0,0]]})", "is not convex"},
      {R"({"id":3,"corners":[[0,10,0],[10,0,0],[12,9,0],[0,1,0]]})", "is not convex"},
      {R"({"id":3.5,"corners":[[0,1,0],[1,1,0],[1,0,0],[0,0,0]]})",
       "'id' must be a whole number from 0 to 1000000"},
      {R"({"id":4294967299,"corners":[[0,1,0],[1,1,0],[1,0,0],[0,0,0]]})", "'id' must be a whole"},
      {R"({"id":3,"corners":[[0,1e9,0],[1,1,0],[1,0,0],[0,0,0]]})",
       "'corners' must be a number from -10000 to 10000"},
      {R"({"id":3,"id":4,"corners":[[0,1,0],[1,1,0],[1,0,0],[0,0,0]]})", "'id' twice"}};
  for (const auto& [marker, words] : wrong) {
    const auto plate = plateOf(plateText(marker));
    ASSERT_FALSE(plate.has_value()) << marker;
    EXPECT_THAT(plate.error().what, HasSubstr(words));
    EXPECT_THAT(plate.error().where, HasSubstr("plate.json"));
  }
}

TEST(ReadPlate, RefusesMarkersThatOverlapAndTakesThoseThatTouch) {
  const std::string first = R"({"id":1,"corners":[[0,10,0],[10,10,0],[10,0,0],[0,0,0]]},)";
  EXPECT_THAT(
      plateOf(plateText(first + R"({"id":2,"corners":[[9,15,0],[19,15,0],[19,5,0],[9,5,0]]})"))
          .error()
          .what,
      HasSubstr("markers 1 and 2 of the plate overlap"));
  EXPECT_TRUE(
      plateOf(plateText(first + R"({"id":2,"corners":[[10,10,0],[20,10,0],[20,0,0],[10,0,0]]})"))
          .has_value());
  // Turned by 45 degrees, with its bounds over the first one's corner, but beside it.
  EXPECT_TRUE(
      plateOf(plateText(first + R"({"id":2,"corners":[[8,16,0],[16,24,0],[24,16,0],[16,8,0]]})"))
          .has_value());
}

TEST(ReadBoard, RefusesNumbersThatNoBoardHas) {
  const BatchFolder folder;
  const std::pair<const char*, const char*> wrong[] = {
      {"4294967305", "'squares_x' must be a whole number from 2 to 100"},
      {"9.5", "'squares_x' must be a whole number from 2 to 100"},
      {"1", "'squares_x' must be a whole number from 2 to 100"},
      {R"(9,"squares_x":9)", "'squares_x' twice"}};
  for (const auto& [squares, words] : wrong) {
    folder.write("d.json", R"({"dictionary":"D","squares_x":)" + std::string(squares) +
                               R"(,"squares_y":7,"square_mm":22,"marker_mm":16})");
    const auto board = readBoard(folder.path() / "d.json");
    ASSERT_FALSE(board.has_value()) << squares;
    EXPECT_THAT(board.error().what, HasSubstr(words));
    EXPECT_THAT(board.error().where, HasSubstr("d.json"));
  }
}

TEST(ReadBoard, ReadsOurNamesAndThoseOfOthers) {
  const BatchFolder folder;
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
