#!/usr/bin/env bash
# needs: tracers/grid
# Blocks of `flatray stability --leaks` that are in the folder are not followed again, the others are.
source "$(dirname "$0")/lib.sh"
leaks() { run 0 stability --leaks "$1" --tracer grid --places origin -o rooms; }
rows() { (($(wc -l < rooms/leaks.csv) == 1 + $1)) || fail "$(wc -l < rooms/leaks.csv) lines of leaks.csv, not $1 rows"; }
leaks 1024
rows 1
cp rooms/leaks.csv once.csv
leaks 1000
cmp -s once.csv rooms/leaks.csv || fail 'a block was followed again'
leaks 1025
rows 2
[[ $(cut -d, -f5 rooms/leaks.csv | sed 1d | sort -n | tr '\n' ' ') == '0 1 ' ]] || fail "blocks: $(cut -d, -f5 rooms/leaks.csv)"
awk -F, 'NR > 1 && ($6 != ($5 == 0 ? 1024 : 1) || $8 != 0) { exit 1 }' rooms/leaks.csv || fail 'rays are 1024 and 1, and none leaks'
finish
