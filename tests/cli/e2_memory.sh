#!/usr/bin/env bash
# Memory grows with the items of a scene, not with the bands of rows they cover, their pixels or the frames of a chain.
# needs: shapes/box shapes/polygon
source "$(dirname "$0")/lib.sh"
[[ -z $sanitizers ]] || exit 77  # where no limit can be set these runs, of minutes then, tell nothing

# 20000 boxes over 512 bands.
{
  printf 'flatray = 1\nfilm = { size = [4096, 4096], world = [[0, 0], [16, 16]] }\n'
  printf '[[entity]]\nshape = { box = { min = [-1, -1], max = [17, 17] } }\nfill = "#c0392b"\n'
  printf 'repeat = { grid = { count = [20000, 1], step = [1e-6, 0] } }\n'
} > boxes.toml
# 3000 translucent slivers in each of 540 rows: a run a row each. Runs of 16 bytes would take them to 52 MB.
{
  printf 'flatray = 1\nfilm = { size = [16, 540], world = [[0, 0], [16, 540]] }\n'
  printf '[[entity]]\nshape = { polygon = { points = [[0, 0], [9, 540], [8.9, 540]] } }\nfill = "#3498db40"\n'
  printf 'repeat = { grid = { count = [3000, 1], step = [0.0023, 0] } }\n'
} > slivers.toml
# 100 chains for 200000 frames.
{
  printf 'flatray = 1\nfilm = { size = [16, 9], world = [[0, 0], [16, 9]] }\n'
  printf '[markov.c]\nA = { A = 0.5, B = 0.5 }\nB = { A = 1 }\n'
  printf '[[entity]]\nshape = { box = { min = [0, 0], max = [1, 1] } }\nvelocity = [1e-6, 0]\n'
  printf 'markov = { chain = "c", start = "A" }\nrepeat = { grid = { count = [10, 10], step = [1, 1] } }\n'
} > chains.toml
# 500 curves that each have thousands of parts at this width.
{
  printf 'flatray = 1\nfilm = { size = [16, 12], world = "pixels" }\n[[entity]]\nshape = { bezier = { points = [[0, 0]'
  awk 'BEGIN { for (i = 0; i < 500; i++) printf ", [%d, %g], [%d, %g], [%d, 0]", i, 1.5 - i % 2 * 3, i + 1, 1.5 - i % 2 * 3, i + 1 }'
  printf '] } }\nstroke = { width = 1e6 }\n'
} > wave.toml
# What they took when it did grow: boxes 1400 MB, chains 600 and the wave 700, instead of 97, 76 and 20.
limit_memory 300000
run 4 render wave.toml -o wave.png -j 1 --max-corners 10000
says err "draws more than 10000 corners"
run 0 render boxes.toml -o boxes.png -j 1
run 0 render chains.toml -f 200000 -o chains.png -j 1
limit_memory 48000 # 26 MB, of which the program itself is 16
run 0 render slivers.toml -o slivers.png -j 1
finish
