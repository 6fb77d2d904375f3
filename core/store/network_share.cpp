#include "store/network_share.h"

#include <mntent.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string_view>

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 19> kShares = {
    "nfs",        "nfs4",   "cifs",       "smb3",        "smbfs",           "ncpfs",
    "afs",        "ceph",   "glusterfs",  "9p",          "vboxsf",          "vmhgfs",
    "davfs",      "lustre", "fuse.sshfs", "fuse.rclone", "fuse.gvfsd-fuse", "fuse.glusterfs",
    "fuse.davfs2"};

bool contains(const std::string& mount, const std::string& path) {
  if (mount == "/") return true;
  return path.starts_with(mount) && (path.size() == mount.size() || path[mount.size()] == '/');
}

}  // namespace

std::string networkShareOf(const fs::path& folder, const fs::path& mounts) {
  std::error_code ignored;
  const std::string path = fs::weakly_canonical(folder, ignored).string();
  const std::unique_ptr<FILE, int (*)(FILE*)> table(::setmntent(mounts.c_str(), "re"), ::endmntent);
  std::string best_mount, best_type;
  mntent entry{};
  std::array<char, 4096> text{};
  while (table && ::getmntent_r(table.get(), &entry, text.data(), text.size()) != nullptr) {
    const std::string mount = entry.mnt_dir;
    // Of two mounts in one place the later one covers the earlier.
    if (!contains(mount, path) || mount.size() < best_mount.size()) continue;
    best_mount = mount;
    best_type = entry.mnt_type;
  }
  const bool share = std::find(kShares.begin(), kShares.end(), best_type) != kShares.end();
  return share ? best_type : std::string();
}

}  // namespace ostraka::store
