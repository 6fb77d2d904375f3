#!/bin/sh
# Writes the icons of this folder anew from the pinned release of Lucide (ISC licence, see
# packaging/copyright), all with one stroke. Not from there, drawn to match: compare, map, ostraka,
# review, section, sherd and turntable.
set -eu
version=1.62.0
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$work" && npm pack --silent "lucide-static@$version" > /dev/null && tar xzf lucide-static-*.tgz)
while read -r name lucide; do
  sed -e '/class="lucide/d' -e 's/currentColor/#000/' -e 's/stroke-width="2"/stroke-width="1.75"/' \
    "$work/package/icons/$lucide.svg" > "$name.svg"
done <<'TABLE'
again rotate-ccw
apart unfold-horizontal
aside archive
bag shopping-bag
camera camera
cancel x
capture aperture
catalogue library
check check
clock clock
distance spline
down chevron-down
drawing pen-tool
edit pencil
error octagon-x
export upload
filter funnel
folder folder
help circle-question-mark
import download
join combine
keys keyboard
label tag
log scroll-text
measure ruler
minus minus
mirror flip-horizontal-2
model box
more ellipsis
new folder-plus
next arrow-right
open folder-open
pause pause
picture image
play play
plus plus
previous arrow-left
print printer
question message-circle-question-mark
queue list-ordered
redo redo-2
report file-text
retry refresh-cw
search search
settings settings
settle magnet
split scissors
stop octagon
table table
theme sun-moon
undo undo-2
up chevron-up
virtual flask-conical
warning triangle-alert
TABLE
