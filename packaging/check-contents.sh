#!/bin/sh
# Looks through an installed tree, or a Debian package: is all of contents.txt there, nothing else,
# and is each file fit for its use? Says what is wrong, one line each.
#   packaging/check-contents.sh FOLDER|PACKAGE.deb
set -eu
here=$(cd "$(dirname "$0")" && pwd)
what=${1:?"name a folder or a package"}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trouble=0
wrong() {
  echo "check-contents: $*" >&2
  trouble=1
}

if [ -f "$what" ]; then
  dpkg-deb -x "$what" "$scratch/tree"
  depends=$(dpkg-deb -f "$what" Depends)
  # Found by the linker's needs; Qt's plugins and the camera drivers come with these.
  for library in libc6 libstdc++6 libqt6widgets6 libqt6svg6 libopencv-core libembree3 libgphoto2-6 \
    libusb-1.0-0 libopencv-videoio libsqlite3-0 libheif1 libraw20 libvtk9 libpcl-features; do
    case "$depends" in
      *"$library"*) ;;
      *) wrong "the package does not depend on $library" ;;
    esac
  done
  for development in -dev googletest libgtest cli11 nlohmann; do
    case "$depends" in
      *"$development"*) wrong "the package depends on $development, which only a build needs" ;;
    esac
  done
  [ -n "$(dpkg-deb -f "$what" Description)" ] || wrong "the package has no description"
  tree=$scratch/tree
else
  tree=$(cd "$what" && pwd)
fi

(cd "$tree" && find . ! -type d | sed 's|^\./||' | sort) > "$scratch/files"
: > "$scratch/known"
grep -v -e '^#' -e '^$' "$here/contents.txt" > "$scratch/patterns"
while read -r pattern; do
  any=no
  while read -r file; do
    # shellcheck disable=SC2254  # a pattern is meant
    case "$file" in
      $pattern)
        any=yes
        echo "$file" >> "$scratch/known"
        ;;
    esac
  done < "$scratch/files"
  [ $any = yes ] || wrong "there is no $pattern"
done < "$scratch/patterns"
sort -u "$scratch/known" | comm -13 - "$scratch/files" > "$scratch/strange"
while read -r file; do wrong "$file is not in contents.txt"; done < "$scratch/strange"

# The program and what it says of itself.
program=$tree/usr/bin/ostraka
if [ -x "$program" ] && "$program" --version > "$scratch/version" 2>&1; then
  "$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p' > "$scratch/commands"
  [ -s "$scratch/commands" ] || wrong "ostraka --help names no command"
  while read -r command; do
    [ -f "$tree/usr/share/man/man1/ostraka-$command.1.gz" ] || wrong "no manual page of $command"
    for shell in bash-completion/completions/ostraka zsh/vendor-completions/_ostraka \
      fish/vendor_completions.d/ostraka.fish; do
      grep -q -- "$command" "$tree/usr/share/$shell" || wrong "$shell does not know $command"
    done
  done < "$scratch/commands"
else
  wrong "the program does not start: $(cat "$scratch/version" 2>/dev/null)"
fi
find "$tree" -type d -name man1 -exec find {} -name '*.gz' \; | while read -r page; do
  gzip -dc "$page" | head -n 1 | grep -q '^\.TH OSTRAKA' || echo "$page"
done > "$scratch/pages"
while read -r page; do wrong "$page is no manual page"; done < "$scratch/pages"

# Texts of other programs are checked by their own tools where those are installed.
desktop=$tree/usr/share/applications/ostraka.desktop
grep -q '^Exec=ostraka %f$' "$desktop" || wrong "the desktop entry does not start ostraka"
if command -v desktop-file-validate > /dev/null; then
  desktop-file-validate "$desktop" || wrong "the desktop entry is not valid"
fi
kind=$(sed -n 's/.*<mime-type type="\(.*\)">.*/\1/p' "$tree/usr/share/mime/packages/ostraka.xml" 2>/dev/null || true)
grep -q "^MimeType=.*$kind;" "$desktop" || wrong "the desktop entry does not open $kind"
if command -v udevadm > /dev/null && udevadm verify --help > /dev/null 2>&1; then
  udevadm verify "$tree/usr/lib/udev/rules.d/70-ostraka.rules" > /dev/null ||
    wrong "the udev rules are not valid"
fi
for language in de fr es el tr hy; do
  grep -q "^GenericName\[$language\]=" "$desktop" ||
    wrong "the desktop entry has no words for $language"
done
exit $trouble
