#pragma once
#include <QAbstractItemModelTester>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <memory>

#include "synthetic_out.h"
#include "ui/jobs/job.h"
#include "ui/review/pair_review_model.h"

namespace ostraka::ui {

/// The review without a window: four made-up sherds, the first two look-alikes whose backs the
/// program has swapped.
class ReviewModel : public QObject {
 protected:
  void make() { out_ = pipeline::writeSyntheticOut(folder_.path().toStdString() + "/out", {}); }

  void open() {
    undo_ = std::make_unique<QUndoStack>();
    model_ = std::make_unique<PairReviewModel>(runner_, *undo_);
    new QAbstractItemModelTester(
        model_.get(), QAbstractItemModelTester::FailureReportingMode::QtTest, model_.get());
    const auto batch = openBatch(out_.output);
    QVERIFY(batch.has_value());
    model_->setPerson("AP");
    model_->open(*batch);
  }

  void close() {
    model_.reset();
    std::filesystem::remove(out_.output / "decisions.json");
  }

  decisions::Decisions onDisk() { return *decisions::readDecisions(out_.output); }
  const review::ReviewCard& cardOf(int front) { return *model_->review().ofFront(front); }
  void waitForScene() { QTRY_VERIFY(model_->fit().fracture_rms_mm > 0); }

  QTemporaryDir folder_;
  pipeline::SyntheticOut out_;
  InlineJobRunner runner_;
  std::unique_ptr<QUndoStack> undo_;
  std::unique_ptr<PairReviewModel> model_;
};

}  // namespace ostraka::ui
