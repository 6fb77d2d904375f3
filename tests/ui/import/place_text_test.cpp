#include "ui/import/place_text.h"

#include <QtTest>

#include "../project_in.h"
#include "catalogue/places.h"
#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;

class PlaceTextTest : public QObject {
  Q_OBJECT

 private slots:
  void readsWhatPeopleTypeAndWhatLabelsSay_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("number") << "ARM1-T3-0012-4";
    QTest::newRow("as the window writes it") << "ARM1 / T3 / 0012 bag 4";
    QTest::newRow("spaces") << "  ARM1 T3 0012 4 ";
    QTest::newRow("code") << "OST1:B:ARM1-T3-0012-4:7F3K9Q2M";
  }
  void readsWhatPeopleTypeAndWhatLabelsSay() {
    QFETCH(QString, text);
    const auto place = readPlaceText(text);
    QVERIFY(place.has_value());
    QCOMPARE(*place, (PlaceText{"ARM1", "T3", "0012", "4"}));
    QCOMPARE(place->words(), QStringLiteral("ARM1 / T3 / 0012 bag 4"));
  }

  void aSiteWithoutTrenchesHasThreeParts() {
    QCOMPARE(*readPlaceText("ARM1-0012-4"), (PlaceText{"ARM1", "", "0012", "4"}));
  }

  void refusesWhatIsNoPlace_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("nothing") << "";
    QTest::newRow("one word") << "ARM1";
    QTest::newRow("a sherd's code") << "OST1:S:ARM1-T3-0012-0007:7F3K9Q2M";
    QTest::newRow("too much") << "a-b-c-d-e";
    QTest::newRow("one part is missing") << "VIRT-T1--3";
  }
  void refusesWhatIsNoPlace() {
    QFETCH(QString, text);
    QVERIFY(!readPlaceText(text).has_value());
  }

  void aNewBagOfASiteWithAMarkInItsCode() {
    QTemporaryDir folder;
    const auto project = projectIn(folder.filePath("p").toStdString());
    records::SiteRecord site;
    site.code = "AR-TS";
    QVERIFY(catalogue::Places(project->catalogue()).save(site, {}).has_value());
    const auto read = [&](const char* text) {
      return findPlaceText(project->catalogue(), QString::fromLatin1(text));
    };
    QCOMPARE(read("ar-ts-T3-0012-4"), std::optional(PlaceText{"AR-TS", "T3", "0012", "4"}));
    QCOMPARE(read("AR-TS / 0012 bag 4"), std::optional(PlaceText{"AR-TS", "", "0012", "4"}));
    QCOMPARE(read("OST1:B:AR-TS-T3-0012-4:7F3K9Q2M"),
             std::optional(PlaceText{"AR-TS", "T3", "0012", "4"}));
    QCOMPARE(read("ARM1-T3-0012-4"), std::optional(PlaceText{"ARM1", "T3", "0012", "4"}));
    QVERIFY(!read("hello new world"));  // a sentence, not a new site
    QCOMPARE(read("Tell5-T3-0012-4"), std::optional(PlaceText{"Tell5", "T3", "0012", "4"}));
    QVERIFY(bagRowOf(project->catalogue(), {"ARM2", "", "12", "a-4"}, {}).has_value());
    QCOMPARE(read("ARM2-12-a-4"), std::optional(PlaceText{"ARM2", "", "12", "a-4"}));
    QCOMPARE(read("AR-TS-4"), std::optional(PlaceText{"AR", "", "TS", "4"}));
    QVERIFY(bagRowOf(project->catalogue(), {"ARM2", "S1", "K 12", "1"}, {}).has_value());
    for (const char* text : {"ARM2-S1-K 12-2", "arm2-k12-2", "K12-2"})
      QCOMPARE(read(text)->words(), QStringLiteral("ARM2 / S1 / K 12 bag 2"));
  }

  void whatIsNewIsSaidBeforeItIsMade() {
    QTemporaryDir folder;
    const auto project = projectIn(folder.filePath("p").toStdString());
    catalogue::Catalogue& rows = project->catalogue();
    QVERIFY(bagRowOf(rows, {"ARM1", "T3", "0012", "4"}, {}).has_value());
    QCOMPARE(newOf(rows, {"arm1", "T3", "0012", "4"}), QString());
    QCOMPARE(newOf(rows, {}), QString());
    QCOMPARE(siteOf(rows), QStringLiteral("ARM1"));
    QCOMPARE(newOf(rows, {"ARM1", "T3", "0012", "5"}), QStringLiteral("bag 5"));
    QCOMPARE(newOf(rows, {"ARM1", "", "0012", "4"}), QStringLiteral("context 0012, bag 4"));
    QCOMPARE(newOf(rows, {"ARM1", "T3", "12", "4"}),
             QStringLiteral("context 12, although 0012 exists, bag 4"));
    QCOMPARE(newOf(rows, {"ARM1", "T9", "1", "5"}), QStringLiteral("trench T9, context 1, bag 5"));
    QCOMPARE(newOf(rows, {"XX", "9", "foo", "77"}),
             QStringLiteral("site XX, trench 9, context foo, bag 77"));
    QCOMPARE(catalogue::Places(rows).sites()->size(), std::size_t{1});
  }

  void theSamePlaceIsMadeOnce() {
    QTemporaryDir folder;
    const auto project = projectIn(folder.filePath("p").toStdString());
    catalogue::Catalogue& rows = project->catalogue();
    const PlaceText place{"ARM1", "T3", "0012", "4"};
    const auto first = bagRowOf(rows, place, {});
    QVERIFY2(first.has_value(), first ? "" : first.error().sentence().english().c_str());
    QVERIFY(*first > 0);
    QCOMPARE(*bagRowOf(rows, place, {}), *first);
    const auto other = bagRowOf(rows, {"ARM1", "T3", "0012", "5"}, {});
    QVERIFY(*other != *first);
    QCOMPARE(catalogue::Places(rows).sites()->size(), std::size_t{1});
    QCOMPARE(catalogue::Places(rows).contexts()->size(), std::size_t{1});
    QCOMPARE(*bagRowOf(rows, {}, {}), std::int64_t{0});
    QCOMPARE(*bagRowOf(rows, {"arm1", "t3", "0012", "4"}, {}), *first);
  }
};

OSTRAKA_UI_TEST(PlaceTextTest)
#include "place_text_test.moc"
