#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::scan {

/// One sherd seen from one side.
struct Scan {
  std::string id;    ///< f001, b003 ... or the file's name without ending
  PointCloud cloud;  ///< mm, in its side's plate frame (or the scanner's own frame)
  std::vector<std::uint8_t>
      fracture;  ///< per point: 1 = on the strip of broken edge; empty = not known
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< unit, towards the viewer, frame of the cloud
};

}  // namespace ostraka::scan
