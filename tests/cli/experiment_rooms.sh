#!/usr/bin/env bash
# Experiments on chambers as their users run them: files, progress kept, sweeps, mistakes.
# needs: shapes/box shapes/circle
leaks=looked_for
source "$(dirname "$0")/lib.sh"
sinai=$root/scenes/chamber/sinai.toml
run 0 experiment mean-free-path "$sinai" --count 20000 -o whole
says out "pi A / P"
exists whole/mean_free_path.csv whole/mean_free_path.json
# A run that is stopped goes on to the same bytes; what it kept is of no use to another.
env --default-signal=INT "$flatray" experiment mean-free-path "$sinai" --count 100000000 --resume -j 1 -o half > half.txt 2>&1 &
running=$!
for _ in {1..600}; do
  [[ $(wc -l 2> /dev/null < half/mean-free-path.blocks || echo 0) -ge 3 ]] && break
  sleep 0.1
done
kill -INT $running
wait $running
code=$?
((code == 130)) || fail "stopped with exit code $code, expected 130"
# A block that takes longer than the grace after a signal, as under sanitizers, is left: then none are counted.
grep -q "interrupted.*; blocks done are kept" half.txt || fail "nothing was said of the stop"
exists half/mean-free-path.blocks
run 6 experiment mean-free-path "$sinai" --count 20000 --resume -o half
says err "was kept by another run: its count is 100000000, not 20000"
run 0 verify half
blocks=$(($(wc -l < half/mean-free-path.blocks) - 1))
says out "$blocks record"
# What a power cut leaves of a line is told, and the blocks before it count.
cp -r half torn
printf '7,0.25' >> torn/mean-free-path.blocks
run 1 verify torn
says out 'torn/mean-free-path.blocks: ends within a line'
says out "$blocks record"
# A number of a block that was changed is told.
cp -r half changed
sed -i '2s/,/,1/' changed/mean-free-path.blocks
run 1 verify changed
says out 'is not what an experiment keeps, or was changed'
run 6 experiment mean-free-path "$sinai" --count 100000000 --resume -o changed
says err 'has a line that is not a block, or was changed'
rm -r half
run 0 experiment mean-free-path "$sinai" --count 20000 --resume -o half
cmp whole/mean_free_path.json half/mean_free_path.json || fail "a resumed run differs"
[[ ! -e half/mean-free-path.blocks ]] || fail "the blocks were left behind"
# Quasi-random starts: evenly spread, so with a smaller error; stopped and gone on from like others.
run 0 experiment mean-free-path "$sinai" --count 20000 --bounces 1 --starts quasi --resume -o quasi
error_of() { awk -F, '$1 == "mean_free_path" { print $5 }' "$1/mean_free_path.csv"; }
run 0 experiment mean-free-path "$sinai" --count 20000 --bounces 1 -o random
awk -v a="$(error_of quasi)" -v b="$(error_of random)" 'BEGIN { exit !(3 * a < b) }' || fail "quasi-random starts have no smaller error"
run 2 experiment mean-free-path "$sinai" --count 3000 --starts quasi
says err "say --count 6400 or more"
run 2 experiment mean-free-path "$sinai" --starts sobol
run 2 experiment reflections "$sinai" --starts quasi
says err "is not an option of experiment reflections"
# Sweeps.
run 0 experiment mean-free-path "$sinai" --count 5000 -o sweep --sweep chamber.0.pillars.0.shape.circle.radius=0.1..0.4:0.1
exists sweep/sweep.csv sweep/sweep.json sweep/sweep_mean_free_path.svg
(($(grep -c '^0.[1-4],mean_free_path' sweep/sweep.csv) == 4)) || fail "four values were asked for"
grep -q 'lengths in world units' sweep/sweep_mean_free_path.svg || fail "a plot of a sweep says no units"
run 0 experiment mean-free-path "$sinai" --count 5000 -n 50 -o kept --sweep seed=1,2 --resume
[[ -z $(find kept -mindepth 1 -type d) ]] || fail "a sweep leaves empty folders"
# The value that fails is named; a folder is not standard output.
run 4 experiment mean-free-path "$sinai" --count 5000 --sweep chamber.0.pillars.0.shape.circle.radius=0.1,3
says err '(--sweep chamber.0.pillars.0.shape.circle.radius=3)'
run 2 experiment mean-free-path "$sinai" -o -
says err '--output: error: is a folder, which standard output is not'
absent ./-
run 2 experiment mean-free-path "$sinai" --sweep radius
says err "write KEY=0.1..0.4:0.05"
run 2 experiment mean-free-path "$sinai" --sweep radius=1..0:0.1
run 0 experiment mean-free-path "$sinai" --count 2000 -o seeds --sweep seed=1,2
run 0 experiment mean-free-path "$sinai" --count 2000 -o seed2 --seed 2
grep -qF "$(grep ^mean_free_path seed2/mean_free_path.csv)" seeds/sweep.csv || fail "a sweep has another run"
exists seeds/sweep_mean_free_path.svg
grep -q 'without an interval' seeds/sweep_mean_free_path.svg && fail "means have intervals"
run 0 experiment lyapunov "$sinai" --count 20000 -o spectrum --sweep seed=1,2
grep -q '>found, without an interval<' spectrum/sweep_spectrum_4.svg || fail "what has no interval looks as if it had"
[ -e seeds/sweep_orbits_escaped.svg ] && fail "a plot of nothing"
run 2 experiment mean-free-path "$sinai" --sweep seed=1,2 --seed 3
says err "say one of them"
run 0 experiment mean-free-path "$sinai" --count 1000 -o lists --sweep 'film.size=[10,10],[20,20]'
(($(grep -c 'mean_free_path' lists/sweep.csv) == 2)) || fail "two lists were asked for"
run 0 experiment mean-free-path "$sinai" --count 1000 -o far --sweep seed=1234567890123..1234567890124:1
grep -q ^1234567890124,mean_free_path far/sweep.csv || fail "a seed has lost digits"
# What a scene is warned of is told once, not for each value.
{ cat "$sinai"; printf '[[entity]]\nshape = { circle = { radius = 0.1 } }\nat = [9, 9]\nfill = "none"\n'; } > warned.toml
run 0 experiment mean-free-path warned.toml --count 1000 -o warned --sweep seed=1,2,3 --json
(($(grep -c 'warning: the entity draws nothing' "$work/err.txt") == 1)) || fail "a warning is told $(grep -c warning: "$work/err.txt") times"
(($(grep -o 'the entity draws nothing' "$work/out.txt" | wc -l) == 1)) || fail 'JSON has a warning for each value'
run 2 experiment divergence "$sinai" --apart 0
run 2 experiment escape "$sinai" --map angel
says err "angle"
# Options that would change nothing, all told at once.
run 2 experiment reflections "$sinai" --count 10 --apart 0.1 --map angle
says err "--count: error: is not an option of experiment reflections"
says err "--apart: error"
says err "it takes --bounces, --map, --resume"
scene box.toml 1
run 4 experiment lyapunov box.toml
says err "has no chamber"
# A disc that stands across a periodic wall is met in its copies by all; other pillars there are refused by all, and discs
# whose copies overlap.
lorentz=$root/scenes/chamber/lorentz.toml
for verb in check orbit explain "experiment mean-free-path"; do
  run 4 $verb "$lorentz" -D 'chamber.0.pillars.0.shape={ segment = { from = [0.5, 0.5], to = [1.5, 0.5] } }'
  says err "does not stand in the chamber"
  run 4 $verb "$lorentz" -D 'chamber.0.pillars.0.shape={ bezier = { degree = 2, points = [[0.5, 0.5], [1, 0], [1.5, 0.5]] } }'
  says err "does not stand in the chamber"
  run 4 $verb "$lorentz" -D 'chamber.0.pillars.0.shape={ circle = { radius = 0.6 } }'
  says err "overlap"
  run 4 $verb "$lorentz" -D 'chamber.0.pillars.0.at=[2, 0]'
  says err "does not stand in the chamber"
done
run 0 check "$lorentz" -D 'chamber.0.pillars.0.at=[0.4, 0]'
run 0 check "$lorentz" -D 'chamber.0.pillars.0.at=[0.25, 0]'
# A cell so skewed that its disc reaches over more than the next ones.
run 4 experiment mean-free-path "$lorentz" -D 'chamber.0.shape={ cell = { a = [1, 0], b = [10, 1] } }' \
  -D 'chamber.0.pillars.0={ shape = { circle = { radius = 0.3 } } }' --count 5000
says err "reaches over more cells than those that are looked at"
finish
