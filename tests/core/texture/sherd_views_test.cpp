#include "texture/sherd_views.h"

#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "block.h"
#include "files/scratch_folder.h"

namespace ostraka::texture {
namespace {

namespace fs = std::filesystem;

class ViewsOfABatch : public testing::Test {
 protected:
  /// Looked at from above and from two sides.
  Photograph photograph(const std::string& name, double x) const {
    Photograph one{lookingAt({x, 0, 200}, {0, 0, 0}), cv::Mat1b(600, 800, uchar{255})};
    one.image.file = (folder_.path() / name).string();
    cv::imwrite(one.image.file, cv::Mat3b(600, 800, cv::Vec3b(50, 100, 150)));
    return one;
  }

  ScratchFolder folder_ = std::move(*ScratchFolder::make("views"));
  const Subject tile_{block({40, 30, 6}, 2).vertices};
};

TEST_F(ViewsOfABatch, GoOnWithoutAPhotographThatCannotBeRead) {
  const std::vector<Photograph> photographs = {photograph("a.png", -50), photograph("b.png", 0),
                                               photograph("c.png", 50)};
  std::ofstream(photographs[1].image.file) << "cut off";
  SherdViews views(photographs, {tile_, tile_}, 2);
  for (const std::size_t sherd : {0U, 1U}) {
    const Result<Shown> shown = views.of(sherd, {});
    ASSERT_TRUE(shown.has_value()) << shown.error().sentence();
    EXPECT_EQ(shown->views.size(), 2U);
    ASSERT_EQ(shown->unread.size(), 1U);
    EXPECT_NE(shown->unread[0].sentence().english().find("b.png"), std::string::npos);
  }
}

TEST_F(ViewsOfABatch, AreNoneWhereNoPhotographCanBeRead) {
  Photograph gone = photograph("a.png", 0);
  fs::remove(gone.image.file);
  SherdViews views({gone}, {tile_}, 1);
  ASSERT_FALSE(views.of(0, {}).has_value());
  EXPECT_NE(views.of(0, {}).error().sentence().english().find("a.png"), std::string::npos);
}

TEST_F(ViewsOfABatch, AreReadAgainAfterACancellation) {
  SherdViews views({photograph("a.png", 0)}, {tile_}, 1);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(views.of(0, stop.get_token()).error().code, ErrorCode::Cancelled);
  const Result<Shown> shown = views.of(0, {});
  ASSERT_TRUE(shown.has_value());
  EXPECT_EQ(shown->views.size(), 1U);
}

}  // namespace
}  // namespace ostraka::texture
