#include "turntables/text_turntable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "base/message.h"
#include "base/text.h"
#include "files/json_numbers.h"
#include "turntables/line_turntable.h"

namespace ostraka::turntables {
namespace {

std::string filledIn(std::string text, const std::string& name, double value) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name))
    text.replace(at, name.size(), fixed(value, 3));
  return text;
}

class TextTurntable final : public LineTurntable {
  static constexpr double kTolerance_deg = 0.1;
  static constexpr int kTries = 3;
  static constexpr double kHoming_s = 60;
  static constexpr double kBoot_s = 3;
  static constexpr double kTrail_s = 0.3;  // within which the end of an answer follows it

  enum class Answer { Accepted, Arrived, Refused, Restarted, Lost };

 public:
  TextTurntable(std::unique_ptr<devices::ByteChannel> channel, const TextTableOptions& options,
                std::shared_ptr<devices::Clock> clock)
      : LineTurntable({std::move(channel), std::move(clock), options.dialect.end},
                      options.speed_deg_s, options.clockwise),
        words_(options.dialect),
        accepted_(words_.accepted),
        refused_(words_.refused),
        restarted_(words_.restarted),
        arrived_(words_.arrived),
        busy_(words_.busy),
        place_(words_.position) {}
  ~TextTurntable() override { close(); }
  TextTurntable(const TextTurntable&) = delete;
  TextTurntable& operator=(const TextTurntable&) = delete;

  // Many boards restart when their line is opened, and hear nothing meanwhile. What they say then
  // is no answer to anything; the first command has to be understood.
  Result<void> connect(std::stop_token stop) override {
    setPosition(std::nullopt);
    saw_restart_ = false;
    for (double end_s = now_s() + kBoot_s; !words_.restarted.empty() && now_s() < end_s;) {
      const auto heard = line_.next(end_s - now_s(), stop);
      if (!heard) return heard.error();
      if (stop.stop_requested()) return Error::cancelled();
      if (*heard && isRestart(**heard)) end_s = std::min(end_s, now_s() + kTrail_s);
    }
    for (int k = 0; k < kTries; ++k) {
      if (Result<void> r = drain(); !r) return r;
      Result<Answer> answer = Answer::Accepted;
      for (const std::string& command : words_.begin) {
        answer = say(command, words_.reply_s, stop);
        if (!answer) return answer.error();
        if (*answer != Answer::Accepted) break;
      }
      if (*answer == Answer::Accepted) return {};
    }
    return gone(message("The turntable does not answer as a %1; check its type.", words_.name));
  }

  std::string name() const override { return words_.name.english() + " at " + where_; }

  Result<void> home(std::stop_token stop) override {
    halt_ = false;
    if (words_.home.empty())
      return gone(message("This turntable has no zero switch: align it by eye."));
    setPosition(std::nullopt);
    if (Result<void> r = obey(words_.home, kHoming_s, stop); !r) return r;
    if (!words_.still.empty())
      if (Result<void> r = obey(words_.still, kHoming_s, stop); !r) return r;
    return zeroHere(std::move(stop));
  }

  Result<void> zeroHere(std::stop_token stop) override {
    halt_ = false;
    if (!words_.zero.empty())
      if (Result<void> r = obey(words_.zero, words_.reply_s, std::move(stop)); !r) return r;
    setPosition(0);
    return {};
  }

  Result<void> moveTo(double degrees, std::stop_token stop) override {
    const Result<double> start = beginMove(degrees);
    if (!start) return start.error();
    if (*start == degrees) return {};
    setPosition(std::nullopt);  // until it has arrived
    Result<void> turned = turn(*start, degrees, stop);
    if (turned)
      setPosition(degrees);
    else if (turned.error().code == ErrorCode::Missing)
      findOut({});
    return turned;
  }

  // A line that was only cut leaves the controller counting; it is asked.
  Result<void> reopen(std::stop_token stop) override {
    halt_ = false;
    if (Result<void> r = line_.channel().reopen(stop); !r) return r;
    line_.forget();
    if (Result<void> r = connect(stop); !r) return r;
    findOut(std::move(stop));
    return {};
  }

 private:
  bool turnsBySteps() const { return words_.move.find("{by}") != std::string::npos; }
  static bool says(const std::string& line, const std::string& word, const std::regex& regex) {
    return !word.empty() && std::regex_search(line, regex);
  }

  bool isRestart(const std::string& line) {
    if (!says(line, words_.restarted, restarted_)) return false;
    saw_restart_ = true;
    setPosition(std::nullopt);
    return true;
  }

  void overhear(const std::string& line) override { (void)isRestart(line); }

  Result<Answer> say(const std::string& command, double patience_s, std::stop_token stop) {
    if (Result<void> r = drain(); !r) return r.error();
    if (Result<void> r = line_.send(command + words_.end); !r) return r.error();
    return hear(patience_s, std::move(stop));
  }

  Result<Answer> hear(double patience_s, std::stop_token stop) {
    double deadline_s = now_s() + patience_s;
    while (true) {
      const auto heard = line_.next(std::min(0.1, std::max(0.0, deadline_s - now_s())), stop);
      if (!heard) return heard.error();
      if (*heard) {
        const std::string& line = **heard;
        if (isRestart(line)) return Answer::Restarted;
        if (says(line, words_.refused, refused_)) {
          complaint_ = line;
          return Answer::Refused;
        }
        if (says(line, words_.arrived, arrived_)) return Answer::Arrived;
        if (says(line, words_.accepted, accepted_)) return Answer::Accepted;
        if (says(line, words_.busy, busy_)) deadline_s = now_s() + patience_s;
      }
      if (stop.stop_requested() || halt_) return halted();
      if (now_s() >= deadline_s) return Answer::Lost;
    }
  }

  Error halted() {
    if (!words_.stop.empty()) (void)line_.send(words_.stop + words_.end);
    return Error::cancelled();
  }

  Error trouble(Answer answer) const {
    if (answer == Answer::Restarted)
      return Error::notEnough(
          message("The controller restarted; the turntable's position is unknown."), where_);
    if (answer == Answer::Refused)
      return Error::failed(message("The turntable rejects the command: %1.", complaint_), where_);
    return gone(message("The turntable does not answer."));
  }

  // Only for commands that may be said twice.
  Result<void> obey(const std::string& command, double patience_s, std::stop_token stop) {
    Answer last = Answer::Lost;
    for (int k = 0; k < kTries && last == Answer::Lost; ++k) {
      const Result<Answer> answer = say(command, patience_s, stop);
      if (!answer) return answer.error();
      last = *answer;
    }
    if (last == Answer::Accepted || last == Answer::Arrived) return {};
    return trouble(last);
  }

  Result<void> turn(double start, double target, std::stop_token stop) {
    const double patience = patience_s(target - start);
    std::string move = filledIn(words_.move, "{target}", sign_ * target);
    move = filledIn(move, "{by}", sign_ * (target - start));
    move = filledIn(move, "{deg_min}", 60 * speed_deg_s_);
    move = filledIn(move, "{deg_s}", speed_deg_s_);
    Result<Answer> answer = say(move, words_.reply_s, stop);
    for (int k = 1; k < kTries && answer && *answer == Answer::Lost && !turnsBySteps(); ++k)
      answer = say(move, words_.reply_s, stop);
    if (!answer) return answer.error();
    if (*answer != Answer::Accepted && *answer != Answer::Arrived) return trouble(*answer);
    if (!words_.still.empty()) {
      if (Result<void> r = obey(words_.still, patience, stop); !r) return r;
    } else if (!words_.arrived.empty() && *answer != Answer::Arrived) {
      answer = hear(patience, stop);
      if (!answer) return answer.error();
      if (*answer != Answer::Arrived) return trouble(*answer);
    } else if (words_.arrived.empty() && !line_.clock().sleep(patience, stop)) {
      return halted();
    }
    if (words_.query.empty()) return {};
    const Result<std::optional<double>> place = ask(stop);
    if (!place) return place.error();
    if (*place && std::abs(**place - target) > kTolerance_deg)
      return gone(message("The turntable is at %1 degrees instead of %2.", decimal(**place, 3),
                          decimal(target, 3)));
    return {};
  }

  Result<std::optional<double>> ask(std::stop_token stop) {
    for (int k = 0; k < kTries; ++k) {
      if (Result<void> r = drain(); !r) return r.error();
      if (Result<void> r = line_.send(words_.query + words_.end); !r) return r.error();
      for (const double deadline_s = now_s() + words_.reply_s; now_s() < deadline_s;) {
        const auto heard = line_.next(deadline_s - now_s(), stop);
        if (!heard) return heard.error();
        if (stop.stop_requested()) return Error::cancelled();
        if (!*heard) break;
        if (isRestart(**heard)) return trouble(Answer::Restarted);
        std::smatch found;
        if (!std::regex_search(**heard, found, place_) || found.size() < 2) continue;
        const std::string digits = found[1].str();
        double place = 0;
        if (std::from_chars(digits.data(), digits.data() + digits.size(), place).ec != std::errc())
          continue;
        // Its "ok" must not be taken for that of the next command.
        if (const Result<Answer> rest = hear(kTrail_s, stop); !rest) return rest.error();
        return std::optional(sign_ * place);
      }
    }
    return std::optional<double>();
  }

  // Two equal answers: it stands there.
  void findOut(std::stop_token stop) {
    if (words_.query.empty() || saw_restart_) return;
    std::optional<double> before;
    for (int k = 0; k < 2 * kTries; ++k) {
      const Result<std::optional<double>> place = ask(stop);
      if (!place || !*place) return;
      if (before && std::abs(*before - **place) < 1e-6) {
        setPosition(**place);
        return;
      }
      before = *place;
      if (!line_.clock().sleep(0.5, stop)) return;
    }
  }

  const TextDialect words_;
  std::regex accepted_, refused_, restarted_, arrived_, busy_, place_;
  std::string complaint_;
  bool saw_restart_ = false;
};

}  // namespace

TextDialect marlinDialect() {
  TextDialect marlin;
  marlin.name = message("Marlin controller");
  marlin.begin = {"G21", "G90"};
  marlin.move = "G0 X{target} F{deg_min}";
  marlin.still = "M400";
  marlin.home = "G28 X";
  marlin.zero = "G92 X0";
  marlin.stop = "M410";
  marlin.query = "M114";
  marlin.accepted = "^ok";
  marlin.refused = "^(Error|error|!!)";
  marlin.restarted = "^(start|Marlin )";
  marlin.busy = "busy:";
  marlin.position = "^X: ?(-?[0-9.]+)";
  return marlin;
}

Result<void> TextDialect::check() const {
  if (move.find("{target}") == std::string::npos && move.find("{by}") == std::string::npos)
    return Error::unusable(
        message("The turntable's dialect: 'move' must contain {target} or {by}."));
  if (accepted.empty())
    return Error::unusable(
        message("The turntable's dialect: 'accepted' must describe its answer."));
  if (query.empty() != position.empty())
    return Error::unusable(
        message("The turntable's dialect: 'query' and 'position' must be given together."));
  if (!(reply_s > 0))
    return Error::unusable(message("The turntable's dialect: 'reply_s' must be greater than 0."));
  for (const std::string& word : {accepted, refused, restarted, arrived, busy, position}) try {
      const std::regex regex(word);
    } catch (const std::regex_error&) {
      return Error::unusable(
          message("The turntable's dialect: '%1' is not a regular expression.", word));
    }
  if (!position.empty() && std::regex(position).mark_count() < 1)
    return Error::unusable(
        message("The turntable's dialect: 'position' needs a group for the angle."));
  return {};
}

Result<TextDialect> dialectFromJson(const nlohmann::json& json) {
  const Error unusable = Error::unusable(
      message("The turntable's 'dialect' must be \"marlin\" or an object with its commands."));
  if (json == "marlin") return marlinDialect();
  if (!json.is_object()) return unusable;
  TextDialect d;
  try {
    d.name = json.contains("name") ? Message(json["name"].get<std::string>())
                                   : message("text controller");
    const std::string end = json.value("end", "\n");
    if (end.size() != 1) return unusable;
    d.end = end[0];
    d.begin = json.value("begin", std::vector<std::string>{});
    d.move = json.at("move").get<std::string>();
    d.reply_s = numberOr(json, "reply_s", d.reply_s, 0, 3600);
    for (const auto& [key, word] : {std::pair<const char*, std::string*>{"still", &d.still},
                                    {"home", &d.home},
                                    {"zero", &d.zero},
                                    {"stop", &d.stop},
                                    {"query", &d.query},
                                    {"accepted", &d.accepted},
                                    {"refused", &d.refused},
                                    {"restarted", &d.restarted},
                                    {"arrived", &d.arrived},
                                    {"busy", &d.busy},
                                    {"position", &d.position}})
      *word = json.value(key, std::string());
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(refused, unusable.what, unusable.where);
  }
  if (const Result<void> checked = d.check(); !checked) return checked.error();
  return d;
}

Result<std::unique_ptr<devices::Turntable>> openTextTable(
    std::unique_ptr<devices::ByteChannel> channel, const TextTableOptions& options,
    std::shared_ptr<devices::Clock> clock, std::stop_token stop) {
  if (const Result<void> checked = options.dialect.check(); !checked) return checked.error();
  return LineTurntable::open(
      std::make_unique<TextTurntable>(std::move(channel), options, std::move(clock)),
      std::move(stop));
}

}  // namespace ostraka::turntables
