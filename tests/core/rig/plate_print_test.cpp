#include "rig/plate_print.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <set>

#include "calibration/intrinsics.h"
#include "colmap/colmap_program.h"
#include "files/files.h"
#include "rig/plate_markers.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::rig {
namespace {

namespace fs = std::filesystem;

constexpr double kDpi = 300;

class PlatePrintTest : public testing::Test {
 protected:
  // The pages as a printer of 300 dots per inch sees them.
  std::vector<cv::Mat> printed(const PlatePrint& print) {
    const fs::path file = folder_ / "plate.pdf";
    EXPECT_TRUE(writeFileAtomically(file, formatPdf(print.pages, "plate")));
    const auto program = colmap::findProgram("pdftoppm");
    EXPECT_TRUE(program.has_value()) << "poppler-utils belongs to the packages";
    const Result<void> done = colmap::runProgram(
        *program, {"-r", "300", "-gray", file.string(), (folder_ / "page").string()},
        folder_ / "log.txt", {});
    EXPECT_TRUE(done) << done.error().sentence();
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().extension() == ".pgm") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<cv::Mat> pages;
    for (const fs::path& page : files)
      pages.push_back(cv::imread(page.string(), cv::IMREAD_GRAYSCALE));
    return pages;
  }

  // On the page, mm; a pixel's centre has integer coordinates.
  static Eigen::Vector2d onPage(const Eigen::Vector2d& pixel) {
    return (pixel + Eigen::Vector2d(0.5, 0.5)) * 25.4 / kDpi;
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

// Largest distance of a marker's corner from where plate.json has it, mm; how many were found.
double worstCorner(const cv::Mat& page, const batch::Plate& plate, const Eigen::Vector2d& centre,
                   std::set<int>& found) {
  double worst = 0;
  const std::vector<SeenMarker> markers = *findPlateMarkers(page, plate);
  for (const SeenMarker& marker : markers) {
    found.insert(marker.id);
    for (int c = 0; c < 4; ++c) {
      const Eigen::Vector3d& p = plate.markers[static_cast<std::size_t>(marker.id)].corners[c];
      const Eigen::Vector2d seen = (marker.corners[c] + Eigen::Vector2d(0.5, 0.5)) * 25.4 / kDpi;
      worst = std::max(worst, (seen - centre - Eigen::Vector2d(p.x(), -p.y())).norm());
    }
  }
  return worst;
}

TEST_F(PlatePrintTest, OnOnePageIsDetectedWholeAndTrue) {
  for (const Ground ground : {Ground::White, Ground::Black}) {
    PlatePrintOptions options;
    options.paper.reset();
    options.ground = ground;
    const auto print = printPlate(options);
    ASSERT_TRUE(print.has_value()) << print.error().sentence();
    const std::vector<cv::Mat> pages = printed(*print);
    ASSERT_EQ(pages.size(), 2U);
    std::set<int> found;
    EXPECT_LT(worstCorner(pages[0], print->plate, print->centres[0], found), 0.05);
    EXPECT_EQ(found.size(), 24U);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
}

TEST_F(PlatePrintTest, OnSheetsIsTrueWithEachMarkerWholeOnOneOfThem) {
  for (const auto& [paper, sheets] :
       std::vector<std::pair<Paper, std::size_t>>{{Paper::A3, 2}, {Paper::A4, 4}}) {
    PlatePrintOptions options;
    options.paper = paper;
    const auto print = printPlate(options);
    ASSERT_TRUE(print.has_value()) << print.error().sentence();
    ASSERT_EQ(print->centres.size(), sheets);
    EXPECT_EQ(print->markers_cut, 0);
    const std::vector<cv::Mat> pages = printed(*print);
    ASSERT_EQ(pages.size(), sheets + 1);
    std::set<int> found;
    for (std::size_t i = 0; i < sheets; ++i)
      EXPECT_LT(worstCorner(pages[i], print->plate, print->centres[i], found), 0.05);
    EXPECT_EQ(found.size(), 24U);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
}

// Sentences, not the rulers' numbers, whose place is fixed.
TEST(PlatePrint, LeavesItsWordsWholeOnOneSheet) {
  for (const Paper paper : {Paper::A3, Paper::A4})
    for (const double diameter : {150.0, 250.0, 330.0, 420.0, 500.0}) {
      PlatePrintOptions options;
      options.paper = paper;
      options.diameter_mm = diameter;
      const auto print = printPlate(options);
      ASSERT_TRUE(print.has_value()) << print.error().sentence();
      int sentences = 0, whole = 0;
      for (std::size_t i = 0; i < print->centres.size(); ++i) {
        const Layer& layer = print->pages[i].layers.front();
        for (const auto& item : layer.sheet.items) {
          const Text* text = std::get_if<Text>(&item);
          if (text == nullptr || text->text.find(' ') == std::string::npos) continue;
          const Eigen::Vector2d at = layer.at + text->at;
          const Eigen::AlignedBox2d box(at - Eigen::Vector2d(0, text->size_mm),
                                        at + Eigen::Vector2d(textWidth(*text), text->size_mm / 3));
          sentences += layer.window->intersects(box);
          whole += layer.window->contains(box);
        }
      }
      EXPECT_GE(whole, 6) << diameter;
      EXPECT_EQ(sentences, whole) << diameter;  // on one sheet each, cut by none
    }
}

Eigen::AlignedBox2d boxOf(const Text& text) {
  const double width = textWidth(text);
  const double left = text.anchor == Anchor::Left     ? 0
                      : text.anchor == Anchor::Middle ? width / 2
                                                      : width;
  const Eigen::Vector2d at = text.at - Eigen::Vector2d(left, 0);
  return {at - Eigen::Vector2d(0, 0.7 * text.size_mm), at + Eigen::Vector2d(width, 0)};
}

// Where the disc within the markers is too small for the words they stand beside the plate.
TEST(PlatePrint, KeepsItsWordsOffMarkersAndOffEachOtherOnSmallPlates) {
  for (const auto& [diameter, marker] : std::vector<std::pair<double, double>>{
           {60, 8}, {80, 12}, {100, 12}, {120, 16}, {150, 12}, {150, 24}, {180, 20}, {220, 33}})
    for (const std::optional<Paper> paper :
         {std::optional(Paper::A4), std::optional(Paper::A3), std::optional<Paper>()}) {
      PlatePrintOptions options;
      options.diameter_mm = diameter;
      options.marker_mm = marker;
      options.paper = paper;
      const auto print = printPlate(options);
      ASSERT_TRUE(print.has_value()) << print.error().sentence();
      const Layer& layer = print->pages.front().layers.front();
      std::vector<Eigen::AlignedBox2d> boxes;
      std::string all;
      for (const auto& item : layer.sheet.items)
        if (const Text* text = std::get_if<Text>(&item)) {
          boxes.push_back(boxOf(*text));
          all += text->text + " ";
          for (const batch::Marker& m : print->plate.markers) {
            const Eigen::Vector3d middle = (m.corners[0] + m.corners[2]) / 2;
            EXPECT_GT(boxes.back().exteriorDistance(Eigen::Vector2d(middle.x(), -middle.y())),
                      marker / 2)
                << diameter << " " << text->text;
          }
        }
      EXPECT_THAT(all, testing::HasSubstr("cut to it."));  // the last of the words
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
          EXPECT_FALSE(boxes[i].intersects(boxes[k])) << diameter << " " << marker;
      const Page& page = print->pages.front();
      if (!paper) {
        for (const Eigen::AlignedBox2d& box : boxes)
          EXPECT_TRUE(Eigen::AlignedBox2d(Eigen::Vector2d(0, 0),
                                          Eigen::Vector2d(page.width_mm, page.height_mm))
                          .contains(box.translated(layer.at)));
      }
    }
}

TEST_F(PlatePrintTest, BoardIsTheOneThatIsLookedFor) {
  const auto print = printPlate({});
  ASSERT_TRUE(print.has_value());
  const cv::Mat page = printed(*print).back();
  const Result<calibration::TargetView> view = calibration::findBoard(page, print->board);
  ASSERT_TRUE(view.has_value());
  ASSERT_EQ(view->points.size(), 48U);  // 8 x 6 corners between 9 x 7 squares
  // 0.06 of this comes from the page's height, which is rounded up to whole pixels.
  for (std::size_t i = 0; i < view->points.size(); ++i)
    EXPECT_LT((onPage(view->pixels[i]) - print->board_corner - view->points[i].head<2>()).norm(),
              0.1);
}

TEST(PlatePrint, FollowsTheRulerAsMeasured) {
  PlatePrintOptions options;
  const auto drawn = printPlate(options);
  ASSERT_TRUE(drawn.has_value());
  EXPECT_DOUBLE_EQ(drawn->ruler_mm, 200);
  options.ruler_measured_mm = 198;  // 1 % short
  const auto measured = printPlate(options);
  ASSERT_TRUE(measured.has_value()) << measured.error().sentence();
  EXPECT_NEAR(measured->plate.diameter_mm, 326.7, 1e-9);
  EXPECT_NEAR(measured->board.square_mm, 21.78, 1e-9);
  EXPECT_NEAR(measured->plate.markers[0].corners[0].x(), 157 * 0.99, 1e-9);
  options.ruler_measured_mm = 141;  // A3 on A4
  const auto shrunk = printPlate(options);
  ASSERT_FALSE(shrunk.has_value());
  EXPECT_THAT(shrunk.error().what, testing::HasSubstr("at 100 %"));
}

TEST(PlatePrint, RefusesWhatCannotBe) {
  PlatePrintOptions options;
  options.diameter_mm = 70;
  EXPECT_THAT(printPlate(options).error().what, testing::HasSubstr("Fewer than six markers"));
  EXPECT_THAT(printPlate(options).error().what, testing::HasSubstr("markers of 12 mm fit on it."));
  options.marker_mm = 13;
  EXPECT_FALSE(options.check().has_value());
  options.marker_mm = 12;
  EXPECT_TRUE(options.check().has_value());
  options.diameter_mm = 30;
  options.marker_mm = 5;
  EXPECT_THAT(printPlate(options).error().what, testing::HasSubstr("no room for a sherd"));
  options.marker_mm = 24;
  options.diameter_mm = 1900;
  EXPECT_THAT(printPlate(options).error().what, testing::HasSubstr("too few markers"));
  options.diameter_mm = 330;
  options.dictionary = "DICT_9X9";
  EXPECT_THAT(printPlate(options).error().what, testing::HasSubstr("DICT_9X9"));
}

}  // namespace
}  // namespace ostraka::rig
