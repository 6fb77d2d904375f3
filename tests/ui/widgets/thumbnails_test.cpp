// Pictures of files; in a project no link is followed.
#include "ui/widgets/thumbnails.h"

#include <sys/stat.h>

#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <filesystem>

#include "tests/ui/program.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

namespace fs = std::filesystem;

class ThumbnailsTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void aPictureIsReadWholeAndScaledDown();
  void aLinkInAProjectIsNotFollowed();
  void aPipeIsNotWaitedFor();
  void paintingWaitsForNoDiskAndAChangedFileIsNoticed();

 private:
  QString at(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }
  QTemporaryDir folder_;
};

void ThumbnailsTest::init() {
  fs::create_directories(at("project/models").toStdString());
  QFile catalogue(at("project/catalogue.sqlite"));
  QVERIFY(catalogue.open(QIODevice::WriteOnly));
  QImage picture(400, 200, QImage::Format_RGB32);
  picture.fill(Qt::darkRed);
  QVERIFY(picture.save(at("private.png")));
  QVERIFY(picture.save(at("project/models/preview.png")));
}

void ThumbnailsTest::aPictureIsReadWholeAndScaledDown() {
  QCOMPARE(readWhole(at("project/models/preview.png")).size(), QSize(400, 200));
  QCOMPARE(readScaled(at("project/models/preview.png"), {100, 100}).size(), QSize(100, 50));
  QCOMPARE(readScaled(at("private.png"), {1000, 1000}).size(), QSize(400, 200));
}

void ThumbnailsTest::aLinkInAProjectIsNotFollowed() {
  const fs::path inside = at("project/linked.png").toStdString(),
                 outside = at("linked.png").toStdString(),
                 folder = at("project/results").toStdString();
  std::error_code there;
  fs::create_symlink(at("private.png").toStdString(), inside, there);
  fs::create_symlink(at("private.png").toStdString(), outside, there);
  fs::create_directory_symlink(folder_.path().toStdString(), folder, there);
  for (const char* name : {"project/linked.png", "project/results/private.png"}) {
    QVERIFY(readWhole(at(name)).isNull());
    QVERIFY(readScaled(at(name), {100, 100}).isNull());
  }
  QVERIFY2(!readWhole(at("linked.png")).isNull(), "a person's own");
}

void ThumbnailsTest::aPipeIsNotWaitedFor() {
  QCOMPARE(::mkfifo(at("pipe.png").toStdString().c_str(), 0600), 0);
  QVERIFY(readWhole(at("pipe.png")).isNull());
}

void ThumbnailsTest::paintingWaitsForNoDiskAndAChangedFileIsNoticed() {
  ThreadedJobRunner jobs;
  Thumbnails pictures(jobs);
  const QString file = at("project/models/preview.png");
  const auto shown = [&] {
    const QPixmap picture = pictures.get(file, {100, 100});
    return picture.isNull() ? QColor() : picture.toImage().pixelColor(5, 5);
  };
  const QSignalSpy ready(&pictures, &Thumbnails::ready);
  QVERIFY(!shown().isValid());
  QTRY_COMPARE(ready.count(), 1);
  QCOMPARE(shown(), QColor(Qt::darkRed));
  QImage other(400, 200, QImage::Format_RGB32);
  other.fill(Qt::darkGreen);
  QVERIFY(other.save(file));
  const fs::path path = file.toStdString();
  fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(2));
  QCOMPARE(shown(), QColor(Qt::darkRed));  // as it is known
  QTRY_COMPARE(ready.count(), 2);
  QCOMPARE(shown(), QColor(Qt::darkGreen));
  QVERIFY(QFile::remove(file));
  QCOMPARE(shown(), QColor(Qt::darkGreen));
  QTRY_COMPARE(ready.count(), 3);
  QVERIFY(!shown().isValid());
}

OSTRAKA_UI_TEST(ThumbnailsTest)

}  // namespace ostraka::ui

#include "thumbnails_test.moc"
