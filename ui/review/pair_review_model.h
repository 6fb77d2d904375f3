#pragma once
#include <QAbstractListModel>
#include <QHash>
#include <QPointer>
#include <QString>
#include <functional>
#include <memory>
#include <set>

#include "ui/jobs/job.h"
#include "ui/review/card_role.h"
#include "ui/review/review_rows.h"
#include "ui/review/review_words.h"
#include "ui/review/review_work.h"
#include "ui/review/trial.h"

class QUndoStack;

namespace ostraka::ui {

/// The review of one batch without a window: cards as rows, the card in hand, what is tried on it,
/// and the decisions. Long work goes through the jobs; every act through the undo stack.
class PairReviewModel final : public QAbstractListModel {
  Q_OBJECT

 public:
  /// Both outlive the model.
  PairReviewModel(JobRunner& runner, QUndoStack& undo, QObject* parent = nullptr);

  void open(OpenedBatch batch);
  void close();
  bool isOpen() const { return live_ != nullptr; }
  bool shows(const std::filesystem::path& output) const;
  void setPerson(const QString& initials);
  const QString& person() const { return person_; }
  const LivePairsPtr& live() const { return live_; }
  const review::Review& review() const { return review_; }

  void setApply(ApplyDecision apply) { apply_ = std::move(apply); }  ///< unset: the file alone
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  int rowOf(int front) const;
  int rowOfLoneBack(int back) const;  ///< -1: a front holds it
  int rowInHand() const;
  void setNumbers(const QHash<int, QString>& numbers);  ///< of the sherds, by front

  int front() const { return trial_.front; }  ///< of the card in hand
  const review::ReviewCard* card() const;
  const std::vector<review::ReviewCandidate>& candidates() const { return candidates_; }
  int chosen() const;  ///< index among the candidates; -1: none of them
  const Trial& trial() const { return trial_; }
  const review::LiveFit& fit() const { return fit_; }
  bool isMeasured() const;  ///< fit() is of the pose on trial
  bool isSettling() const { return busy_; }
  const std::vector<double>& settlingRms() const { return settling_rms_; }  ///< so far, mm
  QString reason() const;       ///< why the card is doubtful, or what is tried on it
  QString figuresText() const;  ///< fracture RMS and overlap of the trial, in words
  bool canAccept() const { return whyNotAccept().isEmpty(); }
  QString whyNotAccept() const;  ///< empty when it can
  int holderOf(int back) const;  ///< the front that holds this back now, -1: none
  int waiting() const { return review_.waiting(); }
  bool wantsComputing() const;  ///< pairs or pieces were changed, not only confirmed

 public slots:
  void select(int front);
  void selectRow(int row);
  void next();
  void previous();
  void choose(int candidate);  ///< index among candidates()
  void chooseBack(int back);   ///< any back; compared first where the program did not
  void accept();
  void setAside();
  void reshoot();
  /// A back dragged onto a front: decides at once, or tries it where the program did not.
  void giveBack(int front, int back);
  void stepStart(int by);   ///< to the next good start point
  void stepSample(int by);  ///< by one of 200 samples
  void moveByHand(const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& move_mm);
  void settle();
  void stopSettling();  ///< the back stays where it was
  /// The pieces of the row in hand and of this one are one sherd's: its fronts or its backs (those
  /// where one of the two is a lone back). The pairs have to be computed again.
  void joinWith(batch::Side side, int row);
  /// The side in hand is two pieces, cut along a line as the picture shows it (front's frame, mm).
  void split(batch::Side side, const Eigen::Vector2d& a_mm, const Eigen::Vector2d& b_mm);
  void fetchModel();                                ///< of the pair on trial, as last computed
  void fetchScans() { fetchScene(Clouds::Fetch); }  ///< both sides as they are on trial

 signals:
  void cardChanged();  ///< another card is in hand, or its state changed
  void candidatesChanged();
  void trialChanged();                                        ///< back or pose
  void settlingAt(const Eigen::Isometry3d& front_from_back);  ///< on the way; trialChanged follows
  void sceneChanged(const std::shared_ptr<const ostraka::ui::PairScene>& scene);
  void busyChanged(bool busy);
  void modelFetched(const std::shared_ptr<const ostraka::TriangleMesh>& model);  ///< null: none
  /// Is on disk. Taken back or done again, it may be another batch's than the one that is shown.
  void decided(const std::filesystem::path& output, const ostraka::intake::AppliedDecision& taken);
  void failed(const QString& sentence);
  void personWanted();  ///< a decision was refused, for nobody has said who decides
  void waitingChanged();

 private:
  friend class DecideCommand;
  friend class TryCommand;
  Result<void> write(const std::filesystem::path& output, decisions::PairDecision& decision);
  void showTrial(const Trial& trial);
  void decide(decisions::PairDecision decision, const QString& text);
  void tryOut(const Trial& trial, const QString& text, bool merge = false);
  void redoReview();
  void dropJobs();
  void takeCandidates();
  void hold(const Trial& trial);                                  ///< another card
  void show(const decisions::ScanRef& scan, const Trial& tried);  ///< as tried, if it is of its row
  const ReviewRow& at(int row) const { return rows_.at(static_cast<std::size_t>(row)); }
  void fetchScene(Clouds clouds);
  void fetchMore();
  bool wantsMore(int front) const;
  Trial standing(const review::ReviewCard& card) const;  ///< what is shown of it at first
  CardStory storyOf(const review::ReviewCard& card) const;
  std::vector<review::ReviewCandidate> candidatesOf(int front) const;
  void fitAt(std::function<Result<review::LiveFit>(Progress&, std::stop_token)> work, Made made,
             const QString& text);
  decisions::PairDecision about(decisions::DecisionKind kind) const;
  decisions::ScanRef frontRef(int i) const;
  decisions::ScanRef backRef(int i) const;
  QString inHand() const;
  bool personIsKnown();

  JobRunner& runner_;
  QUndoStack& undo_;
  QString person_;
  LivePairsPtr live_;
  decisions::Decisions decisions_, followed_;  ///< all, and those that the results follow
  review::Review review_, program_;            ///< as things stand, and without any decision
  std::vector<ReviewRow> rows_;
  QHash<int, QString> numbers_;
  ScanPictures thumbnails_;
  std::map<int, std::vector<review::ReviewCandidate>> more_;  ///< by front, compared on demand
  std::set<int> asked_;  ///< fronts for which there are no more
  std::vector<review::ReviewCandidate> candidates_;
  Trial trial_;
  review::LiveFit fit_;
  std::vector<double> settling_rms_;
  QPointer<JobHandle> scene_job_, fit_job_, more_job_, thumbnails_job_, model_job_;
  bool scene_wanted_ = false, clouds_wanted_ = false, busy_ = false;
  ApplyDecision apply_;
};

}  // namespace ostraka::ui
