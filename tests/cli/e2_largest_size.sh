#!/usr/bin/env bash
# 2^28 pixels within the memory --dry-run announces.
source "$(dirname "$0")/lib.sh"
scene box.toml 1
announced=$("$flatray" render box.toml --size 16384x16384 --dry-run --json | sed 's/.*"peak_bytes":\([0-9]*\).*/\1/')
[[ $(free -b | awk '/Mem:/ { print $7 }') -gt $((announced * 5 / 4)) ]] || { echo "too little memory here"; exit 77; }
run 0 render box.toml --size 16384x16384 -o big.png --quiet -j 2
[[ $(size_of big.png) == 16384x16384 ]] || fail "size $(size_of big.png)"
finish
