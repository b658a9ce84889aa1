#!/usr/bin/env bash
# needs: shapes/circle shapes/convex formats/hill formats/toml
# flatray help: a page for every verb, topic, table and shape; the tables' keys are those that are read.
source "$(dirname "$0")/lib.sh"
run 0 help
says out "exit-codes"
for name in $("$flatray" completion words -- flatray help '' | cut -f1); do
  run 0 help "$name"
  silent err
  (($(wc -l < out.txt) >= 3)) || grep -q 'has no keys; as in: ' out.txt || fail "help $name says nothing"
done
for name in $("$flatray" list verbs | awk '{ print $1 }') $("$flatray" list shapes | awk '{ print $1 }') \
  frames output scene colours exit-codes markov camera determinism limits hill; do
  run 0 help "$name"
done
run 0 help film
says out '[width, height]'
says out '[640, 360]'
run 0 help glass  # and by its whole name, material.glass
says out 'material = { glass = { ... } }'
says out 'dispersion'
run 0 help beam
says out 'source = { beam = { ... } }'
run 0 help markov
says out 'hold'
says out 'the chain'"'"'s first row'
run 2 help camra
says err "did you mean 'camera'?"
run 2 help rendr
says err "did you mean 'render'?"
run 2 help zqzqzqzq
says err 'there are: '

# Scenes in the pages are scenes.
"$flatray" help scene | sed -n '/^  flatray = 1/,/radius/p' > smallest.toml
run 0 check smallest.toml
{ echo 'flatray = 1'; "$flatray" help markov | sed -n '/^  \[markov.paper\]/,/RUNNING  =/p'; } > chain.toml
run 0 check chain.toml
{ echo 'flatray = 1'; "$flatray" help camera | grep '^  camera = '
  printf '[[entity]]\nname = "kite"\nshape = { circle = { radius = 1 } }\n'; } > camera.toml
run 0 check camera.toml

# So is the room in the page on Hill's format, and what it says of the ray is so.
"$flatray" help hill | sed -n '/^  2$/,/^  3 /p' > room.chamber
run 0 check room.chamber
run 0 convert room.chamber room.toml
grep -q 'at = \[4, 3\]' room.toml || fail "the ray does not start in the mean of the corners"
grep -q 'direction = \[1, 0.375\]' room.toml || fail "the ray goes elsewhere"
grep -q 'bounces = 30' room.toml || fail "the ray bounces otherwise"
run 0 render room.chamber -D ray.0.at=[1,1] -D ray.0.direction=[1,2] -D ray.0.bounces=9 --size 64x48 -o room.png
exists room.png
finish
