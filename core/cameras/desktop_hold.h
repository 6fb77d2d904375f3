#pragma once
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.h"
#include "devices/devices.h"

namespace ostraka::cameras {

/// Runs a program with arguments; Missing when it is not installed, Failed when it ended badly.
using RunProgram = std::function<Result<void>(const std::string& program,
                                              const std::vector<std::string>& arguments)>;

/// Desktops open cameras as soon as they are plugged in (gvfs). Asks them to let go, first of what
/// is mounted, then by stopping the service that mounts for this session; no root is needed and
/// nothing outlasts the session. devices: as findDevices gave them; cameras that nobody holds are
/// left alone. Errors: Failed (a camera is still held; the sentence says by what).
Result<void> releaseFromDesktop(
    const std::vector<devices::FoundDevice>& devices, const RunProgram& run,
    const std::function<std::vector<devices::FoundDevice>()>& find_again);

/// The desktop's programs that hold a camera, "gvfsd-gphoto2 (1234)"; releaseFromDesktop helps
/// where there are any.
std::vector<std::string> desktopHolders(const std::vector<devices::FoundDevice>& devices);

/// RunProgram for real; what the program says is dropped.
RunProgram programRunner(std::stop_token stop);

}  // namespace ostraka::cameras
