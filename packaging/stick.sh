#!/bin/bash
# Makes the image of a USB stick that starts Ostraka on any 64-bit PC, by BIOS or UEFI (with Secure
# Boot, too), and leaves the computer's own disk alone. A second partition holds the projects; at the
# first start it grows to the end of the stick. As root on Debian 12, with a network:
#   apt install mmdebstrap squashfs-tools mtools dosfstools fdisk grub-common grub-pc-bin \
#     grub-efi-amd64-signed shim-signed
#   packaging/stick.sh OUT.img --deb FILE|--bundle FILE [--encrypt|--exfat] [--root FOLDER]
# --encrypt   the projects are encrypted; the passphrase is chosen at the first start
# --exfat     Windows and macOS can read the projects; a power failure can harm them more than ext4
# --root      the system is made in FOLDER and left there; one that is there already is used again,
#             with the program of FILE
set -euo pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)/stick
usage() { sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2; }
image='' deb='' bundle='' root='' format=ext4
while [ $# -gt 0 ]; do
  case "$1" in
    --deb) deb=$(realpath -e "${2:?}"); shift ;;
    --bundle) bundle=$(realpath -e "${2:?}"); shift ;;
    --root) root=${2:?}; shift ;;
    --encrypt) format=luks ;;
    --exfat) format=exfat ;;
    -*) usage ;;
    *) image=$1 ;;
  esac
  shift
done
if [ -z "$image" ] || [ -z "$deb$bundle" ] || { [ -n "$deb" ] && [ -n "$bundle" ]; }; then usage; fi
[ "$(id -u)" -eq 0 ] || { echo "stick: run it as root" >&2; exit 1; }
scratch=$(mktemp -d -p "$(dirname "$image")")
trap 'rm -rf "$scratch"' EXIT
root=${root:-$scratch/root}
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C "$@"; }

# The system. Manual pages and other languages' texts are left out; licences stay.
if [ ! -d "$root" ]; then
  packages=$(grep -v '^#' "$here/packages.txt" | xargs | tr ' ' ,)
  options=(--dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/doc/*'
    --dpkgopt='path-include=/usr/share/doc/*/copyright' --dpkgopt='path-include=/usr/share/doc/ostraka/*'
    --dpkgopt='path-exclude=/usr/share/locale/*' --dpkgopt='path-include=/usr/share/locale/locale.alias')
  for language in de fr es el tr hy; do
    options+=(--dpkgopt="path-include=/usr/share/locale/$language/*")
  done
  [ -z "$deb" ] || options+=(--include="$deb"
    --hook-dir=/usr/share/mmdebstrap/hooks/file-mirror-automount)
  # shellcheck disable=SC2016  # mmdebstrap names the folder
  mmdebstrap --variant=minbase --mode=root --components=main,non-free-firmware \
    --essential-hook='mkdir -p "$1/etc/initramfs-tools/conf.d" "$1/usr/share/initramfs-tools/modules.d"' \
    --essential-hook="copy-in '$here/modules' /usr/share/initramfs-tools/modules.d" \
    --essential-hook='echo MODULES=list > "$1/etc/initramfs-tools/conf.d/stick"' \
    --include="$packages" "${options[@]}" bookworm "$root"
elif [ -n "$deb" ]; then
  cp "$deb" "$root/tmp/ostraka.deb"
  inside dpkg --install /tmp/ostraka.deb > /dev/null
  rm "$root/tmp/ostraka.deb"
fi
program=/usr/bin/ostraka
if [ -n "$bundle" ]; then
  program=/opt/ostraka/ostraka
  rm -rf "$root/opt/ostraka"
  mkdir -p "$root/opt/ostraka"
  tar -C "$root/opt/ostraka" --strip-components=1 -xf "$bundle"
  cp "$root/opt/ostraka/lib/udev/rules.d/70-ostraka.rules" "$root/etc/udev/rules.d/"
  for folder in applications icons mime; do
    cp -rT "$root/opt/ostraka/share/$folder" "$root/usr/share/$folder"
  done
fi
inside "$program" --version > /dev/null

# One person, who needs no password: who holds the stick may use it.
inside id lab > /dev/null 2>&1 || inside useradd --create-home --shell /bin/bash \
  --groups sudo,video,dialout,plugdev,lpadmin lab
inside passwd --quiet --delete lab
echo 'lab ALL=(ALL) NOPASSWD: ALL' > "$root/etc/sudoers.d/lab"
echo ostraka > "$root/etc/hostname"
printf '127.0.0.1 localhost ostraka\n::1 localhost\n' > "$root/etc/hosts"
: > "$root/etc/machine-id"
: > "$root/etc/fstab"
rm -f "$root/etc/resolv.conf" "$root/var/lib/dbus/machine-id"
for language in en_US de_DE fr_FR es_ES el_GR tr_TR hy_AM; do
  echo "$language.UTF-8 UTF-8"
done > "$root/etc/locale.gen"
inside locale-gen > /dev/null

install -D -m 755 "$here/projects.sh" "$root/usr/local/sbin/ostraka-projects"
install -D -m 755 "$here/session.sh" "$root/usr/local/bin/ostraka-session"
sed "s|PROGRAM|$program|" "$here/ostraka.sh" > "$root/usr/local/bin/ostraka"
chmod 755 "$root/usr/local/bin/ostraka"
install -m 644 "$here/projects.service" "$root/etc/systemd/system/ostraka-projects.service"
inside systemctl --quiet enable ostraka-projects
# What an installed system cares for on its own disk and in the network has nothing to do here.
inside systemctl --quiet disable e2scrub_reap e2scrub_all.timer fstrim.timer apt-daily.timer \
  apt-daily-upgrade.timer dpkg-db-backup.timer
install -D -m 644 "$here/polkit.rules" "$root/etc/polkit-1/rules.d/50-lab.rules"
mkdir -p "$root/projects" "$root/etc/systemd/system/getty@tty1.service.d"
cat > "$root/etc/systemd/system/getty@tty1.service.d/lab.conf" << 'END'
[Service]
ExecStart=
ExecStart=-/sbin/agetty --autologin lab --noclear %I $TERM
END
# shellcheck disable=SC2016  # for the shell of the person
echo '[ "$(tty)" != /dev/tty1 ] || exec startx /usr/local/bin/ostraka-session -- vt1 > .session.log 2>&1' \
  > "$root/home/lab/.profile"

# The desktop: what stands on it and in its menu; Ostraka's window fills the screen.
desktop=$root/home/lab/Desktop
mkdir -p "$desktop" "$root/home/lab/.config/pcmanfm/default" "$root/home/lab/.config/libfm"
cp "$root/usr/share/applications/ostraka.desktop" "$root/usr/share/applications/system-config-printer.desktop" "$desktop"
entry() {  # FILE COMMAND ICON NAME 'LANGUAGE NAME'...
  printf '[Desktop Entry]\nType=Application\nExec=%s\nIcon=%s\nName=%s\n' "$2" "$3" "$4"
  for name in "${@:5}"; do printf 'Name[%s]=%s\n' "${name%% *}" "${name#* }"; done
} > "$desktop/$1.desktop"
entry projects 'pcmanfm /projects' folder Projects 'de Projekte' 'fr Projets' 'es Proyectos' \
  'el Έργα' 'tr Projeler' 'hy Նախագծեր'
entry shutdown 'systemctl poweroff' system-shutdown 'Shut down' 'de Herunterfahren' 'fr Éteindre' \
  'es Apagar' 'el Τερματισμός' 'tr Kapat' 'hy Անջատել'
cp "$here/desktop.conf" "$root/home/lab/.config/pcmanfm/default/desktop-items-0.conf"
printf '[config]\nquick_exec=1\n' > "$root/home/lab/.config/libfm/libfm.conf"
cp "$here/menu.xml" "$root/etc/xdg/openbox/menu.xml"
grep -q 'class="ostraka"' "$root/etc/xdg/openbox/rc.xml" || sed -i 's|</applications>|\
  <application class="ostraka" type="normal"><focus>yes</focus><maximized>yes</maximized></application>\n&|' \
  "$root/etc/xdg/openbox/rc.xml"
inside chown -R lab:lab /home/lab

# The files of the first partition.
files=$scratch/files
mkdir -p "$files/live" "$files/EFI/BOOT" "$files/EFI/debian" "$files/boot/grub/fonts"
mksquashfs "$root" "$files/live/filesystem.squashfs" -comp zstd -Xcompression-level 6 -no-progress \
  -wildcards -e 'boot/*' 'proc/*' 'sys/*' 'dev/*' 'run/*' 'tmp/*' 'var/cache/apt/*' > /dev/null
cp -L "$root"/boot/vmlinuz-* "$files/live/vmlinuz"
cp -L "$root"/boot/initrd.img-* "$files/live/initrd"
cp /usr/lib/shim/shimx64.efi.signed "$files/EFI/BOOT/BOOTX64.EFI"
cp /usr/lib/shim/mmx64.efi.signed "$files/EFI/BOOT/mmx64.efi"
cp /usr/lib/grub/x86_64-efi-signed/grubx64.efi.signed "$files/EFI/BOOT/grubx64.efi"
cp "$here/grub.cfg" "$files/boot/grub/grub.cfg"
cp /usr/share/grub/unicode.pf2 "$files/boot/grub/fonts/"
grub-editenv "$files/boot/grub/grubenv" create
# shellcheck disable=SC2016  # GRUB's variables
printf 'set prefix=($root)/boot/grub\nsource $prefix/grub.cfg\n' > "$files/EFI/debian/grub.cfg"

# The image: GRUB for BIOS before the first partition, which is FAT, as UEFI wants it.
sector=512
system_sectors=$((($(du -s --apparent-size -B 1048576 "$files" | cut -f 1) + 32) * 2048))
projects_start=$((2048 + system_sectors))
projects_sectors=32768
rm -f "$image"
truncate -s $(((projects_start + projects_sectors) * sector)) "$image"
kind=83
[ $format != exfat ] || kind=7
sfdisk --quiet "$image" << END
label: dos
start=2048, size=$system_sectors, type=ef, bootable
start=$projects_start, size=$projects_sectors, type=$kind
END
mkfs.fat -F 32 -n OSTRAKA --offset 2048 "$image" $((system_sectors / 2)) > /dev/null 2>&1
mcopy -i "$image@@1048576" -s "$files"/* ::
grub-mkimage -O i386-pc -p '(,msdos1)/boot/grub' -o "$scratch/core.img" biosdisk part_msdos fat \
  normal linux loadenv echo test search configfile all_video gfxterm font reboot halt
# Its first sector finds the rest in the sectors that follow it.
put() { dd if="$1" of="$image" bs=1 seek="$2" count="$3" conv=notrunc status=none; }
put /usr/lib/grub/i386-pc/boot.img 0 440
[ "$(stat -c %s "$scratch/core.img")" -lt $((2047 * sector)) ]
dd if="$scratch/core.img" of="$image" bs=$sector seek=1 conv=notrunc status=none
# Some BIOSes name the wrong disk; GRUB takes the one it came from (as grub-bios-setup does).
printf '\220\220' | dd of="$image" bs=1 seek=$((0x66)) conv=notrunc status=none
printf 'ostraka: format as %s' $format |
  dd of="$image" bs=$sector seek=$projects_start conv=notrunc status=none
(cd "$(dirname "$image")" && sha256sum "$(basename "$image")" > "$(basename "$image").sha256")
ls -l "$image"
