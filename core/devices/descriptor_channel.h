#pragma once
#include <functional>
#include <memory>
#include <string>

#include "devices/byte_channel.h"

namespace ostraka::devices {

/// A channel over a file descriptor that can be polled; open gives a fresh one.
std::unique_ptr<ByteChannel> makeDescriptorChannel(std::string name, int descriptor,
                                                   std::function<Result<int>()> open);

}  // namespace ostraka::devices
