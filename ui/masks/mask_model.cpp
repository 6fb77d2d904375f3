#include "ui/masks/mask_model.h"

#include <QPainter>
#include <QUndoCommand>
#include <QUndoStack>
#include <algorithm>
#include <functional>
#include <utility>

#include "base/text.h"
#include "decisions/change_peoples_file.h"
#include "intake/settle_batch.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/look/look.h"
#include "ui/widgets/thumbnails.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

struct OpenedMasks {
  std::vector<decisions::MaskedPhotograph> photographs;
  std::vector<std::string> hashes;
  std::vector<decisions::MaskStroke> strokes;
};

Result<OpenedMasks> opened(const std::filesystem::path& output, const std::stop_token& stop) {
  auto photographs = decisions::maskedPhotographs(output);
  if (!photographs) return photographs.error();
  auto strokes = decisions::readMaskStrokes(output);
  if (!strokes) return strokes.error();
  std::vector<std::string> hashes;
  for (const decisions::MaskedPhotograph& p : *photographs) {
    if (stop.stop_requested()) return Error::cancelled();
    // Large files: only those are read of which there is something to tell.
    const bool asked = decisions::strokesOn(*strokes, p.side, p.camera, p.stop, {}).taken_again;
    hashes.push_back(asked ? decisions::photographHash(p.photograph) : std::string());
  }
  return OpenedMasks{std::move(*photographs), std::move(hashes), std::move(*strokes)};
}

Result<void> saved(ProjectSession* session, const std::string& batch,
                   const std::vector<decisions::MaskStroke>& before,
                   const std::vector<decisions::MaskStroke>& after,
                   const std::function<Result<void>()>& write) {
  if (session == nullptr || !session->hasProject()) return write();
  return intake::saveStrokes(session->project().catalogue(), batch, before, after,
                             session->provenance(), write);
}

QImage overlayOf(const QImage& mask) {
  QVector<QRgb> colours(256);
  QColor ink = photographInks().sherd;
  const int most = ink.alpha();
  for (int level = 0; level < 256; ++level) {
    ink.setAlpha(most * level / 255);
    colours[level] = ink.rgba();
  }
  QImage grey = mask.convertToFormat(QImage::Format_Grayscale8);
  QImage indexed(grey.constBits(), grey.width(), grey.height(),
                 static_cast<int>(grey.bytesPerLine()), QImage::Format_Indexed8);
  indexed.setColorTable(colours);
  return indexed.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

}  // namespace

/// A stroke as a value. What lies above it on the stack is undone first.
class StrokeCommand final : public QUndoCommand {
 public:
  StrokeCommand(MaskModel& model, decisions::MaskStroke stroke)
      : QUndoCommand(MaskModel::tr("paint on a mask")),
        model_(&model),
        session_(model.session_),
        output_(model.output_),
        stroke_(std::move(stroke)) {}
  void redo() override {
    if (stands_) return;
    stands_ = done(change([this](auto& strokes) { strokes.push_back(stroke_); }));
    setObsolete(!stands_);
  }
  // This very stroke, wherever it stands in the file.
  void undo() override {
    const Result<void> taken = change([this](auto& strokes) {
      const auto last = std::find(strokes.rbegin(), strokes.rend(), stroke_);
      if (last != strokes.rend()) strokes.erase(std::next(last).base());
    });
    stands_ = !done(taken);
    if (!stands_) return;
    // It stays, and is what can be taken back once there is room again.
    if (taken.error().code == ErrorCode::CannotWrite && session_)
      QMetaObject::invokeMethod(
          session_, [session = session_.data()] { session->undo().redo(); }, Qt::QueuedConnection);
    else
      setObsolete(true);
  }

 private:
  // The page may show another batch by now; the strokes stand in the file of theirs.
  template <class Change>
  Result<void> change(Change apply) {
    const bool shown = model_ && model_->output_ == output_;
    const std::string batch = output_.filename().string();
    const Result<void> written = decisions::changePeoplesFile(output_, [&]() -> Result<void> {
      auto strokes = decisions::readMaskStrokes(output_);
      if (!strokes) return strokes.error();
      const std::vector<decisions::MaskStroke> before = *strokes;
      apply(*strokes);
      return saved(session_, batch, before, *strokes, [&] {
        return shown ? model_->hold(*strokes) : decisions::writeMaskStrokes(output_, *strokes);
      });
    });
    if (!written) return written;
    if (model_ && !shown) model_->settle(session_, QString::fromStdString(batch));
    return written;
  }
  bool done(const Result<void>& changed) {
    if (!changed && model_) emit model_->failed(sentenceOf(changed.error()));
    return changed.has_value();
  }

  QPointer<MaskModel> model_;
  QPointer<ProjectSession> session_;
  std::filesystem::path output_;
  decisions::MaskStroke stroke_;
  bool stands_ = true;  ///< in the file; it was saved before the command was made
};

void MaskModel::close() {
  dropJob(job_);
  session_.clear();
  batch_.clear();
  output_.clear();
  photographs_.clear();
  hashes_.clear();
  strokes_.clear();
  index_ = -1;
  can_compute_ = false;
  photograph_ = found_overlay_ = overlay_ = {};
  emit changed();
}

void MaskModel::openBatch(ProjectSession& session, const QString& batch) {
  close();
  session_ = &session;
  batch_ = batch;
  output_ = session.folder() / "results" / batch.toStdString();
  job_ = session.jobs().start(
      makeJob([output = output_](Progress&, std::stop_token stop) { return opened(output, stop); }),
      this);
  whenDone<OpenedMasks>(job_, this, [this](const auto& masks) {
    if (!masks) return emit failed(sentenceOf(masks.error()));
    photographs_ = masks->photographs;
    hashes_ = masks->hashes;
    strokes_ = masks->strokes;
    compare();
    show(0);
  });
}

QString MaskModel::title(int index) const {
  const decisions::MaskedPhotograph& p = photographs_.at(static_cast<std::size_t>(index));
  const QString side = p.side == batch::Side::Front ? tr("front") : tr("back");
  const QString file = QString::fromStdString(p.photograph.filename().string());
  if (!file.startsWith(QLatin1String("cam"),
                       Qt::CaseInsensitive))  // by hand: as the camera named it
    return QStringLiteral("%1, %2").arg(side, file);
  return tr("%1, camera %2, position %3").arg(side).arg(QChar('A' + p.camera)).arg(p.stop + 1);
}

// Not those on a photograph that was taken again since: sherds may lie elsewhere now.
std::vector<decisions::MaskStroke> MaskModel::strokesOn(int index) const {
  const std::size_t i = static_cast<std::size_t>(index);
  const decisions::MaskedPhotograph& p = photographs_.at(i);
  return decisions::strokesOn(strokes_, p.side, p.camera, p.stop, hashes_.at(i)).holding;
}

bool MaskModel::isEdited(int index) const {
  return !strokesOn(index).empty();
}

int MaskModel::edited() const {
  int edited = 0;
  for (int i = 0; i < count(); ++i) edited += isEdited(i) ? 1 : 0;
  return edited;
}

Result<MaskModel::Shown> MaskModel::read(const decisions::MaskedPhotograph& photograph) {
  Shown shown{readWhole(QString::fromStdString(photograph.photograph.string())),
              readWhole(QString::fromStdString(photograph.mask.string())),
              decisions::photographHash(photograph.photograph)};
  for (const auto& [image, file] : {std::pair(&shown.photograph, &photograph.photograph),
                                    std::pair(&shown.overlay, &photograph.mask)})
    if (image->isNull())
      return Error{ErrorCode::Missing, "The picture cannot be read.", file->string()};
  shown.overlay = overlayOf(shown.overlay);
  return shown;
}

void MaskModel::show(int index) {
  if (!session_ || index < 0 || index >= count()) return;
  dropJob(job_);
  index_ = index;
  photograph_ = found_overlay_ = overlay_ = {};
  emit changed();
  job_ =
      session_->jobs().start(makeJob([photograph = photographs_[static_cast<std::size_t>(index)]](
                                         Progress&, std::stop_token) { return read(photograph); }),
                             this);
  whenDone<Shown>(job_, this, [this](const auto& shown) {
    if (!shown) return emit failed(sentenceOf(shown.error()));
    photograph_ = shown->photograph;
    found_overlay_ = shown->overlay;
    hashes_[static_cast<std::size_t>(index_)] = shown->hash;
    drawOverlay();
  });
}

void MaskModel::drawOverlay() {
  overlay_ = found_overlay_;
  if (overlay_.isNull()) return;
  QPainter painter(&overlay_);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const decisions::MaskStroke& s : strokesOn(index_)) {
    QPolygonF path;
    for (const Eigen::Vector2d& at : s.path_px) path << QPointF(at.x(), at.y());
    if (path.size() == 1) path << path.first() + QPointF(0.01, 0);  // a dot is drawn, too
    painter.setCompositionMode(s.paint == decisions::MaskPaint::Sherd
                                   ? QPainter::CompositionMode_Source
                                   : QPainter::CompositionMode_Clear);
    painter.setPen(
        QPen(photographInks().sherd, 2 * s.radius_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(path);
  }
  painter.end();
  emit overlayChanged();
}

// With what was computed; where that did not end, with the program's own masks.
void MaskModel::compare() {
  can_compute_ = std::filesystem::exists(output_ / "report.json")
                     ? decisions::masksWantComputing(output_)
                     : !strokes_.empty();
}

Result<void> MaskModel::hold(std::vector<decisions::MaskStroke> strokes) {
  if (const Result<void> done = decisions::writeMaskStrokes(output_, strokes); !done) return done;
  strokes_ = std::move(strokes);
  compare();
  if (index_ >= 0) drawOverlay();
  settle(session_, batch_);
  return {};
}

// The queue tells that the batch is to be computed again, also to who leaves without doing it.
void MaskModel::settle(ProjectSession* session, const QString& batch) {
  if (session == nullptr || !session->hasProject()) return;
  if (settling_) {
    settle_next_ = batch;
    return;
  }
  settling_ = session->jobs().start(
      makeJob([project = session->folder(), number = batch.toStdString(),
               person = session->initials().toStdString()](Progress&, std::stop_token) {
        return intake::settleByResults(project, number, person);
      }),
      session);
  connect(settling_, &JobHandle::finished, session,
          [this, self = QPointer(this), session, batch](const JobOutcome&) {
            session->tellBatchChanged(batch);
            if (!self) return;
            settling_->deleteLater();
            settling_.clear();
            if (!settle_next_.isEmpty()) settle(session, std::exchange(settle_next_, {}));
          });
}

void MaskModel::paint(decisions::MaskPaint paint, const QPolygonF& path, double radius_px) {
  if (!session_ || index_ < 0 || overlay_.isNull() || path.isEmpty()) return;
  const decisions::MaskedPhotograph& p = photographs_[static_cast<std::size_t>(index_)];
  decisions::MaskStroke stroke;
  stroke.side = p.side;
  stroke.camera = p.camera;
  stroke.stop = p.stop;
  stroke.paint = paint;
  stroke.radius_px = radius_px;
  for (const QPointF& at : path) stroke.path_px.emplace_back(at.x(), at.y());
  stroke.by = session_->initials().toStdString();
  stroke.at = utcNow();
  stroke.photograph = hashes_[static_cast<std::size_t>(index_)];
  std::vector<decisions::MaskStroke> strokes = strokes_;
  strokes.push_back(stroke);
  const auto before = strokes_;
  const auto write = [&] { return hold(strokes); };
  if (const auto done = saved(session_, batch_.toStdString(), before, strokes, write); !done)
    return emit failed(sentenceOf(done.error()));
  session_->undo().push(new StrokeCommand(*this, std::move(stroke)));
}

}  // namespace ostraka::ui
