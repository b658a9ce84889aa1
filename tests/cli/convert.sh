#!/usr/bin/env bash
# flatray convert: what is written draws the same pictures as what was read, and is written again as it is.
# needs: formats/hqz formats/list formats/obj formats/toml lamps/point shapes/import
source "$(dirname "$0")/lib.sh"
printf '{ SPIDER MAN, 200, 200 }\nBAT, MAN, -1.5, 2e2\n' > objects.list

count=0
export FLATRAY_ROOT=/  # outlines stay where they are: elsewhere
for folder in "$root"/scenes "$root"/scenes/*/ .; do
  scenes=() written=() to=${folder#"$root"}
  for scene in "$folder"/*.{toml,obj,json,list}; do
    [[ -e $scene ]] || continue
    name=${scene##*/}
    scenes+=("$scene") written+=("first/$to/${name%.*}.toml")
    run 0 convert "$scene" "${written[-1]}" --quiet
    silent out
    run 0 convert "${written[-1]}" "again/${written[-1]#first/}" --quiet
  done
  count=$((count + ${#scenes[@]}))
  [[ -n $sanitizers && $folder != */tutorial/ ]] && continue # ten times as slow
  # All scenes of a folder by one process: their first and third frames.
  draw=(--size 96x60 -f 1,3 -D light.rays=1000 --quiet)
  run 0 render "${scenes[@]}" "${draw[@]}" -o "before/$to/{scene}_#.png"
  run 0 render "${written[@]}" "${draw[@]}" -o "after/$to/{scene}_#.png"
  same "before/$to" "after/$to" "$folder"
done
diff -rq first again || fail "converted again it is another file"
((count > 80)) || fail "only $count scenes"

# What is drawn covers what stands before it, of whatever kind.
cat > turns.toml << 'TOML'
flatray = 1
film = { size = [60, 60], world = [[0, 0], [6, 6]] }
[[entity]]
shape = { box = { min = [2, 1], max = [3, 5.7] } }
fill = "#0000ff"
[[ray]]
at = [1, 3]
direction = [1, 0]
stroke = { width = 1, colour = "#ff0000" }
[[entity]]
shape = { box = { min = [2.5, 1.5], max = [5, 5] } }
fill = "#00ff00"
TOML
cat > contact.toml << 'TOML'
flatray = 1
frames = 41
film = { size = [60, 60], world = [[0, 0], [6, 6]] }
[[entity]]
shape = { box = { min = [0, 0], max = [1, 1] } }
velocity = [1, 0]
fill = "#0000ff"
[[entity]]
shape = { box = { min = [2.5, 0], max = [4, 4] } }
fill = "#00ff00"
layer = 1
[collisions]
response = "stop"
points = "#ff0000"
TOML
for scene in turns contact; do
  frame=$([[ $scene == turns ]] && echo 1 || echo 41)
  run 0 convert $scene.toml ${scene}_again.toml
  run 0 render $scene.toml -f "$frame" -o $scene.png -q
  run 0 render ${scene}_again.toml -f "$frame" -o ${scene}_again.png -q
  run 0 compare $scene.png ${scene}_again.png
done
# So do options: what they replace keeps its place, what is new comes last.
replaced=(-D 'ray.0={ at=[1, 3], direction=[1, 0], stroke={ width=1, colour="#ff0000" } }')
run 0 render turns.toml "${replaced[@]}" -o replaced.png -q
run 0 compare turns.png replaced.png
run 0 convert turns.toml replaced.toml "${replaced[@]}"
cmp -s turns_again.toml replaced.toml || fail "an entry that an option replaces is written elsewhere"
new=(-D 'ray=[]' -D 'chamber=[{ shape={ box={ min=[0, 0], max=[6, 6] } }, fill="#0000ff" }]')
run 0 render turns.toml "${new[@]}" -o new.png -q
run 0 convert turns.toml with_chamber.toml "${new[@]}"
run 0 render with_chamber.toml -o new_again.png -q
run 0 compare new.png new_again.png
run 1 compare turns.png new.png
# Several new ones come in their order, and copies of an entity together.
new=(-D 'ray=[]' -D 'entity.0.fill="#0000ff"' -D 'entity=[{ shape={ box={ min=[0, 0], max=[3, 3] } }, fill="#0000ff", repeat={ grid={ count=[2, 1], step=[1, 1] } } }, { shape={ box={ min=[1, 0], max=[2, 4] } }, fill="#00ff00", repeat={ grid={ count=[2, 1], step=[1, 1] } } }]' -D 'ray=[{ at=[0, 3], direction=[1, 0], stroke={ width=1, colour="#ff0000" } }]' -D 'chamber=[{ shape={ box={ min=[0, 0], max=[6, 6] } }, fill="#00000080" }]')
run 0 render turns.toml "${new[@]}" -o several.png -q
run 0 convert turns.toml several.toml "${new[@]}"
run 0 render several.toml -o several_again.png -q
run 0 compare several.png several_again.png
[[ $(grep '^\[' several.toml | tr -d '\n') == *entity*entity*ray*chamber* ]] || fail "$(grep '^\[' several.toml | tr '\n' ' ')"

# What the folder of the file means is kept, also on standard output, which is written from here.
scene plain.toml 1
mkdir -p far/away
cp plain.toml far/away/plain.toml
cat > far/away/outline.toml << 'TOML'
flatray = 1
[[entity]]
shape = { import = { file = "outline.obj" } }
[[lamp]]
source = { point = {} }
at = [2, 2]
spectrum = "green.csv"
TOML
printf '500 0\n520 1\n540 0\n' > far/away/green.csv
printf 'v 0 0\nv 1 0\nv 0 1\nf 1 2 3\nvn 0 0 1\n' > far/away/outline.obj
run 0 convert far/away/outline.toml -
says out 'file = "far/away/outline.obj"'
says out 'spectrum = "far/away/green.csv"'
says err 'vn ignored'  # what the import cannot honour
run 0 convert far/away/outline.toml near.toml
run 0 convert far/away/outline.obj -
says out 'file = "far/away/outline.obj"'
run 0 render near.toml -D light.rays=1000 -o near.png
run 0 render far/away/outline.toml -D light.rays=1000 -o far.png
cmp -s near.png far.png || fail "an outline from another folder draws another picture"

# Standard input; -D; comments go.
"$flatray" convert - - < plain.toml > piped.toml || fail "no TOML from standard input"
run 0 check piped.toml
run 0 convert plain.toml small.toml -D film.size=[32,24]
grep -q 'size = \[32, 24\]' small.toml || fail "-D is not in what was written"
printf 'flatray = 1 # one\n# two\n' > comment.toml
run 0 convert comment.toml -
[[ $(< out.txt) == "flatray = 1" ]] || fail "a comment is left: $(< out.txt)"

# What is refused leaves the file that is there.
run 6 convert plain.toml near.toml
says err '--force writes over it'
scene bad.toml 1 'velocty = [1, 2]'
cp near.toml kept.toml
run 4 convert bad.toml near.toml --force
says err "did you mean 'velocity'?"
cmp -s near.toml kept.toml || fail "a refused scene was written"
run 2 convert plain.toml out.obj
says err 'scenes are written as TOML'
"$flatray" convert - - < far/away/outline.obj > /dev/null 2> err.txt
[[ $? == 2 ]] || fail "an outline without a name is converted"
says err 'no name to refer to'
# Nor what TOML cannot hold.
{ printf 'A, 1.'; printf '1%.0s' {1..300}; echo ', 2'; } > digits.list
run 0 convert digits.list digits.toml
run 0 check digits.toml
latin() { head -c "$1" /dev/zero | tr '\0' '\351' && echo ', 3, 4'; }
latin 2048 > latin.list
run 0 convert latin.list latin.toml
run 0 check latin.toml
{ echo 'A, 1, 2' && latin 2049; } > long.list
run 0 check long.list
run 4 convert long.list long.toml
says err 'long.list:2:1: error: this takes 4098 bytes as UTF-8'
printf 'v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n' > $'\xe9.obj'
run 4 convert $'\xe9.obj' latin.toml --force
says err 'is not UTF-8, as TOML is'
run 0 check latin.toml
# Each byte becomes six: 2900 names are 70 MB.
name=$(head -c 4000 /dev/zero | tr '\0' '\1')
for i in {1..2900}; do echo "$i$name, 1, 2"; done > large.list
run 4 convert large.list large.toml
says err 'large.list: error: as TOML, the scene is '
absent large.toml
printf 'flatray = 1\ninclude = ["large.list"]\n' > holds.toml
run 0 check holds.toml
# What check refuses is not converted.
run 4 convert "$root/scenes/chamber/lorentz.toml" pillar.toml -D chamber.0.pillars.0.shape.circle.radius=90
says err "overlap"
absent pillar.toml
run 3 convert absent.toml new.toml
run 6 convert plain.toml plain.toml/x.toml
finish
