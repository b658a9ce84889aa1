#!/usr/bin/env bash
# faults.sh FLATRAY ROOT LIBRARY VERB COUNT [SEED]: one call of VERB (or of a verb that loads the module named so) fails -
# memory, a write, a flush, a name, a folder, a thread - for COUNT call stacks drawn by SEED, or for all (COUNT 0).
# Each time: no signal, exit 0 only with all that an undisturbed run leaves, and 70 where it is memory; then the same command, undisturbed, leaves
# just that: no record is lost.
source "$(dirname "$0")/../cli/lib.sh"
library=$3 verb=$4 count=$5 seed=${6:-1}

cat > scene.toml <<'END'
flatray = 1
frames = 3
film = { size = [32, 24], world = [[0, 0], [16, 12]] }
[[chamber]]
name = "room"
shape = { polygon = { points = [[0, 0], [16, 1], [15, 12], [1, 11]] } }  # errors at the first bounce: always a plot
[[ray]]
name = "probe"
at = [1, 1]
direction = [2, 1]
bounces = 3
[[entity]]
name = "box"
shape = { box = { min = [0, 0], max = [4, 3] } }
at = [1, 2]
velocity = [12, 3.5]
fill = "#c0392b"
END

# What a run leaves, without what depends on seconds.
case $verb in
  render)
    command=(render scene.toml -o 'out/f_####.png' -j 2 --resume -q)
    left() { sha256sum out/*.png && sort out/manifest.jsonl; } ;;
  experiment)
    command=(experiment mean-free-path scene.toml --count 64 -n 3 -j 2 --resume -q -o out)
    left() { (cd out && sha256sum ./*); } ;;
  stability)
    command=(stability --families vertex --count 1 --tracer grid -j 2 -o out)
    left() { cut -d, -f1-11,13-19,21-29 out/stability.csv; } ;;
  accuracy)
    command=(accuracy scene.toml --choice precision,depth --budget 0.2 -j 2 -q -o out)
    left() { ls out && [[ -z $(find out -empty) ]] && tail -qc 1 out/* | od -c; } ;;
  certified)
    command=(orbit scene.toml -n 4 --precision certified)
    left() { cat out.txt; } ;;
  embree)
    command=(orbit scene.toml -n 4 --tracer embree)
    left() { cat out.txt; } ;;
  gl)
    command=(render scene.toml -f 2 -o out/p.png --backend gl -j 2)
    left() { sha256sum out/p.png; } ;;
  golden)
    command=(golden update scene --why new)
    left() { sha256sum golden_images/*/*.png golden_images/manifest.json; } ;;
esac
start() {
  rm -rf out golden_images scenes
  [[ $verb != golden ]] || { mkdir -p scenes golden_images && cp scene.toml scenes/ &&
    echo '{"schema": "flatray.goldens/1", "goldens": []}' > golden_images/manifest.json; }
}
undisturbed() { "$flatray" "${command[@]}" > out.txt 2> err.txt; }

start
undisturbed || { cat err.txt; exit 1; }
left > whole.txt || exit 1
start
FAULT_LIST=$work/stacks.txt LD_PRELOAD=$library undisturbed || exit 1
all=$(sort -u stacks.txt | wc -l)
((count > 0)) || count=$all
awk -v seed="$seed" 'BEGIN { srand(seed) } !seen[$0]++ { print rand(), $0 }' stacks.txt | sort | head -n "$count" |
  cut -d' ' -f2- > drawn.txt

declare -A codes
met=0 crashed=0
while read -r kind stack; do
  start
  rm -f done
  FAULT_AT=$stack FAULT_DONE=$work/done LD_PRELOAD=$library timeout 60 "$flatray" "${command[@]}" > out.txt 2> err.txt
  code=$?
  [[ -e done ]] || continue
  met=$((met + 1))
  codes[$code]=$((${codes[$code]:-0} + 1))
  grep -q 'GL library crashed' err.txt && crashed=$((crashed + 1))
  case $code in
    0) left 2> /dev/null | cmp -s - whole.txt || fail "$kind $stack: exit 0 with less" ;;
    70) [[ -s err.txt ]] || fail "$kind $stack: exit $code without a word" ;;
    [3-6])  # memory that ends says nothing of files, and nothing of what is installed
      [[ -s err.txt ]] || fail "$kind $stack: exit $code without a word"
      [[ $kind != alloc ]] || grep -q 'GL library crashed' err.txt || fail "$kind $stack: exit $code: $(head -c 300 err.txt)" ;;
    127) grep -q 'cannot allocate memory for thread-local data' err.txt || fail "$kind $stack: exit $code" ;;  # libc
    *) fail "$kind $stack: exit $code: $(head -c 300 err.txt)" ;;
  esac
  undisturbed || fail "$kind $stack: then exit $?: $(head -c 300 err.txt)"
  left 2>&1 | diff - whole.txt > differs.txt ||
    fail "$kind $stack: what is left then is not what an undisturbed run leaves: $(cat differs.txt out.txt)"
done < drawn.txt
printf 'faults: %s: %s of %s call stacks (%s), %s met, exit codes:' "$verb" "$(wc -l < drawn.txt)" "$all" \
  "$(cut -d' ' -f1 stacks.txt | sort | uniq -c | awk '{ printf "%s%s %s", sep, $1, $2; sep = ", " }')" "$met"
for code in "${!codes[@]}"; do printf ' %s: %s' "$code" "${codes[$code]}"; done
printf '; GL library crashed, and said so: %s; failures: %s\n' "$crashed" "$failures"
((met > 0 || failures > 0)) || fail "no call failed"
finish
