#!/bin/sh
# Takes the texts of the window over into the .ts files; run it in the root of the tree after texts
# changed. New ones arrive as unfinished; translate them with Qt Linguist. A text that no speaker of
# the language has looked at yet carries the comment 'not reviewed by a speaker'.
set -eu
lupdate=$(command -v lupdate || echo /usr/lib/qt6/bin/lupdate)
for language in en de fr es el tr hy; do
  plural=""
  [ "$language" = en ] && plural=-pluralonly
  "$lupdate" -silent -no-obsolete -locations none $plural -I . ui -source-language en \
    -target-language "$language" -ts "translations/ostraka_$language.ts"
done
