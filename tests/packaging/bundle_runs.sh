#!/bin/sh
# Unpacks a bundle into a clean Debian 13 without anything that Ostraka needs, and works there: the
# version, doctor, a simulated batch to its models, the window without a screen. By hand, as root:
# it fetches Debian (mmdebstrap) unless a root of it is given as a tar file.
#   bundle_runs.sh BUNDLE.tar.xz [ROOT.tar]
set -eu
bundle=${1:?"name the bundle"}
(cd "$(dirname "$bundle")" && sha256sum --check --quiet "$(basename "$bundle").sha256")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [ $# -gt 1 ]; then
  mkdir "$scratch/root"
  tar -C "$scratch/root" --exclude=./dev -xf "$2"
else
  mmdebstrap --variant=essential trixie "$scratch/root" http://deb.debian.org/debian
fi
mkdir -p "$scratch/root/dev" "$scratch/root/opt/a folder"
[ -e "$scratch/root/dev/null" ] || mknod -m 666 "$scratch/root/dev/null" c 1 3
[ -e "$scratch/root/dev/urandom" ] || mknod -m 666 "$scratch/root/dev/urandom" c 1 9
tar -C "$scratch/root/opt/a folder" -xf "$bundle"
program="/opt/a folder/$(basename "$bundle" .tar.xz)/ostraka"
# With a /proc of its own, which the program loader asks for where the program lies.
mkdir -p "$scratch/root/proc"
inside() {
  unshare --mount --pid --fork --mount-proc="$scratch/root/proc" chroot "$scratch/root" env -i PATH=/usr/sbin:/usr/bin HOME=/root LC_ALL=C.UTF-8 \
    "$@"
}
wrong() { echo "bundle_runs: $*" >&2; exit 1; }

grep -q trixie "$scratch/root/etc/os-release" || wrong "the root is not Debian 13"
inside "$program" --version | grep -q '^ostraka [0-9]' || wrong "no version"

inside "$program" doctor || wrong "doctor misses something"

status=0
inside QT_QPA_PLATFORM=offscreen timeout 10 "$program" > "$scratch/window" 2>&1 || status=$?
cat "$scratch/window"
[ "$status" -eq 124 ] || wrong "the window ended by itself with $status"

inside "$program" rig simulate --output /root/batch --seed 7 --sherds 2 --width 640
status=0
inside "$program" process /root/batch --output /root/sherds --draft || status=$?
[ "$status" -eq 0 ] || [ "$status" -eq 3 ] || wrong "process ended with $status"
[ -s "$scratch/root/root/sherds/report.html" ] || wrong "there is no report"
find "$scratch/root/root/sherds" -name model.ply | grep -q . || wrong "there is no model"
echo "bundle_runs: all ran"
