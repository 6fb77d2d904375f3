#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace ostraka::store {

/// The kind of network share that the folder lies on (nfs4, cifs, fuse.sshfs, ...), empty when it
/// lies on a disk of this computer. mount_info: as /proc/self/mountinfo.
std::string networkShareOf(const std::filesystem::path& folder, std::string_view mount_info);
std::string networkShareOf(const std::filesystem::path& folder);

}  // namespace ostraka::store
