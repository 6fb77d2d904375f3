#include "api/checked.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "cloud/point_cloud.h"

namespace ostraka::api {

Result<PointCloud> checkedCloud(const PointCloud& cloud, const std::string& name) {
  const auto finite = [](const Eigen::Vector3f& v) { return v.allFinite(); };
  const std::size_t count = cloud.size();
  const Error no_normals =
      Error::unusable(message("The scan has no normals; export it with nx, ny and nz."), name);
  if (cloud.normals.size() != count) return no_normals;
  if ((!cloud.colors.empty() && cloud.colors.size() != count) ||
      (!cloud.quality.empty() && cloud.quality.size() != count))
    return Error::unusable(message("The scan's colours or qualities differ in number from its "
                                   "points; give one for each point."),
                           name);
  if (!std::all_of(cloud.points.begin(), cloud.points.end(), finite) ||
      !std::all_of(cloud.normals.begin(), cloud.normals.end(), finite) ||
      !std::ranges::all_of(cloud.quality, [](float quality) { return std::isfinite(quality); }))
    return Error::unusable(
        message("A point, a normal or a quality of the scan is not finite; leave such points out."),
        name);
  PointCloud directed = oriented(cloud);
  if (directed.normals.size() != directed.size()) return no_normals;
  return directed;
}

}  // namespace ostraka::api
