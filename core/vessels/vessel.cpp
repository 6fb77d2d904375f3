#include "vessels/vessel.h"

#include <algorithm>
#include <numbers>

namespace ostraka::vessels {
namespace {

using Profile = std::vector<Eigen::Vector2d>;  // (radius, height), mm

// Control points from the base's centre to the rim; the first two lie on the flat base.
Profile controlPoints(VesselForm form, Random& r) {
  const double k = r.uniform(0.9, 1.15);
  Profile p;
  if (form == VesselForm::Bowl) {
    const double base = r.uniform(26, 36), mouth = r.uniform(92, 115), height = r.uniform(58, 80);
    p = {{0, 0},
         {base * 0.6, 0},
         {base, 0.5},
         {base + 0.42 * (mouth - base), height * 0.22},
         {base + 0.78 * (mouth - base), height * 0.58},
         {mouth - 2, height * 0.88},
         {mouth + r.uniform(-2, 4), height}};
  } else if (form == VesselForm::Jar) {
    const double base = r.uniform(36, 48), belly = r.uniform(95, 120), neck = r.uniform(62, 76);
    p = {{0, 0},
         {base * 0.6, 0},
         {base, 0.5},
         {belly * 0.82, 48},
         {belly, 98},
         {belly * 0.9, 142},
         {neck + 4, 172},
         {neck, 188},
         {neck + r.uniform(5, 11), 203}};
  } else {
    const double base = r.uniform(32, 42), belly = r.uniform(68, 84), neck = r.uniform(31, 38);
    p = {{0, 0},          {base * 0.6, 0},
         {base, 0.5},     {belly * 0.86, 32},
         {belly, 70},     {belly * 0.86, 104},
         {neck + 6, 132}, {neck, 152},
         {neck + 1, 172}, {neck + r.uniform(4, 8), 186}};
  }
  for (Eigen::Vector2d& q : p) q *= k;
  return p;
}

// Centripetal enough for points this even: uniform Catmull-Rom, 64 points a segment.
Profile spline(const Profile& c) {
  Profile out;
  const int n = static_cast<int>(c.size());
  const auto point = [&](int i) -> Eigen::Vector2d {
    if (i < 0) return {-c[1].x(), c[1].y()};  // mirrored at the axis
    if (i >= n) return 2 * c[n - 1] - c[n - 2];
    return c[i];
  };
  for (int i = 0; i + 1 < n; ++i)
    for (int k = 0; k < 64; ++k) {
      const double t = k / 64.0;
      const Eigen::Vector2d p0 = point(i - 1), p1 = point(i), p2 = point(i + 1), p3 = point(i + 2);
      out.push_back(0.5 * (2 * p1 + (p2 - p0) * t + (2 * p0 - 5 * p1 + 4 * p2 - p3) * t * t +
                           (3 * p1 - p0 - 3 * p2 + p3) * t * t * t));
    }
  out.push_back(c.back());
  return out;
}

Profile resampled(const Profile& line, double step) {
  std::vector<double> length(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    length[i] = length[i - 1] + (line[i] - line[i - 1]).norm();
  Profile out;
  std::size_t i = 1;
  const int count = static_cast<int>(length.back() / step);
  for (int k = 0; k <= count; ++k) {
    const double s = k * step;
    while (i + 1 < line.size() && length[i] < s) ++i;
    const double t = (s - length[i - 1]) / std::max(1e-12, length[i] - length[i - 1]);
    out.push_back(line[i - 1] + t * (line[i] - line[i - 1]));
  }
  return out;
}

// Moving mean over +-half samples; beyond the ends odd (mirror < 0) or point-mirrored values.
std::vector<double> smoothed(const std::vector<double>& v, int half, double mirror_at_start) {
  const int n = static_cast<int>(v.size());
  std::vector<double> out(v.size());
  const auto value = [&](int i) {
    if (i < 0) return mirror_at_start * v[std::min(n - 1, -i)];
    if (i >= n) return 2 * v[n - 1] - v[std::max(0, 2 * (n - 1) - i)];
    return v[i];
  };
  for (int i = 0; i < n; ++i) {
    double sum = 0;
    for (int k = -half; k <= half; ++k) sum += value(i + k);
    out[i] = sum / (2 * half + 1);
  }
  return out;
}

}  // namespace

const char* name(VesselForm form) {
  return form == VesselForm::Bowl ? "bowl" : form == VesselForm::Jar ? "jar" : "jug";
}

double Vessel::at(const std::vector<double>& values, double s) const {
  const double x = std::clamp(s / step_, 0.0, static_cast<double>(values.size()) - 1.0001);
  const auto i = static_cast<std::size_t>(x);
  return values[i] + (x - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

Vessel Vessel::make(VesselForm form, double wall_mm, Random& random) {
  Vessel v;
  v.form_ = form;
  v.seed_ = static_cast<std::uint32_t>(random.next());
  v.ridge_mm_ = random.uniform(0.03, 0.12);
  v.ridge_period_ = random.uniform(4, 8);
  const Profile control = controlPoints(form, random);
  const Profile line = resampled(spline(control), step_);
  for (const Eigen::Vector2d& p : line) {
    v.radius_.push_back(p.x());
    v.height_.push_back(p.y());
  }
  const int bend = static_cast<int>(3.5 / step_);  // a heel's rounding
  for (int round = 0; round < 2; ++round) {
    v.radius_ = smoothed(v.radius_, bend, -1);
    v.height_ = smoothed(v.height_, bend, 1);
  }
  v.heel_ = control[2].x();
  const std::size_t n = v.radius_.size();
  v.normal_r_.resize(n);
  v.normal_z_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(n - 1, i + 1);
    const Eigen::Vector2d t =
        Eigen::Vector2d(v.radius_[b] - v.radius_[a], v.height_[b] - v.height_[a]).normalized();
    v.normal_r_[i] = t.y();
    v.normal_z_[i] = -t.x();
  }
  // Directions through the wall, smoothed over more than its thickness so that they never cross.
  const int across = static_cast<int>(1.2 * wall_mm / step_);
  v.normal_r_ = smoothed(smoothed(v.normal_r_, across, -1), across, -1);
  v.normal_z_ = smoothed(smoothed(v.normal_z_, across, 1), across, 1);
  const double base = random.uniform(1.05, 1.3), top = random.uniform(0.8, 0.95);
  const double lip = random.uniform(0.85, 1.45);
  v.thickness_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) * step_, u = s / v.length();
    const double foot = 1 / (1 + std::exp((s - v.heel_ - 8) / 4));
    const double rim = std::exp(-std::pow((v.length() - s) / 7, 2));
    const double local = wall_mm * (1 + (top - 1) * u + (base - 1) * foot + (lip - 1) * rim);
    v.thickness_[i] = std::clamp(local, 3.0, 10.0);
  }
  return v;
}

Eigen::Vector3d Vessel::place(double s, double theta, double depth) const {
  const double r = at(radius_, s) - depth * at(normal_r_, s);
  return {r * std::cos(theta), r * std::sin(theta), at(height_, s) - depth * at(normal_z_, s)};
}

double Vessel::weathering(const Eigen::Vector3d& p, std::uint32_t face) const {
  const double deep = 0.22 * fractalNoise((p / 4).cast<float>(), seed_ + face, 4, 0.57f);
  return deep > 0 ? deep : 0.3 * deep;  // what stands out is rubbed off
}

Eigen::Vector3d Vessel::outer(double s, double theta) const {
  const Eigen::Vector3d p = place(s, theta, 0);
  const double uneven = 0.09 * fractalNoise((p / 14).cast<float>(), seed_, 3);
  const double ridge = 0.35 * ridge_mm_ * std::sin(2 * std::numbers::pi * s / ridge_period_);
  return place(s, theta, uneven + ridge + weathering(p, 13));
}

Eigen::Vector3d Vessel::inner(double s, double theta) const {
  const Eigen::Vector3d p = place(s, theta, 0);
  const double uneven = 0.16 * fractalNoise((p / 11).cast<float>(), seed_ + 7, 3);
  const double ridge = ridge_mm_ * std::sin(2 * std::numbers::pi * s / ridge_period_ + theta * 0.5);
  return place(s, theta, at(thickness_, s) + uneven + ridge + weathering(p, 17));
}

}  // namespace ostraka::vessels
