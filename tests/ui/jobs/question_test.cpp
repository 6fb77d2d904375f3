#include "ui/jobs/question.h"

#include <QSignalSpy>
#include <QtTest>

#include "tests/ui/program.h"
#include "ui/jobs/job.h"

using namespace ostraka;
using namespace ostraka::ui;

class QuestionTest : public QObject {
  Q_OBJECT

 private:
  static Job asking(const Question& question) {
    return makeJob([ask = question.asker()](Progress&, std::stop_token stop) -> Result<bool> {
      return ask("Turn the table.", stop);
    });
  }

 private slots:
  void theJobWaitsForTheAnswer_data() {
    QTest::addColumn<bool>("answer");
    QTest::newRow("done") << true;
    QTest::newRow("rather not") << false;
  }
  void theJobWaitsForTheAnswer() {
    QFETCH(bool, answer);
    ThreadedJobRunner jobs;
    Question question;
    std::optional<bool> heard;
    JobHandle* job = jobs.start(asking(question), this);
    connect(job, &JobHandle::finished, this,
            [&](const JobOutcome& outcome) { heard = *outcomeAs<bool>(outcome); });
    QTRY_COMPARE(question.sentence(), QStringLiteral("Turn the table."));
    QVERIFY(!heard);
    question.answer(answer);
    QTRY_VERIFY(heard.has_value());
    QCOMPARE(*heard, answer);
    QTRY_VERIFY(question.sentence().isEmpty());
  }

  void aJobThatIsStoppedWaitsNoLonger() {
    ThreadedJobRunner jobs;
    Question question;
    JobHandle* job = jobs.start(asking(question), this);
    bool ended = false;
    connect(job, &JobHandle::finished, this, [&] { ended = true; });
    QTRY_VERIFY(!question.sentence().isEmpty());
    job->cancel();
    QTRY_VERIFY(ended);
  }

  void aQuestionWhoseOwnerIsGoneIsAnsweredWithNo() {
    ThreadedJobRunner jobs;
    auto question = std::make_unique<Question>();
    std::optional<bool> heard;
    JobHandle* job = jobs.start(asking(*question), this);
    connect(job, &JobHandle::finished, this,
            [&](const JobOutcome& outcome) { heard = *outcomeAs<bool>(outcome); });
    QTRY_VERIFY(!question->sentence().isEmpty());
    question.reset();
    QTRY_COMPARE(heard, std::optional<bool>(false));
  }
};

OSTRAKA_UI_TEST(QuestionTest)
#include "question_test.moc"
