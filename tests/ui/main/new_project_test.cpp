#include "ui/main/new_project.h"

#include <QtTest>

#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "tests/ui/program.h"
#include "ui/wizard/rig_source.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class NewProjectTest : public QObject {
  Q_OBJECT

 private slots:
  void theExampleFollowsWhatIsTyped() {
    NewProject fresh;
    fresh.setSiteCode("arm2");
    QCOMPARE(fresh.siteCode(), QStringLiteral("ARM2"));
    QCOMPARE(fresh.example(), QStringLiteral("ARM2-T3-0012-0007"));
    fresh.setNumbering("{site}.{yy}.{n:03}");
    QCOMPARE(fresh.example(), QStringLiteral("ARM2.26.007"));
  }

  void theFolderFollowsTheNameUntilItIsTyped() {
    NewProject fresh;
    fresh.setName("Aragats / north");
    QVERIFY(fresh.folder().endsWith("Ostraka/Aragats _ north"));
    fresh.setFolder("elsewhere");
    fresh.setName("Other");
    QCOMPARE(fresh.folder(), QStringLiteral("elsewhere"));
  }

  // Nothing is asked that can be said later; what was typed stays.
  void isProposedByTheFolderOfThePhotographs() {
    const QTemporaryDir folder;
    qputenv("HOME", folder.path().toUtf8());
    QVERIFY(QDir(folder.path()).mkpath("Grabung Süd/oben"));
    NewProject fresh;
    fresh.proposeFor({folder.filePath("Grabung Süd/oben"), folder.filePath("Grabung Süd/unten")});
    QCOMPARE(fresh.name(), QStringLiteral("Grabung Süd"));
    QCOMPARE(fresh.siteCode(), QStringLiteral("GRABUNGS"));
    QCOMPARE(fresh.folder(), folder.filePath("Ostraka/Grabung Süd"));
    QVERIFY2(fresh.canBeMade(), qPrintable(fresh.refusal()));
    QVERIFY(QDir(folder.path()).mkpath("Ostraka/oben"));
    NewProject second;
    second.setSiteCode("arm1");
    second.proposeFor({folder.filePath("Grabung Süd/oben")});
    QCOMPARE(second.siteCode(), QStringLiteral("ARM1"));
    QCOMPARE(second.folder(), folder.filePath("Ostraka/oben 2"));
    NewProject other;
    other.proposeFor({folder.filePath("Φ/x.jpg")});
    QCOMPARE(other.siteCode(), QStringLiteral("SITE"));
  }

  // The first attempt failed, say, and other photographs are dropped.
  void whatWasProposedGivesWayToTheNextProposalAndWhatWasTypedStays() {
    const QTemporaryDir folder;
    qputenv("HOME", folder.path().toUtf8());
    QVERIFY(QDir(folder.path()).mkpath("Hill") && QDir(folder.path()).mkpath("Valley"));
    NewProject fresh;
    fresh.proposeFor({folder.filePath("Hill")});
    fresh.proposeFor({folder.filePath("Valley")});
    QCOMPARE(fresh.name(), QStringLiteral("Valley"));
    QCOMPARE(fresh.siteCode(), QStringLiteral("VALLEY"));
    QCOMPARE(fresh.folder(), folder.filePath("Ostraka/Valley"));
    fresh.setSiteCode("arm1");
    fresh.proposeFor({folder.filePath("Hill")});
    QCOMPARE(fresh.name(), QStringLiteral("Hill"));
    QCOMPARE(fresh.siteCode(), QStringLiteral("ARM1"));
  }

  void isEmptyAgainForTheNextOne() {
    NewProject fresh;
    fresh.setName("Aragats");
    fresh.setSiteCode("arm1");
    fresh.setFolder("elsewhere");
    fresh.setNumbering("{site}.{n:03}");
    fresh.clear();
    QVERIFY(fresh.name().isEmpty() && fresh.siteCode().isEmpty() && fresh.folder().isEmpty());
    QCOMPARE(fresh.numbering(), NewProject().numbering());
    fresh.setName("Other");
    QVERIFY(fresh.folder().endsWith("Ostraka/Other"));  // follows the name again
  }

  void aFolderWithASpaceIsTyped() {
    const QTemporaryDir folder;
    NewProject fresh;
    fresh.setSiteCode("ARM1");
    fresh.setFolder(folder.filePath("a "));
    QCOMPARE(fresh.folder(), folder.filePath("a "));  // what the field shows is what was typed
    fresh.setFolder(folder.filePath("a b "));
    QVERIFY(fresh.make().has_value());
    QVERIFY(QFileInfo::exists(folder.filePath("a b/catalogue.sqlite")));
  }

  void saysWhyItCannotBeMade() {
    const QTemporaryDir folder;
    NewProject fresh;
    fresh.setFolder(folder.filePath("p"));
    QVERIFY(fresh.refusal().contains("code"));
    fresh.setSiteCode("ARM1");
    QVERIFY2(fresh.canBeMade(), qPrintable(fresh.refusal()));
    fresh.setNumbering("{site}-{context}");
    QVERIFY(!fresh.canBeMade());  // without {n} all sherds would have one number
    QVERIFY(fresh.example().isEmpty());
    fresh.setNumbering("{site}-{n}");
    QFile other(folder.filePath("other.txt"));
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.close();
    fresh.setFolder(folder.path());
    QVERIFY(fresh.refusal().contains("other files"));
  }

  void aMadeProjectIsThereAndIsNotMadeTwice() {
    const QTemporaryDir folder;
    NewProject fresh;
    fresh.setSiteCode("ARM1");
    fresh.setName("Aragats");
    fresh.setFolder(folder.filePath("p"));
    const auto made = fresh.make();
    QVERIFY2(made.has_value(), made ? "" : made.error().sentence().english().c_str());
    QCOMPARE(catalogue::Places((*made)->catalogue()).sites()->front().code, std::string("ARM1"));
    QCOMPARE(catalogue::Settings((*made)->catalogue()).project()->title, std::string("Aragats"));
    QVERIFY(fresh.refusal().contains("project in this folder already"));
  }

  void theVirtualProjectHasItsRigAndItsBag() {
    const QTemporaryDir folder;
    const auto made = makeVirtualProject(folder.filePath("v"));
    QVERIFY2(made.has_value(), made ? "" : made.error().sentence().english().c_str());
    const auto rig = catalogue::Settings((*made)->catalogue()).value("rig");
    QCOMPARE(RigChoice::fromJson(QString::fromStdString(*rig)).kind, RigChoice::Kind::Virtual);
    QVERIFY(!catalogue::Settings((*made)->catalogue()).value("capture.place")->empty());
  }

  void aRigIsReadAsItWasWritten() {
    RigChoice choice;
    choice.kind = RigChoice::Kind::File;
    choice.file = "some/RIG.json";
    choice.seed = 18446744073709551615U;
    choice.width_px = 900;
    const RigChoice back = RigChoice::fromJson(choice.toJson());
    QCOMPARE(back.kind, choice.kind);
    QCOMPARE(back.file, choice.file);
    QCOMPARE(back.seed, choice.seed);
    QCOMPARE(back.width_px, 900);
    QCOMPARE(RigChoice::fromJson("not json").kind, RigChoice::Kind::None);
  }
};

OSTRAKA_UI_TEST(NewProjectTest)
#include "new_project_test.moc"
