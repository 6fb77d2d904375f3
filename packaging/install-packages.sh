#!/bin/sh
# Installs everything that Ostraka needs to build, test and run on Debian 12. Runs as root or with
# sudo, asks nothing, and may be run again.
set -eu

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null 2>&1; then
  as_root="sudo"
else
  echo "install-packages.sh: run it as root, or install sudo first." >&2
  exit 1
fi

packages="
  build-essential cmake ninja-build ccache mold file clang libclang-rt-14-dev
  libeigen3-dev libopencv-dev libopencv-contrib-dev libceres-dev libnanoflann-dev libpcl-dev
  libsqlite3-dev libusb-1.0-0-dev libgphoto2-dev libexif-dev libheif-dev libraw-dev libqrencode-dev libzxingcore-dev
  qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
  libvtk9-dev pkgconf poppler-utils xvfb xauth openbox libgl1-mesa-dri fonts-dejavu-core
  libumockdev-dev umockdev libeatmydata1
  libicu-dev libfreetype-dev libfontconfig-dev libjpeg-dev libpng-dev libtiff-dev libembree-dev nlohmann-json3-dev libcli11-dev libssl-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  python3 python3-numpy python3-scipy colmap
  slurm-wlm munge rsync openssh-client
"

# With everything there already, no network is needed.
missing=""
for package in $packages; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
if [ -z "$missing" ]; then
  echo "All packages are installed."
  exit 0
fi

# shellcheck disable=SC2086  # words are wanted
$as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
