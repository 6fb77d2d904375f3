#include "mask/plane_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ground/plate_geometry.h"

namespace ostraka::mask {
namespace {

constexpr double kPitch = 0.8, kRadius = 40, kHeight = 9;

rig::PosedImage camera(double tilt) {
  rig::PosedImage image;
  image.intrinsics = {240, 200, 500, 500, 119.5, 99.5, {}};
  image.camera_from_plate.linear() =
      Eigen::AngleAxisd(M_PI / 2 + tilt, Eigen::Vector3d::UnitX()).matrix();
  image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 300);
  return image;
}

// Waves of several lengths and directions that repeat nowhere near.
double texture(double x, double y) {
  return 3.5 + 0.2 * std::sin(1.1 * x + 0.3 * y) + 0.2 * std::sin(0.57 * y - 0.71 * x) +
         0.2 * std::sin(1.37 * y + 0.2 * x);
}

// What a camera sees of a textured plane, as log brightness.
cv::Mat1f viewOf(const rig::PosedImage& image, double height_mm) {
  cv::Mat1f view(image.intrinsics.height, image.intrinsics.width);
  const Eigen::Isometry3d back = image.camera_from_plate.inverse();
  const Eigen::Vector3d eye = back.translation();
  for (int y = 0; y < view.rows; ++y)
    for (int x = 0; x < view.cols; ++x) {
      const Eigen::Vector3d way =
          back.linear() *
          image.intrinsics.unproject({static_cast<double>(x), static_cast<double>(y)})
              .homogeneous();
      const Eigen::Vector3d p = eye + (height_mm - eye.z()) / way.z() * way;
      view(y, x) = static_cast<float>(texture(p.x(), p.y()));
    }
  return view;
}

struct Swept {
  PlaneSweep sweep{kPitch, kRadius};
  std::vector<rig::PosedImage> images{camera(0.7), camera(1.1)};
  std::vector<cv::Mat1f> best;

  explicit Swept(double height_mm) {
    for (std::size_t i = 0; i < images.size(); ++i) {
      sweep.add(images[i], viewOf(images[i], kHeight), 15);
      best.emplace_back(sweep.ground(i), 0.F);
    }
    sweep.agreeOn(height_mm, best);
  }

  // As photograph i sees the plane's point.
  float at(std::size_t i, double x, double y) const {
    ground::PlateGrid millimetres;
    millimetres.pitch_mm = 1;
    millimetres.size = 1;
    const cv::Mat1f seen = sweep.seenFrom(i, best[i], ground::gridOfPixels(images[i], millimetres));
    const Eigen::Vector2d p = images[i].project({x, y, kHeight});
    return seen(static_cast<int>(std::lround(p.y())), static_cast<int>(std::lround(p.x())));
  }
};

TEST(PlaneSweep, PhotographsOfAPlaneAgreeOnItWhereItIsSeen) {
  const Swept swept(kHeight);
  for (std::size_t i = 0; i < 2; ++i)
    for (const double x : {-20.0, 0.0, 20.0})
      for (const double y : {-20.0, 0.0, 20.0})
        // Sampled twice, at two scales: a little of the waves is lost.
        EXPECT_GT(swept.at(i, x, y), 0.9) << "photograph " << i << " at " << x << " " << y;
}

TEST(PlaneSweep, TheyDoNotAgreeOnAnotherPlane) {
  const Swept swept(kHeight - 5);
  double sum = 0;
  for (const double x : {-20.0, -10.0, 0.0, 10.0, 20.0})
    for (const double y : {-20.0, -10.0, 0.0, 10.0, 20.0}) sum += swept.at(0, x, y);
  EXPECT_LT(sum / 25, 0.4);
}

TEST(PlaneSweep, NothingIsSaidOutsideOnePhotograph) {
  PlaneSweep sweep(kPitch, kRadius);
  std::vector<cv::Mat1f> best;
  const rig::PosedImage whole = camera(0.7);
  rig::PosedImage part = camera(1.1);
  part.intrinsics.width = 120;  // sees the plate's left half
  for (const rig::PosedImage& image : {whole, part}) {
    sweep.add(image, viewOf(image, 0), 15);
    best.emplace_back(sweep.ground(best.size()), 0.F);
  }
  sweep.agreeOn(0, best);
  ground::PlateGrid millimetres;
  millimetres.pitch_mm = 1;
  millimetres.size = 1;
  const cv::Mat1f seen = sweep.seenFrom(0, best[0], ground::gridOfPixels(whole, millimetres));
  const auto at = [&](double x) {
    const Eigen::Vector2d p = whole.project({x, 0, 0});
    return seen(static_cast<int>(p.y()), static_cast<int>(p.x()));
  };
  const double side = part.project({20, 0, 0}).x() > 119 ? 1 : -1;
  EXPECT_EQ(at(20 * side), 0);
  EXPECT_GT(at(-20 * side), 0.9);
}

}  // namespace
}  // namespace ostraka::mask
