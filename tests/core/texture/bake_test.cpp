#include "texture/bake.h"

#include <gtest/gtest.h>

#include "block.h"
#include "seam_step.h"

namespace ostraka::texture {
namespace {

// What the sherd's surface looks like, BGR: waves of 3 mm on a wash of colour.
cv::Vec3d paint(const Eigen::Vector3d& p) {
  const double wave = 30 * std::sin(2 * M_PI * p.x() / 3) * std::sin(2 * M_PI * p.y() / 3);
  return {70 + p.x() + wave, 100 + 1.5 * p.y() + wave, 140 - p.x() + wave};
}

constexpr double kSize[3] = {40, 30, 6};

// Where a ray meets the box, from outside.
std::optional<Eigen::Vector3d> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
  double enter = 0, leave = INFINITY;
  const Eigen::Vector3d low(-kSize[0] / 2, -kSize[1] / 2, 0),
      high(kSize[0] / 2, kSize[1] / 2, kSize[2]);
  for (int k = 0; k < 3; ++k) {
    double a = (low[k] - from[k]) / along[k], b = (high[k] - from[k]) / along[k];
    if (a > b) std::swap(a, b);
    enter = std::max(enter, a);
    leave = std::min(leave, b);
  }
  return enter < leave ? std::optional<Eigen::Vector3d>(from + enter * along) : std::nullopt;
}

View photographed(const Eigen::Vector3d& from, double exposure,
                  std::optional<Eigen::Vector2d> highlight = {}) {
  const rig::PosedImage image = lookingAt(from, {0, 0, 3});
  cv::Mat3b photograph(600, 800, cv::Vec3b(20, 20, 20));
  cv::Mat1b mask = cv::Mat1b::zeros(600, 800);
  const Eigen::Isometry3d plate_from_camera = image.camera_from_plate.inverse();
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 800; ++x) {
      const Eigen::Vector2d ray = image.intrinsics.unproject({x, y});
      const auto there =
          hit(from, plate_from_camera.linear() * Eigen::Vector3d(ray.x(), ray.y(), 1));
      if (!there) continue;
      mask(y, x) = 255;
      cv::Vec3d color = exposure * paint(*there);
      if (highlight && there->z() > 5.99 && (there->head<2>() - *highlight).norm() < 4)
        color = {250, 250, 250};
      photograph(y, x) = color;
    }
  std::vector<Eigen::Vector3f> corners;
  for (int k = 0; k < 8; ++k)
    corners.emplace_back((k & 1 ? 20 : -20), (k & 2 ? 15 : -15), (k & 4 ? 6 : 0));
  return *cutOut(photograph, mask, image, Eigen::Isometry3d::Identity(), corners);
}

class Bake : public testing::Test {
 protected:
  // Root mean square over the texels that were seen and are `wanted`, of one gain over all.
  template <class Wanted>
  double errorOf(const Texture& texture, Wanted wanted) const {
    const Texels texels = texelsOf(charts, atlas);
    double found = 0, truth = 0, sum = 0;
    int count = 0;
    for (const bool is_second : {false, true})
      for (int y = 0; y < atlas.height; ++y)
        for (int x = 0; x < atlas.width; ++x) {
          if (!texture.seen(y, x)) continue;
          const Eigen::Vector3d p = pointOf(tile, texels, x, y);
          if (!wanted(p)) continue;
          const cv::Vec3d expected = paint(p);
          for (int k = 0; k < 3; ++k) {
            if (is_second) {
              sum += std::pow(texture.picture(y, x)[k] - found / truth * expected[k], 2);
              ++count;
            } else {
              found += texture.picture(y, x)[k];
              truth += expected[k];
            }
          }
        }
    return count > 0 ? std::sqrt(sum / count) : INFINITY;
  }
  Texture baked(const std::vector<View>& views, int threads = 2) {
    QuietProgress quiet;
    return *bake(tile, charts, atlas, views, {}, threads, quiet, {});
  }
  const TriangleMesh tile = block({40, 30, 6}, 2);
  const std::vector<Chart> charts = chartsOf(tile, 0.2);
  const Atlas atlas = packed(charts, 0.2);
};

std::vector<View> around(const std::vector<double>& exposures) {
  std::vector<View> views;
  for (std::size_t i = 0; i < exposures.size(); ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(exposures.size());
    const double height = i % 2 == 0 ? 130 : -130;
    views.push_back(
        photographed({120 * std::cos(angle), 120 * std::sin(angle), height}, exposures[i]));
  }
  return views;
}

TEST_F(Bake, IsWhatWasPaintedWhateverTheExposures) {
  const Texture texture = baked(around({1, 0.8, 1.1, 0.9, 1.2, 1, 0.85, 1.05, 0.95, 1.1, 0.9, 1}));
  EXPECT_GT(texture.seen_share, 0.97);
  const auto everywhere = [](const Eigen::Vector3d&) { return true; };
  const auto above = [](const Eigen::Vector3d& p) { return p.z() > 5.99; };
  EXPECT_LT(errorOf(texture, everywhere), 4);
  EXPECT_LT(errorOf(texture, above), 3);
}

TEST_F(Bake, KeepsTheContrastOfTheFinestPattern) {
  const Texture texture = baked(around({1, 1, 1, 1, 1, 1, 1, 1}));
  const Texels texels = texelsOf(charts, atlas);
  double both = 0, truth = 0;
  for (int y = 0; y < atlas.height; ++y)
    for (int x = 0; x < atlas.width; ++x) {
      if (!texture.seen(y, x)) continue;
      const Eigen::Vector3d p = pointOf(tile, texels, x, y);
      if (p.z() < 5.99) continue;
      const double wave = std::sin(2 * M_PI * p.x() / 3) * std::sin(2 * M_PI * p.y() / 3);
      both += wave * texture.picture(y, x)[1];
      truth += 30 * wave * wave;
    }
  EXPECT_GT(both / truth, 0.9);
}

TEST_F(Bake, ShowsTheSameOnBothSidesOfABorder) {
  const Texture texture = baked(around({1, 0.8, 1.1, 0.9, 1.2, 1, 0.85, 1.05}));
  EXPECT_LT(stepAcross(texture.picture, texture.seen, seamsOf(tile, charts, atlas)), 1.5);
}

TEST_F(Bake, LeavesHighlightsOut) {
  std::vector<View> views = around({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
  views[0] = photographed({120, 0, 130}, 1, Eigen::Vector2d(5, 3));
  const auto there = [](const Eigen::Vector3d& p) {
    return p.z() > 5.99 && (p.head<2>() - Eigen::Vector2d(5, 3)).norm() < 4;
  };
  EXPECT_LT(errorOf(baked(views), there), 6);
}

TEST_F(Bake, FillsInWhatNoPhotographShowsAndSaysSo) {
  const Texture texture = baked({photographed({0, -60, 170}, 1), photographed({10, 60, 170}, 1)});
  EXPECT_LT(texture.seen_share, 0.6);
  EXPECT_GT(texture.seen_share, 0.35);
  const Texels texels = texelsOf(charts, atlas);
  for (int y = 0; y < atlas.height; ++y)
    for (int x = 0; x < atlas.width; ++x) {
      if (texels.face(y, x) < 0) {
        EXPECT_EQ(texture.seen(y, x), 0);
      }
      EXPECT_GT(texture.picture(y, x)[1], 30) << "nothing is left black";
    }
}

TEST_F(Bake, DoesNotDependOnThreads) {
  const std::vector<View> views = around({1, 0.8, 1.1, 0.9});
  EXPECT_EQ(cv::norm(baked(views, 1).picture, baked(views, 2).picture, cv::NORM_INF), 0);
  std::stop_source stop;
  stop.request_stop();
  QuietProgress quiet;
  EXPECT_EQ(bake(tile, charts, atlas, views, {}, 1, quiet, stop.get_token()).error().code,
            ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::texture
