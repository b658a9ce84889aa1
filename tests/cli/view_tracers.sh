#!/usr/bin/env bash
# Views of every shipped scene: the same picture by every exact tracer, and of the walls met in every tier.
# needs: shapes/circle shapes/polygon shapes/convex shapes/segment shapes/import formats/obj formats/list tracers/float
source "$(dirname "$0")/lib.sh"

# compare VIEW TIER...: the view of $scene by `exact`, then by `grid` in each tier and, of walls, by `brute` in the last.
compare() {
  local view=$1 size=32x18
  shift
  [[ $scene == */pile.toml ]] && size=17x1 # 40 000 walls by `exact`; a row is more than 16 rays
  run 0 render "$scene" --view "$view" --tracer exact --size $size --quiet -f 1 -o exact.png
  for tier; do
    for tracer in grid brute; do
      [[ $tracer == grid || $view/$tier == "hits/${tiers[-1]}" ]] || continue
      FLATRAY_ISA=$tier run 0 render "$scene" --view "$view" --tracer $tracer --size $size --quiet -f 1 -o other.png
      cmp exact.png other.png || fail "${scene#"$root/"}, $view, $tracer, $tier: not the picture of exact"
    done
  done
}

# What finds the first wall alone has no answer where all are asked for.
run 2 render "$root/scenes/tutorial/10_everything.toml" --view intervals --tracer float -f 1 -o no.png
says err "--tracer: error: 'float' finds the first wall of a ray alone, and the view intervals asks for all of them"
absent no.png
run 0 render "$root/scenes/tutorial/10_everything.toml" --view depth --tracer float -f 1 --quiet --size 32x18 -o float.png

export FLATRAY_ROOT=/  # scenes that refer to others
mapfile -t tiers < <("$flatray" list isas | awk '{ print $1 }')
[[ -z $sanitizers ]] || tiers=("${tiers[0]}" "${tiers[-1]}")
for scene in $(find "$root/scenes" -name '*.toml' -o -name '*.obj' -o -name '*.chamber' | sort); do
  [[ -n $sanitizers && $scene != */tutorial/* ]] && continue # ten times as slow
  grep -q "^field" "$scene" && continue  # its rays are bent, and no view is of such
  compare hits "${tiers[@]}"
  compare depth "${tiers[-1]}"
  [[ $scene == */pile.toml ]] || compare visibility:3,2 "${tiers[-1]}"
  compare intervals "${tiers[-1]}"
done
finish
