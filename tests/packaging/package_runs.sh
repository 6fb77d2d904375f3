#!/bin/sh
# Installs a package into a clean Debian, works there, purges it, and lists what is left: nothing but
# what the person made. By hand, as root: it fetches Debian (mmdebstrap).
#   package_runs.sh PACKAGE.deb [SUITE]        SUITE: bookworm (default) or trixie
set -eu
package=${1:?"name the package"}
suite=${2:-bookworm}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
root=$scratch/root
wrong() { echo "package_runs: $*" >&2; exit 1; }
mmdebstrap --mode=root --variant=apt --skip=cleanup/apt "$suite" "$root"
mkdir -p "$root/srv"
cp "$package" "$root/srv/ostraka.deb"
# With a /proc of its own; services of what is installed do not start in a chroot.
printf '#!/bin/sh\nexit 101\n' > "$root/usr/sbin/policy-rc.d"
chmod +x "$root/usr/sbin/policy-rc.d"
inside() {
  unshare --mount --pid --fork --mount-proc="$root/proc" chroot "$root" env -i \
    PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}
# Files, but for the bookkeeping of apt and dpkg, logs, and the linker's cache.
files() {
  (cd "$root" && find . \( -path ./proc -o -path ./sys -o -path ./dev -o -path ./tmp -o -path ./var/cache/apt \
    -o -path ./var/lib/apt -o -path ./var/lib/dpkg -o -path ./var/log -o -path ./root \) -prune \
    -o ! -name 'ld.so.cache*' -print | sort)
}
files > "$scratch/before"
inside apt-get install -q -y --no-install-recommends /srv/ostraka.deb > "$scratch/apt" 2>&1 || {
  tail -n 30 "$scratch/apt"
  wrong "the package does not install on $suite"
}
inside ostraka --version
inside ostraka doctor || wrong "doctor misses something"
inside ostraka rig simulate --output /root/batch --seed 7 --sherds 2 --width 640
status=0
inside ostraka process /root/batch --output /root/sherds || status=$?
[ "$status" -eq 0 ] || [ "$status" -eq 3 ] || wrong "process ended with $status"
find "$root/root/sherds" -name model.ply | grep -q . || wrong "there is no model"

inside apt-get remove -q -y ostraka > "$scratch/apt" 2>&1
inside dpkg --list ostraka | tail -n 1
inside apt-get purge -q -y --autoremove ostraka > "$scratch/apt" 2>&1
files > "$scratch/after"
comm -13 "$scratch/before" "$scratch/after" > "$scratch/left"
echo "left after purge beside the person's own folder:"
cat "$scratch/left"
if grep -i ostraka "$scratch/left"; then wrong "the package leaves files behind"; fi
[ -s "$root/root/sherds/report.html" ] || wrong "purging took the person's files"
echo "package_runs: all ran on $suite"
