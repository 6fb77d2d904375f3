#!/bin/sh
# The pictures of the manual and of the README (resources/docs), of the window as it is now.
# Usage: manual_pictures.sh BUILD PROJECT
# PROJECT: with processed batches and the virtual rig; it is copied. It takes some minutes, since a
# batch is photographed for the picture of the flip.
set -eu
test=$(realpath "$1")/tests/ui/main/ui_main_test
project=$(realpath "$2")
docs=$(realpath "$(dirname "$0")/../../resources/docs")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/Ostraka" "$work/pictures"
cp -r "$project" "$work/Ostraka/"
OSTRAKA_SCREENSHOTS=$work/pictures OSTRAKA_PROJECT=$work/Ostraka/$(basename "$project") \
  OSTRAKA_SCREENSHOTS_THEME=light OSTRAKA_SCREENSHOTS_WAIT=${WAIT:-10000} \
  QTEST_FUNCTION_TIMEOUT=3600000 OSTRAKA_SCREENSHOTS_CAPTURE=1 OSTRAKA_SCREENSHOTS_SIZE=1280x720 \
  xvfb-run -a -s '-screen 0 1920x1080x24' "$test" screens_test picturesOfAllScreens
for picture in "$docs"/*-light.png; do
  cp "$work/pictures/$(basename "$picture")" "$picture"
done
