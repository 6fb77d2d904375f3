#include "turntables/hand_turntable.h"

#include <atomic>
#include <cmath>
#include <limits>

#include "base/message.h"

namespace ostraka::turntables {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

class HandTurntable final : public devices::Turntable {
 public:
  explicit HandTurntable(devices::AskPerson ask) : ask_(std::move(ask)) {}

  std::string name() const override { return "turned by hand"; }
  Result<void> home(std::stop_token stop) override { return turn(0, stop); }
  Result<void> zeroHere(std::stop_token) override {
    position_ = 0;
    return {};
  }
  Result<void> moveTo(double degrees, std::stop_token stop) override {
    if (position_ == degrees) return {};
    return turn(degrees, stop);
  }
  bool turnsItself() const override { return false; }
  void stopNow() override {}
  std::optional<double> position_deg() const override {
    const double now = position_;
    return std::isnan(now) ? std::nullopt : std::optional(now);
  }
  Result<void> reopen(std::stop_token) override { return {}; }
  void close() override {}

 private:
  Result<void> turn(double degrees, std::stop_token stop) {
    const long mark = std::lround(degrees - 360 * std::floor(degrees / 360)) % 360;
    position_ = kUnknown;
    if (!ask_ ||
        !ask_(
            message("Turn the turntable counter-clockwise to %1 degrees, then take your hand away.",
                    mark),
            stop))
      return Error::cancelled();
    position_ = degrees;
    return {};
  }

  devices::AskPerson ask_;
  std::atomic<double> position_ = kUnknown;
};

}  // namespace

std::unique_ptr<devices::Turntable> openHandTurntable(devices::AskPerson ask) {
  return std::make_unique<HandTurntable>(std::move(ask));
}

}  // namespace ostraka::turntables
