#!/usr/bin/env bash
# `flatray stability --catalogue`, `--sweep` and of a scene.
source "$(dirname "$0")/lib.sh"
run 1 stability --catalogue --tracer grid,float -o out
says out "87 cases: 67 asked of tracers, 9 of contact, 11 of files and pictures by their tests"
# A row has figures, or says what it is about.
figures=$(awk -F, '$1 ~ /^[A-F][0-9]+$/ && $(NF - 9) != "" { print $1 }' out/catalogue.csv | sort -u | wc -l)
[[ $figures == 76 ]] || fail "$figures of 87 cases have figures"
[[ $(grep -cE ',(a picture|a file|the command line),' out/catalogue.csv) == 11 ]] || fail "a row without figures does not say why"
says out "grid: right, 67 of 67 right"
says out "float: wrong"
[[ $(cut -d, -f1 out/catalogue.csv | sort -u | grep -c '[0-9]') == 87 ]] || fail "not every id is in catalogue.csv"
exists out/catalogue_times.csv
says out "least of up to 3"
run 0 stability --catalogue --tracer grid --json -j 1 -o one
grep -qE '"(leaks|apart|t_ulps|one_by_one|ns_a_query|bytes_an_object)":"' out.txt && fail "texts where numbers belong"
grep -qE '"ns_a_query":[0-9.]+,"bytes_an_object":[0-9.]+,' out.txt || fail "no numbers in --json"
grep -v ',float,[0-9]' out/catalogue.csv | cmp -s - one/catalogue.csv || fail "catalogue.csv is not the same every time"
run 0 stability --sweep --tracer grid -o out
says out "right"
exists out/sweep.csv
[[ ! -e out/sweep_grid.svg ]] || fail "a map of what is nowhere wrong"
run 1 stability --sweep --tracer float -o single
exists single/sweep_float.svg
scene box.toml 1 '[[ray]]' 'name = "r"' 'at = [0, 0]' 'direction = [1, 1]' 'bounces = 1'
run 0 stability box.toml -o out
exists out/margins.csv
run 2 stability --sweep --catalogue
says err "leave one of them out"
run 2 stability box.toml --count 5
says err "leave it out"
run 2 stability box.toml --tracer grid
says err "does not go with a scene"
run 2 stability --catalogue --seed 7
says err "does not go with --catalogue"
for of_scene in "-D seed=1" "--max-entities 5" "--max-bytes 9999"; do
  # shellcheck disable=SC2086  # two words
  run 2 stability --families vertex --count 1 --tracer brute $of_scene
  says err "is about a scene, and none is given"
done
FLATRAY_MAX_ENTITIES=5 run 0 stability --families vertex --count 1 --tracer brute  # said for all commands
run 3 stability none.toml
scene fast.toml 1 '[[ray]]' 'name = "r"' 'at = [0, 0]' 'direction = [1, 1]' 'speed = 5'
"$flatray" stability fast.toml > out.txt 2> err.txt && fail "a ray with a speed among walls that stand still"
says err "has a speed"
finish
