// A program of another house: two scans of a slab become one closed model.
#include <ostraka/catalogue.h>
#include <ostraka/close_model.h>
#include <ostraka/dense.h>
#include <ostraka/point_files.h>
#include <ostraka/register.h>
#include <ostraka/version.h>

#include <cmath>
#include <cstdio>

namespace {

// What a scanner sees of one face of a slab of 24 x 18 x 5 mm, and of its edges.
ostraka::PointCloud slab(float up) {
  const Eigen::Vector3f half(12, 9, 2.5f);
  constexpr float kStep_mm = 0.3f;
  ostraka::PointCloud cloud;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      if (axis == 2 && sign != up) continue;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (float a = -half[u] + kStep_mm / 2; a < half[u]; a += kStep_mm)
        for (float b = -half[v] + kStep_mm / 2; b < half[v]; b += kStep_mm) {
          Eigen::Vector3f p, n = Eigen::Vector3f::Zero();
          p[axis] = sign * half[axis];
          p[u] = a;
          p[v] = b;
          n[axis] = sign;
          cloud.points.push_back(p);
          cloud.normals.push_back(n);
        }
    }
  return cloud;
}

int fail(const ostraka::Error& error) {
  std::fprintf(stderr, "%s\n", error.sentence().english().c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  ostraka::QuietProgress quiet;
  const auto closed =
      ostraka::api::closeModel(slab(1), slab(-1), Eigen::Isometry3d::Identity(), 0, quiet, {});
  if (!closed) return fail(closed.error());
  if (const auto written = ostraka::api::writeMesh(argv[1], closed->mesh); !written)
    return fail(written.error());
  std::printf("Ostraka %s: %.0f mm3\n", ostraka::api::version(), closed->volume_mm3);
  // Errors are values; these three functions are here to be linked.
  const bool refused = !ostraka::api::readCatalogue("/nowhere", "") &&
                       !ostraka::api::dense({}, 1, quiet, {}) &&
                       !ostraka::api::registerScans({}, {}, 1, quiet, {});
  constexpr double kVolume_mm3 = 24 * 18 * 5;
  return refused && std::abs(closed->volume_mm3 - kVolume_mm3) < 0.02 * kVolume_mm3 ? 0 : 1;
}
