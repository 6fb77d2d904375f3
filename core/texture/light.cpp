#include "texture/light.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <set>

#include "base/median.h"
#include "base/message.h"
#include "base/parallel.h"

namespace ostraka::texture {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLeastLight = 0.2;      // of that from above
constexpr double kLeastPositive = 0.02;  // of the mean, while it is sought
constexpr double kLeastFacing = 0.3;     // more slant is mostly blur of what lies around
constexpr double kBlur_mm = 0.5;         // relief below it has normals of its own
constexpr double kDarkLevel = 8, kClippedLevel = 247;
constexpr double kUsualOff = 0.1;      // of logarithms
constexpr double kOwnExposure = 1e-3;  // pull of each photograph towards its own exposure
constexpr double kEvenLight = 1e-7;    // pull towards light from everywhere
// Rounding to a level, and what nine terms leave of a light.
constexpr double kLeastNoise = 0.01;
// Less than a step of L* on a mid grey, which nobody sees.
constexpr double kMostUncertain = 0.03;
constexpr int kLightRounds = 15, kLightHalvings = 12;
constexpr int kGroups = 10, kNoGroup = -1, kRoundsWithout = 4;
constexpr int kLeastSherds = 6;     // fewer tell little of how sherds differ
constexpr double kPlace_mm = 10.0;  // an error of the model's normals does not reach farther
constexpr Index kTerms = 8;         // beside the mean, which is 1 while it is sought

double linearLight(double level) {
  const double v = level / 255;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double encodedLevel(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

// The terms beside the mean.
using Terms8 = Eigen::Matrix<double, kTerms, 1>;

Terms8 shape(const Vector3d& normal) {
  return Light::terms(normal).tail<kTerms>();
}

// One channel's samples, and what is sought of it.
struct Channel {
  struct One {
    Index photograph = 0;
    Terms8 terms;
    double log_light = 0, weight = 0;
  };
  std::vector<std::vector<One>> points;
  std::vector<int> groups;  // of the points, for the jackknife
  Index photographs = 0;

  Terms8 light = Terms8::Zero();
  VectorXd exposures;  // logarithms
  MatrixXd information;
  double total = 0;         // of the weights
  std::vector<double> off;  // of each sample from its point's mean, before the step

  // One step. usual_off: beyond it a sample is a highlight or a shadow, of logarithms. without:
  // a group that takes no part.
  void step(double usual_off, int without = kNoGroup);
  double leastOf(const Terms8& of) const {
    double least = INFINITY;
    for (const std::vector<One>& point : points)
      for (const One& s : point) least = std::min(least, 1 + of.dot(s.terms));
    return least;
  }
};

void Channel::step(double usual_off, int without) {
  const Index all = kTerms + photographs;
  information = MatrixXd::Zero(all, all);
  VectorXd towards = VectorXd::Zero(all);
  total = 0;
  off.clear();
  std::vector<double> weights, residuals;
  VectorXd sum(all);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const std::vector<One>& point = points[p];
    if (groups[p] == without) continue;
    weights.clear();
    residuals.clear();
    for (const One& s : point) {
      residuals.push_back(s.log_light - exposures[s.photograph] - std::log(1 + light.dot(s.terms)));
      weights.push_back(s.weight);
    }
    const double middle = medianOf(std::vector<double>(residuals));
    double mean = 0, weight = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double beside = residuals[i] - middle;
      weights[i] /= 1 + beside * beside / (usual_off * usual_off);
      weight += weights[i];
      mean += weights[i] * residuals[i];
    }
    mean /= weight;
    // The albedo is eliminated: min over it of the weighted squares.
    sum.setZero();
    for (std::size_t i = 0; i < point.size(); ++i) {
      const One& s = point[i];
      const Terms8 slope = s.terms / (1 + light.dot(s.terms));
      const Index at = kTerms + s.photograph;
      const double w = weights[i], r = residuals[i] - mean;
      off.push_back(std::abs(r));
      information.topLeftCorner<kTerms, kTerms>() += w * slope * slope.transpose();
      information.block<kTerms, 1>(0, at) += w * slope;
      information(at, at) += w;
      towards.head<kTerms>() += w * r * slope;
      towards[at] += w * r;
      sum.head<kTerms>() += w * slope;
      sum[at] += w;
    }
    information.topLeftCorner<kTerms, kTerms>() -=
        sum.head<kTerms>() * sum.head<kTerms>().transpose() / weight;
    for (const One& s : point) {
      const Index at = kTerms + s.photograph;
      information.block<kTerms, 1>(0, at) -= sum.head<kTerms>() * (sum[at] / weight);
      for (const One& other : point)
        information(at, kTerms + other.photograph) -=
            sum[at] * sum[kTerms + other.photograph] / weight;
    }
    total += weight;
  }
  information.bottomLeftCorner(photographs, kTerms) =
      information.topRightCorner(kTerms, photographs).transpose();
  const double stay = kOwnExposure * total / static_cast<double>(std::max<Index>(1, photographs));
  information.diagonal().tail(photographs).array() += stay;
  towards.tail(photographs) -= stay * exposures;
  MatrixXd pulled = information;
  pulled.diagonal().head<kTerms>().array() += kEvenLight * total;
  towards.head<kTerms>() -= kEvenLight * total * light;
  VectorXd change = pulled.ldlt().solve(towards);
  for (int i = 0; i < kLightHalvings; ++i) {
    if (leastOf(light + change.head<kTerms>()) > kLeastPositive) {
      light += change.head<kTerms>();
      exposures += change.tail(photographs);
      return;
    }
    change /= 2;
  }
}

// Of each point: groups whose errors have little to do with each other's.
std::vector<int> groupsOf(const std::vector<LitPoint>& points) {
  std::map<int, int> sherds;
  for (const LitPoint& point : points) sherds.try_emplace(point.sherd, 0);
  int count = 0;
  for (auto& sherd : sherds) sherd.second = count++;
  std::vector<int> groups;
  for (const LitPoint& point : points) {
    int group = sherds.at(point.sherd);
    if (count < kLeastSherds)
      // Neighbouring places, and those of both faces, are in unlike groups.
      for (Index k = 0; k < 3; ++k)
        group += (3 + 2 * static_cast<int>(k)) *
                 static_cast<int>(std::floor(point.place[k] / kPlace_mm));
    groups.push_back((group % kGroups + kGroups) % kGroups);
  }
  return groups;
}

Channel channelOf(const std::vector<LitPoint>& points, const std::vector<int>& groups,
                  Index channel) {
  Channel of;
  std::map<int, Index> photographs;
  for (const LitPoint& point : points)
    for (const LitPoint::Sample& s : point.samples) photographs.try_emplace(s.photograph, 0);
  for (auto& named : photographs) named.second = of.photographs++;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].samples.size() < 2) continue;
    of.points.emplace_back();
    of.groups.push_back(groups[i]);
    for (const LitPoint::Sample& s : points[i].samples)
      of.points.back().push_back({photographs.at(s.photograph), shape(s.normal),
                                  std::log(std::max(s.light[channel], 1e-6)), s.weight});
  }
  of.exposures = VectorXd::Zero(of.photographs);
  return of;
}

// How much the logarithm of the light on a normal changes with each term, beside that from above.
Terms8 slopeBeside(const Channel& channel, const Terms8& terms) {
  const Terms8 up = shape(Vector3d::UnitZ());
  return terms / (1 + channel.light.dot(terms)) - up / (1 + channel.light.dot(up));
}

using Matrix8 = Eigen::Matrix<double, kTerms, kTerms>;

// What the samples tell of the terms, exposures and albedos being unknown.
Matrix8 informationOn(const Channel& channel) {
  const Index photographs = channel.photographs;
  const MatrixXd& all = channel.information;
  const MatrixXd shared = all.topRightCorner(kTerms, photographs);
  return all.topLeftCorner(kTerms, kTerms) -
         shared * all.bottomRightCorner(photographs, photographs).ldlt().solve(shared.transpose());
}

// Of the logarithm of the light on what the samples show, for an error of the terms.
double rmsOver(const Channel& channel, const Matrix8& squared_error) {
  double sum = 0, count = 0;
  for (const std::vector<Channel::One>& point : channel.points)
    for (const Channel::One& s : point) {
      const Terms8 slope = slopeBeside(channel, s.terms);
      sum += slope.dot(squared_error * slope);
      ++count;
    }
  const double mean = sum / count;
  return mean >= 0 ? std::sqrt(mean) : INFINITY;  // no error is known of what cannot be solved
}

double uncertaintyOf(const Channel& channel, double noise) {
  Matrix8 own = informationOn(channel);
  own.diagonal().array() += 1e-9 * channel.total;  // nothing is known where this is all
  const Terms8 pull =
      kEvenLight * channel.total * own.ldlt().solve(channel.light);  // to even light
  const Matrix8 bias = pull * pull.transpose();
  const Matrix8 independent =
      own.inverse() * (noise * noise * channel.total / static_cast<double>(channel.off.size()));
  Matrix8 jackknife = Matrix8::Zero();
  const std::set<int> groups(channel.groups.begin(), channel.groups.end());
  if (groups.size() < 2) return INFINITY;
  for (const int group : groups) {
    Channel without = channel;
    for (int round = 0; round < kRoundsWithout; ++round) without.step(kUsualOff, group);
    const Terms8 change = without.light - channel.light;
    jackknife += change * change.transpose();
  }
  const auto count = static_cast<double>(groups.size());
  jackknife *= (count - 1) / count;
  return std::max(rmsOver(channel, independent + bias), rmsOver(channel, jackknife + bias));
}

LightFit fitTo(const std::vector<LitPoint>& points) {
  LightFit found;
  const std::vector<int> groups = groupsOf(points);
  for (Index k = 0; k < 3; ++k) {
    Channel channel = channelOf(points, groups, k);
    if (channel.points.empty()) {
      found.uncertainty = INFINITY;
      return found;
    }
    for (int round = 0; round < kLightRounds; ++round)
      channel.step(round == 0 ? INFINITY : kUsualOff);
    const double noise = std::max(kLeastNoise, 1.4826 * medianOf(channel.off));
    found.residual = std::max(found.residual, noise);
    found.uncertainty = std::max(found.uncertainty, uncertaintyOf(channel, noise));
    const double up = 1 + channel.light.dot(shape(Vector3d::UnitZ()));
    found.light.coefficients(0, k) = 1 / up;
    found.light.coefficients.col(k).tail<kTerms>() = channel.light / up;
  }
  return found;
}

}  // namespace

Light::Terms Light::terms(const Vector3d& n) {
  Terms t;
  t << 1, n.x(), n.y(), n.z(), n.x() * n.y(), n.y() * n.z(), 3 * n.z() * n.z() - 1, n.x() * n.z(),
      n.x() * n.x() - n.y() * n.y();
  return t;
}

Vector3d Light::on(const Vector3d& normal) const {
  return (coefficients.transpose() * terms(normal)).cwiseMax(kLeastLight);
}

Eigen::Vector3f Light::without(const Eigen::Vector3f& level, const Vector3d& normal) const {
  const Vector3d light = on(normal);
  Eigen::Vector3f even;
  for (Index k = 0; k < 3; ++k)
    even[k] =
        static_cast<float>(encodedLevel(linearLight(static_cast<double>(level[k])) / light[k]));
  return even;
}

std::vector<LitPoint> litPoints(const TriangleMesh& mesh, const std::vector<View>& views, int sherd,
                                std::size_t most, int threads) {
  std::vector<std::size_t> vertices;
  for (std::size_t i = 0; i < mesh.vertices.size(); i += mesh.vertices.size() / most + 1)
    if (mesh.seen.empty() || mesh.seen[i] != 0) vertices.push_back(i);
  std::vector<std::vector<std::optional<LitPoint::Sample>>> shown(views.size());
  parallelFor(views.size(), threads, [&](std::size_t v) {
    const View& view = views[v];
    const DepthMap depth(mesh, view);
    const double pixel_mm = finestPixel_mm(mesh, {view});
    const double sigma = pixel_mm > 0 ? std::max(0.5, kBlur_mm / pixel_mm) : 0.5;
    const int off = static_cast<int>(std::ceil(std::max(2 * sigma, 1.5 * view.mask_step)));
    cv::Mat1b surely;
    cv::erode(view.mask >= 128, surely,
              cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * off + 1, 2 * off + 1}), {-1, -1}, 1,
              cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::Mat3b soft;
    cv::GaussianBlur(view.picture, soft, {}, sigma);
    shown[v].resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vector3d point = mesh.vertices[vertices[i]].cast<double>(),
                     normal = mesh.normals[vertices[i]].cast<double>(),
                     in_camera = view.camera_from_mesh * point;
      if (!view.isInSight(in_camera)) continue;
      const double cosine = -(view.camera_from_mesh.linear() * normal).dot(in_camera.normalized());
      if (!(cosine >= kLeastFacing)) continue;
      const Eigen::Vector2d pixel = view.project(point);
      const long x = std::lround(pixel.x()), y = std::lround(pixel.y());
      if (x < 0 || y < 0 || x >= surely.cols || y >= surely.rows) continue;
      const cv::Point at(static_cast<int>(x), static_cast<int>(y));
      if (surely(at) == 0 || !depth.sees(pixel, in_camera.z(), cosine)) continue;
      LitPoint::Sample sample{view.photograph, view.light_from_mesh * normal, {}, cosine};
      const cv::Vec3b& level = soft(at);
      const auto [low, high] = std::minmax({level[0], level[1], level[2]});
      if (low < kDarkLevel || high > kClippedLevel) continue;
      for (int k = 0; k < 3; ++k) sample.light[k] = linearLight(level[k]);
      shown[v][i] = sample;
    }
  });
  std::vector<LitPoint> points;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    LitPoint point{sherd, {}, mesh.vertices[vertices[i]].cast<double>()};
    for (const auto& of_view : shown)
      if (of_view[i]) point.samples.push_back(*of_view[i]);
    if (point.samples.size() >= 2) points.push_back(std::move(point));
  }
  return points;
}

Result<LightFit> lightOf(const std::vector<LitPoint>& points) {
  LightFit found = fitTo(points);
  if (!(found.uncertainty <= kMostUncertain))
    return Error::notEnough(message(
        "The photographs do not tell the light from the sherds' own colours, so textures stay as "
        "photographed."));
  return found;
}

}  // namespace ostraka::texture
