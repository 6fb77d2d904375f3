// Labels carry the catalogue's numbers; what has none yet keeps the batch's own.
#include "ui/map/catalogue_labels.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryDir>
#include <QTest>

#include "../project_in.h"
#include "capture/label_code.h"
#include "catalogue/batches.h"
#include "catalogue/places.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/filter.h"
#include "sherds/numbers.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/import/place_text.h"

namespace ostraka::ui {

class CatalogueLabelsTest : public QObject {
  Q_OBJECT

 private slots:
  void aNumberedSherdHasItsNumberAndAnotherTheBatchs();
  void aBagsLabelIsReadBackAsItsPlace();
  void sherdsOfNoMapGetTheirLabelsOnceTheyHaveANumber();
  void aBagsLabelIsReadBackWhateverItsCodesLookLike_data();
  void aBagsLabelIsReadBackWhateverItsCodesLookLike();
  void aBagsLabelSaysHowManySherdsAndWhoBaggedThem();
  void theMapShowsTheEndsOfNumbersThatTellThemApart();
  void aPrintedLabelIsReadByTheCameraAndKeepsItsMargins();
};

// With OSTRAKA_SCREENSHOTS set to a folder the labels are left there for a person to look at.
void CatalogueLabelsTest::aPrintedLabelIsReadByTheCameraAndKeepsItsMargins() {
  constexpr double kPerMm = 300 / 25.4;
  const SherdLabel labels[] = {
      {"ARM1-T3-0012-0007", "ARM1 / T3 / 0012", "2026-07-14", "OST1:S:ARM1-T3-0012-0007:7F3K9Q2M"},
      {"ARM1-T3-0012-4", "ARM1 / T3 / 0012, bag 4", "2026-07-14", "OST1:B:ARM1-T3-0012-4:7F3K9Q2M",
       "8 of 12 sherds, AP"},
      {"ARAGATS/TSAGHKAHOVIT.WEST-SLOPE.HILL.02.C-000012345", "Ար / T3 / 0012", "2026-07-14",
       "OST1:S:ARAGATS/TSAGHKAHOVIT.WEST-SLOPE.HILL.02.C-000012345:7F3K9Q2M"}};
  for (const SherdLabel& label : labels) {
    QImage paper(qRound(85 * kPerMm), qRound(32 * kPerMm), QImage::Format_RGB32);
    paper.fill(Qt::white);
    QPainter painter(&paper);
    paintLabel(painter, QRectF(paper.rect()), label, kPerMm);
    painter.end();
    QBuffer png;
    QVERIFY(png.open(QIODevice::WriteOnly) && paper.save(&png, "PNG"));
    const QByteArray& bytes = png.data();
    const auto codes =
        capture::codesIn({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    QVERIFY(codes.has_value());
    QCOMPARE(codes->size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(codes->front()), label.code);
    // Nothing runs into the margin of 2 mm at the right; the dotted line at the edge is for
    // scissors.
    for (int y = 10; y < paper.height() - 10; ++y)
      for (int x = paper.width() - qRound(1.8 * kPerMm); x < paper.width() - 10; ++x)
        QVERIFY(qGray(paper.pixel(x, y)) > 250);
    if (const QString folder = qEnvironmentVariable("OSTRAKA_SCREENSHOTS"); !folder.isEmpty())
      QVERIFY(paper.save(folder + "/label-" + QString::number(&label - labels) + ".png"));
  }
}

void CatalogueLabelsTest::theMapShowsTheEndsOfNumbersThatTellThemApart() {
  review::PlateMap map;
  map.front.marks.resize(4);
  for (const int i : {0, 1, 2}) map.front.marks[i].number = "0" + std::to_string(i + 1);
  const auto numbers = [&](const QStringList& list) {
    QVector<PlateSherd> sherds = sherdsOnPlate(map, nullptr, QStringLiteral("B0001"), {});
    for (qsizetype i = 0; i < sherds.size(); ++i) {
      sherds[i].has_final_number = !list[i].startsWith("B0001");
      sherds[i].label.number = list[i];
    }
    return mapNumbers(sherds);
  };
  const MapNumbers one = numbers({"ARM1-T3-0012-0007", "ARM1-T3-0012-0010", "ARM1-T3-0012-0011"});
  QCOMPARE(one.common, QStringLiteral("ARM1-T3-0012-"));
  QCOMPARE(one.shown("01"), QStringLiteral("0007"));
  QCOMPARE(one.shown("03"), QStringLiteral("0011"));
  const MapNumbers part = numbers({"ARM1-T3-0012-0007", "B0001-02", "ARM1-T4-0012-0007"});
  QCOMPARE(part.common, QStringLiteral("ARM1-"));
  QCOMPARE(part.shown("03"), QStringLiteral("T4-0012-0007"));
  QCOMPARE(part.shown("02"), QStringLiteral("(2)"));
  QCOMPARE(part.whole("03"), QStringLiteral("ARM1-T4-0012-0007"));
  QCOMPARE(part.whole("02"), QStringLiteral("(2)"));
  // Typed numbers of another form do not make those of all the others long; of one of another
  // context nobody would tell the short ones.
  map.front.marks[3].number = "04";
  const MapNumbers most =
      numbers({"VIRT-T1-0001-0033", "VIRT-T1-0001-0045", "12,5", "VIRT-T1-2-7"});
  QCOMPARE(most.common, QStringLiteral("VIRT-T1-"));
  QCOMPARE(most.shown("02"), QStringLiteral("0001-0045"));
  QCOMPARE(most.whole("02"), QStringLiteral("VIRT-T1-0001-0045"));
  QCOMPARE(most.shown("03"), QStringLiteral("12,5"));
  QCOMPARE(most.whole("03"), QStringLiteral("12,5"));
  QCOMPARE(most.shown("04"), QStringLiteral("2-7"));
  const MapNumbers clear = numbers({"ARM1-0007", "0007", "ARM1-0008", "ARM1-0009"});
  QCOMPARE(clear.common, QString());  // two would be 0007
  map.front.marks[3].number.clear();
  QVector<PlateSherd> again = sherdsOnPlate(map, nullptr, QStringLiteral("B0001"), {});
  again[1].again = QStringLiteral("ARM1-0001 in B0006");
  QCOMPARE(wordsOf(map.front.marks[1], mapNumbers(again)),
           QStringLiteral("now ARM1-0001 in B0006"));
  QCOMPARE(labelsOf(again).size(), 2);
  const MapNumbers none = numbers({"B0001-01", "B0001-02", "B0001-03"});
  QCOMPARE(none.common, QString());
  QCOMPARE(none.shown("02"), QStringLiteral("2"));
}

void CatalogueLabelsTest::aBagsLabelIsReadBackAsItsPlace() {
  QTemporaryDir folder;
  const auto project = projectIn(folder.filePath("project").toStdString(), "ARM");
  catalogue::Catalogue& rows = project->catalogue();
  QVERIFY(bagLabels(rows, {}).isEmpty());
  const PlaceText second{"ARM1", "T3", "0012", "4"}, first{"ARM1", {}, "0007", "12"};
  for (const PlaceText& place : {second, first}) QVERIFY(bagRowOf(rows, place, {}).has_value());
  const QVector<SherdLabel> labels = bagLabels(rows, {});
  QCOMPARE(labels.size(), 2);
  QCOMPARE(labels[0].number, QStringLiteral("ARM1-0007-12"));
  QCOMPARE(labels[1].context, QStringLiteral("ARM1 / T3 / 0012, bag 4"));
  QVERIFY(labels[1].code.startsWith("OST1:B:ARM1-T3-0012-4:"));
  QCOMPARE(*readPlaceText(labels[0].code), first);
  QCOMPARE(*readPlaceText(labels[1].code), second);
  QPdfWriter pdf(folder.filePath("bags.pdf"));
  QString why;
  QVERIFY2(printLabels(pdf, labels, &why), qPrintable(why));
  QVERIFY(QFileInfo(folder.filePath("bags.pdf")).size() > 1000);
}

void CatalogueLabelsTest::sherdsOfNoMapGetTheirLabelsOnceTheyHaveANumber() {
  QTemporaryDir folder;
  const auto project = projectIn(folder.filePath("project").toStdString(), "ARM");
  catalogue::Catalogue& rows = project->catalogue();
  QVERIFY(bagRowOf(rows, {"ARM1", "T3", "0012", "4"}, {}).has_value());
  const records::BagRecord bag = catalogue::Places(rows).bags()->front();
  std::vector<store::SherdRow> sherds;
  for (int i = 0; i < 3; ++i) {
    records::SherdRecord sherd;
    sherd.context = bag.context;
    sherd.bag = bag.row;
    sherds.push_back(*sherds::Sherds(rows).add(sherd, {}));
  }
  QVERIFY(sherds::Numbers(rows).assign(std::span(sherds).first(2), {}).has_value());
  QVERIFY(sherds::Sherds(rows).voidSherd(sherds[1], "a stone", {}).has_value());
  const QVector<SherdLabel> labels = sherdLabels(rows, sherds);
  QCOMPARE(labels.size(), 1);
  QCOMPARE(labels[0].number, QStringLiteral("ARM1-T3-0012-0001"));
  QCOMPARE(labels[0].context, QStringLiteral("ARM1 / T3 / 0012, bag 4"));
  QVERIFY(labels[0].code.startsWith("OST1:S:ARM1-T3-0012-0001:"));
}

void CatalogueLabelsTest::aBagsLabelIsReadBackWhateverItsCodesLookLike_data() {
  QTest::addColumn<QStringList>("codes");
  QTest::newRow("small letters") << QStringList{"Hayk1", "T3", "0012", "4"};
  QTest::newRow("a site with a mark") << QStringList{"AR-TS", "T3", "0012", "4"};
  QTest::newRow("without a trench") << QStringList{"AR-TS", "", "0012", "4"};
  QTest::newRow("marks everywhere") << QStringList{"AR/TS", "T 3", "2026-12", "4-b"};
  QTest::newRow("letters of its own") << QStringList{QString::fromUtf8("Ստ1"), "T3", "0012", "4"};
}

void CatalogueLabelsTest::aBagsLabelIsReadBackWhateverItsCodesLookLike() {
  QFETCH(QStringList, codes);
  const PlaceText place{codes[0], codes[1], codes[2], codes[3]};
  QTemporaryDir folder;
  const auto project = projectIn(folder.filePath("project").toStdString(), "ARM");
  catalogue::Catalogue& rows = project->catalogue();
  const auto row = bagRowOf(rows, place, {});
  QVERIFY(row.has_value());
  // Such as the first parts of its name.
  QVERIFY(bagRowOf(rows, {"AR", "TS", "T3", "0012"}, {}).has_value());
  QString code;
  for (const SherdLabel& label : bagLabels(rows, {}))
    if (label.number == place.typed()) code = label.code;
  const auto read = findPlaceText(rows, code);
  QVERIFY(read.has_value());
  QCOMPARE(*read, place);
  QCOMPARE(*bagRowOf(rows, *read, {}), *row);
  // As the field shows it, and as a person types it.
  QCOMPARE(findPlaceText(rows, place.typed()), std::optional(place));
  QCOMPARE(*bagRowOf(rows, *findPlaceText(rows, place.typed().toLower()), {}), *row);
  QCOMPARE(catalogue::Places(rows).bags()->size(), std::size_t{2});
}

void CatalogueLabelsTest::aBagsLabelSaysHowManySherdsAndWhoBaggedThem() {
  QTemporaryDir folder;
  const auto project = projectIn(folder.filePath("project").toStdString(), "ARM");
  catalogue::Catalogue& rows = project->catalogue();
  const auto anna =
      catalogue::People(rows).save(records::PersonRecord{{}, {}, "Anna P.", "AP", {}}, {});
  const auto row = bagRowOf(rows, {"ARM1", "T3", "0012", "4"}, {*anna, "window", {}});
  QVERIFY(row.has_value());
  QVERIFY(bagRowOf(rows, {"ARM1", "T3", "0012", "5"}, {}).has_value());
  const auto contents = [&](const QString& prints) {
    return bagLabels(rows, prints)[0].contents + " | " + bagLabels(rows, prints)[1].contents;
  };
  QCOMPARE(contents({}), QStringLiteral("AP | "));
  QCOMPARE(contents("BK"), QStringLiteral("AP | BK"));
  records::BagRecord bag = catalogue::Places(rows).bags()->front();
  bag.count_written = 3;
  QVERIFY(catalogue::Places(rows).save(bag, {}).has_value());
  QCOMPARE(contents({}), QStringLiteral("3 sherd(s), AP | "));
  std::vector<store::SherdRow> sherds;
  for (int i = 0; i < 4; ++i) {
    records::SherdRecord sherd;
    sherd.context = bag.context;
    sherd.bag = bag.row;
    const auto added = sherds::Sherds(rows).add(sherd, {});
    QVERIFY(added.has_value());
    sherds.push_back(*added);
  }
  QCOMPARE(contents({}), QStringLiteral("4 of 3 sherd(s), AP | "));
  QVERIFY(sherds::Sherds(rows).voidSherd(sherds.back(), "a stone", {}).has_value());
  QCOMPARE(contents({}), QStringLiteral("3 sherd(s), AP | "));
}

void CatalogueLabelsTest::aNumberedSherdHasItsNumberAndAnotherTheBatchs() {
  QTemporaryDir folder;
  const auto project = projectIn(folder.filePath("project").toStdString(), "ARM");
  catalogue::Catalogue& rows = project->catalogue();
  records::BatchRecord batch;
  batch.number = "B0001";
  const auto batch_row = catalogue::Batches(rows).add(batch, {});
  QVERIFY(batch_row.has_value());
  records::ScanRecord scan;
  scan.batch = *batch_row;
  scan.index = 3;  // as it was numbered before; the map has newer results
  scan.name = "f003";
  scan.path = "results/B0001/scans/f003.ply";
  scan.plate_x_mm = 30;
  scan.plate_y_mm = 10;
  const auto scan_row = catalogue::Batches(rows).save(scan, {});
  QVERIFY2(scan_row.has_value(), scan_row ? "" : scan_row.error().sentence().english().c_str());
  records::SherdRecord sherd;
  sherd.batch = *batch_row;
  sherd.front = *scan_row;
  records::SiteRecord site;
  site.code = "ARM1";
  site.name = "Trial";
  const auto site_row = catalogue::Places(rows).save(site, {});
  QVERIFY2(site_row.has_value(), site_row ? "" : site_row.error().sentence().english().c_str());
  records::ContextRecord context;
  context.site = *site_row;
  context.number = "0012";
  const auto context_row = catalogue::Places(rows).save(context, {});
  QVERIFY2(context_row.has_value(),
           context_row ? "" : context_row.error().sentence().english().c_str());
  sherd.context = *context_row;
  sherd.number = "ARM1-T3-0012-0007";
  const auto sherd_row = sherds::Sherds(rows).add(sherd, {});
  QVERIFY2(sherd_row.has_value(), sherd_row ? "" : sherd_row.error().sentence().english().c_str());

  review::PlateMap map;
  map.front.marks.resize(3);
  map.front.marks[0].number = "01";
  map.front.marks[0].place_mm = {-50, 0};
  map.front.marks[1].place_mm = {-10, -30};
  map.front.marks[2].place_mm = {31, 12};
  map.front.marks[2].number = "02";  // the one between is set aside
  const QString day = QStringLiteral("2026-07-14");
  const QVector<SherdLabel> plain = labelsOf(sherdsOnPlate(map, nullptr, "B0001", day));
  QCOMPARE(plain[0].code, QStringLiteral("OST1:S:B0001-01"));
  const QVector<SherdLabel> labels = labelsOf(sherdsOnPlate(map, &rows, "B0001", day));
  QCOMPARE(labels.size(), 2);
  QCOMPARE(labels[0].number, QStringLiteral("sherd 1 of B0001"));
  QCOMPARE(labels[1].number, QStringLiteral("ARM1-T3-0012-0007"));
  const QString id =
      QString::fromStdString(sherds::Sherds(rows).get(*sherd_row)->id).remove('-').toUpper();
  QCOMPARE(labels[1].code, "OST1:S:ARM1-T3-0012-0007:" + id.right(8));
  QCOMPARE(labels[1].context, QStringLiteral("ARM1 / 0012"));
  const auto leadsTo = [&](const QString& code) {
    const auto filter = sherds::parseFilter(code.toStdString());
    return filter ? *sherds::Sherds(rows).rows(*filter, {}) : std::vector<store::SherdRow>();
  };
  QCOMPARE(leadsTo(labels[1].code), std::vector<store::SherdRow>{*sherd_row});
  // A draft's label, and what it leads to after the sherd has its number.
  records::SherdRecord draft;
  draft.batch = *batch_row;
  draft.context = *context_row;
  scan.index = 1;
  scan.name = "f001";
  scan.plate_x_mm = -51;
  scan.plate_y_mm = 0;
  draft.front = *catalogue::Batches(rows).save(scan, {});
  const auto draft_row = sherds::Sherds(rows).add(draft, {});
  QVERIFY(draft_row.has_value());
  const SherdLabel before = labelsOf(sherdsOnPlate(map, &rows, "B0001", day))[0];
  QCOMPARE(before.number, QStringLiteral("sherd 1 of B0001"));
  QCOMPARE(leadsTo(before.code), std::vector<store::SherdRow>{*draft_row});
  const records::FieldChange number{*draft_row, "number", "ARM1-8"};
  QVERIFY(sherds::SherdChanges(rows).apply(std::span(&number, 1), {}).has_value());
  QCOMPARE(leadsTo(before.code), std::vector<store::SherdRow>{*draft_row});
  QCOMPARE(leadsTo(plain[0].code), std::vector<store::SherdRow>{*draft_row});
  QCOMPARE(labels[1].date, QStringLiteral("2026-07-14"));
  QCOMPARE(labelsOf(sherdsOnPlate(map, &rows, "B0009", day))[1].number,
           QStringLiteral("sherd 2 of B0009"));

  // A piece that is to be photographed again keeps its number and its label; what is void has none.
  map.front.marks[0].state = map.front.marks[2].state = review::CardState::Reshoot;
  QCOMPARE(labelsOf(sherdsOnPlate(map, &rows, "B0001", day)).size(), 2);
  QCOMPARE(labelsOf(sherdsOnPlate(map, nullptr, "B0001", day)).size(), 0);  // stones, perhaps
  map.front.marks[2].state = review::CardState::Sure;
  QVERIFY(mapNumbers(sherdsOnPlate(map, &rows, "B0001", day)).voided.isEmpty());
  QVERIFY(sherds::Sherds(rows).voidSherd(*sherd_row, "a brick", {}).has_value());
  const QVector<SherdLabel> left = labelsOf(sherdsOnPlate(map, &rows, "B0001", day));
  QCOMPARE(left.size(), 1);
  QCOMPARE(left[0].number, QStringLiteral("ARM1-8"));
  const MapNumbers shown = mapNumbers(sherdsOnPlate(map, &rows, "B0001", day));
  QCOMPARE(shown.voided, QSet<QString>{"02"});
  QCOMPARE(wordsOf(map.front.marks[2], shown), QStringLiteral("T3-0012-0007, void"));
  QCOMPARE(wordsOf(map.front.marks[0], shown), QStringLiteral("8, shoot again"));
}

OSTRAKA_UI_TEST(CatalogueLabelsTest)

}  // namespace ostraka::ui

#include "catalogue_labels_test.moc"
