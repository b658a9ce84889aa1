#!/usr/bin/env bash
# What follows from meetings, other methods, the paper's tables, and the map of velocities, as their users run them.
# needs: shapes/box shapes/capsule shapes/circle shapes/ellipse shapes/polygon shapes/segment shapes/import formats/obj formats/list
source "$(dirname "$0")/lib.sh"
scenes=$root/scenes/collision
for how in '' '--response bounce --fixed wall'; do
  # shellcheck disable=SC2086
  run 0 collide "$scenes/cradle.toml" $how --csv
  (($(wc -l < out.txt) == 4)) || fail "three events of the cradle $how"
done
says out "first,second,1,11,"
says out "second,third,1,11,"
says out "third,wall,"
run 2 collide "$scenes/cradle.toml" --response bounce --fixed wal
says err "did you mean 'wall'?"
run 2 collide "$scenes/cradle.toml" --response bouncy
run 0 collide "$scenes/cradle.toml" --csv -D collisions.response='"stop"'
(($(wc -l < out.txt) == 2)) || fail "what stops meets no other"
run 0 collide "$scenes/cradle.toml" --csv --response none
says out "first,third,through,"
run 0 collide "$scenes/cradle.toml" --csv --method minkowski --response none
says out "first,third,through,"
run 2 collide "$scenes/cradle.toml" --csv --method boxes
says err "cradle.toml:10:1"
says err "say --response none with it, or leave --method out"
run 4 experiment avoidance "$scenes/cradle.toml"
says err "avoidance looks at what goes on undisturbed"
run 4 experiment gas "$scenes/responses.toml"
says err "in a gas everything bounces, and the response of"
run 4 collide "$root/scenes/markov/runner.toml" --response stop --root /
says err "keep one velocity"
# What lies in each other by hundreds of contacts is refused, not waited for.
sed 's/sides = 4, radius = { uniform = \[0.3, 0.6\]/sides = 4, radius = { uniform = [0.3, 1000000]/' "$scenes/gas.toml" > crowd.toml
run 4 collide crowd.toml --last 3 --csv
says err "contacts hang together at t = 0"
says err "place bodies so that fewer lie in each other"
cat > jam.toml << 'EOF'
flatray = 1
fps = 1
frames = 9
collisions = { response = "bounce" }
[[entity]]
name = "free"
shape = { box = { min = [0, 0], max = [1, 1] } }
[[entity]]
name = "left"
shape = { box = { min = [-3, 0], max = [-2, 1] } }
velocity = [1, 0]
mass = "fixed"
[[entity]]
name = "right"
shape = { box = { min = [3, 0], max = [4, 1] } }
velocity = [-1, 0]
mass = "fixed"
[[entity]]
name = "one"
shape = { circle = { radius = 1 } }
at = [0, 50]
velocity = [1, 0]
[[entity]]
name = "two"
shape = { circle = { radius = 1 } }
at = [3, 50]
EOF
for verb in "collide jam.toml -q" "collide jam.toml --json" "render jam.toml -o jam_####.png"; do
  # shellcheck disable=SC2086
  run 4 $verb
  says err "jam.toml:4:14: error: bodies are jammed"
done
# What came before is drawn and told, and then the jam.
[[ -f jam_0002.png && ! -f jam_0003.png ]] || fail "the frames before t = 2 are drawn"
run 4 collide jam.toml --csv
says out "one,two,1,2,"
says err "find no way out at t = "
says err "flatray: 1 error, what came before is told"
run 4 collide jam.toml --json
says out '"a":"one","b":"two","t":1,'
says out '"errors":[{"file":"jam.toml","line":4,'
run 4 collide jam.toml --csv --response slide --fixed left --fixed right
(($(wc -l < out.txt) == 2)) || fail "what slides is jammed when the second comes"
says err "no way out at t = 2"
# As many hits as pi has digits, nearly at one time: of two bodies more than are waited for.
{
  echo 'flatray = 1'
  printf '%s\n' 'fps = 10' 'frames = 31' '[collisions]' 'response = "bounce"' '[[entity]]' 'name = "floor"' \
    'shape = { box = { min = [-20, -1], max = [20, 0] } }' 'mass = "fixed"' '[[entity]]' 'name = "pebble"' \
    'shape = { circle = { radius = 0.01 } }' 'at = [0, 0.01]' '[[entity]]' 'name = "crate"' \
    'shape = { box = { min = [-10, 0], max = [10, 20] } }' 'at = [0, 5]' 'velocity = [0, -4]'
} > pebble.toml
run 4 collide pebble.toml
says err "meet again and again at t = 1.24"
run 0 collide pebble.toml -q -D 'entity.pebble.at=[0,0.0100001]'
run 4 collide jam.toml --response bounce --fixed left --fixed right
says err "--response: error: bodies are jammed"
run 4 collide jam.toml -q --csv -D collisions.most=1
says err "1 events before t = 8"
(($(wc -l < out.txt) == 2)) || fail "the event that is allowed is told"
run 0 collide jam.toml -f 1 --csv
# A triangle wedged between the arms of a C is thrown from one to the other, an ulp of time later each.
cat > wedged.toml << 'EOF'
flatray = 1
fps = 2
frames = 2
collisions = { response = "bounce" }
[[entity]]
name = "c"
shape = { polygon = { points = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [3, 2], [3, 3], [0, 3]] } }
at = [3.6912795886338685, 1.456552405672305]
velocity = [0.7636087649379544, 0.3930329351851207]
[[entity]]
name = "triangle"
shape = { polygon = { points = [[-0.8552745414071192, -0.44000518205351735], [2.4413635052296163, 0.9175524351125182], [1.6156941315572322, 2.005212343871843]] } }
at = [3.8440966137886914, 2.898925314258662]
velocity = [0.7684743068813891, -1.7073448042552202]
EOF
run 4 collide wedged.toml --csv
says err "bodies are jammed"
(($(wc -l < out.txt) < 10000)) || fail "$(wc -l < out.txt) lines of events before the jam"
# Boxes that land lie still after an event each; one that stands a last bit too low is held by the floor.
cat > pile.toml << 'EOF'
flatray = 1
fps = 1
frames = 100
collisions = { response = "slide" }
[[entity]]
name = "floor"
shape = { box = { min = [-5, -1], max = [5, 0.2] } }
mass = "fixed"
[[entity]]
name = "low"
shape = { box = { min = [-0.1, -0.1], max = [0.1, 0.1] } }
at = [0, 0.3]
velocity = [0, -1]
[[entity]]
name = "high"
shape = { box = { min = [-0.5, -0.5], max = [0.5, 0.5] } }
at = [0, 4]
velocity = [0, -1]
mass = 3
[[entity]]
name = "top"
shape = { box = { min = [-0.5, -0.5], max = [0.5, 0.5] } }
at = [0, 6]
velocity = [0, -1]
EOF
run 0 collide pile.toml --csv
(($(wc -l < out.txt) == 4)) || fail "an event for each box"
(($(grep -c ',0,0,0,0$' out.txt) == 3)) || fail "all come to rest"
says err "respond only where they come nearer: floor and low"
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
says out "grows,waits,,"
for which in big,small small,big; do
  printf 'flatray = 1\nfps = 1\nframes = 3\n' > inside.toml
  for entity in ${which//,/ }; do
    half=5 velocity=0
    [[ $entity == small ]] && half=1 velocity=1
    printf '[[entity]]\nname = "%s"\nshape = { box = { min = [-%d, -%d], max = [%d, %d] } }\nvelocity = [%d, 0]\n' \
      $entity $half $half $half $half $velocity >> inside.toml
  done
  run 0 collide inside.toml --method edge-rays --csv
  says out "$which,,0,2,1,,,,,,by frames,"
done
run 0 collide inside.toml --method edge-rays --json
says out '"class":null'
says out '"start":null,"x":null,"y":null,"normal_x":null,"normal_y":null'
run 0 hit growing.toml --ray 2.5,0.5,1,0 --against grows -f 2
says out "inside"
run 0 explain "$scenes/gas.toml"
says out "104 bounce"
run 0 explain "$root/scenes/demo.toml"
says out "nothing responds to contact"

# Frames of what responds: the same bytes for any threads, shards, resumed, with all kept, and alone.
names=(impact responses)
[[ -z $sanitizers ]] || names=(impact) # ten times as slow
for name in "${names[@]}"; do
  at=$scenes/$name.toml
  run 0 render "$at" -o "$name-one/f_####.png" -j 1
  for j in 2 7; do
    run 0 render "$at" -o "$name-$j/f_####.png" -j "$j"
    same "$name-one" "$name-$j" "$name -j $j"
  done
  for i in 2 0 1; do run 0 render "$at" --shard $i/3 -o "$name-shards/f_####.png"; done
  same "$name-one" "$name-shards" "$name in shards"
  rm "$name-2/"f_00{05,17}.png
  run 0 render "$at" -o "$name-2/f_####.png" --resume
  same "$name-one" "$name-2" "$name resumed"
  run 0 render "$at" -o "$name-keep/f_####.png" --keep-all
  same "$name-one" "$name-keep" "$name with all kept"
  for frame in 1 13 29; do
    run 0 render "$at" -f $frame -o "$name-alone/f_####.png"
    file=f_00$(printf %02d $frame).png
    cmp -s "$name-alone/$file" "$name-one/$file" || fail "frame $frame of $name alone differs"
  done
done
printf 'flatray = 1\n[collisions]\nresponse = "bounce"\n[[entity]]\nname = "top"\nshape = { circle = { radius = 1 } }\nangular_velocity = 9\n' > top.toml
run 4 check top.toml
says err "top.toml:7:20: error: entity 'top' turns, so it cannot respond to contact"
run 4 render top.toml -o top.png
run 0 experiment avoidance "$scenes/methods.toml" -D film.size=[96,60] -o map
exists map/avoidance.png map/avoidance.csv map/avoidance_times.csv
run 0 experiment avoidance "$scenes/methods.toml" -D film.size=[96,60] -o one -j 1
cmp map/avoidance.png one/avoidance.png || fail "threads change the map"
# Ellipses within proven times, also one that turns, and capsules; boxes around what turns are not known.
cat > curved.toml << 'END'
flatray = 1
fps = 1
frames = 10
[[entity]]
name = "egg"
shape = { ellipse = { radii = [2, 1] } }
velocity = [1, 0]
[[entity]]
name = "pill"
shape = { capsule = { from = [8, 0], to = [9, 0], radius = 0.5 } }
END
run 0 collide curved.toml --csv
says out "egg,pill,through,5.4999999999998"
run 0 collide curved.toml -D entity.egg.angular_velocity=5 --csv
says out "egg,pill,through,5."
run 4 collide curved.toml -D entity.egg.angular_velocity=5 --method boxes
says err "entity 'egg' turns, and has curves other than circles and capsules"
run 4 collide curved.toml --response bounce
says err "has curves other than circles and capsules"
# What contact could never be told of is refused by all, check among them.
cat > points.toml << 'END'
flatray = 1
frames = 100
[collisions]
response = "bounce"
[[entity]]
name = "a"
shape = { circle = { radius = 0 } }
mass = 1
velocity = [1, 0]
[[entity]]
name = "b"
shape = { circle = { radius = 0 } }
mass = 1
at = [10, 0]
END
for verb in check collide; do
  run 4 $verb points.toml
  says err "entity 'a' and entity 'b' have no area"
  silent out
done
finish
