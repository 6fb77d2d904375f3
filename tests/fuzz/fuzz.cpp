// One program for all targets: fuzz --target=NAME [options of libFuzzer] [CORPUS...]
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "targets.h"

namespace {

const ostraka::fuzz::Target* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  constexpr std::string_view kOption = "--target=";
  for (int i = 1; i < *argc; ++i) {
    const std::string_view argument = (*argv)[i];
    if (!argument.starts_with(kOption)) continue;
    for (const ostraka::fuzz::Target& target : ostraka::fuzz::targets())
      if (target.name == argument.substr(kOption.size())) chosen = &target;
  }
  if (chosen) return 0;
  std::fprintf(stderr, "Name a target with --target=NAME, one of:");
  for (const ostraka::fuzz::Target& target : ostraka::fuzz::targets())
    std::fprintf(stderr, " %s", target.name.data());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  chosen->run({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
