#!/bin/sh
# Worlds of photographs by hand that nobody has chosen: sheet, table, light, camera, clutter, bend and
# clay are drawn from the seed. A row of figures each; worlds that have one already are passed over.
#   tests/bench/worlds.sh OSTRAKA FOLDER FIRST_SEED LAST_SEED [OPTIONS_OF_SIMULATE...]
set -eu
ostraka=$1 folder=$2 seed=$3 last=$4
shift 4
[ $# -gt 0 ] || set -- --hand-held 20 --sherds 5
mkdir -p "$folder"

# drawn SEED: the options of that world. Lehmer's generator; the first numbers still show the seed.
drawn() {
  awk -v state="$1" 'function one_of(words,   n, word) {
      state = (state * 48271) % 2147483647
      n = split(words, word, " ")
      return word[1 + state % n]
    }
    BEGIN {
      for (i = 0; i < 8; ++i) one_of("x")
      printf "--sheet %s --table %s", one_of("a4 a4 a4 a3 letter"), one_of("wood cloth granite cutting-mat")
      printf " --light %s", one_of("window lamp flash overcast sun")
      printf " --camera %s --clutter %s", one_of("phone dslr compact"), one_of("0 2 4")
      printf " --bend %s --gloss %s%s\n", one_of("0 0 2"), one_of("0 0 0.4"), one_of("no no plain") == "no" ? "" : " --plain"
    }'
}

while [ "$seed" -le "$last" ]; do
  world=$folder/$seed
  if [ ! -f "$world.txt" ]; then
    rm -rf "$world" "$world.out"
    options=$(drawn "$seed")
    # shellcheck disable=SC2086  # the options are words
    "$ostraka" rig simulate --quiet --output "$world" --seed "$seed" "$@" $options
    status=0
    "$ostraka" process --quiet "$world" --output "$world.out" > /dev/null || status=$?
    "$ostraka" evaluate --quiet "$world.out" --truth "$world/truth" > "$world.evaluation" || true
    printf '%s | %s | %s | %s\n' "$seed" "$options" "$status" \
      "$(sed -n 's/^models: //p; s/^pairs: /; pairs: /p; s/^masks: /; masks: /p' "$world.evaluation" \
        | tr '\n' ' ')" > "$world.new"
    mv "$world.new" "$world.txt"
  fi
  cat "$world.txt"
  seed=$((seed + 1))
done
