// Pages that need more room than there is are scrolled; others fill what there is.
#include "ui/widgets/page_area.h"

#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>

#include "tests/ui/program.h"
#include "ui/widgets/elided_label.h"

namespace ostraka::ui {

class PageAreaTest : public QObject {
  Q_OBJECT

 private slots:
  void aPageFillsTheRoomThereIs();
  void aPageThatNeedsMoreIsScrolledToItsFocus();
  void aLongLineWidensNothing();
};

void PageAreaTest::aPageFillsTheRoomThereIs() {
  auto* page = new QWidget;
  page->setMinimumSize(200, 100);
  PageArea area(page);
  area.resize(500, 400);
  area.show();
  QCOMPARE(page->size(), QSize(500, 400));
  area.resize(300, 120);
  QCOMPARE(page->size(), QSize(300, 120));
  QVERIFY(!area.verticalScrollBar()->isVisible());
}

void PageAreaTest::aPageThatNeedsMoreIsScrolledToItsFocus() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  QLineEdit* last = nullptr;
  for (int i = 0; i < 20; ++i) column->addWidget(last = new QLineEdit(page));
  PageArea area(page);
  area.resize(300, 150);
  area.show();
  area.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&area));
  QVERIFY(page->height() >= page->minimumSizeHint().height());
  QVERIFY(page->height() > area.viewport()->height());
  QCOMPARE(page->width(), area.viewport()->width());
  column->itemAt(18)->widget()->setFocus();
  QTest::keyClick(column->itemAt(18)->widget(), Qt::Key_Tab);
  QTRY_VERIFY(
      area.viewport()->rect().contains(last->mapTo(area.viewport(), last->rect().center())));
}

void PageAreaTest::aLongLineWidensNothing() {
  ElidedLabel label;
  label.setText(QString(400, QLatin1Char('w')));
  QVERIFY(label.minimumSizeHint().width() < label.fontMetrics().averageCharWidth() * 10);
  label.resize(100, 30);
  (void)label.grab();
  QCOMPARE(label.toolTip(), label.text());
  label.setText(QStringLiteral("w"));
  (void)label.grab();
  QCOMPARE(label.toolTip(), QString());
}

OSTRAKA_UI_TEST(PageAreaTest)

}  // namespace ostraka::ui

#include "page_area_test.moc"
