#!/usr/bin/env bash
# unused_features.sh BUILDS ROOT: no scene pays for what it does not use. The same scene takes at most 1 % more
# instructions in the release build, with all its parts, than in the minimal one, and gives the same bytes.
set -euo pipefail
builds=$1
root=$2
full=$builds/release/flatray
minimal=$builds/minimal/flatray
skip() {
  echo "skipped: $1"
  exit 77
}
command -v valgrind >/dev/null || skip "there is no valgrind"
[[ -x $full && -x $minimal ]] || skip "both the release and the minimal preset must be built"
for program in "$full" "$minimal"; do
  [[ -z $(find "$root/src" -name '*.cpp' -newer "$program" -print -quit) ]] || skip "$program is older than its sources"
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
printf 'flatray = 1\nfilm = { size = [160, 120], world = [[0, 0], [16, 12]] }\n' >empty.toml
cp empty.toml ten.toml
for i in {0..9}; do
  printf '[[entity]]\nshape = { box = { min = [%d.3, %d.2], max = [%d.1, %d.7] } }\nfill = "#%02x6090"\n' \
    "$i" "$i" $((i + 2)) $((i + 1)) $((20 * i + 40)) >>ten.toml
done

# instructions PROGRAM SCENE PICTURE
instructions() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" render "$2" -j 1 --quiet -o "$3" 2>&1 |
    sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
failed=0
for scene in empty ten; do
  with=$(instructions "$full" $scene.toml full.png)
  without=$(instructions "$minimal" $scene.toml minimal.png)
  echo "$scene scene: $with instructions, $without in the minimal build: $(awk "BEGIN { printf \"%+.2f\", 100 * ($with / $without - 1) }") %"
  cmp full.png minimal.png || failed=1
  ((100 * with <= 101 * without)) || failed=1
done
exit $failed
