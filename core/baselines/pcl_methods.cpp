#include "baselines/pcl_methods.h"

#include <random>

// PCL's searches call rand() by its unqualified name. The C library's is shared by all threads, and
// PCL seeds it with the time: this one is found first, and draws from the seed of each call.
namespace pcl {
static int rand();
}

#include <pcl/console/print.h>
#include <pcl/features/fpfh.h>
#include <pcl/keypoints/harris_3d.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_rejection_trimmed.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/ia_fpcs.h>
#include <pcl/registration/ia_kfpcs.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/sample_consensus_prerejective.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>

#include "base/message.h"

namespace ostraka::baselines {
namespace {

using Eigen::Isometry3d;
using Point = pcl::PointNormal;
using Cloud = pcl::PointCloud<Point>;
using Features = pcl::PointCloud<pcl::FPFHSignature33>;

constexpr unsigned kSeed = 1;
constexpr std::size_t kFewestPoints = 20;  // covariances ask for so many neighbours

struct StopRequested {};

// One call of a method: what it draws from, and whether it has to end. Drawing is the one thing
// that PCL's searches do all the time, so that it is there that they are stopped.
struct Call {
  explicit Call(std::stop_token token) : stop(std::move(token)), outer(current) { current = this; }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;
  ~Call() { current = outer; }
  void goOn() const {
    if (stop.stop_requested()) throw StopRequested();
  }

  std::mt19937 engine{kSeed};
  std::stop_token stop;
  Call* outer;
  static thread_local Call* current;  // the library's hook has no argument to hand it through
};
thread_local Call* Call::current = nullptr;

template <class Method>
Result<Isometry3d> called(std::stop_token stop, const Method& method) {
  static std::once_flag quiet;
  std::call_once(quiet, [] { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); });
  const Call call(stop);
  try {
    call.goOn();
    return method();
  } catch (const StopRequested&) {
    return Error::cancelled();
  } catch (const pcl::PCLException&) {
    return notConverged();
  }
}

Cloud::Ptr toPcl(const PointCloud& cloud) {
  Cloud::Ptr points(new Cloud);
  points->reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Point p;
    p.getVector3fMap() = cloud.points[i];
    p.getNormalVector3fMap() = cloud.normals[i];
    p.curvature = 0;
    points->push_back(p);
  }
  return points;
}

// Both sides of one call.
struct Sides {
  Sides(const PointCloud& front_cloud, const PointCloud& back_cloud, double spacing_mm)
      : front(thinned(front_cloud, spacing_mm)), back(thinned(back_cloud, spacing_mm)) {}
  Result<void> check() const { return enoughPoints(front, back); }
  PointCloud front, back;
};

template <class Matrix>
Result<Isometry3d> poseOf(const Matrix& matrix) {
  if (!matrix.allFinite()) return notConverged();
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = matrix.template topRightCorner<3, 1>().template cast<double>();
  pose.linear() =
      Eigen::Quaterniond(matrix.template topLeftCorner<3, 3>().template cast<double>().eval())
          .normalized()
          .toRotationMatrix();
  return pose;
}

// Asked before each round whether to go on; a run that uses up its rounds did not converge.
template <class Icp>
Result<Isometry3d> iterated(Icp& icp, const Sides& sides, const Isometry3d& start,
                            const IcpOptions& options) {
  icp.setInputSource(toPcl(sides.back));
  icp.setInputTarget(toPcl(sides.front));
  icp.setMaxCorrespondenceDistance(options.reach_mm);
  icp.setMaximumIterations(options.max_rounds);
  int rounds = -1;  // it is told once before the first
  std::function<typename Icp::UpdateVisualizerCallbackSignature> each =
      [&rounds](const Cloud&, const pcl::Indices&, const Cloud&, const pcl::Indices&) {
        ++rounds;
        Call::current->goOn();
      };
  icp.registerVisualizationCallback(each);
  Cloud aligned;
  icp.align(aligned, start.matrix());
  if (!icp.hasConverged() || rounds >= options.max_rounds) return notConverged();
  return poseOf(icp.getFinalTransformation());
}

// 4PCS tests every congruent quadruple it finds, which on a regular break are millions. Of more
// than max_matches only so many are tested, evenly taken.
template <class Method>
class Bounded final : public Method {
 public:
  explicit Bounded(const FourPointOptions& options) : options_(options) {
    this->setApproxOverlap(static_cast<float>(options.overlap));
    this->setDelta(static_cast<float>(options.accuracy_mm), false);
    this->setNumberOfSamples(options.samples);
    this->setMaxNormalDifference(static_cast<float>(options.max_normal_angle_deg));
    this->setMaximumIterations(options.bases);
    this->setScoreThreshold(0.02f);  // on to the last base, unless nearly all points meet
  }
  float score() const { return this->fitness_score_; }

 protected:
  void handleMatches(const pcl::Indices& base, std::vector<pcl::Indices>& matches,
                     pcl::registration::MatchingCandidates& candidates) override {
    Call::current->goOn();
    const auto most = static_cast<std::size_t>(options_.max_matches);
    if (matches.size() > most) {
      for (std::size_t i = 0; i < most; ++i) matches[i] = matches[i * matches.size() / most];
      matches.resize(most);
    }
    Method::handleMatches(base, matches, candidates);
  }
  int validateMatch(const pcl::Indices& base, const pcl::Indices& match,
                    const pcl::Correspondences& correspondences, Eigen::Matrix4f& pose) override {
    Call::current->goOn();
    return Method::validateMatch(base, match, correspondences, pose);
  }

 private:
  FourPointOptions options_;
};

template <class Method>
void congruentSets(Bounded<Method>& method, const Cloud::Ptr& front, const Cloud::Ptr& back) {
  method.setInputSource(back);
  method.setInputTarget(front);
  method.setSourceNormals(back);
  method.setTargetNormals(front);
  Cloud aligned;
  method.align(aligned);
}

Features::Ptr featuresOf(const Cloud::Ptr& cloud, double radius_mm) {
  pcl::FPFHEstimation<Point, Point, pcl::FPFHSignature33> fpfh;
  fpfh.setInputCloud(cloud);
  fpfh.setInputNormals(cloud);
  fpfh.setSearchMethod(pcl::search::KdTree<Point>::Ptr(new pcl::search::KdTree<Point>));
  fpfh.setRadiusSearch(radius_mm);
  Features::Ptr found(new Features);
  fpfh.compute(*found);
  for (pcl::FPFHSignature33& feature : *found)
    for (float& bin : feature.histogram)
      if (!std::isfinite(bin)) bin = 0;
  return found;
}

Cloud::Ptr cornersOf(const Cloud::Ptr& cloud, double radius_mm) {
  pcl::HarrisKeypoint3D<Point, pcl::PointXYZI, Point> harris;
  harris.setInputCloud(cloud);
  harris.setNormals(cloud);
  harris.setRadius(static_cast<float>(radius_mm));
  harris.setNonMaxSupression(true);
  harris.setRefine(false);
  pcl::PointCloud<pcl::PointXYZI> corners;
  harris.compute(corners);
  return Cloud::Ptr(new Cloud(*cloud, harris.getKeypointsIndices()->indices));
}

}  // namespace
}  // namespace ostraka::baselines

int pcl::rand() {
  ostraka::baselines::Call& call = *ostraka::baselines::Call::current;
  call.goOn();
  return static_cast<int>(call.engine() >> 1);  // 0 to RAND_MAX
}

namespace ostraka::baselines {

Result<void> enoughPoints(const PointCloud& front, const PointCloud& back) {
  for (const PointCloud* side : {&front, &back}) {
    if (side->size() < kFewestPoints)
      return Error::notEnough(
          message("Too few fracture points for the chosen registration method; use the default "
                  "method."));
    if (!side->hasNormals())
      return Error::notEnough(message("The scan has no normals; export it with normals."));
  }
  return {};
}

Error notConverged() {
  return Error::failed(message(
      "The chosen registration method did not converge; use the default method, or align the "
      "back by hand."));
}

Result<Isometry3d> trimmedIcp(const PointCloud& front, const PointCloud& back,
                              const Isometry3d& start, const IcpOptions& options,
                              std::stop_token stop) {
  const Sides sides(front, back, options.spacing_mm);
  if (const auto ok = sides.check(); !ok) return ok.error();
  return called(stop, [&] {
    pcl::IterativeClosestPoint<Point, Point, double> icp;
    pcl::registration::CorrespondenceRejectorTrimmed::Ptr trim(
        new pcl::registration::CorrespondenceRejectorTrimmed);
    trim->setOverlapRatio(static_cast<float>(options.overlap));
    icp.addCorrespondenceRejector(trim);
    icp.setTransformationEpsilon(1e-6);  // mm^2: a thousandth of a millimetre
    icp.setTransformationRotationEpsilon(1 - 5e-10);
    return iterated(icp, sides, start, options);
  });
}

Result<Isometry3d> generalizedIcp(const PointCloud& front, const PointCloud& back,
                                  const Isometry3d& start, const IcpOptions& options,
                                  std::stop_token stop) {
  const Sides sides(front, back, options.spacing_mm);
  if (const auto ok = sides.check(); !ok) return ok.error();
  return called(stop, [&] {
    pcl::GeneralizedIterativeClosestPoint<Point, Point, double> icp;
    icp.setTransformationEpsilon(1e-4);  // mm
    icp.setRotationEpsilon(1e-5);
    return iterated(icp, sides, start, options);
  });
}

std::vector<Feature> pointFeatures(const PointCloud& cloud, double radius_mm) {
  std::vector<Feature> features;
  const Features::Ptr found = featuresOf(toPcl(cloud), radius_mm);
  for (const pcl::FPFHSignature33& f : *found) {
    features.emplace_back();
    std::copy(std::begin(f.histogram), std::end(f.histogram), features.back().begin());
  }
  return features;
}

Result<Isometry3d> featureRansac(const PointCloud& front, const PointCloud& back,
                                 const FeatureRansacOptions& options, std::stop_token stop) {
  const Sides sides(front, back, options.spacing_mm);
  if (const auto ok = sides.check(); !ok) return ok.error();
  return called(stop, [&]() -> Result<Isometry3d> {
    const Cloud::Ptr target = toPcl(sides.front), source = toPcl(sides.back);
    pcl::SampleConsensusPrerejective<Point, Point, pcl::FPFHSignature33> ransac;
    ransac.setInputSource(source);
    ransac.setSourceFeatures(featuresOf(source, options.feature_radius_mm));
    ransac.setInputTarget(target);
    ransac.setTargetFeatures(featuresOf(target, options.feature_radius_mm));
    ransac.setMaximumIterations(options.max_rounds);
    ransac.setNumberOfSamples(3);
    ransac.setCorrespondenceRandomness(options.nearest_features);
    ransac.setSimilarityThreshold(static_cast<float>(options.edge_similarity));
    ransac.setMaxCorrespondenceDistance(options.inlier_mm);
    ransac.setInlierFraction(static_cast<float>(options.inlier_share));
    Cloud aligned;
    ransac.align(aligned);
    if (!ransac.hasConverged()) return notConverged();
    return poseOf(ransac.getFinalTransformation());
  });
}

Result<Isometry3d> fourPointSets(const PointCloud& front, const PointCloud& back,
                                 const FourPointOptions& options, std::stop_token stop) {
  const Sides sides(front, back, options.spacing_mm);
  if (const auto ok = sides.check(); !ok) return ok.error();
  return called(stop, [&]() -> Result<Isometry3d> {
    Bounded<pcl::registration::FPCSInitialAlignment<Point, Point, Point>> method(options);
    congruentSets(method, toPcl(sides.front), toPcl(sides.back));
    // Its score is the share of points that do not meet the front.
    if (method.score() > 1 - options.overlap) return notConverged();
    return poseOf(method.getFinalTransformation());
  });
}

Result<Isometry3d> keypointFourPointSets(const PointCloud& front, const PointCloud& back,
                                         const FourPointOptions& options, std::stop_token stop) {
  const Sides sides(front, back, options.spacing_mm);
  if (const auto ok = sides.check(); !ok) return ok.error();
  return called(stop, [&]() -> Result<Isometry3d> {
    const Cloud::Ptr target = cornersOf(toPcl(sides.front), 4 * options.spacing_mm);
    const Cloud::Ptr source = cornersOf(toPcl(sides.back), 4 * options.spacing_mm);
    if (target->size() < kFewestPoints || source->size() < kFewestPoints) return notConverged();
    Bounded<pcl::registration::KFPCSInitialAlignment<Point, Point, Point>> method(options);
    congruentSets(method, target, source);
    // Its score is a share too, of squared distances cut off at eight times the accuracy.
    if (method.score() > 1 - options.overlap) return notConverged();
    return poseOf(method.getFinalTransformation());
  });
}

}  // namespace ostraka::baselines
