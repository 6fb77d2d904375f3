#pragma once
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "rendering/prop.h"
#include "vessels/sherd.h"

namespace ostraka::rendering {

/// mm off a surface, so that a ray does not meet its own triangle.
inline constexpr float kLift = 0.03f;

/// Sherds as they lie on one side of a batch, and what lies beside them, ready for rays. Everything
/// in the plate's frame, mm. Bodies count on: the sherds, then the props.
class Scene {
 public:
  struct Hit {
    int body = -1;  ///< -1: nothing
    int triangle = 0;
    float u = 0, v = 0;  ///< weights of the triangle's second and third corner
    float distance = 0;
  };

  /// plate_from_model: one pose per sherd.
  Scene(const std::vector<vessels::VirtualSherd>& sherds,
        const std::vector<Eigen::Isometry3d>& plate_from_model, std::vector<Prop> props = {});
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  Hit nearest(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;
  /// Anything within `reach` times the direction's length.
  bool blocked(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) const;

  const std::vector<vessels::VirtualSherd>& sherds() const { return sherds_; }
  const std::vector<Prop>& props() const { return props_; }
  int bodies() const { return static_cast<int>(sherds_.size() + props_.size()); }
  bool isSherd(int body) const { return body < static_cast<int>(sherds_.size()); }
  const Prop& prop(int body) const { return props_[body - sherds_.size()]; }
  /// The same corners as `vertices`; of sherds in the model's frame.
  const TriangleMesh& mesh(int body) const {
    return isSherd(body) ? sherds_[body].mesh : prop(body).mesh;
  }
  /// Mean albedo.
  const Eigen::Vector3f& color(int body) const {
    return isSherd(body) ? sherds_[body].clay.body : prop(body).body;
  }
  const std::vector<Eigen::Vector3f>& vertices(int body) const { return vertices_[body]; }
  const std::vector<Eigen::Vector3f>& normals(int body) const { return normals_[body]; }
  const Eigen::Isometry3d& pose(int sherd) const { return poses_[sherd]; }

 private:
  struct Tracer;
  const std::vector<vessels::VirtualSherd>& sherds_;
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<Prop> props_;
  std::vector<std::vector<Eigen::Vector3f>> vertices_, normals_;
  std::unique_ptr<Tracer> tracer_;
};

}  // namespace ostraka::rendering
