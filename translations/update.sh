#!/bin/sh
# Takes the texts of the window, and of core that the window shows, over into the .ts files; run it
# in the root of the tree after texts changed. New ones arrive as unfinished; translate them with Qt
# Linguist. A text that no speaker of the language has looked at yet carries the comment 'not
# reviewed by a speaker'.
set -eu
lupdate=$(command -v lupdate || echo /usr/lib/qt6/bin/lupdate)
messages=$(mktemp -d)
trap 'rm -rf "$messages"' EXIT
python3 translations/messages.py core > "$messages/core_messages.cpp"
for language in en de fr es el tr hy; do
  plural=""
  [ "$language" = en ] && plural=-pluralonly
  "$lupdate" -silent -no-obsolete -locations none $plural -I . ui "$messages" -source-language en \
    -target-language "$language" -ts "translations/ostraka_$language.ts"
done
