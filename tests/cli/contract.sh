#!/usr/bin/env bash
# needs: shapes/box formats/obj lamps/point
# Every command of docs/LIMITS.md gives the exit code, leaves the files and keeps to the memory that its row says.
source "$(dirname "$0")/lib.sh"

mkdir -p given/scenes given/golden_images
cd given || exit 1
scene good.toml 2 '[[chamber]]' 'name = "room"' 'shape = { box = { min = [0, 0], max = [16, 12] } }' '[[ray]]' \
  'name = "probe"' 'at = [5, 1]' 'direction = [2, 1]' 'bounces = 3'
scene bad.toml 1 'velocty = [1, 2]'
scene many.toml 1 'repeat = { grid = { count = [20, 20], step = [1, 1] } }'
scene imports_pipe.toml 1 '[[entity]]' 'shape = { import = { file = "pipe.obj" } }'
scene lamp.toml 1 '[light]' 'rays = 1000' '[[lamp]]' 'source = { point = {} }'
mkfifo pipe.obj
ln -s /dev/zero endless.toml
cp good.toml scenes/
echo '{"op":"clip","polygon":[[0,0],[1,0],[1,1]],"origin":[-1,0.5],"direction":[1,0]}' > questions.jsonl
"$flatray" render good.toml -f 1 -o a.png -q
"$flatray" render good.toml -f 2 -o b.png -q
"$flatray" render lamp.toml -o given.film -q
"$flatray" golden update good --why first > ../update.txt || fail "no golden: $(cat ../update.txt)"
cd ..

rows=0 before=$(cd given && find . ! -type d | sort)
while IFS='|' read -r _ command code leaves memory _; do
  rows=$((rows + 1))
  command=${command# \`flatray } command=${command%\` }
  rm -rf here && cp -a given here
  read -ra words <<< "$command"
  [[ -z $sanitizers || $command != *--max-memory* ]] || continue  # sanitizers map more than any limit
  [[ -n $sanitizers || $command == *--max-memory* ]] || words+=(--max-memory "${memory// /}")
  (cd here && timeout 60 "$flatray" "${words[@]}" > ../out.txt 2> ../err.txt)
  got=$?
  ((got == code)) || fail "flatray ${words[*]}: exit code $got, expected $code: $(head -c 300 err.txt)"
  ((got == 0 || got == 1)) || [[ -s err.txt ]] || fail "flatray ${words[*]}: exit code $got without a word"
  now=$(cd here && find . ! -type d | sort) found=
  [[ $now == "$before" ]] || found=$(diff <(echo "$before") <(echo "$now") | sed -n 's,^> \./,,p' | xargs)
  read -r leaves <<< "$leaves"
  [[ -n $sanitizers && $command == *--max-seconds* ]] && continue  # what is done by then depends on their speed
  [[ $found == "$leaves" ]] || fail "flatray ${words[*]}: left '$found', expected '$leaves'"
done < <(grep '^| `flatray ' "$root/docs/LIMITS.md")
((rows > 30)) || fail "only $rows rows"
finish
