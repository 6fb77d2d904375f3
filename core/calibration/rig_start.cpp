#include "calibration/rig_start.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"

namespace ostraka::calibration {
namespace {

double wrapped(double angle) {
  return std::remainder(angle, 2 * M_PI);
}

// Turn about z of a transform that is nearly such a turn.
double turnAboutZ(const Eigen::Matrix3d& rotation) {
  return std::atan2(rotation(1, 0) - rotation(0, 1), rotation(0, 0) + rotation(1, 1));
}

Eigen::Isometry3d turned(double angle) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
}

class Start {
 public:
  Start(const RigState& cameras, const std::vector<ViewPose>& views, std::size_t stops)
      : views_(views) {
    start_.state = cameras;
    start_.camera_posed.assign(cameras.cameras.size(), 0);
    for (int s = 0; s < 2; ++s) {
      start_.state.angles_rad[s].assign(stops, 0);
      start_.stop_measured[s].assign(stops, 0);
    }
  }

  // From the best view outwards: a view with a known camera gives its stop's angle, one with a
  // known angle its camera's pose.
  void spread(Cameras known) {
    std::vector<const ViewPose*> open;
    for (const ViewPose& view : views_) open.push_back(&view);
    std::stable_sort(open.begin(), open.end(),
                     [](const ViewPose* a, const ViewPose* b) { return a->markers > b->markers; });
    if (known == Cameras::Known) {
      start_.camera_posed.assign(start_.camera_posed.size(), 1);
    } else if (!open.empty()) {
      start_.stop_measured[open[0]->side][open[0]->stop] = 1;  // its angle is 0 for now
    }
    for (bool more = true; more;) {
      more = false;
      for (const ViewPose* view : open) more = more || place(*view);
    }
  }

  // A photograph under another's name, or taken while the plate turned, must not place its stop or
  // its camera: each takes what most of its views agree on.
  void takeVotes(Cameras known) {
    for (int round = 0; round < 3; ++round) {
      if (known != Cameras::Known)
        for (std::size_t c = 0; c < start_.camera_posed.size(); ++c)
          if (start_.camera_posed[c]) voteOnCamera(static_cast<int>(c));
      for (int side = 0; side < 2; ++side)
        for (std::size_t k = 0; k < angles(side).size(); ++k)
          if (start_.stop_measured[side][k]) voteOnStop(side, static_cast<int>(k));
    }
  }

  bool sideSeen(int side) const {
    const auto& measured = start_.stop_measured[side];
    return std::find(measured.begin(), measured.end(), 1) != measured.end();
  }

  // The plate may lie turned on the table after the flip; the table's angles are the same.
  void separateTheFlip() {
    std::vector<double> differences;
    for (std::size_t k = 0; k < angles(0).size(); ++k)
      if (start_.stop_measured[0][k] && start_.stop_measured[1][k])
        differences.push_back(angles(1)[k] - angles(0)[k]);
    if (differences.empty()) return;
    const double first = differences[0];
    for (double& d : differences) d = wrapped(d - first);
    const double flip = first + medianOf(differences);
    start_.state.turntable_from_plate[1] = turned(flip);
    for (std::size_t k = 0; k < angles(1).size(); ++k) angles(1)[k] -= flip;
  }

  void fillUnseenStops(const std::vector<int>& numbers) {
    for (int side = 0; side < 2; ++side)
      for (std::size_t k = 0; k < numbers.size(); ++k)
        if (!start_.stop_measured[side][k] && start_.stop_measured[1 - side][k])
          angles(side)[k] = angles(1 - side)[k];
    const std::vector<std::size_t> seen = seenOnAnySide();
    std::vector<double> steps;
    for (std::size_t i = 1; i < seen.size(); ++i)
      if (numbers[seen[i]] == numbers[seen[i - 1]] + 1)
        steps.push_back(wrapped(anyAngle(seen[i]) - anyAngle(seen[i - 1])));
    if (steps.empty()) return;
    const double step = medianOf(steps);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (start_.stop_measured[0][k] || start_.stop_measured[1][k]) continue;
      const auto nearest = *std::min_element(seen.begin(), seen.end(), [&](auto a, auto b) {
        return std::abs(numbers[a] - numbers[k]) < std::abs(numbers[b] - numbers[k]);
      });
      for (int side = 0; side < 2; ++side)
        angles(side)[k] = anyAngle(nearest) + step * (numbers[k] - numbers[nearest]);
    }
  }

  // Angles close to each other on both sides, the front's first one 0.
  void normalise(Cameras known) {
    for (std::size_t k = 0; k < angles(0).size(); ++k) {
      angles(0)[k] = wrapped(angles(0)[k]);
      angles(1)[k] = angles(0)[k] + wrapped(angles(1)[k] - angles(0)[k]);
    }
    if (known == Cameras::Known) return;
    const double zero = angles(0)[0];
    for (int side = 0; side < 2; ++side)
      for (double& angle : angles(side)) angle -= zero;
    for (RigState::Camera& camera : start_.state.cameras)
      camera.camera_from_turntable = camera.camera_from_turntable * turned(zero);
  }

  RigStart take() { return std::move(start_); }

 private:
  static constexpr double kSame_rad = 0.1;  // far less than any step of a plate

  void voteOnStop(int side, int stop) {
    std::vector<double> said;
    for (const ViewPose& view : views_)
      if (view.side == side && view.stop == stop && start_.camera_posed[view.camera])
        said.push_back(
            turnAboutZ((start_.state.cameras[view.camera].camera_from_turntable.inverse() *
                        view.camera_from_plate)
                           .linear()));
    const auto votes = [&](double angle) {
      return std::count_if(said.begin(), said.end(),
                           [&](double a) { return std::abs(wrapped(a - angle)) < kSame_rad; });
    };
    double& angle = angles(side)[stop];
    for (const double candidate : said)
      if (votes(candidate) > votes(angle)) angle = candidate;
  }

  void voteOnCamera(int camera) {
    std::vector<Eigen::Isometry3d> said;
    for (const ViewPose& view : views_)
      if (view.camera == camera && start_.stop_measured[view.side][view.stop])
        said.push_back(view.camera_from_plate * turned(-angles(view.side)[view.stop]));
    const auto votes = [&](const Eigen::Isometry3d& pose) {
      return std::count_if(said.begin(), said.end(), [&](const Eigen::Isometry3d& other) {
        return Eigen::AngleAxisd(Eigen::Matrix3d(pose.linear().transpose() * other.linear()))
                   .angle() < kSame_rad;
      });
    };
    Eigen::Isometry3d& pose = start_.state.cameras[camera].camera_from_turntable;
    for (const Eigen::Isometry3d& candidate : said)
      if (votes(candidate) > votes(pose)) pose = candidate;
  }

  std::vector<double>& angles(int side) { return start_.state.angles_rad[side]; }

  double anyAngle(std::size_t stop) { return angles(start_.stop_measured[0][stop] ? 0 : 1)[stop]; }

  std::vector<std::size_t> seenOnAnySide() const {
    std::vector<std::size_t> seen;
    for (std::size_t k = 0; k < start_.stop_measured[0].size(); ++k)
      if (start_.stop_measured[0][k] || start_.stop_measured[1][k]) seen.push_back(k);
    return seen;
  }

  bool place(const ViewPose& view) {
    char& camera = start_.camera_posed[view.camera];
    char& stop = start_.stop_measured[view.side][view.stop];
    if (static_cast<bool>(camera) == static_cast<bool>(stop)) return false;
    Eigen::Isometry3d& pose = start_.state.cameras[view.camera].camera_from_turntable;
    double& angle = angles(view.side)[view.stop];
    if (camera)
      angle = turnAboutZ((pose.inverse() * view.camera_from_plate).linear());
    else
      pose = view.camera_from_plate * turned(-angle);
    camera = stop = 1;
    return true;
  }

  const std::vector<ViewPose>& views_;
  RigStart start_;
};

}  // namespace

std::optional<RigStart> startRig(const RigState& cameras, const std::vector<ViewPose>& views,
                                 const std::vector<int>& stop_numbers, Cameras known,
                                 SidesShot sides) {
  Start start(cameras, views, stop_numbers.size());
  start.spread(known);
  start.takeVotes(known);
  if (!start.sideSeen(0)) return std::nullopt;
  if (sides == SidesShot::Both && !start.sideSeen(1)) return std::nullopt;
  start.separateTheFlip();
  start.fillUnseenStops(stop_numbers);
  start.normalise(known);
  return start.take();
}

}  // namespace ostraka::calibration
