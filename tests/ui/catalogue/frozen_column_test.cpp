#include "ui/catalogue/frozen_column.h"

#include <QApplication>
#include <QScrollBar>
#include <QTableView>
#include <QTest>

#include "catalogue_window.h"
#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;

class FrozenColumnTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void theNumbersStayInSightWhereTheTableIsScrolledSideways() {
    const auto* numbers = table()->findChild<QTableView*>("sherdsFrozen");
    QVERIFY(!numbers->isVisible());
    QScrollBar* sideways = table()->horizontalScrollBar();
    QVERIFY(sideways->maximum() > 0);
    sideways->setValue(sideways->maximum());
    QVERIFY(numbers->isVisible());
    table()->verticalScrollBar()->setValue(7);
    const QRect ninth = numbers->visualRect(table()->model()->index(9, 0));
    QCOMPARE(numbers->viewport()->mapTo(table(), ninth.topLeft()).y(),
             table()
                 ->viewport()
                 ->mapTo(table(), table()->visualRect(table()->model()->index(9, 5)).topLeft())
                 .y());
    QTest::mouseClick(numbers->viewport(), Qt::LeftButton, {}, ninth.center());
    QVERIFY(table()->selectionModel()->isRowSelected(9, {}));
    filter("0012");
    // Scrolled back, the table shows the numbers itself.
    QCOMPARE(numbers->isVisible(), sideways->value() > sideways->minimum());
    sideways->setValue(0);
    QVERIFY(!numbers->isVisible());
  }
};

OSTRAKA_UI_TEST(FrozenColumnTest)
#include "frozen_column_test.moc"
