#pragma once
#include <QVector>
#include <span>

#include "store/row.h"
#include "ui/map/map_pages.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// One sherd of a plate's front side.
struct PlateSherd {
  QString on_plate;  ///< its number on the plate: "03"
  SherdLabel label;  ///< what its label says, if it gets one
  bool has_final_number = false;
  bool is_void = false;
  bool is_taken_out = false;  ///< aside, or to be photographed again
  QString again;              ///< the number and batch that it was photographed again as
  /// Not what is void, nor what was taken out before it had its number.
  bool getsLabel() const {
    return !is_void && (has_final_number || (!is_taken_out && again.isEmpty()));
  }
};

/// The sherds of a map with what the catalogue knows of them: number, place, and a code with the
/// end of the sherd's id. What has no number there yet keeps the batch's own; its label leads to it
/// all the same, also when it has one.
/// catalogue: null where there is none. date: of the shooting.
QVector<PlateSherd> sherdsOnPlate(const review::PlateMap& map,
                                  const catalogue::Catalogue* catalogue,
                                  const QString& batch_number, const QString& date);

QVector<SherdLabel> labelsOf(const QVector<PlateSherd>& sherds);

/// What the map shows of their numbers.
MapNumbers mapNumbers(const QVector<PlateSherd>& sherds);

/// A label for each of these sherds that has a number and is not void, in their order, also where
/// no map shows them: those of a list, or renumbered by a merge.
QVector<SherdLabel> sherdLabels(const catalogue::Catalogue& catalogue,
                                std::span<const store::SherdRow> sherds);

/// A label for each bag of the project, by place, with the number of its sherds and who bagged
/// them: who entered the bag, else `initials`, of who prints. Read by the camera or a code reader
/// it gives a batch its context.
QVector<SherdLabel> bagLabels(const catalogue::Catalogue& catalogue, const QString& initials);

}  // namespace ostraka::ui
