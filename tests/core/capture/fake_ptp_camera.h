#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ostraka::capture::testing {

/// A camera on the loopback network that speaks PTP/IP, as far as a photograph needs it.
class FakePtpCamera {
 public:
  /// picture: what each exposure gives.
  explicit FakePtpCamera(std::function<std::string()> picture);
  ~FakePtpCamera();
  FakePtpCamera(const FakePtpCamera&) = delete;
  FakePtpCamera& operator=(const FakePtpCamera&) = delete;

  /// "ptpip:127.0.0.1:port:port"
  std::string address() const;
  int exposures() const { return exposures_; }
  /// The camera goes: all connections break; it can be reached again.
  void breakConnections();
  /// A person pressed the button: a photograph that nobody asked for.
  void pressButton() { expose(); }
  std::uint32_t property(std::uint16_t code) const;

  std::atomic<int> busy = 0;        ///< so many answers say: busy
  std::atomic<int> silent = 0;      ///< so many exposures are never announced
  std::atomic<int> cut_short = 0;   ///< so many files end in the middle
  std::atomic<bool> fixed = false;  ///< settings are accepted, and kept as they were

 private:
  void accept(std::stop_token stop);
  void serve(int fd);
  void command(int fd, const std::string& request);
  void expose();
  std::string answerData(std::uint16_t operation, const std::vector<std::uint32_t>& arguments,
                         std::uint16_t& code);

  std::function<std::string()> picture_;
  int listening_ = -1, port_ = 0;
  std::atomic<int> exposures_ = 0;
  mutable std::mutex guard_;
  std::vector<int> connections_;
  int events_ = -1;
  std::uint16_t pending_set_ = 0;
  std::map<std::uint32_t, std::string> objects_;
  std::map<std::uint16_t, std::uint32_t> properties_{{0x500F, 200}, {0x5007, 560}, {0x500D, 166}};
  std::vector<std::jthread> servers_;
  std::jthread acceptor_;
};

}  // namespace ostraka::capture::testing
