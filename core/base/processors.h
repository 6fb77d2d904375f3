#pragma once

/// Before a function: it is compiled for newer processors too and chosen at run time; with plain
/// arithmetic and no contraction it gives the same bits on all. Not under the thread sanitizer,
/// which is not there yet when the choice is made.
#ifdef __SANITIZE_THREAD__
#define OSTRAKA_CLONED
#else
#define OSTRAKA_CLONED __attribute__((target_clones("arch=x86-64-v3", "default")))
#endif
