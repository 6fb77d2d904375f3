#!/bin/bash
# Starts the image of a stick in QEMU, waits for the window, makes and registers scans there over the
# serial line (with KVM also a small batch of photographs), and switches off. Screenshots and the record of the line go to the output folder.
# By hand: without KVM it takes long. Needs qemu-system-x86, ovmf, mtools, socat, imagemagick.
#   stick_boot.sh IMAGE OUTPUT_FOLDER [bios|uefi]       (SECONDS_AT_MOST=3600)
# An encrypted stick gets the passphrase 'ostraka', typed as a person would.
set -euo pipefail
image=${1:?"name the image"}
output=$(mkdir -p "${2:?"name the output folder"}" && cd "$2" && pwd)
firmware=${3:-bios}
at_most=${SECONDS_AT_MOST:-3600}
wrong() { echo "stick_boot: $*" >&2; exit 1; }

kernel='console=tty0 console=ttyS0,115200 systemd.show_status=yes'
acceleration=(-accel kvm)
if [ ! -w /dev/kvm ]; then
  # Everything takes long then, and minutes the clearing of each page that once held code, but for a
  # small cache of translated code and a processor that clears by words.
  acceleration=(-accel 'tcg,tb-size=256')
  kernel+=' init_on_alloc=0 mitigations=off'
  kernel+=' systemd.default_timeout_start_sec=900 systemd.default_device_timeout_sec=900'
fi

# A copy, on a stick larger than the image; its kernel speaks on the serial line, too.
stick=$output/stick.img
cp --sparse=always "$image" "$stick"
truncate -s +3G "$stick"
mcopy -n -i "$stick@@1048576" ::/boot/grub/grub.cfg "$output/grub.cfg"
sed -i "1i set options=\"$kernel\"" "$output/grub.cfg"
mcopy -o -i "$stick@@1048576" "$output/grub.cfg" ::/boot/grub/grub.cfg

# shellcheck disable=SC2054  # commas belong to QEMU's words
options=("${acceleration[@]}" -cpu Nehalem -smp 2 -m 3072 -display none -vga std -nic none -rtc base=utc
  -monitor "unix:$output/monitor,server,nowait"
  -chardev "pipe,id=line,path=$output/line" -serial chardev:line
  -device qemu-xhci -device usb-storage,drive=stick,removable=on
  -drive "id=stick,if=none,format=raw,file=$stick")
if [ "$firmware" = uefi ]; then
  cp /usr/share/OVMF/OVMF_VARS_4M.fd "$output/vars.fd"
  # shellcheck disable=SC2054
  options+=(-drive if=pflash,format=raw,readonly=on,file=/usr/share/OVMF/OVMF_CODE_4M.fd
    -drive "if=pflash,format=raw,file=$output/vars.fd")
fi
rm -f "$output"/line.{in,out}
mkfifo "$output/line.in" "$output/line.out"
qemu-system-x86_64 "${options[@]}" &
machine=$!
cat "$output/line.out" > "$output/line.log" &
trap 'kill $machine 2> /dev/null || true; rm -f "$output"/line.{in,out} "$output/monitor"' EXIT
exec 3> "$output/line.in"
begin=$SECONDS
monitor() { echo "$*" | socat - "unix-connect:$output/monitor" > /dev/null; }
screenshot() {
  monitor "screendump $output/$1.ppm"
  sleep 2
  convert "$output/$1.ppm" "$output/$1.png" && rm "$output/$1.ppm"
}
until_line() {  # until the serial line has said it
  until grep -qaE "$1" "$output/line.log"; do
    kill -0 "$machine" 2> /dev/null || wrong "the machine ended before it said '$1'"
    [ $((SECONDS - begin)) -lt "$at_most" ] || { screenshot timeout; wrong "no '$1' in time"; }
    sleep 2
    [ -z "${2:-}" ] || "$2"
  done
  echo "stick_boot: '$1' after $((SECONDS - begin)) s"
}
typed=0
type_passphrase() {  # twice to choose it, once to open
  [ "$encrypted" = yes ] || return 0
  [ $((SECONDS - begin)) -gt $((typed * 60 + 120)) ] || return 0
  for key in o s t r a k a ret; do monitor "sendkey $key"; done
  typed=$((typed + 1))
}
start=$(sfdisk --json "$image" | sed -n 's/.*"start": *\([0-9]*\).*/\1/p' | tail -n 1)
encrypted=no
! dd if="$image" bs=512 skip="$start" count=1 status=none | tr -d '\0' | grep -qa 'format as luks' || encrypted=yes

until_line 'ostraka login:'
echo lab >&3
until_line 'lab@ostraka'
# Words that the echo of what is typed does not have.
run() { echo "$1; echo \"$2=\"\$?" >&3; until_line "$2=[0-9]" "${3:-}"; }
run 'until pgrep -x ostraka; do sleep 2; done' started type_passphrase
# The window is there when its process rests: less than half a second of work in twenty.
# shellcheck disable=SC2016  # for the shell on the stick
run 'work() { cut -d " " -f 14,15 "/proc/$(pgrep -xo ostraka)/stat" | tr " " +; }
  before=-9999; until now=$(($(work))); [ $((now - before)) -lt 50 ]; do before=$now; sleep 20; done; systemd-analyze' window
screenshot window
run 'mountpoint /projects' mounted
run 'df -h /projects; systemctl --failed --no-pager; /usr/sbin/lpinfo -m | wc -l; fc-list | wc -l' looked
run 'cd /projects; ostraka --version; DISPLAY=:0 ostraka doctor' doctor
run 'ostraka rig simulate --output scans --seed 7 --sherds 1 --scans-only' scanned
run 'ostraka register --front scans/front --back scans/back --output registered' registered
if [ -w /dev/kvm ]; then  # photographs take too long without it
  run 'ostraka rig simulate --output batch --seed 7 --sherds 1 --width 400 --stops 4' simulated
  run 'ostraka process batch --output sherds --draft' processed
fi
screenshot after
echo 'sudo systemctl poweroff' >&3
for _ in $(seq 300); do
  kill -0 "$machine" 2> /dev/null || break
  sleep 2
done
! kill -0 "$machine" 2> /dev/null || wrong "it does not switch off"
grep -qa 'mounted=0' "$output/line.log" || wrong "the projects are not mounted"
grep -qa 'registered=0' "$output/line.log" || wrong "the scans were not registered"
if [ -w /dev/kvm ]; then
  grep -qa 'processed=[03]' "$output/line.log" || wrong "the batch was not processed"  # 3: to be reviewed
fi
echo "stick_boot: all ran by $firmware; look at $output/window.png"
