#!/usr/bin/env bash
# The time that --json tells is that of the run: above 0 and not above what a clock beside it says, whatever the verb.
# needs: shapes/box shapes/circle shapes/polygon
source "$(dirname "$0")/lib.sh"
scene box.toml 2
hall=$root/scenes/chamber/hall.toml case_one=$root/scenes/paper/case_one.toml
verbs=("render box.toml --dry-run" "render box.toml -o f_####.png -q" "check box.toml" "explain box.toml" "list"
  "compare f_0001.png f_0001.png" "hit $case_one --ray 1,2,22,10" "hit $case_one --from ray --against polygon"
  "orbit $hall -n 9" "collide $root/scenes/paper/case_two.toml" "collide $root/scenes/paper/case_two.toml --table"
  "stability --families vertex --count 10"
  "experiment mean-free-path $root/scenes/chamber/sinai.toml --count 10 -o study")
for words in "${verbs[@]}"; do
  before=$(date +%s%N)
  # shellcheck disable=SC2086
  run 0 $words --json
  after=$(date +%s%N)
  told=$(sed -n 's/.*"timing":{"seconds":\([0-9.e-]*\)}.*/\1/p' out.txt)
  awk -v told="${told:-0}" -v most="$((after - before))" 'BEGIN { exit !(told > 0 && told * 1e9 <= most) }' ||
    fail "$words: '$told' seconds, a clock says $((after - before)) ns"
done
printf 'flatray = 1\nfps = 0\n' > wrong.toml
run 4 check --json wrong.toml
grep -q '"timing":{"seconds":0[,}]' out.txt && fail 'a failure takes no time'
finish
