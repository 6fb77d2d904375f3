#!/bin/sh
# Installs the program into an empty folder and looks through it as through a package; then
# spoils it, to know that the looking finds what is wrong.
#   package_contents.sh BUILD_FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
check=$here/../../packaging/check-contents.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
DESTDIR=$tree cmake --install "$1" --prefix /usr --component program > "$tree.log" || { cat "$tree.log"; exit 1; }
rm -f "$tree.log"
"$check" "$tree"

rm "$tree/usr/share/applications/ostraka.desktop" "$tree/usr/share/man/man1/ostraka-dense.1.gz"
touch "$tree/usr/bin/stray"
if said=$("$check" "$tree" 2>&1); then
  echo "package_contents: a spoilt tree passed as whole" >&2
  exit 1
fi
for word in ostraka.desktop 'manual page of dense' usr/bin/stray; do
  case "$said" in
    *"$word"*) ;;
    *)
      echo "package_contents: $word was not named in: $said" >&2
      exit 1
      ;;
  esac
done
