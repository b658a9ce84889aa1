#!/usr/bin/env bash
# The paper's case II, its velocity a tenth: first contact at 5710/635, between frames; at every frame rate the same.
# needs: shapes/box shapes/circle
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
run 0 collide "$case_two" --csv -f 1..8
(($(wc -l < out.txt) == 1)) || fail "they meet while frame 9 is shown"
run 0 collide "$case_two" --csv -f 9
says out "box_2,box_1,through,8.992125984251969,"
run 0 collide "$root/scenes/collision/cradle.toml" --csv -f 11
(($(wc -l < out.txt) == 3)) || fail "two events in frame 11"
run 2 collide "$case_two" --last 9 -f 9
run 2 collide "$case_two" -f 0
run 0 collide "$case_two" --table --json
says out '"numer":-47580'
says out '"t_last":1.1007874015748031'
run 2 collide "$case_two" --last 0
says err "--last"
run 0 collide "$case_two" -f 99  # as render, which draws it
for other in "--csv" "--method boxes" "--response stop" "--last 2" "-f 1"; do
  # shellcheck disable=SC2086
  run 2 collide "$case_two" --table $other
  says err "does not go with --table"
done
run 2 collide "$root/scenes/collision/gas.toml" --response bounce --fixed nosuch
says err " and 101 more"
run 0 collide "$root/scenes/collision/cradle.toml" --json --response bounce
grep -q -e '[:,]-0[,}]' out.txt && fail "a zero with a sign"
finish
