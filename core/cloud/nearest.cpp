#include "cloud/nearest.h"

#include <algorithm>
#include <nanoflann.hpp>

namespace ostraka {
namespace {

struct Points {
  std::vector<Eigen::Vector3f> values;
  std::size_t kdtree_get_point_count() const { return values.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return values[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>,
                                                  Points, 3, int>;

// Equal distances are ordered by index, so that ties do not depend on the tree's layout.
void order(std::vector<Neighbour>& found) {
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                    : a.index < b.index;
  });
}

}  // namespace

struct KdTree::Tree {
  explicit Tree(std::span<const Eigen::Vector3f> points)
      : cloud{{points.begin(), points.end()}},
        index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {}
  Points cloud;
  Index index;
};

KdTree::KdTree(std::span<const Eigen::Vector3f> points) : tree_(std::make_unique<Tree>(points)) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

std::size_t KdTree::size() const { return tree_->cloud.values.size(); }

Neighbour KdTree::nearest(const Eigen::Vector3f& query, float max_distance_mm) const {
  if (size() == 0) return {};
  Neighbour best;
  nanoflann::KNNResultSet<float, int> result(1);
  result.init(&best.index, &best.squared_distance);
  if (!tree_->index.findNeighbors(result, query.data(), nanoflann::SearchParams()) ||
      best.squared_distance > max_distance_mm * max_distance_mm)
    return {};
  return best;
}

void KdTree::nearest(const Eigen::Vector3f& query, int k, std::vector<Neighbour>& found) const {
  found.clear();
  if (size() == 0 || k <= 0) return;
  const int wanted = std::min<int>(k, static_cast<int>(size()));
  std::vector<int> indices(wanted);
  std::vector<float> distances(wanted);
  nanoflann::KNNResultSet<float, int> result(wanted);
  result.init(indices.data(), distances.data());
  tree_->index.findNeighbors(result, query.data(), nanoflann::SearchParams());
  for (std::size_t i = 0; i < result.size(); ++i) found.push_back({indices[i], distances[i]});
  order(found);
}

void KdTree::within(const Eigen::Vector3f& query, float radius_mm,
                    std::vector<Neighbour>& found) const {
  found.clear();
  if (size() == 0) return;
  std::vector<std::pair<int, float>> matches;
  tree_->index.radiusSearch(query.data(), radius_mm * radius_mm, matches,
                            nanoflann::SearchParams(32, 0, false));
  for (const auto& [index, squared] : matches) found.push_back({index, squared});
  order(found);
}

}  // namespace ostraka
