#!/bin/sh
# Simulated pairs through the whole chain, and how far each lies off beside what is stated of it.
# Goes on where it was stopped.
#   tests/bench/joining.sh OSTRAKA FOLDER FIRST_SEED LAST_SEED SHERDS OPTIONS_OF_SIMULATE...
# With --scans-only among the options `register`, else `process`.
set -eu
ostraka=$1 folder=$2 seed=$3 last=$4 sherds=$5
shift 5
mkdir -p "$folder"
while [ "$seed" -le "$last" ]; do
  set_=$folder/$seed
  if [ ! -f "$set_.evaluation.json" ]; then
    rm -rf "$set_" "$set_.out"
    "$ostraka" rig simulate --quiet --output "$set_" --seed "$seed" --sherds "$sherds" "$@"
    if [ -d "$set_/front" ] && ls "$set_"/front/*.jpg > /dev/null 2>&1; then
      "$ostraka" process --quiet "$set_" --output "$set_.out" > /dev/null || [ $? -ne 2 ]
      "$ostraka" evaluate --quiet --json "$set_.out" --truth "$set_/truth" > "$set_.new" || true
    else
      "$ostraka" register --quiet --front "$set_/front" --back "$set_/back" --output "$set_.out" \
        > /dev/null || [ $? -ne 2 ]
      "$ostraka" evaluate --quiet --json "$set_.out" --truth "$set_" > "$set_.new" || true
    fi
    cp "$set_.out/pairs.json" "$set_.pairs.json"
    rm -rf "$set_" "$set_.out"
    mv "$set_.new" "$set_.evaluation.json"
  fi
  seed=$((seed + 1))
done
