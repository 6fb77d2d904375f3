#include "colour/chart.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <opencv2/mcc.hpp>
#include <vector>

#include "base/median.h"
#include "batch/photograph.h"

namespace ostraka::colour {
namespace {

// mcc's model of the chart: its edges, the first patch's middle, and the way to the next.
constexpr float kWide = 16.75f, kHigh = 11.25f;
constexpr double kFirst = 1.5, kStep = 2.75, kMiddle = 1.25;  // half of a patch's edge
constexpr int kSamples = 16;                                  // along it
// Of a patch's samples; medians hold up to a half. A single channel at 0 is not clipped by the
// exposure: cyan lies outside sRGB.
constexpr double kMostClipped = 0.1;

constexpr double kGlance = 240;  // pixels of the longer edge
constexpr float kLeastSaturation = 0.25f, kLeastValue = 0.1f;
constexpr double kLeastShare = 0.0005;  // half a patch of a chart a fifth as wide as the picture
constexpr int kLeastHues = 4;           // of six; half of the chart has so many

using Corners = std::vector<cv::Point2f>;

// One size of window at a time: of several mcc keeps what the fastest thread found.
std::vector<Corners> chartsIn(const cv::Mat3b& picture, int window) {
  const auto parameters = cv::mcc::DetectorParameters::create();
  parameters->adaptiveThreshWinSizeMin = parameters->adaptiveThreshWinSizeMax = window;
  std::vector<Corners> found;
  try {
    const auto detector = cv::mcc::CCheckerDetector::create();
    detector->process(picture, cv::mcc::MCC24, 4, false, parameters);
    for (const auto& one : detector->getListColorChecker()) found.push_back(one->getBox());
  } catch (const cv::Exception&) {
    // what it cannot make sense of is no chart
  }
  return found;
}

// Whether there are hues as on a chart; sherds, plates and sheets have one or two.
bool isColourful(const cv::Mat3b& picture) {
  cv::Mat3f hsv;
  const double scale = std::min(1.0, kGlance / std::max(picture.cols, picture.rows));
  const cv::Mat3b small =
      batch::reducedTo(picture, cvCeil(scale * picture.cols), cvCeil(scale * picture.rows));
  small.convertTo(hsv, CV_32F, 1 / 255.0);
  cv::cvtColor(hsv, hsv, cv::COLOR_BGR2HSV);
  std::array<int, 6> counts{};  // reds, yellows, greens, cyans, blues, magentas
  for (const cv::Vec3f& pixel : hsv)
    if (pixel[1] > kLeastSaturation && pixel[2] > kLeastValue)
      ++counts[static_cast<std::size_t>((pixel[0] + 30) / 60) % 6];
  const auto hues = std::ranges::count_if(
      counts, [&](int count) { return count > kLeastShare * static_cast<double>(hsv.total()); });
  return hues >= kLeastHues;
}

// Chart to photograph: a step of 1 along an edge is one of kSamples samples of a patch. None where
// the patches have not a chart's hues: mcc takes a grid of markers for one, too.
std::optional<Chart> measured(const cv::Mat3b& photograph, const Corners& corners) {
  Chart chart;
  cv::Mat3b medians(4, 6);
  const cv::Mat photograph_from_chart =
      cv::getPerspectiveTransform(Corners{{0, 0}, {kWide, 0}, {kWide, kHigh}, {0, kHigh}}, corners);
  for (std::size_t i = 0; i < chart.light.size(); ++i) {
    const double step = kMiddle / kSamples;
    const double x = kFirst + kStep * static_cast<double>(i % 6) - (kMiddle - step) / 2;
    const double y = kFirst + kStep * static_cast<double>(i / 6) - (kMiddle - step) / 2;
    const cv::Mat chart_from_samples = (cv::Mat_<double>(3, 3) << step, 0, x, 0, step, y, 0, 0, 1);
    cv::Mat3b patch;
    cv::warpPerspective(photograph, patch, photograph_from_chart * chart_from_samples,
                        {kSamples, kSamples}, cv::INTER_NEAREST | cv::WARP_INVERSE_MAP);
    for (int channel = 0; channel < 3; ++channel) {
      std::vector<uchar> levels;
      for (const cv::Vec3b& bgr : patch) levels.push_back(bgr[2 - channel]);
      const uchar level = medianOf(levels);
      medians.begin()[static_cast<std::ptrdiff_t>(i)][2 - channel] = level;
      chart.light[i][channel] = batch::linearLight()[level];
    }
    const auto clipped = std::ranges::count_if(patch, [](const cv::Vec3b& bgr) {
      const uchar most = std::max({bgr[0], bgr[1], bgr[2]});
      return most == 255 || most == 0;
    });
    if (static_cast<double>(clipped) > kMostClipped * static_cast<double>(patch.total()))
      ++chart.clipped;
  }
  return isColourful(medians) ? std::optional(chart) : std::nullopt;
}

}  // namespace

std::optional<Chart> findChart(const cv::Mat3b& photograph) {
  if (!isColourful(photograph)) return std::nullopt;  // mcc takes a hundred times as long
  const double scale = std::min(1.0, 1000.0 / std::min(photograph.cols, photograph.rows));
  const cv::Mat3b small = batch::reducedTo(photograph, cvRound(scale * photograph.cols),
                                           cvRound(scale * photograph.rows));
  std::optional<Chart> best;
  double off = 0;
  for (const int window : {119, 23, 55, 87, 151})
    for (Corners corners : chartsIn(small, window)) {
      for (cv::Point2f& corner : corners) corner /= scale;
      const std::optional<Chart> chart = measured(photograph, corners);
      if (!chart) continue;
      const double now_off = fitted(chart->light).within_95;
      if (!best || now_off < off) best = chart, off = now_off;
      if (correctionBy(*best)) return best;
    }
  return best;
}

}  // namespace ostraka::colour
