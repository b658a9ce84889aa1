#!/usr/bin/env bash
# Names of a scene reach terminals and tables without what steers them; JSON has them as they are.
source "$(dirname "$0")/lib.sh"
name='\u001b[2J\nforged: equal\t=1\u202e\u009b'
cat > scene.toml << TOML
flatray = 1
[[chamber]]
name = "$name"
shape = { box = { min = [0, 0], max = [10, 10] } }
[[entity]]
name = "=cmd|' /C calc'!A0"
shape = { box = { min = [1, 1], max = [2, 2] } }
velocity = [24, 0]
[[entity]]
name = "@$name"
shape = { box = { min = [5, 1], max = [6, 2] } }
[[ray]]
name = "-$name"
at = [5, 5]
direction = [1, 0.5]
bounces = 3
[markov."$name"]
A = { A = 1 }
TOML
# Nothing steers, and nothing forges a line.
clean() {
  LC_ALL=C grep -nP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xa8-\xae]' out.txt err.txt && fail "$*: steers"
  grep -q '^forged' out.txt err.txt && fail "$*: forges a line"
}
for words in "check scene.toml" "hit scene.toml" "hit scene.toml --csv" "hit scene.toml --op any" "orbit scene.toml" "orbit scene.toml --csv" \
  "orbit scene.toml --ray nosuch" "collide scene.toml" "collide scene.toml --csv --last 4" "explain scene.toml" "render scene.toml --dry-run" \
  "experiment markov scene.toml --count 10" "convert scene.toml -"; do
  # shellcheck disable=SC2086
  "$flatray" $words > out.txt 2> err.txt
  clean "$words"
done
run 0 collide scene.toml --last 8 --csv
says out "'=cmd|' /C calc'!A0,'@\\u001b[2J\\nforged: equal\\t=1\\u202e\\u009b,"
run 0 orbit scene.toml --csv
says out "'-\\u001b[2J"
says out ',-1,'  # numbers stay
run 0 orbit scene.toml --json
python3 -c 'import json; assert json.load(open("out.txt"))["results"][0]["ray"].startswith("-\x1b[2J\nforged")' 2> /dev/null ||
  ! command -v python3 > /dev/null || fail "JSON has another name"
mv scene.toml $'esc\e[2J.toml'
run 0 check $'esc\e[2J.toml'
clean "the scene's file name"
run 3 check $'absent\e[2J.toml'
clean "an absent file"

# Bytes that are not UTF-8 make no JSON that is none, and no records that name other files.
scene $'stray\xff.toml' 1
run 0 check $'stray\xff.toml' --json
says out '"operands":["stray\\xff.toml"]'
run 0 render $'stray\xff.toml' -f 1 --size 8x8 -o $'stray\xff.png' --json
says out '"file":"stray\\xff.png"'
run 2 render $'stray\xff.toml' --size 8x8 -o $'stray\xff_####.png'
says err '--output: error: names files by bytes that are not UTF-8'
# What is to be pasted is quoted for the shell.
scene "it's; a \$scene.toml" 1
run 2 "it's; a \$scene.toml"
says err "flatray render 'it'\\''s; a \$scene.toml'"

# What has no name is called by its kind and number.
cat > unnamed.toml << 'TOML'
flatray = 1
[[chamber]]
shape = { box = { min = [0, 0], max = [10, 10] } }
[[chamber.pillars]]
shape = { circle = { radius = 1 } }
at = [8, 5]
[[entity]]
shape = { box = { min = [1, 1], max = [2, 2] } }
velocity = [24, 0]
[[entity]]
shape = { box = { min = [5, 1], max = [6, 2] } }
[[ray]]
at = [5, 5]
direction = [1, 0]
bounces = 2
TOML
run 0 orbit unnamed.toml --csv
says out 'ray 1,1,2,2,7,5,chamber 1/pillar 1,circle,'
says out 'ray 1,2,7,9,0,5,chamber 1,3,'
run 0 collide unnamed.toml --last 8 --csv
says out 'entity 1,entity 2,'
run 0 hit unnamed.toml --ray 0,1.5,1,0
says out 'against entity 1'
finish
