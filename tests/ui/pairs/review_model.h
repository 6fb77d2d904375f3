#pragma once
#include <QAbstractItemModelTester>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <memory>

#include "synthetic_out.h"
#include "ui/jobs/job.h"
#include "ui/pairs/pair_review.h"

namespace ostraka::ui {

/// The review without a window: four made-up sherds, the first two look-alikes whose backs the
/// program has swapped.
class ReviewModel : public QObject {
 protected:
  void make() { out_ = pipeline::writeSyntheticOut(folder_.path().toStdString() + "/out", {}); }

  void open() {
    undo_ = std::make_unique<QUndoStack>();
    review_ = std::make_unique<PairReview>(runner_, *undo_);
    new QAbstractItemModelTester(&review_->cards(),
                                 QAbstractItemModelTester::FailureReportingMode::QtTest,
                                 &review_->cards());
    const auto batch = openBatch(out_.output);
    QVERIFY(batch.has_value());
    review_->setPerson("AP");
    review_->open(*batch);
  }

  void close() {
    review_.reset();
    std::filesystem::remove(out_.output / "decisions.json");
  }

  decisions::Decisions onDisk() { return *decisions::readDecisions(out_.output); }
  const review::ReviewCard& cardOf(int front) { return *review_->batch().review().ofFront(front); }
  void waitForScene() { QTRY_VERIFY(!review_->hand().isLoading()); }
  /// With its pair in sight: nothing else is decided.
  PairReview& shown() {
    waitForScene();
    return *review_;
  }

  QTemporaryDir folder_;
  pipeline::SyntheticOut out_;
  InlineJobRunner runner_;
  std::unique_ptr<QUndoStack> undo_;
  std::unique_ptr<PairReview> review_;
};

}  // namespace ostraka::ui
