#!/usr/bin/env bash
# needs: shapes/polygon shapes/sector shapes/capsule lamps/cone lamps/point lamps/ray materials/diffuse materials/mirror formats/toml passes/light
# Light that is aimed at the corners of closed rooms: none escapes. RAYS in all, as RAYS=100000000.
source "$(dirname "$0")/lib.sh"
rays=${RAYS:-$([[ -z $sanitizers ]] && echo 1000000 || echo 60000)}

# lamps X Y, then the corners: rays, needles and fans from there to each, and a point.
lamps() {
  awk -v x="$1" -v y="$2" -v corners="${*:3}" 'BEGIN {
    printf "[[lamp]]\nsource = { point = {} }\nat = [%s, %s]\n", x, y
    count = split(corners, at, /[ ,]+/)
    for (i = 1; i < count; i += 2) {
      angle = atan2(at[i + 1] - y, at[i] - x) * 57.295779513082323
      split("ray={}|cone={spread=1e-13}|cone={spread=1e-10}|cone={spread=1e-6}|cone={spread=0.01}", sources, "|")
      for (k = 1; k <= 5; ++k)
        printf "[[lamp]]\nsource = { %s }\nat = [%s, %s]\nangle = %.17g\n", sources[k], x, y, angle
    }
  }'
}
# Slanted walls and a corner that juts in; an arc that meets straight walls at an angle; arcs that go on as straight walls.
rooms=('polygon = { points = [[0, 0], [7, 0.5], [9, 4], [5.25, 3.5], [6, 7], [1, 6]] }'
  'sector = { radius = 6, from = 10, to = 130 }'
  'capsule = { from = [1, 1], to = [6, 2.5], radius = 2 }')
places=('3 3.5  0,0 7,0.5 9,4 5.25,3.5 6,7 1,6'
  '0 3  0,0 5.908846518073248,1.0418890660015825 -3.8567256581192355,4.596266658713868'
  '3.4 1.7  0.42529241,2.91563947 1.57470759,-0.91563947 5.42529241,4.41563947 6.57470759,0.58436053')
materials=('"mirror"' '{ diffuse = { reflectance = 0.9 } }')
each=$((rays / 6))
for i in 0 1 2; do
  for material in "${materials[@]}"; do
    {
      printf 'flatray = 1\nfilm = { size = [32, 32], world = [[-7, -7], [11, 11]] }\n'
      printf 'light = { bounces = 3, estimator = "forward" }\n[[chamber]]\nshape = { %s }\nmaterial = %s\n' "${rooms[i]}" "$material"
      lamps ${places[i]}
    } > room.toml
    run 0 render room.toml --rays "$each" -o room.png --json --quiet --force
    says out '"escaped":0,'
    echo "${rooms[i]}, $material: $(grep -o '"light":{[^}]*}' out.txt)"
  done
done
finish
