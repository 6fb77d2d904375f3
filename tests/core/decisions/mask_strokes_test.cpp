#include "decisions/mask_strokes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "base/limits.h"
#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;

MaskStroke dot(MaskPaint paint, double x, double y, double radius) {
  MaskStroke stroke;
  stroke.side = batch::Side::Back;
  stroke.camera = 2;
  stroke.stop = 5;
  stroke.paint = paint;
  stroke.radius_px = radius;
  stroke.path_px = {{x, y}};
  stroke.by = "AP";
  stroke.at = "2026-07-14T09:30:12Z";
  return stroke;
}

class MaskStrokes : public testing::Test {
 protected:
  TemporaryFolder temporary_;
  fs::path out = temporary_.path();
};

TEST_F(MaskStrokes, AreReadBackAsTheyWerePainted) {
  ASSERT_TRUE(readMaskStrokes(out).has_value());
  EXPECT_TRUE(readMaskStrokes(out)->empty());
  MaskStroke line = dot(MaskPaint::Plate, 10.25, 20, 4.5);
  line.path_px.emplace_back(30, 40);
  ASSERT_TRUE(writeMaskStrokes(out, {dot(MaskPaint::Sherd, 1, 2, 3), line}).has_value());
  const auto back = readMaskStrokes(out);
  ASSERT_TRUE(back.has_value()) << back.error().sentence();
  ASSERT_EQ(back->size(), 2u);
  EXPECT_EQ((*back)[0].paint, MaskPaint::Sherd);
  EXPECT_EQ((*back)[1].paint, MaskPaint::Plate);
  EXPECT_EQ((*back)[1].side, batch::Side::Back);
  EXPECT_EQ((*back)[1].camera, 2);
  EXPECT_EQ((*back)[1].stop, 5);
  EXPECT_EQ((*back)[1].radius_px, 4.5);
  EXPECT_EQ((*back)[1].path_px, line.path_px);
  EXPECT_EQ((*back)[1].by, "AP");
  EXPECT_EQ((*back)[1].at, "2026-07-14T09:30:12Z");
}

TEST_F(MaskStrokes, CanBePaintedOnlyWhereThereAreMasks) {
  EXPECT_FALSE(hasMasks(out));
  fs::create_directories(out / "work" / "scans_front");  // a batch of scans
  EXPECT_FALSE(hasMasks(out));
  fs::create_directories(out / "work" / "masks_back");
  EXPECT_TRUE(hasMasks(out));
}

TEST_F(MaskStrokes, HoldOnlyForThePhotographTheyWerePaintedOn) {
  MaskStroke here = dot(MaskPaint::Sherd, 1, 2, 3), before = here, elsewhere = here;
  here.photograph = "aa";
  before.photograph = "bb";
  elsewhere.photograph = "aa";
  elsewhere.stop = 6;
  ASSERT_TRUE(writeMaskStrokes(out, {here, before, elsewhere}).has_value());
  const auto read = readMaskStrokes(out);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  StrokesOn on = strokesOn(*read, batch::Side::Back, 2, 5, "aa");
  EXPECT_EQ(on.holding, std::vector<MaskStroke>{here});
  EXPECT_TRUE(on.taken_again);
  on = strokesOn(*read, batch::Side::Back, 2, 6, "aa");
  EXPECT_EQ(on.holding, std::vector<MaskStroke>{elsewhere});
  EXPECT_FALSE(on.taken_again);
}

TEST_F(MaskStrokes, ThatAreNoneAreRefusedByTheFilesName) {
  for (const char* text :
       {"{}", R"({"format":"ostraka-mask-strokes/1","strokes":[{"side":"front"}]})",
        R"({"format":"ostraka-mask-strokes/1","strokes":[{"side":"front","camera":0,"stop":0,)"
        R"("paint":"sherd","radius_px":1e9,"path_px":[[1,1]]}]})",
        R"({"format":"ostraka-mask-strokes/1","strokes":[{"side":"front","camera":0,"stop":0,)"
        R"("paint":"sherd","radius_px":3,"path_px":[]}]})"}) {
    ASSERT_TRUE(writeFileAtomically(out / "mask_strokes.json", text).has_value());
    const auto read = readMaskStrokes(out);
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(read.error().where.find("mask_strokes.json"), std::string::npos);
  }
}

TEST_F(MaskStrokes, HaveALimitForEachPhotograph) {
  std::vector<MaskStroke> strokes(limits::kMaskStrokes.most, dot(MaskPaint::Sherd, 1, 2, 3));
  strokes.push_back(strokes.back());
  strokes.back().stop = 6;
  ASSERT_TRUE(writeMaskStrokes(out, strokes).has_value());
  EXPECT_TRUE(readMaskStrokes(out).has_value());
  strokes.back().stop = 5;
  EXPECT_EQ(writeMaskStrokes(out, strokes).error().what,
            "A mask holds at most 1,000 strokes and 100,000 points; nothing is saved until you "
            "undo some.");
  EXPECT_EQ(readMaskStrokes(out)->size(), strokes.size()) << "what was there is still there";
  const std::string text = nlohmann::ordered_json{
      {"format", "ostraka-mask-strokes/1"},
      {"strokes",
       toJson(strokes)}}.dump();
  ASSERT_TRUE(writeFileAtomically(out / "mask_strokes.json", text).has_value());
  EXPECT_FALSE(readMaskStrokes(out).has_value());
  strokes.resize(1);
  strokes[0].path_px.resize(limits::kMaskPoints.most, {1, 1});
  EXPECT_TRUE(writeMaskStrokes(out, strokes).has_value());
  strokes[0].path_px.emplace_back(1, 1);
  EXPECT_FALSE(writeMaskStrokes(out, strokes).has_value());
}

TEST_F(MaskStrokes, CostWhatTheyCoverHoweverLargeThePhotograph) {
  cv::Mat1b mask(4000, 6000, uchar{0});
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i) paintStroke(mask, dot(MaskPaint::Sherd, 6 * i, 4 * i, 5));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3))
      << "with a picture for each stroke it takes half a minute";
  EXPECT_EQ(mask(2000, 3000), 255);
}

TEST_F(MaskStrokes, ReachTheEdgesOfThePhotograph) {
  cv::Mat1b mask(200, 300, uchar{0});
  MaskStroke line = dot(MaskPaint::Sherd, -50, 100, 5);
  line.path_px.emplace_back(350, 100);
  paintStroke(mask, line);
  EXPECT_EQ(cv::countNonZero(mask.row(100)), 300);
  EXPECT_EQ(mask(90, 150), 0);
}

TEST_F(MaskStrokes, CoverADiscOrAWayOfTheBrushsWidth) {
  cv::Mat1b mask(200, 300, uchar{0});
  paintStroke(mask, dot(MaskPaint::Sherd, 100, 80, 20));
  // A disc of 20 pixels; its edge is soft, so the count is right to a line of pixels around it.
  EXPECT_NEAR(cv::countNonZero(mask >= 128), CV_PI * 400, 2 * CV_PI * 20);
  EXPECT_EQ(mask(80, 100), 255);
  EXPECT_EQ(mask(80, 130), 0);
  MaskStroke line = dot(MaskPaint::Plate, 100, 0, 5);
  line.path_px.emplace_back(100, 199);
  paintStroke(mask, line);
  EXPECT_EQ(mask(80, 100), 0) << "cut through";
  EXPECT_EQ(mask(80, 104), 0);
  EXPECT_EQ(mask(80, 110), 255) << "beside the way it stays";
  EXPECT_EQ(mask(80, 90), 255);
  paintStroke(mask, dot(MaskPaint::Sherd, -500, 9000, 20));
  EXPECT_EQ(mask.size(), cv::Size(300, 200)) << "beside the picture nothing happens";
}

}  // namespace
}  // namespace ostraka::decisions
