#include "ui/capture/stop_board.h"

#include <QPainter>
#include <algorithm>

#include "batch/batch.h"
#include "ui/look/look.h"
#include "ui/look/state_colours.h"
#include "ui/widgets/thumbnails.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/side_progress.h"

namespace ostraka::ui {

StopBoard::StopBoard(const RigConnection* rig, const SideProgress* side, QWidget* parent)
    : QWidget(parent), rig_(rig), side_(side) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Photographs of this side"));
  setPalette(mattePalette());
}

QSize StopBoard::sizeHint() const {
  return {fontMetrics().height() * 28, fontMetrics().height() * 7};
}

void StopBoard::setThumbnails(Thumbnails* thumbnails) {
  thumbnails_ = thumbnails;
  if (thumbnails_ != nullptr)
    connect(thumbnails_, &Thumbnails::ready, this, qOverload<>(&QWidget::update));
}

void StopBoard::follow() {
  const PreparedPhotographs steps = side_->steps(rig_->source().stops);
  setAccessibleDescription((side_->prepared().total > 0
                                ? tr("%1 of %2 calibration photographs taken")
                                : tr("%1 of %2 positions done"))
                               .arg(steps.done)
                               .arg(steps.total));
  update();
}

void StopBoard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const double margin = fontMetrics().height();
  const double ring = std::min<double>(height() - 2 * margin, width() * 0.28);
  drawRing(painter, QRectF(margin, (height() - ring) / 2, ring, ring));
  drawShots(painter,
            QRectF(ring + 2 * margin, margin, width() - ring - 3 * margin, height() - 2 * margin));
}

void StopBoard::drawRing(QPainter& painter, const QRectF& ring) const {
  const StateColours colours(palette());
  const PreparedPhotographs steps = side_->steps(rig_->source().stops);
  const int stops = std::max(1, steps.total);
  const int current = side_->prepared().total > 0 ? steps.done : side_->currentStop();
  const double thick = ring.width() * 0.13;
  const QRectF arc = ring.adjusted(thick, thick, -thick, -thick);
  const double step = 360.0 / stops, gap = std::min(6.0, step / 4);
  for (int stop = 0; stop < stops; ++stop) {
    const bool done = stop < steps.done, now = stop == current;
    const QColor colour = done  ? colours.of(State::Sure)
                          : now ? colours.of(State::Busy)
                                : palette().color(QPalette::Dark);
    painter.setPen(QPen(colour, now || done ? thick : thick / 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawArc(arc, static_cast<int>(16 * (90 - stop * step - gap / 2)),
                    static_cast<int>(-16 * (step - gap)));
  }
  painter.setPen(palette().color(QPalette::Text));
  painter.setFont(scaledFont(*this, 2.2));
  painter.drawText(ring, Qt::AlignCenter, QStringLiteral("%1 / %2").arg(steps.done).arg(stops));
}

void StopBoard::drawShots(QPainter& painter, const QRectF& board) const {
  const int cameras = rig_->cameras(), stops = rig_->source().stops;
  if (cameras == 0 || board.width() < 20) return;
  const StateColours colours(palette());
  const double letter = fontMetrics().height() * 1.5;
  const double cell_width = (board.width() - letter) / stops;
  const double cell_height = std::min(cell_width * 0.75 + letter, board.height() / cameras);
  const double top = board.top() + (board.height() - cell_height * cameras) / 2;
  const double line = lineWidth(*this, 3), ratio = devicePixelRatioF();
  for (int camera = 0; camera < cameras; ++camera) {
    painter.setPen(palette().color(QPalette::Text));
    painter.setFont(scaledFont(*this, Look::kSection, true));
    painter.drawText(QRectF(board.left(), top + camera * cell_height, letter, cell_height),
                     Qt::AlignCenter, QString::fromStdString(batch::cameraLetter(camera)));
    for (int stop = 0; stop < stops; ++stop) {
      const QRectF cell = QRectF(board.left() + letter + stop * cell_width,
                                 top + camera * cell_height, cell_width, cell_height)
                              .adjusted(line, line, -line, -line);
      painter.setPen(QPen(palette().color(QPalette::Dark), 1));
      painter.drawRect(cell);
      const auto& shots = side_->shots();
      const auto shot = std::find_if(shots.begin(), shots.end(), [&](const TakenShot& taken) {
        return taken.camera == camera && taken.stop == stop;
      });
      if (shot == shots.end()) continue;
      const QPixmap picture = thumbnails_ == nullptr || shot->file.isEmpty()
                                  ? QPixmap()
                                  : thumbnails_->get(shot->file, (cell.size() * ratio).toSize());
      if (!picture.isNull()) {
        const QSizeF fit = QSizeF(picture.size()).scaled(cell.size(), Qt::KeepAspectRatio);
        painter.drawPixmap(QRectF(cell.center() - QPointF(fit.width(), fit.height()) / 2, fit),
                           picture, QRectF(picture.rect()));
      } else if (!shot->refused) {
        painter.setPen(colours.of(State::Sure));
        painter.drawText(cell, Qt::AlignCenter, QStringLiteral("✓"));
      }
      if (shot->problems.isEmpty()) continue;
      painter.setPen(QPen(colours.of(State::Failed), line));
      painter.drawRect(cell);
      painter.setFont(font());
      painter.fillRect(QRectF(cell.left(), cell.bottom() - letter, cell.width(), letter),
                       colours.behind(State::Failed));
      painter.drawText(QRectF(cell.left(), cell.bottom() - letter, cell.width(), letter),
                       Qt::AlignCenter, shot->problems.first());
    }
  }
}

}  // namespace ostraka::ui
