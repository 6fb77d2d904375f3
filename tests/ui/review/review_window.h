#pragma once
#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QMainWindow>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "../project_in.h"
#include "catalogue/batches.h"
#include "records/records.h"
#include "synthetic_out.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/job.h"
#include "ui/pairs/pair_review.h"
#include "ui/review/review_screen.h"
#include "ui/viewport/sherd_view.h"
#include "upkeep/project.h"

namespace ostraka::ui {

/// The screen Review in a real window with real jobs, on made-up batches of look-alikes.
class ReviewWindow : public QObject {
 public:
  static void initMain() { prepareOpenGl(); }

 protected:
  void open(int sherds, bool with_project = false) {
    folder_ = std::make_unique<QTemporaryDir>();
    const std::filesystem::path project = folder_->path().toStdString();
    pipeline::SyntheticOptions options;
    options.sherds = sherds;
    out_ = pipeline::writeSyntheticOut(project / "results" / "B0001", options);
    runner_ = std::make_unique<ThreadedJobRunner>();
    std::shared_ptr<upkeep::Project> catalogue;
    if (with_project) {
      catalogue = projectIn(project / "rows", "ARM");
      enterBatch(*catalogue, sherds);
    }
    session_ = std::make_unique<ProjectSession>(catalogue, project, *runner_);
    window_ = std::make_unique<QMainWindow>();
    screen_ = new ReviewScreen(window_.get());
    window_->setCentralWidget(screen_);
    QAction* undo = session_->undo().createUndoAction(window_.get());
    undo->setShortcut(QKeySequence::Undo);
    window_->addAction(undo);
    window_->resize(1280, 720);
    window_->show();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    screen_->openProject(*session_);
    QTRY_VERIFY(review()->batch().isOpen());
    auto* initials = screen_->findChild<QLineEdit*>("initials");
    QTRY_VERIFY(review()->whyNotAccept().contains("initials"));
    key(Qt::Key_Return);  // without a name nothing is decided, and the name is what is typed next
    QTRY_VERIFY(initials->hasFocus());
    QVERIFY(standingOnDisk().empty());
    QTest::keyClicks(QApplication::focusWidget(), "AP");
    key(Qt::Key_Return);
    QTRY_COMPARE(review()->person(), QStringLiteral("AP"));
    QTRY_VERIFY(review()->hand().fit().fracture_rms_mm > 0);
  }

  void enterBatch(upkeep::Project& project, int sherds, const std::string& number = "B0001") {
    catalogue::Catalogue& rows = project.catalogue();
    records::BatchRecord batch;
    batch.number = number;
    batch.state = records::BatchState::Review;
    const auto row = catalogue::Batches(rows).add(batch, {});
    QVERIFY2(row.has_value(), row ? "" : row.error().sentence().english().c_str());
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
      for (int i = 0; i < sherds; ++i) {
        records::ScanRecord scan;
        scan.batch = *row;
        scan.side = side;
        scan.index = i + 1;
        const decisions::ScanRef& ref =
            (side == batch::Side::Front ? out_.table.fronts : out_.table.backs)
                .at(static_cast<std::size_t>(i));
        scan.name = ref.id;
        scan.plate_x_mm = ref.place_mm.x();
        scan.plate_y_mm = ref.place_mm.y();
        scan.path = "results/" + number + "/scans/" + scan.name + ".ply";
        QVERIFY(catalogue::Batches(rows).save(scan, {}).has_value());
      }
  }

  /// The window, then what it stands on.
  void close() {
    window_.reset();
    session_.reset();
    runner_.reset();
  }

  records::BatchState batchState() {
    return catalogue::Batches(session_->project().catalogue()).byNumber("B0001")->state;
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    // For a moment nothing has it: the window manager is still busy with the window.
    QTRY_VERIFY(QApplication::focusWidget() != nullptr);
    // A person decides on what is seen.
    QTRY_VERIFY(!review()->hand().isLoading());
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  }
  PairReview* review() { return screen_->review(); }
  const review::ReviewCard& cardOf(int front) { return *review()->batch().review().ofFront(front); }
  decisions::Decisions standingOnDisk() {
    return decisions::standing(*decisions::readDecisions(out_.output));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  pipeline::SyntheticOut out_;
  std::unique_ptr<ThreadedJobRunner> runner_;
  std::unique_ptr<ProjectSession> session_;
  std::unique_ptr<QMainWindow> window_;
  ReviewScreen* screen_ = nullptr;
};

}  // namespace ostraka::ui
