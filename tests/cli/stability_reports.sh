#!/usr/bin/env bash
# `flatray stability --catalogue`, `--sweep` and of a scene.
source "$(dirname "$0")/lib.sh"
run 0 stability --catalogue --tracer grid -o out
says out "81 cases, 54 of them asked of tracers"
says out "grid: right, 54 of 54 right"
[[ $(cut -d, -f1 out/catalogue.csv | sort -u | grep -c '[0-9]') == 81 ]] || fail "not every id is in catalogue.csv"
exists out/catalogue_times.csv
says out "least of up to 3"
run 0 stability --catalogue --tracer grid -j 1 -o one
cmp -s out/catalogue.csv one/catalogue.csv || fail "catalogue.csv is not the same every time"
run 1 stability --catalogue --tracer float
says out "float: wrong"
run 0 stability --sweep --tracer grid -o out
says out "right"
exists out/sweep.csv out/sweep_grid.svg
scene box.toml 1 '[[ray]]' 'name = "r"' 'at = [0, 0]' 'direction = [1, 1]' 'bounces = 1'
run 0 stability box.toml -o out
exists out/margins.csv
run 2 stability --sweep --catalogue
says err "leave one of them out"
run 2 stability box.toml --count 5
says err "leave it out"
run 3 stability none.toml
finish
