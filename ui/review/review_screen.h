#pragma once
#include <QPointer>
#include <filesystem>

#include "intake/apply_decision.h"
#include "ui/frame/plate_screen.h"
#include "ui/jobs/job.h"
#include "ui/pairs/review_work.h"

class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ostraka::ui {

class NoBatchYet;
class PairReview;
class ReviewPane;

/// The screen Review: which batch, who decides, and the pane.
class ReviewScreen final : public PlateScreen {
  Q_OBJECT

 public:
  explicit ReviewScreen(QWidget* parent = nullptr);

  void openProject(ProjectSession& session) override;
  void closeProject() override;
  int waiting() const override;
  QString waitingText() const override;
  void setInFront(bool in_front) override;
  void takeChosen(const QString& what) override;
  QAbstractButton* primary() const override;
  void setCompact(bool compact) override;

  PairReview* review() const { return review_; }

 public slots:
  void showItem(const QString& batch) override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void listBatches();
  void showBatch(const QString& batch) override;
  void showOpened(const OpenedBatch& opened);
  void compute();
  void showApplied(const std::filesystem::path& output, const intake::AppliedDecision& applied);
  QString appliedWords(const intake::AppliedDecision& applied) const;
  void restoreModels(const QString& batch);
  void follow(const QString& batch);
  void countElsewhere();
  std::filesystem::file_time_type stampOf(const QString& batch) const;
  void nameSherds();
  QWidget* buildScale();
  void showScale();

  QString asked_;  ///< the sentence that asks for initials
  QString told_;   ///< what the last decision did
  QLineEdit* person_ = nullptr;
  QPushButton* compute_ = nullptr;
  QFrame* scale_ = nullptr;  ///< what holds the batch, besides its pairs
  QLabel* scale_words_ = nullptr;
  PairReview* review_ = nullptr;
  QPointer<ReviewPane> pane_;
  NoBatchYet* empty_ = nullptr;
  bool compact_ = false;
  QPointer<JobHandle> opening_;
  std::filesystem::file_time_type stamp_;  ///< of the results that are shown
  int elsewhere_ = 0;                      ///< what waits in batches that are not shown
  QString waits_;                          ///< one of these batches
};

}  // namespace ostraka::ui
