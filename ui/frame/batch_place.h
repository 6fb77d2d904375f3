#pragma once
#include <QString>
#include <filesystem>

#include "records/records.h"

namespace ostraka::catalogue {
class Catalogue;
}

namespace ostraka::ui {

/// Where the sherds of a batch come from: "ARM1 / T3 / 0012 bag 4"; empty where nobody said.
QString placeWords(const catalogue::Catalogue& rows, const records::BatchRecord& batch);
/// With its number before it, for the line at the head: "B0004, ARM1 / T3 / 0012 bag 4".
QString batchWords(const catalogue::Catalogue& rows, const QString& number);

/// Bag, day and number of sherds counted, as far as they are known, and whether it is invented.
QString aboutBatch(const catalogue::Catalogue& rows, const records::BatchRecord& batch);

/// A photograph of the front of a batch, by its folder: of the rig's highest camera, which sees
/// most of the plate, else the first; empty where there is none.
QString frontPicture(const std::filesystem::path& folder);

}  // namespace ostraka::ui
