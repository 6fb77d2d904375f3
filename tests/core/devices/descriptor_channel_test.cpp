#include "devices/byte_channel.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace ostraka::devices {
namespace {

using ::testing::HasSubstr;

// A controller in the network that takes one connection.
class Server {
 public:
  Server() : listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listening_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(listening_, 1), 0);
    EXPECT_EQ(::getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    name = "tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  }
  ~Server() { ::close(listening_); }
  int accept() const { return ::accept(listening_, nullptr, nullptr); }
  std::string name;

 private:
  int listening_;
};

TEST(DescriptorChannel, SaysInWordsThatAControllerLeftTheNetwork) {
  const Server server;
  const auto channel = openChannel(server.name, 0);
  ASSERT_TRUE(channel.has_value()) << channel.error().sentence();
  const int peer = server.accept();
  ASSERT_TRUE((*channel)->write("?").has_value());
  char byte = 0;
  ASSERT_EQ(::read(peer, &byte, 1), 1);
  EXPECT_EQ(byte, '?');
  const linger at_once{1, 0};  // a reset: whoever writes on would be ended by SIGPIPE
  ::setsockopt(peer, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  ::close(peer);
  Result<void> written;
  for (int k = 0; k < 3 && written; ++k) written = (*channel)->write("G1 X45\n");
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, ErrorCode::Missing);
  EXPECT_THAT(written.error().sentence(), HasSubstr(server.name));
  const auto again = (*channel)->write("?");
  EXPECT_EQ(again.error().code, ErrorCode::Missing);
}

TEST(DescriptorChannel, RefusesWhatIsNoAddressOrDoesNotAnswer) {
  EXPECT_EQ(openChannel("tcp:127.0.0.1", 0).error().code, ErrorCode::UnusableInput);
  std::string closed;
  {
    const Server server;
    closed = server.name;
  }
  const auto channel = openChannel(closed, 0);
  ASSERT_FALSE(channel.has_value());
  EXPECT_EQ(channel.error().code, ErrorCode::Missing);
}

}  // namespace
}  // namespace ostraka::devices
