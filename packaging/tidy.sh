#!/bin/sh
# Reads core and app with clang-tidy (.clang-tidy), or the files that are named; nothing is built.
# Says what it found, and ends with status 1 if that is anything.
#   packaging/tidy.sh [FILE...]
set -eu
cd "$(dirname "$0")/.."
if ! command -v clang-tidy > /dev/null; then
  echo "tidy.sh: install clang-tidy first: sudo apt install clang-tidy" >&2
  exit 2
fi
cmake --preset tidy > /dev/null
if [ "$#" -eq 0 ]; then
  # shellcheck disable=SC2046  # words are wanted; no name of ours has a space
  set -- $(git ls-files 'core/*.cpp' 'app/*.cpp')
fi
printf '%s\n' "$@" |
  xargs -P "$(nproc)" -n 1 clang-tidy -p build/tidy --quiet --warnings-as-errors='*' 2> /dev/null
