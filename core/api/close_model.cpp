#include "api/close_model.h"

#include <utility>

#include "api/checked.h"
#include "model/model.h"

namespace ostraka::api {

namespace {

Result<ClosedModel> closed(const PointCloud& front, const PointCloud& back,
                           const Eigen::Isometry3d& front_from_back, int threads,
                           Progress& progress, const std::stop_token& stop) {
  if (const Result<void> good = checkCloud(front, "front"); !good) return good.error();
  if (const Result<void> good = checkCloud(back, "back"); !good) return good.error();
  model::ModelOptions options;
  options.threads = threads;
  Result<model::SherdModel> made =
      model::closeModel(front, back, front_from_back, options, progress, stop);
  if (!made) return made.error();
  const model::Measures measures = model::measure(made->mesh);
  ClosedModel whole;
  whole.mesh = std::move(made->mesh);
  whole.filled_share = made->filled_share;
  whole.noise_mm = made->noise_mm;
  whole.length_mm = measures.length_mm;
  whole.width_mm = measures.width_mm;
  whole.thickness_min_mm = measures.thickness_min_mm;
  whole.thickness_mean_mm = measures.thickness_mean_mm;
  whole.thickness_max_mm = measures.thickness_max_mm;
  whole.area_mm2 = measures.area_mm2;
  whole.volume_mm3 = measures.volume_mm3;
  return whole;
}

}  // namespace

Result<ClosedModel> closeModel(const PointCloud& front, const PointCloud& back,
                               const Eigen::Isometry3d& front_from_back, int threads,
                               Progress& progress, std::stop_token stop) {
  return withoutExceptions(
      [&] { return closed(front, back, front_from_back, threads, progress, stop); });
}

}  // namespace ostraka::api
