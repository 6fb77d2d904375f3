#pragma once
#include <QHash>
#include <QImage>
#include <QPolygonF>
#include <QSet>
#include <QString>
#include <QVector>
#include <vector>

#include "review/plate_map.h"

class QPagedPaintDevice;
class QPainter;

namespace ostraka::ui {

/// What stands on the label of one sherd.
struct SherdLabel {
  QString number;   ///< "ARM1-T3-0012-0007", or "B0031-03" before it has its own
  QString context;  ///< "ARM1 / T3 / 0012, bag 4"; may be empty
  QString date;
  QString code;           ///< of the QR code
  QString contents = {};  ///< of a bag: "8 sherds, AP"; beside the date
};

/// Final numbers of the sherds on a plate, as short as they tell each other apart.
struct MapNumbers {
  QString common;                   ///< what most begin with: "ARM1-T3-0012-"; may be empty
  QHash<QString, QString> endings;  ///< by the plate's own number: "03" -> "0007"
  QSet<QString> shortened;          ///< those whose ending stands for a number with `common`
  QHash<QString, QString> again;    ///< of pieces photographed again since: number and batch
  QSet<QString> voided;             ///< the plate's own numbers of sherds that are void
  /// On the picture: the ending; in brackets the plate's own where there is no final number yet.
  QString shown(const QString& plate_number) const;
  QString whole(const QString& plate_number) const;
};

/// A plate with the photographs read, for screen and paper.
struct MapPicture {
  review::PlateMap map;
  QImage front, back;  ///< null: the photograph is gone
  MapNumbers numbers = {};
};

/// What stands on the map at a mark: its number, and what is to be known before the piece is
/// bagged.
QString wordsOf(const review::MapMark& mark, const MapNumbers& numbers);

/// A number on the map: how large it is written, where its sherd's middle lies, the sherd.
struct NumberToPlace {
  QSizeF size;
  QPointF at;
  QPolygonF outline;
};
/// Where the numbers go: on their sherds or, where these are small or crowded, beside them. None
/// covers another, or another's sherd, as long as there is room.
std::vector<QRectF> placeNumbers(const std::vector<NumberToPlace>& numbers, const QRectF& within);

/// Draws one side into a rectangle, marks and numbers on it; highlighted: the number in hand.
void paintMapSide(QPainter& painter, const QRectF& where, const review::MapSide& side,
                  const QImage& photograph, const MapNumbers& numbers, const QString& highlighted);
/// The scale and place at which paintMapSide draws the photograph.
QRectF mapPlace(const QRectF& where, const review::MapSide& side);

/// The map on the first page, labels of 85 x 32 mm side by side on the following. Returns false
/// with a sentence when the printer or file refuses.
bool printMap(QPagedPaintDevice& device, const MapPicture& picture,
              const QVector<SherdLabel>& labels, const QString& title, QString* why);

/// One label; per_mm: the painter's units in a millimetre.
void paintLabel(QPainter& painter, const QRectF& where, const SherdLabel& label, double per_mm);

/// Labels alone, from the first page on.
bool printLabels(QPagedPaintDevice& device, const QVector<SherdLabel>& labels, QString* why);

}  // namespace ostraka::ui
