#!/usr/bin/env bash
# The hall's diamond: twelve bounces, back at (10, 0), having travelled 115 sqrt(2).
# needs: shapes/box shapes/circle shapes/polygon
source "$(dirname "$0")/lib.sh"
hall=$root/scenes/chamber/hall.toml
run 0 orbit "$hall" --csv
(($(wc -l < out.txt) == 13)) || fail "$(wc -l < out.txt) lines, expected a header and 12 bounces"
last=$(tail -1 out.txt)
[[ $last == probe,12,10,162.63455967290594,* && $last == *,10,0,hall,0,* ]] || fail "last bounce: $last"
run 0 orbit "$hall" --ray probe -n 100
says out "probe: limit after 100 bounces"
run 0 orbit "$hall" --json
says out '"end":"limit"'
# What is certain, where it starts (C29), and what becomes of a ray in a corner (C7).
run 0 orbit "$hall" -D 'ray.0.at=[15,15]' -n 3
says out "probe: corner after 0 bounces at (20, 20), hall edge 1 and hall edge 2"
run 0 orbit "$hall" -D 'ray.0.at=[15,15]' -n 3 --corner back
says out "limit after 3 bounces"
run 0 orbit "$hall" -D 'ray.0.at=[25,5]' -n 3
says err "ray 'probe' starts outside hall"
says out "started outside hall"
run 0 orbit "$hall" -D 'ray.0.at=[20,5]' -D 'ray.0.direction=[-1,1]' -n 3
says out "started on hall edge 1"
sinai=$root/scenes/chamber/sinai.toml
run 0 orbit "$sinai" --ray one -D 'ray.0.at=[0.5,0.5]'
says err "ray 'one' starts inside box/disc"
run 0 orbit "$sinai" --ray one -D 'ray.0.at=[0.5,0.5]' --json -q
silent err
says out '"message":"ray '"'"'one'"'"' starts inside box/disc"'
run 0 orbit "$sinai" --ray one -n 60
says out "only the first 4"
if "$flatray" --version | grep -q "MPFR"; then
  run 0 orbit "$sinai" --ray one -n 60 --precision certified --csv
  (($(grep -c ',yes$' out.txt) == 60)) || fail "a certified orbit has bounces that are not"
  # Lengths in the world are the same for directions far longer and shorter.
  for far in 1e300 1e-300 1e-309; do
    run 0 orbit "$hall" -D "ray.0.direction=[$far,$far]" --precision certified --csv
    last=$(tail -1 out.txt)
    [[ $last == *,162.6345596729059*,10,0,hall,0,0,1,4[45]* ]] || fail "of a direction of $far: $last"
  done
  # Of what follows an undecided orbit nothing is known, and nothing said.
  run 0 orbit "$sinai" --ray one -n 60 --precision certified --bits 128
  says out "one: undecided after 3"
  says out "what follows is not by 128 bits, doubles are near all of these bounces"
  run 0 orbit "$sinai" --ray one -n 60 --precision certified --bits 128 --json
  says out '"horizon_of_doubles":null'
  says out '"end_certain":false,"end":"undecided"'
fi
run 2 orbit "$sinai" --bits 256
says err "--bits: error: is about certified orbits"
FLATRAY_BITS=256 run 0 orbit "$sinai" --ray one -n 3
run 2 orbit "$sinai" --precision certified --corner back
says err "leave --corner back out"
run 0 orbit "$sinai" --svg
says out "<svg xmlns"
(($(grep -c '<path .*<title>' out.txt) == 2)) || fail "two rays were to be drawn"
grep -q '>26</text>' out.txt || fail "26 bounces each were to have their numbers"
run 0 orbit "$sinai" --svg -n 40
grep -q '>26</text>' out.txt && fail "80 numbers were drawn one over the other"
# A fan by its name, or one ray of it; periodic walls are crossed.
gallery=$root/scenes/chamber/kaleidoscope.toml
run 0 orbit "$gallery" --ray 'side by side'
(($(grep -c 'limit after 12 bounces' out.txt) == 3)) || fail "three rays of the fan were to be followed"
run 0 orbit "$gallery" --ray 'side by side 2'
says out "side by side 2: limit after 12 bounces"
# Rays without names are asked for by their numbers.
printf '%s\n' 'flatray = 1' 'film = { size = [9, 9] }' '[[ray]]' 'at = [0, 0]' 'direction = [1, 0]' > nameless.toml
run 2 orbit nameless.toml --ray nope
says err "--ray: error: no ray of the scene is called 'nope'"
says err 'ray 1'
run 0 orbit nameless.toml --ray 'ray 1'
lorentz=$root/scenes/chamber/lorentz.toml
run 0 orbit "$lorentz"
says out "cell/disc"
if "$flatray" --version | grep -q "MPFR"; then
  run 0 orbit "$lorentz" -n 80 --precision certified
  says out "doubles are noise after"
  run 0 orbit "$hall" -n 9 --precision certified -D 'chamber.0.shape={polygon={points=[[0,0],[3,0],[0,4]]}}' \
    -D 'ray.0.at=[1,1]' -D 'ray.0.direction=[71,47]'
  says out "probe: corner after 1 bounce at (0, 0)"
  says out "exact numbers"
fi
run 2 orbit "$hall" --ray prob
says err "did you mean 'probe'?"
scene box.toml 1
run 4 orbit box.toml
says err "has no ray to follow"
# At finite speed: each meeting with the piston adds 2 to the speed along x (the times are in the scene).
fermi=$root/scenes/chamber/fermi.toml
run 0 orbit "$fermi" --csv
head -1 out.txt | grep -q ',time,speed$' || fail "no columns of time and speed"
grep -q '^ball,2,0.8,9,8.2,1.6,piston,.*,unknown,1.8,6.708203932499369$' out.txt || fail "the first bounce off the piston"
(($(grep -c ',piston,' out.txt) >= 5)) || fail "the piston is met"
run 0 orbit "$fermi" --csv --speed none
head -1 out.txt | grep -q ',certain$' || fail "frozen orbits have no time"
run 0 orbit "$fermi" -n 2 --json
says out '"end_speed":6.708203932499369'
run 0 orbit "$hall" --speed 10 -n 12 --csv
last=$(tail -1 out.txt)
[[ $last == probe,12,* && $last == *,unknown,16.263455967290593,10 ]] || fail "at a speed among walls at rest: $last"
run 2 orbit "$fermi" --precision certified
says err "leave it out, or say --speed none"
run 2 orbit "$fermi" --speed 0
run 2 orbit "$fermi" --speed 1e308
says err "above 0 and below 1e+300, or none"
run 0 orbit "$fermi" -n 1000
says out "limit after 1000 bounces"
run 4 orbit "$fermi" -D 'entity.0.angular_velocity=1'
says err "mirror 'piston' turns"
run 0 orbit "$fermi" -D 'entity.0.angular_velocity=1' -D 'ray.0={at=[1,1],direction=[4,3],bounces=3}'
run 4 orbit "$fermi" -D 'entity.0.angular_velocity=1' -D 'ray.0={at=[1,1],direction=[4,3],bounces=3}' --speed 5
finish
