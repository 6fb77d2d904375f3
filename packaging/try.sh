#!/bin/sh
# Installs what is needed, builds Ostraka, makes a sample batch with the virtual rig, turns it into
# sherds, and names the report to open. The folder for all this may be given; default out/try.
set -eu
cd "$(dirname "$0")/.."
folder=${1:-out/try}

packaging/install-packages.sh
cmake --preset release -D BUILD_TESTING=OFF
cmake --build --preset release
ostraka=build/release/app/ostraka

if [ ! -e "$folder/batch" ]; then
  # Small: two minutes or so on two cores for both. It gets its name only when it is whole.
  rm -rf "$folder/batch.part"
  "$ostraka" rig simulate --output "$folder/batch.part" --seed 7 --sherds 3 --width 1000
  mv "$folder/batch.part" "$folder/batch"
fi
status=0
"$ostraka" process "$folder/batch" --output "$folder/sherds" || status=$?
if [ "$status" -ne 0 ] && [ "$status" -ne 3 ]; then
  exit "$status"
fi
echo
echo "Open this file in a browser: $(cd "$folder/sherds" && pwd)/report.html"
