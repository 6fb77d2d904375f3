#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"

namespace ostraka::store {

/// From this version of the schema on, pages carry checksums (page_checksums.h).
constexpr int kFirstCheckedVersion = 8;

enum class Pages { Checked, Plain };
/// What the first 100 bytes of a catalogue say before SQLite opens it. Refused as Damaged: an
/// empty file, one that is no database or another program's, one that nobody has made a catalogue
/// of yet, and a header whose parts contradict each other.
Result<Pages> lookAtHeader(const std::filesystem::path& file);

/// why: an English clause that ui/words knows.
Error damagedCatalogue(const std::string& why, const std::filesystem::path& file);

/// Rewrites a catalogue with plain pages as one with checksums, beside it, and renames. Nothing is
/// done where that was done already. Errors: another program has it open, the disk is full.
Result<void> addPageChecksums(const std::filesystem::path& file);

}  // namespace ostraka::store
