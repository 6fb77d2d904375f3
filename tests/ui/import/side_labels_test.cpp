#include "ui/import/side_labels.h"

#include <QtTest>

#include "tests/ui/program.h"

using namespace ostraka;
using namespace ostraka::ui;

namespace {

const char* const kBag4 = "OST1:B:ARM1-T3-0012-4:7F3K9Q2M";
const char* const kBag5 = "OST1:B:ARM1-T3-0012-5:8G4L0R3N";

// Two photographs a side, with these codes in the second.
SideLabels with(const std::vector<std::string>& front, const std::vector<std::string>& back) {
  ImportSides sides;
  sides.front = {"a/1.jpg", "a/2.jpg"};
  sides.back = {"b/1.jpg", "b/2.jpg"};
  return labelsOf({{"a/1.jpg", {}}, {"a/2.jpg", front}, {"b/1.jpg", {}}, {"b/2.jpg", back}}, sides,
                  readPlaceText);
}

PlaceText bag(const char* number) {
  return {"ARM1", "T3", "0012", number};
}

}  // namespace

class SideLabelsTest : public QObject {
  Q_OBJECT

 private slots:
  void oneBagOnEitherSideIsTheBag() {
    for (const SideLabels& labels :
         {with({kBag4}, {}), with({}, {kBag4}), with({kBag4}, {kBag4, "a visiting card"})}) {
      QCOMPARE(labels.bag(), std::optional(bag("4")));
      QCOMPARE(labels.doubt({}), QString());
      QCOMPARE(labels.doubt(bag("4")), QString());
      QVERIFY(labels.doubt(bag("7")).contains("names ARM1 / T3 / 0012 bag 4"));
    }
  }

  void withoutALabelNothingIsSaid() {
    const SideLabels labels = with({"a visiting card"}, {});
    QVERIFY(!labels.bag());
    QCOMPARE(labels.doubt(bag("7")), QString());
  }

  void ofSeveralBagsNoneIsTaken() {
    const SideLabels labels = with({kBag4, kBag5}, {kBag4});
    QVERIFY(!labels.bag());
    QVERIFY(labels.doubt({}).contains("several bags"));
    QVERIFY(labels.doubt({}).contains("ARM1 / T3 / 0012 bag 4, ARM1 / T3 / 0012 bag 5"));
  }

  void otherBagsOnTheBacksAreTold() {
    const SideLabels labels = with({kBag4}, {kBag5});
    QVERIFY(!labels.bag());
    QVERIFY(labels.doubt(bag("4")).contains("fronts names ARM1 / T3 / 0012 bag 4"));
    QVERIFY(labels.doubt(bag("4")).contains("backs ARM1 / T3 / 0012 bag 5"));
  }

  void placesDifferWhereBothNameOneAndNotTheSame() {
    QVERIFY(bag("4").differsFrom(bag("5")));
    QVERIFY(!bag("4").differsFrom({"arm1", "t3", "0012", "4"}));
    QVERIFY(!bag("4").differsFrom({"ARM1", {}, "0012", {}}));
    QVERIFY(!bag("4").differsFrom({}));
  }
};

OSTRAKA_UI_TEST(SideLabelsTest)
#include "side_labels_test.moc"
