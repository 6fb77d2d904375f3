#include "model/indicator.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "base/parallel.h"
#include "cloud/bounds.h"

namespace ostraka::model {
namespace {

using Eigen::Array3f;
using Eigen::Array3i;
using Eigen::Vector3f;

constexpr int kLevels = 4;           // 8 cells to 1
constexpr int kRoundsPerLevel = 60;  // at most

// Adds w times the eight corners' weights of a point given in cells.
void splat(std::vector<float>& values, const Array3i& size, const Array3f& at, float w) {
  const Array3i base = at.floor().cast<int>().max(0).min(size - 2);
  const Array3f f = at - base.cast<float>();
  for (int k = 0; k < 8; ++k) {
    const int x = k & 1, y = (k >> 1) & 1, z = k >> 2;
    const float part = (x ? f[0] : 1 - f[0]) * (y ? f[1] : 1 - f[1]) * (z ? f[2] : 1 - f[2]);
    const std::size_t node =
        (static_cast<std::size_t>(base[2] + z) * size[1] + (base[1] + y)) * size[0] + (base[0] + x);
    values[node] += w * part;
  }
}

// h^2 times the divergence of the surfels' field at the nodes; the field's x lives half a cell to
// the right of its node, y and z likewise, so that a plane gives a jump of exactly 1.
std::vector<float> rightSide(const Surfels& s, const Grid& grid) {
  std::vector<float> total(grid.values.size(), 0.0f), field(grid.values.size());
  const float h = grid.cell_mm;
  const std::size_t stride[3] = {1, static_cast<std::size_t>(grid.size[0]),
                                 static_cast<std::size_t>(grid.size[0]) * grid.size[1]};
  for (int axis = 0; axis < 3; ++axis) {
    std::fill(field.begin(), field.end(), 0.0f);
    for (std::size_t i = 0; i < s.size(); ++i) {
      Array3f at = (s.points[i] - grid.origin).array() / h;
      at[axis] -= 0.5f;
      splat(field, grid.size, at, s.area[i] * s.normals[i][axis] / (h * h));
    }
    for (std::size_t k = stride[axis]; k < field.size(); ++k)
      total[k] += field[k] - field[k - stride[axis]];
  }
  return total;
}

// Layers of the grid, in parallel; sums are added in the layers' order.
class Laplacian {
 public:
  Laplacian(const Array3i& size, int threads)
      : size_(size), threads_(threads), partial_(static_cast<std::size_t>(size[2])) {}

  // out = A in, returns in . out; A is minus the Laplacian times h^2, zero on the border.
  double apply(const std::vector<float>& in, std::vector<float>& out) {
    return layers([&](int z, std::size_t begin) {
      double sum = 0;
      const std::size_t row = static_cast<std::size_t>(size_[0]),
                        layer = row * static_cast<std::size_t>(size_[1]);
      if (z == 0 || z == size_[2] - 1) return sum;
      for (int y = 1; y + 1 < size_[1]; ++y) {
        const std::size_t from = begin + static_cast<std::size_t>(y) * row;
        float line = 0;
        for (std::size_t k = from + 1; k + 1 < from + row; ++k) {
          out[k] = 6 * in[k] - (in[k - 1] + in[k + 1]) - (in[k - row] + in[k + row]) -
                   (in[k - layer] + in[k + layer]);
          line += in[k] * out[k];
        }
        sum += line;
      }
      return sum;
    });
  }

  // body(layer, index of its first node) -> its part of the sum
  template <class Body>
  double layers(const Body& body) {
    const std::size_t layer =
        static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]);
    parallelFor(partial_.size(), threads_,
                [&](std::size_t z) { partial_[z] = body(static_cast<int>(z), z * layer); });
    double sum = 0;
    for (const double p : partial_) sum += p;
    return sum;
  }

  std::size_t layerSize() const {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]);
  }

 private:
  Array3i size_;
  int threads_;
  std::vector<double> partial_;
};

void clearBorder(std::vector<float>& values, const Array3i& size) {
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x)
        if (x == 0 || y == 0 || z == 0 || x == size[0] - 1 || y == size[1] - 1 || z == size[2] - 1)
          values[(static_cast<std::size_t>(z) * size[1] + y) * size[0] + x] = 0;
}

// Conjugate gradients on A chi = right, from chi as it is.
bool solve(std::vector<float>& chi, const std::vector<float>& right, const Array3i& size,
           int threads, std::stop_token stop) {
  Laplacian a(size, threads);
  const std::size_t n = a.layerSize();
  std::vector<float> residual(chi.size(), 0.0f), direction(chi.size()), image(chi.size(), 0.0f);
  a.apply(chi, image);
  double rr = a.layers([&](int, std::size_t b) {
    double sum = 0;
    for (std::size_t k = b; k < b + n; ++k) {
      residual[k] = right[k] - image[k];
      sum += static_cast<double>(residual[k]) * residual[k];
    }
    return sum;
  });
  const double start = rr;
  direction = residual;
  for (int round = 0; round < kRoundsPerLevel && rr > 1e-6 * start && rr > 0; ++round) {
    if (stop.stop_requested()) return false;
    const double step_d = rr / a.apply(direction, image);
    const float step = static_cast<float>(step_d);
    const double next = a.layers([&](int, std::size_t b) {
      double sum = 0;
      for (std::size_t k = b; k < b + n; ++k) {
        chi[k] += step * direction[k];
        residual[k] -= step * image[k];
        sum += static_cast<double>(residual[k]) * residual[k];
      }
      return sum;
    });
    const float turn = static_cast<float>(next / rr);
    a.layers([&](int, std::size_t b) {
      for (std::size_t k = b; k < b + n; ++k) direction[k] = residual[k] + turn * direction[k];
      return 0.0;
    });
    rr = next;
  }
  return true;
}

}  // namespace

float Grid::interpolated(const Vector3f& p) const {
  const Array3f at = ((p - origin).array() / cell_mm).max(0.0f).min((size - 1).cast<float>());
  const Array3i b = at.cast<int>().min(size - 2);
  const Array3f f = at - b.cast<float>();
  const std::size_t k = this->at(b[0], b[1], b[2]);
  const std::size_t row = static_cast<std::size_t>(size[0]),
                    layer = row * static_cast<std::size_t>(size[1]);
  const auto line = [&](std::size_t i) { return values[i] + f[0] * (values[i + 1] - values[i]); };
  const float low = line(k) + f[1] * (line(k + row) - line(k));
  const float high = line(k + layer) + f[1] * (line(k + layer + row) - line(k + layer));
  return low + f[2] * (high - low);
}

Result<Grid> indicator(const Surfels& surfels, float cell_mm, int threads, std::stop_token stop) {
  const auto [low, high] = boundsOf(surfels.points);
  Grid coarse;
  for (int level = kLevels - 1; level >= 0; --level) {
    Grid grid;
    grid.cell_mm = cell_mm * static_cast<float>(1 << level);
    const float margin = std::max(kMargin_mm, 3 * grid.cell_mm);
    grid.origin = low.array() - margin;
    const Array3f cells = ((high - low).array() + 2 * margin) / grid.cell_mm;
    if (cells.prod() > 2.6e8f)
      return Error::notEnough(
          message("The scan is too large for a model at this spacing; use a larger spacing."));
    grid.size = cells.ceil().cast<int>() + 1;
    grid.values.assign(static_cast<std::size_t>(grid.size[0]) * grid.size[1] * grid.size[2], 0.0f);
    std::vector<float> right = rightSide(surfels, grid);
    // Fields of normals point outward while chi grows inward: A chi = -h^2 lap(chi) = h^2 div(n).
    clearBorder(right, grid.size);
    if (!coarse.values.empty())
      for (int z = 1; z + 1 < grid.size[2]; ++z)
        for (int y = 1; y + 1 < grid.size[1]; ++y)
          for (int x = 1; x + 1 < grid.size[0]; ++x)
            grid.values[grid.at(x, y, z)] = coarse.interpolated(grid.node(x, y, z));
    if (!solve(grid.values, right, grid.size, threads, stop)) return Error::cancelled();
    coarse = std::move(grid);
  }
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    sum += static_cast<double>(surfels.area[i]) * coarse.interpolated(surfels.points[i]);
    weight += surfels.area[i];
  }
  coarse.level = static_cast<float>(sum / weight);
  for (float& v : coarse.values) v -= coarse.level;
  return coarse;
}

Result<Grid> trustedIndicator(Surfels& surfels, float cell_mm, int threads, std::stop_token stop) {
  constexpr int kRounds = 3;
  for (int round = 0;; ++round) {
    Result<Grid> grid = indicator(surfels, cell_mm, threads, stop);
    if (!grid || round == kRounds) return grid;
    // Fins lower everything around them: the bounds are relative to the usual level, and the
    // first round takes out only the worst.
    const float low = (round == 0 ? 0.4f : 0.5f) * grid->level, high = 0.5f + 0.75f * grid->level;
    std::vector<int> kept;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
      const float chi = grid->interpolated(surfels.points[i]) + grid->level;
      if (chi > low && chi < high) kept.push_back(static_cast<int>(i));
    }
    // Where half of everything would go, the scans are no closed body and the test means nothing.
    if (kept.size() == surfels.size() || kept.size() < surfels.size() / 2) return grid;
    surfels.keep(kept);
  }
}

}  // namespace ostraka::model
