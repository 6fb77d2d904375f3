#include "cloud/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

// The nearest point no farther than a limit. A search that knows its limit from the start leaves
// aside at once what lies beyond; where most queries find nothing, that is most of the tree.
class NearestWithin {
 public:
  using DistanceType = float;
  explicit NearestWithin(float max_squared)
      : squared_(std::nextafter(max_squared, std::numeric_limits<float>::infinity())) {}
  bool addPoint(float squared, int index) {
    if (squared < squared_) {
      squared_ = squared;
      index_ = index;
    }
    return true;
  }
  float worstDist() const { return squared_; }
  bool full() const { return index_ >= 0; }
  std::size_t size() const { return index_ >= 0 ? 1 : 0; }
  Neighbour found() const { return index_ >= 0 ? Neighbour{index_, squared_} : Neighbour{}; }

 private:
  float squared_;
  int index_ = -1;
};

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

std::size_t KdTree::size() const {
  return tree_->cloud.values.size();
}

Neighbour KdTree::nearest(const Eigen::Vector3f& query, float max_distance_mm) const {
  if (size() == 0) return {};
  NearestWithin result(max_distance_mm * max_distance_mm);
  tree_->index.findNeighbors(result, query.data(), nanoflann::SearchParams());
  return result.found();
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
