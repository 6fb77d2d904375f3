// The numbering of an open project is changed, its words too, and both are taken back.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtTest>

#include "../names.h"
#include "../project_in.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/ui/program.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/job.h"
#include "ui/settings/numbering_edit.h"
#include "ui/settings/numbering_model.h"
#include "ui/settings/project_edit.h"
#include "ui/settings/rights_edit.h"
#include "ui/settings/vocabulary_edit.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class NumberingTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    project_ = projectIn(folder_->filePath("project").toStdString(), "ARM");
    session_ = std::make_unique<ProjectSession>(project_, project_->folder(), jobs_);
    session_->setInitials("AP");
    records::SiteRecord site;
    site.code = "ARM1";
    site.name = "Hill";
    records::TrenchRecord trench;
    trench.site = *catalogue::Places(rows()).save(site, {});
    trench.code = "T3";
    records::ContextRecord context;
    context.site = trench.site;
    context.trench = *catalogue::Places(rows()).save(trench, {});
    context.number = "0012";
    context_ = *catalogue::Places(rows()).save(context, {});
  }

  // Whose finds they are is not the program's to say.
  void noLicenceIsNamedUntilAPersonNamesOne() {
    RightsEdit edit;
    edit.setSession(session_.get());
    edit.show();
    auto* licence = edit.findChild<QLineEdit*>("licence");
    QCOMPARE(licence->text(), QString());
    QTest::keyClicks(licence, "CC-BY-NC-4.0");
    QTest::keyClick(licence, Qt::Key_Return);
    QCOMPARE(catalogue::Settings(rows()).project()->licence, std::string("CC-BY-NC-4.0"));
    auto* holder = edit.findChild<QLineEdit*>("rightsHolder");
    QTest::keyClicks(holder, "Museum Yerevan");
    QTest::keyClick(holder, Qt::Key_Return);
    QCOMPARE(catalogue::Settings(rows()).project()->rights_holder, std::string("Museum Yerevan"));
    session_->undo().undo();
    QCOMPARE(catalogue::Settings(rows()).project()->rights_holder, std::string());
    session_->undo().undo();
    QCOMPARE(catalogue::Settings(rows()).project()->licence, std::string());
    QCOMPARE(licence->text(), QString());
  }

  void aProjectGetsAnotherNameAndSiteCodeAndBothAreUndone() {
    catalogue::Settings settings(rows());
    QVERIFY(settings.rename("Hill", "ARM1", {}).error().what.english().find("already exists") !=
            std::string::npos);
    ProjectEdit edit;
    edit.setSession(session_.get());
    edit.show();
    QSignalSpy renamed(&edit, &ProjectEdit::renamed);
    auto* name = edit.findChild<QLineEdit*>("projectName");
    auto* code = edit.findChild<QLineEdit*>("projectCode");
    QCOMPARE(code->text(), QStringLiteral("ARM"));
    const std::string before = settings.project()->title;
    name->clear();
    QTest::keyClicks(name, "Grabung Nord");
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(settings.project()->title, std::string("Grabung Nord"));
    code->clear();
    QTest::keyClicks(code, "grb");
    QTest::keyClick(code, Qt::Key_Return);
    QCOMPARE(settings.project()->code, std::string("GRB"));
    QCOMPARE(renamed.count(), 2);
    session_->undo().undo();
    QCOMPARE(code->text(), QStringLiteral("ARM"));
    session_->undo().undo();
    QCOMPARE(settings.project()->title, before);
    code->setText("A");  // too short
    QTest::keyClick(code, Qt::Key_Return);
    QCOMPARE(settings.project()->code, std::string("ARM"));
    QVERIFY(!edit.findChild<QLabel*>("projectTold")->text().isEmpty());
  }

  void texturesWithoutTheLightAreRememberedInTheProject() {
    ProjectEdit edit;
    edit.setSession(session_.get());
    edit.show();
    auto* textures = edit.findChild<QComboBox*>("projectTextures");
    QCOMPARE(textures->currentIndex(), 0);
    textures->setCurrentIndex(1);
    emit textures->activated(1);
    QVERIFY(*catalogue::Settings(rows()).texturesWithoutLight());
    session_->undo().undo();
    QVERIFY(!*catalogue::Settings(rows()).texturesWithoutLight());
    QCOMPARE(textures->currentIndex(), 0);
  }

  void anotherNumberingHoldsForTheNextSherdsOnlyAndIsUndone() {
    const store::SherdRow first = numbered();
    NumberingEdit edit;
    edit.setSession(session_.get());
    edit.show();
    auto* scheme = edit.findChild<QLineEdit*>("numberingScheme");
    auto* apply = edit.findChild<QPushButton*>("numberingApply");
    auto* example = edit.findChild<QLabel*>("numberingExample");
    QCOMPARE(scheme->text(), QStringLiteral("{site}-{trench}-{context}-{n:04}"));
    QVERIFY(!apply->isEnabled());
    scheme->selectAll();
    QTest::keyClicks(scheme, "{site}/{context}.{n:03}");
    QCOMPARE(example->text(), QStringLiteral("ARM1/0012.001"));
    QVERIFY(apply->isEnabled());
    QTest::mouseClick(apply, Qt::LeftButton);
    QVERIFY(!apply->isEnabled());
    QCOMPARE(numberOf(numbered()), QStringLiteral("ARM1/0012.001"));
    QCOMPARE(numberOf(first), QStringLiteral("ARM1-T3-0012-0001"));
    session_->undo().undo();
    QCOMPARE(scheme->text(), QStringLiteral("{site}-{trench}-{context}-{n:04}"));
    QCOMPARE(numberOf(numbered()), QStringLiteral("ARM1-T3-0012-0002"));
    session_->undo().redo();
    QCOMPARE(numberOf(numbered()), QStringLiteral("ARM1/0012.002"));
    QCOMPARE(catalogue::Settings(rows()).project()->numbering,
             std::string("{site}/{context}.{n:03}"));
  }

  // By a merge, the command line or another window.
  void whatAnotherWroteSinceIsNeitherUndoneNorRedone() {
    RightsEdit rights;
    NumberingEdit numbering;
    VocabularyEdit vocabulary;
    rights.setSession(session_.get());
    numbering.setSession(session_.get());
    vocabulary.setSession(session_.get());
    const QSignalSpy refused(session_.get(), &ProjectSession::stepRefused);
    const auto expectRefusedFor = [&](const QString& field) {
      QCOMPARE(refused.last()[0].toString(),
               QStringLiteral("The field %1 was changed meanwhile; nothing was undone or redone.")
                   .arg(field));
      QCOMPARE(session_->undo().count(), 0);
    };
    catalogue::Settings settings(rows());

    auto* licence = rights.findChild<QLineEdit*>("licence");
    QTest::keyClicks(licence, "CC-BY-4.0");
    QTest::keyClick(licence, Qt::Key_Return);
    records::ProjectRecord project = *settings.project();
    project.title = "Another title";
    QVERIFY(settings.setProject(project, {}).has_value());
    session_->undo().undo();  // the title is no part of the step
    QCOMPARE(refused.count(), 0);
    QCOMPARE(settings.project()->title, std::string("Another title"));
    project = *settings.project();
    project.licence = "ODbL-1.0";
    QVERIFY(settings.setProject(project, {}).has_value());
    session_->undo().redo();
    QCOMPARE(settings.project()->licence, std::string("ODbL-1.0"));
    expectRefusedFor("rights");

    auto* scheme = numbering.findChild<QLineEdit*>("numberingScheme");
    scheme->selectAll();
    QTest::keyClicks(scheme, "{site}/{context}.{n:03}");
    numbering.findChild<QPushButton*>("numberingApply")->click();
    project = *settings.project();
    project.numbering = "{site}_{context}_{n}";
    QVERIFY(settings.setProject(project, {}).has_value());
    session_->undo().undo();
    QCOMPARE(settings.project()->numbering, std::string("{site}_{context}_{n}"));
    expectRefusedFor("numbering");

    auto* which = vocabulary.findChild<QComboBox*>("vocabularyWhich");
    which->setCurrentIndex(which->findData("firing"));
    vocabulary.findChild<QPlainTextEdit*>("vocabularyTerms")->setPlainText("oxidised");
    vocabulary.findChild<QPushButton*>("vocabularySave")->click();
    QVERIFY(settings.setVocabulary("firing", {{"oxidised", {}, {}}, {"smoked", {}, {}}}, {})
                .has_value());
    session_->undo().undo();
    QCOMPARE(settings.vocabulary("firing")->back().term, std::string("smoked"));
    expectRefusedFor("firing");
  }

  // What the page showed as it was opened is older.
  void undoPutsBackWhatStoodThereAtTheTimeOfTheStep() {
    RightsEdit edit;
    edit.setSession(session_.get());
    catalogue::Settings settings(rows());
    records::ProjectRecord project = *settings.project();
    project.licence = "ODbL-1.0";
    QVERIFY(settings.setProject(project, {}).has_value());
    auto* licence = edit.findChild<QLineEdit*>("licence");
    QTest::keyClicks(licence, "CC-BY-4.0");
    QTest::keyClick(licence, Qt::Key_Return);
    QCOMPARE(settings.project()->licence, std::string("CC-BY-4.0"));
    session_->undo().undo();
    QCOMPARE(settings.project()->licence, std::string("ODbL-1.0"));
  }

  void whatCannotBeIsRefusedInASentence() {
    NumberingEdit edit;
    edit.setSession(session_.get());
    auto* scheme = edit.findChild<QLineEdit*>("numberingScheme");
    auto* told = edit.findChild<QLabel*>("numberingTold");
    const QString before = told->text();
    scheme->selectAll();
    QTest::keyClicks(scheme, "{site}");
    QVERIFY(!edit.findChild<QPushButton*>("numberingApply")->isEnabled());
    QVERIFY(told->text() != before);
    QTest::keyClick(scheme, Qt::Key_Return);
    QCOMPARE(catalogue::Settings(rows()).project()->numbering,
             std::string("{site}-{trench}-{context}-{n:04}"));
    // A context straight in the site has no trench to be named.
    records::ContextRecord lone;
    lone.site = catalogue::Places(rows()).sites()->front().row;
    lone.number = "0099";
    QVERIFY(catalogue::Places(rows()).save(lone, {}).has_value());
    scheme->selectAll();
    QTest::keyClicks(scheme, "{trench}.{n}");
    QVERIFY2(told->text().contains("ARM1 0099"), qPrintable(told->text()));
    QVERIFY(edit.findChild<QPushButton*>("numberingApply")->isEnabled());
  }

  void aBlockOfNumbersKeepsTwoComputersApart() {
    NumberingEdit edit;
    edit.setSession(session_.get());
    edit.findChild<QSpinBox*>("numberingFirst")->setValue(5001);
    edit.findChild<QSpinBox*>("numberingLast")->setValue(5000);
    QVERIFY(!edit.findChild<QPushButton*>("numberingApply")->isEnabled());
    edit.findChild<QSpinBox*>("numberingLast")->setValue(6000);
    edit.findChild<QPushButton*>("numberingApply")->click();
    QCOMPARE(numberOf(numbered()), QStringLiteral("ARM1-T3-0012-5001"));
    QCOMPARE(*catalogue::Settings(rows()).value("numbering.last"), std::string("6000"));
  }

  void theExampleIsTheNextNumber() {
    numbered();
    NumberingEdit edit;
    edit.setSession(session_.get());
    QCOMPARE(edit.findChild<QLabel*>("numberingExample")->text(),
             QStringLiteral("ARM1-T3-0012-0002"));
  }

  void numbersLeftOutAreTold() {
    const store::SherdRow sherd = draft();
    const records::FieldChange typed{sherd, "number", "ARM1-T3-0012-0005"};
    QVERIFY(sherds::SherdChanges(rows()).apply(std::span(&typed, 1), {}).has_value());
    numbered();
    NumberingEdit edit;
    edit.setSession(session_.get());
    auto* gaps = edit.findChild<QLabel*>("numberingGaps");
    QTRY_COMPARE(gaps->text(), QStringLiteral("ARM1 T3 0012: 1–4"));
    QCOMPARE(numberRanges({3, 5, 6, 8, 9, 10}, 9), QStringLiteral("3, 5, 6, 8–10"));
    QCOMPARE(numberRanges({1, 3, 5, 7}, 2), QStringLiteral("1, 3, …"));
  }

  void wordsAreAddedAndThoseInUseStay() {
    const store::SherdRow sherd = draft();
    const records::FieldChange unknown{sherd, "firing", "smoked"};
    QVERIFY(!sherds::SherdChanges(rows()).apply(std::span(&unknown, 1), {}).has_value());
    VocabularyEdit edit;
    edit.setSession(session_.get());
    const QSignalSpy told(session_.get(), &ProjectSession::vocabulariesChanged);
    auto* which = edit.findChild<QComboBox*>("vocabularyWhich");
    which->setCurrentIndex(which->findData("firing"));
    auto* terms = edit.findChild<QPlainTextEdit*>("vocabularyTerms");
    QCOMPARE(terms->toPlainText(), QStringLiteral("oxidised\nreduced\nmixed"));
    terms->setPlainText("oxidised\nreduced\nmixed\n smoked \n");
    edit.findChild<QPushButton*>("vocabularySave")->click();
    QCOMPARE(told.count(), 1);
    QVERIFY(sherds::SherdChanges(rows()).apply(std::span(&unknown, 1), {}).has_value());
    terms->setPlainText("oxidised\nreduced\nmixed");
    edit.findChild<QPushButton*>("vocabularySave")->click();
    QVERIFY(edit.findChild<QLabel*>("vocabularyTold")->text().contains("smoked"));
    QCOMPARE(catalogue::Settings(rows()).vocabulary("firing")->size(), std::size_t{4});
    const records::FieldChange none{sherd, "firing", ""};
    QVERIFY(sherds::SherdChanges(rows()).apply(std::span(&none, 1), {}).has_value());
    session_->undo().undo();
    QCOMPARE(catalogue::Settings(rows()).vocabulary("firing")->size(), std::size_t{3});
    QCOMPARE(terms->toPlainText(), QStringLiteral("oxidised\nreduced\nmixed"));
  }

  void wordsThatAreNotSavedYetWaitWhileAnotherListIsShown() {
    VocabularyEdit edit;
    edit.setSession(session_.get());
    auto* which = edit.findChild<QComboBox*>("vocabularyWhich");
    auto* terms = edit.findChild<QPlainTextEdit*>("vocabularyTerms");
    auto* told = edit.findChild<QLabel*>("vocabularyTold");
    const QString standard = told->text();
    which->setCurrentIndex(which->findData("firing"));
    terms->setPlainText("oxidised\nreduced\nmixed\nsmoked");
    which->setCurrentIndex(which->findData("surface"));
    QVERIFY(!terms->toPlainText().contains("smoked"));
    QCOMPARE(told->text(), standard);
    which->setCurrentIndex(which->findData("firing"));
    QCOMPARE(terms->toPlainText(), QStringLiteral("oxidised\nreduced\nmixed\nsmoked"));
    QVERIFY(told->text() != standard);  // and says that it is not saved
    QCOMPARE(catalogue::Settings(rows()).vocabulary("firing")->size(), std::size_t{3});
    edit.findChild<QPushButton*>("vocabularySave")->click();
    QCOMPARE(catalogue::Settings(rows()).vocabulary("firing")->size(), std::size_t{4});
    which->setCurrentIndex(which->findData("surface"));
    which->setCurrentIndex(which->findData("firing"));
    QCOMPARE(told->text(), standard);
    // What is typed in one list outlives an undo in another.
    which->setCurrentIndex(which->findData("surface"));
    const QString typed = terms->toPlainText() + "\nsooted";
    terms->setPlainText(typed);
    session_->undo().undo();
    QCOMPARE(catalogue::Settings(rows()).vocabulary("firing")->size(), std::size_t{3});
    QCOMPARE(terms->toPlainText(), typed);
    edit.setSession(nullptr);
    edit.setSession(session_.get());
    QVERIFY(!terms->toPlainText().contains("sooted"));
  }

  void withoutAProjectThereIsNothingToChange() {
    NumberingEdit numbering;
    VocabularyEdit vocabulary;
    QWidget* const parts[] = {&numbering, &vocabulary};
    for (QWidget* part : parts) {
      const QStringList nameless = namelessIn(*part);
      QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join('\n')));
    }
    numbering.setSession(session_.get());
    vocabulary.setSession(session_.get());
    QVERIFY(!numbering.isHidden() && !vocabulary.isHidden());
    numbering.setSession(nullptr);
    vocabulary.setSession(nullptr);
    QVERIFY(numbering.isHidden() && vocabulary.isHidden());
  }

 private:
  catalogue::Catalogue& rows() { return project_->catalogue(); }
  store::SherdRow draft() {
    records::SherdRecord sherd;
    sherd.context = context_;
    return *sherds::Sherds(rows()).add(sherd, {});
  }
  store::SherdRow numbered() {
    const store::SherdRow row = draft();
    if (!sherds::Numbers(rows()).assign(std::span(&row, 1), {})) qFatal("no number");
    return row;
  }
  QString numberOf(store::SherdRow row) {
    return QString::fromStdString(sherds::Sherds(rows()).get(row)->number);
  }

  ThreadedJobRunner jobs_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::shared_ptr<upkeep::Project> project_;
  std::unique_ptr<ProjectSession> session_;
  store::ContextRow context_;
};

OSTRAKA_UI_TEST(NumberingTest)
#include "numbering_test.moc"
