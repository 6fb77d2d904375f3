#include "capture/desktop_hold.h"

#include <algorithm>

#include "rig/colmap_program.h"

namespace ostraka::capture {

bool heldByDesktop(const std::vector<FoundDevice>& devices) {
  return std::any_of(devices.begin(), devices.end(), [](const FoundDevice& device) {
    return std::any_of(device.holders.begin(), device.holders.end(),
                       [](const std::string& holder) { return holder.starts_with("gvfs"); });
  });
}

Result<void> releaseFromDesktop(const std::vector<FoundDevice>& devices, const RunProgram& run,
                                const std::function<std::vector<FoundDevice>()>& find_again) {
  if (!heldByDesktop(devices)) return {};
  // Each may fail where the desktop has no such program or service; only what is left counts.
  (void)run("gio", {"mount", "-s", "gphoto2"});
  if (!heldByDesktop(find_again())) return {};
  (void)run("systemctl", {"--user", "stop", "gvfs-gphoto2-volume-monitor.service"});
  for (const FoundDevice& device : find_again())
    if (heldByDesktop({device}))
      return Error{ErrorCode::Failed,
                   "The desktop does not let go of the camera: it is still held by " +
                       device.holders.front() + "; close its window of files and try again.",
                   device.model};
  return {};
}

RunProgram programRunner(std::stop_token stop) {
  return [stop](const std::string& program,
                const std::vector<std::string>& arguments) -> Result<void> {
    const auto found = rig::findProgram(program);
    if (!found) return Error{ErrorCode::Missing, "This program is not installed.", program};
    return rig::runProgram(*found, arguments, "/dev/null", stop);
  };
}

}  // namespace ostraka::capture
