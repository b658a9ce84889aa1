#!/usr/bin/env bash
# What follows from meetings, other methods, the paper's tables, and the map of velocities, as their users run them.
# needs: shapes/box shapes/circle shapes/polygon shapes/segment shapes/import formats/obj formats/list
source "$(dirname "$0")/lib.sh"
scenes=$root/scenes/collision
run 0 collide "$scenes/cradle.toml" --response bounce --fixed wall --csv
says out "first,second,1,11,"
says out "second,third,1,11,"
says out "third,wall,"
run 2 collide "$scenes/cradle.toml" --response bounce --fixed wal
says err "did you mean 'wall'?"
run 2 collide "$scenes/cradle.toml" --response bouncy
run 4 collide "$root/scenes/markov/runner.toml" --response stop
says err "keep one velocity"
run 0 collide "$scenes/bullet.toml" --csv
says out "bullet,wall,through,3.330078125e-09,"
run 0 collide "$scenes/bullet.toml" --method edge-rays --csv
(($(wc -l < out.txt) == 1)) || fail "rays in each frame see the bullet"
run 2 collide "$scenes/bullet.toml" --method boxes --response stop
says err "does not go with --response"
run 2 collide "$scenes/bullet.toml" --fixed wall
says err "needs --response"
run 0 collide "$root/scenes/paper/case_two.toml" --table
says out "-49530 | -47580"
run 2 collide "$scenes/bullet.toml" --table
says err "case_two.toml --table"
cat >growing.toml <<'EOF'
flatray = 1
frames = 3
fps = 1
[[entity]]
name = "grows"
shape = { box = { min = [0, 0], max = [{ keys = [[0, 1], [2, 5]] }, 1] } }
[[entity]]
name = "waits"
shape = { box = { min = [4, 0], max = [6, 1] } }
EOF
run 4 collide growing.toml
says err "growing.toml:4:1: error: entity 'grows' changes its size"
says err "--method edge-rays"
run 4 collide growing.toml --response stop
run 0 collide growing.toml --method edge-rays --csv
says out "grows,waits,"
run 0 hit growing.toml --ray 2.5,0.5,1,0 --against grows -f 2
says out "inside"
run 0 experiment avoidance "$scenes/methods.toml" -o map
exists map/avoidance.png map/avoidance.csv map/avoidance_times.csv
run 0 experiment avoidance "$scenes/methods.toml" -o one -j 1
cmp map/avoidance.png one/avoidance.png || fail "threads change the map"
finish
