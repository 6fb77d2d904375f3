#pragma once
#include <cstdio>
#include <cstdlib>

namespace ostraka::fuzz {

/// Ends the program, which the fuzzer keeps the input of, when a promise was not kept.
inline void must(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

}  // namespace ostraka::fuzz
