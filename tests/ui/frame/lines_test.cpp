// What the line at the foot says is whole where there is room, and shares the room where not.
#include "ui/frame/lines.h"

#include <QAction>
#include <QLabel>
#include <QTest>

#include "../named.h"
#include "tests/ui/program.h"

namespace ostraka::ui {

class LinesTest : public QObject {
  Q_OBJECT

 private slots:
  void theFootGivesEachSentenceTheRoomThatItNeeds() {
    QAction pause(QStringLiteral("Pause")), log(QStringLiteral("Log"));
    FooterLine foot(&pause, &log);
    foot.resize(1000, foot.sizeHint().height());
    foot.show();
    auto* work = named<QLabel>(foot, "footerWork");
    auto* told = named<QLabel>(foot, "footerSaid");
    const auto room = [](const QLabel* label) {
      return label->width() >= label->fontMetrics().horizontalAdvance(label->text());
    };
    const QString few = QStringLiteral("Idle"), many = QStringLiteral("many words ").repeated(12);
    foot.setWork(few, -1);
    foot.say(QStringLiteral("many words ").repeated(6));
    QTRY_VERIFY(room(work) && room(told));
    foot.setWork(QStringLiteral("many words ").repeated(6), 0.5);
    foot.say({});
    QTRY_VERIFY(room(work));
    foot.setWork(many, 0.5);
    foot.say(many);
    QTRY_VERIFY2(told->width() > 250 && work->width() > 250,
                 qPrintable(QStringLiteral("%1, %2").arg(work->width()).arg(told->width())));
  }
};

OSTRAKA_UI_TEST(LinesTest)

}  // namespace ostraka::ui

#include "lines_test.moc"
