#include "segmentation/shipped_network.h"

#include <cstddef>

// The bytes of resources/network/sherds.onnx: as an array in C++ they would take a compiler
// minutes.
asm(".section .rodata\n"
    ".balign 16\n"
    ".globl ostraka_network_begin, ostraka_network_end\n"
    ".hidden ostraka_network_begin, ostraka_network_end\n"
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
