// What the wizard's cameras see while sherds are laid and turned.
#include <map>
#include <utility>

#include "base/limits.h"
#include "batch/batch.h"
#include "capture/label_code.h"
#include "files/files.h"
#include "ui/capture/capture_wizard.h"
#include "ui/capture/doubt_words.h"
#include "ui/frame/project_session.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kBetweenLooks_ms = 150;  // a live picture is looked at again after as short a rest
constexpr int kLooksUntilGone = 5;     // a hand may hide a label for a moment
constexpr std::uintmax_t kLargestPhotograph_bytes = limits::kImageBytes.most;
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
    Result<capture::PlateInspection> inspection = capture::inspectPlate(bytes, plate, {});
    if (!inspection) return inspection.error();
    seen.inspection = std::move(*inspection);
  } else {
    Result<capture::InspectionWithClearance> inspection =
        capture::lookForRoom(bytes, plate, {}, {});
    if (!inspection) return inspection.error();
    seen.inspection = std::move(inspection->inspection);
    seen.room = std::move(inspection->room);
    if (const auto codes = capture::codesIn(bytes))
      for (const std::string& code : *codes) seen.codes << QString::fromStdString(code);
  }
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

// What was typed stays until another bag's label comes into sight, or this one once more. Of two
// bags nobody knows whose sherds lie there.
void CaptureWizard::readLabels(const QStringList& codes) {
  if (phase_ != CapturePhase::Place) return;
  std::map<QString, PlaceText> bags;
  for (const QString& code : codes)
    if (code.startsWith(QLatin1String("OST1:")))
      if (const auto place = findPlaceText(session_->project().catalogue(), code))
        bags.emplace(place->words(), *place);
  QStringList seen;
  for (const auto& [words, place] : bags) seen << words;
  looks_without_label_ = seen.isEmpty() ? looks_without_label_ + 1 : 0;
  if (looks_without_label_ == kLooksUntilGone) labels_.clear();
  if (seen.isEmpty() || seen == labels_) return;
  labels_ = seen;
  if (bags.size() > 1)
    return emit said(tr("Labels of several bags are in sight: %1. Leave the one of these sherds.")
                         .arg(seen.join(QStringLiteral(", "))));
  setPlace(bags.begin()->second);
  emit placeRead();
  emit said(tr("Read from the label: %1").arg(seen.front()));
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
  // What was counted is not known any more when the program was closed since.
  std::vector<std::vector<std::filesystem::path>> uncounted;
  if (!summary_[0]) uncounted = batch_.files(batch::Side::Front, cameras());
  front_job_ =
      start(makeJob(tr("Front picture"),
                    [file, uncounted, plate = devices_->plate, check = source_.check](
                        Progress&, std::stop_token stop) -> Result<FrontLook> {
                      FrontLook inspection;
                      const Result<std::string> bytes = readFile(file, kLargestPhotograph_bytes);
                      if (bytes)
                        if (Result<PlatePicture> seen = lookAt(*bytes, plate, LookFor::Sherds))
                          inspection.picture = std::move(*seen);
                      if (!uncounted.empty()) inspection.check = check(uncounted, plate, {}, stop);
                      return inspection;
                    }));
  connect(front_job_, &JobHandle::finished, this,
          [this, number = batch_.number()](const JobOutcome& outcome) {
            Result<FrontLook> inspection = outcomeAs<FrontLook>(outcome);
            if (!inspection || number != batch_.number()) return;
            if (inspection->picture) front_picture_ = std::move(inspection->picture);
            if (inspection->check) takeFrontCount(*inspection->check);
            emit liveChanged();
          });
}

void CaptureWizard::takeFrontCount(const capture::SideCheck& check) {
  if (summary_[0]) return;
  summary_[0].emplace().check = check;
  summary_[0]->kept = static_cast<int>(batch_.photographs(batch::Side::Front).size());
  if (phase_ != CapturePhase::Flip) return;
  doubts_ << doubtsOf(check);
  doubtCount(check);
  emit changed();
}

}  // namespace ostraka::ui
