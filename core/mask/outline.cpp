#include "mask/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

#include "batch/photograph.h"

namespace ostraka::mask {
namespace {

// Sky hidden from a vertical break's last pixel above the plate: between a third and a half of it,
// some of which the plate gives back.
constexpr float kFootShade = 0.35F;

// Certain pixels need no node: -1 background, 1 sherd, 0 open.
cv::Mat_<signed char> certainPixels(const cv::Mat1f& log_odds, const cv::Mat1b& allowed) {
  cv::Mat1f least, most;
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
  cv::erode(log_odds, least, window);
  cv::dilate(log_odds, most, window);
  cv::Mat_<signed char> state(log_odds.size(), static_cast<signed char>(0));
  for (int y = 0; y < state.rows; ++y)
    for (int x = 0; x < state.cols; ++x) {
      if (allowed(y, x) == 0 || most(y, x) < -3) state(y, x) = -1;
      if (allowed(y, x) != 0 && least(y, x) > 3) state(y, x) = 1;
    }
  return state;
}

// Mean squared step of the residual between neighbours that may be cut apart.
double meanSquaredStep(const cv::Mat3f& residual, const cv::Mat_<signed char>& state) {
  double sum = 0;
  std::int64_t count = 0;
  for (int y = 0; y < residual.rows; ++y)
    for (int x = 1; x < residual.cols; ++x) {
      if (state(y, x) != 0 || state(y, x - 1) != 0) continue;
      const cv::Vec3f step = residual(y, x) - residual(y, x - 1);
      sum += step.dot(step);
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 1;
}

void removeSmall(cv::Mat1b& cut, double min_area_px) {
  for (const bool holes : {false, true}) {
    cv::Mat1b part = holes ? cv::Mat1b(~cut) : cut;
    cv::Mat labels, stats, centres;
    const int count = cv::connectedComponentsWithStats(part, labels, stats, centres, holes ? 4 : 8);
    for (int y = 0; y < cut.rows; ++y)
      for (int x = 0; x < cut.cols; ++x) {
        const int label = labels.at<int>(y, x);
        if (label > 0 && label < count && stats.at<int>(label, cv::CC_STAT_AREA) < min_area_px)
          cut(y, x) = holes ? 255 : 0;
      }
  }
}

// Mean colour of the masked pixels around each pixel; weight = how many.
void localMean(const cv::Mat3f& colours, const cv::Mat1b& where, int window, cv::Mat3f& mean,
               cv::Mat1f& weight) {
  cv::Mat3f masked(colours.size(), cv::Vec3f::all(0));
  colours.copyTo(masked, where);
  where.convertTo(weight, CV_32F, 1 / 255.0);
  cv::boxFilter(masked, mean, CV_32F, {window, window}, {-1, -1}, false);
  cv::boxFilter(weight, weight, CV_32F, {window, window}, {-1, -1}, false);
  for (int y = 0; y < mean.rows; ++y)
    for (int x = 0; x < mean.cols; ++x) mean(y, x) *= 1 / std::max(1.F, weight(y, x));
}

/// How the colours beside the cut are taken.
struct Sides {
  int window = 9;         ///< pixels
  float foot = 0;         ///< how much darker a sherd is along its foot than beside it
  cv::Vec2f up = {0, 0};  ///< see refineOutline
};

// The sherd's colour at the very outline: where it meets the plate half of the sky is hidden from
// its last pixel; along its upper edge, with the plate far behind, it is as light as beside it.
void shadeFoot(const cv::Mat1f& inside, const cv::Mat1f& outside, const Sides& sides,
               cv::Mat3f& sherd) {
  cv::Mat1f away = outside - inside, across, along;
  cv::GaussianBlur(away, away, {}, 2, 2);
  cv::Sobel(away, across, CV_32F, 1, 0);
  cv::Sobel(away, along, CV_32F, 0, 1);
  for (int y = 0; y < sherd.rows; ++y)
    for (int x = 0; x < sherd.cols; ++x) {
      if (inside(y, x) > 4 || outside(y, x) > 4) continue;
      const cv::Vec2f normal(across(y, x), along(y, x));
      const float level = std::max(0.F, normal.dot(sides.up)) /
                          std::max(1e-3F, static_cast<float>(cv::norm(normal)));
      sherd(y, x) *= 1 - sides.foot * (1 - std::min(level, 1.F));
    }
}

// The share of sherd in each pixel close to the cut, between the colours of sherd and background
// next to it.
cv::Mat1f sharesAlong(const cv::Mat1b& cut, const cv::Mat3f& colours, const Sides& sides) {
  cv::Mat1f inside, outside;  // distance to the first pixel of the other side
  cv::distanceTransform(cut, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::distanceTransform(~cut, outside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const cv::Mat1b band = (inside < 2.5) & (outside < 2.5);
  cv::Mat3f sherd, ground;
  cv::Mat1f sherd_count, ground_count, share;
  // Beyond the lens's blur of the edge, and no farther: a broken face is a few pixels wide, and a
  // shadow darkens towards the contact.
  localMean(colours, (inside > 1.6) & (inside < 3.2), sides.window, sherd, sherd_count);
  localMean(colours, (outside > 1.6) & (outside < 3.2), sides.window, ground, ground_count);
  if (sides.foot > 0) shadeFoot(inside, outside, sides, sherd);
  cut.convertTo(share, CV_32F, 1 / 255.0);
  cv::GaussianBlur(share, share, {}, 0.7, 0.7);
  for (int y = 0; y < cut.rows; ++y)
    for (int x = 0; x < cut.cols; ++x) {
      if (band(y, x) == 0 || sherd_count(y, x) < 3 || ground_count(y, x) < 3) continue;
      const cv::Vec3f contrast = sherd(y, x) - ground(y, x);
      // Noise in linear light: some 8 % of the colour (grain of clay and sensor) and a level of
      // 255.
      const float noise = 0.08F * static_cast<float>(cv::norm(sherd(y, x) + ground(y, x))) + 0.003F;
      const float strength = contrast.dot(contrast);
      const float own = std::clamp(
          (colours(y, x) - ground(y, x)).dot(contrast) / std::max(strength, 1e-9F), 0.F, 1.F);
      const float trust = strength / (strength + noise * noise);
      share(y, x) = trust * own + (1 - trust) * share(y, x);
    }
  return share;
}

cv::Mat1b softenPart(const cv::Mat1b& cut, const cv::Mat& photograph, const Sides& sides) {
  const std::array<double, 256>& light = batch::linearLight();
  cv::Mat3f colours(cut.size());
  for (int y = 0; y < cut.rows; ++y)
    for (int x = 0; x < cut.cols; ++x) {
      const cv::Vec3b& v = photograph.at<cv::Vec3b>(y, x);
      colours(y, x) = cv::Vec3d(light[v[0]], light[v[1]], light[v[2]]);
    }
  cv::Mat1b soft;
  sharesAlong(cut, colours, sides).convertTo(soft, CV_8U, 255);
  return soft;
}

cv::Mat1b soften(const cv::Mat1b& cut, const cv::Mat& photograph, const Sides& sides) {
  cv::Mat1b soft(cut.size(), uchar{0});
  const cv::Rect box = cv::boundingRect(cut);
  if (box.empty()) return soft;
  const cv::Rect wide(box.x - 12, box.y - 12, box.width + 24, box.height + 24);
  const cv::Rect part = wide & cv::Rect({0, 0}, cut.size());
  softenPart(cut(part), photograph(part), sides).copyTo(soft(part));
  return soft;
}

}  // namespace

cv::Mat1b cutOutline(const cv::Mat1f& log_odds, const cv::Mat1b& allowed, const cv::Mat3f& residual,
                     const CutOptions& options) {
  const cv::Mat_<signed char> state = certainPixels(log_odds, allowed);
  const double beta = 1 / (2 * std::max(1e-8, meanSquaredStep(residual, state)));
  cv::Mat1b cut(log_odds.size(), uchar{0});
  cv::Mat1i node(log_odds.size(), -1);
  int nodes = 0;
  for (int y = 0; y < state.rows; ++y)
    for (int x = 0; x < state.cols; ++x) {
      if (state(y, x) == 0) node(y, x) = nodes++;
      if (state(y, x) > 0) cut(y, x) = 255;
    }
  cv::detail::GCGraph<float> graph(nodes + 2, 8 * nodes + 16);
  for (int i = 0; i < nodes; ++i) graph.addVtx();
  constexpr int kNeighbour[8][2] = {{1, 0},  {0, 1},  {1, 1},   {-1, 1},
                                    {-1, 0}, {0, -1}, {-1, -1}, {1, -1}};
  for (int y = 0; y < state.rows; ++y)
    for (int x = 0; x < state.cols; ++x) {
      const int i = node(y, x);
      if (i < 0) continue;
      float source = std::max(0.F, log_odds(y, x)), sink = std::max(0.F, -log_odds(y, x));
      for (int k = 0; k < 8; ++k) {
        const int xn = x + kNeighbour[k][0], yn = y + kNeighbour[k][1];
        if (xn < 0 || yn < 0 || xn >= state.cols || yn >= state.rows) continue;
        const cv::Vec3f step = residual(yn, xn) - residual(y, x);
        const double length = kNeighbour[k][0] != 0 && kNeighbour[k][1] != 0 ? M_SQRT1_2 : 1;
        // Eight neighbours measure a length of outline about 2.4 times over.
        const auto weight = static_cast<float>(options.smoothness / 2.4 * length *
                                               (0.05 + 0.95 * std::exp(-beta * step.dot(step))));
        const int j = node(yn, xn);
        if (j < 0)
          (state(yn, xn) > 0 ? source : sink) += weight;
        else if (k < 4)
          graph.addEdges(i, j, weight, weight);
      }
      graph.addTermWeights(i, source, sink);
    }
  if (nodes > 0) graph.maxFlow();
  for (int y = 0; y < state.rows; ++y)
    for (int x = 0; x < state.cols; ++x)
      if (node(y, x) >= 0 && graph.inSourceSegment(node(y, x))) cut(y, x) = 255;
  removeSmall(cut, options.min_area_px);
  return cut;
}

cv::Mat1b settleStrips(const cv::Mat1b& surely, const cv::Mat1b& perhaps, double strip_px,
                       const cv::Mat3f& residual, const CutOptions& options) {
  constexpr float kSettled = 8;  // log odds that no neighbour outweighs
  const int strip = cvRound(strip_px) | 1;
  cv::Mat1b wide;
  cv::morphologyEx(perhaps & ~surely, wide, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {strip, strip}));
  cv::Mat1f log_odds(perhaps.size(), -kSettled);
  log_odds.setTo(0, perhaps);
  log_odds.setTo(kSettled, (surely & perhaps) | wide);
  return cutOutline(log_odds, perhaps, residual, options);
}

cv::Mat1b softenOutline(const cv::Mat1b& cut, const cv::Mat& photograph) {
  return soften(cut, photograph, {});
}

cv::Mat1b refineOutline(const cv::Mat1b& soft, const cv::Mat& photograph, const cv::Vec2f& up) {
  // Narrow: clay changes its colour along the outline, and now the sides' places are known.
  return soften(soft >= 128, photograph, {5, kFootShade, up});
}

}  // namespace ostraka::mask
