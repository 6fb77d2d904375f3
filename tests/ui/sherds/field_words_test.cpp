// The filter knows the fields by the names that the window shows.
#include "ui/sherds/field_words.h"
#include "records/sherd.h"
#include "sherds/sherd_fields.h"
#include "tables/column_meanings.h"
#include "ui/frame/term_words.h"

#include <QCoreApplication>
#include <QTranslator>
#include <QtTest>

#include "tests/ui/program.h"

using namespace ostraka::ui;

namespace {

class German final : public QTranslator {
 public:
  QString translate(const char* context, const char* source, const char*, int) const override {
    if (qstrcmp(context, "Fields") != 0) return {};
    static const QHash<QString, QString> kWords{{"thickness, mm", "Dicke, mm"},
                                                {"context", "Befund"},
                                                {"minimum thickness, mm", "Dicke, kleinste, mm"},
                                                {"date", "Datum"},
                                                {"entered", "erfasst"},
                                                {"ware", "Ware"}};
    return kWords.value(QString::fromUtf8(source));
  }
  bool isEmpty() const override { return false; }
};

}  // namespace

class FieldWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void aMeasurementIsToldWithItsUncertainty() {
    ostraka::records::Measurement measured;
    measured.unit = "mm";
    measured.value = 53.929898797564384;
    QCOMPARE(measuredText(measured), QStringLiteral("53.9"));
    measured.uncertainty = 0.4;
    QCOMPARE(measuredText(measured), QStringLiteral("53.9 ± 0.4"));
    measured.value = 78;  // with its zero, as beside it
    measured.uncertainty = 0.02;
    QCOMPARE(measuredText(measured), QStringLiteral("78.0 ± 0.1"));
  }

  void fieldsAreFoundByTheNamesThatTheWindowShows() {
    German german;
    QVERIFY(QCoreApplication::installTranslator(&german));
    QCOMPARE(withFieldNames("Befund:0100 -dicke>5 rot"), QString("context:0100 -thickness>5 rot"));
    QCOMPARE(withFieldNames("Datum:*"), QString("date_edtf:*"));
    // And by those that tables may have.
    QCOMPARE(withFieldNames("Kontext:0100 -Wandstärke>5 Fundort:A"),
             QString("context:0100 -thickness_mean_mm>5 site:A"));
    QCOMPARE(withFieldNames("erfasst>=2026-07"), QString("entered>=2026-07"));
    QCOMPARE(withFieldNames("\"Befund:0100\" note:\"Dicke>5\""),
             QString("\"Befund:0100\" note:\"Dicke>5\""));
    QCOMPARE(withFieldNames("thickness>5 context:0100 Dicke"),
             QString("thickness>5 context:0100 Dicke"));
    const auto chips = [](const char* line) {
      QStringList shown;
      const auto filter = ostraka::sherds::parseFilter(line);
      if (!filter) return QString::fromStdString(filter.error().what.english());
      for (const auto& condition : filter->conditions) shown << conditionText(condition);
      return shown.join('|');
    };
    QCOMPARE(chips("context:0005 -thickness>6 red \"context:1\" fabric:x"),
             QString("Befund:0005|-Dicke>6|red|\"context:1\"|fabric:x"));
    QCoreApplication::removeTranslator(&german);
    QCOMPARE(chips("context:0005 -thickness>6"), QString("context:0005|-thickness>6"));
    QCOMPARE(withFieldNames("thickness>5 -ware:grey"), QString("thickness>5 -ware:grey"));
  }

  void allMeasuresOfOneUnitHaveTheSameDecimals() {
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(measureText(120, "mm"), QString("120,0"));
    QCOMPARE(measureText(49.4712, "mm"), QString("49,5"));
    QCOMPARE(measureText(1205.4321, "mm2"), QLocale().toString(1205));
    QLocale::setDefault(QLocale::c());
    ostraka::records::SherdRecord sherd;
    const TermWords words;
    sherd.measures["thickness_mean"] = 6.25;
    QCOMPARE(fieldText(sherd, "thickness_mean_mm", words), QString("6.3"));
    sherd.replaced["thickness_mean"] = 6.1803398875;
    QCOMPARE(fieldText(sherd, "thickness_mean_mm", words), QString("6.3 (computed 6.2)"));
  }

  void eachColumnOfASpreadsheetHasAWordOfItsOwn() {
    QSet<QString> words;
    for (const ostraka::tables::ColumnMeaning& one : ostraka::tables::columnMeanings()) {
      const QString word = fieldLabel(one.column);
      QVERIFY2(!word.contains('_'), one.column);
      QVERIFY2(!words.contains(word), one.column);
      words.insert(word);
    }
    QCOMPARE(fieldLabel("extra.shelf"), QString("shelf"));
    QCOMPARE(measureLabel("extra.shelf"), QString("shelf"));
    QCOMPARE(measureLabel("length"), QString("length, mm"));
  }

  void aNumberIsTypedAsTheLanguageWritesIt() {
    const auto typed = [](const char* field, const char* text) {
      for (const ostraka::records::SherdField& known : ostraka::sherds::sherdFields())
        if (std::string(known.name) == field) return typedText(known, text);
      return QString();
    };
    QLocale::setDefault(QLocale("fr_FR"));
    QCOMPARE(typed("length_mm", "79.84123456"), QString("79,8"));
    QCOMPARE(typed("area_mm2", "15201.5"), QString("15201,5"));
    QCOMPARE(typed("weight_g", "12"), QString("12,0"));
    QCOMPARE(typed("note", "79.84"), QString("79.84"));
    QLocale::setDefault(QLocale::c());
    QCOMPARE(typed("length_mm", "79.84"), QString("79.84"));
  }
};

OSTRAKA_UI_TEST(FieldWordsTest)
#include "field_words_test.moc"
