#!/usr/bin/env bash
# Views of every shipped scene: the same picture by every exact tracer, and of the walls met in every tier.
# needs: shapes/circle shapes/polygon shapes/convex shapes/segment shapes/import formats/obj formats/list tracers/float
source "$(dirname "$0")/lib.sh"

# compare VIEW TIER...: the view of all $scenes by `exact`, then by `grid` in each tier and, of walls, by `brute` in the last.
compare() {
  local view=$1 tier tracer
  shift
  draw "$view" exact exact
  for tier; do
    for tracer in grid brute; do
      [[ $tracer == grid || $view/$tier == "hits/${tiers[-1]}" ]] || continue
      FLATRAY_ISA=$tier draw "$view" $tracer other
      diff -rqx manifest.jsonl exact other || fail "$view, $tracer, $tier: not the pictures of exact"
    done
  done
}
draw() {  # VIEW TRACER FOLDER: one process for all scenes, most of which take less than to start it
  rm -rf "$3"
  run 0 render "${scenes[@]}" --view "$1" --tracer "$2" --size $size --quiet -f 1 -o "$3/{scene}.png"
  drawn=("$3"/*.png)
  ((${#drawn[@]} == ${#scenes[@]})) || fail "$folder, $1, $2: ${#drawn[@]} pictures of ${#scenes[@]} scenes"
}

# What finds the first wall alone has no answer where all are asked for.
run 2 render "$root/scenes/tutorial/10_everything.toml" --view intervals --tracer float -f 1 -o no.png
says err "--tracer: error: 'float' finds the first wall of a ray alone, and the view intervals asks for all of them"
absent no.png
run 0 render "$root/scenes/tutorial/10_everything.toml" --view depth --tracer float -f 1 --quiet --size 32x18 -o float.png

export FLATRAY_ROOT=/  # scenes that refer to others
mapfile -t tiers < <("$flatray" list isas | awk '{ print $1 }')
[[ -z $sanitizers ]] || tiers=("${tiers[0]}" "${tiers[-1]}")
shipped=0
for folder in $(find "$root/scenes" -type d); do
  [[ -n $sanitizers && $folder != */tutorial ]] && continue # ten times as slow
  scenes=() size=32x18
  for scene in "$folder"/*.{toml,obj,chamber}; do
    [[ -e $scene && $scene != */pile.toml ]] && ! grep -q "^field" "$scene" && scenes+=("$scene")  # no view is of bent rays
  done
  ((${#scenes[@]} > 0)) || continue
  shipped=$((shipped + ${#scenes[@]}))
  compare hits "${tiers[@]}"
  for view in depth visibility:3,2 intervals; do compare $view "${tiers[-1]}"; done
done
((shipped > 80 || ${#sanitizers})) || fail "only $shipped scenes"
if [[ -z $sanitizers ]]; then
  scenes=("$root/scenes/extreme/pile.toml") folder=pile size=17x1 # 40 000 walls by `exact`; a row is more than 16 rays
  compare hits "${tiers[@]}"
  for view in depth intervals; do compare $view "${tiers[-1]}"; done
fi
finish
