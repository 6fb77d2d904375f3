#include "virtualrig/layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "cloud/nearest.h"
#include "vessels/rest.h"

namespace ostraka::virtualrig {
namespace {

constexpr double kGap = 4;  // mm between sherds

// 1 mm cells of the plate that are taken, widened by the gap.
class Occupancy {
 public:
  static constexpr int kSide = 2 * 140;
  explicit Occupancy(const FreeArea& free) : free_(free), taken_(kSide * kSide, 0) {}

  bool fits(const std::vector<Eigen::Vector2d>& shape, const Eigen::Isometry2d& pose) const {
    for (const Eigen::Vector2d& p : shape) {
      const Eigen::Vector2d q = pose * p;
      if (!free_.holds(q) || taken_[index(q)]) return false;
    }
    return true;
  }
  void take(const std::vector<Eigen::Vector2d>& shape, const Eigen::Isometry2d& pose) {
    const int reach = static_cast<int>(kGap);
    for (const Eigen::Vector2d& p : shape) {
      const Eigen::Vector2d q = pose * p;
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
          if (dx * dx + dy * dy <= reach * reach) taken_[index(q + Eigen::Vector2d(dx, dy))] = 1;
    }
  }

 private:
  static std::size_t index(const Eigen::Vector2d& p) {
    const int x = std::clamp(static_cast<int>(std::floor(p.x())) + kSide / 2, 0, kSide - 1);
    const int y = std::clamp(static_cast<int>(std::floor(p.y())) + kSide / 2, 0, kSide - 1);
    return static_cast<std::size_t>(y) * kSide + x;
  }
  const FreeArea& free_;
  std::vector<char> taken_;
};

// One point per mm^2 of the sherd's shadow on the plate, in its rest pose.
std::vector<Eigen::Vector2d> footprint(const vessels::VirtualSherd& sherd,
                                       const Eigen::Isometry3d& rest) {
  std::vector<Eigen::Vector2i> cells;
  for (const Eigen::Vector3f& v : sherd.mesh.vertices) {
    const Eigen::Vector3d p = rest * v.cast<double>();
    cells.emplace_back(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
  }
  const auto less = [](const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
    return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
  };
  std::sort(cells.begin(), cells.end(), less);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Eigen::Vector2d> out;
  for (const Eigen::Vector2i& c : cells)
    out.push_back(c.cast<double>() + Eigen::Vector2d(0.5, 0.5));
  return out;
}

Eigen::Isometry2d planar(double turn, const Eigen::Vector2d& shift) {
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.linear() = Eigen::Rotation2Dd(turn).toRotationMatrix();
  pose.translation() = shift;
  return pose;
}

Eigen::Isometry3d lifted(const Eigen::Isometry2d& pose) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear().topLeftCorner<2, 2>() = pose.linear();
  out.translation().head<2>() = pose.translation();
  return out;
}

// The turn about z that brings a rest pose nearest to a wanted orientation.
double turnTowards(const Eigen::Matrix3d& wanted, const Eigen::Matrix3d& rest) {
  const Eigen::Matrix3d m = wanted * rest.transpose();
  return std::atan2(m(1, 0) - m(0, 1), m(0, 0) + m(1, 1));
}

Eigen::Vector2d inDisc(vessels::Random& random, double radius) {
  const double r = radius * std::sqrt(random.uniform()),
               angle = random.uniform(0, 2 * std::numbers::pi);
  return {r * std::cos(angle), r * std::sin(angle)};
}

struct Piece {
  Eigen::Isometry3d rest;
  std::vector<Eigen::Vector2d> shape;
};

Piece laidDown(const vessels::VirtualSherd& sherd, const Eigen::Vector3d& up) {
  const Eigen::Isometry3d rest = vessels::restPose(sherd.mesh, up);
  return {rest, footprint(sherd, rest)};
}

// Slides a piece from this direction towards another one until their surfaces touch.
std::optional<Eigen::Isometry2d> against(const vessels::VirtualSherd& moving, const Piece& piece,
                                         const vessels::VirtualSherd& other,
                                         const Eigen::Isometry3d& other_pose, double direction_rad,
                                         double turn_rad) {
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& v : other.mesh.vertices)
    points.push_back((other_pose * v.cast<double>()).cast<float>());
  const KdTree tree(points);
  const Eigen::Vector2d direction(std::cos(direction_rad), std::sin(direction_rad));
  const Eigen::Vector2d target = other_pose.translation().head<2>();
  double distance = 0.5 * (moving.width_mm + other.width_mm) + 30;
  bool coarse = true;  // every fifth vertex, until the gap is a few of their distances
  while (distance > 5) {
    const Eigen::Isometry2d pose = planar(turn_rad, target + distance * direction);
    const Eigen::Isometry3d full = lifted(pose) * piece.rest;
    float nearest = 900;
    const std::size_t step = coarse ? 5 : 1;
    for (std::size_t i = 0; i < moving.mesh.vertices.size(); i += step) {
      const Eigen::Vector3f p = (full * moving.mesh.vertices[i].cast<double>()).cast<float>();
      const Neighbour found = tree.nearest(p, std::sqrt(nearest));
      if (found.index >= 0) nearest = std::min(nearest, found.squared_distance);
    }
    const double gap = std::sqrt(nearest);
    if (coarse && gap < 3) {
      coarse = false;
      continue;
    }
    if (gap < 0.35) return pose;  // vertices are half a millimetre apart: the surfaces touch
    distance -= std::max(0.05, 0.9 * (gap - 0.3));
  }
  return std::nullopt;
}

class Arranger {
 public:
  Arranger(const std::vector<vessels::VirtualSherd>& sherds, const SimulateOptions& options,
           vessels::Random& random)
      : sherds_(sherds),
        options_(options),
        free_(freeArea(options)),
        scramble_(options.scramble || options.hand_held),
        random_(random),
        ups_(sherds.size(), 1) {}

  bool front(Layout& layout) {
    laid_.clear();
    for (std::size_t s = 0; s < sherds_.size(); ++s) {
      ups_[s] = random_.chance(0.5) ? 1 : -1;
      const Piece piece = laidDown(sherds_[s], Eigen::Vector3d(0, 0, ups_[s]));
      if (!place(
              piece, s, layout.front, [&](int) { return anywhere(); },
              [&] {
                return Contact{turn(), turn()};
              }))
        return false;
    }
    return true;
  }

  bool back(Layout& layout) {
    laid_.clear();
    const Eigen::Matrix3d flip =
        Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
    for (std::size_t s = 0; s < sherds_.size(); ++s) {
      const Piece piece = laidDown(sherds_[s], Eigen::Vector3d(0, 0, -ups_[s]));
      const double kept = turnTowards(flip * layout.front[s].linear(), piece.rest.linear());
      const Eigen::Vector3d c = flip * layout.front[s].translation();
      const auto by_hand = [&](int round) {
        if (scramble_) return anywhere();
        const double off = random_.uniform(3, 11 + 0.01 * round), way = turn();
        return planar(kept + random_.uniform(-std::numbers::pi / 6, std::numbers::pi / 6),
                      c.head<2>() + off * Eigen::Vector2d(std::cos(way), std::sin(way)));
      };
      const auto contact = [&] {
        if (scramble_ || s == 0) return Contact{turn(), turn()};
        const Eigen::Vector3d from = c - flip * layout.front[s - 1].translation();
        return Contact{std::atan2(from.y(), from.x()) + random_.uniform(-0.3, 0.3),
                       kept + random_.uniform(-0.3, 0.3)};
      };
      if (!place(piece, s, layout.back, by_hand, contact)) return false;
    }
    return true;
  }

 private:
  struct Contact {
    double direction_rad, turn_rad;
  };

  double turn() { return random_.uniform(0, 2 * std::numbers::pi); }
  Eigen::Isometry2d anywhere() {
    const double angle = turn();
    const Eigen::Vector2d p = inDisc(random_, free_.radius - 10);
    return planar(angle, p.cwiseProduct(free_.half.cwiseMin(free_.radius) / free_.radius));
  }

  // Draws until the piece fits beside those that lie already; one of a touching pair is slid
  // against its partner instead.
  template <class Draw, class DrawContact>
  bool place(const Piece& piece, std::size_t s, std::vector<Eigen::Isometry3d>& poses,
             const Draw& draw, const DrawContact& draw_contact) {
    const bool touches = s % 2 == 1 && static_cast<int>(s / 2) < options_.touching;
    Occupancy others(free_);
    for (std::size_t i = 0; i + (touches ? 1 : 0) < laid_.size(); ++i)
      others.take(laid_[i].first, laid_[i].second);
    for (int round = 0; round < (touches ? 12 : 3000); ++round) {
      std::optional<Eigen::Isometry2d> pose;
      if (touches) {
        const Contact contact = draw_contact();
        pose = against(sherds_[s], piece, sherds_[s - 1], poses[s - 1], contact.direction_rad,
                       contact.turn_rad);
      } else {
        pose = draw(round);
      }
      if (!pose || !others.fits(piece.shape, *pose)) continue;
      laid_.emplace_back(piece.shape, *pose);
      poses.push_back(lifted(*pose) * piece.rest);
      return true;
    }
    return false;
  }

  const std::vector<vessels::VirtualSherd>& sherds_;
  const SimulateOptions& options_;
  const FreeArea free_;
  const bool scramble_;
  vessels::Random& random_;
  std::vector<int> ups_;
  std::vector<std::pair<std::vector<Eigen::Vector2d>, Eigen::Isometry2d>> laid_;
};

}  // namespace

double FreeArea::area() const {
  return half.minCoeff() >= radius ? std::numbers::pi * radius * radius : 4 * half.prod();
}

FreeArea freeArea(const SimulateOptions& options) {
  FreeArea free;
  if (!options.hand_held) return free;
  free.half = rig::sheetSize(options.hand_held->sheet) / 2 - Eigen::Vector2d(30.5, 30);
  free.radius = std::min(free.half.norm(), 124.0);
  free.half = free.half.cwiseMin(free.radius);
  return free;
}

Result<Layout> layOut(const std::vector<vessels::VirtualSherd>& sherds,
                      const SimulateOptions& options, vessels::Random& random) {
  for (int round = 0; round < 30; ++round) {
    Layout layout;
    Arranger arranger(sherds, options, random);
    if (arranger.front(layout) && arranger.back(layout)) return layout;
  }
  if (options.hand_held)
    return Error::unusable("The " + std::to_string(sherds.size()) +
                           " sherds do not fit on the sheet; use fewer, or a larger sheet.");
  return Error::unusable(
      message("The %1 sherds do not fit on the plate; use fewer, or another seed.", sherds.size()));
}

}  // namespace ostraka::virtualrig
