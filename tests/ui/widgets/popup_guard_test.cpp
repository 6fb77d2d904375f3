// Esc on an open list closes the list only.
#include "ui/widgets/popup_guard.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QShortcut>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QtTest>

using namespace ostraka::ui;

class PopupGuardTest : public QObject {
  Q_OBJECT

 private slots:
  void escOnAnOpenListClosesTheListOnly() {
    PopupGuard guard;
    qApp->installEventFilter(&guard);
    QWidget page;
    auto* combo = new QComboBox(&page);
    combo->addItems({"Light", "Dark"});
    auto* column = new QVBoxLayout(&page);
    column->addWidget(combo);
    const QShortcut back(QKeySequence(Qt::Key_Escape), &page);
    page.show();
    page.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&page));
    const QSignalSpy left(&back, &QShortcut::activated);
    combo->showPopup();
    QTRY_VERIFY(combo->view()->isVisible());
    QTest::keyClick(combo->view(), Qt::Key_Escape);
    QTRY_VERIFY(!combo->view()->isVisible());
    QCOMPARE(left.count(), 0);
    page.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&page));
    QTest::keyClick(&page, Qt::Key_Escape);
    QCOMPARE(left.count(), 1);
  }

  void theKeyIsThePopupsOnlyWhileOneIsOpen() {
    PopupGuard guard;
    QComboBox combo;
    combo.addItem(QStringLiteral("Light"));
    combo.installEventFilter(&guard);
    const auto isTaken = [&combo](Qt::Key key) {
      QKeyEvent press(QEvent::ShortcutOverride, key, Qt::NoModifier);
      press.ignore();
      QApplication::sendEvent(&combo, &press);
      return press.isAccepted();
    };
    combo.show();
    QVERIFY(!isTaken(Qt::Key_Escape));
    combo.showPopup();
    QTRY_VERIFY(QApplication::activePopupWidget() != nullptr);
    QVERIFY(isTaken(Qt::Key_Escape));
    QVERIFY(!isTaken(Qt::Key_F5));
    combo.hidePopup();
  }
};

QTEST_MAIN(PopupGuardTest)
#include "popup_guard_test.moc"
