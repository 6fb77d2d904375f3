#include "store/network_share.h"

#include <gtest/gtest.h>

namespace ostraka::store {
namespace {

constexpr const char* kMounts =
    "22 1 8:1 / / rw,relatime shared:1 - ext4 /dev/sda1 rw\n"
    "30 22 0:40 / /srv/field rw,relatime shared:9 - nfs4 server:/field rw\n"
    "31 22 0:41 / /media/usb\\040stick rw - exfat /dev/sdb1 rw\n"
    "32 22 0:42 / /mnt/pc rw - cifs //pc/share rw\n"
    "33 22 0:43 / /mnt/far rw - fuse.sshfs someone@far:/ rw\n"
    "34 30 0:44 / /srv/field/local rw - ext4 /dev/sdc1 rw\n";

TEST(NetworkShare, FoldersOnSharesAreRecognised) {
  EXPECT_EQ(networkShareOf("/srv/field/project", kMounts), "nfs4");
  EXPECT_EQ(networkShareOf("/mnt/pc", kMounts), "cifs");
  EXPECT_EQ(networkShareOf("/mnt/far/a/b", kMounts), "fuse.sshfs");
}

TEST(NetworkShare, FoldersOnOwnDisksAreFine) {
  EXPECT_EQ(networkShareOf("/data/anna/project", kMounts), "");
  EXPECT_EQ(networkShareOf("/media/usb stick/project", kMounts), "");
  EXPECT_EQ(networkShareOf("/srv/fieldwork", kMounts), "") << "only the beginning of the name";
  EXPECT_EQ(networkShareOf("/srv/field/local/project", kMounts), "") << "a disk below a share";
}

TEST(NetworkShare, AMountInTheSamePlaceCoversTheEarlierOne) {
  const std::string both = std::string(kMounts) + "40 22 0:50 / /mnt/pc rw - ext4 /dev/sdd1 rw\n";
  EXPECT_EQ(networkShareOf("/mnt/pc/x", both), "");
}

}  // namespace
}  // namespace ostraka::store
