// What the wizard's cameras see while sherds are laid and turned.
#include <utility>

#include "base/files.h"
#include "batch/batch.h"
#include "capture/label_code.h"
#include "catalogue/project.h"
#include "ui/capture/capture_wizard.h"
#include "ui/frame/project_session.h"

namespace ostraka::ui {
namespace {

constexpr int kBetweenLooks_ms = 150;  // a live picture is looked at again after as short a rest
constexpr std::uintmax_t kLargestPhotograph_bytes = std::uintmax_t{200} << 20;
const QSize kFrontPicture(1800, 1400);  // as large as it is ever shown

enum class LookFor {
  Sherds,
  RoomAndLabels,  ///< and where more may lie, and a bag's label: while they are being placed
};

// The picture and what the plate shows, outlines in the pixels of the picture that is shown.
Result<PlatePicture> lookAt(const std::string& bytes, const batch::Plate& plate, LookFor look_for) {
  PlatePicture seen;
  if (!seen.image.loadFromData(reinterpret_cast<const uchar*>(bytes.data()),
                               static_cast<int>(bytes.size())))
    return Error{ErrorCode::UnusableInput, "The camera's picture cannot be read.", {}};
  if (look_for == LookFor::Sherds) {
    Result<capture::PlateLook> look = capture::lookAtPlate(bytes, plate, {});
    if (!look) return look.error();
    seen.look = std::move(*look);
  } else {
    Result<capture::LookWithRoom> look = capture::lookForRoom(bytes, plate, {}, {});
    if (!look) return look.error();
    seen.look = std::move(look->look);
    seen.room = std::move(look->room);
    if (const auto codes = capture::codesIn(bytes))
      for (const std::string& code : *codes) seen.codes << QString::fromStdString(code);
  }
  if (seen.look.width > kFrontPicture.width() || seen.look.height > kFrontPicture.height())
    seen.image = seen.image.scaled(kFrontPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  return seen;
}

}  // namespace

// A camera does one thing at a time: the live picture ends first.
void CaptureWizard::whenCameraIsFree(std::function<void()> act) {
  live_timer_.stop();
  if (live_job_ == nullptr) return act();
  live_job_->cancel();
  after_live_ = std::move(act);
  emit changed();
}

void CaptureWizard::lookLive() {
  const bool useful = phase_ == CapturePhase::Place || phase_ == CapturePhase::Flip;
  if (!live_on_ || !useful || devices_ == nullptr || session_ == nullptr || isBusy() ||
      live_missing_ || live_job_ != nullptr)
    return;
  live_job_ = start(
      makeJob(tr("Live picture"),
              [devices = devices_, camera = camera_,
               look_for = phase_ == CapturePhase::Place ? LookFor::RoomAndLabels : LookFor::Sherds](
                  Progress&, std::stop_token stop) -> Result<PlatePicture> {
                const Result<std::string> picture =
                    devices->cameras[static_cast<std::size_t>(camera)]->preview(stop);
                if (!picture) return picture.error();
                return lookAt(*picture, devices->plate, look_for);
              }));
  connect(live_job_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
    live_job_ = nullptr;
    if (after_live_) return std::exchange(after_live_, nullptr)();
    if (Result<PlatePicture> picture = outcomeAs<PlatePicture>(outcome)) {
      live_ = std::move(*picture);
      readLabels(live_->codes);
    } else if (picture.error().code != ErrorCode::Cancelled) {
      // No live picture is no fault: the photographs will tell.
      live_missing_ = picture.error().code == ErrorCode::Missing;
      live_.reset();
    }
    emit liveChanged();
    if (live_on_) live_timer_.start(kBetweenLooks_ms);
  });
}

// What was typed stays until another bag's label comes into sight.
void CaptureWizard::readLabels(const QStringList& codes) {
  if (phase_ != CapturePhase::Place) return;
  for (const QString& code : codes) {
    if (!code.startsWith(QLatin1String("OST1:")) || code == label_) continue;
    const auto place = findPlaceText(session_->project().catalogue(), code);
    if (!place) continue;
    label_ = code;
    setPlace(*place);
    emit placeRead();
    emit said(tr("Read from the label: %1").arg(place->words()));
    return;
  }
}

void CaptureWizard::lookAtFront() {
  if (devices_ == nullptr) return;
  const std::filesystem::path side = batch_.folder() / batch::name(batch::Side::Front);
  std::filesystem::path file;
  for (const char* ending : {".jpg", ".png", ".tif"})
    if (std::filesystem::path found =
            side / ("cam" + std::to_string(cameras() - 1) + "_pos00" + ending);
        std::filesystem::exists(found))
      file = found;
  if (file.empty()) return;
  if (front_job_ != nullptr) front_job_->drop();
  front_job_ = start(
      makeJob(tr("Front picture"),
              [file, plate = devices_->plate](Progress&, std::stop_token) -> Result<PlatePicture> {
                const Result<std::string> bytes = readFile(file, kLargestPhotograph_bytes);
                if (!bytes) return bytes.error();
                return lookAt(*bytes, plate, LookFor::Sherds);
              }));
  connect(front_job_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
    if (Result<PlatePicture> picture = outcomeAs<PlatePicture>(outcome))
      front_picture_ = std::move(*picture);
    emit liveChanged();
  });
}

}  // namespace ostraka::ui
