#include "evaluate/masks.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "base/limits.h"
#include "base/median.h"
#include "batch/photograph.h"
#include "files/files.h"
#include "images/decode.h"

namespace ostraka::evaluate {
namespace {

constexpr double kInside = 127.5;
constexpr int kReach_px = 20;  // farther edges count as this far

struct EdgePoint {
  float x, y;
};

// Levels with labels raised to 255, so that the same threshold holds for both kinds of mask.
std::vector<float> levelsOf(const MaskImage& mask, bool labels) {
  std::vector<float> levels(mask.levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i] = labels ? (mask.levels[i] ? 255.0f : 0.0f) : static_cast<float>(mask.levels[i]);
  return levels;
}

struct Grid {
  int width, height;
  std::vector<float> levels;
  float at(int x, int y) const { return levels[static_cast<std::size_t>(y) * width + x]; }
  bool inside(int x, int y) const { return at(x, y) > static_cast<float>(kInside); }
  /// The crossing between a pixel and its right (or lower) neighbour, when there is one.
  std::optional<EdgePoint> crossing(int x, int y, bool right) const {
    const int nx = right ? x + 1 : x, ny = right ? y : y + 1;
    if (nx >= width || ny >= height || inside(x, y) == inside(nx, ny)) return {};
    const float a = at(x, y), b = at(nx, ny);
    const float t = (static_cast<float>(kInside) - a) / (b - a);
    const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
    return right ? EdgePoint{fx + t, fy} : EdgePoint{fx, fy + t};
  }
};

double distanceToSegment(const EdgePoint& p, const EdgePoint& a, const EdgePoint& b) {
  const double ex = b.x - a.x, ey = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double length = ex * ex + ey * ey;
  const double t = length > 0 ? std::clamp((px * ex + py * ey) / length, 0.0, 1.0) : 0;
  return std::hypot(px - t * ex, py - t * ey);
}

// The outline within one cell of 2x2 pixels whose upper left is (x, y): its crossings in a ring.
void cellSegments(const Grid& grid, int x, int y, const EdgePoint& p, double& best) {
  const std::optional<EdgePoint> sides[4] = {
      grid.crossing(x, y, true), grid.crossing(x + 1, y, false), grid.crossing(x, y + 1, true),
      grid.crossing(x, y, false)};
  for (int i = 0; i < 4; ++i)
    for (int k = i + 1; k < 4; ++k)
      if (sides[i] && sides[k]) best = std::min(best, distanceToSegment(p, *sides[i], *sides[k]));
}

// Cells that hold a piece of the outline, for each row of cells the columns in order.
std::vector<std::vector<int>> edgeCells(const Grid& grid) {
  std::vector<std::vector<int>> rows(std::max(0, grid.height - 1));
  for (int y = 0; y + 1 < grid.height; ++y)
    for (int x = 0; x + 1 < grid.width; ++x) {
      const int sum = grid.inside(x, y) + grid.inside(x + 1, y) + grid.inside(x, y + 1) +
                      grid.inside(x + 1, y + 1);
      if (sum != 0 && sum != 4) rows[y].push_back(x);
    }
  return rows;
}

double distanceToOutline(const Grid& grid, const std::vector<std::vector<int>>& cells,
                         const EdgePoint& p) {
  double best = kReach_px;
  const int row = static_cast<int>(p.y);
  for (int step = 0; step <= kReach_px + 1; ++step) {
    if (step > best + 1) break;  // a cell reaches one pixel beyond its row
    for (const int y : {row - step, row + step}) {
      if (y < 0 || y >= static_cast<int>(cells.size()) || (step == 0 && y != row)) continue;
      const auto first = std::lower_bound(cells[y].begin(), cells[y].end(),
                                          static_cast<int>(std::floor(p.x - best)) - 1);
      for (auto x = first; x != cells[y].end() && *x <= p.x + best; ++x)
        cellSegments(grid, *x, y, p, best);
    }
  }
  return best;
}

std::vector<double> sizes(const std::vector<float>& values) {
  std::vector<double> found;
  for (const float x : values) found.push_back(std::abs(x));
  return found;
}

}  // namespace

Result<MaskImage> readMask(const std::filesystem::path& file) {
  const Result<std::string> bytes = readFile(file, limits::kImageBytes.most);
  if (!bytes) return bytes.error();
  const Result<cv::Mat> image =
      images::decodeImage(*bytes, images::Values::AsStored, file.string());
  if (!image) return image.error();
  if (image->type() != CV_8UC1)
    return Error::unusable("The mask is not 8-bit grey.", file.string());
  return MaskImage{image->cols, image->rows, {image->begin<uchar>(), image->end<uchar>()}};
}

void MaskFigures::add(const MaskFigures& other) {
  both += other.both;
  either += other.either;
  edge_px.insert(edge_px.end(), other.edge_px.begin(), other.edge_px.end());
}

double MaskFigures::intersectionOverUnion() const {
  return either == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(either);
}

double MaskFigures::edgeBias_px() const {
  return rankedAt(edge_px, 0.5);
}

double MaskFigures::edgeMean_px() const {
  double sum = 0;
  for (const float x : edge_px) sum += std::abs(x);
  return edge_px.empty() ? 0 : sum / static_cast<double>(edge_px.size());
}

double MaskFigures::edgeWithin95_px() const {
  return rankedAt(sizes(edge_px), 0.95);
}

Result<MaskFigures> evaluateMask(const MaskImage& found, const MaskImage& truth) {
  if (found.width != truth.width || found.height != truth.height)
    return Error::unusable("The mask is " + std::to_string(found.width) + "x" +
                           std::to_string(found.height) + " pixels, the true one " +
                           std::to_string(truth.width) + "x" + std::to_string(truth.height) + ".");
  const Grid mine{found.width, found.height, levelsOf(found, false)};
  const Grid real{truth.width, truth.height, levelsOf(truth, true)};
  const std::vector<std::vector<int>> cells = edgeCells(real);
  MaskFigures figures;
  for (int y = 0; y < mine.height; ++y)
    for (int x = 0; x < mine.width; ++x) {
      figures.both += mine.inside(x, y) && real.inside(x, y);
      figures.either += mine.inside(x, y) || real.inside(x, y);
      for (const bool right : {true, false}) {
        const std::optional<EdgePoint> edge = mine.crossing(x, y, right);
        if (!edge) continue;
        const double distance = distanceToOutline(real, cells, *edge);
        const bool in_truth =
            real.inside(std::clamp(static_cast<int>(std::lround(edge->x)), 0, real.width - 1),
                        std::clamp(static_cast<int>(std::lround(edge->y)), 0, real.height - 1));
        figures.edge_px.push_back(static_cast<float>(in_truth ? -distance : distance));
      }
    }
  return figures;
}

}  // namespace ostraka::evaluate
