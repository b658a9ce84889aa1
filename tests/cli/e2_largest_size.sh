#!/usr/bin/env bash
# 2^28 pixels within the memory --dry-run announces.
source "$(dirname "$0")/lib.sh"
scene box.toml 1
announced=$("$flatray" render box.toml --size 16384x16384 --dry-run --json | sed 's/.*"picture_bytes":\([0-9]*\).*/\1/')
program=64000000  # the rest of the program: code, libraries, stacks
if (($(awk '/MemAvailable/ { print $2 }' /proc/meminfo) * 1024 < announced + program)); then
  echo "skipped: less than $announced bytes of memory are free here"
  exit 77
fi
(
  limit_memory $(((announced + program) / 1024))
  "$flatray" render box.toml --size 16384x16384 -o big.png --quiet -j 1
) || fail "not within the announced $announced bytes"
[[ $(size_of big.png) == 16384x16384 ]] || fail "size $(size_of big.png)"
finish
