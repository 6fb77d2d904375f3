#include "turntables/line_turntable.h"

#include <cmath>

#include "base/message.h"

namespace ostraka::turntables {

std::optional<double> LineTurntable::position_deg() const {
  const double now = position_deg_;
  return std::isnan(now) ? std::nullopt : std::optional(now);
}

void LineTurntable::setPosition(std::optional<double> degrees) {
  position_deg_ = degrees.value_or(kUnknown);
}

Result<void> LineTurntable::reopen(std::stop_token stop) {
  setPosition(std::nullopt);
  if (Result<void> r = line_.channel().reopen(stop); !r) return r;
  line_.forget();
  return connect(std::move(stop));
}

double LineTurntable::patience_s(double by_deg) const {
  return 1.5 * std::abs(by_deg) / speed_deg_s_ + 3;
}

Error LineTurntable::lost() const {
  return Error::notEnough(message("The turntable's position is unknown: home it or align it."),
                          where_);
}

Error LineTurntable::noSpeed() {
  return Error::unusable(message("The turntable's speed must be greater than 0."));
}

Result<double> LineTurntable::beginMove(double degrees) {
  halt_ = false;
  if (!std::isfinite(degrees))
    return Error::unusable(message("The angle is not a number."), where_);
  const std::optional<double> start = position_deg();
  if (!start) return lost();
  return *start;
}

Result<void> LineTurntable::drain() {
  for (int k = 0; k < 1000; ++k) {
    const auto heard = line_.waiting();
    if (!heard) return heard.error();
    if (!*heard) return {};
    overhear(**heard);
  }
  return {};
}

Result<std::unique_ptr<devices::Turntable>> LineTurntable::open(
    std::unique_ptr<LineTurntable> table, std::stop_token stop) {
  if (!(table->speed_deg_s_ > 0)) return noSpeed();
  if (Result<void> r = table->connect(std::move(stop)); !r) return r.error();
  return std::unique_ptr<devices::Turntable>(std::move(table));
}

}  // namespace ostraka::turntables
