#!/usr/bin/env bash
# needs: shapes/box lamps/point materials/diffuse materials/glass formats/toml passes/light
# Films of light: more rays, shards and runs that were killed give the bytes of one run.
source "$(dirname "$0")/lib.sh"
cat > lamp.toml << 'END'
flatray = 1
film = { size = [40, 30], world = [[-4, -3], [4, 3]], background = "#000000" }
light = { bounces = 2, exposure = 3.0, tone = "filmic" }
[[lamp]]
source = { point = {} }
at = [-2, 1]
[[entity]]
fill = "none"
shape = { box = { min = [0, -1], max = [1, 1] } }
material = { diffuse = { reflectance = 0.7, colour = "#ffc080" } }
END
as_one() { cmp -s "$1" "$2" || fail "$3: $1 and $2 differ"; }

# A stopped picture of light says what would have kept it: --resume without a film is refused.
for to in v.png -; do
  run 124 render lamp.toml --rays 100000000000 -f 1 --max-seconds 0.2 -o $to
  says err "nothing of a picture's light is kept; -o NAME.film --resume keeps and adds to it"
  grep -q 'same command' err.txt && fail "the same command goes on with $to"
done

# A film that is not to be resumed stays until there is another.
run 0 render lamp.toml --rays 524288 -o kept.film --quiet
cp kept.film before.film
run 124 render lamp.toml --rays 100000000000 -o kept.film --max-seconds 5
as_one before.film kept.film "a run that was stopped"

# Threads, more rays, shards in any order; of three rounds of 262144 rays.
run 0 render lamp.toml --rays 786432 -o all.film -j 1 --quiet
for threads in 2 7; do
  run 0 render lamp.toml --rays 786432 -o threads.film -j $threads --quiet
  as_one all.film threads.film "$threads threads"
done
run 0 render lamp.toml --rays 300000 -o more.film --quiet
run 0 render lamp.toml --rays 786432 -o more.film --resume --quiet
as_one all.film more.film "more rays"
run 0 render lamp.toml --rays 786432 -o more.film --resume --quiet
as_one all.film more.film "nothing left to do"
for i in 0 1 2; do run 0 render lamp.toml --rays 786432 --ray-shard $i/3 -o $i.film --quiet; done
run 0 merge 2.film 0.film 1.film -o merged.film --quiet
as_one all.film merged.film "shards"
run 0 merge 1.film 2.film -o part.film --quiet
run 0 merge part.film 0.film -o merged.film --quiet
as_one all.film merged.film "shards, two first"
# Light that fades is many lines a leg.
sed 's/^material.*/material = { glass = { absorption = [1, 2, 3] } }/' lamp.toml > tinted.toml
run 0 render tinted.toml --rays 524288 -o tinted.film -j 2 --quiet
for i in 0 1; do run 0 render tinted.toml --rays 524288 --ray-shard $i/2 -o t$i.film --quiet; done
run 0 merge t1.film t0.film -o faded.film --quiet
as_one tinted.film faded.film "shards of what fades"
run 0 render lamp.toml --rays 786432 --ray-shard 4/5 -o empty.film --quiet
run 0 merge empty.film -o dark.png --quiet
run 0 render lamp.toml --rays 1 --seed 7 -o seed.film --quiet

# Pictures of films are pictures of scenes.
for format in png hdr pfm; do
  run 0 merge seed.film -o merged.$format --quiet
  run 0 render lamp.toml --rays 262144 --seed 7 -o rendered.$format --quiet
  as_one merged.$format rendered.$format "a picture"
done
run 0 merge all.film -o all.png --quiet
run 0 merge all.film --tone linear --exposure auto -o linear.png --quiet
! cmp -s linear.png all.png || fail "--tone changes nothing"
run 2 merge all.film --tone sfot -o x.png
says err "say linear, soft, filmic"
run 2 merge all.film --exposure 0 -o x.png
for format in film hdr pfm; do
  run 2 merge all.film --tone soft -o x.$format
  says err "a .$format keeps light as it is"
  run 2 merge all.film --exposure 2 -o x.$format
done
run 2 merge all.film -o x.jpg
says err "does not end in ."
says err "as picture.png"
run 2 merge all.film

# What does not go together.
run 4 merge all.film 1.film -o x.film
says err "1.film: error: has rays that are in the films before, too"
run 4 merge all.film seed.film -o x.film
says err "is a film of other light: its seed is 7, not 0"
run 0 render lamp.toml --rays 1 -D film.size=[8,8] -o size.film --quiet
run 4 merge all.film size.film -o x.film
says err 'its size is "8x8", not "40x30"'
run 6 render lamp.toml --seed 7 -o all.film --resume
says err "is a film of other light: its seed is 0, not 7"
head -c 1000 all.film > cut.film
run 4 merge cut.film -o x.film
says err "cut.film: error: film has 1000 bytes, and its header tells of"
run 3 merge absent.film -o x.film
run 4 merge lamp.toml -o x.film
says err "is not a film of this version"
run 6 merge all.film -o lamp.toml/x.png
run 2 render lamp.toml --ray-shard 0/2 -o x.png
says err "needs a film"
run 2 render lamp.toml --crop 0,0,4,4 -o x.film
sed '/lamp\]/,/^at/d' lamp.toml > unlit.toml
run 2 render unlit.toml -o x.film
says err "is of light, and the scene has no lamp"
run 2 render unlit.toml --error 0.1 -o x.png
says err "needs --profile, or lamps"
run 2 render lamp.toml -o x.png --resume
says err "then flatray merge light.film"
absent x.film x.png x.hdr x.pfm

# From pixels: the same for any threads, other noise, and not with mirrors before a point.
run 0 render lamp.toml --estimator forward --rays 20000 -o forward.png --quiet
run 0 render lamp.toml --estimator backward --rays 20000 -o backward.png -j 1 --quiet
run 0 render lamp.toml --estimator backward --rays 20000 -o two.png -j 2 --quiet
as_one backward.png two.png "threads of pixels"
! cmp -s forward.png backward.png || fail "--estimator backward does what forward does"
run 2 render lamp.toml --estimator backward -o x.film
says err "backward has no rounds of rays, which a film is made of"
for more in "--error 0.1" "--error-image e.png" "-D light.scrambles=16"; do
  run 2 render lamp.toml -D 'light.estimator="backward"' $more -o x.png
  says err "or leave"
done
run 4 render lamp.toml -D 'entity.0.material="mirror"' --estimator backward -o x.png
says err "no path from a pixel finds the light of lamp"
run 2 render lamp.toml --estimator sideways -o x.png

# Killed at any moment, then resumed.
run 0 render lamp.toml --rays 1048576 -o long.film --quiet
for delay in 0.1 0.3 0.7; do
  "$flatray" render lamp.toml --rays 1048576 -o killed.film --resume --quiet &
  sleep $delay
  kill -9 $! 2> /dev/null
  wait $! 2> /dev/null
  [[ ! -e killed.film ]] || run 0 merge killed.film -o killed.png --quiet
done
run 0 render lamp.toml --rays 1048576 -o killed.film --resume --quiet
as_one long.film killed.film "killed and resumed"

# The error.
run 0 render lamp.toml --error 0.05 --error-image error.pfm -o lit.pfm --json
says out '"error":0.0'
[[ $(head -c 13 error.pfm) == $'PF\n40 30\n-1.0' ]] || fail "no error image"
run 0 render lamp.toml --time 0.01 -D light.scrambles=16 -o lit.png --json
says out '"rounds":1,'
run 0 render lamp.toml --rays 100000 -D light.scrambles=16 -o lit.film --json --progress always
says err "rays, error 0.0"
run 0 merge lit.film -o lit.png --error-image error.png --json
says out '"error":0.0'
run 2 merge all.film -o lit.png --error-image error.png
says err "needs films of 16 scrambles or more"
run 2 merge lit.film -o lit.png --error-image error.film
says err "is a picture, not a film"
run 0 render lamp.toml -D light.scrambles=16 --rays 786432 --ray-shard 4/5 -o none.film
run 0 merge none.film -o none.png --json
says err "of 0 rays, no error yet"
! grep -q '"error"' out.txt || fail "an error of no rays"
run 2 render lamp.toml --error 0 -o lit.png
run 2 render lamp.toml --error-image lit.png -o lit.png
run 2 render lamp.toml -D light.scrambles=3 -o lit.png

# Frames whose picture of the error was not asked for, is gone or not as written are rendered again.
sed 's/^flatray = 1/flatray = 1\nframes = 3/; s/^at = .*/velocity = [1, 0]/' lamp.toml > errors.toml
errors() { run 0 render errors.toml --size 8x6 --error 0.5 -o 'e/####.png' "$@"; }
errors
run 0 render errors.toml --size 8x6 --error 0.5 -o 'f/####.png' --error-image 'ferr/####.pfm' --quiet
changes=(3 1 1 2)
for change in : 'rm err/0002.pfm' 'truncate -s -1 err/0002.pfm' 'cp err/0001.pfm err/0003.pfm; rm e/0001.png'; do
  eval "$change"
  errors --error-image 'err/####.pfm' --resume
  says err "flatray: ${changes[0]} frame"
  changes=("${changes[@]:1}")
  for i in 1 2 3; do as_one err/000$i.pfm ferr/000$i.pfm "$change"; as_one e/000$i.png f/000$i.png "$change"; done
done
errors --error-image 'err/####.pfm' --resume
says err "0 frames written, 3 kept"
errors --resume
says err "0 frames written, 3 kept"
run 0 verify e
errors --error-image "$PWD/e/error_####.pfm" --force
run 0 verify e
truncate -s -1 e/error_0002.pfm
rm e/error_0003.pfm
run 1 verify e
says out "e/error_0002.pfm: differs from its record"
says out "e/error_0003.pfm: is missing"
says out "2 things not as recorded"

# Lost light is told.
sed 's/bounces = 2, //; s/^material.*/material = "mirror"/; s/^at = .*/at = [0.5, 0]/' lamp.toml > shut.toml
run 0 render shut.toml --rays 100 -o lit.png
says err "of the light is lost"
says err "light.bounces=10000"
run 0 render shut.toml --rays 100 -D light.bounces=3 -o lit.png
! grep -qF "of the light is lost" err.txt || fail "the cut that the scene asks for is warned of"
run 0 render shut.toml --rays 100 -D light.bounces=3 -o lit.png --json
says out '"cut_off":1'
run 0 render lamp.toml --rays 1000 -o lit.png --json
says out '"cut_off":0'

# A sequence: a film a frame, each with its record.
sed 's/^flatray = 1/flatray = 1\nframes = 2/; s/^at = .*/velocity = [1, 0]/; s/^light = {/& scrambles = 16,/' lamp.toml > moving.toml
run 0 render moving.toml --rays 262144 -o 'seq/####.film' --quiet
run 0 render moving.toml --rays 524288 -o 'seq/####.film' --resume --quiet
run 0 render moving.toml --rays 524288 -o 'once/####.film' --quiet
as_one seq/0002.film once/0002.film "a sequence"
run 0 verify seq
run 4 merge seq/0001.film seq/0002.film -o x.film
says err "its frame is 2, not 1"

# Of light that does not move one is traced for all frames, and shown below what moves.
cat > below.toml << 'END'
flatray = 1
frames = 3
END
sed 1d lamp.toml >> below.toml
cat >> below.toml << 'END'
[[entity]]
shape = { box = { min = [-3, -2], max = [-2, -1] } }
velocity = [10, 5]
fill = "#3366cc"
END
run 0 explain below.toml
says out "traced once"
run 0 render below.toml -D light.rays=10000 -o 'once/####.png' --quiet
run 0 render below.toml -D light.rays=10000 -o 'each/####.png' --keep-all --quiet
same once each "light that is kept"
! cmp -s once/0001.png once/0002.png || fail "nothing moves"
for moving in lamp.0.velocity=[1,0] entity.0.velocity=[1,0] light.noise=\"moving\" camera.velocity=[1,0]; do
  run 0 explain below.toml -D $moving
  says out "each traced"
done
# An error that the rays do not reach is told.
run 0 render lamp.toml --rays 1 --error 1e-6 --size 8x6 -o short.png
says err "warning: the error is"
finish
