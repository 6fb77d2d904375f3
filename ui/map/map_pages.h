#pragma once
#include <QImage>
#include <QString>
#include <QVector>

#include "pipeline/plate_map.h"

class QPagedPaintDevice;
class QPainter;

namespace ostraka::ui {

/// What stands on the label of one sherd.
struct SherdLabel {
  QString number;   ///< "ARM1-T3-0012-0007", or "B0031-03" before it has its own
  QString context;  ///< "ARM1 / T3 / 0012, bag 4"; may be empty
  QString date;
  QString code;  ///< of the QR code
};

/// A plate with the photographs read, for screen and paper.
struct MapPicture {
  pipeline::PlateMap map;
  QImage front, back;  ///< null: the photograph is gone
};

/// Draws one side into a rectangle, marks and numbers on it; highlighted: the number in hand.
void paintMapSide(QPainter& painter, const QRectF& where, const pipeline::MapSide& side,
                  const QImage& photograph, const QString& highlighted);
/// The scale and place at which paintMapSide draws the photograph.
QRectF mapPlace(const QRectF& where, const pipeline::MapSide& side);

/// The map on the first page, labels of 62 x 29 mm in two columns on the following. Returns false
/// with a sentence when the printer or file refuses.
bool printMap(QPagedPaintDevice& device, const MapPicture& picture,
              const QVector<SherdLabel>& labels, const QString& title, QString* why);

}  // namespace ostraka::ui
