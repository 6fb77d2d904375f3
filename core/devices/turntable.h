#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "base/result.h"

namespace ostraka::devices {

/// Tells a person to do something at the rig ("Turn the table to 90 degrees.") and waits; false
/// when they would rather stop.
using AskPerson = std::function<bool(const Message& sentence, std::stop_token stop)>;

/// A turntable. Degrees, since that is what every controller speaks; counter-clockwise seen from
/// above, and counted on past 360: after a whole turn the table does not wind back.
/// Calls come from one thread at a time, except stopNow() and position_deg(), from any.
/// Errors name the device; Missing means unplugged or silent: reopen() may bring it back.
class Turntable {
 public:
  virtual ~Turntable() = default;

  virtual std::string name() const = 0;  ///< for people: "GRBL 1.1h at usb 1209:0001"

  /// Goes to the table's own zero; the position is known from then on. Tables without a switch
  /// answer Missing: align by eye and call zeroHere().
  virtual Result<void> home(std::stop_token stop) = 0;
  /// The present place becomes zero.
  virtual Result<void> zeroHere(std::stop_token stop) = 0;

  /// Turns to an absolute angle and returns when the table has arrived and stands still: 'accepted'
  /// is not 'arrived'. Calling it again with the same angle never turns twice. NotEnough: the
  /// position is not known (home first). Cancelled leaves the table standing.
  virtual Result<void> moveTo(double degrees, std::stop_token stop) = 0;
  /// False: a person turns it, and is asked for nothing that is not needed.
  virtual bool turnsItself() const { return true; }
  /// Stops the table at once.
  virtual void stopNow() = 0;

  /// Where it stands; nothing after a restart, an alarm or a move that broke off, until home(),
  /// zeroHere() or an answer of the device says where it is.
  virtual std::optional<double> position_deg() const = 0;

  /// An output of the controller that fires the shutters of all cameras.
  virtual bool firesShutters() const { return false; }
  virtual Result<void> fireShutters(std::stop_token) { return {}; }

  /// After Missing: finds the same device again and asks it where it stands.
  virtual Result<void> reopen(std::stop_token stop) = 0;
  /// Outputs off, the line given back. Again: nothing happens.
  virtual void close() = 0;
};

}  // namespace ostraka::devices
