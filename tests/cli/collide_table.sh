#!/usr/bin/env bash
# The paper's case II, its velocity a tenth: first contact at 5710/635, between frames; at every frame rate the same.
# needs: shapes/box
source "$(dirname "$0")/lib.sh"
case_two=$root/scenes/paper/case_two.toml
run 0 collide "$case_two" --csv
says out "box_2,box_1,through,8.992125984251969,11,9.992125984251969,apart,"
run 0 collide "$case_two" --csv -D fps=7 -D frames=100
says out "box_2,box_1,through,8.992125984251969,11.007874015748031,"
run 0 collide "$case_two" --csv --last 9
(($(wc -l < out.txt) == 1)) || fail "they do not meet before frame 10"
run 0 collide "$case_two" --json
says out '"class":"through"'
run 2 collide "$case_two" --last 99
says err "--last"
finish
