#!/bin/sh
# Pictures of every screen, for a person to look at: three themes, English and German, from a laptop
# of 1280 x 720 at 150 % to a 4K screen at 200 %.
# Usage: screens.sh BUILD PROJECT OUT   (PROJECT: with processed batches; it is copied for each run)
set -eu
test=$(realpath "$1")/tests/ui/main/ui_main_test
project=$(realpath "$2")
mkdir -p "$3"
out=$(realpath "$3")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for language in ${LANGUAGES:-en de}; do
  # Name, logical size, scale: 1280x720 at 150 % are 853 x 480 logical pixels.
  while read -r name size scale; do
    folder=$out/$name-$language
    mkdir -p "$folder" "$work/Ostraka"
    rm -rf "$work/Ostraka/Hill"
    cp -r "$project" "$work/Ostraka/Hill"
    OSTRAKA_SCREENSHOTS=$folder OSTRAKA_PROJECT=$work/Ostraka/Hill OSTRAKA_SCREENSHOTS_TEXT=100 \
      OSTRAKA_SCREENSHOTS_WAIT=${WAIT:-1500} OSTRAKA_SCREENSHOTS_LANGUAGE=$language \
      OSTRAKA_SCREENSHOTS_SIZE=$size QT_SCALE_FACTOR=$scale \
      xvfb-run -a -s '-screen 0 3840x2160x24' "$test" screens_test picturesOfAllScreens \
      > "$folder/log.txt" 2>&1 ||
      echo "$folder: see its log.txt" >&2
  done <<SIZES
1280x720 1280x720 1
1280x720at150 853x480 1.5
1366x768 1366x768 1
1920x1080 1920x1080 1
3840x2160at200 1920x1080 2
SIZES
done
