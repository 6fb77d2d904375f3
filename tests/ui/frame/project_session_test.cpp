// Who works on the project, as the history names them.
#include "ui/frame/project_session.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "../project_in.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "tests/ui/program.h"
#include "ui/jobs/job.h"
#include "upkeep/project.h"

using namespace ostraka;
using namespace ostraka::ui;

class ProjectSessionTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    const std::filesystem::path path = folder_->filePath("p").toStdString();
    session_ = std::make_unique<ProjectSession>(projectIn(path), path, jobs_);
  }

  void whoTypesSmallLettersIsTheSamePerson() {
    catalogue::Catalogue& rows = session_->project().catalogue();
    const auto anna =
        catalogue::People(rows).save(records::PersonRecord{{}, {}, "Anna P.", "AP", {}}, {});
    QVERIFY(anna.has_value());
    QSignalSpy refused(session_.get(), &ProjectSession::personRefused);
    session_->setInitials("ap ");
    QCOMPARE(session_->initials(), QStringLiteral("AP"));
    QCOMPARE(session_->provenance().person, *anna);
    QCOMPARE(refused.count(), 0);
  }

  void aPersonWhomTheProjectDoesNotKnowIsEntered() {
    session_->setInitials("bk");
    const records::Provenance provenance = session_->provenance();
    const auto persons = catalogue::People(session_->project().catalogue()).all();
    QCOMPARE(persons->size(), std::size_t{1});
    QCOMPARE(persons->front().initials, std::string("BK"));
    QCOMPARE(provenance.person, persons->front().row);
  }

  void theFieldsShowTheCapitalsThatAreKept() {
    session_->setInitials("AP");
    QSignalSpy changed(session_.get(), &ProjectSession::initialsChanged);
    session_->setInitials("ap");
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].toString(), QStringLiteral("AP"));
    session_->setInitials("AP");
    QCOMPARE(changed.count(), 1);
  }

  void whatOthersWriteIsTold() {
    QSignalSpy wrote(session_.get(), &ProjectSession::othersWrote);
    catalogue::Settings own(session_->project().catalogue());
    QVERIFY(own.setValue("key", "own").has_value());
    session_->lookForOthers();
    QCOMPARE(wrote.count(), 0);
    auto elsewhere = upkeep::Project::connect(session_->folder());
    QVERIFY(elsewhere.has_value());
    QVERIFY(catalogue::Settings(*elsewhere).setValue("key", "theirs").has_value());
    QVERIFY(wrote.wait(10 * ProjectSession::kLook_ms));
    session_->lookForOthers();
    QCOMPARE(wrote.count(), 1);
  }

  void aPersonWhoCannotBeEnteredIsSaid() {
    QSignalSpy refused(session_.get(), &ProjectSession::personRefused);
    session_->setInitials(QString(300, 'X'));
    QVERIFY(!session_->provenance().person);
    QCOMPARE(refused.count(), 1);
    QVERIFY(refused[0][0].toString().contains("at most 200 characters"));
  }

 private:
  InlineJobRunner jobs_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<ProjectSession> session_;
};

OSTRAKA_UI_TEST(ProjectSessionTest)
#include "project_session_test.moc"
