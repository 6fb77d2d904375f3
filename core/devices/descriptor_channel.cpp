#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <optional>

#include "base/message.h"
#include "devices/byte_channel.h"
#include "devices/clock.h"

namespace ostraka::devices {
namespace {

constexpr double kWrite_s = 2;    // nobody takes bytes for so long: the line is dead
constexpr double kReopen_s = 2;   // a device needs a moment after it was plugged in
constexpr double kPoll_s = 0.05;  // how soon a request to stop is noticed

// A peer that left the network must not end the program (SIGPIPE).
ssize_t send(int fd, std::string_view bytes) {
  const ssize_t n = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  return n < 0 && errno == ENOTSOCK ? ::write(fd, bytes.data(), bytes.size()) : n;
}

class DescriptorChannel final : public ByteChannel {
 public:
  DescriptorChannel(std::string name, std::function<Result<int>()> open)
      : name_(std::move(name)), open_(std::move(open)) {}
  ~DescriptorChannel() override { close(); }
  DescriptorChannel(const DescriptorChannel&) = delete;
  DescriptorChannel& operator=(const DescriptorChannel&) = delete;

  Result<void> open() {
    const Result<int> fd = open_();
    if (!fd) return fd.error();
    fd_ = *fd;
    return {};
  }

  std::string name() const override { return name_; }

  Result<void> write(std::string_view bytes) override {
    const double deadline_s = clock_->now_s() + kWrite_s;
    while (!bytes.empty()) {
      if (fd_ < 0) return gone(message("it is not open"));
      const ssize_t n = send(fd_, bytes);
      if (n > 0) {
        bytes.remove_prefix(static_cast<std::size_t>(n));
        continue;
      }
      if (n < 0 && errno != EAGAIN && errno != EINTR) return gone(std::strerror(errno));
      if (clock_->now_s() > deadline_s) return gone(message("it accepts no more data"));
      pollfd wait{fd_, POLLOUT, 0};
      ::poll(&wait, 1, 50);
    }
    return {};
  }

  Result<std::string> read(double timeout_s, std::stop_token stop) override {
    const double deadline_s = clock_->now_s() + timeout_s;
    while (true) {
      if (fd_ < 0) return gone(message("it is not open"));
      const double left_s = std::max(0.0, deadline_s - clock_->now_s());
      pollfd wait{fd_, POLLIN, 0};
      ::poll(&wait, 1, static_cast<int>(std::ceil(1000 * std::min(left_s, kPoll_s))));
      if (wait.revents != 0) {
        char bytes[512];
        const ssize_t n = ::read(fd_, bytes, sizeof bytes);
        if (n > 0) return std::string(bytes, static_cast<std::size_t>(n));
        if (n == 0) return gone(message("it was closed at the other end"));
        if (errno != EAGAIN && errno != EINTR) return gone(std::strerror(errno));
      }
      if (stop.stop_requested() || clock_->now_s() >= deadline_s) return std::string();
    }
  }

  Result<void> reopen(std::stop_token stop) override {
    close();
    return openWithin(kReopen_s, 0.1, *clock_, stop, [this] { return open(); });
  }

  void close() override {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  Error gone(const Message& why) const {
    return Error::missing(message("The connection to the turntable failed (%1).", why), name_);
  }

  std::string name_;
  std::function<Result<int>()> open_;
  int fd_ = -1;
  std::shared_ptr<Clock> clock_ = steadyClock();
};

std::optional<speed_t> speedOf(int baud) {
  static const std::map<int, speed_t> speeds{
      {1200, B1200},     {2400, B2400},     {4800, B4800},    {9600, B9600},
      {19200, B19200},   {38400, B38400},   {57600, B57600},  {115200, B115200},
      {230400, B230400}, {460800, B460800}, {921600, B921600}};
  const auto found = speeds.find(baud);
  return found == speeds.end() ? std::nullopt : std::optional(found->second);
}

Result<int> openPort(const std::string& path, speed_t speed) {
  const auto missing = [&](const Message& what) { return Error::missing(what, path); };
  const int fd = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) {
    if (errno == EACCES)
      return missing(message(
          "You have no permission to use this serial port; install Ostraka's udev rules or join "
          "the group dialout, then log in again."));
    if (errno == EBUSY)
      return missing(message("Another program uses the turntable; close that program."));
    return missing(message(
        "The serial port does not exist; check that the turntable is plugged in and switched on."));
  }
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    ::close(fd);
    return missing(message("Another program uses the turntable; close that program."));
  }
  termios settings{};
  if (::tcgetattr(fd, &settings) != 0) {
    ::close(fd);
    return missing(message("Not a serial port."));
  }
  ::ioctl(fd, TIOCEXCL);
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(HUPCL | CRTSCTS | CSTOPB | PARENB);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  ::cfsetispeed(&settings, speed);
  ::cfsetospeed(&settings, speed);
  if (::tcsetattr(fd, TCSANOW, &settings) != 0) {
    ::close(fd);
    return missing(message("The serial port does not accept its settings."));
  }
  ::tcflush(fd, TCIOFLUSH);
  return fd;
}

Result<int> connectTo(const std::string& host, const std::string& port) {
  const std::string name = host + ":" + port;
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), port.c_str(), &hints, &found) != 0)
    return Error::missing(message("The turntable's address is unknown on this network."), name);
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, ::freeaddrinfo);
  for (const addrinfo* a = found; a != nullptr; a = a->ai_next) {
    const int fd = ::socket(a->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd < 0) continue;
    if (::connect(fd, a->ai_addr, a->ai_addrlen) != 0 && errno == EINPROGRESS) {
      pollfd wait{fd, POLLOUT, 0};
      ::poll(&wait, 1, 2000);
    }
    int failed = 0;
    socklen_t size = sizeof failed;
    pollfd ready{fd, POLLOUT, 0};
    if (::poll(&ready, 1, 0) == 1 && ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &failed, &size) == 0 &&
        failed == 0)
      return fd;
    ::close(fd);
  }
  return Error::missing(message("The turntable does not answer on the network."), name);
}

// A channel over a file descriptor that can be polled; open gives a fresh one.
Result<std::unique_ptr<ByteChannel>> channelOver(std::string name,
                                                 std::function<Result<int>()> open) {
  auto channel = std::make_unique<DescriptorChannel>(std::move(name), std::move(open));
  if (const Result<void> opened = channel->open(); !opened) return opened.error();
  return std::unique_ptr<ByteChannel>(std::move(channel));
}

}  // namespace

Result<std::unique_ptr<ByteChannel>> openSerial(const std::string& path, int baud) {
  const std::optional<speed_t> speed = speedOf(baud);
  if (!speed)
    return Error::unusable(
        message("A serial port does not support %1 baud; common rates are 9600 and 115200.", baud),
        path);
  return channelOver(path, [path, speed] { return openPort(path, *speed); });
}

Result<std::unique_ptr<ByteChannel>> openTcp(const std::string& host_and_port) {
  const std::size_t colon = host_and_port.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == host_and_port.size())
    return Error::unusable(message("A network address looks like 192.168.0.7:23."), host_and_port);
  const std::string host = host_and_port.substr(0, colon), port = host_and_port.substr(colon + 1);
  return channelOver("tcp:" + host_and_port, [host, port] { return connectTo(host, port); });
}

Result<std::unique_ptr<ByteChannel>> openChannel(const std::string& name, int baud) {
  if (name.starts_with("usb:")) return openUsb(name.substr(4), baud);
  if (name.starts_with("tcp:")) return openTcp(name.substr(4));
  return openSerial(name, baud);
}

}  // namespace ostraka::devices
