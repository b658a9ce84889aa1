#!/usr/bin/env bash
# Whatever a scene's name holds, pictures stay beneath the folder; no name is ever a format string.
source "$(dirname "$0")/lib.sh"
mkdir in
scene plain.toml 1
while IFS= read -r name; do
  cp plain.toml "in/$name.toml"
done << 'NAMES'
%s%n%x
CON
..
.hidden
-rf
{scene}
####
a b;rm
$(touch pwned)
ümlaut
NAMES
for file in in/* in/.[!.]*; do
  run 0 render "$file" --quiet
  run 0 render "$file" -f 1 -o 'sub/{scene}/f_#.png' --quiet
done
absent pwned
names=$(find out sub -type f -name '*.png' | sort)
(($(wc -l <<< "$names") >= 14)) || fail "pictures are missing: $names"
grep -vxE '(out|sub)/[A-Za-z0-9_][A-Za-z0-9_.-]*(/f_1)?\.png' <<< "$names" && fail "a name left plain characters"
[[ -z $(find . -newer plain.toml -name '*.png' -not -path './out/*' -not -path './sub/*') ]] || fail "outside"
exists out/_CON.png out/_s_n_x.png

# A long name is refused with a remedy, and rendered under another.
long=$(printf 'x%.0s' {1..200})
cp plain.toml "in/$long.toml"
run 2 render "in/$long.toml"
says err "say -o FILE"
run 0 render "in/$long.toml" -o short.png
run 2 render plain.toml -o "$(printf 'y%.0s' {1..300}).png"
says err "at most 120"

# The user's own -o goes where it says: through a folder that is a link, but never through a file that is one.
mkdir elsewhere
ln -s elsewhere link
run 0 render plain.toml -o link/x.png
exists elsewhere/x.png
echo precious > victim
ln -s victim pic.png
run 6 render plain.toml -o pic.png
says err "pic.png: error: is a link"
run 0 render plain.toml -o pic.png --force
[[ $(cat victim) == precious ]] || fail "a picture was written through a link"
run 0 render plain.toml -o '%s%n_%04d.png'
exists '%s%n_0001.png'
run 2 render plain.toml -o ''
run 2 render plain.toml -o out/
says err "say out/frame_####.png"
finish
