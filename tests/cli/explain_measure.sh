#!/usr/bin/env bash
# needs: shapes/convex shapes/segment
# explain --measure draws, writes nothing, and counts what was left out; keep-all leaves nothing out.
source "$(dirname "$0")/lib.sh"
cat > hold.toml <<'TOML'
flatray = 1
frames  = 12
film    = { size = [256, 512], world = [[0, 0], [256, 512]] }

[[entity]]
name   = "hidden"
shape  = { box = { min = [10, 10], max = [20, 500] } }

[[entity]]
name   = "cover"
shape  = { box = { min = [0, 0], max = [256, 512] } }
fill   = "#336699"

[[entity]]
name   = "runner"
shape  = { box = { min = [0, 0], max = [4, 4] } }
at     = [100, 4]
markov = { chain = "steps" }
states = { GO = { velocity = [24, 0] }, STOP = { velocity = [0, 0] } }

[markov.steps]
hold = 6
GO   = { STOP = 1 }
STOP = { STOP = 1 }
TOML
run 0 explain hold.toml
# What the build was configured without, or that it lacks nothing.
grep -q '^build' out.txt || fail "nothing is said of the build"
run 0 explain --measure hold.toml
says out "12 frames"
# Frame 1 draws all 8 bands of 64 rows, the six moves after it one band each, and the five frames of STOP none.
says out "7 of 12"
says out "82 of 96 bands"
# What is saved has an interval that leaves out no change, or is not measurable.
grep '^saved by' out.txt | grep -vE ' not measurable |  (costs )?[0-9.e+]+ % \([0-9]' &&
  fail "a saving without its doubt"
(($(grep -c '^saved by' out.txt) >= 3)) || fail "savings are left out"
says out "confidence"
run 0 explain --measure -f 1..3 hold.toml
says out "3 frames"
run 0 explain --measure --keep-all hold.toml
says out "0 of 96 bands"
run 0 explain --measure --json -f 1..2 hold.toml
says out '"measured: bands carried"'
run 2 explain --measure -f 0 hold.toml
absent out
run 0 render hold.toml -o plain/f_####.png
run 0 render hold.toml --keep-all -o all/f_####.png
run 0 render hold.toml -j 3 -o threads/f_####.png
same plain all "--keep-all"
same plain threads "three threads"
# Of the four walls of a room the first flight looks at all, the second leaves out the one it comes from.
cat > room.toml <<'TOML'
flatray = 1
film    = { size = [64, 64], world = [[-1, -1], [1, 1]] }
[[chamber]]
shape = { box = { min = [-1, -1], max = [1, 1] } }
[[ray]]
name = "r"
at = [0.25, 0]
direction = [1, 0]
bounces = 1
TOML
run 0 explain --measure room.toml
says out "3.5 a flight"
says out "87.5 % of the walls, 4 in all, tested and 25 % hit; flights of rays: 2"
# A forced tracer draws the same bytes; hit counts primitives.
for tracer in brute grid exact; do run 0 render room.toml --tracer "$tracer" -o "$tracer.png"; done
cmp brute.png grid.png && cmp brute.png exact.png || fail "a tracer draws another picture"
run 2 render room.toml --tracer none
run 0 hit "$root/scenes/paper/case_one.toml" --ray 1,2,22,10 --json
says out '"primitives":[{"ray":"ray","tested":'
finish
