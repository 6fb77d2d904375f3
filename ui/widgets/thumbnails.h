#pragma once
#include <QCache>
#include <QHash>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <QSize>
#include <QString>
#include <QTimer>

namespace ostraka::ui {

class JobRunner;

/// Small pictures of files, read in a job and kept; the window never waits for a disk. Of those
/// that are painted, the files' times are looked at in a job soon after.
class Thumbnails final : public QObject {
  Q_OBJECT

 public:
  explicit Thumbnails(JobRunner& runner, QObject* parent = nullptr);

  /// The picture within `size` device pixels, or a null pixmap: then it is being read, and ready
  /// follows unless the file cannot be read. Of a file that changed the picture before, until ready
  /// tells of the new one.
  QPixmap get(const QString& file, const QSize& size);

 signals:
  void ready(const QString& file);

 private:
  struct Asked {
    QString file;
    QSize size;
  };
  struct Kept {
    QPixmap picture;  ///< null: the file cannot be read
    qint64 changed_ms = 0;
  };
  void read(const QString& key, const Asked& asked);
  void lookForChanges();

  JobRunner& runner_;
  QCache<QString, Kept> kept_;
  QSet<QString> on_the_way_;
  QHash<QString, Asked> painted_;  ///< since the files' times were looked at
  QTimer look_;
};

/// The picture of a file as stored: an EXIF orientation is not applied, since outlines, masks and
/// poses are of the pixels as they stand in the file. HEIC and RAW too; null where it cannot be
/// read, and for a link in a project; for jobs.
QImage readWhole(const QString& file);

/// The picture of a file scaled down into `size`, read as cheaply as its format allows; for jobs.
QImage readScaled(const QString& file, const QSize& size);

}  // namespace ostraka::ui
