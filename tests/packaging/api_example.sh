#!/bin/sh
# Installs the library and its headers into an empty folder, and builds and runs the example against
# them alone, as another house would; then looks at what is installed and what the library shows.
#   api_example.sh BUILD_FOLDER CXX_COMPILER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tree=$scratch/tree
wrong() {
  echo "api_example: $*" >&2
  exit 1
}
quietly() {
  "$@" > "$scratch/log" 2>&1 || { cat "$scratch/log"; wrong "failed: $*"; }
}
for component in library development; do
  quietly cmake --install "$1" --prefix "$tree" --component $component
done
configure() {
  cmake -S "$here/example" -B "$scratch/$1" -D CMAKE_CXX_COMPILER="$2" -D CMAKE_PREFIX_PATH="$tree" \
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
}
quietly configure build "$2"
quietly cmake --build "$scratch/build"
quietly "$scratch/build/example" "$scratch/slab.ply"
[ -s "$scratch/slab.ply" ] || wrong "the example wrote no model"

# Headers that a program without Qt, VTK, PCL and OpenCV can read.
if grep -rnE '#include *[<"](Q[A-Z]|vtk|pcl|opencv|nlohmann)' "$tree/include"; then
  wrong "an installed header includes what its users need not have"
fi
library=$(find "$tree" -name 'libostraka.so.*' -type f)
[ -n "$library" ] || wrong "no library is installed"
nm -D --defined-only -C "$library" | sed -n 's/^[0-9a-f]* [TWVBDR] //p' | grep '^ostraka::' |
  grep -vE '^ostraka::(api::|Message|about[[(]|inOne[[(]|linesOf[[(])' > "$scratch/shown" || true
[ ! -s "$scratch/shown" ] || wrong "the library shows more than its API: $(head -n 3 "$scratch/shown")"

# A version that the library does not have is not found.
sed 's/Ostraka 0.1 /Ostraka 99.0 /' "$here/example/CMakeLists.txt" > "$scratch/CMakeLists.txt"
cp "$here/example/example.cpp" "$scratch"
if cmake -S "$scratch" -B "$scratch/other" -D CMAKE_PREFIX_PATH="$tree" > "$scratch/log" 2>&1; then
  wrong "version 99.0 was found"
fi
grep -q 'not compatible\|compatible with requested version' "$scratch/log" ||
  wrong "not the version was refused: $(cat "$scratch/log")"
