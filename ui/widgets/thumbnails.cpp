#include "ui/widgets/thumbnails.h"

#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QImageReader>
#include <functional>

#include "batch/photograph.h"
#include "batch/raw_image.h"
#include "files/open_folder.h"
#include "files/output_place.h"
#include "ui/jobs/when_done.h"

namespace ostraka::ui {
namespace {

constexpr int kKept_kib = 64 * 1024;

// Of the formats that Qt does not read, or of which it reads the preview.
bool isCameras(const QString& file) {
  return batch::hasRawEnding(file.toStdString()) ||
         file.endsWith(QLatin1String(".heic"), Qt::CaseInsensitive) ||
         file.endsWith(QLatin1String(".heif"), Qt::CaseInsensitive);
}

// What a link in a project leads to is not the project's.
bool mayBeShown(const QString& file) {
  return checkNoLinkInProject(file.toStdString()).has_value();
}

QImage readByQt(const QString& file, const std::function<void(QImageReader&)>& prepare) {
  Result<OpenFile> open = OpenFile::open(file.toStdString());
  const Result<std::string> bytes = open ? open->readAll() : open.error();
  if (!bytes) return {};
  QByteArray content =
      QByteArray::fromRawData(bytes->data(), static_cast<qsizetype>(bytes->size()));
  QBuffer buffer(&content);
  buffer.open(QIODevice::ReadOnly);
  QImageReader reader(&buffer);
  reader.setAutoTransform(false);
  prepare(reader);
  return reader.read();
}

}  // namespace

QImage readWhole(const QString& file) {
  if (!mayBeShown(file)) return {};
  if (!isCameras(file))
    return readByQt(file, [](QImageReader& reader) {
      reader.setAllocationLimit(0);  // a photograph of 60 megapixels is usual here
    });
  const Result<cv::Mat> picture = batch::readPhotograph(file.toStdString());
  if (!picture) return {};
  return QImage(picture->data, picture->cols, picture->rows, static_cast<qsizetype>(picture->step),
                QImage::Format_BGR888)
      .copy();
}

QImage readScaled(const QString& file, const QSize& size) {
  if (!mayBeShown(file)) return {};
  QImage image = isCameras(file) ? readWhole(file) : readByQt(file, [&size](QImageReader& reader) {
    const QSize whole = reader.size();
    if (whole.isValid() && (whole.width() > size.width() || whole.height() > size.height()))
      reader.setScaledSize(whole.scaled(size, Qt::KeepAspectRatio));
  });
  if (!image.isNull() && (image.width() > size.width() || image.height() > size.height()))
    image = image.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  return image;
}

Thumbnails::Thumbnails(JobRunner& runner, QObject* parent)
    : QObject(parent), runner_(runner), kept_(kKept_kib) {}

QPixmap Thumbnails::get(const QString& file, const QSize& size) {
  // A batch that is computed anew writes other pictures under the same names.
  const QString key = QStringLiteral("%1@%2x%3@%4")
                          .arg(file)
                          .arg(size.width())
                          .arg(size.height())
                          .arg(QFileInfo(file).lastModified().toMSecsSinceEpoch());
  if (const QPixmap* kept = kept_.object(key)) return *kept;
  if (file.isEmpty() || on_the_way_.contains(key) || unreadable_.contains(key)) return {};
  on_the_way_.insert(key);
  JobHandle* job =
      runner_.start(makeJob([file, size](Progress&, std::stop_token) -> Result<QImage> {
                      return readScaled(file, size);
                    }),
                    this);
  whenDone<QImage>(job, this, [this, key, file](const auto& image) {
    on_the_way_.remove(key);
    if (!image || image->isNull()) {
      unreadable_.insert(key);
      return;
    }
    const auto cost = static_cast<int>(image->sizeInBytes() / 1024 + 1);
    kept_.insert(key, new QPixmap(QPixmap::fromImage(*image)), cost);
    emit ready(file);
  });
  return {};
}

}  // namespace ostraka::ui
