#include "fake_ptp_camera.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace ostraka::capture::testing {
namespace {

constexpr std::uint16_t kOk = 0x2001, kUnknown = 0x2005, kBusy = 0x2019, kNoObject = 0x2009;
constexpr std::uint32_t kStorage = 0x00010001;

template <class T>
void put(std::string& out, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    out += static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFF);
}
template <class T>
T get(const std::string& in, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(T) && at + i < in.size(); ++i)
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(in[at + i])) << (8 * i);
  return static_cast<T>(value);
}
void putText(std::string& out, const std::string& text) {
  put<std::uint8_t>(out, text.empty() ? 0 : text.size() + 1);
  if (text.empty()) return;
  for (const char c : text) put<std::uint16_t>(out, c);
  put<std::uint16_t>(out, 0);
}
template <class T>
void putList(std::string& out, const std::vector<T>& values) {
  put<std::uint32_t>(out, values.size());
  for (const T v : values) put<T>(out, v);
}

bool receive(int fd, std::string& packet) {
  packet.clear();
  std::size_t wanted = 4;
  while (packet.size() < wanted) {
    char bytes[4096];
    const ssize_t n = ::recv(fd, bytes, std::min(sizeof bytes, wanted - packet.size()), 0);
    if (n <= 0) return false;
    packet.append(bytes, static_cast<std::size_t>(n));
    if (packet.size() == 4 && wanted == 4) wanted = get<std::uint32_t>(packet, 0);
  }
  return true;
}

void send(int fd, std::uint32_t type, const std::string& body) {
  std::string packet;
  put<std::uint32_t>(packet, body.size() + 8);
  put<std::uint32_t>(packet, type);
  packet += body;
  std::size_t done = 0;
  while (done < packet.size()) {
    const ssize_t n = ::send(fd, packet.data() + done, packet.size() - done, MSG_NOSIGNAL);
    if (n <= 0) return;
    done += static_cast<std::size_t>(n);
  }
}

std::string deviceInfo() {
  std::string out;
  put<std::uint16_t>(out, 100);
  put<std::uint32_t>(out, 0);
  put<std::uint16_t>(out, 0);
  putText(out, "");
  put<std::uint16_t>(out, 0);
  putList<std::uint16_t>(out, {0x1001, 0x1002, 0x1003, 0x1004, 0x1005, 0x1006, 0x1007, 0x1008,
                               0x1009, 0x100B, 0x100E, 0x1014, 0x1015, 0x1016});
  putList<std::uint16_t>(out, {0x4002, 0x400D});
  putList<std::uint16_t>(out, {0x500F, 0x5007, 0x500D});
  putList<std::uint16_t>(out, {0x3801});
  putList<std::uint16_t>(out, {0x3801});
  for (const char* text : {"Ostraka", "Paper camera", "1.0", "SN-0815"}) putText(out, text);
  return out;
}

std::string propertyInfo(std::uint16_t code, std::uint32_t value) {
  const bool wide = code == 0x500D;
  const auto add = [&](std::string& out, std::uint32_t v) {
    wide ? put<std::uint32_t>(out, v) : put<std::uint16_t>(out, v);
  };
  std::string out;
  put<std::uint16_t>(out, code);
  put<std::uint16_t>(out, wide ? 6 : 4);  // 32 or 16 bits, unsigned
  put<std::uint8_t>(out, 1);              // can be set
  add(out, value);
  add(out, value);
  put<std::uint8_t>(out, 2);  // one of these
  const std::vector<std::uint32_t> choices =
      code == 0x500F   ? std::vector<std::uint32_t>{100, 200, 400}
      : code == 0x5007 ? std::vector<std::uint32_t>{400, 560, 1100}
                       : std::vector<std::uint32_t>{80, 166, 1250};
  put<std::uint16_t>(out, choices.size());
  for (const std::uint32_t c : choices) add(out, c);
  return out;
}

std::string objectInfo(std::uint32_t handle, std::size_t size) {
  std::string out;
  put<std::uint32_t>(out, kStorage);
  put<std::uint16_t>(out, 0x3801);
  put<std::uint16_t>(out, 0);
  put<std::uint32_t>(out, size);
  put<std::uint16_t>(out, 0);
  for (int i = 0; i < 3; ++i) put<std::uint32_t>(out, 0);  // no thumbnail
  for (const std::uint32_t v : {640, 480, 24, 0}) put<std::uint32_t>(out, v);
  put<std::uint16_t>(out, 0);
  put<std::uint32_t>(out, 0);
  put<std::uint32_t>(out, 0);
  putText(out, "IMG_" + std::to_string(9997 + handle % 4) + ".JPG");
  putText(out, "20261121T120000");
  putText(out, "20261121T120000");
  putText(out, "");
  return out;
}

}  // namespace

FakePtpCamera::FakePtpCamera(std::function<std::string()> picture) : picture_(std::move(picture)) {
  listening_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ::bind(listening_, reinterpret_cast<sockaddr*>(&address), sizeof address);
  ::listen(listening_, 8);
  socklen_t size = sizeof address;
  ::getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  acceptor_ = std::jthread([this](std::stop_token stop) { accept(stop); });
}

FakePtpCamera::~FakePtpCamera() {
  acceptor_.request_stop();
  acceptor_.join();
  breakConnections();
  servers_.clear();
  ::close(listening_);
}

std::string FakePtpCamera::address() const {
  const std::string port = std::to_string(port_);
  return "ptpip:127.0.0.1:" + port + ":" + port;
}

std::uint32_t FakePtpCamera::property(std::uint16_t code) const {
  const std::lock_guard lock(guard_);
  return properties_.at(code);
}

void FakePtpCamera::breakConnections() {
  const std::lock_guard lock(guard_);
  for (const int fd : connections_) ::shutdown(fd, SHUT_RDWR);
  connections_.clear();
  events_ = -1;
}

void FakePtpCamera::accept(std::stop_token stop) {
  while (!stop.stop_requested()) {
    pollfd wait{listening_, POLLIN, 0};
    if (::poll(&wait, 1, 20) <= 0) continue;
    const int fd = ::accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
    if (fd < 0) continue;
    {
      const std::lock_guard lock(guard_);
      connections_.push_back(fd);
    }
    servers_.emplace_back([this, fd] {
      serve(fd);
      {
        const std::lock_guard lock(guard_);
        std::erase(connections_, fd);
        if (events_ == fd) events_ = -1;
      }
      ::close(fd);
    });
  }
}

void FakePtpCamera::serve(int fd) {
  std::string packet;
  while (receive(fd, packet)) {
    const auto type = get<std::uint32_t>(packet, 4);
    if (type == 1) {
      std::string body;
      put<std::uint32_t>(body, 7);
      body += std::string(16, 'o');
      for (const char c : std::string("paper")) put<std::uint16_t>(body, c);
      put<std::uint16_t>(body, 0);
      put<std::uint32_t>(body, 0x10000);
      send(fd, 2, body);
    } else if (type == 3) {
      const std::lock_guard lock(guard_);
      events_ = fd;
      send(fd, 4, "");
    } else if (type == 6) {
      command(fd, packet);
    }
  }
}

void FakePtpCamera::command(int fd, const std::string& request) {
  const auto phase = get<std::uint32_t>(request, 8);
  const auto operation = get<std::uint16_t>(request, 12);
  const auto transaction = get<std::uint32_t>(request, 14);
  std::vector<std::uint32_t> arguments;
  for (std::size_t at = 18; at + 4 <= request.size(); at += 4)
    arguments.push_back(get<std::uint32_t>(request, at));
  arguments.resize(5);
  std::string received;
  if (phase == 2) {  // data comes from the other side
    std::string packet;
    while (receive(fd, packet)) {
      const auto type = get<std::uint32_t>(packet, 4);
      if (type == 10 || type == 12) received += packet.substr(12);
      if (type == 12) break;
    }
  }
  std::uint16_t code = kOk;
  std::string data;
  const bool can_be_busy = operation == 0x100E || operation == 0x1009 || operation == 0x1016;
  if (can_be_busy && busy > 0) {
    --busy;
    code = kBusy;
  } else if (operation == 0x1016) {
    const std::lock_guard lock(guard_);
    const auto property = static_cast<std::uint16_t>(arguments[0]);
    if (!fixed)
      properties_[property] =
          received.size() >= 4 ? get<std::uint32_t>(received, 0) : get<std::uint16_t>(received, 0);
  } else {
    data = answerData(operation, arguments, code);
  }
  if (!data.empty()) {
    std::string start, end;
    put<std::uint32_t>(start, transaction);
    put<std::uint64_t>(start, data.size());
    send(fd, 9, start);
    put<std::uint32_t>(end, transaction);
    send(fd, 12, end + data);
  }
  std::string response;
  put<std::uint16_t>(response, code);
  put<std::uint32_t>(response, transaction);
  send(fd, 7, response);
  if (operation == 0x100E && code == kOk) expose();
}

std::string FakePtpCamera::answerData(std::uint16_t operation,
                                      const std::vector<std::uint32_t>& arguments,
                                      std::uint16_t& code) {
  const std::lock_guard lock(guard_);
  std::string out;
  const auto object = objects_.find(arguments[0]);
  const auto property = static_cast<std::uint16_t>(arguments[0]);
  switch (operation) {
    case 0x1001:
      return deviceInfo();
    case 0x1004:
      putList<std::uint32_t>(out, {kStorage});
      return out;
    case 0x1005:
      for (const std::uint16_t v : {3, 2, 0}) put<std::uint16_t>(out, v);
      put<std::uint64_t>(out, 1u << 30);
      put<std::uint64_t>(out, 1u << 29);
      put<std::uint32_t>(out, 1000);
      putText(out, "card");
      putText(out, "");
      return out;
    case 0x1007: {
      std::vector<std::uint32_t> handles;
      for (const auto& [handle, bytes] : objects_) handles.push_back(handle);
      putList(out, handles);
      return out;
    }
    case 0x1008:
    case 0x1009:
      if (object == objects_.end()) {
        code = kNoObject;
        return {};
      }
      return operation == 0x1008 ? objectInfo(object->first, object->second.size())
                                 : object->second;
    case 0x100B:
      objects_.erase(arguments[0]);
      return {};
    case 0x1014:
    case 0x1015:
      if (!properties_.contains(property)) {
        code = 0x200A;
        return {};
      }
      if (operation == 0x1014) return propertyInfo(property, properties_[property]);
      property == 0x500D ? put<std::uint32_t>(out, properties_[property])
                         : put<std::uint16_t>(out, properties_[property]);
      return out;
    case 0x1002:
    case 0x1003:
    case 0x1006:
    case 0x100E:
      return {};
    default:
      code = kUnknown;
      return {};
  }
}

void FakePtpCamera::expose() {
  const int number = ++exposures_;
  std::string bytes = picture_();
  if (cut_short > 0) {
    --cut_short;
    bytes.resize(bytes.size() / 2);
  }
  const std::lock_guard lock(guard_);
  objects_[static_cast<std::uint32_t>(number)] = std::move(bytes);
  if (silent > 0) {
    --silent;
    return;
  }
  if (events_ < 0) return;
  for (const std::uint16_t event : {0x4002, 0x400D}) {
    std::string body;
    put<std::uint16_t>(body, event);
    put<std::uint32_t>(body, 0);
    put<std::uint32_t>(body, event == 0x4002 ? number : 0);
    send(events_, 8, body);
  }
}

}  // namespace ostraka::capture::testing
