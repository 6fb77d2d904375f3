#pragma once
#include <QString>

#include "records/records.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// Where the sherds of a batch come from: "ARM1 / T3 / 0012 bag 4"; empty where nobody said.
QString placeWords(const catalogue::Catalogue& rows, const records::BatchRecord& batch);
/// With its number before it, for the line at the head: "B0004, ARM1 / T3 / 0012 bag 4".
QString batchWords(const catalogue::Catalogue& rows, const QString& number);

/// Bag, day and number of sherds counted, as far as they are known.
QString aboutBatch(const catalogue::Catalogue& rows, const records::BatchRecord& batch);

}  // namespace ostraka::ui
