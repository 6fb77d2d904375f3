#!/bin/bash
# Makes a folder that runs on any Linux with glibc 2.36 or newer without being installed, as an
# archive with its checksum, from what is built on Debian 12. Needs patchelf.
#   packaging/bundle.sh BUILD_FOLDER [OUTPUT_FOLDER]    (XZ_OPT=-0 packs faster, and larger)
set -euo pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
build=${1:?"name the build folder"}
output=$(mkdir -p "${2:-.}" && cd "${2:-.}" && pwd)
command -v patchelf > /dev/null || { echo "bundle: install patchelf first" >&2; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

DESTDIR=$scratch/installed cmake --install "$build" --prefix /usr --component program > /dev/null
version=$("$scratch/installed/usr/bin/ostraka" --version | sed -n '1s/[^0-9]*\([0-9.]*\).*/\1/p')
machine=$(uname -m)
name=ostraka-$version-linux-$machine
root=$scratch/$name
mv "$scratch/installed/usr" "$root"

# Plugins are loaded by name, so the linker's needs do not tell of them.
libraries=/usr/lib/$machine-linux-gnu
plugins=$libraries/qt6/plugins
mkdir -p "$root/plugins" "$root/camera" "$root/lib/if-missing"
for kind in platforms xcbglintegrations imageformats iconengines platforminputcontexts \
  printsupport wayland-shell-integration wayland-graphics-integration-client; do
  [ ! -d "$plugins/$kind" ] || cp -rL "$plugins/$kind" "$root/plugins/"
done
# Screens without a desktop: not for the window.
rm -f "$root"/plugins/platforms/lib{qeglfs,qlinuxfb,qminimal,qminimalegl,qvkkhrdisplay,qvnc}.so
cp -rL "$libraries"/libgphoto2/[0-9]* "$root/camera/drivers"
cp -rL "$libraries"/libgphoto2_port/[0-9]* "$root/camera/ports"
printf '[Paths]\nPrefix = ../..\nPlugins = plugins\n' > "$root/libexec/ostraka/qt.conf"

# glibc is the system's, always: the program loader and the C library must be of one version.
glibc='^(ld-linux.*|lib(c|m|mvec|dl|rt|pthread|resolv|util|anl|nss_.*|thread_db|BrokenLocale))\.so'
# The driver of the graphics card is the system's and loads these too. The system's are at least
# as new as its driver needs; ours serve where there are none, as on a cluster's node.
shared='^lib(GL|EGL|GLX|OpenGL|GLdispatch|GLESv2|drm.*|gbm|va.*|vdpau|OpenCL|vulkan|wayland-.*'
shared+='|X11.*|Xau|Xdmcp|Xext|Xfixes|Xxf86vm|xcb.*|xshmfence|stdc\+\+|gcc_s|expat|z|zstd|elf'
shared+='|ffi|xml2|tinfo|udev|systemd)\.so'

find "$root/bin/ostraka" "$root/libexec/ostraka" "$root/plugins" "$root/camera" -type f \
  \( -name '*.so' -o -name 'ostraka*' \) > "$scratch/programs"
: > "$scratch/sources"
while read -r file; do
  ldd "$file"
done < "$scratch/programs" > "$scratch/needs"
if grep 'not found' "$scratch/needs" >&2; then exit 1; fi
awk '$2 == "=>" && $3 ~ /^\// {print $1, $3}' "$scratch/needs" | sort -u -k1,1 > "$scratch/found"
while read -r library path; do
  if [[ $library =~ $glibc ]]; then continue; fi
  folder=$root/lib
  if [[ $library =~ $shared ]]; then
    folder=$root/lib/if-missing/$library
    mkdir -p "$folder"
  fi
  cp -L "$path" "$folder/$library"
  readlink -f "$path" >> "$scratch/sources"
done < "$scratch/found"

# Everything finds its needs from where it lies itself.
chmod -R u+w "$root"
patchelf --set-rpath "\$ORIGIN/../lib" "$root/bin/ostraka"
patchelf --set-rpath "\$ORIGIN/../../lib" "$root/libexec/ostraka/ostraka-window" "$root/libexec/ostraka/video_camera.so"
find "$root/lib" -maxdepth 1 -type f -exec patchelf --set-rpath "\$ORIGIN" {} +
find "$root/lib/if-missing" -type f -exec patchelf --set-rpath "\$ORIGIN/../.." {} +
find "$root/plugins" "$root/camera" -name '*.so' -exec patchelf --set-rpath "\$ORIGIN/../../lib" {} +

cat > "$root/ostraka" << 'LAUNCHER'
#!/bin/sh
# Starts Ostraka from wherever this folder lies.
root=$(dirname "$(readlink -f "$0")")
known=$(PATH=$PATH:/sbin:/usr/sbin ldconfig -p 2> /dev/null)
# What the system lacks and its graphics driver would share with us comes from this folder.
for library in "$root"/lib/if-missing/*; do
  case "$known" in
    *"	${library##*/} ("*) ;;
    *) LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$library ;;
  esac
done
[ -z "${LD_LIBRARY_PATH:-}" ] || export LD_LIBRARY_PATH
export CAMLIBS="$root/camera/drivers" IOLIBS="$root/camera/ports"
exec "$root/bin/ostraka" "$@"
LAUNCHER
chmod +x "$root/ostraka"

# Licences, and the versions whose sources Debian keeps at snapshot.debian.org.
(cd "$root/plugins" && find . -name '*.so' -printf "$plugins/%P\n") >> "$scratch/sources"
find "$libraries/libgphoto2" "$libraries/libgphoto2_port" -name '*.so' >> "$scratch/sources"
# A package may name the same file with or without the leading /usr.
{ cat "$scratch/sources"; sed 's|^/usr||' "$scratch/sources"; } |
  xargs dpkg-query -S 2> /dev/null | sed 's/: .*//; s/, /\n/g' | sort -u > "$scratch/packages" || true
mkdir -p "$root/licences"
# shellcheck disable=SC2016  # dpkg-query fills these in
xargs dpkg-query -W -f '${Package} ${Version} (source ${source:Package} ${source:Version})\n' \
  < "$scratch/packages" > "$root/licences/packages.txt"
while read -r package _; do
  cp -L "/usr/share/doc/$package/copyright" "$root/licences/$package"
done < "$root/licences/packages.txt"
cp "$here/copyright" "$root/licences/ostraka"

tar -C "$scratch" --sort=name --owner=0 --group=0 --numeric-owner -cf - "$name" |
  xz -T0 > "$output/$name.tar.xz.partial"
mv "$output/$name.tar.xz.partial" "$output/$name.tar.xz"
(cd "$output" && sha256sum "$name.tar.xz" > "$name.tar.xz.sha256")
echo "$output/$name.tar.xz"
