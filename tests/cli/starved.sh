#!/usr/bin/env bash
# Machines that have no more threads or memory, and files that never end: a message and an exit code, soon.
source "$(dirname "$0")/lib.sh"
scene box.toml 3

run 0 render box.toml -o 'all/f_####.png' -j 1 -q
if [[ -z $sanitizers ]] && (ulimit -s 4000000) 2> /dev/null; then
  # A stack of 4 GB for each further thread, which there is not: the first one does all.
  (ulimit -s 4000000 -v 3500000 && run 0 render box.toml -o 'alone/f_####.png' -j 8 -q && exit $((failures > 0))) || fail "no threads"
  same all alone "without threads"
  (ulimit -v 60000 && run 70 render box.toml -f 1 -o p.png --size 8000x8000 -j 1 && says err "out of memory" && exit $((failures > 0))) || fail "no memory"
  absent p.png

  # A plank that every disc meets: what the plank was to meet had it not been hit is not kept.
  awk 'BEGIN {
    print "flatray = 1\nframes = 31\nfps = 10\n[collisions]\nresponse = \"bounce\""
    print "[[entity]]\nshape = { box = { min = [-1, -1], max = [3000, 0] } }"
    for (i = 0; i < 1000; i++)
      printf "[[entity]]\nshape = { circle = { radius = 0.5 } }\nat = [%d, %.3f]\nvelocity = [0, -1]\n", 2 * i, 1 + i * 379 % 1000 / 1000
  }' > plank.toml
  (limit_memory 30000 && run 0 collide plank.toml -q -j 1 && exit $((failures > 0))) || fail "a plank with many discs"
  # Rows are made when they are written.
  awk 'function round(name, radius, i) {
    printf "[[entity]]\nname = \"%s\"\nshape = { polygon = { points = [", name
    for (i = 0; i < 600; i++) printf "[%.9f, %.9f], ", radius * cos(i * 0.01047), radius * sin(i * 0.01047)
    print "] } }"
  }
  BEGIN { print "flatray = 1"; round("a", 3); round("b", 2) }' > rounds.toml
  (limit_memory 110000 && run 0 hit rounds.toml --from a --against b --csv && exit $((failures > 0))) || fail "many rows"
fi
# Two outlines each of whose lines meets many of the other: no more is kept than is told.
{
  echo 'flatray = 1'
  for k in 0 1; do
    printf '[[entity]]\nshape = { polyline = { points = ['
    for ((i = 0; i < 1500; i++)); do printf '[0.%04d, 0.%d], ' $i $((i % 2 * 9)); done
    printf '[1, 0]] } }\nat = [%d, 0]\nvelocity = [%d, 0]\n' $((-24 * k)) $((24 * k))
  done
} > lines.toml
(limit_memory 200000 && run 0 collide lines.toml --last 25 -j 1 && exit $((failures > 0))) || fail "lines of two outlines"
run 124 render box.toml -f 1 -o p.png --size 8000x8000 -j 1 --max-seconds 0.001
says err "the time of --max-seconds is over"
absent p.png

# What the user did not name is no pipe and no device: a frame, a manifest, a golden, a profile, rows of a log.
mkdir pipes && mkfifo pipes/f_0001.png
cp all/manifest.jsonl pipes/
run 6 render box.toml -f 1..3 -o 'pipes/f_####.png' --resume -q
says err "f_0001.png: error: is not a plain file"
rm pipes/manifest.jsonl && mkfifo pipes/manifest.jsonl
run 6 render box.toml -o 'pipes/f_####.png' --resume -q
says err "manifest.jsonl: error: is not a plain file"
run 3 render box.toml -f 1 -o p.png --profile /dev/zero --error 0.1
says err "/dev/zero: error: is not a plain file"
mkdir log && ln -s /dev/zero log/stability.csv
run 6 stability --count 1 --families vertex --tracer grid -o log
says err "stability.csv: error: is a link"
mkdir -p golden_images && mkfifo golden_images/manifest.json
run 3 golden check
says err "manifest.json: error: is not a plain file"

# Of what is no picture the beginning is read; of what is named, a pipe is read.
cp all/f_0001.png a.png
printf 'no picture' > b.png && truncate -s 2000M b.png
(limit_memory 400000 && run 4 compare a.png b.png && exit $((failures > 0))) || fail "a large file that is no picture"
truncate -s 5000M b.png
run 3 compare a.png b.png
says err "is larger than"
run 0 compare a.png <(cat all/f_0001.png)
finish
