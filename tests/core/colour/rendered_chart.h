#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "batch/photograph.h"
#include "colour/ciede2000.h"
#include "colour/correction.h"

namespace ostraka::colour {

/// What a camera makes of the colours: darker, and its channels mixed as warm light does.
inline Eigen::Matrix3d camera() {
  return Eigen::Matrix3d{{0.62, 0.10, 0.02}, {0.05, 0.70, 0.03}, {0.01, 0.12, 0.50}};
}

inline Patches<Eigen::Vector3d> photographedPatches(const Eigen::Matrix3d& by) {
  Patches<Eigen::Vector3d> light;
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = by * lightOf(referenceLab()[i]);
  return light;
}

/// The chart from above with its dark frame, linear BGR; patches of 90 pixels, 10 between them.
inline cv::Mat3f chartOf(const Patches<Eigen::Vector3d>& light) {
  constexpr float kFrame = 0.03f;
  cv::Mat3f chart(450, 650, cv::Vec3f(kFrame, kFrame, kFrame));
  for (std::size_t i = 0; i < light.size(); ++i)
    chart(cv::Rect(30 + 100 * static_cast<int>(i % 6), 30 + 100 * static_cast<int>(i / 6), 90, 90))
        .setTo(cv::Scalar(light[i][2], light[i][1], light[i][0]));
  return chart;
}

/// The chart laid into a scene of linear light, its corners clockwise from dark skin's.
inline void lay(const cv::Mat3f& chart, const std::vector<cv::Point2f>& corners, cv::Mat3f& scene) {
  const auto w = static_cast<float>(chart.cols), h = static_cast<float>(chart.rows);
  const cv::Mat scene_from_chart = cv::getPerspectiveTransform(
      std::vector<cv::Point2f>{{0, 0}, {w, 0}, {w, h}, {0, h}}, corners);
  // Averaged first, since a warp takes single pixels.
  const double reduction = cv::norm(corners[1] - corners[0]) / chart.cols;
  cv::Mat3f smooth;
  cv::GaussianBlur(chart, smooth, {}, 0.5 / reduction, 0, cv::BORDER_REPLICATE);
  cv::warpPerspective(smooth, scene, scene_from_chart, scene.size(), cv::INTER_LINEAR,
                      cv::BORDER_TRANSPARENT);
}

inline cv::Mat3f lightIn(const cv::Mat3b& photograph) {
  cv::Mat3f light(photograph.size());
  for (int y = 0; y < light.rows; ++y)
    for (int x = 0; x < light.cols; ++x)
      for (int k = 0; k < 3; ++k)
        light(y, x)[k] = static_cast<float>(batch::linearLight()[photograph(y, x)[k]]);
  return light;
}

/// A plate with clay-coloured sherds on grey cloth.
inline cv::Mat3f sceneWithSherds() {
  cv::Mat3f scene(1200, 1600, cv::Vec3f(0.02f, 0.02f, 0.02f));
  cv::ellipse(scene, {800, 650}, {700, 420}, 0, 0, 360, cv::Scalar(0.06, 0.055, 0.05), -1);
  for (int i = 0; i < 24; ++i) {
    const cv::Point at(800 + cvRound(640 * std::cos(i * 0.2618)),
                       650 + cvRound(370 * std::sin(i * 0.2618)));
    cv::rectangle(scene, at - cv::Point(35, 25), at + cv::Point(35, 25), {0.7, 0.7, 0.7}, -1);
    cv::rectangle(scene, at - cv::Point(22, 15), at + cv::Point(22, 15), {0.01, 0.01, 0.01}, -1);
  }
  for (int i = 0; i < 5; ++i)
    cv::ellipse(scene, {450 + 170 * i, 880 - 20 * (i % 2)}, {60, 45}, 20.0 * i, 0, 360,
                cv::Scalar(0.08 + 0.03 * i, 0.15, 0.3), -1);
  return scene;
}

/// 8-bit sRGB with normal noise.
inline cv::Mat3b photographed(const cv::Mat3f& light, double noise) {
  std::mt19937 random(5);
  std::normal_distribution<double> off(0, noise);
  cv::Mat3b picture(light.size());
  for (int y = 0; y < light.rows; ++y)
    for (int x = 0; x < light.cols; ++x)
      for (int k = 0; k < 3; ++k) {
        const double v = std::clamp<double>(light(y, x)[k], 0, 2);
        const double level = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
        picture(y, x)[k] = cv::saturate_cast<uchar>(255 * level + off(random));
      }
  return picture;
}

}  // namespace ostraka::colour
