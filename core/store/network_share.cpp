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

// SQLite's -shm is memory that two computers do not share, whichever of these it lies on; each
// stands between blanks.
constexpr std::string_view kShares =
    " nfs nfs4 cifs smb3 smbfs ncpfs afs ceph glusterfs 9p vboxsf vmhgfs virtiofs davfs lustre "
    "gpfs "
    "beegfs fhgfs orangefs pvfs2 panfs wekafs fuse.sshfs fuse.rclone fuse.gvfsd-fuse "
    "fuse.glusterfs "
    "fuse.davfs2 fuse.s3fs fuse.juicefs ";

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
  const bool share = kShares.find(" " + best_type + " ") != std::string_view::npos;
  return share ? best_type : std::string();
}

}  // namespace ostraka::store
