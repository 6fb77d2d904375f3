#include "segmentation/shipped_network.h"

// The bytes of resources/network/sherds.onnx.
asm(".section .rodata\n"
    ".balign 16\n"
    "ostraka_network_begin:\n"
    ".incbin \"" OSTRAKA_NETWORK
    "\"\n"
    "ostraka_network_end:\n"
    ".previous\n");
extern "C" const char ostraka_network_begin[], ostraka_network_end[];

namespace ostraka::segmentation {

std::string_view shippedNetwork() {
  return {ostraka_network_begin,
          static_cast<std::size_t>(ostraka_network_end - ostraka_network_begin)};
}

}  // namespace ostraka::segmentation
