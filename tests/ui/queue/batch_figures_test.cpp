// The figures of a batch are of its last computation; what became of its sherds since goes before.
#include "ui/queue/batch_figures.h"

#include <QtTest>

#include "queue_bench.h"

using namespace ostraka;
using namespace ostraka::ui;

class BatchFiguresTest : public QObject {
  Q_OBJECT

 private slots:
  void areLessWhatBecameOfItsSherdsSince() {
    const QTemporaryDir folder;
    const auto project = projectIn(folder.path().toStdString());
    catalogue::Catalogue& rows = project->catalogue();
    records::SiteRecord site;
    site.code = site.name = "ARM1";
    records::ContextRecord context;
    context.site = *rows.save(site, {});
    context.number = "0012";
    records::SherdRecord sherd;
    sherd.context = *rows.save(context, {});
    QString first;
    for (const char* number : {"A-1", "A-2"}) {
      sherd.number = number;
      sherd.batch = *rows.addBatch({}, {});
      QVERIFY(rows.addSherd(sherd, {}).has_value());
      if (first.isEmpty()) first = QString::fromStdString(rows.batch(sherd.batch)->number);
    }
    BatchFigures figures;
    figures.numbers_left = {"A-1", "A-2", "A-3"};
    figures.unlike = {{"A-1", 47.7, 40.4}, {"A-2", 30, 40}};
    QVERIFY(keepFigures(rows, first, figures).has_value());
    const auto kept = keptFigures(rows, first);
    QCOMPARE(kept->numbers_left, figures.numbers_left);
    QCOMPARE(kept->unlike.size(), std::size_t{2});
    const auto shown = shownFigures(rows, first);
    QCOMPARE(shown->numbers_left, (std::vector<std::string>{"A-2", "A-3"}));  // A-1 was given
    QCOMPARE(shown->unlike.size(), std::size_t{1});                           // A-2 lies elsewhere
    QCOMPARE(shown->unlike[0].number, std::string("A-1"));
  }
};

QTEST_GUILESS_MAIN(BatchFiguresTest)
#include "batch_figures_test.moc"
