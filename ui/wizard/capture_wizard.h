#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "capture/sequence.h"
#include "records/records.h"
#include "ui/wizard/batch_in_hand.h"
#include "ui/wizard/capture_facts.h"

namespace ostraka::ui {

class BatchDescription;
class PlatePictures;
class ProjectSession;
class RigConnection;
class SideProgress;

/// Place - Shoot - Flip - Shoot - Done, as a person goes through it; no widget. What was done
/// stands in the catalogue (the batch's state) and in the batch's folder, so that a capture that
/// was interrupted goes on where it was.
class CaptureWizard final : public QObject {
  Q_OBJECT

 public:
  explicit CaptureWizard(QObject* parent = nullptr);
  ~CaptureWizard() override;

  void setSession(ProjectSession* session);  ///< null closes

  RigConnection* rig() const { return rig_; }
  PlatePictures* pictures() const { return pictures_; }
  SideProgress* side() const { return side_; }
  BatchDescription* description() const { return description_; }
  const BatchInHand& batch() const { return batch_; }

  CapturePhase phase() const { return phase_; }
  bool isShooting() const;  ///< a side is being photographed: its devices stay until its end
  bool canGoOn() const;
  bool canDescribe() const;  ///< its bag and its count: until the batch is in the queue
  bool canSetAside() const;  ///< a batch has begun, is in no queue, and nothing is being shot
  bool isQueued() const { return queued_; }
  /// What went wrong; it takes the place of the button. Space tries again.
  const std::optional<Error>& fault() const { return fault_; }
  /// What a person should look at before going on; Space goes on all the same, R takes again.
  QStringList doubts() const;
  /// R once more puts aside a whole side with which nothing is wrong; the next step keeps it.
  bool asksToRepeat() const { return doubts_.repeat; }
  /// Of a side that is whole; of the fronts also when only their sherds were counted.
  const std::optional<capture::SideSummary>& summary(batch::Side side) const;
  const QStringList& sherdsToReshoot() const { return to_reshoot_; }  ///< of earlier plates

 public slots:
  void next();             ///< Space
  void stop();             ///< Esc: the table stands still at once
  void again();            ///< R: the photographs with problems
  void keepPhotographs();  ///< of asksToRepeat()
  void keepDescribed();    ///< the bag was mended: the batch in hand has it at once
  void setAside();         ///< nobody wants the batch in hand: another begins, its photographs stay

 signals:
  void changed();  ///< phase, texts, fault, doubts
  void batchQueued(const QString& number);
  void batchSetAside(const QString& number);
  void said(const QString& sentence);

 private:
  void followRig();
  void openRig();
  void resumeBatch();
  void followBatch(const QString& number);
  void setPhase(CapturePhase phase);  ///< in which nothing has failed yet
  void enter(CapturePhase phase);
  void forgetPlate();
  void keep(const PlaceText& place);
  void shoot(batch::Side side, std::vector<capture::ShotName> retake);
  void startShooting(batch::Side side);
  void finishSide(batch::Side side, const Result<capture::SideSummary>& summary);
  std::vector<std::vector<std::filesystem::path>> uncountedFronts() const;
  void followCount();
  void doubtCount(const capture::SideCheck& check);
  void goOnWithin(batch::Side side);
  void setState(records::BatchState state);
  void queueBatch();
  void takeFrontCount(const capture::SideCheck& check);
  void fail(const Error& error, const QString& safe);
  QString safeWords() const;

  QPointer<ProjectSession> session_;
  BatchInHand batch_;
  RigConnection* rig_;
  PlatePictures* pictures_;
  SideProgress* side_;
  BatchDescription* description_;
  CapturePhase phase_ = CapturePhase::NoRig;
  bool queued_ = false;
  std::optional<Error> fault_;
  struct Doubts {
    QStringList found;    ///< in photographs, on the plate, between its sides
    QString count;        ///< of the sherds that were counted; empty: none
    bool repeat = false;  ///< nothing is wrong, and R asks to photograph it all again
  };
  Doubts doubts_;
  QStringList to_reshoot_;
  std::array<std::optional<capture::SideSummary>, 2> summary_;  ///< front, back
};

}  // namespace ostraka::ui
