// The filter knows the fields by the names that the window shows.
#include "ui/catalogue/field_words.h"

#include <QCoreApplication>
#include <QTranslator>
#include <QtTest>

using namespace ostraka::ui;

namespace {

class German final : public QTranslator {
 public:
  QString translate(const char* context, const char* source, const char*, int) const override {
    if (qstrcmp(context, "Fields") != 0) return {};
    static const QHash<QString, QString> kWords{{"thickness, mm", "Dicke, mm"},
                                                {"context", "Befund"},
                                                {"thickness least, mm", "Dicke, kleinste, mm"},
                                                {"date", "Datum"},
                                                {"ware", "Ware"}};
    return kWords.value(QString::fromUtf8(source));
  }
  bool isEmpty() const override { return false; }
};

}  // namespace

class FieldWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void fieldsAreFoundByTheNamesThatTheWindowShows() {
    German german;
    QVERIFY(QCoreApplication::installTranslator(&german));
    QCOMPARE(withFieldNames("Befund:0100 -dicke>5 rot"), QString("context:0100 -thickness>5 rot"));
    QCOMPARE(withFieldNames("Datum:*"), QString("date_edtf:*"));
    QCOMPARE(withFieldNames("\"Befund:0100\" note:\"Dicke>5\""),
             QString("\"Befund:0100\" note:\"Dicke>5\""));
    QCOMPARE(withFieldNames("thickness>5 context:0100 Dicke"),
             QString("thickness>5 context:0100 Dicke"));
    QCoreApplication::removeTranslator(&german);
    QCOMPARE(withFieldNames("thickness>5 -ware:grey"), QString("thickness>5 -ware:grey"));
  }
};

QTEST_GUILESS_MAIN(FieldWordsTest)
#include "field_words_test.moc"
