// What the queue's work leaves in a project, with real scans and without a display.
#include "ui/queue/compute_batch.h"

#include <QtTest>

#include "files/files.h"
#include "intake/computed_again.h"
#include "synthetic_out.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class ComputeBatchTest : public QObject {
  Q_OBJECT

 private slots:
  // From another scanner's files to rows with models and measures, as photographs do.
  void importedScansBecomeSherdsOfTheCatalogue() {
    const QTemporaryDir folder;
    const std::filesystem::path place = folder.path().toStdString();
    records::ProjectRecord record;
    record.code = "ARM";
    record.title = "Trial";
    auto project = upkeep::Project::create(place / "project", record);
    QVERIFY2(project.has_value(), project ? "" : project.error().sentence().c_str());
    catalogue::Catalogue& rows = project->catalogue();
    records::BatchRecord queued;
    queued.state = records::BatchState::Queued;
    const auto batch = rows.addBatch(queued, {});
    QVERIFY(batch.has_value());
    const std::string number = rows.batch(*batch)->number;
    pipeline::SyntheticOptions options;
    options.sherds = 2;
    options.swapped_look_alikes = false;
    const auto truth = pipeline::writeSyntheticOut(place / "truth", options);
    std::filesystem::create_directories(project->batchFolder(number));
    for (const char* side : {"front", "back"})
      std::filesystem::copy(truth.output / "work" / (std::string("scans_") + side),
                            project->batchFolder(number) / side);
    QuietProgress quiet;
    const auto figures = computeBatch({place / "project", number}, quiet, {});
    QVERIFY2(figures.has_value(), figures ? "" : figures.error().sentence().c_str());
    QCOMPARE(figures->sherds, 2);
    const auto sherds = rows.sherdRows(*batch);
    QVERIFY(sherds.has_value());
    QCOMPARE(sherds->size(), std::size_t{2});
    const auto records = rows.sherds(*sherds);
    QVERIFY(records.has_value());
    for (const records::SherdRecord& sherd : *records) {
      QVERIFY(!sherd.model_path.empty());
      QVERIFY(std::filesystem::exists(place / "project" / sherd.model_path));
      const auto measured = rows.measurements(sherd.row);
      QVERIFY(std::any_of(measured->begin(), measured->end(),
                          [](const auto& m) { return m.kind == "length" && m.value > 15; }));
    }
    const records::BatchState state = rows.batch(*batch)->state;
    QCOMPARE(state, figures->ask > 0 ? records::BatchState::Review : records::BatchState::Done);
  }

  void aPieceThatFoundNoPartnerWantsAPerson() {
    const QTemporaryDir folder;
    const std::filesystem::path place = folder.path().toStdString();
    records::ProjectRecord record;
    record.code = "ARM";
    record.title = "Trial";
    auto project = upkeep::Project::create(place / "project", record);
    QVERIFY(project.has_value());
    records::BatchRecord queued;
    queued.state = records::BatchState::Queued;
    const auto batch = project->catalogue().addBatch(queued, {});
    const std::string number = project->catalogue().batch(*batch)->number;
    pipeline::SyntheticOptions options;
    options.sherds = 2;
    options.swapped_look_alikes = false;
    const auto truth = pipeline::writeSyntheticOut(place / "truth", options);
    std::filesystem::create_directories(project->batchFolder(number));
    for (const char* side : {"front", "back"})
      std::filesystem::copy(truth.output / "work" / (std::string("scans_") + side),
                            project->batchFolder(number) / side);
    QVERIFY(std::filesystem::remove(project->batchFolder(number) / "back" / "b002.ply"));
    QuietProgress quiet;
    const auto figures = computeBatch({place / "project", number}, quiet, {});
    QVERIFY2(figures.has_value(), figures ? "" : figures.error().sentence().c_str());
    QCOMPARE(figures->sherds, 2);
    QCOMPARE(figures->sure, 1);
    QCOMPARE(figures->ask, 1);
    QCOMPARE(project->catalogue().batch(*batch)->state, records::BatchState::Review);
  }

  // In its midst somebody decides, and wants that computed, too.
  void whatIsAskedWhileABatchIsComputedIsQueuedAgain() {
    class Asking final : public Progress {
     public:
      explicit Asking(std::filesystem::path project) : project_(std::move(project)) {}
      void begin(std::string_view stage, double) override {
        if (stage != "pairs") return;
        auto rows = upkeep::Project::connect(project_);
        asked = rows && intake::queueAgain(*rows, "B0001", {}).has_value();
      }
      void report(std::int64_t, std::int64_t) override {}
      void note(NoteLevel, std::string_view) override {}
      bool asked = false;

     private:
      std::filesystem::path project_;
    };
    const QTemporaryDir folder;
    const std::filesystem::path place = folder.path().toStdString();
    records::ProjectRecord record;
    record.code = "ARM";
    record.title = "Trial";
    auto project = upkeep::Project::create(place / "project", record);
    QVERIFY(project.has_value());
    records::BatchRecord queued;
    queued.state = records::BatchState::Queued;
    const auto batch = project->catalogue().addBatch(queued, {});
    QVERIFY(batch.has_value());
    const auto truth =
        pipeline::writeSyntheticOut(place / "truth", {.sherds = 2, .swapped_look_alikes = false});
    std::filesystem::create_directories(project->batchFolder("B0001"));
    for (const char* side : {"front", "back"})
      std::filesystem::copy(truth.output / "work" / (std::string("scans_") + side),
                            project->batchFolder("B0001") / side);
    Asking progress(place / "project");
    const auto figures = computeBatch({place / "project", "B0001"}, progress, {});
    QVERIFY2(figures.has_value(), figures ? "" : figures.error().sentence().c_str());
    QVERIFY(progress.asked);
    QCOMPARE(project->catalogue().batch(*batch)->state, records::BatchState::Queued);
    QuietProgress quiet;
    QVERIFY(computeBatch({place / "project", "B0001"}, quiet, {}).has_value());
    QVERIFY(project->catalogue().batch(*batch)->state != records::BatchState::Queued);
  }

  // 48 batches must not become 529 when a first, small one has been computed, nor grow with each.
  void theRoomOfABatchIsPredictedFromItsPhotographs() {
    const QTemporaryDir folder;
    const std::filesystem::path place = folder.path().toStdString();
    const double before = bytesPerBatch(place);
    const auto photograph = [&](const char* batch, std::size_t bytes) {
      for (const char* side : {"front", "back"})
        QVERIFY(writeFileAtomically(place / "batches" / batch / side / "cam0_pos00.jpg",
                                    std::string(bytes, 'x'))
                    .has_value());
    };
    photograph("B0001", 1000);
    QCOMPARE(bytesPerBatch(place), before);
    photograph("B0002", 20'000'000);
    photograph("B0003", 1000);
    const double three = bytesPerBatch(place);
    QCOMPARE(three, 3 * 40e6);  // its results are expected, too
    photograph("B0004", 1000);
    QCOMPARE(bytesPerBatch(place), three);
    photograph("B0005", 30'000'000);
    QCOMPARE(bytesPerBatch(place), 3 * 60e6);
    // Scans that were imported, however many, say nothing of what is photographed.
    for (int i = 100; i < 120; ++i)
      for (const char* side : {"front", "back"})
        QVERIFY(writeFileAtomically(
                    place / "batches" / ("B0" + std::to_string(i)) / side / "f001.ply", "ply")
                    .has_value());
    QCOMPARE(bytesPerBatch(place), 3 * 60e6);
  }
};

QTEST_GUILESS_MAIN(ComputeBatchTest)
#include "compute_batch_test.moc"
