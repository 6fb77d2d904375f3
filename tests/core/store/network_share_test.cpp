#include "store/network_share.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/scratch_folder.h"

namespace ostraka::store {
namespace {

constexpr const char* kMounts =
    "/dev/sda1 / ext4 rw,relatime 0 0\n"
    "server:/field /srv/field nfs4 rw,relatime 0 0\n"
    "/dev/sdb1 /media/usb\\040stick exfat rw 0 0\n"
    "//pc/share /mnt/pc cifs rw 0 0\n"
    "someone@far:/ /mnt/far fuse.sshfs rw 0 0\n"
    "/dev/sdc1 /srv/field/local ext4 rw 0 0\n";

std::string shareOf(const std::string& folder, const std::string& mounts) {
  const ScratchFolder scratch = std::move(*ScratchFolder::make("mounts"));
  EXPECT_TRUE(writeFileAtomically(scratch.path() / "mounts", mounts));
  return networkShareOf(folder, scratch.path() / "mounts");
}

TEST(NetworkShare, FoldersOnSharesAreRecognised) {
  EXPECT_EQ(shareOf("/srv/field/project", kMounts), "nfs4");
  EXPECT_EQ(shareOf("/mnt/pc", kMounts), "cifs");
  EXPECT_EQ(shareOf("/mnt/far/a/b", kMounts), "fuse.sshfs");
}

TEST(NetworkShare, FileSystemsOfClustersAreShares) {
  for (const std::string type : {"lustre", "gpfs", "beegfs", "nfs4", "orangefs", "fuse.juicefs"}) {
    const std::string mounts =
        std::string(kMounts) + "server:/scratch /scratch " + type + " rw 0 0\n";
    EXPECT_EQ(shareOf("/scratch/anna/dig", mounts), type);
  }
}

TEST(NetworkShare, FoldersOnOwnDisksAreFine) {
  EXPECT_EQ(shareOf("/data/anna/project", kMounts), "");
  EXPECT_EQ(shareOf("/media/usb stick/project", kMounts), "");
  EXPECT_EQ(shareOf("/srv/fieldwork", kMounts), "") << "only the beginning of the name";
  EXPECT_EQ(shareOf("/srv/field/local/project", kMounts), "") << "a disk below a share";
}

TEST(NetworkShare, AMountInTheSamePlaceCoversTheEarlierOne) {
  const std::string both = std::string(kMounts) + "/dev/sdd1 /mnt/pc ext4 rw 0 0\n";
  EXPECT_EQ(shareOf("/mnt/pc/x", both), "");
}

}  // namespace
}  // namespace ostraka::store
