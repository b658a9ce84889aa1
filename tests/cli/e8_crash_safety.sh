#!/usr/bin/env bash
# Killed at any moment, a full disk, a folder that cannot be written, two runs at once: every file with a final name is
# whole, and the resumed sequence is that of an unbroken run.
source "$(dirname "$0")/lib.sh"
scene box.toml 60
run 0 render box.toml -o 'whole/f_####.png' --quiet

# kill -9 at 25 moments of one sequence.
whole_files() {  # every picture so far is byte for byte the one of the unbroken run
  local file
  for file in "$1"/*.png; do
    [[ -e $file ]] || continue
    cmp -s "$file" "whole/${file##*/}" || fail "not whole: $file"
  done
}
kills=0
for i in {1..25}; do
  "$flatray" render box.toml -o 'killed/f_####.png' -j $((i % 2 + 1)) --resume --quiet 2> /dev/null &
  pid=$!
  sleep "0.0$((RANDOM % 9))$((RANDOM % 9))"
  kill -9 $pid 2> /dev/null
  wait $pid 2> /dev/null || kills=$((kills + 1))
  ((i % 5 == 0)) && rm -f killed/f_00[1-4]?.png  # leave it something to do
  whole_files killed
done
echo "killed $kills times"
((kills > 0)) || fail "no run was killed: nothing was tested"
run 0 render box.toml -o 'killed/f_####.png' --resume --quiet
same whole killed "killed and resumed"
same_manifest whole killed "killed and resumed"

# Disk full: the limit is on a file's size, in blocks of 1024 bytes. Nothing with a final name is broken.
scene large.toml 4 'stroke = { width = 0.01, colour = "#000000" }'
(
  ulimit -f 1
  "$flatray" render large.toml --size 3000x2000 -o 'full/f_####.png' > out.txt 2> err.txt
  echo $? > code.txt
)
[[ $(cat code.txt) == 6 ]] || fail "full disk: exit code $(cat code.txt)"
says err "cannot write"
absent full/f_0001.png
[[ -z $(find full -name '.*.part') ]] || fail "a temporary file stayed"

# Folders that cannot be.
run 6 render box.toml -o 'box.toml/f_####.png'
run 6 render box.toml -o '/proc/flatray/f_####.png'
says err "cannot"
if ((EUID != 0)); then
  mkdir read_only
  chmod a-w read_only
  run 6 render box.toml -o 'read_only/f_####.png'
  says err "Permission denied"
fi

# Two runs into one folder.
"$flatray" render box.toml -o 'both/f_####.png' --quiet &
"$flatray" render box.toml -o 'both/f_####.png' --quiet
wait
same whole both "two runs at once"
finish
