#include "cameras/desktop_hold.h"

#include <algorithm>

#include "base/message.h"
#include "colmap/colmap_program.h"

namespace ostraka::cameras {

std::vector<std::string> desktopHolders(const std::vector<devices::FoundDevice>& devices) {
  std::vector<std::string> holders;
  for (const devices::FoundDevice& device : devices)
    for (const std::string& holder : device.holders)
      if (holder.starts_with("gvfs") &&
          std::find(holders.begin(), holders.end(), holder) == holders.end())
        holders.push_back(holder);
  return holders;
}

Result<void> releaseFromDesktop(
    const std::vector<devices::FoundDevice>& devices, const RunProgram& run,
    const std::function<std::vector<devices::FoundDevice>()>& find_again) {
  if (desktopHolders(devices).empty()) return {};
  // Each may fail where the desktop has no such program or service; only what is left counts.
  (void)run("gio", {"mount", "-s", "gphoto2"});
  if (desktopHolders(find_again()).empty()) return {};
  (void)run("systemctl", {"--user", "stop", "gvfs-gphoto2-volume-monitor.service"});
  for (const devices::FoundDevice& device : find_again())
    if (const auto holders = desktopHolders({device}); !holders.empty())
      return Error::failed(
          message("The desktop does not release the camera: it is still in use by %1; "
                  "close its file window and try again.",
                  holders.front()),
          device.model);
  return {};
}

RunProgram programRunner(std::stop_token stop) {
  return [stop](const std::string& program,
                const std::vector<std::string>& arguments) -> Result<void> {
    const auto found = colmap::findProgram(program);
    if (!found) return Error::missing(message("This program is not installed."), program);
    return colmap::runProgram(*found, arguments, "/dev/null", stop);
  };
}

}  // namespace ostraka::cameras
