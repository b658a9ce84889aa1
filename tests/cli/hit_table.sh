#!/usr/bin/env bash
# The paper's tables 2 and 3, corrected, from its own scene.
# needs: shapes/convex shapes/segment
source "$(dirname "$0")/lib.sh"
case_one=$root/scenes/paper/case_one.toml
run 0 hit "$case_one" --from ray --against polygon
while IFS= read -r line; do says out "$line"; done << 'TABLE'
     0        152          216  19/27 = 0.7037037037037037  exiting   [0, 0.7037037037037037]
     1         48           60  4/5 = 0.8                   exiting   [0, 0.7037037037037037]
     2         -5          -60  1/12 = 0.08333333333333333  entering  [0.08333333333333333, 0.7037037037037037]
     3        -57         -216  19/72 = 0.2638888888888889  entering  [0.2638888888888889, 0.7037037037037037]
  through: t from 19/72 = 0.2638888888888889 to 19/27 = 0.7037037037037037
enters by edge 3 at (6.805555555555555,
leaves by edge 0 at (16.48148148148148,
TABLE
cp out.txt first.txt
run 0 hit "$case_one"  # the scene asks the same of itself
cmp -s out.txt first.txt || fail "the scene's own question differs"
run 0 hit "$case_one" --ray 1,2,22,10 --against polygon
says out "t in [0, inf]"
says out "through: t from 19/72"
run 0 hit "$case_one" --ray 23,12,-22,-10 --against polygon --domain segment
says out "through: t from 8/27"
run 0 hit "$case_one" --ray 0,0,0,1 --against polygon
says out "miss, starts outside"
run 0 hit "$case_one" --from ray --against polygon --json
says out '"t_exact":"19/72"'
says out '"class":"through","t_enter":0.2638888888888889,"t_exit":0.7037037037037037'
run 0 hit "$case_one" --from ray --against polygon --csv
(($(wc -l < out.txt) == 5)) || fail "CSV has $(wc -l < out.txt) lines"
says out "ray segment 0,polygon,3,-57,-216,0.2638888888888889,entering,0.2638888888888889,0.7037037037037037,through"

# Case II at rest: sixteen pairs, no hit.
run 0 hit "$root/scenes/paper/case_two.toml" --from box_1 --against box_2
(($(grep -c 'miss, starts' out.txt) == 4)) || fail "case II is not four misses"
run 2 hit "$case_one" --ray 1,2,3
says err "is not four numbers"

# An arc whose ends lie in one direction as doubles see them, so small or so nearly whole is it.
cat > far_arcs.toml << 'TOML'
flatray = 1
[[entity]]
name = "small"
shape = { arc = { centre = [1e9, 0], radius = 1, from = 89.999999, to = 90 } }
stroke = { width = 0.1 }
[[entity]]
name = "large"
shape = { arc = { centre = [1e9, 0], radius = 1, from = 90, to = 449.999999 } }
stroke = { width = 0.1 }
TOML
run 0 hit far_arcs.toml --ray 999999990,0.25,1,0 --against small
says out 'miss, starts outside'
run 0 hit far_arcs.toml --ray 999999990,0.25,1,0 --against large
says out 'touch: t from 9.031754163448145 to 9.031754163448145'

finish
