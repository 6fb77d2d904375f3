#pragma once
#include <filesystem>
#include <string>

namespace ostraka::store {

/// The kind of network share that the folder lies on (nfs4, cifs, fuse.sshfs, ...), empty when it
/// lies on a disk of this computer. mounts: a table of mounted file systems, as in fstab(5).
std::string networkShareOf(const std::filesystem::path& folder,
                           const std::filesystem::path& mounts = "/proc/self/mounts");

}  // namespace ostraka::store
