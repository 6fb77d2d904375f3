#include "ui/sherds/sherd_table_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "catalogue/batches.h"
#include "sample_project.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;

class SherdTableModelTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsThePromisesOfAModel() {
    SampleProject sample(300);
    SherdTableModel model;
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), &sample.session().jobs());
    QCOMPARE(model.rowCount(), 300);
    QCOMPARE(model.setFilter("rim"), QString());
    QCOMPARE(model.rowCount(), 100);
    model.sort(5, Qt::DescendingOrder);
    QCOMPARE(model.rowCount(), 100);
    model.setCatalogue(nullptr, {}, nullptr);
    QCOMPARE(model.rowCount(), 0);
  }

  void readsOnlyThePagesThatAreShown() {
    SampleProject sample(1000);
    SherdTableModel model;
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), nullptr);
    QCOMPARE(model.pagesRead(), 0);
    QCOMPARE(model.data(model.index(0, 0), Qt::DisplayRole).toString(),
             QString("ARM1-T3-0012-0001"));
    QCOMPARE(model.pagesRead(), 1);
    QCOMPARE(model.data(model.index(999, 0), Qt::DisplayRole).toString(),
             QString("ARM1-T3-0013-0500"));
    for (int row = 0; row < SherdTableModel::kPage; ++row)
      model.data(model.index(row, 3), Qt::DisplayRole);
    QCOMPARE(model.pagesRead(), 2);
  }

  void oneChangeIsOneSignalAndNoReset() {
    SampleProject sample(300);
    SherdTableModel model;
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), nullptr);
    const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    const QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QCOMPARE(model.data(model.index(0, 4), Qt::DisplayRole).toString(), QString("grey"));
    const records::FieldChange change{sample.sherds()[0], "ware", "black"};
    QVERIFY(sherds::SherdChanges(sample.catalogue()).apply(std::span(&change, 1), {}).has_value());
    QCOMPARE(model.data(model.index(0, 4), Qt::DisplayRole).toString(), QString("grey"));
    model.refresh({sample.sherds()[0]});
    QCOMPARE(model.data(model.index(0, 4), Qt::DisplayRole).toString(), QString("black"));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(reset.count(), 0);
    QCOMPARE(model.rowOf(sample.sherds()[1]), 150);  // the first of the second context
  }

  void aFilterThatIsNotUnderstoodShowsNoEarlierResult() {
    SampleProject sample(10);
    SherdTableModel model;
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), nullptr);
    QVERIFY(model.setFilter("colour:red").contains("'colour'"));
    QCOMPARE(model.rowCount(), 0);
    model.reload();
    QCOMPARE(model.rowCount(), 0);
    QCOMPARE(model.setFilter(""), QString());
    QCOMPARE(model.rowCount(), 10);
  }

  void aMeasureOfADoubtfulScaleCarriesAQuestionMark() {
    SampleProject sample(3);
    records::BatchRecord batch;
    batch.number = "B0001";
    batch.scale_doubts = {"The scale is wrong."};
    const auto row = catalogue::Batches(sample.catalogue()).add(batch, {});
    QVERIFY(row.has_value());
    records::SherdRecord fresh;
    fresh.batch = *row;
    const auto sherd = sherds::Sherds(sample.catalogue()).add(fresh, {});
    QVERIFY(sherd.has_value());
    for (const auto& [kind, value, method] :
         {std::tuple("length", 50.3, "program"), std::tuple("weight", 23.4, "scale")})
      QVERIFY(sherds::Measurements(sample.catalogue())
                  .add({*sherd, kind, {}, value, std::nullopt, method, {}, {}}, {})
                  .has_value());
    SherdTableModel model;
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), nullptr);
    QCOMPARE(model.setFilter("scale:doubtful"), QString());
    QCOMPARE(model.rowCount(), 1);
    const QModelIndex length = model.index(0, 5), weight = model.index(0, 8);
    QCOMPARE(model.data(length, Qt::DisplayRole).toString(), QLocale().toString(50.3) + " ?");
    QCOMPARE(model.data(weight, Qt::DisplayRole).toString(), QLocale().toString(23.4));
    QVERIFY(model.data(length, Qt::AccessibleTextRole).toString().endsWith("in doubt"));
    QVERIFY(model.data(length, Qt::ToolTipRole).toString().contains("B0001"));
    QCOMPARE(model.setFilter("-scale:doubtful"), QString());
    QCOMPARE(model.rowCount(), 3);
  }

  void picturesComeFromAWorker() {
    SampleProject sample(5);
    SherdTableModel model;
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), &sample.session().jobs());
    const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    const auto sizes = [&] {
      return model.data(model.index(0, 0), Qt::DecorationRole).value<QIcon>().availableSizes();
    };
    QVERIFY(!sizes().contains(QSize(240, 240)));
    QTRY_VERIFY(changed.count() > 0);
    QVERIFY(sizes().contains(QSize(240, 240)));
  }

  void picturesThatArriveTogetherAreDrawnTogether() {
    SampleProject sample(5);
    InlineJobRunner inline_jobs;
    SherdTableModel model;
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), &inline_jobs);
    const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    for (int row = 0; row < 5; ++row) model.data(model.index(row, 0), Qt::DecorationRole);
    QTRY_VERIFY(changed.count() > 0);
    QCOMPARE(changed.count(), 1);
  }

  void readersHearTheFieldWithItsValue() {
    SampleProject sample(1);
    SherdTableModel model;
    model.setCatalogue(&sample.catalogue(), sample.session().folder(), nullptr);
    QCOMPARE(model.data(model.index(0, 4), Qt::AccessibleTextRole).toString(),
             QString("ware: grey"));
    QCOMPARE(model.data(model.index(0, 2), Qt::AccessibleTextRole).toString(),
             QString("bag: not recorded"));
  }
};

OSTRAKA_UI_TEST(SherdTableModelTest)
#include "records/records.h"
#include "records/sherd.h"
#include "sherd_table_model_test.moc"
