#!/bin/sh
# Installs what is needed, builds with warnings as errors, and runs the tests. The last lines say how
# many passed. Needs a network the first time, and no more than 2 cores and 4 GB of memory.
set -eu
cd "$(dirname "$0")/.."

packaging/install-packages.sh
cmake --preset ci
cmake --build --preset ci
log=build/ci/tests.log
status=0
ctest --preset ci > "$log" 2>&1 || status=$?
if [ "$status" -ne 0 ]; then
  cat "$log"
fi
echo "----"
tail -n 12 "$log"
exit "$status"
