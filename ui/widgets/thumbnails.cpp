#include "ui/widgets/thumbnails.h"

#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QImageReader>
#include <functional>
#include <utility>

#include "batch/photograph.h"
#include "files/open_folder.h"
#include "files/output_place.h"
#include "images/raw_image.h"
#include "ui/jobs/when_done.h"

namespace ostraka::ui {
namespace {

constexpr int kKept_kib = 64 * 1024;
constexpr int kLook_ms = 300;  // one look for all that was painted meanwhile

struct ReadPicture {
  QImage image;
  qint64 changed_ms = 0;
};

qint64 changedAt(const QString& file) {
  return QFileInfo(file).lastModified().toMSecsSinceEpoch();
}

// Of the formats that Qt does not read, or of which it reads the preview.
bool isCameras(const QString& file) {
  return images::hasRawEnding(file.toStdString()) ||
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
    : QObject(parent), runner_(runner), kept_(kKept_kib) {
  look_.setSingleShot(true);
  look_.setInterval(kLook_ms);
  connect(&look_, &QTimer::timeout, this, &Thumbnails::lookForChanges);
}

QPixmap Thumbnails::get(const QString& file, const QSize& size) {
  if (file.isEmpty()) return {};
  const QString key = QStringLiteral("%1@%2x%3").arg(file).arg(size.width()).arg(size.height());
  if (const Kept* kept = kept_.object(key)) {
    painted_.insert(key, {file, size});
    if (!look_.isActive()) look_.start();
    return kept->picture;
  }
  read(key, {file, size});
  return {};
}

void Thumbnails::read(const QString& key, const Asked& asked) {
  if (on_the_way_.contains(key)) return;
  on_the_way_.insert(key);
  JobHandle* job =
      runner_.start(makeJob([asked](Progress&, std::stop_token) -> Result<ReadPicture> {
                      const qint64 changed_ms = changedAt(asked.file);  // before, so never too late
                      return ReadPicture{readScaled(asked.file, asked.size), changed_ms};
                    }),
                    this);
  whenDone<ReadPicture>(job, this, [this, key, file = asked.file](const auto& done) {
    on_the_way_.remove(key);
    if (!done) return;
    const QImage& image = done->image;
    const bool told = kept_.contains(key) || !image.isNull();
    const auto cost = static_cast<int>(image.sizeInBytes() / 1024 + 1);
    kept_.insert(key, new Kept{QPixmap::fromImage(image), done->changed_ms}, cost);
    if (told) emit ready(file);
  });
}

// A batch that is computed anew writes other pictures under the same names.
void Thumbnails::lookForChanges() {
  const QHash<QString, Asked> painted = std::exchange(painted_, {});
  const auto work = [painted](Progress&, std::stop_token) -> Result<QHash<QString, qint64>> {
    QHash<QString, qint64> changed_ms;
    for (auto at = painted.begin(); at != painted.end(); ++at)
      changed_ms.insert(at.key(), changedAt(at->file));
    return changed_ms;
  };
  JobHandle* job = runner_.start(makeJob(work), this);
  whenDone<QHash<QString, qint64>>(job, this, [this, painted](const auto& changed_ms) {
    if (!changed_ms) return;
    for (auto at = painted.begin(); at != painted.end(); ++at)
      if (const Kept* kept = kept_.object(at.key());
          kept != nullptr && kept->changed_ms != changed_ms->value(at.key()))
        read(at.key(), *at);
  });
}

}  // namespace ostraka::ui
