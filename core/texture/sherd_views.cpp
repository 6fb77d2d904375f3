#include "texture/sherd_views.h"

#include "base/parallel.h"
#include "batch/photograph.h"

namespace ostraka::texture {

SherdViews::SherdViews(std::vector<Photograph> photographs, std::vector<Subject> sherds,
                       int threads)
    : photographs_(std::move(photographs)), sherds_(std::move(sherds)), threads_(threads) {}

Result<const std::vector<View>*> SherdViews::of(std::size_t sherd, const std::stop_token& stop) {
  if (!views_)
    if (const Result<void> done = read(stop); !done) return done.error();
  return &(*views_)[sherd];
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
    for (const Subject& sherd : sherds_)
      shown[i].push_back(cutOut(*picture, one.mask, one.image,
                                one.image.side == batch::Side::Front ? Eigen::Isometry3d::Identity()
                                                                     : sherd.front_from_back,
                                sherd.points));
  });
  if (stop.stop_requested()) return Error::cancelled();
  for (const std::optional<Error>& error : errors)
    if (error) return *error;
  views_.emplace(sherds_.size());
  for (std::vector<std::optional<View>>& of_photograph : shown)
    for (std::size_t s = 0; s < of_photograph.size(); ++s)
      if (of_photograph[s]) (*views_)[s].push_back(std::move(*of_photograph[s]));
  return {};
}

}  // namespace ostraka::texture
