#include "flat_rig.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <opencv2/aruco.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace ostraka::capture::testing {
namespace {

constexpr int kMarkers = 12;
constexpr double kMarker_mm = 36, kRing_mm = 140, kPixelsPerMm = 2, kHalf_mm = 175;

// Rows downwards are -y.
cv::Point2d onPaper(double x_mm, double y_mm) {
  return {(x_mm + kHalf_mm) * kPixelsPerMm, (kHalf_mm - y_mm) * kPixelsPerMm};
}

void pasteMarker(cv::Mat3b& paper, const batch::Marker& marker,
                 const cv::Ptr<cv::aruco::Dictionary>& dictionary) {
  cv::Mat1b drawn;
  cv::aruco::drawMarker(dictionary, marker.id, 120, drawn, 1);
  cv::Mat1b framed(160, 160, uchar{255});
  drawn.copyTo(framed({20, 20, 120, 120}));
  std::vector<cv::Point2f> from{{19.5f, 19.5f}, {139.5f, 19.5f}, {139.5f, 139.5f}, {19.5f, 139.5f}},
      to;
  for (const Eigen::Vector3d& c : marker.corners) to.push_back(onPaper(c.x(), c.y()));
  const cv::Mat warp = cv::getPerspectiveTransform(from, to);
  cv::Mat1b there, where;
  cv::warpPerspective(framed, there, warp, paper.size());
  cv::warpPerspective(cv::Mat1b(framed.size(), 255), where, warp, paper.size());
  cv::Mat3b coloured;
  cv::cvtColor(there, coloured, cv::COLOR_GRAY2BGR);
  coloured.copyTo(paper, where > 250);
}

cv::Mat3b drawPlate() {
  const int size = static_cast<int>(2 * kHalf_mm * kPixelsPerMm);
  cv::Mat3b paper(size, size, cv::Vec3b(30, 30, 30));
  cv::circle(paper, onPaper(0, 0), static_cast<int>(168 * kPixelsPerMm), {70, 68, 66}, cv::FILLED,
             cv::LINE_AA);
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_100);
  for (const batch::Marker& marker : flatPlate().markers) pasteMarker(paper, marker, dictionary);
  return paper;
}

cv::Mat3b drawPaper(const FlatScene& scene) {
  static const cv::Mat3b plate = drawPlate();
  cv::Mat3b paper = plate.clone();
  for (const FlatSherd& s : scene.sherds)
    cv::circle(paper, onPaper(s.x_mm, s.y_mm), static_cast<int>(s.radius_mm * kPixelsPerMm),
               {60, 110, 180}, cv::FILLED, cv::LINE_AA);
  return paper;
}

// Camera 0 looks down at 45 degrees, each further one 12 degrees more steeply.
cv::Matx33d pixelFromPlate(const FlatScene& scene, int camera, double degrees) {
  const double up = (45 + 12 * camera) * std::numbers::pi / 180;
  const Eigen::Vector3d eye(0, -700 * std::cos(up), 700 * std::sin(up));
  Eigen::Matrix3d camera_from_plate;
  const Eigen::Vector3d z = -eye.normalized(), x = Eigen::Vector3d::UnitX(), y = z.cross(x);
  camera_from_plate << x.transpose(), y.transpose(), z.transpose();
  const double focal = 1.35 * scene.width;
  Eigen::Matrix3d k;
  k << focal, 0, scene.width / 2.0, 0, focal, scene.width * 0.375, 0, 0, 1;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  Eigen::Matrix3d plane;  // x, y on the plate to the camera
  plane.leftCols<2>() = camera_from_plate * turn.leftCols<2>();
  plane.col(2) = camera_from_plate * (Eigen::Vector3d(scene.shift_mm, 0, 0) - eye);
  Eigen::Matrix3d paper;  // of the paper's pixels
  paper << 1 / kPixelsPerMm, 0, -kHalf_mm, 0, -1 / kPixelsPerMm, kHalf_mm, 0, 0, 1;
  const Eigen::Matrix3d h = k * plane * paper;
  return {h(0, 0), h(0, 1), h(0, 2), h(1, 0), h(1, 1), h(1, 2), h(2, 0), h(2, 1), h(2, 2)};
}

}  // namespace

batch::Plate flatPlate() {
  batch::Plate plate;
  plate.dictionary = "DICT_4X4_100";
  plate.diameter_mm = 336;
  for (int id = 0; id < kMarkers; ++id) {
    const double angle = 2 * std::numbers::pi * id / kMarkers;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0),
        right(std::sin(angle), -std::cos(angle), 0);  // seen with its top away from the axis
    const Eigen::Vector3d middle = kRing_mm * out;
    const double h = kMarker_mm / 2;
    plate.markers.push_back({id,
                             {Eigen::Vector3d(middle + h * out - h * right),
                              Eigen::Vector3d(middle + h * out + h * right),
                              Eigen::Vector3d(middle - h * out + h * right),
                              Eigen::Vector3d(middle - h * out - h * right)}});
  }
  return plate;
}

std::string flatPicture(const FlatScene& scene, int camera, double degrees,
                        const std::string& note) {
  cv::Mat picture;
  cv::warpPerspective(drawPaper(scene), picture, pixelFromPlate(scene, camera, degrees),
                      {scene.width, scene.width * 3 / 4}, cv::INTER_AREA, cv::BORDER_CONSTANT,
                      {30, 30, 30});
  cv::GaussianBlur(picture, picture, {0, 0}, std::hypot(0.6, scene.blur_px));
  std::vector<uchar> bytes;
  cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 92});
  std::string jpeg(bytes.begin(), bytes.end());
  // As a comment right after the start of the image.
  const std::size_t length = note.size() + 2;
  const std::string comment = std::string("\xFF\xFE") + static_cast<char>(length >> 8) +
                              static_cast<char>(length & 255) + note;
  return jpeg.insert(2, comment);
}

std::string noteOf(const std::string& jpeg) {
  if (jpeg.size() < 6 || jpeg.substr(2, 2) != "\xFF\xFE") return {};
  const std::size_t length =
      static_cast<unsigned char>(jpeg[4]) * 256u + static_cast<unsigned char>(jpeg[5]);
  return jpeg.substr(6, length - 2);
}

std::string exposureNote(const std::string& side, int camera, double degrees) {
  double turned = degrees - 360 * std::floor(degrees / 360 + 1e-9);
  if (std::abs(turned) < 0.05) turned = 0;  // no minus zero
  char text[64];
  std::snprintf(text, sizeof text, "%s camera %d at %.1f", side.c_str(), camera, turned);
  return text;
}

devices::CameraId FlatCamera::id() const {
  return {"flat", "Flat camera", "FLAT-" + std::to_string(number_), "paper"};
}

Result<devices::CameraSetting> FlatCamera::set(const std::string& name, const std::string& value) {
  if (!plugged_) return Error{ErrorCode::Missing, "The camera is gone.", id().serial};
  if (name != "exposure" || (has_dial && value != exposure_time))
    return Error{ErrorCode::UnusableInput, "No " + value + " for " + name + ".", id().serial};
  exposure_time = value;
  return devices::CameraSetting{name, value, {}, false};
}

Result<std::string> FlatCamera::preview(std::stop_token) {
  return flatPicture(truth_->scene, number_, truth_->stands_at(), "preview");
}

Result<void> FlatCamera::getReady(std::stop_token) {
  if (!plugged_) return Error{ErrorCode::Missing, "The camera is gone.", id().serial};
  buffer_.clear();
  buffer_.swap(late_);  // what is late arrives when nobody expects it any more
  return {};
}

Result<void> FlatCamera::trigger() {
  if (!plugged_) return Error{ErrorCode::Missing, "The camera is gone.", id().serial};
  const Fault fault = !faults.empty() ? faults.front() : chance ? chance() : Fault::None;
  if (!faults.empty() && fault != Fault::Gone) faults.pop_front();
  if (fault == Fault::Unplugged || fault == Fault::Gone) {
    plugged_ = false;
    return Error{ErrorCode::Missing, "The camera is gone.", id().serial};
  }
  if (fault == Fault::Silent) return {};
  const int exposure = ++truth_->exposures;
  FlatScene scene = truth_->scene;
  if (fault == Fault::Blurred) scene.blur_px = 5;
  const double degrees = truth_->stands_at();
  std::string bytes =
      flatPicture(scene, number_, degrees,
                  exposureNote(truth_->side, number_, degrees) + " #" + std::to_string(exposure));
  if (fault == Fault::Truncated) bytes.resize(bytes.size() / 2);
  if (fault == Fault::Stale && !last_.empty()) bytes.swap(last_);
  if (lags && !last_.empty())
    bytes.swap(last_);
  else
    last_ = bytes;
  (fault == Fault::Late ? late_ : buffer_).push_back({"CAPT0000.JPG", std::move(bytes)});
  return {};
}

Result<std::vector<devices::CameraFile>> FlatCamera::fetch(double timeout_s, std::stop_token stop) {
  if (!buffer_.empty()) {
    std::vector<devices::CameraFile> files{buffer_.front()};
    buffer_.erase(buffer_.begin());
    return files;
  }
  if (!truth_->clock->sleep(timeout_s, stop)) return Error::cancelled();
  return Error{ErrorCode::Missing, "No photograph came.", id().serial};
}

Result<void> FlatCamera::reopen(std::stop_token) {
  ++reopened;
  if (!faults.empty() && faults.front() == Fault::Gone)
    return Error{ErrorCode::Missing, "The camera is not plugged in.", id().serial};
  if (!plugged_ && !has_dial) exposure_time = "1/8";
  plugged_ = true;
  return {};
}

Result<void> FlatTurntable::home(std::stop_token) {
  if (!has_switch) return Error{ErrorCode::Missing, "The table has no switch.", name()};
  truth_->degrees = 0;
  count_ = 0;
  return {};
}

Result<void> FlatTurntable::zeroHere(std::stop_token) {
  count_ = 0;
  return {};
}

Result<void> FlatTurntable::moveTo(double degrees, std::stop_token stop) {
  if (stop.stop_requested()) return Error::cancelled();
  if (!count_) return Error{ErrorCode::NotEnough, "The position is not known.", name()};
  const Fault fault = faults.empty() ? Fault::None : faults.front();
  if (!faults.empty()) faults.pop_front();
  const double way = degrees - *count_;
  const Error gone{ErrorCode::Missing, "The table does not answer.", name()};
  if (fault == Fault::UnpluggedBefore) return gone;
  ++turned;
  if (fault == Fault::UnpluggedMidway || fault == Fault::Restarted) {
    truth_->degrees += 0.4 * way;
    if (fault == Fault::Restarted)
      count_.reset();
    else
      *count_ += 0.4 * way;
    return gone;
  }
  truth_->clock->sleep(std::abs(way) / 20, stop);
  truth_->degrees += way - (fault == Fault::Slipped ? 7 : 0);
  count_ = degrees;
  return {};
}

Result<void> FlatTurntable::reopen(std::stop_token) {
  return {};
}

FlatRig makeFlatRig(int cameras) {
  FlatRig rig;
  auto table = std::make_unique<FlatTurntable>(rig.truth);
  rig.table = table.get();
  rig.devices.turntable = std::move(table);
  for (int c = 0; c < cameras; ++c) {
    auto camera = std::make_unique<FlatCamera>(rig.truth, c);
    rig.cameras.push_back(camera.get());
    rig.devices.cameras.push_back(std::move(camera));
  }
  rig.devices.plate = flatPlate();
  rig.devices.clock = rig.truth->clock;
  rig.devices.side_placed = [truth = rig.truth](batch::Side side) {
    truth->side = batch::name(side);
  };
  return rig;
}

}  // namespace ostraka::capture::testing
