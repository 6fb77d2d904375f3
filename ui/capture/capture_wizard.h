#pragma once
#include <QImage>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "capture/sequence.h"
#include "records/records.h"
#include "ui/capture/batch_in_hand.h"
#include "ui/capture/capture_facts.h"
#include "ui/capture/place_text.h"
#include "ui/capture/rig_source.h"
#include "ui/jobs/job.h"
#include "ui/jobs/question.h"

namespace ostraka::ui {

class ProjectSession;

/// Place - Shoot - Flip - Shoot - Done, as a person goes through it; no widget. What was done
/// stands in the catalogue (the batch's state) and in the batch's folder, so that a capture that
/// was interrupted goes on where it was.
class CaptureWizard final : public QObject {
  Q_OBJECT

 public:
  explicit CaptureWizard(QObject* parent = nullptr);
  ~CaptureWizard() override;

  void setSession(ProjectSession* session);  ///< null closes
  /// It waits for a side's end. What does not open leaves its place to the one that worked before.
  void setRig(RigSource source);
  void clearRig();
  bool canKeepRig() const { return before_.has_value(); }
  void setLive(bool on);  ///< live pictures are taken only while somebody looks

  CapturePhase phase() const { return phase_; }
  bool isBusy() const { return work_ != nullptr || after_live_ != nullptr; }
  bool isShooting() const;  ///< a side is being photographed: its devices stay until its end
  bool canGoOn() const;
  QString headline() const;     ///< readable from three metres
  QString instruction() const;  ///< one or two sentences
  QString buttonText() const;   ///< of the one big button
  std::vector<CaptureFact> facts() const;
  /// What went wrong; it takes the place of the button. Space tries again.
  const std::optional<Error>& fault() const { return fault_; }
  const QStringList& holders() const { return holders_; }  ///< of a camera; Space releases it
  const QString& question() const { return question_.sentence(); }  ///< at the rig; Space: done
  /// What a person should look at before going on; Space goes on all the same, R takes again.
  const QStringList& doubts() const { return doubts_; }

  const std::optional<PlatePicture>& live() const { return live_; }
  const std::optional<PlatePicture>& frontPicture() const { return front_picture_; }
  int camera() const { return camera_; }
  int cameras() const;
  int stops() const { return source_.stops; }
  int currentStop() const { return stop_; }  ///< -1: none
  int stopsDone() const { return stops_done_; }
  const std::vector<TakenShot>& shots() const { return shots_; }
  QString batchNumber() const { return batch_.number(); }
  const PlaceText& place() const { return place_; }
  int counted() const { return batch_.counted(); }  ///< by the person onto the plate, 0: not
  bool canDescribe() const;  ///< its bag and its count: until the batch is in the queue
  bool canSetAside() const;  ///< a batch has begun, is in no queue, and nothing is being shot
  QStringList numbersOfAnotherBag() const { return batch_.numbersOfAnotherBag(); }
  QString rigWords() const { return source_.words; }
  /// R once more puts aside a whole side with which nothing is wrong.
  bool asksToRepeat() const { return doubts_ == QStringList(repeatQuestion()); }

 public slots:
  void setPlace(const ostraka::ui::PlaceText& place);
  void setCounted(int sherds);
  void next();           ///< Space
  void keepRig();        ///< the one that worked, after clearRig
  void stop();           ///< Esc: the table stands still at once
  void again();          ///< R: the photographs with problems
  void keepDescribed();  ///< the bag was mended: the batch in hand has it at once
  void takeNumbersAsRight();
  void setAside();  ///< nobody wants the batch in hand: another begins, its photographs stay
  void setCamera(int camera);

 signals:
  void changed();      ///< phase, texts, fault, doubts
  void liveChanged();  ///< the live or the front picture
  void shotsChanged();
  void batchQueued(const QString& number);
  void batchSetAside(const QString& number);
  void placeRead();  ///< place() was read from a bag's label under the camera, or of a batch
  void said(const QString& sentence);
  void rigTried(const std::optional<ostraka::Error>& why_not);  ///< null: it is open

 private:
  static QString repeatQuestion();
  void changeRig(RigSource source);
  bool takeWaitingRig();
  bool devicesAreForThis() const;
  void openRig();
  void takeDevices(const Result<std::shared_ptr<capture::RigDevices>>& opened);
  void whenCameraIsFree(std::function<void()> act);
  void enter(CapturePhase phase);
  void forgetPlate();
  void keep(const PlaceText& place);
  void shoot(batch::Side side, std::vector<capture::ShotName> retake);
  void startShooting(batch::Side side, std::vector<capture::ShotName> retake);
  void hear(const capture::CaptureEvent& event);
  void finishSide(batch::Side side, const Result<capture::SideSummary>& summary);
  QString countDoubt(const capture::SideCheck& check) const;
  void doubtCount(const capture::SideCheck& check);
  void goOnWithin(batch::Side side);
  void takePlace();
  void setState(records::BatchState state);
  void queueBatch();
  void lookLive();
  void lookAtFront();
  void takeFrontCount(const capture::SideCheck& check);
  void readLabels(const QStringList& codes);
  void fail(const Error& error, const QString& safe);
  QString safeWords() const;
  void askWhoHolds();
  void releaseCameras();
  JobHandle* start(Job job);

  QPointer<ProjectSession> session_;
  RigSource source_;
  std::optional<RigSource> waiting_, before_;  ///< until the present work ended; that worked
  std::shared_ptr<capture::RigDevices> devices_;
  int opened_for_ = 0;  ///< the index of the batch that devices_ were opened for
  std::vector<capture::ShotName> retaking_;  ///< asked for again and not kept yet
  CapturePhase phase_ = CapturePhase::NoRig;
  QPointer<JobHandle> work_, live_job_, front_job_;
  QTimer live_timer_;
  Question question_;
  bool live_on_ = false, live_missing_ = false, queued_ = false;
  std::function<void()> after_live_;  ///< waits until the camera is free
  std::optional<Error> fault_;
  QStringList doubts_, holders_, wanted_again_;
  std::optional<PlatePicture> live_, front_picture_;
  std::optional<capture::SideSummary> summary_[2];
  std::vector<TakenShot> shots_;
  int camera_ = -1, stop_ = -1, stops_done_ = 0, looks_without_label_ = 0;
  PreparedPhotographs prepared_;
  PlaceText place_;
  QStringList labels_;  ///< of bags, seen last; while they lie there they say nothing new
  BatchInHand batch_;
};

}  // namespace ostraka::ui
