#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "devices/byte_channel.h"
#include "devices/clock.h"
#include "devices/turntable.h"

namespace ostraka::turntables {

struct GrblOptions {
  double speed_deg_s = 20;
  std::string shutter{};   ///< "M8", "M3" or "M62 P0"; empty: no output
  bool clockwise = false;  ///< the axis counts clockwise
};

/// A turntable on a GRBL 1.1 or FluidNC controller, degrees as its units on the X axis.
/// Targets are absolute, so that a repeated command never turns twice; arrival is what two status
/// reports say. Errors: Missing (no answer, or no GRBL).
Result<std::unique_ptr<devices::Turntable>> openGrbl(std::unique_ptr<devices::ByteChannel> channel,
                                                     const GrblOptions& options,
                                                     std::shared_ptr<devices::Clock> clock,
                                                     std::stop_token stop);

/// "<Idle|MPos:1.000,0,0|WCO:0,0,0>".
struct GrblReport {
  std::string state;              ///< "Idle", "Run", "Hold:0", ...
  std::optional<double> machine;  ///< X of MPos
  std::optional<double> work;     ///< X of WPos
  std::optional<double> offset;   ///< X of WCO
};
/// Nothing when the line is not one whole report.
std::optional<GrblReport> parseGrblReport(std::string_view line);
/// "ALARM:1" and "error:9" in words; nothing for other lines.
std::optional<Message> grblTrouble(std::string_view line);

}  // namespace ostraka::turntables
