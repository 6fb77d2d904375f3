#pragma once
#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace ostraka {

struct Neighbour {
  int index = -1;
  /// mm^2; infinite where nothing was found, so that it is never taken for a hit
  float squared_distance = std::numeric_limits<float>::infinity();
};

/// A k-d tree over points that it copies. Queries are const and may run on several threads.
class KdTree {
 public:
  explicit KdTree(std::span<const Eigen::Vector3f> points);
  ~KdTree();
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;

  /// index -1 and an infinite distance when the tree is empty or nothing lies within
  /// max_distance_mm.
  Neighbour nearest(const Eigen::Vector3f& query, float max_distance_mm = 1e18f) const;
  /// At most k, nearest first.
  void nearest(const Eigen::Vector3f& query, int k, std::vector<Neighbour>& found) const;
  /// All within radius, nearest first.
  void within(const Eigen::Vector3f& query, float radius_mm, std::vector<Neighbour>& found) const;
  std::size_t size() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace ostraka
