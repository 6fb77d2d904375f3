#include <QBuffer>
#include <QDir>
#include <QImage>
#include <QSignalSpy>
#include <QTranslator>

#include "../project_in.h"
#include "batch/batch.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/places.h"
#include "files/files.h"
#include "files/hold.h"
#include "intake/side_photographs.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/import/batch_importer.h"
#include "virtualrig/batch_files.h"

using namespace ostraka;
using namespace ostraka::ui;

class ImportTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    session_ = std::make_unique<ProjectSession>(projectIn(path("project")), path("project"), jobs_);
  }

  void scansBecomeABatchInTheQueueAndTheOriginalsStay() {
    for (const char* file : {"front/a.ply", "front/b.ply", "back/c.ply", "truth/pairs.json"})
      QVERIFY(writeFileAtomically(path("scans") / file, file).has_value());
    BatchImporter importer;
    importer.setSession(session_.get());
    QSignalSpy imported(&importer, &BatchImporter::imported);
    importer.start(shown("scans"), ImportKind::Scans, {"ARM1", "T3", "0012", "4"});
    QTRY_COMPARE(imported.count(), 1);
    const auto batches = catalogue::Batches(session_->project().catalogue()).all();
    QCOMPARE(batches->size(), std::size_t{1});
    const records::BatchRecord& batch = batches->front();
    QCOMPARE(batch.state, records::BatchState::Queued);
    QCOMPARE(batch.bags.size(), std::size_t{1});
    QVERIFY(!batch.started_ms);  // nobody knows when it was scanned
    const auto copy = session_->project().batchFolder(batch.number);
    QCOMPARE(*readFile(copy / "back" / "c.ply"), std::string("back/c.ply"));
    QVERIFY(!std::filesystem::exists(copy / "truth"));
    QVERIFY(std::filesystem::exists(path("scans") / "front" / "a.ply"));
    QVERIFY(!std::filesystem::exists(path("project") / "batches" / "import.partial"));
  }

  void whatWasImportedBeforeIsToldAndComesOnlyWhenItIsWanted() {
    for (const char* file : {"front/a.ply", "front/b.ply", "back/c.ply"})
      QVERIFY(writeFileAtomically(path("scans") / file, file).has_value());
    for (const char* file : {"front/a.ply", "front/b.ply", "back/c.ply"})
      QVERIFY(writeFileAtomically(path("others") / file, std::string("x") + file).has_value());
    for (const char* file : {"front/x.ply", "front/y.ply", "back/z.ply"})  // by other names
      QVERIFY(writeFileAtomically(path("copy") / file,
                                  std::string(file).substr(0, file[0] == 'f' ? 6 : 5) +
                                      char(file[file[0] == 'f' ? 6 : 5] - 23) + ".ply")
                  .has_value());
    BatchImporter importer;
    importer.setSession(session_.get());
    QSignalSpy imported(&importer, &BatchImporter::imported);
    QSignalSpy there(&importer, &BatchImporter::alreadyThere);
    const auto take = [&](const char* name) {
      importer.start(QString::fromStdString(path(name).string()), ImportKind::Scans, {});
    };
    take("scans");
    QTRY_COMPARE(imported.count(), 1);
    take("others");
    QTRY_COMPARE(imported.count(), 2);
    take("copy");
    QTRY_COMPARE(there.count(), 1);
    QCOMPARE(there.front(),
             (QVariantList{"B0001", QString::fromStdString(path("copy").string()), 3, 3}));
    std::filesystem::copy(path("copy"), path("whole"), std::filesystem::copy_options::recursive);
    QVERIFY(writeFileAtomically(path("whole") / "back" / "more.ply", "one more").has_value());
    take("whole");
    QTRY_COMPARE(there.count(), 2);
    QCOMPARE(there[1].mid(2), (QVariantList{3, 4}));
    QVERIFY(writeFileAtomically(path("one") / "front" / "p.ply", "front/a.ply").has_value());
    for (const char* file : {"front/q.ply", "back/r.ply", "back/s.ply"})
      QVERIFY(writeFileAtomically(path("one") / file, std::string("new ") + file).has_value());
    take("one");
    QTRY_COMPARE(there.count(), 3);
    QCOMPARE(there[2].mid(2), (QVariantList{1, 4}));
    take("copy");
    QTRY_COMPARE(there.count(), 4);
    QCOMPARE(catalogue::Batches(session_->project().catalogue()).all()->size(), std::size_t{2});
    QVERIFY(!std::filesystem::exists(path("project") / "batches" / "import.partial"));
    importer.startAllTheSame();
    QTRY_COMPARE(imported.count(), 3);
    QCOMPARE(catalogue::Batches(session_->project().catalogue()).all()->size(), std::size_t{3});
    QCOMPARE(there.count(), 4);
    QVERIFY(intake::checkNotShared(
                session_->project().catalogue(), session_->folder(),
                *catalogue::Batches(session_->project().catalogue()).byNumber("B0003"), {})
                .has_value());
  }

  void aFolderWithoutBacksIsRefusedWithASentenceAndLeavesNothing() {
    QVERIFY(writeFileAtomically(path("half") / "front" / "a.ply", "x").has_value());
    BatchImporter importer;
    importer.setSession(session_.get());
    QSignalSpy imported(&importer, &BatchImporter::imported);
    std::string sentence;
    connect(&importer, &BatchImporter::failed, this,
            [&](const Error& error) { sentence = error.sentence().english(); });
    importer.start(QString::fromStdString(path("half").string()), ImportKind::Scans, {});
    QTRY_VERIFY(!sentence.empty());
    QVERIFY(sentence.find("back/") != std::string::npos);
    QCOMPARE(imported.count(), 0);
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
  }

  void whyAnImportIsRefusedIsSaidInThePersonsLanguage() {
    class Marked final : public QTranslator {
     public:
      QString translate(const char*, const char* text, const char*, int) const override {
        return QStringLiteral("<%1>").arg(QString::fromUtf8(text));
      }
      bool isEmpty() const override { return false; }
    } marked;
    QVERIFY(QCoreApplication::installTranslator(&marked));
    BatchImporter importer;
    importer.setSession(session_.get());
    QString why;
    connect(&importer, &BatchImporter::failed, this,
            [&](const Error& error) { why = QString::fromStdString(error.what.english()); });
    importer.start(QString::fromStdString(path("absent").string()), ImportKind::Scans, {});
    QTRY_VERIFY(!why.isEmpty());
    QVERIFY2(why.startsWith('<') && why.endsWith('>') && why.contains("front/"), qPrintable(why));
    writeScans();
    connect(&importer, &BatchImporter::ended, this, [this] {
      std::filesystem::remove_all(path("project") / "batches" / "import.partial");
    });
    why.clear();
    importer.start(QString::fromStdString(path("scans").string()), ImportKind::Scans, {});
    QTRY_VERIFY(!why.isEmpty());
    QVERIFY2(why.startsWith('<') && why.endsWith('>'), qPrintable(why));
  }

  void aFolderOfNoBatchKeepsItsNumberAndItsContent() {
    writeScans();
    const std::filesystem::path kept = session_->project().batchFolder("B0001") / "x";
    QVERIFY(writeFileAtomically(kept, "mine").has_value());
    QVERIFY(writeFileAtomically(session_->project().resultsFolder("B0002") / "x", "").has_value());
    QVERIFY(writeFileAtomically(path("project") / "models" / "B0003" / "x", "").has_value());
    BatchImporter importer;
    importer.setSession(session_.get());
    QSignalSpy imported(&importer, &BatchImporter::imported);
    importer.start(QString::fromStdString(path("scans").string()), ImportKind::Scans, {});
    QTRY_COMPARE(imported.count(), 1);
    QCOMPARE(imported.front().front().toString(), QStringLiteral("B0004"));
    const auto batches = catalogue::Batches(session_->project().catalogue()).all();
    QCOMPARE(batches->size(), std::size_t{1});
    QCOMPARE(namesIn(session_->project().batchFolder("B0004")), (QStringList{"back", "front"}));
    QCOMPARE(*readFile(kept), std::string("mine"));
  }

  void whatFailsAfterCopyingLeavesNeitherABatchNorFiles() {
    writeScans();
    BatchImporter importer;
    importer.setSession(session_.get());
    QSignalSpy failed(&importer, &BatchImporter::failed);
    importer.start(shown("scans"), ImportKind::Scans, {"ARM1", "T3", "", ""});  // no place
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
    QCOMPARE(namesIn(path("project") / "batches"), QStringList());
    // The copy is gone when it is to be put in its place: the row goes, too, and its bag.
    connect(&importer, &BatchImporter::ended, this, [this] {
      std::filesystem::remove_all(path("project") / "batches" / "import.partial");
    });
    importer.start(shown("scans"), ImportKind::Scans, {"ARM1", "T3", "0012", "4"});
    QTRY_COMPARE(failed.count(), 2);
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
    QVERIFY(catalogue::Places(session_->project().catalogue()).contexts()->empty());
    QCOMPARE(namesIn(path("project") / "batches"), QStringList());
  }

  void whatAKilledImportLeftIsRemovedWhenTheProjectIsOpened() {
    const std::filesystem::path batches = path("project") / "batches";
    records::BatchRecord record;
    record.state = records::BatchState::Queued;
    QVERIFY(catalogue::Batches(session_->project().catalogue()).add(record, {}).has_value());
    for (const char* file :
         {"import.partial/front/a.ply", "B0001/front/a.ply", "B0001/.import.partial",
          "B0002/front/a.ply", "B0002/.import.partial", "B0003/front/a.ply"})
      QVERIFY(writeFileAtomically(batches / file, "x").has_value());
    {
      const auto held = Hold::take(batches / "import.partial");
      BatchImporter importer;
      importer.setSession(session_.get());
      QVERIFY2(namesIn(batches).contains("import.partial"), "another program copies into it");
    }
    BatchImporter importer;
    importer.setSession(session_.get());
    QCOMPARE(namesIn(batches), (QStringList{"B0001", "B0003"}));
    QCOMPARE(namesIn(batches / "B0001"), QStringList{"front"});
  }

  // A JPEG whose Exif says when it was taken and nothing else: at 09:30:00 and 09:30:12.
  static std::string photographOf(const char* second) {
    QByteArray jpeg;
    QBuffer buffer(&jpeg);
    QImage image(64, 48, QImage::Format_RGB32);
    image.fill(Qt::gray);
    image.save(&buffer, "JPG");
    const std::string exif = std::string(
                                 "\xFF\xE1\0\x48"
                                 "Exif\0\0MM\0*\0\0\0\x08"
                                 "\0\x01\x87\x69\0\x04\0\0\0\x01\0\0\0\x1A\0\0\0\0"
                                 "\0\x01\x90\x03\0\x02\0\0\0\x14\0\0\0\x2C\0\0\0\0",
                                 54) +
                             "2026:07:14 09:30:" + second + '\0';
    return jpeg.toStdString().insert(2, exif);
  }

  void aBatchIsOfTheDayWhenItWasPhotographed() {
    for (const char* side : {"front", "back"})
      for (int stop = 0; stop < 4; ++stop)
        QVERIFY(
            writeFileAtomically(path("week") / side / ("cam0_pos0" + std::to_string(stop) + ".jpg"),
                                photographOf(stop == 0 ? "00" : "12") + side + char('0' + stop))
                .has_value());
    QVERIFY(virtualrig::writePlateAndBoard(path("week")).has_value());
    QVERIFY(
        writeFileAtomically(path("week") / "back" / "cam0_pos04.jpg", "no picture").has_value());
    BatchImporter importer;
    importer.setSession(session_.get());
    std::string sentence;
    connect(&importer, &BatchImporter::failed, this,
            [&](const Error& error) { sentence = error.sentence().english(); });
    QSignalSpy imported(&importer, &BatchImporter::imported);
    importer.start(QString::fromStdString(path("week").string()), ImportKind::Photographs, {});
    QTRY_VERIFY2(imported.count() == 1, sentence.c_str());
    const records::BatchRecord batch =
        catalogue::Batches(session_->project().catalogue()).all()->front();
    const QDate day(2026, 7, 14);  // its clock is this computer's: it says no other
    QCOMPARE(batch.started_ms, QDateTime(day, QTime(9, 30, 0)).toMSecsSinceEpoch());
    QCOMPARE(batch.ended_ms, QDateTime(day, QTime(9, 30, 12)).toMSecsSinceEpoch());
    const QStringList doubts = imported[0][2].toStringList();
    QCOMPARE(doubts.size(), 1);  // and what is no picture is told at once
    QVERIFY(doubts[0].contains("cam0_pos04.jpg"));
    // What vanishes before it is computed is noticed, since the catalogue has it from now on.
    const catalogue::Batches batches(session_->project().catalogue());
    QTRY_COMPARE(batches.photographs(batch.row)->size(), std::size_t{8});
    const auto files = catalogue::Files(session_->project().catalogue()).of(batch.row);
    QVERIFY(files.has_value());
    QCOMPARE(files->size(), std::size_t{10});  // with what describes the plate and the board
    QCOMPARE(files->front().sha256.size(), std::size_t{64});
  }

  void whatCouldNotBeComputedIsNotImported() {
    for (const char* side : {"front", "back"})
      for (int stop = 0; stop < 4; ++stop)
        QVERIFY(
            writeFileAtomically(path("bare") / side / ("cam0_pos0" + std::to_string(stop) + ".jpg"),
                                photographOf("00"))
                .has_value());
    BatchImporter importer;
    importer.setSession(session_.get());
    std::string sentence;
    connect(&importer, &BatchImporter::failed, this,
            [&](const Error& error) { sentence = error.sentence().english(); });
    importer.start(QString::fromStdString(path("bare").string()), ImportKind::Photographs, {});
    QTRY_VERIFY2(sentence.find("plate.json") != std::string::npos, sentence.c_str());
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
  }

  // A photograph whose clock says 09:30 and so many seconds; large enough not to be a thumbnail.
  void byHand(const char* file, int second) {
    QByteArray jpeg;
    QBuffer buffer(&jpeg);
    QImage image(800, 600, QImage::Format_RGB32);
    image.fill(QColor::fromHsv(6 * second, 255, 200));
    image.save(&buffer, "JPG");
    const std::string exif = photographOf(qPrintable(QString("%1").arg(second, 2, 10, QChar('0'))));
    QVERIFY(writeFileAtomically(path(file), jpeg.toStdString().insert(2, exif.substr(2, 74)))
                .has_value());
  }

  void sheetAt(const char* folder) {
    QVERIFY(virtualrig::writePlateAndBoard(path(folder)).has_value());
  }

  static QStringList names(const std::vector<std::filesystem::path>& files) {
    QStringList all;
    for (const auto& file : files) all << QString::fromStdString(file.filename().string());
    return all;
  }

  void oneFolderIsDividedAtTheFlip() {
    for (int i = 0; i < 4; ++i) byHand(qPrintable(QString("trench/IMG_%1.jpg").arg(8 + i)), 2 * i);
    for (int i = 0; i < 3; ++i)
      byHand(qPrintable(QString("trench/IMG_%1.jpg").arg(12 + i)), 40 + 2 * i);
    sheetAt("trench");
    const auto plan = planSides({QString::fromStdString(path("trench/").string())}, {});
    QVERIFY(plan.has_value() && plan->has_value());
    QVERIFY((*plan)->divisible && (*plan)->flip_found && (*plan)->isDecided());
    const ImportSides sides = (*plan)->sides();
    QCOMPARE(names(sides.front),
             (QStringList{"IMG_8.jpg", "IMG_9.jpg", "IMG_10.jpg", "IMG_11.jpg"}));
    QCOMPARE(names(sides.back), (QStringList{"IMG_12.jpg", "IMG_13.jpg", "IMG_14.jpg"}));
    QCOMPARE(*sides.sheet, path("trench") / "plate.json");
  }

  void theFolderOfTheBacksTakesThePlaceOfTheSplit() {
    for (int i = 0; i < 6; ++i) {
      byHand(qPrintable(QString("fronts/%1.jpg").arg(i)), 2 * i);
      byHand(qPrintable(QString("backs/%1.jpg").arg(i)), 40 + 2 * i);
    }
    const auto split = planSides({QString::fromStdString(path("fronts").string())}, {});
    QVERIFY(split.has_value() && split->has_value() && (*split)->divisible);
    const auto both = withBack(**split, QString::fromStdString(path("backs").string()));
    QVERIFY(both.has_value());
    QVERIFY(!both->divisible && both->isDecided());
    QCOMPARE(both->sides().front.size(), std::size_t{6});
    QCOMPARE(both->sides().back.front(), path("backs/0.jpg"));
    const auto again = withBack(*both, QString::fromStdString(path("backs").string()));
    QVERIFY(again.has_value());
    QCOMPARE(again->sides().front.front(), path("fronts/0.jpg"));
    QCOMPARE(again->sides().back.size(), std::size_t{6});
    QVERIFY(!withBack(*both, QString::fromStdString(path("project").string())).has_value());
  }

  void withoutAPauseAPersonSaysWhereItIsDivided() {
    for (int i = 0; i < 8; ++i) byHand(qPrintable(QString("even/%1.jpg").arg(i)), 3 * i);
    const auto plan = planSides({QString::fromStdString(path("even").string())}, path("last.json"));
    QVERIFY(plan.has_value() && plan->has_value());
    QVERIFY(!(*plan)->isDecided());
    QVERIFY(!(*plan)->sheet);  // the one of last time is gone
    SidesPlan one = **plan;
    one.one_side = true;
    QVERIFY(one.isDecided());
    QCOMPARE(one.sides().front.size(), std::size_t{8});
    QVERIFY(one.sides().back.empty());
  }

  void ofTwoFoldersTheLaterOneHoldsTheBacks() {
    for (int i = 0; i < 3; ++i) {
      byHand(qPrintable(QString("tray/a/%1.jpg").arg(i)), 40 + i);
      byHand(qPrintable(QString("tray/b/%1.jpg").arg(i)), i);
    }
    QVERIFY(writeFileAtomically(path("last.json"), "{}").has_value());
    for (const QStringList& dropped :
         {QStringList{QString::fromStdString(path("tray/a").string()),
                      QString::fromStdString(path("tray/b").string())},
          QStringList{QString::fromStdString(path("tray").string())}}) {
      const auto plan = planSides(dropped, path("last.json"));
      QVERIFY(plan.has_value() && plan->has_value());
      QVERIFY(!(*plan)->divisible && (*plan)->isDecided());
      const ImportSides sides = (*plan)->sides();
      QCOMPARE(sides.front.front(), path("tray/b/0.jpg"));
      QCOMPARE(sides.back.front(), path("tray/a/0.jpg"));
      QCOMPARE(*sides.sheet, path("last.json"));
    }
  }

  void whatHoldsNoPhotographsOrHalfABatchIsRefused() {
    QVERIFY(writeFileAtomically(path("empty/readme.txt"), "x").has_value());
    byHand("one/1.jpg", 1);
    const QString empty = QString::fromStdString(path("empty").string());
    const QString one = QString::fromStdString(path("one").string());
    QVERIFY(!planSides({empty}, {}).has_value());
    QVERIFY(!planSides({one, empty}, {}).has_value());
    QVERIFY(!planSides({one, one, one}, {}).has_value());
    QVERIFY(!planSides({one, one + "/1.jpg"}, {}).has_value());
    QVERIFY(!planSides({one + "/gone"}, {}).has_value());
    byHand("batch/front/1.jpg", 1);
    QVERIFY(!planSides({QString::fromStdString(path("batch").string())}, {}).has_value());
  }

  void severalFoldersWithPhotographsAreNamed() {
    for (const char* file : {"all/a/1.jpg", "all/b/1.jpg", "all/c/1.jpg", "all/d/1.jpg"})
      byHand(file, 1);
    const auto plan = planSides({QString::fromStdString(path("all").string())}, {});
    QVERIFY(!plan.has_value());
    const std::string& why = plan.error().what.english();
    QVERIFY2(why.find("several folders with photographs (a, b, c, …)") != std::string::npos,
             why.c_str());
  }

  // A folder is not asked about less because its sides are called front and back.
  void aBatchByHandIsShownByItsSidesUnlessItHasMoreThanPhotographs() {
    for (int i = 0; i < 3; ++i) {
      byHand(qPrintable(QString("table/front/%1.jpg").arg(i)), 40 + i);
      byHand(qPrintable(QString("table/back/%1.jpg").arg(i)), i);
    }
    sheetAt("table");
    std::filesystem::remove(path("table/board.json"));
    const QStringList table{QString::fromStdString(path("table").string())};
    const auto plan = planSides(table, {});
    QVERIFY(plan.has_value() && plan->has_value());
    const ImportSides sides = (*plan)->sides();
    QCOMPARE(sides.front.front(), path("table/front/0.jpg"));
    QCOMPARE(sides.back.front(), path("table/back/0.jpg"));
    QCOMPARE(*sides.sheet, path("table/plate.json"));
    std::filesystem::create_directories(path("table/front_masks"));
    std::filesystem::copy_file(path("table/front/0.jpg"), path("table/front_masks/0.jpg"));
    const auto whole = planSides(table, {});
    QVERIFY(whole.has_value() && !whole->has_value());
  }

  void photographsByHandBecomeABatchUnderTheirOwnNames() {
    ImportSides sides;
    for (int i = 0; i < 4; ++i) {
      byHand(qPrintable(QString("up/IMG_%1.jpg").arg(i)), i);
      byHand(qPrintable(QString("down/IMG_%1.jpg").arg(i)), 40 + i);
      sides.front.push_back(path("up") / ("IMG_" + std::to_string(i) + ".jpg"));
      sides.back.push_back(path("down") / ("IMG_" + std::to_string(i) + ".jpg"));
    }
    QVERIFY(writeFileAtomically(path("up/IMG_4.jpg"), "no picture").has_value());
    sides.front.push_back(path("up/IMG_4.jpg"));
    sheetAt("sheets");
    BatchImporter importer;
    importer.setSession(session_.get());
    QSignalSpy imported(&importer, &BatchImporter::imported);
    QSignalSpy there(&importer, &BatchImporter::alreadyThere);
    std::string sentence;
    connect(&importer, &BatchImporter::failed, this,
            [&](const Error& error) { sentence = error.sentence().english(); });
    const QString from = QString::fromStdString(path("up").string());
    sides.sheet = path("sheets/plate.json");
    importer.start(from, ImportKind::Photographs, {}, sides);
    QTRY_VERIFY2(imported.count() == 1, sentence.c_str());
    QCOMPARE(imported[0][1].toInt(), 9);
    QCOMPARE(imported[0][2].toStringList().size(), 1);  // of the one that is no picture
    const records::BatchRecord batch =
        catalogue::Batches(session_->project().catalogue()).all()->front();
    QCOMPARE(batch.state, records::BatchState::Queued);
    const auto copy = session_->project().batchFolder(batch.number);
    for (const char* file : {"front/IMG_0.jpg", "back/IMG_3.jpg", "plate.json"})
      QVERIFY2(std::filesystem::exists(copy / file), file);
    QVERIFY(!std::filesystem::exists(copy / "front" / "IMG_4.jpg"));
    QCOMPARE(batch.started_ms, QDateTime(QDate(2026, 7, 14), QTime(9, 30)).toMSecsSinceEpoch());
    QuietProgress quiet;
    const auto read = batch::readBatch(copy, {}, quiet);
    QVERIFY(read.has_value());
    QCOMPARE(read->way, batch::Way::FreeCamera);
    QCOMPARE(read->shots.size(), std::size_t{8});
    importer.start(from, ImportKind::Photographs, {}, sides);
    QTRY_COMPARE(there.count(), 1);
  }

  void theSamePhotographsForBothSidesAreRefused() {
    ImportSides sides;
    for (int i = 0; i < 4; ++i) {
      const std::string name = "IMG_" + std::to_string(i) + ".jpg";
      byHand(("up/" + name).c_str(), i);
      byHand(("again/" + name).c_str(), i);
      sides.front.push_back(path("up") / name);
      sides.back.push_back(path("again") / name);
    }
    BatchImporter importer;
    importer.setSession(session_.get());
    Error why;
    connect(&importer, &BatchImporter::failed, this, [&](const Error& error) { why = error; });
    importer.start(QString::fromStdString(path("up").string()), ImportKind::Photographs, {}, sides);
    QTRY_VERIFY(!why.what.empty());
    QVERIFY2(why.what.english().starts_with("4 of the 4 photographs of the back side"),
             why.what.english().c_str());
    QCOMPARE(why.where, path("again").string());
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
  }

  void photographsThatAreNoBatchAreRefused() {
    QVERIFY(writeFileAtomically(path("holiday") / "beach.jpg", "x").has_value());
    BatchImporter importer;
    importer.setSession(session_.get());
    std::string sentence;
    connect(&importer, &BatchImporter::failed, this,
            [&](const Error& error) { sentence = error.sentence().english(); });
    importer.start(QString::fromStdString(path("holiday").string()), ImportKind::Photographs, {});
    QTRY_VERIFY(!sentence.empty());
    QVERIFY(catalogue::Batches(session_->project().catalogue()).all()->empty());
  }

 private:
  std::filesystem::path path(const std::string& name) const {
    return std::filesystem::path(folder_->path().toStdString()) / name;
  }
  QString shown(const char* name) const { return QString::fromStdString(path(name).string()); }
  void writeScans() const {
    for (const char* file : {"front/a.ply", "back/b.ply"})
      QVERIFY(writeFileAtomically(path("scans") / file, file).has_value());
  }
  static QStringList namesIn(const std::filesystem::path& folder) {
    return QDir(QString::fromStdString(folder.string()))
        .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
  }
  InlineJobRunner jobs_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<ProjectSession> session_;
};

OSTRAKA_UI_TEST(ImportTest)
#include "import_test.moc"
