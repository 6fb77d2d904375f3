#pragma once
#include <memory>
#include <string_view>

#include "devices/byte_channel.h"
#include "devices/clock.h"
#include "devices/turntable.h"

namespace ostraka::turntables {

enum class ComXimDialect {
  Brackets,  ///< "CT+TRUNSINGLE(1,45);": ComXim MT tables and their relatives
  Commas     ///< "+CT,TURNANGLE=45;": Revopoint dual axis tables
};

struct ComXimOptions {
  ComXimDialect dialect = ComXimDialect::Brackets;
  double speed_deg_s = 10;  ///< about; how long a turn may take at most follows from it
  bool clockwise = false;   ///< positive angles turn clockwise on this table
};

/// A table of this family. It turns by relative angles only, so that a command is never repeated:
/// after a lost reply the table is asked where it stands, and turned by the difference; one that
/// cannot tell has lost its position. Errors: Missing (no answer, or none of this family).
Result<std::unique_ptr<devices::Turntable>> openComXim(
    std::unique_ptr<devices::ByteChannel> channel, const ComXimOptions& options,
    std::shared_ptr<devices::Clock> clock, std::stop_token stop);

/// What a message of either dialect, without its semicolon, says.
struct ComXimReply {
  enum class Kind { Accepted, Arrived, Paused, Refused, Angle, Other } kind = Kind::Other;
  double angle_deg = 0;  ///< of Angle
  int error = 0;         ///< of Refused
};
ComXimReply parseComXimReply(std::string_view message, ComXimDialect dialect);

}  // namespace ostraka::turntables
