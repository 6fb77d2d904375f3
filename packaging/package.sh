#!/bin/sh
# Builds the Debian packages, looks through them, and names the file to install. A build folder that
# is finished may be given: then nothing is built, and the packages lie in the output folder.
#   packaging/package.sh [BUILD_FOLDER [OUTPUT_FOLDER]]
set -eu
build=${1:+$(realpath -e "$1")}
output=${2:+$(mkdir -p "$2" && realpath "$2")}
cd "$(dirname "$0")/.."

if [ -z "$build" ]; then
  packaging/install-packages.sh
  cmake --preset release -D BUILD_TESTING=OFF -D CMAKE_INSTALL_PREFIX=/usr
  cmake --build --preset release --target ostraka ostraka_shared
  build=$PWD/build/release
fi
output=${output:-$build}
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$output"
rm -rf "$output/_CPack_Packages"
version=$(sed -n 's/^set(CPACK_PACKAGE_VERSION "\(.*\)")$/\1/p' "$build/CPackConfig.cmake")
package=$(find "$output" -maxdepth 1 -name "ostraka_${version}-*.deb" | sort | tail -n 1)
packaging/check-contents.sh "$package"
# Where Debian's own check is installed, it finds nothing that is not explained beside its name.
if command -v lintian > /dev/null; then
  lintian --no-cfg --fail-on error,warning --allow-root "$output"/*ostraka*_"$version"-*.deb
fi
echo
echo "Install it with: sudo apt install $package"
