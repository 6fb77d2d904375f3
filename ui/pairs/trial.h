#pragma once
#include <Eigen/Geometry>

namespace ostraka::ui {

/// How the pose on trial came about.
enum class Made { Program, StartPoint, ByHand, Settled };

/// What a person tries on a front at the moment: a back at a pose. A value that undo can put back.
/// Without a front: a back that no front holds is in hand.
struct Trial {
  int front = -1, back = -1;
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  Made made = Made::Program;
  int shift = -1;  ///< start point on the back's contour, of 200
};

}  // namespace ostraka::ui
