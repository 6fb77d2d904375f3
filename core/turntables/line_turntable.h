#pragma once
#include <atomic>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "devices/conversation.h"
#include "devices/turntable.h"

namespace ostraka::turntables {

/// What all turntables share that are spoken to over a line.
class LineTurntable : public devices::Turntable {
 public:
  /// Finds out whether the right controller answers, and makes it ready. Errors: Missing.
  virtual Result<void> connect(std::stop_token stop) = 0;

  void stopNow() override { halt_ = true; }
  std::optional<double> position_deg() const override;
  Result<void> reopen(std::stop_token stop) override;
  void close() override { line_.channel().close(); }

  static Error noSpeed();
  /// The table, connected. Errors: UnusableInput (no speed), those of connect().
  static Result<std::unique_ptr<devices::Turntable>> open(std::unique_ptr<LineTurntable> table,
                                                          std::stop_token stop);

 protected:
  /// clockwise: positive angles turn clockwise on this table.
  LineTurntable(devices::Conversation line, double speed_deg_s, bool clockwise)
      : line_(std::move(line)),
        where_(line_.channel().name()),
        speed_deg_s_(speed_deg_s),
        sign_(clockwise ? -1 : 1) {}

  double now_s() { return line_.clock().now_s(); }
  /// For how long a turn by this angle is waited for.
  double patience_s(double by_deg) const;
  Error gone(const Message& what) const { return Error::missing(what, where_); }
  Error lost() const;
  void setPosition(std::optional<double> degrees);
  /// Where a move to this angle begins. Errors: no angle, position unknown.
  Result<double> beginMove(double degrees);
  /// Old replies mean nothing to the next command, but a restart does.
  Result<void> drain();
  virtual void overhear(const std::string&) {}

  devices::Conversation line_;
  const std::string where_;
  const double speed_deg_s_;
  const double sign_;
  std::atomic<bool> halt_ = false;

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::atomic<double> position_deg_ = kUnknown;
};

}  // namespace ostraka::turntables
