// The wheel changes no field of a form.
#include "ui/widgets/wheel_guard.h"

#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtTest>

using namespace ostraka::ui;

class WheelGuardTest : public QObject {
  Q_OBJECT

 private slots:
  void aFieldKeepsItsValueAndLeavesTheWheelToTheForm() {
    WheelGuard guard;
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

QTEST_MAIN(WheelGuardTest)
#include "wheel_guard_test.moc"
