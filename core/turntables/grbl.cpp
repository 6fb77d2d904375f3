#include "turntables/grbl.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "base/text.h"
#include "turntables/line_turntable.h"

namespace ostraka::turntables {
namespace {

constexpr double kReply_s = 1.0;    // a planned line is answered within milliseconds
constexpr double kBoot_s = 3.0;     // AVR boards restart when the line is opened
constexpr double kReport_s = 0.2;   // GRBL wants at most 5 questions a second
constexpr double kHoming_s = 90.0;  // silent until done
constexpr double kQuiet_s = 3.1;    // a reply that is later than this is not expected any more
constexpr int kMostSilences = 12;   // questions without an answer before the line counts as dead

enum class Reply { Ok, Refused, Lost, Restarted, Alarm };

struct Answer {
  Reply reply = Reply::Lost;
  Message words;  // of Refused and Alarm
};

class GrblTurntable final : public LineTurntable {
 public:
  GrblTurntable(std::unique_ptr<devices::ByteChannel> channel, GrblOptions options,
                std::shared_ptr<devices::Clock> clock)
      : LineTurntable({std::move(channel), std::move(clock), '\n'}, options.speed_deg_s,
                      options.clockwise),
        shutter_(std::move(options.shutter)) {}
  ~GrblTurntable() override { close(); }

  std::string name() const override { return "GRBL turntable at " + where_; }

  // Speaks to it until it answers as a GRBL.
  Result<void> connect(std::stop_token stop) override {
    for (const char* wake : {"\n", "\x18"}) {
      if (Result<void> r = line_.send(wake); !r) return r;
      const double deadline_s = now_s() + kBoot_s;
      bool asked = false;
      while (now_s() < deadline_s) {
        const auto heard = line_.next(0.5, stop);
        if (!heard) return heard.error();
        if (stop.stop_requested()) return Error::cancelled();
        if (*heard && isBanner(**heard)) return prepare(stop);
        if (*heard && (*heard)->starts_with("[VER:")) return prepare(stop);
        if (!*heard && !asked) {
          asked = true;
          if (Result<void> r = line_.send("$I\n"); !r) return r;
        }
      }
    }
    return Error::missing(
        message("The turntable does not answer like a GRBL controller; check that it is switched "
                "on and of this type."),
        where_);
  }

  Result<void> home(std::stop_token stop) override {
    if (!has_switch_) return Error::missing(message("The turntable has no zero switch."), where_);
    setPosition(std::nullopt);
    // An old 'ok' would pass for the end of a homing that never began: the line must be quiet.
    for (int k = 0; k < 10; ++k) {
      const auto heard = line_.next(kQuiet_s, stop);
      if (!heard) return heard.error();
      if (stop.stop_requested()) return Error::cancelled();
      if (!*heard) break;
    }
    const Result<Answer> answer = command("$H", kHoming_s, stop);
    if (!answer) return answer.error();
    if (Result<void> r = judge(*answer, message("It did not answer while homing.")); !r) return r;
    return zeroHere(stop);
  }

  Result<void> zeroHere(std::stop_token stop) override {
    const Result<GrblReport> report = settled(stop);
    if (!report) return report.error();
    if (report->state.starts_with("Alarm")) {  // where it is, we say
      const Result<Answer> unlocked = command("$X", kReply_s, stop);
      if (!unlocked) return unlocked.error();
      if (Result<void> r = judge(*unlocked, message("It did not unlock.")); !r) return r;
    }
    return count(0, stop);
  }

  Result<void> moveTo(double degrees, std::stop_token stop) override {
    if (Result<void> r = drain(); !r) return r;
    const Result<double> start = beginMove(degrees);
    if (!start) return start.error();
    if (std::abs(degrees - *start) <= tolerance_deg_) return standsAt(degrees, stop);
    const Result<void> moved = turn(*start, degrees, stop);
    if (!moved && moved.error().code != ErrorCode::Cancelled && position_deg() == *start)
      setPosition(std::nullopt);  // on its way, we do not know where
    return moved;
  }

  bool firesShutters() const override { return !shutter_.empty(); }
  Result<void> fireShutters(std::stop_token stop) override {
    Result<void> fired;
    for (const std::string& step : {shutterOn(), std::string("G4 P0.2")}) {
      const Result<Answer> answer = command(step, kReply_s, stop);
      if (!answer) return answer.error();
      fired = judge(*answer, message("It did not answer the shutter command."));
      if (!fired) break;
    }
    const Result<Answer> off = command(shutterOff(), kReply_s, {});
    if (!off) return off.error();
    return fired;
  }

  void close() override {
    if (closed_) return;
    closed_ = true;
    if (firesShutters()) (void)line_.send(shutterOff() + "\n");
    LineTurntable::close();
  }

 private:
  static bool isBanner(std::string_view line) {
    return line.starts_with("Grbl ") || line.find("for help]") != std::string_view::npos;
  }

  std::string shutterOn() const { return shutter_ == "M3" ? "M3 S1000" : shutter_; }
  std::string shutterOff() const {
    if (shutter_ == "M3") return "M5";
    if (shutter_.starts_with("M62")) return "M63" + shutter_.substr(3);
    return "M9";
  }

  // Units, and what the controller tells of itself.
  Result<void> prepare(std::stop_token stop) {
    if (Result<void> r = drain(); !r) return r;
    setPosition(std::nullopt);
    if (Result<void> r = line_.send("$$\n"); !r) return r;
    const double deadline_s = now_s() + 2 * kReply_s;
    while (now_s() < deadline_s) {
      const auto heard = line_.next(deadline_s - now_s(), stop);
      if (!heard) return heard.error();
      if (!*heard || **heard == "ok" || grblTrouble(**heard)) break;
      readSetting(**heard);
    }
    const Result<Answer> units = command("G21 G90 G94", kReply_s, stop);
    if (!units) return units.error();
    // Locked until homed or unlocked; said again before each turn.
    return {};
  }

  void readSetting(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (line.empty() || line[0] != '$' || equals == std::string_view::npos) return;
    const auto value = wholeText<double>(line.substr(equals + 1));
    if (!value) return;
    if (line.starts_with("$22=")) has_switch_ = *value > 0;
    // Bounded, since a garbled number must not make every place look like the target.
    if (line.starts_with("$100=") && *value > 0)
      tolerance_deg_ = std::clamp(1.5 / *value, 0.005, 0.1);
  }

  void overhear(const std::string& line) override {
    if (isBanner(line) || line.starts_with("ALARM:")) setPosition(std::nullopt);
  }

  Result<Answer> command(const std::string& text, double timeout_s, std::stop_token stop) {
    const bool known = position_deg().has_value();
    if (Result<void> r = drain(); !r) return r.error();
    if (known && !position_deg()) return Answer{Reply::Restarted, {}};  // it would turn elsewhere
    if (Result<void> r = line_.send(text + "\n"); !r) return r.error();
    return answer(timeout_s, std::move(stop));
  }

  Result<Answer> answer(double timeout_s, std::stop_token stop) {
    const double deadline_s = now_s() + timeout_s;
    while (true) {
      const auto heard = line_.next(std::min(0.1, std::max(0.0, deadline_s - now_s())), stop);
      if (!heard) return heard.error();
      if (*heard) {
        const std::string& line = **heard;
        if (line == "ok") return Answer{Reply::Ok, {}};
        if (isBanner(line)) {
          setPosition(std::nullopt);
          return Answer{Reply::Restarted, {}};
        }
        if (const auto trouble = grblTrouble(line)) {
          const bool alarm = line.starts_with("ALARM:");
          if (alarm) setPosition(std::nullopt);
          return Answer{alarm ? Reply::Alarm : Reply::Refused, *trouble};
        }
      }
      if (stop.stop_requested()) return Error::cancelled();
      if (now_s() >= deadline_s) return Answer{};
    }
  }

  Result<void> judge(const Answer& answer, const Message& when_lost) const {
    switch (answer.reply) {
      case Reply::Ok:
        return {};
      case Reply::Lost:
        return gone(when_lost);
      case Reply::Restarted:
        return Error::notEnough(
            message("The controller restarted; the turntable's position is unknown."), where_);
      default:
        return Error::failed(answer.words, where_);
    }
  }

  // One status report; nothing when none came in time.
  Result<std::optional<GrblReport>> ask(std::stop_token stop) {
    if (Result<void> r = line_.send("?"); !r) return r.error();
    const double deadline_s = now_s() + kReport_s;
    while (true) {
      const auto heard = line_.next(std::max(0.0, deadline_s - now_s()), stop);
      if (!heard) return heard.error();
      if (!*heard) return std::optional<GrblReport>();
      if (isBanner(**heard)) {
        setPosition(std::nullopt);
        return Error::notEnough(
            message("The controller restarted; the turntable's position is unknown."), where_);
      }
      if ((*heard)->starts_with("ALARM:")) {
        setPosition(std::nullopt);
        return Error::failed(*grblTrouble(**heard), where_);
      }
      if (auto report = parseGrblReport(**heard)) {
        if (report->offset) offset_ = *report->offset;
        return std::optional(std::move(*report));
      }
    }
  }

  std::optional<double> placeIn(const GrblReport& report) const {
    if (report.work) return sign_ * *report.work;
    if (report.machine) return sign_ * (*report.machine - offset_);
    return std::nullopt;
  }

  // A report of a table that stands still, whatever it did before.
  Result<GrblReport> settled(std::stop_token stop) {
    std::optional<GrblReport> before;
    int silences = 0;
    for (const double deadline_s = now_s() + kHoming_s; now_s() < deadline_s;) {
      const Result<std::optional<GrblReport>> report = ask(stop);
      if (!report) return report.error();
      if (stop.stop_requested()) return Error::cancelled();
      if (!*report) {
        if (++silences >= kMostSilences) return gone(message("The turntable does not answer."));
        continue;
      }
      silences = 0;
      const std::string& state = (*report)->state;
      const bool still = state == "Idle" || state.starts_with("Hold:0") ||
                         state.starts_with("Alarm") || state.starts_with("Sleep");
      if (still && before && before->state == state && placeIn(*before) == placeIn(**report))
        return **report;
      before = **report;
      if (!line_.clock().sleep(kReport_s, stop)) return Error::cancelled();
    }
    return gone(message("The turntable does not stop moving."));
  }

  // The place where it stands is this angle from now on.
  Result<void> count(double degrees, std::stop_token stop) {
    const Result<GrblReport> before = settled(stop);
    if (!before) return before.error();
    for (int again = 0; again < 3; ++again) {  // saying it twice changes nothing
      const Result<Answer> answer = command("G92 X" + fixed(sign_ * degrees, 3), kReply_s, stop);
      if (!answer) return answer.error();
      if (answer->reply != Reply::Ok && answer->reply != Reply::Lost) return judge(*answer, {});
      if (before->machine) offset_ = *before->machine - sign_ * degrees;
      const Result<GrblReport> now = settled(stop);
      if (!now) return now.error();
      const auto place = placeIn(*now);
      if (place && std::abs(*place - degrees) <= tolerance_deg_ &&
          (now->work || now->offset || answer->reply == Reply::Ok)) {
        setPosition(degrees);
        return {};
      }
    }
    return gone(message("The turntable does not accept its zero."));
  }

  Result<void> standsAt(double degrees, std::stop_token stop) {
    const Result<GrblReport> report = settled(stop);
    if (!report) return report.error();
    const auto place = placeIn(*report);
    if (report->state == "Idle" && place && std::abs(*place - degrees) <= tolerance_deg_) {
      setPosition(degrees);
      return {};
    }
    setPosition(std::nullopt);
    return lost();
  }

  // A restart whose message was lost shows in another count.
  Result<void> stillCounts(double start, std::stop_token stop) {
    const Result<std::optional<GrblReport>> report = ask(stop);
    if (!report) return report.error();
    const auto place = *report ? placeIn(**report) : std::nullopt;
    if (!place || (*report)->state != "Idle" || std::abs(*place - start) <= tolerance_deg_)
      return {};
    setPosition(std::nullopt);
    return Error::notEnough(
        message("The controller reset its count; the turntable's position is unknown."), where_);
  }

  Result<void> turn(double start, double target, std::stop_token stop) {
    if (Result<void> r = stillCounts(start, stop); !r) return r;
    const double patience = patience_s(target - start);
    double deadline_s = now_s() + patience;
    const std::string move = "G1 X" + fixed(sign_ * target, 3) + " F" + fixed(60 * speed_deg_s_, 3);
    int sent = 0, arrived = 0, resting = 0, silences = 0;
    bool must_send = true;
    while (true) {
      if (must_send) {
        must_send = false;
        ++sent;
        deadline_s = now_s() + patience;
        const Result<Answer> answer = command(move, kReply_s, stop);
        if (!answer) return answer.error().code == ErrorCode::Cancelled ? halt() : answer.error();
        if (answer->reply != Reply::Ok && answer->reply != Reply::Lost) return judge(*answer, {});
        if (answer->reply == Reply::Ok) {
          // Waits for an empty planner; only what the reports say counts.
          const Result<Answer> empty =
              command("G4 P0.05", std::max(0.1, deadline_s - now_s()), stop);
          if (!empty) return empty.error().code == ErrorCode::Cancelled ? halt() : empty.error();
          if (empty->reply == Reply::Restarted || empty->reply == Reply::Alarm)
            return judge(*empty, {});
        }
      }
      if (stop.stop_requested() || halt_) return halt();
      const Result<std::optional<GrblReport>> report = ask(stop);
      if (!report) return report.error();
      const std::optional<double> place = *report ? placeIn(**report) : std::nullopt;
      silences = *report ? 0 : silences + 1;
      if (silences >= kMostSilences) return gone(message("The turntable does not answer."));
      const bool idle = *report && (*report)->state == "Idle" && place;
      arrived = idle && std::abs(*place - target) <= tolerance_deg_ ? arrived + 1 : 0;
      resting =
          idle && arrived == 0 && std::abs(*place - start) <= tolerance_deg_ ? resting + 1 : 0;
      if (arrived >= 2) {
        setPosition(target);
        return {};
      }
      if (resting >= 3) {  // the command itself was lost; an absolute target may be said again
        if (sent >= 3) return gone(message("The turntable does not move."));
        resting = 0;
        must_send = true;
        continue;
      }
      if (now_s() > deadline_s) {
        (void)line_.send("!");
        setPosition(std::nullopt);
        return gone(message("The turntable did not arrive in time; it was stopped."));
      }
      if (!line_.clock().sleep(arrived > 0 ? kReport_s / 2 : kReport_s, stop)) return halt();
    }
  }

  // Feed hold, then a reset at standstill, which keeps the machine's count but not our zero.
  Result<void> halt() {
    if (Result<void> r = line_.send("!"); !r) return r;
    const Result<GrblReport> report = settled({});
    if (!report) return report.error();
    const std::optional<double> place = placeIn(*report);
    if (Result<void> r = line_.send("\x18"); !r) return r;
    for (const double deadline_s = now_s() + kBoot_s; now_s() < deadline_s;) {
      const auto heard = line_.next(0.2, {});
      if (!heard) return heard.error();
      if (*heard && isBanner(**heard)) break;
    }
    setPosition(std::nullopt);
    const Result<Answer> units = command("G21 G90 G94", kReply_s, {});
    if (!units) return units.error();
    if (place)
      if (Result<void> r = count(*place, {}); !r) return r;
    return Error::cancelled();
  }

  const std::string shutter_;
  bool has_switch_ = false;
  double tolerance_deg_ = 0.1;  // one and a half steps, as soon as the steps are known
  double offset_ = 0;           // machine count at our zero
  bool closed_ = false;
};

}  // namespace

Result<std::unique_ptr<devices::Turntable>> openGrbl(std::unique_ptr<devices::ByteChannel> channel,
                                                     const GrblOptions& options,
                                                     std::shared_ptr<devices::Clock> clock,
                                                     std::stop_token stop) {
  const std::string& shutter = options.shutter;
  if (!shutter.empty() && shutter != "M8" && shutter != "M7" && shutter != "M3" &&
      !shutter.starts_with("M62 P"))
    return Error::unusable(message("The shutter output must be M8, M7, M3 or M62 Pn."));
  if (!(options.speed_deg_s > 0)) return LineTurntable::noSpeed();  // before anything is said to it
  return LineTurntable::open(
      std::make_unique<GrblTurntable>(std::move(channel), options, std::move(clock)),
      std::move(stop));
}

}  // namespace ostraka::turntables
