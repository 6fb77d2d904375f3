#include "rendering/scene.h"

#include <embree3/rtcore.h>

#include <limits>
#include <utility>

namespace ostraka::rendering {

namespace {

// Unit normals per vertex, weighted by the triangles' areas.
std::vector<Eigen::Vector3f> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.vertices.size(), Eigen::Vector3f::Zero());
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f n = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                                  .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    for (const int i : t) normals[i] += n;
  }
  for (Eigen::Vector3f& n : normals) n.normalize();
  return normals;
}

}  // namespace

// Embree, Wald et al., SIGGRAPH 2014. One building thread: the same tree, so the same ties.
struct Scene::Tracer {
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  RTCScene scene = rtcNewScene(device);
  ~Tracer() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

Scene::Scene(const std::vector<vessels::VirtualSherd>& sherds,
             const std::vector<Eigen::Isometry3d>& plate_from_model, std::vector<Prop> props)
    : sherds_(sherds),
      poses_(plate_from_model),
      props_(std::move(props)),
      tracer_(std::make_unique<Tracer>()) {
  for (std::size_t s = 0; s < sherds.size() + props_.size(); ++s) {
    const TriangleMesh placed = s < sherds.size() ? transformed(sherds[s].mesh, plate_from_model[s])
                                                  : props_[s - sherds.size()].mesh;
    vertices_.push_back(placed.vertices);
    normals_.push_back(vertexNormals(placed));
    RTCGeometry geometry = rtcNewGeometry(tracer_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, placed.vertices.size()));
    for (const Eigen::Vector3f& p : placed.vertices)
      for (int c = 0; c < 3; ++c) *points++ = p[c];
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, placed.triangles.size()));
    for (const auto& t : placed.triangles)
      for (const int i : t) *corners++ = static_cast<unsigned>(i);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(tracer_->scene, geometry, static_cast<unsigned>(s));
    rtcReleaseGeometry(geometry);
  }
  rtcSetSceneFlags(tracer_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(tracer_->scene);
}

Scene::~Scene() = default;

Scene::Hit Scene::nearest(const Eigen::Vector3f& o, const Eigen::Vector3f& d) const {
  RTCRayHit ray{};
  ray.ray = {o.x(), o.y(), o.z(), 0, d.x(), d.y(), d.z(), 0, std::numeric_limits<float>::infinity(),
             ~0u,   0,     0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(tracer_->scene, &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {static_cast<int>(ray.hit.geomID), static_cast<int>(ray.hit.primID), ray.hit.u, ray.hit.v,
          ray.ray.tfar};
}

bool Scene::blocked(const Eigen::Vector3f& o, const Eigen::Vector3f& d, float reach) const {
  RTCRay ray{o.x(), o.y(), o.z(), 0, d.x(), d.y(), d.z(), 0, reach, ~0u, 0, 0};
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(tracer_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace ostraka::rendering
