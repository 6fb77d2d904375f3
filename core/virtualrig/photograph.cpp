#include "virtualrig/photograph.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "virtualrig/sensor.h"

namespace ostraka::virtualrig {
namespace {

constexpr int kTile = 16;

// Just inside a pixel's corners: an edge that passes between them is wider than a pixel.
constexpr std::array<std::array<float, 2>, 4> kCorners{
    {{-0.45f, -0.45f}, {0.45f, -0.45f}, {-0.45f, 0.45f}, {0.45f, 0.45f}}};

class Renderer {
 public:
  Renderer(const View& view, const LensRays& lens, std::uint64_t seed)
      : view_(view), lens_(lens), seed_(seed) {
    const Eigen::Isometry3d plate_from_camera = view.camera_from_plate.inverse();
    origin_ = plate_from_camera.translation().cast<float>();
    turn_ = plate_from_camera.linear().cast<float>();
    for (std::size_t s = 0; s < view.scene.sherds().size(); ++s)
      model_turns_.push_back(view.scene.pose(static_cast<int>(s)).linear().cast<float>());
    markTiles();
  }

  // The mean light of a pixel and the sherd that covers more than half of it.
  Eigen::Vector3f pixel(int x, int y, std::uint8_t& label) const {
    label = 0;
    const Ray centre = ray(x, y, 0, 0);
    if (!tiles_[static_cast<std::size_t>(y / kTile) * tile_columns_ + x / kTile])
      return openPixel(x, y, centre);
    static constexpr std::array<std::array<float, 2>, 4> kRotated{
        {{-0.375f, -0.125f}, {-0.125f, 0.375f}, {0.125f, -0.375f}, {0.375f, 0.125f}}};
    std::array<Scene::Hit, 4> hits;
    bool same = true;
    for (int k = 0; k < 4; ++k) {
      const Ray r = ray(x, y, kRotated[k][0], kRotated[k][1]);
      hits[k] = view_.scene.nearest(r.origin, r.direction);
      same = same && hits[k].sherd == hits[0].sherd;
    }
    if (same && hits[0].sherd < 0) return openPixel(x, y, centre);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    if (same) {
      for (int k = 0; k < 4; ++k) sum += sherdLight(hits[k], sampleHash(x, y, k));
      label = static_cast<std::uint8_t>(hits[0].sherd + 1);
      return sum / 4;
    }
    return edgePixel(x, y, label);
  }

 private:
  Ray ray(int x, int y, float dx, float dy) const {
    const Eigen::Vector2f n = lens_.at(x, y, dx, dy);
    return {origin_, turn_ * Eigen::Vector3f(n.x(), n.y(), 1)};
  }

  void markTiles() {
    const rig::Intrinsics& k = lens_.intrinsics();
    tile_columns_ = (k.width + kTile - 1) / kTile;
    const int tile_rows = (k.height + kTile - 1) / kTile;
    tiles_.assign(static_cast<std::size_t>(tile_columns_) * tile_rows, 0);
    // A mesh edge of 0.65 mm spans at most this; a pixel more for its own extent.
    const float reach = 1.5f + 0.65f * static_cast<float>(k.fx) / 500;
    for (std::size_t s = 0; s < view_.scene.sherds().size(); ++s)
      for (const Eigen::Vector3f& p : view_.scene.vertices(static_cast<int>(s))) {
        const Eigen::Vector2f q =
            k.project(view_.camera_from_plate * p.cast<double>()).cast<float>();
        const int left = static_cast<int>(std::floor((q.x() - reach) / kTile)),
                  right = static_cast<int>(std::floor((q.x() + reach) / kTile));
        const int top = static_cast<int>(std::floor((q.y() - reach) / kTile)),
                  bottom = static_cast<int>(std::floor((q.y() + reach) / kTile));
        for (int ty = std::max(0, top); ty <= std::min(tile_rows - 1, bottom); ++ty)
          for (int tx = std::max(0, left); tx <= std::min(tile_columns_ - 1, right); ++tx)
            tiles_[static_cast<std::size_t>(ty) * tile_columns_ + tx] = 1;
      }
  }

  Eigen::Vector3f edgePixel(int x, int y, std::uint8_t& label) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    std::array<int, 16> seen;
    for (int k = 0; k < 16; ++k) {
      const Ray r =
          ray(x, y, (static_cast<float>(k % 4) - 1.5f) / 4, (static_cast<float>(k / 4) - 1.5f) / 4);
      const Scene::Hit hit = view_.scene.nearest(r.origin, r.direction);
      seen[k] = hit.sherd;
      const std::uint64_t hash = sampleHash(x, y, k);
      sum += hit.sherd < 0 ? view_.backdrop.light(r, hash) : sherdLight(hit, hash);
    }
    for (const int s : seen)
      if (s >= 0 && std::count(seen.begin(), seen.end(), s) > 8)
        label = static_cast<std::uint8_t>(s + 1);
    return sum / 16;
  }

  // A pixel without a sherd: one sample where all is even, 16 where edges may be.
  Eigen::Vector3f openPixel(int x, int y, const Ray& centre) const {
    const Backdrop& backdrop = view_.backdrop;
    if (backdrop.even(centre)) return backdrop.light(centre, sampleHash(x, y, 0));
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float low = 1e9f, high = 0;
    int k = 0;
    for (const auto& [dx, dy] : kCorners) {
      const Eigen::Vector3f light = backdrop.light(ray(x, y, dx, dy), sampleHash(x, y, k++));
      low = std::min(low, light.y());
      high = std::max(high, light.y());
      sum += light;
    }
    if (high < 1.3f * low)
      return sum / 4;  // felt and paper vary by less, ink and paper by 20 times
    sum.setZero();
    for (k = 0; k < 16; ++k)
      sum += backdrop.light(
          ray(x, y, (static_cast<float>(k % 4) - 1.5f) / 4, (static_cast<float>(k / 4) - 1.5f) / 4),
          sampleHash(x, y, k));
    return sum / 16;
  }

  std::uint64_t sampleHash(int x, int y, int sample) const {
    const auto pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(lens_.intrinsics().width) +
        static_cast<std::uint64_t>(x);
    return mixed(seed_, 16 * pixel + static_cast<std::uint64_t>(sample));
  }

  // hash: of this look at the clay, for what glitters.
  Eigen::Vector3f sherdLight(const Scene::Hit& hit, std::uint64_t hash) const {
    const VirtualSherd& sherd = view_.scene.sherds()[hit.sherd];
    const auto& t = sherd.mesh.triangles[hit.triangle];
    const std::array<float, 3> w{1 - hit.u - hit.v, hit.u, hit.v};
    Eigen::Vector3f p_model = Eigen::Vector3f::Zero(), p = p_model, normal = p_model,
                    irradiance = p_model;
    ClayPlace place;
    LightField::Shares shares{};
    for (int k = 0; k < 3; ++k) {
      const int i = t[k];
      p_model += w[k] * sherd.mesh.vertices[i];
      p += w[k] * view_.scene.vertices(hit.sherd)[i];
      normal += w[k] * view_.scene.normals(hit.sherd)[i];
      irradiance += w[k] * view_.ambient.vertices[hit.sherd][i];
      place.around_mm += w[k] * sherd.places[i].around_mm;
      place.up_mm += w[k] * sherd.places[i].up_mm;
      place.depth += w[k] * sherd.places[i].depth;
      place.broken += w[k] * sherd.places[i].broken;
      for (int l = 0; l < kLights; ++l) shares[l] += w[k] * view_.light.vertices[hit.sherd][i][l];
    }
    const ClaySample clay = sampleClay(sherd.clay, p_model, place);
    normal.normalize();
    const Eigen::Vector3f slope = model_turns_[hit.sherd] * clay.slope;
    const Eigen::Vector3f bent = (normal - (slope - normal * normal.dot(slope))).normalized();
    for (int l = 0; l < kLights; ++l)
      if (view_.room_plate.lights[l].hard && shares[l] > 0)
        shares[l] = seesLight(view_.scene, view_.room_plate.lights[l], p + kLift * normal,
                              mixed(hash, static_cast<std::uint64_t>(l)));
    irradiance += directLight(view_.room_plate, p, bent, shares);
    // Facets of grains finer than a pixel flash up in one view and not in the next.
    const float flash = 1 + clay.glitter * quickNormal(hash);
    return clay.albedo.cwiseProduct(irradiance) * (handShare(view_.hand, p) * std::max(0.f, flash));
  }

  const View& view_;
  const LensRays& lens_;
  const std::uint64_t seed_;
  Eigen::Vector3f origin_;
  Eigen::Matrix3f turn_;
  std::vector<Eigen::Matrix3f> model_turns_;
  int tile_columns_ = 0;
  std::vector<char> tiles_;
};

}  // namespace

LensRays::LensRays(const rig::Intrinsics& intrinsics) : intrinsics_(intrinsics) {
  rays_.reserve(static_cast<std::size_t>(intrinsics.width) * intrinsics.height);
  for (int y = 0; y < intrinsics.height; ++y)
    for (int x = 0; x < intrinsics.width; ++x)
      rays_.push_back(
          intrinsics.unproject({static_cast<double>(x), static_cast<double>(y)}).cast<float>());
}

Photograph photograph(const View& view, const LensRays& lens, const Sensor& sensor,
                      std::uint64_t seed, std::stop_token stop) {
  const int width = lens.intrinsics().width, height = lens.intrinsics().height;
  const Renderer renderer(view, lens, seed + 2);
  std::vector<float> linear(static_cast<std::size_t>(width) * height * 3);
  Photograph out;
  out.labels.create(height, width, CV_8UC1);
  for (int y = 0; y < height && !stop.stop_requested(); ++y) {
    auto* labels = out.labels.ptr<std::uint8_t>(y);
    for (int x = 0; x < width; ++x) {
      const Eigen::Vector3f light = renderer.pixel(x, y, labels[x]);
      for (int c = 0; c < 3; ++c)
        linear[(static_cast<std::size_t>(y) * width + x) * 3 + c] = light[c];
    }
  }
  out.gain = expose(linear, width, height, sensor);
  out.image = develop(linear, width, height, sensor, seed);
  return out;
}

cv::Mat photographBoard(const BoardSurface& board, const LensRays& lens,
                        const Eigen::Isometry3d& camera_from_board, const Sensor& sensor,
                        std::uint64_t seed) {
  const int width = lens.intrinsics().width, height = lens.intrinsics().height;
  const Eigen::Isometry3d board_from_camera = camera_from_board.inverse();
  const Eigen::Vector3f origin = board_from_camera.translation().cast<float>();
  const Eigen::Matrix3f turn = board_from_camera.linear().cast<float>();
  std::vector<float> linear(static_cast<std::size_t>(width) * height * 3);
  const auto at = [&](int x, int y, float dx, float dy) {
    const Eigen::Vector2f n = lens.at(x, y, dx, dy);
    const Eigen::Vector3f d = turn * Eigen::Vector3f(n.x(), n.y(), 1);
    const Eigen::Vector3f p = origin - origin.z() / d.z() * d;
    const float b = board.brightness(p.head<2>());
    return b < 0 ? 0.033f : 0.85f * b;
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      float mean = at(x, y, 0, 0);
      bool even = true;
      for (const auto& [dx, dy] : kCorners) even = even && at(x, y, dx, dy) == mean;
      if (!even) {
        float sum = 0;
        for (int k = 0; k < 25; ++k)
          sum += at(x, y, (static_cast<float>(k % 5) - 2) / 5, (static_cast<float>(k / 5) - 2) / 5);
        mean = sum / 25;
      }
      for (int c = 0; c < 3; ++c) linear[(static_cast<std::size_t>(y) * width + x) * 3 + c] = mean;
    }
  return develop(linear, width, height, sensor, seed);
}

}  // namespace ostraka::virtualrig
