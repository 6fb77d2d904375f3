#include "files/open_folder.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "files/files.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

class OpenFiles : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static std::string refusal(const fs::path& file) {
    const Result<std::string> read = readFile(file);
    return read ? "it was read" : read.error().sentence().english();
  }
  // A name short enough for a socket.
  fs::path folder_ = fs::path("/tmp") / ("ostraka_in_" + std::to_string(::getpid()));
};

// Were one of them opened as a file, this test would hang or fill the memory.
TEST_F(OpenFiles, OtherThingsAreRefusedByTheirKindAtOnce) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (folder_ / "socket").c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  fs::create_symlink("/dev/zero", folder_ / "zero");
  for (const auto& [name, kind] : {std::pair{"pipe", "a pipe"},
                                   {"socket", "a socket"},
                                   {"zero", "a device"},
                                   {".", "a folder"}}) {
    const fs::path file = folder_ / name;
    EXPECT_EQ(refusal(file), file.string() + ": This is " + kind + ", not a file; choose a file.");
    EXPECT_FALSE(otherThanAFile(file).empty());
  }
  ::close(socket);
}

TEST_F(OpenFiles, AbsentOnesAndLinksToNothingAreNamed) {
  fs::create_symlink(folder_ / "gone", folder_ / "link");
  for (const char* name : {"gone", "link"})
    EXPECT_EQ(refusal(folder_ / name),
              (folder_ / name).string() + ": There is no such file; check its name.");
  EXPECT_TRUE(otherThanAFile(folder_ / "gone").empty());
}

}  // namespace
}  // namespace ostraka
