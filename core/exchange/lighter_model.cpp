#include "exchange/lighter_model.h"

#include <algorithm>

#include "evaluate/surface.h"
#include "model/model.h"

namespace ostraka::exchange {
namespace {

constexpr int kAttempts = 4;
constexpr std::size_t kOneIn = 1000;

// Measures of LighterModel, from one surface to the other.
void measure(const TriangleMesh& from, const evaluate::Surface& to, LighterModel& lighter) {
  std::vector<double> off_mm;
  off_mm.reserve(from.vertices.size());
  for (const Eigen::Vector3f& vertex : from.vertices)
    off_mm.push_back(to.closest(vertex.cast<double>()).distance_mm);
  const auto most = off_mm.end() - 1 - static_cast<std::ptrdiff_t>(off_mm.size() / kOneIn);
  std::nth_element(off_mm.begin(), most, off_mm.end());
  lighter.deviation_mm = std::max(lighter.deviation_mm, *most);
  lighter.farthest_mm = std::max(lighter.farthest_mm, *std::max_element(most, off_mm.end()));
}

}  // namespace

Result<LighterModel> lighterModel(const TriangleMesh& model, double deviation_mm) {
  const evaluate::Surface whole(model);
  // The collapses are bounded by a mean over planes; one in a thousand lies about twice as far off.
  double bound_mm = deviation_mm / 2;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Result<TriangleMesh> mesh = model::decimated(model, bound_mm);
    if (!mesh) return mesh.error();
    LighterModel lighter{std::move(*mesh)};
    measure(model, evaluate::Surface(lighter.mesh), lighter);
    measure(lighter.mesh, whole, lighter);
    if (lighter.deviation_mm <= deviation_mm) return lighter;
    bound_mm *= std::max(0.25, 0.9 * deviation_mm / lighter.deviation_mm);
  }
  return LighterModel{model};
}

}  // namespace ostraka::exchange
