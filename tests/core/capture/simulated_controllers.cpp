#include "simulated_controllers.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace ostraka::capture::testing {
namespace {

std::string written(const char* pattern, double a, double b = 0) {
  char text[96];
  std::snprintf(text, sizeof text, pattern, a, b);
  return text;
}

double numberAfter(const std::string& text, const std::string& start) {
  const std::size_t at = text.find(start);
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + start.size(), nullptr);
}

}  // namespace

bool SimulatedController::chance(double probability) {
  return probability > 0 && std::uniform_real_distribution<>(0, 1)(random_) < probability;
}

double SimulatedController::place() {
  const double t = now_s();
  if (t >= move_end_s_) return to_deg_;
  return from_deg_ + (to_deg_ - from_deg_) * (t - move_start_s_) / (move_end_s_ - move_start_s_);
}

double SimulatedController::degrees() {
  const std::lock_guard lock(guard_);
  return place();
}

double SimulatedController::turned_in_all() {
  const std::lock_guard lock(guard_);
  return way_deg_ + std::abs(place() - from_deg_);
}

bool SimulatedController::moving() {
  return now_s() < move_end_s_;
}

void SimulatedController::startMove(double by, double speed_deg_s) {
  const double here = place();
  way_deg_ += std::abs(here - from_deg_);
  from_deg_ = here;
  to_deg_ = here + by;
  move_start_s_ = now_s();
  move_end_s_ = move_start_s_ + std::abs(by) / speed_deg_s;
}

void SimulatedController::stopMove() {
  const double here = place();
  way_deg_ += std::abs(here - from_deg_);
  from_deg_ = to_deg_ = here;
  move_end_s_ = now_s();
}

void SimulatedController::say(const std::string& message, double delay_s) {
  if (chance(mischief_.lost) || (swallow && swallow(message))) return;
  std::string bytes = message;
  if (chance(mischief_.garbled))
    for (char& c : bytes)
      if (chance(0.3)) c = static_cast<char>(33 + random_() % 90);
  if (chance(mischief_.late)) delay_s += 3 * std::uniform_real_distribution<>(0, 1)(random_);
  sayings_.push_back({now_s() + delay_s, bytes});
  if (chance(mischief_.doubled)) sayings_.push_back({now_s() + delay_s, bytes});
}

void SimulatedController::receive(const std::string& bytes) {
  const std::lock_guard lock(guard_);
  for (const char c : bytes) byte(c);
}

std::string SimulatedController::said() {
  const std::lock_guard lock(guard_);
  std::string all;
  std::deque<Saying> left;
  for (Saying& saying : sayings_) {
    if (saying.due_s <= now_s())
      all += saying.bytes;
    else
      left.push_back(std::move(saying));
  }
  sayings_ = std::move(left);
  return all;
}

void SimulatedGrbl::opened() {
  const std::lock_guard lock(guard_);
  if (restarts_when_opened) restart();
}

void SimulatedGrbl::restart() {
  stopMove();
  rest_.clear();
  held_ = alarm_ = false;
  say("\r\nGrbl 1.1h ['$' for help]\r\n", 0.05);
}

void SimulatedGrbl::byte(char c) {
  if (c == '?') {
    report();
  } else if (c == '!') {
    if (moving()) {
      stopMove();
      held_ = true;
    }
  } else if (c == '~') {
    held_ = false;
  } else if (c == '\x18') {
    if (moving()) alarm_ = true;
    const bool alarm = alarm_;
    offset_ = 0;
    restart();
    alarm_ = alarm;
  } else if (c == '\n') {
    const std::string text = rest_;
    rest_.clear();
    if (chance(mischief().deaf)) return;
    if (chance(mischief().restart)) {
      machine_zero_ = place();  // it counts from anew
      offset_ = 0;
      restart();
      return;
    }
    lines.push_back(text);
    line(text);
  } else if (c != '\r') {
    rest_ += c;
  }
}

void SimulatedGrbl::report() {
  const char* state = alarm_ ? "Alarm" : held_ ? "Hold:0" : moving() ? "Run" : "Idle";
  say("<" + std::string(state) +
      written("|MPos:%.3f,0.000,0.000|FS:0,0|WCO:%.3f,0.000,0.000>", machine(), offset_) + "\r\n");
}

void SimulatedGrbl::line(const std::string& text) {
  if (text.empty()) return say("ok\r\n");
  if (text == "$I") return say("[VER:1.1h.20190830:]\r\n[OPT:V,15,128]\r\nok\r\n");
  if (text == "$$")
    return say(std::string("$20=0\r\n$22=") + (has_switch ? "1" : "0") +
               "\r\n$100=88.889\r\n$110=6000.000\r\nok\r\n");
  if (text == "$X") {
    alarm_ = false;
    return say("ok\r\n");
  }
  if (text == "$H") {
    if (!has_switch) return say("error:5\r\n");
    alarm_ = false;
    startMove(switch_deg - place(), 90);
    machine_zero_ = switch_deg;
    return say("ok\r\n", moveEnds_s() - now_s());
  }
  if (alarm_) return say("error:9\r\n");
  if (text.starts_with("G92 X")) {
    offset_ = machine() - numberAfter(text, "X");
    return say("ok\r\n");
  }
  if (text.starts_with("G4 P"))  // answered when the planner is empty
    return say("ok\r\n", std::max(0.0, moveEnds_s() - now_s()) + numberAfter(text, "P"));
  if (text.starts_with("G1 X")) {
    startMove(numberAfter(text, "X") + offset_ - machine(), numberAfter(text, "F") / 60);
    return say("ok\r\n", 0.004);
  }
  const bool known = text.starts_with("G21") || text.starts_with("M");
  say(known ? "ok\r\n" : "error:20\r\n");
}

void SimulatedComXim::byte(char c) {
  if (c != ';') {
    if (c != '\r' && c != '\n' && c != '#') rest_ += c;
    return;
  }
  const std::string text = rest_;
  rest_.clear();
  if (chance(mischief().deaf)) return;
  if (chance(mischief().restart)) {  // it forgets its zero and stands still
    stopMove();
    zero_deg_ = place();
    return;
  }
  messages.push_back(text);
  dialect_ == 1 ? dialect1(text) : dialect2(text);
}

void SimulatedComXim::dialect1(const std::string& text) {
  const std::string turn = new_spelling ? "CT+TURNSINGLE(" : "CT+TRUNSINGLE(";
  if (text.starts_with(turn)) {
    const char way = text[turn.size()];
    if (way != '0' && way != '1') return say("CR+ERR=71;");
    const double angle = numberAfter(text, ",");
    say("CR+OK;", 0.01);
    startMove(way == '1' ? angle : -angle, speed_deg_s);
    return say("CR+EVENT=TB_END;", moveEnds_s() - now_s() + 0.01);
  }
  if (text == "CT+TOZERO()") {
    double back = std::remainder(zero_deg_ - place(), 360);
    const bool there = std::abs(back) < 1e-9;
    say("CR+OK;", 0.01);
    startMove(back, speed_deg_s);
    if (!there) say("CR+EVENT=TB_END;", moveEnds_s() - now_s() + 0.01);
    return;
  }
  if (text == "CT+SETZERO()") {
    zero_deg_ = place();
    return say("CR+OK;");
  }
  if (text == "CT+SETSTOP()") {
    stopMove();
    return say("CR+OK;");
  }
  if (text == "CT+GETOFFSETANGLE()" && tells_offset)
    return say(written("CR+OK;CR+OffsetAngle=%.2f;", std::remainder(place() - zero_deg_, 360)));
  const bool known = text.starts_with("CT+ACK") || text.starts_with("CT+EVENT") ||
                     text.starts_with("CT+HEARTBEAT") || text.starts_with("CT+SPKMUTE");
  say(known ? "CR+OK;" : "CR+ERR=1;");
}

void SimulatedComXim::dialect2(const std::string& text) {
  if (text.starts_with("+CT,TURNANGLE=")) {
    say("+OK;", 0.01);
    startMove(numberAfter(text, "TURNANGLE="), speed_deg_s);
    if (tells_arrival) say(written("+OK,TURNANGLE=%.1f;", place()), moveEnds_s() - now_s() + 0.01);
    return;
  }
  if (text == "+CT,STOP") {
    stopMove();
    return say("+OK;");
  }
  if (text == "+CT,TOZERO") {
    startMove(std::remainder(zero_deg_ - place(), 360), speed_deg_s);
    return say("+OK;", 0.01);
  }
  if (text == "+QT,CHANGEANGLE" && tells_offset)
    return say(written("+DATA=%.2f;", std::remainder(place() - zero_deg_, 360)));
  if (text == "+QR,VERSION") return say("+DATA=V3.28;");
  say("+FAIL,ERR=007;");
}

Result<void> SimulatedChannel::write(std::string_view bytes) {
  if (!gone_ && device_->chance(device_->mischief().unplug)) gone_ = true;
  if (gone_) return Error{ErrorCode::Missing, "The line is gone.", name()};
  device_->receive(std::string(bytes));
  return {};
}

Result<std::string> SimulatedChannel::read(double timeout_s, std::stop_token stop) {
  const double deadline_s = clock_->now_s() + timeout_s;
  while (true) {
    if (gone_) return Error{ErrorCode::Missing, "The line is gone.", name()};
    std::string bytes = device_->said();
    if (!bytes.empty()) return bytes;
    const double left_s = deadline_s - clock_->now_s();
    if (left_s <= 1e-6) {
      if (timeout_s > 0) clock_->sleep(1e-6, stop);  // time passes, however short the wait
      return std::string();
    }
    if (!clock_->sleep(std::min(0.01, left_s), stop)) return std::string();
  }
}

Result<void> SimulatedChannel::reopen(std::stop_token) {
  gone_ = false;
  (void)device_->said();
  device_->opened();
  return {};
}

PseudoTerminal::PseudoTerminal(std::shared_ptr<SimulatedController> device)
    : device_(std::move(device)) {
  master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ::grantpt(master_);
  ::unlockpt(master_);
  char name[128];
  ::ptsname_r(master_, name, sizeof name);
  path_ = name;
  termios raw{};
  ::tcgetattr(master_, &raw);
  ::cfmakeraw(&raw);
  ::tcsetattr(master_, TCSANOW, &raw);
  device_->opened();
  pump_ = std::jthread([this](std::stop_token stop) {
    while (!stop.stop_requested()) {
      pollfd master{master_, POLLIN, 0};
      ::poll(&master, 1, 2);
      if ((master.revents & POLLIN) != 0) {
        char bytes[256];
        const ssize_t n = ::read(master_, bytes, sizeof bytes);
        if (n > 0) device_->receive(std::string(bytes, static_cast<std::size_t>(n)));
      } else if ((master.revents & POLLHUP) != 0) {
        ::usleep(2000);  // nobody has the other end open
      }
      const std::string said = device_->said();
      if (!said.empty() && ::write(master_, said.data(), said.size()) < 0) return;
    }
  });
}

PseudoTerminal::~PseudoTerminal() {
  pump_.request_stop();
  pump_.join();
  ::close(master_);
}

}  // namespace ostraka::capture::testing
