#include <cstddef>
#include <cstdint>

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  ostraka::fuzz::decisions({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
