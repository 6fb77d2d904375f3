#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "ui/jobs/job.h"
#include "ui/pairs/card_list_model.h"
#include "ui/pairs/reviewed_batch.h"

class QUndoStack;

namespace ostraka::ui {

/// The card in hand: its candidates, the back and pose that a person tries on it, and what is
/// fetched to show them. Nothing is decided here. Long work goes through the jobs, one of a kind;
/// what is tried through the undo stack.
class CardInHand final : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  CardInHand(JobRunner& runner, QUndoStack& undo, ReviewedBatch& batch, const CardListModel& cards);

  void hold(const Trial& trial);  ///< another card
  void clear();                   ///< none; what is on its way is dropped
  void updateCandidates();

  int front() const { return trial_.front; }
  const review::ReviewCard* card() const { return batch_.review().ofFront(trial_.front); }
  int row() const { return cards_.rowAbout(trial_); }  ///< -1: none
  const Trial& trial() const { return trial_; }
  const std::vector<review::ReviewCandidate>& candidates() const { return candidates_; }
  int chosen() const;  ///< index among the candidates; -1: none of them
  const review::LiveFit& fit() const { return fit_; }  ///< of what was shown last
  bool isTried() const;                                ///< the trial is not what stands
  bool isMeasured() const;                             ///< fit() is of the pose on trial
  bool isSettling() const { return busy_; }
  /// The pair is still loading and is not shown yet, so nobody can judge it; ends in sceneFetched.
  bool isLoading() const { return scene_job_ != nullptr && !isShown(); }
  QString reason() const;       ///< why the card is doubtful, or what is tried on it
  QString figuresText() const;  ///< fracture RMS and overlap of the trial, in words

 public slots:
  void choose(int candidate);  ///< index among candidates()
  void chooseBack(int back);   ///< any back; compared first where the program did not
  void stepStart(int by);      ///< to the next good start point
  void stepSample(int by);     ///< by one of 200 samples
  void moveByHand(const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& move_mm);
  void settle();
  void stopSettling();                              ///< the back stays where it was
  void fetchModel();                                ///< of the pair on trial, as last computed
  void fetchScans() { fetchScene(Clouds::Fetch); }  ///< both sides as they are on trial

 signals:
  void cardChanged();  ///< another card is in hand
  void candidatesChanged();
  void trialChanged();  ///< back or pose
  /// On the way, with the fractures' RMS so far, mm; trialChanged follows.
  void settlingAt(const Eigen::Isometry3d& front_from_back, const std::vector<double>& rms_mm);
  void sceneChanged(const std::shared_ptr<const ostraka::ui::PairScene>& scene);
  void sceneFetched();  ///< and none is on its way
  void busyChanged(bool busy);
  void modelFetched(const std::shared_ptr<const ostraka::TriangleMesh>& model);  ///< null: none
  void failed(const QString& sentence);

 private:
  friend class TryCommand;
  void showTrial(const Trial& trial);
  void tryOut(const Trial& trial, const QString& text, bool merge = false);
  void fitAt(std::function<Result<review::LiveFit>(Progress&, std::stop_token)> work, Made made,
             const QString& text);
  void fetchScene(Clouds clouds);
  bool isAbout(int front, int back) const { return front == trial_.front && back == trial_.back; }
  bool isShown() const { return scene_ && isAbout(scene_->front, scene_->back); }

  JobRunner& runner_;
  QUndoStack& undo_;
  ReviewedBatch& batch_;
  const CardListModel& cards_;
  std::vector<review::ReviewCandidate> candidates_;
  Trial trial_;
  review::LiveFit fit_;
  std::shared_ptr<const PairScene> scene_;  ///< the last one that came
  std::vector<double> settling_rms_;
  QPointer<JobHandle> scene_job_, fit_job_, model_job_;
  bool scene_wanted_ = false, clouds_wanted_ = false, busy_ = false;
};

}  // namespace ostraka::ui
