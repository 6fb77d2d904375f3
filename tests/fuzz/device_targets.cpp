#include <cmath>
#include <memory>

#include "must.h"
#include "targets.h"
#include "turntables/comxim.h"
#include "turntables/grbl.h"
#include "turntables/text_turntable.h"

namespace ostraka::fuzz {
namespace {

// Says the bytes, cut into pieces, whatever it is told; then it is silent.
class SayingChannel final : public devices::ByteChannel {
 public:
  SayingChannel(std::string_view bytes, std::shared_ptr<devices::Clock> clock)
      : bytes_(bytes), clock_(std::move(clock)) {}
  std::string name() const override { return "fuzz"; }
  Result<void> write(std::string_view) override { return {}; }
  Result<std::string> read(double timeout_s, std::stop_token stop) override {
    if (bytes_.empty()) {
      clock_->sleep(timeout_s > 0 ? timeout_s + 1e-6 : 0, stop);  // time passes
      return std::string();
    }
    std::string piece(bytes_.substr(0, 7));
    bytes_.remove_prefix(piece.size());
    clock_->sleep(0.01, stop);
    return piece;
  }
  Result<void> reopen(std::stop_token) override { return {}; }
  void close() override {}

 private:
  std::string_view bytes_;
  std::shared_ptr<devices::Clock> clock_;
};

class FuzzClock final : public devices::Clock {
 public:
  double now_s() override { return now_s_; }
  bool sleep(double seconds, std::stop_token) override {
    now_s_ += seconds;
    must(now_s_ < 1e5, "drivers give up in the end");
    return true;
  }

 private:
  double now_s_ = 0;
};

// An open table that was told to turn either stands there or says what is wrong.
void mustStandOrSay(const Result<std::unique_ptr<devices::Turntable>>& table) {
  mustNameItself(table);
  if (!table) return;
  mustNameItself((*table)->zeroHere({}));
  const Result<void> moved = (*table)->moveTo(45, {});
  mustNameItself(moved);
  if (moved)
    must(std::abs((*table)->position_deg().value_or(1e9) - 45) < 0.5,
         "arrived is where it was told");
}

}  // namespace

void deviceReplies(std::string_view bytes) {
  for (std::string_view rest = bytes; !rest.empty();) {
    const std::size_t end = rest.find_first_of("\n;");
    const std::string_view line = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    if (const auto report = turntables::parseGrblReport(line))
      must(!report->machine || std::isfinite(*report->machine), "positions are finite");
    (void)turntables::grblTrouble(line);
    for (const auto dialect :
         {turntables::ComXimDialect::Brackets, turntables::ComXimDialect::Commas})
      must(std::isfinite(turntables::parseComXimReply(line, dialect).angle_deg),
           "angles are finite");
  }
  const auto clock = std::make_shared<FuzzClock>();
  mustStandOrSay(
      turntables::openGrbl(std::make_unique<SayingChannel>(bytes, clock), {}, clock, {}));
  for (const auto dialect :
       {turntables::ComXimDialect::Brackets, turntables::ComXimDialect::Commas}) {
    turntables::ComXimOptions options;
    options.dialect = dialect;
    mustStandOrSay(
        turntables::openComXim(std::make_unique<SayingChannel>(bytes, clock), options, clock, {}));
  }
  mustStandOrSay(
      turntables::openTextTable(std::make_unique<SayingChannel>(bytes, clock), {}, clock, {}));
}

}  // namespace ostraka::fuzz
