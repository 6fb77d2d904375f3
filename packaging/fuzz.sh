#!/bin/sh
# Feeds every reader of foreign bytes its corpus and then SECONDS of new input, under the address and
# undefined behaviour sanitizers. What ends a reader is kept in build/fuzz/found and printed in base64;
# add it to the target's corpus with the change that mends it. A reader fails that crashes, leaks,
# takes 2 GB of memory, or 100 s for one input of at most 64 KiB: a slow machine fails none that takes
# milliseconds.
#   packaging/fuzz.sh SECONDS [TARGET...]
# FUZZ_SEED=N tries new inputs in the same order each time.
set -eu
cd "$(dirname "$0")/.."
seconds=${1:?"say for how many seconds each target runs"}
shift

packaging/install-packages.sh
cmake --preset fuzz
cmake --build --preset fuzz
[ $# -gt 0 ] || set -- $(ls tests/fuzz/corpus)
mkdir -p build/fuzz/found
export ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1
export LSAN_OPTIONS=suppressions=$PWD/tests/sanitizers/lsan.supp
status=0
printf '%s\n' "$@" | SECONDS_EACH=$seconds xargs -P 2 -I NAME sh -c '
  mkdir -p build/fuzz/new/NAME
  build/fuzz/tests/fuzz/fuzz --target=NAME -max_total_time="$SECONDS_EACH" -timeout=100 -seed="${FUZZ_SEED:-0}" \
    -rss_limit_mb=2048 -max_len=65536 -artifact_prefix=build/fuzz/found/NAME- \
    build/fuzz/new/NAME tests/fuzz/corpus/NAME > build/fuzz/NAME.log 2>&1 &&
    echo "NAME: $(tail -n 1 build/fuzz/NAME.log)" ||
    { : > build/fuzz/found/NAME-failed
      tail -n 60 build/fuzz/NAME.log
      for found in build/fuzz/found/NAME-*; do
        [ ! -s "$found" ] || { echo "$found:"; base64 "$found"; }
      done
      echo "NAME: FAILED"; exit 1; }' || status=1
exit $status
