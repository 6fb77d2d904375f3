// The details of a sherd: what is refused, and what has little room.
#include "ui/catalogue/sherd_details.h"

#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QTranslator>

#include "catalogue_window.h"
#include "ui/catalogue/catalogue_station.h"
#include "ui/catalogue/number_delegate.h"
#include "ui/frame/elided_button.h"

using namespace ostraka;
using namespace ostraka::ui;

class DetailsTest : public CatalogueWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void withLargeLettersANumberKeepsItsEndAndTheDetailsTheirWidth() {
    sample_->addDraft();
    filter("state:draft");
    choose(0);
    QFont large = station_->font();
    large.setPointSizeF(1.6 * large.pointSizeF());
    station_->setFont(large);
    auto* give = static_cast<ElidedButton*>(child<QPushButton>("giveNumber"));
    give->setText("Donner le numéro ARAGATS-T2-000005-000123");
    station_->findChild<SherdDetails*>()->setFixedWidth(300);
    QTRY_VERIFY(give->isVisible() && give->width() <= 300);
    QCOMPARE(station_->findChild<SherdDetails*>()->horizontalScrollBar()->maximum(), 0);
    QVERIFY2(give->shownText().endsWith("0123"), qPrintable(give->shownText()));
    filter("state:numbered");
    QStyleOptionViewItem option;
    NumberDelegate().initStyleOption(&option, table()->model()->index(0, 0));
    QCOMPARE(option.text, QString("ARM1-T3-0012-0001"));
    QCOMPARE(option.textElideMode, Qt::ElideLeft);
  }

  void aRefusalIsInThePersonsLanguage() {
    class Marks final : public QTranslator {
      QString translate(const char* context, const char* source, const char*, int) const override {
        return qstrcmp(context, "ostraka::Error") == 0 ? "<" + QString::fromUtf8(source) + ">"
                                                       : QString();
      }
      bool isEmpty() const override { return false; }
    } marks;
    QVERIFY(QCoreApplication::installTranslator(&marks));
    choose(1);
    auto* text = child<QLabel>("refusalText");
    const auto refused = [&](const char* field, const QString& value) {
      auto* line = child<QLineEdit>(field);
      line->setFocus();
      line->selectAll();
      QTest::keyClicks(line, value);
      QTest::keyClick(line, Qt::Key_Return);
      return text->text();
    };
    const QString weight = refused("field_weight_g", "abc"), bag = refused("field_bag", "neck"),
                  number = refused("field_number", "ARM1-T3-0012-0001");
    QCoreApplication::removeTranslator(&marks);
    QCOMPARE(weight, QString("<'abc' is no number; write 12.5 or 12,5, without a unit.>"));
    QVERIFY2(bag.startsWith("<There is no bag neck in context 0012 yet"), qPrintable(bag));
    QVERIFY2(number.startsWith("<The number ARM1-T3-0012-0001 belongs to another sherd.>"),
             qPrintable(number));
  }
};

QTEST_MAIN(DetailsTest)
#include "details_test.moc"
