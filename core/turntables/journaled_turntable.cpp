#include "turntables/journaled_turntable.h"

#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>

#include "files/json.h"

namespace ostraka::turntables {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJournalFormat = "ostraka-turntable/1";

class JournaledTurntable final : public devices::Turntable {
 public:
  JournaledTurntable(std::unique_ptr<devices::Turntable> table, fs::path journal)
      : table_(std::move(table)), journal_(std::move(journal)) {
    (void)recall({});
  }

  std::string name() const override { return table_->name(); }

  Result<void> home(std::stop_token stop) override {
    setOut(0);
    const Result<void> homed = table_->home(std::move(stop));
    if (homed) zero_deg_ = 0;
    arrived();
    return homed;
  }
  Result<void> zeroHere(std::stop_token stop) override {
    const Result<void> zeroed = table_->zeroHere(std::move(stop));
    if (zeroed) zero_deg_ = 0;
    arrived();
    return zeroed;
  }
  Result<void> moveTo(double degrees, std::stop_token stop) override {
    if (position_deg() == degrees) return table_->moveTo(degrees - zero_deg_, std::move(stop));
    setOut(degrees);
    const Result<void> moved = table_->moveTo(degrees - zero_deg_, std::move(stop));
    arrived();
    return moved;
  }
  void stopNow() override { table_->stopNow(); }
  bool turnsItself() const override { return table_->turnsItself(); }

  std::optional<double> position_deg() const override {
    const std::optional<double> counted = table_->position_deg();
    return counted ? std::optional(*counted + zero_deg_) : std::nullopt;
  }
  bool firesShutters() const override { return table_->firesShutters(); }
  Result<void> fireShutters(std::stop_token stop) override {
    return table_->fireShutters(std::move(stop));
  }
  Result<void> reopen(std::stop_token stop) override {
    if (Result<void> r = table_->reopen(stop); !r) return r;
    return recall(std::move(stop));
  }
  void close() override { table_->close(); }

 private:
  // A restarted controller counts from nothing; its place becomes what the journal says.
  Result<void> recall(std::stop_token stop) {
    if (table_->position_deg()) return {};
    const std::optional<double> place = readPlace();
    if (!place) return {};
    if (Result<void> r = table_->zeroHere(std::move(stop)); !r) return r;
    zero_deg_ = *place;
    return {};
  }

  std::optional<double> readPlace() const {
    const Result<nlohmann::json> json = readJson(journal_);
    if (!json || !json->is_object() || !json->contains("format") ||
        json->at("format") != kJournalFormat)
      return std::nullopt;
    const auto place = json->find("stands_at_deg");
    if (place == json->end() || !place->is_number()) return std::nullopt;
    const double degrees = place->get<double>();
    return std::isfinite(degrees) ? std::optional(degrees) : std::nullopt;
  }

  // Written before the command is sent: from here on nobody knows the place until it is arrived().
  void setOut(double target_deg) const {
    if (!writeJson(journal_, {{"format", kJournalFormat}, {"turns_to_deg", target_deg}})) forget();
  }
  void arrived() const {
    const std::optional<double> place = position_deg();
    if (!place) return;
    if (!writeJson(journal_, {{"format", kJournalFormat}, {"stands_at_deg", *place}})) forget();
  }
  // What cannot be kept up to date must not be believed later.
  void forget() const {
    std::error_code failed;
    fs::remove(journal_, failed);
  }

  std::unique_ptr<devices::Turntable> table_;
  fs::path journal_;
  std::atomic<double> zero_deg_ = 0;  // of the table's own count
};

}  // namespace

std::unique_ptr<devices::Turntable> rememberPosition(std::unique_ptr<devices::Turntable> table,
                                                     std::filesystem::path journal) {
  return std::make_unique<JournaledTurntable>(std::move(table), std::move(journal));
}

}  // namespace ostraka::turntables
