#!/usr/bin/env bash
# needs: shapes/arc shapes/bezier shapes/capsule shapes/cell shapes/circle shapes/conic shapes/convex shapes/ellipse shapes/import shapes/lens shapes/mushroom shapes/ngon shapes/parabola shapes/penrose formats/obj
# README's limits: `hit`, `edge_rays` and the view `intervals` clip rays to every shape that there is.
source "$(dirname "$0")/lib.sh"

printf 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n' > outline.obj
# Each shape so that the ray from (-50, 0.3) along x meets it.
declare -A shapes=(
  [arc]='radius = 2, from = 0, to = 90'
  [bezier]='points = [[-2, 1], [-1, -2], [1, 2], [2, -1]]'
  [box]='min = [-1, -1], max = [1, 1]'
  [capsule]='from = [-1, 0], to = [1, 0], radius = 1'
  [cell]='a = [2, 0], b = [1, 2]'
  [circle]='radius = 2'
  [conic]='vertex = [0, 0], focus = [1, 0], width = 4, eccentricity = 2'
  [convex]='points = [[-1, -1], [1, -1], [0, 1]]'
  [ellipse]='radii = [2, 1]'
  [import]='file = "outline.obj"'
  [lens]='height = 2, thickness = 1, radii = [2, 3]'
  [mushroom]='radius = 2, width = 1, height = 2'
  [ngon]='sides = 5, radius = 2'
  [parabola]='vertex = [0, 0], focus = [1, 0], width = 4'
  [penrose]='size = 5'
  [polygon]='points = [[-1, -1], [1, -1], [0, 1], [0, 0]]'
  [polyline]='points = [[-1, -1], [1, 1]]'
  [sector]='radius = 2, from = 0, to = 90'
  [segment]='from = [-1, -1], to = [1, 1]'
  [star]='points = 5, outer = 2, inner = 1'
  [text]='string = "H", size = 3'
  [tokarsky]='size = 1'
)
run 0 list shapes
for name in $(awk '{ print $1 }' out.txt); do
  [[ -n ${shapes[$name]:-} ]] || { fail "no shape $name here"; continue; }
  cat > "$name.toml" <<TOML
flatray = 1
film    = { size = [32, 32], world = [[-8, -8], [8, 8]] }

[[entity]]
name  = "probe"
shape = { segment = { from = [-50, 0.3], to = [50, 0.3] } }

[[entity]]
name  = "shape"
shape = { $name = { ${shapes[$name]} } }

[[edge_rays]]
from    = "probe"
against = "shape"
TOML
  run 0 hit "$name.toml" --ray -50,0.3,1,0 --against shape
  grep -qE '^  (through|touch|along): ' out.txt || fail "no ray meets $name"
  run 0 render "$name.toml" -o "$name.png" --quiet
  run 0 render "$name.toml" --view intervals -o "$name.png" --quiet
done
finish
