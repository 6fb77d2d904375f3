#include "turntables/comxim.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/message.h"
#include "base/text.h"
#include "turntables/line_turntable.h"

namespace ostraka::turntables {
namespace {

using Kind = ComXimReply::Kind;

constexpr double kComXimReply_s = 1.0;
constexpr double kBetween_s = 0.1;      // the tables want a pause between commands
constexpr double kTolerance_deg = 0.3;  // they turn to about a tenth
constexpr int kMostTurns = 3;           // a first one and two corrections

std::optional<double> numberIn(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto value = wholeText<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

class ComXimTurntable final : public LineTurntable {
 public:
  ComXimTurntable(std::unique_ptr<devices::ByteChannel> channel, const ComXimOptions& options,
                  std::shared_ptr<devices::Clock> clock)
      : LineTurntable({std::move(channel), std::move(clock), ';', "#"}, options.speed_deg_s,
                      options.clockwise),
        dialect_(options.dialect) {}
  ~ComXimTurntable() override { close(); }

  std::string name() const override { return "ComXim turntable at " + where_; }

  Result<void> connect(std::stop_token stop) override {
    setPosition(std::nullopt);
    bool answered = false;
    std::vector<std::string> greetings{"+QR,VERSION", "+QR,VERSION"};
    if (brackets()) greetings = {"CT+ACK(1)", "CT+EVENT(1)", "CT+HEARTBEAT(0)"};
    for (const std::string& greeting : greetings) {
      const Result<ComXimReply> reply = command(greeting, stop);
      if (!reply) return reply.error();
      answered = answered || reply->kind != Kind::Other || heard_;
    }
    if (!answered)
      return Error::missing(
          message("The turntable does not answer like a ComXim; check that it is switched on and "
                  "of this type."),
          where_);
    if (brackets()) {
      // Two spellings are about. An argument that is no number moves nothing: error 71 means that
      // the name was understood.
      const Result<ComXimReply> old = command("CT+TRUNSINGLE(a,0)", stop);
      if (!old) return old.error();
      if (!(old->kind == Kind::Refused && old->error == 71)) {
        const Result<ComXimReply> newer = command("CT+TURNSINGLE(a,0)", stop);
        if (!newer) return newer.error();
        new_spelling_ = newer->kind == Kind::Refused && newer->error == 71;
      }
    }
    const Result<std::optional<double>> angle = askAngle(stop);
    if (!angle) return angle.error();
    tells_angle_ = angle->has_value();
    return {};
  }

  Result<void> home(std::stop_token stop) override {
    halt_ = false;
    setPosition(std::nullopt);
    const Result<ComXimReply> reply = command(brackets() ? "CT+TOZERO()" : "+CT,TOZERO", stop);
    if (!reply) return reply.error();
    if (reply->kind == Kind::Refused) return refused(*reply);
    // At zero already it answers, but never arrives: the silence of a whole turn's time says so.
    const Result<bool> arrived = awaitArrival(patience_s(360), stop);
    if (!arrived) return arrived.error();
    if (tells_angle_) {
      const Result<std::optional<double>> angle = restingAngle(stop);
      if (!angle) return angle.error();
      if (!*angle || std::abs(std::remainder(**angle, 360)) > kTolerance_deg)
        return gone(message("The turntable did not reach its zero."));
      base_deg_ = **angle;
    } else if (!*arrived && reply->kind == Kind::Other) {
      return gone(message("The turntable does not answer."));
    }
    setPosition(0);
    return {};
  }

  Result<void> zeroHere(std::stop_token stop) override {
    if (tells_angle_) {
      const Result<std::optional<double>> angle = restingAngle(stop);
      if (!angle) return angle.error();
      if (!*angle) return gone(message("The turntable does not report its position."));
      base_deg_ = **angle;
    }
    setPosition(0);
    return {};
  }

  Result<void> moveTo(double degrees, std::stop_token stop) override {
    if (const Result<double> start = beginMove(degrees); !start) return start.error();
    for (int turn = 0; turn < kMostTurns; ++turn) {
      const double by = degrees - *position_deg();
      if (std::abs(by) <= (turn == 0 ? 0.005 : kTolerance_deg)) return {};
      if (Result<void> r = turnBy(by, stop); !r) return r;
      if (!tells_angle_) return {};
    }
    if (std::abs(degrees - *position_deg()) <= kTolerance_deg) return {};
    setPosition(std::nullopt);
    return Error::failed(
        message("The turntable does not reach its angle; check that nothing blocks it."), where_);
  }

 private:
  bool brackets() const { return dialect_ == ComXimDialect::Brackets; }
  Error refused(const ComXimReply& reply) const {
    return Error::failed(
        message("The turntable rejected a command (error %1): wrong turntable type or bad cable.",
                reply.error),
        where_);
  }
  // Sends it and gives the first reply of one of these kinds; Other: none came in time.
  Result<ComXimReply> ask(const std::string& text, std::initializer_list<Kind> wanted,
                          std::stop_token stop) {
    heard_ = false;
    if (!line_.clock().sleep(kBetween_s, stop)) return Error::cancelled();
    if (Result<void> r = drain(); !r) return r.error();
    if (Result<void> r = line_.send(text + ";"); !r) return r.error();
    for (const double deadline_s = now_s() + kComXimReply_s; now_s() < deadline_s;) {
      const auto heard = line_.next(deadline_s - now_s(), stop);
      if (!heard) return heard.error();
      if (stop.stop_requested()) return Error::cancelled();
      if (!*heard) break;
      const ComXimReply reply = parseComXimReply(**heard, dialect_);
      heard_ = heard_ || (*heard)->starts_with("CR+") || (*heard)->starts_with("+DATA") ||
               (*heard)->starts_with("+OK") || (*heard)->starts_with("+FAIL");
      if (std::find(wanted.begin(), wanted.end(), reply.kind) != wanted.end()) return reply;
    }
    return ComXimReply{};
  }

  Result<ComXimReply> command(const std::string& text, std::stop_token stop) {
    return ask(text, {Kind::Accepted, Kind::Refused}, stop);
  }

  // True: it said that it arrived. False: it said nothing.
  Result<bool> awaitArrival(double within_s, std::stop_token stop) {
    for (const double deadline_s = now_s() + within_s; now_s() < deadline_s;) {
      const auto heard = line_.next(std::min(0.2, deadline_s - now_s()), stop);
      if (!heard) return heard.error();
      if (stop.stop_requested() || halt_) return halt();
      if (!*heard) continue;
      const ComXimReply reply = parseComXimReply(**heard, dialect_);
      if (reply.kind == Kind::Arrived) return true;
      if (reply.kind == Kind::Paused) {
        setPosition(std::nullopt);
        return Error::failed(message("The turntable was paused with its own button."), where_);
      }
    }
    return false;
  }

  Result<std::optional<double>> askAngle(std::stop_token stop) {
    const Result<ComXimReply> reply = ask(brackets() ? "CT+GETOFFSETANGLE()" : "+QT,CHANGEANGLE",
                                          {Kind::Angle, Kind::Refused}, stop);
    if (!reply) return reply.error();
    if (reply->kind == Kind::Angle) return std::optional(sign_ * reply->angle_deg);
    return std::optional<double>();
  }

  // Two equal answers: it stands still. Nothing when it does not tell.
  Result<std::optional<double>> restingAngle(std::stop_token stop) {
    std::optional<double> before;
    int silences = 0;
    for (const double deadline_s = now_s() + patience_s(360); now_s() < deadline_s;) {
      const Result<std::optional<double>> angle = askAngle(stop);
      if (!angle) return angle.error().code == ErrorCode::Cancelled ? halt() : angle.error();
      if (!*angle && ++silences >= 5) break;
      if (!*angle) continue;
      silences = 0;
      if (before && std::abs(*before - **angle) < 0.02) return angle;
      before = *angle;
    }
    return std::optional<double>();
  }

  Result<void> turnBy(double by, std::stop_token stop) {
    const double start = *position_deg();
    setPosition(std::nullopt);
    const double way = sign_ * by;
    const std::string text =
        brackets() ? std::string(new_spelling_ ? "CT+TURNSINGLE(" : "CT+TRUNSINGLE(") +
                         (way > 0 ? "1," : "0,") + fixed(std::abs(way), 2) + ")"
                   : "+CT,TURNANGLE=" + fixed(way, 2);
    const Result<ComXimReply> reply = command(text, stop);
    if (!reply) return reply.error().code == ErrorCode::Cancelled ? haltAt() : reply.error();
    if (reply->kind == Kind::Refused) {
      setPosition(start);
      return refused(*reply);
    }
    const Result<bool> arrived = awaitArrival(patience_s(by), stop);
    if (!arrived) return arrived.error();
    if (tells_angle_) return readPosition(start + by, stop);
    if (!*arrived || reply->kind != Kind::Accepted)
      return Error::notEnough(
          message("A reply from the turntable was lost, and it cannot report its position: home "
                  "it or align it."),
          where_);
    setPosition(start + by);
    return {};
  }

  // The table tells its angle within a turn; `near` tells which turn.
  Result<void> readPosition(double near, std::stop_token stop) {
    const Result<std::optional<double>> angle = restingAngle(stop);
    if (!angle) return angle.error();
    if (!*angle) return gone(message("The turntable does not report its position."));
    const double within = **angle - base_deg_;
    setPosition(within + 360 * std::round((near - within) / 360));
    return {};
  }

  Error halt() {
    setPosition(std::nullopt);
    (void)line_.send(brackets() ? "CT+SETSTOP();" : "+CT,STOP;");
    return Error::cancelled();
  }
  Result<void> haltAt() { return halt(); }

  const ComXimDialect dialect_;
  bool new_spelling_ = false, tells_angle_ = false, heard_ = false;
  double base_deg_ = 0;  // what the table tells at our zero
};

}  // namespace

ComXimReply parseComXimReply(std::string_view message, ComXimDialect dialect) {
  ComXimReply reply;
  const auto errorAfter = [&](std::string_view start) {
    if (!message.starts_with(start)) return false;
    const auto code = numberIn(message.substr(start.size()));
    if (!code || std::abs(*code) > 9999) return false;
    reply.kind = Kind::Refused;
    reply.error = static_cast<int>(*code);
    return true;
  };
  const auto angleAfter = [&](std::string_view start) {
    const std::size_t at = message.find(start);
    if (at == std::string_view::npos) return false;
    const auto angle = numberIn(message.substr(at + start.size()));
    if (!angle || std::abs(*angle) > 1e6) return false;
    reply.kind = Kind::Angle;
    reply.angle_deg = *angle;
    return true;
  };
  if (dialect == ComXimDialect::Brackets) {
    if (!message.starts_with("CR+")) return reply;
    if (message == "CR+OK") reply.kind = Kind::Accepted;
    if (message == "CR+EVENT=TB_END") reply.kind = Kind::Arrived;
    if (message == "CR+EVENT=TB_PAUSE") reply.kind = Kind::Paused;
    if (reply.kind == Kind::Other && !errorAfter("CR+ERR=")) angleAfter("OffsetAngle=");
    return reply;
  }
  if (message == "+OK") reply.kind = Kind::Accepted;
  if (message.starts_with("+OK,TURNANGLE=")) reply.kind = Kind::Arrived;
  if (reply.kind == Kind::Other && !errorAfter("+FAIL,ERR=") && message.starts_with("+DATA="))
    angleAfter("+DATA=");
  return reply;
}

Result<std::unique_ptr<devices::Turntable>> openComXim(
    std::unique_ptr<devices::ByteChannel> channel, const ComXimOptions& options,
    std::shared_ptr<devices::Clock> clock, std::stop_token stop) {
  return LineTurntable::open(
      std::make_unique<ComXimTurntable>(std::move(channel), options, std::move(clock)),
      std::move(stop));
}

}  // namespace ostraka::turntables
