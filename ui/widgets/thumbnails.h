#pragma once
#include <QCache>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <QSize>
#include <QString>

namespace ostraka::ui {

class JobRunner;

/// Small pictures of files, read in a job and kept; the window never waits for a disk.
class Thumbnails final : public QObject {
  Q_OBJECT

 public:
  explicit Thumbnails(JobRunner& runner, QObject* parent = nullptr);

  /// The picture within `size` device pixels, or a null pixmap: then it is being read, and ready
  /// follows unless the file cannot be read.
  QPixmap get(const QString& file, const QSize& size);

 signals:
  void ready(const QString& file);

 private:
  JobRunner& runner_;
  QCache<QString, QPixmap> kept_;
  QSet<QString> on_the_way_, unreadable_;
};

/// The picture of a file as stored: an EXIF orientation is not applied, since outlines, masks and
/// poses are of the pixels as they stand in the file. HEIC and RAW too; null where it cannot be
/// read, and for a link in a project; for jobs.
QImage readWhole(const QString& file);

/// The picture of a file scaled down into `size`, read as cheaply as its format allows; for jobs.
QImage readScaled(const QString& file, const QSize& size);

}  // namespace ostraka::ui
