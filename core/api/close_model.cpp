#include "api/close_model.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "api/checked.h"
#include "base/message.h"
#include "decisions/scan_folder.h"
#include "files/json.h"
#include "model/model.h"

namespace ostraka::api {

namespace {

Eigen::AlignedBox3d boxOf(const PointCloud& cloud, const Eigen::Isometry3d& pose) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& point : cloud.points) box.extend(pose * point.cast<double>());
  return box;
}

// The time that closing takes grows with the room that both scans take up together.
Result<void> checkScans(const PointCloud& front, const PointCloud& back,
                        const Eigen::Isometry3d& front_from_back) {
  if (front.points.empty() || back.points.empty()) return {};  // for closeModel to say
  decisions::ScanFolder fronts, backs;
  fronts.scans = {{"front", front, {}}};
  fronts.files = {"front/0"};
  backs.scans = {{"back", back, {}}};
  backs.files = {"back/0"};
  if (Result<void> unit = decisions::checkUnit(fronts, backs, message("give them in mm")); !unit)
    return unit;
  const Eigen::AlignedBox3d box = boxOf(front, Eigen::Isometry3d::Identity());
  const double apart_mm = box.exteriorDistance(boxOf(back, front_from_back));
  if (apart_mm <= box.diagonal().norm()) return {};
  return Error::unusable(message("The transform puts the back %1 mm away from the front; give one "
                                 "that takes points of the back to the front's frame.",
                                 static_cast<std::int64_t>(std::llround(apart_mm))),
                         "front_from_back");
}

Result<ClosedModel> closed(const PointCloud& given_front, const PointCloud& given_back,
                           const Eigen::Isometry3d& front_from_back, int threads,
                           Progress& progress, const std::stop_token& stop) {
  const Result<PointCloud> front = checkedCloud(given_front, "front"),
                           back = checkedCloud(given_back, "back");
  if (!front) return front.error();
  if (!back) return back.error();
  const Result<Eigen::Isometry3d> rigid =
      rigidTransform(front_from_back.matrix(), "front_from_back");
  if (!rigid) return rigid.error();
  if (const Result<void> good = checkScans(*front, *back, *rigid); !good) return good.error();
  model::ModelOptions options;
  options.threads = threads;
  Result<model::SherdModel> made =
      model::closeModel(*front, *back, *rigid, options, progress, stop);
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
