#!/usr/bin/env bash
# needs: shapes/box
# Nothing replaces an input, a link or a file of another kind without --force.
source "$(dirname "$0")/lib.sh"
scene box.toml 2
run 0 render box.toml -f 1 -o a.png --quiet
run 0 render box.toml -f 2 -o b.png --quiet
mkdir mine one two
cp a.png one/a.png
cp b.png two/a.png
scene room.toml 1 '[[chamber]]' 'shape = { box = { min = [0, 0], max = [20, 20] } }' '[[ray]]' 'at = [15, 5]' \
  'direction = [1, 1]' 'bounces = 3'
printf 'time,volts\n1,2\n3' > mine/stability.csv
cp mine/stability.csv mine/leaks.csv
cp mine/stability.csv mine/accuracy.csv
ln -s ../box.toml mine/link.png
ln -s ../box.toml mine/coverage.csv
cp box.toml mine/picture.png
mkfifo mine/pipe.png
# Of folders not the time: an experiment claims the one it is to write into, and lets it go.
tree() { find . -not -name out.txt -not -name err.txt -not -name '*.more' \( -type d -printf '%p %i\n' -o -printf '%p %s %i %T@\n' \) | sort; }
before=$(tree)
refused() {  # refused PATH TEXT ARGS...: exit 6, and nothing is touched
  local path=$1 text=$2
  shift 2
  run 6 "$@"
  says err "$path: error: $text"
  [[ $(tree) == "$before" ]] || fail "$*: $(diff <(echo "$before") <(tree))"
}
other="is there already, and nothing of the kind that is written here"
refused mine/stability.csv "$other" stability --families vertex --tracer brute --count 10 -o mine
refused mine/stability.csv "$other" stability --pairs 1 --families grid -o mine
refused mine/leaks.csv "$other" stability --leaks 1 --tracer brute --places origin -o mine
refused mine/coverage.csv "is a link" experiment coverage room.toml -o mine
refused box.toml "is an input" accuracy box.toml --profile box.toml --budget 0.1 --choice coverage -o out
refused b.png "is an input" compare a.png b.png --diff b.png
refused a.png "is an input" compare a.png b.png --diff ./mine/../a.png
refused two/a.png "is an input" compare one two --diff two
for name in d.jpg - .png; do
  run 2 compare a.png b.png --diff "$name"
  says err "'$name' does not end in .png"
  absent "./$name"
done
refused mine/accuracy.csv "$other" accuracy box.toml --budget 0.1 --choice tracer -o mine
refused mine/picture.png "$other" render box.toml -f 1 -o mine/picture.png
refused mine/link.png "is a link" render box.toml -f 1 -o mine/link.png
refused mine/pipe.png "is not a plain file" render box.toml -f 1 -o mine/pipe.png
refused mine/pipe.png "is not a plain file" render box.toml -f 1 -o mine/pipe.png --force
refused mine/link.png "is a link" compare a.png b.png --diff mine/link.png
says err "--force replaces this one"

# --force replaces the file, never what a link leads to.
cp box.toml kept.toml
run 1 compare a.png b.png --diff mine/link.png --force
run 0 render box.toml -f 1 -o mine/picture.png --force --quiet
run 0 stability --families vertex --tracer brute --count 10 -o mine --force
run 0 stability --families vertex --tracer brute --count 10 -o mine
cmp -s box.toml kept.toml || fail "a link was followed"
cmp -s a.png mine/picture.png || fail "not replaced"
[[ $(grep -c '^vertex,brute' mine/stability.csv) == 1 ]] || fail "rows: $(cat mine/stability.csv)"
run 1 compare a.png b.png --diff a.png --force
# What a run of the kind wrote is replaced as ever.
run 0 render box.toml -f 2 -o mine/picture.png --quiet
cmp -s b.png mine/picture.png || fail "a picture was not replaced by a picture"
run 4 accuracy box.toml --budget 0.1 --choice precision -o nothing
says err "precision cannot be measured"
absent nothing
run 2 stability --families vertex --count 1 -o ''
says err "--output: error: is empty"
run 2 verify ''
says err "is empty"
absent stability.csv
finish
