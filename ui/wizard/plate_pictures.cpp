#include "ui/wizard/plate_pictures.h"

#include <algorithm>
#include <utility>

#include "base/limits.h"
#include "batch/batch.h"
#include "capture/label_code.h"
#include "files/files.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/wizard/batch_in_hand.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/rig_connection.h"

namespace ostraka::ui {
namespace {

constexpr int kBetweenLooks_ms = 150;  // a live picture is looked at again after as short a rest
constexpr std::uintmax_t kLargestPhotograph_bytes = limits::kImageBytes.most;
const QSize kFrontPicture(1800, 1400);  // as large as it is ever shown

enum class LookFor {
  Sherds,
  SherdsAndLabels,  ///< and a bag's label: while they are turned over
  RoomAndLabels,    ///< and where more may lie, and a bag's label: while they are being placed
};

// The picture and what the plate shows, outlines in the pixels of the picture that is shown.
Result<PlatePicture> lookAt(const std::string& bytes, const batch::Plate& plate, LookFor look_for) {
  PlatePicture seen;
  if (!seen.image.loadFromData(reinterpret_cast<const uchar*>(bytes.data()),
                               static_cast<int>(bytes.size())))
    return Error{ErrorCode::UnusableInput, "The camera's picture cannot be read.", {}};
  if (look_for != LookFor::RoomAndLabels) {
    Result<capture::PlateInspection> inspection = capture::inspectPlate(bytes, plate, {});
    if (!inspection) return inspection.error();
    seen.inspection = std::move(*inspection);
  } else {
    Result<capture::InspectionWithClearance> inspection = capture::lookForRoom(bytes, plate, {});
    if (!inspection) return inspection.error();
    seen.inspection = std::move(inspection->inspection);
    seen.room = std::move(inspection->room);
  }
  if (look_for != LookFor::Sherds)
    if (const auto codes = capture::codesIn(bytes))
      for (const std::string& code : *codes) seen.codes << QString::fromStdString(code);
  if (seen.inspection.width > kFrontPicture.width() ||
      seen.inspection.height > kFrontPicture.height())
    seen.image = seen.image.scaled(kFrontPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  return seen;
}

struct FrontLook {
  std::optional<PlatePicture> picture;
  std::optional<capture::SideCheck> check;
};

}  // namespace

PlatePictures::PlatePictures(RigConnection* rig, const BatchInHand* batch, QObject* parent)
    : QObject(parent), rig_(rig), batch_(batch) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &PlatePictures::takeLive);
  connect(rig_, &RigConnection::begun, &timer_, &QTimer::stop);
  connect(rig_, &RigConnection::opened, this, [this] {
    const int last = rig_->cameras() - 1;
    camera_ = std::clamp(camera_ < 0 ? last : camera_, 0, last);
  });
}

void PlatePictures::setSession(ProjectSession* session) {
  dropJob(front_job_);
  session_ = session;
}

void PlatePictures::setLive(bool on) {
  live_on_ = on;
  if (!on) return timer_.stop();
  emit liveTurnedOn();
  takeLive();
}

void PlatePictures::setCamera(int camera) {
  if (camera < 0 || camera >= rig_->cameras() || camera == camera_) return;
  camera_ = camera;
  live_missing_ = false;
  emit cameraChanged();
  takeLive();
}

void PlatePictures::forget() {
  live_.reset();
  front_.reset();
  emit changed();
}

void PlatePictures::preview() {
  live_missing_ = false;
  takeLive();
}

void PlatePictures::takeLive() {
  if (!live_on_ || !isUseful() || live_missing_ || rig_->devices() == nullptr) return;
  const LookFor look_for =
      phase_ == CapturePhase::Place ? LookFor::RoomAndLabels : LookFor::SherdsAndLabels;
  rig_->preview(makeJob([devices = rig_->devices(), camera = camera_, look_for](
                            Progress&, std::stop_token stop) -> Result<PlatePicture> {
                  const Result<std::string> picture =
                      devices->cameras[static_cast<std::size_t>(camera)]->preview(stop);
                  if (!picture) return picture.error();
                  return lookAt(*picture, devices->plate, look_for);
                }),
                [this](const JobOutcome& outcome) { showLive(outcome); });
}

void PlatePictures::showLive(const JobOutcome& outcome) {
  if (Result<PlatePicture> picture = outcomeAs<PlatePicture>(outcome)) {
    live_ = std::move(*picture);
    if (isUseful()) emit codesSeen(live_->codes);
  } else if (picture.error().code != ErrorCode::Cancelled) {
    // No live picture is no fault: the photographs will tell.
    live_missing_ = picture.error().code == ErrorCode::Missing;
    live_.reset();
  }
  emit changed();
  if (live_on_) timer_.start(kBetweenLooks_ms);
}

void PlatePictures::readFront(std::vector<std::vector<std::filesystem::path>> uncounted) {
  if (rig_->devices() == nullptr) return;
  const std::filesystem::path side = batch_->folder() / batch::name(batch::Side::Front);
  std::filesystem::path file;
  for (const char* ending : {".jpg", ".png", ".tif"})
    if (std::filesystem::path found =
            side / ("cam" + std::to_string(rig_->cameras() - 1) + "_pos00" + ending);
        std::filesystem::exists(found))
      file = found;
  if (file.empty()) return;
  dropJob(front_job_);
  front_job_ = session_->jobs().start(
      makeJob([file, uncounted = std::move(uncounted), plate = rig_->devices()->plate,
               check = rig_->source().check](Progress&, std::stop_token stop) -> Result<FrontLook> {
        FrontLook inspection;
        const Result<std::string> bytes = readFile(file, kLargestPhotograph_bytes);
        if (bytes)
          if (Result<PlatePicture> seen = lookAt(*bytes, plate, LookFor::Sherds))
            inspection.picture = std::move(*seen);
        if (!uncounted.empty()) inspection.check = check(uncounted, plate, {}, stop);
        return inspection;
      }),
      this);
  whenDone<FrontLook>(front_job_, this,
                      [this, number = batch_->number()](Result<FrontLook> inspection) {
                        if (!inspection || number != batch_->number()) return;
                        if (inspection->picture) front_ = std::move(inspection->picture);
                        if (inspection->check) emit frontCounted(*inspection->check);
                        emit changed();
                      });
}

}  // namespace ostraka::ui
