#pragma once
#include <QVector>

#include "ui/map/map_pages.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// The labels of a batch with what the catalogue knows of its sherds: number, place, and a code
/// with the end of the sherd's id. What has no number there yet keeps the batch's own; its label
/// leads to it all the same, also when it has one.
/// labels: one for each mark of the front side that has a number, in their order.
QVector<SherdLabel> withCatalogue(QVector<SherdLabel> labels, const pipeline::PlateMap& map,
                                  const catalogue::Catalogue& catalogue,
                                  const std::string& batch_number);

/// What the map shows of final numbers, from those labels.
MapNumbers mapNumbers(const QVector<SherdLabel>& labels, const pipeline::PlateMap& map,
                      const QString& batch_number);

/// A label for each bag of the project, by place, with the number of its sherds and who bagged
/// them: who entered the bag, else `initials`, of who prints. Read by the camera or a code reader
/// it gives a batch its context.
QVector<SherdLabel> bagLabels(const catalogue::Catalogue& catalogue, const QString& initials);

}  // namespace ostraka::ui
