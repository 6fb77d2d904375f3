#include "texture/sherd_views.h"

#include <algorithm>

#include "base/parallel.h"
#include "batch/photograph.h"

namespace ostraka::texture {
namespace {

constexpr double kHidesFrom_mm = 100;  // between two sherds' middles, less their own sizes

using Points = std::vector<Eigen::Vector3d>;

struct InCamera {
  Points points;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double radius = 0;
};

Eigen::Isometry3d meshFromPlate(const Photograph& photograph, const Subject& sherd) {
  return photograph.image.side == batch::Side::Front ? Eigen::Isometry3d::Identity()
                                                     : sherd.front_from_back;
}

InCamera inCamera(const Photograph& photograph, const Subject& sherd) {
  const Eigen::Isometry3d camera_from_mesh =
      photograph.image.camera_from_plate * meshFromPlate(photograph, sherd).inverse();
  InCamera in;
  for (const Eigen::Vector3f& p : sherd.points) {
    in.points.push_back(camera_from_mesh * p.cast<double>());
    in.middle += in.points.back() / static_cast<double>(sherd.points.size());
  }
  for (const Eigen::Vector3d& p : in.points)
    in.radius = std::max(in.radius, (p - in.middle).norm());
  return in;
}

// Of one photograph, by sherd.
std::vector<std::optional<View>> shownBy(const Photograph& photograph, const cv::Mat3b& picture,
                                         const std::vector<Subject>& sherds) {
  std::vector<InCamera> all;
  for (const Subject& sherd : sherds) all.push_back(inCamera(photograph, sherd));
  std::vector<std::optional<View>> shown;
  for (std::size_t s = 0; s < sherds.size(); ++s) {
    shown.push_back(cutOut(picture, photograph.mask, photograph.image,
                           meshFromPlate(photograph, sherds[s]), sherds[s].points));
    if (!shown.back()) continue;
    shown.back()->light_from_mesh =
        photograph.light_from_plate * meshFromPlate(photograph, sherds[s]).linear().transpose();
    Points others;
    for (std::size_t o = 0; o < sherds.size(); ++o)
      if (o != s &&
          (all[o].middle - all[s].middle).norm() < all[o].radius + all[s].radius + kHidesFrom_mm)
        others.insert(others.end(), all[o].points.begin(), all[o].points.end());
    hideOthers(*shown.back(), all[s].points, others);
  }
  return shown;
}

}  // namespace

SherdViews::SherdViews(std::vector<Photograph> photographs, std::vector<Subject> sherds,
                       int threads)
    : photographs_(std::move(photographs)), sherds_(std::move(sherds)), threads_(threads) {}

Result<Shown> SherdViews::of(std::size_t sherd, const std::stop_token& stop) {
  if (!views_)
    if (const Result<void> done = read(stop); !done) return done.error();
  if (!unread_.empty() && unread_.size() == photographs_.size()) return unread_.front();
  return Shown{(*views_)[sherd], unread_};
}

Result<void> SherdViews::read(const std::stop_token& stop) {
  std::vector<std::vector<std::optional<View>>> shown(photographs_.size());
  std::vector<std::optional<Error>> errors(photographs_.size());
  parallelFor(photographs_.size(), threads_, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const Photograph& one = photographs_[i];
    const Result<cv::Mat> picture = batch::readPhotograph(one.image.file);
    if (!picture) {
      errors[i] = picture.error();
      return;
    }
    shown[i] = shownBy(one, *picture, sherds_);
  });
  if (stop.stop_requested()) return Error::cancelled();
  for (const std::optional<Error>& error : errors)
    if (error) unread_.push_back(*error);
  views_.emplace(sherds_.size());
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (std::size_t s = 0; s < shown[i].size(); ++s) {
      if (!shown[i][s]) continue;
      shown[i][s]->photograph = static_cast<int>(i);
      (*views_)[s].push_back(std::move(*shown[i][s]));
    }
  return {};
}

}  // namespace ostraka::texture
