#include "stereo/sources.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ostraka::stereo {

Link linkBetween(const Frame& view, const Frame& other, int source) {
  Link link;
  link.source = source;
  link.rotation = other.rotation * view.rotation.transpose();
  link.translation = other.translation - link.rotation * view.translation;
  return link;
}

std::vector<std::vector<Link>> chooseSources(std::span<const Frame* const> frames,
                                             const Eigen::Vector3f& middle,
                                             const DenseOptions& options) {
  constexpr double ideal_rad = 0.35, spread_rad = 0.3;  // 20 degrees: depth against foreshortening
  constexpr std::size_t few = 2;  // a view on each side; with none, nothing is seen at all
  std::vector<std::vector<Link>> all(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Eigen::Vector3f own = (frames[i]->centre - middle).normalized();
    struct Candidate {
      double score;
      std::size_t frame;
      Eigen::Vector3f direction;
    };
    std::vector<Candidate> candidates, distant;
    for (std::size_t j = 0; j < frames.size(); ++j) {
      const Eigen::Vector3f other = (frames[j]->centre - middle).normalized();
      const double angle = std::acos(std::clamp(static_cast<double>(own.dot(other)), -1.0, 1.0));
      if (j == i || angle < options.min_source_angle_rad || angle > options.last_source_angle_rad)
        continue;
      const double off = (angle - ideal_rad) / spread_rad;
      (angle <= options.max_source_angle_rad ? candidates : distant)
          .push_back({std::exp(-0.5 * off * off), j, other});
    }
    std::ranges::sort(distant, std::greater(), [](const auto& one) { return one.score; });
    for (std::size_t k = 0; candidates.size() < few && k < distant.size(); ++k)
      candidates.push_back(distant[k]);
    while (!candidates.empty() && static_cast<int>(all[i].size()) < options.max_sources) {
      const auto best =
          std::ranges::max_element(candidates, {}, [](const auto& one) { return one.score; });
      all[i].push_back(
          linkBetween(*frames[i], *frames[best->frame], static_cast<int>(best->frame)));
      const Eigen::Vector3f taken = best->direction;
      candidates.erase(best);
      for (Candidate& c : candidates)  // two sources in the same place say the same thing
        c.score *=
            1.0 -
            0.5 * std::exp(-0.5 *
                           std::pow(std::acos(std::min(1.0F, taken.dot(c.direction))) / 0.15, 2));
    }
  }
  return all;
}

}  // namespace ostraka::stereo
