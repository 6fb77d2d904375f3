#include <QAbstractButton>
#include <QtTest>

#include "tests/ui/program.h"
#include "ui/widgets/message_panel.h"

using namespace ostraka;
using namespace ostraka::ui;

class MessagePanelTest : public QObject {
  Q_OBJECT

 private slots:
  void onlyAnErrorLooksLikeAnError() {
    MessagePanel panel(QStringLiteral("message"), nullptr);
    const auto ground = [&] { return panel.palette().color(QPalette::Window); };
    panel.showError({ErrorCode::UnusableInput, "No photographs.", "/p"}, QStringLiteral("OK"));
    const QColor failed = ground();
    for (const State state : {State::Sure, State::Ask, State::Busy}) {
      panel.showWords(state, QStringLiteral("The project is restored."), {}, QStringLiteral("OK"));
      QVERIFY(ground() != failed);
    }
    QCOMPARE(panel.headline(), QStringLiteral("The project is restored."));
  }

  // Cancel is at hand, and is not what to do next.
  void whatStopsSomethingThatGoesOnIsNotThePrimaryButton() {
    MessagePanel panel(QStringLiteral("message"), nullptr);
    const auto primary = [&] { return panel.act()->property("primary").toBool(); };
    panel.showWords(State::Busy, QStringLiteral("Restoring"), {}, QStringLiteral("Cancel"));
    QVERIFY(!primary());
    panel.showWords(State::Sure, QStringLiteral("Restored"), {},
                    QStringLiteral("Open the project"));
    QVERIFY(primary());
    panel.setBesidePrimary();
    panel.showWords(State::Ask, QStringLiteral("Sure?"), {}, QStringLiteral("OK"));
    QVERIFY(!primary());
  }
};

OSTRAKA_UI_TEST(MessagePanelTest)
#include "message_panel_test.moc"
