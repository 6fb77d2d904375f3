#!/bin/sh
# Opens the stick's second partition at /projects. At the first start it grows to the end of the
# stick and is formatted as stick.sh noted in it; one that holds anything else is never formatted.
set -eu
kernel_option() { sed -n "s/.*ostraka\.$1=\([^ ]*\).*/\1/p" /proc/cmdline; }

# A passphrase is typed with the keyboard of the chosen language.
layout=$(kernel_option keyboard)
sed -i "s/^XKBLAYOUT=.*/XKBLAYOUT=\"${layout:-us}\"/" /etc/default/keyboard
setupcon --keyboard-only || true

system=$(findmnt -n -o SOURCE /run/live/medium)
partition=${system%1}2
disk=/dev/$(lsblk -n -d -o PKNAME "$system")
device=$partition
noted=$(head -c 64 "$partition" | tr -d '\0')
kind=
case "$noted" in
  "ostraka: format as "*) kind=${noted#ostraka: format as } ;;
esac
if [ -n "$kind" ]; then
  echo 'Preparing the space for projects. This happens once.'
  echo ', +' | sfdisk --quiet --no-reread --no-tell-kernel -N 2 "$disk"
  partx --update --nr 2 "$disk"
  udevadm settle
fi
open_encrypted() {
  until cryptsetup open "$partition" projects; do :; done
  device=/dev/mapper/projects
}
case "$kind" in
  luks)
    echo 'Choose a passphrase for the projects on this stick. Without it nobody can read them.'
    # 256 MB of memory to open it, so that small computers can.
    until cryptsetup luksFormat --batch-mode --verify-passphrase --type luks2 \
      --pbkdf-memory 262144 "$partition"; do :; done
    open_encrypted
    mkfs.ext4 -q -F -m 0 -L projects "$device"
    ;;
  ext4) mkfs.ext4 -q -F -m 0 -L projects "$device" ;;
  exfat) mkfs.exfat -q -L PROJECTS "$device" ;;
  *)
    if cryptsetup isLuks "$partition"; then
      echo 'The projects on this stick are encrypted.'
      open_encrypted
    fi
    ;;
esac
case "$(blkid -o value -s TYPE "$device")" in
  exfat) mount -o noatime,uid=lab,gid=lab,umask=077 "$device" /projects ;;
  *)
    mount -o noatime "$device" /projects
    chown lab:lab /projects
    ;;
esac
