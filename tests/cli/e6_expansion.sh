#!/usr/bin/env bash
# needs: shapes/segment
# Scenes that grow without end are refused in little memory, with the option that moves the limit.
source "$(dirname "$0")/lib.sh"
limit_memory 2000000

printf 'flatray = 1\ninclude = ["self.toml"]\n' > self.toml
run 4 check self.toml
says err "self.toml:2:12: error: 'self.toml' includes itself"

{
  echo 'flatray = 1'
  for i in $(seq 0 29); do
    printf '[[group]]\nname = "g%d"\nrepeat = { grid = { count = [2, 1], step = [1, 0] } }\n' "$i"
    ((i == 0)) || printf 'group = "g%d"\n' $((i - 1))
  done
  printf '[[entity]]\ngroup = "g29"\nshape = { box = { min = [0, 0], max = [1, 1] } }\n'
} > double.toml
run 4 check double.toml
says err "error: group stands for 524288, after 524286 before it"
says err "the limit is 1000000; --max-entities raises it"

printf 'flatray = 1\n[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\n%s\n' \
  'repeat = { grid = { count = [4, 3], step = [2, 2] } }' > twelve.toml
run 0 check twelve.toml --max-entities 12
run 4 check twelve.toml --max-entities 11
says err "the limit is 11; --max-entities raises it"
run 2 check twelve.toml --max-entities 16777217

run 0 check double.toml -D 'group=[]' -D 'entity=[]'
printf 'flatray = 1\n[[group]]\nname = "a"\n[[group]]\nname = "b"\ngroup = "a"\n' > nested.toml
run 0 check nested.toml --max-depth 1
run 4 check nested.toml --max-depth 0
says err "the limit is 0; --max-depth raises it"

printf 'flatray = 1\n[[entity]]\nshape = { ngon = { sides = 1000, radius = { uniform = [1, 2] } } }\n%s\n' \
  'repeat = { grid = { count = [1000, 1000], step = [2, 2] } }' > corners.toml
run 4 check corners.toml --max-corners 1000000
says err "corners.toml:3:9: error: the corners of the scene come to more than 1000000"
says err "--max-corners N"
scene line.toml 1 '[[entity]]' 'shape = { segment = { from = [0, 0], to = [16, 0] } }' \
  'stroke = { width = 0.01, dashes = [0.1, 0.1] }' \
  'repeat = { grid = { count = [1, 100000], step = [0, 0.0001] } }'
run 4 render line.toml -o line.png --max-corners 1000000
says err "line.toml:11:1: error: with this a frame draws more than 1000000 corners"
absent line.png
run 2 check line.toml --max-corners 0

run 3 check nested.toml --max-bytes 20
says err "the limit of a scene and its files is 20; --max-bytes raises it"
FLATRAY_MAX_BYTES=20 run 3 check nested.toml
finish
