#pragma once
#include <filesystem>

#include "base/result.h"

namespace ostraka::store {

/// Looks at the first 100 bytes of a catalogue before SQLite opens it. Refused as Damaged: an
/// empty file, one that is no database or another program's, one that nobody has made a catalogue
/// of yet, a header whose parts contradict each other, and a backup beside a WAL (hasWalOfAnother).
Result<void> checkHeader(const std::filesystem::path& file);

/// A backup was put in the place of a catalogue whose WAL was left: SQLite would write the newer
/// pages into the older file. False of a file that cannot be read.
bool hasWalOfAnother(const std::filesystem::path& file);

/// why: a clause, without a capital letter or full stop.
Error damagedCatalogue(const Message& why, const std::filesystem::path& file);

/// Where a repair puts the whole catalogue before it removes the WAL and replaces the damaged file.
/// While it lies there, it alone is the catalogue: the repair that was interrupted is to be ended.
std::filesystem::path repairedBeside(const std::filesystem::path& file);

}  // namespace ostraka::store
