#include "colmap/colmap_program.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "base/message.h"
#include "base/parallel.h"
#include "base/text.h"
#include "batch/exif.h"
#include "batch/label_mask.h"
#include "batch/photograph.h"
#include "files/files.h"
#include "images/jpeg_image.h"
#include "images/png_image.h"
#include "rig/support_plane.h"

namespace ostraka::colmap {
namespace fs = std::filesystem;
namespace {

// What cameras wrote about their focal length, which copies no longer say; 0 where none did.
double focalShareOf(const std::vector<batch::Shot>& shots) {
  std::vector<double> shares;
  for (const batch::Shot& shot : shots)
    if (const auto equivalent = batch::readExif(shot.file).focal_length_35mm)
      shares.push_back(*equivalent / 36.0);
  return medianOf(shares);
}

// Each photograph is matched with each other, each feature with each: COLMAP's own 8192 for twenty
// photographs, and of more photographs so many that matching takes no longer.
int featuresFor(std::size_t photographs) {
  const double twenty = 20.0 / static_cast<double>(std::max<std::size_t>(photographs, 20));
  return std::max(2000, static_cast<int>(8192 * twenty));
}

class Session {
 public:
  Session(const fs::path& program, const fs::path& workspace, const ColmapPoseOptions& options,
          Progress& progress, std::stop_token stop)
      : program_(program),
        workspace_(workspace),
        threads_(std::to_string(options.threads > 0 ? options.threads : availableThreads())),
        lenses_(options.lenses),
        megapixels_(options.megapixels),
        progress_(progress),
        stop_(std::move(stop)) {}

  // Links to the photographs or smaller copies, one folder per lens, and masks as COLMAP names
  // them.
  Result<void> prepare(const std::vector<batch::Shot>& shots) {
    Result<FolderLock> held = claimWorkspace(workspace_);
    if (!held) return held.error();
    held_.emplace(std::move(*held));
    if (megapixels_ > 0) focal_share_ = focalShareOf(shots);
    for (std::size_t i = 0; i < shots.size(); ++i) {
      const int lens = lenses_.empty() ? shots[i].camera : lenses_[i];
      const std::string name = "cam" + std::to_string(lens) + "/" + std::to_string(i) +
                               (megapixels_ > 0 ? ".jpg" : shots[i].file.extension().string());
      shot_of_[name] = i;
      const fs::path image = workspace_ / "images" / name;
      if (const Result<void> made = makeFolder(image.parent_path()); !made) return made;
      if (const Result<void> put = putInto(shots[i], image); !put) return put;
      if (shots[i].mask_file.empty()) continue;
      if (const Result<void> done = writeMask(shots[i], name); !done) return done;
    }
    return {};
  }

  Result<void> run() {
    const std::string database = (workspace_ / "database.db").string();
    const std::string images = (workspace_ / "images").string();
    const fs::path sparse = workspace_ / "sparse";
    if (const Result<void> made = makeFolder(sparse); !made) return made;
    std::vector<std::string> extract{
        "feature_extractor", "--database_path", database, "--image_path", images,
        "--ImageReader.single_camera_per_folder", "1",
        // One focal length and one term of distortion: with a free one per axis a lens of unknown
        // focal length runs away (404 beside 1618 px on photographs of 1520).
        "--ImageReader.camera_model", "SIMPLE_RADIAL",
        // Without a display and CUDA COLMAP aborts unless told so.
        "--SiftExtraction.use_gpu", "0", "--SiftExtraction.num_threads", threads_};
    if (megapixels_ > 0) {
      extract.push_back("--SiftExtraction.max_num_features");
      extract.push_back(std::to_string(featuresFor(shot_of_.size())));
    }
    if (focal_share_ > 0) {
      extract.push_back("--ImageReader.default_focal_length_factor");
      extract.push_back(fixed(focal_share_, 4));
    }
    if (with_masks_) {
      extract.push_back("--ImageReader.mask_path");
      extract.push_back((workspace_ / "masks").string());
    }
    if (const Result<void> done = step(0, "features", extract); !done) return done;
    if (const Result<void> done =
            step(1, "matching",
                 {"exhaustive_matcher", "--database_path", database, "--SiftMatching.use_gpu", "0",
                  "--SiftMatching.num_threads", threads_});
        !done)
      return done;
    const Result<void> mapped =
        step(2, "mapping",
             {"mapper", "--database_path", database, "--image_path", images, "--output_path",
              sparse.string(), "--Mapper.num_threads", threads_,
              // Stops of a turntable are 10 to 45 degrees apart, and a first pair judged with a
              // guessed focal length looks flatter than it is: 16 degrees, the default, is too
              // much to ask.
              "--Mapper.init_min_tri_angle", "8"});
    if (!mapped && mapped.error().code == ErrorCode::Failed)
      return Error::notEnough(
          message("COLMAP cannot align these photographs; its output is in this file. Check that "
                  "all show the same sherds with large overlap, or photograph on a marker plate."),
          mapped.error().where);
    return mapped;
  }

  // COLMAP may leave several models, and none with exit status 0: the largest one counts.
  Result<ColmapModel> largestModel() const {
    ColmapModel best;
    std::error_code failed;
    std::vector<fs::path> folders;
    for (fs::directory_iterator it(workspace_ / "sparse", failed), end; !failed && it != end;
         it.increment(failed))
      folders.push_back(it->path());
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
      Result<ColmapModel> model = readColmapModel(folder);
      if (!model) return model.error();
      if (model->images.size() > best.images.size()) best = std::move(*model);
    }
    return best;
  }

  // Index of the shot behind an image's name.
  std::optional<std::size_t> shotOf(const std::string& name) const {
    const auto found = shot_of_.find(name);
    if (found == shot_of_.end()) return std::nullopt;
    return found->second;
  }

 private:
  cv::Mat handed(const cv::Mat& picture) const {
    if (megapixels_ <= 0) return picture;
    const rig::Intrinsics small = rig::reducedTo({picture.cols, picture.rows}, megapixels_);
    return batch::reducedTo(picture, small.width, small.height);
  }

  Result<void> writeMask(const batch::Shot& shot, const std::string& name) {
    const Result<cv::Mat1b> mask = batch::readLabelMask(shot.mask_file);
    if (!mask) {
      progress_.note(NoteLevel::Warning,
                     inOne(mask.error().sentence(),
                           message("The pose of this photograph is estimated without its mask.")));
      return {};
    }
    with_masks_ = true;
    return writeFileAtomically(workspace_ / "masks" / (name + ".png"),
                               images::encodedPng(handed(*mask)));
  }

  Result<void> putInto(const batch::Shot& shot, const fs::path& image) const {
    if (megapixels_ <= 0) {
      std::error_code failed;
      fs::create_symlink(shot.file, image, failed);
      return failed ? Result<void>(cannotWrite(image, failed.value())) : Result<void>();
    }
    const Result<cv::Mat> photograph = batch::readPhotograph(shot.file);
    if (!photograph) return photograph.error();
    return writeFileAtomically(image, images::encodedJpeg(handed(*photograph)));
  }

  Result<void> step(int done, const std::string& word, const std::vector<std::string>& arguments) {
    progress_.report(done, 3);
    progress_.note(NoteLevel::Info, "rig: COLMAP " + word);
    return runProgram(program_, arguments, workspace_ / "log.txt", stop_);
  }

  fs::path program_, workspace_;
  std::optional<FolderLock> held_;
  std::string threads_;
  const std::vector<int>& lenses_;
  double megapixels_;
  Progress& progress_;
  std::stop_token stop_;
  std::map<std::string, std::size_t> shot_of_;
  double focal_share_ = 0;  ///< focal length per longer side; 0: unknown
  bool with_masks_ = false;
};

double low(std::vector<double> values) {
  if (values.empty()) return 0;
  const std::size_t k = values.size() / 50;  // a few wild points lie below the plate
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[k];
}

// Turntable frame from camera centres that circle about an axis: centres[k] belong to one camera.
// Nothing when they do not (fewer than three centres of every camera, or all in one place).
std::optional<Eigen::Isometry3d> turntableFromCentres(
    const std::vector<std::vector<Eigen::Vector3d>>& centres,
    const std::vector<Eigen::Vector3d>& points) {
  // Differences within a camera's circle are at right angles to the axis.
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& circle : centres) {
    if (circle.size() < 3) continue;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& c : circle) mean += c / static_cast<double>(circle.size());
    for (const Eigen::Vector3d& c : circle) spread += (c - mean) * (c - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  if (!(solver.eigenvalues()[1] > 1e-6 * std::max(1e-12, spread.trace()))) return std::nullopt;
  const Eigen::Vector3d axis = solver.eigenvectors().col(0);
  // Circles about one point of the plane: |c|^2 = 2 c.m + k, with one k per camera.
  const Eigen::Vector3d u = solver.eigenvectors().col(1), v = solver.eigenvectors().col(2);
  Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  double cameras_height = 0, count = 0;
  for (const auto& circle : centres) {
    if (circle.size() < 3) continue;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    double mean_square = 0;
    const double n = static_cast<double>(circle.size());
    for (const Eigen::Vector3d& c : circle) {
      const Eigen::Vector2d p(u.dot(c), v.dot(c));
      mean += p / n;
      mean_square += p.squaredNorm() / n;
    }
    for (const Eigen::Vector3d& c : circle) {
      const Eigen::Vector2d p(u.dot(c), v.dot(c)), d = p - mean;
      a += 2 * d * d.transpose();
      b += d * (p.squaredNorm() - mean_square);
      cameras_height += axis.dot(c);
      ++count;
    }
  }
  const Eigen::Vector2d m = a.ldlt().solve(b);
  std::vector<double> heights;
  for (const Eigen::Vector3d& p : points) heights.push_back(axis.dot(p));
  const double middle = medianOf(std::vector(heights));
  const double up = cameras_height / count >= middle ? 1 : -1;
  for (double& h : heights) h *= up;
  const Eigen::Vector3d z = up * axis;
  const Eigen::Vector3d origin = m.x() * u + m.y() * v + low(heights) * z;
  Eigen::Isometry3d world_from_table = Eigen::Isometry3d::Identity();
  world_from_table.linear() << u, z.cross(u), z;
  world_from_table.translation() = origin;
  return world_from_table.inverse();
}

Eigen::Isometry3d turntableOrIdentity(const ColmapPoses& poses) {
  std::map<int, std::vector<Eigen::Vector3d>> by_camera;
  for (const rig::PosedImage& image : poses.images)
    by_camera[image.camera].push_back(image.centre());
  std::vector<std::vector<Eigen::Vector3d>> centres;
  for (auto& [camera, list] : by_camera) centres.push_back(std::move(list));
  return turntableFromCentres(centres, poses.points).value_or(Eigen::Isometry3d::Identity());
}

}  // namespace

void moveTo(ColmapPoses& poses, const Eigen::Isometry3d& frame_from_world) {
  for (rig::PosedImage& image : poses.images)
    image.camera_from_plate = image.camera_from_plate * frame_from_world.inverse();
  for (Eigen::Vector3d& point : poses.points) point = frame_from_world * point;
}

ColmapPoses scaledTo(ColmapPoses poses, double mm_per_unit) {
  for (rig::PosedImage& image : poses.images) image.camera_from_plate.translation() *= mm_per_unit;
  for (Eigen::Vector3d& point : poses.points) point *= mm_per_unit;
  poses.has_scale = true;
  return poses;
}

Result<ColmapPoses> poseWithColmap(const std::vector<batch::Shot>& shots, const fs::path& workspace,
                                   const ColmapPoseOptions& options, Progress& progress,
                                   std::stop_token stop) {
  const std::optional<fs::path> program =
      options.program.empty() ? findProgram("colmap") : std::optional(options.program);
  if (!program)
    return Error::missing(
        message("Without plate.json, poses come from COLMAP, which is not installed; install the "
                "package 'colmap' or photograph on a marker plate."));
  Session session(*program, fs::absolute(workspace), options, progress, stop);
  if (const Result<void> done = session.prepare(shots); !done) return done.error();
  if (const Result<void> done = session.run(); !done) return done.error();
  const Result<ColmapModel> model = session.largestModel();
  if (!model) return model.error();
  const Result<std::vector<rig::PosedImage>> images = fromColmap(*model);
  if (!images) return images.error();
  std::map<std::size_t, rig::PosedImage> by_shot;
  for (const rig::PosedImage& image : *images)
    if (const auto shot = session.shotOf(image.file)) by_shot[*shot] = image;
  ColmapPoses poses;
  for (auto& [index, image] : by_shot) {
    image.file = shots[index].file.string();
    image.side = shots[index].side;
    image.camera = shots[index].camera;
    image.stop = shots[index].stop;
    if (options.megapixels > 0)
      image.intrinsics = rig::reduced(image.intrinsics, shots[index].width, shots[index].height);
    poses.images.push_back(image);
  }
  const auto needed = std::max(3.0, std::ceil(options.min_posed_share * shots.size()));
  if (static_cast<double>(poses.images.size()) < needed)
    return Error::notEnough(
        message("COLMAP found poses for %1 of %2 photographs, too few; provide masks or "
                "photograph on a marker plate.",
                poses.images.size(), shots.size()),
        workspace.string());
  for (const ColmapPoint& point : model->points) {
    poses.points.push_back(point.position);
    poses.reprojection_px += point.error_px / static_cast<double>(model->points.size());
  }
  moveTo(poses,
         options.lenses.empty() ? turntableOrIdentity(poses) : rig::uprightFrame(poses.images));
  progress.report(3, 3);
  progress.note(NoteLevel::Info, "rig: COLMAP posed " + std::to_string(poses.images.size()) +
                                     " of " + std::to_string(shots.size()) + " photographs");
  return poses;
}

}  // namespace ostraka::colmap
