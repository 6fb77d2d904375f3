#pragma once
#include <cstdio>
#include <cstdlib>

#include "base/result.h"

namespace ostraka::fuzz {

/// Ends the program, which the fuzzer keeps the input of, when a promise was not kept.
inline void must(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

template <class T>
void mustNameItself(const Result<T>& result) {
  if (!result) must(!result.error().what.empty(), "an error has a sentence");
}

}  // namespace ostraka::fuzz
