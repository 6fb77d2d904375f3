// The wheel changes no field of a form, and Esc on an open list closes the list only.
#include "ui/widgets/input_guard.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QShortcut>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtTest>

#include "tests/ui/program.h"

using namespace ostraka::ui;

class InputGuardTest : public QObject {
  Q_OBJECT

 private slots:
  void escOnAnOpenListClosesTheListOnly() {
    InputGuard guard;
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
    InputGuard guard;
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

  void aFieldKeepsItsValueAndLeavesTheWheelToTheForm() {
    InputGuard guard;
    qApp->installEventFilter(&guard);
    QScrollArea area;
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    auto* combo = new QComboBox(form);
    combo->addItems({"0012", "0013"});
    auto* spin = new QSpinBox(form);
    auto* slider = new QSlider(Qt::Horizontal, form);
    column->addWidget(combo);
    column->addWidget(spin);
    column->addWidget(slider);
    form->setMinimumHeight(2000);
    area.setWidget(form);
    area.resize(200, 200);
    area.show();
    for (QWidget* field : {static_cast<QWidget*>(combo), static_cast<QWidget*>(spin),
                           static_cast<QWidget*>(slider)}) {
      field->setFocus();
      QWheelEvent down({5, 5}, field->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton,
                       Qt::NoModifier, Qt::NoScrollPhase, false);
      QApplication::sendEvent(field, &down);
      QVERIFY(!down.isAccepted());  // and so Qt hands it on to what scrolls
    }
    QCOMPARE(combo->currentIndex(), 0);
    QCOMPARE(spin->value(), 0);
    QCOMPARE(slider->value(), 0);
  }
};

OSTRAKA_UI_TEST(InputGuardTest)
#include "input_guard_test.moc"
