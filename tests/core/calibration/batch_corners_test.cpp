#include "calibration/batch_corners.h"

#include <gmock/gmock.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "tests/core/calibration/drawn_board.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::calibration {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Notes final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override { texts.push_back(text.english()); }
  std::vector<std::string> texts;
};

// The board, a dark picture, a file that is none, the board again.
class BatchCorners : public testing::Test {
 protected:
  BatchCorners() {
    const std::filesystem::path folder = temporary_.path();
    batch_.folder = folder;
    const cv::Mat board = render(1200, 0.7).picture;
    for (const char* name : {"0.png", "3.png"}) cv::imwrite((folder / name).string(), board);
    cv::imwrite((folder / "1.png").string(), cv::Mat(60, 80, CV_8UC3, cv::Scalar(20, 20, 20)));
    std::ofstream(folder / "2.png") << "no picture";
    for (int i = 0; i < 4; ++i) {
      const std::filesystem::path file = folder / (std::to_string(i) + ".png");
      batch_.calibration.push_back({0, file});
      batch_.shots.push_back({batch::Side::Front, 0, i, file, {}, 1200, 900});
    }
    batch_.board = kBoard;
    batch_.plate.emplace();
    batch_.plate->dictionary = kBoard.dictionary;
    batch_.plate->markers.resize(2);  // those of the board with these ids
    batch_.plate->markers[0].id = 30;
    batch_.plate->markers[1].id = 4;
  }
  TemporaryFolder temporary_;
  batch::Batch batch_;
  Notes notes_;
};

TEST_F(BatchCorners, OfBoardsComeInTheOrderOfTheirPictures) {
  for (const int threads : {1, 3}) {
    notes_.texts.clear();
    const auto views = findBatchBoards(batch_, threads, notes_, {});
    ASSERT_TRUE(views.has_value()) << views.error().sentence();
    std::vector<std::size_t> found;
    for (const TargetView& view : *views) found.push_back(view.points.size());
    EXPECT_THAT(found, ElementsAre(48, 0, 0, 48));
    EXPECT_EQ((*views)[3].file, batch_.calibration[3].file.string());
    EXPECT_THAT(notes_.texts,
                ElementsAre(HasSubstr("1.png: The board was not detected"), HasSubstr("2.png")));
  }
}

TEST_F(BatchCorners, OfMarkersAreThoseOfThePlateAlone) {
  const auto shots = findBatchMarkers(batch_, 2, notes_, {});
  ASSERT_TRUE(shots.has_value()) << shots.error().sentence();
  ASSERT_EQ(shots->size(), 4u);
  for (const std::size_t i : {0, 3}) {
    ASSERT_EQ((*shots)[i].markers.size(), 2u) << i;
    EXPECT_EQ((*shots)[i].markers[0].id, 4);
    EXPECT_EQ((*shots)[i].markers[1].id, 30);
    EXPECT_TRUE((*shots)[i].unreadable.empty());
  }
  EXPECT_TRUE((*shots)[1].markers.empty() && (*shots)[1].unreadable.empty());
  EXPECT_THAT((*shots)[2].unreadable.english(), HasSubstr("2.png"));
}

TEST_F(BatchCorners, OfAnUnknownDictionaryNameTheFileThatHasIt) {
  batch_.board->dictionary = batch_.plate->dictionary = "DICT_9X9";
  const auto boards = findBatchBoards(batch_, 1, notes_, {});
  ASSERT_FALSE(boards.has_value());
  EXPECT_EQ(boards.error().where, (batch_.folder / "board.json").string());
  const auto shots = findBatchMarkers(batch_, 1, notes_, {});
  ASSERT_FALSE(shots.has_value());
  EXPECT_EQ(shots.error().where, (batch_.folder / "plate.json").string());
}

TEST_F(BatchCorners, AreNoneOnceAStopIsRequested) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(findBatchBoards(batch_, 1, notes_, stop.get_token()).error().code,
            ErrorCode::Cancelled);
  EXPECT_EQ(findBatchMarkers(batch_, 1, notes_, stop.get_token()).error().code,
            ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::calibration
