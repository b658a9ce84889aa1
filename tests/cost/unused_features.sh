#!/usr/bin/env bash
# unused_features.sh [--must] BUILDS ROOT [FEW]: no scene pays for what it does not use. A scene takes at most 1 % more
# instructions in the release build, with all its parts, than in the build in the folder FEW (minimal, where the preset few
# puts what draws boxes, and our PNG encoder), and gives the same bytes. Scenes: those written here, and the first frame of all shipped ones that FEW can draw.
# Where there is no valgrind, or a build is missing, the check is skipped (exit 77); with --must, or where CI is set, it fails
# then. A build that is older than its sources is brought up to date.
set -euo pipefail
must=${CI:-}
[[ $1 != --must ]] || { must=1 && shift; }
builds=$(cd "$1" && pwd)
root=$(cd "$2" && pwd)
few=${3:-minimal}
skip() {
  [[ -z $must ]] || { echo "FAIL: $1" && exit 1; }
  echo "skipped: $1"
  exit 77
}
command -v valgrind >/dev/null || skip "there is no valgrind"
unset "${!FLATRAY_@}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for folder in release "$few"; do
  [[ -x $builds/$folder/flatray ]] || skip "there is no program in $builds/$folder"
  cmake --build "$builds/$folder" --target flatray >"$work/build.log" || { cat "$work/build.log" && exit 1; }
done
# Paths of one length, and no modules beside either.
mkdir "$work/all" "$work/few" "$work/own"
cp "$builds/release/flatray" "$work/all"
cp "$builds/$few/flatray" "$work/few"
cd "$work"

film='flatray = 1
film = { size = [160, 120], world = [[0, 0], [16, 12]] }'
boxes() {
  local i
  for ((i = 0; i < $1; i++)); do
    printf '[[entity]]\nshape = { box = { min = [%d.3, %d.2], max = [%d.1, %d.7] } }\nfill = "#%02x6090"\n' \
      $((i % 13)) $((i % 9)) $((i % 13 + 2)) $((i % 9 + 1)) $((20 * (i % 9) + 40))
  done
}
moving='[[entity]]
shape = { box = { min = [0, 0], max = [2, 1] } }
fill = "#c0392b80"
at = [1, 5]
velocity = [24, 3]
angular_velocity = 40'
echo "$film" >own/empty.toml
{ echo "$film" && boxes 1; } >own/one.toml
{ echo "$film" && boxes 10; } >own/ten.toml
{ echo "$film" && boxes 200; } >own/many.toml
{ echo "frames = 4" && echo "$film" && boxes 40 && echo "$moving"; } >own/moving.toml
{ echo "$film" | sed 's/ }$/, coverage = "centre" }/' && boxes 10; } >own/centre.toml
{ echo "$film" && boxes 3 && echo 'opacity = 0.5
stroke = { colour = "#1f3a93", width = 0.2, dashes = [0.4, 0.2] }'; } >own/strokes.toml

scenes=(own/*.toml)
for scene in "$root"/scenes/*.toml "$root"/scenes/*/*.toml; do
  few/flatray render "$scene" --dry-run -o x.png -f 1 >/dev/null 2>&1 && scenes+=("$scene")
done

# instructions PROGRAM SCENE: of its first frames, of a small picture.
instructions() {
  local frames=1 size=()
  [[ $2 != own/moving.toml ]] || frames=1..4
  [[ $2 != /* ]] || size=(--size 160x120)
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1/flatray" render "$2" -j 1 --quiet -f "$frames" \
    "${size[@]}" -o "$1/####.png" 2>&1 | sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
failed=0
for scene in "${scenes[@]}"; do
  rm -f {all,few}/*.png
  instructions all "$scene" >all.count &
  instructions few "$scene" >few.count
  wait
  with=$(cat all.count) without=$(cat few.count)
  [[ -n $with && -n $without ]] || { echo "FAIL: $scene is not drawn" && failed=1 && continue; }
  printf '%-32s %11d instructions, %11d with few parts: %+.2f %%\n' "${scene#"$root"/}" "$with" "$without" \
    "$(awk "BEGIN { print 100 * ($with / $without - 1) }")"
  for picture in few/*.png; do cmp "$picture" "all/${picture#*/}" || failed=1; done
  ((100 * with <= 101 * without)) || { echo "FAIL: ${scene#"$root"/} pays more than 1 %" && failed=1; }
done
echo "cost: ${#scenes[@]} scenes compared"
exit $failed
