#include "mask/colour_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/parallel.h"
#include "ground/plate_picture.h"

namespace ostraka::mask {
namespace {

constexpr int kLevels = 22;  // of brightness, a fifth of e each: from log 4 to log 260
constexpr int kTints = 21;   // of each colour difference, 0.06 wide: the noise in dark pixels
constexpr int kLearningRounds = 2;  // the second learns from what the first was in doubt of
constexpr float kMostOdds = 4;  // colours learnt from the odds may outvote a doubt, not a certainty
constexpr float kDoubt = 2;     // odds below are no certainty
constexpr float kFewest = 100;  // pixels that colours are learnt from
constexpr double kShadows = 0.3;  // of the plate close to a sherd that lies in some shadow

struct LogTable {
  std::array<float, 256> values{};
  LogTable() {
    for (int i = 0; i < 256; ++i) values[i] = std::log(static_cast<float>(i) + ground::kDarkLevel);
  }
  cv::Vec3f operator()(const cv::Vec3b& v) const {
    return {values[v[0]], values[v[1]], values[v[2]]};
  }
};

// Calls body(y, x) for each pixel of the group's cells.
template <class Body>
void overGroup(const ColourView& view, int group, const cv::Rect& box, int reduction,
               const Body& body) {
  for (int y = box.y * reduction; y < (box.y + box.height) * reduction; ++y)
    for (int column = box.x; column < box.x + box.width; ++column) {
      if (view.group(y / reduction, column) != group) continue;
      for (int x = column * reduction; x < (column + 1) * reduction; ++x) body(y, x);
    }
}

// boxes[group] in one view's reduced picture.
std::vector<cv::Rect> boxesOf(const cv::Mat1b& groups) {
  std::vector<cv::Rect> boxes(256);
  for (int y = 0; y < groups.rows; ++y)
    for (int x = 0; x < groups.cols; ++x)
      if (groups(y, x) != 0) {
        cv::Rect& box = boxes[groups(y, x)];
        box = box.empty() ? cv::Rect(x, y, 1, 1) : (box | cv::Rect(x, y, 1, 1));
      }
  return boxes;
}

constexpr uchar kPlatesEdge = 128;  // in ColourView::beyond, as onEdges leaves it

// Marks the cells beyond the plate that lie next to it.
void onEdges(cv::Mat1b& beyond) {
  cv::Mat1b far;
  cv::erode(beyond, far, cv::Mat());
  beyond = beyond.clone();
  beyond.setTo(kPlatesEdge, beyond & ~far);
}

bool isBeyond(const ColourView& view, int y, int x) {
  return !view.beyond.empty() && view.beyond(y, x) > kPlatesEdge;
}

bool isPlate(const ColourView& view, int y, int x) {
  return view.beyond.empty() || view.beyond(y, x) == 0;
}

// log P(colour | sherd) / P(colour | plate), before plain plate and before its ink.
using Ratios = std::array<std::vector<float>, 2>;

std::size_t groundOf(const ColourView& view, int y, int x) {
  return !view.ink.empty() && view.ink(y, x) != 0 ? 1 : 0;
}

// From pixels weighted by how likely they are either.
void learn(std::span<const ColourView> views, const std::vector<std::vector<cv::Rect>>& boxes,
           int group, int reduction, bool certain_only, Ratios& ratios, ColourHistogram& sherd) {
  static const LogTable kLogs;
  sherd = ColourHistogram();
  std::array<ColourHistogram, 2> grounds;
  for (std::size_t v = 0; v < views.size(); ++v)
    overGroup(views[v], group, boxes[v][group], reduction, [&](int y, int x) {
      if (!isPlate(views[v], y / reduction, x / reduction)) return;
      const int bin = ColourHistogram::bin(kLogs(views[v].photograph.at<cv::Vec3b>(y, x)));
      const std::size_t ground = groundOf(views[v], y, x);
      const float odds = (*views[v].log_odds)(y, x) + ratios[ground][bin];
      const float share = 1 / (1 + std::exp(-odds));
      if (certain_only && std::abs(odds) < kDoubt) return;
      if (views[v].core(y / reduction, x / reduction) != 0) sherd.add(bin, share);
      grounds[ground].add(bin, 1 - share);
    });
  sherd.finish();
  for (std::size_t g = 0; g < grounds.size(); ++g) {
    grounds[g].addShadows(kShadows);
    grounds[g].finish();
    if (sherd.total() < kFewest || grounds[g].total() < kFewest) continue;
    for (int bin = 0; bin < ColourHistogram::bins(); ++bin)
      ratios[g][bin] =
          std::clamp(std::log(sherd.density(bin) / grounds[g].density(bin)), -kMostOdds, kMostOdds);
  }
}

// What one photograph shows beyond the plate and beside all hulls.
ColourHistogram coloursBeyond(const ColourView& view, int reduction) {
  static const LogTable kLogs;
  ColourHistogram beyond;
  for (int y = 0; y < view.beyond.rows; ++y)
    for (int x = 0; x < view.beyond.cols; ++x)
      if (isBeyond(view, y, x) && view.group(y, x) == 0)
        beyond.add(ColourHistogram::bin(kLogs(view.photograph.at<cv::Vec3b>(
            y * reduction + reduction / 2, x * reduction + reduction / 2))));
  beyond.finish();
  return beyond;
}

void sharpenGroup(std::span<const ColourView> views, std::span<const ColourHistogram> beyond,
                  const std::vector<std::vector<cv::Rect>>& boxes, int group, int reduction) {
  static const LogTable kLogs;
  Ratios ratios;
  ratios.fill(std::vector<float>(static_cast<std::size_t>(ColourHistogram::bins()), 0.F));
  ColourHistogram sherd;
  for (int round = 0; round < kLearningRounds; ++round)
    learn(views, boxes, group, reduction, round == 0, ratios, sherd);
  for (std::size_t v = 0; v < views.size(); ++v) {
    const bool known = sherd.total() >= kFewest && beyond[v].total() >= kFewest;
    overGroup(views[v], group, boxes[v][group], reduction, [&](int y, int x) {
      const int bin = ColourHistogram::bin(kLogs(views[v].photograph.at<cv::Vec3b>(y, x)));
      float& odds = (*views[v].log_odds)(y, x);
      if (isPlate(views[v], y / reduction, x / reduction))
        odds += ratios[groundOf(views[v], y, x)][bin];
      else if (known && isBeyond(views[v], y / reduction, x / reduction))
        odds += std::clamp(std::log(sherd.density(bin) / beyond[v].density(bin)), -kMostOdds,
                           kMostOdds);
    });
  }
}

}  // namespace

ColourHistogram::ColourHistogram() : counts_(static_cast<std::size_t>(bins()), 0.F) {}

int ColourHistogram::bins() {
  return kLevels * kTints * kTints;
}

int ColourHistogram::bin(const cv::Vec3f& log_colour) {
  const float level = (log_colour[0] + log_colour[1] + log_colour[2]) / 3;
  const auto tint = [](float v) {
    return std::clamp(static_cast<int>(std::floor(v / 0.06F + 0.5F * kTints)), 0, kTints - 1);
  };
  const int row = std::clamp(static_cast<int>((level - 1.386F) * 5), 0, kLevels - 1);
  return (row * kTints + tint(log_colour[2] - log_colour[1])) * kTints +
         tint(log_colour[1] - log_colour[0]);
}

void ColourHistogram::addShadows(double share) {
  constexpr int kPlane = kTints * kTints;
  std::vector<float> shadows(counts_.size(), 0.F);
  for (int tint = 0; tint < kPlane; ++tint) {
    float above = 0;  // falls on each level below, spread evenly over them
    for (int level = kLevels - 1; level >= 0; --level) {
      const int i = level * kPlane + tint;
      shadows[i] = above;
      above += static_cast<float>(share) * counts_[i] / static_cast<float>(std::max(1, level));
    }
  }
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += shadows[i];
}

void ColourHistogram::finish() {
  for (const int stride : {1, kTints, kTints * kTints}) {
    const std::vector<float> before = counts_;
    const int length = stride == kTints * kTints ? kLevels : kTints;
    for (int i = 0; i < static_cast<int>(counts_.size()); ++i) {
      const int place = i / stride % length;
      const float left = place > 0 ? before[i - stride] : before[i];
      const float right = place + 1 < length ? before[i + stride] : before[i];
      counts_[i] = 0.25F * left + 0.5F * before[i] + 0.25F * right;
    }
  }
  total_ = 0;
  for (const float count : counts_) total_ += count;
}

float ColourHistogram::density(int bin) const {
  return total_ > 0 ? counts_[bin] / total_ + 1e-4F : 1e-4F;
}

void sharpenByColours(std::span<const ColourView> of_side, int reduction, int threads) {
  std::vector<ColourView> views(of_side.begin(), of_side.end());
  std::vector<std::vector<cv::Rect>> boxes;
  for (ColourView& view : views) {
    boxes.push_back(boxesOf(view.group));
    if (!view.beyond.empty()) onEdges(view.beyond);
  }
  std::vector<ColourHistogram> beyond(views.size());
  parallelFor(views.size(), threads,
              [&](std::size_t v) { beyond[v] = coloursBeyond(views[v], reduction); });
  parallelFor(255, threads, [&](std::size_t i) {
    sharpenGroup(views, beyond, boxes, static_cast<int>(i) + 1, reduction);
  });
}

}  // namespace ostraka::mask
