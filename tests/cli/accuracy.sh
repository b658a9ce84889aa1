#!/usr/bin/env bash
# `flatray accuracy`: files, a table for people, a budget that cuts, and what it refuses.
source "$(dirname "$0")/lib.sh"
scene box.toml 3
run 0 accuracy box.toml -o out --budget 5s
says out "coverage: What does it cost"
says out "left out: "
exists out/accuracy.{csv,json,html} out/accuracy_coverage.svg
head -1 out/accuracy.csv | grep -q '^choice,series,setting,n,seconds' || fail "header of accuracy.csv"
run 0 accuracy box.toml -o json --choice coverage --budget 5 --json
says out '"files":'
says out '"points":[{"choice":"coverage",'
grep -qE '"seconds":[0-9.e-]+,"seconds_half_range":([0-9.e-]+|null),"error":[0-9.e-]+,' out.txt || fail "no numbers in --json"
run 0 accuracy box.toml -o cut --choice coverage --budget 0.000001s
says out "not within the budget: reference of 16 samples"
says out "exact area, 4 rays a row"
run 2 accuracy box.toml --choice covrage
says err "did you mean 'coverage'?"
run 2 accuracy box.toml --budget soon
says err "is not a time above 0"
field=$root/scenes/chamber/magnetic_stadium.toml
run 0 accuracy "$field" -o field --choice coverage --budget 0.000001s
run 4 accuracy "$field" --choice tracer
says err "a magnetic field bends them"
# What must not be replaced is told before anything is measured.
for name in accuracy.csv accuracy.json accuracy.html accuracy_light.svg; do
  rm -rf foreign && mkdir foreign && echo 'all I know' > "foreign/$name"
  SECONDS=0
  run 6 accuracy "$root/scenes/light/nephroid.toml" -o foreign --choice light --budget 60s
  ((SECONDS < 15)) || fail "$name is refused after $SECONDS s"
done
# So is what cannot be written, and nothing is left half written.
echo > taken
SECONDS=0
run 6 accuracy "$root/scenes/light/nephroid.toml" -o taken/out --choice light --budget 60s
says err "taken/out: error: cannot make the folder: Not a directory"
((SECONDS < 15)) || fail "a folder in a file is refused after $SECONDS s"
run 6 accuracy box.toml -o unwritten --choice coverage --budget 0.1 --profile taken/box.profile
says err "taken: error: cannot make the folder"
absent unwritten
# A circle of radius 0 is no wall that a reference meets.
run 0 accuracy "$root/scenes/language/growing.toml" -o growing --choice tracer --budget 0.1
says out "(oracle/long_orbit)"
finish
