#pragma once
#include <filesystem>
#include <memory>

#include "devices/turntable.h"

namespace ostraka::turntables {

/// A table that remembers on disk where it stands. The target is written down before a move, the
/// place after it: when the program, the controller or the computer went down while the table stood
/// still, its position is known again without homing; when it went down in mid-move, it is not.
/// A controller that still counts is believed rather than the journal. journal: a file that may be
/// absent; where it cannot be written, the table is as forgetful as before.
/// Whoever turned the table by hand meanwhile is found out by the markers, as ever.
std::unique_ptr<devices::Turntable> rememberPosition(std::unique_ptr<devices::Turntable> table,
                                                     std::filesystem::path journal);

}  // namespace ostraka::turntables
