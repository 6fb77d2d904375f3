#include "registration_rivals.h"

#include <pcl/features/fpfh.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_rejection_trimmed.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/ia_fpcs.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/sample_consensus_prerejective.h>
#include <pcl/search/kdtree.h>

#include <cmath>

namespace ostraka::bench {
namespace {

using Point = pcl::PointNormal;
using Cloud = pcl::PointCloud<Point>;

Cloud::Ptr toPcl(const PointCloud& cloud, double edge_mm) {
  const PointCloud thin = thinned(cloud, edge_mm);
  Cloud::Ptr points(new Cloud);
  for (std::size_t i = 0; i < thin.size(); ++i) {
    Point p;
    p.getVector3fMap() = thin.points[i];
    p.getNormalVector3fMap() = thin.normals[i];
    p.curvature = 0;
    points->push_back(p);
  }
  return points;
}

template <class Method>
std::optional<Eigen::Isometry3d> result(Method& method, const Eigen::Matrix4f& start) {
  Cloud aligned;
  method.align(aligned, start);
  if (!method.hasConverged()) return std::nullopt;
  Eigen::Isometry3d pose(method.getFinalTransformation().template cast<double>());
  pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  return pose;
}

pcl::PointCloud<pcl::FPFHSignature33>::Ptr features(const Cloud::Ptr& cloud) {
  pcl::FPFHEstimation<Point, Point, pcl::FPFHSignature33> fpfh;
  fpfh.setInputCloud(cloud);
  fpfh.setInputNormals(cloud);
  fpfh.setSearchMethod(pcl::search::KdTree<Point>::Ptr(new pcl::search::KdTree<Point>));
  fpfh.setRadiusSearch(4.0);
  pcl::PointCloud<pcl::FPFHSignature33>::Ptr found(new pcl::PointCloud<pcl::FPFHSignature33>);
  fpfh.compute(*found);
  return found;
}

}  // namespace

std::optional<Eigen::Isometry3d> registerByRival(const std::string& method, const PointCloud& front,
                                                 const PointCloud& back,
                                                 const Eigen::Isometry3d& start) {
  const Eigen::Matrix4f guess = start.matrix().cast<float>();
  const bool is_global = method == "fpfh" || method == "4pcs";
  const Cloud::Ptr target = toPcl(front, is_global ? 1.2 : 0.6);
  const Cloud::Ptr source = toPcl(back, is_global ? 1.2 : 0.6);
  if (method == "trimmed") {
    pcl::IterativeClosestPoint<Point, Point> icp;
    pcl::registration::CorrespondenceRejectorTrimmed::Ptr trim(
        new pcl::registration::CorrespondenceRejectorTrimmed);
    trim->setOverlapRatio(0.5f);
    icp.addCorrespondenceRejector(trim);
    icp.setMaxCorrespondenceDistance(3.0);
    icp.setMaximumIterations(60);
    icp.setInputSource(source);
    icp.setInputTarget(target);
    return result(icp, guess);
  }
  if (method == "gicp") {
    pcl::GeneralizedIterativeClosestPoint<Point, Point> icp;
    icp.setMaxCorrespondenceDistance(1.5);
    icp.setMaximumIterations(40);
    icp.setInputSource(source);
    icp.setInputTarget(target);
    return result(icp, guess);
  }
  if (method == "fpfh") {
    pcl::SampleConsensusPrerejective<Point, Point, pcl::FPFHSignature33> ransac;
    ransac.setInputSource(source);
    ransac.setSourceFeatures(features(source));
    ransac.setInputTarget(target);
    ransac.setTargetFeatures(features(target));
    ransac.setMaximumIterations(20000);
    ransac.setNumberOfSamples(3);
    ransac.setCorrespondenceRandomness(5);
    ransac.setSimilarityThreshold(0.9f);
    ransac.setMaxCorrespondenceDistance(1.5);
    ransac.setInlierFraction(0.15f);
    return result(ransac, Eigen::Matrix4f::Identity());
  }
  if (method == "4pcs") {
    pcl::registration::FPCSInitialAlignment<Point, Point, Point> fpcs;
    fpcs.setInputSource(source);
    fpcs.setInputTarget(target);
    fpcs.setApproxOverlap(0.4f);
    fpcs.setDelta(1.0f, false);
    fpcs.setNumberOfSamples(300);
    fpcs.setMaxComputationTime(5);
    return result(fpcs, Eigen::Matrix4f::Identity());
  }
  return std::nullopt;
}

}  // namespace ostraka::bench
