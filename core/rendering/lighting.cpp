#include "rendering/lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"

namespace ostraka::rendering {
namespace {

// Strata of a light, side by side: penumbras within 3 %, those of windows, which are wide, too.
int shadowSide(const Light& light) {
  return light.radius > 0.25f ? 10 : 5;
}

// Cells along the side of the ground's square.
int gridOf(const Lighting& lighting) {
  return 2 * lighting.ground_mm + 1;
}

double unit(std::uint64_t h, int part) {
  return static_cast<double>((h >> (16 * part)) & 0xFFFF) / 65536.0;
}

// Share of each light seen from p, by strata shifted together by a hash of the point.
LightField::Shares seenShares(const Scene& scene, const Lighting& lighting,
                              const Eigen::Vector3f& p, const Eigen::Vector3f& normal,
                              std::uint64_t hash) {
  LightField::Shares shares{};
  for (int l = 0; l < kLights; ++l) {
    const Light& light = lighting.lights[l];
    if (light.strength.isZero()) continue;
    if (light.hard) {
      shares[l] = 1;
      continue;
    }
    const Eigen::Vector3f to_centre = light.centre.cast<float>() - p;
    const float spread = static_cast<float>(light.half_u.norm() + light.half_v.norm());
    if (normal.dot(to_centre) < -spread) continue;  // wholly behind
    const std::uint64_t h = vessels::mixed(hash, static_cast<std::uint64_t>(l));
    const int side = shadowSide(light);
    const auto sees = [&](int i) {
      const double a = (i % side + unit(h, 0)) / side;
      const double b = (i / side + unit(h, 1)) / side;
      const Eigen::Vector3d q =
          light.centre + (2 * a - 1) * light.half_u + (2 * b - 1) * light.half_v;
      return !scene.blocked(p, q.cast<float>() - p, 1.f);
    };
    // Where the light's corners and middle are all seen or all hidden, so is nearly all between.
    const std::array<int, 5> first{0, side - 1, side * side / 2, side * (side - 1),
                                   side * side - 1};
    int seen = 0;
    for (const int i : first) seen += sees(i);
    if (seen == 0 || seen == static_cast<int>(first.size())) {
      shares[l] = seen > 0 ? 1.f : 0.f;
      continue;
    }
    for (int i = 0; i < side * side; ++i)
      if (std::find(first.begin(), first.end(), i) == first.end()) seen += sees(i);
    shares[l] = static_cast<float>(seen) / (side * side);
  }
  return shares;
}

// What falls on every vertex and every cell of the plate before it goes on to others: the lamps,
// averaged over the turns of the plate (bounced light is soft, and one field serves all stops), and
// the sky.
struct FirstLight {
  std::vector<std::vector<Eigen::Vector3f>> vertices;
  std::vector<Eigen::Vector3f> plate;
};

class AmbientSource {
 public:
  AmbientSource(const Scene& scene, const Lighting& lighting, const Ground& ground,
                const AmbientOptions& options)
      : scene_(scene), lighting_(lighting), ground_(ground) {
    for (int k = 0; k < kTurns; ++k)
      lightings_.push_back(options.turning ? turned(lighting, 2 * std::numbers::pi * k / kTurns)
                                           : lighting);
  }

  Eigen::Vector3f openPlate() const {
    return lighting_.sky +
           directLight(lighting_, Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ(), {1, 1, 1});
  }

  Eigen::Vector3f lamps(const Eigen::Vector3f& p, const Eigen::Vector3f& normal,
                        std::uint64_t hash) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int k = 0; k < kTurns; ++k) {
      LightField::Shares shares;
      for (int l = 0; l < kLights; ++l) {
        const Light& light = lightings_[k].lights[l];
        const std::uint64_t h = vessels::mixed(hash, static_cast<std::uint64_t>(k * kLights + l));
        shares[l] = !light.strength.isZero() && seesLight(scene_, light, p, h) ? 1.f : 0.f;
      }
      sum += directLight(lightings_[k], p, normal, shares);
    }
    return sum / kTurns;
  }

  // Irradiance from the hemisphere. The sky is brighter overhead (1 + 2 cos, CIE overcast, divided
  // by its mean over a horizontal element). What is hit sends back a share of its own first light;
  // without a first light it is black.
  Eigen::Vector3f gather(const Eigen::Vector3f& p, const Eigen::Vector3f& normal,
                         std::uint64_t hash, const FirstLight* first, int side) const {
    const Eigen::Vector3f u = normal.unitOrthogonal(), v = normal.cross(u);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int i = 0; i < side * side; ++i) {
      const double a = (i % side + unit(hash, 0)) / side;
      const double b = (i / side + unit(hash, 1)) / side;
      const auto radius = static_cast<float>(std::sqrt(a)),
                 height = static_cast<float>(std::sqrt(1 - a));
      const auto angle = static_cast<float>(2 * std::numbers::pi * b);
      const Eigen::Vector3f d =
          radius * (std::cos(angle) * u + std::sin(angle) * v) + height * normal;
      const Scene::Hit hit = scene_.nearest(p, d);
      if (hit.body < 0 && d.z() > 0)
        sum += (1 + 2 * d.z()) * 3 / 7 * lighting_.sky;
      else if (first != nullptr)
        sum += hit.body < 0 ? fromPlate(p - p.z() / d.z() * d, *first) : fromBody(hit, *first);
    }
    return sum / (side * side);
  }

 private:
  static constexpr int kTurns = 6;  // three lamps each: 18 directions that the lamps come from

  Eigen::Vector3f fromBody(const Scene::Hit& hit, const FirstLight& first) const {
    const auto& t = scene_.mesh(hit.body).triangles[hit.triangle];
    const auto& light = first.vertices[hit.body];
    return scene_.color(hit.body).cwiseProduct((1 - hit.u - hit.v) * light[t[0]] +
                                               hit.u * light[t[1]] + hit.v * light[t[2]]);
  }

  Eigen::Vector3f fromPlate(const Eigen::Vector3f& p, const FirstLight& first) const {
    const int n = gridOf(lighting_);
    const int x = std::clamp(static_cast<int>(std::lround(p.x())) + n / 2, 0, n - 1),
              y = std::clamp(static_cast<int>(std::lround(p.y())) + n / 2, 0, n - 1);
    return ground_.meanAlbedo(p.head<2>())
        .cwiseProduct(first.plate[static_cast<std::size_t>(y) * n + x]);
  }

  const Scene& scene_;
  const Lighting& lighting_;
  const Ground& ground_;
  std::vector<Lighting> lightings_;
};

constexpr int kFirstSide = 6;  // directions, squared, of light that is averaged once more

// Cells of the plate near enough to a sherd for it to shade them or to take sky from them.
std::vector<char> nearSherds(const Scene& scene, const Lighting& lighting) {
  const int n = gridOf(lighting);
  std::vector<char> close(static_cast<std::size_t>(n) * n, 0);
  for (std::size_t s = 0; s < static_cast<std::size_t>(scene.bodies()); ++s) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& p : scene.vertices(static_cast<int>(s))) box.extend(p);
    const float reach = lighting.shadow_reach * box.max().z() + 3;
    for (int y = 1; y < n - 1; ++y)  // the border stays open: what lies beyond is like it
      for (int x = 1; x < n - 1; ++x) {
        const Eigen::Vector2f p(static_cast<float>(x - n / 2), static_cast<float>(y - n / 2));
        const Eigen::Vector2f q = p.cwiseMax(box.min().head<2>()).cwiseMin(box.max().head<2>());
        if ((p - q).norm() < reach) close[static_cast<std::size_t>(y) * n + x] = 1;
      }
  }
  return close;
}

constexpr std::size_t kBlock = 512;  // vertices or cells a task

template <class Body>
void overBlocks(std::size_t count, int threads, const Body& body) {
  parallelFor((count + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i) body(i);
  });
}

}  // namespace

Light softbox(double azimuth, double elevation, double distance, double half_width,
              double half_height, const Eigen::Vector3f& strength) {
  const Eigen::Vector3d to(std::cos(azimuth) * std::cos(elevation),
                           std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  const Eigen::Vector3d u = Eigen::Vector3d::UnitZ().cross(to).normalized();
  Light light;
  light.centre = distance * to;
  light.half_u = half_width * u;
  light.half_v = half_height * to.cross(u);
  light.strength = strength;
  return light;
}

Lighting makeLighting(vessels::Random& random) {
  Lighting lighting;
  const double key = random.uniform(0, 2 * std::numbers::pi);
  const auto warm = [&](double strength) {
    const auto t = static_cast<float>(random.uniform(-0.03, 0.03)),
               s = static_cast<float>(strength);
    return Eigen::Vector3f(s * (1 + t), s, s * (1 - t));
  };
  lighting.lights[0] = softbox(key, random.uniform(0.75, 1.0), 750, 190, 150, warm(0.44));
  lighting.lights[1] = softbox(key + random.uniform(1.7, 2.4), random.uniform(0.65, 0.85), 800, 220,
                               150, warm(0.24));
  lighting.lights[2] =
      softbox(key - random.uniform(1.5, 2.3), random.uniform(0.7, 1.1), 900, 150, 200, warm(0.15));
  lighting.sky = warm(0.19);
  return lighting;
}

Lighting turned(const Lighting& lighting, double plate_angle_rad) {
  const Eigen::AngleAxisd turn(-plate_angle_rad, Eigen::Vector3d::UnitZ());
  Lighting out = lighting;
  for (Light& l : out.lights) {
    l.centre = turn * l.centre;
    l.half_u = turn * l.half_u;
    l.half_v = turn * l.half_v;
  }
  return out;
}

LightField castShadows(const Scene& scene, const Lighting& lighting, std::uint64_t seed,
                       int threads) {
  LightField field;
  for (std::size_t s = 0; s < static_cast<std::size_t>(scene.bodies()); ++s) {
    const auto& points = scene.vertices(static_cast<int>(s));
    const auto& normals = scene.normals(static_cast<int>(s));
    field.vertices.emplace_back(points.size());
    overBlocks(points.size(), threads, [&](std::size_t i) {
      field.vertices[s][i] = seenShares(scene, lighting, points[i] + kLift * normals[i], normals[i],
                                        vessels::mixed(seed + s, i));
    });
  }
  const int n = gridOf(lighting);
  const std::vector<char> close = nearSherds(scene, lighting);
  field.plate.assign(static_cast<std::size_t>(n) * n, {1, 1, 1});
  overBlocks(field.plate.size(), threads, [&](std::size_t i) {
    if (!close[i]) return;
    const Eigen::Vector3f p(static_cast<float>(static_cast<int>(i % n) - n / 2),
                            static_cast<float>(static_cast<int>(i / n) - n / 2), 0);
    field.plate[i] =
        seenShares(scene, lighting, p, Eigen::Vector3f::UnitZ(), vessels::mixed(seed + 991, i));
  });
  return field;
}

bool seesLight(const Scene& scene, const Light& light, const Eigen::Vector3f& p,
               std::uint64_t hash) {
  const Eigen::Vector3d q = light.centre + (2 * unit(hash, 0) - 1) * light.half_u +
                            (2 * unit(hash, 1) - 1) * light.half_v;
  return !scene.blocked(p, q.cast<float>() - p, 1.f);
}

AmbientField gatherAmbient(const Scene& scene, const Lighting& lighting, const Ground& ground,
                           std::uint64_t seed, const AmbientOptions& options) {
  const AmbientSource source(scene, lighting, ground, options);
  const int threads = options.threads;
  const int n = gridOf(lighting);
  const std::vector<char> close = nearSherds(scene, lighting);
  const auto cell = [n](std::size_t i) {
    return Eigen::Vector3f(static_cast<float>(static_cast<int>(i % n) - n / 2),
                           static_cast<float>(static_cast<int>(i / n) - n / 2), 0);
  };
  AmbientField field;
  field.plate.assign(static_cast<std::size_t>(n) * n, lighting.sky);
  const auto over = [&](std::vector<std::vector<Eigen::Vector3f>>& vertices,
                        std::vector<Eigen::Vector3f>& cells, const auto& body) {
    vertices.resize(static_cast<std::size_t>(scene.bodies()));
    for (std::size_t s = 0; s < static_cast<std::size_t>(scene.bodies()); ++s) {
      const auto& points = scene.vertices(static_cast<int>(s));
      const auto& normals = scene.normals(static_cast<int>(s));
      vertices[s].resize(points.size());
      overBlocks(points.size(), threads, [&](std::size_t i) {
        vertices[s][i] = body(points[i] + kLift * normals[i], normals[i],
                              vessels::mixed(seed + s, i), options.side);
      });
    }
    overBlocks(cells.size(), threads, [&](std::size_t i) {
      if (close[i])
        cells[i] = body(cell(i), Eigen::Vector3f::UnitZ(), vessels::mixed(seed + 991, i),
                        options.ground_side);
    });
  };
  FirstLight first;
  first.plate.assign(field.plate.size(), source.openPlate());
  over(first.vertices, first.plate,
       [&](const auto& p, const auto& normal, std::uint64_t hash, int) {
         return Eigen::Vector3f(source.lamps(p, normal, hash) +
                                source.gather(p, normal, hash, nullptr, kFirstSide));
       });
  over(field.vertices, field.plate,
       [&](const auto& p, const auto& normal, std::uint64_t hash, int side) {
         return source.gather(p, normal, hash, &first, side);
       });
  return field;
}

Eigen::Vector3f directLight(const Lighting& lighting, const Eigen::Vector3f& p,
                            const Eigen::Vector3f& normal, const LightField::Shares& shares) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int l = 0; l < kLights; ++l) {
    if (shares[l] == 0) continue;
    const Eigen::Vector3f centre = lighting.lights[l].centre.cast<float>();
    const Eigen::Vector3f d = centre - p;
    const float square = d.squaredNorm(), cosine = normal.dot(d) / std::sqrt(square);
    // A light of angular radius asin(w) sets over a horizon of 2 w instead of at once.
    const float w = lighting.lights[l].radius;
    const float facing = cosine > w    ? cosine
                         : cosine < -w ? 0.f
                                       : (cosine + w) * (cosine + w) / (4 * w);
    sum += lighting.lights[l].strength * (shares[l] * facing * centre.squaredNorm() / square);
  }
  return sum;
}

void plateLight(const LightField& field, const AmbientField& ambient, const Eigen::Vector2f& p,
                LightField::Shares& shares, Eigen::Vector3f& irradiance) {
  const auto n = static_cast<int>(std::lround(std::sqrt(field.plate.size())));
  const float x = std::clamp(p.x() + n / 2, 0.f, n - 1.001f),
              y = std::clamp(p.y() + n / 2, 0.f, n - 1.001f);
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float u = x - static_cast<float>(i), v = y - static_cast<float>(j);
  shares = {};
  irradiance.setZero();
  for (int k = 0; k < 4; ++k) {
    const float weight = ((k & 1) ? u : 1 - u) * ((k >> 1) ? v : 1 - v);
    const std::size_t at = static_cast<std::size_t>(j + (k >> 1)) * n + i + (k & 1);
    for (int l = 0; l < kLights; ++l) shares[l] += weight * field.plate[at][l];
    irradiance += weight * ambient.plate[at];
  }
}

}  // namespace ostraka::rendering
