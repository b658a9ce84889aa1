#!/usr/bin/env bash
# sizes.sh ROOT: no source is longer than 400 lines. Prints the ones that are.
set -euo pipefail
cd "$1"

limit=400
mapfile -t files < <(find src tests benchmarks tools -name '*.h' -o -name '*.cpp' -o -name '*.cmake' -o -name '*.sh')
long=$(awk -v limit=$limit 'FNR == limit + 1 { print FILENAME ": longer than " limit " lines, split it" }' "${files[@]}")
echo "sizes: ${#files[@]} files${long:+
$long}"
[[ -z $long ]]
