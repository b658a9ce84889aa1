#!/usr/bin/env bash
# Parts of a ray in any entity, in all, in one alone.
# needs: shapes/bezier shapes/capsule shapes/circle shapes/box shapes/ellipse
source "$(dirname "$0")/lib.sh"
cat > row.toml << 'SCENE'
flatray = 1
film = { size = [100, 40], world = [[0, 0], [10, 4]] }
[[entity]]
name = "left"
shape = { box = { min = [1, 0], max = [4, 2] } }
[[entity]]
name = "right"
shape = { box = { min = [3, 0], max = [6, 2] } }
[[entity]]
name = "disc"
shape = { circle = { centre = [3, 1], radius = 1 } }
SCENE
run 0 hit row.toml --ray 0,1,1,0 --op union
says out 'ray: 1 part, length 5'
says out '  t from 1 to 6'
run 0 hit row.toml --ray 0,1,4,0 --op union # a length is in world units, t in lengths of the direction
says out 'ray: 1 part, length 5'
says out '  t from 0.25 to 1.5'
run 0 hit row.toml --ray 0,1,1,0 --op intersection --json
says out '"parts":[[3,4]],"length":1'
run 0 hit row.toml --ray 0,1,1,0 --op difference --against left
says out 'ray: 1 part, length 1'
says out '  t from 1 to 2'
run 0 hit row.toml --ray 0,1,1,0 --op difference --against right --csv
says out 'ray,part,t_enter,t_exit'
says out 'ray,0,4,6'
run 0 hit row.toml --ray 0,1,1,0 --op difference --against disc
says out 'ray: no part'
run 0 hit row.toml --ray 2,1,0,0 --op union # a point test
says out 'ray: 1 part, length 0'
run 0 hit row.toml --ray 0,3,1,0 --op union
says out 'ray: no part'
run 0 hit row.toml --ray 6,1,1,0 --op union # touches
says out '  t from 0 to 0'
run 2 hit row.toml --ray 0,1,1,0 --op difference
says err 'add --against ENTITY'
# What is not there is empty; what arcs bound has an inside.
cat row.toml - > gone.toml << 'SCENE'
[[entity]]
name = "gone"
shape = { box = { min = [2, 0], max = [{ keys = [[0, 2], [1, 4]] }, 2] } }
SCENE
run 0 hit gone.toml --ray 0,1,1,0 --op intersection
says out 'ray: no part'
run 0 hit gone.toml --ray 0,1,1,0 --op difference --against left
says out '  t from 1 to 2'
cat row.toml - > pill.toml << 'SCENE'
[[entity]]
name = "pill"
shape = { capsule = { from = [1, 1], to = [3, 1], radius = 0.5 } }
SCENE
run 0 hit pill.toml --ray 0,1,1,0 --op difference --against pill
says out 'ray: 1 part, length 0.5'
run 0 hit pill.toml --ray 0,1,1,0 --against pill
says out 't from 0.5 to 3.5'
run 2 hit row.toml --ray 0,1,1,0 --op unoin
says err 'say union, intersection, difference'
run 2 hit row.toml --ray 0,1,1,0 --op union --svg
# The diagram has the outline of every kind of shape.
for shape in '{ circle = { radius = 1 } }' '{ ellipse = { radii = [1, 0.5] } }' '{ bezier = { points = [[-1, 0], [0, 2], [1, 2], [1, 0]] } }'; do
  run 0 hit row.toml --ray=-3,0.25,1,0 --against left -D "entity.left.shape=$shape" --svg
  grep -q nan "$work/out.txt" && fail "a place of $shape is no number"
  awk -F L '/class="s-axis"/ && NF > 30 { found = 1 } END { exit !found }' "$work/out.txt" || fail "no outline of $shape"
done
[[ $(grep -o 't = ' "$work/out.txt" | wc -l) == 2 ]] || fail "a point that is touched is named twice"

# What is only drawn, by even-odd, is told to be left out.
cat > bow.toml << 'SCENE'
flatray = 1
[[entity]]
name = "box"
shape = { box = { min = [-2, -2], max = [3, 2] } }
[[entity]]
name = "bow"
shape = { polygon = { points = [[-1, 0], [-1, 1], [-2, 0], [-2, 1]], fill_rule = "even-odd" } }
SCENE
for question in "--op difference --against box" "--op intersection" "--against box --op union"; do
  run 0 hit bow.toml --ray -5,0.25,1,0 $question
  case $question in
    *union) silent err ;;
    *) says err "is left out: its outline crosses itself" ;;
  esac
done
run 0 hit bow.toml --ray -5,0.25,1,0
says err "is left out: its outline crosses itself"
run 0 hit bow.toml --ray -5,0.25,1,0 -D 'entity.bow.repeat={ grid = { count = [5, 1], step = [1, 0] } }'
(($(grep -c 'is left out' err.txt) == 3)) || fail "names others than three"
says err "2 more left out for that"
run 2 hit bow.toml --ray -5,0.25,1,0 --against bow
says err "even-odd polygons have no inside"
grep -qF -e --from "$work/err.txt" && fail "speaks of --from, which was not said"

finish
