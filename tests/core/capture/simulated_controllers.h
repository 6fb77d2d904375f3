#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "devices/byte_channel.h"
#include "devices/clock.h"

/// Controllers of turntables that misbehave on demand, and lines to them.
namespace ostraka::capture::testing {

/// How often, of one, a reply goes wrong, or a command makes the controller do so.
struct Mischief {
  double lost = 0, late = 0, doubled = 0, garbled = 0;
  double deaf = 0;     ///< a command that never arrives
  double restart = 0;  ///< at a command, in mid-move too
  double unplug = 0;   ///< at a write: the line is gone until it is opened again
  std::uint64_t seed = 1;
};

class SimulatedController {
 public:
  SimulatedController(std::shared_ptr<devices::Clock> clock, Mischief mischief)
      : clock_(std::move(clock)), mischief_(mischief), random_(mischief.seed) {}
  virtual ~SimulatedController() = default;

  void receive(const std::string& bytes);
  /// What it has said up to now.
  std::string said();
  /// The line was opened: boards that restart then do so.
  virtual void opened() {}
  double degrees();        ///< where the plate really stands, counter-clockwise
  double turned_in_all();  ///< the way of the plate in both directions, added up
  Mischief& mischief() { return mischief_; }
  bool chance(double probability);
  std::function<bool(const std::string& message)> swallow;  ///< a scripted loss of replies

 protected:
  virtual void byte(char c) = 0;
  void say(const std::string& message, double delay_s = 0);
  void startMove(double by, double speed_deg_s);
  void stopMove();
  bool moving();
  double moveEnds_s() const { return move_end_s_; }
  double now_s() { return clock_->now_s(); }
  double place();

  std::mutex guard_;

 private:
  struct Saying {
    double due_s;
    std::string bytes;
  };
  std::shared_ptr<devices::Clock> clock_;
  Mischief mischief_;
  std::mt19937_64 random_;
  std::deque<Saying> sayings_;
  double from_deg_ = 0, to_deg_ = 0, move_start_s_ = 0, move_end_s_ = 0, way_deg_ = 0;
};

class SimulatedGrbl final : public SimulatedController {
 public:
  using SimulatedController::SimulatedController;
  void opened() override;
  bool has_switch = true;
  bool restarts_when_opened = true;
  double switch_deg = 0;
  std::vector<std::string> lines;  ///< all that came

 private:
  void byte(char c) override;
  void line(const std::string& text);
  void restart();
  double machine() { return place() - machine_zero_; }
  void report();

  std::string rest_;
  double machine_zero_ = 0, offset_ = 0;
  bool held_ = false, alarm_ = false;
};

class SimulatedComXim final : public SimulatedController {
 public:
  SimulatedComXim(std::shared_ptr<devices::Clock> clock, Mischief mischief, int dialect)
      : SimulatedController(std::move(clock), mischief), dialect_(dialect) {}
  bool tells_offset = true;
  bool new_spelling = false;
  bool tells_arrival = true;
  double speed_deg_s = 60;
  std::vector<std::string> messages;

 private:
  void byte(char c) override;
  void message(const std::string& text);
  void dialect1(const std::string& text);
  void dialect2(const std::string& text);

  int dialect_;
  std::string rest_;
  double zero_deg_ = 0;
};

/// A line in memory, in simulated time.
class SimulatedChannel final : public devices::ByteChannel {
 public:
  SimulatedChannel(std::shared_ptr<SimulatedController> device,
                   std::shared_ptr<devices::Clock> clock)
      : device_(std::move(device)), clock_(std::move(clock)) {
    device_->opened();
  }
  std::string name() const override { return "simulated line"; }
  Result<void> write(std::string_view bytes) override;
  Result<std::string> read(double timeout_s, std::stop_token stop) override;
  Result<void> reopen(std::stop_token stop) override;
  void close() override {}

 private:
  std::shared_ptr<SimulatedController> device_;
  std::shared_ptr<devices::Clock> clock_;
  bool gone_ = false;
};

/// A pseudo terminal with the controller behind it, in real time.
class PseudoTerminal {
 public:
  explicit PseudoTerminal(std::shared_ptr<SimulatedController> device);
  ~PseudoTerminal();
  const std::string& path() const { return path_; }

 private:
  int master_ = -1;
  std::string path_;
  std::shared_ptr<SimulatedController> device_;
  std::jthread pump_;
};

}  // namespace ostraka::capture::testing
