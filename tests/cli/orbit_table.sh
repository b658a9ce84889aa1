#!/usr/bin/env bash
# The hall's diamond: twelve bounces, back at (10, 0), having travelled 115 sqrt(2).
# needs: shapes/box
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
run 2 orbit "$hall" --ray prob
says err "did you mean 'probe'?"
scene box.toml 1
run 4 orbit box.toml
says err "has no ray to follow"
finish
