#include "texture/seams.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/parallel.h"

namespace ostraka::texture {
namespace {

using Eigen::Vector2d;
using Sparse = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

constexpr double kApart = 0.01;  // texels: places of one edge within a chart differ by rounding
constexpr int kReach = 16;       // texels: where a correction ends
// Weights of a correction's slope and of the pull towards none, beside the step at a place.
constexpr double kSmoothCorrection = 0.03, kNoCorrection = 3e-4;
constexpr int kRounds = 200;
constexpr double kPrecision = 1e-3;  // of the steps that are there

// The four texels that a place is read from.
struct Footprint {
  std::array<cv::Point, 4> texels;
  std::array<double, 4> weights;
};

Footprint footprintOf(const Vector2d& place, const cv::Size& page) {
  const double x = std::clamp(place.x(), 0.0, page.width - 1.0),
               y = std::clamp(place.y(), 0.0, page.height - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, page.width - 1), y1 = std::min(y0 + 1, page.height - 1);
  const double fx = x - x0, fy = y - y0;
  return {{cv::Point(x0, y0), {x1, y0}, {x0, y1}, {x1, y1}},
          {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

// All that lies in a chart; what lies beside it is filled in anyway.
bool isSeen(const Footprint& footprint, const cv::Mat1i& faces, const cv::Mat1b& seen) {
  bool any = false;
  for (const cv::Point& texel : footprint.texels) {
    if (faces(texel) < 0) continue;
    if (seen(texel) == 0) return false;
    any = true;
  }
  return any;
}

std::vector<std::pair<Footprint, Footprint>> footprintsOf(const std::vector<Seam>& seams,
                                                          const cv::Mat1i& faces,
                                                          const cv::Mat1b& seen) {
  std::vector<std::pair<Footprint, Footprint>> found;
  for (const Seam& seam : seams)
    for (const auto& [a, b] : placesAlong(seam)) {
      const Footprint one = footprintOf(a, seen.size()), other = footprintOf(b, seen.size());
      if (isSeen(one, faces, seen) && isSeen(other, faces, seen)) found.emplace_back(one, other);
    }
  return found;
}

// The texels that may change.
struct Band {
  cv::Mat1i index;  // -1: stays
  std::vector<cv::Point> texels;
};

Band bandOf(const std::vector<std::pair<Footprint, Footprint>>& places, const cv::Mat1i& faces) {
  cv::Mat1b read = cv::Mat1b::zeros(faces.size()), near;
  for (const auto& [one, other] : places)
    for (const Footprint* side : {&one, &other})
      for (const cv::Point& texel : side->texels) read(texel) = 255;
  cv::dilate(read, near,
             cv::getStructuringElement(cv::MORPH_RECT, {2 * kReach + 1, 2 * kReach + 1}));
  Band band{cv::Mat1i(faces.size(), -1), {}};
  for (int y = 0; y < faces.rows; ++y)
    for (int x = 0; x < faces.cols; ++x)
      if (read(y, x) != 0 || (near(y, x) != 0 && faces(y, x) >= 0)) {
        band.index(y, x) = static_cast<int>(band.texels.size());
        band.texels.emplace_back(x, y);
      }
  return band;
}

// Level on one side less that on the other, by place and texel.
Sparse stepsOver(const std::vector<std::pair<Footprint, Footprint>>& places, const Band& band) {
  Entries entries;
  entries.reserve(8 * places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [one, other] = places[i];
      entries.emplace_back(static_cast<int>(i), band.index(one.texels[k]), one.weights[k]);
      entries.emplace_back(static_cast<int>(i), band.index(other.texels[k]), -other.weights[k]);
    }
  Sparse steps(static_cast<Eigen::Index>(places.size()),
               static_cast<Eigen::Index>(band.texels.size()));
  steps.setFromTriplets(entries.begin(), entries.end());
  return steps;
}

// Corrections are small and change little from texel to texel, to none where the band ends.
Sparse calm(const Band& band, const cv::Mat1i& faces) {
  Entries entries;
  entries.reserve(5 * band.texels.size());
  for (std::size_t i = 0; i < band.texels.size(); ++i) {
    double own = kNoCorrection;
    for (const cv::Point& by :
         {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      const cv::Point beside = band.texels[i] + by;
      if (!cv::Rect({}, faces.size()).contains(beside)) continue;
      const int other = band.index(beside);
      if (other < 0 && faces(beside) < 0) continue;
      own += kSmoothCorrection;
      if (other >= 0) entries.emplace_back(static_cast<int>(i), other, -kSmoothCorrection);
    }
    entries.emplace_back(static_cast<int>(i), static_cast<int>(i), own);
  }
  const auto count = static_cast<Eigen::Index>(band.texels.size());
  Sparse matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

std::vector<Seam> seamsOf(const TriangleMesh& mesh, const std::vector<Chart>& charts,
                          const Atlas& atlas) {
  struct Half {
    std::pair<int, int> edge;  // vertices, the lower one first
    Seam::Line line;
  };
  std::vector<Half> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::size_t c = 0; c < charts.size(); ++c)
    for (std::size_t i = 0; i < charts[c].faces.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& t = mesh.triangles[static_cast<std::size_t>(charts[c].faces[i])];
        const std::size_t next = (k + 1) % 3;
        const bool rises = t[k] < t[next];
        const std::size_t from = rises ? k : next, to = rises ? next : k;
        halves.push_back({{t[from], t[to]},
                          {atlas.onPage(charts[c], c, charts[c].corners[i][from]),
                           atlas.onPage(charts[c], c, charts[c].corners[i][to])}});
      }
  std::ranges::stable_sort(halves, {}, &Half::edge);
  const auto apart = [](const Seam::Line& a, const Seam::Line& b) {
    return std::max((a[0] - b[0]).norm(), (a[1] - b[1]).norm()) > kApart;
  };
  std::vector<Seam> seams;
  for (std::size_t i = 0; i + 1 < halves.size(); ++i)
    if (halves[i].edge == halves[i + 1].edge && apart(halves[i].line, halves[i + 1].line))
      seams.push_back({halves[i].line, halves[i + 1].line});
  return seams;
}

std::vector<std::pair<Vector2d, Vector2d>> placesAlong(const Seam& seam) {
  const double longer =
      std::max((seam.one[1] - seam.one[0]).norm(), (seam.other[1] - seam.other[0]).norm());
  const int count = std::max(1, static_cast<int>(std::ceil(2 * longer)));
  std::vector<std::pair<Vector2d, Vector2d>> places;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    places.emplace_back((1 - t) * seam.one[0] + t * seam.one[1],
                        (1 - t) * seam.other[0] + t * seam.other[1]);
  }
  return places;
}

void levelSeams(cv::Mat3f& page, const cv::Mat1i& faces, const cv::Mat1b& seen,
                const std::vector<Seam>& seams, int threads) {
  const auto places = footprintsOf(seams, faces, seen);
  if (places.empty()) return;
  const Band band = bandOf(places, faces);
  const Sparse steps = stepsOver(places, band);
  const Sparse matrix = Sparse(steps.transpose() * steps) + calm(band, faces);
  parallelFor(3, threads, [&](std::size_t channel) {
    const int k = static_cast<int>(channel);
    Eigen::VectorXd levels(static_cast<Eigen::Index>(band.texels.size()));
    for (Eigen::Index i = 0; i < levels.size(); ++i)
      levels[i] = static_cast<double>(page(band.texels[static_cast<std::size_t>(i)])[k]);
    Eigen::ConjugateGradient<Sparse, Eigen::Lower | Eigen::Upper> solver(matrix);
    solver.setMaxIterations(kRounds);
    solver.setTolerance(kPrecision);
    const Eigen::VectorXd wanted = -(steps.transpose() * (steps * levels));
    const Eigen::VectorXd correction = solver.solve(wanted);
    for (Eigen::Index i = 0; i < levels.size(); ++i)
      page(band.texels[static_cast<std::size_t>(i)])[k] += static_cast<float>(correction[i]);
  });
}

}  // namespace ostraka::texture
