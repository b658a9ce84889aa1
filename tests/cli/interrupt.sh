#!/usr/bin/env bash
# needs: shapes/circle
# Ctrl-C and SIGTERM: files in flight are finished, a frame that takes long is left, the exit code is 130 or 143, --resume
# goes on.
source "$(dirname "$0")/lib.sh"
scene box.toml 4000
for run in 'INT 130 interrupted' 'TERM 143 terminated'; do
  read -r signal expected word <<< "$run"
  rm -rf out
  # A shell starts what runs in the background deaf to SIGINT; env gives it back its ears.
  env --default-signal=INT,TERM "$flatray" render box.toml -o 'out/f_####.png' -j 2 2> err.txt &
  pid=$!
  for _ in {1..100}; do
    [[ -s out/manifest.jsonl ]] && break
    sleep 0.02
  done
  kill -$signal $pid
  wait $pid
  code=$?
  ((code == expected)) || fail "SIG$signal: exit code $code"
  says err "$word"
  says err "--resume"
  files=$(ls out/*.png | wc -l)
  lines=$(wc -l < out/manifest.jsonl)
  ((files == lines && files > 0 && files < 4000)) || fail "$files files, $lines lines"
  [[ -z $(find out -name '.*.part') ]] || fail "a temporary file stayed"
done

# One frame of some 10^10 blended pixels, of which none is seen.
scene long.toml 1 '[[entity]]' 'shape = { circle = { radius = 20 } }' 'opacity = 0.5' \
  'fill = { linear = { from = [0, 0], to = [16, 12], stops = ["#ff0000", "#0000ff"] } }' \
  'repeat = { grid = { count = [200, 1], step = [0.01, 0] } }'
for options in '-o long.png' '-o long.hdr' '-o long.png --keep-all'; do
  env --default-signal=INT "$flatray" render long.toml --size 8000x6000 $options -j 2 2> err.txt &
  pid=$!
  sleep 1
  start=$SECONDS
  kill -INT $pid
  wait $pid
  code=$?
  ((code == 130)) || fail "$options: exit code $code"
  ((SECONDS - start < 5)) || fail "$options: ended $((SECONDS - start)) s after the signal"
  says err "flatray: interrupted"
  absent long.png long.hdr
  [[ -z $(find . -name '.*.part') ]] || fail "a temporary file stayed"
done

# One path of 100 000 lines, and one band.
scene path.toml 1 '[[chamber]]' 'shape = { box = { min = [0, 0], max = [20, 20] } }' '[[ray]]' \
  'at = [15, 5]' 'direction = [1, 0.7320508]' 'bounces = 100000' 'stroke = { width_px = 1, colour = "#ff0000" }'
env --default-signal=INT "$flatray" render path.toml --size 1000x100 -o path.png -j 1 2> err.txt &
pid=$!
sleep 2
kill -INT $pid
wait $pid
code=$?
((code == 130)) || fail "one path: exit code $code"
absent path.png
finish
