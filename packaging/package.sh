#!/bin/sh
# Builds the Debian package, looks through it, and names the file to install.
set -eu
cd "$(dirname "$0")/.."

packaging/install-packages.sh
cmake --preset release -D BUILD_TESTING=OFF -D CMAKE_INSTALL_PREFIX=/usr
cmake --build --preset release --target ostraka ostraka_shared
(cd build/release && cpack -G DEB)
package=$(find build/release -maxdepth 1 -name 'ostraka_*.deb' -newer build/release/CPackConfig.cmake | sort | tail -n 1)
packaging/check-contents.sh "$package"
echo
echo "Install it with: sudo apt install ./$package"
