#include "api/close_model.h"

#include <utility>

#include "model/model.h"

namespace ostraka::api {

Result<ClosedModel> closeModel(const PointCloud& front, const PointCloud& back,
                               const Eigen::Isometry3d& front_from_back, int threads,
                               Progress& progress, std::stop_token stop) {
  model::ModelOptions options;
  options.threads = threads;
  Result<model::SherdModel> made =
      model::closeModel(front, back, front_from_back, options, progress, std::move(stop));
  if (!made) return made.error();
  const model::Measures measures = model::measure(made->mesh);
  ClosedModel closed;
  closed.mesh = std::move(made->mesh);
  closed.filled_share = made->filled_share;
  closed.noise_mm = made->noise_mm;
  closed.length_mm = measures.length_mm;
  closed.width_mm = measures.width_mm;
  closed.thickness_min_mm = measures.thickness_min_mm;
  closed.thickness_mean_mm = measures.thickness_mean_mm;
  closed.thickness_max_mm = measures.thickness_max_mm;
  closed.area_mm2 = measures.area_mm2;
  closed.volume_mm3 = measures.volume_mm3;
  return closed;
}

}  // namespace ostraka::api
