#pragma once
#include <string_view>

namespace ostraka::fuzz {

/// Each hands strange bytes to readers and stops the program when a promise of theirs is broken.
void ply(std::string_view bytes);
void json(std::string_view bytes);
void imageHeader(std::string_view bytes);
/// What a turntable answers, to all its drivers.
void deviceReplies(std::string_view bytes);
void table(std::string_view bytes);
void sherdJson(std::string_view bytes);
/// What people decided, down to what the chain makes of it.
void decisions(std::string_view bytes);

}  // namespace ostraka::fuzz
