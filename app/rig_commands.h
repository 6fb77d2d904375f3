#pragma once
#include "command.h"

namespace ostraka::app {

/// Sub-commands of `ostraka rig`.
void addRigCalibrate(CLI::App& rig, Command& chosen);
void addRigPredict(CLI::App& rig, Command& chosen);

}  // namespace ostraka::app
