#!/usr/bin/env bash
# Ctrl-C: frames in flight are finished, the exit code is 130, --resume goes on.
source "$(dirname "$0")/lib.sh"
scene box.toml 4000
for signal in INT TERM; do
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
  ((code == 130)) || fail "SIG$signal: exit code $code"
  says err "interrupted"
  says err "--resume"
  files=$(ls out/*.png | wc -l)
  lines=$(wc -l < out/manifest.jsonl)
  ((files == lines && files > 0 && files < 4000)) || fail "$files files, $lines lines"
  [[ -z $(find out -name '.*.part') ]] || fail "a temporary file stayed"
done
finish
