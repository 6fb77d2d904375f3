#include "virtualrig/virtual_scan.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "base/text.h"
#include "cloud/ply.h"
#include "files/json.h"
#include "rendering/scene.h"

namespace ostraka::virtualrig {
namespace {

constexpr float kSpacing = 0.4f;           // mm between points
constexpr float kMostIncidence = 0.2588f;  // cosine of 75 degrees
constexpr int kFewestViews = 2;

/// How one scan came out: drawn once per scan.
struct ScanErrors {
  float wavy_mm, white_mm;                  // standard deviations along the normal
  float floor_mm;                           // nothing is seen nearer to the plate
  float hidden_from = 0, hidden_width = 0;  // part of the strip, as turn about the axis
  std::vector<Eigen::Vector3f> holes;
  float hole_mm;
};

ScanErrors drawErrors(const std::vector<Eigen::Vector3f>& vertices, vessels::Random& random) {
  ScanErrors n;
  n.wavy_mm = static_cast<float>(random.uniform(0.04, 0.065));
  n.white_mm = static_cast<float>(random.uniform(0.01, 0.025));
  n.floor_mm = static_cast<float>(random.uniform(0.35, 0.6));
  n.hidden_from = static_cast<float>(random.uniform(-std::numbers::pi, std::numbers::pi));
  const double width = random.uniform(0.6, 1.4);
  if (random.chance(0.15)) n.hidden_width = static_cast<float>(width);
  for (int i = random.below(6); i > 0; --i)
    n.holes.push_back(
        vertices[static_cast<std::size_t>(random.below(static_cast<int>(vertices.size())))]);
  n.hole_mm = static_cast<float>(random.uniform(0.5, 1.2));
  return n;
}

/// What stereo does to a broken edge beyond that; drawn once per scan.
struct EdgeErrors {
  float fat_mm, sd_mm;  // outward; along the normal
  float gap_above;      // where a smooth field exceeds it nothing was matched
  std::uint32_t wave;

  static EdgeErrors draw(vessels::Random& random) {
    // The field has SD 0.36: a fifth of it lies above 0.30, two fifths above 0.09.
    return {static_cast<float>(random.uniform(0.03, 0.10)),
            static_cast<float>(random.uniform(0.11, 0.16)),
            static_cast<float>(random.uniform(0.09, 0.30)),
            static_cast<std::uint32_t>(random.next())};
  }
  /// 0 on faces turned up or down, 1 on walls.
  static float on(const Eigen::Vector3f& normal) {
    return std::clamp((0.85f - std::abs(normal.z())) / 0.35f, 0.f, 1.f);
  }
  bool gap(const Eigen::Vector3f& p) const { return vessels::noise(p / 4, wave + 1) > gap_above; }
  /// Overhangs are seen by few views and come out fatter. Of the variance 0.55 waves over
  /// 1.5 mm, 0.15 over 4 mm, the rest is white (white_normal: of SD 1).
  float shift(const Eigen::Vector3f& p, const Eigen::Vector3f& normal, float white_normal) const {
    const float smooth =
        (0.74f * vessels::noise(p / 1.5f, wave + 2) + 0.39f * vessels::noise(p / 4, wave + 3)) /
        0.36f;
    return fat_mm * (1 - 0.5f * normal.z()) + sd_mm * (smooth + 0.55f * white_normal);
  }
  /// 20 degrees in the median: 0.30 in each of the two directions across, alike over 1.5 mm.
  Eigen::Vector3f tilt(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p / 1.5f;
    return 0.30f / 0.36f *
           Eigen::Vector3f(vessels::noise(q, wave + 4), vessels::noise(q, wave + 5),
                           vessels::noise(q, wave + 6));
  }
};

struct Candidates {
  PointCloud cloud;
  std::vector<float> broken;
};

// Points even by area, one per cube of the spacing.
Candidates sampleSurface(const rendering::Scene& scene, int sherd, vessels::Random& random) {
  const TriangleMesh& mesh = scene.sherds()[sherd].mesh;
  Candidates out;
  PointCloud dense;
  for (const auto& t : mesh.triangles) {
    const auto& v = scene.vertices(sherd);
    const Eigen::Vector3f a = v[t[0]], u = v[t[1]] - a, w = v[t[2]] - a;
    const double wanted = 0.5 * u.cross(w).norm() * 3 / (kSpacing * kSpacing);
    const int count = static_cast<int>(wanted + random.uniform());
    for (int k = 0; k < count; ++k) {
      auto p = static_cast<float>(random.uniform()), q = static_cast<float>(random.uniform());
      if (p + q > 1) p = 1 - p, q = 1 - q;
      dense.points.push_back(a + p * u + q * w);
      const auto& n = scene.normals(sherd);
      dense.normals.push_back(
          (n[t[0]] + p * (n[t[1]] - n[t[0]]) + q * (n[t[2]] - n[t[0]])).normalized());
      const auto& places = scene.sherds()[sherd].places;
      dense.quality.push_back(places[t[0]].broken * (1 - p - q) + places[t[1]].broken * p +
                              places[t[2]].broken * q);
    }
  }
  out.cloud =
      thinned(dense, 1.15 * kSpacing);  // cubes that a sheet cuts lie nearer than their edge
  out.broken = std::move(out.cloud.quality);
  out.cloud.quality.clear();
  return out;
}

// Largest cosine of incidence among the views that see the point, 0 when fewer than two do.
float seenBy(const rendering::Scene& scene, const std::vector<Eigen::Vector3f>& eyes,
             const Eigen::Vector3f& p, const Eigen::Vector3f& normal) {
  int views = 0;
  float best = 0;
  for (const Eigen::Vector3f& eye : eyes) {
    const Eigen::Vector3f d = eye - p;
    const float cosine = normal.dot(d) / d.norm();
    if (cosine < kMostIncidence || scene.blocked(p + 0.05f * normal, d, 1)) continue;
    ++views;
    best = std::max(best, cosine);
  }
  return views >= kFewestViews ? best : 0;
}

PointCloud scan(const rendering::Scene& scene, int sherd, const std::vector<Eigen::Vector3f>& eyes,
                ScanNoise kind, std::uint64_t seed) {
  vessels::Random random(seed);
  const ScanErrors noise_of = drawErrors(scene.vertices(sherd), random);
  vessels::Random edge_chance(vessels::mixed(seed, 1));
  const EdgeErrors edge = EdgeErrors::draw(edge_chance);
  const Candidates candidates = sampleSurface(scene, sherd, random);
  const Eigen::Vector2f middle = scene.pose(sherd).translation().head<2>().cast<float>();
  const auto wave = static_cast<std::uint32_t>(random.next());
  const auto normal = [&] { return static_cast<float>(random.normal()); };
  PointCloud out;
  for (std::size_t i = 0; i < candidates.cloud.size(); ++i) {
    const Eigen::Vector3f& p = candidates.cloud.points[i];
    const Eigen::Vector3f& n = candidates.cloud.normals[i];
    if (p.z() < noise_of.floor_mm) continue;
    const Eigen::Vector2f out_from = p.head<2>() - middle;
    const float turn = std::remainder(std::atan2(out_from.y(), out_from.x()) - noise_of.hidden_from,
                                      2 * std::numbers::pi_v<float>);
    if (candidates.broken[i] > 0.4f && std::abs(turn) < noise_of.hidden_width / 2) continue;
    if (std::any_of(noise_of.holes.begin(), noise_of.holes.end(),
                    [&](const Eigen::Vector3f& h) { return (p - h).norm() < noise_of.hole_mm; }))
      continue;
    const float worse = kind == ScanNoise::Stereo ? EdgeErrors::on(n) : 0;
    if (worse > 0.5f && edge.gap(p)) continue;
    const float facing = seenBy(scene, eyes, p, n);
    if (facing == 0) continue;
    // Grazing views measure worse, and the lowest band is fat by light from the plate.
    float factor = 1 + 0.5f * std::clamp((0.7f - facing) / 0.45f, 0.f, 1.f), shift = 0;
    const float low = std::clamp(1 - (p.z() - noise_of.floor_mm) / 1.2f, 0.f, 1.f);
    factor *= 1 + low;
    shift += 0.06f * low;
    shift += factor * (noise_of.wavy_mm / 0.36f * vessels::noise(p / 0.9f, wave) +
                       noise_of.white_mm * normal());
    if (facing < 0.5f && random.chance(0.02))
      shift += static_cast<float>(random.uniform(0.3, 1.5));  // flying
    Eigen::Vector3f aside = Eigen::Vector3f::Zero();
    if (worse > 0) {
      shift += worse * edge.shift(p, n, static_cast<float>(edge_chance.normal()));
      aside = worse * edge.tilt(p);
    }
    out.points.push_back(p + shift * n);
    // 9 degrees: 0.11 in each of the two directions across.
    const Eigen::Vector3f white(normal(), normal(), normal());
    out.normals.push_back((n + aside + 0.11f * white).normalized());
  }
  return out;
}

std::vector<int> shuffled(std::size_t count, vessels::Random& random) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 1);
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  return order;
}

}  // namespace

Result<void> writeScans(const std::vector<vessels::VirtualSherd>& sherds, const Layout& layout,
                        const VirtualRig& rig, const SimulateOptions& options, Progress& progress,
                        std::stop_token stop) {
  vessels::Random names(vessels::mixed(options.seed, 6));
  const std::size_t count = sherds.size();
  const std::vector<int> fronts = shuffled(count, names), backs = shuffled(count, names);
  std::vector<Eigen::Vector3f> eyes;
  for (int s = 0; s < static_cast<int>(rig.angles_rad.size()); ++s)
    for (int c = 0; c < rig.cameras(); ++c)
      eyes.push_back(rig.cameraFromPlate(c, s).inverse().translation().cast<float>());
  for (const bool front : {true, false}) {
    if (stop.stop_requested()) return Error::cancelled();
    const rendering::Scene scene(sherds, front ? layout.front : layout.back);
    std::vector<PointCloud> clouds(count);
    parallelFor(count, options.threads, [&](std::size_t i) {
      if (!stop.stop_requested())
        clouds[i] = scan(scene, static_cast<int>(i), eyes, options.scan_noise,
                         vessels::mixed(options.seed, (front ? 300 : 400) + i));
    });
    if (stop.stop_requested()) return Error::cancelled();
    for (std::size_t i = 0; i < count; ++i) {
      const std::string file =
          front ? formatted("front/f%03d.ply", fronts[i]) : formatted("back/b%03d.ply", backs[i]);
      if (Result<void> r =
              writePly(options.output / file, clouds[i], front ? "plate_front" : "plate_back");
          !r)
        return r;
    }
    progress.report(front ? 1 : 2, 2);
  }
  nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string mesh = formatted("truth/f%03d.ply", fronts[i]);
    if (Result<void> r = writePly(options.output / mesh,
                                  transformed(sherds[i].mesh, layout.front[i]), "plate_front");
        !r)
      return r;
    nlohmann::ordered_json group;
    if (sherds[i].lookalike_group >= 0) group = sherds[i].lookalike_group;
    pairs.push_back({{"front", formatted("front/f%03d.ply", fronts[i])},
                     {"back", formatted("back/b%03d.ply", backs[i])},
                     {"T_front_from_back", toJson(layout.front[i] * layout.back[i].inverse())},
                     {"lookalike_group", group},
                     {"symmetric", false},
                     {"width_mm", sherds[i].width_mm},
                     {"thickness_mm", sherds[i].wall_mean_mm},
                     {"form", sherds[i].kind},
                     {"truth_mesh", mesh}});
  }
  return writeJson(options.output / "truth.json",
                   {{"unit", "mm"},
                    {"pairs", pairs},
                    {"unpaired_front", nlohmann::ordered_json::array()},
                    {"unpaired_back", nlohmann::ordered_json::array()}});
}

}  // namespace ostraka::virtualrig
