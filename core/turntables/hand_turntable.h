#pragma once
#include <memory>

#include "devices/turntable.h"

namespace ostraka::turntables {

/// A table without a motor: a person is told where to turn it. The markers in the photographs check
/// that they did.
std::unique_ptr<devices::Turntable> openHandTurntable(devices::AskPerson ask);

}  // namespace ostraka::turntables
