#include "store/network_share.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <vector>

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 19> kShares = {
    "nfs",        "nfs4",   "cifs",       "smb3",        "smbfs",           "ncpfs",
    "afs",        "ceph",   "glusterfs",  "9p",          "vboxsf",          "vmhgfs",
    "davfs",      "lustre", "fuse.sshfs", "fuse.rclone", "fuse.gvfsd-fuse", "fuse.glusterfs",
    "fuse.davfs2"};

// Blanks in mount points are written as \040.
std::string unescaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 3 < text.size()) {
      out +=
          static_cast<char>((text[i + 1] - '0') * 64 + (text[i + 2] - '0') * 8 + text[i + 3] - '0');
      i += 3;
    } else {
      out += text[i];
    }
  }
  return out;
}

bool contains(const std::string& mount, const std::string& path) {
  if (mount == "/") return true;
  return path.starts_with(mount) && (path.size() == mount.size() || path[mount.size()] == '/');
}

}  // namespace

std::string networkShareOf(const fs::path& folder, std::string_view mount_info) {
  const std::string path = folder.string();
  std::string best_mount, best_type;
  std::istringstream lines{std::string(mount_info)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    const auto dash = std::find(all.begin(), all.end(), "-");
    if (all.size() < 7 || dash == all.end() || std::next(dash) == all.end()) continue;
    const std::string mount = unescaped(all[4]);
    // Of two mounts in one place the later one covers the earlier.
    if (contains(mount, path) && mount.size() >= best_mount.size()) {
      best_mount = mount;
      best_type = *std::next(dash);
    }
  }
  const bool share = std::find(kShares.begin(), kShares.end(), best_type) != kShares.end();
  return share ? best_type : std::string();
}

std::string networkShareOf(const fs::path& folder) {
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(folder, ignored);
  std::ifstream file("/proc/self/mountinfo");
  std::ostringstream text;
  text << file.rdbuf();
  return networkShareOf(real, text.str());
}

}  // namespace ostraka::store
