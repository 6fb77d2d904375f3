#include "rendering/photograph.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "batch/photograph.h"
#include "rendering/highlights.h"
#include "rendering/sensor.h"

namespace ostraka::rendering {
namespace {

constexpr int kTile = 16;
constexpr float kSharp_px = 0.6f;  // a blur that is lost in the lens's own

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
    aperture_ = static_cast<float>(view.focus.aperture_mm);
    inverse_focus_ = static_cast<float>(1 / view.focus.distance_mm);
    for (std::size_t s = 0; s < view.scene.sherds().size(); ++s)
      model_turns_.push_back(view.scene.pose(static_cast<int>(s)).linear().cast<float>());
    markTiles();
  }

  // The mean light of a pixel and the sherd that covers more than half of it.
  Eigen::Vector3f pixel(int x, int y, std::uint8_t& label) const {
    label = 0;
    const Ray centre = ray(x, y, 0, 0);
    if (!tiles_[static_cast<std::size_t>(y / kTile) * tile_columns_ + x / kTile]) {
      const float blur = blurOf(depthOfGround(centre));
      if (blur < kSharp_px || view_.backdrop.even(centre)) return openPixel(x, y, centre);
      return lensPixel(x, y, blur, false);
    }
    static constexpr std::array<std::array<float, 2>, 4> kRotated{
        {{-0.375f, -0.125f}, {-0.125f, 0.375f}, {0.125f, -0.375f}, {0.375f, 0.125f}}};
    std::array<Scene::Hit, 4> hits;
    bool same = true;
    for (int k = 0; k < 4; ++k) {
      const Ray r = ray(x, y, kRotated[k][0], kRotated[k][1]);
      hits[k] = view_.scene.nearest(r.origin, r.direction);
      same = same && hits[k].body == hits[0].body;
    }
    label = same ? labelOf(hits[0].body) : edgeLabel(x, y);
    const float blur = blurOf(hits[0].body < 0 ? depthOfGround(centre) : hits[0].distance);
    if (blur >= kSharp_px) return lensPixel(x, y, blur, true);
    if (same && hits[0].body < 0) return openPixel(x, y, centre);
    if (!same) return edgePixel(x, y);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int k = 0; k < 4; ++k) {
      const Ray r = ray(x, y, kRotated[k][0], kRotated[k][1]);
      sum += bodyLight(hits[k], r, sampleHash(x, y, k));
    }
    return sum / 4;
  }

 private:
  Ray ray(int x, int y, float dx, float dy) const {
    const Eigen::Vector2f n = lens_.at(x, y, dx, dy);
    return {origin_, turn_ * Eigen::Vector3f(n.x(), n.y(), 1)};
  }

  // Through a point of the lens, in radii from its middle, towards what the pinhole has in focus.
  Ray lensRay(int x, int y, float dx, float dy, const Eigen::Vector2f& lens) const {
    const Eigen::Vector2f n = lens_.at(x, y, dx, dy), o = 0.5f * aperture_ * lens;
    const Eigen::Vector2f d = n - o * inverse_focus_;
    return {origin_ + turn_ * Eigen::Vector3f(o.x(), o.y(), 0),
            turn_ * Eigen::Vector3f(d.x(), d.y(), 1)};
  }

  // Rays have a length of 1 along the optical axis: what they travel is the depth.
  static float depthOfGround(const Ray& r) {
    return r.direction.z() < 0 ? -r.origin.z() / r.direction.z() : 1e6f;
  }
  // Diameter of a point's picture at this depth, pixels.
  float blurOf(float depth) const {
    return aperture_ * static_cast<float>(lens_.intrinsics().fx) *
           std::abs(1 / depth - inverse_focus_);
  }

  // Out of focus: samples spread over lens and pixel together, more the wider they spread.
  Eigen::Vector3f lensPixel(int x, int y, float blur_px, bool with_sherds) const {
    const int first = blur_px < 1.5f ? 6 : 8,
              most = static_cast<int>(std::clamp(8 * blur_px, 12.f, 32.f));
    const std::uint64_t hash = sampleHash(x, y, 0);
    const float start = static_cast<float>(hash & 0xFFFF) / 65536.f * 6.2831853f;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float low = 1e9f, high = 0;
    const auto look = [&](int k, int count) {
      // Vogel's spiral over the lens; the R2 sequence over the pixel.
      const float radius = std::sqrt((static_cast<float>(k) + 0.5f) / static_cast<float>(count)),
                  angle = start + 2.3999632f * static_cast<float>(k);
      const auto part = [&](float step, int shift) {
        const float at =
            step * static_cast<float>(k) + static_cast<float>((hash >> shift) & 0xFFFF) / 65536.f;
        return at - std::floor(at) - 0.5f;
      };
      const Ray r = lensRay(x, y, part(0.7548777f, 16), part(0.5698403f, 32),
                            radius * Eigen::Vector2f(std::cos(angle), std::sin(angle)));
      const std::uint64_t own = vessels::mixed(hash, static_cast<std::uint64_t>(k + 100 * count));
      const Scene::Hit hit =
          with_sherds ? view_.scene.nearest(r.origin, r.direction) : Scene::Hit{};
      const Eigen::Vector3f light =
          hit.body < 0 ? view_.backdrop.light(r, own) : bodyLight(hit, r, own);
      low = std::min(low, light.y());
      high = std::max(high, light.y());
      sum += light;
    };
    for (int k = 0; k < first; ++k) look(k, first);
    if (high < 1.3f * low) return sum / static_cast<float>(first);
    sum.setZero();
    for (int k = 0; k < most; ++k) look(k, most);
    return sum / static_cast<float>(most);
  }

  void markTiles() {
    const rig::Intrinsics& k = lens_.intrinsics();
    tile_columns_ = (k.width + kTile - 1) / kTile;
    const int tile_rows = (k.height + kTile - 1) / kTile;
    tiles_.assign(static_cast<std::size_t>(tile_columns_) * tile_rows, 0);
    // A mesh edge of 0.65 mm spans at most this; a pixel more for its own extent.
    // Props' edges of 1.5 mm lie nearer to the camera: as far as a hand holds it, twice a sherd's.
    const float reach =
        1.5f + (view_.scene.props().empty() ? 0.65f : 1.8f) * static_cast<float>(k.fx) / 500;
    for (int body = 0; body < view_.scene.bodies(); ++body)
      for (const Eigen::Vector3f& p : view_.scene.vertices(body)) {
        const Eigen::Vector3d p_camera = view_.camera_from_plate * p.cast<double>();
        const Eigen::Vector2f q = k.project(p_camera).cast<float>();
        const float wide = reach + 0.5f * blurOf(static_cast<float>(p_camera.z()));
        const int left = static_cast<int>(std::floor((q.x() - wide) / kTile)),
                  right = static_cast<int>(std::floor((q.x() + wide) / kTile));
        const int top = static_cast<int>(std::floor((q.y() - wide) / kTile)),
                  bottom = static_cast<int>(std::floor((q.y() + wide) / kTile));
        for (int ty = std::max(0, top); ty <= std::min(tile_rows - 1, bottom); ++ty)
          for (int tx = std::max(0, left); tx <= std::min(tile_columns_ - 1, right); ++tx)
            tiles_[static_cast<std::size_t>(ty) * tile_columns_ + tx] = 1;
      }
  }

  static std::array<float, 2> sixteenth(int k) {
    return {(static_cast<float>(k % 4) - 1.5f) / 4, (static_cast<float>(k / 4) - 1.5f) / 4};
  }

  std::uint8_t labelOf(int body) const {
    return body >= 0 && view_.scene.isSherd(body) ? static_cast<std::uint8_t>(body + 1) : 0;
  }

  std::uint8_t edgeLabel(int x, int y) const {
    std::array<int, 16> seen;
    for (int k = 0; k < 16; ++k) {
      const Ray r = ray(x, y, sixteenth(k)[0], sixteenth(k)[1]);
      seen[k] = view_.scene.nearest(r.origin, r.direction).body;
    }
    for (const int s : seen)
      if (std::count(seen.begin(), seen.end(), s) > 8) return labelOf(s);
    return 0;
  }

  Eigen::Vector3f edgePixel(int x, int y) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int k = 0; k < 16; ++k) {
      const Ray r = ray(x, y, sixteenth(k)[0], sixteenth(k)[1]);
      const Scene::Hit hit = view_.scene.nearest(r.origin, r.direction);
      const std::uint64_t hash = sampleHash(x, y, k);
      sum += hit.body < 0 ? view_.backdrop.light(r, hash) : bodyLight(hit, r, hash);
    }
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
      sum += backdrop.light(ray(x, y, sixteenth(k)[0], sixteenth(k)[1]), sampleHash(x, y, k));
    return sum / 16;
  }

  std::uint64_t sampleHash(int x, int y, int sample) const {
    const auto pixel =
        static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(lens_.intrinsics().width) +
        static_cast<std::uint64_t>(x);
    return vessels::mixed(seed_, 16 * pixel + static_cast<std::uint64_t>(sample));
  }

  // A place on a body, between its triangle's corners.
  struct Place {
    Eigen::Vector3f p_model, p, normal, irradiance;  ///< the last of ambient light
    LightField::Shares shares{};
  };

  Place placeOf(const Scene::Hit& hit) const {
    const TriangleMesh& mesh = view_.scene.mesh(hit.body);
    const auto& t = mesh.triangles[hit.triangle];
    const std::array<float, 3> w{1 - hit.u - hit.v, hit.u, hit.v};
    Place at;
    at.p_model = at.p = at.normal = at.irradiance = Eigen::Vector3f::Zero();
    for (int k = 0; k < 3; ++k) {
      const int i = t[k];
      at.p_model += w[k] * mesh.vertices[i];
      at.p += w[k] * view_.scene.vertices(hit.body)[i];
      at.normal += w[k] * view_.scene.normals(hit.body)[i];
      at.irradiance += w[k] * view_.ambient.vertices[hit.body][i];
      for (int l = 0; l < kLights; ++l) at.shares[l] += w[k] * view_.light.vertices[hit.body][i][l];
    }
    at.normal.normalize();
    return at;
  }

  vessels::ClayPlace clayPlaceOf(const Scene::Hit& hit) const {
    const vessels::VirtualSherd& sherd = view_.scene.sherds()[hit.body];
    const std::array<float, 3> w{1 - hit.u - hit.v, hit.u, hit.v};
    vessels::ClayPlace place;
    for (int k = 0; k < 3; ++k) {
      const vessels::ClayPlace& corner = sherd.places[sherd.mesh.triangles[hit.triangle][k]];
      place.around_mm += w[k] * corner.around_mm;
      place.up_mm += w[k] * corner.up_mm;
      place.depth += w[k] * corner.depth;
      place.broken += w[k] * corner.broken;
    }
    return place;
  }

  // A thing with colours of its own has no clay's; where it shines, all of it does.
  vessels::ClaySample claySampleOf(const Scene::Hit& hit, const Eigen::Vector3f& p_model) const {
    const vessels::VirtualSherd& sherd = view_.scene.sherds()[hit.body];
    vessels::ClaySample sample = vessels::sampleClay(sherd.clay, p_model, clayPlaceOf(hit));
    if (sherd.mesh.colors.empty()) return sample;
    const std::array<float, 3> w{1 - hit.u - hit.v, hit.u, hit.v};
    const std::array<double, 256>& light = batch::linearLight();
    sample.albedo.setZero();
    for (int k = 0; k < 3; ++k) {
      const Color& corner = sherd.mesh.colors[sherd.mesh.triangles[hit.triangle][k]];
      for (int c = 0; c < 3; ++c) sample.albedo[c] += w[k] * static_cast<float>(light[corner[c]]);
    }
    sample.shine = sherd.clay.shine;
    return sample;
  }

  // r, hash: of this look at the clay; the hash for what glitters.
  Eigen::Vector3f bodyLight(const Scene::Hit& hit, const Ray& r, std::uint64_t hash) const {
    Place at = placeOf(hit);
    const Eigen::Vector3f& normal = at.normal;
    for (int l = 0; l < kLights; ++l)
      if (view_.room_plate.lights[l].hard && at.shares[l] > 0)
        at.shares[l] = seesLight(view_.scene, view_.room_plate.lights[l], at.p + kLift * normal,
                                 vessels::mixed(hash, static_cast<std::uint64_t>(l)));
    if (!view_.scene.isSherd(hit.body)) {
      at.irradiance += directLight(view_.room_plate, at.p, normal, at.shares);
      return view_.scene.prop(hit.body).albedo(at.p).cwiseProduct(at.irradiance);
    }
    const vessels::ClaySample clay = claySampleOf(hit, at.p_model);
    const Eigen::Vector3f slope = model_turns_[hit.body] * clay.slope;
    const Eigen::Vector3f bent = (normal - (slope - normal * normal.dot(slope))).normalized();
    at.irradiance += directLight(view_.room_plate, at.p, bent, at.shares);
    // Facets of grains finer than a pixel flash up in one view and not in the next.
    const float flash = std::max(0.f, 1 + clay.glitter * vessels::quickNormal(hash));
    Eigen::Vector3f light = clay.albedo.cwiseProduct(at.irradiance) * flash;
    if (clay.shine.weight > 0.01f) light += shine(at, clay.shine, bent, r, hash);
    return light * handShare(view_.hand, at.p);
  }

  // What a shiny face mirrors: the lights, and one look at what else is around.
  Eigen::Vector3f shine(const Place& at, const vessels::Gloss& gloss, const Eigen::Vector3f& normal,
                        const Ray& r, std::uint64_t hash) const {
    const Eigen::Vector3f to_eye = -r.direction.normalized();
    const Eigen::Vector3f lights =
        highlights(view_.room_plate, at.p, normal, to_eye, at.shares, gloss);
    const Eigen::Vector3f towards =
        vessels::strewnReflection(normal, to_eye, gloss, vessels::mixed(hash, 55));
    const Ray mirrored{at.p + 2 * kLift * at.normal, towards};
    const Scene::Hit other = view_.scene.nearest(mirrored.origin, mirrored.direction);
    Eigen::Vector3f around;
    if (other.body >= 0) {
      const Place there = placeOf(other);
      around = view_.scene.color(other.body)
                   .cwiseProduct(there.irradiance + directLight(view_.room_plate, there.p,
                                                                there.normal, there.shares));
    } else if (towards.z() > 0) {
      around = (1 + 2 * towards.z()) * 3 / 7 * view_.room_plate.sky;
    } else {
      around = view_.backdrop.light(mirrored, hash);
    }
    return lights + gloss.weight * vessels::fresnel(normal.dot(to_eye)) * around;
  }

  const View& view_;
  const LensRays& lens_;
  const std::uint64_t seed_;
  Eigen::Vector3f origin_;
  Eigen::Matrix3f turn_;
  float aperture_ = 0, inverse_focus_ = 0;
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

}  // namespace ostraka::rendering
