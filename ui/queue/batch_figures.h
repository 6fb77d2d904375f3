#pragma once
#include <QString>
#include <optional>

#include "ui/queue/compute_batch.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// The figures that the queue shows of a batch outlive the window: they are kept in the catalogue.
std::optional<BatchFigures> keptFigures(const catalogue::Catalogue& rows, const QString& number);
/// Less what was photographed again, and the numbers that were given, since.
std::optional<BatchFigures> shownFigures(const catalogue::Catalogue& rows, const QString& number);
Result<void> keepFigures(catalogue::Catalogue& rows, const QString& number,
                         const BatchFigures& figures);

}  // namespace ostraka::ui
