#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "devices/byte_channel.h"
#include "devices/clock.h"
#include "devices/turntable.h"

namespace ostraka::turntables {

/// The words of a controller, so that most tables need no driver of their own. Commands hold
/// {target} or {by} (degrees, counter-clockwise) and {deg_min} or {deg_s} (the speed); replies are
/// regular expressions that a line has to contain. Empty: the controller has no such word.
struct TextDialect {
  Message name;                    ///< for people
  char end = '\n';                 ///< of commands and replies
  std::vector<std::string> begin;  ///< said after opening, one by one
  std::string move;                ///< with {target}, or {by} where it turns by steps only
  std::string still;               ///< accepted once the table stands still
  std::string home, zero, stop, query;
  std::string accepted, refused, restarted;
  std::string arrived;   ///< comes by itself at the end of a move, where there is no `still`
  std::string busy;      ///< "I am still at it": the patience begins anew
  std::string position;  ///< of the answer to `query`; its first group is the angle
  double reply_s = 2;
  Result<void> check() const;
};

/// Marlin 2: X counts in degrees.
TextDialect marlinDialect();
/// "marlin", or an object with the members of TextDialect. Errors: UnusableInput.
Result<TextDialect> dialectFromJson(const nlohmann::json& json);

struct TextTableOptions {
  TextDialect dialect = marlinDialect();
  double speed_deg_s = 20;
  bool clockwise = false;  ///< the controller counts clockwise
};

/// After a lost reply an absolute target is said again, which turns nothing twice; a table that
/// turns by steps is asked where it stands, and has lost its position when it cannot tell.
/// Errors: Missing (no answer).
Result<std::unique_ptr<devices::Turntable>> openTextTable(
    std::unique_ptr<devices::ByteChannel> channel, const TextTableOptions& options,
    std::shared_ptr<devices::Clock> clock, std::stop_token stop);

}  // namespace ostraka::turntables
