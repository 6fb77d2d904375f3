#include "model/surfels.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/message.h"
#include "model/blocks.h"
#include "model/point_bins.h"

namespace ostraka::model {
namespace {

using Eigen::Vector3f;

// A fit is trusted to this much; finer differences are noise of any scan and of the registration.
constexpr float kFitFloor_mm = 0.02f;
constexpr float kLeastRadius_mm = 0.9f;   // about 4 pixels of the rig: the window of stereo
constexpr float kLeastSpacings = 3.0f;    // some 18 neighbours on a flat
constexpr float kWindowSpacings = 5.5f;   // stereo's window of finer pixels
constexpr float kNearestSpacings = 2.4f;  // least radius of the smoothing: some 12 neighbours
constexpr float kFewest = 3;  // neighbours, by weight, that a point needs to be believed
constexpr std::size_t kFewestSurfels = 400;  // ten by twenty a side: fewer tell no thickness

// All points of both sides: what the fits are made from.
struct Sources {
  std::vector<Vector3f> points, normals;
  std::vector<float> quality, noise;
  std::vector<std::uint8_t> side;
};

struct Fit {
  Vector3f point, normal;
  float noise = 0;
  float support = 0;  // effective number of neighbours
  float density = 0;  // neighbours per mm^2
};

enum class Residual { OwnNormal, BothNormals };

struct FitOptions {
  Residual
      residual;  // measured along the fit's normal, or along the mean of it and the neighbour's
  float normal_sharpness;  // weight exp(-(1 - cos) * this)
  int rounds;
};

void append(Sources& all, const PointCloud& cloud, std::uint8_t side) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.points[i].allFinite() || !(cloud.normals[i].squaredNorm() > 0.25f)) continue;
    all.points.push_back(cloud.points[i]);
    all.normals.push_back(cloud.normals[i].normalized());
    all.quality.push_back(
        cloud.quality.size() == cloud.size() ? std::clamp(cloud.quality[i], 0.05f, 1.0f) : 1.0f);
    all.noise.push_back(0);
    all.side.push_back(side);
  }
}

struct Near {
  int index;
  float kernel;
};

// The normal of the plane through the weighted points, or `fallback` where they lie along a line.
Vector3f planeNormal(const Eigen::Matrix3f& covariance, const Vector3f& fallback) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance);
  const Vector3f values = solver.eigenvalues();
  // A fat line: the plane's normal could turn about it.
  if (!(values[1] > 4 * std::max(values[0], 1e-6f))) return fallback;
  Vector3f n = solver.eigenvectors().col(0);
  if (n.dot(fallback) < 0) n = -n;
  // Further off than the noise of normals: the points are no single sheet.
  return n.dot(fallback) > 0.7f ? Vector3f(n.normalized()) : fallback;
}

// Robust local fit about `start`. Each neighbour counts by distance, by how far its normal is from
// the fit's and by its residual in units of the scatter. The residual uses the mean of both
// normals, which is exact on spheres: rounded lips do not shrink.
Fit fitAround(const Vector3f& start, const Vector3f& start_normal, const std::vector<Near>& near,
              const Sources& all, const FitOptions& options) {
  Fit fit{start, start_normal, 0, 0, 0};
  float scale = 1e9f;
  for (int round = 0; round < options.rounds; ++round) {
    float sum = 0, sum2 = 0, offset = 0, spread = 0;
    Vector3f mean = Vector3f::Zero(), normal = Vector3f::Zero();
    Eigen::Matrix3f square = Eigen::Matrix3f::Zero();
    for (const Near& n : near) {
      const Vector3f& nj = all.normals[static_cast<std::size_t>(n.index)];
      const float cosine = nj.dot(fit.normal);
      if (cosine < 0.2f) continue;
      const Vector3f d = all.points[static_cast<std::size_t>(n.index)] - fit.point;
      const float h = options.residual == Residual::OwnNormal ? fit.normal.dot(d)
                                                              : 0.5f * (nj + fit.normal).dot(d);
      const float u = h / scale;
      if (u * u >= 1) continue;
      const float noise = all.noise[static_cast<std::size_t>(n.index)];
      const float trust = all.quality[static_cast<std::size_t>(n.index)] /
                          (noise * noise + kFitFloor_mm * kFitFloor_mm);
      const float w = n.kernel * trust * std::exp((cosine - 1) * options.normal_sharpness) *
                      (1 - u * u) * (1 - u * u);
      sum += w;
      sum2 += w * w;
      offset += w * h;
      spread += w * std::abs(h);
      mean += w * d;
      normal += w * nj;
      square += w * d * d.transpose();
    }
    if (!(sum > 0)) return {start, start_normal, 0, 0, 0};
    fit.support = sum * sum / sum2;
    mean /= sum;
    const Vector3f average = normal.normalized();
    fit.normal = planeNormal(square / sum - mean * mean.transpose(), average);
    fit.point += fit.normal * (offset / sum);
    // Sigma of a Gaussian from its mean absolute value; the plane took three freedoms.
    fit.noise = 1.2533f * spread / sum * std::sqrt(fit.support / std::max(1.0f, fit.support - 3));
    scale = 3.5f * std::max(fit.noise, kFitFloor_mm);
  }
  return fit;
}

float kernel(float squared_distance, float radius) {
  const float u = 1 - squared_distance / (radius * radius);
  return u * u;
}

Fit fitWithin(const Vector3f& p, const Vector3f& n, float radius, const PointBins& bins,
              const Sources& all, const FitOptions& options, std::vector<Near>& near) {
  near.clear();
  bins.within(p, radius, [&](int j, float d2) { near.push_back({j, kernel(d2, radius)}); });
  Fit fit = fitAround(p, n, near, all, options);
  fit.density = static_cast<float>(near.size()) / (static_cast<float>(M_PI) * radius * radius);
  return fit;
}

// One fit per source: a better normal and the scatter of the source's own side there.
bool estimateNoise(Sources& all, float radius, int threads, std::stop_token stop,
                   std::vector<Fit>& fits) {
  const PointBins bins(all.points, radius);
  fits.resize(all.points.size());
  return inBlocks<std::vector<
      Near>>(all.points.size(), threads, stop, [&](std::size_t i, std::vector<Near>& near) {
    near.clear();
    bins.within(all.points[i], radius, [&](int j, float d2) {
      if (all.side[static_cast<std::size_t>(j)] == all.side[i])
        near.push_back({j, kernel(d2, radius)});
    });
    fits[i] = fitAround(all.points[i], all.normals[i], near, all, {Residual::OwnNormal, 3.0f, 3});
    fits[i].density =
        static_cast<float>(near.size()) / (static_cast<float>(M_PI) * radius * radius);
  });
}

// Flying points: too few neighbours agree, or the point lies far off what they say.
bool flies(const Fit& fit, const Vector3f& point) {
  if (fit.support < kFewest) return true;
  const float off = std::abs(fit.normal.dot(point - fit.point));
  return off > std::max(0.3f, 4 * fit.noise);
}

// The sources without the flying ones, with the fits' normals and noise.
Sources believed(const Sources& all, const std::vector<Fit>& fits, std::vector<float>& density) {
  Sources kept;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (flies(fits[i], all.points[i])) continue;
    kept.points.push_back(all.points[i]);
    kept.normals.push_back(fits[i].normal);
    kept.quality.push_back(all.quality[i]);
    kept.noise.push_back(fits[i].noise);
    kept.side.push_back(all.side[i]);
    density.push_back(fits[i].density);
  }
  return kept;
}

// Indices of one source per cube and side, in order.
std::vector<int> seeds(const Sources& all, double edge_mm) {
  PointCloud numbered;
  std::vector<int> chosen;
  for (std::uint8_t side = 0; side < 2; ++side) {
    numbered = {};
    std::vector<int> index;
    for (std::size_t i = 0; i < all.points.size(); ++i)
      if (all.side[i] == side) {
        numbered.points.push_back(all.points[i]);
        index.push_back(static_cast<int>(i));
      }
    // The place of each point travels in `quality`: exact up to 2^24 points.
    for (std::size_t k = 0; k < index.size(); ++k)
      numbered.quality.push_back(static_cast<float>(k));
    if (edge_mm > 0) numbered = thinned(numbered, edge_mm);
    for (const float k : numbered.quality) chosen.push_back(index[static_cast<std::size_t>(k)]);
  }
  return chosen;
}

// The share of the surface of each surfel: a disc shared by those in it that face the same way.
void estimateAreas(Surfels& s, int threads, std::stop_token stop) {
  const float radius = 2.5f * static_cast<float>(s.spacing_mm);
  const PointBins bins(s.points, radius);
  s.area.resize(s.size());
  // At a hole's border the disc is half empty: more than 1.5 squares are not believed.
  const float most = 1.5f * static_cast<float>(s.spacing_mm * s.spacing_mm);
  inBlocks<Nothing>(s.size(), threads, stop, [&](std::size_t i, Nothing) {
    int count = 0;
    bins.within(s.points[i], radius, [&](int j, float) {
      count += s.normals[static_cast<std::size_t>(j)].dot(s.normals[i]) > 0.5f;
    });
    s.area[i] =
        std::min(most, static_cast<float>(M_PI) * radius * radius / static_cast<float>(count));
  });
}

// Median distance along the normal between the sides' own surfaces where both saw the place.
double sideGap(const Sources& all, const std::vector<Fit>& own_fits, float radius, int threads,
               std::stop_token stop) {
  const PointBins bins(all.points, radius);
  std::vector<float> gap(all.points.size(), -1);
  inBlocks<std::vector<Near>>(
      all.points.size(), threads, stop, [&](std::size_t i, std::vector<Near>& near) {
        if (all.side[i] != 0) return;
        near.clear();
        bins.within(all.points[i], radius, [&](int j, float d2) {
          if (all.side[static_cast<std::size_t>(j)] == 1) near.push_back({j, kernel(d2, radius)});
        });
        if (near.size() < 8) return;
        const Fit other = fitAround(own_fits[i].point, own_fits[i].normal, near, all,
                                    {Residual::BothNormals, 8.0f, 3});
        if (other.support >= 8)
          gap[i] = std::abs((other.point - own_fits[i].point).dot(own_fits[i].normal));
      });
  std::erase_if(gap, [](float g) { return g < 0; });
  return gap.size() < 20 ? 0 : medianOf(std::move(gap));
}

// Of points at places of their own: files of triangles hold each corner many times.
double spacingOf(const PointCloud& cloud) {
  constexpr double kSamePlace_mm = 0.01;
  const double spacing = medianSpacing(cloud);
  return spacing > kSamePlace_mm ? spacing : medianSpacing(thinned(cloud, kSamePlace_mm));
}

Error tooFew() {
  return Error::notEnough(
      message("The scans contain too few points that agree with each other for a model."));
}

// The chosen points, each moved onto the smooth surface through its neighbours. false: stopped.
bool smoothed(const Sources& all, const std::vector<float>& density, const std::vector<int>& chosen,
              float radius, int threads, std::stop_token stop, Surfels& out) {
  const float nearest = kNearestSpacings * static_cast<float>(out.spacing_mm);
  const PointBins bins(all.points, radius);
  std::vector<Fit> smooth(chosen.size());
  const bool whole = inBlocks<std::vector<Near>>(
      chosen.size(), threads, stop, [&](std::size_t k, std::vector<Near>& near) {
        const std::size_t i = static_cast<std::size_t>(chosen[k]);
        // As many neighbours as bring the mean's error down to the floor; the kernel counts half of
        // them.
        const float wanted =
            all.noise[i] / kFitFloor_mm /
            std::sqrt(0.5f * static_cast<float>(M_PI) * std::max(density[i], 0.1f));
        const float reach = std::clamp(wanted, nearest, std::max(nearest, 1.2f));
        smooth[k] = fitWithin(all.points[i], all.normals[i], reach, bins, all,
                              {Residual::BothNormals, 8.0f, 4}, near);
      });
  if (!whole) return false;
  for (std::size_t k = 0; k < smooth.size(); ++k) {
    const std::size_t i = static_cast<std::size_t>(chosen[k]);
    if (smooth[k].support < 2 || (smooth[k].point - all.points[i]).norm() > 1.0f) continue;
    out.points.push_back(smooth[k].point);
    out.normals.push_back(smooth[k].normal);
    out.noise.push_back(all.noise[i]);
    const float floor2 = kFitFloor_mm * kFitFloor_mm;
    out.confidence.push_back(all.quality[i] * floor2 /
                             (smooth[k].noise * smooth[k].noise + floor2));
  }
  return true;
}

}  // namespace

void Surfels::keep(const std::vector<int>& indices) {
  dropped += static_cast<int>(size() - indices.size());
  const auto choose = [&](auto& values) {
    for (std::size_t k = 0; k < indices.size(); ++k)
      values[k] = values[static_cast<std::size_t>(indices[k])];
    values.resize(indices.size());
  };
  choose(points);
  choose(normals);
  choose(noise);
  choose(confidence);
  choose(area);
}

Result<Surfels> mergedSurfels(const PointCloud& front, const PointCloud& back,
                              const Eigen::Isometry3d& front_from_back, double spacing_mm,
                              int threads, std::stop_token stop) {
  Sources raw;
  append(raw, front, 0);
  append(raw, transformed(back, front_from_back), 1);
  const double given = std::max(spacingOf(front), spacingOf(back));
  const float spacing = static_cast<float>(given);
  const float radius =
      std::max(kLeastSpacings * spacing, std::min(kLeastRadius_mm, kWindowSpacings * spacing));
  std::vector<Fit> fits;
  if (!estimateNoise(raw, radius, threads, stop, fits)) return Error::cancelled();
  std::vector<float> density;
  const Sources all = believed(raw, fits, density);
  std::vector<Fit> own;
  for (std::size_t i = 0; i < fits.size(); ++i)
    if (!flies(fits[i], raw.points[i])) own.push_back(fits[i]);

  Surfels out;
  out.spacing_mm = spacing_mm > 0 ? spacing_mm : std::max(given, std::min(0.28, 2 * given));
  out.dropped = static_cast<int>(raw.points.size() - all.points.size());
  // A cube's edge of 1.2 spacings leaves about one point per square of one spacing.
  const std::vector<int> chosen =
      seeds(all, given < 0.8 * out.spacing_mm ? 1.2 * out.spacing_mm : 0);
  if (chosen.size() < kFewestSurfels) return tooFew();

  if (!smoothed(all, density, chosen, radius, threads, stop, out)) return Error::cancelled();
  if (out.size() < kFewestSurfels) return tooFew();
  estimateAreas(out, threads, stop);
  out.noise_mm = medianOf(std::vector(out.noise));
  out.side_gap_mm = sideGap(all, own, radius, threads, stop);
  if (stop.stop_requested()) return Error::cancelled();
  return out;
}

}  // namespace ostraka::model
